use crate::contact::quantities::{DISSIPATED_ENERGY, DISSIPATED_POWER, FRICTION_FORCE, VELOCITY};
use crate::model::integrate::{self, Moving};
use crate::model::{Derivatives, Fault, Law, Meaning, Model, ModelExchange, Preset, real};
use crate::number::Real;

crate::part! {
    /// Fluid and dashpots of a magnetorheological damper.
    MagnetorheologicalFluid {
        /// Damping at high speeds without voltage.
        c_0a: tunable = real("N.s/m", 2100.0).at_least(0.0).nominal(1e3),
        /// Increase of the damping at high speeds with the voltage.
        c_0b: tunable = real("N.s/(m.V)", 350.0).at_least(0.0).nominal(1e3),
        /// Stiffness at high speeds.
        k_0: tunable = real("N/m", 4690.0).at_least(0.0).nominal(1e3),
        /// Coefficient of the dashpot in series without voltage.
        c_1a: tunable = real("N.s/m", 28_300.0).positive().nominal(1e4),
        /// Increase of the coefficient of the dashpot in series with the voltage.
        c_1b: tunable = real("N.s/(m.V)", 295.0).at_least(0.0).nominal(1e3),
        /// Stiffness of the hysteresis without voltage.
        alpha_a: tunable = real("N/m", 14_000.0).at_least(0.0).nominal(1e4),
        /// Increase of the stiffness of the hysteresis with the voltage.
        alpha_b: tunable = real("N/(m.V)", 69_500.0).at_least(0.0).nominal(1e4),
        /// Form of the hysteresis: its part that acts in both directions of motion, in m^-n.
        hysteresis_gamma: tunable = real("1/m2", 3.63e6).at_least(0.0).nominal(1e6).means(Meaning::Shape),
        /// Form of the hysteresis: its part that changes sign with the motion, in m^-n; above -hysteresis_gamma.
        hysteresis_beta: tunable = real("1/m2", 3.63e6).nominal(1e6).means(Meaning::Shape),
        /// Slope of the evolutionary variable over the displacement where it is 0.
        A: tunable = real("1", 301.0).positive().nominal(100.0).means(Meaning::Shape),
        /// Exponent of the hysteresis: its transition to the saturated level is sharper if larger.
        n: tunable = real("1", 2.0).at_least(1.0).means(Meaning::Shape),
        /// Rate at which the voltage on the fluid follows that at the driver.
        voltage_rate: tunable = real("1/s", 190.0).positive().nominal(100.0),
    }
}

crate::part! {
    /// State of the fluid of a magnetorheological damper.
    MagnetorheologicalState {
        /// Evolutionary variable of the hysteresis.
        z: state = real("m", 0.0).nominal(1e-3).shown_in("mm"),
        /// Voltage that acts on the fluid.
        filtered_voltage: state = real("V", 0.0),
    }
}

