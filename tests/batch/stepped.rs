//! Runs that the caller steps together have the bits of instances that are stepped alone.

use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};

use stribeck::batch::{Given, Registers, Stepped, Wanted};
use stribeck::catalogue::{by_name, models};
use stribeck::instance::{Instance, Phase};
use stribeck::model::{Fault, Kind, ModelType, Role, Variable};

use super::bits_agree;
use crate::common::random::Random;
use crate::common::rows;

/// Runs of every model: more than a group of any registers. And of one law: more than are worked on together.
const RUNS: usize = 11;
const MANY: usize = 150;
const STEPS: usize = 4;

/// A column with values for each run.
type Column = (usize, Vec<f64>);

/// Values of runs, drawn for the columns of these roles.
fn drawn(model: &'static ModelType, runs: usize, random: &mut Random, wanted: fn(Role) -> bool) -> Vec<Column> {
    let rows: Vec<Vec<f64>> = (0..runs).map(|_| rows::everyday(model, random)).collect();
    let is_wanted = |variable: &Variable| wanted(variable.role) && matches!(variable.kind, Kind::Real(_));
    let columns = model.table.iter().enumerate().filter(|(_, variable)| is_wanted(variable));
    columns.map(|(column, _)| (column, rows.iter().map(|row| row[column]).collect())).collect()
}

fn given(columns: &[Column]) -> Vec<Given<'_>> {
    columns.iter().map(|(column, values)| (*column, &values[..])).collect()
}

/// A step of all runs, or a column without a step.
fn found(stepped: &mut Stepped, dt: Option<f64>, inputs: &[Column], column: usize) -> Result<Vec<f64>, String> {
    let mut values = vec![f64::NAN; stepped.runs()];
    let mut take = |runs: Range<usize>, results: &[f64]| {
        values[runs].copy_from_slice(results);
        Ok(())
    };
    let done = match dt {
        Some(dt) => stepped.step(dt, &given(inputs), column, &mut take),
        None => stepped.get(column, &mut take),
    };
    done.map_err(|(run, ended)| format!("run {run}: {ended}")).map(|()| values)
}

fn results(model: &ModelType) -> Vec<usize> {
    let is_result = |variable: &Variable| !matches!(variable.role, Role::Fixed | Role::Tunable);
    model.table.iter().enumerate().filter(|(_, variable)| is_result(variable)).map(|(column, _)| column).collect()
}

/// Inputs, states and outputs of all runs.
fn everything(law: &ModelType, stepped: &mut Stepped) -> Vec<Result<Vec<f64>, String>> {
    results(law).into_iter().map(|column| found(stepped, None, &[], column)).collect()
}

/// The model, or none where its drawn parameters are refused.
fn agree(model: &'static ModelType, registers: Registers, runs: usize, random: &mut Random) -> bool {
    let mut stepped = Stepped::new(model, registers, runs).expect("memory");
    let mut alone: Vec<Instance> = (0..runs).map(|_| Instance::new(model)).collect();
    let parameters = drawn(model, runs, random, |role| matches!(role, Role::Fixed | Role::Tunable));
    stepped.set(&given(&parameters)).expect("admitted parameters");
    let first = model.table.iter().position(|variable| variable.role == Role::Output).expect("an output");
    for step in 0..STEPS {
        let inputs = drawn(model, runs, random, |role| role == Role::Input);
        let dt = 1e-3 * (1 + step) as f64;
        let mut wanted: Vec<Result<(), String>> = Vec::new();
        for (run, instance) in alone.iter_mut().enumerate() {
            let of_run = |(column, values): &Column| (*column, values[run]);
            let values: Vec<(usize, f64)> = parameters.iter().chain(&inputs).map(of_run).collect();
            let done = instance.set_all(Phase::Setup, values.into_iter()).map_err(|refused| refused.to_string());
            let done = done.and_then(|()| instance.step(dt).map_err(|fault| fault.to_string()));
            wanted.push(done.and_then(|()| instance.refresh().map_err(|fault| fault.to_string())));
        }
        let made = found(&mut stepped, Some(dt), &inputs, first);
        if let Some((run, text)) = wanted.iter().enumerate().find_map(|(run, done)| Some((run, done.as_ref().err()?))) {
            assert_eq!(made.err(), Some(format!("run {run}: {text}")), "{} {registers:?}", model.name);
            return false;
        }
        let made = made.unwrap_or_else(|text| panic!("{} {registers:?}: {text}", model.name));
        for (run, value) in made.iter().enumerate() {
            assert!(bits_agree(*value, alone[run].row()[first]), "{} {registers:?} {run}", model.name);
        }
        for column in results(model) {
            let path = model.table.at(column).path;
            let values = found(&mut stepped, None, &[], column).expect("results");
            for (run, value) in values.iter().enumerate() {
                let wanted = alone[run].row()[column];
                assert!(bits_agree(*value, wanted), "{}.{path} {registers:?} {run}: {value} {wanted}", model.name);
            }
        }
    }
    true
}

