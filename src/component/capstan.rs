use crate::contact::motion::Motion;
use crate::contact::quantities::{DISSIPATED_ENERGY, DISSIPATED_POWER, FRICTION_FORCE, MU_K, VELOCITY};
use crate::model::{Derivatives, Fault, Law, Meaning, Model, ModelExchange, Preset, ramp, real};
use crate::number::Real;
use crate::number::elementary::{exp, exp_m1, ln};
use crate::numerics::quadrature::integral;

/// Largest logarithm of the ratio of the tensions (chosen: a ratio of 5e21, beyond any rope).
const LARGEST: f64 = 50.0;

/// Way in relaxation distances after which nothing is left of a change of the share (chosen: e^-40 is below rounding).
const SETTLED: f64 = 40.0;

crate::model! {
    /// Rope, belt or Bowden cable over bends: the friction grows exponentially with the angle of wrap (Euler,
    /// Eytelwein), and with a state in place of the sign of the velocity it builds up over a short way.
    ///
    /// # Equations
    ///
    /// ```text
    /// T_2   = (T_0 + T_1) exp(mu_k phi z)
    /// dz/dt = (v - |v| z) / d
    /// f_f   = T_2 - (T_0 + T_1)
    /// ```
    ///
    /// The state comes to $z = sgn(v)$ after some $d$ of motion. Then
    ///
    /// ```text
    /// T_2 = (T_0 + T_1) exp( mu_k phi)           v > 0, side 2 pulls
    /// T_2 = (T_0 + T_1) exp(-mu_k phi)           v < 0, side 1 pulls
    /// ```
    ///
    /// | symbol | variable              | unit | meaning                                                        |
    /// |--------|-----------------------|------|----------------------------------------------------------------|
    /// | v      | `velocity`            | m/s  | velocity of the rope relative to the drum, from side 1 to 2    |
    /// | T_1    | `tension_1`           | N    | tension on side 1 beside the preload                           |
    /// | T_0    | `preload`             | N    | tension on side 1 without load                                 |
    /// | mu_k   | `mu_k`                | 1    | kinetic coefficient of friction of rope and drum               |
    /// | phi    | `wrap_angle`          | rad  | angle of wrap, all bends and turns together                    |
    /// | d      | `relaxation_distance` | m    | distance after which 1/e of a change of z is left              |
    /// | z      | `friction_share`      | 1    | part of the angle whose friction acts, -1 to 1                 |
    /// | T_2    | `tension_2`           | N    | tension on side 2                                              |
    /// | f_f    | `friction_force`      | N    | friction force on the rope                                     |
    ///
    /// Bends in series add up in their angles, whatever their radii and planes: a cable that is not stretched slides by
    /// the same way in all of them, so that they have the same $z$, and their ratios of tensions multiply. Bends with
    /// different $mu_k$ or $d$ are a `Capstan` each, with `tension_2` of one as `tension_1` of the next, and a
    /// `preload` only in the first.
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` once the rope has moved by some $d$ in one direction; the rope feels
    /// `-friction_force`, the drum feels `friction_force`. Dissipated power is `friction_force * velocity`, negative for
    /// short ways after a reversal. At a constant tension $T = T_0 + T_1$ the bend is passive: it gives back no more
    /// than it has stored. The store $E$ is empty at $z = 0$ and follows
    ///
    /// ```text
    /// dE/dz = d (T_0 + T_1) (exp(mu_k phi z) - 1) / (1 + |z|)
    /// ```
    ///
    /// # Step
    /// Exact for held inputs: the state is an exponential of the way, the energy an integral over the way with an error
    /// below 1e-10 of it. For a velocity that moves linearly as well, as long as the tension is held; else by the
    /// rates, with error control.
    ///
    /// A master that integrates a mass m with the force it reads couples it explicitly to the stiffness of the bend, at
    /// most $2 mu_k phi T exp(mu_k phi) / d$, where the rope turns back from $v > 0$.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; $mu_k phi$ above 50, a ratio of the tensions of 5e21.
    ///
    /// # Limits
    /// The rope has neither mass nor bending stiffness, and the drum no inertia: a drum that turns is part of
    /// `velocity`. A rope at rest keeps the ratio of its tensions: a change of `tension_1` alone does not move it
    /// towards slip, and `tension_2` follows at once. Under a tension that swings it creeps, as Dahl's law
    /// does, and is not passive: what a way stores without tension is given back under one that is set later. For a V-belt
    /// $mu_k$ is that of the rope by the sine of half the angle of its groove; the centrifugal tension of a fast belt is
    /// not in it. The
    /// friction of the bends acts everywhere at once; in a long cable that stretches it spreads from the end that is
    /// pulled. $d$ is the way by which the rope stretches and shears before it slides. $mu_k phi$ = 0 leaves out the
    /// friction; a tension of 0 has none.
    ///
    /// # Source
    /// L. Euler, "Remarques sur l'effet du frottement dans l'equilibre", Memoires de l'academie des sciences de Berlin
    /// 18 (1769), 265-278; J. A. Eytelwein, "Handbuch der Statik fester Koerper" (1808). The state is that of Dahl's
    /// law, see `Dahl`; that it multiplies the angle is ours. All start values are chosen.
    ///
    /// # Example
    /// ```
    /// use stribeck::component::Capstan;
    /// use stribeck::model::{Law, Model};
    /// let mut half_turn = Capstan { velocity: 1.0, tension_1: 10.0, ..Default::default() };
    /// half_turn.step(1.0);
    /// half_turn.output();
    /// assert!((half_turn.tension_2 - 13.69).abs() < 0.01); // 10 exp(0.1 pi)
    /// ```
    Capstan: "Rope or Bowden cable over bends, with pre-sliding displacement (Euler and Eytelwein)" {
        velocity: input = VELOCITY.help("Velocity of the rope relative to the drum, from side 1 to side 2."),
        /// Tension on side 1 beside the preload (default chosen).
        tension_1: input = real("N", 10.0).at_least(0.0).nominal(10.0),
        mu_k: tunable = MU_K,
        /// Angle of wrap, all bends and turns together (default chosen: half a turn).
        wrap_angle: tunable = real("rad", std::f64::consts::PI).at_least(0.0).shown_in("deg").means(Meaning::Shape),
        /// Tension on side 1 without load.
        preload: tunable = real("N", 0.0).at_least(0.0).nominal(10.0),
        /// Distance after which 1/e of a change of the friction share is left (default chosen).
        relaxation_distance: tunable = real("m", 1e-3).positive().nominal(1e-3).shown_in("mm"),
        /// Part of the angle whose friction acts, with the sign of the direction.
        friction_share: state = real("1", 0.0).at_least(-1.0).at_most(1.0).odd(),
        dissipated_energy: state_output = DISSIPATED_ENERGY.nominal(0.1),
        friction_force: output = FRICTION_FORCE
            .help("Tension on side 2 less that on side 1; has the sign of the velocity when sliding. The rope feels its \
                   negative."),
        dissipated_power: output = DISSIPATED_POWER,
        /// Tension on side 2.
        tension_2: output = real("N", 0.0).nominal(10.0),
    }
}

