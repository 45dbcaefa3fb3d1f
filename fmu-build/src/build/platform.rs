//! The platforms for which an FMU can have a library: its build tools, its place in the FMU, and its permitted imports.

use std::collections::BTreeSet;
use std::env;

use anyhow::{Result, bail, ensure};
use clap::ValueEnum;
use object::{Architecture, BinaryFormat};

use crate::build::binary::{self, Binary, Image, Machine};
use crate::build::toolchain::{
    self, LINUX_AARCH64, LINUX_X86_64, MACOS_AARCH64, MACOS_NAME, MACOS_X86_64, OLDEST_GLIBC, OLDEST_MACOS, Target,
    WINDOWS_X86_64,
};

/// Choices on the command line.
#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
pub enum Choice {
    /// This machine, built with its own tools.
    Host,
    /// Linux on x86-64, with glibc 2.17 or newer.
    Linux64,
    /// Windows on x86-64.
    Win64,
    /// macOS 11 or newer, on Intel's and on Apple's processors.
    Darwin64,
    /// Linux on ARM, with glibc 2.17 or newer; its FMUs go to a separate folder.
    Aarch64Linux,
    /// All of them except host.
    All,
}

/// A platform to build for.
#[derive(Clone, Copy)]
pub struct Platform {
    /// Folders of the library in an FMU, of which the first is the name of the platform.
    pub folders: &'static [&'static str],
    /// Folders of the library in an FMU of FMI 3.0, which are named after processor and system.
    pub tuples: &'static [&'static str],
    /// Ending of the library's name, with the dot.
    pub suffix: &'static str,
    /// Targets of the compiler; none if the library is built for this machine.
    pub targets: &'static [Target],
    /// Formats and processors of the parts of its library; only macOS loads a file with several parts.
    machines: &'static [Machine],
    /// Libraries that it may need, in lower case: those that every such system has. That of mathematical functions is not
    /// among them, because their last digit differs from one platform to the next.
    libraries: &'static [&'static str],
}

const LINUX64: Platform = Platform {
    folders: &["linux64"],
    tuples: &["x86_64-linux"],
    suffix: ".so",
    targets: &[LINUX_X86_64],
    machines: &[(BinaryFormat::Elf, Architecture::X86_64)],
    libraries: &["libc.so.6", "libdl.so.2", "libpthread.so.0", "librt.so.1", "ld-linux-x86-64.so.2"],
};

/// FMI 2.0 has no folder for Linux on ARM. Importers there look in that for x86-64, as fmpy 0.3.32 does; the first
/// folder is that of FMI 3.0.
const AARCH64_LINUX: Platform = Platform {
    folders: &["aarch64-linux", "linux64"],
    tuples: &["aarch64-linux"],
    suffix: ".so",
    targets: &[LINUX_AARCH64],
    machines: &[(BinaryFormat::Elf, Architecture::Aarch64)],
    libraries: &["libc.so.6", "libdl.so.2", "libpthread.so.0", "librt.so.1", "ld-linux-aarch64.so.1"],
};

const WIN64: Platform = Platform {
    folders: &["win64"],
    tuples: &["x86_64-windows"],
    suffix: ".dll",
    targets: &[WINDOWS_X86_64],
    machines: &[(BinaryFormat::Pe, Architecture::X86_64)],
    // wine 8 has these too; it lacks bcryptprimitives.dll, which Rust needs for random numbers.
    libraries: &["api-ms-win-core-synch-l1-2-0.dll", "kernel32.dll", "msvcrt.dll", "ntdll.dll"],
};

const DARWIN64: Platform = Platform {
    folders: &["darwin64"],
    tuples: &["x86_64-darwin", "aarch64-darwin"],
    suffix: ".dylib",
    targets: &[MACOS_X86_64, MACOS_AARCH64],
    machines: &[(BinaryFormat::MachO, Architecture::X86_64), (BinaryFormat::MachO, Architecture::Aarch64)],
    libraries: &["/usr/lib/libsystem.b.dylib"],
};

