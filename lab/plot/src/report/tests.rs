//! Reports read back, against the outcomes.

use roxmltree::{Document, Node, ParsingOptions};

use super::*;
use stribeck_solve::run::Settings;
use stribeck_solve::solve::End;
use stribeck_solve::system::{Setting, Source};

const LAWS: [&str; 3] = ["CoulombStiction", "Bernard", "LuGre"];

/// The belt with a heavier block and three laws, of which one has a steeper slope: systems, outcomes.
fn belt() -> (Vec<System>, Vec<(String, Outcome)>) {
    let source = Source::open("belt").unwrap();
    let settings = ["rig.mass=1.25", "transition_slope=1000"].map(|text| text.parse::<Setting>().unwrap());
    let system = |law: &str| System::assemble(&source, Some(law), &settings).unwrap();
    let systems: Vec<System> = LAWS.iter().map(|law| system(law)).collect();
    let run = |system: &System| {
        let results = picture::needed(system);
        (
            system.law.unwrap().name.to_owned(),
            stribeck_solve::run::run(system, &Settings::of(system), &results).unwrap(),
        )
    };
    let outcomes = systems.iter().map(run).collect();
    (systems, outcomes)
}

fn parse(html: &str) -> Document<'_> {
    Document::parse_with_options(html, ParsingOptions { allow_dtd: true, ..ParsingOptions::default() }).unwrap()
}

fn text(node: Node) -> String {
    node.descendants().filter(Node::is_text).filter_map(|part| part.text().map(str::to_owned)).collect()
}

/// The rows of the table below a heading, without its head.
fn table(document: &Document, heading: &str) -> Vec<Vec<String>> {
    let heading = document.descendants().find(|node| node.has_tag_name("h2") && text(*node) == heading).unwrap();
    let mut after = heading.next_siblings().skip(1);
    let table = after.find_map(|node| node.descendants().find(|node| node.has_tag_name("tbody"))).unwrap();
    let cells = |row: Node| row.children().filter(|cell| cell.has_tag_name("td")).map(text).collect();
    table.children().filter(|row| row.has_tag_name("tr")).map(cells).collect()
}

#[test]
fn numbers_are_those_of_the_outcomes() {
    let (systems, outcomes) = belt();
    let facts = Facts { systems: &systems, tolerance: 1e-8, events: 5, ..Facts::default() };
    let html = html(&systems[0], &outcomes, &facts);
    let document = parse(&html);
    let mut events = table(&document, "Events").into_iter();
    let mut costs = table(&document, "Solver").into_iter();
    for (law, outcome) in &outcomes {
        for (number, event) in outcome.events.iter().take(5).enumerate() {
            let row = events.next().unwrap();
            assert_eq!(row[..2], [law.clone(), (number + 1).to_string()]);
            assert_eq!(row[2].parse::<f64>().unwrap(), event.time);
            assert_eq!(row[3], "friction");
        }
        let total = outcome.events.len();
        let note = match total {
            0 => format!("{law}: no events."),
            1 => format!("{law}: 1 event."),
            2..=5 => format!("{law}: all {total} events."),
            _ => format!("{law}: the first 5 of {total} events."),
        };
        assert!(html.contains(&note), "{note}");
        let row = costs.next().unwrap();
        assert_eq!(row[..2], [law.clone(), "rodas5p".to_owned()]);
        assert_eq!(row[2].parse::<f64>().unwrap(), 1e-8);
        let numbers: Vec<u64> = row[3..8].iter().map(|cell| cell.parse().unwrap()).collect();
        let cost = &outcome.statistics;
        assert_eq!(numbers, [cost.steps, cost.rejected, cost.evaluations, cost.jacobians, total as u64]);
        assert_eq!(row[8], "reached");
    }
    assert_eq!((events.next(), costs.next()), (None, None));
    assert!(outcomes[0].1.events.len() > 5, "the list is cut");
}

