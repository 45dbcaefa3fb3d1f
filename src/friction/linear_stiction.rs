use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::model::{Fault, Model};
use crate::number::{Real, choose};

crate::model! {
    /// Linear friction with stiction: three straight lines, up to the static level, down to the kinetic one and on at
    /// that level. In the thesis's comparison it has the shortest run time of all static laws with stiction (Table 6.5,
    /// with ode23s; averaged over the solvers, Awrejcewicz's law is the fastest).
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = f_s v / v_0                                                    |v| <= v_0             (6.29)
    /// f_f = (f_s - (f_s - f_C) (|v| - v_0) / (v_1 - v_0)) sgn(v)           v_0 <= |v| <= v_1
    /// f_f = f_C sgn(v)                                                     |v| >= v_1
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
    /// $f'(0) = f_s / v_0$ (1472 N.s/m for the defaults: 1.4 ms for 1 kg); above, a held body chatters. With `mass`
    /// the step is not limited. `sticking` means $|v| < v_0$.
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`; `sliding_velocity` <= `transition_velocity`.
    ///
    /// # Limits
    /// Cannot hold a load: a stuck body creeps with $|v| < v_0$. The peak is exactly $f_s$ at $v_0$. Kinks at $v_0$ and
    /// $v_1$. `mu_s` = `mu_k` is the linear form of Rooney-Deravi friction. No pre-sliding displacement. `normal_force`
    /// = 0 gives force 0.
    ///
    /// # Source
    /// Marques, Flores, Claro, Lankarani (2016), doi:10.1007/s11071-016-2999-3; equation (6.29) of F. Novais, "A
    /// critical analysis on friction force models in dynamical systems", MSc thesis, University of Minho (2024). The
    /// values in the thesis are on a page that was not available: $v_0 = 1$ mm/s and $v_1 = 1.5$ mm/s are chosen.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::LinearStiction;
    /// use stribeck::model::Law;
    /// let mut law = LinearStiction { velocity: 0.001_25, ..Default::default() }; // between v_0 and v_1
    /// law.output();
    /// assert!((law.friction_force - (1.4715 + 0.981) / 2.0).abs() < 1e-15);
    /// ```
    LinearStiction: "Friction law with stiction made of three straight lines" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        transition_velocity: tunable = TRANSITION_VELOCITY,
        sliding_velocity: tunable = SLIDING_VELOCITY.start(0.0015),
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Curve<T> for LinearStiction<T> {
    /// Eq. (6.29).
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        let [speed, from, to] = [velocity.abs(), self.transition_velocity, self.sliding_velocity];
        let [coulomb, breakaway] = [self.mu_k * self.normal_force, self.level()];
        choose!(
            speed.at_most(from),
            breakaway * velocity / from,
            choose!(
                speed.below(to),
                (breakaway - (breakaway - coulomb) * (speed - from) / (to - from)) * velocity.sign(),
                coulomb * velocity.sign()
            )
        )
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
        [self.transition_velocity, self.sliding_velocity]
    }
}

memoryless!(LinearStiction);

impl Model for LinearStiction {
    const PIECEWISE_LINEAR: bool = true;
    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)?;
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

    fn force(law: LinearStiction) -> f64 {
        law.curve(law.velocity)
    }

    #[test]
    fn three_lines_meet() {
        for (velocity, expected) in
            [(2e-4, 0.2943), (-1e-3, -1.4715), (1.25e-3, 1.22625), (1.5e-3, 0.981), (-3.0, -0.981)]
        {
            assert!((force(LinearStiction { velocity, ..Default::default() }) - expected).abs() < 1e-14, "{velocity}");
        }
    }

    #[test]
    fn an_empty_ramp_is_refused() {
        let law = LinearStiction { sliding_velocity: 1e-3, ..Default::default() };
        assert_eq!(law.check().unwrap_err().0, "sliding_velocity = 0.001: must be > transition_velocity = 0.001");
    }

    /// A body of 1 kg at 1.4 mm/s under 1.2 N, on the falling line, where f = 2.4525 - 981 v and the load is above it:
    /// it escapes to the kinetic line. In 1 ms: w = v + h (f_e - f_C) / m.
    #[test]
    fn a_driven_body_leaves_the_falling_line() {
        let mut law = LinearStiction { velocity: 1.4e-3, external_force: 1.2, ..Default::default() };
        law.time_stepping.mass = 1.0;
        law.step(1e-3);
        crate::model::Law::output(&mut law);
        assert!((law.friction_force - 0.981).abs() < 1e-12, "{}", law.friction_force);
    }

    /// At 1.1 mm/s under 1.3 N the line is above the load: it decelerates, back to the rising line, where
    /// w = (v + h f_e / m) / (1 + h f_s / (v_0 m)).
    #[test]
    fn a_weakly_driven_body_falls_back_to_stiction() {
        let mut law = LinearStiction { velocity: 1.1e-3, external_force: 1.3, ..Default::default() };
        law.time_stepping.mass = 1.0;
        law.step(1e-2);
        crate::model::Law::output(&mut law);
        let velocity = (1.1e-3 + 1e-2 * 1.3) / (1.0 + 1e-2 * 1471.5);
        assert!((law.friction_force - 1471.5 * velocity).abs() < 1e-12, "{}", law.friction_force);
    }
}
