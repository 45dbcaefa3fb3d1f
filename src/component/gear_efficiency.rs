use crate::contact::motion::Motion;
use crate::contact::quantities::{DISSIPATED_ENERGY, DISSIPATED_POWER, FRICTION_FORCE, VELOCITY};
use crate::model::{Derivatives, Law, Model, ModelExchange, Preset, ramp, real};
use crate::number::Real;
use crate::number::elementary::exp_m1;

crate::model! {
    /// Gear whose friction is a part of the force that it transmits, one part when it is driven and another one when the
    /// load drives it back, with a state in place of the sign of the velocity.
    ///
    /// # Equations
    ///
    /// ```text
    /// dz/dt = (v - |v| z) / h
    /// f_f   = (mu_d + mu_b) / 2 |f| z + (mu_d - mu_b) / 2 f z^2
    /// ```
    ///
    /// The state comes to $z = sgn(v)$ after some $h$ of motion. Then
    ///
    /// ```text
    /// f_f = mu_d |f| sgn(v)           f v > 0, driving
    /// f_f = mu_b |f| sgn(v)           f v < 0, driven back
    /// ```
    ///
    /// | symbol | variable              | unit | meaning                                                     |
    /// |--------|-----------------------|------|-------------------------------------------------------------|
    /// | v      | `velocity`            | m/s  | velocity of the output                                      |
    /// | f      | `transmitted_force`   | N    | force of the motor at the output, positive along `velocity` |
    /// | mu_d   | `mu_driving`          | 1    | part of the force that is lost when driving                 |
    /// | mu_b   | `mu_backdriving`      | 1    | part of the force that resists when driven back             |
    /// | h      | `relaxation_distance` | m    | distance after which 1/e of a change of z is left           |
    /// | z      | `direction`           | 1    | direction of the motion, -1 to 1                            |
    /// | f_f    | `friction_force`      | N    | friction force                                              |
    ///
    /// Of a gear that turns the velocity is in rad/s, forces are torques in N.m, and $h$ is an angle in rad. With the
    /// efficiencies $e_d$ and $e_b$ of driving and driving back, $mu_d = 1 - e_d$ and $mu_b = 1 - e_b$.
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` once the gear has moved by some $h$ in one direction; body 1 feels
    /// `-friction_force`. Dissipated power is `friction_force * velocity`, negative for short ways after a reversal. At a
    /// constant force the gear is passive: it gives back no more than it has stored, which is
    ///
    /// ```text
    /// E = h |f| ((mu_d + mu_b) z^2 / 4 + (mu_d - mu_b) sgn(f) z^3 / 6)
    /// ```
    ///
    /// # Step
    /// Exact for held inputs, energy included: the state is an exponential of the way. For a velocity that moves linearly
    /// as well, as long as the force is held; else by the rates, with error control.
    ///
    /// A master that integrates a mass m with the force it reads couples it explicitly to the stiffness
    /// $mu_d |f| / h$ of the first way.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// A gear at rest holds the force that it had, and creeps under one that swings, as Dahl's law does. $mu_b >= 1$
    /// resists more than the load pushes: it holds itself. No friction without force. $h$ is the elastic way of the teeth,
    /// a small part of a tooth.
    ///
    /// # Source
    /// Equations: a request to MuJoCo, google-deepmind/mujoco, issue 3528 (2026), with the mean and half of the
    /// difference of our coefficients as parameters. The start values are chosen.
    ///
    /// # Example
    /// ```
    /// use stribeck::component::GearEfficiency;
    /// use stribeck::model::{Law, Model};
    /// let mut gear = GearEfficiency { velocity: 1.0, transmitted_force: 10.0, ..Default::default() };
    /// gear.step(1.0);
    /// gear.output();
    /// assert!((gear.friction_force - 2.0).abs() < 1e-12); // mu_driving f
    /// (gear.velocity, gear.transmitted_force) = (1.0, -10.0);
    /// gear.output();
    /// assert!((gear.friction_force - 3.0).abs() < 1e-12); // the load drives: mu_backdriving |f|
    /// ```
    GearEfficiency: "Gear with an efficiency of driving and one of driving back" {
        velocity: input = VELOCITY,
        /// Force of the motor at the output, positive in the direction of the velocity (default chosen).
        transmitted_force: input = real("N", 10.0).nominal(10.0).odd(),
        /// Part of the force that is lost when driving (default chosen).
        mu_driving: tunable = real("1", 0.2).at_least(0.0),
        /// Part of the force that resists when the load drives back (default chosen).
        mu_backdriving: tunable = real("1", 0.3).at_least(0.0),
        /// Distance after which 1/e of a change of the direction is left (default chosen).
        relaxation_distance: tunable = real("m", 1e-3).positive().nominal(1e-3).shown_in("mm"),
        /// Direction of the motion.
        direction: state = real("1", 0.0).at_least(-1.0).at_most(1.0).odd(),
        dissipated_energy: state_output = DISSIPATED_ENERGY.nominal(0.1),
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
    }
}

impl<T: Real> GearEfficiency<T> {
    /// Factors of z and of z^2.
    fn factors(&self) -> [T; 2] {
        let (half, force) = (T::from(0.5), self.transmitted_force);
        let [mean, difference] =
            [self.mu_driving + self.mu_backdriving, self.mu_driving - self.mu_backdriving].map(|sum| half * sum);
        [mean * force.abs(), difference * force]
    }

