//! Tables of defaults on the page of the shock absorber.

use std::fmt::Write;

use anyhow::{Context, Result};
use stribeck::catalogue;
use stribeck::model::{Enumeration, Kind, ModelType, Path, Segment, Variable};
use stribeck_draw::text::typeset_unit;

use crate::describe::{block, text};

/// The page, relative to the root of the project.
pub const PAGE: &str = "docs/shock_absorber.md";

/// The part whose parameters are those of the friction laws.
const LAWS: &str = "friction";

/// The text of the page with fresh tables.
pub fn with_tables(page: &str) -> Result<String> {
    let model = catalogue::by_name("ShockAbsorber").context("there is no ShockAbsorber")?;
    let (of_laws, of_strut): (Vec<Row>, _) = rows(model).into_iter().partition(Row::is_of_laws);
    let page = block::replaced(PAGE, page, "defaults", &strut_table(&of_strut)?)?;
    block::replaced(PAGE, &page, "laws", &law_table(&of_laws)?)
}

/// One parameter, or all elements of an array of parameters.
struct Row {
    /// Name without indices.
    name: String,
    elements: Vec<Variable>,
}

fn rows(model: &ModelType) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for variable in model.table.iter().filter(|variable| variable.role.is_parameter()) {
        let name = without_indices(&variable.path);
        match rows.iter_mut().find(|row| row.name == name) {
            Some(row) => row.elements.push(variable),
            None => rows.push(Row { name, elements: vec![variable] }),
        }
    }
    rows
}

/// `element[3].share` is `element[].share`.
fn without_indices(path: &Path) -> String {
    let step = |Segment { name, index }: &Segment| if *index == 0 { (*name).into() } else { format!("{name}[]") };
    path.segments().iter().map(step).collect::<Vec<String>>().join(".")
}

impl Row {
    fn is_of_laws(&self) -> bool {
        self.elements[0].path.segments()[0].name == LAWS
    }

    fn name(&self) -> String {
        format!("`{}`", self.name.replace("[]", &format!("[1..{}]", self.elements.len())))
    }

    /// The start values; equal ones at the end of an array appear once.
    fn default(&self) -> String {
        let mut values: Vec<String> = self.elements.iter().map(text::start).collect();
        let last = values.last().cloned().unwrap_or_default();
        let repeated = values.iter().rev().take_while(|value| **value == last).count();
        if repeated < 2 {
            return values.join(", ");
        }
        values.truncate(values.len() - repeated);
        format!("{}, then {last}", values.join(", "))
    }

    /// The unit, or the choices.
    fn unit(&self) -> String {
        match self.elements[0].kind {
            Kind::Enumeration(choices) => names(choices).join(", "),
            Kind::Boolean => "true, false".to_owned(),
            Kind::Real(_) | Kind::Integer => typeset_unit(text::unit(&self.elements[0])),
        }
    }

    fn help(&self) -> &'static str {
        self.elements[0].help
    }
}

fn names(choices: &Enumeration) -> Vec<&'static str> {
    choices.items.iter().map(|item| item.name).collect()
}

fn strut_table(rows: &[Row]) -> Result<String> {
    let mut table = String::from("| parameter | default | unit or choices | what it is |\n|---|---|---|---|\n");
    for row in rows {
        writeln!(table, "| {} | {} | {} | {} |", row.name(), row.default(), row.unit(), row.help())?;
    }
    Ok(table)
}

fn law_table(rows: &[Row]) -> Result<String> {
    let mut table =
        String::from("| parameter | default | unit or choices | what it is | laws |\n|---|---|---|---|---|\n");
    let laws = laws(rows)?;
    for row in rows {
        let known = known_by(&laws, rows, row).join(", ");
        writeln!(table, "| {} | {} | {} | {} | {known} |", row.name(), row.default(), row.unit(), row.help())?;
    }
    Ok(table)
}

/// The laws that can be chosen.
fn laws(rows: &[Row]) -> Result<Vec<&'static ModelType>> {
    let choice = rows.iter().find(|row| row.name == format!("{LAWS}.model")).context("no law can be chosen")?;
    let Kind::Enumeration(choices) = choice.elements[0].kind else { return Ok(Vec::new()) };
    Ok(names(choices).into_iter().filter_map(catalogue::by_name).collect())
}

/// Names of the laws that use a parameter: the one in its name, or all that have it and no parameter of their own.
fn known_by(laws: &[&ModelType], rows: &[Row], row: &Row) -> Vec<&'static str> {
    let steps: Vec<&str> = row.name.split('.').skip(1).collect();
    let (owner, name) = (steps[0], steps.join("."));
    if let Some(law) = laws.iter().find(|law| law.name == owner) {
        return vec![law.name];
    }
    let follows = |law: &&&ModelType| {
        let own = format!("{LAWS}.{}.{name}", law.name);
        law.table.iter().any(|variable| without_indices(&variable.path) == name)
            && !rows.iter().any(|row| row.name == own)
    };
    laws.iter().filter(follows).map(|law| law.name).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strut() -> Vec<Row> {
        rows(catalogue::by_name("ShockAbsorber").unwrap())
    }

    fn row(name: &str) -> Row {
        strut().into_iter().find(|row| row.name == name).unwrap()
    }

    #[test]
    fn an_array_is_one_row() {
        let row = row("spring.tab_x[]");
        assert_eq!((row.name().as_str(), row.default().as_str()), ("`spring.tab_x[1..16]`", "0, 0.03, 0.055, then 0"));
        assert_eq!(row.unit(), "m");
    }

    #[test]
    fn parameters_of_laws_name_the_laws_that_use_them() {
        let laws = laws(&strut()).unwrap();
        let known = |name: &str| known_by(&laws, &strut(), &row(name));
        assert_eq!(known("friction.damping_velocity"), ["LuGre", "ElastoPlastic"]);
        assert_eq!(known("friction.sliding_velocity"), ["Ambrosio"]);
        assert_eq!(known("friction.LinearStiction.sliding_velocity"), ["LinearStiction"]);
        assert_eq!(known("friction.Threlfall.variant"), ["Threlfall"]);
        assert_eq!(known("friction.element[].strength_share"), ["MaxwellSlip", "Leuven"]);
        assert!(known("friction.scale").is_empty());
    }

    /// Numbers of the strut that have a source, which the page names.
    const SOURCED: [&str; 4] = ["geom.stroke", "spring.k", "gas.p_ambient", "num.mass_ref"];

    /// 0 and 1 switch a part off or leave a force unchanged.
    #[test]
    fn numbers_without_a_source_are_marked_as_chosen() {
        for row in strut().iter().filter(|row| !row.is_of_laws()) {
            let is_number = matches!(row.elements[0].kind, Kind::Real(_) | Kind::Integer);
            let says_something = row.elements.iter().any(|variable| ![0.0, 1.0].contains(&variable.start));
            let has_source = SOURCED.contains(&row.name.as_str()) || row.name.starts_with("damper.mr.");
            let needs_mark = is_number && says_something && !has_source;
            assert_eq!(row.help().contains("(default chosen"), needs_mark, "{}: {}", row.name, row.help());
        }
    }
}
