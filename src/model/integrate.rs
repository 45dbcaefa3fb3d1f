//! Integration of a model whose rates follow from its states and its inputs.

use crate::model::ramp::{Inputs, set_inputs};
use crate::model::{Described, Model, row_of, row_of_mut};
use crate::numerics::rosenbrock::rosenbrock;
use crate::numerics::runge_kutta::{dormand_prince, growth};

/// Error allowed in a piece of a step, relative to the larger of the state and its nominal value (chosen).
const TOLERANCE: f64 = 1e-10;

/// The same for those who compare a force with a measured one, which has more noise by far (chosen).
const COARSE: f64 = 1e-6;

/// Pieces of such a step after which its rates are taken for stiff (chosen: smooth motion between samples takes fewer).
const SMOOTH: u32 = 16;

/// Length of a piece in s within which the model may change its branch (chosen: where the rate of the rate jumps by j,
/// it leaves an error of less than j times its square, 1e-10 m/s for a wheel that lands at 1 m/s).
const CHANGE: f64 = 1e-7;

/// Largest number of pieces of a step, per state (chosen: about a second of computation, and half an hour of a ride).
const MOST_PIECES_TIMES_STATES: u32 = 2_000_000;

/// Ten times per budget of pieces, the rest of the step is extrapolated; it is given up if it would need more than
/// `HOPELESS` budgets (chosen), so that a hopeless step costs a tenth of one.
const OUTLOOKS: u32 = 10;
const HOPELESS: f64 = 10.0;

/// States that move continuously through a step.
pub(crate) trait Moving<const N: usize> {
    /// Whether an error of 1e-6 is small enough. Such steps go on by an implicit method where the rates are stiff, as they are
    /// with some of the parameters that a search tries.
    const IS_COARSE: bool = false;

    /// Error allowed in a piece.
    const TOLERANCE: f64 = if Self::IS_COARSE { COARSE } else { TOLERANCE };

    /// Rates at a time after the beginning of the step and at these states.
    fn rates(&mut self, time: f64, at: [f64; N]) -> [f64; N];

    /// Whether a piece of this length that ends here leaves the branch on which it began; if not, the next one begins
    /// here.
    fn leaves(&mut self, _end: f64, _next: [f64; N], _length: f64) -> bool {
        false
    }
}

/// The states after `dt`, from those before; none if the step would take too many pieces. Errors are relative to the
/// larger of a state and its nominal value.
pub(crate) fn moved<M: Moving<N>, const N: usize>(
    moving: &mut M,
    mut at: [f64; N],
    nominal: [f64; N],
    dt: f64,
) -> Option<[f64; N]> {
    let (mut time, mut piece) = (0.0, dt);
    let most = const { MOST_PIECES_TIMES_STATES / N as u32 };
    let mut last_look = 0.0;
    for count in 1..=most {
        // A remainder hardly longer than the piece is made in one.
        let end = if time + 1.01 * piece >= dt { dt } else { time + piece };
        let length = end - time;
        let rates = |since, at| moving.rates(time + since, at);
        let (next, error) = if M::IS_COARSE && count > SMOOTH {
            rosenbrock(rates, at, std::array::from_fn(|i| at[i].abs().max(nominal[i])), length)
        } else {
            dormand_prince(rates, at, length)
        };
        let error = largest(&nominal, next, error) / M::TOLERANCE;
        piece = length * growth(error);
        if error <= 1.0 {
            if moving.leaves(end, next, length) {
                piece = 0.25 * length;
                continue;
            }
            (time, at) = (end, next);
            if time >= dt {
                return Some(at);
            }
        }
        if time + piece <= time {
            return None;
        }
        if count.is_multiple_of(most / OUTLOOKS) {
            let pace = f64::from(OUTLOOKS) * (time - last_look);
            if dt - time > HOPELESS * pace {
                return None;
            }
            last_look = time;
        }
    }
    None
}

/// Advances the `N` states of `model` by `dt` while its inputs are held.
pub(crate) fn held<M: Model, const N: usize>(model: &mut M, dt: f64) {
    advance_by::<M, N>(model, None, dt);
}

/// Advances the `N` states of `model` by `dt` while its inputs move with `slope`. A step that would take too many
/// pieces gives NaN, which the caller refuses.
pub(crate) fn advance<M: Model, const N: usize>(model: &mut M, slope: &M, dt: f64) {
    advance_by::<M, N>(model, Some(slope), dt);
}

/// A model within a step, with workspace for its rates: a car's row is long, and the stack of a host may be small.
struct Motion<'a, M: Model, const N: usize> {
    branches: u32,
    model: &'a mut M,
    begin: Inputs,
    rate: M,
    /// Slope of the inputs, if they move.
    slope: Option<&'a M>,
    columns: [usize; N],
}

impl<M: Model, const N: usize> Motion<'_, M, N> {
    /// Sets the model to a time after the beginning of the step and to these states.
    fn put(&mut self, time: f64, at: [f64; N]) {
        if let Some(slope) = self.slope {
            set_inputs(self.model, &self.begin, slope, time);
        }
        for (column, value) in self.columns.iter().zip(at) {
            row_of_mut(self.model)[*column] = value;
        }
    }
}

impl<M: Model, const N: usize> Moving<N> for Motion<'_, M, N> {
    fn rates(&mut self, time: f64, at: [f64; N]) -> [f64; N] {
        self.put(time, at);
        self.model.rate(&mut self.rate);
        self.columns.map(|column| row_of(&self.rate)[column])
    }

    fn leaves(&mut self, end: f64, next: [f64; N], length: f64) -> bool {
        self.put(end, next);
        let branches = self.model.branches();
        let leaves = branches != self.branches && length > CHANGE;
        if !leaves {
            self.branches = branches;
        }
        leaves
    }
}

fn advance_by<M: Model, const N: usize>(model: &mut M, slope: Option<&M>, dt: f64) {
    let columns = states::<M, N>();
    let branches = model.branches();
    let mut motion = Motion { branches, begin: Inputs::of(model), rate: *model, model, slope, columns };
    let at = columns.map(|column| row_of(motion.model)[column]);
    let end = moved(&mut motion, at, nominal::<M, N>(), dt);
    motion.put(dt, end.unwrap_or([f64::NAN; N]));
}

/// Columns of the states that move with time.
fn states<M: Described, const N: usize>() -> [usize; N] {
    let is_moving = |column: usize| M::COLUMNS.role(column).is_state() && M::COLUMNS.at(column).is_continuous_state();
    let mut states = (0..M::TABLE.len()).filter(|column| is_moving(*column));
    let columns = std::array::from_fn(|_| states.next().unwrap_or(usize::MAX));
    debug_assert!(states.next().is_none() && columns.last() < Some(&usize::MAX), "not {N} states");
    columns
}

/// Their nominal values.
pub(crate) fn nominal<M: Described, const N: usize>() -> [f64; N] {
    states::<M, N>().map(|column| M::COLUMNS.nominal(column))
}

/// The largest error of a state, relative to the larger of its value and its nominal value.
fn largest<const N: usize>(nominal: &[f64; N], at: [f64; N], error: [f64; N]) -> f64 {
    let relative = |i: usize| (error[i] / at[i].abs().max(nominal[i])).abs();
    // `f64::max` would hide NaN.
    (0..N).map(relative).fold(0.0, |largest, error| if error > largest || error.is_nan() { error } else { largest })
}
