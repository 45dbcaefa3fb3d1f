//! The friction laws as a contact of the strut: they start as on their own, and they release a load that is gone.

use crate::common::Bench;
use approx::abs_diff_eq;
use stribeck::catalogue::by_name;
use stribeck::model::Kind;
use stribeck::model::Meaning;

/// Numbers and names of the friction laws, without "None".
fn laws() -> impl Iterator<Item = (f64, &'static str)> {
    let model = by_name("GuideContact").unwrap();
    let Kind::Enumeration(laws) = model.table.at(model.find("friction.model").unwrap()).kind else { panic!() };
    laws.items.iter().enumerate().skip(1).map(|(at, law)| (at as f64 + 1.0, law.name))
}

/// A contact without preload, 0.1 and 0.15, and its friction.
fn contact(law: f64) -> Bench {
    Bench::new("GuideContact", &[("friction.model", law), ("levels.preload_k", 0.0), ("levels.preload_s", 0.0)])
}

/// The same contact in a strut without other parts, with its load as a force across the rod: half at the rod guide,
/// half at the piston.
fn strut(law: f64) -> Bench {
    let mut strut = Bench::new("ShockAbsorber", &[("friction.model", law), ("side.mode", 1.0), ("geom.h_reg", 0.0)]);
    for contact in ["c1", "c2"] {
        for (level, value) in [("mu_s", 0.15), ("mu_k", 0.1), ("preload_s", 0.0), ("preload_k", 0.0)] {
            strut.set(&format!("{contact}.{level}"), value);
        }
    }
    strut
}

/// A force in the middle of the overlap, reduced to the eye of the tube.
fn press(bench: &mut Bench, normal_force: f64) {
    if bench.instance.model().name == "GuideContact" {
        return bench.set("normal_force", normal_force);
    }
    let middle = 0.5 * (0.125 + 0.1775 - 0.105);
    bench.set("side_force_m", normal_force);
    bench.set("side_moment_n", middle * normal_force);
}

fn friction(bench: &mut Bench) -> f64 {
    if bench.instance.model().name == "GuideContact" {
        bench.get("friction_force")
    } else {
        -bench.get("force_friction")
    }
}

/// Moves the contact at a velocity, and returns the friction after each step of 1 ms. The length of the strut stays
/// constant, and so does its load.
fn moved(bench: &mut Bench, velocity: f64, steps: usize) -> Vec<f64> {
    bench.set("velocity", velocity);
    (0..steps)
        .map(|_| {
            bench.step(1e-3);
            friction(bench)
        })
        .collect()
}

/// Each law on its own and in the contact, with only the load set.
#[test]
fn laws_start_in_a_contact_as_on_their_own() {
    for (number, name) in laws() {
        let (mut contact, mut law) = (contact(number), Bench::new(name, &[]));
        contact.set("normal_force", 9.81);
        let has_acceleration = law.instance.model().find("acceleration").is_some();
        for k in 0..600 {
            let phase = 0.02 * f64::from(k);
            for bench in [&mut contact, &mut law] {
                // From 1 um/s to 40 mm/s, through rest.
                bench.set("velocity", 0.04 * phase.sin().powi(5));
                if has_acceleration {
                    bench.set("acceleration", 4.0 * phase.sin().powi(4) * phase.cos());
                }
                bench.step(1e-3);
            }
            let [here, alone] = [contact.get("friction_force"), law.get("friction_force")];
            assert!(abs_diff_eq!(here, alone, epsilon = 1e-9), "{name}, step {k}: {here} N, on its own {alone} N");
        }
    }
}

/// As in the table for users: the parameter that a law uses has the default of the law's own.
#[test]
fn parameters_of_a_law_start_at_its_own_values() {
    let given = [Meaning::KineticLevel, Meaning::StaticLevel, Meaning::Mass, Meaning::Exchange];
    for model in ["GuideContact", "ShockAbsorber"].map(|name| by_name(name).unwrap()) {
        for (_, name) in laws() {
            let law = by_name(name).unwrap();
            for variable in law.table.iter().filter(|variable| variable.role.is_parameter()) {
                let path = variable.path.to_string();
                let index = variable.path.segments()[0].index;
                if given.contains(&variable.meaning) || index > 16 {
                    continue;
                }
                let own = model.find(&format!("friction.{name}.{path}"));
                let column = own.or_else(|| model.find(&format!("friction.{path}")));
                let column = column.unwrap_or_else(|| panic!("{}: no {path} for {name}", model.name));
                assert_eq!(model.table.at(column).start, variable.start, "{}: {path} of {name}", model.name);
            }
        }
    }
}

