//! Bonds that snap within the steps of a solver, against simulations of their own: snap by snap on the belt, and by the law's
//! own steps along a given motion.

use stribeck::friction::Bristle;
use stribeck::model::{Law, Model};

use super::signal::Course;
use super::{Motion, Setting, Signal, Source, System, WireSource};
use crate::run::Solver;
use crate::solve::{End, Grid, Method, Options, Recorder, solve};

/// Number of bonds with the default parameters.
const BONDS: usize = 25;

/// delta, which equals Delta with the default levels.
const LIMIT: f64 = 1.4715e-5;

/// N sigma.
const STIFFNESS: f64 = 1e5;

fn system(name: &str, settings: &[(&str, &str)], inputs: &[(&str, Course)]) -> System {
    let set = |(name, value): &(&str, &str)| Setting { name: (*name).to_owned(), value: (*value).to_owned() };
    let mut source = Source::open(name).unwrap();
    for (input, course) in inputs {
        source.description.input.insert((*input).to_owned(), Signal::Course(course.clone()));
    }
    System::assemble(&source, Some("Bristle"), &settings.iter().map(set).collect::<Vec<_>>()).unwrap()
}

/// One column per result.
fn run(system: &System, until: f64, intervals: usize, tolerance: f64, recorded: &[String]) -> Vec<Vec<f64>> {
    let sources: Vec<WireSource> = recorded.iter().map(|name| system.source(name).unwrap()).collect();
    let mut motion = Motion::new(system, &sources).unwrap();
    let mut recorder = Recorder::new(Grid { begin: 0.0, end: until, intervals }, &motion);
    let (mut states, options) = (motion.start(), Options::new(until, tolerance));
    let (end, _) = solve(Method::Rodas5P, &mut motion, &mut states, &options, &mut recorder);
    assert_eq!(end, End::Reached);
    recorder.values
}

/// These names and those of all bonds.
fn names(first: &[&str]) -> Vec<String> {
    let bonds = (1..=BONDS).flat_map(|bond| ["strain", "draws"].map(|name| format!("friction.bristle[{bond}].{name}")));
    first.iter().map(|name| (*name).to_owned()).chain(bonds).collect()
}

/// Random number k of a bond with the seed 0, by SplitMix64.
fn number(bond: usize, k: u64) -> f64 {
    let mix = |number: u64| {
        let z = number.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    };
    let key = mix(mix(0).wrapping_add(bond as u64));
    ((mix(key.wrapping_add(k.wrapping_mul(0x9E37_79B9_7F4A_7C15))) >> 11) + 1) as f64 / 2f64.powi(53)
}

/// Block of 1 kg on a spring of 2 N/m, and the belt, which moves at 0.1 m/s, as a harmonic motion from snap to snap.
struct Belt {
    time: f64,
    position: f64,
    velocity: f64,
    strains: [f64; BONDS],
    draws: [u64; BONDS],
    energy: f64,
}

/// The motion in which no bond snaps: the force is that of the bonds at its beginning and grows with the slip.
struct Harmonic {
    omega: f64,
    drift: f64,
    /// Distance from the centre, and velocity less the drift.
    off: [f64; 2],
}

impl Harmonic {
    fn of(belt: &Belt) -> Harmonic {
        let omega = (2.0 + STIFFNESS).sqrt();
        let [centre, drift] = [STIFFNESS * belt.position - belt.force(), STIFFNESS * 0.1].map(|x| x / (omega * omega));
        Harmonic { omega, drift, off: [belt.position - centre, belt.velocity - drift] }
    }

    /// Slip since the beginning, and its velocity.
    fn slip(&self, time: f64) -> [f64; 2] {
        let [off, speed] = self.off;
        // cos - 1 without the digits that are lost beside 1.
        let (sin, half) = ((self.omega * time).sin(), (0.5 * self.omega * time).sin());
        let change = -2.0 * half * half;
        let moved = (self.drift - 0.1) * time + off * change + speed / self.omega * sin;
        [moved, self.drift - 0.1 + speed * (1.0 + change) - off * self.omega * sin]
    }

    /// The time until which something is not yet the case.
    fn until(&self, mut late: f64, has_happened: impl Fn([f64; 2]) -> bool) -> f64 {
        let mut early = 0.0;
        while late - early > 4.0 * f64::EPSILON * late {
            let middle = 0.5 * (early + late);
            if has_happened(self.slip(middle)) { late = middle } else { early = middle }
        }
        late
    }
}

