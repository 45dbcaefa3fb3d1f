//! Systems against closed forms and published figures.

use stribeck::catalogue::{Family, documented};
use stribeck::numerics::root::bisect;

use super::*;
use crate::solve::{End, Equations, Grid, Method, Options, Recorder, Statistics, solve};
use crate::stick_slip::{BELT, StickSlip};

/// The belt with a law: statistics, and the recorded motion (time, position of the block).
pub(super) fn belt(law: &str, tolerance: f64) -> (Statistics, Vec<(f64, f64)>) {
    belt_with(law, &[], tolerance)
}

/// The same with settings.
pub(super) fn belt_with(law: &str, settings: &[(&str, f64)], tolerance: f64) -> (Statistics, Vec<(f64, f64)>) {
    let setting = |(name, value): &(&str, f64)| Setting { name: (*name).to_owned(), value: value.to_string() };
    let settings: Vec<Setting> = settings.iter().map(setting).collect();
    let source = Source::open("belt").unwrap();
    let system = System::assemble(&source, Some(law), &settings).unwrap();
    let mut motion = Motion::new(&system, &[]).unwrap();
    let position = motion.places().iter().position(|place| *place == system.place("rig.position").unwrap()).unwrap();
    let (mut states, until) = (motion.start(), 40.0);
    let mut recorder = Recorder::new(Grid { begin: 0.0, end: until, intervals: 40_000 }, &motion);
    let (end, statistics) =
        solve(Method::Rodas5P, &mut motion, &mut states, &Options::new(until, tolerance), &mut recorder);
    assert_eq!(end, End::Reached, "{law} {statistics:?}");
    (statistics, recorder.times().zip(recorder.states[position].iter().copied()).collect())
}

#[test]
fn stick_slip_is_that_of_the_closed_form() {
    let exact = StickSlip::table_6_1();
    let (statistics, motion) = belt("CoulombStiction", 1e-12);
    let times: Vec<f64> = statistics.events.iter().map(|event| event.time).collect();
    assert_eq!(times.len(), 9, "{times:?}");
    let slips = (0..).map(|cycle| exact.first_slip + f64::from(cycle) * exact.period);
    let expected = slips.flat_map(|slip| [slip, slip + exact.slip]);
    for (time, expected) in times.iter().zip(expected) {
        assert!((time - expected).abs() < 1e-9, "{time} instead of {expected}");
    }
    let error = motion.iter().map(|(time, x)| (x - exact.position(*time)).abs()).fold(0.0, f64::max);
    assert!(error < 1e-10, "{error:e}");
}

/// In the band of Karnopp's law the block still moves under f_e - f_s; the block leaves the band at
/// w tau = arccos(1 - v_0 / v_b). With linear stiction it is m x'' + c x' + k x = c v_b inside the band, c = f_s / v_0:
/// it leaves at 7.39520735382 s.
#[test]
fn first_slips_of_laws_with_a_band_are_those_of_their_closed_forms() {
    let exact = StickSlip::table_6_1();
    let (statistics, _) = belt("Karnopp", 1e-12);
    let leaves = exact.first_slip + (1.0f64 - 1e-3 / BELT).acos() / exact.w;
    let times: Vec<f64> = statistics.events.iter().take(2).map(|event| event.time).collect();
    assert!((times[0] - exact.first_slip).abs() < 1e-10 && (times[1] - leaves).abs() < 1e-10, "{times:?} {leaves}");
    let (statistics, _) = belt("LinearStiction", 1e-12);
    assert!((statistics.events[0].time - 7.395_207_353_82).abs() < 1e-10, "{:?}", statistics.events[0]);
}

/// Position and velocity of the block, from where it is, after a time t under a constant friction force.
fn swung([x, v]: [f64; 2], friction: f64, t: f64) -> [f64; 2] {
    let (w, middle) = (2f64.sqrt(), -0.5 * friction);
    let ((sine, cosine), out) = ((w * t).sin_cos(), x - middle);
    [middle + out * cosine + v / w * sine, v * cosine - out * w * sine]
}

