//! The same for FMI 3.0: steps with events and visits allocate nothing, and lack of memory is an error.

use std::ffi::{CStr, c_char, c_void};
use std::ptr::{null, null_mut};

use stribeck::catalogue;
use stribeck::model::{Kind, ModelType, Role};
use stribeck_ffi::fmi3::derivatives::*;
use stribeck_ffi::fmi3::setup::*;
use stribeck_ffi::fmi3::snapshot::*;
use stribeck_ffi::fmi3::step::*;
use stribeck_ffi::fmi3::types::fmi3Status::*;
use stribeck_ffi::fmi3::types::*;
use stribeck_ffi::fmi3::values::*;

use super::{HEARD, REFUSED, Refused, allocations, failures, guid};

unsafe extern "C-unwind" fn listen(_: *mut c_void, _: fmi3Status, category: *const c_char, text: *const c_char) {
    assert!(!category.is_null() && !text.is_null());
    HEARD.set(HEARD.get() + 1);
}

unsafe extern "C-unwind" fn visit(
    _: *mut c_void,
    time: f64,
    _: fmi3Boolean,
    _: fmi3Boolean,
    _: fmi3Boolean,
    _: fmi3Boolean,
    _: *mut fmi3Boolean,
    _: *mut f64,
) {
    assert!(time.is_finite());
}

/// An instance with events and visits, ready to step.
struct Slave {
    instance: fmi3Instance,
    /// Real inputs and outputs of one element.
    inputs: Vec<u32>,
    given: Vec<f64>,
    outputs: Vec<u32>,
}

fn instantiate(token: &CStr) -> fmi3Instance {
    let (name, token, none) = (c"slave".as_ptr(), token.as_ptr(), null_mut());
    // SAFETY: valid texts.
    unsafe { fmi3InstantiateCoSimulation(name, token, null(), 0, 1, 1, 1, null(), 0, none, Some(listen), Some(visit)) }
}

impl Slave {
    fn new(model: &ModelType) -> Slave {
        let instance = instantiate(&guid(model));
        // SAFETY: a live instance.
        unsafe {
            assert_eq!(fmi3EnterInitializationMode(instance, 0, 0.0, 0.0, 0, 0.0), fmi3OK);
            assert_eq!(fmi3ExitInitializationMode(instance), fmi3OK);
            assert_eq!(fmi3EnterStepMode(instance), fmi3OK);
        }
        let is_real = |kind: &Kind| matches!(kind, Kind::Real(_));
        let reals = || {
            let shown = model.variables().filter(move |(_, variable)| is_real(&variable.kind));
            shown.filter(|(_, variable)| variable.path.without_index().is_none() && !variable.is_advice)
        };
        let inputs = || reals().filter(|(_, variable)| variable.role == Role::Input);
        let outputs = reals().filter(|(_, variable)| variable.role.is_output());
        Slave {
            instance,
            inputs: inputs().map(|(column, _)| model.reference(column)).collect(),
            given: inputs().map(|(_, variable)| variable.start).collect(),
            outputs: outputs.map(|(column, _)| model.reference(column)).collect(),
        }
    }

    /// Steps to `end` whatever events there are, then derivatives of all outputs.
    fn run(&mut self, end: f64, values: &mut [f64], adjoint: &mut [f64]) {
        let (c, n, m) = (self.instance, self.inputs.len(), self.outputs.len());
        let (mut t, mut flags, seed) = (0.0, [0; 3], [1.0; 64]);
        while t < end {
            if let Some(first) = self.given.first_mut() {
                *first += 1e-4 * f64::sin(300.0 * t);
            }
            let [event, terminate, early] = &mut flags;
            let step = 1e-3_f64.min(end - t);
            // SAFETY: a live instance, and arrays of their lengths.
            unsafe {
                assert_eq!(fmi3SetFloat64(c, self.inputs.as_ptr(), n, self.given.as_ptr(), n), fmi3OK);
                assert_eq!(fmi3DoStep(c, t, step, 1, event, terminate, early, &mut t), fmi3OK);
                assert_eq!(fmi3GetFloat64(c, self.outputs.as_ptr(), m, values.as_mut_ptr(), m), fmi3OK);
                if *event == fmi3True {
                    assert_eq!(fmi3EnterEventMode(c), fmi3OK);
                    assert_eq!(fmi3EnterStepMode(c), fmi3OK);
                }
            }
        }
        let (unknowns, knowns) = (self.outputs.as_ptr(), self.inputs.as_ptr());
        let m = m.min(seed.len());
        // SAFETY: as above.
        let status =
            unsafe { fmi3GetAdjointDerivative(c, unknowns, m, knowns, n, seed.as_ptr(), m, adjoint.as_mut_ptr(), n) };
        assert_eq!(status, fmi3OK);
    }
}

impl Drop for Slave {
    fn drop(&mut self) {
        // SAFETY: made above, freed once.
        unsafe { fmi3FreeInstance(self.instance) };
    }
}

#[test]
fn no_model_allocates_in_steps_with_events() {
    for model in catalogue::models() {
        let mut slave = Slave::new(model);
        let (mut values, mut adjoint) = (vec![0.0; slave.outputs.len()], vec![0.0; slave.inputs.len()]);
        let count = allocations(|| slave.run(0.1, &mut values, &mut adjoint));
        assert_eq!(count, 0, "{} allocates", model.name);
    }
}

#[test]
fn lack_of_memory_is_an_error() {
    let mut tested = 0;
    for model in catalogue::models() {
        let token = guid(model);
        tested += failures(model.name, || {
            let heard = HEARD.get();
            let instance = instantiate(&token);
            // SAFETY: a live instance or NULL, freed once.
            unsafe { fmi3FreeInstance(instance) };
            assert_eq!(HEARD.get() - heard, usize::from(instance.is_null()), "a refusal is logged");
            !instance.is_null()
        });
        let slave = Slave::new(model);
        tested += failures(model.name, || {
            let mut state = null_mut();
            // SAFETY: a live instance, a state freed once.
            unsafe {
                let status = fmi3GetFMUState(slave.instance, &mut state);
                assert_eq!(state.is_null(), status == fmi3Error);
                // After an error only a reset, or a saved state, leads on.
                assert_eq!(fmi3FreeFMUState(slave.instance, &mut state), fmi3OK);
                status == fmi3OK
            }
        });
        // A misuse is an error even without memory for its message.
        REFUSED.set(Refused { first: 0, ..Refused::NONE });
        let mut places = ([0; 3], 0.0);
        let [event, terminate, early] = &mut places.0;
        // SAFETY: a live instance, places for answers.
        let status = unsafe { fmi3DoStep(slave.instance, 0.0, -1.0, 1, event, terminate, early, &mut places.1) };
        REFUSED.set(Refused::NONE);
        assert_eq!(status, fmi3Error);
    }
    println!("figure: FMI 3.0: {tested} refused requests for memory, as many errors");
}
