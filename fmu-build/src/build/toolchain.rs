//! Tools and flags that Rust needs to build a shared library for another platform.

use std::env;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail, ensure};

/// One target of the compiler.
#[derive(Clone, Copy)]
pub struct Target {
    /// Its name in Rust.
    pub triple: &'static str,
    linker: Linker,
}

/// The linker of the library.
#[derive(Clone, Copy)]
enum Linker {
    /// cargo-zigbuild with Zig's linker, which knows the functions of old versions of glibc.
    Zig,
    /// The GNU linker for Windows.
    MinGw,
    /// The linker of the Rust toolchain, with a list of the functions of macOS.
    RustLld,
}

/// A component that a linker adds to a library.
#[derive(Clone, Debug, PartialEq)]
pub struct Addition {
    /// Name.
    pub name: &'static str,
    /// SPDX expression of its licence.
    pub license: &'static str,
    /// The file with its licence.
    pub notices: PathBuf,
}

/// Linux on x86-64.
pub const LINUX_X86_64: Target = Target { triple: "x86_64-unknown-linux-gnu", linker: Linker::Zig };
/// Linux on ARM.
pub const LINUX_AARCH64: Target = Target { triple: "aarch64-unknown-linux-gnu", linker: Linker::Zig };
/// Windows on x86-64.
pub const WINDOWS_X86_64: Target = Target { triple: "x86_64-pc-windows-gnu", linker: Linker::MinGw };
/// macOS on Intel.
pub const MACOS_X86_64: Target = Target { triple: "x86_64-apple-darwin", linker: Linker::RustLld };
/// macOS on Apple's processors.
pub const MACOS_AARCH64: Target = Target { triple: "aarch64-apple-darwin", linker: Linker::RustLld };

/// The oldest glibc that the Linux libraries run with: that of RHEL 7 and manylinux2014.
pub const OLDEST_GLIBC: &str = "2.17";

/// The oldest macOS: the first one on Apple's processors.
pub const OLDEST_MACOS: &str = "11.0";

/// Name of the library for programs linked to it, which search for it in folders of their own choice.
pub const MACOS_NAME: &str = "@rpath/libstribeck.dylib";

/// Names that the library may need from macOS, without the underscore that Mach-O puts before them. No function is
/// among them whose last digit differs from one platform to the next, such as `exp`: linking then fails.
const MACOS_NAMES: &str = include_str!("macos_names.txt");

impl Target {
    /// The tools missing on this machine, each with the command that installs it.
    pub fn missing(self, root: &Path) -> Result<Vec<String>> {
        let mut missing = Vec::new();
        if !has_standard_library(self.triple)? {
            missing.push(format!("Rust's standard library for it: rustup target add {}", self.triple));
        }
        missing.extend(self.linker.missing(root)?);
        Ok(missing)
    }

    /// Additions of its linker to the library.
    pub fn additions(self, root: &Path) -> Result<Vec<Addition>> {
        self.linker.additions(root)
    }

    /// The program to call as cargo.
    pub fn cargo(self) -> OsString {
        if matches!(self.linker, Linker::Zig) { "cargo-zigbuild".into() } else { cargo() }
    }

    /// The target as that program names it.
    pub fn argument(self) -> String {
        match self.linker {
            Linker::Zig => format!("{}.{OLDEST_GLIBC}", self.triple),
            Linker::MinGw | Linker::RustLld => self.triple.into(),
        }
    }

    /// Flags for rustc.
    pub fn flags(self) -> &'static [&'static str] {
        match self.linker {
            Linker::Zig => &[],
            Linker::MinGw => &["-Clink-arg=-Wl,--no-insert-timestamp"],
            // -S omits data for debuggers, including the paths of object files.
            Linker::RustLld => &[
                "-Clinker=rust-lld",
                "-Clinker-flavor=ld64.lld",
                "-Clink-arg=-install_name",
                "-Clink-arg=@rpath/libstribeck.dylib",
                "-Clink-arg=-S",
            ],
        }
    }

    /// Environment of the build. Writes the files that it names to `folder`.
    pub fn environment(self, folder: &Path) -> Result<Vec<(&'static str, OsString)>> {
        if !matches!(self.linker, Linker::RustLld) {
            return Ok(Vec::new());
        }
        let folder = folder.join("macos");
        write_macos_libraries(&folder)?;
        Ok(vec![("SDKROOT", folder.into()), ("MACOSX_DEPLOYMENT_TARGET", OLDEST_MACOS.into())])
    }
}

