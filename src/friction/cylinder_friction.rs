use crate::contact::conditions::is_elastic;
use crate::contact::quantities::*;
use crate::contact::unloading::released_without_load;
use crate::laws::{passivity, stribeck};
use crate::model::{Derivatives, Fault, GivesBack, Law, Meaning, Model, ModelExchange, Preset, real};
use crate::number::elementary::{exp, exp_m1, hypot, ln, ln_1p};
use crate::number::{Real, choose};
use crate::numerics::relaxation;

crate::model! {
    /// Friction of a hydraulic or pneumatic cylinder: bristles with the Stribeck effect (LuGre) beside a lubricant film
    /// that needs time to form and to leave, which gives hysteresis in the range of mixed lubrication.
    ///
    /// # Equations
    ///
    /// ```text
    /// dz/dt = v - sigma_0 |v| z / g(v, h)
    /// g     = F_c + ((1 - h) F_s - F_c) exp(-(|v| / v_s)^n)
    /// F_r   = sigma_0 z + sigma_1 dz/dt + sigma_2 v
    /// F_c   = mu_k f_n,   F_s = mu_s f_n
    ///
    /// dh/dt = (h_ss - h) / tau_h
    /// h_ss  = K_f min(|v|, v_b)^(2/3),   K_f = (1 - F_c / F_s) v_b^(-2/3)
    /// tau_h = tau_h0 if v = 0, else tau_hp if h <= h_ss, else tau_hn
    /// ```
    ///
    /// | symbol  | variable                    | unit  | meaning                                                  |
    /// |---------|-----------------------------|-------|----------------------------------------------------------|
    /// | v       | `velocity`                  | m/s   | velocity of body 1 relative to body 2                    |
    /// | f_n     | `normal_force`              | N     | force pressing the surfaces together                     |
    /// | mu_k    | `mu_k`                      | 1     | kinetic coefficient of friction                          |
    /// | mu_s    | `mu_s`                      | 1     | static coefficient of friction                           |
    /// | v_s     | `stribeck_velocity`         | m/s   | speed at which the level has fallen                      |
    /// | n       | `stribeck_exponent`         | 1     | shape of the Stribeck curve                              |
    /// | v_b     | `film_velocity`             | m/s   | speed from which on the film grows no further            |
    /// | tau_hp  | `film_growth_time_constant` | s     | time constant of a film that grows                       |
    /// | tau_hn  | `film_decay_time_constant`  | s     | time constant of a film that thins in motion             |
    /// | tau_h0  | `film_rest_time_constant`   | s     | time constant of a film that is squeezed out at rest     |
    /// | sigma_0 | `sigma_0`                   | N/m   | stiffness of the bristles                                |
    /// | sigma_1 | `sigma_1`                   | N.s/m | damping of the bristles                                  |
    /// | sigma_2 | `viscous_coefficient`       | N.s/m | viscous coefficient                                      |
    /// | z       | `bristle_deflection`        | m     | mean deflection of the bristles                          |
    /// | h       | `film_thickness`            | 1     | thickness of the film, 0 = dry, 1 = carries all the load |
    /// | F_r     | `friction_force`            | N     | friction force                                           |
    ///
    /// Of a joint that turns the velocities are in rad/s, the deflection is in rad, forces are torques in N.m.
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` in steady sliding; body 1 feels `-friction_force`. Dissipated power
    /// is `friction_force * velocity`; it is negative while the bristles spring back.
    ///
    /// # Step
    /// With held inputs $h$ relaxes exponentially, and with it the level $g$. Over the slip $q$, the integral of
    /// $sigma_0 |v| / g$ over time, which has a closed form, the force $y = sigma_0 |z|$ follows $dy/dq = g - y$, where
    /// $g$ is a logistic function of $q$. It is taken as its Taylor polynomial of degree 24 over a quarter of the radius
    /// of convergence, for which $y$ and the work of the bristles have closed forms. The result depends on how an
    /// interval is divided by less than 1e-12, from 1 us to hours. `sticking` means that more than 1 % (chosen) of the
    /// motion still goes into the bristles.
    ///
    /// A master that integrates the body itself has the same limits of the communication step as with `LuGre`.
    ///
    #[doc = include_str!("slopes.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`.
    ///
    /// # Limits
    /// Steady sliding has $h = h_ss$: the level lies below that of `LuGre`, by $h_ss F_s exp(-(|v| / v_s)^n)$. On an
    /// oscillation around a mean speed the film is too thin on the way up and too thick on the way down, so that the
    /// force rising is above the force falling. With $v_b$ far above every speed, or `mu_s` = `mu_k`, no film forms, and
    /// the law is `LuGre`. Since $h_ss <= 1 - F_c / F_s$, the level stays between $F_c$ and $F_s$, unless $h$ is set to more.
    /// $mu_k = 0$ is refused: $g$ would vanish. `film_rest_time_constant` counts at a velocity of exactly 0, which a
    /// prescribed motion has; a body that bristles hold still creeps, and its film leaves with
    /// `film_decay_time_constant`.
    ///
    /// Passive for every motion at constant load only if $sigma_2 >= sigma_1 (F_s - F_c) / F_c$, as `LuGre`: at high
    /// speed the film does not matter. Drifts under a load that cycles below breakaway. `normal_force` = 0 releases the
    /// contact: force, deflection and film 0.
    ///
    /// # Source
    /// X. B. Tran, N. Hafizah, H. Yanada, "Modeling of dynamic friction behaviors of hydraulic cylinders", Mechatronics
    /// 22 (2012) 65-75, with the film of H. Yanada, Y. Sekikawa, "Modeling of dynamic behaviors of friction", Mechatronics
    /// 18 (2008) 330-339. The paper has the viscous part $sigma_2 (v + T dv/dt)$. The force $sigma_2 T dv/dt$ is that of a
    /// mass $sigma_2 T$, which is to be added to the mass of the body: here $T = 0$. There the levels are forces; here they
    /// carry the normal force. Levels, $v_s$, $sigma_0$ and $sigma_1$ start as those of `LuGre`; $v_b$ and the time
    /// constants are chosen, and so are the values of the preset: those of the paper were not at hand.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::CylinderFriction;
    /// use stribeck::model::{Law, Model};
    /// let mut law = CylinderFriction { velocity: 0.002, normal_force: 10.0, ..Default::default() };
    /// law.output(); // dry: F_s = 1.5 N, F_c = 1 N, nothing deflected
    /// law.step(10.0); // at v_b the film is full: (1 - h) F_s = F_c
    /// law.output();
    /// assert!((law.film_thickness - 1.0 / 3.0).abs() < 1e-12);
    /// assert!((law.friction_force - (1.0 + 0.1 * 0.002)).abs() < 1e-12);
    /// ```
    CylinderFriction: "Friction of a cylinder with a lubricant film that needs time (Tran and Yanada)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        mu_k: tunable = MU_K.positive(),
        mu_s: tunable = MU_S,
        stribeck_velocity: tunable = STRIBECK_VELOCITY,
        stribeck_exponent: tunable = STRIBECK_EXPONENT,
        /// Speed from which on the film grows no further (default chosen).
        film_velocity: tunable = real("m/s", 0.002).positive().shown_in("mm/s").means(Meaning::Own),
        /// Time constant of a film that grows (default chosen).
        film_growth_time_constant: tunable = real("s", 0.05).positive().means(Meaning::Own),
        /// Time constant of a film that thins in motion (default chosen).
        film_decay_time_constant: tunable = real("s", 0.2).positive().means(Meaning::Own),
        /// Time constant of a film that is squeezed out at rest (default chosen).
        film_rest_time_constant: tunable = real("s", 20.0).positive().means(Meaning::Own),
        sigma_0: tunable = SIGMA_0,
        sigma_1: tunable = SIGMA_1,
        viscous_coefficient: tunable = VISCOUS_COEFFICIENT.start(0.1),
        bristle_deflection: state = BRISTLE_DEFLECTION.reinit(),
        /// Thickness of the lubricant film: 0 = dry, 1 = carries all the load.
        film_thickness: state = real("1", 0.0).at_least(0.0).at_most(1.0).reinit(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> CylinderFriction<T> {
    /// h_ss.
    fn steady_film(&self) -> T {
        let one = T::from(1.0);
        let u = self.velocity.abs() / self.film_velocity;
        // The slope of the root at rest is infinite; there the film only leaves.
        let share = choose!(u.vanishes(), T::zero(), choose!(u.at_least(one), one, u.powf(T::from(2.0 / 3.0))));
        (one - self.mu_k / self.mu_s) * share
    }

    /// tau_h.
    fn film_time(&self, steady: T) -> T {
        choose!(
            self.velocity.vanishes(),
            self.film_rest_time_constant,
            choose!(self.film_thickness.at_most(steady), self.film_growth_time_constant, self.film_decay_time_constant)
        )
    }

    /// exp(-(|v| / v_s)^n).
    fn fall(&self) -> T {
        stribeck::level(self.velocity, T::zero(), T::from(1.0), self.stribeck_velocity, self.stribeck_exponent)
    }

    /// g / f_n at a thickness of the film.
    fn coefficient(&self, film: T, fall: T) -> T {
        self.mu_k + ((T::from(1.0) - film) * self.mu_s - self.mu_k) * fall
    }

    /// g at a thickness of the film.
    fn level(&self, film: T) -> T {
        self.coefficient(film, self.fall()) * self.normal_force
    }

    /// dz/dt.
    fn deflection_rate(&self) -> T {
        let level = self.level(self.film_thickness);
        choose!(
            level.vanishes(),
            T::zero(),
            self.velocity - self.sigma_0 * self.velocity.abs() * self.bristle_deflection / level
        )
    }

    fn film_rate(&self) -> T {
        let steady = self.steady_film();
        choose!(self.normal_force.vanishes(), T::zero(), (steady - self.film_thickness) / self.film_time(steady))
    }

    fn force(&self, deflection_rate: T) -> T {
        choose!(
            self.normal_force.vanishes(),
            T::zero(),
            self.sigma_0 * self.bristle_deflection
                + self.sigma_1 * deflection_rate
                + self.viscous_coefficient * self.velocity
        )
    }

    /// The outputs. Returns dz/dt.
    fn respond(&mut self) -> T {
        let rate = self.deflection_rate();
        self.friction_force = self.force(rate);
        self.dissipated_power = self.friction_force * self.velocity;
        self.sticking = T::truth(is_elastic(rate, self.velocity) & self.normal_force.is_positive());
        rate
    }
}

impl<T: Real> Law for CylinderFriction<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.respond();
    }

    fn slide_steadily(&mut self) {
        let is_loaded = self.normal_force.is_positive();
        let film = self.steady_film();
        let moving = self.velocity.sign() * self.level(film) / self.sigma_0;
        let kept = choose!(self.velocity.vanishes(), self.bristle_deflection, moving);
        self.bristle_deflection = choose!(is_loaded, kept, T::zero());
        self.film_thickness = choose!(is_loaded, film, T::zero());
    }
}

