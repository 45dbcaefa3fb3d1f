//! Pictures read back from their SVG and PNG.

use resvg::tiny_skia::Pixmap;
use roxmltree::{Document, Node};

use super::*;
use stribeck_solve::run::{Column, Passed, Settings, Solver};
use stribeck_solve::solve::Statistics;
use stribeck_solve::system::Source;

/// The belt and runs of it with these laws.
pub(crate) fn belt(laws: &[&str]) -> (System, Vec<(String, Outcome)>) {
    let source = Source::open("belt").unwrap();
    let system = System::assemble(&source, None, &[]).unwrap();
    let run = |law: &&str| {
        let system = System::assemble(&source, Some(law), &[]).unwrap();
        let outcome = stribeck_solve::run::run(&system, &Settings::of(&system), &needed(&system)).unwrap();
        (law.to_string(), outcome)
    };
    let outcomes = laws.iter().map(run).collect();
    (system, outcomes)
}

/// An outcome of the belt with courses made up: force, velocity, position and acceleration over time.
fn made_up(time: Vec<f64>, course: impl Fn(f64) -> f64) -> Outcome {
    let names = [
        ("rig.position", "m"),
        ("rig.velocity", "m/s"),
        ("der(rig.block_velocity)", "m/s2"),
        ("friction.friction_force", "N"),
    ];
    let columns = names.map(|(name, unit)| {
        let values = time.iter().map(|time| course(*time)).collect();
        Column { name: name.to_owned(), unit: unit.to_owned(), values }
    });
    Outcome {
        law: None,
        solver: Solver::Rodas5P,
        time,
        columns: columns.into(),
        end: End::Reached,
        statistics: Statistics::default(),
        events: Vec::new(),
        elapsed: std::time::Duration::ZERO,
        check: None,
    }
}

fn grid(count: usize, every: f64) -> Vec<f64> {
    (0..count).map(|number| number as f64 * every).collect()
}

fn of_class<'a>(document: &'a Document, class: &str) -> Vec<Node<'a, 'a>> {
    let has = |node: &Node| node.attribute("class").is_some_and(|names| names.split(' ').any(|name| name == class));
    document.descendants().filter(has).collect()
}

/// Text of a node with that of its parts.
fn whole_text(node: Node) -> String {
    node.descendants().filter_map(|part| part.is_text().then(|| part.text()).flatten()).collect()
}

/// The line through the outermost ticks, as a person with a ruler draws it.
fn ruler(document: &Document, class: &str, attribute: &str, shift: f64) -> impl Fn(f64) -> f64 {
    let ticks: Vec<[f64; 2]> = of_class(document, class)[0]
        .children()
        .filter(Node::is_element)
        .map(|tick| {
            let place: f64 = tick.attribute(attribute).unwrap().parse().unwrap();
            [place - shift, tick.text().unwrap().replace('\u{2212}', "-").parse().unwrap()]
        })
        .collect();
    let ([a, at_a], [b, at_b]) = (ticks[0], ticks[ticks.len() - 1]);
    move |place| at_a + (place - a) * (at_b - at_a) / (b - a)
}

/// The curves of a picture in the units of its axes.
fn read_back(svg: &str) -> Vec<Vec<[f64; 2]>> {
    let document = Document::parse(svg).unwrap();
    let (across, up) = (ruler(&document, "x", "x", 0.0), ruler(&document, "y", "y", 4.2));
    let point = |point: &str| {
        let (x, y) = point.split_once(' ').unwrap();
        [across(x.parse().unwrap()), up(y.parse().unwrap())]
    };
    let curve = |node: &Node| node.attribute("d").unwrap().split(['M', 'L']).skip(1).map(point).collect();
    of_class(&document, "law").iter().map(curve).collect()
}

