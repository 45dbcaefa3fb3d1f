//! Runs: a system, a solver, and what came of it.

mod check;
mod communication_step;
mod configuration;
mod likeness;
mod outcome;
mod progress;
mod solver;
mod step;

use std::time::{Duration, Instant};

use stribeck::model::Brief;
use stribeck::number::elementary::pow;

pub use communication_step::{CommunicationSteps, Order, Search, Trial, communication_steps};
pub use configuration::{Configuration, Vary, words};
pub use likeness::Deviation;
pub use outcome::{Check, Column, Difference, Finer, Outcome, Passed};
pub use solver::{Kind, Solver};
pub use step::Step;

use crate::couple::{Exchange, Master, by_steps, co_simulation};
#[cfg(feature = "foreign")]
use crate::solve::solve_foreign;
use crate::solve::{End, Equations, Grid, MOST_STEPS, Options, Progress, Recorder, Statistics, solve};
use crate::system::{Fault, Motion, Part, System, WireSource};

/// How a system is run.
#[derive(Clone, Copy, Debug)]
pub struct Settings<'a> {
    /// The solver.
    pub solver: Solver,
    /// Relative and absolute tolerance.
    pub tolerance: f64,
    /// End of the run, in s.
    pub until: f64,
    /// Interval of the results, in s.
    pub every: f64,
    /// Whether events are located.
    pub events: bool,
    /// The master, for co-simulation.
    pub master: Master,
    /// Whether the run is repeated at a tenth of its steps' tolerance, or of the master's step.
    pub is_checked: bool,
    /// Largest number of steps, rejected ones included.
    pub most_steps: u64,
    /// Set from outside to end the run early.
    pub cancel: Option<&'a std::sync::atomic::AtomicBool>,
    /// Listener to the progress.
    pub progress: Option<&'a dyn Progress>,
}

/// Largest number of output times (chosen): a table of a gigabyte.
const MOST_ROWS: f64 = 2e7;

/// Tolerance up to which that of the steps is the same.
const FINE: f64 = 1e-8;

/// Power of a larger tolerance with which that of the steps grows (chosen): 1e-6 at 1e-3.
const GROWTH: f64 = 0.4;

/// Least tolerance: a few roundings of a number.
const LEAST_TOLERANCE: f64 = 1e-14;

impl Settings<'_> {
    /// The settings of a system's description, with the default solver at 1e-8.
    pub fn of(system: &System) -> Settings<'static> {
        let (until, every) = (system.description.until, system.description.every);
        let master = Master { step: 1e-3, exchange: Exchange::Sequential, jitter: 0.0 };
        let (solver, tolerance) = (Solver::Auto, 1e-8);
        let (events, is_checked, most_steps) = (true, false, MOST_STEPS);
        let (cancel, progress) = (None, None);
        Settings { solver, tolerance, until, every, events, master, is_checked, most_steps, cancel, progress }
    }

    /// Refuses settings with which nothing can be run.
    pub fn check(&self) -> Result<(), Fault> {
        for (name, value, unit) in
            [("until", self.until, " s"), ("every", self.every, " s"), ("tolerance", self.tolerance, "")]
        {
            if !(value > 0.0 && value.is_finite()) {
                return Err(Fault::value(format_args!("{name} = {}{unit}: must be > 0 and finite", Brief(value))));
            }
        }
        if self.tolerance < LEAST_TOLERANCE || self.tolerance > 0.1 {
            let text = format_args!("tolerance = {:e}: must be between {LEAST_TOLERANCE:e} and 0.1", self.tolerance);
            return Err(Fault::value(text));
        }
        if self.is_checked && self.solver != Solver::CoSimulation {
            check::can_be_finer(self.tolerance)?;
        }
        let rows = self.until / self.every;
        if rows > MOST_ROWS {
            let rows = if rows < 1e15 { format!("{rows:.0}") } else { format!("{rows:.0e}") };
            let every = Brief(self.every);
            return Err(Fault::value(format_args!("every = {every} s gives {rows} rows: at most {MOST_ROWS}")));
        }
        Ok(())
    }

    /// The output times: multiples of the interval, and the end.
    fn grid(&self) -> Grid {
        Grid { begin: 0.0, end: self.until, intervals: ((self.until / self.every).round() as usize).max(1) }
    }

    fn options(&self) -> Options<'_> {
        Options {
            events: self.events,
            most_steps: self.most_steps,
            cancel: self.cancel,
            progress: self.progress,
            ..Options::new(self.until, self.tolerance)
        }
    }
}

/// The tolerance of a step of our methods by which the motion keeps that of the run: friction that falls with speed
/// amplifies an error made before breakaway a thousandfold, so that a loose step may change the whole motion.
fn of_steps(tolerance: f64) -> f64 {
    tolerance.min(FINE) * pow((tolerance / FINE).max(1.0), GROWTH)
}

/// The tolerance of a run whose steps have this one.
fn of_run(steps: f64) -> f64 {
    steps.min(FINE) * pow((steps / FINE).max(1.0), 1.0 / GROWTH)
}

/// Runs a system and records the named results: variables such as `rig.position`, or `der(rig.block_velocity)`.
/// If the settings ask for it, the run is repeated, and the outcome has the difference.
pub fn run(system: &System, settings: &Settings, results: &[String]) -> Result<Outcome, Fault> {
    settings.check()?;
    if settings.is_checked { check::checked(system, settings, results) } else { once(system, settings, results) }
}

