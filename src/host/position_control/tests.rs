//! The loop against closed forms, its rates, the law that it observes, and the transfer function of a sampled controller.

use approx::{assert_abs_diff_eq, assert_relative_eq};

use super::*;
use crate::catalogue::by_name;
use crate::friction::LuGre;
use crate::instance::Instance;

/// Gains with which the loop has the eigenvalues -1, -2 and -3 per second.
fn with_real_modes() -> PositionControl {
    PositionControl {
        mass: 2.0,
        integral_gain: 12.0,
        proportional_gain: 22.0,
        velocity_gain: 12.0,
        ..Default::default()
    }
}

/// From rest to 1 m: x = 1 + 2.5 e^-t - 8 e^-2t + 4.5 e^-3t.
#[test]
fn a_step_of_the_target_excites_the_modes_of_the_loop() {
    for t in [1e-3, 0.4, 2.0, 30.0] {
        let mut control = PositionControl { target_position: 1.0, ..with_real_modes() };
        control.step(t);
        let modes = |power: i32| -> f64 {
            let amplitudes = [2.5, -8.0, 4.5];
            (1..=3).zip(amplitudes).map(|(s, a)| a * f64::from(-s).powi(power) * f64::exp(-f64::from(s) * t)).sum()
        };
        for (found, expected) in [
            (control.position, 1.0 + modes(0)),
            (control.velocity, modes(1)),
            // The integral of the error ends at 0: its rate is what is left of the way.
            (control.error_integral, modes(-1)),
        ] {
            assert!((found - expected).abs() < 2e-14, "{t}: {found} {expected}");
        }
    }
}

/// Forces alone, whose rates are constant: v = a t + j t^2 / 2, x = a t^2 / 2 + j t^3 / 6.
#[test]
fn without_gains_it_is_a_free_mass() {
    let gains =
        PositionControl { integral_gain: 0.0, proportional_gain: 0.0, velocity_gain: 0.0, ..Default::default() };
    for t in [1e-6, 0.5, 20.0] {
        let mut control = PositionControl { mass: 4.0, friction_force: -2.0, target_acceleration: 0.25, ..gains };
        let slope = PositionControl { friction_force: -0.6, ..ramp::held_inputs(&control) };
        control.step_ramp(&slope, t);
        assert_relative_eq!(control.velocity, 0.75 * t + 0.075 * t * t, max_relative = 1e-14);
        assert_relative_eq!(control.position, 0.375 * t * t + 0.025 * t * t * t, max_relative = 1e-14);
    }
}

/// The velocity of the target passes 0 after 0.6 s of a second: the force is -F_C and then F_C beside sigma_2 v_d.
#[test]
fn friction_that_is_fed_forward_turns_with_the_target() {
    let mut control = PositionControl {
        compensation: Compensation::FeedForward.number(),
        integral_gain: 0.0,
        proportional_gain: 0.0,
        velocity_gain: 0.0,
        kinetic_force: 2.0,
        breakaway_force: 2.0,
        viscous_coefficient: 0.5,
        target_velocity: -0.3,
        ..Default::default()
    };
    let slope = PositionControl { target_velocity: 0.5, ..ramp::held_inputs(&control) };
    control.step_ramp(&slope, 1.0);
    let (coulomb, viscous) = (2.0 * (0.4 - 0.6), 0.5 * (-0.3 + 0.25));
    assert_relative_eq!(control.velocity, coulomb + viscous, max_relative = 1e-14);
    // Over the two parts: a way by each force, and that of the velocity reached first.
    let way = -0.36 - 1.2 * 0.4 + 0.16 + 0.5 * (-0.15 + 0.5 / 6.0);
    assert_relative_eq!(control.position, way, max_relative = 1e-14);
    assert_relative_eq!(control.target_velocity, 0.2, max_relative = 1e-15);
}

