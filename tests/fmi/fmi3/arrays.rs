//! Arrays, and structural parameters that are their sizes.

use super::importer::{Choice, Importer};
use stribeck_ffi::fmi3::lifecycle::{Purpose, State};
use stribeck_ffi::fmi3::setup::*;
use stribeck_ffi::fmi3::types::fmi3Status::{self, *};
use stribeck_ffi::fmi3::values::*;

impl Importer {
    /// References of an array and of its size.
    fn array(&self, name: &str) -> [u32; 2] {
        let arrays = stribeck::arrays::of(self.model).expect("memory");
        let array = arrays.iter().find(|array| array.path.to_string() == name).expect(name);
        [array.reference(), array.size.expect("a size").reference()]
    }

    fn set_size(&self, reference: u32, size: u64) -> fmi3Status {
        // SAFETY: one reference, one value.
        unsafe { fmi3SetUInt64(self.instance, &reference, 1, &size, 1) }
    }

    fn size(&self, reference: u32) -> u64 {
        let mut size = 0;
        // SAFETY: one reference, one value.
        assert_eq!(unsafe { fmi3GetUInt64(self.instance, &reference, 1, &mut size, 1) }, fmi3OK);
        size
    }

    fn initialize(&self) -> fmi3Status {
        // SAFETY: an instance of this test.
        unsafe {
            assert_eq!(fmi3EnterInitializationMode(self.instance, 0, 0.0, 0.0, 0, 0.0), fmi3OK);
            fmi3ExitInitializationMode(self.instance)
        }
    }
}

fn strut(state: State) -> Importer {
    Importer::in_state("ShockAbsorber", Purpose::CoSimulation, &Choice::default(), state)
}

#[test]
fn an_array_is_set_and_read_in_one_call() {
    let strut = strut(State::Instantiated);
    let [speeds, size] = strut.array("damper.tab_v");
    assert_eq!(strut.size(size), 16);
    let values: Vec<f64> = (0..16).map(|index| f64::from(index) - 8.0).collect();
    assert_eq!(strut.set_all(&[speeds], &values), fmi3OK, "{}", strut.last_message());
    let (mass, mut read) = (strut.vr("velocity"), [f64::NAN; 18]);
    assert_eq!(strut.get_all(&[mass, speeds, mass], &mut read), fmi3OK);
    assert_eq!(read[1..17], values);
    assert_eq!(strut.set_all(&[speeds], &values[..15]), fmi3Error);
    assert_eq!(strut.one_message().2, "fmi3SetFloat64: 15 values: must be 16");
}

/// A run with a smaller table is that with the full one, if both use the same points.
#[test]
fn a_smaller_table_has_its_first_points() {
    let force = |size: Option<u64>| {
        let strut = strut(State::Instantiated);
        let [speeds, sizes] = strut.array("damper.tab_v");
        let [forces, same] = strut.array("damper.tab_f");
        assert_eq!(sizes, same, "one size for both");
        if let Some(size) = size {
            // SAFETY: an instance of this test.
            unsafe {
                assert_eq!(fmi3EnterConfigurationMode(strut.instance), fmi3OK);
                assert_eq!(strut.set_size(sizes, size), fmi3OK);
                assert_eq!(strut.size(sizes), size, "readable at once");
                assert_eq!(fmi3ExitConfigurationMode(strut.instance), fmi3OK);
            }
        }
        let count = size.unwrap_or(16) as usize;
        let points: Vec<f64> = (0..count).map(|index| index as f64 - 1.0).collect();
        assert_eq!(strut.set_all(&[speeds], &points), fmi3OK, "{}", strut.last_message());
        let values: Vec<f64> = points.iter().map(|speed| 700.0 * speed).collect();
        assert_eq!(strut.set_all(&[forces], &values), fmi3OK);
        let used = strut.model.find("damper.tab_n").expect("a count");
        // SAFETY: one reference, one value.
        assert_eq!(unsafe { fmi3SetInt32(strut.instance, &strut.model.reference(used), 1, &3, 1) }, fmi3OK);
        assert_eq!(strut.initialize(), fmi3OK, "{}", strut.last_message());
        assert_eq!(strut.set("velocity", 0.3), fmi3OK);
        strut.step(0.0, 1e-3);
        strut.get("force").to_bits()
    };
    assert_eq!(force(Some(3)), force(None));
    assert_eq!(force(Some(5)), force(None));
}

