//! Repeats, and their scatter.
//!
//! # Equations
//! Rows of the same speed and load are repeats. With the residuals r from the mean of each setting, and the degrees of
//! freedom nu of all settings, of a band of speeds, and the number k of bands:
//!
//! ```text
//! s2  = sum of r2 / nu                                     pooled
//! chi2 = (nu ln s2 - sum of nu_b ln s2_b) / (1 + (sum of 1 / nu_b - 1 / nu) / (3 (k - 1)))
//! ```
//!
//! Where scatter makes chi2 as large as that in less than one of 100 maps, each band has a scatter of its own.
//!
//! # Source
//! M. S. Bartlett, "Properties of sufficiency and statistical tests", Proceedings of the Royal Society A 160 (1937),
//! doi:10.1098/rspa.1937.0109.

use stribeck::number::Real;

use super::super::interval::chi_square;

/// Scatter of the repeats of a map.
#[derive(Clone, Debug, PartialEq)]
pub struct Scatter {
    /// Standard deviation, N, of all repeats together.
    pub pooled: f64,
    /// Its degrees of freedom.
    pub freedom: usize,
    /// Scatter by speed; empty if it is the same at all speeds.
    pub bands: Vec<Band>,
}

/// Scatter in a band of speeds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// Largest speed, m/s.
    pub up_to: f64,
    /// Standard deviation, N.
    pub scatter: f64,
}

/// Degrees of freedom of a band, at least (chosen): its standard deviation is then known to about a fifth.
const OF_BAND: usize = 10;

/// Standard deviations of the normal distribution that are exceeded, to one side, in one of 100 cases.
pub(super) const RARE: f64 = 2.326_347_874_040_841;

/// Part of a value by which repeats may differ, if their file rounds as coarsely (chosen).
const ALIKE: f64 = 0.01;

/// Part of a value by which it may be off after a conversion of its unit.
const CONVERTED: f64 = 1e-9;

/// Whether values are the same but for the rounding of their file.
pub(super) fn is_same(a: f64, b: f64, rounding: f64) -> bool {
    let apart = (a - b).abs();
    apart <= CONVERTED * a.abs() || apart <= (1.0 + CONVERTED) * rounding.min(ALIKE * a.abs())
}

/// Most decimals that are looked for.
const DECIMALS: i32 = 9;

/// Unit of the last decimal of values; 0 if they have more decimals than a file that rounds.
fn rounding(values: &[f64]) -> f64 {
    let is_whole = |scaled: f64| (scaled - scaled.round()).abs() <= 1e-6;
    let decimals = (0..=DECIMALS).find(|decimals| values.iter().all(|value| is_whole(value * 10f64.powi(*decimals))));
    decimals.map_or(0.0, |decimals| 10f64.powi(-decimals))
}

/// Divides rows into those of the same value, which ascends.
fn alike(values: &[f64], mut rows: Vec<usize>) -> Vec<Vec<usize>> {
    let unit = rounding(values);
    rows.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let mut found: Vec<Vec<usize>> = Vec::new();
    for row in rows {
        match found.last_mut().filter(|group| is_same(values[group[0]], values[row], unit)) {
            Some(group) => group.push(row),
            None => found.push(vec![row]),
        }
    }
    found
}

/// The number of the setting of each row: velocity and load.
pub(super) fn settings(velocity: &[f64], load: &[f64]) -> Vec<usize> {
    let of_speed = alike(velocity, (0..velocity.len()).collect());
    let groups = of_speed.into_iter().flat_map(|rows| alike(load, rows));
    let mut found = vec![0; velocity.len()];
    for (number, rows) in groups.enumerate() {
        rows.iter().for_each(|row| found[*row] = number);
    }
    found
}

/// Squares of residuals, with their degrees of freedom, at a speed or up to it.
#[derive(Clone, Copy, Default)]
struct Squares {
    speed: f64,
    sum: f64,
    freedom: usize,
}

