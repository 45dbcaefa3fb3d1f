use crate::friction::Exchange;
use crate::model::{Columns, Fault, Kind, Law, Model, Preset, boolean, real, row_of, row_of_mut};
use crate::number::Real;
use crate::ramp;
use crate::shock_absorber::coil_spring::Coil;
use crate::shock_absorber::coupling::{self, Series};
use crate::shock_absorber::damper_temperature::Heating;
use crate::shock_absorber::end_stops::{BumpStop, ReboundStop};
use crate::shock_absorber::gas_spring::GasChamber;
use crate::shock_absorber::geometry::Geometry;
use crate::shock_absorber::guide_contact::{FrictionLaw, Levels, Touch};
use crate::shock_absorber::hydraulic_damper::Hydraulics;
use crate::shock_absorber::law::{Answer, Evaluate, MEMORY, MOST_EVENTS, blank_memory};
use crate::shock_absorber::presets;
use crate::shock_absorber::telescopic_joint::{NormalSum, SideConvention, SideLoad, Wrench};

crate::choices! {
    /// Which side loads act on the joint.
    pub enum SideMode {
        /// The four inputs.
        Inputs,
        /// What the spring does to the joint: offset of its line of action and side force.
        Internal,
        /// Both.
        Sum,
    }
}

crate::choices! {
    /// How the inputs move within a step.
    pub enum InputMode {
        /// They are held.
        Hold,
        /// The length moves with the velocity, the velocity with the acceleration.
        Linear,
    }
}

crate::choices! {
    /// What the friction law remembers at the start.
    pub enum FrictionStart {
        /// What a second of motion at the first velocity leaves: steady sliding, or rest.
        Steady,
        /// Contacts at rest, without load.
        Zero,
        /// The start values of memory_1 and memory_2.
        Value,
    }
}

crate::part! {
    /// Where the side load comes from, and what is made of it.
    Side {
        /// Side loads that act on the joint.
        mode: fixed = SideMode::Sum.start(),
        /// Meaning of the four side-load inputs.
        convention: fixed = SideConvention::WrenchOnRod.start(),
        /// Offset of the spring's line of action along m (default chosen).
        offset_m: tunable = real("m", 0.003).shown_in("mm"),
        /// Offset of the spring's line of action along n.
        offset_n: tunable = real("m", 0.0).shown_in("mm"),
        /// Side force of the spring along m, relative to its axial force; it acts at the eye of the tube.
        force_ratio: tunable = real("1", 0.0),
        /// How the load of the joint becomes the load of its contacts.
        normal_sum: fixed = NormalSum::TwoPoint.start(),
        /// Factor on the contact forces for the distribution of pressure; 4 / pi for a cosine over half the rim.
        c_geo: tunable = real("1", 1.0).at_least(0.0),
    }
}

crate::part! {
    /// From the travel of the host to the length of the strut.
    Adapter {
        /// Length of the strut where the input length is 0.
        length_offset: fixed = real("m", 0.0).shown_in("mm"),
        /// Length of the strut per input length; -MR for wheel travel, -0.001 for millimetres of compression.
        length_gain: fixed = real("1", 1.0),
        /// Factor on force_travel, for the host's unit of force.
        force_gain: fixed = real("1", 1.0),
    }
}

crate::part! {
    /// Numerical settings.
    Numerics {
        /// Largest internal step (default chosen).
        h_max: fixed = real("s", 1e-4).positive().shown_in("ms"),
        /// How the inputs move within a step.
        input_mode: fixed = InputMode::Hold.start(),
        /// Mass that the strut carries or moves, whichever is smaller; for the advice step_limit only.
        mass_ref: tunable = real("kg", 16.4).positive(),
    }
}

crate::part! {
    /// State at the start.
    Start {
        /// What the friction law remembers at the start.
        friction_state: fixed = FrictionStart::Steady.start(),
    }
}

crate::part! {
    /// All that a strut's forces depend on besides its states.
    Setting {
        /// Distance of the eyes, or travel of the host: see adapter.
        length: input = real("m", 0.1775).shown_in("mm"),
        /// Time derivative of the length; positive in extension.
        velocity: input = real("m/s", 0.0),
        /// Load across the axis.
        load: (SideLoad),
        /// Spin of the rod relative to the tube, about the axis from tube to rod.
        spin_rate: input = real("rad/s", 0.0),
        /// All other forces along the strut, positive in extension; only for laws that hold a load at rest.
        external_force: input = real("N", 0.0),
        /// Time derivative of the velocity; for num.input_mode = Linear and for laws that ask for it.
        acceleration: input = real("m/s2", 0.0),
        /// Ambient temperature; used if thermal.enabled is true.
        temperature_ambient: input = real("K", 293.15).at_least(0.0).nominal(300.0).shown_in("degC"),
        /// Dimensions.
        geom: Geometry,
        /// Spring.
        spring: Coil,
        /// Gas.
        gas: GasChamber,
        /// Bump stop.
        bump: BumpStop,
        /// Rebound stop.
        rebound: ReboundStop,
        /// Damper.
        damper: Hydraulics,
        /// Friction law.
        friction: FrictionLaw,
        /// Contact of the rod with its guide and wiper.
        c1: Levels,
        /// Contact of the piston with the tube.
        c2: Levels = &[("mu_s", 0.10), ("mu_k", 0.08), ("preload_s", 8.0), ("preload_k", 6.0)],
        /// Side loads.
        side: Side,
        /// Heating of the damper.
        thermal: Heating,
        /// Travel of the host.
        adapter: Adapter,
        /// Numerical settings.
        num: Numerics,
        /// State at the start.
        init: Start,
    }
}

