//! Evaluations of whole systems beside their connections, one by one.

use stribeck::catalogue::{Family, documented, models};
use stribeck::model::{ModelType, Role, Variable};
use stribeck::number::Dual;

use super::part::Part;
use super::*;
use crate::solve::Equations;

/// Computes the outputs of all parts and passes all values on, so often that each has gone through all parts.
fn settle<T: Copy>(system: &System, rows: &mut [Vec<T>], output: fn(&ModelType, &mut [T])) {
    for _ in 0..=system.wires.len() {
        for (row, part) in rows.iter_mut().zip(&system.parts) {
            output(part.model, row);
        }
        for wire in &system.wires {
            if let WireSource::Variable(from) = wire.from {
                rows[wire.to.part][wire.to.column] = rows[from.part][from.column];
            }
        }
    }
}

fn output(model: &ModelType, row: &mut [f64]) {
    model.output(row);
}

/// Rows with these states at a time, settled; and the value in each column of the states.
struct OneByOne<'a> {
    system: &'a System,
    places: Vec<Place>,
    rows: Vec<Vec<f64>>,
}

impl OneByOne<'_> {
    fn put(&mut self, time: f64, states: &[f64]) {
        for (place, state) in self.places.iter().zip(states) {
            self.rows[place.part][place.column] = *state;
        }
        for (place, signal) in &self.system.signals {
            self.rows[place.part][place.column] = signal.at(time).0;
        }
        settle(self.system, &mut self.rows, output);
    }

    /// The event with which a run begins.
    fn begin(&mut self, time: f64, states: &mut [f64]) {
        for _ in 0..8 {
            self.put(time, states);
            for (row, part) in self.rows.iter_mut().zip(&self.system.parts) {
                assert!(part.model.at_event(row));
            }
            for (place, state) in self.places.iter().zip(&mut *states) {
                *state = self.rows[place.part][place.column];
            }
        }
    }

    fn rates(&mut self, time: f64, states: &[f64]) -> Vec<f64> {
        self.put(time, states);
        let mut rates: Vec<Vec<f64>> = self.rows.iter().map(|row| vec![0.0; row.len()]).collect();
        for ((part, row), rate) in self.system.parts.iter().zip(&self.rows).zip(&mut rates) {
            part.model.rate(row, rate);
        }
        self.places.iter().map(|place| rates[place.part][place.column]).collect()
    }

    /// Derivatives of the rates with respect to a state, or to time.
    fn slopes(&mut self, time: f64, states: &[f64], by: Option<usize>) -> Vec<f64> {
        self.put(time, states);
        let mut rows: Vec<Vec<Dual>> =
            self.rows.iter().map(|row| row.iter().map(|value| Dual::from(*value)).collect()).collect();
        match by {
            Some(state) => rows[self.places[state].part][self.places[state].column].slope = 1.0,
            None => {
                for (place, signal) in &self.system.signals {
                    rows[place.part][place.column].slope = signal.at(time).1;
                }
            }
        }
        settle(self.system, &mut rows, ModelType::output_dual);
        let rates = rows.iter().zip(&self.system.parts).map(|(row, Part { model, .. })| {
            let mut rate = vec![Dual::from(0.0); row.len()];
            model.rate_dual(row, &mut rate);
            rate
        });
        let rates: Vec<Vec<Dual>> = rates.collect();
        self.places.iter().map(|place| rates[place.part][place.column].slope).collect()
    }
}

