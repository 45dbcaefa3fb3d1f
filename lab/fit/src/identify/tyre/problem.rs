//! The sum of squares of a tyre test, and its derivatives.

use std::cell::Cell;

use stribeck::host::{Contact, MagicFormula, Wrench};
use stribeck::model::{Columns, row_of, row_of_mut};
use stribeck::number::{Dual, Scalar};

use super::super::least_squares::{Bounded, LeastSquares};
use super::TyreTest;
use super::coefficient::Coefficient;

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

    pub fn measured(self, test: &TyreTest) -> Option<&[f64]> {
        match self {
            Channel::ForceX => test.force_x.as_deref(),
            Channel::ForceY => Some(&test.force_y),
            Channel::MomentZ => test.moment_z.as_deref(),
        }
    }

    /// Largest magnitude in a test.
    pub fn largest(self, test: &TyreTest) -> f64 {
        self.measured(test).unwrap_or_default().iter().fold(0.0, |most, value| most.max(value.abs()))
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

    /// Values of the channels at each sample, one sample after the other.
    fn predicted<T: Scalar>(&self, formula: &MagicFormula<T>) -> Vec<T> {
        let test = self.test;
        let mut all = Vec::with_capacity(self.rows.samples.len() * self.rows.channels.len());
        for at in &self.rows.samples {
            let contact = Contact {
                load: T::from(test.load[*at]),
                longitudinal_slip: T::from(test.longitudinal_slip[*at]),
                side_slip: T::from(test.side_slip[*at]),
                camber: T::from(test.camber[*at]),
                speed: T::from(1.0),
            };
            let wrench = formula.wrench(&contact);
            all.extend(self.rows.channels.iter().map(|(channel, _)| channel.of(&wrench)));
        }
        all
    }

    /// Explained minus measured values of each channel.
    pub fn left(&self, formula: &MagicFormula) -> Vec<Vec<f64>> {
        let predicted = self.predicted(formula);
        let count = self.rows.channels.len();
        let of_channel = |(number, (channel, _)): (usize, &(Channel, f64))| {
            let measured = channel.measured(self.test).unwrap_or_default();
            let samples = self.rows.samples.iter().enumerate();
            samples.map(|(row, at)| predicted[count * row + number] - measured[*at]).collect()
        };
        self.rows.channels.iter().enumerate().map(of_channel).collect()
    }

    /// The residuals with their weights, one sample after the other.
    fn residuals(&self, formula: &MagicFormula) -> Vec<f64> {
        let left = self.left(formula);
        let at = |row: usize| self.rows.channels.iter().zip(&left).map(move |((_, weight), left)| weight * left[row]);
        (0..self.rows.samples.len()).flat_map(at).collect()
    }

    /// Derivatives of the weighted residuals with respect to a parameter.
    pub fn sensitivity(&self, formula: &MagicFormula, number: usize) -> Vec<f64> {
        let (seeded, at) = (column(self.parameters[number].name), Cell::new(0));
        let dual = formula.map(&|value: f64| {
            let here = at.replace(at.get() + 1);
            Dual { slope: f64::from(u8::from(here == seeded)), ..Dual::from(value) }
        });
        let weights = self.rows.channels.iter().map(|(_, weight)| weight).cycle();
        self.predicted(&dual).into_iter().zip(weights).map(|(one, weight)| weight * one.slope).collect()
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
        let of_channel = |(channel, weight): &(Channel, f64)| {
            let measured = channel.measured(self.test).unwrap_or_default();
            self.rows.samples.iter().map(|at| (weight * measured[*at]).powi(2)).sum::<f64>()
        };
        let count = self.rows.samples.len() * self.rows.channels.len();
        (self.rows.channels.iter().map(of_channel).sum::<f64>() / count.max(1) as f64).sqrt()
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

    fn cost(&self, point: &[f64]) -> f64 {
        self.half_square(&self.at(point))
    }
}
