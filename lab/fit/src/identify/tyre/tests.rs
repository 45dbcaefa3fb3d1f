//! Tests of tyres whose coefficients are known.

use std::f64::consts::TAU;
use std::fmt::Write;

use approx::assert_relative_eq;
use stribeck::host::{Contact, FormulaVersion};

use super::*;
use stribeck_sheet::Sheet;
use stribeck_solve::job::Entry;

/// The set of the library, which has no moments, with the moments of a passenger car tyre (Pacejka 2006, Table A3.1).
const MOMENTS: [(&str, f64); 13] = [
    ("qbz1", 10.9),
    ("qbz2", -1.9),
    ("qbz9", 16.0),
    ("qcz1", 1.18),
    ("qdz1", 0.1),
    ("qdz2", -0.006),
    ("qdz6", -0.006),
    ("qdz8", -0.18),
    ("qez1", -1.6),
    ("qez4", 0.17),
    ("qhz1", 0.002),
    ("ssz1", 0.03),
    ("lhy", 1.0),
];

fn truth() -> MagicFormula {
    let mut formula: MagicFormula = start();
    let row = row_of_mut(&mut formula);
    for (name, value) in MOMENTS {
        row[column(name)] = value;
    }
    formula.lvy = 1.0;
    // Within the loads of a test the cornering stiffness of the set is a straight line.
    formula.pky1 = -35.0;
    formula.pky2 = 1.7;
    // Without these the side force that slip induces is 0 whatever its other coefficients are.
    formula.rvy5 = 1.9;
    formula.rvy6 = 12.0;
    formula
}

/// A program of sweeps: side slip at loads and cambers, longitudinal slip at side slips; then samples as they come.
fn contacts(cambers: &[f64], loads: &[f64], is_combined: bool) -> Vec<Contact> {
    let mut list = Vec::new();
    let speed = 10.0;
    for load in loads {
        for camber in cambers {
            list.extend((0..28).map(|k| {
                let side_slip = 0.25 * (TAU * f64::from(k) / 28.0).sin();
                Contact { load: *load, longitudinal_slip: 0.0, side_slip, camber: *camber, speed }
            }));
        }
        let slips: &[f64] = if is_combined { &[-0.1, 0.0, 0.05] } else { &[] };
        for side_slip in slips {
            let camber = if *side_slip == 0.0 { 0.0 } else { cambers[0] };
            list.extend((0..28).map(|k| {
                let longitudinal_slip = 0.25 * (TAU * f64::from(k) / 28.0).sin();
                Contact { load: *load, longitudinal_slip, side_slip: *side_slip, camber, speed }
            }));
        }
    }
    list
}

/// The test as a rig would write it, with noise of a part of the largest value of each channel.
fn written(truth: &MagicFormula, contacts: &[Contact], noise: f64, axes: Axes) -> String {
    let mut random = fastrand::Rng::with_seed(8);
    let mut gauss = || (0..12).map(|_| random.f64()).sum::<f64>() - 6.0;
    let wrenches: Vec<[f64; 3]> =
        contacts.iter().map(|one| truth.wrench(one)).map(|one| [one.force_x, one.force_y, one.moment_z]).collect();
    let most = [0, 1, 2].map(|at| wrenches.iter().fold(0.0, |most: f64, one| most.max(one[at].abs())));
    let sign = if axes == Axes::Sae { -1.0 } else { 1.0 };
    let mut text = "FZ [N],SA [deg],SR,IA [deg],FX [N],FY [N],MZ [Nm]\n".to_owned();
    for (contact, [x, y, z]) in contacts.iter().zip(&wrenches) {
        let [x, y, z] = [(x, 0), (y, 1), (z, 2)].map(|(value, at)| value + noise * most[at] * gauss());
        let Contact { load, longitudinal_slip, side_slip, camber, .. } = contact;
        let [alpha, gamma] = [sign * side_slip, *camber].map(f64::to_degrees);
        let _ = writeln!(text, "{},{alpha},{longitudinal_slip},{gamma},{x},{},{}", sign * load, sign * y, sign * z);
    }
    text
}

fn test_of(text: &str, axes: Axes) -> Result<TyreTest, TyreTestError> {
    TyreTest::of(&Sheet::parse(text)?, axes)
}

