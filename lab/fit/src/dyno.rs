//! Damper files: turns the measurements of a damper dynamometer into a parameter set of the shock absorber.
//!
//! The damper is driven back and forth without its spring and without side load; the file has velocity and force,
//! either of whole strokes (a loop test) or at the peaks of several speeds (a peak-velocity plot).
//!
//! # Equations
//! With the resistance r (the force that has the sign of the velocity) and the velocity v, positive in extension:
//!
//! ```text
//! r(v, x) = F_d(v) + sgn(v) F_C (1 - alpha sgn(v)) - F_g + g (x - x_c)
//! ```
//!
//! | symbol | unit | meaning                                                                             |
//! |--------|------|-------------------------------------------------------------------------------------|
//! | F_d    | N    | damper table, monotone, 0 at rest                                                   |
//! | F_C    | N    | friction, mean of both directions: half the jump of r at v = 0                      |
//! | alpha  | 1    | asymmetry of friction: F_C (1 + alpha) in compression, F_C (1 - alpha) in extension |
//! | F_g    | N    | gas force, mean of both ends of the stroke: minus the mean of r at v = 0            |
//! | x, x_c | m    | displacement and its centre, positive in extension                                  |
//! | g      | N/m  | force in proportion to displacement: gradient of the gas force, lag of the oil      |
//!
//! At v = 0 a polynomial through the samples below the low speed is extrapolated to rest, on each side. g comes from
//! the gap between the two branches of a stroke at equal speed, and is removed first. All fits are by least squares
//! with Tukey's weights, so that single outliers do not count; the standard deviations are those of the fits.
//!
//! # Sign
//! Dynamometers differ: [`Options::compression_positive`] reverses velocity and displacement. A damper dissipates
//! energy, so the sign of the force can be found in the file; [`Options::force_sign`] requires one.
//!
//! # Limits
//! * F_g and alpha enter the same mean: alpha is found only if the gas force is known ([`Options::gas_force`]).
//! * Below breakaway, friction is not yet fully developed. With displacement, samples within a millimetre after the end
//!   of a stroke are excluded from the fits at low speed; without it they make the friction look smaller.
//! * g is that of middle speeds. Oil lags in proportion to the slope of F_d, so where the characteristic bends
//!   strongly, part of the lag at low speed counts as friction: test slowly, with long strokes.
//! * The static level (stiction) is not visible in such tests: see [`Damper::parameter_set`]. A file with times and slow
//!   strokes ([`slow_strokes`]) shows more: identification fits a friction law to it.
//!
//! # Source
//! The equation is a balance of forces. Weights: A. E. Beaton, J. W. Tukey, "The fitting of power series, meaning
//! polynomials, illustrated on band-spectroscopic data", Technometrics 16 (1974). The windows are chosen.

mod file;
mod regression;
mod strokes;

use std::fmt;

use clap::ValueEnum;
use serde::{Deserialize, Serialize};
use ssp::parameter_set::{ParameterSet, SetError, choice};
use stribeck::catalogue;
use stribeck::model::ModelType;
use stribeck::numerics::interpolation::Curve;
use thiserror::Error;

use stribeck_measured::{extremes, median};
use stribeck_sheet::SheetError;

pub use file::Test;
use regression::{isotonic, local, regress};
pub use strokes::{Stroke, slow_strokes};

/// The largest table of the shock absorber.
pub const MOST_POINTS: usize = 16;

/// A range of temperature that changes the oil notably, K (chosen).
const WARM_UP: f64 = 10.0;

/// Travel after the end of a stroke in which friction develops, m (chosen: several times the breakaway travel).
const BREAKAWAY: f64 = 1e-3;

/// Sign convention of the force in the file.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum ForceSign {
    /// The force has the sign of the velocity in the file
    Resistance,
    /// The force has the opposite sign: it is the action of the damper on the machine
    Reaction,
}

impl fmt::Display for ForceSign {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            ForceSign::Resistance => "resistance",
            ForceSign::Reaction => "reaction",
        })
    }
}

