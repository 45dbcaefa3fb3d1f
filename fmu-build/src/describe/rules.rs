//! House rules for the tables and texts of the models that the compiler cannot check.

use std::collections::BTreeMap;
use std::mem::discriminant;
use std::path::Path;

use anyhow::Result;
use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};
use stribeck::catalogue;
use stribeck::model::{Enumeration, Kind, ModelType, Variable};

use crate::describe::{entry, header};

/// Every breach, in words.
pub fn breaches(root: &Path) -> Result<Vec<String>> {
    let entries = entry::entries();
    let models: Vec<_> = entries.iter().map(|entry| entry.model).collect();
    let unknown = entries.iter().flat_map(|entry| unknown_symbols(entry.model, entry.documentation));
    let mut breaches: Vec<String> = unknown.collect();
    breaches.extend(models.iter().flat_map(|model| unfit_texts(model)));
    breaches.extend(differing_variables(&models));
    breaches.extend(differing_choices(&models));
    breaches.extend(header::without_comment(&header::text(root)?));
    Ok(breaches)
}

/// Names in the symbol tables of the documentation that are not variables of the model.
fn unknown_symbols(model: &ModelType, documentation: &str) -> Vec<String> {
    let known: Vec<_> = model.table.iter().map(|variable| without_indices(&variable.path.to_string())).collect();
    let names = names_in_symbol_tables(documentation).into_iter();
    let unknown = names.filter(|name| !known.contains(&without_indices(name)));
    unknown.map(|name| format!("{}: the symbol table names `{name}`, which is not a variable", model.name)).collect()
}

/// `element[3].stiffness` and `element[i].stiffness` are the same row of a symbol table.
fn without_indices(name: &str) -> String {
    let parts = name.split('[').enumerate();
    parts.map(|(at, part)| if at == 0 { part } else { part.split_once(']').map_or(part, |(_, rest)| rest) }).collect()
}

/// The code in the column with the heading `variable` of every table.
fn names_in_symbol_tables(documentation: &str) -> Vec<String> {
    let mut names = Vec::new();
    let (mut column, mut variables, mut in_head) = (0, None, false);
    for event in Parser::new_ext(documentation, Options::ENABLE_TABLES) {
        match event {
            Event::Start(Tag::Table(_)) => variables = None,
            Event::Start(Tag::TableHead) => (in_head, column) = (true, 0),
            Event::End(TagEnd::TableHead) => in_head = false,
            Event::Start(Tag::TableRow) => column = 0,
            Event::End(TagEnd::TableCell) => column += 1,
            Event::Text(title) if in_head && &*title == "variable" => variables = Some(column),
            Event::Code(name) if variables == Some(column) => names.push(name.into_string()),
            _ => (),
        }
    }
    names
}

/// Texts that a C header, XML or an old importer would not accept, or that are not a sentence.
fn unfit_texts(model: &ModelType) -> Vec<String> {
    let mut breaches = Vec::new();
    let mut examine = |owner: String, text: &str, ends: &[char]| {
        breaches.extend(unfit(text, ends).map(|fault| format!("{owner}: help text {fault}: {text}")));
    };
    examine(model.name.to_owned(), model.summary, &[]);
    for variable in model.table {
        let owner = format!("{} {}", model.name, variable.path);
        // A Boolean may be a question.
        let ends: &[char] = if variable.kind == Kind::Boolean { &['.', '?'] } else { &['.'] };
        examine(owner.clone(), variable.help, ends);
        if let Kind::Enumeration(choices) = variable.kind {
            for item in choices.items {
                // A choice of models repeats the models' own descriptions.
                let ends: &[char] = if is_summary(item.help) { &[] } else { &['.'] };
                examine(format!("{owner} {}", item.name), item.help, ends);
            }
        }
    }
    breaches
}

/// Faults of a text, which must end with one of these characters if any are given.
fn unfit(text: &str, ends: &[char]) -> Option<&'static str> {
    if text.is_empty() {
        Some("is missing")
    } else if !text.bytes().all(|byte| (b' '..=b'~').contains(&byte)) {
        Some("must be one line of ASCII")
    } else if text.contains("--") || text.contains("*/") || text.contains("/*") {
        Some("must not contain --, */ or /*")
    } else if !ends.is_empty() && !text.ends_with(ends) {
        Some("must end with a full stop")
    } else {
        None
    }
}

