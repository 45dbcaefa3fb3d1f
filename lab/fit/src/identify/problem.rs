//! The sum of squares of a fit, and its derivatives.

use std::borrow::Cow;
use std::ops::ControlFlow;

use nalgebra::DMatrix;
use stribeck::instance::{Instance, Phase, Refused};
use stribeck::model::ModelType;

use super::Experiment;
pub(super) use super::least_squares::Found;
use super::least_squares::LeastSquares;
use super::loss::Loss;
use super::parameter::{Parameter, Target};
use super::ports::Ports;
use super::response::{Exact, Plain, forces};
use stribeck_measured::{Direction, Movement};

/// A law, the experiments it is fitted to, and the parameters.
#[derive(Clone)]
pub(super) struct Problem<'a> {
    pub law: &'static ModelType,
    pub ports: Ports,
    pub exact: Option<Exact>,
    pub plain: Option<Plain>,
    pub experiments: &'a [Experiment],
    pub parameters: Vec<Parameter>,
    /// Columns that are held, with their values.
    pub held: Vec<(usize, f64)>,
    /// Mass and offset of the rig where they are not parameter.
    pub mass: f64,
    pub offset: f64,
    /// Delay of the motion, if it is held.
    pub delay: Option<f64>,
    /// Gravity of an arm where it is not parameter: coefficients of the cosine and the sine of its angle.
    pub gravity: [f64; 2],
    /// Cost of a residual.
    pub loss: Loss,
    /// Parts into which the intervals between samples are divided.
    pub parts: usize,
    /// Whether derivatives that are not exact are one-sided differences. These take half the evaluations, and the search
    /// ends a little short of the best point.
    pub is_rough: bool,
    /// Coordinates that are held, for profiles.
    pub pinned: Vec<Option<f64>>,
    /// Forces that are fitted instead of the measured ones.
    pub substitute: Option<Vec<f64>>,
    /// Excesses of static levels that are held: the columns of both levels, and the value.
    pub excess: Vec<(usize, usize, f64)>,
    /// Columns that have the value of another one, which is none of them.
    pub tied: Vec<(usize, usize)>,
    /// Parameters on which the rows of a map do not depend, with the values at which they are held.
    pub untold: Vec<(Parameter, f64)>,
}

/// Residual of a point at which the law is refused: larger than any force that is measured.
const REFUSED: f64 = 1e9;

/// Step of central differences of a coordinate: about a hundredth of a value on a logarithmic scale (chosen), so that a law
/// whose memory has the steps of the samples moves by more than one of them.
const STEP: f64 = 1e-3;

/// Part of values that columns cannot explain; None if the columns do not differ from each other.
fn residual_after_projection(columns: &[Vec<f64>], mut values: Vec<f64>) -> Option<Vec<f64>> {
    let sizes: Vec<f64> = columns.iter().map(|column| dot(column, column).sqrt().max(f64::MIN_POSITIVE)).collect();
    let count = columns.len();
    let gram = DMatrix::from_fn(count, count, |a, b| dot(&columns[a], &columns[b]) / (sizes[a] * sizes[b]));
    let known = gram.cholesky()?.inverse();
    let pulls: Vec<f64> = columns.iter().zip(&sizes).map(|(column, size)| dot(column, &values) / size).collect();
    let parts: Vec<f64> = (0..count).map(|a| (0..count).map(|b| known[(a, b)] * pulls[b]).sum()).collect();
    for (column, (part, size)) in columns.iter().zip(parts.iter().zip(&sizes)) {
        values.iter_mut().zip(column).for_each(|(value, slope)| *value -= part / size * slope);
    }
    Some(values)
}

