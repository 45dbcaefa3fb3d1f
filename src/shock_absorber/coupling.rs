//! The largest communication step at which a mass carried by a spring-damper stays stable.

use crate::contact::ExchangeOrder;
use crate::number::elementary::{hypot, square};

/// Value that stands for "no limit" (chosen), so that the output is finite.
const NO_LIMIT: f64 = 1.0;

/// Largest step h for a mass m on a stiffness k and a damping c, if the force is held over each step.
///
/// `bristles` is the part of the stiffness whose deflection is the integral of the velocity. If the velocity is held,
/// too, the deflection lags, and such a stiffness counts twice (*sequential*) or 4/3 (*parallel*).
///
/// *Sequential* (the force belongs to the beginning of the step): the map of one step has the determinant `1 - c h / m
/// + k h^2 / 2 m` and the trace `2 - c h / m - k h^2 / 2 m`; by Jury's criterion h < 2 m / c and h < 2 c / k.
///
/// *Parallel* (it is one step older): Jury's criterion gives a cubic, whose smallest root is close to
/// `1 / (c / m + 3 k / 2 c)`: exact for k = 0 and for m k >> c^2, low by a fifth at most in between.
pub(crate) fn step_limit(stiffness: f64, bristles: f64, damping: f64, mass: f64, exchange: ExchangeOrder) -> f64 {
    let (k, c) = ((stiffness + weight(exchange) * bristles).max(0.0), damping.abs());
    if k == 0.0 && c == 0.0 {
        return NO_LIMIT;
    }
    let limit = match exchange {
        ExchangeOrder::Sequential => (2.0 * mass / c).min(if k > 0.0 { 2.0 * c / k } else { f64::INFINITY }),
        ExchangeOrder::Parallel if c == 0.0 => 0.0,
        ExchangeOrder::Parallel => 1.0 / (c / mass + 1.5 * k / c),
    };
    limit.min(NO_LIMIT)
}

/// Weight of a stiffness whose deflection lags.
fn weight(exchange: ExchangeOrder) -> f64 {
    if exchange == ExchangeOrder::Parallel { 4.0 / 3.0 } else { 2.0 }
}

/// A damper that acts through a stiffness in series.
pub(crate) struct Series {
    /// Slope of the damper's characteristic.
    pub damping: f64,
    /// Stiffness in series with it.
    pub stiffness: f64,
    /// Whether its velocity is held over the step, so that it acts one step late.
    pub is_late: bool,
}

/// As [`step_limit`], with a damper behind a series stiffness in parallel.
///
/// At the circular frequency w of the mass, m w^2 = k + k_s u / (1 + u) with u = (w c_s / k_s)^2, such an element is a
/// damping c_s / (1 + u) and a stiffness k_s u / (1 + u). At the limit of the step it is no stronger damper than (m
/// k_s)^(1/2), because its stiffness takes over the motion. The reciprocals of the limits by damping and by stiffness
/// are added. `damping` is negative where friction weakens with the speed: the rest of the damper then has to stabilise
/// the stiffness. Against the largest modulus of the exact map of a step, for dampers of 200 to 6000 N.s/m on 1e4 to
/// 1e9 N/m at 16.36 kg, the sum is 0.35 to 1.12 of the true limit; a margin keeps the advice below it.
pub(crate) fn step_limit_in_series(
    stiffness: f64,
    bristles: f64,
    damping: f64,
    series: &Series,
    mass: f64,
    exchange: ExchangeOrder,
) -> f64 {
    if series.damping <= 0.0 {
        return step_limit(stiffness, bristles, damping, mass, exchange);
    }
    let stiffness = stiffness.max(0.0);
    let u = softness(stiffness + bristles, series, mass);
    let sprung = series.stiffness * (1.0 - 1.0 / (1.0 + u));
    let (free, late) = if series.is_late { (0.0, sprung) } else { (sprung, 0.0) };
    let k = stiffness + free + weight(exchange) * (bristles + late);
    let c = damping + series.damping / (1.0 + u);
    let fast = (series.damping / mass).min((series.stiffness / mass).sqrt());
    let (by_damping, by_series, by_stiffness) = match exchange {
        ExchangeOrder::Sequential => (0.5, if series.is_late { 1.0 } else { 0.5 }, 0.5),
        // A damper that is two steps late: a^2 + a < 1.
        ExchangeOrder::Parallel => (1.0, if series.is_late { 1.62 } else { 1.0 }, 1.5),
    };
    if c <= 0.0 {
        return 0.0;
    }
    let hardness = if k > 0.0 { by_stiffness * k / c } else { 0.0 };
    (MARGIN / (by_damping * damping.abs() / mass + by_series * fast + hardness)).min(NO_LIMIT)
}

/// Keeps the estimate with a series stiffness below the true limit.
const MARGIN: f64 = 0.85;

