//! Any scalar law of the catalogue as the friction of a contact.
//!
//! The list of laws, their parameters and their states are taken from the tables of the friction models, so that a new
//! law can be chosen here without any further code.

pub use crate::model::Evaluate;
use crate::model::{Columns, Fault, GivesBack, Path, Table};
use crate::number::{Mask, Scalar};
use crate::shock_absorber::law_list::{COUNT, GIVENS, HELD, LAWS, WIDEST};
use crate::shock_absorber::law_parameters::LawParameters;
use crate::shock_absorber::law_plan::{Carrier, MEMORY, PLANS, Plan};

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

/// The parameters of all laws.
static PARAMETERS: Table = crate::packed!(LawParameters::TABLE);

/// Positions among [`Given::values`].
const VELOCITY: usize = 0;
const NORMAL_FORCE: usize = 1;
const MASS: usize = 4;
const EXTERNAL_FORCE: usize = 6;
const ACCELERATION: usize = 7;

impl<T: Copy> Given<T> {
    /// The columns that a law may have.
    #[inline(always)]
    pub(super) fn values(&self) -> [T; GIVENS] {
        let Given { velocity, normal_force, mu_k, mu_s, mass, exchange, external_force, acceleration, .. } = *self;
        [velocity, normal_force, mu_k, mu_s, mass, exchange, external_force, acceleration]
    }
}

/// Result of a law.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Answer<T> {
    pub force: T,
    /// Whether the contact sticks: 1 or 0.
    pub sticking: T,
    /// Energy dissipated over the step.
    pub energy: T,
}

impl<T: Scalar> Answer<T> {
    /// The answer of a contact without friction.
    pub(crate) fn none() -> Answer<T> {
        Answer { force: T::zero(), sticking: T::zero(), energy: T::zero() }
    }
}

