//! Dependencies found by trying, for models whose equations cannot be followed without values.
//!
//! Many rows are drawn at random, with zeros, tiny and large values of both signs, limits and start values; then one
//! column at a time is changed. An output depends on a column if changing that column alone ever changed it.

use std::collections::BTreeSet;

use fastrand::Rng;
use stribeck::model::{Kind, ModelType, Role, Variable};

use super::{has_elements, has_rates};

/// Rows that are tried per model (chosen: of those with arrays, the strut whose lower contact asks for the acceleration
/// takes some 30,000; the others are only compared with their equations).
fn rows(model: &ModelType) -> usize {
    if has_elements(model) { 60_000 } else { 20_000 }
}

/// For each column, which of the `candidates` its value is computed from; empty for columns that are not computed. Then
/// the same for the time derivatives of the columns, if the model is offered for Model Exchange and has no arrays.
pub fn of(model: &ModelType, candidates: impl Fn(usize) -> bool) -> Vec<BTreeSet<usize>> {
    // Unpacked once, for many rows.
    let table: Vec<Variable> = model.table.iter().collect();
    let (columns, has_rates) = (table.len(), has_rates(model));
    let (known, mut computed): (Vec<usize>, Vec<usize>) =
        (0..columns).partition(|column| !table[*column].role.is_computed());
    let known: Vec<usize> = known.into_iter().filter(|column| candidates(*column)).collect();
    if has_rates {
        computed.extend(model.continuous_states().map(|state| columns + state));
    }
    let mut found = vec![BTreeSet::new(); 2 * columns];
    // Any seed will do; a fixed one makes every run the same.
    let mut rng = Rng::with_seed(1);
    for _ in 0..rows(model) {
        let mut row = draw_row(&table, &mut rng);
        if !evaluate(model, has_rates, &mut row) {
            continue;
        }
        for &column in &known {
            let mut changed = row[..columns].to_vec();
            changed[column] = draw(&table[column], &mut rng);
            if changed[column] == row[column] || !evaluate(model, has_rates, &mut changed) {
                continue;
            }
            for &output in computed.iter().filter(|output| changed[**output] != row[**output]) {
                found[output].insert(column);
            }
        }
    }
    found
}

/// Computes the outputs of the row and appends its time derivatives; false if the model refuses it or asks for more.
fn evaluate(model: &ModelType, has_rates: bool, row: &mut Vec<f64>) -> bool {
    // A row by itself has no memory beside it.
    if model.check(row).is_err() || model.memory_in_use(row) > 0 || !model.output(row) {
        return false;
    }
    let columns = row.len();
    row.resize(2 * columns, 0.0);
    let (row, rate) = row.split_at_mut(columns);
    if has_rates {
        model.rate(row, rate);
    }
    rate.iter().all(|rate| rate.is_finite())
}

/// A row in which some columns, from a few to all, have left their start values.
fn draw_row(table: &[Variable], rng: &mut Rng) -> Vec<f64> {
    let share = rng.f64();
    let value = |variable: &Variable| if rng.f64() < share { draw(variable, rng) } else { variable.start };
    let mut row: Vec<f64> = table.iter().map(value).collect();
    if rng.bool() {
        remember_inputs(table, &mut row, rng);
    }
    row
}

/// Gives three of four states the value of an input with the same unit: a model may do something else as long as an input
/// is what it was at the end of a step. A state that carries the name of an input, as `end_normal_force`, gets that one.
fn remember_inputs(table: &[Variable], row: &mut [f64], rng: &mut Rng) {
    for (column, variable) in table.iter().enumerate() {
        if !variable.role.is_state() || !matches!(variable.kind, Kind::Real(_)) || rng.u8(0..4) == 0 {
            continue;
        }
        let is_alike = |other: &usize| {
            let other = &table[*other];
            other.role == Role::Input && other.kind == variable.kind
        };
        let mut alike: Vec<usize> = (0..row.len()).filter(is_alike).collect();
        let is_named = |input: &usize| variable.path.to_string().ends_with(&table[*input].path.to_string());
        if let Some(named) = alike.iter().copied().find(is_named) {
            alike = vec![named];
        }
        if let Some(input) = rng.choice(alike).filter(|input| variable.admits(row[*input])) {
            row[column] = row[input];
        }
    }
}

/// A value within the bound of the variable.
fn draw(variable: &Variable, rng: &mut Rng) -> f64 {
    let value = match variable.kind {
        Kind::Real(_) => draw_real(variable, rng),
        Kind::Integer => f64::from(rng.i32(-100..=100)),
        Kind::Boolean => f64::from(rng.i32(0..=1)),
        Kind::Enumeration(items) => f64::from(rng.i32(1..=items.items.len() as i32)),
    };
    if variable.admits(value) { value } else { variable.start }
}

fn draw_real(variable: &Variable, rng: &mut Rng) -> f64 {
    let scale = variable.nominal.max(variable.start.abs());
    // Half of the magnitudes are near the usual one, where the laws bend; the others reach far, mostly down.
    let decades = if rng.bool() { 2.0 * rng.f64() - 1.0 } else { 12.0 * rng.f64() - 9.0 };
    let magnitude = scale * 10f64.powf(decades);
    let (min, max) = crate::describe::text::limits(variable);
    match rng.u8(0..8) {
        0 => 0.0,
        1 => min.or(max).unwrap_or(-magnitude),
        2 => max.unwrap_or(magnitude),
        3 => min.zip(max).map_or(variable.start, |(min, max)| min + (max - min) * rng.f64()),
        4 => -magnitude,
        5 => variable.start * 2.0 * rng.f64(),
        _ => magnitude,
    }
}
