//! The FMI calls of a running simulation allocate nothing: masters call them from real-time threads. The others, which
//! do, survive a lack of memory.

#![allow(non_upper_case_globals, reason = "the names of the standard")]

mod common;
#[path = "allocation/fmi3.rs"]
mod fmi3;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::ffi::{CStr, CString, c_void};
use std::hint::black_box;
use std::ops::Range;
use std::ptr::{null, null_mut};
use std::sync::atomic::AtomicBool;

use common::NO_EVENT;
use stribeck::batch::{Registers, Rows, Runs, Stepped, Worker};
use stribeck::catalogue;
use stribeck::instance::Instance;
use stribeck::model::{Kind, ModelType, Role};
use stribeck::series::{Between, Times, set_up};
use stribeck_ffi::c::*;
use stribeck_ffi::fmi2::exchange::*;
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::snapshot::*;
use stribeck_ffi::fmi2::step::fmi2DoStep;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::{fmi2GetReal, fmi2SetReal};

thread_local! {
    // Per thread, because the test harness allocates on its own threads. Without a destructor, so that an allocator can
    // use it at any time.
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
    // Blocks that are in use.
    static LIVE: Cell<isize> = const { Cell::new(0) };
    // The refused requests: those from `first` up to, but not including, `end`.
    static REFUSED: Cell<Refused> = const { Cell::new(Refused::NONE) };
}

/// Refused memory requests, counted from 0.
#[derive(Clone, Copy)]
struct Refused {
    first: usize,
    end: usize,
    asked: usize,
}

impl Refused {
    const NONE: Refused = Refused { first: usize::MAX, end: usize::MAX, asked: 0 };
}

/// The allocator of the system, with a count of its requests. It refuses the selected ones.
struct Counting;

fn count() {
    ALLOCATIONS.set(ALLOCATIONS.get() + 1);
}

/// Counts a memory request; true if it is to be refused.
fn is_refused() -> bool {
    count();
    let mut refused = REFUSED.get();
    let is_refused = (refused.first..refused.end).contains(&refused.asked);
    refused.asked += 1;
    REFUSED.set(refused);
    is_refused
}

/// Counts a block, if it is not NULL.
fn live(memory: *mut u8) -> *mut u8 {
    LIVE.set(LIVE.get() + isize::from(!memory.is_null()));
    memory
}

