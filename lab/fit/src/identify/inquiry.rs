//! An identification as a user describes it: the records, what is known of the rig, the laws, and how they are fitted.
//!
//! The command line, files, Python and the page all describe it so. What it means, the defaults, and what contradicts
//! itself are stated here alone.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::{Args, ValueEnum};
use serde::{Deserialize, Serialize};
use stribeck::model::ModelType;
use stribeck_solve::job::{self, Entry, Spelled};
use stribeck_solve::system::Fault;
use toml::Value;
use ts_rs::TS;

use super::judgement::{Given, judge_held};
use super::map::{self, FrictionMap, MapColumns};
use super::{
    Experiment, Led, Method, Ports, Ranking, Selection, Settings, Watch, axis, fit_all, held_out, laws_named, names,
    parameter,
};
use stribeck_measured::{Columns, Delay, Drive, MeasuredError, Record, Setup};
use stribeck_sheet::{
    DISPLACEMENT, FORCE, NO_SHEETS, Quantity, Sheet, SheetError, TIME, VELOCITY, has_sheets, of_file, tables,
};

/// Records, what is known of their rig, the laws, and how they are fitted.
#[derive(Args, Clone, Debug, Default, Deserialize, PartialEq, Serialize, TS)]
#[serde(deny_unknown_fields, default)]
#[ts(optional_fields)]
pub struct Inquiry {
    /// Records: tables with time, force, and displacement or velocity, perhaps normal_force; units in brackets. Without
    /// time and displacement they are maps of friction at constant speed
    #[serde(deserialize_with = "job::names")]
    pub records: Vec<PathBuf>,
    /// Name of a column in the records: force=Kraft_1; in binary files (.mf4, .mat) that of a channel or variable
    #[arg(long, value_name = "NAME=COLUMN")]
    #[serde(with = "job::table")]
    #[ts(type = "Record<string, string>")]
    pub column: Vec<Entry<String>>,
    /// Sheet of a spreadsheet (default: the first one with a table)
    #[arg(long, value_name = "NAME")]
    pub sheet: Option<String>,
    /// Factor of a column: force=35.15 if it has volts of an amplifier with 35.15 N/V, displacement=-1 if it is reversed
    #[arg(long, value_name = "NAME=FACTOR", allow_hyphen_values = true)]
    #[serde(with = "job::table")]
    #[ts(type = "Record<string, number>")]
    pub scale: Vec<Entry<f64>>,
    /// The records are of a joint: columns without a unit are in N m, rad and rad/s
    #[arg(long)]
    pub joint: bool,
    /// Torque constant of the motor of a joint in N m/A: its current, in A, stands in the column of the force
    #[arg(long, value_name = "CONSTANT", allow_hyphen_values = true)]
    pub torque_constant: Option<f64>,
    /// Turns of the motor for one of the joint: torque or current are of the motor, and their column is multiplied by it
    #[arg(long, value_name = "RATIO", allow_hyphen_values = true)]
    pub gear_ratio: Option<f64>,
    /// Columns of the motor, before the gear: force, displacement, velocity (default: force, with --gear-ratio)
    #[arg(long, value_name = "NAME", num_args = 1.., value_delimiter = ',')]
    #[serde(deserialize_with = "job::names")]
    pub motor_side: Vec<String>,
    /// Table of the motion on its own clock (a camera), for a single record
    #[arg(long, value_name = "FILE")]
    pub motion: Option<PathBuf>,
    /// Friction laws or components; several, or `all` laws, are ranked (default: none; for an axis CoulombViscous)
    #[arg(long, alias = "laws", num_args = 1.., value_delimiter = ',')]
    #[serde(deserialize_with = "job::names")]
    pub law: Vec<String>,
    /// The records are of an axis, M a = F - f - offset: fit mass and offset too, with Coulomb and viscous friction
    /// unless a law is given, at a normal force of 1 N unless one is known
    #[arg(long)]
    pub axis: bool,
    /// Mass between load cell and contact in kg (default: 0)
    #[arg(long)]
    pub mass: Option<f64>,
    /// Normal force in N, if the record has none
    #[arg(long)]
    pub normal_force: Option<f64>,
    /// Window in s for smoothing and differentiating the motion, 0 for the shortest of 7 samples (default: up to 391
    /// samples, at most a tenth of the record, with the least error of velocity and acceleration; for an axis 9 to 191
    /// samples, force and motion alike, 0 for 3)
    #[arg(long)]
    pub window: Option<f64>,
    /// Delay of the motion behind the force in s; or `find`, or `find:LONGEST` (default: 0; for an axis that of a
    /// controller, up to two samples, is found)
    #[arg(long)]
    #[ts(type = "number | string", optional)]
    pub delay: Option<DelayChoice>,
    /// Seconds at the start of the records that are skipped (default: 0)
    #[arg(long)]
    pub skip: Option<f64>,
    /// Speed in m/s below which samples are left out (default: three times the error of the velocity, and for Coulomb and
    /// viscous friction of an axis a twentieth of the highest speed; 0 for none)
    #[arg(long)]
    pub rest: Option<f64>,
    /// Parameter that is held, in those of several laws that have it: sigma_1=0; also mass and offset of the rig, gravity_cos and gravity_sin
    #[arg(long, value_name = "NAME=VALUE")]
    #[serde(with = "job::table")]
    #[ts(type = "Record<string, number>")]
    pub fix: Vec<Entry<f64>>,
    /// Additional parameter to fit: an exponent, mass, offset; gravity of the arm of a joint
    #[arg(long, value_name = "NAME", num_args = 1.., value_delimiter = ',')]
    #[serde(deserialize_with = "job::names")]
    pub fit: Vec<String>,
    /// Parameter that has the value of another one of its law: mu_k_backward=mu_k_forward
    #[arg(long, value_name = "NAME=OTHER")]
    #[serde(with = "job::table")]
    #[ts(type = "Record<string, string>")]
    pub tie: Vec<Entry<String>>,
    /// Range of a parameter instead of the one that follows from the data
    #[arg(long, value_name = "NAME=LOW:HIGH")]
    #[serde(with = "job::table")]
    #[ts(type = "Record<string, [number, number]>")]
    pub range: Vec<Entry<[f64; 2]>>,
    /// Search over the whole range (default: evolution)
    #[arg(long, value_enum)]
    pub method: Option<Method>,
    /// Cost of a residual: squares, or less for outliers (default: squares)
    #[arg(long, value_enum)]
    pub loss: Option<LossChoice>,
    /// Validation records, which are not fitted: the laws are held against them
    #[arg(long, value_name = "FILE", num_args = 1..)]
    #[serde(deserialize_with = "job::names")]
    pub hold_out: Vec<PathBuf>,
    /// Cross-validation: fit all parts of the records but one, in turn, and hold the law against that part (default: none)
    #[arg(long, value_name = "PARTS")]
    pub folds: Option<usize>,
    /// Evaluations of the law in a search over the whole range, before least squares; at least those of its first
    /// generations are made, 48 or 16 for each parameter, 62 by the genetic algorithm (default: 3000)
    #[arg(long)]
    pub budget: Option<u64>,
    /// Values that are judged beside the fit of the same law: a preset of the law, or a parameter set (.toml, .csv, .ssv)
    #[arg(long, value_name = "PRESET|FILE")]
    pub reference: Option<String>,
    /// Values that are judged while nothing is fitted: a preset, or a parameter set (.toml, .csv, .ssv); what it does not
    /// name has its start value
    #[arg(long, value_name = "PRESET|FILE")]
    pub evaluate: Option<String>,
    /// Seed of the search and of the repetitions (default: 1)
    #[arg(long)]
    pub seed: Option<u64>,
    /// Repetitions with blocks of residuals (default: 40)
    #[arg(long)]
    pub repetitions: Option<usize>,
}

