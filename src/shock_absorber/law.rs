//! Any scalar law of the catalogue as the friction of a contact.
//!
//! The list of laws, their parameters and their states are taken from the tables of the friction models, so that a new
//! law can be chosen here without any further code.

use crate::friction::MODELS;
use crate::model::{Column, Columns, Enumeration, Fault, Item, Kind, ModelType, Path, Variable, real};
use crate::number::{Dual, Real};
pub use crate::shock_absorber::law_parameters::LawParameters;
use crate::shock_absorber::law_parameters::place_of;
use crate::unit::same;

/// Whether the law is one along a line.
const fn is_scalar(model: &ModelType) -> bool {
    column(model, "velocity").is_some() && column(model, "friction_force").is_some()
}

/// Column named `name`, not within a part.
const fn column(model: &ModelType, name: &str) -> Option<usize> {
    let mut at = 0;
    while at < model.table.len() {
        let segments = model.table[at].path.segments();
        if segments.len() == 1 && same(segments[0].name, name) {
            return Some(at);
        }
        at += 1;
    }
    None
}

/// Number of laws.
pub(super) const COUNT: usize = {
    let (mut count, mut at) = (0, 0);
    while at < MODELS.len() {
        count += is_scalar(&MODELS[at]) as usize;
        at += 1;
    }
    count
};

/// The laws, in the order of the catalogue.
pub(super) const LAWS: [&ModelType; COUNT] = {
    let mut laws = [&MODELS[0]; COUNT];
    let (mut count, mut at) = (0, 0);
    while at < MODELS.len() {
        if is_scalar(&MODELS[at]) {
            laws[count] = &MODELS[at];
            count += 1;
        }
        at += 1;
    }
    laws
};

/// Choices of a law: none, then the laws in the order of the catalogue.
pub static FRICTION_MODEL: Enumeration = Enumeration { name: "FrictionModel", items: &ITEMS };

static ITEMS: [Item; COUNT + 1] = {
    let mut items = [const { Item { name: "None", help: "No friction." } }; COUNT + 1];
    let mut at = 0;
    while at < COUNT {
        items[at + 1] = Item { name: LAWS[at].name, help: LAWS[at].summary };
        at += 1;
    }
    items
};

/// The default law.
pub(crate) const LUGRE: i32 = position("LuGre") as i32 + 2;

pub(super) const fn position(name: &str) -> usize {
    let mut at = 0;
    while !same(LAWS[at].name, name) {
        at += 1;
    }
    at
}

/// Source of the value of a column of a law's row.
#[derive(Clone, Copy)]
pub(super) enum Source {
    /// The law's own start value.
    Start,
    /// Input from the contact.
    Velocity,
    NormalForce,
    MuK,
    MuS,
    Mass,
    Exchange,
    ExternalForce,
    Acceleration,
    /// A parameter of the law, by its place among those of all laws.
    Parameter(u16),
    /// A state of the law, by its place in the memory.
    Memory(u16),
}

/// Columns that a contact provides to its law.
const GIVEN: [(&str, Source); 8] = [
    ("velocity", Source::Velocity),
    ("normal_force", Source::NormalForce),
    ("mu_k", Source::MuK),
    ("mu_s", Source::MuS),
    ("mass", Source::Mass),
    ("exchange", Source::Exchange),
    ("external_force", Source::ExternalForce),
    ("acceleration", Source::Acceleration),
];

pub(super) const fn given(variable: &Variable) -> Option<Source> {
    let segments = variable.path.segments();
    let mut at = 0;
    while at < GIVEN.len() {
        if segments.len() == 1 && same(segments[0].name, GIVEN[at].0) {
            return Some(GIVEN[at].1);
        }
        at += 1;
    }
    None
}

/// Whether the variable is a state of the law. The energy is summed by the contact.
const fn is_remembered(variable: &Variable) -> bool {
    variable.role.is_state() && !same(variable.path.segments()[0].name, "dissipated_energy")
}

