//! The importer of the crate `fmi-rs`.

use std::path::Path;
use std::sync::Arc;

use anyhow::{Result, ensure};
use fmi_rs::fmi2::builder::FMU2Builder;
use fmi_rs::fmi2::types::{fmi2Status, fmi2True};
use fmi_rs::fmi2::{CS, FMU2};

use crate::master::Slave;

/// An instance, and the folder with its unpacked FMU.
pub struct FmiRs {
    instance: Arc<FMU2<CS>>,
    _builder: FMU2Builder,
}

/// Findings of the checks of `fmi-rs` for a description; none if the FMU is fine.
pub fn problems(path: &Path) -> Result<Vec<String>> {
    let builder = FMU2Builder::new(&path)?;
    Ok(builder.model_description.validate().into_iter().map(|problem| problem.message).collect())
}

impl Slave for FmiRs {
    fn open(path: &Path) -> Result<Self> {
        let builder = FMU2Builder::new(&path)?.loggingOn(true);
        let instance = builder.instantiate_cs("slave")?;
        Ok(Self { instance, _builder: builder })
    }

    fn initialise(&mut self) -> Result<()> {
        succeed(self.instance.setupExperiment(None, 0.0, None))?;
        succeed(self.instance.enterInitializationMode())?;
        succeed(self.instance.exitInitializationMode())
    }

    fn get(&mut self, variable: u32) -> Result<f64> {
        let mut value = [0.0];
        succeed(self.instance.getReal(&[variable], &mut value))?;
        Ok(value[0])
    }

    fn set(&mut self, variable: u32, value: f64) -> Result<()> {
        succeed(self.instance.setReal(&[variable], &[value]))
    }

    fn step(&mut self, time: f64, step: f64) -> Result<()> {
        succeed(self.instance.doStep(time, step, fmi2True))
    }

    fn terminate(self) -> Result<()> {
        succeed(self.instance.terminate())
    }
}

fn succeed(status: fmi2Status) -> Result<()> {
    ensure!(matches!(status, fmi2Status::Ok | fmi2Status::Warning), "{status:?}");
    Ok(())
}
