//! Files as people have them, made for this test.

use super::reader::car;
use super::*;
use approx::abs_diff_eq;

const SAMPLE: &str = include_str!("../../../../examples/tyres/formula_student.tir");

/// A minimal file, with `more` at its end.
fn small(more: &str) -> String {
    let units = "[UNITS]\nLENGTH = 'meter'\nFORCE = 'newton'\nANGLE = 'radians'\nMASS = 'kg'\nTIME = 'second'\n";
    let model = "[MODEL]\nPROPERTY_FILE_FORMAT = 'PAC2002'\nTYRESIDE = 'LEFT'\nLONGVL = 16.7\n";
    let tyre = "[DIMENSION]\nUNLOADED_RADIUS = 0.24\n[VERTICAL]\nFNOMIN = 800\n";
    format!("{units}{model}{tyre}[LATERAL_COEFFICIENTS]\nPCY1=1.4\nPDY1=1.5\nPKY1=-30\nPKY2=1.6\n{more}")
}

fn get(text: &str, name: &str) -> f64 {
    parse("x.tir", text).unwrap().set.get(name).unwrap()
}

fn refusal(text: &str) -> String {
    parse("x.tir", text).unwrap_err().to_string()
}

/// The file in `examples` is the built-in tyre, number by number.
#[test]
fn sample_file_is_the_built_in_tyre() {
    let file = parse("formula_student.tir", SAMPLE).unwrap();
    assert_eq!(file.set.name(), "formula_student");
    let mut tyres = 0;
    for variable in car().table.iter().filter(|variable| variable.path.to_string().starts_with("tyre.")) {
        let name = variable.path.to_string();
        let value = file.set.get(&name).unwrap();
        assert!(abs_diff_eq!(value, variable.start, epsilon = 1e-15 * variable.start.abs()), "{name}: {value}");
        tyres += 1;
    }
    assert!(tyres > 100, "{tyres}");
    for name in ["front.tyre_stiffness", "rear.tyre_stiffness", "front.tyre_damping", "rear.tyre_damping"] {
        assert_eq!(file.set.get(name), Some(car().table.at(car().find(name).unwrap()).start), "{name}");
    }
    assert_eq!(file.notes, ["PROPERTY_FILE_FORMAT = PAC2002: read as Magic Formula 5.2"]);
}

#[test]
fn missing_entries_are_neutral_and_not_built_in() {
    let text = small("");
    for (name, value) in [("tyre.pdy1", 1.5), ("tyre.pey1", 0.0), ("tyre.lmuy", 1.0), ("tyre.lhy", 1.0)] {
        assert_eq!(get(&text, name), value, "{name}");
    }
    let notes = parse("x.tir", &text).unwrap().notes;
    let ones = notes.iter().find(|note| note.starts_with("not in the file, set to 1: ")).unwrap();
    assert!(ones.contains(": LFZO, LCX, ") && !ones.contains("LKYC"), "{ones}");
    assert_eq!(notes.iter().filter(|note| note.starts_with("not in the file, set to ")).count(), 2, "{notes:?}");
}

#[test]
fn comments_case_line_ends_and_byte_order_mark_do_not_matter() {
    let text = small("[SCALING_COEFFICIENTS]\n$ a comment\n! another = 3\nLMUY = 6.5D-1 $grip!\n");
    let expected = parse("x.tir", &text).unwrap().set;
    assert_eq!(expected.get("tyre.lmuy"), Some(0.65));
    assert_eq!(parse("x.tir", &text.to_lowercase()).unwrap().set, expected);
    let windows = format!("\u{feff}{}", text.replace('\n', "\r\n"));
    assert_eq!(parse("x.tir", &windows).unwrap().set, expected);
    let quoted = text.replace("'LEFT'", "'LEFT' ! $ not right");
    assert_eq!(parse("x.tir", &quoted).unwrap().set, expected);
}

#[test]
fn comments_in_other_encodings_do_not_matter() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("umlaut.tir");
    let mut bytes = b"! gemessen f\xfcr Stra\xdfe\n".to_vec();
    bytes.extend(small("").bytes());
    fs::write(&path, bytes).unwrap();
    assert_eq!(read(&path).unwrap().set.get("tyre.pdy1"), Some(1.5));
    assert!(read(&folder.path().join("absent.tir")).unwrap_err().to_string().contains("absent.tir: "));
}

