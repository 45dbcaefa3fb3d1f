//! Records of a slider whose motion and friction are known in closed form, and spoilt files.

use std::f64::consts::TAU;
use std::fmt::Write;

use super::*;
use stribeck_sheet::Sheet;

const MASS: f64 = 2.0;
const LEVEL: f64 = 4.0;
const LOAD: f64 = 20.0;
const AMPLITUDE: f64 = 0.01;
const FREQUENCY: f64 = 0.5;

/// Displacement, velocity and acceleration of the slider.
fn motion(t: f64) -> [f64; 3] {
    let (rate, turn) = (TAU * FREQUENCY, (TAU * FREQUENCY * t).sin_cos());
    [-AMPLITUDE * turn.1, AMPLITUDE * rate * turn.0, AMPLITUDE * rate * rate * turn.1]
}

fn friction(t: f64) -> f64 {
    LEVEL * (motion(t)[1] / 1e-4).tanh()
}

fn force(t: f64) -> f64 {
    friction(t) + MASS * motion(t)[2]
}

/// A file of 8 s at 1 kHz.
fn file(row: impl Fn(f64) -> String) -> String {
    (0..8000)
        .map(|k| f64::from(k) / 1000.0)
        .fold("time,force,displacement\n".to_owned(), |text, t| text + &row(t) + "\n")
}

fn rig() -> Setup {
    Setup { mass: MASS, normal_force: Some(LOAD), ..Setup::default() }
}

fn record(text: &str, rig: &Setup) -> Result<Record, MeasuredError> {
    Record::of(&Sheet::parse(text)?, None, rig)
}

#[test]
fn friction_is_the_force_without_inertia_in_both_strokes() {
    let text = file(|t| format!("{t},{},{}", force(t), motion(t)[0]));
    let record = record(&text, &rig()).unwrap();
    assert!(record.is_differentiated && record.time.len() == 8000);
    for (at, t) in record.time.iter().enumerate() {
        // The filters follow the sine to 1e-7 of it.
        assert!((record.velocity[at] - motion(*t)[1]).abs() < 1e-7, "{t}");
        assert!((record.acceleration[at] - motion(*t)[2]).abs() < 1e-4, "{t}");
        assert!((record.friction_force[at] - friction(*t)).abs() < 2e-4, "{t}");
    }
    let quality = &record.quality;
    assert_eq!([quality.samples, quality.reversals, quality.gaps.len()], [8000, 7, 0]);
    assert_eq!(quality.findings.len(), 1, "{quality:?}");
    assert!(quality.findings[0].starts_with("one normal force (20 N)"), "{quality:?}");
}

/// A measured velocity has its noise, and one from seven samples an error too, although half of them make no window.
#[test]
fn the_error_of_the_velocity_around_rest_is_known() {
    let mut random = fastrand::Rng::with_seed(4);
    let spread = |random: &mut fastrand::Rng| (0..12).map(|_| random.f64()).sum::<f64>() - 6.0;
    let noisy: Vec<f64> = (0..8000).map(|_| 1e-4 * spread(&mut random)).collect();
    let at = |t: f64| noisy[(t * 1000.0).round() as usize];
    let text = file(|t| format!("{t},{},{}", force(t), motion(t)[1] + at(t)));
    let measured = record(&text.replace("displacement", "velocity"), &rig()).unwrap();
    assert!((0.9..1.1).contains(&(measured.velocity_error / 1e-4)), "{}", measured.velocity_error);
    // Noise of 1e-7 m: the slope of fifth degree through seven samples of 1 ms has sqrt(4214 / 3600) of it per ms.
    let text = file(|t| format!("{t},{},{}", force(t), motion(t)[0] + 1e-3 * at(t)));
    let short = record(&text, &Setup { window: Some(0.0065), ..rig() }).unwrap();
    assert!((0.5..2.0).contains(&(short.velocity_error / 1.08e-4)), "{}", short.velocity_error);
}

