//! Everything on which the forces of a strut depend, except its states, and the quantities derived from it at an
//! instant.

use crate::model::{Meaning, real};
use crate::number::{Mask, Scalar};
use crate::shock_absorber::coil_spring::Coil;
use crate::shock_absorber::damper_temperature::Heating;
use crate::shock_absorber::end_stops::{BumpStop, ReboundStop};
use crate::shock_absorber::gas_spring::GasChamber;
use crate::shock_absorber::geometry::Geometry;
use crate::shock_absorber::guide_contact::{FrictionLaw, Levels, Touch};
use crate::shock_absorber::hydraulic_damper::{DamperState, Hydraulics};
use crate::shock_absorber::law::Evaluate;
use crate::shock_absorber::mount::Mount;
use crate::shock_absorber::telescopic_joint::{NormalSum, SideConvention, SideLoad, Wrench};

crate::choices! {
    /// Side loads that act on the joint.
    pub enum SideMode {
        /// The four inputs.
        Inputs,
        /// Loads from the spring: offset of its line of action and side force.
        Internal,
        /// Both.
        Sum,
    }
}

crate::choices! {
    /// Motion of the inputs within a step.
    pub enum InputMode {
        /// They are held.
        Hold,
        /// The length moves with the velocity, the velocity with the acceleration.
        Linear,
    }
}

crate::part! {
    /// Sources and treatment of the side load.
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
        /// Rule for the loads of the contacts from the load of the joint.
        normal_sum: fixed = NormalSum::TwoPoint.start(),
        /// Factor on the contact forces for the distribution of pressure; 4 / pi for a cosine over half the rim.
        c_geo: tunable = real("1", 1.0).at_least(0.0),
    }
}

crate::part! {
    /// Conversion from the travel of the host to the length of the strut.
    Adapter {
        /// Length of the strut when the input length is 0.
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
        /// Motion of the inputs within a step.
        input_mode: fixed = InputMode::Hold.start(),
        /// Mass that the strut carries or moves, whichever is smaller; for the advice step_limit only.
        mass_ref: tunable = real("kg", 16.4).positive(),
    }
}

crate::choices! {
    /// Initial state of the friction law.
    pub enum FrictionStart {
        /// State after one second at the initial velocity: steady sliding, or rest.
        Steady,
        /// Contacts at rest, without load.
        Zero,
        /// Start values of memory_1 and memory_2.
        Value,
    }
}

crate::part! {
    /// State at the start.
    Start {
        /// Initial state of the friction law.
        friction_state: fixed = FrictionStart::Steady.start(),
    }
}

crate::part! {
    /// Everything on which the forces of a strut depend, except its states.
    Setting {
        /// Distance of the eyes, or travel of the host: see adapter.
        length: input = real("m", 0.1775).shown_in("mm").means(Meaning::StrutLength),
        /// Time derivative of the length; positive in extension.
        velocity: input = real("m/s", 0.0).means(Meaning::Velocity),
        /// Load across the axis.
        load: (SideLoad),
        /// Spin of the rod relative to the tube, about the axis from tube to rod.
        spin_rate: input = real("rad/s", 0.0),
        /// All other forces along the strut, positive in extension; only for laws that hold a load at rest.
        external_force: input = real("N", 0.0).means(Meaning::ExternalForce),
        /// Time derivative of the velocity; for num.input_mode = Linear and for laws that use it.
        acceleration: input = real("m/s2", 0.0).means(Meaning::Acceleration),
        /// Ambient temperature; used if thermal.enabled is true.
        temperature_ambient: input = real("K", 293.15).at_least(0.0).nominal(300.0).shown_in("degC"),
        /// Voltage at the current driver of the damper's coil; used by damper.mode = MagnetorheologicalDamper.
        voltage: input = real("V", 0.0).at_least(0.0),
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
        /// Rubber mount.
        mount: Mount,
        /// Travel of the host.
        adapter: Adapter,
        /// Numerical settings.
        num: Numerics,
        /// State at the start.
        init: Start,
    }
}

/// States of damper and temperature.
#[derive(Clone, Copy)]
pub(super) struct OtherStates<T: Copy> {
    pub(super) damper: DamperState<T>,
    pub(super) temperature: T,
}

/// Motion of the strut, after the adapter.
#[derive(Clone, Copy)]
pub(super) struct Motion<T> {
    pub(super) length: T,
    pub(super) velocity: T,
}

/// Axial forces without friction; positive pushes the eyes apart.
pub(super) struct Forces<T> {
    pub(super) spring: T,
    pub(super) gas: T,
    pub(super) bump: T,
    pub(super) rebound: T,
}

