//! Strengths of the elements of Leuven friction while the load is held or moves linearly.

use crate::contact::elements::{self, Division};
use crate::number::elementary::exp_m1;

/// Forces that the elements can carry, in shares of w f_s.
#[derive(Clone, Copy)]
pub(crate) struct Limits<'a> {
    pub division: &'a Division<f64>,
    /// w f_s as seen by the elements; it falls with the deflection where the load falls, down to a floor.
    pub line: f64,
    pub fall: f64,
    pub floor: f64,
    /// Elements that slip along their rising strength, and w f_s in the middle of the piece, where they are held.
    pub slipping: Marks,
    pub held: f64,
}

impl<'a> Limits<'a> {
    /// Limits for a held load.
    pub(crate) fn held(division: &'a Division<f64>, strength: f64) -> Limits<'a> {
        Limits { division, line: strength, fall: 0.0, floor: strength, slipping: Marks::default(), held: strength }
    }

    /// w f_s as seen by an element.
    pub(crate) fn at(&self, index: usize) -> f64 {
        if self.slipping.has(index) { self.held } else { self.line }
    }

    /// The deflection at which an element slips, given its force in the direction of the deflection; none if it does
    /// not follow.
    #[inline]
    pub(crate) fn room(&self, index: usize, stiffness: f64, share: f64, force: f64) -> Option<f64> {
        if self.slipping.has(index) {
            let left = share * self.held - force;
            return (left > 0.0).then(|| left / stiffness);
        }
        let left = share * self.line - force;
        if self.fall == 0.0 {
            return (left > 0.0).then(|| left / stiffness);
        }
        let above_floor = share * self.floor - force;
        (left > 0.0).then(|| f64::max(left / (stiffness + share * self.fall), above_floor / stiffness))
    }
}

/// A mark on each of some elements.
#[derive(Clone, Copy, Default)]
pub(crate) struct Marks([u64; elements::MOST.div_ceil(64)]);

impl Marks {
    /// Whether an element has one.
    #[inline]
    pub(crate) fn has(&self, index: usize) -> bool {
        self.0[index / 64] >> (index % 64) & 1 == 1
    }

    /// Marks an element.
    pub(crate) fn set(&mut self, index: usize) {
        self.0[index / 64] |= 1 << (index % 64);
    }
}

/// Both ends of a piece of a ramp, and its middle, whose inputs are set.
pub(crate) struct Stretch {
    /// w f_s at both ends.
    pub strength: [f64; 2],
    /// |s| at both ends.
    pub level: [f64; 2],
    /// |v| at the end.
    pub speed: f64,
    pub duration: f64,
}

impl Stretch {
    /// Slope of w f_s.
    pub(crate) fn rise(&self) -> f64 {
        (self.strength[1] - self.strength[0]) / self.duration
    }

    /// K |v| / |s| times the duration, at the end and near the level, where the law is n times as fast.
    pub(crate) fn distance(&self, stiffness: f64, exponent: f64) -> f64 {
        exponent * stiffness * self.speed * self.duration / self.level[1]
    }
}

/// 1 / x - 1 / (e^x - 1): the lag of an exponential approach behind its moving level after x, in shares of the change.
pub(crate) fn lag(x: f64) -> f64 {
    if x < 1e-3 { 0.5 - x / 12.0 } else { 1.0 / x - 1.0 / exp_m1(x) }
}