impl Linker {
    /// Code that unwinds the stack, functions that glibc has in no shared library (fstat64 before version 2.33), and
    /// the start-up code of a library on Windows. The linker for macOS adds nothing: its libraries are lists of names.
    fn additions(self, root: &Path) -> Result<Vec<Addition>> {
        match self {
            Linker::Zig => Ok(of_zig(&zig_folder(root)?)),
            Linker::MinGw => Ok(of_mingw(Path::new("/usr/share/doc"))),
            Linker::RustLld => Ok(Vec::new()),
        }
    }

    fn has_notices(self, root: &Path) -> bool {
        let are_there = |additions: Vec<Addition>| additions.iter().all(|addition| addition.notices.is_file());
        self.additions(root).is_ok_and(are_there)
    }

    fn missing(self, root: &Path) -> Result<Option<String>> {
        Ok(match self {
            Linker::Zig if !runs(root, "cargo-zigbuild", &["zig", "cc", "--", "--version"]) => {
                let python = programs(root).join("python");
                Some(format!("Zig as linker: {} -m pip install cargo-zigbuild ziglang", python.display()))
            }
            Linker::Zig if !self.has_notices(root) => {
                Some("the licences of Zig, which come with the Python package ziglang: install it".into())
            }
            Linker::MinGw if !runs(root, "x86_64-w64-mingw32-gcc", &["--version"]) => {
                Some("the linker for Windows: apt-get install gcc-mingw-w64-x86-64-win32".into())
            }
            Linker::MinGw if !self.has_notices(root) => {
                Some("the licences of MinGW-w64, in /usr/share/doc of Debian and Ubuntu: pack there".into())
            }
            Linker::RustLld if !has_rust_lld()? => {
                Some("rust-lld, which only the Rust of https://rustup.rs includes: install that one".into())
            }
            Linker::Zig | Linker::MinGw | Linker::RustLld => None,
        })
    }
}

fn of_zig(zig: &Path) -> Vec<Addition> {
    // The terms are in the source of each such function, with the exception for programs linked to it.
    let glibc = zig.join("lib").join("libc").join("glibc").join("io").join("fstat64-2.32.c");
    let unwind = zig.join("lib").join("libunwind").join("LICENSE.TXT");
    vec![
        Addition { name: "glibc", license: "LGPL-2.1-or-later WITH GCC-exception-2.0-note", notices: glibc },
        Addition { name: "libunwind", license: "Apache-2.0 WITH LLVM-exception", notices: unwind },
        Addition { name: "zig", license: "MIT", notices: zig.join("LICENSE") },
    ]
}

fn of_mingw(documents: &Path) -> Vec<Addition> {
    let [gcc, mingw] =
        ["gcc-mingw-w64-base", "mingw-w64-x86-64-dev"].map(|package| documents.join(package).join("copyright"));
    vec![
        Addition { name: "libgcc", license: "GPL-3.0-or-later WITH GCC-exception-3.1", notices: gcc },
        Addition { name: "mingw-w64", license: "ZPL-2.1", notices: mingw },
    ]
}

/// Parts that are linked into a program beside its crates: those of the linker for Windows, and the C library of a static
/// program for Linux.
pub fn additions_of_program(root: &Path, triple: &str) -> Result<Vec<Addition>> {
    if triple.ends_with("-windows-gnu") {
        return Linker::MinGw.additions(root);
    }
    if !triple.ends_with("-linux-musl") {
        return Ok(Vec::new());
    }
    let libraries = zig_folder(root).context("the licence of musl comes with the Python package ziglang")?.join("lib");
    Ok(vec![
        Addition {
            name: "libunwind",
            license: "Apache-2.0 WITH LLVM-exception",
            notices: libraries.join("libunwind").join("LICENSE.TXT"),
        },
        Addition { name: "musl", license: "MIT", notices: libraries.join("libc").join("musl").join("COPYRIGHT") },
    ])
}

