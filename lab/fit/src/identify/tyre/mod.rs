//! Coefficients of the Magic Formula 5.2, or 6.1 with the inflation pressure, from a tyre test, as a tyre property file.
//!
//! The coefficients are found group by group, by bounded least squares with exact sensitivities: side force in pure side
//! slip (from several starts, which must agree), longitudinal force in pure longitudinal slip, aligning moment in pure
//! side slip, then what combined slip changes; and at last all of them together, each channel with the weight of its
//! noise. A coefficient that the test does not determine is held at the value that the format prescribes for a missing
//! one, 0, the others are fitted again, and it stays out of the file. Equations and axes are those of
//! [`stribeck::host::MagicFormula`].

mod coefficient;
mod columns;
mod file;
mod files;
mod inquiry;
mod left_out;
mod pressure;
mod problem;
#[cfg(test)]
mod tests;

use stribeck::host::{MagicFormula, Side};
use stribeck::model::{Columns, row_of, row_of_mut, start};

pub use columns::{Axes, PURE, Sample, TyreTest, TyreTestError};
pub use file::{property_file, table};
pub use inquiry::{FormulaChoice, Inquiry, SideChoice, TyreInquiryError};

use super::loss::Loss;
use super::uncertainty::{DETERMINED, Known, WIDTH, residuals};
use crate::tir::missing_value;
use coefficient::{Coefficient, GROUPS, Group, groups};
use left_out::by_residual;
use problem::{Channel, Rows, TyreProblem, column};
use stribeck_solve::system::Fault;

/// Known properties of a tyre besides the test.
#[derive(Clone, Debug, PartialEq)]
pub struct TyreTask {
    /// Radius without load, m.
    pub radius: f64,
    /// Nominal load of the set, N; the mean load of the test if it is not given.
    pub nominal_load: Option<f64>,
    /// Side of the car on which the tyre was tested.
    pub side: Side,
    /// Coefficients that are held, by their keys.
    pub fixed: Vec<(String, f64)>,
}

/// Verdict on a coefficient.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The test determines it: the half width of its interval of 95 %.
    Within(f64),
    /// It was held.
    Held,
    /// It is at an end of its range.
    AtEnd,
    /// The test does not determine it, for this reason.
    Not(String),
}

/// A coefficient after a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct TyreEstimate {
    /// Its key in a tyre property file.
    pub key: String,
    /// Its value; 0 if the test does not determine it.
    pub value: f64,
    /// Whether the test determines it.
    pub verdict: Verdict,
}

/// A tyre fitted to a test.
#[derive(Clone, Debug)]
pub struct TyreFit {
    /// The coefficients, in the order of the formula.
    pub estimates: Vec<TyreEstimate>,
    /// Notes on data that were ignored and on results that are doubtful, with the reason.
    pub notes: Vec<String>,
    /// For each measured channel its name, unit, RMS residual, and largest value.
    pub left: Vec<(&'static str, &'static str, f64, f64)>,
    /// The formula.
    pub formula: MagicFormula,
}

/// Coefficients without which nothing is left of their group.
const ESSENTIAL: [&[&str]; GROUPS] = [
    &["pcy1", "pdy1", "pky1", "pky2"],
    &["pcx1", "pdx1", "pkx1"],
    &["rbx1", "rcx1"],
    &["rby1", "rcy1"],
    &["qbz1", "qcz1", "qdz1"],
    &[],
];

/// Distance from an end of a range, as a part of it, that counts as the end (chosen).
const AT_END: f64 = 1e-4;

/// Shapes and curvatures of the side force from which it is fitted.
const STARTS: [[f64; 2]; 4] = [[1.2, -1.0], [1.4, 0.3], [1.7, -0.5], [1.6, -4.0]];