impl<T: Real> Derivatives for CylinderFriction<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.bristle_deflection = self.deflection_rate();
        rate.film_thickness = self.film_rate();
        rate.dissipated_energy = self.force(rate.bristle_deflection) * self.velocity;
    }

    fn output_and_derivatives(&mut self, rate: &mut Self) {
        rate.bristle_deflection = self.respond();
        rate.film_thickness = self.film_rate();
        rate.dissipated_energy = self.dissipated_power;
    }
}

impl CylinderFriction {
    /// Advances the states, and the energy if it `counts`.
    fn advance(&mut self, dt: f64, counts: bool) {
        if self.normal_force == 0.0 {
            (self.bristle_deflection, self.film_thickness) = (0.0, 0.0);
            return;
        }
        let steady = self.steady_film();
        let film = relaxation::after(self.film_thickness, steady, dt / self.film_time(steady)).clamp(0.0, 1.0);
        if self.velocity != 0.0 {
            let [change, work] = self.slide(film, dt, counts);
            self.bristle_deflection += change;
            if counts {
                let viscous = self.viscous_coefficient * self.velocity * dt;
                self.dissipated_energy += work + self.velocity * (self.sigma_1 * change + viscous);
            }
        }
        self.film_thickness = film;
    }

    /// Change of the deflection in a time at the end of which the film is `film`, and, if it `counts`, the work of the force
    /// sigma_0 z.
    fn slide(&self, film: f64, time: f64, counts: bool) -> [f64; 2] {
        let steady_film = self.steady_film();
        // It is costly, and the same for both.
        let fall = self.fall();
        let coefficients = [self.film_thickness, steady_film].map(|film| self.coefficient(film, fall));
        let [level, steady] = coefficients.map(|coefficient| coefficient * self.normal_force);
        if level == 0.0 || steady == 0.0 {
            return [-self.bristle_deflection, 0.0];
        }
        let (direction, distance) = (self.velocity.signum(), self.velocity.abs() * time);
        if film == self.film_thickness {
            let decay = self.sigma_0 * distance / level;
            let target = direction * level / self.sigma_0;
            let change = relaxation::after(self.bristle_deflection, target, decay) - self.bristle_deflection;
            return [change, direction * level * (direction * distance - change)];
        }
        let film_time = self.film_time(steady_film);
        let [now, then] = coefficients;
        let mut course = Course {
            level: now / then,
            excess: (steady_film - self.film_thickness) * self.mu_s * fall / then,
            missing: direction * self.sigma_0 * self.bristle_deflection / steady - 1.0,
            change: 0.0,
            counts,
            work: 0.0,
        };
        let (excess, part) = (course.excess, -exp_m1(-time / film_time));
        // The film's time, measured by the level: g / g_ss is a logistic function of it.
        let log_time = time / film_time + ln_1p(-part * excess / course.level);
        course.run(log_time, self.sigma_0 * self.velocity.abs() * film_time / steady);
        let impulse = steady * (time + excess * film_time * part);
        let change = direction * steady * course.change / self.sigma_0;
        let work = self.velocity.abs() * impulse - steady * steady * (course.change + course.work) / self.sigma_0;
        [change, work]
    }
}

