//! Experiments as a fit needs them.

use std::borrow::Cow;
use std::path::{Component, Path};

use super::map::Rows;
use super::ports::Ports;
use stribeck::model::ModelType;
use stribeck_measured::{Channel, Direction, MatchedFilter, Movement, Record};
use stribeck_solve::system::Fault;

/// A run of a rig: the motion and the load that the law is led through, and the force it shall give; of a joint, angles and
/// torques in N m and rad.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Experiment {
    /// Whether the body slides or turns.
    pub movement: Movement,
    /// Its name.
    pub name: String,
    /// Time, s.
    pub time: Vec<f64>,
    /// Displacement at the first sample, m.
    pub displacement: f64,
    /// Velocity, m/s.
    pub velocity: Vec<f64>,
    /// Acceleration, m/s2.
    pub acceleration: Vec<f64>,
    /// Normal force, N.
    pub normal_force: Vec<f64>,
    /// Force of the load cell: m a + f_f + offset, N.
    pub force: Vec<f64>,
    /// Further quantities that a law may be led by.
    pub channels: Vec<Channel>,
    /// Direction of an arm that gravity turns.
    pub direction: Option<Direction>,
    /// Error of the velocity around rest, m/s; 0 if it is not known.
    pub velocity_error: f64,
    /// Error of the acceleration where it passes through 0, m/s2; 0 if it is not known.
    pub acceleration_error: f64,
    /// Part of the acceleration that a filter has taken away.
    pub acceleration_lost: f64,
    /// Delay of the motion behind the force that velocity and acceleration are for, s.
    pub delay: f64,
    /// Range in which it is, s; None if it was not looked for.
    pub delay_range: Option<[f64; 2]>,
    /// Samples that are left out; empty for none.
    pub left_out: Vec<bool>,
    /// Those that are left out because they are at rest, or in steady motion.
    pub rest: Rest,
    /// Time to each side in which the filter of the motion mixes samples, s.
    pub reach: f64,
    /// Times between which that filter has samples on both sides, s, if it is one; samples beyond them are left out.
    pub ends: Option<[f64; 2]>,
    /// Time in which an error of the velocity has one sign, s: the window of its filter.
    pub window: f64,
    /// Further data of a record whose force and motion are smoothed alike.
    pub matched_filter: Option<MatchedFilter>,
    /// Rows of a map of friction, each in steady sliding; None for a record. The time is then the number of the row.
    pub map: Option<Rows>,
}

/// Samples that are taken to be at rest, or in steady motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rest {
    /// Speed below which they are, m/s.
    pub speed: f64,
    /// Time to each side of such a sample in which others are too, s.
    pub reach: f64,
    /// Acceleration below which it is not known whether the contact speeds up or slows down, m/s2; 0 if that does not
    /// matter.
    pub steady: f64,
}

/// Errors of the velocity below which the direction of motion is not known (chosen). A law that jumps there is off by
/// twice its level in samples that get the wrong sign: fifteen of 4001 decided that regularised laws predicted the
/// records of `Coulomb`, `CoulombViscous` and `Stribeck` better than these themselves.
pub(super) const UNKNOWN_DIRECTION: f64 = 3.0;

/// Names of records: those of their files, with folders before them where files have the same name, and with endings
/// where they differ in nothing else.
pub fn names(files: &[&Path]) -> Vec<String> {
    let plain = |file: &Path| file.with_extension("");
    let is_alone = |file: &Path| files.iter().filter(|other| plain(other) == plain(file)).count() == 1;
    let parts = |file: &&Path| -> Vec<String> {
        let file = if is_alone(file) { plain(file) } else { file.to_path_buf() };
        let parts = file.components().filter(|part| matches!(part, Component::Normal(_)));
        parts.rev().map(|part| part.as_os_str().to_string_lossy().into()).collect()
    };
    let all: Vec<Vec<String>> = files.iter().map(parts).collect();
    let alike = |own: &Vec<String>, other: &Vec<String>| own.iter().zip(other).take_while(|(a, b)| a == b).count();
    let name = |own: &Vec<String>| {
        let most = all.iter().filter(|other| *other != own).map(|other| alike(own, other)).max().unwrap_or(0);
        own.iter().take(most + 1).rev().map(String::as_str).collect::<Vec<&str>>().join("-")
    };
    all.iter().map(name).collect()
}

