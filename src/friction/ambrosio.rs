use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::model::{Fault, Model, Preset};
use crate::number::{Real, choose};

crate::model! {
    /// Ambrosio friction: Coulomb friction that is zero around rest and ramped up between two velocities, for contacts
    /// in multibody systems.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = 0                                       |v| <= v_0             (6.6)
    /// f_f = f_C (|v| - v_0) / (v_1 - v_0) sgn(v)    v_0 <= |v| <= v_1
    /// f_f = f_C sgn(v)                              |v| >= v_1
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
    /// | v_0    | `transition_velocity` | m/s  | velocity at which the ramp begins               |
    /// | v_1    | `sliding_velocity`    | m/s  | velocity at which $f_C$ is reached              |
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
    /// $f'(v_0) = f_C / (v_1 - v_0)$ in place of $f'(0)$ (1090 N.s/m for the defaults: 1.8 ms for 1 kg); above, a held
    /// body chatters. With `mass` the step is not limited. `sticking` means $|v| < v_1$.
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `sliding_velocity` <= `transition_velocity`.
    ///
    /// # Limits
    /// No stiction: friction never exceeds $f_C$. No resistance at all for $|v| < v_0$; a loaded body creeps with
    /// $v_0 < |v| < v_1$. $v_0 = 0$ is the linear form of Rooney-Deravi friction with its $v_0 := v_1$. `normal_force`
    /// = 0 gives force 0.
    ///
    /// # Source
    /// Ambrosio (2003), in Virtual Nonlinear Multibody Systems, 57-81; equation (6.6) of F. Novais, "A critical
    /// analysis on friction force models in dynamical systems", MSc thesis, University of Minho (2024), defaults of
    /// Table 6.2. Differs from the thesis: (6.6) shows $v - v_0$ in the ramp, which must be $|v| - v_0$ for $v < 0$.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Ambrosio;
    /// use stribeck::model::Law;
    /// let mut law = Ambrosio { velocity: -0.000_55, ..Default::default() }; // the middle of the ramp
    /// law.output();
    /// assert!((law.friction_force + 0.981 / 2.0).abs() < 1e-15);
    /// ```
    Ambrosio: "Coulomb friction that is ramped up with speed (Ambrosio)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        transition_velocity: tunable = TRANSITION_VELOCITY.start(0.0001).at_least(0.0),
        sliding_velocity: tunable = SLIDING_VELOCITY,
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Curve<T> for Ambrosio<T> {
    /// Eq. (6.6).
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        let [speed, from, to] = [velocity.abs(), self.transition_velocity, self.sliding_velocity];
        // Without dead zone the ramp passes through rest.
        self.level()
            * choose!(
                speed.at_most(from),
                choose!(from.is(0.0), velocity / to, T::zero()),
                choose!(speed.below(to), (speed - from) / (to - from) * velocity.sign(), velocity.sign())
            )
    }

    #[inline(always)]
    fn level(&self) -> T {
        self.mu_k * self.normal_force
    }

    #[inline(always)]
    fn band(&self) -> Option<T> {
        Some(self.sliding_velocity)
    }

    #[inline(always)]
    fn kinks(&self) -> [T; 2] {
        [self.transition_velocity, self.sliding_velocity]
    }
}

memoryless!(Ambrosio);

impl Model for Ambrosio {
    const PIECEWISE_LINEAR: bool = true;
    const PRESETS: &'static [Preset] =
        &[Preset { name: "thesis", source: "Novais (2024), Tables 6.1 and 6.2 (the start values)", values: &[] }];

    fn check(&self) -> Result<(), Fault> {
        if self.sliding_velocity <= self.transition_velocity {
            let [from, to] = [self.transition_velocity, self.sliding_velocity];
            return Err(Fault::new(format_args!("sliding_velocity = {to}: must be > transition_velocity = {from}")));
        }
        Ok(())
    }

    memoryless!();
}

#[cfg(test)]
mod tests {
    use super::*;

    fn force(law: Ambrosio) -> f64 {
        law.curve(law.velocity)
    }

    #[test]
    fn dead_zone_ramp_and_plateau() {
        for (velocity, share) in
            [(0.0, 0.0), (1e-4, 0.0), (3.25e-4, 0.25), (-7.75e-4, -0.75), (1e-3, 1.0), (-2.0, -1.0)]
        {
            let law = Ambrosio { velocity, ..Default::default() };
            assert!((force(law) - 0.981 * share).abs() < 1e-15, "{velocity}");
        }
    }

    #[test]
    fn an_empty_ramp_is_refused() {
        let law = Ambrosio { sliding_velocity: 1e-4, ..Default::default() };
        assert_eq!(law.check().unwrap_err().0, "sliding_velocity = 0.0001: must be > transition_velocity = 0.0001");
    }

    /// In the dead zone a free body with mass is not braked; a fast one is braked into it, but not stopped.
    #[test]
    fn a_body_is_braked_to_the_dead_zone_only() {
        let mut law = Ambrosio { velocity: 0.01, ..Default::default() };
        law.time_stepping.mass = 1.0;
        for _ in 0..10_000 {
            law.step(1e-2);
            crate::model::Law::output(&mut law);
            law.velocity -= 1e-2 * law.friction_force;
        }
        assert!((law.velocity - 1e-4).abs() < 1e-12, "{}", law.velocity);
    }
}
