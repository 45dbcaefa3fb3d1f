//! The cars on struts given by a closure, compared with the tables of a reference solution.

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::common::Bench;
use approx::abs_diff_eq;

/// Force of a strut over a step, which begins at this length and velocity.
type Strut<'a> = Box<dyn FnMut(f64, f64, f64) -> f64 + 'a>;

/// A linear spring and a damper with two slopes, without friction: `force_0` at 177.5 mm.
fn spring_and_damper(force_0: f64, stiffness: f64) -> impl FnMut(f64, f64, f64) -> f64 {
    move |length, velocity, _| {
        let damping = if velocity < 0.0 { 1500.0 } else { 2300.0 };
        force_0 - stiffness * (length - 0.1775) - damping * velocity
    }
}

/// The same spring and damper as a `ShockAbsorber` without gas, with a friction that does not depend on the load: LuGre
/// with this kinetic level and a static one 30 % higher, or none.
fn shock_absorber(stiffness: f64, kinetic: f64) -> impl FnMut(f64, f64, f64) -> f64 {
    let mut strut = Bench::new("ShockAbsorber", &[("spring.k", stiffness), ("gas.enabled", 0.0)]);
    for name in ["c1.mu_s", "c1.mu_k", "c2.mu_s", "c2.mu_k", "c2.preload_s", "c2.preload_k"] {
        strut.set(name, 0.0);
    }
    strut.set("c1.preload_s", 1.3 * kinetic);
    strut.set("c1.preload_k", kinetic);
    if kinetic == 0.0 {
        strut.set("friction.model", 1.0);
    }
    move |length, velocity, h| {
        strut.set("length", length);
        strut.set("velocity", velocity);
        strut.step(h);
        strut.get("force")
    }
}

/// Force of that shock absorber at rest.
fn static_force(stiffness: f64) -> f64 {
    150.0 + 0.0225 * stiffness
}

/// A quarter car or one corner of a car: connects strut and road by the names with this prefix.
fn exchange(car: &mut Bench, prefix: &str, road: &str, strut: &mut Strut, now: [f64; 2], next: [f64; 2], h: f64) {
    let name = |rest: &str| format!("{prefix}{rest}");
    let (length, velocity) = (car.get(&name("length")), car.get(&name("velocity")));
    car.set(&name("strut_force"), strut(length, velocity, h));
    for (what, at, after) in [("height", now[0], next[0]), ("velocity", now[1], next[1])] {
        let column = car.column(&name(&format!("{road}_{what}")));
        car.instance.set_column(column, at).unwrap();
        car.instance.set_slope(column, (after - at) / h).unwrap();
    }
}

/// Amplitudes of the first harmonic of body height and wheel-body distance per amplitude of a sinusoidal road.
fn transmissibility(frequency: f64, amplitude: f64, static_force: f64, mut strut: Strut) -> [f64; 2] {
    let mut car = Bench::new("QuarterCar", &[("static_force", static_force)]);
    let (w, periods, per_period) = (TAU * frequency, 8, 4000);
    let h = 1.0 / (frequency * f64::from(per_period));
    let road = |k: i32| {
        let (sine, cosine) = (w * h * f64::from(k)).sin_cos();
        [amplitude * sine, amplitude * w * cosine]
    };
    let mut harmonics = [[0.0; 2]; 2];
    for k in 0..periods * per_period {
        exchange(&mut car, "", "road", &mut strut, road(k), road(k + 1), h);
        car.step(h);
        if k >= (periods - 1) * per_period {
            let (sine, cosine) = (w * h * f64::from(k + 1)).sin_cos();
            let body = car.get("body_height");
            let travel = body - car.get("wheel_height");
            for (harmonic, value) in harmonics.iter_mut().zip([body, travel]) {
                harmonic[0] += 2.0 / f64::from(per_period) * value * cosine;
                harmonic[1] += 2.0 / f64::from(per_period) * value * sine;
            }
        }
    }
    harmonics.map(|[a, b]| a.hypot(b) / amplitude)
}

fn assert_close(what: &str, value: f64, expected: f64, relative: f64) {
    assert!(abs_diff_eq!(value / expected, 1.0, epsilon = relative), "{what}: {value}, expected {expected}");
}

fn assert_transmits(
    expected: &[(f64, f64, f64)],
    tolerance: f64,
    static_force: f64,
    strut: impl Fn() -> Strut<'static>,
) {
    for (frequency, body, travel) in expected {
        let found = transmissibility(*frequency, 2e-3, static_force, strut());
        assert_close(&format!("body at {frequency} Hz"), found[0], *body, tolerance);
        // The tables have three digits.
        assert_close(&format!("travel at {frequency} Hz"), found[1], *travel, tolerance + 5e-4 / travel);
    }
}

