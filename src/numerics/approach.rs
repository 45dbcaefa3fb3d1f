//! Exact approach of a force to its level, with any exponent.
//!
//! ```text
//! dr/dq = 1 - sgn(r) |r|^n
//! ```
//!
//! r is the force over the level, q the distance travelled over the distance in which a spring would reach the level.
//! From both sides r moves towards 1 and never gets there. With w = -ln|1 - r| this becomes
//!
//! ```text
//! dq/dw = 1 / h,   h = (1 - sgn(r) |r|^n) / (1 - r)
//! ```
//!
//! where h is smooth and goes to n as r goes to 1: q(w) is an ordinary integral, and w(q) its inverse.

use crate::number::elementary::{cosh, exp, exp_m1, ln, ln_1p, pow, sinh};

/// Result of the motion.
pub struct Travel {
    /// Change of r.
    pub change: f64,
    /// Part of q that was travelled.
    pub distance: f64,
    /// Integral of r over q.
    pub area: f64,
    /// Whether `end` was reached.
    pub arrived: bool,
}

/// From here on 1 - r is less than the spacing of the numbers near 1.
const FULL: f64 = 40.0;

/// Advances r by `q`, at most to `end`, which lies in the direction of the motion.
pub fn advance(r: f64, end: f64, q: f64, exponent: f64) -> Travel {
    if exponent == 1.0 {
        return advance_linear(r, end, q);
    }
    let side = if r < 1.0 { 1.0 } else { -1.0 };
    let position = |r: f64| if side > 0.0 { -ln_1p(-r) } else { -ln(r - 1.0) };
    let start = position(r);
    if start >= FULL {
        return Travel { change: 0.0, distance: q, area: q * r, arrived: false };
    }
    // A distance far below the whole path does not need all its digits.
    let path = Path { start, side, exponent, slack: [1e-15 * q, 1e-15 * q * r.abs().max(1.0)] };
    let last = if (1.0 - end) * side > 0.0 { position(end).min(FULL) } else { FULL };
    let [distance, area] = path.between(start, last);
    if distance > q {
        let (w, area) = path.inverse(q, last);
        return Travel { change: path.change(w), distance: q, area, arrived: false };
    }
    if last < FULL {
        return Travel { change: end - r, distance, area, arrived: true };
    }
    Travel { change: 1.0 - r, distance: q, area: area + (q - distance), arrived: false }
}

/// The exponential of n = 1, where r = 1 - dr/dq.
fn advance_linear(r: f64, end: f64, q: f64) -> Travel {
    let left = (1.0 - end) / (1.0 - r);
    let to_end = if left > 0.0 { -ln(left) } else { f64::INFINITY };
    let (change, distance, arrived) =
        if to_end <= q { (end - r, to_end, true) } else { (-(1.0 - r) * exp_m1(-q), q, false) };
    Travel { change, distance, area: distance - change, arrived }
}

/// A path towards r = 1.
struct Path {
    start: f64,
    /// +1 from below, -1 from above.
    side: f64,
    exponent: f64,
    /// Error allowed in the two integrals.
    slack: [f64; 2],
}

/// Up to this w from r = 0, |r|^n is integrated directly: it is smooth except for its end at r = 0.
const NEAR: f64 = 0.3;

/// How often an interval may be halved; the steepest integrands need about fifteen.
const DEPTH: u32 = 24;

impl Path {
    /// Change of r from the start to w.
    fn change(&self, w: f64) -> f64 {
        -self.side * exp(-self.start) * exp_m1(self.start - w)
    }

    /// r, and dq/dw = 1 / h.
    fn at(&self, w: f64) -> (f64, f64) {
        let gap = exp(-w);
        // Each form keeps the digits of the small quantity: r around 0, 1 - r near 1.
        let r = if self.side > 0.0 { -exp_m1(-w) } else { 1.0 + gap };
        let power = if r <= 0.0 {
            1.0 + pow(-r, self.exponent)
        } else if r < 0.5 {
            1.0 - pow(r, self.exponent)
        } else {
            -self.side * exp_m1(self.exponent * ln_1p(-self.side * gap))
        };
        (r, gap / power)
    }

