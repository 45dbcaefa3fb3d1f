//! The contents of an FMU, and the command that packs them.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use jiff::Timestamp;

use crate::build::crates::Parts;
use crate::build::library::Library;
use crate::build::platform::{self, Choice};
use crate::describe::entry::Entry;
use crate::describe::fmi2::{self, Choices};
use crate::describe::fmi3;
use crate::describe::interface::Version;
use crate::describe::only_law::OnlyLaw;
use crate::describe::terminals;
use crate::pack::archive::{Archiver, Files};
use crate::pack::sbom::{self, Product};
use crate::pack::{licenses, related};
use crate::page::{html, icon};
use crate::sources::Sources;

/// A form in which a model is packed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// For FMI 2.0.
    Two(Choices),
    /// For FMI 3.0.
    Three,
}

impl Form {
    /// The version of FMI.
    pub fn version(self) -> Version {
        match self {
            Form::Two(_) => Version::Two,
            Form::Three => Version::Three,
        }
    }

    /// The folder of the FMUs beside those of FMI 2.0: an FMU is named after its model in every form, and tools name
    /// instances after the file.
    pub fn subfolder(self) -> &'static str {
        match self {
            Form::Two(Choices::Plain) => "plain",
            Form::Two(_) => "",
            Form::Three => "fmi3",
        }
    }
}

/// Contents that all FMUs of a model share.
pub struct Contents<'a> {
    entry: &'a Entry,
    /// The only law of C sources.
    law: Option<OnlyLaw>,
    page: html::Page,
    icon: Vec<u8>,
    related: Files,
}

impl Contents<'_> {
    /// Page, icon, presets and results of a model.
    pub fn of(entry: &Entry) -> Result<Contents<'_>> {
        Contents::with_law(entry, None)
    }

    /// The same for C sources with this law, if the model has a choice: the results are those of this law.
    pub fn with_law(entry: &Entry, law: Option<OnlyLaw>) -> Result<Contents<'_>> {
        let (page, icon) = (html::Page::of(entry)?, icon::png(entry.model, entry.family)?);
        Ok(Contents { entry, law, page, icon, related: related::files(entry, law)? })
    }

    /// The files of an FMU that do not depend on its platforms.
    fn files(&self, form: Form, date: Timestamp) -> Result<Files> {
        let (model, version) = (self.entry.model, form.version());
        let description = match form {
            Form::Two(choices) => fmi2::model_description(model, date, choices)?,
            Form::Three => fmi3::model_description(model, date)?,
        };
        let icon = match version {
            Version::Two => "model.png",
            Version::Three => terminals::ICON,
        };
        let mut files = self.related.clone();
        files.insert("documentation/index.html".into(), self.page.text(version)?.into());
        files.insert("modelDescription.xml".into(), description.into());
        files.insert(icon.into(), self.icon.clone());
        files.extend(terminals::text(model, version)?.map(|text| (terminals::FILE.into(), text.into())));
        if version == Version::Three && terminals::has_maps(model)? {
            files.extend([related::manifest_of_tables()?]);
        }
        Ok(files)
    }
}

/// Contents that the FMUs of one packing share.
pub struct Packing<'a> {
    libraries: Vec<&'a Library>,
    parts: Parts,
    licenses: Files,
    date: Timestamp,
    archiver: &'a Archiver,
}

