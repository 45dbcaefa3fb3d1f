//! The car against closed forms and other programs.

use approx::assert_abs_diff_eq;

use super::*;
use crate::host::{FormulaVersion, FourPostCar, TyreSpring};
use crate::model::{row_of, row_of_mut, start};
use crate::numerics::runge_kutta::dormand_prince;

const STEP: f64 = 1e-3;

fn wheels(car: &mut DoubleTrackCar) -> [&mut RollingWheel; 4] {
    [&mut car.fl, &mut car.fr, &mut car.rl, &mut car.rr]
}

/// Linear springs and dampers of two slopes, as in the reference run: 45 and 35 kN/m, 1500 and 2300 N.s/m.
fn load_struts(car: &mut DoubleTrackCar) {
    let seats = [&car.front, &car.front, &car.rear, &car.rear].map(|axle| axle.axle.suspension);
    let stiffness = [45e3, 45e3, 35e3, 35e3];
    for ((wheel, seat), stiffness) in wheels(car).into_iter().zip(seats).zip(stiffness) {
        let RollingWheel { wheel, .. } = wheel;
        let damping = if wheel.velocity < 0.0 { 1500.0 } else { 2300.0 };
        let spring = seat.static_force - stiffness * (wheel.length - seat.static_length);
        wheel.strut_force = spring - damping * wheel.velocity;
    }
}

/// Drives in steps of 1 ms, struts first, and inspects each.
fn drive(
    car: &mut DoubleTrackCar,
    duration: f64,
    steering: impl Fn(f64) -> f64,
    mut seen: impl FnMut(&DoubleTrackCar),
) {
    for step in 0..(duration / STEP).round() as u32 {
        car.steering_angle = steering(f64::from(step) * STEP);
        car.output();
        load_struts(car);
        car.step(STEP);
        car.output();
        seen(car);
    }
}

/// The textbook bicycle model: mass and distances of the car, cornering stiffness and trail of each axle.
struct Bicycle {
    mass: f64,
    places: [f64; 2],
    stiffness: [f64; 2],
    trails: [f64; 2],
}

impl Bicycle {
    /// Numbers of ZR26: 288.64 kg, 48 % in front; the stiffness is that of the formula at each load.
    fn of(car: &DoubleTrackCar) -> Bicycle {
        let mass = 223.2 + 4.0 * 16.36;
        let behind: f64 = 1.528 - 0.8035;
        let ahead = (223.2 * 0.8035 + 2.0 * 16.36 * 1.528) / mass;
        let loads = [behind, 0.8035].map(|lever| 9.81 * (223.2 * lever / (2.0 * 1.528) + 16.36));
        Bicycle {
            mass,
            places: [ahead, ahead - 1.528],
            stiffness: loads.map(|load| 2.0 * 75.5 * 700.0 * (2.0 * (load / (4.65f64 * 700.0)).atan()).sin()),
            trails: loads.map(|load| load / 700.0 * car.tyre.qdz1 * 0.2),
        }
    }

    /// Rates of lateral velocity, yaw rate and the side slips of both axles, small, at the speed 20 m/s.
    fn rates(&self, steering: f64, [velocity, yaw_rate, front, rear]: [f64; 4]) -> [f64; 4] {
        let forces = [-self.stiffness[0] * front, -self.stiffness[1] * rear];
        let arm = |i: usize| self.places[i] - self.trails[i];
        let path = |i: usize| (velocity + self.places[i] * yaw_rate) / 20.0;
        [
            (forces[0] + forces[1]) / self.mass - 20.0 * yaw_rate,
            (arm(0) * forces[0] + arm(1) * forces[1]) / 142.92,
            20.0 / 0.2 * (path(0) - steering - front),
            20.0 / 0.2 * (path(1) - rear),
        ]
    }
}

