use crate::host::oscillator::undamped;
use crate::host::vertical::GRAVITY;
use crate::model::{Derivatives, Law, Meaning, Model, ModelExchange, real};
use crate::number::Real;

crate::model! {
    /// A block on a moving belt, held by a spring: the one-degree-of-freedom benchmark of stick-slip.
    ///
    /// # Equations
    ///
    /// ```text
    /// m d2x/dt2 = -k x - f_f       (6.32)
    /// v   = dx/dt - v_b
    /// f_e = -k x
    /// f_n = m g
    /// ```
    ///
    /// | symbol | variable         | unit | meaning                                    |
    /// |--------|------------------|------|--------------------------------------------|
    /// | f_f    | `friction_force` | N    | friction force of the contact              |
    /// | m      | `mass`           | kg   | mass of the block                          |
    /// | k      | `stiffness`      | N/m  | stiffness of the spring                    |
    /// | v_b    | `belt_velocity`  | m/s  | velocity of the belt                       |
    /// | g      | `gravity`        | m/s2 | acceleration of gravity                    |
    /// | x      | `position`       | m    | position of the block, spring relaxed at 0 |
    /// | dx/dt  | `block_velocity` | m/s  | velocity of the block                      |
    /// | v      | `velocity`       | m/s  | velocity of the block relative to the belt |
    /// | f_e    | `external_force` | N    | spring force on the block                  |
    /// | f_n    | `normal_force`   | N    | weight of the block on the belt            |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` when sliding; the block feels `-friction_force`. While the block
    /// sticks, `friction_force` is `external_force`: negative as the belt pulls it to positive positions.
    ///
    /// # Step
    /// The system is linear, so the step is exact for a held friction force and for one that moves linearly. All
    /// outputs are states or follow from states alone: there is no direct feed-through from input to output.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// The friction force comes from the master: held over a step, it makes the coupling a method of first order.
    /// `stiffness` = 0 is a free block.
    ///
    /// # Source
    /// Equation (6.32) and Table 6.1 of F. Novais, "A critical analysis on friction force models in dynamical systems",
    /// MSc thesis, University of Minho (2024): $m = 1$ kg, $g = 9.81$ m/s2, $k = 2$ N/m, $v_b = 0.1$ m/s, $x(0) = 0$,
    /// $dx/dt(0) = 0.1$ m/s.
    ///
    /// # Example
    /// ```
    /// use stribeck::host::BeltRig;
    /// use stribeck::model::Model;
    /// let mut rig = BeltRig { position: 0.1, block_velocity: 0.0, ..Default::default() };
    /// rig.step(std::f64::consts::PI / 2f64.sqrt()); // half a period of sqrt(k / m)
    /// assert!((rig.position + 0.1).abs() < 1e-15);
    /// ```
    BeltRig: "Block on a moving belt, held by a spring" {
        /// Friction force; has the sign of the velocity when sliding. Body 1 feels its negative.
        friction_force: input = real("N", 0.0).means(Meaning::FrictionForce),
        /// Mass of the block.
        mass: fixed = real("kg", 1.0).positive(),
        /// Stiffness of the spring.
        stiffness: fixed = real("N/m", 2.0).at_least(0.0),
        /// Velocity of the belt.
        belt_velocity: tunable = real("m/s", 0.1),
        /// Position of the block; the spring is relaxed at 0.
        position: state_output = real("m", 0.0),
        /// Velocity of the block.
        block_velocity: state_output = real("m/s", 0.1),
        /// Velocity of the block relative to the belt.
        velocity: output = real("m/s", 0.0).means(Meaning::Velocity),
        /// Spring force on the block.
        external_force: output = real("N", 0.0).means(Meaning::ExternalForce),
        /// Acceleration of gravity.
        gravity: tunable = real("m/s2", GRAVITY).at_least(0.0),
        /// Weight of the block on the belt.
        normal_force: output = real("N", 0.0).means(Meaning::NormalForce),
    }
}

impl<T: Real> Law for BeltRig<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.velocity = self.block_velocity - self.belt_velocity;
        self.external_force = -self.stiffness * self.position;
        self.normal_force = self.mass * self.gravity;
    }
}

impl<T: Real> Derivatives for BeltRig<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.position = self.block_velocity;
        rate.block_velocity = self.acceleration();
    }
}

impl<T: Real> BeltRig<T> {
    /// Eq. (6.32).
    fn acceleration(&self) -> T {
        -(self.stiffness * self.position + self.friction_force) / self.mass
    }
}

impl BeltRig {
    /// Exact solution of (6.32) while the friction force moves at a constant rate.
    fn advance(&mut self, force_rate: f64, t: f64) {
        let jerk = -(self.stiffness * self.block_velocity + force_rate) / self.mass;
        let (state, rates) = ([self.position, self.block_velocity], [self.acceleration(), jerk]);
        [self.position, self.block_velocity] = undamped(state, rates, self.stiffness / self.mass, t);
    }
}

impl Model for BeltRig {
    const PIECEWISE_LINEAR: bool = true;
    fn step(&mut self, dt: f64) {
        self.advance(0.0, dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        self.advance(slope.friction_force, dt);
        self.friction_force += slope.friction_force * dt;
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    #[test]
    fn weight_presses_the_block_on_the_belt() {
        let mut rig = BeltRig { mass: 2.0, gravity: 1.62, ..Default::default() };
        rig.output();
        assert_eq!(rig.normal_force, 3.24);
    }

    /// The energy of the undamped oscillator with a held force is constant.
    #[test]
    fn held_force_conserves_the_shifted_energy() {
        let mut rig = BeltRig { friction_force: 0.3, ..Default::default() };
        let energy = |rig: &BeltRig| 0.5 * rig.block_velocity.powi(2) + rig.position.powi(2) + 0.3 * rig.position;
        let before = energy(&rig);
        for dt in [1e-6, 1e-3, 0.1, 3.0, 50.0] {
            rig.step(dt);
            assert!((energy(&rig) - before).abs() < 1e-13, "{dt}");
        }
    }

    /// A force that grows linearly, without spring: x = x' t - f' t^3 / 6 m.
    #[test]
    fn ramp_on_a_free_block_is_a_cubic() {
        let mut rig = BeltRig { stiffness: 0.0, mass: 2.0, block_velocity: 0.5, ..Default::default() };
        let slope = BeltRig { friction_force: 3.0, ..rig };
        rig.step_ramp(&slope, 2.0);
        assert_abs_diff_eq!(rig.position, 1.0 - 3.0 * 8.0 / 12.0, epsilon = 1e-15);
        assert_abs_diff_eq!(rig.block_velocity, 0.5 - 3.0 * 4.0 / 4.0, epsilon = 1e-15);
        assert_eq!(rig.friction_force, 6.0);
    }
}
