//! Hosts: the mechanical systems that carry the friction models in a test.

crate::catalogue::family! {
    belt_rig::BeltRig,
}