/// Whether an importer that integrates the states itself integrates this one.
const fn is_moving(law: &ModelType, variable: &Variable) -> bool {
    law.model_exchange && is_remembered(variable) && variable.is_continuous_state()
}

/// Largest number of continuous states of a law that supports Model Exchange: they come first in the memory. A discrete
/// state never has such a place, where a solver may write anything.
const MOVING: usize = {
    let (mut most, mut law) = (0, 0);
    while law < COUNT {
        let (mut count, mut at) = (0, 0);
        while at < LAWS[law].table.len() {
            count += is_moving(LAWS[law], &LAWS[law].table[at]) as usize;
            at += 1;
        }
        if count > most {
            most = count;
        }
        law += 1;
    }
    most
};

/// First place for the discrete states of a law.
const fn first_jumping(law: &ModelType) -> usize {
    if law.model_exchange { MOVING } else { 0 }
}

/// Number of places that suffices for the states of any law.
pub const MEMORY: usize = {
    let (mut most, mut at) = (0, 0);
    while at < COUNT {
        let (mut places, mut column) = (first_jumping(LAWS[at]), 0);
        while column < LAWS[at].table.len() {
            let variable = &LAWS[at].table[column];
            places += (is_remembered(variable) && !is_moving(LAWS[at], variable)) as usize;
            column += 1;
        }
        if places > most {
            most = places;
        }
        at += 1;
    }
    most
};

/// Largest number of columns of any law.
const WIDEST: usize = {
    let (mut widest, mut at) = (0, 0);
    while at < COUNT {
        if LAWS[at].table.len() > widest {
            widest = LAWS[at].table.len();
        }
        at += 1;
    }
    widest
};

/// A law and the sources of the columns of its row.
struct Plan {
    model: &'static ModelType,
    sources: [Source; WIDEST],
    friction_force: usize,
    sticking: usize,
    dissipated_energy: usize,
    /// Place of its viscous coefficient among the parameters of all laws.
    viscous: Option<usize>,
    /// State of the carried force.
    carrier: Carrier,
}

/// State of the force that a law carries, which may come from a larger load than the present one.
#[derive(Clone, Copy)]
enum Carrier {
    /// Nothing, or a share of the load, which falls with it.
    Share,
    /// Columns of the mean deflection of its bristles and of their stiffness.
    Deflection(usize, usize),
    /// Column of the force, viscous part included.
    Force(usize),
    /// Forces of elements, and the column of their total strength as a multiple of the static level, if the law has
    /// one.
    Elements(Option<usize>),
}

static PLANS: [Plan; COUNT] = {
    let mut plans = [const { plan(LAWS[0]) }; COUNT];
    let mut at = 0;
    while at < COUNT {
        plans[at] = plan(LAWS[at]);
        at += 1;
    }
    plans
};

const fn plan(law: &'static ModelType) -> Plan {
    let mut sources = [Source::Start; WIDEST];
    let (mut moving, mut jumping, mut at) = (0, first_jumping(law), 0);
    while at < law.table.len() {
        let variable = &law.table[at];
        if let Some(source) = given(variable) {
            sources[at] = source;
        } else if is_moving(law, variable) {
            sources[at] = Source::Memory(moving);
            moving += 1;
        } else if is_remembered(variable) {
            sources[at] = Source::Memory(jumping as u16);
            jumping += 1;
        } else if let Some(place) = place_of(law, variable) {
            sources[at] = Source::Parameter(place);
        }
        at += 1;
    }
    let viscous = match column(law, "viscous_coefficient") {
        Some(at) => match sources[at] {
            Source::Parameter(place) => Some(place as usize),
            _ => None,
        },
        None => None,
    };
    let friction_force = column(law, "friction_force").expect("every law has a force");
    let sticking = column(law, "sticking").expect("every law says whether it sticks");
    let dissipated_energy = column(law, "dissipated_energy").expect("every law counts its energy");
    Plan { model: law, sources, friction_force, sticking, dissipated_energy, viscous, carrier: carrier(law) }
}

