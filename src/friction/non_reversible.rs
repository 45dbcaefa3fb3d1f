use crate::contact::branching::{AccelerationSource, Branching};
use crate::contact::motion::Motion;
use crate::contact::quantities::*;
use crate::contact::time_stepping::{Branches, Curve, EVENTS_ON_BRANCHES, OnCurve, Phase, PhaseColumn};
use crate::laws::branches;
use crate::model::{Derivatives, Fault, Law, Meaning, Model, ModelExchange, Preset, ramp, real};
use crate::number::{Mask, Real, choose};
use crate::numerics::quadrature::integral_past_peak;

crate::model! {
    /// Non-reversible friction, reconstructed: one curve while the contact speeds up, another while it slows down, so
    /// that friction differs at the same velocity.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f  = f_fu sgn(v)                          v v' >= 0
    /// f_f  = f_fl sgn(v)                          v v' <  0
    /// f_fu = f_C + (f_s - f_C) exp(-a |v|)        upper curve
    /// f_fl = f_C - (f_C - f_l0) exp(-b |v|)       lower curve
    /// f_C = mu_k f_n,   f_s = mu_s f_n,   f_l0 = mu_stop f_n
    /// ```
    ///
    /// Whether a free body speeds up depends on this force itself. With `acceleration_source` = Balance the
    /// external force $f_e$ decides; between the curves the body keeps its velocity ($v > 0$; mirrored for
    /// $v < 0$):
    ///
    /// ```text
    /// f_f = f_fu                                  f_e > f_fu
    /// f_f = f_e                                   f_fl <= f_e <= f_fu, and at rest |f_e| <= f_s
    /// f_f = f_fl                                  f_e < f_fl
    /// ```
    ///
    /// | symbol  | variable             | unit | meaning                                         |
    /// |---------|----------------------|------|-------------------------------------------------|
    /// | v       | `velocity`           | m/s  | velocity of body 1 relative to body 2           |
    /// | f_n     | `normal_force`       | N    | force pressing the surfaces together            |
    /// | f_e     | `external_force`     | N    | resultant of all other tangential forces        |
    /// | v'      | `acceleration`       | m/s2 | acceleration of body 1 relative to body 2       |
    /// |         | `velocity_slope`     | m/s2 | $v'$ as it was given by a slope of the velocity |
    /// | mu_k    | `mu_k`               | 1    | kinetic coefficient of friction                 |
    /// | mu_s    | `mu_s`               | 1    | static coefficient of friction                  |
    /// | mu_stop | `mu_stop`            | 1    | coefficient of friction reached when stopping   |
    /// | a       | `acceleration_decay` | s/m  | steepness of the upper curve                    |
    /// | b       | `deceleration_decay` | s/m  | steepness of the lower curve                    |
    /// | f_f     | `friction_force`     | N    | friction force                                  |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity`; body 1 feels `-friction_force`. Dissipated power is
    /// `friction_force * velocity`, never negative: the law is passive.
    ///
    /// # Step
    /// The sign of the acceleration is that of the slope of `velocity` where the master gives one
    /// (fmi2SetRealInputDerivatives), otherwise that of the input `acceleration` at the beginning of the step; without
    /// either it is 0 and the upper curve counts. After a step with a slope the outputs use that slope until the next
    /// step. The law has no other memory. The dissipated energy is exact for held inputs; for inputs that move linearly
    /// it is a quadrature with a relative error below 1e-10, divided where the velocity passes through zero. `sticking`
    /// says that the velocity is exactly zero.
    ///
    /// A host that integrates the body itself never reaches $v = 0$ exactly, so at rest the force alternates at any
    /// communication step $h$, and its velocity alternates by up to $f_s h / m$. If the acceleration is computed from
    /// the last force, the two curves alternate wherever neither agrees with the sign of the acceleration that it
    /// causes; at any step size the body then feels their mean, and begins to slide at $(f_s + f_l0) / 2$. A balance of
    /// forces has no such loop; but a held force lags behind an external force that changes at the rate $r$, and a body
    /// that should rest for the time $t$ reaches the velocity $r h t / (2 m)$. In Model Exchange a free body needs
    /// Balance, with `external_force` connected, and is held up to $f_s$; a motion that is prescribed needs Input and
    /// its acceleration.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`; `mu_stop` > `mu_s`; in a balance of forces curves that
    /// cross, that is, `mu_stop` > `mu_k` with `deceleration_decay` < `acceleration_decay`.
    ///
    /// # Limits
    /// With Input no stiction: the force is zero at $v = 0$, so the law cannot hold a load. The force jumps by
    /// $f_fu - f_fl$ where the acceleration changes its sign.
    ///
    /// `mu_stop` = `mu_s` with $a = b$ is the reversible curve of Tustin with $v_S = 1 / a$; `mu_stop` = `mu_k` leaves
    /// the Coulomb level while slowing down; `mu_stop` = 2 `mu_k` - `mu_s` mirrors the upper curve. `normal_force` = 0
    /// gives force 0.
    ///
    /// # Source
    /// Reconstructed: the pages of F. Novais, "A critical analysis on friction force models in dynamical systems", MSc
    /// thesis, University of Minho (2024), on non-reversibility were not available; its list of symbols names $f_fu$,
    /// $f_fl$, a and $b$. The curves are of the family of Powell and Wiercigroch (1992), Machine Vibration 1, and
    /// Wiercigroch, Sin and Liew (1999), Proc. IMechE C 213, 527-534. In the literature $f_l0$ is 0 or $2 f_C - f_s$;
    /// which one the thesis prints is unknown, so it is a parameter, here as a coefficient, so that it follows the
    /// load. The defaults of $f_l0 = 0$ and $a = b = 500$ s/m are chosen.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::NonReversible;
    /// use stribeck::model::Law;
    /// let mut law = NonReversible { velocity: 0.002, ..Default::default() }; // a v = 1
    /// law.output();
    /// assert!((law.friction_force - (0.981 + 0.4905 * (-1.0f64).exp())).abs() < 1e-15);
    /// law.branching.acceleration = -3.0;
    /// law.output();
    /// assert!((law.friction_force - 0.981 * (1.0 - (-1.0f64).exp())).abs() < 1e-15);
    /// ```
    NonReversible: "Different friction while speeding up and slowing down (reconstructed)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        /// How the acceleration is known.
        branching: (Branching),
        /// How the law knows whether the contact speeds up or slows down.
        acceleration_source: fixed = AccelerationSource::Input.start(),
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        /// Coefficient of friction that a contact reaches when it comes to rest; not more than mu_s (default chosen).
        mu_stop: tunable = real("1", 0.0).at_least(0.0).means(Meaning::Level),
        /// Steepness of the curve while speeding up (default chosen).
        acceleration_decay: tunable = real("s/m", 500.0).positive().nominal(500.0).means(Meaning::Own),
        /// Steepness of the curve while slowing down (default chosen).
        deceleration_decay: tunable = real("s/m", 500.0).positive().nominal(500.0).means(Meaning::Own),
        /// Motion of the contact as found by the last event of Model Exchange.
        phase: state = Phase::Free.start(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> NonReversible<T> {
    /// f_fl.
    fn lower(&self, velocity: T, load: T) -> T {
        branches::level(velocity, self.mu_k * load, self.mu_stop * load, self.deceleration_decay)
    }

    /// f_fu.
    fn upper(&self, velocity: T, load: T) -> T {
        branches::level(velocity, self.mu_k * load, self.mu_s * load, self.acceleration_decay)
    }

    /// f_fu or f_fl.
    fn level(&self, velocity: T, load: T, acceleration: T) -> T {
        let slows_down = branches::slows_down(velocity, acceleration);
        slows_down.choose(|| self.lower(velocity, load), || self.upper(velocity, load))
    }
}

impl<T: Real> Curve<T> for NonReversible<T> {
    fn curve(&self, velocity: T) -> T {
        self.level(velocity, self.normal_force, self.branching.known_acceleration()) * velocity.sign()
    }

    fn level(&self) -> T {
        self.mu_s * self.normal_force
    }

    fn band(&self) -> Option<T> {
        None
    }
}

impl<T: Real> Branches<T> for NonReversible<T> {
    fn levels(&self, velocity: T) -> [T; 2] {
        [self.lower(velocity, self.normal_force), self.upper(velocity, self.normal_force)]
    }

    fn is_by_balance(&self) -> T::Mask {
        AccelerationSource::Balance.is(self.acceleration_source)
    }
}

impl<T: Real> NonReversible<T> {
    fn contact(&self) -> OnCurve<'_, T, Self> {
        let NonReversible { velocity, normal_force, external_force, phase, .. } = *self;
        // Only a balance has external forces.
        let external_force = choose!(self.is_by_balance(), external_force, T::zero());
        OnCurve { law: self, velocity, normal_force, external_force, phase: PhaseColumn(phase) }
    }
}

impl<T: Real> Law for NonReversible<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.friction_force = self.contact().on_branches();
        self.dissipated_power = self.friction_force * self.velocity;
        self.sticking = T::truth(self.contact().is_held() & self.normal_force.is_positive());
    }

    fn slide_steadily(&mut self) {
        self.phase = T::from(Phase::Free.number());
        self.branching.velocity_slope = T::zero();
    }
}

