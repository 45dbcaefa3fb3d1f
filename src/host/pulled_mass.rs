use crate::host::oscillator::damped;
use crate::host::vertical::GRAVITY;
use crate::model::{Derivatives, Law, Meaning, Model, ModelExchange, ramp, real};
use crate::number::Real;

crate::model! {
    /// A mass on the ground that a spring pulls along; the end of the spring moves at a given velocity.
    ///
    /// # Equations
    ///
    /// ```text
    /// m d2x/dt2 = f_e - f_f
    /// de/dt = u - dx/dt
    /// f_e = f_0 + k e + c (u - dx/dt)
    /// f_n = m g
    /// ```
    ///
    /// | symbol | variable         | unit  | meaning                                             |
    /// |--------|------------------|-------|-----------------------------------------------------|
    /// | f_f    | `friction_force` | N     | friction force between mass and ground              |
    /// | u      | `pull_velocity`  | m/s   | velocity of the end of the spring                   |
    /// | m      | `mass`           | kg    | mass                                                |
    /// | k      | `stiffness`      | N/m   | stiffness of the spring                             |
    /// | c      | `damping`        | N.s/m | damping beside the spring                           |
    /// | f_0    | `preload`        | N     | force of the spring where its elongation is 0       |
    /// | g      | `gravity`        | m/s2  | acceleration of gravity                             |
    /// | x      | `position`       | m     | position of the mass                                |
    /// | dx/dt  | `velocity`       | m/s   | velocity of the mass                                |
    /// | e      | `elongation`     | m     | elongation of the spring                            |
    /// | f_e    | `external_force` | N     | force of spring and damper on the mass              |
    /// | f_n    | `normal_force`   | N     | weight of the mass                                  |
    ///
    /// While the mass sticks, the force on the contact grows at the rate $k u$. Where it breaks away, at the static
    /// level, depends on that rate in laws with a memory.
    ///
    /// # Sign
    /// A positive `elongation` pulls the mass to positive positions. `friction_force` has the sign of `velocity` when
    /// sliding; the mass feels `-friction_force`.
    ///
    /// # Step
    /// The system is linear, so the step is exact for held inputs and for inputs that move linearly, with any damping.
    /// Outputs follow from states and, with damping, from the velocity of the pull: there is no direct feed-through of
    /// the friction force.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// The spring pushes as well as it pulls. With `damping` a jump of `pull_velocity` is a jump of the force. The
    /// friction force comes from the master: held over a step, it makes the coupling a method of first order.
    ///
    /// # Source
    /// A mass pulled by a spring is the usual experiment on stick-slip, such as in Canudas de Wit, Olsson, Astrom and
    /// Lischinsky (1995), doi:10.1109/9.376053. Mass and gravity are those of Table 6.1 of F. Novais, "A critical
    /// analysis on friction force models in dynamical systems", MSc thesis, University of Minho (2024). Stiffness and
    /// velocity of the pull are chosen, equal to those of its belt: seen from the belt, the block of `BeltRig` is a mass
    /// that is pulled. A law with its bristles at 1e5 N/m is 50,000 times stiffer than this spring: at the default
    /// levels the mass breaks away after 7.36 s at 1.47 N, while the bristles bend by 15 um.
    ///
    /// # Example
    /// ```
    /// use stribeck::host::PulledMass;
    /// use stribeck::model::Law;
    /// let mut pulled = PulledMass { elongation: 0.73575, ..Default::default() };
    /// pulled.output();
    /// assert_eq!(pulled.external_force, 0.15 * pulled.normal_force); // on the verge of breaking away at mu = 0.15
    /// ```
    PulledMass: "Mass pulled by a spring" {
        /// Friction force; has the sign of the velocity when sliding. Body 1 feels its negative.
        friction_force: input = real("N", 0.0).means(Meaning::FrictionForce),
        /// Velocity of the end of the spring (default chosen).
        pull_velocity: input = real("m/s", 0.1),
        /// Mass.
        mass: fixed = real("kg", 1.0).positive(),
        /// Stiffness of the spring (default chosen).
        stiffness: fixed = real("N/m", 2.0).at_least(0.0),
        /// Damping beside the spring.
        damping: fixed = real("N.s/m", 0.0).at_least(0.0),
        /// Force of the spring where its elongation is 0.
        preload: fixed = real("N", 0.0),
        /// Acceleration of gravity.
        gravity: tunable = real("m/s2", GRAVITY).at_least(0.0),
        /// Position of the mass.
        position: state_output = real("m", 0.0).nominal(1e-2),
        /// Velocity of the mass.
        velocity: state_output = real("m/s", 0.0).nominal(0.1).means(Meaning::Velocity),
        /// Elongation of the spring.
        elongation: state_output = real("m", 0.0).nominal(1e-2),
        /// Force of spring and damper on the mass.
        external_force: output = real("N", 0.0).means(Meaning::ExternalForce),
        /// Weight of the mass.
        normal_force: output = real("N", 0.0).means(Meaning::NormalForce),
    }
}

