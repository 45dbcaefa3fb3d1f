//! Spoilt files of every format: each is read and gives finite numbers, or is refused in one line that says where.

mod common;

use std::io::Write;
use std::path::Path;

use common::rig;
use stribeck_fit::dyno::{Options, Test, find_damper};
use stribeck_fit::identify::{
    self,
    tyre::{Axes, Sample, TyreTest},
};
use stribeck_fit::rig::Faults;
use stribeck_fit::tir;
use stribeck_measured::{Record, Setup, average};
use stribeck_sheet::{DISPLACEMENT, FORCE, Sheet, TIME, table};

type Outcome = Result<Vec<f64>, String>;

/// A record of a rig, as text.
fn record_text() -> String {
    let text = rig(Faults::NOISE).record().unwrap().force;
    text.lines().enumerate().filter(|(at, _)| at % 7 < 1).map(|(_, line)| line.to_owned() + "\n").collect()
}

fn record(sheet: &Sheet) -> Outcome {
    let setup = Setup { mass: 1.0, normal_force: Some(20.0), window: Some(0.05), ..Setup::default() };
    let record = Record::of(sheet, None, &setup).map_err(|error| error.to_string())?;
    let mean = average(&record).map_or_else(Vec::new, |cycle| [cycle.friction_force, cycle.deviation].concat());
    let columns = [record.time, record.force, record.displacement, record.velocity, record.acceleration];
    Ok([columns.concat(), record.friction_force, mean].concat())
}

/// A file in which a record is found, or not.
fn record_in(bytes: &[u8], ending: &str, folder: &Path) -> Outcome {
    let path = folder.join(format!("file.{ending}"));
    std::fs::write(&path, bytes).unwrap();
    record(&table(&path, None).map_err(|error| error.to_string().replace(&path.display().to_string(), "file"))?)
}

fn damper(text: &[u8]) -> Outcome {
    let test = Test::parse(&String::from_utf8_lossy(text)).map_err(|error| error.to_string())?;
    let damper = find_damper(&test, &Options::default()).map_err(|error| error.to_string())?;
    let points = damper.table.iter().flat_map(|(velocity, force)| [*velocity, *force]);
    Ok(points.chain([damper.rms_error, damper.max_error]).chain(test.velocity).chain(test.force).collect())
}

fn tyre_test(text: &[u8]) -> Outcome {
    let sheet = Sheet::parse(&String::from_utf8_lossy(text)).map_err(|error| error.to_string())?;
    let test = TyreTest::of(&sheet, Axes::Iso).map_err(|error| error.to_string())?;
    let numbers = |one: &Sample| {
        let measured = [one.force_x, one.force_y, one.moment_z].into_iter().flatten();
        [one.load, one.side_slip, one.longitudinal_slip, one.camber].into_iter().chain(measured).collect::<Vec<f64>>()
    };
    Ok(test.samples.iter().flat_map(numbers).collect())
}

fn property_file(text: &[u8]) -> Outcome {
    let file = tir::parse("file.tir", &String::from_utf8_lossy(text)).map_err(|error| error.to_string())?;
    assert!(file.set.values().all(|(variable, value)| variable.admits(value)));
    Ok(file.set.values().map(|(_, value)| value).collect())
}

fn columns(text: &str) -> Vec<(String, Vec<f64>)> {
    let sheet = Sheet::parse(text).unwrap();
    let quantities = [&TIME, &FORCE, &DISPLACEMENT];
    let filled =
        quantities.iter().filter_map(|quantity| Some((quantity.name.to_owned(), sheet.column(quantity).unwrap()?)));
    filled.collect()
}

/// An element of a MAT 5 file.
fn element(kind: u32, bytes: &[u8]) -> Vec<u8> {
    let mut all = [kind.to_le_bytes(), (bytes.len() as u32).to_le_bytes()].concat();
    all.extend(bytes);
    if kind < 14 {
        all.resize(all.len().next_multiple_of(8), 0);
    }
    all
}

/// Columns as MAT 5, every second one compressed.
fn mat_5(columns: &[(String, Vec<f64>)]) -> Vec<u8> {
    let mut file = format!("{:<124}", "MATLAB 5.0 MAT-file").into_bytes();
    file.extend([0, 1, b'I', b'M']);
    for (at, (name, values)) in columns.iter().enumerate() {
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        let dimensions = [(values.len() as u32).to_le_bytes(), 1u32.to_le_bytes()].concat();
        let parts = [element(6, &[6, 0, 0, 0, 0, 0, 0, 0]), element(5, &dimensions), element(1, name.as_bytes())];
        let variable = element(14, &[parts.concat(), element(9, &bytes)].concat());
        if at % 2 == 0 {
            file.extend(variable);
            continue;
        }
        let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::fast());
        encoder.write_all(&variable).unwrap();
        file.extend(element(15, &encoder.finish().unwrap()));
    }
    file
}