    /// Integrals of dq and r dq.
    fn between(&self, from: f64, to: f64) -> [f64; 2] {
        if self.side < 0.0 {
            return self.smooth(from, to, DEPTH);
        }
        // |r|^n has a kink at r = 0, where w = 0; on both sides of it an integer power is smooth.
        let kink = f64::clamp(0.0, from, to);
        if self.exponent.fract() == 0.0 {
            return add(self.smooth(from, kink, DEPTH), self.smooth(kink, to, DEPTH));
        }
        let [a, b] = [-NEAR, NEAR].map(|cut| cut.clamp(from, to));
        let outside = add(self.smooth(from, a, DEPTH), self.smooth(b, to, DEPTH));
        add(outside, add(self.near(a, kink), self.near(kink, b)))
    }

    /// Integrals over an interval on one side of the kink and near it.
    fn near(&self, from: f64, to: f64) -> [f64; 2] {
        if from.abs().min(to.abs()) > 0.5 * from.abs().max(to.abs()) {
            return self.smooth(from, to, DEPTH);
        }
        let ([q_a, area_a], [q_b, area_b]) = (self.beyond_kink(from), self.beyond_kink(to));
        [q_b - q_a, area_b - area_a]
    }

    /// Integrals from the kink on, by the tanh-sinh rule of Takahasi and Mori (1974), which tolerates singularities of
    /// the integrand at its ends.
    fn beyond_kink(&self, to: f64) -> [f64; 2] {
        const STEP: f64 = 0.1;
        if to == 0.0 {
            return [0.0; 2];
        }
        (-34..=34).fold([0.0; 2], |sum, k| {
            let t = STEP * f64::from(k);
            let share = 1.0 / (1.0 + exp(-std::f64::consts::PI * sinh(t)));
            let weight = STEP * to * std::f64::consts::PI * cosh(t) * share * (1.0 - share);
            let (r, rate) = self.at(to * share);
            add(sum, [weight * rate, weight * rate * r])
        })
    }

    /// Gauss quadrature, halved until the halves agree with the whole.
    fn smooth(&self, from: f64, to: f64, depth: u32) -> [f64; 2] {
        if from == to {
            return [0.0; 2];
        }
        let middle = 0.5 * (from + to);
        let whole = self.gauss(from, to);
        let halves = add(self.gauss(from, middle), self.gauss(middle, to));
        // The halves are far better than this for a smooth function.
        let differ = |k: usize| (whole[k] - halves[k]).abs() > (1e-10 * halves[k].abs()).max(self.slack[k]);
        if depth == 0 || !(differ(0) || differ(1)) {
            return halves;
        }
        add(self.smooth(from, middle, depth - 1), self.smooth(middle, to, depth - 1))
    }

