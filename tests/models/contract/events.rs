//! Model Exchange: events, phases and event indicators.

use super::{axes, friction_models, set_velocity};
use crate::common::random::Random;
use crate::common::{Bench, holding_laws, rows};
use approx::{abs_diff_eq, assert_abs_diff_eq};
use stribeck::model::{Meaning, ModelType};

/// Without load in Model Exchange: an event indicator changes its sign where the load vanishes, and the event releases
/// the contact. Its changes are declared.
#[test]
fn an_event_without_load_releases_the_contact() {
    let mut tested = 0;
    for model in friction_models().filter(|model| model.model_exchange && model.find("normal_force").is_some()) {
        let mut bench = Bench::new(model.name, &[]);
        let axes = axes(&bench);
        set_velocity(&mut bench, 0.01);
        bench.step(1e-2);
        let mut row = bench.instance.row().to_vec();
        let put = |row: &mut [f64], name: &str, value: f64| row[model.find(name).unwrap()] = value;
        assert!(model.at_event(&mut row), "{}", model.name);
        let signs = |row: &[f64]| {
            let mut indicators = vec![f64::NAN; model.event_indicators];
            model.indicate(row, &mut indicators);
            assert!(indicators.iter().all(|indicator| *indicator != 0.0), "{} {indicators:?}", model.name);
            indicators.iter().map(|indicator| *indicator > 0.0).collect::<Vec<_>>()
        };
        let loaded = signs(&row);
        put(&mut row, "normal_force", 0.0);
        assert_ne!(signs(&row), loaded, "{} does not detect the loss of its load", model.name);
        let before = row.clone();
        assert!(model.at_event(&mut row), "{}", model.name);
        for (column, variable) in model.table.iter().enumerate() {
            let is_declared = variable.reinit || variable.jumps || row[column] == before[column];
            assert!(is_declared, "{} changes {} at an event", model.name, variable.path);
        }
        let unloaded = signs(&row);
        put(&mut row, "normal_force", 9.81);
        assert_ne!(signs(&row), unloaded, "{} does not detect the return of its load", model.name);
        for (velocity, force, _) in axes {
            put(&mut row, velocity, 0.0);
            assert!(model.at_event(&mut row) && model.output(&mut row), "{}", model.name);
            assert_eq!(row[model.find(force).unwrap()], 0.0, "{} remembers its old load", model.name);
        }
        tested += 1;
    }
    assert!(tested > 20);
}

/// Bristles whose level is set to 0 while they are deflected: a solver would keep a force that a step drops at once,
/// because it only integrates rates. So the shortest step changes little, or the law rejects such a level in Model
/// Exchange.
#[test]
fn a_solver_keeps_no_force_that_a_step_drops() {
    let mut refusing = Vec::new();
    for model in friction_models().filter(|model| model.model_exchange) {
        let Some(mu_k) = model.find("mu_k").filter(|column| model.table.at(*column).admits(0.0)) else { continue };
        let mut bench = Bench::new(model.name, &[]);
        let axes = axes(&bench);
        set_velocity(&mut bench, 0.01);
        bench.step(1e-2);
        set_velocity(&mut bench, 0.0);
        let mut row = bench.instance.row().to_vec();
        assert_eq!(model.check_model_exchange(&row), Ok(()), "{}", model.name);
        for column in [Some(mu_k), model.find("mu_s")].into_iter().flatten() {
            row[column] = 0.0;
        }
        assert_eq!(model.check(&row), Ok(()), "{}", model.name);
        if let Err(fault) = model.check_model_exchange(&row) {
            assert!(fault.to_string().contains(" = 0: must be > 0 in Model Exchange"), "{fault}");
            refusing.push(model.name);
            continue;
        }
        assert!(model.at_event(&mut row) && model.output(&mut row), "{}", model.name);
        let mut stepped = row.clone();
        assert!(model.advance(&mut stepped, 1e-9), "{}", model.name);
        for force in axes.iter().map(|(_, force, _)| model.find(force).unwrap()) {
            let (kept, left) = (row[force], stepped[force]);
            assert!(abs_diff_eq!(kept, left, epsilon = 1e-4), "{} keeps {kept} N, a step leaves {left} N", model.name);
        }
    }
    assert_eq!(refusing, ["Dahl", "ElastoPlastic", "SpeckerDynamic", "LuGrePlanar", "ElastoPlasticPlanar"]);
}

