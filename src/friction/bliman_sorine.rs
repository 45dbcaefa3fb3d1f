use crate::contact::conditions::ELASTIC_SHARE;
use crate::contact::quantities::*;
use crate::contact::unloading::released_without_load;
use crate::model::{Derivatives, Law, Meaning, Model, ModelExchange, Preset, Steps, change, in_lanes, real};
use crate::number::{Real, choose};
use crate::numerics::relaxation;

crate::choices! {
    /// Order of the law of Bliman and Sorine.
    pub enum BlimanSorineOrder {
        /// One relaxation: Coulomb friction with pre-sliding displacement.
        First,
        /// Two relaxations: a peak of the force before steady sliding.
        Second,
    }
}

crate::model! {
    /// Bliman-Sorine friction: the force is a linear filter of the direction of motion, in the sliding distance instead
    /// of in time; the second order adds a peak at breakaway to the pre-sliding displacement of the first.
    ///
    /// # Equations
    ///
    /// ```text
    /// s       = integral of |v| dt                                                   (7.12)
    /// dx_s/ds = A x_s + B sgn(v)                                                     (7.13)
    /// f_f     = C x_s
    ///
    /// First:   A = -1 / eps_f,   B = f_1 / eps_f,   C = 1,   f_1 = f_C               (7.14)
    /// Second:  A = -1 / eps_f [1 / eta, 0; 0, 1],   B = 1 / eps_f [f_1 / eta; -f_2],   C = [1, 1]
    ///
    /// f_C = f_1 - f_2 = mu_k f_n,   f_2 = mu_2 f_n
    /// ```
    ///
    /// The states are kept in units of their own level, $x_1 = f_1 y_1$ and $x_2 = -f_2 y_2$ with $|y| <= 1$, so that
    /// the force follows the load:
    ///
    /// ```text
    /// dy_1/dt = (v - |v| y_1) / (eta eps_f),   dy_2/dt = (v - |v| y_2) / eps_f
    /// f_f     = f_C y_1 + f_2 (y_1 - y_2)
    /// ```
    ///
    /// First order is this with $f_2 = 0$ and $eta = 1$.
    ///
    /// | symbol | variable         | unit | meaning                                        |
    /// |--------|------------------|------|------------------------------------------------|
    /// | v      | `velocity`       | m/s  | velocity of body 1 relative to body 2          |
    /// | f_n    | `normal_force`   | N    | force pressing the surfaces together           |
    /// | -      | `variant`        |      | first or second order                          |
    /// | mu_k   | `mu_k`           | 1    | kinetic coefficient of friction                |
    /// | mu_2   | `mu_2`           | 1    | level of the slow relaxation; second order     |
    /// | eta    | `eta`            | 1    | ratio of the two lengths; second order         |
    /// | eps_f  | `eps_f`          | m    | length in which the slow relaxation settles    |
    /// | y_1    | `y_1`            | 1    | fast relaxation                                |
    /// | y_2    | `y_2`            | 1    | slow relaxation                                |
    /// | f_f    | `friction_force` | N    | friction force                                 |
    ///
    /// From rest the second order has, with $f_1 = (mu_k + mu_2) f_n$,
    ///
    /// ```text
    /// initial stiffness:  (f_1 / eta - f_2) / eps_f
    /// peak at:            s_p    = eta eps_f / (1 - eta) ln(f_1 / (eta f_2))
    /// peak force:         f_peak = f_1 - f_2 + (1 - eta) f_2 (eta f_2 / f_1)^(eta / (1 - eta))
    /// ```
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` in steady sliding; body 1 feels `-friction_force`. Dissipated power
    /// is `friction_force * velocity`; it is negative while the contact springs back.
    ///
    /// # Step
    /// The force depends on the sliding distance only. With held inputs each relaxation is solved exactly, so the
    /// result does not depend on how an interval is divided; the energy is its closed form. No events. `sticking` means
    /// that more than 1 % (chosen) of the fast relaxation is still to come, or that there is no motion.
    ///
    /// A master that integrates a mass m with the force it reads couples it explicitly to the stiffness k of the
    /// contact at rest. If the friction steps first, a held body stays still for communication steps below 2 sqrt(m /
    /// k), which is 6.3 ms for the defaults and 1 kg; above, it chatters within the bounds of the force. If all models
    /// step at once and exchange afterwards, it chatters at every step, because the stiffness is undamped: step the
    /// friction first, or Model Exchange.
    ///
    #[doc = include_str!("slopes.md")]
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// No dependence on the speed. A reversal out of steady sliding doubles the change of the force, so the peak of the
    /// second order is then $2 f_peak - f_C$ (1.962 N for the defaults), which no path exceeds. The peak of the second
    /// order needs a fresh path of a few $eps_f$: a contact that is caught again after slipping has no stiction peak,
    /// so the belt benchmark shows one stick-slip cycle only. Drifts under a load that cycles below the peak.
    ///
    /// Passive at constant load, for both orders: from the start values `dissipated_energy` never becomes negative,
    /// because Re $C (j w - A)^-1 B = f_1 / (1 + (eta eps_f w)^2) - f_2 / (1 + (eps_f w)^2) > 0$ for $eta <= 1$ and
    /// $f_1 > f_2$. `normal_force` = 0 releases the contact (force 0, $y_1 = y_2 = 0$). `mu_2` = 0 is the first order
    /// with the length $eta eps_f$, and so is `eta` = 1 with the length $eps_f$.
    ///
    /// # Source
    /// Bliman and Sorine (1995), "Easy-to-use realistic dry friction models for automatic control", European Control
    /// Conference; equations (7.12) to (7.14) of F. Novais, "A critical analysis on friction force models in dynamical
    /// systems", MSc thesis, University of Minho (2024); second order as in Olsson et al. (1998),
    /// doi:10.1016/S0947-3580(98)70113-X. In (7.13) $f_f$ also has a term $D sgn(v)$; $D$ is 0 in both orders. The
    /// levels are given as coefficients, and the states in units of their level: both are our choice, and make no
    /// difference at constant load. The defaults are calibrated to $f_C = 0.981$ N, $f_peak = 1.4715$ N and the initial
    /// stiffness 1e5 N/m of Table 7.1 at $eta = 0.5$: $mu_2 = 0.1 + sqrt(0.03)$, $eps_f = (3 + sqrt(3)) f_C / sigma_0$.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::BlimanSorine;
    /// use stribeck::model::{Law, Model};
    /// let mut law = BlimanSorine { velocity: 4.665596e-5, ..Default::default() };
    /// law.step(1.0); // to the peak
    /// law.output();
    /// assert!((law.friction_force - 0.15 * 9.81).abs() < 1e-8);
    /// ```
    BlimanSorine: "Pre-sliding displacement and breakaway peak in the sliding distance (Bliman-Sorine)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        /// Variant of the law.
        variant: fixed = BlimanSorineOrder::Second.start().means(Meaning::Variant),
        mu_k: tunable = MU_K,
        /// Level of the slow relaxation, as a coefficient of friction; second order (default calibrated).
        mu_2: tunable = real("1", 0.273_205_080_756_887_7).at_least(0.0).means(Meaning::Level),
        /// Length of the fast relaxation as a part of that of the slow one; second order (default chosen).
        eta: tunable = real("1", 0.5).positive().at_most(1.0).means(Meaning::Shape),
        /// Sliding distance in which the slow relaxation settles to 1/e (default calibrated).
        eps_f: tunable = real("m", 4.642_141_842_225_068e-5).positive().nominal(1e-5).shown_in("um").means(Meaning::Own),
        /// Fast relaxation, in units of its level.
        y_1: state = real("1", 0.0).reinit().odd(),
        /// Slow relaxation, in units of its level; second order.
        y_2: state = real("1", 0.0).reinit().odd(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> BlimanSorine<T> {
    #[inline(always)]
    fn is_second_order(&self) -> T::Mask {
        BlimanSorineOrder::Second.is(self.variant)
    }

    /// f_C = f_1 - f_2.
    #[inline(always)]
    fn coulomb(&self) -> T {
        self.mu_k * self.normal_force
    }

    /// f_2.
    #[inline(always)]
    fn slow_level(&self) -> T {
        choose!(self.is_second_order(), self.mu_2 * self.normal_force, T::zero())
    }

    /// eta eps_f.
    #[inline(always)]
    fn fast_length(&self) -> T {
        choose!(self.is_second_order(), self.eta * self.eps_f, self.eps_f)
    }

    /// C x_s, written so that steady sliding gives f_C without a rounding error of the larger f_1 and f_2.
    #[inline(always)]
    fn force(&self) -> T {
        self.coulomb() * self.y_1 + self.slow_level() * (self.y_1 - self.y_2)
    }
}

impl<T: Real> Law for BlimanSorine<T> {
    type Interface = ModelExchange;

    #[inline(always)]
    fn output(&mut self) {
        self.friction_force = self.force();
        self.dissipated_power = self.friction_force * self.velocity;
        let missing = T::from(1.0) - self.y_1 * self.velocity.sign();
        let elastic = self.velocity.vanishes() | missing.above(T::from(ELASTIC_SHARE));
        self.sticking = T::truth(elastic & self.coulomb().is_positive());
    }

    #[inline(always)]
    fn slide_steadily(&mut self) {
        let (rests, direction) = (self.velocity.vanishes(), self.velocity.sign());
        let (y_1, y_2) = (choose!(rests, self.y_1, direction), choose!(rests, self.y_2, direction));
        let is_loaded = self.normal_force.is_positive();
        self.y_1 = choose!(is_loaded, y_1, T::zero());
        self.y_2 = choose!(is_loaded & self.is_second_order(), y_2, T::zero());
    }
}

impl<T: Real> Derivatives for BlimanSorine<T> {
    #[inline(always)]
    fn derivatives(&self, rate: &mut Self) {
        let is_loaded = self.normal_force.is_positive();
        let approach = |y, length| (self.velocity - self.velocity.abs() * y) / length;
        rate.y_1 = choose!(is_loaded, approach(self.y_1, self.fast_length()), T::zero());
        let moves = is_loaded & self.is_second_order();
        rate.y_2 = choose!(moves, approach(self.y_2, self.eps_f), T::zero());
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

impl<T: Real> BlimanSorine<T> {
    #[inline(always)]
    fn slide(&mut self, dt: T) {
        let direction = self.velocity.sign();
        let distance = self.velocity.abs() * dt;
        let (fast, slow) = (self.fast_length(), self.eps_f);
        let before = (self.y_1, self.y_2);
        self.y_1 = relaxation::after(self.y_1, direction, distance / fast);
        self.y_2 = choose!(self.is_second_order(), relaxation::after(self.y_2, direction, distance / slow), T::zero());
        // The integral of each y over the distance: dy/ds = (1 - y) / length gives y ds = ds - length dy.
        let fast_path = distance - fast * direction * (self.y_1 - before.0);
        let slow_path = distance - slow * direction * (self.y_2 - before.1);
        let work = self.coulomb() * fast_path + self.slow_level() * (fast_path - slow_path);
        self.dissipated_energy = self.dissipated_energy + work;
    }
}

impl<T: Real> Steps for BlimanSorine<T> {
    #[inline(always)]
    fn advance(&mut self, dt: T) {
        let is_loaded = self.normal_force.is_positive();
        change!(self, is_loaded, |law| law.slide(dt), |law| (law.y_1, law.y_2) = (T::zero(), T::zero()));
    }
}

in_lanes!(BlimanSorine);

impl Model for BlimanSorine {
    const LINEAR: bool = true;
    const STEADY_SLIDING: bool = true;
    const PRESETS: &'static [Preset] = &[
        Preset {
            name: "thesis",
            source: "Novais (2024), (7.14), Tables 6.1 and 7.1: first order; eps_f = f_C / sigma_0 is derived",
            values: &[("variant", 1.0), ("eps_f", 9.81e-6)],
        },
        Preset {
            name: "sharp_peak",
            source: "Example: second order with eta = 0.1, the same peak of 1.4715 N and stiffness of 1e5 N/m",
            values: &[("eta", 0.1), ("mu_2", 0.078_603_851_671_501_77), ("eps_f", 1.674_993_406_407_689e-4)],
        },
    ];

    released_without_load!(y_1, y_2);

    in_lanes!();
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn slide(law: BlimanSorine, distance: f64) -> BlimanSorine {
        let mut law = BlimanSorine { velocity: distance, ..law };
        law.step(1.0);
        law.output();
        law
    }

    /// The energy against Simpson's rule over the force, on a path with reversals.
    #[test]
    fn energy_is_the_integral_of_force_over_distance() {
        for variant in [1.0, 2.0] {
            let mut law = BlimanSorine { variant, ..Default::default() };
            let mut integral = 0.0;
            for leg in [3e-5, -7e-5, 1e-4, -2e-5] {
                let n = 2000;
                let force = |k: usize| slide(law, leg * k as f64 / n as f64).friction_force;
                let sum: f64 = (1..n).map(|k| force(k) * if k % 2 == 1 { 4.0 } else { 2.0 }).sum();
                integral += (force(0) + sum + force(n)) * leg / n as f64 / 3.0;
                law = slide(law, leg);
            }
            assert!((law.dissipated_energy / integral - 1.0).abs() < 1e-10, "{variant}: {}", law.dissipated_energy);
        }
    }

    /// The limits of the second order: f_2 = 0 leaves the fast relaxation, eta = 1 one relaxation of level f_1 - f_2.
    #[test]
    fn second_order_reduces_to_first_order() {
        let second = BlimanSorine { eps_f: 2e-5, ..Default::default() };
        let first = BlimanSorine { variant: 1.0, ..second };
        let pairs = [
            (BlimanSorine { mu_2: 0.0, ..second }, BlimanSorine { eps_f: 1e-5, ..first }),
            (BlimanSorine { eta: 1.0, ..second }, first),
        ];
        for (mut second, mut first) in pairs {
            for leg in [1e-6, 2e-5, -1e-5, -4e-5, 3e-6] {
                (second, first) = (slide(second, leg), slide(first, leg));
                assert_abs_diff_eq!(second.friction_force, first.friction_force, epsilon = 1e-15);
                assert_abs_diff_eq!(second.dissipated_energy, first.dissipated_energy, epsilon = 1e-18);
            }
        }
    }

    /// The state of the other variant has no effect.
    #[test]
    fn first_order_has_one_state() {
        let law = slide(BlimanSorine { variant: 1.0, y_2: 0.7, ..Default::default() }, 1.0);
        assert_eq!((law.y_2, law.friction_force), (0.0, 0.1 * 9.81));
    }
}
