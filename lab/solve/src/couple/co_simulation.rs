//! Co-simulation at communication points, as a master of FMUs does it.

use super::train::{Recorded, Train, is_host};
use crate::solve::{End, Grid, Options, Statistics};
use crate::system::{Fault, Place, System, Wire, WireSource};

/// Order in which a master exchanges values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Exchange {
    /// Laws and struts step first; the hosts then step with their forces (Gauss-Seidel).
    Sequential,
    /// The forces are read as soon as the inputs are set; then all parts step.
    Feedthrough,
    /// All parts step, then all values are exchanged (Jacobi): what most masters do.
    Parallel,
}

impl std::fmt::Display for Exchange {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(match self {
            Exchange::Sequential => "sequential",
            Exchange::Feedthrough => "feedthrough",
            Exchange::Parallel => "parallel",
        })
    }
}

/// A master.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Master {
    /// Communication step, in s.
    pub step: f64,
    /// Order of exchange.
    pub exchange: Exchange,
    /// Largest part by which a step is longer or shorter than the others, at random.
    pub jitter: f64,
}

impl Master {
    /// Rejects values that make no sense.
    pub fn check(&self) -> Result<(), Fault> {
        if !(self.step > 0.0 && self.step.is_finite()) {
            return Err(Fault::value(format_args!("step = {} s: must be > 0 and finite", self.step)));
        }
        if !(0.0..1.0).contains(&self.jitter) {
            return Err(Fault::value(format_args!("jitter = {}: must be >= 0 and < 1", self.jitter)));
        }
        Ok(())
    }
}

/// Runs a system. The interval of the results is that of the grid; they are those of the communication point at or
/// right after each output time.
pub fn co_simulation(
    system: &System,
    master: &Master,
    grid: Grid,
    options: &Options,
    recorded: &[WireSource],
) -> Result<(End, Statistics, Recorded), Fault> {
    master.check()?;
    let mut held = system.clone();
    hold(&mut held, master.exchange)?;
    let mut train = Train::new(&held)?;
    let mut statistics = Statistics::default();
    let mut table = (Vec::new(), vec![Vec::new(); recorded.len()]);
    let mut run =
        Run { train: &mut train, master, random: 0x9e37_79b9_7f4a_7c15, lost: 0.0, statistics: &mut statistics };
    let end = match run.go(grid, options, recorded, &mut table) {
        Ok(end) => end,
        Err(reason) => End::Failed { time: run.train.time, reason },
    };
    Ok((end, statistics, table))
}

/// Tells laws that can hold a body its mass and the order of exchange, unless they were set.
pub fn hold(system: &mut System, exchange: Exchange) -> Result<(), Fault> {
    for (to, from) in system.description.hold.clone() {
        let (Ok(to), from) = (system.place(&to), system.place(&from)?) else { continue };
        let value = system.parts[from.part].known(from.column);
        system.parts[to.part].follow(to.column, value);
        let model = system.parts[to.part].model;
        if let Some(column) = model.find("exchange") {
            let number = if exchange == Exchange::Parallel { 2.0 } else { 1.0 };
            system.parts[to.part].follow(column, number);
        }
    }
    Ok(())
}

struct Run<'a, 'b> {
    train: &'a mut Train<'b>,
    master: &'a Master,
    random: u64,
    /// Part of the present time that its last digit has lost: steps of 1 ms then meet whole seconds after any time.
    lost: f64,
    statistics: &'a mut Statistics,
}

impl Run<'_, '_> {
    fn go(
        &mut self,
        grid: Grid,
        options: &Options,
        recorded: &[WireSource],
        (times, values): &mut Recorded,
    ) -> Result<End, String> {
        self.train.settle()?;
        let mut number = 0;
        loop {
            let time = self.train.time;
            let reached = time + 1e-9 * self.master.step + 4.0 * f64::EPSILON * time;
            if number < grid.len() && grid.time(number) <= reached {
                times.push(time);
                for (column, source) in values.iter_mut().zip(recorded) {
                    column.push(self.train.value(*source)?);
                }
                while number < grid.len() && grid.time(number) <= reached {
                    number += 1;
                }
            }
            if number == grid.len() {
                return Ok(End::Reached);
            }
            if self.statistics.steps.is_multiple_of(1024) {
                if options.is_cancelled() {
                    return Ok(End::Cancelled { time });
                }
                if let Some(progress) = options.progress {
                    progress.reached(time);
                }
            }
            let h = self.next_step(grid.end - time);
            self.step(h)?;
            self.statistics.steps += 1;
            self.statistics.evaluations += 1;
        }
    }

    /// Length of the next step, which ends with the run.
    fn next_step(&mut self, rest: f64) -> f64 {
        let Master { step, jitter, .. } = *self.master;
        let h = step * (1.0 + jitter * (2.0 * self.uniform() - 1.0));
        if h >= rest * (1.0 - 1e-9) { rest } else { h }
    }

    /// A random number between 0 and 1 (xorshift); the same in every run.
    fn uniform(&mut self) -> f64 {
        self.random ^= self.random << 13;
        self.random ^= self.random >> 7;
        self.random ^= self.random << 17;
        (self.random >> 11) as f64 / (1u64 << 53) as f64
    }

    fn step(&mut self, h: f64) -> Result<(), String> {
        // Kahan's sum.
        let length = h - self.lost;
        let end = self.train.time + length;
        self.lost = (end - self.train.time) - length;
        match self.master.exchange {
            Exchange::Sequential => {
                self.signals()?;
                self.pass(|to_host| !to_host)?;
                self.advance(h, |is_host| !is_host)?;
                self.pass(|to_host| to_host)?;
                self.advance(h, |is_host| is_host)?;
            }
            Exchange::Feedthrough => {
                self.signals()?;
                self.pass(|to_host| !to_host)?;
                self.pass(|to_host| to_host)?;
                self.advance(h, |_| true)?;
            }
            Exchange::Parallel => {
                self.signals()?;
                self.pass(|to_host| to_host)?;
                self.pass(|to_host| !to_host)?;
                self.advance(h, |_| true)?;
            }
        }
        self.train.time = end;
        Ok(())
    }

    fn signals(&mut self) -> Result<(), String> {
        for (place, signal) in self.train.system.signals.clone() {
            self.train.put(place, signal.at(self.train.time).0)?;
        }
        Ok(())
    }

    /// Passes values on to hosts, or to what acts on them. All are read before any is set.
    fn pass(&mut self, chosen: impl Fn(bool) -> bool) -> Result<(), String> {
        let system = self.train.system;
        let wires: Vec<Wire> =
            system.wires.iter().filter(|wire| chosen(is_host(system, wire.to.part))).copied().collect();
        let values: Vec<(Place, f64)> =
            wires.iter().map(|wire| Ok((wire.to, self.train.value(wire.from)?))).collect::<Result<_, String>>()?;
        values.into_iter().try_for_each(|(to, value)| self.train.put(to, value))
    }

    fn advance(&mut self, h: f64, chosen: impl Fn(bool) -> bool) -> Result<(), String> {
        for part in self.train.order.clone() {
            if chosen(is_host(self.train.system, part)) {
                self.train.step(part, h)?;
            }
        }
        Ok(())
    }
}
