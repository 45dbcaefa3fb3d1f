//! Advice to the master: tangents, and the largest step that they allow.

use crate::contact::ExchangeOrder;
use crate::number::Mask;
use crate::shock_absorber::ShockAbsorber;
use crate::shock_absorber::coupling::{self, Series};
use crate::shock_absorber::hydraulic_damper::DamperState;
use crate::shock_absorber::law::Evaluate;
use crate::shock_absorber::law_plan::MEMORY;
use crate::shock_absorber::memories::Memories;
use crate::shock_absorber::setting::{InputMode, Motion, OtherStates, Setting};

/// Half widths of the central differences (chosen): far smaller than the transition of any friction law, far larger
/// than rounding.
const PROBE_LENGTH: f64 = 1e-8;
const PROBE_VELOCITY: f64 = 1e-8;

/// Shortest step over which tangents are taken (chosen), to keep enough digits.
const SHORTEST_PROBE: f64 = 1e-6;

struct Tangents {
    length: f64,
    /// Without the damper.
    velocity: f64,
    held_velocity: f64,
    /// For the damper's force.
    held_damper: f64,
    /// Slope of the damper's resistance over the velocity of its piston.
    damper: f64,
}

impl<T: Evaluate> Setting<T> {
    /// Friction force along the axis at this instant.
    #[inline(never)]
    pub(super) fn friction_now(&self, motion: &Motion<T>, memory: Memories<T>) -> T {
        let touches = self.touches(motion);
        let force = |at: usize| {
            let answer = self.friction.force(self.contacts()[at], &touches[at], memory[at]);
            answer.force * touches[at].direction()[0]
        };
        force(0) + force(1)
    }
}

impl Setting {
    /// Friction force along the axis after a step of this motion; nothing is changed.
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

    /// Damper resistance at this instant and after a step at a held velocity.
    fn resistance_after(&self, motion: &Motion<f64>, state: &OtherStates<f64>, dt: f64) -> f64 {
        let mut state = *state;
        if dt > 0.0 {
            let factor = self.thermal.factor(state.temperature);
            self.damper.advance(&mut state.damper, motion.velocity, self.voltage, factor, dt);
        }
        self.resistance(self.piston(motion, &state), &state)
    }

    /// Derivatives of the force: with respect to the length at this instant; to the velocity at this instant; and to a
    /// velocity held over a step of `dt`, separately for the damper.
    #[inline(never)] // as the other parts of an output, so that the stack of each is freed before the next
    fn tangents(&self, here: Motion<f64>, memory: Memories<f64>, state: &OtherStates<f64>, dt: f64) -> Tangents {
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
            damper: self.slope_of_the_damper(self.piston(&here, state), state),
        }
    }

    /// Stiffness between the damper and what the strut moves, if there is one. A mount counts as stiff as it is in small
    /// and quick motions.
    fn stiffness_in_series(&self) -> Option<f64> {
        let (of_damper, of_mount) = (self.damper.k_series, self.mount.rubber.largest_stiffness());
        match (self.damper.has_series(), self.has_mount()) {
            (false, false) => None,
            (true, false) => Some(of_damper),
            (false, true) => Some(of_mount),
            (true, true) => Some(of_damper * of_mount / (of_damper + of_mount)),
        }
    }

    /// Slope of the damper's resistance at a velocity of the piston.
    fn slope_of_the_damper(&self, piston_velocity: f64, state: &OtherStates<f64>) -> f64 {
        let d_velocity = PROBE_VELOCITY.max(1e-6 * piston_velocity.abs());
        let at = |velocity: f64| self.resistance(velocity, state);
        (at(piston_velocity + d_velocity) - at(piston_velocity - d_velocity)) / (2.0 * d_velocity)
    }
}

