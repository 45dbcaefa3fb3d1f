use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::laws::{stribeck, viscous};
use crate::model::{Fault, Meaning, Model, Preset, real};
use crate::number::{Real, choose};

/// Temperature at which the parameters hold, in K (chosen: 20 degC).
const REFERENCE: f64 = 293.15;

/// Logarithm of the factor by which the cold part of the viscous coefficient may grow (chosen: 22,000 times).
const THICKEST: f64 = 10.0;

crate::model! {
    /// Friction of a joint of a robot with its gear: levels that grow with the load and a lubricant that thins with the
    /// temperature, and a contact that holds at rest.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = S(v) sgn(v) + B v                       v != 0
    /// f_f = min(|f_e|, S(0)) sgn(f_e)               v  = 0
    ///
    /// S = f_C + mu_k f_n + (mu_s - mu_k) f_n exp(-(|v| / v_S)^delta) + F exp(-(|v| / V)^delta)
    /// F = f_E (1 + k_E (T - T_0)),   V = v_E (1 + k_V (T - T_0)),   B = f_v + f_w exp(-(T - T_0) / T_v)
    /// ```
    ///
    /// With `mass` $m > 0$ the force over a step $h$ is that of the velocity $w$ at its end; the jump at rest is part
    /// of $f_f$. Of several solutions it is the first one reached from $v$ in the direction of the acceleration
    /// (implicit Euler; time stepping in the sense of Moreau):
    ///
    /// ```text
    /// m (w - v) / h = f_e - f_f(w)
    /// ```
    ///
    /// | symbol | variable                     | unit  | meaning                                            |
    /// |--------|------------------------------|-------|----------------------------------------------------|
    /// | v      | `velocity`                   | m/s   | velocity of body 1 relative to body 2              |
    /// | f_n    | `normal_force`               | N     | force pressing the surfaces together: the load     |
    /// | f_e    | `external_force`             | N     | all other tangential forces on body 1              |
    /// | mu_k   | `mu_k`                       | 1     | kinetic coefficient of friction of the load        |
    /// | mu_s   | `mu_s`                       | 1     | static coefficient of friction of the load         |
    /// | v_S    | `stribeck_velocity`          | m/s   | Stribeck velocity of the load's excess             |
    /// | f_C    | `kinetic_force`              | N     | kinetic level without load                         |
    /// | f_E    | `excess_force`               | N     | excess of the static level without load, at T_0    |
    /// | k_E    | `excess_by_temperature`      | 1/K   | relative change of f_E with temperature            |
    /// | v_E    | `stribeck_velocity_unloaded` | m/s   | Stribeck velocity of f_E, at T_0                   |
    /// | k_V    | `velocity_by_temperature`    | 1/K   | relative change of v_E with temperature            |
    /// | delta  | `stribeck_exponent`          | 1     | exponent of both curves                            |
    /// | f_v    | `viscous_coefficient`        | N.s/m | viscous coefficient of a hot joint                 |
    /// | f_w    | `viscous_coefficient_cold`   | N.s/m | what is added to it at T_0                         |
    /// | T_v    | `viscous_temperature`        | K     | rise of temperature after which 1/e of f_w is left |
    /// | T      | `temperature`                | K     | temperature of the lubricant                       |
    /// | T_0    |                              | K     | 293.15, 20 degC                                    |
    /// | m      | `mass`                       | kg    | effective mass of the host, 0 = the printed law    |
    /// | h      | `step_size`                  | s     | last communication step                            |
    /// | f_f    | `friction_force`             | N     | friction force                                     |
    ///
    /// Of a joint that turns the velocity is in rad/s, forces are torques in N.m, the mass is a moment of inertia.
    /// `normal_force` is then the magnitude of the torque that the gear transmits.
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` when sliding and the sign of `external_force` when stuck; body 1
    /// feels `-friction_force`. Dissipated power is `friction_force * velocity`; outside rest it is never negative: the
    /// law is passive.
    ///
    /// # Step
    /// Without `mass` the law has no memory; only the dissipated energy is integrated, exactly for held inputs. A host
    /// that integrates the body itself never reaches $v = 0$ exactly, so the force of a contact at rest then alternates
    /// at any step. With `mass` the body is caught where it comes to rest and neither chatters nor creeps; there is no
    /// largest step. In Model Exchange a contact is held or slides in one direction from one event to the next. A held
    /// contact returns `external_force`: connect it, or the body is released and caught again endlessly.
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`; a temperature at which $F$ would be negative, $V$ not
    /// positive, or the part $f_w$ of $B$ more than e^10 = 22,000 times as large as at $T_0$.
    ///
    /// # Limits
    /// Without `kinetic_force`, `excess_force` and `viscous_coefficient_cold` it is `Stribeck` with `curve` =
    /// BoPavelescu. The law does not heat itself: what heats the joint changes `temperature` between steps. No pre-sliding displacement.
    /// The falling branches take a driven body through stick-slip; with `mass` a long step crosses them in one go.
    /// Where `normal_force`, `kinetic_force` and `excess_force` are all 0, nothing presses the surfaces together: force
    /// 0, also of the viscous part. `sticking` means that the step ends at rest or, without `mass`, that $v = 0$ and
    /// $|f_e|$ is within $S(0)$. A strut does not have the law: its contacts have no friction without load.
    ///
    /// # Source
    /// A. Carvalho Bittencourt, S. Gunnarsson, "Static friction in a robot joint: modeling and identification of load and
    /// temperature effects", Journal of Dynamic Systems, Measurement and Control 134 (2012) 051013,
    /// doi:10.1115/1.4006589. There $F_c,0 = f_C$, $F_c,tau = mu_k$, $F_s,tau = mu_s - mu_k$ and
    /// $F_s,0 + F_s,T T = F$, $w_s,0 + w_s,T T = V$, $F_v,0 = f_v$, $F_v,T exp(-T_0 / T_v) = f_w$ with $T$ in degC, and
    /// an exponent of 1.3. All start values but those of other laws are chosen; those of load and temperature are 0, so
    /// that what was not measured has no effect. Time stepping: Moreau (1988), doi:10.1007/978-3-7091-2624-0_1. The
    /// choice `exchange` is our addition.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::JointFriction;
    /// use stribeck::model::Law;
    /// let mut law = JointFriction { velocity: 1.0, normal_force: 10.0, kinetic_force: 2.0, ..Default::default() };
    /// law.output();
    /// assert_eq!(law.friction_force, 3.0); // f_C + mu_k f_n
    /// (law.viscous_coefficient_cold, law.viscous_temperature, law.temperature) = (4.0, 20.0, 293.15 + 20.0);
    /// law.output();
    /// assert!((law.friction_force - 3.0 - 4.0 * (-1.0f64).exp()).abs() < 1e-12);
    /// ```
    JointFriction: "Friction of a joint by load and temperature (Bittencourt and Gunnarsson)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        stribeck_velocity: tunable = STRIBECK_VELOCITY,
        /// Kinetic level of friction without load.
        kinetic_force: tunable = real("N", 0.0).at_least(0.0).means(Meaning::Preload),
        /// Excess of the static over the kinetic level without load, at 20 degC.
        excess_force: tunable = real("N", 0.0).at_least(0.0).means(Meaning::Preload),
        /// Relative change of excess_force with temperature.
        excess_by_temperature: tunable = real("1/K", 0.0).nominal(1e-2).means(Meaning::EffectOfCondition),
        stribeck_velocity_unloaded: tunable = STRIBECK_VELOCITY
            .help("Speed at which the excess without load has fallen to 1/e, at 20 degC."),
        /// Relative change of stribeck_velocity_unloaded with temperature.
        velocity_by_temperature: tunable = real("1/K", 0.0).nominal(1e-2).means(Meaning::EffectOfCondition),
        stribeck_exponent: tunable = STRIBECK_EXPONENT,
        viscous_coefficient: tunable = VISCOUS_COEFFICIENT,
        /// Viscous coefficient that is added at 20 degC, less in a warmer joint.
        viscous_coefficient_cold: tunable = real("N.s/m", 0.0).at_least(0.0).means(Meaning::EffectOfCondition),
        /// Rise of temperature after which 1/e of viscous_coefficient_cold is left (start value chosen).
        viscous_temperature: tunable = real("K", 20.0).positive().nominal(20.0).means(Meaning::EffectOfCondition),
        /// Temperature of the lubricant.
        temperature: tunable = real("K", REFERENCE).at_least(0.0).nominal(300.0).shown_in("degC").means(Meaning::Condition),
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> JointFriction<T> {
    /// T - T_0.
    #[inline(always)]
    fn warming(&self) -> T {
        self.temperature - T::from(REFERENCE)
    }

    /// Height of the excess due to the load.
    #[inline(always)]
    fn excess_of_load(&self) -> T {
        (self.mu_s - self.mu_k) * self.normal_force
    }

    /// F.
    #[inline(always)]
    fn excess(&self) -> T {
        self.excess_force * (T::from(1.0) + self.excess_by_temperature * self.warming())
    }

    /// V.
    #[inline(always)]
    fn speed_of_excess(&self) -> T {
        self.stribeck_velocity_unloaded * (T::from(1.0) + self.velocity_by_temperature * self.warming())
    }

    /// B.
    #[inline(always)]
    fn viscous(&self) -> T {
        let thinning = || (-self.warming() / self.viscous_temperature).exp();
        let cold = self.viscous_coefficient_cold;
        // Without it the exponential does not matter, even where it overflows.
        self.viscous_coefficient + choose!(cold.is_positive(), cold * thinning(), T::zero())
    }

    /// S - S(infinity) + the kinetic levels.
    #[inline(always)]
    fn falling_level(&self, velocity: T) -> T {
        let falling = |excess, speed| stribeck::level(velocity, T::zero(), excess, speed, self.stribeck_exponent);
        self.kinetic_force
            + self.mu_k * self.normal_force
            + falling(self.excess_of_load(), self.stribeck_velocity)
            + falling(self.excess(), self.speed_of_excess())
    }
}

impl<T: Real> Curve<T> for JointFriction<T> {
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        let pressing = self.normal_force + self.kinetic_force + self.excess_force;
        self.falling_level(velocity) * velocity.sign() + viscous::force(velocity, self.viscous(), pressing)
    }

    #[inline(always)]
    fn level(&self) -> T {
        self.kinetic_force + self.mu_s * self.normal_force + self.excess()
    }

    #[inline(always)]
    fn band(&self) -> Option<T> {
        None
    }

    fn turning_again(&self) -> f64 {
        let parts = [(self.excess_of_load(), self.stribeck_velocity), (self.excess(), self.speed_of_excess())];
        let parts = parts.map(|(excess, speed)| [excess.lane(0), speed.lane(0)]);
        stribeck::turning_again(parts, self.stribeck_exponent.lane(0))
    }
}

