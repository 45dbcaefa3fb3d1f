use crate::host::oscillator::undamped;
use crate::host::vertical::GRAVITY;
use crate::model::{Derivatives, Law, Meaning, Model, ModelExchange, ramp, real};
use crate::number::Real;

crate::model! {
    /// A block on a belt whose motion is prescribed, held by a spring: `BeltRig` with a belt that speeds up and slows
    /// down.
    ///
    /// # Equations
    ///
    /// ```text
    /// m d2x/dt2 = -k x - f_f
    /// v   = dx/dt - v_b
    /// f_e = -k x - m a_b
    /// f_n = m g
    /// ```
    ///
    /// | symbol | variable            | unit | meaning                                                       |
    /// |--------|---------------------|------|---------------------------------------------------------------|
    /// | f_f    | `friction_force`    | N    | friction force of the contact                                 |
    /// | v_b    | `belt_velocity`     | m/s  | velocity of the belt                                          |
    /// | a_b    | `belt_acceleration` | m/s2 | acceleration of the belt                                      |
    /// | m      | `mass`              | kg   | mass of the block                                             |
    /// | k      | `stiffness`         | N/m  | stiffness of the spring                                       |
    /// | g      | `gravity`           | m/s2 | acceleration of gravity                                       |
    /// | x      | `position`          | m    | position of the block, spring relaxed at 0                    |
    /// | dx/dt  | `block_velocity`    | m/s  | velocity of the block                                         |
    /// | v      | `velocity`          | m/s  | velocity of the block relative to the belt                    |
    /// | f_e    | `external_force`    | N    | spring force and force of inertia, in the frame of the belt   |
    /// | f_n    | `normal_force`      | N    | weight of the block on the belt                               |
    ///
    /// The force of inertia $-m a_b$ belongs to `external_force` because a contact that sticks must carry the block
    /// along with the belt: with $f_f = f_e$ the block has the acceleration of the belt.
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` when sliding; the block feels `-friction_force`. Positions and the
    /// velocities of block and belt are positive in the same direction.
    ///
    /// # Step
    /// The system is linear, so the step is exact for a held friction force and for one that moves linearly. The motion
    /// of the belt affects only the outputs, which never follow the friction force at once.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// `belt_velocity` and `belt_acceleration` are two inputs, and nothing checks that one is the rate of the other. With
    /// a wrong acceleration a block that should stick slides on and is caught again. The friction force comes from the
    /// master: held over a step, it makes the coupling a method of first order. `stiffness` = 0 is a free block.
    ///
    /// # Source
    /// The benchmark of F. Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis,
    /// University of Minho (2024), equation (6.32), with its numbers of Table 6.1: $m = 1$ kg, $g = 9.81$ m/s2, $k = 2$
    /// N/m, $v_b = 0.1$ m/s, $x(0) = 0$, $dx/dt(0) = 0.1$ m/s. A belt that accelerates is our addition.
    ///
    /// # Example
    /// ```
    /// use stribeck::host::BeltDrive;
    /// use stribeck::model::Law;
    /// let mut drive = BeltDrive { position: 0.1, belt_acceleration: 0.5, ..Default::default() };
    /// drive.output();
    /// assert_eq!(drive.external_force, -0.7); // 0.2 N of the spring, 0.5 N of inertia
    /// ```
    BeltDrive: "Block on a belt of prescribed motion, held by a spring" {
        /// Friction force; has the sign of the velocity when sliding. Body 1 feels its negative.
        friction_force: input = real("N", 0.0).means(Meaning::FrictionForce),
        /// Velocity of the belt.
        belt_velocity: input = real("m/s", 0.1),
        /// Acceleration of the belt.
        belt_acceleration: input = real("m/s2", 0.0),
        /// Mass of the block.
        mass: fixed = real("kg", 1.0).positive(),
        /// Stiffness of the spring.
        stiffness: fixed = real("N/m", 2.0).at_least(0.0),
        /// Acceleration of gravity.
        gravity: tunable = real("m/s2", GRAVITY).at_least(0.0),
        /// Position of the block; the spring is relaxed at 0.
        position: state_output = real("m", 0.0),
        /// Velocity of the block.
        block_velocity: state_output = real("m/s", 0.1),
        /// Velocity of the block relative to the belt.
        velocity: output = real("m/s", 0.0).means(Meaning::Velocity),
        /// Spring force and force of inertia on the block, in the frame of the belt.
        external_force: output = real("N", 0.0).means(Meaning::ExternalForce),
        /// Weight of the block on the belt.
        normal_force: output = real("N", 0.0).means(Meaning::NormalForce),
    }
}

