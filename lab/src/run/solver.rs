//! The solvers by name.

use std::fmt;

use crate::solve::Method;
use crate::system::{Motion, System};

/// A solver, with the class of MATLAB's solvers that it belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Solver {
    /// Rodas5P, or steps for systems with a law that has no rates.
    Auto,
    /// Rosenbrock method of order 5 with located events.
    #[value(name = "rodas5p")]
    Rodas5P,
    /// Modified Rosenbrock method 2(3), the class of ode23s.
    Rosenbrock23,
    /// Steps of all models together, halved until two halves agree.
    Steps,
    /// A master of co-simulation with a fixed step.
    CoSimulation,
}

impl Solver {
    /// The solver that runs a system: steps if a part has no rates.
    pub fn for_system(self, system: &System) -> Solver {
        match self {
            Solver::Auto if Motion::new(system, &[]).is_ok() => Solver::Rodas5P,
            Solver::Auto => Solver::Steps,
            other => other,
        }
    }

    /// Our method of that name.
    pub fn method(self) -> Option<Method> {
        match self {
            Solver::Rodas5P => Some(Method::Rodas5P),
            Solver::Rosenbrock23 => Some(Method::Rosenbrock23),
            Solver::Auto | Solver::Steps | Solver::CoSimulation => None,
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
