//! `stribeck compare`: a system with several laws.

use stribeck_solve::run::Step;
use stribeck_solve::system::{Fault, System};

use super::choice::Arguments;
use super::step::find_steps;
use super::watch::heed_interrupts;
use super::{Failure, Verdict, laws};

/// Runs a system with each of several laws; with all of the catalogue if none is named.
pub fn compare(arguments: &Arguments) -> Result<Verdict, Failure> {
    let choice = arguments.choice()?;
    if choice.vary.is_some() {
        return Err(Fault::value("--vary: use `stribeck run`, for one law at a time").into());
    }
    heed_interrupts();
    let system = |law: &String| choice.system(Some(law), None);
    let systems = laws(&choice.run.law).iter().map(system).collect::<Result<Vec<System>, Fault>>()?;
    System::refuse_unused(&systems)?;
    if choice.run.step == Some(Step::Find) {
        return find_steps(&choice, &systems);
    }
    choice.conclude(systems, Some("law"))
}
