//! Magic Formula 6.1 and 6.2: forces and moments of a rolling tyre in steady state, with inflation pressure, without
//! turn slip (all factors zeta are 1).
//!
//! The code follows the equations line by line; their numbers are those of H. B. Pacejka, "Tire and Vehicle Dynamics",
//! 3rd ed., Butterworth-Heinemann (2012), section 4.3.2, (4.E1) to (4.E78). Where the solver that files are fitted with
//! (MF-Tyre) departs from the book, the equations are those of I. J. M. Besselink, A. J. C. Schmeitz, H. B. Pacejka,
//! "An improved Magic Formula/Swift tyre model that can handle inflation pressure changes", Vehicle System Dynamics 48,
//! supplement 1 (2010) 337-352, doi:10.1080/00423111003748088, as M. Furlan's MFeval found them:
//!
//! - (4.E8): the digressive friction factor is that of (4.E7), A_mu = 1;
//! - (4.E40): `qbz4` gamma in place of q_Bz6; trail and moment arm have camber as an angle; the moment arm is relative
//!   to the nominal load without its scale factor, and so is the trail in combined slip;
//! - (4.E77), (4.E78): the equivalent slip angles are composed as tangents;
//! - (4.E69): arctan of the squared ratio of loads, with the three terms `qsx12` to `qsx14` of version 6.2;
//! - (4.E70): the rolling resistance acts against the rolling wheel and is relative to the nominal load.

use crate::host::magic_formula::{Contact, MagicFormula, Wrench, equivalent, phase, quotient, reduction, sine};
use crate::number::{Mask, Scalar};

/// What the equations of all forces and moments share.
struct Basis<T> {
    /// F_z.
    load: T,
    /// kappa.
    slip: T,
    /// alpha*.
    side_slip: T,
    /// cos' alpha.
    cosine: T,
    /// gamma.
    camber: T,
    /// gamma*.
    lean: T,
    /// df_z.
    df: T,
    /// dp_i.
    dp: T,
    /// lambda*_mux.
    scale_x: T,
    /// lambda*_muy.
    scale_y: T,
}

/// Lateral force in pure slip, and what the moments take from it.
struct Lateral<T> {
    force: T,
    /// mu_y.
    friction: T,
    /// K_ya.
    stiffness: T,
    /// S_Hy.
    shift: T,
    /// S_Vy.
    vertical_shift: T,
}

impl<T: Scalar> MagicFormula<T> {
    /// Forces and moments for a positive load, on the side on which the set was measured.
    pub(super) fn wrench_6(&self, contact: &Contact<T>) -> Wrench<T> {
        let basis = self.basis(contact);
        let slip_stiffness = self.slip_stiffness(&basis);
        let lateral = self.lateral(&basis);
        let weight = self.weight_y(&basis);
        // (4.E50), (4.E58)
        let force_x = self.longitudinal_force(&basis, slip_stiffness) * self.weight_x(&basis);
        let force_y = lateral.force * weight + self.shift_by_slip(&basis, lateral.friction);
        // (4.E74): without camber
        let upright = self.lateral(&Basis { lean: T::zero(), ..basis });
        let slip = quotient(slip_stiffness, lateral.stiffness) * basis.slip;
        // (4.E71), (4.E72)
        let moment_z = self.residual(&basis, &lateral, slip) - self.trail_6(&basis, slip) * (upright.force * weight)
            + self.arm(&basis, force_y) * force_x;
        let (moment_x, moment_y) = (self.couple(&basis, force_y), self.resistance(&basis, contact.speed, force_x));
        Wrench { force_x, force_y, moment_x, moment_y, moment_z }
    }

    fn basis(&self, contact: &Contact<T>) -> Basis<T> {
        let (one, cosine) = (T::from(1.0), contact.side_slip.cos());
        // (4.E3) and (4.E4), rolling forward
        let (side_slip, lean) = (contact.side_slip.sin() / cosine, contact.camber.sin());
        // (4.E7)
        let square = contact.longitudinal_slip * contact.longitudinal_slip + side_slip * side_slip;
        let still = self.lmuv.is(0.0) | square.is(0.0);
        let speed = still.choose(T::zero, || contact.speed * square.sqrt());
        let decrease = one + self.lmuv * speed / self.longvl;
        Basis {
            load: contact.load,
            slip: contact.longitudinal_slip,
            side_slip,
            cosine,
            camber: contact.camber,
            lean,
            // (4.E1), (4.E2)
            df: (contact.load - self.lfzo * self.fnomin) / (self.lfzo * self.fnomin),
            dp: (self.inflpres - self.nompres) / self.nompres,
            scale_x: self.lmux / decrease,
            scale_y: self.lmuy / decrease,
        }
    }