/// Makes one run.
fn once(system: &System, settings: &Settings, results: &[String]) -> Result<Outcome, Fault> {
    let sources = results.iter().map(|name| system.source(name)).collect::<Result<Vec<WireSource>, Fault>>()?;
    let solver = settings.solver.for_system(system);
    // A browser has its own clock, which the standard library does not know.
    let begin = cfg!(not(target_family = "wasm")).then(Instant::now);
    let Ran { end, statistics, time, values, parts } = start(system, solver, settings, &sources)?;
    let columns = results.iter().zip(&sources).zip(values);
    let columns =
        columns.map(|((name, source), values)| Column { name: name.clone(), unit: system.unit(*source).name, values });
    let columns = columns.collect();
    let events = statistics.events.iter().zip(parts).map(|(event, part)| Passed { time: event.time, part });
    let events = events.collect();
    let elapsed = begin.map_or(Duration::ZERO, |begin| begin.elapsed());
    Ok(Outcome { law: system.law, solver, time, columns, end, statistics, events, elapsed, check: None })
}

/// What a solver gives back.
struct Ran {
    end: End,
    statistics: Statistics,
    time: Vec<f64>,
    values: Vec<Vec<f64>>,
    /// The part of which each event was.
    parts: Vec<String>,
}

fn start(system: &System, solver: Solver, settings: &Settings, sources: &[WireSource]) -> Result<Ran, Fault> {
    let (grid, options) = (settings.grid(), settings.options());
    let kind = solver.kind();
    if !settings.events && !matches!(kind, Kind::Steps | Kind::CoSimulation) {
        needs_no_events(system)?;
    }
    let (end, statistics, (time, values)) = match kind {
        Kind::Own(method) => {
            let tolerance = of_steps(settings.tolerance);
            let options = Options { relative: tolerance, absolute: tolerance, ..options };
            return of_motion(system, sources, grid, |motion, states, recorder| {
                Ok(solve(method, motion, states, &options, recorder))
            });
        }
        #[cfg(feature = "foreign")]
        Kind::Foreign(foreign) => {
            return of_motion(system, sources, grid, |motion, states, recorder| {
                if motion.has_past() {
                    return Err(Fault::value(format_args!("solver {solver}: keeps no past, which a law follows")));
                }
                if motion.has_bonds() {
                    return Err(Fault::value(format_args!("solver {solver}: follows no bonds that snap one by one")));
                }
                let refused = |fault: Fault| Fault::value(format_args!("solver {solver}: {fault}"));
                solver::check_slopes(motion).map_err(refused)?;
                let locates = settings.events && motion.indicators() > 0;
                check_foreign(solver, !locates || foreign.has_events(), states)?;
                Ok(solve_foreign(foreign, motion, states, &options, recorder))
            });
        }
        Kind::CoSimulation => co_simulation(system, &settings.master, grid, &options, sources)?,
        Kind::Steps => by_steps(system, grid, &options, sources)?,
    };
    Ok(Ran { end, statistics, time, values, parts: Vec::new() })
}

/// Refuses what a solver of another crate cannot do.
#[cfg(feature = "foreign")]
fn check_foreign(solver: Solver, can_locate: bool, states: &[f64]) -> Result<(), Fault> {
    if !can_locate {
        return Err(Fault::value(format_args!("solver {solver}: does not locate events; run it without")));
    }
    if states.is_empty() {
        let text = format_args!("solver {solver}: the system has no continuous state that it could integrate");
        return Err(Fault::value(text));
    }
    Ok(())
}

/// Refuses parts that come to rest at events only.
fn needs_no_events(system: &System) -> Result<(), Fault> {
    for Part { name, model, row, .. } in &system.parts {
        let refused = |fault| Fault::value(format_args!("{name}: {}: {fault}", model.name));
        model.check_without_events(row).map_err(refused)?;
    }
    Ok(())
}

/// Runs the equations of motion.
fn of_motion(
    system: &System,
    sources: &[WireSource],
    grid: Grid,
    run: impl FnOnce(&mut Motion, &mut [f64], &mut Recorder) -> Result<(End, Statistics), Fault>,
) -> Result<Ran, Fault> {
    let mut motion = Motion::new(system, sources)?;
    // States come from the polynomials of the steps, everything else from the models.
    let state = |source: &WireSource| motion.places().iter().position(|place| WireSource::Variable(*place) == *source);
    let states: Vec<Option<usize>> = sources.iter().map(state).collect();
    let others = sources.iter().zip(&states).filter(|(_, state)| state.is_none()).map(|(source, _)| *source);
    motion.record_only(others.collect());
    let mut recorder = Recorder::new(grid, &motion);
    let mut now = motion.start();
    let (end, statistics) = run(&mut motion, &mut now, &mut recorder)?;
    recorder.finish();
    let parts = statistics.events.iter().map(|event| motion.indicator_name(event.indicator)).collect();
    let time = recorder.times().collect();
    let Recorder { states: mut moved, values: computed, .. } = recorder;
    let mut computed = computed.into_iter();
    let values = states.iter().map(|state| match state {
        Some(state) => std::mem::take(&mut moved[*state]),
        None => computed.next().unwrap_or_default(),
    });
    Ok(Ran { end, statistics, time, values: values.collect(), parts })
}

impl Outcome {
    /// Whether the run came to its end.
    pub fn is_reached(&self) -> bool {
        self.end == End::Reached
    }

    /// Why the outcome is not what was asked for: the run did not come to its end, or a check says that its tolerance
    /// does not hold.
    pub fn fault(&self) -> Option<String> {
        if self.is_reached() { self.check.as_ref()?.fault.clone() } else { Some(self.end.to_string()) }
    }
}
