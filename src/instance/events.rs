//! Events within a step: where results that jump change, or event indicators their sign.

use super::{Instance, exchange};
use crate::memory::{self, OutOfMemory};
use crate::model::{Computed, ModelType};

/// Parts of a step after which events are looked for (chosen): one that is undone within a part is not seen.
const PARTS: u32 = 8;

/// Part of a step after which the first event may come (chosen). What the inputs have changed before the step is no
/// event of the step.
const BEGINNING: f64 = f64::EPSILON * 4_194_304.0;

/// Halvings of a part that locate an event, more than an f64 has bits (chosen).
const HALVINGS: u32 = 64;

/// A trial of a step, beside the instance: its row and memory, and what events change in them.
pub struct Trial {
    row: Box<[f64]>,
    memory: Box<[f64]>,
    room: Box<[f64]>,
    /// Results that jump.
    jumping: Box<[usize]>,
    indicators: Box<[f64]>,
    /// Those results, and the signs of the indicators, at the beginning of the step and now.
    before: Box<[f64]>,
    now: Box<[f64]>,
    time: f64,
    computed: Computed,
}

impl Trial {
    /// For an instance of this model, if there is memory for it.
    pub fn of(model: &ModelType) -> Result<Trial, OutOfMemory> {
        let jumping = exchange::columns_of(model, |variable| variable.role.is_computed() && variable.jumps)?;
        let marks = jumping.len() + model.event_indicators;
        Ok(Trial {
            row: memory::filled(0.0, model.table.len())?,
            memory: memory::filled(0.0, model.memory)?,
            room: memory::filled(0.0, model.table.len() + model.memory)?,
            jumping,
            indicators: memory::filled(0.0, model.event_indicators)?,
            before: memory::filled(0.0, marks)?,
            now: memory::filled(0.0, marks)?,
            time: 0.0,
            computed: Computed::Nothing,
        })
    }

    /// Makes a step of `dt` from the present state of an instance. False if a result is not finite.
    fn advance(&mut self, instance: &Instance, dt: f64) -> bool {
        self.row.copy_from_slice(&instance.row);
        self.memory.copy_from_slice(&instance.memory);
        (instance.model.try_advance)(&mut self.row, &mut self.memory, &mut self.room, dt)
    }

    /// Whether a step of `dt` has an event, compared with its beginning; None if a result is not finite.
    fn has_event(&mut self, instance: &Instance, dt: f64) -> Option<bool> {
        self.mark(instance, dt)?;
        Some(self.now.iter().zip(&self.before).any(|(now, before)| now.to_bits() != before.to_bits()))
    }

    /// Notes what events change after a step of `dt`.
    fn mark(&mut self, instance: &Instance, dt: f64) -> Option<()> {
        if !self.advance(instance, dt) {
            return None;
        }
        instance.model.indicate(&self.row, &mut self.indicators);
        let jumping = self.jumping.iter().map(|column| self.row[*column]);
        let signs = self.indicators.iter().map(|indicator| f64::from(u8::from(*indicator > 0.0)));
        for (mark, value) in self.now.iter_mut().zip(jumping.chain(signs)) {
            *mark = value;
        }
        Some(())
    }
}

impl Instance {
    /// The first event within a step of `dt` with held inputs: the part of the step after which a result that jumps has
    /// another value than at the beginning of the step, or an event indicator another sign. It is located to the last
    /// bits of `dt`. None without an event, and for a step that fails. An event that is undone within an eighth of the
    /// step may be missed.
    pub fn first_event(&self, trial: &mut Trial, dt: f64) -> Option<f64> {
        trial.mark(self, BEGINNING * dt)?;
        trial.before.copy_from_slice(&trial.now);
        let end = |part: u32| dt * (f64::from(part) / f64::from(PARTS));
        for part in 1..=PARTS {
            if trial.has_event(self, end(part))? {
                let begin = if part == 1 { BEGINNING * dt } else { end(part - 1) };
                return self.locate(trial, begin, end(part));
            }
        }
        None
    }

    /// Whether the end of a step of `dt` differs from its beginning as by an event.
    pub fn ends_changed(&self, trial: &mut Trial, dt: f64) -> bool {
        let changed = trial.mark(self, BEGINNING * dt).and_then(|()| {
            trial.before.copy_from_slice(&trial.now);
            trial.has_event(self, dt)
        });
        changed == Some(true)
    }

    /// The first of the times up to `after` from which on the step has an event, which it has not up to `before`.
    fn locate(&self, trial: &mut Trial, mut before: f64, mut after: f64) -> Option<f64> {
        for _ in 0..HALVINGS {
            let middle = 0.5 * (before + after);
            if middle <= before || middle >= after {
                break;
            }
            if trial.has_event(self, middle)? {
                after = middle;
            } else {
                before = middle;
            }
        }
        Some(after)
    }

    /// Shows the state after a step of `dt` until [`Instance::show_present`], for results within a step. False, with
    /// nothing changed, if a result is not finite.
    pub fn show_future(&mut self, trial: &mut Trial, dt: f64) -> bool {
        if !trial.advance(self, dt) {
            return false;
        }
        (trial.time, trial.computed) = (self.time, self.computed);
        self.swap(trial);
        self.time += dt;
        self.computed = Computed::Main;
        true
    }

    /// Shows the present state again.
    pub fn show_present(&mut self, trial: &mut Trial) {
        self.swap(trial);
        (self.time, self.computed) = (trial.time, trial.computed);
    }

    fn swap(&mut self, trial: &mut Trial) {
        std::mem::swap(&mut self.row, &mut trial.row);
        std::mem::swap(&mut self.memory, &mut trial.memory);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue;

    fn instance(name: &str, values: &[(&str, f64)]) -> (Instance, Trial) {
        let mut instance = Instance::new(catalogue::by_name(name).expect("a model"));
        for (name, value) in values {
            instance.set_by_name(name, *value).expect(name);
        }
        let trial = Trial::of(instance.model()).expect("memory");
        (instance, trial)
    }

    /// A body of 1 kg under 0.4 N, slowed down by 0.981 N: v m / (f_C - f_e).
    #[test]
    fn a_body_comes_to_rest_where_its_momentum_is_used_up() {
        let values =
            [("velocity", 0.006), ("external_force", 0.4), ("normal_force", 9.81), ("mass", 1.0), ("mu_k", 0.1)];
        let (law, mut trial) = instance("Coulomb", &values);
        let before = law.save();
        let found = law.first_event(&mut trial, 0.05).expect("it comes to rest");
        assert!((found - 0.006 / 0.581).abs() < 1e-15, "{found}");
        assert_eq!(law.first_event(&mut trial, 0.01), None, "not yet");
        assert!(law.ends_changed(&mut trial, 0.05) && !law.ends_changed(&mut trial, 0.01));
        assert_eq!(law.save(), before, "a trial changes nothing");
    }

    #[test]
    fn a_shown_future_is_that_of_the_step_and_is_taken_back() {
        let (mut law, mut trial) = instance("LuGre", &[("velocity", 1e-3), ("normal_force", 10.0)]);
        let before = law.save();
        assert!(law.show_future(&mut trial, 2e-3));
        let shown = law.get_by_name("friction_force").expect("a force");
        assert_eq!(law.time(), 2e-3);
        law.show_present(&mut trial);
        assert_eq!(law.save(), before);
        law.step(2e-3).expect("a step");
        assert_eq!(law.get_by_name("friction_force").expect("a force").to_bits(), shown.to_bits());
    }
}