/// Motion of the strut, after the adapter.
#[derive(Clone, Copy)]
struct Motion<T> {
    length: T,
    velocity: T,
}

/// Axial forces without friction; positive pushes the eyes apart.
struct Forces<T> {
    spring: T,
    gas: T,
    bump: T,
    rebound: T,
}

impl<T: Real> Forces<T> {
    fn sum(&self) -> T {
        self.spring + self.gas + self.bump + self.rebound
    }
}

impl<T: Evaluate> Setting<T> {
    /// The same in plain numbers. Not inline, as the other parts of an output: what each puts on the stack is gone before
    /// the next.
    #[inline(never)]
    fn values(&self) -> Setting {
        self.map(&|number: T| number.value())
    }

    /// The slopes of its numbers.
    #[inline(never)]
    fn slopes(&self) -> Setting {
        self.map(&|number: T| number.slope())
    }
}

impl<T: Real> Setting<T> {
    fn motion(&self) -> Motion<T> {
        let given = self.given_length();
        // Eyes in one place are an input that nobody has set yet, and warned of.
        let length = if given.value() == 0.0 { self.geom.length_extended + given } else { given };
        Motion { length, velocity: self.adapter.length_gain * self.velocity }
    }

    /// The length that the input says.
    fn given_length(&self) -> T {
        self.adapter.length_offset + self.adapter.length_gain * self.length
    }

    fn compression(&self, motion: &Motion<T>) -> T {
        self.geom.length_extended - motion.length
    }

    fn forces(&self, motion: &Motion<T>) -> Forces<T> {
        let compression = self.compression(motion);
        Forces {
            spring: self.spring.force(compression),
            gas: self.gas.force(compression),
            bump: self.bump.force(compression, motion.velocity),
            rebound: self.rebound.force(compression, motion.velocity),
        }
    }

    /// Load of the joint: the inputs and what the spring adds.
    fn wrench(&self, spring_force: T) -> Wrench<T> {
        let mode = SideMode::of(self.side.mode.value());
        let mut wrench = self.load.wrench(SideConvention::of(self.side.convention.value()));
        if mode == SideMode::Internal {
            wrench = Wrench { force: [T::zero(); 2], moment: [T::zero(); 2] };
        }
        if mode != SideMode::Inputs {
            wrench.force[0] = wrench.force[0] + self.side.force_ratio * spring_force;
            wrench.moment[0] = wrench.moment[0] - self.side.offset_n * spring_force;
            wrench.moment[1] = wrench.moment[1] + self.side.offset_m * spring_force;
        }
        wrench
    }

    /// Normal forces at rod guide and piston.
    fn normal_forces(&self, motion: &Motion<T>) -> [T; 2] {
        let wrench = self.wrench(self.spring.force(self.compression(motion)));
        let sum = NormalSum::of(self.side.normal_sum.value());
        let normal = self.geom.guidance().normal_forces(&wrench, motion.length, sum);
        normal.map(|normal| self.side.c_geo * normal)
    }

    fn contacts(&self) -> [&Levels<T>; 2] {
        [&self.c1, &self.c2]
    }

    fn radii(&self) -> [T; 2] {
        [self.geom.r_1, self.geom.r_2]
    }

    /// What the two contacts feel. Mass and external force are theirs in proportion to what they can hold.
    fn touches(&self, motion: &Motion<T>) -> [Touch<T>; 2] {
        let normal = self.normal_forces(motion);
        let levels = self.contacts();
        let holds = [0, 1].map(|at| self.friction.levels(levels[at], normal[at])[1]);
        let total = holds[0] + holds[1];
        [0, 1].map(|at| {
            let share = if total.value() > 0.0 { holds[at] / total } else { T::from(0.5) };
            Touch {
                velocity: motion.velocity,
                rim_velocity: self.radii()[at] * self.spin_rate,
                normal_force: normal[at],
                acceleration: self.adapter.length_gain * self.acceleration,
                external_force: share * self.external_force,
                mass: share * self.friction.mass,
            }
        })
    }

    /// Velocity of the damper's piston.
    fn piston(&self, motion: &Motion<T>, piston_velocity: T) -> T {
        if self.damper.has_series() { piston_velocity } else { motion.velocity }
    }

    /// Do piston or temperature move while the inputs are held?
    fn has_own_dynamics(&self) -> bool {
        self.damper.has_series() || self.thermal.enabled.value() != 0.0
    }

    fn resistance(&self, piston_velocity: T, temperature: T) -> T {
        self.thermal.factor(temperature) * self.damper.resistance(piston_velocity)
    }
}

impl Setting {
    /// Gives length and velocity the slopes that their derivatives say, where the master gives none: to the length that
    /// of the mean velocity of the step.
    fn follow_the_motion(&mut self, now: &Setting, dt: f64) {
        if self.velocity == 0.0 {
            self.velocity = now.acceleration;
        }
        if self.length == 0.0 {
            self.length = now.velocity + 0.5 * self.velocity * dt;
        }
    }

    /// What a contact remembers after a while at this motion.
    #[inline(never)]
    fn settled(&self, at: usize) -> [f64; MEMORY] {
        self.friction.settled(self.contacts()[at], &self.touches(&self.motion())[at])
    }

    /// The same where the setting has moved along its slopes.
    #[inline(never)]
    fn settled_beside(&self, slopes: &Setting, distance: f64, at: usize) -> [f64; MEMORY] {
        let mut setting = *self;
        for (value, slope) in row_of_mut(&mut setting).iter_mut().zip(row_of(slopes)) {
            *value += distance * slope;
        }
        setting.settled(at)
    }