/// A step ignores the phase found by an event: it uses the velocity, from the first step on.
#[test]
fn steps_ignore_the_phase_found_by_an_event() {
    let mut tested = 0;
    for model in friction_models().filter(|model| model.find("phase").is_some()) {
        let with_mass = [[("mass", 1.0), ("exchange", 1.0)], [("mass", 1.0), ("exchange", 2.0)]];
        let held = with_mass.iter().map(|with| &with[..]).filter(|_| model.find("mass").is_some());
        for with in std::iter::once(&[][..]).chain(held) {
            let run = |phase: f64| {
                let values = [("external_force", 1000.0), ("velocity", 0.02), ("phase", phase)];
                let known = values.iter().filter(|(name, _)| model.find(name).is_some()).copied();
                let values: Vec<(&str, f64)> = with.iter().copied().chain(known).collect();
                let mut bench = Bench::for_model_exchange(model.name, &values);
                bench.step(1e-3);
                assert_eq!(bench.get("phase"), 1.0, "{}", model.name);
                ["friction_force", "dissipated_energy", "sticking"].map(|name| bench.get(name))
            };
            let free = run(1.0);
            assert!(free[0] != 0.0 && free[0].abs() < 100.0, "{} {free:?}", model.name);
            for phase in [2.0, 3.0, 4.0] {
                assert_eq!(run(phase), free, "{}: phase {phase}, {with:?}", model.name);
            }
            tested += 1;
        }
    }
    assert!(tested > 20);
}

/// At an event a contact at rest is held as long as the static level carries the load. Until the next event its phase
/// does not change, even where a solver tries values beyond; its indicator falls below zero there: past the rest of a
/// sliding body, beyond the static level, and for a held body that is moved otherwise.
#[test]
fn events_catch_and_release_contacts_at_rest() {
    let is_driven = |model: &ModelType| model.find("external_force").is_some();
    let laws = friction_models().filter(|model| model.model_exchange && model.event_indicators >= 2);
    let seen = laws.filter(|model| is_driven(model) && is_held_at_rest(model)).count();
    assert!(seen >= 4, "{seen} laws");
}

/// Static level under a load of 10 N.
fn static_level(bench: &mut Bench) -> f64 {
    match bench.of_meaning(Meaning::StaticLevel).or_else(|| bench.of_meaning(Meaning::KineticLevel)) {
        Some(coefficient) => 10.0 * coefficient,
        None => 10.0 * bench.get("lever_arm") / bench.get("wheel_radius"),
    }
}

/// Tries a law; whether it holds a body at all.
fn is_held_at_rest(model: &'static ModelType) -> bool {
    let mut bench = Bench::for_model_exchange(model.name, &[("normal_force", 10.0)]);
    let level = static_level(&mut bench);
    let goes_on = |bench: &Bench| {
        let mut indicators = vec![f64::NAN; model.event_indicators];
        bench.instance.indicate(&mut indicators).expect("finite indicators");
        assert_ne!(indicators[0], 0.0, "{}", model.name);
        indicators[0] > 0.0
    };
    bench.set("external_force", 0.5 * level);
    // A law with a band around rest does not hold a body.
    if bench.get("friction_force") != 0.5 * level || bench.has("transition_velocity") {
        return false;
    }
    for velocity in [2e-3, -3e-4] {
        bench.set("velocity", velocity);
        bench.instance.at_event().expect("an event");
        assert_eq!(bench.get("sticking"), 0.0, "{}", model.name);
        assert!(goes_on(&bench), "{}", model.name);
        bench.set("velocity", -1e-8 * velocity.signum());
        assert!(bench.get("friction_force") * velocity > 0.0, "{}: as before the event", model.name);
        assert!(!goes_on(&bench), "{}: past its rest", model.name);
    }
    for share in [0.2, -0.7, 0.999] {
        bench.set("velocity", 0.0);
        bench.set("external_force", share * level);
        bench.instance.at_event().expect("an event");
        assert_eq!((bench.get("sticking"), bench.get("friction_force")), (1.0, share * level), "{}", model.name);
        for nearly in [1.0 - 3e-8, 1.0 + 3e-8] {
            bench.set("external_force", nearly * level);
            assert_eq!(goes_on(&bench), nearly < 1.0, "{} {share}", model.name);
        }
        bench.set("external_force", share * level);
        bench.set("velocity", 2e-6);
        assert!(!goes_on(&bench), "{}: moved otherwise", model.name);
    }
    bench.set("velocity", 0.0);
    bench.set("external_force", 1.01 * level);
    bench.instance.at_event().expect("an event");
    let force = bench.get("friction_force");
    assert!(bench.get("sticking") == 0.0 && force > 0.0 && force <= level, "{}: {force} N", model.name);
    true
}

