//! The system to run: the text explained in examples/c/system_master.c, but with the .fmu files themselves.

use std::path::PathBuf;
use std::str::{FromStr, SplitWhitespace};

use anyhow::{Context, Result, bail, ensure};

/// A variable of a component: its value reference.
#[derive(Clone, Copy)]
pub struct Port {
    pub component: usize,
    pub variable: u32,
}

/// FMUs with their start values, the connections between them, the values of free inputs step by step, and the watched
/// variables.
#[derive(Default)]
pub struct Plan {
    pub step: f64,
    pub steps: usize,
    pub fmus: Vec<PathBuf>,
    pub starts: Vec<(Port, f64)>,
    pub links: Vec<(Port, Port)>,
    pub signals: Vec<(Port, Vec<f64>)>,
    pub watches: Vec<Port>,
}

impl Plan {
    /// Reads the text line by line.
    pub fn read(text: &str) -> Result<Self> {
        let mut plan = Self::default();
        for line in text.lines() {
            plan.read_line(line).with_context(|| format!("in the line '{line:.60}'"))?;
        }
        Ok(plan)
    }

    fn read_line(&mut self, line: &str) -> Result<()> {
        let mut words = line.split_whitespace();
        match words.next() {
            None => {}
            Some("step") => self.step = next(&mut words)?,
            Some("steps") => self.steps = next(&mut words)?,
            // The path is the text after the guid, which both importers read from the FMU.
            Some("fmu") => self.fmus.push(line.splitn(3, ' ').nth(2).context("no path")?.into()),
            Some("start") => self.starts.push((self.port(&mut words)?, next(&mut words)?)),
            Some("link") => self.links.push((self.port(&mut words)?, self.port(&mut words)?)),
            Some("signal") => {
                let port = self.port(&mut words)?;
                let values = (0..self.steps).map(|_| next(&mut words)).collect::<Result<_>>()?;
                self.signals.push((port, values));
            }
            Some("watch") => self.watches.push(self.port(&mut words)?),
            Some(other) => bail!("unknown keyword {other}"),
        }
        Ok(())
    }

    fn port(&self, words: &mut SplitWhitespace<'_>) -> Result<Port> {
        let port = Port { component: next(words)?, variable: next(words)? };
        ensure!(port.component < self.fmus.len(), "there is no component {}", port.component);
        Ok(port)
    }
}

fn next<T: FromStr>(words: &mut SplitWhitespace<'_>) -> Result<T> {
    let word = words.next().context("a word is missing")?;
    word.parse().ok().with_context(|| format!("'{word}' is not a number"))
}