/// Also with tyres whose shifts push both sides against each other.
#[test]
fn a_straight_road_is_followed_exactly() {
    let mut car = DoubleTrackCar::default();
    (car.tyre.lhy, car.tyre.lvy, car.tyre.qdz6, car.tyre.qbz9) = (1.0, 1.0, 0.01, 3.0);
    for wheel in wheels(&mut car) {
        wheel.road_height = 0.01;
    }
    drive(&mut car, 1.0, |_| 0.0, |_| ());
    let lateral = [car.position_y, car.yaw_angle, car.lateral_velocity, car.yaw_rate, car.body.roll];
    assert_eq!(lateral, [0.0; 5]);
    assert_abs_diff_eq!(car.position_x, 20.0, epsilon = 1e-12);
    assert!(car.body.heave > 9e-3 && car.fl.lateral_force == -car.fr.lateral_force);
    assert!(car.fl.lateral_force.abs() > 10.0);
}

/// Small steering: yaw rate = V delta / (L + K V^2), K = m (b C_r - a C_f) / (L C_f C_r).
#[test]
fn small_steering_turns_as_the_understeer_gradient_says() {
    let mut car = DoubleTrackCar::default();
    let Bicycle { mass, places: [a, b], stiffness: [c_f, c_r], .. } = Bicycle::of(&car);
    let wheelbase = a - b;
    let gradient = mass * (-b * c_r - a * c_f) / (wheelbase * c_f * c_r);
    drive(&mut car, 3.0, |_| 1e-5, |_| ());
    let expected = 20.0 * 1e-5 / (wheelbase + gradient * 400.0);
    assert!((car.yaw_rate / expected - 1.0).abs() < 1e-6, "{} against {expected}", car.yaw_rate);
    assert_abs_diff_eq!(car.lateral_acceleration / (20.0 * expected), 1.0, epsilon = 1e-6);
}

/// The whole transient of lateral velocity, yaw rate and side slip, small, against the linear bicycle; also with
/// tyres that have a trail.
#[test]
fn small_motions_are_those_of_the_bicycle() {
    for trail in [0.0, 0.1] {
        let mut car = DoubleTrackCar::default();
        (car.tyre.qdz1, car.tyre.qcz1, car.tyre.qbz1) = (trail, 1.1, 9.0);
        (car.lateral_velocity, car.steering_angle) = (1e-5, 1e-6);
        let bicycle = Bicycle::of(&car);
        let mut linear = [1e-5, 0.0, 0.0, 0.0];
        for _ in 0..40 {
            car.step(0.01);
            for _ in 0..10 {
                linear = dormand_prince(|_, at| bicycle.rates(1e-6, at), linear, 1e-3).0;
            }
            let states = [car.lateral_velocity, car.yaw_rate, car.fl.side_slip, car.rr.side_slip];
            for (state, linear) in states.iter().zip(linear) {
                assert!((state - linear).abs() < 1e-11, "trail {trail}: {states:?} against {linear:?}");
            }
        }
        assert!(linear[1].abs() > 1e-6, "it has turned: {linear:?}");
    }
}

#[test]
fn steering_to_the_other_side_mirrors_the_run() {
    let mut left = DoubleTrackCar::default();
    (left.tyre.lhy, left.tyre.lvy) = (1.0, 1.0);
    let mut right = left;
    let mut path = Vec::new();
    drive(&mut left, 0.5, |t| 0.1 * (12.0 * t).sin(), |car| path.push(*car));
    let mut path = path.iter();
    drive(
        &mut right,
        0.5,
        |t| -0.1 * (12.0 * t).sin(),
        |right| {
            let left = path.next().unwrap();
            let odd = |car: &DoubleTrackCar| {
                [car.position_y, car.yaw_angle, car.lateral_velocity, car.yaw_rate, car.body.roll, car.body.roll_rate]
            };
            odd(left).iter().zip(odd(right)).for_each(|(left, right)| assert!((left + right).abs() < 1e-9));
            let even = |car: &DoubleTrackCar| [car.position_x, car.body.heave, car.body.pitch];
            even(left).iter().zip(even(right)).for_each(|(left, right)| assert!((left - right).abs() < 1e-9));
            assert_abs_diff_eq!(left.fl.wheel.tyre_load, right.fr.wheel.tyre_load, epsilon = 1e-5);
            assert!((left.rl.lateral_force + right.rr.lateral_force).abs() < 1e-5);
        },
    );
    assert!(left.position_y.abs() > 0.1);
}