crate::model! {
    /// Magnetorheological damper after Spencer: a Bouc-Wen hysteresis whose level follows the voltage on the coil, with
    /// a dashpot in series, for the force that falls off at low speeds, and the spring of an accumulator.
    ///
    /// # Equations
    ///
    /// ```text
    /// c_1 dy/dt = alpha z + k_0 (x - y) + c_0 (dx/dt - dy/dt)
    /// dz/dt     = -gamma |dx/dt - dy/dt| z |z|^(n - 1) - beta (dx/dt - dy/dt) |z|^n + A (dx/dt - dy/dt)
    /// F         = c_1 dy/dt + k_1 (x - x_0)
    /// alpha     = alpha_a + alpha_b u
    /// c_0       = c_0a + c_0b u
    /// c_1       = c_1a + c_1b u
    /// du/dt     = -eta (u - V)
    /// dx/dt     = v
    /// ```
    ///
    /// | symbol  | variable           | unit      | meaning                                                    |
    /// |---------|--------------------|-----------|------------------------------------------------------------|
    /// | v       | `velocity`         | m/s       | velocity of body 1 relative to body 2                      |
    /// | V       | `voltage`          | V         | voltage at the current driver                              |
    /// | c_0a    | `c_0a`             | N.s/m     | damping at high speeds without voltage                     |
    /// | c_0b    | `c_0b`             | N.s/(m.V) | its increase with the voltage                              |
    /// | k_0     | `k_0`              | N/m       | stiffness at high speeds                                   |
    /// | c_1a    | `c_1a`             | N.s/m     | dashpot in series without voltage                          |
    /// | c_1b    | `c_1b`             | N.s/(m.V) | its increase with the voltage                              |
    /// | k_1     | `k_1`              | N/m       | stiffness of the accumulator                               |
    /// | x_0     | `x_0`              | m         | displacement at which the accumulator carries nothing      |
    /// | alpha_a | `alpha_a`          | N/m       | stiffness of the hysteresis without voltage                |
    /// | alpha_b | `alpha_b`          | N/(m.V)   | its increase with the voltage                              |
    /// | gamma   | `hysteresis_gamma` | 1/m2      | form of the hysteresis, for n = 2; else in m^-n            |
    /// | beta    | `hysteresis_beta`  | 1/m2      | form of the hysteresis, for n = 2; else in m^-n            |
    /// | A       | `A`                | 1         | slope of the hysteresis at z = 0                           |
    /// | n       | `n`                | 1         | exponent of the hysteresis                                 |
    /// | eta     | `voltage_rate`     | 1/s       | rate at which u follows the voltage                        |
    /// | x       | `displacement`     | m         | displacement of body 1 relative to body 2                  |
    /// | y       | `y`                | m         | displacement of the dashpot in series                      |
    /// | z       | `z`                | m         | evolutionary variable of the hysteresis                    |
    /// | u       | `filtered_voltage` | V         | voltage that acts on the fluid                             |
    /// | F       | `friction_force`   | N         | force of the damper                                        |
    ///
    /// The hysteresis saturates in a long motion in one direction. On the way there, $z$ is a function of the slip
    /// $p = x - y$ alone, for $n = 2$ from $z = 0$
    ///
    /// ```text
    /// z_max = (A / (gamma + beta))^(1/n)
    /// z     = z_max tanh(sqrt(A (gamma + beta)) p)
    /// ```
    ///
    /// At a held speed the slip then ends, with the time constant $(c_0 + c_1) / k_0$, which is 6.5 s for the start
    /// values, and the force is $c_1 v + k_1 (x - x_0)$.
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` in steady motion, but for the force of the accumulator; body 1 feels
    /// `-friction_force`. Dissipated power is `friction_force * velocity`; it is negative while hysteresis and springs
    /// give back.
    ///
    /// # Step
    /// Displacement, $y$, $z$, $u$ and the energy are integrated together by the method of Dormand and Prince with
    /// error control, to 1e-10 of each, for held inputs and for inputs that move linearly; so the result does not
    /// depend on how an interval is divided. The hysteresis follows its level at the rate
    /// $n A |dx/dt - dy/dt| / z_max$, which is 93,500 1/s at 1 m/s for the start values: the pieces of a step are as
    /// short as that, until it has reached its level to 1e-10, where it is held. The damper does not know the
    /// displacement of the host: it integrates the velocity, from the start value of `displacement`. With held
    /// velocities it follows a host that does the same.
    ///
    /// A master that integrates a mass m with the force it reads couples it explicitly to the stiffness $alpha A$ and
    /// the damping $c_0 c_1 / (c_0 + c_1)$.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; $gamma + beta <= 0$, with which the hysteresis has no bound; a step of
    /// more than 400,000 pieces, such as one over years.
    ///
    /// # Limits
    /// At constant voltage the damper is passive: it gives back no more than its springs and the hysteresis have
    /// stored, the latter `alpha` times the integral of $z / (A + (gamma - beta) |z|^n)$ over $z$, because at the same
    /// $z$ the hysteresis rises no faster than it falls ($gamma >= 0$). A voltage that rises while the hysteresis is
    /// loaded raises the force with it and adds energy.
    ///
    /// The start values belong to one prototype and to voltages up to 2.25 V; the linear growth with the voltage has no
    /// saturation beyond. No temperature, no inertia of the fluid. With $k_0 = 0$ and `c_1a` very large the damper is
    /// the simple Bouc-Wen model. At rest the force does not vanish: it is what springs and hysteresis keep.
    ///
    /// # Source
    /// B. F. Spencer, S. J. Dyke, M. K. Sain, J. D. Carlson (1997), "Phenomenological model for magnetorheological
    /// dampers", Journal of Engineering Mechanics 123 (3), 230-238, doi:10.1061/(ASCE)0733-9399(1997)123:3(230), and
    /// its printed parameters, here in metres. The displacement as a state, the unit of $gamma$ and $beta$ and the
    /// bounds are our choice.
    ///
    /// # Example
    /// ```
    /// use stribeck::component::MagnetorheologicalDamper;
    /// use stribeck::model::{Law, Model};
    /// let mut damper = MagnetorheologicalDamper { velocity: 0.1, voltage: 1.5, ..Default::default() };
    /// damper.step(0.1);
    /// let z_max = (301.0f64 / 7.26e6).sqrt();
    /// assert!((damper.state.z - z_max).abs() < 1e-9); // saturated
    /// assert!((damper.state.filtered_voltage - 1.5 * (1.0 - (-19.0f64).exp())).abs() < 1e-9);
    /// damper.output();
    /// assert!(damper.friction_force > 0.0);
    /// ```
    MagnetorheologicalDamper: "Magnetorheological damper with hysteresis (Spencer)" {
        velocity: input = VELOCITY,
        /// Voltage at the current driver of the coil.
        voltage: input = real("V", 0.0).at_least(0.0),
        /// Fluid and dashpots.
        fluid: (MagnetorheologicalFluid),
        /// Stiffness of the accumulator.
        k_1: tunable = real("N/m", 500.0).at_least(0.0).nominal(1e3),
        /// Displacement at which the accumulator carries nothing.
        x_0: tunable = real("m", 0.143).nominal(0.1),
        /// Displacement of body 1 relative to body 2.
        displacement: state_output = real("m", 0.0).nominal(1e-2).shown_in("mm").odd().means(Meaning::Displacement),
        /// Displacement of the dashpot in series.
        y: state = real("m", 0.0).nominal(1e-2).shown_in("mm").means(Meaning::Displacement),
        /// Hysteresis and voltage.
        state: (MagnetorheologicalState),
        dissipated_energy: state_output = DISSIPATED_ENERGY.nominal(1.0),
        friction_force: output = FRICTION_FORCE
            .help("Force of the damper; has the sign of the velocity when sliding. Body 1 feels its negative."),
        dissipated_power: output = DISSIPATED_POWER,
    }
}

