//! Parts and their connections, checked.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::OnceLock;

use stribeck::contact::branching::AccelerationSource;
use stribeck::model::{Kind, Meaning, ModelType, Role, Variable};

use super::file::{Description, PartDescription, Source};
use super::influence::{Influence, drives, is_used};
use super::signal::Course;
use super::values::{column, spelled};
use super::{Fault, Setting, Signal, slot};

/// A model in a system.
#[derive(Clone, Debug)]
pub struct Part {
    /// Name in the system.
    pub name: String,
    /// Its model.
    pub model: &'static ModelType,
    /// Start values.
    pub row: Vec<f64>,
    /// Whether any friction law can be this part.
    pub is_law: bool,
    set: BTreeSet<usize>,
}

/// A variable of a system: part and column.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// Number of the part.
    pub part: usize,
    /// Column of its model.
    pub column: usize,
}

/// A connection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wire {
    /// Where the value comes from.
    pub from: WireSource,
    /// The input.
    pub to: Place,
}

/// Where the value of a connection or a result comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WireSource {
    /// A variable.
    Variable(Place),
    /// The time derivative of a state.
    Derivative(Place),
}

/// A system that has passed all checks.
#[derive(Clone, Debug)]
pub struct System {
    /// The parts.
    pub parts: Vec<Part>,
    /// The connections.
    pub wires: Vec<Wire>,
    /// Inputs with their signals.
    pub signals: Vec<(Place, Signal)>,
    /// The description it was made from.
    pub description: Description,
    /// The friction law, if a part can be any.
    pub law: Option<&'static ModelType>,
    /// Settings that no part has.
    pub unused: Vec<Setting>,
    /// Dependencies of each part's outputs, once they were asked for.
    influences: OnceLock<Vec<Influence>>,
}

impl System {
    /// Joins the parts of a description. A law replaces that of the description; settings come last. Settings of the law
    /// that it does not have are listed in [`System::unused`].
    pub fn assemble(source: &Source, law: Option<&str>, settings: &[Setting]) -> Result<System, Fault> {
        let (description, settings) = tuned(&source.description, settings)?;
        let mut system = System {
            parts: Vec::new(),
            wires: Vec::new(),
            signals: Vec::new(),
            description: description.clone(),
            law: None,
            unused: Vec::new(),
            influences: OnceLock::new(),
        };
        for (name, part) in &description.part {
            system.add(name, part, law)?;
        }
        if let (Some(law), None) = (law, system.law) {
            system.choose(law)?;
        }
        for (input, signal) in &description.input {
            if let Some(to) = system.input(input)? {
                let signal = system.moved(input, signal, &source.folder, MOST_RATES)?;
                system.signals.push((to, signal));
            }
        }
        for (input, output) in &description.connect {
            system.connect(input, output)?;
        }
        for setting in &settings {
            system.set(setting)?;
        }
        system.follow()?;
        system.check()?;
        Ok(system)
    }

