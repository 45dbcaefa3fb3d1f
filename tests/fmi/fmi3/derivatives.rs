//! Derivatives of outputs with respect to time, in directions, and their adjoints.

use super::importer::{Choice, Importer};
use super::{Known, reals};
use crate::common::random::Random;
use stribeck::catalogue;
use stribeck::model::{ModelType, Role};
use stribeck_ffi::fmi3::derivatives::*;
use stribeck_ffi::fmi3::lifecycle::{Purpose, State};
use stribeck_ffi::fmi3::types::fmi3Status::*;

type Derivative = unsafe extern "C-unwind" fn(
    *mut std::ffi::c_void,
    *const u32,
    usize,
    *const u32,
    usize,
    *const f64,
    usize,
    *mut f64,
    usize,
) -> stribeck_ffi::fmi3::types::fmi3Status;

impl Importer {
    fn derive(&self, function: Derivative, [unknowns, knowns]: [&[u32]; 2], seed: &[f64], count: usize) -> Vec<f64> {
        let mut result = vec![f64::NAN; count];
        let (unknown, known) = (unknowns.as_ptr(), knowns.as_ptr());
        let (n, m, s) = (unknowns.len(), knowns.len(), seed.len());
        // SAFETY: arrays of the lengths given.
        let status =
            unsafe { function(self.instance, unknown, n, known, m, seed.as_ptr(), s, result.as_mut_ptr(), count) };
        assert_eq!(status, fmi3OK, "{}: {}", self.model.name, self.last_message());
        result
    }
}

/// Outputs that have derivatives, and the time derivatives of the states of Model Exchange, with their numbers of elements.
fn unknowns(model: &ModelType, purpose: Purpose) -> (Vec<u32>, usize) {
    let outputs = reals(model, Role::is_output);
    let outputs = outputs.iter().filter(|output| output.first.check_derivatives().is_ok());
    let mut found: Vec<(u32, usize)> = outputs.map(|output| (output.reference, output.columns.len())).collect();
    if purpose == Purpose::ModelExchange {
        let states = reals(model, Role::is_state).into_iter().filter(|state| state.first.is_continuous_state());
        found.extend(states.map(|state| (state.derivatives, state.columns.len())));
    }
    (found.iter().map(|(reference, _)| *reference).collect(), found.iter().map(|(_, count)| count).sum())
}

fn elements(known: &[Known]) -> usize {
    known.iter().map(|known| known.columns.len()).sum()
}

/// Random inputs, and in Model Exchange random states near their nominal values.
fn disturb(importer: &Importer, purpose: Purpose, random: &mut Random) {
    let is_moved = |role: Role| role == Role::Input || (role.is_state() && purpose == Purpose::ModelExchange);
    for known in reals(importer.model, is_moved) {
        if known.first.jumps {
            continue;
        }
        let values: Vec<f64> = known
            .columns
            .iter()
            .map(|column| {
                let variable = importer.model.table.at(*column);
                let value = variable.start + 0.02 * variable.nominal * random.signed();
                if variable.admits(value) { value } else { variable.start }
            })
            .collect();
        let status = importer.set_all(&[known.reference], &values);
        assert_eq!(status, fmi3OK, "{} {}", importer.model.name, importer.last_message());
    }
}

/// w . (J d) = (J^T w) . d, and each row of J^T by itself.
#[test]
fn the_adjoint_is_the_transposed_directional_derivative() {
    let (mut random, mut count) = (Random(3), 0);
    for model in catalogue::models() {
        for purpose in [Purpose::CoSimulation, Purpose::ModelExchange] {
            if purpose == Purpose::ModelExchange && !model.model_exchange {
                continue;
            }
            let state = [State::StepMode, State::ContinuousTimeMode][usize::from(purpose != Purpose::CoSimulation)];
            let importer = Importer::in_state(model.name, purpose, &Choice::default(), state);
            disturb(&importer, purpose, &mut random);
            let knowns = reals(model, |role| role != Role::Output);
            let (directions, knowns) = (elements(&knowns), knowns.iter().map(|known| known.reference));
            let (knowns, (unknowns, results)) = (knowns.collect::<Vec<u32>>(), unknowns(model, purpose));
            let pair = [&unknowns[..], &knowns[..]];
            let rows: Vec<Vec<f64>> = (0..directions)
                .map(|at| {
                    let mut seed = vec![0.0; directions];
                    seed[at] = 1.0;
                    importer.derive(fmi3GetDirectionalDerivative, pair, &seed, results)
                })
                .collect();
            let weights: Vec<f64> = (0..results).map(|_| random.signed()).collect();
            let adjoint = importer.derive(fmi3GetAdjointDerivative, pair, &weights, directions);
            for (row, found) in rows.iter().zip(&adjoint) {
                let terms = || row.iter().zip(&weights).map(|(slope, weight)| slope * weight);
                let (expected, size) = (terms().sum::<f64>(), terms().map(f64::abs).sum::<f64>());
                assert!((found - expected).abs() <= 1e-12 * size, "{}: {found} {expected}", model.name);
                count += 1;
            }
        }
    }
    println!("figure: {count} elements of adjoint derivatives against transposed directional ones");
}