fn mat_4(columns: &[(String, Vec<f64>)]) -> Vec<u8> {
    let variable = |(name, values): &(String, Vec<f64>)| {
        let header = [0, values.len() as u32, 1, 0, name.len() as u32 + 1].map(u32::to_le_bytes).concat();
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        [&header[..], name.as_bytes(), &[0], &bytes].concat()
    };
    columns.iter().flat_map(variable).collect()
}

/// A block of an MDF file: its links, then its data.
fn block(id: &str, links: &[u64], data: &[u8]) -> Vec<u8> {
    let length = (24 + 8 * links.len() + data.len()) as u64;
    let numbers = [[length, links.len() as u64].as_slice(), links].concat();
    let mut all = [b"##", id.as_bytes(), &[0; 4]].concat();
    all.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
    all.extend(data);
    all.resize(all.len().next_multiple_of(8), 0);
    all
}

/// Columns as MDF 4, the first one the master channel.
fn mdf(columns: &[(String, Vec<f64>)]) -> Vec<u8> {
    let [head, group, channels] = [64_u64, 64 + 104, 64 + 104 + 64];
    let (count, samples) = (columns.len() as u64, columns[0].1.len());
    // A name takes 40 bytes, since they are shorter than 16 letters.
    let channel = |at: u64| channels + 104 + 160 * at;
    let name = |at: u64| channel(count) + 40 * at;
    let zeros = |bytes: usize| vec![0; bytes];
    let identification = [&b"MDF     4.10    test    "[..], &[0; 4], &410_u16.to_le_bytes(), &[0; 34]].concat();
    let record = [zeros(8), (samples as u64).to_le_bytes().to_vec(), zeros(8)].concat();
    let record = [record, (8 * columns.len() as u32).to_le_bytes().to_vec(), zeros(4)].concat();
    let mut file = [
        identification,
        block("HD", &[group, 0, 0, 0, 0, 0], &zeros(32)),
        block("DG", &[0, channels, name(count), 0], &zeros(8)),
        block("CG", &[0, channel(0), 0, 0, 0, 0], &record),
    ]
    .concat();
    assert_eq!([head + 104, file.len() as u64], [group, channel(0)]);
    for at in 0..count {
        let next = if at + 1 < count { channel(at + 1) } else { 0 };
        let kind = if at == 0 { [2, 1, 4, 0] } else { [0, 0, 4, 0] };
        let place = [8 * at as u32, 64].map(u32::to_le_bytes).concat();
        file.extend(block("CN", &[next, 0, name(at), 0, 0, 0, 0, 0], &[&kind[..], &place, &[0; 60]].concat()));
    }
    for (name, _) in columns {
        let mut text = name.clone().into_bytes();
        text.resize(16, 0);
        file.extend(block("TX", &[], &text));
    }
    let values = (0..samples).flat_map(|row| columns.iter().flat_map(move |(_, column)| column[row].to_le_bytes()));
    file.extend(block("DT", &[], &values.collect::<Vec<u8>>()));
    file
}

