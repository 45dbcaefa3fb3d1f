//! Inputs that move within a step: contacts that hold a mass, in the strut and in a guide.

use crate::common::random::Random;
use crate::common::{Bench, Exchange, holding_laws, laws_of_strut};
use stribeck::catalogue;
use stribeck::model::{Kind, Meaning, ModelType, Role};

const MASS: f64 = 20.0;
const STEP: f64 = 1e-3;

/// Sets the friction law by its name.
fn choose(bench: &mut Bench, law: &str) {
    let column = bench.column("friction.model");
    let Kind::Enumeration(laws) = bench.instance.model().table.at(column).kind else { panic!("a choice") };
    let number = laws.items.iter().position(|item| item.name == law).expect("a law");
    bench.instance.set_column(column, number as f64 + 1.0).unwrap();
}

/// Force on a body besides friction: 15 N that swing by 5 N, twice a second. Breakaway is at 30 N.
fn load(time: f64) -> f64 {
    15.0 + 5.0 * f64::sin(4.0 * std::f64::consts::PI * time)
}

fn load_rate(time: f64) -> f64 {
    20.0 * std::f64::consts::PI * f64::cos(4.0 * std::f64::consts::PI * time)
}

/// Drives a body of 20 kg at 20 mm/s on nothing but the friction of `model`, which holds it in the end. `feel` tells the
/// model position, velocity, acceleration as the host knows it, and time. Returns the largest speed and the largest
/// second difference of the force once the body is held.
fn hold(
    bench: &mut Bench,
    exchange: Exchange,
    feel: impl Fn(&mut Bench, [f64; 4]),
    force: impl Fn(&mut Bench) -> f64,
) -> [f64; 2] {
    let (mut x, mut v, mut friction) = (0.0, 0.02, [0.0; 3]);
    let (mut speed, mut jump) = (0f64, 0f64);
    for k in 0..2000 {
        let time = f64::from(k) * STEP;
        let mut now = friction[2];
        if exchange == Exchange::Parallel {
            now = force(bench);
        }
        let acceleration = (load(time) - friction[2]) / MASS;
        feel(bench, [x, v, acceleration, time]);
        bench.step(STEP);
        if exchange == Exchange::Sequential {
            now = force(bench);
        }
        friction = [friction[1], friction[2], now];
        if k > 500 {
            speed = speed.max(v.abs());
            jump = jump.max((friction[2] - 2.0 * friction[1] + friction[0]).abs());
        }
        // The mean of the load over the step, so that what is left is the doing of the friction.
        let mean = 0.5 * (load(time) + load(time + STEP));
        x += STEP * (v + 0.5 * STEP * (mean - now) / MASS);
        v += STEP * (mean - now) / MASS;
    }
    [speed, jump]
}

fn slope(bench: &mut Bench, name: &str, slope: f64) {
    let column = bench.column(name);
    bench.instance.set_slope(column, slope).unwrap();
}

/// Laws of sliding that know the mass of the body: those of a strut.
fn laws_with_mass() -> impl Iterator<Item = &'static str> {
    laws_of_strut().filter(|law| law.table.of(Meaning::Mass).is_some()).map(|law| law.name)
}

/// Those that hold the body at rest.
fn holding_laws_of_strut() -> impl Iterator<Item = &'static str> {
    holding_laws().filter(|name| laws_of_strut().any(|law| law.name == *name))
}

/// Friction alone of a strut: levels of 10 N and 14 N kinetic, 12 N and 18 N static.
fn strut(law: &str, exchange: Exchange) -> Bench {
    let mut strut = Bench::new("ShockAbsorber", &[]);
    let zero = [
        "spring.k",
        "spring.preload",
        "gas.enabled",
        "bump.k",
        "bump.c",
        "rebound.k",
        "damper.c_comp",
        "damper.c_reb",
        "side.offset_m",
        "c1.mu_s",
        "c1.mu_k",
        "c2.mu_s",
        "c2.mu_k",
    ];
    let levels = [("c1.preload_s", 12.0), ("c1.preload_k", 10.0), ("c2.preload_s", 18.0), ("c2.preload_k", 14.0)];
    for (name, value) in zero.map(|name| (name, 0.0)).into_iter().chain(levels) {
        strut.set(name, value);
    }
    choose(&mut strut, law);
    strut.set("friction.mass", MASS);
    strut.set("friction.viscous_coefficient", 0.0);
    strut.set("friction.exchange", if exchange == Exchange::Parallel { 2.0 } else { 1.0 });
    strut
}