fn task(fixed: &[(&str, f64)]) -> TyreTask {
    let fixed = fixed.iter().map(|(key, value)| ((*key).to_owned(), *value)).collect();
    TyreTask { radius: 0.2, nominal_load: Some(700.0), side: Side::Left, fixed }
}

const LOADS: [f64; 3] = [400.0, 700.0, 1100.0];

fn estimate<'a>(fit: &'a TyreFit, key: &str) -> &'a TyreEstimate {
    fit.estimates.iter().find(|one| one.key == key).unwrap_or_else(|| panic!("{key}"))
}

/// Read back from the file, the tyre has the forces of the truth within the noise of a test of so many samples, and the
/// intervals of the coefficients hold the truth.
#[test]
fn coefficients_come_back_from_a_test_in_either_axes() {
    let truth = truth();
    let contacts = contacts(&[0.0, -0.05, 0.05], &LOADS, true);
    let iso = test_of(&written(&truth, &contacts, 0.005, Axes::Iso), Axes::Iso).unwrap();
    let sae = test_of(&written(&truth, &contacts, 0.005, Axes::Sae), Axes::Sae).unwrap();
    for (a, b) in iso.samples.iter().zip(&sae.samples) {
        assert_relative_eq!(a.force_y.unwrap(), b.force_y.unwrap(), max_relative = 1e-12);
        assert_relative_eq!(a.side_slip, b.side_slip, max_relative = 1e-12);
    }
    let fit = fit_tyre(&iso, &task(&[])).unwrap();
    let (mut held, mut determined) = (0, 0);
    for one in &fit.estimates {
        if let Verdict::Within(half) = one.verdict {
            let known = row_of(&truth)[column(&one.key.to_lowercase())];
            // The formula is even in these.
            let known = if ["RBX2", "RBY2", "RVY4"].contains(&one.key.as_str()) { known.abs() } else { known };
            determined += 1;
            held += usize::from((one.value - known).abs() <= half);
        }
    }
    println!("{}", table(&fit));
    assert!(determined > 40 && 100 * held >= 88 * determined, "{held} of {determined}");
    let file = crate::tir::parse("fitted.tir", &property_file(&fit)).unwrap();
    let mut read: MagicFormula = start();
    for (column, variable) in MagicFormula::TABLE.iter().enumerate() {
        row_of_mut(&mut read)[column] = file.set.get(&format!("tyre.{}", variable.path)).unwrap();
    }
    let mut worst = [0.0f64; 3];
    for contact in &contacts {
        let [a, b] = [truth.wrench(contact), read.wrench(contact)];
        let apart = [a.force_x - b.force_x, a.force_y - b.force_y, a.moment_z - b.moment_z];
        worst = std::array::from_fn(|at| worst[at].max(apart[at].abs()));
    }
    // What was dropped leaves less than the noise.
    for ((name, _, rms, most), worst) in fit.left.iter().zip(worst) {
        assert!((0.9..1.1).contains(&(rms / most / 0.005)), "{name}: {rms} of {most}");
        assert!(worst < 0.01 * most, "{name}: {worst} of {most}");
    }
}

