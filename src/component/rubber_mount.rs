use crate::contact::motion::Motion;
use crate::contact::quantities::{DISSIPATED_ENERGY, DISSIPATED_POWER, FRICTION_FORCE, VELOCITY};
use crate::contact::time_stepping::{MOVED, PASSED};
use crate::model::{Derivatives, Fault, Law, Meaning, Model, ModelExchange, boolean, ramp, real};
use crate::number::elementary::{exp, ln_1p};
use crate::number::{Real, choose};

crate::part! {
    /// Rubber of a mount.
    Rubber {
        /// Elastic stiffness (default chosen).
        k_e: tunable = real("N/m", 5e5).at_least(0.0).nominal(1e5).shown_in("N/mm"),
        /// Stiffness in series with the damper; 0 = no damper (default chosen).
        k_v: fixed = real("N/m", 1e5).at_least(0.0).nominal(1e5).shown_in("N/mm"),
        /// Coefficient of the damper (default chosen).
        c: tunable = real("N.s/m", 2000.0).positive().nominal(1e3),
        /// Largest friction (default chosen).
        F_max: tunable = real("N", 100.0).at_least(0.0).nominal(100.0),
        /// Displacement from rest at which the friction is half of the largest (default chosen).
        x_2: tunable = real("m", 2e-4).positive().nominal(1e-4).shown_in("mm"),
    }
}

crate::part! {
    /// State of the rubber of a mount, beside its displacement.
    RubberState {
        /// Friction as a part of the largest.
        friction_share: state = real("1", 0.0).at_least(-1.0).at_most(1.0).odd(),
        /// Friction at the last turning point as a part of the largest.
        turning_share: state = real("1", 0.0).at_least(-1.0).at_most(1.0).discrete().odd(),
        /// Was the last motion towards positive displacements?
        rising: state = boolean(true),
        /// Force of the damper and its spring.
        damper_force: state = real("N", 0.0).nominal(100.0).odd(),
    }
}