    /// Inputs with signals that move.
    pub(super) fn moving_signals(&self) -> impl Iterator<Item = Place> + '_ {
        let moving = self.signals.iter().filter(|(_, signal)| !matches!(signal, Signal::Constant(_)));
        moving.map(|(place, _)| *place)
    }

    /// Dependencies of each part's outputs.
    pub(super) fn influences(&self) -> &[Influence] {
        self.influences.get_or_init(|| self.parts.iter().map(|part| Influence::of(part.model, &part.row)).collect())
    }

    /// Refuses a setting that none of the systems can use.
    pub fn refuse_unused(systems: &[System]) -> Result<(), Fault> {
        let mut unused = systems.first().map_or_else(Vec::new, |system| system.unused.clone());
        unused.retain(|setting| systems.iter().all(|system| system.unused.contains(setting)));
        let Some(setting) = unused.first() else { return Ok(()) };
        let models = systems.iter().flat_map(|system| &system.parts).map(|part| part.model);
        let known: BTreeSet<String> =
            models.flat_map(ModelType::variables).map(|(_, variable)| variable.path.to_string()).collect();
        let variable = setting.name.split_once('.').map_or(setting.name.as_str(), |(part, variable)| {
            let is_part = systems.iter().flat_map(|system| &system.parts).any(|known| known.name == part);
            if is_part { variable } else { setting.name.as_str() }
        });
        Err(Fault::unknown("variable of the system", variable, known.iter().map(String::as_str)))
    }

    fn add(&mut self, name: &str, part: &PartDescription, law: Option<&str>) -> Result<(), Fault> {
        let model = match (&part.model, &part.law) {
            (Some(model), None) => model_named(model)?,
            (None, Some(default)) => slot::law(law.unwrap_or(default))?,
            _ => return Err(Fault::value(format_args!("part '{name}': must have either model or law"))),
        };
        let is_law = part.law.is_some();
        let row = model.table.iter().map(|variable| variable.start).collect();
        let mut made = Part { name: name.to_owned(), model, row, is_law, set: BTreeSet::new() };
        if let Some(preset) = &part.preset {
            made.apply(preset)?;
        }
        for (variable, value) in &part.set {
            if is_law && model.find(variable).is_none() {
                continue;
            }
            made.set(variable, &value.to_string())?;
        }
        if is_law {
            self.law = Some(model);
            for (law, values) in &self.description.law {
                slot::law(law)?;
                if law == model.name {
                    for (variable, value) in values {
                        made.set(variable, &value.to_string())?;
                    }
                }
            }
        }
        self.parts.push(made);
        Ok(())
    }

    /// Chooses the law of parts that contain one, such as a strut.
    fn choose(&mut self, law: &str) -> Result<(), Fault> {
        if self.description.choose_law.is_empty() {
            return Err(Fault::value(format_args!("the law {law} has no place: no part of the system is a law")));
        }
        for choice in self.description.choose_law.clone() {
            let (part, variable) = self.split(&choice)?;
            self.parts[part].set(variable, law)?;
        }
        self.law = Some(slot::law(law)?);
        Ok(())
    }

    /// The part and the variable that a name such as `rig.mass` means.
    fn split<'a>(&self, name: &'a str) -> Result<(usize, &'a str), Fault> {
        let (part, variable) =
            name.split_once('.').ok_or_else(|| Fault::value(format_args!("'{name}': must be part.variable")))?;
        let number = self.parts.iter().position(|known| known.name == part);
        let known = || self.parts.iter().map(|part| part.name.as_str());
        Ok((number.ok_or_else(|| Fault::unknown("part", part, known()))?, variable))
    }

    /// The variable that a name means; of a law in the plane or in space the component along x.
    pub fn place(&self, name: &str) -> Result<Place, Fault> {
        let (part, variable) = self.split(name)?;
        let Part { model, is_law, .. } = self.parts[part];
        let found = if is_law { slot::along(model, variable) } else { None };
        let column = found.map_or_else(|| column(model, &self.parts[part].name, variable), Ok)?;
        Ok(Place { part, column })
    }

    /// The source that a name means: a variable, or `der(...)` of a state.
    pub fn source(&self, name: &str) -> Result<WireSource, Fault> {
        let Some(state) = name.strip_prefix("der(").and_then(|rest| rest.strip_suffix(')')) else {
            return Ok(WireSource::Variable(self.place(name)?));
        };
        let place = self.place(state)?;
        if !self.variable(place).is_continuous_state() {
            return Err(Fault::value(format_args!("{name}: {state} is not a state that moves with time")));
        }
        Ok(WireSource::Derivative(place))
    }

    /// Full name of a variable.
    pub fn name(&self, place: Place) -> String {
        format!("{}.{}", self.parts[place.part].name, self.variable(place).path)
    }

    /// The declaration of a variable.
    pub fn variable(&self, place: Place) -> Variable {
        self.parts[place.part].model.table.at(place.column)
    }

    /// The input that a name means; none if a law does not have it.
    fn input(&self, name: &str) -> Result<Option<Place>, Fault> {
        let (part, variable) = self.split(name)?;
        if self.parts[part].is_law && slot::along(self.parts[part].model, variable).is_none() {
            return Ok(None);
        }
        let place = self.place(name)?;
        if self.variable(place).role != Role::Input {
            return Err(Fault::value(format_args!("{name} is not an input")));
        }
        if self.source_of(place).is_some() {
            return Err(Fault::value(format_args!("{name} has two sources")));
        }
        Ok(Some(place))
    }

    /// What an input gets its values from, for messages.
    fn source_of(&self, place: Place) -> Option<String> {
        let wire = self.wires.iter().find(|wire| wire.to == place).map(|wire| match wire.from {
            WireSource::Variable(from) => self.name(from),
            WireSource::Derivative(from) => format!("der({})", self.name(from)),
        });
        wire.or_else(|| self.signals.iter().any(|(to, _)| *to == place).then(|| "a signal".to_owned()))
    }

    fn connect(&mut self, input: &str, output: &str) -> Result<(), Fault> {
        let Some(to) = self.input(input)? else { return Ok(()) };
        let from = self.source(output)?;
        if let WireSource::Variable(place) = from
            && !self.variable(place).role.is_output()
        {
            return Err(Fault::value(format_args!("{output} is not an output")));
        }
        let [to_unit, from_unit] = [self.unit(WireSource::Variable(to)), self.unit(from)];
        if to_unit.exponents != from_unit.exponents {
            let [to_unit, from_unit] = [to_unit.name, from_unit.name];
            return Err(Fault::Unit { to: input.to_owned(), to_unit, from: output.to_owned(), from_unit });
        }
        self.wires.push(Wire { from, to });
        Ok(())
    }

    /// Unit of a source.
    pub fn unit(&self, source: WireSource) -> Dimension {
        match source {
            WireSource::Variable(place) => Dimension::of(&self.variable(place)),
            WireSource::Derivative(place) => Dimension::of(&self.variable(place)).per_second(),
        }
    }

    /// The signal of an input, with points from files and rates of other signals.
    fn moved(&self, input: &str, signal: &Signal, folder: &Path, rates: usize) -> Result<Signal, Fault> {
        let Signal::Course(Course::RateOf(other)) = signal else {
            // A law may not have the input whose rate another one is.
            let place = self.place(input).ok();
            let unit = place.map_or(String::new(), |place| self.unit(WireSource::Variable(place)).name);
            return signal.loaded(folder, &unit).map_err(|error| prefixed(input, error));
        };
        let known = self.description.input.keys().map(String::as_str);
        let found = self.description.input.get(other).ok_or_else(|| Fault::unknown("signal", other, known))?;
        if rates == 0 {
            return Err(Fault::value(format_args!("{input}: {other} is itself the rate of a rate of a signal")));
        }
        Ok(self.moved(other, found, folder, rates - 1)?.rate())
    }

    /// Sets a variable of the part that has it; hosts come before laws.
    fn set(&mut self, setting: &Setting) -> Result<(), Fault> {
        if let Some((part, _)) = setting.name.split_once('.')
            && self.parts.iter().any(|known| known.name == part)
        {
            let (part, variable) = self.split(&setting.name)?;
            let Part { model, is_law, .. } = self.parts[part];
            if is_law && model.find(variable).is_none() {
                self.unused.push(setting.clone());
                return Ok(());
            }
            return self.set_in(part, variable, &setting.value);
        }
        let has = |part: &&usize| self.parts[**part].model.find(&setting.name).is_some();
        let numbers: Vec<usize> = (0..self.parts.len()).collect();
        let hosts: Vec<usize> = numbers.iter().filter(has).filter(|part| !self.parts[**part].is_law).copied().collect();
        let laws: Vec<usize> = numbers.iter().filter(has).filter(|part| self.parts[**part].is_law).copied().collect();
        match (hosts.as_slice(), laws.as_slice()) {
            ([part], _) => self.set_in(*part, &setting.name, &setting.value),
            ([], []) => {
                self.unused.push(setting.clone());
                Ok(())
            }
            ([], laws) => laws.iter().try_for_each(|part| self.set_in(*part, &setting.name, &setting.value)),
            (hosts, _) => {
                let names: Vec<String> =
                    hosts.iter().map(|part| format!("{}.{}", self.parts[*part].name, setting.name)).collect();
                Err(Fault::value(format_args!("'{}' can mean {}", setting.name, names.join(" or "))))
            }
        }
    }

    fn set_in(&mut self, part: usize, variable: &str, value: &str) -> Result<(), Fault> {
        let place = Place { part, column: column(self.parts[part].model, &self.parts[part].name, variable)? };
        if self.variable(place).role != Role::Input {
            return self.parts[part].set(variable, value);
        }
        if let Some(wire) = self.wires.iter().find(|wire| wire.to == place) {
            let from = match wire.from {
                WireSource::Variable(from) | WireSource::Derivative(from) => self.name(from),
            };
            return Err(Fault::value(format_args!("{} comes from {from} and cannot be set", self.name(place))));
        }
        let constant = Signal::Constant(spelled(&self.variable(place), value)?);
        match self.signals.iter_mut().find(|(to, _)| *to == place) {
            Some((_, signal)) => *signal = constant,
            None => self.signals.push((place, constant)),
        }
        Ok(())
    }

    /// Start values that follow other variables.
    fn follow(&mut self) -> Result<(), Fault> {
        for (to, from) in self.description.start.clone() {
            let [to, from] = [self.place(&to)?, self.place(&from)?];
            let signal = self.signals.iter().find(|(place, _)| *place == from).map(|(_, signal)| signal.at(0.0).0);
            let value = signal.unwrap_or(self.parts[from.part].row[from.column]);
            self.parts[to.part].follow(to.column, value);
        }
        Ok(())
    }

    /// Open inputs, values of signals at the beginning, parameters that do not fit together.
    fn check(&mut self) -> Result<(), Fault> {
        for part in 0..self.parts.len() {
            for column in 0..self.parts[part].model.table.len() {
                let place = Place { part, column };
                let variable = self.variable(place);
                if variable.role != Role::Input || self.source_of(place).is_some() {
                    continue;
                }
                let value = self.parts[part].open(column).ok_or_else(|| Fault::Open { input: self.name(place) })?;
                self.signals.push((place, Signal::Constant(value)));
            }
        }
        for (place, signal) in &self.signals {
            let (variable, value) = (self.variable(*place), signal.at(0.0).0);
            if !variable.admits(value) {
                return Err(prefixed(&self.parts[place.part].name, Fault::value(variable.fault(value).0)));
            }
            self.parts[place.part].row[place.column] = value;
        }
        for (place, signal) in &self.signals {
            if matches!(signal, Signal::Constant(0.0)) && self.parts[place.part].balances(place.column) {
                return Err(Fault::Unbalanced { input: self.name(*place) });
            }
        }
        for part in &self.parts {
            part.model.check(&part.row).map_err(|fault| prefixed(&part.name, Fault::value(fault.0)))?;
        }
        Ok(())
    }
}

