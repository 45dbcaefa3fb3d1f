//! The library of an FMU: how it is built for each platform, what it contains, and whether every machine can load it.

pub mod binary;
pub mod crates;
pub mod library;
pub mod platform;
pub mod toolchain;
pub mod universal;
pub mod wasm;