/// The events of Karnopp's law are at the edge of its band, on the way out and on the way in.
#[test]
fn leaving_and_entering_the_band_are_events() {
    let mut bench = Bench::for_model_exchange("Karnopp", &[]);
    let edge = bench.get("transition_velocity");
    let mut indicators = vec![f64::NAN; bench.instance.model().event_indicators];
    for share in [0.5, -0.5, 1.5, -1.5] {
        bench.set("velocity", share * edge);
        bench.instance.at_event().expect("an event");
        bench.instance.indicate(&mut indicators).expect("finite indicators");
        assert!(indicators[0] > 0.0, "{indicators:?}");
        bench.set("velocity", (2.0 - share.abs()) * share.signum() * edge);
        bench.instance.indicate(&mut indicators).expect("finite indicators");
        assert!(indicators[0] < 0.0, "{indicators:?}");
    }
}

/// A stuck spring breaks where it carries the static level, moving outwards; the contact that slides comes to rest past
/// zero velocity, with the force at which the lower curve ends. Trials beyond an event change no branch.
#[test]
fn a_spring_breaks_at_the_static_level_and_comes_to_rest_with_the_last_force() {
    let mut bench = Bench::for_model_exchange("Wojewoda", &[("acceleration_source", 2.0)]);
    let goes_on = |bench: &Bench| {
        let mut indicators = vec![f64::NAN; bench.instance.model().event_indicators];
        bench.instance.indicate(&mut indicators).expect("finite indicators");
        indicators[0] > 0.0
    };
    for side in [1.0, -1.0] {
        bench.set("bristle_deflection", 0.0);
        bench.set("velocity", 0.0);
        bench.instance.at_event().expect("an event");
        for (share, speed, holds) in [(0.999, 1e-4, true), (1.001, 1e-4, false), (1.001, -1e-4, true)] {
            bench.set("bristle_deflection", side * share * 1.4715e-5);
            bench.set("velocity", side * speed);
            assert_eq!((goes_on(&bench), bench.get("sticking")), (holds, 1.0), "{share} {speed}");
            assert!((side * bench.get("friction_force") - 1.4715 * share.min(1.0)).abs() < 1e-12);
        }
        bench.set("velocity", side * 2e-3);
        bench.instance.at_event().expect("an event");
        let fade = 0.4905 * (-1.0f64).exp();
        for (external, force) in [(2.0, 0.981 + fade), (1.0, 1.0), (0.3, 0.981 - fade)] {
            bench.set("external_force", side * external);
            assert!((side * bench.get("friction_force") - force).abs() < 1e-12, "{external}");
            assert_eq!((goes_on(&bench), bench.get("slipping")), (true, 1.0));
        }
        bench.set("velocity", side * -1e-8);
        assert!(!goes_on(&bench) && side * bench.get("friction_force") > 0.4904, "past its rest, and on its branch");
        bench.instance.at_event().expect("an event");
        let found = ["sticking", "slipping", "friction_force"].map(|name| bench.get(name));
        assert_eq!(found[..2], [1.0, 0.0]);
        assert!((side * found[2] - 0.4905).abs() < 1e-12 && goes_on(&bench), "{found:?}");
    }
}