    /// Of slopes: leaves those of numbers that vary. Returns the largest one, relative to the sizes of the numbers.
    fn keep_those_of_reals(&mut self, setting: &Setting) -> f64 {
        let mut fastest = 0f64;
        for ((slope, value), variable) in row_of_mut(self).iter_mut().zip(row_of(setting)).zip(Setting::TABLE) {
            if !matches!(variable.kind, Kind::Real(_)) {
                *slope = 0.0;
            }
            fastest = fastest.max(slope.abs() / value.abs().max(SMALL));
        }
        fastest
    }

    /// Friction force along the axis after a step, if the strut moves so; nothing is changed.
    #[inline(never)]
    fn friction_after(&self, motion: &Motion<f64>, memory: Memories<f64>, dt: f64) -> f64 {
        let touches = self.touches(motion);
        let force = |at: usize| {
            let mut memory = *memory[at];
            let answer = self.friction.advance(self.contacts()[at], &touches[at], &mut memory, dt);
            answer.force * touches[at].direction()[0]
        };
        force(0) + force(1)
    }

    /// Friction force along the axis at this instant.
    #[inline(never)]
    fn friction_now(&self, motion: &Motion<f64>, memory: Memories<f64>) -> f64 {
        let touches = self.touches(motion);
        let force = |at: usize| {
            let answer = self.friction.force(self.contacts()[at], &touches[at], memory[at]);
            answer.force * touches[at].direction()[0]
        };
        force(0) + force(1)
    }

    /// Damper resistance at this instant and after a step at a held velocity.
    fn resistance_after(&self, motion: &Motion<f64>, state: &OtherStates<f64>, dt: f64) -> f64 {
        let mut piston = self.piston(motion, state.piston_velocity);
        let factor = self.thermal.factor(state.temperature);
        if dt > 0.0 {
            self.damper.advance(&mut piston, motion.velocity, factor, dt);
        }
        factor * self.damper.resistance(piston)
    }

    /// Derivatives of the force: with respect to the length at this instant; to the velocity at this instant and to one
    /// that is held over a step of `dt`, for the damper by itself.
    #[inline(never)] // as the other parts of an output: what each puts on the stack is gone before the next
    fn tangents(&self, memory: Memories<f64>, state: &OtherStates<f64>, dt: f64) -> Tangents {
        let here = self.motion();
        let now = |motion: &Motion<f64>| {
            self.forces(motion).sum() - self.friction_now(motion, memory) - self.resistance_after(motion, state, 0.0)
        };
        let undamped = |motion: &Motion<f64>| self.forces(motion).sum() - self.friction_now(motion, memory);
        let later = |motion: &Motion<f64>| self.forces(motion).sum() - self.friction_after(motion, memory, dt);
        let damper = |motion: &Motion<f64>| -self.resistance_after(motion, state, dt);
        let difference = |force: &dyn Fn(&Motion<f64>) -> f64, d_length: f64, d_velocity: f64| {
            let at = |side: f64| {
                force(&Motion { length: here.length + side * d_length, velocity: here.velocity + side * d_velocity })
            };
            (at(1.0) - at(-1.0)) / (2.0 * (d_length + d_velocity))
        };
        let d_velocity = PROBE_VELOCITY.max(1e-6 * here.velocity.abs());
        Tangents {
            length: difference(&now, PROBE_LENGTH, 0.0),
            velocity: difference(&undamped, 0.0, d_velocity),
            held_velocity: difference(&later, 0.0, d_velocity),
            held_damper: difference(&damper, 0.0, d_velocity),
            damper: self.slope_of_the_damper(self.piston(&here, state.piston_velocity), state.temperature),
        }
    }

    /// Slope of the damper's resistance about a velocity of the piston.
    fn slope_of_the_damper(&self, piston_velocity: f64, temperature: f64) -> f64 {
        let d_velocity = PROBE_VELOCITY.max(1e-6 * piston_velocity.abs());
        let at = |velocity: f64| self.resistance(velocity, temperature);
        (at(piston_velocity + d_velocity) - at(piston_velocity - d_velocity)) / (2.0 * d_velocity)
    }
}

/// Half widths of the central differences (chosen): far below the width of any friction law's transition, far above
/// rounding.
const PROBE_LENGTH: f64 = 1e-8;
const PROBE_VELOCITY: f64 = 1e-8;

/// Half width of the difference by which the settled friction is differentiated, relative to the sizes of the numbers
/// that vary, and the least size that counts, in SI units (both chosen).
const PROBE_SETTING: f64 = 1e-6;
const SMALL: f64 = 1e-3;

/// Shortest step that the tangents of a step are taken over (chosen), for their digits.
const SHORTEST_PROBE: f64 = 1e-6;

/// What the two contacts remember. By reference: a memory is long, and copies of it fill the stack.
type Memories<'a, T> = [&'a [T; MEMORY]; 2];

/// What a strut tells its master beside its results.
struct Advice {
    dlength: f64,
    dvelocity: f64,
    step_limit: f64,
}

struct Tangents {
    length: f64,
    /// Without the damper.
    velocity: f64,
    held_velocity: f64,
    /// Of the damper's force.
    held_damper: f64,
    /// Slope of the damper's resistance over the velocity of its piston.
    damper: f64,
}

/// States of the damper.
struct OtherStates<T> {
    piston_velocity: T,
    temperature: T,
}

/// Size of the deflections that most laws remember, in m.
const DEFLECTION: f64 = 1e-5;

