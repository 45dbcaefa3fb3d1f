//! Measurements as a page.

use std::collections::BTreeSet;

use super::{MOST_STEPS, Measurement, RIGHT, Reference};
use stribeck_fit::thesis::{CLASSES, TABLE_6_5};
use stribeck_solve::run::Solver;

/// Solvers in the place of those of the thesis.
const SOLVERS: [Solver; 4] = [Solver::Dopri5, Solver::Bdf, Solver::Rosenbrock23, Solver::Dop853];

/// The solvers in the place of those of the thesis, their classes, and its time for a law.
pub(super) fn in_thesis(law: &str) -> Vec<(Solver, &'static str, String)> {
    let times = TABLE_6_5.iter().find(|(name, _)| *name == law).map_or([None; 4], |(_, times)| *times);
    let solvers = SOLVERS.iter().zip(CLASSES);
    solvers.zip(times).map(|((solver, class), time)| (*solver, class, seconds(time))).collect()
}

/// A time of the thesis.
fn seconds(time: Option<f64>) -> String {
    time.map_or("DNC".to_owned(), |time| format!("{time:.4}"))
}

/// The page of a benchmark: its table at the tolerance of the thesis, the runs that were not right, and what accuracy
/// costs, with links to the files of its pictures.
pub fn page(
    measurements: &[Measurement],
    references: &[(String, Result<Reference, String>)],
    tolerance: f64,
    printed: &str,
    pictures: &[(String, Vec<String>)],
) -> String {
    let pictures = if pictures.is_empty() { String::new() } else { precise(measurements, pictures) };
    let (head, printed, sensitive) = (head(tolerance), printed.to_owned(), SENSITIVE.to_owned());
    let (table, failures) = (table(measurements, tolerance), failures(measurements, tolerance));
    [head, table, thesis(), failures, printed, uncertain(references), sensitive, pictures].concat()
}

fn head(tolerance: f64) -> String {
    let [most, of_models] = MOST_STEPS.map(|steps| steps as f64);
    format!(
        "# Benchmark\n\nEvery law of the catalogue on the belt of Table 6.1 (40 s, 400,001 results, relative and \
         absolute tolerance {tolerance:e}), with\n{HEAD}\nA motion is *right* if its position is never off by more \
         than {} mm; *DNC* means that the solver did not come\nto the end within {most:e} steps, {of_models:e} of the \
         models, at this tolerance or at a looser one. A motion in brackets is\nnot judged: rounding errors alone move it \
         by as much ([References](#references)).\n\n",
        RIGHT * 1e3
    )
}

/// Error of the position, in m, for which the price is listed (chosen).
const PRECISE: f64 = 1e-6;

/// From which tolerance on each solver is right, the fewest evaluations with which it keeps the error small, and the
/// pictures of each law.
fn precise(measurements: &[Measurement], pictures: &[(String, Vec<String>)]) -> String {
    let solvers = solvers(measurements);
    let [columns, rule] = [solvers.iter().map(|solver| format!(" {solver} |")).collect(), "---|".repeat(solvers.len())];
    let head: String = format!("| law |{columns}\n|---|{rule}\n");
    let mut text = format!("{BEGINS}{head}{}", begins(measurements, &solvers));
    text += &format!(
        "\n## Work and precision\n\nFewest evaluations of the rates in a run whose position is never off by more than \
         {PRECISE:e} m, over nine tolerances from 1e-3 to 1e-11; events located or stepped over.\n\n{head}"
    );
    for (law, _) in pictures {
        let counts: Vec<String> = solvers.iter().map(|solver| fewest(measurements, law, *solver)).collect();
        text += &format!("| {law} | {} |\n", counts.join(" | "));
    }
    for (law, files) in pictures.iter().filter(|(_, files)| !files.is_empty()) {
        text += &format!("\n<details><summary>{law}</summary>\n\n");
        files.iter().for_each(|file| text += &format!("![{law}]({file})\n"));
        text += "\n</details>\n";
    }
    text
}

