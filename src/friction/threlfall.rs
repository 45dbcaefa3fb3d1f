use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::laws::regularised;
use crate::model::{Meaning, Model, Preset};
use crate::number::{Real, choose};

crate::choices! {
    /// Variants of the law.
    pub enum ThrelfallVariant {
        /// The exponential for all velocities, as printed in the thesis.
        Printed,
        /// The original, which stops at 95 % of the Coulomb level.
        Capped,
    }
}

crate::model! {
    /// Threlfall friction: Coulomb friction with an exponential transition, smooth except at rest.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = f_C (1 - exp(-3 |v| / v_0)) sgn(v)      Printed, and Capped for |v| <= v_0     (6.2)
    /// f_f = 0.95 f_C sgn(v)                         Capped for |v| > v_0
    /// f_C = mu_k f_n
    /// ```
    ///
    /// With `mass` $m > 0$ the force over a step $h$ is that of the velocity $w$ at its end, and of several solutions
    /// the first one reached from $v$ in the direction of the acceleration (implicit Euler):
    ///
    /// ```text
    /// m (w - v) / h = f_e - f_f(w)
    /// ```
    ///
    /// | symbol | variable              | unit | meaning                                         |
    /// |--------|-----------------------|------|-------------------------------------------------|
    /// | v      | `velocity`            | m/s  | velocity of body 1 relative to body 2           |
    /// | f_n    | `normal_force`        | N    | force pressing the surfaces together            |
    /// | f_e    | `external_force`      | N    | all other tangential forces on body 1           |
    /// | mu_k   | `mu_k`                | 1    | kinetic coefficient of friction                 |
    /// |        | `variant`             |      | which of the two forms                          |
    /// | v_0    | `transition_velocity` | m/s  | velocity at which 95 % of $f_C$ are reached     |
    /// | m      | `mass`                | kg   | effective mass of the host, 0 = the printed law |
    /// | h      | `step_size`           | s    | last communication step                         |
    /// | f_f    | `friction_force`      | N    | friction force                                  |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity`; body 1 feels `-friction_force`. Dissipated power is
    /// `friction_force * velocity`, never negative: the law is passive.
    ///
    /// # Step
    /// Without `mass` the law has no memory; only the dissipated energy is integrated, exactly for held inputs. A
    /// master that couples it explicitly to a mass $m$ needs a communication step below $2 m / f'(0)$, where
    /// $f'(0) = 3 f_C / v_0$ (2943 N.s/m for the defaults: 0.68 ms for 1 kg); above, a held body chatters. With `mass`
    /// the step is not limited. `sticking` means $|v| < v_0$.
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// No stiction: friction never exceeds $f_C$ (Printed) or $0.9502 f_C$ (Capped). Cannot hold a load: a stuck body
    /// creeps with $|v| < v_0$ as long as the load is below $0.95 f_C$. Capped drops by $2.13e-4 f_C$ at $v_0$, because
    /// 1 - exp(-3) is 0.9502, not 0.95. `normal_force` = 0 gives force 0.
    ///
    /// # Source
    /// Threlfall (1978), Mechanism and Machine Theory 13, 475-483; equation (6.2) of F. Novais, "A critical analysis on
    /// friction force models in dynamical systems", MSc thesis, University of Minho (2024), default of Table 6.2. The
    /// thesis prints one formula for all $v$ (Printed); the original stops at $0.95 f_C$ (Capped): two different laws.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Threlfall;
    /// use stribeck::model::Law;
    /// let mut law = Threlfall { velocity: -0.001, ..Default::default() };
    /// law.output();
    /// assert!((law.friction_force + 0.981 * 0.950_212_932).abs() < 1e-9); // 1 - exp(-3)
    /// ```
    Threlfall: "Coulomb friction with an exponential transition (Threlfall)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        /// Variant of the law.
        variant: fixed = ThrelfallVariant::Printed.start().means(Meaning::Variant),
        transition_velocity: tunable = TRANSITION_VELOCITY,
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Curve<T> for Threlfall<T> {
    /// Eq. (6.2).
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        let is_fast = velocity.abs().above(self.transition_velocity);
        let is_capped = ThrelfallVariant::Capped.is(self.variant) & is_fast;
        self.level()
            * choose!(
                is_capped,
                T::from(0.95) * velocity.sign(),
                regularised::exponential(velocity, self.transition_velocity)
            )
    }

    #[inline(always)]
    fn level(&self) -> T {
        self.mu_k * self.normal_force
    }

    #[inline(always)]
    fn band(&self) -> Option<T> {
        Some(self.transition_velocity)
    }

    #[inline(always)]
    fn kinks(&self) -> [T; 2] {
        [T::zero(), self.transition_velocity]
    }
}

memoryless!(Threlfall);

impl Model for Threlfall {
    const PRESETS: &'static [Preset] =
        &[Preset { name: "thesis", source: "Novais (2024), Tables 6.1 and 6.2 (the start values)", values: &[] }];

    memoryless!();
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn force(law: Threlfall) -> f64 {
        law.curve(law.velocity)
    }

    const CAPPED: f64 = 2.0;

    /// The cap takes away (1 - exp(-3) - 0.95) f_C = 2.13e-4 f_C at v_0.
    #[test]
    fn the_cap_drops_the_force_at_v_0() {
        let at = |velocity| force(Threlfall { velocity, variant: CAPPED, ..Default::default() }) / 0.981;
        assert_abs_diff_eq!(at(0.001), 0.950_212_932, epsilon = 1e-9);
        assert_abs_diff_eq!(at(0.001_000_000_1), 0.95, epsilon = 1e-15);
        assert_abs_diff_eq!(at(-5.0), -0.95, epsilon = 1e-15);
    }

    #[test]
    fn printed_form_tends_to_the_coulomb_level() {
        assert_abs_diff_eq!(force(Threlfall { velocity: -0.1, ..Default::default() }), -0.981, epsilon = 1e-15);
        assert_eq!(force(Threlfall::default()), 0.0);
    }
}
