//! From the tables of a rig to a record: checks, clocks, filters.

use crate::clock::{Clocks, Pair, range_around};
use crate::error::{MeasuredError, short};
use crate::matched_filter::{self, Filter, OF_ARM, TERMS};
use crate::movement::Movement;
use crate::plausible;
use crate::polynomial::Local;
use crate::quality::{noise, quality, rounding};
use crate::record::{Channel, Delay, Direction, Quality, Record, Setup};
use crate::statistics::{extremes, median};
use crate::stencil::derivatives;
use crate::window::{Signal, degree, order, shortest};
use stribeck_sheet::{DISPLACEMENT, FORCE, NORMAL_FORCE, Quantity, Sheet, TIME, VELOCITY};

/// Tolerance of a delay that was estimated without the law, in samples of the motion or standard deviations (chosen):
/// hysteretic friction looks like a delay, and its displacement is not known before the fit.
const TOLERANCE: f64 = 3.0;

/// Least number of samples.
const LEAST: usize = 20;

impl Record {
    /// Reads a table with the columns `time`, `force`, `displacement` or `velocity`, and perhaps `normal_force`; the
    /// motion may be in a table of its own, with its own times.
    pub fn of(sheet: &Sheet, motion: Option<&Sheet>, setup: &Setup) -> Result<Record, MeasuredError> {
        let movement = Movement::of(sheet, motion)?;
        check(setup, movement)?;
        let time = times(sheet)?;
        check_lengths(setup, &time)?;
        let force = sheet.required(FORCE.name, &movement.quantity(&FORCE))?;
        moving("force", &force)?;
        let load = load(sheet, setup, movement)?;
        let motion = match motion {
            Some(sheet) => Motion::of(sheet, movement).map_err(MeasuredError::of_motion)?,
            None => Motion::of(sheet, movement)?,
        };
        if setup.has_gravity && !(movement == Movement::Rotation && motion.has_displacement) {
            return Err(MeasuredError::NoAngle);
        }
        let channels = channels(sheet, setup, movement)?;
        let reduction = Reduction { setup, movement, time, force, load, channels, motion };
        let record = if setup.is_axis { reduction.matched()? } else { reduction.smoothed()? };
        record.finite()?;
        plausible::check(&record, setup)?;
        Ok(record)
    }
}

fn check(setup: &Setup, movement: Movement) -> Result<(), MeasuredError> {
    let wrong = |name, value, wanted: String| Err(MeasuredError::Setup { name, value, wanted });
    let values = [
        ("mass", Some(setup.mass), "kg"),
        ("skip", Some(setup.skip), "s"),
        ("normal_force", setup.normal_force, "N"),
        ("window", setup.window, "s"),
    ];
    for (name, value, unit) in values {
        if let Some(value) = value.filter(|value| !(*value >= 0.0 && value.is_finite())) {
            return wrong(name, value, format!(">= 0 and finite, in {}", movement.unit(unit)));
        }
    }
    match setup.delay {
        Delay::Known(delay) | Delay::Find(delay) if !delay.is_finite() => {
            wrong("delay", delay, "a finite number, in s".to_owned())
        }
        Delay::Find(longest) if longest <= 0.0 => wrong("longest delay", longest, "> 0, in s".to_owned()),
        _ => Ok(()),
    }
}

/// Rejects windows and delays longer than half the record.
fn check_lengths(setup: &Setup, time: &[f64]) -> Result<(), MeasuredError> {
    let half = 0.5 * (time[time.len() - 1] - time[0]);
    let longest = if let Delay::Find(longest) = setup.delay { Some(longest) } else { None };
    for (name, value) in [("window", setup.window), ("longest delay", longest)] {
        if let Some(value) = value.filter(|value| *value > half) {
            let wanted = format!("at most half of the record, {} s", short(half));
            return Err(MeasuredError::Setup { name, value, wanted });
        }
    }
    Ok(())
}

fn times(sheet: &Sheet) -> Result<Vec<f64>, MeasuredError> {
    let time = sheet.required(TIME.name, &TIME)?;
    if time.len() < LEAST {
        return Err(MeasuredError::Short { count: time.len(), least: LEAST });
    }
    match (1..time.len()).find(|at| time[*at] <= time[at - 1]) {
        Some(at) => Err(MeasuredError::Time { line: sheet.line(at), now: time[at], before: time[at - 1] }),
        None => Ok(time),
    }
}