/// Force, power and rates of a row in a phase; none if Model Exchange refuses them.
fn driven_by(model: &ModelType, row: &[f64], phase: f64) -> Option<Vec<f64>> {
    let mut row = row.to_vec();
    row[model.find("phase")?] = phase;
    let is_given = model.check_model_exchange(&row).is_ok() && model.output(&mut row);
    let outputs = ["friction_force", "dissipated_power"].map(|name| row[model.find(name).expect("an output")]);
    let mut rates = vec![0.0; row.len()];
    model.rate(&row, &mut rates);
    is_given.then(|| outputs.into_iter().chain(rates).collect())
}

/// A law that needs no events moves in the same way in every phase, and one that needs them does not.
#[test]
fn laws_that_run_without_events_follow_no_phase() {
    let (mut random, mut needing, mut free) = (Random(11), Vec::new(), 0);
    for model in friction_models().filter(|model| model.model_exchange && model.find("phase").is_some()) {
        let (mut rejected, mut differing) = (0, 0);
        for _ in 0..500 {
            let row = rows::row(model, random.next(), &mut random);
            let phases = [1.0, 2.0, 3.0, 4.0].map(|phase| driven_by(model, &row, phase));
            let differs = phases.iter().any(|phase| *phase != phases[0]);
            if model.check_without_events(&row).is_ok() {
                assert!(!differs, "{}: {row:?}", model.name);
                free += 1;
            } else {
                rejected += 1;
                differing += usize::from(differs);
            }
        }
        assert!(rejected == 0 || differing > 0, "{} needs no events", model.name);
        needing.extend((rejected > 0).then_some(model.name));
    }
    assert!(free > 2000);
    let known = ["Coulomb", "CoulombStiction", "CoulombViscous", "Karnopp", "Stribeck"];
    assert!(known.iter().all(|law| needing.contains(law)), "{needing:?}");
    // What other tests take for them is what the printed laws without a band are.
    let mut holding: Vec<&str> = holding_laws().filter(|law| known.contains(law)).collect();
    holding.sort_unstable();
    assert_eq!(holding, known);
}

/// Which events are due: onset of slip, its end, loss of the load.
fn due(bench: &Bench) -> Vec<bool> {
    let mut indicators = vec![f64::NAN; bench.instance.model().event_indicators];
    bench.instance.indicate(&mut indicators).expect("finite indicators");
    indicators.iter().map(|indicator| *indicator < 0.0).collect()
}

/// Rate of the force of the first element.
fn force_rate(bench: &Bench) -> f64 {
    let mut rate = bench.instance.row().to_vec();
    bench.instance.model().rate(bench.instance.row(), &mut rate);
    rate[bench.column("element[1].force")]
}

