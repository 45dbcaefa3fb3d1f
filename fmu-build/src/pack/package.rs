//! The contents of an FMU, and the command that packs them.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use jiff::Timestamp;

use crate::build::crates::Parts;
use crate::build::library::Library;
use crate::describe::entry::Entry;
use crate::describe::fmi2::{self, Choices};
use crate::pack::archive::{Archiver, Files};
use crate::pack::{licenses, sbom};
use crate::page::{html, icon};

/// Contents that the FMUs of one packing share.
pub struct Packing {
    libraries: Vec<Library>,
    parts: Parts,
    licenses: Files,
    date: Timestamp,
    archiver: Archiver,
}

impl Packing {
    /// A packing with these libraries and this date.
    pub fn new(root: &Path, libraries: Vec<Library>, date: Timestamp) -> Result<Packing> {
        let platforms: Vec<_> = libraries.iter().map(|library| library.platform).collect();
        let parts = Parts::of(root, &platforms)?;
        let licenses = licenses::files(root, &parts)?;
        Ok(Packing { libraries, parts, licenses, date, archiver: Archiver::new(date)? })
    }

    /// Names of the platforms that the FMUs run on.
    pub fn platforms(&self) -> Vec<&'static str> {
        self.libraries.iter().map(|library| library.platform.name()).collect()
    }

    /// Writes one FMU and returns its size in bytes.
    pub fn write(&self, entry: &Entry, folder: &Path) -> Result<usize> {
        save(folder, &format!("{}.fmu", entry.model.name), &self.fmu(entry, Choices::Named)?)
    }

    /// The bytes of one FMU.
    pub fn fmu(&self, entry: &Entry, choices: Choices) -> Result<Vec<u8>> {
        self.archiver.zip(&self.contents(entry, choices)?)
    }

    fn contents(&self, entry: &Entry, choices: Choices) -> Result<Files> {
        let Entry { model, family, .. } = *entry;
        let mut files = Files::from([
            ("documentation/index.html".into(), html::page(entry)?.into()),
            (sbom::FILE.into(), sbom::text(model, &self.parts)?.into()),
            ("model.png".into(), icon::png(model, family)?),
            ("modelDescription.xml".into(), fmi2::model_description(model, self.date, choices)?.into()),
        ]);
        files.extend(self.licenses.clone());
        for Library { platform, bytes, .. } in &self.libraries {
            for folder in platform.folders {
                files.insert(format!("binaries/{folder}/{}{}", model.name, platform.suffix), bytes.clone());
            }
        }
        Ok(files)
    }
}

/// Writes a file to a folder, which is created if necessary, and returns the size of the file.
pub fn save(folder: &Path, name: &str, bytes: &[u8]) -> Result<usize> {
    let file = folder.join(name);
    fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
    fs::write(&file, bytes).with_context(|| format!("cannot write {}", file.display()))?;
    Ok(bytes.len())
}

