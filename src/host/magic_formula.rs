//! Forces and moments of a rolling tyre.

use crate::host::tyre_spring::TyreSpring;
use crate::model::real;
use crate::number::{Decision, Mask, Scalar};

crate::choices! {
    /// The side of the car on which a set of tyre coefficients was measured.
    pub enum Side {
        /// The set describes a left tyre; right tyres are its mirror image.
        Left,
        /// The set describes a right tyre; left tyres are its mirror image.
        Right,
    }
}

crate::choices! {
    /// Versions of the Magic Formula.
    pub enum FormulaVersion {
        /// Version 5.2, as PAC2002.
        Five,
        /// Versions 6.1 and 6.2, whose forces and moments are the same.
        Six,
    }
}

crate::part! {
    /// Magic Formula 5.2, 6.1 and 6.2: forces and moments of a rolling tyre in steady state, in pure and in combined
    /// slip.
    ///
    /// The columns have the names of the keys of tyre property files, in lower case. `version` says which formula they
    /// are for; what only the other one has is not used. The equations here are those of version 5.2. Version 6 (in
    /// `magic_formula_6.rs`) adds the inflation pressure, camber beyond small angles, the tangent of the side slip in
    /// place of the angle, a camber stiffness of its own, and more terms in the moments.
    ///
    /// # Equations
    ///
    /// ```text
    /// F_z0' = lfzo fnomin,   df = (F_z - F_z0') / F_z0'
    /// gamma_x = lgax gamma,  gamma_y = lgay gamma,  gamma_z = lgaz gamma
    /// S(C, E, x) = C atan(x - E (x - atan x)),  E <= 1 everywhere
    /// ```
    ///
    /// Longitudinal force in pure slip:
    ///
    /// ```text
    /// F_x0 = D_x sin S(C_x, E_x, B_x k_x) + S_Vx,  k_x = kappa + S_Hx
    /// C_x  = pcx1 lcx,  D_x = mu_x F_z,  B_x = K_x / (C_x D_x)
    /// mu_x = (pdx1 + pdx2 df) (1 - pdx3 gamma_x^2) lmux
    /// E_x  = (pex1 + pex2 df + pex3 df^2) (1 - pex4 sgn k_x) lex
    /// K_x  = F_z (pkx1 + pkx2 df) exp(pkx3 df) lkx
    /// S_Hx = (phx1 + phx2 df) lhx,  S_Vx = F_z (pvx1 + pvx2 df) lvx lmux
    /// ```
    ///
    /// Lateral force in pure slip:
    ///
    /// ```text
    /// F_y0 = D_y sin S(C_y, E_y, B_y a_y) + S_Vy,  a_y = alpha + S_Hy
    /// C_y  = pcy1 lcy,  D_y = mu_y F_z,  B_y = K_y / (C_y D_y)
    /// mu_y = (pdy1 + pdy2 df) (1 - pdy3 gamma_y^2) lmuy
    /// E_y  = (pey1 + pey2 df) (1 - (pey3 + pey4 gamma_y) sgn a_y) ley
    /// K_y  = pky1 F_z0' sin(2 atan(F_z / (pky2 F_z0'))) (1 - pky3 |gamma_y|) lky
    /// S_Hy = (phy1 + phy2 df) lhy + phy3 gamma_y
    /// S_Vy = F_z ((pvy1 + pvy2 df) lvy + (pvy3 + pvy4 df) gamma_y) lmuy
    /// ```
    ///
    /// Combined slip:
    ///
    /// ```text
    /// F_x  = F_x0 G(rcx1, rex1 + rex2 df, B_xa, alpha, rhx1),       B_xa = rbx1 cos(atan(rbx2 kappa)) lxal
    /// F_y  = F_y0 G(rcy1, rey1 + rey2 df, B_yk, kappa, S_Hyk) + S_Vyk
    /// B_yk = rby1 cos(atan(rby2 (alpha - rby3))) lyka,              S_Hyk = rhy1 + rhy2 df
    /// S_Vyk = mu_y F_z (rvy1 + rvy2 df + rvy3 gamma) cos(atan(rvy4 alpha)) sin(rvy5 atan(rvy6 kappa)) lvyka
    /// G(C, E, B, x, s) = cos S(C, E, B (x + s)) / cos S(C, E, B s)
    /// ```
    ///
    /// Moments; k_e(a) = atan sqrt(tan^2 a + (K_x / K_y)^2 kappa^2) sgn a:
    ///
    /// ```text
    /// M_z  = -t (F_y - S_Vyk) + M_zr + s F_x
    /// t    = D_t cos S(C_t, E_t, B_t k_e(a_t)) cos alpha
    /// M_zr = D_r cos(atan(B_r k_e(a_r))) cos alpha
    /// a_t  = alpha + qhz1 + qhz2 df + (qhz3 + qhz4 df) gamma_z,     a_r = alpha + S_Hy + S_Vy / K_y
    /// B_t  = (qbz1 + qbz2 df + qbz3 df^2) (1 + qbz4 gamma_z + qbz5 |gamma_z|) lky / lmuy
    /// C_t  = qcz1,  D_t = F_z (qdz1 + qdz2 df) (1 + qdz3 gamma_z + qdz4 gamma_z^2) R_0 / F_z0' ltr
    /// E_t  = (qez1 + qez2 df + qez3 df^2) (1 + (qez4 + qez5 gamma_z) (2 / pi) atan(B_t C_t a_t))
    /// B_r  = qbz9 lky / lmuy + qbz10 B_y C_y
    /// D_r  = F_z ((qdz6 + qdz7 df) lres + (qdz8 + qdz9 df) gamma_z) R_0 lmuy
    /// s    = (ssz1 + ssz2 F_y / F_z0' + (ssz3 + ssz4 df) gamma) R_0 ls
    /// M_x  = R_0 F_z (qsx1 lvmx - qsx2 gamma + qsx3 F_y / F_z0') lmx
    /// M_y  = -R_0 F_z (qsy1 + qsy2 F_x / F_z0' + qsy3 |V / V_0| + qsy4 (V / V_0)^4) lmy
    /// ```
    ///
    /// # Sign
    /// Axes of ISO 8855 at the contact point: x forward, y left, z up; F_z pushes the tyre up. The side slip alpha is
    /// positive when the contact point moves to the left, kappa is positive when driving, gamma is positive when the
    /// top leans to the right (a positive rotation about x). With these axes the stiffness of side slip is negative
    /// (`pky1` < 0): a tyre that slips to the left is pushed to the right. The rolling resistance holds for V > 0.
    ///
    /// # Limits
    /// Without load, all forces and moments are zero. Where a quotient above has the denominator 0 (no friction, no
    /// stiffness), it counts as 0. No turn slip, no speeds near 0; in version 6 the side slip is within a right angle.
    /// Far above the nominal load the linear terms in df can change the sign of friction or stiffness: the formula is a
    /// fit, not a law.
    ///
    /// # Source
    /// H. B. Pacejka, "Tyre and Vehicle Dynamics", 2nd ed., Butterworth-Heinemann (2006), section 4.3.2, equations
    /// (4.E1) to (4.E78), without turn slip, in the form that Magic Formula 5.2 and PAC2002 share: camber enters as an
    /// angle, side slip as an angle. The start values are those of the Magic Formula 5.2 set of Open-Car-Dynamics
    /// (TUMFTM, Apache License 2.0), for a nominal load of 3000 N, with five changes: the nominal load is scaled to 700
    /// N, the friction scale 0.97 is 1, the shifts without camber are switched off, and radius and reference speed are
    /// chosen. That set has no moments, so their coefficients are 0.
    MagicFormula {
        /// Nominal load F_z0 of the set.
        fnomin: fixed = real("N", 3000.0).positive().nominal(1e3),
        /// Unloaded radius R_0 of the tyre (default chosen).
        unloaded_radius: fixed = real("m", 0.2).positive().nominal(0.1),
        /// Reference speed V_0 of the rolling resistance (default chosen).
        longvl: fixed = real("m/s", 16.7).positive().nominal(10.0),
        /// Scale factor of the nominal load; 700 N here, for Formula Student.
        lfzo: fixed = real("1", 7.0 / 30.0).positive(),
        /// Scale factor of the shape of F_x.
        lcx: fixed = real("1", 1.0),
        /// Scale factor of the longitudinal friction; 0.97 in the source.
        lmux: fixed = real("1", 1.0).positive(),
        /// Scale factor of the curvature of F_x.
        lex: fixed = real("1", 1.0),
        /// Scale factor of the slip stiffness.
        lkx: fixed = real("1", 1.0),
        /// Scale factor of the horizontal shift of F_x; 1 in the source.
        lhx: fixed = real("1", 0.0),
        /// Scale factor of the vertical shift of F_x; 1 in the source.
        lvx: fixed = real("1", 0.0),
        /// Scale factor of the camber in F_x.
        lgax: fixed = real("1", 1.0),
        /// Scale factor of the shape of F_y.
        lcy: fixed = real("1", 1.0),
        /// Scale factor of the lateral friction; 0.97 in the source.
        lmuy: fixed = real("1", 1.0).positive(),
        /// Scale factor of the curvature of F_y.
        ley: fixed = real("1", 1.0),
        /// Scale factor of the cornering stiffness.
        lky: fixed = real("1", 1.0),
        /// Scale factor of the horizontal shift of F_y; 1 in the source.
        lhy: fixed = real("1", 0.0),
        /// Scale factor of the vertical shift of F_y; 1 in the source.
        lvy: fixed = real("1", 0.0),
        /// Scale factor of the camber in F_y.
        lgay: fixed = real("1", 1.0),
        /// Scale factor of the pneumatic trail.
        ltr: fixed = real("1", 1.0),
        /// Scale factor of the residual torque.
        lres: fixed = real("1", 1.0),
        /// Scale factor of the camber in M_z.
        lgaz: fixed = real("1", 1.0),
        /// Scale factor of the influence of the side slip on F_x.
        lxal: fixed = real("1", 1.0),
        /// Scale factor of the influence of the longitudinal slip on F_y.
        lyka: fixed = real("1", 1.0),
        /// Scale factor of the side force that longitudinal slip induces.
        lvyka: fixed = real("1", 1.0),
        /// Scale factor of the moment arm of F_x.
        ls: fixed = real("1", 1.0),
        /// Scale factor of the overturning couple.
        lmx: fixed = real("1", 1.0),
        /// Scale factor of the vertical shift of the overturning couple.
        lvmx: fixed = real("1", 1.0),
        /// Scale factor of the rolling resistance.
        lmy: fixed = real("1", 1.0),
        /// Shape factor of F_x.
        pcx1: fixed = real("1", 1.6),
        /// Longitudinal friction at the nominal load.
        pdx1: fixed = real("1", 1.5),
        /// Change of the longitudinal friction with load.
        pdx2: fixed = real("1", -0.04),
        /// Change of the longitudinal friction with the square of camber.
        pdx3: fixed = real("1", 0.1),
        /// Curvature of F_x at the nominal load.
        pex1: fixed = real("1", 0.7),
        /// Change of the curvature of F_x with load.
        pex2: fixed = real("1", -0.17),
        /// Change of the curvature of F_x with the square of load.
        pex3: fixed = real("1", 0.023),
        /// Change of the curvature of F_x with the sign of slip.
        pex4: fixed = real("1", -0.14),
        /// Slip stiffness per load at the nominal load.
        pkx1: fixed = real("1", 30.7).nominal(10.0),
        /// Change of the slip stiffness with load.
        pkx2: fixed = real("1", 0.27),
        /// Exponent of the slip stiffness with load.
        pkx3: fixed = real("1", 0.13),
        /// Horizontal shift of F_x at the nominal load.
        phx1: fixed = real("1", 0.0),
        /// Change of the horizontal shift of F_x with load.
        phx2: fixed = real("1", 0.0),
        /// Vertical shift of F_x per load at the nominal load.
        pvx1: fixed = real("1", 0.0),
        /// Change of the vertical shift of F_x with load.
        pvx2: fixed = real("1", 0.0),
        /// Stiffness of the reduction of F_x by side slip.
        rbx1: fixed = real("1", 17.4).nominal(10.0),
        /// Change of the stiffness of the reduction of F_x with longitudinal slip.
        rbx2: fixed = real("1", 12.9).nominal(10.0),
        /// Shape factor of the reduction of F_x.
        rcx1: fixed = real("1", 1.1),
        /// Curvature of the reduction of F_x.
        rex1: fixed = real("1", 0.0),
        /// Change of the curvature of the reduction of F_x with load.
        rex2: fixed = real("1", 0.0),
        /// Shift of the reduction of F_x.
        rhx1: fixed = real("1", 0.001),
        /// Shape factor of F_y.
        pcy1: fixed = real("1", 1.5),
        /// Lateral friction at the nominal load.
        pdy1: fixed = real("1", 1.2),
        /// Change of the lateral friction with load.
        pdy2: fixed = real("1", -0.09),
        /// Change of the lateral friction with the square of camber.
        pdy3: fixed = real("1", 0.1),
        /// Curvature of F_y at the nominal load.
        pey1: fixed = real("1", 0.1),
        /// Change of the curvature of F_y with load.
        pey2: fixed = real("1", -1.2),
        /// Change of the curvature of F_y with the sign of side slip.
        pey3: fixed = real("1", 0.05),
        /// Change of the curvature of F_y with camber and the sign of side slip.
        pey4: fixed = real("1", -8.1),
        /// Largest cornering stiffness per nominal load; negative for these axes.
        pky1: fixed = real("1", -75.5).nominal(10.0),
        /// Load of the largest cornering stiffness per nominal load; not 0.
        pky2: fixed = real("1", 4.65),
        /// Change of the cornering stiffness with camber.
        pky3: fixed = real("1", -0.6),
        /// Horizontal shift of F_y at the nominal load.
        phy1: fixed = real("1", 0.003),
        /// Change of the horizontal shift of F_y with load.
        phy2: fixed = real("1", -0.0006),
        /// Change of the horizontal shift of F_y with camber.
        phy3: fixed = real("1", 0.004),
        /// Vertical shift of F_y per load at the nominal load.
        pvy1: fixed = real("1", 0.04),
        /// Change of the vertical shift of F_y with load.
        pvy2: fixed = real("1", -0.02),
        /// Change of the vertical shift of F_y with camber.
        pvy3: fixed = real("1", -0.97),
        /// Change of the vertical shift of F_y with camber and load.
        pvy4: fixed = real("1", -0.41),
        /// Stiffness of the reduction of F_y by longitudinal slip.
        rby1: fixed = real("1", 20.6).nominal(10.0),
        /// Change of the stiffness of the reduction of F_y with side slip.
        rby2: fixed = real("1", -23.5).nominal(10.0),
        /// Side slip at which that stiffness is largest.
        rby3: fixed = real("1", 0.001),
        /// Shape factor of the reduction of F_y.
        rcy1: fixed = real("1", 1.0),
        /// Curvature of the reduction of F_y.
        rey1: fixed = real("1", 0.0),
        /// Change of the curvature of the reduction of F_y with load.
        rey2: fixed = real("1", 0.0),
        /// Shift of the reduction of F_y.
        rhy1: fixed = real("1", -0.02),
        /// Change of the shift of the reduction of F_y with load.
        rhy2: fixed = real("1", 0.0),
        /// Side force induced by longitudinal slip, at the nominal load.
        rvy1: fixed = real("1", 0.16),
        /// Change of the induced side force with load.
        rvy2: fixed = real("1", 0.03),
        /// Change of the induced side force with camber.
        rvy3: fixed = real("1", 27.5).nominal(10.0),
        /// Change of the induced side force with side slip.
        rvy4: fixed = real("1", -29.7).nominal(10.0),
        /// Shape factor of the induced side force.
        rvy5: fixed = real("1", 0.03),
        /// Stiffness of the induced side force.
        rvy6: fixed = real("1", 0.0),
        /// Stiffness of the trail at the nominal load.
        qbz1: fixed = real("1", 0.0),
        /// Change of the stiffness of the trail with load.
        qbz2: fixed = real("1", 0.0),
        /// Change of the stiffness of the trail with the square of load.
        qbz3: fixed = real("1", 0.0),
        /// Change of the stiffness of the trail with camber.
        qbz4: fixed = real("1", 0.0),
        /// Change of the stiffness of the trail with the size of camber.
        qbz5: fixed = real("1", 0.0),
        /// Stiffness of the residual torque.
        qbz9: fixed = real("1", 0.0),
        /// Stiffness of the residual torque per that of F_y.
        qbz10: fixed = real("1", 0.0),
        /// Shape factor of the trail.
        qcz1: fixed = real("1", 0.0),
        /// Largest trail per radius at the nominal load; 0: no trail in the source.
        qdz1: fixed = real("1", 0.0),
        /// Change of the largest trail with load.
        qdz2: fixed = real("1", 0.0),
        /// Change of the largest trail with camber.
        qdz3: fixed = real("1", 0.0),
        /// Change of the largest trail with the square of camber.
        qdz4: fixed = real("1", 0.0),
        /// Largest residual torque per radius and load.
        qdz6: fixed = real("1", 0.0),
        /// Change of the residual torque with load.
        qdz7: fixed = real("1", 0.0),
        /// Change of the residual torque with camber.
        qdz8: fixed = real("1", 0.0),
        /// Change of the residual torque with camber and load.
        qdz9: fixed = real("1", 0.0),
        /// Curvature of the trail at the nominal load.
        qez1: fixed = real("1", 0.0),
        /// Change of the curvature of the trail with load.
        qez2: fixed = real("1", 0.0),
        /// Change of the curvature of the trail with the square of load.
        qez3: fixed = real("1", 0.0),
        /// Change of the curvature of the trail with side slip.
        qez4: fixed = real("1", 0.0),
        /// Change of the curvature of the trail with side slip and camber.
        qez5: fixed = real("1", 0.0),
        /// Horizontal shift of the trail at the nominal load.
        qhz1: fixed = real("1", 0.0),
        /// Change of the horizontal shift of the trail with load.
        qhz2: fixed = real("1", 0.0),
        /// Change of the horizontal shift of the trail with camber.
        qhz3: fixed = real("1", 0.0),
        /// Change of the horizontal shift of the trail with camber and load.
        qhz4: fixed = real("1", 0.0),
        /// Moment arm of F_x per radius.
        ssz1: fixed = real("1", 0.0),
        /// Change of the moment arm with F_y.
        ssz2: fixed = real("1", 0.0),
        /// Change of the moment arm with camber.
        ssz3: fixed = real("1", 0.0),
        /// Change of the moment arm with camber and load.
        ssz4: fixed = real("1", 0.0),
        /// Overturning couple per radius and load.
        qsx1: fixed = real("1", 0.0),
        /// Change of the overturning couple with camber.
        qsx2: fixed = real("1", 0.0),
        /// Change of the overturning couple with F_y.
        qsx3: fixed = real("1", 0.0),
        /// Rolling resistance per radius and load.
        qsy1: fixed = real("1", 0.0),
        /// Change of the rolling resistance with F_x.
        qsy2: fixed = real("1", 0.0),
        /// Change of the rolling resistance with speed.
        qsy3: fixed = real("1", 0.0),
        /// Change of the rolling resistance with the fourth power of speed.
        qsy4: fixed = real("1", 0.0),
        /// Side that the set was measured for; tyres on the other side are mirrored.
        side: fixed = Side::Left.start(),
        /// Version of the formula.
        version: fixed = FormulaVersion::Five.start(),
        /// Inflation pressure (default chosen); from version 6 on.
        inflpres: fixed = real("Pa", 1e5).positive().nominal(1e5),
        /// Nominal inflation pressure of the set (default chosen); from version 6 on.
        nompres: fixed = real("Pa", 1e5).positive().nominal(1e5),
        /// Decrease of friction with the speed of slip; from version 6 on, as all that follow.
        lmuv: fixed = real("1", 0.0).at_least(0.0),
        /// Scale factor of the stiffness of F_y against camber.
        lkyc: fixed = real("1", 1.0),
        /// Scale factor of the stiffness of M_z against camber.
        lkzc: fixed = real("1", 1.0),
        /// Change of the slip stiffness with pressure.
        ppx1: fixed = real("1", 0.0),
        /// Change of the slip stiffness with the square of pressure.
        ppx2: fixed = real("1", 0.0),
        /// Change of the longitudinal friction with pressure.
        ppx3: fixed = real("1", 0.0),
        /// Change of the longitudinal friction with the square of pressure.
        ppx4: fixed = real("1", 0.0),
        /// Change of the stiffness of the reduction of F_x with the square of camber.
        rbx3: fixed = real("1", 0.0),
        /// Change of the curvature of F_y with the square of camber.
        pey5: fixed = real("1", 0.0),
        /// Shape of the cornering stiffness over load; 2 in version 5.2.
        pky4: fixed = real("1", 2.0),
        /// Change of the load of the largest cornering stiffness with the square of camber.
        pky5: fixed = real("1", 0.0),
        /// Stiffness of F_y against camber per load.
        pky6: fixed = real("1", 0.0),
        /// Change of the stiffness against camber with load.
        pky7: fixed = real("1", 0.0),
        /// Change of the cornering stiffness with pressure.
        ppy1: fixed = real("1", 0.0),
        /// Change of the load of the largest cornering stiffness with pressure.
        ppy2: fixed = real("1", 0.0),
        /// Change of the lateral friction with pressure.
        ppy3: fixed = real("1", 0.0),
        /// Change of the lateral friction with the square of pressure.
        ppy4: fixed = real("1", 0.0),
        /// Change of the stiffness against camber with pressure.
        ppy5: fixed = real("1", 0.0),
        /// Change of the stiffness of the reduction of F_y with the square of camber.
        rby4: fixed = real("1", 0.0),
        /// Change of the trail with pressure.
        ppz1: fixed = real("1", 0.0),
        /// Change of the residual torque by camber with pressure.
        ppz2: fixed = real("1", 0.0),
        /// Change of the residual torque with camber times its size.
        qdz10: fixed = real("1", 0.0),
        /// Change of the residual torque with camber times its size, and load.
        qdz11: fixed = real("1", 0.0),
        /// Change of the overturning couple by camber with pressure.
        ppmx1: fixed = real("1", 0.0),
        /// Overturning couple of load, lateral force and camber.
        qsx4: fixed = real("1", 0.0),
        /// Change of that couple with load.
        qsx5: fixed = real("1", 0.0),
        /// Load in that change.
        qsx6: fixed = real("1", 0.0),
        /// Camber in that couple.
        qsx7: fixed = real("1", 0.0),
        /// Lateral force in that couple.
        qsx8: fixed = real("1", 0.0),
        /// Stiffness of the lateral force in that couple.
        qsx9: fixed = real("1", 0.0),
        /// Overturning couple of load and camber.
        qsx10: fixed = real("1", 0.0),
        /// Load in that couple.
        qsx11: fixed = real("1", 0.0),
        /// Overturning couple of camber times its size.
        qsx12: fixed = real("1", 0.0),
        /// Overturning couple per radius and lateral force.
        qsx13: fixed = real("1", 0.0),
        /// Change of that couple with the size of camber.
        qsx14: fixed = real("1", 0.0),
        /// Change of the rolling resistance with the square of camber.
        qsy5: fixed = real("1", 0.0),
        /// Change of the rolling resistance with the square of camber and load.
        qsy6: fixed = real("1", 0.0),
        /// Exponent of the load in the rolling resistance; 1 in version 5.2.
        qsy7: fixed = real("1", 1.0),
        /// Exponent of the pressure in the rolling resistance.
        qsy8: fixed = real("1", 0.0),
        /// Vertical spring and radii.
        spring: (TyreSpring),
    }
}

