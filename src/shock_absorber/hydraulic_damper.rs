use std::fmt;
use std::mem::offset_of;

use crate::component::{MagnetorheologicalFluid, MagnetorheologicalState};
use crate::model::ramp;
use crate::model::{Column, Derivatives, Fault, Law, Meaning, Model, ModelExchange, Width, boolean, integer, real};
use crate::number::{Dual, Mask, Scalar};
use crate::numerics::interpolation::Curve;
use crate::numerics::root;
use crate::shock_absorber::coil_spring::{POINTS, check_rising, points};
use crate::shock_absorber::fluid_state::FluidState;

crate::choices! {
    /// Form of a damper's characteristic.
    pub enum DamperMode {
        /// Proportional to the velocity, with two coefficients.
        Linear,
        /// A table over the velocity.
        Table,
        /// Falling slope: c v / (1 + d |v|).
        Degressive,
        /// Hysteresis that follows a voltage: see MagnetorheologicalDamper.
        MagnetorheologicalDamper,
    }
}

crate::choices! {
    /// Curve through the points of a table.
    pub enum Interpolation {
        /// Straight lines.
        Linear,
        /// Monotone cubic: smooth, without overshoot.
        Cubic,
    }
}

crate::part! {
    /// Hydraulic damper.
    Hydraulics {
        /// Is there a damper?
        enabled: fixed = boolean(true),
        /// Form of the damper's characteristic.
        mode: fixed = DamperMode::Linear.start(),
        /// Damping coefficient in compression (default chosen).
        c_comp: tunable = real("N.s/m", 1500.0).at_least(0.0),
        /// Damping coefficient in extension, the rebound (default chosen).
        c_reb: tunable = real("N.s/m", 2300.0).at_least(0.0),
        /// Degression in compression.
        degr_comp: tunable = real("s/m", 0.0).at_least(0.0),
        /// Degression in extension.
        degr_reb: tunable = real("s/m", 0.0).at_least(0.0),
        /// Number of points of the table in use (default chosen).
        tab_n: fixed = integer(11).at_least(2.0).at_most(POINTS as f64),
        /// Velocities of the table, ascending; positive in extension (default chosen).
        tab_v: [tunable; POINTS] = velocities(),
        /// Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
        tab_f: [tunable; POINTS] = resistances(),
        /// Curve through the points of the table.
        interpolation: fixed = Interpolation::Linear.start(),
        /// Factor on the damper force.
        scale: tunable = real("1", 1.0).at_least(0.0),
        /// Stiffness in series with the damper, of oil and top mount; 0 = rigid.
        k_series: fixed = real("N/m", 0.0).at_least(0.0),
        /// Magnetorheological damper.
        mr: MagnetorheologicalFluid,
    }
}

/// States of a damper.
#[derive(Clone, Copy)]
pub(crate) struct DamperState<T: Copy> {
    pub piston_velocity: T,
    pub fluid: FluidState<T>,
}

/// Table of the default set (chosen).
const TABLE: [(f64, f64); 11] = [
    (-1.0, -1150.0),
    (-0.5, -700.0),
    (-0.25, -430.0),
    (-0.1, -210.0),
    (-0.05, -110.0),
    (0.0, 0.0),
    (0.05, 180.0),
    (0.1, 340.0),
    (0.25, 640.0),
    (0.5, 950.0),
    (1.0, 1500.0),
];

const fn velocities() -> [Column; POINTS] {
    let mut columns = [real("m/s", 0.0); POINTS];
    let mut at = 0;
    while at < TABLE.len() {
        columns[at] = real("m/s", TABLE[at].0);
        at += 1;
    }
    columns
}

const fn resistances() -> [Column; POINTS] {
    let mut columns = [real("N", 0.0); POINTS];
    let mut at = 0;
    while at < TABLE.len() {
        columns[at] = real("N", TABLE[at].1);
        at += 1;
    }
    columns
}

impl<T: Scalar> Hydraulics<T> {
    /// Whether the damper is a magnetorheological one.
    pub(crate) fn is_magnetorheological(&self) -> T::Mask {
        !self.enabled.vanishes() & DamperMode::MagnetorheologicalDamper.is(self.mode)
    }

    /// Whether the damper has a stiffness in series.
    pub fn has_series(&self) -> T::Mask {
        !self.enabled.vanishes() & self.k_series.is_positive() & !self.is_magnetorheological()
    }

    /// Velocity of the piston.
    pub(crate) fn piston(&self, velocity: T, state: &DamperState<T>) -> T {
        self.has_series().choose(|| state.piston_velocity, || velocity)
    }