crate::model! {
    /// Telescopic shock absorber with spring, gas, stops, damper and the friction of its joint under side load.
    ///
    /// # Equations
    ///
    /// ```text
    /// x = d_0 - d
    /// F = F_s + F_g + F_b + F_r + F_d - f_1 - f_2
    /// F_s = F_p + k x
    /// F_g = (p_0 (V_0 / (V_0 - A x))^n - p_a) A
    /// F_d = -c v
    /// f_k = phi_k(s_k) v / s_k,   tau_k = r_k phi_k(s_k) r_k w / s_k
    /// s_k = (v^2 + (r_k w)^2)^(1/2)
    /// N_1 = c_g |R / 2 + G / h_e|,   N_2 = c_g |R / 2 - G / h_e|
    /// h_e = (h^2 + h_r^2)^(1/2),   h = d_i + d_j - d
    /// ```
    ///
    /// With `geom.guidance_derived` the guidance follows from length and stroke alone. What the stroke leaves of the
    /// length is divided as in the start values: a third of it is the overlap at full extension, two ninths and four
    /// ninths keep the rod's eye from the guide and the piston from the tube's eye at full compression:
    ///
    /// ```text
    /// d_i = d_0 - s - 2/9 (d_0 - 2 s),   d_j = d_0 - s - 4/9 (d_0 - 2 s)
    /// ```
    ///
    /// F_s, F_b, F_r and F_d have other forms, too, by `spring.mode`, `bump.mode` and `damper.mode`; phi is any scalar law
    /// of the catalogue, chosen by `friction.model`, with the levels F_C = `preload_k` + `mu_k` N and
    /// F_S = `preload_s` + `mu_s` N of each contact. The parts are models of their own, with all equations on their
    /// pages: `TelescopicJoint` (contact forces), `GuideContact` (friction), `CoilSpring`, `GasSpring`, `EndStops`,
    /// `HydraulicDamper`, `DamperTemperature`.
    ///
    /// | symbol   | variable               | unit  | meaning                                                  |
    /// |----------|------------------------|-------|----------------------------------------------------------|
    /// | d        | `length`               | m     | distance of the eyes                                     |
    /// | v        | `velocity`             | m/s   | its time derivative                                      |
    /// | R_m, R_n | `side_force_m`, `side_force_n` | N | force of the tube on the rod, at the eye of the tube  |
    /// | M_m, M_n | `side_moment_m`, `side_moment_n` | N.m | moment of the tube on the rod, about that eye     |
    /// | w        | `spin_rate`            | rad/s | spin of the rod relative to the tube                     |
    /// | d_0      | `geom.length_extended` | m     | distance of the eyes at full extension                   |
    /// | x        | `compression`          | m     | compression from full extension                          |
    /// | s        | `geom.stroke`          | m     | stroke                                                   |
    /// | d_i      | `geom.d_i`             | m     | from the eye of the tube to the rod guide                |
    /// | d_j      | `geom.d_j`             | m     | from the eye of the rod to the piston                    |
    /// | h        | `overlap`              | m     | distance from piston to rod guide                        |
    /// | h_r      | `geom.h_reg`           | m     | regularisation of the overlap, 0 = none                  |
    /// | G        | -                      | N.m   | couple of the contact forces: see TelescopicJoint        |
    /// | c_g      | `side.c_geo`           | 1     | factor for the distribution of pressure                  |
    /// | s_k      | -                      | m/s   | sliding speed                                            |
    /// | F_s      | `force_spring`         | N     | force of the spring                                      |
    /// | F_p      | `spring.preload`       | N     | its force at full extension                              |
    /// | k        | `spring.k`             | N/m   | stiffness of the spring                                  |
    /// | F_g      | `force_gas`            | N     | force of the gas                                         |
    /// | p_0, V_0 | `gas.p0`, `gas.V0`     | Pa, m3 | pressure and volume of the gas at full extension        |
    /// | n        | `gas.n`                | 1     | polytropic exponent                                      |
    /// | A        | -                      | m2    | area of the rod, of `gas.rod_diameter`                   |
    /// | p_a      | `gas.p_ambient`        | Pa    | ambient pressure                                         |
    /// | F_b, F_r | `force_bump`, `force_rebound` | N | forces of bump stop and rebound stop                  |
    /// | F_d      | `force_damper`         | N     | force of the damper                                      |
    /// | c        | `damper.c_comp`, `damper.c_reb` | N.s/m | coefficient in compression, in extension         |
    /// | r_k      | `geom.r_1`, `geom.r_2` | m     | radius of rod and piston                                 |
    /// | F        | `force`                | N     | force of the strut                                       |
    /// | f_k      | `friction_1`, `friction_2` | N | friction force at rod guide and piston                   |
    /// | tau_k    | -                      | N.m   | friction torques, `friction_torque` is their sum         |
    /// | N_k      | `normal_1`, `normal_2` | N     | normal force at rod guide and piston                     |
    ///
    /// # Sign
    /// `length` grows in extension, `velocity` is its derivative, and every force pushes the eyes apart when positive.
    /// `friction_1` and `friction_2` are resistances with the sign of `velocity`; `force_friction` is their sum with the
    /// opposite sign. `friction_torque` acts on the tube about the axis from tube to rod, and reversed on the rod.
    /// A host with another travel uses the adapter: the strut's length is `adapter.length_offset` +
    /// `adapter.length_gain` * `length`, and `force_travel` is the generalised force on that travel. With a motion ratio
    /// MR = damper travel / wheel travel the gain is -MR; millimetres of compression have -0.001.
    ///
    /// # Step
    /// Friction laws advance as on their own pages (LuGre exactly), by the whole step where they stop
    /// `friction.mass`; damper and temperature in steps of at most `num.h_max`, at most 10,000 per communication
    /// step. `num.input_mode` = Linear moves the length with the velocity, and the velocity with the acceleration,
    /// within a step and leaves them there. All outputs follow the inputs at once. `dforce_dlength` is the derivative
    /// of `force` at this instant, `dforce_dvelocity` that with respect to a velocity held over a step like the last
    /// one (before the first: `num.h_max`), which includes what bristles and series stiffness add. `step_limit` is
    /// the largest communication step that keeps `num.mass_ref` stable on the strut as it is now, for the order of
    /// exchange `friction.exchange`; with `damper.k_series` it is 0.3 to 1 of that, less with undamped bristles. The
    /// three are advice and have no derivatives. At the start friction is as after a second of motion at the first
    /// velocity, unless `init.friction_state` says otherwise. The first velocity is that of the first step; in Model
    /// Exchange it is that at the end of the initialization.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; static levels below kinetic ones; tables that do not rise; a gas volume
    /// that the rod fills; `adapter.length_gain` = 0; a stroke of half of the length or more where the guidance is
    /// derived; what the chosen law refuses; in Model Exchange a law that is not offered for it itself. Parameters of laws that are not chosen are ignored, as are those of modes that are
    /// not chosen.
    ///
    /// # Limits
    /// The two eyes are never in one place: where the length of the strut is 0, as of an input that nothing has set yet,
    /// it is computed at full extension, with a warning. A `temperature_ambient` of 0 K counts with heating only, and
    /// warns then. `spring.enabled`, `gas.enabled`, `bump.enabled`, `rebound.enabled` and `damper.enabled` take a part
    /// away; without the spring the side load that it makes is gone, too.
    ///
    /// Rigid bodies: no bending of the rod, no bearing friction in the eyes; axial friction acts on the axis. Stops, spring
    /// and gas go on beyond the stroke. A law with memory remembers along the axis only. Most laws without memory do not
    /// hold a load at rest unless `friction.mass` and `external_force` are given; LuGre and the other bristle laws do.
    /// In Model Exchange `Coulomb`, `CoulombStiction`, `CoulombViscous`, `Stribeck` and `Karnopp` want `external_force`, and
    /// bristles that carry too much as the load falls slip down with a time constant of 1 ms: at a reversal the force lags.
    /// A host that steps at each evaluation of its integrator, several times in each of its steps, is warned: the way that
    /// `velocity` makes in the steps is then more than twice that of `length`.
    ///
    /// # Source
    /// Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis, University of Minho
    /// (2024), chapter 9, rebuilt from its lists of symbols and figures; LuGre parameters: its Table 7.1. Spring, travel
    /// and masses: Zips Racing ZR26 (ZipsRacingElectric/Vehicle-Dynamics, MIT licence). All other defaults are chosen;
    /// with them a strut has 21 N to 26 N of kinetic friction, within the 10 N to 70 N that rigs report (thesis, Table 2.1).
    ///
    /// # Example
    /// ```
    /// use stribeck::model::Law;
    /// use stribeck::shock_absorber::ShockAbsorber;
    /// let mut strut = ShockAbsorber::default();
    /// strut.setting.friction.model = 1.0; // none
    /// (strut.setting.length, strut.setting.velocity) = (0.1775, -0.2);
    /// strut.output();
    /// // 150 N + 45 N/mm 22.5 mm + gas + 1500 N.s/m 0.2 m/s
    /// assert!((strut.force - 1625.2555).abs() < 1e-4);
    /// assert_eq!(strut.force_damper, 300.0);
    /// ```
    ShockAbsorber: "Telescopic shock absorber with friction from its side load" {
        /// Inputs and parameters.
        setting: (Setting),
        /// What the friction law at the rod guide remembers, in SI units: see GuideContact.
        memory_1: [state; MEMORY] = blank_memory(DEFLECTION),
        /// What the friction law at the piston remembers, in SI units: see GuideContact.
        memory_2: [state; MEMORY] = blank_memory(DEFLECTION),
        /// Velocity of the damper's piston behind its series stiffness; that of the strut if there is none.
        piston_velocity: state = real("m/s", 0.0),
        /// Has the run begun?
        started: state = boolean(false),
        /// Last communication step; 0 before the first.
        step_size: state = real("s", 0.0).at_least(0.0).shown_in("ms").discrete(),
        /// Temperature of the damper.
        temperature: state_output = real("K", 293.15).positive().nominal(300.0).shown_in("degC"),
        /// Energy taken out of the motion by friction and damper since the start.
        dissipated_energy: state_output = real("J", 0.0),
        /// Force of the strut; positive pushes the eyes apart.
        force: output = real("N", 0.0),
        /// The same with the other sign: positive pulls the eyes together.
        force_tension: output = real("N", 0.0),
        /// Part of the spring.
        force_spring: output = real("N", 0.0),
        /// Part of the gas.
        force_gas: output = real("N", 0.0),
        /// Part of the bump stop.
        force_bump: output = real("N", 0.0),
        /// Part of the rebound stop.
        force_rebound: output = real("N", 0.0),
        /// Part of the damper.
        force_damper: output = real("N", 0.0),
        /// Part of the friction.
        force_friction: output = real("N", 0.0),
        /// Force on the travel of the host, by virtual work: see adapter.
        force_travel: output = real("N", 0.0),
        /// Axial friction at the rod guide; has the sign of the velocity when sliding.
        friction_1: output = real("N", 0.0),
        /// Axial friction at the piston; has the sign of the velocity when sliding.
        friction_2: output = real("N", 0.0),
        /// Normal force at the rod guide.
        normal_1: output = real("N", 0.0),
        /// Normal force at the piston.
        normal_2: output = real("N", 0.0),
        /// Friction torque about the axis, on the tube; has the sign of the spin rate when sliding.
        friction_torque: output = real("N.m", 0.0),
        /// Compression from full extension.
        compression: output = real("m", 0.0).shown_in("mm"),
        /// Distance from piston to rod guide.
        overlap: output = real("m", 0.0).shown_in("mm"),
        /// Derivative of the force with respect to the length of the strut.
        dforce_dlength: output = real("N/m", 0.0).without_derivatives(),
        /// Derivative of the force after a step with respect to the velocity of the strut.
        dforce_dvelocity: output = real("N.s/m", 0.0).without_derivatives(),
        /// Largest communication step that is stable for num.mass_ref; advice to the master.
        step_limit: output = real("s", 0.0).shown_in("ms").without_derivatives(),
        /// Power taken out of the motion by friction and damper.
        dissipated_power: output = real("W", 0.0),
        /// Do the contacts stick?
        sticking: output = boolean(false),
        /// Is the bump stop touched?
        bump_active: output = boolean(false),
        /// Is the overlap so short that the contact forces are regularised?
        overlap_low: output = boolean(false),
    }
}

