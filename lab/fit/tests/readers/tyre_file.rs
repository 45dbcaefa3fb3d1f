//! Tyre property files.

use ssp::parameter_set::ParameterSet;
use stribeck_fit::tir;

pub fn read(bytes: &[u8]) {
    // As `tir::read` does.
    let Ok(file) = tir::parse("tyre.tir", &String::from_utf8_lossy(bytes)) else { return };
    for (variable, value) in file.set.values() {
        assert!(variable.admits(value), "{} = {value}", variable.path);
    }
    let set = ParameterSet::from_csv(file.set.model(), file.set.name(), &file.set.to_csv());
    assert_eq!(set.expect("what was written"), file.set);
}
