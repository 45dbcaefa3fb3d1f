//! `stribeck report`: what a report of a fault must say about the program and the machine.

use std::env::{consts, var};
use std::thread::available_parallelism;

use clap::Args;
use stribeck::batch::Registers;
use stribeck::catalogue;
use stribeck::model::ModelType;
use stribeck_solve::system::Fault;

use super::{Failure, Verdict};

/// The models that a report is about.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// Models whose guids are printed (default: all)
    models: Vec<String>,
}

/// Prints version, platform, registers of the processor, and the guids that the FMUs of this version have.
pub fn report(arguments: &Arguments) -> Result<Verdict, Failure> {
    let models = chosen(&arguments.models)?;
    println!("Stribeck    {}", env!("CARGO_PKG_VERSION"));
    println!("platform    {} {}, {} build", consts::OS, consts::ARCH, kind_of_build());
    println!("processors  {}", available_parallelism().map_or("unknown".to_owned(), |count| count.to_string()));
    println!("registers   {}", registers());
    println!("solvers     {}", if cfg!(feature = "foreign") { "own and foreign" } else { "own" });
    println!("guids");
    for model in models {
        println!("  {:<24} {}", model.name, model.guid());
    }
    Ok(Verdict::Done)
}

fn chosen(names: &[String]) -> Result<Vec<&'static ModelType>, Fault> {
    let model = |name: &String| {
        let known = || catalogue::models().map(|model| model.name);
        catalogue::by_name(name).ok_or_else(|| Fault::unknown("model", name, known()))
    };
    if names.is_empty() { Ok(catalogue::models().collect()) } else { names.iter().map(model).collect() }
}

fn kind_of_build() -> &'static str {
    if cfg!(debug_assertions) { "debug" } else { "release" }
}

/// The registers of this processor, those in use, and what limits them.
fn registers() -> String {
    let here: Vec<String> = Registers::here().map(|registers| format!("{registers:?}")).collect();
    let limit = var("STRIBECK_REGISTERS").map_or_else(|_| String::new(), |text| format!(", STRIBECK_REGISTERS={text}"));
    format!("{}; in use: {:?}{limit}", here.join(", "), Registers::best())
}