    fn force(&self) -> T {
        let [even, odd] = self.factors();
        self.direction * (even + odd * self.direction)
    }
}

impl<T: Real> Law for GearEfficiency<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.friction_force = self.force();
        self.dissipated_power = self.friction_force * self.velocity;
    }
}

impl<T: Real> Derivatives for GearEfficiency<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.direction = (self.velocity - self.velocity.abs() * self.direction) / self.relaxation_distance;
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

impl GearEfficiency {
    /// Moves by a way in one direction.
    fn follow(&mut self, way: f64) {
        if way == 0.0 {
            return;
        }
        let (sense, ways) = (way.sign(), way.abs() / self.relaxation_distance);
        // z = s - missing exp(-u) over the ways u; the integrals of z and of z^2 over the way.
        let missing = sense - self.direction;
        let [once, twice] = [-exp_m1(-ways), -0.5 * exp_m1(-2.0 * ways)];
        let [first, second] =
            [ways - sense * missing * once, sense * (ways - 2.0 * sense * missing * once + missing * missing * twice)];
        let [even, odd] = self.factors();
        self.dissipated_energy += self.relaxation_distance * (even * first + odd * second);
        self.direction = (self.direction + missing * once).clamp(-1.0, 1.0);
    }
}

impl Model for GearEfficiency {
    const PRESETS: &'static [Preset] = &[Preset {
        name: "self_locking",
        source: "Example of a worm gear, in N.m and rad/s, which the load cannot drive back",
        values: &[("mu_driving", 0.55), ("mu_backdriving", 1.2), ("relaxation_distance", 0.01)],
    }];

    fn step(&mut self, dt: f64) {
        self.follow(self.velocity * dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        if slope.transmitted_force != 0.0 {
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
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::numerics::random::uniform;
    use crate::numerics::runge_kutta::classical;

    fn gear(transmitted_force: f64) -> GearEfficiency {
        GearEfficiency { transmitted_force, mu_driving: 0.1, mu_backdriving: 0.4, ..Default::default() }
    }

    fn moved(gear: &mut GearEfficiency, way: f64) -> f64 {
        gear.velocity = way;
        gear.step(1.0);
        gear.output();
        gear.friction_force
    }

    /// Driving and driven back, in both directions.
    #[test]
    fn each_direction_of_power_has_its_loss() {
        for (force, way, expected) in [(20.0, 1.0, 2.0), (-20.0, -1.0, -2.0), (-20.0, 1.0, 8.0), (20.0, -1.0, -8.0)] {
            assert_abs_diff_eq!(moved(&mut gear(force), way), expected, epsilon = 1e-14);
        }
        assert_eq!(moved(&mut gear(0.0), 1.0), 0.0);
    }

    /// After ln 2 relaxation distances from rest z = 1/2: the force by hand.
    #[test]
    fn half_of_the_direction_is_there_after_ln_2_ways() {
        let force = moved(&mut gear(20.0), 1e-3 * std::f64::consts::LN_2);
        assert_abs_diff_eq!(force, 0.25 * 20.0 * 0.5 - 0.15 * 20.0 * 0.25, epsilon = 1e-14);
    }

    /// The equations as printed, by the classical Runge-Kutta method in 2,000 steps, with work.
    #[test]
    fn a_step_is_the_solution_of_the_printed_equations() {
        let mut draws = (0..).map(|k| uniform(7, 0, k) - 0.5);
        let mut law = gear(0.0);
        for _ in 0..40 {
            law.transmitted_force = 30.0 * draws.next().unwrap();
            law.velocity = 6e-3 * draws.next().unwrap();
            let (f, v) = (law.transmitted_force, law.velocity);
            let rate = |[z, _]: [f64; 2]| [(v - v.abs() * z) / 1e-3, (0.25 * f.abs() * z - 0.15 * f * z * z) * v];
            let at = classical(rate, [law.direction, law.dissipated_energy], 1.0, 2000);
            law.step(1.0);
            assert_abs_diff_eq!(law.direction, at[0], epsilon = 1e-11);
            assert_abs_diff_eq!(law.dissipated_energy, at[1], epsilon = 1e-12);
        }
    }

    /// Energy that the gear gives back at a constant force was stored before, by the closed form; the rest is lost.
    #[test]
    fn what_is_given_back_was_stored() {
        let mut draws = (0..).map(|k| uniform(11, 0, k) - 0.5);
        for force in [20.0, -20.0] {
            let mut law = gear(force);
            let stored = |law: &GearEfficiency| {
                let z = law.direction;
                1e-3 * 20.0 * (0.5 * z * z / 4.0 - 0.3 * force.signum() * z * z * z / 6.0)
            };
            let (mut lost, mut given_back) = (0.0, 0.0f64);
            for _ in 0..2000 {
                let before = law.dissipated_energy;
                moved(&mut law, 2e-3 * draws.next().unwrap());
                given_back = given_back.min(law.dissipated_energy - before);
                let now = law.dissipated_energy - stored(&law);
                assert!(now >= lost - 1e-15, "{now} after {lost}");
                lost = now;
            }
            assert!(given_back < -1e-4 && lost > 0.1, "{given_back} {lost}");
        }
    }
}
