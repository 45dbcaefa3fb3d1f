use crate::contact::conditions::ELASTIC_SHARE;
use crate::contact::quantities::*;
use crate::contact::unloading::released_without_load;
use crate::model::{Derivatives, Law, Meaning, Model, ModelExchange, Steps, change, in_lanes, real};
use crate::number::{Real, choose};

crate::model! {
    /// A law that is added to a copy to see that a law is its file and one line. It is Dahl's with alpha = 1, and calls its
    /// quantities as no other law does.
    ///
    /// # Equations
    ///
    /// ```text
    /// dz/dt = v - k_b |v| z / f_C
    /// f_f = k_b z
    /// f_C = c f_n
    /// ```
    ///
    /// | symbol | variable         | unit | meaning                               |
    /// |--------|------------------|------|---------------------------------------|
    /// | v      | `velocity`       | m/s  | velocity of body 1 relative to body 2 |
    /// | f_n    | `normal_force`   | N    | force pressing the surfaces together  |
    /// | c      | `coefficient`    | 1    | kinetic coefficient of friction       |
    /// | k_b    | `k_b`            | N/m  | stiffness of the contact at rest      |
    /// | z      | `yielding`       | m    | elastic deflection                    |
    /// | f_f    | `friction_force` | N    | friction force                        |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` in steady sliding; body 1 feels `-friction_force`. Dissipated power
    /// is `friction_force * velocity`; it is negative while the contact springs back.
    ///
    /// # Step
    /// Exact with held inputs: z decays exponentially with the displacement.
    ///
    #[doc = include_str!("slopes.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; in Model Exchange `coefficient` = 0.
    ///
    /// # Limits
    /// No stiction and no Stribeck effect. `normal_force` = 0 releases the contact (force 0, deflection 0).
    ///
    /// # Source
    /// Dahl (1968), "A solid friction model", TOR-0158(3107-18)-1, The Aerospace Corporation.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::SpringSlider;
    /// use stribeck::model::{Law, Model};
    /// let mut law = SpringSlider { velocity: 1e-4, ..Default::default() };
    /// law.step(0.15); // 15 um of sliding
    /// law.output();
    /// let by_hand = 0.981 * (1.0 - (-1e5 * 1.5e-5 / 0.981f64).exp());
    /// assert!((law.friction_force - by_hand).abs() < 1e-15);
    /// ```
    SpringSlider: "A law that is added to a copy" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        /// Kinetic coefficient of friction.
        coefficient: tunable = real("1", 0.1).at_least(0.0).means(Meaning::KineticLevel),
        /// Stiffness of the contact.
        k_b: tunable = real("N/m", 1e5).positive().nominal(1e5).means(Meaning::Stiffness),
        /// Elastic deflection of the contact.
        yielding: state = real("m", 0.0).nominal(1e-5).shown_in("um").odd().reinit().means(Meaning::Deflection),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> SpringSlider<T> {
    #[inline(always)]
    fn coulomb(&self) -> T {
        self.coefficient * self.normal_force
    }

    #[inline(always)]
    fn force(&self) -> T {
        choose!(self.normal_force.is_positive(), self.k_b * self.yielding, T::zero())
    }

    /// dz/dt / v.
    #[inline(always)]
    fn elastic_share(&self) -> T {
        T::from(1.0) - self.force() / self.coulomb() * self.velocity.sign()
    }
}

impl<T: Real> Law for SpringSlider<T> {
    type Interface = ModelExchange;

    #[inline(always)]
    fn output(&mut self) {
        self.friction_force = self.force();
        self.dissipated_power = self.friction_force * self.velocity;
        let elastic = self.velocity.vanishes() | self.elastic_share().above(T::from(ELASTIC_SHARE));
        self.sticking = T::truth(elastic & self.coulomb().is_positive());
    }
}

impl<T: Real> Derivatives for SpringSlider<T> {
    #[inline(always)]
    fn derivatives(&self, rate: &mut Self) {
        let is_loaded = self.coulomb().is_positive();
        rate.yielding = choose!(is_loaded, self.velocity * self.elastic_share(), T::zero());
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

impl<T: Real> SpringSlider<T> {
    #[inline(always)]
    fn slide(&mut self, dt: T) {
        let (coulomb, direction) = (self.coulomb(), self.velocity.sign());
        let distance = self.velocity.abs() * dt;
        let missing = coulomb - direction * self.force();
        let decay = self.k_b * distance / coulomb;
        let change = direction * missing * (T::zero() - decay).exp_m1() / self.k_b;
        self.yielding = self.yielding - change;
        // The integral of the force over the way: that of the level less that of what is missing, which decays.
        let lost = coulomb * distance + missing * coulomb / self.k_b * (T::zero() - decay).exp_m1();
        self.dissipated_energy = self.dissipated_energy + lost;
    }
}

impl<T: Real> Steps for SpringSlider<T> {
    #[inline(always)]
    fn advance(&mut self, dt: T) {
        let is_loaded = !self.coulomb().vanishes();
        change!(self, is_loaded, |law| law.slide(dt), |law| law.yielding = T::zero());
    }
}

in_lanes!(SpringSlider);

impl Model for SpringSlider {
    released_without_load!(yielding);

    fn check_model_exchange(&self) -> Result<(), crate::model::Fault> {
        crate::contact::conditions::kinetic_friction_for_exchange(self.coefficient)
    }

    in_lanes!();
}
