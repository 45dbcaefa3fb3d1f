//! A step with inputs that move linearly, composed of steps with held inputs.
//!
//! The models solve a step with held inputs exactly. Holding each input at its value in the middle of a piece is of
//! second order; the length of the pieces follows from comparing one piece with its two halves.

use crate::model::{Columns, Model, Role, row_of, row_of_mut};

/// Error allowed in a piece, relative to the larger of the state and its nominal value (chosen: an order below what
/// co-simulation with a communication step of 1 us would resolve).
const TOLERANCE: f64 = 1e-9;

/// No piece is shorter than this part of the step (chosen), so that the number of pieces is bounded.
const SHORTEST: f64 = 1e-6;

/// Advances `model` by `dt` while its inputs move with `slope`.
pub(crate) fn advance<M: Model>(model: &mut M, slope: &M, dt: f64) {
    let begin = *model;
    let mut from = 0.0;
    while from < dt {
        // The laws have their kinks where an input changes sign, so no piece reaches across such an instant.
        let to = next_zero(&begin, slope, from).map_or(dt, |zero| zero.min(dt));
        smooth(model, &begin, slope, from, to);
        from = to;
    }
    set_inputs(model, &begin, slope, dt);
}

/// Moves the inputs to the end of the step and makes one held step there: for laws whose force belongs to a whole step.
pub(crate) fn at_end<M: Model>(model: &mut M, slope: &M, dt: f64) {
    let begin = *model;
    set_inputs(model, &begin, slope, dt);
    model.step(dt);
}

/// The first instant after `from` at which an input passes through zero.
fn next_zero<M: Columns>(begin: &M, slope: &M, from: f64) -> Option<f64> {
    inputs::<M>()
        .map(|column| -row_of(begin)[column] / row_of(slope)[column])
        .filter(|zero| *zero > from && zero.is_finite())
        .min_by(f64::total_cmp)
}

/// Advances over an interval in which no input changes sign.
fn smooth<M: Model>(model: &mut M, begin: &M, slope: &M, from: f64, to: f64) {
    let shortest = SHORTEST * (to - from);
    let mut at = from;
    let mut piece = to - from;
    while at < to {
        let end = if at + piece >= to - shortest { to } else { at + piece };
        let middle = 0.5 * (at + end);
        let mut whole = *model;
        held(&mut whole, begin, slope, at, end);
        let mut halves = *model;
        held(&mut halves, begin, slope, at, middle);
        held(&mut halves, begin, slope, middle, end);
        let error = difference(&whole, &halves) / TOLERANCE;
        let length = end - at;
        // Of `piece`, not of `length`: the sum at + shortest may be rounded up, and the loop would never end.
        if error <= 1.0 || piece <= shortest {
            *model = halves;
            at = end;
        }
        // The local error is of third order; safety factor and limits as usual in step-size control.
        piece = shortest.max(length * (0.9 * error.powf(-1.0 / 3.0)).clamp(0.2, 4.0));
    }
}

/// One step with the inputs held at their values in its middle.
fn held<M: Model>(model: &mut M, begin: &M, slope: &M, from: f64, to: f64) {
    set_inputs(model, begin, slope, 0.5 * (from + to));
    model.step(to - from);
}

fn set_inputs<M: Columns>(model: &mut M, begin: &M, slope: &M, time: f64) {
    for column in inputs::<M>() {
        row_of_mut(model)[column] = row_of(begin)[column] + row_of(slope)[column] * time;
    }
}

fn inputs<M: Columns>() -> impl Iterator<Item = usize> {
    let is_input = |column: &usize| M::TABLE[*column].role == Role::Input;
    (0..M::TABLE.len()).filter(is_input)
}

/// Largest difference of a state, relative to the larger of its value and its nominal value.
fn difference<M: Columns>(a: &M, b: &M) -> f64 {
    M::TABLE
        .iter()
        .zip(row_of(a).iter().zip(row_of(b)))
        .filter(|(variable, _)| variable.role.is_state())
        .map(|(variable, (a, b))| (a - b).abs() / b.abs().max(variable.nominal))
        .fold(0.0, f64::max)
}
