//! Exact motion of a mass on a spring and a damper under a force that moves linearly.

use crate::model::ramp::phi;
use crate::number::elementary::{cos, exp, sin};

/// Position and velocity after a time, from acceleration and jerk at its beginning and w^2, without a damper:
///
/// ```text
/// x(t) = x + x' t + a t^2 c_2(u) + j t^3 c_3(u),   u = w^2 t^2
/// ```
pub(super) fn undamped([x, v]: [f64; 2], [a, j]: [f64; 2], square: f64, t: f64) -> [f64; 2] {
    let [c_1, c_2, c_3] = stumpff(square * t * t);
    [x + t * (v + t * (a * c_2 + t * j * c_3)), v + t * (a * c_1 + t * j * c_2)]
}

/// Displacement and velocity after a time, from the velocity at its beginning, with a damper of the decay rate d, under
/// the force F + F' t per mass, which includes that of the spring at the beginning:
///
/// ```text
/// y'' + 2 d y' + w^2 y = F + F' t,   y(0) = 0
/// y(t) = y'(0) S + F S_1 + F' S_2
/// ```
///
/// S is the response to a unit velocity; S_1 and S_2 are its first and second integral.
pub(super) fn damped(velocity: f64, [force, rate]: [f64; 2], [decay, square]: [f64; 2], t: f64) -> [f64; 2] {
    let [slope, s, s_1, s_2] = response(decay, square, t);
    [velocity * s + (force * s_1 + rate * s_2), velocity * slope + (force * s + rate * s_1)]
}

/// Stumpff's functions of u >= -1, with w = sqrt(u):
/// `c_1 = sin w / w`, `c_2 = (1 - cos w) / w^2`, `c_3 = (w - sin w) / w^3`.
fn stumpff(u: f64) -> [f64; 3] {
    if u > 1.0 {
        let w = u.sqrt();
        return [sin(w) / w, (1.0 - cos(w)) / u, (w - sin(w)) / (u * w)];
    }
    // Horner's form of the power series sum (-u)^n / (2 n + k)!; ten terms leave less than 1 / 21!.
    let series = |k: u32| {
        (1..=10).rev().fold(1.0, |sum, n| {
            let i = f64::from(2 * n + k);
            1.0 - u * sum / (i * (i - 1.0))
        })
    };
    [series(1), series(2) / 2.0, series(3) / 6.0]
}

/// 2 d t + w^2 t^2 up to which the power series is used.
const SHORT: f64 = 4.0;

/// Part of its decay time after which a slow exponential has decayed enough for the integrals to be differences.
const DECAYED: f64 = 0.5;

/// S', S and its first two integrals after a time.
fn response(decay: f64, square: f64, t: f64) -> [f64; 4] {
    if 2.0 * decay * t + square * t * t <= SHORT {
        return series(2.0 * decay * t, square * t * t, t);
    }
    let discriminant = decay * decay - square;
    let u = -discriminant * t * t;
    let [s, slope] = if u < -1.0 {
        let root = discriminant.sqrt();
        let (slow, fast) = (-square / (decay + root), -(decay + root));
        if -slow * t < DECAYED {
            return creeping(slow, fast, t);
        }
        let [late, early] = [exp(slow * t), exp(fast * t)];
        [(late - early) / (slow - fast), (slow * late - fast * early) / (slow - fast)]
    } else {
        let [c_1, c_2, _] = stumpff(u);
        let fade = exp(-decay * t);
        [t * fade * c_1, fade * (1.0 - u * c_2 - decay * t * c_1)]
    };
    // Integrals of S'' + 2 d S' + w^2 S = 0. Here w t is at least 1, or the motion has decayed, so that they lose no
    // digits.
    let s_1 = (1.0 - slope - 2.0 * decay * s) / square;
    [slope, s, s_1, (t - s - 2.0 * decay * s_1) / square]
}

