//! Parameters of the thesis' Tables 6.1 and 7.1, in SI units.

/// Kinetic force f_C.
pub const F_C: f64 = 0.981;
/// Static force f_s.
pub const F_S: f64 = 1.4715;
/// Stribeck velocity v_S.
pub const V_S: f64 = 0.001;
/// Stiffness of the bristles.
pub const SIGMA_0: f64 = 1e5;
/// Damping of the bristles: sqrt(sigma_0).
pub const SIGMA_1: f64 = 316.227_766_016_837_94;
/// Viscous coefficient.
pub const SIGMA_2: f64 = 0.1;

/// Stribeck curve.
pub fn level(velocity: f64) -> f64 {
    F_C + (F_S - F_C) * (-(velocity / V_S).powi(2)).exp()
}
