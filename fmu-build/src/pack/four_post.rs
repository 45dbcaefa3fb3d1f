//! The four-post rig as a package: a car on four posts, with a shock absorber in each corner, and several dampers.

use std::path::Path;

use anyhow::{Context, Result};
use ssp::parameter_set::{ParameterSet, choice};
use ssp::system::{Component, Port, System};
use stribeck::catalogue;
use stribeck::model::ModelType;

use crate::pack::archive::Files;

/// Name of the package.
pub const NAME: &str = "FourPost";

/// Description that tools open.
const MAIN: &str = "SystemStructure";

const CORNERS: [&str; 4] = ["fl", "fr", "rl", "rr"];

/// Stiffness of the car's rear springs, N/m, to which the rest position of `FourPostCar` belongs.
const REAR_SPRING: f64 = 35_000.0;

/// Adds the descriptions of all variants, and their parameter sets, to a package. Returns the models it needs.
pub fn add_to(files: &mut Files, root: &Path) -> Result<Vec<&'static str>> {
    let mut models = Vec::new();
    for damper in dampers(root)? {
        let system = system(&damper)?;
        system.add_to(files, if damper.name() == "default" { MAIN } else { damper.name() })?;
        models = system.models().into_iter().collect();
    }
    Ok(models)
}

fn shock_absorber() -> Result<&'static ModelType> {
    catalogue::by_name("ShockAbsorber").context("unknown model ShockAbsorber")
}

/// The dampers of the variants, by the names of their parameter sets.
fn dampers(root: &Path) -> Result<Vec<ParameterSet>> {
    let model = shock_absorber()?;
    let measured = |file: &str| ParameterSet::load(model, &root.join("examples/dampers").join(file));
    let off = choice(model, "friction.switch", "Off")?;
    Ok(vec![
        ParameterSet::new::<&str>(model, "default", [])?,
        ParameterSet::new(model, "without_friction", [("friction.switch", off)])?,
        measured("firm.csv")?,
        measured("soft.csv")?,
    ])
}

/// The rig with one kind of damper.
fn system(damper: &ParameterSet) -> Result<System> {
    let part = |name: &str, model| Component { name: name.to_owned(), model, parameters: None };
    let mut components = vec![part("posts", "Posts"), part("car", "FourPostCar")];
    let mut connections = Vec::new();
    for corner in CORNERS {
        let strut = format!("strut_{corner}");
        let [axle, spring] = if corner.starts_with('f') { ["front"; 2] } else { ["rear"; 2] };
        let set = if spring == "rear" { damper.with([("spring.k", REAR_SPRING)])? } else { damper.clone() };
        let file = format!("resources/{}_{axle}.ssv", damper.name());
        components.push(Component { name: strut.clone(), model: "ShockAbsorber", parameters: Some((file, set)) });
        connections.extend(connections_of(corner, &strut));
    }
    let description = "Car on four posts with four shock absorbers";
    Ok(System { name: NAME, description, stop_time: 5.0, components, connections })
}