/// Information in addition to the file.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Velocity and displacement in the file are positive in compression.
    pub compression_positive: bool,
    /// Sign of the force that the file must have; found in the file if not given.
    pub force_sign: Option<ForceSign>,
    /// Number of points of the table, including 0: 3 to [`MOST_POINTS`]. Without it a curve of so many points is kept as
    /// it is, and a table has 11 (chosen).
    pub points: Option<usize>,
    /// Speed below which samples distinguish friction from damping, m/s.
    pub low_speed: f64,
    /// Speed below which friction still falls with speed, m/s, if known: slower samples do not count at rest.
    pub falling: f64,
    /// Gas force, N, mean of both ends of the stroke, if known: only then can the asymmetry of friction be found.
    pub gas_force: Option<f64>,
}

impl Default for Options {
    /// 0.05 m/s (chosen).
    fn default() -> Options {
        Options {
            compression_positive: false,
            force_sign: None,
            points: None,
            low_speed: 0.05,
            falling: 0.0,
            gas_force: None,
        }
    }
}

/// A value with its standard deviation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Value.
    pub value: f64,
    /// Standard deviation.
    pub deviation: f64,
}

/// Friction of the damper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// Mean of both directions, N.
    pub level: Estimate,
    /// alpha, if the gas force was known.
    pub asymmetry: Option<f64>,
}

/// Properties of a damper found in a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Damper {
    /// Velocity in m/s, positive in extension, and resistance of the damper in N, without friction and gas force.
    pub table: Vec<(f64, f64)>,
    /// Friction, if the samples determine it.
    pub friction: Option<Friction>,
    /// Gas force, N, mean of both ends of the stroke, positive pushes the eyes apart, if the samples determine it.
    pub gas_force: Option<Estimate>,
    /// Resistance in proportion to displacement, N/m, if the file has strokes with displacement.
    pub gradient: Option<Estimate>,
    /// Sign convention of the force in the file.
    pub force_sign: ForceSign,
    /// Root mean square of the difference between the samples and table, friction and gas force, N.
    pub rms_error: f64,
    /// Largest difference, N.
    pub max_error: f64,
    /// Warnings for the user.
    pub warnings: Vec<String>,
}

