use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::laws::{stribeck, viscous};
use crate::model::{Fault, Meaning, Model, real};
use crate::number::{Real, choose};

crate::choices! {
    /// Shape of the Stribeck curve.
    pub enum StribeckCurve {
        /// Exponential of speed.
        Tustin,
        /// Exponential of a power of speed, with stribeck_exponent.
        BoPavelescu,
        /// Lorentzian; half of the excess is left at stribeck_velocity.
        HessSoom,
        /// Hyperbola; half of the excess is left at stribeck_velocity. A quadratic part may be added.
        PoppStelter,
        /// Exponential of the square of speed.
        Gaussian,
    }
}

crate::model! {
    /// Stribeck friction: sliding friction that falls with speed from the static to the kinetic level, in five forms
    /// from the literature, and a contact that holds at rest.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = (S(v) + f_v |v|) sgn(v)        v != 0
    /// f_f = min(|f_e|, f_s) sgn(f_e)       v  = 0
    ///
    /// Tustin:       S = f_C + (f_s - f_C) exp(-|v| / v_S)                      (5.5)
    /// BoPavelescu:  S = f_C + (f_s - f_C) exp(-(|v| / v_S)^delta)              (5.6)
    /// HessSoom:     S = f_C + (f_s - f_C) / (1 + (v / v_S)^2)                  (5.7)
    /// PoppStelter:  S = f_C + (f_s - f_C) / (1 + |v| / v_S) + eta v^2          (5.8)
    /// Gaussian:     S = f_C + (f_s - f_C) exp(-(v / v_S)^2)
    /// f_C = mu_k f_n,   f_s = mu_s f_n
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
    /// | symbol | variable                | unit    | meaning                                         |
    /// |--------|-------------------------|---------|-------------------------------------------------|
    /// | v      | `velocity`              | m/s     | velocity of body 1 relative to body 2           |
    /// | f_n    | `normal_force`          | N       | force pressing the surfaces together            |
    /// | f_e    | `external_force`        | N       | all other tangential forces on body 1           |
    /// |        | `curve`                 |         | which of the five forms                         |
    /// | mu_k   | `mu_k`                  | 1       | kinetic coefficient of friction                 |
    /// | mu_s   | `mu_s`                  | 1       | static coefficient of friction                  |
    /// | v_S    | `stribeck_velocity`     | m/s     | Stribeck velocity                               |
    /// | delta  | `stribeck_exponent`     | 1       | exponent of BoPavelescu                         |
    /// | f_v    | `viscous_coefficient`   | N.s/m   | viscous coefficient                             |
    /// | eta    | `quadratic_coefficient` | N.s2/m2 | quadratic coefficient of PoppStelter            |
    /// | m      | `mass`                  | kg      | effective mass of the host, 0 = the printed law |
    /// | h      | `step_size`             | s       | last communication step                         |
    /// | f_f    | `friction_force`        | N       | friction force                                  |
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
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`.
    ///
    /// # Limits
    /// At $v_S$ the remaining part of the excess $f_s - f_C$ is 1/e (Tustin, BoPavelescu, Gaussian) or one half
    /// (HessSoom, PoppStelter). No pre-sliding displacement. The falling branch takes a driven body through stick-slip;
    /// with `mass` a step longer than about $m v_S / (f_s - f_C)$ crosses it in one go. `mu_s` = `mu_k` is Coulomb
    /// friction, with viscous part. `normal_force` = 0 releases the contact: force 0, also of the viscous part.
    /// `sticking` means that the step ends at rest or, without `mass`, that $v = 0$ and $|f_e|$ is within the level.
    ///
    /// # Source
    /// Tustin (1947), Journal of the IEE 94 (IIA), 143-151; Bo and Pavelescu (1982), doi:10.1016/0043-1648(82)90274-8;
    /// Hess and Soom (1990), Journal of Tribology 112, 147-152; Popp and Stelter (1990), Philosophical Transactions A
    /// 332, 89-105; Gaussian: Armstrong-Helouvry (1991), Control of Machines with Friction; equations (5.4) to (5.8) of
    /// F. Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis, University of Minho
    /// (2024). Differs from the thesis: the sign of $v$ is missing there; (5.5) has 1 - exp(..), which would rise with
    /// speed; the constant of (5.8) has the subscript s, which would give $2 f_s - f_C$ at rest. Bo and Pavelescu write
    /// $exp(-a |v|^delta)$, here $a = v_S^-delta$; Popp and Stelter write $1 + d |v|$, here $d = 1 / v_S$. $f_v$ is
    /// available for every form. $v_S = 0.001$ m/s and $delta = 2$ are chosen. Time stepping: Moreau (1988),
    /// doi:10.1007/978-3-7091-2624-0_1. The choice `exchange` is our addition.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Stribeck;
    /// use stribeck::model::Law;
    /// let mut law = Stribeck { velocity: 0.001, ..Default::default() }; // the Stribeck velocity
    /// law.output();
    /// assert!((law.friction_force - (0.981 + 0.4905 * (-1.0f64).exp())).abs() < 1e-15);
    /// ```
    Stribeck: "Friction that falls with speed from the static to the kinetic level (Stribeck)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        /// How the level falls with speed.
        curve: fixed = StribeckCurve::Gaussian.start(),
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        stribeck_velocity: tunable = STRIBECK_VELOCITY
            .help("Speed at which 1/e of the excess is left; one half with HessSoom and PoppStelter."),
        stribeck_exponent: tunable = STRIBECK_EXPONENT,
        viscous_coefficient: tunable = VISCOUS_COEFFICIENT,
        /// Quadratic friction coefficient; used by PoppStelter.
        quadratic_coefficient: tunable = real("N.s2/m2", 0.0).at_least(0.0).means(Meaning::GrowsWithSpeed),
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Stribeck<T> {
    /// S(v), eqs. (5.5) to (5.8).
    #[inline(always)]
    fn falling_level(&self, velocity: T) -> T {
        let coulomb = self.mu_k * self.normal_force;
        let [breakaway, v_s] = [self.level(), self.stribeck_velocity];
        let exponential = |exponent| stribeck::level(velocity, coulomb, breakaway, v_s, exponent);
        let hyperbolic = || {
            let quadratic = viscous::force(velocity * velocity, self.quadratic_coefficient, self.normal_force);
            stribeck::hyperbolic(velocity, coulomb, breakaway, v_s) + quadratic
        };
        let lorentzian = || stribeck::lorentzian(velocity, coulomb, breakaway, v_s);
        let is = |curve: StribeckCurve| curve.is(self.curve);
        let is_rational = is(StribeckCurve::HessSoom) | is(StribeckCurve::PoppStelter);
        let exponent = || {
            choose!(
                is(StribeckCurve::Gaussian),
                T::from(2.0),
                choose!(is(StribeckCurve::Tustin), T::from(1.0), self.stribeck_exponent)
            )
        };
        choose!(is_rational, choose!(is(StribeckCurve::HessSoom), lorentzian(), hyperbolic()), exponential(exponent()))
    }
}

impl<T: Real> Curve<T> for Stribeck<T> {
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        let viscous = viscous::force(velocity, self.viscous_coefficient, self.normal_force);
        self.falling_level(velocity) * velocity.sign() + viscous
    }

    #[inline(always)]
    fn level(&self) -> T {
        self.mu_s * self.normal_force
    }

    #[inline(always)]
    fn band(&self) -> Option<T> {
        None
    }
}