    /// Resistance to a velocity of the piston.
    pub(crate) fn resistance(&self, piston: T, state: &DamperState<T>) -> T {
        let of_fluid = || self.scale * state.fluid.resistance(&self.mr, piston);
        self.is_magnetorheological().choose(of_fluid, || self.characteristic(piston))
    }

    /// Time derivatives of the state of the fluid.
    pub(crate) fn fluid_rates(&self, fluid: &FluidState<T>, velocity: T, voltage: T) -> FluidState<T> {
        let rates = || {
            let FluidState { slip, hysteresis } = fluid.rates(&self.mr, velocity, voltage);
            [slip, hysteresis.z, hysteresis.filtered_voltage]
        };
        let [slip, z, filtered_voltage] = self.is_magnetorheological().choose_all(rates, || [T::zero(); 3]);
        FluidState { slip, hysteresis: MagnetorheologicalState { z, filtered_voltage } }
    }

    /// Resistance F_d of a damper without memory; it has the sign of the velocity.
    fn characteristic(&self, velocity: T) -> T {
        let table = || self.interpolated(velocity);
        let resistance = || self.scale * DamperMode::Table.is(self.mode).choose(table, || self.formula(velocity));
        self.enabled.vanishes().choose(|| T::zero(), resistance)
    }

    /// Coefficient in this direction of motion.
    fn coefficient(&self, velocity: T) -> T {
        velocity.is_positive().choose(|| self.c_reb, || self.c_comp)
    }

    /// 1 for a linear damper, and what the coefficient is divided by for a degressive one.
    fn fading(&self, velocity: T) -> T {
        let degression = velocity.is_positive().choose(|| self.degr_reb, || self.degr_comp);
        T::from(1.0) + degression * velocity.abs()
    }

    /// Resistance by a formula, linear or degressive.
    fn formula(&self, velocity: T) -> T {
        let linear = self.coefficient(velocity) * velocity;
        DamperMode::Degressive.is(self.mode).choose(|| linear / self.fading(velocity), || linear)
    }

    /// Slope of the resistance over the velocity of the piston.
    fn slope(&self, velocity: T) -> T {
        let table = || {
            let points = points(&self.tab_v, &self.tab_f);
            let curve = Curve::new(&points, self.tab_n);
            let cubic = || curve.monotone_cubic_slope(velocity);
            Interpolation::Cubic.is(self.interpolation).choose(cubic, || curve.linear_slope(velocity))
        };
        let formula = || {
            let linear = self.coefficient(velocity);
            let degressive = || {
                let fading = self.fading(velocity);
                linear / (fading * fading)
            };
            DamperMode::Degressive.is(self.mode).choose(degressive, || linear)
        };
        self.scale * DamperMode::Table.is(self.mode).choose(table, formula)
    }

    /// Time derivative of the velocity of the piston behind the series stiffness. `factor` multiplies the resistance.
    pub(crate) fn rate(&self, piston_velocity: T, velocity: T, factor: T) -> T {
        let rate = || {
            // Where the characteristic is flat, the piston follows at once. A solver needs a finite rate, so it gets a
            // high one.
            let least = self.k_series * T::from(FOLLOWING_TIME);
            let slope = factor * self.slope(piston_velocity);
            let slope = slope.above(least).choose(|| slope, || least);
            self.k_series * (velocity - piston_velocity) / slope
        };
        self.has_series().choose(rate, || T::zero())
    }

    fn interpolated(&self, velocity: T) -> T {
        let points = points(&self.tab_v, &self.tab_f);
        let curve = Curve::new(&points, self.tab_n);
        let cubic = || curve.monotone_cubic(velocity);
        Interpolation::Cubic.is(self.interpolation).choose(cubic, || curve.linear(velocity))
    }
}

/// Shortest time constant of the piston behind its stiffness, if an importer integrates it (chosen, in s). Where the
/// characteristic alone would give a shorter one, the force lags that of a rigid damper by this time at most.
const FOLLOWING_TIME: f64 = 1e-5;

/// Coefficient of an L-stable step of second order (Alexander 1977, doi:10.1137/0714068): gamma = 1 - 1 / sqrt(2).
const GAMMA: f64 = 1.0 - std::f64::consts::FRAC_1_SQRT_2;

