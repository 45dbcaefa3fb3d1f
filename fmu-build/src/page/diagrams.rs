//! The diagrams of a model's page, chosen by the model's behaviour.

use anyhow::{Context, Result};
use stribeck::catalogue::Family;
use stribeck::model::{ModelType, Preset, Variable};

use crate::describe::text;
use crate::page::curve::{self, Curve, Law};
use crate::page::figure::{self, Figure, Line, Quantity, Style};
use crate::page::motion::{self, Motion};
use crate::page::sweep::{self, Sweep};

/// The diagrams of a model as HTML.
pub fn html(model: &'static ModelType, family: Family) -> Result<String> {
    let figures = match family {
        Family::Friction => of_law(&Law::new(model, None)?),
        Family::ShockAbsorber | Family::Component => of_part(model),
        Family::Host => of_host(model),
    };
    let figures = figures.with_context(|| format!("cannot draw the diagrams of {}", model.name))?;
    Ok(row(&figures))
}

/// The diagrams of a friction law with the values of a preset, as HTML.
pub fn preset(model: &'static ModelType, preset: &'static Preset) -> Result<String> {
    let context = || format!("cannot draw {} with the preset {}", model.name, preset.name);
    Ok(row(&of_law(&Law::new(model, Some(preset))?).with_context(context)?))
}

fn row(figures: &[Figure]) -> String {
    format!("<div class=\"diagrams\">\n{}</div>\n", figures.iter().map(figure::html).collect::<String>())
}

fn of_law(law: &Law) -> Result<Vec<Figure>> {
    let (figure, range) = over_velocity(law)?;
    let mut figures = vec![figure];
    figures.extend(over_displacement(law, range)?);
    Ok(figures)
}

fn words(variable: &Variable) -> String {
    variable.path.to_string().replace('_', " ")
}

fn quantity(variable: &Variable) -> Quantity {
    Quantity { name: words(variable), unit: text::unit(variable) }
}

/// Force over velocity, and the range of the velocities.
fn over_velocity(law: &Law) -> Result<(Figure, f64)> {
    let range = law.velocity_range()?;
    let steady = law.steady(range, 0.0)?;
    let mut caption = format!("Friction force at held velocities{}", conditions(law)?);
    let mut lines = Vec::new();
    if let Some((curve, period)) = oscillation(law, range, &steady)? {
        caption += &format!(", and for a velocity that oscillates with a period of {}", duration(period));
        lines.push(line("oscillating velocity", Style::Second, curve));
    }
    if law.has_external_force() {
        external(law, range, &steady, &mut lines)?;
    } else {
        lines.push(line("held velocity", Style::First, steady));
    }
    let quantities = [law.velocity, law.force].map(|column| quantity(&law.model.table.at(column)));
    Ok((Figure { caption: caption + ".", quantities, lines }, range))
}

fn line(name: &str, style: Style, points: Curve) -> Line {
    Line { name: name.to_owned(), style, points }
}

/// The other input of all laws, which does not change.
fn conditions(law: &Law) -> Result<String> {
    let Some((column, value)) = law.normal_force()? else { return Ok(String::new()) };
    Ok(format!(", normal force {} {}", text::number(value), text::unit(&law.model.table.at(column))))
}

fn duration(seconds: f64) -> String {
    // The period is a round number; its product need not be.
    let milliseconds = (1e6 * seconds).round() / 1e3;
    if seconds < 1.0 { format!("{} ms", text::number(milliseconds)) } else { format!("{} s", text::number(seconds)) }
}

/// The region of the friction forces that an external force can cause, where it determines them; elsewhere the curve.
fn external(law: &Law, range: f64, steady: &Curve, lines: &mut Vec<Line>) -> Result<()> {
    let [low, high] = curve::limits([steady], 1);
    let large = 1e3 * low.abs().max(high.abs()).max(1e-3);
    let (lower, upper) = (law.steady(range, -large)?, law.steady(range, large)?);
    let is_free = |at: &usize| (upper[*at][1] - lower[*at][1]).abs() > 1e-3 * (high - low);
    let Some(first) = (0..upper.len()).find(is_free) else {
        lines.push(line("held velocity", Style::First, upper));
        return Ok(());
    };
    let last = (0..upper.len()).rfind(is_free).unwrap_or(first);
    let region = upper[first..=last].iter().chain(lower[first..=last].iter().rev()).copied().collect();
    lines.push(line("determined by the external force", Style::Region, region));
    lines.push(line("sliding", Style::First, upper[..first].to_vec()));
    lines.push(line("sliding", Style::First, upper[last + 1..].to_vec()));
    Ok(())
}

/// The curve of an oscillating velocity and its period, for a law that has a memory.
fn oscillation(law: &Law, range: f64, steady: &Curve) -> Result<Option<(Curve, f64)>> {
    let Some(period) = law.period(range)? else { return Ok(None) };
    let oscillation = law.oscillation(range, period)?;
    let [held, moving] = [steady, &oscillation].map(|curve| curve::limits([curve], 1));
    // False for a response too violent to be drawn in the same figure.
    let is_fit = moving[1] - moving[0] < 4.0 * (held[1] - held[0]);
    Ok(is_fit.then_some((oscillation, period)))
}

