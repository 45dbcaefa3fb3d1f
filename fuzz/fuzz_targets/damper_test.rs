//! Files of damper tests, and the dampers found in them.
#![no_main]

#[path = "../../lab/fit/tests/readers/damper_test.rs"]
mod damper_test;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| damper_test::read(bytes));
