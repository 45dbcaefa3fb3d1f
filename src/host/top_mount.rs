use crate::host::oscillator::undamped;
use crate::host::vertical::GRAVITY;
use crate::model::{Derivatives, Law, Meaning, Model, ModelExchange, ramp, real};
use crate::number::Real;

crate::model! {
    /// The inner part of a top mount with the rod of the strut: a small mass between the strut and the rubber that joins it
    /// to the body of a `QuarterCar`.
    ///
    /// # Equations
    ///
    /// ```text
    /// m d2y/dt2 = f_y = f - f_0 - f_m
    /// x = y - r z_s
    /// l = l_0 + y - r z_u
    /// f_e = f_w - f_0 - (M f_m + m (f_t - f_t0) / r) / (m + M)
    /// M = m_u / r^2,   f_t0 = (m_s + m_u) g
    /// ```
    ///
    /// | symbol | variable                 | unit | meaning                                             |
    /// |--------|--------------------------|------|-----------------------------------------------------|
    /// | f      | `strut_force`            | N    | force of the strut                                  |
    /// | f_w    | `force_without_friction` | N    | that force without the friction in the strut        |
    /// | f_m    | `mount_force`            | N    | force of the rubber, 0 at rest                      |
    /// | z_s    | `body_height`            | m    | height of the body above its height at rest         |
    /// | z_u    | `wheel_height`           | m    | height of the wheel above its height at rest        |
    /// | f_t    | `tyre_load`              | N    | force of the tyre on the road                       |
    /// | m      | `mass`                   | kg   | mass of the inner part, with the rod                |
    /// | m_s    | `body_mass`              | kg   | mass of the body                                    |
    /// | m_u    | `wheel_mass`             | kg   | unsprung mass of the corner                         |
    /// | r      | `motion_ratio`           | 1    | damper travel per wheel travel                      |
    /// | l_0    | `static_length`          | m    | length of the strut at rest                         |
    /// | f_0    | `static_force`           | N    | force of the strut at rest                          |
    /// | y      | `rod_position`           | m    | position of the rod along the strut                 |
    /// | x      | `displacement`           | m    | displacement of the inner part relative to the body |
    /// | dx/dt  | `inner_velocity`         | m/s  | its rate                                            |
    /// | l      | `length`                 | m    | length of the strut                                 |
    /// | dl/dt  | `velocity`               | m/s  | rate of the strut's length                          |
    /// | f_y    | `rod_force`              | N    | part of the strut force that moves the rod          |
    /// | f_e    | `external_force`         | N    | force that the friction of a stuck strut carries    |
    /// | g      |                          | m/s2 | 9.81, the acceleration of gravity                   |
    ///
    /// The wheel feels the force of the strut, the body that of the rubber: `QuarterCar` gets both `strut_force` and
    /// `rod_force`. The rubber is a `RubberMount` that gets `inner_velocity`; it carries the load at rest in addition.
    ///
    /// # Sign
    /// `displacement` is positive where the rod presses into the body. `strut_force` is positive if it pushes the eyes of
    /// the strut apart, `mount_force` if it pushes the inner part back. `velocity` is positive as the strut extends.
    ///
    /// # Step
    /// Exact for held inputs and for inputs that move linearly. `length`, `velocity`, `displacement` and `inner_velocity`
    /// follow from the motion alone: strut and rubber close no algebraic loop.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// Parameters of the car must be those of the `QuarterCar`. Its mass does not contain `mass`, which is small. Forces
    /// come from the master; held over a step they make the coupling a method of first order, stable for steps shorter
    /// than about `mass` / c with the damper c of the strut, with the defaults 0.1 ms. A solver of the workbench, or an
    /// importer with Model Exchange, has no such limit.
    ///
    /// # Source
    /// Newton's law for a mass between two forces. The mass is chosen; the other parameters are those of `QuarterCar`.
    ///
    /// # Example
    /// ```
    /// use stribeck::host::TopMount;
    /// use stribeck::model::{Law, Model};
    /// let mut mount = TopMount { mount_force: -3.0, ..Default::default() }; // 3 N on 0.3 kg: 10 m/s2
    /// mount.step(0.01);
    /// mount.output();
    /// assert!((mount.length - 0.1775 - 0.5e-3).abs() < 1e-15);
    /// ```
    TopMount: "Inner part of a top mount, between a strut and the rubber to the body" {
        /// Force of the strut.
        strut_force: input = real("N", 1325.2555).means(Meaning::StrutForce),
        /// Force of the strut without its friction; only the external force depends on it.
        force_without_friction: input = real("N", 1325.2555).means(Meaning::ForceWithoutFriction),
        /// Force of the rubber, 0 at rest; pushes the inner part back where it is displaced.
        mount_force: input = real("N", 0.0),
        /// Height of the body above its height at rest.
        body_height: input = real("m", 0.0).shown_in("mm"),
        /// Vertical velocity of the body.
        body_velocity: input = real("m/s", 0.0),
        /// Height of the wheel above its height at rest.
        wheel_height: input = real("m", 0.0).shown_in("mm"),
        /// Vertical velocity of the wheel.
        wheel_velocity: input = real("m/s", 0.0),
        /// Vertical force of the tyre on the ground; only the external force depends on it.
        tyre_load: input = real("N", 679.5387).at_least(0.0),
        /// Mass of the inner part, with the rod of the strut (default chosen).
        mass: fixed = real("kg", 0.3).positive(),
        /// Mass of the body, without the wheels.
        body_mass: fixed = real("kg", 52.91).positive(),
        /// Unsprung mass of the corner.
        wheel_mass: fixed = real("kg", 16.36).positive(),
        /// Damper travel per wheel travel.
        motion_ratio: fixed = real("1", 1.011).positive(),
        /// Length of the strut at rest, eye to eye.
        static_length: fixed = real("m", 0.1775).positive().shown_in("mm"),
        /// Force of the strut at rest.
        static_force: fixed = real("N", 1325.2555),
        /// Position of the rod along the strut; 0 at rest.
        rod_position: state_output = real("m", 0.0).nominal(1e-2).shown_in("mm"),
        /// Velocity of the rod along the strut.
        rod_velocity: state_output = real("m/s", 0.0).nominal(0.1),
        /// Displacement of the inner part relative to the body.
        displacement: output = real("m", 0.0).nominal(1e-3).shown_in("mm"),
        /// Velocity of the inner part relative to the body.
        inner_velocity: output = real("m/s", 0.0).nominal(0.1),
        /// Length of the strut.
        length: output = real("m", 0.0).shown_in("mm").means(Meaning::StrutLength),
        /// Rate of the strut's length, positive in extension.
        velocity: output = real("m/s", 0.0).means(Meaning::Velocity),
        /// Part of the strut force that moves the rod and not the body.
        rod_force: output = real("N", 0.0),
        /// Force that the friction of a stuck strut carries.
        external_force: output = real("N", 0.0).means(Meaning::ExternalForce),
    }
}

