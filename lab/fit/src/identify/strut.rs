//! The friction law of a strut, from the slow strokes of a test on a dynamometer.
//!
//! # Equations
//! The damper that was found in the test ([`crate::dyno`]) takes table, gas force and gradient away; what is left is
//! friction, to which the law is fitted at the load that the strut gives it:
//!
//! ```text
//! f_n = F_C / mu (1 - alpha sgn v)
//! ```
//!
//! with the level F_C and the asymmetry alpha of the damper, and the coefficient mu that the contacts of the strut have
//! by default. A constant offset is fitted too: it takes what is left of the gas force. Viscous parts are held at 0,
//! since the damper table has them.
//!
//! The strut has two contacts with the same velocity. They get half the level each, and half of every quantity that
//! adds up over contacts (stiffness, damping), so that without side load both together are the fitted law.

use ssp::parameter_set::{ParameterSet, choice};
use stribeck::model::{Meaning, ModelType, Variable};

use super::parameter::is_level;
use super::{Estimate, Experiment, Fit, Selection, Settings, Target, Verdict, Watch, fit};
use crate::dyno::{Damper, Options, Stroke, Test, find_damper, shock_absorber, slow_strokes};
use stribeck_solve::system::Fault;

/// A friction law in a strut.
#[derive(Clone, Debug)]
pub struct StrutFriction {
    /// The damper.
    pub damper: Damper,
    /// The law fitted to the slow strokes.
    pub fit: Fit,
    /// Mean normal force for which its coefficients hold, N: with it, the coefficient of the shock absorber gives the level.
    pub load: f64,
    /// Values of the shock absorber that follow from it.
    pub values: Vec<(String, f64)>,
    /// Parameters that the test does not determine: the shock absorber keeps its defaults.
    pub left: Vec<String>,
}

/// The contacts of the strut.
const CONTACTS: [&str; 2] = ["c1", "c2"];

/// Part of the level, and of what adds up over contacts, that each of them gets.
const SHARE: f64 = 1.0 / CONTACTS.len() as f64;

/// Names of the parameters of a law that are viscous.
pub(super) fn viscous(law: &ModelType) -> Vec<String> {
    let is_viscous = |one: &Variable| [Meaning::Viscous, Meaning::GrowsWithSpeed].contains(&one.meaning);
    law.table.iter().filter(is_viscous).map(|one| one.path.to_string()).collect()
}

/// Stribeck velocities above which friction no longer falls with speed: the rest is below exp(-9) (chosen).
const FALLEN: f64 = 3.0;

/// Finds the damper in a test and fits a law to its slow strokes. Where friction falls with speed, the level that is
/// extrapolated to rest would be too high, and the table too low: both are then found once more, from faster samples.
pub fn strut_friction(
    law: &'static ModelType,
    test: &Test,
    options: &Options,
    task: &Settings,
    watch: Watch,
) -> Result<StrutFriction, Fault> {
    let once = |options: &Options| strut_friction_once(law, test, options, task, watch);
    let first = once(options)?;
    let falling = first.fit.estimates.iter().find(|one| one.meaning == Meaning::FallSpeed);
    match falling.filter(is_told) {
        Some(one) if FALLEN * one.value < options.low_speed => {
            once(&Options { falling: FALLEN * one.value, ..*options })
        }
        _ => Ok(first),
    }
}

fn strut_friction_once(
    law: &'static ModelType,
    test: &Test,
    options: &Options,
    task: &Settings,
    watch: Watch,
) -> Result<StrutFriction, Fault> {
    let strut = shock_absorber().map_err(Fault::value)?;
    let chosen = choice(strut, "friction.model", law.name).map_err(Fault::value)?;
    let damper = find_damper(test, options).map_err(Fault::value)?;
    let Some(friction) = damper.friction else {
        return Err(Fault::value("no level of friction was found, so that no law can be fitted"));
    };
    let [mu] = ParameterSet::starts(strut, ["c1.mu_k"]).map_err(Fault::value)?;
    let load = friction.level.value / mu;
    let asymmetry = friction.asymmetry.unwrap_or(0.0);
    let strokes = slow_strokes(test, options, &damper).map_err(Fault::value)?;
    let experiments: Vec<Experiment> = strokes.iter().map(|stroke| experiment(stroke, load, asymmetry)).collect();
    let mut selection = Selection { fitted: vec!["offset".to_owned()], ..task.selection.clone() };
    selection.fixed.extend(viscous(law).into_iter().map(|name| (name, 0.0)));
    let fit = fit(law, &experiments, &Settings { selection, mass: 0.0, ..task.clone() }, watch)?;
    let values = vec![("friction.model".to_owned(), chosen)];
    let mut found = StrutFriction { damper, values, left: Vec::new(), fit, load };
    found.transfer(strut, mu)?;
    Ok(found)
}

