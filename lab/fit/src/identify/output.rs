//! Results of a fit: parameter sets, differences from a reference, a table for a terminal.

use std::collections::BTreeMap;
use std::fmt::Write;

use ssp::parameter_set::ParameterSet;
use stribeck::instance::Instance;
use stribeck::model::ModelType;

use super::levels::pairs_of_levels;
use super::ports::Ports;
use super::response::forces;
use super::selection::OF_RIG;
use super::uncertainty::digits;
use super::{Estimate, Experiment, Fit, Searches, Verdict};
use stribeck_measured::{Direction, Movement, Record};
use stribeck_solve::run::Configuration;
use stribeck_solve::system::Fault;

/// Difference from a reference in both usual definitions, in percent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// |a - b| / |b|, with the reference b.
    pub to_reference: f64,
    /// |a - b| / ((a + b) / 2).
    pub to_mean: f64,
}

/// Difference of a value from a reference.
pub fn difference(value: f64, reference: f64) -> Difference {
    let apart = 100.0 * (value - reference).abs();
    Difference { to_reference: apart / reference.abs(), to_mean: apart / (0.5 * (value + reference)).abs() }
}

/// Values of parameters to compare with, by name.
pub type Reference = BTreeMap<String, f64>;

/// The values of a preset of a law; those it does not name are the start values.
pub fn preset(law: &ModelType, name: &str) -> Result<Reference, Fault> {
    let presets = law.presets;
    let found = presets.iter().find(|preset| preset.name == name);
    let preset = found.ok_or_else(|| {
        Fault::unknown(format!("{}: preset", law.name), name, presets.iter().map(|preset| preset.name))
    })?;
    let starts = law.variables().map(|(_, variable)| (variable.path.to_string(), variable.start));
    Ok(starts.chain(preset.values.iter().map(|(name, value)| ((*name).to_owned(), *value))).collect())
}

/// Friction force of a law with these values over the motion and the load of a record, with each interval between samples
/// divided into `parts`. Values of inputs and results are ignored, since the record has them.
pub fn respond(law: &'static ModelType, values: &Reference, record: &Record, parts: usize) -> Result<Vec<f64>, Fault> {
    let columns = parameters(law, values)?;
    let refused = |reason: &dyn std::fmt::Display| Fault::value(format_args!("{}: {reason}", law.name));
    let ports = Ports::of(law).ok_or_else(|| refused(&"only laws of one sliding direction can be fitted"))?;
    let experiment = Experiment::new("record", record);
    forces(&mut Instance::new(law), &ports, &columns, &experiment, parts).map_err(|reason| refused(&reason))
}

/// The columns of a law that are parameters, with these values of theirs; refuses a variable that the law does not have.
pub(super) fn parameters(law: &ModelType, values: &Reference) -> Result<Vec<(usize, f64)>, Fault> {
    let all: Vec<(String, usize)> =
        law.variables().map(|(column, variable)| (variable.path.to_string(), column)).collect();
    let mut columns = Vec::new();
    for (name, value) in values {
        let column = all.iter().find(|(known, _)| known == name).map(|(_, column)| *column);
        let column = column.ok_or_else(|| {
            Fault::unknown(format!("{}: variable", law.name), name, all.iter().map(|(name, _)| name.as_str()))
        })?;
        if law.table.at(column).role.is_parameter() {
            columns.push((column, *value));
        }
    }
    Ok(columns)
}

/// Values of a reference that a law has as parameters; None if it has none of them.
pub fn of_law(law: &ModelType, reference: &Reference) -> Option<Reference> {
    let is_known = |name: &str| law.find(name).is_some_and(|column| law.table.at(column).role.is_parameter());
    let known = reference.iter().filter(|(name, _)| is_known(name));
    let known: Reference = known.map(|(name, value)| (name.clone(), *value)).collect();
    (!known.is_empty()).then_some(known)
}

