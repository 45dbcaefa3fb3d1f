//! Events within steps of co-simulation.

use super::importer::{Choice, Importer};
use super::{driven, reals};
use stribeck::catalogue;
use stribeck::model::Role;
use stribeck_ffi::fmi3::types::fmi3Status::fmi3OK;

/// Communication step, in s.
const H: f64 = 0.05;

fn law(name: &str, choice: &Choice, values: &[(&str, f64)]) -> Importer {
    use stribeck_ffi::fmi3::lifecycle::{Purpose, State};
    use stribeck_ffi::fmi3::setup::*;
    use stribeck_ffi::fmi3::step::fmi3EnterStepMode;
    let importer = Importer::in_state(name, Purpose::CoSimulation, choice, State::InitializationMode);
    for (name, value) in values {
        assert_eq!(importer.set(name, *value), fmi3OK, "{}", importer.last_message());
    }
    // SAFETY: an instance of this test.
    unsafe {
        assert_eq!(fmi3ExitInitializationMode(importer.instance), fmi3OK);
        if choice.event_mode {
            importer.update();
            assert_eq!(fmi3EnterStepMode(importer.instance), fmi3OK);
        }
    }
    importer
}

const BODY: [(&str, f64); 3] = [("mu_k", 0.1), ("mass", 2.0), ("normal_force", 19.62)];

/// A mass that a constant force pulls against friction comes to rest after m v / (f_C - f_e), in its seventh step; the law
/// finds the time, and the mass is at rest there.
#[test]
fn a_pulled_mass_sticks_at_the_closed_form_time() {
    let (v, pull, mass, friction) = (0.137, 1.2, 2.0, 1.962);
    let law = law("Coulomb", &Choice::events(), &BODY);
    let values = [("mass", mass), ("stiffness", 0.0), ("preload", pull), ("velocity", v), ("pull_velocity", 0.0)];
    let body = self::law("PulledMass", &Choice::default(), &values);
    let (mut t, mut steps) = (0.0, 0);
    let stop = loop {
        for name in ["velocity", "external_force"] {
            assert_eq!(law.set(name, body.get(name)), fmi3OK);
        }
        let answer = law.step(t, H);
        assert_eq!(body.set("friction_force", friction), fmi3OK);
        body.step(t, answer.time - t);
        t = answer.time;
        steps += 1;
        assert_eq!(answer.event, answer.early);
        if answer.event {
            break answer.time;
        }
        assert!(steps < 100, "it never comes to rest");
    };
    let exact = mass * v / (friction - pull);
    assert!((stop - exact).abs() < 1e-9, "{stop} against {exact}");
    assert_eq!(steps, (exact / H).ceil() as i32);
    assert!(law.sticks() && body.get("velocity").abs() < 1e-12, "{}", body.get("velocity"));
    law.handle_event();
    assert_eq!(law.set("velocity", 0.0), fmi3OK);
    for k in 0..4 {
        let answer = law.step(stop + f64::from(k) * H, H);
        assert!(!answer.event && !answer.early, "it stays at rest");
        assert_eq!(law.get("friction_force"), pull);
    }
}

/// A bond that is bent at constant velocity breaks at z_m / v.
#[test]
fn a_bond_slips_at_the_closed_form_time() {
    let v = 3e-5;
    let law = law("ResetIntegrator", &Choice::events(), &[("velocity", v)]);
    let exact = law.get("mu_k") * law.get("normal_force") / law.get("sigma_0") / v;
    let mut t = 0.0;
    let slip = loop {
        let was_stuck = law.sticks();
        let answer = law.step(t, H);
        if answer.early {
            assert!(was_stuck && !law.sticks());
            break answer.time;
        }
        t = answer.time;
        assert!(t < 10.0, "it never slips");
    };
    assert!((slip - exact).abs() < 1e-9, "{slip} against {exact}");
    assert!((slip / H).fract() > 1e-3, "not at a communication point");
}

/// Without early return the step goes to its end and reports that results have jumped; without event mode not even that.
#[test]
fn nothing_is_signalled_unasked() {
    for (event_mode, early_return) in [(false, false), (false, true), (true, false)] {
        let choice = Choice { event_mode, early_return, ..Choice::default() };
        let law = law("Coulomb", &choice, &BODY);
        assert_eq!(law.set("velocity", 1e-3), fmi3OK);
        let answer = law.step(0.0, H);
        assert_eq!((answer.event, answer.early, answer.time), (event_mode, false, H));
        assert!(law.sticks());
    }
}

/// Every model in event mode reaches the end of a run with inputs that jump at communication points; events do not follow
/// each other without end, and no result is undefined.
#[test]
fn every_model_runs_in_event_mode() {
    let mut count = 0;
    for model in catalogue::models() {
        let importer = Importer::ready_with(model.name, &Choice::events());
        let (inputs, outputs) = (reals(model, |role| role == Role::Input), reals(model, Role::is_output));
        let mut events = 0;
        for k in 0..40 {
            for input in &inputs {
                let values: Vec<f64> = input.columns.iter().map(|at| driven(&model.table.at(*at), k)).collect();
                assert_eq!(importer.set_all(&[input.reference], &values), fmi3OK, "{}", importer.last_message());
            }
            let (mut t, end) = (f64::from(k) * 2e-3, f64::from(k + 1) * 2e-3);
            while t < end {
                let answer = importer.step(t, end - t);
                assert!(answer.time >= t && answer.time <= end && answer.early == (answer.time < end));
                assert!(!answer.early || answer.event);
                t = answer.time;
                if answer.event {
                    events += 1;
                    importer.handle_event();
                }
                assert!(events < 400, "{}: too many events", model.name);
            }
            for output in &outputs {
                let mut values = vec![f64::NAN; output.columns.len()];
                assert_eq!(importer.get_all(&[output.reference], &mut values), fmi3OK);
                assert!(values.iter().all(|value| value.is_finite()));
            }
        }
        count += events;
        if events > 0 {
            println!("{}: {events} events in 40 steps", model.name);
        }
    }
    assert!(count > 0);
    println!("figure: {count} events in runs of all models");
}
