//! The friction laws and their hosts, one subject per file: what every law promises, published numbers and closed forms,
//! and how laws move bodies.

#[path = "../common/mod.rs"]
mod common;

mod belt;
mod components;
mod contract;
mod falling_load;
mod help_texts;
mod hosts;
mod many_elements;
mod published;
mod published_hysteresis;
mod published_lag;
mod published_memoryless;
mod published_presliding;
mod ramps_presliding;
mod slopes;
mod two_bodies;
