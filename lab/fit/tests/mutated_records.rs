//! Records of rigs and tyre tests with random mistakes: each is accepted or refused with a text, and what is accepted
//! has finite numbers, also in its cycles, and, for a few of them, in a fit.

mod common;

use std::sync::atomic::AtomicBool;

use common::rig;
use stribeck::catalogue::by_name;
use stribeck_fit::identify::tyre::{Axes, Sample, TyreTest};
use stribeck_fit::identify::{Experiment, Settings, Watch, fit};
use stribeck_fit::rig::Faults;
use stribeck_measured::{Delay, Record, Setup, average};
use stribeck_sheet::Sheet;

/// Pieces of text that stand for the usual mistakes.
const PIECES: [&str; 18] = [
    "nan",
    "-inf",
    "",
    "0",
    "-1",
    "1e308",
    "-1e-308",
    "1e999",
    "1,5",
    "1;5",
    "\"",
    "#",
    "time [ms]",
    "force [kN]",
    "velocity",
    "normal_force",
    "[mm]",
    "\u{feff}\u{b5}",
];

const TRIALS: usize = 4000;

/// One fit for so many accepted records: they take most of the time.
const FITTED: usize = 150;

#[test]
fn mistakes_in_records_never_panic_and_never_give_numbers_that_are_not_finite() {
    let [force, camera, own] = files();
    let mut random = fastrand::Rng::with_seed(16);
    let (mut accepted, mut refused) = (0, 0);
    for trial in 0..TRIALS {
        let rig = Setup {
            mass: [0.0, 1.0][random.usize(..2)],
            normal_force: [Some(20.0), None][usize::from(random.u8(..8) == 0)],
            delay: [Delay::Known(0.0), Delay::Find(0.05)][usize::from(trial % 16 == 0)],
            window: [Some(0.05), None][usize::from(trial % 8 == 0)],
            ..Setup::default()
        };
        let outcome = if random.bool() {
            read(&mutated(&own, &mut random), None, &rig)
        } else {
            read(&mutated(&force, &mut random), Some(&mutated(&camera, &mut random)), &rig)
        };
        match outcome {
            Err(reason) => {
                assert!(!reason.is_empty(), "a refusal without a text");
                refused += 1;
            }
            Ok(record) => {
                attempt(&record, accepted % FITTED == 0);
                accepted += 1;
            }
        }
    }
    assert!(accepted > TRIALS / 20 && refused > TRIALS / 4, "{accepted} accepted, {refused} refused");
}

/// Files of a rig: force and camera, and force with an encoder.
fn files() -> [String; 3] {
    let files = rig(Faults::ALL).record().unwrap();
    let with_encoder = rig(Faults::NOISE).record().unwrap().force;
    // Fewer rows, so that most mistakes are near one that matters.
    let thin = |text: &str, every: usize| -> String {
        text.lines()
            .enumerate()
            .filter(|(n, _)| *n == 0 || n % every == 1 % every)
            .map(|(_, l)| l.to_owned() + "\n")
            .collect()
    };
    [thin(&files.force, 7), thin(&files.camera.unwrap(), 1), thin(&with_encoder, 7)]
}

fn read(text: &str, camera: Option<&str>, rig: &Setup) -> Result<Record, String> {
    let sheet = Sheet::parse(text).map_err(|error| error.to_string())?;
    let camera = camera.map(Sheet::parse).transpose().map_err(|error| error.to_string())?;
    Record::of(&sheet, camera.as_ref(), rig).map_err(|error| error.to_string())
}

fn attempt(record: &Record, is_fitted: bool) {
    let columns = [&record.time, &record.force, &record.displacement, &record.velocity, &record.normal_force];
    for column in columns.into_iter().chain([&record.acceleration, &record.friction_force]) {
        assert_eq!(column.len(), record.time.len());
        assert!(column.iter().all(|value| value.is_finite()), "{column:?}");
    }
    if let Some(cycle) = average(record) {
        assert!(cycle.friction_force.iter().chain(&cycle.deviation).all(|value| value.is_finite()));
    }
    if !is_fitted {
        return;
    }
    let never = AtomicBool::new(false);
    let task = Settings { budget: 60, profiles: false, repetitions: 0, ..Settings::default() };
    let experiments = [Experiment::new("record", record)];
    let found = fit(by_name("Dahl").unwrap(), &experiments, &task, Watch { cancel: &never, progress: &|_, _| {} });
    if let Ok(fit) = found {
        assert!(fit.values().iter().all(|(_, value)| value.is_finite()), "{:?}", fit.values());
        assert!(fit.predicted[0].iter().all(|force| force.is_finite()));
    }
}

#[test]
fn mistakes_in_tyre_tests_never_panic() {
    let mut text = "FZ [N],SA [deg],SR,IA [deg],FX [N],FY [N],MZ [Nm]\n".to_owned();
    for k in -30..30 {
        let slip = f64::from(k) * 0.4;
        text += &format!("700,{slip},0,1,0,{},{}\n", -900.0 * (0.3 * slip).tanh(), 20.0 * slip / (1.0 + slip * slip));
    }
    let mut random = fastrand::Rng::with_seed(17);
    let (mut accepted, mut refused) = (0, 0);
    for _ in 0..TRIALS {
        let axes = if random.u8(..4) == 0 { Axes::Sae } else { Axes::Iso };
        let outcome = Sheet::parse(&mutated(&text, &mut random)).map_err(|error| error.to_string());
        match outcome.and_then(|sheet| TyreTest::of(&sheet, axes).map_err(|error| error.to_string())) {
            Err(reason) => {
                assert!(!reason.is_empty(), "a refusal without a text");
                refused += 1;
            }
            Ok(test) => {
                accepted += 1;
                for one in test.samples {
                    let Sample { load, side_slip, longitudinal_slip, camber, force_y, .. } = one;
                    let all = [load, side_slip, longitudinal_slip, camber, force_y.unwrap_or(0.0)];
                    assert!(all.iter().all(|value| value.is_finite()) && load >= 0.0);
                }
            }
        }
    }
    assert!(accepted > TRIALS / 20 && refused > TRIALS / 4, "{accepted} accepted, {refused} refused");
}

/// Up to two rows lost, doubled, exchanged or cut, or cells replaced.
fn mutated(text: &str, random: &mut fastrand::Rng) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for _ in 0..random.usize(0..=2) {
        // A quarter of the mistakes is in the heading.
        let at = if random.u8(..4) == 0 { 0 } else { random.usize(..lines.len()) };
        let other = random.usize(..lines.len());
        match random.usize(..6) {
            0 => {
                lines.remove(at);
            }
            1 => lines.insert(other, lines[at].clone()),
            2 => lines.swap(at, other),
            3 | 4 => {
                let cells: Vec<&str> = lines[at].split(',').collect();
                let cell = random.usize(..cells.len());
                let piece = PIECES[random.usize(..PIECES.len())];
                let changed = cells.iter().enumerate().map(|(n, text)| if n == cell { piece } else { text });
                lines[at] = changed.collect::<Vec<&str>>().join(",");
            }
            _ => {
                let cut = lines[at].char_indices().map(|(n, _)| n).nth(random.usize(..lines[at].len() + 1));
                lines[at].truncate(cut.unwrap_or(0));
            }
        }
    }
    lines.join("\n")
}