/// Reason why no damper was found in a test.
#[derive(Debug, Error)]
pub enum DynoError {
    /// The file cannot be read.
    #[error(transparent)]
    File(#[from] SheetError),
    /// An option is outside its range.
    #[error("{name} = {value}: must be {wanted}")]
    Option {
        /// The option.
        name: &'static str,
        /// Its value.
        value: f64,
        /// The condition.
        wanted: &'static str,
    },
    /// There are too few samples in one direction.
    #[error("{count} samples in {direction}: a damper table needs at least 2 in each direction")]
    OneDirection {
        /// `extension` or `compression`.
        direction: &'static str,
        /// Samples in this direction.
        count: usize,
    },
    /// Velocity and force are not those of one damper.
    #[error(
        "force and velocity agree in sign in {percent:.0} % of the samples above half of the highest speed: \
         neither a resistance (100 %) nor a reaction (0 %)"
    )]
    Incoherent {
        /// Share of the samples in which the signs agree.
        percent: f64,
    },
    /// The force has the opposite sign.
    #[error(
        "the force in the file is the {found}, not the {wanted}: set the force sign to {found}, or reverse the velocity"
    )]
    ForceSign {
        /// The sign in the file.
        found: ForceSign,
        /// The required sign.
        wanted: ForceSign,
    },
    /// Displacement and velocity do not match.
    #[error(
        "the displacement decreases while the velocity is positive: the two columns have opposite sign conventions"
    )]
    Displacement,
    /// The file has no times.
    #[error("no column 'time': a friction law needs it")]
    NoTime,
    /// Times do not ascend.
    #[error("row {row}, time: {now} s after {before} s; times must ascend")]
    Time {
        /// Row of the table.
        row: usize,
        /// The time.
        now: f64,
        /// The time before it.
        before: f64,
    },
    /// The file has no slow strokes.
    #[error(
        "no strokes at up to {low_speed} m/s that turn at least twice: a friction law needs slow ones; at higher speeds \
         damping hides friction"
    )]
    NoSlowStrokes {
        /// The speed, m/s.
        low_speed: f64,
    },
    /// The test has slow strokes only.
    #[error(
        "no sample is faster than {fastest:.3e} m/s: up to {low_speed} m/s (low speed) friction cannot be \
         separated from damping without faster strokes; add some, or give a lower low speed"
    )]
    OnlySlow {
        /// The highest speed, m/s.
        fastest: f64,
        /// The speed up to which friction is separated from damping, m/s.
        low_speed: f64,
    },
    /// Squares of velocities or forces overflow, or table points coincide.
    #[error("speeds up to {speed:e} m/s and forces up to {force:e} N are too large or too small to compute with")]
    OutOfRange {
        /// The highest speed, m/s.
        speed: f64,
        /// The largest force, N.
        force: f64,
    },
    /// The result is not a parameter set of the shock absorber.
    #[error(transparent)]
    Set(#[from] SetError),
    /// The library has no such model.
    #[error("the library has no model {0}")]
    NoModel(&'static str),
}

/// One sample, with this project's signs.
#[derive(Clone, Copy)]
struct Sample {
    velocity: f64,
    resistance: f64,
    displacement: f64,
}

impl Sample {
    fn is_extension(&self) -> bool {
        self.velocity > 0.0
    }
}

/// Finds the damper in a test.
///
/// # Errors
/// Options outside their range, a direction without samples, contradictory signs, or numbers too large or too small to
/// compute with.
pub fn find_damper(test: &Test, options: &Options) -> Result<Damper, DynoError> {
    check(options)?;
    let force_sign = force_sign(test, options)?;
    let mut samples = samples(test, options, force_sign);
    let (fastest, low_speed) = (top_speed(&samples), options.low_speed);
    if fastest <= low_speed {
        return Err(DynoError::OnlySlow { fastest, low_speed });
    }
    let mut warnings: Vec<String> = warm_up(test).into_iter().collect();
    let gradient = if test.displacement.is_some() { remove_gradient(&mut samples) } else { None };
    if test.displacement.is_some() && gradient.is_none() {
        warnings.push("the displacement does not separate the two branches of a stroke: not used".into());
    }
    let sides = sides_at_rest(&samples, options, gradient.is_some());
    let (friction, gas_force) = match sides {
        Ok(sides) => friction_and_gas(sides, options.gas_force, &mut warnings),
        Err(_) => (None, None),
    };
    warnings.extend(sides.err().map(|direction| {
        format!(
            "too few samples below {low_speed} m/s in {direction}: friction and gas force cannot be separated from \
             damping; the table includes them, and the set keeps the default friction"
        )
    }));
    let offset = Offset { gas: gas_force.map_or(0.0, |gas| gas.value), friction };
    let table = table(&samples, &offset, options.points, &mut warnings);
    let [rms_error, max_error] = errors(&samples, &offset, &table);
    let damper = Damper { table, friction, gas_force, gradient, force_sign, rms_error, max_error, warnings };
    if damper.is_sound() { Ok(damper) } else { Err(out_of_range(&samples)) }
}

fn out_of_range(samples: &[Sample]) -> DynoError {
    let force = samples.iter().fold(0.0, |most, sample| sample.resistance.abs().max(most));
    DynoError::OutOfRange { speed: top_speed(samples), force }
}

fn check(options: &Options) -> Result<(), DynoError> {
    let refuse = |name, value, wanted| Err(DynoError::Option { name, value, wanted });
    if let Some(points) = options.points.filter(|points| !(3..=MOST_POINTS).contains(points)) {
        return refuse("points", points as f64, "3 to 16");
    }
    if !(options.low_speed > 0.0 && options.low_speed.is_finite()) {
        return refuse("low speed", options.low_speed, "> 0 m/s and finite");
    }
    match options.gas_force {
        Some(gas) if !gas.is_finite() => refuse("gas force", gas, "finite"),
        _ => Ok(()),
    }
}

/// Sign convention of the force in the file, checked against the option. Velocity and force are used as in the file:
/// reversing both changes nothing.
fn force_sign(test: &Test, options: &Options) -> Result<ForceSign, DynoError> {
    check_directions(test, options)?;
    let percent = 100.0 * agreement(test);
    let found = match percent {
        90.0.. => ForceSign::Resistance,
        ..=10.0 => ForceSign::Reaction,
        _ => return Err(DynoError::Incoherent { percent }),
    };
    if test.displacement.as_ref().is_some_and(|displacement| climb(&test.velocity, displacement) < 0.0) {
        return Err(DynoError::Displacement);
    }
    match options.force_sign {
        Some(wanted) if wanted != found => Err(DynoError::ForceSign { found, wanted }),
        _ => Ok(found),
    }
}

fn check_directions(test: &Test, options: &Options) -> Result<(), DynoError> {
    let names = if options.compression_positive { ["compression", "extension"] } else { ["extension", "compression"] };
    for (sign, direction) in [1.0, -1.0].into_iter().zip(names) {
        let count = test.velocity.iter().filter(|velocity| sign * **velocity > 0.0).count();
        if count < 2 {
            return Err(DynoError::OneDirection { direction, count });
        }
    }
    Ok(())
}

/// Fraction of the samples above half of the highest speed of their direction in which the force, relative to the middle
/// of the medians of both directions, has the sign of the velocity.
fn agreement(test: &Test) -> f64 {
    let at_speed = |direction: f64| -> Vec<f64> {
        let half = test.velocity.iter().fold(0.0, |most: f64, v| most.max(direction * v)) / 2.0;
        let pairs = test.velocity.iter().zip(&test.force);
        pairs.filter(|(velocity, _)| direction * **velocity > half).map(|(_, force)| *force).collect()
    };
    let [mut up, mut down] = [at_speed(1.0), at_speed(-1.0)];
    let centre = (median(&mut up) + median(&mut down)) / 2.0;
    let above = up.iter().filter(|force| **force > centre).count();
    let below = down.iter().filter(|force| **force < centre).count();
    (above + below) as f64 / (up.len() + down.len()) as f64
}

/// Positive if the displacement mostly increases while the velocity is positive.
fn climb(velocity: &[f64], displacement: &[f64]) -> f64 {
    let moves = displacement.windows(2).zip(velocity.windows(2));
    moves.map(|(x, v)| (x[1] - x[0]) * (v[0] + v[1])).sum()
}

/// The samples with this project's signs. Those at rest are not used.
fn samples(test: &Test, options: &Options, force_sign: ForceSign) -> Vec<Sample> {
    let [motion, force] = strokes::signs(options, force_sign);
    let displacement = |at: usize| test.displacement.as_ref().map_or(0.0, |displacement| motion * displacement[at]);
    let pairs = test.velocity.iter().zip(&test.force).enumerate();
    let all = pairs.map(|(at, (velocity, measured))| Sample {
        velocity: motion * velocity,
        resistance: force * measured,
        displacement: displacement(at),
    });
    all.filter(|sample| sample.velocity != 0.0).collect()
}

fn warm_up(test: &Test) -> Option<String> {
    let [low, high] = extremes(test.temperature.as_ref()?.iter().copied());
    let [low_c, high_c] = [low, high].map(|kelvin| kelvin - 273.15);
    (high - low > WARM_UP).then(|| {
        format!(
            "the temperature runs from {low_c:.1} to {high_c:.1} degC: damping and friction of a warm damper are \
             smaller; the table is a mean over the test"
        )
    })
}

fn centre_and_stroke(samples: &[Sample]) -> (f64, f64) {
    let [low, high] = extremes(samples.iter().map(|sample| sample.displacement));
    ((low + high) / 2.0, high - low)
}

fn top_speed(samples: &[Sample]) -> f64 {
    samples.iter().fold(0.0, |most, sample| sample.velocity.abs().max(most))
}

/// Removes the force in proportion to displacement from the samples and returns its slope. None if displacement and
/// velocity do not vary independently.
fn remove_gradient(samples: &mut [Sample]) -> Option<Estimate> {
    let (centre, stroke) = centre_and_stroke(samples);
    if stroke == 0.0 {
        return None;
    }
    let side = |is_extension: bool| -> Vec<Sample> {
        samples.iter().copied().filter(|sample| sample.is_extension() == is_extension).collect()
    };
    let slope = |side: &[Sample]| slope(side, |sample| (sample.displacement - centre) / stroke);
    let gradient = mean(slope(&side(true))?, slope(&side(false))?).map(|value| value / stroke);
    for sample in samples {
        sample.resistance -= gradient.value * (sample.displacement - centre);
    }
    Some(gradient)
}

/// Slope of the resistance of one direction over a quantity, beside a cubic of the speed, at the speeds at which both
/// branches of a stroke are far apart in displacement.
fn slope(side: &[Sample], over: impl Fn(&Sample) -> f64) -> Option<Estimate> {
    const FEWEST: usize = 20; // chosen: a loop has more samples, a peak-velocity plot less
    let top = top_speed(side);
    let middle = side.iter().filter(|sample| (0.3..0.9).contains(&(sample.velocity.abs() / top)));
    let row = |sample: &Sample| {
        let u = sample.velocity.abs() / top - 0.6;
        ([1.0, u, u * u, u * u * u, over(sample)], sample.resistance)
    };
    let (rows, values): (Vec<[f64; 5]>, Vec<f64>) = middle.map(row).unzip();
    if rows.len() < FEWEST { None } else { regress(&rows, &values).map(|estimates| estimates[4]) }
}

impl Estimate {
    fn map(self, scale: impl Fn(f64) -> f64) -> Estimate {
        Estimate { value: scale(self.value), deviation: scale(self.deviation).abs() }
    }
}

/// Mean of two independent estimates.
fn mean(first: Estimate, second: Estimate) -> Estimate {
    Estimate { value: (first.value + second.value) / 2.0, deviation: first.deviation.hypot(second.deviation) / 2.0 }
}

/// Resistance at rest, approached from extension and from compression; else the direction that has too few samples.
fn sides_at_rest(
    samples: &[Sample],
    options: &Options,
    with_displacement: bool,
) -> Result<[Estimate; 2], &'static str> {
    // At most a fifth of the range: further up the characteristic bends. Close to rest the sign of the velocity is
    // noise.
    let window = options.low_speed.min(0.2 * top_speed(samples));
    let slowest = (0.05 * window).max(options.falling);
    let (centre, stroke) = centre_and_stroke(samples);
    let developed = |sample: &Sample| {
        let travel = stroke / 2.0 + sample.velocity.signum() * (sample.displacement - centre);
        !with_displacement || travel > BREAKAWAY.min(0.1 * stroke)
    };
    let side = |is_extension: bool| {
        let is_near = |sample: &&Sample| {
            let is_slow = (slowest..=window).contains(&sample.velocity.abs());
            sample.is_extension() == is_extension && is_slow && developed(sample)
        };
        let near = samples.iter().filter(is_near).map(|sample| (sample.velocity, sample.resistance));
        local(&near.collect::<Vec<_>>(), 0.0).ok_or(if is_extension { "extension" } else { "compression" })
    };
    Ok([side(true)?, side(false)?])
}