/// An element of Maxwell-slip friction is a spring until an event finds it at its share of the level, moving outwards,
/// and slips until an event finds that the motion has turned.
#[test]
fn elements_begin_and_cease_to_slip_at_events() {
    let mut bench = Bench::for_model_exchange("MaxwellSlip", &[("velocity", 1e-5)]);
    let limit = 0.1 * 0.15 * 9.81;
    let spring = 0.5 * 1e5 * 1e-5;
    let level = |velocity: f64| 0.1 * (0.981 + 0.4905 * (-(velocity * 1e3).powi(2)).exp());
    bench.instance.at_event().expect("an event");
    for (force, velocity, is_due) in [(0.999, 1e-5, false), (1.001, 1e-5, true), (1.001, -1e-5, false)] {
        for side in [1.0, -1.0] {
            bench.set("element[1].force", side * force * limit);
            bench.set("velocity", side * velocity);
            assert_eq!(due(&bench), [is_due, false, false], "{force} {velocity} {side}");
            assert_abs_diff_eq!(force_rate(&bench), side * spring * velocity.signum(), epsilon = 1e-12);
        }
    }
    bench.set("element[1].force", 1.001 * limit);
    bench.set("velocity", 1e-5);
    bench.instance.at_event().expect("an event");
    assert_eq!((bench.get("element[1].slipping"), bench.get("slip"), bench.get("sticking")), (1.0, 3.0, 1.0));
    bench.set("velocity", 1e-3);
    assert_eq!(due(&bench), [false; 3]);
    // C (alpha - F / s), whatever the trial velocity.
    for velocity in [1e-3, -1e-3] {
        bench.set("velocity", velocity);
        let expected = 1e3 * (0.1 - 0.1 * 1.001 * limit / level(velocity));
        assert_abs_diff_eq!(force_rate(&bench), expected, epsilon = 1e-9);
    }
    assert_eq!(due(&bench), [false, true, false]);
    bench.instance.at_event().expect("an event");
    assert_eq!((bench.get("element[1].slipping"), bench.get("slip")), (0.0, 2.0));
    assert_abs_diff_eq!(force_rate(&bench), -0.5 * 1e5 * 1e-3, epsilon = 1e-9);
}

/// The same for `Leuven`, whose elements move with the deflection, slip at their strength and follow it while the load
/// rises, but not faster than their springs.
#[test]
fn elements_of_leuven_slip_as_the_deflection_moves() {
    let (v, load) = (1e-5, 9.81);
    let mut bench = Bench::for_model_exchange("Leuven", &[("velocity", v)]);
    let limit = 0.1 * 1.2 * 0.15 * load;
    let level = |load: f64| load * (0.1 + 0.05 * (-(v * 1e3f64).powi(2)).exp());
    bench.instance.at_event().expect("an event");
    for (share, velocity, is_due) in [(0.999, v, false), (1.001, v, true), (1.001, -v, false)] {
        for side in [1.0, -1.0] {
            let force = side * share * limit;
            bench.set("element[1].force", force);
            bench.set("velocity", side * velocity);
            assert_eq!(due(&bench), [is_due, false, false], "{share} {velocity} {side}");
            let spring = 0.5 * 1e5 * (side * velocity - v * force / level(load));
            assert_abs_diff_eq!(force_rate(&bench), spring, epsilon = 1e-12);
        }
    }
    bench.set("element[1].force", limit * (1.0 + 1e-11));
    bench.set("velocity", v);
    bench.instance.at_event().expect("an event");
    assert_eq!((bench.get("element[1].slipping"), bench.get("slip")), (1.0, 3.0));
    assert_eq!((due(&bench), force_rate(&bench)), (vec![false; 3], 0.0));
    bench.set("normal_force", load * (1.0 + 1e-9));
    assert_abs_diff_eq!(force_rate(&bench), (1e-9 - 1e-11) * limit / 1e-4, epsilon = 1e-11);
    bench.set("normal_force", 2.0 * load);
    let spring = 0.5 * 1e5 * v * (1.0 - limit / level(2.0 * load));
    assert_abs_diff_eq!(force_rate(&bench), spring, epsilon = 1e-9);
    bench.set("normal_force", load);
    bench.set("velocity", -v);
    assert_eq!(due(&bench), [false, true, false]);
    bench.instance.at_event().expect("an event");
    assert_eq!((bench.get("element[1].slipping"), bench.get("slip")), (0.0, 2.0));
}

/// Names of what a bristle in a plane does: its deflection, and the force.
const IN_SPACE: [[&str; 3]; 2] = [
    ["bristle_deflection_x", "bristle_deflection_y", "bristle_deflection_z"],
    ["friction_force_x", "friction_force_y", "friction_force_z"],
];

/// A bristle in a plane with its velocity, deflection in parts of 10 um, and load.
fn put_bristle(bench: &mut Bench, velocity: [f64; 2], deflection: [f64; 2], load: f64) {
    for (name, value) in ["velocity_x", "velocity_y"].into_iter().zip(velocity) {
        bench.set(name, value);
    }
    for (name, value) in IN_SPACE[0].into_iter().zip(deflection) {
        bench.set(name, 1e-5 * value);
    }
    bench.set("normal_force", load);
}