impl Fit {
    /// A record that was fitted, corrected: with the motion at the delay, and the friction force without the
    /// inertia and the offset, that were found.
    pub fn corrected(&self, record: &Record) -> Record {
        let as_is = Experiment::new("record", record);
        let by = self.physical.delay.filter(|_| as_is.delay_range.is_some()).map_or(0.0, |delay| delay - as_is.delay);
        let moved = as_is.with_delay(self.physical.delay).into_owned();
        let friction_force = self.without_inertia(&record.force, &moved.acceleration, moved.direction.as_ref());
        let displacement = record.displacement.iter().zip(&record.velocity).map(|(x, v)| x + by * v).collect();
        let Experiment { velocity, acceleration, direction, .. } = moved;
        Record { displacement, velocity, acceleration, direction, friction_force, ..record.clone() }
    }

    /// The same with the friction force that the law explains in it; its number is that of the experiments that were
    /// fitted.
    pub fn predicted_in(&self, corrected: &Record, number: usize) -> Record {
        let friction_force =
            self.without_inertia(&self.predicted[number], &corrected.acceleration, corrected.direction.as_ref());
        Record { friction_force, ..corrected.clone() }
    }

    /// Friction in forces of the load cell.
    fn without_inertia(&self, forces: &[f64], acceleration: &[f64], direction: Option<&Direction>) -> Vec<f64> {
        let friction = |(at, (force, a)): (usize, (&f64, &f64))| {
            force - (self.physical.mass * a + self.physical.offset) - self.physical.gravity_at(direction, at)
        };
        forces.iter().zip(acceleration).enumerate().map(friction).collect()
    }

    /// Name of a column of the law.
    pub fn name_of(&self, column: usize) -> String {
        self.law.table.at(column).path.to_string()
    }

    /// The parameters of the law that the data determine, and those that were held; what is not determined is left out.
    pub fn values(&self) -> Vec<(String, f64)> {
        // Some laws have a parameter mass as well, which is not that of the rig.
        let is_parameter = |column: usize| self.law.table.at(column).role.is_parameter();
        let is_of_law = |name: &str| !OF_RIG.contains(&name) && self.law.find(name).is_some_and(is_parameter);
        let is_determined = |one: &&Estimate| one.verdict == Verdict::Determined && is_of_law(&one.name);
        let held = self.held.iter().filter(|(column, _)| is_parameter(*column));
        let held = held.map(|(column, value)| (self.name_of(*column), *value));
        let determined = self.estimates.iter().filter(is_determined).map(|one| (one.name.clone(), one.value));
        held.chain(determined).collect()
    }

    /// Names of static and kinetic levels with the kinetic one, where the static one is not determined and has a start
    /// value below it: the law takes no less.
    fn least_static(&self) -> Vec<([String; 2], f64)> {
        let values = self.values();
        let value = |name: &str| values.iter().find(|(known, _)| known == name).map(|(_, value)| *value);
        let least = |pair: [usize; 2]| {
            let names = pair.map(|column| self.name_of(column));
            let is_open = value(&names[0]).is_none();
            let kinetic = value(&names[1]).filter(|kinetic| is_open && self.law.table.at(pair[0]).start < *kinetic)?;
            Some((names, kinetic))
        };
        pairs_of_levels(self.law).into_iter().filter_map(least).collect()
    }

    /// Says so.
    pub(super) fn static_warnings(&self) -> Vec<String> {
        let text = |([level, kinetic], least): ([String; 2], f64)| {
            format!(
                "{level} is not determined, and the law refuses its start value, which is below {kinetic}: parameter \
                 sets have {level} = {}, the kinetic level",
                digits(least)
            )
        };
        self.least_static().into_iter().map(text).collect()
    }

    /// The values, with the kinetic level for the static one where the law refuses its start value.
    pub(super) fn accepted(&self) -> Vec<(String, f64)> {
        let least = self.least_static().into_iter().map(|([level, _], least)| (level, least));
        self.values().into_iter().chain(least).collect()
    }

