//! FMUs, the package of the four-post rig, the kit for C.

pub mod archive;
pub mod experiment;
pub mod four_post;
pub mod licenses;
pub mod package;
pub mod related;
pub mod sbom;
pub mod sdk;
