//! `stribeck`: the program of the workbench. Lists and shows models, runs systems of them, fits laws to measurements, and
//! reads files of dampers and tyres.

#[macro_use]
mod standard_output;

#[cfg(feature = "foreign")]
mod benchmark;
mod command;
mod damper;
mod outputs;
mod tyre;

use std::process::ExitCode;

use clap::{Arg, Command, CommandFactory, FromArgMatches, Parser, Subcommand};
use ssp::parameter_set::text_of;
use stribeck::catalogue;
use stribeck::instance::Instance;
use stribeck::model::{Kind, ModelType, Variable};
use stribeck_solve::system::{BUILT_IN, Description, Fault};

/// Lists and shows friction force models, runs systems of them, fits them to measurements, and reads files of dampers and
/// tyres.
#[derive(Parser)]
#[command(name = "stribeck", version)]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Lists the models.
    Models,
    /// Shows the variables of a model (column, role, start value, unit, bound, meaning) and its presets.
    Show {
        /// Name of the model, as `stribeck models` lists it.
        model: String,
    },
    /// Lists the built-in systems, or prints the file of one.
    Systems {
        /// Name of the system whose file is printed.
        name: Option<String>,
    },
    /// Runs a system, once or for each value of a variable.
    Run(command::Arguments),
    /// Runs a system with several friction laws, or with all of them.
    Compare(command::Arguments),
    /// Runs a system many times, with values from ranges, distributions or a table, and writes one table.
    Study(command::StudyArguments),
    /// Fits the parameters of a friction law to measured friction, with confidence intervals; ranks several laws.
    Identify(Box<command::IdentifyArguments>),
    /// Writes the records of a virtual rig whose friction law is known.
    Rig(command::RigArguments),
    /// Benchmarks all laws with all solvers, as the thesis does, and writes a page and a table.
    #[cfg(feature = "foreign")]
    Bench(command::BenchArguments),
    /// Writes the page for a browser: one HTML file with the same laws, systems and solvers.
    Page(command::PageArguments),
    /// Prints what a report of a fault must say: version, platform, registers of the processor, guids of the FMUs.
    Report(command::ReportArguments),
    /// Converts a damper test into a parameter set of the ShockAbsorber: damper table and friction.
    Damper(damper::Arguments),
    /// Converts a tyre property file (.tir) into a parameter set of DoubleTrackCar, or fits one to a tyre test.
    Tyre(tyre::Arguments),
    /// Prints a script with which a shell completes commands, options and choices.
    Completions(command::CompletionsArguments),
    /// Writes the manual pages, one of each command.
    Manual(command::ManualArguments),
}

/// The command line. A negative number after an option is its value, not an option: errors then name the bound.
fn command_line() -> Command {
    let takes_negative = |argument: Arg| {
        let has_value = argument.get_action().takes_values() && !argument.is_positional();
        argument.allow_negative_numbers(has_value)
    };
    Arguments::command().mut_subcommands(|task| task.mut_args(takes_negative))
}

fn main() -> ExitCode {
    let arguments = Arguments::from_arg_matches(&command_line().get_matches()).unwrap_or_else(|error| error.exit());
    match arguments.task {
        Task::Models => models(),
        Task::Show { model } => show(&model),
        Task::Systems { name } => systems(name.as_deref()),
        Task::Run(arguments) => ended(command::run(&arguments)),
        Task::Compare(arguments) => ended(command::compare(&arguments)),
        Task::Study(arguments) => ended(command::study(&arguments)),
        Task::Identify(arguments) => ended(command::identify(&arguments)),
        Task::Rig(arguments) => ended(command::rig(&arguments)),
        #[cfg(feature = "foreign")]
        Task::Bench(arguments) => ended(command::bench(&arguments)),
        Task::Page(arguments) => ended(command::page(&arguments)),
        Task::Report(arguments) => ended(command::report(&arguments)),
        Task::Damper(arguments) => ended(damper::run(&arguments).map(|()| command::Verdict::Done)),
        Task::Tyre(arguments) => ended(tyre::run(&arguments).map(|()| command::Verdict::Done)),
        Task::Completions(arguments) => command::completions(&arguments, command_line()).into(),
        Task::Manual(arguments) => ended(command::manual(&arguments, command_line())),
    }
}

