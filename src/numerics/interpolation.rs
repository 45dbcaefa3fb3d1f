//! Interpolation in a table of points (x, y) with rising x. Beyond its ends the table continues as a straight line.

use crate::number::{Mask, Scalar};

/// A curve through points, of which the first ones are in use: at least two.
#[derive(Clone, Copy)]
pub struct Curve<'a, T> {
    points: &'a [(T, T)],
    count: T,
}

impl<'a, T: Scalar> From<&'a [(T, T)]> for Curve<'a, T> {
    fn from(points: &'a [(T, T)]) -> Curve<'a, T> {
        Curve::new(points, T::from(points.len() as f64))
    }
}

impl<'a, T: Scalar> Curve<'a, T> {
    /// The curve through the first `count` points.
    pub fn new(points: &'a [(T, T)], count: T) -> Curve<'a, T> {
        Curve { points, count }
    }

    /// Value at `x` on the straight lines between the points.
    pub fn linear(&self, x: T) -> T {
        let line = |at: usize| {
            let ((x_0, y_0), slope) = (self.points[at], self.secant(at));
            y_0 + slope * (x - x_0)
        };
        self.on_interval(0, x, &line)
    }

    /// Slope of [`Curve::linear`] at `x`.
    pub fn linear_slope(&self, x: T) -> T {
        self.on_interval(0, x, &|at| self.secant(at))
    }

    /// Value at `x` on the monotone cubic of Fritsch and Butland (1984), doi:10.1137/0905021: smooth in the first
    /// derivative, rising wherever the points rise, and without overshoot.
    pub fn monotone_cubic(&self, x: T) -> T {
        let curve = |at: usize| {
            let [(x_0, y_0), (x_1, y_1)] = [self.points[at], self.points[at + 1]];
            let inside = || {
                let length = x_1 - x_0;
                let t = (x - x_0) / length;
                let [one, two, three] = [1.0, 2.0, 3.0].map(T::from);
                // Hermite's form.
                let rest = one - t;
                rest * rest * ((one + two * t) * y_0 + t * length * self.slope(at))
                    + t * t * ((three - two * t) * y_1 - rest * length * self.slope(at + 1))
            };
            let before = || y_0 + self.slope(at) * (x - x_0);
            let beyond = || y_1 + self.slope(at + 1) * (x - x_1);
            self.by_place(at, x, before, inside, beyond)
        };
        self.on_interval(0, x, &curve)
    }

    /// Slope of [`Curve::monotone_cubic`] at `x`.
    pub fn monotone_cubic_slope(&self, x: T) -> T {
        let curve = |at: usize| {
            let inside = || {
                let t = (x - self.points[at].0) / (self.points[at + 1].0 - self.points[at].0);
                let [one, two, three, six] = [1.0, 2.0, 3.0, 6.0].map(T::from);
                let rest = one - t;
                six * t * rest * self.secant(at)
                    + rest * (one - three * t) * self.slope(at)
                    + t * (three * t - two) * self.slope(at + 1)
            };
            self.by_place(at, x, || self.slope(at), inside, || self.slope(at + 1))
        };
        self.on_interval(0, x, &curve)
    }

    /// A number by the interval that contains x, beginning with this one; the first or the last one for an x outside.
    fn on_interval(&self, at: usize, x: T, value: &impl Fn(usize) -> T) -> T {
        if at + 2 >= self.points.len() {
            return value(at);
        }
        let is_later = T::from((at + 2) as f64).below(self.count) & x.at_least(self.points[at + 1].0);
        is_later.choose(|| self.on_interval(at + 1, x, value), || value(at))
    }

    /// A number by whether x is in its interval, or beyond an end of the table.
    fn by_place(
        &self,
        at: usize,
        x: T,
        before: impl FnOnce() -> T,
        inside: impl FnOnce() -> T,
        beyond: impl FnOnce() -> T,
    ) -> T {
        // Only in the last interval x can be beyond the end.
        let from_here = || x.above(self.points[at + 1].0).choose(beyond, inside);
        if at == 0 { x.below(self.points[0].0).choose(before, from_here) } else { from_here() }
    }

    fn length(&self, at: usize) -> T {
        self.points[at + 1].0 - self.points[at].0
    }

    /// Slope of the line over an interval.
    fn secant(&self, at: usize) -> T {
        let [(x_0, y_0), (x_1, y_1)] = [self.points[at], self.points[at + 1]];
        (y_1 - y_0) / (x_1 - x_0)
    }

    /// Slope of the monotone cubic at a point.
    fn slope(&self, at: usize) -> T {
        let has_two = self.count.at_most(T::from(2.0));
        let (last, is_last) = (self.points.len() - 1, T::from((at + 1) as f64).at_least(self.count));
        let at_end = || self.slope_at_end(at - 1, at - 2);
        let of_many = || match at {
            0 => self.slope_at_end(0, 1),
            1 => self.inner_slope(at),
            _ if at == last => at_end(),
            _ => is_last.choose(at_end, || self.inner_slope(at)),
        };
        // Nothing is read beyond the points, whatever the count.
        if last == 1 { self.secant(0) } else { has_two.choose(|| self.secant(0), of_many) }
    }

    /// Slope of the parabola through the three points at an end, limited so that it preserves the shape: by the
    /// interval at the end, and the next one.
    fn slope_at_end(&self, at: usize, next: usize) -> T {
        let ([near, far], [first, second]) =
            ([at, next].map(|at| self.length(at)), [at, next].map(|at| self.secant(at)));
        let [two, three] = [2.0, 3.0].map(T::from);
        let parabola = ((two * near + far) * first - near * second) / (near + far);
        let is_too_steep = (first * second).at_most(T::zero()) & parabola.abs().above(three * first.abs());
        let limited = || is_too_steep.choose(|| three * first, || parabola);
        (parabola * first).at_most(T::zero()).choose(|| T::zero(), limited)
    }

    /// Weighted harmonic mean of the slopes on both sides; 0 at an extremum of the points.
    fn inner_slope(&self, at: usize) -> T {
        let ([before, after], [falling, rising]) =
            ([at - 1, at].map(|at| self.length(at)), [at - 1, at].map(|at| self.secant(at)));
        let two = T::from(2.0);
        let weights = [two * after + before, after + two * before];
        let mean = || (weights[0] + weights[1]) / (weights[0] / falling + weights[1] / rising);
        (falling * rising).at_most(T::zero()).choose(|| T::zero(), mean)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    const POINTS: [(f64, f64); 5] = [(-1.0, -3.0), (0.0, 0.0), (0.5, 0.25), (2.0, 0.25), (3.0, 8.0)];

    fn curve() -> Curve<'static, f64> {
        Curve::from(&POINTS[..])
    }

    #[test]
    fn both_pass_through_the_points() {
        for (x, y) in POINTS {
            assert_eq!(curve().linear(x), y);
            assert_abs_diff_eq!(curve().monotone_cubic(x), y, epsilon = 1e-15);
        }
    }

    #[test]
    fn slopes_are_those_of_central_differences() {
        let h = 1e-6;
        for x in [-1.5, -0.3, 0.2, 0.49, 1.0, 2.3, 2.9, 4.0] {
            for (slope, value) in [
                (curve().linear_slope(x), [x - h, x + h].map(|x| curve().linear(x))),
                (curve().monotone_cubic_slope(x), [x - h, x + h].map(|x| curve().monotone_cubic(x))),
            ] {
                assert!((slope - (value[1] - value[0]) / (2.0 * h)).abs() < 1e-8, "{x}");
            }
        }
    }

    /// Rising data give a rising curve, constant data a constant one: there is no overshoot.
    #[test]
    fn the_cubic_never_falls_where_the_points_do_not() {
        let at = |i: i32| curve().monotone_cubic(-2.0 + 1e-3 * f64::from(i));
        assert!((1..6000).all(|i| at(i) >= at(i - 1) - 1e-15));
        assert!((0..100).all(|i| (curve().monotone_cubic(0.5 + 0.015 * f64::from(i)) - 0.25).abs() < 1e-15));
    }

    /// A cubic is reproduced to second order in the spacing: halving it quarters the error at least.
    #[test]
    fn the_cubic_converges_on_a_smooth_curve() {
        let error = |n: i32| {
            let points: Vec<(f64, f64)> = (0..=n).map(|i| f64::from(i) / f64::from(n)).map(|x| (x, x.exp())).collect();
            (0..999)
                .map(|i| 1e-3 * f64::from(i))
                .map(|x| (Curve::from(&points[..]).monotone_cubic(x) - x.exp()).abs())
                .fold(0.0, f64::max)
        };
        assert!(error(8) > 4.0 * error(16) && error(16) > 4.0 * error(32));
    }

    #[test]
    fn a_line_goes_on_beyond_the_ends() {
        assert_eq!(curve().linear(4.0), 15.75);
        assert_eq!(curve().linear(-3.0), -9.0);
        assert_eq!(Curve::from(&[(0.0, 0.0), (1.0, 2.0)][..]).monotone_cubic(7.0), 14.0);
        // Beyond the end the cubic keeps its last slope.
        let beyond = |x: f64| curve().monotone_cubic(x);
        assert!((beyond(5.0) - 2.0 * beyond(4.0) + beyond(3.0)).abs() < 1e-13);
        assert_abs_diff_eq!(beyond(3.0) - beyond(3.0 - 1e-6), beyond(3.0 + 1e-6) - beyond(3.0), epsilon = 1e-10);
    }
}