/// Fits a tyre to a test.
pub fn fit_tyre(test: &TyreTest, task: &TyreTask) -> Result<TyreFit, Fault> {
    let nominal = check(test, task)?;
    let formula = neutral(test, task, nominal);
    let (groups, notes) = (groups(test.version()), test.notes.clone());
    let mut fitter = Fitter { test, task, formula, groups, dropped: Vec::new(), kept: Vec::new(), notes };
    let where_all = |is_one: &dyn Fn(&Sample) -> bool, channel: Channel| -> Vec<usize> {
        channel.samples(test).into_iter().filter(|at| is_one(&test.samples[*at])).collect()
    };
    fitter.lateral(&where_all(&Sample::is_rolling, Channel::ForceY))?;
    let is_combined = test.samples.iter().any(|one| !one.is_rolling());
    let is_driven = is_combined && !Channel::ForceX.samples(test).is_empty();
    if is_driven {
        fitter.group(Group::Longitudinal, Channel::ForceX, &where_all(&Sample::is_straight, Channel::ForceX))?;
        fitter.group(Group::CombinedX, Channel::ForceX, &Channel::ForceX.samples(test))?;
    }
    if is_combined {
        fitter.group(Group::CombinedY, Channel::ForceY, &Channel::ForceY.samples(test))?;
    }
    if !Channel::MomentZ.samples(test).is_empty() {
        fitter.group(Group::Aligning, Channel::MomentZ, &where_all(&Sample::is_rolling, Channel::MomentZ))?;
        if is_driven {
            fitter.group(Group::Arm, Channel::MomentZ, &Channel::MomentZ.samples(test))?;
        }
    }
    fitter.together()
}

/// Refuses what no tyre has; the nominal load.
fn check(test: &TyreTest, task: &TyreTask) -> Result<f64, Fault> {
    if !(task.radius > 0.0 && task.radius.is_finite()) {
        return Err(Fault::value(format_args!("radius = {}: must be > 0 and finite, in m", task.radius)));
    }
    let mean = test.samples.iter().map(|one| one.load).sum::<f64>() / test.samples.len() as f64;
    let nominal = task.nominal_load.unwrap_or(mean);
    if !(nominal > 0.0 && nominal.is_finite()) {
        return Err(Fault::value(format_args!("nominal load = {nominal}: must be > 0 and finite, in N")));
    }
    let slips = test.samples.iter().filter(|one| one.force_y.is_some()).map(|one| one.side_slip.abs());
    let most = slips.fold(0.0, f64::max);
    for (key, value) in &task.fixed {
        let keys: Vec<String> = groups(test.version()).iter().flatten().map(|one| one.name.to_uppercase()).collect();
        if !keys.iter().any(|known| known.eq_ignore_ascii_case(key)) {
            return Err(Fault::unknown("coefficient", key, keys.iter().map(String::as_str)));
        }
        if !value.is_finite() {
            return Err(Fault::value(format_args!("{key} = {value}: must be a finite number")));
        }
    }
    if most == 0.0 {
        return Err(Fault::value(
            "the side slip is 0 throughout: no side force can be seen, and no file can do without",
        ));
    }
    Ok(nominal)
}

/// The formula as the format prescribes it for missing keys: coefficients 0, scale factors 1.
fn neutral(test: &TyreTest, task: &TyreTask, nominal: f64) -> MagicFormula {
    let mut formula: MagicFormula = start();
    let row = row_of_mut(&mut formula);
    for (column, variable) in MagicFormula::TABLE.iter().enumerate() {
        let name = variable.path.to_string();
        if !["fnomin", "unloaded_radius", "longvl", "side", "version"].contains(&name.as_str()) {
            row[column] = missing_value(&name.to_uppercase(), variable.start);
        }
    }
    formula.fnomin = nominal;
    formula.version = test.version().number();
    if let Some(pressure) = test.nominal_pressure {
        (formula.nompres, formula.inflpres) = (pressure, pressure);
    }
    formula.unloaded_radius = task.radius;
    formula.side = task.side.number();
    hold(&mut formula, task);
    formula
}

/// Gives the coefficients that are held their values.
fn hold(formula: &mut MagicFormula, task: &TyreTask) {
    let row = row_of_mut(formula);
    task.fixed.iter().for_each(|(key, value)| row[column(&key.to_lowercase())] = *value);
}