/// Motion within the damper.
struct Within<T> {
    /// dx/dt - dy/dt.
    slip: T,
    /// c_1 dy/dt, the force without that of the accumulator.
    force: T,
    /// c_1.
    dashpot: T,
}

impl<T: Real> MagnetorheologicalDamper<T> {
    /// At rest, without an accumulator; its displacement is counted from that of the dashpot in series.
    pub(crate) fn without_accumulator(
        fluid: MagnetorheologicalFluid<T>,
        state: MagnetorheologicalState<T>,
        slip: T,
    ) -> Self {
        let none = T::zero();
        MagnetorheologicalDamper {
            velocity: none,
            voltage: none,
            fluid,
            k_1: none,
            x_0: none,
            displacement: slip,
            y: none,
            state,
            dissipated_energy: none,
            friction_force: none,
            dissipated_power: none,
        }
    }

    /// The motion that holds the hysteresis and the dashpot in series in balance.
    fn within(&self) -> Within<T> {
        let fluid = &self.fluid;
        let at = |without: T, increase: T| without + increase * self.state.filtered_voltage;
        let (alpha, c_0, c_1) =
            (at(fluid.alpha_a, fluid.alpha_b), at(fluid.c_0a, fluid.c_0b), at(fluid.c_1a, fluid.c_1b));
        let elastic = alpha * self.state.z + fluid.k_0 * (self.displacement - self.y);
        let slip = (c_1 * self.velocity - elastic) / (c_0 + c_1);
        Within { slip, force: elastic + c_0 * slip, dashpot: c_1 }
    }

