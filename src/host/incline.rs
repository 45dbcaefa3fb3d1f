use std::f64::consts::FRAC_PI_2;

use crate::host::oscillator::undamped;
use crate::host::vertical::GRAVITY;
use crate::model::{Derivatives, Law, Meaning, Model, ModelExchange, ramp, real};
use crate::number::Real;
use crate::number::elementary::cos;

crate::model! {
    /// A block on an inclined plane whose angle is an input: the oldest way to measure a coefficient of friction.
    ///
    /// # Equations
    ///
    /// ```text
    /// m d2x/dt2 = m g sin(alpha) - f_f
    /// f_e = m g sin(alpha)
    /// f_n = m g cos(alpha)
    /// ```
    ///
    /// A block at rest begins to slide at the angle at which $f_e$ reaches the static level, and slides at constant
    /// velocity at that of the kinetic level:
    ///
    /// ```text
    /// tan(alpha) = mu       (3.2)
    /// ```
    ///
    /// | symbol | variable         | unit | meaning                                              |
    /// |--------|------------------|------|------------------------------------------------------|
    /// | f_f    | `friction_force` | N    | friction force of the contact                        |
    /// | alpha  | `angle`          | rad  | angle of the plane above the horizontal              |
    /// | m      | `mass`           | kg   | mass of the block                                    |
    /// | g      | `gravity`        | m/s2 | acceleration of gravity                              |
    /// | x      | `position`       | m    | position of the block, positive down the slope       |
    /// | dx/dt  | `velocity`       | m/s  | velocity of the block, positive down the slope       |
    /// | f_e    | `external_force` | N    | weight along the plane                               |
    /// | f_n    | `normal_force`   | N    | weight across the plane                              |
    ///
    /// # Sign
    /// Positions, velocities and forces along the plane are positive in the direction in which a plane with a positive
    /// angle descends. `friction_force` has the sign of `velocity` when sliding; the block feels `-friction_force`.
    ///
    /// # Step
    /// Exact for held inputs and for inputs that move linearly, an angle that turns at a constant rate included. The
    /// outputs follow from states and the angle: there is no direct feed-through of the friction force.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; an angle beyond the vertical.
    ///
    /// # Limits
    /// The angle moves slowly: terms of inertia of a plane that turns (centrifugal, Euler and Coriolis forces) are left
    /// out. They are below 1 % of the weight if the block is within 1 m of the axis and the plane turns at less than
    /// 0.3 rad/s. The plane has no end. The friction force comes from the master: held over a step, it makes the
    /// coupling a method of first order.
    ///
    /// # Source
    /// Equations (3.1) and (3.2) of F. Novais, "A critical analysis on friction force models in dynamical systems", MSc
    /// thesis, University of Minho (2024); mass and gravity are those of its Table 6.1.
    ///
    /// # Example
    /// ```
    /// use stribeck::host::Incline;
    /// use stribeck::model::Law;
    /// let mut slope = Incline { angle: 0.15f64.atan(), ..Default::default() };
    /// slope.output();
    /// assert!((slope.external_force / slope.normal_force - 0.15).abs() < 1e-15); // tan(8.53 degrees)
    /// ```
    Incline: "Block on an inclined plane" {
        /// Friction force; has the sign of the velocity when sliding. Body 1 feels its negative.
        friction_force: input = real("N", 0.0).means(Meaning::FrictionForce),
        /// Angle of the plane above the horizontal.
        angle: input = real("rad", 0.0).at_least(-FRAC_PI_2).at_most(FRAC_PI_2).shown_in("deg"),
        /// Mass of the block.
        mass: fixed = real("kg", 1.0).positive(),
        /// Acceleration of gravity.
        gravity: tunable = real("m/s2", GRAVITY).at_least(0.0),
        /// Position of the block, positive down the slope.
        position: state_output = real("m", 0.0).nominal(1e-2),
        /// Velocity of the block, positive down the slope.
        velocity: state_output = real("m/s", 0.0).nominal(0.1).means(Meaning::Velocity),
        /// Weight of the block along the plane.
        external_force: output = real("N", 0.0).means(Meaning::ExternalForce),
        /// Weight of the block across the plane.
        normal_force: output = real("N", 0.0).means(Meaning::NormalForce),
    }
}

