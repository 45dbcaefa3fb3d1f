use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, Inputs, NO_EVENT, TimeStepping, memoryless};
use crate::laws::stribeck;
use crate::model::{Meaning, Model, Preset, real};
use crate::number::{Real, choose};

crate::model! {
    /// Friction of a servo drive and its gear, which grows with the torques that the motor and the load put on the gear.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = (C + s S) sgn(v) + f_v v                v != 0
    /// f_f = min(|f_e|, C + S) sgn(f_e)              v  = 0
    ///
    /// s = exp(-(|v| / v_S)^delta),   f_e = f_m + f_l
    /// C = f_C + |K_l f_l - K_m f_m|
    /// S = f_E + |K_ls f_l - K_ms f_m| + Q
    /// Q = K_lq f_l^2                                f_l f_m < 0 and |f_l| < |f_m|
    /// Q = K_mq f_m^2                                f_l f_m < 0 and |f_l| > |f_m|
    /// Q = 0                                         else
    /// ```
    ///
    /// The models of the paper are special cases, and the presets: M1 has $f_C$ and $f_v$ only, M2 also $f_E$, M3 instead
    /// $K_l = K_m$, M4 all of them and $K_ls = K_ms$, in M5 all four factors differ, and M6 has $Q$ as well.
    ///
    /// With `mass` $m > 0$ the force over a step $h$ is that of the velocity $w$ at its end; the jump at rest is part
    /// of $f_f$. Of several solutions it is the first one reached from $v$ in the direction of the acceleration
    /// (implicit Euler; time stepping in the sense of Moreau):
    ///
    /// ```text
    /// m (w - v) / h = f_e - f_f(w)
    /// ```
    ///
    /// | symbol | variable                  | unit  | meaning                                               |
    /// |--------|---------------------------|-------|-------------------------------------------------------|
    /// | v      | `velocity`                | m/s   | velocity of the output                                |
    /// | f_m    | `motor_force`             | N     | force of the motor at the output                      |
    /// | f_l    | `load_force`              | N     | force of the load on the output, such as weight       |
    /// | f_C    | `kinetic_force`           | N     | kinetic level without load                            |
    /// | f_E    | `excess_force`            | N     | excess of the static level without load               |
    /// | K_m    | `motor_coefficient`       | 1     | kinetic level by the force of the motor               |
    /// | K_l    | `load_coefficient`        | 1     | kinetic level by the force of the load                |
    /// | K_ms   | `motor_excess`            | 1     | excess by the force of the motor                      |
    /// | K_ls   | `load_excess`             | 1     | excess by the force of the load                       |
    /// | K_mq   | `motor_quadratic_excess`  | 1/N   | excess by the square of the force of the motor        |
    /// | K_lq   | `load_quadratic_excess`   | 1/N   | excess by the square of the force of the load         |
    /// | v_S    | `stribeck_velocity`       | m/s   | Stribeck velocity of all excesses                     |
    /// | delta  | `stribeck_exponent`       | 1     | their exponent                                        |
    /// | f_v    | `viscous_coefficient`     | N.s/m | viscous coefficient                                   |
    /// | m      | `mass`                    | kg    | effective mass of the host, 0 = the printed law       |
    /// | h      | `step_size`               | s     | last communication step                               |
    /// | f_f    | `friction_force`          | N     | friction force                                        |
    ///
    /// Of a servo that turns the velocity is in rad/s, forces are torques in N.m, and the mass is a moment of inertia,
    /// that of the rotor with the square of the gear ratio included: the presets are in these units.
    ///
    /// # Sign
    /// The forces of motor and load are both positive in the direction of `velocity`: their sum accelerates the output,
    /// and the gear carries their difference. `friction_force` has the sign of `velocity` when sliding; the output feels
    /// `-friction_force`. Dissipated power is `friction_force * velocity`, never negative
    /// without `mass`; with it the force is that of the end of a step.
    ///
    /// # Step
    /// With held inputs exact, energy included. At rest the output holds any sum of forces up to the level, and the
    /// level is that of the forces themselves. With $K = K_m + K_ms$ and $k = K_l + K_ls$ a motor that drives against a
    /// load $f_l < 0$ begins to lift it, and gives way to it, at
    ///
    /// ```text
    /// f_m (1 - K) = f_C + f_E - f_l (1 + k)
    /// f_m (1 + K) = -f_l (1 - k) - f_C - f_E
    /// ```
    ///
    /// where both differences of weighted forces have one sign and $Q = 0$. A gear with $k >= 1$ holds every load; a
    /// motor with $K >= 1$ lifts none.
    ///
    /// With `mass` the forces of a step are means: that of the sum $f_e$, and of the magnitude of the difference
    /// $|f_m - f_l|$, which differs from the magnitude of the mean only where the difference changes its sign.
    ///
    #[doc = include_str!("../friction/coupling.md")]
    /// Here `external_force` is the sum of both forces, and `normal_force` the magnitude of their difference.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// No pre-sliding displacement, and no backlash. The falling branch takes a driven output through stick-slip; with
    /// `mass` a long step crosses it in one go. $Q$ jumps where $f_m = -f_l$. `sticking` means that the step ends at rest
    /// or, without `mass`, that $v = 0$ and $|f_e|$ is within $C + S$. In the paper the forces are those of the last step
    /// of a simulator; here they are those of the same instant, so that a law for the motor that depends on
    /// `velocity` is coupled to the friction.
    ///
    /// # Source
    /// M. Duclusaud, G. Passault, V. Padois, O. Ly, "Extended friction models for the physics simulation of servo
    /// actuators", IEEE International Conference on Robotics and Automation (2025), 12091-12097, arXiv 2410.08650, models
    /// M1 to M6; parameters of seven servos from their repository Rhoban/bam (2026), rounded to four digits, parts below
    /// 1e-6 to 0. Start values: Dynamixel MX-106, M4. Time stepping: Moreau (1988), doi:10.1007/978-3-7091-2624-0_1. The
    /// choice `exchange` is our addition.
    ///
    /// # Example
    /// ```
    /// use stribeck::component::ServoFriction;
    /// use stribeck::model::Law;
    /// let mut servo = ServoFriction { motor_coefficient: 0.1, load_coefficient: 0.2, ..Default::default() };
    /// (servo.velocity, servo.motor_force, servo.load_force) = (1e3, 2.0, -3.0); // far beyond v_S
    /// servo.viscous_coefficient = 0.0;
    /// servo.output();
    /// assert!((servo.friction_force - 0.8).abs() < 1e-12); // 0.2 * 3 + 0.1 * 2
    /// ```
    ServoFriction: "Friction of a servo drive that depends on the torques of motor and load (Duclusaud and others)" {
        velocity: input = VELOCITY,
        /// Force of the motor at the output, positive in the direction of the velocity.
        motor_force: input = real("N", 0.0).odd().means(Meaning::MotorForce),
        /// Force of the load on the output, positive in the direction of the velocity.
        load_force: input = real("N", 0.0).odd().means(Meaning::LoadForce),
        /// Kinetic level of friction without load.
        kinetic_force: tunable = real("N", 0.0).at_least(0.0).means(Meaning::Preload),
        /// Excess of the static over the kinetic level without load.
        excess_force: tunable = real("N", 0.1049).at_least(0.0).means(Meaning::Preload),
        /// Kinetic level of friction by the force of the motor.
        motor_coefficient: tunable = real("1", 0.00915).at_least(0.0).means(Meaning::Level),
        /// Kinetic level of friction by the force of the load.
        load_coefficient: tunable = real("1", 0.00915).at_least(0.0).means(Meaning::Level),
        /// Excess of the static over the kinetic level by the force of the motor.
        motor_excess: tunable = real("1", 0.2224).at_least(0.0).means(Meaning::Level),
        /// Excess of the static over the kinetic level by the force of the load.
        load_excess: tunable = real("1", 0.2224).at_least(0.0).means(Meaning::Level),
        /// Excess by the square of the force of the motor, where a larger load opposes it.
        motor_quadratic_excess: tunable = real("1/N", 0.0).at_least(0.0).nominal(1e-2).means(Meaning::Own),
        /// Excess by the square of the force of the load, where a larger force of the motor opposes it.
        load_quadratic_excess: tunable = real("1/N", 0.0).at_least(0.0).nominal(1e-2).means(Meaning::Own),
        /// Speed at which the excess of static over kinetic friction has fallen to 1/e.
        stribeck_velocity: tunable = real("m/s", 1.623).positive().means(Meaning::FallSpeed),
        /// Exponent of the Stribeck curve.
        stribeck_exponent: tunable = real("1", 1.323).positive().means(Meaning::Shape),
        viscous_coefficient: tunable = real("N.s/m", 0.05096).at_least(0.0).means(Meaning::Viscous)
            .help("Viscous friction coefficient."),
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY.nominal(0.1),
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> ServoFriction<T> {
    /// Differences of the weighted forces of load and motor, in C and in S.
    #[inline(always)]
    fn differences(&self) -> [T; 2] {
        [
            self.load_coefficient * self.load_force - self.motor_coefficient * self.motor_force,
            self.load_excess * self.load_force - self.motor_excess * self.motor_force,
        ]
    }

    /// Q.
    #[inline(always)]
    fn quadratic(&self) -> T {
        let [load, motor] = [self.load_force, self.motor_force];
        let opposed = (load * motor).below(T::zero());
        let drives = opposed & load.abs().below(motor.abs());
        let is_driven = opposed & motor.abs().below(load.abs());
        let of_motor = choose!(is_driven, self.motor_quadratic_excess * motor * motor, T::zero());
        choose!(drives, self.load_quadratic_excess * load * load, of_motor)
    }

    /// C and S.
    #[inline(always)]
    fn levels(&self) -> [T; 2] {
        let [kinetic, excess] = self.differences();
        [self.kinetic_force + kinetic.abs(), self.excess_force + excess.abs() + self.quadratic()]
    }
}

impl<T: Real> Curve<T> for ServoFriction<T> {
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        let [kinetic, excess] = self.levels();
        let level =
            stribeck::level(velocity, kinetic, kinetic + excess, self.stribeck_velocity, self.stribeck_exponent);
        level * velocity.sign() + self.viscous_coefficient * velocity
    }

    #[inline(always)]
    fn level(&self) -> T {
        let [kinetic, excess] = self.levels();
        kinetic + excess
    }

    #[inline(always)]
    fn band(&self) -> Option<T> {
        None
    }
}

memoryless!(ServoFriction, {
    #[inline(always)]
    fn inputs(&self) -> Inputs<T> {
        Inputs {
            velocity: self.velocity,
            external_force: self.motor_force + self.load_force,
            normal_force: (self.motor_force - self.load_force).abs(),
        }
    }

    #[inline(always)]
    fn given(self, Inputs { velocity, external_force, normal_force }: Inputs<T>) -> Self {
        let is_negative = self.motor_force.below(self.load_force);
        let difference = choose!(is_negative, -normal_force, normal_force);
        let half = T::from(0.5);
        let [motor_force, load_force] = [half * (external_force + difference), half * (external_force - difference)];
        Self { velocity, motor_force, load_force, ..self }
    }
});

impl ServoFriction {
    /// Sign of a function of both forces, as an event indicator of the size of their largest part.
    fn relative(difference: f64, parts: [f64; 2]) -> f64 {
        let size = parts[0].abs() + parts[1].abs();
        if size > 0.0 { difference / size } else { NO_EVENT }
    }

    /// Where the level has a kink, or a jump, in the forces.
    fn turns(&self) -> [f64; 3] {
        let [load, motor] = [self.load_force, self.motor_force];
        let of = |by_load: f64, by_motor: f64| {
            Self::relative(by_load * load - by_motor * motor, [by_load * load, by_motor * motor])
        };
        let is_quadratic = self.load_quadratic_excess + self.motor_quadratic_excess > 0.0 && load * motor < 0.0;
        [
            of(self.load_coefficient, self.motor_coefficient),
            of(self.load_excess, self.motor_excess),
            if is_quadratic { Self::relative(load + motor, [load, motor]) } else { NO_EVENT },
        ]
    }
}

/// Parameters of the models of the paper, in its order.
macro_rules! values {
    (M1($f_c:literal, $f_v:literal)) => {
        &[
            ("kinetic_force", $f_c),
            ("viscous_coefficient", $f_v),
            ("excess_force", 0.0),
            ("motor_coefficient", 0.0),
            ("load_coefficient", 0.0),
            ("motor_excess", 0.0),
            ("load_excess", 0.0),
        ]
    };
    (M2($f_c:literal, $f_e:literal, $v_s:literal, $delta:literal, $f_v:literal)) => {
        &[
            ("kinetic_force", $f_c),
            ("excess_force", $f_e),
            ("stribeck_velocity", $v_s),
            ("stribeck_exponent", $delta),
            ("viscous_coefficient", $f_v),
            ("motor_coefficient", 0.0),
            ("load_coefficient", 0.0),
            ("motor_excess", 0.0),
            ("load_excess", 0.0),
        ]
    };
    (M3($f_c:literal, $k:literal, $f_v:literal)) => {
        &[
            ("kinetic_force", $f_c),
            ("motor_coefficient", $k),
            ("load_coefficient", $k),
            ("viscous_coefficient", $f_v),
            ("excess_force", 0.0),
            ("motor_excess", 0.0),
            ("load_excess", 0.0),
        ]
    };
    (M4($f_c:literal, $f_e:literal, $k:literal, $k_s:literal, $v_s:literal, $delta:literal, $f_v:literal)) => {
        values!(M5($f_c, $f_e, $k, $k, $k_s, $k_s, $v_s, $delta, $f_v))
    };
    (M5($f_c:literal, $f_e:literal, $k_m:literal, $k_l:literal, $k_ms:literal, $k_ls:literal, $v_s:literal,
        $delta:literal, $f_v:literal)) => {
        values!(M6($f_c, $f_e, $k_m, $k_l, $k_ms, $k_ls, 0.0, 0.0, $v_s, $delta, $f_v))
    };
    (M6($f_c:literal, $f_e:literal, $k_m:literal, $k_l:literal, $k_ms:literal, $k_ls:literal, $k_mq:literal,
        $k_lq:literal, $v_s:literal, $delta:literal, $f_v:literal)) => {
        &[
            ("kinetic_force", $f_c),
            ("excess_force", $f_e),
            ("motor_coefficient", $k_m),
            ("load_coefficient", $k_l),
            ("motor_excess", $k_ms),
            ("load_excess", $k_ls),
            ("motor_quadratic_excess", $k_mq),
            ("load_quadratic_excess", $k_lq),
            ("stribeck_velocity", $v_s),
            ("stribeck_exponent", $delta),
            ("viscous_coefficient", $f_v),
        ]
    };
}

/// Presets in one line each: name, model of the paper with its values, servo.
macro_rules! presets {
    ($($name:literal: $Model:ident $values:tt of $servo:literal;)+) => {
        &[$(Preset {
            name: $name,
            source: concat!(
                "Rhoban/bam (2026), see Duclusaud et al. (2025), ", $servo, ", model ", stringify!($Model), "; N.m and rad/s"
            ),
            values: values!($Model $values),
        }),+]
    };
}

impl Model for ServoFriction {
    #[rustfmt::skip] // one line each
    const PRESETS: &'static [Preset] = presets! {
        "mx106_m1": M1(0.1035, 0.0352) of "Dynamixel MX-106";
        "mx106_m2": M2(2.769e-6, 0.1174, 1.849, 1.741, 0.05959) of "Dynamixel MX-106";
        "mx106_m3": M3(0.1134, 0.1082, 0.01194) of "Dynamixel MX-106";
        "mx106_m4": M4(0.0, 0.1049, 0.00915, 0.2224, 1.623, 1.323, 0.05096) of "Dynamixel MX-106";
        "mx106_m5": M5(0.0, 0.1224, 0.2076, 0.02268, 0.1952, 0.0849, 1.746, 1.138, 0.05066) of "Dynamixel MX-106";
        "mx106_m6": M6(1.023e-5, 0.122, 0.198, 0.02222, 0.1986, 0.0871, 0.01, 7.327e-5, 1.746, 1.143, 0.05072) of "Dynamixel MX-106";
        "mx64_m1": M1(0.09039, 0.01169) of "Dynamixel MX-64";
        "mx64_m2": M2(0.05612, 0.08186, 1.12, 3.0, 0.01918) of "Dynamixel MX-64";
        "mx64_m3": M3(0.1022, 0.0758, 0.00063) of "Dynamixel MX-64";
        "mx64_m4": M4(0.06155, 0.0239, 0.0, 0.2343, 1.521, 1.334, 0.01475) of "Dynamixel MX-64";
        "mx64_m5": M5(0.07502, 0.02223, 0.3848, 0.0, 0.03012, 0.1659, 0.7462, 1.293, 0.01491) of "Dynamixel MX-64";
        "mx64_m6": M6(0.0, 0.1227, 0.3115, 0.0, 0.1877, 0.01407, 0.006909, 0.01, 2.575, 0.8409, 0.02534) of "Dynamixel MX-64";
        "xl320_m1": M1(0.02751, 0.003318) of "Dynamixel XL-320";
        "xl320_m2": M2(0.0, 0.02989, 2.329, 1.229, 0.009149) of "Dynamixel XL-320";
        "xl320_m3": M3(0.02063, 0.219, 0.002263) of "Dynamixel XL-320";
        "xl320_m4": M4(0.0, 0.0215, 0.2214, 0.0, 1.967, 1.836, 0.007794) of "Dynamixel XL-320";
        "xl320_m5": M5(0.0, 0.01629, 0.0, 0.1581, 0.0, 0.2462, 2.303, 1.704, 0.007224) of "Dynamixel XL-320";
        "xl320_m6": M6(0.0, 0.01631, 3.088e-6, 0.1583, 0.0, 0.2455, 0.003616, 0.004711, 2.301, 1.707, 0.007225) of "Dynamixel XL-320";
        "xl330_m1": M1(0.01283, 0.003662) of "Dynamixel XL-330";
        "xl330_m2": M2(0.0, 0.01265, 4.167, 1.364, 0.005621) of "Dynamixel XL-330";
        "xl330_m3": M3(0.008882, 0.1217, 0.004379) of "Dynamixel XL-330";
        "xl330_m4": M4(0.008759, 0.0, 0.06803, 0.07381, 2.558, 0.7601, 0.004621) of "Dynamixel XL-330";
        "xl330_m5": M5(0.000366, 0.008678, 0.2897, 0.0, 3.057e-5, 0.05868, 3.189, 2.99, 0.006348) of "Dynamixel XL-330";
        "xl330_m6": M6(0.004771, 0.004676, 0.2668, 8.516e-6, 1.072e-5, 0.08078, 0.009972, 0.004903, 2.89, 8.683, 0.00536) of "Dynamixel XL-330";
        "erob80_50_m1": M1(4.097, 1.298) of "eRob80:50";
        "erob80_50_m2": M2(4.086, 0.0, 0.9618, 1.439, 1.313) of "eRob80:50";
        "erob80_50_m3": M3(3.467, 0.06292, 1.207) of "eRob80:50";
        "erob80_50_m4": M4(3.454, 9.218e-6, 0.06309, 0.0, 0.346, 2.727, 1.217) of "eRob80:50";
        "erob80_50_m5": M5(2.367, 0.838, 0.03418, 0.0002679, 0.0154, 0.08496, 2.264, 2.985, 1.609) of "eRob80:50";
        "erob80_50_m6": M6(3.259, 0.3204, 0.03566, 0.0008432, 0.003771, 0.04144, 0.001872, 0.001599, 2.83, 1.786, 1.403) of "eRob80:50";
        "erob80_100_m1": M1(5.611, 8.392) of "eRob80:100";
        "erob80_100_m2": M2(0.0, 5.455, 2.08, 3.0, 9.571) of "eRob80:100";
        "erob80_100_m3": M3(4.832, 0.148, 7.395) of "eRob80:100";
        "erob80_100_m4": M4(0.0001251, 4.382, 2.127e-6, 0.1661, 1.977, 3.0, 9.029) of "eRob80:100";
        "erob80_100_m5": M5(0.0008544, 3.897, 0.001439, 3.392e-6, 7.95e-5, 0.2545, 1.85, 2.999, 8.888) of "eRob80:100";
        "erob80_100_m6": M6(0.000478, 5.226, 0.04889, 0.0, 8.823e-6, 0.05117, 0.002703, 0.002556, 2.033, 3.0, 9.709) of "eRob80:100";
        "sts3215_m1": M1(0.05239, 0.05909) of "Feetech STS3215, 7.4 V";
    };

    const EVENT_INDICATORS: usize = 4;

    fn event_indicators(&self, indicators: &mut [f64]) {
        let [kinetic, excess, quadratic] = self.turns();
        let phase = crate::contact::time_stepping::Holding::contact(self).indicator_of_phase();
        indicators.copy_from_slice(&[phase, kinetic, excess, quadratic]);
    }

    memoryless!(without events);
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::friction::{CoulombViscous, Stribeck};
    use crate::model::{Columns, Law};
    use crate::numerics::root::bisect;

    /// M6 in round numbers, with v_S = 1 and delta = 1.
    fn servo(velocity: f64, motor_force: f64, load_force: f64) -> ServoFriction {
        ServoFriction {
            velocity,
            motor_force,
            load_force,
            kinetic_force: 0.5,
            excess_force: 0.25,
            motor_coefficient: 0.1,
            load_coefficient: 0.2,
            motor_excess: 0.3,
            load_excess: 0.05,
            motor_quadratic_excess: 0.04,
            load_quadratic_excess: 0.02,
            stribeck_velocity: 1.0,
            stribeck_exponent: 1.0,
            viscous_coefficient: 0.7,
            ..Default::default()
        }
    }

    fn force(mut law: ServoFriction) -> f64 {
        law.output();
        law.friction_force
    }

    /// Friction of the MX-106 at 0.5 rad/s, 1 N.m of the motor against a load of 2 N.m, by the program of the paper's
    /// authors with its unrounded parameters.
    const MX_106: [(&str, f64); 6] = [
        ("mx106_m1", 0.121_121),
        ("mx106_m2", 0.135_771),
        ("mx106_m3", 0.444_047),
        ("mx106_m4", 0.678_416),
        ("mx106_m5", 0.661_403),
        ("mx106_m6", 0.665_070),
    ];

    fn preset(name: &str) -> ServoFriction {
        let mut law = ServoFriction::default();
        let preset = ServoFriction::PRESETS.iter().find(|preset| preset.name == name).unwrap();
        for (variable, value) in preset.values {
            let column = ServoFriction::TABLE.iter().position(|column| column.path.to_string() == *variable).unwrap();
            crate::model::row_of_mut(&mut law)[column] = *value;
        }
        law
    }

    /// C = 0.5 + |0.2 f_l - 0.1 f_m|, S = 0.25 + |0.05 f_l - 0.3 f_m| + Q by hand.
    #[test]
    fn each_force_has_its_part_of_the_level() {
        for (motor, load, kinetic, excess) in [
            (0.0, 0.0, 0.5, 0.25),
            (2.0, 3.0, 0.9, 0.70),        // both drive: no Q
            (2.0, -3.0, 1.3, 1.0 + 0.16), // back-driven: 0.04 * 2^2
            (-4.0, 3.0, 1.5, 1.6 + 0.18), // driving: 0.02 * 3^2
            (2.0, -2.0, 1.1, 0.95),
        ] {
            for v in [0.3, 2.0] {
                let sliding = kinetic + excess * f64::exp(-v) + 0.7 * v;
                assert_abs_diff_eq!(force(servo(v, motor, load)), sliding, epsilon = 1e-14);
                assert_abs_diff_eq!(force(servo(-v, -motor, -load)), -sliding, epsilon = 1e-14);
                // Friction of the same forces in the other direction.
                assert_abs_diff_eq!(force(servo(-v, motor, load)), -sliding, epsilon = 1e-14);
            }
            let (sum, level): (f64, f64) = (motor + load, kinetic + excess);
            assert_abs_diff_eq!(force(servo(0.0, motor, load)), sum.clamp(-level, level), epsilon = 1e-14);
        }
    }

    /// Forces of the motor between which a load is held, by bisection and from the straight lines of the paper's
    /// diagrams of driving and back-driving.
    #[test]
    fn a_load_is_held_between_two_straight_lines() {
        for (name, constant, motor, load) in [
            ("mx106_m1", 0.1035, 0.0, 0.0),
            ("mx106_m2", 0.117_402_769, 0.0, 0.0),
            ("mx106_m3", 0.1134, 0.1082, 0.1082),
            ("mx106_m4", 0.1049, 0.231_55, 0.231_55),
            ("mx106_m5", 0.1224, 0.4028, 0.107_58),
        ] {
            for f_l in [-8.0, -3.0, -1.0] {
                let excess = |f_m: f64| {
                    let law = ServoFriction { motor_force: f_m, load_force: f_l, ..preset(name) };
                    (f_m + f_l).abs() - law.level()
                };
                let lifts = bisect(excess, -f_l, 20.0);
                assert_abs_diff_eq!(lifts, (constant - f_l * (1.0 + load)) / (1.0 - motor), epsilon = 1e-12);
                let gives_way = bisect(|f_m| -excess(f_m), -10.0, -f_l);
                assert_abs_diff_eq!(gives_way, (-f_l * (1.0 - load) - constant) / (1.0 + motor), epsilon = 1e-12);
            }
        }
    }

    #[test]
    fn models_of_the_paper_differ_at_the_same_forces() {
        for (model, expected) in MX_106 {
            let law = ServoFriction { velocity: 0.5, motor_force: 1.0, load_force: -2.0, ..preset(model) };
            assert_abs_diff_eq!(force(law), expected, epsilon = 2e-4);
        }
    }

    /// M1 is Coulomb friction with a viscous part, M2 the Stribeck curve, whatever the forces are, and however they are
    /// exchanged: along motions with turns and rest.
    #[test]
    fn models_without_load_are_the_laws_of_friction() {
        for (mass, exchange) in [(0.0, 1.0), (0.03, 1.0), (0.03, 2.0)] {
            let mut servos = [preset("mx106_m1"), preset("mx106_m2")];
            let mut coulomb = CoulombViscous { normal_force: 1.0, mu_k: 0.1035, ..Default::default() };
            coulomb.viscous_coefficient = 0.0352;
            let mut falling = Stribeck { normal_force: 1.0, mu_k: 2.769e-6, mu_s: 0.117_402_769, ..Default::default() };
            (falling.curve, falling.stribeck_velocity, falling.stribeck_exponent) = (2.0, 1.849, 1.741);
            falling.viscous_coefficient = 0.05959;
            for steps in servos.iter_mut().map(|servo| &mut servo.time_stepping) {
                (steps.mass, steps.exchange) = (mass, exchange);
            }
            (coulomb.time_stepping, falling.time_stepping) = (servos[0].time_stepping, servos[0].time_stepping);
            for k in 0..400 {
                let t = f64::from(k) * 0.01;
                let (velocity, external_force) = ((t.sin() * (7.3 * t).cos()).clamp(-0.4, 0.6), 0.3 * (3.0 * t).sin());
                for servo in &mut servos {
                    (servo.velocity, servo.load_force) = (velocity, 0.2 * (5.0 * t).cos());
                    servo.motor_force = external_force - servo.load_force;
                    servo.step(1e-3);
                    servo.output();
                }
                (coulomb.velocity, coulomb.external_force) = (velocity, external_force);
                (falling.velocity, falling.external_force) = (velocity, external_force);
                coulomb.step(1e-3);
                coulomb.output();
                falling.step(1e-3);
                falling.output();
                for (servo, force, sticking) in [
                    (servos[0], coulomb.friction_force, coulomb.sticking),
                    (servos[1], falling.friction_force, falling.sticking),
                ] {
                    assert_abs_diff_eq!(servo.friction_force, force, epsilon = 1e-13);
                    assert_eq!(servo.sticking, sticking, "{k}");
                }
            }
            assert_abs_diff_eq!(servos[0].dissipated_energy, coulomb.dissipated_energy, epsilon = 1e-12);
        }
    }

    /// Under forces that move linearly a held body stays at rest: the friction force has the mean of their sum, whose
    /// impulse it takes away; it lets go when that exceeds the level of the mean forces.
    #[test]
    fn a_body_is_held_under_forces_that_move() {
        let mut law = servo(0.0, 0.5, -1.0);
        law.time_stepping.mass = 0.05;
        let (h, mut held) = (0.01, 0);
        let slope = ServoFriction { motor_force: 20.0, load_force: -4.0, velocity: 0.0, ..law.map(&|_| 0.0) };
        for step in 0..60 {
            let mean = [20.0, -4.0].map(|rate| rate * h * (f64::from(step) + 0.5));
            let [motor, load] = [0.5 + mean[0], mean[1] - 1.0];
            let level = servo(0.0, motor, load).level();
            law.step_ramp(&slope, h);
            law.output();
            if (motor + load).abs() > level {
                break;
            }
            held += 1;
            assert_eq!(law.sticking, 1.0, "{step}");
            assert_abs_diff_eq!(law.friction_force, motor + load, epsilon = 1e-14);
        }
        assert!(held > 10 && law.sticking == 0.0, "held for {held} steps");
    }

    /// A body that is stopped by the friction of what drives it: the equation of its step, solved here on its own.
    #[test]
    fn a_step_with_mass_ends_where_the_level_of_its_own_forces_takes_it() {
        for (motor, load, v) in [(1.0, -3.0, 2.0), (3.0, -1.0, 2.0), (0.0, -6.0, 3.0), (2.0, 2.0, 0.1)] {
            let mut law = servo(v, motor, load);
            law.time_stepping.mass = 0.2;
            let h = 0.05;
            let printed = |w: f64| force(servo(w, motor, load));
            let residual = |w: f64| 0.2 * (w - v) / h + printed(w) - (motor + load);
            law.step(h);
            law.output();
            let end = v + h * (motor + load - law.friction_force) / 0.2;
            assert!(end > 1e-3 && residual(end).abs() < 1e-12, "{end}: {}", residual(end));
        }
    }
}