/// Cost of a residual.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize, ValueEnum, TS)]
#[serde(rename_all = "kebab-case")]
pub enum LossChoice {
    /// Half the squares
    Squares,
    /// Squares of small residuals, magnitudes of those well above 1.3 times the noise
    Robust,
}

/// Delay of the motion behind the force: a number in s, `find`, or `find:LONGEST`.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
#[serde(try_from = "Value", into = "Value")]
pub enum DelayChoice {
    /// In s.
    Known(f64),
    /// To be found; the longest one, in s.
    Find(Option<f64>),
}

impl FromStr for DelayChoice {
    type Err = Fault;

    fn from_str(text: &str) -> Result<DelayChoice, Fault> {
        let wrong = |_| Fault::value(format_args!("delay = {text}: must be a number in s, find, or find:LONGEST"));
        Ok(match text.split_once(':') {
            Some(("find", longest)) => DelayChoice::Find(Some(f64::spelled("delay", longest.trim()).map_err(wrong)?)),
            None if text == "find" => DelayChoice::Find(None),
            _ => DelayChoice::Known(f64::spelled("delay", text.trim()).map_err(wrong)?),
        })
    }
}

impl TryFrom<Value> for DelayChoice {
    type Error = Fault;

    fn try_from(value: Value) -> Result<DelayChoice, Fault> {
        value.as_str().map_or_else(|| value.to_string().parse(), str::parse)
    }
}

