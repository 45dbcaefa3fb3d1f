//! A mass that a component stops, solved by its rates and events, against closed forms and the balance of energy.

use std::path::PathBuf;

use stribeck::numerics::root::bisect;
use stribeck_solve::run::{Outcome, Settings, run};
use stribeck_solve::system::{Description, Setting, Source, System};

/// Solves a system to a tolerance of 1e-10.
fn solved(text: &str, shown: &[String]) -> Outcome {
    let description = Description::parse(text).unwrap();
    let system = System::assemble(&Source { description, folder: PathBuf::new() }, None, &[]).unwrap();
    let settings = Settings { tolerance: 1e-10, ..Settings::of(&system) };
    run(&system, &settings, shown).unwrap()
}

/// A free mass of 1 kg at this speed, and a component between it and the ground.
fn stopped(component: &str, speed: f64, set: &str, input: &str, until: f64) -> Outcome {
    let text = format!(
        "title = \"mass\"\nuntil = {until}\nevery = {}\n\
         [part.mass]\nmodel = \"PulledMass\"\n[part.mass.set]\nstiffness = 0.0\nvelocity = {speed}\n\
         [part.stop]\nmodel = \"{component}\"\n[part.stop.set]\n{set}\n\
         [connect]\n\"mass.friction_force\" = \"stop.friction_force\"\n\"stop.velocity\" = \"mass.velocity\"\n\
         [input]\n\"mass.pull_velocity\" = 0.0\n{input}\n",
        until / 1000.0
    );
    let shown =
        ["mass.position", "mass.velocity", "stop.displacement", "stop.dissipated_energy", "stop.friction_force"];
    let mut shown: Vec<String> = shown.map(str::to_owned).to_vec();
    if component == "RubberMount" {
        shown.push("stop.turning_share".to_owned());
    }
    solved(&text, &shown)
}

/// Checks that the component has taken the energy that the mass has lost, and has followed the mass.
fn assert_balance(outcome: &Outcome, speed: f64) {
    let of = |name: &str| outcome.values(name).unwrap();
    let motion = of("mass.velocity").iter().zip(of("stop.dissipated_energy"));
    for (velocity, energy) in motion {
        let missing = 0.5 * (speed * speed - velocity * velocity) - energy;
        assert!(missing.abs() < 1e-7 * speed * speed, "{missing} J");
    }
    for (mass, component) in of("mass.position").iter().zip(of("stop.displacement")) {
        assert!((mass - component).abs() < 1e-9, "{mass} {component}");
    }
}

/// Shares of the friction at the turning points of a mass of 1 kg on a spring and Berg's friction, from the balance of
/// energy between two turning points: with the share f at the last one, the friction takes
/// `F_max (d - x_2 (1 + f)^2 ln(1 + d / (x_2 (1 + f))))` over the distance d to the next.
fn turning_shares(speed: f64, count: usize) -> Vec<f64> {
    let (stiffness, f_max, x_2) = (5e5, 100.0, 2e-4);
    let spring = |x: f64| 0.5 * stiffness * x * x;
    let first = bisect(|x| spring(x) + f_max * (x - x_2 * (x / x_2).ln_1p()) - 0.5 * speed * speed, 0.0, 1.0);
    let (mut x, mut share) = (first, first / (x_2 + first));
    let mut shares = vec![share];
    while shares.len() < count {
        let length = x_2 * (1.0 + share);
        let taken = |d: f64| f_max * (d - length * (1.0 + share) * (d / length).ln_1p());
        // Past the middle the energy missing grows with the distance.
        let distance = bisect(|d| spring(d - x) + taken(d) - spring(x), x, 2.0 * x);
        (x, share) = (distance - x, 1.0 - (1.0 + share) / (1.0 + distance / length));
        shares.push(share);
    }
    shares
}

#[test]
fn a_mass_on_a_rubber_mount_turns_where_the_energy_says() {
    let outcome = stopped("RubberMount", 0.3, "k_v = 0.0", "", 0.03);
    assert_balance(&outcome, 0.3);
    let mut found: Vec<f64> = outcome.values("stop.turning_share").unwrap().to_vec();
    found.dedup();
    assert_eq!(found.remove(0), 0.0);
    let expected = turning_shares(0.3, found.len());
    assert!(found.len() >= 5 && outcome.events.len() == found.len(), "{found:?}");
    for (turn, (found, expected)) in found.iter().zip(expected).enumerate() {
        let sign = if turn % 2 == 0 { 1.0 } else { -1.0 };
        assert!((found - sign * expected).abs() < 1e-7, "turn {turn}: {found} {expected}");
    }
}

#[test]
fn a_mass_in_a_magnetorheological_damper_loses_what_the_damper_takes() {
    for voltage in [0.0, 1.5] {
        let outcome =
            stopped("MagnetorheologicalDamper", 0.5, "k_1 = 0.0", &format!("\"stop.voltage\" = {voltage:?}"), 0.05);
        assert_balance(&outcome, 0.5);
        let taken = *outcome.values("stop.dissipated_energy").unwrap().last().unwrap();
        assert!(taken > 0.9 * 0.125, "{voltage} V: {taken} J");
    }
}

