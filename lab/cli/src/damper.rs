//! `stribeck damper`: turns a damper test into a parameter set.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::{Args, ValueEnum};
use stribeck_fit::dyno::{Damper, DynoError, ForceSign, Options, Test, find_damper};
use stribeck_fit::identify::{StrutFriction, Task, Watch, laws_named, strut_friction};
use stribeck_solve::system::Fault;
use thiserror::Error;

use crate::outputs;

#[derive(Args)]
pub struct Arguments {
    /// Table with the columns velocity and force, optionally displacement and temperature; units in brackets.
    pub file: PathBuf,
    /// Parameter set to write: set.csv or set.ssv.
    #[arg(long)]
    out: Option<PathBuf>,
    /// Number of points of the damper table, including 0 (3 to 16).
    #[arg(long, default_value_t = Options::default().points)]
    points: usize,
    /// Velocity and displacement in the file are positive in compression.
    #[arg(long)]
    compression_positive: bool,
    /// Reject a file unless its force has this sign.
    #[arg(long)]
    force_sign: Option<Sign>,
    /// Speed below which samples distinguish friction from damping, in m/s.
    #[arg(long, default_value_t = Options::default().low_speed)]
    low_speed: f64,
    /// Gas force, in N, mean of both ends of the stroke; separates the friction of the two directions.
    #[arg(long)]
    gas_force: Option<f64>,
    /// Friction law of the strut, fitted to the strokes below the low speed; the file needs a column time.
    #[arg(long)]
    law: Option<String>,
    /// Seed of the search for its parameters.
    #[arg(long, default_value_t = Task::default().seed)]
    seed: u64,
}

/// Reason why no set was written.
#[derive(Debug, Error)]
pub enum DamperError {
    /// No damper was found.
    #[error(transparent)]
    Dyno(#[from] DynoError),
    /// No friction law was found, or the set cannot be written.
    #[error(transparent)]
    Fault(#[from] Fault),
}

#[derive(Clone, Copy, ValueEnum)]
enum Sign {
    /// The force has the sign of the velocity in the file.
    Resistance,
    /// The force has the opposite sign.
    Reaction,
}

impl From<Sign> for ForceSign {
    fn from(sign: Sign) -> ForceSign {
        match sign {
            Sign::Resistance => ForceSign::Resistance,
            Sign::Reaction => ForceSign::Reaction,
        }
    }
}

pub fn run(arguments: &Arguments) -> Result<(), DamperError> {
    let options = Options {
        compression_positive: arguments.compression_positive,
        force_sign: arguments.force_sign.map(ForceSign::from),
        points: arguments.points,
        low_speed: arguments.low_speed,
        falling: 0.0,
        gas_force: arguments.gas_force,
    };
    arguments.out.as_ref().map_or(Ok(()), |out| outputs::file(out, &["csv", "ssv"]))?;
    let test = Test::load(&arguments.file).map_err(DynoError::from)?;
    let mut damper = find_damper(&test, &options)?;
    let friction = arguments.law.as_ref().map(|law| fitted(law, arguments.seed, &test, &options)).transpose()?;
    if let Some(friction) = &friction {
        damper.clone_from(&friction.damper);
    }
    print!("{}", report(&test, &damper));
    if let Some(friction) = &friction {
        print!("\nslow strokes, at a mean normal force of {:.1} N:\n{}", friction.load, friction.fit.table(None));
        if !friction.left.is_empty() {
            println!("not determined, so that the strut keeps its defaults: {}", friction.left.join(", "));
        }
    }
    if let Some(out) = &arguments.out {
        let name = out.file_stem().unwrap_or_default().to_string_lossy();
        let instead = friction.map_or_else(Vec::new, |friction| friction.values);
        damper.parameter_set_with(&name, &instead)?.save(out).map_err(DynoError::from)?;
        println!("\n{}", out.display());
    }
    Ok(())
}

fn fitted(law: &str, seed: u64, test: &Test, options: &Options) -> Result<StrutFriction, Fault> {
    let [law] = laws_named(&[law.to_owned()])?[..] else {
        return Err(Fault::value(format_args!("--law {law}: must be one law")));
    };
    let never = AtomicBool::new(false);
    let watch = Watch { cancel: &never, progress: &|_, _| {} };
    strut_friction(law, test, options, &Task { seed, ..Task::default() }, watch)
}

/// Report of the results.
fn report(test: &Test, damper: &Damper) -> String {
    let mut text = format!("{} samples; the force is the {}\n\n", test.velocity.len(), damper.force_sign);
    text += "velocity (extension > 0)   resistance\n";
    for (velocity, force) in &damper.table {
        text += &format!("{velocity:>16.4} m/s {force:>12.1} N\n");
    }
    text += "\n";
    if let Some(friction) = damper.friction {
        let level = friction.level;
        text += &format!("friction    {:.1} N, standard deviation {:.1} N", level.value, level.deviation);
        text += &friction.asymmetry.map_or_else(
            || "; the same in both directions, because the gas force is not given\n".into(),
            |asymmetry| {
                let [compression, extension] = [1.0 + asymmetry, 1.0 - asymmetry].map(|share| share * level.value);
                format!("; {compression:.1} N in compression, {extension:.1} N in extension\n")
            },
        );
    }
    if let Some(gas) = damper.gas_force {
        text += &format!("gas force   {:.1} N, standard deviation {:.1} N\n", gas.value, gas.deviation);
    }
    if let Some(gradient) = damper.gradient {
        let [value, deviation] = [gradient.value, gradient.deviation];
        text += &format!("gradient    {value:.0} N/m, standard deviation {deviation:.0} N/m (gas, lag of the oil)\n");
    }
    text += &format!("difference  {:.1} N (root mean square), {:.1} N (largest)\n", damper.rms_error, damper.max_error);
    for warning in &damper.warnings {
        text += &format!("warning: {warning}\n");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use stribeck_fit::dyno::{Estimate, Friction};

    #[test]
    fn reports_name_what_was_found_and_what_was_not() {
        let test = Test { velocity: vec![0.0; 7], ..Test::default() };
        let level = Estimate { value: 20.0, deviation: 0.5 };
        let damper = Damper {
            table: vec![(-1.0, -900.0), (0.0, 0.0), (1.0, 1500.0)],
            friction: Some(Friction { level, asymmetry: Some(0.25) }),
            gas_force: None,
            gradient: None,
            force_sign: ForceSign::Reaction,
            rms_error: 1.25,
            max_error: 3.0,
            warnings: vec!["too warm".into()],
        };
        let text = report(&test, &damper);
        assert!(text.starts_with("7 samples; the force is the reaction\n"), "{text}");
        assert!(text.contains(" -1.0000 m/s       -900.0 N\n"), "{text}");
        assert!(text.contains("deviation 0.5 N; 25.0 N in compression, 15.0 N in extension\n"), "{text}");
        assert!(!text.contains("gas force"), "{text}");
        assert!(text.ends_with("warning: too warm\n"), "{text}");
        let damper = Damper { friction: Some(Friction { level, asymmetry: None }), ..damper };
        assert!(report(&test, &damper).contains("because the gas force is not given"));
    }
}