/// The connections of a corner of the car with its post and its strut.
fn connections_of(corner: &str, strut: &str) -> [[Port; 2]; 5] {
    let port = |component: &str, variable: String| Port { component: component.to_owned(), variable };
    let of_corner = |component: &str, variable: &str| port(component, format!("{corner}.{variable}"));
    let of_strut = |variable: &str| port(strut, variable.to_owned());
    [
        [of_corner("posts", "post_height"), of_corner("car", "post_height")],
        [of_corner("posts", "post_velocity"), of_corner("car", "post_velocity")],
        [of_corner("car", "length"), of_strut("length")],
        [of_corner("car", "velocity"), of_strut("velocity")],
        [of_strut("force"), of_corner("car", "strut_force")],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::project::root;
    use approx::abs_diff_eq;
    use roxmltree::{Document, Node};
    use std::collections::BTreeSet;

    fn files() -> Files {
        let mut files = Files::new();
        assert_eq!(add_to(&mut files, root()).unwrap(), ["FourPostCar", "Posts", "ShockAbsorber"]);
        files
    }

    fn all<'a>(document: &'a Document, name: &str) -> Vec<Node<'a, 'a>> {
        document.descendants().filter(|node| node.tag_name().name() == name).collect()
    }

    #[test]
    fn every_variant_names_files_of_the_package_and_connects_every_input_it_needs() {
        let files = files();
        let descriptions: Vec<&String> = files.keys().filter(|name| name.ends_with(".ssd")).collect();
        assert_eq!(descriptions, ["SystemStructure.ssd", "firm.ssd", "soft.ssd", "without_friction.ssd"]);
        for name in descriptions {
            let text = std::str::from_utf8(&files[name]).unwrap();
            let document = Document::parse(text).unwrap();
            assert_eq!(all(&document, "Component").len(), 6);
            for binding in all(&document, "ParameterBinding") {
                assert!(files.contains_key(binding.attribute("source").unwrap()), "{binding:?}");
            }
            let of = |connector: Node, end: &str, name: &str| {
                [end, name].map(|attribute| connector.attribute(attribute).unwrap().to_owned())
            };
            let ends: BTreeSet<[String; 2]> = all(&document, "Connection")
                .into_iter()
                .map(|connection| of(connection, "endElement", "endConnector"))
                .collect();
            assert_eq!(ends.len(), 20, "no input is connected twice");
            // Every end is a declared connector of its component.
            let declared: BTreeSet<[String; 2]> = all(&document, "Connector")
                .into_iter()
                .filter(|connector| connector.attribute("kind") == Some("input"))
                .map(|connector| {
                    let component = connector.ancestors().find(|node| node.has_tag_name(component_tag())).unwrap();
                    [component.attribute("name").unwrap().to_owned(), connector.attribute("name").unwrap().to_owned()]
                })
                .collect();
            assert_eq!(declared, ends);
        }
    }

    fn component_tag() -> (&'static str, &'static str) {
        ("http://ssp-standard.org/SSP1/SystemStructureDescription", "Component")
    }

    #[test]
    fn rear_struts_have_softer_springs_and_each_variant_has_its_damper() {
        let files = files();
        let model = shock_absorber().unwrap();
        let set = |name: &str| {
            let text = std::str::from_utf8(&files[&format!("resources/{name}.ssv")]).unwrap();
            ParameterSet::from_ssv(model, text).unwrap()
        };
        for damper in ["default", "firm", "soft", "without_friction"] {
            assert_eq!(set(&format!("{damper}_front")).get("spring.k"), None);
            assert_eq!(set(&format!("{damper}_rear")).get("spring.k"), Some(35_000.0));
            assert_eq!(set(&format!("{damper}_rear")).name(), damper);
        }
        let top = |name: &str| set(name).get("damper.tab_f[11]").unwrap();
        assert!(
            abs_diff_eq!(top("soft_front") / top("firm_front"), 0.6, epsilon = 0.01),
            "the soft damper: six tenths"
        );
    }

    #[test]
    fn impossible_connections_are_rejected() {
        let refusal = |change: &dyn Fn(&mut System)| {
            let mut system = system(&dampers(root()).unwrap()[0]).unwrap();
            change(&mut system);
            system.add_to(&mut Files::new(), MAIN).unwrap_err().to_string()
        };
        let rename = |at: usize, end: usize, variable: &'static str| {
            move |system: &mut System| system.connections[at][end].variable = variable.into()
        };
        assert_eq!(refusal(&rename(0, 0, "fl.height")), "Posts has no variable fl.height");
        assert_eq!(refusal(&rename(0, 0, "fl.travel")), "posts: fl.travel is not an output");
        assert_eq!(refusal(&rename(0, 1, "fl.length")), "car: fl.length is not an input");
        assert_eq!(
            refusal(&rename(0, 0, "fl.post_velocity")),
            "fl.post_velocity and fl.post_height are not physical quantities of the same unit"
        );
        assert_eq!(
            refusal(&|system| system.connections[5] = system.connections[0].clone()),
            "car: fl.post_height is connected twice"
        );
        assert_eq!(refusal(&|system| system.connections[0][0].component = "rig".into()), "no component rig");
    }
}
