//! Units of the columns: name, SI base exponents, the quantity they measure and the display units an importer may
//! offer.

/// A unit as FMI 2.0.5 section 2.2.2 describes it: a product of powers of SI base units.
#[derive(Debug, PartialEq)]
pub struct Unit {
    /// Name as in modelDescription.xml, for example `N.s/m`; `1` for a pure number.
    pub name: &'static str,
    /// The physical quantity, used as the name of the type definition.
    pub quantity: &'static str,
    /// Exponent of the kilogram.
    pub kg: i8,
    /// Exponent of the metre.
    pub m: i8,
    /// Exponent of the second.
    pub s: i8,
    /// Exponent of the ampere.
    pub ampere: i8,
    /// Exponent of the kelvin.
    pub kelvin: i8,
    /// Exponent of the radian.
    pub rad: i8,
    /// Units in which a user interface may show the value; the first one is the default.
    pub display: &'static [DisplayUnit],
}

/// A display unit: value shown = `factor` * value in the SI unit + `offset`.
#[derive(Debug, PartialEq)]
pub struct DisplayUnit {
    /// Name, for example `mm/s`.
    pub name: &'static str,
    /// Values in this unit per SI value.
    pub factor: f64,
    /// Value shown for an SI value of 0; nonzero for temperatures only.
    pub offset: f64,
}

const fn shown(name: &'static str, factor: f64) -> DisplayUnit {
    DisplayUnit { name, factor, offset: 0.0 }
}

/// Degrees per radian.
const DEGREES: f64 = 180.0 / std::f64::consts::PI;

const fn unit(
    name: &'static str,
    quantity: &'static str,
    [kg, m, s]: [i8; 3],
    display: &'static [DisplayUnit],
) -> Unit {
    Unit { name, quantity, kg, m, s, ampere: 0, kelvin: 0, rad: 0, display }
}

impl Unit {
    /// The base units of this unit, each with its exponent.
    pub fn base_units(&self) -> impl Iterator<Item = (&'static str, i8)> {
        ["kg", "m", "s", "A", "K", "rad"].into_iter().zip(self.exponents()).filter(|(_, exponent)| *exponent != 0)
    }

    /// Exponents of kg, m, s, A, K and rad.
    pub const fn exponents(&self) -> [i8; 6] {
        [self.kg, self.m, self.s, self.ampere, self.kelvin, self.rad]
    }

    const fn with_ampere(mut self, power: i8) -> Unit {
        self.ampere = power;
        self
    }

    const fn per_kelvin(mut self, power: i8) -> Unit {
        self.kelvin = -power;
        self
    }

    const fn times_radian(mut self) -> Unit {
        self.rad = 1;
        self
    }

    const fn per_radian(mut self) -> Unit {
        self.rad = -1;
        self
    }
}

