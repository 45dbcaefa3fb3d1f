use crate::friction::time_stepping::{self, TimeStepping, TwoLevels};
use crate::model::{Fault, Law, Model, boolean, real};
use crate::number::Real;

crate::model! {
    /// Coulomb friction with stiction: a contact at rest holds up to the static level, a sliding one resists with the
    /// kinetic level. The reference law of stick-slip; it needs the external force to know what to hold.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = f_C sgn(v)                   v != 0      (5.1)
    /// f_f = min(|f_e|, f_s) sgn(f_e)     v  = 0
    /// f_C = mu_k f_n,   f_s = mu_s f_n
    /// ```
    ///
    /// With `mass` m > 0 the force over a step h is the one that brings the body to rest within the step, limited to the
    /// static level while stuck and to the kinetic level while sliding (time stepping in the sense of Moreau):
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
    /// `friction_force` has the sign of `velocity` when sliding and the sign of `external_force` when stuck; body 1 feels
    /// `-friction_force`. Dissipated power is `friction_force * velocity`.
    ///
    /// # Step
    /// Without `mass` the law has no memory. With `mass` it remembers whether it is stuck and how long the last step was.
    /// A stuck body then neither chatters nor creeps, at any step size: what velocity remains is the one that a change
    /// of `external_force` within a step causes. For two bodies that both move, `mass` is m_1 m_2 / (m_1 + m_2).
    /// `exchange` tells how the master works. Sequential: set the inputs, step this model, read `friction_force`, step
    /// the host with it. Parallel: step both, then exchange all values, as most masters do; the force then acts one step
    /// later and is planned for that. The step may change from one to the next: a sequential exchange knows it, a
    /// parallel one plans for the longest of late. A force that is read between setting the inputs and the step, which
    /// FMI 2.0 does not allow but the C and Rust interfaces do, is that of a step as long as the last one.
    /// A force read before the first step is that of (5.1). With `mass` > 0 slopes of the inputs are not used, only
    /// their values at the end of the step.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`.
    ///
    /// # Limits
    /// No Stribeck effect, no pre-sliding displacement, no viscous part. Without `mass` a host that integrates the body
    /// itself never meets v = 0 exactly, so the force alternates: use `mass`, or a regularised or bristle law.
    /// `normal_force` = 0 releases the contact (force 0, not stuck). `mu_s` = `mu_k` is plain Coulomb friction.
    ///
    /// # Source
    /// Morin (1833); Rabinowicz (1951), doi:10.1063/1.1699869; equation (5.1) of F. Novais, "A critical analysis on
    /// friction force models in dynamical systems", MSc thesis, University of Minho (2024). Time stepping: Moreau (1988),
    /// doi:10.1007/978-3-7091-2624-0_1. The choice `exchange` is ours.
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
        /// Sliding velocity of body 1 relative to body 2.
        velocity: input = real("m/s", 0.0).shown_in("mm/s"),
        /// Normal force that presses the surfaces together.
        normal_force: input = real("N", 9.81).at_least(0.0),
        /// Resultant of all other tangential forces on body 1.
        external_force: input = real("N", 0.0),
        /// Kinetic coefficient of friction.
        mu_k: tunable = real("1", 0.1).at_least(0.0),
        /// Static coefficient of friction; not less than mu_k.
        mu_s: tunable = real("1", 0.15).at_least(0.0),
        /// Is the contact stuck since the last step? Used with mass > 0.
        stuck: state = boolean(false),
        /// What the law needs to hold a body in co-simulation.
        time_stepping: (TimeStepping),
        /// Energy taken out of the motion since the start.
        dissipated_energy: state_output = real("J", 0.0).nominal(1e-3),
        /// Friction force; has the sign of the velocity when sliding. Body 1 feels its negative.
        friction_force: output = real("N", 0.0),
        /// Power taken out of the motion: friction force times velocity.
        dissipated_power: output = real("W", 0.0),
        /// Is the contact sticking?
        sticking: output = boolean(false),
    }
}

impl<T: Real> CoulombStiction<T> {
    fn contact(&self) -> TwoLevels<T> {
        TwoLevels {
            velocity: self.velocity,
            external_force: self.external_force,
            kinetic: self.mu_k * self.normal_force,
            statical: self.mu_s * self.normal_force,
            band: T::zero(),
            stuck: self.stuck.value() != 0.0,
        }
    }
}

impl<T: Real> Law for CoulombStiction<T> {
    fn output(&mut self) {
        let contact = self.contact();
        self.friction_force = self.time_stepping.force(&contact);
        self.dissipated_power = self.friction_force * self.velocity;
        self.sticking = contact.sticking(&self.time_stepping);
    }

    fn derivatives(&self, rate: &mut Self) {
        rate.dissipated_energy = self.time_stepping.force(&self.contact()) * self.velocity;
    }
}

impl Model for CoulombStiction {
    const MODEL_EXCHANGE: bool = true;
    const EVENT_INDICATORS: usize = 2;

    fn check(&self) -> Result<(), Fault> {
        crate::friction::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    fn check_exchange(&self) -> Result<(), Fault> {
        self.time_stepping.check_exchange()
    }

    fn event_indicators(&self, indicators: &mut [f64]) {
        self.contact().write_indicators(indicators);
    }

    fn at_event(&mut self) {
        self.stuck = f64::from(u8::from(self.contact().is_caught()));
    }

    fn step(&mut self, dt: f64) {
        let contact = self.contact();
        let done = self.time_stepping.step(&contact, dt);
        self.dissipated_energy += done.energy;
        self.stuck = f64::from(u8::from(done.is_held));
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        time_stepping::step_ramp(self, self.time_stepping.mass, slope, dt);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn force(velocity: f64, external_force: f64) -> f64 {
        let mut law = CoulombStiction { velocity, external_force, ..Default::default() };
        law.output();
        law.friction_force
    }

    /// Eq. (5.1) by hand: f_C = 0.981 N, f_s = 1.4715 N.
    #[test]
    fn printed_law_at_rest_and_sliding() {
        assert!((force(1e-9, -3.0) - 0.981).abs() < 1e-12);
        assert!((force(-2.0, 3.0) + 0.981).abs() < 1e-12);
        assert_eq!(force(0.0, 0.7), 0.7);
        assert!((force(0.0, 9.0) - 1.4715).abs() < 1e-12);
        assert!((force(0.0, -9.0) + 1.4715).abs() < 1e-12);
    }

    #[test]
    fn no_load_releases_the_contact() {
        let mut law = CoulombStiction { normal_force: 0.0, external_force: 1.0, ..Default::default() };
        law.output();
        assert_eq!((law.friction_force, law.sticking), (0.0, 0.0));
    }
}
