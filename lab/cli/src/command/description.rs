//! The description of a job in a file.

use std::path::PathBuf;

use clap::Args;
use serde::Serialize;
use serde::de::DeserializeOwned;
use stribeck_solve::job;
use stribeck_solve::system::{Fault, read};

use super::{Failure, write};

/// Files with the description of a job.
#[derive(Args, Clone, Debug)]
pub struct Description {
    /// Read options from a TOML file; arguments take precedence
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,
    /// Write the options as a TOML file for --config
    #[arg(long, value_name = "FILE")]
    save_config: Option<PathBuf>,
}

impl Description {
    /// The job of the file, with the given arguments in it; saved as a file if the user wants one.
    pub fn complete<T: Clone + Serialize + DeserializeOwned>(&self, given: &T) -> Result<T, Failure> {
        let job = match &self.config {
            Some(path) => job::given_over(given, &read(path)?)?,
            None => given.clone(),
        };
        if let Some(path) = &self.save_config {
            let text = job::text(&job).map_err(|fault| Fault::File(format!("{}: {fault}", path.display())))?;
            write(path, text)?;
        }
        Ok(job)
    }
}