    /// Gauss-Legendre quadrature with eight points.
    fn gauss(&self, from: f64, to: f64) -> [f64; 2] {
        const POINTS: [(f64, f64); 4] = [
            (0.183_434_642_495_649_8, 0.362_683_783_378_362),
            (0.525_532_409_916_329, 0.313_706_645_877_887_3),
            (0.796_666_477_413_626_7, 0.222_381_034_453_374_47),
            (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
        ];
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        POINTS.iter().flat_map(|(x, weight)| [(*x, *weight), (-x, *weight)]).fold([0.0; 2], |sum, (x, weight)| {
            let (r, rate) = self.at(middle + half * x);
            add(sum, [half * weight * rate, half * weight * rate * r])
        })
    }

    /// The w up to `last` at which q is reached, and the integral of r dq up to there.
    fn inverse(&self, q: f64, last: f64) -> (f64, f64) {
        let (mut low, mut high) = (self.start, last);
        let (mut w, mut reached) = (self.start, [0.0; 2]);
        // Newton's method, kept inside the bracket by halving; it converges long before.
        for _ in 0..60 {
            let missing = q - reached[0];
            if missing > 0.0 {
                low = w;
            } else {
                high = w;
            }
            let newton = w + missing / self.at(w).1;
            if (newton - w).abs() <= 1e-16 * w.abs() {
                break;
            }
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            reached = add(reached, self.between(w.min(next), w.max(next)).map(|part| part * (next - w).signum()));
            w = next;
        }
        (w, reached[1])
    }
}

fn add(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    /// n = 2 from 0 is tanh, and from above the level coth; backwards (r < 0) tan.
    #[test]
    fn square_law_is_a_hyperbolic_tangent() {
        for q in [1e-9, 1e-3, 0.3, 1.0, 7.0] {
            let r = advance(0.0, 9.0, q, 2.0).change;
            assert!((r / q.tanh() - 1.0).abs() < 1e-13, "{q}: {r}");
            let begin = 1.0 / 0.2f64.tanh();
            let above = begin + advance(begin, -9.0, q, 2.0).change;
            assert!((above * (0.2 + q).tanh() - 1.0).abs() < 1e-13, "{q}: {above}");
        }
        let back = -0.5f64.tan() + advance(-0.5f64.tan(), 9.0, 0.3, 2.0).change;
        assert!((back + 0.2f64.tan()).abs() < 1e-13);
    }

    /// At the level there is nothing left to approach: r stays 1 over the whole distance.
    #[test]
    fn at_the_level_nothing_changes() {
        for exponent in [0.5, 2.0, 3.7] {
            let travel = advance(1.0, 1.0, 0.3, exponent);
            assert_eq!((travel.change, travel.distance, travel.area, travel.arrived), (0.0, 0.3, 0.3, false));
        }
    }

    #[test]
    fn first_order_law_is_an_exponential() {
        for (r, q) in [(0.0, 0.4), (-3.0, 2.0), (5.0, 1e-8), (0.2, 30.0)] {
            let travel = advance(r, f64::NAN, q, 1.0);
            assert_abs_diff_eq!(travel.change, (1.0 - r) * -f64::exp_m1(-q), epsilon = 1e-14);
            assert_abs_diff_eq!(travel.area, q - travel.change, epsilon = 1e-14 * q.max(1.0));
        }
    }

    /// Any exponent against the classical Runge-Kutta method with small steps.
    #[test]
    fn any_exponent_agrees_with_runge_kutta() {
        for exponent in [0.5, 1.5, 3.0, 20.0] {
            for (r, q) in [(-1.0, 0.4), (0.1, 0.7), (1.3, 0.2)] {
                let rate = |r: f64| 1.0 - r.signum() * r.abs().powf(exponent);
                let (n, mut fine, mut area) = (20_000, r, 0.0);
                let h = q / f64::from(n);
                for _ in 0..n {
                    let a = rate(fine);
                    let b = rate(fine + 0.5 * h * a);
                    let c = rate(fine + 0.5 * h * b);
                    let d = rate(fine + h * c);
                    let next = fine + h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
                    area += 0.5 * h * (fine + next) - h * h / 12.0 * (rate(next) - rate(fine));
                    fine = next;
                }
                let travel = advance(r, 2.0 - r, q, exponent);
                assert!((r + travel.change - fine).abs() < 1e-11, "{exponent} {r}: {} {fine}", r + travel.change);
                assert!((travel.area - area).abs() < 1e-10, "{exponent} {r}: {} {area}", travel.area);
            }
        }
    }

    #[test]
    fn arrival_and_the_rest_make_the_whole() {
        for exponent in [0.3, 1.0, 2.5] {
            let first = advance(-0.7, 0.4, 9.0, exponent);
            assert!(first.arrived);
            let second = advance(0.4, 9.0, 2.0 - first.distance, exponent);
            let whole = advance(-0.7, 9.0, 2.0, exponent);
            assert_abs_diff_eq!(first.change + second.change, whole.change, epsilon = 1e-13);
            assert_abs_diff_eq!(first.area + second.area, whole.area, epsilon = 1e-13);
        }
    }
}