impl From<DelayChoice> for Value {
    fn from(delay: DelayChoice) -> Value {
        match delay {
            DelayChoice::Known(delay) => delay.into(),
            DelayChoice::Find(None) => "find".into(),
            DelayChoice::Find(Some(longest)) => format!("find:{longest:?}").into(),
        }
    }
}

/// Where the tables of records come from.
pub trait Source {
    /// The tables of a record, one for each of its clocks; of a spreadsheet that of a sheet.
    fn tables(&self, record: &Path, sheet: Option<&str>) -> Result<Vec<Sheet>, SheetError>;

    /// Refuses columns that are used and are no numbers, once columns have the names of their quantities.
    fn check(&self, _record: &Path, _table: &Sheet, _is_used: &dyn Fn(&str) -> bool) -> Result<(), Fault> {
        Ok(())
    }
}

/// Records in files.
#[derive(Clone, Copy, Debug)]
pub struct Files;

impl Source for Files {
    fn tables(&self, record: &Path, sheet: Option<&str>) -> Result<Vec<Sheet>, SheetError> {
        tables(record, sheet)
    }
}

/// The data of an identification.
#[derive(Clone, Debug)]
pub struct Data {
    /// The records that are fitted, by their names.
    pub records: Vec<(String, Record)>,
    /// The same as the laws are led through them.
    pub experiments: Vec<Experiment>,
    /// Maps that are fitted instead of records, by their names.
    pub maps: Vec<(String, FrictionMap)>,
    /// Those that are not fitted.
    pub validation: Vec<Experiment>,
}

impl Inquiry {
    fn mass(&self) -> f64 {
        self.mass.unwrap_or(0.0)
    }

    /// The rig.
    pub(super) fn setup(&self) -> Setup {
        let delay = match self.delay {
            Some(DelayChoice::Known(delay)) => Delay::Known(delay),
            Some(DelayChoice::Find(longest)) => Delay::Find(longest.unwrap_or(Delay::LONGEST)),
            None if self.axis => Delay::OfController,
            None => Delay::Known(0.0),
        };
        let normal_force = self.normal_force.or(self.axis.then_some(axis::NORMAL_FORCE)).or(self.without_load());
        let (mass, window, skip) = (self.mass(), self.window, self.skip.unwrap_or(0.0));
        let has_gravity = parameter::has_gravity(&self.selection());
        let is_elastic = self.laws().is_ok_and(|laws| laws.iter().any(|law| !has_load(law)));
        let (is_axis, further) = (self.axis, self.further());
        Setup { mass, normal_force, window, delay, skip, is_axis, has_gravity, is_elastic, further }
    }

    /// Normal force where no law has one.
    fn without_load(&self) -> Option<f64> {
        let laws = self.laws().unwrap_or_default();
        (!laws.is_empty() && !laws.iter().any(|law| has_load(law))).then_some(0.0)
    }

    /// Columns by which a record may lead the laws, each with its law, without those that are held, fitted or tied.
    fn led(&self) -> Vec<(&'static ModelType, Led)> {
        let laws = self.laws().unwrap_or_default();
        let all = laws
            .into_iter()
            .flat_map(|law| Ports::of(law).into_iter().flat_map(|ports| ports.led).map(move |led| (law, led)));
        let selection = self.selection();
        let is_left = |name: &str| selection.fixed(name).is_none() && !selection.fits(name) && !selection.is_tied(name);
        all.filter(|(_, led)| is_left(led.name)).collect()
    }

    /// The quantities of these.
    fn further(&self) -> Vec<Quantity> {
        let mut found: Vec<Quantity> =
            self.led().iter().filter_map(|(_, led)| Quantity::of(led.name, led.unit)).collect();
        found.sort_by_key(|quantity| quantity.name);
        found.dedup_by_key(|quantity| quantity.name);
        found
    }