/// Tables as the sheets a and b of a workbook, not compressed.
fn workbook(tables: [&str; 2]) -> Vec<u8> {
    let main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
    let office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    let package = "http://schemas.openxmlformats.org/package/2006/relationships";
    let relations = |all: &[(&str, &str)]| {
        let one = |(target, kind): &(&str, &str)| {
            let name = target.replace('/', "");
            format!("<Relationship Id='{name}' Type='{office}/{kind}' Target='{target}'/>")
        };
        format!("<Relationships xmlns='{package}'>{}</Relationships>", all.iter().map(one).collect::<String>())
    };
    let cell = |text: &str| match text.parse::<f64>() {
        Ok(number) if number.is_finite() => format!("<c><v>{text}</v></c>"),
        _ => format!("<c t='inlineStr'><is><t>{text}</t></is></c>"),
    };
    let row = |line: &str| format!("<row>{}</row>", line.split(',').map(cell).collect::<String>());
    let sheet = |text: &str| {
        let rows: String = text.lines().map(row).collect();
        format!("<worksheet xmlns='{main}'><sheetData>{rows}</sheetData></worksheet>")
    };
    let listed = ["a", "b"].map(|name| format!("<sheet name='{name}' sheetId='1' r:id='{name}.xml'/>")).concat();
    let book = format!("<workbook xmlns='{main}' xmlns:r='{office}'><sheets>{listed}</sheets></workbook>");
    let parts = [
        ("_rels/.rels", relations(&[("xl/workbook.xml", "officeDocument")])),
        ("xl/workbook.xml", book),
        ("xl/_rels/workbook.xml.rels", relations(&["a.xml", "b.xml"].map(|name| (name, "worksheet")))),
        ("xl/a.xml", sheet(tables[0])),
        ("xl/b.xml", sheet(tables[1])),
    ];
    let mut zip = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for (name, text) in parts {
        let stored = zip::write::SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
        zip.start_file(name, stored).unwrap();
        zip.write_all(text.as_bytes()).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

/// Cut after every so many bytes.
fn cut(bytes: &[u8], times: usize) -> Vec<Vec<u8>> {
    (0..times).map(|at| bytes[..bytes.len() * at / times].to_vec()).collect()
}

/// Some bytes changed, lost or doubled.
fn bytes_changed(bytes: &[u8], times: usize, random: &mut fastrand::Rng) -> Vec<Vec<u8>> {
    let change = |_| {
        let mut spoilt = bytes.to_vec();
        for _ in 0..random.usize(1..4) {
            let at = random.usize(..spoilt.len().min(bytes.len()));
            let end = (at + random.usize(..40)).min(spoilt.len());
            match random.usize(..4) {
                0 => spoilt[at] ^= 1 << random.u8(..8),
                1 => spoilt[at] = random.u8(..),
                2 => drop(spoilt.drain(at..end)),
                _ => drop(spoilt.splice(at..at, bytes[at..end.clamp(at, bytes.len())].to_vec())),
            }
        }
        spoilt
    };
    (0..times).map(change).collect()
}

type Reader<'a> = Box<dyn Fn(&[u8]) -> Outcome + 'a>;

/// A tyre test with its load in N.
fn tyre_text() -> String {
    let row = |k: i32| {
        let slip = 0.4 * f64::from(k);
        let [force, moment] = [-900.0 * (0.3 * slip).tanh(), 20.0 * slip / (1.0 + slip * slip)];
        format!("700,{slip},0,1,0,{force},{moment}\n")
    };
    "FZ [N],SA [deg],SR,IA [deg],FX [N],FY [N],MZ [Nm]\n".to_owned() + &(-30..30).map(row).collect::<String>()
}

/// A damper of 1500 N s/m with a friction of 20 N.
fn damper_text() -> String {
    let row = |k: i32| {
        let velocity = 0.5 * (0.2 * f64::from(k)).sin();
        format!("{velocity},{}\n", 1500.0 * velocity + 20.0 * velocity.signum())
    };
    "velocity [m/s],force [N]\n".to_owned() + &(1..120).map(row).collect::<String>()
}

const TYRE_FILE: &str = include_str!("../../../examples/tyres/formula_student.tir");

/// Files of every format, and what reads them.
fn files(folder: &Path) -> Vec<(&'static str, Vec<u8>, Reader<'_>)> {
    let text = record_text();
    let columns = columns(&text);
    let of = |ending: &'static str| -> Reader { Box::new(move |bytes| record_in(bytes, ending, folder)) };
    vec![
        ("csv", text.clone().into_bytes(), of("csv")),
        ("MAT 5", mat_5(&columns), of("mat")),
        ("MAT 4", mat_4(&columns), of("mat")),
        ("MDF", mdf(&columns), of("mf4")),
        ("xlsx", workbook(["Rig,A12", &text]), of("xlsx")),
        ("damper", damper_text().into_bytes(), Box::new(damper)),
        ("tyre", tyre_text().into_bytes(), Box::new(tyre_test)),
        ("tir", TYRE_FILE.to_owned().into_bytes(), Box::new(property_file)),
    ]
}

/// Words of a refusal that say where a mistake is: its line, byte, column or part, or that it is the file as a whole.
const PLACES: [&str; 17] = [
    "at offset 0x",
    "block size: ",
    "version: ",
    "line ",
    "byte ",
    "file.tir:",
    "no column '",
    "two columns '",
    ": unit '",
    "samples; at least",
    "samples in ",
    "sheet '",
    "no sheet has ",
    "file: the file ",
    "friction gives ",
    "force and velocity",
    "displacement and velocity",
];

#[test]
fn spoilt_bytes_are_refused_in_one_line_or_give_finite_numbers() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = fastrand::Rng::with_seed(5);
    for (name, bytes, read) in files(folder.path()) {
        assert!(read(&bytes).is_ok(), "{name}: {:?}", read(&bytes));
        let mut refused = 0;
        for spoilt in [cut(&bytes, 100), bytes_changed(&bytes, 200, &mut random)].concat() {
            match read(&spoilt) {
                Ok(values) => assert!(values.iter().all(|value| value.is_finite()), "{name}: {values:?}"),
                Err(reason) => {
                    refused += 1;
                    let is_one_line = !reason.contains('\n') && reason.len() < 1000;
                    assert!(is_one_line && PLACES.iter().any(|place| reason.contains(place)), "{name}: {reason}");
                }
            }
        }
        assert!(refused > 100, "{name}: {refused}");
    }
}

/// A table with another text in one cell; rows are counted from its heading.
fn with_cell(text: &str, row: usize, column: usize, cell: &str) -> String {
    let line = |(at, line): (usize, &str)| {
        let mut cells: Vec<&str> = line.split(',').collect();
        if at == row {
            cells[column] = cell;
        }
        cells.join(",") + "\n"
    };
    text.lines().enumerate().map(line).collect()
}

#[test]
fn mistakes_in_cells_are_refused_with_line_and_column() {
    let folder = tempfile::tempdir().unwrap();
    let text = record_text();
    let heading: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    let at = |name: &str| heading.iter().position(|heading| heading.starts_with(name)).unwrap();
    let in_both = |text: &str, wanted: &str| {
        for (bytes, ending) in [(text.as_bytes().to_vec(), "csv"), (workbook([text, "Rig,A12"]), "xlsx")] {
            let reason = record_in(&bytes, ending, folder.path()).unwrap_err();
            assert!(reason.starts_with(wanted), "{ending}: {reason}");
        }
    };
    for wrong in ["nan", "-inf", "x", "1e999", "1.2.3"] {
        let place = format!("line 9, force: '{wrong}' is not a finite number");
        in_both(&with_cell(&text, 8, at("force"), wrong), &place);
    }
    in_both(&with_cell(&text, 0, at("force"), "force [kg]"), "force: unit 'kg', must be one of N, ");
    in_both(&with_cell(&text, 0, at("displacement"), "force"), "two columns 'force'");
    let earlier = text.lines().nth(7).unwrap().split(',').nth(at("time")).unwrap();
    in_both(&with_cell(&text, 8, at("time"), earlier), "line 9, time: ");
    let mut columns = columns(&text);
    columns[1].1[7] = f64::NAN;
    for file in [mat_4(&columns), mat_5(&columns)] {
        let reason = record_in(&file, "mat", folder.path()).unwrap_err();
        assert_eq!(reason, "line 8, force: 'NaN' is not a finite number");
    }
    let wrong = damper(with_cell(&damper_text(), 3, 0, "x").as_bytes()).unwrap_err();
    assert_eq!(wrong, "line 4, velocity: 'x' is not a finite number");
    let wrong = tyre_test(with_cell(&tyre_text(), 3, 5, "nan").as_bytes()).unwrap_err();
    assert_eq!(wrong, "line 4, FY: 'nan' is not a finite number");
    let line = TYRE_FILE.lines().position(|line| line.starts_with("PKY1")).unwrap();
    let spoilt: Vec<&str> =
        TYRE_FILE.lines().enumerate().map(|(at, text)| if at == line { "PKY1 = nan" } else { text }).collect();
    let wrong = property_file(spoilt.join("\n").as_bytes()).unwrap_err();
    assert_eq!(wrong, format!("file.tir:{}: PKY1 = nan: must be a finite number", line + 1));
}

/// The sheet that was read is noted for every kind of file, unless it was chosen.
#[test]
fn the_sheet_that_was_read_is_noted() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, workbook(["Rig,A12", text])).unwrap();
        path
    };
    let notes = |sheet: Option<&str>| {
        let sheet = sheet.map(str::to_owned);
        let records = vec![file("record.xlsx", &record_text())];
        let law = vec!["Dahl".to_owned()];
        let (normal_force, sheet_of) = (Some(20.0), sheet.clone());
        let inquiry = identify::Inquiry { records, law, normal_force, sheet: sheet_of, ..Default::default() };
        let found = inquiry.data(&identify::Files).unwrap();
        let record = Some(file("damper.xlsx", &damper_text()));
        let test =
            identify::damper::Inquiry { record, sheet: sheet.clone(), ..Default::default() }.answer().unwrap().test;
        let (records, axes) = (vec![file("tyre.xlsx", &tyre_text())], Some(Axes::Iso));
        let tyre = identify::tyre::Inquiry { records, axes, sheet, ..Default::default() }.test().unwrap();
        [found.records[0].1.quality.findings.clone(), test.note.into_iter().collect(), tyre.notes]
    };
    let note =
        "the table was read from sheet 'b', the first of 2 that has one; --sheet NAME chooses another".to_owned();
    assert!(notes(None).iter().all(|notes| notes.contains(&note)), "{:?}", notes(None));
    assert!(!notes(Some("b")).iter().any(|notes| notes.contains(&note)));
}
