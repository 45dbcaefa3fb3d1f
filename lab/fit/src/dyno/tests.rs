//! Round trip: simulate tests of known dampers and recover their parameters.

use std::f64::consts::TAU;
use std::path::PathBuf;

use super::*;
use approx::{abs_diff_eq, assert_abs_diff_eq};

/// A damper with a known law: degressive, with Coulomb friction and a linear gas spring.
struct Known {
    damping: [f64; 2], // compression, extension, N.s/m
    friction: [f64; 2],
    gas: f64,
    gas_rate: f64,
    noise: f64,
}

const KNOWN: Known =
    Known { damping: [2500.0, 4000.0], friction: [22.0, 22.0], gas: 160.0, gas_rate: 1200.0, noise: 0.0 };

impl Known {
    fn hydraulic(&self, velocity: f64) -> f64 {
        let damping = self.damping[usize::from(velocity > 0.0)];
        damping * velocity / (1.0 + 2.0 * velocity.abs())
    }

    fn resistance(&self, velocity: f64, displacement: f64) -> f64 {
        let friction = self.friction[usize::from(velocity > 0.0)] * velocity.signum();
        self.hydraulic(velocity) + friction - (self.gas - self.gas_rate * displacement)
    }

    /// Cycles with an amplitude of 20 mm, one at each peak velocity.
    fn strokes(&self, peaks: &[f64], samples: usize, seed: u64) -> Test {
        let mut random = fastrand::Rng::with_seed(seed);
        let mut test = Test { displacement: Some(Vec::new()), ..Test::default() };
        for peak in peaks {
            for sample in 0..samples {
                let angle = TAU * (sample as f64 + 0.5) / samples as f64;
                let [velocity, displacement] = [peak * angle.sin(), -0.02 * angle.cos()];
                let noise = self.noise * ((0..12).map(|_| random.f64()).sum::<f64>() - 6.0);
                test.velocity.push(velocity);
                test.displacement.as_mut().unwrap().push(displacement);
                test.force.push(self.resistance(velocity, displacement) + noise);
            }
        }
        test
    }

    /// One sample per speed and direction, as given by the peaks of many cycles.
    fn peaks(&self, speeds: &[f64]) -> Test {
        let velocity: Vec<f64> = speeds.iter().flat_map(|speed| [*speed, -speed]).collect();
        let force = velocity.iter().map(|velocity| self.resistance(*velocity, 0.0)).collect();
        Test { velocity, force, ..Test::default() }
    }
}

const PEAKS: [f64; 3] = [0.05, 0.3, 1.0];

fn find(test: &Test) -> Damper {
    find_damper(test, &Options::default()).unwrap()
}

fn refusal(test: &Test, options: &Options) -> String {
    find_damper(test, options).unwrap_err().to_string()
}

/// Every point of the table lies on the law, within a fraction of the force there.
fn assert_table(damper: &Damper, law: impl Fn(f64) -> f64, part: f64, least: f64) {
    for &(velocity, force) in &damper.table {
        let wanted = law(velocity);
        let tolerance = (part * wanted.abs()).max(least);
        assert!(
            abs_diff_eq!(force, wanted, epsilon = tolerance),
            "{velocity} m/s: {force} N, must be {wanted} +- {tolerance} N"
        );
    }
    assert!(damper.table.windows(2).all(|pair| pair[0].0 < pair[1].0 && pair[0].1 <= pair[1].1), "{:?}", damper.table);
    assert!(damper.table.contains(&(0.0, 0.0)));
}

#[test]
fn strokes_without_noise_give_back_table_friction_and_gas() {
    let damper = find(&KNOWN.strokes(&PEAKS, 500, 1));
    assert_table(&damper, |v| KNOWN.hydraulic(v), 0.002, 0.3);
    let friction = damper.friction.unwrap();
    // The law bends below the low speed: its third derivative causes an error of a third of a newton.
    assert!(abs_diff_eq!(friction.level.value, 22.0, epsilon = 0.5), "{friction:?}");
    assert_eq!(friction.asymmetry, None);
    assert!(abs_diff_eq!(damper.gas_force.unwrap().value, 160.0, epsilon = 0.2), "{:?}", damper.gas_force);
    assert!(abs_diff_eq!(damper.gradient.unwrap().value, 1200.0, epsilon = 5.0), "{:?}", damper.gradient);
    assert_eq!(damper.table.len(), 11);
    assert!(damper.warnings.is_empty(), "{:?}", damper.warnings);
}