impl<T: Evaluate> ShockAbsorber<T> {
    fn has_started(&self) -> bool {
        self.started.value() != 0.0
    }

    /// Works on what the two contacts remember; before the run, on what they will remember at its start.
    fn with_memories<R>(&self, work: impl FnOnce(Memories<T>) -> R) -> R {
        if self.has_started() { work([&self.memory_1, &self.memory_2]) } else { self.with_first_memories(work) }
    }

    #[inline(never)] // so that only those who need them have them on their stack
    fn with_first_memories<R>(&self, work: impl FnOnce(Memories<T>) -> R) -> R {
        match FrictionStart::of(self.setting.init.friction_state.value()) {
            FrictionStart::Steady => {
                let mut memories = [[T::zero(); MEMORY]; 2];
                self.settle(&mut memories);
                work([&memories[0], &memories[1]])
            }
            FrictionStart::Zero => {
                let mut memory = [T::zero(); MEMORY];
                self.setting.friction.write_fresh(&mut memory);
                work([&memory; 2])
            }
            FrictionStart::Value => work([&self.memory_1, &self.memory_2]),
        }
    }

    /// Finds what the two contacts remember once they have moved for a while. Its derivative is a central difference
    /// along the direction that the setting carries.
    #[inline(never)]
    fn settle(&self, memories: &mut [[T; MEMORY]; 2]) {
        let setting = self.setting.values();
        for (at, memory) in memories.iter_mut().enumerate() {
            let settled = setting.settled(at);
            memory.iter_mut().zip(&settled).for_each(|(number, value)| *number = T::from(*value));
        }
        self.add_slopes(&setting, memories);
    }

