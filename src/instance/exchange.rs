//! Model Exchange: the part of an instance whose states an importer integrates, and what it offers for that.

use super::Instance;
use crate::memory::{self, OutOfMemory};
use crate::model::{Computed, Fault, ModelType, Variable};

/// Results that jump, and what an event may change.
///
/// An importer that integrates sees results that jump as they were at the last event.
pub(super) struct Exchange {
    /// The continuous states before an event.
    before: Box<[f64]>,
    /// Columns of the results that jump.
    jumping: Box<[usize]>,
    /// Their present values between events; the row has those of the last event.
    latest: Box<[f64]>,
    instant: Instant,
}

/// Where an importer stands.
#[derive(Clone, Copy, PartialEq)]
enum Instant {
    /// At an event: the row has the present values.
    Event,
    /// Between events; whether `latest` belongs to the other columns.
    Between { latest_is_known: bool },
}

impl Exchange {
    pub fn of(model: &ModelType) -> Result<Exchange, OutOfMemory> {
        let jumping = columns_of(model, |variable| variable.role.is_computed() && variable.jumps)?;
        Ok(Exchange {
            before: memory::filled(0.0, model.continuous_states().count())?,
            latest: memory::filled(0.0, jumping.len())?,
            jumping,
            instant: Instant::Event,
        })
    }

    pub fn is_between_events(&self) -> bool {
        self.instant != Instant::Event
    }

    pub fn begin_event(&mut self) {
        self.instant = Instant::Event;
    }

    fn end_event(&mut self) {
        self.instant = Instant::Between { latest_is_known: false };
    }
}

impl Instance {
    /// Columns of the states that an importer may integrate, in the order of the table unless
    /// [`Instance::order_continuous_states`] has changed it; none if the model is for co-simulation only.
    pub fn continuous_states(&self) -> &[usize] {
        &self.continuous
    }

    /// Brings the states into another order, that of an importer.
    pub fn order_continuous_states<K: Ord>(&mut self, key: impl Fn(usize) -> K) {
        self.continuous.sort_unstable_by_key(|column| key(*column));
    }

    /// Sets the states, whatever their bounds: a solver may try values beyond them on its way to a result. All, or none
    /// if one is not finite.
    pub fn set_continuous_states(&mut self, values: &[f64]) -> Result<(), Fault> {
        if let Some(at) = values.iter().position(|value| !value.is_finite()) {
            return Err(Fault::new(format_args!("x[{at}] = {}: must be finite", values[at])));
        }
        for (column, value) in self.continuous.iter().zip(values) {
            self.row[*column] = *value;
        }
        self.computed = Computed::Nothing;
        Ok(())
    }

    /// Time derivatives of the states, in the columns of the states.
    pub fn rates(&mut self) -> Result<&[f64], Fault> {
        self.find_rates();
        if self.continuous.iter().all(|column| self.rate[*column].is_finite()) {
            Ok(&self.rate)
        } else {
            Err(self.not_finite(format_args!("the derivatives")))
        }
    }

    /// As [`Instance::rates`] has found them last.
    pub fn latest_rates(&self) -> &[f64] {
        &self.rate
    }

    /// Writes the event indicators.
    pub fn indicate(&self, indicators: &mut [f64]) -> Result<(), Fault> {
        self.model.indicate(&self.row, indicators);
        if indicators.iter().all(|indicator| indicator.is_finite()) {
            Ok(())
        } else {
            Err(self.not_finite(format_args!("the event indicators")))
        }
    }

    /// Changes whatever changes at events only. True if that includes a continuous state.
    pub fn at_event(&mut self) -> Result<bool, Fault> {
        let Some(exchange) = &mut self.exchange else { return Err(only_steps()) };
        for (before, column) in exchange.before.iter_mut().zip(&self.continuous) {
            *before = self.row[*column];
        }
        if !(self.model.try_at_event)(&mut self.row, &mut self.memory, &mut self.room) {
            return Err(self.not_finite(format_args!("the states after an event")));
        }
        self.computed = Computed::Nothing;
        let mut states = self.continuous.iter().zip(&exchange.before);
        Ok(states.any(|(column, before)| self.row[*column] != *before))
    }

    /// Sets all results to their present values.
    pub fn enter_event(&mut self) {
        if let Some(exchange) = &mut self.exchange {
            exchange.begin_event();
        }
        self.computed = Computed::Nothing;
    }

    /// From here to the next event the results that jump keep their values.
    pub fn leave_event(&mut self) -> Result<(), Fault> {
        self.refresh_to(Computed::Main)?;
        self.continue_between_events();
        Ok(())
    }

    /// As [`Instance::leave_event`], for a state that was saved after it.
    pub fn continue_between_events(&mut self) {
        if let Some(exchange) = &mut self.exchange {
            exchange.end_event();
        }
    }

    /// Whether an event would change results.
    pub fn wants_event(&mut self) -> Result<bool, Fault> {
        let is_known = match &self.exchange {
            Some(exchange) => match exchange.instant {
                Instant::Event => return Ok(false),
                Instant::Between { latest_is_known } => latest_is_known,
            },
            None => return Ok(false),
        };
        if self.computed == Computed::Nothing || !is_known {
            self.refresh_between_events()?;
        }
        let mut jumps = self.exchange.iter().flat_map(|exchange| exchange.jumping.iter().zip(&exchange.latest));
        Ok(jumps.any(|(column, value)| self.row[*column] != *value))
    }

    /// Results that jump keep their values.
    pub(super) fn refresh_between_events(&mut self) -> Result<(), Fault> {
        if let Some(exchange) = &mut self.exchange {
            exchange.end_event();
            for (value, column) in exchange.latest.iter_mut().zip(&exchange.jumping) {
                *value = self.row[*column];
            }
        }
        self.compute_outputs()?;
        if let Some(exchange) = &mut self.exchange {
            exchange.instant = Instant::Between { latest_is_known: true };
            for (value, column) in exchange.latest.iter_mut().zip(&exchange.jumping) {
                std::mem::swap(value, &mut self.row[*column]);
            }
        }
        Ok(())
    }
}

#[cold]
fn only_steps() -> Fault {
    Fault::new(format_args!("the instance was made for steps, which have no events"))
}

/// The columns of these variables.
pub(super) fn columns_of(
    model: &ModelType,
    is_wanted: impl Fn(&Variable) -> bool,
) -> Result<Box<[usize]>, OutOfMemory> {
    memory::collected((0..model.table.len()).filter(|column| is_wanted(&model.table.at(*column))))
}