impl Model for CylinderFriction {
    const STEADY_SLIDING: bool = true;
    const PRESETS: &'static [Preset] = &[Preset {
        name: "hydraulic_cylinder",
        source: "Example of a hydraulic cylinder: 60 N at breakaway, 30 N of seals sliding, at a contact force of 300 N",
        values: &[
            ("normal_force", 300.0),
            ("mu_s", 0.2),
            ("stribeck_velocity", 0.015),
            ("film_velocity", 0.03),
            ("film_growth_time_constant", 0.1),
            ("sigma_0", 1e7),
            ("sigma_1", 300.0),
            ("viscous_coefficient", 300.0),
        ],
    }];

    released_without_load!(bristle_deflection, film_thickness);

    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    fn passivity(&self) -> Option<GivesBack> {
        // The level without a film at the static level, that at high speed with any film.
        passivity::least_viscous(self.viscous_coefficient, self.sigma_1 * (self.mu_s / self.mu_k - 1.0))
    }

    fn kinks(&self) -> [f64; 2] {
        [self.film_velocity, 0.0]
    }

    fn step(&mut self, dt: f64) {
        self.advance(dt, true);
    }

    fn step_without_energy(&mut self, _memory: &mut [f64], dt: f64) {
        self.advance(dt, false);
    }
}

