//! Karnopp's law as it is printed: without events, in the classes of solvers of the thesis.

use std::sync::atomic::AtomicBool;
use std::time::Instant;

use super::page::in_thesis;
use super::{EVERY, RIGHT, Reference, belt};
use stribeck_solve::run::{Kind, Settings, Solver};
use stribeck_solve::solve::{End, Equations, Grid, Method, Options, Recorder, Statistics, solve, solve_foreign};
use stribeck_solve::system::{Fault, System};

/// The law with a band, which is the one that a solver of the thesis could not bring to its end.
const LAW: &str = "Karnopp";

/// The block on the belt. The force jumps where the velocity enters or leaves the band, and no event says so.
struct Printed {
    mass: f64,
    stiffness: f64,
    belt: f64,
    /// Kinetic and static level.
    levels: [f64; 2],
    /// Half the width of the band.
    band: f64,
    start: [f64; 2],
}

impl Printed {
    fn of(system: &System) -> Result<Printed, Fault> {
        let value = |name: &str| system.place(name).map(|place| system.parts[place.part].row[place.column]);
        let weight = value("rig.mass")? * value("rig.gravity")?;
        Ok(Printed {
            mass: value("rig.mass")?,
            stiffness: value("rig.stiffness")?,
            belt: value("rig.belt_velocity")?,
            levels: [value("friction.mu_k")? * weight, value("friction.mu_s")? * weight],
            band: value("friction.transition_velocity")?,
            start: [value("rig.position")?, value("rig.block_velocity")?],
        })
    }

    fn acceleration(&self, position: f64, speed: f64) -> f64 {
        let velocity = speed - self.belt;
        let spring = self.stiffness * position;
        let [kinetic, breakaway] = self.levels;
        let is_inside = velocity.abs() < self.band;
        let force = if is_inside { spring.clamp(-breakaway, breakaway) } else { -kinetic * velocity.signum() };
        (force - spring) / self.mass
    }
}

impl Equations for Printed {
    fn states(&self) -> usize {
        2
    }

    fn state_name(&self, state: usize) -> String {
        ["position", "speed"][state].to_owned()
    }

    fn scales(&self) -> &[f64] {
        &[1.0, 1.0]
    }

    fn rates(&mut self, _time: f64, x: &[f64], rates: &mut [f64]) {
        rates.copy_from_slice(&[x[1], self.acceleration(x[0], x[1])]);
    }

    /// By differences, as a solver finds it that knows nothing of the law.
    fn jacobian(&mut self, _time: f64, x: &[f64], jacobian: &mut [f64], by_time: &mut [f64]) {
        let here = self.acceleration(x[0], x[1]);
        let [by_position, by_speed] = [x[0], x[1]].map(|x| f64::EPSILON.sqrt() * x.abs().max(1e-8));
        jacobian.copy_from_slice(&[
            0.0,
            1.0,
            (self.acceleration(x[0] + by_position, x[1]) - here) / by_position,
            (self.acceleration(x[0], x[1] + by_speed) - here) / by_speed,
        ]);
        by_time.fill(0.0);
    }

    fn indicators(&self) -> usize {
        0
    }

    fn indicator_name(&self, _indicator: usize) -> String {
        String::new()
    }

    fn indicate(&mut self, _time: f64, _x: &[f64], _indicators: &mut [f64]) {}

    fn at_event(&mut self, _time: f64, _x: &mut [f64]) -> Result<(), String> {
        Ok(())
    }
}

/// Runs the printed law with a solver; the positions at the times of the benchmark.
fn attempt(
    printed: &mut Printed,
    solver: Solver,
    tolerance: f64,
    grid: Grid,
    cancel: Option<&AtomicBool>,
) -> (End, Statistics, Vec<f64>) {
    let mut recorder = Recorder::new(grid, printed);
    let options = Options { events: false, cancel, ..Options::new(grid.end, tolerance) };
    let mut states = printed.start;
    let (end, statistics) = match solver.kind() {
        Kind::Foreign(foreign) => solve_foreign(foreign, printed, &mut states, &options, &mut recorder),
        Kind::Own(method) => solve(method, printed, &mut states, &options, &mut recorder),
        Kind::Steps | Kind::CoSimulation => solve(Method::Rodas5P, printed, &mut states, &options, &mut recorder),
    };
    (end, statistics, recorder.states.swap_remove(0))
}