fn experiment(stroke: &Stroke, load: f64, asymmetry: f64) -> Experiment {
    let [first, last] = [stroke.time[0], stroke.time[stroke.time.len() - 1]];
    let direction = |v: f64| if v == 0.0 { 0.0 } else { v.signum() };
    Experiment {
        name: format!("{first:.2} s to {last:.2} s"),
        time: stroke.time.clone(),
        velocity: stroke.velocity.clone(),
        acceleration: vec![0.0; stroke.time.len()],
        normal_force: stroke.velocity.iter().map(|v| load * (1.0 - asymmetry * direction(*v))).collect(),
        force: stroke.friction_force.clone(),
        velocity_error: 0.0,
        acceleration_error: 0.0,
        acceleration_lost: 0.0,
        delay: 0.0,
        delay_range: None,
        left_out: Vec::new(),
        rest: super::experiment::Rest::default(),
        reach: 0.0,
        ends: super::experiment::EVERYWHERE,
        window: 0.0,
        alike: None,
    }
}

impl StrutFriction {
    /// Translates the fit into values of the strut.
    pub(super) fn transfer(&mut self, strut: &'static ModelType, mu: f64) -> Result<(), Fault> {
        let law = self.fit.law;
        let told = |meaning: Meaning| {
            let is_it = |one: &&Estimate| one.meaning == meaning && matches!(one.target, Target::Column(_));
            self.fit.estimates.iter().find(is_it)
        };
        let kinetic = told(Meaning::KineticLevel);
        let Some(kinetic) = kinetic.filter(is_told).map(|one| one.value) else {
            let reason = kinetic.map_or("the law has none".to_owned(), |one| one.verdict.to_string());
            return Err(Fault::value(format_args!("{}: mu_k, on which all levels depend: {reason}", law.name)));
        };
        let level = kinetic * self.load * SHARE;
        let starts = ["c1.preload_k", "c1.preload_s"];
        let starts = ParameterSet::starts(strut, starts).map_err(Fault::value)?;
        let ratio = match told(Meaning::StaticLevel) {
            Some(one) if is_told(&one) => one.value / kinetic,
            // Not seen: as for a test that has no slow strokes.
            _ => starts[1] / starts[0],
        };
        for contact in CONTACTS {
            self.values.push((format!("{contact}.preload_k"), level));
            self.values.push((format!("{contact}.preload_s"), ratio * level));
        }
        self.others(strut, kinetic, mu);
        for name in viscous(law) {
            self.values.extend(in_strut(strut, law.name, &name).map(|name| (name, 0.0)));
        }
        Ok(())
    }

    /// The other parameters, each by its unit.
    fn others(&mut self, strut: &'static ModelType, kinetic: f64, mu: f64) {
        let law = self.fit.law;
        for one in &self.fit.estimates {
            match (one.target, one.meaning) {
                (_, Meaning::KineticLevel) => {}
                (Target::Column(_), Meaning::StaticLevel) if is_told(&one) => {}
                (Target::Column(_), _) if is_told(&one) => {
                    let unit = one.unit;
                    let factor = match unit {
                        // The strut has its own mu and a load that gives the same level.
                        "N" => kinetic / mu * SHARE,
                        _ if is_level(one.meaning) => mu / kinetic,
                        // Stiffness, damping, rates of a force: they add up over the contacts.
                        _ if unit.starts_with("N/") || unit.starts_with("N.") => SHARE,
                        _ => 1.0,
                    };
                    match in_strut(strut, law.name, &one.name) {
                        Some(name) => self.values.push((name, factor * one.value)),
                        // Elements beyond those that the strut has.
                        None => self.left.push(one.name.clone()),
                    }
                }
                (Target::Column(_), _) => self.left.push(one.name.clone()),
                _ => {}
            }
        }
    }
}

fn is_told(one: &&Estimate) -> bool {
    one.verdict == Verdict::Determined
}

/// Name of a parameter of a law in the strut, if it is there: its own, if its default differs from the one that the laws
/// share.
fn in_strut(strut: &ModelType, law: &str, name: &str) -> Option<String> {
    let names = [format!("friction.{law}.{name}"), format!("friction.{name}")];
    names.into_iter().find(|name| strut.find(name).is_some())
}