/// One load and no camber: what they would show has no number, neither in the table nor in the file.
#[test]
fn what_a_test_does_not_have_gets_no_number() {
    let truth = truth();
    let contacts = contacts(&[0.0, 0.0], &[700.0], false);
    let text = written(&truth, &contacts, 0.005, Axes::Iso);
    // Of one load the two coefficients of the cornering stiffness cannot be told apart, and no file can do without them.
    let refused = fit_tyre(&test_of(&text, Axes::Iso).unwrap(), &task(&[])).unwrap_err().to_string();
    assert!(refused.contains("PKY") && refused.contains("test at more loads"), "{refused}");
    let held = fit_tyre(&test_of(&text, Axes::Iso).unwrap(), &task(&[("PKY2", 1.7)])).unwrap();
    assert_eq!(estimate(&held, "PKY2").verdict, Verdict::Held);
    let stiffness = estimate(&held, "PKY1");
    assert!(
        matches!(stiffness.verdict, Verdict::Within(half) if (stiffness.value + 35.0).abs() < 1.5 * half),
        "{stiffness:?}"
    );
    assert!(property_file(&held).contains("\nPKY2   = 1.7 "), "{}", property_file(&held));
    let wrong = |fixed| fit_tyre(&test_of(&text, Axes::Iso).unwrap(), &task(fixed)).unwrap_err().to_string();
    assert_eq!(wrong(&[("PKYZ", 1.0)]), "coefficient 'PKYZ' does not exist (did you mean 'PKY3'?)");
    assert_eq!(wrong(&[("PKY2", f64::NAN)]), "PKY2 = NaN: must be a finite number");
    let contacts = super::tests::contacts(&[0.0], &LOADS, false);
    let test = test_of(&written(&truth, &contacts, 0.005, Axes::Iso), Axes::Iso).unwrap();
    let fit = fit_tyre(&test, &task(&[])).unwrap();
    let text = property_file(&fit);
    for key in ["PDY3", "PEY4", "PKY3", "PHY3", "PVY3", "QDZ8"] {
        assert!(matches!(&estimate(&fit, key).verdict, Verdict::Not(reason) if reason.contains("cambers")), "{key}");
        assert!(!text.contains(&format!("\n{key}")) && text.contains(&format!("$ {key}: not determined")), "{key}");
    }
    assert!(matches!(estimate(&fit, "PDY1").verdict, Verdict::Within(_)));
    // Nothing was asked about combined slip.
    assert!(fit.estimates.iter().all(|one| !one.key.starts_with('R') && !one.key.starts_with("PCX")));
    assert_eq!(crate::tir::parse("x.tir", &text).unwrap().set.get("tyre.pdy3"), Some(0.0));
}

#[test]
fn spoilt_tests_are_refused() {
    let text = written(&truth(), &contacts(&[0.0], &LOADS, false), 0.0, Axes::Iso);
    let refusal = |text: &str, axes: Axes| test_of(text, axes).map(|_| ()).unwrap_err().to_string();
    assert_eq!(refusal(&text, Axes::Sae), "line 2, FZ: 400 N: must be <= 0 with these axes");
    let reversed = text.replace("SA [deg]", "x").replace("IA [deg]", "SA [deg]");
    assert!(refusal(&text.replace("FY [N]", "y"), Axes::Iso).contains("no column 'F_y', 'FY', 'force_y'"));
    assert!(refusal(&text.replace("SA [deg]", "SA [furlong]"), Axes::Iso).contains("unit 'furlong'"));
    let few: Vec<&str> = text.lines().take(20).collect();
    assert_eq!(refusal(&few.join("\n"), Axes::Iso), "19 samples; at least 40 are needed");
    assert!(refusal(&text.replacen("400,", "abc,", 1), Axes::Iso).starts_with("line 2, FZ: 'abc'"));
    let angle = |name: &str| refusal(&text.replace(&format!("{name} [deg]"), name), Axes::Iso);
    let expected = "rad: must be at most pi/2 in magnitude; is the unit deg? Then write SA [deg]";
    assert!(angle("SA").starts_with("line 3, SA: ") && angle("SA").ends_with(expected), "{}", angle("SA"));
    // No side slip at all, since the camber is 0 throughout.
    let none = fit_tyre(&test_of(&reversed, Axes::Iso).unwrap(), &task(&[])).unwrap_err().to_string();
    assert!(none.starts_with("the side slip is 0 throughout"), "{none}");
    let mirrored: String = text
        .lines()
        .map(|line| {
            let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
            if let Ok(slip) = cells[1].parse::<f64>() {
                cells[1] = (-slip).to_string();
            }
            cells.join(",") + "\n"
        })
        .collect();
    assert!(refusal(&mirrored, Axes::Iso).starts_with("the side force rises with the side slip"));
    let test = test_of(&text, Axes::Iso).unwrap();
    let task = |radius, nominal_load| TyreTask { radius, nominal_load, ..task(&[]) };
    let refused = |task: TyreTask| fit_tyre(&test, &task).map(|_| ()).unwrap_err().to_string();
    assert_eq!(refused(task(0.0, None)), "radius = 0: must be > 0 and finite, in m");
    assert_eq!(refused(task(0.2, Some(f64::NAN))), "nominal load = NaN: must be > 0 and finite, in N");
}