// SAFETY: every call is refused, or passed on unchanged to the system's allocator; counting does not allocate.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        if is_refused() {
            return null_mut();
        }
        // SAFETY: the caller's promise.
        live(unsafe { System.alloc(layout) })
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        if is_refused() {
            return null_mut();
        }
        // SAFETY: the caller's promise.
        live(unsafe { System.alloc_zeroed(layout) })
    }

    unsafe fn realloc(&self, memory: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        if is_refused() {
            return null_mut();
        }
        // SAFETY: the caller's promise.
        unsafe { System.realloc(memory, layout, size) }
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        count();
        LIVE.set(LIVE.get() - 1);
        // SAFETY: the caller's promise.
        unsafe { System.dealloc(memory, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Number of calls of the allocator by `work`, to get or free memory.
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

fn instantiate(guid: &CStr, kind: fmi2Type) -> fmi2Component {
    let callbacks = fmi2CallbackFunctions {
        logger: listener(),
        allocateMemory: None,
        freeMemory: None,
        stepFinished: None,
        componentEnvironment: null_mut(),
    };
    // SAFETY: texts are terminated, and the struct lives during the call.
    unsafe { fmi2Instantiate(c"slave".as_ptr(), kind, guid.as_ptr(), null(), &callbacks, 0, 1) }
}

thread_local! {
    /// Number of messages that the logger received.
    static HEARD: Cell<usize> = const { Cell::new(0) };
}

/// A logger that counts. Rust cannot define variadic functions; where arguments are not on the stack, one without the
/// variadic arguments can be used instead.
fn listener() -> fmi2CallbackLogger {
    unsafe extern "C" fn listen(_: *mut c_void, _: fmi2String, _: fmi2Status, category: fmi2String, text: fmi2String) {
        assert!(!category.is_null() && !text.is_null());
        HEARD.set(HEARD.get() + 1);
    }
    type Fixed = unsafe extern "C" fn(*mut c_void, fmi2String, fmi2Status, fmi2String, fmi2String);
    // SAFETY: see above; the caller cleans up what it has passed.
    unsafe { std::mem::transmute::<Fixed, fmi2CallbackLogger>(listen) }
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
        let component = instantiate(&guid(model), fmi2CoSimulation);
        // SAFETY: a live component, or NULL, which is rejected.
        let statuses = unsafe {
            [
                fmi2SetupExperiment(component, 0, 0.0, 0.0, 0, 0.0),
                fmi2EnterInitializationMode(component),
                fmi2ExitInitializationMode(component),
            ]
        };
        assert_eq!(statuses, [fmi2Status::fmi2OK; 3], "{}", model.name);
        let reals = || model.variables().filter(|(_, variable)| matches!(variable.kind, Kind::Real(_)));
        let inputs = || reals().filter(|(_, variable)| variable.role == Role::Input);
        Slave {
            component,
            start: inputs().next().map_or(0.0, |(_, variable)| variable.start),
            inputs: inputs().map(|(column, _)| model.reference(column)).collect(),
            given: inputs().map(|(_, variable)| variable.start).collect(),
            reals: reals().map(|(column, _)| model.reference(column)).collect(),
        }
    }

    /// Sets all inputs, of which the first oscillates, makes a step of 1 ms and reads everything back.
    fn run(&mut self, steps: i32, values: &mut [f64]) {
        for k in 0..steps {
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
        assert_eq!(allocations(|| slave.run(10_000, &mut values)), 0, "{} allocates", model.name);
        assert!(values.iter().any(|value| *value != 0.0), "{} did not move", model.name);
        tested += 1;
    }
    assert!(tested > 0);
}

/// The calls of a solver between two events.
#[test]
fn no_model_allocates_while_a_solver_integrates_it() {
    let mut tested = 0;
    for model in catalogue::models().filter(|model| model.model_exchange) {
        let c = instantiate(&guid(model), fmi2ModelExchange);
        let mut x = vec![0.0; model.continuous_states().count()];
        let mut rates = x.clone();
        let mut indicators = vec![0.0; model.event_indicators];
        let mut event = NO_EVENT;
        let (mut enters, mut ends) = (fmi2False, fmi2False);
        // SAFETY: a live component, freed once, and arrays with their lengths.
        unsafe {
            let ready = [
                fmi2SetupExperiment(c, 0, 0.0, 0.0, 0, 0.0),
                fmi2EnterInitializationMode(c),
                fmi2ExitInitializationMode(c),
                fmi2NewDiscreteStates(c, &mut event),
                fmi2EnterContinuousTimeMode(c),
                fmi2GetContinuousStates(c, x.as_mut_ptr(), x.len()),
            ];
            assert_eq!(ready, [fmi2Status::fmi2OK; 6], "{}", model.name);
            let mut integrate = || {
                for k in 1..=1_000 {
                    let statuses = [
                        fmi2SetTime(c, f64::from(k) * 1e-6),
                        fmi2SetContinuousStates(c, x.as_ptr(), x.len()),
                        fmi2GetDerivatives(c, rates.as_mut_ptr(), rates.len()),
                        fmi2GetEventIndicators(c, indicators.as_mut_ptr(), indicators.len()),
                        fmi2CompletedIntegratorStep(c, fmi2True, &mut enters, &mut ends),
                        fmi2EnterEventMode(c),
                        fmi2NewDiscreteStates(c, &mut event),
                        fmi2EnterContinuousTimeMode(c),
                        fmi2GetContinuousStates(c, x.as_mut_ptr(), x.len()),
                    ];
                    assert_eq!(statuses, [fmi2Status::fmi2OK; 9], "{}", model.name);
                    x.iter_mut().zip(&rates).for_each(|(x, rate)| *x += 1e-6 * rate);
                }
            };
            assert_eq!(allocations(&mut integrate), 0, "{} allocates", model.name);
            fmi2FreeInstance(c);
        }
        tested += 1;
    }
    assert!(tested > 0);
}

#[test]
fn a_million_steps_allocate_nothing() {
    for name in ["LuGre", "QuarterCar"] {
        let mut slave = Slave::new(catalogue::by_name(name).expect(name));
        let mut values = vec![0.0; slave.reals.len()];
        assert_eq!(allocations(|| slave.run(1_000_000, &mut values)), 0, "{name} allocates");
        println!("figure: {name}: a million steps, no allocation");
    }
}

/// Runs of a law whose state relaxes, made along their samples and side by side, and of one whose runs are made one by one.
#[test]
fn runs_of_a_worker_allocate_nothing() {
    const SAMPLES: usize = 200;
    for name in ["LuGre", "Karnopp"] {
        let law = catalogue::by_name(name).expect(name);
        let [velocity, load, force] =
            ["velocity", "normal_force", "friction_force"].map(|name| law.find(name).expect(name));
        let velocities: Vec<f64> = (0..SAMPLES).map(|sample| 1e-5 * (sample as f64 - 50.0)).collect();
        let inputs = [
            Rows { column: velocity, rows: 1, width: SAMPLES, values: &velocities },
            Rows { column: load, rows: 1, width: 1, values: &[10.0] },
        ];
        let (times, between) = (Times::Every(1e-3), Between::Held);
        let runs = Runs { inputs: &inputs, times, samples: SAMPLES, between, results: &[force] };
        for count in [1, 2, 9] {
            let mut worker = Worker::new(law, &runs, Registers::best()).expect("memory");
            let mut instance = Instance::new(law);
            let mut forces = vec![f64::NAN; count * SAMPLES];
            let begin = |_: usize, instance: &mut Instance| {
                instance.reset();
                set_up(instance, &[])
            };
            let mut made = Ok(());
            let results = &mut [&mut forces[..]];
            let work = || made = worker.make(&mut instance, &runs, 0..count, &begin, results, &AtomicBool::new(false));
            assert_eq!(allocations(work), 0, "{count} runs of {name} allocate");
            made.expect(name);
            assert!(forces.iter().all(|force| force.is_finite()), "{name}");
        }
    }
}

/// Stepped runs take all of their values or, if memory runs out at any of them, none.
#[test]
fn values_that_lack_memory_are_not_taken() {
    let law = catalogue::by_name("LuGre").expect("a law");
    let [velocity, load, force] =
        ["velocity", "normal_force", "friction_force"].map(|name| law.find(name).expect(name));
    let force_of = |stepped: &mut Stepped| {
        let mut found = [f64::NAN; 3];
        let mut take = |runs: Range<usize>, values: &[f64]| {
            found[runs].copy_from_slice(values);
            Ok(())
        };
        stepped.get(force, &mut take).expect("forces");
        found
    };
    let failures = failures("Stepped", || {
        let Ok(mut stepped) = Stepped::new(law, Registers::best(), 3) else { return false };
        stepped.set(&[(velocity, &[0.02]), (load, &[7.0])]).expect("room for one value");
        let before = force_of(&mut stepped);
        let is_set = stepped.set(&[(velocity, &[0.011, 0.012, 0.013]), (load, &[8.0, 9.0, 10.0])]).is_ok();
        assert_eq!(force_of(&mut stepped) == before, !is_set);
        is_set
    });
    assert!(failures > 6, "{failures}");
}

/// The allocations of fmi2Instantiate are counted, so those of the calls above would have been counted too.
#[test]
fn instantiation_is_seen_by_the_counter() {
    let guid = guid(catalogue::models().next().expect("the catalogue is not empty"));
    let mut component = null_mut();
    assert!(allocations(|| component = instantiate(&guid, fmi2CoSimulation)) > 0);
    assert!(!component.is_null());
    // SAFETY: a live component, freed once.
    assert!(allocations(|| unsafe { fmi2FreeInstance(component) }) > 0);
}

/// Repeats `attempt` (true: it succeeded) while one memory request after another is refused, alone or with all later
/// ones, until no request is refused. Each refusal must make it fail without a leak. Returns the number of failures.
fn failures(what: &str, mut attempt: impl FnMut() -> bool) -> usize {
    let mut failures = 0;
    for lasts in [1, usize::MAX / 2] {
        for first in 0.. {
            assert!(first < 100_000, "{what} continues without the memory that it needs");
            let live = LIVE.get();
            REFUSED.set(Refused { first, end: first + lasts, asked: 0 });
            let succeeded = attempt();
            let asked = REFUSED.replace(Refused::NONE).asked;
            assert_eq!(succeeded, asked <= first, "{what}: request {first} of {asked} was refused");
            assert_eq!(LIVE.get(), live, "{what}: request {first} was refused, and memory was lost");
            if succeeded {
                break;
            }
            failures += 1;
        }
    }
    failures
}

#[test]
fn lack_of_memory_for_an_fmu_is_an_error() {
    let mut tested = 0;
    for model in catalogue::models() {
        let guid = guid(model);
        let kinds = [fmi2CoSimulation, fmi2ModelExchange];
        for kind in kinds.into_iter().filter(|kind| *kind == fmi2CoSimulation || model.model_exchange) {
            let made = failures(model.name, || {
                let heard = HEARD.get();
                let component = instantiate(&guid, kind);
                // SAFETY: a live component or NULL, freed once.
                unsafe { fmi2FreeInstance(component) };
                assert_eq!(HEARD.get() - heard, usize::from(component.is_null()), "a refusal is logged");
                !component.is_null()
            });
            // Slave, name, and five arrays, each refused alone and with all that follow.
            assert!(made >= 14, "{}: {made} failures", model.name);
            tested += made;
        }

        tested += lacking_for_states(model);
    }
    println!("figure: FMI: {tested} refused requests for memory, as many errors");
}

/// Refused requests for memory while states are saved and restored.
fn lacking_for_states(model: &'static ModelType) -> usize {
    let slave = Slave::new(model);
    let c = slave.component;
    let mut size = 0;
    let mut state = null_mut();
    // SAFETY: a live component and states of its own, each freed once.
    unsafe {
        assert_eq!(fmi2GetFMUstate(c, &mut state), fmi2Status::fmi2OK);
        assert_eq!(fmi2SerializedFMUstateSize(c, state, &mut size), fmi2Status::fmi2OK);
        let mut bytes = vec![0; size];
        let saved = failures(model.name, || {
            let mut copy = null_mut();
            let status = fmi2GetFMUstate(c, &mut copy);
            assert_eq!(copy.is_null(), status == fmi2Status::fmi2Error);
            // An earlier saved state can be continued.
            assert_eq!(fmi2SetFMUstate(c, state), fmi2Status::fmi2OK);
            assert_eq!(fmi2FreeFMUstate(c, &mut copy), fmi2Status::fmi2OK);
            status == fmi2Status::fmi2OK
        });
        let written =
            failures(model.name, || fmi2SerializeFMUstate(c, state, bytes.as_mut_ptr(), size) == fmi2Status::fmi2OK);
        assert_eq!(written, 0, "serialising needs no memory");
        let read = failures(model.name, || {
            let mut copy = null_mut();
            let status = fmi2DeSerializeFMUstate(c, bytes.as_ptr(), size, &mut copy);
            assert_eq!(copy.is_null(), status == fmi2Status::fmi2Error);
            assert_eq!(fmi2SetFMUstate(c, state), fmi2Status::fmi2OK);
            assert_eq!(fmi2FreeFMUstate(c, &mut copy), fmi2Status::fmi2OK);
            status == fmi2Status::fmi2OK
        });
        assert!(saved >= 6 && read >= 6, "{}: {saved} and {read} failures", model.name);
        // A misuse is an error even without memory for its message.
        REFUSED.set(Refused { first: 0, ..Refused::NONE });
        let status = fmi2DoStep(c, 0.0, -1.0, fmi2True);
        assert!(REFUSED.replace(Refused::NONE).asked > 0 && status == fmi2Status::fmi2Error);
        assert_eq!(fmi2FreeFMUstate(c, &mut state), fmi2Status::fmi2OK);
        saved + read
    }
}

/// Parameters that a rule of the model rejects together, for most laws and the strut.
const REFUSED_TOGETHER: [(&str, f64); 2] = [("mu_s", 0.01), ("c1.mu_s", 0.01)];

#[test]
fn a_rejected_parameter_without_memory_for_the_reason_is_an_error() {
    let mut tested = 0;
    for model in catalogue::models() {
        for (name, value) in REFUSED_TOGETHER {
            let Some(column) = model.find(name) else { continue };
            let component = instantiate(&guid(model), fmi2CoSimulation);
            assert!(!component.is_null());
            let reference = model.reference(column);
            // SAFETY: a live component, freed once, and arrays of one element.
            let status = unsafe {
                assert_eq!(fmi2SetupExperiment(component, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2Status::fmi2OK);
                assert_eq!(fmi2EnterInitializationMode(component), fmi2Status::fmi2OK);
                REFUSED.set(Refused { first: 0, ..Refused::NONE });
                let mut status = fmi2SetReal(component, &reference, 1, &value);
                if status == fmi2Status::fmi2OK {
                    status = fmi2ExitInitializationMode(component);
                }
                assert!(REFUSED.replace(Refused::NONE).asked > 0, "{}: a reason is written", model.name);
                fmi2FreeInstance(component);
                status
            };
            assert!(matches!(status, fmi2Status::fmi2Error | fmi2Status::fmi2Discard), "{}: {status:?}", model.name);
            tested += 1;
        }
    }
    assert!(tested > 20, "{tested} models");
}

#[test]
fn lack_of_memory_for_a_c_caller_is_a_status() {
    let mut tested = 0;
    for known in catalogue::models() {
        let name = CString::new(known.name).expect("a name has no zero byte");
        // SAFETY: terminated texts, writable places, handles freed once.
        unsafe {
            tested += failures(known.name, || {
                let mut model = null_mut();
                let status = stribeck_create(name.as_ptr(), &mut model);
                let expected = [stribeck_status::STRIBECK_OUT_OF_MEMORY, stribeck_status::STRIBECK_OK];
                assert_eq!(status, expected[usize::from(!model.is_null())]);
                stribeck_free(model);
                status == stribeck_status::STRIBECK_OK
            });
            let mut model = null_mut();
            assert_eq!(stribeck_create(name.as_ptr(), &mut model), stribeck_status::STRIBECK_OK);
            let mut bytes = vec![0u8; stribeck_state_size(model)];
            tested += failures(known.name, || {
                stribeck_save(model, bytes.as_mut_ptr().cast(), bytes.len()) == stribeck_status::STRIBECK_OK
            });
            stribeck_free(model);
        }
    }
    println!("figure: C: {tested} refused requests for memory, as many errors");
}
