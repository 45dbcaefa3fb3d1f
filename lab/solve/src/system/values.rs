//! Values as a user writes them, for variables found by name.

use stribeck::model::{Kind, ModelType, Variable};

use super::Fault;

/// A value for a variable: of one part, `rig.mass`, or of every part that has it, `mass`.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// The name as written.
    pub name: String,
    /// The value as written: a number, or the name of a choice.
    pub value: String,
}

impl Setting {
    /// Name and value, for a variable that has no choices.
    pub fn number(&self) -> Result<(String, f64), Fault> {
        let wrong = |_| Fault::value(format_args!("{} = {}: must be a number", self.name, self.value));
        Ok((self.name.clone(), self.value.parse().map_err(wrong)?))
    }
}

impl std::str::FromStr for Setting {
    type Err = Fault;

    fn from_str(text: &str) -> Result<Setting, Fault> {
        let (name, value) =
            text.split_once('=').ok_or_else(|| Fault::value(format_args!("'{text}': must be name=value")))?;
        Ok(Setting { name: name.trim().to_owned(), value: value.trim().to_owned() })
    }
}

/// The name most similar to one that does not exist.
pub fn closest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<String> {
    let wanted = name.to_lowercase();
    let likeness = |other: &&str| strsim::jaro_winkler(&wanted, &other.to_lowercase());
    let best = known.into_iter().max_by(|a, b| likeness(a).total_cmp(&likeness(b)))?;
    (likeness(&best) > 0.75).then(|| best.to_owned())
}

/// The number that a text stands for as the value of a variable: a number, true or false, or the name of a choice.
pub fn spelled(variable: &Variable, text: &str) -> Result<f64, Fault> {
    let value = match variable.kind {
        Kind::Enumeration(choices) => {
            choices.items.iter().position(|item| item.name == text).map(|index| (index + 1) as f64).ok_or_else(
                || {
                    let names = choices.items.iter().map(|item| item.name);
                    Fault::unknown(format!("choice of {}", variable.path), text, names)
                },
            )?
        }
        Kind::Boolean if text == "true" => 1.0,
        Kind::Boolean if text == "false" => 0.0,
        _ => text.parse().map_err(|_| Fault::value(format_args!("{} = '{text}': must be a number", variable.path)))?,
    };
    if variable.admits(value) { Ok(value) } else { Err(Fault::value(variable.fault(value).0)) }
}

/// The column of a variable that a user may name.
pub(super) fn column(model: &'static ModelType, part: &str, name: &str) -> Result<usize, Fault> {
    model.find(name).ok_or_else(|| {
        let known: Vec<String> = model.variables().map(|(_, variable)| variable.path.to_string()).collect();
        Fault::unknown(format!("variable of {part} ({})", model.name), name, known.iter().map(String::as_str))
    })
}