#[test]
fn every_model_has_the_bits_of_its_instances() {
    for registers in Registers::here() {
        let (mut random, mut stepped) = (Random(3), 0);
        for model in models() {
            stepped += usize::from((0..2).fold(false, |done, _| done | agree(model, registers, RUNS, &mut random)));
        }
        assert!(stepped >= 60, "{registers:?}: {stepped}");
        assert!(agree(by_name("LuGre").expect("a law"), registers, MANY, &mut random));
    }
}

/// As many runs as are worked on together are alike, and those after them are not: no run has the state of another.
#[test]
fn runs_that_are_alike_are_not_taken_for_others() {
    let law = by_name("LuGre").expect("a law");
    let column = |name: &str| law.find(name).expect("a variable");
    let velocity_of = |run: usize| if run < 64 { 1e-3 } else { -1e-4 * run as f64 };
    for registers in Registers::here() {
        let mut stepped = Stepped::new(law, registers, MANY).expect("memory");
        let mut alone: Vec<Instance> = (0..MANY).map(|_| Instance::new(law)).collect();
        let inputs = [(column("velocity"), (0..MANY).map(velocity_of).collect()), (column("normal_force"), vec![10.0])];
        for step in 0..STEPS {
            let forces = found(&mut stepped, Some(1e-3), &inputs, column("friction_force")).expect("a step");
            for (run, instance) in alone.iter_mut().enumerate() {
                let values = [(column("velocity"), velocity_of(run)), (column("normal_force"), 10.0)];
                instance.set_all(Phase::Setup, values.into_iter()).expect("admitted");
                instance.step(1e-3).expect("a step");
                instance.refresh().expect("results");
                let wanted = instance.row()[column("friction_force")];
                assert!(bits_agree(forces[run], wanted), "{registers:?} run {run}, step {step}");
            }
        }
    }
}

/// One value for all runs is that of each, also after values of their own.
#[test]
fn one_value_for_all_is_in_force_again() {
    let law = by_name("LuGre").expect("a law");
    let [velocity, force] = ["velocity", "friction_force"].map(|name| law.find(name).expect("a variable"));
    for registers in Registers::here() {
        let own = (0..MANY).map(|run| -1e-5 * run as f64).collect();
        let [mut by_one, mut by_each] = [0, 1].map(|_| Stepped::new(law, registers, MANY).expect("memory"));
        for values in [vec![1e-3], own, vec![1e-3], vec![2e-3]] {
            let each = if values.len() == 1 { vec![values[0]; MANY] } else { values.clone() };
            let forces = found(&mut by_one, Some(1e-3), &[(velocity, values)], force);
            assert_eq!(forces, found(&mut by_each, Some(1e-3), &[(velocity, each)], force), "{registers:?}");
        }
    }
}