fn friction_and_gas(
    [extension, compression]: [Estimate; 2],
    known_gas: Option<f64>,
    warnings: &mut Vec<String>,
) -> (Option<Friction>, Option<Estimate>) {
    let level = mean(extension, compression.map(|value| -value));
    let gas = mean(extension, compression).map(|value| -value);
    if level.value <= 0.0 {
        warnings.push(format!("the gap at rest is {:.1} N: no friction was found", 2.0 * level.value));
        return (None, Some(gas));
    }
    if level.value < 2.0 * level.deviation {
        warnings.push(format!("friction {:.1} N is within its uncertainty ({:.1} N)", level.value, level.deviation));
    }
    // The mean at rest is F_g + alpha F_C.
    let parts = known_gas.map(|known| (known, (gas.value - known) / level.value));
    let used = parts.filter(|(_, asymmetry)| asymmetry.is_nan() || asymmetry.abs() < 1.0);
    match known_gas {
        Some(known) if used.is_none() => {
            warnings.push(format!("a gas force of {known} N would make friction negative in one direction: not used"));
        }
        None if gas.value < -3.0 * gas.deviation - 1.0 => warnings.push(format!(
            "at rest the damper pulls with {:.1} N, but gas pushes: are velocities positive in compression?",
            -gas.value
        )),
        _ => {}
    }
    let gas = used.map_or(gas, |(value, _)| Estimate { value, deviation: 0.0 });
    (Some(Friction { level, asymmetry: used.map(|(_, asymmetry)| asymmetry) }), Some(gas))
}

