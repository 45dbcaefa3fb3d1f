//! The components of an FMU, or of another product with the library, in machine-readable form: CycloneDX 1.5.

use anyhow::{Context, Result};
use cyclonedx_bom::external_models::spdx::SpdxExpression;
use cyclonedx_bom::models::bom::{Bom, SpecVersion};
use cyclonedx_bom::models::component::{Classification, Component, Components};
use cyclonedx_bom::models::dependency::{Dependencies, Dependency};
use cyclonedx_bom::models::hash::{Hash, HashAlgorithm, HashValue, Hashes};
use cyclonedx_bom::models::license::{LicenseChoice, Licenses};
use cyclonedx_bom::models::metadata::Metadata;
use cyclonedx_bom::prelude::{NormalizedString, Purl};

use crate::build::crates::{Crate, Parts};
use crate::build::toolchain::Addition;
use crate::project::{LICENSE, VERSION};

/// Its name, with the file extension that CycloneDX recommends.
pub const FILE: &str = "sbom.cdx.json";

const STANDARD_LIBRARY: &str = "rust-std";

/// Product whose components are listed.
pub struct Product<'a> {
    /// Its file.
    pub file: String,
    /// Name.
    pub name: &'a str,
    /// Description in a sentence.
    pub summary: &'a str,
}

/// The text for a product. It contains no date and no serial number, so that equal contents give equal bytes.
pub fn text(product: &Product, parts: &Parts) -> Result<String> {
    let Parts { crates, rust, additions, .. } = parts;
    let standard_library = format!("{STANDARD_LIBRARY} {rust}");
    let components = crates.iter().map(of_crate).chain([of_standard_library(&standard_library, rust)]);
    let components = components.chain(additions.iter().map(of_addition)).collect::<Result<Vec<_>>>()?;
    let dependencies = dependencies(&product.file, parts, &standard_library)?;
    let bom = Bom {
        serial_number: None,
        metadata: Some(Metadata { component: Some(component_of(product)?), ..Metadata::default() }),
        components: Some(Components(components)),
        dependencies: Some(Dependencies(dependencies)),
        spec_version: SpecVersion::V1_5,
        ..Bom::default()
    };
    let mut text = Vec::new();
    bom.output_as_json_v1_5(&mut text).context("cannot write the list of components")?;
    Ok(String::from_utf8(text)? + "\n")
}

/// Dependencies of the product and of each of its crates.
fn dependencies(product: &str, parts: &Parts, standard_library: &str) -> Result<Vec<Dependency>> {
    let Parts { crates, additions, .. } = parts;
    let built = crates.iter().find(|one| one.name == parts.package).context("a package is not among its crates")?;
    let added = additions.iter().map(|addition| addition.name.to_owned());
    let of_product = [built.id()].into_iter().chain(added).collect();
    let of_crate = |one: &Crate| {
        let needs = one.needs.iter().cloned().chain([standard_library.to_owned()]).collect();
        Dependency { dependency_ref: one.id(), dependencies: needs }
    };
    let of_product = Dependency { dependency_ref: product.to_owned(), dependencies: of_product };
    Ok([of_product].into_iter().chain(crates.iter().map(of_crate)).collect())
}

fn component_of(product: &Product) -> Result<Component> {
    let mut component = component(product.name, VERSION, product.file.clone(), LICENSE)?;
    component.description = Some(NormalizedString::new(product.summary));
    Ok(component)
}

fn of_crate(one: &Crate) -> Result<Component> {
    let mut component = component(&one.name, &one.version, one.id(), &one.license)?;
    // Only crates with a checksum came from the registry.
    if let Some(sha256) = &one.sha256 {
        let hash = Hash { alg: HashAlgorithm::SHA_256, content: HashValue(sha256.clone()) };
        component.hashes = Some(Hashes(vec![hash]));
        component.purl = Some(Purl::new("cargo", &one.name, &one.version)?);
    }
    Ok(component)
}

fn of_standard_library(id: &str, rust: &str) -> Result<Component> {
    // As stated by https://github.com/rust-lang/rust for `library`; its tables of characters are made from Unicode's
    // data.
    let mut component = component(STANDARD_LIBRARY, rust, id.into(), "(MIT OR Apache-2.0) AND Unicode-3.0")?;
    component.purl = Some(Purl::new("generic", STANDARD_LIBRARY, rust)?);
    Ok(component)
}

