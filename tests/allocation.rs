//! The FMI calls of a running simulation allocate nothing: masters call them from real-time threads.

#![allow(non_upper_case_globals, reason = "the names of the standard")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::ffi::{CStr, CString};
use std::hint::black_box;
use std::ptr::{null, null_mut};

use stribeck::catalogue;
use stribeck::fmi2::setup::*;
use stribeck::fmi2::step::fmi2DoStep;
use stribeck::fmi2::types::*;
use stribeck::fmi2::values::{fmi2GetReal, fmi2SetReal};
use stribeck::model::{Kind, ModelType, Role};

thread_local! {
    // Per thread, because the test harness allocates on threads of its own. It has no destructor, so that it can be used
    // by an allocator at any time.
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

/// The allocator of the system, and a count of what it is asked for.
struct Counting;

fn count() {
    ALLOCATIONS.set(ALLOCATIONS.get() + 1);
}

// SAFETY: every call is passed on unchanged to the system's allocator; counting does not allocate.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count();
        // SAFETY: the caller's promise.
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count();
        // SAFETY: the caller's promise.
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, memory: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count();
        // SAFETY: the caller's promise.
        unsafe { System.realloc(memory, layout, size) }
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        count();
        // SAFETY: the caller's promise.
        unsafe { System.dealloc(memory, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// How often `work` called the allocator, to get memory or to give it back.
fn allocations(work: impl FnOnce()) -> usize {
    let before = ALLOCATIONS.get();
    work();
    ALLOCATIONS.get() - before
}

#[test]
fn the_counter_counts() {
    assert_eq!(allocations(|| drop(black_box(Box::new(1)))), 2);
    assert_eq!(allocations(|| drop(black_box(vec![0u8; 100]))), 2);
    let mut growing = Vec::with_capacity(1);
    assert_eq!(allocations(|| black_box(&mut growing).extend([1, 2, 3])), 1);
    assert_eq!(allocations(|| ()), 0);
}

fn instantiate(guid: &CStr) -> fmi2Component {
    let callbacks = fmi2CallbackFunctions {
        logger: None,
        allocateMemory: None,
        freeMemory: None,
        stepFinished: None,
        componentEnvironment: null_mut(),
    };
    // SAFETY: texts are terminated, and the struct lives during the call.
    unsafe { fmi2Instantiate(c"slave".as_ptr(), fmi2CoSimulation, guid.as_ptr(), null(), &callbacks, 0, 0) }
}

fn guid(model: &ModelType) -> CString {
    CString::new(model.guid()).expect("a guid has no zero byte")
}

/// A slave in its stepping mode.
struct Slave {
    component: fmi2Component,
    inputs: Vec<fmi2ValueReference>,
    given: Vec<f64>,
    start: f64,
    reals: Vec<fmi2ValueReference>,
}

impl Slave {
    fn new(model: &ModelType) -> Slave {
        let component = instantiate(&guid(model));
        // SAFETY: a live component, or NULL, which is refused.
        let statuses = unsafe {
            [
                fmi2SetupExperiment(component, 0, 0.0, 0.0, 0, 0.0),
                fmi2EnterInitializationMode(component),
                fmi2ExitInitializationMode(component),
            ]
        };
        assert_eq!(statuses, [fmi2Status::fmi2OK; 3], "{}", model.name);
        let reals = || model.table.iter().zip(0..).filter(|(variable, _)| matches!(variable.kind, Kind::Real(_)));
        let inputs = || reals().filter(|(variable, _)| variable.role == Role::Input);
        Slave {
            component,
            start: inputs().next().map_or(0.0, |(variable, _)| variable.start),
            inputs: inputs().map(|(_, reference)| reference).collect(),
            given: inputs().map(|(variable, _)| variable.start).collect(),
            reals: reals().map(|(_, reference)| reference).collect(),
        }
    }

    /// Sets all inputs, of which the first moves to and fro, makes a step and reads everything back, for 10 s.
    fn run(&mut self, values: &mut [f64]) {
        for k in 0..10_000 {
            let (time, dt) = (f64::from(k) * 1e-3, 1e-3);
            if let Some(first) = self.given.first_mut() {
                *first = self.start + 0.002 * f64::sin(3.0 * time);
            }
            // SAFETY: a live component, and slices with their lengths.
            let statuses = unsafe {
                [
                    fmi2SetReal(self.component, self.inputs.as_ptr(), self.inputs.len(), self.given.as_ptr()),
                    fmi2DoStep(self.component, time, dt, fmi2True),
                    fmi2GetReal(self.component, self.reals.as_ptr(), self.reals.len(), values.as_mut_ptr()),
                ]
            };
            assert_eq!(statuses, [fmi2Status::fmi2OK; 3]);
        }
    }
}

impl Drop for Slave {
    fn drop(&mut self) {
        // SAFETY: made by fmi2Instantiate, freed once.
        unsafe { fmi2FreeInstance(self.component) }
    }
}

#[test]
fn no_model_allocates_in_10_000_steps() {
    let mut tested = 0;
    for model in catalogue::models() {
        let mut slave = Slave::new(model);
        let mut values = vec![0.0; slave.reals.len()];
        assert_eq!(allocations(|| slave.run(&mut values)), 0, "{} allocates", model.name);
        assert!(values.iter().any(|value| *value != 0.0), "{} did not move", model.name);
        tested += 1;
    }
    assert!(tested > 0);
}

/// What fmi2Instantiate allocates is seen, so the calls above were seen too.
#[test]
fn instantiation_is_seen_by_the_counter() {
    let guid = guid(catalogue::models().next().expect("the catalogue is not empty"));
    let mut component = null_mut();
    assert!(allocations(|| component = instantiate(&guid)) > 0);
    assert!(!component.is_null());
    // SAFETY: a live component, freed once.
    assert!(allocations(|| unsafe { fmi2FreeInstance(component) }) > 0);
}
