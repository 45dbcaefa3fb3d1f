//! The models behind the interfaces: those of the catalogue.

use stribeck::catalogue;
use stribeck::model::ModelType;

pub(crate) fn all() -> impl Iterator<Item = &'static ModelType> {
    let models = catalogue::models();
    #[cfg(test)]
    let models = models.chain(crate::probe::MODELS);
    models
}

/// The model of this name (its modelIdentifier).
pub(crate) fn by_name(name: &str) -> Option<&'static ModelType> {
    all().find(|model| model.name == name)
}

/// The model whose FMU with Real variables only has this guid.
pub(crate) fn by_plain_guid(guid: impl AsRef<[u8]>) -> Option<&'static ModelType> {
    all().find(|model| model.plain_guid() == guid.as_ref())
}

/// The model whose table has this fingerprint.
pub(crate) fn by_guid(guid: impl AsRef<[u8]>) -> Option<&'static ModelType> {
    all().find(|model| model.guid().as_bytes() == guid.as_ref())
}
