use crate::host::vertical::GRAVITY;
use crate::model::{Derivatives, Law, Meaning, Model, ModelExchange, Preset, integrate, real};
use crate::number::Real;

crate::model! {
    /// An arm with a load, held against its weight by a servo: a motor with gear and a controller of the angle.
    ///
    /// # Equations
    ///
    /// ```text
    /// m dv/dt = f_m + f_l - f_f,   dq/dt = v / r
    /// f_m = k_t (U - k_t v / r) / (R r)
    /// U   = k_p (q_d - q)                      at most U_max, at least -U_max
    /// f_l = -m_l g l sin(q) / r
    /// m   = (J + m_l l^2) / r^2
    /// ```
    ///
    /// | symbol | variable            | unit  | meaning                                                        |
    /// |--------|---------------------|-------|----------------------------------------------------------------|
    /// | f_f    | `friction_force`    | N     | friction force of the drive                                    |
    /// | q_d    | `target_angle`      | rad   | angle that the arm should have                                 |
    /// | k_p    | `gain`              | V/rad | gain of the controller                                         |
    /// | U_max  | `voltage_limit`     | V     | largest voltage of the motor                                   |
    /// | k_t    | `motor_constant`    | N.m/A | torque of the gear by current, voltage by its angular velocity |
    /// | R      | `resistance`        | Ohm   | resistance of the motor                                        |
    /// | J      | `armature`          | kg.m2 | moment of inertia of rotor and gear at the output              |
    /// | m_l    | `load_mass`         | kg    | mass at the end of the arm                                     |
    /// | l      | `arm_length`        | m     | length of the arm, which has no mass                           |
    /// | r      | `radius`            | m     | radius at which forces and velocity are counted                |
    /// | g      | `gravity`           | m/s2  | acceleration of gravity                                        |
    /// | q      | `angle`             | rad   | angle of the arm, 0 if it hangs down                           |
    /// | v      | `velocity`          | m/s   | velocity at the radius                                         |
    /// | f_m    | `motor_force`       | N     | force of the motor at the radius                               |
    /// | f_l    | `load_force`        | N     | weight of the load, at the radius                              |
    /// | f_e    | `external_force`    | N     | their sum                                                      |
    /// | m      | `effective_mass`    | kg    | moment of inertia at the radius                                |
    ///
    /// At the default radius of 1 m a force in N is a torque in N.m, a velocity in m/s an angular velocity in rad/s,
    /// and the effective mass in kg a moment of inertia in kg.m2. Without voltage, as with `gain` = 0, the motor brakes
    /// as one that is short-circuited; `motor_constant` = 0 removes it.
    ///
    /// # Sign
    /// Angle, velocity and forces are positive in the same direction. `friction_force` has the sign of `velocity` when
    /// sliding; the arm feels `-friction_force`.
    ///
    /// # Step
    /// Integrates the rates with error control to 1e-10. Outputs follow from states and the target, without direct
    /// feed-through of the friction force.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; a step that would need too many pieces.
    ///
    /// # Limits
    /// The gear is stiff and has no backlash; the motor has no inductance, and the controller acts at once. The friction
    /// force comes from the master: held over a step, it makes the coupling a method of first order.
    ///
    /// # Source
    /// The pendulum on which M. Duclusaud, G. Passault, V. Padois, O. Ly, "Extended friction models for the physics
    /// simulation of servo actuators", IEEE International Conference on Robotics and Automation (2025), 12091-12097, arXiv
    /// 2410.08650, identify servos. Start values of the motor: Dynamixel MX-106 with their friction model M4, at a
    /// supply of 15 V of which 96.25 % are used, and a gain of 32 in the units of its controller. The presets are the
    /// motors of their six models of friction with their usual supply and gain, to four digits, from their repository
    /// Rhoban/bam (2026). Load and length are chosen.
    ///
    /// # Example
    /// ```
    /// use stribeck::host::ServoArm;
    /// use stribeck::model::Law;
    /// let mut arm = ServoArm { angle: std::f64::consts::FRAC_PI_2, load_mass: 2.0, ..Default::default() };
    /// (arm.arm_length, arm.gravity) = (0.1, 9.81);
    /// arm.output();
    /// assert!((arm.load_force + 1.962).abs() < 1e-15); // horizontal: -2 kg 9.81 m/s2 0.1 m
    /// ```
    ServoArm: "Arm with a load, held by a servo" {
        /// Friction force; has the sign of the velocity when sliding. Body 1 feels its negative.
        friction_force: input = real("N", 0.0).means(Meaning::FrictionForce),
        /// Angle that the arm should have.
        target_angle: input = real("rad", 0.0).shown_in("deg"),
        /// Gain of the controller: voltage by the error of the angle.
        gain: tunable = real("V/rad", 75.84).at_least(0.0).nominal(100.0),
        /// Largest voltage of the motor, in both directions.
        voltage_limit: tunable = real("V", 14.44).at_least(0.0).nominal(10.0),
        /// Torque of the gear by the current of the motor, and voltage of the motor by the angular velocity of the gear.
        motor_constant: fixed = real("N.m/A", 2.231).at_least(0.0),
        /// Resistance of the motor.
        resistance: fixed = real("Ohm", 2.372).positive(),
        /// Moment of inertia of rotor and gear at the output.
        armature: fixed = real("kg.m2", 0.02457).positive().nominal(1e-2),
        /// Mass at the end of the arm (default chosen).
        load_mass: fixed = real("kg", 0.5).at_least(0.0),
        /// Length of the arm (default chosen).
        arm_length: fixed = real("m", 0.2).at_least(0.0).nominal(0.1),
        /// Radius at which forces and velocity are counted.
        radius: fixed = real("m", 1.0).positive(),
        /// Acceleration of gravity.
        gravity: tunable = real("m/s2", GRAVITY).at_least(0.0),
        /// Angle of the arm; 0 if it hangs down.
        angle: state_output = real("rad", 0.0).shown_in("deg"),
        /// Velocity at the radius.
        velocity: state_output = real("m/s", 0.0).means(Meaning::Velocity),
        /// Force of the motor at the radius.
        motor_force: output = real("N", 0.0).means(Meaning::MotorForce),
        /// Weight of the load, at the radius.
        load_force: output = real("N", 0.0).means(Meaning::LoadForce),
        /// Sum of the forces of motor and load.
        external_force: output = real("N", 0.0).means(Meaning::ExternalForce),
        /// Moment of inertia of drive and load, as a mass at the radius.
        effective_mass: output = real("kg", 0.0),
    }
}