    /// K_xk (4.E15).
    fn slip_stiffness(&self, &Basis { load, df, dp, .. }: &Basis<T>) -> T {
        let by_pressure = T::from(1.0) + self.ppx1 * dp + self.ppx2 * dp * dp;
        load * (self.pkx1 + self.pkx2 * df) * (self.pkx3 * df).exp() * by_pressure * self.lkx
    }

    /// F_xo (4.E9).
    fn longitudinal_force(&self, basis: &Basis<T>, stiffness: T) -> T {
        let &Basis { load, df, dp, camber, scale_x, .. } = basis;
        let one = T::from(1.0);
        // (4.E10), (4.E17)
        let slip = basis.slip + (self.phx1 + self.phx2 * df) * self.lhx;
        // (4.E11)
        let shape = self.pcx1 * self.lcx;
        // (4.E13), (4.E12)
        let by_pressure = one + self.ppx3 * dp + self.ppx4 * dp * dp;
        let friction = (self.pdx1 + self.pdx2 * df) * by_pressure * (one - self.pdx3 * camber * camber) * scale_x;
        // (4.E14)
        let curvature = (self.pex1 + self.pex2 * df + self.pex3 * df * df) * (one - self.pex4 * slip.sign()) * self.lex;
        // (4.E18)
        let shift = load * (self.pvx1 + self.pvx2 * df) * self.lvx * scale_x;
        sine(shape, curvature, friction * load, stiffness, slip) + shift
    }

    /// G_xa (4.E51).
    fn weight_x(&self, &Basis { slip, side_slip, lean, df, .. }: &Basis<T>) -> T {
        // (4.E54) to (4.E57)
        let stiffness = (self.rbx1 + self.rbx3 * lean * lean) * (self.rbx2 * slip).atan().cos() * self.lxal;
        reduction(self.rcx1, self.rex1 + self.rex2 * df, stiffness, side_slip, self.rhx1)
    }

    /// F_yo (4.E19).
    fn lateral(&self, &Basis { load, side_slip, lean, df, dp, scale_y, .. }: &Basis<T>) -> Lateral<T> {
        let (one, square) = (T::from(1.0), lean * lean);
        let stiffness = self.cornering_stiffness_6(load, lean, dp);
        // (4.E30)
        let by_camber = load * (self.pky6 + self.pky7 * df) * (one + self.ppy5 * dp) * self.lkyc;
        // (4.E28), (4.E29)
        let leaning = load * (self.pvy3 + self.pvy4 * df) * lean * self.lkyc * scale_y;
        let vertical_shift = load * (self.pvy1 + self.pvy2 * df) * self.lvy * scale_y + leaning;
        // (4.E27), (4.E20)
        let shift = (self.phy1 + self.phy2 * df) * self.lhy + quotient(by_camber * lean - leaning, stiffness);
        let slip = side_slip + shift;
        // (4.E23), (4.E22)
        let by_pressure = one + self.ppy3 * dp + self.ppy4 * dp * dp;
        let friction = (self.pdy1 + self.pdy2 * df) * by_pressure * (one - self.pdy3 * square) * scale_y;
        // (4.E24)
        let uneven = (self.pey3 + self.pey4 * lean) * slip.sign();
        let curvature = (self.pey1 + self.pey2 * df) * (one + self.pey5 * square - uneven) * self.ley;
        // (4.E21), (4.E26)
        let force = sine(self.pcy1 * self.lcy, curvature, friction * load, stiffness, slip) + vertical_shift;
        Lateral { force, friction, stiffness, shift, vertical_shift }
    }

    /// K_ya (4.E25), for gamma* and dp_i.
    fn cornering_stiffness_6(&self, load: T, lean: T, dp: T) -> T {
        let (one, nominal) = (T::from(1.0), self.lfzo * self.fnomin);
        let largest_at = (self.pky2 + self.pky5 * lean * lean) * (one + self.ppy2 * dp);
        let bend = self.pky4 * (load / nominal / largest_at).atan();
        self.pky1 * nominal * (one + self.ppy1 * dp) * (one - self.pky3 * lean.abs()) * bend.sin() * self.lky
    }

    /// G_yk (4.E59).
    fn weight_y(&self, &Basis { slip, side_slip, lean, df, .. }: &Basis<T>) -> T {
        // (4.E62) to (4.E65)
        let along = (self.rby2 * (side_slip - self.rby3)).atan().cos();
        let stiffness = (self.rby1 + self.rby4 * lean * lean) * along * self.lyka;
        reduction(self.rcy1, self.rey1 + self.rey2 * df, stiffness, slip, self.rhy1 + self.rhy2 * df)
    }

    /// S_Vyk (4.E66), (4.E67).
    fn shift_by_slip(&self, &Basis { load, slip, side_slip, lean, df, .. }: &Basis<T>, friction: T) -> T {
        let level = self.rvy1 + self.rvy2 * df + self.rvy3 * lean;
        let largest = friction * load * level * (self.rvy4 * side_slip).atan().cos();
        largest * (self.rvy5 * (self.rvy6 * slip).atan()).sin() * self.lvyka
    }

