//! An importer of FMI 3.0 with one instance, which records the messages of the library.

use std::ffi::{CStr, CString, c_void};
use std::ptr::{null, null_mut};
use std::sync::Mutex;

use stribeck::catalogue;
use stribeck::model::ModelType;
use stribeck_ffi::fmi3::exchange::*;
use stribeck_ffi::fmi3::lifecycle::{Purpose, State};
use stribeck_ffi::fmi3::setup::*;
use stribeck_ffi::fmi3::snapshot::*;
use stribeck_ffi::fmi3::step::*;
use stribeck_ffi::fmi3::types::fmi3Status::*;
use stribeck_ffi::fmi3::types::*;
use stribeck_ffi::fmi3::values::*;

/// What an importer is called back for.
#[derive(Default)]
pub struct Heard {
    pub messages: Mutex<Vec<(fmi3Status, String, String)>>,
    /// What it does within a step.
    pub within: Mutex<Option<Within>>,
}

pub type Within = Box<dyn FnMut(&Visit) -> Option<f64> + Send>;

/// A call of the importer's function within a step.
pub struct Visit {
    pub time: f64,
    pub flags: [bool; 4],
}

unsafe extern "C-unwind" fn listen(
    environment: *mut c_void,
    status: fmi3Status,
    category: fmi3String,
    text: fmi3String,
) {
    // SAFETY: the environment is the `Heard` given below; the texts are those of the library.
    unsafe {
        let read = |text| CStr::from_ptr(text).to_string_lossy().into_owned();
        let heard = &*environment.cast::<Heard>();
        heard.messages.lock().expect("one thread").push((status, read(category), read(text)));
    }
}

unsafe extern "C-unwind" fn visit(
    environment: *mut c_void,
    time: f64,
    set: fmi3Boolean,
    get: fmi3Boolean,
    finished: fmi3Boolean,
    early: fmi3Boolean,
    requested: *mut fmi3Boolean,
    end: *mut f64,
) {
    // SAFETY: the environment is the `Heard` given below; the library passes places for its answers.
    unsafe {
        let heard = &*environment.cast::<Heard>();
        let visit = Visit { time, flags: [set, get, finished, early].map(|flag| flag == fmi3True) };
        let mut within = heard.within.lock().expect("one thread");
        if let Some(asked) = within.as_mut().and_then(|within| within(&visit)) {
            (*requested, *end) = (fmi3True, asked);
        }
    }
}

/// How an importer makes an instance for co-simulation.
#[derive(Clone, Default)]
pub struct Choice {
    pub event_mode: bool,
    pub early_return: bool,
    /// Whether it has a callback within steps, and what it reads there.
    pub within: bool,
    pub required: Vec<fmi3ValueReference>,
}

impl Choice {
    pub fn events() -> Choice {
        Choice { event_mode: true, early_return: true, ..Choice::default() }
    }
}

/// Results of fmi3DoStep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    pub event: bool,
    pub early: bool,
    pub time: f64,
}

pub struct Importer {
    pub instance: fmi3Instance,
    pub model: &'static ModelType,
    pub heard: Box<Heard>,
}

impl Drop for Importer {
    fn drop(&mut self) {
        // SAFETY: freed once.
        unsafe { fmi3FreeInstance(self.instance) };
    }
}

/// The token of a model.
pub fn token(model: &str) -> CString {
    CString::new(catalogue::by_name(model).expect(model).guid()).expect("no zero byte")
}

impl Importer {
    pub fn with(model: &str, purpose: Purpose, choice: &Choice) -> Importer {
        let heard = Box::<Heard>::default();
        let environment = std::ptr::from_ref(&*heard).cast_mut().cast();
        let (name, token, required) = (c"importer".as_ptr(), token(model), &choice.required);
        let [event, early] = [choice.event_mode, choice.early_return].map(fmi3Boolean::from);
        let update: fmi3IntermediateUpdateCallback = if choice.within { Some(visit) } else { None };
        // SAFETY: valid texts and arrays.
        let instance = unsafe {
            match purpose {
                Purpose::ModelExchange => {
                    fmi3InstantiateModelExchange(name, token.as_ptr(), null(), 0, 1, environment, Some(listen))
                }
                Purpose::CoSimulation => fmi3InstantiateCoSimulation(
                    name,
                    token.as_ptr(),
                    null(),
                    0,
                    1,
                    event,
                    early,
                    required.as_ptr(),
                    required.len(),
                    environment,
                    Some(listen),
                    update,
                ),
            }
        };
        assert!(!instance.is_null(), "{model}: {:?}", heard.messages.lock());
        Importer { instance, model: catalogue::by_name(model).expect("a model"), heard }
    }

    /// An instance in this state; not for the one within a step.
    pub fn in_state(model: &str, purpose: Purpose, choice: &Choice, state: State) -> Importer {
        let importer = Importer::with(model, purpose, choice);
        importer.go(purpose, choice, state);
        importer.heard.messages.lock().expect("one thread").clear();
        importer
    }

