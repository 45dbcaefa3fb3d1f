//! The parts of the library, or of a program, with their licences: the crates that cargo builds, the standard library,
//! and additions of linkers.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};
use cargo_metadata::{DependencyKind, Metadata, MetadataCommand, Node, Package, PackageId};
use serde::Deserialize;

use crate::build::platform::Platform;
use crate::build::toolchain::{self, Addition};

/// The package whose library the FMUs carry.
pub const LIBRARY: &str = "libstribeck";

/// A crate of the library or of a program.
#[derive(Clone, Debug, PartialEq)]
pub struct Crate {
    /// Name.
    pub name: String,
    /// Version.
    pub version: String,
    /// SPDX expression of its licence.
    pub license: String,
    /// SHA-256 of its archive; none for the crates of this project.
    pub sha256: Option<String>,
    /// Folder of its sources.
    pub folder: PathBuf,
    /// The crates that it needs, by [`Crate::id`].
    pub needs: BTreeSet<String>,
}

/// Everything in the libraries of an FMU, or in a program.
#[derive(Clone, Debug)]
pub struct Parts {
    /// The package that is built.
    pub package: String,
    /// Crates, including that of the package.
    pub crates: Vec<Crate>,
    /// Version of Rust, whose standard library is linked.
    pub rust: String,
    /// Additions of the linkers.
    pub additions: Vec<Addition>,
}

impl Parts {
    /// Parts of the libraries for these platforms.
    pub fn of(root: &Path, platforms: &[Platform]) -> Result<Parts> {
        let triples = platforms.iter().map(Platform::triples).collect::<Result<Vec<_>>>()?.concat();
        let targets = platforms.iter().flat_map(|platform| platform.targets);
        let mut additions = targets.map(|target| target.additions(root)).collect::<Result<Vec<_>>>()?.concat();
        additions.sort_by_key(|addition| addition.name);
        additions.dedup();
        let crates = linked(root, LIBRARY, &triples)?;
        Ok(Parts { package: LIBRARY.into(), crates, rust: toolchain::version()?, additions })
    }

    /// Parts of another package that is built for a target.
    pub fn of_package(root: &Path, package: &str, triple: &str) -> Result<Parts> {
        let crates = linked(root, package, &[triple.to_owned()])?;
        let additions = toolchain::additions_of_program(root, triple)?;
        Ok(Parts { package: package.into(), crates, rust: toolchain::version()?, additions })
    }
}

impl Crate {
    /// Name and version.
    pub fn id(&self) -> String {
        id(&self.name, &self.version)
    }

    /// Whether its sources are those of this project, not of the registry.
    pub fn is_own(&self) -> bool {
        self.sha256.is_none()
    }
}

fn id(name: &str, version: &str) -> String {
    format!("{name} {version}")
}

/// The crates whose code is in a package if it is built for one of these targets: including its own, but without macros,
/// which only write code, and without crates that only build or test it.
fn linked(root: &Path, package: &str, targets: &[String]) -> Result<Vec<Crate>> {
    let checksums = checksums(root)?;
    let mut crates: BTreeMap<String, Crate> = BTreeMap::new();
    for target in targets {
        for one in linked_for(root, package, target, &checksums)? {
            match crates.get_mut(&one.id()) {
                Some(known) => known.needs.extend(one.needs),
                None => drop(crates.insert(one.id(), one)),
            }
        }
    }
    Ok(crates.into_values().collect())
}

fn linked_for(root: &Path, package: &str, target: &str, checksums: &HashMap<String, String>) -> Result<Vec<Crate>> {
    let linked = tree(root, package, target, "normal,no-proc-macro")?;
    let metadata = metadata(root, target)?;
    let nodes = &metadata.resolve.as_ref().context("cargo metadata resolved nothing")?.nodes;
    let node = |package: &PackageId| nodes.iter().find(|node| node.id == *package);
    let of_package = |package: &Package| {
        let id = id(&package.name, &package.version.to_string());
        let license = package.license.as_ref().with_context(|| format!("{id} has no licence in its manifest"))?;
        let folder = package.manifest_path.parent().with_context(|| format!("{id} has no folder"))?;
        Ok(Crate {
            name: package.name.to_string(),
            version: package.version.to_string(),
            // Cargo still accepts the old way to write "or".
            license: license.replace('/', " OR "),
            sha256: checksums.get(&id).cloned(),
            folder: folder.into(),
            needs: node(&package.id).map(|node| needs(&metadata, node, &linked)).unwrap_or_default(),
        })
    };
    let is_linked = |package: &&Package| linked.contains(&id(&package.name, &package.version.to_string()));
    metadata.packages.iter().filter(is_linked).map(of_package).collect()
}

/// Names and versions of the crates that these edges of the tree lead to. `cargo metadata` would include features that
/// only other packages of the workspace request.
fn tree(root: &Path, package: &str, target: &str, edges: &str) -> Result<BTreeSet<String>> {
    let mut cargo = Command::new(toolchain::cargo());
    cargo.args(["tree", "--locked", "--package", package, "--target", target]);
    cargo.args(["--edges", edges, "--prefix", "none", "--format", "{p}"]).current_dir(root);
    let name_and_version = |line: &str| {
        let (name, rest) = line.split_once(" v")?;
        Some(id(name, rest.split(' ').next()?))
    };
    Ok(toolchain::stdout(&mut cargo)?.lines().filter_map(name_and_version).collect())
}

fn metadata(root: &Path, target: &str) -> Result<Metadata> {
    let mut cargo = MetadataCommand::new();
    cargo.manifest_path(root.join("Cargo.toml"));
    cargo.other_options(["--locked", "--filter-platform", target].map(str::to_owned));
    cargo.exec().context("cargo metadata failed")
}

