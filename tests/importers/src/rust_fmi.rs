//! The importer of the crate `fmi`.

use std::path::Path;

use anyhow::Result;
use fmi::fmi2::import::Fmi2Import;
use fmi::fmi2::instance::{CoSimulation, Common, InstanceCS};

use crate::master::Slave;

/// An instance, and the folder with its unpacked FMU.
pub struct RustFmi {
    instance: InstanceCS,
    _import: Fmi2Import,
}

impl Slave for RustFmi {
    fn open(path: &Path) -> Result<Self> {
        let import: Fmi2Import = fmi::import::from_path(path)?;
        let instance = import.instantiate_cs("slave", false, true)?;
        Ok(Self { instance, _import: import })
    }

    fn initialise(&mut self) -> Result<()> {
        self.instance.setup_experiment(None, 0.0, None)?;
        self.instance.enter_initialization_mode()?;
        self.instance.exit_initialization_mode()?;
        Ok(())
    }

    fn get(&mut self, variable: u32) -> Result<f64> {
        let mut value = [0.0];
        self.instance.get_real(&[variable], &mut value)?;
        Ok(value[0])
    }

    fn set(&mut self, variable: u32, value: f64) -> Result<()> {
        self.instance.set_real(&[variable], &[value])?;
        Ok(())
    }

    fn step(&mut self, time: f64, step: f64) -> Result<()> {
        self.instance.do_step(time, step, true)?;
        Ok(())
    }

    fn terminate(mut self) -> Result<()> {
        self.instance.terminate()?;
        Ok(())
    }
}
