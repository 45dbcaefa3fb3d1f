//! Changes between two lists of the interface, and whether the version of the library allows them.

use std::collections::{BTreeSet, HashMap};
use std::fmt;

use anyhow::{Context, Result, ensure};
use semver::Version;

use crate::describe::interface::{Interface, Row};

/// A difference between the committed list and the present interface.
#[derive(Debug, PartialEq)]
pub enum Change {
    /// Only new items; every listed one is unchanged.
    Additive(String),
    /// A host or program that works with the listed interface may fail.
    Breaking(String),
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Change::Additive(text) => write!(f, "additive: {text}"),
            Change::Breaking(text) => write!(f, "BREAKING: {text}"),
        }
    }
}

/// Prints the changes since the committed interface, and rejects those that the version does not allow.
pub fn review(committed: &Interface, now: &Interface) -> Result<()> {
    let changes = changes(committed, now);
    changes.iter().for_each(|change| println!("{change}"));
    let breaking = changes.iter().filter(|change| matches!(change, Change::Breaking(_))).count();
    ensure!(
        breaking == 0 || may_break(&committed.version, &now.version)?,
        "breaking changes to the interface: {breaking}; undo them, or set a version in Cargo.toml that starts a new \
         series (the committed files are those of {}) and add their migration lines to CHANGELOG.md",
        committed.version
    );
    Ok(())
}

/// Whether the interface may break when the version changes from one to the other: if that starts a new series (0.1.x
/// to 0.2.0, 1.x to 2.0.0), and as long as the listed version is the draft of the first one of a series (0.2.0-dev).
fn may_break(listed: &str, now: &str) -> Result<bool> {
    let parse = |text: &str| Version::parse(text).with_context(|| format!("{text} is not a version"));
    let (listed, now) = (parse(listed)?, parse(now)?);
    let is_draft = !listed.pre.is_empty() && series(&listed) == (listed.major, listed.minor, listed.patch);
    Ok(is_draft || series(&now) > series(&listed))
}

/// The first version with which this one promises to be compatible.
fn series(version: &Version) -> (u64, u64, u64) {
    match (version.major, version.minor) {
        (0, 0) => (0, 0, version.patch),
        (0, minor) => (0, minor, 0),
        (major, _) => (major, 0, 0),
    }
}

/// All differences: first removed and changed items, in the order of the old list, then new ones.
pub fn changes(old: &Interface, new: &Interface) -> Vec<Change> {
    let [old_owners, new_owners] = [old, new].map(owners);
    let [old_rows, new_rows] = [old, new].map(by_key);
    let lost = old_owners.difference(&new_owners).map(|owner| {
        Change::Breaking(format!("{owner} was removed; fix: keep it, hosts and programs request it by name"))
    });
    let mut changes: Vec<_> = lost.collect();
    for row in old.rows.iter().filter(|row| new_owners.contains(row.owner.as_str())) {
        match new_rows.get(&key(row)) {
            Some(now) => changes.extend(differences(row, now)),
            None => changes.push(removed(row, new, &old_rows)),
        }
    }
    changes.extend(new_owners.difference(&old_owners).map(|owner| Change::Additive(format!("{owner} is new"))));
    let is_new = |row: &&Row| old_owners.contains(row.owner.as_str()) && !old_rows.contains_key(&key(row));
    let added = new.rows.iter().filter(is_new);
    changes.extend(added.map(|row| Change::Additive(format!("{} is new", title(row)))));
    changes
}

type Key<'a> = (&'a str, &'a str, &'a str);

fn key(row: &Row) -> Key<'_> {
    (&row.owner, &row.item, &row.name)
}

fn by_key(interface: &Interface) -> HashMap<Key<'_>, &Row> {
    interface.rows.iter().map(|row| (key(row), row)).collect()
}

fn owners(interface: &Interface) -> BTreeSet<&str> {
    interface.rows.iter().map(|row| row.owner.as_str()).collect()
}

fn title(row: &Row) -> String {
    format!("{}: {} {}", row.owner, row.item, row.name)
}

/// Change for an item that is no longer listed. A variable whose reference has another name now was renamed.
fn removed(row: &Row, new: &Interface, old_rows: &HashMap<Key, &Row>) -> Change {
    let is_heir = |now: &&Row| {
        let is_same = (&now.owner, &now.item, &now.value) == (&row.owner, &row.item, &row.value);
        is_same && row.item == "variable" && !old_rows.contains_key(&key(now))
    };
    let what = match new.rows.iter().find(is_heir) {
        Some(heir) => format!("was renamed to {}", heir.name),
        None => "was removed".into(),
    };
    Change::Breaking(format!("{} {what}; fix: keep the name, hosts and programs rely on it", title(row)))
}