/// Where each solver begins to be right: for all laws that it runs, and for each.
fn begins(measurements: &[Measurement], solvers: &[Solver]) -> String {
    let judged: Vec<&str> = laws(measurements)
        .into_iter()
        .filter(|law| measurements.iter().any(|one| one.law == *law && one.is_judged))
        .collect();
    let (mut all, mut loosest) = (String::new(), String::new());
    for solver in solvers {
        let known: Vec<Begin> = judged.iter().filter_map(|law| begin(measurements, law, *solver)).collect();
        let first = known.iter().copied().reduce(|a, b| a.zip(b).map(|(a, b)| f64::min(a, b))).flatten();
        all += &format!(" **{}** |", tolerance_text(first));
        let at_once = known.iter().filter(|one| one.is_some_and(|one| one >= LOOSEST)).count();
        loosest += &format!(" {at_once} of {} |", known.len());
    }
    let mut text =
        format!("| **all laws that it runs** |{all}\n| laws with which it is right at {LOOSEST:e} |{loosest}\n");
    for law in judged {
        text += &format!("| {law} |");
        for solver in solvers {
            let begin = begin(measurements, law, *solver);
            text += &begin.map_or_else(|| " |".to_owned(), |begin| format!(" {} |", tolerance_text(begin)));
        }
        text += "\n";
    }
    text
}

/// The loosest tolerance from which on a solver is right, if there is one.
type Begin = Option<f64>;

/// The loosest tolerance of the tables.
const LOOSEST: f64 = 1e-3;

fn tolerance_text(begin: Begin) -> String {
    begin.map_or_else(|| "-".to_owned(), |tolerance| format!("{tolerance:e}"))
}

/// Finds the loosest tolerance from which on a solver is right with a law, among the runs that reach their end. Returns
/// None if no run does.
fn begin(measurements: &[Measurement], law: &str, solver: Solver) -> Option<Begin> {
    let tolerances = measurements.iter().filter(|one| one.law == law && one.trial.solver == solver);
    let tolerances: BTreeSet<u64> = tolerances.map(|one| one.trial.tolerance.to_bits()).collect();
    let at = |tolerance: u64| find(measurements, law, solver, f64::from_bits(tolerance));
    let ended: Vec<&Measurement> = tolerances.into_iter().filter_map(at).filter(|one| one.error.is_some()).collect();
    ended.first()?;
    let right = ended.iter().take_while(|one| one.verdict() == "right");
    Some(right.last().map(|one| one.trial.tolerance))
}

fn fewest(measurements: &[Measurement], law: &str, solver: Solver) -> String {
    let is_precise = |one: &&Measurement| {
        one.law == law && one.trial.solver == solver && one.error.is_some_and(|error| error <= PRECISE)
    };
    let counts = measurements.iter().filter(is_precise).map(|one| one.counts[2]);
    counts.min().map_or_else(|| "-".to_owned(), |count| count.to_string())
}

/// Text before the table of where solvers begin to be right.
const BEGINS: &str = "
## Where each solver begins to be right

The loosest tolerance, of nine from 1e-3 to 1e-11, from which on the motion is right: at it and in all finer runs that
come to their end. `-`: not even the finest is; empty: the law was refused, or no run came to its end. Events are
located where the solver can do so. Laws that are not judged are left out.

";

const HEAD: &str = "the solver classes of F. Novais (2024), Tables 6.3, 6.5 and 7.2, and with ours. `stribeck bench \
thesis` writes this page
and `benchmark.csv`; with `--work-precision` the table there has nine tolerances, events located and not.

Times are medians on the machine that made the page: compare them with each other, not with those of the thesis. They
include the 400,001 results. The last column, `steps`, knows no rates: it makes steps of the models, as an importer of
FMUs does, halved until two halves agree.
";

/// Laws whose motion on the belt amplifies small errors, and why.
const SENSITIVE: &str = "
Why some of these motions amplify errors, so that no solver is as good as its tolerance:

- `LinearStiction` and `Hollars` let the block creep until their force has its peak. It arrives there with an acceleration
  of (v_0 / f_s) k v_b, 1.4e-4 m/s2 for the defaults: a velocity that is off by 1e-8 m/s is a breakaway that is off by
  7e-5 s, and a position by 1e-5 m.
