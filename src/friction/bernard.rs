use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::model::{Model, Preset};
use crate::number::Real;

crate::model! {
    /// Bernard friction: Coulomb friction with a steep straight line through rest, so that a solver sees no jump.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = f_C max(min(k_l v, 1), -1)     (6.1)
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
    /// | symbol | variable           | unit | meaning                                              |
    /// |--------|--------------------|------|------------------------------------------------------|
    /// | v      | `velocity`         | m/s  | velocity of body 1 relative to body 2                |
    /// | f_n    | `normal_force`     | N    | force pressing the surfaces together                 |
    /// | f_e    | `external_force`   | N    | all other tangential forces on body 1                |
    /// | mu_k   | `mu_k`             | 1    | kinetic coefficient of friction                      |
    /// | k_l    | `transition_slope` | s/m  | slope at rest over $f_C$; the band ends at $1 / k_l$ |
    /// | m      | `mass`             | kg   | effective mass of the host, 0 = the printed law      |
    /// | h      | `step_size`        | s    | last communication step                              |
    /// | f_f    | `friction_force`   | N    | friction force                                       |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity`; body 1 feels `-friction_force`. Dissipated power is
    /// `friction_force * velocity`, never negative: the law is passive.
    ///
    /// # Step
    /// Without `mass` the law has no memory; only the dissipated energy is integrated, exactly for held inputs. A
    /// master that couples it explicitly to a mass $m$ needs a communication step below $2 m / f'(0)$, where
    /// $f'(0) = f_C k_l$ (1962 N.s/m for the defaults: 1.0 ms for 1 kg); above, a held body chatters. With `mass` the
    /// step is not limited. `sticking` means $|v| < 1 / k_l$.
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// No stiction: friction never exceeds $f_C$. Cannot hold a load: a stuck body creeps with $|v| < 1 / k_l$. The
    /// default $k_l = 2000$ s/m saturates at 0.5 mm/s, half of the band of the other laws. `normal_force` = 0 gives
    /// force 0.
    ///
    /// # Source
    /// Bernard (1974), as cited in F. Novais, "A critical analysis on friction force models in dynamical systems", MSc
    /// thesis, University of Minho (2024): equation (6.1), default of Table 6.2.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Bernard;
    /// use stribeck::model::Law;
    /// let mut law = Bernard { velocity: 0.000_25, ..Default::default() }; // half way to 1 / k_l
    /// law.output();
    /// assert!((law.friction_force - 0.981 / 2.0).abs() < 1e-15);
    /// ```
    Bernard: "Coulomb friction with a linear transition, by its slope (Bernard)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        transition_slope: tunable = TRANSITION_SLOPE.start(2000.0),
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Curve<T> for Bernard<T> {
    /// Eq. (6.1).
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        self.level() * (self.transition_slope * velocity).limited(T::from(1.0))
    }

    #[inline(always)]
    fn level(&self) -> T {
        self.mu_k * self.normal_force
    }

    #[inline(always)]
    fn band(&self) -> Option<T> {
        Some(T::from(1.0) / self.transition_slope)
    }

    #[inline(always)]
    fn kinks(&self) -> [T; 2] {
        [T::zero(), T::from(1.0) / self.transition_slope]
    }
}

memoryless!(Bernard);

impl Model for Bernard {
    const PIECEWISE_LINEAR: bool = true;
    const PRESETS: &'static [Preset] =
        &[Preset { name: "thesis", source: "Novais (2024), Tables 6.1 and 6.2 (the start values)", values: &[] }];

    memoryless!();
}

#[cfg(test)]
mod tests {
    use super::*;

    fn force(law: Bernard) -> f64 {
        law.curve(law.velocity)
    }

    /// 0.981 N at and beyond 0.5 mm/s, one fifth of it at 0.1 mm/s.
    #[test]
    fn line_and_plateaus() {
        for (velocity, share) in [(1e-4, 0.2), (-1e-4, -0.2), (5e-4, 1.0), (-0.3, -1.0), (0.0, 0.0)] {
            let law = Bernard { velocity, ..Default::default() };
            assert!((force(law) - 0.981 * share).abs() < 1e-15, "{velocity}");
        }
    }

    /// Inside the band a body with mass decays as implicit Euler of v' = -(f_C k_l / m) v: v / (1 + f_C k_l h / m).
    #[test]
    fn band_with_mass_is_implicit_euler() {
        for dt in [1e-4, 1e-2, 1.0] {
            let mut law = Bernard { velocity: 4e-4, ..Default::default() };
            law.time_stepping.mass = 1.0;
            law.step(dt);
            crate::model::Law::output(&mut law);
            assert!((law.friction_force - 1962.0 * 4e-4 / (1.0 + 1962.0 * dt)).abs() < 1e-15, "{dt}");
        }
    }
}
