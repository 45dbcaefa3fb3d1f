//! Elementary functions, the only ones that the laws use. The functions of a platform's mathematical library differ in
//! the last digit from one platform to the next; these give the same bits everywhere.
//!
//! [`exp`], [`exp_m1`] and [`tanh`], which nearly every law needs, are written here: one kernel without branches or
//! fused operations, so that a loop over many values can run it in the lanes of a processor with the same result.
//! The others come from the crate `libm`, which is written in Rust alone. What IEEE 754 rounds correctly, such as the
//! square root, is the same everywhere as it is.

use std::f64::consts::LOG2_E;
use std::ops::{Add, Div, Mul, Sub};

pub use libm::{atan, atan2, cos, cosh, hypot, log as ln, log1p as ln_1p, pow, sin, sinh};

/// Added to a number and subtracted again, it rounds to an integer; the last bits of the sum are that integer + 2046.
const ROUNDING: f64 = 1.5 * (1u64 << 52) as f64 + 2046.0;
/// ln 2 to 42 bits: a multiple of it by an integer of 11 bits is exact.
const LN_2_HIGH: f64 = f64::from_bits(0x3fe6_2e42_fefa_3800);
/// The rest of ln 2.
const LN_2_LOW: f64 = 5.497_923_018_708_371e-14;

/// Q in exp(r) = 1 + r + r^2 Q(r), of least relative error of exp(r) - 1 for |r| <= ln(2) / 2: 6e-19 (Remez).
const Q: [f64; 11] = [
    0.5,
    0.166_666_666_666_666_77,
    0.041_666_666_666_666_7,
    0.008_333_333_333_321_606,
    0.001_388_888_888_886_686,
    0.000_198_412_698_861_849_92,
    2.480_158_736_052_665e-5,
    2.755_724_415_230_836_7e-6,
    2.755_724_277_359_755e-7,
    2.510_905_615_567_31e-8,
    2.092_444_186_418_452e-9,
];

/// A number, or several in lanes, in which [`exp`], [`exp_m1`] and [`tanh`] are written.
pub(super) trait Kernel:
    Copy + From<f64> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// `f64::clamp`, as two selects. NaN stays NaN.
    fn within(self, least: f64, most: f64) -> Self;
    /// The number without its sign.
    fn magnitude(self) -> Self;
    /// The number with the sign of another one.
    fn with_sign(self, of: Self) -> Self;
    /// 2^(k + 1023 - offset) for a number whose last 12 bits are k + 2046: its bits, less `offset`, as an exponent.
    fn power(self, offset: u64) -> Self;
    /// Two powers of 2 whose product is 2^k, for the same number.
    fn halves(self) -> [Self; 2];
}

impl Kernel for f64 {
    #[inline(always)]
    fn within(self, least: f64, most: f64) -> f64 {
        let x = if self < least { least } else { self };
        if x > most { most } else { x }
    }
    #[inline(always)]
    fn magnitude(self) -> f64 {
        self.abs()
    }
    #[inline(always)]
    fn with_sign(self, of: f64) -> f64 {
        self.copysign(of)
    }
    #[inline(always)]
    fn power(self, offset: u64) -> f64 {
        f64::from_bits(self.to_bits().wrapping_sub(offset) << 52)
    }
    #[inline(always)]
    fn halves(self) -> [f64; 2] {
        let exponents = self.to_bits() & 0xfff;
        let first = exponents >> 1;
        [first, exponents - first].map(|exponent| f64::from_bits(exponent << 52))
    }
}

/// e to the power of `x`; less than 1 unit in the last place (ulp) off.
#[inline]
pub fn exp(x: f64) -> f64 {
    exp_of(x)
}

/// e to the power of `x`, minus 1, also accurate near 0; less than 2 ulp off.
#[inline]
pub fn exp_m1(x: f64) -> f64 {
    exp_m1_of(x)
}

/// Hyperbolic tangent; less than 2 ulp off, exactly -1 or 1 where that is the nearest number.
#[inline]
pub fn tanh(x: f64) -> f64 {
    tanh_of(x)
}

#[inline(always)]
pub(super) fn exp_of<T: Kernel>(x: T) -> T {
    // Beyond these limits the result is 0 or infinite; within them two factors of 2^k are enough, one may not exist.
    let (rise, power) = reduced(x.within(-746.0, 710.0));
    let [first, second] = power.halves();
    (T::from(1.0) + rise) * first * second
}

#[inline(always)]
pub(super) fn exp_m1_of<T: Kernel>(x: T) -> T {
    let (rise, power) = reduced(x.within(-100.0, 710.0));
    // 2^(k - 1), as 2^1024 does not exist.
    let half_power = power.power(1024);
    (T::from(2.0) * (half_power * rise + (half_power - T::from(0.5)))).with_sign(x)
}

