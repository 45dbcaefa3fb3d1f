//! Solvers against closed forms.

use super::*;

/// x'' = -x, or a ball that is thrown up again at each landing.
struct Analytic {
    kind: Kind,
    /// Whether they say that they are linear between events.
    linear: bool,
    scales: Vec<f64>,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Oscillator,
    /// x' = -1e6 (x - cos t) - sin t: stiff, solution cos t.
    Stiff,
    /// Nine oscillators of frequencies 1, 2 ... 9, one after the other.
    Nine,
    /// Height and velocity; the velocity is reversed on the ground.
    Ball,
    /// x'' = -sin x.
    Pendulum,
    /// x_0' = 0.1, x_1' = -1e6 (x_1 - x_0 / 3 - 0.3): stiff, at rest beside something that moves.
    Following,
    /// An oscillator whose indicator is the distance to a wall.
    Wall(f64),
    /// x' = 1, as long as x <= 0.5.
    Ending,
}

impl Equations for Analytic {
    fn states(&self) -> usize {
        match self.kind {
            Kind::Stiff | Kind::Ending => 1,
            Kind::Nine => 18,
            Kind::Oscillator | Kind::Ball | Kind::Pendulum | Kind::Following | Kind::Wall(_) => 2,
        }
    }

    fn state_name(&self, state: usize) -> String {
        assert!(state < self.states(), "{state} is the number of no state");
        format!("x{state}")
    }

    fn scales(&self) -> &[f64] {
        &self.scales
    }

    fn rates(&mut self, time: f64, x: &[f64], rates: &mut [f64]) {
        match self.kind {
            Kind::Oscillator | Kind::Wall(_) => rates.copy_from_slice(&[x[1], -x[0]]),
            Kind::Nine => {
                for (number, (rates, x)) in rates.chunks_mut(2).zip(x.chunks(2)).enumerate() {
                    let w = (number + 1) as f64;
                    rates.copy_from_slice(&[w * x[1], -w * x[0]]);
                }
            }
            Kind::Stiff => rates[0] = -1e6 * (x[0] - time.cos()) - time.sin(),
            Kind::Ending => rates[0] = if x[0] > 0.5 { f64::NAN } else { 1.0 },
            Kind::Ball => rates.copy_from_slice(&[x[1], -10.0]),
            Kind::Following => rates.copy_from_slice(&[0.1, -1e6 * (x[1] - x[0] / 3.0 - 0.3)]),
            Kind::Pendulum => rates.copy_from_slice(&[x[1], -x[0].sin()]),
        }
    }

    fn jacobian(&mut self, time: f64, x: &[f64], jacobian: &mut [f64], by_time: &mut [f64]) {
        match self.kind {
            Kind::Oscillator | Kind::Wall(_) => jacobian.copy_from_slice(&[0.0, 1.0, -1.0, 0.0]),
            Kind::Stiff => {
                jacobian[0] = -1e6;
                by_time[0] = -1e6 * time.sin() - time.cos();
                return;
            }
            Kind::Ending => jacobian[0] = 0.0,
            Kind::Ball => jacobian.copy_from_slice(&[0.0, 1.0, 0.0, 0.0]),
            Kind::Following => jacobian.copy_from_slice(&[0.0, 0.0, 1e6 / 3.0, -1e6]),
            Kind::Pendulum => jacobian.copy_from_slice(&[0.0, 1.0, -x[0].cos(), 0.0]),
            Kind::Nine => {
                jacobian.fill(0.0);
                for number in 0..9 {
                    let (w, at) = ((number + 1) as f64, 2 * number);
                    jacobian[at * 18 + at + 1] = w;
                    jacobian[(at + 1) * 18 + at] = -w;
                }
            }
        }
        by_time.fill(0.0);
    }

    fn indicators(&self) -> usize {
        usize::from(matches!(self.kind, Kind::Ball | Kind::Wall(_)))
    }

    fn indicator_name(&self, _indicator: usize) -> String {
        "ground".to_owned()
    }

    fn indicate(&mut self, _time: f64, x: &[f64], indicators: &mut [f64]) {
        match self.kind {
            Kind::Ball => indicators[0] = x[0],
            Kind::Wall(place) => indicators[0] = x[0] - place,
            _ => {}
        }
    }

    fn is_piecewise_linear(&self) -> bool {
        self.linear
    }

    fn at_event(&mut self, _time: f64, x: &mut [f64]) -> Result<(), String> {
        if self.kind == Kind::Ball && x[0] <= 0.0 {
            (x[0], x[1]) = (0.0, x[1].abs());
        }
        Ok(())
    }
}