/// State of a rolling tyre.
#[derive(Clone, Copy, Debug)]
pub struct Contact<T = f64> {
    /// Load F_z, N.
    pub load: T,
    /// Longitudinal slip kappa; -1 for a locked wheel.
    pub longitudinal_slip: T,
    /// Side slip alpha, rad; positive when the contact point moves to the left.
    pub side_slip: T,
    /// Camber gamma, rad; positive when the top leans to the right.
    pub camber: T,
    /// Forward speed V, m/s.
    pub speed: T,
}

/// Forces and moments of the road on the tyre, at the contact point, in the axes of the wheel.
#[derive(Clone, Copy, Debug)]
pub struct Wrench<T = f64> {
    /// Longitudinal force, N.
    pub force_x: T,
    /// Lateral force, N.
    pub force_y: T,
    /// Overturning couple, N.m.
    pub moment_x: T,
    /// Rolling resistance moment, N.m.
    pub moment_y: T,
    /// Aligning torque, N.m.
    pub moment_z: T,
}

impl<T: Scalar> MagicFormula<T> {
    /// Forces and moments of a tyre on one side of the car.
    pub fn wrench_on(&self, side: Side, contact: &Contact<T>) -> Wrench<T> {
        if Side::of(self.side.value()) == side {
            return self.wrench(contact);
        }
        let mirrored = Contact { side_slip: -contact.side_slip, camber: -contact.camber, ..*contact };
        let wrench = self.wrench(&mirrored);
        Wrench { force_y: -wrench.force_y, moment_x: -wrench.moment_x, moment_z: -wrench.moment_z, ..wrench }
    }