/// In a steady turn the tyres carry the weight, and their loads balance the moment of inertia and weight about the
/// ground, whatever the suspension does. Left turn: right tyres are loaded, the right side goes down.
#[test]
fn loads_of_a_steady_turn_balance() {
    let mut car = DoubleTrackCar::default();
    drive(&mut car, 4.0, |t| 0.03 * t.min(1.0), |_| ());
    let loads = [car.fl, car.fr, car.rl, car.rr].map(|wheel| wheel.wheel.tyre_load);
    assert!((loads.iter().sum::<f64>() - 9.81 * 288.64).abs() < 1e-6, "{loads:?}");
    let moment = 0.61 * (loads[0] - loads[1]) + 0.60 * (loads[2] - loads[3]);
    let heights = 223.2 * 0.3203 + 4.0 * 16.36 * 0.2;
    let roll_axis = 0.035 + (0.05 - 0.035) * 0.8035 / 1.528;
    let expected = -car.lateral_acceleration * heights - 223.2 * 9.81 * (0.3203 - roll_axis) * car.body.roll;
    assert!((moment - expected).abs() < 1e-6, "{moment} against {expected}");
    assert!(car.lateral_acceleration > 7.0 && car.body.roll > 0.01, "{car:?}");
    // The centre of gravity runs on a circle.
    assert_abs_diff_eq!(car.lateral_acceleration, 20.0 * car.yaw_rate, epsilon = 1e-9);
}

/// The body rolls by the moment over the stiffness of the springs; the wheels follow their tyres.
#[test]
fn steady_roll_angle_is_moment_over_stiffness() {
    let mut car = DoubleTrackCar::default();
    // Without roll centres and without weight above the roll axis there is one moment and two springs in series.
    (car.front.roll_centre_height, car.rear.roll_centre_height, car.wheel_centre_height) = (0.0, 0.0, 0.0);
    drive(&mut car, 4.0, |t| 0.02 * t.min(1.0), |_| ());
    let spring = [(45e3 * 1.011 * 1.011, 0.61), (35e3 * 1.004 * 1.004, 0.60)];
    let stiffness: f64 = spring.iter().map(|(rate, half_track)| 2.0 * half_track * half_track * rate).sum();
    let loads = [car.fl, car.fr, car.rl, car.rr].map(|wheel| wheel.wheel.wheel_height);
    // Deflection of the springs: the roll of the body less that of each axle.
    let resisted: f64 = [0, 1]
        .map(|axle| {
            let (rate, half_track) = spring[axle];
            let axle_roll = (loads[2 * axle] - loads[2 * axle + 1]) / (2.0 * half_track);
            2.0 * half_track * half_track * rate * (car.body.roll - axle_roll)
        })
        .iter()
        .sum();
    let moment = 223.2 * 0.3203 * (car.lateral_acceleration + 9.81 * car.body.roll);
    assert!((resisted / moment - 1.0).abs() < 1e-6, "{resisted} against {moment}");
    assert!(car.body.roll > moment / stiffness);
}

