//! The velocity at the end of a step in which a body feels the friction force of that velocity.
//!
//! A steep friction law, coupled explicitly, makes the force alternate unless the step is tiny. If the law knows the
//! body's mass m and the step h, it can look ahead: with the external force f_e held, the velocity w after the step and
//! the force f(w) satisfy
//!
//! ```text
//! m (w - v) / h = f_e - f(w)
//! ```
//!
//! (implicit Euler, and for a set-valued law the time stepping of J. J. Moreau). Where f falls with speed there can be
//! three solutions. The body cannot pass any of them, so the relevant one is the first one reached from v in the
//! direction in which the body is accelerated.

use crate::number::Dual;

/// The first solution that the body reaches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Landing {
    /// A velocity at which the curve balances the body.
    Curve(f64),
    /// The index of the mark at which the curve jumps across the balance: the force is a value within the jump.
    Jump(usize),
}

/// Iterations of Newton's method, which needs about five; bisection needs about sixty (chosen).
const ITERATIONS: usize = 200;

/// Walks down from `start`, where the body decelerates, to the first zero of the `residual`
/// m (w - v) / h + f(w) - f_e, whose derivative must be given with it.
///
/// `marks` are the velocities, in falling order, at which the curve has kinks or jumps. Between two of them, outwards
/// from rest, the curve must be rising, or first concave and then convex. `end` is a velocity, below all marks that may
/// be reached, at which the residual is not positive.
#[inline(never)] // once for all laws
pub fn first(residual: &dyn Fn(f64) -> Dual, marks: &[f64], start: f64, end: f64) -> Landing {
    let mut upper = start;
    for (number, &mark) in marks.iter().enumerate() {
        if mark > upper || mark <= end {
            continue;
        }
        if mark < upper
            && let Some(velocity) = first_between(residual, upper, above(mark))
        {
            return Landing::Curve(velocity);
        }
        upper = below(mark);
        if residual(upper).value <= 0.0 {
            return Landing::Jump(number);
        }
    }
    // Rounding may leave a residual just above zero at the end.
    Landing::Curve(first_between(residual, upper, end).unwrap_or(end))
}

/// The next larger velocity than a mark.
fn above(mark: f64) -> f64 {
    // Close to zero there are numbers so small that arithmetic with them is slow.
    if mark == 0.0 { f64::MIN_POSITIVE } else { mark.next_up() }
}

/// The next smaller velocity than a mark.
fn below(mark: f64) -> f64 {
    -above(-mark)
}

/// The highest zero between `lower` and `upper`, where the residual is positive.
///
/// Where the residual is convex, Newton's method comes down to the first zero without stepping over it; if it reaches a
/// point where the residual falls with velocity, it has passed a minimum without zero, and the part below is concave:
/// it holds one zero if it ends below zero. Where the residual rises all the way, it has one zero at most.
fn first_between(residual: &dyn Fn(f64) -> Dual, upper: f64, lower: f64) -> Option<f64> {
    let (mut velocity, mut here) = (upper, residual(upper));
    for _ in 0..ITERATIONS {
        let next = velocity - here.value / here.slope;
        if !(here.slope > 0.0 && next > lower) {
            break;
        }
        if is_same(next, velocity) {
            return Some(next);
        }
        let there = residual(next);
        if there.value <= 0.0 {
            return Some(between(residual, next, velocity));
        }
        (velocity, here) = (next, there);
    }
    (residual(lower).value <= 0.0).then(|| between(residual, lower, velocity))
}

/// The zero between `lower`, where the residual is not positive, and `upper`, where it is: Newton's method, with
/// bisection if that would leave the bracket or not be faster.
fn between(residual: &dyn Fn(f64) -> Dual, mut lower: f64, mut upper: f64) -> f64 {
    let mut velocity = lower;
    let mut here = residual(velocity);
    let mut width = upper - lower;
    for _ in 0..ITERATIONS {
        if here.value == 0.0 {
            break;
        }
        let newton = velocity - here.value / here.slope;
        let is_fast = (newton - velocity).abs() < 0.5 * width;
        let next = if is_fast && newton > lower && newton < upper { newton } else { 0.5 * (lower + upper) };
        width = (next - velocity).abs();
        if is_same(next, velocity) || is_same(lower, upper) {
            return next;
        }
        velocity = next;
        here = residual(velocity);
        if here.value > 0.0 { upper = velocity } else { lower = velocity }
    }
    velocity
}