/// Law chosen by its number in [`FRICTION_MODEL`].
#[derive(Clone, Copy)]
pub(crate) struct ChosenLaw(&'static Plan);

impl ChosenLaw {
    /// The law of that number; `None` for no friction. No other law is ever chosen than those that the library holds.
    pub(crate) fn of(number: f64) -> Option<ChosenLaw> {
        let law = (number as usize).wrapping_sub(2);
        assert!(HELD.end - HELD.start == COUNT || law >= COUNT || HELD.contains(&law), "a law that is not here");
        PLANS.get(law.wrapping_sub(HELD.start)).map(ChosenLaw)
    }

    /// Its plan: of the only law a constant, so that its functions are called directly.
    #[inline(always)]
    fn plan(self) -> &'static Plan {
        if HELD.end - HELD.start == 1 { &PLANS[0] } else { self.0 }
    }

    /// Whether it uses the mass that the contact has to stop.
    pub(crate) fn asks_for_mass(self) -> bool {
        self.asks_for(MASS)
    }

    /// Whether it uses this one among [`Given::values`].
    fn asks_for(self, place: usize) -> bool {
        usize::from(self.plan().given[place]) < self.plan().model.table.len()
    }

    /// Refuses a law that needs more than the motion and the load of its contact.
    pub(crate) fn check_mounted(self, given: &Given<f64>, parameters: &LawParameters) -> Result<(), Fault> {
        let holds_by_event = self.asks_for(EXTERNAL_FORCE) && self.check_without_events(given, parameters).is_err();
        let why = if self.asks_for(ACCELERATION) {
            "must be a law that follows no acceleration if mount.enabled is true: the host gives that of the eyes, not that \
             of the rod"
        } else if holds_by_event {
            "must be a law that holds no mass by an event if mount.enabled is true: its force at rest follows from \
             external_force, which does not know the rod"
        } else {
            return Ok(());
        };
        Err(Fault::new(format_args!("friction.model = {}: {why}", self.plan().model.name)))
    }

    /// Number of places that it uses of a memory, from the first.
    #[inline]
    pub(crate) fn memory_in_use(self) -> usize {
        self.plan().memory_in_use
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
            let is_finite = T::evaluate(self.plan().model, row);
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
            let is_finite = self.plan().model.advance(row, dt);
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
                let begin = begin.values();
                for input in [VELOCITY, NORMAL_FORCE, EXTERNAL_FORCE] {
                    let column = usize::from(self.plan().given[input]);
                    if let (Some(value), Some(slope)) = (row.get_mut(column), slope.get_mut(column)) {
                        *slope = (*value - begin[input]) / dt;
                        *value = begin[input];
                    }
                }
                let is_finite = self.plan().model.advance_ramp(row, slope, dt);
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
        if !self.plan().is_exchanged {
            T::refuse_rates();
        }
        self.on_row(|row| {
            self.fill(row, given, parameters, memory);
            self.on_row(|rates| {
                T::rate(self.plan().model, row, rates);
                self.remember(rates, rate);
            });
            if let Carrier::Deflection(slipping, _) | Carrier::Force(slipping) = self.plan().carrier
                && let Some((_, place)) = self.plan().memory.pairs().find(|(column, _)| *column == slipping)
            {
                rate[place] -= (memory[place] - row[slipping]) / T::from(RELEASE_TIME);
            }
        });
    }

    /// Stands for [`ChosenLaw::advance`] where numbers have no values.
    pub(crate) fn mark_step<T: Evaluate>(
        self,
        given: &Given<T>,
        parameters: &LawParameters<T>,
        memory: &mut [T; MEMORY],
    ) {
        self.on_row(|row| {
            self.fill(row, given, parameters, memory);
            T::mark_step(self.plan().model, row);
            self.remember(row, memory);
        });
    }

    /// Writes the initial state of the law; the other places are left as they are.
    pub(crate) fn write_start<T: Scalar>(self, memory: &mut [T; MEMORY]) {
        for (column, place) in self.plan().memory.pairs() {
            memory[place] = T::from(self.plan().model.table.start(column));
        }
    }

    /// Initial state of the law.
    fn start(self) -> [f64; MEMORY] {
        let mut memory = [0.0; MEMORY];
        self.write_start(&mut memory);
        memory
    }

    /// The viscous coefficient, if the law has one.
    pub(crate) fn viscous_coefficient<T: Scalar>(self, parameters: &LawParameters<T>) -> T {
        self.plan().viscous.map_or(T::zero(), |place| parameters.values[place])
    }

    /// Refuses parameters that the law refuses.
    pub(crate) fn check(self, given: &Given<f64>, parameters: &LawParameters) -> Result<(), Fault> {
        let named = |fault: Fault| Fault::new(format_args!("friction.model = {}: {}", self.plan().model.name, fault.0));
        self.on_row(|row| {
            self.fill(row, given, parameters, &self.start());
            for (column, _) in self.plan().parameters.pairs() {
                let (variable, value) = (&self.plan().model.table.at(column), row[column]);
                if !variable.admits(value) {
                    return Err(named(variable.fault(value)));
                }
            }
            self.plan().model.check(row).map_err(named)
        })
    }

    /// Warns of a shared parameter that was set although this law has its own; names only the first one.
    pub(crate) fn warning(self, parameters: &LawParameters) -> Option<Fault> {
        let shared = parameters.values.iter().enumerate();
        let changed = shared.filter(|(place, value)| **value != PARAMETERS.start(*place));
        let mut changed = changed.map(|(place, value)| (PARAMETERS.at(place).path, value));
        let has_own = |path: &Path| {
            let is_own = |(column, place): (usize, usize)| {
                self.plan().model.table.at(column).path.is(path) && !PARAMETERS.at(place).path.is(path)
            };
            self.plan().parameters.pairs().any(is_own)
        };
        let (name, value) = changed.find(|(path, _)| has_own(path))?;
        let law = self.plan().model.name;
        let text = format_args!("has no effect on friction.model = {law}: set friction.{law}.{name}");
        Some(Fault::new(format_args!("friction.{name} = {value} {text}")))
    }

    /// Reason why the law can give back more energy than it took, in motion at the kinetic level with bristles that carry
    /// the static one. At any speed, what they push falls with the level of the motion: no curve between the two needs more.
    pub(crate) fn gives_back_at_worst(self, given: &Given<f64>, parameters: &LawParameters) -> Option<GivesBack> {
        self.on_row(|row| {
            self.fill(row, given, parameters, &self.start());
            if let Some(column) = self.plan().model.find("stribeck_velocity") {
                row[column] = 0.0;
            }
            self.plan().model.gives_back(row)
        })
    }

    /// Path of its viscous coefficient, if the law has one.
    pub(crate) fn viscous_path(self) -> Option<Path> {
        self.plan().viscous.map(|place| PARAMETERS.at(place).path)
    }

    /// Refuses a law, or parameters, that are for co-simulation only.
    pub(crate) fn check_model_exchange(self, given: &Given<f64>, parameters: &LawParameters) -> Result<(), Fault> {
        let name = self.plan().model.name;
        if !self.plan().is_exchanged {
            let text = format_args!("friction.model = {name}: must be a law that supports Model Exchange in a contact");
            return Err(Fault::new(text));
        }
        let named = |fault: Fault| Fault::new(format_args!("friction.model = {name}: {}", fault.0));
        self.on_row(|row| {
            self.fill(row, given, parameters, &self.start());
            self.plan().model.check_model_exchange(row).map_err(named)
        })
    }

    /// Refuses a law that sticks and slips at events.
    pub(crate) fn check_without_events(self, given: &Given<f64>, parameters: &LawParameters) -> Result<(), Fault> {
        let name = self.plan().model.name;
        let named = |fault: Fault| Fault::new(format_args!("friction.model = {name}: {}", fault.0));
        self.on_row(|row| {
            self.fill(row, given, parameters, &self.start());
            self.plan().model.check_without_events(row).map_err(named)
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
        let model = self.plan().model;
        self.on_row(|row| {
            self.fill(row, given, parameters, memory);
            model.indicate(row, &mut indicators[..model.event_indicators]);
        });
    }

    /// Updates the states of the law that change at an event.
    pub(crate) fn at_event(self, given: &Given<f64>, parameters: &LawParameters, memory: &mut [f64; MEMORY]) {
        self.on_row(|row| {
            self.fill(row, given, parameters, memory);
            self.plan().model.at_event(row);
            self.remember(row, memory);
        });
    }

    /// Works on a row of the law. Most rows are short, and long ones of a few laws must not enlarge the stack of all.
    fn on_row<T: Scalar, R>(self, work: impl FnOnce(&mut [T]) -> R) -> R {
        let columns = self.plan().model.table.len();
        if columns <= NARROW {
            in_space::<NARROW, _, _>(columns, work)
        } else {
            in_space::<WIDEST, _, _>(columns, work)
        }
    }

    #[inline(always)]
    fn remember<T: Scalar>(self, row: &[T], memory: &mut [T; MEMORY]) {
        for (column, place) in self.plan().memory.pairs() {
            memory[place] = row[column];
        }
    }

    /// Fills a row of zeros.
    fn fill<T: Evaluate>(self, row: &mut [T], given: &Given<T>, parameters: &LawParameters<T>, memory: &[T; MEMORY]) {
        for (column, value) in self.plan().given.iter().zip(given.values()) {
            if let Some(place) = row.get_mut(usize::from(*column)) {
                *place = value;
            }
        }
        for (column, place) in self.plan().parameters.pairs() {
            row[column] = parameters.values[place];
        }
        for (column, place) in self.plan().memory.pairs() {
            row[column] = memory[place];
        }
        for (column, _) in self.plan().starts.pairs() {
            row[column] = T::from(self.plan().model.table.start(column));
        }
        self.slip(row, given, parameters);
    }

    /// Lets slip whatever carries more than the present load allows.
    fn slip<T: Evaluate>(self, row: &mut [T], given: &Given<T>, parameters: &LawParameters<T>) {
        match self.plan().carrier {
            Carrier::Share => {}
            Carrier::Deflection(deflection, stiffness) => {
                row[deflection] = row[deflection].limited(given.largest / row[stiffness]);
            }
            Carrier::Force(force) => {
                let viscous = self.viscous_coefficient(parameters) * given.velocity.abs();
                let is_too_much = row[force].abs().above(given.largest + viscous);
                if is_too_much.agreed() != Some(false) {
                    row[force] = row[force].limited(T::overshoot(self.plan().model, row) * given.largest + viscous);
                }
            }
            Carrier::Elements(strength) => {
                let strength = strength.map_or(given.largest, |strength| row[strength] * given.largest);
                self.slip_elements(row, strength, |sum, force| sum + force.abs());
                self.slip_elements(row, given.largest, |sum, force| sum + force);
            }
        }
    }

    /// Scales the forces of the elements, which keep their shares of the total and of the forces between them.
    fn slip_elements<T: Scalar>(self, row: &mut [T], largest: T, add: impl Fn(T, T) -> T) {
        let forces = || self.plan().elements.pairs().map(|(column, _)| column);
        let total = forces().fold(T::zero(), |sum, column| add(sum, row[column])).abs();
        // Slipping elements are at their strength, apart from rounding, and stay as they are.
        let is_too_much = total.above(largest * T::from(1.0 + ROUNDING));
        if is_too_much.agreed() != Some(false) {
            let part = is_too_much.choose(|| largest / total, || T::from(1.0));
            forces().for_each(|column| row[column] = row[column] * part);
        }
    }

    fn answer<T: Scalar>(self, row: &[T], is_finite: bool) -> Answer<T> {
        Answer {
            force: if is_finite { row[self.plan().friction_force] } else { T::from(f64::NAN) },
            sticking: row[self.plan().sticking],
            energy: row[self.plan().dissipated_energy],
        }
    }
}

/// Rounding of a sum of forces, relative to the sum (chosen).
const ROUNDING: f64 = 1e-12;

/// Number of columns that suffices for all laws except the few that have many (chosen).
const NARROW: usize = 48;

#[inline(never)]
fn in_space<const SPACE: usize, T: Scalar, R>(columns: usize, work: impl FnOnce(&mut [T]) -> R) -> R {
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
        if LAWS[at].model.event_indicators > most {
            most = LAWS[at].model.event_indicators;
        }
        at += 1;
    }
    most
};