/// Reference solution without friction, road amplitude 2 mm.
const FRICTIONLESS: [(f64, f64, f64); 4] =
    [(1.0, 1.079, 0.047), (2.0, 1.350, 0.217), (3.9, 2.569, 1.232), (5.0, 2.069, 1.415)];

#[test]
fn quarter_car_transmits_as_the_reference() {
    assert_transmits(&FRICTIONLESS, 0.01, 1325.2555, || Box::new(spring_and_damper(1325.2555, 45e3)));
}

/// Less motion below the body's frequency, more above it: no damping has both effects.
#[test]
fn friction_in_the_shock_absorber_transmits_as_the_reference() {
    let tables = [
        (0.0, FRICTIONLESS),
        (20.0, [(1.0, 1.047, 0.015), (2.0, 1.216, 0.072), (3.9, 2.436, 0.997), (5.0, 2.254, 1.390)]),
        (50.0, [(1.0, 1.047, 0.015), (2.0, 1.215, 0.068), (3.9, 2.446, 0.744), (5.0, 2.588, 1.381)]),
    ];
    for (kinetic, table) in tables {
        assert_transmits(&table, 0.01, static_force(45e3), || Box::new(shock_absorber(45e3, kinetic)));
    }
}

/// A locked strut leaves one mass on the tyre: sqrt(k_t / (m_s + m_u)) / 2 pi = 5.66 Hz.
#[test]
fn quarter_car_with_a_locked_strut_is_one_mass_on_the_tyre() {
    // Locked by a spring that is much stiffer than the tyre.
    let strut = |length: f64, velocity: f64, _: f64| 1325.2555 - 3e7 * (length - 0.1775) - 1e4 * velocity;
    for frequency in [2.0, 4.0] {
        let [body, travel] = transmissibility(frequency, 2e-3, 1325.2555, Box::new(strut));
        let ratio = frequency / 5.66;
        // Its damping, 2 % of critical, would need more periods to settle than are simulated.
        assert_close("body", body, 1.0 / (1.0 - ratio * ratio), 0.1);
        assert!(travel < 2e-3 * body, "{travel}");
    }
}

/// Measurements of a car in periodic motion; of its front left corner in the last three.
struct Ride {
    heave: f64,
    pitch: f64,
    fastest: f64,
    travel: f64,
    least_load: f64,
}

const CORNERS: [&str; 4] = ["fl.", "fr.", "rl.", "rr."];

/// The posts rise and fall, z = A (1 - cos(w t - phi)) / 2 with phi = 0 in front; peak to peak over the last period.
fn four_post(frequency: f64, phase: f64, static_forces: [f64; 2], mut struts: [Strut; 4]) -> Ride {
    let [front, rear] = static_forces;
    let mut car = Bench::new("FourPostCar", &[("front.static_force", front), ("rear.static_force", rear)]);
    let height = 0.04;
    let (w, periods, h) = (TAU * frequency, 6.0, 2e-4);
    let post = |t: f64, phase: f64| {
        let (sine, cosine) = (w * t - phase).sin_cos();
        [0.5 * height * (1.0 - cosine), 0.5 * height * w * sine]
    };
    let mut range = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    let (mut fastest, mut least_load) = (0.0f64, f64::INFINITY);
    let steps = (periods / frequency / h).round() as u32;
    for k in 0..steps {
        let (t, next) = (f64::from(k) * h, f64::from(k + 1) * h);
        for ((corner, strut), phase) in CORNERS.into_iter().zip(&mut struts).zip([0.0, 0.0, phase, phase]) {
            exchange(&mut car, corner, "post", strut, post(t, phase), post(next, phase), h);
        }
        car.step(h);
        if t > (periods - 1.0) / frequency {
            let corner = car.get("heave") - 0.8035 * car.get("pitch") + 0.61 * car.get("roll");
            let values = [car.get("heave"), car.get("pitch"), corner - car.get("fl.wheel_height")];
            for ([low, high], value) in range.iter_mut().zip(values) {
                (*low, *high) = (low.min(value), high.max(value));
            }
            fastest = fastest.max(car.get("fl.velocity").abs());
            least_load = least_load.min(car.get("fl.tyre_load"));
        }
    }
    let [heave, pitch, travel] = range.map(|[low, high]| high - low);
    Ride { heave, pitch: pitch.to_degrees(), fastest, travel, least_load }
}