impl Experiment {
    /// A record of a rig, without the samples at its ends, where the filter of the motion has samples on one side only,
    /// and without those whose direction of motion is not known; with these if they are the greater part, as where all
    /// motion is slow.
    pub fn new(name: &str, record: &Record) -> Experiment {
        let reach = 0.5 * record.window.max(record.acceleration_window);
        let [first, last] = record.motion_ends;
        let all = Experiment {
            movement: record.movement,
            name: name.to_owned(),
            time: record.time.clone(),
            displacement: record.displacement.first().copied().unwrap_or(0.0),
            velocity: record.velocity.clone(),
            acceleration: record.acceleration.clone(),
            normal_force: record.normal_force.clone(),
            force: record.force.clone(),
            channels: record.channels.clone(),
            direction: record.direction.clone(),
            velocity_error: record.velocity_error,
            acceleration_error: record.acceleration_error,
            acceleration_lost: if record.matched_filter.is_none() { record.acceleration_lost } else { 0.0 },
            delay: record.clocks.delay,
            delay_range: record.delay_range,
            reach,
            ends: if record.matched_filter.is_none() { Some([first + reach, last - reach]) } else { None },
            window: record.window,
            matched_filter: record.matched_filter.clone(),
            ..Experiment::default()
        };
        all.of_known_direction()
    }

    /// The same without its ends and samples whose direction of motion is not known.
    fn of_known_direction(self) -> Experiment {
        let rest = Rest { speed: UNKNOWN_DIRECTION * self.velocity_error, ..Rest::default() };
        let count = self.at_rest(rest).iter().filter(|is_at_rest| **is_at_rest).count();
        let rest = if 2 * count > self.time.len() { Rest::default() } else { rest };
        self.without(rest)
    }

    /// The same without samples of which it is not known whether the contact speeds up or slows down; with these if they
    /// are the greater part.
    pub(super) fn of_known_branch(&self) -> Experiment {
        let steady = UNKNOWN_DIRECTION * self.acceleration_error;
        let found = self.clone().without(Rest { steady, ..self.rest });
        if 2 * found.samples() > self.samples() { found } else { self.clone() }
    }

    /// The same with the acceleration that its filter has taken away: a mass would be found too large by that part.
    pub(super) fn with_all_acceleration(&self) -> Experiment {
        let whole = 1.0 / (1.0 - self.acceleration_lost);
        Experiment { acceleration: self.acceleration.iter().map(|a| whole * a).collect(), ..self.clone() }
    }

    /// The same without its ends and what is at rest.
    fn without(self, rest: Rest) -> Experiment {
        Experiment { left_out: self.left_out(rest), rest, ..self }
    }

    /// Whether each sample is at rest, in steady motion or at an end; empty if none is.
    fn left_out(&self, rest: Rest) -> Vec<bool> {
        let mut found = self.at_rest(rest);
        let is_steady = |a: &f64| a.abs() < rest.steady;
        if self.acceleration.iter().any(is_steady) {
            found.resize(self.time.len(), false);
            found.iter_mut().zip(&self.acceleration).for_each(|(found, a)| *found |= is_steady(a));
        }
        let is_beyond = |t: &f64| self.ends.is_some_and(|[first, last]| !(first..=last).contains(t));
        if self.time.iter().any(is_beyond) {
            found.resize(self.time.len(), false);
            found.iter_mut().zip(&self.time).for_each(|(found, t)| *found |= is_beyond(t));
        }
        found
    }

    /// The same without samples below a speed, and without those that the filter of the motion mixes with them; with all
    /// of them for a speed of 0.
    pub fn without_rest(self, rest: f64) -> Result<Experiment, Fault> {
        if !(rest >= 0.0 && rest.is_finite()) {
            let unit = self.movement.unit("m/s");
            return Err(Fault::value(format_args!("rest = {rest}: must be >= 0 and finite, in {unit}")));
        }
        let rest = if rest > 0.0 { Rest { speed: rest, reach: self.reach, ..self.rest } } else { Rest::default() };
        Ok(self.without(rest))
    }

