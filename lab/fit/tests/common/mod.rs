//! What the tests of spoilt records have in common.

use stribeck::catalogue::by_name;
use stribeck_fit::rig::{Faults, VirtualRig};

/// A short run of a rig with these faults.
pub fn rig(faults: Faults) -> VirtualRig {
    let law = by_name("Dahl").expect("the law");
    VirtualRig { law, values: Vec::new(), mass: 1.0, normal_force: 20.0, duration: 0.3, faults, seed: 1 }
}