/// The exact motion with Karnopp's law in pieces: the time at which each begins, position and velocity there, and the
/// friction force; none where the block is held and moves as fast as it entered the band.
fn pieces_of_karnopp() -> Vec<(f64, [f64; 2], Option<f64>)> {
    let [kinetic, breakaway, edge] = [0.981, 1.4715, 1e-3];
    let (mut time, mut state) = (0.0, [0.0, BELT]);
    let mut pieces = Vec::new();
    while time < 40.0 {
        pieces.push((time, state, None));
        let held = (0.5 * breakaway - state[0]) / state[1];
        (time, state) = (time + held, [state[0] + state[1] * held, state[1]]);
        // The spring pulls it out of the band, and out of the way, until it is as fast as the belt again.
        for (friction, longest, leaves) in [(-breakaway, 0.5, true), (-kinetic, 4.0, false)] {
            pieces.push((time, state, Some(friction)));
            let beyond = |t: f64| BELT - swung(state, friction, t)[1] - edge;
            let begin = if leaves { 0.0 } else { 1.0 };
            let end = bisect(|t| if leaves { beyond(t) } else { -beyond(t) }, begin, longest);
            (time, state) = (time + end, swung(state, friction, end));
        }
    }
    pieces
}

/// The largest error of Karnopp's motion is that of its events, 3 um at any tolerance.
#[test]
fn karnopp_is_off_by_the_width_of_its_events() {
    let pieces = pieces_of_karnopp();
    let exact = |time: f64| {
        let (from, state, friction) = pieces.iter().rfind(|piece| piece.0 <= time).expect("a piece");
        let held = state[0] + state[1] * (time - from);
        friction.map_or(held, |friction| swung(*state, friction, time - from)[0])
    };
    for tolerance in [1e-8, 1e-12] {
        let (_, motion) = belt("Karnopp", tolerance);
        let error = motion.iter().map(|(time, x)| (x - exact(*time)).abs()).fold(0.0, f64::max);
        assert!((2.5e-6..3.5e-6).contains(&error), "{tolerance}: {error} m");
    }
}

/// First maximum, position at the end: computed with LSODA (static laws), Radau and LSODA (dynamic laws) at 1e-10 by
/// another program from the printed equations.
#[test]
fn motions_are_those_of_an_independent_solver() {
    for (law, maximum, last) in [
        ("Hollars", 0.747_052, 0.238_553),
        ("LinearStiction", 0.746_220, 0.236_488),
        ("BrownMcPhee", 0.750_661, 0.266_749),
        ("ThrelfallModified", 0.560_506, 0.447_956),
        ("Dahl", 0.560_941, 0.448_751),
        ("LuGre", 0.739_936, 0.463_150),
    ] {
        let (_, motion) = belt(law, 1e-10);
        let first = motion.windows(2).find(|pair| pair[1].1 < pair[0].1).unwrap()[0].1;
        assert!((first - maximum).abs() < 1.5e-6, "{law}: first maximum {first}");
        let end = motion.last().unwrap().1;
        assert!((end - last).abs() < 1.5e-6, "{law}: {end} at the end");
    }
}

/// The block comes near the kink of this law once a period and turns back at once; where such an event was missed, the end
/// was off by 2e-6 m.
#[test]
fn kinks_that_are_only_touched_are_not_missed() {
    let ends = [1e-8, 1e-9, 1e-10, 1e-11].map(|tolerance| {
        let (statistics, motion) = belt("ThrelfallModified", tolerance);
        (statistics.events.len(), motion.last().unwrap().1)
    });
    for (events, end) in ends {
        assert!(events == ends[0].0 && (end - ends[3].1).abs() < 5e-8, "{ends:?}");
    }
}