    #[inline(never)]
    fn add_slopes(&self, setting: &Setting, memories: &mut [[T; MEMORY]; 2]) {
        let mut slopes = self.setting.slopes();
        let fastest = slopes.keep_those_of_reals(setting);
        if fastest == 0.0 {
            return;
        }
        let distance = PROBE_SETTING / fastest;
        for (at, memory) in memories.iter_mut().enumerate() {
            let after = setting.settled_beside(&slopes, distance, at);
            let before = setting.settled_beside(&slopes, -distance, at);
            for (value, (after, before)) in memory.iter_mut().zip(after.iter().zip(&before)) {
                *value = T::with_slope(value.value(), (after - before) / (2.0 * distance));
            }
        }
    }

    fn damper_state(&self) -> OtherStates<T> {
        let settles =
            !self.has_started() && FrictionStart::of(self.setting.init.friction_state.value()) == FrictionStart::Steady;
        OtherStates {
            piston_velocity: if settles { self.setting.motion().velocity } else { self.piston_velocity },
            temperature: self.temperature,
        }
    }

    fn write_forces(&mut self, motion: &Motion<T>, friction: [T; 2]) {
        let setting = &self.setting;
        let forces = setting.forces(motion);
        let state = self.damper_state();
        let piston = setting.piston(motion, state.piston_velocity);
        let resistance = setting.resistance(piston, state.temperature);
        self.force_spring = forces.spring;
        self.force_gas = forces.gas;
        self.force_bump = forces.bump;
        self.force_rebound = forces.rebound;
        self.force_damper = -resistance;
        self.force_friction = -(friction[0] + friction[1]);
        self.force = forces.sum() + self.force_damper + self.force_friction;
        self.force_tension = -self.force;
        self.force_travel = self.setting.adapter.force_gain * self.setting.adapter.length_gain * self.force;
        self.dissipated_power = resistance * piston;
    }

    /// Power that friction and damper take out of the motion.
    fn power(&self, motion: &Motion<T>, touches: &[Touch<T>; 2], memories: Memories<T>) -> T {
        let (setting, state) = (&self.setting, self.damper_state());
        let piston = setting.piston(motion, state.piston_velocity);
        let friction = |at: usize| {
            let answer = setting.friction.force(setting.contacts()[at], &touches[at], memories[at]);
            answer.force * touches[at].signed_speed()
        };
        setting.resistance(piston, state.temperature) * piston + friction(0) + friction(1)
    }

    fn write_friction(&mut self, touches: &[Touch<T>; 2], answers: &[Answer<T>; 2]) {
        let directions = touches.map(|touch| touch.direction());
        let radii = self.setting.radii();
        [self.friction_1, self.friction_2] = [0, 1].map(|at| answers[at].force * directions[at][0]);
        let torque = [0, 1].map(|at| radii[at] * answers[at].force * directions[at][1]);
        self.friction_torque = torque[0] + torque[1];
        for (touch, answer) in touches.iter().zip(answers) {
            self.dissipated_power = self.dissipated_power + answer.force * touch.signed_speed();
        }
        self.sticking = truth(self.sticks(touches, answers));
    }

