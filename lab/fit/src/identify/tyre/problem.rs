//! The sum of squares of a tyre test, and its derivatives.

use std::cell::Cell;

use stribeck::host::{Contact, MagicFormula, Wrench};
use stribeck::model::{Columns, row_of, row_of_mut};
use stribeck::number::{Dual, Scalar};

use super::super::least_squares::{Bounded, LeastSquares};
use super::coefficient::Coefficient;
use super::{Sample, TyreTest};

/// A measured quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Channel {
    ForceX,
    ForceY,
    MomentZ,
}

impl Channel {
    pub const ALL: [Channel; 3] = [Channel::ForceX, Channel::ForceY, Channel::MomentZ];

    pub fn name(self) -> &'static str {
        match self {
            Channel::ForceX => "F_x",
            Channel::ForceY => "F_y",
            Channel::MomentZ => "M_z",
        }
    }

    pub fn unit(self) -> &'static str {
        if self == Channel::MomentZ { "N.m" } else { "N" }
    }

    pub fn measured(self, sample: &Sample) -> Option<f64> {
        match self {
            Channel::ForceX => sample.force_x,
            Channel::ForceY => sample.force_y,
            Channel::MomentZ => sample.moment_z,
        }
    }

    /// Numbers of the samples in which it was measured.
    pub fn samples(self, test: &TyreTest) -> Vec<usize> {
        (0..test.samples.len()).filter(|at| self.measured(&test.samples[*at]).is_some()).collect()
    }

    /// Largest magnitude in a test.
    pub fn largest(self, test: &TyreTest) -> f64 {
        test.samples.iter().filter_map(|one| self.measured(one)).fold(0.0, |most, value| most.max(value.abs()))
    }

    fn of<T: Copy>(self, wrench: &Wrench<T>) -> T {
        match self {
            Channel::ForceX => wrench.force_x,
            Channel::ForceY => wrench.force_y,
            Channel::MomentZ => wrench.moment_z,
        }
    }
}

/// Samples that are fitted, and the channels, each with the weight of its residuals.
#[derive(Clone, Debug)]
pub(super) struct Rows {
    pub samples: Vec<usize>,
    pub channels: Vec<(Channel, f64)>,
}

/// A formula of which some coefficients are parameter.
#[derive(Clone)]
pub(super) struct TyreProblem<'a> {
    pub test: &'a TyreTest,
    /// All coefficients; those of the parameters are where the search begins.
    pub formula: MagicFormula,
    pub parameters: Vec<&'static Coefficient>,
    pub rows: Rows,
    /// Where the search begins, and the residual of a large change from there: coefficients that only act together stay
    /// near it, so that least squares have one end.
    anchor: Vec<f64>,
    pull: f64,
}

/// Column of a coefficient.
pub(super) fn column(name: &str) -> usize {
    let position = MagicFormula::TABLE.iter().position(|variable| variable.path.to_string() == name);
    position.expect("a coefficient of the formula")
}

/// Steps of least squares (chosen).
const MOST_STEPS: u64 = 30;

/// Residual of a large change from where a search begins, as a part of the root mean square of what was measured
/// (chosen: far below any noise).
const PULL: f64 = 1e-4;