#[test]
fn a_measured_velocity_is_taken_as_it_is() {
    let text = file(|t| format!("{t},{},{}", force(t), motion(t)[1])).replace("displacement", "velocity");
    let record = record(&text, &rig()).unwrap();
    assert!(!record.is_differentiated);
    assert!(record.time.iter().zip(&record.velocity).all(|(t, v)| *v == motion(*t)[1]));
    let travelled = record.displacement.iter().fold(0.0, |most: f64, x| most.max(*x));
    assert!((travelled - 2.0 * AMPLITUDE).abs() < 1e-7, "{travelled}");
}

/// A camera of 100 Hz whose clock is 12.3 ms late and gains 0.2 ms per second.
#[test]
fn delay_and_drift_between_two_clocks_are_found() {
    let text = file(|t| format!("{t},{},0", force(t)));
    let forces = Sheet::parse(&text.replace("displacement", "nothing")).unwrap();
    let camera = (0..830).map(|k| f64::from(k) * 0.01 - 0.1).fold("time,displacement\n".to_owned(), |text, t| {
        let shown = t + 0.0123 + 2e-4 * (t - 4.0);
        text + &format!("{shown},{}\n", motion(t)[0])
    });
    let camera = Sheet::parse(&camera).unwrap();
    let window = Some(0.07);
    let found = Record::of(&forces, Some(&camera), &Setup { delay: Delay::Find(0.05), window, ..rig() }).unwrap();
    let clocks = found.clocks;
    assert!((clocks.delay - 0.0123).abs() < 1e-4, "{clocks:?}");
    assert!((clocks.drift - 2e-4).abs() < 5e-5, "{clocks:?}");
    let worst = |record: &Record| {
        let far = record.time.iter().enumerate().filter(|(_, t)| motion(**t)[1].abs() > 5e-3);
        far.map(|(at, t)| (record.friction_force[at] - friction(*t)).abs()).fold(0.0, f64::max)
    };
    assert!(worst(&found) < 0.01, "{}", worst(&found));
    let ignored = Record::of(&forces, Some(&camera), &Setup { window, ..rig() }).unwrap();
    assert!(worst(&ignored) > 10.0 * worst(&found));
}

#[test]
fn cycles_lie_on_top_of_each_other() {
    let mut random = fastrand::Rng::with_seed(3);
    let noise: Vec<f64> = (0..8000).map(|_| (0..12).map(|_| random.f64()).sum::<f64>() - 6.0).collect();
    let text = file(|t| format!("{t},{},{}", force(t) + 0.1 * noise[(t * 1e3).round() as usize], motion(t)[0]));
    let record = record(&text, &rig()).unwrap();
    assert!((record.quality.noise - 0.1).abs() < 0.01, "{}", record.quality.noise);
    let cycle = average(&record).unwrap();
    assert_eq!(cycle.count, 2);
    assert!((cycle.period - 2.0).abs() < 1e-4, "{}", cycle.period);
    for (phase, force) in cycle.phase.iter().zip(&cycle.friction_force) {
        // The cycle begins with the forward stroke, at t = 2 s.
        assert!((force - friction(2.0 + 2.0 * phase)).abs() < 0.4 || phase.min(1.0 - phase) < 0.01, "{phase}: {force}");
    }
    let spread = cycle.deviation.iter().sum::<f64>() / cycle.deviation.len() as f64;
    // Interpolation between two samples has less noise than one; the mean of |z| of two cycles is 0.8 sigma.
    assert!((0.04..0.1).contains(&spread), "{spread}");
}

/// Two frequencies: each stroke has another length, and their mean would be a motion and a friction that never were.
#[test]
fn strokes_of_different_lengths_have_no_mean() {
    let sine =
        |t: f64, size: f64, rate: f64| [size * (TAU * rate * t).sin(), size * TAU * rate * (TAU * rate * t).cos()];
    let motion = |t: f64| [0, 1].map(|order| sine(t, 1e-2, 0.8)[order] + sine(t, 5e-3, 2.3)[order]);
    let text = file(|t| format!("{t},{},{}", 4.0 * motion(t)[1].signum(), motion(t)[0]));
    let record = record(&text, &Setup { mass: 0.0, ..rig() }).unwrap();
    assert!(record.quality.reversals > 10);
    assert_eq!(average(&record), None);
}