crate::model! {
    /// Rubber mount after Berg: an elastic spring, a damper with a spring in series, and friction that remembers the
    /// last turning point, so that small strokes are stiffer than large ones and lose energy at any frequency.
    ///
    /// # Equations
    ///
    /// ```text
    /// F       = k_e x + F_v + F_f
    /// dF_v/dt = k_v (v - F_v / c)
    /// F_f     = F_s + (x - x_s) (F_max - F_s) / (x_2 (1 - F_s / F_max) + (x - x_s))        x rising
    /// F_f     = F_s + (x - x_s) (F_max + F_s) / (x_2 (1 + F_s / F_max) - (x - x_s))        x falling
    /// dx/dt   = v
    /// ```
    ///
    /// with the displacement $x_s$ and the friction $F_s$ at the last turning point. Of the two only $F_s$ has to be
    /// kept: with $f = F_f / F_max$ and $f_s = F_s / F_max$ the same friction obeys
    ///
    /// ```text
    /// df/dt = (v / x_2) ((1 - f) / (1 - f_s))^2        x rising
    /// df/dt = (v / x_2) ((1 + f) / (1 + f_s))^2        x falling
    /// ```
    ///
    /// | symbol | variable         | unit  | meaning                                                     |
    /// |--------|------------------|-------|-------------------------------------------------------------|
    /// | v      | `velocity`       | m/s   | velocity of body 1 relative to body 2                       |
    /// | k_e    | `k_e`            | N/m   | elastic stiffness                                           |
    /// | k_v    | `k_v`            | N/m   | stiffness in series with the damper, 0 = no damper          |
    /// | c      | `c`              | N.s/m | coefficient of the damper                                   |
    /// | F_max  | `F_max`          | N     | largest friction                                            |
    /// | x_2    | `x_2`            | m     | displacement from rest at which the friction is F_max / 2   |
    /// | x      | `displacement`   | m     | displacement of body 1 relative to body 2                   |
    /// | f      | `friction_share` | 1     | friction as a part of F_max                                 |
    /// | f_s    | `turning_share`  | 1     | the same at the last turning point                          |
    /// | -      | `rising`         |       | direction of the last motion                                |
    /// | F_v    | `damper_force`   | N     | force of the damper and its spring                          |
    /// | F      | `friction_force` | N     | force of the mount                                          |
    ///
    /// A periodic motion between $-x_0$ and $x_0$ ends in a loop between $-f_0$ and $f_0$ in which, each cycle, the
    /// friction takes the energy $W$:
    ///
    /// ```text
    /// f_0 = (sqrt(x_2^2 + x_0^2 + 6 x_2 x_0) - x_2 - x_0) / (2 x_2)
    /// W   = 2 F_max (2 x_0 - x_2 (1 + f_0)^2 ln(1 + 2 x_0 / (x_2 (1 + f_0))))
    /// ```
    ///
    /// The stiffness of the friction is $F_max f_0 / x_0$, from $F_max / x_2$ for small strokes to 0 for long ones.
    ///
    /// # Sign
    /// `friction_force` pulls body 1 back to $x = 0$ when positive $x$ make it positive: body 1 feels
    /// `-friction_force`. Dissipated power is `friction_force * velocity`; it is negative while the mount springs back.
    ///
    /// # Step
    /// Exact for held velocities and for velocities that move linearly, with turning points inside of the step: so the
    /// result does not depend on how an interval is divided. Friction and its work are closed forms of the distance,
    /// the damper with its spring is linear. The mount does not know the displacement of the host: it integrates the
    /// velocity, from the start value of `displacement`. With held velocities it follows a host that does the same. In
    /// Model Exchange the turning points are events; a solver without events would never turn.
    ///
    /// A master that integrates a mass m with the force it reads couples it explicitly to the stiffness
    /// $k_e + k_v + F_max / x_2$.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// The friction remembers one turning point: a small loop within a large one does not close, and leaves the large
    /// one there. Small motions back and forth renew the stiffness $F_max / x_2$. A load raised with such motions
    /// stores less than it gives back on a way back without them, so the friction is not passive: up to $F_max$ and
    /// back to 0 it may add $F_max x_2 (4 ln 2 - 5/2) = 0.27 F_max x_2$. Periodic motion with two turning points always
    /// loses energy. The elastic spring is linear. $F_max$ = 0 leaves out the friction, $k_v$ = 0 the damper. A change
    /// of $F_max$ during a run changes the friction with it, at the same share.
    ///
    /// # Source
    /// M. Berg (1998), "A non-linear rubber spring model for rail vehicle dynamics analysis", Vehicle System Dynamics
    /// 30, 197-212, doi:10.1080/00423119808969447. The rate of the friction and the displacement as a state are ours.
    /// The start values are chosen: a top mount of a strut, with a damper that loses most at 8 Hz.
    ///
    /// # Example
    /// ```
    /// use stribeck::component::RubberMount;
    /// use stribeck::model::{Law, Model};
    /// let mut mount = RubberMount { velocity: 2e-4, ..Default::default() };
    /// mount.rubber.k_v = 0.0;
    /// mount.step(1.0); // to x_2
    /// mount.output();
    /// assert!((mount.friction_force - 5e5 * 2e-4 - 50.0).abs() < 1e-12); // k_e x_2 + F_max / 2
    /// ```
    RubberMount: "Rubber mount with friction that remembers the last turning point (Berg)" {
        velocity: input = VELOCITY,
        /// Rubber.
        rubber: (Rubber),
        /// Displacement of body 1 relative to body 2.
        displacement: state_output = real("m", 0.0).nominal(1e-3).shown_in("mm").odd().means(Meaning::Displacement),
        /// Friction and damper.
        state: (RubberState),
        dissipated_energy: state_output = DISSIPATED_ENERGY.nominal(0.1),
        friction_force: output = FRICTION_FORCE.help(
            "Force of the mount, elastic part included; resists a displacement. Body 1 feels its negative."),
        dissipated_power: output = DISSIPATED_POWER,
    }
}

