//! Components: led by what their tables declare, from the displacement at which a record begins.

use std::f64::consts::TAU;
use std::path::Path;

use super::*;
use stribeck_sheet::{Sheet, SheetError};

/// A record as a text.
struct Text(String);

impl Source for Text {
    fn tables(&self, _: &Path, _: Option<&str>) -> Result<Vec<Sheet>, SheetError> {
        Ok(vec![Sheet::parse(&self.0)?])
    }
}

/// A record of 2 s at 500 Hz of a body that moves from `start` along a sine from rest; `row` has the force at a time,
/// a displacement and a velocity, and what stands behind both.
fn record(heading: &str, start: f64, row: impl Fn(f64, [f64; 2]) -> String) -> Text {
    let rows = (0..1000).map(|k| f64::from(k) * 2e-3).map(|t| {
        let (sine, cosine) = (TAU * t).sin_cos();
        let (x, v) = (start + 2e-3 * (1.0 - cosine), 2e-3 * TAU * sine);
        format!("{t},{x},{}\n", row(t, [x, v]))
    });
    Text(format!("time [s],displacement [m],{heading}\n") + &rows.collect::<String>())
}

fn asked(law: &str, fix: &[(&str, f64)]) -> Inquiry {
    let fix = fix.iter().map(|(name, value)| stribeck_solve::job::Entry((*name).to_owned(), *value)).collect();
    Inquiry {
        records: vec!["record.csv".into()],
        law: vec![law.into()],
        repetitions: Some(0),
        fix,
        ..Inquiry::default()
    }
}

fn found(asked: &Inquiry, record: &Text) -> Fit {
    let data = asked.data(record).unwrap();
    asked.fits(&data, &mut |_| {}, super::tests::quiet()).unwrap().best().clone()
}

fn refusal(asked: &Inquiry, record: &Text) -> String {
    asked.data(record).unwrap_err().to_string()
}

/// An elastic mount far from its rest: the force begins with that displacement.
#[test]
fn a_mount_is_fitted_from_the_displacement_of_its_record() {
    let ripple = |t: f64| 0.3 * (1e4 * t * t).sin();
    let record = record("force [N]", 5e-3, |t, [x, _]| (3e5 * x + ripple(t)).to_string());
    let fit = found(&asked("RubberMount", &[("F_max", 0.0), ("x_2", 1e-3), ("k_v", 0.0), ("c", 1.0)]), &record);
    let one = super::tests::estimate(&fit, "k_e");
    assert!(one.verdict == Verdict::Determined && (one.value / 3e5 - 1.0).abs() < 1e-3, "{one:?}");
    assert!(fit.residuals.rms < 0.5, "{}", fit.residuals.rms);
    assert!(fit.parameter_set("mount").is_ok());
    for format in Format::ALL {
        let refused = fit.exported(format.1, &[]).unwrap_err().to_string();
        assert!(refused.starts_with("RubberMount: ") && refused.contains(".csv or .ssv"), "{refused}");
    }
}

/// An input has to be measured or held, and a normal force is refused where no model has one.
#[test]
fn an_input_is_a_column_or_is_held() {
    let plain = record("force [N]", 0.0, |_, [_, v]| (1000.0 * v).to_string());
    let law = "MagnetorheologicalDamper";
    let text = refusal(&asked(law, &[]), &plain);
    let expected = "no column 'voltage'; there are time, displacement, force: it drives MagnetorheologicalDamper, in V; \
                    --column voltage=NAME names it, --fix voltage=VALUE holds it";
    assert!(text.ends_with(expected), "{text}");
    assert!(asked(law, &[("voltage", 1.0)]).data(&plain).is_ok());
    let with_voltage = record("force [N],voltage [mV]", 0.0, |t, [_, v]| format!("{},{}", 1000.0 * v, 500.0 * t));
    let data = asked(law, &[]).data(&with_voltage).unwrap();
    let voltage = data.experiments[0].channel("voltage").unwrap();
    assert!((voltage[500] - 0.5).abs() < 1e-12 && voltage.len() == 1000, "{}", voltage[500]);
    // Held by the user, the column does not count.
    let data = asked(law, &[("voltage", 1.0)]).data(&with_voltage).unwrap();
    assert_eq!(data.experiments[0].channel("voltage"), None);
    let loaded = Inquiry { normal_force: Some(3.0), ..asked(law, &[("voltage", 1.0)]) };
    assert_eq!(refusal(&loaded, &plain), "normal_force = 3: MagnetorheologicalDamper has none: leave it out");
    let negative = record("force [N],voltage [V]", 0.0, |t, [_, v]| format!("{},{}", 1000.0 * v, t - 1.0));
    let data = asked(law, &[]).data(&negative).unwrap();
    assert!(asked(law, &[]).fits(&data, &mut |_| {}, super::tests::quiet()).is_err());
    let other = Inquiry { column: vec![stribeck_solve::job::Entry("current".into(), "I".into())], ..asked(law, &[]) };
    assert!(refusal(&other, &plain).contains("voltage"), "{}", refusal(&other, &plain));
}

