use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::model::{Meaning, Model, Preset};
use crate::number::{Real, choose};

crate::choices! {
    /// Variants of the law.
    pub enum RooneyDeraviVariant {
        /// Hyperbolic tangent inside the band, as printed in the thesis; jumps at the end of the band.
        Printed,
        /// Straight line inside the band.
        Linear,
        /// Hyperbolic tangent for all velocities.
        Tanh,
    }
}

crate::model! {
    /// Rooney-Deravi friction: Coulomb friction with a transition band, in the form printed in the thesis and in two
    /// continuous forms.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = f_C max(min(v / v_0, 1), -1)     Linear
    /// f_f = f_C tanh(v / v_0)                Tanh, and Printed for |v| < v_0     (6.5)
    /// f_f = f_C sgn(v)                       Printed for |v| >= v_0
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
    /// |        | `variant`             |      | which of the three forms                        |
    /// | v_0    | `transition_velocity` | m/s  | velocity at which the band ends                 |
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
    /// $f'(0) = f_C / v_0$ (981 N.s/m for the defaults: 2.0 ms for 1 kg); above, a held body chatters. With `mass`
    /// the step is not limited. `sticking` means $|v| < v_0$.
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// No stiction: friction never exceeds $f_C$. Cannot hold a load: a stuck body creeps with $|v| < v_0$ (Tanh: with
    /// a load below $0.76 f_C$). Printed jumps at $v_0$ from $0.7616 f_C$ to $f_C$: a load in between makes a host
    /// chatter at $|v| = v_0$ without `mass`; with it the body rides the jump. Linear is Bernard friction with
    /// $k_l = 1 / v_0$. `normal_force` = 0 gives force 0.
    ///
    /// # Source
    /// Rooney and Deravi (1982), Mechanism and Machine Theory 17, 207-211; equation (6.5) of F. Novais, "A critical
    /// analysis on friction force models in dynamical systems", MSc thesis, University of Minho (2024), default of
    /// Table 6.2. Differs from the thesis: the second branch lacks the sign of $v$ there. Linear is the form that the
    /// literature on joints with clearance uses under this name (the paper itself was not seen) and the default,
    /// because (6.5) jumps; Tanh is (6.5) without its second branch.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::RooneyDeravi;
    /// use stribeck::model::Law;
    /// let mut law = RooneyDeravi { velocity: 0.000_2, ..Default::default() };
    /// law.output();
    /// assert!((law.friction_force - 0.2 * 0.981).abs() < 1e-15); // v / v_0 = 0.2
    /// ```
    RooneyDeravi: "Coulomb friction with a transition band (Rooney and Deravi)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        /// Variant of the law.
        variant: fixed = RooneyDeraviVariant::Linear.start().means(Meaning::Variant),
        transition_velocity: tunable = TRANSITION_VELOCITY,
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Curve<T> for RooneyDeravi<T> {
    /// Eq. (6.5).
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        let u = velocity / self.transition_velocity;
        let is_fast = velocity.abs().at_least(self.transition_velocity);
        let is_cut = RooneyDeraviVariant::Printed.is(self.variant) & is_fast;
        self.level()
            * choose!(
                RooneyDeraviVariant::Linear.is(self.variant),
                u.limited(T::from(1.0)),
                choose!(is_cut, velocity.sign(), u.tanh())
            )
    }

    #[inline(always)]
    fn level(&self) -> T {
        self.mu_k * self.normal_force
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

memoryless!(RooneyDeravi);

impl Model for RooneyDeravi {
    const PIECEWISE_LINEAR: bool = true;
    const PRESETS: &'static [Preset] = &[Preset {
        name: "thesis",
        source: "Novais (2024), Tables 6.1 and 6.2 (the start values), in the form of (6.5)",
        values: &[("variant", 1.0)],
    }];

    memoryless!();
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn force(law: RooneyDeravi) -> f64 {
        law.curve(law.velocity)
    }

    fn law(variant: RooneyDeraviVariant, velocity: f64) -> RooneyDeravi {
        RooneyDeravi { variant: variant.number(), velocity, ..Default::default() }
    }

    /// tanh 1 = 0.761594: the printed form jumps by 0.238406 f_C, the others do not.
    #[test]
    fn jump_of_the_printed_form() {
        use RooneyDeraviVariant::{Linear, Printed, Tanh};
        for (variant, jump) in [(Printed, 0.238_406), (Linear, 0.0), (Tanh, 0.0)] {
            let found = force(law(variant, 0.001)) - force(law(variant, 0.001f64.next_down()));
            assert!((found / 0.981 - jump).abs() < 1e-6, "{variant:?}: {found}");
            let mirrored = force(law(variant, -0.001)) - force(law(variant, -0.001f64.next_down()));
            assert!((mirrored + found).abs() < 1e-15);
        }
    }

    /// A load of 0.9 f_C lies within the jump: with mass the body rides it at v_0, and the force is the load.
    #[test]
    fn a_body_with_mass_rides_the_jump() {
        let mut body = RooneyDeravi { external_force: 0.9 * 0.981, ..law(RooneyDeraviVariant::Printed, 0.0) };
        body.time_stepping.mass = 1.0;
        for _ in 0..100 {
            body.step(1e-2);
            crate::model::Law::output(&mut body);
            body.velocity += 1e-2 * (body.external_force - body.friction_force);
        }
        assert!((body.velocity - 0.001).abs() < 1e-16, "{}", body.velocity);
        assert_abs_diff_eq!(body.friction_force, body.external_force, epsilon = 1e-15);
    }

    /// Pulled back, a body turns within one step and rides the jump on the other side of rest.
    #[test]
    fn a_body_that_turns_meets_the_jump_of_the_other_side() {
        let law = law(RooneyDeraviVariant::Printed, 0.0);
        let mut body = RooneyDeravi { velocity: 5e-4, external_force: -0.9 * 0.981, ..law };
        body.time_stepping.mass = 1.0;
        body.step(1.0);
        crate::model::Law::output(&mut body);
        let velocity = body.velocity + body.external_force - body.friction_force;
        assert!((velocity + 0.001).abs() < 1e-15, "{velocity}");
    }
}
