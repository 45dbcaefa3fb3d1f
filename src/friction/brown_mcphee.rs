use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::model::{Fault, Meaning, Model, real};
use crate::number::{Real, choose};

crate::model! {
    /// Brown-McPhee friction: a smooth law with a stiction peak near the transition velocity, without memory and
    /// without exponentials of large arguments, made for fast multibody simulation.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = f_C tanh(4 v / v_0)                                           (6.30)
    ///     + (f_s - f_C) (v / v_0) / ((v / v_0)^2 / 4 + 3 / 4)^2
    ///     + mu_v v tanh(4 f_n / f_nt)
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
    /// | symbol | variable                  | unit  | meaning                                                |
    /// |--------|---------------------------|-------|--------------------------------------------------------|
    /// | v      | `velocity`                | m/s   | velocity of body 1 relative to body 2                  |
    /// | f_n    | `normal_force`            | N     | force pressing the surfaces together                   |
    /// | f_e    | `external_force`          | N     | all other tangential forces on body 1                  |
    /// | mu_k   | `mu_k`                    | 1     | kinetic coefficient of friction                        |
    /// | mu_s   | `mu_s`                    | 1     | static coefficient of friction                         |
    /// | v_0    | `transition_velocity`     | m/s   | velocity of the stiction peak                          |
    /// | mu_v   | `viscous_coefficient`     | N.s/m | viscous coefficient                                    |
    /// | f_nt   | `transition_normal_force` | N     | normal force at which the viscous part is fully active |
    /// | m      | `mass`                    | kg    | effective mass of the host, 0 = the printed law        |
    /// | h      | `step_size`               | s     | last communication step                                |
    /// | f_f    | `friction_force`          | N     | friction force                                         |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity`; body 1 feels `-friction_force`. Dissipated power is
    /// `friction_force * velocity`, never negative: the law is passive.
    ///
    /// # Step
    /// Without `mass` the law has no memory; only the dissipated energy is integrated, exactly for held inputs. A
    /// master that couples it explicitly to a mass $m$ needs a communication step below $2 m / f'(0)$, where
    /// $f'(0) = (4 f_C + 16/9 (f_s - f_C)) / v_0$ (4796 N.s/m for the defaults: 0.42 ms for 1 kg); above, a held body
    /// chatters. With `mass` the step is not limited. `sticking` means $|v| < v_0$.
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`.
    ///
    /// # Limits
    /// Cannot hold a load: a stuck body creeps with $|v| < v_0$. The peak is not exactly $f_s$: $f(v_0)$ is
    /// $f_s - 6.707e-4 f_C$, because $tanh 4 = 0.99933$; the largest force is within $6.7e-4 f_C$ below $f_s$. No
    /// pre-sliding displacement. `normal_force` = 0 gives force 0.
    ///
    /// # Source
    /// Brown and McPhee (2016), doi:10.1115/1.4033658; equations (6.30) and (6.31) of F. Novais, "A critical analysis
    /// on friction force models in dynamical systems", MSc thesis, University of Minho (2024). $mu_v$ must be in N.s/m
    /// for the printed equation to have consistent units. The defaults of $v_0$ and $f_nt$ are chosen.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::BrownMcPhee;
    /// use stribeck::model::Law;
    /// let mut law = BrownMcPhee { velocity: 0.001, ..Default::default() };
    /// law.output();
    /// let peak = 0.981 * 4f64.tanh() + 0.4905; // at v_0 the rational term is exactly 1
    /// assert!((law.friction_force - peak).abs() < 1e-15);
    /// ```
    BrownMcPhee: "Smooth friction law with a stiction peak (Brown and McPhee)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        transition_velocity: tunable = TRANSITION_VELOCITY,
        viscous_coefficient: tunable = VISCOUS_COEFFICIENT,
        /// Normal force at which the viscous part is fully active (default chosen).
        transition_normal_force: tunable = real("N", 1.0).positive().means(Meaning::Own),
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Curve<T> for BrownMcPhee<T> {
    /// Eq. (6.30).
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        let [quarter, three_quarters, four] = [0.25, 0.75, 4.0].map(T::from);
        let coulomb = self.mu_k * self.normal_force;
        let breakaway = self.mu_s * self.normal_force;
        let u = velocity / self.transition_velocity;
        let base = quarter * u * u + three_quarters;
        let sliding = coulomb * (four * u).tanh() + (breakaway - coulomb) * u / (base * base);
        // Usually absent, and a hyperbolic tangent costs more than everything else.
        choose!(self.viscous_coefficient.is(0.0), sliding, {
            let active = (four * self.normal_force / self.transition_normal_force).tanh();
            sliding + self.viscous_coefficient * velocity * active
        })
    }

    #[inline(always)]
    fn level(&self) -> T {
        self.mu_s * self.normal_force
    }

    #[inline(always)]
    fn band(&self) -> Option<T> {
        Some(self.transition_velocity)
    }
}

memoryless!(BrownMcPhee);

impl Model for BrownMcPhee {
    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    memoryless!();
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn force(law: BrownMcPhee) -> f64 {
        law.curve(law.velocity)
    }

    /// With f_s = f_C the law reduces to a hyperbolic tangent.
    #[test]
    fn equal_levels_leave_the_regularised_coulomb_law() {
        for velocity in [-2e-3, -1e-4, 3e-5, 0.4] {
            let law = BrownMcPhee { velocity, mu_s: 0.1, ..Default::default() };
            assert_abs_diff_eq!(force(law), 0.981 * (4.0 * velocity / 0.001).tanh(), epsilon = 1e-15);
        }
    }

    /// Far above v_0 the excess over the Coulomb level falls as 16 (f_s - f_C) (v_0 / v)^3.
    #[test]
    fn tail_is_algebraic() {
        let law = BrownMcPhee { velocity: 1.0, ..Default::default() };
        let excess = (force(law) - 0.981) / (16.0 * 0.4905 * 1e-9);
        assert!((excess - 1.0).abs() < 1e-4, "{excess}");
    }

    #[test]
    fn viscous_part_needs_a_normal_force() {
        let law = BrownMcPhee { velocity: 1.0, normal_force: 0.0, viscous_coefficient: 5.0, ..Default::default() };
        assert_eq!(force(law), 0.0);
        let loaded = BrownMcPhee { normal_force: 100.0, ..law };
        assert_abs_diff_eq!(force(loaded) - 10.0, 5.0, epsilon = 1e-6);
    }
}
