//! Questions.

use lab::run::Configuration;
use serde::Deserialize;

use crate::answer::Answer;
use crate::law::Motion;
use crate::{catalogue, law, solution, system};

/// A question of the page.
#[derive(Debug, Deserialize)]
#[serde(tag = "ask", rename_all = "kebab-case", deny_unknown_fields)]
enum Question {
    /// All models, systems and solvers.
    Catalogue,
    /// The parts of a system with one law and their present values.
    System {
        /// What would be run.
        run: Configuration,
    },
    /// The run of one of the laws.
    Solve {
        /// What is run, with all laws: a setting that none of them has is refused.
        run: Configuration,
        /// The law; none if the system has its own.
        law: Option<String>,
    },
    /// The table of results of one of the laws, as the command line writes it.
    Csv {
        /// What is run.
        run: Configuration,
        /// The law.
        law: Option<String>,
    },
    /// The file with which the command line runs the same.
    Toml {
        /// What is run.
        run: Configuration,
    },
    /// Results of a model over given inputs.
    Follow(Motion),
    /// Results of a model at held inputs, once they have settled.
    Settle(Motion),
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
        Question::Follow(motion) => law::follow(&motion),
        Question::Settle(motion) => law::settle(&motion),
    };
    answer.unwrap_or_else(Answer::refusal)
}
