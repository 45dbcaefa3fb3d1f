//! Rows side by side in registers have the bits of each by itself, whatever the registers; and the values of formulas in
//! 50 digits.

mod common;

use std::sync::atomic::AtomicBool;

use common::random::Random;
use common::rows;
use stribeck::batch::{Batch, Registers, Rows, Runs, Worker};
use stribeck::catalogue::{by_name, models};
use stribeck::instance::Instance;
use stribeck::model::ModelType;
use stribeck::series::{Between, Course, Input, Times, follow, set_up};

static NEVER: AtomicBool = AtomicBool::new(false);

/// Rows that are worked on together: more than a group of any registers, and not a multiple of one.
const ROWS: usize = 19;
/// Times that they are drawn anew.
const TRIED: usize = 60;

fn registers() -> Vec<Registers> {
    Registers::here().filter(|registers| *registers != Registers::Scalar).collect()
}

fn bits_agree(side_by_side: f64, alone: f64) -> bool {
    side_by_side.to_bits() == alone.to_bits() || side_by_side.is_nan() && alone.is_nan()
}

/// Every column of all rows after outputs and steps, against the same in each row.
fn agree(law: &'static ModelType, registers: Registers, random: &mut Random) -> bool {
    let share = random.next();
    let Some(mut batch) = Batch::new(law, registers, ROWS).expect("memory") else { return false };
    let mut drawn: Vec<Vec<f64>> = Vec::new();
    while drawn.len() < ROWS {
        let mut row = rows::row(law, share, random);
        // Only a step with a mass leaves these.
        for left in ["planning_step", "planned_force", "end_velocity", "end_external_force", "end_normal_force"] {
            law.find(left).into_iter().for_each(|column| row[column] = 0.0);
        }
        for left in ["velocity_change", "external_force_change", "normal_force_change"] {
            law.find(left).into_iter().for_each(|column| row[column] = 0.0);
        }
        if batch.load(drawn.len()..drawn.len() + 1, &row) {
            drawn.push(row);
        }
    }
    for _ in 0..3 {
        let dt = 10f64.powf(-3.0 + 3.0 * random.signed());
        // A row that is not finite stays as it was, alone; side by side it is reported.
        let mut are_finite = batch.output();
        drawn.iter_mut().for_each(|row| are_finite &= law.output(row));
        are_finite &= batch.advance(dt);
        drawn.iter_mut().for_each(|row| are_finite &= law.advance(row, dt));
        if !are_finite {
            return true;
        }
        batch.output();
        drawn.iter_mut().for_each(|row| assert!(law.output(row)));
        for (column, variable) in law.table.iter().enumerate() {
            batch.get(column, |row, value| {
                let alone = drawn[row][column];
                assert!(bits_agree(value, alone), "{}.{} {registers:?}: {value} {alone}", law.name, variable.path);
            });
        }
    }
    true
}

#[test]
fn rows_side_by_side_have_the_bits_of_each_alone() {
    for registers in registers() {
        let mut laws = 0;
        for law in models() {
            let mut random = Random(21);
            laws += usize::from((0..TRIED).fold(false, |_, _| agree(law, registers, &mut random)));
        }
        assert_eq!(laws, 23, "{registers:?}");
    }
}

/// Runs of a law over given inputs, all results of all samples.
struct Case {
    law: &'static ModelType,
    runs: usize,
    samples: usize,
    between: Between,
    results: Vec<usize>,
    parameters: Vec<(usize, Vec<f64>)>,
    inputs: Vec<(usize, Vec<f64>)>,
}

impl Case {
    fn of(name: &str, [runs, samples]: [usize; 2], between: Between, results: &[&str]) -> Case {
        let law = by_name(name).expect("a law");
        let column = |name: &str| law.find(name).expect("a variable");
        let mut random = Random(5);
        let mut values = |count: usize, scale: f64| (0..count).map(|_| scale * random.signed()).collect::<Vec<f64>>();
        let velocity = values(runs * samples, 3e-3);
        let mu = values(runs, 0.05).iter().map(|value| 0.1 + value).collect();
        let load = values(runs * samples, 5.0).iter().map(|value| 10.0 + value).collect();
        Case {
            law,
            runs,
            samples,
            between,
            results: results.iter().map(|name| column(name)).collect(),
            parameters: vec![(column("mu_k"), mu)],
            inputs: vec![(column("velocity"), velocity), (column("normal_force"), load)],
        }
    }

    fn begin(&self, run: usize, instance: &mut Instance) -> Result<(), stribeck::series::Ended> {
        instance.reset();
        let values: Vec<(usize, f64)> = self.parameters.iter().map(|(column, values)| (*column, values[run])).collect();
        set_up(instance, &values)
    }

