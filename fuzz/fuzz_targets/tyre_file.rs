//! Tyre property files.
#![no_main]

#[path = "../../lab/fit/tests/readers/tyre_file.rs"]
mod tyre_file;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| tyre_file::read(bytes));