- `Karnopp` holds the block at the velocity with which it entered the band. Each micrometre per second there moves the next
  breakaway by 2 (f_s - f_C) / (k v_b^2), 49 us.
- `Bristle` gives a bond that breaks a new place at random. The k-th number of a bond is the same in all runs with a seed,
  so that its bonds are those of the distance slid, at any tolerance. The spring that they are while the block sticks is
  not damped, however: it swings at 50 Hz, and each turn decides which bond snaps.
- `Wojewoda` lets the block slow down to 1.6 um/s, which it keeps until the spring reaches the upper curve: how fast it creeps
  decides when it speeds up again, and a difference grows exponentially then.
- `MaxwellSlip`, `Armstrong` and `FrictionalLag` break away where their force falls with speed: a difference grows
  exponentially then, in each of the five slips.
";

pub(super) fn solvers(measurements: &[Measurement]) -> Vec<Solver> {
    let mut found: Vec<Solver> = Vec::new();
    for one in measurements {
        if !found.contains(&one.trial.solver) {
            found.push(one.trial.solver);
        }
    }
    found
}

fn laws(measurements: &[Measurement]) -> Vec<&str> {
    let mut seen = BTreeSet::new();
    measurements.iter().map(|one| one.law.as_str()).filter(|law| seen.insert(*law)).collect()
}

fn find<'a>(all: &'a [Measurement], law: &str, solver: Solver, tolerance: f64) -> Option<&'a Measurement> {
    let fits = |one: &&Measurement| one.law == law && one.trial.solver == solver && one.trial.tolerance == tolerance;
    let located = all.iter().filter(fits).find(|one| one.trial.events && one.end.is_ok());
    located.or_else(|| all.iter().find(|one| fits(one) && !one.trial.events))
}

/// Evaluations, milliseconds and verdict of each law and solver.
fn table(measurements: &[Measurement], tolerance: f64) -> String {
    let solvers = solvers(measurements);
    let mut text = String::from(
        "## All laws, all solvers\n\nEvaluations of the rates / ms / largest error in m. Events are located where the \
         solver can do so. For laws made of straight lines rodas5p is exact, as is what it is compared with (0e0): what \
         both are worth is in the column of another code, in the references.\n\n| law |",
    );
    solvers.iter().for_each(|solver| text += &heading(*solver));
    text += &format!("\n|---|{}\n", "---|".repeat(solvers.len()));
    for law in laws(measurements) {
        text += &format!("| {law} |");
        for solver in &solvers {
            text += &find(measurements, law, *solver, tolerance).map_or_else(|| " |".to_owned(), cell);
        }
        text += "\n";
    }
    text + "\n"
}

/// Heading of a solver's column, with its class.
fn heading(solver: Solver) -> String {
    let class = SOLVERS.iter().position(|one| *one == solver).map(|at| CLASSES[at]);
    class.map_or_else(|| format!(" {solver} |"), |class| format!(" {solver} ({class}) |"))
}

fn cell(one: &Measurement) -> String {
    let ms = one.time.as_secs_f64() * 1e3;
    match one.error {
        Some(error) if one.verdict() == "right" => format!(" {} / {ms:.1} / {error:.0e} |", one.counts[2]),
        Some(error) if !one.is_judged => format!(" {} / {ms:.1} / ({error:.0e}) |", one.counts[2]),
        Some(error) => format!(" {} / {ms:.1} / **{error:.0e}** |", one.counts[2]),
        None => format!(" {} |", one.verdict()),
    }
}

fn thesis() -> String {
    let mut text = String::from(
        "## Table 6.5 of the thesis\n\nAverage times in s in MATLAB, on a machine that the thesis does not name. The \
         times of its Tables 6.3 and 7.2 were not available.\n\n| law | ode45 | ode15s | ode23s | ode78 \
         |\n|---|---|---|---|---|\n",
    );
    for (law, times) in TABLE_6_5 {
        let times = times.map(seconds);
        text += &format!("| {law} | {} |\n", times.join(" | "));
    }
    text + "\n"
}

