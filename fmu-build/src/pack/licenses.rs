//! The licences of all parts of the library, as files beside it, in an FMU or elsewhere. Every text is a file of its
//! owner: this project, a crate, or the Rust toolchain.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};

use crate::build::crates::{Crate, Parts};
use crate::build::toolchain::{self, Addition};
use crate::pack::archive::Files;

const FOLDER: &str = "licenses";

/// Beginnings of the names of files that hold a licence, or notices that a licence requires to be passed on.
const BEGINNINGS: [&str; 6] = ["LICENSE", "LICENCE", "COPYING", "COPYRIGHT", "NOTICE", "UNLICENSE"];

/// Crates of the workbench whose archives lack the text of the licence that their manifests name, MIT: the solvers that
/// the program compares with, what these need, and the types of the page. Any other crate must bring its own.
const WITHOUT_TEXT: [&str; 13] = [
    "diffsol",
    "diffsol-la",
    "diffsol-nl",
    "equator",
    "faer-traits",
    "nano-gemm",
    "nano-gemm-c32",
    "nano-gemm-c64",
    "nano-gemm-core",
    "nano-gemm-f32",
    "nano-gemm-f64",
    "pulp-wasm-simd-flag",
    "ts-rs",
];

/// Crates that are part of the standard library of Rust 1.95 but not of its notices. Their licences are those in their
/// manifests at crates.io.
const UNNAMED_BY_RUST: &str = "\
rust.html may leave out these crates of the standard library: addr2line, adler2, miniz_oxide and object, which are
used under the Apache License below, and memchr, which is in the public domain (Unlicense).";

/// The folder `licenses`, whose entry the standard of FMI calls `license.txt` (FMI 2.0.5, section 2.3).
pub fn files(root: &Path, parts: &Parts) -> Result<Files> {
    let mut files = Files::from([
        (format!("{FOLDER}/license.txt"), entry(root, &parts.additions)?.into()),
        (format!("{FOLDER}/crates.txt"), of_crates(root, &parts.crates)?.into()),
        (format!("{FOLDER}/rust.html"), of_standard_library("COPYRIGHT-library.html")?),
        (format!("{FOLDER}/unicode.txt"), of_standard_library("licenses/Unicode-3.0.txt")?),
    ]);
    for Addition { name, notices, .. } in &parts.additions {
        files.insert(format!("{FOLDER}/{name}.txt"), read(notices)?.into());
    }
    Ok(files)
}

/// The files below a folder.
pub fn below(folder: &str, files: &Files) -> Files {
    files.iter().map(|(path, bytes)| (format!("{folder}/{path}"), bytes.clone())).collect()
}

/// Explanation of the other files, and both licences of this project.
fn entry(root: &Path, additions: &[Addition]) -> Result<String> {
    let rule = "-".repeat(80);
    let line =
        |addition: &Addition| format!("{0}.txt: {0}, which the linker adds, {1}\n", addition.name, addition.license);
    let additions: String = additions.iter().map(line).collect();
    Ok(format!(
        "Stribeck is licensed under the MIT licence or the Apache License 2.0, at your option.\n\n\
         It contains third-party code: the crates in crates.txt, each with its licence, and parts of\n\
         Rust's standard library, with the notices in rust.html and, for its tables of characters, the licence\n\
         of Unicode in unicode.txt. ../sbom.cdx.json lists them in machine-readable form.\n\n\
         {UNNAMED_BY_RUST}\n{additions}\n\
         {rule}\n\n{}\n{rule}\n\n{}",
        read(&root.join("LICENSE-MIT"))?,
        read(&root.join("LICENSE-APACHE"))?,
    ))
}

/// A list of the crates, then each text once, with the crates from which it comes.
fn of_crates(root: &Path, crates: &[Crate]) -> Result<String> {
    let mut list = String::from("Crates that are linked, with the licences that their authors offer:\n\n");
    let mut texts: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for one in crates.iter().filter(|one| !one.is_own()) {
        list.push_str(&format!("{}: {}\n", one.id(), one.license));
        let is_without = one.license == "MIT" && WITHOUT_TEXT.contains(&one.name.as_str());
        if is_without {
            texts.entry(terms_of_mit(root)?).or_default().push(format!("the manifest of {}", one.id()));
        }
        for file in if is_without { Vec::new() } else { texts_of(one)? } {
            let name = file.file_name().unwrap_or_default().to_string_lossy();
            texts.entry(read(&file)?).or_default().push(format!("{name} of {}", one.id()));
        }
    }
    let rule = "-".repeat(80);
    Ok(texts.iter().fold(list, |all, (text, owners)| format!("{all}\n{rule}\n{}\n{rule}\n\n{text}", owners.join("\n"))))
}

/// The licence MIT without a holder, whom the crates that name it in their manifests do not name there.
fn terms_of_mit(root: &Path) -> Result<String> {
    let text = read(&root.join("LICENSE-MIT"))?;
    let paragraphs = text.split("\n\n").filter(|paragraph| !paragraph.starts_with("Copyright"));
    let terms = paragraphs.collect::<Vec<_>>().join("\n\n");
    Ok(format!("Copyright (c) the authors of the crate, whose archive has no notice.\n\n{terms}"))
}

