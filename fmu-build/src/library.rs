//! Builds the shared library that every FMU carries.

use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail, ensure};
use serde_json::Value;

/// The shared library for one platform.
pub struct Library {
    /// Name of the platform's folder in an FMU.
    pub platform: &'static str,
    /// Ending of the file's name, with the dot.
    pub suffix: &'static str,
    /// The file.
    pub bytes: Vec<u8>,
}

/// Builds the library in release mode for this machine. Its bytes depend on the sources and the compiler only, not on
/// where they lie.
pub fn build(root: &Path) -> Result<Library> {
    let platform = platform(env::consts::OS, env::consts::ARCH)?;
    let remapped = remapped_paths(root)?;
    let file = compile(root, &remapped)?;
    let bytes = std::fs::read(&file).with_context(|| format!("cannot read {}", file.display()))?;
    for (path, _) in &remapped {
        ensure!(!contains(&bytes, path), "{} holds the path {}", file.display(), path.display());
    }
    Ok(Library { platform, suffix: env::consts::DLL_SUFFIX, bytes })
}

/// The folder of FMI 2.0 for a platform; the standard has none for ARM, so Linux there uses the name of FMI 3.0.
fn platform(os: &str, architecture: &str) -> Result<&'static str> {
    Ok(match (os, architecture) {
        ("linux", "x86_64") => "linux64",
        ("linux", "x86") => "linux32",
        ("linux", "aarch64") => "aarch64-linux",
        ("windows", "x86_64") => "win64",
        ("windows", "x86") => "win32",
        ("macos", "x86_64" | "aarch64") => "darwin64",
        _ => bail!("FMI has no platform name for {architecture} {os}"),
    })
}

/// Folders of this machine that source paths in the library begin with, and what to write instead.
fn remapped_paths(root: &Path) -> Result<Vec<(PathBuf, &'static str)>> {
    let rustc = env::var_os("RUSTC").unwrap_or("rustc".into());
    let sysroot = stdout(Command::new(rustc).args(["--print", "sysroot"]))?;
    let mut paths = vec![
        (root.join("src"), "/stribeck/src"),
        (Path::new(sysroot.trim()).join("lib").join("rustlib").join("src").join("rust"), "/rust"),
    ];
    paths.extend(cargo_home().map(|home| (home.join("registry").join("src"), "/crates")));
    Ok(paths)
}

fn cargo_home() -> Option<PathBuf> {
    env::var_os("CARGO_HOME").map(PathBuf::from).or_else(|| Some(env::home_dir()?.join(".cargo")))
}

/// Runs cargo and returns the path of the library.
fn compile(root: &Path, remapped: &[(PathBuf, &'static str)]) -> Result<PathBuf> {
    // Other flags would rebuild everything each time, so this build has a folder of its own.
    let target = env::var_os("CARGO_TARGET_DIR").map_or(root.join("target"), PathBuf::from).join("fmu");
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo
        .args(["build", "--release", "--lib", "--package", "stribeck"])
        .arg("--message-format=json-render-diagnostics")
        .arg("--target-dir")
        .arg(target)
        .current_dir(root)
        .env_remove("RUSTFLAGS")
        .env("CARGO_ENCODED_RUSTFLAGS", flags(given_flags(), remapped));
    let messages = stdout(&mut cargo)?;
    let file =
        messages.lines().filter_map(|line| serde_json::from_str(line).ok()).find_map(|message| artifact(&message));
    file.with_context(|| format!("cargo named no *{} of the package stribeck", env::consts::DLL_SUFFIX))
}

/// What separates flags in cargo's encoding of a list of them.
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
fn flags(given: OsString, remapped: &[(PathBuf, &'static str)]) -> OsString {
    let mut flags = given;
    for (path, name) in remapped {
        if !flags.is_empty() {
            flags.push(SEPARATOR);
        }
        flags.push("--remap-path-prefix=");
        flags.push(path);
        flags.push("=");
        flags.push(name);
    }
    flags
}

/// The shared library that a message of cargo reports, if it is one about it.
fn artifact(message: &Value) -> Option<PathBuf> {
    let is_ours = message["reason"] == "compiler-artifact" && message["target"]["name"] == "stribeck";
    let files = message["filenames"].as_array().filter(|_| is_ours)?;
    let mut names = files.iter().filter_map(Value::as_str);
    names.find(|name| name.ends_with(env::consts::DLL_SUFFIX)).map(PathBuf::from)
}

/// Runs a command, whose complaints go to the terminal, and returns what it prints.
fn stdout(command: &mut Command) -> Result<String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let output = command.stderr(Stdio::inherit()).output().with_context(|| format!("cannot run {name}"))?;
    ensure!(output.status.success(), "{name} failed: {}", output.status);
    Ok(String::from_utf8(output.stdout)?)
}

fn contains(bytes: &[u8], path: &Path) -> bool {
    let path = path.as_os_str().as_encoded_bytes();
    bytes.windows(path.len()).any(|window| window == path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn library_is_found_among_the_messages_of_cargo() {
        let file = format!("/t/release/libstribeck{}", env::consts::DLL_SUFFIX);
        let message = |name: &str| {
            serde_json::json!({
                "reason": "compiler-artifact",
                "target": { "name": name },
                "filenames": ["/t/release/libstribeck.rlib", file],
            })
        };
        assert_eq!(artifact(&message("stribeck")), Some(PathBuf::from(&file)));
        assert_eq!(artifact(&message("libc")), None);
        assert_eq!(artifact(&serde_json::json!({ "reason": "build-finished", "success": true })), None);
    }

    #[test]
    fn flags_of_the_user_are_kept() {
        let remapped = [(PathBuf::from("/here"), "/there")];
        assert_eq!(flags(encoded("").into(), &remapped), "--remap-path-prefix=/here=/there");
        let both = flags(encoded(" -C  target-cpu=native ").into(), &remapped);
        assert_eq!(both, "-C\u{1f}target-cpu=native\u{1f}--remap-path-prefix=/here=/there");
    }

    #[test]
    fn unknown_platforms_are_refused_by_name() {
        assert_eq!(platform("linux", "x86_64").unwrap(), "linux64");
        assert_eq!(platform("linux", "riscv64").unwrap_err().to_string(), "FMI has no platform name for riscv64 linux");
    }
}
