//! Texts of the friction laws for the page in a browser, which draws its own curves.

use anyhow::{Context, Result};
use serde_json::{Map, Value, json};
use stribeck::catalogue::{self, Family};
use stribeck::model::ModelType;

use crate::page::curve::{Law, round_up};
use crate::page::typeset;

/// The text of each law as HTML, a round velocity that includes all features of its curve, and a stroke that shows how
/// the contact begins to slide, if the force depends on displacement.
pub fn json() -> Result<Value> {
    let laws = catalogue::documented(Family::Friction);
    let text = |(model, documentation): (&'static ModelType, &str)| {
        let context = || format!("cannot write the text of {}", model.name);
        Ok((model.name.to_owned(), of_law(model, documentation).with_context(context)?))
    };
    Ok(Value::Object(laws.map(text).collect::<Result<Map<String, Value>>>()?))
}

/// Strokes that show pre-sliding are this many times the way on which the contact yields.
const STROKE: f64 = 4.0;

fn of_law(model: &'static ModelType, documentation: &str) -> Result<Value> {
    let law = Law::new(model, None)?;
    let velocity = law.velocity_range()?;
    let stroke = law.displacement_scale(velocity)?.map(|scale| round_up(STROKE * scale));
    Ok(json!({ "html": typeset::html(model.name, documentation, "")?, "velocity": velocity, "stroke": stroke }))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The page shows every equation of a law, and strokes of bristles in micrometres.
    #[test]
    fn texts_have_equations_and_ranges() {
        let texts = json().unwrap();
        for (model, documentation) in catalogue::documented(Family::Friction) {
            let text = &texts[model.name];
            let html = text["html"].as_str().unwrap();
            assert!(documentation.matches("```text").count() <= html.matches("<div class=\"equations\">").count());
            assert!(html.contains("<math") && html.contains("<h2>Source</h2>"), "{}", model.name);
            assert!(text["velocity"].as_f64().unwrap() > 0.0, "{}", model.name);
        }
        // Defaults of LuGre: sigma_0 = 1e5 N/m carries up to 1.5 N, by 15 um at most.
        let stroke = texts["LuGre"]["stroke"].as_f64().unwrap();
        assert!((1e-6..2e-4).contains(&stroke), "{stroke}");
        assert!(texts["Coulomb"]["stroke"].is_null());
    }
}
