use crate::contact::conditions::ELASTIC_SHARE;
use crate::contact::motion::Motion;
use crate::contact::quantities::*;
use crate::contact::unloading::released_without_load;
use crate::model::{
    Derivatives, Fault, Law, Meaning, Model, ModelExchange, Preset, Steps, change, in_lanes, ramp, real,
};
use crate::number::{Mask, Real, choose};

crate::model! {
    /// Dahl friction: a contact yields like a spring before it slides, and the force follows the displacement with
    /// hysteresis; the simplest law with pre-sliding displacement.
    ///
    /// # Equations
    ///
    /// ```text
    /// df_f/dt = sigma_0 |1 - (f_f / f_C) sgn v|^alpha sgn(1 - (f_f / f_C) sgn v) v     (7.2)
    /// f_f = sigma_0 z
    /// f_C = mu_k f_n
    /// ```
    ///
    /// The first line is (7.1), which has $df_f/dx$, times $v$. For $alpha = 1$ it is $dz/dt = v - sigma_0 |v| z / f_C$
    /// (7.5).
    ///
    /// | symbol  | variable             | unit | meaning                                               |
    /// |---------|----------------------|------|-------------------------------------------------------|
    /// | v       | `velocity`           | m/s  | velocity of body 1 relative to body 2                 |
    /// | f_n     | `normal_force`       | N    | force pressing the surfaces together                  |
    /// | mu_k    | `mu_k`               | 1    | kinetic coefficient of friction                       |
    /// | sigma_0 | `sigma_0`            | N/m  | stiffness of the contact at rest                      |
    /// | alpha   | `alpha`              | 1    | shape of the transition; < 1 brittle, >= 1 ductile    |
    /// | z       | `bristle_deflection` | m    | elastic deflection                                    |
    /// | f_f     | `friction_force`     | N    | friction force                                        |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` in steady sliding; body 1 feels `-friction_force`. Dissipated power
    /// is `friction_force * velocity`; it is negative while the contact springs back. Over a closed cycle at constant
    /// load the dissipated energy is not negative.
    ///
    /// # Step
    /// The force depends on the displacement only, so with held inputs the step is exact for every $alpha$ and every
    /// step size, and two half steps equal one. With $y = 1 - (f_f / f_C) sgn v$ and $q = sigma_0 |x| / f_C$:
    ///
    /// ```text
    /// y(q) = y_0 exp(-q)                                            alpha  = 1
    /// y(q) = (y_0^(1 - alpha) - (1 - alpha) q)_+^(1 / (1 - alpha))  alpha != 1
    /// ```
    ///
    /// For $alpha < 1$ sliding is reached after a finite distance; the bracket is then zero. `sticking` means that more
    /// than 1 % (chosen) of the motion is still elastic.
    ///
    /// A master that integrates a mass m with the force it reads couples it explicitly to the stiffness k of the
    /// contact at rest. If the friction steps first, a held body stays still for communication steps below 2 sqrt(m /
    /// k), which is 6.3 ms for the defaults and 1 kg; above, it chatters within the bounds of the force. If all models
    /// step at once and exchange afterwards, it chatters at every step, since nothing damps the stiffness: take the
    /// friction first, or Model Exchange.
    ///
    #[doc = include_str!("slopes.md")]
    /// With `alpha` < 1 and a constant load a step with slopes is exact, too. If the load changes with it, the force of
    /// `alpha` = 0 may be beyond its level by 1.4 % of the mean one, whatever the step (a load that oscillates by 40 %
    /// at 11 Hz, at 10 mm/s).
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; in Model Exchange `mu_k` = 0, and `alpha` < 1, with which the bristles
    /// reach their full deflection with an infinite slope, where solvers stop.
    ///
    /// # Limits
    /// No stiction and no Stribeck effect. Drifts under a load that cycles below $f_C$. If the load falls while the
    /// contact is at rest, the force keeps the old deflection until there is motion. `normal_force` = 0 releases the
    /// contact (force 0, deflection 0).
    ///
    /// # Source
    /// Dahl (1968), "A solid friction model", TOR-0158(3107-18)-1, The Aerospace Corporation; equations (7.1) to (7.6)
    /// of F. Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis, University of
    /// Minho (2024), whose Table 7.1 gives $sigma_0$. $alpha = 1$, the form (7.5), is chosen as the default.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Dahl;
    /// use stribeck::model::{Law, Model};
    /// let mut law = Dahl { velocity: 1e-4, ..Default::default() };
    /// law.step(0.15); // 15 um of sliding
    /// law.output();
    /// let by_hand = 0.981 * (1.0 - (-1e5 * 1.5e-5 / 0.981f64).exp());
    /// assert!((law.friction_force - by_hand).abs() < 1e-15);
    /// ```
    Dahl: "Pre-sliding displacement with hysteresis (Dahl)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        mu_k: tunable = MU_K,
        sigma_0: tunable = SIGMA_0,
        /// Exponent of the transition to sliding; below 1 brittle, from 1 on ductile.
        alpha: tunable = real("1", 1.0).at_least(0.0).means(Meaning::Shape),
        bristle_deflection: state = BRISTLE_DEFLECTION.reinit(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Dahl<T> {
    #[inline(always)]
    fn coulomb(&self) -> T {
        self.mu_k * self.normal_force
    }

    #[inline(always)]
    fn force(&self) -> T {
        choose!(self.normal_force.is_positive(), self.sigma_0 * self.bristle_deflection, T::zero())
    }

    /// y = 1 - (f_f / f_C) sgn v: 0 when sliding, 1 for an undeflected contact.
    #[inline(always)]
    fn distance_to_sliding(&self) -> T {
        T::from(1.0) - self.force() / self.coulomb() * self.velocity.sign()
    }

    /// dz/dt / v.
    #[inline(always)]
    fn elastic_share(&self) -> T {
        let distance = self.distance_to_sliding();
        distance.sign() * power(distance.abs(), self.alpha)
    }
}

impl<T: Real> Law for Dahl<T> {
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
        let coulomb = self.coulomb();
        let kept =
            choose!(self.velocity.vanishes(), self.bristle_deflection, self.velocity.sign() * coulomb / self.sigma_0);
        self.bristle_deflection = choose!(coulomb.vanishes(), T::zero(), kept);
    }
}

impl<T: Real> Derivatives for Dahl<T> {
    /// Eq. (7.1), divided by sigma_0.
    #[inline(always)]
    fn derivatives(&self, rate: &mut Self) {
        let is_loaded = self.coulomb().is_positive();
        rate.bristle_deflection = choose!(is_loaded, self.velocity * self.elastic_share(), T::zero());
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

impl<T: Real> Dahl<T> {
    #[inline(always)]
    fn slide(&mut self, dt: T) {
        let (coulomb, direction) = (self.coulomb(), self.velocity.sign());
        let distance = self.velocity.abs() * dt;
        // Everything below is for sliding forwards; `missing` is the distance of the force from the level, f_C y.
        let missing = coulomb - direction * self.force();
        let y = missing.abs() / coulomb;
        let shrinkage = log_shrinkage(y, self.sigma_0 * distance / coulomb, self.alpha);
        let change = direction * missing * shrinkage.exp_m1() / self.sigma_0;
        self.bristle_deflection = self.bristle_deflection - change;
        let before = self.dissipated_energy;
        self.dissipated_energy = choose!(
            distance.is_positive(),
            before + coulomb * (distance - missing / self.sigma_0 * mean_path(y, shrinkage, self.alpha)),
            before
        );
    }
}

impl<T: Real> Steps for Dahl<T> {
    #[inline(always)]
    fn advance(&mut self, dt: T) {
        let is_loaded = !self.coulomb().vanishes();
        change!(self, is_loaded, |law| law.slide(dt), |law| law.bristle_deflection = T::zero());
    }
}

in_lanes!(Dahl);

impl Model for Dahl {
    const STEADY_SLIDING: bool = true;
    const PRESETS: &'static [Preset] = &[
        Preset {
            name: "thesis",
            source: "Novais (2024), Tables 6.1 and 7.1, in the form (7.5), alpha = 1 (the start values)",
            values: &[],
        },
        Preset {
            name: "bushing",
            source: "Example of a suspension bushing: 60 N of hysteresis, reached over some 0.2 mm",
            values: &[("normal_force", 600.0), ("sigma_0", 6e5)],
        },
    ];

    released_without_load!(bristle_deflection);

    /// With `alpha` < 1 the level is reached within a step, where the rate has a kink or jumps. At a constant load only
    /// the displacement counts, so that the step is exact.
    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        if self.alpha >= 1.0 || slope.normal_force != 0.0 {
            return ramp::advance(self, slope, dt);
        }
        let begin = ramp::Inputs::of(self);
        let motion = Motion { acceleration: slope.velocity, ..Motion::held(self.velocity, self.normal_force, dt) };
        for part in motion.parts() {
            self.velocity = part.path(part.duration) / part.duration;
            Steps::advance(self, part.duration);
        }
        ramp::set_inputs(self, &begin, slope, dt);
    }

    fn check_model_exchange(&self) -> Result<(), Fault> {
        if self.alpha < 1.0 {
            return Err(Fault::new(format_args!("alpha = {}: must be >= 1 in Model Exchange", self.alpha)));
        }
        crate::contact::conditions::kinetic_friction_for_exchange(self.mu_k)
    }

    in_lanes!();
}

/// `base` to a power, which usually is 0 or 1.
#[inline(always)]
fn power<T: Real>(base: T, exponent: T) -> T {
    choose!(exponent.is(1.0), base, choose!(exponent.is(0.0), T::from(1.0), base.powf(exponent)))
}

/// ln(y(q) / y_0) of dy/dq = -y^alpha for y_0 >= 0; minus infinity where y has reached 0.
#[inline(always)]
fn log_shrinkage<T: Real>(y_0: T, q: T, alpha: T) -> T {
    let [one, most] = [1.0, f64::MAX].map(T::from);
    let q = q.below(most).select(q, most);
    choose!(
        alpha.is(1.0),
        -q,
        choose!(
            y_0.vanishes(),
            T::zero(),
            choose!(
                alpha.equals(one),
                // The first terms in 1 - alpha: for its derivative.
                -q + (one - alpha) * q * (y_0.ln() - q / T::from(2.0)),
                log_shrinkage_by_powers(y_0, q, alpha)
            )
        )
    )
}

/// [`log_shrinkage`] for y_0 > 0 and an exponent other than 1. Not for registers, which have no powers.
fn log_shrinkage_by_powers<T: Real>(y_0: T, q: T, alpha: T) -> T {
    let one = T::from(1.0);
    let relative = (one - alpha) * q * power(y_0, alpha - one);
    let finite = choose!(
        relative.is(f64::NEG_INFINITY),
        // A level far below the force, with a large exponent: ln(1 + w) is ln w, computed in parts so that w may
        // overflow.
        -((alpha - one) * q).ln() / (alpha - one) - y_0.ln(),
        (-relative).ln_1p() / (one - alpha)
    );
    relative.at_least(one).select(T::from(f64::NEG_INFINITY), finite)
}

/// Integral of y over q, divided by y_0: (y_0^(2 - alpha) - y^(2 - alpha)) / ((2 - alpha) y_0).
#[inline(always)]
fn mean_path<T: Real>(y_0: T, log_shrinkage: T, alpha: T) -> T {
    let [one, two] = [1.0, 2.0].map(T::from);
    let exponent = two - alpha;
    let moving = choose!(
        exponent.is(0.0),
        -log_shrinkage / y_0,
        choose!(
            exponent.vanishes(),
            // The first terms in the exponent: for its derivative.
            -power(y_0, one - alpha) * log_shrinkage * (one + exponent * log_shrinkage / two),
            choose!(
                (exponent * log_shrinkage).abs().below(one),
                // The difference of two nearly equal powers.
                -power(y_0, one - alpha) * (exponent * log_shrinkage).exp_m1() / exponent,
                {
                    let y = y_0 * log_shrinkage.exp();
                    (power(y_0, exponent) - power(y, exponent)) / (exponent * y_0)
                }
            )
        )
    );
    y_0.vanishes().select(T::zero(), moving)
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    #[test]
    fn a_solver_is_not_given_an_infinite_slope() {
        let refusal =
            |alpha| Dahl { alpha, ..Default::default() }.check_model_exchange().map_err(|fault| fault.to_string());
        assert_eq!([1.0, 1.5].map(refusal), [Ok(()), Ok(())]);
        assert_eq!(refusal(0.5), Err("alpha = 0.5: must be >= 1 in Model Exchange".to_owned()));
    }

    fn slide(alpha: f64, from: f64, distance: f64, pieces: usize) -> Dahl {
        let mut law = Dahl { velocity: distance, alpha, bristle_deflection: from / 1e5, ..Default::default() };
        for _ in 0..pieces {
            law.step(1.0 / pieces as f64);
        }
        law.output();
        law
    }

    /// An elastic and perfectly plastic contact on a sine: f is the distance moved since the last reversal, up to the
    /// level. Its steps have slopes and pass the reversals.
    #[test]
    fn ramps_of_a_perfectly_plastic_contact_end_at_its_level() {
        let velocity = |t: f64| 0.01 * (44.0 * t + 0.3).sin() + 0.003 * (195.0 * t).sin();
        for dt in [1e-3, 1e-4, 1e-5] {
            let (mut law, mut expected, mut most) = (Dahl { alpha: 0.0, ..Default::default() }, 0.0f64, 0.0f64);
            for step in 0..(0.2 / dt) as usize {
                let [begin, end] = [step, step + 1].map(|step| velocity(step as f64 * dt));
                law.velocity = begin;
                let zero = Dahl { normal_force: 0.0, ..law }.map(&|_: f64| 0.0);
                law.step_ramp(&Dahl { velocity: (end - begin) / dt, ..zero }, dt);
                assert_eq!(law.velocity, begin + (end - begin) / dt * dt);
                let turn = if begin * end < 0.0 { begin / (begin - end) } else { 1.0 };
                let paths = [0.5 * begin * turn * dt, 0.5 * end * (1.0 - turn) * dt];
                let whole = [0.5 * (begin + end) * dt, 0.0];
                for path in if turn < 1.0 { paths } else { whole } {
                    expected = (expected + 1e5 * path).clamp(-0.981, 0.981);
                }
                law.output();
                assert_abs_diff_eq!(law.friction_force, expected, epsilon = 1e-11);
                most = most.max(law.friction_force.abs());
            }
            assert!((most - 0.981).abs() < 1e-15, "{most}");
        }
    }

    /// Virgin curve at 15 um, computed by numerical integration of (7.1).
    #[test]
    fn virgin_curve_for_four_exponents() {
        let expected = [(0.0, 0.981), (0.5, 0.926_605_505), (1.0, 0.768_377_037), (2.0, 0.593_107_618)];
        for (alpha, force) in expected {
            for pieces in [1, 7, 1000] {
                let law = slide(alpha, 0.0, 1.5e-5, pieces);
                assert!((law.friction_force - force).abs() < 1e-9, "{alpha}: {}", law.friction_force);
            }
        }
    }

    /// The closed forms for single exponents, as in textbooks.
    #[test]
    fn general_exponent_agrees_with_the_special_closed_forms() {
        let (level, q) = (0.981, 0.7);
        for from in [-0.9, -0.2, 0.0, 0.4] {
            let y_0: f64 = 1.0 - from / level;
            let expected = [
                (0.0, f64::min(from + level * q, level)),
                (0.5, level * (1.0 - f64::max(y_0.sqrt() - q / 2.0, 0.0).powi(2))),
                (1.0, level - (level - from) * f64::exp(-q)),
                (2.0, level * (1.0 - 1.0 / (1.0 / y_0 + q))),
            ];
            for (alpha, force) in expected {
                let law = slide(alpha, from, level * q / 1e5, 1);
                assert!((law.friction_force - force).abs() < 1e-14, "{alpha} from {from}");
                let mirrored = slide(alpha, -from, -level * q / 1e5, 1);
                assert!((mirrored.friction_force + force).abs() < 1e-14, "{alpha} from {from}, backwards");
            }
        }
    }

    /// Energy against the integral of the force over the distance by Simpson's rule.
    #[test]
    fn energy_is_the_integral_of_force_over_distance() {
        for alpha in [0.0, 0.5, 1.0, 1.5, 2.0, 3.0] {
            let (from, distance, n) = (-0.5, 2e-5, 20_000);
            let force = |k: usize| slide(alpha, from, distance * k as f64 / n as f64, 1).friction_force;
            let sum: f64 = (1..n).map(|k| force(k) * if k % 2 == 1 { 4.0 } else { 2.0 }).sum();
            let integral = (force(0) + sum + force(n)) * distance / n as f64 / 3.0;
            let energy = slide(alpha, from, distance, 1).dissipated_energy;
            assert!((energy / integral - 1.0).abs() < 1e-8, "{alpha}: {energy} against {integral}");
        }
    }

    /// Symmetric loop for alpha = 1: F_m = f_C tanh(sigma_0 X / f_C), E = 4 f_C X - 4 f_C^2 / sigma_0 tanh(..).
    #[test]
    fn periodic_loop_has_the_closed_form_peak_and_energy() {
        let mut law = slide(1.0, 0.0, 2e-5, 1);
        for _ in 0..20 {
            law.velocity = -4e-5;
            law.step(1.0);
            law.velocity = 4e-5;
            law.step(1.0);
        }
        law.output();
        assert_abs_diff_eq!(law.friction_force, 0.948_297_894_5, epsilon = 1e-10);
        let before = law.dissipated_energy;
        law.velocity = -4e-5;
        law.step(1.0);
        law.velocity = 4e-5;
        law.step(1.0);
        let energy = law.dissipated_energy - before;
        assert!((energy / 4.126_879_06e-5 - 1.0).abs() < 1e-8, "{energy}");
    }

    /// A level that falls below the present force is approached from above, not jumped to.
    #[test]
    fn falling_load_pulls_the_force_down_with_the_motion() {
        let mut law = slide(0.5, 0.981, 0.0, 1);
        law.normal_force = 4.905;
        law.velocity = 1e-6;
        law.step(1.0);
        law.output();
        assert!(law.friction_force < 0.981 && law.friction_force > 0.4905);
        law.step(1000.0);
        law.output();
        assert_abs_diff_eq!(law.friction_force, 0.4905, epsilon = 1e-15);
    }
}
