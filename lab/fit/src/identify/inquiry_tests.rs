//! Descriptions of identifications.

use clap::{Command, FromArgMatches};
use stribeck_solve::job;

use super::*;
use stribeck_measured::Delay;

fn described(text: &str) -> Inquiry {
    toml::from_str(text).unwrap()
}

fn parsed(words: &[&str]) -> Inquiry {
    let command = <Inquiry as clap::Args>::augment_args(Command::new("stribeck"));
    Inquiry::from_arg_matches(&command.get_matches_from(words)).unwrap()
}

/// Everything that can be said, once.
const ALL: &str = r#"
records = ["a.csv", "b c.csv"]
column = { force = "Kraft 1" }
scale = { displacement = -1.0, force = 35.15 }
torque_constant = 0.05
gear_ratio = -100.0
motor_side = ["force", "velocity"]
motion = "film.csv"
law = ["Dahl", "LuGre"]
axis = true
mass = 2.5
normal_force = 20.0
window = 0.01
delay = "find:0.05"
skip = 0.1
rest = 1e-4
fix = { sigma_1 = 0.0 }
fit = ["offset"]
range = { "mu_s - mu_k" = [0.01, 0.1], sigma_0 = [1e4, 1e6] }
sheet = "run 2"
method = "genetic"
loss = "robust"
hold_out = ["c.csv"]
folds = 3
budget = 500
seed = 7
repetitions = 10
reference = "thesis"
evaluate = "a.toml"
"#;

#[test]
fn a_description_is_the_same_on_the_command_line_and_in_a_file() {
    let all = described(ALL);
    assert_eq!(job::entries(&all).unwrap().len(), 28, "an option is missing in the text above");
    let words = shlex::split(&all.command().unwrap()).unwrap();
    assert_eq!(words[..2], ["stribeck", "identify"]);
    let words: Vec<&str> = words[1..].iter().map(String::as_str).collect();
    assert_eq!(parsed(&words), all);
    assert_eq!(described(&job::text(&all).unwrap()), all);
    // What was not given stays so.
    let short = described("records = \"a.csv\"\nlaw = \"Dahl\"\ndelay = 0.25");
    assert_eq!(short.command().unwrap(), "stribeck identify a.csv --delay 0.25 --law Dahl");
    assert_eq!(
        short.python().unwrap(),
        "import stribeck\n\nfound = stribeck.identify([\"a.csv\"], delay=0.25, law=[\"Dahl\"])\nprint(found)\n"
    );
}

#[test]
fn what_a_description_means_is_what_it_says() {
    let settings = described(ALL).settings().unwrap();
    let Settings { selection, method, seed, budget, repetitions, mass, is_robust, folds, profiles } = settings;
    assert_eq!((method, seed, budget, repetitions, mass), (Method::Genetic, 7, 500, 10, 2.5));
    assert_eq!((is_robust, folds, profiles), (true, 3, true));
    assert_eq!(selection.fixed, [("sigma_1".to_owned(), 0.0)]);
    assert_eq!(selection.fitted, ["offset"], "the mass is known");
    assert_eq!(selection.ranges.len(), 2);
    assert_eq!(Inquiry::default().settings().unwrap(), Settings::default());
    let laws = |text: &str| described(text).laws().map(|laws| laws.iter().map(|law| law.name).collect::<Vec<_>>());
    assert_eq!(laws("axis = true").unwrap(), [axis::LAW]);
    assert_eq!(laws("axis = true\nlaw = \"Dahl\"").unwrap(), ["Dahl"]);
    assert_eq!(laws("").unwrap_err().to_string(), "no law was given");
    let delay = |text: &str| described(text).setup().delay;
    assert_eq!(delay(""), Delay::Known(0.0));
    assert_eq!(delay("axis = true"), Delay::OfController);
    assert_eq!(delay("delay = \"find\""), Delay::Find(Delay::LONGEST));
    assert_eq!(delay("axis = true\ndelay = 1"), Delay::Known(1.0));
}

#[test]
fn what_contradicts_itself_is_refused() {
    for (text, expected) in [
        ("mass = 2\nfix = { mass = 3 }", "fix mass = 3 contradicts mass = 2"),
        ("fit = \"mass\"\nfix = { mass = 3 }", "fix mass = 3 contradicts fit mass"),
    ] {
        assert_eq!(described(text).settings().unwrap_err().to_string(), expected);
    }
    let twice = parsed(&["identify", "--fix", "k=1", "--fix", "k=2"]);
    assert_eq!(twice.settings().unwrap_err().to_string(), "fix k = 1 contradicts fix k = 2");
    let records = |text: &str| described(text).records(&Files).unwrap_err().to_string();
    assert_eq!(records(""), "no record was given");
    assert_eq!(records("records = [\"a\", \"b\"]\nmotion = \"c\""), "motion: is for a single record");
    for (text, expected) in [
        ("delai = 1", "unknown field `delai`"),
        ("delay = \"late\"", "delay = late: must be a number in s, find, or find:LONGEST"),
        ("loss = \"cubes\"", "unknown variant `cubes`, expected `squares` or `robust`"),
    ] {
        let error = toml::from_str::<Inquiry>(text).unwrap_err().to_string();
        assert!(error.contains(expected), "{error}");
    }
}