/// Whether the Jacobian of the belt with a law is the same at all velocities between which no event indicator changes its
/// sign.
fn is_made_of_straight_lines(system: &System) -> bool {
    let mut branches: Vec<(Vec<bool>, [f64; 4])> = Vec::new();
    for number in 0..240 {
        let speed = 10f64.powf(-5.5 + 5.0 * (0.5 + f64::from(number / 2)) / 120.0);
        let velocity = if number % 2 == 0 { speed } else { -speed };
        let mut motion = Motion::new(system, &[]).unwrap();
        let mut states = [0.3 + 1e-3 * f64::from(number), BELT + velocity];
        motion.at_event(0.0, &mut states).unwrap();
        let mut indicators = vec![0.0; motion.indicators()];
        motion.indicate(0.0, &states, &mut indicators);
        let (mut rates, mut jacobian, mut by_time) = ([0.0; 2], [0.0; 4], [0.0; 2]);
        motion.rates(0.0, &states, &mut rates);
        motion.jacobian(0.0, &states, &mut jacobian, &mut by_time);
        let mut branch: Vec<bool> = indicators.iter().map(|indicator| *indicator > 0.0).collect();
        branch.push(velocity > 0.0);
        match branches.iter().find(|(known, _)| *known == branch) {
            None => branches.push((branch, jacobian)),
            Some((_, known)) => {
                if known.iter().zip(&jacobian).any(|(a, b)| (a - b).abs() > 1e-9 * a.abs().max(1.0)) {
                    return false;
                }
            }
        }
    }
    true
}

/// Of the laws without further states, those whose curves are made of straight lines, and no others, say so. Of the
/// others a bond that breaks and elements that stick and slip do; their closed forms are above.
#[test]
fn laws_made_of_straight_lines_say_so() {
    let source = Source::open("belt").unwrap();
    let (mut counts, mut wrong, mut bonds) = ([0; 2], Vec::new(), Vec::new());
    for (law, _) in documented(Family::Friction) {
        let system = System::assemble(&source, Some(law.name), &[]).unwrap();
        let Ok(motion) = Motion::new(&system, &[]) else { continue };
        // The past is a memory in place of states.
        if motion.places().len() == 2 && !motion.has_past() {
            if is_made_of_straight_lines(&system) != motion.is_piecewise_linear() {
                wrong.push(law.name);
            }
            counts[usize::from(motion.is_piecewise_linear())] += 1;
        } else if motion.is_piecewise_linear() {
            bonds.push(law.name);
        }
    }
    assert_eq!(bonds, ["ResetIntegrator", "MaxwellSlip"], "springs have straight lines, too");
    assert!(wrong.is_empty() && counts[0] > 5 && counts[1] > 5, "{counts:?} {wrong:?}");
}

fn refused(text: &str) -> String {
    let description = match Description::parse(text) {
        Ok(description) => description,
        Err(fault) => return fault.to_string(),
    };
    let source = Source { description, folder: std::path::PathBuf::new() };
    match System::assemble(&source, None, &[]).and_then(|system| Motion::new(&system, &[]).map(|_| ())) {
        Ok(()) => "accepted".to_owned(),
        Err(fault) => fault.to_string(),
    }
}

const BELT_TOML: &str = BUILT_IN[0].1;

#[test]
fn mistakes_in_a_file_are_named() {
    assert_eq!(refused(BELT_TOML), "accepted");
    for (from, to, expected) in [
        ("\"BeltRig\"", "\"BeltRg\"", "model 'BeltRg' does not exist (did you mean 'BeltRig'?)"),
        (
            "\"rig.velocity\"",
            "\"rig.velocty\"",
            "variable of rig (BeltRig) 'velocty' does not exist (did you mean 'velocity'?)",
        ),
        (
            "= \"rig.velocity\"",
            "= \"rig.position\"",
            "friction.velocity [m/s] cannot be connected to rig.position [m]: the units differ",
        ),
        (
            "\"friction.velocity\" = \"rig.velocity\"\n",
            "",
            "friction.velocity is open: it needs a connection or a signal",
        ),
        ("until = 40.0", "until = nan", "until = NaN s: must be > 0 and finite"),
        ("every = 0.01", "every = -0.01", "every = -0.01 s: must be > 0 and finite"),
        ("\"CoulombStiction\"", "\"BeltRig\"", "friction law 'BeltRig' does not exist"),
    ] {
        assert!(BELT_TOML.contains(from), "{from}");
        assert_eq!(refused(&BELT_TOML.replacen(from, to, 1)), expected);
    }
}

