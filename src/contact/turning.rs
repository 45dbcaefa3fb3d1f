//! A direction that turns towards another one, which may itself turn.

use crate::number::elementary::{self, atan2, exp_m1, ln_1p};

/// Change of the angle from a follower to its leader.
#[derive(Clone, Copy, Debug)]
pub struct Turn {
    /// Sine of the angle at the end.
    pub sin: f64,
    /// Its cosine.
    pub cos: f64,
    /// Integral of cos(phi) over the distance.
    pub along: f64,
    /// Integral of sin(phi)^2 over the distance.
    pub across: f64,
}

/// A distance below this is short enough for Simpson's rule (chosen).
const SHORT: f64 = 1e-5;

/// Follows `d(phi)/d(q) = w / Q - sin(phi)` from the angle with that sine and cosine over the distance Q, while the
/// leader turns by the angle w at constant speed. Exact: t = tan(phi / 2) obeys a Riccati equation with constant
/// coefficients, so that t = a / b with
///
/// ```text
/// da/dq = (-a + (w / Q) b) / 2
/// db/dq = (-(w / Q) a + b) / 2,   integral of cos(phi) dq = ln((a^2 + b^2) at the end / at the start)
/// ```
pub fn follow(sin: f64, cos: f64, distance: f64, w: f64) -> Turn {
    // Sine and cosine of half the angle; the larger one first, so that no digits are lost.
    let (a, b) = if cos >= 0.0 {
        let b = (0.5 * (1.0 + cos)).sqrt();
        (0.5 * sin / b, b)
    } else {
        let a = (0.5 * (1.0 - cos)).sqrt().copysign(sin);
        (a, 0.5 * sin / a)
    };
    let (even, odd, growth) = parts(0.25 * (distance - w) * (distance + w));
    // Changes rather than values, so that a short distance keeps its digits.
    let change = (even * a + 0.5 * odd * (w * b - distance * a), even * b + 0.5 * odd * (distance * b - w * a));
    let end = (a + change.0, b + change.1);
    let square = end.0 * end.0 + end.1 * end.1;
    let gain = (change.0 * (a + end.0) + change.1 * (b + end.1)) / (a * a + b * b);
    let (sin_end, cos_end) = (2.0 * end.0 * end.1 / square, (end.1 - end.0) * (end.1 + end.0) / square);
    let turned = || atan2(sin_end * cos - cos_end * sin, cos_end * cos + sin_end * sin);
    let across = if w == 0.0 {
        cos_end - cos
    } else if distance < SHORT {
        let half = 0.5 * turned();
        let middle = sin * elementary::cos(half) + cos * elementary::sin(half);
        distance / 6.0 * (sin * sin + 4.0 * middle * middle + sin_end * sin_end)
    } else {
        w / distance * (w - turned()) + cos_end - cos
    };
    Turn { sin: sin_end, cos: cos_end, along: 2.0 * growth + ln_1p(gain), across }
}

/// cosh(x) / exp(growth) - 1, sinh(x) / x / exp(growth), and growth, for x^2 = `square`, which may be negative.
fn parts(square: f64) -> (f64, f64, f64) {
    let x = square.abs().sqrt();
    if x == 0.0 {
        (0.0, 1.0, 0.0)
    } else if square > 0.0 {
        let fall = -exp_m1(-2.0 * x);
        (-0.5 * fall, 0.5 * fall / x, x)
    } else {
        (-2.0 * elementary::square(elementary::sin(0.5 * x)), elementary::sin(x) / x, 0.0)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    /// The classical Runge-Kutta method with small steps, for slow and fast leaders, ahead, aside and behind.
    #[test]
    fn agrees_with_small_steps() {
        for (start, distance, w) in [
            (0.7, 1.3, 0.0),
            (-1.2, 0.4, 0.9),
            (1.4, 6.0, -1.1),
            (0.0, 0.3, 2.0),
            (2.9, 2.0, 0.3),
            (-2.0, 1e-4, -0.8),
            (-2.0, 1e-6, -0.3),
            (0.4, 1.0, 1.0),
            (0.0, 3.0, 0.0),
        ] {
            let n = 20_000;
            let h = distance / f64::from(n);
            let rate = |phi: f64| w / distance - phi.sin();
            let (mut phi, mut along, mut across) = (start, 0.0, 0.0);
            for _ in 0..n {
                let before = phi;
                let a = rate(phi);
                let b = rate(phi + 0.5 * h * a);
                let c = rate(phi + 0.5 * h * b);
                let d = rate(phi + h * c);
                let middle = phi + 0.25 * h * (a + b);
                phi += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
                along += h / 6.0 * (before.cos() + 4.0 * middle.cos() + phi.cos());
                across += h / 6.0 * (before.sin().powi(2) + 4.0 * middle.sin().powi(2) + phi.sin().powi(2));
            }
            let turn = follow(f64::sin(start), f64::cos(start), distance, w);
            let what = format!("{start} {distance} {w}: {turn:?}, {phi} {along} {across}");
            assert!((turn.sin - phi.sin()).abs() < 1e-11 && (turn.cos - phi.cos()).abs() < 1e-11, "{what}");
            assert!(
                (turn.along - along).abs() < 1e-10 && (turn.across - across).abs() < 1e-8 * distance.max(1.0),
                "{what}"
            );
        }
    }

    /// Long slides end on the leader, behind it by its rate of turning.
    #[test]
    fn a_long_slide_lags_by_what_the_leader_turns() {
        for w in [0.0, 0.5, -0.5] {
            let turn = follow(0.9, f64::sqrt(0.19), 1e6, w);
            assert!((turn.sin - w / 1e6).abs() < 1e-15, "{turn:?}");
            assert_abs_diff_eq!(turn.along / 1e6, 1.0, epsilon = 1e-5);
        }
    }
}