    /// The same as a parameter set, for the FMU and the C library.
    pub fn parameter_set(&self, name: &str) -> Result<ParameterSet, Fault> {
        ParameterSet::new(self.law, name, self.accepted()).map_err(Fault::value)
    }

    /// The same for `stribeck run --config`; of an axis for the system `axis`, with its mass and offset.
    pub fn configuration(&self) -> Configuration {
        let of_rig = self.axis().into_iter().map(|(name, value)| (format!("axis.{name}"), value));
        let set = self.accepted().into_iter().chain(of_rig);
        Configuration {
            system: self.axis_load.map(|_| "axis".to_owned()),
            law: vec![self.law.name.to_owned()],
            set: set.map(|(name, value)| (name, toml::Value::Float(value))).collect(),
            ..Configuration::default()
        }
    }

    /// Known parameters of an axis besides those of its friction.
    fn axis(&self) -> Vec<(&'static str, f64)> {
        let Some(load) = self.axis_load else { return Vec::new() };
        let is_known = |name: &str| self.undetermined().all(|open| open != name);
        let all = [("mass", self.physical.mass), ("offset", self.physical.offset), ("guide_force", load)];
        all.into_iter().filter(|(name, _)| is_known(name)).collect()
    }

    /// Tells what a coefficient of friction is if the normal force is only a unit.
    pub fn note(&self) -> Option<String> {
        let load = self.axis_load.filter(|load| *load == super::axis::NORMAL_FORCE)?;
        Some(match self.movement {
            Movement::Translation => {
                format!("at a normal force of {load} N a coefficient of friction, mu_k, is the friction force in N")
            }
            Movement::Rotation => {
                format!("at a load of {load} N.m a coefficient of friction, mu_k, is the friction torque in N.m")
            }
        })
    }

    /// Names of the parameters that have no number.
    pub fn undetermined(&self) -> impl Iterator<Item = &str> {
        let is_open = |one: &&Estimate| one.verdict != Verdict::Determined;
        self.estimates.iter().filter(is_open).map(|one| one.name.as_str())
    }

    /// The values beside which it was fitted, if any were given.
    pub fn reference(&self) -> Option<&Reference> {
        self.judgement.as_ref().filter(|one| one.fit_rms.is_some()).map(|one| &one.values)
    }

    /// The fit as a table for a terminal, with the differences from a reference if one was given.
    pub fn table(&self) -> String {
        let (mut text, reference) = (self.heading(), self.reference());
        let width = self.estimates.iter().map(|one| one.name.len()).max().unwrap_or(0);
        for one in &self.estimates {
            let _ =
                writeln!(text, "  {:<width$}  {}{}", one.name, text_of(one, self.searches), compared(one, reference));
        }
        for note in self.note().iter().map(String::as_str).chain(self.is_cancelled.then_some(EARLY)) {
            let _ = writeln!(text, "{note}");
        }
        for warning in &self.warnings {
            let _ = writeln!(text, "warning: {warning}");
        }
        text
    }

    /// Law, residuals and effort.
    fn heading(&self) -> String {
        let (left, [rms, level]) = (&self.residuals, [self.residuals.rms, self.level].map(digits));
        let unit = self.movement.unit("N");
        let mut text = format!("{}: RMS residual {rms} {unit} of {level} {unit} ", self.law.name);
        let _ = writeln!(text, "({} samples, correlation time {:.1} samples)", self.samples, left.correlation);
        if left.loss < left.rms {
            let _ = writeln!(text, "robust loss: the noise without outliers is {} {unit}", digits(left.noise));
        }
        if let Some(found) = &self.lack_of_fit {
            let _ = writeln!(text, "{}", found.text());
        }
        for one in &self.validation {
            let _ = writeln!(text, "validation record {}: RMS residual {} {unit}", one.name, digits(one.rms));
        }
        if self.estimates.is_empty() {
            return text + "all parameters are held: nothing was fitted\n";
        }
        let how = if self.is_exact { "exact" } else { "by differences" };
        let _ =
            writeln!(text, "{} evaluations, sensitivities {how}, condition {:.1e}", self.evaluations, self.condition);
        text
    }
}

