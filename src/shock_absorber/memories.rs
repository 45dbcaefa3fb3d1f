//! States of the two contacts of a strut, and their initial values.

use crate::model::{Columns, Kind, row_of, row_of_mut};
use crate::number::Decision;
use crate::shock_absorber::ShockAbsorber;
use crate::shock_absorber::law::Evaluate;
use crate::shock_absorber::law_plan::MEMORY;
use crate::shock_absorber::setting::{FrictionStart, Setting};

/// States of the two contacts. By reference: a memory is long, and copies of it fill the stack.
pub(super) type Memories<'a, T> = [&'a [T; MEMORY]; 2];

/// Half width of the difference quotient of the settled friction, relative to the sizes of the numbers that vary, and
/// the smallest size used, in SI units (both chosen).
const PROBE_SETTING: f64 = 1e-6;
const SMALL: f64 = 1e-3;

/// Which columns of a setting are real numbers.
static ARE_REAL: [bool; Setting::TABLE.len()] = {
    let (mut are_real, mut column) = ([false; Setting::TABLE.len()], 0);
    while column < are_real.len() {
        are_real[column] = matches!(Setting::TABLE[column].kind, Kind::Real(_));
        column += 1;
    }
    are_real
};

impl Setting {
    /// States of a contact after a while at this motion.
    #[inline(never)]
    fn settled(&self, at: usize) -> [f64; MEMORY] {
        self.friction.settled(self.contacts()[at], &self.touches(&self.first_motion())[at])
    }

    /// The same for a setting moved along its slopes.
    #[inline(never)]
    fn settled_beside(&self, slopes: &Setting, distance: f64, at: usize) -> [f64; MEMORY] {
        let mut setting = *self;
        for (value, slope) in row_of_mut(&mut setting).iter_mut().zip(row_of(slopes)) {
            *value += distance * slope;
        }
        setting.settled(at)
    }

    /// Keeps only the slopes of real numbers. Returns the largest one, relative to the sizes of the numbers.
    fn keep_those_of_reals(&mut self, setting: &Setting) -> f64 {
        let mut fastest = 0f64;
        for ((slope, value), is_real) in row_of_mut(self).iter_mut().zip(row_of(setting)).zip(&ARE_REAL) {
            if !is_real {
                *slope = 0.0;
            }
            fastest = fastest.max(slope.abs() / value.abs().max(SMALL));
        }
        fastest
    }
}

impl<T: Evaluate> ShockAbsorber<T> {
    /// Works on the states of the two contacts; before the run, on their initial states.
    pub(super) fn with_memories<R>(&self, work: impl FnOnce(Memories<T>) -> R) -> R {
        if self.has_started().holds() { work([&self.memory_1, &self.memory_2]) } else { self.with_first_memories(work) }
    }

    #[inline(never)] // so that only callers that need them have them on their stack
    fn with_first_memories<R>(&self, work: impl FnOnce(Memories<T>) -> R) -> R {
        match FrictionStart::of(self.setting.init.friction_state.value()) {
            FrictionStart::Steady => {
                let mut memories = [[T::from(0.0); MEMORY]; 2];
                if T::HAS_VALUES {
                    self.settle(&mut memories);
                } else {
                    self.mark_settled(&mut memories);
                }
                work([&memories[0], &memories[1]])
            }
            FrictionStart::Zero => {
                let mut memory = [T::from(0.0); MEMORY];
                self.setting.friction.write_fresh(&mut memory);
                work([&memory; 2])
            }
            FrictionStart::Value => work([&self.memory_1, &self.memory_2]),
        }
    }

    /// Stands for [`ShockAbsorber::settle`] where numbers have no values: each state becomes a number with the same
    /// dependencies.
    #[inline(never)]
    fn mark_settled(&self, memories: &mut [[T; MEMORY]; 2]) {
        let setting = &self.setting;
        let touches = setting.touches(&self.motion());
        for (at, memory) in memories.iter_mut().enumerate() {
            setting.friction.mark_settled(setting.contacts()[at], &touches[at], memory);
        }
    }

    /// Finds the states of the two contacts after a second of motion. Their derivative is a central difference along
    /// the direction of the setting's slopes.
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
        // A number with several slopes has no single one: it must be refused, not taken for a constant.
        if row_of(&slopes).iter().any(|slope| slope.is_nan()) {
            memories.as_flattened_mut().iter_mut().for_each(|number| *number = T::with_slope(number.value(), f64::NAN));
            return;
        }
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
}

impl ShockAbsorber {
    /// Sets the initial states. Not inlined, so that the large stack of a start is freed before the step.
    #[inline(never)]
    pub(super) fn remember_first(&mut self) {
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
}