fn run(kind: Kind, method: Method, tolerance: f64, end: f64, start: &[f64]) -> (Vec<f64>, Statistics, Recorder) {
    let equations = Analytic { kind, linear: false, scales: vec![1.0; start.len()] };
    run_equations(equations, method, tolerance, end, start)
}

/// Equations that say that they are linear between events.
fn run_linear(kind: Kind, end: f64, start: &[f64]) -> (Vec<f64>, Statistics, Recorder) {
    run_equations(Analytic { kind, linear: true, scales: vec![1.0; start.len()] }, Method::Rodas5P, 1e-3, end, start)
}

fn run_equations(
    mut equations: Analytic,
    method: Method,
    tolerance: f64,
    end: f64,
    start: &[f64],
) -> (Vec<f64>, Statistics, Recorder) {
    let mut states = start.to_vec();
    let mut recorder = Recorder::new(Grid { begin: 0.0, end, intervals: 1000 }, &equations);
    let (end, statistics) = solve(method, &mut equations, &mut states, &Options::new(end, tolerance), &mut recorder);
    assert_eq!(end, End::Reached);
    (states, statistics, recorder)
}

#[test]
fn an_oscillator_keeps_its_circle() {
    for (method, tolerance, bound) in [(Method::Rodas5P, 1e-10, 1e-8), (Method::Rosenbrock23, 1e-7, 3e-4)] {
        let (_, _, recorder) = run(Kind::Oscillator, method, tolerance, 20.0, &[1.0, 0.0]);
        for (number, time) in recorder.times().enumerate() {
            let error = (recorder.states[0][number] - time.cos()).abs();
            assert!(error < bound, "{method:?} at {time}: {error}");
        }
        assert_eq!(recorder.len(), 1001);
    }
}

/// Eighteen states, for which no method has code of its own: further ones rest at 0.
#[test]
fn many_states_move_as_each_by_itself() {
    let start: Vec<f64> = [1.0, 0.0].repeat(9);
    for (method, tolerance, end, bound) in
        [(Method::Rodas5P, 1e-10, 7.0, 1e-7), (Method::Rosenbrock23, 1e-7, 0.5, 3e-4)]
    {
        let (states, _, _) = run(Kind::Nine, method, tolerance, end, &start);
        for (number, x) in states.chunks(2).enumerate() {
            let expected = ((number + 1) as f64 * end).cos();
            assert!((x[0] - expected).abs() < bound, "{method:?} {number}: {} {expected}", x[0]);
        }
    }
}

/// The state is named whose rate has no value from somewhere on, also by a method that has code for two states only.
#[test]
fn a_rate_that_ends_is_an_honest_failure() {
    for method in [Method::Rodas5P, Method::Rosenbrock23] {
        let mut equations = Analytic { kind: Kind::Ending, linear: false, scales: vec![1.0] };
        let mut recorder = Recorder::new(Grid { begin: 0.0, end: 1.0, intervals: 4 }, &equations);
        let (end, _) = solve(method, &mut equations, &mut [0.0], &Options::new(1.0, 1e-6), &mut recorder);
        let End::Failed { time, reason } = end else { panic!("{method:?}: {end}") };
        assert!(
            (time - 0.5).abs() < 1e-9 && reason.ends_with("is still too long for x0"),
            "{method:?} {time} {reason}"
        );
    }
}

#[test]
fn a_stiff_equation_takes_few_steps() {
    let (states, statistics, _) = run(Kind::Stiff, Method::Rodas5P, 1e-8, 10.0, &[1.0]);
    assert!((states[0] - 10f64.cos()).abs() < 1e-7, "{states:?}");
    assert!(statistics.steps < 300, "{statistics:?}");
}

/// A ball thrown up at 1 m/s lands after 0.2 s and so on.
#[test]
fn landings_are_located() {
    let (_, statistics, _) = run(Kind::Ball, Method::Rodas5P, 1e-9, 1.05, &[0.0, 1.0]);
    let times: Vec<f64> = statistics.events.iter().map(|event| event.time).collect();
    assert_eq!(times.len(), 5, "{times:?}");
    for (number, time) in times.iter().enumerate() {
        assert!((time - 0.2 * (number + 1) as f64).abs() < 1e-13, "{times:?}");
    }
}