/// Over many noisy tests the estimates scatter about the truth according to their standard deviations.
#[test]
fn standard_deviations_cover_the_truth() {
    let noisy = Known { noise: 2.0, ..KNOWN };
    let mut scores = Vec::new();
    for seed in 0..60 {
        let damper = find(&noisy.strokes(&PEAKS, 400, seed));
        assert_table(&damper, |v| noisy.hydraulic(v), 0.02, 4.0);
        let level = damper.friction.unwrap().level;
        assert!(abs_diff_eq!(level.value, 22.0, epsilon = 2.0), "{level:?}");
        assert!(level.deviation > 0.1 && level.deviation < 1.0, "{level:?}");
        scores.push((level.value - 22.0) / level.deviation);
    }
    let spread = (scores.iter().map(|score| score * score).sum::<f64>() / scores.len() as f64).sqrt();
    assert!((0.7..1.4).contains(&spread), "{spread}");
}

#[test]
fn outliers_do_not_count() {
    let mut test = Known { noise: 1.0, ..KNOWN }.strokes(&PEAKS, 400, 3);
    for force in test.force.iter_mut().step_by(37) {
        *force += 400.0;
    }
    let damper = find(&test);
    assert_table(&damper, |v| KNOWN.hydraulic(v), 0.02, 4.0);
    assert_abs_diff_eq!(damper.friction.unwrap().level.value, 22.0, epsilon = 1.0);
    assert!(damper.max_error > 350.0, "the outliers appear in the largest difference");
}

#[test]
fn known_gas_force_separates_the_directions() {
    let known = Known { friction: [35.0, 21.0], noise: 1.0, ..KNOWN };
    let test = known.strokes(&PEAKS, 400, 4);
    let damper = find_damper(&test, &Options { gas_force: Some(160.0), ..Options::default() }).unwrap();
    let friction = damper.friction.unwrap();
    assert!(abs_diff_eq!(friction.level.value, 28.0, epsilon = 1.0), "{friction:?}");
    assert!(abs_diff_eq!(friction.asymmetry.unwrap(), 0.25, epsilon = 0.04), "{friction:?}");
    assert_table(&damper, |v| known.hydraulic(v), 0.02, 4.0);
    let wrong = find_damper(&test, &Options { gas_force: Some(500.0), ..Options::default() }).unwrap();
    assert_eq!(wrong.friction.unwrap().asymmetry, None);
    assert!(wrong.warnings[0].contains("would make friction negative"), "{:?}", wrong.warnings);
}

/// Compressible oil makes the force lag. With a linear damper the lag is proportional to the displacement, and all of
/// it is separated from friction, which it would more than double.
#[test]
fn lag_of_the_oil_is_not_friction() {
    let [peak, amplitude, delay] = [0.3, 0.02, 1e-3];
    let damping = |velocity: f64| velocity * if velocity > 0.0 { 4000.0 } else { 2500.0 };
    let mut test = Test { displacement: Some(Vec::new()), ..Test::default() };
    for sample in 0..2000 {
        let angle = TAU * (f64::from(sample) + 0.5) / 2000.0;
        let velocity = peak * angle.sin();
        let late = velocity - delay * peak * peak / amplitude * angle.cos();
        test.velocity.push(velocity);
        test.displacement.as_mut().unwrap().push(-amplitude * angle.cos());
        test.force.push(damping(velocity) / velocity * late + 22.0 * velocity.signum() - 160.0);
    }
    let damper = find(&test);
    let level = damper.friction.unwrap().level.value;
    assert_abs_diff_eq!(level, 22.0, epsilon = 0.1);
    let lag = delay * (peak / amplitude).powi(2) * (4000.0 + 2500.0) / 2.0;
    assert!(abs_diff_eq!(damper.gradient.unwrap().value / lag, 1.0, epsilon = 0.01), "{:?}", damper.gradient);
}