/// All inputs move; the other way integrates the rates with error control.
#[test]
fn exact_steps_are_those_of_the_rates() {
    for (scale, t) in [(1.0, 3.0), (1.0, 1e-3), (1e4, 0.2), (1e-4, 40.0)] {
        let control = PositionControl {
            integral_gain: 4.0 * scale,
            proportional_gain: 3.0 * scale,
            velocity_gain: 6.0 * scale,
            compensation: Compensation::FeedForward.number(),
            friction_force: 0.7,
            target_position: 0.5,
            target_velocity: 0.3,
            position: 0.2,
            velocity: -0.1,
            error_integral: 0.03,
            ..Default::default()
        };
        let slope = PositionControl {
            friction_force: -0.4,
            target_position: 0.3,
            target_velocity: 0.05,
            target_acceleration: -0.2,
            ..ramp::held_inputs(&control)
        };
        let (mut exact, mut integrated) = (control, control);
        exact.step_ramp(&slope, t);
        integrate::advance::<_, 4>(&mut integrated, &slope, t);
        for (exact, integrated) in [
            (exact.position, integrated.position),
            (exact.velocity, integrated.velocity),
            (exact.error_integral, integrated.error_integral),
        ] {
            assert_relative_eq!(exact, integrated, max_relative = 1e-8, epsilon = 1e-9);
        }
    }
}

/// Steps of any lengths are one, also if the loop is stiff and they are long.
#[test]
fn two_steps_are_one() {
    for (first, second) in [(0.1, 1.5), (1e-6, 0.2), (7.0, 200.0)] {
        let start = PositionControl {
            position: 0.3,
            velocity: -2.0,
            friction_force: 1.0,
            velocity_gain: 600.0,
            ..with_real_modes()
        };
        let slope = PositionControl { target_position: 0.1, friction_force: 0.2, ..ramp::held_inputs(&start) };
        let (mut once, mut twice) = (start, start);
        once.step_ramp(&slope, first + second);
        twice.step_ramp(&slope, first);
        twice.step_ramp(&slope, second);
        assert_relative_eq!(once.position, twice.position, max_relative = 1e-13, epsilon = 1e-14);
        assert_relative_eq!(once.velocity, twice.velocity, max_relative = 1e-13, epsilon = 1e-14);
    }
}

/// An observer that knows the deflection of the true law takes the friction away from the loop.
#[test]
fn the_observer_gives_the_force_of_the_law() {
    for (velocity, deflection) in [(2e-4, 3e-6), (-0.3, -9e-6), (0.0, 1.4e-5)] {
        let mut law = LuGre { velocity, bristle_deflection: deflection, normal_force: 1.0, ..Default::default() };
        (law.mu_k, law.mu_s, law.sigma_1, law.viscous_coefficient) = (1.0, 1.5, f64::sqrt(1e5), 0.4);
        law.output();
        let free = PositionControl { velocity, target_position: 0.4, error_integral: 0.2, ..Default::default() };
        let observed = PositionControl {
            compensation: Compensation::Observer.number(),
            deflection_estimate: deflection,
            observer_gain: 0.0,
            friction_force: law.friction_force,
            ..free
        };
        let [of_free, of_observed] = [free, observed].map(|control| {
            let mut rate = control;
            control.derivatives(&mut rate);
            rate
        });
        assert_relative_eq!(of_observed.velocity, of_free.velocity, max_relative = 1e-13);
        let mut of_law = law;
        law.derivatives(&mut of_law);
        assert_relative_eq!(of_observed.deflection_estimate, of_law.bristle_deflection, max_relative = 1e-13);
    }
}

/// At rest at a distance the estimate grows as the gain says, and with it the force, by k sigma_0 times the distance.
#[test]
fn a_body_at_rest_winds_the_observer_up() {
    let mut control = PositionControl {
        compensation: Compensation::Observer.number(),
        target_position: 0.5,
        integral_gain: 0.0,
        mass: 1e12,
        ..Default::default()
    };
    control.output();
    let before = control.external_force;
    control.step(0.02);
    control.output();
    assert_relative_eq!(control.deflection_estimate, 1e-6, max_relative = 1e-6);
    assert_relative_eq!(control.external_force - before, 0.1, max_relative = 1e-6);
}

