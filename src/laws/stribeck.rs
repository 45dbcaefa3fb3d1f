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

#[cfg(test)]
mod tests {
    use super::*;

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