    fn alone(&self, run: usize) -> Vec<Vec<f64>> {
        let mut instance = Instance::new(self.law);
        self.begin(run, &mut instance).expect("parameters");
        let samples = run * self.samples..(run + 1) * self.samples;
        let given = self.inputs.iter();
        let inputs: Vec<Input> =
            given.map(|(column, values)| Input { column: *column, samples: &values[samples.clone()] }).collect();
        let times = Times::Every(1e-3);
        let course = Course { inputs: &inputs, times, samples: self.samples, between: self.between };
        let mut results = vec![vec![f64::NAN; self.samples]; self.results.len()];
        let mut rows: Vec<&mut [f64]> = results.iter_mut().map(Vec::as_mut_slice).collect();
        follow(&mut instance, &course, &self.results, &mut rows, &NEVER).expect("a run");
        results
    }

    /// The inputs of all runs.
    fn rows(&self) -> Vec<Rows<'_>> {
        let of = |column: usize, values| Rows { column, rows: self.runs, width: self.samples, values };
        self.inputs.iter().map(|(column, values)| of(*column, values)).collect()
    }

    fn check(&self, registers: Registers) {
        let inputs = self.rows();
        let (times, samples) = (Times::Every(1e-3), self.samples);
        let all = Runs { inputs: &inputs, times, samples, between: self.between, results: &self.results };
        let mut worker = Worker::new(self.law, &all, registers).expect("memory");
        let mut instance = Instance::new(self.law);
        for first in (0..self.runs).step_by(Worker::together(self.law)) {
            let some = first..self.runs.min(first + Worker::together(self.law));
            let mut arrays = vec![vec![f64::NAN; some.len() * self.samples]; self.results.len()];
            let mut places: Vec<&mut [f64]> = arrays.iter_mut().map(Vec::as_mut_slice).collect();
            let begin = |run: usize, instance: &mut Instance| self.begin(run, instance);
            worker.make(&mut instance, &all, some.clone(), &begin, &mut places, &NEVER).expect("runs");
            for (place, run) in some.enumerate() {
                for (array, alone) in arrays.iter().zip(self.alone(run)) {
                    let found = &array[place * self.samples..(place + 1) * self.samples];
                    for (sample, (found, alone)) in found.iter().zip(alone).enumerate() {
                        assert!(bits_agree(*found, alone), "{} {registers:?} {run} {sample}", self.law.name);
                    }
                }
            }
        }
    }
}

/// Side by side, along the samples, and one after the other: laws with and without memory, and one with modes.
#[test]
fn runs_have_the_bits_of_each_alone() {
    let (all, forces) = (["friction_force", "dissipated_energy"], ["friction_force", "dissipated_power", "sticking"]);
    for registers in Registers::here() {
        for law in ["LuGre", "BrownMcPhee", "Dahl", "ElastoPlastic"] {
            for between in [Between::Held, Between::Linear] {
                for [runs, samples] in [[1, 50], [21, 9], [18, 40]] {
                    Case::of(law, [runs, samples], between, &all).check(registers);
                    Case::of(law, [runs, samples], between, &forces).check(registers);
                }
            }
        }
    }
}

/// A run with a value that is refused, and one whose results would not be finite, are named as when made alone.
#[test]
fn the_first_run_that_fails_is_the_one_that_is_named() {
    for registers in Registers::here() {
        for (value, text) in [(f64::NAN, "velocity = NaN: must be a finite number"), (1e308, "would not be finite")] {
            let mut case = Case::of("LuGre", [20, 30], Between::Held, &["friction_force", "dissipated_energy"]);
            for run in [17, 13] {
                case.inputs[0].1[run * 30 + 4] = value;
                case.inputs[1].1[run * 30 + 4] = 1e300;
            }
            let inputs = case.rows();
            let (times, between) = (Times::Every(1e-3), Between::Held);
            let all = Runs { inputs: &inputs, times, samples: 30, between, results: &case.results };
            let mut worker = Worker::new(case.law, &all, registers).expect("memory");
            let mut arrays = vec![vec![f64::NAN; 16 * 30]; 2];
            let mut places: Vec<&mut [f64]> = arrays.iter_mut().map(Vec::as_mut_slice).collect();
            let begin = |run: usize, instance: &mut Instance| case.begin(run, instance);
            let mut instance = Instance::new(case.law);
            let (run, ended) =
                worker.make(&mut instance, &all, 4..20, &begin, &mut places, &NEVER).expect_err("a refusal");
            assert_eq!(run, 13, "{registers:?}");
            assert!(ended.to_string().contains("sample 4") && ended.to_string().contains(text), "{ended}");
        }
    }
}
