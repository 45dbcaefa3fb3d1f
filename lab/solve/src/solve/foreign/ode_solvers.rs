//! The explicit methods of the crate ode_solvers.
//!
//! The crate takes one absolute tolerance for all states: it is given them in parts of their sizes.

use std::cell::RefCell;

use ::ode_solvers::continuous_output_model::ContinuousOutputModel;
use ::ode_solvers::dop_shared::{IntegrationError, OutputType, Stats, System};
use ::ode_solvers::{Dop853, Dopri5};
use nalgebra::allocator::Allocator;
use nalgebra::{Const, DefaultAllocator, Dim, Dyn, OVector, U1};

use super::bridge::Bridge;
use super::{Run, Stop, report};
use crate::solve::event::Watch;
use crate::solve::{Options, Recorder};

/// The controller of step sizes as the crate has it by default: safety factor, beta, smallest and largest change.
const SAFETY: f64 = 0.9;
const BETA: f64 = 0.04;
const SHRINK: f64 = 0.2;
const GROW: f64 = 10.0;

/// Steps between two tests for stiffness: none, so that a stiff run takes its many steps instead of being refused.
const STIFFNESS_TESTS: u32 = u32::MAX;

/// Part of a step to which an event is located (chosen).
const PRECISION: f64 = 1e-13;

/// Steps of DOPRI5 after which it is started anew (chosen): the crate keeps the motion of every step until it stops, some
/// 250 bytes each, and an explicit method makes millions of steps where equations are stiff.
const KEPT: u64 = 200_000;

/// A stretch of the run, in the variable x of the crate: time = origin + unit x.
#[derive(Clone, Copy)]
struct Stretch {
    origin: f64,
    unit: f64,
    begin: f64,
    end: f64,
}

impl Stretch {
    fn time(&self, x: f64) -> f64 {
        self.origin + self.unit * x
    }
}

/// What is known of the steps while the crate makes them.
struct Seen {
    steps: u64,
    /// Beginning and end of the last step.
    last: [f64; 2],
    states: Vec<f64>,
    watch: Option<Watch>,
    event: Option<usize>,
    is_cancelled: bool,
    /// Whether as many steps are kept as may be, and the end is not reached.
    is_full: bool,
}

/// The equations as the crate wants them.
struct Course<'a, 'e> {
    bridge: &'a Bridge<'e>,
    scales: &'a [f64],
    options: &'a Options<'a>,
    stretch: Stretch,
    /// Steps made before.
    before: u64,
    /// Whether x is a state, behind the others: DOP853 (of 0.6.2) takes the beginning of a step for its end in two stages,
    /// and so errs wherever rates depend on time itself.
    has_clock: bool,
    seen: &'a RefCell<Seen>,
}

/// States in their own units.
fn unscale<D: Dim>(y: &OVector<f64, D>, scales: &[f64], states: &mut [f64])
where
    DefaultAllocator: Allocator<D>,
{
    for ((state, y), scale) in states.iter_mut().zip(y.iter()).zip(scales) {
        *state = y * scale;
    }
}

impl<D: Dim> System<f64, OVector<f64, D>> for Course<'_, '_>
where
    DefaultAllocator: Allocator<D>,
{
    fn system(&self, x: f64, y: &OVector<f64, D>, dy: &mut OVector<f64, D>) {
        let states = &mut self.seen.borrow_mut().states;
        unscale(y, self.scales, states);
        let x = if self.has_clock { y[states.len()] } else { x };
        let (rates, clock) = dy.as_mut_slice().split_at_mut(states.len());
        clock.fill(1.0);
        self.bridge.rates(self.stretch.time(x), states, rates);
        for (rate, scale) in rates.iter_mut().zip(self.scales) {
            *rate *= self.stretch.unit / scale;
        }
    }

    /// The end of a step. `y` is the state there unless the crate gives dense output by itself.
    fn solout(&mut self, x: f64, y: &OVector<f64, D>, _dy: &OVector<f64, D>) -> bool {
        let seen = &mut *self.seen.borrow_mut();
        seen.steps += 1;
        seen.last = [seen.last[1], x];
        let time = self.stretch.time(x);
        report(self.options, self.before + seen.steps, time);
        seen.is_cancelled = self.options.is_cancelled();
        if let Some(watch) = &mut seen.watch {
            unscale(y, self.scales, &mut seen.states);
            let states = &seen.states;
            seen.event = self.bridge.with(|equations| watch.changed(equations, time, states));
            if seen.event.is_none() {
                self.bridge.with(|equations| watch.begin(equations, time, states));
            }
        }
        // DOP853, which has the clock, keeps the states at output times only.
        seen.is_full = !self.has_clock && seen.steps >= KEPT && x < self.stretch.end;
        seen.is_cancelled || seen.is_full || seen.event.is_some()
    }
}

