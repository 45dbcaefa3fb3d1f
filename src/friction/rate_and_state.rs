use crate::contact::quantities::*;
use crate::contact::unloading::released_without_load;
use crate::model::{Derivatives, Law, Meaning, Model, ModelExchange, Preset, real};
use crate::number::{Real, choose};
use crate::numerics::quadrature::integral;
use crate::numerics::relaxation;

crate::choices! {
    /// How the age of the contacts evolves.
    pub enum RateAndStateVariant {
        /// Contacts age with time, also at rest (Dieterich).
        Ageing,
        /// Contacts change only by sliding (Ruina).
        Slip,
    }
}

crate::model! {
    /// Rate-and-state friction (Dieterich, Ruina): friction depends on the logarithms of the speed and of the age of
    /// the contacts, which sliding renews; the law of rock and earthquakes, and of creep that turns into stick-slip.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = f_n a asinh( v / (2 v_0) exp((mu_0 + b ln(v_0 theta / D_c)) / a) )
    ///
    /// dtheta/dt = 1 - |v| theta / D_c                                Ageing
    /// dtheta/dt = -(|v| theta / D_c) ln(|v| theta / D_c)             Slip
    /// ```
    ///
    /// The state is $psi = ln(v_0 theta / D_c)$, with which every $theta$ is positive:
    ///
    /// ```text
    /// dpsi/dt = (v_0 exp(-psi) - |v|) / D_c                          Ageing
    /// dpsi/dt = -(|v| / D_c) (psi + ln(|v| / v_0))                   Slip
    /// ```
    ///
    /// Steady sliding has $theta = D_c / |v|$. Unless the argument of asinh is small, its friction is
    ///
    /// ```text
    /// f_f / f_n = mu_0 + (a - b) ln(v / v_0)
    /// ```
    ///
    /// A contact at rest has no steady age: its age grows without limit (Ageing) or stays as it is (Slip). A steady curve
    /// keeps the age that the contact had.
    ///
    /// After a jump of the speed from $v_1$ to $v_2$ the coefficient changes by $a ln(v_2 / v_1)$ at once and by
    /// $-b ln(v_2 / v_1)$ over a way of some $D_c$.
    ///
    /// | symbol | variable             | unit | meaning                                              |
    /// |--------|----------------------|------|------------------------------------------------------|
    /// | v      | `velocity`           | m/s  | velocity of body 1 relative to body 2                |
    /// | f_n    | `normal_force`       | N    | force pressing the surfaces together                 |
    /// | mu_0   | `mu_0`               | 1    | coefficient of friction of steady sliding at $v_0$   |
    /// | a      | `direct_effect`      | 1    | effect of the speed                                  |
    /// | b      | `evolution_effect`   | 1    | effect of the age of the contacts                    |
    /// | D_c    | `slip_distance`      | m    | way on which sliding renews the contacts             |
    /// | v_0    | `reference_velocity` | m/s  | speed of steady sliding at which friction is $mu_0$  |
    /// |        | `variant`            |      | how the age evolves                                  |
    /// | psi    | `log_age`            | 1    | logarithm of the age, relative to $D_c / v_0$        |
    /// | theta  | `age`                | s    | age of the contacts                                  |
    /// | f_f    | `friction_force`     | N    | friction force                                       |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` always; body 1 feels `-friction_force`. Dissipated power is
    /// `friction_force * velocity`, never negative: the law is passive for every motion and every load.
    ///
    /// # Step
    /// With held inputs both equations of the state have a closed form, so the age does not depend on how an interval
    /// is divided. With $q = |v| h / D_c$:
    ///
    /// ```text
    /// theta(h) = theta exp(-q) + (D_c / |v|) (1 - exp(-q)),   theta + h at rest      Ageing
    /// ln(|v| theta(h) / D_c) = ln(|v| theta / D_c) exp(-q),   theta at rest          Slip
    /// ```
    ///
    /// The dissipated energy is a quadrature with a relative error below 1e-10. `sticking` means $|v| < v_0$ under
    /// load.
    ///
    /// While the contact slides, the slope of the force is $a f_n / |v|$. A master that integrates a mass $m$ with the
    /// force it reads therefore needs a communication step below $2 m |v| / (a f_n)$; below a speed of
    /// $a f_n h / (2 m)$, 49 um/s for the defaults, 1 kg and 1 ms, the body chatters across rest with the whole force.
    /// Model Exchange with an implicit solver has no such limit.
    ///
    #[doc = include_str!("slopes.md")]
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// No stick: a contact at rest carries nothing, and under a load it creeps. A load $f_e$ below the level moves a
    /// body at $2 v_0 sinh(f_e / (a f_n)) exp(-(mu_0 + b psi) / a)$: for the defaults at $psi = 0$ and half of
    /// $mu_0 f_n$ that is 1e-13 of $v_0$. No elasticity either, hence no pre-sliding displacement.
    ///
    /// The force passes from one level to the other within $2 v_0 exp(-mu_0 / a)$, 1e-32 m/s for the defaults, which a
    /// solver does not resolve: where a body comes to rest or creeps far below 1e-9 m/s its steps become tiny, or it
    /// takes the force for linear and holds the body forever. Model Exchange is for motions that go on in one direction,
    /// as in the system `spring-slider`; the workbench starts others by steps of the law itself.
    ///
    /// $a < b$ weakens with speed: a spring softer than $(b - a) f_n / D_c$ then gives stick-slip. Fits are made around
    /// $v_0$; far from it the logarithm goes on, down to a friction of 0, which it does not pass. Only the product of
    /// normal force and coefficient is described: a change of the load does not change the age. `normal_force` = 0
    /// releases the contact: force 0, and the next step or event begins anew with $psi = 0$. A strut does not have the law:
    /// its contacts scale all of a law with one coefficient.
    ///
    /// # Source
    /// Dieterich (1979), doi:10.1029/JB084iB05p02161; Ruina (1983), doi:10.1029/JB088iB12p10359, both with the
    /// logarithm of the speed. The form with asinh, which is finite at rest and odd: Rice, Lapusta and Ranjith (2001),
    /// doi:10.1016/S0022-5096(01)00042-4. $|v|$ in both equations of the state makes it odd in full; $psi$ instead of
    /// $theta$ is the same law. Defaults of $mu_0$, $a$, $b$ and $v_0$: benchmark problem BP1, see the presets; $D_c$,
    /// 10 um instead of 8 mm, is chosen, of the size of asperities in a laboratory.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::RateAndState;
    /// use stribeck::model::{Law, Model};
    /// let mut law = RateAndState { velocity: 1e-5, normal_force: 100.0, ..Default::default() };
    /// law.output(); // ten times v_0, at the age of v_0
    /// assert!((law.friction_force - 100.0 * (0.6 + 0.010 * 10f64.ln())).abs() < 1e-12);
    /// law.step(100.0); // 1 mm of sliding
    /// law.output();
    /// assert!((law.friction_force - 100.0 * (0.6 - 0.005 * 10f64.ln())).abs() < 1e-12);
    /// ```
    RateAndState: "Friction of rock, by the speed and the age of its contacts (Dieterich, Ruina)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        /// Coefficient of friction in steady sliding at the reference velocity.
        mu_0: tunable = real("1", 0.6).at_least(0.0).means(Meaning::KineticLevel),
        /// Direct effect: change of the coefficient of friction with the logarithm of the speed, at once.
        direct_effect: tunable = real("1", 0.010).positive().nominal(0.01).means(Meaning::Own),
        /// Evolution effect: change of the coefficient of friction with the logarithm of the age of the contacts.
        evolution_effect: tunable = real("1", 0.015).at_least(0.0).nominal(0.01).means(Meaning::Own),
        /// Characteristic slip distance, on which sliding renews the contacts (default chosen).
        slip_distance: tunable = real("m", 1e-5).positive().nominal(1e-5).shown_in("um").means(Meaning::Own),
        /// Speed of steady sliding at which the coefficient of friction is mu_0.
        reference_velocity: tunable =
            real("m/s", 1e-6).positive().nominal(1e-6).shown_in("mm/s").means(Meaning::ReferenceSpeed),
        /// Variant of the law.
        variant: fixed = RateAndStateVariant::Ageing.start().means(Meaning::Variant),
        /// Logarithm of the age of the contacts, relative to that of steady sliding at the reference velocity.
        log_age: state = real("1", 0.0).reinit(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        /// Age of the contacts.
        age: output = real("s", 0.0).nominal(10.0),
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

/// Exponent beyond which the largest slope of the force, at rest, is not told from an infinite one (chosen).
const STEEPEST: f64 = 200.0;

/// Exponent from which asinh(e^x) is x + ln 2 to the last bit.
const LARGE: f64 = 20.0;

/// Ways, in slip distances, after which nothing of an age is left that was not larger than that of steady sliding.
const RENEWED: f64 = 40.0;

impl<T: Real> RateAndState<T> {
    fn is_ageing(&self) -> T::Mask {
        RateAndStateVariant::Ageing.is(self.variant)
    }

    /// ln(|v| / v_0), for motion.
    fn log_speed(&self) -> T {
        self.velocity.abs().ln() - self.reference_velocity.ln()
    }

    /// f_f / f_n for a logarithm of the age.
    fn coefficient(&self, log_age: T) -> T {
        let a = self.direct_effect;
        let strength = (self.mu_0 + self.evolution_effect * log_age) / a;
        choose!(
            self.velocity.vanishes(),
            {
                // The value is 0; its slope is finite, as solvers need it.
                let steepest = strength.limited(T::from(STEEPEST)).exp();
                a * self.velocity / (self.reference_velocity + self.reference_velocity) * steepest
            },
            a * asinh_exp(strength + self.log_speed() - T::from(std::f64::consts::LN_2)) * self.velocity.sign()
        )
    }

    fn force(&self) -> T {
        choose!(self.normal_force.is_positive(), self.normal_force * self.coefficient(self.log_age), T::zero())
    }

    /// dpsi/dt.
    fn ageing_rate(&self) -> T {
        let speed = self.velocity.abs();
        choose!(
            self.is_ageing(),
            (self.reference_velocity * (-self.log_age).exp() - speed) / self.slip_distance,
            choose!(speed.vanishes(), T::zero(), -(speed / self.slip_distance) * (self.log_age + self.log_speed()))
        )
    }
}

impl<T: Real> Law for RateAndState<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.age = self.slip_distance / self.reference_velocity * self.log_age.exp();
        self.friction_force = self.force();
        self.dissipated_power = self.friction_force * self.velocity;
        let creeps = self.velocity.abs().below(self.reference_velocity);
        self.sticking = T::truth(creeps & self.normal_force.is_positive());
    }

    fn slide_steadily(&mut self) {
        let kept = choose!(self.velocity.vanishes(), self.log_age, -self.log_speed());
        self.log_age = choose!(self.normal_force.is_positive(), kept, T::zero());
    }
}