/// A cornering test as a machine writes it: two pressures with transitions between them, and a slip ratio of -1 that was not measured.
#[test]
fn a_slip_that_was_not_measured_and_several_pressures_are_noted() {
    let truth = truth();
    let contacts = contacts(&[0.0, 0.05], &LOADS, false);
    let text = written(&truth, &contacts, 0.005, Axes::Sae);
    let (heading, rows) = text.split_once('\n').unwrap();
    let row = |(number, line): (usize, &str), pressure: f64, scale: f64| {
        let mut cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        cells[2] = -0.9997 + 3e-4 * (number as f64).sin();
        cells[5] *= scale;
        let cells: Vec<String> = cells.iter().map(f64::to_string).collect();
        format!("{},{}\n", cells.join(","), pressure + 0.3 * (number as f64).sin())
    };
    let low: String = rows.lines().enumerate().map(|one| row(one, 68.0, 0.9)).collect();
    let passing: String =
        rows.lines().take(4).enumerate().map(|one| row(one, 72.0 + 2.0 * one.0 as f64, 0.95)).collect();
    let high: String = rows.lines().chain(rows.lines().take(20)).enumerate().map(|one| row(one, 83.0, 1.0)).collect();
    let test = test_of(&format!("{heading},P [kPa]\n{low}{passing}{high}"), Axes::Sae).unwrap();
    assert!(test.samples.iter().all(|one| one.longitudinal_slip == 0.0));
    assert!(test.notes[0].starts_with("SR is -0.9997 throughout and is ignored as not measured"), "{:?}", test.notes);
    let chosen = |pressure: Option<f64>| {
        let mut test = test.clone();
        test.at_pressure(pressure).map(|()| test)
    };
    let count = contacts.len();
    let [usual, lower] = [None, Some(68e3)].map(|pressure| chosen(pressure).unwrap());
    assert_eq!([usual.samples.len(), lower.samples.len()], [count + 20, count]);
    assert!(usual.notes[1].contains("of 68.0, 83.0 kPa: fitted to the 188 samples at 83.0 kPa"), "{:?}", usual.notes);
    let peak = |test: &TyreTest| {
        let fit = fit_tyre(test, &task(&[])).unwrap();
        assert!(table(&fit).starts_with("SR is"), "{}", table(&fit));
        crate::tir::parse("fitted.tir", &property_file(&fit)).unwrap();
        estimate(&fit, "PDY1").value
    };
    assert_relative_eq!(peak(&lower) / peak(&usual), 0.9, max_relative = 0.01);
    let refused = chosen(Some(75e3)).unwrap_err().to_string();
    assert_eq!(refused, "pressure = 75000 Pa: must be one of those of the test, 68.0, 83.0 kPa");
}

/// Cornering and braking as a team has them: two tables with columns and units of their own.
fn cornering_and_braking() -> [String; 2] {
    let (truth, sides, speed) = (truth(), contacts(&[0.0, 0.05], &LOADS, false), 10.0);
    let mut cornering = "FZ [kN],SA [deg],IA [deg],FX [N],FY [lbf],SR\n".to_owned();
    for one in &sides {
        let ([alpha, gamma], force) = ([one.side_slip, one.camber].map(f64::to_degrees), truth.wrench(one).force_y);
        let _ = writeln!(cornering, "{},{alpha},{gamma},-60,{},-1", 1e-3 * one.load, force / 4.448_221_615_260_5);
    }
    let mut braking = "FX;FZ;SR\nkN;N;%\n".to_owned();
    for (load, step) in LOADS.into_iter().flat_map(|load| (0..60).map(move |step| (load, f64::from(step)))) {
        let longitudinal_slip = 0.25 * (TAU * step / 60.0).sin();
        let contact = Contact { load, longitudinal_slip, side_slip: 0.0, camber: 0.0, speed };
        let _ = writeln!(braking, "{};{load};{}", 1e-3 * truth.wrench(&contact).force_x, 100.0 * longitudinal_slip);
    }
    [cornering, braking]
}

