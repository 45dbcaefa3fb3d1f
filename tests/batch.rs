//! Rows side by side in registers have the bits of each by itself, whatever the registers; and the values of formulas in
//! 50 digits.

mod common;
#[path = "batch/stepped.rs"]
mod stepped;

use std::ops::Range;
use std::sync::atomic::AtomicBool;

use common::random::Random;
use common::rows;
use stribeck::batch::{Batch, Points, Registers, Rows, Runs, Steady, Worker};
use stribeck::catalogue::{by_name, models};
use stribeck::instance::Instance;
use stribeck::model::ModelType;
use stribeck::series::{Between, Course, Ended, Input, Times, follow, set_up};

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
        assert!(laws >= 23, "{registers:?}: {laws}");
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
        let mut velocity = values(runs * samples, 3e-3);
        let mu = values(runs, 0.05).iter().map(|value| 0.1 + value).collect();
        let mut load: Vec<f64> = values(runs * samples, 5.0).iter().map(|value| 10.0 + value).collect();
        // At rest, and without load.
        velocity.iter_mut().skip(11).step_by(13).for_each(|value| *value = 0.0);
        load.iter_mut().skip(12).step_by(17).for_each(|value| *value = 0.0);
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

    fn begin(&self, run: usize, instance: &mut Instance) -> Result<(), Ended> {
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
        for law in ["LuGre", "BrownMcPhee", "Dahl", "ElastoPlastic", "Dankowicz", "SpeckerDynamic"] {
            for between in [Between::Held, Between::Linear] {
                for [runs, samples] in [[1, 150], [2, 64], [21, 9], [18, 40]] {
                    Case::of(law, [runs, samples], between, &all).check(registers);
                    Case::of(law, [runs, samples], between, &forces).check(registers);
                }
            }
        }
    }
}

/// The run that ends a worker's, and why.
fn refusal(case: &Case, dt: f64, some: Range<usize>, registers: Registers) -> (usize, String) {
    let inputs = case.rows();
    let (times, between, samples) = (Times::Every(dt), case.between, case.samples);
    let all = Runs { inputs: &inputs, times, samples, between, results: &case.results };
    let mut worker = Worker::new(case.law, &all, registers).expect("memory");
    let mut arrays = vec![vec![f64::NAN; some.len() * samples]; case.results.len()];
    let mut places: Vec<&mut [f64]> = arrays.iter_mut().map(Vec::as_mut_slice).collect();
    let begin = |run: usize, instance: &mut Instance| case.begin(run, instance);
    let mut instance = Instance::new(case.law);
    let made = worker.make(&mut instance, &all, some, &begin, &mut places, &NEVER);
    made.map_err(|(run, ended)| (run, ended.to_string())).expect_err("a refusal")
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
            let (run, ended) = refusal(&case, 1e-3, 4..20, registers);
            assert_eq!(run, 13, "{registers:?}");
            assert!(ended.contains("sample 4") && ended.contains(text), "{ended}");
        }
    }
}

/// A deflection and an input that stays as it is, so large at the beginning that the energy of a step is not finite, while
/// all outputs are: the runs end whether the energy is recorded or not, along their samples and side by side.
#[test]
fn a_start_with_which_a_step_fails_is_refused() {
    for registers in Registers::here() {
        for (input, start, dt) in [(100.0, 1.5e301, 10.0), (1e150, 0.0, 1e15)] {
            for runs in [1, 5] {
                let mut case = Case::of("LuGre", [runs, 40], Between::Held, &["friction_force"]);
                case.inputs.remove(0);
                case.inputs[0].1.fill(1e10);
                for (name, value) in [("velocity", input), ("bristle_deflection", start)] {
                    case.parameters.push((case.law.find(name).expect(name), vec![value; runs]));
                }
                let (run, ended) = refusal(&case, dt, 0..runs, registers);
                assert_eq!(run, 0, "{registers:?}");
                assert!(ended.contains(&format!("a step of {dt} s would not be finite")), "{registers:?}: {ended}");
            }
        }
    }
}

