//! Vertical spring and radii of a rolling tyre: equations (1) to (7) of [`TyreSpring`].

use std::cell::Cell;
use std::fmt;

use crate::host::magic_formula::{Contact, FormulaVersion, MagicFormula, Side, Wrench, quotient};
use crate::host::tyre_spring::TyreSpring;
use crate::number::{Dual, Mask, Scalar};
use crate::numerics::root;

/// State of a wheel on which the spring of its tyre depends.
#[derive(Clone, Copy, Debug)]
pub struct Rolling<T = f64> {
    /// Longitudinal force of the road, N.
    pub force_x: T,
    /// Lateral force of the road, N.
    pub force_y: T,
    /// Camber, rad; positive when the top leans to the right.
    pub camber: T,
    /// Angular velocity of the wheel about its axis, rad/s.
    pub spin: T,
}

/// Radii of a tyre under load.
#[derive(Clone, Copy, Debug)]
pub struct Radii<T = f64> {
    /// Radius R_Omega of the rolling tyre without load, m.
    pub free: T,
    /// Distance R_l of the centre of the wheel from the road, in the plane of the wheel, m.
    pub loaded: T,
    /// Effective rolling radius R_e, m: the speed of a wheel without slip per angular velocity.
    pub effective: T,
    /// Vertical deflection rho, m; R_Omega - R_l without camber.
    pub deflection: T,
}

/// Reason why a tyre has no radii.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoRadii {
    /// No loaded radius carries the load.
    Load {
        /// Least load that is carried, N.
        least: f64,
        /// Largest load that was found, N.
        most: f64,
    },
    /// The wheel would roll on a radius of 0 or less.
    Rolling,
}

impl fmt::Display for NoRadii {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            NoRadii::Load { least, most } => write!(
                f,
                "no deflection carries it: with these forces, this camber and this speed the formula carries from \
                 {least:.1} to {most:.1} N"
            ),
            NoRadii::Rolling => f.write_str(
                "no rolling radius: with its q_re0, q_v1, dreff and freff the tyre would roll on 0 m or less",
            ),
        }
    }
}

impl std::error::Error for NoRadii {}

impl<T: Scalar> MagicFormula<T> {
    /// Radii of a tyre on one side of the car with the stiffness C_z0, for a contact and the forces there; all are 0 if
    /// it has none. The wheel turns with the slip of the contact.
    pub fn radii_on(&self, side: Side, stiffness: T, contact: &Contact<T>, wrench: &Wrench<T>) -> Radii<T> {
        self.case(side, stiffness, contact, wrench).radii()
    }

    /// Load of a tyre on one side of the car with the stiffness C_z0, for its loaded radius.
    pub fn load_on(&self, side: Side, stiffness: T, rolling: &Rolling<T>, loaded_radius: T) -> T {
        self.spring_on(side, stiffness, rolling).load(loaded_radius)
    }

    /// Largest `q_fz2` that (3) admits for the stiffness C_z0.
    pub fn largest_q_fz2(&self, stiffness: T) -> T {
        let linear = stiffness * self.unloaded_radius / self.fnomin;
        linear * linear / T::from(4.0)
    }

    fn spring_on(&self, side: Side, stiffness: T, rolling: &Rolling<T>) -> Spring<T> {
        let Rolling { force_x, force_y, camber, spin } = *rolling;
        let none = T::zero();
        let contact = Contact { load: none, longitudinal_slip: none, side_slip: none, camber, speed: none };
        let wrench = Wrench { force_x, force_y, moment_x: none, moment_y: none, moment_z: none };
        let case = self.case(side, stiffness, &contact, &wrench);
        case.spring(spin * case.radius / case.reference)
    }

    fn case(&self, side: Side, stiffness: T, contact: &Contact<T>, wrench: &Wrench<T>) -> Case<T> {
        let sign = T::from(if Side::of(self.side.value()) == side { 1.0 } else { -1.0 });
        let pressure = match FormulaVersion::of(self.version.value()) {
            FormulaVersion::Five => T::zero(),
            FormulaVersion::Six => (self.inflpres - self.nompres) / self.nompres,
        };
        Case {
            columns: self.spring,
            radius: self.unloaded_radius,
            nominal: self.fnomin,
            reference: self.longvl,
            pressure,
            stiffness,
            load: contact.load.larger(T::zero()),
            speed: (T::from(1.0) + contact.longitudinal_slip) * contact.speed,
            force_x: wrench.force_x,
            force_y: sign * wrench.force_y,
            camber: sign * contact.camber,
        }
    }
}

impl MagicFormula {
    /// As [`MagicFormula::radii_on`], or the reason why the tyre has none.
    pub fn checked_radii_on(
        &self,
        side: Side,
        stiffness: f64,
        contact: &Contact,
        wrench: &Wrench,
    ) -> Result<Radii, NoRadii> {
        let case = self.case(side, stiffness, contact, wrench);
        case.standing()?;
        Ok(case.radii())
    }
}

