//! A master on any importer: all FMUs step, then all values are exchanged (Jacobi).

use std::io::Write;
use std::path::Path;

use anyhow::{Context, Result};

use crate::plan::{Plan, Port};

/// Functions that a master needs from an importer.
pub trait Slave: Sized {
    /// Unpacks, loads and instantiates an FMU.
    fn open(path: &Path) -> Result<Self>;
    /// Goes through the initialisation mode.
    fn initialise(&mut self) -> Result<()>;
    /// Value of a real variable.
    fn get(&mut self, variable: u32) -> Result<f64>;
    /// Sets a real variable.
    fn set(&mut self, variable: u32, value: f64) -> Result<()>;
    /// Makes a communication step.
    fn step(&mut self, time: f64, step: f64) -> Result<()>;
    /// Ends the run.
    fn terminate(self) -> Result<()>;
}

/// Runs a plan and writes one line of watched values per step. The first failing call ends the run.
pub fn run<S: Slave>(plan: &Plan, out: &mut impl Write) -> Result<()> {
    let mut slaves = plan.fmus.iter().map(|path| S::open(path)).collect::<Result<Vec<S>>>()?;
    for &(port, value) in &plan.starts {
        slaves[port.component].set(port.variable, value).context("setting a variable")?;
    }
    slaves.iter_mut().try_for_each(Slave::initialise)?;
    // At the start, values propagate through all components.
    for _ in 0..slaves.len() {
        exchange(plan, &mut slaves)?;
    }
    for number in 0..plan.steps {
        advance(plan, &mut slaves, number, out).with_context(|| format!("step {}", number + 1))?;
    }
    slaves.into_iter().try_for_each(Slave::terminate)
}

fn advance<S: Slave>(plan: &Plan, slaves: &mut [S], number: usize, out: &mut impl Write) -> Result<()> {
    for (port, values) in &plan.signals {
        slaves[port.component].set(port.variable, values[number]).context("setting a variable")?;
    }
    for slave in slaves.iter_mut() {
        slave.step(number as f64 * plan.step, plan.step).context("a step")?;
    }
    let row = plan.watches.iter().map(|&port| Ok(get(slaves, port)?.to_string())).collect::<Result<Vec<_>>>()?;
    writeln!(out, "{}", row.join(" "))?;
    exchange(plan, slaves)
}

/// All outputs are read before the first input is set: the order of the connections must not matter.
fn exchange<S: Slave>(plan: &Plan, slaves: &mut [S]) -> Result<()> {
    let values = plan.links.iter().map(|&(from, _)| get(slaves, from)).collect::<Result<Vec<f64>>>()?;
    for (&(_, to), value) in plan.links.iter().zip(values) {
        slaves[to.component].set(to.variable, value).context("setting a variable")?;
    }
    Ok(())
}

fn get<S: Slave>(slaves: &mut [S], port: Port) -> Result<f64> {
    slaves[port.component].get(port.variable).context("reading a variable")
}