/// The part of the force that is not hydraulic damping.
struct Offset {
    gas: f64,
    friction: Option<Friction>,
}

impl Offset {
    fn at(&self, velocity: f64) -> f64 {
        let sign = velocity.signum();
        let of = |friction: Friction| friction.level.value * (sign - friction.asymmetry.unwrap_or(0.0));
        self.friction.map_or(0.0, of) - self.gas
    }
}

/// Number of points of a table (chosen).
const USUAL_POINTS: usize = 11;

/// The damper table: monotone, 0 at rest.
fn table(samples: &[Sample], offset: &Offset, points: Option<usize>, warnings: &mut Vec<String>) -> Vec<(f64, f64)> {
    let curves = [false, true].map(|is_extension| curve(hydraulic(samples, offset, is_extension)));
    let is_kept = points.is_none() && curves.iter().map(Vec::len).sum::<usize>() < MOST_POINTS;
    let slots = if is_kept { MOST_POINTS } else { (points.unwrap_or(USUAL_POINTS) - 1) / 2 };
    let mut correction: f64 = 0.0;
    let [compression, extension] = curves.map(|curve| {
        let (speeds, forces): (Vec<f64>, Vec<f64>) = curve.into_iter().unzip();
        let monotone = isotonic(&forces);
        let shifts = forces.iter().zip(&monotone).map(|(force, monotone)| (force - monotone).abs());
        correction = shifts.fold(correction, f64::max);
        let points_from_rest: Vec<(f64, f64)> =
            [(0.0, 0.0)].into_iter().chain(speeds.into_iter().zip(monotone)).collect();
        polyline(&points_from_rest, slots)
    });
    if correction > 0.0 {
        warnings.push(format!("the measured curve is not monotone: points were moved by up to {correction:.1} N"));
    }
    let negative = compression.into_iter().rev().map(|(speed, force)| (-speed, -force));
    negative.chain([(0.0, 0.0)]).chain(extension).collect()
}