    /// Whether each sample is at rest; empty if none is.
    fn at_rest(&self, rest: Rest) -> Vec<bool> {
        if let Some(filter) = &self.matched_filter {
            return filter.least_speed.iter().map(|least| *least <= rest.speed).collect();
        }
        let mut found = self.in_pauses(rest);
        let mut from = 0;
        // Where a filter reaches across rest, it does so too if no sample is slow enough.
        let turns = |at: usize| self.velocity.get(at + 1).is_some_and(|next| next * self.velocity[at] < 0.0);
        let is_at_rest = |at: &usize| self.velocity[*at].abs() < rest.speed || (rest.reach > 0.0 && turns(*at));
        for at in (0..self.time.len()).filter(is_at_rest) {
            // What is at rest together with the sample before is not looked at again.
            from = from.max(self.time.partition_point(|t| *t < self.time[at] - rest.reach));
            let to = self.time.partition_point(|t| *t <= self.time[at] + rest.reach);
            found[from..to].fill(true);
            from = to;
        }
        if found.contains(&true) { found } else { Vec::new() }
    }

    /// Whether each sample is in a pause, longer than the window of the filter, or within a window of it: there the filter
    /// sees the motion begin too early and end too late.
    fn in_pauses(&self, rest: Rest) -> Vec<bool> {
        let mut found = vec![false; self.time.len()];
        let is_slow = |at: &usize| self.velocity[*at].abs() < rest.speed;
        let mut at = 0;
        while let Some(begin) = (at..self.time.len()).find(is_slow) {
            let end = (begin..self.time.len()).find(|at| !is_slow(at)).unwrap_or(self.time.len());
            let [first, last] = [self.time[begin], self.time[end - 1]];
            if self.window > 0.0 && last - first > self.window {
                let from = self.time.partition_point(|t| *t < first - self.window);
                let to = self.time.partition_point(|t| *t <= last + self.window);
                found[from..to].fill(true);
            }
            at = end;
        }
        found
    }

    /// The same, with the samples left out that are at rest if the motion has another delay.
    pub(super) fn at_delay(&self, delay: f64) -> Experiment {
        let left_out = self.shifted(delay - self.delay).left_out(self.rest);
        Experiment { left_out, ..self.clone() }
    }