/// Files with these names and texts, as a user asks about them.
fn asked(folder: &std::path::Path, files: &[(&str, &str)]) -> Inquiry {
    let path = |(name, text): &(&str, &str)| {
        let path = folder.join(name);
        std::fs::write(&path, text).unwrap();
        path
    };
    let (axes, radius, nominal_load) = (Some(Axes::Iso), Some(0.2), Some(700.0));
    Inquiry { records: files.iter().map(path).collect(), axes, radius, nominal_load, ..Inquiry::default() }
}

/// Machines write a slip by the loaded and one by the effective radius, and sometimes only one of them is measured.
#[test]
fn of_two_slips_the_first_one_that_changes_is_read() {
    let ([_, braking], folder) = (cornering_and_braking(), tempfile::tempdir().unwrap());
    let slips = |text: &str| {
        let test = asked(folder.path(), &[("along.csv", text)]).test().unwrap();
        (test.samples.iter().map(|one| one.longitudinal_slip).collect::<Vec<f64>>(), test.notes)
    };
    let with = |own: &str, other: &str, cell: &str| {
        let more = [other, "%"].into_iter().chain(std::iter::repeat(cell));
        let lines = braking.lines().zip(more).map(|(line, more)| format!("{line};{more}\n").replace("SR;", own));
        slips(&lines.collect::<String>())
    };
    let (alone, _) = slips(&braking);
    for (own, other, cell, note) in [
        ("SL;", "SR", "-100", "SR is constant: SL is read as the longitudinal slip"),
        ("SL;", "SR", "0", "SR is constant: SL is read as the longitudinal slip"),
        ("SR;", "SL", "-100", "SR is read as the longitudinal slip, and SL is not"),
        ("SR;", "SL", "many", "SR is read as the longitudinal slip, and SL is not"),
    ] {
        let (read, notes) = with(own, other, cell);
        assert_eq!(read, alone, "{own} {other} {cell}");
        assert!(notes.contains(&note.to_owned()), "{notes:?}");
    }
}

/// Without noise the coefficients are those of the truth, whatever the order of the files.
#[test]
fn cornering_and_braking_in_files_of_their_own_are_fitted_together() {
    let ([cornering, braking], folder) = (cornering_and_braking(), tempfile::tempdir().unwrap());
    let [side, along] = [("side.csv", &*cornering), ("along.csv", &*braking)];
    let expected = [
        "side: SR is -1.000 throughout and is ignored as not measured: free rolling is assumed",
        "side: 168 samples, 168 with side slip alone, 0 with longitudinal slip alone, 0 with both (slips up to 0.01 \
         count as 0); fitted: F_y",
        "along: no column 'alpha', 'SA', 'side_slip': the side slip is 0",
        "along: 180 samples, 6 with side slip alone, 174 with longitudinal slip alone, 0 with both (slips up to 0.01 \
         count as 0); fitted: F_x",
    ];
    assert_eq!(asked(folder.path(), &[side, along]).test().unwrap().notes, expected);
    for files in [[side, along], [along, side]] {
        let inquiry = asked(folder.path(), &files);
        let fit = fit_tyre(&inquiry.test().unwrap(), &inquiry.task().unwrap()).unwrap();
        for key in ["PCY1", "PDY1", "PEY1", "PKY1", "PKY2", "PCX1", "PDX1", "PEX1", "PKX1"] {
            let known = row_of(&truth())[column(&key.to_lowercase())];
            assert_relative_eq!(estimate(&fit, key).value, known, max_relative = 1e-3);
        }
        assert!(
            matches!(&estimate(&fit, "RBX1").verdict, Verdict::Not(reason) if reason.contains("cornering at once"))
        );
        assert_eq!(fit.left.iter().map(|left| left.0).collect::<Vec<_>>(), ["F_x", "F_y"]);
    }
}