/// A solver of the crate for a stretch, with the crate's own settings.
macro_rules! solver {
    ($Solver:ident, $has_clock:literal, $run:ident, $stretch:ident, $seen:ident, $dim:ident, $output:expr) => {{
        let Run { bridge, options, scales, .. } = *$run;
        let before = $run.statistics.steps;
        let course = Course { bridge, scales, options, stretch: $stretch, before, has_clock: $has_clock, seen: &$seen };
        let longest = (options.longest / $stretch.unit).min($stretch.end - $stretch.begin);
        let most = u32::try_from($run.steps_left()).unwrap_or(u32::MAX);
        let Options { relative, absolute, .. } = *options;
        // The interval of dense output is the unit; the first step is chosen by the crate.
        $Solver::from_param(
            course,
            $stretch.begin,
            $stretch.end,
            1.0,
            $run.scaled($stretch.begin, $dim),
            relative,
            absolute,
            SAFETY,
            BETA,
            SHRINK,
            GROW,
            longest,
            0.0,
            most,
            STIFFNESS_TESTS,
            $output,
        )
    }};
}

/// Dispatches on the number of states: with few of them the crate's vectors need no memory of the heap.
macro_rules! by_size {
    ($count:expr, $function:ident($run:ident, $($argument:expr),*)) => {
        match $count {
            1 => $function($run, $($argument,)* Const::<1>),
            2 => $function($run, $($argument,)* Const::<2>),
            3 => $function($run, $($argument,)* Const::<3>),
            4 => $function($run, $($argument,)* Const::<4>),
            count => $function($run, $($argument,)* Dyn(count)),
        }
    };
}

impl Run<'_, '_> {
    /// The states in parts of their sizes, and x behind them if there is room.
    fn scaled<D: Dim>(&self, x: f64, dim: D) -> OVector<f64, D>
    where
        DefaultAllocator: Allocator<D>,
    {
        let parts = self.states.iter().zip(self.scales).map(|(state, scale)| state / scale);
        OVector::from_iterator_generic(dim, U1, parts.chain([x]).take(dim.value()))
    }

    fn seen(&self, stretch: Stretch) -> RefCell<Seen> {
        let watch = self.has_events().then(|| {
            self.bridge.with(|equations| {
                let mut watch = Watch::new(equations, equations.states());
                watch.begin(equations, self.time, &self.states);
                watch
            })
        });
        let (last, states) = ([stretch.begin; 2], self.states.clone());
        RefCell::new(Seen { steps: 0, last, states, watch, event: None, is_cancelled: false, is_full: false })
    }

    /// Counts what the crate has done.
    fn count(&mut self, seen: &Seen, done: &Result<Stats, IntegrationError>) -> Option<String> {
        self.statistics.steps += seen.steps;
        match done {
            Ok(stats) => {
                self.statistics.rejected += u64::from(stats.rejected_steps);
                None
            }
            Err(IntegrationError::MaxNumStepReached { .. }) => Some(self.too_many_steps()),
            Err(IntegrationError::StepSizeUnderflow { .. }) => {
                Some("ode_solvers' step has become too short".to_owned())
            }
            Err(other) => Some(format!("ode_solvers: {other}")),
        }
    }
}

/// Runs to the wall, or to an event before it.
pub(super) fn dopri5(run: &mut Run, wall: f64) -> Result<Stop, String> {
    by_size!(run.states.len(), dopri5_of(run, wall))
}

fn dopri5_of<D: Dim>(run: &mut Run, wall: f64, dim: D) -> Result<Stop, String>
where
    DefaultAllocator: Allocator<D>,
{
    let stretch = Stretch { origin: run.time, unit: 1.0, begin: 0.0, end: wall - run.time };
    let seen = run.seen(stretch);
    let mut model = ContinuousOutputModel::new();
    let mut solver = solver!(Dopri5, false, run, stretch, seen, dim, OutputType::Continuous);
    let done = solver.integrate_with_continuous_output_model(&mut model);
    let mut states = run.states.clone();
    if let Some(last) = solver.y_out().last() {
        unscale(last, run.scales, &mut states);
    }
    drop(solver);
    let mut seen = seen.into_inner();
    let failure = run.count(&seen, &done);
    if seen.steps > 0 {
        let motion = |x: f64, states: &mut [f64]| {
            if let Some(y) = model.evaluate(x.clamp(0.0, model.bounds().1)) {
                unscale(&y, run.scales, states);
            }
        };
        let end = match seen.event {
            None => seen.last[1],
            Some(_) => locate(run, &mut seen, stretch, &motion),
        };
        record(run.recorder, run.bridge, stretch, end, &motion)?;
        if seen.event.is_some() {
            motion(end, &mut states);
        }
        run.time = stretch.time(end);
    }
    run.states = states;
    match (failure, seen.event) {
        (Some(failure), _) => Err(failure),
        (None, Some(event)) => Ok(Stop::Event(event)),
        (None, None) if seen.is_cancelled => Ok(Stop::Cancelled),
        (None, None) if seen.is_full => Ok(Stop::Between),
        (None, None) => Ok(Stop::Wall),
    }
}