/// Rates of the deflection.
fn bristle_rates(bench: &Bench) -> [f64; 3] {
    let mut rate = bench.instance.row().to_vec();
    bench.instance.model().rate(bench.instance.row(), &mut rate);
    IN_SPACE[0].map(|name| rate[bench.column(name)])
}

/// A bristle of Liang's law under 10 N, whose limits are 15 um below v_0 and 10 um above: which events are due, and what
/// they find. In a phase that an event has found nothing depends on the limit that the speed would choose.
#[test]
fn bristles_of_liang_slide_and_change_their_limit_at_events() {
    const BONDED: f64 = 2.0;
    for side in [1.0, -1.0] {
        let mut bench = Bench::for_model_exchange("Liang", &[("normal_force", 10.0)]);
        bench.instance.at_event().expect("an event");
        let mut find = |velocity: f64, deflection: f64, load: f64| {
            put_bristle(&mut bench, [side * velocity, 0.0], [side * deflection, 0.0], load);
            let before = due(&bench);
            bench.instance.at_event().expect("an event");
            assert_eq!(due(&bench)[..2], [false; 2], "{velocity} {deflection}: still due");
            (before, bench.get("motion"), side * bench.get("friction_force_x"))
        };
        let damping = 316.227_766;
        // Velocity, deflection and load; whether to slide or stop, to pass v_0, to be released; motion and force.
        let legs = [
            ((1e-4, 0.0, 10.0), [false; 3], BONDED, damping * 1e-4),
            ((1e-4, 1.499, 10.0), [false; 3], BONDED, 1.499 + damping * 1e-4),
            ((-1e-4, 1.501, 10.0), [false; 3], BONDED, 1.5 - damping * 1e-4),
            ((1e-4, 1.501, 10.0), [true, false, false], 3.0, 1.5),
            ((9e-4, 1.5, 10.0), [false; 3], 3.0, 1.5),
            ((0.0, 1.5, 10.0), [false; 3], BONDED, 1.5),
            ((1.1e-3, 1.5, 10.0), [false, true, false], 5.0, 1.0),
            ((5e-2, 1.0, 11.0), [false; 3], 5.0, 1.1),
            ((5e-2, 1.1, 10.0), [false; 3], 5.0, 1.0),
            ((9e-4, 1.0, 10.0), [false, true, false], BONDED, 1.0 + damping * 9e-4),
            ((2e-3, 1.2, 10.0), [false, true, false], 5.0, 1.0),
            ((-1e-9, 1.0, 10.0), [true, true, false], BONDED, 1.0 - damping * 1e-9),
            ((-2e-3, 0.5, 10.0), [false, true, false], 4.0, 0.5 - damping * 2e-3),
            ((2e-3, 0.9, 0.0), [false, false, true], 5.0, 0.0),
            ((2e-3, 0.0, 1e-7), [false, false, true], 5.0, 0.0),
            ((2e-3, 0.0, 10.0), [true, false, false], 4.0, damping * 2e-3),
            ((2e-3, 1.1, 10.0), [true, false, false], 5.0, 1.0),
            ((0.0, 1.0, 10.0), [false, true, false], BONDED, 1.0),
        ];
        for ((velocity, deflection, load), is_due, motion, force) in legs {
            let what = format!("{velocity} {deflection} {load}");
            let (due, found, carried) = find(velocity, deflection, load);
            assert_eq!((due.as_slice(), found), (&is_due[..], motion), "{what}");
            assert_abs_diff_eq!(carried, force, epsilon = 1e-6);
        }
    }
}