impl<T: Real> RubberMount<T> {
    /// A mount as a part of something else.
    pub(crate) fn of(rubber: Rubber<T>, state: RubberState<T>, [displacement, velocity]: [T; 2]) -> Self {
        let none = T::zero();
        let [dissipated_energy, friction_force, dissipated_power] = [none; 3];
        RubberMount { velocity, rubber, displacement, state, dissipated_energy, friction_force, dissipated_power }
    }

    /// 1 for rising displacement, -1 for falling.
    fn direction(&self) -> T {
        choose!(self.state.rising.vanishes(), T::from(-1.0), T::from(1.0))
    }

    /// Parts of F_max that the friction was away from its limit in this direction at the last turning point, and is
    /// now.
    fn missing(&self) -> [T; 2] {
        let direction = self.direction();
        [self.state.turning_share, self.state.friction_share].map(|share| T::from(1.0) - direction * share)
    }

    fn force(&self) -> T {
        self.rubber.k_e * self.displacement + self.state.damper_force + self.rubber.F_max * self.state.friction_share
    }
}

impl Rubber {
    /// Stiffness for small and quick motions.
    pub(crate) fn largest_stiffness(&self) -> f64 {
        self.k_e + self.k_v + self.F_max / self.x_2
    }
}

impl<T: Real> Law for RubberMount<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.friction_force = self.force();
        self.dissipated_power = self.friction_force * self.velocity;
    }
}

