use crate::host::oscillator::undamped;
use crate::model::{Derivatives, Law, Meaning, Model, ModelExchange, ramp, real};
use crate::number::Real;

crate::model! {
    /// The inner part of a top mount: a small mass between a strut and the rubber that joins it to the body.
    ///
    /// # Equations
    ///
    /// ```text
    /// m d2x/dt2 = f - f_0 - f_m
    /// l     = L + x
    /// dl/dt = dL/dt + dx/dt
    /// f_e   = f_w - f_0 - (m (f_w - f_r - f_0) + M f_m) / (m + M)
    /// ```
    ///
    /// | symbol | variable                 | unit | meaning                                                     |
    /// |--------|--------------------------|------|-------------------------------------------------------------|
    /// | f      | `strut_force`            | N    | force of the strut                                          |
    /// | f_w    | `force_without_friction` | N    | that force without the friction in the strut                |
    /// | f_m    | `mount_force`            | N    | force of the rubber, 0 at rest                              |
    /// | L      | `distance`               | m    | length of the strut if the mount were rigid                 |
    /// | dL/dt  | `distance_rate`          | m/s  | its rate                                                    |
    /// | f_r    | `rigid_external_force`   | N    | force that friction carries in a stuck strut, rigid mount   |
    /// | m      | `mass`                   | kg   | mass of the inner part, with the rod of the strut           |
    /// | M      | `reduced_mass`           | kg   | reduced mass of body and wheel, as the strut feels it       |
    /// | f_0    | `static_force`           | N    | force of the strut at rest                                  |
    /// | x      | `displacement`           | m    | displacement of the inner part relative to the body         |
    /// | dx/dt  | `inner_velocity`         | m/s  | its rate                                                    |
    /// | l      | `length`                 | m    | length of the strut                                         |
    /// | dl/dt  | `velocity`               | m/s  | rate of the strut's length                                  |
    /// | f_e    | `external_force`         | N    | force that the friction of a stuck strut carries            |
    ///
    /// The reduced mass of a body $m_s$ and a wheel $m_u$ with a lever ratio $r$ is $m_s m_u / ((m_s + m_u) r^2)$. The rubber
    /// is a `RubberMount` that gets `inner_velocity`; it carries the load at rest in addition. Body and wheel feel the
    /// force of the strut.
    ///
    /// # Sign
    /// `displacement` is positive where the rod presses into the body, which makes the strut longer than the distance of
    /// its eyes. `strut_force` is positive if it pushes the eyes of the strut apart, `mount_force` if it pushes the inner
    /// part back. `velocity` is positive as the strut extends.
    ///
    /// # Step
    /// Exact for held inputs and for inputs that move linearly. `length` and `velocity` follow from states and the
    /// distance: strut and rubber close no algebraic loop.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// The motion of the inner part with the body is that of a part of the body: count its mass there as well. Forces come
    /// from the master; held over a step they make the coupling a method of first order, stable for steps shorter than
    /// about `mass` / c with the damper c of the strut, with the defaults 0.1 ms. A solver of the workbench, or an importer
    /// with Model Exchange, has no such limit.
    ///
    /// # Source
    /// Two masses and a spring between them. The mass is chosen; reduced mass and force at rest are those of the defaults of
    /// `QuarterCar`.
    ///
    /// # Example
    /// ```
    /// use stribeck::host::TopMount;
    /// use stribeck::model::{Law, Model};
    /// let mut mount = TopMount { mount_force: -3.0, ..Default::default() }; // 3 N of 0.3 kg: 10 m/s2
    /// mount.step(0.01);
    /// mount.output();
    /// assert!((mount.length - 0.1775 - 0.5e-3).abs() < 1e-15);
    /// ```
    TopMount: "Inner part of a top mount, between a strut and the rubber to the body" {
        /// Force of the strut.
        strut_force: input = real("N", 1325.2555),
        /// Force of the strut without its friction; only the external force depends on it.
        force_without_friction: input = real("N", 1325.2555),
        /// Force of the rubber, 0 at rest; pushes the inner part back where it is displaced.
        mount_force: input = real("N", 0.0),
        /// Length of the strut if the mount were rigid.
        distance: input = real("m", 0.1775).shown_in("mm"),
        /// Rate of the distance.
        distance_rate: input = real("m/s", 0.0),
        /// Force that the friction of a stuck strut would carry if the mount were rigid.
        rigid_external_force: input = real("N", 0.0),
        /// Mass of the inner part, with the rod of the strut (default chosen).
        mass: fixed = real("kg", 0.3).positive(),
        /// Reduced mass of body and wheel, as the strut feels it.
        reduced_mass: fixed = real("kg", 12.225695).positive(),
        /// Force of the strut at rest.
        static_force: fixed = real("N", 1325.2555),
        /// Displacement of the inner part relative to the body.
        displacement: state_output = real("m", 0.0).nominal(1e-3).shown_in("mm"),
        /// Velocity of the inner part relative to the body.
        inner_velocity: state_output = real("m/s", 0.0).nominal(0.1),
        /// Length of the strut.
        length: output = real("m", 0.0).shown_in("mm"),
        /// Rate of the strut's length, positive in extension.
        velocity: output = real("m/s", 0.0).means(Meaning::Velocity),
        /// Force that the friction of a stuck strut carries.
        external_force: output = real("N", 0.0),
    }
}