/// Whether Rust's standard library for a target is here. `rustc` names the folder of any target that it knows; only an
/// installed one has the library in it.
pub fn has_standard_library(triple: &str) -> Result<bool> {
    let folder = stdout(rustc().args(["--print", "target-libdir", "--target", triple]))?;
    let Ok(files) = fs::read_dir(folder.trim()) else { return Ok(false) };
    let names = files.filter_map(|file| Some(file.ok()?.file_name().to_string_lossy().into_owned()));
    Ok(names.into_iter().any(|name| name.starts_with("libstd-") && name.ends_with(".rlib")))
}

/// Runs a command, whose error output goes to the terminal, and returns its standard output.
pub fn stdout(command: &mut Command) -> Result<String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let output = command.stderr(Stdio::inherit()).output().with_context(|| format!("cannot run {name}"))?;
    ensure!(output.status.success(), "{name} failed: {}", output.status);
    Ok(String::from_utf8(output.stdout)?)
}

/// Flags with which a linker finds what the static library needs on a target, as the compiler names them.
pub fn native_libraries(triple: &str) -> Result<Vec<String>> {
    let folder = tempfile::tempdir()?;
    let mut compiler = rustc();
    compiler.args(["--crate-type", "staticlib", "--crate-name", "empty", "--print", "native-static-libs"]);
    compiler.args(["--target", triple, "-", "-o"]).arg(folder.path().join("empty.a")).stdin(Stdio::null());
    let output = compiler.output().context("cannot run rustc")?;
    let text = String::from_utf8(output.stderr)?;
    let flags = text.lines().find_map(|line| Some(line.split_once("native-static-libs:")?.1));
    let flags = flags.with_context(|| format!("rustc names no libraries for {triple}: {text}"))?;
    Ok(flags.split_whitespace().map(str::to_owned).collect())
}

/// Cargo.
pub fn cargo() -> OsString {
    env::var_os("CARGO").unwrap_or("cargo".into())
}

/// The compiler.
pub fn rustc() -> Command {
    Command::new(env::var_os("RUSTC").unwrap_or("rustc".into()))
}

/// Folder of the toolchain.
pub fn sysroot() -> Result<PathBuf> {
    Ok(stdout(rustc().args(["--print", "sysroot"]))?.trim().into())
}

/// Rust's name of this machine.
pub fn host() -> Result<String> {
    of_rustc("host")
}

/// Version of the compiler and of its standard library.
pub fn version() -> Result<String> {
    of_rustc("release")
}

/// A property that the compiler reports.
fn of_rustc(property: &str) -> Result<String> {
    let text = stdout(rustc().args(["--version", "--verbose"]))?;
    let mut properties = text.lines().filter_map(|line| line.split_once(": "));
    let found = properties.find(|(name, _)| *name == property);
    Ok(found.with_context(|| format!("rustc does not report its {property}"))?.1.into())
}

/// A program of the toolchain that is not in the search path.
fn inner_program(name: &str) -> Result<PathBuf> {
    let programs = sysroot()?.join("lib").join("rustlib").join(host()?).join("bin");
    Ok(programs.join(format!("{name}{}", env::consts::EXE_SUFFIX)))
}

fn has_rust_lld() -> Result<bool> {
    // The latter strips the output of the former.
    Ok(inner_program("rust-lld")?.is_file() && inner_program("rust-objcopy")?.is_file())
}

/// A static library without data for debuggers: for Windows, even without any, they name the file that the compiler wrote,
/// and its folder.
pub fn without_debug_data(library: &Path) -> Result<Vec<u8>> {
    let folder = tempfile::tempdir()?;
    let stripped = folder.path().join("stripped.a");
    let mut program = Command::new(inner_program("rust-objcopy")?);
    program.args(["--strip-debug", "--enable-deterministic-archives"]).arg(library).arg(&stripped);
    // It shares LLVM with the compiler.
    let shared = sysroot()?.join("lib");
    stdout(program.env("LD_LIBRARY_PATH", &shared).env("DYLD_LIBRARY_PATH", &shared))?;
    fs::read(&stripped).with_context(|| format!("cannot read {}", stripped.display()))
}

