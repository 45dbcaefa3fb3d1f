//! A mass under a PID controller with friction: hunting by stiction, and what ends it.

use stribeck::numerics::root::bisect;

use super::{BUILT_IN, Description, Setting, Source, System};
use crate::run::{Outcome, Settings, Solver, run};

const TARGET: f64 = 1.0;
const K_P: f64 = 3.0;
const K_I: f64 = 4.0;
const K_V: f64 = 6.0;
/// Kinetic level.
const F_C: f64 = 1.0;

/// The loop of a mass of 1 kg with constant friction against a motion, by its modes:
/// `y = a e^(r t) + e^(p t) (b cos w t + c sin w t)`, where y is the integral of the error plus the friction by k_i.
struct Slip {
    shift: f64,
    r: f64,
    p: f64,
    w: f64,
    parts: [f64; 3],
}

impl Slip {
    /// From the integral of the error, the error at rest, and the direction.
    fn from_rest([integral, error]: [f64; 2], direction: f64) -> Slip {
        let r = bisect(|s: f64| ((s + K_V) * s + K_P) * s + K_I, -K_V, -1.0);
        let p = -0.5 * (K_V + r);
        let w = (-K_I / r - p * p).sqrt();
        let shift = direction * F_C / K_I;
        let y = integral + shift;
        let a = (-2.0 * p * error + (p * p + w * w) * y) / ((r - p) * (r - p) + w * w);
        let b = y - a;
        Slip { shift, r, p, w, parts: [a, b, (error - a * r - b * p) / w] }
    }

    /// Integral of the error, error and velocity.
    fn at(&self, t: f64) -> [f64; 3] {
        let [mut a, mut b, mut c] = self.parts;
        let (grown, fade, (sine, cosine)) = ((self.r * t).exp(), (self.p * t).exp(), (self.w * t).sin_cos());
        let mut values = [0.0; 3];
        for value in &mut values {
            *value = a * grown + fade * (b * cosine + c * sine);
            (a, b, c) = (a * self.r, b * self.p + c * self.w, c * self.p - b * self.w);
        }
        values[0] -= self.shift;
        values
    }

    /// Time at which it comes to rest.
    fn length(&self, direction: f64) -> f64 {
        let turned = |t: f64| -direction * self.at(t)[2];
        let step = 1e-3;
        let last = (1..).map(|k| step * f64::from(k)).find(|t| turned(*t) >= 0.0).unwrap();
        bisect(turned, last - step, last)
    }
}

/// Times at which the mass comes to rest and breaks away by turns, until a time, and the errors at rest.
fn hunting(static_level: f64, until: f64) -> (Vec<f64>, Vec<f64>) {
    let (mut times, mut errors) = (Vec::new(), Vec::new());
    let (mut time, mut integral, mut error) = (0.0, 0.0, -TARGET);
    loop {
        let direction = -f64::signum(K_P * error + K_I * integral);
        let slip = Slip::from_rest([integral, error], direction);
        let length = slip.length(direction);
        [integral, error, _] = slip.at(length);
        // At rest the integral grows at a constant rate, until the force is the static level on the side of the target.
        let force = -K_P * error - K_I * integral;
        assert!(force.abs() < static_level, "{force}");
        let dwell = (static_level + force * error.signum()) / (K_I * error.abs());
        integral += error * dwell;
        for (span, event) in [(length, true), (dwell, false)] {
            time += span;
            if time >= until {
                return (times, errors);
            }
            times.push(time);
            if event {
                errors.push(error);
            }
        }
    }
}

