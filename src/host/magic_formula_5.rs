//! Magic Formula 5.2: forces and moments of a rolling tyre in steady state, as [`MagicFormula`] documents its equations.

use crate::host::magic_formula::{Contact, MagicFormula, Wrench, equivalent, phase, quotient, reduction, sine};
use crate::number::Scalar;

/// The curve of a force in pure slip, and the quantities that combined slip and the moments take from it.
struct Curve<T> {
    force: T,
    friction: T,
    stiffness: T,
    shift: T,
    vertical_shift: T,
}

impl<T: Scalar> MagicFormula<T> {
    /// Forces and moments for a positive load, on the side on which the set was measured.
    pub(super) fn wrench_5(&self, contact: &Contact<T>) -> Wrench<T> {
        let longitudinal = self.pure_longitudinal(contact);
        let lateral = self.pure_lateral(contact);
        let force_x = longitudinal.force * self.reduction_of_force_x(contact);
        let induced = self.induced_force(contact, lateral.friction);
        let force_y = lateral.force * self.reduction_of_force_y(contact) + induced;
        Wrench {
            force_x,
            force_y,
            moment_x: self.overturning_couple(contact, force_y),
            moment_y: self.rolling_resistance(contact, force_x),
            moment_z: self.aligning_torque(contact, &longitudinal, &lateral, force_y - induced)
                + self.moment_arm(contact, force_y) * force_x,
        }
    }

    /// F_z0'.
    fn nominal_load(&self) -> T {
        self.lfzo * self.fnomin
    }

    /// df.
    fn load_change(&self, contact: &Contact<T>) -> T {
        contact.load / self.nominal_load() - T::from(1.0)
    }

    fn pure_longitudinal(&self, contact: &Contact<T>) -> Curve<T> {
        let (one, load, df) = (T::from(1.0), contact.load, self.load_change(contact));
        let gamma = self.lgax * contact.camber;
        let shift = (self.phx1 + self.phx2 * df) * self.lhx;
        let vertical_shift = load * (self.pvx1 + self.pvx2 * df) * self.lvx * self.lmux;
        let slip = contact.longitudinal_slip + shift;
        let friction = (self.pdx1 + self.pdx2 * df) * (one - self.pdx3 * gamma * gamma) * self.lmux;
        let curvature = (self.pex1 + self.pex2 * df + self.pex3 * df * df) * (one - self.pex4 * slip.sign()) * self.lex;
        let stiffness = load * (self.pkx1 + self.pkx2 * df) * (self.pkx3 * df).exp() * self.lkx;
        let shape = self.pcx1 * self.lcx;
        let force = sine(shape, curvature, friction * load, stiffness, slip) + vertical_shift;
        Curve { force, friction, stiffness, shift, vertical_shift }
    }

    fn pure_lateral(&self, contact: &Contact<T>) -> Curve<T> {
        let (one, load, df) = (T::from(1.0), contact.load, self.load_change(contact));
        let gamma = self.lgay * contact.camber;
        let shift = (self.phy1 + self.phy2 * df) * self.lhy + self.phy3 * gamma;
        let vertical_shift =
            load * ((self.pvy1 + self.pvy2 * df) * self.lvy + (self.pvy3 + self.pvy4 * df) * gamma) * self.lmuy;
        let slip = contact.side_slip + shift;
        let friction = (self.pdy1 + self.pdy2 * df) * (one - self.pdy3 * gamma * gamma) * self.lmuy;
        let curvature = (self.pey1 + self.pey2 * df) * (one - (self.pey3 + self.pey4 * gamma) * slip.sign()) * self.ley;
        let stiffness = self.cornering_stiffness(load) * (one - self.pky3 * gamma.abs());
        let shape = self.pcy1 * self.lcy;
        let force = sine(shape, curvature, friction * load, stiffness, slip) + vertical_shift;
        Curve { force, friction, stiffness, shift, vertical_shift }
    }

    /// Slope of the lateral force over the side slip at 0, without camber: K_y.
    fn cornering_stiffness(&self, load: T) -> T {
        let bend = T::from(2.0) * (load / (self.pky2 * self.nominal_load())).atan();
        self.pky1 * self.nominal_load() * bend.sin() * self.lky
    }

    /// Reduction of the longitudinal force by side slip.
    fn reduction_of_force_x(&self, contact: &Contact<T>) -> T {
        let curvature = self.rex1 + self.rex2 * self.load_change(contact);
        let stiffness = self.rbx1 * (self.rbx2 * contact.longitudinal_slip).atan().cos() * self.lxal;
        reduction(self.rcx1, curvature, stiffness, contact.side_slip, self.rhx1)
    }