#[test]
fn an_observer_without_a_level_is_refused() {
    let refused = |control: PositionControl| control.check().map_err(|fault| fault.to_string());
    let observer =
        PositionControl { compensation: Compensation::Observer.number(), kinetic_force: 0.0, ..Default::default() };
    let text = "kinetic_force = 0: must be > 0 with compensation = Observer";
    assert_eq!(refused(observer), Err(text.to_owned()));
    assert_eq!(refused(PositionControl { compensation: Compensation::FeedForward.number(), ..observer }), Ok(()));
    let text = "breakaway_force = 0.5: must be >= kinetic_force = 1";
    let low = PositionControl { kinetic_force: 1.0, breakaway_force: 0.5, ..observer };
    assert_eq!(refused(low), Err(text.to_owned()));
    assert_eq!(refused(PositionControl { compensation: Compensation::FeedForward.number(), ..low }), Ok(()));
}

/// A controller at this sample time without friction, on its way to 1 m.
fn sampled(sample_time: f64) -> PositionControl {
    PositionControl { target_position: 1.0, sample_time, ..Default::default() }
}

/// The transfer functions of a mass whose force is held and of the controller, `k_p + k_v (z - 1) / (z T) + k_i T / (z -
/// 1)`, give the characteristic polynomial `z (z - 1)^3 + T / (2 m) (z + 1) (k_p T z (z - 1) + k_v (z - 1)^2 + k_i T^2
/// z)`, which the error obeys.
#[test]
fn a_sampled_loop_obeys_its_characteristic_polynomial() {
    let t = 0.1;
    let mut control = sampled(t);
    let mut errors = Vec::new();
    for _ in 0..500 {
        errors.push(control.position - 1.0);
        control.step(t);
    }
    let times = |a: &[f64], b: &[f64]| -> Vec<f64> {
        let mut product = vec![0.0; a.len() + b.len() - 1];
        for (i, x) in a.iter().enumerate() {
            b.iter().enumerate().for_each(|(j, y)| product[i + j] += x * y);
        }
        product
    };
    // Coefficients of ascending powers of z, with the start values of mass and gains.
    let falling = [-1.0, 1.0];
    let square = times(&falling, &falling);
    let mut gains: Vec<f64> = square.iter().map(|x| 6.0 * x).collect();
    times(&[0.0, 3.0 * t], &falling).iter().enumerate().for_each(|(power, x)| gains[power] += x);
    gains[1] += 4.0 * t * t;
    let mut polynomial = times(&[0.0, 1.0], &times(&square, &falling));
    times(&[0.5 * t, 0.5 * t], &gains).iter().enumerate().for_each(|(power, x)| polynomial[power] += x);
    for window in errors.windows(5) {
        let sum: f64 = window.iter().zip(&polynomial).map(|(error, coefficient)| error * coefficient).sum();
        assert!(sum.abs() < 1e-14, "{window:?}: {sum}");
    }
    assert!(errors[499].abs() < 1e-2 && errors[10].abs() > 0.1, "{errors:?}");
}

/// A shorter sample time comes nearer to the continuous loop, in proportion.
#[test]
fn samples_come_to_the_continuous_loop() {
    let mut continuous = sampled(0.0);
    continuous.step(2.0);
    let off = |sample_time: f64| {
        let mut control = sampled(sample_time);
        control.step(2.0);
        control.position - continuous.position
    };
    let [coarse, fine] = [off(2e-3), off(1e-3)];
    assert!(coarse.abs() < 1e-2 && (coarse / fine - 2.0).abs() < 0.02, "{coarse} {fine}");
}

/// Any length of the communication steps gives the same motion, be it a fraction or a multiple of the sample time, under
/// forces that change within a step.
#[test]
fn a_sampled_motion_does_not_depend_on_the_steps() {
    let until = 2.1;
    let start = PositionControl { encoder_resolution: 1e-3, position: 0.3, ..sampled(1e-2) };
    let slope = PositionControl { friction_force: 0.3, ..ramp::held_inputs(&start) };
    let mut whole = start;
    whole.step_ramp(&slope, until);
    for count in [2, 210, 211, 1733] {
        let mut parts = start;
        for _ in 0..count {
            parts.step_ramp(&slope, until / f64::from(count));
        }
        assert_relative_eq!(whole.position, parts.position, max_relative = 1e-11);
        assert_relative_eq!(whole.velocity, parts.velocity, max_relative = 1e-10);
    }
}

