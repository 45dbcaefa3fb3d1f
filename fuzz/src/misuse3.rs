//! Misuse of FMI 3.0: NULL where there must be none, and instances that cannot be made.

use std::ffi::{CStr, CString};
use std::ptr::{null, null_mut};

use stribeck::model::ModelType;
use stribeck_ffi::fmi3::derivatives::*;
use stribeck_ffi::fmi3::exchange::*;
use stribeck_ffi::fmi3::lifecycle::Call;
use stribeck_ffi::fmi3::setup::*;
use stribeck_ffi::fmi3::snapshot::*;
use stribeck_ffi::fmi3::step::*;
use stribeck_ffi::fmi3::types::*;
use stribeck_ffi::fmi3::unused::*;
use stribeck_ffi::fmi3::values::*;

use crate::argument::model;
use crate::fmi3::Fmi3;
use crate::slave::Slave;

/// Number of calls of [`with_null`]. Only the first one is without an instance.
pub const CALLS: u8 = 24;

/// A call with a NULL, and its status.
pub fn with_null(slave: &Slave<Fmi3>, which: u8) -> (Call, fmi3Status) {
    let c = slave.c;
    let ([mut a, mut b, mut d, mut e, mut f], mut value, one) = ([0; 5], 0.0, 1u32);
    let (none, no_value, no_flag) = (null::<u32>(), null_mut::<f64>(), null_mut::<fmi3Boolean>());
    let any = &raw mut value;
    // SAFETY: these calls must reject NULL; the other arguments are valid.
    unsafe {
        match which % CALLS {
            0 => (Call::DoStep, fmi3DoStep(null_mut(), 0.0, 1.0, 1, &mut a, &mut b, &mut d, any)),
            1 => (Call::SetDebugLogging, fmi3SetDebugLogging(c, 1, 1, null())),
            2 => (Call::SetDebugLogging, fmi3SetDebugLogging(c, 1, 1, &null())),
            3 => (Call::GetFloat64, fmi3GetFloat64(c, none, 1, any, 1)),
            4 => (Call::GetFloat64, fmi3GetFloat64(c, &one, 1, no_value, 1)),
            5 => (Call::SetFloat64, fmi3SetFloat64(c, none, 1, any, 1)),
            6 => (Call::SetFloat64, fmi3SetFloat64(c, &one, 1, no_value, 1)),
            7 => (Call::GetInt64, fmi3GetInt64(c, &one, 1, null_mut(), 1)),
            8 => (Call::SetInt32, fmi3SetInt32(c, none, 1, &1, 1)),
            9 => (Call::GetBoolean, fmi3GetBoolean(c, none, 1, &mut a, 1)),
            10 => (Call::SetUInt64, fmi3SetUInt64(c, &one, 1, null(), 1)),
            11 => (Call::GetString, fmi3GetString(c, none, 1, null_mut(), 0)),
            12 => (Call::GetOutputDerivatives, fmi3GetOutputDerivatives(c, &one, 1, null(), any, 1)),
            13 => {
                let call = Call::GetDirectionalDerivative;
                (call, fmi3GetDirectionalDerivative(c, none, 0, &one, 1, null(), 1, any, 0))
            }
            14 => {
                let call = Call::GetAdjointDerivative;
                (call, fmi3GetAdjointDerivative(c, none, 1, none, 0, any, 1, no_value, 0))
            }
            15 => (Call::DoStep, fmi3DoStep(c, 0.0, 1.0, 1, &mut a, &mut b, no_flag, any)),
            16 => {
                let call = Call::UpdateDiscreteStates;
                (call, fmi3UpdateDiscreteStates(c, &mut a, &mut b, &mut d, &mut e, &mut f, no_value))
            }
            17 => (Call::CompletedIntegratorStep, fmi3CompletedIntegratorStep(c, 1, &mut a, no_flag)),
            18 => (Call::GetFMUState, fmi3GetFMUState(c, null_mut())),
            19 => (Call::SetFMUState, fmi3SetFMUState(c, null_mut())),
            20 => (Call::SerializedFMUStateSize, fmi3SerializedFMUStateSize(c, null_mut(), &mut 0)),
            21 => (Call::SerializeFMUState, fmi3SerializeFMUState(c, null_mut(), null_mut(), 8)),
            22 => (Call::DeserializeFMUState, fmi3DeserializeFMUState(c, null(), 8, &mut null_mut())),
            _ => (Call::GetNumberOfContinuousStates, fmi3GetNumberOfContinuousStates(c, null_mut())),
        }
    }
}

/// Makes an instance with arguments that may be wrong, and frees it. `required` has the intermediate variable of the model,
/// or, without a token, of the first one.
pub fn instantiate(kind: u8, token: Option<u8>, name: u8, required: impl FnOnce(&'static ModelType) -> u32) {
    const NAMES: [Option<&CStr>; 4] = [Some(c"name"), Some(c" \t"), Some(c"\xff%s"), None];
    let name = NAMES[usize::from(name) % NAMES.len()];
    let required = required(model(token.unwrap_or_default()));
    let model = token.map(model);
    let token = model.map_or(c"{}".to_owned(), |model| CString::new(model.guid()).expect("no zero byte"));
    let (text, token) = (name.map_or(null(), CStr::as_ptr), token.as_ptr());
    let nobody = null_mut();
    // SAFETY: terminated texts or NULL, an array of one element; what is made is freed once.
    let is_made = unsafe {
        let c = match kind % 3 {
            0 => fmi3InstantiateModelExchange(text, token, null(), 0, 1, nobody, None),
            1 => fmi3InstantiateCoSimulation(text, token, null(), 0, 1, 1, 1, &required, 1, nobody, None, None),
            _ => fmi3InstantiateScheduledExecution(text, token, null(), 0, 1, nobody, None, None, None, None),
        };
        fmi3FreeInstance(c);
        !c.is_null()
    };
    let has_name = name.is_some_and(|name| !name.to_bytes().trim_ascii().is_empty());
    let may_be_made = model.is_some_and(|model| match kind % 3 {
        0 => model.model_exchange,
        1 => crate::fmi3::is_port(model, required),
        _ => false,
    });
    assert_eq!(is_made, has_name && may_be_made);
}