/// The difference of values.
pub(super) fn minus(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// A point with one coordinate moved as far as its range admits.
pub(super) fn moved(point: &[f64], number: usize, by: f64) -> Vec<f64> {
    let mut moved = point.to_vec();
    moved[number] = (moved[number] + by).clamp(0.0, 1.0);
    moved
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Values of the parameters as a law and a rig take them.
#[derive(Clone, Debug)]
pub struct Physical {
    /// Values of the columns of the law.
    pub columns: Vec<(usize, f64)>,
    /// Mass of the rig, as given or fitted, kg.
    pub mass: f64,
    /// Offset of the load cell, N.
    pub offset: f64,
    /// Delay of the motion behind the force, if it was fitted or held, s.
    pub delay: Option<f64>,
    /// Gravity of an arm: coefficients of the cosine and the sine of its angle, N m.
    pub gravity: [f64; 2],
}

impl Physical {
    /// Gravity of an arm at a sample, N m; 0 of other bodies.
    pub(super) fn gravity_at(&self, direction: Option<&Direction>, at: usize) -> f64 {
        let [a, b] = self.gravity;
        direction.map_or(0.0, |one| a * one.cosine[at] + b * one.sine[at])
    }

    /// Force of the load cell at a sample.
    fn force(&self, friction: f64, experiment: &Experiment, at: usize) -> f64 {
        let force = friction + (self.mass * experiment.acceleration[at] + self.offset);
        let direction = experiment.direction.as_ref();
        direction.map_or(force, |direction| force + self.gravity_at(Some(direction), at))
    }
}

/// Part of what a filter takes away of the acceleration that is doubtful (chosen): it takes more of what is faster.
const DOUBTFUL: f64 = 0.5;

impl Problem<'_> {
    /// Part of a parameter, if it is a mass, by which it may be off because of the filter of the acceleration.
    pub fn doubt_of_mass(&self, parameter: &Parameter) -> f64 {
        let lost = self.experiments.iter().map(|one| one.acceleration_lost).fold(0.0, f64::max);
        if parameter.target == Target::Mass { DOUBTFUL * lost } else { 0.0 }
    }

    /// Whether the body slides or turns.
    pub fn movement(&self) -> Movement {
        self.experiments.first().map_or(Movement::Translation, |one| one.movement)
    }

    /// Number of samples that count.
    pub fn samples(&self) -> usize {
        self.lengths().iter().sum()
    }

    /// Number of samples that count in each experiment.
    pub fn lengths(&self) -> Vec<usize> {
        self.experiments.iter().map(Experiment::samples).collect()
    }

    /// The values at samples that count, of those at all samples.
    fn counting(&self, all: Vec<f64>) -> Vec<f64> {
        if self.experiments.iter().all(|one| one.left_out.is_empty()) {
            return all;
        }
        let counts = self.experiments.iter().flat_map(Experiment::fitted);
        all.into_iter().zip(counts).filter(|(_, counts)| *counts).map(|(value, _)| value).collect()
    }

    /// Weights of the samples that count; None if all are 1.
    fn weights(&self) -> Option<Vec<f64>> {
        let of = |one: &Experiment| match &one.map {
            Some(rows) => rows.weights.clone(),
            None => vec![1.0; one.time.len()],
        };
        self.is_map().then(|| self.counting(self.experiments.iter().flat_map(of).collect()))
    }

    /// Forces at the samples that count, with their weights.
    fn weighed(&self, mut forces: Vec<f64>) -> Vec<f64> {
        if let Some(weights) = self.weights() {
            forces.iter_mut().zip(weights).for_each(|(force, weight)| *force *= weight);
        }
        forces
    }

    /// The same without their weights.
    pub fn without_weights(&self, mut forces: Vec<f64>) -> Vec<f64> {
        if let Some(weights) = self.weights() {
            forces.iter_mut().zip(weights).for_each(|(force, weight)| *force /= weight);
        }
        forces
    }

    /// Samples that are repeated together: ten correlation times, and one row of a map, whose rows are independent.
    pub fn block(&self, correlation: f64) -> usize {
        if self.is_map() { 1 } else { (10.0 * correlation).ceil() as usize }
    }

    /// Whether it is fitted to maps, whose rows are independent, and not to records.
    pub fn is_map(&self) -> bool {
        self.experiments.iter().any(|one| one.map.is_some())
    }

    /// Velocities of the samples that count.
    pub fn velocities(&self) -> Vec<f64> {
        self.counting(self.experiments.iter().flat_map(|one| one.velocity.iter().copied()).collect())
    }

    /// The coordinates of all parameters, from those that are free.
    pub fn whole(&self, free: &[f64]) -> Vec<f64> {
        let mut free = free.iter();
        self.pinned.iter().map(|pin| pin.or_else(|| free.next().copied()).unwrap_or(0.5)).collect()
    }

    /// Values of the parameters at a point.
    pub fn values(&self, point: &[f64]) -> Vec<f64> {
        self.parameters.iter().zip(point).map(|(parameter, coordinate)| parameter.value(*coordinate)[0]).collect()
    }

    /// Numbers of the parameters that are not held.
    pub fn free(&self) -> impl Iterator<Item = usize> {
        (0..self.parameters.len()).filter(|number| self.pinned[*number].is_none())
    }

    /// Holds a parameter at a coordinate.
    pub fn pin(&mut self, number: usize, coordinate: f64) {
        self.pinned[number] = Some(coordinate.clamp(0.0, 1.0));
    }

    /// Changes of the parameters that are large.
    pub fn large_changes(&self, values: &[f64]) -> Vec<f64> {
        self.parameters.iter().zip(values).map(|(parameter, value)| parameter.large_change(*value)).collect()
    }

    pub fn physical(&self, point: &[f64]) -> Physical {
        let mut physical = Physical {
            columns: self.held.clone(),
            mass: self.mass,
            offset: self.offset,
            delay: self.delay,
            gravity: self.gravity,
        };
        let mut excess = self.excess.clone();
        for (parameter, value) in self.parameters.iter().zip(self.values(point)) {
            match parameter.target {
                Target::Column(column) => physical.columns.push((column, value)),
                Target::Excess { of, over } => excess.push((of, over, value)),
                Target::Mass => physical.mass = value,
                Target::Offset => physical.offset = value,
                Target::Delay => physical.delay = Some(value),
                Target::Cosine => physical.gravity[0] = value,
                Target::Sine => physical.gravity[1] = value,
                Target::Gravity => {}
            }
        }
        self.tie(&mut physical.columns);
        for (of, over, value) in excess {
            let kinetic = self.found(&physical.columns, over);
            physical.columns.push((of, kinetic + value));
        }
        // A static level is known now.
        self.tie(&mut physical.columns);
        physical
    }

    /// The value of a column: the last one, or its start value.
    fn found(&self, columns: &[(usize, f64)], column: usize) -> f64 {
        let last = columns.iter().rev().find(|(known, _)| *known == column).map(|(_, value)| *value);
        last.unwrap_or_else(|| self.law.table.at(column).start)
    }

    /// Gives the columns that are tied the values of the others.
    fn tie(&self, columns: &mut Vec<(usize, f64)>) {
        for (column, source) in &self.tied {
            columns.push((*column, self.found(columns, *source)));
        }
    }

    /// Holds the columns that are tied to others than parameters.
    pub fn hold_tied(&mut self) {
        let is_parameter = |column: usize| {
            let targets = self.parameters.iter().map(|one| one.target);
            let mut of = targets.filter_map(|target| match target {
                Target::Column(of) | Target::Excess { of, .. } => Some(of),
                _ => None,
            });
            of.any(|of| of == column)
        };
        let held = self.tied.iter().filter(|(_, source)| !is_parameter(*source));
        let held: Vec<(usize, f64)> = held.map(|(column, source)| (*column, self.kinetic(*source))).collect();
        self.held.extend(held);
    }

    /// The column that has the value of a column: itself, unless it is tied.
    pub fn source(&self, column: usize) -> usize {
        self.tied.iter().find(|(tied, _)| *tied == column).map_or(column, |(_, source)| *source)
    }

    /// The value of a column that is not parameter: as it is held, or its start value.
    pub fn kinetic(&self, column: usize) -> f64 {
        self.found(&self.held, column)
    }

    /// The columns that move with a column: static levels with the kinetic one, and those that are tied.
    fn moving_with(&self, column: usize) -> Vec<(usize, f64)> {
        let excess = self.parameters.iter().filter_map(|parameter| match parameter.target {
            Target::Excess { of, over } => Some((of, over)),
            _ => None,
        });
        let held = self.excess.iter().map(|(of, over, _)| (*of, *over));
        let links: Vec<(usize, usize)> = excess.chain(held).chain(self.tied.iter().copied()).collect();
        let mut seeds = vec![(column, 1.0)];
        let mut at = 0;
        while at < seeds.len() {
            let source = seeds[at].0;
            seeds.extend(links.iter().filter(|(_, of)| *of == source).map(|(moving, _)| (*moving, 1.0)));
            at += 1;
        }
        seeds
    }

    /// Forces of the load cell that the law explains.
    pub fn predicted(&self, instance: &mut Instance, physical: &Physical, parts: usize) -> Result<Vec<f64>, Refused> {
        let mut all = Vec::with_capacity(self.samples());
        for experiment in self.delayed(physical) {
            let friction = self.friction(instance, physical, &experiment, parts)?;
            all.extend(friction.into_iter().enumerate().map(|(at, one)| physical.force(one, &experiment, at)));
        }
        Ok(all)
    }

    /// Friction force at the samples of an experiment.
    fn friction(
        &self,
        instance: &mut Instance,
        physical: &Physical,
        experiment: &Experiment,
        parts: usize,
    ) -> Result<Vec<f64>, Refused> {
        let mut found = Vec::with_capacity(experiment.time.len());
        let take = |force: f64| {
            found.push(force);
            ControlFlow::Continue(())
        };
        let columns = &physical.columns;
        let lead = |plain: Plain| plain.lead(instance, &self.ports, columns, (experiment, parts), take);
        // The instance says what it refuses.
        if self.plain.is_some_and(lead) { Ok(found) } else { forces(instance, &self.ports, columns, experiment, parts) }
    }

    /// The cost at a point, or infinity if it is above a limit: most points of a search are, long before the last sample.
    fn cost_within(&self, plain: Plain, point: &[f64], most: f64) -> f64 {
        let (physical, measured) = (self.physical(point), self.measured());
        let (mut instance, mut measured) = (Instance::new(self.law), measured.iter());
        let mut sum = 0.0;
        for experiment in self.delayed(&physical) {
            let mut at = 0;
            let add = |friction: f64| {
                if experiment.counts(at) {
                    let measured = measured.next().copied().unwrap_or(f64::NAN);
                    sum += self.loss.root_of_loss(physical.force(friction, &experiment, at) - measured).powi(2);
                }
                at += 1;
                if 0.5 * sum > most { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            };
            let is_led = plain.lead(&mut instance, &self.ports, &physical.columns, (&experiment, self.parts), add);
            if !is_led || 0.5 * sum > most {
                return f64::INFINITY;
            }
        }
        0.5 * sum
    }

    /// The experiments with the motion at its delay.
    fn delayed(&self, physical: &Physical) -> impl Iterator<Item = Cow<'_, Experiment>> {
        let delay = physical.delay;
        self.experiments.iter().map(move |one| one.with_delay(delay))
    }

    /// Gives a point that was found on fewer samples its cost on all of them.
    pub fn judge(&self, found: Found) -> Found {
        let cost = self.residuals(&found.point).map_or(f64::INFINITY, |all| self.loss.cost(&all));
        Found { cost, ..found }
    }

    /// The forces that are fitted.
    pub fn measured(&self) -> Vec<f64> {
        let all = || self.experiments.iter().flat_map(|one| one.force.iter().copied()).collect();
        self.substitute.clone().unwrap_or_else(|| self.counting(all()))
    }

    /// Explained minus measured forces at a point, weighted; None where the law is refused.
    pub fn residuals(&self, point: &[f64]) -> Option<Vec<f64>> {
        let mut instance = Instance::new(self.law);
        let predicted = self.predicted(&mut instance, &self.physical(point), self.parts).ok()?;
        Some(self.weighed(minus(&self.counting(predicted), &self.measured())))
    }

    /// The same with intervals between samples that are not divided, and with forces that leave the same residuals at a
    /// point: near it, the error of the steps hardly changes.
    pub fn corrected(&self, point: &[f64]) -> Option<Problem<'_>> {
        self.leaving(point, self.residuals(point)?)
    }

    /// The same with forces that have their least squares at the point: the residuals are the same as far as the parameters
    /// cannot explain them.
    pub fn undivided(&self, point: &[f64]) -> Option<Problem<'_>> {
        let quick = self.with_whole_intervals();
        let inside = (0..point.len()).filter(|number| point[*number] > 0.0 && point[*number] < 1.0);
        let columns: Vec<Vec<f64>> = inside.map(|number| quick.sensitivity(point, number)).collect();
        self.leaving(point, residual_after_projection(&columns, self.residuals(point)?)?)
    }

    /// The same with intervals that are not divided.
    fn with_whole_intervals(&self) -> Problem<'_> {
        Problem { parts: 1, substitute: None, ..self.clone() }
    }

    /// A problem with intervals that are not divided and with forces that leave given residuals at a point.
    fn leaving(&self, point: &[f64], left: Vec<f64>) -> Option<Problem<'_>> {
        let quick = self.with_whole_intervals();
        let coarse = quick.residuals(point)?;
        let predicted: Vec<f64> = quick.measured().iter().zip(coarse).map(|(force, left)| force + left).collect();
        Some(Problem { substitute: Some(minus(&predicted, &left)), ..quick })
    }

    /// Derivatives of the residuals with respect to the value of each parameter, a column for each.
    pub fn sensitivities(&self, point: &[f64]) -> Vec<Vec<f64>> {
        (0..self.parameters.len()).map(|number| self.sensitivity(point, number)).collect()
    }

    fn sensitivity(&self, point: &[f64], number: usize) -> Vec<f64> {
        let physical = self.physical(point);
        match (self.parameters[number].target, self.exact) {
            (Target::Mass, _) => {
                self.weighed(self.counting(self.delayed(&physical).flat_map(|one| one.acceleration.clone()).collect()))
            }
            (Target::Offset, _) => self.weighed(vec![1.0; self.samples()]),
            (target @ (Target::Cosine | Target::Sine), _) => self.directions(&physical, target == Target::Cosine),
            (Target::Column(moved) | Target::Excess { of: moved, .. }, Some(exact)) => {
                self.exactly(exact, &physical, &self.moving_with(moved))
            }
            (Target::Delay | Target::Gravity, _) | (_, None) => self.differences(point, number, STEP),
        }
    }

    /// Cosine or sine of the angles of arms.
    fn directions(&self, physical: &Physical, is_cosine: bool) -> Vec<f64> {
        let of = |one: Cow<Experiment>| {
            let direction = one.direction.clone().unwrap_or_default();
            if is_cosine { direction.cosine } else { direction.sine }
        };
        self.counting(self.delayed(physical).flat_map(of).collect())
    }

    fn exactly(&self, exact: Exact, physical: &Physical, seeds: &[(usize, f64)]) -> Vec<f64> {
        let mut instance = Instance::new(self.law);
        // Refused values have led to no residuals before.
        let _ = instance.set_all(Phase::Setup, physical.columns.iter().copied());
        let start = instance.row().to_vec();
        let forces = |one: Cow<Experiment>| {
            exact.forces(&start, &self.ports, seeds, &one, self.parts).into_iter().map(|force| force.slope)
        };
        self.weighed(self.counting(self.delayed(physical).flat_map(forces).collect()))
    }

    /// Derivatives for a step of least squares from a point with known residuals.
    fn slope_from(&self, point: &[f64], number: usize, here: &[f64]) -> Vec<f64> {
        if !self.is_rough || !self.is_by_differences(number) {
            return self.sensitivity(point, number);
        }
        let there = moved(point, number, if point[number] + STEP > 1.0 { -STEP } else { STEP });
        let distance =
            self.parameters[number].value(there[number])[0] - self.parameters[number].value(point[number])[0];
        match self.residuals(&there) {
            Some(there) => there.iter().zip(here).map(|(there, here)| (there - here) / distance).collect(),
            None => vec![0.0; self.samples()],
        }
    }

    /// Whether the derivatives by a parameter are differences.
    fn is_by_differences(&self, number: usize) -> bool {
        match self.parameters[number].target {
            Target::Column(_) | Target::Excess { .. } => self.exact.is_none(),
            Target::Delay => true,
            Target::Mass | Target::Offset | Target::Cosine | Target::Sine | Target::Gravity => false,
        }
    }

    /// Central differences; one-sided at an end of the range.
    pub fn differences(&self, point: &[f64], number: usize, step: f64) -> Vec<f64> {
        let at = |shift: f64| {
            let moved = moved(point, number, shift);
            (self.parameters[number].value(moved[number])[0], self.residuals(&moved))
        };
        let [(low, before), (high, after)] = [at(-step), at(step)];
        match (before, after) {
            (Some(before), Some(after)) if high > low => {
                before.iter().zip(&after).map(|(before, after)| (after - before) / (high - low)).collect()
            }
            _ => vec![0.0; self.samples()],
        }
    }
}

