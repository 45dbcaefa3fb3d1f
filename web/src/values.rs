//! Values as the page sends them.

use std::collections::BTreeMap;

/// Names and values as a user writes them.
pub fn texts(set: &BTreeMap<String, toml::Value>) -> impl Iterator<Item = (String, String)> + '_ {
    let plain = |value: &toml::Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
    set.iter().map(move |(name, value)| (name.clone(), plain(value)))
}

/// A text with values for the names between its marks @.
pub fn filled(text: &str, values: &[(&str, &str)]) -> String {
    values.iter().fold(text.to_owned(), |text, (name, value)| text.replace(&format!("@{name}@"), value))
}