    /// t (4.E73), for a longitudinal slip scaled to an equivalent side slip.
    fn trail_6(&self, basis: &Basis<T>, slip: T) -> T {
        let &Basis { load, side_slip, camber, lean, df, dp, .. } = basis;
        let one = T::from(1.0);
        // (4.E34), (4.E35)
        let side_slip = side_slip + self.qhz1 + self.qhz2 * df + (self.qhz3 + self.qhz4 * df) * lean;
        // (4.E40), (4.E41)
        let stiffness = (self.qbz1 + self.qbz2 * df + self.qbz3 * df * df)
            * (one + self.qbz4 * camber + self.qbz5 * camber.abs())
            * self.lky
            / basis.scale_y;
        // (4.E42), (4.E43)
        let largest = load
            * (self.unloaded_radius / self.fnomin)
            * (self.qdz1 + self.qdz2 * df)
            * (one - self.ppz1 * dp)
            * (one + self.qdz3 * camber + self.qdz4 * camber * camber)
            * self.ltr;
        // (4.E44)
        let bend = T::from(std::f64::consts::FRAC_2_PI) * (stiffness * self.qcz1 * side_slip).atan();
        let curvature =
            (self.qez1 + self.qez2 * df + self.qez3 * df * df) * (one + (self.qez4 + self.qez5 * lean) * bend);
        // (4.E77)
        let equivalent = equivalent(side_slip, slip);
        largest * phase(self.qcz1, curvature, stiffness * equivalent).cos() * basis.cosine
    }

    /// M_zr (4.E75), for a longitudinal slip scaled to an equivalent side slip.
    fn residual(&self, basis: &Basis<T>, lateral: &Lateral<T>, slip: T) -> T {
        let &Basis { load, lean, df, dp, scale_y, .. } = basis;
        // (4.E37) to (4.E39)
        let side_slip = basis.side_slip + lateral.shift + quotient(lateral.vertical_shift, lateral.stiffness);
        // (4.E45), with B_y C_y = K_ya / D_y
        let stiffness =
            self.qbz9 * self.lky / scale_y + self.qbz10 * quotient(lateral.stiffness, lateral.friction * load);
        // (4.E47)
        let by_camber = (self.qdz8 + self.qdz9 * df) * (T::from(1.0) + self.ppz2 * dp)
            + (self.qdz10 + self.qdz11 * df) * lean.abs();
        let level = (self.qdz6 + self.qdz7 * df) * self.lres + by_camber * lean * self.lkzc;
        let largest = load * self.unloaded_radius * level * scale_y * basis.cosine;
        // (4.E78)
        largest * (stiffness * equivalent(side_slip, slip)).atan().cos()
    }

    /// s (4.E76).
    fn arm(&self, &Basis { camber, df, .. }: &Basis<T>, force_y: T) -> T {
        let by_force = self.ssz2 * (force_y / self.fnomin);
        self.unloaded_radius * (self.ssz1 + by_force + (self.ssz3 + self.ssz4 * df) * camber) * self.ls
    }

    /// M_x (4.E69).
    fn couple(&self, &Basis { load, camber, dp, .. }: &Basis<T>, force_y: T) -> T {
        let (force, ratio) = (force_y / self.fnomin, load / self.fnomin);
        let lifted = self.qsx6 * ratio;
        let both = self.qsx4
            * (self.qsx5 * (lifted * lifted).atan()).cos()
            * (self.qsx7 * camber + self.qsx8 * (self.qsx9 * force).atan()).sin();
        let level = self.qsx1 * self.lvmx
            - self.qsx2 * camber * (T::from(1.0) + self.ppmx1 * dp)
            - self.qsx12 * camber * camber.abs()
            + self.qsx3 * force
            + both
            + self.qsx10 * (self.qsx11 * ratio).atan() * camber;
        self.unloaded_radius * (load * level + force_y * (self.qsx13 + self.qsx14 * camber.abs())) * self.lmx
    }

    /// M_y (4.E70).
    fn resistance(&self, &Basis { load, camber, .. }: &Basis<T>, speed: T, force_x: T) -> T {
        let (speed, ratio) = (speed / self.longvl, load / self.fnomin);
        let square = speed * speed;
        let level = self.qsy1
            + self.qsy2 * (force_x / self.fnomin)
            + self.qsy3 * speed.abs()
            + self.qsy4 * square * square
            + (self.qsy5 + self.qsy6 * ratio) * camber * camber;
        let by_load = ratio.powf(self.qsy7) * (self.inflpres / self.nompres).powf(self.qsy8);
        -self.unloaded_radius * self.fnomin * level * by_load * self.lmy
    }
}