/// Over the coordinates of the free parameters.
impl LeastSquares for Problem<'_> {
    fn count(&self) -> usize {
        self.free().count()
    }

    fn work(&self) -> u64 {
        self.parameters.len() as u64
    }

    fn weighted(&self, free: &[f64]) -> Vec<f64> {
        let residuals = self.residuals(&self.whole(free)).unwrap_or_else(|| vec![REFUSED; self.samples()]);
        residuals.into_iter().map(|one| self.loss.root_of_loss(one)).collect()
    }

    fn slopes(&self, free: &[f64]) -> Vec<Vec<f64>> {
        let point = self.whole(free);
        // A refused point has no residuals and is never a point to go on from.
        let residuals = self.residuals(&point).unwrap_or_else(|| vec![0.0; self.samples()]);
        let weights: Vec<f64> = residuals.iter().map(|one| self.loss.slope_of_root(*one)).collect();
        let column = |number: usize| {
            let [_, slope] = self.parameters[number].value(point[number]);
            let column = self.slope_from(&point, number, &residuals);
            column.iter().zip(&weights).map(|(value, weight)| weight * (value * slope)).collect()
        };
        self.free().map(column).collect()
    }

    fn cost(&self, free: &[f64], most: f64) -> f64 {
        let point = self.whole(free);
        match self.plain {
            Some(plain) => self.cost_within(plain, &point, most),
            None => self.residuals(&point).map_or(f64::INFINITY, |found| self.loss.cost(&found)),
        }
    }
}
