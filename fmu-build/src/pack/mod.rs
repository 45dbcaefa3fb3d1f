//! FMUs, and the package of the four-post rig.

pub mod archive;
pub mod four_post;
pub mod licenses;
pub mod package;
pub mod sbom;
