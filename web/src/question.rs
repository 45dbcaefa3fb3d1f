//! Questions.

use std::collections::BTreeMap;

use serde::Deserialize;
use stribeck_solve::run::Configuration;
use ts_rs::TS;

use crate::answer::Answer;
use crate::copied::{self, Job};
use crate::progress::progress;
use crate::rig::{Asked, Texts};
use crate::strokes::Strokes;
use crate::{catalogue, parameters, program, rig, solution, system};

/// A question of the page.
#[derive(Debug, Deserialize, TS)]
#[serde(tag = "ask", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Question {
    /// All models, systems and solvers.
    Catalogue,
    /// The parts of a system with one law and their present values.
    System {
        /// The run.
        #[ts(type = "Partial<Run>")]
        run: Configuration,
    },
    /// The run of one of the laws.
    Solve {
        /// The run with all laws: a setting that none of them has is refused.
        #[ts(type = "Partial<Run>")]
        run: Configuration,
        /// The law; none if the system has its own.
        law: Option<String>,
    },
    /// The table of results of one of the laws, as the command line writes it.
    Csv {
        /// The run.
        #[ts(type = "Partial<Run>")]
        run: Configuration,
        /// The law.
        law: Option<String>,
    },
    /// The file with which the command line runs the same.
    Toml {
        /// The run.
        #[ts(type = "Partial<Run>")]
        run: Configuration,
    },
    /// A program in C that runs the same by co-simulation.
    C {
        /// The run.
        #[ts(type = "Partial<Run>")]
        run: Configuration,
        /// The law.
        law: Option<String>,
    },
    /// Forces of a law at held velocities.
    Curve(Strokes),
    /// Forces of a law along strokes to and fro.
    Strokes(Strokes),
    /// These as a program in C.
    StrokesC(Strokes),
    /// The parameter set of a model, for FMUs.
    Ssv {
        /// The model.
        model: String,
        /// Values of its parameters.
        #[ts(type = "Record<string, Value>")]
        set: BTreeMap<String, toml::Value>,
    },
    /// Records of a virtual rig.
    Rig {
        /// The rig, as a user types it.
        #[ts(type = "Record<string, string>")]
        rig: BTreeMap<String, String>,
    },
    /// Quality of a record.
    Quality {
        /// The identification.
        fit: Asked,
        /// The record and the motion.
        files: Texts,
    },
    /// Laws fitted to a record.
    Fit {
        /// The identification.
        fit: Asked,
        /// The record and the motion.
        files: Texts,
    },
    /// The command line that does the same.
    Command {
        /// What is done.
        job: Job,
    },
    /// The same in Python.
    Python {
        /// What is done.
        job: Job,
    },
}

/// The answer to a question.
pub fn answer(text: &[u8]) -> Answer {
    let question = match serde_json::from_slice(text) {
        Ok(question) => question,
        Err(fault) => return Answer::refusal(fault),
    };
    let answer = match question {
        Question::Catalogue => catalogue::catalogue(),
        Question::System { run } => system::parts(&run),
        Question::Solve { run, law } => solution::solve(&run, law.as_deref()),
        Question::Csv { run, law } => solution::csv(&run, law.as_deref()),
        Question::Toml { run } => solution::toml(&run),
        Question::C { run, law } => program::c(&run, law.as_deref()),
        Question::Curve(strokes) => strokes.curve(),
        Question::Strokes(strokes) => strokes.strokes(),
        Question::StrokesC(strokes) => strokes.c(),
        Question::Ssv { model, set } => parameters::ssv(&model, &set),
        Question::Rig { rig } => rig::record(&rig),
        Question::Quality { fit, files } => rig::quality(&fit, &files),
        Question::Fit { fit, files } => rig::fit(&fit, &files, &progress),
        Question::Command { job } => copied::command(&job),
        Question::Python { job } => copied::python(&job),
    };
    answer.unwrap_or_else(Answer::refusal)
}
