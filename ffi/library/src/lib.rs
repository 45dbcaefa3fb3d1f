//! The shared and static library: exports the C functions of `stribeck-ffi`, and nothing else.

pub use stribeck_ffi::{c, fmi2, fmi3};