fn moving(name: &'static str, values: &[f64]) -> Result<(), MeasuredError> {
    let value = values.first().copied().unwrap_or(f64::NAN);
    if values.iter().all(|other| *other == value) { Err(MeasuredError::Constant { name, value }) } else { Ok(()) }
}

/// Range of a channel, in standard deviations of its noise, up to which all of it may be noise (chosen: a million samples
/// of white noise have a range of 9.8).
const STILL: f64 = 10.0;

fn more_than_noise(name: &'static str, unit: &'static str, values: &[f64]) -> Result<(), MeasuredError> {
    let [low, high] = extremes(values.iter().copied());
    let (range, noise) = (high - low, noise(values));
    if range < STILL * noise { Err(MeasuredError::Still { name, range, noise, unit }) } else { Ok(()) }
}

/// Normal force of every sample: the column, or the value given.
pub fn load(sheet: &Sheet, setup: &Setup, movement: Movement) -> Result<Vec<f64>, MeasuredError> {
    let Some(loads) = sheet.column(&movement.quantity(&NORMAL_FORCE))? else {
        return setup.normal_force.map(|load| vec![load; sheet.len()]).ok_or(MeasuredError::NoLoad);
    };
    match loads.iter().position(|load| *load < 0.0) {
        Some(at) => Err(MeasuredError::Load { line: sheet.line(at), value: loads[at], unit: movement.unit("N") }),
        None => Ok(loads),
    }
}

/// The further quantities that a table has.
fn channels(sheet: &Sheet, setup: &Setup, movement: Movement) -> Result<Vec<Channel>, MeasuredError> {
    let quantities = setup.further.iter().map(|quantity| movement.quantity(quantity));
    let read = |quantity: Quantity| Ok(sheet.column(&quantity)?.map(|values| Channel { quantity, values }));
    quantities.filter_map(|quantity| read(quantity).transpose()).collect()
}

/// The motion on its own clock.
struct Motion {
    time: Vec<f64>,
    displacement: Vec<f64>,
    /// Whether it was measured.
    has_displacement: bool,
    /// Velocity, if it was measured.
    velocity: Option<Vec<f64>>,
}

impl Motion {
    fn of(sheet: &Sheet, movement: Movement) -> Result<Motion, MeasuredError> {
        let [of_displacement, of_velocity] = [&DISPLACEMENT, &VELOCITY].map(|quantity| movement.quantity(quantity));
        let time = times(sheet)?;
        let velocity = sheet.column(&of_velocity)?;
        let displacement = match (sheet.column(&of_displacement)?, &velocity) {
            (Some(displacement), _) => displacement,
            (None, Some(velocity)) => integral(&time, velocity),
            (None, None) => sheet.required(DISPLACEMENT.name, &of_displacement)?,
        };
        moving("displacement", &displacement)?;
        match &velocity {
            Some(velocity) => more_than_noise("velocity", movement.unit("m/s"), velocity)?,
            None => more_than_noise("displacement", movement.unit("m"), &displacement)?,
        }
        let has_displacement = sheet.has(DISPLACEMENT.name);
        Ok(Motion { time, displacement, has_displacement, velocity })
    }

    fn interval(&self) -> f64 {
        let mut steps: Vec<f64> = self.time.windows(2).map(|pair| pair[1] - pair[0]).collect();
        median(&mut steps)
    }

    /// First and last time.
    fn ends(&self) -> [f64; 2] {
        [self.time[0], self.time[self.time.len() - 1]]
    }

    /// Samples of the measured quantity, and the order of its derivative that is the acceleration.
    fn measured(&self) -> (&[f64], usize) {
        self.velocity.as_ref().map_or((&self.displacement, 2), |velocity| (velocity, 1))
    }

    /// Displacement, velocity and acceleration at a time, without a filter.
    fn unfiltered(&self, time: f64) -> [f64; 3] {
        let of_displacement = derivatives(&self.time, &self.displacement, time);
        self.velocity.as_ref().map_or(of_displacement, |velocity| {
            let [v, a, _] = derivatives(&self.time, velocity, time);
            [of_displacement[0], v, a]
        })
    }

    /// Displacement, velocity and acceleration at a time. A measured velocity is not smoothed.
    fn at(&self, [of_velocity, of_acceleration]: [f64; 2], time: f64) -> [f64; 3] {
        let in_window =
            |values, window, derivative| Local::new(&self.time, values, window, degree(derivative)).at(time);
        match &self.velocity {
            None => {
                let [x, v, _] = in_window(&self.displacement, of_velocity, 1);
                [x, v, in_window(&self.displacement, of_acceleration, 2)[2]]
            }
            Some(velocity) => {
                let [_, acceleration, _] = in_window(velocity, of_acceleration, 1);
                let [x, v] =
                    [&self.displacement, velocity].map(|values| super::cycle::interpolate(&self.time, values, time));
                [x, v, acceleration]
            }
        }
    }
}