    fn force(&self, within: &Within<T>) -> T {
        within.force + self.k_1 * (self.displacement - self.x_0)
    }

    /// dz/dt at dx/dt - dy/dt, with |z|^n.
    fn evolution(&self, slip: T, power: T) -> T {
        let (fluid, z) = (&self.fluid, self.state.z);
        let saturation = (fluid.hysteresis_gamma * (slip * z).sign() + fluid.hysteresis_beta) * power;
        (fluid.A - saturation) * slip
    }

    /// Rates of x, y, z, u and the energy, with |z|^n.
    fn rates(&self, within: &Within<T>, power: T) -> [T; 5] {
        [
            self.velocity,
            within.force / within.dashpot,
            self.evolution(within.slip, power),
            self.fluid.voltage_rate * (self.voltage - self.state.filtered_voltage),
            self.force(within) * self.velocity,
        ]
    }

    /// States x, y, z, u and the energy.
    fn states(&mut self) -> [&mut T; 5] {
        let MagnetorheologicalState { z, filtered_voltage } = &mut self.state;
        [&mut self.displacement, &mut self.y, z, filtered_voltage, &mut self.dissipated_energy]
    }
}

/// A damper within a step, with inputs that begin at these values and move at these rates; its error may be that of a force
/// that is compared with a measured one.
struct Driven<'a, const IS_COARSE: bool> {
    damper: &'a mut MagnetorheologicalDamper,
    begin: [f64; 2],
    slope: [f64; 2],
}

impl<const IS_COARSE: bool> Driven<'_, IS_COARSE> {
    fn put(&mut self, time: f64, at: [f64; 5]) {
        let inputs = [0, 1].map(|i| self.begin[i] + self.slope[i] * time);
        [self.damper.velocity, self.damper.voltage] = inputs;
        for (state, value) in self.damper.states().into_iter().zip(at) {
            *state = value;
        }
    }
}

impl<const IS_COARSE: bool> Moving<5> for Driven<'_, IS_COARSE> {
    const IS_COARSE: bool = IS_COARSE;

    fn rates(&mut self, time: f64, at: [f64; 5]) -> [f64; 5] {
        self.put(time, at);
        let (damper, within) = (&self.damper, self.damper.within());
        let (z, n) = (damper.state.z.abs(), damper.fluid.n);
        // The exponent of most published dampers, without its costly power.
        let mut rates = damper.rates(&within, if n == 2.0 { z * z } else { Real::powf(z, n) });
        // A saturated hysteresis does not move, to the tolerance: it is drawn there faster than anything else moves, and
        // the pieces of a step would be as short as that.
        if rates[2].abs() <= Self::TOLERANCE * (n * damper.fluid.A * within.slip).abs() {
            rates[2] = 0.0;
        }
        rates
    }
}

impl MagnetorheologicalDamper {
    /// Advances by `dt` while velocity and voltage move at these rates.
    fn advance<const IS_COARSE: bool>(&mut self, slope: [f64; 2], dt: f64) {
        let at = self.states().map(|state| *state);
        let mut driven = Driven::<IS_COARSE> { begin: [self.velocity, self.voltage], damper: self, slope };
        let end = integrate::moved(&mut driven, at, integrate::nominal::<Self, 5>(), dt);
        driven.put(dt, end.unwrap_or([f64::NAN; 5]));
    }
}

