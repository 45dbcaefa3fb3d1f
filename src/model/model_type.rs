//! The record of a model, without its type.

use std::ffi::CStr;
use std::fmt;

use super::row::{Room, commit, view, view_mut};
use super::{Bonds, GivesBack, Interface, Kernels, Law, Model, Past, Preset, is_for_exchange};
use crate::guid::{self, GuidText};
use crate::number::Dual;
use crate::reference::{self, Place, Reference, References};
use crate::table::{Fault, Meaning, Ports, Role, Table, Variable};

/// Arguments: row, memory, workspace for a copy, slopes and time.
type AdvanceRamp = fn(&mut [f64], &mut [f64], Room, &[f64], f64) -> bool;

/// Arguments: row, memory, and the rates of row and memory.
type Rate = fn(&[f64], &[f64], &mut [f64], &mut [f64]);

/// Everything the library knows about a model, in one record of plain data and functions.
pub struct ModelType {
    /// Name, also FMI's modelIdentifier.
    pub name: &'static str,
    /// The name, for C.
    pub c_name: &'static CStr,
    /// One-line description.
    pub summary: &'static str,
    /// Its columns.
    pub table: Table,
    /// The facts about the columns that get and set need on every step.
    pub ports: Ports,
    references: References,
    /// Its named parameter sets.
    pub presets: &'static [Preset],
    /// Whether it supports Model Exchange.
    pub model_exchange: bool,
    /// Whether a solver that keeps its [past](ModelType::past), and follows its [bonds](ModelType::bonds), finds the rates
    /// of all its states.
    pub has_rates: bool,
    /// Number of its event indicators.
    pub event_indicators: usize,
    /// Number of values that an instance keeps beside the row: [`Model::MEMORY`].
    pub memory: usize,
    /// Its functions over several rows at once, if it runs in lanes.
    pub(crate) kernels: Option<Kernels>,
    guid: GuidText,
    check: fn(&[f64]) -> Result<(), Fault>,
    /// Names the limit of an input for which a result is not finite.
    pub(crate) check_motion: fn(&[f64]) -> Result<(), Fault>,
    /// Names the limit of a step whose result is not finite.
    pub(crate) check_step: fn(&[f64], f64) -> Result<(), Fault>,
    warning: fn(&[f64]) -> Option<Fault>,
    passivity: fn(&[f64]) -> Option<GivesBack>,
    memory_in_use: fn(&[f64]) -> usize,
    /// As [`ModelType::advance`], without advice; row and memory are as they were if a result is not finite, or if the
    /// model panics. So with the four below.
    pub(crate) try_advance: fn(&mut [f64], &mut [f64], Room, f64) -> bool,
    pub(crate) try_advance_ramp: AdvanceRamp,
    pub(crate) try_output: fn(&mut [f64], &mut [f64], Room) -> bool,
    /// [`Law::slide_steadily`], and the outputs after it.
    pub(crate) try_slide_steadily: fn(&mut [f64], &mut [f64], Room) -> bool,
    pub(crate) try_at_event: fn(&mut [f64], &mut [f64], Room) -> bool,
    /// None for a model without advice.
    advise: Option<fn(&mut [f64], Room) -> bool>,
    /// As [`ModelType::output_dual`], with the part of the memory that is in use.
    pub(crate) output_dual_with: fn(&mut [Dual], &[Dual]),
    /// As [`ModelType::rate`], with the part of the memory that is in use.
    pub(crate) rate_with: Rate,
    rate_dual: fn(&[Dual], &mut [Dual]),
    overshoot: fn(&[f64]) -> f64,
    overshoot_dual: fn(&[Dual]) -> Dual,
    slides_steadily: fn(&[f64]) -> bool,
    check_model_exchange: fn(&[f64]) -> Result<(), Fault>,
    check_without_events: fn(&[f64]) -> Result<(), Fault>,
    rests: fn(&[f64], usize) -> bool,
    indicate: fn(&[f64], &mut [f64]),
    is_linear: fn(&[f64]) -> bool,
    past: fn(&[f64]) -> Option<Past>,
    bonds: fn(&[f64]) -> Option<Bonds>,
    put_bonds: fn(&mut [f64], &Bonds, f64),
}