/// Degree of the polynomials.
const DEGREE: usize = 24;

/// Length of a piece, relative to the radius of convergence: what is left out is less than 4e-15 of the excess.
const SHARE: f64 = 0.25;

/// Slip up to which the series of an exponential of it converges within that degree, and from which on the other form
/// keeps its digits (24! / 10^24 < 1).
const LONG: f64 = 2.5;

/// Excess below which a level has arrived, and time of the film after which every level has: from the smallest positive
/// number in 709.
const ARRIVED: f64 = 1e-17;
const LATEST: f64 = 800.0;

/// 1 / n.
const RECIPROCALS: [f64; 2 * DEGREE + 1] = {
    let mut reciprocals = [0.0; 2 * DEGREE + 1];
    let mut n = 1;
    while n <= 2 * DEGREE {
        reciprocals[n] = 1.0 / n as f64;
        n += 1;
    }
    reciprocals
};

/// Part of the first terms of a series that a term may have to be left out.
const NEGLIGIBLE: f64 = 1e-18;

/// A polynomial in the share of a piece; terms beyond its degree are 0.
struct Polynomial {
    terms: [f64; DEGREE + 1],
    degree: usize,
}

/// Degree behind which the terms of a series fall below [`NEGLIGIBLE`], for a piece relative to the radius of convergence.
fn degree(share: f64) -> usize {
    ((ln(NEGLIGIBLE) / ln(share)) as usize + 1).min(DEGREE)
}