/// Compares rates and Jacobians from a few states, which are drawn around those at the start, at a few times.
fn compare(system: &System, name: &str) -> bool {
    let Ok(mut motion) = Motion::new(system, &[]) else { return false };
    if motion.has_past() || motion.has_bonds() {
        return false;
    }
    let rows = system.parts.iter().map(|part| part.row.clone()).collect();
    let mut apart = OneByOne { system, places: motion.places().to_vec(), rows };
    let (mut states, mut random) = (motion.start(), fastrand::Rng::with_seed(7));
    let mut same = states.clone();
    motion.at_event(0.0, &mut states).unwrap();
    apart.begin(0.0, &mut same);
    assert_eq!(states, same, "{name}");
    let (scales, count) = (motion.scales().to_vec(), states.len());
    let [mut rates, mut again, mut by_time] = [(); 3].map(|()| vec![f64::NAN; count]);
    let mut jacobian = vec![f64::NAN; count * count];
    for time in [0.0, 0.3, 0.3, 1.7] {
        let drawn: Vec<f64> = states.iter().zip(&scales).map(|(x, scale)| x + scale * (random.f64() - 0.5)).collect();
        motion.linearise(time, &drawn, &mut rates, &mut jacobian, &mut by_time);
        motion.rates(time, &drawn, &mut again);
        assert_eq!(rates, again, "{name} at {time} s");
        assert_eq!(rates, apart.rates(time, &drawn), "{name} at {time} s");
        for column in 0..count {
            let found: Vec<f64> = (0..count).map(|row| jacobian[row * count + column]).collect();
            assert_eq!(found, apart.slopes(time, &drawn, Some(column)), "{name} at {time} s, by state {column}");
        }
        assert_eq!(by_time, apart.slopes(time, &drawn, None), "{name} at {time} s, by time");
    }
    true
}

#[test]
fn systems_are_evaluated_as_their_connections_say() {
    let mut compared = 0;
    for (name, _) in BUILT_IN {
        let source = Source::open(name).unwrap();
        if !source.description.takes_laws() {
            let system = System::assemble(&source, None, &[]).unwrap();
            compared += usize::from(compare(&system, name));
            continue;
        }
        let few = ["CoulombStiction", "LuGre", "BrownMcPhee"];
        for (law, _) in documented(Family::Friction).filter(|(law, _)| *name == "belt" || few.contains(&law.name)) {
            let system = System::assemble(&source, Some(law.name), &[]).unwrap();
            compared += usize::from(compare(&system, &format!("{name} {}", law.name)));
        }
    }
    assert!(compared > 50, "{compared}");
}

/// A contact that slides at a given speed drives an axis, by way of another contact that only hands its force on; a third
/// one is driven by a signal.
const AT_REST_TOML: &str = r#"
title = "Constant parts beside others that move"
until = 1.0
every = 0.1
part.drive.model = "CoulombViscous"
part.load.model = "CoulombStiction"
part.axis.model = "Axis"
part.friction.model = "LuGre"
part.brake.model = "Coulomb"
[connect]
"load.external_force" = "drive.friction_force"
"axis.drive_force" = "load.friction_force"
"axis.friction_force" = "friction.friction_force"
"friction.velocity" = "axis.velocity"
"friction.normal_force" = "brake.friction_force"
[input]
"drive.velocity" = 0.2
"drive.normal_force" = 3.0
"drive.external_force" = 0.0
"load.velocity" = 0.0
"load.normal_force" = 40.0
"brake.velocity" = { sine = { mean = 1.0, amplitude = 0.4, frequency = 2.0 } }
"brake.external_force" = 0.0
"brake.normal_force" = { ramp = { from = 30.0, rate = 5.0 } }
"#;

#[test]
fn parts_that_do_not_move_keep_what_they_give() {
    let source = Source { description: Description::parse(AT_REST_TOML).unwrap(), folder: std::path::PathBuf::new() };
    let system = System::assemble(&source, None, &[]).unwrap();
    assert!(compare(&system, "at rest"));
    // Also before the first event.
    let mut motion = Motion::new(&system, &[]).unwrap();
    let rows = system.parts.iter().map(|part| part.row.clone()).collect();
    let mut apart = OneByOne { system: &system, places: motion.places().to_vec(), rows };
    let states = motion.start();
    let mut rates = vec![f64::NAN; states.len()];
    motion.rates(0.2, &states, &mut rates);
    assert_eq!(rates, apart.rates(0.2, &states));
}

/// An evaluation leaves advice out: its units are those of no input.
#[test]
fn advice_fits_no_input() {
    let variables: Vec<Variable> = models().flat_map(|model| model.table.iter()).collect();
    let advice: Vec<_> = variables.iter().filter(|variable| variable.is_advice).collect();
    assert_eq!(advice.len(), 3);
    for input in variables.iter().filter(|variable| variable.role == Role::Input) {
        assert!(advice.iter().all(|advice| advice.kind != input.kind), "{}", input.path);
    }
}