/// The platforms of these choices, each once. A platform requested by name is not also built with this machine's own
/// tools.
pub fn platforms(choices: &[Choice]) -> Result<Vec<Platform>> {
    let mut platforms: Vec<Platform> = Vec::new();
    for choice in choices {
        platforms.extend(match choice {
            Choice::Host => &[][..],
            Choice::Linux64 => &[LINUX64],
            Choice::Win64 => &[WIN64],
            Choice::Darwin64 => &[DARWIN64],
            Choice::Aarch64Linux => &[AARCH64_LINUX],
            Choice::All => &[LINUX64, WIN64, DARWIN64, AARCH64_LINUX],
        });
    }
    if choices.contains(&Choice::Host) {
        platforms.push(host(env::consts::OS, env::consts::ARCH)?);
    }
    let mut names = BTreeSet::new();
    platforms.retain(|platform| names.insert(platform.name()));
    Ok(platforms)
}

/// This machine.
fn host(os: &str, architecture: &str) -> Result<Platform> {
    let platform = match (os, architecture) {
        ("linux", "x86_64") => LINUX64,
        ("linux", "x86") => {
            let machines = &[(BinaryFormat::Elf, Architecture::I386)];
            Platform { folders: &["linux32"], tuples: &["x86-linux"], machines, ..LINUX64 }
        }
        ("linux", "aarch64") => AARCH64_LINUX,
        ("windows", "x86_64") => WIN64,
        ("windows", "x86") => {
            let machines = &[(BinaryFormat::Pe, Architecture::I386)];
            Platform { folders: &["win32"], tuples: &["x86-windows"], machines, ..WIN64 }
        }
        ("macos", "x86_64") => {
            let machines = &[(BinaryFormat::MachO, Architecture::X86_64)];
            Platform { tuples: &["x86_64-darwin"], machines, ..DARWIN64 }
        }
        ("macos", "aarch64") => {
            let machines = &[(BinaryFormat::MachO, Architecture::Aarch64)];
            Platform { tuples: &["aarch64-darwin"], machines, ..DARWIN64 }
        }
        _ => bail!("FMI has no platform name for {architecture} {os}"),
    };
    Ok(Platform { targets: &[], ..platform })
}

impl Platform {
    /// Its name.
    pub fn name(&self) -> &'static str {
        self.folders[0]
    }

    /// Whether this machine builds the library for itself; it then runs here, but possibly not on older systems.
    pub fn is_host(&self) -> bool {
        self.targets.is_empty()
    }

    /// Rust's names of the targets of its library.
    pub fn triples(&self) -> Result<Vec<String>> {
        match self.is_host() {
            true => Ok(vec![toolchain::host()?]),
            false => Ok(self.targets.iter().map(|target| target.triple.to_owned()).collect()),
        }
    }

    /// Subfolder of its FMUs; none if they share a file with the others. Two processors cannot share `linux64`.
    pub fn subfolder(&self) -> &'static str {
        let is_shared = self.is_host() || self.folders.len() == 1;
        if is_shared { "" } else { self.name() }
    }

    /// Rejects a library unless it has one part for each of its processors, in the format of its loader.
    pub fn check_machines(&self, parts: &[Binary]) -> Result<()> {
        let found: Vec<_> = parts.iter().map(|part| part.machine).collect();
        let is_it = found.len() == self.machines.len() && self.machines.iter().all(|machine| found.contains(machine));
        ensure!(is_it, "{}: is {}, not {}", self.name(), listed(&found), listed(self.machines));
        Ok(())
    }

    /// Rejects a library that some importer on such a system cannot load.
    pub fn check(&self, binary: &Binary, exports: &[String]) -> Result<()> {
        let name = self.name();
        let extra: Vec<_> = binary.exports.iter().filter(|export| !exports.contains(export)).collect();
        ensure!(extra.is_empty(), "{name}: exports {extra:?}, which neither include/stribeck.h nor FMI 3.0 declares");
        let lost: Vec<_> = exports.iter().filter(|export| !binary.exports.contains(*export)).collect();
        ensure!(lost.is_empty(), "{name}: does not export {lost:?} of include/stribeck.h or FMI 3.0");
        if self.is_host() { Ok(()) } else { self.check_portable(binary) }
    }

    /// Checks that a library needs nothing that an older system lacks.
    fn check_portable(&self, binary: &Binary) -> Result<()> {
        let name = self.name();
        for library in &binary.libraries {
            let is_known = self.libraries.contains(&library.to_lowercase().as_str());
            ensure!(is_known, "{name}: needs {library}, which not every system has");
        }
        let oldest = binary::glibc(&format!("GLIBC_{OLDEST_GLIBC}"));
        for version in &binary.versions {
            let is_old = binary::glibc(version).is_some_and(|version| Some(version) <= oldest);
            ensure!(is_old, "{name}: needs {version}, which is newer than glibc {OLDEST_GLIBC}");
        }
        if let Some(image) = &binary.image {
            self.check_image(image, binary.machine.1)?;
        }
        Ok(())
    }

    fn check_image(&self, image: &Image, processor: Architecture) -> Result<()> {
        let name = self.name();
        ensure!(image.name == MACOS_NAME, "{name}: is called {}, not {MACOS_NAME}", image.name);
        ensure!(image.oldest == OLDEST_MACOS, "{name}: is for macOS {} or newer, not {OLDEST_MACOS}", image.oldest);
        // The loader of macOS 26 refuses a library without one.
        ensure!(image.has_uuid, "{name}: has no UUID");
        let must_be_signed = processor == Architecture::Aarch64;
        ensure!(image.is_signed || !must_be_signed, "{name}: is not signed, which Apple's processors require");
        Ok(())
    }
}

