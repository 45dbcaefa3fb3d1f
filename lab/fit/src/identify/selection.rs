//! What a user chooses of the parameters of a fit.

use stribeck::model::ModelType;

/// Names of the parameters that are of the rig and not of the law.
pub(super) const OF_RIG: [&str; 6] = ["mass", "offset", "delay", "gravity", "gravity_cos", "gravity_sin"];

/// Choice of the parameters by the user.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Selection {
    /// Parameters that are held, with their values; `mass` and `offset` too.
    pub fixed: Vec<(String, f64)>,
    /// Parameters that are fitted although they usually are not: exponents, `mass`, `offset` ...
    pub fitted: Vec<String>,
    /// Ranges instead of those that follow from the data.
    pub ranges: Vec<(String, [f64; 2])>,
    /// Parameters of the law that have the value of another one.
    pub tied: Vec<(String, String)>,
    /// Whether the offset is fitted only because the records are of an axis: then not with levels of both directions.
    pub is_offset_usual: bool,
}

impl Selection {
    /// Value at which a parameter is held.
    pub(super) fn fixed(&self, name: &str) -> Option<f64> {
        self.fixed.iter().find(|(fixed, _)| fixed == name).map(|(_, value)| *value)
    }

    /// Whether a parameter is to be fitted although it usually is not.
    pub(super) fn fits(&self, name: &str) -> bool {
        self.fitted.iter().any(|fitted| fitted == name)
    }

    /// Those for one of several laws: without names that others of them have and it does not.
    pub(super) fn of(&self, law: &ModelType, laws: &[&ModelType]) -> Selection {
        let has =
            |law: &ModelType, name: &str| law.find(name.split_once(" - ").map_or(name, |(name, _)| name)).is_some();
        let is_meant =
            |name: &str| OF_RIG.contains(&name) || has(law, name) || !laws.iter().any(|other| has(other, name));
        let mut found = self.clone();
        found.fixed.retain(|(name, _)| is_meant(name));
        found.fitted.retain(|name| is_meant(name));
        found.ranges.retain(|(name, _)| is_meant(name));
        found.tied.retain(|(name, source)| is_meant(name) && is_meant(source));
        found
    }

    /// Whether the offset is fitted with a law.
    pub(super) fn fits_offset(&self, has_open_directions: bool) -> bool {
        self.fits("offset") && !(self.is_offset_usual && has_open_directions)
    }

    /// Whether a parameter has the value of another one.
    pub(super) fn is_tied(&self, name: &str) -> bool {
        self.tied.iter().any(|(tied, _)| tied == name)
    }
}
