//! Bounds of values.

use std::fmt;

/// The values a column admits. NaN and infinities are never admitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    // Both ends are admitted.
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Bound {
    /// The smallest number admitted for values that must be > 0, such as a stiffness (chosen). FMI's `min` and `max`
    /// are themselves admitted values, so a description cannot exclude 0 as such. This number is short, far below any
    /// meaningful value, and has a finite reciprocal, unlike the smallest doubles.
    pub const SMALLEST_POSITIVE: f64 = 1e-300;

    /// Every finite number.
    pub const ANY: Bound = Bound { low: f64::MIN, high: f64::MAX };

    /// Whether the bound admits `value`.
    #[inline]
    pub const fn admits(&self, value: f64) -> bool {
        value >= self.low && value <= self.high
    }

    /// The admitted value nearest to `value`.
    pub const fn nearest(&self, value: f64) -> f64 {
        value.clamp(self.low, self.high)
    }

    /// Lower end; `f64::MIN` if there is none.
    pub const fn min(&self) -> f64 {
        self.low
    }

    /// Upper end; `f64::MAX` if there is none.
    pub const fn max(&self) -> f64 {
        self.high
    }

    /// Admits the values of both bounds and everything between.
    pub(crate) const fn or(self, other: Bound) -> Bound {
        Bound { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The same up to `high`.
    pub(crate) const fn up_to(self, high: f64) -> Bound {
        Bound { high: self.high.min(high), ..self }
    }

    /// Whether values must be > 0, as for a stiffness.
    pub const fn is_positive(&self) -> bool {
        self.low == Bound::SMALLEST_POSITIVE
    }
}

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (relation, low) = if self.is_positive() { (">", 0.0) } else { (">=", self.low) };
        let (low, high) = (Brief(low), Brief(self.high));
        match (self.low > f64::MIN, self.high < f64::MAX) {
            (false, false) => write!(f, "a finite number"),
            (true, false) => write!(f, "{relation} {low} and finite"),
            (false, true) => write!(f, "<= {high} and finite"),
            (true, true) => write!(f, "{relation} {low} and <= {high}"),
        }
    }
}

/// A number as messages show it: with an exponent if it would have many zeros.
#[derive(Clone, Copy, Debug)]
pub struct Brief(pub f64);

impl fmt::Display for Brief {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Brief(value) = *self;
        let plain = value == 0.0 || !value.is_finite() || (1e-5..1e16).contains(&value.abs());
        if plain { write!(f, "{value}") } else { write!(f, "{value:e}") }
    }
}