impl<T: Real> ServoArm<T> {
    fn motor(&self) -> T {
        let voltage = (self.gain * (self.target_angle - self.angle)).limited(self.voltage_limit);
        let back = self.motor_constant * self.velocity / self.radius;
        self.motor_constant * (voltage - back) / (self.resistance * self.radius)
    }

    fn load(&self) -> T {
        -self.load_mass * self.gravity * self.arm_length * self.angle.sin() / self.radius
    }

    fn inertia(&self) -> T {
        (self.armature + self.load_mass * self.arm_length * self.arm_length) / (self.radius * self.radius)
    }
}

impl<T: Real> Law for ServoArm<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.motor_force = self.motor();
        self.load_force = self.load();
        self.external_force = self.motor_force + self.load_force;
        self.effective_mass = self.inertia();
    }
}

impl<T: Real> Derivatives for ServoArm<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.angle = self.velocity / self.radius;
        rate.velocity = (self.motor() + self.load() - self.friction_force) / self.inertia();
    }
}

/// Presets in one line each: name; motor constant, resistance, moment of inertia, gain and largest voltage; servo.
macro_rules! presets {
    ($($name:literal: [$k_t:literal, $resistance:literal, $armature:literal, $gain:literal, $limit:literal]
        of $servo:literal;)+) => {
        &[$(Preset {
            name: $name,
            source: concat!("Rhoban/bam (2026), see Duclusaud et al. (2025), motor of ", $servo),
            values: &[("motor_constant", $k_t), ("resistance", $resistance), ("armature", $armature), ("gain", $gain),
                ("voltage_limit", $limit)],
        }),+]
    };
}

