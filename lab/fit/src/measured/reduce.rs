//! The way from the tables of a rig to a record: checks, clocks, filters.

use super::MeasuredError;
use super::alike;
use super::clock::{Clocks, Pair, around};
use super::error::short;
use super::plausible;
use super::polynomial::Local;
use super::quality::{median, noise, quality, rounding};
use super::record::{Delay, Quality, Record, Rig};
use super::stencil::derivatives;
use super::window::{Signal, shortest};
use crate::sheet::{DISPLACEMENT, FORCE, NORMAL_FORCE, Sheet, TIME, VELOCITY};
/// Samples of the motion, or standard deviations, by which a delay that was found without the law may be off (chosen):
/// friction that turns within some way looks late, and its way is not known before the fit.
const DOUBT: f64 = 3.0;

/// Least number of samples.
const LEAST: usize = 20;

impl Record {
    /// Reads a table with the columns `time`, `force`, `displacement` or `velocity`, and perhaps `normal_force`; the
    /// motion may be in a table of its own, with its own times.
    pub fn of(sheet: &Sheet, motion: Option<&Sheet>, rig: &Rig) -> Result<Record, MeasuredError> {
        check(rig)?;
        let time = times(sheet)?;
        check_lengths(rig, &time)?;
        let force = sheet.required(FORCE.name, &FORCE)?;
        moving("force", &force)?;
        let load = load(sheet, rig)?;
        let own = Own { time: &time, force: &force, load: &load };
        let moved = match motion {
            Some(motion) => Motion::of(motion).map_err(MeasuredError::of_motion)?,
            None => Motion::of(sheet)?,
        };
        let record = if rig.is_axis { moved.of_axis(&own, rig)? } else { moved.record(&own, rig)? };
        record.finite()?;
        plausible::check(&record, rig)?;
        Ok(record)
    }
}

fn check(rig: &Rig) -> Result<(), MeasuredError> {
    let delay = match rig.delay {
        Delay::Known(delay) => delay,
        Delay::Find(longest) => longest,
        Delay::OfController => 0.0,
    };
    let wrong = |name, value, wanted: &str| Err(MeasuredError::Rig { name, value, wanted: wanted.to_owned() });
    match rig {
        _ if !(rig.mass >= 0.0 && rig.mass.is_finite()) => wrong("mass", rig.mass, ">= 0 and finite, in kg"),
        _ if !(rig.skip >= 0.0 && rig.skip.is_finite()) => wrong("skip", rig.skip, ">= 0 and finite, in s"),
        _ if !delay.is_finite() => wrong("delay", delay, "a finite number, in s"),
        Rig { delay: Delay::Find(longest), .. } if *longest <= 0.0 => wrong("longest delay", *longest, "> 0, in s"),
        Rig { normal_force: Some(load), .. } if !(*load >= 0.0 && load.is_finite()) => {
            wrong("normal_force", *load, ">= 0 and finite, in N")
        }
        Rig { window: Some(window), .. } if !(*window >= 0.0 && window.is_finite()) => {
            wrong("window", *window, ">= 0 and finite, in s")
        }
        _ => Ok(()),
    }
}

/// Refuses what is smoothed or sought over most of the record.
fn check_lengths(rig: &Rig, time: &[f64]) -> Result<(), MeasuredError> {
    let half = 0.5 * (time[time.len() - 1] - time[0]);
    let longest = if let Delay::Find(longest) = rig.delay { Some(longest) } else { None };
    for (name, value) in [("window", rig.window), ("longest delay", longest)] {
        if let Some(value) = value.filter(|value| *value > half) {
            let wanted = format!("at most half of the record, {} s", short(half));
            return Err(MeasuredError::Rig { name, value, wanted });
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

/// Standard deviations of noise in the range of a channel up to which all of it may be noise (chosen: a million samples of
/// white noise have a range of 9.8).
const STILL: f64 = 10.0;

fn more_than_noise(name: &'static str, unit: &'static str, values: &[f64]) -> Result<(), MeasuredError> {
    let [low, high] = values
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(*value), high.max(*value)]);
    let (range, noise) = (high - low, noise(values));
    if range < STILL * noise { Err(MeasuredError::Still { name, range, noise, unit }) } else { Ok(()) }
}

fn load(sheet: &Sheet, rig: &Rig) -> Result<Vec<f64>, MeasuredError> {
    let Some(loads) = sheet.column(&NORMAL_FORCE)? else {
        return rig.normal_force.map(|load| vec![load; sheet.len()]).ok_or(MeasuredError::NoLoad);
    };
    match loads.iter().position(|load| *load < 0.0) {
        Some(at) => Err(MeasuredError::Load { line: sheet.line(at), value: loads[at] }),
        None => Ok(loads),
    }
}

/// Samples of the load cell, on its clock.
struct Own<'a> {
    time: &'a [f64],
    force: &'a [f64],
    load: &'a [f64],
}

/// The motion on its own clock.
struct Motion {
    time: Vec<f64>,
    displacement: Vec<f64>,
    velocity: Option<Vec<f64>>,
}