/// The root u >= 0 of p u^2 + (p - k - k_s) u - k = 0 with p = m (k_s / c_s)^2.
fn softness(k: f64, series: &Series, mass: f64) -> f64 {
    let p = mass * square(series.stiffness / series.damping);
    let b = p - k - series.stiffness;
    let root = hypot(b, 2.0 * (p * k).sqrt());
    // Avoids the difference of nearly equal numbers.
    if b > 0.0 { 2.0 * k / (b + root) } else { (root - b) / (2.0 * p) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether the motion of a mass on a spring, a damper and a damper in series grows. The force is held over each
    /// step; the element in series moves exactly at a held velocity or at one that changes linearly to its value at the
    /// end.
    fn grows_in_series(k: f64, c: f64, series: &Series, exchange: ExchangeOrder, h: f64) -> bool {
        const MASS: f64 = 16.36;
        let (mut x, mut v, mut f, mut old) = (1e-3, 1e-3, 0.0, 0.0);
        let relaxation = h * series.stiffness / series.damping;
        let kept = (-relaxation).exp();
        let end = if series.is_late { 0.0 } else { 1.0 - (1.0 - kept) / relaxation };
        for _ in 0..20_000 {
            let now = -k * x - c * v - f;
            let force = if exchange == ExchangeOrder::Parallel { old } else { now };
            old = now;
            x += h * (v + h * force / (2.0 * MASS));
            let next = v + h * force / MASS;
            f = kept * f + series.damping * ((1.0 - kept - end) * v + end * next);
            v = next;
            if v.abs() > 1e3 {
                return true;
            }
        }
        v.abs() > 1.0
    }

    #[test]
    fn limit_with_a_series_stiffness_is_below_and_near_the_true_one() {
        for (k, c, damping) in [
            (0.0, 0.0, 1500.0),
            (4.5e4, 0.0, 1500.0),
            (4.5e4, 316.0, 1500.0),
            (1e5, 316.0, 6000.0),
            (4.5e4, -100.0, 3000.0),
            (0.0, -400.0, 3000.0),
        ] {
            for stiffness in [1e5, 1e6, 1e7, 1e9] {
                for (exchange, is_late) in [
                    (ExchangeOrder::Sequential, false),
                    (ExchangeOrder::Sequential, true),
                    (ExchangeOrder::Parallel, false),
                    (ExchangeOrder::Parallel, true),
                ] {
                    let series = Series { damping, stiffness, is_late };
                    let limit = step_limit_in_series(k, 0.0, c, &series, 16.36, exchange);
                    let grows = |part: f64| grows_in_series(k, c, &series, exchange, part * limit);
                    let case = format!("{k} {c} {damping} {stiffness} {exchange:?} {is_late} {limit}");
                    assert!(!grows(1.0) && !grows(0.5), "{case}");
                    assert!(grows(1.0 / 0.3), "{case}");
                }
            }
        }
    }

    /// Whether the motion of a mass under a held force grows from a small displacement and velocity.
    fn grows(k: f64, c: f64, m: f64, exchange: ExchangeOrder, h: f64) -> bool {
        let (mut x, mut v, mut old) = (1e-3, 1e-3, 0.0);
        for _ in 0..20_000 {
            let now = -k * x - c * v;
            let force = if exchange == ExchangeOrder::Parallel { old } else { now };
            old = now;
            x += h * (v + h * force / (2.0 * m));
            v += h * force / m;
            if v.abs() > 1e3 {
                return true;
            }
        }
        v.abs() > 1.0
    }

    #[test]
    fn limit_separates_stable_from_unstable_steps() {
        for (k, c) in [(0.0, 1500.0), (4.5e4, 1500.0), (4.5e4, 5000.0), (1e5, 316.0), (1e5, 1816.0), (1.045e6, 1500.0)]
        {
            for exchange in [ExchangeOrder::Sequential, ExchangeOrder::Parallel] {
                let limit = step_limit(k, 0.0, c, 16.36, exchange);
                assert!(!grows(k, c, 16.36, exchange, 0.97 * limit), "{k} {c} {exchange:?} {limit}");
                assert!(grows(k, c, 16.36, exchange, 1.3 * limit), "{k} {c} {exchange:?} {limit}");
            }
        }
    }

    #[test]
    fn advice_is_always_finite() {
        for exchange in [ExchangeOrder::Sequential, ExchangeOrder::Parallel] {
            assert_eq!(step_limit(0.0, 0.0, 0.0, 1.0, exchange), 1.0);
            assert_eq!(step_limit(1e5, 0.0, 0.0, 1.0, exchange), 0.0);
            assert_eq!(step_limit(-5.0, 0.0, 1e-9, 1.0, exchange), 1.0);
            for (damping, stiffness) in [(1e-300, 1e300), (1e300, 1e-300), (0.0, 1e5), (1e3, 1e3)] {
                for k in [-5.0, 0.0, 1e300] {
                    let series = Series { damping, stiffness, is_late: true };
                    let limit = step_limit_in_series(k, 0.0, 0.0, &series, 1.0, exchange);
                    assert!((0.0..=1.0).contains(&limit), "{k} {damping} {stiffness} {exchange:?}: {limit}");
                }
            }
        }
    }
}