/// 30 N on a contact of 40 N, 20 kg: by default Gonthier's law holds them.
#[test]
fn gonthier_holds_a_load_by_default() {
    let number = laws().find(|law| law.1 == "Gonthier").unwrap().0;
    let mut contact = contact(number);
    press(&mut contact, 400.0);
    let (mut velocity, h) = (0.0, 1e-3);
    for _ in 0..2_000 {
        contact.set("velocity", velocity);
        contact.step(h);
        velocity += h * (30.0 - contact.get("friction_force")) / 20.0;
    }
    assert!(velocity.abs() < 1e-5, "{velocity} m/s");
}

/// Paths to a contact at rest under 100 N: after sliding, half way back, and after a fine oscillation that leaves the
/// elements of a law strained against each other. Velocities and numbers of steps.
const WAYS: [&[(f64, usize)]; 3] = [
    &[(0.01, 300), (0.0, 2)],
    &[(0.01, 300), (-1e-3, 50), (0.0, 2)],
    &[(0.01, 100), (-1e-3, 160), (1e-3, 80), (-1e-3, 30), (0.0, 2)],
];

/// Amount by which a law exceeds its static level even under a constant load: smooth curves by up to 1 %; one whose
/// peak is the difference of two relaxations by more after a reversal, as both then change by twice as much.
fn overshoot(law: &str) -> f64 {
    if law == "BlimanSorine" { 1.35 } else { 1.0101 }
}

/// The load falls at rest: the friction does not exceed the new static level, at rest or in slow motion to either side,
/// and it resists continued motion.
#[test]
fn friction_falls_with_the_load() {
    for (number, name) in laws() {
        for (make, case) in [(contact as fn(f64) -> Bench, "contact"), (strut, "strut")] {
            for (way, legs) in WAYS.iter().enumerate() {
                for onward in [1e-5, -1e-5, 1e-4, -1e-4] {
                    let mut bench = make(number);
                    press(&mut bench, 100.0);
                    for (velocity, steps) in legs.iter() {
                        moved(&mut bench, *velocity, *steps);
                    }
                    press(&mut bench, 5.0);
                    let level = overshoot(name) * 0.15 * 5.0;
                    let at_rest = friction(&mut bench);
                    let case = format!("{name}, {case}, way {way}, {onward} m/s");
                    assert!(at_rest.abs() <= level, "{case}: {at_rest} N at rest, static level {level} N");
                    let forces = [moved(&mut bench, 0.0, 1), moved(&mut bench, onward, 400)].concat();
                    for (k, force) in forces.iter().enumerate() {
                        // Damping and viscous part are those of the motion, of up to two contacts.
                        let most = level + 2.0 * 320.0 * onward.abs();
                        assert!(force.abs() <= most, "{case}, step {k}: {force} N, static level {level} N");
                        let drives = at_rest * onward >= 0.0 && force * onward.signum() < -1e-9;
                        assert!(!drives, "{case}, step {k}: {force} N along the motion");
                    }
                }
            }
        }
    }
}

/// Force of a law whose curve rises above its static level: for levels of 10 N up to 10.2403 N beyond the peak velocity,
/// by hand (the largest tanh(2 u) + (1 - tanh 2) u exp((1 - u^2) / 2), at u = 1.46016).
#[test]
fn a_smooth_curve_keeps_its_summit() {
    let (number, _) = laws().find(|(_, name)| *name == "SpeckerDynamic").expect("the law");
    let summit = |u: f64| 10.0 * ((2.0 * u).tanh() + (1.0 - 2f64.tanh()) * u * (0.5 * (1.0 - u * u)).exp());
    for sign in [1.0, -1.0] {
        let mut bench = contact(number);
        bench.set("levels.mu_s", 0.1);
        bench.set("levels.mu_k", 0.1);
        press(&mut bench, 100.0);
        for u in [1.0, 1.2, 1.46016, 1.8, 2.5] {
            let force = *moved(&mut bench, sign * u * 5e-4, 20_000).last().expect("a force");
            assert!((sign * force - summit(u)).abs() < 1e-6, "{u}: {force} N, {} N by hand", summit(u));
        }
        assert!((summit(1.46016) - 10.2403).abs() < 1e-4, "{}", summit(1.46016));
    }
}

