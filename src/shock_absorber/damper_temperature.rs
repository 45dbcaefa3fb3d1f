use crate::model::{Derivatives, Fault, Law, Model, ModelExchange, Preset, boolean, real};
use crate::number::{Mask, Scalar};
use crate::numerics::relaxation;

crate::part! {
    /// Heating of the damper.
    Heating {
        /// Does the temperature change and affect the damper force?
        enabled: fixed = boolean(false),
        /// Relative loss of damper force per kelvin (default chosen).
        beta: tunable = real("1/K", 0.003).at_least(0.0),
        /// Temperature at which the damper's characteristic was measured (default chosen).
        temperature_ref: fixed = real("K", 293.15).positive().nominal(300.0).shown_in("degC"),
        /// Heat capacity of the damper (default chosen: 0.6 kg of aluminium and oil).
        capacity: fixed = real("J/K", 600.0).positive().nominal(500.0),
        /// Heat flow to the surroundings per kelvin (default chosen).
        conductance: tunable = real("W/K", 1.5).at_least(0.0),
    }
}

impl<T: Scalar> Heating<T> {
    /// Factor on the damper force.
    pub fn factor(&self, temperature: T) -> T {
        let factor = || (-self.beta * (temperature - self.temperature_ref)).exp();
        self.enabled.vanishes().choose(|| T::from(1.0), factor)
    }

    /// Time derivative of the temperature.
    pub(crate) fn rate(&self, temperature: T, ambient: T, power: T) -> T {
        let rate = || (power - self.conductance * (temperature - ambient)) / self.capacity;
        self.enabled.vanishes().choose(|| T::zero(), rate)
    }
}

impl Heating {
    /// Warns of an ambient temperature that has not been set.
    pub(crate) fn warning(&self, ambient: f64) -> Option<Fault> {
        let text = "temperature_ambient = 0 K: the damper cools towards 0 K; set the temperature of the surroundings";
        (self.enabled != 0.0 && ambient == 0.0).then(|| Fault::new(text))
    }

    /// Temperature after a time with constant power and ambient temperature.
    pub(crate) fn after(&self, temperature: f64, ambient: f64, power: f64, dt: f64) -> f64 {
        if self.enabled == 0.0 {
            return temperature;
        }
        if self.conductance == 0.0 {
            return temperature + power * dt / self.capacity;
        }
        let steady = ambient + power / self.conductance;
        relaxation::after(temperature, steady, self.conductance * dt / self.capacity)
    }
}

crate::model! {
    /// Temperature of a damper: the dissipated power heats it, and a hot damper is softer.
    ///
    /// # Equations
    ///
    /// ```text
    /// C dT/dt = P - h (T - T_a)
    /// s = exp(-beta (T - T_r))
    /// ```
    ///
    /// | symbol | variable                  | unit | meaning                                              |
    /// |--------|---------------------------|------|------------------------------------------------------|
    /// | P      | `power`                   | W    | power dissipated in the damper                       |
    /// | T_a    | `temperature_ambient`     | K    | ambient temperature                                  |
    /// | T      | `temperature`             | K    | temperature of the damper                            |
    /// | C      | `thermal.capacity`        | J/K  | heat capacity                                        |
    /// | h      | `thermal.conductance`     | W/K  | heat flow to the surroundings per kelvin             |
    /// | beta   | `thermal.beta`            | 1/K  | relative loss of force per kelvin                    |
    /// | T_r    | `thermal.temperature_ref` | K    | temperature at which the characteristic was measured |
    /// | s      | `force_factor`            | 1    | factor on the damper force                           |
    ///
    /// # Sign
    /// `power` is positive when it heats.
    ///
    /// # Step
    /// Exact for held inputs.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// One temperature for oil and body; the viscosity law is a plain exponential. Nothing happens unless
    /// `thermal.enabled` is true. A `temperature_ambient` of 0 K, as with an input that is not set yet, is used as it
    /// is; with heating it gives a warning.
    ///
    /// # Source
    /// Heat balance. All defaults are chosen.
    ///
    /// # Example
    /// ```
    /// use stribeck::model::Model;
    /// use stribeck::shock_absorber::DamperTemperature;
    /// let mut damper = DamperTemperature { power: 60.0, ..Default::default() };
    /// damper.thermal.enabled = 1.0;
    /// damper.step(1e6);
    /// assert!((damper.temperature - 333.15).abs() < 1e-9); // 60 W / 1.5 W/K above 293.15 K
    /// ```
    DamperTemperature: "Temperature of a damper and its effect on the force" {
        /// Power dissipated in the damper.
        power: input = real("W", 0.0),
        /// Ambient temperature.
        temperature_ambient: input = real("K", 293.15).at_least(0.0).nominal(300.0).shown_in("degC"),
        /// Heating.
        thermal: Heating,
        /// Temperature of the damper.
        temperature: state_output = real("K", 293.15).positive().nominal(300.0).shown_in("degC"),
        /// Factor on the damper force.
        force_factor: output = real("1", 1.0),
    }
}

impl<T: Scalar> Law for DamperTemperature<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.force_factor = self.thermal.factor(self.temperature);
    }
}

impl<T: Scalar> Derivatives for DamperTemperature<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.temperature = self.thermal.rate(self.temperature, self.temperature_ambient, self.power);
    }
}

impl Model for DamperTemperature {
    const PRESETS: &'static [Preset] = &[Preset {
        name: "heating",
        source: "Example with 50 W, heating switched on",
        values: &[("power", 50.0), ("thermal.enabled", 1.0)],
    }];

    fn warning(&self) -> Option<Fault> {
        self.thermal.warning(self.temperature_ambient)
    }

    fn step(&mut self, dt: f64) {
        self.temperature = self.thermal.after(self.temperature, self.temperature_ambient, self.power, dt);
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    #[test]
    fn insulated_damper_keeps_all_heat() {
        let mut damper = DamperTemperature { power: 60.0, ..Default::default() };
        (damper.thermal.enabled, damper.thermal.conductance) = (1.0, 0.0);
        damper.step(100.0);
        assert_abs_diff_eq!(damper.temperature, 303.15, epsilon = 1e-10);
        damper.output();
        assert_abs_diff_eq!(damper.force_factor, (-0.03f64).exp(), epsilon = 1e-14);
    }

    #[test]
    fn disabled_heating_changes_nothing() {
        let mut damper = DamperTemperature { power: 1e6, ..Default::default() };
        damper.step(1e6);
        damper.output();
        assert_eq!([damper.temperature, damper.force_factor], [293.15, 1.0]);
    }
}
