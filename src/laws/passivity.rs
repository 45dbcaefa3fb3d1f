//! Viscous friction without which the damping of bristles gives back more energy than the contact took.
//!
//! A bristle that an earlier motion has deflected up to the static level is beyond the level of the present speed, by a
//! part r of it, y = 1 + r <= f_s / g(v). Its deflection then shrinks while the contact moves on, dz/dt = -r^i v, and its
//! damping pushes. With the energy of the bristle stored apart, the contact takes the power
//!
//! ```text
//! P = v^2 (sigma_2 - sigma_1(v) r^i) + g(v) |v| y (1 + r^i)
//! ```
//!
//! which is not negative at any speed and deflection if
//!
//! ```text
//! sigma_2 >= max (sigma_1(v) r^i - g(v) y (1 + r^i) / |v|)
//! sigma_2 >= sigma_1 (f_s / f_C - 1)^i               with constant damping: the limit of high speeds
//! ```
//!
//! # Source
//! For LuGre with constant damping: N. Barabanov, R. Ortega, "Necessary and sufficient conditions for passivity of the
//! LuGre friction model", IEEE Transactions on Automatic Control 45 (2000), 830-832, doi:10.1109/9.847131.

use super::stribeck;
use crate::model::GivesBack;
use crate::number::Real;

/// Parameters of bristles with a Stribeck curve.
pub struct Bristles {
    /// mu_k and mu_s.
    pub coefficients: [f64; 2],
    /// f_n.
    pub normal_force: f64,
    /// v_S and its exponent.
    pub fall: [f64; 2],
    /// sigma_1.
    pub damping: f64,
    /// Speed at which sigma_1 fades; 0 for none.
    pub damping_velocity: f64,
    /// i.
    pub exponent: f64,
}

impl Bristles {
    /// Least viscous coefficient with which the contact is passive at constant load.
    pub fn least_viscous(&self) -> f64 {
        let [mu_k, mu_s] = self.coefficients;
        if self.damping_velocity == 0.0 {
            return self.damping * Real::powf(mu_s / mu_k - 1.0, self.exponent);
        }
        // Beyond three times the speed the damping is less than 2e-4 of what it was.
        let fastest = 3.0 * self.damping_velocity;
        let near = self.search([1e-4 * fastest, fastest]).1;
        self.search(near).0
    }

    /// Largest answer of [`Bristles::least_at`] at some speeds between these, and the speeds beside it.
    fn search(&self, [slowest, fastest]: [f64; 2]) -> (f64, [f64; 2]) {
        const PARTS: i32 = 200;
        let speed = |part: i32| slowest * Real::powf(fastest / slowest, f64::from(part) / f64::from(PARTS));
        let answers = (0..=PARTS).map(|part| (self.least_at(speed(part)), part));
        let (most, part) = answers.fold((0.0, 0), |most, one| if one.0 > most.0 { one } else { most });
        (most, [speed((part - 1).max(0)), speed((part + 1).min(PARTS))])
    }

    fn least_at(&self, speed: f64) -> f64 {
        let ([mu_k, mu_s], [v_s, delta]) = (self.coefficients, self.fall);
        let mu = stribeck::level(speed, mu_k, mu_s, v_s, delta);
        let level = mu * self.normal_force;
        let u = speed / self.damping_velocity;
        let damping = self.damping * Real::exp(-(u * u));
        let beyond = self.most_pushing(damping * speed / level, mu_s / mu - 1.0);
        let back = Real::powf(beyond, self.exponent);
        damping * back - level * (1.0 + beyond) * (1.0 + back) / speed
    }

    /// The r up to `largest` at which d r^i - (1 + r) (1 + r^i) is largest: there i (d - 1) = r^(1 - i) + (i + 1) r, whose
    /// right side is convex. Newton's method comes from above to the larger solution, that of the maximum.
    fn most_pushing(&self, d: f64, largest: f64) -> f64 {
        let i = self.exponent;
        let mut r = largest.min((i * (d - 1.0) / (i + 1.0)).max(0.0));
        for _ in 0..20 {
            let excess = Real::powf(r, 1.0 - i) + (i + 1.0) * r - i * (d - 1.0);
            let slope = i + 1.0 - (i - 1.0) * Real::powf(r, -i);
            if !(excess > 0.0 && slope > 0.0) {
                break;
            }
            r = (r - excess / slope).max(0.0);
        }
        r
    }