impl<T: Real> Capstan<T> {
    fn tension(&self) -> T {
        self.preload + self.tension_1
    }

    /// Logarithm of the ratio of the tensions of a rope that slides.
    fn exponent(&self) -> T {
        self.mu_k * self.wrap_angle
    }

    fn force(&self) -> T {
        self.tension() * (self.exponent() * self.friction_share).exp_m1()
    }
}

impl<T: Real> Law for Capstan<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.friction_force = self.force();
        self.dissipated_power = self.friction_force * self.velocity;
        self.tension_2 = self.tension() * (self.exponent() * self.friction_share).exp();
    }
}

impl<T: Real> Derivatives for Capstan<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.friction_share = (self.velocity - self.velocity.abs() * self.friction_share) / self.relaxation_distance;
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

impl Capstan {
    /// Moves by a way in one direction.
    fn follow(&mut self, way: f64) {
        if way == 0.0 {
            return;
        }
        let (sense, ways) = (way.sign(), way.abs() / self.relaxation_distance);
        let missing = sense - self.friction_share;
        self.dissipated_energy += sense * self.relaxation_distance * self.tension() * self.excess_over(missing, ways);
        self.friction_share = (self.friction_share - missing * exp_m1(-ways)).clamp(-1.0, 1.0);
    }

