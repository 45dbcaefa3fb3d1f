//! `stribeck damper`: converts a damper test into a parameter set.

use std::path::PathBuf;

use clap::Args;
use stribeck_fit::dyno::{Damper, DynoError, Friction, Test};
use stribeck_fit::identify::StrutFriction;
use stribeck_fit::identify::damper::{Answer, DamperError, Inquiry};

use crate::command::{Description, Failure};
use crate::outputs;

/// A damper test, and the file for its results.
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    inquiry: Inquiry,
    #[command(flatten)]
    description: Description,
    /// Parameter set to write: set.csv or set.ssv
    #[arg(long)]
    out: Option<PathBuf>,
}

/// Identifies the damper, prints it and writes the set.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    arguments.out.as_ref().map_or(Ok(()), |out| outputs::file(out, &["csv", "ssv"]))?;
    let inquiry = arguments.description.complete(&arguments.inquiry)?;
    let path = inquiry.file()?;
    let refused = |error: DamperError| Failure::of_file(path, &error);
    let Answer { test, damper, friction } = inquiry.answer().map_err(refused)?;
    print!("{}{}", report(&test, &damper), friction.as_ref().map_or(String::new(), strokes));
    if let Some(out) = &arguments.out {
        let name = out.file_stem().unwrap_or_default().to_string_lossy();
        let instead = friction.map_or_else(Vec::new, |friction| friction.values);
        let set = damper.parameter_set_with(&name, &instead).map_err(|error| refused(error.into()))?;
        set.save(out).map_err(|error| refused(DynoError::from(error).into()))?;
        println!("\n{}", out.display());
    }
    Ok(())
}

fn strokes(friction: &StrutFriction) -> String {
    let mut text =
        format!("\nslow strokes, at a mean normal force of {:.1} N:\n{}", friction.load, friction.fit.table());
    if !friction.left.is_empty() {
        text += &format!("not determined, the strut keeps its defaults: {}\n", friction.left.join(", "));
    }
    text
}

/// Report of the results.
fn report(test: &Test, damper: &Damper) -> String {
    let mut text = test.note.as_ref().map_or(String::new(), |note| format!("{note}\n"));
    text += &format!("{} samples; the force is the {}\n\n", test.velocity.len(), damper.force_sign);
    text += "velocity (extension > 0)   resistance\n";
    for (velocity, force) in &damper.table {
        text += &format!("{velocity:>16.4} m/s {force:>12.1} N\n");
    }
    text += "\n";
    text += &damper.friction.as_ref().map_or(String::new(), friction_line);
    if let Some(gas) = damper.gas_force {
        text += &format!("gas force   {:.1} N, standard deviation {:.1} N\n", gas.value, gas.deviation);
    }
    if let Some(gradient) = damper.gradient {
        let [value, deviation] = [gradient.value, gradient.deviation];
        text += &format!("gradient    {value:.0} N/m, standard deviation {deviation:.0} N/m (gas, lag of the oil)\n");
    }
    text += &format!("difference  {:.1} N (root mean square), {:.1} N (largest)\n", damper.rms_error, damper.max_error);
    damper.warnings.iter().for_each(|warning| text += &format!("warning: {warning}\n"));
    text
}

fn friction_line(Friction { level, asymmetry }: &Friction) -> String {
    let directions = match asymmetry {
        None => "the same in both directions, because the gas force is not given".to_owned(),
        Some(asymmetry) => {
            let [compression, extension] = [1.0 + asymmetry, 1.0 - asymmetry].map(|share| share * level.value);
            format!("{compression:.1} N in compression, {extension:.1} N in extension")
        }
    };
    format!("friction    {:.1} N, standard deviation {:.1} N; {directions}\n", level.value, level.deviation)
}

#[cfg(test)]
mod tests {
    use super::*;
    use stribeck_fit::dyno::{Estimate, ForceSign};

    #[test]
    fn reports_name_what_was_found_and_what_was_not() {
        let note = Some("read from sheet 'a'".to_owned());
        let test = Test { velocity: vec![0.0; 7], note, ..Test::default() };
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
        assert!(text.starts_with("read from sheet 'a'\n7 samples; the force is the reaction\n"), "{text}");
        assert!(text.contains(" -1.0000 m/s       -900.0 N\n"), "{text}");
        assert!(text.contains("deviation 0.5 N; 25.0 N in compression, 15.0 N in extension\n"), "{text}");
        assert!(!text.contains("gas force"), "{text}");
        assert!(text.ends_with("warning: too warm\n"), "{text}");
        let damper = Damper { friction: Some(Friction { level, asymmetry: None }), ..damper };
        assert!(report(&test, &damper).contains("because the gas force is not given"));
    }
}
