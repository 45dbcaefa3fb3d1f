//! The solvers by name.

use std::fmt;

#[cfg(feature = "foreign")]
use crate::solve::Foreign;
use crate::solve::Method;
use crate::system::{Motion, System};

/// A solver, with the class of MATLAB's solvers that it belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Solver {
    /// Rodas5P, or steps for systems with a part that has no rates.
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

impl Solver {
    /// The solver that runs a system: steps if a part has no rates.
    pub fn for_system(self, system: &System) -> Solver {
        match self {
            Solver::Auto if Motion::check(system).is_ok() => Solver::Rodas5P,
            Solver::Auto => Solver::Steps,
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