#[test]
fn every_law_has_one_path_and_one_entry_in_each_of_seven_pictures() {
    let laws = ["CoulombStiction", "Karnopp", "Hollars", "LuGre"];
    let (system, outcomes) = belt(&laws);
    for theme in [Theme::Light, Theme::Dark, Theme::Auto] {
        let pictures = all(&system, &outcomes, &Options { theme, zoom: None });
        assert_eq!(pictures.iter().map(|picture| picture.kind).collect::<Vec<_>>(), Kind::ALL);
        for Picture { kind, svg, title, .. } in &pictures {
            let document = Document::parse(svg).unwrap();
            let curves = of_class(&document, "law");
            assert_eq!(curves.len(), laws.len(), "{kind}");
            let names: Vec<String> = of_class(&document, "entry").iter().map(|entry| whole_text(*entry)).collect();
            assert_eq!(names, laws, "{kind}");
            let looks = curves.iter().map(|curve| (curve.attribute("stroke"), curve.attribute("stroke-dasharray")));
            let looks: std::collections::BTreeSet<_> = looks.collect();
            assert_eq!(looks.len(), laws.len());
            assert_eq!(whole_text(of_class(&document, "title")[0]), *title);
        }
    }
}

#[test]
fn names_of_the_axes_fit_the_numbers() {
    let (system, outcomes) = belt(&["CoulombStiction"]);
    let pictures = all(&system, &outcomes, &Options::default());
    let names = |kind: Kind| -> Vec<String> {
        let svg = &pictures.iter().find(|picture| picture.kind == kind).unwrap().svg;
        let document = Document::parse(svg).unwrap();
        of_class(&document, "names")[0].children().filter(Node::is_element).map(whole_text).collect()
    };
    assert_eq!(names(Kind::Position), ["Time t in s", "Position x in mm"]);
    assert_eq!(names(Kind::Velocity), ["Time t in s", "Relative velocity v in mm/s"]);
    assert_eq!(names(Kind::Acceleration), ["Time t in s", "Acceleration a in m/s²"]);
    assert_eq!(names(Kind::ForceOverVelocity), ["Relative velocity v in mm/s", "Friction force ff in N"]);
    assert_eq!(names(Kind::ForceOverDisplacement), ["Displacement x in mm", "Friction force ff in N"]);
    // Read with a ruler, the block is carried to f_s / k = 735.75 mm at most 0.1 m/s.
    let position = read_back(&pictures[0].svg);
    let breakaway = position[0].iter().find(|point| point[1] >= 735.75).unwrap();
    assert!((breakaway[0] - 7.3575).abs() < 0.1, "{breakaway:?}");
}

/// What is drawn are the outcome's values: each lies on the polygon, to the twentieth of a millimetre of the print.
#[test]
fn curves_reproduce_the_outcome() {
    let (system, outcomes) = belt(&["BrownMcPhee"]);
    let pictures = all(&system, &outcomes, &Options::default());
    let drawn = &read_back(&pictures[0].svg)[0];
    let position = outcomes[0].1.values("rig.position").unwrap();
    for (time, value) in outcomes[0].1.time.iter().zip(position) {
        let right = drawn.partition_point(|point| point[0] < *time).clamp(1, drawn.len() - 1);
        let [[x_0, y_0], [x_1, y_1]] = [drawn[right - 1], drawn[right]];
        let polygon = y_0 + (y_1 - y_0) * (time - x_0) / (x_1 - x_0);
        // A unit of the drawing is 2.8 mm high and 75 ms wide; the block is at most 0.5 m/s fast.
        assert!((polygon - 1e3 * value).abs() < 0.55, "{time} s: {polygon} mm instead of {value} m");
    }
}