/// Noise hides the difference between a preload and a steeper growth of the tension. Another tension helps: a rope has no
/// normal force.
#[test]
fn what_helps_a_component_is_another_value_of_its_input() {
    let level = |v: f64| 10.0 * (0.12 * std::f64::consts::PI * v.signum() * f64::from(v != 0.0)).exp_m1();
    let ripple = |t: f64| 0.3 * (1e4 * t * t).sin();
    let record = record("force [N],tension_1 [N]", 0.0, |t, [_, v]| format!("{},10", level(v) + ripple(t)));
    let cheap = Inquiry { budget: Some(60), ..asked("Capstan", &[("relaxation_distance", 1e-6)]) };
    let fit = found(&cheap, &record);
    let verdict = super::tests::estimate(&fit, "preload").verdict.to_string();
    assert!(verdict.ends_with("; add runs with other values of tension_1"), "{verdict}");
}

/// Each input of each component has a unit that files may have.
#[test]
fn every_model_is_led_by_quantities_that_files_have() {
    for led in fittable().flat_map(|law| Ports::of(law).unwrap().led) {
        assert!(stribeck_sheet::Quantity::of(led.name, led.unit).is_some(), "{led:?}");
    }
    let names = |name: &str| {
        let law = catalogue::by_name(name).unwrap();
        Ports::of(law).unwrap().led.into_iter().map(|led| led.name).collect::<Vec<_>>()
    };
    assert_eq!(names("ServoFriction"), ["motor_force", "load_force"]);
    assert_eq!(names("JointFriction"), ["temperature"]);
    assert!(laws().filter(|law| law.name != "JointFriction").all(|law| names(law.name).is_empty()));
}

/// A joint that warms from 20 to 60 degC, at speeds at which friction no longer falls: B = 5 + 8 exp(-(T - 20) / 25).
#[test]
fn a_joint_is_fitted_at_the_temperature_of_its_record() {
    let level = |v: f64| if v == 0.0 { 0.0 } else { 4.0 * v.signum() };
    let force = |t: f64, v: f64| level(v) + 200.0 * (5.0 + 8.0 * (-20.0 * t / 25.0_f64).exp()) * v;
    let ripple = |t: f64| 0.01 * (1e4 * t * t).sin();
    let heading = "force [N],temperature [degC]";
    let warming = record(heading, 0.0, |t, [_, v]| format!("{},{}", force(t, v) + ripple(t), 20.0 + 20.0 * t));
    let held = [("kinetic_force", 0.0), ("excess_force", 0.0)];
    let others =
        [("excess_by_temperature", 0.0), ("stribeck_velocity_unloaded", 1e-6), ("velocity_by_temperature", 0.0)];
    let fix: Vec<(&str, f64)> = held.into_iter().chain(others).collect();
    let tie = vec![stribeck_solve::job::Entry("mu_s".into(), "mu_k".into())];
    let joint = Inquiry { normal_force: Some(20.0), tie, ..asked("JointFriction", &fix) };
    let fit = found(&joint, &warming);
    for (name, truth) in [
        ("mu_k", 0.2),
        ("viscous_coefficient", 1000.0),
        ("viscous_coefficient_cold", 1600.0),
        ("viscous_temperature", 25.0),
    ] {
        let one = super::tests::estimate(&fit, name);
        let [low, high] = one.interval();
        assert!(one.verdict == Verdict::Determined && (low..=high).contains(&truth), "{one:?}");
        assert!((one.value / truth - 1.0).abs() < 0.1, "{one:?}");
    }
    // Without the column nothing tells the warm joint from the cold one, and the record says at what it is taken.
    let blind = record("force [N]", 0.0, |t, [_, v]| force(t, v).to_string());
    let data = joint.data(&blind).unwrap();
    let said = &data.records[0].1.quality.findings;
    let note = "no column temperature [K]: JointFriction has its start value, 293.15 K, unless --fix temperature=VALUE";
    assert!(said.iter().any(|one| one.starts_with(note)), "{said:?}");
    let fit = found(&joint, &blind);
    assert!(fit.estimates.iter().all(|one| one.name != "viscous_temperature"));
    // Colder than the law takes: exp(200 / 20) is above its limit.
    let frozen = record(heading, 0.0, |t, [_, v]| format!("{},-230", force(t, v)));
    let data = joint.data(&frozen).unwrap();
    let law = catalogue::by_name("JointFriction").unwrap();
    let cold = [(law.find("viscous_coefficient_cold").unwrap(), 1.0)];
    let ports = Ports::of(law).unwrap();
    let refused = response::forces(&mut Instance::new(law), &ports, &cold, &data.experiments[0], 1);
    assert!(refused.unwrap_err().to_string().contains("temperature"));
}

/// A map is of one temperature.
#[test]
fn a_column_of_temperatures_in_a_map_is_refused() {
    let rows = (1..30).map(|k| format!("{},{},300\n", 0.01 * f64::from(k), 4.0 + 0.1 * f64::from(k)));
    let map = Text("velocity,force,temperature\n".to_owned() + &rows.collect::<String>());
    let joint = Inquiry { normal_force: Some(20.0), ..asked("JointFriction", &[]) };
    assert!(
        refusal(&joint, &map)
            .ends_with("column temperature: a map is of one temperature; --fix temperature=VALUE holds it, in K")
    );
    let held = Inquiry { fix: asked("", &[("temperature", 300.0)]).fix, ..joint };
    assert!(held.data(&map).is_ok());
}