    /// Integral of `exp(mu_k phi z) - 1` over the ways u, with `z = sense - missing exp(-u)`.
    fn excess_over(&self, missing: f64, ways: f64) -> f64 {
        let (sense, exponent) = (self.friction_share + missing, self.exponent());
        let excess = |u: f64| exp_m1(exponent * (sense - missing * exp(-u)));
        // Cut where z = 0, so that the integrand does not change sign, and where z no longer changes.
        let turn = ln(missing.abs()).max(0.0).min(ways);
        let end = ways.min(SETTLED);
        let rest = exp_m1(exponent * sense) * (ways - end);
        integral(&excess, 0.0, turn) + integral(&excess, turn, end) + rest
    }
}

impl Model for Capstan {
    const PRESETS: &'static [Preset] = &[
        Preset {
            name: "winch",
            source: "Example of a rope with three turns around a winch, with a preload of 100 N",
            values: &[
                ("mu_k", 0.2),
                ("wrap_angle", 6.0 * std::f64::consts::PI),
                ("preload", 100.0),
                ("relaxation_distance", 5e-3),
            ],
        },
        Preset {
            name: "bowden_cable",
            source: "Example of a derailleur cable of a bicycle with 180 degrees of bends; mu_k = 0.06 was measured with \
                     180 to 540 degrees (killasgarage.bike, \"Cable Routing - Experimental Results\", 2016)",
            values: &[("mu_k", 0.06), ("wrap_angle", std::f64::consts::PI), ("preload", 20.0)],
        },
    ];

    fn check(&self) -> Result<(), Fault> {
        if self.exponent() > LARGEST {
            let angle = self.wrap_angle;
            return Err(Fault::new(format_args!("wrap_angle = {angle}: mu_k wrap_angle must be <= {LARGEST}")));
        }
        Ok(())
    }

    fn step(&mut self, dt: f64) {
        self.follow(self.velocity * dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        if slope.tension_1 != 0.0 {
            return ramp::advance(self, slope, dt);
        }
        let begin = ramp::Inputs::of(self);
        let motion = Motion { acceleration: slope.velocity, ..Motion::held(self.velocity, 0.0, dt) };
        motion.parts().for_each(|part| self.follow(part.path(part.duration)));
        ramp::set_inputs(self, &begin, slope, dt);
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{LN_2, PI, TAU};

    use approx::{assert_abs_diff_eq, assert_relative_eq};

    use super::*;
    use crate::numerics::random::uniform;
    use crate::numerics::runge_kutta::classical;

    /// A tension of 5 N, two of them preload, and an exponent of 1.2.
    fn bend() -> Capstan {
        Capstan { tension_1: 3.0, preload: 2.0, mu_k: 0.4, wrap_angle: 3.0, ..Default::default() }
    }

    fn moved(bend: &mut Capstan, way: f64) -> f64 {
        bend.velocity = way;
        bend.step(1.0);
        bend.output();
        bend.friction_force
    }

    /// Factors of the table in "Capstan equation", Wikipedia, as printed: coefficient, turns, factor and its digits.
    #[test]
    fn sliding_ropes_have_the_printed_factors() {
        for (mu_k, turns, factor, digit) in [
            (0.1, 1.0, 1.9, 0.1),
            (0.2, 3.0, 43.0, 1.0),
            (0.3, 2.0, 43.0, 1.0),
            (0.3, 3.0, 286.0, 1.0),
            (0.6, 5.0, 153_552_935.0, 1.0),
        ] {
            let mut rope = Capstan { mu_k, wrap_angle: turns * TAU, tension_1: 1.0, ..Default::default() };
            moved(&mut rope, 1.0);
            assert_abs_diff_eq!(rope.tension_2, factor, epsilon = 0.5 * digit);
            assert_relative_eq!(rope.friction_force, rope.tension_2 - 1.0, max_relative = 1e-14);
            moved(&mut rope, -1.0);
            assert_abs_diff_eq!(1.0 / rope.tension_2, factor, epsilon = 0.5 * digit);
        }
    }

    /// After ln 2 relaxation distances from rest half of the angle counts; after another one three quarters.
    #[test]
    fn half_of_the_angle_counts_after_ln_2_ways() {
        for side in [1.0, -1.0] {
            let mut rope = bend();
            moved(&mut rope, side * 1e-3 * LN_2);
            assert_abs_diff_eq!(rope.tension_2, 5.0 * (side * 0.6).exp(), epsilon = 1e-13);
            moved(&mut rope, side * 1e-3 * LN_2);
            assert_abs_diff_eq!(rope.tension_2, 5.0 * (side * 0.9).exp(), epsilon = 1e-13);
        }
    }

    /// The first slope of the force is mu_k phi T / d, and the largest is that of a rope that turns back from sliding.
    #[test]
    fn stiffness_is_that_of_the_page() {
        let mut rope = bend();
        assert_relative_eq!(moved(&mut rope, 1e-12) / 1e-12, 1.2 * 5.0 / 1e-3, max_relative = 1e-7);
        let sliding = moved(&mut rope, 1.0);
        let turning = (sliding - moved(&mut rope, -1e-10)) / 1e-10;
        assert_relative_eq!(turning, 2.0 * 1.2 * 5.0 * 1.2f64.exp() / 1e-3, max_relative = 1e-4);
    }

    /// Bends in series as a `Capstan` each, against one with the sum of mu_k phi, through reversals.
    #[test]
    fn bends_in_series_are_one_with_the_sum_of_their_angles() {
        let bends = [(0.1, PI / 2.0), (0.1, 0.7), (0.25, 1.1), (0.06, PI)];
        let sum: f64 = bends.iter().map(|(mu_k, angle)| mu_k * angle).sum();
        let mut whole = Capstan { mu_k: 1.0, wrap_angle: sum, ..bend() };
        let mut parts = bends.map(|(mu_k, wrap_angle)| Capstan { mu_k, wrap_angle, ..Default::default() });
        let mut draws = (0..).map(|k| uniform(5, 0, k) - 0.5);
        let mut least = f64::INFINITY;
        for _ in 0..200 {
            let way = 4e-3 * draws.next().unwrap();
            moved(&mut whole, way);
            let (mut tension, mut resistance) = (5.0, 0.0);
            for part in &mut parts {
                part.tension_1 = tension;
                resistance += moved(part, way);
                tension = part.tension_2;
            }
            assert_relative_eq!(tension, whole.tension_2, max_relative = 1e-13);
            assert_abs_diff_eq!(resistance, whole.friction_force, epsilon = 1e-13);
            least = least.min(whole.friction_force);
        }
        assert!(least < -1.0, "{least}");
    }

    /// The energy of a long way from rest, `T ((e^a - 1) x - d e^a Ein(a))` with the series
    /// `Ein(a) = a - a^2 / (2 2!) + a^3 / (3 3!) - ...`.
    #[test]
    fn energy_of_a_long_way_is_an_exponential_integral() {
        for exponent in [1e-6f64, 0.5, -0.5, 3.0, -3.0] {
            let mut rope = Capstan { mu_k: exponent.abs(), wrap_angle: 1.0, tension_1: 7.0, ..Default::default() };
            let (mut term, mut series) = (-1.0, 0.0);
            for k in 1..60 {
                term *= -exponent / f64::from(k);
                series += term / f64::from(k);
            }
            let way = 0.1;
            moved(&mut rope, way * exponent.signum());
            let expected = 7.0 * (exponent.exp_m1() * way - 1e-3 * exponent.exp() * series) * exponent.signum();
            assert_relative_eq!(rope.dissipated_energy, expected, max_relative = 1e-9);
        }
    }

    /// The equations as printed, by the classical Runge-Kutta method in 2,000 steps, with work.
    #[test]
    fn a_step_is_the_solution_of_the_printed_equations() {
        let mut draws = (0..).map(|k| uniform(7, 0, k));
        let mut rope = bend();
        for _ in 0..40 {
            rope.tension_1 = 30.0 * draws.next().unwrap();
            rope.velocity = 6e-3 * (draws.next().unwrap() - 0.5);
            let (tension, v) = (2.0 + rope.tension_1, rope.velocity);
            let rate = |[z, _]: [f64; 2]| [(v - v.abs() * z) / 1e-3, tension * ((1.2 * z).exp() - 1.0) * v];
            let at = classical(rate, [rope.friction_share, rope.dissipated_energy], 1.0, 2000);
            rope.step(1.0);
            assert_abs_diff_eq!(rope.friction_share, at[0], epsilon = 1e-11);
            assert_abs_diff_eq!(rope.dissipated_energy, at[1], epsilon = 1e-11);
        }
    }

    /// Energy that the bend gives back at a constant tension was stored before, by its printed slope and Simpson's rule;
    /// the rest is lost.
    #[test]
    fn what_is_given_back_was_stored() {
        let stored = |z: f64| {
            let (count, at) = (200, |y: f64| ((1.2 * y).exp() - 1.0) / (1.0 + y.abs()));
            let h = z / f64::from(count);
            let sum: f64 = (0..count)
                .map(|k| h * f64::from(k))
                .map(|y| h / 6.0 * (at(y) + 4.0 * at(y + 0.5 * h) + at(y + h)))
                .sum();
            1e-3 * 5.0 * sum
        };
        let mut draws = (0..).map(|k| uniform(11, 0, k) - 0.5);
        let (mut rope, mut lost, mut given_back) = (bend(), 0.0, 0.0f64);
        for _ in 0..2000 {
            let before = rope.dissipated_energy;
            moved(&mut rope, 2e-3 * draws.next().unwrap());
            given_back = given_back.min(rope.dissipated_energy - before);
            let now = rope.dissipated_energy - stored(rope.friction_share);
            assert!(now >= lost - 1e-13, "{now} after {lost}");
            lost = now;
        }
        assert!(given_back < -1e-4 && lost > 0.1, "{given_back} {lost}");
    }

    #[test]
    fn ropes_beyond_any_ratio_are_refused() {
        let check = |wrap_angle| Capstan { wrap_angle, mu_k: 0.5, ..Default::default() }.check();
        assert!(check(100.0).is_ok());
        let text = "wrap_angle = 100.5: mu_k wrap_angle must be <= 50";
        assert_eq!(check(100.5).map_err(|fault| fault.to_string()), Err(text.to_owned()));
        // At the limit the rope still has its numbers, without cancellation at small shares.
        let mut rope = Capstan { wrap_angle: 100.0, mu_k: 0.5, tension_1: 1.0, ..Default::default() };
        moved(&mut rope, 1e-12);
        assert_relative_eq!(rope.dissipated_energy, 0.5 * 50.0 * 1e-12 * 1e-9, max_relative = 1e-6);
        assert_relative_eq!(moved(&mut rope, 1.0), 50f64.exp(), max_relative = 1e-12);
        assert_relative_eq!(moved(&mut rope, -1.0), -1.0, max_relative = 1e-12);
    }

    /// Equal tensions on both sides, and no force, without friction or tension.
    #[test]
    fn no_friction_without_angle_or_tension() {
        let mut rope = Capstan { wrap_angle: 0.0, ..bend() };
        assert_eq!([moved(&mut rope, 1.0), rope.tension_2, rope.dissipated_energy], [0.0, 5.0, 0.0]);
        let mut slack = Capstan { tension_1: 0.0, preload: 0.0, ..bend() };
        assert_eq!([moved(&mut slack, 1.0), slack.tension_2, slack.dissipated_energy], [0.0; 3]);
    }
}
