//! Completions of shells and manual pages of the program, both made from its command line.

use std::path::PathBuf;

use clap::{Args, Command};
use clap_complete::Shell;

use super::{Failure, Verdict, folder};

/// The shell.
#[derive(Args)]
pub struct CompletionsArguments {
    /// Shell that completes commands, options and choices.
    shell: Shell,
}

/// The folder of the pages.
#[derive(Args)]
pub struct ManualArguments {
    /// Folder for the pages, one of each command.
    #[arg(long, value_name = "FOLDER")]
    out: PathBuf,
}

/// Prints the completions of a shell.
pub fn completions(arguments: &CompletionsArguments, mut line: Command) -> Verdict {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut line, "stribeck", &mut script);
    print!("{}", String::from_utf8_lossy(&script));
    Verdict::Done
}

/// Writes the manual pages.
pub fn manual(arguments: &ManualArguments, line: Command) -> Result<Verdict, Failure> {
    folder(&arguments.out)?;
    clap_mangen::generate_to(line, &arguments.out)
        .map_err(|source| Failure::File { path: arguments.out.clone(), source })?;
    Ok(Verdict::Done)
}