    /// Reduction of the lateral force by longitudinal slip.
    fn reduction_of_force_y(&self, contact: &Contact<T>) -> T {
        let df = self.load_change(contact);
        let stiffness = self.rby1 * (self.rby2 * (contact.side_slip - self.rby3)).atan().cos() * self.lyka;
        let shift = self.rhy1 + self.rhy2 * df;
        reduction(self.rcy1, self.rey1 + self.rey2 * df, stiffness, contact.longitudinal_slip, shift)
    }

    /// S_Vyk.
    fn induced_force(&self, contact: &Contact<T>, friction: T) -> T {
        let level = self.rvy1 + self.rvy2 * self.load_change(contact) + self.rvy3 * contact.camber;
        let by_side_slip = (self.rvy4 * contact.side_slip).atan().cos();
        let by_slip = (self.rvy5 * (self.rvy6 * contact.longitudinal_slip).atan()).sin();
        friction * contact.load * level * by_side_slip * by_slip * self.lvyka
    }

    /// -t (F_y - S_Vyk) + M_zr.
    fn aligning_torque(&self, contact: &Contact<T>, longitudinal: &Curve<T>, lateral: &Curve<T>, force_y: T) -> T {
        let slip = quotient(longitudinal.stiffness, lateral.stiffness) * contact.longitudinal_slip;
        let trail = self.trail(contact, slip);
        (self.residual_torque(contact, lateral, slip) - trail * force_y) * contact.side_slip.cos()
    }

    /// t / cos alpha, for a longitudinal slip scaled to an equivalent side slip.
    fn trail(&self, contact: &Contact<T>, slip: T) -> T {
        let (one, df) = (T::from(1.0), self.load_change(contact));
        let gamma = self.lgaz * contact.camber;
        let side_slip = contact.side_slip + self.qhz1 + self.qhz2 * df + (self.qhz3 + self.qhz4 * df) * gamma;
        let stiffness = (self.qbz1 + self.qbz2 * df + self.qbz3 * df * df)
            * (one + self.qbz4 * gamma + self.qbz5 * gamma.abs())
            * self.lky
            / self.lmuy;
        let bend = T::from(std::f64::consts::FRAC_2_PI) * (stiffness * self.qcz1 * side_slip).atan();
        let curvature =
            (self.qez1 + self.qez2 * df + self.qez3 * df * df) * (one + (self.qez4 + self.qez5 * gamma) * bend);
        let largest = contact.load
            * (self.qdz1 + self.qdz2 * df)
            * (one + self.qdz3 * gamma + self.qdz4 * gamma * gamma)
            * self.unloaded_radius
            / self.nominal_load()
            * self.ltr;
        largest * phase(self.qcz1, curvature, stiffness * equivalent(side_slip, slip)).cos()
    }

    /// M_zr / cos alpha, for a longitudinal slip scaled to an equivalent side slip.
    fn residual_torque(&self, contact: &Contact<T>, lateral: &Curve<T>, slip: T) -> T {
        let df = self.load_change(contact);
        let gamma = self.lgaz * contact.camber;
        let side_slip = contact.side_slip + lateral.shift + quotient(lateral.vertical_shift, lateral.stiffness);
        // B_y C_y = K_y / D_y
        let stiffness = self.qbz9 * self.lky / self.lmuy
            + self.qbz10 * quotient(lateral.stiffness, lateral.friction * contact.load);
        let level = (self.qdz6 + self.qdz7 * df) * self.lres + (self.qdz8 + self.qdz9 * df) * gamma;
        let largest = contact.load * level * self.unloaded_radius * self.lmuy;
        largest * (stiffness * equivalent(side_slip, slip)).atan().cos()
    }

    /// s.
    fn moment_arm(&self, contact: &Contact<T>, force_y: T) -> T {
        let by_camber = (self.ssz3 + self.ssz4 * self.load_change(contact)) * contact.camber;
        (self.ssz1 + self.ssz2 * force_y / self.nominal_load() + by_camber) * self.unloaded_radius * self.ls
    }

    /// M_x.
    fn overturning_couple(&self, contact: &Contact<T>, force_y: T) -> T {
        let level = self.qsx1 * self.lvmx - self.qsx2 * contact.camber + self.qsx3 * force_y / self.nominal_load();
        self.unloaded_radius * contact.load * level * self.lmx
    }