impl<T: Real> TopMount<T> {
    /// Force that moves the rod.
    fn push(&self) -> T {
        self.strut_force - self.static_force - self.mount_force
    }

    /// Force of the strut beside that at rest with which rod and wheel have the same acceleration along it.
    fn holding_force(&self) -> T {
        let wheel = self.wheel_mass / (self.motion_ratio * self.motion_ratio);
        let excess = self.tyre_load - T::from(GRAVITY) * (self.body_mass + self.wheel_mass);
        (wheel * self.mount_force + self.mass * excess / self.motion_ratio) / (self.mass + wheel)
    }
}

impl<T: Real> Law for TopMount<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.displacement = self.rod_position - self.motion_ratio * self.body_height;
        self.inner_velocity = self.rod_velocity - self.motion_ratio * self.body_velocity;
        self.length = self.static_length + self.rod_position - self.motion_ratio * self.wheel_height;
        self.velocity = self.rod_velocity - self.motion_ratio * self.wheel_velocity;
        self.rod_force = self.push();
        self.external_force = self.force_without_friction - self.static_force - self.holding_force();
    }
}

impl<T: Real> Derivatives for TopMount<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.rod_position = self.rod_velocity;
        rate.rod_velocity = self.push() / self.mass;
    }
}

impl TopMount {
    /// Exact motion while the forces move at a constant rate.
    fn advance(&mut self, force_rate: f64, t: f64) {
        let push = [self.push(), force_rate].map(|push| push / self.mass);
        [self.rod_position, self.rod_velocity] = undamped([self.rod_position, self.rod_velocity], push, 0.0, t);
    }
}