impl<T: Real> Derivatives for RateAndState<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.log_age = choose!(self.normal_force.is_positive(), self.ageing_rate(), T::zero());
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

impl RateAndState {
    /// psi after a time in which the velocity is held.
    fn log_age_after(&self, time: f64) -> f64 {
        let speed = self.velocity.abs();
        let ways = speed * time / self.slip_distance;
        match RateAndStateVariant::of(self.variant) {
            RateAndStateVariant::Ageing => {
                // Logarithms of both terms of theta(h): neither may overflow where the other one counts.
                let left = self.log_age - ways;
                let grown = if ways < 1.0 {
                    Real::ln(self.reference_velocity * time / self.slip_distance * mean_decay(ways))
                } else {
                    Real::ln_1p(-Real::exp(-ways)) - self.log_speed()
                };
                left.max(grown) + Real::ln_1p(Real::exp(-(left - grown).abs()))
            }
            RateAndStateVariant::Slip if speed == 0.0 => self.log_age,
            RateAndStateVariant::Slip => relaxation::after(self.log_age, -self.log_speed(), ways),
        }
    }

    /// Energy dissipated in a time in which the inputs are held.
    fn work(&self, time: f64) -> f64 {
        let speed = self.velocity.abs();
        if speed == 0.0 {
            return 0.0;
        }
        let excess = self.log_age + self.log_speed();
        let until = match RateAndStateVariant::of(self.variant) {
            RateAndStateVariant::Ageing => RENEWED + excess.max(0.0),
            RateAndStateVariant::Slip => RENEWED + Real::ln_1p(excess.abs()),
        };
        let evolving = time.min(until * self.slip_distance / speed);
        let coefficient = |time| self.coefficient(self.log_age_after(time)).abs();
        let steady = if time > evolving { coefficient(time) * (time - evolving) } else { 0.0 };
        self.normal_force * speed * (integral(&coefficient, 0.0, evolving) + steady)
    }
}

