use crate::contact::quantities::*;
use crate::contact::unloading::released_without_load;
use crate::laws::specker::SpeckerCurve;
use crate::model::{Derivatives, Fault, Law, Meaning, Model, ModelExchange, Preset, Steps, change, in_lanes, real};
use crate::number::{Real, choose};
use crate::numerics::relaxation::{self, Relaxation};

crate::model! {
    /// Dynamic Specker friction, reconstructed: the smooth curve of Specker behind a first-order low-pass whose time
    /// constant depends on the velocity, so that small motions see a spring instead of a damper.
    ///
    /// # Equations
    ///
    /// ```text
    /// T(v) df_f/dt + f_f = f_stat(v)
    /// T(v)      = T_slip + (T_stick - T_slip) exp(-(v / v_Sp)^2),   T_stick = K_0 / sigma_0
    /// f_stat(v) = f_C tanh(v / v_0) + f_p (v / v_Sp) exp(1/2 (1 - (v / v_Sp)^2)) + c_v v    (6.27)
    /// f_p       = f_s - f_C tanh(v_Sp / v_0) - c_v v_Sp,  not below 0
    /// K_0       = f_C / v_0 + f_p exp(1/2) / v_Sp + c_v          slope of f_stat at rest
    /// f_C = mu_k f_n,   f_s = mu_s f_n
    /// ```
    ///
    /// | symbol  | variable              | unit  | meaning                                      |
    /// |---------|-----------------------|-------|----------------------------------------------|
    /// | v       | `velocity`            | m/s   | velocity of body 1 relative to body 2        |
    /// | f_n     | `normal_force`        | N     | force pressing the surfaces together         |
    /// | mu_k    | `mu_k`                | 1     | kinetic coefficient of friction              |
    /// | mu_s    | `mu_s`                | 1     | static coefficient of friction               |
    /// | v_0     | `transition_velocity` | m/s   | velocity scale of the transition             |
    /// | v_Sp    | `peak_velocity`       | m/s   | velocity at which $f_stat$ is $f_s$          |
    /// | c_v     | `viscous_coefficient` | N.s/m | viscous coefficient                          |
    /// | sigma_0 | `sigma_0`             | N/m   | stiffness seen by small and short motions    |
    /// | T_slip  | `slip_time`           | s     | lag of the force while sliding               |
    /// | f_f     | `friction_force`      | N     | friction force; its state is `lagging_force` |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` in steady sliding; body 1 feels `-friction_force`. Dissipated power
    /// is `friction_force * velocity`; it is negative while the force lags behind a reversal.
    ///
    /// # Step
    /// With held inputs the equation of $f_f$ is linear and solved exactly, so the result does not depend on how an
    /// interval is divided, from 1 us to 1 s; the energy is its closed form. No events. `sticking` means $|v| < v_Sp$.
    ///
    /// A master that integrates a mass m with the force it reads couples it explicitly to the stiffness k of the
    /// contact at rest. If the friction steps first, a held body stays still for communication steps below 2 sqrt(m /
    /// k), which is 6.3 ms for the defaults and 1 kg; above, it chatters within the bounds of the force. If all models
    /// step at once and exchange afterwards, it chatters at every step, since nothing damps the stiffness: take the
    /// friction first, or Model Exchange.
    ///
    #[doc = include_str!("slopes.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`; in Model Exchange `mu_s` = 0 without viscous part,
    /// where the force has no time constant at rest, and a solver would keep the old force.
    ///
    /// # Limits
    /// Cannot hold a load: under a constant load below $f_s$ the body creeps with the speed at which $f_stat$ is the
    /// load, and after a stop the force vanishes within $T_stick$ (57 ms for the defaults). A step of the velocity to
    /// $v << v_Sp$ gives $f_f = K_0 v (1 - exp(-t / T_stick))$, which is $sigma_0 x$ for $t << T_stick$. $|f_f|$ never
    /// exceeds the maximum of $|f_stat|$ and the viscous part at constant load. The maximum is $1.0044 f_s$ for the
    /// defaults, $1.024 f_s$ for `mu_s` = `mu_k`, and below $f_s + f_C (1 - tanh(v_Sp / v_0))$ for any levels.
    ///
    /// Not passive: after a reversal from a force $f_0$ to a speed $V$ well above $v_Sp$ the contact returns the energy
    /// $V T_slip (f_0 - f_C ln(1 + f_0 / f_C))$, and fast cycles with slow parts in between gain energy. The power that
    /// it returns is below $|f_f v|$, and vanishes with $T_slip$ and $T_stick$, for which the law is the static curve.
    /// `normal_force` = 0 releases the contact (force 0, also of the viscous part and of the memory). `mu_s` = `mu_k`
    /// leaves $f_C tanh(v / v_0)$ and a remainder of 3.6 % of $f_C$ in $f_p$ for the defaults.
    ///
    /// # Source
    /// Reconstructed: F. Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis,
    /// University of Minho (2024), says that the curve of Specker, Buchholz, Dietmayer (2014), IFAC Proceedings Volumes
    /// 47(3), 4523-4528, (6.24) to (6.27), is extended to a linear parameter-varying system in the form of a
    /// first-order low-pass filter; the law of its time constant is ours. $v_0 = 0.25$ mm/s and $v_Sp = 0.5$ mm/s
    /// follow (6.28), $v_S = 4 v_0 = 2 v_Sp$, for $v_S = 1$ mm/s, which is chosen, and so is $T_slip$. $sigma_0$ is
    /// that of the laws in Table 7.1, which does not list this one. $f_p$ is kept from becoming negative, which would
    /// drive the motion.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::SpeckerDynamic;
    /// use stribeck::model::{Law, Model};
    /// let mut law = SpeckerDynamic { velocity: 1e-6, ..Default::default() };
    /// law.step(1e-4); // 0.1 nm: sigma_0 x = 10 uN
    /// law.output();
    /// assert!((law.friction_force / 1e-5 - 1.0).abs() < 1e-3);
    /// law.velocity = 5e-4;
    /// law.step(10.0); // steady sliding at the peak velocity
    /// law.output();
    /// assert!((law.friction_force - 1.4715).abs() < 1e-12);
    /// ```
    SpeckerDynamic: "Smooth friction law with a velocity-dependent lag (Specker, reconstructed)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        transition_velocity: tunable = TRANSITION_VELOCITY.start(0.00025),
        peak_velocity: tunable = PEAK_VELOCITY,
        viscous_coefficient: tunable = VISCOUS_COEFFICIENT,
        sigma_0: tunable = SIGMA_0,
        /// Time constant of the force while sliding (default chosen).
        slip_time: tunable = real("s", 0.001).positive().nominal(1e-3).shown_in("ms").means(Meaning::Own),
        /// Friction force behind the low-pass.
        lagging_force: state = real("N", 0.0).reinit().odd(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> SpeckerDynamic<T> {
    #[inline(always)]
    fn curve(&self) -> SpeckerCurve<T> {
        SpeckerCurve {
            coulomb: self.mu_k * self.normal_force,
            breakaway: self.mu_s * self.normal_force,
            transition_velocity: self.transition_velocity,
            peak_velocity: self.peak_velocity,
            viscous_coefficient: self.viscous_coefficient,
        }
    }

    /// T(v).
    #[inline(always)]
    fn time_constant(&self, curve: &SpeckerCurve<T>) -> T {
        let u = self.velocity / self.peak_velocity;
        let share = (-u * u).exp();
        self.slip_time * (T::from(1.0) - share) + curve.slope_at_rest() / self.sigma_0 * share
    }

    #[inline(always)]
    fn force(&self) -> T {
        choose!(self.normal_force.is_positive(), self.lagging_force, T::zero())
    }
}

impl<T: Real> Law for SpeckerDynamic<T> {
    type Interface = ModelExchange;

    #[inline(always)]
    fn output(&mut self) {
        self.friction_force = self.force();
        self.dissipated_power = self.friction_force * self.velocity;
        let is_slow = self.velocity.abs().below(self.peak_velocity);
        self.sticking = T::truth(is_slow & self.normal_force.is_positive());
    }

    #[inline(always)]
    fn slide_steadily(&mut self) {
        let is_loaded = self.normal_force.is_positive();
        self.lagging_force = choose!(is_loaded, self.curve().force(self.velocity), T::zero());
    }

    #[inline(always)]
    fn overshoot(&self) -> Option<T> {
        Some(self.curve().overshoot())
    }
}

impl<T: Real> Derivatives for SpeckerDynamic<T> {
    #[inline(always)]
    fn derivatives(&self, rate: &mut Self) {
        let curve = self.curve();
        rate.lagging_force = choose!(
            self.normal_force.is_positive(),
            {
                let time_constant = self.time_constant(&curve);
                choose!(
                    time_constant.is_positive(),
                    (curve.force(self.velocity) - self.lagging_force) / time_constant,
                    T::zero()
                )
            },
            T::zero()
        );
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

impl<T: Real> SpeckerDynamic<T> {
    #[inline(always)]
    fn approach(&mut self, dt: T) {
        let curve = self.curve();
        let (steady, time_constant) = (curve.force(self.velocity), self.time_constant(&curve));
        let before = self.lagging_force;
        self.lagging_force = relaxation::after(before, steady, dt / time_constant);
        // The integral of f_f over time: f_f = f_stat - T df_f/dt.
        let work = self.velocity * (steady * dt - time_constant * (self.lagging_force - before));
        self.dissipated_energy = self.dissipated_energy + work;
    }
}

impl<T: Real> Steps for SpeckerDynamic<T> {
    #[inline(always)]
    fn advance(&mut self, dt: T) {
        let is_loaded = self.normal_force.is_positive();
        change!(self, is_loaded, |law| law.approach(dt), |law| law.lagging_force = T::zero());
    }

    #[inline(always)]
    fn relaxation(&self, dt: T) -> Option<Relaxation<T>> {
        let curve = self.curve();
        let decay = dt / self.time_constant(&curve);
        Some(Relaxation::of(curve.force(self.velocity), decay, self.normal_force.is_positive()))
    }
}

in_lanes!(SpeckerDynamic, relaxes lagging_force);

impl Model for SpeckerDynamic {
    const LINEAR: bool = true;
    const STEADY_SLIDING: bool = true;
    const PRESETS: &'static [Preset] = &[Preset {
        name: "guidance",
        source: "Guidance (6.28) of Novais (2024) for v_S = 1 mm/s, which is chosen, as is T_slip (the start values)",
        values: &[],
    }];

    released_without_load!(lagging_force);

    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    fn check_model_exchange(&self) -> Result<(), Fault> {
        if self.mu_s == 0.0 && self.viscous_coefficient == 0.0 {
            let why = "must be > 0 in Model Exchange unless viscous_coefficient is, for a time constant at rest";
            return Err(Fault::new(format_args!("mu_s = {}: {why}", self.mu_s)));
        }
        Ok(())
    }

    in_lanes!();
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn moved(law: SpeckerDynamic, velocity: f64, dt: f64) -> SpeckerDynamic {
        let mut law = SpeckerDynamic { velocity, ..law };
        law.step(dt);
        law.output();
        law
    }

    /// Without dry friction the time constant at rest is that of the viscous part, if there is one.
    #[test]
    fn model_exchange_needs_a_time_constant_at_rest() {
        let law = |viscous_coefficient| {
            SpeckerDynamic { mu_s: 0.0, mu_k: 0.0, viscous_coefficient, ..Default::default() }.check_model_exchange()
        };
        assert!(law(2.0).is_ok());
        assert!(law(0.0).unwrap_err().0.starts_with("mu_s = 0: must be > 0 in Model Exchange unless"));
    }

    /// A step to v << v_Sp: K_0 v (1 - exp(-t / T_stick)) with K_0 = 5657.7588 N.s/m, T_stick = K_0 / sigma_0.
    #[test]
    fn small_motions_meet_a_spring_that_creeps() {
        for time in [1e-4, 1e-2, 0.1, 1.0] {
            let law = moved(SpeckerDynamic::default(), 1e-8, time);
            let expected = 5657.7588e-8 * (1.0 - f64::exp(-time / 0.056577588));
            assert!((law.friction_force / expected - 1.0).abs() < 1e-6, "{time}: {}", law.friction_force);
        }
    }

    /// The energy against a fine sum of the power.
    #[test]
    fn energy_is_the_integral_of_power() {
        let mut law = moved(SpeckerDynamic::default(), 6e-4, 0.02);
        let whole = moved(law, -2e-3, 5e-3).dissipated_energy - law.dissipated_energy;
        let (mut integral, n) = (0.0, 50_000);
        for _ in 0..n {
            law = moved(law, -2e-3, 2.5e-3 / f64::from(n));
            integral += law.dissipated_power * 5e-3 / f64::from(n);
            law = moved(law, -2e-3, 2.5e-3 / f64::from(n));
        }
        assert!((whole / integral - 1.0).abs() < 1e-8, "{whole} {integral}");
    }

    /// A reversal from f_0 to the speed V >> v_Sp returns V T_slip (f_0 - f_C ln(1 + f_0 / f_C)) until f_f is 0.
    #[test]
    fn a_fast_reversal_gives_back_energy() {
        let (f_0, v) = (1.4715, 1.0);
        let held = moved(SpeckerDynamic::default(), 5e-4, 10.0);
        let back = moved(held, -v, 1e-3 * f64::ln(1.0 + f_0 / 0.981));
        assert!(back.friction_force.abs() < 1e-12);
        let expected = v * 1e-3 * (f_0 - 0.981 * f64::ln(1.0 + f_0 / 0.981));
        assert_abs_diff_eq!((held.dissipated_energy - back.dissipated_energy) / expected, 1.0, epsilon = 1e-9);
    }
}
