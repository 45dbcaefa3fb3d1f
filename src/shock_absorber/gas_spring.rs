use crate::model::{Brief, Derivatives, Fault, Law, Model, ModelExchange, boolean, real};
use crate::number::{Mask, Scalar};

crate::part! {
    /// Gas compressed by the rod.
    GasChamber {
        /// Is there a gas force?
        enabled: fixed = boolean(true),
        /// Absolute gas pressure at full extension (default chosen).
        p0: tunable = real("Pa", 1e6).at_least(0.0).nominal(1e6),
        /// Gas volume at full extension (default chosen).
        V0: fixed = real("m3", 3e-5).positive().nominal(1e-5),
        /// Polytropic exponent (default chosen).
        n: fixed = real("1", 1.2).at_least(0.0),
        /// Diameter of the rod (default chosen).
        rod_diameter: fixed = real("m", 0.014).at_least(0.0).shown_in("mm"),
        /// Ambient pressure.
        p_ambient: tunable = real("Pa", 101_325.0).at_least(0.0).nominal(1e5),
    }
}

impl<T: Scalar> GasChamber<T> {
    fn rod_area(&self) -> T {
        T::from(std::f64::consts::FRAC_PI_4) * self.rod_diameter * self.rod_diameter
    }

    /// Force on the rod at a compression from full extension.
    pub fn force(&self, compression: T) -> T {
        self.enabled.vanishes().choose(|| T::zero(), || self.force_of_gas(compression))
    }

    fn force_of_gas(&self, compression: T) -> T {
        let area = self.rod_area();
        let volume = self.V0 - area * compression;
        let compressed = || {
            let pressure = self.p0 * (self.V0 / volume).powf(self.n);
            (pressure - self.p_ambient) * area
        };
        // An integer exponent would still give a pressure without a volume, even a negative one.
        volume.at_most(T::zero()).choose(|| T::from(f64::NAN), compressed)
    }
}

impl GasChamber {
    /// Refuses a volume that the rod fills before the end of the stroke.
    pub(crate) fn check(&self, stroke: f64) -> Result<(), Fault> {
        let displaced = self.rod_area() * stroke;
        if self.enabled != 0.0 && self.V0 <= displaced {
            return Err(Fault::new(format_args!(
                "gas.V0 = {} m3: must be > {displaced:e} m3, the volume of the rod over a stroke of {stroke} m",
                self.V0
            )));
        }
        Ok(())
    }

    /// Compression at which the rod fills the whole volume.
    pub(crate) fn largest_compression(&self) -> f64 {
        self.V0 / self.rod_area()
    }

    /// Refuses a compression at which the rod fills the whole volume.
    pub(crate) fn check_compression(&self, compression: f64) -> Result<(), Fault> {
        let most = self.largest_compression();
        if self.enabled != 0.0 && compression >= most {
            let (compression, most) = (Brief(compression), Brief(most));
            return Err(Fault::new(format_args!(
                "compression = {compression} m: must be < {most} m, where the rod fills the volume gas.V0"
            )));
        }
        Ok(())
    }
}

crate::model! {
    /// Gas spring: the force of the gas in a shock absorber on its rod.
    ///
    /// # Equations
    ///
    /// ```text
    /// F = (p - p_a) A
    /// p = p_0 (V_0 / (V_0 - A x))^n
    /// A = pi / 4 d^2
    /// ```
    ///
    /// | symbol | variable           | unit | meaning                               |
    /// |--------|--------------------|------|---------------------------------------|
    /// | x      | `compression`      | m    | compression from full extension       |
    /// | p_0    | `gas.p0`           | Pa   | absolute pressure at full extension   |
    /// | V_0    | `gas.V0`           | m3   | gas volume at full extension          |
    /// | n      | `gas.n`            | 1    | polytropic exponent, 1 = isothermal   |
    /// | d      | `gas.rod_diameter` | m    | diameter of the rod                   |
    /// | p_a    | `gas.p_ambient`    | Pa   | ambient pressure                      |
    /// | F      | `force`            | N    | force on the rod                      |
    ///
    /// # Sign
    /// `force` is positive when it pushes the rod out.
    ///
    /// # Step
    /// No memory: the force follows the compression.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound. A compression at which the rod fills the whole volume is an error.
    ///
    /// # Limits
    /// One polytropic exponent for all speeds; no heat exchange, no friction of a floating piston.
    ///
    /// # Source
    /// Polytropic change of state. The defaults are chosen: 10 bar, 30 cm3, rod of 14 mm.
    ///
    /// # Example
    /// ```
    /// use stribeck::model::Law;
    /// use stribeck::shock_absorber::GasSpring;
    /// let mut spring = GasSpring::default();
    /// spring.output();
    /// assert!((spring.force - 138.3403).abs() < 1e-4); // (1e6 - 101325) Pa on pi 7^2 mm2
    /// ```
    GasSpring: "Gas force on the rod of a shock absorber" {
        /// Compression from full extension.
        compression: input = real("m", 0.0).shown_in("mm"),
        /// Gas.
        gas: GasChamber,
        /// Gas force on the rod; positive pushes it out.
        force: output = real("N", 0.0),
    }
}

impl<T: Scalar> Law for GasSpring<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.force = self.gas.force(self.compression);
    }
}

impl<T: Scalar> Derivatives for GasSpring<T> {
    /// No state moves with time.
    fn derivatives(&self, _rate: &mut Self) {}
}

impl Model for GasSpring {
    fn check_motion(&self) -> Result<(), Fault> {
        self.gas.check_compression(self.compression)
    }

    fn step(&mut self, _dt: f64) {}
}

#[cfg(test)]
mod tests {
    use crate::catalogue::by_name;
    use crate::instance::Instance;

    /// A strut without gas may be as short as it likes.
    #[test]
    fn no_gas_has_no_force_and_no_limit() {
        let mut spring = Instance::new(by_name("GasSpring").expect("a model"));
        spring.set_by_name("gas.enabled", 0.0).unwrap();
        spring.set_by_name("compression", 10.0).unwrap();
        assert_eq!(spring.get_by_name("force").unwrap(), 0.0);
        spring.step(1e-3).unwrap();
    }

    /// When the rod fills the gas volume there is no pressure, whatever the exponent.
    #[test]
    fn a_rod_that_fills_the_volume_is_an_error() {
        let filled = 3e-5 / (0.25 * std::f64::consts::PI * 0.014 * 0.014);
        for exponent in [0.0, 1.0, 1.2, 2.0] {
            let mut spring = Instance::new(by_name("GasSpring").expect("a model"));
            let column = |name: &str| spring.model().find(name).expect("a column");
            let [compression, n] = [column("compression"), column("gas.n")];
            spring.set_column(n, exponent).unwrap();
            spring.set_column(compression, 0.999 * filled).unwrap();
            spring.refresh().expect("there is gas left");
            for compression_there in [1.001 * filled, 2.0 * filled] {
                spring.set_column(compression, compression_there).unwrap();
                let text = spring.refresh().unwrap_err().to_string();
                let named = format!("compression = {compression_there} m: must be < {filled} m, where the rod fills");
                assert!(text.contains(&named), "n = {exponent}: {text}");
            }
        }
    }
}