/// Rates of rates that a signal may be.
const MOST_RATES: usize = 2;

/// A description whose signals have the settings meant for them, such as `strut.length.amplitude`, and the others.
fn tuned(description: &Description, settings: &[Setting]) -> Result<(Description, Vec<Setting>), Fault> {
    let (mut description, mut others) = (description.clone(), Vec::new());
    for setting in settings {
        let named = setting.name.rsplit_once('.');
        let moving = named.and_then(|(input, property)| {
            let signal = description.input.get_mut(input)?;
            (!signal.properties().is_empty()).then_some((signal, input, property))
        });
        let Some((signal, input, property)) = moving else {
            others.push(setting.clone());
            continue;
        };
        let known: Vec<&str> = signal.properties().iter().map(|(name, _)| *name).collect();
        let mut properties = signal.properties();
        let place = properties.iter_mut().find(|(name, _)| *name == property);
        let (_, place) =
            place.ok_or_else(|| Fault::unknown(format!("property of the signal {input}"), property, known))?;
        **place = setting.number()?.1;
    }
    Ok((description, others))
}

fn prefixed(name: &str, fault: Fault) -> Fault {
    Fault::value(format_args!("{name}: {fault}"))
}

fn model_named(name: &str) -> Result<&'static ModelType, Fault> {
    let models = || stribeck::catalogue::models();
    stribeck::catalogue::by_name(name).ok_or_else(|| Fault::unknown("model", name, models().map(|model| model.name)))
}