/// Kind of value that an item has, and the cure if it has changed.
fn value_of(item: &str) -> (&'static str, &'static str) {
    match item {
        "variable" => ("value reference", "restore the old name of the variable"),
        "choice" => ("number", "add new choices after the others"),
        "function" | "type" => ("declaration", "add a new one under another name"),
        _ => ("value", "restore the old value"),
    }
}

/// Differences in an item that is in both lists.
fn differences(old: &Row, new: &Row) -> Vec<Change> {
    let another = "add a new variable and keep this one";
    let fields = [
        (value_of(&old.item), &old.value, &new.value),
        (("type", another), &old.kind, &new.kind),
        (("unit", another), &old.unit, &new.unit),
        (("causality", another), &old.causality, &new.causality),
        (("variability", another), &old.variability, &new.variability),
        (("start value", "restore the old start value"), &old.start, &new.start),
    ];
    let changed = fields.into_iter().filter(|(_, before, after)| before != after);
    let describe = |((field, cure), before, after): ((&str, &str), &String, &String)| {
        let text = format!("{}: the {field} was {}, is {}", title(old), shown(before), shown(after));
        Change::Breaking(format!("{text}; fix: {cure}"))
    };
    changed.map(describe).collect()
}

fn shown(value: &str) -> &str {
    if value.is_empty() { "none" } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::describe::interface::tests::NOW;
    use crate::project::VERSION;
    use stribeck::model::Path;
    use stribeck::reference;

    /// The report on the present interface after a careless change.
    fn after(alter: impl FnOnce(&mut Vec<Row>)) -> Vec<String> {
        let mut new = NOW.clone();
        alter(&mut new.rows);
        changes(&NOW, &new).iter().map(Change::to_string).collect()
    }

    fn row<'a>(rows: &'a mut [Row], owner: &str, item: &str, name: &str) -> &'a mut Row {
        let is_it = |row: &&mut Row| key(row) == (owner, item, name);
        rows.iter_mut().find(is_it).unwrap_or_else(|| panic!("no {item} {name} of {owner}"))
    }

    fn is_variable(row: &Row, name: &str) -> bool {
        key(row) == ("LuGre", "variable", name)
    }

    #[test]
    fn nothing_changes_by_itself() {
        assert_eq!(after(|_| ()), [""; 0]);
    }

    #[test]
    fn a_renamed_variable_is_seen() {
        let changes = after(|rows| row(rows, "LuGre", "variable", "velocity").name = "speed".into());
        let renamed = "BREAKING: LuGre: variable velocity was renamed to speed; fix: keep the name";
        assert_eq!(changes.len(), 2);
        assert!(changes[0].starts_with(renamed), "{changes:?}");
        assert_eq!(changes[1], "additive: LuGre: variable speed is new");
    }

    #[test]
    fn a_removed_variable_is_seen() {
        let changes = after(|rows| rows.retain(|row| !is_variable(row, "velocity")));
        assert_eq!(changes.len(), 1);
        assert!(changes[0].starts_with("BREAKING: LuGre: variable velocity was removed; fix: "), "{changes:?}");
    }

    #[test]
    fn a_moved_reference_is_seen_with_both_values() {
        let changes = after(|rows| row(rows, "LuGre", "variable", "velocity").value = "7".into());
        let was = reference::of(&Path::root("velocity"));
        let moved = format!("BREAKING: LuGre: variable velocity: the value reference was {was}, is 7; fix: ");
        assert!(changes.len() == 1 && changes[0].starts_with(&moved), "{changes:?}");
    }

    #[test]
    fn every_property_of_a_variable_counts() {
        type Alteration = (fn(&mut Row), &'static str);
        let alterations: [Alteration; 5] = [
            (|row| row.unit = "mm/s".into(), "the unit was m/s, is mm/s"),
            (|row| row.kind = "Integer".into(), "the type was Real, is Integer"),
            (|row| row.causality = "output".into(), "the causality was input, is output"),
            (|row| row.variability = "discrete".into(), "the variability was continuous, is discrete"),
            (|row| row.start.clear(), "the start value was 0, is none"),
        ];
        for (alter, text) in alterations {
            let changes = after(|rows| alter(row(rows, "LuGre", "variable", "velocity")));
            let expected = format!("BREAKING: LuGre: variable velocity: {text}; fix: ");
            assert!(changes.len() == 1 && changes[0].starts_with(&expected), "{changes:?}");
        }
    }

    #[test]
    fn choices_keep_their_numbers() {
        let changes = after(|rows| row(rows, "Coulomb", "choice", "ExchangeOrder.Parallel").value = "3".into());
        let renumbered = "BREAKING: Coulomb: choice ExchangeOrder.Parallel: the number was 2, is 3; fix: ";
        assert!(changes.len() == 1 && changes[0].starts_with(renumbered), "{changes:?}");
        let gone = |row: &Row| key(row) == ("Coulomb", "choice", "ExchangeOrder.Parallel");
        let changes = after(|rows| rows.retain(|row| !gone(row)));
        assert!(changes.len() == 1 && changes[0].contains("choice ExchangeOrder.Parallel was removed"), "{changes:?}");
    }

    #[test]
    fn promises_to_importers_and_c_programs_are_kept() {
        let changes = after(|rows| {
            row(rows, "LuGre", "attribute", "CoSimulation.canGetAndSetFMUstate").value = "false".into();
            row(rows, "stribeck.h", "function", "stribeck_free").value =
                "int stribeck_free(stribeck_instance *m)".into();
            row(rows, "stribeck.h", "constant", "fmi2Error").value = "9".into();
            rows.retain(|row| row.name != "stribeck_time");
        });
        let expected =
            ["the value was true, is false", "the declaration was void stribeck_free", "was 3, is 9", "removed"];
        assert_eq!(changes.len(), expected.len(), "{changes:?}");
        for text in expected {
            assert!(changes.iter().any(|change| change.starts_with("BREAKING") && change.contains(text)), "{text}");
        }
    }

    #[test]
    fn additions_break_nothing() {
        let changes = after(|rows| {
            let mut new = row(rows, "LuGre", "variable", "velocity").clone();
            (new.name, new.value) = ("new".into(), reference::of(&Path::root("new")).to_string());
            rows.insert(0, new);
        });
        assert_eq!(changes, ["additive: LuGre: variable new is new"]);
    }

    #[test]
    fn whole_models_come_and_go_in_one_line() {
        let mut fewer = NOW.clone();
        fewer.rows.retain(|row| row.owner != "LuGre");
        assert_eq!(changes(&fewer, &NOW), [Change::Additive("LuGre is new".into())]);
        let lost = changes(&NOW, &fewer);
        assert!(lost.len() == 1 && lost[0].to_string().starts_with("BREAKING: LuGre was removed"), "{lost:?}");
    }

    #[test]
    fn only_a_new_series_or_its_draft_may_break() {
        for (listed, now, may) in [
            ("0.1.0", "0.1.0", false),
            ("0.1.0", "0.1.9", false),
            ("0.1.0", "0.1.1-dev", false),
            ("0.1.1-dev", "0.1.1", false),
            ("0.1.0", "0.2.0-dev", true),
            ("0.1.0", "0.2.0", true),
            ("0.2.0-dev", "0.2.0-dev", true),
            ("0.2.0-dev", "0.2.0", true),
            ("0.2.0", "0.1.0", false),
            ("0.9.0", "1.0.0", true),
            ("1.2.3", "1.9.0", false),
            ("1.2.0-dev", "1.2.0", false),
            ("1.2.3", "2.0.0", true),
            ("0.0.1", "0.0.2", true),
        ] {
            assert_eq!(may_break(listed, now).unwrap(), may, "{listed} to {now}");
        }
        assert!(may_break("one", "0.1.0").is_err());
    }

    /// A review of today's interface, if a variable was renamed since the files of `version` were committed.
    fn reviewed(version: &str) -> Result<()> {
        let mut committed = NOW.clone();
        committed.version = version.into();
        row(&mut committed.rows, "LuGre", "variable", "velocity").name = "speed".into();
        review(&committed, &NOW)
    }

    #[test]
    fn a_review_rejects_changes_that_the_version_does_not_allow() {
        let error = reviewed(VERSION).unwrap_err().to_string();
        for text in ["breaking changes to the interface: 1", VERSION, "CHANGELOG.md", "Cargo.toml"] {
            assert!(error.contains(text), "{text} is not in {error}");
        }
        reviewed("0.0.9").unwrap();
    }
}
