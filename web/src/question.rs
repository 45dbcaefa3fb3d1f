//! Questions.

use std::collections::BTreeMap;

use serde::Deserialize;
use stribeck_solve::run::Configuration;

use crate::answer::Answer;
use crate::progress::progress;
use crate::rig::{Known, Virtual, Wanted};
use crate::series::Series;
use crate::{catalogue, parameters, program, rig, series, solution, system};

/// A question of the page.
#[derive(Debug, Deserialize)]
#[serde(tag = "ask", rename_all = "kebab-case", deny_unknown_fields)]
enum Question {
    /// All models, systems and solvers.
    Catalogue,
    /// The parts of a system with one law and their present values.
    System {
        /// The run.
        run: Configuration,
    },
    /// The run of one of the laws.
    Solve {
        /// The run with all laws: a setting that none of them has is refused.
        run: Configuration,
        /// The law; none if the system has its own.
        law: Option<String>,
    },
    /// The table of results of one of the laws, as the command line writes it.
    Csv {
        /// The run.
        run: Configuration,
        /// The law.
        law: Option<String>,
    },
    /// The file with which the command line runs the same.
    Toml {
        /// The run.
        run: Configuration,
    },
    /// A program in C that runs the same by co-simulation.
    C {
        /// The run.
        run: Configuration,
        /// The law.
        law: Option<String>,
    },
    /// Results of a model at held inputs.
    Settle(Series),
    /// Results of a model along samples.
    Follow {
        /// Interval of the samples, in s.
        every: f64,
        /// Model, parameters, inputs and results.
        series: Series,
    },
    /// The parameter set of a model, for FMUs.
    Ssv {
        /// The model.
        model: String,
        /// Values of its parameters.
        set: BTreeMap<String, toml::Value>,
    },
    /// Records of a virtual rig.
    Rig(Virtual),
    /// Quality of a record.
    Quality(Known),
    /// Laws fitted to a record.
    Fit {
        /// The record.
        known: Known,
        /// The laws.
        wanted: Wanted,
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
        Question::Settle(series) => series::settled(&series),
        Question::Follow { every, series } => series::followed(&series, every),
        Question::Ssv { model, set } => parameters::ssv(&model, &set),
        Question::Rig(given) => rig::record(&given),
        Question::Quality(known) => rig::quality(&known),
        Question::Fit { known, wanted } => rig::fit(&known, &wanted, &progress),
    };
    answer.unwrap_or_else(Answer::refusal)
}
