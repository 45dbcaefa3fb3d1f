//! Builds the library of one model as WebAssembly, from which its C sources are made.

use std::ffi::OsString;
use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, ensure};

use super::library::{self, contains};
use super::toolchain::{self, has_standard_library};

const TRIPLE: &str = "wasm32-unknown-unknown";

/// The package that is built.
const PACKAGE: &str = "stribeck-sources";

/// Flags for a library with one law.
const ONE_LAW: [&str; 2] = ["--cfg", "stribeck_one_law"];

/// Builds the library of the model with this path in the crate, such as `friction::LuGre`, with a stack of so many bytes,
/// for inputs with slopes or without, with one law if it has a choice. Its bytes depend only on the sources and the tools,
/// not on their location.
pub fn build(root: &Path, model: &str, stack: usize, has_slopes: bool, law: Option<&str>) -> Result<Vec<u8>> {
    ensure!(has_standard_library(TRIPLE)?, "Rust's standard library for it is missing: rustup target add {TRIPLE}");
    // With one law the crates of the laws are others, which would displace those for all other models.
    let folder = library::target_folder(root).join(law.map_or("", |_| "one_law"));
    let mut paths = library::remapped_paths(root)?;
    paths.push((root.join("sources"), "/stribeck/sources"));
    let mut cargo = Command::new(toolchain::cargo());
    cargo
        .args(["build", "--profile", "sources", "--package", PACKAGE, "--target", TRIPLE, "--target-dir"])
        .arg(&folder)
        .current_dir(root)
        .env("STRIBECK_MODEL", model)
        .env("STRIBECK_STACK", stack.to_string())
        .env("STRIBECK_SLOPES", u8::from(has_slopes).to_string())
        .env_remove("RUSTFLAGS")
        .env_remove("STRIBECK_LAW")
        .envs(law.map(|law| ("STRIBECK_LAW", law)))
        .env("CARGO_ENCODED_RUSTFLAGS", library::flags(OsString::new(), law.map_or(&[], |_| &ONE_LAW), &paths));
    toolchain::stdout(&mut cargo).with_context(|| format!("cannot build the library of {model}"))?;
    let file = folder.join(TRIPLE).join("sources").join("stribeck_sources.wasm");
    let bytes = fs::read(&file).with_context(|| format!("cannot read {}", file.display()))?;
    for path in [folder, toolchain::sysroot()?].into_iter().chain(paths.into_iter().map(|(path, _)| path)) {
        ensure!(!contains(&bytes, &path), "the library of {model} contains the path {}", path.display());
    }
    Ok(bytes)
}
