use crate::contact::conditions::is_elastic;
use crate::contact::quantities::*;
use crate::contact::unloading::released_without_load;
use crate::laws::passivity::names_least_viscous;
use crate::laws::stribeck;
use crate::model::{Derivatives, Fault, Law, Meaning, Model, ModelExchange, Preset, integer};
use crate::number::elementary::{exp, exp_m1, ln, ln_1p, pow, sin};
use crate::number::{Mask, Real, Scalar};
use crate::numerics::quadrature;
use crate::numerics::runge_kutta::{Done, dormand_prince_from, growth};

crate::model! {
    /// Elasto-plastic friction (Dupont): LuGre with a range of purely elastic deflection, so that a contact loaded
    /// below breakaway does not drift.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f   = sigma_0 z + sigma_1(v) dz/dt + sigma_2 v                                  (7.30)
    /// dz/dt = v [1 - alpha(z, v) sgn(v) z / z_ss(v)]^i                                  (7.32)
    /// z_ss  = g(v) / sigma_0,   g(v) = f_C + (f_s - f_C) exp(-(|v| / v_S)^delta)
    /// alpha = 0                                                        sgn v != sgn z   (7.33)
    ///       = 0                                                        |z| <= z_ba
    ///       = 1/2 + 1/2 sin(pi (|z| - (z_ss + z_ba) / 2) / (z_ss - z_ba))   z_ba < |z| < z_ss
    ///       = 1                                                        |z| >= z_ss
    /// z_ba  = kappa z_ss(v)
    /// f_C   = mu_k f_n,   f_s = mu_s f_n
    /// sigma_1(v) = sigma_1 exp(-(v / v_d)^2)     if v_d > 0, else sigma_1
    /// ```
    ///
    /// | symbol  | variable              | unit  | meaning                                    |
    /// |---------|-----------------------|-------|--------------------------------------------|
    /// | v       | `velocity`            | m/s   | velocity of body 1 relative to body 2      |
    /// | f_n     | `normal_force`        | N     | force pressing the surfaces together       |
    /// | mu_k    | `mu_k`                | 1     | kinetic coefficient of friction            |
    /// | mu_s    | `mu_s`                | 1     | static coefficient of friction             |
    /// | v_S     | `stribeck_velocity`   | m/s   | speed at which the level has fallen        |
    /// | delta   | `stribeck_exponent`   | 1     | shape of the Stribeck curve                |
    /// | kappa   | `breakaway_ratio`     | 1     | $z_ba / z_ss$: part that is purely elastic |
    /// | i       | `plastic_exponent`    | -     | shape of the transition, odd               |
    /// | sigma_0 | `sigma_0`             | N/m   | stiffness of the bristles                  |
    /// | sigma_1 | `sigma_1`             | N.s/m | damping of the bristles                    |
    /// | sigma_2 | `viscous_coefficient` | N.s/m | viscous coefficient                        |
    /// | v_d     | `damping_velocity`    | m/s   | speed at which the bristle damping fades   |
    /// | z       | `bristle_deflection`  | m     | mean deflection of the bristles            |
    /// | f_f     | `friction_force`      | N     | friction force                             |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` in steady sliding; body 1 feels `-friction_force`. Dissipated power
    /// is `friction_force * velocity`; it is negative while the bristles spring back.
    ///
    /// # Step
    /// With held inputs the deflection depends on the sliding distance only. Where $alpha$ is 0 (elastic) or 1 (level
    /// exceeded) the step is exact, and the distance at which $z_ba$ is reached is located. Between them, with
    /// $y = 1 - |z| / z_ss$ and $q$ the distance in units of $z_ss$, the law is integrated in a variable in which it is
    /// not stiff:
    ///
    /// ```text
    /// p     = -ln(y)   if i = 1, else   y^(1 - i) / (i - 1)
    /// dp/dq = ((1 - alpha |z| / z_ss) / y)^i                 falls from (1 - kappa)^-i to 1
    /// ```
    ///
    /// The approach to steady sliding, $p = q$, is therefore exact over any distance, and for the rest an explicit
    /// method of order 5 (Dormand and Prince) with error control is as stable as an implicit one would be for $z$
    /// itself. If a slide leaves nothing of $y$ and $i = 1$, only its energy is unknown, which is an integral over $y$.
    /// The error per step is below $1e-12 z_ss$ (chosen), and two half steps equal one to 1e-10 of the level.
    /// `sticking` means that more than 1 % (chosen) of the motion still goes into the bristles.
    ///
    /// A master that integrates a mass $m$ with the force it reads couples it explicitly to the stiffness $k$ and the
    /// damping $c$ of the contact at rest, $sigma_0$ and $sigma_1 + sigma_2$ as with `LuGre`. If the friction steps
    /// first, a held body stays still for communication steps $h$ with $k h^2 + 2 c h < 4 m$, which is 3.9 ms for the
    /// defaults and 1 kg; above, it chatters within the bounds of the force. If all models step at once and exchange
    /// afterwards, the limit is $h < 1 / (k / c + c / m)$, 1.6 ms.
    ///
    #[doc = include_str!("slopes.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`; an even `plastic_exponent`, for which the bracket
    /// cannot become negative, so that $z$ could not return when $z_ss(v)$ falls below $|z|$; in Model Exchange `mu_k`
    /// = 0.
    ///
    /// # Limits
    /// No drift as long as $|z|$ stays below $z_ba = kappa z_ss$. The damping has the weakness of LuGre: with the
    /// bracket $r = 1 - |z| / z_ss(v) >= 1 - f_s / f_C$ the power is above $-sigma_1 (f_s / f_C - 1)^i v^2$, so that
    /// the law is passive for every motion at constant load only if $sigma_2 >= sigma_1 (f_s / f_C - 1)^i$, or if
    /// `mu_s` = `mu_k`, or `sigma_1` = 0. A velocity that jumps from full stiction to 0.1 m/s gives -14.3 N;
    /// `damping_velocity` (of the size of $v_S$) removes that, and the default 0 keeps the law of the paper. For
    /// $i > 1$ steady sliding is approached as $q^(-1 / (i - 1))$ only. `breakaway_ratio` = 1 is elastic and perfectly
    /// plastic; small values come close to LuGre without reaching it, because $alpha$ still rises with $|z|$.
    /// `normal_force` = 0 releases the contact (force 0, deflection 0).
    ///
    #[doc = include_str!("falling_load.md")]
    /// # Source
    /// Dupont, Hayward, Armstrong, Altpeter (2002), "Single state elastoplastic friction models",
    /// doi:10.1109/TAC.2002.1000274; equations (7.30) to (7.34) of F. Novais, "A critical analysis on friction force
    /// models in dynamical systems", MSc thesis, University of Minho (2024), whose Table 7.1 gives $sigma_0$,
    /// $sigma_1$, $sigma_2$, $v_S$ and $i$, and whose text gives $kappa = 0.7$. Differences: the sine (7.34) is printed
    /// with $z$, which is right for $z > 0$ only; here it has $|z|$. $i$ is any integer there and odd here.
    /// `damping_velocity`: Olsson (1996), PhD thesis, Lund University. A public library of friction models has $z$
    /// instead of $|z|$, and lacks $alpha = 0$ for $sgn v != sgn z$.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::ElastoPlastic;
    /// use stribeck::model::{Law, Model};
    /// let mut law = ElastoPlastic { velocity: 1e-4, ..Default::default() };
    /// law.step(0.1); // 10 um, just below z_ba = 0.7 * 14.67 um: a spring and two dampers
    /// law.output();
    /// let by_hand = 1e5 * 1e-5 + (1e5f64.sqrt() + 0.1) * 1e-4;
    /// assert!((law.friction_force - by_hand).abs() < 1e-12);
    /// ```
    ElastoPlastic: "Bristle friction without drift below breakaway (elasto-plastic)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        stribeck_velocity: tunable = STRIBECK_VELOCITY,
        stribeck_exponent: tunable = STRIBECK_EXPONENT,
        breakaway_ratio: tunable = BREAKAWAY_RATIO,
        /// Exponent of the transition from elastic deflection to sliding; odd.
        plastic_exponent: tunable = integer(1).at_least(1.0).at_most(9.0).means(Meaning::Shape),
        sigma_0: tunable = SIGMA_0,
        sigma_1: tunable = SIGMA_1,
        viscous_coefficient: tunable = VISCOUS_COEFFICIENT.start(0.1),
        damping_velocity: tunable = DAMPING_VELOCITY,
        bristle_deflection: state = BRISTLE_DEFLECTION.reinit(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Scalar> ElastoPlastic<T> {
    /// g(v).
    fn level(&self) -> T {
        let coulomb = self.mu_k * self.normal_force;
        let breakaway = self.mu_s * self.normal_force;
        stribeck::level(self.velocity, coulomb, breakaway, self.stribeck_velocity, self.stribeck_exponent)
    }

    /// sigma_1(v).
    fn damping(&self) -> T {
        let falling = || {
            let u = self.velocity / self.damping_velocity;
            self.sigma_1 * (-(u * u)).exp()
        };
        self.damping_velocity.is(0.0).choose(|| self.sigma_1, falling)
    }

    /// Eqs. (7.33) and (7.34), in terms of u = sgn(v) z / z_ss.
    fn alpha(&self, u: T) -> T {
        let [half, one] = [0.5, 1.0].map(T::from);
        let kappa = self.breakaway_ratio;
        let rising = || {
            let angle = T::from(std::f64::consts::PI) * (u - half * (one + kappa)) / (one - kappa);
            half + half * angle.sin()
        };
        u.at_most(kappa).choose(|| T::zero(), || u.below(one).choose(rising, || one))
    }

    /// Eq. (7.32).
    fn deflection_rate(&self) -> T {
        let level = self.level();
        let loaded = || {
            let u = self.velocity.sign() * self.bristle_deflection * self.sigma_0 / level;
            let bracket = T::from(1.0) - self.alpha(u) * u;
            let power = (1..self.plastic_exponent.value() as u32).fold(bracket, |power, _| power * bracket);
            self.velocity * power
        };
        level.vanishes().choose(|| T::zero(), loaded)
    }

    fn force(&self, deflection_rate: T) -> T {
        let [stiffness, viscous] = [self.sigma_0, self.viscous_coefficient];
        let loaded =
            || stiffness * self.bristle_deflection + self.damping() * deflection_rate + viscous * self.velocity;
        self.normal_force.vanishes().choose(|| T::zero(), loaded)
    }
}

impl<T: Scalar> ElastoPlastic<T> {
    /// The outputs at dz/dt.
    fn respond(&mut self, rate: T) {
        self.friction_force = self.force(rate);
        self.dissipated_power = self.friction_force * self.velocity;
        let elastic = is_elastic(rate, self.velocity);
        self.sticking = T::truth(elastic & self.normal_force.is_positive());
    }
}

impl<T: Scalar> Law for ElastoPlastic<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.respond(self.deflection_rate());
    }

    fn slide_steadily(&mut self) {
        let level = self.level();
        let moving = || self.velocity.sign() * (level / self.sigma_0);
        let loaded = || self.velocity.vanishes().choose(|| self.bristle_deflection, moving);
        self.bristle_deflection = level.vanishes().choose(|| T::zero(), loaded);
    }
}

