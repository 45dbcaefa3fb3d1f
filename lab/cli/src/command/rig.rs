//! `stribeck rig`: records of a virtual rig.

use std::path::PathBuf;

use clap::Args;
use stribeck::catalogue;
use stribeck_fit::rig::{Faults, VirtualRig};
use stribeck_solve::run::Configuration;
use stribeck_solve::system::{Fault, Setting};

use super::{Failure, Verdict, write};

/// The rig, the law it has, and the folder for its files.
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
    /// Hysteresis, ripple of the load, drift, and a camera instead of an encoder, besides the noise
    #[arg(long)]
    faults: bool,
    /// Noise of the load cell, as a part of the largest force
    #[arg(long, default_value_t = Faults::NOISE.noise)]
    noise: f64,
    /// Seed of the noise
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Folder for force.csv, camera.csv and truth.toml
    #[arg(long, short)]
    out: PathBuf,
}

/// Writes the records of a virtual rig, and its truth.
pub fn rig(arguments: &Arguments) -> Result<Verdict, Failure> {
    let known = || stribeck_fit::identify::laws().map(|law| law.name);
    let law = catalogue::by_name(&arguments.law).filter(|law| known().any(|name| name == law.name));
    let law = law.ok_or_else(|| Fault::unknown("friction law", &arguments.law, known()))?;
    let values = arguments.set.iter().map(Setting::number).collect::<Result<Vec<(String, f64)>, Fault>>()?;
    let faults = if arguments.faults { Faults::ALL } else { Faults::NOISE };
    let rig = VirtualRig {
        law,
        values: values.clone(),
        mass: arguments.mass,
        normal_force: arguments.normal_force,
        duration: arguments.duration,
        faults: Faults { noise: arguments.noise, ..faults },
        seed: arguments.seed,
    };
    let files = rig.record()?;
    let folder = &arguments.out;
    std::fs::create_dir_all(folder).map_err(|source| Failure::File { path: folder.clone(), source })?;
    write(&folder.join("force.csv"), files.force)?;
    if let Some(camera) = files.camera {
        write(&folder.join("camera.csv"), camera)?;
    }
    let starts = law.variables().filter(|(_, variable)| variable.role.is_parameter());
    let starts = starts.filter(|(_, variable)| matches!(variable.kind, stribeck::model::Kind::Real(_)));
    let starts = starts.map(|(_, variable)| (variable.path.to_string(), variable.start));
    let set = starts.chain(values).map(|(name, value)| (name, toml::Value::Float(value))).collect();
    let truth = Configuration { law: vec![law.name.to_owned()], set, ..Configuration::default() };
    write(&folder.join("truth.toml"), truth.text())?;
    Ok(Verdict::Done)
}
