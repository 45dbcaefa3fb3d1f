//! All models: the families one after the other; found by name or by guid.

use crate::model::{ModelType, Visitor};

/// A family of models.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Friction force models.
    Friction,
    /// The telescopic shock absorber and its parts.
    ShockAbsorber,
    /// Mechanical systems that carry a friction force.
    Host,
    /// Machine parts with friction that no normal force presses together.
    Component,
}

/// Every model of the library, in the order of the families.
pub fn models() -> impl Iterator<Item = &'static ModelType> {
    let until_hosts = crate::friction::MODELS.iter().chain(crate::shock_absorber::MODELS).chain(crate::host::MODELS);
    until_hosts.chain(crate::component::MODELS)
}

/// Shows every model of the library to a visitor, in the order of the families. Not for the library in an FMU: it knows
/// models by their records.
pub fn visit(visitor: &mut impl Visitor) {
    crate::friction::visit(visitor);
    crate::shock_absorber::visit(visitor);
    crate::host::visit(visitor);
    crate::component::visit(visitor);
}

/// Every model of a family with its documentation page, in Markdown.
pub fn documented(family: Family) -> impl Iterator<Item = (&'static ModelType, &'static str)> {
    let (models, pages) = match family {
        Family::Friction => (crate::friction::MODELS, crate::friction::PAGES),
        Family::ShockAbsorber => (crate::shock_absorber::MODELS, crate::shock_absorber::PAGES),
        Family::Host => (crate::host::MODELS, crate::host::PAGES),
        Family::Component => (crate::component::MODELS, crate::component::PAGES),
    };
    models.iter().zip(pages.iter().copied())
}

/// The model of this name (its modelIdentifier).
pub fn by_name(name: &str) -> Option<&'static ModelType> {
    models().find(|model| model.name == name)
}

/// The model whose table has this fingerprint.
pub fn by_guid(guid: impl AsRef<[u8]>) -> Option<&'static ModelType> {
    models().find(|model| model.guid().as_bytes() == guid.as_ref())
}