impl Model for TopMount {
    fn step(&mut self, dt: f64) {
        self.advance(0.0, dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        let begin = ramp::Inputs::of(self);
        self.advance(slope.strut_force - slope.mount_force, dt);
        ramp::set_inputs(self, &begin, slope, dt);
    }
}

#[cfg(test)]
mod tests {
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    use super::*;
    use crate::host::QuarterCar;

    /// Body, wheel and rod: with the friction that the mount gives, the length of the strut keeps its rate, and with any
    /// other it does not. At a lever ratio of 1 the three gain the momentum that tyre and weight give them.
    #[test]
    fn a_stuck_strut_keeps_the_rate_of_its_length() {
        for ratio in [1.0, 1.3] {
            let mut car = QuarterCar { road_height: 0.004, road_velocity: 0.2, ..Default::default() };
            car.suspension.motion_ratio = ratio;
            car.output();
            let mut mount = TopMount {
                force_without_friction: 1500.0,
                mount_force: 77.0,
                tyre_load: car.wheel.tyre_load,
                motion_ratio: ratio,
                ..Default::default()
            };
            mount.output();
            // Accelerations of body, wheel and rod.
            let moved = |friction: f64| {
                let (mut car, mut mount) = (car, mount);
                (car.wheel.strut_force, mount.strut_force) = (1500.0 - friction, 1500.0 - friction);
                mount.output();
                car.rod_force = mount.rod_force;
                let (mut of_car, mut of_mount) = (car, mount);
                car.rate(&mut of_car);
                mount.rate(&mut of_mount);
                [of_car.body_velocity, of_car.wheel.wheel_velocity, of_mount.rod_velocity]
            };
            let stretched = |[_, wheel, rod]: [f64; 3]| rod - ratio * wheel;
            assert_abs_diff_eq!(stretched(moved(mount.external_force)), 0.0, epsilon = 1e-10);
            let other = stretched(moved(mount.external_force + 1.0));
            assert_relative_eq!(other, -1.0 / 0.3 - ratio * ratio / 16.36, max_relative = 1e-9);
            let [body, wheel, rod] = moved(20.0);
            assert_abs_diff_eq!(body, ratio * 77.0 / 52.91, epsilon = 1e-12);
            if ratio == 1.0 {
                let gained = 52.91 * body + 16.36 * wheel + 0.3 * rod;
                assert_abs_diff_eq!(gained, car.wheel.tyre_load - 69.27 * 9.81, epsilon = 1e-9);
            }
        }
    }

    /// Under forces that move linearly the position of the rod is a polynomial of the time.
    #[test]
    fn a_ramp_of_the_forces_is_a_cubic() {
        let mut mount = TopMount { strut_force: 1325.2555 + 0.6, rod_velocity: 0.01, ..Default::default() };
        let slope = TopMount { strut_force: 9.0, mount_force: 3.0, wheel_velocity: 2.0, ..mount.map(&|_| 0.0) };
        mount.step_ramp(&slope, 0.1);
        let (acceleration, jerk) = (0.6 / 0.3, 6.0 / 0.3);
        assert_abs_diff_eq!(mount.rod_position, 0.001 + acceleration / 200.0 + jerk / 6000.0, epsilon = 1e-12);
        assert_abs_diff_eq!(mount.rod_velocity, 0.01 + acceleration / 10.0 + jerk / 200.0, epsilon = 1e-11);
        mount.output();
        assert_abs_diff_eq!(mount.velocity, mount.rod_velocity - 1.011 * 0.2, epsilon = 1e-14);
    }
}