/// A bristle force y that follows a level g, both relative to the level g_ss to which the film leads:
///
/// ```text
/// d  = g / g_ss - 1,   d'  = -d (1 + d)
/// e  = y / g_ss - 1,   e'  = r (d - e)
/// ```
///
/// The time is that of the film, and r its ratio to the slip.
struct Course {
    /// 1 + d.
    level: f64,
    /// d.
    excess: f64,
    /// e.
    missing: f64,
    /// Change of e since the beginning.
    change: f64,
    /// Whether the work is asked for.
    counts: bool,
    /// Integral of d over e.
    work: f64,
}

impl Course {
    fn run(&mut self, time: f64, slip: f64) {
        let mut left = time.min(LATEST);
        while left > 0.0 && self.excess.abs() > ARRIVED {
            let piece = left.min(SHARE * self.radius());
            self.advance(piece, piece * slip);
            left -= piece;
        }
        let left = left + (time - time.min(LATEST));
        if left > 0.0 {
            self.follow(self.missing * exp_m1(-left * slip), 0.0);
        }
    }

    /// Distance of the nearest pole of d: of 1 / (exp(t + ln((1 + d) / d)) - 1).
    fn radius(&self) -> f64 {
        if self.excess > 0.0 {
            return ln_1p(1.0 / self.excess);
        }
        hypot(ln(-self.level / self.excess), std::f64::consts::PI)
    }

    fn follow(&mut self, change: f64, work: f64) {
        self.missing += change;
        self.change += change;
        self.work += work;
    }

    fn advance(&mut self, piece: f64, slip: f64) {
        let excess = self.series_of_excess(piece);
        if slip < LONG {
            let missing = self.series_of_missing(&excess, slip);
            self.follow(rise(&missing), self.area(&excess, &missing));
        } else {
            // The polynomial p that solves it, and what decays: e = p + c exp(-slip s).
            let smooth = sum_of_derivatives(&excess, -1.0 / slip);
            let decaying = self.missing - smooth.terms[0];
            let lost = if self.counts { decayed(&excess, slip) } else { 0.0 };
            let work = self.area(&excess, &smooth) - decaying * lost;
            self.follow(rise(&smooth) + decaying * exp_m1(-slip), work);
        }
        let rise = rise(&excess);
        self.level += rise;
        self.excess += rise;
    }

    /// Integral of p q' over a piece, if the work is asked for.
    fn area(&self, p: &Polynomial, q: &Polynomial) -> f64 {
        if self.counts { area(p, q) } else { 0.0 }
    }