impl<T: Evaluate> ShockAbsorber<T> {
    /// Stands for [`ShockAbsorber::advice`] where numbers have no values: numbers with the same dependencies.
    pub(super) fn sources_of_advice(&self, memories: Memories<T>) -> [T; 3] {
        let (setting, state) = (&self.setting, self.damper_state());
        let (motion, damper) = (self.motion(), &setting.damper);
        let [elastic, friction] = [setting.forces(&motion).sum(), setting.friction_now(&motion, memories)];
        let resistance = setting.resistance(setting.piston(&motion, &state), &state);
        let touches = setting.touches(&motion);
        let [after_1, after_2] = [0, 1].map(|at| {
            let mut memory = *memories[at];
            setting.friction.mark_step(setting.contacts()[at], &touches[at], &mut memory);
            memory
        });
        let duration = self.step_size.is_positive().choose(|| self.step_size, || setting.num.h_max);
        let in_series = damper.has_series().choose(|| damper.k_series + motion.velocity, || T::from(0.0));
        let fluid = damper.fluid_rates(&state.damper.fluid, motion.velocity, setting.voltage);
        let in_fluid = fluid.slip + fluid.hysteresis.z + fluid.hysteresis.filtered_voltage;
        let moved = resistance + in_series + in_fluid;
        let held = elastic + setting.friction_now(&motion, [&after_1, &after_2]) + moved + duration;
        let rubber = &setting.mount.rubber;
        let stiffest = || rubber.k_e + rubber.k_v + rubber.F_max + rubber.x_2;
        let in_mount = setting.has_mount().choose(stiffest, || T::from(0.0));
        let of_limit = setting.num.mass_ref + setting.num.input_mode + setting.friction.exchange + in_mount;
        [elastic + friction + resistance, held, held + friction + of_limit]
    }

    /// Tangents, by the length and by the velocity, and the largest step that they allow.
    #[inline(never)]
    pub(super) fn advice(&self, memories: Memories<T>) -> [f64; 3] {
        let setting = self.setting.values();
        let mut values = [[0.0; MEMORY]; 2];
        for (values, memory) in values.iter_mut().zip(memories) {
            values.iter_mut().zip(memory).for_each(|(value, number)| *value = number.value());
        }
        let OtherStates { damper: DamperState { piston_velocity, fluid }, temperature } = self.damper_state();
        let damper =
            DamperState { piston_velocity: piston_velocity.value(), fluid: fluid.map(&|number: T| number.value()) };
        let state = OtherStates { damper, temperature: temperature.value() };
        let dt =
            if self.step_size.value() > 0.0 { self.step_size.value().max(SHORTEST_PROBE) } else { setting.num.h_max };
        let Motion { length, velocity } = self.motion();
        let here = Motion { length: length.value(), velocity: velocity.value() };
        let tangents = setting.tangents(here, [&values[0], &values[1]], &state, dt);
        // The change of force due to a held velocity over a step comes from bristles and from a fluid that yields: a
        // stiffness.
        let elastic = if setting.damper.is_magnetorheological() {
            (-tangents.damper - tangents.held_damper).max(0.0)
        } else {
            0.0
        };
        let bristles = ((tangents.velocity - tangents.held_velocity).max(0.0) + elastic) / dt;
        let is_held = InputMode::of(setting.num.input_mode) == InputMode::Hold;
        let (stiffness, held) = if is_held { (-tangents.length, bristles) } else { (bristles - tangents.length, 0.0) };
        let exchange = ExchangeOrder::of(setting.friction.exchange);
        let mass = setting.num.mass_ref;
        let limit = if let Some(in_series) = setting.stiffness_in_series() {
            let series = Series { damping: tangents.damper, stiffness: in_series, is_late: is_held };
            coupling::step_limit_in_series(stiffness, held, -tangents.velocity, &series, mass, exchange)
        } else {
            coupling::step_limit(stiffness, held, tangents.velocity - tangents.damper, mass, exchange)
        };
        [tangents.length, tangents.held_velocity + tangents.held_damper, limit]
    }
}