    /// The same with the motion at the delay that was found, unless its own is known.
    pub(super) fn with_delay(&self, found: Option<f64>) -> Cow<'_, Experiment> {
        match found {
            Some(delay) if self.delay_range.is_some() && delay != self.delay => {
                Cow::Owned(self.shifted(delay - self.delay))
            }
            _ => Cow::Borrowed(self),
        }
    }

    /// Whether a sample counts.
    pub(super) fn counts(&self, at: usize) -> bool {
        self.left_out.get(at).is_none_or(|is_left_out| !is_left_out)
    }

    /// Number of samples that count.
    pub(super) fn samples(&self) -> usize {
        (0..self.time.len()).filter(|at| self.counts(*at)).count()
    }

    /// Whether each sample counts.
    pub(super) fn fitted(&self) -> Vec<bool> {
        (0..self.time.len()).map(|at| self.counts(at)).collect()
    }

    /// The same with the motion taken from this much later.
    pub(super) fn shifted(&self, by: f64) -> Experiment {
        if let Some(filter) = &self.matched_filter {
            return self.along_jerk(&filter.jerk, by);
        }
        let last = self.time.len() - 1;
        let at = |values: &[f64], slopes: Option<&[f64]>, t: f64| {
            let end = if t < self.time[0] { 0 } else { last };
            if (self.time[0]..=self.time[last]).contains(&t) {
                stribeck_measured::interpolate(&self.time, values, t)
            } else {
                values[end] + slopes.map_or(0.0, |slopes| slopes[end] * (t - self.time[end]))
            }
        };
        let later = self.time.iter().map(|t| t + by);
        let (velocity, acceleration): (Vec<f64>, Vec<f64>) =
            later.map(|t| (at(&self.velocity, Some(&self.acceleration), t), at(&self.acceleration, None, t))).unzip();
        let (direction, displacement) = (self.turned(&velocity, by), self.displacement + by * self.velocity[0]);
        Experiment { displacement, velocity, acceleration, direction, ..self.clone() }
    }

    /// The same for a motion of which the jerk is known; samples may be far apart.
    fn along_jerk(&self, jerk: &[f64], by: f64) -> Experiment {
        let moved = self.velocity.iter().zip(&self.acceleration).zip(jerk);
        let moved = moved.map(|((v, a), jerk)| (v + by * (a + 0.5 * by * jerk), a + by * jerk));
        let (velocity, acceleration): (Vec<f64>, Vec<f64>) = moved.unzip();
        let (direction, displacement) = (self.turned(&velocity, by), self.displacement + by * self.velocity[0]);
        Experiment { displacement, velocity, acceleration, direction, ..self.clone() }
    }

    /// The samples of a further quantity.
    pub(super) fn channel(&self, name: &str) -> Option<&[f64]> {
        self.channels.iter().find(|one| one.quantity.name == name).map(|one| &one.values[..])
    }

    /// The direction of an arm that has moved on, with its velocities then.
    fn turned(&self, then: &[f64], by: f64) -> Option<Direction> {
        let angles = self.velocity.iter().zip(then).map(|(now, then)| 0.5 * by * (now + then));
        self.direction.as_ref().map(|direction| direction.turned(angles))
    }

    /// The same with `parts` intervals joined to one; the force is the one at the samples that are left.
    pub(super) fn coarser(&self, parts: usize) -> Experiment {
        let take = |values: &[f64]| values.iter().copied().step_by(parts).collect();
        let matched_filter = self.matched_filter.as_ref().map(|filter| MatchedFilter {
            jerk: take(&filter.jerk),
            least_speed: take(&filter.least_speed),
            noise: filter.noise,
        });
        let direction = self.direction.as_ref();
        let direction = direction.map(|one| Direction { cosine: take(&one.cosine), sine: take(&one.sine) });
        Experiment {
            direction,
            time: take(&self.time),
            velocity: take(&self.velocity),
            acceleration: take(&self.acceleration),
            normal_force: take(&self.normal_force),
            force: take(&self.force),
            channels: self.channels.iter().map(|one| one.with(take(&one.values))).collect(),
            left_out: self.left_out.iter().copied().step_by(parts).collect(),
            matched_filter,
            map: self.map.as_ref().map(|rows| rows.coarser(parts)),
            ..self.clone()
        }
    }

    /// Length, s.
    pub fn duration(&self) -> f64 {
        self.time[self.time.len() - 1] - self.time[0]
    }

    /// Whether it begins in motion: faster than a hundredth of the highest speed, below which it is noise (chosen).
    pub(super) fn begins_in_motion(&self) -> bool {
        let fastest = self.velocity.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        self.velocity[0].abs() > 0.01 * fastest
    }

    /// How it is taken to begin for some laws.
    pub fn beginning(&self, laws: &[&ModelType]) -> String {
        let mut all: Vec<&str> = laws.iter().map(|law| self.beginning_of(law)).collect();
        all.dedup();
        all.join("; ")
    }

    fn beginning_of(&self, law: &ModelType) -> &'static str {
        if self.map.is_some() {
            "each row is taken as steady sliding"
        } else if Ports::of(law).is_some_and(|ports| ports.has_displacement()) {
            "taken to begin at its first displacement, at rest and unloaded"
        } else if self.begins_in_motion() {
            "taken to begin in steady sliding"
        } else {
            "taken to begin at rest, with the contact unloaded"
        }
    }

    /// Range of the displacement, m.
    pub(super) fn travel(&self) -> f64 {
        let (mut x, mut low, mut high) = (0.0, 0.0f64, 0.0f64);
        for at in 1..self.time.len() {
            x += self.mean_velocity(at - 1) * (self.time[at] - self.time[at - 1]);
            (low, high) = (low.min(x), high.max(x));
        }
        high - low
    }

    /// Work of the force as a part of that of the largest one along the whole way; 1 if there is hardly one.
    pub(super) fn dissipated(&self) -> f64 {
        let (mut work, mut way, mut largest) = (0.0, 0.0_f64, f64::MIN_POSITIVE);
        for at in 1..self.time.len() {
            let step = self.mean_velocity(at - 1) * (self.time[at] - self.time[at - 1]);
            work += 0.5 * (self.force[at] + self.force[at - 1]) * step;
            way += step.abs();
            largest = f64::max(largest, self.force[at].abs());
        }
        if way.is_normal() { work / (way * largest) } else { 1.0 }
    }

    /// Mean velocity between a sample and the next one.
    pub(super) fn mean_velocity(&self, at: usize) -> f64 {
        0.5 * (self.velocity[at] + self.velocity[at + 1])
    }

    /// Refuses columns that do not fit each other, and values that no rig has.
    pub(super) fn check(&self, law: &ModelType) -> Result<(), Fault> {
        let Experiment { name, time, velocity, acceleration, normal_force, force, .. } = self;
        let refuse = |text: std::fmt::Arguments| Err(Fault::value(format_args!("{name}: {text}")));
        let columns: [(&str, &[f64]); 5] = [
            ("time", time),
            ("velocity", velocity),
            ("acceleration", acceleration),
            ("normal_force", normal_force),
            ("force", force),
        ];
        columns.iter().try_for_each(|(column, values)| self.check_column(column, values))?;
        if let Some(at) = (1..time.len()).find(|at| time[*at] <= time[at - 1]) {
            return refuse(format_args!("time[{at}] = {}: times must ascend", time[at]));
        }
        self.channels.iter().try_for_each(|one| self.check_column(one.quantity.name, &one.values))?;
        let has_load = Ports::of(law).is_some_and(|ports| ports.load.is_some());
        let moving = [("velocity", velocity)].into_iter().chain(has_load.then_some(("normal_force", normal_force)));
        for (column, values) in moving {
            if values.iter().all(|value| *value == 0.0) {
                return refuse(format_args!("{column} is 0 throughout, so that no friction can be seen"));
            }
        }
        match normal_force.iter().position(|load| *load < 0.0) {
            Some(at) => refuse(format_args!("normal_force[{at}] = {}: must be >= 0", normal_force[at])),
            None => Ok(()),
        }
    }

    /// Refuses a column of another length than the time, or with values that are not finite.
    fn check_column(&self, column: &str, values: &[f64]) -> Result<(), Fault> {
        let (name, count) = (&self.name, self.time.len());
        if values.len() != count || count < 2 {
            let text = format_args!("{name}: {column} has {} values, time has {count}; at least 2", values.len());
            return Err(Fault::value(text));
        }
        match values.iter().position(|value| !value.is_finite()) {
            Some(at) => Err(Fault::value(format_args!("{name}: {column}[{at}] = {}: must be finite", values[at]))),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{estimate, fitted, measured, noise, quick, standard};
    use super::super::{Settings, held_out};
    use super::*;

    /// Strokes shorter than the contact yields, from an unloaded contact: the force goes one way only.
    #[test]
    fn a_stiffness_is_found_in_pre_sliding_alone() {
        let even = standard(1000);
        let velocity = even.velocity.iter().map(|v| 0.003 * v).collect();
        let data = measured("Dahl", &[("sigma_0", 3e4), ("mu_k", 0.2)], &Experiment { velocity, ..even }, 0.01, 1);
        let fit = fitted("Dahl", &[data], &quick());
        let one = estimate(&fit, "sigma_0");
        assert!(one.verdict == super::super::Verdict::Determined && (one.value / 3e4 - 1.0).abs() < 0.1, "{one:?}");
    }

    /// Strokes of 0.9 s and pauses of 0.6 s, in which the contact holds half of its level. The filter of the displacement
    /// sees motion before it begins.
    #[test]
    fn the_ends_of_pauses_do_not_count() {
        let place = |t: f64| {
            let stroke = (t / 1.5 + 1e-12).floor();
            let part = ((t - 1.5 * stroke) / 0.9).clamp(0.0, 1.0);
            let way = 0.5 - 0.5 * (std::f64::consts::PI * part).cos();
            0.02 * if stroke % 2.0 == 0.0 { way } else { 1.0 - way }
        };
        let time: Vec<f64> = (0..6000).map(|k| f64::from(k) * 1e-3).collect();
        let speed = |t: f64| (place(t + 1e-6) - place(t - 1e-6)) / 2e-6;
        let acceleration = |t: f64| (speed(t + 1e-5) - speed(t - 1e-5)) / 2e-5;
        let force = |t: f64| match t % 1.5 < 0.9 {
            true => 2.0 * acceleration(t) + 4.0 * speed(t).signum() + 5.0 * speed(t),
            false => 2.0,
        };
        let [random, shaken] = [noise(1, time.len()), noise(2, time.len())];
        let columns = [
            ("time", time.clone()),
            ("force", time.iter().zip(&random).map(|(t, noise)| force(*t) + 0.03 * noise).collect()),
            ("displacement", time.iter().zip(&shaken).map(|(t, noise)| place(*t) + 1e-7 * noise).collect()),
        ];
        let sheet =
            stribeck_sheet::Sheet::of_columns(&columns.map(|(name, values)| (name.to_owned(), values))).unwrap();
        let rig =
            stribeck_measured::Setup { mass: 2.0, normal_force: Some(20.0), ..stribeck_measured::Setup::default() };
        let experiment = Experiment::new("paused", &Record::of(&sheet, None, &rig).unwrap());
        let share = experiment.samples() as f64 / time.len() as f64;
        assert!((0.5..0.6).contains(&share), "{share}");
        let fit = fitted("CoulombViscous", &[experiment], &Settings { mass: 2.0, ..quick() });
        for (name, truth) in [("mu_k", 0.2), ("viscous_coefficient", 5.0)] {
            let one = estimate(&fit, name);
            let [low, high] = one.interval();
            assert!(one.verdict == super::super::Verdict::Determined && (low..=high).contains(&truth), "{one:?}");
        }
        assert!(fit.warnings.is_empty(), "{:?}", fit.warnings);
    }

    /// At the highest speeds the acceleration passes through 0: noise of 0.005 m/s2 there takes the wrong curve, in some
    /// samples out of a hundred.
    #[test]
    fn samples_on_an_unknown_curve_do_not_count() {
        let clean = measured("NonReversible", &[], &standard(2000), 0.01, 3);
        let error = 5e-3;
        let acceleration = clean.acceleration.iter().zip(noise(8, 2000)).map(|(a, noise)| a + error * noise).collect();
        let noisy = Experiment { acceleration, ..clean.clone() };
        let known = Experiment { acceleration_error: error, ..noisy.clone() };
        let task = Settings { profiles: true, ..quick() };
        let validation = known.clone();
        let [clean, noisy, known] =
            [clean, noisy, known].map(|experiment| fitted("NonReversible", &[experiment], &task));
        assert!(noisy.residuals.rms > 1.3 * clean.residuals.rms, "{} {}", noisy.residuals.rms, clean.residuals.rms);
        assert!(known.residuals.rms < 1.05 * clean.residuals.rms, "{} {}", known.residuals.rms, clean.residuals.rms);
        assert!((1600..1950).contains(&known.samples), "{}", known.samples);
        let validation = held_out(&known, &[validation]).unwrap().swap_remove(0);
        assert!((validation.rms / known.residuals.rms - 1.0).abs() < 0.05, "{validation:?}");
        for name in ["mu_k", "mu_s", "acceleration_decay", "deceleration_decay"] {
            let [clean, known] = [&clean, &known].map(|fit| estimate(fit, name));
            assert!(known.verdict.is_informative(), "{name} {:?}", known.verdict);
            assert!(known.deviation < 1.5 * clean.deviation, "{name} {} {}", known.deviation, clean.deviation);
        }
    }

    #[test]
    fn records_of_the_same_name_are_told_apart_by_their_folders() {
        let files = ["a/force.csv", "/rig/b/force.csv", "other.csv", "force.csv", "x/b/force.csv"];
        let expected = ["a-force", "rig-b-force", "other", "force", "x-b-force"];
        assert_eq!(names(&files.map(Path::new)), expected);
    }

    #[test]
    fn the_acceleration_does_not_matter_to_other_laws_nor_in_motion_that_is_steady_throughout() {
        let data = measured("Coulomb", &[], &standard(400), 0.01, 1);
        let doubtful = Experiment { acceleration_error: 0.01, ..data.clone() };
        let task = Settings { profiles: true, ..quick() };
        assert_eq!(fitted("Coulomb", std::slice::from_ref(&doubtful), &task).samples, data.samples());
        assert!(doubtful.of_known_branch().samples() < data.samples());
        let steady = Experiment { acceleration_error: 10.0, ..data.clone() };
        assert_eq!(steady.of_known_branch().samples(), data.samples());
    }
}
