//! The same for the command line and in Python.

use serde::Deserialize;
use stribeck_solve::run::Configuration;
use stribeck_solve::system::Fault;
use ts_rs::TS;

use crate::answer::{Answer, Text};
use crate::rig::Asked;
use crate::strokes::Strokes;

/// What a user may take along.
#[derive(Debug, Deserialize, TS)]
#[serde(rename_all = "kebab-case")]
pub enum Job {
    /// A run of a system.
    Run(#[ts(type = "Partial<Run>")] Configuration),
    /// An identification.
    Fit(Asked),
    /// Strokes of a law.
    Strokes(Strokes),
}

/// As a command line.
pub fn command(job: &Job) -> Result<Answer, Fault> {
    let text = match job {
        Job::Run(run) => run.command()?,
        Job::Fit(asked) => asked.inquiry()?.command()?,
        Job::Strokes(_) => {
            return Err(Fault::value("the command line has no strokes of a law; copy them as Python or C"));
        }
    };
    Ok(Answer::plain(Text { text }))
}

/// In Python.
pub fn python(job: &Job) -> Result<Answer, Fault> {
    let text = match job {
        Job::Run(run) => run.python()?,
        Job::Fit(asked) => asked.inquiry()?.python()?,
        Job::Strokes(strokes) => strokes.python()?,
    };
    Ok(Answer::plain(Text { text }))
}