#[test]
fn units_are_converted() {
    let text = small("").replace("'meter'", "'mm'").replace("'newton'", "'kilo_newton'").replace("= 0.24", "= 240");
    let text = text.replace("LONGVL = 16.7", "LONGVL = 16700").replace("FNOMIN = 800", "FNOMIN = 0.8");
    let text = text.replace("[VERTICAL]", "[VERTICAL]\nVERTICAL_STIFFNESS = 0.1\nVERTICAL_DAMPING = 1E-4");
    let expected = [
        ("tyre.unloaded_radius", 0.24),
        ("tyre.longvl", 16.7),
        ("tyre.fnomin", 800.0),
        ("front.tyre_stiffness", 1e5),
        ("rear.tyre_damping", 100.0),
        ("tyre.pky1", -30.0),
    ];
    for (name, value) in expected {
        assert!(abs_diff_eq!(get(&text, name) / value, 1.0, epsilon = 1e-15), "{name}: {}", get(&text, name));
    }
}

#[test]
fn the_side_is_heeded() {
    assert_eq!(get(&small(""), "tyre.side"), 1.0);
    assert_eq!(get(&small("").replace("'LEFT'", "'Right'"), "tyre.side"), 2.0);
}

fn read_small(more: &str) -> TyreFile {
    parse("x.tir", &small(more)).unwrap()
}

fn told(groups: &[Group]) -> Vec<String> {
    groups.iter().map(ToString::to_string).collect()
}

/// Sections and keys as fitting tools export them: most of a file is for other models.
#[test]
fn what_is_not_used_is_told_once_by_what_it_is_for() {
    let more = "PTY1 = 2.1\nPTY1 = 2.2\n[SHAPE]\n{radial width}\n1.0 0.0\n[LONG_SLIP_RANGE]\nKPUMIN = -1.5\n\
                [STRUCTURAL]\nYAW_STIFFNESS = 5000\nDAMP_YAW = many\n[TURNSLIP_COEFFICIENTS]\nPECP2 = 0\n\
                [TIRE_CONDITIONS]\nIP = 83000\n[INERTIA]\nMASS = kg\n[X]\nQFZ1 = 1\nPDYl = 3\n";
    let file = read_small(more);
    let expected = [
        "relaxation and structure: PTY1, YAW_STIFFNESS, DAMP_YAW",
        "ranges: KPUMIN",
        "turn slip: PECP2",
        "inflation pressure: IP",
        "size and mass: MASS",
        "deflection and rolling radius: QFZ1",
        "unknown: PDYL",
    ];
    assert_eq!(told(&file.unused), expected);
    assert!(file.ignored.is_empty(), "{:?}", file.ignored);
}

/// A file of version 5.2 has terms of version 6 without effect, which have their neutral values then.
#[test]
fn what_would_change_forces_but_is_not_modelled_is_told_apart() {
    let neutral = "PKY4 = 2\nPEY5 = 0\nLKZC = 1\nLKYC = 1.0\nQSY7 = 1\nPPX1 = 0\nPDXP1 = 0\n";
    assert!(read_small(neutral).ignored.is_empty());
    let file = read_small("PKY4 = 1.8\nLKZC = 0.5\nQSX4 = 0.1\nPDXP1 = 0.4\nPPY1 = 0.7\nPKYP1 = 1\n");
    assert_eq!(told(&file.ignored), ["Magic Formula 6: PKY4, LKZC, QSX4, PPY1", "turn slip: PDXP1, PKYP1"]);
    let at_nominal = read_small("PPY1 = 0.7\nIP = 83000\nIP_NOM = 8.3d4\n");
    assert!(at_nominal.ignored.is_empty());
    assert_eq!(told(&read_small("PPY1 = 0.7\nIP = 8E4\nIP_NOM = 83000").ignored), ["Magic Formula 6: PPY1"]);
}

