//! terminalsAndIcons.xml of FMI 3.0.2, which FMI 2.0.4 and newer know too: the variables of each flange, so that an
//! importer connects two models at once. Which variables those are follows from what they are declared for.

use std::io;

use anyhow::{Context, Result};
use stribeck::arrays::{self, Array};
use stribeck::model::{Meaning, ModelType, Role, Variable};

use crate::describe::fmi3::VERSION;
use crate::describe::interface::Version;
use crate::describe::text::number;
use crate::describe::xml::{Attributes, Xml, document, leaf, parent};

/// The file.
pub const FILE: &str = "terminalsAndIcons/terminalsAndIcons.xml";

/// The picture of the model beside it in FMI 3.0.
pub const ICON: &str = "terminalsAndIcons/icon.png";

/// The layered standard by which a terminal holds a map.
pub const STRUCT: &str = "org.fmi-standard.fmi-ls-struct";

/// Something that connects two models.
struct Flange {
    name: &'static str,
    description: &'static str,
    /// Its members, by what they are declared for, with the names that both sides have.
    members: &'static [(Meaning, &'static str)],
    /// Meanings that a model must have for such a flange.
    needed: [Meaning; 2],
}

const FLANGES: [Flange; 3] = [
    Flange {
        name: "contact",
        description: "Contact between a body and a friction law",
        members: &[
            (Meaning::Velocity, "velocity"),
            (Meaning::Acceleration, "acceleration"),
            (Meaning::NormalForce, "normal_force"),
            (Meaning::ExternalForce, "external_force"),
            (Meaning::MotorForce, "motor_force"),
            (Meaning::LoadForce, "load_force"),
            (Meaning::FrictionForce, "friction_force"),
        ],
        needed: [Meaning::Velocity, Meaning::FrictionForce],
    },
    Flange {
        name: "strut",
        description: "Eyes of a strut",
        members: &[
            (Meaning::StrutLength, "length"),
            (Meaning::Velocity, "velocity"),
            (Meaning::Acceleration, "acceleration"),
            (Meaning::StrutForce, "force"),
            (Meaning::ForceWithoutFriction, "force_without_friction"),
            (Meaning::RodForce, "rod_force"),
            (Meaning::ExternalForce, "external_force"),
        ],
        needed: [Meaning::StrutLength, Meaning::StrutForce],
    },
    Flange {
        name: "ground",
        description: "Ground under a wheel",
        members: &[(Meaning::GroundHeight, "height"), (Meaning::GroundVelocity, "velocity")],
        needed: [Meaning::GroundHeight, Meaning::GroundVelocity],
    },
];