impl Squares {
    fn with(self, other: Squares) -> Squares {
        Squares { speed: other.speed, sum: self.sum + other.sum, freedom: self.freedom + other.freedom }
    }

    /// Variance, at least that of the rounding.
    fn variance(&self, least: f64) -> f64 {
        (self.sum / self.freedom as f64).max(least)
    }
}

/// Squares around the means of the settings with repeats, by speed.
fn squares(velocity: &[f64], force: &[f64], settings: &[usize]) -> Vec<Squares> {
    let count = settings.iter().max().map_or(0, |most| most + 1);
    let mut rows: Vec<Vec<usize>> = vec![Vec::new(); count];
    // At rest a force is whatever holds.
    (0..settings.len()).filter(|row| velocity[*row] != 0.0).for_each(|row| rows[settings[row]].push(row));
    let of = |rows: &Vec<usize>| {
        let mean = rows.iter().map(|row| force[*row]).sum::<f64>() / rows.len() as f64;
        let sum = rows.iter().map(|row| (force[*row] - mean).powi(2)).sum();
        Squares { speed: velocity[rows[0]].abs(), sum, freedom: rows.len() - 1 }
    };
    let mut found: Vec<Squares> = rows.iter().filter(|rows| rows.len() > 1).map(of).collect();
    found.sort_by(|a, b| a.speed.total_cmp(&b.speed));
    found
}

/// Bands of speeds with enough repeats.
fn banded(squares: &[Squares]) -> Vec<Squares> {
    let mut bands: Vec<Squares> = Vec::new();
    let mut open = Squares::default();
    for one in squares {
        open = open.with(*one);
        if open.freedom >= OF_BAND {
            bands.push(std::mem::take(&mut open));
        }
    }
    if let Some(last) = bands.last_mut().filter(|_| open.freedom > 0) {
        *last = last.with(open);
    }
    bands
}

/// Whether bands differ by more than chance.
fn differ(bands: &[Squares], least: f64) -> bool {
    let all = bands.iter().fold(Squares::default(), |sum, band| sum.with(*band));
    let weighted = |one: &Squares| one.freedom as f64 * Real::ln(one.variance(least));
    let more = bands.len() as f64 - 1.0;
    if more < 1.0 {
        return false;
    }
    let reciprocals: f64 = bands.iter().map(|band| 1.0 / band.freedom as f64).sum();
    let correction = 1.0 + (reciprocals - 1.0 / all.freedom as f64) / (3.0 * more);
    let found = (weighted(&all) - bands.iter().map(weighted).sum::<f64>()) / correction;
    found > chi_square(more, RARE)
}

impl Scatter {
    /// None without repeats.
    pub(super) fn of(velocity: &[f64], force: &[f64], settings: &[usize]) -> Option<Scatter> {
        let squares = squares(velocity, force, settings);
        let all = squares.iter().fold(Squares::default(), |sum, one| sum.with(*one));
        let level = force.iter().fold(f64::MIN_POSITIVE, |most: f64, force| most.max(force.abs()));
        // Rounding is the least scatter: its variance is a twelfth of its square.
        let least = (rounding(force).powi(2) / 12.0).max((CONVERTED * level).powi(2));
        let bands = banded(&squares);
        let bands = if differ(&bands, least) { bands } else { Vec::new() };
        let band = |one: &Squares| Band { up_to: one.speed, scatter: one.variance(least).sqrt() };
        let pooled = (all.freedom > 0).then(|| all.variance(least).sqrt())?;
        Some(Scatter { pooled, freedom: all.freedom, bands: bands.iter().map(band).collect() })
    }

    /// Standard deviation of a row at a velocity, N.
    pub fn at(&self, velocity: f64) -> f64 {
        let band = self.bands.iter().find(|band| velocity.abs() <= band.up_to).or(self.bands.last());
        band.map_or(self.pooled, |band| band.scatter)
    }

    pub(super) fn weight(&self, velocity: f64) -> f64 {
        self.pooled / self.at(velocity)
    }
}
