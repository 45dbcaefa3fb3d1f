//! `stribeck run`: a system with one law.

use stribeck_solve::run::Step;
use stribeck_solve::system::{Fault, System};

use super::choice::Arguments;
use super::step::find_steps;
use super::watch::heed_interrupts;
use super::{Failure, Verdict};

/// Runs a system, once or for each value of a variable.
pub fn run(arguments: &Arguments) -> Result<Verdict, Failure> {
    let choice = arguments.choice()?;
    if choice.run.law.len() > 1 {
        return Err(Fault::value("several laws: use `stribeck compare`").into());
    }
    heed_interrupts();
    let law = choice.run.law.first().map(String::as_str);
    // Whatever is refused is refused before the first run.
    let system = |value: Option<f64>| {
        let system = choice.system(law, value)?;
        System::refuse_unused(std::slice::from_ref(&system))?;
        Ok(system)
    };
    let systems: Vec<System> = match &choice.vary {
        Some(vary) => vary.values.iter().map(|value| system(Some(*value))).collect::<Result<_, Fault>>()?,
        None => vec![system(None)?],
    };
    if choice.run.step == Some(Step::Find) {
        return find_steps(&choice, &systems);
    }
    choice.conclude(systems, choice.vary.as_ref().map(|vary| vary.name.as_str()))
}
