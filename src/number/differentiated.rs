//! What numbers with derivatives have in common, in however many directions those are.
//!
//! A macro, not a trait: the functions are those of [`Real`](super::Real), which every number has of its own.

/// Comparisons of numbers with derivatives: of their values.
macro_rules! compared {
    ($Number:ident) => {
        impl PartialEq for $Number {
            fn eq(&self, other: &$Number) -> bool {
                self.value == other.value
            }
        }

        impl PartialOrd for $Number {
            fn partial_cmp(&self, other: &$Number) -> Option<std::cmp::Ordering> {
                self.value.partial_cmp(&other.value)
            }
        }
    };
}

/// Functions of [`Real`](super::Real) for numbers with a `value`, and with derivatives to which the chain rule applies.
macro_rules! differentiated {
    () => {
        type Mask = bool;

        #[inline(always)]
        fn lane(self, _lane: usize) -> f64 {
            self.value
        }
        fn is(self, constant: f64) -> bool {
            self.value == constant && !self.has_slope()
        }
        #[inline(always)]
        fn above(self, other: Self) -> bool {
            self > other
        }
        #[inline(always)]
        fn at_least(self, other: Self) -> bool {
            self >= other
        }
        #[inline(always)]
        fn equals(self, other: Self) -> bool {
            self == other
        }
        fn as_constant(self) -> Self {
            Self::from(self.value)
        }
        fn sign(self) -> Self {
            Self::from(f64::from(i8::from(self.value > 0.0) - i8::from(self.value < 0.0)))
        }
        fn exp(self) -> Self {
            let value = elementary::exp(self.value);
            // If the exponential vanishes, its derivative vanishes too, however fast the exponent changes.
            if value == 0.0 { Self::from(0.0) } else { self.chain(value, value) }
        }
        fn exp_m1(self) -> Self {
            let value = elementary::exp_m1(self.value);
            self.chain(value, 1.0 + value)
        }
        fn ln(self) -> Self {
            self.chain(elementary::ln(self.value), 1.0 / self.value)
        }
        fn ln_1p(self) -> Self {
            self.chain(elementary::ln_1p(self.value), 1.0 / (1.0 + self.value))
        }
        fn tanh(self) -> Self {
            let value = elementary::tanh(self.value);
            self.chain(value, 1.0 - value * value)
        }
        fn sin(self) -> Self {
            self.chain(elementary::sin(self.value), elementary::cos(self.value))
        }
        fn cos(self) -> Self {
            self.chain(elementary::cos(self.value), -elementary::sin(self.value))
        }
        fn atan(self) -> Self {
            self.chain(elementary::atan(self.value), 1.0 / (1.0 + self.value * self.value))
        }
        fn sqrt(self) -> Self {
            let value = self.value.sqrt();
            self.chain(value, 0.5 / value)
        }
        fn powf(self, exponent: Self) -> Self {
            let value = elementary::pow(self.value, exponent.value);
            let by_base = self.chain(value, exponent.value * elementary::pow(self.value, exponent.value - 1.0));
            // The limit of x^p ln x as x goes to 0 is 0 for p > 0.
            let log = if value == 0.0 { 0.0 } else { elementary::ln(self.value) };
            by_base.with_slope_of(exponent.chain(value, value * log))
        }
    };
}

pub(super) use {compared, differentiated};