impl Belt {
    fn force(&self) -> f64 {
        self.strains.iter().sum::<f64>() * STIFFNESS / BONDS as f64
    }

    /// The bond that snaps first in a direction, and the slip until then.
    fn next(&self, direction: f64) -> (usize, f64) {
        let rooms = self.strains.iter().map(|strain| LIMIT - direction * strain);
        rooms.enumerate().min_by(|a, b| a.1.total_cmp(&b.1)).unwrap()
    }

    /// Goes on to the next snap or turn, at most this long.
    fn go(&mut self, longest: f64) {
        let (motion, speed) = (Harmonic::of(self), self.velocity - 0.1);
        let ahead = 2.0 * self.next(speed.signum()).1.max(1e-13) / speed.abs();
        let mut time = longest.min(2e-5).min(ahead);
        let has_turned = |[_, now]: [f64; 2]| now * speed < 0.0;
        if has_turned(motion.slip(time)) {
            time = motion.until(time, has_turned);
        }
        let direction = motion.slip(time)[0].signum();
        let (bond, room) = self.next(direction);
        let is_beyond = |[slip, _]: [f64; 2]| direction * slip >= room;
        let snaps = is_beyond(motion.slip(time));
        if snaps {
            time = motion.until(time, is_beyond);
        }
        let [slip, speed] = motion.slip(time);
        self.energy += slip * (self.force() + 0.5 * STIFFNESS * slip);
        (self.position, self.velocity) = (self.position + slip + 0.1 * time, 0.1 + speed);
        self.strains.iter_mut().for_each(|strain| *strain += slip);
        if snaps {
            self.strains[bond] = direction * LIMIT * (1.0 - number(bond, self.draws[bond]));
            self.draws[bond] += 1;
        }
        self.time += time;
    }
}

/// A block that the spring pulls over the belt from bonds without strain: it swings, breaks away, slides and creeps. Snap
/// by snap, and by steps of two tolerances.
#[test]
fn a_block_on_the_belt_moves_as_snap_by_snap() {
    let (until, intervals) = (0.3, 30);
    let block = system("belt", &[("rig.position", "0.73")], &[]);
    let recorded = names(&["rig.position", "rig.block_velocity", "friction.dissipated_energy"]);
    let found = [1e-3, 1e-6, 1e-8].map(|tolerance| run(&block, until, intervals, tolerance, &recorded));
    let (strains, draws) = ([0.0; BONDS], [0; BONDS]);
    let mut belt = Belt { time: 0.0, position: 0.73, velocity: 0.1, strains, draws, energy: 0.0 };
    for interval in 0..=intervals {
        let end = until * interval as f64 / intervals as f64;
        while belt.time < end {
            belt.go(end - belt.time);
        }
        for found in &found {
            let found: Vec<f64> = found.iter().map(|column| column[interval]).collect();
            let off = [found[0] - belt.position, found[1] - belt.velocity, found[2] - belt.energy];
            assert!(off[0].abs() < 1e-10 && off[1].abs() < 1e-8 && off[2].abs() < 1e-10, "{end}: {off:?}");
            for (bond, found) in found[3..].chunks(2).enumerate() {
                assert!((found[0] - belt.strains[bond]).abs() < 1e-10, "{end}: {bond} {found:?}");
                assert_eq!(found[1], belt.draws[bond] as f64, "{end}: {bond}");
            }
        }
    }
    assert!(belt.draws.iter().all(|draws| *draws > 500), "{:?}", belt.draws);
}

/// The law along a displacement in short steps, under a load that moves.
fn stepped(law: &mut Bristle, [from, to]: [f64; 2], slip: impl Fn(f64) -> f64, load: impl Fn(f64) -> f64) {
    let parts = 200;
    let time = |part: i32| from + (to - from) * f64::from(part) / f64::from(parts);
    for part in 0..parts {
        law.normal_force = load(0.5 * (time(part) + time(part + 1)));
        law.velocity = slip(time(part + 1)) - slip(time(part));
        law.step(1.0);
    }
    law.normal_force = load(to);
    law.output();
}