#[test]
fn parameters_that_differ_are_listed_with_their_defaults_and_no_others() {
    let (systems, outcomes) = belt();
    let html = html(&systems[0], &outcomes, &Facts { systems: &systems, ..Facts::default() });
    let document = parse(&html);
    let rows = table(&document, "Parameters that differ from the defaults");
    let row = |name: &str| rows.iter().find(|row| row[0] == name).unwrap_or_else(|| panic!("{name}: {rows:?}"));
    assert_eq!(row("rig.mass")[1..4], ["1.25", "kg", "1"]);
    assert_eq!(row("rig.mass")[5], "all");
    assert_eq!(row("friction.transition_slope")[1..4], ["1000", "s/m", "2000"]);
    assert_eq!(row("friction.transition_slope")[5], "Bernard");
    // Counted by hand from rows and tables.
    let differs = |part: &Part, column: usize| {
        let variable = part.model.table.at(column);
        variable.role != Role::Input && variable.role != Role::Output && part.row[column] != variable.start
    };
    for system in &systems {
        for part in &system.parts {
            for column in 0..part.row.len() {
                let name = format!("{}.{}", part.name, part.model.table.at(column).path);
                let law = system.law.unwrap().name;
                let listed = rows.iter().any(|row| row[0] == name && (row[5] == "all" || row[5] == law));
                assert_eq!(listed, differs(part, column), "{law}: {name}");
            }
        }
    }
    assert!(table(&document, "Connections").contains(&vec!["friction.velocity".into(), "rig.velocity".into()]));
    let versions = table(&document, "Versions");
    assert_eq!(versions.len(), 1 + LAWS.len());
    for row in versions {
        assert_eq!(row[1], stribeck::catalogue::by_name(&row[0]).unwrap().guid());
    }
}

/// A reader without a network sees the same page, and nothing runs in it.
#[test]
fn report_is_one_file_without_scripts_and_addresses() {
    let (systems, outcomes) = belt();
    let command = "stribeck compare belt --law CoulombStiction --law LuGre mass=1.25";
    let facts = Facts { systems: &systems, command, toml: "title = \"a < b\"\n", ..Facts::default() };
    let html = html(&systems[0], &outcomes, &facts);
    let document = parse(&html);
    let elements = || document.descendants().filter(Node::is_element);
    for node in elements() {
        assert!(!["script", "link", "iframe", "object", "embed", "img"].contains(&node.tag_name().name()));
        for attribute in node.attributes() {
            let name = attribute.name();
            assert!(!name.starts_with("on") && !["src", "href", "srcset", "data", "action"].contains(&name), "{name}");
        }
    }
    assert!(!html.contains("url(") && !html.contains("@import"));
    assert!(!html.replace("http://www.w3.org/2000/svg", "").contains("://"));
    let named =
        |name: &str| elements().filter(|node| node.tag_name().name() == name).map(text).collect::<Vec<String>>();
    assert_eq!(named("svg").len(), 7);
    assert_eq!(named("h1"), ["Block on a moving belt, held by a spring"]);
    assert_eq!(named("pre"), [command, "title = \"a < b\"\n"]);
    let sources = elements().filter(|node| node.attribute("class") == Some("source"));
    assert_eq!(sources.map(text).collect::<Vec<String>>(), [systems[0].description.source.clone()]);
    assert_eq!(html, super::html(&systems[0], &outcomes, &facts), "the same runs have the same report");
}

#[test]
fn a_run_that_did_not_converge_is_told_first() {
    let (systems, mut outcomes) = belt();
    let stopped = &mut outcomes[1].1;
    stopped.end = End::Failed { time: 12.5, reason: "the step became too short".to_owned() };
    stopped.time.truncate(1251);
    stopped.columns.iter_mut().for_each(|column| column.values.truncate(1251));
    let html = html(&systems[0], &outcomes, &Facts::default());
    let document = parse(&html);
    let place = |what: &str| html.find(what).unwrap_or_else(|| panic!("{what}"));
    let warning = "Bernard: did not converge at 12.5 s: the step became too short. Its curves end there.";
    assert!(place(warning) < place("<h2>"));
    let failed = document.descendants().find(|node| node.attribute("class") == Some("failed")).unwrap();
    assert!(text(failed).starts_with("Bernard") && text(failed).ends_with("too short"));
    assert!(html.contains("Bernard (stopped at 12.5 s)"));
    let (systems, outcomes) = belt();
    assert!(!super::html(&systems[0], &outcomes, &Facts::default()).contains("class=\"warning\""));
}