/// Programs of the Python environment that tasks.py creates.
fn programs(root: &Path) -> PathBuf {
    root.join(".venv").join(if cfg!(windows) { "Scripts" } else { "bin" })
}

/// The search path, with the project's own programs first.
pub fn search_path(root: &Path) -> Result<OsString> {
    let given = env::var_os("PATH").unwrap_or_default();
    let folders = std::iter::once(programs(root)).chain(env::split_paths(&given));
    env::join_paths(folders).context("the search path cannot include .venv")
}

/// Folder of Zig, which cargo-zigbuild finds among Python's packages or in the search path.
fn zig_folder(root: &Path) -> Result<PathBuf> {
    let path = search_path(root)?;
    let package = &["-m", "ziglang", "env"][..];
    // On Windows a Python environment has no python3.
    for (program, arguments) in [("python3", package), ("python", package), ("zig", &["env"])] {
        let mut command = Command::new(program);
        let output = command.args(arguments).current_dir(root).env("PATH", &path).stderr(Stdio::null()).output();
        let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned()).unwrap_or_default();
        if let Some(folder) = text.lines().find_map(folder_of_zig) {
            return Ok(root.join(folder));
        }
    }
    bail!("`zig env` does not report the folder with the licences of Zig's additions to a library")
}

/// The parent folder of the one in the line `.lib_dir = "..."` of `zig env`; older versions write JSON.
fn folder_of_zig(line: &str) -> Option<PathBuf> {
    let (name, rest) = line.split_once([':', '='])?;
    let path = rest.trim().strip_prefix('"')?.split('"').next()?;
    let is_it = name.trim().trim_matches(['.', '"']) == "lib_dir";
    Path::new(path).parent().filter(|_| is_it).map(Path::to_owned)
}

fn runs(root: &Path, program: &str, arguments: &[&str]) -> bool {
    let Ok(path) = search_path(root) else { return false };
    let mut command = Command::new(program);
    command.args(arguments).env("PATH", path).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

/// Writes text-based libraries, which list the functions of macOS for the linker. Rust requires all four, but the
/// library needs only the first one: on macOS two others are parts of it, and no function of the last one is called.
fn write_macos_libraries(folder: &Path) -> Result<()> {
    let libraries = folder.join("usr").join("lib");
    fs::create_dir_all(&libraries).with_context(|| format!("cannot create {}", libraries.display()))?;
    for name in ["libSystem.tbd", "libc.tbd", "libm.tbd", "libiconv.tbd"] {
        let file = libraries.join(name);
        fs::write(&file, macos_library()).with_context(|| format!("cannot write {}", file.display()))?;
    }
    Ok(())
}

fn macos_library() -> String {
    let names: Vec<_> = MACOS_NAMES.split_whitespace().map(|name| format!("_{name}")).collect();
    format!(
        "--- !tapi-tbd\n\
        tbd-version: 4\n\
        targets: [ x86_64-macos, arm64-macos ]\n\
        install-name: '/usr/lib/libSystem.B.dylib'\n\
        exports:\n\
        \x20 - targets: [ x86_64-macos, arm64-macos ]\n\
        \x20   symbols: [ dyld_stub_binder, {} ]\n\
        ...\n",
        names.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folder_of_zig_is_found_in_both_forms_of_the_output() {
        let folder = Some(PathBuf::from("/opt/zig"));
        assert_eq!(folder_of_zig("    .lib_dir = \"/opt/zig/lib\","), folder);
        assert_eq!(folder_of_zig(" \"lib_dir\": \"/opt/zig/lib\","), folder);
        assert_eq!(folder_of_zig("    .std_dir = \"/opt/zig/lib/std\","), None);
        assert_eq!(folder_of_zig("    .env = .{"), None);
    }

    #[test]
    fn linkers_name_their_additions_and_that_for_macos_has_none() {
        assert_eq!(MACOS_X86_64.additions(Path::new("/")).unwrap(), []);
        let names: Vec<_> = WINDOWS_X86_64.additions(Path::new("/")).unwrap().iter().map(|one| one.name).collect();
        assert_eq!(names, ["libgcc", "mingw-w64"]);
    }
}
