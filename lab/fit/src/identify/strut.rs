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

use super::levels::levels_by_direction;
use super::parameter::{is_level, refused};
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
    match falling.filter(is_determined) {
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
        ..Experiment::default()
    }
}

impl StrutFriction {
    /// Translates the fit into values of the strut.
    pub(super) fn transfer(&mut self, strut: &'static ModelType, mu: f64) -> Result<(), Fault> {
        let law = self.fit.law;
        if levels_by_direction(law).is_some() {
            return Err(refused(law, "has a level for each direction, and a contact of the strut has one for both"));
        }
        let estimate = |meaning: Meaning| {
            let is_it = |one: &&Estimate| one.meaning == meaning && matches!(one.target, Target::Column(_));
            self.fit.estimates.iter().find(is_it)
        };
        let kinetic = estimate(Meaning::KineticLevel);
        let reason = || kinetic.map_or("the law has none".to_owned(), |one| one.verdict.to_string());
        let unknown = || refused(law, format_args!("mu_k, on which all levels depend: {}", reason()));
        let kinetic = kinetic.filter(is_determined).ok_or_else(unknown)?.value;
        let level = kinetic * self.load * SHARE;
        let starts = ParameterSet::starts(strut, ["c1.preload_k", "c1.preload_s"]).map_err(Fault::value)?;
        let ratio = match estimate(Meaning::StaticLevel) {
            Some(one) if is_determined(&one) => one.value / kinetic,
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
        for one in &self.fit.estimates {
            let is_level =
                one.meaning == Meaning::KineticLevel || one.meaning == Meaning::StaticLevel && is_determined(&one);
            if is_level || !matches!(one.target, Target::Column(_)) {
                continue;
            }
            // The strut may have fewer elements than the law.
            match in_strut(strut, self.fit.law.name, &one.name).filter(|_| is_determined(&one)) {
                Some(name) => self.values.push((name, factor(one, kinetic, mu) * one.value)),
                None => self.left.push(one.name.clone()),
            }
        }
    }
}

/// Factor of a parameter in a contact of the strut, which has its own mu and a load that gives the same level.
fn factor(one: &Estimate, kinetic: f64, mu: f64) -> f64 {
    match one.unit {
        "N" => kinetic / mu * SHARE,
        _ if is_level(one.meaning) => mu / kinetic,
        // Stiffness, damping, rates of a force: they add up over the contacts.
        unit if unit.starts_with("N/") || unit.starts_with("N.") => SHARE,
        _ => 1.0,
    }
}

fn is_determined(one: &&Estimate) -> bool {
    one.verdict == Verdict::Determined
}

/// Name of a parameter of a law in the strut, if it is there: its own, if its default differs from the one that the laws
/// share.
fn in_strut(strut: &ModelType, law: &str, name: &str) -> Option<String> {
    let names = [format!("friction.{law}.{name}"), format!("friction.{name}")];
    names.into_iter().find(|name| strut.find(name).is_some())
}