#[test]
fn what_is_missing_in_a_record_is_named() {
    let findings = |text: &str| record(text, &rig()).unwrap().quality.findings.join("\n");
    let forward = (0..200).fold("time,force,displacement\n".to_owned(), |mut text, k| {
        let _ = writeln!(text, "{},{},{}", k, 4.0 + 1e-3 * f64::from(k % 3), 0.01 * f64::from(k));
        text
    });
    assert!(findings(&forward).contains("no reversal"));
    let slow = (0..400).fold("time,force,displacement\n".to_owned(), |mut text, k| {
        let t = f64::from(k) * 0.05;
        let _ = writeln!(text, "{t},{},{}", force(t).clamp(-3.9, 3.9), motion(t)[0]);
        text
    });
    let text = findings(&slow);
    assert!(text.contains("samples per reversal") && text.contains("is the load cell saturated?"), "{text}");
    let gap = file(|t| format!("{t},{},{}", force(t), motion(t)[0]));
    let gap: Vec<&str> = gap.lines().enumerate().filter(|(n, _)| !(3000..3100).contains(n)).map(|(_, l)| l).collect();
    assert!(findings(&gap.join("\n")).contains("a gap of 0.101 s at 2.998 s"));
}

/// A good row, repeated with ascending times.
fn rows(heading: &str, row: impl Fn(usize) -> String) -> String {
    (0..40).fold(heading.to_owned() + "\n", |text, k| text + &row(k) + "\n")
}

fn good(k: usize) -> String {
    let t = k as f64 * 0.05;
    format!("{t},{},{}", force(t), motion(t)[0])
}

fn spoil(at: usize, row: &str) -> String {
    rows("time,force,displacement", |k| if k == at { row.to_owned() } else { good(k) })
}

/// Each text is refused, with these words.
fn assert_refused(cases: &[(String, &str)]) {
    for (text, wanted) in cases {
        let refused = record(text, &rig()).map_or_else(|error| error.to_string(), |_| "accepted".to_owned());
        assert!(refused.contains(wanted), "{refused}\n instead of\n{wanted}\nin\n{text}");
    }
}

#[test]
fn spoilt_headings_are_refused_by_name() {
    let plain = |heading: &str| rows(heading, good);
    assert_refused(&[
        (String::new(), "no column 'time'; there are no columns"),
        ("time\n".into(), "0 samples; at least 20 are needed"),
        (plain("t,force,displacement"), "no column 'time'; there are t, force, displacement"),
        (plain("time,F,displacement"), "no column 'force'; there are time, F, displacement"),
        (plain("time_ms,force_N,x"), "there are time_ms, force_N, x; units stand in brackets: 'time [ms]' instead of"),
        (plain("time,force,x"), "no column 'displacement'; there are time, force, x"),
        (plain("time,time,displacement"), "two columns 'time'"),
        (plain("time,force,Force"), "two columns 'force'"),
        (plain("time [h],force,displacement"), "time: unit 'h', must be one of s, sec, ms, us, ns, min"),
        (plain("time,force [kg],displacement"), "force: unit 'kg', must be one of N, kN, lbf, lb"),
        (plain("time,force,displacement (ft)"), "displacement: unit 'ft', must be one of m, mm, um, in"),
        (plain("time,force [mm],displacement"), "force: unit 'mm', must be one of N, kN, lbf, lb"),
    ]);
}

#[test]
fn spoilt_numbers_are_refused_with_line_and_column() {
    assert_refused(&[
        (spoil(3, "0.15,,0.1"), "line 5, force: '' is not a finite number"),
        (spoil(3, "0.15,abc,0.1"), "line 5, force: 'abc' is not a finite number"),
        (spoil(3, "0.15,NaN,0.1"), "line 5, force: 'NaN' is not a finite number"),
        (spoil(3, "0.15,inf,0.1"), "line 5, force: 'inf' is not a finite number"),
        (spoil(3, "0.15,1e999,0.1"), "line 5, force: '1e999' is not a finite number"),
        (spoil(3, "0.15,1,-"), "line 5, displacement: '-' is not a finite number"),
        (spoil(3, "0.15,1,#N/A"), "line 5, displacement: '#N/A' is not a finite number"),
        (spoil(3, "0:15,1,0.1"), "line 5, time: '0:15' is not a finite number"),
        (spoil(3, "0.15,1;5,0.1"), "line 5, force: '1;5' is not a finite number"),
        (spoil(3, "0.15,0x10,0.1"), "line 5, force: '0x10' is not a finite number"),
        (spoil(3, "0.15,1 000,0.1"), "line 5, force: '1 000' is not a finite number"),
        (spoil(3, "0.15,--1,0.1"), "line 5, force: '--1' is not a finite number"),
        (spoil(3, "0.15,1 N,0.1"), "line 5, force: '1 N' is not a finite number"),
        (spoil(3, "0.15,\"1\n2\",0.1"), "line 5, force: '1\n2' is not a finite number"),
    ]);
}