#[inline(always)]
pub(super) fn tanh_of<T: Kernel>(x: T) -> T {
    let (rise, power) = reduced((T::from(-2.0) * x.magnitude()).within(-80.0, 0.0));
    let (one, power) = (T::from(1.0), power.power(1023));
    let rise = power * rise;
    ((rise + (power - one)) / (rise + (power + one))).with_sign(x)
}

/// `x` to the power of 2.
#[inline]
pub fn square(x: f64) -> f64 {
    x * x
}

/// exp(r) - 1 with x = k ln 2 + r, |r| <= ln(2) / 2, and a number whose last 12 bits are k + 2046. |x| < 1000.
#[inline(always)]
fn reduced<T: Kernel>(x: T) -> (T, T) {
    let rounding = T::from(ROUNDING);
    let sum = x * T::from(LOG2_E) + rounding;
    let k = sum - rounding;
    let high = x - k * T::from(LN_2_HIGH);
    let low = k * T::from(LN_2_LOW);
    let r = high - low;
    let lost = (high - r) - low;
    let r_2 = r * r;
    let r_4 = r_2 * r_2;
    let first = (T::from(Q[0]) + T::from(Q[1]) * r) + r_2 * (T::from(Q[2]) + T::from(Q[3]) * r);
    let second = (T::from(Q[4]) + T::from(Q[5]) * r) + r_2 * (T::from(Q[6]) + T::from(Q[7]) * r);
    let third = (T::from(Q[8]) + T::from(Q[9]) * r) + r_2 * T::from(Q[10]);
    let q = first + r_4 * (second + r_4 * third);
    (r + (r_2 * q + lost), sum)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use super::*;

    /// A number as the sum of two f64 (Dekker): 32 digits.
    #[derive(Clone, Copy)]
    struct Pair(f64, f64);

    impl Pair {
        fn sum(a: f64, b: f64) -> Pair {
            let s = a + b;
            let t = s - a;
            Pair(s, (a - (s - t)) + (b - t))
        }
        fn add(self, other: Pair) -> Pair {
            let (high, low) = (Pair::sum(self.0, other.0), Pair::sum(self.1, other.1));
            let high = Pair::sum(high.0, high.1 + low.0);
            Pair::sum(high.0, high.1 + low.1)
        }
        fn mul(self, other: Pair) -> Pair {
            let product = self.0 * other.0;
            Pair::sum(product, self.0.mul_add(other.0, -product) + (self.0 * other.1 + self.1 * other.0))
        }
        fn div(self, other: Pair) -> Pair {
            let first = self.0 / other.0;
            let rest = self.add(other.mul(Pair(-first, 0.0)));
            let second = rest.0 / other.0;
            let rest = rest.add(other.mul(Pair(-second, 0.0)));
            Pair::sum(first, second).add(Pair(rest.0 / other.0, 0.0))
        }
    }

    const ONE: Pair = Pair(1.0, 0.0);
    /// How many numbers are tried; Miri is slow.
    const TRIED: u32 = if cfg!(miri) { 200 } else { 200_000 };

    /// exp(x) - 1 by its series at x / 2^m, and exp(2t) - 1 = (exp(t) - 1)(exp(t) + 1) m times.
    fn exact_exp_m1(x: f64) -> Pair {
        let halvings = 13;
        let t = Pair(x / f64::from(1 << halvings), 0.0);
        let mut result = Pair(0.0, 0.0);
        for n in (2..=14).rev() {
            result = t.div(Pair(f64::from(n), 0.0)).mul(result.add(ONE));
        }
        result = t.mul(result.add(ONE));
        for _ in 0..halvings {
            result = result.mul(result.add(Pair(2.0, 0.0)));
        }
        result
    }

    fn exact_exp(x: f64) -> Pair {
        let rise = exact_exp_m1(x.abs()).add(ONE);
        if x < 0.0 { ONE.div(rise) } else { rise }
    }

    fn exact_tanh(x: f64) -> Pair {
        let rise = exact_exp_m1(2.0 * x);
        rise.div(rise.add(Pair(2.0, 0.0)))
    }

    /// Distance in units in the last place of the exact result.
    fn ulps(result: f64, exact: Pair) -> f64 {
        let unit = exact.0.abs().next_up() - exact.0.abs();
        (Pair::sum(result, -exact.0).add(Pair(-exact.1, 0.0)).0 / unit).abs()
    }

    /// Numbers up to `most` in magnitude, dense everywhere, and numbers of all magnitudes below.
    fn numbers(most: f64) -> impl Iterator<Item = f64> {
        let share = |k: u32, step: f64| (f64::from(k) * step).fract();
        (1..TRIED).map(move |k| {
            let x = most * (2.0 * share(k, 0.618_033_988_749_894_9) - 1.0);
            if k % 2 == 0 { x } else { x * 0.5f64.powf(60.0 * share(k, 0.754_877_666_246_692_7)) }
        })
    }

    fn worst(function: fn(f64) -> f64, exact: fn(f64) -> Pair, most: f64) -> f64 {
        numbers(most).map(|x| ulps(function(x), exact(x))).fold(0.0, f64::max)
    }

    #[test]
    fn errors_are_small_everywhere() {
        // The low half of a pair needs 53 bits below the result, so not as far as exp itself reaches.
        let exp_error = worst(exp, exact_exp, 660.0).max(worst(exp, exact_exp, 3.0));
        let exp_m1_error = worst(exp_m1, exact_exp_m1, 660.0).max(worst(exp_m1, exact_exp_m1, 3.0));
        let tanh_error = worst(tanh, exact_tanh, 20.0).max(worst(tanh, exact_tanh, 2.0));
        println!("errors in ulp: exp {exp_error:.2}, exp_m1 {exp_m1_error:.2}, tanh {tanh_error:.2}");
        assert!(exp_error < 1.0 && exp_m1_error < 2.0 && tanh_error < 2.0);
    }

    #[test]
    fn exponential_reaches_its_limits() {
        for x in [0.0, -0.0] {
            assert_eq!(exp(x), 1.0);
            assert_eq!(exp_m1(x).to_bits(), x.to_bits());
            assert_eq!(tanh(x).to_bits(), x.to_bits());
        }
        // ln of the largest number, and the next number, whose exponential is beyond it.
        let last = 709.782_712_893_384;
        assert!((exp(last) / f64::MAX - 1.0).abs() < 1e-12 && (exp_m1(last) / f64::MAX - 1.0).abs() < 1e-12);
        for x in [last.next_up(), 710.0, 1e308, f64::INFINITY] {
            assert_eq!((exp(x), exp_m1(x), tanh(x)), (f64::INFINITY, f64::INFINITY, 1.0));
        }
        for x in [-746.0, -1e308, f64::NEG_INFINITY] {
            assert_eq!((exp(x), exp_m1(x), tanh(x)), (0.0, -1.0, -1.0));
        }
        assert!(exp(f64::NAN).is_nan() && exp_m1(f64::NAN).is_nan() && tanh(f64::NAN).is_nan());
        // Half of the smallest number is e^-745.133...: it is the nearest number above, 0 below.
        assert_eq!((exp(-745.13), exp(-745.14)), (f64::from_bits(1), 0.0));
    }

    /// In the range where neighbours are 5e-324 apart: by the square of a number that is not.
    #[test]
    fn exponential_underflows_gradually() {
        for k in 0..TRIED {
            let x = -680.0 - 66.0 * f64::from(k) / f64::from(TRIED);
            let root = exact_exp(0.5 * x);
            let expected = root.0 * (root.0 + 2.0 * root.1);
            assert!((exp(x) - expected).abs() <= f64::from_bits(1) + 2.3e-16 * expected, "{x}");
        }
    }

    /// Also from one k to the next. Neighbours closer than the error are not compared.
    #[test]
    fn functions_never_fall() {
        let mut before = [0.0, -1.0, -1.0];
        for k in 0..=TRIED {
            let x = 40.0 * (f64::from(k) / f64::from(TRIED) - 0.5);
            let now = [exp(x), exp_m1(x), tanh(x)];
            assert!(now.iter().zip(before).all(|(now, before)| *now >= before), "{x}");
            before = now;
        }
    }

    /// Those of `libm` belong together: identities, and the numbers of their definitions.
    #[test]
    fn functions_agree_with_each_other() {
        let near = |a: f64, b: f64| assert!((a - b).abs() <= 4e-15 * b.abs().max(1.0), "{a} {b}");
        for x in numbers(8.0).take(2_000) {
            near(square(sin(x)) + square(cos(x)), 1.0);
            near(sin(2.0 * x), 2.0 * sin(x) * cos(x));
            near(atan(sin(0.19 * x) / cos(0.19 * x)), 0.19 * x);
            near(exp(ln(x.abs())), x.abs());
            near(ln_1p(exp_m1(x.abs())), x.abs());
            near(atan2(sin(0.4 * x), cos(0.4 * x)), (0.4 * x + PI).rem_euclid(TAU) - PI);
            near(sinh(x) / cosh(x), tanh(x));
            near(cosh(x), 0.5 * (exp(x) + exp(-x)));
            near(pow(x.abs(), 1.5), x.abs() * x.abs().sqrt());
            near(hypot(3.0 * x, 4.0 * x), 5.0 * x.abs());
        }
    }
}