/// The strut with `num.input_mode` = Linear and the acceleration of the host, as its page recommends: what it holds must
/// neither chatter nor jump.
#[test]
fn a_strut_that_knows_the_acceleration_holds_its_mass() {
    for exchange in [Exchange::Sequential, Exchange::Parallel] {
        for law in holding_laws_of_strut() {
            for knows_the_load in [false, true] {
                let mut strut = strut(law, exchange);
                strut.set("num.input_mode", 2.0);
                let feel = |strut: &mut Bench, [x, v, a, time]: [f64; 4]| {
                    strut.set("length", 0.1775 + x);
                    strut.set("velocity", v);
                    strut.set("acceleration", a);
                    strut.set("external_force", load(time));
                    if knows_the_load {
                        slope(strut, "external_force", load_rate(time));
                    }
                };
                let [speed, jump] = hold(&mut strut, exchange, feel, |strut| -strut.get("force"));
                let what = format!("{law} {exchange:?} {knows_the_load}: {speed} m/s, {jump} N");
                // By 0.06 N the load changes in a step, that is 3 um/s if it is not known before.
                assert!(speed < if knows_the_load { 1e-7 } else { 7e-6 } && jump < 2e-3, "{what}");
            }
        }
    }
}

/// The same for a rod in its guide, with slopes of velocity, force and load.
#[test]
fn a_guide_that_knows_the_slopes_holds_its_mass() {
    for exchange in [Exchange::Sequential, Exchange::Parallel] {
        for law in holding_laws_of_strut() {
            let mut guide = Bench::new("GuideContact", &[("levels.preload_s", 0.0), ("levels.preload_k", 0.0)]);
            choose(&mut guide, law);
            guide.set("friction.mass", MASS);
            guide.set("friction.viscous_coefficient", 0.0);
            guide.set("friction.exchange", if exchange == Exchange::Parallel { 2.0 } else { 1.0 });
            let feel = |guide: &mut Bench, [_, v, a, time]: [f64; 4]| {
                guide.set("velocity", v);
                guide.set("normal_force", 300.0 + 20.0 * f64::sin(9.0 * time));
                guide.set("external_force", load(time));
                slope(guide, "velocity", a);
                slope(guide, "normal_force", 180.0 * f64::cos(9.0 * time));
                slope(guide, "external_force", load_rate(time));
            };
            let [speed, jump] = hold(&mut guide, exchange, feel, |guide| guide.get("friction_force"));
            assert!(speed < 1e-7 && jump < 2e-3, "{law} {exchange:?}: {speed} m/s, {jump} N");
        }
    }
}

/// All laws that know a mass, in the strut: a regularised law creeps, but by its own curve and without jumps.
#[test]
fn no_law_jumps_in_a_strut_that_knows_the_acceleration() {
    let mut laws = 0;
    for law in laws_with_mass() {
        for exchange in [Exchange::Sequential, Exchange::Parallel] {
            let mut strut = strut(law, exchange);
            strut.set("num.input_mode", 2.0);
            let feel = |strut: &mut Bench, [x, v, a, time]: [f64; 4]| {
                strut.set("length", 0.1775 + x);
                strut.set("velocity", v);
                strut.set("acceleration", a);
                strut.set("external_force", load(time));
            };
            let [_, jump] = hold(&mut strut, exchange, feel, |strut| -strut.get("force"));
            assert!(jump < 5e-3, "{law} {exchange:?}: {jump} N");
            laws += 1;
        }
    }
    assert!(laws > 30, "{laws}");
}

