//! Laws that hold at rest, in the strut of a quarter car.

use super::tests::solved;

/// Laws that carry at rest what the rest of the strut and the car leave to them.
const HOLDING: [&str; 6] = ["Coulomb", "CoulombStiction", "CoulombViscous", "Stribeck", "Karnopp", "NonReversible"];

/// A car let go on a flat road with its tyre pressed in so little that the strut stays stuck: body and wheel are one mass
/// on the tyre.
#[test]
fn a_stuck_strut_leaves_one_mass_on_the_tyre() {
    let (mass, stiffness, damping, start): (f64, f64, f64, f64) = (52.91 + 16.36, 87563.5, 95.8, 2e-4);
    let decay = damping / (2.0 * mass);
    let w = (stiffness / mass - decay * decay).sqrt();
    let settings = [("car.road_height.amplitude", "0"), ("car.body_height", "0.0002"), ("car.wheel_height", "0.0002")];
    for law in HOLDING {
        let run = solved("quarter-car", law, &settings, 1e-9, &["car.body_height", "strut.velocity"]);
        for (at, time) in run.time.iter().enumerate() {
            let [height, velocity] = [0, 1].map(|column| run.columns[column].values[at]);
            let (sine, cosine) = (w * time).sin_cos();
            let exact = start * (-decay * time).exp() * (cosine + decay / w * sine);
            assert!((height - exact).abs() < 1e-8, "{law}: {height} m for {exact} m at {time} s");
            assert!(velocity.abs() < 1e-6, "{law}: {velocity} m/s at {time} s");
        }
    }
}

/// On the sine road they stick and slip at the same instants at a loose and at a tight tolerance.
#[test]
fn a_strut_sticks_and_slips_at_the_same_instants_at_every_tolerance() {
    for law in ["CoulombStiction", "Stribeck", "NonReversible"] {
        let [loose, tight] = [1e-4, 1e-8]
            .map(|tolerance| solved("quarter-car", law, &[], tolerance, &["strut.length"]).statistics.events);
        assert!(loose.len() == tight.len() && tight.len() > 50, "{law}: {} and {}", loose.len(), tight.len());
        for (loose, tight) in loose.iter().zip(&tight) {
            assert!((loose.time - tight.time).abs() < 1e-3, "{law}: {} and {} s", loose.time, tight.time);
        }
    }
}

/// The same car with a rubber top mount, elastic only: with a stuck strut the rod moves with the wheel, and the rubber joins
/// both to the body. Their linear equations by the classical Runge-Kutta method.
#[test]
fn a_stuck_strut_leaves_its_top_mount_between_body_and_wheel() {
    let ([body, wheel, rod], ratio): ([f64; 3], f64) = ([52.91, 16.36, 0.3], 1.011);
    let (tyre, damping, rubber) = (87563.5, 95.8, 5e5 * ratio * ratio);
    let rates = |[z_s, z_u, v_s, v_u]: [f64; 4]| {
        let (pull, push) = (rubber * (z_u - z_s), -tyre * z_u - damping * v_u);
        [v_s, v_u, pull / body, (push - pull) / (wheel + rod * ratio * ratio)]
    };
    let every = 20;
    let h = 1e-3 / f64::from(every);
    let (mut at, mut heights) = ([2e-4, 2e-4, 0.0, 0.0], vec![[2e-4; 2]]);
    for step in 1..=5000 * every {
        let ahead = |k: [f64; 4], share: f64| std::array::from_fn(|i| at[i] + share * h * k[i]);
        let k_1 = rates(at);
        let k_2 = rates(ahead(k_1, 0.5));
        let k_3 = rates(ahead(k_2, 0.5));
        let k_4 = rates(ahead(k_3, 1.0));
        at = std::array::from_fn(|i| at[i] + h / 6.0 * (k_1[i] + 2.0 * (k_2[i] + k_3[i]) + k_4[i]));
        if step % every == 0 {
            heights.push([at[0], at[1]]);
        }
    }
    let settings = [
        ("car.road_height.amplitude", "0"),
        ("car.body_height", "0.0002"),
        ("car.wheel_height", "0.0002"),
        ("mount.rod_position", "0.0002022"),
        ("rubber.F_max", "0"),
        ("rubber.k_v", "0"),
    ];
    for law in HOLDING {
        let results = ["car.body_height", "car.wheel_height", "strut.velocity"];
        let run = solved("quarter-car-mount", law, &settings, 1e-9, &results);
        for (at, exact) in heights.iter().enumerate() {
            let [body, wheel, velocity] = [0, 1, 2].map(|column| run.columns[column].values[at]);
            let error = (body - exact[0]).abs().max((wheel - exact[1]).abs());
            assert!(error < 1e-8 && velocity.abs() < 1e-6, "{law} at {at} ms: {error} m, {velocity} m/s");
        }
    }
}

/// With rubber 2,000 times as stiff the car moves as with a rigid mount and a body that is heavier by the rod.
#[test]
fn a_stiff_top_mount_is_none() {
    let settings = [("rubber.k_e", "1e9"), ("rubber.k_v", "0"), ("rubber.F_max", "0")];
    for law in ["CoulombStiction", "LuGre"] {
        let height = |name: &str, settings: &[(&str, &str)]| {
            solved(name, law, settings, 1e-8, &["car.body_height"]).columns[0].values.clone()
        };
        let (rigid, mounted) =
            (height("quarter-car", &[("car.body_mass", "53.21")]), height("quarter-car-mount", &settings));
        let error = rigid.iter().zip(&mounted).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max);
        let largest = rigid.iter().fold(0.0, |largest: f64, height| largest.max(height.abs()));
        assert!(error < 2e-3 * largest, "{law}: {error} m of {largest} m");
    }
}