/// Writes only the documentation of one FMU: its page and its icon, in the places they have in the FMU.
pub fn write_page(entry: &Entry, folder: &Path) -> Result<()> {
    let folder = folder.join(entry.model.name);
    let pages = folder.join("documentation");
    fs::create_dir_all(&pages).with_context(|| format!("cannot create {}", pages.display()))?;
    for (file, bytes) in [
        (pages.join("index.html"), html::page(entry)?.into_bytes()),
        (folder.join("model.png"), icon::png(entry.model, entry.family)?),
    ] {
        fs::write(&file, bytes).with_context(|| format!("cannot write {}", file.display()))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::platform::{Choice, platforms};
    use crate::describe::entry::entries;
    use crate::project::{release_date, root};
    use jiff::SignedDuration;

    /// FMUs with libraries of these platforms, which are only copied: their tools are not needed.
    fn packing(choices: &[Choice], date: Timestamp) -> Packing {
        let bytes: Vec<_> = (0..100_000_u32).flat_map(|number| (number / 7).to_le_bytes()).collect();
        let library = |platform| Library { platform, bytes: bytes.clone(), glibc: None };
        let libraries = platforms(choices).unwrap().into_iter().map(library).collect();
        let parts = Parts::of(root(), &platforms(&[Choice::Host]).unwrap()).unwrap();
        let licenses = licenses::files(root(), &parts).unwrap();
        Packing { libraries, parts, licenses, date, archiver: Archiver::new(date).unwrap() }
    }

    fn packed(entry: &Entry, packing: &Packing) -> Vec<u8> {
        let folder = tempfile::tempdir().unwrap();
        let size = packing.write(entry, folder.path()).unwrap();
        let bytes = fs::read(folder.path().join(format!("{}.fmu", entry.model.name))).unwrap();
        assert_eq!(bytes.len(), size);
        bytes
    }

    fn u16_at(bytes: &[u8], at: usize) -> usize {
        usize::from(u16::from_le_bytes([bytes[at], bytes[at + 1]]))
    }

    fn u32_at(bytes: &[u8], at: usize) -> usize {
        u16_at(bytes, at) | u16_at(bytes, at + 2) << 16
    }

    /// Reads an archive according to the specification of the format (PKWARE, APPNOTE 4.3), without the library that
    /// wrote it, and asserts the rules of FMI 2.0.5 section 2.3. Returns the names.
    fn names_by_the_rules(zip: &[u8]) -> Vec<String> {
        let end = zip.len() - 22;
        assert_eq!(&zip[end..end + 4], b"PK\x05\x06", "the archive ends with the end record, without a comment");
        assert_ne!(&zip[end - 20..end - 16], b"PK\x06\x07", "no Zip64");
        let mut names = Vec::new();
        let mut at = u32_at(zip, end + 16);
        for _ in 0..u16_at(zip, end + 10) {
            assert_eq!(&zip[at..at + 4], b"PK\x01\x02");
            let local = u32_at(zip, at + 42);
            assert_eq!(&zip[local..local + 4], b"PK\x03\x04");
            for (header, first) in [(at, at + 6), (local, local + 4)] {
                assert!(u16_at(zip, first) <= 20, "version needed: at most 2.0");
                assert_eq!(u16_at(zip, first + 2), 0, "flags: no encryption, no data descriptor");
                assert!([0, 8].contains(&u16_at(zip, first + 4)), "method: store or deflate");
                let extra = u16_at(zip, if header == at { at + 30 } else { local + 28 });
                assert_eq!(extra, 0, "no extra fields");
            }
            assert_eq!(u16_at(zip, at + 40) >> 12, 0o10, "a regular file, not a symbolic link");
            let name = std::str::from_utf8(&zip[at + 46..at + 46 + u16_at(zip, at + 28)]).unwrap();
            assert!(name.is_ascii() && !name.contains('\\') && !name.contains(".."), "{name}");
            assert!(!name.starts_with(['/', '.']) && !name.ends_with('/'), "{name}");
            names.push(name.to_owned());
            at += 46 + name.len() + u16_at(zip, at + 32);
        }
        names
    }

    #[test]
    fn archives_keep_the_rules_of_the_standard() {
        let packing = packing(&[Choice::Win64], release_date());
        for entry in entries() {
            let names = names_by_the_rules(&packed(&entry, &packing));
            let binary = format!("binaries/win64/{}.dll", entry.model.name);
            let expected = [
                binary.as_str(),
                "documentation/index.html",
                "documentation/licenses/crates.txt",
                "documentation/licenses/license.txt",
                "documentation/licenses/rust.html",
                "documentation/licenses/unicode.txt",
                "documentation/sbom.cdx.json",
                "model.png",
                "modelDescription.xml",
            ];
            assert_eq!(names, expected);
        }
    }

    #[test]
    fn every_platform_has_its_folder_and_arm_has_two() {
        let binaries = |choices: &[Choice]| -> Vec<String> {
            let files = packing(choices, release_date()).contents(&entries()[0], Choices::Named).unwrap();
            files.into_keys().filter(|path| path.starts_with("binaries/")).collect()
        };
        let of = |folder: &str, suffix: &str| format!("binaries/{folder}/{}{suffix}", entries()[0].model.name);
        assert_eq!(
            binaries(&[Choice::Linux64, Choice::Win64, Choice::Darwin64]),
            [of("darwin64", ".dylib"), of("linux64", ".so"), of("win64", ".dll")]
        );
        assert_eq!(binaries(&[Choice::Aarch64Linux]), [of("aarch64-linux", ".so"), of("linux64", ".so")]);
    }

    #[test]
    fn packing_twice_gives_the_same_bytes_and_the_date_is_the_given_one() {
        let entry = &entries()[0];
        let date = release_date();
        let packed = |date| packed(entry, &packing(&[Choice::Win64], date));
        assert_eq!(packed(date), packed(date));
        assert_ne!(packed(date), packed(date + SignedDuration::from_hours(30)));
    }
}
