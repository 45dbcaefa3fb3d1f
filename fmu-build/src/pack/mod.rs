//! FMUs, and the package of the four-post rig.

pub mod archive;
pub mod experiment;
pub mod four_post;
pub mod licenses;
pub mod package;
pub mod related;
pub mod sbom;
