//! Laws that follow the past, against closed forms and an integration of their own.

use super::past::Line;
use super::tests::belt_with;
use super::{Motion, Setting, Source, System, WireSource};
use crate::solve::{End, Equations, Grid, Method, Options, Recorder, Statistics, solve};
use crate::stick_slip::BELT;

/// The time lag of both laws.
const LAG: f64 = 5e-3;

const KINETIC: f64 = 0.981;

const STATIC: f64 = 1.4715;

/// Stiffness of the spring of the block.
const SPRING: f64 = 2.0;

/// A run of a built-in system with 1000 results.
struct Run {
    statistics: Statistics,
    times: Vec<f64>,
    /// One column for each quantity that was asked for.
    values: Vec<Vec<f64>>,
}

fn system(name: &str, law: &str, settings: &[(&str, &str)]) -> System {
    let set = |(name, value): &(&str, &str)| Setting { name: (*name).to_owned(), value: (*value).to_owned() };
    let settings: Vec<Setting> = settings.iter().map(set).collect();
    System::assemble(&Source::open(name).unwrap(), Some(law), &settings).unwrap()
}

fn run(system: &System, until: f64, tolerance: f64, recorded: &[&str]) -> Run {
    let sources: Vec<WireSource> = recorded.iter().map(|name| system.source(name).unwrap()).collect();
    let mut motion = Motion::new(system, &sources).unwrap();
    let mut recorder = Recorder::new(Grid { begin: 0.0, end: until, intervals: 1000 }, &motion);
    let mut states = motion.start();
    let options = Options::new(until, tolerance);
    let (end, statistics) = solve(Method::Rodas5P, &mut motion, &mut states, &options, &mut recorder);
    assert_eq!(end, End::Reached, "{statistics:?}");
    Run { statistics, times: recorder.times().collect(), values: recorder.values }
}

/// Level of `FrictionalLag` with the default parameters.
fn lagging_level(w: f64) -> f64 {
    KINETIC + (STATIC - KINETIC) * (-(w / 1e-3).powi(2)).exp()
}

/// 0.0015 sin(20 t).
const SINE: [(&str, &str); 2] =
    [("friction.velocity.amplitude", "0.0015"), ("friction.velocity.frequency", "3.183098861837907")];

/// A given velocity: the level is that of a lag ago, that of the beginning until then. The energy is the integral of the
/// power, by the midpoint rule from lag to lag.
#[test]
fn force_of_a_given_motion_is_that_of_a_lag_ago() {
    let velocity = |t: f64| 0.002 + 0.0015 * (20.0 * t).sin();
    let moved = system("motion", "FrictionalLag", &[&[("friction.velocity.mean", "0.002")][..], &SINE].concat());
    let power = |t: f64| lagging_level(velocity((t - LAG).max(0.0))) * velocity(t);
    for tolerance in [1e-4, 1e-11] {
        let found = run(&moved, 1.0, tolerance, &["friction.friction_force", "friction.lagged_velocity"]);
        for (at, time) in found.times.iter().enumerate() {
            let w = velocity((time - LAG).max(0.0));
            let [force, lagged] = [0, 1].map(|column| found.values[column][at]);
            assert!((lagged / w - 1.0).abs() < 1e-9, "{time}: {lagged} instead of {w}");
            assert!((force / lagging_level(w) - 1.0).abs() < 1e-9, "{time}: {force}");
        }
    }
    let energy = run(&moved, 1.0, 1e-11, &["friction.dissipated_energy"]);
    let count = 2_000_000;
    let expected: f64 = (0..count).map(|k| power((f64::from(k) + 0.5) / f64::from(count)) / f64::from(count)).sum();
    let dissipated = energy.values[0][1000];
    assert!((dissipated / expected - 1.0).abs() < 1e-9, "{dissipated} instead of {expected}");
}

/// The filtered velocity of the same motion is a sine, too, once what is left of the beginning has faded.
#[test]
fn filtered_velocity_of_a_given_motion_is_that_of_its_closed_form() {
    let [mean, amplitude, omega] = [0.002, 0.0015, 20.0f64];
    let settings = [("variant", "FirstOrder"), ("friction.velocity.mean", "0.002")];
    let settings = [&settings[..], &SINE].concat();
    let moved = system("motion", "FrictionalLag", &settings);
    let found = run(&moved, 1.0, 1e-11, &["friction.friction_force", "friction.lagged_velocity"]);
    for (at, time) in found.times.iter().enumerate() {
        let (phase, lag) = (omega * time, omega * LAG);
        let share = (phase.sin() - lag * phase.cos() + lag * (-time / LAG).exp()) / (1.0 + lag * lag);
        let w = mean + amplitude * share;
        let [force, lagged] = [0, 1].map(|column| found.values[column][at]);
        assert!((lagged / w - 1.0).abs() < 1e-9, "{time}: {lagged} instead of {w}");
        assert!((force / lagging_level(w) - 1.0).abs() < 1e-9, "{time}: {force}");
    }
}