fn ended(result: Result<command::Verdict, command::Failure>) -> ExitCode {
    match result {
        Ok(verdict) => verdict.into(),
        Err(error) => refused(&error),
    }
}

fn systems(name: Option<&str>) -> ExitCode {
    let Some(name) = name else {
        for (name, text) in BUILT_IN {
            if let Ok(system) = Description::parse(text) {
                println!("{name:<16} {}", system.title);
            }
        }
        return ExitCode::SUCCESS;
    };
    let Some((_, text)) = BUILT_IN.iter().find(|(known, _)| *known == name) else {
        return refused(&Fault::unknown("system", name, BUILT_IN.iter().map(|(known, _)| *known)));
    };
    print!("{text}");
    ExitCode::SUCCESS
}

fn refused(reason: &dyn std::fmt::Display) -> ExitCode {
    eprintln!("stribeck: {reason}");
    ExitCode::FAILURE
}

fn models() -> ExitCode {
    for model in catalogue::models() {
        println!("{:<16} {}", model.name, model.summary);
    }
    ExitCode::SUCCESS
}

fn show(name: &str) -> ExitCode {
    let Some(model) = catalogue::by_name(name) else {
        let names: Vec<&str> = catalogue::models().map(|model| model.name).collect();
        return refused(&format_args!("no model '{name}'; there are {}", names.join(", ")));
    };
    println!("{}: {}", model.name, model.summary);
    println!("guid {}\n", model.guid());
    let row = |variable: Variable| {
        [variable.path.to_string(), format!("{:?}", variable.role), value(&variable), variable.help.to_string()]
    };
    let rows: Vec<[String; 4]> = model.table.iter().map(row).collect();
    let width = |column: usize| rows.iter().map(|row| row[column].len()).max().unwrap_or(0);
    let [names, roles, values] = [width(0), width(1), width(2)];
    for (column, [name, role, value, help]) in rows.iter().enumerate() {
        println!("{column:>3} {name:<names$} {role:<roles$} {value:<values$} {help}");
    }
    print!("{}{}", with_start_values(model), presets(model));
    ExitCode::SUCCESS
}

/// The parameters with which the start values are not passive.
fn with_start_values(model: &'static ModelType) -> String {
    let warning = model.passivity(Instance::new(model).row());
    warning.map_or_else(String::new, |text| format!("\nwith start values, {text}\n"))
}

/// The presets, one value per line.
fn presets(model: &'static ModelType) -> String {
    let mut text = String::new();
    for preset in model.presets {
        text += &format!("\npreset {}: {}\n", preset.name, preset.source);
        for (name, number) in preset.values {
            let shown = model.find(name).map_or(number.to_string(), |column| in_unit(&model.table.at(column), *number));
            text += &format!("    {name} = {shown}\n");
        }
        let mut instance = Instance::new(model);
        instance.apply(preset.name);
        text += &model.passivity(instance.row()).map_or_else(String::new, |warning| format!("    {warning}\n"));
    }
    text
}

/// A value with its unit, or its name if it is a choice.
fn in_unit(variable: &Variable, value: f64) -> String {
    match variable.kind {
        Kind::Real(unit) if unit.name != "1" => format!("{value} {}", unit.name),
        _ => text_of(variable, value),
    }
}

/// Start value with unit, and the bound if there is one.
fn value(variable: &Variable) -> String {
    let start = in_unit(variable, variable.start);
    match variable.kind {
        Kind::Real(_) | Kind::Integer => format!("{start} ({})", variable.bound),
        Kind::Boolean | Kind::Enumeration(_) => start,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn presets_are_listed_with_values_and_units() {
        let text = presets(catalogue::by_name("LuGre").unwrap());
        assert!(text.starts_with("\npreset thesis: Novais (2024)"), "{text}");
        assert!(text.contains("\npreset canudas_1995: Canudas de Wit et al. (1995)"), "{text}");
        assert!(text.contains("\n    viscous_coefficient = 0.4 N.s/m\n"), "{text}");
        assert!(text.contains("\n    mu_s = 1.5\n"), "{text}");
    }

    #[test]
    fn choices_are_named() {
        let model = catalogue::by_name("CoulombStiction").unwrap();
        let exchange = &model.table.at(model.find("exchange").unwrap());
        assert_eq!([in_unit(exchange, 1.0), in_unit(exchange, 2.0)], ["Sequential", "Parallel"]);
    }
}