/// The runs that were wrong or did not come to their end, with the reason.
fn failures(measurements: &[Measurement], tolerance: f64) -> String {
    let mut text = String::from(
        "## Runs that were not right\n\n| law | solver | events | verdict | how it ended |\n|---|---|---|---|---|\n",
    );
    // One row for all solvers that ended in the same way.
    let mut rows: Vec<(&Measurement, Vec<String>)> = Vec::new();
    for one in measurements
        .iter()
        .filter(|one| one.trial.tolerance == tolerance && !matches!(one.verdict(), "right" | "not judged"))
    {
        let what = |one: &Measurement| (one.law.clone(), one.trial.events, one.end.clone());
        match rows.iter_mut().find(|(other, _)| what(other) == what(one)) {
            Some((_, solvers)) => solvers.push(one.trial.solver.to_string()),
            None => rows.push((one, vec![one.trial.solver.to_string()])),
        }
    }
    for (one, solvers) in rows {
        let events = if one.trial.events { "located" } else { "stepped over" };
        let (solvers, verdict) = (solvers.join(", "), one.verdict());
        text += &format!("| {} | {solvers} | {events} | {verdict} | {} |\n", one.law, one.reason());
    }
    text + "\n"
}

/// How well each motion is known, and how errors grow in it.
fn uncertain(references: &[(String, Result<Reference, String>)]) -> String {
    let ((other, at), shift) = (Reference::OTHER, Reference::SHIFT);
    let head = format!(
        "## References\n\nEach motion is compared with one by the solver and at the tolerance named here; the uncertainty \
         is its largest difference from\na run at ten times that tolerance, the next column its largest difference from \
         a run of another code, {other} at {at:e}. The last\none says how errors grow: by how much the motion is off at \
         most if the block starts {shift:e} m beside its place. A motion is\nnot judged if one of the three is above {} \
         mm.\n\n| law | solver | uncertainty in m | other code in m | growth of {shift:e} m, in m \
         |\n|---|---|---|---|---|\n",
        RIGHT * 1e3
    );
    let row = |(law, reference): &(String, Result<Reference, String>)| match reference {
        Ok(Reference { by: (solver, tolerance), uncertainty, other, growth, .. }) => {
            let other = other.as_ref().map_or_else(|reason| format!("none: {reason}"), |other| format!("{other:.0e}"));
            format!("| {law} | {solver}, {tolerance:e} | {uncertainty:.0e} | {other} | {growth:.0e} |\n")
        }
        Err(reason) => format!("| {law} | - | not measured, since it has no reference: {reason} | - | - |\n"),
    };
    head + &references.iter().map(row).collect::<String>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::benchmark::tests::trial;

    /// A run that happens to be right at a loose tolerance does not count if a finer one is wrong.
    #[test]
    fn a_solver_begins_to_be_right_where_no_finer_run_is_wrong() {
        let of_bdf = |tolerance, error| trial(Solver::Bdf, tolerance, 1, error);
        let chance = [of_bdf(1e-3, 1e-3), of_bdf(1e-4, 1e-2), of_bdf(1e-5, 1e-3), of_bdf(1e-6, 1e-4)];
        assert_eq!(begin(&chance, "LuGre", Solver::Bdf), Some(Some(1e-5)));
        assert_eq!(begin(&chance[..2], "LuGre", Solver::Bdf), Some(None));
        assert_eq!(begin(&chance, "LuGre", Solver::Dopri5), None);
        let text = begins(&chance, &[Solver::Bdf, Solver::Dopri5]);
        assert!(text.contains("| **all laws that it runs** | **1e-5** | **-** |"), "{text}");
        assert!(text.contains("| LuGre | 1e-5 | |"), "{text}");
        // What is not judged has no row.
        let unknown = chance.map(|one| Measurement { is_judged: false, ..one });
        assert!(!begins(&unknown, &[Solver::Bdf]).contains("LuGre"));
        assert_eq!(unknown[0].verdict(), "not judged");
    }
}
