//! Friction force models, one per file.
//!
//! Sign: `velocity` is that of body 1 relative to body 2; `friction_force` is the resistance and has the sign of
//! `velocity` when sliding. Body 1 feels `-friction_force`, body 2 feels `+friction_force`. `external_force` is the
//! resultant of all other tangential forces on body 1.

crate::catalogue::family! {
    coulomb_stiction::CoulombStiction,
    karnopp::Karnopp,
    brown_mcphee::BrownMcPhee,
    dahl::Dahl,
    lugre::LuGre,
    maxwell_slip::MaxwellSlip,
    leuven::Leuven,
    gonthier::Gonthier,
    liang::Liang,
    lugre_planar::LuGrePlanar,
    elasto_plastic_planar::ElastoPlasticPlanar,
}

mod elements;
mod time_stepping;

use crate::model::Fault;

/// The rule between the two coefficients that every model with stiction has.
fn static_not_below_kinetic(mu_s: f64, mu_k: f64) -> Result<(), Fault> {
    if mu_s < mu_k {
        return Err(Fault(format!("mu_s = {mu_s}: must be >= mu_k = {mu_k}")));
    }
    Ok(())
}
