use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::laws::{stribeck, viscous};
use crate::model::{Fault, Model, Preset};
use crate::number::Real;

crate::model! {
    /// Andersson friction: the Stribeck curve times a hyperbolic tangent, smooth, with every parameter of the curve.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = (f_C + (f_s - f_C) exp(-(|v| / v_S)^p)) tanh(k_t v) + f_v v
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
    /// | v_S    | `stribeck_velocity`   | m/s   | Stribeck velocity                               |
    /// | p      | `stribeck_exponent`   | 1     | shape of the Stribeck curve                     |
    /// | k_t    | `transition_slope`    | s/m   | slope at rest over $f_s$                        |
    /// | f_v    | `viscous_coefficient` | N.s/m | viscous coefficient                             |
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
    /// $f'(0) = f_s k_t + f_v$ (14715 N.s/m for the defaults: 0.14 ms for 1 kg, the shortest of all static laws);
    /// above, a held body chatters. With `mass` the step is not limited. `sticking` means $|v| < 3 / k_t$ (chosen:
    /// 99.5 % of the rise).
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`.
    ///
    /// # Limits
    /// Cannot hold a load: a stuck body creeps at the speed where the force equals the load. The peak is always below
    /// $f_s$ ($0.9678 f_s$ at 0.272 mm/s for the defaults, $0.9991 f_s$ for $k_t = 1e5$ s/m) and needs $k_t v_S$ well
    /// above 1, say 10: for $k_t v_S = 1$ there is none, and friction never exceeds $f_C$. `mu_s` = `mu_k` is
    /// $f_C tanh(k_t v)$. No pre-sliding displacement. `normal_force` = 0 gives force 0, also of the viscous part.
    ///
    /// # Source
    /// Andersson, Soderberg, Bjorklund (2007), doi:10.1016/j.triboint.2005.11.014, and Nikravesh, Planar Multibody
    /// Dynamics, whose programs have the same function. No equation of the thesis was available. Defaults as in those
    /// programs. Some public implementations have $mu_k - mu_s$ in the bracket, which turns the stiction peak into a
    /// dip.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Andersson;
    /// use stribeck::model::Law;
    /// let mut law = Andersson { velocity: 0.001, ..Default::default() }; // the Stribeck velocity, k_t v = 10
    /// law.output();
    /// assert!((law.friction_force - (0.981 + 0.4905 * (-1.0f64).exp()) * 10f64.tanh()).abs() < 1e-15);
    /// ```
    Andersson: "Smooth friction law with the Stribeck curve (Andersson)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        stribeck_velocity: tunable = STRIBECK_VELOCITY,
        stribeck_exponent: tunable = STRIBECK_EXPONENT,
        transition_slope: tunable = TRANSITION_SLOPE,
        viscous_coefficient: tunable = VISCOUS_COEFFICIENT,
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Curve<T> for Andersson<T> {
    /// The Stribeck level, regularised.
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        let [coulomb, breakaway] = [self.mu_k * self.normal_force, self.level()];
        let level = stribeck::level(velocity, coulomb, breakaway, self.stribeck_velocity, self.stribeck_exponent);
        let viscous = viscous::force(velocity, self.viscous_coefficient, self.normal_force);
        level * (self.transition_slope * velocity).tanh() + viscous
    }

    #[inline(always)]
    fn level(&self) -> T {
        self.mu_s * self.normal_force
    }

    #[inline(always)]
    fn band(&self) -> Option<T> {
        Some(T::from(3.0) / self.transition_slope)
    }
}

memoryless!(Andersson);

impl Model for Andersson {
    const PRESETS: &'static [Preset] = &[Preset {
        name: "conveyor_belt",
        source: "Conveyor-belt example of Nikravesh, Planar Multibody Dynamics",
        values: &[("mu_k", 0.15), ("mu_s", 0.2)],
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

    fn force(law: Andersson) -> f64 {
        law.curve(law.velocity)
    }

    fn peak(law: Andersson) -> f64 {
        (1..40_000).map(|k| force(Andersson { velocity: 5e-8 * f64::from(k), ..law })).fold(0.0, f64::max)
    }

    /// Found by search: 1.42410731 N at 0.272268 mm/s; 0.999099 f_s for k_t = 1e5; 0.913878 f_s for p = 1.
    #[test]
    fn peak_is_below_the_static_level() {
        let law = Andersson::default();
        assert_abs_diff_eq!(peak(law), 1.424_107_31, epsilon = 1e-8);
        assert_abs_diff_eq!(force(Andersson { velocity: 2.722_68e-4, ..law }), 1.424_107_31, epsilon = 1e-8);
        assert_abs_diff_eq!(peak(Andersson { transition_slope: 1e5, ..law }) / 1.4715, 0.999_099, epsilon = 1e-6);
        assert_abs_diff_eq!(peak(Andersson { stribeck_exponent: 1.0, ..law }) / 1.4715, 0.913_878, epsilon = 1e-6);
    }

    /// k_t v_S = 1: no stiction peak.
    #[test]
    fn a_flat_transition_hides_the_peak() {
        let law = Andersson { transition_slope: 1e3, ..Default::default() };
        assert!(peak(law) < 0.981 && (force(Andersson { velocity: 1.0, ..law }) - 0.981).abs() < 1e-15);
    }

    #[test]
    fn equal_levels_leave_a_hyperbolic_tangent() {
        for velocity in [-2e-3, 3e-5, 0.0] {
            let law = Andersson { velocity, mu_s: 0.1, ..Default::default() };
            assert_abs_diff_eq!(force(law), 0.981 * (1e4 * velocity).tanh(), epsilon = 1e-15);
        }
    }
}
