//! A system of FMUs as an SSP 1.0 package (System Structure and Parameterization): components, the connections between
//! them, and parameter sets. One package may hold several variants of a system, each with its own description.

use std::collections::{BTreeMap, BTreeSet};

use anyhow::{Context, Result, ensure};
use lab::parameter_set::{ParameterSet, unit_definition};
use quick_xml::escape::escape;
use stribeck::catalogue;
use stribeck::model::{Kind, ModelType, Role, Variable};
use stribeck::unit::Unit;

use crate::pack::archive::Files;
use crate::project::VERSION;

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
    pub fn add_to(&self, files: &mut Files, name: &str) -> Result<()> {
        files.insert(format!("{name}.ssd"), self.description()?.into_bytes());
        for (file, set) in self.components.iter().filter_map(|component| component.parameters.as_ref()) {
            files.insert(file.clone(), set.to_ssv().into_bytes());
        }
        Ok(())
    }

    /// The models of the components, each once.
    pub fn models(&self) -> BTreeSet<&'static str> {
        self.components.iter().map(|component| component.model).collect()
    }

    /// The text of the description. The prefixes are fixed: libcosim and Ecos look for `ssd:`, `ssc:` and `ssv:`.
    fn description(&self) -> Result<String> {
        self.check()?;
        let mut text = format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
             <ssd:SystemStructureDescription\n\
             \x20   xmlns:ssd=\"http://ssp-standard.org/SSP1/SystemStructureDescription\"\n\
             \x20   xmlns:ssc=\"http://ssp-standard.org/SSP1/SystemStructureCommon\"\n\
             \x20   version=\"1.0\" name=\"{0}\" generationTool=\"Stribeck {VERSION}\">\n\
             \x20 <ssd:System name=\"{0}\" description=\"{1}\">\n\
             \x20   <ssd:Elements>\n",
            self.name,
            escape(self.description),
        );
        for component in &self.components {
            text += &self.element(component)?;
        }
        text += "    </ssd:Elements>\n    <ssd:Connections>\n";
        for [from, to] in &self.connections {
            text += &format!(
                "      <ssd:Connection startElement=\"{}\" startConnector=\"{}\" \
                 endElement=\"{}\" endConnector=\"{}\"/>\n",
                from.component, from.variable, to.component, to.variable
            );
        }
        let mut units = BTreeMap::new();
        for component in &self.components {
            units.extend(self.connectors(component)?.map(|(_, unit)| (unit.name, unit)));
        }
        let units: String = units.values().map(|unit| unit_definition(unit)).collect();
        text += &format!(
            "    </ssd:Connections>\n  </ssd:System>\n  <ssd:Units>\n{units}  </ssd:Units>\n\
             \x20 <ssd:DefaultExperiment startTime=\"0\" stopTime=\"{}\"/>\n</ssd:SystemStructureDescription>\n",
            self.stop_time
        );
        Ok(text)
    }

    /// Rejects connections that do not lead from an output to an input of the same quantity, and inputs that are
    /// connected twice.
    fn check(&self) -> Result<()> {
        let mut connected = BTreeSet::new();
        for [from, to] in &self.connections {
            let [output, input] = [self.variable(from)?, self.variable(to)?];
            ensure!(output.role.is_output(), "{}: {} is not an output", from.component, from.variable);
            ensure!(input.role == Role::Input, "{}: {} is not an input", to.component, to.variable);
            ensure!(
                real_unit(output).is_some() && output.kind == input.kind,
                "{} and {} are not physical quantities of the same unit",
                from.variable,
                to.variable
            );
            ensure!(connected.insert(to), "{}: {} is connected twice", to.component, to.variable);
        }
        Ok(())
    }

    fn variable(&self, port: &Port) -> Result<&'static Variable> {
        let component = self.components.iter().find(|component| component.name == port.component);
        let model = component.with_context(|| format!("no component {}", port.component))?.model()?;
        let column = model.find(&port.variable);
        Ok(&model.table[column.with_context(|| format!("{} has no variable {}", model.name, port.variable))?])
    }

    fn element(&self, component: &Component) -> Result<String> {
        let mut text = format!(
            "      <ssd:Component name=\"{}\" type=\"application/x-fmu-sharedlibrary\" source=\"{}\">\n\
             \x20       <ssd:Connectors>\n",
            component.name,
            fmu(component.model),
        );
        for (variable, unit) in self.connectors(component)? {
            let kind = if variable.role == Role::Input { "input" } else { "output" };
            text += &format!(
                "          <ssd:Connector name=\"{}\" kind=\"{kind}\"><ssc:Real unit=\"{}\"/></ssd:Connector>\n",
                variable.path, unit.name
            );
        }
        text += "        </ssd:Connectors>\n";
        if let Some((file, _)) = &component.parameters {
            text += &format!(
                "        <ssd:ParameterBindings>\n          <ssd:ParameterBinding source=\"{file}\"/>\n\
                 \x20       </ssd:ParameterBindings>\n"
            );
        }
        Ok(text + "      </ssd:Component>\n")
    }

    /// Connected inputs, and all outputs that are physical quantities: those not connected can still be observed.
    fn connectors(&self, component: &Component) -> Result<impl Iterator<Item = (&'static Variable, &'static Unit)>> {
        let is_connected = |variable: &Variable| {
            let name = variable.path.to_string();
            self.connections.iter().any(|[_, to]| to.component == component.name && to.variable == name)
        };
        let table = component.model()?.table.iter();
        let ports = table.filter(move |variable| variable.role.is_output() || is_connected(variable));
        Ok(ports.filter_map(|variable| Some((variable, real_unit(variable)?))))
    }
}

impl Component {
    fn model(&self) -> Result<&'static ModelType> {
        catalogue::by_name(self.model).with_context(|| format!("there is no model {}", self.model))
    }
}

/// Place of a model's FMU in the package.
pub fn fmu(model: &str) -> String {
    format!("resources/{model}.fmu")
}

fn real_unit(variable: &Variable) -> Option<&'static Unit> {
    match variable.kind {
        Kind::Real(unit) => Some(unit),
        _ => None,
    }
}
