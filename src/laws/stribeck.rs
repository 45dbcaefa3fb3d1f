//! Steady friction levels that depend on the sliding speed.

use crate::number::{Real, choose};

/// The Stribeck function: the friction level falls from `breakaway` at rest to `coulomb` at speeds well above the
/// Stribeck velocity.
///
/// ```text
/// S(v) = f_C + (f_s - f_C) exp(-(|v| / v_S)^delta)
/// ```
///
/// Bo and Pavelescu (1982), doi:10.1016/0043-1648(82)90274-8, in the normalised form of Armstrong-Helouvry (1991).
#[inline(always)]
pub fn level<T: Real>(velocity: T, coulomb: T, breakaway: T, stribeck_velocity: T, exponent: T) -> T {
    let u = velocity.abs() / stribeck_velocity;
    // The exponent of nearly every published parameter set; a product is several times faster than a power.
    let power = choose!(exponent.is(2.0), u * u, u.powf(exponent));
    coulomb + (breakaway - coulomb) * (-power).exp()
}

/// A level that falls as a Lorentzian: halfway at the Stribeck velocity.
///
/// ```text
/// S(v) = f_C + (f_s - f_C) / (1 + (v / v_S)^2)
/// ```
///
/// Hess and Soom (1990), Journal of Tribology 112, 147-152.
#[inline(always)]
pub fn lorentzian<T: Real>(velocity: T, coulomb: T, breakaway: T, stribeck_velocity: T) -> T {
    let u = velocity / stribeck_velocity;
    coulomb + (breakaway - coulomb) / (T::from(1.0) + u * u)
}

/// A level that falls as a hyperbola: halfway at the Stribeck velocity.
///
/// ```text
/// S(v) = f_C + (f_s - f_C) / (1 + |v| / v_S)
/// ```
///
/// Popp and Stelter (1990).
#[inline(always)]
pub fn hyperbolic<T: Real>(velocity: T, coulomb: T, breakaway: T, stribeck_velocity: T) -> T {
    coulomb + (breakaway - coulomb) / (T::from(1.0) + velocity.abs() / stribeck_velocity)
}

/// Speed at which the sum of two excesses that fall with different speeds turns from convex to concave again; 0 if it
/// does not. Each of them alone is first concave and then convex, or convex everywhere.
///
/// With s = |v|^delta and p_i = v_i^-delta the curvature has the sign of
///
/// ```text
/// C(s) = sum e_i p_i exp(-p_i s) (delta p_i s - (delta - 1))
/// ```
///
/// Between the inflections s_1 < s_2 of the parts their curvatures differ in sign, and the logarithm of their ratio
/// has the slope (s_2 - s_1) / ((s - s_1) (s_2 - s)) - (p_1 - p_2): the ratio falls between the zeros of that, if at all.
pub fn turning_again(parts: [[f64; 2]; 2], exponent: f64) -> f64 {
    let rates = parts.map(|[_, speed]| Real::powf(speed, -exponent));
    let [fast, slow] = if rates[0] > rates[1] { [0, 1] } else { [1, 0] };
    let [p, q] = [fast, slow].map(|part| rates[part]);
    let inflection = |rate: f64| (exponent - 1.0) / (exponent * rate);
    let [first, last] = [inflection(p), inflection(q)];
    let width = (last - first) * (last - first) - 4.0 * (exponent - 1.0) / (exponent * p * q);
    if !(exponent > 1.0 && width > 0.0 && parts.iter().all(|[excess, _]| *excess > 0.0)) {
        return 0.0;
    }
    let curvature = |s: f64| -> f64 {
        let of = |part: usize| {
            let rate = rates[part];
            parts[part][0] * rate * Real::exp(-rate * s) * (exponent * rate * s - (exponent - 1.0))
        };
        of(fast) + of(slow)
    };
    let half = 0.5 * width.sqrt();
    let [mut low, mut high] = [-half, half].map(|side| 0.5 * (first + last) + side);
    if !(curvature(low) > 0.0 && curvature(high) < 0.0) {
        return 0.0;
    }
    while high - low > 1e-12 * high {
        let middle = 0.5 * (low + high);
        if curvature(middle) > 0.0 { low = middle } else { high = middle }
    }
    Real::powf(low, 1.0 / exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Signs of the curvature by differences on a fine grid.
    #[test]
    fn two_humps_turn_again_where_their_differences_do() {
        for (parts, exponent, expected) in [
            ([[3.0, 0.5], [5.0, 0.02]], 2.0, true),
            ([[5.0, 0.02], [3.0, 0.5]], 2.0, true),
            ([[3.0, 0.5], [5.0, 0.005]], 1.5, true),
            ([[3.0, 0.5], [5.0, 0.4]], 2.0, false),
            ([[3.0, 0.5], [5.0, 0.02]], 1.0, false),
            ([[3.0, 0.5], [0.0, 0.02]], 2.0, false),
        ] {
            let value =
                |v: f64| -> f64 { parts.map(|[excess, speed]| level(v, 0.0, excess, speed, exponent)).iter().sum() };
            let curvature = |v: f64| value(1.001 * v) - 2.0 * value(v) + value(0.999 * v);
            let grid: Vec<f64> = (0..2000).map(|k| 1e-3 * 10f64.powf(f64::from(k) / 600.0)).collect();
            let again = grid.windows(2).find(|v| curvature(v[0]) > 1e-12 && curvature(v[1]) < -1e-12);
            let found = turning_again(parts, exponent);
            assert_eq!(again.is_some(), expected, "{parts:?}");
            assert_eq!(found > 0.0, expected, "{parts:?}: {found}");
            if let Some(v) = again {
                assert!((0.99 * v[0]..1.01 * v[1]).contains(&found), "{parts:?}: {found} in {v:?}");
            }
        }
    }

    #[test]
    fn falls_by_one_e_th_at_the_stribeck_velocity_for_every_exponent() {
        for exponent in [0.5, 1.0, 2.0, 3.7] {
            let level = level(-0.001, 0.981, 1.4715, 0.001, exponent);
            assert!((level - 1.161_444_866).abs() < 1e-9, "{exponent}: {level}");
        }
    }

    #[test]
    fn rational_levels_are_half_way_at_the_stribeck_velocity() {
        assert_eq!(lorentzian(-0.25, 1.0, 1.5, 0.25), 1.25);
        assert_eq!(hyperbolic(-0.25, 1.0, 1.5, 0.25), 1.25);
        assert_eq!((lorentzian(0.0, 1.0, 1.5, 0.25), hyperbolic(0.0, 1.0, 1.5, 0.25)), (1.5, 1.5));
    }

    #[test]
    fn is_the_static_level_at_rest() {
        assert_eq!(level(0.0, 1.0, 1.5, 0.001, 2.0), 1.5);
        assert_eq!(level(0.0, 1.0, 1.5, 0.001, 0.5), 1.5);
    }
}
