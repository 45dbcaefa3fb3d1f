//! Integration of a host whose rates follow from its states and its inputs.

use crate::laws::runge_kutta::dormand_prince;
use crate::model::{Columns, Model, row_of, row_of_mut};
use crate::ramp::set_inputs;

/// Error allowed in a piece of a step, relative to the larger of the state and its nominal value (chosen).
const TOLERANCE: f64 = 1e-10;

/// Length of a piece in s within which the model may change its branch (chosen: where the rate of the rate jumps by j,
/// it leaves an error of less than j times its square, 1e-10 m/s for a wheel that lands at 1 m/s).
const CHANGE: f64 = 1e-7;

/// A step is divided into at most so many pieces, times the number of states (chosen: about a second of computation, and
/// half an hour of a ride).
const MOST_PIECES_TIMES_STATES: u32 = 2_000_000;

/// After each of so many parts of the most pieces it is foreseen how many the rest of the step takes at this pace; where
/// they are `HOPELESS` times the most, it is given up (chosen: a step without hope costs a tenth).
const OUTLOOKS: u32 = 10;
const HOPELESS: f64 = 10.0;

/// Advances the `N` states of `model` by `dt` while its inputs are held.
pub(crate) fn held<M: Model, const N: usize>(model: &mut M, dt: f64) {
    let mut slope = *model;
    row_of_mut(&mut slope).fill(0.0);
    advance::<M, N>(model, &slope, dt);
}

/// Advances the `N` states of `model` by `dt` while its inputs move with `slope`. What would take too many pieces
/// becomes NaN, which the caller refuses.
pub(crate) fn advance<M: Model, const N: usize>(model: &mut M, slope: &M, dt: f64) {
    let (begin, rate) = (*model, *model);
    let columns = states::<M, N>();
    let mut car = Moving { model, begin: &begin, slope, columns: &columns, rate };
    let (mut time, mut piece) = (0.0, dt);
    let mut at = columns.map(|column| row_of(&begin)[column]);
    let mut branches = begin.branches();
    let most = const { MOST_PIECES_TIMES_STATES / N as u32 };
    let mut last_look = 0.0;
    for count in 1..=most {
        // A rest that is hardly longer than the piece is made in one.
        let end = if time + 1.01 * piece >= dt { dt } else { time + piece };
        let length = end - time;
        let (next, error) = dormand_prince(|since, at| car.rates(time + since, at), at, length);
        let error = largest::<M, N>(&columns, next, error) / TOLERANCE;
        // The estimate is of fifth order; safety factor and limits as usual in step-size control.
        let factor = 0.9 * error.powf(-0.2);
        piece = length * if factor.is_nan() { 0.2 } else { factor.clamp(0.2, 5.0) };
        if error <= 1.0 {
            car.move_to(end, next);
            let after = car.model.branches();
            if after != branches && length > CHANGE {
                piece = 0.25 * length;
                continue;
            }
            (time, at, branches) = (end, next, after);
            if time >= dt {
                return;
            }
        }
        if time + piece <= time {
            break;
        }
        if count.is_multiple_of(most / OUTLOOKS) {
            let pace = f64::from(OUTLOOKS) * (time - last_look);
            if dt - time > HOPELESS * pace {
                break;
            }
            last_look = time;
        }
    }
    car.move_to(dt, [f64::NAN; N]);
}

/// A model that is moved about within a step, in place: rows are large, and stacks may be small.
struct Moving<'a, M, const N: usize> {
    model: &'a mut M,
    begin: &'a M,
    slope: &'a M,
    columns: &'a [usize; N],
    rate: M,
}

impl<M: Model, const N: usize> Moving<'_, M, N> {
    #[inline(never)]
    fn move_to(&mut self, time: f64, at: [f64; N]) {
        set_inputs(self.model, self.begin, self.slope, time);
        for (column, value) in self.columns.iter().zip(at) {
            row_of_mut(self.model)[*column] = value;
        }
    }

    #[inline(never)]
    fn rates(&mut self, time: f64, at: [f64; N]) -> [f64; N] {
        self.move_to(time, at);
        self.model.rate(&mut self.rate);
        self.columns.map(|column| row_of(&self.rate)[column])
    }
}

/// Columns of the states.
fn states<M: Columns, const N: usize>() -> [usize; N] {
    let mut states = (0..M::TABLE.len()).filter(|column| M::TABLE[*column].role.is_state());
    let columns = std::array::from_fn(|_| states.next().unwrap_or(usize::MAX));
    debug_assert!(states.next().is_none() && columns.last() < Some(&usize::MAX), "not {N} states");
    columns
}

/// The largest error of a state, relative to the larger of its value and its nominal value.
fn largest<M: Columns, const N: usize>(columns: &[usize; N], at: [f64; N], error: [f64; N]) -> f64 {
    let relative = |i: usize| (error[i] / at[i].abs().max(M::TABLE[columns[i]].nominal)).abs();
    // `f64::max` would hide what is not a number.
    (0..N).map(relative).fold(0.0, |largest, error| if error > largest || error.is_nan() { error } else { largest })
}