fn assert_rides(
    frequency: f64,
    expected: &[f64],
    tolerance: f64,
    static_forces: [f64; 2],
    strut: impl Fn(usize) -> Strut<'static>,
) {
    let struts = [0, 0, 1, 1].map(strut);
    let Ride { heave, pitch, fastest, travel, least_load } = four_post(frequency, FRAC_PI_2, static_forces, struts);
    let found = [heave, pitch, fastest, travel, least_load];
    let names = ["heave", "pitch", "damper velocity", "travel", "least load"];
    for ((name, found), expected) in names.into_iter().zip(found).zip(expected.iter().copied()) {
        // The table gives the velocity to 1 mm/s.
        let rounding = if name == "damper velocity" { 5e-4 / expected } else { 0.0 };
        assert_close(&format!("{name} at {frequency} Hz"), found, expected, tolerance + rounding);
    }
}

const STIFFNESSES: [f64; 2] = [45e3, 35e3];

/// Reference solution without friction: 40 mm, the rear axle a quarter of a period later.
#[test]
fn four_post_car_moves_as_the_reference() {
    let forces = [1325.2555, 1100.2555];
    let strut = |axle: usize| -> Strut { Box::new(spring_and_damper(forces[axle], STIFFNESSES[axle])) };
    assert_rides(1.0, &[30.77e-3, 2.319, 0.006, 1.86e-3, 622.0], 0.01, forces, strut);
    assert_rides(2.0, &[38.06e-3, 3.025, 0.058, 8.52e-3, 407.0], 0.01, forces, strut);
}

/// The reference gives no minimum load with friction.
#[test]
fn four_post_car_with_friction_moves_as_the_reference() {
    let forces = STIFFNESSES.map(static_force);
    for (kinetic, expected) in [
        (0.0, [38.06e-3, 3.025, 0.058, 8.52e-3]),
        (20.0, [37.06e-3, 2.935, 0.051, 7.57e-3]),
        (50.0, [35.91e-3, 2.826, 0.042, 5.94e-3]),
    ] {
        let strut = |axle: usize| -> Strut { Box::new(shock_absorber(STIFFNESSES[axle], kinetic)) };
        assert_rides(2.0, &expected, 0.01, forces, strut);
    }
}

/// Roll angles of a lane change in degrees, one per step of 1 ms over 5 s: two periods of sine steering, 3.6 degrees at
/// 0.9 Hz, with 0.35 s between them, at 72 km/h.
fn lane_change(mut struts: [Strut; 4]) -> Vec<f64> {
    let [front, rear] = STIFFNESSES.map(static_force);
    let mut car = Bench::new("DoubleTrackCar", &[("front.static_force", front), ("rear.static_force", rear)]);
    let (period, h) = (1.0 / 0.9, 1e-3);
    let steering = |t: f64| {
        let within = if t < period { t } else { (t - period - 0.35).clamp(0.0, period) };
        3.6f64.to_radians() * (TAU * within / period).sin()
    };
    let step = |k: u32| {
        car.set("steering_angle", steering(f64::from(k) * h));
        for (corner, strut) in CORNERS.into_iter().zip(&mut struts) {
            exchange(&mut car, corner, "road", strut, [0.0; 2], [0.0; 2], h);
        }
        car.step(h);
        car.get("roll").to_degrees()
    };
    (0..5000).map(step).collect()
}

/// Friction keeps some roll after the lane change, which springs and dampers cannot. The reference has a simpler tyre,
/// and no links that tilt the axles: these add 0.1 degrees to its largest roll, whatever the friction.
#[test]
fn friction_leaves_the_car_rolled_after_a_lane_change_as_the_reference() {
    let ride = |kinetic: f64| {
        lane_change([0, 0, 1, 1].map(|axle: usize| -> Strut { Box::new(shock_absorber(STIFFNESSES[axle], kinetic)) }))
    };
    let largest = |roll: &[f64]| roll.iter().fold(0.0, |largest: f64, roll| largest.max(roll.abs()));
    let free = ride(0.0);
    assert_close("largest roll", largest(&free), 0.953 + 0.108, 0.02);
    assert!(free[4999].abs() < 1e-4, "{}", free[4999]);
    for (kinetic, less, left) in [(20.0, 0.047, 0.051), (50.0, 0.117, 0.123)] {
        let roll = ride(kinetic);
        assert_close("less roll", largest(&free) - largest(&roll), less, 0.1);
        assert_close("roll left", roll[4999].abs(), left, 0.1);
    }
}