/// Across a bristle that slides, the velocity turns it; along it, nothing does, until the velocity points inwards. Its
/// force follows a load that rises, but not faster than the bristle moves in 0.1 ms; then it is bonded.
#[test]
fn a_bristle_that_slides_turns_and_follows_its_circle() {
    let mut bench = Bench::for_model_exchange("Liang", &[("normal_force", 10.0)]);
    put_bristle(&mut bench, [3e-2, 0.0], [0.6, 0.8], 10.0);
    bench.instance.at_event().expect("an event");
    assert_eq!(bench.get("motion"), 5.0);
    let force = |bench: &mut Bench| IN_SPACE[1].map(|name| bench.get(name));
    let near = |a: [f64; 3], b: [f64; 3], most: f64| a.iter().zip(b).all(|(a, b)| (a - b).abs() < most);
    // v less its part along z: 0.03 (1, 0) - 0.018 (0.6, 0.8).
    let turning = [0.0192, -0.0144, 0.0];
    assert!(near(bristle_rates(&bench), turning, 1e-12), "{:?}", bristle_rates(&bench));
    let expected = [0.6 + 316.227_766 * 0.0192, 0.8 - 316.227_766 * 0.0144, 0.0];
    assert!(near(force(&mut bench), expected, 1e-6), "{:?}", force(&mut bench));
    // It moves outwards at 18 mm/s, which is 1.8 um or 0.18 N in 0.1 ms.
    for (load, level, is_due) in [(11.0, 1.1, false), (11.79, 1.179, false), (13.0, 1.18, true), (8.0, 0.8, false)] {
        bench.set("normal_force", load);
        let expected = [0.6 * level + 316.227_766 * 0.0192, 0.8 * level - 316.227_766 * 0.0144, 0.0];
        assert!(near(force(&mut bench), expected, 1e-6), "{load}: {:?}", force(&mut bench));
        assert_eq!(due(&bench), [is_due, false, false], "{load}");
        let follows = 1e-5 * (level - 1.0) / 1e-4;
        let rates = [turning[0] + 0.6 * follows, turning[1] + 0.8 * follows, 0.0];
        assert!(near(bristle_rates(&bench), rates, 1e-9), "{load}: {:?}", bristle_rates(&bench));
    }
    bench.set("normal_force", 13.0);
    bench.instance.at_event().expect("an event");
    assert_eq!((bench.get("motion"), bristle_rates(&bench)), (4.0, [3e-2, 0.0, 0.0]));
}

/// The printed rule leads a bristle that slides by the velocity, keeps it where the velocity passes 0, and turns it over
/// where a limit shrinks below it.
#[test]
fn the_printed_rule_turns_a_bristle_over_at_an_event() {
    let mut bench = Bench::for_model_exchange("Liang", &[("normal_force", 10.0), ("variant", 2.0)]);
    let carries = |bench: &mut Bench, expected: [f64; 2]| {
        let [x, y] = [bench.get("friction_force_x"), bench.get("friction_force_y")];
        assert!((x - expected[0]).abs() < 1e-12 && (y - expected[1]).abs() < 1e-12, "{x} {y}, not {expected:?}");
    };
    put_bristle(&mut bench, [3e-2, 0.0], [0.6, 0.8], 10.0);
    bench.instance.at_event().expect("an event");
    assert_eq!(bench.get("motion"), 5.0);
    carries(&mut bench, [1.0, 0.0]);
    put_bristle(&mut bench, [3e-2, 4e-2], [1.0, 0.0], 10.0);
    carries(&mut bench, [0.6, 0.8]);
    assert_eq!(due(&bench), [false; 3]);
    let rates = bristle_rates(&bench);
    assert!((rates[0] + 0.04).abs() < 1e-12 && (rates[1] - 0.08).abs() < 1e-12, "{rates:?}");
    // Past a reversal it has its direction until the event, which bonds it.
    put_bristle(&mut bench, [-2e-3, 0.0], [1.0, 0.0], 10.0);
    carries(&mut bench, [1.0, 0.0]);
    assert_eq!(due(&bench), [true, false, false]);
    bench.instance.at_event().expect("an event");
    assert_eq!(bench.get("motion"), 4.0);
    bench.set("normal_force", 9.0);
    assert_eq!(due(&bench), [true, false, false]);
    bench.instance.at_event().expect("an event");
    assert_eq!(bench.get("motion"), 5.0);
    carries(&mut bench, [-0.9, 0.0]);
    // At rest it is shortened.
    put_bristle(&mut bench, [0.0, 0.0], [-0.9, 0.0], 5.0);
    bench.instance.at_event().expect("an event");
    assert_eq!(bench.get("motion"), 2.0);
    carries(&mut bench, [-0.75, 0.0]);
}