/// Speed and hydraulic resistance of one direction, both positive, sorted by speed.
fn hydraulic(samples: &[Sample], offset: &Offset, is_extension: bool) -> Vec<(f64, f64)> {
    let side = samples.iter().filter(|sample| sample.is_extension() == is_extension);
    let speed_and_force = |sample: &Sample| {
        let force = sample.resistance - offset.at(sample.velocity);
        (sample.velocity.abs(), sample.velocity.signum() * force)
    };
    let mut curve: Vec<(f64, f64)> = side.map(speed_and_force).collect();
    curve.sort_by(|a, b| a.0.total_cmp(&b.0));
    curve
}

/// The curve through samples sorted by speed: the samples themselves if they are few, else local fits at speeds that
/// are denser near rest.
fn curve(samples: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    const FITS: usize = 24; // chosen
    const SLOWEST: f64 = 0.02; // of the highest speed; below it noise dominates (chosen)
    // A single outlier must not stretch the table.
    let top = samples[(samples.len() - 1) * 199 / 200].0;
    let groups = groups(&samples, 0.005 * top);
    if groups.len() <= 2 * FITS {
        return groups;
    }
    let speed = |fit: usize| top * (fit as f64 / FITS as f64).powi(2);
    let fit = |fit: usize| {
        let [at, reach] = [speed(fit), (speed(fit) - speed(fit - 1)) / 2.0];
        let near: Vec<(f64, f64)> = samples.iter().copied().filter(|sample| (sample.0 - at).abs() <= reach).collect();
        local(&near, at).map(|force| (at, force.value))
    };
    (1..=FITS).filter(|number| speed(*number) >= SLOWEST * top).filter_map(fit).collect()
}

/// The `slots` points of a curve, in addition to its first, whose connection by straight lines is nearest to all its
/// points; the last is always one of them. Found by dynamic programming.
fn polyline(curve: &[(f64, f64)], slots: usize) -> Vec<(f64, f64)> {
    let last = curve.len() - 1;
    let slots = slots.min(last);
    // Sum of squares of the best polyline that ends in a point, and the point before it; one row per number of lines.
    let mut rows = vec![vec![(f64::INFINITY, 0); curve.len()]];
    rows[0][0].0 = 0.0;
    for slot in 1..=slots {
        let before = &rows[slot - 1];
        let best = |end: usize| {
            let ways = (0..end).map(|start| (before[start].0 + misfit(&curve[start..=end]), start));
            ways.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((f64::INFINITY, 0))
        };
        let row = (0..curve.len()).map(best).collect();
        rows.push(row);
    }
    let ends = std::iter::successors(Some((slots, last)), |(slot, end)| Some((slot - 1, rows[*slot][*end].1)));
    let mut points: Vec<(f64, f64)> = ends.take(slots).map(|(_, end)| curve[end]).collect();
    points.reverse();
    points
}

/// Sum of the squared distances of points from the line between the first and the last.
fn misfit(points: &[(f64, f64)]) -> f64 {
    let line = [points[0], points[points.len() - 1]];
    points.iter().map(|point| (point.1 - Curve::from(&line[..]).linear(point.0)).powi(2)).sum()
}

