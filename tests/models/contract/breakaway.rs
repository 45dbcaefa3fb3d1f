//! Events of laws whose contact is a spring until it breaks away: what is due, and what the event finds.

use approx::assert_abs_diff_eq;
use stribeck::catalogue::by_name;
use stribeck::friction::{Armstrong, Wojewoda};
use stribeck::model::{Model, ModelType, rate_in};

const HELD: f64 = 2.0;
const FORWARD: f64 = 3.0;
const BACKWARD: f64 = 4.0;

/// A row of a law, by names, under a load of 10 N.
struct Contact {
    model: &'static ModelType,
    row: Vec<f64>,
}

impl Contact {
    fn new(name: &str, values: &[(&str, f64)]) -> Contact {
        let model = by_name(name).unwrap();
        let row = model.table.iter().map(|variable| variable.start).collect();
        let mut contact = Contact { model, row };
        contact.put(&[&[("normal_force", 10.0)], values].concat());
        contact
    }

    fn put(&mut self, values: &[(&str, f64)]) {
        for (name, value) in values {
            self.row[self.model.find(name).unwrap()] = *value;
        }
    }

    fn get(&self, name: &str) -> f64 {
        self.row[self.model.find(name).unwrap()]
    }

    fn due(&self) -> Vec<bool> {
        let mut indicators = vec![f64::NAN; self.model.event_indicators];
        self.model.indicate(&self.row, &mut indicators);
        indicators.iter().map(|indicator| *indicator < 0.0).collect()
    }

    /// The events that are due with these values; the others keep theirs.
    fn due_with(&mut self, values: &[(&str, f64)]) -> Vec<bool> {
        self.put(values);
        self.due()
    }

    fn pass_event(&mut self) {
        assert!(self.model.at_event(&mut self.row));
        self.compute();
    }

    fn compute(&mut self) {
        assert!(self.model.output(&mut self.row));
    }

    /// The rate of a state by the law of this contact.
    fn rate<M: Model>(&self, name: &str) -> f64 {
        let mut rate = self.row.clone();
        rate_in::<M, f64>(&self.row, &mut rate);
        rate[self.model.find(name).unwrap()]
    }

    fn has(&self, expected: &[(&str, f64)]) {
        for (name, value) in expected {
            let found = self.get(name);
            assert!((found - value).abs() <= 1e-9 * value.abs(), "{name} = {found}, not {value}: {:?}", self.row);
        }
    }
}

/// Levels of 1.5 and 1 N, and a stiffness of 1.5e5 N/m up to 10 um: held, also at the first event in motion, until the
/// deflection is reached outwards; then sliding, whatever the load, until the motion turns.
#[test]
fn a_bond_of_the_reset_integrator_breaks_outwards_and_forms_where_the_motion_turns() {
    for side in [1.0, -1.0] {
        let [forward, v, z] = [side, side * 1e-3, side * 1e-5];
        let start = [("velocity", v), ("bristle_deflection", 0.5 * z), ("sigma_1", 0.0)];
        let mut contact = Contact::new("ResetIntegrator", &start);
        contact.pass_event();
        contact.has(&[("bond", HELD), ("friction_force", side * 0.75), ("sticking", 1.0), ("slip_direction", 0.0)]);
        assert_eq!(contact.due_with(&[("bristle_deflection", 0.999 * z)]), [false, false]);
        assert_eq!(contact.due_with(&[("velocity", -v), ("bristle_deflection", 1.001 * z)]), [false, false]);
        contact.pass_event();
        contact.has(&[("bond", HELD), ("bristle_deflection", z), ("friction_force", side * 1.5)]);
        assert_eq!(contact.due_with(&[("velocity", v), ("bristle_deflection", 1.001 * z)]), [true, false]);
        contact.pass_event();
        let slides = if side > 0.0 { FORWARD } else { BACKWARD };
        contact.has(&[("bond", slides), ("bristle_deflection", z), ("slip_direction", forward)]);
        contact.has(&[("friction_force", side), ("sticking", 0.0)]);
        assert_eq!(contact.due_with(&[("normal_force", 12.0)]), [false, false]);
        contact.pass_event();
        contact.has(&[("bond", slides), ("bristle_deflection", 1.2 * z), ("friction_force", side * 1.2)]);
        for velocity in [0.0, side * -1e-13] {
            assert_eq!(contact.due_with(&[("velocity", velocity)]), [false, false], "{velocity}");
        }
        assert_eq!(contact.due_with(&[("velocity", side * -1e-8)]), [true, false]);
        contact.pass_event();
        contact.has(&[("bond", HELD), ("bristle_deflection", 1.2 * z), ("slip_direction", 0.0), ("sticking", 1.0)]);
        assert_eq!(contact.due_with(&[("normal_force", 0.0)]), [false, true]);
        contact.pass_event();
        contact.has(&[("bond", HELD), ("bristle_deflection", 0.0), ("friction_force", 0.0)]);
    }
}

