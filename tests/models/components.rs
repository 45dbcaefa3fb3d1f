//! Properties that every component promises: machine parts with friction that no normal force presses together.

use crate::common::random::Random;
use crate::common::{Bench, rows};
use approx::abs_diff_eq;
use stribeck::catalogue::{self, Family};
use stribeck::instance::Instance;
use stribeck::model::{Kind, ModelType, Role, Variable};

fn components() -> impl Iterator<Item = &'static ModelType> {
    catalogue::documented(Family::Component).map(|(model, _)| model)
}

/// Inputs within a few times their usual size.
fn drive(bench: &mut Bench, random: &mut Random) {
    for (column, variable) in inputs(bench.instance.model()) {
        let size = if variable.path.to_string() == "velocity" { 0.1 } else { 2.0 };
        let value = size * random.signed();
        let value = if variable.admits(value) { value } else { -value };
        bench.instance.set_column(column, value).unwrap();
    }
}

fn inputs(model: &'static ModelType) -> impl Iterator<Item = (usize, Variable)> {
    model.variables().filter(|(_, variable)| variable.role == Role::Input)
}

fn is_continuous(variable: &Variable) -> bool {
    variable.is_continuous_state() && matches!(variable.kind, Kind::Real(_))
}

#[test]
fn every_component_has_the_common_columns() {
    assert!(components().count() > 0);
    for model in components() {
        let role = |name: &str| model.find(name).map(|column| model.table.at(column).role);
        for (name, expected) in [
            ("velocity", Role::Input),
            ("dissipated_energy", Role::StateOutput),
            ("friction_force", Role::Output),
            ("dissipated_power", Role::Output),
        ] {
            assert_eq!(role(name), Some(expected), "{} {name}", model.name);
        }
        assert_eq!(model.find("normal_force"), None, "{}", model.name);
        for preset in model.presets {
            let mut bench = Bench::new(model.name, &[]);
            assert!(bench.instance.apply(preset.name));
            bench.step(1e-3);
        }
    }
}

/// A step of any admitted row, with inputs of any size, gives finite results or is refused and leaves no trace.
#[test]
fn every_step_is_finite_or_refused_without_a_trace() {
    for model in components() {
        let mut random = Random(31);
        let (mut done, mut refused) = (0, 0);
        for case in 0..300 {
            let row = rows::row(model, if case % 2 == 0 { 0.3 } else { 1.0 }, &mut random);
            let mut bench = Bench::new(model.name, &[]);
            // Steps have no events, which alone set a phase.
            let is_set = |variable: &Variable| variable.role != Role::Output && !variable.is_settled_by_events();
            for (column, _) in model.variables().filter(|(_, variable)| is_set(variable)) {
                bench.instance.set_column(column, row[column]).unwrap();
            }
            if case % 3 == 0 {
                let velocity = bench.column("velocity");
                bench.instance.set_column(velocity, 10f64.powf(300.0 * random.next())).unwrap();
            }
            if bench.instance.refresh().is_err() {
                continue;
            }
            let before = bench.instance.save();
            match bench.instance.step(10f64.powf(-6.0 + 8.0 * random.next())) {
                Ok(()) => {
                    assert!(bench.instance.row().iter().all(|value| value.is_finite()), "{}", model.name);
                    done += 1;
                }
                Err(fault) => {
                    assert!(fault.to_string().ends_with("nothing was changed"), "{fault}");
                    assert_eq!(bench.instance.save(), before, "{}", model.name);
                    refused += 1;
                }
            }
        }
        assert!(done > 100, "{}: {done} done, {refused} refused", model.name);
    }
}

#[test]
fn two_half_steps_are_one_step_of_a_component() {
    for model in components() {
        let (mut whole, mut halves) = (Bench::new(model.name, &[]), Bench::new(model.name, &[]));
        let mut random = Random(37);
        for _ in 0..50 {
            drive(&mut whole, &mut random);
            for (column, _) in inputs(model) {
                halves.instance.set_column(column, whole.instance.row()[column]).unwrap();
            }
            let h = 10f64.powf(-4.0 + 3.0 * random.next());
            whole.step(h);
            halves.step(0.5 * h);
            halves.step(0.5 * h);
            whole.instance.refresh().unwrap();
            halves.instance.refresh().unwrap();
            for (column, variable) in model.variables().filter(|(_, variable)| !matches!(variable.role, Role::Input)) {
                let (one, two) = (whole.instance.row()[column], halves.instance.row()[column]);
                // Each piece of a step may be off by 1e-10 of a state or of its usual size; a force adds up stiff
                // parts.
                let scale = if variable.role == Role::Output { 1e3 } else { one.abs().max(variable.nominal) };
                assert!(
                    abs_diff_eq!(one, two, epsilon = 1e-7 * scale),
                    "{} {}: {one} {two}",
                    model.name,
                    variable.path
                );
            }
        }
    }
}

