//! What a shared library offers and needs, read from its file: ELF, PE or Mach-O.

use std::collections::BTreeSet;

use anyhow::{Context, Result};
use object::read::{File, ImportFlags, Object};

/// A shared library as a loader sees it. All names are those of the file, except that the underscore that Mach-O puts
/// before every C name is left out.
#[derive(Debug, Default, PartialEq)]
pub struct Binary {
    /// Functions and data that a host can find by name.
    pub exports: BTreeSet<String>,
    /// Libraries that the loader must find.
    pub libraries: BTreeSet<String>,
    /// Functions and data that these libraries must have.
    pub imports: BTreeSet<String>,
    /// Versions of the imports, such as `GLIBC_2.14`; only ELF has them.
    pub versions: BTreeSet<String>,
    /// Whether it has a Mach-O UUID.
    pub has_uuid: bool,
}

/// Reads a shared library.
pub fn read(bytes: &[u8]) -> Result<Binary> {
    let file = File::parse(bytes).context("no shared library of a known format")?;
    let prefix = if matches!(file, File::MachO64(_)) { "_" } else { "" };
    let plain = |name: &[u8]| {
        let name = String::from_utf8_lossy(name).into_owned();
        name.strip_prefix(prefix).map_or(name.clone(), str::to_owned)
    };
    let mut binary = Binary { has_uuid: file.mach_uuid()?.is_some(), ..Binary::default() };
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

/// The number in the name of a version of glibc: `GLIBC_2.2.5` is 2, 2, 5.
pub fn glibc(version: &str) -> Option<Vec<u32>> {
    version.strip_prefix("GLIBC_")?.split('.').map(|part| part.parse().ok()).collect()
}

impl Binary {
    /// The newest glibc that an import asks for, such as `2.14`.
    pub fn newest_glibc(&self) -> Option<String> {
        let newest = self.versions.iter().filter_map(|version| glibc(version)).max()?;
        Some(newest.iter().map(u32::to_string).collect::<Vec<_>>().join("."))
    }
}