/// Posts under the wheels and no lateral motion: with the roll axis at the centre of gravity, the car on four
/// posts.
#[test]
fn without_lateral_motion_it_is_the_car_on_four_posts() {
    let mut car = DoubleTrackCar { cg_height: 0.04, ..Default::default() };
    (car.front.roll_centre_height, car.rear.roll_centre_height) = (0.04, 0.04);
    let mut posts = FourPostCar::default();
    let mut lifted = false;
    for step in 0..300 {
        let time = f64::from(step) * STEP;
        let heights = [0.0, 1.0, 2.0, 3.0].map(|phase: f64| 0.04 * (30.0 * time + phase).sin());
        car.output();
        load_struts(&mut car);
        let pairs = wheels(&mut car).into_iter().zip([&mut posts.fl, &mut posts.fr, &mut posts.rl, &mut posts.rr]);
        for ((wheel, post), height) in pairs.zip(heights) {
            (wheel.road_height, post.post_height) = (height, height);
            post.wheel.strut_force = wheel.wheel.strut_force;
            lifted |= wheel.wheel.tyre_load == 0.0;
        }
        car.step(STEP);
        posts.step(STEP);
        for (car, posts) in row_of(&car.body).iter().zip(row_of(&posts.body)) {
            assert!((car - posts).abs() < 1e-9, "after {time} s");
        }
        assert_abs_diff_eq!(car.rr.wheel.wheel_height, posts.rr.wheel.wheel_height, epsilon = 1e-9);
    }
    assert!(lifted, "the road was rough enough");
    assert_eq!([car.lateral_velocity, car.yaw_rate], [0.0; 2]);
}

#[test]
fn two_half_steps_are_one_step_also_on_ramps() {
    for dt in [1e-12, 1e-4, 0.02, 0.5] {
        let mut whole = DoubleTrackCar { steering_angle: 0.05, yaw_rate: 0.2, ..Default::default() };
        whole.fl.road_height = -0.03;
        let mut slope = whole;
        row_of_mut(&mut slope).fill(0.0);
        (slope.steering_angle, slope.rr.road_height, slope.fl.wheel.strut_force) = (-0.1, 0.02, 200.0);
        let mut halves = whole;
        whole.step_ramp(&slope, dt);
        halves.step_ramp(&slope, 0.5 * dt);
        halves.step_ramp(&slope, 0.5 * dt);
        // Each piece of a step has an error of 1e-10. In half a second they add up to between 4e-10 and 8e-9, as lengths
        // of 0.35, 0.36 ... 0.64 s show.
        let bound = f64::max(1e-9, 2e-8 * dt);
        for (a, b) in row_of(&whole).iter().zip(row_of(&halves)) {
            assert!((a - b).abs() < bound * a.abs().max(1.0), "{dt}: {a} against {b}");
        }
    }
}

/// Inertia only: the car slides on in its old direction.
#[test]
fn without_grip_steering_does_nothing() {
    let mut car = DoubleTrackCar { lateral_velocity: 0.5, steering_angle: 0.1, ..Default::default() };
    (car.tyre.pdy1, car.tyre.pdy2) = (0.0, 0.0);
    car.step(1.0);
    assert_eq!([car.lateral_velocity, car.yaw_angle, car.body.roll], [0.5, 0.0, 0.0]);
    assert_abs_diff_eq!(car.position_y, 0.5, epsilon = 1e-12);
}

/// Two periods of sine steering, 3.6 degrees at 0.9 Hz, with 0.35 s between them, at 72 km/h, on struts without
/// friction. Another simulation of the same car, with a simpler tyre and without the links that tilt the axles, has
/// 1.13 g and a roll of 0.953 degrees. The tilt of the axles (see C_a) adds what this test computes at rest.
#[test]
fn lane_change_of_the_reference() {
    let period = 1.0 / 0.9;
    let steering = |time: f64| {
        let second = time - period - 0.35;
        let phase = if time < period { time } else { second.clamp(0.0, period) };
        3.6f64.to_radians() * (std::f64::consts::TAU * phase / period).sin()
    };
    let mut car = DoubleTrackCar::default();
    let (mut roll, mut acceleration): (f64, f64) = (0.0, 0.0);
    drive(&mut car, 5.0, steering, |car| {
        roll = roll.max(car.body.roll.abs().to_degrees());
        acceleration = acceleration.max(car.lateral_acceleration.abs() / 9.81);
    });
    assert!((acceleration / 1.13 - 1.0).abs() < 0.03, "{acceleration} g");
    let tilt = |body_mass: f64, roll_centre: f64, track: f64| {
        let moment = (body_mass * roll_centre + 2.0 * 16.36 * 0.2) * acceleration * 9.81;
        moment / (0.5 * 87563.5 * track * track)
    };
    let spring = |rate: f64, ratio: f64, track: f64| rate * (ratio * track).powi(2);
    let (front, rear) = (spring(45e3, 1.011, 1.22), spring(35e3, 1.004, 1.20));
    let tilt = (front * tilt(105.83, 0.035, 1.22) + rear * tilt(117.37, 0.05, 1.20)) / (front + rear);
    let without_tilt = roll - tilt.to_degrees();
    assert!((without_tilt / 0.953 - 1.0).abs() < 0.02, "{roll} deg, {without_tilt} deg without tilt");
    assert!(car.body.roll.abs().to_degrees() < 1e-4, "no friction holds the body: {}", car.body.roll);
}