/// To and fro under a load that swings: the force of each time, the numbers drawn, and the energy. So with bonds that take
/// their strains when the motion begins.
#[test]
fn a_given_motion_moves_the_bonds_as_steps_do() {
    use std::f64::consts::TAU;
    let [sine, load] = [(0.0, 0.01, 1.0, -0.6), (9.0, 5.0, 3.0, 0.0)]
        .map(|(mean, amplitude, frequency, phase)| Course::Sine { mean, amplitude, frequency, phase });
    let inputs = [("friction.velocity", sine), ("friction.normal_force", load)];
    let slip = |t: f64| -0.01 / TAU * (TAU * t - 0.6).cos();
    for bonds in ["Bonded", "Stationary"] {
        let moved = system("motion", &[("initial_bonds", bonds)], &inputs);
        let recorded = names(&["friction.friction_force", "friction.dissipated_energy"]);
        let found = run(&moved, 1.0, 50, 1e-10, &recorded);
        let initial_bonds = if bonds == "Bonded" { 1.0 } else { 2.0 };
        let mut law = Bristle { initial_bonds, normal_force: 9.0, ..Default::default() };
        for at in 1..=50 {
            let [from, to] = [at - 1, at].map(|at| f64::from(at) / 50.0);
            stepped(&mut law, [from, to], slip, |t| 9.0 + 5.0 * (TAU * 3.0 * t).sin());
            let of: Vec<f64> = found.iter().map(|column| column[at as usize]).collect();
            let off = [of[0] - law.friction_force, of[1] - law.dissipated_energy];
            assert!(off[0].abs() < 1e-5 && off[1].abs() < 1e-6 * law.dissipated_energy.abs() + 1e-9, "{to}: {off:?}");
            for (bond, (found, law)) in of[2..].chunks(2).zip(&law.bristle).enumerate() {
                assert!((found[0] - law.strain).abs() < 1e-10 && found[1] == law.draws, "{to}: {bond} {found:?}");
            }
        }
        assert!(law.bristle[..BONDS].iter().all(|bond| bond.draws > 500.0));
    }
}

/// The load is gone from 0.2 s to 0.3 s: bonds form again in place, without strain, and their numbers go on.
#[test]
fn without_a_load_the_bonds_are_released() {
    let load = Course::Points { time: vec![0.0, 0.2, 0.2001, 0.3, 0.3001], value: vec![9.81, 9.81, 0.0, 0.0, 9.81] };
    let velocity = Course::Ramp { from: 1e-3, rate: 0.0, start: 0.0, to: None };
    let moved = system("motion", &[], &[("friction.velocity", velocity), ("friction.normal_force", load)]);
    let recorded = names(&["friction.friction_force"]);
    let found = run(&moved, 0.4, 400, 1e-8, &recorded);
    let mut law = Bristle { velocity: 1e-3, ..Default::default() };
    let at = |at: usize| -> Vec<f64> { found.iter().map(|column| column[at]).collect() };
    law.step(0.1);
    law.step(0.1);
    let (before, during, after) = (at(200), at(250), at(305));
    assert!(before[1..].chunks(2).zip(&law.bristle).all(|(found, law)| (found[0] - law.strain).abs() < 1e-12));
    assert!(during[0] == 0.0 && during[1..].chunks(2).all(|bond| bond[0].abs() < 1e-13), "{during:?}");
    // What moved since the load came back, at 0.3 s and within 0.1 ms.
    let since = 1e-3 * (0.305 - 0.3);
    assert!((after[0] / (STIFFNESS * since) - 1.0).abs() < 0.03, "{after:?}");
    let before: Vec<f64> = before[2..].iter().step_by(2).copied().collect();
    assert!(after[2..].iter().step_by(2).zip(&before).all(|(after, before)| (after - before).abs() <= 1.0));
    assert!(before.iter().all(|draws| *draws > 10.0));
}

#[test]
fn bonds_that_slide_are_for_steps() {
    let equal = system("belt", &[("mu_s", "0.1")], &[]);
    let fault = Motion::new(&equal, &[]).err().unwrap().to_string();
    assert!(fault.starts_with("friction: mu_s = 0.1: must be > mu_k where rates are integrated"), "{fault}");
    assert_eq!(Solver::Auto.for_system(&equal), Solver::Steps);
    assert_eq!(Solver::Auto.for_system(&system("belt", &[], &[])), Solver::Rodas5P);
}

/// Through the first slip and beyond, a tolerance changes nothing: the belt is linear between two snaps.
#[test]
fn bonds_are_the_same_at_any_tolerance() {
    let block = system("belt", &[], &[]);
    let recorded = names(&["rig.position", "friction.friction_force"]);
    let [loose, tight] = [1e-6, 1e-8].map(|tolerance| run(&block, 9.0, 90, tolerance, &recorded));
    assert!(loose == tight);
    assert!(loose[2..].chunks(2).all(|bond| *bond[1].last().unwrap() > 10_000.0));
}