impl ModelType {
    /// The record of a model.
    pub const fn of<M: Model>() -> ModelType {
        ModelType {
            name: M::NAME,
            c_name: M::C_NAME,
            summary: M::SUMMARY,
            table: M::COLUMNS,
            ports: M::PORTS,
            references: M::REFERENCES,
            presets: M::PRESETS,
            model_exchange: is_for_exchange::<M>(),
            has_rates: <M::Interface as Interface<M>>::HAS_RATES,
            event_indicators: M::EVENT_INDICATORS,
            memory: M::MEMORY,
            kernels: M::KERNELS,
            guid: guid_of::<M>(),
            check: |row| view::<M, f64>(row).check(),
            check_motion: |row| view::<M, f64>(row).check_motion(),
            check_step: |row, dt| view::<M, f64>(row).check_step(dt),
            warning: |row| view::<M, f64>(row).warning(),
            passivity: |row| view::<M, f64>(row).passivity(),
            memory_in_use: |row| view::<M, f64>(row).memory_in_use(),
            try_advance: advance::<M>,
            try_advance_ramp: advance_ramp::<M>,
            try_output: output::<M>,
            try_slide_steadily: if M::STEADY_SLIDING { slide_steadily::<M> } else { output::<M> },
            advise: if has_advice(M::TABLE) { Some(advise::<M>) } else { None },
            output_dual_with: |row, memory| view_mut::<M::In<Dual>, Dual>(row).output_with(memory),
            rate_with: rate_with::<M>,
            rate_dual: super::rate_in::<M, Dual>,
            overshoot: super::evaluate::overshoot_in::<M, f64>,
            overshoot_dual: super::evaluate::overshoot_in::<M, Dual>,
            slides_steadily: |row| view::<M, f64>(row).slides_steadily(),
            check_model_exchange: |row| view::<M, f64>(row).check_model_exchange(),
            check_without_events: |row| view::<M, f64>(row).check_without_events(),
            rests: |row, column| view::<M, f64>(row).rests(column),
            indicate: |row, indicators| view::<M, f64>(row).event_indicators(indicators),
            is_linear: |row| view::<M, f64>(row).is_linear(),
            past: |row| view::<M, f64>(row).past(),
            bonds: |row| view::<M, f64>(row).bonds(),
            put_bonds: |row, bonds, displacement| view_mut::<M, f64>(row).put_bonds(bonds, displacement),
            try_at_event: |row, memory, room| commit::<M>(row, memory, room, 0, |model, _| model.at_event()),
        }
    }

    /// As [`ModelType::of`], for a library whose instances make steps only: without what solvers, batches and events ask
    /// for, which its linker then leaves out.
    pub const fn of_steps<M: Model>() -> ModelType {
        ModelType {
            kernels: None,
            try_slide_steadily: output::<M>,
            slides_steadily: |_| false,
            overshoot: |_| 0.0,
            overshoot_dual: |_| Dual::from(0.0),
            check_model_exchange: |_| Ok(()),
            indicate: |_, _| {},
            is_linear: |_| false,
            past: |_| None,
            bonds: |_| None,
            put_bonds: |_, _, _| {},
            try_at_event: |_, _, _| true,
            ..ModelType::of::<M>()
        }
    }

    /// As [`ModelType::of_steps`], for instances whose inputs never have slopes.
    pub const fn of_held_steps<M: Model>() -> ModelType {
        ModelType { try_advance_ramp: |_, _, _, _, _| false, ..ModelType::of_steps::<M>() }
    }

    /// The guid that ties modelDescription.xml to this library.
    pub fn guid(&self) -> &str {
        // The fingerprint is spelled with ASCII digits only.
        std::str::from_utf8(&self.guid).unwrap_or_default()
    }

    /// The guid, for data that must not hold the address of the model.
    pub fn guid_text(&self) -> GuidText {
        self.guid
    }

    /// The guid of a description in which all variables are Real, as hosts need it that know no other type.
    pub fn plain_guid(&self) -> GuidText {
        guid::plain(&self.guid)
    }

    /// The column or other quantity with this value reference.
    #[inline(always)]
    pub fn place(&self, reference: Reference) -> Option<Place> {
        self.references.find(reference, self.table.len())
    }

    /// The value reference of a column.
    pub fn reference(&self, column: usize) -> Reference {
        reference::of(&self.table.at(column).path)
    }

    /// The value references of the time derivatives of the continuous states.
    pub fn derivative_references(&self) -> impl Iterator<Item = Reference> {
        self.continuous_states().map(|state| reference::of_derivative(&self.table.at(state).path))
    }

    /// The variables that the interfaces show, with their columns.
    pub fn variables(&self) -> impl Iterator<Item = (usize, Variable)> {
        self.table.iter().enumerate().filter(|(_, variable)| !variable.is_hidden)
    }