/// Description of a fit that was cancelled.
pub const EARLY: &str = "ended early: the best values so far, without profiles and repetitions";

/// Value and intervals of a parameter, or why it has none.
pub(super) fn text_of(one: &Estimate, searches: Searches) -> String {
    let unit = if one.unit == "1" { "" } else { one.unit };
    if one.verdict != Verdict::Determined {
        return one.verdict.to_string();
    }
    if searches == Searches::Ended {
        return format!("{} {unit} (the best so far)", digits(one.value)).replace("  ", " ");
    }
    let notation = one.notation();
    let repeated = one.repeated.map_or(String::new(), |ends| format!("; repeated {}", notation.ends(ends)));
    let (value, ends) = (notation.text(one.value), notation.ends(one.interval()));
    format!("{value} {unit} (95 %: {ends}{repeated})").replace("  ", " ")
}

fn compared(one: &Estimate, reference: Option<&Reference>) -> String {
    let Some(known) = reference.and_then(|reference| known(reference, one)) else { return String::new() };
    if one.verdict != Verdict::Determined {
        return format!("; reference {}", one.beside(known));
    }
    if known == 0.0 {
        return "; reference 0".to_owned();
    }
    let Difference { to_reference, to_mean } = difference(one.value, known);
    let [low, high] = one.interval();
    let place = if (low..=high).contains(&known) { "" } else { " outside" };
    format!(
        "; reference {}{place}, difference {to_reference:.1} % of it, {to_mean:.1} % of the mean",
        one.beside(known)
    )
}

/// Reference value of a fitted parameter; that of the excess `mu_s - mu_k` is the difference of two.
pub fn known(reference: &Reference, one: &Estimate) -> Option<f64> {
    match one.difference_of() {
        Some([of, over]) => Some(reference.get(of)? - reference.get(over)?),
        None => reference.get(&one.name).copied(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{fitted, measured, quick, standard};
    use super::*;

    /// Fast sliding at 0.3 tells the kinetic level only, and the start value of the static one is 0.15.
    #[test]
    fn a_parameter_set_without_the_static_level_is_one_that_the_law_takes() {
        let even = standard(400);
        let velocity = (0..400).map(|at| if at % 100 < 50 { 0.5 } else { -0.5 }).collect();
        let sliding = Experiment { velocity, ..even };
        let data = measured("Stribeck", &[("mu_k", 0.3), ("mu_s", 0.4)], &sliding, 0.01, 1);
        let fit = fitted("Stribeck", &[data], &quick());
        let values = fit.values();
        assert_eq!(values.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), ["mu_k"], "{:?}", fit.estimates);
        assert_eq!(fit.least_static(), [(["mu_s", "mu_k"].map(str::to_owned), values[0].1)]);
        assert!(fit.warnings.iter().any(|one| one.contains("the kinetic level")), "{:?}", fit.warnings);
        assert!(fit.parameter_set("sliding").is_ok());
        assert!(fit.configuration().text().contains("mu_s"));
    }

    #[test]
    fn a_reference_is_compared_by_the_parameters_that_the_law_has() {
        let law = stribeck::catalogue::by_name("Dahl").unwrap();
        let reference = [("mu_k", 0.2), ("stribeck_velocity", 1e-3), ("velocity", 1.0)];
        let reference: Reference = reference.map(|(name, value)| (name.to_owned(), value)).into();
        assert_eq!(of_law(law, &reference), Some([("mu_k".to_owned(), 0.2)].into()));
        assert_eq!(of_law(law, &[("stribeck_velocity".to_owned(), 1e-3)].into()), None);
    }
}