#[test]
fn spoilt_tables_are_refused_with_line_and_column() {
    let plain = |heading: &str| rows(heading, good);
    assert_refused(&[
        (spoil(3, "0.15,1"), "no table: line 5, columns: 2, must be 3 as in the heading"),
        (
            spoil(3, "0.15,1,5,0.1"),
            "no table: line 5, columns: 4, must be 3 as in the heading; if its numbers have decimal commas",
        ),
        (spoil(3, "time,force,displacement"), "line 5, time: 'time' is not a finite number"),
        (spoil(0, "Zeit,Kraft,Weg"), "line 2, time: 'Zeit' is not a finite number"),
        (spoil(0, "s,N,furlong"), "displacement: unit 'furlong', must be one of m, mm, um, in"),
        (spoil(3, "0.1,1,0.1"), "line 5, time: 0.1 s after 0.1 s; times must ascend"),
        (spoil(3, "-1,1,0.1"), "line 5, time: -1 s after 0.1 s; times must ascend"),
        (rows("time,force,displacement", |_| good(0)), "line 3, time: 0 s after 0 s; times must ascend"),
        (rows("time,force,displacement", |k| good(40 - k)), "line 3, time: 1.95"),
        (rows("time,force,displacement", |k| format!("{k},2.5,{k}")), "force: all values are 2.5"),
        (rows("time,force,displacement", |k| format!("{k},{k},7")), "displacement: all values are 7"),
        (rows("time,force,velocity", |k| format!("{k},{k},0")), "displacement: all values are 0"),
        (
            rows("time,force,displacement,normal_force", |k| format!("{},{}", good(k), 3 - k as i32)),
            "line 6, normal_force: -1 N; must be >= 0",
        ),
        (
            rows("time,force,displacement,normal_force", |k| good(k) + ",x"),
            "line 2, normal_force: 'x' is not a finite number",
        ),
        (
            rows("time,force,displacement,normal_force [m]", |k| good(k) + ",1"),
            "normal_force: unit 'm', must be one of N, kN, lbf, lb",
        ),
        (good(0) + "\n" + &good(1), "no column 'time'; there are 0, "),
        ("time,force,displacement\n0,1,0\n1,1,1\n".into(), "2 samples; at least 20 are needed"),
        (plain("time;force;displacement"), "no table: line 2, columns: 1, must be 3"),
        ("\u{0}\u{1}\u{2}PK\u{3}\u{4}".into(), "no column 'time'"),
        ("<html><body>404</body></html>".into(), "no column 'time'"),
        ("{\"time\": [0, 1]}".into(), "no column 'time'"),
        (rows("time,force,displacement", |k| format!("{k},{},{k}", -4.0 - 0.1 * k as f64)), "friction gives "),
        (plain("time,force,displacement\n\""), "no table: line 2, columns: 1, must be 3"),
    ]);
}

#[test]
fn files_that_are_absent_or_huge_are_refused() {
    let absent = Sheet::load(std::path::Path::new("absent.csv")).unwrap_err().to_string();
    assert!(absent.starts_with("absent.csv: "), "{absent}");
    let huge = tempfile::NamedTempFile::new().unwrap();
    huge.as_file().set_len(10_000_000_000).unwrap();
    let refused = Sheet::load(huge.path()).unwrap_err().to_string();
    assert!(refused.contains("has 10000000000 bytes, must be at most 1073741824"), "{refused}");
}

