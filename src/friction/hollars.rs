use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::model::{Fault, Meaning, Model, Preset, real};
use crate::number::Real;

crate::model! {
    /// Hollars friction: a continuous law with a stiction peak that uses only rational functions, known from the
    /// contact models of Simbody.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = f_n (min(r, 1) (mu_k + 2 (mu_s - mu_k) / (1 + r^2)) + mu_v |v|) sgn(v)
    /// r   = |v| / v_0
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
    /// | symbol | variable              | unit | meaning                                         |
    /// |--------|-----------------------|------|-------------------------------------------------|
    /// | v      | `velocity`            | m/s  | velocity of body 1 relative to body 2           |
    /// | f_n    | `normal_force`        | N    | force pressing the surfaces together            |
    /// | f_e    | `external_force`      | N    | all other tangential forces on body 1           |
    /// | mu_k   | `mu_k`                | 1    | kinetic coefficient of friction                 |
    /// | mu_s   | `mu_s`                | 1    | static coefficient of friction                  |
    /// | v_0    | `transition_velocity` | m/s  | velocity of the stiction peak                   |
    /// | mu_v   | `mu_v`                | s/m  | viscous coefficient per normal force            |
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
    /// $f'(0) = (2 f_s - f_C) / v_0 + mu_v f_n$ (1962 N.s/m for the defaults: 1.0 ms for 1 kg); above, a held body
    /// chatters. With `mass` the step is not limited. `sticking` means $|v| < v_0$.
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`.
    ///
    /// # Limits
    /// Cannot hold a load: a stuck body creeps with $|v| < v_0$. Without viscous part the peak is exactly $f_s$ at
    /// $v_0$, with a kink there. The excess over $f_C$ falls as $2 (f_s - f_C) / r^2$, slower than the exponential
    /// laws. `mu_s` = `mu_k` is the linear form of Rooney-Deravi friction. No pre-sliding displacement. `normal_force`
    /// = 0 gives force 0.
    ///
    /// # Source
    /// Hollars, Rosenthal, Sherman (1994), SD/FAST manual, as documented for Simbody: Sherman, Seth, Delp (2011),
    /// doi:10.1016/j.piutam.2011.04.023. No equation of the thesis was available. The default $v_0 = 0.001$ m/s is
    /// chosen (Simbody: 0.01 m/s, preset `simbody`). Newer contact models of Simbody use a quintic transition instead.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Hollars;
    /// use stribeck::model::Law;
    /// let mut law = Hollars { velocity: -0.001, ..Default::default() };
    /// law.output();
    /// assert!((law.friction_force + 1.4715).abs() < 1e-15); // f_s at v_0
    /// ```
    Hollars: "Continuous friction law with a stiction peak, without exponentials (Hollars)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        transition_velocity: tunable = TRANSITION_VELOCITY,
        /// Viscous coefficient of friction, per normal force.
        mu_v: tunable = real("s/m", 0.0).at_least(0.0).means(Meaning::GrowsWithSpeed),
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Curve<T> for Hollars<T> {
    /// The force with its sign: min(r, 1) and r^2 do not depend on it.
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        let u = velocity / self.transition_velocity;
        let [one, two] = [1.0, 2.0].map(T::from);
        let dry = u.limited(one) * (self.mu_k + two * (self.mu_s - self.mu_k) / (one + u * u));
        self.normal_force * (dry + self.mu_v * velocity)
    }

    #[inline(always)]
    fn level(&self) -> T {
        self.mu_s * self.normal_force
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

memoryless!(Hollars);

impl Model for Hollars {
    const PRESETS: &'static [Preset] = &[Preset {
        name: "simbody",
        source: "Default transition velocity of Simbody",
        values: &[("transition_velocity", 0.01)],
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

    fn force(law: Hollars) -> f64 {
        law.curve(law.velocity)
    }

    /// r = 2: mu_k + 2 (mu_s - mu_k) / 5 = 0.12; r = 1/2: 0.5 (0.1 + 0.1 / 1.25) = 0.09; times 10 N.
    #[test]
    fn by_hand() {
        for (velocity, expected) in [(-2e-3, -1.2), (5e-4, 0.9), (1e-3, 1.5), (0.0, 0.0)] {
            assert_abs_diff_eq!(
                force(Hollars { velocity, normal_force: 10.0, ..Default::default() }),
                expected,
                epsilon = 1e-14
            );
        }
        let viscous = Hollars { velocity: -4.0, normal_force: 10.0, mu_v: 0.05, ..Default::default() };
        assert_abs_diff_eq!(force(viscous) + 1.0, -2.0, epsilon = 1e-6);
    }
}