/// One section of a motion: inputs at its beginning and at its end, and its length.
struct Section {
    from: Vec<(usize, f64)>,
    to: Vec<(usize, f64)>,
    h: f64,
}

/// A random motion: slides of all speeds, reversals, dwells, loads that rise, fall and vanish.
fn motion(bench: &Bench, sections: usize, seed: u64) -> Vec<Section> {
    let model = bench.instance.model();
    let inputs: Vec<usize> = (0..model.table.len()).filter(|c| model.table.at(*c).role == Role::Input).collect();
    let mut random = Random(seed);
    let mut now: Vec<(usize, f64)> = inputs.iter().map(|column| (*column, model.table.at(*column).start)).collect();
    let mut motion = Vec::new();
    for _ in 0..sections {
        let dwells = random.next() < 0.2;
        let keeps_load = random.next() < 0.3;
        let from = now.clone();
        for (column, value) in &mut now {
            let name = model.table.at(*column).path.to_string();
            *value = if name.starts_with("velocity") {
                if dwells { 0.0 } else { random.signed() * 10f64.powf(-4.0 * random.next()) * 0.1 }
            } else if name == "normal_force" {
                if keeps_load { *value } else { 20.0 * (1.2 * random.next() - 0.2).max(0.0) }
            } else if name == "external_force" {
                2.0 * random.signed()
            } else {
                *value
            };
        }
        // Where a law asks for the acceleration, it is that of the velocity.
        let h = 1e-3 * (0.2 + random.next());
        let find = |name: &str| inputs.iter().position(|column| model.table.at(*column).path.to_string() == name);
        if let (Some(velocity), Some(acceleration)) = (find("velocity"), find("acceleration")) {
            now[acceleration].1 = (now[velocity].1 - from[velocity].1) / h;
        }
        motion.push(Section { from, to: now.clone(), h });
    }
    motion
}

/// Which inputs move within a section: an acceleration that is given is that of the velocity.
fn moves(bench: &Bench, column: usize) -> bool {
    bench.instance.model().table.at(column).path.to_string() != "acceleration"
}

/// Makes a section in `pieces` steps whose inputs are held at their values in the middle of each, and leaves them at
/// their ends. A load that rises stays behind by half a piece, or it would let go of what has just slipped.
fn held(bench: &mut Bench, section: &Section, pieces: u32) {
    for piece in 0..pieces {
        let share = (f64::from(piece) + 0.5) / f64::from(pieces);
        for ((column, from), (_, to)) in section.from.iter().zip(&section.to) {
            let value = if moves(bench, *column) { from + share * (to - from) } else { *to };
            bench.instance.set_column(*column, value).unwrap();
        }
        bench.step(section.h / f64::from(pieces));
    }
    for ((column, from), (_, to)) in section.from.iter().zip(&section.to) {
        if bench.column("normal_force") != *column || to < from {
            bench.instance.set_column(*column, *to).unwrap();
        }
    }
}

/// The same with slopes.
fn ramped(bench: &mut Bench, section: &Section, pieces: u32) {
    for piece in 0..pieces {
        for ((column, from), (_, to)) in section.from.iter().zip(&section.to) {
            let at = |piece: u32| from + f64::from(piece) / f64::from(pieces) * (to - from);
            let [value, end] = if moves(bench, *column) { [at(piece), at(piece + 1)] } else { [*to; 2] };
            bench.instance.set_column(*column, value).unwrap();
            bench.instance.set_slope(*column, (end - value) * f64::from(pieces) / section.h).unwrap();
        }
        bench.step(section.h / f64::from(pieces));
    }
}

