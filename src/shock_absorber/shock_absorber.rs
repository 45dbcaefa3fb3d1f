use std::mem::offset_of;
use std::ops::Range;

use crate::model::ramp;
use crate::model::{Derivatives, Fault, GivesBack, Law, Meaning, Model, ModelExchange, Preset, Width, boolean, real};
use crate::number::Mask;
use crate::shock_absorber::fluid_state::FluidState;
use crate::shock_absorber::guide_contact::Touch;
use crate::shock_absorber::hydraulic_damper::DamperState;
use crate::shock_absorber::law::{Answer, Evaluate, MOST_EVENTS};
use crate::shock_absorber::law_plan::{MEMORY, blank_memory};
use crate::shock_absorber::memories::Memories;
use crate::shock_absorber::mount::MountState;
use crate::shock_absorber::presets;
use crate::shock_absorber::setting::{FrictionStart, InputMode, Motion, OtherStates, Setting};

/// Typical size of the deflections of most laws, in m.
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
    /// With `geom.guidance_derived` the guidance is derived from length and stroke. The length less two strokes is
    /// divided in the proportions of the start values: one third is the overlap at full extension, two ninths and four
    /// ninths are the distances from the rod's eye to the guide and from the piston to the tube's eye at full
    /// compression:
    ///
    /// ```text
    /// d_i = d_0 - s - 2/9 (d_0 - 2 s),   d_j = d_0 - s - 4/9 (d_0 - 2 s)
    /// ```
    ///
    /// With `mount.enabled` the rod ends in a mass and a rubber mount, which is a `RubberMount` between it and its eye.
    /// The strut is then longer than the distance of the eyes by the displacement y, and faster by its rate: d + y and v +
    /// dy/dt take the places of d and v above. The eye of the rod feels $F_m$ instead of $F$:
    ///
    /// ```text
    /// m d2y/dt2 = F - F_m,   F_m = F_0 + F_e
    /// ```
    ///
    /// $F_s$, $F_b$, $F_r$ and $F_d$ also have other forms, selected by `spring.mode`, `bump.mode` and `damper.mode`;
    /// phi is any scalar law of the catalogue, chosen by `friction.model`, with the levels $F_C$ = `preload_k` + `mu_k`
    /// N and $F_S$ = `preload_s` + `mu_s` N of each contact. The parts are models of their own, with all equations on
    /// their pages: `TelescopicJoint` (contact forces), `GuideContact` (friction), `CoilSpring`, `GasSpring`,
    /// `EndStops`, `HydraulicDamper`, `DamperTemperature`.
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
    /// | V        | `voltage`              | V     | voltage at the driver of a magnetorheological damper     |
    /// | c        | `damper.c_comp`, `damper.c_reb` | N.s/m | coefficient in compression, in extension         |
    /// | r_k      | `geom.r_1`, `geom.r_2` | m     | radius of rod and piston                                 |
    /// | y        | `mount.displacement`   | m     | displacement of the rod towards its eye                  |
    /// | m        | `mount.mass`           | kg    | mass of the rod with the inner part of the mount         |
    /// | F_m      | `force_mount`          | N     | force of the mount                                       |
    /// | F_0      | `mount.preload`        | N     | force that it carries without displacement               |
    /// | F_e      | -                      | N     | force of its rubber: see RubberMount                     |
    /// | F        | `force`                | N     | force of the strut                                       |
    /// | f_k      | `friction_1`, `friction_2` | N | friction force at rod guide and piston                   |
    /// | tau_k    | -                      | N.m   | friction torques, `friction_torque` is their sum         |
    /// | N_k      | `normal_1`, `normal_2` | N     | normal force at rod guide and piston                     |
    ///
    /// # Sign
    /// `length` grows in extension, `velocity` is its derivative, and every force pushes the eyes apart when positive.
    /// `friction_1` and `friction_2` are resistances with the sign of `velocity`; `force_friction` is their sum with
    /// the opposite sign. `friction_torque` acts on the tube about the axis from tube to rod, and reversed on the rod.
    /// A host with a different travel variable uses the adapter: the strut's length is `adapter.length_offset` +
    /// `adapter.length_gain` * `length`, and `force_travel` is the generalised force on that travel. With a motion
    /// ratio MR = damper travel / wheel travel the gain is -MR; for millimetres of compression it is -0.001.
    ///
    /// # Step
    /// Friction laws advance as described on their own pages (LuGre exactly), over the whole step if they stop
    /// `friction.mass`; damper and temperature advance in steps of at most `num.h_max`, at most 10,000 per
    /// communication step. `num.input_mode` = Linear moves the length with the velocity, and the velocity with the
    /// acceleration, within a step and keeps their final values. All outputs follow the inputs at once.
    /// `dforce_dlength` is the derivative of `force` at this instant, `dforce_dvelocity` that with respect to a
    /// velocity held over a step like the last one (before the first: `num.h_max`), which includes what bristles and
    /// series stiffness add. `step_limit` is the largest communication step that keeps `num.mass_ref` stable on the
    /// strut in its present state, for the order of exchange `friction.exchange`; with `damper.k_series` it is 0.3 to 1
    /// of that, less with undamped bristles. The three are advice: computed when they are read (in Rust by
    /// `Law::advise`), without derivatives. Where they would not be finite, reading them is an error. At the start friction has
    /// the state reached after one second at the initial velocity, unless `init.friction_state` selects another. The
    /// initial velocity is that of the first step; in Model Exchange it is that at the end of the initialization.
    ///
    /// Behind a mount the rod moves at a constant velocity in each internal step, at the end of which the forces on it are
    /// in balance: of first order in `num.h_max`, and stable however stiff the mount and light the rod is. The mount starts
    /// at rest, displaced until it carries spring, gas and stops, unless `init.friction_state` = Value gives its state. Until
    /// the first step `mount.displacement` shows the start value of that state; `compression` contains the displacement.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; static levels below kinetic ones; tables that are not strictly
    /// ascending; a gas volume that the rod fills; `adapter.length_gain` = 0; a stroke of at least half the length if
    /// the guidance is derived; whatever the chosen law refuses; in Model Exchange, a law that does not support it; behind
    /// a mount a law that holds a mass at events (`Coulomb`, `CoulombStiction`, `CoulombViscous`, `Stribeck`, `Karnopp`,
    /// `FrictionalLag`: its force at rest follows from `external_force`, which does not know the rod) or follows the
    /// acceleration (`NonReversible`, `Wojewoda`: the host gives that of the eyes), `friction.mass`, `mount.k_e` = 0, and a
    /// `mount.preload` that the gas cannot carry. Parameters of laws and modes that are not chosen are ignored.
    ///
    /// # Limits
    /// The eyes cannot coincide: a strut of length 0, as with an input that is not set yet, is computed at full
    /// extension, with a warning. A negative length is used as it is, with a warning. A `temperature_ambient` of 0 K
    /// matters only with heating, and gives a warning then. `spring.enabled`, `gas.enabled`, `bump.enabled`,
    /// `rebound.enabled` and `damper.enabled` remove a part; without the spring its side load is absent, too.
    ///
    /// Rigid bodies: no bending of the rod, no bearing friction in the eyes; axial friction acts on the axis. Stops,
    /// spring and gas continue beyond the stroke. The memory of a law belongs to the axial motion only. Most laws
    /// without memory do not hold a load at rest unless `friction.mass` and `external_force` are given; LuGre and the
    /// other bristle laws do. In Model Exchange `Coulomb`, `CoulombStiction`, `CoulombViscous`, `Stribeck` and
    /// `Karnopp` need `external_force`: `force_without_friction` less the force of a strut whose length keeps its
    /// velocity, as `QuarterCar` computes it. Bristles that carry too much when the load falls slip with a time
    /// constant of 1 ms: at a reversal the force lags. A warning is logged if the host steps the strut at every
    /// evaluation of its integrator, several times per step: the distance travelled by `velocity` is then more than
    /// twice that by `length`.
    ///
    /// With laws that are not passive the contacts can give back more energy than they took. A warning names the
    /// parameter and a value with which they do not, under any load: see GuideContact. There is none where the damper takes
    /// that energy: if it is linear, without series stiffness and heating, and the smaller one of `damper.c_comp` and
    /// `damper.c_reb`, with `damper.scale`, makes up for the viscous coefficients that both contacts lack. It resists along
    /// the axis only, not the spin of a rod.
    ///
    /// A mount moves along the axis only. The strut does not know how its eyes accelerate in space: the inertia of the rod
    /// is that against its eye. `force_without_friction`, `dforce_dlength` and `dforce_dvelocity` are those of a rod that is
    /// held; `step_limit` takes the mount for a stiffness in series with the damper. `dissipated_energy` does not contain
    /// what the rubber takes.
    ///
    /// # Source
    /// Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis, University of Minho
    /// (2024), chapter 9, reconstructed from its lists of symbols and figures; LuGre parameters: its Table 7.1. Spring,
    /// travel and masses: Zips Racing ZR26 (ZipsRacingElectric/Vehicle-Dynamics, MIT licence). All other defaults are
    /// chosen; with them a strut has 21 N to 26 N of kinetic friction, within the 10 N to 70 N reported from test rigs
    /// (thesis, Table 2.1).
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
        /// States of the friction law at the rod guide, in SI units: see GuideContact.
        memory_1: [state; MEMORY] = blank_memory(DEFLECTION),
        /// States of the friction law at the piston, in SI units: see GuideContact.
        memory_2: [state; MEMORY] = blank_memory(DEFLECTION),
        /// Velocity of the damper's piston behind its series stiffness; that of the strut without a series stiffness.
        piston_velocity: state = real("m/s", 0.0),
        /// Has the run begun?
        started: state = boolean(false).hidden(),
        /// Last communication step; 0 before the first.
        step_size: state = real("s", 0.0).at_least(0.0).shown_in("ms").discrete().hidden(),
        /// Temperature of the damper.
        temperature: state_output = real("K", 293.15).positive().nominal(300.0).shown_in("degC"),
        /// Energy taken out of the motion by friction and damper since the start.
        dissipated_energy: state_output = real("J", 0.0).means(Meaning::Energy),
        /// Magnetorheological damper.
        mr: FluidState,
        /// Rubber mount.
        mount: MountState,
        /// Force of the strut; positive pushes the eyes apart.
        force: output = real("N", 0.0).means(Meaning::StrutForce),
        /// The same with the opposite sign: positive pulls the eyes together.
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
        /// Axial force without friction. At rest the friction carries it, less the force with which the host holds the
        /// length.
        force_without_friction: output = real("N", 0.0).means(Meaning::ForceWithoutFriction),
        /// Force of the mount, on the eye of the rod; force if there is no mount.
        force_mount: output = real("N", 0.0),
        /// Part of the force that moves the rod and not its eye: force less force_mount.
        rod_force: output = real("N", 0.0).means(Meaning::RodForce),
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
        dforce_dlength: output = real("N/m", 0.0).advice(),
        /// Derivative of the force after a step with respect to the velocity of the strut.
        dforce_dvelocity: output = real("N.s/m", 0.0).advice(),
        /// Largest communication step that is stable for num.mass_ref; advice to the master.
        step_limit: output = real("s", 0.0).shown_in("ms").advice(),
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
    pub(super) fn has_started(&self) -> T::Mask {
        !self.started.vanishes()
    }

    pub(super) fn damper_state(&self) -> OtherStates<T> {
        let settles = !self.has_started() & FrictionStart::Steady.is(self.setting.init.friction_state);
        let piston_velocity = settles.choose(|| self.setting.motion().velocity, || self.piston_velocity);
        OtherStates { damper: DamperState { piston_velocity, fluid: self.mr }, temperature: self.temperature }
    }

    #[inline(never)]
    fn write_outputs(&mut self, motion: &Motion<T>, touches: &[Touch<T>; 2]) {
        let answers = self.with_memories(|memories| {
            [0, 1].map(|at| self.setting.friction.force(self.setting.contacts()[at], &touches[at], memories[at]))
        });
        let friction = [0, 1].map(|at| answers[at].force * touches[at].direction()[0]);
        self.write_forces(motion, friction);
        self.write_friction(touches, &answers);
        [self.normal_1, self.normal_2] = touches.map(|touch| touch.normal_force);
        self.compression = self.setting.compression(motion);
        self.overlap = self.setting.geom.guidance().overlap(motion.length);
        self.overlap_low = T::truth(self.setting.geom.guidance().is_low(motion.length));
        self.bump_active = T::truth(self.setting.bump.is_active(self.compression));
    }

    fn write_forces(&mut self, motion: &Motion<T>, friction: [T; 2]) {
        let setting = &self.setting;
        let forces = setting.forces(motion);
        let state = self.damper_state();
        let piston = setting.piston(motion, &state);
        let resistance = setting.resistance(piston, &state);
        self.force_spring = forces.spring;
        self.force_gas = forces.gas;
        self.force_bump = forces.bump;
        self.force_rebound = forces.rebound;
        self.force_damper = -resistance;
        self.force_friction = -(friction[0] + friction[1]);
        self.force_without_friction = forces.sum() + self.force_damper;
        self.force = self.force_without_friction + self.force_friction;
        self.force_mount = self.force_on_the_rod_eye();
        self.rod_force = self.force - self.force_mount;
        self.force_tension = -self.force;
        self.force_travel = self.setting.adapter.force_gain * self.setting.adapter.length_gain * self.force;
        self.dissipated_power = resistance * piston;
    }

    /// Power that friction and damper take out of the motion.
    fn power(&self, motion: &Motion<T>, touches: &[Touch<T>; 2], memories: Memories<T>) -> T {
        let (setting, state) = (&self.setting, self.damper_state());
        let piston = setting.piston(motion, &state);
        let friction = |at: usize| {
            let answer = setting.friction.force(setting.contacts()[at], &touches[at], memories[at]);
            answer.force * touches[at].signed_speed()
        };
        setting.resistance(piston, &state) * piston + friction(0) + friction(1)
    }

    fn write_friction(&mut self, touches: &[Touch<T>; 2], answers: &[Answer<T>; 2]) {
        let directions = touches.map(|touch| touch.direction());
        let radii = self.setting.radii();
        [self.friction_1, self.friction_2] = [0, 1].map(|at| answers[at].force * directions[at][0]);
        let torque = [0, 1].map(|at| radii[at] * answers[at].force * directions[at][1]);
        self.friction_torque = torque[0] + torque[1];
        for (touch, answer) in touches.iter().zip(answers) {
            self.dissipated_power += answer.force * touch.signed_speed();
        }
        self.sticking = T::truth(self.sticks(touches, answers));
    }

    /// Whether at least one contact sticks and no loaded one slips.
    fn sticks(&self, touches: &[Touch<T>; 2], answers: &[Answer<T>; 2]) -> T::Mask {
        let has_friction = T::Mask::from(self.setting.friction.chosen().is_some());
        let [is_loaded_1, is_loaded_2] = [0, 1].map(|at| {
            let [kinetic, _] = self.setting.friction.levels(self.setting.contacts()[at], touches[at].normal_force);
            has_friction & kinetic.is_positive()
        });
        let [slips_1, slips_2] = [0, 1].map(|at| answers[at].sticking.vanishes());
        (is_loaded_1 | is_loaded_2) & !(is_loaded_1 & slips_1) & !(is_loaded_2 & slips_2)
    }
}