impl MagnetorheologicalFluid {
    /// Refuses a hysteresis without a bound. `part` is what the names of the parameters begin with.
    pub(crate) fn check(&self, part: &str) -> Result<(), Fault> {
        if self.hysteresis_gamma + self.hysteresis_beta <= 0.0 {
            let limit = -self.hysteresis_gamma;
            let why = "or the hysteresis has no bound";
            return Err(Fault::new(format_args!(
                "{part}hysteresis_beta = {}: must be > -{part}hysteresis_gamma = {limit}, {why}",
                self.hysteresis_beta
            )));
        }
        Ok(())
    }
}

impl<T: Real> Law for MagnetorheologicalDamper<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.friction_force = self.force(&self.within());
        self.dissipated_power = self.friction_force * self.velocity;
    }
}

impl<T: Real> Derivatives for MagnetorheologicalDamper<T> {
    fn derivatives(&self, rate: &mut Self) {
        let rates = self.rates(&self.within(), self.state.z.abs().powf(self.fluid.n));
        for (state, value) in rate.states().into_iter().zip(rates) {
            *state = value;
        }
    }
}

impl Model for MagnetorheologicalDamper {
    const COARSE_RAMP: Option<fn(&mut Self, &Self, f64)> =
        Some(|damper, slope, dt| damper.advance::<true>([slope.velocity, slope.voltage], dt));