#[test]
fn a_spoilt_file_of_several_is_named() {
    let ([cornering, braking], folder) = (cornering_and_braking(), tempfile::tempdir().unwrap());
    let side = ("side.csv", &*cornering);
    let with = |text: &str| asked(folder.path(), &[side, ("along.csv", text)]);
    let refusal = |inquiry: Inquiry| inquiry.test().map(|_| ()).unwrap_err().to_string();
    // Of braking alone no file can be made.
    let alone = asked(folder.path(), &[("along.csv", &braking)]);
    let refused = fit_tyre(&alone.test().unwrap(), &alone.task().unwrap()).map(|_| ()).unwrap_err().to_string();
    assert!(refused.starts_with("the side slip is 0 throughout"), "{refused}");
    let both = with(&braking);
    let named = |entry: &str| Inquiry { column: vec![entry.parse().unwrap()], ..both.clone() };
    assert_eq!(named("FZ=FZ").test().unwrap(), both.test().unwrap());
    let refused = refusal(named("FZ=Last"));
    assert!(refused.contains("side.csv, ") && refused.ends_with("along.csv: no column 'Last' for FZ"), "{refused}");
    let refused = refusal(with(&braking.replace(";%", ";deg")));
    assert!(refused.contains("along.csv: SR: unit 'deg', must be one of 1, %"), "{refused}");
    let refused = refusal(with(&braking.replace("FX;", "Zug;")));
    assert!(refused.contains("along.csv: no column 'F_y', 'FY', 'force_y'"), "{refused}");
}

/// A test of three sweeps while the tyre warms up, a sweep of the load, the sweeps of the test, and a cold repetition.
fn warmed_up() -> String {
    let truth = truth();
    let mut text = "ET,FZ,SA,FY,TSTC,TSTO\nsec,N,deg,N,deg F,deg C\n".to_owned();
    let mut time = 0.0;
    let mut row = |load: f64, side_slip: f64, celsius: f64, scale: f64| {
        let contact = Contact { load, longitudinal_slip: 0.0, side_slip, camber: 0.0, speed: 10.0 };
        let force = scale * truth.wrench(&contact).force_y;
        // The middle is as much colder as the outside is warmer.
        let (middle, outside) = (1.8 * (celsius - 3.0) + 32.0, celsius + 3.0);
        let _ = writeln!(text, "{time},{load},{},{force},{middle},{outside}", side_slip.to_degrees());
        time += 0.02;
    };
    let sweep = |step: i32| 0.2 * (TAU * f64::from(step) / 100.0).sin();
    (0..300).for_each(|step| row(700.0, sweep(step), 20.0 + f64::from(step / 100), 0.6));
    (0..50).for_each(|step| row(200.0 + 20.0 * f64::from(step), 0.0, 55.0, 1.0));
    for load in LOADS.into_iter().cycle().take(24) {
        (0..100).for_each(|step| row(load, sweep(step), 54.0 + f64::from(step % 3), 1.0));
    }
    (0..100).for_each(|step| row(700.0, sweep(step), 30.0, 0.6));
    text
}

#[test]
fn warm_up_is_named_and_left_out_if_asked() {
    let (text, folder) = (warmed_up(), tempfile::tempdir().unwrap());
    let fix = vec![Entry("PKY2".to_owned(), truth().pky2)];
    let all = Inquiry { fix, ..asked(folder.path(), &[("t.csv", &text)]) };
    let fitted = |inquiry: &Inquiry| fit_tyre(&inquiry.test().unwrap(), &inquiry.task().unwrap()).unwrap();
    let fit = fitted(&all);
    let told = fit.notes.join("\n");
    for (part, about) in [
        ("lines 303 to 353 (6.000 to 7.000 s)", "a sweep of the load from 200.0 to 1180 N without slip, not fitted"),
        ("lines 3 to 302 (0 to 5.980 s)", "the tyre has 20 to 22 degC, 55 degC in the rest: warm-up?"),
        ("lines 2753 to 2852 (55.00 to 56.98 s)", "the tyre has 30 to 30 degC"),
        ("lines 3 to ", "residuals of F_y are"),
    ] {
        assert!(fit.notes.iter().any(|note| note.contains(part) && note.contains(about)), "{part} {about}: {told}");
    }
    let late = Inquiry { skip: Some(5.99), ..all.clone() }.test().unwrap();
    assert!(late.notes.iter().any(|note| note.contains("300 of 2850 samples are left out")), "{:?}", late.notes);
    // Fitted with the rest, they are not the tyre; left out by time and temperature, the rest is.
    let known = truth().pdy1;
    assert!((estimate(&fit, "PDY1").value / known - 1.0).abs() > 0.01);
    let only = vec![Entry("TSTC".to_owned(), [110.0, f64::INFINITY])];
    let warm = Inquiry { skip: Some(5.99), only, ..all };
    let fit = fitted(&warm);
    let told = fit.notes.join("\n");
    assert!(told.contains("400 of 2850 samples are left out, as was asked for") && !told.contains("warm-up"), "{told}");
    assert_relative_eq!(estimate(&fit, "PDY1").value, known, max_relative = 1e-3);
}

