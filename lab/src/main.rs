//! `stribeck`: the bench. Looks at models without an importer.

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use stribeck::catalogue;
use stribeck::model::{Kind, ModelType, Variable};

/// Friction force models: look at them without an importer.
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
    /// Shows the variables of a model: column, role, unit, start value, bound, meaning.
    Show {
        /// Name of the model, as `stribeck models` lists it.
        model: String,
    },
}

fn main() -> ExitCode {
    match Arguments::parse().task {
        Task::Models => {
            for model in catalogue::models() {
                println!("{:<16} {}", model.name, model.summary);
            }
        }
        Task::Show { model } => match catalogue::by_name(&model) {
            Some(model) => show(model),
            None => {
                let names: Vec<&str> = catalogue::models().map(|model| model.name).collect();
                eprintln!("stribeck: no model '{model}'; there are {}", names.join(", "));
                return ExitCode::FAILURE;
            }
        },
    }
    ExitCode::SUCCESS
}

fn show(model: &ModelType) {
    println!("{}: {}", model.name, model.summary);
    println!("guid {}\n", model.guid());
    let rows = model.table.iter().map(|variable| {
        [variable.path.to_string(), format!("{:?}", variable.role), value(variable), variable.help.to_string()]
    });
    let rows: Vec<[String; 4]> = rows.collect();
    let width = |column: usize| rows.iter().map(|row| row[column].len()).max().unwrap_or(0);
    let [names, roles, values] = [width(0), width(1), width(2)];
    for (column, [name, role, value, help]) in rows.iter().enumerate() {
        println!("{column:>3} {name:<names$} {role:<roles$} {value:<values$} {help}");
    }
}

/// Start value with unit, and the bound if there is one.
fn value(variable: &Variable) -> String {
    let Variable { start, bound, .. } = variable;
    match variable.kind {
        Kind::Real(unit) => format!("{start} {} ({bound})", unit.name),
        Kind::Integer => format!("{start} ({bound})"),
        Kind::Boolean => format!("{}", *start != 0.0),
        Kind::Enumeration(choices) => choices.items[*start as usize - 1].name.to_string(),
    }
}
