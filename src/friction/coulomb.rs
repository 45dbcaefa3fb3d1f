use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::model::Model;
use crate::number::Real;

crate::model! {
    /// Coulomb friction: a sliding contact resists with a constant force, one at rest holds up to the same force. All
    /// other laws refine it.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = f_C sgn(v)                   v != 0
    /// f_f = min(|f_e|, f_C) sgn(f_e)     v  = 0
    /// f_C = mu_k f_n
    /// ```
    ///
    /// With `mass` $m > 0$ the force over a step $h$ is that of the velocity $w$ at its end; the jump at rest is part
    /// of $f_f$. Of several solutions it is the first one reached from $v$ in the direction of the acceleration
    /// (implicit Euler; time stepping in the sense of Moreau):
    ///
    /// ```text
    /// m (w - v) / h = f_e - f_f(w)
    /// ```
    ///
    /// | symbol | variable         | unit | meaning                                         |
    /// |--------|------------------|------|-------------------------------------------------|
    /// | v      | `velocity`       | m/s  | velocity of body 1 relative to body 2           |
    /// | f_n    | `normal_force`   | N    | force pressing the surfaces together            |
    /// | f_e    | `external_force` | N    | all other tangential forces on body 1           |
    /// | mu_k   | `mu_k`           | 1    | coefficient of friction                         |
    /// | m      | `mass`           | kg   | effective mass of the host, 0 = the printed law |
    /// | h      | `step_size`      | s    | last communication step                         |
    /// | f_f    | `friction_force` | N    | friction force                                  |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` when sliding and the sign of `external_force` when stuck; body 1
    /// feels `-friction_force`. Dissipated power is `friction_force * velocity`; outside rest it is never negative: the
    /// law is passive.
    ///
    /// # Step
    /// Without `mass` the law has no memory; only the dissipated energy is integrated, exactly for held inputs. A host
    /// that integrates the body itself never reaches $v = 0$ exactly, so the force of a contact at rest then alternates
    /// at any step. With `mass` the body is caught where it comes to rest and neither chatters nor creeps; there is no
    /// largest step. In Model Exchange a contact is held or slides in one direction from one event to the next. A held
    /// contact returns `external_force`: connect it, or the body is released and caught again endlessly.
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// No stiction: the holding force does not exceed the sliding force. No Stribeck effect, no viscous part, no
    /// pre-sliding displacement. `normal_force` = 0 releases the contact (force 0, not sticking). `sticking` means that
    /// the step ends at rest or, without `mass`, that $v = 0$ and $|f_e|$ is within the level.
    ///
    /// # Source
    /// Coulomb (1785); section 4.1.2 of F. Novais, "A critical analysis on friction force models in dynamical systems",
    /// MSc thesis, University of Minho (2024). Time stepping: Moreau (1988), doi:10.1007/978-3-7091-2624-0_1. The
    /// choice `exchange` is ours.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Coulomb;
    /// use stribeck::model::Law;
    /// let mut held = Coulomb { external_force: -1.2, ..Default::default() };
    /// held.output();
    /// assert_eq!(held.friction_force, -0.1 * 9.81); // -1.2 N exceeds mu_k f_n
    /// ```
    Coulomb: "Coulomb friction" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Curve<T> for Coulomb<T> {
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        self.level() * velocity.sign()
    }

    #[inline(always)]
    fn level(&self) -> T {
        self.mu_k * self.normal_force
    }

    #[inline(always)]
    fn band(&self) -> Option<T> {
        None
    }
}

memoryless!(Coulomb);

impl Model for Coulomb {
    const PIECEWISE_LINEAR: bool = true;
    memoryless!();
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::model::Law;

    fn output(law: Coulomb) -> (f64, f64) {
        let mut law = law;
        law.output();
        (law.friction_force, law.sticking)
    }

    /// f_C = 0.981 N: up to it the contact holds, above it slides.
    #[test]
    fn holds_up_to_the_level_and_slides_with_it() {
        assert_eq!(output(Coulomb { external_force: 0.98, ..Default::default() }), (0.98, 1.0));
        assert_eq!(output(Coulomb { external_force: -2.0, ..Default::default() }), (-0.1 * 9.81, 0.0));
        assert_eq!(output(Coulomb { velocity: -1e-12, external_force: 0.5, ..Default::default() }), (-0.1 * 9.81, 0.0));
    }

    /// 2 kg at 3 mm/s under 0.4 N: the force that stops it in 10 ms is 0.4 + 2 * 0.003 / 0.01 = 1.0 N, just too much;
    /// in 11 ms it is 0.945 N.
    #[test]
    fn catches_a_body_that_comes_to_rest_within_the_step() {
        for (dt, force, sticking) in [(0.010, 0.981, 0.0), (0.011, 0.4 + 0.006 / 0.011, 1.0)] {
            let mut law = Coulomb { velocity: 0.003, external_force: 0.4, ..Default::default() };
            law.time_stepping.mass = 2.0;
            law.step(dt);
            let (found, held) = output(law);
            assert!((found - force).abs() < 1e-12, "{found}");
            assert_eq!(held, sticking);
        }
    }
}
