//! Interpolation in a table of points (x, y) with rising x. Beyond its ends the table continues as a straight line.

use crate::number::{Mask, Scalar};

/// Value at `x` on the straight lines between the points.
pub fn linear<T: Scalar>(points: &[(T, T)], x: T) -> T {
    let at = interval(points, x);
    let ((x_0, y_0), slope) = (points[at], secant(points, at));
    y_0 + slope * (x - x_0)
}

/// Slope of [`linear`] at `x`.
pub fn linear_slope<T: Scalar>(points: &[(T, T)], x: T) -> T {
    secant(points, interval(points, x))
}

/// Value at `x` on the monotone cubic of Fritsch and Butland (1984), doi:10.1137/0905021: smooth in the first
/// derivative, rising wherever the points rise, and without overshoot.
pub fn monotone_cubic<T: Scalar>(points: &[(T, T)], x: T) -> T {
    let last = points.len() - 1;
    let at = interval(points, x);
    let [(x_0, y_0), (x_1, y_1)] = [points[at], points[at + 1]];
    if x < points[0].0 {
        return y_0 + slope(points, 0) * (x - x_0);
    }
    if x > points[last].0 {
        return y_1 + slope(points, last) * (x - x_1);
    }
    let length = x_1 - x_0;
    let t = (x - x_0) / length;
    let [one, two, three] = [1.0, 2.0, 3.0].map(T::from);
    // Hermite's form.
    let rest = one - t;
    rest * rest * ((one + two * t) * y_0 + t * length * slope(points, at))
        + t * t * ((three - two * t) * y_1 - rest * length * slope(points, at + 1))
}

/// Slope of [`monotone_cubic`] at `x`.
pub fn monotone_cubic_slope<T: Scalar>(points: &[(T, T)], x: T) -> T {
    let last = points.len() - 1;
    if x < points[0].0 {
        return slope(points, 0);
    }
    if x > points[last].0 {
        return slope(points, last);
    }
    let at = interval(points, x);
    let t = (x - points[at].0) / (points[at + 1].0 - points[at].0);
    let [one, two, three, six] = [1.0, 2.0, 3.0, 6.0].map(T::from);
    let rest = one - t;
    six * t * rest * secant(points, at)
        + rest * (one - three * t) * slope(points, at)
        + t * (three * t - two) * slope(points, at + 1)
}

/// Index of the interval that contains x; the first or the last one for an x outside.
fn interval<T: Scalar>(points: &[(T, T)], x: T) -> usize {
    points[1..points.len() - 1].iter().take_while(|point| x >= point.0).count()
}

/// Slope of the line over an interval.
fn secant<T: Scalar>(points: &[(T, T)], at: usize) -> T {
    let [(x_0, y_0), (x_1, y_1)] = [points[at], points[at + 1]];
    (y_1 - y_0) / (x_1 - x_0)
}

/// Slope of the monotone cubic at a point.
fn slope<T: Scalar>(points: &[(T, T)], at: usize) -> T {
    let last = points.len() - 1;
    if last == 1 {
        return secant(points, 0);
    }
    let length = |at: usize| points[at + 1].0 - points[at].0;
    match at {
        0 => end_slope([length(0), length(1)], [secant(points, 0), secant(points, 1)]),
        _ if at == last => {
            end_slope([length(last - 1), length(last - 2)], [secant(points, last - 1), secant(points, last - 2)])
        }
        _ => inner_slope([length(at - 1), length(at)], [secant(points, at - 1), secant(points, at)]),
    }
}

/// Weighted harmonic mean of the slopes on both sides; 0 at an extremum of the points.
fn inner_slope<T: Scalar>([before, after]: [T; 2], [falling, rising]: [T; 2]) -> T {
    let two = T::from(2.0);
    let weights = [two * after + before, after + two * before];
    let mean = || (weights[0] + weights[1]) / (weights[0] / falling + weights[1] / rising);
    (falling * rising).at_most(T::zero()).choose(|| T::zero(), mean)
}

/// Slope of the parabola through the three points at an end, limited so that it preserves the shape.
fn end_slope<T: Scalar>([near, far]: [T; 2], [first, second]: [T; 2]) -> T {
    let [two, three] = [2.0, 3.0].map(T::from);
    let parabola = ((two * near + far) * first - near * second) / (near + far);
    let is_too_steep = (first * second).at_most(T::zero()) & parabola.abs().above(three * first.abs());
    let limited = || is_too_steep.choose(|| three * first, || parabola);
    (parabola * first).at_most(T::zero()).choose(|| T::zero(), limited)
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: [(f64, f64); 5] = [(-1.0, -3.0), (0.0, 0.0), (0.5, 0.25), (2.0, 0.25), (3.0, 8.0)];

    #[test]
    fn both_pass_through_the_points() {
        for (x, y) in POINTS {
            assert_eq!(linear(&POINTS, x), y);
            assert!((monotone_cubic(&POINTS, x) - y).abs() < 1e-15);
        }
    }

    #[test]
    fn slopes_are_those_of_central_differences() {
        let h = 1e-6;
        for x in [-1.5, -0.3, 0.2, 0.49, 1.0, 2.3, 2.9, 4.0] {
            for (slope, value) in [
                (linear_slope(&POINTS, x), [x - h, x + h].map(|x| linear(&POINTS, x))),
                (monotone_cubic_slope(&POINTS, x), [x - h, x + h].map(|x| monotone_cubic(&POINTS, x))),
            ] {
                assert!((slope - (value[1] - value[0]) / (2.0 * h)).abs() < 1e-8, "{x}");
            }
        }
    }

    /// Rising data give a rising curve, constant data a constant one: there is no overshoot.
    #[test]
    fn the_cubic_never_falls_where_the_points_do_not() {
        let at = |i: i32| monotone_cubic(&POINTS, -2.0 + 1e-3 * f64::from(i));
        assert!((1..6000).all(|i| at(i) >= at(i - 1) - 1e-15));
        assert!((0..100).all(|i| (monotone_cubic(&POINTS, 0.5 + 0.015 * f64::from(i)) - 0.25).abs() < 1e-15));
    }

    /// A cubic is reproduced to second order in the spacing: halving it quarters the error at least.
    #[test]
    fn the_cubic_converges_on_a_smooth_curve() {
        let error = |n: i32| {
            let points: Vec<(f64, f64)> = (0..=n).map(|i| f64::from(i) / f64::from(n)).map(|x| (x, x.exp())).collect();
            (0..999)
                .map(|i| 1e-3 * f64::from(i))
                .map(|x| (monotone_cubic(&points, x) - x.exp()).abs())
                .fold(0.0, f64::max)
        };
        assert!(error(8) > 4.0 * error(16) && error(16) > 4.0 * error(32));
    }

    #[test]
    fn a_line_goes_on_beyond_the_ends() {
        assert_eq!(linear(&POINTS, 4.0), 15.75);
        assert_eq!(linear(&POINTS, -3.0), -9.0);
        assert_eq!(monotone_cubic(&[(0.0, 0.0), (1.0, 2.0)], 7.0), 14.0);
        // Beyond the end the cubic keeps its last slope.
        let beyond = |x: f64| monotone_cubic(&POINTS, x);
        assert!((beyond(5.0) - 2.0 * beyond(4.0) + beyond(3.0)).abs() < 1e-13);
        assert!(((beyond(3.0) - beyond(3.0 - 1e-6)) - (beyond(3.0 + 1e-6) - beyond(3.0))).abs() < 1e-10);
    }
}