#[test]
fn a_spike_in_a_long_run_is_in_the_picture() {
    let (system, _) = belt(&[]);
    let time = grid(400_001, 1e-4);
    let spike = time[271_828];
    let outcome = made_up(time, |time| if time == spike { -7.5 } else { (0.4 * time).sin() });
    let pictures = all(&system, &[("Long".to_owned(), outcome)], &Options::default());
    let force = &pictures.iter().find(|picture| picture.kind == Kind::Force).unwrap().svg;
    let lowest = read_back(force)[0].iter().copied().min_by(|a, b| a[1].total_cmp(&b[1])).unwrap();
    assert!((lowest[1] + 7.5).abs() < 1e-3 && (lowest[0] - spike).abs() < 0.01, "{lowest:?}");
    for Picture { kind, svg, .. } in &pictures {
        assert!(svg.len() < 80_000, "{kind}: {}", svg.len());
    }
}

#[test]
fn zoom_is_about_the_first_breakaway_and_has_the_range_in_its_title() {
    let (system, outcomes) = belt(&["CoulombStiction", "Karnopp"]);
    let zoom =
        |options: &Options| all(&system, &outcomes, options).into_iter().find(|made| made.kind == Kind::Zoom).unwrap();
    let found = zoom(&Options::default());
    assert_eq!(found.title, "Friction force at the first breakaway, 6.7 s to 8 s");
    for curve in read_back(&found.svg) {
        assert!((curve[0][0] - 6.7).abs() < 2e-3 && (curve[curve.len() - 1][0] - 8.0).abs() < 2e-3, "{curve:?}");
    }
    let given = zoom(&Options { zoom: Some([1.25, 2.5]), ..Options::default() });
    assert_eq!(given.title, "Friction force 1.25 s to 2.5 s");
    let [ends, _] = [0, 1].map(|law| read_back(&given.svg)[law].clone());
    assert!((ends[0][0] - 1.25).abs() < 2e-3 && (ends[ends.len() - 1][0] - 2.5).abs() < 2e-3);
}

/// Without events the zoom is about the largest change of force.
#[test]
fn zoom_without_events_is_about_the_largest_change() {
    let (system, _) = belt(&[]);
    let outcome = made_up(grid(1001, 0.01), |time| if time < 6.0 { 0.1 * time } else { 0.2 });
    let mut outcomes = vec![("Step".to_owned(), outcome)];
    let title = |outcomes: &[(String, Outcome)]| {
        let pictures = all(&system, outcomes, &Options::default());
        pictures.into_iter().find(|made| made.kind == Kind::Zoom).map(|made| made.title)
    };
    assert_eq!(title(&outcomes).unwrap(), "Friction force at its largest change, 5.84 s to 6.16 s");
    // The capture of a sliding body at 6 s is no breakaway; the event at 2 s, after which it is faster, is one.
    outcomes[0].1.events = [6.0, 2.0].map(|time| Passed { time, part: "friction".to_owned() }).into();
    assert_eq!(title(&outcomes).unwrap(), "Friction force at the first breakaway, 1.84 s to 2.16 s");
    assert_eq!(title(&[]), None);
}

#[test]
fn png_has_the_stated_size_and_shows_curve_and_text() {
    let (system, outcomes) = belt(&["LuGre"]);
    let options = |theme| Options { theme, zoom: None };
    let picture = all(&system, &outcomes, &options(Theme::Light)).swap_remove(3);
    let png = picture.png(1200).unwrap();
    let pixels = Pixmap::decode_png(&png).unwrap();
    let height = Document::parse(&picture.svg).unwrap().root_element().attribute("viewBox").unwrap().to_owned();
    let height: f64 = height.split(' ').nth(3).unwrap().parse().unwrap();
    assert_eq!((pixels.width(), pixels.height()), (1200, (2.0 * height).round() as u32));
    let count = |colour: [u8; 3]| {
        let is_it =
            |pixel: &&resvg::tiny_skia::PremultipliedColorU8| [pixel.red(), pixel.green(), pixel.blue()] == colour;
        pixels.pixels().iter().filter(is_it).count()
    };
    assert!(count([0x00, 0x72, 0xb2]) > 3_000, "curve: {}", count([0x00, 0x72, 0xb2]));
    assert!(count([0x1a, 0x1a, 0x1a]) > 2_000, "texts: {}", count([0x1a, 0x1a, 0x1a]));
    assert!(count([0xff, 0xff, 0xff]) > 600_000);
    // A picture for both surroundings is light, and only the dark one differs.
    let of = |theme| all(&system, &outcomes, &options(theme)).swap_remove(3).png(1200).unwrap();
    assert_eq!(of(Theme::Auto), png);
    assert_ne!(of(Theme::Dark), png);
    assert!(picture.png(0).is_err() && picture.png(10_001).is_err());
}

