//! The commands that run systems and fit laws.

#[cfg(feature = "foreign")]
mod bench;
mod choice;
mod compare;
mod description;
mod identify;
mod one;
mod page;
mod report;
mod rig;
mod shell;
mod step;
mod study;
mod watch;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use stribeck::catalogue::{Family, documented};
use stribeck_plot::picture::Picture;
use stribeck_sheet::of_file;
use stribeck_solve::system::Fault;

#[cfg(feature = "foreign")]
pub use bench::{Arguments as BenchArguments, bench};
pub use choice::Arguments;
pub use compare::compare;
pub use description::Description;
pub use identify::{Arguments as IdentifyArguments, identify};
pub use one::run;
pub use page::{Arguments as PageArguments, page};
pub use report::{Arguments as ReportArguments, report};
pub use rig::{Arguments as RigArguments, rig};
pub use shell::{CompletionsArguments, ManualArguments, completions, manual};
pub use study::{Arguments as StudyArguments, study};

/// Why a command did not do its work.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// Something was refused.
    #[error("{0}")]
    Refused(#[from] Fault),
    /// A file could not be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
}

impl Failure {
    /// An error about a file, with its name.
    pub fn of_file(path: &Path, error: &dyn std::fmt::Display) -> Failure {
        Fault::File(of_file(path, error)).into()
    }
}

/// How a command ended, as an exit code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// All runs came to their end.
    Done,
    /// A run did not converge.
    Diverged,
    /// The user ended it.
    Cancelled,
}

impl From<Verdict> for ExitCode {
    fn from(verdict: Verdict) -> ExitCode {
        match verdict {
            Verdict::Done => ExitCode::SUCCESS,
            Verdict::Diverged => ExitCode::from(3),
            // As of a program that was interrupted (128 + SIGINT).
            Verdict::Cancelled => ExitCode::from(130),
        }
    }
}

/// Writes a file.
pub fn write(path: &Path, text: impl AsRef<[u8]>) -> Result<(), Failure> {
    std::fs::write(path, text).map_err(|source| Failure::File { path: path.into(), source })
}

/// Makes a folder.
pub fn folder(path: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(path).map_err(|source| Failure::File { path: path.into(), source })
}

/// Width of PNG pictures (chosen: a column of 85 mm at 600 dots per inch).
const PIXELS: u32 = 2000;

/// Writes a picture as SVG and as PNG.
pub fn draw(picture: &Picture, path: &Path) -> Result<(), Failure> {
    write(&path.with_extension("svg"), &picture.svg)?;
    write(&path.with_extension("png"), picture.png(PIXELS)?)
}

/// The chosen laws, or all.
fn laws(chosen: &[String]) -> Vec<String> {
    let all = || documented(Family::Friction).map(|(law, _)| law.name.to_owned()).collect();
    if chosen.is_empty() { all() } else { chosen.to_vec() }
}