/// Integral of a polynomial, lowest power first, from 0.
fn integral(polynomial: &[f64]) -> Vec<f64> {
    let terms = polynomial.iter().enumerate().map(|(power, c)| c / (power + 1) as f64);
    std::iter::once(0.0).chain(terms).collect()
}

fn value(polynomial: &[f64], at: f64) -> f64 {
    polynomial.iter().rev().fold(0.0, |sum, c| sum * at + c)
}

/// A free block of 1 kg with equal levels: its viscous friction lags behind, u' = -(f_C + f_v u(t - tau)). From lag to lag
/// the velocity is a polynomial of one degree more; it vanishes in the third. Then friction holds the block.
#[test]
fn a_free_block_stops_where_the_delay_equation_says() {
    let viscous = 40.0;
    let mut speeds = vec![vec![0.02]];
    for lag in 1..=3 {
        let before = &speeds[lag - 1];
        let begin = if lag == 1 { 0.02 } else { value(before, LAG) };
        let mut speed: Vec<f64> = integral(before).iter().map(|c| -viscous * c).collect();
        speed[0] = begin;
        speed[1] -= KINETIC;
        speeds.push(speed);
    }
    let (mut low, mut high) = (0.0, LAG);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if value(&speeds[3], middle) > 0.0 { low = middle } else { high = middle }
    }
    let stop = 2.0 * LAG + high;
    let settings = [
        ("stiffness", "0"),
        ("belt_velocity", "0"),
        ("rig.block_velocity", "0.02"),
        ("mu_s", "0.1"),
        ("viscous_coefficient", "40"),
    ];
    let block = system("belt", "FrictionalLag", &settings);
    for tolerance in [1e-4, 1e-11] {
        let found = run(&block, 0.02, tolerance, &["friction.friction_force"]);
        let first = found.statistics.events[0].time;
        assert!((first - stop).abs() < 1e-9, "{first} instead of {stop}");
        for (time, force) in found.times.iter().zip(&found.values[0]) {
            let lag = ((time / LAG) as usize).min(3);
            let speed = value(&speeds[lag], if lag == 0 { 0.0 } else { time - lag as f64 * LAG });
            let expected = if *time < stop { KINETIC + viscous * speed } else { 0.0 };
            assert!((force - expected).abs() <= 1e-9 * (KINETIC + viscous * speed.abs()), "{time}: {force} {expected}");
        }
    }
}

/// A block that lags behind the belt under a level that follows its speed a lag later: the method of Runge and Kutta, with
/// a whole number of steps in a lag and Hermite's cubic between them.
struct Slip<'a> {
    level: &'a dyn Fn(f64) -> f64,
    /// Position, and speed against the belt, at the beginning of each step.
    motion: Vec<[f64; 2]>,
}

/// Steps in a lag.
const STEPS: usize = 200;

const H: f64 = LAG / STEPS as f64;

impl Slip<'_> {
    /// Speed a lag ago, at a part of the next step.
    fn delayed(&self, part: f64) -> f64 {
        let Some(at) = (self.motion.len() - 1).checked_sub(STEPS) else { return 0.0 };
        let [[x_0, v_0], [x_1, v_1]] = [self.motion[at], self.motion[at + 1]];
        let earlier = |at: usize| at.checked_sub(STEPS).map_or(0.0, |at| self.motion[at][1]);
        let [a_0, a_1] = [SPRING * x_0 - (self.level)(earlier(at)), SPRING * x_1 - (self.level)(earlier(at + 1))];
        let rest = 1.0 - part;
        v_0 * (1.0 + 2.0 * part) * rest * rest
            + v_1 * (1.0 + 2.0 * rest) * part * part
            + H * (a_0 * rest - a_1 * part) * part * rest
    }

    /// The motion after a part of the next step.
    fn after(&self, part: f64) -> [f64; 2] {
        let begin = self.motion[self.motion.len() - 1];
        let rates = |[x, v]: [f64; 2], part: f64| [BELT - v, SPRING * x - (self.level)(self.delayed(part))];
        let beside = |k: [f64; 2], h: f64| [begin[0] + h * k[0], begin[1] + h * k[1]];
        let h = part * H;
        let k_1 = rates(begin, 0.0);
        let k_2 = rates(beside(k_1, 0.5 * h), 0.5 * part);
        let k_3 = rates(beside(k_2, 0.5 * h), 0.5 * part);
        let k_4 = rates(beside(k_3, h), part);
        std::array::from_fn(|i| begin[i] + h / 6.0 * (k_1[i] + 2.0 * (k_2[i] + k_3[i]) + k_4[i]))
    }

    /// Time after which the block is as fast as the belt again, its position then, and the speed a lag before.
    fn stop(mut self) -> [f64; 3] {
        while self.motion.len() < STEPS || self.after(1.0)[1] > 0.0 {
            self.motion.push(self.after(1.0));
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if self.after(middle)[1] > 0.0 { low = middle } else { high = middle }
        }
        [(self.motion.len() - 1) as f64 * H + high * H, self.after(high)[0], self.delayed(high)]
    }
}

