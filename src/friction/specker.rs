use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::laws::specker::SpeckerCurve;
use crate::model::{Fault, Model, Preset};
use crate::number::{Real, choose};

crate::model! {
    /// Specker friction: a smooth law whose force at a given peak velocity is the static level, with one exponential
    /// and one hyperbolic tangent.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = f_C tanh(v / v_0)                                        (6.27)
    ///     + f_p (v / v_p) exp((1 - (v / v_p)^2) / 2) + c_v v
    /// f_p = max(f_s - f_C tanh(v_p / v_0) - c_v v_p, 0)
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
    /// | symbol | variable              | unit  | meaning                                         |
    /// |--------|-----------------------|-------|-------------------------------------------------|
    /// | v      | `velocity`            | m/s   | velocity of body 1 relative to body 2           |
    /// | f_n    | `normal_force`        | N     | force pressing the surfaces together            |
    /// | f_e    | `external_force`      | N     | all other tangential forces on body 1           |
    /// | mu_k   | `mu_k`                | 1     | kinetic coefficient of friction                 |
    /// | mu_s   | `mu_s`                | 1     | static coefficient of friction                  |
    /// | v_0    | `transition_velocity` | m/s   | velocity scale of the transition                |
    /// | v_p    | `peak_velocity`       | m/s   | velocity at which $f_s$ is reached              |
    /// | c_v    | `viscous_coefficient` | N.s/m | viscous coefficient                             |
    /// | m      | `mass`                | kg    | effective mass of the host, 0 = the printed law |
    /// | h      | `step_size`           | s     | last communication step                         |
    /// | f_f    | `friction_force`      | N     | friction force                                  |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity`; body 1 feels `-friction_force`. Dissipated power is
    /// `friction_force * velocity`, never negative: the law is passive.
    ///
    /// # Step
    /// Without `mass` the law has no memory; only the dissipated energy is integrated, exactly for held inputs. A
    /// master that couples it explicitly to a mass $m$ needs a communication step below $2 m / f'(0)$, where
    /// $f'(0) = f_C / v_0 + f_p exp(1/2) / v_p + c_v$ (5658 N.s/m for the defaults: 0.35 ms for 1 kg); above, a held
    /// body chatters. With `mass` the step is not limited. `sticking` means $|v| < v_p$.
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`.
    ///
    /// # Limits
    /// Cannot hold a load: a stuck body creeps with $|v| < v_p$. The force at $v_p$ is exactly $f_s$, but the maximum
    /// lies beyond and a little higher: $1.0044 f_s$ at 0.548 mm/s for the defaults, $1.030 f_s$ for $v_0 = v_p$, at
    /// most $1.11 f_s$. Choose $v_0$ below $v_p$ (guidance of the authors: $v_S = 4 v_0 = 2 v_p$ for a Stribeck
    /// velocity $v_S$). No pre-sliding displacement. `normal_force` = 0 gives force 0, also of the viscous part.
    ///
    /// # Source
    /// Specker, Buchholz, Dietmayer (2014), IFAC Proceedings Volumes 47(3), 4523-4528; equations (6.24) to (6.28) of F.
    /// Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis, University of Minho
    /// (2024), of which (6.24) is the first term, (6.27) the whole and (6.28) the guidance. Differs: $f_p$ is kept from
    /// becoming negative, which would drive the motion; with `mu_s` >= `mu_k` that only concerns the viscous part at
    /// small loads. $v_0 = 0.25$ mm/s and $v_p = 0.5$ mm/s follow the guidance for $v_S = 1$ mm/s, which is chosen.
    /// Translational Friction of Simscape has the same form without the corrections in $f_p$ (preset `simscape`).
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Specker;
    /// use stribeck::model::Law;
    /// let mut law = Specker { velocity: 0.000_5, ..Default::default() };
    /// law.output();
    /// assert!((law.friction_force - 1.4715).abs() < 1e-15); // f_s at the peak velocity
    /// ```
    Specker: "Smooth friction law that passes through the static level (Specker)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        transition_velocity: tunable = TRANSITION_VELOCITY.start(0.00025),
        peak_velocity: tunable = PEAK_VELOCITY,
        viscous_coefficient: tunable = VISCOUS_COEFFICIENT,
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Curve<T> for Specker<T> {
    /// Eq. (6.27).
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        let curve = SpeckerCurve {
            coulomb: self.mu_k * self.normal_force,
            breakaway: self.level(),
            transition_velocity: self.transition_velocity,
            peak_velocity: self.peak_velocity,
            viscous_coefficient: self.viscous_coefficient,
        };
        choose!(self.normal_force.at_most(T::zero()), T::zero(), curve.force(velocity))
    }

    #[inline(always)]
    fn level(&self) -> T {
        self.mu_s * self.normal_force
    }

    #[inline(always)]
    fn band(&self) -> Option<T> {
        Some(self.peak_velocity)
    }
}

memoryless!(Specker);

impl Model for Specker {
    const PRESETS: &'static [Preset] = &[Preset {
        name: "simscape",
        source: "Ratio of the two velocities in Translational Friction of Simscape, v_0 = v_p / 10, at v_p = 0.5 mm/s",
        values: &[("transition_velocity", 5e-5)],
    }];

    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    memoryless!();
}

#[cfg(test)]
mod tests {
    use super::*;

    fn force(law: Specker) -> f64 {
        law.curve(law.velocity)
    }

    fn peak(law: Specker) -> (f64, f64) {
        let points = (1..40_000).map(|k| 5e-8 * f64::from(k));
        let forces = points.map(|velocity| (velocity, force(Specker { velocity, ..law })));
        forces.fold((0.0, 0.0), |highest, point| if point.1 > highest.1 { point } else { highest })
    }

    #[test]
    fn passes_through_the_static_level_for_any_velocities_and_viscosity() {
        for (v_0, v_p, c_v) in [(1e-4, 1e-3, 0.0), (2e-3, 1e-3, 5.0), (2.5e-4, 5e-4, 100.0)] {
            let law = Specker {
                velocity: -v_p,
                transition_velocity: v_0,
                peak_velocity: v_p,
                viscous_coefficient: c_v,
                ..Default::default()
            };
            assert!((force(law) + 1.4715).abs() < 1e-14, "{v_0} {v_p} {c_v}");
        }
    }

    /// Found by search: 1.0043723 f_s at 0.54794 mm/s; 1.030248 f_s for v_0 = v_p; f_s for v_0 = v_p / 10.
    #[test]
    fn the_maximum_is_a_little_beyond() {
        let (velocity, force) = peak(Specker::default());
        assert!((velocity - 5.4794e-4).abs() < 1e-7 && (force / 1.4715 - 1.004_372_3).abs() < 1e-7);
        for (v_0, share) in [(5e-4, 1.030_248), (5e-5, 1.0)] {
            let (_, force) = peak(Specker { transition_velocity: v_0, ..Default::default() });
            assert!((force / 1.4715 - share).abs() < 1e-6, "{v_0}: {}", force / 1.4715);
        }
    }

    /// A light load with a strong viscous part: friction must not drive the motion.
    #[test]
    fn stays_passive_where_the_viscous_part_exceeds_the_static_level() {
        for k in 1..2000 {
            let velocity = 1e-6 * f64::from(k);
            let law = Specker { velocity, normal_force: 1e-3, viscous_coefficient: 10.0, ..Default::default() };
            assert!(force(law) > 0.0, "{velocity}");
        }
    }
}