/// Rates of the states against differences over a short step; that of the energy is the power.
#[test]
fn rates_of_a_component_are_the_derivatives_of_its_states() {
    for model in components() {
        let mut bench = Bench::new(model.name, &[]);
        let mut random = Random(41);
        for _ in 0..50 {
            drive(&mut bench, &mut random);
            bench.step(0.02 * random.next());
            let rates: Vec<f64> = bench.instance.time_derivative().iter().map(|dual| dual.slope).collect();
            let power = bench.get("dissipated_power");
            let energy = rates[bench.column("dissipated_energy")];
            assert!(abs_diff_eq!(energy, power, epsilon = 1e-12 * power.abs()), "{}: {energy} W", model.name);
            let before = bench.instance.row().to_vec();
            let h = 1e-8;
            bench.step(h);
            for (column, variable) in model.variables().filter(|(_, variable)| is_continuous(variable)) {
                let quotient = (bench.instance.row()[column] - before[column]) / h;
                let scale = rates[column].abs().max(1e-2 * variable.nominal);
                let name = &variable.path;
                let error = (quotient - rates[column]).abs();
                assert!(error < 5e-3 * scale, "{} {name}: {quotient} against {}", model.name, rates[column]);
            }
        }
    }
}

/// The energy is the integral of force times velocity, here by Simpson's rule over short steps with held velocity.
#[test]
fn energy_of_a_component_is_force_times_distance() {
    for model in components() {
        let mut bench = Bench::new(model.name, &[]);
        let mut random = Random(43);
        for _ in 0..20 {
            drive(&mut bench, &mut random);
            let (velocity, before, h) = (bench.get("velocity"), bench.get("dissipated_energy"), 2e-6);
            let (mut sum, mut last) = (0.0, bench.get("friction_force"));
            for _ in 0..1000 {
                bench.step(h);
                let middle = bench.get("friction_force");
                bench.step(h);
                let end = bench.get("friction_force");
                sum += 2.0 * h / 6.0 * (last + 4.0 * middle + end) * velocity;
                last = end;
            }
            let gained = bench.get("dissipated_energy") - before;
            assert!(abs_diff_eq!(gained, sum, epsilon = 1e-6 * sum.abs().max(1e-3)), "{}: {gained} {sum}", model.name);
        }
    }
}

/// From a saved state, with ramps of the inputs as well, the future is the same to the last bit; a reset forgets all.
#[test]
fn a_restored_component_has_the_same_future() {
    for model in components() {
        let future = |instance: &mut Instance, seed| {
            let mut random = Random(seed);
            for step in 0..100 {
                for (column, variable) in inputs(model) {
                    let value = 0.1 * random.signed();
                    let value = if variable.admits(value) { value } else { -value };
                    instance.set_column(column, value).unwrap();
                    if step % 3 == 0 {
                        instance.set_slope(column, random.next()).unwrap();
                    }
                }
                instance.step(1e-2 * random.next()).unwrap();
            }
            instance.save()
        };
        let mut instance = Instance::new(model);
        let fresh = instance.save();
        future(&mut instance, 1);
        let saved = instance.save();
        let once = future(&mut instance, 2);
        instance.restore(&saved);
        assert_eq!(future(&mut instance, 2), once, "{}", model.name);
        instance.reset();
        assert_eq!(instance.save(), fresh, "{}", model.name);
    }
}

/// A ramp of the velocity against many short steps with its value in their middles.
#[test]
fn ramps_of_a_component_are_many_short_steps() {
    for model in components() {
        let mut random = Random(47);
        let (mut ramp, mut steps) = (Bench::new(model.name, &[]), Bench::new(model.name, &[]));
        for _ in 0..8 {
            let (from, to, h, count) = (0.1 * random.signed(), 0.1 * random.signed(), 0.02, 4000);
            ramp.set("velocity", from);
            let column = ramp.column("velocity");
            ramp.instance.set_slope(column, (to - from) / h).unwrap();
            ramp.step(h);
            for step in 0..count {
                let part = (f64::from(step) + 0.5) / f64::from(count);
                steps.set("velocity", from + (to - from) * part);
                steps.step(h / f64::from(count));
            }
            for (column, variable) in model.variables().filter(|(_, variable)| is_continuous(variable)) {
                let (one, many) = (ramp.instance.row()[column], steps.instance.row()[column]);
                let scale = many.abs().max(variable.nominal);
                let name = &variable.path;
                assert!(abs_diff_eq!(one, many, epsilon = 1e-5 * scale), "{} {name}: {one} {many}", model.name);
            }
        }
    }
}