fn times(law: &str, tolerance: f64, count: usize) -> Vec<f64> {
    let events = belt_with(law, &[], tolerance).0.events;
    events.iter().take(count).map(|event| event.time).collect()
}

/// The block is held until the spring pulls with the static level, slips, and is held again.
#[test]
fn a_block_slips_under_its_lagging_level_as_another_integration_says() {
    let begin = STATIC / SPRING;
    let [slip, x, _] = Slip { level: &lagging_level, motion: vec![[begin, 0.0]] }.stop();
    let first = begin / BELT;
    let expected = [first, first + slip, first + slip + (begin - x) / BELT];
    for (tolerance, most) in [(1e-3, 1e-4), (1e-6, 1e-5), (1e-11, 1e-9)] {
        let found = times("FrictionalLag", tolerance, 3);
        let off = found.iter().zip(expected).map(|(time, exact)| (time - exact).abs()).fold(0.0, f64::max);
        assert!(off < most, "{tolerance:e}: {found:?} instead of {expected:?}");
    }
}

/// Static friction of `Armstrong` after a time at rest, from the Stribeck magnitude kept of the last slip.
fn risen(kept: f64, rest: f64) -> f64 {
    kept + (STATIC - KINETIC - kept) * rest / (rest + 2.0)
}

/// A block at rest on the belt, swinging without damping on spring and contact: the time after which the contact breaks
/// away, its magnitude then, the place of the block and its speed against the belt.
fn breakaway(x: f64, deflection: f64, kept: f64) -> [f64; 4] {
    let stiffness = 1e5;
    let both = SPRING + stiffness;
    let w = f64::sqrt(both);
    // With y the way against the belt: y'' = k x + s z - (k + s) y + k v_b t.
    let (offset, drift) = ((SPRING * x + stiffness * deflection) / both, SPRING * BELT / both);
    let way = |t: f64| offset * (1.0 - (w * t).cos()) + drift * (t - (w * t).sin() / w);
    let excess = |t: f64| stiffness * (way(t) - deflection) - KINETIC - risen(kept, t);
    let mut high = 1e-4;
    while excess(high) < 0.0 {
        high += 1e-6;
    }
    let mut low = high - 1e-6;
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if excess(middle) < 0.0 { low = middle } else { high = middle }
    }
    let speed = offset * w * (w * high).sin() + drift * (1.0 - (w * high).cos());
    [high, risen(kept, high), x + BELT * high - way(high), speed]
}

/// The contact breaks away from the rising level, the block slips for a time under the level of the breakaway and then under
/// that of a lag ago, stops, and swings on the spring of the contact until it reaches the level again, which rises as fast
/// as the swings at first: the seventh of them reaches it, with little to spare.
#[test]
fn a_contact_breaks_away_and_stops_where_another_integration_says() {
    let [first, magnitude, x, speed] = breakaway(0.0, 0.0, 0.0);
    let level = |w: f64| KINETIC + magnitude / (1.0 + (w / 1e-3).powi(2));
    let [slip, x, w] = Slip { level: &level, motion: vec![[x, speed]] }.stop();
    // The contact is bent as by the force of the slip.
    let kept = level(w) - KINETIC;
    let [rest, ..] = breakaway(x, -(KINETIC + kept) / 1e5, kept);
    let expected = [first, first + slip, first + slip + rest];
    assert!(rest > 0.11 && rest < 0.13, "{rest}");
    for (tolerance, most) in [(1e-3, 1e-3), (1e-6, 1e-5), (1e-11, 1e-8)] {
        let found: Vec<f64> = times("Armstrong", tolerance, 3);
        let off = found.iter().zip(expected).map(|(time, exact)| (time - exact).abs()).fold(0.0, f64::max);
        assert!(off < most, "{tolerance:e}: {found:?} instead of {expected:?}");
    }
}