impl Hydraulics {
    /// Advances by `dt`, with the strut at a held velocity. Returns the energy taken out of the motion. `factor`
    /// multiplies the resistance.
    pub(crate) fn advance(
        &self,
        state: &mut DamperState<f64>,
        velocity: f64,
        voltage: f64,
        factor: f64,
        dt: f64,
    ) -> f64 {
        if self.has_series() {
            return self.press(&mut state.piston_velocity, velocity, factor, dt);
        }
        state.piston_velocity = velocity;
        if self.is_magnetorheological() {
            return factor * self.scale * state.fluid.advance(&self.mr, [velocity, voltage], [0.0; 2], dt);
        }
        factor * self.characteristic(velocity) * velocity * dt
    }

    /// Advances the velocity w of the piston behind the series stiffness by `dt`, with the strut at a held velocity v:
    /// d F_d(w) / dt = k_s (v - w). Returns the energy that the piston dissipates.
    fn press(&self, piston_velocity: &mut f64, velocity: f64, factor: f64, dt: f64) -> f64 {
        let law = self.map(&|number| Dual::from(number));
        let resistance = |w: f64| {
            let force = law.characteristic(Dual { value: w, slope: 1.0 });
            Dual { value: factor * force.value, slope: factor * force.slope }
        };
        let stage_gain = GAMMA * dt * self.k_series;
        // Each stage solves F_d(w) + a w = b with a > 0; F_d does not decrease and is 0 at 0, so w lies between 0 and b
        // / a.
        let stage = |from: f64| {
            let right = from + stage_gain * velocity;
            let residual = |w: f64| {
                let force = resistance(w);
                Dual { value: force.value + stage_gain * w - right, slope: force.slope + stage_gain }
            };
            // With a soft spring and a short step, b / a may overflow.
            let far = (right / stage_gain).clamp(f64::MIN, f64::MAX);
            root::newton(residual, far.min(0.0), far.max(0.0))
        };
        let begin = resistance(*piston_velocity).value;
        let first = stage(begin);
        let second = stage(begin + (1.0 - GAMMA) * dt * self.k_series * (velocity - first));
        *piston_velocity = second;
        let power = |w: f64| resistance(w).value * w;
        dt * ((1.0 - GAMMA) * power(first) + GAMMA * power(second))
    }

    /// Refuses impossible tables and fluids.
    pub(crate) fn check(&self) -> Result<(), Fault> {
        match DamperMode::of(self.mode) {
            _ if self.enabled == 0.0 => Ok(()),
            DamperMode::Table => self.check_table(),
            DamperMode::MagnetorheologicalDamper => self.check_fluid(),
            DamperMode::Linear | DamperMode::Degressive => Ok(()),
        }
    }

    /// Coefficient with which it resists at least to every motion; 0 if its resistance is not proportional to the velocity.
    pub(crate) fn least_coefficient(&self) -> f64 {
        let is_proportional = DamperMode::of(self.mode) == DamperMode::Linear && !self.has_series();
        if self.enabled != 0.0 && is_proportional { self.scale * self.c_comp.min(self.c_reb) } else { 0.0 }
    }

    fn check_fluid(&self) -> Result<(), Fault> {
        if self.k_series > 0.0 {
            let why = "must be 0 with damper.mode = MagnetorheologicalDamper, which has its own dashpot in series";
            return Err(Fault::new(format_args!("damper.k_series = {}: {why}", self.k_series)));
        }
        self.mr.check("damper.mr.")
    }

    fn check_table(&self) -> Result<(), Fault> {
        check_rising("damper.tab_v", &self.tab_v, self.tab_n)?;
        for at in 0..self.tab_n as usize {
            let (i, force, velocity) = (at + 1, self.tab_f[at], self.tab_v[at]);
            let refused = |why: fmt::Arguments| Err(Fault::new(format_args!("damper.tab_f[{i}] = {force}: {why}")));
            if at > 0 && force < self.tab_f[at - 1] {
                return refused(format_args!("must be >= damper.tab_f[{at}] = {}", self.tab_f[at - 1]));
            }
            if force * velocity < 0.0 {
                return refused(format_args!("must have the sign of damper.tab_v[{i}] = {velocity}"));
            }
        }
        match self.interpolated(0.0) {
            0.0 => Ok(()),
            at_rest => Err(Fault::new(format_args!(
                "damper.tab_f: must give 0 at velocity 0, gives {at_rest} N; add the point (0, 0)"
            ))),
        }
    }
}