/// A terminal with the name, and each variable with the name that it has there and its kind.
#[derive(Debug, PartialEq)]
pub struct Terminal {
    /// Name.
    pub name: String,
    /// Description.
    pub description: &'static str,
    /// Kind and rule of matching.
    rule: [&'static str; 2],
    /// Variable, its name in the terminal, and its kind.
    pub members: Vec<[String; 3]>,
}

/// Variables may be connected even if the other side lacks some: not every law needs every force.
const BUS: [&str; 2] = ["", "bus"];

/// A map on a line, whose points stand in one array and whose values in another.
const MAP: [&str; 2] = ["org.fmi-standard.fmi-ls-struct.map.rectilinearGrid", "org.fmi-standard.fmi-ls-struct.map"];

/// The text of the file; none if the model has no terminal and its icon stands elsewhere, as in FMI 2.0.
pub fn text(model: &ModelType, version: Version) -> Result<Option<String>> {
    let terminals = of(model, version)?;
    if terminals.is_empty() && version == Version::Two {
        return Ok(None);
    }
    let text = document("fmiTerminalsAndIcons", vec![("fmiVersion", VERSION.into())], |xml| {
        if version == Version::Three {
            parent(xml, "GraphicalRepresentation", vec![], graphics)?;
        }
        if terminals.is_empty() {
            return Ok(());
        }
        parent(xml, "Terminals", vec![], |xml| terminals.iter().try_for_each(|terminal| write(xml, terminal)))
    })?;
    Ok(Some(text))
}

/// The icon fills the coordinate system.
fn graphics(xml: &mut Xml) -> io::Result<()> {
    let mut system = corners();
    system.push(("suggestedScalingFactorTo_mm", "0.1".into()));
    leaf(xml, "CoordinateSystem", system)?;
    leaf(xml, "Icon", corners())
}

/// The square of the standard's own coordinate system.
fn corners() -> Attributes {
    [("x1", -100.0), ("y1", -100.0), ("x2", 100.0), ("y2", 100.0)].map(|(name, at)| (name, number(at))).into()
}

fn write(xml: &mut Xml, terminal: &Terminal) -> io::Result<()> {
    let [kind, rule] = terminal.rule;
    let mut attributes = vec![("name", terminal.name.clone()), ("matchingRule", rule.into())];
    if !kind.is_empty() {
        attributes.push(("terminalKind", kind.into()));
    }
    attributes.push(("description", terminal.description.into()));
    parent(xml, "Terminal", attributes, |xml| {
        terminal.members.iter().cloned().try_for_each(|[variable, member, kind]| {
            let attributes = vec![("variableName", variable), ("memberName", member), ("variableKind", kind)];
            leaf(xml, "TerminalMemberVariable", attributes)
        })
    })
}

/// The terminals of a model: its flanges and, where arrays are variables, its tables.
pub fn of(model: &ModelType, version: Version) -> Result<Vec<Terminal>> {
    let mut terminals = flanges(model);
    if version == Version::Three {
        terminals.extend(maps(model)?);
    }
    Ok(terminals)
}

/// Whether a model has a table that FMI-LS-STRUCT describes.
pub fn has_maps(model: &ModelType) -> Result<bool> {
    Ok(!maps(model)?.is_empty())
}

fn flanges(model: &ModelType) -> Vec<Terminal> {
    let ports: Vec<Variable> = model.variables().map(|(_, variable)| variable).filter(is_port).collect();
    let mut parts: Vec<String> = Vec::new();
    for variable in &ports {
        let part = part(variable);
        if !parts.contains(&part) {
            parts.push(part);
        }
    }
    let of_part = |name: &String| {
        let members: Vec<&Variable> = ports.iter().filter(|variable| part(variable) == *name).collect();
        FLANGES.iter().filter_map(|flange| terminal(flange, name, &members)).collect::<Vec<_>>()
    };
    parts.iter().flat_map(of_part).collect()
}

fn is_port(variable: &Variable) -> bool {
    variable.role == Role::Input || variable.role.is_output()
}

/// The part that a variable belongs to, with a dot; empty for one that belongs to the model itself.
fn part(variable: &Variable) -> String {
    let name = variable.path.to_string();
    name.rfind('.').map_or_else(String::new, |dot| name[..=dot].to_owned())
}

fn terminal(flange: &Flange, part: &str, ports: &[&Variable]) -> Option<Terminal> {
    let is_there = |meaning: &Meaning| ports.iter().any(|variable| variable.meaning == *meaning);
    if !flange.needed.iter().all(is_there) {
        return None;
    }
    let members = flange.members.iter().flat_map(|(meaning, member)| {
        let named = ports.iter().filter(|variable| variable.meaning == *meaning);
        named.flat_map(|variable| components(variable, member, ports)).collect::<Vec<_>>()
    });
    let name = format!("{part}{}", flange.name);
    Some(Terminal { name, description: flange.description, rule: BUS, members: members.collect() })
}

/// A variable, or all components of a vector whose component along x it is.
fn components(variable: &Variable, member: &str, ports: &[&Variable]) -> Vec<[String; 3]> {
    let name = variable.path.to_string();
    let signal = |name: String, member: String| [name, member, "signal".to_owned()];
    let Some(stem) = name.strip_suffix("_x") else { return vec![signal(name, member.to_owned())] };
    let along = |axis| [format!("{stem}_{axis}"), format!("{member}_{axis}")];
    let is_there = |name: &str| ports.iter().any(|port| port.path.to_string() == name);
    let components = ["x", "y", "z"].map(along).into_iter().filter(|[name, _]| is_there(name));
    components.map(|[name, member]| signal(name, member)).collect()
}

fn maps(model: &ModelType) -> Result<Vec<Terminal>> {
    let arrays = arrays::of(model).ok().context("out of memory")?;
    Ok(arrays.windows(2).filter_map(|pair| map(model, &pair[0], &pair[1])).collect())
}

/// The table of two arrays of one size, points first: `damper.tab_v` and `damper.tab_f`. The number of points in use is a
/// member beside them.
fn map(model: &ModelType, points: &Array, values: &Array) -> Option<Terminal> {
    let size = points.size.filter(|size| values.size == Some(*size))?;
    let name = size.to_string().strip_suffix("_size")?.to_owned();
    let is_column =
        |array: &Array| array.path.to_string().strip_prefix(&name).is_some_and(|rest| rest.starts_with('_'));
    if !is_column(points) || !is_column(values) {
        return None;
    }
    let member = |variable: String, kind: String| {
        let own = variable.rsplit('.').next().unwrap_or_default().to_owned();
        [variable, own, kind]
    };
    let of_map = |array: &Array, kind: &str| member(array.path.to_string(), format!("{}.{kind}", MAP[1]));
    let in_use = member(model.table.at(size.in_use).path.to_string(), "signal".into());
    let members = vec![of_map(points, "domain"), of_map(values, "codomain"), in_use];
    Some(Terminal { name, description: "Table, of which the first points are in use", rule: MAP, members })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;
    use stribeck::catalogue;
    use stribeck::model::Kind;

    fn model(name: &str) -> &'static ModelType {
        catalogue::by_name(name).unwrap()
    }