#[test]
fn what_cannot_be_left_out_is_refused() {
    let (text, folder) = (warmed_up(), tempfile::tempdir().unwrap());
    let all = asked(folder.path(), &[("t.csv", &text)]);
    let refusal = |inquiry: Inquiry| inquiry.test().map(|_| ()).unwrap_err().to_string();
    let only = |name: &str, range| Inquiry { only: vec![Entry(name.to_owned(), range)], ..all.clone() };
    assert_eq!(refusal(only("ET", [9.0, 2.0])), "only: ET = 9:2: must be LOW:HIGH with LOW <= HIGH");
    assert!(refusal(only("TSTX", [0.0, 1.0])).contains("t.csv: no column 'TSTX'; there are ET, FZ"));
    assert!(refusal(only("ET", [900.0, 901.0])).ends_with("0 samples; at least 40 are needed"));
    let skipped = |skip| refusal(Inquiry { skip: Some(skip), ..all.clone() });
    assert_eq!(skipped(f64::NAN), "skip = NaN: must be >= 0 and finite, in s");
    assert!(skipped(1e6).ends_with("0 samples; at least 40 are needed"));
    let timeless = asked(folder.path(), &[("u.csv", &text.replace("ET,", "clock,"))]);
    let refused = refusal(Inquiry { skip: Some(1.0), ..timeless });
    assert!(refused.contains("u.csv: no column 'time', 'ET', 't'; there are clock"), "{refused}");
    // What is only looked at keeps no test from being fitted.
    for (from, to, expected) in [
        ("deg F", "furlong", "TSTC: unit 'furlong', must be one of K, degC, C, degF; the column is ignored"),
        ("deg F", "none", "TSTC has no unit; the column is ignored"),
    ] {
        let notes = asked(folder.path(), &[("v.csv", &text.replace(from, to))]).test().unwrap().notes;
        assert!(notes.iter().any(|note| note == expected), "{notes:?}");
    }
    // A line is that of the file, whatever was left out before it.
    let cell = |(at, line): (usize, &str)| line.replacen(",400,", if at == 402 { ",x400," } else { ",400," }, 1) + "\n";
    let spoilt: String = text.lines().enumerate().map(cell).collect();
    let refused = refusal(Inquiry { skip: Some(7.0), ..asked(folder.path(), &[("w.csv", &spoilt)]) });
    assert!(refused.contains("line 403, FZ: 'x400'"), "{refused}");
}

/// A tyre of version 6.1 that changes with its pressure.
fn truth_6() -> MagicFormula {
    let pressures = MagicFormula { ppy1: -0.4, ppy2: 0.5, ppy3: -0.1, ppy4: 0.3, nompres: 83e3, ..truth() };
    // Camber acts by its own stiffness; without it nothing depends on the last one of pressure.
    let six = FormulaVersion::Six.number();
    MagicFormula { version: six, pky6: -0.8, pky7: -0.2, pvy3: 0.0, pvy4: 0.0, ppz1: -0.3, ..pressures }
}

/// A cornering test of that tyre at some pressures, in kPa.
fn at_pressures(pressures: &[f64]) -> String {
    let contacts = contacts(&[0.0, -0.05, 0.05], &LOADS, false);
    let rows = |pressure: &f64| {
        let truth = MagicFormula { inflpres: 1e3 * pressure, ..truth_6() };
        let text = written(&truth, &contacts, 0.003, Axes::Iso);
        text.lines().skip(1).map(|line| format!("{line},{pressure}\n")).collect::<String>()
    };
    let all: String = pressures.iter().map(rows).collect();
    format!("FZ [N],SA [deg],SR,IA [deg],FX [N],FY [N],MZ [Nm],P [kPa]\n{all}")
}