impl Model for ServoArm {
    #[rustfmt::skip] // one line each
    const PRESETS: &'static [Preset] = presets! {
        "mx106_m1": [2.191, 2.965, 0.02661, 75.84, 14.44] of "Dynamixel MX-106, model M1";
        "mx106_m2": [2.191, 2.961, 0.02684, 75.84, 14.44] of "Dynamixel MX-106, model M2";
        "mx106_m3": [2.204, 2.653, 0.02485, 75.84, 14.44] of "Dynamixel MX-106, model M3";
        "mx106_m4": [2.231, 2.372, 0.02457, 75.84, 14.44] of "Dynamixel MX-106, model M4";
        "mx106_m5": [2.209, 2.014, 0.02602, 75.84, 14.44] of "Dynamixel MX-106, model M5";
        "mx106_m6": [2.21, 2.034, 0.02602, 75.84, 14.44] of "Dynamixel MX-106, model M6";
        "mx64_m1": [1.622, 3.949, 0.01195, 75.84, 14.44] of "Dynamixel MX-64, model M1";
        "mx64_m2": [1.62, 3.894, 0.01192, 75.84, 14.44] of "Dynamixel MX-64, model M2";
        "mx64_m3": [1.631, 3.571, 0.01124, 75.84, 14.44] of "Dynamixel MX-64, model M3";
        "mx64_m4": [1.663, 3.156, 0.01096, 75.84, 14.44] of "Dynamixel MX-64, model M4";
        "mx64_m5": [1.587, 2.414, 0.01173, 75.84, 14.44] of "Dynamixel MX-64, model M5";
        "mx64_m6": [1.602, 2.316, 0.01227, 75.84, 14.44] of "Dynamixel MX-64, model M6";
        "xl320_m1": [0.9869, 35.61, 0.001119, 12.12, 7.5] of "Dynamixel XL-320, model M1";
        "xl320_m2": [0.9413, 34.18, 0.001108, 12.12, 7.5] of "Dynamixel XL-320, model M2";
        "xl320_m3": [1.041, 27.54, 0.001499, 12.12, 7.5] of "Dynamixel XL-320, model M3";
        "xl320_m4": [0.9949, 26.2, 0.001482, 12.12, 7.5] of "Dynamixel XL-320, model M4";
        "xl320_m5": [1.009, 31.6, 0.001162, 12.12, 7.5] of "Dynamixel XL-320, model M5";
        "xl320_m6": [1.009, 31.59, 0.001163, 12.12, 7.5] of "Dynamixel XL-320, model M6";
        "xl330_m1": [0.3867, 4.017, 0.001814, 8.632, 7.5] of "Dynamixel XL-330, model M1";
        "xl330_m2": [0.3853, 4.0, 0.001819, 8.632, 7.5] of "Dynamixel XL-330, model M2";
        "xl330_m3": [0.3804, 3.38, 0.001918, 8.632, 7.5] of "Dynamixel XL-330, model M3";
        "xl330_m4": [0.3862, 3.403, 0.001895, 8.632, 7.5] of "Dynamixel XL-330, model M4";
        "xl330_m5": [0.3622, 2.752, 0.001847, 8.632, 7.5] of "Dynamixel XL-330, model M5";
        "xl330_m6": [0.366, 2.811, 0.001808, 8.632, 7.5] of "Dynamixel XL-330, model M6";
    };

    fn step(&mut self, dt: f64) {
        integrate::held::<_, 2>(self, dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        integrate::advance::<_, 2>(self, slope, dt);
    }

    /// Whether the voltage is at one of its limits.
    fn branches(&self) -> u32 {
        let voltage = self.gain * (self.target_angle - self.angle);
        u32::from(voltage > self.voltage_limit) + 2 * u32::from(voltage < -self.voltage_limit)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    /// Without motor and friction the arm swings through with the energy it had, and a full swing of 90 degrees to
    /// either side takes 1.180,340,599 times as long as a small one (complete elliptic integral of the first kind).
    #[test]
    fn a_free_arm_is_a_pendulum() {
        let begin = ServoArm { motor_constant: 0.0, angle: std::f64::consts::FRAC_PI_2, ..Default::default() };
        let energy = |arm: &ServoArm| 0.5 * (0.02457 + 0.02) * arm.velocity.powi(2) - 0.981 * arm.angle.cos();
        let period = std::f64::consts::TAU * f64::sqrt((0.02457 + 0.02) / 0.981) * 1.180_340_599_016_096;
        let mut arm = begin;
        for part in [0.1, 0.25, 0.05, 0.6] {
            arm.step(part * period);
            assert_abs_diff_eq!(energy(&arm), energy(&begin), epsilon = 1e-9);
        }
        assert_abs_diff_eq!(arm.angle, begin.angle, epsilon = 1e-8);
        assert_abs_diff_eq!(arm.velocity, 0.0, epsilon = 1e-6);
    }

    /// Far from its target the motor turns at full voltage, with the time constant m R / k_t^2, up to U / k_t.
    #[test]
    fn full_voltage_has_an_exponential_run_up() {
        let mut arm = ServoArm { target_angle: 1e3, gravity: 0.0, ..Default::default() };
        let time_constant = (0.02457 + 0.02) * 2.372 / (2.231 * 2.231);
        arm.step(0.03);
        let end = 14.44 / 2.231;
        assert_abs_diff_eq!(arm.velocity, end * -f64::exp_m1(-0.03 / time_constant), epsilon = 1e-9);
        arm.output();
        assert_abs_diff_eq!(arm.motor_force, 2.231 / 2.372 * (14.44 - 2.231 * arm.velocity), epsilon = 1e-12);
    }

    /// The motion does not depend on the radius at which forces and velocity are counted.
    #[test]
    fn the_radius_only_changes_what_is_counted() {
        let mut arms = [1.0, 0.04].map(|radius| ServoArm {
            radius,
            angle: 0.4,
            velocity: 0.7 * radius,
            friction_force: 0.3 / radius,
            target_angle: 1.0,
            ..Default::default()
        });
        arms.iter_mut().for_each(|arm| arm.step(0.2));
        arms.iter_mut().for_each(Law::output);
        let [one, other] = arms;
        assert_abs_diff_eq!(one.angle, other.angle, epsilon = 1e-10);
        assert_abs_diff_eq!(one.velocity, other.velocity / 0.04, epsilon = 1e-8);
        assert_abs_diff_eq!(one.external_force, other.external_force * 0.04, epsilon = 1e-7);
        assert_abs_diff_eq!(one.effective_mass, other.effective_mass * 0.04 * 0.04, epsilon = 1e-15);
    }
}