impl<T: Evaluate> Law for ShockAbsorber<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        let motion = self.motion();
        self.write_outputs(&motion, &self.setting.touches(&motion));
    }

    fn advise(&mut self) {
        let advice = self.with_memories(|memories| {
            if T::HAS_VALUES { self.advice(memories).map(T::from) } else { self.sources_of_advice(memories) }
        });
        [self.dforce_dlength, self.dforce_dvelocity, self.step_limit] = advice;
    }
}

impl<T: Evaluate> Derivatives for ShockAbsorber<T> {
    fn derivatives(&self, rate: &mut Self) {
        let setting = &self.setting;
        let motion = self.motion();
        let touches = setting.touches(&motion);
        let (state, factor) = (self.damper_state().damper, setting.thermal.factor(self.temperature));
        rate.piston_velocity = setting.damper.rate(state.piston_velocity, motion.velocity, factor);
        rate.mr = setting.damper.fluid_rates(&state.fluid, motion.velocity, setting.voltage);
        let power = self.with_memories(|memories| {
            let memory_rates = [&mut rate.memory_1, &mut rate.memory_2];
            for (at, rate) in memory_rates.into_iter().enumerate() {
                setting.friction.write_rate(setting.contacts()[at], &touches[at], memories[at], rate);
            }
            rate.mount = self.mount_rates(&motion, memories);
            self.power(&motion, &touches, memories)
        });
        rate.dissipated_energy = power;
        rate.temperature = setting.thermal.rate(self.temperature, setting.temperature_ambient, power);
    }
}