    /// d as a polynomial of the share of the piece.
    fn series_of_excess(&self, piece: f64) -> Polynomial {
        let degree = degree(piece / self.radius());
        let mut series = Polynomial { terms: [0.0; DEGREE + 1], degree };
        let terms = &mut series.terms;
        terms[0] = self.excess;
        for n in 0..degree {
            let product: f64 = (0..n).map(|i| terms[i] * terms[n - i]).sum::<f64>() + terms[n] * self.level;
            terms[n + 1] = -piece * RECIPROCALS[n + 1] * product;
        }
        series
    }

    /// e as a polynomial of the share of a short piece, up to the first term behind those of d that adds nothing.
    fn series_of_missing(&self, excess: &Polynomial, slip: f64) -> Polynomial {
        let mut series = Polynomial { terms: [0.0; DEGREE + 1], degree: 0 };
        let (terms, negligible) = (&mut series.terms, NEGLIGIBLE * (self.missing.abs() + self.excess.abs()));
        terms[0] = self.missing;
        while series.degree < DEGREE && (series.degree <= excess.degree || terms[series.degree].abs() > negligible) {
            let n = series.degree;
            terms[n + 1] = slip * RECIPROCALS[n + 1] * (excess.terms[n] - terms[n]);
            series.degree += 1;
        }
        series
    }
}

/// p(1) - p(0).
fn rise(p: &Polynomial) -> f64 {
    p.terms[1..=p.degree].iter().rev().sum()
}

/// p + c p' + c^2 p'' + ...
fn sum_of_derivatives(p: &Polynomial, c: f64) -> Polynomial {
    let mut sum = Polynomial { ..*p };
    for n in (0..p.degree).rev() {
        sum.terms[n] += c * (n + 1) as f64 * sum.terms[n + 1];
    }
    sum
}

/// Integral of p slip exp(-slip s) over s from 0 to 1.
fn decayed(p: &Polynomial, slip: f64) -> f64 {
    let weights = sum_of_derivatives(p, 1.0 / slip);
    let end: f64 = weights.terms.iter().sum();
    weights.terms[0] - exp(-slip) * end
}

/// Integral of p q' from 0 to 1.
fn area(p: &Polynomial, q: &Polynomial) -> f64 {
    let with = |j: usize| {
        let inner: f64 = (0..=p.degree).map(|i| p.terms[i] * RECIPROCALS[i + j]).sum();
        inner * j as f64 * q.terms[j]
    };
    (1..=q.degree).rev().map(with).sum()
}

#[cfg(test)]
mod tests {
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    use super::*;
    use crate::friction::LuGre;
    use crate::numerics::random::uniform;

    /// Levels of 1 N and 2.5 N, so that films of more and of less than half of the level occur.
    fn law() -> CylinderFriction {
        CylinderFriction { normal_force: 10.0, mu_s: 0.25, ..Default::default() }
    }

    fn slide(law: &mut CylinderFriction, velocity: f64, time: f64) -> f64 {
        law.velocity = velocity;
        law.step(time);
        law.output();
        law.friction_force
    }

    /// As printed, with the functions of the standard library: h_ss, and exp(-(|v| / v_s)^n).
    fn printed(law: &CylinderFriction, v: f64) -> [f64; 2] {
        let k_f = (1.0 - law.mu_k / law.mu_s) * law.film_velocity.powf(-2.0 / 3.0);
        let steady = k_f * v.abs().min(law.film_velocity).powf(2.0 / 3.0);
        [steady, (-(v.abs() / law.stribeck_velocity).powf(law.stribeck_exponent)).exp()]
    }

    fn printed_level(law: &CylinderFriction, h: f64, fall: f64) -> f64 {
        let [f_c, f_s] = [law.mu_k * law.normal_force, law.mu_s * law.normal_force];
        f_c + ((1.0 - h) * f_s - f_c) * fall
    }

