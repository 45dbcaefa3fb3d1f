//! An importer with one instance, which records the messages of the library.

use std::cell::RefCell;
use std::ffi::{CStr, CString, c_void};
use std::ptr::{null, null_mut};
use std::sync::Mutex;

use super::NO_EVENT;
use stribeck::catalogue;
use stribeck_ffi::fmi2::exchange::*;
use stribeck_ffi::fmi2::lifecycle::{Purpose, State};
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::snapshot::*;
use stribeck_ffi::fmi2::step::*;
use stribeck_ffi::fmi2::types::fmi2Status::*;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

/// Messages received by the logger of an importer.
pub type Heard = Mutex<Vec<(fmi2Status, String, String)>>;

thread_local! {
    /// The instance of the last message.
    pub static NAME: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Rust cannot define variadic functions, but on the platforms of these tests a function that names the first variadic
/// argument receives it: on x86-64 and AArch64 Linux and on x86-64 Windows pointers travel in the same registers.
unsafe extern "C" fn listen(
    environment: *mut c_void,
    name: fmi2String,
    status: fmi2Status,
    category: fmi2String,
    message: fmi2String,
    argument: fmi2String,
) {
    // SAFETY: the environment is the `Heard` given below; the texts are those of the library.
    unsafe {
        assert_eq!(CStr::from_ptr(message), c"%s", "the message is a format and must be constant");
        let text = |text| CStr::from_ptr(text).to_string_lossy().into_owned();
        NAME.set(text(name));
        let heard = &*environment.cast::<Heard>();
        heard.lock().expect("one thread").push((status, text(category), text(argument)));
    }
}

pub fn callbacks(heard: &Heard) -> fmi2CallbackFunctions {
    type Fixed = unsafe extern "C" fn(*mut c_void, fmi2String, fmi2Status, fmi2String, fmi2String, fmi2String);
    // SAFETY: see `listen`.
    let logger = unsafe { std::mem::transmute::<Fixed, fmi2CallbackLogger>(listen) };
    fmi2CallbackFunctions {
        logger,
        allocateMemory: None,
        freeMemory: None,
        stepFinished: None,
        componentEnvironment: std::ptr::from_ref(heard).cast_mut().cast(),
    }
}

/// An importer with one instance.
pub struct Importer {
    pub c: fmi2Component,
    pub model: &'static str,
    pub heard: Box<Heard>,
}

impl Drop for Importer {
    fn drop(&mut self) {
        // SAFETY: freed once, here.
        unsafe { fmi2FreeInstance(self.c) };
    }
}

pub fn guid(model: &str) -> CString {
    CString::new(catalogue::by_name(model).expect(model).guid()).expect("no zero byte")
}

impl Importer {
    pub fn new(model: &'static str) -> Importer {
        Importer::with(model, Purpose::CoSimulation)
    }

    pub fn with(model: &'static str, purpose: Purpose) -> Importer {
        let kind = match purpose {
            Purpose::CoSimulation => fmi2CoSimulation,
            Purpose::ModelExchange => fmi2ModelExchange,
        };
        let heard = Box::<Heard>::default();
        let callbacks = callbacks(&heard);
        // SAFETY: valid texts and callbacks.
        let c = unsafe {
            let name = c"importer".as_ptr();
            fmi2Instantiate(name, kind, guid(model).as_ptr(), null(), &callbacks, fmi2False, fmi2True)
        };
        assert!(!c.is_null());
        Importer { c, model, heard }
    }

    pub fn in_state(model: &'static str, state: State) -> Importer {
        Importer::in_state_of(model, Purpose::CoSimulation, state)
    }

    pub fn in_state_of(model: &'static str, purpose: Purpose, state: State) -> Importer {
        let importer = Importer::with(model, purpose);
        let c = importer.c;
        // SAFETY: an instance of this test.
        unsafe {
            if state != State::Instantiated {
                assert_eq!(fmi2SetupExperiment(c, fmi2True, 1e-6, 0.0, fmi2True, 100.0), fmi2OK);
                assert_eq!(fmi2EnterInitializationMode(c), fmi2OK);
            }
            if !matches!(state, State::Instantiated | State::Initialization) {
                assert_eq!(fmi2ExitInitializationMode(c), fmi2OK);
            }
            match (state, purpose) {
                (State::Terminated, _) => assert_eq!(fmi2Terminate(c), fmi2OK),
                (State::Error, Purpose::CoSimulation) => assert_eq!(fmi2DoStep(c, 0.0, -1.0, fmi2True), fmi2Error),
                (State::Error, Purpose::ModelExchange) => assert_eq!(fmi2SetTime(c, f64::NAN), fmi2Error),
                (State::ContinuousTimeMode, _) => {
                    assert_eq!(fmi2NewDiscreteStates(c, &mut { NO_EVENT }), fmi2OK);
                    assert_eq!(fmi2EnterContinuousTimeMode(c), fmi2OK);
                }
                _ => (),
            }
        }
        importer.heard.lock().expect("one thread").clear();
        importer
    }

    pub fn ready(model: &'static str) -> Importer {
        Importer::in_state(model, State::StepComplete)
    }

    pub fn vr(&self, name: &str) -> fmi2ValueReference {
        let model = catalogue::by_name(self.model).expect("a model");
        model.reference(model.find(name).expect(name))
    }

    pub fn set(&self, name: &str, value: f64) -> fmi2Status {
        // SAFETY: one reference, one value.
        unsafe { fmi2SetReal(self.c, &self.vr(name), 1, &value) }
    }

    pub fn get(&self, name: &str) -> f64 {
        let mut value = f64::NAN;
        // SAFETY: one reference, one value.
        assert_eq!(unsafe { fmi2GetReal(self.c, &self.vr(name), 1, &mut value) }, fmi2OK, "{name}");
        value
    }

    pub fn step(&self, t: f64, h: f64) -> fmi2Status {
        // SAFETY: an instance of this test.
        unsafe { fmi2DoStep(self.c, t, h, fmi2True) }
    }

    pub fn save(&self) -> fmi2FMUstate {
        let mut state = null_mut();
        // SAFETY: an instance of this test.
        assert_eq!(unsafe { fmi2GetFMUstate(self.c, &mut state) }, fmi2OK);
        state
    }

    pub fn bytes(&self, state: fmi2FMUstate) -> Vec<fmi2Byte> {
        let mut size = 0;
        // SAFETY: a state of this test and a buffer of its size.
        unsafe {
            assert_eq!(fmi2SerializedFMUstateSize(self.c, state, &mut size), fmi2OK);
            let mut bytes = vec![0; size];
            assert_eq!(fmi2SerializeFMUstate(self.c, state, bytes.as_mut_ptr(), size), fmi2OK);
            bytes
        }
    }

    /// The only message since the last time.
    #[track_caller]
    pub fn one_message(&self) -> (fmi2Status, String, String) {
        let mut heard = self.heard.lock().expect("one thread");
        assert_eq!(heard.len(), 1, "{heard:?}");
        heard.remove(0)
    }

    /// The text of the last message; empty if there was none.
    pub fn last_message(&self) -> String {
        self.heard.lock().expect("one thread").last().map(|(_, _, text)| text.clone()).unwrap_or_default()
    }
}