/// Every unit that a column may have.
pub static UNITS: [Unit; 42] = [
    unit("1", "Ratio", [0, 0, 0], &[]),
    unit("m", "Length", [0, 1, 0], &[shown("mm", 1e3), shown("um", 1e6)]),
    unit("m/s", "Velocity", [0, 1, -1], &[shown("mm/s", 1e3)]),
    unit("m/s2", "Acceleration", [0, 1, -2], &[]),
    unit("s", "Duration", [0, 0, 1], &[shown("ms", 1e3)]),
    unit("kg", "Mass", [1, 0, 0], &[]),
    unit("N", "Force", [1, 1, -2], &[shown("kN", 1e-3)]),
    unit("N/s", "ForceRate", [1, 1, -3], &[]),
    unit("N/m", "Stiffness", [1, 0, -2], &[shown("N/mm", 1e-3)]),
    unit("N.s/m", "ViscousCoefficient", [1, 0, -1], &[shown("N.s/mm", 1e-3)]),
    unit("s/m", "InverseVelocity", [0, -1, 1], &[]),
    unit("N.s2/m2", "QuadraticDragCoefficient", [1, -1, 0], &[]),
    unit("J", "Energy", [1, 2, -2], &[]),
    unit("W", "Power", [1, 2, -3], &[]),
    unit("N.m", "Torque", [1, 2, -2], &[]),
    unit("N/m2", "ProgressiveStiffness", [1, -1, -2], &[]),
    unit("N/m3", "CubicStiffness", [1, -2, -2], &[]),
    unit("Pa", "Pressure", [1, -1, -2], &[shown("bar", 1e-5)]),
    unit("m3", "Volume", [0, 3, 0], &[shown("cm3", 1e6)]),
    unit("kg.m2", "MomentOfInertia", [1, 2, 0], &[]),
    unit("rad", "Angle", [0, 0, 0], &[shown("deg", DEGREES)]).times_radian(),
    unit("rad/s", "AngularVelocity", [0, 0, -1], &[shown("deg/s", DEGREES)]).times_radian(),
    unit("rad/s2", "AngularAcceleration", [0, 0, -2], &[]).times_radian(),
    unit("1/s", "Rate", [0, 0, -1], &[]),
    unit("1/m", "PerLength", [0, -1, 0], &[]),
    unit("Hz", "Frequency", [0, 0, -1], &[]),
    unit("K", "Temperature", [0, 0, 0], &[DisplayUnit { name: "degC", factor: 1.0, offset: -273.15 }]).per_kelvin(-1),
    unit("K/s", "TemperatureRate", [0, 0, -1], &[]).per_kelvin(-1),
    unit("1/K", "PerTemperature", [0, 0, 0], &[]).per_kelvin(1),
    unit("J/K", "HeatCapacity", [1, 2, -2], &[]).per_kelvin(1),
    unit("W/K", "ThermalConductance", [1, 2, -3], &[]).per_kelvin(1),
    unit("1/m2", "PerArea", [0, -2, 0], &[]),
    unit("1/N", "PerForce", [-1, -1, 2], &[]),
    unit("V", "Voltage", [1, 2, -3], &[]).with_ampere(-1),
    unit("V/rad", "VoltagePerAngle", [1, 2, -3], &[]).with_ampere(-1).per_radian(),
    unit("Ohm", "Resistance", [1, 2, -3], &[]).with_ampere(-2),
    unit("N.m/A", "TorquePerCurrent", [1, 2, -2], &[]).with_ampere(-1),
    unit("V/s", "VoltageRate", [1, 2, -4], &[]).with_ampere(-1),
    unit("N/(m.V)", "StiffnessPerVoltage", [0, -2, 1], &[]).with_ampere(1),
    unit("N.s/(m.V)", "ViscousCoefficientPerVoltage", [0, -2, 2], &[]).with_ampere(1),
    unit("N/(m.s)", "StiffnessRate", [1, 0, -3], &[]),
    unit("m.s", "Absement", [0, 1, 1], &[]),
];

/// The unit of this name. A column with an unknown unit does not compile.
pub(crate) const fn named(name: &str) -> &'static Unit {
    &UNITS[place(name)]
}

/// Place among [`UNITS`] of the unit of this name.
pub(crate) const fn place(name: &str) -> usize {
    let mut at = 0;
    while at < UNITS.len() {
        if same(UNITS[at].name, name) {
            return at;
        }
        at += 1;
    }
    panic!("unknown unit: add it to UNITS in src/unit.rs");
}

/// Equality of texts in a `const fn`, where `==` on `str` is not available.
pub(crate) const fn same(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let end = a.len();
    if end != b.len() {
        return false;
    }
    let mut at = 0;
    while at < end {
        if a[at] != b[at] {
            return false;
        }
        at += 1;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_unit_is_found_by_its_name() {
        for (at, unit) in UNITS.iter().enumerate() {
            assert_eq!(place(unit.name), at, "{} is listed once", unit.name);
            assert!(same(named(unit.name).name, unit.name));
        }
        assert!(!same("N.m", "N/m") && !same("N", "N.m"));
    }

    #[test]
    #[should_panic(expected = "unknown unit")]
    fn a_unit_that_is_not_listed_is_refused() {
        named("furlong");
    }
}