/// Two contacts at rest, each loaded by the force of the other one.
const LOOP_TOML: &str = r#"
title = "Two contacts that load each other"
until = 1.0
every = 0.1
part.left.model = "CoulombStiction"
part.right.model = "CoulombStiction"
[connect]
"left.external_force" = "right.friction_force"
"right.external_force" = "left.friction_force"
[input]
"left.velocity" = 0.0
"left.normal_force" = 10.0
"right.velocity" = 0.0
"right.normal_force" = 10.0
"#;

#[test]
fn outputs_that_depend_on_each_other_are_named() {
    let names = "right.friction_force, left.friction_force";
    assert_eq!(
        refused(LOOP_TOML),
        format!("{names} depend on each other at one instant: such a loop cannot be solved")
    );
    let opened = LOOP_TOML.replace("\"right.external_force\" = \"left.friction_force\"\n", "");
    assert_eq!(refused(&opened), "right.external_force is open: it needs a connection or a signal");
}

/// Central differences of the rates by each state, in units of its size, and by time.
fn differences(motion: &mut Motion, time: f64, states: &[f64]) -> Vec<Vec<f64>> {
    let (step, scales) = (1e-6, motion.scales().to_vec());
    let mut beside = |column: usize, h: f64| {
        let (mut states, mut rates) = (states.to_vec(), vec![0.0; scales.len()]);
        let later = if let Some(state) = states.get_mut(column) {
            *state += h * scales[column];
            0.0
        } else {
            h
        };
        motion.rates(time + later, &states, &mut rates);
        rates
    };
    let mut column = |column: usize| {
        let [after, before] = [step, -step].map(|h| beside(column, h));
        after.iter().zip(before).map(|(after, before)| (after - before) / (2.0 * step)).collect()
    };
    (0..=states.len()).map(&mut column).collect()
}

/// Rates and Jacobian at once beside the rates alone and their differences, with more states than a gradient has directions
/// and with signals that move.
#[test]
fn jacobians_agree_with_central_differences() {
    let mut compared = 0;
    for (name, law) in [("belt", "LuGre"), ("belt", "Threlfall"), ("belt-drive", "Dahl"), ("quarter-car", "Coulomb")] {
        let system = System::assemble(&Source::open(name).unwrap(), Some(law), &[]).unwrap();
        let mut motion = Motion::new(&system, &[]).unwrap();
        let (time, mut states, scales) = (0.37, motion.start(), motion.scales().to_vec());
        motion.at_event(time, &mut states).unwrap();
        states.iter_mut().zip(&scales).enumerate().for_each(|(i, (x, scale))| *x += scale * (0.11 + 0.07 * i as f64));
        let count = states.len();
        let [mut alone, mut rates, mut by_time] = [(); 3].map(|()| vec![f64::NAN; count]);
        let mut jacobian = vec![f64::NAN; count * count];
        motion.rates(time, &states, &mut alone);
        motion.linearise(time, &states, &mut rates, &mut jacobian, &mut by_time);
        assert_eq!(rates, alone, "{name} {law}");
        let differences = differences(&mut motion, time, &states);
        for i in 0..count {
            let of_state = jacobian[i * count..][..count].iter().zip(&scales).map(|(slope, scale)| slope * scale);
            let found: Vec<f64> = of_state.chain([by_time[i]]).collect();
            let size = found.iter().fold(0.0, |size: f64, slope| size.max(slope.abs()));
            for (found, column) in found.iter().zip(&differences) {
                assert!((found - column[i]).abs() <= 1e-6 * size, "{name} {law} {i}: {found} {}", column[i]);
                compared += usize::from(*found != 0.0);
            }
        }
    }
    assert!(compared > 20, "{compared}");
}

#[test]
fn every_built_in_system_is_accepted_with_its_own_law() {
    for (name, _) in BUILT_IN {
        let source = Source::open(name).unwrap();
        let system = System::assemble(&source, None, &[]).unwrap_or_else(|fault| panic!("{name}: {fault}"));
        Motion::new(&system, &[]).unwrap_or_else(|fault| panic!("{name}: {fault}"));
        for show in source.description.show.values() {
            system.source(show).unwrap_or_else(|fault| panic!("{name}: {fault}"));
        }
    }
}