/// Sum over a random motion of the errors of force and energy that sections have as steps with slopes, divided by
/// `pieces`, beside the largest of the force. From the limit of short steps with held inputs, as far as it is known.
fn errors(bench: &mut Bench, force: &str, pieces: u32) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for section in motion(bench, 60, 3) {
        let begin = bench.instance.save();
        let results = |bench: &mut Bench, make: &dyn Fn(&mut Bench)| {
            bench.instance.restore(&begin);
            make(bench);
            [bench.get(force), bench.get("dissipated_energy")]
        };
        let coarse = results(bench, &|bench| held(bench, &section, 500));
        let fine = results(bench, &|bench| held(bench, &section, 2000));
        let found = results(bench, &|bench| ramped(bench, &section, pieces));
        // Short steps come slowly to their own limit where they meet a kink or a jump.
        let error = |k: usize| ((found[k] - fine[k]).abs() - 2.0 * (coarse[k] - fine[k]).abs()).max(0.0);
        sums = [sums[0] + error(0), sums[1] + error(1), sums[2].max(error(0))];
        results(bench, &|bench| ramped(bench, &section, 8));
    }
    sums
}

/// A step with slopes approaches the limit of ever shorter steps with held inputs, for every law and wherever it starts
/// from: with eight times as many steps the error falls at least sixteenfold. Loads go from nothing to 20 N, and speeds
/// to 0.1 m/s, within a millisecond.
#[test]
fn a_ramp_comes_to_the_limit_of_short_held_steps() {
    let mut laws = 0;
    let is_contact = |model: &&ModelType| matches!(model.find("normal_force"), Some(load) if model.table.at(load).role == Role::Input);
    for model in catalogue::models().filter(is_contact) {
        let mut bench = Bench::new(model.name, &[]);
        let force = if bench.has("friction_force") { "friction_force" } else { "friction_force_x" };
        let one = errors(&mut bench, force, 1);
        bench.instance.reset();
        let eight = errors(&mut bench, force, 8);
        let what = format!("{}: {one:?} in one step, {eight:?} in eight", model.name);
        println!("{what}");
        assert!(one[2] < 0.05, "{what}");
        // The error allowed in a deflection of 10 um, on 1e5 N/m, is half a millinewton; on average over the sections it
        // is a tenth of that, and 10 nJ.
        for (k, allowed) in [(0, 3e-3), (1, 6e-7)] {
            assert!(eight[k] <= one[k] / 16.0 + allowed, "{what}");
        }
        laws += 1;
    }
    assert!(laws > 30, "{laws}");
}

/// The time derivative of a contact's force under a moving load, against a difference along the very run, by laws whose
/// elements follow their strength.
#[test]
fn the_derivative_of_a_guide_is_that_along_its_run() {
    let mut compared = 0;
    for law in ["Leuven", "MaxwellSlip", "LuGre", "Dahl", "ElastoPlastic", "Gonthier", "Dankowicz", "BlimanSorine"] {
        let mut random = Random(17);
        for _ in 0..40 {
            let mut guide = Bench::new("GuideContact", &[]);
            choose(&mut guide, law);
            let (velocity, load) = (1e-3 * random.signed(), 20.0 + 60.0 * random.next());
            let (acceleration, rate) = (0.01 * random.signed(), 200.0 * random.next());
            guide.set("velocity", velocity);
            guide.set("normal_force", load);
            // Some of the way goes into the bristles, some into sliding.
            guide.step(0.1 * random.next());
            let mut go_on = |h: f64| {
                slope(&mut guide, "velocity", acceleration);
                slope(&mut guide, "normal_force", rate);
                guide.step(h);
                let column = guide.column("friction_force");
                (guide.get("friction_force"), guide.instance.time_derivative()[column].slope)
            };
            let h = 1e-6;
            let [(before, _), (_, now), (after, _)] = [go_on(1e-4), go_on(h), go_on(h)];
            let difference = (after - before) / (2.0 * h);
            let error = (difference - now).abs() / (1.0 + now.abs());
            assert!(error < 0.02, "{law} at {velocity} m/s, {load} N: {now} N/s, along the run {difference} N/s");
            compared += 1;
        }
    }
    assert_eq!(compared, 320);
}