/// If a solver integrates the states of a law, the friction falls with the load at once, and the states follow.
#[test]
fn friction_falls_with_the_load_under_a_solver() {
    // With the elements of some laws a contact is for steps only.
    let is_integrated = |name: &str| {
        let law = by_name(name).unwrap();
        law.model_exchange && law.find("element_count").is_none()
    };
    let mut tested = 0;
    for (number, name) in laws().filter(|(_, name)| is_integrated(name)) {
        let mut bench = contact(number);
        press(&mut bench, 100.0);
        moved(&mut bench, 0.01, 300);
        moved(&mut bench, 0.0, 2);
        press(&mut bench, 5.0);
        let model = bench.instance.model();
        let force = bench.column("friction_force");
        bench.instance.refresh().unwrap();
        let mut row = bench.instance.row().to_vec();
        let level = overshoot(name) * 0.15 * 5.0;
        assert!(row[force].abs() <= level, "{name}: {} N", row[force]);
        let (mut rate, dt) = (row.clone(), 1e-5);
        for _ in 0..2_000 {
            model.rate(&row, &mut rate);
            for state in model.continuous_states() {
                row[state] += dt * rate[state];
            }
        }
        assert!(model.output(&mut row) && row[force].abs() <= level, "{name}: {} N", row[force]);
        row[bench.column("normal_force")] = 100.0;
        assert!(model.output(&mut row));
        // The states of some laws are relative to the load: they have their old force again. So has a broken bond.
        let is_share = ["BlimanSorine", "Dankowicz", "ResetIntegrator"].contains(&name);
        assert!(is_share || row[force].abs() <= 1.01 * level, "{name}: {} N again", row[force]);
        tested += 1;
    }
    assert!(tested > 15);
}

/// Setting the shared parameter for a law that has its own gives a warning with the name to set instead.
#[test]
fn a_shared_parameter_that_the_law_does_not_use_warns() {
    let number = |name: &str| laws().find(|law| law.1 == name).unwrap().0;
    let warning = |law: &str, set: &[(&str, f64)]| {
        let bench = Bench::new("GuideContact", &[set, &[("friction.model", number(law))]].concat());
        bench.instance.model().warning(bench.instance.row()).map(|fault| fault.to_string())
    };
    let set = [("friction.transition_velocity", 0.01)];
    let text = warning("Gonthier", &set).unwrap();
    let own = "friction.Gonthier.transition_velocity";
    assert_eq!(
        text,
        format!("friction.transition_velocity = 0.01 has no effect on friction.model = Gonthier: set {own}")
    );
    assert_eq!(warning("Gonthier", &[]), None);
    assert_eq!(warning("Gonthier", &[("friction.Gonthier.transition_velocity", 0.01)]), None);
    assert_eq!(warning("Karnopp", &set), None);
    assert_eq!(warning("LuGre", &set), None);
}

/// A law without levels has its viscous part alone: along a velocity that passes zero it takes d v^2 / 3 times the
/// time.
#[test]
fn drag_without_a_load_dissipates_what_its_force_does() {
    let (drag, speed, h) = (12.0, 0.2, 0.01);
    let mut viscous = 0;
    for (law, name) in laws() {
        for mass in [0.0, 2.0] {
            let mut bench = contact(law);
            for coefficient in ["friction.viscous_coefficient", &format!("friction.{name}.viscous_coefficient")] {
                if bench.has(coefficient) {
                    bench.set(coefficient, drag);
                }
            }
            bench.set("friction.mass", mass);
            bench.set("normal_force", 0.0);
            bench.set("velocity", -speed);
            let column = bench.column("velocity");
            bench.instance.set_slope(column, 2.0 * speed / h).unwrap();
            bench.step(h);
            // Without a viscous part there is nothing.
            let has_drag = friction(&mut bench) != 0.0;
            viscous += usize::from(has_drag);
            let expected = if has_drag { drag * speed * speed / 3.0 * h } else { 0.0 };
            let found = bench.get("dissipated_energy");
            // Levels are taken a little beside the reversal.
            assert!(
                abs_diff_eq!(found, expected, epsilon = 1e-8 * expected),
                "{name}, {mass} kg: {found} J instead of {expected} J"
            );
        }
    }
    assert!(viscous > 20, "{viscous}");
}
