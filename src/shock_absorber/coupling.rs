//! The largest communication step at which a mass carried by a spring-damper stays stable.

use crate::friction::Exchange;

/// What stands for "no limit" (chosen), so that the advice is a finite number.
const NO_LIMIT: f64 = 1.0;

/// Largest step h for a mass m on a stiffness k and a damping c, if the force is held over each step.
///
/// `bristles` is the part of the stiffness whose deflection is the integral of the velocity. Where that is held, too, the
/// deflection lags, and such a stiffness counts twice (*sequential*) or 4/3 (*parallel*).
///
/// *Sequential* (the force belongs to the beginning of the step): the map of one step has the determinant
/// `1 - c h / m + k h^2 / 2 m` and the trace `2 - c h / m - k h^2 / 2 m`; by Jury's criterion h < 2 m / c and h < 2 c / k.
///
/// *Parallel* (it is one step older): Jury's criterion gives a cubic, whose smallest root is close to
/// `1 / (c / m + 3 k / 2 c)`: exact for k = 0 and for m k >> c^2, low by a fifth at most in between.
pub(crate) fn step_limit(stiffness: f64, bristles: f64, damping: f64, mass: f64, exchange: Exchange) -> f64 {
    let weight = if exchange == Exchange::Parallel { 4.0 / 3.0 } else { 2.0 };
    let (k, c) = ((stiffness + weight * bristles).max(0.0), damping.abs());
    if k == 0.0 && c == 0.0 {
        return NO_LIMIT;
    }
    let limit = match exchange {
        Exchange::Sequential => (2.0 * mass / c).min(if k > 0.0 { 2.0 * c / k } else { f64::INFINITY }),
        Exchange::Parallel if c == 0.0 => 0.0,
        Exchange::Parallel => 1.0 / (c / mass + 1.5 * k / c),
    };
    limit.min(NO_LIMIT)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Does the motion of a mass whose force is held grow from a small displacement and velocity?
    fn grows(k: f64, c: f64, m: f64, exchange: Exchange, h: f64) -> bool {
        let (mut x, mut v, mut old) = (1e-3, 1e-3, 0.0);
        for _ in 0..20_000 {
            let now = -k * x - c * v;
            let force = if exchange == Exchange::Parallel { old } else { now };
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
            for exchange in [Exchange::Sequential, Exchange::Parallel] {
                let limit = step_limit(k, 0.0, c, 16.36, exchange);
                assert!(!grows(k, c, 16.36, exchange, 0.97 * limit), "{k} {c} {exchange:?} {limit}");
                assert!(grows(k, c, 16.36, exchange, 1.3 * limit), "{k} {c} {exchange:?} {limit}");
            }
        }
    }

    #[test]
    fn advice_is_always_finite() {
        for exchange in [Exchange::Sequential, Exchange::Parallel] {
            assert_eq!(step_limit(0.0, 0.0, 0.0, 1.0, exchange), 1.0);
            assert_eq!(step_limit(1e5, 0.0, 0.0, 1.0, exchange), 0.0);
            assert_eq!(step_limit(-5.0, 0.0, 1e-9, 1.0, exchange), 1.0);
        }
    }
}