/// The radii of linear springs, of tyres that grow with speed, and of tyres that cannot carry what they carry: the car
/// goes on as it does.
#[test]
fn radii_follow_load_and_speed_and_move_nothing() {
    let turned = |spring: TyreSpring| {
        let mut car = DoubleTrackCar::default();
        (car.tyre.version, car.tyre.spring) = (FormulaVersion::Six.number(), spring);
        drive(&mut car, 0.5, |_| 0.02, |_| ());
        car
    };
    let linear: TyreSpring = start();
    let mut plain = turned(linear);
    for RollingWheel { wheel, tyre_deflection, loaded_radius, effective_radius, .. } in wheels(&mut plain) {
        assert_abs_diff_eq!(*tyre_deflection, wheel.tyre_load / 87563.5, epsilon = 1e-15);
        assert_abs_diff_eq!(*loaded_radius, 0.2 - *tyre_deflection, epsilon = 1e-15);
        assert_eq!(*effective_radius, 0.2);
    }
    // Without deflection in R_e it is the free radius: R (R / 0.2 - 1) R = q_v1 (0.2 20 / 16.7)^2.
    let mut grown = turned(TyreSpring { q_v1: 0.05, ..linear });
    for RollingWheel { tyre_deflection, loaded_radius, effective_radius, .. } in wheels(&mut grown) {
        let radius = *effective_radius;
        assert_abs_diff_eq!(radius * radius * (radius / 0.2 - 1.0), 0.05 * (4.0f64 / 16.7).powi(2), epsilon = 1e-16);
        assert_abs_diff_eq!(*loaded_radius, radius - *tyre_deflection, epsilon = 1e-15);
    }
    let mut soft = turned(TyreSpring { q_fcy: 1e3, ..linear });
    for RollingWheel { tyre_deflection, loaded_radius, effective_radius, .. } in wheels(&mut soft) {
        assert_eq!([*tyre_deflection, *loaded_radius, *effective_radius], [0.0, 0.0, 0.0]);
    }
    for mut other in [grown, soft] {
        other.tyre = plain.tyre;
        for (wheel, as_plain) in wheels(&mut other).into_iter().zip(wheels(&mut plain)) {
            (wheel.tyre_deflection, wheel.loaded_radius) = (as_plain.tyre_deflection, as_plain.loaded_radius);
            wheel.effective_radius = as_plain.effective_radius;
        }
        assert_eq!(row_of(&other), row_of(&plain));
    }
}

#[test]
fn parameters_that_do_not_fit_are_refused() {
    let mut car = DoubleTrackCar::default();
    car.check().unwrap();
    car.body.cg_to_front = 2.0;
    assert_eq!(car.check().unwrap_err().0, "cg_to_front = 2: must be <= wheelbase = 1.528");
    car.tyre.spring.q_fz2 = 8.0;
    car.rear.axle.suspension.tyre_stiffness = 8e4;
    let limit = "(tyre.unloaded_radius rear.tyre_stiffness / tyre.fnomin)^2 / 4 = 7.11";
    let refused = car.check().unwrap_err().0;
    assert!(refused.starts_with(&format!("tyre.q_fz2 = 8: must be at most {limit}")), "{refused}");
    car.tyre.pky2 = 0.0;
    assert_eq!(car.check().unwrap_err().0, "tyre.pky2 = 0: must not be 0");
}