impl Motion {
    fn of(sheet: &Sheet) -> Result<Motion, MeasuredError> {
        let time = times(sheet)?;
        let velocity = sheet.column(&VELOCITY)?;
        let displacement = match (sheet.column(&DISPLACEMENT)?, &velocity) {
            (Some(displacement), _) => displacement,
            (None, Some(velocity)) => integral(&time, velocity),
            (None, None) => sheet.required(DISPLACEMENT.name, &DISPLACEMENT)?,
        };
        moving("displacement", &displacement)?;
        match &velocity {
            Some(velocity) => more_than_noise("velocity", "m/s", velocity)?,
            None => more_than_noise("displacement", "m", &displacement)?,
        }
        Ok(Motion { time, displacement, velocity })
    }

    fn interval(&self) -> f64 {
        let mut steps: Vec<f64> = self.time.windows(2).map(|pair| pair[1] - pair[0]).collect();
        median(&mut steps)
    }

    /// The record with the motion smoothed.
    fn record(&self, own: &Own, rig: &Rig) -> Result<Record, MeasuredError> {
        let windows = self.windows(own, rig, rig.window);
        self.joined(own, rig, windows, self.clocks(own, rig, windows))
    }

    /// The record with force and motion smoothed alike.
    fn of_axis(&self, own: &Own, rig: &Rig) -> Result<Record, MeasuredError> {
        let windows = self.windows(own, rig, None);
        let clocks = self.clocks(own, rig, windows);
        let record = self.joined(own, rig, windows, clocks)?;
        let doubt = match rig.delay {
            Delay::Known(_) => 0.0,
            Delay::Find(longest) => longest,
            Delay::OfController => alike::doubt(self.interval()),
        };
        let is_held = rig.delay == Delay::OfController;
        let raw = |delay: f64| {
            let clocks = Clocks { delay, ..clocks };
            record.time.iter().map(|t| self.unfiltered(clocks.of_motion(*t))).collect()
        };
        let shortest = rig.window.unwrap_or(alike::shortest(record.quality.interval));
        let found = alike::alike(&record, rig.mass, &raw, rig.window, doubt, is_held);
        found.ok_or(MeasuredError::NoStroke { window: shortest, doubt })
    }

    /// Displacement, velocity and acceleration at a time, as the nearest samples have them.
    fn unfiltered(&self, time: f64) -> [f64; 3] {
        match &self.velocity {
            None => derivatives(&self.time, &self.displacement, time),
            Some(velocity) => {
                let [x, ..] = derivatives(&self.time, &self.displacement, time);
                let [v, a, _] = derivatives(&self.time, velocity, time);
                [x, v, a]
            }
        }
    }

    /// Windows for velocity and acceleration: the given one, or those with the least error.
    fn windows(&self, own: &Own, rig: &Rig, given: Option<f64>) -> [f64; 2] {
        let given = given.map(|window| window.max(shortest(self.interval())));
        match (given, &self.velocity) {
            (Some(window), None) => [window; 2],
            (Some(window), Some(_)) => [0.0, window],
            (None, None) => self.signal(&self.displacement, own, rig).windows(),
            (None, Some(velocity)) => [0.0, self.signal(velocity, own, rig).windows()[0]],
        }
    }

    /// Samples of the motion, and those that belong to the force as far as the delay is known.
    fn signal<'a>(&'a self, values: &'a [f64], own: &Own, rig: &Rig) -> Signal<'a> {
        let doubt = match rig.delay {
            Delay::Known(delay) => [delay; 2],
            Delay::Find(longest) => [-longest, longest],
            Delay::OfController => around(alike::middle(self.interval()), alike::doubt(self.interval())),
        };
        let [begin, end] = [own.time[0] + rig.skip + doubt[0], own.time[own.time.len() - 1] + doubt[1]];
        let part = self.time.partition_point(|t| *t < begin)..self.time.partition_point(|t| *t <= end);
        let part = if part.len() < LEAST { 0..self.time.len() } else { part };
        Signal { time: &self.time, values, interval: self.interval(), part }
    }

    /// Clocks, as they are known or as they let the motion explain most of the force.
    fn clocks(&self, own: &Own, rig: &Rig, windows: [f64; 2]) -> Clocks {
        match rig.delay {
            Delay::Known(delay) => Clocks::known(delay),
            Delay::Find(longest) => {
                let ends = [self.time[0], self.time[self.time.len() - 1]];
                Pair::new(own.time, own.force, ends, &|time| self.at(windows, time)).find(longest)
            }
            Delay::OfController => Clocks::known(alike::middle(self.interval())),
        }
    }