memoryless!(Stribeck);

impl Model for Stribeck {
    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    memoryless!();
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    const CURVES: [StribeckCurve; 5] = [
        StribeckCurve::Tustin,
        StribeckCurve::BoPavelescu,
        StribeckCurve::HessSoom,
        StribeckCurve::PoppStelter,
        StribeckCurve::Gaussian,
    ];

    fn law(curve: StribeckCurve, velocity: f64) -> Stribeck {
        Stribeck { curve: curve.number(), velocity, ..Default::default() }
    }

    fn force(law: Stribeck) -> f64 {
        law.curve(law.velocity)
    }

    #[test]
    fn every_form_falls_from_the_static_to_the_kinetic_level() {
        for curve in CURVES {
            assert!((force(law(curve, 1e-12)) - 1.4715).abs() < 1e-8, "{curve:?}");
            assert!((force(law(curve, -1e3)) + 0.981).abs() < 1e-5, "{curve:?}");
            let forces = (1..2000).map(|k| force(law(curve, 5e-6 * f64::from(k)))).collect::<Vec<_>>();
            assert!(forces.windows(2).all(|w| w[1] <= w[0]), "{curve:?}");
        }
    }

    /// Speeds at which half of the excess is left: v_S ln 2, v_S sqrt(ln 2), v_S, v_S.
    #[test]
    fn half_way_points() {
        let ln_2 = std::f64::consts::LN_2;
        let points = [ln_2, ln_2.sqrt(), 1.0, 1.0, ln_2.sqrt()];
        for (curve, u) in CURVES.into_iter().zip(points) {
            assert!((force(law(curve, 1e-3 * u)) - 1.22625).abs() < 1e-15, "{curve:?}");
        }
    }

    #[test]
    fn equal_levels_are_coulomb_friction() {
        for curve in CURVES {
            assert_abs_diff_eq!(force(Stribeck { mu_s: 0.1, ..law(curve, -3e-4) }), -0.981, epsilon = 1e-15);
        }
    }

    /// Popp and Stelter's own example for a load of 1 N: (0.4 - 0.1) / (1 + 10 v) + 0.1 + 0.01 v^2.
    #[test]
    fn example_of_popp_and_stelter() {
        for v in [0.01, 0.5, 3.0] {
            let example = Stribeck {
                normal_force: 1.0,
                mu_s: 0.4,
                stribeck_velocity: 0.1,
                quadratic_coefficient: 0.01,
                ..law(StribeckCurve::PoppStelter, v)
            };
            let expected = (0.4 - 0.1) / (1.0 + 10.0 * v) + 0.1 + 0.01 * v * v;
            assert_abs_diff_eq!(force(example), expected, epsilon = 1e-15);
        }
    }
}