crate::model! {
    /// Hydraulic damper: linear, degressive or from a table, with an optional stiffness in series, or magnetorheological.
    ///
    /// # Equations
    ///
    /// ```text
    /// F_d(w) = s c w                         linear
    /// F_d(w) = s c w / (1 + d |w|)           degressive
    /// F_d(w) = s F_t(w)                      table
    /// d F_d(w) / dt = k_s (v - w)            with stiffness in series, else w = v
    /// F = -F_d(w)
    /// ```
    ///
    /// and magnetorheological, with the slip $p = x - y$ of the component `MagnetorheologicalDamper`:
    ///
    /// ```text
    /// F_d   = s (alpha z + k_0 p + c_0 dp/dt)
    /// dp/dt = (c_1 v - alpha z - k_0 p) / (c_0 + c_1)
    /// ```
    ///
    /// These are its equations for $F - k_1 (x - x_0)$: an accumulator is a spring beside the damper. Those for $z$ and
    /// the voltage, $alpha$, $c_0$ and $c_1$ are on its page.
    ///
    /// | symbol | variable                                   | unit  | meaning                                    |
    /// |--------|--------------------------------------------|-------|--------------------------------------------|
    /// | v      | `velocity`                                 | m/s   | velocity of extension                      |
    /// | w      | `piston_velocity`                          | m/s   | velocity of the piston in the oil          |
    /// | c      | `damper.c_comp`, `damper.c_reb`            | N.s/m | coefficient in compression, in extension   |
    /// | d      | `damper.degr_comp`, `damper.degr_reb`      | s/m   | degression in compression, in extension    |
    /// | F_t    | `damper.tab_v[1]`, `damper.tab_f[1]`, ...  | m/s, N | points, `damper.tab_n` of them            |
    /// | s      | `damper.scale`                             | 1     | factor on the force                        |
    /// | k_s    | `damper.k_series`                          | N/m   | stiffness in series, 0 = rigid             |
    /// | V      | `voltage`                                  | V     | voltage at the current driver              |
    /// | p      | `mr.slip`                                  | m     | displacement beside the dashpot in series  |
    /// | z      | `mr.z`                                     | m     | evolutionary variable of the hysteresis    |
    /// | u      | `mr.filtered_voltage`                      | V     | voltage that acts on the fluid             |
    /// | F      | `force`                                    | N     | force of the damper                        |
    ///
    /// # Sign
    /// `velocity` is positive in extension, `force` pushes the ends apart when positive: it opposes the velocity. Table
    /// values are resistances, with the sign of the velocity.
    ///
    /// # Step
    /// Without stiffness in series the force follows the velocity. With it, the step is L-stable and of second order,
    /// with internal steps of at most `step_size`. In Model Exchange the piston follows with a time constant of at
    /// least 10 us, also where the slope of the characteristic is 0. The magnetorheological damper is integrated with
    /// error control, as its component.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; a table whose velocities are not strictly ascending, or whose
    /// resistances decrease, have the wrong sign or are not 0 at rest; with `damper.mode` = MagnetorheologicalDamper a
    /// stiffness in series, and what that component refuses.
    ///
    /// # Limits
    /// No cavitation, no dependence on position. Beyond the ends of a table the end slopes are continued. The energy of
    /// the magnetorheological damper is the work of its force, part of which hysteresis and springs give back.
    ///
    /// # Source
    /// Degressive form as in the shock absorbers of Project Chrono; monotone cubic: Fritsch and Butland (1984),
    /// doi:10.1137/0905021; step: Alexander (1977), doi:10.1137/0714068; magnetorheological damper: Spencer, Dyke, Sain
    /// and Carlson (1997), see the page of the component. The defaults are chosen: damping ratios of 0.5
    /// and 0.75 at the front wheel of a Formula Student car.
    ///
    /// # Example
    /// ```
    /// use stribeck::model::Law;
    /// use stribeck::shock_absorber::HydraulicDamper;
    /// let mut damper = HydraulicDamper { velocity: 0.2, ..Default::default() };
    /// damper.damper.mode = 2.0; // table
    /// damper.output();
    /// assert!((damper.force + 540.0).abs() < 1e-12); // between 340 N at 0.1 m/s and 640 N at 0.25 m/s
    /// ```
    HydraulicDamper: "Hydraulic damper, linear, degressive, from a table or magnetorheological" {
        /// Velocity of extension.
        velocity: input = real("m/s", 0.0).means(Meaning::Velocity),
        /// Voltage at the current driver of the coil; used by damper.mode = MagnetorheologicalDamper.
        voltage: input = real("V", 0.0).at_least(0.0),
        /// Characteristic.
        damper: Hydraulics,
        /// Largest internal step (default chosen).
        step_size: fixed = real("s", 1e-4).positive().shown_in("ms"),
        /// Velocity of the piston behind the series stiffness; the velocity itself if there is none.
        piston_velocity: state = real("m/s", 0.0),
        /// Energy taken out of the motion since the start.
        dissipated_energy: state_output = real("J", 0.0).means(Meaning::Energy),
        /// Magnetorheological damper.
        mr: FluidState,
        /// Force of the damper; positive pushes its ends apart.
        force: output = real("N", 0.0),
        /// Power taken out of the motion.
        dissipated_power: output = real("W", 0.0),
    }
}

