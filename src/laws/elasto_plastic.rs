//! The transition from elastic to plastic deflection of Dupont's law.

use crate::number::{Mask, Real};

/// alpha of Dupont et al. (2002), (7.33) and (7.34) of the thesis: the plastic part of a motion that loads the bristle.
///
/// ```text
/// alpha = 0                                                                          |z| <= z_ba
///       = 1/2 + 1/2 sin(pi (|z| - (z_ss + z_ba) / 2) / (z_ss - z_ba))         z_ba < |z| <  z_ss
///       = 1                                                                   z_ss <= |z|
/// ```
///
/// `deflection` is |z|: the thesis and the paper print z, which is only correct for z > 0.
pub fn alpha<T: Real>(deflection: T, steady: T, breakaway: T) -> T {
    let [half, one] = [0.5, 1.0].map(T::from);
    let rising = || {
        let angle = T::from(std::f64::consts::PI) * (deflection - half * (steady + breakaway)) / (steady - breakaway);
        half + half * angle.sin()
    };
    let beyond = || deflection.below(steady).choose(rising, || one);
    deflection.at_most(breakaway).choose(|| T::zero(), beyond)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rises_from_nothing_to_all() {
        for (deflection, part) in [(0.0, 0.0), (0.7, 0.0), (0.775, 0.146_446_609), (0.85, 0.5), (1.0, 1.0), (3.0, 1.0)]
        {
            assert!((alpha(deflection, 1.0, 0.7) - part).abs() < 1e-9, "{deflection}");
        }
    }
}
