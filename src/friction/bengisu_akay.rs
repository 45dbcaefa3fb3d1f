use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::laws::regularised;
use crate::model::{Fault, Meaning, Model, Preset};
use crate::number::{Real, choose};

crate::choices! {
    /// Variants of the law.
    pub enum BengisuAkayVariant {
        /// Product of two exponentials, as printed in the thesis.
        Thesis,
        /// Parabola up to the peak, exponential beyond it, as in Marques et al. (2016).
        Marques,
    }
}

crate::model! {
    /// Bengisu-Akay friction: a continuous law with a stiction peak, in the exponential form of the thesis and in the
    /// form of Marques et al. with a parabola up to the peak.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = (1 - exp(-beta |v|)) (f_C + (f_s - f_C) exp(-alpha |v|)) sgn(v)      Thesis     (6.8)
    /// f_f = f_s (1 - (|v| / v_0 - 1)^2) sgn(v)                                   Marques, |v| <  v_0
    /// f_f = (f_C + (f_s - f_C) exp(-alpha (|v| - v_0))) sgn(v)                   Marques, |v| >= v_0
    /// f_C = mu_k f_n,   f_s = mu_s f_n
    /// ```
    ///
    /// With `mass` $m > 0$ the force over a step $h$ is that of the velocity $w$ at its end, and of several solutions
    /// the first one reached from $v$ in the direction of the acceleration (implicit Euler):
    ///
    /// ```text
    /// m (w - v) / h = f_e - f_f(w)
    /// ```
    ///
    /// | symbol | variable              | unit | meaning                                            |
    /// |--------|-----------------------|------|----------------------------------------------------|
    /// | v      | `velocity`            | m/s  | velocity of body 1 relative to body 2              |
    /// | f_n    | `normal_force`        | N    | force pressing the surfaces together               |
    /// | f_e    | `external_force`      | N    | all other tangential forces on body 1              |
    /// | mu_k   | `mu_k`                | 1    | kinetic coefficient of friction                    |
    /// | mu_s   | `mu_s`                | 1    | static coefficient of friction                     |
    /// |        | `variant`             |      | one of the two forms                               |
    /// | beta   | `transition_slope`    | s/m  | Thesis: slope at rest over $f_s$                   |
    /// | alpha  | `stiction_decay`      | s/m  | decay of stiction with speed; xi in Marques et al. |
    /// | v_0    | `transition_velocity` | m/s  | Marques: velocity of the peak                      |
    /// | m      | `mass`                | kg   | effective mass of the host, 0 = the printed law    |
    /// | h      | `step_size`           | s    | last communication step                            |
    /// | f_f    | `friction_force`      | N    | friction force                                     |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity`; body 1 feels `-friction_force`. Dissipated power is
    /// `friction_force * velocity`, never negative: the law is passive.
    ///
    /// # Step
    /// Without `mass` the law has no memory; only the dissipated energy is integrated, exactly for held inputs. A
    /// master that couples it explicitly to a mass $m$ needs a communication step below $2 m / f'(0)$, where
    /// $f'(0) = f_s beta$ for Thesis (7358 N.s/m for the defaults: 0.27 ms for 1 kg) and $2 f_s / v_0$ for Marques
    /// (2943 N.s/m: 0.68 ms); above, a held body chatters. With `mass` the step is not limited. `sticking` means
    /// $|v| < 3 / beta$ (Thesis, chosen: 95 % of the rise) or $|v| < v_0$ (Marques).
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`.
    ///
    /// # Limits
    /// Cannot hold a load: a stuck body creeps at the speed where the force equals the load. Thesis: the peak is always
    /// below $f_s$ ($0.8747 f_s$ at 0.737 mm/s for the defaults) and tends to it for $beta / alpha$ to infinity;
    /// $alpha$ must be well below $beta$. Marques: the peak is exactly $f_s$ at $v_0$, with a kink. `mu_s` = `mu_k` in
    /// the form Thesis is Threlfall friction with $v_0 = 3 / beta$. No pre-sliding displacement. `normal_force` = 0
    /// gives force 0.
    ///
    /// # Source
    /// Bengisu and Akay (1994), Journal of Sound and Vibration 171, 557-570; equations (6.8) and (6.9) of F. Novais, "A
    /// critical analysis on friction force models in dynamical systems", MSc thesis, University of Minho (2024); the
    /// second form as in Marques, Flores, Claro, Lankarani (2016), doi:10.1007/s11071-016-2999-3. Differs from the
    /// thesis: its text calls $f_s / f_C$ the ratio of the asymptotic value to the maximum, which contradicts (6.9).
    /// The values in the thesis are on a page that was not available: $beta$, $alpha$ and $v_0$ are chosen.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::BengisuAkay;
    /// use stribeck::model::Law;
    /// let mut law = BengisuAkay { velocity: 0.000_5, variant: 2.0, ..Default::default() }; // Marques, half way to v_0
    /// law.output();
    /// assert!((law.friction_force - 0.75 * 1.4715).abs() < 1e-15);
    /// ```
    BengisuAkay: "Continuous friction law with a stiction peak (Bengisu and Akay)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        /// Variant of the law.
        variant: fixed = BengisuAkayVariant::Thesis.start().means(Meaning::Variant),
        transition_slope: tunable = TRANSITION_SLOPE.start(5000.0),
        stiction_decay: tunable = STICTION_DECAY.start(500.0),
        transition_velocity: tunable = TRANSITION_VELOCITY,
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> BengisuAkay<T> {
    #[inline(always)]
    fn is_marques(&self) -> T::Mask {
        BengisuAkayVariant::Marques.is(self.variant)
    }

    /// Level at a speed above that of the peak.
    #[inline(always)]
    fn falling_level(&self, speed: T) -> T {
        let coulomb = self.mu_k * self.normal_force;
        coulomb + (self.level() - coulomb) * (-(self.stiction_decay * speed)).exp()
    }
}

impl<T: Real> Curve<T> for BengisuAkay<T> {
    /// Eq. (6.8), or the form of Marques et al.
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        let [speed, peak] = [velocity.abs(), self.transition_velocity];
        choose!(
            self.is_marques(),
            choose!(
                speed.below(peak),
                {
                    // 1 - (u - 1)^2 = u (2 - u)
                    let u = velocity / peak;
                    self.level() * u * (T::from(2.0) - u.abs())
                },
                self.falling_level(speed - peak) * velocity.sign()
            ),
            regularised::rise(velocity, self.transition_slope) * self.falling_level(speed)
        )
    }

    #[inline(always)]
    fn level(&self) -> T {
        self.mu_s * self.normal_force
    }

    #[inline(always)]
    fn band(&self) -> Option<T> {
        Some(choose!(self.is_marques(), self.transition_velocity, T::from(3.0) / self.transition_slope))
    }

    #[inline(always)]
    fn kinks(&self) -> [T; 2] {
        [T::zero(), choose!(self.is_marques(), self.transition_velocity, T::zero())]
    }
}

