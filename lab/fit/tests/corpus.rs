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
fn readers_of_files_take_what_fuzzing_has_kept() {
    replay("damper_test", readers::damper_test::read);
    replay("description", readers::description::read);
    replay("record", readers::record::read);
    replay("system", readers::system::read);
    replay("tyre_file", readers::tyre_file::read);
}
