//! Model Exchange: states in the order of FMI 3.0, with the values of FMI 2.0.

use super::importer::{Choice, Importer};
use super::{reals, variables};
use stribeck::catalogue;
use stribeck::model::{ModelType, Role};
use stribeck::reference::EVENT_INDICATORS;
use stribeck_ffi::fmi2;
use stribeck_ffi::fmi3::exchange::*;
use stribeck_ffi::fmi3::lifecycle::{Purpose, State};
use stribeck_ffi::fmi3::types::fmi3Status::*;

/// The columns of the states in the order in which they are described.
fn states(model: &ModelType) -> Vec<usize> {
    let variables = variables(model).into_iter().filter(|known| known.first.is_continuous_state());
    variables.flat_map(|known| known.columns).collect()
}

/// An instance of each version between events, with the same inputs.
fn pair(model: &'static ModelType) -> (crate::Importer, Importer) {
    use fmi2::lifecycle::{Purpose as Two, State as StateOfTwo};
    let two = crate::Importer::in_state_of(model.name, Two::ModelExchange, StateOfTwo::ContinuousTimeMode);
    let choice = Choice::default();
    let three = Importer::in_state(model.name, Purpose::ModelExchange, &choice, State::ContinuousTimeMode);
    for input in reals(model, |role| role == Role::Input).iter().filter(|input| !input.first.jumps) {
        let values: Vec<f64> = input.columns.iter().map(|at| super::driven(&model.table.at(*at), 1)).collect();
        assert_eq!(three.set_all(&[input.reference], &values), fmi3OK);
        let references: Vec<u32> = input.columns.iter().map(|at| model.reference(*at)).collect();
        let (references, n) = (references.as_ptr(), references.len());
        // SAFETY: arrays of the lengths given.
        let status = unsafe { fmi2::values::fmi2SetReal(two.c, references, n, values.as_ptr()) };
        assert_eq!(status, crate::fmi2OK);
    }
    (two, three)
}

/// States, moved a little, their derivatives and the event indicators.
type Vectors = [Vec<f64>; 3];

fn vectors(model: &ModelType) -> Vectors {
    let states = || vec![f64::NAN; model.continuous_states().count()];
    [states(), states(), vec![f64::NAN; model.event_indicators]]
}

fn move_three(three: &Importer) -> Vectors {
    let [mut x, mut rates, mut z] = vectors(three.model);
    let (c, n, k, mut counts) = (three.instance, x.len(), z.len(), [0; 2]);
    let mut nominals = x.clone();
    // SAFETY: arrays of the lengths given.
    unsafe {
        assert_eq!(fmi3GetNumberOfContinuousStates(c, &mut counts[0]), fmi3OK);
        assert_eq!(fmi3GetNumberOfEventIndicators(c, &mut counts[1]), fmi3OK);
        assert_eq!(counts, [n, k]);
        assert_eq!(fmi3GetContinuousStates(c, x.as_mut_ptr(), n), fmi3OK);
        x.iter_mut().enumerate().for_each(|(at, x)| *x += 1e-7 * (1.0 + at as f64));
        assert_eq!(fmi3SetContinuousStates(c, x.as_ptr(), n), fmi3OK);
        assert_eq!(fmi3GetContinuousStateDerivatives(c, rates.as_mut_ptr(), n), fmi3OK, "{}", three.last_message());
        assert_eq!(fmi3GetEventIndicators(c, z.as_mut_ptr(), k), fmi3OK);
        assert_eq!(fmi3GetNominalsOfContinuousStates(c, nominals.as_mut_ptr(), n), fmi3OK);
    }
    let expected: Vec<f64> = states(three.model).iter().map(|column| three.model.table.at(*column).nominal).collect();
    assert_eq!(nominals, expected);
    [x, rates, z]
}

fn move_two(two: &crate::Importer, model: &ModelType, x: &[f64]) -> Vectors {
    let [_, mut rates, mut z] = vectors(model);
    let (n, k) = (x.len(), z.len());
    // SAFETY: arrays of the lengths given.
    unsafe {
        assert_eq!(fmi2::exchange::fmi2SetContinuousStates(two.c, x.as_ptr(), n), crate::fmi2OK);
        assert_eq!(fmi2::exchange::fmi2GetDerivatives(two.c, rates.as_mut_ptr(), n), crate::fmi2OK);
        assert_eq!(fmi2::exchange::fmi2GetEventIndicators(two.c, z.as_mut_ptr(), k), crate::fmi2OK);
    }
    [x.to_vec(), rates, z]
}