/// Number of runs and samples of those below.
const MANY: usize = 18;
const LONG: usize = 20;

/// The results of all runs of a law: of a worker, and of instances that follow their inputs alone.
fn both_ways(
    law: &'static ModelType,
    runs: &Runs,
    registers: Registers,
    parameters: &[(usize, f64)],
) -> [Result<Vec<Vec<f64>>, String>; 2] {
    let begin = |_: usize, instance: &mut Instance| {
        instance.reset();
        set_up(instance, parameters)
    };
    let mut arrays = vec![vec![f64::NAN; MANY * runs.samples]; runs.results.len()];
    let mut alone = arrays.clone();
    let mut instance = Instance::new(law);
    let mut worker = Worker::new(law, runs, registers).expect("memory");
    let together = Worker::together(law);
    let made = (0..MANY).step_by(together).try_for_each(|first| {
        let part = |array: &mut Vec<f64>| array.split_off(first * runs.samples);
        let mut rests: Vec<Vec<f64>> = arrays.iter_mut().map(part).collect();
        let mut places: Vec<&mut [f64]> = rests.iter_mut().map(Vec::as_mut_slice).collect();
        let some = first..MANY.min(first + together);
        let done = worker.make(&mut instance, runs, some, &begin, &mut places, &NEVER);
        arrays.iter_mut().zip(rests).for_each(|(array, rest)| array.extend(rest));
        done
    });
    let followed = (0..MANY).try_for_each(|run| {
        begin(run, &mut instance).map_err(|ended| (run, ended))?;
        let of = |rows: &Rows| {
            let first = if rows.rows == 1 { 0 } else { run * rows.width };
            (rows.column, rows.values[first..first + rows.width].to_vec())
        };
        let inputs: Vec<(usize, Vec<f64>)> = runs.inputs.iter().map(of).collect();
        let inputs: Vec<Input> = inputs.iter().map(|(column, samples)| Input { column: *column, samples }).collect();
        let course = Course { inputs: &inputs, times: runs.times, samples: runs.samples, between: runs.between };
        let samples = run * runs.samples..(run + 1) * runs.samples;
        let mut places: Vec<&mut [f64]> = alone.iter_mut().map(|array| &mut array[samples.clone()]).collect();
        follow(&mut instance, &course, runs.results, &mut places, &NEVER).map_err(|ended| (run, ended))
    });
    let text = |(run, ended): (usize, Ended)| format!("run {run}: {ended}");
    [made.map(|()| arrays).map_err(text), followed.map(|()| alone).map_err(text)]
}

fn assert_same(law: &'static ModelType, runs: &Runs, parameters: &[(usize, f64)]) {
    for registers in Registers::here() {
        let [made, followed] = both_ways(law, runs, registers, parameters);
        match (made, followed) {
            (Ok(made), Ok(followed)) => {
                for (found, alone) in made.iter().flatten().zip(followed.iter().flatten()) {
                    assert!(bits_agree(*found, *alone), "{} {registers:?}: {found} {alone}", law.name);
                }
            }
            (made, followed) => assert_eq!(made.err(), followed.err(), "{} {registers:?}", law.name),
        }
    }
}