    /// M_y.
    fn rolling_resistance(&self, contact: &Contact<T>, force_x: T) -> T {
        let speed = contact.speed / self.longvl;
        let square = speed * speed;
        let level = self.qsy1
            + self.qsy2 * force_x / self.nominal_load()
            + self.qsy3 * speed.abs()
            + self.qsy4 * square * square;
        -self.unloaded_radius * contact.load * level * self.lmy
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::host::magic_formula::Side;
    use crate::model::{Columns, row_of_mut, start};
    use crate::number::Dual;

    const LOAD: f64 = 700.0;

    /// The built-in set, with the given coefficients changed.
    fn tyre(changes: &[(&str, f64)]) -> MagicFormula {
        let mut tyre: MagicFormula = start();
        for (name, value) in changes {
            let column = MagicFormula::TABLE.iter().position(|variable| variable.path.to_string() == *name).unwrap();
            row_of_mut(&mut tyre)[column] = *value;
        }
        tyre
    }

    /// Without the terms that distinguish left from right or driving from braking.
    fn symmetric() -> MagicFormula {
        tyre(&[("pey3", 0.0), ("pex4", 0.0), ("rhx1", 0.0), ("rhy1", 0.0), ("rby3", 0.0), ("rvy1", 0.0), ("rvy2", 0.0)])
    }

    fn contact(longitudinal_slip: f64, side_slip: f64) -> Contact {
        Contact { load: LOAD, longitudinal_slip, side_slip, camber: 0.0, speed: 20.0 }
    }

    fn grid(limit: f64) -> impl Iterator<Item = f64> {
        (-40..=40).map(move |i| limit * f64::from(i) / 40.0)
    }

    /// Computed with another program from the same set: symmetric part, 700 N, nominal load 700 N.
    #[test]
    fn lateral_force_of_the_sample_set_at_four_side_slips() {
        let forces = [(0.02, -400.079), (0.05, -730.387), (0.10, -839.639), (0.15, -822.635)];
        let tyre = symmetric();
        for (side_slip, force) in forces {
            assert!((tyre.wrench(&contact(0.0, side_slip)).force_y - force).abs() < 5e-4, "{side_slip}");
        }
    }

    #[test]
    fn forces_are_odd_in_their_own_slip_and_even_in_the_other() {
        let tyre = symmetric();
        for (kappa, alpha) in grid(0.3).flat_map(|kappa| grid(0.4).map(move |alpha| (kappa, alpha))) {
            let at = |kappa, alpha| tyre.wrench(&contact(kappa, alpha));
            let here = at(kappa, alpha);
            assert!((here.force_y + at(kappa, -alpha).force_y).abs() < 1e-9);
            assert_abs_diff_eq!(here.force_y, at(-kappa, alpha).force_y, epsilon = 1e-9);
            assert!((here.force_x + at(-kappa, alpha).force_x).abs() < 1e-9);
            assert_abs_diff_eq!(here.force_x, at(kappa, -alpha).force_x, epsilon = 1e-9);
        }
    }

    /// The slope at zero is the cornering stiffness, from the dual numbers and from differences.
    #[test]
    fn slope_at_zero_is_the_stiffness() {
        for load in [100.0, 700.0, 1400.0] {
            let tyre = symmetric();
            // K_y and K_x of Pacejka's (4.E25) and (4.E15), at the load.
            let nominal = 700.0;
            let k_y = -75.5 * nominal * (2.0 * (load / (4.65f64 * nominal)).atan()).sin();
            let df = load / nominal - 1.0;
            let k_x = load * (30.7 + 0.27 * df) * (0.13 * df).exp();
            let at = |kappa, alpha| tyre.wrench(&Contact { load, ..contact(kappa, alpha) });
            let h = 1e-6;
            assert!((at(0.0, h).force_y / h / k_y - 1.0).abs() < 1e-6, "{load}");
            assert!((at(h, 0.0).force_x / h / k_x - 1.0).abs() < 1e-6, "{load}");
            assert_abs_diff_eq!(tyre.cornering_stiffness(load) / k_y, 1.0, epsilon = 1e-14);
            let dual = tyre.map(&|value| Dual::from(value));
            let moving = Contact {
                load: Dual::from(load),
                longitudinal_slip: Dual::from(0.0),
                side_slip: Dual { value: 0.0, slope: 1.0 },
                camber: Dual::from(0.0),
                speed: Dual::from(20.0),
            };
            assert!((dual.wrench(&moving).force_y.slope / k_y - 1.0).abs() < 1e-12, "{load}");
        }
    }

    /// The largest force over a fine grid of slips is the friction times the load.
    #[test]
    fn peak_is_friction_times_load() {
        for load in [300.0, 700.0, 1200.0] {
            let df = load / 700.0 - 1.0;
            let tyre = symmetric();
            let slips = || (0..20_000).map(|i| f64::from(i) * 5e-5);
            let at = |kappa, alpha| tyre.wrench(&Contact { load, ..contact(kappa, alpha) });
            let lateral = slips().map(|alpha| at(0.0, alpha).force_y.abs()).fold(0.0, f64::max);
            let longitudinal = slips().map(|kappa| at(kappa, 0.0).force_x.abs()).fold(0.0, f64::max);
            assert!((lateral / ((1.2 - 0.09 * df) * load) - 1.0).abs() < 1e-6, "{load}: {lateral}");
            assert!((longitudinal / ((1.5 - 0.04 * df) * load) - 1.0).abs() < 1e-6, "{load}: {longitudinal}");
        }
    }

    /// The formula of combined slip is a fit, but it must stay near the friction ellipse.
    #[test]
    fn combined_force_stays_in_the_ellipse_of_friction() {
        let tyre = symmetric();
        let mut largest: f64 = 0.0;
        for (kappa, alpha) in grid(1.0).flat_map(|kappa| grid(0.5).map(move |alpha| (kappa, alpha))) {
            let wrench = tyre.wrench(&contact(kappa, alpha));
            largest = largest.max((wrench.force_x / (1.5 * LOAD)).hypot(wrench.force_y / (1.2 * LOAD)));
        }
        assert!(largest <= 1.0 + 1e-9, "{largest}");
        assert!(largest > 0.999, "{largest}");
    }

    /// Combined slip with one slip going to zero is pure slip: no jump where the weight is taken as exactly 1.
    #[test]
    fn combined_slip_goes_over_into_pure_slip() {
        let tyre = tyre(&[]);
        for slip in [-0.2, -0.03, 0.01, 0.1] {
            let [pure, nearly] = [0.0, 1e-12].map(|kappa| tyre.wrench(&contact(kappa, slip)).force_y);
            assert!((pure - nearly).abs() < 1e-6, "{pure} {nearly}");
            let [pure, nearly] = [0.0, 1e-12].map(|alpha| tyre.wrench(&contact(slip, alpha)).force_x);
            assert!((pure - nearly).abs() < 1e-6, "{pure} {nearly}");
        }
    }

    /// For small slip the aligning torque is the side force on the trail: M_z = -t K_y alpha, t = qdz1 R_0 at the
    /// nominal load. The moments without slip follow from their definition.
    #[test]
    fn moments_at_small_slip() {
        let changes =
            [("qdz1", 0.1), ("qcz1", 1.2), ("qbz1", 9.0), ("pey3", 0.0), ("qsy1", 0.02), ("qsx3", 0.5), ("qsx2", 0.3)];
        let tyre = tyre(&changes);
        let alpha = 1e-6;
        let wrench = tyre.wrench(&contact(0.0, alpha));
        let stiffness = -75.5 * 700.0 * (2.0 * (1.0 / 4.65f64).atan()).sin();
        assert_abs_diff_eq!(wrench.moment_z / (-0.1 * 0.2 * stiffness * alpha), 1.0, epsilon = 1e-6);
        assert!(wrench.moment_z > 0.0, "the torque turns the wheel towards its direction of motion");
        assert!((wrench.moment_y + 0.02 * 0.2 * LOAD).abs() < 1e-12);
        assert_abs_diff_eq!(wrench.moment_x, 0.5 * 0.2 * wrench.force_y, epsilon = 1e-12);
        let leaning = tyre.wrench(&Contact { camber: 0.1, ..contact(0.0, 0.0) });
        assert_abs_diff_eq!(leaning.moment_x, 0.2 * (0.5 * leaning.force_y - 0.3 * 0.1 * LOAD), epsilon = 1e-12);
    }

    /// Driving and braking have separate curvatures, E = pex1 (1 - pex4 sgn k_x).
    #[test]
    fn curvature_depends_on_the_sign_of_slip() {
        let uneven = tyre(&[("pex1", 0.5), ("pex4", 0.3)]);
        for (slip, curvature) in [(0.1, 0.35), (-0.1, 0.65)] {
            let even = tyre(&[("pex1", curvature), ("pex4", 0.0)]);
            let [a, b] = [&uneven, &even].map(|tyre| tyre.wrench(&contact(slip, 0.0)).force_x);
            assert!((a - b).abs() < 1e-9, "{slip}: {a} {b}");
        }
    }

    /// Camber moves the curve of the lateral force by phy3 gamma against the side slip.
    #[test]
    fn camber_shifts_the_side_slip() {
        let tyre = tyre(&[("phy3", 0.1), ("pvy3", 0.0), ("pvy4", 0.0)]);
        let force = tyre.wrench(&Contact { camber: 0.1, ..contact(0.0, -0.01) }).force_y;
        assert!(force.abs() < 1e-9, "{force}");
    }

    /// At twice the nominal load df = 1; the rolling resistance grows with V / V_0 = 20 / 16.7.
    #[test]
    fn moments_change_with_load_and_speed() {
        let tyre = tyre(&[("qdz6", 0.1), ("qdz7", 0.05), ("qsy3", 0.02)]);
        let wrench = tyre.wrench(&Contact { load: 2.0 * LOAD, ..contact(0.0, 0.0) });
        assert!((wrench.moment_z - 0.15 * 0.2 * 2.0 * LOAD).abs() < 1e-9, "{}", wrench.moment_z);
        assert!((wrench.moment_y + 0.02 * 20.0 / 16.7 * 0.2 * 2.0 * LOAD).abs() < 1e-9, "{}", wrench.moment_y);
    }

    /// A longitudinal force off the centre line makes a torque about z.
    #[test]
    fn longitudinal_force_turns_by_its_arm() {
        let [without, with] = [0.0, 0.03].map(|arm| tyre(&[("ssz1", arm)]).wrench(&contact(0.05, 0.0)));
        assert_abs_diff_eq!(with.moment_z - without.moment_z, 0.03 * 0.2 * with.force_x, epsilon = 1e-12);
    }

    /// Shifts point to one side; the tyre of the other side is its mirror image.
    #[test]
    fn other_side_is_the_mirror_image() {
        let tyre = tyre(&[("lhy", 1.0), ("lvy", 1.0), ("qdz1", 0.1), ("qcz1", 1.0), ("qbz1", 5.0), ("qsx1", 0.1)]);
        let left = tyre.wrench_on(Side::Left, &Contact { camber: 0.02, ..contact(0.01, 0.03) });
        let right = tyre.wrench_on(Side::Right, &Contact { camber: -0.02, ..contact(0.01, -0.03) });
        assert_eq!([left.force_x, left.moment_y], [right.force_x, right.moment_y]);
        assert_eq!([left.force_y, left.moment_x, left.moment_z], [-right.force_y, -right.moment_x, -right.moment_z]);
        assert!(tyre.wrench_on(Side::Left, &contact(0.0, 0.0)).force_y.abs() > 10.0);
    }

    /// Also where a quotient of the formula loses its denominator.
    #[test]
    fn finite_for_every_contact() {
        let tyres = [
            tyre(&[]),
            tyre(&[("pky1", 0.0), ("pkx1", 0.0), ("pkx2", 0.0), ("qbz10", 1.0), ("qdz6", 0.1)]),
            tyre(&[("pdy1", 0.0), ("pdy2", 0.0), ("pdx1", 0.0), ("pdx2", 0.0), ("qbz10", 1.0)]),
            tyre(&[("pcy1", 0.0), ("pcx1", 0.0), ("rcx1", 0.0), ("rcy1", 0.0)]),
            tyre(&[("pky2", 0.0)]),
            tyre(&[("version", 2.0), ("lmuv", 0.5), ("qdz6", 0.1), ("qsy7", 0.8), ("qsy8", -0.4), ("ppy1", 2.0)]),
            tyre(&[("version", 2.0), ("pky2", 0.0), ("pkx1", 0.0), ("pkx2", 0.0), ("pdy1", 0.0), ("pdy2", 0.0)]),
        ];
        let slips = [-10.0, -1.0, -0.1, 0.0, 1e-300, 0.5, 10.0];
        for tyre in &tyres {
            for load in [-10.0, 0.0, 1e-300, 1.0, 700.0, 1e4] {
                for (kappa, alpha) in slips.iter().flat_map(|kappa| slips.map(|alpha| (*kappa, alpha))) {
                    for camber in [-0.3, 0.0, 0.3] {
                        let wrench = tyre.wrench(&Contact { load, camber, ..contact(kappa, alpha) });
                        let Wrench { force_x, force_y, moment_x, moment_y, moment_z } = wrench;
                        let sum = force_x + force_y + moment_x + moment_y + moment_z;
                        assert!(sum.is_finite(), "{load} {kappa} {alpha} {camber}: {wrench:?}");
                        assert!(load > 0.0 || sum == 0.0);
                    }
                }
            }
        }
    }
}
