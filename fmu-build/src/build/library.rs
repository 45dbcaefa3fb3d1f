//! Builds the shared library that every FMU carries.

use std::env;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use serde_json::Value;

use crate::build::crates::LIBRARY;
use crate::build::platform::Platform;
use crate::build::toolchain::{self, Target};
use crate::build::{binary, universal};

/// The shared library for one platform.
pub struct Library {
    /// The platform.
    pub platform: Platform,
    /// The file.
    pub bytes: Vec<u8>,
    /// The oldest glibc that it runs with, if it needs glibc.
    pub glibc: Option<String>,
}

/// Builds the library in release mode, and rejects it if it exports anything other than these functions or needs
/// something that a machine may lack. Its bytes depend only on the sources and the tools, not on their location.
pub fn build(root: &Path, platform: Platform, exports: &[String]) -> Result<Library> {
    let targets = platform.targets.iter().copied().map(Some);
    let targets = if platform.is_host() { vec![None] } else { targets.collect() };
    let parts = targets.into_iter().map(|target| compile(root, platform, target));
    let mut files = parts.collect::<Result<Vec<_>>>()?;
    let bytes = if files.len() == 1 { files.remove(0) } else { universal::join(&files)? };
    let glibc = check(root, platform, &bytes, exports).context("the library that was built is not usable")?;
    Ok(Library { platform, bytes, glibc })
}

/// Rejects a library that exports anything other than these functions, needs something that a machine may lack, or
/// contains a path of this machine. Returns the glibc that it needs.
pub fn check(root: &Path, platform: Platform, bytes: &[u8], exports: &[String]) -> Result<Option<String>> {
    let mut glibc = None;
    let parts = universal::parts(bytes)?.into_iter().map(binary::read).collect::<Result<Vec<_>>>()?;
    platform.check_machines(&parts)?;
    for library in &parts {
        platform.check(library, exports)?;
        glibc = library.newest_glibc();
    }
    let folders = remapped_paths(root)?.into_iter().map(|(folder, _)| folder);
    for path in folders.chain([target_folder(root), toolchain::sysroot()?]) {
        ensure!(!contains(bytes, &path), "{}: contains the path {}", platform.name(), path.display());
    }
    Ok(glibc)
}

/// Folders of this machine with which source paths in the library begin, and their replacements.
pub(super) fn remapped_paths(root: &Path) -> Result<Vec<(PathBuf, &'static str)>> {
    let mut paths = vec![
        (root.join("src"), "/stribeck/src"),
        (root.join("ffi"), "/stribeck/ffi"),
        (toolchain::sysroot()?.join("lib").join("rustlib").join("src").join("rust"), "/rust"),
    ];
    paths.extend(cargo_home().map(|home| (home.join("registry").join("src"), "/crates")));
    Ok(paths)
}

fn cargo_home() -> Option<PathBuf> {
    env::var_os("CARGO_HOME").map(PathBuf::from).or_else(|| Some(env::home_dir()?.join(".cargo")))
}

/// Flags that differ from those of `cargo build` would rebuild everything each time, so these builds have their own
/// folder.
pub(super) fn target_folder(root: &Path) -> PathBuf {
    env::var_os("CARGO_TARGET_DIR").map_or(root.join("target"), PathBuf::from).join("fmu")
}

/// The library for one target or, without one, for this machine.
fn compile(root: &Path, platform: Platform, target: Option<Target>) -> Result<Vec<u8>> {
    let folder = target_folder(root);
    let mut cargo = Command::new(target.map_or_else(toolchain::cargo, Target::cargo));
    cargo.arg("build");
    if let Some(target) = target {
        cargo.args(["--target", &target.argument()]).envs(target.environment(&folder)?);
    }
    let own = target.map_or(&[][..], Target::flags);
    cargo
        // With the shared library comes the static one, of the same code, for C.
        .args(["--release", "--lib", "--package", LIBRARY])
        .arg("--message-format=json-render-diagnostics")
        .arg("--target-dir")
        .arg(folder)
        .current_dir(root)
        .env("PATH", toolchain::search_path(root)?)
        .env_remove("RUSTFLAGS")
        .env("CARGO_ENCODED_RUSTFLAGS", flags(given_flags(), own, &remapped_paths(root)?));
    let messages = toolchain::stdout(&mut cargo)?;
    let mut messages = messages.lines().filter_map(|line| serde_json::from_str(line).ok());
    let file = messages.find_map(|message| artifact(&message, platform.suffix));
    let file = file.with_context(|| format!("cargo did not report a *{} of the package {LIBRARY}", platform.suffix))?;
    fs::read(&file).with_context(|| format!("cannot read {}", file.display()))
}

/// Separator of flags in cargo's encoding of a list.
const SEPARATOR: &str = "\u{1f}";

/// The flags that the user has set for rustc, in cargo's encoding.
fn given_flags() -> OsString {
    match env::var_os("CARGO_ENCODED_RUSTFLAGS") {
        Some(encoded) => encoded,
        None => encoded(&env::var("RUSTFLAGS").unwrap_or_default()).into(),
    }
}

fn encoded(flags: &str) -> String {
    flags.split_whitespace().collect::<Vec<_>>().join(SEPARATOR)
}

/// The given flags and ours.
pub(super) fn flags(given: OsString, own: &[&str], remapped: &[(PathBuf, &'static str)]) -> OsString {
    let mut flags = given;
    let mut push = |flag: OsString| {
        if !flags.is_empty() {
            flags.push(SEPARATOR);
        }
        flags.push(flag);
    };
    for flag in own {
        push(flag.into());
    }
    for (path, name) in remapped {
        let mut flag = OsString::from("--remap-path-prefix=");
        flag.push(path);
        flag.push("=");
        flag.push(name);
        push(flag);
    }
    flags
}

/// The shared library that a message of cargo reports, if it is one about it.
fn artifact(message: &Value, suffix: &str) -> Option<PathBuf> {
    let is_ours = message["reason"] == "compiler-artifact" && message["target"]["name"] == "stribeck";
    let files = message["filenames"].as_array().filter(|_| is_ours)?;
    let mut names = files.iter().filter_map(Value::as_str);
    names.find(|name| name.ends_with(suffix)).map(PathBuf::from)
}

pub(super) fn contains(bytes: &[u8], path: &Path) -> bool {
    let path = path.as_os_str().as_encoded_bytes();
    bytes.windows(path.len()).any(|window| window == path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn library_is_found_among_the_messages_of_cargo() {
        let message = |name: &str| {
            serde_json::json!({
                "reason": "compiler-artifact",
                "target": { "name": name },
                "filenames": ["/t/release/libstribeck.rlib", "/t/stribeck.dll.a", "/t/stribeck.dll"],
            })
        };
        assert_eq!(artifact(&message("stribeck"), ".dll"), Some(PathBuf::from("/t/stribeck.dll")));
        assert_eq!(artifact(&message("stribeck"), ".so"), None);
        assert_eq!(artifact(&message("libc"), ".dll"), None);
        assert_eq!(artifact(&serde_json::json!({ "reason": "build-finished", "success": true }), ".dll"), None);
    }

    #[test]
    fn flags_of_the_user_are_kept() {
        let remapped = [(PathBuf::from("/here"), "/there")];
        assert_eq!(flags(encoded("").into(), &[], &remapped), "--remap-path-prefix=/here=/there");
        let all = flags(encoded(" -C  target-cpu=native ").into(), &["-Clinker=ours"], &remapped);
        assert_eq!(all, "-C\u{1f}target-cpu=native\u{1f}-Clinker=ours\u{1f}--remap-path-prefix=/here=/there");
    }
}