memoryless!(BengisuAkay);

impl Model for BengisuAkay {
    const PRESETS: &'static [Preset] = &[Preset {
        name: "marques_2016",
        source: "Form of Marques et al. (2016), with a chosen decay: 1/e in 1 mm/s",
        values: &[("variant", 2.0), ("stiction_decay", 1000.0)],
    }];

    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    memoryless!();
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn force(law: BengisuAkay) -> f64 {
        law.curve(law.velocity)
    }

    /// Peak of the printed form, found by search: 1.28717768 N at 0.737358 mm/s, and 0.978250 f_s for 10000 and 100.
    #[test]
    fn peak_of_the_printed_form_is_below_the_static_level() {
        let peak = |law: BengisuAkay| {
            let forces = (1..20_000).map(|k| force(BengisuAkay { velocity: 1e-7 * f64::from(k), ..law }));
            forces.fold(0.0, f64::max)
        };
        let law = BengisuAkay::default();
        assert_abs_diff_eq!(peak(law), 1.287_177_68, epsilon = 1e-8);
        assert_abs_diff_eq!(force(BengisuAkay { velocity: 7.373_58e-4, ..law }), 1.287_177_68, epsilon = 1e-8);
        let sharp = BengisuAkay { transition_slope: 1e4, stiction_decay: 100.0, ..law };
        assert_abs_diff_eq!(peak(sharp) / 1.4715, 0.978_250, epsilon = 1e-6);
    }

    #[test]
    fn marques_peaks_at_the_static_level_without_a_jump() {
        let law = BengisuAkay { variant: 2.0, velocity: 0.001, ..Default::default() };
        assert_abs_diff_eq!(force(law), 1.4715, epsilon = 1e-15);
        assert_abs_diff_eq!(force(BengisuAkay { velocity: 0.001f64.next_down(), ..law }), 1.4715, epsilon = 1e-15);
        assert_abs_diff_eq!(force(BengisuAkay { velocity: -1.0, ..law }), -0.981, epsilon = 1e-15);
    }
}