    /// The column of the variable of this name.
    pub fn find(&self, name: &str) -> Option<usize> {
        match self.place(reference::of_name(name))? {
            // Another name can have the same fingerprint.
            Place::Column(column) => self.table.at(column).path.is_spelled(name).then_some(column),
            Place::Time | Place::Derivative(_) => None,
        }
    }

    /// The columns of advice.
    pub(crate) fn advice(&self) -> impl Iterator<Item = usize> {
        let columns = if self.advise.is_some() { self.table.len() } else { 0 };
        (0..columns).filter(|column| self.table.at(*column).is_advice)
    }

    /// Refuses parameters that are admitted one by one but not together.
    pub fn check(&self, row: &[f64]) -> Result<(), Fault> {
        (self.check)(row)
    }

    /// Warning about values that are accepted although they make no sense here.
    pub fn warning(&self, row: &[f64]) -> Option<Fault> {
        (self.warning)(row)
    }

    /// The value with which the model can give back more energy than it took: [`Model::passivity`].
    pub fn passivity(&self, row: &[f64]) -> Option<Fault> {
        self.gives_back(row).map(GivesBack::fault)
    }

    /// The same, for a model that contains the model.
    pub(crate) fn gives_back(&self, row: &[f64]) -> Option<GivesBack> {
        (self.passivity)(row)
    }

    /// Number of values of the memory beside the row that the parameters ask for. The functions that work on a row
    /// alone are for rows that need none.
    #[inline]
    pub fn memory_in_use(&self, row: &[f64]) -> usize {
        (self.memory_in_use)(row)
    }

    /// Advances by `dt` with held inputs and computes the outputs. False if a result is not finite; the row must not be
    /// used then.
    #[inline]
    pub fn advance(&self, row: &mut [f64], dt: f64) -> bool {
        (self.try_advance)(row, &mut [], &mut [], dt) && self.try_advise(row, &mut [])
    }

    /// As [`ModelType::advance`], with inputs that move linearly.
    pub fn advance_ramp(&self, row: &mut [f64], slope: &[f64], dt: f64) -> bool {
        (self.try_advance_ramp)(row, &mut [], &mut [], slope, dt) && self.try_advise(row, &mut [])
    }

    /// Computes the outputs. False if one is not finite; the row must not be used then.
    #[inline]
    pub fn output(&self, row: &mut [f64]) -> bool {
        (self.try_output)(row, &mut [], &mut []) && self.try_advise(row, &mut [])
    }

    /// Computes the outputs that are advice. False if one is not finite; the row is then as it was, if there is workspace
    /// for a copy.
    #[inline(always)]
    pub(crate) fn try_advise(&self, row: &mut [f64], room: Room) -> bool {
        self.advise.is_none_or(|advise| advise(row, room))
    }

    /// Computes the outputs, except advice, with their derivatives in the direction that the other columns carry.
    pub fn output_dual(&self, row: &mut [Dual]) {
        (self.output_dual_with)(row, &[]);
    }

    /// Time derivatives of the states, in the columns of the states; 0 elsewhere.
    pub fn rate(&self, row: &[f64], rate: &mut [f64]) {
        (self.rate_with)(row, &[], rate, &mut []);
    }

    /// The same with their derivatives in the direction that the columns of `row` carry; for Model Exchange.
    pub fn rate_dual(&self, row: &[Dual], rate: &mut [Dual]) {
        (self.rate_dual)(row, rate);
    }

    /// Largest force without its viscous part, relative to the static level.
    pub fn overshoot(&self, row: &[f64]) -> f64 {
        (self.overshoot)(row)
    }

    /// The same with its derivative in the direction that the columns of `row` carry.
    pub fn overshoot_dual(&self, row: &[Dual]) -> Dual {
        (self.overshoot_dual)(row)
    }

    /// Whether the outputs at held inputs in the end have a closed form with the parameters of a row, whatever the inputs.
    pub fn slides_steadily(&self, row: &[f64]) -> bool {
        (self.slides_steadily)(row)
    }

    /// The columns of the states that move with time.
    pub fn continuous_states(&self) -> impl Iterator<Item = usize> {
        let table = self.table;
        (0..table.len()).filter(move |column| table.at(*column).is_continuous_state())
    }

    /// Those of them that the parameters of a row use: the states of elements beyond the number of elements rest, and
    /// those of parts that are switched off.
    pub fn states_in_use(&self, row: &[f64]) -> impl Iterator<Item = usize> {
        let (table, count) = (self.table, self.table.of(Meaning::ElementCount).map(|column| row[column]));
        let index = move |column: usize| table.at(column).path.segments()[0].index;
        self.continuous_states()
            .filter(move |column| count.is_none_or(|count| f64::from(index(*column)) <= count))
            .filter(move |column| !(self.rests)(row, *column))
    }