/// Laws find all their inputs in each system with a place for a law, but for the acceleration of a contact whose bodies
/// both accelerate. A strut has its own list: it offers no law in a plane or of rolling.
#[test]
fn every_law_runs_in_every_system() {
    let mut open = Vec::new();
    for (name, _) in BUILT_IN {
        let source = Source::open(name).unwrap();
        if !source.description.takes_laws() {
            assert_eq!(*name, "servo-pendulum");
            continue;
        }
        let offers_all = source.description.choose_law.is_empty();
        for (law, _) in stribeck::catalogue::documented(stribeck::catalogue::Family::Friction) {
            match System::assemble(&source, Some(law.name), &[]) {
                Ok(_) => {}
                Err(Fault::Open { input }) => open.push(format!("{name} {} {input}", law.name)),
                Err(fault) if offers_all => panic!("{name} {}: {fault}", law.name),
                Err(fault) => assert!(fault.to_string().contains("choice of friction.model"), "{name}: {fault}"),
            }
        }
    }
    open.sort();
    let expected = ["four-post NonReversible strut_fl.acceleration", "four-post Wojewoda strut_fl.acceleration"];
    assert_eq!(open, expected);
}

/// A balance of forces without the force of the bodies around the contact would slide on the wrong curve.
#[test]
fn a_balance_of_forces_needs_its_force() {
    let assembled = |name: &str, law: &str| {
        let balance = [Setting { name: "friction.acceleration_source".into(), value: "Balance".into() }];
        System::assemble(&Source::open(name).unwrap(), Some(law), &balance)
    };
    for law in ["NonReversible", "Wojewoda"] {
        for (name, input) in [("dyno", "strut"), ("motion", "friction")] {
            let fault = assembled(name, law).err().unwrap().to_string();
            assert!(fault.starts_with(&format!("{input}.external_force is held at 0, but with")), "{name}: {fault}");
        }
        assert!(assembled("belt", law).is_ok() && assembled("quarter-car", law).is_ok());
    }
    assert!(assembled("quarter-car", "LuGre").is_ok());
}

/// A built-in system with a law and settings, solved; the recorded values of some results at each output time.
pub(super) fn solved(
    name: &str,
    law: &str,
    settings: &[(&str, &str)],
    tolerance: f64,
    results: &[&str],
) -> crate::run::Outcome {
    let settings: Vec<Setting> =
        settings.iter().map(|(name, value)| Setting { name: (*name).to_owned(), value: (*value).to_owned() }).collect();
    let system = System::assemble(&Source::open(name).unwrap(), Some(law), &settings).unwrap();
    let settings = crate::run::Settings { tolerance, ..crate::run::Settings::of(&system) };
    let results: Vec<String> = results.iter().map(|name| (*name).to_owned()).collect();
    let outcome = crate::run::run(&system, &settings, &results).unwrap();
    assert!(outcome.is_reached(), "{name} {law}: {}", outcome.end);
    outcome
}

/// With ramps the velocity is +-4 A f, and the length straight between its ends; with a sine a = -w^2 (d - mean).
#[test]
fn signals_of_a_dyno_move_as_they_are_set() {
    let settings = [("strut.length.amplitude", "0.01"), ("strut.length.frequency", "2.5")];
    let results = ["strut.length", "strut.velocity", "strut.acceleration"];
    let ramps = solved("dyno-ramps", "LuGre", &settings, 1e-8, &results);
    for (at, time) in ramps.time.iter().enumerate() {
        let [length, velocity, acceleration] = [0, 1, 2].map(|column| ramps.columns[column].values[at]);
        // An arcsine of a sine is a triangle.
        let turn = (std::f64::consts::TAU * 2.5 * time).sin().asin() / std::f64::consts::FRAC_PI_2;
        assert!((length - 0.175 - 0.01 * turn).abs() < 1e-9, "{length} m at {time} s");
        assert!((velocity.abs() - 0.1).abs() < 1e-12 && acceleration == 0.0, "{velocity} m/s at {time} s");
    }
    let sine = solved("dyno", "LuGre", &settings, 1e-8, &results);
    for (at, time) in sine.time.iter().enumerate() {
        let [length, velocity, acceleration] = [0, 1, 2].map(|column| sine.columns[column].values[at]);
        let omega = std::f64::consts::TAU * 2.5;
        assert!((velocity - 0.01 * omega * (omega * time).cos()).abs() < 1e-12, "{velocity} m/s at {time} s");
        assert!((acceleration + omega * omega * (length - 0.175)).abs() < 1e-10, "{acceleration} m/s2 at {time} s");
    }
}