impl Part {
    /// Value of an input without a source: across the slip of a law 0; the start value of one on which nothing depends.
    fn open(&self, input: usize) -> Option<f64> {
        let variable = self.model.table.at(input);
        let across = slot::across(&variable.path.to_string()).filter(|_| self.is_law);
        let is_driven = || variable.meaning != Meaning::Acceleration && drives(self.model, &self.row, input);
        let is_idle = || !self.uses(input) && !is_driven();
        across.or_else(|| is_idle().then_some(variable.start))
    }

    /// Whether an output depends on an input of either sign while the contact slides or rests.
    pub fn uses(&self, input: usize) -> bool {
        is_used(self.model, &self.row, input)
    }

    /// Whether an input is the external force by which a law knows how the contact slides.
    fn balances(&self, input: usize) -> bool {
        let name = AccelerationSource::CHOICES.name;
        let is_balance = |(column, variable): (usize, Variable)| {
            matches!(variable.kind, Kind::Enumeration(choices) if choices.name == name)
                && AccelerationSource::Balance.is(self.row[column])
        };
        self.model.table.at(input).meaning == Meaning::ExternalForce
            && self.model.variables().any(is_balance)
            && self.uses(input)
    }

    /// Gives a column a value unless it was set.
    pub fn follow(&mut self, column: usize, value: f64) {
        if !self.set.contains(&column) {
            self.row[column] = value;
        }
    }

