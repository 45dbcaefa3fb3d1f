//! Exports and imports of a shared library, read from its file: ELF, PE or Mach-O.

use std::collections::BTreeSet;

use anyhow::{Context, Result};
use object::macho::LC_CODE_SIGNATURE;
use object::read::macho::{LoadCommandVariant, MachOFile64};
use object::read::{File, ImportFlags, Object};
use object::{Architecture, BinaryFormat, Endianness};

/// Format of a file and its processor.
pub type Machine = (BinaryFormat, Architecture);

/// A shared library as a loader sees it. All names are those of the file, except that the underscore that Mach-O puts
/// before every C name is left out.
#[derive(Debug, PartialEq)]
pub struct Binary {
    /// Format and processor.
    pub machine: Machine,
    /// Functions and data that a host can find by name.
    pub exports: BTreeSet<String>,
    /// Libraries that the loader must find.
    pub libraries: BTreeSet<String>,
    /// Functions and data that these libraries must provide.
    pub imports: BTreeSet<String>,
    /// Versions of the imports, such as `GLIBC_2.14`; only ELF has them.
    pub versions: BTreeSet<String>,
    /// Properties that only Mach-O has.
    pub image: Option<Image>,
}

/// Properties of a Mach-O file that the loader of macOS reads.
#[derive(Debug, Default, PartialEq)]
pub struct Image {
    /// Whether it has a UUID.
    pub has_uuid: bool,
    /// Whether it has a signature, possibly an anonymous one.
    pub is_signed: bool,
    /// Name under which programs linked to it search for it.
    pub name: String,
    /// The oldest macOS that it supports, such as `11.0`.
    pub oldest: String,
}

/// Reads a shared library.
pub fn read(bytes: &[u8]) -> Result<Binary> {
    let file = File::parse(bytes).context("not a shared library of a known format")?;
    let prefix = if matches!(file, File::MachO64(_)) { "_" } else { "" };
    let plain = |name: &[u8]| {
        let name = String::from_utf8_lossy(name).into_owned();
        name.strip_prefix(prefix).map_or(name.clone(), str::to_owned)
    };
    let image = if let File::MachO64(file) = &file { Some(image(file)?) } else { None };
    let mut binary = Binary { image, ..Binary::empty((file.format(), file.architecture())) };
    for export in file.exports()? {
        let export = export?;
        binary.exports.insert(export.name().name().map_or_else(|| "(a number)".into(), plain));
    }
    for library in file.import_libraries()? {
        binary.libraries.insert(String::from_utf8_lossy(library?.name()).into_owned());
    }
    for import in file.imports()? {
        let import = import?;
        binary.imports.insert(import.name().name().map_or_else(|| "(a number)".into(), plain));
        if let ImportFlags::Elf { version: Some(version), .. } = import.flags() {
            binary.versions.insert(String::from_utf8_lossy(version).into_owned());
        }
    }
    Ok(binary)
}

fn image(file: &MachOFile64) -> Result<Image> {
    let endian: Endianness = file.endian();
    let mut image = Image::default();
    let mut commands = file.macho_load_commands()?;
    while let Some(command) = commands.next()? {
        match command.variant()? {
            LoadCommandVariant::Uuid(_) => image.has_uuid = true,
            LoadCommandVariant::LinkeditData(_) if command.cmd() == LC_CODE_SIGNATURE => image.is_signed = true,
            LoadCommandVariant::IdDylib(library) => {
                image.name = String::from_utf8_lossy(command.string(endian, library.dylib.name)?).into_owned();
            }
            LoadCommandVariant::BuildVersion(version, _) => {
                let oldest = version.minos.get(endian);
                image.oldest = format!("{}.{}", oldest.major(), oldest.minor());
            }
            _ => (),
        }
    }
    Ok(image)
}

/// Numbers in the name of a glibc version: `GLIBC_2.2.5` is 2, 2, 5.
pub fn glibc(version: &str) -> Option<Vec<u32>> {
    version.strip_prefix("GLIBC_")?.split('.').map(|part| part.parse().ok()).collect()
}

impl Binary {
    /// A library without exports and imports.
    pub fn empty(machine: Machine) -> Binary {
        let (exports, libraries, imports, versions) = Default::default();
        Binary { machine, exports, libraries, imports, versions, image: None }
    }

    /// The newest glibc that an import requires, such as `2.14`.
    pub fn newest_glibc(&self) -> Option<String> {
        let newest = self.versions.iter().filter_map(|version| glibc(version)).max()?;
        Some(newest.iter().map(u32::to_string).collect::<Vec<_>>().join("."))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_of_glibc_are_ordered_by_number() {
        assert_eq!(glibc("GLIBC_2.2.5"), Some(vec![2, 2, 5]));
        assert!(glibc("GLIBC_2.4") < glibc("GLIBC_2.17"));
        assert_eq!(glibc("GLIBC_PRIVATE"), None);
        let versions = ["GLIBC_2.4", "GLIBC_2.17", "GLIBC_2.2.5", "GCC_3.0"].map(str::to_owned).into();
        let binary = Binary { versions, ..Binary::empty((BinaryFormat::Elf, Architecture::X86_64)) };
        assert_eq!(binary.newest_glibc().as_deref(), Some("2.17"));
    }

    #[test]
    fn other_files_are_refused() {
        assert!(read(b"MZ begins a program for Windows").is_err());
        assert!(read(b"").is_err());
    }

    /// This program itself has the imports of every program on Linux.
    #[cfg(target_os = "linux")]
    #[test]
    fn imports_of_this_program_are_found() {
        let this = read(&std::fs::read(std::env::current_exe().unwrap()).unwrap()).unwrap();
        assert!(this.libraries.contains("libc.so.6"), "{:?}", this.libraries);
        assert!(this.imports.contains("malloc") && !this.exports.contains("malloc"));
        assert!(this.newest_glibc().is_some() && this.image.is_none());
        let (format, processor) = this.machine;
        assert_eq!(format, BinaryFormat::Elf);
        assert_eq!(format!("{processor:?}").to_lowercase(), std::env::consts::ARCH);
    }
}