#[test]
fn keys_without_value_count_as_absent() {
    let file = read_small("PEY1 =\nPEY2 = $ 0.1\nROAD_INCREMENT =\t! m\nPEY3 = ''\nLMUY=\n");
    let without = "without value, as if absent: PEY1, PEY2, ROAD_INCREMENT, PEY3, LMUY";
    assert!(file.notes.contains(&without.into()), "{:?}", file.notes);
    assert_eq!([file.set.get("tyre.pey1"), file.set.get("tyre.lmuy")], [Some(0.0), Some(1.0)]);
    assert_eq!(refusal(&small("").replace("PDY1=1.5", "PDY1 = $ 1.5")), "x.tir:17: PDY1 = $ 1.5: has no value");
}

#[test]
fn the_last_of_several_values_counts_and_this_is_told() {
    let file = read_small("PCY1 = 1.3\nPDY1 = 15d-1\n[MORE]\nPDY1 =\n[UNITS]\nFORCE = 'Newton'");
    assert_eq!([file.set.get("tyre.pcy1"), file.set.get("tyre.pdy1")], [Some(1.3), Some(1.5)]);
    let first = |key: &str| file.notes.iter().find(|note| note.starts_with(key)).unwrap().as_str();
    assert_eq!(first("PCY1"), "PCY1: line 20 is used (1.3) and line 16 is not (1.4): the last one counts");
    assert_eq!(first("PDY1"), "PDY1: given more than once with the same value, in lines 17, 21");
    assert_eq!(first("FORCE"), "FORCE: given more than once with the same value, in lines 3, 25");
}

/// Numbers as Fortran prints them, and as programs print them where the comma is for decimals.
#[test]
fn numbers_may_have_other_exponents_and_commas() {
    for (text, value) in [
        ("1.5D-1", 0.15),
        ("+.15d0", 0.15),
        ("1.5-001", 0.15),
        ("150.E-3 // grip", 0.15),
        ("0.15\t$ grip", 0.15),
        ("1.5000e-001!", 0.15),
    ] {
        assert_eq!(get(&small(&format!("LMUY = {text}")), "tyre.lmuy"), value, "{text}");
    }
    let comma = small("PEY1 = -1,5D-1").replace('.', ",");
    assert_eq!([get(&comma, "tyre.pey1"), get(&comma, "tyre.unloaded_radius")], [-0.15, 0.24]);
    let notes = parse("x.tir", &comma).unwrap().notes;
    assert!(notes.contains(&"line 10: the comma is for decimals".into()), "{notes:?}");
    let both = "x.tir:20: PEY1 = 1,234: has a decimal comma, and line 10 has a decimal point";
    assert_eq!(refusal(&small("PEY1 = 1,234")), both);
}

#[test]
fn sections_may_be_in_any_order_and_absent() {
    let text = small("");
    let (units, rest) = text.split_once("[MODEL]").unwrap();
    let turned = format!("[MODEL]{rest}{units}");
    let expected = parse("x.tir", &text).unwrap().set;
    assert_eq!(parse("x.tir", &turned).unwrap().set, expected);
    let bare: String = text.lines().filter(|line| !line.starts_with('[')).map(|line| format!("{line}\n")).collect();
    assert_eq!(parse("x.tir", &bare).unwrap().set, expected);
    assert_eq!(parse("x.tir", &text.replace('\n', "\r")).unwrap().set, expected);
    assert_eq!(parse("x.tir", &text.replace('=', "\t=\t").replace("[MODEL]", "[MODEL $ x")).unwrap().set, expected);
}

#[test]
fn wrong_lines_are_rejected_with_number_and_text() {
    for (more, answer) in [
        ("PEY1 = 0.1.2", "x.tir:20: PEY1 = 0.1.2: must be a finite number"),
        ("PEY1 = 1.000,5", "x.tir:20: PEY1 = 1.000,5: must be a finite number"),
        ("PEY1 = inf", "x.tir:20: PEY1 = inf: must be a finite number"),
        ("PEY1 = nan $", "x.tir:20: PEY1 = nan $: must be a finite number"),
        ("PEY1 = 0.1 0.2", "x.tir:20: PEY1 = 0.1 0.2: must be a finite number"),
        ("PEY1 0.1", "x.tir:20: PEY1 0.1: must be KEY = value"),
        ("PCY2 = 0.8", "x.tir:20: PCY2 = 0.8: is for the camber thrust of a motorcycle tyre, which is not modelled"),
        ("LMUY = 0", "x.tir:20: LMUY = 0: tyre.lmuy = 0: must be > 0 and finite"),
    ] {
        assert_eq!(refusal(&small(more)), answer);
    }
    assert_eq!(refusal("A = 1"), "x.tir: neither FITTYP nor PROPERTY_FILE_FORMAT gives the version");
}

