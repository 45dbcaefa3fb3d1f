//! The importer of the crate `fmi-rs` for FMI 3.0, with or without event mode.

use std::path::Path;
use std::sync::Arc;

use anyhow::{Result, ensure};
use fmi_rs::fmi3::FMU3;
use fmi_rs::fmi3::builder::FMU3Builder;
use fmi_rs::fmi3::types::fmi3Status;

use crate::master::Slave;

/// An instance, and the folder with its unpacked FMU.
pub struct FmiRs3<const EVENTS: bool> {
    instance: Arc<FMU3>,
    _builder: FMU3Builder,
}

/// Findings of the checks of `fmi-rs` for a description; none if the FMU is fine.
pub fn problems(path: &Path) -> Result<Vec<String>> {
    let builder = FMU3Builder::new(&path)?;
    Ok(builder.model_description.validate().into_iter().map(|problem| problem.message).collect())
}

impl<const EVENTS: bool> FmiRs3<EVENTS> {
    /// Leaves event mode.
    fn handle_event(&self) -> Result<()> {
        let [mut again, mut ends, mut nominals, mut values] = [true, false, false, false];
        while again {
            let event = &mut None;
            succeed(self.instance.updateDiscreteStates(&mut again, &mut ends, &mut nominals, &mut values, event))?;
            ensure!(!ends, "the FMU ends the simulation");
        }
        succeed(self.instance.enterStepMode())
    }
}

impl<const EVENTS: bool> Slave for FmiRs3<EVENTS> {
    fn open(path: &Path) -> Result<Self> {
        let mut builder = FMU3Builder::new(&path)?.loggingOn(true);
        (builder.eventModeUsed, builder.earlyReturnAllowed) = (EVENTS, EVENTS);
        let instance = builder.instantiate_cs("slave")?;
        Ok(Self { instance, _builder: builder })
    }

    fn initialise(&mut self) -> Result<()> {
        succeed(self.instance.enterInitializationMode(None, 0.0, None))?;
        succeed(self.instance.exitInitializationMode())?;
        if EVENTS { self.handle_event() } else { Ok(()) }
    }

    fn get(&mut self, variable: u32) -> Result<f64> {
        let mut value = [0.0];
        succeed(self.instance.getFloat64(&[variable], &mut value))?;
        Ok(value[0])
    }

    fn set(&mut self, variable: u32, value: f64) -> Result<()> {
        succeed(self.instance.setFloat64(&[variable], &[value]))
    }

    fn step(&mut self, time: f64, step: f64) -> Result<()> {
        let (mut at, end) = (time, time + step);
        while at < end {
            let [mut event, mut ends, mut early] = [false; 3];
            let mut reached = at;
            let span = if at == time { step } else { end - at };
            succeed(self.instance.doStep(at, span, true, &mut event, &mut ends, &mut early, &mut reached))?;
            ensure!(!ends && (EVENTS || !(event || early)), "the FMU returns early unasked");
            at = if early { reached } else { end };
            if event {
                succeed(self.instance.enterEventMode())?;
                self.handle_event()?;
            }
        }
        Ok(())
    }

    fn terminate(self) -> Result<()> {
        succeed(self.instance.terminate())
    }
}

fn succeed(status: fmi3Status) -> Result<()> {
    ensure!(status <= fmi3Status::Warning, "{status:?}");
    Ok(())
}