impl ShockAbsorber {
    fn start(&mut self) {
        if !self.has_started() {
            self.piston_velocity = self.damper_state().damper.piston_velocity;
            let mount = self.mount_state();
            self.remember_first();
            self.mount = mount;
            self.started = 1.0;
        }
    }

    /// Begins a step.
    fn begin(&mut self, dt: f64) {
        self.start();
        self.step_size = dt;
    }

    /// Advances the states while the inputs are held, without a mount.
    fn hold(&mut self, touches: &[Touch<f64>; 2], dt: f64) {
        let friction = self.slide(touches, dt);
        let count = if self.setting.has_own_dynamics() { super::substeps(dt, self.setting.num.h_max) } else { 1 };
        for _ in 0..count {
            self.pump(friction, dt / f64::from(count));
        }
    }

    /// A step in which the length moves with the velocity, and the velocity with the acceleration, unless the master
    /// gives other slopes.
    #[inline(never)]
    fn step_along_the_motion(&mut self, slope: Option<&Self>, dt: f64) {
        let mut slope = slope.copied().unwrap_or_else(|| ramp::held_inputs(self));
        slope.setting.follow_the_motion(&self.setting, dt);
        self.follow(&slope, dt);
    }

    /// Advances while the inputs change at the rates `slope`.
    #[inline(never)]
    fn follow(&mut self, slope: &Self, dt: f64) {
        if self.setting.has_mount() {
            return self.step_behind_mount(slope, dt);
        }
        let begin = ramp::Inputs::of(self);
        // A force that stops a mass belongs to the whole step.
        let stopping = self.setting.friction.moves_mass().then(|| {
            let before = self.setting;
            ramp::set_inputs(self, &begin, slope, dt);
            self.slide_from(&before, dt)
        });
        let count = super::substeps(dt, self.setting.num.h_max);
        let h = dt / f64::from(count);
        for piece in 0..count {
            ramp::set_inputs(self, &begin, slope, (f64::from(piece) + 0.5) * h);
            let friction = stopping.unwrap_or_else(|| self.slide(&self.setting.touches(&self.setting.motion()), h));
            self.pump(friction, h);
        }
        ramp::set_inputs(self, &begin, slope, dt);
    }