impl<T: Scalar> Derivatives for ElastoPlastic<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.bristle_deflection = self.deflection_rate();
        rate.dissipated_energy = self.force(rate.bristle_deflection) * self.velocity;
    }

    fn output_and_derivatives(&mut self, rate: &mut Self) {
        rate.bristle_deflection = self.deflection_rate();
        self.respond(rate.bristle_deflection);
        rate.dissipated_energy = self.dissipated_power;
    }
}

impl Model for ElastoPlastic {
    const STEADY_SLIDING: bool = true;
    const PRESETS: &'static [Preset] = &[
        Preset {
            name: "thesis",
            source: "Novais (2024), Tables 6.1 and 7.1, and kappa = 0.7 from its text (the start values)",
            values: &[],
        },
        Preset {
            name: "sampled",
            source: "Example: the thesis's values with a bristle damping that fades at 1 mm/s, for sampled velocities",
            values: &[("damping_velocity", 0.001)],
        },
    ];

    released_without_load!(bristle_deflection);

    fn check(&self) -> Result<(), Fault> {
        if self.plastic_exponent % 2.0 == 0.0 {
            return Err(Fault::new(format_args!("plastic_exponent = {}: must be odd", self.plastic_exponent)));
        }
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    names_least_viscous!(|law| law.plastic_exponent);

    fn check_model_exchange(&self) -> Result<(), Fault> {
        crate::contact::conditions::kinetic_friction_for_exchange(self.mu_k)
    }

    fn step(&mut self, dt: f64) {
        let level = self.level();
        let distance = self.velocity.abs() * dt;
        if level == 0.0 {
            self.bristle_deflection = 0.0;
            if self.normal_force > 0.0 {
                self.dissipated_energy += self.viscous_coefficient * self.velocity.abs() * distance;
            }
            return;
        }
        let direction = self.velocity.sign();
        let (begin, z_ss) = (self.bristle_deflection, level / self.sigma_0);
        // alpha = 0: a spring, up to z_ba.
        let elastic = distance.min((self.breakaway_ratio * z_ss - direction * begin).max(0.0));
        self.bristle_deflection += direction * elastic;
        self.dissipated_energy += self.sigma_0 * elastic * (direction * begin + 0.5 * elastic);
        if elastic < distance {
            let u = (direction * self.bristle_deflection / z_ss).clamp(self.breakaway_ratio, f64::MAX);
            let mut slide = Slide { u, left: ((distance - elastic) / z_ss).min(f64::MAX), area: 0.0 };
            slide.finish(self.breakaway_ratio, self.plastic_exponent);
            self.bristle_deflection = direction * slide.u * z_ss;
            self.dissipated_energy += level * (z_ss * slide.area);
        }
        self.dissipated_energy += self.damping() * self.velocity * (self.bristle_deflection - begin)
            + self.viscous_coefficient * self.velocity.abs() * distance;
    }
}

