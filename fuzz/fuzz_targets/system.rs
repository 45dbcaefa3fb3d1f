//! Files of systems, and short runs of them.
#![no_main]

#[path = "../../lab/fit/tests/readers/system.rs"]
mod system;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| system::read(bytes));
