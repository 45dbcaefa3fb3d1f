//! Parameter sets as CSV and as XML. The first line of the input names the model.
#![no_main]

use libfuzzer_sys::fuzz_target;
use ssp::parameter_set::{ParameterSet, choice};
use stribeck::catalogue;

fuzz_target!(|text: &str| {
    let Some((name, text)) = text.split_once('\n') else { return };
    let Some(model) = catalogue::by_name(name) else { return };
    if let Ok(set) = ParameterSet::from_csv(model, "set", text) {
        check(&set);
    }
    if let Ok(set) = ParameterSet::from_ssv(model, text) {
        check(&set);
    }
    let _ = text.split_once(',').map(|(variable, value)| choice(model, variable, value));
});

/// A set that was read can be written and read again, in both formats.
fn check(set: &ParameterSet) {
    for (variable, value) in set.values() {
        assert!(variable.admits(value), "{} = {value}", variable.path);
    }
    let csv = set.to_csv();
    assert_eq!(&ParameterSet::from_csv(set.model(), set.name(), &csv).expect("what was written"), set, "{csv}");
    let xml = set.to_ssv();
    assert_eq!(&ParameterSet::from_ssv(set.model(), &xml).expect("what was written"), set, "{xml}");
}