    /// Advances the friction at held inputs. Returns the power that it takes out of the motion.
    fn slide(&mut self, touches: &[Touch<f64>; 2], dt: f64) -> f64 {
        let setting = &self.setting;
        let [c_1, c_2] = setting.contacts();
        let energy = setting.friction.advance(c_1, &touches[0], &mut self.memory_1, dt).energy
            + setting.friction.advance(c_2, &touches[1], &mut self.memory_2, dt).energy;
        energy / dt
    }

    /// As [`ShockAbsorber::slide`], over a step in which the inputs have moved linearly to their present values.
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
        let mut state = DamperState { piston_velocity: self.piston_velocity, fluid: self.mr };
        let damper = setting.damper.advance(&mut state, velocity, setting.voltage, factor, dt);
        (self.piston_velocity, self.mr) = (state.piston_velocity, state.fluid);
        let power = friction + damper / dt;
        self.temperature = setting.thermal.after(self.temperature, setting.temperature_ambient, power, dt);
        self.dissipated_energy += friction * dt + damper;
    }
}

impl Model for ShockAbsorber {
    const EVENT_INDICATORS: usize = 2 * MOST_EVENTS + 1;
    const PRESETS: &'static [Preset] = presets::ALL;

    const HAS_IDLE: bool = true;