/// An axis of 100 kg, 50 N s/m and 5 N: the inertia of the mass, which is not known yet, is far above its friction.
#[test]
fn inertia_of_an_unknown_mass_does_not_drive_an_axis() {
    let (amplitude, rate) = (0.08, TAU);
    let text = |sign: f64| {
        let rows = (0..2500).map(|k| f64::from(k) / 100.0).map(|t| {
            let (sine, cosine) = (rate * t).sin_cos();
            let v = amplitude * rate * cosine;
            let force = -100.0 * amplitude * rate * rate * sine + 50.0 * v + 5.0 * v.signum();
            format!("{t},{},{}\n", sign * force, amplitude * sine)
        });
        "time,force,displacement\n".to_owned() + &rows.collect::<String>()
    };
    // As short as is tried: 9 samples.
    let rig = Setup { is_axis: true, window: Some(0.09), normal_force: Some(1.0), ..Setup::default() };
    assert!(record(&text(1.0), &rig).is_ok());
    let Err(MeasuredError::Drives { energy, .. }) = record(&text(-1.0), &rig) else { panic!("accepted") };
    // Work of both in 25 cycles; the filter takes some of the motion, and the ends.
    let (viscous, dry) = (50.0 * (amplitude * rate).powi(2) / 2.0 * 25.0, 5.0 * 4.0 * amplitude * 25.0);
    assert!((0.9..1.0).contains(&(energy / (viscous + dry))), "{energy}");
}

/// A slider at rest, seen by a sensor with noise or by an encoder between two counts, has neither velocity nor friction.
#[test]
fn noise_of_a_slider_at_rest_is_no_motion() {
    let mut random = fastrand::Rng::with_seed(1);
    for (name, unit, quantum) in [("displacement", "m", 1e-12), ("velocity", "m/s", 1e-12), ("displacement", "m", 1e-7)]
    {
        let rows = (0..4000).map(|k| {
            let mut white = || (0..12).map(|_| random.f64()).sum::<f64>() - 6.0;
            let [force, noise] = [0.03 * white(), 1e-7 * white()];
            format!("{},{force},{}\n", f64::from(k) * 1e-3, (noise / quantum).round() * quantum)
        });
        let text = format!("time,force,{name}\n") + &rows.collect::<String>();
        let refused = record(&text, &rig()).map(|_| ()).unwrap_err().to_string();
        assert!(
            refused.starts_with(&format!("{name}: its range, ")) && refused.ends_with("nothing moves"),
            "{refused}"
        );
        assert!(refused.contains(&format!(" {unit}, is that of its noise (")), "{refused}");
    }
}

/// With what was understood of the motion.
#[test]
fn friction_that_drives_the_slider_speaks_of_units() {
    let refused = |number: usize, name: &str| {
        let text = file(|t| format!("{t},{},{}", -force(t), 1e3 * motion(t)[number])).replace("displacement", name);
        record(&text, &rig()).map(|_| ()).unwrap_err().to_string()
    };
    let fastest = 1e3 * (0..8000).map(|k| motion(f64::from(k) * 1e-3)[1].abs()).fold(0.0, f64::max);
    let measured = refused(1, "velocity");
    let expected =
        format!("at up to {fastest:.4} m/s: force and velocity are positive in opposite directions, or a unit");
    assert!(measured.contains(&expected), "{measured}");
    assert!(refused(0, "displacement").contains("m/s: force and displacement are positive in opposite directions"));
}

/// An axis without viscous friction, with a coarse encoder: no part of zero is reported.
#[test]
fn no_shift_is_told_of_a_friction_that_there_is_not() {
    let text = |viscous: f64| {
        let rows = (0..2500).map(|k| f64::from(k) / 100.0).map(|t| {
            let (sine, cosine) = (TAU * t).sin_cos();
            let (x, v) = (0.08 * sine, 0.08 * TAU * cosine);
            let force = -100.0 * TAU * TAU * x + viscous * v + 5.0 * v.signum();
            format!("{t},{force},{}\n", (x / 1e-3).round() * 1e-3)
        });
        "time,force,displacement\n".to_owned() + &rows.collect::<String>()
    };
    let findings = |viscous: f64| {
        let rig = Setup { is_axis: true, normal_force: Some(1.0), delay: Delay::OfController, ..Setup::default() };
        record(&text(viscous), &rig).unwrap().quality.findings.join("; ")
    };
    let [without, with] = [0.0, 200.0].map(findings);
    assert!(!without.contains("viscous friction"), "{without}");
    assert!(with.contains("may shift") && with.contains("viscous friction by "), "{with}");
}