/// An output that is not finite is refused, even if all states are: the power, but not the energy of a short step.
#[test]
fn an_output_that_is_not_finite_is_refused() {
    let law = by_name("LuGre").expect("a law");
    let [velocity, force] = ["velocity", "friction_force"].map(|name| law.find(name).expect("a variable"));
    let large = MANY - 80;
    for registers in Registers::here() {
        let mut stepped = Stepped::new(law, registers, MANY).expect("memory");
        let speeds = (0..MANY).map(|run| if run == large { 1e160 } else { 1e-3 }).collect();
        let refused = found(&mut stepped, Some(1e-20), &[(velocity, speeds)], force).expect_err("infinite power");
        assert!(refused.starts_with(&format!("run {large}: ")) && refused.contains("velocity = 1e160"), "{refused}");
        assert_eq!(stepped.times(), [0.0; MANY]);
    }
}

/// Whatever is refused names the run, and leaves all runs as they are.
#[test]
fn what_is_refused_changes_nothing() {
    let law = by_name("LuGre").expect("a law");
    let column = |name: &str| law.find(name).expect("a variable");
    let [velocity, load, force, mu_s] = ["velocity", "normal_force", "friction_force", "mu_s"].map(column);
    for registers in Registers::here() {
        let mut stepped = Stepped::new(law, registers, MANY).expect("memory");
        let usual = [(velocity, vec![1e-3; MANY]), (load, vec![10.0])];
        let at = |run: usize, value: f64| (0..MANY).map(|one| if one == run { value } else { 1e-3 }).collect();
        found(&mut stepped, Some(1e-3), &usual, force).expect("a step");
        let before = everything(law, &mut stepped);
        let nan: (usize, Vec<f64>) = (velocity, at(140, f64::NAN));
        let large = [(velocity, at(97, 1e308)), (load, vec![1e300])];
        for (dt, inputs, text) in [
            (1e-3, &[(load, vec![5.0]), nan][..], "run 140: velocity = NaN: must be a finite number"),
            (1e-3, &large[..], "run 97: a step of 0.001 s would not be finite"),
            (0.0, &usual[..], "run 0: a step of 0 s: must be > 0 and finite"),
        ] {
            let refused = found(&mut stepped, Some(dt), inputs, force).expect_err("a refusal");
            assert!(refused.starts_with(text), "{registers:?}: {refused}");
            assert_eq!(before, everything(law, &mut stepped), "{registers:?}: {text}");
        }
        let (run, ended) =
            stepped.set(&[(mu_s, &[0.2]), (mu_s, &at(3, -1.0)), (force, &[1.0])]).expect_err("a refusal");
        assert_eq!((run, ended.to_string()), (3, "mu_s = -1: must be >= 0 and finite".to_string()));
        assert_eq!(before, everything(law, &mut stepped), "{registers:?}");
        for dt in [0.0, -1e-3, f64::NAN, f64::INFINITY] {
            let wanted = Wanted { of: &[force], by: &[velocity], dt: Some(dt) };
            let (run, ended) = stepped.derivatives(wanted, &mut |_, _, _| ()).expect_err("a refusal");
            assert_eq!((run, ended.to_string()), (0, format!("a step of {dt} s: must be > 0 and finite")));
        }
        let mut full = |_: Range<usize>, _: &[f64]| Err((2, Fault::new(format_args!("no place"))));
        let (run, ended) = stepped.step(1e-3, &given(&usual), force, &mut full).expect_err("a refusal");
        assert_eq!((run, ended.to_string()), (2, "no place".to_string()));
        assert_eq!(before, everything(law, &mut stepped), "{registers:?}");
        assert_eq!(stepped.times(), [1e-3; MANY]);
        // Parameters that are admitted one by one but not together are told at the first step.
        stepped.set(&[(mu_s, &at(5, 0.01))]).expect("admitted one by one");
        let refused = found(&mut stepped, Some(1e-3), &usual, force).expect_err("a refusal");
        assert!(refused.starts_with("run 0: mu_s"), "{refused}");
    }
}

