//! The inputs that fuzzing has kept of each reader of files.

mod readers;

use std::fs::File;
use std::io::Read;

/// Gives a reader the inputs of its archive.
fn replay(name: &str, read: fn(&[u8])) {
    let path = format!("{}/../../fuzz/corpus/{name}.zip", env!("CARGO_MANIFEST_DIR"));
    let mut archive = zip::ZipArchive::new(File::open(path).unwrap()).unwrap();
    assert!(!archive.is_empty(), "{name}");
    for number in 0..archive.len() {
        let mut bytes = Vec::new();
        archive.by_index(number).unwrap().read_to_end(&mut bytes).unwrap();
        read(&bytes);
    }
}

#[test]
fn damper_tests() {
    replay("damper_test", readers::damper_test::read);
}

#[test]
fn descriptions_of_jobs() {
    replay("description", readers::description::read);
}

#[test]
fn records() {
    replay("record", readers::record::read);
}

#[test]
fn systems() {
    replay("system", readers::system::read);
}

#[test]
fn tyre_files() {
    replay("tyre_file", readers::tyre_file::read);
}