#[test]
fn impossible_rigs_are_refused() {
    let text = file(|t| format!("{t},{},{}", force(t), motion(t)[0]));
    let cases = [
        (Setup { mass: -1.0, ..rig() }, "mass = -1: must be >= 0 and finite, in kg"),
        (Setup { mass: f64::NAN, ..rig() }, "mass = NaN: must be >= 0 and finite, in kg"),
        (Setup { normal_force: Some(-2.0), ..rig() }, "normal_force = -2: must be >= 0 and finite, in N"),
        (Setup { window: Some(-1.0), ..rig() }, "window = -1: must be >= 0 and finite, in s"),
        (
            Setup { window: Some(0.0005), ..rig() },
            "window = 0.0005: must be at least 0.0065 s for the intervals of the",
        ),
        (
            Setup { window: Some(0.0005), is_axis: true, ..rig() },
            "window = 0.0005: must be at least 0.003 s for the intervals of the file",
        ),
        (Setup { window: Some(5.0), ..rig() }, "window = 5: must be at most half of the record, 3.9995 s"),
        (Setup { delay: Delay::Find(4.0), ..rig() }, "longest delay = 4: must be at most half of the record, 3.9995 s"),
        (Setup { delay: Delay::Find(0.0), ..rig() }, "longest delay = 0: must be > 0, in s"),
        (Setup { delay: Delay::Known(f64::INFINITY), ..rig() }, "delay = inf: must be a finite number, in s"),
        (
            Setup { skip: 7.995, ..rig() },
            "skip = 7.995: must be short enough to leave at least 20 samples before 7.999 s",
        ),
        (
            Setup { skip: 100.0, ..rig() },
            "skip = 100: must be short enough to leave at least 20 samples before 7.999 s",
        ),
        (Setup { delay: Delay::Known(9.0), ..rig() }, "they do not overlap"),
        (Setup { normal_force: None, ..rig() }, "no column 'normal_force', and no value was given for it"),
    ];
    for (rig, wanted) in cases {
        let refused = record(&text, &rig).map(|_| ()).unwrap_err().to_string();
        assert!(refused.contains(wanted), "{refused} instead of {wanted}");
    }
}

/// A fast and rough motion comes before the one that is looked at.
#[test]
fn what_is_skipped_chooses_no_window() {
    let rough = |t: f64| if t < 2.0 { 1e-3 * (TAU * 50.0 * t).sin() } else { 0.0 };
    let text = file(|t| format!("{t},{},{:.6}", force(t), motion(t)[0] + rough(t)));
    let skipped = record(&text, &Setup { skip: 2.5, ..rig() }).unwrap();
    let mut lines: Vec<&str> = text.lines().collect();
    lines.drain(1..2501);
    let cut = record(&lines.join("\n"), &rig()).unwrap();
    assert!((skipped.window / cut.window - 1.0).abs() < 1e-9);
    assert!((skipped.acceleration_window / cut.acceleration_window - 1.0).abs() < 1e-9);
    assert!((skipped.velocity_error / cut.velocity_error - 1.0).abs() < 0.1);
    let whole = record(&text, &rig()).unwrap();
    assert!(whole.window < 0.5 * cut.window, "{} {}", whole.window, cut.window);
    // The filter has samples before what is not skipped.
    assert_eq!(skipped.motion_ends[0], 0.0);
}

/// It stands for the shortest one.
#[test]
fn a_window_of_no_length_has_seven_samples() {
    let text = file(|t| format!("{t},{},{}", force(t), motion(t)[0]));
    let found = record(&text, &Setup { window: Some(0.0), ..rig() }).unwrap();
    assert!([found.window, found.acceleration_window].iter().all(|window| (window - 0.0065).abs() < 1e-9));
}
