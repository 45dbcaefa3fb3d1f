//! Moment of inertia, friction and offset of joints.

use std::collections::BTreeSet;
use std::f64::consts::TAU;
use std::path::Path;

use stribeck::model::Kind;
use stribeck_solve::job::Entry;

use super::tests::{estimate, noise, quiet};
use super::*;
use stribeck_measured::Movement;
use stribeck_sheet::{Sheet, SheetError};

/// Records as texts.
pub(super) struct Text(pub String);

impl Source for Text {
    fn tables(&self, _: &Path, _: Option<&str>) -> Result<Vec<Sheet>, SheetError> {
        Ok(vec![Sheet::parse(&self.0)?])
    }
}

/// A joint of 0.12 kg m2 that sticks, with a drive whose controller holds its torque between samples.
#[derive(Clone, Copy)]
pub(super) struct Joint {
    pub level: f64,
    pub viscous: f64,
    pub offset: f64,
    /// Additions to level and viscous coefficient when it turns backward.
    pub backward: [f64; 2],
    /// Gravity of an arm, and the angle at which it is horizontal.
    pub gravity: [f64; 2],
}

pub(super) const INERTIA: f64 = 0.12;
pub(super) const JOINT: Joint = Joint { level: 0.9, viscous: 0.5, offset: 0.05, backward: [0.0; 2], gravity: [0.0; 2] };
const ARM: Joint = Joint { gravity: [1.5, 0.3], ..JOINT };
/// Of the samples, s, and of the simulation.
const INTERVAL: f64 = 0.004;
const PARTS: u32 = 100;
/// Step of the encoder, rad.
const STEP: f64 = TAU / 65536.0;

/// Time, angle, velocity and torque.
pub(super) type Samples = Vec<[f64; 4]>;

/// Wanted angle and velocity.
fn wanted(t: f64) -> [f64; 2] {
    let waves = [(0.8, 0.31, 0.0), (0.35, 0.9, 1.0), (0.1, 2.3, 2.0)];
    let sum = |f: &dyn Fn((f64, f64, f64)) -> f64| waves.into_iter().map(f).sum();
    [
        sum(&|(size, rate, phase)| size * (TAU * rate * t + phase).sin()),
        sum(&|(size, rate, phase)| size * TAU * rate * (TAU * rate * t + phase).cos()),
    ]
}

impl Joint {
    /// Angle and velocity a short time later; the joint stops where its velocity changes its sign and the torque does not
    /// exceed the level.
    fn moved(self, [q, v]: [f64; 2], torque: f64, step: f64) -> [f64; 2] {
        let [of_arm, horizontal] = self.gravity;
        let drive = torque - self.offset - of_arm * (q + 0.5 * step * v - horizontal).cos();
        let direction = if v == 0.0 { drive.signum() } else { v.signum() };
        let [more, more_viscous] = if direction < 0.0 { self.backward } else { [0.0; 2] };
        let level = self.level + more;
        if v == 0.0 && drive.abs() <= level {
            return [q, v];
        }
        let acceleration = |v: f64| (drive - level * direction - (self.viscous + more_viscous) * v) / INERTIA;
        let middle = v + 0.5 * step * acceleration(v);
        let next = v + step * acceleration(middle);
        if next * direction < 0.0 { [q, 0.0] } else { [q + 0.5 * step * (v + next), next] }
    }

    /// A record over 12 s: measured torque and velocity with noise, angle from the encoder.
    pub(super) fn record(self, seed: u64) -> Samples {
        let count = 3000;
        let [of_torque, of_velocity] = [seed, seed + 1000].map(|seed| noise(seed, count));
        let [q, v] = wanted(0.0);
        let mut state = [q, v];
        let sample = |at: usize| {
            let t = at as f64 * INTERVAL;
            let rounded = (state[0] / STEP).round() * STEP;
            let [q, v] = wanted(t);
            let torque = 40.0 * (q - rounded) + 3.0 * (v - state[1]) + self.level * v.signum();
            let measured = [t, rounded, state[1] + 2e-3 * of_velocity[at], torque + 0.02 * of_torque[at]];
            for _ in 0..PARTS {
                state = self.moved(state, torque, INTERVAL / f64::from(PARTS));
            }
            measured
        };
        (0..count).map(sample).collect()
    }
}