#[test]
fn more_points_than_a_table_has_are_rejected_by_name() {
    let strut = strut(State::ConfigurationMode);
    let [_, size] = strut.array("damper.tab_v");
    let used = strut.model.table.at(strut.model.find("damper.tab_n").expect("a count")).start;
    assert_eq!(strut.set_size(size, 1), fmi3OK);
    // SAFETY: an instance of this test.
    assert_eq!(unsafe { fmi3ExitConfigurationMode(strut.instance) }, fmi3OK);
    assert_eq!(strut.initialize(), fmi3Error);
    let text = format!("fmi3ExitInitializationMode: damper.tab_n = {used}: must be at most damper.tab_size = 1");
    assert_eq!(strut.one_message().2, text);
    // SAFETY: an instance of this test.
    assert_eq!(unsafe { fmi3Reset(strut.instance) }, fmi3OK);
    assert_eq!(strut.size(size), 16, "a reset restores the sizes");
    assert_eq!(strut.initialize(), fmi3OK);
}

#[test]
fn sizes_outside_their_bounds_are_discarded_and_change_nothing() {
    let strut = strut(State::ConfigurationMode);
    let [_, size] = strut.array("damper.tab_v");
    for wrong in [0, 17, u64::MAX] {
        assert_eq!(strut.set_size(size, wrong), fmi3Discard);
        let text = strut.one_message().2;
        assert!(
            text.starts_with("fmi3SetUInt64: damper.tab_size = ") && text.ends_with("must be from 1 to 16"),
            "{text}"
        );
        assert_eq!(strut.size(size), 16);
    }
}

#[test]
fn sizes_are_set_in_configuration_mode_only() {
    for state in [State::Instantiated, State::InitializationMode, State::StepMode] {
        let strut = strut(state);
        let [_, size] = strut.array("damper.tab_v");
        assert_eq!(strut.set_size(size, 3), fmi3Error);
        assert_eq!(strut.one_message().2, "fmi3SetUInt64: damper.tab_size can be set in state ConfigurationMode only");
    }
}

#[test]
fn an_element_has_no_reference_of_its_own() {
    for state in [State::Instantiated, State::StepMode] {
        let strut = strut(state);
        let element = strut.vr("damper.tab_v[1]");
        assert_eq!(strut.get_all(&[element], &mut [0.0]), fmi3Error);
        assert!(strut.one_message().2.contains("does not belong to any variable"));
    }
}

#[test]
fn other_types_are_rejected_by_name() {
    let importer = strut(State::StepMode);
    let velocity = importer.vr("velocity");
    // SAFETY: one reference, one value.
    assert_eq!(unsafe { fmi3GetInt32(importer.instance, &velocity, 1, &mut 0, 1) }, fmi3Error);
    let text = format!("fmi3GetInt32: velocity (value reference {velocity}) is of type Float64, not Int32");
    assert_eq!(importer.one_message().2, text);
    let importer = strut(State::StepMode);
    // SAFETY: one reference, one value.
    let status = unsafe { stribeck_ffi::fmi3::unused::fmi3GetFloat32(importer.instance, &velocity, 1, &mut 0.0, 1) };
    assert_eq!(status, fmi3Error);
    assert!(importer.one_message().2.ends_with("is of type Float64, not Float32"));
}

#[test]
fn enumerations_and_switches_have_their_own_types() {
    let strut = strut(State::StepMode);
    let (mut checked, c) = ([0; 2], strut.instance);
    for (column, variable) in strut.model.variables() {
        let reference = strut.model.reference(column);
        // SAFETY: one reference, one value.
        unsafe {
            match variable.kind {
                stribeck::model::Kind::Enumeration(_) => {
                    let mut value = 0;
                    assert_eq!(fmi3GetInt64(c, &reference, 1, &mut value, 1), fmi3OK, "{}", variable.path);
                    assert!(value >= 1);
                    checked[0] += 1;
                }
                stribeck::model::Kind::Boolean => {
                    let mut value = 9;
                    assert_eq!(fmi3GetBoolean(c, &reference, 1, &mut value, 1), fmi3OK, "{}", variable.path);
                    assert!(value <= 1);
                    checked[1] += 1;
                }
                _ => (),
            }
        }
    }
    assert!(checked[0] > 3 && checked[1] > 0, "{checked:?}");
    let switch = strut.model.variables().find(|(_, variable)| {
        variable.kind == stribeck::model::Kind::Boolean && variable.role == stribeck::model::Role::Tunable
    });
    if let Some((column, _)) = switch {
        // SAFETY: one reference, one value.
        assert_eq!(unsafe { fmi3SetBoolean(c, &strut.model.reference(column), 1, &2, 1) }, fmi3Discard);
    }
}