impl<T: Real> PulledMass<T> {
    fn pull(&self) -> T {
        self.preload + self.stiffness * self.elongation + self.damping * (self.pull_velocity - self.velocity)
    }

    fn acceleration(&self) -> T {
        (self.pull() - self.friction_force) / self.mass
    }
}

impl<T: Real> Law for PulledMass<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.external_force = self.pull();
        self.normal_force = self.mass * self.gravity;
    }
}

impl<T: Real> Derivatives for PulledMass<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.position = self.velocity;
        rate.velocity = self.acceleration();
        rate.elongation = self.pull_velocity - self.velocity;
    }
}

impl PulledMass {
    /// Exact motion while friction force and pull velocity move at constant rates. In a frame that begins at rest and
    /// has the acceleration u' of the pull, the end of the spring moves at constant velocity.
    fn advance(&mut self, [force_rate, speeding]: [f64; 2], t: f64) {
        let pull = self.preload + self.stiffness * self.elongation + self.damping * self.pull_velocity;
        let resting = pull - self.friction_force;
        let forces = [resting / self.mass - speeding, (self.stiffness * self.pull_velocity - force_rate) / self.mass];
        let oscillator = [0.5 * self.damping / self.mass, self.stiffness / self.mass];
        let [shift, velocity] = damped(self.velocity, forces, oscillator, t);
        self.elongation += self.pull_velocity * t - shift;
        self.position += shift + 0.5 * speeding * t * t;
        self.velocity = velocity + speeding * t;
    }
}

impl Model for PulledMass {
    const PIECEWISE_LINEAR: bool = true;
    fn step(&mut self, dt: f64) {
        self.advance([0.0; 2], dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        let begin = ramp::Inputs::of(self);
        self.advance([slope.friction_force, slope.pull_velocity], dt);
        ramp::set_inputs(self, &begin, slope, dt);
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::host::BeltRig;
    use crate::model::integrate;

    /// Seen from the belt, the block of the rig is pulled backwards by a spring whose end moves at -v_b.
    #[test]
    fn it_is_the_belt_rig_seen_from_the_belt() {
        let mut rig = BeltRig { friction_force: -0.6, position: 0.4, block_velocity: -0.2, ..Default::default() };
        let mut pulled = PulledMass {
            friction_force: -0.6,
            pull_velocity: -0.1,
            velocity: -0.3,
            elongation: -0.4,
            ..Default::default()
        };
        for dt in [1e-6, 1e-3, 0.1, 3.0, 50.0] {
            let moved = pulled.position;
            let travel = rig.position;
            rig.step(dt);
            pulled.step(dt);
            assert!((pulled.elongation + rig.position).abs() < 1e-14, "{dt}");
            assert!((pulled.velocity - (rig.block_velocity - 0.1)).abs() < 1e-14, "{dt}");
            assert!((pulled.position - moved - (rig.position - travel - 0.1 * dt)).abs() < 1e-14, "{dt}");
        }
    }

    /// Every damping, against the integration of the rates with error control.
    #[test]
    fn ramps_agree_with_the_integrated_rates() {
        for damping in [0.0, 0.3, 2.0 * 2f64.sqrt(), 5.0, 60.0] {
            for t in [1e-3, 0.5, 4.0] {
                let begin = PulledMass { damping, elongation: 0.2, velocity: -0.1, preload: 0.3, ..Default::default() };
                let slope = PulledMass { friction_force: 0.4, pull_velocity: -0.3, ..ramp::held_inputs(&begin) };
                let (mut exact, mut integrated) = (begin, begin);
                exact.step_ramp(&slope, t);
                integrate::advance::<_, 3>(&mut integrated, &slope, t);
                for (name, pair) in [
                    ("position", [exact.position, integrated.position]),
                    ("velocity", [exact.velocity, integrated.velocity]),
                    ("elongation", [exact.elongation, integrated.elongation]),
                    ("pull_velocity", [exact.pull_velocity, integrated.pull_velocity]),
                ] {
                    assert!((pair[0] - pair[1]).abs() < 1e-9, "{damping} {t}: {name} {pair:?}");
                }
            }
        }
    }

    /// A contact that sticks carries the force of spring and damper, which grows at the rate k u.
    #[test]
    fn stuck_mass_loads_the_spring_at_a_constant_rate() {
        let mut pulled = PulledMass { stiffness: 30.0, damping: 4.0, ..Default::default() };
        pulled.output();
        let begin = pulled.external_force;
        pulled.friction_force = begin;
        let slope = PulledMass { friction_force: 3.0, ..ramp::held_inputs(&pulled) };
        pulled.step_ramp(&slope, 0.25);
        pulled.output();
        assert_abs_diff_eq!(pulled.external_force - begin, 0.75, epsilon = 1e-15);
        assert!(pulled.velocity.abs() < 1e-16 && pulled.position.abs() < 1e-16);
    }
}