/// The section of the page on the printed law, with the times of the thesis beside; empty if the law was not measured.
pub fn section(
    tolerance: f64,
    references: &[(String, Result<Reference, String>)],
    settings: &Settings,
) -> Result<String, Fault> {
    let measured = references.iter().find(|(law, _)| law == LAW);
    let Some((_, Ok(reference))) = measured else { return Ok(String::new()) };
    let system = belt(LAW)?;
    let mut printed = Printed::of(&system)?;
    let grid = Grid { begin: 0.0, end: settings.until, intervals: (settings.until / EVERY).round() as usize };
    let mut text = format!("{}{tolerance:e}{}", HEAD[0], HEAD[1]);
    for (solver, class, seconds) in in_thesis(LAW) {
        let begin = Instant::now();
        let (end, Statistics { steps, evaluations, .. }, position) =
            attempt(&mut printed, solver, tolerance, grid, settings.cancel);
        let passed = begin.elapsed().as_secs_f64();
        let result = verdict(end, reference.error(&position));
        text += &format!("| {solver} ({class}) | {steps} | {evaluations} | {passed:.2} | {result} | {seconds} |\n");
    }
    Ok(text + WHY)
}

/// The error, if the run came to its end; in bold if it is large.
fn verdict(end: End, error: f64) -> String {
    match end {
        End::Reached if error <= RIGHT => format!("{error:.0e}"),
        End::Reached => format!("**{error:.0e}**"),
        end => end.to_string(),
    }
}

/// Text before the table: up to the tolerance, and from it on.
const HEAD: [&str; 2] = [
    "## Karnopp's law as it is printed\n\nInside its band the printed law carries whatever acts on the block; where \
     the velocity enters or leaves the band\nthe force jumps, and no event says so. The same solvers at ",
    ", with Jacobians by differences where they need\none:\n\n| solver | steps | evaluations | seconds | largest error \
     in m | thesis, seconds |\n|---|---|---|---|---|---|\n",
];

const WHY: &str = "
The block enters the band with what is left of its acceleration, 0.49 m/s2, and then feels none. A step of the class of
ode23s asks for the rate at its middle. Just outside the band the middle already lies inside, where the rate is zero, so
that the end of the step stays outside: the block follows the edge without entering, in steps just long enough for their
middle to reach it. The distance from the edge is of the size of the tolerance, and the number of steps grows as its
inverse: 2,030 in these 40 s at 1e-4, 194,350 at 1e-6, 18 million at 1e-8. At 1e-5 and 1e-7 a step happens to cross. This
may be why ode23s \"did not converge\" in the thesis. `rosenbrock23` of this library takes a step only if the rates at its
end confirm it; they do not, the step becomes shorter, and the block passes the edge: 346 steps at 1e-4, 1,079 at 1e-6.

";

#[cfg(test)]
mod tests {
    use super::*;

    fn steps(solver: Solver, tolerance: f64) -> f64 {
        let mut printed = Printed::of(&belt(LAW).unwrap()).unwrap();
        let grid = Grid { begin: 0.0, end: 40.0, intervals: 10 };
        let (end, statistics, _) = attempt(&mut printed, solver, tolerance, grid, None);
        assert_eq!(end, End::Reached, "{solver} {tolerance:e}");
        statistics.steps as f64
    }

    /// Taken without a look at its end, a step of the class of ode23s follows the edge: 194,350 steps at 1e-6.
    #[test]
    fn the_printed_law_does_not_hold_a_solver_up() {
        for solver in [Solver::Rosenbrock23, Solver::Rodas5P] {
            let [loose, tight] = [1e-4, 1e-6].map(|tolerance| steps(solver, tolerance));
            assert!(tight < 4.0 * loose && tight < 2000.0, "{solver}: {loose} and {tight} steps");
        }
    }

    /// The same motion as the law with events, but for the jumps that steps extend across.
    #[test]
    fn the_printed_law_is_that_of_the_catalogue() {
        let system = belt(LAW).unwrap();
        let mut printed = Printed::of(&system).unwrap();
        let settings = Settings { every: 1e-2, until: 12.0, ..Settings::of(&system) };
        let reference = Reference::of(&system, &settings).unwrap();
        let grid = Grid { begin: 0.0, end: 12.0, intervals: 1200 };
        let (_, _, position) = attempt(&mut printed, Solver::Rodas5P, 1e-10, grid, None);
        assert!(reference.error(&position) < 1e-4, "{}", reference.error(&position));
    }
}