/// After steps, which have no phase, an event finds what they have left: a contact that slides, in motion and at rest, with
/// the last force.
#[test]
fn an_event_goes_on_from_the_steps_of_the_reset_integrator() {
    for rest in [false, true] {
        let mut contact = Contact::new("ResetIntegrator", &[("velocity", -1e-3), ("sigma_1", 0.0)]);
        assert!(contact.model.advance(&mut contact.row, 0.1));
        contact.put(&[("velocity", if rest { 0.0 } else { -1e-3 })]);
        contact.pass_event();
        contact.has(&[("bond", BACKWARD), ("friction_force", -1.0), ("bristle_deflection", -1e-5)]);
        assert_eq!(contact.due(), [false, false]);
    }
}

/// A contact that has rested for gamma holds 1.25 N of 1 to 1.5: it breaks there, moving outwards, and keeps this level as
/// its own; it stops where the motion turns, with what the velocity of a time lag ago leaves of it.
#[test]
fn a_contact_of_armstrong_breaks_at_the_level_that_has_risen() {
    for side in [1.0, -1.0] {
        let [v, z] = [side * 1e-3, side * 1e-5];
        let start = [("velocity", v), ("bristle_deflection", 1.249 * z), ("dwell_time", 2.0), ("gamma", 2.0)];
        let mut contact = Contact::new("Armstrong", &start);
        let waiting = [false, false, false];
        assert_eq!(contact.due(), waiting);
        contact.pass_event();
        contact.has(&[("phase", HELD), ("slipping", 0.0), ("friction_force", side * 1.249), ("sticking", 1.0)]);
        // Past the level inwards, only the reserve is used up, and nothing breaks.
        let inwards = [("velocity", -v), ("bristle_deflection", 1.251 * z)];
        assert_eq!(contact.due_with(&inwards), [false, true, false]);
        contact.pass_event();
        contact.has(&[("phase", HELD), ("slipping", 0.0), ("dwell_time", 2.0), ("friction_force", side * 1.25)]);
        // What the level does not carry goes within 0.1 ms, unless the motion stretches it.
        assert_abs_diff_eq!(contact.rate::<Armstrong>("bristle_deflection"), -v - side * 1e-8 / 1e-4, epsilon = 1e-12);
        assert_eq!(contact.due_with(&[("velocity", v)]), [true, true, false]);
        contact.pass_event();
        let slides = if side > 0.0 { FORWARD } else { BACKWARD };
        contact.has(&[("phase", slides), ("slipping", 1.0), ("dwell_time", 0.0), ("stribeck_coefficient", 0.025)]);
        contact.has(&[("bristle_deflection", 1.25 * z), ("sticking", 0.0)]);
        for velocity in [v, side * 40.0, side * 1e-9, side * -1e-13] {
            assert_eq!(contact.due_with(&[("velocity", velocity)]), waiting, "{velocity}");
        }
        let lagged = [("velocity", side * -1e-8), ("lagged_velocity", 1e-3), ("stribeck_velocity", 1e-3)];
        assert_eq!(contact.due_with(&lagged), [true, false, false]);
        contact.pass_event();
        contact.has(&[("phase", HELD), ("slipping", 0.0), ("stribeck_coefficient", 0.0125), ("sticking", 1.0)]);
        contact.has(&[("bristle_deflection", 1.125 * z), ("friction_force", side * 1.125)]);
        assert_eq!(contact.due_with(&[("normal_force", 0.0)]), [false, true, true]);
        contact.pass_event();
        contact.has(&[("bristle_deflection", 0.0), ("stribeck_coefficient", 0.0), ("friction_force", 0.0)]);
    }
}