/// Read with a ruler on the axis of its own frame, the residual is what the curves differ by; those of others are there too.
#[test]
fn residuals_are_measured_less_other_in_a_frame_below() {
    let over_time =
        |course: &dyn Fn(f64) -> f64| grid(101, 0.1).into_iter().map(|t| [t, course(t)]).collect::<Vec<_>>();
    let measured = ("measured".to_owned(), over_time(&|t| 5.0 * t.sin()));
    let others = [("near", 0.25), ("far", -0.5)];
    let others = others.map(|(name, less)| (name.to_owned(), over_time(&|t| 5.0 * t.sin() - less))).into();
    let picture = beside(Kind::Force, str::to_owned, measured, others, |unit| unit, Theme::Light).unwrap();
    let document = Document::parse(&picture.svg).unwrap();
    assert_eq!(of_class(&document, "law").len(), 3);
    assert!(of_class(&document, "law")[0].attribute("stroke-opacity").is_some(), "what is measured is a band");
    let numbers = of_class(&document, "y")[1].children().filter(Node::is_element);
    let ticks: Vec<[f64; 2]> = numbers
        .map(|tick| {
            [
                tick.attribute("y").unwrap().parse().unwrap(),
                tick.text().unwrap().replace('\u{2212}', "-").parse().unwrap(),
            ]
        })
        .collect();
    let ([a, at_a], [b, at_b]) = (ticks[0], ticks[ticks.len() - 1]);
    let residuals = of_class(&document, "residual");
    assert_eq!(residuals.len(), 2);
    for (residual, (class, less)) in residuals.iter().zip([("law-2", 0.25), ("law-3", -0.5)]) {
        assert!(residual.attribute("class").unwrap().ends_with(class));
        for place in residual.attribute("d").unwrap().split(['M', 'L']).skip(1) {
            let y: f64 = place.split_once(' ').unwrap().1.parse().unwrap();
            let value = at_a + (y + 4.2 - a) * (at_b - at_a) / (b - a);
            assert!((value - less).abs() < 0.01, "{value} in place of {less}");
        }
    }
    assert!(whole_text(of_class(&document, "names")[0]).ends_with("Residual in N\n"), "{}", picture.svg);
}

#[test]
fn a_run_that_did_not_converge_ends_with_a_cross() {
    let (system, _) = belt(&[]);
    let mut stopped = made_up(grid(401, 0.01), |time| time);
    stopped.end = End::Failed { time: 4.0004, reason: "the step became too short".to_owned() };
    let outcomes = [("Whole".to_owned(), made_up(grid(1001, 0.01), f64::sin)), ("Stopped".to_owned(), stopped)];
    let svg = &all(&system, &outcomes, &Options::default())[0].svg;
    let document = Document::parse(svg).unwrap();
    assert_eq!(of_class(&document, "stop").len(), 1);
    assert!(of_class(&document, "stop")[0].attribute("class").unwrap().contains("law-2"));
    assert_eq!(whole_text(of_class(&document, "entry")[1]), "Stopped (stopped at 4 s)");
    let last = *read_back(svg)[1].last().unwrap();
    assert!((last[0] - 4.0).abs() < 0.01 && (last[1] - 4.0).abs() < 0.01, "{last:?}");
}