/// The bristles of LuGre friction need a travel of some f / sigma_0 after each reversal, exact update for held
/// velocity.
#[test]
fn developing_friction_is_left_out() {
    let mut test = KNOWN.strokes(&PEAKS, 1000, 5);
    let [level, stiffness] = [22.0, 1e5];
    let mut bristle: f64 = -level / stiffness;
    for at in 0..test.velocity.len() {
        let velocity = test.velocity[at];
        let step = TAU * 0.02 / PEAKS[at / 1000] / 1000.0;
        let end = velocity.signum() * level / stiffness;
        bristle = end + (bristle - end) * (-stiffness * velocity.abs() * step / level).exp();
        test.force[at] += stiffness * bristle - level * velocity.signum();
    }
    let damper = find(&test);
    assert!(abs_diff_eq!(damper.friction.unwrap().level.value, 22.0, epsilon = 1.0), "{:?}", damper.friction);
    let blind = Test { displacement: None, ..test };
    let without = find(&blind).friction.unwrap().level.value;
    assert!(without < 21.5, "{without}: the documentation says that it looks smaller without displacement");
}

#[test]
fn few_monotone_points_are_kept_exactly() {
    let speeds = [0.01, 0.02, 0.03, 0.05, 0.1, 0.25, 0.5];
    let known = Known { friction: [0.0; 2], gas: 0.0, damping: [1600.0, 3200.0], ..KNOWN };
    let test = known.peaks(&speeds[3..]);
    let damper = find(&test);
    assert_eq!(damper.friction, None);
    let wanted = |velocity: f64| known.resistance(velocity, 0.0);
    for speed in &speeds[3..] {
        for velocity in [*speed, -speed] {
            let point = damper.table.iter().find(|point| point.0 == velocity).unwrap();
            assert_eq!(point.1, wanted(velocity));
        }
    }
    assert_eq!(damper.table.len(), 9);
    assert!(damper.rms_error < 1e-12);
    assert!(damper.warnings[0].starts_with("too few samples below 0.05 m/s in extension"), "{:?}", damper.warnings);
}

/// As long as no number of points is asked for: a table of 11 points would be off by more than the test.
#[test]
fn a_curve_of_at_most_sixteen_points_is_kept() {
    let rows: Vec<(f64, f64)> = (-7..=8).map(|at| f64::from(at) * 0.13).map(|v| (v, 1000.0 * v * (1.0 + v))).collect();
    let curve = |rows: &[(f64, f64)]| {
        let lines: String = rows.iter().map(|(v, force)| format!("{v},{force}\n")).collect();
        find(&Test::parse(&format!("velocity,force\n{lines}")).unwrap())
    };
    let monotone: Vec<(f64, f64)> = rows.iter().copied().filter(|(v, _)| *v > -0.45).collect();
    let kept = curve(&monotone);
    assert_eq!(kept.table.len(), monotone.len());
    for ((v, force), (of, found)) in monotone.iter().zip(&kept.table) {
        assert!(abs_diff_eq!(v, of, epsilon = 1e-15) && abs_diff_eq!(force, found, epsilon = 1e-12), "{v} {force}");
    }
    let seventeen: Vec<(f64, f64)> = (-8..=8).map(|at| (f64::from(at) * 0.1, f64::from(at) * 90.0)).collect();
    assert_eq!([curve(&seventeen[1..]).table.len(), curve(&seventeen).table.len()], [16, 11]);
}