/// The system after changes of its text, with settings.
fn changed(changes: &[(&str, &str)], law: &str, settings: &[(&str, &str)]) -> System {
    let (_, text) = BUILT_IN.iter().find(|(name, _)| *name == "servo").unwrap();
    let text = changes.iter().fold((*text).to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    let settings: Vec<Setting> =
        settings.iter().map(|(name, value)| Setting { name: (*name).to_owned(), value: (*value).to_owned() }).collect();
    let source = Source { description: Description::parse(&text).unwrap(), folder: std::path::PathBuf::new() };
    System::assemble(&source, Some(law), &settings).unwrap()
}

/// The motion of a system to its end, or until another time.
fn moved(system: &System, until: Option<f64>, tolerance: f64, solver: Solver) -> Outcome {
    let settings = Settings { tolerance, solver, ..Settings::of(system) };
    let settings = Settings { until: until.unwrap_or(settings.until), ..settings };
    let results = ["servo.position", "servo.target_position", "servo.external_force"].map(str::to_owned);
    let outcome = run(system, &settings, &results).unwrap();
    assert!(outcome.is_reached(), "{}", outcome.end);
    outcome
}

/// Distances from the target.
fn errors(outcome: &Outcome) -> Vec<f64> {
    let [position, target] = ["servo.position", "servo.target_position"].map(|name| outcome.values(name).unwrap());
    position.iter().zip(target).map(|(position, target)| position - target).collect()
}

/// Largest distance in the last part of a motion.
fn late(outcome: &Outcome, part: f64) -> f64 {
    let errors = errors(outcome);
    let from = ((1.0 - part) * errors.len() as f64) as usize;
    errors[from..].iter().map(|error| error.abs()).fold(0.0, f64::max)
}

/// With constant levels every slip and every rest has a closed form. Where the static level is above the kinetic one the
/// errors at rest come to a limit, else they die out: each rest is then longer than the one before, and with it grows what
/// an error of its distance does to its end.
#[test]
fn it_sticks_and_slips_where_closed_forms_say() {
    for (mu_s, until, [least, most], off) in [("0.15", 150.0, [0.05, 0.07], 1e-10), ("0.1", 1000.0, [0.0, 1e-3], 1e-7)]
    {
        let (times, at_rest) = hunting(10.0 * mu_s.parse::<f64>().unwrap(), until);
        let found =
            moved(&changed(&[], "CoulombStiction", &[("friction.mu_s", mu_s)]), Some(until), 1e-10, Solver::Auto);
        assert_eq!(found.events.len(), times.len(), "{:?} {times:?}", found.events);
        for (event, expected) in found.events.iter().zip(&times) {
            assert!((event.time - expected).abs() < off * expected, "{}: {expected}", event.time);
        }
        let errors = errors(&found);
        for (rest, error) in times.chunks_exact(2).zip(&at_rest) {
            let at = found.time.partition_point(|time| *time < 0.5 * (rest[0] + rest[1]));
            assert!((errors[at] - error).abs() < 1e-8, "{mu_s}: {} {error}", errors[at]);
        }
        let last = at_rest.last().unwrap().abs();
        assert!(times.len() > 10 && last > least && last < most, "{mu_s}: {at_rest:?}");
    }
}

/// The observer compensates for the friction of the law from which it has its values; the error dies out.
#[test]
fn an_observer_ends_hunting() {
    let motion = |settings: &[(&str, &str)]| moved(&changed(&[], "LuGre", settings), None, 1e-8, Solver::Auto);
    let [hunts, rests] =
        [motion(&[]), motion(&[("servo.compensation", "Observer")])].map(|outcome| late(&outcome, 0.2));
    assert!(hunts > 0.06 && rests < 1e-4, "{hunts} {rests}");
}

/// On a path, friction that is fed forward leaves no error; without it the mass stops at each turning point.
#[test]
fn friction_fed_forward_keeps_the_mass_on_its_path() {
    let (amplitude, frequency, phase) = (0.1, 0.2, 1.0_f64);
    let path = format!(
        "\"servo.target_position\" = {{ sine = {{ amplitude = {amplitude}, frequency = {frequency}, phase = {phase:?} }} }}"
    );
    let rate = amplitude * std::f64::consts::TAU * frequency;
    let [position, velocity] = [amplitude * phase.sin(), rate * phase.cos()].map(|start: f64| start.to_string());
    let settings = |compensation| {
        [
            ("servo.compensation", compensation),
            ("servo.viscous_coefficient", "0"),
            ("servo.position", position.as_str()),
            ("servo.velocity", velocity.as_str()),
            ("friction.mu_s", "0.1"),
        ]
    };
    let [off, fed] = ["Off", "FeedForward"].map(|compensation| {
        let system = changed(&[("\"servo.target_position\" = 1.0", &path)], "CoulombStiction", &settings(compensation));
        late(&moved(&system, Some(20.0), 1e-10, Solver::Auto), 1.0)
    });
    assert!(fed < 1e-7 && off > 0.01, "{fed} {off}");
}

/// A fast sampled controller hunts as the continuous one does; the solver that takes rates is refused.
#[test]
fn a_sampled_controller_is_led_by_steps() {
    let system = changed(&[], "LuGre", &[("servo.sample_time", "1e-3")]);
    let settings = Settings { solver: Solver::Rodas5P, ..Settings::of(&system) };
    let refused = run(&system, &settings, &[]).unwrap_err().to_string();
    assert!(refused.contains("servo: sample_time = 0.001: must be 0"), "{refused}");
    let sampled = moved(&system, Some(3.0), 1e-6, Solver::Auto);
    assert_eq!(sampled.solver, Solver::Steps);
    let continuous = moved(&changed(&[], "LuGre", &[]), Some(3.0), 1e-8, Solver::Auto);
    let off = errors(&sampled).iter().zip(errors(&continuous)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off > 1e-5 && off < 5e-3, "{off}");
}