/// What the radii depend on, on the side on which the set was measured.
struct Case<T> {
    columns: TyreSpring<T>,
    /// R_0.
    radius: T,
    /// F_z0.
    nominal: T,
    /// V_0.
    reference: T,
    /// dp.
    pressure: T,
    /// C_z0.
    stiffness: T,
    load: T,
    /// (1 + kappa) V.
    speed: T,
    force_x: T,
    force_y: T,
    camber: T,
}

/// Most steps of the search: down to the centre of a tyre with twice its unloaded radius (chosen).
const LOOKS: u32 = 128;

/// A zero of a function, and the slope of the function there; both are 0 if there is none.
type Found = [f64; 2];

impl<T: Scalar> Case<T> {
    /// The same case in another number type.
    fn map<U: Copy>(&self, convert: &impl Fn(T) -> U) -> Case<U> {
        let Case { radius, nominal, reference, pressure, stiffness, load, speed, force_x, force_y, camber, .. } = *self;
        let [radius, nominal, reference, pressure, stiffness] =
            [radius, nominal, reference, pressure, stiffness].map(convert);
        let [load, speed, force_x, force_y, camber] = [load, speed, force_x, force_y, camber].map(convert);
        let columns = self.columns.map(convert);
        Case { columns, radius, nominal, reference, pressure, stiffness, load, speed, force_x, force_y, camber }
    }

    /// Numbers on which all others depend.
    fn all(&self) -> [T; 1] {
        let sum = Cell::new(T::zero());
        self.map(&|number| sum.set(sum.get() + number));
        [sum.get()]
    }

    /// The radii. What is searched for is found on plain numbers; a step of Newton's method from there has the
    /// derivatives.
    fn radii(&self) -> Radii<T> {
        let plain = |lane: usize| self.map(&|number| number.lane(lane));
        let [effective, slope] = T::found(|| self.all(), |lane| plain(lane).rolling().unwrap_or_default());
        let effective = effective - quotient(self.excess_radius(effective), slope);
        let spring = self.spring(quotient(self.speed * self.radius, effective * self.reference));
        let [loaded, slope] = T::found(|| self.all(), |lane| plain(lane).standing().unwrap_or_default());
        let is_carried = !loaded.vanishes();
        let carrying = || loaded - quotient(spring.load(loaded) - self.load, slope);
        let loaded = self.load.is_positive().choose(carrying, || spring.touching());
        let zero = T::zero;
        Radii {
            free: is_carried.choose(|| spring.free, zero),
            loaded: is_carried.choose(|| loaded, zero),
            effective: is_carried.choose(|| effective, zero),
            deflection: is_carried.choose(|| spring.deflection(loaded), zero),
        }
    }

    /// a and b of (7): with (1) and Omega = v / R_e it is R_e^2 (R_e - a) = b.
    fn of_effective_radius(&self) -> [T; 2] {
        let (columns, ratio) = (&self.columns, self.load / self.nominal);
        let decrease = columns.dreff * (columns.breff * ratio).atan() + columns.freff * ratio;
        let stiffness = self.stiffness * (T::from(1.0) + columns.pfz1 * self.pressure);
        let turn = self.radius * self.speed / self.reference;
        let a = self.radius * columns.q_re0 - quotient(self.nominal, stiffness) * decrease;
        [a, self.radius * columns.q_v1 * turn * turn]
    }

    fn excess_radius(&self, radius: T) -> T {
        let [a, b] = self.of_effective_radius();
        radius * radius * (radius - a) - b
    }

    /// The spring of a wheel that turns with Omega R_0 / V_0.
    fn spring(&self, turn: T) -> Spring<T> {
        let (one, camber, columns) = (T::from(1.0), self.camber, self.columns);
        let linear = self.stiffness * self.radius / self.nominal;
        let along = columns.q_fcx * self.force_x / self.nominal;
        let is_round = columns.q_cam1.vanishes() & columns.q_cam2.vanishes();
        let tread = (T::from(1.075) - T::from(0.5) * columns.aspect_ratio) * columns.width;
        let edge = || tread * (camber.sin() / camber.cos()).abs() / T::from(2.0);
        Spring {
            columns,
            camber,
            force_y: self.force_y,
            radius: self.radius,
            nominal: self.nominal,
            // (1)
            free: self.radius * (columns.q_re0 + columns.q_v1 * turn * turn),
            // (3)
            linear: (linear * linear - T::from(4.0) * columns.q_fz2).sqrt() + columns.q_cam * camber * camber,
            scale: self.nominal * (one + columns.pfz1 * self.pressure),
            growth: one + columns.q_v2 * turn.abs() - along * along,
            edge: is_round.choose(T::zero, edge),
        }
    }
}

impl Case<f64> {
    /// R_e, to which Newton's method comes down from a larger radius.
    fn rolling(&self) -> Result<Found, NoRadii> {
        let [a, b] = self.of_effective_radius();
        let has_root = a > 0.0 && b > -4.0 / 27.0 * a * a * a;
        let slope = |radius: f64| radius * (3.0 * radius - 2.0 * a);
        let mut radius = a + (b / (a * a)).max(0.0);
        if !has_root || !radius.is_finite() {
            return Err(NoRadii::Rolling);
        }
        loop {
            let next = radius - self.excess_radius(radius) / slope(radius);
            if next < radius {
                radius = next;
            } else {
                return Ok([radius, slope(radius)]);
            }
        }
    }

