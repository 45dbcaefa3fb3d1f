//! A step with inputs that move linearly, composed of steps with held inputs.
//!
//! The models solve a step with held inputs exactly. Holding each input at its value in the middle of a piece is of
//! second order; the length of the pieces follows from comparing one piece with its two halves.

use crate::model::{Columns, Model, Path, Role, row_of, row_of_mut};

/// Error allowed in a piece, relative to the larger of the state and its nominal value (chosen).
const TOLERANCE: f64 = 1e-9;

/// No piece is shorter than this part of the step (chosen), so that the time that a step takes is bounded.
const SHORTEST: f64 = 1e-5;

/// Advances `model` by `dt` while its inputs move with `slope`.
pub(crate) fn advance<M: Model>(model: &mut M, slope: &M, dt: f64) {
    let begin = *model;
    let mut from = 0.0;
    while from < dt {
        let to = next_kink(&begin, slope, from).map_or(dt, |kink| kink.min(dt));
        smooth(model, &begin, slope, from, to);
        from = to;
    }
    set_inputs(model, &begin, slope, dt);
}

/// The first instant after `from` at which an input changes sign, where most laws have a kink, or at which the velocity
/// passes another kink of the law.
fn next_kink<M: Model>(begin: &M, slope: &M, from: f64) -> Option<f64> {
    let reach = |column: usize, level: f64| (level - row_of(begin)[column]) / row_of(slope)[column];
    let zeros = inputs::<M>().map(|column| reach(column, 0.0));
    let velocity = M::TABLE.iter().position(|variable| variable.path == Path::root("velocity"));
    let kinks = begin.kinks().into_iter().flat_map(|speed| [speed, -speed]);
    let kinks = velocity.into_iter().flat_map(|column| kinks.clone().map(move |level| reach(column, level)));
    zeros.chain(kinks).filter(|time| *time > from && time.is_finite()).min_by(f64::total_cmp)
}

/// Advances over an interval in which the law is smooth.
fn smooth<M: Model>(model: &mut M, begin: &M, slope: &M, from: f64, to: f64) {
    let shortest = SHORTEST * (to - from);
    let (mut at, mut piece) = (from, to - from);
    while at < to {
        // A rest that is hardly longer than the piece is made in one.
        let end = if at + 1.01 * piece >= to { to } else { at + piece };
        let (middle, length) = (0.5 * (at + end), end - at);
        let mut whole = *model;
        held(&mut whole, begin, slope, at, end);
        let mut halves = *model;
        held(&mut halves, begin, slope, at, middle);
        held(&mut halves, begin, slope, middle, end);
        let error = difference(&whole, &halves) / TOLERANCE;
        let is_accurate = error <= 1.0;
        // What is not finite is refused by the caller; what can hardly be divided is taken as it is.
        if is_accurate || length <= 2.0 * shortest || middle <= at || !error.is_finite() {
            *model = halves;
            at = end;
        }
        // The local error is of third order; safety factor and limits as usual in step-size control. A refused piece is
        // at least halved, so that the shortest is always reached.
        let most = if is_accurate { 4.0 } else { 0.5 };
        piece = shortest.max(length * (0.9 * error.powf(-1.0 / 3.0)).clamp(0.2, most));
    }
}

/// One step with the inputs held at their values in its middle.
fn held<M: Model>(model: &mut M, begin: &M, slope: &M, from: f64, to: f64) {
    set_inputs(model, begin, slope, 0.5 * (from + to));
    model.step(to - from);
}

/// Gives the inputs the values they have a time after `begin`.
pub(crate) fn set_inputs<M: Columns>(model: &mut M, begin: &M, slope: &M, time: f64) {
    for column in inputs::<M>() {
        // By rounding, a ramp that ends on a bound may end beyond it.
        let value = row_of(begin)[column] + row_of(slope)[column] * time;
        row_of_mut(model)[column] = M::TABLE[column].bound.nearest(value);
    }
}

/// Slopes of inputs that do not move.
pub(crate) fn held_inputs<M: Model>(model: &M) -> M {
    let mut slope = *model;
    for column in inputs::<M>() {
        row_of_mut(&mut slope)[column] = 0.0;
    }
    slope
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