#[test]
fn more_laws_than_can_be_told_apart_are_split_evenly_with_equal_axes() {
    let (system, _) = belt(&[]);
    let law = |number: usize| (format!("Law {number}"), made_up(grid(101, 0.1), move |time| number as f64 * time));
    let outcomes: Vec<(String, Outcome)> = (1..=9).map(law).collect();
    let pictures = all(&system, &outcomes, &Options::default());
    let names: Vec<String> = pictures.iter().take(2).map(Picture::name).collect();
    assert_eq!(names, ["position-1", "position-2"]);
    assert_eq!(pictures[0].title, "Position over time (laws 1 to 5 of 9)");
    assert_eq!(pictures[1].title, "Position over time (laws 6 to 9 of 9)");
    let curves = [read_back(&pictures[0].svg), read_back(&pictures[1].svg)];
    assert_eq!(curves.each_ref().map(Vec::len), [5, 4]);
    let ends: Vec<f64> = curves.iter().flatten().map(|curve| curve[curve.len() - 1][1]).collect();
    for (number, end) in ends.iter().enumerate() {
        assert!((end - 10.0 * (number as f64 + 1.0)).abs() < 0.1, "{ends:?}");
    }
    assert_eq!(all(&system, &outcomes[..8], &Options::default()).len(), 7);
}

#[test]
fn names_are_escaped_and_cut_to_the_picture() {
    let (system, _) = belt(&[]);
    let hostile = "</text><script>alert(\"1\")</script>&amp;\u{1}'".repeat(20);
    let outcomes = [(hostile, made_up(grid(11, 1.0), f64::cos))];
    for picture in all(&system, &outcomes, &Options::default()) {
        let document = Document::parse(&picture.svg).unwrap();
        assert!(document.descendants().all(|node| node.tag_name().name() != "script"));
        let entry = whole_text(of_class(&document, "entry")[0]);
        assert!(entry.starts_with("</text><script>") && entry.ends_with('\u{2026}'), "{entry}");
        picture.png(300).unwrap();
    }
}

/// Nothing overlaps, and nothing is outside the picture: by the boxes of texts and legend as they are rendered.
#[test]
fn texts_stay_apart_and_inside() {
    let (system, _) = belt(&[]);
    let names = ["BengisuAkay", "ThrelfallModified", "A law of one's own, with a long name", "x", "NonReversible"];
    for count in [1, 4, 5, 8] {
        for scale in [1.0, -2.7e-9, 4.2e8] {
            let law = |number: usize| {
                (
                    names[number % 5].to_owned(),
                    made_up(grid(101, 0.1), move |time| scale * (time + number as f64).sin()),
                )
            };
            let outcomes: Vec<(String, Outcome)> = (0..count).map(law).collect();
            for picture in all(&system, &outcomes, &Options::default()) {
                let tree = Tree::from_str(&picture.svg, &text::READER).unwrap();
                let mut boxes = Vec::new();
                collect(tree.root(), &mut boxes);
                assert!(boxes.len() > 10 + count);
                let size = tree.size();
                for (number, (text, one)) in boxes.iter().enumerate() {
                    let inside = one.left() >= 0.0 && one.top() >= 0.0;
                    assert!(inside && one.right() <= size.width() && one.bottom() <= size.height(), "{text} {one:?}");
                    for (other, two) in &boxes[number + 1..] {
                        let apart = one.right() < two.left() || two.right() < one.left();
                        let apart = apart || one.bottom() < two.top() + 2.0 || two.bottom() < one.top() + 2.0;
                        assert!(apart, "{}: '{text}' {one:?} and '{other}' {two:?}", picture.title);
                    }
                }
            }
        }
    }
}

/// The texts under a node with their boxes.
fn collect(group: &resvg::usvg::Group, boxes: &mut Vec<(String, resvg::usvg::Rect)>) {
    for node in group.children() {
        match node {
            resvg::usvg::Node::Group(group) => collect(group, boxes),
            resvg::usvg::Node::Text(text) => {
                let words = text.chunks().iter().map(|chunk| chunk.text()).collect();
                boxes.push((words, text.abs_bounding_box()));
            }
            _ => {}
        }
    }
}
