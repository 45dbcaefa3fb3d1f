//! Zeros of functions: instants of events within a step, and solutions of implicit steps.

use crate::number::Dual;

/// The smallest t of an interval with `f(t) >= 0`, if f is negative at `low`, not negative at `high` and rises through
/// zero once in between: bisection until two neighbouring numbers are left.
pub fn bisect(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    for round in 0.. {
        let middle = middle(low, high, round);
        if middle <= low || middle >= high {
            break;
        }
        if f(middle) >= 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

/// The point at which to divide a bracket. By value, 60 rounds find all digits of a zero of the bracket's own
/// magnitude; a much smaller one would take up to 1000 more rounds. By the count of floating-point numbers in between,
/// 64 are enough.
fn middle(low: f64, high: f64, round: usize) -> f64 {
    if round < 60 {
        return low + 0.5 * (high - low);
    }
    number_at(i64::midpoint(place(low), place(high)))
}

/// Position of x in the sequence of all numbers: neighbours differ by one, and both zeros are at 0.
fn place(x: f64) -> i64 {
    let bits = x.abs().to_bits() as i64;
    if x < 0.0 { -bits } else { bits }
}

fn number_at(place: i64) -> f64 {
    f64::from_bits(place.unsigned_abs()).copysign(place as f64)
}

/// The instant in (from, to) at which the monotonic function w passes `level`, if it does.
pub fn crossing(w: impl Fn(f64) -> f64, level: f64, from: f64, to: f64) -> Option<f64> {
    let (before, after) = (w(from) - level, w(to) - level);
    let passes = before < 0.0 && after > 0.0 || before > 0.0 && after < 0.0;
    // NaN passes nothing.
    passes.then(|| bisect(|t| if after > 0.0 { w(t) - level } else { level - w(t) }, from, to))
}

/// The first t in [0, end] with `f(t) >= 0` and not falling, for an f that has the sign of a cubic polynomial with these
/// coefficients of t, t^2 and t^3. The polynomial gives the turning points of f, f itself its zero.
pub fn first_rise(f: impl Fn(f64) -> f64, c: [f64; 3], end: f64) -> Option<f64> {
    // A zero from which f falls does not count: a contact whose load has just appeared.
    if f(0.0) > 0.0 || f(0.0) == 0.0 && c[0] >= 0.0 {
        return Some(0.0);
    }
    let mut from = 0.0;
    for to in turns(c).into_iter().filter(|t| *t > 0.0 && *t < end).chain([end]) {
        if f(to) >= 0.0 {
            return Some(bisect(f, from, to));
        }
        from = to;
    }
    None
}

/// The zero of a rising function in [low, high]: Newton's method, with bisection where it leaves the bracket. `f` gives
/// value and slope.
pub fn newton(f: impl Fn(f64) -> Dual, mut low: f64, mut high: f64) -> f64 {
    let mut x = low + 0.5 * (high - low);
    // Bisection alone may need some 130 rounds.
    for round in 0..200 {
        let y = f(x);
        if y.value > 0.0 {
            high = x;
        } else {
            low = x;
        }
        let newton = x - y.value / y.slope;
        let next = if newton > low && newton < high { newton } else { middle(low, high, round) };
        if y.value == 0.0 || (next - x).abs() <= f64::EPSILON * x.abs() || next <= low || next >= high {
            break;
        }
        x = next;
    }
    x
}

/// The zero of a rising function near `start`: first in steps that double until f has changed its sign, then by regula
/// falsi after Illinois. `slope` is the least slope of f, or a guess: with the least one, the first step passes the zero.
/// A value of at most `near` counts as 0.
pub fn rising(f: impl Fn(f64) -> f64, start: f64, slope: f64, near: f64) -> f64 {
    let (mut a, mut at_a) = (start, f(start));
    if at_a.abs() <= near {
        return a;
    }
    let mut reach = -at_a / slope;
    let (mut b, mut at_b) = (a + reach, f(a + reach));
    for _ in 0..64 {
        if at_b.signum() != at_a.signum() || at_b.abs() <= near {
            break;
        }
        reach *= 2.0;
        (a, at_a) = (b, at_b);
        b = a + reach;
        at_b = f(b);
    }
    for round in 1..200 {
        if at_b.abs() <= near {
            break;
        }
        let falsi = b - at_b * (b - a) / (at_b - at_a);
        let is_between = falsi > a.min(b) && falsi < a.max(b);
        // A kink may hold one end for long.
        let c = if is_between && round % 4 != 0 { falsi } else { a + 0.5 * (b - a) };
        if c == a || c == b {
            break;
        }
        let at_c = f(c);
        if at_c.signum() == at_b.signum() {
            at_a *= 0.5;
        } else {
            (a, at_a) = (b, at_b);
        }
        (b, at_b) = (c, at_c);
    }
    b
}

/// The zeros of the cubic's derivative in rising order; infinite or NaN if they do not exist.
fn turns([c_1, c_2, c_3]: [f64; 3]) -> [f64; 2] {
    // 3 c_3 t^2 + 2 c_2 t + c_1 = 0, in the form that preserves all digits.
    let root = (c_2 * c_2 - 3.0 * c_3 * c_1).sqrt();
    let sum = -(c_2 + root.copysign(c_2));
    let (a, b) = (sum / (3.0 * c_3), c_1 / sum);
    if a < b { [a, b] } else { [b, a] }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    #[test]
    fn newton_finds_zeros_of_smooth_kinked_and_flat_functions() {
        let at = |value: f64, slope: f64| Dual { value, slope };
        assert_abs_diff_eq!(newton(|x| at(x * x * x - 2.0, 3.0 * x * x), 0.0, 9.0), 2f64.cbrt(), epsilon = 1e-15);
        let kinked = |x: f64| if x < 1.0 { at(1e-3 * (x - 1.0) - 1.0, 1e-3) } else { at(1e6 * (x - 1.0) - 1.0, 1e6) };
        assert_abs_diff_eq!(newton(kinked, -50.0, 50.0), 1.0 + 1e-6, epsilon = 1e-15);
        assert_abs_diff_eq!(newton(|x| at((x - 0.3).signum(), 0.0), 0.0, 1.0), 0.3, epsilon = 1e-15);
        assert_eq!(newton(|x| at(x, 1.0), 0.0, 0.0), 0.0);
    }

    #[test]
    fn rising_functions_are_followed_from_afar() {
        let found = |f: fn(f64) -> f64, slope: f64| rising(f, 0.0, slope, 1e-12);
        assert_abs_diff_eq!(found(|x| x * x * x - 2.0, 1e-3), 2f64.cbrt(), epsilon = 1e-12);
        assert_abs_diff_eq!(found(|x| 5.0 * x + 3.0, 5.0), -0.6, epsilon = 1e-12);
        assert_abs_diff_eq!(found(|x| x.atan() - 1.5, 1.0), 1.5f64.tan(), epsilon = 1e-9);
        // A step, which no value of f meets, and a fall before the zero.
        assert_abs_diff_eq!(found(|x| (x - 0.3).signum(), 1.0), 0.3, epsilon = 1e-15);
        let wavy = |x: f64| x - 2.0 + (5.0 * x).sin();
        assert_abs_diff_eq!(wavy(found(wavy, 1.0)), 0.0, epsilon = 1e-12);
        assert_eq!(found(|x| x, 1.0), 0.0);
        assert!(!found(|_| f64::NAN, 1.0).is_normal());
    }

    #[test]
    fn bisection_finds_the_first_number_that_is_not_below() {
        assert_eq!(bisect(|t| t - 0.1, 0.0, 1e6), 0.1);
        assert_eq!(bisect(|t| t - 1e-300, 0.0, 1.0), 1e-300);
        assert_eq!(bisect(|t| t + 1e-300, -1.0, 1e9), -1e-300);
    }

    #[test]
    fn small_zeros_take_few_rounds() {
        for zero in [1e-300, 5e-324, -1e-300, 1e-9, 1e300] {
            let rounds = std::cell::Cell::new(0);
            let count = |x: f64| {
                rounds.set(rounds.get() + 1);
                if x < zero { -1.0 } else { 1.0 }
            };
            assert_eq!(bisect(count, -1.0, 1.7e308), zero);
            assert!(rounds.get() <= 130, "{zero:e}: {} rounds", rounds.get());
            rounds.set(0);
            let found = newton(|x| Dual { value: count(x), slope: 0.0 }, -1.0, 1.7e308);
            // It ends with a step below the last digit, which may leave a few of them.
            assert!((found - zero).abs() <= 4.0 * f64::EPSILON * zero.abs(), "{zero:e}: {found:e}");
            assert!(rounds.get() <= 130, "{zero:e}: {} rounds", rounds.get());
        }
    }

    #[test]
    fn crossings_in_both_directions() {
        assert_eq!(crossing(|t| 1.0 - t, 0.25, 0.0, 2.0), Some(0.75));
        assert_eq!(crossing(|t| t - 1.0, -0.25, 0.0, 2.0), Some(0.75));
        assert_eq!(crossing(|t| t, 3.0, 0.0, 2.0), None);
        assert_eq!(crossing(|_| f64::NAN, 3.0, 0.0, 2.0), None);
    }

    /// (t - 1)(t - 2)(t - 3): negative up to 1, between 2 and 3 again.
    #[test]
    fn the_first_of_several_zeros_is_found() {
        let c = [11.0, -6.0, 1.0];
        let f = |t: f64| (t - 1.0) * (t - 2.0) * (t - 3.0);
        for end in [1.5, 2.5, 10.0, 1e6] {
            assert_eq!(first_rise(f, c, end), Some(1.0), "{end}");
        }
        assert_eq!(first_rise(f, c, 0.9), None);
        // -(t + 1/2) (t - 1/2) (t - 3/2) is positive between 1/2 and 3/2 only.
        let bump = |t: f64| -(t + 0.5) * (t - 0.5) * (t - 1.5);
        assert_eq!(first_rise(bump, [0.25, 1.5, -1.0], 3.0), Some(0.5));
    }

    #[test]
    fn parabolas_straight_lines_and_constants_are_cubics_too() {
        assert_eq!(first_rise(|t| 1.0 - (t - 3.0) * (t - 3.0), [6.0, -1.0, 0.0], 10.0), Some(2.0));
        assert_eq!(first_rise(|t| t - 0.5, [1.0, 0.0, 0.0], 10.0), Some(0.5));
        assert_eq!(first_rise(|_| -1.0, [0.0; 3], 10.0), None);
        assert_eq!(first_rise(|_| 0.0, [0.0; 3], 10.0), Some(0.0));
        assert_eq!(first_rise(|_| f64::NAN, [f64::NAN; 3], 10.0), None);
    }
}