impl Model for RateAndState {
    const STEADY_SLIDING: bool = true;
    const PRESETS: &'static [Preset] = &[
        Preset {
            name: "seas_bp1",
            source: "SEAS benchmark BP1, where friction weakens: Erickson et al. (2020), doi:10.1785/0220190248",
            values: &[("slip_distance", 8e-3)],
        },
        Preset {
            name: "strengthening",
            source: "Example of a contact that creeps steadily: a = 0.015 above b = 0.010",
            values: &[("direct_effect", 0.015), ("evolution_effect", 0.010)],
        },
    ];

    released_without_load!(log_age);

    fn step(&mut self, dt: f64) {
        if self.normal_force > 0.0 {
            self.dissipated_energy += self.work(dt);
        }
        self.step_without_energy(&mut [], dt);
    }

    fn step_without_energy(&mut self, _memory: &mut [f64], dt: f64) {
        self.log_age = if self.normal_force == 0.0 { 0.0 } else { self.log_age_after(dt) };
    }
}

/// asinh(e^x).
fn asinh_exp<T: Real>(x: T) -> T {
    let one = T::from(1.0);
    choose!(
        x.above(T::from(LARGE)),
        x + T::from(std::f64::consts::LN_2),
        choose!(x.is_positive(), x + (one + (one + (-(x + x)).exp()).sqrt()).ln(), {
            let y = x.exp();
            (y + y * y / (one + (one + y * y).sqrt())).ln_1p()
        })
    )
}

