//! Questions and answers as types of TypeScript.

use std::fmt::Write;

use stribeck_fit::identify;
use stribeck_measured as measured;
use stribeck_solve::{job, run};
use ts_rs::{Config, TS};

use crate::{answer, catalogue, copied, question, rig, solution, strokes, system};

/// Declarations of types.
macro_rules! declared {
    ($($type:ty),* $(,)?) => {{
        let config = Config::default().with_large_int("number");
        let mut text = String::new();
        $(let _ = write!(text, "\nexport {}\n", <$type>::decl(&config));)*
        text
    }};
}

/// The text of a file with all of them.
pub fn types() -> String {
    "/** What the library is asked and what it answers. Written by `python3 tasks.py types`. */\n\n\
     export type Value = number | string | boolean;\n"
        .to_owned()
        + &questions()
        + &answers()
        + &options()
}

/// Options that have places of their own on the page, are files, or are for files that the page does not read.
const ELSEWHERE: [&str; 9] =
    ["sheet", "records", "motion", "law", "mass", "normal_force", "hold_out", "reference", "evaluate"];

/// The other options of an identification, which the page shows as fields.
fn options() -> String {
    let all = job::options::<identify::Inquiry>().into_iter();
    let all: Vec<job::Choice> = all.filter(|option| !ELSEWHERE.contains(&option.name.as_str())).collect();
    let all = serde_json::to_string(&all);
    all.map_or_else(|fault| fault.to_string(), |all| format!("\nexport const IDENTIFICATION: Choice[] = {all};\n"))
}

/// What the page asks.
fn questions() -> String {
    declared!(question::Question, run::Configuration, rig::Asked, rig::Texts, strokes::Strokes, copied::Job,)
}

/// What it is answered.
fn answers() -> String {
    declared!(
        answer::Text,
        catalogue::Catalogue,
        catalogue::Fittable,
        catalogue::Drive,
        catalogue::Thesis,
        catalogue::Palette,
        catalogue::Colours,
        catalogue::Named,
        catalogue::SystemEntry,
        catalogue::Model,
        catalogue::Preset,
        catalogue::Described,
        job::Choice,
        system::Parts,
        system::Part,
        system::Moving,
        system::Property,
        solution::Solved,
        solution::Statistics,
        solution::Column,
        run::Check,
        run::Finer,
        run::Difference,
        strokes::Loop,
        rig::Files,
        rig::Label,
        rig::Labels,
        rig::RecordQuality,
        rig::MapQuality,
        rig::Quality,
        measured::Units,
        rig::Fitted,
        identify::Answer,
        identify::FittedLaw,
        identify::FittedParameter,
        identify::Readable,
        identify::RefusedLaw,
        identify::Judgement,
        identify::Outside,
        identify::LackOfFit,
    )
}