/// A step that its caller ends by a panic leaves all runs as they are.
#[test]
fn a_caller_that_panics_changes_nothing() {
    let law = by_name("LuGre").expect("a law");
    let column = |name: &str| law.find(name).expect("a variable");
    let [velocity, load, force] = ["velocity", "normal_force", "friction_force"].map(column);
    let mut stepped = Stepped::new(law, Registers::best(), MANY).expect("memory");
    let inputs = [(velocity, vec![1e-3; MANY]), (load, vec![10.0])];
    found(&mut stepped, Some(1e-3), &inputs, force).expect("a step");
    let before = everything(law, &mut stepped);
    let mut fall = |_: Range<usize>, _: &[f64]| panic!("the caller falls");
    let step = || stepped.step(1e-3, &[(velocity, &[-0.7])], force, &mut fall);
    assert!(catch_unwind(AssertUnwindSafe(step)).is_err());
    assert_eq!(before, everything(law, &mut stepped));
    assert_eq!(stepped.times(), [1e-3; MANY]);
}

/// Derivatives of all results by all real columns over a step, against differences of rows.
#[test]
fn derivatives_over_a_step_are_those_of_differences() {
    let mut compared = 0;
    for law in models() {
        let mut stepped = Stepped::new(law, Registers::best(), 1).expect("memory");
        if stepped.differentiates_steps() {
            compared += compare_derivatives(law, &mut stepped, 1e-4);
        }
    }
    assert!(compared > 200, "{compared} derivatives");
}

/// Number of derivatives of a law that are not 0, each of which has been compared.
fn compare_derivatives(law: &'static ModelType, stepped: &mut Stepped, dt: f64) -> usize {
    let start = moving(law, stepped, dt);
    let (of, by) = smooth_columns(law);
    let mut slopes = vec![vec![f64::NAN; by.len()]; of.len()];
    let wanted = Wanted { of: &of, by: &by, dt: Some(dt) };
    stepped.derivatives(wanted, &mut |[of, by], _, slope| slopes[of][by] = slope).expect("derivatives");
    let mut compared = 0;
    for (number, column) in by.iter().enumerate().filter(|(_, column)| start[**column] != 0.0) {
        let change = 1e-5 * start[*column].abs();
        let [above, below] = [change, -change].map(|change| {
            let mut row = start.clone();
            row[*column] += change;
            assert!(law.advance(&mut row, dt), "{}", law.name);
            row
        });
        for (slopes, result) in slopes.iter().zip(&of) {
            let difference = (above[*result] - below[*result]) / (2.0 * change);
            let size = above[*result].abs() / start[*column].abs() + difference.abs();
            let [of, by] = [result, column].map(|column| law.table.at(*column).path);
            let slope = slopes[number];
            assert!((slope - difference).abs() <= 1e-6 * size, "{}: {of} by {by}: {slope} {difference}", law.name);
            compared += usize::from(difference != 0.0);
        }
    }
    compared
}

/// The row of a run that has begun to move.
fn moving(law: &'static ModelType, stepped: &mut Stepped, dt: f64) -> Vec<f64> {
    let inputs = [("velocity", 4e-4), ("normal_force", 9.0), ("velocity_x", 3e-4), ("velocity_y", 2e-4)];
    let inputs: Vec<Column> = inputs.iter().filter_map(|(name, value)| Some((law.find(name)?, vec![*value]))).collect();
    let force = law.table.iter().position(|variable| variable.role == Role::Output).expect("an output");
    found(stepped, Some(dt), &inputs, force).expect("a step");
    (0..law.table.len()).map(|column| found(stepped, None, &[], column).expect("a column")[0]).collect()
}

/// The columns that can be differentiated, and those by which they can be.
fn smooth_columns(law: &'static ModelType) -> (Vec<usize>, Vec<usize>) {
    let of = results(law).into_iter().filter(|column| is_smooth(&law.table.at(*column))).collect();
    let is_given = |column: &usize| {
        let variable = law.table.at(*column);
        variable.role != Role::Output && is_smooth(&variable)
    };
    (of, (0..law.table.len()).filter(is_given).collect())
}

fn is_smooth(variable: &Variable) -> bool {
    matches!(variable.kind, Kind::Real(_)) && !variable.jumps && !variable.is_advice
}