/// A slide from u >= kappa at constant speed, in units of z_ss: du/dq = (1 - alpha(u) u)^i.
struct Slide {
    /// sgn(v) z / z_ss.
    u: f64,
    /// Remaining distance.
    left: f64,
    /// Integral of u over the distance.
    area: f64,
}

/// Error allowed in u and in the integral of u, per step of the integration (chosen: two orders below what the two
/// halves of a step may differ by).
const TOLERANCE: f64 = 1e-12;

/// From here on u is 1 apart from rounding.
const NOTHING: f64 = 1e-17;

impl Slide {
    fn finish(&mut self, kappa: f64, exponent: f64) {
        if self.u < 1.0 { self.yield_gradually(kappa, exponent) } else { self.shrink(exponent) }
    }

    /// alpha = 1: w = u - 1 follows dw/dq = -w^i.
    fn shrink(&mut self, i: f64) {
        let (w, q) = (self.u - 1.0, self.left);
        let x = (i - 1.0) * q * pow(w, i - 1.0);
        let (w_end, area) = if i == 1.0 {
            (w * exp(-q), -w * exp_m1(-q))
        } else if w == 0.0 {
            (0.0, 0.0)
        } else if x < 1.0 {
            let log = ln_1p(x) / (i - 1.0);
            (w * exp(-log), pow(w, 2.0 - i) * exp_m1((i - 2.0) * log) / (i - 2.0))
        } else {
            let w_end = pow(pow(w, 1.0 - i) + (i - 1.0) * q, -1.0 / (i - 1.0));
            (w_end, (pow(w_end, 2.0 - i) - pow(w, 2.0 - i)) / (i - 2.0))
        };
        self.u = 1.0 + w_end;
        self.area += q + area;
        self.left = 0.0;
    }