/// Three pressures are fitted together: the coefficients of pressure are those of the truth, and the file is of 6.1.
#[test]
fn three_pressures_give_the_coefficients_of_pressure() {
    let folder = tempfile::tempdir().unwrap();
    let inquiry = asked(folder.path(), &[("p.csv", &at_pressures(&[70.0, 83.0, 97.0]))]);
    let test = inquiry.test().unwrap();
    assert_eq!((test.version(), test.nominal_pressure.unwrap().round()), (FormulaVersion::Six, 83e3));
    let fit = fit_tyre(&test, &inquiry.task().unwrap()).unwrap();
    for (key, known) in [("PPY1", -0.4), ("PPY2", 0.5), ("PPY3", -0.1), ("PPY4", 0.3), ("PPZ1", -0.3), ("PKY6", -0.8)] {
        let one = estimate(&fit, key);
        assert!(
            matches!(one.verdict, Verdict::Within(half) if (one.value - known).abs() <= 1.5 * half),
            "{key}: {one:?}"
        );
    }
    assert!(fit.estimates.iter().all(|one| one.key != "PHY3"));
    let text = property_file(&fit);
    let file = crate::tir::parse("fitted.tir", &text).unwrap();
    assert_eq!(file.notes[0], "FITTYP = 61: read as Magic Formula 6.1");
    for (name, expected) in
        [("nompres", fit.formula.nompres), ("inflpres", fit.formula.nompres), ("ppy1", fit.formula.ppy1)]
    {
        assert_eq!(file.set.get(&format!("tyre.{name}")), Some(expected), "{name}: {text}");
    }
    let one = Inquiry { pressure: Some(97e3), ..inquiry.clone() }.test().unwrap();
    assert_eq!((one.version(), one.samples.len()), (FormulaVersion::Five, test.samples.len() / 3));
    let five = Inquiry { formula: Some(FormulaChoice::Five), ..inquiry }.test().unwrap();
    assert_eq!((five.version(), five.samples.len()), (FormulaVersion::Five, test.samples.len() / 3));
}

/// Of two pressures only the changes of first order can be known.
#[test]
fn two_pressures_leave_the_second_order_undetermined() {
    let folder = tempfile::tempdir().unwrap();
    let plain = asked(folder.path(), &[("p.csv", &at_pressures(&[70.0, 83.0]))]);
    assert_eq!(plain.test().unwrap().version(), FormulaVersion::Five);
    let inquiry = Inquiry { nominal_pressure: Some(83e3), ..plain.clone() };
    let fit = fit_tyre(&inquiry.test().unwrap(), &inquiry.task().unwrap()).unwrap();
    let Verdict::Not(reason) = &estimate(&fit, "PPY4").verdict else { panic!("{:?}", estimate(&fit, "PPY4")) };
    assert_eq!(reason, "only in combination with others; test at more inflation pressures");
    assert!(matches!(estimate(&fit, "PPY3").verdict, Verdict::Within(_)));
    let refusal = |inquiry: Inquiry| inquiry.test().map(|_| ()).unwrap_err().to_string();
    let both = Inquiry { pressure: Some(83e3), ..inquiry.clone() };
    assert_eq!(refusal(both), "pressure: is for formula 5.2; 6.1 is fitted to all inflation pressures");
    let five = Inquiry { formula: Some(FormulaChoice::Five), ..inquiry.clone() };
    assert_eq!(refusal(five), "nominal_pressure: is for formula 6.1; 5.2 has no inflation pressure");
    let negative = Inquiry { nominal_pressure: Some(-1.0), ..inquiry };
    assert_eq!(refusal(negative), "nominal_pressure = -1: must be > 0 and finite, in Pa");
    let unknown = asked(folder.path(), &[("q.csv", &at_pressures(&[70.0]).replace("P [kPa]", "Q"))]);
    let unknown = Inquiry { formula: Some(FormulaChoice::Six), ..unknown };
    assert!(refusal(unknown).ends_with("formula 6.1 needs the inflation pressure of all samples; 252 have none"));
}