/// A bonded bristle at rest follows a plane that turns about y at w = 10 rad/s, and loses w^2 of it per second in the
/// 0.1 ms by which it lags, as its page says: 0.1 % in 0.1 s.
#[test]
fn a_bonded_bristle_follows_a_plane_that_turns() {
    const H: f64 = 2e-6;
    let mut bench = Bench::for_model_exchange("Liang", &[("normal_force", 10.0)]);
    put_bristle(&mut bench, [0.0, 0.0], [0.5, 0.3], 10.0);
    bench.instance.at_event().expect("an event");
    for step in 0..50_000 {
        let angle = 10.0 * H * (f64::from(step) + 0.5);
        bench.set("normal_x", angle.sin());
        bench.set("normal_z", angle.cos());
        for (name, rate) in IN_SPACE[0].into_iter().zip(bristle_rates(&bench)) {
            let moved = bench.get(name) + H * rate;
            bench.set(name, moved);
        }
    }
    let [x, y, z] = IN_SPACE[1].map(|name| bench.get(name));
    let [along, normal] = [x * 1f64.cos() - z * 1f64.sin(), x * 1f64.sin() + z * 1f64.cos()];
    assert!((y - 0.3).abs() < 1e-9 && normal.abs() < 1e-5, "{y} {normal}");
    assert_abs_diff_eq!((0.5 - along) / 0.5, 1e-3, epsilon = 3e-5);
}

/// A contact with levels of 1.5 N forward and 4 N backward, by hand: held between -4 and 1.5 N until the event at either
/// end, and each direction that it slides in comes to rest, or goes on, by its own level.
#[test]
fn a_contact_that_differs_by_direction_is_held_between_both_levels() {
    let levels = [("mu_k_forward", 0.1), ("mu_s_forward", 0.15), ("mu_k_backward", 0.2), ("mu_s_backward", 0.4)];
    let mut bench =
        Bench::for_model_exchange("DirectionalStribeck", &[&[("normal_force", 10.0)], &levels[..]].concat());
    for load in [1.499, 0.2, -1.6, -3.999] {
        bench.set("velocity", 0.0);
        bench.set("external_force", load);
        bench.instance.at_event().expect("an event");
        assert_eq!((bench.get("sticking"), bench.get("friction_force")), (1.0, load));
        for (end, is_due) in [(1.5 - 1e-7, false), (1.5 + 1e-7, true), (1e-7 - 4.0, false), (-1e-7 - 4.0, true)] {
            bench.set("external_force", end);
            assert_eq!(due(&bench)[0], is_due, "{load} {end}");
            assert_eq!(bench.get("friction_force"), end, "held until the event");
        }
    }
    for (load, level) in [(1.6, 1.5), (-4.1, -4.0)] {
        bench.set("velocity", 0.0);
        bench.set("external_force", load);
        bench.instance.at_event().expect("an event");
        assert_eq!((bench.get("sticking"), bench.get("friction_force")), (0.0, level), "{load}");
        assert!(!due(&bench)[0], "{load}");
    }
    // Past its rest: caught by the level of its load, or sent back beyond it.
    for (velocity, load, phase) in [(1e-3, -3.9, 2.0), (1e-3, -4.1, 4.0), (-1e-3, 1.4, 2.0), (-1e-3, 1.6, 3.0)] {
        bench.set("velocity", velocity);
        bench.set("external_force", load);
        bench.instance.at_event().expect("an event");
        bench.set("velocity", -1e-8 * velocity.signum());
        assert!(due(&bench)[0], "{velocity} {load}");
        bench.instance.at_event().expect("an event");
        assert_eq!(bench.get("phase"), phase, "{velocity} {load}");
    }
}