    /// kappa <= u < 1.
    fn yield_gradually(&mut self, kappa: f64, exponent: f64) {
        let transition = Transition { width: 1.0 - kappa, exponent };
        if exponent == 1.0 && self.left >= transition.variable(NOTHING) {
            // Nothing is left of y, which falls at least as fast as e^-q.
            self.area += self.left - quadrature::integral(&|y| transition.share(y), 0.0, 1.0 - self.u);
            (self.u, self.left) = (1.0, 0.0);
            return;
        }
        // p, and the integral of y = 1 - u over the distance.
        let mut at = [transition.variable(1.0 - self.u), 0.0];
        // dp/dq, and y.
        let mut rates = transition.rates(at);
        let mut piece = 0.1 * at[0].max(1.0) / rates[0];
        let distance = self.left;
        while self.left > 0.0 && rates[1] > NOTHING {
            let q = piece.min(self.left);
            let next = dormand_prince_from(rates, |_, at| transition.rates(at), at, q);
            let error = transition.error(&next) / TOLERANCE;
            if error <= 1.0 {
                (at, rates) = (next.end, next.rates);
                self.left = if q < self.left { self.left - q } else { 0.0 };
            } else if q < f64::MIN_POSITIVE {
                // Numbers out of range: the caller refuses the step.
                (at, rates) = ([f64::NAN; 2], [f64::NAN; 2]);
            }
            if self.left > 0.0 {
                piece = q * growth(error);
            }
        }
        self.u = 1.0 - rates[1];
        self.area += distance - at[1];
        self.left = 0.0;
    }
}

