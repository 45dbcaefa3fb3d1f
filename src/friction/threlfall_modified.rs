use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::laws::regularised;
use crate::model::{Model, Preset};
use crate::number::elementary::exp_m1;
use crate::number::{Real, choose};

crate::model! {
    /// Modified Threlfall friction: the exponential transition of Threlfall, scaled so that it reaches the Coulomb
    /// level at the transition velocity and continues without a jump.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = f_C (1 - exp(-3 |v| / v_0)) / (1 - exp(-3)) sgn(v)      |v| <= v_0     (6.4)
    /// f_f = f_C sgn(v)                                              |v| >  v_0
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
    /// | v_0    | `transition_velocity` | m/s  | velocity at which $f_C$ is reached              |
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
    /// $f'(0) = 3.157 f_C / v_0$ (3097 N.s/m for the defaults: 0.65 ms for 1 kg); above, a held body chatters. With
    /// `mass` the step is not limited. `sticking` means $|v| < v_0$.
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// No stiction: friction never exceeds $f_C$. Cannot hold a load: a stuck body creeps with $|v| < v_0$. The slope
    /// jumps at $v_0$ from $0.157 f_C / v_0$ to 0. `normal_force` = 0 gives force 0.
    ///
    /// # Source
    /// Marques, Flores, Claro, Lankarani (2016), doi:10.1007/s11071-016-2999-3, after Threlfall (1978), Mechanism and
    /// Machine Theory 13, 475-483; equation (6.4) of F. Novais, "A critical analysis on friction force models in
    /// dynamical systems", MSc thesis, University of Minho (2024), default of Table 6.2. Differs from the thesis: (6.4)
    /// has no condition; unbounded, the formula would reach $1.0524 f_C$. The legible part of its denominator fits 1 -
    /// exp(-1), with which the force at $v_0$ would be $1.503 f_C$: a misprint for 1 - exp(-3), which gives $f_C$
    /// there.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::ThrelfallModified;
    /// use stribeck::model::Law;
    /// let mut law = ThrelfallModified { velocity: 0.001, ..Default::default() };
    /// law.output();
    /// assert!((law.friction_force - 0.981).abs() < 1e-15);
    /// ```
    ThrelfallModified: "Coulomb friction with an exponential transition up to the Coulomb level (modified Threlfall)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        transition_velocity: tunable = TRANSITION_VELOCITY,
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Curve<T> for ThrelfallModified<T> {
    /// Eq. (6.4).
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        let end = T::from(-exp_m1(-3.0));
        choose!(
            velocity.abs().above(self.transition_velocity),
            self.level() * velocity.sign(),
            self.level() * regularised::exponential(velocity, self.transition_velocity) / end
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

memoryless!(ThrelfallModified);

impl Model for ThrelfallModified {
    const PRESETS: &'static [Preset] =
        &[Preset { name: "thesis", source: "Novais (2024), Tables 6.1 and 6.2 (the start values)", values: &[] }];

    memoryless!();
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn force(law: ThrelfallModified) -> f64 {
        law.curve(law.velocity)
    }

    #[test]
    fn reaches_the_coulomb_level_at_v_0_without_a_jump() {
        for velocity in [0.001, 0.001f64.next_up(), 0.3] {
            let law = ThrelfallModified { velocity, ..Default::default() };
            assert_abs_diff_eq!(force(law), 0.981, epsilon = 1e-15);
            assert_abs_diff_eq!(force(ThrelfallModified { velocity: -velocity, ..law }), -0.981, epsilon = 1e-15);
        }
    }

    /// Half way the exponential has covered 1 / (1 + exp(-3/2)) of its range: (1 - q) / (1 - q^2) with q = exp(-3/2).
    #[test]
    fn half_way() {
        let law = ThrelfallModified { velocity: 5e-4, ..Default::default() };
        assert_abs_diff_eq!(force(law), 0.981 / (1.0 + (-1.5f64).exp()), epsilon = 1e-15);
    }
}