impl Packing<'_> {
    /// A packing with these libraries and this date.
    pub fn new<'a>(
        root: &Path,
        libraries: Vec<&'a Library>,
        date: Timestamp,
        archiver: &'a Archiver,
    ) -> Result<Packing<'a>> {
        let platforms: Vec<_> = libraries.iter().map(|library| library.platform).collect();
        let parts = Parts::of(root, &platforms)?;
        let licenses = licenses::files(root, &parts)?;
        Ok(Packing { libraries, parts, licenses, date, archiver })
    }

    /// A packing of C sources: their parts are those of the library for this machine, but nothing is added by a linker.
    pub fn of_sources<'a>(root: &Path, date: Timestamp, archiver: &'a Archiver) -> Result<Packing<'a>> {
        let parts = Parts::of(root, &platform::platforms(&[Choice::Host])?)?;
        let parts = Parts { additions: Vec::new(), ..parts };
        let licenses = licenses::files(root, &parts)?;
        Ok(Packing { libraries: Vec::new(), parts, licenses, date, archiver })
    }

    /// Names of the platforms that the FMUs run on.
    pub fn platforms(&self) -> Vec<&'static str> {
        self.libraries.iter().map(|library| library.platform.name()).collect()
    }

    /// Writes one FMU and returns its size in bytes.
    pub fn write(&self, contents: &Contents, form: Form, folder: &Path) -> Result<usize> {
        save(folder, &format!("{}.fmu", contents.entry.model.name), &self.fmu(contents, form)?)
    }

    /// Writes an FMU that has C sources in place of libraries, and returns its size in bytes.
    pub fn write_sources(&self, contents: &Contents, form: Form, sources: &Sources, folder: &Path) -> Result<usize> {
        let model = contents.entry.model;
        let names: Vec<&str> = sources.files.keys().map(String::as_str).collect();
        let mut files = self.files(contents, form)?;
        let description = match form.version() {
            Version::Two => fmi2::source_description(model, self.date, &names, contents.law)?,
            Version::Three => {
                files.insert("sources/buildDescription.xml".into(), fmi3::build_description(model, &names)?.into());
                fmi3::source_description(model, self.date, contents.law)?
            }
        };
        files.insert("modelDescription.xml".into(), description.into());
        let texts = sources.files.iter().map(|(name, text)| (format!("sources/{name}"), text.clone().into()));
        files.extend(texts);
        save(folder, &format!("{}.fmu", model.name), &self.archiver.zip(&files)?)
    }

    /// The bytes of one FMU.
    pub fn fmu(&self, contents: &Contents, form: Form) -> Result<Vec<u8>> {
        self.archiver.zip(&self.files(contents, form)?)
    }

    fn files(&self, contents: &Contents, form: Form) -> Result<Files> {
        let model = contents.entry.model;
        let mut files = contents.files(form, self.date)?;
        let product = Product { file: format!("{}.fmu", model.name), name: model.name, summary: model.summary };
        files.insert(format!("documentation/{}", sbom::FILE), sbom::text(&product, &self.parts)?.into());
        files.extend(licenses::below("documentation", &self.licenses));
        for Library { platform, bytes, .. } in &self.libraries {
            let folders = if form == Form::Three { platform.tuples } else { platform.folders };
            for folder in folders {
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

/// Writes files, by their paths, below a folder.
pub fn save_all(folder: &Path, files: &Files) -> Result<()> {
    for (path, bytes) in files {
        let (below, name) = path.rsplit_once('/').unwrap_or(("", path));
        save(&folder.join(below), name, bytes)?;
    }
    Ok(())
}

/// Writes only the documentation of one FMU: its page and its icon, in the places they have in the FMU.
pub fn write_page(entry: &Entry, folder: &Path) -> Result<()> {
    let folder = folder.join(entry.model.name);
    let pages = folder.join("documentation");
    fs::create_dir_all(&pages).with_context(|| format!("cannot create {}", pages.display()))?;
    for (file, bytes) in [
        (pages.join("index.html"), html::Page::of(entry)?.text(Version::Two)?.into_bytes()),
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

    /// Libraries of these platforms, which are only copied: their tools are not needed.
    fn libraries(choices: &[Choice]) -> Vec<Library> {
        let bytes: Vec<_> = (0..100_000_u32).flat_map(|number| (number / 7).to_le_bytes()).collect();
        let library = |platform| Library { platform, bytes: bytes.clone(), glibc: None, beside: Vec::new() };
        platforms(choices).unwrap().into_iter().map(library).collect()
    }

    fn packing<'a>(libraries: &'a [Library], date: Timestamp, archiver: &'a Archiver) -> Packing<'a> {
        let parts = Parts::of(root(), &platforms(&[Choice::Host]).unwrap()).unwrap();
        let licenses = licenses::files(root(), &parts).unwrap();
        Packing { libraries: libraries.iter().collect(), parts, licenses, date, archiver }
    }

    fn packed(contents: &Contents, form: Form, packing: &Packing) -> Vec<u8> {
        let folder = tempfile::tempdir().unwrap();
        let size = packing.write(contents, form, folder.path()).unwrap();
        let bytes = fs::read(folder.path().join(format!("{}.fmu", contents.entry.model.name))).unwrap();
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
        let (libraries, archiver) = (libraries(&[Choice::Win64]), Archiver::new(release_date()).unwrap());
        let packing = packing(&libraries, release_date(), &archiver);
        for entry in entries() {
            let contents = Contents::of(&entry).unwrap();
            for (form, folder) in [(Form::Two(Choices::Named), "win64"), (Form::Three, "x86_64-windows")] {
                let mut names = names_by_the_rules(&packed(&contents, form, &packing));
                names.retain(|name| !name.starts_with("extra/") && !name.starts_with("terminalsAndIcons/"));
                let binary = format!("binaries/{folder}/{}.dll", entry.model.name);
                let mut expected = vec![
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
                expected.retain(|name| *name != "model.png" || form != Form::Three);
                assert_eq!(names, expected);
            }
        }
    }

    #[test]
    fn terminals_icons_and_related_files_are_where_each_version_looks_for_them() {
        let entry = entries().into_iter().find(|entry| entry.model.name == "HydraulicDamper").unwrap();
        let contents = Contents::of(&entry).unwrap();
        let beside = |form| -> Vec<String> {
            let files = contents.files(form, release_date()).unwrap();
            files.into_keys().filter(|name| name.starts_with("extra/") || name.starts_with("terminals")).collect()
        };
        let results = [
            "extra/org.fmi-standard.fmi-ls-ref/HydraulicDamper_in.csv",
            "extra/org.fmi-standard.fmi-ls-ref/HydraulicDamper_out.csv",
            "extra/org.fmi-standard.fmi-ls-ref/fmi-ls-manifest.xml",
        ];
        assert_eq!(beside(Form::Two(Choices::Named)), results);
        let tables = ["extra/org.fmi-standard.fmi-ls-struct/fmi-ls-manifest.xml", terminals::ICON, terminals::FILE];
        assert_eq!(beside(Form::Three), [&results[..], &tables].concat());
    }

    #[test]
    fn every_platform_has_its_folder_and_arm_has_two() {
        let archiver = Archiver::new(release_date()).unwrap();
        let entries = entries();
        let contents = Contents::of(&entries[0]).unwrap();
        let binaries = |choices: &[Choice], form: Form| -> Vec<String> {
            let libraries = libraries(choices);
            let files = packing(&libraries, release_date(), &archiver).files(&contents, form).unwrap();
            files.into_keys().filter(|path| path.starts_with("binaries/")).collect()
        };
        let of = |folder: &str, suffix: &str| format!("binaries/{folder}/{}{suffix}", entries[0].model.name);
        let two = Form::Two(Choices::Named);
        assert_eq!(
            binaries(&[Choice::Linux64, Choice::Win64, Choice::Darwin64], two),
            [of("darwin64", ".dylib"), of("linux64", ".so"), of("win64", ".dll")]
        );
        assert_eq!(binaries(&[Choice::Aarch64Linux], two), [of("aarch64-linux", ".so"), of("linux64", ".so")]);
        assert_eq!(
            binaries(&[Choice::All], Form::Three),
            [
                of("aarch64-darwin", ".dylib"),
                of("aarch64-linux", ".so"),
                of("x86_64-darwin", ".dylib"),
                of("x86_64-linux", ".so"),
                of("x86_64-windows", ".dll")
            ]
        );
    }

    #[test]
    fn packing_twice_gives_the_same_bytes_and_the_date_is_the_given_one() {
        let (entries, libraries) = (entries(), libraries(&[Choice::Win64]));
        let contents = Contents::of(&entries[0]).unwrap();
        let date = release_date();
        let packed = |date| {
            let archiver = Archiver::new(date).unwrap();
            packed(&contents, Form::Two(Choices::Named), &packing(&libraries, date, &archiver))
        };
        assert_eq!(packed(date), packed(date));
        assert_ne!(packed(date), packed(date + SignedDuration::from_hours(30)));
    }
}