/// Halves the last step, at whose end an indicator has changed its sign, by the crate's dense output.
fn locate(run: &Run, seen: &mut Seen, stretch: Stretch, motion: &impl Fn(f64, &mut [f64])) -> f64 {
    let [mut low, mut high] = seen.last;
    let precision = PRECISION * (high - low) + 4.0 * f64::EPSILON * stretch.time(high).abs();
    let Some(watch) = &mut seen.watch else { return high };
    while high - low > precision {
        let middle = 0.5 * (low + high);
        motion(middle, &mut seen.states);
        let states = &seen.states;
        match run.bridge.with(|equations| watch.changed(equations, stretch.time(middle), states)) {
            Some(event) => (high, seen.event) = (middle, Some(event)),
            None => low = middle,
        }
    }
    high
}

/// Records the output times up to the end of a stretch.
fn record(
    recorder: &mut Recorder,
    bridge: &Bridge,
    stretch: Stretch,
    end: f64,
    motion: &impl Fn(f64, &mut [f64]),
) -> Result<(), String> {
    let mut states = bridge.with(|equations| vec![0.0; equations.states()]);
    while let Some(time) = recorder.next().filter(|time| *time <= stretch.time(end)) {
        motion((time - stretch.origin) / stretch.unit, &mut states);
        bridge.with(|equations| recorder.point(equations, &states))?;
    }
    Ok(())
}

/// Runs to the wall, by the numbers of the output times: the crate gives dense output at equal intervals only.
///
/// Its last dense output (of 0.6.2) may be extrapolated from a step that ends before it, and its last state is not to be
/// had beside dense output. So it runs densely to the last output time before the wall, as part of a run to the wall, and
/// from there once more without.
pub(super) fn dop853(run: &mut Run, wall: f64) -> Result<Stop, String> {
    by_size!(run.states.len() + 1, dop853_of(run, wall))
}

fn dop853_of<D: Dim>(run: &mut Run, wall: f64, dim: D) -> Result<Stop, String>
where
    DefaultAllocator: Allocator<D>,
{
    let grid = run.recorder.grid();
    let unit = (grid.end - grid.begin) / grid.intervals as f64;
    let number = |time: f64| if time == grid.end { grid.intervals as f64 } else { (time - grid.begin) / unit };
    let mut stretch = Stretch { origin: grid.begin, unit, begin: number(run.time), end: number(wall) };
    let last = stretch.end.ceil() - 1.0;
    if stretch.begin < last {
        let first = stretch.begin.ceil();
        if stretch.begin < first {
            let before = Stretch { end: first, ..stretch };
            if let Some(stop) = segment(run, before, OutputType::Sparse, dim)? {
                return Ok(stop);
            }
            stretch.begin = first;
        }
        if let Some(stop) = segment(run, stretch, OutputType::Dense, dim)? {
            return Ok(stop);
        }
        stretch.begin = last;
    }
    Ok(segment(run, stretch, OutputType::Sparse, dim)?.unwrap_or(Stop::Wall))
}

/// Runs to the end of a stretch, or densely to the last output time before it.
fn segment<D: Dim>(run: &mut Run, stretch: Stretch, output: OutputType, dim: D) -> Result<Option<Stop>, String>
where
    DefaultAllocator: Allocator<D>,
{
    let seen = run.seen(stretch);
    let is_dense = output == OutputType::Dense;
    let mut solver = solver!(Dop853, true, run, stretch, seen, dim, output);
    let done = solver.integrate();
    let (numbers, results) = solver.results().get();
    let (mut states, mut at) = (run.states.clone(), stretch.begin);
    for (number, y) in numbers.iter().zip(results) {
        let is_past = *number > seen.borrow().last[1] || is_dense && *number >= stretch.end;
        if !is_past {
            unscale(y, run.scales, &mut states);
            at = *number;
            if run.recorder.next().is_some() && run.recorder.len() as f64 == at {
                run.bridge.with(|equations| run.recorder.point(equations, &states))?;
            }
        }
    }
    let seen = seen.borrow();
    run.time = stretch.time(at);
    run.states = states;
    match run.count(&seen, &done) {
        Some(failure) => Err(failure),
        None => Ok(seen.is_cancelled.then_some(Stop::Cancelled)),
    }
}