impl<T: Real> Law for Incline<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.external_force = self.along();
        self.normal_force = self.mass * self.gravity * self.angle.cos();
    }
}

impl<T: Real> Derivatives for Incline<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.position = self.velocity;
        rate.velocity = (self.along() - self.friction_force) / self.mass;
    }
}

impl<T: Real> Incline<T> {
    /// Weight along the plane.
    fn along(&self) -> T {
        self.mass * self.gravity * self.angle.sin()
    }
}

impl Incline {
    /// Exact motion while friction force and angle move at constant rates. The weight along a plane that turns at the
    /// rate w satisfies the equation of an oscillator, f'' + w^2 f = 0.
    fn advance(&mut self, [force_rate, turn]: [f64; 2], t: f64) {
        let jerk = self.gravity * cos(self.angle) * turn;
        let [fall, speed] = undamped([0.0; 2], [self.along() / self.mass, jerk], turn * turn, t);
        let resistance = [-self.friction_force / self.mass, -force_rate / self.mass];
        let [drag, loss] = undamped([0.0; 2], resistance, 0.0, t);
        self.position += t * self.velocity + (fall + drag);
        self.velocity += speed + loss;
    }
}

impl Model for Incline {
    fn step(&mut self, dt: f64) {
        self.advance([0.0; 2], dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        let begin = ramp::Inputs::of(self);
        self.advance([slope.friction_force, slope.angle], dt);
        ramp::set_inputs(self, &begin, slope, dt);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The work of friction is the loss of kinetic energy and height.
    #[test]
    fn energy_of_a_block_that_slides() {
        let mut block = Incline { angle: 0.5, friction_force: 2.1, mass: 1.3, velocity: -0.7, ..Default::default() };
        let energy = |block: &Incline| {
            0.5 * block.mass * block.velocity.powi(2) - block.mass * block.gravity * block.position * 0.5f64.sin()
        };
        for dt in [1e-6, 1e-3, 0.1, 3.0] {
            let before = block;
            block.step(dt);
            let lost = energy(&before) - energy(&block);
            assert!((lost - 2.1 * (block.position - before.position)).abs() < 1e-12, "{dt}: {lost} J");
        }
    }

    #[test]
    fn a_block_that_is_held_stays_where_it_is() {
        let mut block = Incline { angle: 0.123, mass: 0.7, ..Default::default() };
        block.output();
        block.friction_force = block.external_force;
        block.step(10.0);
        assert_eq!([block.position, block.velocity], [0.0, 0.0]);
    }

    /// Without friction, a plane that turns from level at the rate w gives v = g (1 - cos wt) / w and
    /// x = g (t - sin(wt) / w) / w; friction that grows from nothing takes f' t^2 / 2 m and f' t^3 / 6 m.
    #[test]
    fn turning_plane_and_growing_friction() {
        for (turn, t) in [(0.05, 20.0), (-0.3, 4.0), (1.5, 1.0), (1e-9, 3.0)] {
            let mut block = Incline { mass: 2.0, ..Default::default() };
            let slope = Incline { angle: turn, friction_force: 0.4, ..block };
            block.step_ramp(&slope, t);
            let half = (0.5 * turn * t).sin();
            let velocity = 9.81 * 2.0 * half * half / turn - 0.1 * t * t;
            let cubic = 9.81 * turn * t.powi(3) / 6.0;
            let fall = if turn.abs() < 1e-6 { cubic } else { 9.81 * (t - (turn * t).sin() / turn) / turn };
            assert!((block.velocity - velocity).abs() < 1e-13 * t, "{turn}");
            assert!((block.position - (fall - 0.4 * t.powi(3) / 12.0)).abs() < 1e-12 * t, "{turn}");
            assert_eq!([block.angle, block.friction_force], [turn * t, 0.4 * t]);
        }
    }
}
