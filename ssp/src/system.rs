//! A system of FMUs as an SSP 1.0 package (System Structure and Parameterization): components, the connections between
//! them, and parameter sets. One package may hold several variants of a system, each with its own description.

mod ssd;

use std::collections::{BTreeMap, BTreeSet};

use stribeck::catalogue;
use stribeck::model::{ModelType, Role, Variable};
use stribeck::unit::Unit;
use thiserror::Error;

use crate::parameter_set::ParameterSet;
use crate::units::unit_of;

/// A system whose components are models of this library.
pub struct System {
    /// Name of the package.
    pub name: &'static str,
    /// Description in one line.
    pub description: &'static str,
    /// End of the default experiment, s.
    pub stop_time: f64,
    /// The components.
    pub components: Vec<Component>,
    /// From an output to an input, each as component and variable.
    pub connections: Vec<[Port; 2]>,
}

/// A model under a name.
pub struct Component {
    /// Name of the component.
    pub name: String,
    /// Name of the model.
    pub model: &'static str,
    /// Parameters, in a separate file.
    pub parameters: Option<(String, ParameterSet)>,
}

/// Reason why a system was rejected.
#[derive(Debug, Error)]
pub enum SystemError {
    /// The system has no component of this name.
    #[error("no component {0}")]
    Component(String),
    /// The library has no such model.
    #[error("unknown model {0}")]
    Model(&'static str),
    /// The model has no such variable.
    #[error("{model} has no variable {name}")]
    Variable {
        /// The model.
        model: &'static str,
        /// The requested name.
        name: String,
    },
    /// A connection begins at something else.
    #[error("{}: {} is not an output", .0.component, .0.variable)]
    Output(Port),
    /// A connection ends at something else.
    #[error("{}: {} is not an input", .0.component, .0.variable)]
    Input(Port),
    /// A connection joins different quantities, or things that are not quantities.
    #[error("{from} and {to} are not physical quantities of the same unit")]
    Unit {
        /// The output.
        from: String,
        /// The input.
        to: String,
    },
    /// An input has two sources.
    #[error("{}: {} is connected twice", .0.component, .0.variable)]
    Twice(Port),
}

/// A variable with its unit.
type Quantity = (Variable, &'static Unit);

/// A variable of a component.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Port {
    /// Name of the component.
    pub component: String,
    /// Name of the variable.
    pub variable: String,
}

impl System {
    /// Adds a description of this system, under a name, and its parameter sets to the files of a package. The one that
    /// tools open is called `SystemStructure`.
    pub fn add_to(&self, files: &mut BTreeMap<String, Vec<u8>>, name: &str) -> Result<(), SystemError> {
        files.insert(format!("{name}.ssd"), ssd::text(self)?.into_bytes());
        for (file, set) in self.components.iter().filter_map(|component| component.parameters.as_ref()) {
            files.insert(file.clone(), set.to_ssv().into_bytes());
        }
        Ok(())
    }

    /// The models of the components, each once.
    pub fn models(&self) -> BTreeSet<&'static str> {
        self.components.iter().map(|component| component.model).collect()
    }

    /// Rejects connections that do not lead from an output to an input of the same quantity, and inputs that are
    /// connected twice.
    fn check(&self) -> Result<(), SystemError> {
        let mut connected = BTreeSet::new();
        for [from, to] in &self.connections {
            let [output, input] = [self.variable(from)?, self.variable(to)?];
            if !output.role.is_output() {
                return Err(SystemError::Output(from.clone()));
            }
            if input.role != Role::Input {
                return Err(SystemError::Input(to.clone()));
            }
            if unit_of(&output).is_none() || output.kind != input.kind {
                return Err(SystemError::Unit { from: from.variable.clone(), to: to.variable.clone() });
            }
            if !connected.insert(to) {
                return Err(SystemError::Twice(to.clone()));
            }
        }
        Ok(())
    }

    fn variable(&self, port: &Port) -> Result<Variable, SystemError> {
        let component = self.components.iter().find(|component| component.name == port.component);
        let model = component.ok_or_else(|| SystemError::Component(port.component.clone()))?.model()?;
        let unknown = || SystemError::Variable { model: model.name, name: port.variable.clone() };
        Ok(model.table.at(model.find(&port.variable).ok_or_else(unknown)?))
    }

    /// Connected inputs, and all outputs that are physical quantities: those not connected can still be observed.
    fn connectors(&self, component: &Component) -> Result<impl Iterator<Item = Quantity>, SystemError> {
        let is_connected = |variable: &Variable| {
            let name = variable.path.to_string();
            self.connections.iter().any(|[_, to]| to.component == component.name && to.variable == name)
        };
        let table = component.model()?.table.iter();
        let ports = table.filter(move |variable| variable.role.is_output() || is_connected(variable));
        Ok(ports.filter_map(|variable| Some((variable, unit_of(&variable)?))))
    }
}

impl Component {
    fn model(&self) -> Result<&'static ModelType, SystemError> {
        catalogue::by_name(self.model).ok_or(SystemError::Model(self.model))
    }
}

/// Place of a model's FMU in the package.
pub fn fmu(model: &str) -> String {
    format!("resources/{model}.fmu")
}
