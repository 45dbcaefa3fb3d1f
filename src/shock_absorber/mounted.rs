//! A strut behind a top mount: its motion, and the steps in which it moves its rod.

use crate::component::RubberState;
use crate::model::ramp;
use crate::number::{Mask, Scalar};
use crate::numerics::root;
use crate::shock_absorber::ShockAbsorber;
use crate::shock_absorber::hydraulic_damper::DamperState;
use crate::shock_absorber::law::Evaluate;
use crate::shock_absorber::law_plan::MEMORY;
use crate::shock_absorber::memories::Memories;
use crate::shock_absorber::mount::{Mount, MountState};
use crate::shock_absorber::setting::{FrictionStart, Motion, Setting};

/// Force in N that counts as none in the balance of the rod (chosen).
const NO_FORCE: f64 = 1e-7;

/// Half width of a difference quotient of the stiffness (chosen).
const PROBE: f64 = 1e-7;

impl<T: Scalar> Setting<T> {
    pub(super) fn has_mount(&self) -> T::Mask {
        !self.mount.enabled.vanishes()
    }

    /// Motion of the strut between the eye of the tube and its rod.
    pub(super) fn motion_behind(&self, mount: &MountState<T>) -> Motion<T> {
        let Motion { length, velocity } = self.motion();
        let behind = || [length + mount.displacement, velocity + mount.velocity];
        let [length, velocity] = self.has_mount().choose_all(behind, || [length, velocity]);
        Motion { length, velocity }
    }

    /// Force that a mount at rest with this displacement carries too much, beside spring, gas and stops.
    fn excess(&self, displacement: T) -> T {
        let motion = Motion { length: self.motion().length + displacement, velocity: T::zero() };
        self.mount.preload + self.mount.rubber.k_e * displacement - self.forces(&motion).sum()
    }
}

impl<T: Evaluate> Setting<T> {
    /// Displacement of a mount that carries spring, gas and stops at rest.
    #[inline(never)]
    fn carrying_displacement(&self) -> T {
        if !T::HAS_VALUES {
            return self.excess(T::from(0.0)) + self.mount.rubber.k_e;
        }
        let plain = self.values();
        let excess = |displacement: f64| plain.excess(displacement);
        let found = root::rising(excess, 0.0, plain.mount.rubber.k_e, NO_FORCE);
        let stiffness = (excess(found + PROBE) - excess(found - PROBE)) / (2.0 * PROBE);
        // The last step of Newton's method carries the derivatives.
        T::from(found) - self.excess(T::from(found)) / T::from(stiffness)
    }

    /// Motion of a strut at the start of a run, before which its mount rested.
    pub(super) fn first_motion(&self) -> Motion<T> {
        let Motion { length, velocity } = self.motion();
        let length = self.has_mount().choose(|| length + self.carrying_displacement(), || length);
        Motion { length, velocity }
    }
}

impl Setting {
    /// Whether a mount that is to carry the strut at rest is displaced without end, and would not be without preload.
    pub(super) fn preload_displaces(&self) -> bool {
        let is_carried = |preload: f64| {
            let mount = Mount { preload, ..self.mount };
            Setting { mount, ..*self }.carrying_displacement().is_finite()
        };
        let is_given = FrictionStart::Value.is(self.init.friction_state);
        !is_given && !is_carried(self.mount.preload) && is_carried(0.0)
    }
}

impl<T: Evaluate> ShockAbsorber<T> {
    /// State of the mount; before the run, the initial one.
    pub(super) fn mount_state(&self) -> MountState<T> {
        let is_given = FrictionStart::Value.is(self.setting.init.friction_state);
        let settles = self.setting.has_mount() & !self.has_started() & !is_given;
        let settled = || [self.setting.carrying_displacement(), T::from(0.0)];
        let [displacement, velocity] = settles.choose_all(settled, || [self.mount.displacement, self.mount.velocity]);
        MountState { displacement, velocity, rubber: self.mount.rubber }
    }

    /// Motion of the strut between the eye of the tube and its rod.
    pub(super) fn motion(&self) -> Motion<T> {
        self.setting.motion_behind(&self.mount_state())
    }