/// A record under a heading, in other units.
pub(super) fn text(heading: &str, samples: &Samples, [angle, velocity, torque]: [f64; 3]) -> Text {
    let row = |[t, q, v, m]: &[f64; 4]| format!("{t},{},{},{}\n", angle * q, velocity * v, torque * m);
    Text(format!("{heading}\n") + &samples.iter().map(row).collect::<String>())
}

pub(super) fn asked() -> Inquiry {
    Inquiry { records: vec!["joint.csv".into()], axis: true, repetitions: Some(0), ..Inquiry::default() }
}

pub(super) fn fitted(asked: &Inquiry, record: &Text) -> (Data, Fit) {
    let data = asked.data(record).unwrap();
    let ranking = asked.fits(&data, &mut |_| {}, quiet()).unwrap();
    (data, ranking.best().clone())
}

fn refusal(asked: &Inquiry, record: &Text) -> String {
    asked.records(record).unwrap_err().to_string()
}

pub(super) const SI: &str = "time [s],position [rad],velocity [rad/s],torque [N m]";

/// Whether a parameter is determined, in its unit, with an interval that is not wide and has the truth.
pub(super) fn assert_told(fit: &Fit, (name, unit): (&str, &str), truth: f64, widest: f64) {
    let one = estimate(fit, name);
    let [low, high] = one.interval();
    assert!(one.verdict == Verdict::Determined && (low..=high).contains(&truth), "{one:?}");
    assert!(high - low < widest && one.unit == unit, "{one:?}");
}

#[test]
fn the_values_of_a_joint_are_found_and_shown_in_its_units() {
    let record = text(SI, &JOINT.record(1), [1.0; 3]);
    let (data, fit) = fitted(&asked(), &record);
    let Joint { level, viscous, offset, .. } = JOINT;
    for (name, truth, unit) in [
        ("mass", INERTIA, "kg.m2"),
        ("mu_k", level, "1"),
        ("viscous_coefficient", viscous, "N.m.s/rad"),
        ("offset", offset, "N.m"),
    ] {
        assert_told(&fit, (name, unit), truth, 0.1 * truth.max(0.1));
    }
    let shown = fit.table();
    assert!(shown.contains(" N.m of ") && shown.contains("at a load of 1 N.m a coefficient"), "{shown}");
    assert!(!shown.contains(" N ") && !shown.contains(" m/s") && !shown.contains(" kg "), "{shown}");
    assert!(data.records[0].1.csv().unwrap().starts_with("time [s],force [N.m],displacement [rad],velocity [rad/s],"));
    let answer = Answer::of(&Ranking { ranks: rank(slice(&fit)), fits: vec![fit.clone()], refused: vec![] }, &data);
    let units = [answer.units.force, answer.units.displacement, answer.units.velocity];
    assert_eq!(units, ["N.m", "rad", "rad/s"]);
    for (format, parts) in [
        (Format::Mujoco, ["type=\"hinge\"", "diaginertia=\"0.1", "at 1 N.m"]),
        (Format::Urdf, ["type=\"revolute\"", "ixx=\"0.1", "at 1 N.m"]),
    ] {
        let Exported { text, .. } = fit.exported(format, &data.experiments).unwrap();
        assert!(parts.iter().all(|part| text.contains(part)), "{text}");
    }
}

fn slice(fit: &Fit) -> &[Fit] {
    std::slice::from_ref(fit)
}

/// Degrees, turns per minute and newton centimetres, and columns of which only one has a unit.
#[test]
fn a_joint_in_other_units_is_the_same_joint() {
    let samples = JOINT.record(2);
    let degree = 360.0 / TAU;
    let (_, expected) = fitted(&asked(), &text(SI, &samples, [1.0; 3]));
    for (heading, factors) in [
        ("time [s],pos [deg],speed [rpm],torque [N cm]", [degree, 60.0 / TAU, 100.0]),
        ("time [s],position [rev],vel [\u{b0}/s],tau [mN.m]", [1.0 / TAU, degree, 1000.0]),
        ("t,q,dq,torque [Nm]", [1.0; 3]),
        ("t,q,dq [rad/s],F", [1.0; 3]),
    ] {
        let (data, fit) = fitted(&asked(), &text(heading, &samples, factors));
        assert_eq!(data.records[0].1.movement, Movement::Rotation, "{heading}");
        are_the_same(&expected, &fit);
    }
}

