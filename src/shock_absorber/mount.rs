//! The top mount of a strut: rubber between the rod and its eye, with the mass that it carries.

use crate::component::{Rubber, RubberMount, RubberState};
use crate::model::{Brief, Derivatives, Fault, Law, Model, boolean, real};
use crate::number::Real;
use crate::shock_absorber::gas_spring::GasChamber;

crate::part! {
    /// Rubber mount between the rod and its eye.
    Mount {
        /// Is there a rubber mount between the rod and its eye?
        enabled: fixed = boolean(false),
        /// Mass of the rod with the inner part of the mount (default chosen).
        mass: fixed = real("kg", 0.3).positive(),
        /// Force that the mount carries where it is not displaced.
        preload: tunable = real("N", 0.0),
        /// Rubber.
        rubber: (Rubber),
    }
}

crate::part! {
    /// State of the mount of a strut.
    MountState {
        /// Displacement of the rod towards its eye, by which the strut is longer than the distance of the eyes.
        displacement: state = real("m", 0.0).nominal(1e-3).shown_in("mm"),
        /// Velocity of the rod towards its eye.
        velocity: state = real("m/s", 0.0).nominal(0.1),
        /// Rubber.
        rubber: (RubberState),
    }
}

impl<T: Real> MountState<T> {
    /// The component in this state.
    fn component(&self, mount: &Mount<T>) -> RubberMount<T> {
        RubberMount::of(mount.rubber, self.rubber, [self.displacement, self.velocity])
    }

    /// Force on the eye of the rod.
    pub(super) fn force(&self, mount: &Mount<T>) -> T {
        let mut component = self.component(mount);
        component.output();
        mount.preload + component.friction_force
    }

    /// Time derivatives, while the strut pushes the rod towards its eye.
    pub(super) fn rates(&self, mount: &Mount<T>, push: T) -> MountState<T> {
        let component = self.component(mount);
        let mut rate = component.map(&|_| T::zero());
        component.derivatives(&mut rate);
        MountState {
            displacement: self.velocity,
            velocity: (push - self.force(mount)) / mount.mass,
            rubber: rate.state,
        }
    }
}

impl MountState {
    /// The state after a time at a velocity.
    pub(super) fn after(&self, mount: &Mount, velocity: f64, dt: f64) -> MountState {
        let mut component = MountState { velocity, ..*self }.component(mount);
        component.step(dt);
        MountState { displacement: component.displacement, velocity, rubber: component.state }
    }

    /// Changes its sign where the rubber turns.
    pub(super) fn indicator(&self, mount: &Mount) -> f64 {
        let mut indicator = [1.0];
        self.component(mount).event_indicators(&mut indicator);
        indicator[0]
    }

    /// Lets the rubber turn.
    pub(super) fn at_event(&mut self, mount: &Mount) {
        let mut component = self.component(mount);
        component.at_event();
        self.rubber = component.state;
    }
}

impl Mount {
    /// Refuses rubber that carries nothing at rest.
    pub(super) fn check(&self) -> Result<(), Fault> {
        if self.enabled != 0.0 && self.rubber.k_e == 0.0 {
            return Err(Fault::new(
                "mount.k_e = 0: must be > 0 if mount.enabled is true: nothing else carries the strut",
            ));
        }
        Ok(())
    }

    /// Refuses a preload that displaces the rod until no gas volume is left.
    pub(super) fn check_carried(&self, gas: &GasChamber) -> Result<(), Fault> {
        if gas.enabled == 0.0 {
            return Ok(());
        }
        let [preload, most] = [self.preload, gas.largest_compression()].map(Brief);
        Err(Fault::new(format_args!(
            "mount.preload = {preload} N: must be a force that the strut carries with compression < {most} m, where the rod \
             fills the volume gas.V0"
        )))
    }

    /// Refuses rubber that turns at events.
    pub(super) fn check_without_events(&self) -> Result<(), Fault> {
        if self.enabled == 0.0 {
            return Ok(());
        }
        let named = |fault: Fault| Fault::new(format_args!("mount.enabled = true: {}", fault.0));
        RubberMount::default().check_without_events().map_err(named)
    }
}
