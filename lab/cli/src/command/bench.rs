//! `stribeck bench`: the benchmark of the thesis.

use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use crate::benchmark::{
    EVERY, Measurement, Precision, Reference, Trial, belt, csv, karnopp_as_printed, measure, most_steps, page,
    work_precision,
};
use clap::{Args, ValueEnum};
use stribeck_plot::picture::Theme;
use stribeck_solve::run::{Settings, Solver};
use stribeck_solve::system::{Fault, System};

use super::watch::{Bar, CANCELLED, heed_interrupts};
use super::{Failure, Verdict, write};

/// Laws, solvers and tolerances to measure, and the folder for the results.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// The benchmark
    #[arg(value_enum)]
    benchmark: Benchmark,
    /// Friction laws; all if none is named
    #[arg(long, num_args = 1.., value_delimiter = ',')]
    law: Vec<String>,
    /// Tolerance of the thesis' table
    #[arg(long, default_value_t = 1e-8)]
    tol: f64,
    /// Runs of each law and solver; the median time is reported
    #[arg(long, default_value_t = 3)]
    repeats: usize,
    /// Also run nine tolerances from 1e-3 to 1e-11, with and without event location, and draw diagrams
    #[arg(long)]
    work_precision: bool,
    /// Folder for benchmark.md and benchmark.csv
    #[arg(long, short, default_value = "out")]
    out: PathBuf,
}

/// Folder of the work-precision diagrams.
const PICTURES: &str = "work-precision";

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Benchmark {
    /// Tables 6.3, 6.5 and 7.2
    Thesis,
}

/// Measures all laws with all solvers.
pub fn bench(arguments: &Arguments) -> Result<Verdict, Failure> {
    let Benchmark::Thesis = arguments.benchmark;
    let laws = super::laws(&arguments.law);
    let systems = laws.iter().map(|law| belt(law)).collect::<Result<Vec<System>, Fault>>()?;
    let (measurements, references) = measured(arguments, &laws, &systems);
    let is_cancelled = CANCELLED.load(Ordering::Relaxed);
    super::folder(&arguments.out)?;
    let [text, table] = ["benchmark.md", "benchmark.csv"].map(|name| arguments.out.join(name));
    write(&table, csv(&measurements))?;
    let pictures = if arguments.work_precision { draw(&measurements, &laws, &arguments.out)? } else { Vec::new() };
    let printed = systems.first().filter(|_| !is_cancelled).map(|system| {
        let settings = Settings { cancel: Some(&CANCELLED), ..Settings::of(system) };
        karnopp_as_printed(arguments.tol, &references, &settings)
    });
    let printed = printed.transpose()?.unwrap_or_default();
    write(&text, page(&measurements, &references, arguments.tol, &printed, &pictures))?;
    println!("{}\n{}", text.display(), table.display());
    Ok(if is_cancelled { Verdict::Cancelled } else { Verdict::Done })
}

/// References of the laws, or why a law has none.
type References = Vec<(String, Result<Reference, String>)>;

/// Measures the laws one by one, until the user ends it.
fn measured(arguments: &Arguments, laws: &[String], systems: &[System]) -> (Vec<Measurement>, References) {
    heed_interrupts();
    let bar = Bar::new(laws.len(), systems.first().map_or(1.0, |system| system.description.until));
    let (mut measurements, mut references) = (Vec::new(), Vec::new());
    for (number, (law, system)) in laws.iter().zip(systems).enumerate() {
        bar.begin(number, law);
        let settings = Settings { every: EVERY, cancel: Some(&CANCELLED), progress: None, ..Settings::of(system) };
        let reference = Reference::of(system, &settings);
        if let Ok(reference) = &reference {
            measurements.extend(one_law(arguments, system, reference, &settings));
        }
        references.push((law.clone(), reference));
        if CANCELLED.load(Ordering::Relaxed) {
            break;
        }
    }
    bar.finish();
    (measurements, references)
}

/// Draws the work-precision diagrams of each law; returns the names of their files in the folder.
fn draw(measurements: &[Measurement], laws: &[String], folder: &Path) -> Result<Vec<(String, Vec<String>)>, Failure> {
    super::folder(&folder.join(PICTURES))?;
    let mut all = Vec::new();
    for law in laws {
        let mut files = Vec::new();
        for (name, precision) in [("motion", Precision::Motion), ("switching", Precision::Switching)] {
            for (way, events) in [("located", true), ("stepped-over", false)] {
                let Some(svg) = work_precision(measurements, law, events, precision, Theme::Auto) else { continue };
                let file = format!("{PICTURES}/{law}-{name}-{way}.svg");
                write(&folder.join(&file), svg)?;
                files.push(file);
            }
        }
        all.push((law.clone(), files));
    }
    Ok(all)
}

/// A law with each solver that can run it.
fn one_law(arguments: &Arguments, system: &System, reference: &Reference, settings: &Settings) -> Vec<Measurement> {
    let mut measurements = Vec::new();
    // The others choose a solver themselves, or have no tolerance.
    let compared = Solver::value_variants().iter().filter(|one| !matches!(one, Solver::Auto | Solver::CoSimulation));
    for solver in compared {
        let settings = &Settings { most_steps: most_steps(*solver), ..*settings };
        for trial in trials(arguments, *solver) {
            let repeats = if trial.tolerance == arguments.tol { arguments.repeats.max(1) } else { 1 };
            let looser = measurements.iter().rev().find_map(|one: &Measurement| one.for_finer(trial));
            measurements.push(looser.unwrap_or_else(|| measure(system, reference, trial, settings, repeats)));
        }
    }
    measurements
}

/// From the loosest tolerance on.
fn trials(arguments: &Arguments, solver: Solver) -> Vec<Trial> {
    let mut tolerances = vec![arguments.tol];
    if arguments.work_precision {
        tolerances.extend((3..=11).map(|power| 10f64.powi(-power)).filter(|other| *other != arguments.tol));
    }
    tolerances.sort_by(|a, b| b.total_cmp(a));
    // These two locate no events.
    let events: &[bool] = if matches!(solver, Solver::Steps | Solver::Dop853) { &[false] } else { &[true, false] };
    let both = |tolerance: f64| events.iter().map(move |events| Trial { solver, tolerance, events: *events });
    tolerances.into_iter().flat_map(both).collect()
}