/// Whether the variable is a state that holds the force of an element or the whole force.
const fn is_carried_force(variable: &Variable) -> bool {
    let is_force = match variable.kind {
        Kind::Real(unit) => same(unit.name, "N"),
        _ => false,
    };
    is_force && is_remembered(variable) && variable.is_continuous_state()
}

const fn carrier(law: &ModelType) -> Carrier {
    let mut at = 0;
    while at < law.table.len() {
        if is_carried_force(&law.table[at]) {
            let is_element = law.table[at].path.segments()[0].index > 0;
            return if is_element { Carrier::Elements(column(law, "hysteresis_strength")) } else { Carrier::Force(at) };
        }
        at += 1;
    }
    match (column(law, "bristle_deflection"), column(law, "sigma_0")) {
        (Some(deflection), Some(stiffness)) => Carrier::Deflection(deflection, stiffness),
        _ => Carrier::Share,
    }
}

/// Inputs of a law from its contact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Given<T> {
    pub velocity: T,
    pub normal_force: T,
    pub mu_k: T,
    pub mu_s: T,
    pub mass: T,
    pub exchange: T,
    pub external_force: T,
    pub acceleration: T,
    /// Largest force of the contact at rest.
    pub largest: T,
}

/// Result of a law.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Answer<T> {
    pub force: T,
    pub sticking: bool,
    /// Energy dissipated over the step.
    pub energy: f64,
}

/// Evaluates a model's row in its number type. False if a result is not finite.
pub trait Evaluate: Real {
    /// Computes the outputs of the row.
    fn evaluate(model: &ModelType, row: &mut [Self]) -> bool;

    /// Computes the time derivatives of the states.
    fn rate(model: &ModelType, row: &[Self], rate: &mut [Self]);

    /// Slope of the number; 0 if it has none.
    fn slope(self) -> f64;

    /// A number with that slope, if the type can hold one.
    fn with_slope(value: f64, slope: f64) -> Self;
}

impl Evaluate for f64 {
    fn evaluate(model: &ModelType, row: &mut [f64]) -> bool {
        model.output(row)
    }

    fn rate(model: &ModelType, row: &[f64], rate: &mut [f64]) {
        model.rate(row, rate);
    }

    fn slope(self) -> f64 {
        0.0
    }

    fn with_slope(value: f64, _slope: f64) -> f64 {
        value
    }
}

impl Evaluate for Dual {
    fn evaluate(model: &ModelType, row: &mut [Dual]) -> bool {
        model.output_dual(row);
        true
    }

    fn rate(model: &ModelType, row: &[Dual], rate: &mut [Dual]) {
        model.rate_dual(row, rate);
    }

    fn slope(self) -> f64 {
        self.slope
    }

    fn with_slope(value: f64, slope: f64) -> Dual {
        Dual { value, slope }
    }
}

