//! Systems with drawn parameters, and how far loose tolerances lead from their motion.

use stribeck::catalogue::{Family, documented};
use stribeck::table::Kind;
use stribeck_solve::run::{Outcome, Settings, Solver, run};
use stribeck_solve::solve::End;
use stribeck_solve::system::{Motion, Setting, Source, System};

/// Largest part of the amplitude by which a run that is reached may be off.
pub const GROSS: f64 = 0.05;

/// Largest error in tolerances of the amplitude.
const SANE: f64 = 1000.0;

/// Tolerance of the reference.
const REFERENCE: f64 = 1e-11;

/// Largest derivative of a rate at the start with which an explicit method ends, in 1/s.
const STIFFEST: f64 = 1e9;

/// Numbers of results that are compared.
const RESULTS: f64 = 2000.0;

/// Largest factor by which a parameter is drawn away from its default.
const FACTOR: f64 = 2.5;

/// Quantities of hosts that are drawn beside those of the law.
const OF_HOSTS: [&str; 2] = ["belt_velocity", "stiffness"];

/// A built-in system and the time for which it runs.
#[derive(Clone, Copy)]
pub struct Case {
    pub system: &'static str,
    pub until: f64,
}

/// Counts of the runs at one tolerance.
#[derive(Clone, Copy, Default)]
pub struct Tally {
    pub runs: usize,
    /// Reached, but off by more than a thousand tolerances.
    pub off: usize,
    /// Reached, but off by more than a twentieth of the amplitude.
    pub gross: usize,
    /// Not reached, which the run says.
    pub refused: usize,
}

impl std::ops::AddAssign for Tally {
    fn add_assign(&mut self, other: Tally) {
        self.runs += other.runs;
        self.off += other.off;
        self.gross += other.gross;
        self.refused += other.refused;
    }
}

/// Runs a law in a system with its defaults and with drawn parameters, at each tolerance. The reference is that of two
/// methods which agree; None if the law is not solved there. `spoil` takes every gross run.
pub fn tallies(
    case: Case,
    law: &str,
    draws: usize,
    solver: Solver,
    tolerances: &[f64],
    mut spoil: impl FnMut(String),
) -> Option<Vec<Tally>> {
    let source = Source::open(case.system).ok()?;
    let base = System::assemble(&source, Some(law), &[]).ok()?;
    // Solvers of other crates, of which one checks the reference, keep no past and follow no bonds.
    let mut motion = Motion::new(&base, &[]).ok().filter(|motion| !motion.has_past() && !motion.has_bonds())?;
    // The explicit one of them cannot follow a law of creep.
    motion.steepest().filter(|(_, most)| *most < STIFFEST)?;
    let mut random = fastrand::Rng::with_seed(7);
    let mut tallies = vec![Tally::default(); tolerances.len()];
    let mut settings = Vec::new();
    for _ in 0..draws {
        let present = std::mem::replace(&mut settings, drawn(&base, &mut random));
        let Ok(system) = System::assemble(&source, Some(law), &present) else { continue };
        if Motion::check(&system).is_ok()
            && let Some(truth) = reference(&system, case.until)
        {
            for (tally, tolerance) in tallies.iter_mut().zip(tolerances) {
                let (one, error) = judged(&system, case.until, solver, *tolerance, &truth);
                *tally += one;
                if one.gross > 0 {
                    spoil(format!("{} {law} at {tolerance:e}: off by {error:.3}, {}", case.system, spelled(&present)));
                }
            }
        }
    }
    Some(tallies)
}

/// All laws of friction.
pub fn laws() -> impl Iterator<Item = &'static str> {
    documented(Family::Friction).map(|(law, _)| law.name)
}

fn judged(system: &System, until: f64, solver: Solver, tolerance: f64, truth: &[f64]) -> (Tally, f64) {
    let outcome = ran(system, until, solver, tolerance);
    let error = distance(&outcome.columns[0].values, truth) / amplitude(truth);
    let is_reached = outcome.end == End::Reached;
    let tally = Tally {
        runs: 1,
        off: usize::from(is_reached && error > SANE * tolerance),
        gross: usize::from(is_reached && error > GROSS),
        refused: usize::from(!is_reached),
    };
    (tally, error)
}

/// The position by two methods, if they agree to a thousandth of the amplitude.
fn reference(system: &System, until: f64) -> Option<Vec<f64>> {
    let [ours, other] = [Solver::Rodas5P, Solver::Dopri5].map(|solver| ran(system, until, solver, REFERENCE));
    let values = |outcome: Outcome| (outcome.end == End::Reached).then(|| outcome.columns[0].values.clone());
    let (ours, other) = (values(ours)?, values(other)?);
    (distance(&ours, &other) < 1e-3 * amplitude(&ours)).then_some(ours)
}

fn ran(system: &System, until: f64, solver: Solver, tolerance: f64) -> Outcome {
    let settings = Settings { solver, tolerance, until, every: until / RESULTS, ..Settings::of(system) };
    run(system, &settings, &[system.description.show["position"].clone()]).unwrap()
}

fn distance(values: &[f64], truth: &[f64]) -> f64 {
    values.iter().zip(truth).map(|(value, truth)| (value - truth).abs()).fold(0.0, f64::max)
}

fn amplitude(values: &[f64]) -> f64 {
    let of = |better: fn(f64, f64) -> f64| values.iter().copied().reduce(better).unwrap_or(0.0);
    of(f64::max) - of(f64::min)
}

/// Real parameters of the law and some of its host, each multiplied by a factor between 1 / FACTOR and FACTOR.
fn drawn(base: &System, random: &mut fastrand::Rng) -> Vec<Setting> {
    let mut settings = Vec::new();
    for part in &base.parts {
        for (column, variable) in part.model.variables() {
            let (name, value) = (variable.path.to_string(), part.row[column]);
            let is_drawn = part.is_law || OF_HOSTS.contains(&name.as_str());
            let is_real = variable.role.is_parameter() && matches!(variable.kind, Kind::Real(_));
            if is_drawn && is_real && value != 0.0 && value.is_finite() {
                let value = (value * FACTOR.powf(2.0 * random.f64() - 1.0)).to_string();
                settings.push(Setting { name: format!("{}.{name}", part.name), value });
            }
        }
    }
    settings
}

fn spelled(settings: &[Setting]) -> String {
    settings.iter().map(|Setting { name, value }| format!("--set {name}={value}")).collect::<Vec<_>>().join(" ")
}
