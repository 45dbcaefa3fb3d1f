//! Integrals that have no closed form.

use crate::numerics::root::crossing;

/// Difference of the two rules in a piece, relative to the whole integral, above which the piece is halved (chosen).
/// The error of the better rule is far smaller: in the tests below 1e-13 for smooth functions, 1e-11 with a cusp.
const TOLERANCE: f64 = 1e-10;

/// This number of halvings per integral (chosen) resolves a cusp to 1e-12 of the interval several times over. The limit
/// is for integrands that are rough everywhere, because their argument has lost its digits.
const HALVINGS: u32 = 200;

/// Positive nodes of Kronrod's rule with 15 points; every second one, and 0, belongs to the Gauss rule with 7 points.
/// A. S. Kronrod, "Nodes and weights of quadrature formulas" (1965).
const NODES: [f64; 7] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_4,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_47,
];
/// Kronrod's weights of these nodes, and of 0.
const KRONROD: ([f64; 7], f64) = (
    [
        0.022_935_322_010_529_224,
        0.063_092_092_629_978_55,
        0.104_790_010_322_250_18,
        0.140_653_259_715_525_92,
        0.169_004_726_639_267_9,
        0.190_350_578_064_785_4,
        0.204_432_940_075_298_9,
    ],
    0.209_482_141_084_727_82,
);
/// Gauss' weights of the nodes 1, 3 and 5, and of 0.
const GAUSS: ([f64; 3], f64) =
    ([0.129_484_966_168_869_7, 0.279_705_391_489_276_64, 0.381_830_050_505_118_9], 0.417_959_183_673_469_4);

/// The integral of a function that is smooth and does not change sign between `from` and `to`.
pub fn integral(f: &impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let (value, error) = both_rules(f, from, to);
    let allowed = (TOLERANCE * value.abs()).max(f64::MIN_POSITIVE);
    // NaN and infinity are final.
    if error <= allowed || !value.is_finite() {
        return value;
    }
    halves(f, from, to, allowed, &mut { HALVINGS })
}

/// The integral as the sum over the halves of the interval, each halved again until its error is allowed.
fn halves(f: &impl Fn(f64) -> f64, from: f64, to: f64, allowed: f64, left: &mut u32) -> f64 {
    *left -= 1;
    let middle = from + 0.5 * (to - from);
    let half = |(from, to)| {
        let (value, error) = both_rules(f, from, to);
        if error <= allowed || *left == 0 { value } else { halves(f, from, to, allowed, left) }
    };
    [(from, middle), (middle, to)].map(half).iter().sum()
}

/// Kronrod's value, and its difference from that of Gauss.
fn both_rules(f: &impl Fn(f64) -> f64, from: f64, to: f64) -> (f64, f64) {
    let half = 0.5 * (to - from);
    let centre = from + half;
    let at_centre = f(centre);
    let mut fine = KRONROD.1 * at_centre;
    let mut coarse = GAUSS.1 * at_centre;
    for (k, node) in NODES.into_iter().enumerate() {
        let pair = f(centre - half * node) + f(centre + half * node);
        fine += KRONROD.0[k] * pair;
        if k % 2 == 1 {
            coarse += GAUSS.0[k / 2] * pair;
        }
    }
    (half * fine, (half * (fine - coarse)).abs())
}

/// The integral over time of a power that depends on a quantity w(t), monotonic between `from` and `to`. Where |w|
/// falls below `band` the power has a peak with a kink at w = 0: a long interval could miss it, so it is located.
pub fn integral_past_peak(power: &impl Fn(f64) -> f64, w: &impl Fn(f64) -> f64, band: f64, from: f64, to: f64) -> f64 {
    let mut cuts = [-band, 0.0, band].map(|level| crossing(w, level, from, to).unwrap_or(to));
    cuts.sort_by(f64::total_cmp);
    let mut sum = 0.0;
    let mut begin = from;
    for end in cuts.into_iter().chain([to]).filter(|end| *end <= to) {
        if end > begin {
            sum += integral(power, begin, end);
            begin = end;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rules are exact for polynomials up to degree 22 and 13, and not beyond.
    #[test]
    fn rules_have_their_degrees() {
        for degree in (0..=24).step_by(2) {
            let exact = 2.0 / f64::from(degree + 1);
            let (fine, difference) = both_rules(&|x: f64| x.powi(degree), -1.0, 1.0);
            assert_eq!((fine - exact).abs() < 2e-15, degree <= 22, "{degree}: {fine}");
            assert_eq!(difference < 2e-15, degree <= 12, "{degree}: {difference}");
        }
    }

    #[test]
    fn known_integrals() {
        let agree = |found: f64, exact: f64| assert!((found / exact - 1.0).abs() < 1e-13, "{found} against {exact}");
        agree(integral(&|x: f64| x.exp(), -3.0, 2.0), 2f64.exp() - (-3f64).exp());
        agree(integral(&|x: f64| 1.0 / (1.0 + x * x), 0.0, 1e6), 1e6f64.atan());
        // erf(8) = 1 to 1e-28.
        agree(integral(&|x: f64| (-x * x).exp(), 0.0, 8.0), 0.5 * std::f64::consts::PI.sqrt());
        // A cusp at one end: 2 - 4 / e.
        let cusp = integral(&|x: f64| (-x.sqrt()).exp(), 0.0, 1.0) / (2.0 - 4.0 * (-1f64).exp());
        assert!((cusp - 1.0).abs() < 1e-11, "{cusp}");
    }

    /// A peak of width 1e-6 in an interval of length 3 would be missed by the rule alone.
    #[test]
    fn a_narrow_peak_is_found_on_the_way_up_and_down() {
        let exact = 1e-6 * std::f64::consts::PI.sqrt();
        for (w, at) in [(1.0, 0.7), (-1.0, 0.7)] {
            let w = |t: f64| w * (t - at);
            let power = |t: f64| (-(w(t) / 1e-6).powi(2)).exp();
            let found = integral_past_peak(&power, &w, 6.5e-6, -1.0, 2.0);
            assert!((found / exact - 1.0).abs() < 1e-10, "{found}");
            assert!(integral(&power, -1.0, 2.0) < 0.1 * exact);
        }
    }

    #[test]
    fn what_is_not_finite_comes_back_at_once() {
        assert!(integral(&|_| f64::NAN, 0.0, 1.0).is_nan());
        assert!(integral_past_peak(&|_| f64::INFINITY, &|_| f64::NAN, 1.0, 0.0, 1.0).is_infinite());
    }
}