/// Samples grouped by nearly equal speed, each group replaced by its medians.
fn groups(sorted: &[(f64, f64)], width: f64) -> Vec<(f64, f64)> {
    let mut groups = Vec::new();
    let mut rest = sorted;
    while let [first, ..] = rest {
        let count = rest.partition_point(|sample| sample.0 <= first.0 + width);
        let (group, others) = rest.split_at(count);
        let (mut speeds, mut forces): (Vec<f64>, Vec<f64>) = group.iter().copied().unzip();
        groups.push((median(&mut speeds), median(&mut forces)));
        rest = others;
    }
    groups
}

/// Root mean square and largest difference between the samples and the result.
fn errors(samples: &[Sample], offset: &Offset, table: &[(f64, f64)]) -> [f64; 2] {
    let difference =
        |sample: &Sample| sample.resistance - offset.at(sample.velocity) - Curve::from(table).linear(sample.velocity);
    let squares: f64 = samples.iter().map(|sample| difference(sample).powi(2)).sum();
    let largest = samples.iter().map(|sample| difference(sample).abs()).fold(0.0, f64::max);
    [(squares / samples.len() as f64).sqrt(), largest]
}

impl Damper {
    /// Whether every number is finite and the table rises from each point to the next.
    fn is_sound(&self) -> bool {
        let level = self.friction.map(|friction| friction.level);
        let asymmetry = self.friction.and_then(|friction| friction.asymmetry);
        let estimates = [level, self.gas_force, self.gradient].into_iter().flatten();
        let estimated = estimates.flat_map(|estimate| [estimate.value, estimate.deviation]);
        let mut numbers = estimated.chain([self.rms_error, self.max_error]).chain(asymmetry);
        numbers.all(f64::is_finite)
            && self.table.iter().all(|(velocity, force)| velocity.is_finite() && force.is_finite())
            && self.table.windows(2).all(|pair| pair[0].0 < pair[1].0 && pair[0].1 <= pair[1].1)
    }

    /// The parameter set of the shock absorber. The friction is that of both contacts together, without side load: the
    /// preloads of the contacts, static and kinetic, keep the proportions that they have in the defaults.
    pub fn parameter_set(&self, name: &str) -> Result<ParameterSet, DynoError> {
        self.parameter_set_with(name, &[])
    }

    /// As [`Damper::parameter_set`], with these values instead of those of the same name.
    pub fn parameter_set_with(&self, name: &str, instead: &[(String, f64)]) -> Result<ParameterSet, DynoError> {
        let model = shock_absorber()?;
        let mut values = self.values(model)?;
        values.retain(|(name, _)| instead.iter().all(|(other, _)| other != name));
        values.extend_from_slice(instead);
        Ok(ParameterSet::new(model, name, values)?)
    }

    fn values(&self, model: &'static ModelType) -> Result<Vec<(String, f64)>, DynoError> {
        let mut values = vec![
            ("damper.mode".to_owned(), choice(model, "damper.mode", "Table")?),
            ("damper.tab_n".to_owned(), self.table.len() as f64),
        ];
        for ((velocity, force), index) in self.table.iter().zip(1..) {
            values.push((format!("damper.tab_v[{index}]"), *velocity));
            values.push((format!("damper.tab_f[{index}]"), *force));
        }
        if let Some(friction) = self.friction {
            values.extend(preloads(model, friction.level.value)?);
            values.extend(friction.asymmetry.map(|asymmetry| ("friction.asymmetry".to_owned(), asymmetry)));
        }
        Ok(values)
    }
}

/// The model that the sets are for.
pub fn shock_absorber() -> Result<&'static ModelType, DynoError> {
    const NAME: &str = "ShockAbsorber";
    catalogue::by_name(NAME).ok_or(DynoError::NoModel(NAME))
}

/// Preloads of the contacts for a kinetic friction force.
fn preloads(model: &'static ModelType, level: f64) -> Result<Vec<(String, f64)>, DynoError> {
    let names = ["c1.preload_k", "c2.preload_k", "c1.preload_s", "c2.preload_s"];
    let starts = ParameterSet::starts(model, names)?;
    let scale = level / (starts[0] + starts[1]);
    Ok(names.into_iter().zip(starts).map(|(name, start)| (name.to_owned(), start * scale)).collect())
}

#[cfg(test)]
mod tests;
