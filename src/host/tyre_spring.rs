//! Coefficients of the vertical spring of a tyre: Magic Formula 6.1 and 6.2.

use crate::model::real;

crate::part! {
    /// Vertical spring and radii of a rolling tyre, from version 6 of the Magic Formula on.
    ///
    /// The columns have the names of the keys of tyre property files, in lower case. The stiffness at rest is that of
    /// the tyre, C_z0 (`VERTICAL_STIFFNESS`); without these coefficients the spring is linear and the tyre rolls on its
    /// free radius. The effective radius of version 5.2 is the same function.
    ///
    /// # Equations
    /// For the rotation Omega of the wheel, the camber gamma and the pressure dp = (p - p_0) / p_0:
    ///
    /// ```text
    /// R_Omega = R_0 (q_re0 + q_v1 (Omega R_0 / V_0)^2)                                          (1)
    /// F_z     = F_z0 (1 + pfz1 dp) g (q_fz1 rho / R_0 + q_fz2 (rho / R_0)^2)                     (2)
    /// q_fz1   = sqrt((C_z0 R_0 / F_z0)^2 - 4 q_fz2) + q_cam gamma^2                             (3)
    /// g       = 1 + q_v2 |Omega| R_0 / V_0 - (q_fcx F_x / F_z0)^2
    ///           - ((rho / R_0)^q_fcy2 q_fcy (F_y - S) / F_z0)^2                                 (4)
    /// S       = (q_fys1 + q_fys2 R_l / R_Omega + q_fys3 (R_l / R_Omega)^2) gamma                (5)
    /// rho     = x + (c(R_l) / c(R_Omega))^2 h / 4 - q_cam3 x |gamma|,  x = R_Omega - R_l >= 0    (6)
    /// c(R)    = q_cam1 R + q_cam2 R^2,  h = (1.075 - 0.5 aspect_ratio) width tan|gamma| / 2
    /// R_e     = R_Omega - F_z0 / C_z (dreff atan(breff F_z / F_z0) + freff F_z / F_z0)          (7)
    /// C_z     = C_z0 (1 + pfz1 dp),  Omega = (1 + kappa) V / R_e
    /// ```
    ///
    /// With `bottom_stiff` the rim carries (`rim_radius` + `bottom_offst` - R_l) `bottom_stiff` where that is more than
    /// (2). Without `q_cam1` and `q_cam2` the tread is round, h = 0. Where only the shoulder of a flat tread touches,
    /// -h < x < 0, rho is the mean depth of the tread in the road, (x + h)^2 / (4 h), which continues (6).
    ///
    /// # Limits
    /// The loaded radius is the largest one that carries the load, looked for in steps of R_0 / 64. Where (2) falls
    /// again, a load that is carried within one step only may be missed.
    ///
    /// # Source
    /// I. J. M. Besselink, A. J. C. Schmeitz, H. B. Pacejka, Vehicle System Dynamics 48, supplement 1 (2010) 337-352,
    /// doi:10.1080/00423111003748088, and H. B. Pacejka, "Tire and Vehicle Dynamics", 3rd ed. (2012), appendix 3:
    /// (A3.1) for (1), (A3.3) for (2) and (4), (A3.4) for (3), (A3.5) and (A3.6) for (7); q_cam is q_Fz3 of (4.E68). What
    /// version 6.2 adds, q_fcy2, (5) and (6), is that of MF-Tyre's equation manual, in the form of M. Furlan's MFeval;
    /// the shoulder is derived here.
    TyreSpring {
        /// Free radius at rest per unloaded radius.
        q_re0: fixed = real("1", 1.0),
        /// Growth of the free radius with the square of speed.
        q_v1: fixed = real("1", 0.0),
        /// Growth of the vertical stiffness with speed.
        q_v2: fixed = real("1", 0.0),
        /// Growth of the vertical stiffness with deflection.
        q_fz2: fixed = real("1", 0.0),
        /// Decrease of the vertical stiffness with the longitudinal force.
        q_fcx: fixed = real("1", 0.0),
        /// Decrease of the vertical stiffness with the lateral force.
        q_fcy: fixed = real("1", 0.0),
        /// Exponent of the deflection in that decrease; from version 6.2 on.
        q_fcy2: fixed = real("1", 0.0),
        /// Change of the vertical stiffness with the square of camber; in version 6.1.
        q_cam: fixed = real("1", 0.0),
        /// Deflection by camber with the loaded radius; from version 6.2 on, as those that follow.
        q_cam1: fixed = real("1", 0.0),
        /// Deflection by camber with the square of the loaded radius.
        q_cam2: fixed = real("1/m", 0.0),
        /// Decrease of the deflection with the size of camber.
        q_cam3: fixed = real("1", 0.0),
        /// Lateral force by camber that does not soften the tyre.
        q_fys1: fixed = real("N", 0.0).nominal(1e3),
        /// Its change with the loaded radius.
        q_fys2: fixed = real("N", 0.0).nominal(1e3),
        /// Its change with the square of the loaded radius.
        q_fys3: fixed = real("N", 0.0).nominal(1e3),
        /// Change of the vertical stiffness with pressure.
        pfz1: fixed = real("1", 0.0),
        /// Stiffness of the effective radius at small loads.
        breff: fixed = real("1", 0.0),
        /// Level of the decrease of the effective radius at small loads.
        dreff: fixed = real("1", 0.0),
        /// Decrease of the effective radius with load.
        freff: fixed = real("1", 0.0),
        /// Distance from the rim at which the tyre bottoms.
        bottom_offst: fixed = real("m", 0.0),
        /// Stiffness of the bottomed tyre; 0 without bottoming.
        bottom_stiff: fixed = real("N/m", 0.0).at_least(0.0).nominal(1e6),
        /// Radius of the rim.
        rim_radius: fixed = real("m", 0.0).at_least(0.0),
        /// Width of the tyre's section.
        width: fixed = real("m", 0.0).at_least(0.0),
        /// Height of the tyre's section per width.
        aspect_ratio: fixed = real("1", 0.0).at_least(0.0),
    }
}