/// Why a coefficient is not determined, and what would help.
fn why(one: &Coefficient, alone: f64) -> String {
    let why =
        if alone > DETERMINED { "it hardly changes what was measured" } else { "only in combination with others" };
    format!("{why}; {}", one.needs.remedy())
}

/// Gives the coefficients that were dropped the value of a missing key.
fn validation(formula: &mut MagicFormula, dropped: &[(&'static Coefficient, String)]) {
    let row = row_of_mut(formula);
    dropped.iter().for_each(|(one, _)| row[column(one.name)] = 0.0);
}

/// Change of what was measured, as a part of that by the most visible coefficient, below which there is none (chosen).
const INVISIBLE: f64 = 1e-9;

/// A fit under way.
struct Fitter<'a> {
    test: &'a TyreTest,
    task: &'a TyreTask,
    formula: MagicFormula,
    groups: [Vec<&'static Coefficient>; GROUPS],
    kept: Vec<&'static Coefficient>,
    dropped: Vec<(&'static Coefficient, String)>,
    notes: Vec<String>,
}

/// The parameter of which least is known, if that is not enough; one that its group can do without, if there is one.
fn worst(known: &Known, parameters: &[&'static Coefficient]) -> Option<usize> {
    let open = |number: &usize| known.parts[*number] > DETERMINED;
    let is_essential = |number: usize| ESSENTIAL.iter().any(|group| group.contains(&parameters[number].name));
    (0..parameters.len())
        .filter(open)
        .max_by(|a, b| is_essential(*b).cmp(&is_essential(*a)).then(known.parts[*a].total_cmp(&known.parts[*b])))
}

impl Fitter<'_> {
    /// The formula with a group where its search begins.
    fn begin_with(&self, group: Group) -> MagicFormula {
        let mut formula = self.formula;
        let row = row_of_mut(&mut formula);
        self.groups[group as usize].iter().for_each(|one| row[column(one.name)] = one.start);
        hold(&mut formula, self.task);
        formula
    }

    /// The coefficients of a group that are not held and that change anything; the others are dropped, since least
    /// squares cannot do with them.
    fn visible(&mut self, group: Group, rows: &Rows) -> Vec<&'static Coefficient> {
        let is_held = |one: &Coefficient| self.task.fixed.iter().any(|(key, _)| key.eq_ignore_ascii_case(one.name));
        let all = self.groups[group as usize].iter().copied();
        let free: Vec<&'static Coefficient> = all.filter(|one| !is_held(one)).collect();
        let problem = TyreProblem::new(self.test, self.begin_with(group), free.clone(), rows.clone());
        let size = |number: usize| {
            let column = problem.sensitivity(&problem.formula, number);
            free[number].large * column.iter().map(|one| one * one).sum::<f64>().sqrt()
        };
        let sizes: Vec<f64> = (0..free.len()).map(size).collect();
        let least = INVISIBLE * sizes.iter().copied().fold(0.0, f64::max);
        let (seen, blind): (Vec<_>, Vec<_>) = free.into_iter().zip(sizes).partition(|(_, size)| *size > least);
        blind.into_iter().for_each(|(one, _)| self.drop(one, 1.0));
        seen.into_iter().map(|(one, _)| one).collect()
    }

    /// Side force in pure side slip, from several starts.
    fn lateral(&mut self, samples: &[usize]) -> Result<(), Fault> {
        let (count, least) = (samples.len(), columns::LEAST);
        if count < least {
            let text = format_args!("{count} samples without longitudinal slip; at least {least} are needed");
            return Err(Fault::value(text));
        }
        let rows = Rows { samples: samples.to_vec(), channels: vec![(Channel::ForceY, 1.0)] };
        let parameters = self.visible(Group::Lateral, &rows);
        let begin = |[shape, curvature]: [f64; 2]| {
            let mut formula = self.begin_with(Group::Lateral);
            validation(&mut formula, &self.dropped);
            formula.pcy1 = shape;
            formula.pey1 = curvature;
            let mut problem = TyreProblem::new(self.test, formula, parameters.clone(), rows.clone());
            (problem.solve(), problem.formula)
        };
        let mut ends = STARTS.map(begin).to_vec();
        ends.sort_by(|a, b| a.0.total_cmp(&b.0));
        let variance = 2.0 * ends[0].0 / count as f64;
        let level = self.test.samples.iter().filter_map(|one| one.force_y).map(|force| force * force).sum::<f64>();
        if 2.0 * (ends[1].0 - ends[0].0) > variance.max(1e-9 * level) {
            self.notes.push(
                "fits of the side force from different starts end at different values: this is the best one; sweep the \
                 side slip to both sides, beyond the peak of the force"
                    .to_owned(),
            );
        }
        self.formula = ends[0].1;
        self.prune(parameters, rows)
    }

    /// A group of coefficients on a channel.
    fn group(&mut self, group: Group, channel: Channel, samples: &[usize]) -> Result<(), Fault> {
        let rows = Rows { samples: samples.to_vec(), channels: vec![(channel, 1.0)] };
        let parameters = self.visible(group, &rows);
        self.formula = self.begin_with(group);
        validation(&mut self.formula, &self.dropped);
        self.prune(parameters, rows)
    }

    /// Fits a group, drops the coefficient of which least is known, and begins again until all are determined.
    fn prune(&mut self, mut parameters: Vec<&'static Coefficient>, mut rows: Rows) -> Result<(), Fault> {
        loop {
            let mut problem = TyreProblem::new(self.test, self.formula, parameters.clone(), rows.clone());
            problem.solve();
            self.formula = problem.formula;
            rows = weighed(&problem);
            problem.rows = rows.clone();
            let known = known(&problem);
            let Some(worst) = worst(&known, &parameters) else { break };
            let gone = self.without(parameters[worst], known.alone(worst))?;
            parameters.retain(|one| !gone.contains(&one.name));
        }
        self.kept.extend(parameters);
        Ok(())
    }

    /// Drops a coefficient, and all of its group if nothing is left of that without it; their names. No file can do
    /// without the side force.
    fn without(&mut self, one: &'static Coefficient, alone: f64) -> Result<Vec<&'static str>, Fault> {
        let Some(group) = ESSENTIAL.iter().position(|group| group.contains(&one.name)) else {
            self.drop(one, alone);
            return Ok(vec![one.name]);
        };
        let key = one.name.to_uppercase();
        if group == 0 {
            let text = format_args!("{key}, without which there is no side force: {}, or hold it", why(one, alone));
            return Err(Fault::value(text));
        }
        let reason = format!("nothing is left without {key}: {}", why(one, alone));
        for other in self.groups[group].clone() {
            row_of_mut(&mut self.formula)[column(other.name)] = 0.0;
            if self.dropped.iter().all(|(known, _)| known.name != other.name) {
                self.dropped.push((other, reason.clone()));
            }
        }
        Ok(self.groups[group].iter().map(|other| other.name).collect())
    }

    fn drop(&mut self, one: &'static Coefficient, alone: f64) {
        row_of_mut(&mut self.formula)[column(one.name)] = 0.0;
        self.dropped.push((one, why(one, alone)));
    }

    /// All coefficients that are left, on all channels.
    fn together(mut self) -> Result<TyreFit, Fault> {
        let channels = Channel::ALL.into_iter().filter(|channel| !channel.samples(self.test).is_empty());
        let samples = (0..self.test.samples.len()).collect();
        let rows = Rows { samples, channels: channels.map(|channel| (channel, 1.0)).collect() };
        loop {
            let mut problem = TyreProblem::new(self.test, self.formula, self.kept.clone(), rows.clone());
            problem.rows = weighed(&problem);
            problem.solve();
            problem.rows = weighed(&problem);
            self.formula = problem.formula;
            let known = known(&problem);
            let Some(worst) = worst(&known, &self.kept) else { return Ok(self.finish(&problem, &known)) };
            let gone = self.without(self.kept[worst], known.alone(worst))?;
            self.kept.retain(|one| !gone.contains(&one.name));
        }
    }

    fn finish(&self, problem: &TyreProblem, known: &Known) -> TyreFit {
        let row = row_of(&self.formula);
        let estimate = |key: &str, value, verdict| TyreEstimate { key: key.to_uppercase(), value, verdict };
        let deviations = known.parts.iter().zip(large(problem)).map(|(part, large)| part * large);
        let kept = self.kept.iter().zip(deviations).map(|(one, deviation)| {
            let value = row[column(one.name)];
            let coordinate = (value - one.range[0]) / (one.range[1] - one.range[0]);
            let is_inside = (AT_END..=1.0 - AT_END).contains(&coordinate);
            estimate(one.name, value, if is_inside { Verdict::Within(WIDTH * deviation) } else { Verdict::AtEnd })
        });
        let fixed = self.task.fixed.iter().map(|(key, value)| estimate(key, *value, Verdict::Held));
        let dropped = self.dropped.iter().map(|(one, reason)| estimate(one.name, 0.0, Verdict::Not(reason.clone())));
        let mut estimates: Vec<TyreEstimate> = kept.chain(fixed).chain(dropped).collect();
        estimates.sort_by_key(|one| column(&one.key.to_lowercase()));
        let groups = problem.left(&self.formula);
        let left = problem.rows.channels.iter().zip(&groups).map(|((channel, _), left)| {
            let rms = (left.iter().map(|one| one * one).sum::<f64>() / left.len().max(1) as f64).sqrt();
            (channel.name(), channel.unit(), rms, channel.largest(self.test))
        });
        let (left, notes) = (left.collect(), self.notes.iter().cloned().chain(self.far(problem, &groups)).collect());
        TyreFit { estimates, notes, left, formula: self.formula }
    }

    /// Notes on residuals of the side force, by channel, that are far from the rest in their file.
    fn far(&self, problem: &TyreProblem, groups: &[Vec<f64>]) -> Vec<String> {
        let channel = Channel::ForceY;
        let Some(number) = problem.rows.channels.iter().position(|(one, _)| *one == channel) else { return Vec::new() };
        let samples = channel.samples(self.test).into_iter().map(|at| self.test.samples[at]);
        let all: Vec<(Sample, f64)> = samples.zip(groups[number].iter().copied()).collect();
        let of_file = |part: &[(Sample, f64)]| {
            let (samples, left): (Vec<Sample>, Vec<f64>) = part.iter().copied().unzip();
            let name = self.test.files.get(samples[0].file).cloned().unwrap_or_default();
            by_residual(&samples, &left, channel.name()).into_iter().map(move |note| format!("{name}, {note}"))
        };
        all.chunk_by(|a, b| a.0.file == b.0.file).flat_map(of_file).collect()
    }
}

/// The rows with the weights of their noise; correlated residuals count as fewer samples.
fn weighed(problem: &TyreProblem) -> Rows {
    let groups = problem.left(&problem.formula);
    let weigh = |((channel, _), left): (&(Channel, f64), Vec<f64>)| {
        let seen = residuals(&left, &[left.len()], problem.parameters.len(), Loss::SQUARES);
        let most = channel.largest(problem.test);
        // What is computed leaves rounding; a channel that is 0 throughout says nothing.
        let deviation = seen.variance().sqrt().max(1e-9 * most);
        (*channel, if most > 0.0 { 1.0 / deviation } else { 0.0 })
    };
    let channels = problem.rows.channels.iter().zip(groups).map(weigh).collect();
    Rows { samples: problem.rows.samples.clone(), channels }
}

/// Large changes of the parameters: as for laws, about the value itself where that is larger.
fn large(problem: &TyreProblem) -> Vec<f64> {
    let row = row_of(&problem.formula);
    problem.parameters.iter().map(|one| one.large.max(row[column(one.name)].abs())).collect()
}

fn known(problem: &TyreProblem) -> Known {
    let columns = (0..problem.parameters.len()).map(|number| problem.sensitivity(&problem.formula, number));
    Known::of(&columns.collect::<Vec<_>>(), &large(problem), 1.0, &|_| false)
}