fn needs(metadata: &Metadata, node: &Node, linked: &BTreeSet<String>) -> BTreeSet<String> {
    let is_normal =
        |kinds: &[cargo_metadata::DepKindInfo]| kinds.iter().any(|kind| kind.kind == DependencyKind::Normal);
    let needed = node.deps.iter().filter(|dependency| is_normal(&dependency.dep_kinds));
    let ids =
        needed.map(|dependency| id(&metadata[&dependency.pkg].name, &metadata[&dependency.pkg].version.to_string()));
    ids.filter(|id| linked.contains(id)).collect()
}

/// Checksums of the archives, by name and version.
fn checksums(root: &Path) -> Result<HashMap<String, String>> {
    #[derive(Deserialize)]
    struct Lock {
        package: Vec<Locked>,
    }
    #[derive(Deserialize)]
    struct Locked {
        name: String,
        version: String,
        checksum: Option<String>,
    }
    let text = fs::read_to_string(root.join("Cargo.lock")).context("cannot read Cargo.lock")?;
    let lock: Lock = toml::from_str(&text).context("cannot read Cargo.lock")?;
    let packages = lock.package.into_iter();
    Ok(packages.filter_map(|package| Some((id(&package.name, &package.version), package.checksum?))).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::project::root;
    use spdx::{Expression, ParseMode};
    use toml::{Table, Value};

    /// The crates of this project that are in the library.
    const OWN: [&str; 3] = [LIBRARY, "stribeck", "stribeck-ffi"];

    /// The settings of cargo-deny.
    fn settings() -> Table {
        fs::read_to_string(root().join("deny.toml")).unwrap().parse().unwrap()
    }

    fn listed(table: &str, list: &str) -> Vec<Value> {
        settings()[table][list].as_array().unwrap().clone()
    }

    fn is_permitted(license: &str, permitted: &[Value]) -> bool {
        let expression = Expression::parse_mode(license, ParseMode::LAX).unwrap();
        let is_listed = |name: &str| permitted.iter().any(|known| known.as_str() == Some(name));
        expression.evaluate(|wanted| wanted.license.id().is_some_and(|id| is_listed(id.name)))
    }

    #[test]
    fn every_crate_of_the_library_is_allowed() {
        let names = listed("bans", "allow").into_iter().map(|one| one["crate"].as_str().unwrap().to_owned());
        let own = OWN.map(str::to_owned);
        let allowed: BTreeSet<_> = names.chain(own).collect();
        let compiled = tree(root(), LIBRARY, "all", "normal,build").unwrap();
        let compiled: BTreeSet<_> = compiled.iter().map(|id| id.split_once(' ').unwrap().0.to_owned()).collect();
        let lost: Vec<_> = compiled.symmetric_difference(&allowed).collect();
        assert_eq!(lost, [""; 0], "compiled for the library, or listed in deny.toml, but not both");
    }

    #[test]
    fn own_crates_depend_on_four_others() {
        let crates = linked(root(), LIBRARY, &[toolchain::host().unwrap()]).unwrap();
        let own = crates.iter().filter(|one| OWN.contains(&one.name.as_str()));
        let needs: BTreeSet<_> = own.flat_map(|one| &one.needs).map(|id| id.split(' ').next().unwrap()).collect();
        let others: Vec<_> = needs.into_iter().filter(|name| !OWN.contains(name)).collect();
        assert_eq!(others, ["libc", "libm", "nalgebra", "num-traits"]);
    }

    #[test]
    fn licences_are_permitted() {
        let permitted = listed("licenses", "allow");
        for one in linked(root(), LIBRARY, &[toolchain::host().unwrap()]).unwrap() {
            assert!(is_permitted(&one.license, &permitted), "{}: {}", one.id(), one.license);
        }
        for (license, expected) in
            [("MIT", true), ("GPL-3.0 OR Zlib", true), ("GPL-3.0-only", false), ("MIT AND MPL-2.0", false)]
        {
            assert_eq!(is_permitted(license, &permitted), expected, "{license}");
        }
    }

    #[test]
    fn what_is_linked_is_complete() {
        let crates = linked(root(), LIBRARY, &[toolchain::host().unwrap()]).unwrap();
        let ids: BTreeSet<_> = crates.iter().map(Crate::id).collect();
        for one in &crates {
            assert!(one.needs.is_subset(&ids), "{one:?}");
            assert_eq!(one.is_own(), OWN.contains(&one.name.as_str()), "{one:?}");
            assert!(one.folder.join("Cargo.toml").is_file(), "{one:?}");
        }
        let needed: BTreeSet<_> = crates.iter().flat_map(|one| one.needs.clone()).collect();
        assert_eq!(ids.difference(&needed).collect::<Vec<_>>().len(), 1, "only the library is not needed");
        // A macro, and crates that nalgebra uses for other packages.
        assert!(crates.iter().all(|one| !["paste", "glam"].contains(&one.name.as_str())));
    }

    #[test]
    fn platforms_are_joined() {
        let targets = ["x86_64-unknown-linux-gnu", "x86_64-pc-windows-gnu"].map(str::to_owned);
        let joined = linked(root(), LIBRARY, &targets).unwrap();
        for target in targets {
            for one in linked(root(), LIBRARY, &[target]).unwrap() {
                assert!(
                    joined.iter().any(|known| known.id() == one.id() && one.needs.is_subset(&known.needs)),
                    "{one:?}"
                );
            }
        }
    }
}
