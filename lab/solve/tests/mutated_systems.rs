//! System files with random mistakes: each is accepted or refused with a text, and what is accepted runs or says why it
//! does not.

use std::path::PathBuf;

use stribeck_solve::run::{Settings, run};
use stribeck_solve::system::{BUILT_IN, Description, Source, System};

/// Pieces of text that stand for the usual mistakes.
const PIECES: [&str; 16] = [
    "nan",
    "-1.0",
    "0.0",
    "1e308",
    "\"\"",
    "[",
    "]",
    "=",
    "\"rig.velocity\"",
    "\"friction.friction_force\"",
    "LuGre",
    "der(",
    ")",
    "\n",
    "{ sine = { amplitude = inf, frequency = 1.0 } }",
    "rig",
];

const TRIALS: usize = 3000;

#[test]
fn mistakes_never_panic_and_never_give_numbers_that_are_not_finite() {
    let mut random = fastrand::Rng::with_seed(14);
    let (mut accepted, mut refused) = (0, 0);
    for _ in 0..TRIALS {
        let (_, text) = BUILT_IN[random.usize(..BUILT_IN.len())];
        let text = mutated(text, &mut random);
        match assemble(&text) {
            Err(reason) => {
                assert!(!reason.is_empty(), "a refusal without a text");
                refused += 1;
            }
            Ok(system) => {
                accepted += 1;
                attempt(&system);
            }
        }
    }
    assert!(accepted > TRIALS / 50 && refused > TRIALS / 2, "{accepted} accepted, {refused} refused");
}

fn assemble(text: &str) -> Result<System, String> {
    let description = Description::parse(text).map_err(|fault| fault.to_string())?;
    System::assemble(&Source { description, folder: PathBuf::new() }, None, &[]).map_err(|fault| fault.to_string())
}

/// Runs a system for a moment.
fn attempt(system: &System) {
    let settings = Settings { tolerance: 1e-3, until: 0.01, every: 0.01, ..Settings::of(system) };
    let results: Vec<String> = system.description.show.values().cloned().collect();
    if let Ok(outcome) = run(system, &settings, &results) {
        for column in &outcome.columns {
            assert!(column.values.iter().all(|value| value.is_finite()), "{}: {:?}", column.name, outcome.end);
        }
    }
}

/// One to three pieces of a file lost, doubled, exchanged or replaced.
fn mutated(text: &str, random: &mut fastrand::Rng) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for _ in 0..random.usize(1..=3) {
        let at = random.usize(..lines.len());
        let other = random.usize(..lines.len());
        match random.usize(..5) {
            0 => {
                lines.remove(at);
            }
            1 => lines.insert(other, lines[at].clone()),
            2 => lines.swap(at, other),
            3 => {
                let words: Vec<&str> = lines[at].split(' ').collect();
                let word = random.usize(..words.len());
                let piece = PIECES[random.usize(..PIECES.len())];
                let changed = words.iter().enumerate().map(|(n, text)| if n == word { piece } else { text });
                lines[at] = changed.collect::<Vec<&str>>().join(" ");
            }
            _ => {
                let cut = lines[at].char_indices().map(|(n, _)| n).nth(random.usize(..lines[at].len() + 1));
                lines[at].truncate(cut.unwrap_or(0));
            }
        }
    }
    lines.join("\n")
}