impl<T: Scalar> HydraulicDamper<T> {
    fn state(&self) -> DamperState<T> {
        DamperState { piston_velocity: self.piston_velocity, fluid: self.mr }
    }

    /// Resistance, and the power that it takes out of the motion.
    fn resists(&self) -> [T; 2] {
        let state = self.state();
        let piston = self.damper.piston(self.velocity, &state);
        let resistance = self.damper.resistance(piston, &state);
        [resistance, resistance * piston]
    }
}

impl<T: Scalar> Law for HydraulicDamper<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        let [resistance, power] = self.resists();
        self.force = -resistance;
        self.dissipated_power = power;
    }
}

impl<T: Scalar> Derivatives for HydraulicDamper<T> {
    fn derivatives(&self, rate: &mut Self) {
        [_, rate.dissipated_energy] = self.resists();
        rate.mr = self.damper.fluid_rates(&self.mr, self.velocity, self.voltage);
        rate.piston_velocity = self.damper.rate(self.piston_velocity, self.velocity, T::from(1.0));
    }
}

impl HydraulicDamper {
    /// Advances at held inputs.
    fn advance(&mut self, dt: f64) {
        let mut state = self.state();
        self.dissipated_energy += self.damper.advance(&mut state, self.velocity, self.voltage, 1.0, dt);
        (self.piston_velocity, self.mr) = (state.piston_velocity, state.fluid);
    }
}

impl Model for HydraulicDamper {
    fn rests(&self, column: usize) -> bool {
        let first = offset_of!(Self, mr) / size_of::<f64>();
        (first..first + FluidState::<f64>::WIDTH).contains(&column) && !self.damper.is_magnetorheological()
    }

    fn check(&self) -> Result<(), Fault> {
        self.damper.check()
    }

    fn step(&mut self, dt: f64) {
        // Without stiffness in series there is nothing to integrate, and one step is exact.
        let count = if self.damper.has_series() { super::substeps(dt, self.step_size) } else { 1 };
        for _ in 0..count {
            self.advance(dt / f64::from(count));
        }
    }

    /// Behind a stiffness, in pieces of at most `step_size`, each with the velocity in its middle. Without a stiffness
    /// the piston has the velocity of the strut, and only the energy is an integral.
    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        let begin = ramp::Inputs::of(self);
        if self.damper.is_magnetorheological() {
            let (now, rates) = ([self.velocity, self.voltage], [slope.velocity, slope.voltage]);
            self.dissipated_energy += self.damper.scale * self.mr.advance(&self.damper.mr, now, rates, dt);
            ramp::set_inputs(self, &begin, slope, dt);
            self.piston_velocity = self.velocity;
            return;
        }
        if !self.damper.has_series() {
            let power = |law: &HydraulicDamper| law.damper.characteristic(law.velocity) * law.velocity;
            self.dissipated_energy += ramp::integral(self, slope, dt, power);
            ramp::set_inputs(self, &begin, slope, dt);
            self.piston_velocity = self.velocity;
            return;
        }
        let count = super::substeps(dt, self.step_size);
        let h = dt / f64::from(count);
        for piece in 0..count {
            ramp::set_inputs(self, &begin, slope, (f64::from(piece) + 0.5) * h);
            self.advance(h);
        }
        ramp::set_inputs(self, &begin, slope, dt);
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn damper(set: impl Fn(&mut Hydraulics)) -> HydraulicDamper {
        let mut damper = HydraulicDamper::default();
        set(&mut damper.damper);
        damper
    }

    fn force(damper: &mut HydraulicDamper, velocity: f64) -> f64 {
        damper.velocity = velocity;
        damper.output();
        damper.force
    }