/// Held to 1.5 N or 15 um: beyond it inwards nothing breaks, and the excess goes within 0.1 ms; outwards it slides, and it is
/// stuck again where the motion turns.
#[test]
fn a_spring_of_wojewoda_breaks_outwards_only() {
    for side in [1.0, -1.0] {
        let [v, z] = [side * 1e-3, side * 1.5e-5];
        let mut contact = Contact::new("Wojewoda", &[("velocity", v), ("bristle_deflection", 0.5 * z)]);
        contact.pass_event();
        contact.has(&[("phase", HELD), ("slipping", 0.0), ("friction_force", side * 0.75)]);
        assert!(!contact.due_with(&[("velocity", -v), ("bristle_deflection", 1.001 * z)])[0]);
        let back = contact.rate::<Wojewoda>("bristle_deflection");
        assert_abs_diff_eq!(back, -v - side * 1.5e-8 / 1e-4, epsilon = 1e-12);
        contact.pass_event();
        contact.has(&[("phase", HELD), ("bristle_deflection", z), ("friction_force", side * 1.5)]);
        assert!(contact.due_with(&[("velocity", v), ("bristle_deflection", 1.001 * z)])[0]);
        contact.pass_event();
        let slides = if side > 0.0 { FORWARD } else { BACKWARD };
        contact.has(&[("phase", slides), ("slipping", 1.0), ("bristle_deflection", z)]);
        assert!(!contact.due_with(&[("velocity", side * -1e-13)])[0]);
        contact.put(&[("velocity", side * 1e-9)]);
        contact.pass_event();
        contact.has(&[("phase", slides), ("slipping", 1.0)]);
        assert!(contact.due_with(&[("velocity", side * -1e-8)])[0]);
        contact.pass_event();
        contact.has(&[("phase", HELD), ("slipping", 0.0), ("sticking", 1.0)]);
        let kept = side * contact.get("bristle_deflection");
        assert!(kept > 0.0 && kept < 1.5e-5, "{kept}");
    }
}

/// A stuck contact whose load falls by half while it is stretched to 0.9 of its level keeps no more than that load carries,
/// after a step of any length: the old load does not bring the force back. An event does the same with Wojewoda's spring,
/// and leaves the deflection of Armstrong's to its rate.
#[test]
fn a_load_that_falls_cuts_the_deflection() {
    for (name, level) in [("Wojewoda", 1.5), ("Armstrong", 1.0)] {
        let z = level / 1e5;
        for pass in [0, 1, 2] {
            let mut contact = Contact::new(name, &[("bristle_deflection", 0.9 * z)]);
            contact.compute();
            contact.has(&[("friction_force", 0.9 * level)]);
            contact.put(&[("normal_force", 5.0)]);
            match pass {
                0 => contact.pass_event(),
                1 => assert!(contact.model.advance(&mut contact.row, 1e-12)),
                _ => {
                    let slope = vec![0.0; contact.row.len()];
                    assert!(contact.model.advance_ramp(&mut contact.row, &slope, 1e-3));
                }
            }
            contact.compute();
            contact.has(&[("friction_force", 0.5 * level)]);
            contact.put(&[("normal_force", 10.0)]);
            contact.compute();
            contact.has(&[("friction_force", if pass == 0 && name == "Armstrong" { 0.9 } else { 0.5 } * level)]);
        }
    }
}

/// Which laws are made of straight lines between events, with the start values and in which motion.
#[test]
fn motions_between_events_are_straight_lines_of_some_laws_only() {
    let found = |name: &str, values: &[(&str, f64)]| {
        let mut contact = Contact::new(name, values);
        contact.pass_event();
        contact.model.is_linear(&contact.row)
    };
    assert!(found("Armstrong", &[]) && !found("LuGre", &[]));
    let slipping = [("velocity", 1e-3), ("slipping", 1.0), ("bristle_deflection", 1e-5)];
    assert!(!found("Armstrong", &slipping), "the level follows the velocity");
    let along = [("velocity_x", 3e-2), ("bristle_deflection_x", 1e-5)];
    let across = [("velocity_x", 3e-2), ("bristle_deflection_x", 0.6e-5), ("bristle_deflection_y", 0.8e-5)];
    assert!(found("Liang", &[]) && found("Liang", &along));
    assert!(!found("Liang", &across), "a bristle that turns");
    let steps = Contact::new("Liang", &[]);
    assert!(!steps.model.is_linear(&steps.row), "no event has found a motion");
}