/// Law chosen by its number in [`FRICTION_MODEL`].
#[derive(Clone, Copy)]
pub(crate) struct ChosenLaw(&'static Plan);

impl ChosenLaw {
    /// The law of that number; `None` for no friction.
    pub(crate) fn of(number: f64) -> Option<ChosenLaw> {
        PLANS.get((number as usize).wrapping_sub(2)).map(ChosenLaw)
    }

    /// Sources of the columns of its row.
    fn sources(self) -> &'static [Source] {
        &self.0.sources[..self.0.model.table.len()]
    }

    /// Whether it uses the mass that the contact has to stop.
    pub(crate) fn asks_for_mass(self) -> bool {
        self.sources().iter().any(|source| matches!(source, Source::Mass))
    }

    /// Force at the given motion.
    pub(crate) fn force<T: Evaluate>(
        self,
        given: &Given<T>,
        parameters: &LawParameters<T>,
        memory: &[T; MEMORY],
    ) -> Answer<T> {
        self.on_row(|row| {
            self.fill(row, given, parameters, memory);
            let is_finite = T::evaluate(self.0.model, row);
            self.answer(row, is_finite)
        })
    }

    /// Advances the memory by `dt` while the motion is held.
    pub(crate) fn advance(
        self,
        given: &Given<f64>,
        parameters: &LawParameters,
        memory: &mut [f64; MEMORY],
        dt: f64,
    ) -> Answer<f64> {
        self.on_row(|row| {
            self.fill(row, given, parameters, memory);
            let is_finite = self.0.model.advance(row, dt);
            self.remember(row, memory);
            self.answer(row, is_finite)
        })
    }

    /// Advances the memory by `dt` while velocity and forces change linearly from `begin` to `end`.
    #[inline(never)]
    pub(crate) fn advance_from(
        self,
        begin: &Given<f64>,
        end: &Given<f64>,
        parameters: &LawParameters,
        memory: &mut [f64; MEMORY],
        dt: f64,
    ) -> Answer<f64> {
        self.on_row(|row| {
            self.fill(row, end, parameters, memory);
            self.on_row(|slope| {
                for ((value, slope), source) in row.iter_mut().zip(slope.iter_mut()).zip(self.sources()) {
                    let begin = match source {
                        Source::Velocity => begin.velocity,
                        Source::NormalForce => begin.normal_force,
                        Source::ExternalForce => begin.external_force,
                        _ => continue,
                    };
                    *slope = (*value - begin) / dt;
                    *value = begin;
                }
                let is_finite = self.0.model.advance_ramp(row, slope, dt);
                self.remember(row, memory);
                self.answer(row, is_finite)
            })
        })
    }

    /// Writes the time derivatives of the law's states; the other places are left as they are.
    pub(crate) fn write_rate<T: Evaluate>(
        self,
        given: &Given<T>,
        parameters: &LawParameters<T>,
        memory: &[T; MEMORY],
        rate: &mut [T; MEMORY],
    ) {
        self.on_row(|row| {
            self.fill(row, given, parameters, memory);
            self.on_row(|rates| {
                T::rate(self.0.model, row, rates);
                self.remember(rates, rate);
            });
            if let Carrier::Deflection(slipping, _) | Carrier::Force(slipping) = self.0.carrier
                && let Source::Memory(place) = self.0.sources[slipping]
            {
                let (place, release_time) = (usize::from(place), T::from(RELEASE_TIME));
                rate[place] = rate[place] - (memory[place] - row[slipping]) / release_time;
            }
        });
    }

    /// Writes the initial state of the law; the other places are left as they are.
    pub(crate) fn write_start<T: Real>(self, memory: &mut [T; MEMORY]) {
        for (source, variable) in self.sources().iter().zip(self.0.model.table) {
            if let Source::Memory(place) = source {
                memory[usize::from(*place)] = T::from(variable.start);
            }
        }
    }

    /// Initial state of the law.
    fn start(self) -> [f64; MEMORY] {
        let mut memory = [0.0; MEMORY];
        self.write_start(&mut memory);
        memory
    }

    /// The viscous coefficient, if the law has one.
    pub(crate) fn viscous_coefficient<T: Real>(self, parameters: &LawParameters<T>) -> T {
        self.0.viscous.map_or(T::zero(), |place| parameters.values[place])
    }

    /// Refuses parameters that the law refuses.
    pub(crate) fn check(self, given: &Given<f64>, parameters: &LawParameters) -> Result<(), Fault> {
        let named = |fault: Fault| Fault::new(format_args!("friction.model = {}: {}", self.0.model.name, fault.0));
        self.on_row(|row| {
            self.fill(row, given, parameters, &self.start());
            for ((variable, source), value) in self.0.model.table.iter().zip(self.sources()).zip(&*row) {
                if matches!(source, Source::Parameter(_)) && !variable.admits(*value) {
                    return Err(named(variable.fault(*value)));
                }
            }
            self.0.model.check(row).map_err(named)
        })
    }

    /// Warns of a shared parameter that was set although this law has its own; names only the first one.
    pub(crate) fn warning(self, parameters: &LawParameters) -> Option<Fault> {
        let shared = LawParameters::TABLE.iter().zip(&parameters.values);
        let mut changed = shared.filter(|(variable, value)| **value != variable.start);
        let has_own = |path: &Path| {
            let columns = self.0.model.table.iter().zip(self.sources());
            columns.into_iter().any(|(variable, source)| {
                let Source::Parameter(place) = *source else { return false };
                variable.path.is(path) && !LawParameters::TABLE[usize::from(place)].path.is(path)
            })
        };
        let (variable, value) = changed.find(|(variable, _)| has_own(&variable.path))?;
        let (name, law) = (variable.path, self.0.model.name);
        let text = format_args!("has no effect on friction.model = {law}: set friction.{law}.{name}");
        Some(Fault::new(format_args!("friction.{name} = {value} {text}")))
    }

    /// Refuses a law, or parameters, that are for co-simulation only.
    pub(crate) fn check_model_exchange(self, given: &Given<f64>, parameters: &LawParameters) -> Result<(), Fault> {
        let name = self.0.model.name;
        if !self.0.model.model_exchange {
            let text = format_args!("friction.model = {name}: must be a law that supports Model Exchange");
            return Err(Fault::new(text));
        }
        let named = |fault: Fault| Fault::new(format_args!("friction.model = {name}: {}", fault.0));
        self.on_row(|row| {
            self.fill(row, given, parameters, &self.start());
            self.0.model.check_model_exchange(row).map_err(named)
        })
    }

    /// Event indicators of the law.
    pub(crate) fn indicate(
        self,
        given: &Given<f64>,
        parameters: &LawParameters,
        memory: &[f64; MEMORY],
        indicators: &mut [f64; MOST_EVENTS],
    ) {
        let model = self.0.model;
        self.on_row(|row| {
            self.fill(row, given, parameters, memory);
            model.indicate(row, &mut indicators[..model.event_indicators]);
        });
    }

    /// Updates the states of the law that change at an event.
    pub(crate) fn at_event(self, given: &Given<f64>, parameters: &LawParameters, memory: &mut [f64; MEMORY]) {
        self.on_row(|row| {
            self.fill(row, given, parameters, memory);
            self.0.model.at_event(row);
            self.remember(row, memory);
        });
    }

    /// Works on a row of the law. Most rows are short, and long ones of a few laws must not enlarge the stack of all.
    fn on_row<T: Real, R>(self, work: impl FnOnce(&mut [T]) -> R) -> R {
        let columns = self.0.model.table.len();
        if columns <= NARROW {
            in_space::<NARROW, _, _>(columns, work)
        } else {
            in_space::<WIDEST, _, _>(columns, work)
        }
    }

    fn remember<T: Real>(self, row: &[T], memory: &mut [T; MEMORY]) {
        for (source, value) in self.sources().iter().zip(row) {
            if let Source::Memory(place) = source {
                memory[usize::from(*place)] = *value;
            }
        }
    }

    fn fill<T: Real>(self, row: &mut [T], given: &Given<T>, parameters: &LawParameters<T>, memory: &[T; MEMORY]) {
        for ((value, source), variable) in row.iter_mut().zip(self.sources()).zip(self.0.model.table) {
            *value = match *source {
                Source::Start => T::from(variable.start),
                Source::Velocity => given.velocity,
                Source::NormalForce => given.normal_force,
                Source::MuK => given.mu_k,
                Source::MuS => given.mu_s,
                Source::Mass => given.mass,
                Source::Exchange => given.exchange,
                Source::ExternalForce => given.external_force,
                Source::Acceleration => given.acceleration,
                Source::Parameter(place) => parameters.values[usize::from(place)],
                Source::Memory(place) => memory[usize::from(place)],
            };
        }
        self.slip(row, given, parameters);
    }

    /// Lets slip whatever carries more than the present load allows.
    fn slip<T: Real>(self, row: &mut [T], given: &Given<T>, parameters: &LawParameters<T>) {
        match self.0.carrier {
            Carrier::Share => {}
            Carrier::Deflection(deflection, stiffness) => {
                row[deflection] = row[deflection].limited(given.largest / row[stiffness]);
            }
            Carrier::Force(force) => {
                let viscous = self.viscous_coefficient(parameters) * given.velocity.abs();
                row[force] = row[force].limited(T::from(OVERSHOOT) * given.largest + viscous);
            }
            Carrier::Elements(strength) => {
                let strength = strength.map_or(given.largest, |strength| row[strength] * given.largest);
                self.slip_elements(row, strength, |sum, force| sum + force.abs());
                self.slip_elements(row, given.largest, |sum, force| sum + force);
            }
        }
    }

    /// Scales the forces of the elements, which keep their shares of the total and of the forces between them.
    fn slip_elements<T: Real>(self, row: &mut [T], largest: T, add: impl Fn(T, T) -> T) {
        let table = self.0.model.table;
        let forces = || (0..table.len()).filter(|column| is_carried_force(&table[*column]));
        let total = forces().fold(T::zero(), |sum, column| add(sum, row[column])).abs();
        // Slipping elements are at their strength, apart from rounding, and stay as they are.
        if total.value() > largest.value() * (1.0 + ROUNDING) {
            let part = largest / total;
            forces().for_each(|column| row[column] = row[column] * part);
        }
    }

    fn answer<T: Real>(self, row: &[T], is_finite: bool) -> Answer<T> {
        Answer {
            force: if is_finite { row[self.0.friction_force] } else { T::from(f64::NAN) },
            sticking: row[self.0.sticking].value() != 0.0,
            energy: row[self.0.dissipated_energy].value(),
        }
    }
}