/// (1 - exp(-q)) / q.
fn mean_decay(q: f64) -> f64 {
    if q == 0.0 { 1.0 } else { -Real::exp_m1(-q) / q }
}

#[cfg(test)]
mod tests {
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    use super::*;
    use crate::number::Dual;
    use crate::numerics::random::uniform;

    const VARIANTS: [RateAndStateVariant; 2] = [RateAndStateVariant::Ageing, RateAndStateVariant::Slip];

    fn law(variant: RateAndStateVariant) -> RateAndState {
        RateAndState { variant: variant.number(), normal_force: 1.0, ..Default::default() }
    }

    /// The coefficient of friction after a time at a velocity.
    fn slide(law: &mut RateAndState, velocity: f64, time: f64) -> f64 {
        law.velocity = velocity;
        if time > 0.0 {
            law.step(time);
        }
        law.output();
        law.friction_force
    }

    /// As printed, with the asinh of the standard library.
    fn printed(v: f64, theta: f64) -> f64 {
        0.010 * (v / 2e-6 * ((0.6 + 0.015 * (1e-6 * theta / 1e-5f64).ln()) / 0.010).exp()).asinh()
    }

    #[test]
    fn steady_sliding_is_the_logarithm_of_the_speed() {
        for variant in VARIANTS {
            for v in [1e-9, 1e-6, 3e-4, 0.1, 20.0, -2e-5] {
                let mut law = law(variant);
                let mu = slide(&mut law, v, 100.0 * 1e-5 / v.abs());
                assert_relative_eq!(mu, printed(v, 1e-5 / v.abs()), max_relative = 1e-13);
                let logarithm = (0.6 - 0.005 * (v.abs() / 1e-6).ln()) * v.signum();
                assert_abs_diff_eq!(mu, logarithm, epsilon = 1e-14);
                assert_relative_eq!(law.age, 1e-5 / v.abs(), max_relative = 1e-13);
            }
        }
    }

