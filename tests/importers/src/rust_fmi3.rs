//! The importer of the crate `fmi` for FMI 3.0.

use std::path::Path;

use anyhow::{Result, ensure};
use fmi::fmi3::import::Fmi3Import;
use fmi::fmi3::instance::InstanceCS;
use fmi::fmi3::{CoSimulation, Common, Fmi3Model, GetSet};

use crate::master::Slave;

/// An instance, and the folder with its unpacked FMU.
pub struct RustFmi3 {
    instance: InstanceCS,
    _import: Fmi3Import,
}

impl Slave for RustFmi3 {
    fn open(path: &Path) -> Result<Self> {
        let import: Fmi3Import = fmi::import::from_path(path)?;
        let instance = import.instantiate_cs("slave", false, true, false, false, &[])?;
        Ok(Self { instance, _import: import })
    }

    fn initialise(&mut self) -> Result<()> {
        self.instance.enter_initialization_mode(None, 0.0, None)?;
        self.instance.exit_initialization_mode()?;
        Ok(())
    }

    fn get(&mut self, variable: u32) -> Result<f64> {
        let mut value = [0.0];
        self.instance.get_float64(&[variable], &mut value)?;
        Ok(value[0])
    }

    fn set(&mut self, variable: u32, value: f64) -> Result<()> {
        self.instance.set_float64(&[variable], &[value])?;
        Ok(())
    }

    fn step(&mut self, time: f64, step: f64) -> Result<()> {
        let [mut event, mut ends, mut early] = [false; 3];
        let mut reached = time;
        self.instance.do_step(time, step, true, &mut event, &mut ends, &mut early, &mut reached)?;
        ensure!(!(event || ends || early), "the FMU returns early unasked");
        Ok(())
    }

    fn terminate(mut self) -> Result<()> {
        self.instance.terminate()?;
        Ok(())
    }
}
