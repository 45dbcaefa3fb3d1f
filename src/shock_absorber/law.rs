//! Any scalar law of the catalogue as the friction of a contact.
//!
//! The list of laws, their parameters and the numbers they remember are taken from the tables of the friction models, so
//! a new law can be chosen here without another line.

use crate::friction::MODELS;
use crate::model::{Column, Columns, Enumeration, Fault, Item, ModelType, Path, Segment, Variable, Width, real};
use crate::number::{Dual, Real};
use crate::unit::same;

/// Elements that the laws with Maxwell-slip elements may use here.
const ELEMENTS: u16 = 16;

/// Is it a law along a line?
const fn is_scalar(model: &ModelType) -> bool {
    column(model, "velocity").is_some() && column(model, "friction_force").is_some()
}

/// The column whose name, without parts, is `name`.
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
const COUNT: usize = {
    let (mut count, mut at) = (0, 0);
    while at < MODELS.len() {
        count += is_scalar(&MODELS[at]) as usize;
        at += 1;
    }
    count
};

/// The laws, in the order of the catalogue.
const LAWS: [&ModelType; COUNT] = {
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

/// The choice of a law: none, then the laws in the order of the catalogue.
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

/// The law that is chosen at the start.
pub(crate) const LUGRE: i32 = position("LuGre") as i32 + 2;

const fn position(name: &str) -> usize {
    let mut at = 0;
    while !same(LAWS[at].name, name) {
        at += 1;
    }
    at
}

/// Where a column of a law's row gets its value from.
#[derive(Clone, Copy)]
enum Source {
    /// The law's own start value.
    Start,
    /// What the contact feels.
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
    /// A number that the law remembers, by its place in the memory.
    Memory(u16),
}

/// Columns that a contact gives to its law.
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

const fn given(variable: &Variable) -> Option<Source> {
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

/// The parameter of a law as it is offered here; `None` if the contact gives it, or for elements beyond the last.
const fn offered(law: &ModelType, variable: &Variable) -> Option<Variable> {
    let segments = variable.path.segments();
    if !variable.role.is_parameter() || given(variable).is_some() || segments[0].index > ELEMENTS {
        return None;
    }
    let mut offered = *variable;
    // Variants of different laws are different choices under one name.
    if same(segments[0].name, "variant") {
        offered.path = variable.path.within(Segment { name: law.name, index: 0 });
    }
    if same(segments[0].name, "element_count") {
        offered.bound = variable.bound.up_to(ELEMENTS as f64);
    }
    Some(offered)
}

/// The parameters of all laws, each once. Start values are those of LuGre, else the largest of any law.
const fn merge() -> ([Variable; MOST_PARAMETERS], usize) {
    let mut merged = [crate::model::BLANK; MOST_PARAMETERS];
    let first = add_parameters(&mut merged, 0, 0, LAWS[position("LuGre")]);
    let (mut count, mut at) = (first, 0);
    while at < COUNT {
        count = add_parameters(&mut merged, first, count, LAWS[at]);
        at += 1;
    }
    (merged, count)
}

/// Adds the parameters of a law to the `count` that are there; the `settled` first of these keep their start values.
const fn add_parameters(
    merged: &mut [Variable; MOST_PARAMETERS],
    settled: usize,
    mut count: usize,
    law: &ModelType,
) -> usize {
    let mut at = 0;
    while at < law.table.len() {
        if let Some(offered) = offered(law, &law.table[at]) {
            let place = find(merged, count, &offered.path);
            if place < count {
                merged[place].bound = merged[place].bound.or(offered.bound);
                if place >= settled && offered.start > merged[place].start {
                    merged[place].start = offered.start;
                }
            } else {
                merged[count] = offered;
                count += 1;
            }
        }
        at += 1;
    }
    count
}

/// Place of a name among the first `count` variables; `count` if it is not there.
const fn find(variables: &[Variable; MOST_PARAMETERS], count: usize, path: &Path) -> usize {
    let mut at = 0;
    while at < count && !variables[at].path.is(path) {
        at += 1;
    }
    at
}

/// Room for the parameters of all laws while they are merged; too little does not compile.
const MOST_PARAMETERS: usize = 128;

const MERGED: ([Variable; MOST_PARAMETERS], usize) = merge();

/// Number of parameters of all laws together.
const PARAMETERS: usize = MERGED.1;

/// The parameters of all laws.
#[derive(Debug)]
#[repr(C)]
pub struct LawParameters<T = f64> {
    /// Their values, in the order of the table.
    pub values: [T; PARAMETERS],
}

impl<T: Copy> Clone for LawParameters<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: Copy> Copy for LawParameters<T> {}

impl<T: Copy> LawParameters<T> {
    /// The same columns in another number type.
    pub fn map<U: Copy>(&self, convert: &impl Fn(T) -> U) -> LawParameters<U> {
        LawParameters { values: self.values.map(convert) }
    }
}

impl Width for LawParameters {
    const WIDTH: usize = PARAMETERS;
}

// SAFETY: `#[repr(C)]` and an array of numbers; the table has one entry for each by its type.
unsafe impl Columns for LawParameters {
    const TABLE: &'static [Variable] = MERGED.0.split_at(PARAMETERS).0;
}

/// Is it a number that a law remembers from step to step? The energy is summed up by the contact.
const fn is_remembered(variable: &Variable) -> bool {
    variable.role.is_state() && !same(variable.path.segments()[0].name, "dissipated_energy")
}

/// Does an importer that integrates the states itself integrate this one?
const fn is_moving(law: &ModelType, variable: &Variable) -> bool {
    law.model_exchange && is_remembered(variable) && variable.is_continuous_state()
}

/// As many numbers of a memory move with time in the laws that are offered for Model Exchange: they come first. A
/// number that jumps never has such a place, where a solver may leave anything.
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

/// The place behind those that a law leaves to what moves.
const fn first_jumping(law: &ModelType) -> usize {
    if law.model_exchange { MOVING } else { 0 }
}

/// Places that any law needs for the numbers that it remembers.
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

/// Most columns that any law has.
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

/// A law and where the columns of its row come from.
struct Plan {
    model: &'static ModelType,
    sources: [Source; WIDEST],
    friction_force: usize,
    sticking: usize,
    dissipated_energy: usize,
    /// Place of its viscous coefficient among the parameters of all laws.
    viscous: Option<usize>,
    /// Columns of the mean deflection of its bristles and of their stiffness.
    deflection: Option<(usize, usize)>,
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
        } else if let Some(offered) = offered(law, variable) {
            sources[at] = Source::Parameter(find(&MERGED.0, PARAMETERS, &offered.path) as u16);
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
    let deflection = match (column(law, "bristle_deflection"), column(law, "sigma_0")) {
        (Some(deflection), Some(stiffness)) => Some((deflection, stiffness)),
        _ => None,
    };
    let friction_force = column(law, "friction_force").expect("every law has a force");
    let sticking = column(law, "sticking").expect("every law says whether it sticks");
    let dissipated_energy = column(law, "dissipated_energy").expect("every law counts its energy");
    Plan { model: law, sources, friction_force, sticking, dissipated_energy, viscous, deflection }
}

/// What a law is given by its contact.
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
    /// What the bristles can carry at most.
    pub largest: T,
}

/// What a law answers.
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

    /// The slope that the number carries; 0 for one that carries none.
    fn slope(self) -> f64;

    /// A number with that slope, if it can carry one.
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

/// The law that is chosen by its number in [`FRICTION_MODEL`].
#[derive(Clone, Copy)]
pub(crate) struct ChosenLaw(&'static Plan);

impl ChosenLaw {
    /// The law of that number; `None` for no friction.
    pub(crate) fn of(number: f64) -> Option<ChosenLaw> {
        PLANS.get((number as usize).wrapping_sub(2)).map(ChosenLaw)
    }

    /// Where the columns of its row come from.
    fn sources(self) -> &'static [Source] {
        &self.0.sources[..self.0.model.table.len()]
    }

    /// Does it ask for the mass that the contact has to stop?
    pub(crate) fn asks_for_mass(self) -> bool {
        self.sources().iter().any(|source| matches!(source, Source::Mass))
    }

    /// Force at the given motion.
    #[inline(never)]
    pub(crate) fn force<T: Evaluate>(
        self,
        given: &Given<T>,
        parameters: &LawParameters<T>,
        memory: &[T; MEMORY],
    ) -> Answer<T> {
        let mut row = self.row(given, parameters, memory);
        let is_finite = T::evaluate(self.0.model, &mut row[..self.0.model.table.len()]);
        self.answer(&row, is_finite)
    }

    /// Advances the memory by `dt` while the motion is held.
    #[inline(never)]
    pub(crate) fn advance(
        self,
        given: &Given<f64>,
        parameters: &LawParameters,
        memory: &mut [f64; MEMORY],
        dt: f64,
    ) -> Answer<f64> {
        let mut row = self.row(given, parameters, memory);
        let is_finite = self.0.model.advance(&mut row[..self.0.model.table.len()], dt);
        self.remember(&row, memory);
        self.answer(&row, is_finite)
    }

    /// Advances the memory by `dt` while velocity and forces move linearly: from `begin` to the others.
    #[inline(never)]
    pub(crate) fn advance_from(
        self,
        begin: &Given<f64>,
        end: &Given<f64>,
        parameters: &LawParameters,
        memory: &mut [f64; MEMORY],
        dt: f64,
    ) -> Answer<f64> {
        let columns = self.0.model.table.len();
        let (mut row, mut slope) = (self.row(end, parameters, memory), [0.0; WIDEST]);
        for ((value, slope), source) in row.iter_mut().zip(&mut slope).zip(self.sources()) {
            let begin = match source {
                Source::Velocity => begin.velocity,
                Source::NormalForce => begin.normal_force,
                Source::ExternalForce => begin.external_force,
                _ => continue,
            };
            *slope = (*value - begin) / dt;
            *value = begin;
        }
        let is_finite = self.0.model.advance_ramp(&mut row[..columns], &slope[..columns], dt);
        self.remember(&row, memory);
        self.answer(&row, is_finite)
    }

    /// Time derivatives of what the law remembers.
    pub(crate) fn rate<T: Evaluate>(
        self,
        given: &Given<T>,
        parameters: &LawParameters<T>,
        memory: &[T; MEMORY],
    ) -> [T; MEMORY] {
        let columns = self.0.model.table.len();
        let (row, mut rates) = (self.row(given, parameters, memory), [T::zero(); WIDEST]);
        T::rate(self.0.model, &row[..columns], &mut rates[..columns]);
        let mut rate = [T::zero(); MEMORY];
        for (source, value) in self.sources().iter().zip(rates) {
            if let Source::Memory(place) = source {
                rate[usize::from(*place)] = value;
            }
        }
        if let Some((deflection, _)) = self.0.deflection
            && let Source::Memory(place) = self.0.sources[deflection]
        {
            let (place, release_time) = (usize::from(place), T::from(RELEASE_TIME));
            rate[place] = rate[place] - (memory[place] - row[deflection]) / release_time;
        }
        rate
    }

    /// What the law remembers at its start.
    pub(crate) fn start(self) -> [f64; MEMORY] {
        let mut memory = [0.0; MEMORY];
        for (source, variable) in self.sources().iter().zip(self.0.model.table) {
            if let Source::Memory(place) = source {
                memory[usize::from(*place)] = variable.start;
            }
        }
        memory
    }

    /// The viscous coefficient, if the law has one.
    pub(crate) fn viscous_coefficient<T: Real>(self, parameters: &LawParameters<T>) -> T {
        self.0.viscous.map_or(T::zero(), |place| parameters.values[place])
    }

    /// Refuses parameters that the law refuses.
    pub(crate) fn check(self, given: &Given<f64>, parameters: &LawParameters) -> Result<(), Fault> {
        let row = self.row(given, parameters, &self.start());
        let named = |fault: Fault| Fault::new(format_args!("friction.model = {}: {}", self.0.model.name, fault.0));
        for ((variable, source), value) in self.0.model.table.iter().zip(self.sources()).zip(row) {
            if matches!(source, Source::Parameter(_)) && !variable.admits(value) {
                return Err(named(variable.fault(value)));
            }
        }
        self.0.model.check(&row[..self.0.model.table.len()]).map_err(named)
    }

    /// Refuses a law, or parameters, that are for co-simulation only.
    pub(crate) fn check_exchange(self, given: &Given<f64>, parameters: &LawParameters) -> Result<(), Fault> {
        let name = self.0.model.name;
        if !self.0.model.model_exchange {
            let text = format_args!("friction.model = {name}: must be a law that is offered for Model Exchange itself");
            return Err(Fault::new(text));
        }
        let row = self.row(given, parameters, &self.start());
        let named = |fault: Fault| Fault::new(format_args!("friction.model = {name}: {}", fault.0));
        self.0.model.check_exchange(&row[..self.0.model.table.len()]).map_err(named)
    }

    /// Event indicators of the law.
    pub(crate) fn indicate(
        self,
        given: &Given<f64>,
        parameters: &LawParameters,
        memory: &[f64; MEMORY],
        indicators: &mut [f64; MOST_EVENTS],
    ) {
        let (model, row) = (self.0.model, self.row(given, parameters, memory));
        model.indicate(&row[..model.table.len()], &mut indicators[..model.event_indicators]);
    }

    /// Changes what the law remembers where it changes at an event.
    pub(crate) fn at_event(self, given: &Given<f64>, parameters: &LawParameters, memory: &mut [f64; MEMORY]) {
        let mut row = self.row(given, parameters, memory);
        self.0.model.at_event(&mut row[..self.0.model.table.len()]);
        self.remember(&row, memory);
    }

    fn remember(self, row: &[f64; WIDEST], memory: &mut [f64; MEMORY]) {
        for (source, value) in self.sources().iter().zip(row) {
            if let Source::Memory(place) = source {
                memory[usize::from(*place)] = *value;
            }
        }
    }

    fn row<T: Real>(self, given: &Given<T>, parameters: &LawParameters<T>, memory: &[T; MEMORY]) -> [T; WIDEST] {
        let mut row = [T::zero(); WIDEST];
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
        if let Some((deflection, stiffness)) = self.0.deflection {
            // Bristles that carried more when the contact was loaded more slip until they carry what they can.
            row[deflection] = row[deflection].limited(given.largest / row[stiffness]);
        }
        row
    }

    fn answer<T: Real>(self, row: &[T; WIDEST], is_finite: bool) -> Answer<T> {
        Answer {
            force: if is_finite { row[self.0.friction_force] } else { T::from(f64::NAN) },
            sticking: row[self.0.sticking].value() != 0.0,
            energy: row[self.0.dissipated_energy].value(),
        }
    }
}

/// Time in which bristles slip down to what they can carry once the load has fallen, if an importer integrates them
/// (chosen, in s). While the motion goes on, the force is that of bristles that have slipped. At a reversal within this
/// time they first have to come back: the force then lags by about what the load took away in that time, at most.
const RELEASE_TIME: f64 = 1e-3;

/// Most event indicators of any law.
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

/// The columns of a memory; `nominal` is the usual size of what moves in it.
pub(crate) const fn blank_memory(nominal: f64) -> [Column; MEMORY] {
    let mut memory = [real("1", 0.0).discrete(); MEMORY];
    let mut at = 0;
    while at < MOVING {
        memory[at] = real("1", 0.0).nominal(nominal).reinit();
        at += 1;
    }
    memory
}
