//! Descriptions of runs, studies and identifications: what is read is written and read again as the same.
#![no_main]

#[path = "../../lab/fit/tests/readers/description.rs"]
mod description;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| description::read(bytes));