    /// The regularised form where it differs from the logarithms: near rest, and where friction has faded at speed.
    #[test]
    fn near_rest_the_force_is_viscous() {
        let mut law = RateAndState { mu_0: 0.02, ..law(RateAndStateVariant::Ageing) };
        for v in [1e-12, 1e-7, 1e-6, -4e-7] {
            let by_hand = 0.010 * (v / 2e-6 * 2f64.exp()).asinh();
            assert_relative_eq!(slide(&mut law, v, 0.0), by_hand, max_relative = 1e-14);
        }
        let dual = law.map(&Dual::from);
        let mut rest = RateAndState { velocity: Dual { value: 0.0, slope: 1.0 }, ..dual };
        rest.output();
        assert_eq!(rest.friction_force.value, 0.0);
        assert_relative_eq!(rest.friction_force.slope, 0.010 / 2e-6 * 2f64.exp(), max_relative = 1e-14);
        // Steady at 1 m/s: mu_0 + (a - b) ln(v / v_0) is negative, friction is not.
        let by_hand = 0.010 * (0.5 * ((0.02 - 0.005 * 1e6f64.ln()) / 0.010).exp()).asinh();
        assert_relative_eq!(slide(&mut law, 1.0, 1.0), by_hand, max_relative = 1e-13);
    }

    #[test]
    fn asinh_of_an_exponential_is_that_of_the_standard_library() {
        for k in -3000..6000 {
            let x = f64::from(k) * 0.01;
            assert_relative_eq!(asinh_exp(x), x.exp().asinh(), max_relative = 2e-14);
            let slope = asinh_exp(Dual { value: x, slope: 1.0 }).slope;
            assert_relative_eq!(slope, 1.0 / (1.0 + (-2.0 * x).exp()).sqrt(), max_relative = 1e-13);
        }
        assert_eq!(asinh_exp(-800.0), 0.0);
        assert_eq!(asinh_exp(1e300), 1e300);
        assert_eq!(asinh_exp(700.0), 700.0 + std::f64::consts::LN_2);
    }

    /// A jump from v_1 to v_2: a ln(v_2 / v_1) at once, (a - b) ln(v_2 / v_1) in the end; what is missing of b ln(v_2 /
    /// v_1) decays as exp(-x / D_c) by the slip law, up and down alike, and with theta by the ageing law.
    #[test]
    fn a_jump_of_the_speed_acts_at_once_and_over_the_slip_distance() {
        for (v_1, v_2) in [(1e-6, 1e-5), (1e-4, 1e-6), (-3e-6, -0.01)] {
            let jump = f64::ln(v_2 / v_1);
            for variant in VARIANTS {
                let mut law = law(variant);
                let before = slide(&mut law, v_1, 1e-3 / f64::abs(v_1)).abs();
                let at_once = slide(&mut law, v_2, 0.0).abs();
                assert_abs_diff_eq!(at_once - before, 0.010 * jump, epsilon = 1e-13);
                for ways in [0.1, 1.0, 3.0] {
                    let mut law = law;
                    let on_the_way = slide(&mut law, v_2, ways * 1e-5 / f64::abs(v_2)).abs();
                    let left = match variant {
                        RateAndStateVariant::Slip => jump * f64::exp(-ways),
                        RateAndStateVariant::Ageing => f64::ln(1.0 + (v_2 / v_1 - 1.0) * f64::exp(-ways)),
                    };
                    assert_abs_diff_eq!(on_the_way - before, 0.010 * jump - 0.015 * (jump - left), epsilon = 1e-13);
                }
                let after = slide(&mut law, v_2, 1e-3 / f64::abs(v_2)).abs();
                assert_abs_diff_eq!(after - before, -0.005 * jump, epsilon = 1e-13);
            }
        }
    }

    /// At rest contacts age with time by the ageing law, and stay as they are by the slip law: 10 s at the start.
    #[test]
    fn contacts_age_at_rest() {
        for time in [1e-9, 1e-3, 2.0, 3600.0, 3e9] {
            for (variant, age) in VARIANTS.into_iter().zip([10.0 + time, 10.0]) {
                let mut law = law(variant);
                assert_eq!(slide(&mut law, 0.0, time), 0.0);
                assert_relative_eq!(law.age, age, max_relative = 1e-14);
                assert_eq!(law.dissipated_energy, 0.0);
            }
        }
    }