    /// Refuses parameters with which the model is for co-simulation only.
    pub fn check_model_exchange(&self, row: &[f64]) -> Result<(), Fault> {
        (self.check_model_exchange)(row)
    }

    /// Refuses parameters with which the model needs the events of Model Exchange.
    pub fn check_without_events(&self, row: &[f64]) -> Result<(), Fault> {
        (self.check_without_events)(row)
    }

    /// Writes the event indicators.
    pub fn indicate(&self, row: &[f64], indicators: &mut [f64]) {
        (self.indicate)(row, indicators);
    }

    /// Whether rates and outputs are linear until the next event; see [`Model::PIECEWISE_LINEAR`].
    pub fn is_linear(&self, row: &[f64]) -> bool {
        (self.is_linear)(row)
    }

    /// The past that the rates need with these parameters.
    pub fn past(&self, row: &[f64]) -> Option<Past> {
        (self.past)(row)
    }

    /// The bonds of the contact, if it has some.
    pub fn bonds(&self, row: &[f64]) -> Option<Bonds> {
        (self.bonds)(row)
    }

    /// Takes the bonds over after a displacement in which none has snapped.
    pub fn put_bonds(&self, row: &mut [f64], bonds: &Bonds, displacement: f64) {
        (self.put_bonds)(row, bonds, displacement);
    }

    /// Changes whatever changes at events only. False if a result is not finite; the row must not be used then.
    pub fn at_event(&self, row: &mut [f64]) -> bool {
        (self.try_at_event)(row, &mut [], &mut [])
    }
}

impl PartialEq for ModelType {
    fn eq(&self, other: &ModelType) -> bool {
        self.guid == other.guid
    }
}

impl fmt::Debug for ModelType {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} {}", self.name, self.guid())
    }
}

const fn guid_of<M: Model>() -> GuidText {
    let indicators = if is_for_exchange::<M>() { Some(M::EVENT_INDICATORS) } else { None };
    guid::fingerprint(M::NAME, M::TABLE, indicators)
}

fn rate_with<M: Model>(row: &[f64], memory: &[f64], rate: &mut [f64], memory_rate: &mut [f64]) {
    rate.fill(0.0);
    view::<M, f64>(row).rate_with(memory, view_mut(rate), memory_rate);
}

fn advance<M: Model>(row: &mut [f64], memory: &mut [f64], room: Room, dt: f64) -> bool {
    let first = if view::<M, f64>(row).moves_inputs() { 0 } else { const { first_result(M::TABLE) } };
    commit::<M>(row, memory, room, first, |model, memory| model.step_and_output_with(memory, dt))
}

fn output<M: Model>(row: &mut [f64], memory: &mut [f64], room: Room) -> bool {
    commit::<M>(row, memory, room, const { first_result(M::TABLE) }, |model, memory| model.output_with(memory))
}

fn slide_steadily<M: Model>(row: &mut [f64], memory: &mut [f64], room: Room) -> bool {
    commit::<M>(row, memory, room, const { first_result(M::TABLE) }, |model, memory| {
        model.slide_steadily_with(memory);
        model.output_with(memory);
    })
}

fn advance_ramp<M: Model>(row: &mut [f64], memory: &mut [f64], room: Room, slope: &[f64], dt: f64) -> bool {
    let slope = view::<M, f64>(slope);
    // The inputs have moved as well.
    commit::<M>(row, memory, room, 0, |model, memory| {
        model.step_ramp_with(memory, slope, dt);
        model.output_with(memory);
    })
}

/// Whether a table has advice. It must be a number that is not a result of events.
const fn has_advice(table: &[Variable]) -> bool {
    let (mut found, mut column) = (false, 0);
    while column < table.len() {
        let Variable { role, is_advice, jumps, .. } = table[column];
        assert!(!is_advice || role.is_computed() && !jumps, "advice is a real output");
        found |= is_advice;
        column += 1;
    }
    found
}

fn advise<M: Model>(row: &mut [f64], room: Room) -> bool {
    commit::<M>(row, &mut [], room, const { first_result(M::TABLE) }, |model, _| model.advise())
}

/// The first column that the outputs may change, and a step that does not move the inputs: those before it are inputs and
/// parameters.
const fn first_result(table: &[Variable]) -> usize {
    let mut first = 0;
    while first < table.len() && (table[first].role.is_parameter() || matches!(table[first].role, Role::Input)) {
        first += 1;
    }
    first
}