    #[test]
    fn each_direction_has_its_coefficient() {
        let mut linear = damper(|_| ());
        assert_eq!([force(&mut linear, 0.2), force(&mut linear, -0.2)], [-460.0, 300.0]);
        let mut degressive = damper(|d| {
            d.mode = DamperMode::Degressive.number();
            (d.degr_comp, d.degr_reb) = (5.0, 2.5);
        });
        assert_eq!(force(&mut degressive, 0.2), -460.0 / 1.5);
        assert_eq!(force(&mut degressive, -0.2), 300.0 / 2.0);
    }

    /// A linear damper in series with a spring relaxes exponentially to c v, with the time constant c / k.
    #[test]
    fn series_stiffness_relaxes_exponentially() {
        let mut relaxing = damper(|d| d.k_series = 4.6e5);
        relaxing.velocity = 0.1;
        for k in 1..=20 {
            relaxing.step(1e-3);
            relaxing.output();
            let exact = -230.0 * (1.0 - (-1e-3 * f64::from(k) / 5e-3).exp());
            assert!((relaxing.force - exact).abs() < 1e-2, "{k}: {} {exact}", relaxing.force);
        }
        // Work of the motion = energy in the spring F^2 / 2 k + energy dissipated.
        let work: f64 = 0.1 * 230.0 * (0.02 - 5e-3 * (1.0 - (-4f64).exp()));
        let stored = relaxing.force.powi(2) / (2.0 * 4.6e5);
        assert_abs_diff_eq!(relaxing.dissipated_energy + stored, work, epsilon = 1e-5);
    }

    /// Along a ramp v = a t the piston follows with w = a (t - T (1 - exp(-t / T))), T = c / k; the force is -c w. Each
    /// piece of the step has the velocity in its middle, a method of second order.
    #[test]
    fn series_stiffness_follows_a_ramp() {
        let (a, time, lag) = (5.0, 20e-3, 5e-3);
        let exact = -2300.0 * a * (time - lag * (1.0 - f64::exp(-time / lag)));
        let error = |step_size: f64| {
            let mut relaxing = HydraulicDamper { step_size, ..damper(|d| d.k_series = 4.6e5) };
            relaxing.step_ramp(&HydraulicDamper { velocity: a, ..relaxing }, time);
            relaxing.output();
            assert_abs_diff_eq!(relaxing.velocity, a * time, epsilon = 1e-15);
            (relaxing.force - exact).abs()
        };
        let [coarse, fine] = [1e-3, 5e-4].map(error);
        assert!(coarse < 2.0 && coarse / fine > 3.0, "{coarse} {fine}");
    }

    /// The step is of second order or better, and stable for a stiffness of 1e12 N/m.
    #[test]
    fn series_step_is_of_second_order_and_l_stable() {
        let run = |step_size: f64| {
            let mut relaxing = damper(|d| (d.k_series, d.mode) = (4.6e5, 2.0));
            (relaxing.velocity, relaxing.step_size) = (-0.2, step_size);
            relaxing.step(2e-3);
            relaxing.output();
            relaxing.force
        };
        let exact = run(1e-6);
        let [coarse, fine] = [run(4e-5), run(2e-5)].map(|force| (force - exact).abs());
        assert!(coarse < 1e-3 && coarse / fine > 3.0, "{coarse} {fine}");
        let mut stiff = damper(|d| d.k_series = 1e12);
        stiff.velocity = -0.2;
        stiff.step(1e-3);
        stiff.output();
        assert_abs_diff_eq!(stiff.force, 300.0, epsilon = 1e-3);
    }

    #[test]
    fn impossible_tables_are_refused() {
        let refused = |set: fn(&mut Hydraulics)| {
            let mut damper = damper(set);
            damper.damper.mode = 2.0;
            damper.check().unwrap_err().0
        };
        assert_eq!(refused(|d| d.tab_v[2] = -0.6), "damper.tab_v[3] = -0.6: must be > damper.tab_v[2] = -0.5");
        assert_eq!(refused(|d| d.tab_f[8] = 300.0), "damper.tab_f[9] = 300: must be >= damper.tab_f[8] = 340");
        assert_eq!(refused(|d| d.tab_f[4] = 1.0), "damper.tab_f[5] = 1: must have the sign of damper.tab_v[5] = -0.05");
        let text = refused(|d| {
            d.tab_n = 2.0;
            (d.tab_v[0], d.tab_v[1], d.tab_f[0], d.tab_f[1]) = (-1.0, 1.0, 0.0, 1000.0);
        });
        assert_eq!(text, "damper.tab_f: must give 0 at velocity 0, gives 500 N; add the point (0, 0)");
    }
}
