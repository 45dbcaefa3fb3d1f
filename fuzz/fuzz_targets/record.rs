//! Records of rigs, maps of friction and tyre tests, as text.
#![no_main]

#[path = "../../lab/fit/tests/readers/record.rs"]
mod record;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| record::read(bytes));
