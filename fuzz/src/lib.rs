//! Code shared by the fuzz targets: arguments that a careless or hostile caller might pass, and the bytes of a saved
//! state.
//!
//! A target turns bytes from the fuzzer into calls and checks the invariants after each of them: no result that is not
//! finite, nothing changed by a rejected call, no state outside the table, the same future from the same saved state.
//! `run.py` builds and runs the targets.

pub mod argument;
pub mod fmi2;
pub mod fmi3;
pub mod misuse;
pub mod misuse3;
pub mod saved;
pub mod slave;
pub mod version;
pub mod world;