/// No version: the linkers do not name it.
fn of_addition(addition: &Addition) -> Result<Component> {
    let mut component = component(addition.name, "", addition.name.into(), addition.license)?;
    component.version = None;
    Ok(component)
}

fn component(name: &str, version: &str, id: String, license: &str) -> Result<Component> {
    let expression = SpdxExpression::try_from(license.to_owned()).with_context(|| format!("licence of {id}"))?;
    let mut component = Component::new(Classification::Library, name, version, Some(id));
    component.licenses = Some(Licenses(vec![LicenseChoice::Expression(expression)]));
    Ok(component)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::platform::{Choice, platforms};
    use crate::build::toolchain::WINDOWS_X86_64;
    use crate::project::root;
    use cyclonedx_bom::prelude::Validate;
    use serde_json::Value;

    fn product() -> Product<'static> {
        Product { file: "Specimen.fmu".into(), name: "Specimen", summary: "Friction, for example" }
    }

    /// Parts of the library of this machine, and of one for Windows.
    fn parts() -> Parts {
        let parts = Parts::of(root(), &platforms(&[Choice::Host]).unwrap()).unwrap();
        Parts { additions: WINDOWS_X86_64.additions(root()).unwrap(), ..parts }
    }

    #[test]
    fn the_list_is_valid_and_names_every_crate() {
        let parts = parts();
        let text = text(&product(), &parts).unwrap();
        let bom = Bom::parse_from_json_v1_5(text.as_bytes()).unwrap();
        let faults = bom.validate();
        assert!(faults.passed(), "{faults:?}");
        let document: Value = serde_json::from_str(&text).unwrap();
        let components = document["components"].as_array().unwrap();
        assert_eq!(components.len(), parts.crates.len() + 1 + parts.additions.len());
        for one in &parts.crates {
            let component = components.iter().find(|component| component["name"] == one.name.as_str()).unwrap();
            assert_eq!(component["version"], one.version.as_str());
            assert_eq!(component["licenses"][0]["expression"], one.license.as_str());
            assert_eq!(component["hashes"][0]["content"].as_str(), one.sha256.as_deref());
            assert_eq!(component["purl"].is_string(), !one.is_own());
        }
        let standard_library = &components[parts.crates.len()];
        assert_eq!(standard_library["purl"], format!("pkg:generic/rust-std@{}", parts.rust));
        assert_eq!(standard_library["licenses"][0]["expression"], "(MIT OR Apache-2.0) AND Unicode-3.0");
        let last = components.last().unwrap();
        assert_eq!((&last["name"], &last["version"]), (&"mingw-w64".into(), &Value::Null));
    }

    #[test]
    fn every_reference_leads_to_a_component() {
        let document: Value = serde_json::from_str(&text(&product(), &parts()).unwrap()).unwrap();
        let components = document["components"].as_array().unwrap();
        let known: Vec<_> = components.iter().map(|component| &component["bom-ref"]).collect();
        for dependency in document["dependencies"].as_array().unwrap() {
            for needed in dependency["dependsOn"].as_array().unwrap() {
                assert!(known.contains(&needed), "{needed}");
            }
        }
        assert_eq!(document["dependencies"][0]["ref"], document["metadata"]["component"]["bom-ref"]);
    }

    #[test]
    fn equal_contents_give_equal_bytes_without_date_or_path() {
        let once = text(&product(), &parts()).unwrap();
        assert_eq!(once, text(&product(), &parts()).unwrap());
        for foreign in ["timestamp", "serialNumber", &root().display().to_string()] {
            assert!(!once.contains(foreign), "{foreign}");
        }
    }

    #[test]
    fn an_unknown_licence_is_refused() {
        let mut parts = parts();
        parts.crates[0].license = "Gratis".into();
        let error = format!("{:#}", text(&product(), &parts).unwrap_err());
        assert!(error.starts_with(&format!("licence of {}", parts.crates[0].id())), "{error}");
    }
}
