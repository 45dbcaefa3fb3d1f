use crate::contact::quantities::*;
use crate::contact::time_stepping::{TimeStepping, two_levels};
use crate::model::Model;
use crate::number::Real;

crate::model! {
    /// Coulomb friction with stiction: a contact at rest holds up to the static level, a sliding one resists with the
    /// kinetic level. The reference law of stick-slip; it needs the external force that it has to hold.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = f_C sgn(v)                   v != 0      (5.1)
    /// f_f = min(|f_e|, f_s) sgn(f_e)     v  = 0
    /// f_C = mu_k f_n,   f_s = mu_s f_n
    /// ```
    ///
    /// With `mass` $m > 0$ the force over a step $h$ is the one that brings the body to rest within the step, limited
    /// to the static level while stuck and to the kinetic level while sliding (time stepping in the sense of Moreau):
    ///
    /// ```text
    /// f_stop = f_e + m v / h
    /// ```
    ///
    /// | symbol | variable             | unit | meaning                                     |
    /// |--------|----------------------|------|---------------------------------------------|
    /// | v      | `velocity`           | m/s  | velocity of body 1 relative to body 2       |
    /// | f_n    | `normal_force`       | N    | force pressing the surfaces together        |
    /// | f_e    | `external_force`     | N    | all other tangential forces on body 1       |
    /// | mu_k   | `mu_k`               | 1    | kinetic coefficient of friction             |
    /// | mu_s   | `mu_s`               | 1    | static coefficient of friction              |
    /// | m      | `mass`               | kg   | effective mass of the host, 0 = (5.1) alone |
    /// | h      | `step_size`          | s    | last communication step                     |
    /// | f_f    | `friction_force`     | N    | friction force                              |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` when sliding and the sign of `external_force` when stuck; body 1
    /// feels `-friction_force`. Dissipated power is `friction_force * velocity`.
    ///
    /// # Step
    /// Without `mass` the law has no memory. With `mass` it remembers whether it is stuck and how long the last step
    /// was. A stuck body then neither chatters nor creeps, at any step size: the only velocity that remains is the one
    /// caused by a change of `external_force` within a step. In Model Exchange a contact is held or slides in one
    /// direction from one event to the next. A held contact returns `external_force`: connect it, or the body is
    /// released and caught again endlessly.
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`.
    ///
    /// # Limits
    /// No Stribeck effect, no pre-sliding displacement, no viscous part. Without `mass` a host that integrates the body
    /// itself never reaches $v = 0$ exactly, so the force alternates: use `mass`, or a regularised or bristle law.
    /// `normal_force` = 0 releases the contact (force 0, not stuck). `mu_s` = `mu_k` is plain Coulomb friction.
    ///
    /// # Source
    /// Morin (1833); Rabinowicz (1951), doi:10.1063/1.1699869; equation (5.1) of F. Novais, "A critical analysis on
    /// friction force models in dynamical systems", MSc thesis, University of Minho (2024). Time stepping: Moreau
    /// (1988), doi:10.1007/978-3-7091-2624-0_1. The choice `exchange` is our addition.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::CoulombStiction;
    /// use stribeck::model::Law;
    /// let mut held = CoulombStiction { external_force: -1.2, ..Default::default() };
    /// held.output();
    /// assert_eq!(held.friction_force, -1.2); // stuck: below mu_s f_n = 1.4715 N
    /// ```
    CoulombStiction: "Coulomb friction with stiction" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        stuck: state = STUCK,
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

two_levels!(CoulombStiction, |_law| T::zero());

impl Model for CoulombStiction {
    const PIECEWISE_LINEAR: bool = true;
    two_levels!();
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::model::Law;

    fn force(velocity: f64, external_force: f64) -> f64 {
        let mut law = CoulombStiction { velocity, external_force, ..Default::default() };
        law.output();
        law.friction_force
    }

    /// Eq. (5.1) by hand: f_C = 0.981 N, f_s = 1.4715 N.
    #[test]
    fn printed_law_at_rest_and_sliding() {
        assert_abs_diff_eq!(force(1e-9, -3.0), 0.981, epsilon = 1e-12);
        assert_abs_diff_eq!(force(-2.0, 3.0), -0.981, epsilon = 1e-12);
        assert_eq!(force(0.0, 0.7), 0.7);
        assert_abs_diff_eq!(force(0.0, 9.0), 1.4715, epsilon = 1e-12);
        assert_abs_diff_eq!(force(0.0, -9.0), -1.4715, epsilon = 1e-12);
    }

    /// The law after an event, and its indicator of the next one.
    fn settled(law: CoulombStiction) -> (CoulombStiction, f64) {
        let (mut law, mut indicators) = (law, [f64::NAN; CoulombStiction::EVENT_INDICATORS]);
        law.at_event();
        law.output();
        law.event_indicators(&mut indicators);
        (law, indicators[0])
    }

    #[test]
    fn between_events_the_direction_of_sliding_is_frozen() {
        let (forward, before) = settled(CoulombStiction { velocity: 1e-3, ..Default::default() });
        let mut beyond = CoulombStiction { velocity: -1e-3, ..forward };
        let mut indicators = [f64::NAN; CoulombStiction::EVENT_INDICATORS];
        beyond.output();
        beyond.event_indicators(&mut indicators);
        assert_eq!(beyond.friction_force, forward.friction_force);
        assert!(before > 0.0 && indicators[0] < 0.0, "{before} {indicators:?}");
        let (backward, after) = settled(beyond);
        assert_eq!(backward.friction_force, -forward.friction_force);
        assert!(after > 0.0);
    }

    /// Each event leaves an indicator that is clearly positive, on whichever side of the instant it occurred.
    #[test]
    fn a_body_at_rest_is_caught_below_the_static_level_and_driven_on_above_it() {
        for error in [-1e-13, 0.0, 1e-13] {
            for (load, direction) in [(0.0, 0.0), (-1.4, 0.0), (1.4714, 0.0), (1.472, 1.0), (-1.472, -1.0)] {
                let sliding = settled(CoulombStiction { velocity: 1e-3, ..Default::default() }).0;
                let rest = CoulombStiction { velocity: -1e-9 + error, external_force: load, ..sliding };
                let (rest, indicator) = settled(rest);
                let expected = if direction == 0.0 { load } else { direction * 0.981 };
                assert!((rest.friction_force - expected).abs() < 1e-12, "{load}: {}", rest.friction_force);
                assert!(indicator > 1e-10, "{load}: {indicator}");
            }
            let held = settled(CoulombStiction { velocity: 1e-9, ..Default::default() }).0;
            let (released, indicator) =
                settled(CoulombStiction { external_force: -1.4715 * (1.0 + 1e-9) + error, ..held });
            assert!((released.friction_force + 0.981).abs() < 1e-12, "{}", released.friction_force);
            assert!(indicator > 1e-10, "{indicator}");
        }
    }

    #[test]
    fn no_load_releases_the_contact() {
        let mut law = CoulombStiction { normal_force: 0.0, external_force: 1.0, ..Default::default() };
        law.output();
        assert_eq!((law.friction_force, law.sticking), (0.0, 0.0));
    }
}