    fn columns(&self) -> Result<Columns, Fault> {
        let names = self.column.iter().map(|Entry(name, column)| (name.clone(), column.clone())).collect();
        let (torque_constant, gear_ratio) = (self.torque_constant, self.gear_ratio);
        let drive = Drive { torque_constant, gear_ratio, motor_side: self.motor_side.clone() };
        let further = self.further();
        let columns = Columns { names, factors: pairs(&self.scale), drive, is_joint: self.joint, further };
        columns.check().map_err(Fault::value)?;
        Ok(columns)
    }

    /// The laws.
    pub fn laws(&self) -> Result<Vec<&'static ModelType>, Fault> {
        match self.law.as_slice() {
            [] if self.axis => laws_named(&[axis::LAW.to_owned()]),
            [] => Err(Fault::value("no law was given")),
            names => laws_named(names),
        }
    }

    fn selection(&self) -> Selection {
        let tied = self.tie.iter().map(|Entry(name, other)| (name.clone(), other.clone())).collect();
        Selection {
            fixed: pairs(&self.fix),
            fitted: self.fit.clone(),
            ranges: pairs(&self.range),
            tied,
            is_offset_usual: false,
        }
    }

    /// How they are fitted.
    pub fn settings(&self) -> Result<Settings, Fault> {
        self.refuse_contradictions()?;
        let mut selection = self.selection();
        if self.axis {
            axis::fitted(&mut selection, self.mass());
        }
        let usual = Settings::default();
        Ok(Settings {
            selection,
            method: self.method.unwrap_or(usual.method),
            seed: self.seed.unwrap_or(usual.seed),
            budget: self.budget.unwrap_or(usual.budget),
            repetitions: self.repetitions.unwrap_or(usual.repetitions),
            mass: self.mass(),
            is_robust: self.loss == Some(LossChoice::Robust),
            folds: self.folds.unwrap_or(usual.folds),
            ..usual
        })
    }

    /// Refuses values that no law has, and an evaluation that is to fit something, before the search.
    pub fn check_given(&self) -> Result<(), Fault> {
        let laws = self.laws()?;
        for text in self.reference.iter().chain(&self.evaluate) {
            Given(text).values(&laws)?;
        }
        let others = [
            ("reference", self.reference.is_some()),
            ("fit", !self.fit.is_empty()),
            ("range", !self.range.is_empty()),
            ("folds", self.folds.is_some()),
        ];
        match others.into_iter().find(|(_, is_given)| self.evaluate.is_some() && *is_given) {
            Some((other, _)) => {
                Err(Fault::value(format_args!("evaluate: nothing is fitted, which {other} contradicts")))
            }
            None => Ok(()),
        }
    }

    /// Refuses a parameter that is held at two values, or held and fitted.
    pub fn refuse_contradictions(&self) -> Result<(), Fault> {
        for Entry(name, value) in &self.fix {
            let contradicts =
                |other: String| Err(Fault::value(format_args!("fix {name} = {value} contradicts {other}")));
            if let Some(mass) = self.mass.filter(|mass| name == "mass" && mass != value) {
                return contradicts(format!("mass = {mass}"));
            }
            if self.fit.contains(name) {
                return contradicts(format!("fit {name}"));
            }
            if let Some(Entry(_, other)) = self.fix.iter().find(|Entry(known, other)| known == name && other != value) {
                return contradicts(format!("fix {name} = {other}"));
            }
        }
        Ok(())
    }

    /// Refuses a file that is given twice: it would count twice, or be held against itself.
    fn refuse_twice(&self) -> Result<(), Fault> {
        let records = self.records.iter().map(|path| (path, false));
        let mut known: Vec<(PathBuf, bool)> = Vec::new();
        for (path, is_held_out) in records.chain(self.hold_out.iter().map(|path| (path, true))) {
            // A file that is not there is refused when it is read.
            let Ok(real) = path.canonicalize() else { continue };
            if let Some((_, was_held_out)) = known.iter().find(|(other, _)| *other == real) {
                let why = if is_held_out == *was_held_out { "is given twice" } else { "is a record and held out too" };
                return Err(Fault::File(format!("{}: {why}", path.display())));
            }
            known.push((real, is_held_out));
        }
        Ok(())
    }

    /// The records with their names, and the validation records. An error if they are maps, which have no motion.
    pub fn records(&self, from: &dyn Source) -> Result<[Vec<(String, Record)>; 2], Fault> {
        let [own, others] = self.tables(from)?;
        Ok([records(own)?, records(others)?])
    }

    /// The tables with their names, and those of the validation.
    pub fn tables(&self, from: &dyn Source) -> Result<[Vec<(String, Table)>; 2], Fault> {
        if self.records.is_empty() {
            return Err(Fault::value("no record was given"));
        }
        self.refuse_twice()?;
        let files: Vec<&Path> = self.records.iter().chain(&self.hold_out).map(PathBuf::as_path).collect();
        if self.motion.is_some() && files.len() > 1 {
            return Err(Fault::value("motion: is for a single record"));
        }
        if self.sheet.is_some() && !files.iter().copied().chain(self.motion.as_deref()).any(has_sheets) {
            return Err(Fault::value(NO_SHEETS));
        }
        let mut names = names(&files).into_iter();
        let mut named = |files: &[PathBuf]| {
            let read = |(path, name): (&PathBuf, String)| Ok((name, self.table(path, from)?));
            files.iter().zip(names.by_ref()).map(read).collect::<Result<Vec<_>, Fault>>()
        };
        Ok([named(&self.records)?, named(&self.hold_out)?])
    }

    /// The tables of a file.
    fn read(&self, path: &Path, from: &dyn Source) -> Result<Vec<Sheet>, Fault> {
        let sheet = self.sheet.as_deref().filter(|_| has_sheets(path));
        from.tables(path, sheet).map_err(|error| unreadable(path, &error))
    }

    fn table(&self, path: &Path, from: &dyn Source) -> Result<Table, Fault> {
        let own = self.read(path, from)?;
        let is_map = !self.axis && self.motion.is_none() && self.columns()?.are_of_map(&own);
        let map = if is_map { own.into_iter().next() } else { return self.record(path, own, from).map(Table::record) };
        map.map_or_else(|| Err(Fault::value("no table")), |table| self.map(path, table, from)).map(Table::Map)
    }

    fn map(&self, path: &Path, mut table: Sheet, from: &dyn Source) -> Result<FrictionMap, Fault> {
        self.refuse_load()?;
        let (setup, columns) = (self.setup(), self.columns()?);
        let refused = |error: MeasuredError| match error {
            MeasuredError::NoLoad => unreadable(path, &format!("{error}; {}", map::LOAD)),
            error => unreadable(path, &with_remedy(&error, &columns)),
        };
        map::refuse_unheeded(self).map_err(|fault| unreadable(path, &fault))?;
        let (movement, mut said) = columns.apply_to_map(&mut table, &setup).map_err(refused)?;
        from.check(path, &table, &|quantity| columns.knows(quantity))?;
        let conditions = self.refuse_led(&table).and_then(|()| self.conditions(&table));
        said.extend(conditions.map_err(|error| unreadable(path, &error))?);
        let columns = MapColumns::of(&table, &setup, movement).map_err(refused)?;
        FrictionMap::of(columns, said).map_err(|fault| unreadable(path, &fault))
    }

    fn record(&self, path: &Path, mut own: Vec<Sheet>, from: &dyn Source) -> Result<Record, Fault> {
        self.refuse_load()?;
        let (setup, columns) = (self.setup(), self.columns()?);
        let read = |path: &Path| self.read(path, from);
        let mut motion = self.motion.as_deref().map(read).transpose()?.unwrap_or_default();
        let refused = |error: MeasuredError| match (error, &self.motion) {
            (MeasuredError::Motion(error), Some(camera)) => unreadable(camera, &with_remedy(&error, &columns)),
            (error, _) => unreadable(path, &with_remedy(&error, &columns)),
        };
        let said = columns.apply(&mut own, &mut motion, &setup).map_err(refused)?;
        let is_elsewhere = |quantity: &str| self.motion.is_some() && is_of_motion(quantity);
        for table in &own {
            from.check(path, table, &|quantity| columns.knows(quantity) && !is_elsewhere(quantity))?;
        }
        for (camera, table) in self.motion.iter().flat_map(|camera| motion.iter().map(move |table| (camera, table))) {
            from.check(camera, table, &|quantity| quantity == TIME.name || is_of_motion(quantity))?;
        }
        let (own, others) = with_force(own);
        let conditions = self.conditions(&own).map_err(|error| unreadable(path, &error))?;
        // The channels of a file may have several clocks.
        let apart = if has_motion(&own) { None } else { with_motion(others) };
        let motion = with_motion(motion).or(apart);
        let mut record = Record::of(&own, motion.as_ref(), &setup).map_err(refused)?;
        record.quality.findings.splice(0..0, said.into_iter().chain(conditions));
        Ok(record)
    }

    /// Refuses a normal force that no law has.
    fn refuse_load(&self) -> Result<(), Fault> {
        match (self.normal_force, self.without_load(), &self.law[..]) {
            (Some(load), Some(_), laws) => {
                Err(Fault::value(format_args!("normal_force = {load}: {} has none: leave it out", laws.join(", "))))
            }
            _ => Ok(()),
        }
    }

    /// Refuses the columns of a map by which a record would lead a law.
    fn refuse_led(&self, table: &Sheet) -> Result<(), Fault> {
        match self.led().iter().find(|(_, led)| table.has(led.name)) {
            Some((_, Led { name, unit, .. })) => Err(Fault::value(format_args!(
                "column {name}: a map is of one {name}; --fix {name}=VALUE holds it, in {unit}"
            ))),
            None => Ok(()),
        }
    }

    /// Notes on start values that stand for conditions which a table lacks. An error for an input that it lacks.
    fn conditions(&self, table: &Sheet) -> Result<Vec<String>, Fault> {
        let missing = self.led().into_iter().filter(|(_, led)| !table.has(led.name));
        let said = |(law, Led { name, unit, column, is_input }): (&ModelType, Led)| {
            let law_name = law.name;
            if is_input {
                return Err(Fault::value(format_args!(
                    "{}: it drives {law_name}, in {unit}; --column {name}=NAME names it, --fix {name}=VALUE holds it",
                    table.missing(name)
                )));
            }
            let start = law.table.at(column).start;
            Ok(format!(
                "no column {name} [{unit}]: {law_name} has its start value, {start} {unit}, unless --fix {name}=VALUE holds \
                 another one"
            ))
        };
        missing.map(said).collect()
    }

    fn experiments(&self, tables: &[(String, Table)], laws: &[&'static ModelType]) -> Result<Vec<Experiment>, Fault> {
        let experiment = |(name, table): &(String, Table)| {
            let all = match table {
                Table::Record(record) => Experiment::new(name, record),
                Table::Map(map) => return map.experiment(name, self.rest),
            };
            match self.rest {
                Some(rest) => all.without_rest(rest),
                None if self.axis => axis::in_motion(all, laws),
                None => Ok(all),
            }
        };
        tables.iter().map(experiment).collect()
    }

    /// Reads the data.
    pub fn data(&self, from: &dyn Source) -> Result<Data, Fault> {
        let laws = self.laws()?;
        let [own, others] = self.tables(from)?;
        refuse_both(&own, &others)?;
        let [experiments, validation] = [self.experiments(&own, &laws)?, self.experiments(&others, &laws)?];
        let (mut records, mut maps) = (Vec::new(), Vec::new());
        for (name, table) in own {
            match table {
                Table::Record(record) => records.push((name, *record)),
                Table::Map(map) => maps.push((name, map)),
            }
        }
        Ok(Data { experiments, records, maps, validation })
    }

    /// Fits the laws, ranks them, and holds them against the validation records. `begin` hears of each law.
    pub fn fits(
        &self,
        data: &Data,
        begin: &mut (dyn FnMut(&'static ModelType) + Send),
        watch: Watch,
    ) -> Result<Ranking, Fault> {
        self.check_given()?;
        let (laws, task) = (self.laws()?, self.settings()?);
        let mut ranking = match &self.evaluate {
            Some(text) => Given(text).evaluated(&laws, &data.experiments, &task, watch)?,
            None => fit_all(&laws, &data.experiments, &task, begin, watch)?,
        };
        if let Some(text) = &self.reference {
            let values = Given(text).values(&laws)?;
            Given(text).judge(&mut ranking, &laws, &values, (&data.experiments, &task))?;
        }
        judge_held(&mut ranking);
        let best = ranking.best().law.name;
        // A law that is refused in other records has no figure there; the best one must have.
        for fit in &mut ranking.fits {
            match held_out(fit, &data.validation) {
                Ok(found) => fit.saw(found),
                Err(fault) if fit.law.name == best => return Err(fault),
                Err(fault) => ranking.refused.push((fit.law.name, format!("not validated: {fault}"))),
            }
        }
        Ok(ranking)
    }

    /// The same as a command line.
    pub fn command(&self) -> Result<String, Fault> {
        let records = job::shown(&self.records);
        let begin: Vec<&str> = ["stribeck", "identify"].into_iter().chain(records.iter().map(String::as_str)).collect();
        job::command_line(&begin, &self.options()?)
    }

    /// The same in Python.
    pub fn python(&self) -> Result<String, Fault> {
        let records = job::shown(&self.records).into_iter().map(Value::String).collect();
        let call = job::python_call("stribeck.identify", &[Value::Array(records)], &self.options()?);
        Ok(format!("import stribeck\n\nfound = {call}\nprint(found)\n"))
    }

    fn options(&self) -> Result<toml::Table, Fault> {
        let mut options = job::entries(self)?;
        options.remove("records");
        Ok(options)
    }
}

/// A table of measurements.
#[derive(Debug)]
pub enum Table {
    /// Force and motion over time.
    Record(Box<Record>),
    /// Friction at constant speed.
    Map(FrictionMap),
}

impl Table {
    fn record(record: Record) -> Table {
        Table::Record(Box::new(record))
    }
}

/// Records of a rig; refuses maps.
fn records(tables: Vec<(String, Table)>) -> Result<Vec<(String, Record)>, Fault> {
    let record = |(name, table): (String, Table)| match table {
        Table::Record(record) => Ok((name, *record)),
        Table::Map(_) => Err(Fault::value(format_args!(
            "{name}: has no column time, and is a map of friction at constant speed; a motion over time is needed"
        ))),
    };
    tables.into_iter().map(record).collect()
}

/// Refuses records beside maps: what both scatter by is not the same.
fn refuse_both(own: &[(String, Table)], others: &[(String, Table)]) -> Result<(), Fault> {
    let all = || own.iter().chain(others);
    let record = all().find(|(_, table)| matches!(table, Table::Record(_)));
    let map = all().find(|(_, table)| matches!(table, Table::Map(_)));
    match record.zip(map) {
        Some(((record, _), (map, _))) => Err(Fault::value(format_args!(
            "{map}: has no column time, and is a map of friction; {record} is a record: fit them one at a time"
        ))),
        None => Ok(()),
    }
}

fn pairs<T: Clone>(entries: &[Entry<T>]) -> Vec<(String, T)> {
    entries.iter().map(|Entry(name, value)| (name.clone(), value.clone())).collect()
}

/// An error about the tables of a file, with its name.
fn unreadable(path: &Path, error: &dyn std::fmt::Display) -> Fault {
    Fault::File(of_file(path, error))
}

/// Whether a law has a normal force.
fn has_load(law: &ModelType) -> bool {
    Ports::of(law).is_none_or(|ports| ports.load.is_some())
}

/// An error about a record; how to name a column that was not found.
fn with_remedy(error: &MeasuredError, columns: &Columns) -> String {
    match error {
        MeasuredError::Sheet(SheetError::Column { wanted, .. }) if columns.knows(wanted) => {
            format!("{error}; --column {wanted}=NAME names it, --scale {wanted}=FACTOR turns it into the SI unit")
        }
        _ => error.to_string(),
    }
}

/// Whether a table of the motion has a quantity besides the time.
fn is_of_motion(quantity: &str) -> bool {
    [DISPLACEMENT, VELOCITY].iter().any(|known| known.name == quantity)
}

fn has_motion(table: &Sheet) -> bool {
    [DISPLACEMENT, VELOCITY].iter().any(|quantity| table.has(quantity.name))
}

/// The table of the force, or the first one if none has a force; and the others.
fn with_force(mut tables: Vec<Sheet>) -> (Sheet, Vec<Sheet>) {
    let at = tables.iter().position(|table| table.has(FORCE.name)).unwrap_or(0);
    (tables.remove(at), tables)
}

/// The table of the motion, or the first one if none has a motion.
fn with_motion(mut tables: Vec<Sheet>) -> Option<Sheet> {
    let at = tables.iter().position(has_motion).unwrap_or(0);
    (!tables.is_empty()).then(|| tables.remove(at))
}