/// A contact under 0.05 sin(20 t): it stops where the velocity does, breaks away once the way, (1 - cos 20 t) / 400 after
/// every stop, has bent it from one level to the other, and what it remembers is the velocity of slip, 0 at rest. The rests
/// are longer than the lag, and no step ends for its sake in them: there are 200 lags in a second.
#[test]
fn a_contact_at_rest_remembers_its_slip_and_needs_no_steps_for_it() {
    let velocity = |t: f64| 0.05 * (20.0 * t).sin();
    let settings = [
        ("friction.velocity.amplitude", "0.05"),
        ("friction.velocity.frequency", "3.183098861837907"),
        ("sigma_0", "1000"),
        // Equal levels: from one to the other the contact bends by 2 f_C / sigma_0.
        ("mu_s", "0.1"),
    ];
    let moved = system("motion", "Armstrong", &settings);
    let half = std::f64::consts::PI / 20.0;
    let after = |way: f64| (1.0 - 400.0 * way).acos() / 20.0;
    let changes: Vec<f64> = (0..6)
        .flat_map(|k| {
            let way = if k == 0 { 1e-3 * KINETIC } else { 2e-3 * KINETIC };
            [f64::from(k) * half + after(way), f64::from(k + 1) * half]
        })
        .collect();
    for tolerance in [1e-4, 1e-11] {
        let found = run(&moved, 1.0, tolerance, &["friction.lagged_velocity"]);
        let events: Vec<f64> = found.statistics.events.iter().map(|event| event.time).collect();
        assert_eq!(events.len(), 12);
        for (time, expected) in events.iter().zip(&changes) {
            assert!((time - expected).abs() < 1e-2 * tolerance + 1e-9, "{time} instead of {expected}");
        }
        for (time, w) in found.times.iter().zip(&found.values[0]) {
            let ago = time - LAG;
            let is_slip = events.iter().filter(|event| **event <= ago).count() % 2 == 1;
            let expected = if is_slip { velocity(ago) } else { 0.0 };
            assert!((w - expected).abs() < 1e-12, "{time}: {w} instead of {expected}");
        }
    }
    let held = system("motion", "Armstrong", &[&settings[..2], &[("sigma_0", "100")]].concat());
    let steps = run(&held, 1.0, 1e-4, &[]).statistics.steps;
    assert!(steps < 100, "{steps}");
}

/// Errors at all tolerances, from the motion at 1e-11.
#[test]
fn errors_follow_the_tolerance() {
    let truth = belt_with("FrictionalLag", &[], 1e-11).1;
    for exponent in 3..=10 {
        let tolerance = 10f64.powi(-exponent);
        let motion = belt_with("FrictionalLag", &[], tolerance).1;
        let off = motion.iter().zip(&truth).map(|((_, x), (_, exact))| (x - exact).abs()).fold(0.0, f64::max);
        assert!(off < 1e-5 && off < 100.0 * tolerance, "{tolerance:e}: {off:e}");
    }
}

/// A law whose past steps have left is for steps; a lag of 0 is the static law.
#[test]
fn a_given_past_is_refused_and_no_lag_is_the_present() {
    let given = system("motion", "FrictionalLag", &[("history[1].duration", "0.001")]);
    let fault = Motion::check(&given).unwrap_err().to_string();
    assert!(fault.contains("history[1].duration = 0.001: must be 0"), "{fault}");
    for law in ["FrictionalLag", "Armstrong"] {
        let present = system("motion", law, &[("time_lag", "0")]);
        let motion = Motion::new(&present, &[]).unwrap();
        assert!(!motion.has_past() && motion.next_break(0.0) == f64::INFINITY, "{law}");
        let found = run(&present, 0.2, 1e-8, &["friction.lagged_velocity", "friction.velocity"]);
        assert_eq!(found.values[0][1000], found.values[1][1000], "{law}");
    }
}

/// A step that is exact is known at its quarters. What rests there is not looked at in between, and a part that differs from
/// a polynomial by rounding errors only is not divided.
#[test]
fn a_step_is_asked_for_at_its_quarters() {
    let asked = |quantity: fn(f64) -> f64| {
        let (mut line, mut fractions) = (Line::new(0, 0, LAG, 1e-3), Vec::new());
        line.keep(0.1, 0.1 + 0.9 * LAG, &mut |fraction| {
            fractions.push(fraction);
            quantity(fraction)
        });
        fractions
    };
    assert_eq!(asked(|_| 0.3), [0.0, 0.25, 0.5, 0.75, 1.0]);
    let smooth = [0.0, 0.25, 0.5, 0.75, 1.0, 0.125, 0.875];
    assert_eq!(asked(|fraction| fraction * fraction), smooth);
    // A body that moves nearly as fast as the other one: eight digits of the difference are rounded.
    assert_eq!(asked(|fraction| (0.1 + 1e-9 * fraction) - 0.1), smooth);
}