    /// Force and motion on the clock of the force, where both are known.
    fn joined(&self, own: &Own, rig: &Rig, windows: [f64; 2], clocks: Clocks) -> Result<Record, MeasuredError> {
        let inside = self.overlap(own, rig, clocks)?;
        let interval = self.interval();
        let take = |values: &[f64]| -> Vec<f64> { inside.iter().map(|at| values[*at]).collect() };
        let time = take(own.time);
        let moved: Vec<[f64; 3]> = time.iter().map(|t| self.at(windows, clocks.of_motion(*t))).collect();
        let [displacement, velocity, acceleration] =
            [0, 1, 2].map(|n| moved.iter().map(|all| all[n]).collect::<Vec<f64>>());
        let force = take(own.force);
        let friction_force = force.iter().zip(&acceleration).map(|(force, a)| force - rig.mass * a).collect();
        let mut record = Record {
            normal_force: take(own.load),
            is_differentiated: self.velocity.is_none(),
            window: windows[0],
            acceleration_window: windows[1],
            motion_interval: interval,
            delay_range: (clocks.deviation > 0.0).then(|| around(clocks.delay, DOUBT * interval.max(clocks.deviation))),
            alike: None,
            velocity_error: self.velocity_error(own, rig, windows[0]),
            acceleration_error: self.acceleration_error(own, rig, windows[1]),
            acceleration_lost: 0.0,
            motion_ends: clocks.ends([self.time[0], self.time[self.time.len() - 1]]),
            quality: Quality::default(),
            time,
            force,
            displacement,
            velocity,
            acceleration,
            friction_force,
            clocks,
        };
        record.quality = quality(&record, rig);
        record.acceleration_lost = self.acceleration_lost(&record);
        Ok(record)
    }

    /// Samples of the force at which the motion is known too.
    fn overlap(&self, own: &Own, rig: &Rig, clocks: Clocks) -> Result<Vec<usize>, MeasuredError> {
        let [first, last] = [self.time[0], self.time[self.time.len() - 1]];
        let begin = own.time[0] + rig.skip;
        let is_inside = |t: f64| t >= begin && (first..=last).contains(&clocks.of_motion(t));
        let inside: Vec<usize> = (0..own.time.len()).filter(|at| is_inside(own.time[*at])).collect();
        if inside.len() < LEAST {
            let force = [begin, own.time[own.time.len() - 1]];
            if own.time.iter().filter(|t| **t >= begin).count() < LEAST {
                let wanted = format!("short enough to leave at least {LEAST} samples before {} s", force[1]);
                return Err(MeasuredError::Rig { name: "skip", value: rig.skip, wanted });
            }
            return Err(MeasuredError::Apart { force, motion: [first, last] });
        }
        Ok(inside)
    }

    /// Error of the velocity around rest: its noise if it was measured, otherwise its error in a window.
    fn velocity_error(&self, own: &Own, rig: &Rig, window: f64) -> f64 {
        match &self.velocity {
            Some(velocity) => noise(velocity).max(rounding(velocity)),
            None => self.signal(&self.displacement, own, rig).error(window),
        }
    }

    fn acceleration_error(&self, own: &Own, rig: &Rig, window: f64) -> f64 {
        match &self.velocity {
            Some(velocity) => self.signal(velocity, own, rig).passed(window, 1),
            None => self.signal(&self.displacement, own, rig).passed(window, 2),
        }
    }

    /// Part of the acceleration that its filter takes away, by the square of the window, from what one of twice the length
    /// takes away more: noise in the difference of the two has nothing in common with noise in the longer one.
    fn acceleration_lost(&self, record: &Record) -> f64 {
        let window = record.acceleration_window;
        let (values, order) = self.velocity.as_ref().map_or((&self.displacement, 2), |velocity| (velocity, 1));
        let [one, twice] = [window, 2.0 * window].map(|window| Local::new(&self.time, values, window));
        let [first, last] = [record.motion_ends[0] + window, record.motion_ends[1] - window];
        let (mut difference, mut square) = (0.0, 0.0);
        let inside = record.time.iter().filter(|t| (first..=last).contains(*t));
        for t in inside.step_by(record.time.len().div_ceil(LOOKED_AT)) {
            let [a, damped] = [one, twice].map(|local| local.at(record.clocks.of_motion(*t))[order]);
            difference += (a - damped) * damped;
            square += damped * damped;
        }
        if square > 0.0 { (difference / (3.0 * square)).max(0.0) } else { 0.0 }
    }

    /// Displacement, velocity and acceleration at a time. A velocity that was measured is not smoothed.
    fn at(&self, [of_velocity, of_acceleration]: [f64; 2], time: f64) -> [f64; 3] {
        let in_window = |values, window| Local::new(&self.time, values, window).at(time);
        match &self.velocity {
            None => {
                let [x, v, a] = in_window(&self.displacement, of_velocity);
                let is_one = of_velocity == of_acceleration;
                [x, v, if is_one { a } else { in_window(&self.displacement, of_acceleration)[2] }]
            }
            Some(velocity) => {
                let [_, acceleration, _] = in_window(velocity, of_acceleration);
                let [x, v] =
                    [&self.displacement, velocity].map(|values| super::cycle::interpolate(&self.time, values, time));
                [x, v, acceleration]
            }
        }
    }
}

/// Samples at which a filter is compared with another one, at most (chosen).
const LOOKED_AT: usize = 2000;

pub(super) fn integral(time: &[f64], velocity: &[f64]) -> Vec<f64> {
    let mut displacement = vec![0.0];
    for at in 1..time.len() {
        let step = 0.5 * (velocity[at] + velocity[at - 1]) * (time[at] - time[at - 1]);
        displacement.push(displacement[at - 1] + step);
    }
    displacement
}