/// The range in which alpha rises from 0 to 1, in the variable p in which it is not stiff.
struct Transition {
    /// 1 - kappa.
    width: f64,
    /// i.
    exponent: f64,
}

impl Transition {
    /// p for y = 1 - u.
    fn variable(&self, y: f64) -> f64 {
        if self.exponent == 1.0 { -ln(y) } else { pow(y, 1.0 - self.exponent) / (self.exponent - 1.0) }
    }

    /// y for p.
    fn missing(&self, p: f64) -> f64 {
        if self.exponent == 1.0 { exp(-p) } else { pow((self.exponent - 1.0) * p, -1.0 / (self.exponent - 1.0)) }
    }

    /// dp/dq = ((1 - alpha u) / y)^i with 1 - alpha = sin^2(pi y / (2 - 2 kappa)), and y.
    fn rates(&self, [p, _]: [f64; 2]) -> [f64; 2] {
        let y = self.missing(p);
        [self.power(1.0 + (1.0 - y) * self.elastic(y) / y), y]
    }

    /// x^i.
    fn power(&self, x: f64) -> f64 {
        if self.exponent == 1.0 { x } else { pow(x, self.exponent) }
    }

    /// For i = 1, y by the rate at which it falls.
    fn share(&self, y: f64) -> f64 {
        y / (y + (1.0 - y) * self.elastic(y))
    }

    /// 1 - alpha.
    fn elastic(&self, y: f64) -> f64 {
        let sine = sin(std::f64::consts::FRAC_PI_2 * (y / self.width).min(1.0));
        sine * sine
    }