#[test]
fn a_check_is_a_table_and_a_warning_if_the_tolerance_does_not_hold() {
    let (systems, mut outcomes) = belt();
    let html = |outcomes: &[(String, Outcome)]| super::html(&systems[0], outcomes, &Facts::default());
    assert!(!html(&outcomes).contains("<h2>Check"), "nobody asked for one");
    let settings = Settings { is_checked: true, until: 10.0, ..Settings::of(&systems[2]) };
    let results = picture::needed(&systems[2]);
    outcomes[2].1 = stribeck_solve::run::run(&systems[2], &settings, &results).unwrap();
    let page = html(&outcomes);
    let rows = table(&parse(&page), "Check");
    let check = outcomes[2].1.check.clone().unwrap();
    assert_eq!((rows.len(), check.fault), (results.len(), None));
    for (row, one) in rows.iter().zip(&check.differences) {
        assert_eq!(row[..2], ["LuGre".to_owned(), one.name.clone()]);
        assert!((row[2].parse::<f64>().unwrap() - one.largest).abs() <= 0.01 * one.largest, "{row:?}");
        assert!((row[5].parse::<f64>().unwrap() - one.time).abs() < 1e-9, "{row:?}");
    }
    assert!(page.contains("Largest differences from a run at 1e-9.") && !page.contains("class=\"warning\""));
    outcomes[2].1.check.as_mut().unwrap().fault = Some("the tolerance does not hold: a < b".to_owned());
    let page = html(&outcomes);
    let warning = "<p class=\"warning\">LuGre: the tolerance does not hold: a &lt; b.</p>";
    assert!(page.find(warning).unwrap() < page.find("<h2>").unwrap() && page.contains("class=\"failed\""));
}

#[test]
fn hostile_texts_stay_texts() {
    let (mut systems, mut outcomes) = belt();
    let hostile = "</title></h1><script>alert('1')</script> & \"\u{0}\u{b}";
    systems[0].description.title = hostile.to_owned();
    systems[0].description.source = hostile.to_owned();
    outcomes[0].0 = hostile.to_owned();
    outcomes[0].1.events[0].part = hostile.to_owned();
    outcomes[0].1.end = End::Failed { time: 1.0, reason: hostile.to_owned() };
    let html = html(&systems[0], &outcomes, &Facts { command: hostile, toml: hostile, ..Facts::default() });
    let document = parse(&html);
    assert!(document.descendants().all(|node| node.tag_name().name() != "script"));
    let shown = hostile.replace(['\u{0}', '\u{b}'], "\u{fffd}");
    let headings: Vec<String> = document.descendants().filter(|node| node.has_tag_name("h1")).map(text).collect();
    assert_eq!(headings, [shown.as_str()]);
    assert_eq!(table(&document, "Solver")[0][0], shown);
    assert_eq!(table(&document, "Events")[0][3], shown);
}

/// The strut has its law inside: it is a parameter like others.
#[test]
fn other_systems_have_reports_too() {
    let system = System::assemble(&Source::open("quarter-car").unwrap(), Some("Dahl"), &[]).unwrap();
    let settings = Settings { until: 0.2, ..Settings::of(&system) };
    let outcome = stribeck_solve::run::run(&system, &settings, &picture::needed(&system)).unwrap();
    let html = html(&system, &[("Dahl".to_owned(), outcome)], &Facts::default());
    let document = parse(&html);
    let rows = table(&document, "Parameters that differ from the defaults");
    let law = rows.iter().find(|row| row[0] == "strut.friction.model").unwrap();
    assert_eq!(law[1], "Dahl");
    let road = table(&document, "Connections").into_iter().find(|row| row[0] == "car.road_height").unwrap();
    assert!(road[1].contains("sine") && road[1].contains("3.9"), "{road:?}");
    let ambient = vec!["strut.temperature_ambient".to_owned(), "293.15 K".to_owned()];
    assert!(table(&document, "Connections").contains(&ambient));
    assert_eq!(html.matches("<svg").count(), 7);
}
