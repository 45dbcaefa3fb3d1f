//! Friction force models, one per file.
//!
//! Sign: `velocity` is that of body 1 relative to body 2; `friction_force` is the resistance and has the sign of
//! `velocity` when sliding. Body 1 feels `-friction_force`, body 2 feels `+friction_force`. `external_force` is the
//! resultant of all other tangential forces on body 1 or, if body 2 accelerates too, the effective mass times the
//! relative acceleration that they cause; see the section Coupling of the laws that have it.

// The choice of a law in the shock absorber is numbered in this order: a new law goes to the end.
crate::model::family! {
    coulomb::Coulomb,
    coulomb_stiction::CoulombStiction,
    coulomb_viscous::CoulombViscous,
    stribeck::Stribeck,
    bernard::Bernard,
    threlfall::Threlfall,
    threlfall_modified::ThrelfallModified,
    rooney_deravi::RooneyDeravi,
    ambrosio::Ambrosio,
    karnopp::Karnopp,
    bengisu_akay::BengisuAkay,
    hollars::Hollars,
    andersson::Andersson,
    awrejcewicz::Awrejcewicz,
    specker::Specker,
    linear_stiction::LinearStiction,
    brown_mcphee::BrownMcPhee,
    dahl::Dahl,
    lugre::LuGre,
    frictional_lag::FrictionalLag,
    armstrong::Armstrong,
    non_reversible::NonReversible,
    wojewoda::Wojewoda,
    bliman_sorine::BlimanSorine,
    reset_integrator::ResetIntegrator,
    dankowicz::Dankowicz,
    elasto_plastic::ElastoPlastic,
    bristle::Bristle,
    specker_dynamic::SpeckerDynamic,
    maxwell_slip::MaxwellSlip,
    leuven::Leuven,
    gonthier::Gonthier,
    liang::Liang,
    lugre_planar::LuGrePlanar,
    elasto_plastic_planar::ElastoPlasticPlanar,
    rolling_resistance::RollingResistance,
    directional_stribeck::DirectionalStribeck,
    joint_friction::JointFriction,
    rate_and_state::RateAndState,
    cylinder_friction::CylinderFriction,
}

// What a parameter is for decides its carrier in a strut and its range in a fit: a law that does not say it does not
// compile.
const _: () = {
    let mut law = 0;
    while law < TABLES.len() {
        assert!(crate::model::is_declared(TABLES[law]), "a parameter of a law has no meaning: see Column::means");
        law += 1;
    }
};