    /// Does at least one contact stick, and none that is loaded slip?
    fn sticks(&self, touches: &[Touch<T>; 2], answers: &[Answer<T>; 2]) -> bool {
        let is_loaded = |at: usize| {
            let [kinetic, _] = self.setting.friction.levels(self.setting.contacts()[at], touches[at].normal_force);
            self.setting.friction.chosen().is_some() && kinetic.value() > 0.0
        };
        let loaded = [is_loaded(0), is_loaded(1)];
        (loaded[0] || loaded[1]) && (0..2).all(|at| !loaded[at] || answers[at].sticking)
    }

    /// Tangents and the step that they allow.
    #[inline(never)]
    fn advice(&self, memories: Memories<T>) -> Advice {
        let setting = self.setting.values();
        let mut values = [[0.0; MEMORY]; 2];
        for (values, memory) in values.iter_mut().zip(memories) {
            values.iter_mut().zip(memory).for_each(|(value, number)| *value = number.value());
        }
        let OtherStates { piston_velocity, temperature } = self.damper_state();
        let state = OtherStates { piston_velocity: piston_velocity.value(), temperature: temperature.value() };
        let dt =
            if self.step_size.value() > 0.0 { self.step_size.value().max(SHORTEST_PROBE) } else { setting.num.h_max };
        let tangents = setting.tangents([&values[0], &values[1]], &state, dt);
        // What a held velocity adds over a step is the work of bristles: a stiffness.
        let bristles = (tangents.velocity - tangents.held_velocity).max(0.0) / dt;
        let is_held = InputMode::of(setting.num.input_mode) == InputMode::Hold;
        let (stiffness, held) = if is_held { (-tangents.length, bristles) } else { (bristles - tangents.length, 0.0) };
        let exchange = Exchange::of(setting.friction.exchange);
        let mass = setting.num.mass_ref;
        let limit = if setting.damper.has_series() {
            let series = Series { damping: tangents.damper, stiffness: setting.damper.k_series, is_late: is_held };
            coupling::step_limit_in_series(stiffness, held, -tangents.velocity, &series, mass, exchange)
        } else {
            coupling::step_limit(stiffness, held, tangents.velocity - tangents.damper, mass, exchange)
        };
        Advice { dlength: tangents.length, dvelocity: tangents.held_velocity + tangents.held_damper, step_limit: limit }
    }

    fn write_advice(&mut self, advice: &Advice) {
        self.dforce_dlength = T::from(advice.dlength);
        self.dforce_dvelocity = T::from(advice.dvelocity);
        self.step_limit = T::from(advice.step_limit);
    }
}

impl<T: Evaluate> Law for ShockAbsorber<T> {
    #[inline(never)]
    fn output(&mut self) {
        let motion = self.setting.motion();
        let touches = self.setting.touches(&motion);
        let (answers, advice) = self.with_memories(|memories| {
            let force =
                |at: usize| self.setting.friction.force(self.setting.contacts()[at], &touches[at], memories[at]);
            ([0, 1].map(force), self.advice(memories))
        });
        let friction = [0, 1].map(|at| answers[at].force * touches[at].direction()[0]);
        self.write_forces(&motion, friction);
        self.write_friction(&touches, &answers);
        [self.normal_1, self.normal_2] = touches.map(|touch| touch.normal_force);
        self.compression = self.setting.compression(&motion);
        self.overlap = self.setting.geom.guidance().overlap(motion.length);
        self.overlap_low = truth(self.setting.geom.guidance().is_low(motion.length));
        self.bump_active = truth(self.setting.bump.is_active(self.compression));
        self.write_advice(&advice);
    }

    fn derivatives(&self, rate: &mut Self) {
        let setting = &self.setting;
        let motion = setting.motion();
        let touches = setting.touches(&motion);
        let (piston, factor) = (self.damper_state().piston_velocity, setting.thermal.factor(self.temperature));
        rate.piston_velocity = setting.damper.rate(piston, motion.velocity, factor);
        let power = self.with_memories(|memories| {
            let memory_rates = [&mut rate.memory_1, &mut rate.memory_2];
            for (at, rate) in memory_rates.into_iter().enumerate() {
                setting.friction.write_rate(setting.contacts()[at], &touches[at], memories[at], rate);
            }
            self.power(&motion, &touches, memories)
        });
        rate.dissipated_energy = power;
        rate.temperature = setting.thermal.rate(self.temperature, setting.temperature_ambient, power);
    }
}

fn truth<T: Real>(is_true: bool) -> T {
    T::from(f64::from(u8::from(is_true)))
}

impl ShockAbsorber {
    fn start(&mut self) {
        if !self.has_started() {
            self.piston_velocity = self.damper_state().piston_velocity;
            self.remember_first();
            self.started = 1.0;
        }
    }

    /// Not inline, as what a step does after it: a start puts much on the stack that is gone before the step.
    #[inline(never)]
    fn remember_first(&mut self) {
        match FrictionStart::of(self.setting.init.friction_state) {
            FrictionStart::Steady => {
                self.memory_1 = self.setting.settled(0);
                self.memory_2 = self.setting.settled(1);
            }
            FrictionStart::Zero => {
                self.setting.friction.write_fresh(&mut self.memory_1);
                self.setting.friction.write_fresh(&mut self.memory_2);
            }
            FrictionStart::Value => {}
        }
    }

    /// A step in which the length moves with the velocity, and the velocity with the acceleration, where the master gives
    /// no other slopes.
    #[inline(never)]
    fn step_along_the_motion(&mut self, slope: Option<&Self>, dt: f64) {
        let mut slope = slope.copied().unwrap_or_else(|| ramp::held_inputs(self));
        slope.setting.follow_the_motion(&self.setting, dt);
        self.follow(&slope, dt);
    }