    /// Forces and moments of a tyre on the side on which the set was measured.
    pub fn wrench(&self, contact: &Contact<T>) -> Wrench<T> {
        let zero = T::zero();
        if contact.load.at_most(zero).holds() {
            return Wrench { force_x: zero, force_y: zero, moment_x: zero, moment_y: zero, moment_z: zero };
        }
        match FormulaVersion::of(self.version.value()) {
            FormulaVersion::Five => self.wrench_5(contact),
            FormulaVersion::Six => self.wrench_6(contact),
        }
    }
}

/// The angle S of the Magic Formula.
pub(super) fn phase<T: Scalar>(shape: T, curvature: T, x: T) -> T {
    let one = T::from(1.0);
    let curvature = curvature.above(one).choose(|| one, || curvature);
    shape * (x - curvature * (x - x.atan())).atan()
}

/// The curve of a force: its peak, its slope at 0, its shape.
pub(super) fn sine<T: Scalar>(shape: T, curvature: T, peak: T, stiffness: T, slip: T) -> T {
    peak * phase(shape, curvature, quotient(stiffness, shape * peak) * slip).sin()
}

/// The weight G of combined slip; exactly 1 without slip.
pub(super) fn reduction<T: Scalar>(shape: T, curvature: T, stiffness: T, slip: T, shift: T) -> T {
    let weight = |x: T| phase(shape, curvature, stiffness * x).cos();
    slip.is(0.0).choose(|| T::from(1.0), || quotient(weight(slip + shift), weight(shift)))
}

/// The equivalent side slip for both slips in trail and residual torque, which are even functions of it.
pub(super) fn equivalent<T: Scalar>(side_slip: T, slip: T) -> T {
    let both = || {
        let tangent = side_slip.sin() / side_slip.cos();
        (tangent * tangent + slip * slip).sqrt().atan()
    };
    slip.is(0.0).choose(|| side_slip, both)
}

/// a / b, and 0 for b = 0: a tyre without friction or stiffness has no force to divide.
pub(super) fn quotient<T: Scalar>(a: T, b: T) -> T {
    b.vanishes().choose(|| T::zero(), || a / b)
}
