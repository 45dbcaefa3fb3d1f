use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::model::{Fault, Model};
use crate::number::{Real, choose};

crate::model! {
    /// Awrejcewicz-Grzelczyk-Pyryev friction: a continuous law that knows the external force and so holds a body at
    /// rest, without a search for the instant of rest.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = A (f_s sgn(v) - f_e) + f_e        |v| <= v_0, |f_e| <= f_s                      (6.22)
    /// f_f = (2 A - 1) f_s sgn(v)              0 < |v| <= v_0, |f_e| > f_s, f_e v <  0
    /// f_f = f_s sgn(f_e)                      |v| <= v_0, |f_e| > f_s, f_e v >= 0
    /// f_f = S(|v|) sgn(v)                     |v| > v_0
    /// A   = (v / v_0)^2 (3 - 2 |v| / v_0)                                                   (6.23)
    /// S(v) = f_C + (f_s - f_C) exp(-xi (v - v_0))
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
    /// | v_0    | `transition_velocity` | m/s  | velocity at which the band ends                 |
    /// | xi     | `stiction_decay`      | s/m  | decay of stiction with speed                    |
    /// | m      | `mass`                | kg   | effective mass of the host, 0 = the printed law |
    /// | h      | `step_size`           | s    | last communication step                         |
    /// | f_f    | `friction_force`      | N    | friction force                                  |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` outside the band and the sign of `external_force` at rest; body 1
    /// feels `-friction_force`. Dissipated power is `friction_force * velocity`; inside the band it is negative where
    /// the external force acts against the motion and is the larger part of the force, with at most $f_s v_0$.
    ///
    /// # Step
    /// Without `mass` the law has no memory; only the dissipated energy is integrated, exactly for held inputs. A
    /// master that couples it explicitly to a mass $m$ needs a communication step below $2 m / f'(0)$, where $f'(0)$
    /// must be replaced by the largest slope $3 f_s / v_0$ (4415 N.s/m for the defaults: 0.45 ms for 1 kg); above, a
    /// held body chatters. With `mass` the step is not limited. `sticking` means $|v| < v_0$.
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`.
    ///
    /// # Limits
    /// Holds at $v = 0$ exactly; inside the band, under a load below $f_s$, the net force is $A (f_s sgn(v) - f_e)$,
    /// which vanishes with $v^2$: in the end a body slows down as 1 / t instead of stopping. Passive outside the band
    /// only. The peak is exactly $f_s$ at $v_0$. No pre-sliding displacement. `normal_force` = 0 gives force 0.
    ///
    /// # Source
    /// Awrejcewicz, Grzelczyk, Pyryev (2008), Journal of Vibroengineering 10, 475-482; equations (6.22) and (6.23) of
    /// F. Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis, University of Minho
    /// (2024), of which only one reading is continuous in $v$ and in $f_e$. $S$ is left open there; the law is
    /// continuous only if $S(v_0) = f_s$, so the exponential starts at $v_0$. $v_0$ and $xi$ are chosen.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Awrejcewicz;
    /// use stribeck::model::Law;
    /// let mut held = Awrejcewicz { external_force: -1.2, ..Default::default() };
    /// held.output();
    /// assert_eq!(held.friction_force, -1.2); // at rest, below mu_s f_n = 1.4715 N
    /// ```
    Awrejcewicz: "Continuous friction law that holds a load at rest (Awrejcewicz, Grzelczyk and Pyryev)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        transition_velocity: tunable = TRANSITION_VELOCITY,
        stiction_decay: tunable = STICTION_DECAY,
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Curve<T> for Awrejcewicz<T> {
    /// Eqs. (6.22), (6.23).
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        let [one, two, three] = [1.0, 2.0, 3.0].map(T::from);
        let [coulomb, breakaway, load] = [self.mu_k * self.normal_force, self.level(), self.external_force];
        let [speed, direction] = [velocity.abs(), velocity.sign()];
        choose!(
            speed.above(self.transition_velocity),
            {
                let decay = (-(self.stiction_decay * (speed - self.transition_velocity))).exp();
                (coulomb + (breakaway - coulomb) * decay) * direction
            },
            {
                let u = speed / self.transition_velocity;
                let a = u * u * (three - two * u);
                choose!(load.abs().at_most(breakaway), a * (breakaway * direction - load) + load, {
                    let is_against = (load * velocity).below(T::zero());
                    choose!(is_against, (two * a - one) * breakaway * direction, breakaway * load.sign())
                })
            }
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
        [T::zero(), self.transition_velocity]
    }
}

memoryless!(Awrejcewicz);

impl Model for Awrejcewicz {
    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    memoryless!();
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn force(velocity: f64, external_force: f64) -> f64 {
        let law = Awrejcewicz { velocity, external_force, ..Default::default() };
        law.curve(velocity)
    }

    #[test]
    fn holds_at_rest_up_to_the_static_level() {
        for (load, held) in [(0.5, 0.5), (-1.2, -1.2), (2.0, 1.4715), (-9.0, -1.4715), (0.0, 0.0)] {
            assert_abs_diff_eq!(force(0.0, load), held, epsilon = 1e-15);
        }
    }

    #[test]
    fn is_the_static_level_at_the_end_of_the_band_for_any_load() {
        for load in [-5.0, -1.4715, -0.3, 0.0, 1.0, 1.4715, 5.0] {
            for side in [1.0, -1.0] {
                for velocity in [0.001, 0.001f64.next_up()] {
                    assert!((force(side * velocity, load) - side * 1.4715).abs() < 1e-14, "{load} {velocity}");
                }
            }
        }
    }

    /// Continuous in velocity and load: a small change has a small effect; the steepest slopes are 3 f_s / v_0 and 1.
    #[test]
    fn is_continuous() {
        for i in -300..300 {
            for k in -200..200 {
                let (velocity, load) = (1e-5 * f64::from(i) + 1e-6, 0.02 * f64::from(k) + 1e-3);
                let change = force(velocity + 1e-6, load) - force(velocity, load);
                assert!(change.abs() <= 3.0 * 1471.5 * 1e-6 + 1e-9, "{velocity} {load}: {change}");
                let change = force(velocity, load + 1e-3) - force(velocity, load);
                assert!(change.abs() <= 1e-3 + 1e-9, "{velocity} {load}: {change}");
            }
        }
    }

    #[test]
    fn no_load_releases_the_contact() {
        let mut law = Awrejcewicz { normal_force: 0.0, external_force: 1.0, ..Default::default() };
        crate::model::Law::output(&mut law);
        assert_eq!((law.friction_force, law.sticking), (0.0, 0.0));
    }
}