impl<'a> TyreProblem<'a> {
    pub fn new(
        test: &'a TyreTest,
        formula: MagicFormula,
        parameters: Vec<&'static Coefficient>,
        rows: Rows,
    ) -> TyreProblem<'a> {
        let count = parameters.len();
        TyreProblem { test, formula, parameters, rows, anchor: vec![0.0; count], pull: 0.0 }
    }

    /// The point of the parameters, from 0 to 1 in their ranges.
    pub fn point(&self) -> Vec<f64> {
        let row = row_of(&self.formula);
        let coordinate = |one: &&Coefficient| {
            ((row[column(one.name)] - one.range[0]) / (one.range[1] - one.range[0])).clamp(0.0, 1.0)
        };
        self.parameters.iter().map(coordinate).collect()
    }

    /// The formula with the parameters at a point.
    pub fn at(&self, point: &[f64]) -> MagicFormula {
        let mut formula = self.formula;
        let row = row_of_mut(&mut formula);
        for (one, coordinate) in self.parameters.iter().zip(point) {
            row[column(one.name)] =
                (one.range[0] + (one.range[1] - one.range[0]) * coordinate).clamp(one.range[0], one.range[1]);
        }
        formula
    }

    /// The channels that were measured at a sample, each with its number and value.
    fn measured(&self, at: usize) -> impl Iterator<Item = (usize, f64)> {
        let channels = self.rows.channels.iter().enumerate();
        channels.filter_map(move |(number, (channel, _))| Some((number, channel.measured(&self.test.samples[at])?)))
    }

    /// Values of the measured channels at each sample, one sample after the other.
    fn predicted<T: Scalar>(&self, formula: &MagicFormula<T>) -> Vec<T> {
        let mut all = Vec::with_capacity(self.rows.samples.len() * self.rows.channels.len());
        let mut formula = *formula;
        for at in &self.rows.samples {
            let sample = &self.test.samples[*at];
            // Version 5.2 has no pressure.
            sample.pressure.into_iter().for_each(|pressure| formula.inflpres = T::from(pressure));
            let contact = Contact {
                load: T::from(sample.load),
                longitudinal_slip: T::from(sample.longitudinal_slip),
                side_slip: T::from(sample.side_slip),
                camber: T::from(sample.camber),
                speed: T::from(1.0),
            };
            let wrench = formula.wrench(&contact);
            all.extend(self.measured(*at).map(|(number, _)| self.rows.channels[number].0.of(&wrench)));
        }
        all
    }

    /// The numbers of channels and the measured values, in the order of what is predicted.
    fn all_measured(&self) -> impl Iterator<Item = (usize, f64)> {
        self.rows.samples.iter().flat_map(|at| self.measured(*at))
    }

    /// Explained minus measured values of each channel.
    pub fn left(&self, formula: &MagicFormula) -> Vec<Vec<f64>> {
        let mut left = vec![Vec::with_capacity(self.rows.samples.len()); self.rows.channels.len()];
        for (predicted, (number, measured)) in self.predicted(formula).into_iter().zip(self.all_measured()) {
            left[number].push(predicted - measured);
        }
        left
    }

    /// The residuals with their weights, one sample after the other.
    fn residuals(&self, formula: &MagicFormula) -> Vec<f64> {
        let all = self.predicted(formula).into_iter().zip(self.all_measured());
        all.map(|(predicted, (number, measured))| self.rows.channels[number].1 * (predicted - measured)).collect()
    }

    /// Derivatives of the weighted residuals with respect to a parameter.
    pub fn sensitivity(&self, formula: &MagicFormula, number: usize) -> Vec<f64> {
        let (seeded, at) = (column(self.parameters[number].name), Cell::new(0));
        let dual = formula.map(&|value: f64| {
            let here = at.replace(at.get() + 1);
            Dual { slope: f64::from(u8::from(here == seeded)), ..Dual::from(value) }
        });
        let all = self.predicted(&dual).into_iter().zip(self.all_measured());
        all.map(|(one, (number, _))| self.rows.channels[number].1 * one.slope).collect()
    }

    /// Half the weighted sum of squares.
    fn half_square(&self, formula: &MagicFormula) -> f64 {
        0.5 * self.residuals(formula).iter().map(|one| one * one).sum::<f64>()
    }

    /// Follows the slopes from where the formula is; half the sum of squares at the end.
    pub fn solve(&mut self) -> f64 {
        let before = self.half_square(&self.formula);
        if self.parameters.is_empty() {
            return before;
        }
        self.anchor = self.point();
        self.pull = PULL * self.size();
        let Some(end) = Bounded::new(self).solve(self.point(), 1e-7, MOST_STEPS) else { return before };
        let found = self.at(&end.point);
        let cost = self.half_square(&found);
        if cost < before {
            self.formula = found;
        }
        cost.min(before)
    }

    /// Root mean square of what was measured, with its weights.
    fn size(&self) -> f64 {
        let weighted = self.all_measured().map(|(number, measured)| self.rows.channels[number].1 * measured);
        let (square, count) = weighted.fold((0.0, 0), |(sum, count), one| (sum + one * one, count + 1));
        (square / f64::from(count.max(1))).sqrt()
    }

    /// Residual of a move of a parameter by its whole range.
    fn pulled(&self, number: usize) -> f64 {
        let one = self.parameters[number];
        self.pull * (one.range[1] - one.range[0]) / one.large
    }
}

impl LeastSquares for TyreProblem<'_> {
    fn count(&self) -> usize {
        self.parameters.len()
    }

    fn work(&self) -> u64 {
        self.parameters.len() as u64
    }

    fn weighted(&self, point: &[f64]) -> Vec<f64> {
        let mut all = self.residuals(&self.at(point));
        let moved = point.iter().zip(&self.anchor).enumerate();
        all.extend(moved.map(|(number, (coordinate, anchor))| self.pulled(number) * (coordinate - anchor)));
        all
    }

    fn slopes(&self, point: &[f64]) -> Vec<Vec<f64>> {
        let formula = self.at(point);
        let column = |number: usize| {
            let range = self.parameters[number].range;
            let slopes = self.sensitivity(&formula, number).into_iter().map(|slope| slope * (range[1] - range[0]));
            let pull = |row: usize| if row == number { self.pulled(row) } else { 0.0 };
            slopes.chain((0..self.count()).map(pull)).collect()
        };
        (0..self.count()).map(column).collect()
    }

    fn cost(&self, point: &[f64], _most: f64) -> f64 {
        self.half_square(&self.at(point))
    }
}
