//! The magnetorheological damper of a strut: the component, without the accumulator, for which a strut has spring and
//! gas.

use crate::component::{MagnetorheologicalDamper, MagnetorheologicalFluid, MagnetorheologicalState};
use crate::model::{Derivatives, Law, Model, ramp, real};
use crate::number::Real;

crate::part! {
    /// State of a magnetorheological damper in a strut.
    FluidState {
        /// Displacement of the damper less that of its dashpot in series.
        slip: state = real("m", 0.0).nominal(1e-2).shown_in("mm"),
        /// Hysteresis and voltage.
        hysteresis: (MagnetorheologicalState),
    }
}

impl<T: Real> FluidState<T> {
    /// The component in this state. It counts its displacement from that of its dashpot in series.
    fn damper(&self, fluid: &MagnetorheologicalFluid<T>, velocity: T, voltage: T) -> MagnetorheologicalDamper<T> {
        let damper = MagnetorheologicalDamper::without_accumulator(*fluid, self.hysteresis, self.slip);
        MagnetorheologicalDamper { velocity, voltage, ..damper }
    }

    /// Resistance to a velocity.
    pub(super) fn resistance(&self, fluid: &MagnetorheologicalFluid<T>, velocity: T) -> T {
        let mut damper = self.damper(fluid, velocity, T::zero());
        damper.output();
        damper.friction_force
    }

    /// Time derivatives of the state.
    pub(super) fn rates(&self, fluid: &MagnetorheologicalFluid<T>, velocity: T, voltage: T) -> FluidState<T> {
        let damper = self.damper(fluid, velocity, voltage);
        let mut rate = damper;
        damper.derivatives(&mut rate);
        FluidState { slip: rate.displacement - rate.y, hysteresis: rate.state }
    }
}

impl FluidState {
    /// Advances while velocity and voltage start at these values and move at these rates. Returns the energy taken out of
    /// the motion.
    pub(super) fn advance(
        &mut self,
        fluid: &MagnetorheologicalFluid,
        [velocity, voltage]: [f64; 2],
        [acceleration, voltage_rate]: [f64; 2],
        dt: f64,
    ) -> f64 {
        let mut damper = self.damper(fluid, velocity, voltage);
        if acceleration == 0.0 && voltage_rate == 0.0 {
            damper.step(dt);
        } else {
            let slope = MagnetorheologicalDamper {
                velocity: acceleration,
                voltage: voltage_rate,
                ..ramp::held_inputs(&damper)
            };
            damper.step_ramp(&slope, dt);
        }
        *self = FluidState { slip: damper.displacement - damper.y, hysteresis: damper.state };
        damper.dissipated_energy
    }
}