/// The files of a crate that hold its licences; there must be one.
fn texts_of(one: &Crate) -> Result<Vec<PathBuf>> {
    let mut texts = Vec::new();
    for entry in one.folder.read_dir().with_context(|| format!("cannot list {}", one.folder.display()))? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_uppercase();
        if path.is_file() && BEGINNINGS.iter().any(|beginning| name.starts_with(beginning)) {
            texts.push(path);
        }
    }
    ensure!(!texts.is_empty(), "{} has no file with its licence in {}", one.id(), one.folder.display());
    texts.sort();
    Ok(texts)
}

/// A file with licences of the standard library, which comes with the compiler.
fn of_standard_library(name: &str) -> Result<Vec<u8>> {
    let file = toolchain::sysroot()?.join("share/doc/rust").join(name);
    fs::read(&file).with_context(|| {
        let cure = "the Rust of https://rustup.rs has it, some others do not";
        format!("cannot read {}, a licence of Rust's standard library: {cure}", file.display())
    })
}

fn read(file: &Path) -> Result<String> {
    fs::read_to_string(file).with_context(|| format!("cannot read {}", file.display()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::toolchain::WINDOWS_X86_64;
    use crate::project::root;

    /// A crate whose folder holds these files.
    fn specimen(name: &str, files: &[(&str, &str)]) -> (tempfile::TempDir, Crate) {
        let folder = tempfile::tempdir().unwrap();
        for (file, text) in files {
            fs::write(folder.path().join(file), text).unwrap();
        }
        let one = Crate {
            name: name.into(),
            version: "1.0.0".into(),
            license: "MIT".into(),
            sha256: Some("0".repeat(64)),
            folder: folder.path().into(),
            needs: Default::default(),
        };
        (folder, one)
    }

    #[test]
    fn equal_texts_appear_once_with_all_their_owners() {
        let files = [("LICENSE-MIT", "Permission."), ("notice.txt", "Thanks."), ("lib.rs", "code")];
        let (_a, a) = specimen("a", &files);
        let (_b, b) = specimen("b", &files[..1]);
        let text = of_crates(root(), &[a, b]).unwrap();
        assert_eq!(text.matches("Permission.").count(), 1);
        assert!(text.contains("a 1.0.0: MIT\nb 1.0.0: MIT\n"), "{text}");
        assert!(text.contains("LICENSE-MIT of a 1.0.0\nLICENSE-MIT of b 1.0.0\n"), "{text}");
        assert!(
            text.contains("notice.txt of a 1.0.0\n") && text.contains("Thanks.") && !text.contains("code"),
            "{text}"
        );
    }

    #[test]
    fn a_crate_without_a_licence_is_refused() {
        let (_folder, bare) = specimen("bare", &[("README.md", "MIT, I think.")]);
        let error = of_crates(root(), &[bare]).unwrap_err().to_string();
        assert!(error.starts_with("bare 1.0.0 has no file with its licence in "), "{error}");
    }

    #[test]
    fn a_crate_that_is_known_to_lack_its_licence_gets_that_of_its_manifest() {
        let (_folder, mut known) = specimen("ts-rs", &[("README.md", "Types.")]);
        let text = of_crates(root(), &[known.clone()]).unwrap();
        assert!(
            text.contains("the manifest of ts-rs 1.0.0") && text.contains("Permission is hereby granted"),
            "{text}"
        );
        assert!(!text.contains(crate::project::AUTHORS), "{text}");
        known.license = "Apache-2.0".into();
        assert!(of_crates(root(), &[known]).is_err());
    }

    #[test]
    fn the_entry_has_both_licences_of_this_project_and_names_what_linkers_add() {
        let additions = WINDOWS_X86_64.additions(root()).unwrap();
        let text = entry(root(), &additions).unwrap();
        assert!(text.contains("Permission is hereby granted") && text.contains("Apache License"));
        assert!(text.contains("\nmingw-w64.txt: mingw-w64, which the linker adds, ZPL-2.1\n"), "{text}");
    }

    #[test]
    fn tables_of_unicode_bring_their_licence() {
        let parts = Parts { package: "none".into(), crates: Vec::new(), rust: "1.95.0".into(), additions: Vec::new() };
        let text = String::from_utf8(files(root(), &parts).unwrap()["licenses/unicode.txt"].clone());
        assert!(text.unwrap().starts_with("UNICODE LICENSE V3\n"));
    }

    #[test]
    fn what_linkers_add_brings_its_licence() {
        let (folder, _) = specimen("a", &[("copyright", "Redistribution and use.")]);
        let addition = Addition { name: "start", license: "ZPL-2.1", notices: folder.path().join("copyright") };
        let (package, crates) = ("none".into(), Vec::new());
        let mut parts = Parts { package, crates, rust: "1.95.0".into(), additions: vec![addition] };
        assert_eq!(files(root(), &parts).unwrap()["licenses/start.txt"], b"Redistribution and use.");
        parts.additions[0].notices = folder.path().join("lost");
        assert!(files(root(), &parts).unwrap_err().to_string().contains("lost"));
    }
}