/// A mass of 1 kg at 0.2 m/s that pulls a load of 4 N over two bends, with mu phi = 0.8 together, and beside them one
/// bend with this sum. All ropes slide already.
const ROPE_DRIVE: &str = r#"
title = "rope drive"
until = 0.1
every = 1e-4
[part.mass]
model = "PulledMass"
[part.mass.set]
stiffness = 0.0
velocity = 0.2
[part.first]
model = "Capstan"
[part.first.set]
mu_k = 0.2
wrap_angle = 1.0
relaxation_distance = 5e-4
friction_share = 1.0
[part.second]
model = "Capstan"
[part.second.set]
mu_k = 0.3
wrap_angle = 2.0
relaxation_distance = 5e-4
friction_share = 1.0
[part.whole]
model = "Capstan"
[part.whole.set]
mu_k = 0.4
wrap_angle = 2.0
relaxation_distance = 5e-4
friction_share = 1.0
[connect]
"first.velocity" = "mass.velocity"
"second.velocity" = "mass.velocity"
"whole.velocity" = "mass.velocity"
"second.tension_1" = "first.tension_2"
"mass.friction_force" = "second.tension_2"
[input]
"mass.pull_velocity" = 0.0
"first.tension_1" = 4.0
"whole.tension_1" = 4.0
"#;

/// Work of the rope on the mass that it pulls back by a distance, from the turn: the integral of
/// `T exp(a (2 exp(-y / d) - 1))`.
fn work_on_the_way_back(distance: f64) -> f64 {
    let (exponent, tension, d) = (0.8, 4.0, 5e-4);
    let (mut power, mut series) = (1.0, 0.0);
    for k in 1..40 {
        let k = f64::from(k);
        power *= 2.0 * exponent / k;
        series -= power / k * (-k * distance / d).exp_m1();
    }
    tension * f64::exp(-exponent) * (distance + d * series)
}

/// Against closed forms: the mass slows down by the tension of a sliding rope, and is then pulled back by one whose
/// friction turns over.
#[test]
fn a_mass_pulls_a_load_over_two_bends_as_over_one() {
    let names = ["mass.position", "mass.velocity", "second.tension_2", "whole.tension_2"];
    let energies = ["first.dissipated_energy", "second.dissipated_energy", "whole.dissipated_energy"];
    let outcome = solved(ROPE_DRIVE, &names.iter().chain(&energies).map(|name| (*name).to_owned()).collect::<Vec<_>>());
    let of = |name: &str| outcome.values(name).unwrap();
    let pull = 4.0 * 0.8f64.exp();
    let farthest = 0.2 * 0.2 / (2.0 * pull);
    let (mut forwards, mut longest) = (0, 0.0f64);
    for (row, (position, velocity)) in of(names[0]).iter().zip(of(names[1])).enumerate() {
        if *velocity > 0.0 {
            let expected = 0.2 - pull * 1e-4 * row as f64;
            assert!((velocity - expected).abs() < 1e-8, "{velocity} {expected}");
            forwards += 1;
        } else {
            let distance = farthest - position;
            let expected = -(2.0 * work_on_the_way_back(distance)).sqrt();
            assert!((velocity - expected).abs() < 1e-6, "{velocity} {expected}");
            longest = longest.max(distance);
        }
        let [two, one] = [of(names[2])[row], of(names[3])[row]];
        assert!((two - one).abs() < 1e-9, "{two} {one}");
        let [first, second, whole] = energies.map(|name| of(name)[row]);
        assert!((first + second - whole).abs() < 1e-9, "{first} {second} {whole}");
        let missing = 0.5 * (0.2 * 0.2 - velocity * velocity) - 4.0 * position - whole;
        assert!(missing.abs() < 1e-8, "{missing} J");
    }
    assert!(forwards > 200 && longest > 4e-3, "{forwards} {longest}");
}

/// A quarter car whose strut has the mount inside; otherwise as the built-in system with a mount of its own.
const MOUNTED: &str = r#"
title = "strut with a mount"
until = 0.5
every = 1e-3
[part.car]
model = "QuarterCar"
[part.strut]
model = "ShockAbsorber"
[part.strut.set]
"mount.enabled" = true
"mount.mass" = 0.01
"mount.preload" = 1325.2555
[connect]
"car.strut_force" = "strut.force"
"car.rod_force" = "strut.rod_force"
"car.force_without_friction" = "strut.force_without_friction"
"strut.length" = "car.length"
"strut.velocity" = "car.velocity"
[input]
"car.road_height" = { sine = { amplitude = 0.002, frequency = 10.0 } }
"car.road_velocity" = { rate-of = "car.road_height" }
"strut.external_force" = 0.0
"strut.side_force_m" = 0.0
"strut.side_force_n" = 0.0
"strut.side_moment_m" = 0.0
"strut.side_moment_n" = 0.0
"strut.spin_rate" = 0.0
"strut.temperature_ambient" = 293.15
"#;

/// Strut and mount as one model, and as the parts of the built-in system, where the inertia of the rod is that against
/// the ground and not that against the body: they differ by the ratio of its mass to that of the body.
#[test]
fn a_mount_in_the_strut_is_the_mount_behind_it() {
    let shown = ["car.body_height", "car.wheel_height"].map(str::to_owned);
    let inside = solved(MOUNTED, &shown);
    let settings = [("mount.mass", "0.01"), ("car.road_height.frequency", "10")];
    let settings = settings.map(|(name, value)| Setting { name: name.to_owned(), value: value.to_owned() });
    let source = Source::open("quarter-car-mount").unwrap();
    let system = System::assemble(&source, Some("LuGre"), &settings).unwrap();
    let settings = Settings { tolerance: 1e-10, until: 0.5, every: 1e-3, ..Settings::of(&system) };
    let behind = run(&system, &settings, &shown).unwrap();
    for name in &shown {
        let [inside, behind] = [&inside, &behind].map(|outcome| outcome.values(name).unwrap());
        let largest = behind.iter().fold(0f64, |largest, height| largest.max(height.abs()));
        assert_eq!(inside.len(), behind.len());
        for (k, (a, b)) in inside.iter().zip(behind).enumerate() {
            assert!((a - b).abs() < 3.0 * 0.01 / 52.91 * largest, "{name} at {k} ms: {a} {b} of {largest}");
        }
    }
}
