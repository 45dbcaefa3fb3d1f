//! The solvers by name.

use std::fmt;

use crate::couple::check_steps;
#[cfg(feature = "foreign")]
use crate::solve::Foreign;
use crate::solve::{Equations, Method};
use crate::system::{Fault, Motion, System};

/// A solver, with the class of MATLAB's solvers that it belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Solver {
    /// Rodas5P, or steps for systems with a part that has no rates, or rates steeper than states resolve.
    Auto,
    /// Rosenbrock method of order 5 with located events; exact for laws made of straight lines.
    #[value(name = "rodas5p")]
    Rodas5P,
    /// Modified Rosenbrock method 2(3), the class of ode23s.
    Rosenbrock23,
    /// Explicit Runge-Kutta method of order 5, of the crate ode_solvers, the class of ode45.
    #[cfg(feature = "foreign")]
    Dopri5,
    /// Explicit Runge-Kutta method of order 8, of the crate ode_solvers, the class of ode78; without events.
    #[cfg(feature = "foreign")]
    Dop853,
    /// Backward differentiation formulas of orders 1 to 5, of the crate diffsol, the class of ode15s.
    #[cfg(feature = "foreign")]
    Bdf,
    /// Trapezoidal rule with backward differentiation formula, of the crate diffsol, the class of ode23tb.
    #[cfg(feature = "foreign")]
    TrBdf2,
    /// Diagonally implicit Runge-Kutta method of order 3, of the crate diffsol.
    #[cfg(feature = "foreign")]
    Esdirk34,
    /// Steps of all models together, halved until two halves agree.
    Steps,
    /// A master of co-simulation with a fixed step.
    CoSimulation,
}

/// How a solver works.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// It solves the equations of motion by a method of ours.
    Own(Method),
    /// It solves the equations of motion by another crate.
    #[cfg(feature = "foreign")]
    Foreign(Foreign),
    /// It makes steps of the models.
    Steps,
    /// It is a master of co-simulation.
    CoSimulation,
}

/// Steepest rate at the start, in 1/s, that is taken to be resolved (chosen): where it is steeper, the rounding of a velocity
/// of 0.1 m/s is more than 1e-5 m/s2.
const STEEPEST: f64 = 1e12;

/// Refuses rates that are so steep at the start that their states hardly tell them.
pub(super) fn check_slopes(motion: &mut Motion) -> Result<(), Fault> {
    match motion.steepest() {
        Some((state, slope)) if slope > STEEPEST => Err(Fault::value(format_args!(
            "the rate of {} has a slope of {slope:.0e} 1/s at the start, which rounding hides: at most {STEEPEST:e} 1/s",
            motion.state_name(state)
        ))),
        _ => Ok(()),
    }
}

fn is_too_steep(system: &System) -> bool {
    Motion::new(system, &[]).is_ok_and(|mut motion| check_slopes(&mut motion).is_err())
}

impl Solver {
    /// The solver that runs a system: steps if a part has no rates, or if they can make steps where rates are too steep.
    pub fn for_system(self, system: &System) -> Solver {
        match self {
            Solver::Auto if Motion::check(system).is_err() => Solver::Steps,
            Solver::Auto if is_too_steep(system) && check_steps(system).is_ok() => Solver::Steps,
            Solver::Auto => Solver::Rodas5P,
            other => other,
        }
    }

    /// How it works.
    pub fn kind(self) -> Kind {
        match self {
            Solver::Auto | Solver::Rodas5P => Kind::Own(Method::Rodas5P),
            Solver::Rosenbrock23 => Kind::Own(Method::Rosenbrock23),
            #[cfg(feature = "foreign")]
            Solver::Dopri5 => Kind::Foreign(Foreign::Dopri5),
            #[cfg(feature = "foreign")]
            Solver::Dop853 => Kind::Foreign(Foreign::Dop853),
            #[cfg(feature = "foreign")]
            Solver::Bdf => Kind::Foreign(Foreign::Bdf),
            #[cfg(feature = "foreign")]
            Solver::TrBdf2 => Kind::Foreign(Foreign::TrBdf2),
            #[cfg(feature = "foreign")]
            Solver::Esdirk34 => Kind::Foreign(Foreign::Esdirk34),
            Solver::Steps => Kind::Steps,
            Solver::CoSimulation => Kind::CoSimulation,
        }
    }
}

impl fmt::Display for Solver {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        use clap::ValueEnum;
        match self.to_possible_value() {
            Some(value) => f.write_str(value.get_name()),
            None => Ok(()),
        }
    }
}