/// A belt in mm/s over ms, as a logger wrote it, and the same points.
#[test]
fn signals_of_files_have_the_units_of_their_headings() {
    let folder = tempfile::tempdir().unwrap();
    let system = |course: &str, file: &str| {
        std::fs::write(folder.path().join("belt.csv"), file).unwrap();
        let (ramp, path) = ("{ ramp = { rate = 0.01, to = 0.2 } }", folder.path().join("drive.toml"));
        let text = include_str!("built_in/belt-drive.toml");
        assert!(text.contains(ramp));
        std::fs::write(&path, text.replace(ramp, course)).unwrap();
        System::assemble(&Source::open(path.to_str().unwrap()).unwrap(), Some("LuGre"), &[])
    };
    let signal = |system: System| system.signals.into_iter().map(|(_, signal)| signal).find(|one| one.at(0.5).1 != 0.0);
    let csv = "{ csv = { file = \"belt.csv\", column = \"belt\" } }";
    let read = system(csv, "\u{feff}% a log\r\ntime (ms);belt [mm/s]\r\n0;0,5\r\n2000;20,5\r\n").unwrap();
    let points = system("{ points = { time = [0.0, 2.0], value = [0.0005, 0.0205] } }", "").unwrap();
    assert_eq!(signal(read), signal(points));
    for (file, expected) in [
        ("time,belt\n0,0\n1,nan\n", "line 3, belt: 'nan' is not a finite number"),
        ("time,belt [N]\n0,0\n", "belt: unit 'N', must be one of m/s, mm/s, in/s, km/h, kph, mph"),
        ("time,drum\n0,0\n", "no column 'belt'; there are time, drum"),
        ("time,belt\n", "the table has no rows"),
    ] {
        let refusal = system(csv, file).unwrap_err().to_string();
        assert!(refusal.contains("belt.csv: ") && refusal.ends_with(expected), "{refusal}");
    }
}

#[test]
fn properties_that_a_signal_does_not_have_are_refused() {
    let refused = |name: &str, value: &str| {
        let setting = Setting { name: name.into(), value: value.into() };
        System::assemble(&Source::open("dyno").unwrap(), None, &[setting]).map(|_| ()).unwrap_err().to_string()
    };
    assert_eq!(
        refused("strut.length.ampl", "1"),
        "property of the signal strut.length 'ampl' does not exist (did you mean 'amplitude'?)"
    );
    assert_eq!(refused("strut.length.amplitude", "wide"), "strut.length.amplitude = wide: must be a number");
    assert!(refused("strut.length.frequency", "inf").ends_with("inf in a signal: must be a finite number"));
}

/// The blocks keep their momentum m_1 v_1 + m_2 v_2, and the energy that they lose is dissipated in the contact.
#[test]
fn two_blocks_conserve_momentum_and_close_their_energy_balance() {
    for law in ["CoulombStiction", "LinearStiction", "BrownMcPhee", "LuGre", "Wojewoda"] {
        let results = ["blocks.velocity_1", "blocks.velocity_2", "friction.dissipated_energy"];
        let outcome = solved("two-blocks", law, &[], 1e-12, &results);
        let [v_1, v_2, lost] = results.map(|name| outcome.values(name).unwrap());
        for row in 0..outcome.time.len() {
            let momentum = v_1[row] + 2.0 * v_2[row];
            assert!((momentum - 1.0).abs() < 1e-12, "{law}: momentum {momentum}");
        }
        let last = outcome.time.len() - 1;
        let kinetic = 0.5 * v_1[last].powi(2) + v_2[last].powi(2);
        assert!((0.5 - kinetic - lost[last]).abs() < 1e-8, "{law}: {kinetic} {}", lost[last]);
    }
}