/// Force over displacement, for a law with pre-sliding displacement.
fn over_displacement(law: &Law, range: f64) -> Result<Option<Figure>> {
    let Some(scale) = law.displacement_scale(range)? else { return Ok(None) };
    let lines = vec![line("", Style::First, law.strokes(scale, range)?)];
    let displacement = Quantity { name: "displacement".to_owned(), unit: "m" };
    let quantities = [displacement, quantity(&law.model.table.at(law.force))];
    let caption = "Pre-sliding: friction force for slow reciprocating strokes of growing amplitude.".to_owned();
    Ok(Some(Figure { caption, quantities, lines }))
}

fn of_part(model: &'static ModelType) -> Result<Vec<Figure>> {
    let Sweep { across, answer, curve } = sweep::of(model)?;
    let [across, answer] = [across, answer].map(|column| model.table.at(column));
    let lines = vec![line("", Style::First, curve)];
    let with =
        model.presets.first().map_or(String::new(), |preset| format!(", with the parameter set {}", preset.name));
    let caption = format!("{} over {} in a cycle{with}.", capitalised(&words(&answer)), words(&across));
    Ok(vec![Figure { caption, quantities: [quantity(&across), quantity(&answer)], lines }])
}

fn of_host(model: &'static ModelType) -> Result<Vec<Figure>> {
    let Motion { with, states, times, values } = motion::motion(model)?;
    let states = states.map(|column| model.table.at(column));
    let over_time = |index: usize| {
        let points = times.iter().zip(&values).map(|(time, value)| [*time, value[index]]).collect();
        let lines = vec![line("", Style::First, points)];
        let quantities = [Quantity { name: "time".to_owned(), unit: "s" }, quantity(&states[index])];
        Figure { caption: format!("{} over time.", capitalised(&words(&states[index]))), quantities, lines }
    };
    let lines = vec![line("", Style::First, values.clone())];
    let caption = format!("Phase portrait, {with}.");
    let portrait = Figure { caption, quantities: states.each_ref().map(quantity), lines };
    Ok(vec![over_time(0), portrait])
}

fn capitalised(text: &str) -> String {
    let (first, rest) = text.split_at(1);
    first.to_uppercase() + rest
}

#[cfg(test)]
mod tests {
    use super::*;
    use stribeck::catalogue::{by_name, documented};

    fn names(model: &str) -> Vec<String> {
        let law = Law::new(by_name(model).unwrap(), None).unwrap();
        over_velocity(&law).unwrap().0.lines.into_iter().map(|line| line.name).collect()
    }

    #[test]
    fn lines_follow_from_the_behaviour() {
        assert_eq!(names("BrownMcPhee"), ["held velocity"]);
        assert_eq!(names("LuGre"), ["oscillating velocity", "held velocity"]);
        assert_eq!(names("Karnopp"), ["determined by the external force", "sliding", "sliding"]);
    }

    #[test]
    fn laws_with_bristles_have_a_second_diagram() {
        let count = |model: &str| html(by_name(model).unwrap(), Family::Friction).unwrap().matches("<svg").count();
        assert_eq!(["LuGre", "Dahl"].map(count), [2, 2]);
        assert_eq!(["BrownMcPhee", "Karnopp", "CoulombStiction"].map(count), [1, 1, 1]);
    }

    /// The region of Karnopp's law is the band |v| <= v_0 between -f_s and f_s.
    #[test]
    fn region_holds_the_forces_that_the_external_force_can_cause() {
        let law = Law::new(by_name("Karnopp").unwrap(), None).unwrap();
        let (figure, range) = over_velocity(&law).unwrap();
        let region = &figure.lines[0].points;
        let ([left, right], [low, high]) = (curve::limits([region], 0), curve::limits([region], 1));
        assert!((right - 1e-3).abs() < 0.01 * range && (left + 1e-3).abs() < 0.01 * range, "{left} {right}");
        assert!((high - 1.4715).abs() < 1e-12 && (low + 1.4715).abs() < 1e-12, "{low} {high}");
    }

    /// The points of every curve of every model, with every preset, are finite and vary.
    #[test]
    fn all_models_with_all_presets_can_be_drawn() {
        for (model, _) in documented(Family::Friction) {
            for preset in model.presets.iter().map(Some).chain([None]) {
                let (figure, range) = over_velocity(&Law::new(model, preset).unwrap()).unwrap();
                assert!(range > 0.0 && range <= 1.5, "{}: {range}", model.name);
                let points = || figure.lines.iter().flat_map(|line| &line.points);
                assert!(points().flatten().all(|value| value.is_finite()), "{}", model.name);
                let [low, high] = curve::limits(figure.lines.iter().map(|line| &line.points), 1);
                assert!(high > low, "{}", model.name);
            }
        }
        for (model, _) in documented(Family::ShockAbsorber).chain(documented(Family::Component)) {
            assert_eq!(of_part(model).unwrap().len(), 1, "{}", model.name);
        }
        for (model, _) in documented(Family::Host) {
            assert_eq!(of_host(model).unwrap().len(), 2, "{}", model.name);
        }
    }

    #[test]
    fn durations_are_readable() {
        assert_eq!([duration(0.08), duration(0.0015), duration(3.0)], ["80 ms", "1.5 ms", "3 s"]);
    }
}