#[test]
fn peaks_of_many_speeds_give_back_friction() {
    let speeds = [0.005, 0.01, 0.02, 0.03, 0.04, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.75, 1.0];
    let damper = find(&KNOWN.peaks(&speeds));
    assert!(abs_diff_eq!(damper.friction.unwrap().level.value, 22.0, epsilon = 1.5), "{:?}", damper.friction);
    assert!(abs_diff_eq!(damper.gas_force.unwrap().value, 160.0, epsilon = 1.5), "{:?}", damper.gas_force);
    assert_eq!(damper.table.len(), 11);
    assert_table(&damper, |v| KNOWN.hydraulic(v), 0.02, 2.0);
}

/// The five points found by the search are as good as the best of all choices.
#[test]
fn polyline_is_the_best_choice_of_points() {
    let curve: Vec<(f64, f64)> = (0..=10).map(f64::from).map(|v| (v, (v * 0.4).sin() + 0.1 * v)).collect();
    let error = |points: &[(f64, f64)]| {
        let line: Vec<(f64, f64)> = [curve[0]].into_iter().chain(points.iter().copied()).collect();
        curve.iter().map(|point| (point.1 - Curve::from(&line[..]).linear(point.0)).powi(2)).sum::<f64>()
    };
    let found = error(&polyline(&curve, 3));
    let mut best = f64::INFINITY;
    for first in 1..10 {
        for second in first + 1..10 {
            best = best.min(error(&[curve[first], curve[second], curve[10]]));
        }
    }
    assert_abs_diff_eq!(found, best, epsilon = 1e-12);
    assert_eq!(polyline(&curve, 20), curve[1..]);
}

#[test]
fn signs_are_found_and_contradictions_rejected() {
    let test = KNOWN.strokes(&PEAKS, 300, 6);
    let wanted = find(&test);
    let turned = |values: &[f64]| values.iter().map(|value| -value).collect::<Vec<f64>>();
    let reaction = Test { force: turned(&test.force), ..test.clone() };
    let damper = find(&reaction);
    assert_eq!(damper.force_sign, ForceSign::Reaction);
    assert_eq!(damper.table, wanted.table);

    let compression = Test {
        velocity: turned(&test.velocity),
        displacement: test.displacement.as_deref().map(turned),
        ..test.clone()
    };
    let options = Options { compression_positive: true, ..Options::default() };
    let damper = find_damper(&compression, &options).unwrap();
    assert_eq!((damper.force_sign, &damper.table), (ForceSign::Reaction, &wanted.table));
    let unturned = find(&compression);
    assert!(unturned.warnings[0].contains("but gas pushes"), "{:?}", unturned.warnings);

    let demanded = Options { force_sign: Some(ForceSign::Resistance), ..Options::default() };
    assert_eq!(find_damper(&test, &demanded).unwrap(), wanted);
    assert!(refusal(&reaction, &demanded).starts_with("the force in the file is the reaction, not the resistance"));
    let half_turned = Test { velocity: turned(&test.velocity), ..test.clone() };
    assert!(refusal(&half_turned, &Options::default()).starts_with("the displacement decreases while"));
    let mut random = fastrand::Rng::with_seed(8);
    let noise = Test { force: test.force.iter().map(|_| random.f64()).collect(), ..test };
    assert!(refusal(&noise, &Options::default()).contains("neither a resistance (100 %) nor a reaction (0 %)"));
}

#[test]
fn inconclusive_data_are_reported() {
    let mut warm = KNOWN.strokes(&PEAKS, 300, 9);
    warm.temperature = Some((0..warm.velocity.len()).map(|at| 293.15 + 45.0 * at as f64 / 899.0).collect());
    assert!(find(&warm).warnings[0].starts_with("the temperature runs from 20.0 to 65.0 degC"));

    let still = Test { displacement: Some(vec![0.01; 900]), ..KNOWN.strokes(&PEAKS, 300, 9) };
    assert!(find(&still).warnings[0].starts_with("the displacement does not separate the two branches"));

    let smooth = Known { friction: [-5.0, -5.0], ..KNOWN }.strokes(&PEAKS, 300, 9);
    let damper = find(&smooth);
    assert!(damper.friction.is_none() && damper.warnings[0].contains("no friction was found"), "{:?}", damper.warnings);

    let faint = Known { friction: [0.1, 0.1], noise: 3.0, ..KNOWN }.strokes(&PEAKS, 300, 12);
    assert!(find(&faint).warnings.iter().any(|warning| warning.contains("friction")), "{:?}", find(&faint).warnings);

    let mut wavy = KNOWN.peaks(&[0.1, 0.2, 0.3, 0.4]);
    wavy.force[4] = wavy.force[2] - 20.0; // 0.3 m/s below 0.2 m/s
    let damper = find(&wavy);
    assert!(damper.warnings[1].contains("not monotone: points were moved by up to 10.0 N"), "{:?}", damper.warnings);
}