/// Inputs that differ from run to run, from sample to sample, both or neither; samples at equal and unequal intervals;
/// results that are advice, and a contact that knows the mass of its body, which has modes.
#[test]
fn shared_and_constant_inputs_have_the_bits_of_each_alone() {
    let mut random = Random(8);
    let mut values = |count: usize, middle: f64, half: f64| -> Vec<f64> {
        (0..count).map(|_| middle + half * random.signed()).collect()
    };
    let (velocities, loads) = (values(MANY * LONG, 0.0, 3e-3), values(MANY * LONG, 10.0, 5.0));
    let mut at = vec![0.0];
    values(LONG - 1, 2e-3, 1e-3).iter().for_each(|step| at.push(at[at.len() - 1] + step));
    for name in ["LuGre", "Threlfall", "CoulombViscous"] {
        let law = by_name(name).expect("a law");
        let column = |name: &str| law.find(name).expect("a variable");
        let results = ["friction_force", "dissipated_energy", "sticking"].map(column);
        let mass: Vec<(usize, f64)> = law.find("mass").into_iter().map(|column| (column, 1.0)).collect();
        for [rows, width] in [[1, 1], [1, LONG], [MANY, 1], [MANY, LONG]] {
            let velocity = Rows { column: column("velocity"), rows: MANY, width: LONG, values: &velocities };
            let values = &loads[..rows * width];
            let load = Rows { column: column("normal_force"), rows, width, values };
            let inputs = [Rows { values: &velocities[..rows * width], rows, width, ..velocity }, load];
            for times in [Times::Every(1e-3), Times::At(&at)] {
                for (between, results) in [(Between::Held, &results[..]), (Between::Linear, &results[..1])] {
                    let runs = Runs { inputs: &inputs, times, samples: LONG, between, results };
                    assert_same(law, &runs, &[]);
                    assert_same(law, &runs, &mass);
                }
            }
        }
    }
}

/// Times that do not rise or are not finite, parameters and inputs that are not admitted, and a parameter that moves like
/// an input are refused as they are alone.
#[test]
fn what_is_refused_alone_is_refused_side_by_side() {
    let falling: Vec<f64> = (0..LONG).map(|sample| if sample == 7 { 0.0 } else { sample as f64 }).collect();
    let endless: Vec<f64> =
        (0..LONG).map(|sample| if sample == LONG - 1 { f64::INFINITY } else { sample as f64 }).collect();
    let law = by_name("LuGre").expect("a law");
    let column = |name: &str| law.find(name).expect("a variable");
    let (force, mu) = (column("friction_force"), column("mu_k"));
    let values = [1e-3; LONG];
    let input = |column| [Rows { column, rows: 1, width: LONG, values: &values }];
    for times in
        [Times::At(&falling), Times::At(&endless), Times::Every(0.0), Times::Every(f64::NAN), Times::Every(1e-3)]
    {
        for inputs in [input(column("velocity")), input(mu), input(force)] {
            for parameters in [&[][..], &[(mu, -1.0)][..]] {
                for results in [&[force][..], &[column("bristle_deflection")][..]] {
                    let between = Between::Held;
                    let runs = Runs { inputs: &inputs, times, samples: LONG, between, results };
                    assert_same(law, &runs, parameters);
                }
            }
        }
    }
}

/// One long run is made along its samples if no result depends on the steps; otherwise nothing is made.
#[test]
fn outputs_of_one_run_have_the_bits_of_the_run() {
    let values: Vec<f64> = (0..37).map(|sample| 1e-3 * (sample as f64 - 18.0)).collect();
    let begin = |_: usize, instance: &mut Instance| set_up(instance, &[]);
    for registers in Registers::here() {
        for (name, result, may) in [
            ("BrownMcPhee", "friction_force", true),
            ("BrownMcPhee", "dissipated_energy", false),
            ("LuGre", "friction_force", false),
            ("Karnopp", "friction_force", false),
        ] {
            let law = by_name(name).expect("a law");
            let column = |name: &str| law.find(name).expect("a variable");
            let inputs = [Rows { column: column("velocity"), rows: 1, width: values.len(), values: &values }];
            let (times, between, results) = (Times::Every(1e-3), Between::Linear, [column(result)]);
            let runs = Runs { inputs: &inputs, times, samples: values.len(), between, results: &results };
            let mut worker = Worker::new(law, &runs, registers).expect("memory");
            let mut found = vec![f64::NAN; values.len()];
            let mut instance = Instance::new(law);
            let done = worker.make_outputs(&mut instance, &runs, &begin, &mut [&mut found], &NEVER);
            assert_eq!(done, may && registers != Registers::Scalar, "{name} {result} {registers:?}");
            if done {
                for (velocity, force) in values.iter().zip(found) {
                    instance.set_column(inputs[0].column, *velocity).expect("a velocity");
                    let alone = instance.get_column(results[0]).expect("a force");
                    assert_eq!(force.to_bits(), alone.to_bits(), "{velocity}");
                }
            }
        }
    }
}

