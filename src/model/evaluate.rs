//! Numbers in which any model can be evaluated.

use super::row::{view, view_mut};
use super::{Interface, Law, Model, ModelType};
use crate::number::{DIRECTIONS, Dual, Gradient, Scalar};
use crate::numerics::vector::Component;

/// A number in which a model evaluates rows of other models.
pub trait Evaluate: Component + Scalar {
    /// Whether numbers have values that a search can work on. Others only show which numbers a result depends on.
    const HAS_VALUES: bool = true;

    /// Computes the outputs of the row. False if one is known not to be finite.
    fn evaluate(model: &ModelType, row: &mut [Self]) -> bool;

    /// Computes the time derivatives of the states.
    fn rate(model: &ModelType, row: &[Self], rate: &mut [Self]);

    /// Largest force of a law without its viscous part, relative to the static level.
    fn overshoot(model: &ModelType, row: &[Self]) -> Self;

    /// Tells numbers without values that nobody asks for the rates at hand: they belong to a model for co-simulation only.
    fn refuse_rates() {}

    /// Lets each state of the row depend on what it depends on after a step, in numbers without values. Others take the
    /// step.
    fn mark_step(_model: &ModelType, _row: &mut [Self]) {}

    /// Slope of the number; 0 if it has none.
    fn slope(self) -> f64;

    /// A number with that slope, if the type can hold one.
    fn with_slope(value: f64, slope: f64) -> Self;
}

impl Evaluate for f64 {
    fn evaluate(model: &ModelType, row: &mut [f64]) -> bool {
        model.output(row)
    }

    fn rate(model: &ModelType, row: &[f64], rate: &mut [f64]) {
        model.rate(row, rate);
    }

    fn overshoot(model: &ModelType, row: &[f64]) -> f64 {
        model.overshoot(row)
    }

    fn slope(self) -> f64 {
        0.0
    }

    fn with_slope(value: f64, _slope: f64) -> f64 {
        value
    }
}

impl Evaluate for Dual {
    fn evaluate(model: &ModelType, row: &mut [Dual]) -> bool {
        model.output_dual(row);
        true
    }

    fn rate(model: &ModelType, row: &[Dual], rate: &mut [Dual]) {
        model.rate_dual(row, rate);
    }

    fn overshoot(model: &ModelType, row: &[Dual]) -> Dual {
        model.overshoot_dual(row)
    }

    fn slope(self) -> f64 {
        self.slope
    }

    fn with_slope(value: f64, slope: f64) -> Dual {
        Dual { value, slope }
    }
}

/// One direction after the other.
impl Evaluate for Gradient {
    fn evaluate(model: &ModelType, row: &mut [Gradient]) -> bool {
        let before = row.to_vec();
        for direction in 0..DIRECTIONS {
            let mut along: Vec<Dual> = before.iter().map(|number| number.along(direction)).collect();
            model.output_dual(&mut along);
            take(row, &along, direction);
        }
        true
    }

    fn rate(model: &ModelType, row: &[Gradient], rate: &mut [Gradient]) {
        for direction in 0..DIRECTIONS {
            let along: Vec<Dual> = row.iter().map(|number| number.along(direction)).collect();
            let mut rate_along = vec![Dual::default(); rate.len()];
            model.rate_dual(&along, &mut rate_along);
            take(rate, &rate_along, direction);
        }
    }

    fn overshoot(model: &ModelType, row: &[Gradient]) -> Gradient {
        let mut bound = [Gradient::from(0.0)];
        for direction in 0..DIRECTIONS {
            let along: Vec<Dual> = row.iter().map(|number| number.along(direction)).collect();
            take(&mut bound, &[model.overshoot_dual(&along)], direction);
        }
        bound[0]
    }

    /// Not a number if it changes: what asks for one slope has no use for several.
    fn slope(self) -> f64 {
        if self.has_slope() { f64::NAN } else { 0.0 }
    }

    fn with_slope(value: f64, slope: f64) -> Gradient {
        Gradient { value, slopes: [slope; DIRECTIONS] }
    }
}

/// Takes values, and slopes in one direction.
fn take(numbers: &mut [Gradient], along: &[Dual], direction: usize) {
    for (number, along) in numbers.iter_mut().zip(along) {
        number.value = along.value;
        number.slopes[direction] = along.slope;
    }
}

/// Number of values beside a row of a model that its parameters ask for.
pub fn memory_in<M: Model, T: Evaluate>(row: &[T]) -> usize {
    view::<M::In<T>, T>(row).memory_in_use()
}

/// Computes the outputs of a row of a model in any number, advice apart.
pub fn output_in<M: Model, T: Evaluate>(row: &mut [T], memory: &[T]) {
    view_mut::<M::In<T>, T>(row).output_with(memory);
}

/// Computes the outputs of a row that are advice.
pub fn advise_in<M: Model, T: Evaluate>(row: &mut [T]) {
    view_mut::<M::In<T>, T>(row).advise();
}

/// Computes the outputs of a row without memory, advice apart, and the time derivatives of its continuous states, in the
/// columns of the states; `rate` is 0 elsewhere. What both need is computed once.
pub fn output_and_rate_in<M: Model, T: Evaluate>(row: &mut [T], rate: &mut [T]) {
    // As long as the table, which the compiler knows.
    let rate = &mut rate[..M::TABLE.len()];
    rate.fill(T::from(0.0));
    <M::In<T> as Law>::Interface::outputs_and_rates(view_mut(row), view_mut(rate));
}

/// Largest force of a law without its viscous part, relative to the static level.
pub(super) fn overshoot_in<M: Model, T: Evaluate>(row: &[T]) -> T {
    view::<M::In<T>, T>(row).overshoot().unwrap_or(T::from(1.0))
}

/// Computes the time derivatives of the continuous states, in the columns of the states; `rate` is 0 elsewhere.
pub fn rate_in<M: Model, T: Evaluate>(row: &[T], rate: &mut [T]) {
    let rate = &mut rate[..M::TABLE.len()];
    rate.fill(T::from(0.0));
    <M::In<T> as Law>::Interface::rates(view(row), view_mut(rate));
}