    fn go(&self, purpose: Purpose, choice: &Choice, state: State) {
        let c = self.instance;
        // SAFETY: an instance of this test.
        unsafe {
            match state {
                State::Instantiated => return,
                State::ConfigurationMode => return assert_eq!(fmi3EnterConfigurationMode(c), fmi3OK),
                _ => assert_eq!(fmi3EnterInitializationMode(c, 1, 1e-6, 0.0, 1, 100.0), fmi3OK),
            }
            if state == State::InitializationMode {
                return;
            }
            assert_eq!(fmi3ExitInitializationMode(c), fmi3OK, "{}", self.last_message());
            match state {
                State::Terminated => assert_eq!(fmi3Terminate(c), fmi3OK),
                State::Error => assert_eq!(fmi3SetDebugLogging(c, 1, 1, null()), fmi3Error),
                State::ContinuousTimeMode => {
                    self.update();
                    assert_eq!(fmi3EnterContinuousTimeMode(c), fmi3OK);
                }
                State::StepMode if choice.event_mode => {
                    self.update();
                    assert_eq!(fmi3EnterStepMode(c), fmi3OK);
                }
                State::EventMode => assert!(choice.event_mode || purpose == Purpose::ModelExchange),
                _ => (),
            }
        }
    }

    /// fmi3UpdateDiscreteStates; whether states have jumped.
    pub fn update(&self) -> bool {
        let (mut flags, mut time) = ([9; 5], f64::NAN);
        let [a, b, c, d, e] = &mut flags;
        // SAFETY: places for all answers.
        assert_eq!(unsafe { fmi3UpdateDiscreteStates(self.instance, a, b, c, d, e, &mut time) }, fmi3OK);
        assert_eq!([flags[0], flags[1], flags[2], flags[4]], [0; 4]);
        flags[3] == 1
    }

    /// Event Mode without a change of inputs.
    pub fn handle_event(&self) {
        // SAFETY: an instance of this test.
        unsafe {
            assert_eq!(fmi3EnterEventMode(self.instance), fmi3OK, "{}", self.last_message());
            self.update();
            assert_eq!(fmi3EnterStepMode(self.instance), fmi3OK);
        }
    }

    pub fn ready(model: &str) -> Importer {
        Importer::ready_with(model, &Choice::default())
    }

    pub fn ready_with(model: &str, choice: &Choice) -> Importer {
        Importer::in_state(model, Purpose::CoSimulation, choice, State::StepMode)
    }

    pub fn vr(&self, name: &str) -> fmi3ValueReference {
        self.model.reference(self.model.find(name).expect(name))
    }

    pub fn set(&self, name: &str, value: f64) -> fmi3Status {
        self.set_all(&[self.vr(name)], &[value])
    }

    pub fn set_all(&self, references: &[u32], values: &[f64]) -> fmi3Status {
        // SAFETY: arrays of the lengths given.
        unsafe { fmi3SetFloat64(self.instance, references.as_ptr(), references.len(), values.as_ptr(), values.len()) }
    }

    pub fn get_all(&self, references: &[u32], values: &mut [f64]) -> fmi3Status {
        let (count, n) = (references.len(), values.len());
        // SAFETY: arrays of the lengths given.
        unsafe { fmi3GetFloat64(self.instance, references.as_ptr(), count, values.as_mut_ptr(), n) }
    }

    pub fn get(&self, name: &str) -> f64 {
        let mut value = [f64::NAN];
        assert_eq!(self.get_all(&[self.vr(name)], &mut value), fmi3OK, "{name}: {}", self.last_message());
        value[0]
    }

    pub fn sticks(&self) -> bool {
        let mut value = 9;
        // SAFETY: one reference, one value.
        assert_eq!(unsafe { fmi3GetBoolean(self.instance, &self.vr("sticking"), 1, &mut value, 1) }, fmi3OK);
        value == fmi3True
    }

    pub fn try_step(&self, t: f64, h: f64) -> Result<Answer, fmi3Status> {
        let ([mut event, mut end, mut early], mut time) = ([9; 3], f64::NAN);
        // SAFETY: places for all answers.
        let status = unsafe { fmi3DoStep(self.instance, t, h, 1, &mut event, &mut end, &mut early, &mut time) };
        if status != fmi3OK {
            return Err(status);
        }
        assert!(event <= 1 && end == 0 && early <= 1);
        Ok(Answer { event: event == 1, early: early == 1, time })
    }

    #[track_caller]
    pub fn step(&self, t: f64, h: f64) -> Answer {
        self.try_step(t, h).unwrap_or_else(|status| panic!("{status:?}: {}", self.last_message()))
    }

    pub fn save(&self) -> fmi3FMUState {
        let mut state = null_mut();
        // SAFETY: an instance of this test.
        assert_eq!(unsafe { fmi3GetFMUState(self.instance, &mut state) }, fmi3OK);
        state
    }

    pub fn free(&self, mut state: fmi3FMUState) {
        // SAFETY: a state of this test, freed once.
        assert_eq!(unsafe { fmi3FreeFMUState(self.instance, &mut state) }, fmi3OK);
        assert!(state.is_null());
    }

    pub fn bytes(&self, state: fmi3FMUState) -> Vec<u8> {
        let mut size = 0;
        // SAFETY: a state of this test and a buffer of its size.
        unsafe {
            assert_eq!(fmi3SerializedFMUStateSize(self.instance, state, &mut size), fmi3OK);
            let mut bytes = vec![0; size];
            assert_eq!(fmi3SerializeFMUState(self.instance, state, bytes.as_mut_ptr(), size), fmi3OK);
            bytes
        }
    }

    /// The text of the last message; empty if there was none.
    pub fn last_message(&self) -> String {
        let messages = self.heard.messages.lock().expect("one thread");
        messages.last().map(|(_, _, text)| text.clone()).unwrap_or_default()
    }

    /// The only message since the last time.
    #[track_caller]
    pub fn one_message(&self) -> (fmi3Status, String, String) {
        let mut messages = self.heard.messages.lock().expect("one thread");
        assert_eq!(messages.len(), 1, "{messages:?}");
        messages.remove(0)
    }
}
