//! What the fuzz targets share: arguments that a careless or hostile caller might give, and the bytes of a saved state.
//!
//! A target takes bytes from the fuzzer, makes calls of them and checks what must hold after each of them, whatever was
//! called: no result that is not finite, nothing changed by a refused call, no state outside the table, the same future
//! from the same saved state. `run.py` builds and runs the targets.

pub mod argument;
pub mod fmi;
pub mod saved;