impl<T: Scalar> Forces<T> {
    pub(super) fn sum(&self) -> T {
        self.spring + self.gas + self.bump + self.rebound
    }
}

impl<T: Evaluate> Setting<T> {
    /// The same in plain numbers. Not inline, as the other parts of an output: the stack of each is freed before the
    /// next.
    #[inline(never)]
    pub(super) fn values(&self) -> Setting {
        self.map(&|number: T| number.value())
    }

    /// Slopes of its numbers.
    #[inline(never)]
    pub(super) fn slopes(&self) -> Setting {
        self.map(&|number: T| number.slope())
    }
}

impl<T: Scalar> Setting<T> {
    pub(super) fn motion(&self) -> Motion<T> {
        let given = self.given_length();
        // A distance of 0 is an input that is not set yet; the model warns of it.
        let length = given.vanishes().choose(|| self.geom.length_extended + given, || given);
        Motion { length, velocity: self.adapter.length_gain * self.velocity }
    }

    /// Length of the strut according to the input.
    pub(super) fn given_length(&self) -> T {
        self.adapter.length_offset + self.adapter.length_gain * self.length
    }

    pub(super) fn compression(&self, motion: &Motion<T>) -> T {
        self.geom.length_extended - motion.length
    }

    pub(super) fn forces(&self, motion: &Motion<T>) -> Forces<T> {
        let compression = self.compression(motion);
        Forces {
            spring: self.spring.force(compression),
            gas: self.gas.force(compression),
            bump: self.bump.force(compression, motion.velocity),
            rebound: self.rebound.force(compression, motion.velocity),
        }
    }

    /// Load of the joint: the inputs plus the loads from the spring.
    pub(super) fn wrench(&self, spring_force: T) -> Wrench<T> {
        let mode = self.side.mode;
        let inputs = || {
            let Wrench { force: [m, n], moment: [about_m, about_n] } = self.load.wrench(self.side.convention);
            [m, n, about_m, about_n]
        };
        let [m, n, about_m, about_n] = SideMode::Internal.is(mode).choose_all(|| [T::zero(); 4], inputs);
        let with_spring = || {
            let Side { force_ratio, offset_m, offset_n, .. } = self.side;
            [m + force_ratio * spring_force, about_m - offset_n * spring_force, about_n + offset_m * spring_force]
        };
        let [m, about_m, about_n] = SideMode::Inputs.is(mode).choose_all(|| [m, about_m, about_n], with_spring);
        Wrench { force: [m, n], moment: [about_m, about_n] }
    }

    /// Normal forces at rod guide and piston.
    pub(super) fn normal_forces(&self, motion: &Motion<T>) -> [T; 2] {
        let wrench = self.wrench(self.spring.force(self.compression(motion)));
        let normal = self.geom.guidance().normal_forces(&wrench, motion.length, self.side.normal_sum);
        normal.map(|normal| self.side.c_geo * normal)
    }

    pub(super) fn contacts(&self) -> [&Levels<T>; 2] {
        [&self.c1, &self.c2]
    }

    pub(super) fn radii(&self) -> [T; 2] {
        [self.geom.r_1, self.geom.r_2]
    }

    /// Motion and load of the two contacts. Mass and external force are divided in proportion to their static levels.
    pub(super) fn touches(&self, motion: &Motion<T>) -> [Touch<T>; 2] {
        let normal = self.normal_forces(motion);
        let levels = self.contacts();
        let holds = [0, 1].map(|at| self.friction.levels(levels[at], normal[at])[1]);
        let total = holds[0] + holds[1];
        [0, 1].map(|at| {
            let share = total.is_positive().choose(|| holds[at] / total, || T::from(0.5));
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
    pub(super) fn piston(&self, motion: &Motion<T>, state: &OtherStates<T>) -> T {
        self.damper.piston(motion.velocity, &state.damper)
    }

    /// Resistance of the damper to a velocity of its piston.
    pub(super) fn resistance(&self, piston: T, state: &OtherStates<T>) -> T {
        self.thermal.factor(state.temperature) * self.damper.resistance(piston, &state.damper)
    }
}

impl Setting {
    /// Whether the piston or the temperature changes while the inputs are held.
    pub(super) fn has_own_dynamics(&self) -> bool {
        self.damper.has_series() || self.thermal.enabled != 0.0
    }

    /// Sets the slopes of length and velocity from their derivatives if the master gives none: that of the length from
    /// the mean velocity of the step.
    pub(super) fn follow_the_motion(&mut self, now: &Setting, dt: f64) {
        if self.velocity == 0.0 {
            self.velocity = now.acceleration;
        }
        if self.length == 0.0 {
            self.length = now.velocity + 0.5 * self.velocity * dt;
        }
    }
}
