use crate::contact::conditions::ELASTIC_SHARE;
use crate::contact::quantities::*;
use crate::contact::unloading::released_without_load;
use crate::model::{Derivatives, Law, Meaning, Model, ModelExchange, Preset, Steps, change, in_lanes, real};
use crate::number::{Real, choose};
use crate::numerics::relaxation::{self, Relaxation};

crate::model! {
    /// Dankowicz friction, reconstructed: asperities yield by a given shear deflection before gross sliding; Dahl's law
    /// with a length instead of a stiffness, so that the force follows the load.
    ///
    /// # Equations
    ///
    /// ```text
    /// dz/dt = v (1 - (z / delta_t) sgn(v))
    /// f_f   = f_C z / delta_t
    /// f_C   = mu_k f_n
    /// ```
    ///
    /// | symbol  | variable             | unit | meaning                                         |
    /// |---------|----------------------|------|-------------------------------------------------|
    /// | v       | `velocity`           | m/s  | velocity of body 1 relative to body 2           |
    /// | f_n     | `normal_force`       | N    | force pressing the surfaces together            |
    /// | mu_k    | `mu_k`               | 1    | kinetic coefficient of friction                 |
    /// | delta_t | `delta_t`            | m    | shear deflection of the asperities when sliding |
    /// | z       | `bristle_deflection` | m    | shear deflection of the asperities              |
    /// | f_f     | `friction_force`     | N    | friction force                                  |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` in steady sliding; body 1 feels `-friction_force`. Dissipated power
    /// is `friction_force * velocity`; it is negative while the asperities spring back.
    ///
    /// # Step
    /// With held inputs the equation of $z$ is linear and solved exactly, so the result does not depend on how an
    /// interval is divided; the energy is its closed form. No events. `sticking` means that more than 1 % (chosen) of
    /// the motion is still elastic.
    ///
    /// A master that integrates a mass m with the force it reads couples it explicitly to the stiffness k of the
    /// contact at rest. If the friction steps first, a held body stays still for communication steps below 2 sqrt(m /
    /// k), which is 6.3 ms for the defaults and 1 kg; above, it chatters within the bounds of the force. If all models
    /// step at once and exchange afterwards, it chatters at every step, since nothing damps the stiffness: take the
    /// friction first, or Model Exchange.
    ///
    #[doc = include_str!("slopes.md")]
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// At constant load this is Dahl's law with $alpha = 1$ and $sigma_0 = f_C / delta_t$: no stiction, no Stribeck
    /// effect, drift under a load that cycles below $f_C$. The normal motion and the second time scale of the original
    /// paper are not part of it. `normal_force` = 0 releases the contact (force 0, deflection 0). Passive at constant
    /// load: from the start values `dissipated_energy` never becomes negative.
    ///
    /// # Source
    /// Reconstructed after the summary of Dankowicz (1999), "On the modeling of dynamic friction phenomena", ZAMM 79,
    /// 399-409, in Andersson, Soderberg and Bjorklund (2007), doi:10.1016/j.triboint.2005.11.014, where the law is one
    /// of friction as a function of displacement; the paper itself was not available. F. Novais, "A critical analysis
    /// on friction force models in dynamical systems", MSc thesis, University of Minho (2024), Table 7.1 has no value
    /// of its own for $delta_t$; the default is $f_C / sigma_0$ with the $sigma_0 = 1e5$ N/m that the table gives for
    /// all models.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Dankowicz;
    /// use stribeck::model::{Law, Model};
    /// let mut law = Dankowicz { velocity: 1e-4, ..Default::default() };
    /// law.step(0.0981); // one delta_t
    /// law.output();
    /// assert!((law.friction_force - 0.981 * (1.0 - (-1.0f64).exp())).abs() < 1e-15);
    /// ```
    Dankowicz: "Pre-sliding displacement of sheared asperities (Dankowicz, reconstructed)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        mu_k: tunable = MU_K,
        /// Shear deflection of the asperities in steady sliding (default f_C / sigma_0 of the thesis).
        delta_t: tunable = real("m", 9.81e-6).positive().nominal(1e-5).shown_in("um").means(Meaning::Own),
        bristle_deflection: state = BRISTLE_DEFLECTION.reinit(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Dankowicz<T> {
    /// f_C.
    #[inline(always)]
    fn coulomb(&self) -> T {
        self.mu_k * self.normal_force
    }

    #[inline(always)]
    fn force(&self) -> T {
        self.coulomb() * (self.bristle_deflection / self.delta_t)
    }

    /// dz/dt / v.
    #[inline(always)]
    fn elastic_share(&self) -> T {
        T::from(1.0) - self.bristle_deflection / self.delta_t * self.velocity.sign()
    }
}

impl<T: Real> Law for Dankowicz<T> {
    type Interface = ModelExchange;

    #[inline(always)]
    fn output(&mut self) {
        self.friction_force = self.force();
        self.dissipated_power = self.friction_force * self.velocity;
        let elastic = self.velocity.vanishes() | self.elastic_share().above(T::from(ELASTIC_SHARE));
        self.sticking = T::truth(elastic & self.coulomb().is_positive());
    }

    #[inline(always)]
    fn slide_steadily(&mut self) {
        let kept = choose!(self.velocity.vanishes(), self.bristle_deflection, self.velocity.sign() * self.delta_t);
        self.bristle_deflection = choose!(self.normal_force.is_positive(), kept, T::zero());
    }
}

impl<T: Real> Derivatives for Dankowicz<T> {
    #[inline(always)]
    fn derivatives(&self, rate: &mut Self) {
        let is_loaded = self.normal_force.is_positive();
        rate.bristle_deflection = choose!(is_loaded, self.velocity * self.elastic_share(), T::zero());
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

impl<T: Real> Dankowicz<T> {
    #[inline(always)]
    fn decay(&self, distance: T) -> T {
        distance / self.delta_t
    }

    #[inline(always)]
    fn slide(&mut self, dt: T) {
        let direction = self.velocity.sign();
        let distance = self.velocity.abs() * dt;
        let before = self.bristle_deflection;
        self.bristle_deflection = relaxation::after(before, direction * self.delta_t, self.decay(distance));
        // The integral of z over the distance: dz = ds - (z / delta_t) ds, forwards.
        let work = self.coulomb() * (distance - direction * (self.bristle_deflection - before));
        self.dissipated_energy = self.dissipated_energy + work;
    }
}

impl<T: Real> Steps for Dankowicz<T> {
    #[inline(always)]
    fn advance(&mut self, dt: T) {
        let is_loaded = self.normal_force.is_positive();
        change!(self, is_loaded, |law| law.slide(dt), |law| law.bristle_deflection = T::zero());
    }

    #[inline(always)]
    fn relaxation(&self, dt: T) -> Option<Relaxation<T>> {
        let (steady, decay) = (self.velocity.sign() * self.delta_t, self.decay(self.velocity.abs() * dt));
        Some(Relaxation::of(steady, decay, self.normal_force.is_positive()))
    }
}

in_lanes!(Dankowicz, relaxes bristle_deflection);

impl Model for Dankowicz {
    const STEADY_SLIDING: bool = true;
    const PRESETS: &'static [Preset] = &[Preset {
        name: "thesis",
        source: "Novais (2024), Tables 6.1 and 7.1; delta_t = f_C / sigma_0 is derived (the start values)",
        values: &[],
    }];

    released_without_load!(bristle_deflection);

    in_lanes!();
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::friction::Dahl;

    /// At constant load the two laws agree, on any path.
    #[test]
    fn is_dahl_with_the_stiffness_of_the_asperities() {
        let mut law = Dankowicz { delta_t: 2e-5, mu_k: 0.3, ..Default::default() };
        let mut dahl = Dahl { mu_k: 0.3, sigma_0: 0.3 * 9.81 / 2e-5, ..Default::default() };
        for velocity in [1e-3, -2e-3, 5e-4, 3e-2, -1e-5, 0.0, -4.0] {
            (law.velocity, dahl.velocity) = (velocity, velocity);
            law.step(3e-3);
            dahl.step(3e-3);
            law.output();
            dahl.output();
            assert_abs_diff_eq!(law.friction_force, dahl.friction_force, epsilon = 1e-14);
            assert_abs_diff_eq!(law.dissipated_energy / dahl.dissipated_energy, 1.0, epsilon = 1e-12);
            assert_eq!(law.sticking, dahl.sticking);
        }
    }

    /// The difference from Dahl's law: the force follows the load at rest.
    #[test]
    fn force_follows_the_load() {
        let mut law = Dankowicz { velocity: 1e-3, ..Default::default() };
        law.step(1.0);
        (law.velocity, law.normal_force) = (0.0, 2.0);
        law.output();
        assert_abs_diff_eq!(law.friction_force, 0.2, epsilon = 1e-15);
    }
}
