use crate::contact::quantities::*;
use crate::contact::time_stepping::{TimeStepping, two_levels};
use crate::model::Model;
use crate::number::Real;

crate::model! {
    /// Karnopp friction: stiction in a band of small velocities instead of at velocity zero exactly, so that a solver
    /// needs no search for the instant of rest.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = f_C sgn(v)                  |v| >  v_0     (6.7)
    /// f_f = min(|f_e|, f_s) sgn(f_e)    |v| <= v_0
    /// f_C = mu_k f_n,   f_s = mu_s f_n
    /// ```
    ///
    /// With `mass` $m > 0$ the force over a step $h$ is the one that brings the body to rest within the step, limited
    /// to the static level inside the band and to the kinetic level outside (time stepping in the sense of Moreau):
    ///
    /// ```text
    /// f_stop = f_e + m v / h
    /// ```
    ///
    /// | symbol | variable              | unit | meaning                                     |
    /// |--------|-----------------------|------|---------------------------------------------|
    /// | v      | `velocity`            | m/s  | velocity of body 1 relative to body 2       |
    /// | f_n    | `normal_force`        | N    | force pressing the surfaces together        |
    /// | f_e    | `external_force`      | N    | all other tangential forces on body 1       |
    /// | mu_k   | `mu_k`                | 1    | kinetic coefficient of friction             |
    /// | mu_s   | `mu_s`                | 1    | static coefficient of friction              |
    /// | v_0    | `transition_velocity` | m/s  | half width of the band of stiction          |
    /// | m      | `mass`                | kg   | effective mass of the host, 0 = (6.7) alone |
    /// | h      | `step_size`           | s    | last communication step                     |
    /// | f_f    | `friction_force`      | N    | friction force                              |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` when sliding and the sign of `external_force` inside the band; body
    /// 1 feels `-friction_force`. Dissipated power is `friction_force * velocity`.
    ///
    /// # Step
    /// Without `mass` the law has no memory. Inside the band its force balances the external force, so the velocity
    /// stays constant instead of going to zero: a captured body creeps with up to $v_0$. With `mass` it is brought to
    /// rest and neither chatters nor creeps, at any step size, and breaks away from rest: on the belt of the benchmark
    /// the second slip comes 0.04 s later than without, and its amplitude is 1.3 % larger. In Model Exchange a contact is inside the band, or
    /// slides in one direction, from one event to the next. Inside the band it returns `external_force`, up to $f_s$:
    /// connect it, or nothing is held and events repeat endlessly at the edge of the band.
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`.
    ///
    /// # Limits
    /// The force jumps at $|v| = v_0$, and after breakaway the static level acts until the body has left the band. No
    /// Stribeck effect, no pre-sliding displacement. `normal_force` = 0 releases the contact (force 0, not stuck).
    /// `mu_s` = `mu_k` is regularised Coulomb friction.
    ///
    /// # Source
    /// Karnopp (1985), doi:10.1115/1.3140698; equation (6.7) of F. Novais, "A critical analysis on friction force
    /// models in dynamical systems", MSc thesis, University of Minho (2024). Differs: outside the band (6.7) allows any
    /// $f(v)$, here it is $f_C sgn(v)$ without a viscous or a Stribeck part. The default $v_0 = 0.001$ m/s is chosen.
    /// Time stepping: Moreau (1988), doi:10.1007/978-3-7091-2624-0_1. The choice `exchange` is our addition.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Karnopp;
    /// use stribeck::model::Law;
    /// let mut held = Karnopp { velocity: 0.0009, external_force: 1.2, ..Default::default() };
    /// held.output();
    /// assert_eq!(held.friction_force, 1.2); // inside the band, below mu_s f_n = 1.4715 N
    /// ```
    Karnopp: "Coulomb friction with a band of stiction (Karnopp)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        transition_velocity: tunable = TRANSITION_VELOCITY,
        stuck: state = STUCK,
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

two_levels!(Karnopp, |law| law.transition_velocity);

impl Model for Karnopp {
    two_levels!();

    fn kinks(&self) -> [f64; 2] {
        [self.transition_velocity, 0.0]
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::model::Law;

    fn force(velocity: f64, external_force: f64) -> f64 {
        let mut law = Karnopp { velocity, external_force, ..Default::default() };
        law.output();
        law.friction_force
    }

    /// Eq. (6.7) by hand: f_C = 0.981 N, f_s = 1.4715 N, v_0 = 1 mm/s.
    #[test]
    fn printed_law_inside_and_outside_the_band() {
        assert_eq!(force(0.001, 0.7), 0.7);
        assert_abs_diff_eq!(force(-0.001, 9.0), 1.4715, epsilon = 1e-12);
        assert_abs_diff_eq!(force(0.00101, 9.0), 0.981, epsilon = 1e-12);
        assert_abs_diff_eq!(force(-0.5, 0.3), -0.981, epsilon = 1e-12);
    }

    #[test]
    fn an_event_finds_on_which_side_of_the_edge_the_velocity_is() {
        let mut law = Karnopp { velocity: 0.1, external_force: 0.2, stuck: 1.0, ..Default::default() };
        law.at_event();
        law.output();
        assert_abs_diff_eq!(law.friction_force, 0.981, epsilon = 1e-12);
        law.velocity = 0.0009;
        law.output();
        assert!((law.friction_force - 0.981).abs() < 1e-12, "no event has put it inside yet");
        law.at_event();
        law.output();
        assert_eq!(law.friction_force, 0.2);
    }
}
