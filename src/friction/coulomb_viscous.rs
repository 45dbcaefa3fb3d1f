use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::laws::viscous;
use crate::model::{Meaning, Model, real};
use crate::number::{Real, choose};

crate::choices! {
    /// Variants of the law.
    pub enum CoulombViscousVariant {
        /// The viscous part is proportional to velocity.
        Linear,
        /// The viscous part is a power of speed.
        Power,
    }
}

crate::model! {
    /// Coulomb friction with a viscous part: sliding friction that grows with speed.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = f_C sgn(v) + f_v v                   v != 0, Linear     (5.2)
    /// f_f = f_C sgn(v) + f_v |v|^d_v sgn(v)      v != 0, Power      (5.3)
    /// f_f = min(|f_e|, f_C) sgn(f_e)             v  = 0
    /// f_C = mu_k f_n
    /// ```
    ///
    /// In (5.3) $|v|$ stands for $|v|$ / (1 m/s), so that $f_v$ has the same unit for every exponent up to a factor 1
    /// m/s.
    ///
    /// With `mass` $m > 0$ the force over a step $h$ is that of the velocity $w$ at its end; the jump at rest is part
    /// of $f_f$. Of several solutions it is the first one reached from $v$ in the direction of the acceleration
    /// (implicit Euler; time stepping in the sense of Moreau):
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
    /// | mu_k   | `mu_k`                | 1     | coefficient of friction                         |
    /// |        | `variant`             |       | which of the two equations                      |
    /// | f_v    | `viscous_coefficient` | N.s/m | viscous coefficient                             |
    /// | d_v    | `viscous_exponent`    | 1     | exponent of the viscous part of (5.3)           |
    /// | m      | `mass`                | kg    | effective mass of the host, 0 = the printed law |
    /// | h      | `step_size`           | s     | last communication step                         |
    /// | f_f    | `friction_force`      | N     | friction force                                  |
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
    /// No stiction, no Stribeck effect, no pre-sliding displacement. `normal_force` = 0 releases the contact: force 0,
    /// also of the viscous part. $d_v < 1$ gives the force an infinite slope at rest. $f_v = 0$ is plain Coulomb
    /// friction. `sticking` means that the step ends at rest or, without `mass`, that $v = 0$ and $|f_e|$ is within the
    /// level.
    ///
    /// # Source
    /// Equations (5.2) and (5.3) of F. Novais, "A critical analysis on friction force models in dynamical systems", MSc
    /// thesis, University of Minho (2024); the same form in Olsson et al. (1998), European Journal of Control 4,
    /// 176-195. $f_v = 0.1$ N.s/m is chosen. Time stepping: Moreau (1988), doi:10.1007/978-3-7091-2624-0_1. The choice
    /// `exchange` is ours.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::CoulombViscous;
    /// use stribeck::model::Law;
    /// let mut law = CoulombViscous { velocity: -2.0, ..Default::default() };
    /// law.output();
    /// assert!((law.friction_force + 0.981 + 0.2).abs() < 1e-15); // -(mu_k f_n + f_v |v|)
    /// ```
    CoulombViscous: "Coulomb friction with a viscous part" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        /// Variant of the law.
        variant: fixed = CoulombViscousVariant::Linear.start().means(Meaning::Variant),
        viscous_coefficient: tunable = VISCOUS_COEFFICIENT.start(0.1),
        /// Exponent of the viscous part.
        viscous_exponent: tunable = real("1", 1.0).positive().means(Meaning::Shape),
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Curve<T> for CoulombViscous<T> {
    /// Eqs. (5.2), (5.3).
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        let speed = choose!(
            CoulombViscousVariant::Power.is(self.variant),
            velocity.abs().powf(self.viscous_exponent),
            velocity.abs()
        );
        let viscous = viscous::force(speed, self.viscous_coefficient, self.normal_force);
        (self.level() + viscous) * velocity.sign()
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

memoryless!(CoulombViscous);

impl Model for CoulombViscous {
    const PIECEWISE_LINEAR: bool = true;
    memoryless!();
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn force(law: CoulombViscous) -> f64 {
        law.curve(law.velocity)
    }

    const POWER: f64 = 2.0;

    #[test]
    fn the_power_with_exponent_1_is_linear() {
        for velocity in [-3.0, -1e-4, 2e-7, 0.3] {
            let linear = CoulombViscous { velocity, ..Default::default() };
            assert_abs_diff_eq!(force(CoulombViscous { variant: POWER, ..linear }), force(linear), epsilon = 1e-15);
        }
    }

    /// 0.981 + 0.1 * 4^(3/2) = 1.781 N, by hand.
    #[test]
    fn power_law_by_hand() {
        let law = CoulombViscous { velocity: -4.0, variant: POWER, viscous_exponent: 1.5, ..Default::default() };
        assert_abs_diff_eq!(force(law), -1.781, epsilon = 1e-14);
    }

    /// 1 kg at 1 m/s, mu_k = 0, f_v = 3 N.s/m: implicit Euler gives v / (1 + f_v h / m).
    #[test]
    fn viscous_braking_is_implicit_euler() {
        let mut law = CoulombViscous { velocity: 1.0, mu_k: 0.0, viscous_coefficient: 3.0, ..Default::default() };
        law.time_stepping.mass = 1.0;
        law.step(0.5);
        crate::model::Law::output(&mut law);
        assert_abs_diff_eq!(law.friction_force, 3.0 / 2.5, epsilon = 1e-15);
    }
}