/// Whether the two differ only by rounding.
fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 2.0 * f64::EPSILON * b.abs()
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    /// Residual of a body with m / h = `inertia` and velocity `v` under `load`, on a curve.
    fn residual(curve: fn(f64) -> (f64, f64), inertia: f64, v: f64, load: f64) -> impl Fn(f64) -> Dual {
        move |w| {
            let (value, slope) = curve(w);
            Dual { value: inertia * (w - v) + value - load, slope: inertia + slope }
        }
    }

    /// Odd continuation of a curve given for v > 0.
    fn odd(w: f64, (value, slope): (f64, f64)) -> (f64, f64) {
        (value.copysign(w), slope)
    }

    /// 1 + 0.5 exp(-v^2): set-valued at rest, falling.
    fn gaussian(w: f64) -> (f64, f64) {
        odd(w, (1.0 + 0.5 * (-w * w).exp(), -w.abs() * (-w * w).exp()))
    }

    /// Rises to 1 at v = 1, then stays.
    fn linear(w: f64) -> (f64, f64) {
        if w.abs() < 1.0 { (w, 1.0) } else { (1.0f64.copysign(w), 0.0) }
    }

    /// Rises to 0.5 at v = 1, jumps to 1.
    fn jump(w: f64) -> (f64, f64) {
        if w.abs() < 1.0 { (0.5 * w, 0.5) } else { (1.0f64.copysign(w), 0.0) }
    }

    #[test]
    fn piecewise_linear_curves_by_hand() {
        let marks = [1.0, 0.0, -1.0];
        // 2 (w - 3) + 1 = 0 stays on the plateau; 0.1 (w - 3) + w = 0 ends on the slope.
        assert_eq!(first(&residual(linear, 2.0, 3.0, 0.0), &marks, 3.0, -1.0), Landing::Curve(2.5));
        let Landing::Curve(w) = first(&residual(linear, 0.1, 3.0, 0.0), &marks, 3.0, -1.0) else { panic!() };
        assert_abs_diff_eq!(w, 0.3 / 1.1, epsilon = 1e-15);
        // Through rest to the other plateau: 1 (w - 3) - 1 + 10 = 0.
        assert_eq!(first(&residual(linear, 1.0, 3.0, -10.0), &marks, 3.0, -7.0), Landing::Curve(-6.0));
    }

    #[test]
    fn a_jump_holds_what_lies_within() {
        let marks = [1.0, 0.0, -1.0];
        // At v = 1 the balance asks for a force of 0.2 + 0.3 * 1.5 = 0.65, within the jump from 0.5 to 1.
        assert_eq!(first(&residual(jump, 0.3, 2.5, 0.2), &marks, 2.5, -1.0), Landing::Jump(0));
        // Set-valued at rest: 0.3 * 2.5 - 1 = -0.25 lies between -1.5 and 1.5.
        assert_eq!(first(&residual(gaussian, 0.3, 2.5, -1.0), &[0.0], 2.5, -1.0), Landing::Jump(0));
    }

    /// On a falling branch with three balances, against a scan from the starting point.
    #[test]
    fn the_first_of_several_zeros_is_found() {
        let mut several = 0;
        for k in 0..4000 {
            let (a, b, c) = (f64::from(k % 20), f64::from(k / 20 % 20), f64::from(k / 400));
            let (inertia, v, load) = (0.1 + 0.04 * c, 0.5 + 0.1 * a, 0.9 + 0.01 * b);
            let residual = residual(gaussian, inertia, v, load);
            if residual(v).value <= 0.0 {
                continue;
            }
            let n = 20_000;
            let at = |i: i32| v * (1.0 - f64::from(i) / f64::from(n));
            let zeros: Vec<i32> =
                (1..=n).filter(|i| (residual(at(*i)).value > 0.0) != (residual(at(*i - 1)).value > 0.0)).collect();
            several += usize::from(zeros.len() > 1);
            match first(&residual, &[0.0], v, -10.0) {
                Landing::Curve(w) if w > 0.0 => {
                    assert!(w >= at(zeros[0]) && w <= at(zeros[0] - 1), "{inertia} {v} {load}: {w}");
                    assert!(residual(w).value.abs() < 1e-14);
                }
                landing => assert!(zeros.is_empty(), "{inertia} {v} {load}: {landing:?}, {}", at(zeros[0])),
            }
        }
        assert!(several > 100, "{several}");
    }

    /// A curve steeper than numbers can resolve causes no problem, nor does a body without mass.
    #[test]
    fn extreme_slopes_end_in_time() {
        fn steep(w: f64) -> (f64, f64) {
            let t = (1e200 * w).tanh();
            (t, 1e200 * (1.0 - t * t))
        }
        for (inertia, load) in [(1.0, 0.3), (1e-300, -0.3), (1e15, 0.999)] {
            let landing = first(&residual(steep, inertia, 2.0, load), &[0.0], 2.0, f64::min(0.0, 2.0 + load / inertia));
            let Landing::Curve(w) = landing else { panic!("{landing:?}") };
            let force = steep(w).0;
            let balance = inertia * (w - 2.0) + force - load;
            assert!(balance.abs() < 1e-9 || inertia > 1e10 && (w - 2.0).abs() < 1e-14, "{inertia}: {w} {balance}");
        }
    }
}