    /// Force on the eye of the rod.
    pub(super) fn force_on_the_rod_eye(&self) -> T {
        let with_mount = || self.mount_state().force(&self.setting.mount);
        self.setting.has_mount().choose(with_mount, || self.force)
    }

    /// Time derivatives of the state of the mount.
    pub(super) fn mount_rates(&self, motion: &Motion<T>, memories: Memories<T>) -> MountState<T> {
        let setting = &self.setting;
        let mount = self.mount_state();
        let moved = || {
            let state = self.damper_state();
            let resistance = setting.resistance(setting.piston(motion, &state), &state);
            let push = setting.forces(motion).sum() - resistance - setting.friction_now(motion, memories);
            let rate = mount.rates(&setting.mount, push);
            [rate.displacement, rate.velocity, rate.rubber.friction_share, rate.rubber.damper_force]
        };
        let [displacement, velocity, friction_share, damper_force] =
            setting.has_mount().choose_all(moved, || [T::from(0.0); 4]);
        let rest = mount.map(&|_| T::from(0.0));
        MountState { displacement, velocity, rubber: RubberState { friction_share, damper_force, ..rest.rubber } }
    }
}

/// A strut after a piece of a step.
struct After {
    memories: [[f64; MEMORY]; 2],
    damper: DamperState<f64>,
    mount: MountState,
    /// Energies that friction and damper take out of the motion.
    friction: f64,
    damping: f64,
    /// Force that the mount and the inertia of the rod carry too much, beside the strut.
    excess: f64,
}

impl ShockAbsorber {
    /// Steps while the inputs change at the rates `slope`. The rod moves at a constant velocity in each internal step,
    /// at the end of which the forces on it are in balance: stable however stiff the mount and light the rod is.
    #[inline(never)]
    pub(super) fn step_behind_mount(&mut self, slope: &Self, dt: f64) {
        let begin = ramp::Inputs::of(self);
        let count = super::substeps(dt, self.setting.num.h_max);
        let h = dt / f64::from(count);
        for piece in 1..=count {
            ramp::set_inputs(self, &begin, slope, f64::from(piece) * h);
            self.move_rod(h);
        }
        ramp::set_inputs(self, &begin, slope, dt);
    }

    fn move_rod(&mut self, h: f64) {
        let least_slope = self.setting.mount.mass / h + self.setting.mount.rubber.k_e * h;
        let excess = |velocity: f64| self.after(velocity, h).excess;
        let velocity = root::rising(excess, self.mount.velocity, least_slope, NO_FORCE);
        let After { memories, damper, mount, friction, damping, .. } = self.after(velocity, h);
        [self.memory_1, self.memory_2] = memories;
        (self.piston_velocity, self.mr) = (damper.piston_velocity, damper.fluid);
        self.mount = mount;
        let (thermal, ambient) = (&self.setting.thermal, self.setting.temperature_ambient);
        self.temperature = thermal.after(self.temperature, ambient, (friction + damping) / h, h);
        self.dissipated_energy += friction + damping;
    }

    /// The strut after a piece of a step in which the rod moves at a velocity towards its eye.
    #[inline(never)]
    fn after(&self, velocity: f64, h: f64) -> After {
        let setting = &self.setting;
        let mount = self.mount.after(&setting.mount, velocity, h);
        let motion = setting.motion_behind(&mount);
        let touches = setting.touches(&motion);
        let mut memories = [self.memory_1, self.memory_2];
        let (mut resistance, mut friction) = (0.0, 0.0);
        for (at, memory) in memories.iter_mut().enumerate() {
            let answer = setting.friction.advance(setting.contacts()[at], &touches[at], memory, h);
            resistance += answer.force * touches[at].direction()[0];
            friction += answer.energy;
        }
        let mut state = self.damper_state();
        let factor = setting.thermal.factor(self.temperature);
        let damping = setting.damper.advance(&mut state.damper, motion.velocity, setting.voltage, factor, h);
        resistance += setting.resistance(setting.piston(&motion, &state), &state);
        let inertia = setting.mount.mass * (velocity - self.mount.velocity) / h;
        let excess = inertia + mount.force(&setting.mount) + resistance - setting.forces(&motion).sum();
        After { memories, damper: state.damper, mount, friction, damping, excess }
    }
}
