//! The kit for C and C++: header, libraries, what CMake and pkg-config read, examples, licences.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};

use crate::build::crates::Parts;
use crate::build::library::Library;
use crate::build::toolchain;
use crate::pack::archive::Files;
use crate::pack::licenses;
use crate::pack::sbom::{self, Product};
use crate::project::{LICENSE, VERSION};

/// Templates of files that need the version or the platform, by their places in the kit.
const TEMPLATES: [(&str, &str); 5] = [
    ("README.md", include_str!("sdk/README.md")),
    ("lib/cmake/stribeck/stribeckConfig.cmake", include_str!("sdk/stribeckConfig.cmake")),
    ("lib/cmake/stribeck/stribeckConfigVersion.cmake", include_str!("sdk/stribeckConfigVersion.cmake")),
    ("lib/pkgconfig/stribeck.pc", include_str!("sdk/stribeck.pc")),
    ("share/stribeck/examples/CMakeLists.txt", include_str!("sdk/CMakeLists.txt")),
];

const DOCUMENTS: &str = "share/doc/stribeck";
const EXAMPLES: [&str; 4] = ["c/belt.c", "c/fmu_master.c", "c/system_master.c", "cpp/hysteresis.cpp"];

/// The kit for the platform of a library, with paths below its folder.
pub fn files(root: &Path, library: &Library) -> Result<Files> {
    let platform = library.platform;
    let needs = toolchain::native_libraries(&platform.triples()?[0])?;
    let shared = shared_path(platform.suffix);
    let mut files = Files::from([
        ("include/stribeck.h".into(), read(&root.join("include/stribeck.h"))?),
        (shared.clone(), library.bytes.clone()),
        ("lib/libstribeck.a".into(), library.static_library(root)?),
    ]);
    files.extend(library.import_library()?.map(|bytes| ("lib/libstribeck.dll.a".into(), bytes)));
    for example in EXAMPLES {
        let (_, name) = example.split_once('/').context("an example has a folder")?;
        files.insert(format!("share/stribeck/examples/{name}"), read(&root.join("examples").join(example))?);
    }
    for (path, template) in TEMPLATES {
        files.insert(path.into(), filled(template, platform.name(), &shared, &needs).into());
    }
    let parts = Parts::of(root, &[platform])?;
    let product = Product {
        file: format!("stribeck for C, {}", platform.name()),
        name: "stribeck",
        summary: "Friction force models and a telescopic shock absorber, for C and C++",
    };
    files.insert(format!("{DOCUMENTS}/{}", sbom::FILE), sbom::text(&product, &parts)?.into());
    files.extend(licenses::below(DOCUMENTS, &licenses::files(root, &parts)?));
    Ok(files)
}

/// Where the shared library stands: Windows looks for it where it looks for programs.
fn shared_path(suffix: &str) -> String {
    if suffix == ".dll" { "bin/stribeck.dll".into() } else { format!("lib/libstribeck{suffix}") }
}

/// A template with its blanks filled.
fn filled(template: &str, platform: &str, shared: &str, needs: &[String]) -> String {
    let (series, _) = VERSION.rsplit_once('.').unwrap_or((VERSION, ""));
    let import = match shared.ends_with(".dll") {
        true => "\n    IMPORTED_IMPLIB \"${stribeck_folder}/lib/libstribeck.dll.a\"",
        // Its file does not say under which name programs find it; without this CMake would write a path into them.
        false if shared.ends_with(".so") => "\n    IMPORTED_NO_SONAME TRUE",
        false => "",
    };
    let names: Vec<_> = needs.iter().map(|flag| flag.trim_start_matches("-l")).collect();
    let blanks = [
        ("@VERSION@", VERSION),
        ("@SERIES@", series),
        ("@LICENSE@", LICENSE),
        ("@PLATFORM@", platform),
        ("@SHARED@", shared),
        ("@IMPORT@", import),
        ("@NEEDS@", &names.join(";")),
        ("@FLAGS@", &needs.join(" ")),
    ];
    blanks.iter().fold(template.to_owned(), |text, (blank, value)| text.replace(blank, value))
}

fn read(file: &Path) -> Result<Vec<u8>> {
    fs::read(file).with_context(|| format!("cannot read {}", file.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_template_keeps_a_blank_or_names_a_place() {
        for shared in ["lib/libstribeck.so", "bin/stribeck.dll", "lib/libstribeck.dylib"] {
            for (path, template) in TEMPLATES {
                let text = filled(template, "linux64", shared, &["-lm".into(), "-lc".into()]);
                assert!(!text.contains('@'), "{path}: {text}");
                assert!(!text.contains(env!("CARGO_MANIFEST_DIR")), "{path}");
            }
        }
        let config = |shared| filled(TEMPLATES[1].1, "linux64", shared, &["-lm".into(), "-lc".into()]);
        assert!(config("lib/libstribeck.so").contains("INTERFACE_LINK_LIBRARIES \"m;c\""));
        assert!(config("bin/stribeck.dll").contains("IMPORTED_IMPLIB"));
    }

    #[test]
    fn every_c_and_cpp_example_is_in_the_kit() {
        for (folder, ending) in [("c", "c"), ("cpp", "cpp")] {
            let files = fs::read_dir(crate::project::root().join("examples").join(folder)).unwrap();
            let names = files.map(|file| file.unwrap().file_name().into_string().unwrap());
            for name in names.filter(|name| name.ends_with(&format!(".{ending}"))) {
                assert!(EXAMPLES.contains(&format!("{folder}/{name}").as_str()), "{name}");
                assert!(TEMPLATES[4].1.contains(&name), "{name}");
            }
        }
    }
}
