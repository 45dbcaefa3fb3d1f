use crate::host::oscillator::undamped;
use crate::model::{Derivatives, Law, Meaning, Model, ModelExchange, ramp, real};
use crate::number::Real;

crate::model! {
    /// An axis of a machine: a slide in guides, moved by the force of its drive.
    ///
    /// # Equations
    ///
    /// ```text
    /// M a = F - f_f - b
    /// f_e = F - b
    /// f_n = f_g
    /// ```
    ///
    /// | symbol | variable         | unit | meaning                                                |
    /// |--------|------------------|------|--------------------------------------------------------|
    /// | f_f    | `friction_force` | N    | friction force of the guides                           |
    /// | F      | `drive_force`    | N    | force of the drive, as it is measured                  |
    /// | M      | `mass`           | kg   | mass that moves, that of the drive included            |
    /// | b      | `offset`         | N    | offset: part of the measured force that moves nothing  |
    /// | f_n    | `normal_force`   | N    | sum of the normal forces of the guides                 |
    /// | f_g    | `guide_force`    | N    | normal forces of the guides, preload and weight        |
    /// | x      | `position`       | m    | position                                               |
    /// | dx/dt  | `velocity`       | m/s  | velocity                                               |
    /// | f_e    | `external_force` | N    | force that moves the slide                             |
    ///
    /// The offset is that of an amplifier, of a load cell that is not zeroed, or the weight along an axis that is not
    /// level. With the default `guide_force` of 1 N a coefficient of friction is the friction force in N: of an axis in
    /// preloaded guides only that force can be measured. `stribeck identify --axis` finds mass, offset and friction.
    ///
    /// # Sign
    /// Force, position and velocity are positive in the same direction. `friction_force` has the sign of `velocity`
    /// when sliding; the slide feels `-friction_force`.
    ///
    /// # Step
    /// Exact for held inputs and for inputs that move linearly. Outputs follow from states and the force of the drive:
    /// there is no direct feed-through of the friction force.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// The drive is stiff, and there are no stops. The friction force comes from the master: held over a step, it makes
    /// the coupling a method of first order.
    ///
    /// # Source
    /// A. Janot, $M$. Gautier, $M$. Brunot, "Data set and reference models of EMPS", Workshop on Nonlinear System
    /// Identification Benchmarks (2019), whose axis has $M = 95.1089$ kg, viscous and Coulomb friction of 203.5034 N
    /// s/m and 20.3935 N, and $b = -3.1648$ N. The default mass is that one.
    ///
    /// # Example
    /// ```
    /// use stribeck::host::Axis;
    /// use stribeck::model::Law;
    /// let mut axis = Axis { drive_force: 5.0, offset: -3.0, ..Default::default() };
    /// axis.output();
    /// assert_eq!(axis.external_force, 8.0); // the axis feels 3 N more than is measured
    /// ```
    Axis: "Axis of a machine, moved by the force of its drive" {
        /// Friction force; has the sign of the velocity when sliding. Body 1 feels its negative.
        friction_force: input = real("N", 0.0).means(Meaning::FrictionForce),
        /// Force of the drive, as it is measured.
        drive_force: input = real("N", 0.0),
        /// Mass that moves.
        mass: fixed = real("kg", 95.1089).positive(),
        /// Part of the measured force that moves nothing.
        offset: tunable = real("N", 0.0),
        /// Sum of the normal forces of the guides (default chosen: a coefficient of friction is then a force in N).
        guide_force: tunable = real("N", 1.0).at_least(0.0),
        /// Position of the slide.
        position: state_output = real("m", 0.0).nominal(1e-2),
        /// Velocity of the slide.
        velocity: state_output = real("m/s", 0.0).nominal(0.1).means(Meaning::Velocity),
        /// Force that moves the slide.
        external_force: output = real("N", 0.0).means(Meaning::ExternalForce),
        /// Sum of the normal forces of the guides.
        normal_force: output = real("N", 0.0).means(Meaning::NormalForce),
    }
}

impl<T: Real> Axis<T> {
    fn drive(&self) -> T {
        self.drive_force - self.offset
    }
}

impl<T: Real> Law for Axis<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.external_force = self.drive();
        self.normal_force = self.guide_force;
    }
}

impl<T: Real> Derivatives for Axis<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.position = self.velocity;
        rate.velocity = (self.drive() - self.friction_force) / self.mass;
    }
}

impl Axis {
    /// Exact motion while the forces move at constant rates.
    fn advance(&mut self, rate: f64, t: f64) {
        let acceleration = (self.drive() - self.friction_force) / self.mass;
        [self.position, self.velocity] =
            undamped([self.position, self.velocity], [acceleration, rate / self.mass], 0.0, t);
    }
}

impl Model for Axis {
    fn step(&mut self, dt: f64) {
        self.advance(0.0, dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        let begin = ramp::Inputs::of(self);
        self.advance(slope.drive_force - slope.friction_force, dt);
        ramp::set_inputs(self, &begin, slope, dt);
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Forces that grow from F_0 at the rate F': v = (F_0 t + F' t^2 / 2) / M, x = (F_0 t^2 / 2 + F' t^3 / 6) / M.
    #[test]
    fn forces_that_grow_give_a_parabola_and_a_cubic() {
        for t in [1e-3, 0.5, 20.0] {
            let mut axis =
                Axis { mass: 4.0, drive_force: 7.0, friction_force: 2.0, offset: -1.0, ..Default::default() };
            let slope = Axis { drive_force: 0.9, friction_force: 0.3, ..ramp::held_inputs(&axis) };
            axis.step_ramp(&slope, t);
            assert_relative_eq!(axis.velocity, (6.0 * t + 0.3 * t * t) / 4.0, max_relative = 1e-14);
            assert_relative_eq!(axis.position, (3.0 * t * t + 0.1 * t * t * t) / 4.0, max_relative = 1e-14);
            assert_relative_eq!(axis.drive_force, 7.0 + 0.9 * t, max_relative = 1e-15);
        }
    }

    #[test]
    fn friction_that_carries_the_external_force_holds_the_slide() {
        let mut axis = Axis { drive_force: 0.3, offset: -3.1648, ..Default::default() };
        axis.output();
        axis.friction_force = axis.external_force;
        axis.step(10.0);
        assert_eq!([axis.position, axis.velocity, axis.normal_force], [0.0, 0.0, 1.0]);
    }
}