    /// Advances while the inputs move with `slope`.
    #[inline(never)]
    fn follow(&mut self, slope: &Self, dt: f64) {
        let begin = *self;
        // The force that stops a mass belongs to the whole step.
        let stopping = self.setting.friction.moves_mass().then(|| {
            ramp::set_inputs(self, &begin, slope, dt);
            self.slide_from(&begin.setting, dt)
        });
        let count = super::substeps(dt, self.setting.num.h_max);
        let h = dt / f64::from(count);
        for piece in 0..count {
            ramp::set_inputs(self, &begin, slope, (f64::from(piece) + 0.5) * h);
            let friction = stopping.unwrap_or_else(|| self.slide(h));
            self.pump(friction, h);
        }
        ramp::set_inputs(self, &begin, slope, dt);
    }

    /// Advances the friction at held inputs. Returns the power that it takes out of the motion.
    fn slide(&mut self, dt: f64) -> f64 {
        let setting = &self.setting;
        let touches = setting.touches(&setting.motion());
        let [c_1, c_2] = setting.contacts();
        let energy = setting.friction.advance(c_1, &touches[0], &mut self.memory_1, dt).energy
            + setting.friction.advance(c_2, &touches[1], &mut self.memory_2, dt).energy;
        energy / dt
    }

    /// As [`ShockAbsorber::slide`], over a step in which the inputs have moved linearly to where they are.
    fn slide_from(&mut self, begin: &Setting, dt: f64) -> f64 {
        let setting = &self.setting;
        let (before, after) = (begin.touches(&begin.motion()), setting.touches(&setting.motion()));
        let mut energy = 0.0;
        for (at, memory) in [&mut self.memory_1, &mut self.memory_2].into_iter().enumerate() {
            let touches = [&before[at], &after[at]];
            energy += setting.friction.advance_from(setting.contacts()[at], touches, memory, dt).energy;
        }
        energy / dt
    }

    /// One internal step of damper and temperature at held inputs, while friction takes a power out of the motion.
    fn pump(&mut self, friction: f64, dt: f64) {
        let setting = &self.setting;
        let factor = setting.thermal.factor(self.temperature);
        let velocity = setting.motion().velocity;
        let damper = setting.damper.advance(&mut self.piston_velocity, velocity, factor, dt);
        let power = friction + damper / dt;
        self.temperature = setting.thermal.after(self.temperature, setting.temperature_ambient, power, dt);
        self.dissipated_energy += friction * dt + damper;
    }
}

impl Model for ShockAbsorber {
    const MODEL_EXCHANGE: bool = true;
    const EVENT_INDICATORS: usize = 2 * MOST_EVENTS;
    const PRESETS: &'static [Preset] = presets::ALL;

    fn check(&self) -> Result<(), Fault> {
        let setting = &self.setting;
        setting.c1.check("c1.")?;
        setting.c2.check("c2.")?;
        setting.friction.check(&setting.c1)?;
        setting.friction.check(&setting.c2)?;
        setting.spring.check()?;
        setting.gas.check(setting.geom.stroke)?;
        setting.geom.check()?;
        setting.damper.check()?;
        if setting.adapter.length_gain == 0.0 {
            return Err(Fault::new("adapter.length_gain = 0: must not be 0"));
        }
        Ok(())
    }

    fn warning(&self) -> Option<Fault> {
        let setting = &self.setting;
        if setting.given_length() == 0.0 {
            let (length, extended) = (setting.length, setting.geom.length_extended);
            let text = "the distance of the eyes must be > 0; until it is, the strut is at full extension";
            let text = format_args!("length = {length}: {text}, geom.length_extended = {extended} m");
            return Some(Fault::new(text));
        }
        setting.thermal.warning(setting.temperature_ambient).or_else(|| setting.friction.warning())
    }

    fn check_motion(&self) -> Result<(), Fault> {
        let (setting, motion) = (&self.setting, self.setting.motion());
        setting.gas.check_compression(setting.compression(&motion))?;
        setting.geom.guidance().check_overlap(motion.length)
    }

    fn check_exchange(&self) -> Result<(), Fault> {
        self.setting.friction.check_exchange(&self.setting.c1)
    }

    fn event_indicators(&self, indicators: &mut [f64]) {
        let touches = self.setting.touches(&self.setting.motion());
        self.with_memories(|memories| {
            for (at, indicators) in indicators.chunks_exact_mut(MOST_EVENTS).enumerate() {
                let levels = self.setting.contacts()[at];
                indicators.copy_from_slice(&self.setting.friction.indicators(levels, &touches[at], memories[at]));
            }
        });
    }

    fn at_event(&mut self) {
        self.start();
        let touches = self.setting.touches(&self.setting.motion());
        for (at, memory) in [&mut self.memory_1, &mut self.memory_2].into_iter().enumerate() {
            self.setting.friction.at_event(self.setting.contacts()[at], &touches[at], memory);
        }
    }

    fn step(&mut self, dt: f64) {
        self.start();
        self.step_size = dt;
        if InputMode::of(self.setting.num.input_mode) == InputMode::Linear {
            return self.step_along_the_motion(None, dt);
        }
        let friction = self.slide(dt);
        let count = if self.setting.has_own_dynamics() { super::substeps(dt, self.setting.num.h_max) } else { 1 };
        for _ in 0..count {
            self.pump(friction, dt / f64::from(count));
        }
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        self.start();
        self.step_size = dt;
        if InputMode::of(self.setting.num.input_mode) == InputMode::Linear {
            self.step_along_the_motion(Some(slope), dt);
        } else {
            self.follow(slope, dt);
        }
    }
}