/// cos t is beyond -1 + d for the time 2 arccos(1 - d) only, much shorter than a step.
#[test]
fn a_wall_that_is_only_touched_is_noticed() {
    for depth in [1e-6, 1e-5, 1e-4, 1e-3, 1e-2] {
        for side in [1.0, -1.0] {
            let wall = Kind::Wall(side * (depth - 1.0));
            for tolerance in [1e-9, 1e-10, 1e-11] {
                let (_, statistics, _) = run(wall, Method::Rodas5P, tolerance, 20.0, &[side, 0.0]);
                let times: Vec<f64> = statistics.events.iter().map(|event| event.time).collect();
                let half = f64::acos(1.0 - depth);
                let turns = [1.0, 3.0, 5.0].map(|turn| turn * std::f64::consts::PI);
                let expected: Vec<f64> = turns.iter().flat_map(|turn| [turn - half, turn + half]).collect();
                assert_eq!(times.len(), expected.len(), "{depth} {tolerance}: {times:?} {expected:?}");
                for (time, expected) in times.iter().zip(expected) {
                    assert!((time - expected).abs() < 1e3 * tolerance / half, "{depth} {tolerance}: {time} {expected}");
                }
            }
        }
    }
}

/// A coarse tolerance says nothing about them.
#[test]
fn equations_that_are_linear_between_events_are_solved_exactly() {
    let (_, statistics, recorder) = run_linear(Kind::Oscillator, 20.0, &[1.0, 0.0]);
    assert!(statistics.steps < 40 && statistics.jacobians == 1, "{statistics:?}");
    for (number, time) in recorder.times().enumerate() {
        let errors = [recorder.states[0][number] - time.cos(), recorder.states[1][number] + time.sin()];
        assert!(errors.iter().all(|error| error.abs() < 3e-14), "{errors:?} at {time}");
    }
    let (_, statistics, _) = run_linear(Kind::Ball, 1.05, &[0.0, 1.0]);
    let times = statistics.events.iter().map(|event| event.time);
    let worst = times.enumerate().map(|(number, time)| (time - 0.2 * (number + 1) as f64).abs()).fold(0.0, f64::max);
    assert!(statistics.events.len() == 5 && worst < 2e-14, "{worst}: {:?}", statistics.events);
}

/// Rounding errors of a stiff state do not keep the steps short.
#[test]
fn exact_steps_of_a_stiff_state_at_rest_are_long() {
    let (states, statistics, _) = run_linear(Kind::Following, 40.0, &[0.0, 0.0]);
    assert!((states[1] - (4.0 / 3.0 + 0.3 - 0.1 / 3e6)).abs() < 1e-13, "{states:?}");
    assert!(statistics.steps < 30, "{statistics:?}");
}

#[test]
fn a_wall_that_is_only_touched_is_noticed_in_exact_steps() {
    for depth in [1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2] {
        for side in [1.0, -1.0] {
            let (_, statistics, _) = run_linear(Kind::Wall(side * (depth - 1.0)), 20.0, &[side, 0.0]);
            let half = f64::acos(1.0 - depth);
            let turns = [1.0, 3.0, 5.0].map(|turn| turn * std::f64::consts::PI);
            let expected = turns.iter().flat_map(|turn| [turn - half, turn + half]);
            assert_eq!(statistics.events.len(), 6, "{depth}: {:?}", statistics.events);
            for (event, expected) in statistics.events.iter().zip(expected) {
                // The position, to 1e-14, says when.
                assert!((event.time - expected).abs() < 1e-14 / half + 1e-14, "{depth}: {event:?} {expected}");
            }
        }
    }
}

/// A pendulum that says that it is linear is found out in its first step, even where it nearly is.
#[test]
fn equations_that_only_say_that_they_are_linear_are_solved_otherwise() {
    for (start, tolerance) in [(2.0, 1e-4), (2.0, 1e-8), (1e-3, 1e-12)] {
        let solved = |linear: bool, tolerance: f64| {
            let equations = Analytic { kind: Kind::Pendulum, linear, scales: vec![1.0; 2] };
            run_equations(equations, Method::Rodas5P, tolerance, 10.0, &[start, 0.0])
        };
        let (exact, _, _) = solved(false, 1e-2 * tolerance);
        let [(said, statistics, _), (plain, others, _)] = [true, false].map(|linear| solved(linear, tolerance));
        let [error, usual] = [&said, &plain].map(|states| (states[0] - exact[0]).abs());
        assert!(error < 2.0 * usual + tolerance, "{error:e} {usual:e}");
        assert!(statistics.rejected <= others.rejected + 4, "{statistics:?} {others:?}");
    }
}

/// Exact steps end at events: without events, the method itself goes on.
#[test]
fn without_events_no_step_is_exact() {
    let mut equations = Analytic { kind: Kind::Oscillator, linear: true, scales: vec![1.0; 2] };
    let mut recorder = Recorder::new(Grid { begin: 0.0, end: 1.0, intervals: 1 }, &equations);
    let options = Options { events: false, ..Options::new(1.0, 1e-8) };
    let (end, statistics) = solve(Method::Rodas5P, &mut equations, &mut [1.0, 0.0], &options, &mut recorder);
    assert!(end.is_reached() && statistics.jacobians == statistics.steps + 1, "{statistics:?}");
}