fn is_summary(text: &str) -> bool {
    catalogue::models().any(|model| model.summary == text)
}

/// Variables of the same name that measure different things.
fn differing_variables(models: &[&ModelType]) -> Vec<String> {
    let mut first: BTreeMap<String, (&ModelType, Variable)> = BTreeMap::new();
    let mut breaches = Vec::new();
    for (model, variable) in models.iter().flat_map(|model| model.table.iter().map(move |variable| (*model, variable)))
    {
        let (other, same) = *first.entry(variable.path.to_string()).or_insert((model, variable));
        if !is_same_quantity(variable.kind, same.kind) {
            let name = &variable.path;
            breaches.push(format!("{name}: the unit or type in {} differs from that in {}", model.name, other.name));
        }
    }
    breaches
}

/// Whether units and types are equal; the choices of an enumeration may differ between models.
fn is_same_quantity(a: Kind, b: Kind) -> bool {
    match (a, b) {
        (Kind::Real(a), Kind::Real(b)) => a == b,
        _ => discriminant(&a) == discriminant(&b),
    }
}

/// Enumerations of the same name with different choices: the header has room for one.
fn differing_choices(models: &[&ModelType]) -> Vec<String> {
    let mut first: BTreeMap<&str, &Enumeration> = BTreeMap::new();
    let mut breaches = Vec::new();
    for variable in models.iter().flat_map(|model| model.table) {
        let Kind::Enumeration(choices) = variable.kind else { continue };
        if *first.entry(choices.name).or_insert(choices) != choices {
            breaches.push(format!("{}: two enumerations of this name have different choices", choices.name));
        }
    }
    breaches
}

#[cfg(test)]
mod tests {
    use super::*;

    mod odd {
        //! A model that breaks every rule.
        use stribeck::model::{Law, Model, real};
        use stribeck::number::Real;

        stribeck::model! {
            /// | symbol | variable   | unit | meaning |
            /// |--------|------------|------|---------|
            /// | v      | `velocity` | m/s  | `speed` |
            /// | w      | `wrong`    | m/s  | nothing |
            Odd: "A model that breaks every rule" {
                /// No full stop
                velocity: input = real("N", 0.0),
                /// Not ASCII: µ.
                level: tunable = real("N", 0.0),
                /// Two -- dashes.
                level_2: tunable = real("N", 0.0),
            }
        }
        impl<T: Real> Law for Odd<T> {
            type Interface = stribeck::model::CoSimulation;

            fn output(&mut self) {}
        }
        impl Model for Odd {
            fn step(&mut self, _dt: f64) {}
        }
    }

    #[test]
    fn models_keep_the_rules() {
        assert_eq!(breaches(crate::project::root()).unwrap(), Vec::<String>::new());
    }

    #[test]
    fn breaches_are_found() {
        let odd = ModelType::of::<odd::Odd>();
        let symbols = unknown_symbols(&odd, <odd::Odd as stribeck::model::Described>::DOCUMENTATION);
        assert_eq!(symbols, ["Odd: the symbol table names `wrong`, which is not a variable"]);
        let texts = unfit_texts(&odd);
        assert!(texts[0].starts_with("Odd velocity: help text must end with a full stop"), "{texts:?}");
        assert!(texts[1].starts_with("Odd level: help text must be one line of ASCII"), "{texts:?}");
        assert!(texts[2].starts_with("Odd level_2: help text must not contain --"), "{texts:?}");
        assert_eq!(texts.len(), 3);
        let lugre = stribeck::catalogue::by_name("LuGre").unwrap();
        let differing = differing_variables(&[lugre, &odd]);
        assert_eq!(differing, ["velocity: the unit or type in Odd differs from that in LuGre"]);
    }

    #[test]
    fn indices_do_not_matter_in_symbol_tables() {
        assert_eq!(without_indices("stack.element[12].stiffness"), "stack.element.stiffness");
        assert_eq!(without_indices("element[i].stiffness"), "element.stiffness");
        assert_eq!(without_indices("velocity"), "velocity");
    }
}