    /// Error of u, with dy = -y^i dp, and of the integral, relative to it where it is large.
    fn error(&self, done: &Done<2>) -> f64 {
        let Done { end: [_, area], error: [error, area_error], rates: [_, y] } = *done;
        (self.power(y) * error).abs() + area_error.abs() / area.max(1.0)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    /// u and the integral of u after a slide of q.
    fn slide(u: f64, q: f64, kappa: f64, exponent: f64) -> Slide {
        let elastic = q.min((kappa - u).max(0.0));
        let mut slide = Slide { u: u + elastic, left: q - elastic, area: elastic * (u + 0.5 * elastic) };
        if slide.left > 0.0 {
            slide.finish(kappa, exponent);
        }
        slide
    }

    /// alpha as printed in (7.33) and (7.34), with u = |z| / z_ss.
    fn alpha(u: f64, kappa: f64) -> f64 {
        ElastoPlastic { breakaway_ratio: kappa, ..Default::default() }.alpha(u)
    }

    /// Limits 0, 1/2 and 1 of alpha, on both sides; nothing yields when z and v have different signs.
    #[test]
    fn alpha_rises_from_zero_to_one_between_breakaway_and_sliding() {
        for (u, expected) in [(-0.9, 0.0), (0.0, 0.0), (0.7, 0.0), (0.85, 0.5), (1.0, 1.0), (1.4, 1.0)] {
            assert!((alpha(u, 0.7) - expected).abs() < 1e-15, "{u}");
        }
        assert!(alpha(0.7 + 1e-6, 0.7) < 1e-10 && alpha(1.0 - 1e-6, 0.7) > 1.0 - 1e-10);
        let force = |velocity: f64, z: f64| {
            let mut law = ElastoPlastic { velocity, bristle_deflection: z, ..Default::default() };
            law.output();
            law.friction_force
        };
        for z in [4e-6, 1.1e-5, 1.25e-5, 1.5e-5, 2e-5] {
            assert_eq!(force(1e-3, z), -force(-1e-3, -z));
            assert!((force(-1e-5, z) - (1e5 * z - 316.327_766e-5)).abs() < 1e-9, "against the deflection: a spring");
        }
    }

    /// A slide after which nothing is left to yield, against two short ones that end at the same place.
    #[test]
    fn a_long_slide_is_the_sum_of_short_ones() {
        for kappa in [0.05, 0.7, 0.99, 1.0 - 1e-9] {
            for start in [-0.5, 0.0, 1.0 - 1e-3] {
                let (long, first) = (slide(start, 50.0, kappa, 1.0), slide(start, 25.0, kappa, 1.0));
                let second = slide(first.u, 25.0, kappa, 1.0);
                assert_eq!(long.u, 1.0);
                assert_abs_diff_eq!(long.u, second.u, epsilon = 1e-12);
                assert!((long.area - first.area - second.area).abs() < 1e-10, "{kappa} {start}");
            }
        }
    }

    /// u and its integral against a fine integration of du/dq = (1 - alpha u)^i as printed.
    #[test]
    fn slides_follow_the_differential_equation() {
        for (kappa, exponent) in [(0.7, 1.0), (0.2, 1.0), (0.95, 1.0), (0.7, 3.0), (0.5, 5.0)] {
            let rate = |u: f64| (1.0 - alpha(u, kappa) * u).powf(exponent);
            for start in [-1.5, -0.3, 0.0, 0.9, 0.99] {
                let (mut u, mut area, n, q) = (start, 0.0, 40_000, 4.0);
                let h = q / f64::from(n);
                for step in 0..n {
                    let k_1 = rate(u);
                    let k_2 = rate(u + 0.5 * h * k_1);
                    let k_3 = rate(u + 0.5 * h * k_2);
                    let k_4 = rate(u + h * k_3);
                    let next = u + h / 6.0 * (k_1 + 2.0 * k_2 + 2.0 * k_3 + k_4);
                    // Hermite's cubic: its integral over the step.
                    area += h * (0.5 * (u + next) + h / 12.0 * (k_1 - rate(next)));
                    u = next;
                    if step % 10_000 == 9_999 {
                        let found = slide(start, h * f64::from(step + 1), kappa, exponent);
                        assert!((found.u - u).abs() < 1e-9, "{kappa} {exponent} {start}: {} {u}", found.u);
                        assert!((found.area - area).abs() < 1e-9, "{kappa} {exponent} {start}: {}", found.area);
                    }
                }
            }
        }
    }

    /// Above the level (it has fallen): w = u - 1 decays as exp(-q), or as (w^(1 - i) + (i - 1) q)^(-1 / (i - 1)).
    #[test]
    fn exceeded_level_is_left_by_the_closed_forms() {
        assert_abs_diff_eq!(slide(1.5, 0.7, 0.7, 1.0).u, 1.0 + 0.5 * f64::exp(-0.7), epsilon = 1e-15);
        let cube = slide(1.5, 0.7, 0.7, 3.0);
        let w: f64 = (4.0f64 + 1.4).powf(-0.5);
        assert_abs_diff_eq!(cube.u - 1.0, w, epsilon = 1e-15);
        // For i = 3 the integral of w is 1 / w(end) - 1 / w(0).
        assert_abs_diff_eq!(cube.area - 0.7, 1.0 / w - 2.0, epsilon = 1e-14);
    }

    /// Any distance, at any kappa and i, in one piece and in two.
    #[test]
    fn two_halves_are_one_slide() {
        for exponent in [1.0, 3.0, 9.0] {
            for kappa in [1e-3, 0.3, 0.7, 0.99, 1.0 - 1e-9, 1.0] {
                for q in [1e-9, 1e-3, 0.3, 2.0, 40.0, 1e6, 1e15] {
                    for start in [-1.0, 0.2, 0.8, 0.995, 1.3] {
                        let whole = slide(start, q, kappa, exponent);
                        let half = slide(start, 0.5 * q, kappa, exponent);
                        let rest = slide(half.u, 0.5 * q, kappa, exponent);
                        let what = format!("{exponent} {kappa} {q} {start}");
                        assert!((whole.u - rest.u).abs() < 1e-11, "{what}: {} {}", whole.u, rest.u);
                        let area = half.area + rest.area;
                        assert!((whole.area - area).abs() < 1e-11 * area.abs().max(1.0), "{what}");
                    }
                }
            }
        }
    }

    /// kappa = 1: elastic up to z_ss, then sliding at the level.
    #[test]
    fn without_transition_the_contact_is_elastic_and_perfectly_plastic() {
        for (q, u) in [(0.4, 0.4), (0.999, 0.999), (1.0, 1.0), (5.0, 1.0)] {
            assert_eq!(slide(0.0, q, 1.0, 1.0).u, u);
        }
        assert_eq!(slide(0.0, 5.0, 1.0, 1.0).area, 4.5);
    }

    #[test]
    fn even_exponents_are_refused() {
        let law = ElastoPlastic { plastic_exponent: 2.0, ..Default::default() };
        assert_eq!(law.check().unwrap_err().0, "plastic_exponent = 2: must be odd");
    }

    /// From full stiction a jump to 0.1 m/s: as LuGre, f_s + sigma_1 v (1 - f_s / f_C) + sigma_2 v.
    #[test]
    fn velocity_dependent_damping_removes_the_spike() {
        let mut printed = ElastoPlastic { velocity: 0.1, bristle_deflection: 1.4715e-5, ..Default::default() };
        let mut faded = ElastoPlastic { damping_velocity: 0.001, ..printed };
        printed.output();
        assert!((printed.friction_force + 14.33).abs() < 0.01, "{}", printed.friction_force);
        faded.output();
        assert!((faded.friction_force - 1.4815).abs() < 1e-9, "{}", faded.friction_force);
    }
}
