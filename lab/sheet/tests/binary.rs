//! Binary measurements against the Python programs for them: `python3 tasks.py formats` writes the files with asammdf and
//! scipy, and what these read back as tables.

use std::panic;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use stribeck_sheet::{Quantity, Sheet, SheetError, table, tables};

/// Any unit: values as they are in the file.
const PLAIN: Quantity = Quantity {
    name: "any",
    units: &[("", 1.0, 0.0), ("s", 1.0, 0.0), ("N", 1.0, 0.0), ("kN", 1.0, 0.0), ("mm", 1.0, 0.0), ("degC", 1.0, 0.0)],
};

fn folder() -> PathBuf {
    PathBuf::from(std::env::var_os("FORMATS").expect("FORMATS: the folder that tasks.py formats has written"))
}

fn headings(path: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(path).unwrap();
    text.lines().next().unwrap().split(',').map(str::to_owned).collect()
}

/// Every channel of every group has the numbers that the Python program reads, to the last bit.
#[test]
fn channels_are_those_of_the_python_programs() {
    let mut channels = 0;
    for (name, groups) in [("rig0.mf4", 2), ("rig1.mf4", 2), ("rig2.mf4", 2), ("rig0.mat", 1), ("rig1.mat", 1)] {
        let found = tables(&folder().join(name), None).unwrap();
        assert_eq!(found.len(), groups, "{name}");
        for (number, table) in found.iter().enumerate() {
            let path = folder().join(format!("{name}-{number}.csv"));
            let wanted = std::fs::read_to_string(&path).unwrap();
            let rows: Vec<Vec<&str>> = wanted.lines().skip(1).map(|line| line.split(',').collect()).collect();
            assert_eq!(table.len(), rows.len(), "{name}");
            for (at, heading) in headings(&path).iter().enumerate() {
                channels += 1;
                let expected: Vec<f64> = rows.iter().map_while(|row| row[at].parse().ok()).collect();
                match table.column_named(heading, &PLAIN) {
                    Ok(values) => assert_eq!(values.as_ref(), Some(&expected), "{name} {heading}"),
                    // A channel that is shorter than the others ends before them.
                    Err(SheetError::Number { line, .. }) => {
                        assert!(heading == "short" && line as usize == expected.len() + 1, "{name} {heading}");
                    }
                    Err(error) => panic!("{name} {heading}: {error}"),
                }
            }
            for other in ["state", "matrix", "text", "scalar", "rig"] {
                assert!(!table.has(other), "{name} {other}");
            }
        }
    }
    assert_eq!(channels, 3 * 6 + 2 * 6);
    println!("figure: MDF 4 and MAT 5: {channels} channels equal to those of asammdf and scipy, to the last bit");
}

/// Files of MATLAB 4 to 8, with which scipy tests itself: the vectors that scipy finds in them and no others, or a reason
/// in one line.
#[test]
fn files_of_matlab_are_read_as_scipy_does() {
    let folder = folder().join("matlab");
    let all = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path());
    let (mut files, mut channels) = (0, 0);
    for path in all.filter(|path| path.extension().is_some_and(|extension| extension == "mat")) {
        files += 1;
        let wanted = folder.join(format!("{}-0.csv", path.file_name().unwrap().display()));
        if !wanted.exists() {
            let reason = tables(&path, None).unwrap_err().to_string();
            assert!(!reason.contains('\n'), "{reason}");
            continue;
        }
        let [wanted, found] = [&wanted, &path].map(|path| table(path, None).unwrap());
        assert_eq!(found.names().collect::<Vec<_>>(), wanted.names().collect::<Vec<_>>(), "{}", path.display());
        for name in wanted.names() {
            channels += 1;
            // Lines of a text are counted from its heading. Vectors that are shorter than others end before them.
            let values = |table: &Sheet, heading: u64| match table.column_named(name, &PLAIN) {
                Err(SheetError::Number { line, text, .. }) => format!("'{text}' after {} values", line - heading - 1),
                other => format!("{:?}", other.map_err(|error| error.to_string())),
            };
            assert_eq!(values(&found, 0), values(&wanted, 1), "{} {name}", path.display());
        }
    }
    assert!(files > 100 && channels > 30, "{files} files, {channels} channels");
    println!("figure: files of MATLAB 4 to 8: {channels} channels of {files} files equal to those of scipy");
}

/// Cut or overwritten files are refused, or read in part; they never stop the program, and nothing is printed for them.
#[test]
fn damaged_files_never_panic() {
    static REPORTED: AtomicUsize = AtomicUsize::new(0);
    let report = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        REPORTED.fetch_add(1, Ordering::Relaxed);
        report(info);
    }));
    let mut random = fastrand::Rng::with_seed(3);
    let mut refused = 0;
    for name in ["rig1.mf4", "rig0.mat", "rig1.mat"] {
        let bytes = std::fs::read(folder().join(name)).unwrap();
        let path = folder().join(format!("damaged-{name}"));
        for _ in 0..200 {
            let mut spoilt = bytes.clone();
            if random.bool() {
                spoilt.truncate(random.usize(..bytes.len()));
            }
            for _ in 0..random.usize(1..4) {
                if let Some(byte) = spoilt.get_mut(random.usize(..600)) {
                    *byte = random.u8(..);
                }
            }
            std::fs::write(&path, spoilt).unwrap();
            refused += usize::from(tables(&path, None).map(|tables: Vec<Sheet>| tables.len()).is_err());
        }
    }
    assert!(refused > 100, "{refused}");
    assert_eq!(REPORTED.load(Ordering::Relaxed), 0);
}