    /// Members of a terminal, with their variables.
    fn members(name: &str, terminal: &str) -> Vec<(String, String)> {
        let terminals = of(model(name), Version::Three).unwrap();
        let found = terminals.into_iter().find(|known| known.name == terminal);
        let members = found.unwrap_or_else(|| panic!("{name} has no {terminal}")).members;
        members.into_iter().map(|[variable, member, _]| (member, variable)).collect()
    }

    fn pairs(pairs: &[(&str, &str)]) -> Vec<(String, String)> {
        pairs.iter().map(|(a, b)| ((*a).into(), (*b).into())).collect()
    }

    /// An output of one side and an input of the other, in the same unit, for each member that both have. Returns the
    /// inputs that are connected.
    fn connect(a: (&str, &str), b: (&str, &str)) -> Vec<String> {
        let [(left, left_members), (right, right_members)] =
            [a, b].map(|(name, terminal)| (model(name), members(name, terminal)));
        let mut inputs = Vec::new();
        for (member, variable) in left_members {
            let Some((_, other)) = right_members.iter().find(|(name, _)| *name == member) else { continue };
            let ends =
                [(left, &variable), (right, other)].map(|(model, name)| model.table.at(model.find(name).unwrap()));
            assert!(matches!((ends[0].kind, ends[1].kind), (Kind::Real(a), Kind::Real(b)) if a == b), "{member}");
            let (taken, given): (Vec<&Variable>, Vec<&Variable>) = ends.iter().partition(|end| end.role == Role::Input);
            assert!(taken.len() == 1 && given[0].role.is_output(), "{variable} and {other}");
            inputs.push(taken[0].path.to_string());
        }
        inputs.sort();
        inputs
    }

    #[test]
    fn a_law_and_its_host_are_connected_at_once() {
        for host in ["Axis", "BeltRig", "BeltDrive", "Incline", "PositionControl", "PulledMass", "TwoBlocks"] {
            let inputs = connect((host, "contact"), ("Karnopp", "contact"));
            assert_eq!(inputs, ["external_force", "friction_force", "normal_force", "velocity"], "{host}");
        }
        let inputs = connect(("ServoArm", "contact"), ("ServoFriction", "contact"));
        assert_eq!(inputs, ["friction_force", "load_force", "motor_force", "velocity"]);
    }

    #[test]
    fn a_strut_and_a_car_are_connected_at_once() {
        let inputs = connect(("QuarterCar", "strut"), ("ShockAbsorber", "strut"));
        let expected = ["external_force", "force_without_friction", "length", "rod_force", "strut_force", "velocity"];
        assert_eq!(inputs, expected);
        for corner in ["fl", "fr", "rl", "rr"] {
            let (strut, ground) = (format!("{corner}.strut"), format!("{corner}.ground"));
            for car in ["FourPostCar", "DoubleTrackCar"] {
                let inputs = connect((car, &strut), ("ShockAbsorber", "strut")).into_iter().collect::<BTreeSet<_>>();
                assert_eq!(inputs, [format!("{corner}.strut_force"), "length".into(), "velocity".into()].into());
                assert_eq!(connect((car, &ground), ("Posts", &ground)).len(), 2);
            }
        }
    }

    #[test]
    fn every_model_that_rubs_has_a_flange() {
        for (model, _) in catalogue::documented(catalogue::Family::Friction) {
            let terminals = of(model, Version::Two).unwrap();
            assert_eq!(terminals[0].name, "contact", "{}", model.name);
        }
        let planar = [("velocity_x", "velocity_x"), ("velocity_y", "velocity_y"), ("normal_force", "normal_force")];
        let planar =
            [&planar[..], &[("friction_force_x", "friction_force_x"), ("friction_force_y", "friction_force_y")]];
        assert_eq!(members("LuGrePlanar", "contact"), pairs(&planar.concat()));
    }

    #[test]
    fn tables_are_maps_of_fmi_3() {
        let damper = pairs(&[("tab_v", "damper.tab_v"), ("tab_f", "damper.tab_f"), ("tab_n", "damper.tab_n")]);
        assert_eq!(members("ShockAbsorber", "damper.tab"), damper);
        assert_eq!(of(model("HydraulicDamper"), Version::Two).unwrap(), []);
        let with_maps: Vec<&str> =
            catalogue::models().filter(|model| has_maps(model).unwrap()).map(|model| model.name).collect();
        assert_eq!(with_maps, ["ShockAbsorber", "CoilSpring", "HydraulicDamper"]);
    }

    #[test]
    fn names_are_unique() {
        for model in catalogue::models() {
            let terminals = of(model, Version::Three).unwrap();
            let names: BTreeSet<&String> = terminals.iter().map(|terminal| &terminal.name).collect();
            assert_eq!(names.len(), terminals.len());
            for terminal in &terminals {
                let members: BTreeSet<&String> = terminal.members.iter().map(|member| &member[1]).collect();
                assert_eq!(members.len(), terminal.members.len(), "{}: {}", model.name, terminal.name);
            }
        }
    }
}
