//! Hosts: the mechanical systems that carry the friction models in a test.

crate::catalogue::family! {
    belt_rig::BeltRig,
}

mod magic_formula;
pub use magic_formula::{Contact, MagicFormula, Side, Wrench};
