//! Builds the library: the shared one that every FMU carries, and the static one of the same code.

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
    /// Files that cargo wrote with it, those of each processor: the static library and, for Windows, the one that
    /// programs are linked to in place of the shared one.
    pub beside: Vec<PathBuf>,
}

/// Builds the library in release mode, and rejects it if it exports anything other than these functions or needs
/// something that a machine may lack. Its bytes depend only on the sources and the tools, not on their location.
pub fn build(root: &Path, platform: Platform, exports: &[String]) -> Result<Library> {
    let targets = platform.targets.iter().copied().map(Some);
    let targets = if platform.is_host() { vec![None] } else { targets.collect() };
    let parts = targets.into_iter().map(|target| compile(root, target));
    let (mut shared, mut beside) = (Vec::new(), Vec::new());
    for files in parts {
        let (those, others): (Vec<_>, Vec<_>) = files?.into_iter().partition(|file| is_shared(file, platform.suffix));
        let file = those.first();
        shared.push(read(file.with_context(|| format!("cargo did not report a *{} of {LIBRARY}", platform.suffix))?)?);
        beside.extend(others);
    }
    let bytes = joined(shared)?;
    let glibc = check(root, platform, &bytes, exports).context("the library that was built is not usable")?;
    Ok(Library { platform, bytes, glibc, beside })
}

/// The library with these parts, of one processor each.
fn joined(mut parts: Vec<Vec<u8>>) -> Result<Vec<u8>> {
    if parts.len() == 1 { Ok(parts.remove(0)) } else { universal::join(&parts) }
}

impl Library {
    /// The static library; rejected if it contains a path of this machine.
    pub fn static_library(&self, root: &Path) -> Result<Vec<u8>> {
        let is_static = |file: &&PathBuf| name_of(file) == "libstribeck.a";
        let is_for_windows = self.platform.suffix == ".dll";
        let bytes = |file: &PathBuf| if is_for_windows { toolchain::without_debug_data(file) } else { read(file) };
        let library = joined(self.beside.iter().filter(is_static).map(bytes).collect::<Result<_>>()?)?;
        check_paths(root, self.platform, &library)?;
        Ok(library)
    }

    /// The library that programs for Windows are linked to in place of the shared one.
    pub fn import_library(&self) -> Result<Option<Vec<u8>>> {
        self.beside.iter().find(|file| name_of(file).ends_with(".dll.a")).map(|file| read(file)).transpose()
    }
}

fn name_of(file: &Path) -> std::borrow::Cow<'_, str> {
    file.file_name().unwrap_or_default().to_string_lossy()
}

fn read(file: &Path) -> Result<Vec<u8>> {
    fs::read(file).with_context(|| format!("cannot read {}", file.display()))
}

fn is_shared(file: &Path, suffix: &str) -> bool {
    name_of(file).ends_with(suffix)
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
    check_paths(root, platform, bytes)?;
    Ok(glibc)
}

fn check_paths(root: &Path, platform: Platform, bytes: &[u8]) -> Result<()> {
    let folders = remapped_paths(root)?.into_iter().map(|(folder, _)| folder);
    for path in folders.chain([target_folder(root), toolchain::sysroot()?]) {
        ensure!(!contains(bytes, &path), "{}: contains the path {}", platform.name(), path.display());
    }
    Ok(())
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

/// The files of the library for one target or, without one, for this machine.
fn compile(root: &Path, target: Option<Target>) -> Result<Vec<PathBuf>> {
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
    messages.find_map(|message| artifacts(&message)).with_context(|| format!("cargo did not report {LIBRARY}"))
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

/// The files of the library that a message of cargo reports, if it is one about it.
fn artifacts(message: &Value) -> Option<Vec<PathBuf>> {
    let target = &message["target"];
    let is_ours = target["name"] == "stribeck" && target["kind"].as_array()?.iter().any(|kind| kind == "cdylib");
    let files = message["filenames"].as_array().filter(|_| message["reason"] == "compiler-artifact" && is_ours)?;
    Some(files.iter().filter_map(Value::as_str).map(PathBuf::from).collect())
}

pub(super) fn contains(bytes: &[u8], path: &Path) -> bool {
    let path = path.as_os_str().as_encoded_bytes();
    bytes.windows(path.len()).any(|window| window == path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_the_library_are_found_among_the_messages_of_cargo() {
        let message = |name: &str| {
            serde_json::json!({
                "reason": "compiler-artifact",
                "target": { "name": name, "kind": ["cdylib", "staticlib"] },
                "filenames": ["/t/libstribeck.a", "/t/libstribeck.dll.a", "/t/stribeck.dll"],
            })
        };
        let files = artifacts(&message("stribeck")).unwrap();
        assert_eq!(files.iter().map(|file| is_shared(file, ".dll")).collect::<Vec<_>>(), [false, false, true]);
        assert_eq!(artifacts(&message("libc")), None);
        let rlib = serde_json::json!({ "name": "stribeck", "kind": ["lib"] });
        assert_eq!(artifacts(&serde_json::json!({ "reason": "compiler-artifact", "target": rlib })), None);
        assert_eq!(artifacts(&serde_json::json!({ "reason": "build-finished", "success": true })), None);
    }

    #[test]
    fn flags_of_the_user_are_kept() {
        let remapped = [(PathBuf::from("/here"), "/there")];
        assert_eq!(flags(encoded("").into(), &[], &remapped), "--remap-path-prefix=/here=/there");
        let all = flags(encoded(" -C  target-cpu=native ").into(), &["-Clinker=ours"], &remapped);
        assert_eq!(all, "-C\u{1f}target-cpu=native\u{1f}-Clinker=ours\u{1f}--remap-path-prefix=/here=/there");
    }
}