/// The spring of a pulled mass, by hand: d f_e / d e = k, d(dv/dt) / d f_f = -1 / m.
#[test]
fn derivatives_of_a_pulled_mass_are_those_of_its_equations() {
    let choice = Choice::default();
    let importer = Importer::in_state("PulledMass", Purpose::ModelExchange, &choice, State::ContinuousTimeMode);
    let acceleration = {
        let velocity = importer.model.find("velocity").expect("a state");
        stribeck::reference::of_derivative(&importer.model.table.at(velocity).path)
    };
    let unknowns = [importer.vr("external_force"), acceleration];
    let knowns = [importer.vr("elongation"), importer.vr("friction_force")];
    let pair = [&unknowns[..], &knowns[..]];
    assert_eq!(importer.derive(fmi3GetDirectionalDerivative, pair, &[1.0, 0.0], 2), [2.0, 2.0]);
    assert_eq!(importer.derive(fmi3GetDirectionalDerivative, pair, &[0.0, 1.0], 2), [0.0, -1.0]);
    assert_eq!(importer.derive(fmi3GetAdjointDerivative, pair, &[1.0, 10.0], 2), [22.0, -10.0]);
}

#[test]
fn wrong_derivatives_are_errors() {
    let force = |importer: &Importer| [importer.vr("friction_force")];
    for (what, text) in [
        (0, "2 seeds: must be 1"),
        (1, "2 sensitivities: must be 1"),
        (2, "friction_force is computed: nothing can be differentiated"),
        (3, "mu_k is neither an output nor a derivative"),
        (4, "value reference 7 does not belong to any variable"),
    ] {
        for function in [fmi3GetDirectionalDerivative as Derivative, fmi3GetAdjointDerivative] {
            let importer = Importer::ready("LuGre");
            let (mut unknowns, mut knowns) = (force(&importer), [importer.vr("velocity")]);
            let (mut seeds, mut results) = (1, 1);
            match what {
                0 => seeds = 2,
                1 => results = 2,
                2 => knowns = force(&importer),
                3 => unknowns = [importer.vr("mu_k")],
                _ => unknowns = [7],
            }
            let mut result = [0.0; 2];
            // SAFETY: arrays of at least the lengths given.
            let status = unsafe {
                let (unknowns, knowns) = (unknowns.as_ptr(), knowns.as_ptr());
                function(
                    importer.instance,
                    unknowns,
                    1,
                    knowns,
                    1,
                    [1.0; 2].as_ptr(),
                    seeds,
                    result.as_mut_ptr(),
                    results,
                )
            };
            assert_eq!(status, fmi3Error, "{text}");
            let message = importer.one_message().2;
            assert!(message.contains(text), "{message}");
        }
    }
}

/// Order 1 against the difference of an output over short steps, with held inputs.
#[test]
fn output_derivatives_are_changes() {
    let importer = Importer::ready("LuGre");
    assert_eq!(importer.set("velocity", 1e-3), fmi3OK);
    importer.step(0.0, 1e-3);
    let force = importer.vr("friction_force");
    let derivative = |order: i32| {
        let mut value = f64::NAN;
        // SAFETY: one reference, one value.
        let status = unsafe { fmi3GetOutputDerivatives(importer.instance, &force, 1, &order, &mut value, 1) };
        if status == fmi3OK { value } else { f64::NAN }
    };
    let h = 1e-7;
    let before = importer.get("friction_force");
    importer.step(1e-3, h);
    let exact = derivative(1);
    assert_eq!(derivative(2), 0.0);
    importer.step(1e-3 + h, h);
    let difference = (importer.get("friction_force") - before) / (2.0 * h);
    assert!((exact / difference - 1.0).abs() < 1e-4, "{exact} against {difference}");
    assert!(derivative(0).is_nan());
    assert!(importer.one_message().2.contains("order 0 of friction_force: must be >= 1"));
}