memoryless!(JointFriction);

impl Model for JointFriction {
    const PRESETS: &'static [Preset] = &[Preset {
        name: "warm_gear",
        source: "Example of a joint with a gear, in N.m and rad/s at the arm; exponent of Bittencourt and Gunnarsson \
                 (2012)",
        values: &[
            ("normal_force", 100.0),
            ("mu_k", 0.02),
            ("mu_s", 0.05),
            ("stribeck_velocity", 0.05),
            ("kinetic_force", 20.0),
            ("excess_force", 4.0),
            ("excess_by_temperature", 0.02),
            ("stribeck_velocity_unloaded", 0.03),
            ("velocity_by_temperature", 0.03),
            ("stribeck_exponent", 1.3),
            ("viscous_coefficient", 6.0),
            ("viscous_coefficient_cold", 12.0),
        ],
    }];

    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)?;
        let refuse = |rule| Err(Fault::new(format_args!("temperature = {}: {rule}", self.temperature)));
        if self.excess() < 0.0 {
            return refuse(format_args!("1 + excess_by_temperature (temperature - {REFERENCE}) must be >= 0"));
        }
        if self.speed_of_excess() <= 0.0 {
            return refuse(format_args!("1 + velocity_by_temperature (temperature - {REFERENCE}) must be > 0"));
        }
        if self.viscous_coefficient_cold > 0.0 && -self.warming() > THICKEST * self.viscous_temperature {
            return refuse(format_args!("({REFERENCE} - temperature) / viscous_temperature must be <= {THICKEST}"));
        }
        Ok(())
    }

    memoryless!();
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::friction::Stribeck;
    use crate::model::Law;

    /// A cold joint at a load of 10 N; round numbers.
    fn joint(velocity: f64) -> JointFriction {
        JointFriction {
            velocity,
            normal_force: 10.0,
            mu_k: 0.1,
            mu_s: 0.4,
            stribeck_velocity: 0.5,
            kinetic_force: 2.0,
            excess_force: 5.0,
            excess_by_temperature: 0.02,
            stribeck_velocity_unloaded: 0.1,
            velocity_by_temperature: 0.05,
            stribeck_exponent: 1.3,
            viscous_coefficient: 3.0,
            viscous_coefficient_cold: 7.0,
            viscous_temperature: 25.0,
            ..Default::default()
        }
    }

    fn force(mut law: JointFriction) -> f64 {
        law.output();
        law.friction_force
    }

    /// The six terms by hand, cold and at 45 degC: F = 7.5, V = 0.225, B = 3 + 7 / e.
    #[test]
    fn each_term_follows_load_speed_and_temperature() {
        let excess = |u: f64| (-u.powf(1.3)).exp();
        for v in [1e-9f64, 0.05, 0.3, 2.0] {
            let cold = 3.0 + 3.0 * excess(v / 0.5) + 5.0 * excess(v / 0.1) + 10.0 * v;
            assert_abs_diff_eq!(force(joint(v)), cold, epsilon = 1e-12);
            let b = 3.0 + 7.0 / 1.0f64.exp();
            let warm = 3.0 + 3.0 * excess(v / 0.5) + 7.5 * excess(v / 0.225) + b * v;
            let law = JointFriction { temperature: 318.15, ..joint(v) };
            assert_abs_diff_eq!(force(law), warm, epsilon = 1e-11);
            assert_abs_diff_eq!(force(JointFriction { velocity: -v, ..law }), -warm, epsilon = 1e-11);
        }
        // Without load the joint has friction of its own, and it holds f_C + f_E.
        assert_abs_diff_eq!(force(JointFriction { normal_force: 0.0, ..joint(5.0) }), 52.0, epsilon = 1e-12);
        let held = |external_force| force(JointFriction { normal_force: 0.0, external_force, ..joint(0.0) });
        assert_eq!([6.9, 7.1, -8.0].map(held), [6.9, 7.0, -7.0]);
    }

    #[test]
    fn temperatures_without_a_level_are_refused_by_name() {
        let check = |law: JointFriction| law.check().map_err(|fault| fault.to_string());
        let cold = |temperature| check(JointFriction { temperature, ..joint(0.1) });
        assert_eq!(cold(273.16), Ok(()));
        let text = "temperature = 273.15: 1 + velocity_by_temperature (temperature - 293.15) must be > 0";
        assert_eq!(cold(273.15), Err(text.to_owned()));
        let text = "temperature = 243: 1 + excess_by_temperature (temperature - 293.15) must be >= 0";
        assert_eq!(cold(243.0), Err(text.to_owned()));
        let thick = |viscous_coefficient_cold| {
            check(JointFriction {
                temperature: 290.0,
                viscous_temperature: 0.3,
                viscous_coefficient_cold,
                ..joint(0.1)
            })
        };
        assert_eq!(thick(0.0), Ok(()));
        let text = "temperature = 290: (293.15 - temperature) / viscous_temperature must be <= 10";
        assert_eq!(thick(7.0), Err(text.to_owned()));
    }

    /// With one curve and no temperature it is Stribeck's law, along a motion with jumps, turns and rest.
    #[test]
    fn a_joint_with_friction_by_load_only_is_stribeck() {
        for (mass, exchange) in [(0.0, 1.0), (0.3, 1.0), (0.3, 2.0)] {
            let mut joint = JointFriction { stribeck_velocity: 2e-3, ..Default::default() };
            let mut even = Stribeck { curve: 2.0, stribeck_velocity: 2e-3, ..Default::default() };
            (joint.stribeck_exponent, even.stribeck_exponent) = (1.5, 1.5);
            (joint.viscous_coefficient, even.viscous_coefficient) = (0.7, 0.7);
            (joint.time_stepping.mass, joint.time_stepping.exchange) = (mass, exchange);
            even.time_stepping = joint.time_stepping;
            for k in 0..400 {
                let t = f64::from(k) * 0.01;
                let velocity = 4e-3 * (t.sin() * (7.3 * t).cos()).clamp(-0.4, 0.6);
                (joint.velocity, even.velocity) = (velocity, velocity);
                (joint.external_force, even.external_force) = ((3.0 * t).sin(), (3.0 * t).sin());
                joint.step(1e-3);
                even.step(1e-3);
                joint.output();
                even.output();
                assert_abs_diff_eq!(joint.friction_force, even.friction_force, epsilon = 1e-14);
                assert_eq!(joint.sticking, even.sticking, "{k}");
            }
            assert_abs_diff_eq!(joint.dissipated_energy, even.dissipated_energy, epsilon = 1e-13);
        }
    }

    /// Two humps of very different speeds: a body that is slowed down lands on the first balance, found here on a fine
    /// grid, whatever hump it starts on.
    #[test]
    fn a_body_lands_on_the_first_balance_between_two_humps() {
        let mut seen = 0;
        for number in 0..4000u32 {
            let random = |k: u32| (f64::from(number * 7 + k) * 0.618_033_988_749_894_9).fract();
            let mut law = JointFriction {
                stribeck_velocity_unloaded: 0.005 + 0.03 * random(1),
                stribeck_velocity: 0.5,
                stribeck_exponent: 1.2 + 3.0 * random(2),
                excess_by_temperature: 0.0,
                velocity_by_temperature: 0.0,
                viscous_coefficient: 0.0,
                viscous_coefficient_cold: 0.0,
                external_force: 9.0 * random(3),
                ..joint(1.2 * random(4))
            };
            law.time_stepping.mass = 0.2 + 3.0 * random(5);
            let (mass, h, v, load) = (law.time_stepping.mass, 0.1 + 0.2 * random(6), law.velocity, law.external_force);
            let before = law;
            let residual = |w: f64| mass * (w - v) / h + before.curve(w) - load;
            let at = |k: i32| v * (1.0 - f64::from(k) / 5000.0);
            if residual(v) <= 0.0 {
                continue;
            }
            let Some(first) = (1..5000).find(|k| residual(at(*k)) <= 0.0) else { continue };
            law.step(h);
            law.output();
            // Between two points of the grid there may be another one, above.
            let landed = v + h * (load - law.friction_force) / mass;
            assert!(landed >= at(first) && residual(landed).abs() < 1e-9, "{number}: {landed} below {}", at(first));
            let again = law.turning_again();
            seen += u32::from(again > 0.0 && landed < again && again < v);
        }
        assert!(seen > 10, "only {seen} passed the second hump");
    }
}