    fn idle(&self) -> [Range<usize>; 2] {
        // The start of a run writes all of the memories.
        let in_use = if self.has_started() { self.setting.friction.memory_in_use() } else { MEMORY };
        let first = [offset_of!(Self, memory_1), offset_of!(Self, memory_2)];
        first.map(|offset| offset / size_of::<f64>()).map(|first| first + in_use..first + MEMORY)
    }

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
        setting.mount.check()?;
        if setting.has_mount() {
            setting.friction.check_mounted(&setting.c1)?;
        }
        if setting.adapter.length_gain == 0.0 {
            return Err(Fault::new("adapter.length_gain = 0: must not be 0"));
        }
        Ok(())
    }

    fn warning(&self) -> Option<Fault> {
        let setting = &self.setting;
        let (length, distance) = (setting.length, setting.given_length());
        if distance == 0.0 {
            let extended = setting.geom.length_extended;
            return Some(Fault::new(format_args!(
                "length = {length}: gives a distance of the eyes of 0; until it is > 0, \
                 the strut is computed at full extension, geom.length_extended = {extended} m"
            )));
        }
        if distance < 0.0 {
            let text = format_args!("length = {length}: gives a distance of the eyes of {distance} m; it must be > 0");
            return Some(Fault::new(text));
        }
        setting.thermal.warning(setting.temperature_ambient).or_else(|| setting.friction.warning())
    }

    fn passivity(&self) -> Option<GivesBack> {
        let Setting { friction, c1, c2, thermal, damper, .. } = &self.setting;
        let damping = if thermal.enabled == 0.0 { damper.least_coefficient() } else { 0.0 };
        let contacts = [friction.passivity("c1.", c1), friction.passivity("c2.", c2)];
        let lacking = contacts.iter().flatten().map(|contact| contact.coefficient).sum::<f64>();
        let worst = contacts.into_iter().flatten().max_by(|a, b| a.coefficient.total_cmp(&b.coefficient));
        worst.filter(|_| lacking > damping).map(|contact| GivesBack::Said(contact.said))
    }

    fn check_motion(&self) -> Result<(), Fault> {
        let (setting, motion) = (&self.setting, self.motion());
        let is_displaced = setting.has_mount() && !motion.length.is_finite();
        let motion = if is_displaced { setting.motion() } else { motion };
        setting.gas.check_compression(setting.compression(&motion))?;
        setting.geom.guidance().check_overlap(motion.length)?;
        if is_displaced && setting.preload_displaces() { setting.mount.check_carried(&setting.gas) } else { Ok(()) }
    }

    fn check_model_exchange(&self) -> Result<(), Fault> {
        self.setting.friction.check_model_exchange(&self.setting.c1)
    }

    fn check_without_events(&self) -> Result<(), Fault> {
        self.setting.mount.check_without_events()?;
        self.setting.friction.check_without_events(&self.setting.c1)
    }

    fn rests(&self, column: usize) -> bool {
        let is_in = |offset: usize, width: usize| {
            let first = offset / size_of::<f64>();
            (first..first + width).contains(&column)
        };
        is_in(offset_of!(Self, mr), FluidState::<f64>::WIDTH) && !self.setting.damper.is_magnetorheological()
            || is_in(offset_of!(Self, mount), MountState::<f64>::WIDTH) && !self.setting.has_mount()
    }

    fn event_indicators(&self, indicators: &mut [f64]) {
        let touches = self.setting.touches(&self.motion());
        let (contacts, mount) = indicators.split_at_mut(2 * MOST_EVENTS);
        mount[0] = if self.setting.has_mount() { self.mount_state().indicator(&self.setting.mount) } else { 1.0 };
        self.with_memories(|memories| {
            for (at, indicators) in contacts.chunks_exact_mut(MOST_EVENTS).enumerate() {
                let levels = self.setting.contacts()[at];
                indicators.copy_from_slice(&self.setting.friction.indicators(levels, &touches[at], memories[at]));
            }
        });
    }

    fn at_event(&mut self) {
        self.start();
        if self.setting.has_mount() {
            self.mount.at_event(&self.setting.mount);
        }
        let touches = self.setting.touches(&self.motion());
        for (at, memory) in [&mut self.memory_1, &mut self.memory_2].into_iter().enumerate() {
            self.setting.friction.at_event(self.setting.contacts()[at], &touches[at], memory);
        }
    }

    #[inline(always)]
    fn moves_inputs(&self) -> bool {
        InputMode::of(self.setting.num.input_mode) == InputMode::Linear
    }

    fn step(&mut self, dt: f64) {
        self.begin(dt);
        if self.moves_inputs() {
            self.step_along_the_motion(None, dt);
        } else if self.setting.has_mount() {
            self.step_behind_mount(&ramp::held_inputs(self), dt);
        } else {
            self.hold(&self.setting.touches(&self.setting.motion()), dt);
        }
    }

    fn step_and_output(&mut self, dt: f64) {
        if self.moves_inputs() || self.setting.has_mount() {
            self.step(dt);
            return self.output();
        }
        self.begin(dt);
        // Held inputs are the same after the step.
        let motion = self.setting.motion();
        let touches = self.setting.touches(&motion);
        self.hold(&touches, dt);
        self.write_outputs(&motion, &touches);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        self.begin(dt);
        if self.moves_inputs() {
            self.step_along_the_motion(Some(slope), dt);
        } else {
            self.follow(slope, dt);
        }
    }
}