    /// No film at any speed, none within 1e300 s, or none because the levels are equal.
    #[test]
    fn without_a_film_it_is_lugre() {
        for (values, mu_s) in [([1e40, 0.05], 0.25), ([0.002, 1e300], 0.25), ([0.002, 0.05], 0.1)] {
            let [film_velocity, film_growth_time_constant] = values;
            let mut cylinder = CylinderFriction { film_velocity, film_growth_time_constant, mu_s, ..law() };
            let mut lugre = LuGre { normal_force: 10.0, mu_s, ..Default::default() };
            for step in 0..300 {
                let [speed, side, time] = [1, 2, 3].map(|sequence| uniform(7, sequence, step));
                let v = if step % 7 == 0 { 0.0 } else { (side - 0.5).signum() * 10f64.powf(-5.0 + 4.0 * speed) };
                lugre.velocity = v;
                lugre.step(0.01 * time);
                lugre.output();
                let force = slide(&mut cylinder, v, 0.01 * time);
                assert_abs_diff_eq!(force, lugre.friction_force, epsilon = 1e-12 * force.abs().max(1.0));
                assert_relative_eq!(cylinder.dissipated_energy, lugre.dissipated_energy, max_relative = 1e-12);
            }
        }
    }

    #[test]
    fn steady_sliding_has_its_film() {
        for v in [1e-7, 3e-5, -1e-3, 1.9e-3, 2e-3, -0.02, 1.0] {
            let mut law = law();
            let force = slide(&mut law, v, 1e4);
            let [film, fall] = printed(&law, v);
            assert_relative_eq!(law.film_thickness, film, max_relative = 1e-14);
            let by_hand = (printed_level(&law, film, fall) + 0.1 * f64::abs(v)) * v.signum();
            assert_relative_eq!(force, by_hand, max_relative = 1e-13);
        }
    }

    /// Growing, thinning and at rest.
    #[test]
    fn a_film_relaxes_with_one_of_three_time_constants() {
        for (v, start, constant) in [(5e-4, 0.0, 0.05), (-5e-4, 0.5, 0.2), (0.0, 0.5, 20.0)] {
            for time in [1e-6, 0.03, 1.0, 50.0] {
                let mut law = CylinderFriction { film_thickness: start, bristle_deflection: 1e-6, ..law() };
                let steady = printed(&law, v)[0];
                slide(&mut law, v, time);
                let by_hand = steady + (start - steady) * (-time / constant).exp();
                assert_relative_eq!(law.film_thickness, by_hand, max_relative = 1e-12);
                assert_eq!(v == 0.0, law.bristle_deflection == 1e-6, "bristles stay as they are only at rest");
            }
        }
    }

    /// One leg by the classical Runge-Kutta method: deflection, film and energy.
    fn integrated(law: &CylinderFriction, time: f64) -> [f64; 3] {
        let v = law.velocity;
        let [steady, fall] = printed(law, v);
        let constants = [law.film_growth_time_constant, law.film_decay_time_constant, law.film_rest_time_constant];
        let constant = if v == 0.0 { constants[2] } else { constants[usize::from(law.film_thickness > steady)] };
        let rates = |[z, h, _]: [f64; 3]| {
            let rate = v - law.sigma_0 * v.abs() * z / printed_level(law, h, fall);
            let force = law.sigma_0 * z + law.sigma_1 * rate + law.viscous_coefficient * v;
            [rate, (steady - h) / constant, force * v]
        };
        let least = printed_level(law, law.film_thickness.max(steady), fall);
        let n = (100.0 * time * (law.sigma_0 * v.abs() / least + 1.0 / constant)).max(2000.0).ceil();
        let step = time / n;
        let mut at = [law.bristle_deflection, law.film_thickness, law.dissipated_energy];
        let moved = |at: [f64; 3], by: [f64; 3], h: f64| std::array::from_fn(|i| at[i] + h * by[i]);
        for _ in 0..n as u64 {
            let k_1 = rates(at);
            let k_2 = rates(moved(at, k_1, 0.5 * step));
            let k_3 = rates(moved(at, k_2, 0.5 * step));
            let k_4 = rates(moved(at, k_3, step));
            at = std::array::from_fn(|i| at[i] + step / 6.0 * (k_1[i] + 2.0 * k_2[i] + 2.0 * k_3[i] + k_4[i]));
        }
        at
    }

