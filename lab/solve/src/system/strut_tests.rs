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