/// Whether each communication step is a sample time or less than it by rounding, every sample meets a communication point:
/// it sees the target that was set there, and the mass follows a ramp with the same error.
#[test]
fn samples_stay_at_the_communication_points() {
    let follow = |h: f64| {
        let mut control = PositionControl { proportional_gain: 1e4, velocity_gain: 200.0, ..sampled(1e-3) };
        (control.target_position, control.target_velocity, control.integral_gain) = (0.0, 0.5, 0.0);
        control.velocity = 0.5;
        let mut largest: f64 = 0.0;
        for step in 0..20_000 {
            control.target_position = 0.5 * h * f64::from(step);
            largest = largest.max((control.position - control.target_position).abs());
            control.step(h);
        }
        (largest, control.position - 0.5 * h * 20_000.0)
    };
    let (exact, rounded, longer) = (follow(1e-3), follow(9.999_999_999_998_899e-4), follow(1.000_000_000_000_11e-3));
    assert!(exact.0 > 1e-5, "{exact:?}");
    for other in [rounded, longer] {
        assert_abs_diff_eq!(other.0, exact.0, epsilon = 1e-9);
        assert_abs_diff_eq!(other.1, exact.1, epsilon = 1e-9);
    }
}

/// A target that is set where a sample is due acts from there on.
#[test]
fn a_target_acts_at_the_sample_at_which_it_is_set() {
    let mut control = PositionControl { target_position: 0.0, ..sampled(0.1) };
    for _ in 0..10 {
        control.step(0.1);
    }
    control.target_position = 1.0;
    control.output();
    assert_eq!(control.external_force, 3.0);
    control.step(0.05);
    assert_abs_diff_eq!(control.velocity, 0.15, epsilon = 1e-15);
    control.target_position = 2.0;
    control.output();
    assert_eq!(control.external_force, 3.0, "held up to the next sample");
}

/// A controller with the observer at this sample time, against the force of LuGre's law of the same parameters, held over
/// steps of 0.1 ms.
fn observed(sample_time: f64, until: f64) -> PositionControl {
    let compensation = Compensation::Observer.number();
    let start = PositionControl { compensation, sigma_0: 1e3, sigma_1: 30.0, stribeck_velocity: 0.05, ..sampled(0.0) };
    let mut control = PositionControl { sample_time, target_position: 0.1, observer_gain: 0.02, ..start };
    let mut law =
        LuGre { normal_force: 1.0, sigma_0: 1e3, sigma_1: 30.0, stribeck_velocity: 0.05, ..Default::default() };
    (law.mu_k, law.mu_s, law.viscous_coefficient) = (1.0, 1.5, 0.4);
    let h = 1e-4;
    for _ in 0..(until / h).round() as usize {
        law.velocity = control.velocity;
        law.step(h);
        law.output();
        control.friction_force = law.friction_force;
        control.step(h);
    }
    control
}

/// A shorter sample time comes nearer to the continuous observer, in proportion.
#[test]
fn sampled_observers_come_to_the_continuous_one() {
    let continuous = observed(0.0, 1.5);
    let off = |sample_time| observed(sample_time, 1.5).position - continuous.position;
    let [coarse, fine] = [off(4e-3), off(2e-3)];
    assert!(coarse.abs() > 1e-6 && coarse.abs() < 1e-2 && (coarse / fine - 2.0).abs() < 0.1, "{coarse} {fine}");
    let estimate = observed(2e-3, 1.5).deflection_estimate;
    assert_relative_eq!(estimate, continuous.deflection_estimate, max_relative = 0.05);
}

