//! How often the intervals of an identification hold the truth, and how often the law that made the data ranks first.
//!
//! For each law and seed a record of the virtual rig with 1 % noise; for each unknown that the fit calls determined,
//! whether its interval holds the truth. Then each law's record against all laws. Arguments: number of seeds (200),
//! number of laws that are ranked by a record (all), names of laws.

use std::sync::atomic::AtomicBool;
use std::time::Instant;

use lab::identify::{Experiment, Fit, Rank, Task, Verdict, Watch, fit, laws, rank};
use lab::measured::{Record, Rig};
use lab::rig::{Faults, VirtualRig};
use lab::sheet::Sheet;
use stribeck::model::ModelType;

const MASS: f64 = 2.0;
const LOAD: f64 = 20.0;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let number = |at: usize, usual: u64| arguments.get(at).and_then(|text| text.parse().ok()).unwrap_or(usual);
    let (seeds, ranked) = (number(0, 200), number(1, u64::MAX));
    let named = arguments.get(2..).unwrap_or(&[]);
    let chosen: Vec<&'static ModelType> =
        laws().filter(|law| named.is_empty() || named.iter().any(|name| name == law.name)).collect();
    println!("{:<18} {:<22} {:>10} {:>8} {:>10}", "law", "unknown", "determined", "held", "share, %");
    let (mut all, mut held) = (0, 0);
    for law in &chosen {
        for (name, told, hits) in coverage(law, seeds) {
            let share = if told > 0 { format!("{:.1}", 100.0 * hits as f64 / told as f64) } else { String::new() };
            println!("{:<18} {name:<22} {told:>10} {hits:>8} {share:>10}", law.name);
            (all, held) = (all + told, held + hits);
        }
    }
    println!("figure: {held} of {all} intervals hold the truth ({:.1} %)", 100.0 * held as f64 / all.max(1) as f64);
    let records: Vec<&'static ModelType> = chosen.iter().copied().take(ranked as usize).collect();
    let begin = Instant::now();
    let first = records.iter().filter(|law| is_first_or_tied(law, &chosen)).count();
    println!("figure: {first} of {} laws rank first, or are tied, with their own record", records.len());
    println!(
        "{:.1} s to rank {} laws with a record",
        begin.elapsed().as_secs_f64() / records.len().max(1) as f64,
        chosen.len()
    );
}

fn experiment(law: &'static ModelType, seed: u64) -> Experiment {
    let rig = VirtualRig {
        law,
        values: Vec::new(),
        mass: MASS,
        normal_force: LOAD,
        duration: 4.0,
        faults: Faults::NOISE,
        seed,
    };
    let sheet = Sheet::parse(&rig.record().expect("a record").force).expect("a table");
    let known = Rig { mass: MASS, normal_force: Some(LOAD), ..Rig::default() };
    Experiment::new(law.name, &Record::of(&sheet, None, &known).expect("a record of a rig"))
}

fn fitted(law: &'static ModelType, experiment: &Experiment, profiles: bool) -> Option<Fit> {
    let never = AtomicBool::new(false);
    let task = Task { mass: MASS, profiles, repetitions: 0, ..Task::default() };
    fit(law, std::slice::from_ref(experiment), &task, Watch { cancel: &never, progress: &|_| {} }).ok()
}

/// For each unknown how often it was determined, and how often its interval held the truth.
fn coverage(law: &'static ModelType, seeds: u64) -> Vec<(String, u32, u32)> {
    let start = |name: &str| law.find(name).map(|column| law.table.at(column).start);
    let truth = |name: &str| match name {
        "mu_s - mu_k" => Some(start("mu_s")? - start("mu_k")?),
        _ => start(name),
    };
    let mut counts: Vec<(String, u32, u32)> = Vec::new();
    for seed in 0..seeds {
        let Some(fit) = fitted(law, &experiment(law, 1000 + seed), true) else { continue };
        counts.resize_with(fit.estimates.len(), Default::default);
        for (count, one) in counts.iter_mut().zip(&fit.estimates) {
            count.0.clone_from(&one.name);
            if let (Verdict::Determined, Some(truth)) = (&one.verdict, truth(&one.name)) {
                let [low, high] = one.interval();
                count.1 += 1;
                count.2 += u32::from((low..=high).contains(&truth));
            }
        }
    }
    counts
}

fn is_first_or_tied(law: &'static ModelType, chosen: &[&'static ModelType]) -> bool {
    let experiment = experiment(law, 1);
    let fits: Vec<Fit> = chosen.iter().filter_map(|other| fitted(other, &experiment, false)).collect();
    let ranks = rank(&fits);
    let is_own = |place: &&Rank| fits[place.fit].law.name == law.name;
    let is_tied = ranks.iter().find(is_own).is_some_and(|place| place.is_tied);
    let best = ranks.first().map_or("", |place| fits[place.fit].law.name);
    println!("record of {:<18} best {best:<18} {}", law.name, if is_tied { "first or tied" } else { "behind" });
    is_tied
}
