//! Misuse of FMI 2.0: NULL where there must be none, and instances that cannot be made.

use std::ffi::{CStr, CString};
use std::ptr::{null, null_mut};

use stribeck_ffi::fmi2::exchange::*;
use stribeck_ffi::fmi2::lifecycle::Call;
use stribeck_ffi::fmi2::setup::*;
use stribeck_ffi::fmi2::snapshot::*;
use stribeck_ffi::fmi2::step::*;
use stribeck_ffi::fmi2::types::*;
use stribeck_ffi::fmi2::values::*;

use crate::argument::model;
use crate::fmi2::Fmi2;
use crate::slave::Slave;

/// One of 24 calls with a NULL, and its status. Only the first one is without an instance.
pub fn with_null(slave: &Slave<Fmi2>, which: u8) -> (Call, fmi2Status) {
    let c = slave.c;
    let (one, mut value) = (1u32, 0.0);
    let (none, no_value, no_flag) = (null::<u32>(), null_mut::<f64>(), null_mut::<i32>());
    let any = &raw mut value;
    let nobody = null_mut();
    // SAFETY: these calls must reject NULL; the other arguments are valid.
    unsafe {
        match which % 24 {
            0 => (Call::DoStep, fmi2DoStep(nobody, 0.0, 1.0, fmi2True)),
            1 => (Call::SetDebugLogging, fmi2SetDebugLogging(c, fmi2True, 1, null())),
            2 => (Call::SetDebugLogging, fmi2SetDebugLogging(c, fmi2True, 1, &null())),
            3 => (Call::GetReal, fmi2GetReal(c, none, 1, any)),
            4 => (Call::GetReal, fmi2GetReal(c, &one, 1, no_value)),
            5 => (Call::SetReal, fmi2SetReal(c, none, 1, any)),
            6 => (Call::SetReal, fmi2SetReal(c, &one, 1, no_value)),
            7 => (Call::GetInteger, fmi2GetInteger(c, &one, 1, no_flag)),
            8 => (Call::SetInteger, fmi2SetInteger(c, none, 1, &1)),
            9 => (Call::GetBoolean, fmi2GetBoolean(c, none, 1, &mut 1)),
            10 => (Call::SetBoolean, fmi2SetBoolean(c, &one, 1, no_flag)),
            11 => (Call::GetString, fmi2GetString(c, none, 1, null_mut())),
            12 => (Call::SetRealInputDerivatives, fmi2SetRealInputDerivatives(c, &one, 1, null(), any)),
            13 => (Call::GetRealOutputDerivatives, fmi2GetRealOutputDerivatives(c, &one, 1, null(), any)),
            14 => (Call::GetDirectionalDerivative, fmi2GetDirectionalDerivative(c, none, 0, &one, 1, null(), any)),
            15 => (Call::GetRealStatus, fmi2GetRealStatus(c, fmi2LastSuccessfulTime, no_value)),
            16 => (Call::NewDiscreteStates, fmi2NewDiscreteStates(c, null_mut())),
            17 => {
                let call = Call::CompletedIntegratorStep;
                (call, fmi2CompletedIntegratorStep(c, fmi2True, no_flag, no_flag))
            }
            18 => (Call::GetFMUstate, fmi2GetFMUstate(c, null_mut())),
            19 => (Call::SetFMUstate, fmi2SetFMUstate(c, null_mut())),
            20 => (Call::SerializedFMUstateSize, fmi2SerializedFMUstateSize(c, null_mut(), &mut 0)),
            21 => (Call::SerializeFMUstate, fmi2SerializeFMUstate(c, null_mut(), null_mut(), 8)),
            22 => (Call::DeSerializeFMUstate, fmi2DeSerializeFMUstate(c, null(), 8, &mut null_mut())),
            _ => (Call::DeSerializeFMUstate, fmi2DeSerializeFMUstate(c, null(), 8, null_mut())),
        }
    }
}

/// Makes an instance with arguments that may be wrong, and frees it.
pub fn instantiate(kind: fmi2Type, guid: Option<u8>, name: u8, callbacks: bool) {
    const NAMES: [Option<&CStr>; 4] = [Some(c"name"), Some(c" \t"), Some(c"\xff%s"), None];
    const SILENT: fmi2CallbackFunctions = fmi2CallbackFunctions {
        logger: None,
        allocateMemory: None,
        freeMemory: None,
        stepFinished: None,
        componentEnvironment: null_mut(),
    };
    let name = NAMES[usize::from(name) % NAMES.len()];
    let model = guid.map(model);
    let guid = model.map_or(c"{}".to_owned(), |model| CString::new(model.guid()).expect("no zero byte"));
    let given: *const fmi2CallbackFunctions = if callbacks { &SILENT } else { null() };
    let text = name.map_or(null(), CStr::as_ptr);
    // SAFETY: terminated texts or NULL, a valid struct or NULL; what is made is freed once.
    let is_made = unsafe {
        let c = fmi2Instantiate(text, kind, guid.as_ptr(), null(), given, fmi2True, fmi2True);
        fmi2FreeInstance(c);
        !c.is_null()
    };
    let has_name = name.is_some_and(|name| !name.to_bytes().trim_ascii().is_empty());
    let is_offered =
        model.is_some_and(|model| kind == fmi2CoSimulation || (kind == fmi2ModelExchange && model.model_exchange));
    assert_eq!(is_made, has_name && is_offered && callbacks);
}