impl<T: Real> Derivatives for RubberMount<T> {
    fn derivatives(&self, rate: &mut Self) {
        let [at_turn, now] = self.missing();
        let part = choose!(at_turn.vanishes(), T::zero(), now / at_turn);
        rate.displacement = self.velocity;
        rate.state.friction_share = part * part * self.velocity / self.rubber.x_2;
        rate.state.damper_force = self.rubber.k_v * (self.velocity - self.state.damper_force / self.rubber.c);
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

impl RubberMount {
    /// Begins a motion in a direction.
    fn turn_to(&mut self, direction: f64) {
        if direction != self.direction() {
            self.state.rising = f64::from(u8::from(direction > 0.0));
            self.state.turning_share = self.state.friction_share;
        }
    }

    /// Moves on in the present direction, and gives the integral of the share over the distance.
    fn slide(&mut self, distance: f64) -> f64 {
        let [at_turn, now] = self.missing();
        // 1 - f = now / (1 + s now / room) at the distance s.
        let room = self.rubber.x_2 * at_turn * at_turn;
        if room == 0.0 {
            return (1.0 - now) * distance;
        }
        let part = distance * (now / room);
        // As a quotient that stays finite.
        self.state.friction_share += self.direction() * now / (1.0 + 1.0 / part);
        distance - room * ln_1p(part)
    }

    /// Advances the damper and its spring, and gives their work.
    fn yield_over(&mut self, part: &Motion) -> f64 {
        let h = part.duration;
        let decay = self.rubber.k_v / self.rubber.c * h;
        let [one, two, three, four] = phi(-decay);
        let (start, pull, change) =
            (self.state.damper_force, self.rubber.k_v * h * part.velocity, part.acceleration * h);
        let push = self.rubber.k_v * h * change;
        self.state.damper_force = start * exp(-decay) + pull * one + push * two;
        // Integrals of the force over the time in parts of h, and over the same once more.
        let once = start * one + pull * two + push * three;
        let twice = start * two + pull * three + push * four;
        h * (part.velocity * once + change * (once - twice))
    }

    /// Advances over a motion in one direction.
    fn follow(&mut self, part: &Motion) {
        let (path, direction) = (part.path(part.duration), part.direction());
        let elastic = self.rubber.k_e * path * (self.displacement + 0.5 * path);
        let mut work = elastic + self.yield_over(part);
        if direction != 0.0 {
            self.turn_to(direction);
            work += self.rubber.F_max * self.slide(path.abs());
        }
        self.displacement += path;
        self.dissipated_energy += work;
    }
}

/// [`ramp::phi`] and the next of these functions, phi_4.
fn phi(x: f64) -> [f64; 4] {
    let [one, two, three] = ramp::phi(x);
    // Horner's form of the series sum x^n / (n + 4)!; the remainder is below rounding.
    let series = || (1..=11).rev().fold(1.0, |sum, n| 1.0 + x * sum / f64::from(n + 4)) / 24.0;
    [one, two, three, if x.abs() < 0.5 { series() } else { (three - 1.0 / 6.0) / x }]
}

impl Model for RubberMount {
    const EVENT_INDICATORS: usize = 1;

    fn check_without_events(&self) -> Result<(), Fault> {
        Err(Fault::new(format_args!("turns at an event; without events its friction would only grow")))
    }

    fn event_indicators(&self, indicators: &mut [f64]) {
        indicators[0] = self.direction() * self.velocity / MOVED + PASSED;
    }

    fn at_event(&mut self) {
        if self.direction() * self.velocity < 0.0 {
            self.turn_to(-self.direction());
        }
    }

    fn step(&mut self, dt: f64) {
        self.follow(&Motion::held(self.velocity, 0.0, dt));
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        let begin = ramp::Inputs::of(self);
        let motion = Motion { acceleration: slope.velocity, ..Motion::held(self.velocity, 0.0, dt) };
        motion.parts().for_each(|part| self.follow(&part));
        ramp::set_inputs(self, &begin, slope, dt);
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{LN_2, TAU};

    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::model::ramp::held_inputs;

    fn with(set: impl Fn(&mut Rubber)) -> RubberMount {
        let mut mount = RubberMount::default();
        set(&mut mount.rubber);
        mount
    }

    /// Friction only.
    fn friction() -> RubberMount {
        with(|rubber| (rubber.k_e, rubber.k_v) = (0.0, 0.0))
    }

    /// Moves by a distance in a second.
    fn moved(mount: &mut RubberMount, distance: f64) {
        mount.velocity = distance;
        mount.step(1.0);
        mount.output();
    }

    /// The printed friction, with the memory of both coordinates of the last turning point, which the caller keeps.
    fn printed(x: f64, [x_s, f_s]: [f64; 2], is_rising: bool) -> f64 {
        let (f_max, x_2) = (100.0, 2e-4);
        if is_rising {
            f_s + (x - x_s) * (f_max - f_s) / (x_2 * (1.0 - f_s / f_max) + (x - x_s))
        } else {
            f_s + (x - x_s) * (f_max + f_s) / (x_2 * (1.0 + f_s / f_max) - (x - x_s))
        }
    }

    /// Along strokes of several steps each, small ones inside of large ones.
    #[test]
    fn friction_is_the_printed_one() {
        let mut mount = friction();
        let mut turn = [0.0, 0.0];
        for (target, is_rising) in [(3e-4, true), (1e-4, false), (1.5e-4, true), (-8e-4, false), (5e-3, true)] {
            let begin = mount.displacement;
            for _ in 0..7 {
                moved(&mut mount, (target - begin) / 7.0);
                let expected = printed(mount.displacement, turn, is_rising);
                assert_abs_diff_eq!(mount.friction_force, expected, epsilon = 1e-11);
            }
            turn = [mount.displacement, mount.friction_force];
        }
    }

    /// F_max / x_2 at first, half of F_max at x_2, F_max in the end: from rest, to either side.
    #[test]
    fn virgin_curve_has_its_two_parameters() {
        for side in [1.0, -1.0] {
            let mut mount = friction();
            moved(&mut mount, side * 1e-12);
            assert!((mount.friction_force / (side * 1e-12) / 5e5 - 1.0).abs() < 1e-7);
            moved(&mut mount, side * (2e-4 - 1e-12));
            assert_abs_diff_eq!(mount.friction_force, side * 50.0, epsilon = 1e-12);
            moved(&mut mount, side * 1e9);
            assert_abs_diff_eq!(mount.friction_force, side * 100.0, epsilon = 1e-9);
        }
    }

    /// Loss and stiffness of loops between -x_0 and x_0 in closed form.
    #[test]
    fn loops_have_the_printed_loss_and_stiffness() {
        let (f_max, x_2) = (100.0, 2e-4f64);
        for x_0 in [1e-5, 1e-4, 4e-4, 5e-3] {
            let mut mount = friction();
            moved(&mut mount, x_0);
            for _ in 0..3000 {
                moved(&mut mount, -2.0 * x_0);
                moved(&mut mount, 2.0 * x_0);
            }
            let share = ((x_2 * x_2 + x_0 * x_0 + 6.0 * x_2 * x_0).sqrt() - x_2 - x_0) / (2.0 * x_2);
            assert!(
                (mount.friction_force / (f_max * share) - 1.0).abs() < 1e-9,
                "{x_0}: {}",
                mount.state.friction_share
            );
            let before = mount.dissipated_energy;
            moved(&mut mount, -2.0 * x_0);
            assert!((mount.friction_force / (f_max * share) + 1.0).abs() < 1e-9, "{x_0}");
            moved(&mut mount, 2.0 * x_0);
            let end = x_2 * (1.0 + share);
            let loss = 2.0 * f_max * (2.0 * x_0 - end * (1.0 + share) * (1.0 + 2.0 * x_0 / end).ln());
            let found = mount.dissipated_energy - before;
            assert!((found - loss).abs() < 1e-12 * f_max * x_0 + 1e-7 * loss, "{x_0}: {found} {loss}");
            // Long strokes lose almost as much as a constant force would.
            assert!(loss > 0.0 && loss < 4.0 * f_max * x_0);
        }
        let stiffness =
            |x_0: f64| f_max / x_0 * ((x_2 * x_2 + x_0 * x_0 + 6.0 * x_2 * x_0).sqrt() - x_2 - x_0) / (2.0 * x_2);
        assert!((stiffness(1e-9) / 5e5 - 1.0).abs() < 1e-4);
    }

    /// A rise in small steps, each after a still smaller step back, costs only the work of a spring; the way back
    /// without them gives back more, as the page says.
    #[test]
    fn friction_may_add_energy() {
        let mut mount = friction();
        while mount.state.friction_share < 0.999 {
            moved(&mut mount, 2e-8);
            moved(&mut mount, -1e-8);
        }
        while mount.state.friction_share > 0.0 {
            moved(&mut mount, -1e-7);
        }
        let gained = -mount.dissipated_energy / (100.0 * 2e-4);
        assert!((gained - (4.0 * LN_2 - 2.5)).abs() < 0.01, "{gained}");
    }

    /// A velocity that moves linearly through zero: the rates by the classical Runge-Kutta method, with an event where
    /// the indicator changes its sign.
    #[test]
    fn ramps_agree_with_rates_and_events() {
        let mut start = RubberMount { velocity: 0.01, ..Default::default() };
        start.state.damper_force = 30.0;
        let (mut exact, mut solved) = (start, start);
        for (slope, time) in [(-0.5, 0.05), (1.2, 0.03), (-0.4, 0.08)] {
            let rates = RubberMount { velocity: slope, ..held_inputs(&exact) };
            exact.step_ramp(&rates, time);
            let count = 20_000;
            let h = time / f64::from(count);
            let begin = solved.velocity;
            for step in 0..count {
                let mut indicator = [0.0];
                solved.velocity = begin + slope * h * f64::from(step);
                solved.event_indicators(&mut indicator);
                if indicator[0] < 0.0 {
                    solved.at_event();
                }
                runge_kutta(&mut solved, slope, h);
            }
            solved.velocity = begin + slope * time;
            for (found, expected, scale) in [
                (solved.displacement, exact.displacement, 1e-3),
                (solved.state.friction_share, exact.state.friction_share, 1.0),
                (solved.state.damper_force, exact.state.damper_force, 100.0),
                (solved.dissipated_energy, exact.dissipated_energy, 0.1),
            ] {
                assert!((found - expected).abs() < 1e-5 * scale, "{slope}: {found} {expected}");
            }
        }
        assert_eq!([exact.state.rising, solved.state.rising], [0.0, 0.0]);
        assert_abs_diff_eq!(exact.state.turning_share, solved.state.turning_share, epsilon = 1e-5);
    }

    fn runge_kutta(mount: &mut RubberMount, slope: f64, h: f64) {
        let rates = |at: &RubberMount| {
            let mut rate = RubberMount::default();
            at.derivatives(&mut rate);
            [rate.displacement, rate.state.friction_share, rate.state.damper_force, rate.dissipated_energy]
        };
        let begin = *mount;
        let moved = |k: [f64; 4], part: f64| RubberMount {
            velocity: begin.velocity + slope * part * h,
            displacement: begin.displacement + part * h * k[0],
            state: RubberState {
                friction_share: begin.state.friction_share + part * h * k[1],
                damper_force: begin.state.damper_force + part * h * k[2],
                ..begin.state
            },
            dissipated_energy: begin.dissipated_energy + part * h * k[3],
            ..begin
        };
        let k_1 = rates(&begin);
        let k_2 = rates(&moved(k_1, 0.5));
        let k_3 = rates(&moved(k_2, 0.5));
        let k_4 = rates(&moved(k_3, 1.0));
        *mount = moved(std::array::from_fn(|i| (k_1[i] + 2.0 * k_2[i] + 2.0 * k_3[i] + k_4[i]) / 6.0), 1.0);
    }

    /// Loss of damper and spring in a sine, by their complex stiffness: k_v i w T / (1 + i w T) with T = c / k_v.
    #[test]
    fn damper_loses_as_its_complex_stiffness_says() {
        for frequency in [0.5, 8.0, 100.0] {
            let mut mount = with(|rubber| (rubber.k_e, rubber.F_max) = (0.0, 0.0));
            let (w, x_0, count) = (TAU * frequency, 1e-3, 4000);
            let h = 1.0 / frequency / f64::from(count);
            let velocity = |step: u32| x_0 * w * (w * h * f64::from(step)).cos();
            let mut before = 0.0;
            for step in 0..20 * count {
                if step == 19 * count {
                    before = mount.dissipated_energy;
                }
                mount.velocity = velocity(step);
                let slope = (velocity(step + 1) - velocity(step)) / h;
                mount.step_ramp(&RubberMount { velocity: slope, ..held_inputs(&mount) }, h);
            }
            let turn = w * 2000.0 / 1e5;
            let expected = 0.5 * TAU * x_0 * x_0 * 1e5 * turn / (1.0 + turn * turn);
            let found = mount.dissipated_energy - before;
            assert!((found / expected - 1.0).abs() < 1e-5, "{frequency} Hz: {found} {expected}");
        }
    }

    /// Without the damper the mount is a spring beside its friction; without both it is a spring.
    #[test]
    fn parts_can_be_left_out() {
        let mut mount = with(|rubber| (rubber.k_v, rubber.F_max) = (0.0, 0.0));
        for distance in [1e-3, -3e-3, 2e-3] {
            moved(&mut mount, distance);
            assert_abs_diff_eq!(mount.friction_force, 5e5 * mount.displacement, epsilon = 1e-9);
        }
        assert!(mount.dissipated_energy.abs() < 1e-12);
        // A damper far stiffer than it is quick is a damper alone.
        let mut damper = with(|rubber| (rubber.k_e, rubber.F_max, rubber.k_v) = (0.0, 0.0, 1e12));
        moved(&mut damper, 0.1);
        assert_abs_diff_eq!(damper.friction_force, 200.0, epsilon = 1e-6);
        assert_abs_diff_eq!(damper.dissipated_energy, 20.0, epsilon = 1e-6);
    }
}