/// tan(alpha) = mu_s at the first slip, 8.5308 degrees; at tan(alpha) = mu_k a sliding block keeps its velocity.
#[test]
fn a_block_on_an_incline_slides_from_the_angle_of_friction_on() {
    let outcome = solved("incline", "CoulombStiction", &[], 1e-10, &["plane.velocity"]);
    let angle = (0.01 * outcome.events[0].time).to_degrees();
    assert!((angle - 0.15f64.atan().to_degrees()).abs() < 1e-6, "{angle}");
    let kinetic = 0.1f64.atan();
    for (offset, direction) in [(-1e-6f64, -1.0), (0.0, 0.0), (1e-6, 1.0)] {
        let angle = (kinetic + offset.to_radians()).to_string();
        let settings = [("plane.angle", angle.as_str()), ("plane.velocity", "0.5")];
        let outcome = solved("incline", "CoulombStiction", &settings, 1e-10, &["plane.velocity"]);
        let change = outcome.values("plane.velocity").unwrap().last().unwrap() - 0.5;
        let expected = direction * 1e-6f64.to_radians() * 9.81 * 1.01 / (1.01f64).sqrt() * 20.0;
        assert!((change - expected).abs() < 1e-8, "{offset}: {change} {expected}");
    }
}

/// A constant force on an axis: v = (F - b - f_C) / f_v (1 - exp(-f_v t / M)); a force within friction moves nothing.
#[test]
fn axis_approaches_its_speed_exponentially() {
    let law = [("mu_k", "20.3935"), ("viscous_coefficient", "203.5034")];
    let speed = |force: &str| {
        let settings = [&[("axis.drive_force", force)], &law[..]].concat();
        let outcome = solved("axis", "CoulombViscous", &settings, 1e-10, &["axis.velocity"]);
        *outcome.values("axis.velocity").unwrap().last().unwrap()
    };
    let expected = (60.0 + 3.1648 - 20.3935) / 203.5034 * (1.0 - f64::exp(-203.5034 * 10.0 / 95.1089));
    assert!((speed("60") - expected).abs() < 1e-8 * expected, "{} {expected}", speed("60"));
    assert_eq!(speed("17"), 0.0);
}

/// Largest friction force while the spring pulls the mass off the ground, with LuGre's law.
fn breakaway(pull: f64, rows: f64, tolerance: f64) -> f64 {
    let source = Source::open("pulled-mass").unwrap();
    let setting = Setting { name: "mass.pull_velocity".to_owned(), value: pull.to_string() };
    let system = System::assemble(&source, Some("LuGre"), &[setting]).unwrap();
    // The spring of 2 N/m reaches twice the static level.
    let until = 1.4715 / pull;
    let settings = crate::run::Settings { tolerance, until, every: until / rows, ..crate::run::Settings::of(&system) };
    let outcome = crate::run::run(&system, &settings, &["friction.friction_force".to_owned()]).unwrap();
    assert!(outcome.is_reached(), "{}", outcome.end);
    outcome.columns[0].values.iter().copied().fold(0.0, f64::max)
}

/// The faster the force grows, the lower the force at breakaway: from the static level down towards the Coulomb level
/// (Canudas de Wit, Olsson, Astrom and Lischinsky, 1995, Fig. 4).
#[test]
fn breakaway_of_lugre_falls_with_the_rate_of_the_force() {
    let pulls = [0.002, 0.01, 0.05, 0.2, 1.0, 5.0, 20.0];
    let forces = pulls.map(|pull| {
        let force = breakaway(pull, 2e4, 1e-8);
        let converged = breakaway(pull, 8e4, 1e-11);
        assert!((force / converged - 1.0).abs() < 1e-4, "{pull} m/s: {force} {converged}");
        force
    });
    assert!(forces.windows(2).all(|pair| pair[0] > pair[1]), "{forces:?}");
    let [static_level, coulomb_level] = [1.4715, 0.981];
    assert!(forces[0] < static_level && forces[0] > 0.99 * static_level, "{forces:?}");
    assert!(forces[6] > coulomb_level && forces[6] < 1.1 * coulomb_level, "{forces:?}");
}