    /// dtheta/dt as printed.
    fn rate(variant: RateAndStateVariant, v: f64, theta: f64) -> f64 {
        let ways = v.abs() * theta / 1e-5;
        match variant {
            RateAndStateVariant::Ageing => 1.0 - ways,
            RateAndStateVariant::Slip if ways == 0.0 => 0.0,
            RateAndStateVariant::Slip => -ways * ways.ln(),
        }
    }

    /// Dwells, reversals and jumps of the speed over four decades, in steps of up to three slip distances: theta by the
    /// classical Runge-Kutta method, the energy by Simpson's rule along it.
    #[test]
    fn steps_agree_with_the_integrated_equations() {
        for variant in VARIANTS {
            let (mut law, mut theta, mut energy) = (law(variant), 10.0, 0.0);
            for step in 0..60 {
                let [speed, side, time] = [1, 2, 3].map(|sequence| uniform(5, sequence, step));
                let speed = if step % 7 == 0 { 0.0 } else { 10f64.powf(-6.0 + 4.0 * speed) };
                let v = if side < 0.5 { speed } else { -speed };
                let time = if speed == 0.0 { 5.0 * time } else { 3e-5 * time / speed };
                let (n, mut sum) = (20_000, 0.0);
                let h = time / f64::from(n);
                for _ in 0..n {
                    let k_1 = rate(variant, v, theta);
                    let k_2 = rate(variant, v, theta + 0.5 * h * k_1);
                    let middle = theta + 0.5 * h * k_2;
                    let k_3 = rate(variant, v, middle);
                    let k_4 = rate(variant, v, theta + h * k_3);
                    let end = theta + h / 6.0 * (k_1 + 2.0 * k_2 + 2.0 * k_3 + k_4);
                    let middle = 0.5 * (theta + end) + h / 8.0 * (k_1 - rate(variant, v, end));
                    sum += h / 6.0 * (printed(v, theta) + 4.0 * printed(v, middle) + printed(v, end));
                    theta = end;
                }
                energy += v * sum;
                slide(&mut law, v, time);
                assert_relative_eq!(law.age, theta, max_relative = 1e-9);
                assert_relative_eq!(law.dissipated_energy, energy, max_relative = 1e-9);
            }
        }
    }

    /// Where friction fades within the step, with a bend that is sharp beside the step: one step against many short
    /// ones.
    #[test]
    fn energy_is_found_where_friction_fades() {
        for variant in VARIANTS {
            let faded = RateAndState {
                direct_effect: 1e-5,
                evolution_effect: 0.15,
                velocity: 1.0,
                log_age: 3.0,
                ..law(variant)
            };
            let (mut once, mut often) = (faded, faded);
            once.step(3e-5);
            for _ in 0..50_000 {
                often.step(6e-10);
            }
            assert_relative_eq!(once.dissipated_energy, often.dissipated_energy, max_relative = 1e-10);
            assert_abs_diff_eq!(once.log_age, often.log_age, epsilon = 1e-9);
        }
    }

    /// As said under Limits, with the sinh of the standard library.
    #[test]
    fn a_load_below_the_level_creeps() {
        let mut law = law(RateAndStateVariant::Ageing);
        for (share, log_age) in [(0.5, 0.0), (0.9, 2.0), (1.05, 0.0)] {
            law.log_age = log_age;
            let load: f64 = 0.6 * share;
            let creep = 2e-6 * (load / 0.010).sinh() * (-(0.6 + 0.015 * log_age) / 0.010).exp();
            assert_relative_eq!(slide(&mut law, creep, 0.0), load, max_relative = 1e-13);
            assert_eq!(law.sticking == 1.0, creep < 1e-6, "{creep}");
        }
        let half = slide(&mut RateAndState { log_age: 0.0, ..law }, 1e-6 * (-30f64).exp(), 0.0);
        assert_abs_diff_eq!(half, 0.3, epsilon = 1e-12);
    }

    #[test]
    fn a_released_contact_begins_anew() {
        for variant in VARIANTS {
            let mut law = law(variant);
            slide(&mut law, 0.1, 1.0);
            law.normal_force = 0.0;
            assert_eq!(slide(&mut law, 0.1, 1e-3), 0.0);
            assert_eq!((law.log_age, law.sticking), (0.0, 0.0));
            assert_relative_eq!(law.age, 10.0, max_relative = 1e-15);
        }
    }
}
