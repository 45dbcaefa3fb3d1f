//! An instance where no interface is between it and its caller.

use super::*;
use crate::catalogue::{Family, by_name, documented};
use crate::reference;

fn lugre() -> Instance {
    Instance::new(by_name("LuGre").unwrap())
}

#[test]
fn an_instance_for_steps_has_no_events() {
    let mut law = lugre();
    let refused = law.at_event().unwrap_err().to_string();
    assert_eq!(refused, "the instance was made for steps, which have no events");
    law.enter_event();
    law.leave_event().unwrap();
    assert!(!law.wants_event().unwrap());
    let (velocity, force) = (law.column_by_name("velocity").unwrap(), law.column_by_name("friction_force").unwrap());
    law.set_column(velocity, 1e-3).unwrap();
    law.step(10.0).unwrap();
    assert!((law.get_column(force).unwrap() - 1.161_544_866).abs() < 1e-9, "it makes its steps as before");
}

#[test]
fn steps_without_a_finite_end_are_refused() {
    let mut law = lugre();
    for dt in [f64::INFINITY, f64::NAN, 0.0, -1.0] {
        assert_eq!(law.step(dt).unwrap_err().to_string(), format!("a step of {dt} s: must be > 0 and finite"));
    }
    law.set_time(1.7e308);
    assert!(law.step(1.7e308).unwrap_err().to_string().ends_with("the time must stay finite"));
    assert_eq!(law.time(), 1.7e308, "nothing has run");
}

#[test]
fn slopes_that_are_not_finite_or_lead_too_far_are_refused() {
    let mut law = lugre();
    let velocity = law.column_by_name("velocity").unwrap();
    let refused = law.set_slope(velocity, f64::NAN).unwrap_err().to_string();
    assert_eq!(refused, "derivative of velocity = NaN: must be finite");
    law.set_slope(velocity, 1e300).unwrap();
    let refused = law.step(1e10).unwrap_err().to_string();
    assert_eq!(refused, "at the end of its ramp velocity = inf: must be a finite number");
    assert_eq!(law.time(), 0.0, "nothing has run");
}

/// Saved between the setting of a slope and the step that uses it.
#[test]
fn a_slope_survives_saving_and_restoring() {
    let (mut law, mut other) = (lugre(), lugre());
    let [velocity, force] = ["velocity", "friction_force"].map(|name| law.column_by_name(name).unwrap());
    law.set_slope(velocity, 0.5).unwrap();
    other.restore(&law.save());
    let forces = [&mut law, &mut other].map(|instance| {
        instance.step(1e-4).unwrap();
        instance.get_column(force).unwrap()
    });
    assert!(forces[0] > 0.0, "the contact has moved");
    assert_eq!(forces[0].to_bits(), forces[1].to_bits());
}

/// Without a load there is no force, so that no energy is lost.
#[test]
fn an_unloaded_contact_loses_no_energy() {
    for (model, _) in documented(Family::Friction) {
        let mut law = Instance::new(model);
        let velocity = model.find("velocity").or_else(|| model.find("velocity_x")).unwrap();
        law.set_column(velocity, 0.3).unwrap();
        law.set_by_name("normal_force", 0.0).unwrap();
        if model.find("viscous_coefficient").is_some() {
            law.set_by_name("viscous_coefficient", 0.0).unwrap();
        }
        let energy = law.column_by_name("dissipated_energy").unwrap();
        assert_eq!(law.rates().unwrap()[energy], 0.0, "{}", model.name);
    }
}

#[test]
fn a_reference_that_belongs_to_no_variable_is_refused() {
    let (mut law, unknown) = (lugre(), reference::of_name("no such variable"));
    for refused in [law.get(unknown).map(|_| ()), law.set(unknown, 1.0)] {
        let text = refused.unwrap_err().to_string();
        assert_eq!(text, format!("LuGre has no variable with the reference {unknown}"));
    }
}