    const PRESETS: &'static [Preset] = &[Preset {
        name: "spencer_1997",
        source: "Spencer, Dyke, Sain, Carlson (1997), the printed parameters: N/cm as 100 N/m, cm^-2 as 10,000 m^-2",
        values: &[
            ("c_0a", 2100.0),
            ("c_0b", 350.0),
            ("k_0", 4690.0),
            ("c_1a", 28_300.0),
            ("c_1b", 295.0),
            ("k_1", 500.0),
            ("x_0", 0.143),
            ("alpha_a", 14_000.0),
            ("alpha_b", 69_500.0),
            ("hysteresis_gamma", 3.63e6),
            ("hysteresis_beta", 3.63e6),
            ("A", 301.0),
            ("n", 2.0),
            ("voltage_rate", 190.0),
        ],
    }];

    fn check(&self) -> Result<(), Fault> {
        self.fluid.check("")
    }

    fn step(&mut self, dt: f64) {
        self.advance::<false>([0.0; 2], dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        self.advance::<false>([slope.velocity, slope.voltage], dt);
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    /// The printed model in the units of the paper, cm, s and V, for a velocity and a voltage over time: states x, y,
    /// z, u, work, by the classical Runge-Kutta method.
    fn printed(drive: impl Fn(f64) -> [f64; 2], until: f64, steps: u32) -> ([f64; 5], f64) {
        let force = |t: f64, [x, y, z, u, _]: [f64; 5]| {
            let [v, _] = drive(t);
            let (alpha, c_0, c_1) = (140.0 + 695.0 * u, 21.0 + 3.50 * u, 283.0 + 2.95 * u);
            let dy = (alpha * z + c_0 * v + 46.9 * (x - y)) / (c_0 + c_1);
            (dy, c_1 * dy + 5.00 * (x - 14.3))
        };
        let rates = |t: f64, at: [f64; 5]| {
            let ([v, voltage], [_, _, z, u, _]) = (drive(t), at);
            let (dy, force) = force(t, at);
            let dz = -363.0 * (v - dy).abs() * z * z.abs() - 363.0 * (v - dy) * z.abs() * z.abs() + 301.0 * (v - dy);
            [v, dy, dz, -190.0 * (u - voltage), force * v]
        };
        let h = until / f64::from(steps);
        let mut at = [0.0; 5];
        for step in 0..steps {
            let t = f64::from(step) * h;
            let along = |k: [f64; 5], part: f64| std::array::from_fn(|i| at[i] + part * h * k[i]);
            let k_1 = rates(t, at);
            let k_2 = rates(t + 0.5 * h, along(k_1, 0.5));
            let k_3 = rates(t + 0.5 * h, along(k_2, 0.5));
            let k_4 = rates(t + h, along(k_3, 1.0));
            at = std::array::from_fn(|i| at[i] + h / 6.0 * (k_1[i] + 2.0 * k_2[i] + 2.0 * k_3[i] + k_4[i]));
        }
        (at, force(until, at).1)
    }

    /// Ramps of the velocity between the corners of a zigzag, with a voltage that rises by ramps as well.
    #[test]
    fn it_is_the_printed_model_in_centimetres() {
        // Between 20 and -20 cm/s, turned every 0.05 s; up to 2.25 V.
        let zigzag = |t: f64| {
            let turns = t / 0.05;
            let (whole, part) = (turns.floor(), turns.fract());
            let direction = if whole % 2.0 == 0.0 { 1.0 } else { -1.0 };
            direction * 20.0 * (1.0 - 2.0 * part)
        };
        let drive = |t: f64| [zigzag(t), 2.25 * t / 0.2];
        let (expected, force) = printed(drive, 0.2, 400_000);
        let mut damper = MagnetorheologicalDamper { velocity: 0.2, ..Default::default() };
        for slope in [-8.0, 8.0, -8.0, 8.0] {
            let rates = MagnetorheologicalDamper { velocity: slope, voltage: 11.25, ..held(&damper) };
            damper.step_ramp(&rates, 0.05);
        }
        damper.output();
        let found = [
            100.0 * damper.displacement,
            100.0 * damper.y,
            100.0 * damper.state.z,
            damper.state.filtered_voltage,
            100.0 * damper.dissipated_energy,
        ];
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-6 * expected.abs().max(1.0), "{found} {expected}");
        }
        assert!((damper.friction_force - force).abs() < 1e-5 * force.abs(), "{} {force}", damper.friction_force);
    }

    fn held(damper: &MagnetorheologicalDamper) -> MagnetorheologicalDamper {
        crate::model::ramp::held_inputs(damper)
    }

    /// z depends on the slip x - y alone, through any speeds of one direction: for n = 2 a tanh, for n = 1 an
    /// exponential.
    #[test]
    fn hysteresis_follows_its_closed_form_up_to_saturation() {
        for (gamma, beta) in [(3.63e6, 3.63e6), (5e6, -2e6), (1e6, 4e6)] {
            let mut damper = MagnetorheologicalDamper::default();
            (damper.fluid.hysteresis_gamma, damper.fluid.hysteresis_beta) = (gamma, beta);
            let z_max = (301.0 / (gamma + beta)).sqrt();
            for velocity in [1e-4, 2e-3, 0.05, 0.1, 0.3] {
                damper.velocity = velocity;
                damper.step(0.01);
                let slip = damper.displacement - damper.y;
                let expected = z_max * ((301.0 * (gamma + beta)).sqrt() * slip).tanh();
                assert!((damper.state.z - expected).abs() < 1e-9 * z_max, "{velocity}: {} {expected}", damper.state.z);
            }
            assert!((damper.state.z / z_max - 1.0).abs() < 1e-9);
        }
        let sum = 1000.0;
        let mut damper = MagnetorheologicalDamper::default();
        let fluid = &mut damper.fluid;
        (fluid.n, fluid.hysteresis_gamma, fluid.hysteresis_beta) = (1.0, 600.0, 400.0);
        for velocity in [-1e-3, -0.02] {
            damper.velocity = velocity;
            damper.step(0.02);
            let expected = -301.0 / sum * (1.0 - (sum * (damper.displacement - damper.y)).exp());
            assert!((damper.state.z - expected).abs() < 1e-9 * expected.abs(), "{} {expected}", damper.state.z);
        }
    }

    /// From the saturated state the rest is linear: at a held speed the slip ends exponentially.
    #[test]
    fn slip_ends_and_leaves_the_dashpot_in_series() {
        let mut start = MagnetorheologicalDamper { velocity: 0.1, voltage: 2.0, ..Default::default() };
        start.state.filtered_voltage = 2.0;
        let z_max = (301.0f64 / 7.26e6).sqrt();
        let (alpha, c_0, c_1) = (153_000.0, 2800.0, 28_890.0);
        for time in [0.1, 1.0, 7.0, 60.0] {
            let mut damper = start;
            damper.state.z = z_max;
            damper.step(time);
            damper.output();
            let rate = 4690.0 / (c_0 + c_1);
            let slip = (c_1 * 0.1 - alpha * z_max) / (c_0 + c_1) * (-rate * time).exp();
            let accumulator = 500.0 * (0.1 * time - 0.143);
            let expected = c_1 * (0.1 - slip) + accumulator;
            assert!((damper.friction_force / expected - 1.0).abs() < 1e-8, "{time}: {}", damper.friction_force);
            let path = (c_1 * 0.1 - alpha * z_max) / 4690.0 * -f64::exp_m1(-rate * time);
            assert!((damper.y - 0.1 * time + path).abs() < 1e-8, "{time}");
            let work = 0.1 * (c_1 * (0.1 * time - path) + 500.0 * (0.05 * time - 0.143) * time);
            assert!((damper.dissipated_energy - work).abs() < 1e-7 * work.abs().max(1.0), "{time}");
        }
    }

    #[test]
    fn voltage_on_the_fluid_relaxes_exponentially() {
        let mut damper = MagnetorheologicalDamper { velocity: 0.03, voltage: 2.25, ..Default::default() };
        for (step, time) in [1e-4, 3e-3, 0.02].into_iter().enumerate() {
            let before = damper.state.filtered_voltage;
            damper.step(time);
            let expected = 2.25 + (before - 2.25) * (-190.0 * time).exp();
            assert!((damper.state.filtered_voltage - expected).abs() < 1e-9, "{step}");
        }
    }

    /// At constant voltage it gives back no more than springs and hysteresis have stored, which is known in closed form
    /// for gamma = beta.
    #[test]
    fn it_gives_back_no_more_than_it_stored() {
        let stored = |damper: &MagnetorheologicalDamper| {
            let alpha = damper.fluid.alpha_a + damper.fluid.alpha_b * damper.state.filtered_voltage;
            let (bent, pressed) = (damper.displacement - damper.y, damper.displacement - damper.x_0);
            let hysteresis = 0.5 * alpha / damper.fluid.A * damper.state.z * damper.state.z;
            hysteresis + 0.5 * (damper.fluid.k_0 * bent * bent + damper.k_1 * pressed * pressed)
        };
        for voltage in [0.0, 1.0, 2.25] {
            let mut damper = MagnetorheologicalDamper { voltage, ..Default::default() };
            damper.state.filtered_voltage = voltage;
            for step in 0..400 {
                let before = (damper.dissipated_energy, stored(&damper));
                damper.velocity = 0.2 * (0.7 * f64::from(step)).sin() * (0.013 * f64::from(step)).cos();
                damper.step(2e-3);
                let lost = damper.dissipated_energy - before.0 - (stored(&damper) - before.1);
                assert!(lost > -1e-9, "{voltage} V, step {step}: {lost} J");
            }
        }
    }

    /// A sine of 2.5 Hz and 1.5 cm, the motion of the paper: the force grows with the voltage, and the loop is that of
    /// the Runge-Kutta method in centimetres.
    #[test]
    fn sine_of_the_paper_agrees_step_by_step() {
        let w = TAU * 2.5;
        let drive = |t: f64| [1.5 * w * (w * t).cos(), 1.5];
        let (expected, force) = printed(drive, 0.3, 300_000);
        let mut damper = MagnetorheologicalDamper { voltage: 1.5, ..Default::default() };
        let count = 3000;
        let velocity = |step: u32| 0.015 * w * (w * 1e-4 * f64::from(step)).cos();
        for step in 0..count {
            damper.velocity = velocity(step);
            let slope = (velocity(step + 1) - velocity(step)) / 1e-4;
            damper.step_ramp(&MagnetorheologicalDamper { velocity: slope, ..held(&damper) }, 1e-4);
        }
        damper.output();
        // The ramps leave out h^2 / 12 of the velocity's curvature.
        assert!((100.0 * damper.state.z - expected[2]).abs() < 1e-5, "{} {}", damper.state.z, expected[2]);
        assert!((damper.friction_force / force - 1.0).abs() < 1e-5, "{} {force}", damper.friction_force);
        assert!((100.0 * damper.dissipated_energy / expected[4] - 1.0).abs() < 1e-5);
    }

    /// The coarse ramp beside the other one, in two sines under a voltage that swings: as printed, where the hysteresis
    /// saturates, and with dashpots so weak that its slip relaxes within microseconds and less.
    #[test]
    fn a_coarse_ramp_is_near_the_fine_one() {
        for (weaker, steps) in [(1.0, 300), (1e-2, 60), (1e-4, 12)] {
            let mut fine = MagnetorheologicalDamper::default();
            let fluid = &mut fine.fluid;
            for dashpot in [&mut fluid.c_0a, &mut fluid.c_0b, &mut fluid.c_1a, &mut fluid.c_1b] {
                *dashpot *= weaker;
            }
            let (mut coarse, mut most) = (fine, 0.0f64);
            let ramp = MagnetorheologicalDamper::COARSE_RAMP.unwrap();
            let inputs = |k: u32| {
                let t = 4e-3 * f64::from(k);
                [0.06 * (TAU * t).sin() + 0.03 * (TAU * 3.1 * t).sin(), 1.0 - (TAU * 1.4 * t).cos()]
            };
            for k in 0..steps {
                let [[v, voltage], next] = [inputs(k), inputs(k + 1)];
                let rates = [(next[0] - v) / 4e-3, (next[1] - voltage) / 4e-3];
                let slope = MagnetorheologicalDamper { velocity: rates[0], voltage: rates[1], ..held(&fine) };
                for damper in [&mut fine, &mut coarse] {
                    (damper.velocity, damper.voltage) = (v, voltage);
                }
                fine.step_ramp(&slope, 4e-3);
                ramp(&mut coarse, &slope, 4e-3);
                fine.output();
                coarse.output();
                most = most.max(fine.friction_force.abs());
                let apart = (coarse.friction_force - fine.friction_force).abs();
                assert!(apart < 1e-4 * most, "{weaker} {k}: {apart} {most}");
            }
        }
    }

    /// The decay to the level, 93,500 1/s, no longer counts once the level is reached.
    #[test]
    fn a_saturated_hysteresis_costs_few_pieces() {
        let mut damper = MagnetorheologicalDamper { velocity: 1.0, ..Default::default() };
        damper.step(3600.0);
        // The slip has ended: y follows x at the distance at which k_0 and the hysteresis carry the dashpot.
        let z_max = (301.0f64 / 7.26e6).sqrt();
        let distance = (28_300.0 - 14_000.0 * z_max) / 4690.0;
        assert!((damper.displacement - 3600.0).abs() < 1e-6);
        assert!((damper.displacement - damper.y - distance).abs() < 1e-6, "{}", damper.displacement - damper.y);
    }

    /// A step ends or is given up, and then gives NaN, which an instance refuses.
    #[test]
    fn endless_steps_are_given_up() {
        let after = |time: f64| {
            let mut damper = MagnetorheologicalDamper { velocity: 1.0, ..Default::default() };
            damper.step(time);
            damper.displacement
        };
        assert!((after(20.0) - 20.0).abs() < 1e-8);
        assert!(after(1e9).is_nan());
    }

    #[test]
    fn hysteresis_without_bound_is_refused() {
        let refused = |beta: f64| {
            let mut damper = MagnetorheologicalDamper::default();
            damper.fluid.hysteresis_beta = beta;
            damper.check().err().map(|fault| fault.0)
        };
        let expected =
            "hysteresis_beta = -3630000: must be > -hysteresis_gamma = -3630000, or the hysteresis has no bound";
        assert_eq!(refused(-3.63e6).unwrap(), expected);
        assert_eq!(refused(-3.62e6), None);
    }
}