fn listed(machines: &[Machine]) -> String {
    let names: Vec<_> = machines.iter().map(|(format, processor)| format!("{format:?} for {processor:?}")).collect();
    names.join(" and ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(choices: &[Choice]) -> Vec<&'static str> {
        platforms(choices).unwrap().iter().map(Platform::name).collect()
    }

    #[test]
    fn choices_name_each_platform_once() {
        assert_eq!(names(&[Choice::All]), ["linux64", "win64", "darwin64", "aarch64-linux"]);
        assert_eq!(names(&[Choice::Win64, Choice::All, Choice::Host]).len(), 4);
        assert_eq!(names(&[Choice::Host]).len(), 1);
    }

    #[test]
    fn named_platforms_are_built_for_old_systems_and_the_host_for_itself() {
        assert!(platforms(&[Choice::Host]).unwrap()[0].is_host());
        assert!(!platforms(&[Choice::Host, Choice::All]).unwrap().iter().any(Platform::is_host));
    }

    #[test]
    fn unknown_machines_are_refused_by_name() {
        assert_eq!(host("linux", "x86_64").unwrap().name(), "linux64");
        let error = host("linux", "riscv64").err().unwrap().to_string();
        assert_eq!(error, "FMI has no platform name for riscv64 linux");
    }

    #[test]
    fn folders_of_fmi_3_are_those_of_the_standard() {
        let tuples: Vec<_> = platforms(&[Choice::All]).unwrap().iter().flat_map(|platform| platform.tuples).collect();
        let known = ["x86_64-linux", "x86_64-windows", "x86_64-darwin", "aarch64-darwin", "aarch64-linux"];
        assert_eq!(tuples, known.iter().collect::<Vec<_>>());
        assert_eq!(host("macos", "aarch64").unwrap().tuples, ["aarch64-darwin"]);
    }

    #[test]
    fn only_the_fmus_for_arm_linux_are_separate_files() {
        let all = platforms(&[Choice::All]).unwrap();
        let folders: Vec<_> = all.iter().map(Platform::subfolder).collect();
        assert_eq!(folders, ["", "", "", "aarch64-linux"]);
        assert_eq!(host("linux", "aarch64").unwrap().subfolder(), "");
    }

    /// A library that Linux on x86-64 can load, with one thing changed.
    fn refusal(platform: Platform, change: impl FnOnce(&mut Binary)) -> Option<String> {
        let set = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect();
        let mut binary = Binary {
            machine: *platform.machines.last().unwrap(),
            exports: set(&["fmi2DoStep"]),
            libraries: set(&[platform.libraries[0]]),
            imports: set(&["exp"]),
            versions: set(&["GLIBC_2.2.5", "GLIBC_2.17"]),
            image: (platform.suffix == ".dylib").then(|| Image {
                has_uuid: true,
                is_signed: true,
                name: MACOS_NAME.into(),
                oldest: OLDEST_MACOS.into(),
            }),
        };
        change(&mut binary);
        platform.check(&binary, &["fmi2DoStep".into()]).err().map(|error| error.to_string())
    }

    #[test]
    fn libraries_that_load_everywhere_pass() {
        for platform in platforms(&[Choice::All]).unwrap() {
            assert_eq!(refusal(platform, |_| {}), None, "{}", platform.name());
        }
        assert_eq!(
            refusal(WIN64, |binary| {
                binary.libraries.insert("KERNEL32.dll".into());
            }),
            None
        );
    }

    #[test]
    fn exports_must_be_those_of_the_header() {
        let lost = refusal(LINUX64, |binary| binary.exports.clear()).unwrap();
        assert!(lost.contains("does not export [\"fmi2DoStep\"]"), "{lost}");
        let extra = refusal(WIN64, |binary| {
            binary.exports.insert("rust_eh_personality".into());
        })
        .unwrap();
        assert!(extra.contains("exports [\"rust_eh_personality\"]"), "{extra}");
    }

    #[test]
    fn imports_that_some_systems_lack_are_rejected() {
        for (platform, library) in [
            (LINUX64, "libgcc_s.so.1"),
            (AARCH64_LINUX, "ld-linux-x86-64.so.2"),
            (WIN64, "libgcc_s_seh-1.dll"),
            (WIN64, "VCRUNTIME140.dll"),
            (WIN64, "bcryptprimitives.dll"),
            (DARWIN64, "/usr/lib/libiconv.2.dylib"),
        ] {
            let refused = refusal(platform, |binary| {
                binary.libraries.insert(library.into());
            });
            assert!(refused.unwrap().contains(&format!("needs {library}")));
            let host = Platform { targets: &[], ..platform };
            assert_eq!(
                refusal(host, |binary| {
                    binary.libraries.insert(library.into());
                }),
                None
            );
        }
        for version in ["GLIBC_2.18", "GLIBC_2.33", "GLIBC_3.0", "GLIBC_PRIVATE", "GCC_3.0"] {
            let refused = refusal(LINUX64, |binary| {
                binary.versions.insert(version.into());
            });
            assert!(refused.unwrap().contains(&format!("needs {version}")));
        }
    }

    #[test]
    fn images_that_macos_would_not_load_are_rejected() {
        let refused = |change: fn(&mut Image)| {
            let change = |binary: &mut Binary| change(binary.image.as_mut().unwrap());
            refusal(DARWIN64, change)
        };
        assert!(refused(|image| image.has_uuid = false).unwrap().contains("has no UUID"));
        assert!(refused(|image| image.is_signed = false).unwrap().contains("is not signed"));
        assert!(refused(|image| image.oldest = "15.0".into()).unwrap().contains("for macOS 15.0"));
        assert!(refused(|image| image.name = "/home/lib.dylib".into()).unwrap().contains("called /home/lib.dylib"));
        let unsigned_for_intel = |binary: &mut Binary| {
            binary.machine.1 = Architecture::X86_64;
            binary.image.as_mut().unwrap().is_signed = false;
        };
        assert_eq!(refusal(DARWIN64, unsigned_for_intel), None);
    }

    #[test]
    fn libraries_in_another_format_or_for_other_processors_are_refused() {
        let check = |platform: Platform, machines: &[Machine]| {
            let parts: Vec<_> = machines.iter().map(|machine| Binary::empty(*machine)).collect();
            platform.check_machines(&parts).err().map(|error| error.to_string())
        };
        let all = platforms(&[Choice::All]).unwrap();
        for platform in &all {
            for other in &all {
                assert_eq!(check(*platform, other.machines).is_none(), platform.name() == other.name());
            }
        }
        let [intel, apple] = DARWIN64.machines else { panic!("two processors") };
        assert_eq!(check(DARWIN64, &[*apple, *intel]), None);
        let refused = check(DARWIN64, &[*intel, *intel]).unwrap();
        assert_eq!(
            refused,
            "darwin64: is MachO for X86_64 and MachO for X86_64, not MachO for X86_64 and MachO for Aarch64"
        );
        assert_eq!(check(host("macos", "aarch64").unwrap(), &[*apple]), None);
        assert!(check(host("macos", "aarch64").unwrap(), &[*intel]).is_some());
        assert!(check(host("linux", "x86").unwrap(), LINUX64.machines).is_some());
    }
}