impl<T: Real> Law for BeltDrive<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.velocity = self.block_velocity - self.belt_velocity;
        self.external_force = -self.stiffness * self.position - self.mass * self.belt_acceleration;
        self.normal_force = self.mass * self.gravity;
    }
}

impl<T: Real> Derivatives for BeltDrive<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.position = self.block_velocity;
        rate.block_velocity = self.acceleration();
    }
}

impl<T: Real> BeltDrive<T> {
    fn acceleration(&self) -> T {
        -(self.stiffness * self.position + self.friction_force) / self.mass
    }
}

impl BeltDrive {
    fn advance(&mut self, force_rate: f64, t: f64) {
        let jerk = -(self.stiffness * self.block_velocity + force_rate) / self.mass;
        let (state, rates) = ([self.position, self.block_velocity], [self.acceleration(), jerk]);
        [self.position, self.block_velocity] = undamped(state, rates, self.stiffness / self.mass, t);
    }
}

impl Model for BeltDrive {
    const PIECEWISE_LINEAR: bool = true;
    fn step(&mut self, dt: f64) {
        self.advance(0.0, dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        let begin = ramp::Inputs::of(self);
        self.advance(slope.friction_force, dt);
        ramp::set_inputs(self, &begin, slope, dt);
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    /// A contact that carries all other forces keeps the block on the belt, whatever the belt does.
    #[test]
    fn a_block_that_sticks_moves_with_the_belt() {
        for (position, acceleration) in [(0.0, 0.0), (0.3, 0.0), (-0.2, 0.7), (0.1, -4.0)] {
            let mut drive = BeltDrive {
                position,
                belt_acceleration: acceleration,
                mass: 3.0,
                stiffness: 7.0,
                ..Default::default()
            };
            drive.output();
            drive.friction_force = drive.external_force;
            let mut rate = drive;
            drive.derivatives(&mut rate);
            assert!((rate.block_velocity - acceleration).abs() < 1e-15, "{}", rate.block_velocity);
        }
    }

    /// The work of spring and friction is the change of the kinetic energy, in any frame: here in that of a belt with
    /// constant acceleration, in which the block feels `external_force` less the friction force.
    #[test]
    fn energy_in_the_frame_of_the_belt() {
        let (belt_acceleration, friction_force, span) = (0.4, 0.25, 1.7);
        let mut drive = BeltDrive { belt_acceleration, friction_force, ..Default::default() };
        let slope = BeltDrive { friction_force: 0.0, belt_velocity: 0.4, belt_acceleration: 0.0, ..drive };
        let (mut work, pieces) = (0.0, 20_000);
        for _ in 0..pieces {
            let power = |drive: &mut BeltDrive| {
                drive.output();
                (drive.external_force - friction_force) * drive.velocity
            };
            let before = power(&mut drive);
            drive.step_ramp(&slope, span / f64::from(pieces));
            work += 0.5 * (before + power(&mut drive)) * span / f64::from(pieces);
        }
        assert_abs_diff_eq!(drive.belt_velocity, 0.1 + 0.4 * span, epsilon = 1e-12);
        assert!((0.5 * drive.velocity * drive.velocity - work).abs() < 1e-8, "{work} J");
    }

    /// Without spring the jerk alone moves it: x = x' t - f' t^3 / 6 m.
    #[test]
    fn all_inputs_move_over_a_ramp() {
        let mut drive = BeltDrive { stiffness: 0.0, mass: 2.0, block_velocity: 0.5, ..Default::default() };
        let slope = BeltDrive { friction_force: 3.0, belt_velocity: 0.25, belt_acceleration: -1.0, ..drive };
        drive.step_ramp(&slope, 2.0);
        assert_abs_diff_eq!(drive.position, 1.0 - 3.0 * 8.0 / 12.0, epsilon = 1e-15);
        assert_abs_diff_eq!(drive.block_velocity, 0.5 - 3.0 * 4.0 / 4.0, epsilon = 1e-15);
        assert_eq!([drive.friction_force, drive.belt_velocity, drive.belt_acceleration], [6.0, 0.6, -2.0]);
    }
}