/// Cancelled runs say so, whichever way they would have been made.
#[test]
fn cancelled_runs_say_so() {
    let cancelled = AtomicBool::new(true);
    let begin = |_: usize, instance: &mut Instance| set_up(instance, &[]);
    for registers in Registers::here() {
        for (name, result) in [("LuGre", "friction_force"), ("Threlfall", "friction_force"), ("Karnopp", "sticking")] {
            let law = by_name(name).expect("a law");
            let column = |name: &str| law.find(name).expect("a variable");
            let values = [1e-3; LONG];
            let inputs = [Rows { column: column("velocity"), rows: 1, width: LONG, values: &values }];
            let (times, between, results) = (Times::Every(1e-3), Between::Held, [column(result)]);
            let runs = Runs { inputs: &inputs, times, samples: LONG, between, results: &results };
            let mut worker = Worker::new(law, &runs, registers).expect("memory");
            let some = 2..2 + Worker::together(law);
            let mut found = vec![f64::NAN; some.len() * LONG];
            let mut instance = Instance::new(law);
            let ended = worker.make(&mut instance, &runs, some, &begin, &mut [&mut found], &cancelled);
            assert!(matches!(ended, Err((2, Ended::Cancelled))), "{name} {registers:?}: {ended:?}");
        }
    }
}

/// Velocities and loads of points, and their forces.
struct Map {
    inputs: [Vec<f64>; 2],
    forces: Vec<f64>,
}

impl Points for Map {
    fn read(&self, input: usize, points: Range<usize>, values: &mut [f64]) {
        values.copy_from_slice(&self.inputs[input][points]);
    }

    fn write(&mut self, result: usize, points: Range<usize>, values: &[f64]) {
        assert_eq!(result, 0);
        self.forces[points].copy_from_slice(values);
    }
}

/// Steady sliding at many points against an instance at each, whose states differ at rest; and the point that is refused.
#[test]
fn points_of_steady_sliding_have_the_bits_of_each_by_itself() {
    let mut random = Random(11);
    let mut laws = 0;
    for law in models() {
        let columns = ["velocity", "normal_force", "friction_force"].map(|name| law.find(name));
        let [Some(velocity), Some(load), Some(force)] = columns else { continue };
        let mut instance = Instance::new(law);
        if !law.slides_steadily(instance.row()) {
            continue;
        }
        laws += 1;
        instance.check().expect("start values");
        let mut size = |from: f64, to: f64| 10f64.powf(from + (to - from) * random.next());
        let mut inputs = [(); 2].map(|()| (0..200).map(|_| size(-9.0, 2.0)).collect::<Vec<f64>>());
        inputs[0].iter_mut().step_by(2).for_each(|velocity| *velocity = -*velocity);
        inputs.iter_mut().for_each(|values| values[7] = 0.0);
        inputs[0][131] = 0.0;
        for registers in Registers::here() {
            let (columns, results) = ([velocity, load], [force]);
            let steady = Steady::of(&instance, registers, &columns, &results).expect("memory");
            let mut map = Map { inputs: inputs.clone(), forces: vec![f64::NAN; 200] };
            steady.expect(law.name).make(0..200, &mut map).expect(law.name);
            for (point, found) in map.forces.iter().enumerate() {
                let mut alone = Instance::new(law);
                alone.set_column(velocity, inputs[0][point]).expect("a velocity");
                alone.set_column(load, inputs[1][point]).expect("a load");
                assert!(alone.slide_steadily().expect(law.name), "{}", law.name);
                let force = alone.get_column(force).expect(law.name);
                assert!(bits_agree(*found, force), "{} {registers:?} {point}: {found} {force}", law.name);
            }
            map.inputs[1][100] = -1.0;
            let mut steady = Steady::of(&instance, registers, &columns, &results).expect("memory").expect(law.name);
            let refused = steady.make(0..200, &mut map).expect_err("a negative load");
            assert!(refused.contains(&100) && refused.len() <= 64, "{refused:?}");
        }
    }
    assert!(laws >= 30, "{laws}");
}