#[test]
fn other_versions_units_and_axes_are_rejected() {
    let change = |from: &str, to: &str| {
        let text = small("");
        assert!(text.contains(from), "{from}");
        refusal(&text.replace(from, to))
    };
    let version = change("PROPERTY_FILE_FORMAT = 'PAC2002'", "FITTYP = 51");
    assert!(version.starts_with("x.tir:8: FITTYP = 51: must be 5, 6, 21 or 52 for Magic Formula 5.2, "), "{version}");
    let format = change("'PAC2002'", "'FTIRE'");
    assert!(format.starts_with("x.tir:8: PROPERTY_FILE_FORMAT = 'FTIRE': must be one of PAC2002, "), "{format}");
    for without in ["", "PROPERTY_FILE_FORMAT = 'USER'\n"] {
        assert_eq!(
            change("PROPERTY_FILE_FORMAT = 'PAC2002'\n", without),
            "x.tir: neither FITTYP nor PROPERTY_FILE_FORMAT gives the version"
        );
    }
    assert!(change("'radians'", "'turns'").starts_with("x.tir:4: ANGLE = 'turns': must be one of radians, "));
    assert!(change("'meter'", "'furlong'").starts_with("x.tir:2: LENGTH = 'furlong': must be one of meter, "));
    assert!(change("'LEFT'", "'UP'").ends_with("must be LEFT, RIGHT, SYMMETRIC or UNKNOWN"));
    assert_eq!(change("FNOMIN = 800\n", ""), "x.tir: no FNOMIN");
    assert!(change("FNOMIN = 800", "FNOMIN = -800").ends_with("tyre.fnomin = -800: must be > 0 and finite"));
    assert!(change("PKY1=-30", "PKY1=30").contains("the cornering stiffness must be negative"));
    assert_eq!(change("PKY2=1.6", "PKY2=0"), "x.tir: tyre.pky2 = 0: must not be 0");
}

/// Degrees are for the ranges of the file; the coefficients are for radians.
#[test]
fn degrees_change_no_coefficient() {
    let file = parse("x.tir", &small("").replace("'radians'", "deg")).unwrap();
    assert_eq!(file.set, read_small("").set);
    assert!(file.notes.contains(&"ANGLE: degrees are for the ranges alone; the coefficients are for radians".into()));
}

/// A minimal file of version 6, with `more` at its end.
fn six(more: &str) -> String {
    small(more).replace("PROPERTY_FILE_FORMAT = 'PAC2002'", "FITTYP = 61")
}

#[test]
fn files_of_version_6_have_pressures() {
    let pressures = |text: &str| ["tyre.inflpres", "tyre.nompres"].map(|name| get(text, name));
    assert_eq!(pressures(&six("INFLPRES = 2E5\nNOMPRES = 220000")), [2e5, 2.2e5]);
    assert_eq!(pressures(&six("NOMPRES = 220000")), [2.2e5; 2]);
    assert_eq!(pressures(&six("INFLPRES = 220000")), [2.2e5; 2]);
    assert_eq!(pressures(&six("IP = 80\nIP_NOM = 83\n[UNITS]\nPRESSURE = kPa")), [8e4, 8.3e4]);
    let imperial = six("NOMPRES = 12").replace("'meter'", "inch").replace("'newton'", "pound_force");
    assert!(abs_diff_eq!(pressures(&imperial)[1], 12.0 * 6_894.757_293_168, epsilon = 1e-6));
    for (text, note) in [
        (six("NOMPRES = 220000"), "INFLPRES: not in the file, set to NOMPRES"),
        (six("INFLPRES = 220000"), "NOMPRES: not in the file, set to INFLPRES"),
        (six(""), "neither INFLPRES nor NOMPRES in the file: pressure has no effect"),
    ] {
        let notes = parse("x.tir", &text).unwrap().notes;
        assert!(notes.contains(&note.into()), "{notes:?}");
    }
    assert!(refusal(&six("NOMPRES = 0")).ends_with("tyre.nompres = 0: must be > 0 and finite"));
    assert!(refusal(&six("[UNITS]\nPRESSURE = mmHg")).starts_with("x.tir:21: PRESSURE = mmHg: must be one of pascal"));
}

