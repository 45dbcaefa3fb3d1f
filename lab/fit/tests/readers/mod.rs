//! What is asserted of files that people, or a fuzzer, write: also the bodies of the targets in `fuzz`.

pub mod damper_test;
pub mod description;
pub mod record;
pub mod system;
pub mod tyre_file;