/// The power series, with p = 2 d t and q = w^2 t^2.
fn series(p: f64, q: f64, t: f64) -> [f64; 4] {
    // 4^32 / 32! < 1e-16 of the first term.
    const TERMS: u32 = 32;
    let (mut before, mut term) = (0.0, 1.0);
    let mut sums = [0.0; 4];
    for n in 1..=TERMS {
        let n = f64::from(n);
        sums[0] += n * term;
        sums[1] += term;
        sums[2] += term / (n + 1.0);
        sums[3] += term / ((n + 1.0) * (n + 2.0));
        (before, term) = (term, -(p * term + q * before / n) / (n + 1.0));
    }
    [sums[0], t * sums[1], t * t * sums[2], t * t * t * sums[3]]
}

/// Two real exponentials, well apart: divided differences of e^(r t) and of its integrals.
fn creeping(slow: f64, fast: f64, t: f64) -> [f64; 4] {
    let ([a_1, a_2, _], [b_1, b_2, _]) = (phi(slow * t), phi(fast * t));
    let over = |difference: f64| difference / (slow - fast);
    let [late, early] = [exp(slow * t), exp(fast * t)];
    [over(slow * late - fast * early), over(late - early), t * over(a_1 - b_1), t * t * over(a_2 - b_2)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stumpff_functions_satisfy_their_recurrence_on_both_sides_of_the_switch() {
        for u in [0.0, 1e-9, 0.3, 0.999_999, 1.000_001, 7.0, 200.0] {
            let [c_1, c_2, c_3] = stumpff(u);
            let w: f64 = f64::sqrt(u);
            assert!((1.0 - u * c_2 - w.cos()).abs() < 1e-14, "{u}");
            assert!((1.0 - u * c_3 - c_1).abs() < 1e-14, "{u}");
            assert!((w * c_1 - w.sin()).abs() < 1e-14, "{u}");
        }
    }

    /// Without a damper both ways are the same; with a damper alone, S is (1 - e^(-2 d t)) / 2 d.
    #[test]
    fn limits_of_the_damped_motion() {
        for t in [1e-9, 1e-3, 0.7, 1.9, 2.1, 30.0] {
            let one = undamped([0.0, -0.2], [0.3, 0.4], 1.0, t);
            let other = damped(-0.2, [0.3, 0.4 - 0.2], [0.0, 1.0], t);
            assert!((one[0] - other[0]).abs() < 1e-14 * (1.0 + t) && (one[1] - other[1]).abs() < 1e-14, "{t}");
            let [slope, s, s_1, _] = response(0.5, 0.0, t);
            assert!((s / -(-t).exp_m1() - 1.0).abs() < 4e-15 && (slope - (-t).exp()).abs() < 4e-15, "{t}");
            assert!((s_1 - (t - s)).abs() < 2e-15 * t, "{t}");
        }
    }

    /// In the end a spring carries any force that moves linearly, later by the damper: y = F / w^2 + F' (t - 2 d / w^2).
    #[test]
    fn each_kind_of_damping_ends_at_rest() {
        for decay in [0.02, 0.5, 0.999_999, 1.0, 1.000_001, 1.5, 40.0] {
            let long = 40.0 * (decay + 1.0 / decay);
            let [y, velocity] = damped(7.0, [18.0, 9.0], [3.0 * decay, 9.0], long);
            let lag = 2.0 * 3.0 * decay / 9.0;
            assert!((y - (2.0 + long - lag)).abs() < 1e-13 * long && (velocity - 1.0).abs() < 1e-13, "{decay}");
        }
    }

    /// Two steps of any lengths are one, also if they are computed by different formulas.
    #[test]
    fn two_steps_are_one() {
        for decay in [0.0, 0.1, 0.99, 1.0, 1.01, 3.0, 1e3] {
            for (first, second) in [(0.1, 1.5), (1.5, 0.1), (1.9, 0.9), (1e-3, 5.0), (7.0, 11.0)] {
                let after = |t: f64, [y, velocity]: [f64; 2], begin: f64| {
                    let [shift, velocity] = damped(velocity, [0.4 + 0.3 * begin - y, 0.3], [decay, 1.0], t);
                    [y + shift, velocity]
                };
                let once = after(first + second, [0.5, -0.2], 0.0);
                let twice = after(second, after(first, [0.5, -0.2], 0.0), first);
                for (once, twice) in once.into_iter().zip(twice) {
                    assert!((twice - once).abs() < 4e-15 * (1.0 + once.abs()), "{decay} {first}: {twice:?} {once:?}");
                }
            }
        }
    }
}
