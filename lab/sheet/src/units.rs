//! Quantities and their units in files.

/// A quantity, with its possible units in files: SI value = factor (value + offset). The first unit is the SI one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// Name of the column.
    pub name: &'static str,
    /// Units, factors and offsets.
    pub units: &'static [(&'static str, f64, f64)],
}

impl Quantity {
    /// A quantity by its SI unit; None for a unit that no file has.
    pub fn of(name: &'static str, unit: &str) -> Option<Quantity> {
        let known = QUANTITIES.into_iter().chain([&VOLTAGE]).find(|known| known.units[0].0 == unit)?;
        Some(Quantity { name, units: known.units })
    }
}

/// Time.
pub const TIME: Quantity = Quantity {
    name: "time",
    units: &[
        ("s", 1.0, 0.0),
        ("sec", 1.0, 0.0),
        ("ms", 1e-3, 0.0),
        ("us", 1e-6, 0.0),
        ("ns", 1e-9, 0.0),
        ("min", 60.0, 0.0),
    ],
};
/// Velocity.
pub const VELOCITY: Quantity = Quantity {
    name: "velocity",
    units: &[
        ("m/s", 1.0, 0.0),
        ("mm/s", 1e-3, 0.0),
        ("in/s", 0.0254, 0.0),
        ("km/h", KPH, 0.0),
        ("kph", KPH, 0.0),
        ("mph", MPH, 0.0),
    ],
};
/// Force.
pub const FORCE: Quantity =
    Quantity { name: "force", units: &[("N", 1.0, 0.0), ("kN", 1e3, 0.0), ("lbf", POUND, 0.0), ("lb", POUND, 0.0)] };
/// Normal force.
pub const NORMAL_FORCE: Quantity = Quantity { name: "normal_force", units: FORCE.units };
/// Displacement.
pub const DISPLACEMENT: Quantity = Quantity {
    name: "displacement",
    units: &[("m", 1.0, 0.0), ("mm", 1e-3, 0.0), ("um", 1e-6, 0.0), ("in", 0.0254, 0.0)],
};
/// Temperature.
pub const TEMPERATURE: Quantity = Quantity {
    name: "temperature",
    units: &[("K", 1.0, 0.0), ("degC", 1.0, 273.15), ("C", 1.0, 273.15), ("degF", 5.0 / 9.0, 459.67)],
};

/// Angle.
pub const ANGLE: Quantity =
    Quantity { name: "angle", units: &[("rad", 1.0, 0.0), ("deg", DEGREE, 0.0), ("rev", TURN, 0.0)] };
/// Angular velocity.
pub const ANGULAR_VELOCITY: Quantity = Quantity {
    name: "angular velocity",
    units: &[
        ("rad/s", 1.0, 0.0),
        ("deg/s", DEGREE, 0.0),
        ("rev/s", TURN, 0.0),
        ("rpm", TURN / 60.0, 0.0),
        ("1/min", TURN / 60.0, 0.0),
        ("rev/min", TURN / 60.0, 0.0),
        ("r/min", TURN / 60.0, 0.0),
    ],
};
/// Longitudinal slip.
pub const SLIP: Quantity = Quantity { name: "slip", units: &[("1", 1.0, 0.0), ("%", 0.01, 0.0)] };
/// Pressure.
pub const PRESSURE: Quantity = Quantity {
    name: "pressure",
    units: &[("Pa", 1.0, 0.0), ("kPa", 1e3, 0.0), ("bar", 1e5, 0.0), ("psi", POUND / (0.0254 * 0.0254), 0.0)],
};
/// Electric current.
pub const CURRENT: Quantity = Quantity { name: "current", units: &[("A", 1.0, 0.0), ("mA", 1e-3, 0.0)] };
/// Electric voltage. It is none of [`QUANTITIES`]: columns in volts may be signals of any quantity.
const VOLTAGE: Quantity = Quantity { name: "voltage", units: &[("V", 1.0, 0.0), ("mV", 1e-3, 0.0)] };
/// Moment.
pub const MOMENT: Quantity = Quantity {
    name: "moment",
    units: &[
        ("N.m", 1.0, 0.0),
        ("Nm", 1.0, 0.0),
        ("N*m", 1.0, 0.0),
        ("N-m", 1.0, 0.0),
        ("Ncm", 1e-2, 0.0),
        ("N.cm", 1e-2, 0.0),
        ("N*cm", 1e-2, 0.0),
        ("N-cm", 1e-2, 0.0),
        ("Nmm", 1e-3, 0.0),
        ("N.mm", 1e-3, 0.0),
        ("N*mm", 1e-3, 0.0),
        ("N-mm", 1e-3, 0.0),
        ("mNm", 1e-3, 0.0),
        ("mN.m", 1e-3, 0.0),
        ("mN*m", 1e-3, 0.0),
        ("mN-m", 1e-3, 0.0),
        ("kNm", 1e3, 0.0),
        ("kN.m", 1e3, 0.0),
        ("ft-lb", 0.3048 * POUND, 0.0),
        ("lbf.ft", 0.3048 * POUND, 0.0),
        ("in-lb", 0.0254 * POUND, 0.0),
        ("lbf.in", 0.0254 * POUND, 0.0),
    ],
};

/// Quantities that differ in their units.
pub(super) const QUANTITIES: [&Quantity; 10] =
    [&TIME, &VELOCITY, &FORCE, &DISPLACEMENT, &TEMPERATURE, &ANGLE, &SLIP, &PRESSURE, &MOMENT, &ANGULAR_VELOCITY];

const DEGREE: f64 = std::f64::consts::PI / 180.0;
const TURN: f64 = std::f64::consts::TAU;
/// SI values of a kilometre per hour, a mile per hour and the force of a pound.
const KPH: f64 = 1.0 / 3.6;
const MPH: f64 = 0.447_04;
const POUND: f64 = 4.448_221_615_260_5;
