//! How far identification can be trusted, in figures. `cargo bench --package stribeck-fit --bench identify -- PART ...`:
//!
//! * `trust [SEEDS [RANKED [LAWS]]]`: for each law and seed (200) a record of the virtual rig with 1 % noise; for each
//!   parameter to which the fit gives an interval or an upper limit, whether that holds the truth. Then the records of some
//!   laws (all) against all laws. What is found is kept in the file that `IDENTIFIED` names, if it does, and not computed again:
//!   hours of work can be spread over days.
//! * `ranking`: time to rank all laws by a record of 10,001 samples.
//! * `methods`: evaluations to 1.02 of the noise with the search of the program and with a genetic algorithm as in the
//!   thesis, over eight seeds.
//! * `joints [SEEDS]`: simulated joints (200), every other one an arm with gravity: how many intervals hold the truth.
//! * `sliders [SEEDS]`: the same of simulated sliders (200) with LuGre's law.
//! * `mounts [SEEDS]`: the same of simulated rubber mounts (100).
//! * `dampers [SEEDS]`: the same of simulated magnetorheological dampers (100).
//! * `ropes [SEEDS]`, `gears [SEEDS]`, `servos [SEEDS]`: the same of simulated ropes over a drum, gears and servo drives
//!   (100). A second number, as in `dampers 100 60`, is that of the first record: the count can be made in parts.
//! * `camera`: what a camera of 100 Hz makes of the static level and the Stribeck velocity.
//!
//! Without arguments all of them.

mod simulated;

use std::collections::{BTreeMap, HashMap};
use std::fs::File;
use std::io::Write;
use std::ops::Range;
use std::slice;
use std::sync::Mutex;
use std::sync::atomic::AtomicBool;
use std::thread::{ThreadId, current};
use std::time::Instant;

use cpu_time::ProcessTime;
use stribeck::catalogue::by_name;
use stribeck::model::ModelType;
use stribeck_fit::identify::{
    Estimate, Experiment, Fit, Method, Rank, Searches, Settings, Verdict, Watch, fit, fit_all, laws,
};
use stribeck_fit::rig::{Faults, VirtualRig};
use stribeck_measured::{Delay, Record, Setup};
use stribeck_sheet::Sheet;

use simulated::{Damper, Held, Joint, Mount, Servo, Simulated, Slider, Transmission};

const MASS: f64 = 2.0;
const LOAD: f64 = 20.0;

/// A simulated thing, by the number of its seed.
type Drawn = fn(u64, &mut fastrand::Rng) -> Box<dyn Simulated>;

/// Simulated things, how many of them there are by default, and how one is drawn.
const SIMULATED: [(&str, u64, Drawn); 7] = [
    ("joints", SEEDS, |seed, random| Box::new(Joint::drawn(seed, random))),
    ("sliders", SEEDS, |_, random| Box::new(Slider::drawn(random))),
    ("mounts", SEEDS / 2, |_, random| Box::new(Mount::drawn(random))),
    ("dampers", SEEDS / 2, |_, random| Box::new(Damper::drawn(random))),
    ("ropes", SEEDS / 2, |_, random| Box::new(Transmission::rope(random))),
    ("gears", SEEDS / 2, |_, random| Box::new(Transmission::gear(random))),
    ("servos", SEEDS / 2, |_, random| Box::new(Servo::drawn(random))),
];

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    match arguments.first().map(String::as_str) {
        None => {
            trust(&[]);
            ranking();
            methods();
            SIMULATED.iter().for_each(|(names, seeds, of)| count(names, 0..*seeds, of));
            camera();
        }
        Some("trust") => trust(&arguments[1..]),
        Some("ranking") => ranking(),
        Some("methods") => methods(),
        Some("camera") => camera(),
        Some(other) => match SIMULATED.iter().find(|(names, ..)| *names == other) {
            Some((names, most, of)) => count(names, number(&arguments, 2, 0)..number(&arguments, 1, *most), of),
            None => {
                let names = SIMULATED.map(|(names, ..)| names).join(", ");
                eprintln!("no part '{other}': trust, ranking, methods, camera, {names}");
            }
        },
    }
}

/// Records of each law, and of each kind that is simulated.
const SEEDS: u64 = 200;

