//! `stribeck rig`: records of a virtual rig.

use std::path::PathBuf;

use clap::Args;
use stribeck::model::{Kind, ModelType, Variable};
use stribeck_fit::rig::{Faults, VirtualRig};
use stribeck_solve::run::Configuration;
use stribeck_solve::system::{Fault, Setting};

use super::{Failure, Verdict, write};

/// The virtual rig, its law, and the folder for its files.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// Friction law of the contact
    #[arg(long, default_value = "LuGre")]
    law: String,
    /// Value of a parameter of the law
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<Setting>,
    /// Mass between load cell and contact in kg
    #[arg(long, default_value_t = 2.0)]
    mass: f64,
    /// Normal force in N
    #[arg(long, default_value_t = 20.0)]
    normal_force: f64,
    /// Length of the record in s
    #[arg(long, default_value_t = 4.0)]
    duration: f64,
    /// Add hysteresis, ripple of the normal force and drift, and replace the encoder by a camera
    #[arg(long)]
    faults: bool,
    /// Standard deviation of the noise of the load cell, relative to the largest force
    #[arg(long, default_value_t = Faults::NOISE.noise)]
    noise: f64,
    /// Seed of the noise
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Folder for force.csv, camera.csv and truth.toml
    #[arg(long, short)]
    out: PathBuf,
}

/// Writes the records of a virtual rig and the true parameters.
pub fn rig(arguments: &Arguments) -> Result<Verdict, Failure> {
    let law = VirtualRig::law(&arguments.law)?;
    let values = arguments.set.iter().map(Setting::number).collect::<Result<Vec<(String, f64)>, Fault>>()?;
    let faults = if arguments.faults { Faults::ALL } else { Faults::NOISE };
    let Arguments { mass, normal_force, duration, noise, seed, .. } = *arguments;
    let faults = Faults { noise, ..faults };
    let rig = VirtualRig { law, values: values.clone(), mass, normal_force, duration, faults, seed };
    let files = rig.record()?;
    let folder = arguments.out.as_path();
    super::folder(folder)?;
    write(&folder.join("force.csv"), files.force)?;
    if let Some(camera) = files.camera {
        write(&folder.join("camera.csv"), camera)?;
    }
    write(&folder.join("truth.toml"), truth(law, values).text())?;
    Ok(Verdict::Done)
}

/// The real parameters of a law, with the given values.
fn truth(law: &ModelType, values: Vec<(String, f64)>) -> Configuration {
    let is_real = |variable: &Variable| variable.role.is_parameter() && matches!(variable.kind, Kind::Real(_));
    let starts = law.variables().filter(|(_, variable)| is_real(variable));
    let all = starts.map(|(_, variable)| (variable.path.to_string(), variable.start)).chain(values);
    let set = all.map(|(name, value)| (name, toml::Value::Float(value))).collect();
    Configuration { law: vec![law.name.to_owned()], set, ..Configuration::default() }
}