#[test]
fn half_tests_and_bad_options_are_rejected() {
    let test = KNOWN.strokes(&PEAKS, 300, 10);
    let keep = |test: &Test, keep: fn(f64) -> bool| {
        let pairs = test.velocity.iter().zip(&test.force).filter(|pair| keep(*pair.0));
        let (velocity, force) = pairs.unzip();
        Test { velocity, force, ..Test::default() }
    };
    let half = keep(&test, |velocity| velocity > 0.0);
    assert!(refusal(&half, &Options::default()).starts_with("0 samples in compression: a damper table needs"));
    let turned = Options { compression_positive: true, ..Options::default() };
    assert!(refusal(&half, &turned).starts_with("0 samples in extension"));
    for (options, answer) in [
        (Options { points: Some(2), ..Options::default() }, "points = 2: must be 3 to 16"),
        (Options { points: Some(17), ..Options::default() }, "points = 17: must be 3 to 16"),
        (Options { low_speed: 0.0, ..Options::default() }, "low speed = 0: must be > 0 m/s and finite"),
        (Options { low_speed: f64::NAN, ..Options::default() }, "low speed = NaN: must be > 0 m/s and finite"),
        (Options { gas_force: Some(f64::NAN), ..Options::default() }, "gas force = NaN: must be finite"),
    ] {
        assert_eq!(refusal(&test, &options), answer);
    }
}

fn examples() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples/dampers")
}

fn example(name: &str) -> Test {
    Test::load(&examples().join(name), None, &[]).unwrap()
}

/// The law from which the example was computed: the damper table of the defaults.
fn default_damping(velocity: f64) -> f64 {
    let speeds = [0.0, 0.05, 0.1, 0.25, 0.5, 1.0];
    let forces = if velocity > 0.0 {
        [0.0, 180.0, 340.0, 640.0, 950.0, 1500.0]
    } else {
        [0.0, 110.0, 210.0, 430.0, 700.0, 1150.0]
    };
    let table: Vec<(f64, f64)> = speeds.into_iter().zip(forces).collect();
    velocity.signum() * Curve::from(&table[..]).linear(velocity.abs())
}

#[test]
fn shipped_examples_give_back_their_dampers() {
    let firm = find(&example("dyno.csv"));
    assert_table(&firm, default_damping, 0.02, 6.0);
    assert!(abs_diff_eq!(firm.friction.unwrap().level.value, 25.0, epsilon = 1.5), "{:?}", firm.friction);
    assert!(firm.warnings.is_empty() && firm.rms_error < 12.0, "{firm:?}");
    let options = Options { compression_positive: true, ..Options::default() };
    let soft = find_damper(&example("dyno_soft.csv"), &options).unwrap();
    assert_table(&soft, |velocity| 0.6 * default_damping(velocity), 0.02, 4.0);
    assert!(abs_diff_eq!(soft.friction.unwrap().level.value, 12.0, epsilon = 1.0), "{:?}", soft.friction);
    assert_eq!(soft.force_sign, ForceSign::Reaction);
}