fn number(arguments: &[String], at: usize, usual: u64) -> u64 {
    arguments.get(at).and_then(|text| text.parse().ok()).unwrap_or(usual)
}

fn trust(arguments: &[String]) {
    let (seeds, ranked) = (number(arguments, 0, SEEDS), number(arguments, 1, u64::MAX));
    let named = arguments.get(2..).unwrap_or(&[]);
    let chosen: Vec<&'static ModelType> =
        laws().filter(|law| named.is_empty() || named.iter().any(|name| name == law.name)).collect();
    let found = Kept::open().collect(&chosen, seeds);
    println!("{:<18} {:<22} {:>9} {:>6} {:>6} {:>8}", "law", "parameter", "intervals", "limits", "held", "share, %");
    let (mut all, mut held) = (0, 0);
    for ((law, name), Counts { intervals, limits, held: hits }) in in_order(&found) {
        let told = intervals + limits;
        let share = if told > 0 { format!("{:.1}", 100.0 * f64::from(hits) / f64::from(told)) } else { String::new() };
        println!("{law:<18} {name:<22} {intervals:>9} {limits:>6} {hits:>6} {share:>8}");
        (all, held) = (all + told, held + hits);
    }
    let share = 100.0 * f64::from(held) / f64::from(all.max(1));
    println!(
        "figure: {held} of {all} intervals and upper limits hold the truth ({share:.1} %), with {seeds} records of each law"
    );
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

fn ranking() {
    let experiment = read(&slider(10.0, Faults::NOISE, 1), None);
    let all: Vec<&'static ModelType> = laws().collect();
    let never = AtomicBool::new(false);
    let watch = Watch { cancel: &never, progress: &|_, _| {} };
    let (begin, worked) = (Instant::now(), ProcessTime::now());
    let ranking = fit_all(&all, slice::from_ref(&experiment), &task(false), &mut |_| {}, watch).expect("a fit");
    let (wall, worked) = (begin.elapsed().as_secs_f64(), worked.elapsed().as_secs_f64());
    println!(
        "figure: {} laws ranked by {} samples in {wall:.0} s, {worked:.0} s of processor time; the first is {}",
        all.len(),
        experiment.time.len(),
        ranking.best().law.name
    );
}

/// A slider whose friction falls at 4 mm/s.
const SLIDER: [(&str, f64); 6] = [
    ("mu_k", 0.21),
    ("mu_s", 0.28),
    ("sigma_0", 2e4),
    ("sigma_1", 60.0),
    ("viscous_coefficient", 4.0),
    ("stribeck_velocity", 0.004),
];

fn slider(duration: f64, faults: Faults, seed: u64) -> VirtualRig {
    VirtualRig {
        law: by_name("LuGre").expect("a law of the catalogue"),
        values: SLIDER.map(|(name, value)| (name.to_owned(), value)).to_vec(),
        mass: MASS,
        normal_force: LOAD,
        duration,
        faults,
        seed,
    }
}

/// Part of the noise up to which a search has found the values.
const FOUND: f64 = 1.02;

/// Evaluations after which the searches are compared, and those that the genetic algorithm may have.
const COMPARED: u64 = 3600;
const GENEROUS: u64 = 20_000;

fn methods() {
    println!("{:>4} {:>18} {:>18} {:>26}", "seed", "evaluations, ours", "genetic / ours", "evaluations, genetic");
    let (mut ours, mut genetic, mut late, mut most) = (0, 0, 0, 0);
    for seed in 1..=8 {
        // Fewer samples than a search thins out.
        let rig = slider(1.9, Faults::NOISE, seed);
        let experiment = read(&rig, None);
        let task = Settings { seed, profiles: false, repetitions: 0, mass: MASS, ..Settings::default() };
        let (best, log) = logged(rig.law, &experiment, &task);
        let count = best.samples as f64;
        let floor = best.residuals.rms * ((count - best.parameters() as f64) / count).sqrt();
        let reached = |log: &[(u64, f64)]| log.iter().find(|(_, rms)| *rms <= FOUND * floor).map(|(count, _)| *count);
        let searches = log.len().max(1) as u64;
        // Where the search stops before, least squares go on: their evaluations count too.
        let found = log.iter().filter_map(|log| reached(log)).min().unwrap_or(best.evaluations / searches);
        let other = Settings { method: Method::Genetic, budget: GENEROUS, ..task };
        let (worse, log) = logged(rig.law, &experiment, &other);
        let needed = log.iter().filter_map(|log| reached(log)).min();
        let shown = needed.map_or("not reached".to_owned(), |count| count.to_string());
        println!("{seed:>4} {found:>18} {:>18.3} {shown:>26}", worse.residuals.rms / best.residuals.rms);
        ours += u32::from(best.searches == Searches::Agree && found <= COMPARED);
        genetic += u32::from(needed.is_some_and(|count| count <= COMPARED));
        late += u32::from(needed.is_some());
        most = found.max(most);
    }
    println!(
        "figure: {FOUND} of the noise in {COMPARED} evaluations: {ours} of 8 seeds, in at most {most}; the genetic \
         algorithm {genetic} of 8, and {late} of 8 in {GENEROUS}"
    );
}

/// A fit, and for each search the evaluations and what was left at its best place.
fn logged(law: &'static ModelType, experiment: &Experiment, task: &Settings) -> (Fit, Vec<Vec<(u64, f64)>>) {
    let never = AtomicBool::new(false);
    let log: Mutex<HashMap<ThreadId, Vec<(u64, f64)>>> = Mutex::default();
    let progress = |rms: f64, evaluations: u64| {
        let mut log = log.lock().expect("no thread panics");
        log.entry(current().id()).or_default().push((evaluations, rms));
    };
    let watch = Watch { cancel: &never, progress: &progress };
    let fit = fit(law, slice::from_ref(experiment), task, watch).expect("a fit");
    (fit, log.into_inner().expect("no thread panics").into_values().collect())
}

/// Simulated things, each with its record: how many intervals hold the truth.
fn count(names: &str, seeds: Range<u64>, of: &Drawn) {
    let mut all = Held::default();
    let records = seeds.end.saturating_sub(seeds.start);
    for seed in seeds {
        let mut random = fastrand::Rng::with_seed(seed);
        all.look(&*of(seed, &mut random), &mut random);
    }
    for (name, [told, held]) in &all.counts {
        println!("{name:<22} {told:>6} {held:>6} {:>8.1}", 100.0 * f64::from(*held) / f64::from(*told));
    }
    let ([told, held], warned) = (all.total(), all.warned);
    let share = 100.0 * f64::from(held) / f64::from(told.max(1));
    println!(
        "figure: {names}: {held} of {told} intervals hold the truth ({share:.1} %) in {records} records, {warned} with \
         warnings"
    );
}

/// A camera blurs the speeds at which friction falls.
fn camera() {
    let faults = Faults { camera: true, ..Faults::NOISE };
    println!(
        "{:<8} {:>4} {:<22} {:>10} {:>10} {:>10} {:>10}",
        "motion", "seed", "parameter", "truth", "found", "low", "high"
    );
    let (mut held, mut told, mut warned, mut runs) = (0, 0, 0, 0);
    for seed in 1..=3 {
        for (name, rig) in [("encoder", slider(4.0, Faults::NOISE, seed)), ("camera", slider(4.0, faults, seed))] {
            let task = Settings { repetitions: 0, mass: MASS, ..Settings::default() };
            let delay = if rig.faults.camera { Some(Delay::Find(0.05)) } else { None };
            let (fit, _) = logged(rig.law, &read(&rig, delay), &task);
            let is_warned = fit.warnings.iter().any(|text| text.contains("found too low"));
            (warned, runs) = (warned + u32::from(is_warned && delay.is_some()), runs + u32::from(delay.is_some()));
            for one in &fit.estimates {
                let Some((_, truth)) = SLIDER.iter().find(|(known, _)| *known == one.name) else { continue };
                let (is_told, is_held) = show(name, seed, one, *truth, is_warned);
                if delay.is_some() {
                    (told, held) = (told + u32::from(is_told), held + u32::from(is_held));
                }
            }
        }
    }
    println!("figure: camera: {held} of {told} intervals hold the truth; {warned} of {runs} fits warn of the bias");
    blur();
}

/// Bias of the values against the error of the velocity as a part of the speed at which friction falls.
fn blur() {
    println!("{:>10} {:>10} {:>8} {:>8} {:>8} {:>8}", "v_S, mm/s", "error/v_S", "mu_s", "v_S", "sigma_1", "warned");
    for speed in [0.002, 0.004, 0.008, 0.012, 0.016] {
        let mut rig = slider(4.0, Faults { camera: true, ..Faults::NOISE }, 1);
        rig.values.retain(|(name, _)| name != "stribeck_velocity");
        rig.values.push(("stribeck_velocity".to_owned(), speed));
        let experiment = read(&rig, Some(Delay::Find(0.05)));
        let task = Settings { repetitions: 0, profiles: false, mass: MASS, ..Settings::default() };
        let (fit, _) = logged(rig.law, &experiment, &task);
        let off = |name: &str, truth: f64| {
            let one = fit.estimates.iter().find(|one| one.name == name);
            one.map_or(f64::NAN, |one| 100.0 * (one.value / truth - 1.0))
        };
        println!(
            "{:>10.1} {:>10.3} {:>6.0} % {:>6.0} % {:>6.0} % {:>8}",
            1e3 * speed,
            experiment.velocity_error / speed,
            off("mu_s", 0.28),
            off("stribeck_velocity", speed),
            off("sigma_1", 60.0),
            fit.warnings.iter().any(|text| text.contains("found too low"))
        );
    }
}

fn show(name: &str, seed: u64, one: &Estimate, truth: f64, is_warned: bool) -> (bool, bool) {
    let [low, high] = one.interval();
    let is_told = one.verdict == Verdict::Determined;
    let note = if is_told { "" } else { "not determined" };
    let warned = if is_warned { "warned" } else { "" };
    println!(
        "{name:<8} {seed:>4} {:<22} {truth:>10.4} {:>10.4} {low:>10.4} {high:>10.4}  {note} {warned}",
        one.name, one.value
    );
    (is_told, is_told && (low..=high).contains(&truth))
}

fn read(rig: &VirtualRig, delay: Option<Delay>) -> Experiment {
    let files = rig.record().expect("a record");
    let known =
        Setup { mass: MASS, normal_force: Some(LOAD), delay: delay.unwrap_or(Delay::Known(0.0)), ..Setup::default() };
    let camera = files.camera.map(|text| Sheet::parse(&text).expect("a table"));
    let record = Record::of(&Sheet::parse(&files.force).expect("a table"), camera.as_ref(), &known);
    Experiment::new(rig.law.name, &record.expect("a record of a rig"))
}

/// A record of a law; no two laws have the same noise.
fn experiment(law: &'static ModelType, seed: u64) -> Experiment {
    let place = laws().take_while(|one| one.name != law.name).count() as u64;
    let seed = 1000 * (place + 1) + seed;
    let rig = VirtualRig {
        law,
        values: Vec::new(),
        mass: MASS,
        normal_force: LOAD,
        duration: 4.0,
        faults: Faults::NOISE,
        seed,
    };
    read(&rig, None)
}

fn task(profiles: bool) -> Settings {
    Settings { mass: MASS, profiles, repetitions: 0, ..Settings::default() }
}

fn fitted(law: &'static ModelType, experiment: &Experiment) -> Option<Fit> {
    let never = AtomicBool::new(false);
    let watch = Watch { cancel: &never, progress: &|_, _| {} };
    fit(law, slice::from_ref(experiment), &task(true), watch).ok()
}

/// A parameter in a fit to a record: law, seed of the record, name; whether it was given an interval or an upper limit,
/// and whether that held the truth.
#[derive(Clone)]
struct Seen {
    law: String,
    seed: u64,
    name: String,
    is_told: bool,
    is_held: bool,
    /// Truth, best value, and ends of the interval; the lower end of an upper limit is 0.
    values: [f64; 4],
}

/// Counts of earlier runs, and the file that keeps them.
struct Kept(Vec<Seen>, Option<File>);

impl Kept {
    fn open() -> Kept {
        let Some(path) = std::env::var_os("IDENTIFIED") else { return Kept(Vec::new(), None) };
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        let file = File::options().create(true).append(true).open(&path).expect("a file that can be written");
        Kept(text.lines().filter_map(Seen::read).collect(), Some(file))
    }

    /// All laws with a seed before the next seed, so that an early end leaves as many records of each law.
    fn collect(mut self, laws: &[&'static ModelType], seeds: u64) -> Vec<Seen> {
        for (seed, law) in (0..seeds).flat_map(|seed| laws.iter().map(move |law| (seed, *law))) {
            if self.0.iter().any(|one| one.law == law.name && one.seed == seed) {
                continue;
            }
            let found = look(law, seed);
            if let Some(file) = &mut self.1 {
                let text: String = found.iter().map(Seen::line).collect();
                file.write_all(text.as_bytes()).expect("a file that can be written");
            }
            self.0.extend(found);
        }
        let is_chosen = |one: &Seen| one.seed < seeds && laws.iter().any(|law| law.name == one.law);
        self.0.into_iter().filter(is_chosen).collect()
    }
}

impl Seen {
    fn line(&self) -> String {
        let Seen { law, seed, name, is_told, is_held, values: [truth, value, low, high] } = self;
        format!("{law},{seed},{name},{is_told},{is_held},{truth},{value},{low},{high}\n")
    }

    fn read(line: &str) -> Option<Seen> {
        let mut cells = line.split(',');
        let mut next = || cells.next();
        let (law, seed, name) = (next()?.to_owned(), next()?.parse().ok()?, next()?.to_owned());
        let (is_told, is_held) = (next()?.parse().ok()?, next()?.parse().ok()?);
        let mut number = || next()?.parse().ok();
        Some(Seen { law, seed, name, is_told, is_held, values: [number()?, number()?, number()?, number()?] })
    }
}

/// The parameters of a law in a fit to a record of it; one without a name if it cannot be fitted.
fn look(law: &'static ModelType, seed: u64) -> Vec<Seen> {
    let start = |name: &str| law.find(name).map(|column| law.table.at(column).start);
    let truth = |name: &str| match name {
        "mu_s - mu_k" => Some(start("mu_s")? - start("mu_k")?),
        _ => start(name),
    };
    let none = Seen {
        law: law.name.to_owned(),
        seed,
        name: String::new(),
        is_told: false,
        is_held: false,
        values: [f64::NAN; 4],
    };
    let Some(fit) = fitted(law, &experiment(law, seed)) else { return vec![none] };
    let seen = |one: &Estimate| {
        let truth = truth(&one.name).unwrap_or(f64::NAN);
        let [low, high] = match one.verdict {
            Verdict::AtMost(most) => [0.0, most],
            _ => one.interval(),
        };
        let is_told = matches!(one.verdict, Verdict::Determined | Verdict::AtMost(_)) && !truth.is_nan();
        let is_held = is_told && (low..=high).contains(&truth);
        if std::env::var_os("WHY").is_some() {
            println!("{} {seed} {} {:?}", law.name, one.name, one.verdict);
        }
        Seen { name: one.name.clone(), is_told, is_held, values: [truth, one.value, low, high], ..none.clone() }
    };
    fit.estimates.iter().map(seen).collect()
}

/// How often a parameter was given an interval or an upper limit, and how often that held the truth.
#[derive(Default)]
struct Counts {
    intervals: u32,
    limits: u32,
    held: u32,
}

/// Counts for each parameter of each law.
fn in_order(found: &[Seen]) -> BTreeMap<(&str, &str), Counts> {
    let mut all = BTreeMap::new();
    for one in found.iter().filter(|one| !one.name.is_empty()) {
        let counts: &mut Counts = all.entry((one.law.as_str(), one.name.as_str())).or_default();
        let is_limit = one.values[2] == 0.0;
        counts.intervals += u32::from(one.is_told && !is_limit);
        counts.limits += u32::from(one.is_told && is_limit);
        counts.held += u32::from(one.is_held);
    }
    all
}

fn is_first_or_tied(law: &'static ModelType, chosen: &[&'static ModelType]) -> bool {
    let never = AtomicBool::new(false);
    let watch = Watch { cancel: &never, progress: &|_, _| {} };
    let experiment = experiment(law, 1);
    let ranking = fit_all(chosen, slice::from_ref(&experiment), &task(false), &mut |_| {}, watch).expect("a fit");
    let is_own = |place: &&Rank| ranking.fits[place.fit].law.name == law.name;
    let is_tied = ranking.ranks.iter().find(is_own).is_some_and(|place| place.is_tied);
    let best = ranking.best().law.name;
    println!("record of {:<18} best {best:<18} {}", law.name, if is_tied { "first or tied" } else { "behind" });
    is_tied
}