    /// Dwells, reversals and jumps of the speed over four decades, in steps of up to 40 slip distances or some time
    /// constants of the film.
    #[test]
    fn steps_agree_with_the_integrated_equations() {
        let mut law = CylinderFriction { film_rest_time_constant: 0.3, stribeck_exponent: 0.7, ..law() };
        for step in 0..200 {
            let [speed, side, time] = [1, 2, 3].map(|sequence| uniform(5, sequence, step));
            let speed = if step % 7 == 0 { 0.0 } else { 10f64.powf(-5.5 + 4.0 * speed) };
            law.velocity = if side < 0.5 { speed } else { -speed };
            let slips = 40.0 * time / (law.sigma_0 * speed / law.level(law.film_thickness));
            let time = slips.min(0.5 * time);
            let [deflection, film, energy] = integrated(&law, time);
            law.step(time);
            assert_abs_diff_eq!(law.bristle_deflection, deflection, epsilon = 1e-9 * 2.5e-5);
            assert_abs_diff_eq!(law.film_thickness, film, epsilon = 1e-9);
            assert_relative_eq!(law.dissipated_energy, energy, max_relative = 1e-9);
        }
    }

    /// Any ratio of film and slip, films that grow and thin, in one piece and in two uneven ones.
    #[test]
    fn two_parts_are_one_step() {
        for v in [1e-9, 1e-6, 2e-4, 1e-3, 0.05, 3.0] {
            for constant in [1e-9, 1e-3, 0.2, 1e4] {
                for (film, deflection) in [(0.0, 0.0), (0.0, -2.5e-5), (0.6, 1e-5), (0.999, 0.0), (0.2, 2.5e-5)] {
                    for time in [1e-6, 1e-3, 0.1, 4.0, 3600.0] {
                        let mut whole = CylinderFriction {
                            velocity: v,
                            film_growth_time_constant: constant,
                            film_decay_time_constant: constant,
                            film_thickness: film,
                            bristle_deflection: deflection,
                            ..law()
                        };
                        let mut parts = whole;
                        whole.step(time);
                        parts.step(0.3 * time);
                        parts.step(0.7 * time);
                        let of = format!("{v} m/s, {constant} s, {film}, {deflection} m, {time} s");
                        let difference = (whole.bristle_deflection - parts.bristle_deflection).abs();
                        assert!(difference < 1e-12 * 2.5e-5, "{of}: {difference} m");
                        let difference = (whole.dissipated_energy - parts.dissipated_energy).abs();
                        let scale = parts.dissipated_energy.abs().max(2.5 * v * time).max(3e-5);
                        assert!(difference < 1e-12 * scale, "{of}: {difference} J");
                    }
                }
            }
        }
    }

    /// A film of 1 leaves nothing at rest for bristles to carry, and the next step drops them.
    #[test]
    fn a_film_that_carries_all_leaves_no_bristle() {
        let mut law = CylinderFriction { film_thickness: 1.0, bristle_deflection: 1e-5, sigma_1: 0.0, ..law() };
        assert_relative_eq!(slide(&mut law, 1e-14, 1e-9), 1e-15, max_relative = 1e-9);
        assert_eq!(law.bristle_deflection, 0.0);
        assert_relative_eq!(law.dissipated_energy, 1e-38, max_relative = 1e-9);
        // With something of the level left it carries that.
        assert_abs_diff_eq!(slide(&mut law, 1e-6, 1e-6), 0.0, epsilon = 1e-3);
        assert!(law.bristle_deflection > 0.0);
    }

    #[test]
    fn a_released_contact_begins_anew() {
        let mut law = law();
        slide(&mut law, 0.1, 1.0);
        law.normal_force = 0.0;
        assert_eq!(slide(&mut law, 0.1, 1e-3), 0.0);
        assert_eq!((law.bristle_deflection, law.film_thickness, law.sticking), (0.0, 0.0, 0.0));
    }
}
