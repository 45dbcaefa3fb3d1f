//! Conditions on the parameters of a contact, and on its state of sticking.

use crate::model::Fault;
use crate::number::Real;

/// Condition on the two coefficients in every model with stiction.
pub(crate) fn static_not_below_kinetic(mu_s: f64, mu_k: f64) -> Result<(), Fault> {
    not_below(("mu_s", mu_s), ("mu_k", mu_k))
}

/// Condition on a static and a kinetic coefficient with names of their own.
pub(crate) fn not_below((of, mu_s): (&str, f64), (over, mu_k): (&str, f64)) -> Result<(), Fault> {
    if mu_s < mu_k {
        return Err(Fault::new(format_args!("{of} = {mu_s}: must be >= {over} = {mu_k}")));
    }
    Ok(())
}

/// Refuses elements that are together weaker than the static level.
pub(crate) fn carries_static_level(hysteresis_strength: f64) -> Result<(), Fault> {
    if hysteresis_strength < 1.0 {
        let rule = "must be >= 1, because the elements together must carry the static level";
        return Err(Fault::new(format_args!("hysteresis_strength = {hysteresis_strength}: {rule}")));
    }
    Ok(())
}

/// Condition of laws with bristles in Model Exchange. Where the level is 0 the bristles carry nothing; a step drops
/// their deflection there, but a solver that integrates it would keep its force.
pub(crate) fn kinetic_friction_for_exchange(mu_k: f64) -> Result<(), Fault> {
    if mu_k == 0.0 {
        let why = "must be > 0 in Model Exchange, where bristles are not released when their level falls to 0";
        return Err(Fault::new(format_args!("mu_k = {mu_k}: {why}")));
    }
    Ok(())
}

/// Share of the motion that is elastic above which a contact with bristles counts as sticking (chosen).
pub(crate) const ELASTIC_SHARE: f64 = 0.01;

/// Whether a bristle still moves with the surface, as its rate of deflection shows.
#[inline(always)]
pub(crate) fn is_elastic<T: Real>(deflection_rate: T, velocity: T) -> T::Mask {
    let is_moved = (deflection_rate * velocity.sign()).above(T::from(ELASTIC_SHARE) * velocity.abs());
    velocity.vanishes() | is_moved
}