impl<T: Real> TopMount<T> {
    /// Force of the strut beside that at rest with which its length keeps its rate: a mean of that of a rigid mount and
    /// that of the rubber.
    fn holding_force(&self) -> T {
        let rigid = self.force_without_friction - self.rigid_external_force - self.static_force;
        (self.mass * rigid + self.reduced_mass * self.mount_force) / (self.mass + self.reduced_mass)
    }

    fn acceleration(&self) -> T {
        (self.strut_force - self.static_force - self.mount_force) / self.mass
    }
}

impl<T: Real> Law for TopMount<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.length = self.distance + self.displacement;
        self.velocity = self.distance_rate + self.inner_velocity;
        self.external_force = self.force_without_friction - self.static_force - self.holding_force();
    }
}

impl<T: Real> Derivatives for TopMount<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.displacement = self.inner_velocity;
        rate.inner_velocity = self.acceleration();
    }
}

impl TopMount {
    /// Exact motion while the forces move at a constant rate.
    fn advance(&mut self, force_rate: f64, t: f64) {
        [self.displacement, self.inner_velocity] =
            undamped([self.displacement, self.inner_velocity], [self.acceleration(), force_rate / self.mass], 0.0, t);
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

    /// Body, wheel and inner part: with the friction that the mount gives, the length of the strut keeps its rate, and with
    /// any other it does not.
    #[test]
    fn a_stuck_strut_keeps_the_rate_of_its_length() {
        let mut car = QuarterCar { road_height: 0.004, road_velocity: 0.2, ..Default::default() };
        car.force_without_friction = 1500.0;
        car.output();
        let mut mount = TopMount {
            force_without_friction: 1500.0,
            rigid_external_force: car.external_force,
            mount_force: 77.0,
            ..Default::default()
        };
        mount.output();
        let stretched = |friction: f64| {
            let (mut car, mut mount) = (car, mount);
            (car.wheel.strut_force, mount.strut_force) = (1500.0 - friction, 1500.0 - friction);
            let (mut of_car, mut of_mount) = (car, mount);
            car.rate(&mut of_car);
            mount.rate(&mut of_mount);
            1.011 * (of_car.body_velocity - of_car.wheel.wheel_velocity) + of_mount.inner_velocity
        };
        assert_abs_diff_eq!(stretched(mount.external_force), 0.0, epsilon = 1e-5);
        assert_relative_eq!(stretched(mount.external_force + 1.0), -1.0 / 0.3 - 1.0 / 12.225695, max_relative = 1e-5);
    }

    /// Under forces that move linearly the displacement is a polynomial of the time.
    #[test]
    fn a_ramp_of_the_forces_is_a_cubic() {
        let mut mount = TopMount { strut_force: 1325.2555 + 0.6, inner_velocity: 0.01, ..Default::default() };
        let slope = TopMount { strut_force: 9.0, mount_force: 3.0, distance_rate: 2.0, ..mount.map(&|_| 0.0) };
        mount.step_ramp(&slope, 0.1);
        let (acceleration, jerk) = (0.6 / 0.3, 6.0 / 0.3);
        assert_abs_diff_eq!(mount.displacement, 0.001 + acceleration / 200.0 + jerk / 6000.0, epsilon = 1e-12);
        assert_abs_diff_eq!(mount.inner_velocity, 0.01 + acceleration / 10.0 + jerk / 200.0, epsilon = 1e-11);
        mount.output();
        assert_abs_diff_eq!(mount.velocity, 0.2 + mount.inner_velocity, epsilon = 1e-14);
    }
}