impl<T: Real> Derivatives for NonReversible<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.dissipated_energy = self.contact().on_branches() * self.velocity;
    }
}

impl NonReversible {
    fn advance(&mut self, motion: Motion) {
        self.branching.begin(&motion);
        self.dissipated_energy += motion.parts().map(|part| self.work(&part)).sum::<f64>();
    }

    /// Energy dissipated over a motion in one direction.
    fn work(&self, part: &Motion) -> f64 {
        let acceleration = self.branching.known_acceleration();
        let power = |t: f64| {
            let velocity = part.velocity_at(t);
            self.level(velocity, part.load_at(t), acceleration) * velocity.abs()
        };
        if part.is_steady() {
            return power(0.0) * part.duration;
        }
        let band = branches::FADED / self.acceleration_decay.min(self.deceleration_decay);
        integral_past_peak(&power, &|t| part.velocity_at(t), band, 0.0, part.duration)
    }
}

impl Model for NonReversible {
    const STEADY_SLIDING: bool = true;
    const PRESETS: &'static [Preset] = &[
        Preset {
            name: "mirrored",
            source: "Example: the variant in the literature whose lower curve is the mirror image, f_l0 = 2 f_C - f_s",
            values: &[("mu_stop", 0.05)],
        },
        Preset {
            name: "reversible",
            source: "Example: both curves equal, that is, the curve of Tustin with a Stribeck velocity of 2 mm/s",
            values: &[("mu_stop", 0.15)],
        },
    ];

    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)?;
        if self.mu_stop > self.mu_s {
            return Err(Fault::new(format_args!("mu_stop = {}: must be <= mu_s = {}", self.mu_stop, self.mu_s)));
        }
        let crosses = self.mu_stop > self.mu_k && self.acceleration_decay > self.deceleration_decay;
        if crosses && self.is_by_balance() {
            return Err(Fault::new(format_args!(
                "mu_stop = {}: must be <= mu_k = {} in a balance of forces, or deceleration_decay = {} must be >= \
                 acceleration_decay = {}: the curves would cross",
                self.mu_stop, self.mu_k, self.deceleration_decay, self.acceleration_decay
            )));
        }
        Ok(())
    }

    const EVENT_INDICATORS: usize = EVENTS_ON_BRANCHES;

    fn check_without_events(&self) -> Result<(), Fault> {
        Err(crate::model::rests_at_events())
    }

    fn event_indicators(&self, indicators: &mut [f64]) {
        self.contact().write_indicators_on_branches(self.branching.known_acceleration(), indicators);
    }

    fn at_event(&mut self) {
        self.branching.velocity_slope = 0.0;
        self.phase = self.contact().settled().number();
    }

    fn step(&mut self, dt: f64) {
        self.phase = Phase::Free.number();
        if self.is_by_balance() {
            self.branching.velocity_slope = 0.0;
            self.dissipated_energy += self.contact().on_branches() * self.velocity * dt;
            return;
        }
        self.advance(Motion::held(self.velocity, self.normal_force, dt));
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        self.phase = Phase::Free.number();
        if self.is_by_balance() {
            self.branching.velocity_slope = 0.0;
            return ramp::advance(self, slope, dt);
        }
        let begin = ramp::Inputs::of(self);
        self.advance(Motion {
            acceleration: slope.velocity,
            load_rate: slope.normal_force,
            ..Motion::held(self.velocity, self.normal_force, dt)
        });
        ramp::set_inputs(self, &begin, slope, dt);
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn force(velocity: f64, acceleration: f64, parameters: NonReversible) -> f64 {
        let mut law = NonReversible { velocity, ..parameters };
        law.branching.acceleration = acceleration;
        law.output();
        law.friction_force
    }

    #[test]
    fn both_curves_end_at_the_coulomb_level() {
        let law = NonReversible { mu_stop: 0.02, acceleration_decay: 700.0, ..Default::default() };
        for sign in [1.0, -1.0] {
            for acceleration in [2.0, -2.0] {
                assert_abs_diff_eq!(sign * force(sign * 0.2, acceleration, law), 0.981, epsilon = 1e-12);
            }
            let start = sign * force(sign * 1e-12, sign, law);
            let stop = sign * force(sign * 1e-12, -sign, law);
            assert!((start - 1.4715).abs() < 1e-8 && (stop - 0.1962).abs() < 1e-8, "{start} {stop}");
        }
    }

    /// a = b and f_l0 = f_s: Tustin's curve whatever the acceleration.
    #[test]
    fn equal_curves_are_tustin() {
        let law = NonReversible {
            mu_stop: 0.15,
            acceleration_decay: 1000.0,
            deceleration_decay: 1000.0,
            ..Default::default()
        };
        for (velocity, expected) in [(2e-4, 1.38258743), (1e-3, 1.16144487), (1e-2, 0.981022269)] {
            for acceleration in [-1.0, 0.0, 1.0] {
                assert_abs_diff_eq!(force(velocity, acceleration, law) / expected, 1.0, epsilon = 5e-9);
                assert_abs_diff_eq!(force(-velocity, acceleration, law) / expected, -1.0, epsilon = 5e-9);
            }
        }
    }

    /// Speeding up from rest to V and slowing down to rest: the areas under the curves over the distance, by hand with
    /// n = a V: E = m { f_C V^2 / 2 + (f_0 - f_C) [1 - (1 + n) exp(-n)] / a^2 } / |v'|.
    #[test]
    fn energy_of_a_stroke_has_its_closed_form() {
        let (v, a, rate) = (0.01f64, 500.0f64, 2.0);
        let shape = (1.0 - (1.0 + a * v) * (-a * v).exp()) / (a * a);
        let energy = |f_0: f64| (0.981 * v * v / 2.0 + (f_0 - 0.981) * shape) / rate;
        let mut law = NonReversible::default();
        let up = NonReversible { velocity: rate, normal_force: 0.0, ..law };
        law.step_ramp(&up, v / rate);
        assert_abs_diff_eq!(law.dissipated_energy / energy(1.4715), 1.0, epsilon = 1e-12);
        let down = NonReversible { velocity: -rate, ..up };
        law.step_ramp(&down, v / rate);
        assert_abs_diff_eq!(law.dissipated_energy / (energy(1.4715) + energy(0.0)), 1.0, epsilon = 1e-12);
        // Through zero in one step: slowing down, then speeding up the other way.
        let mut law = NonReversible { velocity: v, ..Default::default() };
        law.step_ramp(&down, 2.0 * v / rate);
        assert_abs_diff_eq!(law.dissipated_energy / (energy(0.0) + energy(1.4715)), 1.0, epsilon = 1e-12);
        law.output();
        assert!((law.friction_force + 0.981 + 0.4905 * (-5.0f64).exp()).abs() < 1e-12);
    }

    #[test]
    fn the_slope_counts_more_than_the_input_and_only_until_the_next_held_step() {
        let mut law = NonReversible { velocity: 1e-3, ..Default::default() };
        law.branching.acceleration = 1.0;
        let mut slope = NonReversible { velocity: -0.1, normal_force: 0.0, ..law };
        slope.branching.acceleration = 0.0;
        law.step_ramp(&slope, 1e-3);
        law.output();
        assert!(law.friction_force < 0.981, "slows down");
        law.step(1e-3);
        law.output();
        assert!(law.friction_force > 0.981, "speeds up");
    }

    #[test]
    fn a_stop_above_the_static_level_is_refused_by_name() {
        let law = NonReversible { mu_stop: 0.2, ..Default::default() };
        assert_eq!(law.check().unwrap_err().0, "mu_stop = 0.2: must be <= mu_s = 0.15");
    }

    #[test]
    fn rest_and_no_load_have_no_force() {
        assert_eq!(force(0.0, -1.0, NonReversible::default()), 0.0);
        assert_eq!(force(0.1, -1.0, NonReversible { normal_force: 0.0, ..Default::default() }), 0.0);
    }

    fn balance(velocity: f64, external_force: f64) -> NonReversible {
        let acceleration_source = AccelerationSource::Balance.number();
        NonReversible { velocity, external_force, acceleration_source, ..Default::default() }
    }

    /// a v = 1: f_fl = 0.6201 N, f_fu = 1.1614 N.
    #[test]
    fn between_the_curves_the_external_force_is_carried() {
        let (lower, upper) = (0.981 * (1.0 - (-1.0f64).exp()), 0.981 + 0.4905 * (-1.0f64).exp());
        let at_rest = [(1.4, 1.4), (-1.4, -1.4), (2.0, 1.4715), (-2.0, -1.4715)];
        let sliding = [(2.0, upper), (1.0, 1.0), (lower + 1e-3, lower + 1e-3), (0.3, lower), (-5.0, lower)];
        for (velocity, cases) in [(0.0, &at_rest[..]), (0.002, &sliding)] {
            for (load, expected) in cases {
                for sign in [1.0, -1.0] {
                    let mut law = balance(sign * velocity, sign * load);
                    law.output();
                    assert_abs_diff_eq!(sign * law.friction_force, expected, epsilon = 1e-15);
                }
            }
        }
    }

    #[test]
    fn curves_that_cross_are_refused_in_a_balance() {
        let crossing = NonReversible { mu_stop: 0.12, deceleration_decay: 100.0, ..balance(0.0, 0.0) };
        assert!(crossing.check().unwrap_err().0.contains("deceleration_decay = 100"));
        assert!(NonReversible { acceleration_source: 1.0, ..crossing }.check().is_ok());
        assert!(NonReversible { mu_stop: 0.1, ..crossing }.check().is_ok());
    }
}
