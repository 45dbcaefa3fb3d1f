//! Parameters that let a model give back more energy than it took from a motion, and values with which it does not.

use crate::table::{Brief, Fault};

/// Reason why a model can give back more energy than it took from a motion.
#[derive(Clone, Debug, PartialEq)]
pub enum GivesBack {
    /// Damping of bristles with this viscous coefficient; from `least` on the model is passive.
    Damping {
        /// Viscous coefficient.
        viscous_coefficient: f64,
        /// Least viscous coefficient with which the model is passive; infinite: no coefficient suffices.
        least: f64,
    },
    /// A static level above the kinetic one.
    Level {
        /// Static coefficient of friction.
        mu_s: f64,
        /// Kinetic one.
        mu_k: f64,
    },
    /// Another reason, in words.
    Said(Fault),
}

impl GivesBack {
    /// The text of a model that has the variables of a law.
    pub(crate) fn fault(self) -> Fault {
        match self {
            GivesBack::Damping { least: f64::INFINITY, .. } => Fault::new(
                "mu_k = 0: at high speeds the damping of the bristles can give back more energy than the contact took",
            ),
            GivesBack::Damping { viscous_coefficient, least } => {
                damping("viscous_coefficient", viscous_coefficient, least)
            }
            GivesBack::Level { mu_s, mu_k } => level(["mu_s", "mu_k"], [mu_s, mu_k]),
            GivesBack::Said(fault) => fault,
        }
    }
}

/// Names a viscous coefficient that is below the least one.
pub(crate) fn damping(name: &str, value: f64, least: f64) -> Fault {
    let [value, least] = [value, rounded_up(least)].map(Brief);
    Fault::new(format_args!(
        "{name} = {value}: below {least} the damping of the bristles can give back more energy than the contact took"
    ))
}

/// Names a static level that is above the kinetic one.
pub(crate) fn level([of_static, of_kinetic]: [&str; 2], values: [f64; 2]) -> Fault {
    let [highest, kinetic] = values.map(Brief);
    Fault::new(format_args!(
        "{of_static} = {highest}: above {of_kinetic} = {kinetic} a level that rises can give back more energy than the \
         contact took"
    ))
}

/// The next larger number of six digits, of one that is positive.
fn rounded_up(value: f64) -> f64 {
    if !(1e-300..1e300).contains(&value) {
        return value;
    }
    let mut scale = 1.0;
    while value * scale < 1e5 {
        scale *= 10.0;
    }
    while value * scale >= 1e6 {
        scale *= 0.1;
    }
    (value * scale).ceil() / scale
}
