//! The description of a system in SSP 1.0 (section "System Structure Description"). The prefixes are fixed: libcosim and
//! Ecos look for `ssd:`, `ssc:` and `ssv:`.

use serde::Serialize;
use stribeck::model::Role;

use super::{Quantity, System, SystemError, fmu};
use crate::units::Units;
use crate::xml::{self, COMMON};

const DESCRIPTION: &str = "http://ssp-standard.org/SSP1/SystemStructureDescription";

#[derive(Serialize)]
#[serde(rename = "ssd:SystemStructureDescription")]
struct Document<'a> {
    #[serde(rename = "@xmlns:ssd")]
    description: &'static str,
    #[serde(rename = "@xmlns:ssc")]
    common: &'static str,
    #[serde(rename = "@version")]
    version: &'static str,
    #[serde(rename = "@name")]
    name: &'a str,
    #[serde(rename = "@generationTool")]
    tool: &'static str,
    #[serde(rename = "ssd:System")]
    system: Content<'a>,
    #[serde(rename = "ssd:Units", skip_serializing_if = "Option::is_none")]
    units: Option<Units>,
    #[serde(rename = "ssd:DefaultExperiment")]
    experiment: Experiment,
}

#[derive(Serialize)]
struct Content<'a> {
    #[serde(rename = "@name")]
    name: &'a str,
    #[serde(rename = "@description")]
    description: &'a str,
    #[serde(rename = "ssd:Elements")]
    elements: Elements<'a>,
    #[serde(rename = "ssd:Connections")]
    connections: Connections<'a>,
}

#[derive(Serialize)]
struct Elements<'a> {
    #[serde(rename = "ssd:Component")]
    components: Vec<Component<'a>>,
}

#[derive(Serialize)]
struct Component<'a> {
    #[serde(rename = "@name")]
    name: &'a str,
    #[serde(rename = "@type")]
    kind: &'static str,
    #[serde(rename = "@source")]
    source: String,
    #[serde(rename = "ssd:Connectors")]
    connectors: Connectors,
    #[serde(rename = "ssd:ParameterBindings", skip_serializing_if = "Option::is_none")]
    parameters: Option<Bindings<'a>>,
}

#[derive(Serialize)]
struct Connectors {
    #[serde(rename = "ssd:Connector")]
    connectors: Vec<Connector>,
}

#[derive(Serialize)]
struct Connector {
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "@kind")]
    kind: &'static str,
    #[serde(rename = "ssc:Real")]
    quantity: Real,
}

#[derive(Serialize)]
struct Real {
    #[serde(rename = "@unit")]
    unit: &'static str,
}

#[derive(Serialize)]
struct Bindings<'a> {
    #[serde(rename = "ssd:ParameterBinding")]
    binding: Binding<'a>,
}

#[derive(Serialize)]
struct Binding<'a> {
    #[serde(rename = "@source")]
    source: &'a str,
}

#[derive(Serialize)]
struct Connections<'a> {
    #[serde(rename = "ssd:Connection")]
    connections: Vec<Connection<'a>>,
}

#[derive(Serialize)]
struct Connection<'a> {
    #[serde(rename = "@startElement")]
    start_element: &'a str,
    #[serde(rename = "@startConnector")]
    start_connector: &'a str,
    #[serde(rename = "@endElement")]
    end_element: &'a str,
    #[serde(rename = "@endConnector")]
    end_connector: &'a str,
}

#[derive(Serialize)]
struct Experiment {
    #[serde(rename = "@startTime")]
    start: f64,
    #[serde(rename = "@stopTime")]
    stop: f64,
}

/// The text of the description.
pub fn text(system: &System) -> Result<String, SystemError> {
    system.check()?;
    let mut components = Vec::new();
    let mut units = Vec::new();
    for component in &system.components {
        let ports: Vec<_> = system.connectors(component)?.collect();
        units.extend(ports.iter().map(|(_, unit)| *unit));
        components.push(Component {
            name: &component.name,
            kind: "application/x-fmu-sharedlibrary",
            source: fmu(component.model),
            connectors: Connectors { connectors: ports.into_iter().map(connector).collect() },
            parameters: component.parameters.as_ref().map(|(file, _)| Bindings { binding: Binding { source: file } }),
        });
    }
    Ok(xml::text(&Document {
        description: DESCRIPTION,
        common: COMMON,
        version: "1.0",
        name: system.name,
        tool: concat!("Stribeck ", env!("CARGO_PKG_VERSION")),
        system: Content {
            name: system.name,
            description: system.description,
            elements: Elements { components },
            connections: connections(system),
        },
        units: Units::of(units),
        experiment: Experiment { start: 0.0, stop: system.stop_time },
    }))
}

fn connector((variable, unit): Quantity) -> Connector {
    let kind = if variable.role == Role::Input { "input" } else { "output" };
    Connector { name: variable.path.to_string(), kind, quantity: Real { unit: unit.name } }
}

fn connections(system: &System) -> Connections<'_> {
    let connections = system.connections.iter().map(|[from, to]| Connection {
        start_element: &from.component,
        start_connector: &from.variable,
        end_element: &to.component,
        end_connector: &to.variable,
    });
    Connections { connections: connections.collect() }
}