#[test]
fn coefficients_count_in_their_version() {
    let file = parse("x.tir", &six("PHY3 = 0.1\nLGAY = 1\nPKY6 = -1\nPDXP1 = 0.4\n")).unwrap();
    assert_eq!(told(&file.unused), ["Magic Formula 5.2: PHY3, LGAY"]);
    assert_eq!(told(&file.ignored), ["turn slip: PDXP1"]);
    let values =
        ["version", "pky6", "pky4", "qsy7", "lkyc", "lmuv", "ppy1"].map(|key| file.set.get(&format!("tyre.{key}")));
    assert_eq!(values.map(Option::unwrap), [2.0, -1.0, 2.0, 1.0, 1.0, 0.0, 0.0]);
    assert!(file.notes.iter().any(|note| note == "not in the file, set to 2: PKY4"), "{:?}", file.notes);
    assert!(!file.notes.iter().any(|note| note.contains("LMUV") || note.contains("LGAX")), "{:?}", file.notes);
    assert_eq!([get(&small("PKY6 = -1"), "tyre.pky6"), get(&small("PKY6 = -1"), "tyre.version")], [0.0, 1.0]);
}

/// The spring of a tyre in both versions, in the units of the file and with the names of several programs.
#[test]
fn coefficients_of_the_spring_are_read_in_all_versions() {
    let spring = "QRE0 = 0.99\nQV1 = 1E-3\nQV2 = 0.05\nQ_FZ3 = -2\nDREFF = 0.3\nQ_FYS1 = 2\nQ_CAM2 = 0.1\n\
                  RIM_RADIUS = 127\nBOTTOM_OFFST = 8\nBOTTOM_STIFF = 2\nWIDTH = 200\nASPECT_RATIO = 0.5\n";
    let small = format!("{}VERTICAL_STIFFNESS = 0.1\nQ_FZ2 = 3\n", small(spring));
    let millimetres = small.replace("'meter'", "mm").replace("'newton'", "kN").replace("0.24", "240");
    let millimetres = millimetres.replace("FNOMIN = 800", "FNOMIN = 0.8");
    for text in [millimetres.clone(), millimetres.replace("PROPERTY_FILE_FORMAT = 'PAC2002'", "FITTYP = 62")] {
        let expected: [(&str, f64); 13] = [
            ("q_re0", 0.99),
            ("q_v1", 1e-3),
            ("q_v2", 0.05),
            ("q_cam", -2.0),
            ("dreff", 0.3),
            ("q_fys1", 2000.0),
            ("q_cam2", 100.0),
            ("rim_radius", 0.127),
            ("bottom_offst", 0.008),
            ("bottom_stiff", 2e6),
            ("width", 0.2),
            ("aspect_ratio", 0.5),
            ("q_fz2", 3.0),
        ];
        for (name, value) in expected {
            assert!(abs_diff_eq!(get(&text, &format!("tyre.{name}")), value, epsilon = 1e-12 * value.abs()), "{name}");
        }
        let file = parse("x.tir", &text).unwrap();
        assert!(file.unused.is_empty() && file.ignored.is_empty(), "{:?} {:?}", file.unused, file.ignored);
    }
    // The largest one is (C_z R_0 / F_z0)^2 / 4 = 225.
    let refused = refusal(&millimetres.replace("Q_FZ2 = 3", "Q_FZ2 = 226"));
    assert!(refused.starts_with("x.tir: tyre.q_fz2 = 226: must be at most "), "{refused}");
}

#[test]
fn a_progressive_spring_needs_its_stiffness() {
    let file = parse("x.tir", &six("Q_FZ2 = 400")).unwrap();
    assert_eq!(file.set.get("tyre.q_fz2"), Some(0.0));
    assert!(file.notes.contains(&"Q_FZ2: not used without VERTICAL_STIFFNESS".into()), "{:?}", file.notes);
    let absent = |text: &str| parse("x.tir", text).unwrap().notes.iter().any(|note| note.contains("DREFF"));
    assert!(absent(&six("")) && !absent(&six("DREFF = 0.2")) && !absent(&small("")));
}