#[test]
fn states_derivatives_and_indicators_are_those_of_fmi_2() {
    let mut count = 0;
    for model in catalogue::models().filter(|model| model.model_exchange) {
        let (two, three) = pair(model);
        let [x, rates, z] = move_three(&three);
        let (order, table) = (states(model), model.continuous_states().collect::<Vec<usize>>());
        assert_eq!(order.len(), table.len(), "{}", model.name);
        let in_table = |values: &[f64]| -> Vec<f64> {
            let place = |column: &usize| order.iter().position(|other| other == column).expect("a state");
            table.iter().map(|column| values[place(column)]).collect()
        };
        let [_, expected, indicators] = move_two(&two, model, &in_table(&x));
        assert_eq!(in_table(&rates), expected, "{}", model.name);
        assert_eq!(z, indicators, "{}", model.name);
        as_variables(&three, [&x, &rates, &z]);
        count += x.len();
    }
    println!("figure: {count} states of Model Exchange have the derivatives of FMI 2.0");
}

/// States, derivatives and event indicators are variables too.
fn as_variables(three: &Importer, [x, rates, z]: [&[f64]; 3]) {
    let known: Vec<_> = variables(three.model).into_iter().filter(|one| one.first.is_continuous_state()).collect();
    let derivatives: Vec<u32> = known.iter().map(|one| one.derivatives).collect();
    let mut found = vec![f64::NAN; rates.len()];
    assert_eq!(three.get_all(&derivatives, &mut found), fmi3OK, "{}", three.last_message());
    assert_eq!(found, rates, "{}", three.model.name);
    let states: Vec<u32> = known.iter().map(|one| one.reference).collect();
    assert_eq!(three.get_all(&states, &mut found), fmi3OK);
    assert_eq!(found, x);
    let mut found = vec![f64::NAN; z.len()];
    if z.is_empty() {
        return;
    }
    assert_eq!(three.get_all(&[EVENT_INDICATORS], &mut found), fmi3OK);
    assert_eq!(found, z);
}

/// The indicators of co-simulation are those of its row.
#[test]
fn co_simulation_shows_its_indicators() {
    for model in catalogue::models() {
        let importer = Importer::ready(model.name);
        let mut values = vec![f64::NAN; model.event_indicators];
        let status = importer.get_all(&[EVENT_INDICATORS], &mut values);
        if values.is_empty() {
            assert_eq!(status, fmi3Error, "{}: it has none", model.name);
        } else {
            assert_eq!(status, fmi3OK, "{}: {}", model.name, importer.last_message());
            let instance = stribeck::instance::Instance::new(model);
            let mut expected = values.clone();
            instance.indicate(&mut expected).expect("finite indicators");
            assert_eq!(values, expected, "{}", model.name);
        }
    }
}

/// A mass that comes to rest: the importer finds the event by the indicator, and the law says that its results jump.
#[test]
fn an_importer_finds_the_event() {
    let choice = Choice::default();
    let importer = Importer::in_state("Coulomb", Purpose::ModelExchange, &choice, State::EventMode);
    assert_eq!(importer.set("velocity", 0.1), fmi3OK);
    importer.update();
    // SAFETY: an instance and places of this test.
    unsafe {
        assert_eq!(fmi3EnterContinuousTimeMode(importer.instance), fmi3OK);
        assert!(!importer.sticks());
        assert_eq!(importer.set("velocity", 0.0), fmi3OK);
        assert_eq!(fmi3SetTime(importer.instance, 0.5), fmi3OK);
        assert!(!importer.sticks(), "it changes at events only");
        assert_eq!(stribeck_ffi::fmi3::step::fmi3EnterEventMode(importer.instance), fmi3OK);
        importer.update();
        assert!(importer.sticks());
        assert_eq!(fmi3EnterContinuousTimeMode(importer.instance), fmi3OK);
        let [mut event, mut end] = [9; 2];
        assert_eq!(fmi3CompletedIntegratorStep(importer.instance, 1, &mut event, &mut end), fmi3OK);
        assert_eq!((event, end), (0, 0));
        assert_eq!(fmi3SetTime(importer.instance, f64::NAN), fmi3Error);
    }
}