/// `firm.csv` and `soft.csv`, which the four-post rig uses, are written by `stribeck damper`.
#[test]
fn shipped_parameter_sets_are_those_of_the_shipped_tests() {
    let reversed = Options { compression_positive: true, ..Options::default() };
    for (name, file, options) in [("firm", "dyno.csv", Options::default()), ("soft", "dyno_soft.csv", reversed)] {
        let found = find_damper(&example(file), &options).unwrap().parameter_set(name).unwrap();
        let shipped = ParameterSet::load(found.model(), &examples().join(format!("{name}.csv"))).unwrap();
        assert_eq!(found.values().count(), shipped.values().count());
        for ((variable, value), (known, shipped)) in found.values().zip(shipped.values()) {
            assert_eq!(variable.path.to_string(), known.path.to_string());
            let difference = (value - shipped).abs();
            assert!(difference <= 1e-9 * shipped.abs(), "{name}: {} = {value}, not {shipped}", variable.path);
        }
    }
}

/// The shock absorber with the set gives the force of the measured damper.
#[test]
fn the_shock_absorber_with_the_set_has_the_measured_force() {
    use stribeck::instance::Instance;
    let damper = find(&example("dyno.csv"));
    let set = damper.parameter_set("firm").unwrap();
    let model = set.model();
    let column = |name: &str| model.find(name).unwrap();
    for velocity in [-0.7, -0.2, 0.03, 0.3, 0.9] {
        let mut absorber = Instance::new(model);
        for (variable, value) in set.values() {
            absorber.set_column(column(&variable.path.to_string()), value).unwrap();
        }
        // No side load, so that only the preloads cause friction.
        absorber.set_column(column("side.offset_m"), 0.0).unwrap();
        absorber.set_column(column("velocity"), velocity).unwrap();
        absorber.step(0.1).unwrap();
        absorber.refresh().unwrap();
        let friction = absorber.row()[column("force_friction")];
        let hydraulic = absorber.row()[column("force_damper")];
        assert!(abs_diff_eq!(friction, -25.0 * velocity.signum(), epsilon = 1.5), "{velocity}: {friction}");
        let wanted = default_damping(velocity);
        assert!(
            abs_diff_eq!(hydraulic, -wanted, epsilon = (0.03 * wanted.abs()).max(6.0)),
            "{velocity}: {hydraulic} {wanted}"
        );
    }
    assert_eq!(set.get("damper.mode"), Some(2.0));
    assert_eq!(set.get("damper.tab_n"), Some(11.0));
    let preloads = ["c1.preload_k", "c2.preload_k", "c1.preload_s", "c2.preload_s"].map(|name| set.get(name).unwrap());
    assert!(
        (preloads[0] / preloads[1] - 8.0 / 6.0).abs() < 1e-12 && (preloads[2] / preloads[3] - 10.0 / 8.0).abs() < 1e-12
    );
    assert_abs_diff_eq!(preloads[0] + preloads[1], damper.friction.unwrap().level.value, epsilon = 1e-12);
    let again = ParameterSet::from_ssv(model, &set.to_ssv()).unwrap();
    assert_eq!(again, set);
}

/// Found by fuzzing: squares overflow, deviations become infinite, or the points of a table coincide.
#[test]
fn unphysical_numbers_are_rejected() {
    const SAMPLES: [(i32, i32); 12] = [
        (-500, -900),
        (-250, -500),
        (-100, -250),
        (-20, -60),
        (-10, -40),
        (-5, -30),
        (5, 20),
        (10, 40),
        (20, 60),
        (100, 300),
        (250, 700),
        (500, 1200),
    ];
    let file = |velocity: &str, force: &str| {
        let rows: String = SAMPLES.iter().map(|(v, f)| format!("{v}{velocity},{f}{force}\n")).collect();
        find_damper(&Test::parse(&format!("velocity,force\n{rows}")).unwrap(), &Options::default())
    };
    file("e-3", "").unwrap();
    for (velocity, force, expected) in [
        ("e-3", "e160", "too large or too small to compute with"),
        ("e-3", "e304", "too large or too small to compute with"),
        ("e-5", "", "no sample is faster than 5.000e-3 m/s: up to 0.05 m/s (low speed)"),
        ("e-323", "", "no sample is faster than"),
    ] {
        let refusal = file(velocity, force).unwrap_err().to_string();
        assert!(refusal.contains(expected), "{velocity} {force}: {refusal}");
    }
}