#[test]
fn columns_of_bodies_that_slide_and_turn_are_not_mixed() {
    let samples = &JOINT.record(3)[..200].to_vec();
    let mixed = text("time,position [rad],velocity [m/s],torque [N m]", samples, [1.0; 3]);
    let found = refusal(&asked(), &mixed);
    assert!(found.contains("torque [Nm] and velocity [m/s]: one is of a body that slides"), "{found}");
    let found = refusal(&asked(), &text("time,position [mm],speed,force [N m]", samples, [1.0; 3]));
    assert!(found.contains("force [Nm] and position [mm]"), "{found}");
    // The force at a lever of 50 mm, and a motor current.
    for unit in ["N", "A"] {
        let at_lever = text(&format!("time,position,velocity [rad/s],F [{unit}]"), samples, [1.0, 1.0, 20.0]);
        let scaled = Inquiry { scale: vec![Entry("force".into(), 0.05)], ..asked() };
        let [records, _] = scaled.records(&at_lever).unwrap();
        let plain = asked().records(&text(SI, samples, [1.0; 3])).unwrap();
        let [scaled, plain] = [&records[0].1, &plain[0][0].1];
        assert_eq!((scaled.movement, scaled.time.len()), (Movement::Rotation, plain.time.len()));
        assert!(scaled.force.iter().zip(&plain.force).all(|(a, b)| (a - b).abs() < 1e-12));
    }
    let coulomb = laws().next().unwrap();
    let slides = Experiment { movement: Movement::Translation, ..Experiment::default() };
    let turns = Experiment { name: "arm".into(), movement: Movement::Rotation, ..Experiment::default() };
    let found = super::check(coulomb, &[slides, turns], &Settings::default()).unwrap_err().to_string();
    assert!(found.ends_with("arm in N.m: one body slides, the other turns: fit them one at a time"), "{found}");
}

/// So that no result of a joint is shown in newtons or metres.
#[test]
fn every_unit_that_a_fit_shows_has_one_for_joints() {
    let of_laws = fittable().flat_map(|law| parameter::known(law).into_iter().map(|(_, variable)| variable.kind));
    let units = of_laws.filter_map(|kind| if let Kind::Real(unit) = kind { Some(unit.name) } else { None });
    for unit in units.chain(["N", "m", "m/s", "m/s2", "kg", "s"]).collect::<BTreeSet<_>>() {
        let turned = Movement::Rotation.unit(unit);
        assert_eq!(turned == unit, ["1", "s", "1/s", "J", "K", "1/K", "V", "rad"].contains(&unit), "{unit} {turned}");
        assert_eq!(Movement::Translation.unit(unit), unit);
    }
}

/// Columns without any unit are those of a joint if the user says so, also beside one in rpm by a factor, and in a map.
#[test]
fn a_joint_without_units_is_one_that_is_said_to_be() {
    let samples = JOINT.record(8);
    let (_, expected) = fitted(&asked(), &text(SI, &samples, [1.0; 3]));
    let joint = Inquiry { joint: true, ..asked() };
    let in_rpm = Inquiry { scale: vec![Entry("velocity".into(), TAU / 60.0)], ..joint.clone() };
    for (asked, heading, factors) in [
        (&joint, "time,q,qd,tau", [1.0; 3]),
        (&joint, "t,position,velocity,F", [1.0; 3]),
        (&in_rpm, "time,q,qd,torque", [1.0, 60.0 / TAU, 1.0]),
    ] {
        let (data, fit) = fitted(asked, &text(heading, &samples, factors));
        assert_eq!(data.records[0].1.movement, Movement::Rotation, "{heading}");
        are_the_same(&expected, &fit);
        let said = data.records[0].1.quality.findings.join("\n");
        assert!(heading == "time,q,qd,torque" || said.contains("no unit in the file, taken as s, N.m, "), "{said}");
    }
    let map = |joint: bool| {
        let law = vec!["CoulombViscous".to_owned()];
        let asked = Inquiry { axis: false, normal_force: Some(1.0), law, joint, ..asked() };
        asked.data(&Text("qd,tau\n1,1.4\n2,1.9\n-1,-1.4\n-3,-2.4\n".to_owned()))
    };
    assert_eq!(map(true).unwrap().maps[0].1.movement, Movement::Rotation);
    let refused = [refusal(&asked(), &text("time,q,qd,tau", &samples, [1.0; 3])), map(false).unwrap_err().to_string()];
    for text in refused {
        assert!(text.contains("'tau' may be the torque of a joint") && text.contains("--joint takes them"), "{text}");
    }
    let sliding = refusal(&joint, &text("time,q [mm],qd,tau", &samples, [1.0; 3]));
    assert!(sliding.contains("q [mm]: joint, torque_constant and gear_ratio are for bodies that turn"), "{sliding}");
}