    /// R_l, where the load of the spring is that of the case.
    fn standing(&self) -> Result<Found, NoRadii> {
        let [effective, _] = self.rolling()?;
        let spring = self.spring(self.speed * self.radius / (effective * self.reference));
        if self.load > 0.0 { spring.radius_for(self.load) } else { Ok([spring.touching(), 0.0]) }
    }
}

/// The spring of a tyre in a state of its wheel.
struct Spring<T> {
    columns: TyreSpring<T>,
    camber: T,
    force_y: T,
    /// R_0.
    radius: T,
    /// F_z0.
    nominal: T,
    /// R_Omega.
    free: T,
    /// q_fz1.
    linear: T,
    /// F_z0 (1 + pfz1 dp).
    scale: T,
    /// g without the lateral force.
    growth: T,
    /// h.
    edge: T,
}

impl<T: Scalar> Spring<T> {
    /// The same spring in another number type.
    fn map<U: Copy>(&self, convert: &impl Fn(T) -> U) -> Spring<U> {
        let [camber, force_y, radius, nominal] = [self.camber, self.force_y, self.radius, self.nominal].map(convert);
        let [free, linear, scale, growth, edge] =
            [self.free, self.linear, self.scale, self.growth, self.edge].map(convert);
        Spring {
            columns: self.columns.map(convert),
            camber,
            force_y,
            radius,
            nominal,
            free,
            linear,
            scale,
            growth,
            edge,
        }
    }

    /// The largest loaded radius at which the tyre touches the road.
    fn touching(&self) -> T {
        self.free + self.edge
    }

    /// rho (6); 0 where the tyre does not touch.
    fn deflection(&self, loaded_radius: T) -> T {
        let (depth, four) = (self.free - loaded_radius, T::from(4.0));
        let of_shoulder = || {
            let touching = (depth + self.edge).larger(T::zero());
            quotient(touching * touching, four * self.edge)
        };
        let of_tread = || {
            let tread = |radius: T| (self.columns.q_cam1 + self.columns.q_cam2 * radius) * radius;
            let ratio = quotient(tread(loaded_radius), tread(self.free));
            let by_camber = ratio * ratio * self.edge / four - self.columns.q_cam3 * depth * self.camber.abs();
            (depth + by_camber).larger(T::zero())
        };
        depth.below(T::zero()).choose(of_shoulder, of_tread)
    }

    /// (2), or the load of the rim if that is larger.
    fn load(&self, loaded_radius: T) -> T {
        let TyreSpring { q_fz2, bottom_stiff, rim_radius, bottom_offst, .. } = self.columns;
        let ratio = self.deflection(loaded_radius) / self.radius;
        let of_rim = (bottom_stiff * (rim_radius + bottom_offst - loaded_radius)).larger(T::zero());
        let of_tyre = || {
            let growth = (self.growth - self.softening(ratio, loaded_radius / self.free)).larger(T::zero());
            self.scale * growth * (self.linear + q_fz2 * ratio) * ratio
        };
        ratio.is_positive().choose(|| of_tyre().larger(of_rim), || of_rim)
    }

    /// The last term of (4), for rho / R_0 and R_l / R_Omega.
    fn softening(&self, deflection: T, radius: T) -> T {
        let TyreSpring { q_fcy, q_fcy2, q_fys1, q_fys2, q_fys3, .. } = self.columns;
        let unfelt = (q_fys1 + (q_fys2 + q_fys3 * radius) * radius) * self.camber;
        let power = q_fcy2.is(0.0).choose(|| T::from(1.0), || deflection.powf(q_fcy2));
        let ratio = power * q_fcy * (self.force_y - unfelt) / self.nominal;
        ratio * ratio
    }
}

impl Spring<f64> {
    /// The largest loaded radius that carries a load, and the slope of the load there.
    fn radius_for(&self, load: f64) -> Result<Found, NoRadii> {
        let [low, high] = self.bracket(load)?;
        let dual = self.map(&Dual::from);
        let excess = |depth: f64| dual.load(Dual { value: high - depth, slope: -1.0 }) - Dual::from(load);
        let depth = root::newton(excess, 0.0, high - low);
        Ok([high - depth, -excess(depth).slope])
    }

    /// A smaller and a larger radius between which the load is first carried.
    fn bracket(&self, load: f64) -> Result<[f64; 2], NoRadii> {
        let mut high = self.touching();
        let least = self.load(high);
        let mut most = least;
        // A step that is too small for the radius, or a radius that is no number, ends the search.
        for _ in 0..LOOKS {
            let low = (high - self.radius / 64.0).max(0.0);
            if !(load >= least && low < high) {
                break;
            }
            let carried = self.load(low);
            if carried >= load {
                return Ok([low, high]);
            }
            most = most.max(carried);
            high = low;
        }
        Err(NoRadii::Load { least, most })
    }
}

#[cfg(test)]
mod tests;