/// Largest force of a smooth curve relative to its static level (chosen; the excess is 0.4 % for the start values of
/// SpeckerDynamic).
const OVERSHOOT: f64 = 1.01;

/// Rounding of a sum of forces, relative to the sum (chosen).
const ROUNDING: f64 = 1e-12;

/// Number of columns that suffices for all laws except the few that have many (chosen).
const NARROW: usize = 48;

#[inline(never)]
fn in_space<const SPACE: usize, T: Real, R>(columns: usize, work: impl FnOnce(&mut [T]) -> R) -> R {
    let mut row = [T::zero(); SPACE];
    work(&mut row[..columns])
}

/// Time constant with which bristles slip to the force they can carry once the load has fallen, if an importer
/// integrates them (chosen, in s). While the motion continues, the force is that of bristles that have slipped. At a
/// reversal within this time they first have to return: the force then lags by at most roughly the amount that the load
/// lost in that time.
const RELEASE_TIME: f64 = 1e-3;

/// Largest number of event indicators of any law.
pub(crate) const MOST_EVENTS: usize = {
    let (mut most, mut at) = (0, 0);
    while at < COUNT {
        if LAWS[at].event_indicators > most {
            most = LAWS[at].event_indicators;
        }
        at += 1;
    }
    most
};

/// Columns of a memory; `nominal` is the typical size of its continuous states. Only these are variables: a law that
/// remembers more changes no interface.
pub(crate) const fn blank_memory(nominal: f64) -> [Column; MEMORY] {
    let mut memory = [real("1", 0.0).discrete().hidden(); MEMORY];
    let mut at = 0;
    while at < MOVING {
        memory[at] = real("1", 0.0).nominal(nominal).reinit();
        at += 1;
    }
    memory
}