/// Over each sample time the estimate follows its equation, here by a Runge-Kutta method of 1,000 steps; slow samples and
/// stiff bristles, for which steps of Euler's method would grow without bound.
#[test]
fn a_sampled_observer_solves_its_equation_for_each_sample() {
    let (t, compensation) = (0.02, Compensation::Observer.number());
    let mut control = PositionControl { compensation, encoder_resolution: 1e-4, ..sampled(t) };
    let (mut estimate, mut before, mut largest) = (0.0, 0.0, 0.0_f64);
    for sample in 0..200 {
        let position = 1e-4 * (control.position / 1e-4).round();
        let velocity: f64 = (position - before) / t;
        let level = 1.0 + 0.5 * (-(velocity / 1e-3).powi(2)).exp();
        let rate = |z: f64| velocity - 1e5 * velocity.abs() * z / level - 1e-4 * (position - 1.0);
        let force = 1e5 * estimate + 316.227_766_016_837_94 * rate(estimate) + 0.4 * velocity;
        let of_loop = -6.0 * velocity - 3.0 * (position - 1.0) - 4.0 * control.error_integral;
        control.output();
        assert_relative_eq!(control.external_force, force + of_loop, max_relative = 1e-6, epsilon = 1e-6);
        let (ways, h) = (1e5 * velocity.abs() * t / level, t / 1000.0);
        for _ in 0..1000 {
            let half = estimate + 0.5 * h * rate(estimate);
            estimate += h * rate(half);
        }
        largest = largest.max(ways);
        control.friction_force = 1.2;
        control.step(t);
        if ways < 100.0 {
            assert_relative_eq!(control.deflection_estimate, estimate, max_relative = 1e-4, epsilon = 1e-12);
        }
        estimate = control.deflection_estimate;
        before = position;
        assert!(estimate.abs() < 1e-3, "{sample}: {estimate}");
    }
    assert!(largest > 5.0, "{largest}");
}

/// Half an increment from the target the controller sees no error; beyond, it sees a whole one.
#[test]
fn an_encoder_sees_whole_increments() {
    let mut control = PositionControl { encoder_resolution: 0.01, ..sampled(1e-3) };
    for (position, force) in [(0.9951, 0.0), (0.9949, 0.03), (1.0049, 0.0), (1.0149, -0.03)] {
        control.position = position;
        let mut moved = control;
        moved.step(1e-9);
        moved.output();
        assert_abs_diff_eq!(moved.external_force, force, epsilon = 1e-14);
    }
}

#[test]
fn samples_are_for_steps_alone() {
    let text = |fault: Result<(), Fault>| fault.map_err(|fault| fault.0);
    let why = "must be 0 for solvers that integrate rates, because a sampled controller acts in steps";
    assert_eq!(text(sampled(1e-3).check_model_exchange()), Err(format!("sample_time = 0.001: {why}")));
    assert_eq!(text(sampled(0.0).check_model_exchange()), Ok(()));
    for (control, expected) in [
        (sampled(1e-7), "sample_time = 0.0000001: must be 0 or >= 0.000001"),
        (
            PositionControl { encoder_resolution: 1e-6, ..sampled(0.0) },
            "encoder_resolution = 0.000001: must be 0 with sample_time = 0",
        ),
    ] {
        assert_eq!(text(control.check()), Err(expected.to_owned()));
    }
    let mut endless = sampled(1e-6);
    endless.step(1e3);
    assert!(endless.position.is_nan());
}

#[test]
fn a_step_of_too_many_samples_names_the_sample_time() {
    let mut control = sampled(1e-6);
    control.step(10.001);
    assert!(control.position.is_nan());
    let text = control.check_step(10.001).unwrap_err().0;
    assert_eq!(text, "sample_time = 1e-6 s: a step must be <= 10 s, in which the controller samples 10 million times");
    assert_eq!(control.check_step(10.0), Ok(()));
    assert_eq!(PositionControl::default().check_step(1e9), Ok(()));
}

/// A number that overflows in a step of few samples is not the fault of the sample time.
#[test]
fn a_gain_that_overflows_does_not_name_the_sample_time() {
    let mut control = Instance::new(by_name("PositionControl").expect("a host"));
    for (name, value) in [("sample_time", 1e-3), ("proportional_gain", 1e308), ("target_position", 1e3)] {
        control.set_by_name(name, value).expect(name);
    }
    let text = control.step(0.01).unwrap_err().to_string();
    assert!(text.starts_with("a step of 0.01 s would not be finite at"), "{text}");
    assert!(text.contains("target_position = 1000") && !text.contains("sample_time"), "{text}");
    control.set_by_name("sample_time", 1e-6).expect("a sample time");
    let text = control.step(20.0).unwrap_err().to_string();
    assert!(text.contains("sample_time = 1e-6 s: a step must be <= 10 s"), "{text}");
}