fn are_the_same(expected: &Fit, found: &Fit) {
    for (one, other) in expected.estimates.iter().zip(&found.estimates) {
        // A search ends where it no longer gains.
        let apart = (one.value - other.value).abs();
        assert!(apart < 1e-3 * one.deviation && one.unit == other.unit, "{one:?} {other:?}");
    }
}

fn names(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

/// Before a gear that turns the other way round.
#[test]
fn the_record_of_a_motor_is_that_of_its_joint() {
    let samples = JOINT.record(4);
    let (ratio, constant) = (-100.0, 0.05);
    let (_, expected) = fitted(&asked(), &text(SI, &samples, [1.0; 3]));
    let gear = Inquiry { gear_ratio: Some(ratio), ..asked() };
    let motor = Inquiry { torque_constant: Some(constant), ..gear.clone() };
    for (asked, heading, factors) in [
        (
            Inquiry { motor_side: names(&["force", "velocity"]), ..motor.clone() },
            "time [s],position,velocity [rad/s],current [mA]",
            [1.0, ratio, 1e3 / (ratio * constant)],
        ),
        (motor, "time [s],position,velocity,current", [1.0, 1.0, 1.0 / (ratio * constant)]),
        (gear, "t,position [rad],vel,torque", [1.0, 1.0, 1.0 / ratio]),
        (
            Inquiry { torque_constant: Some(constant), ..asked() },
            "t,place,dq [deg/s],i [A]",
            [1.0, 360.0 / TAU, 1.0 / constant],
        ),
    ] {
        let (data, fit) = fitted(&asked, &text(heading, &samples, factors));
        assert_eq!(data.records[0].1.movement, Movement::Rotation, "{heading}");
        are_the_same(&expected, &fit);
    }
}

#[test]
fn what_contradicts_a_motor_and_its_gear_is_refused() {
    let samples = &JOINT.record(5)[..200].to_vec();
    let gear = || Inquiry { gear_ratio: Some(50.0), ..asked() };
    let motor = || Inquiry { torque_constant: Some(0.1), ..asked() };
    let column = vec![Entry("force".into(), "torque".into())];
    let both = "time,displacement [rad],velocity [rad/s],torque [N m]";
    for (asked, heading, expected) in [
        (Inquiry { scale: vec![Entry("force".into(), 2.0)], ..gear() }, SI, "scale force contradicts torque_constant"),
        (Inquiry { gear_ratio: Some(0.0), ..asked() }, SI, "gear_ratio = 0: must be finite and not 0"),
        (Inquiry { torque_constant: Some(f64::INFINITY), ..asked() }, SI, "torque_constant = inf: must be finite"),
        (
            Inquiry { motor_side: names(&["velocity"]), ..asked() },
            SI,
            "motor_side velocity: must be given with gear_ratio",
        ),
        (Inquiry { motor_side: names(&["load"]), ..gear() }, SI, "motor_side load: must be force, displacement or"),
        (Inquiry { motor_side: names(&["displacement"]), ..gear() }, SI, "no column 'displacement'"),
        (Inquiry { column, ..motor() }, SI, "torque: unit 'Nm', must be one of A, mA"),
        (motor(), SI, "no column 'force'"),
        (
            gear(),
            "time,position [mm],speed [m/s],torque",
            "position [mm]: joint, torque_constant and gear_ratio are for bodies that turn",
        ),
        (
            Inquiry { motor_side: names(&["velocity"]), ..gear() },
            both,
            "displacement and velocity contradict each other",
        ),
    ] {
        let found = refusal(&asked, &text(heading, samples, [1.0; 3]));
        assert!(found.contains(expected), "{expected}: {found}");
    }
}

fn with_gravity() -> Inquiry {
    Inquiry { fit: names(&["gravity"]), ..asked() }
}

#[test]
fn the_gravity_of_an_arm_is_found_as_torque_and_angle() {
    let samples = ARM.record(6);
    let (data, fit) = fitted(&with_gravity(), &text(SI, &samples, [1.0; 3]));
    let Joint { level, viscous, offset, gravity: [torque, angle], .. } = ARM;
    for (name, truth, unit) in [
        ("gravity", torque, "N.m"),
        ("gravity_angle", angle, "rad"),
        ("gravity_cos", torque * angle.cos(), "N.m"),
        ("gravity_sin", torque * angle.sin(), "N.m"),
        ("mass", INERTIA, "kg.m2"),
        ("mu_k", level, "1"),
        ("viscous_coefficient", viscous, "N.m.s/rad"),
        ("offset", offset, "N.m"),
    ] {
        assert_told(&fit, (name, unit), truth, 0.1 * truth.max(0.5));
    }
    // In degrees and rpm; and another record, which is not fitted.
    let turned = text("time,angle [deg],velocity [rpm],torque [N cm]", &samples, [360.0 / TAU, 60.0 / TAU, 100.0]);
    let column = vec![Entry("displacement".into(), "angle".into())];
    are_the_same(&fit, &fitted(&Inquiry { column, ..with_gravity() }, &turned).1);
    let other = with_gravity().data(&text(SI, &ARM.record(7), [1.0; 3])).unwrap();
    let unseen = &held_out(&fit, &other.experiments).unwrap()[0];
    assert!((unseen.rms / unseen.fitted - 1.0).abs() < 0.2, "{unseen:?}");
    // What pictures show is friction alone.
    let seen = fit.corrected(&data.records[0].1);
    let fast: Vec<usize> = (0..seen.time.len()).filter(|at| seen.velocity[*at].abs() > 1.0).collect();
    for at in &fast {
        let friction = level * seen.velocity[*at].signum() + viscous * seen.velocity[*at];
        assert!((seen.friction_force[*at] - friction).abs() < 0.1, "{at} {friction} {}", seen.friction_force[*at]);
    }
    assert!(fast.len() > 50);
    // Values that are given are judged with the gravity that was found.
    let truth = [("mu_k", level), ("viscous_coefficient", viscous)].map(|(name, value)| (name.to_owned(), value));
    let known = evaluate(&fit, &truth.into(), &data.experiments, &asked().settings().unwrap());
    assert!(known.unwrap().residuals.rms < 1.5 * fit.residuals.rms);
    let Exported { lost, .. } = fit.exported(Format::Mujoco, &data.experiments).unwrap();
    assert!(lost.iter().any(|one| one.starts_with("the gravity of 1.4")), "{lost:?}");
}

#[test]
fn gravity_that_there_is_not_has_a_limit_and_one_that_is_forgotten_is_seen() {
    let (_, fit) = fitted(&with_gravity(), &text(SI, &JOINT.record(8), [1.0; 3]));
    let [torque, angle] = ["gravity", "gravity_angle"].map(|name| &estimate(&fit, name).verdict);
    assert!(matches!(torque, Verdict::AtMost(limit) if *limit < 0.05), "{torque:?}");
    assert!(matches!(angle, Verdict::Undetermined(_)), "{angle:?}");
    let record = text(SI, &ARM.record(9), [1.0; 3]);
    let [forgotten, known] = [asked(), with_gravity()].map(|asked| fitted(&asked, &record).1);
    assert!(forgotten.residuals.rms > 5.0 * known.residuals.rms);
    assert!(forgotten.warnings.iter().any(|one| one.starts_with("the residuals are not noise")));
}

#[test]
fn gravity_needs_the_angle_of_a_joint() {
    let samples = &ARM.record(10)[..200].to_vec();
    for heading in ["t,place,velocity [rad/s],torque [N m]", "t,q [m],v,F"] {
        let found = refusal(&with_gravity(), &text(heading, samples, [1.0; 3]));
        assert!(
            found.ends_with("gravity: is fitted to records of a joint, with a column of its angle, in rad or deg"),
            "{found}"
        );
    }
    let held = Inquiry { fix: vec![Entry("gravity".into(), 1.0)], ..asked() };
    let data = held.data(&text(SI, samples, [1.0; 3])).unwrap();
    let found = held.fits(&data, &mut |_| {}, quiet()).unwrap_err().to_string();
    assert_eq!(found, "gravity = 1: hold gravity_cos and gravity_sin instead");
}
