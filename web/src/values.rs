//! Values as the page sends them.

use std::collections::BTreeMap;

/// Names and values as a user writes them.
pub fn texts(set: &BTreeMap<String, toml::Value>) -> impl Iterator<Item = (String, String)> + '_ {
    let plain = |value: &toml::Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
    set.iter().map(move |(name, value)| (name.clone(), plain(value)))
}

/// Names and numbers.
pub fn numbers(set: &BTreeMap<String, f64>) -> Vec<(String, f64)> {
    set.iter().map(|(name, value)| (name.clone(), *value)).collect()
}
