//! Files of systems, and short runs of them.

use std::path::PathBuf;

use stribeck_solve::solve::{Grid, Method, Options, Recorder, solve};
use stribeck_solve::system::{Description, Motion, Source, System};

/// Most steps of a run, rejected ones included.
const MOST_STEPS: u64 = 200;
const INTERVALS: usize = 20;

pub fn read(bytes: &[u8]) {
    // As `Source::open` does.
    let Ok(description) = Description::parse(&String::from_utf8_lossy(bytes)) else { return };
    let source = Source { description, folder: PathBuf::new() };
    let Ok(system) = System::assemble(&source, None, &[]) else { return };
    for part in &system.parts {
        assert_eq!(part.row.len(), part.model.table.len());
        assert!(part.row.iter().all(|value| value.is_finite()), "{part:?}");
    }
    if let Ok(motion) = Motion::new(&system, &[]) {
        run(motion, system.description.until);
    }
}

/// A run that reaches its end has finite numbers; the others say why they ended.
fn run(mut motion: Motion, end: f64) {
    let mut states = motion.start();
    let mut recorder = Recorder::new(Grid { begin: 0.0, end, intervals: INTERVALS }, &motion);
    let options = Options { most_steps: MOST_STEPS, ..Options::new(end, 1e-6) };
    let (end, _) = solve(Method::Rodas5P, &mut motion, &mut states, &options, &mut recorder);
    if end.is_reached() {
        assert_eq!(recorder.len(), INTERVALS + 1);
        assert!(recorder.states.iter().flatten().all(|value| value.is_finite()), "{:?}", recorder.states);
    } else {
        assert!(!end.to_string().is_empty());
    }
}