    /// Value of a column at the beginning; an output follows from the others.
    pub fn known(&self, column: usize) -> f64 {
        let mut row = self.row.clone();
        self.model.output(&mut row);
        row[column]
    }

    fn set(&mut self, variable: &str, value: &str) -> Result<(), Fault> {
        let column = column(self.model, &self.name, variable)?;
        let declared = &self.model.table.at(column);
        if declared.role == Role::Output {
            return Err(Fault::value(format_args!("{}.{variable} is computed and cannot be set", self.name)));
        }
        self.row[column] = spelled(declared, value).map_err(|fault| prefixed(&self.name, fault))?;
        self.set.insert(column);
        Ok(())
    }

    fn apply(&mut self, preset: &str) -> Result<(), Fault> {
        let known = || self.model.presets.iter();
        let found = known().find(|known| known.name == preset);
        let found = found.ok_or_else(|| {
            Fault::unknown(format!("preset of {}", self.model.name), preset, known().map(|known| known.name))
        })?;
        for (variable, value) in found.values {
            self.set(variable, &value.to_string())?;
        }
        Ok(())
    }
}

/// Unit of a variable or of a time derivative.
#[derive(Clone, Debug, PartialEq)]
pub struct Dimension {
    /// Name.
    pub name: String,
    /// Exponents of kg, m, s, A, K, rad.
    pub exponents: [i8; 6],
}

impl Dimension {
    fn of(variable: &Variable) -> Dimension {
        match variable.kind {
            Kind::Real(unit) => Dimension { name: unit.name.to_owned(), exponents: unit.exponents() },
            _ => Dimension { name: "1".to_owned(), exponents: [0; 6] },
        }
    }

    fn per_second(self) -> Dimension {
        let mut exponents = self.exponents;
        exponents[2] -= 1;
        let known = stribeck::unit::UNITS.iter().find(|unit| unit.exponents() == exponents);
        Dimension { name: known.map_or_else(|| format!("{}/s", self.name), |unit| unit.name.to_owned()), exponents }
    }
}