    /// Finding about a viscous coefficient: none if it is large enough.
    pub fn gives_back(&self, viscous_coefficient: f64) -> Option<GivesBack> {
        least_viscous(viscous_coefficient, self.least_viscous())
    }
}

/// The method `passivity` of a model whose bristles have a Stribeck curve and this exponent i.
macro_rules! names_least_viscous {
    (|$law:ident| $exponent:expr) => {
        fn passivity(&self) -> Option<$crate::model::GivesBack> {
            let $law = self;
            let bristles = $crate::laws::passivity::Bristles {
                coefficients: [self.mu_k, self.mu_s],
                normal_force: self.normal_force,
                fall: [self.stribeck_velocity, self.stribeck_exponent],
                damping: self.sigma_1,
                damping_velocity: self.damping_velocity,
                exponent: $exponent,
            };
            bristles.gives_back(self.viscous_coefficient)
        }
    };
}
pub(crate) use names_least_viscous;

/// Finding about a viscous coefficient: none if it is not below the least one.
pub fn least_viscous(viscous_coefficient: f64, least: f64) -> Option<GivesBack> {
    // The least one is not a number if both coefficients are 0.
    (viscous_coefficient < least).then_some(GivesBack::Damping { viscous_coefficient, least })
}

/// Finding about a static level above the kinetic one, which lets the law give back more energy than it took.
pub fn equal_levels(mu_s: f64, mu_k: f64) -> Option<GivesBack> {
    (mu_s > mu_k).then_some(GivesBack::Level { mu_s, mu_k })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bristles(damping_velocity: f64) -> Bristles {
        Bristles {
            coefficients: [0.1, 0.15],
            normal_force: 10.0,
            fall: [1e-3, 2.0],
            damping: 316.0,
            damping_velocity,
            exponent: 1.0,
        }
    }

    #[test]
    fn constant_damping_needs_its_share_of_the_excess() {
        assert!((bristles(0.0).least_viscous() - 158.0).abs() < 1e-12);
        assert!((Bristles { exponent: 3.0, ..bristles(0.0) }.least_viscous() - 39.5).abs() < 1e-12);
        assert_eq!(bristles(0.0).gives_back(bristles(0.0).least_viscous()), None);
        let text = "viscous_coefficient = 0.1: below 158 the damping of the bristles can give back more energy than the \
                    contact took";
        assert_eq!(bristles(0.0).gives_back(0.1).unwrap().fault().0, text);
        assert_eq!(Bristles { coefficients: [0.0, 0.0], ..bristles(0.0) }.gives_back(0.1), None);
    }

    /// Against all of many speeds and deflections, also far beyond the level of the motion.
    #[test]
    fn damping_that_fades_needs_what_the_worst_speed_and_deflection_need() {
        for (exponent, mu_s, v_s) in [(1.0, 0.15, 1e-3), (1.0, 0.9, 1e-5), (3.0, 0.4, 0.05), (9.0, 0.3, 1e-4)] {
            let fall = [v_s, 2.0];
            let bristles = Bristles { coefficients: [0.1, mu_s], fall, exponent, ..bristles(0.3) };
            let least_of = |speed: f64, share: f64| {
                let mu = 0.1 + (mu_s - 0.1) * (-(speed / v_s) * (speed / v_s)).exp();
                let r = share * (mu_s / mu - 1.0);
                let damping = 316.0 * (-(speed / 0.3) * (speed / 0.3)).exp();
                damping * r.powf(exponent) - 10.0 * mu * (1.0 + r) * (1.0 + r.powf(exponent)) / speed
            };
            let speeds = (1..=800).map(|k| 0.9 * f64::from(k) / 800.0);
            let all = speeds.flat_map(|speed| (1..=400).map(move |k| (speed, f64::from(k) / 400.0)));
            let needed = all.map(|(speed, share)| least_of(speed, share)).fold(0.0, f64::max);
            let least = bristles.least_viscous();
            assert!(needed > 1.0 && (needed..1.0001 * needed).contains(&least), "{exponent}: {least} {needed}");
        }
    }

    /// Damping that fades at the Stribeck velocity has faded before it pushes; one that fades at 1 m/s has not.
    #[test]
    fn damping_that_fades_early_needs_nothing() {
        assert_eq!(bristles(1e-3).least_viscous(), 0.0);
        let late = bristles(1.0).least_viscous();
        assert!((100.0..158.0).contains(&late), "{late}");
        assert!((bristles(1e5).least_viscous() / 158.0 - 1.0).abs() < 1e-3);
    }
}