/// Samples of the load cell on their clock, and the motion on its own.
struct Reduction<'a> {
    setup: &'a Setup,
    movement: Movement,
    time: Vec<f64>,
    force: Vec<f64>,
    load: Vec<f64>,
    channels: Vec<Channel>,
    motion: Motion,
}

impl Reduction<'_> {
    /// The record with the motion smoothed.
    fn smoothed(&self) -> Result<Record, MeasuredError> {
        let windows = self.windows(self.setup.window);
        self.joined(windows, self.clocks(windows))
    }

    /// The matched-filtered record of an axis.
    fn matched(&self) -> Result<Record, MeasuredError> {
        let Setup { mass, window, delay, .. } = *self.setup;
        let windows = self.windows(None);
        let clocks = self.clocks(windows);
        let record = self.joined(windows, clocks)?;
        let tolerance = match delay {
            Delay::Known(_) => 0.0,
            Delay::Find(longest) => longest,
            Delay::OfController => matched_filter::tolerance_of_controller(self.motion.interval()),
        };
        let raw = |delay: f64| {
            let clocks = Clocks { delay, ..clocks };
            record.time.iter().map(|t| self.motion.unfiltered(clocks.of_motion(*t))).collect()
        };
        let is_held = delay == Delay::OfController;
        let found = if self.setup.has_gravity {
            Filter::<OF_ARM>::new(&record, &raw, tolerance, is_held).apply(mass, window)
        } else {
            Filter::<TERMS>::new(&record, &raw, tolerance, is_held).apply(mass, window)
        };
        found.ok_or_else(|| {
            let window = window.unwrap_or(matched_filter::shortest(record.quality.interval));
            MeasuredError::NoStroke { window, tolerance }
        })
    }

    /// Windows for velocity and acceleration: the given one, or those with the least error.
    fn windows(&self, given: Option<f64>) -> [f64; 2] {
        let given = given.map(|window| [window.max(shortest(self.motion.interval(), 1)); 2]);
        let [first, second] = given.unwrap_or_else(|| self.signal().windows());
        if self.motion.velocity.is_some() { [0.0, first] } else { [first, second] }
    }

    /// Samples of the motion, and the part of them that the force covers at any admitted delay.
    fn signal(&self) -> Signal<'_> {
        let interval = self.motion.interval();
        let [least, most] = match self.setup.delay {
            Delay::Known(delay) => [delay; 2],
            Delay::Find(longest) => [-longest, longest],
            Delay::OfController => {
                let tolerance = matched_filter::tolerance_of_controller(interval);
                range_around(matched_filter::delay_of_controller(interval), tolerance)
            }
        };
        let [begin, end] = [self.time[0] + self.setup.skip + least, self.time[self.time.len() - 1] + most];
        let time = &self.motion.time;
        let covered = time.partition_point(|t| *t < begin)..time.partition_point(|t| *t <= end);
        let part = if covered.len() < LEAST { 0..time.len() } else { covered };
        Signal { time, values: self.motion.measured().0, interval, part }
    }

    /// Clocks, known or estimated from force and motion.
    fn clocks(&self, windows: [f64; 2]) -> Clocks {
        match self.setup.delay {
            Delay::Known(delay) => Clocks::known(delay),
            Delay::Find(longest) => {
                let motion = |time| self.motion.at(windows, time);
                Pair::new(&self.time, &self.force, self.motion.ends(), &motion).find(longest)
            }
            Delay::OfController => Clocks::known(matched_filter::delay_of_controller(self.motion.interval())),
        }
    }

    /// Force and motion on the clock of the force, where both are known.
    fn joined(&self, windows: [f64; 2], clocks: Clocks) -> Result<Record, MeasuredError> {
        let inside = self.overlap(clocks)?;
        let chosen = |all: &[f64]| inside.iter().map(|at| all[*at]).collect::<Vec<f64>>();
        let [time, force, normal_force] = [&self.time, &self.force, &self.load].map(|all| chosen(all));
        let motion = time.iter().map(|t| self.motion.at(windows, clocks.of_motion(*t)));
        let (displacement, (velocity, acceleration)): (Vec<f64>, (Vec<f64>, Vec<f64>)) =
            motion.map(|[x, v, a]| (x, (v, a))).unzip();
        Ok(self.assessed(Record {
            movement: self.movement,
            direction: self.setup.has_gravity.then(|| Direction::of(&displacement)),
            friction_force: force.iter().zip(&acceleration).map(|(force, a)| force - self.setup.mass * a).collect(),
            normal_force,
            channels: self.channels.iter().map(|one| one.with(chosen(&one.values))).collect(),
            is_differentiated: self.motion.velocity.is_none(),
            window: windows[0],
            acceleration_window: windows[1],
            motion_interval: self.motion.interval(),
            delay_range: self.delay_range(clocks),
            matched_filter: None,
            velocity_error: self.velocity_error(windows[0]),
            acceleration_error: self.signal().noise_in(windows[1], self.motion.measured().1),
            acceleration_lost: 0.0,
            motion_ends: clocks.ends(self.motion.ends()),
            quality: Quality::default(),
            time,
            force,
            displacement,
            velocity,
            acceleration,
            clocks,
        }))
    }

    /// A record with its quality, and with what the filter takes away.
    fn assessed(&self, mut record: Record) -> Record {
        record.quality = quality(&record, self.setup);
        record.acceleration_lost = self.acceleration_lost(&record);
        record
    }

    /// Samples of the force at which the motion is known too.
    fn overlap(&self, clocks: Clocks) -> Result<Vec<usize>, MeasuredError> {
        let motion @ [first, last] = self.motion.ends();
        let [begin, end] = [self.time[0] + self.setup.skip, self.time[self.time.len() - 1]];
        let is_inside = |t: f64| t >= begin && (first..=last).contains(&clocks.of_motion(t));
        let inside: Vec<usize> = (0..self.time.len()).filter(|at| is_inside(self.time[*at])).collect();
        if inside.len() >= LEAST {
            Ok(inside)
        } else if self.time.iter().filter(|t| **t >= begin).count() < LEAST {
            let wanted = format!("short enough to leave at least {LEAST} samples before {end} s");
            Err(MeasuredError::Setup { name: "skip", value: self.setup.skip, wanted })
        } else {
            Err(MeasuredError::Apart { force: [begin, end], motion })
        }
    }

    fn delay_range(&self, clocks: Clocks) -> Option<[f64; 2]> {
        let tolerance = TOLERANCE * self.motion.interval().max(clocks.deviation);
        (clocks.deviation > 0.0).then(|| range_around(clocks.delay, tolerance))
    }

    /// RMS error of the velocity near rest: its noise if it was measured, otherwise its error in a window.
    fn velocity_error(&self, window: f64) -> f64 {
        match &self.motion.velocity {
            Some(velocity) => noise(velocity).max(rounding(velocity)),
            None => self.signal().error(window),
        }
    }

    /// Fraction of the acceleration that its filter attenuates, extrapolated with a power of the window from the further
    /// attenuation in twice the window: the noise of the difference is not correlated with that in the longer window.
    fn acceleration_lost(&self, record: &Record) -> f64 {
        let window = record.acceleration_window;
        let (values, derivative) = self.motion.measured();
        let [one, twice] =
            [window, 2.0 * window].map(|window| Local::new(&self.motion.time, values, window, degree(derivative)));
        let [first, last] = [record.motion_ends[0] + window, record.motion_ends[1] - window];
        let (mut difference, mut square) = (0.0, 0.0);
        let inside = record.time.iter().filter(|t| (first..=last).contains(*t));
        for t in inside.step_by(record.time.len().div_ceil(COMPARED)) {
            let [a, damped] = [one, twice].map(|local| local.at(record.clocks.of_motion(*t))[derivative]);
            difference += (a - damped) * damped;
            square += damped * damped;
        }
        let further = 2.0_f64.powi(order(derivative)) - 1.0;
        if square > 0.0 { (difference / (further * square)).max(0.0) } else { 0.0 }
    }
}

/// Most samples at which two filters are compared (chosen).
const COMPARED: usize = 2000;

pub(crate) fn integral(time: &[f64], velocity: &[f64]) -> Vec<f64> {
    let mut displacement = vec![0.0];
    for at in 1..time.len() {
        let step = 0.5 * (velocity[at] + velocity[at - 1]) * (time[at] - time[at - 1]);
        displacement.push(displacement[at - 1] + step);
    }
    displacement
}
