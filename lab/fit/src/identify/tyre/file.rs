//! A fitted tyre as a tyre property file and as a table.

use std::fmt::Write;

use stribeck::host::{MagicFormula, Side};
use stribeck::model::Columns;

use super::super::uncertainty::digits;
use super::{Told, TyreEstimate, TyreFit};

/// Sections of the format, by the first letters of their keys.
const SECTIONS: [(&str, &[&str]); 3] = [
    ("LONGITUDINAL_COEFFICIENTS", &["PCX", "PDX", "PEX", "PKX", "PHX", "PVX", "RBX", "RCX", "REX", "RHX"]),
    ("LATERAL_COEFFICIENTS", &["PCY", "PDY", "PEY", "PKY", "PHY", "PVY", "RBY", "RCY", "REY", "RHY", "RVY"]),
    ("ALIGNING_COEFFICIENTS", &["Q", "SSZ"]),
];

/// The file (`.tir`), which [`crate::tir::parse`] reads. What is not determined is a comment without a number.
pub fn property_file(fit: &TyreFit) -> String {
    let formula = &fit.formula;
    let mut text =
        "$ Coefficients of the Magic Formula 5.2, fitted to a test by stribeck. Axes: ISO 8855.\n".to_owned();
    for (name, unit, rms, most) in &fit.left {
        let _ = writeln!(text, "$ {name}: RMS residual {} {unit} of {} {unit}", digits(*rms), digits(*most));
    }
    let side = if Side::of(formula.side) == Side::Left { "LEFT" } else { "RIGHT" };
    let _ = write!(
        text,
        "[UNITS]\nLENGTH = 'meter'\nFORCE = 'newton'\nANGLE = 'radians'\nMASS = 'kg'\nTIME = 'second'\n[MODEL]\n\
         PROPERTY_FILE_FORMAT = 'PAC2002'\nTYRESIDE = '{side}'\nLONGVL = {}\n[DIMENSION]\nUNLOADED_RADIUS = {}\n\
         [VERTICAL]\nFNOMIN = {}\n",
        formula.longvl, formula.unloaded_radius, formula.fnomin
    );
    for (section, beginnings) in SECTIONS {
        let is_here = |one: &&TyreEstimate| beginnings.iter().any(|begin| one.key.starts_with(begin));
        let mut rest = fit.estimates.iter().filter(is_here).peekable();
        if rest.peek().is_some() {
            let _ = writeln!(text, "[{section}]");
        }
        for one in rest {
            let (key, value) = (&one.key, one.value);
            let _ = match &one.told {
                Told::Within(half) => {
                    let [low, high] = [value - half, value + half].map(digits);
                    writeln!(text, "{key:<6} = {value:<24} $ 95 %: {low} to {high}; {}", help(key))
                }
                Told::Held => writeln!(text, "{key:<6} = {value:<24} $ held; {}", help(key)),
                Told::AtEnd => writeln!(text, "{key:<6} = {value:<24} $ at an end of its range; {}", help(key)),
                Told::Not(reason) => writeln!(text, "$ {key}: not determined: {reason}"),
            };
        }
    }
    text
}

/// Meaning of a coefficient, from the table of the library.
fn help(key: &str) -> String {
    let name = key.to_lowercase();
    let variable = MagicFormula::TABLE.iter().find(|variable| variable.path.to_string() == name);
    variable.map_or(String::new(), |variable| variable.help.to_owned())
}

/// The fit as a table for a terminal.
pub fn table(fit: &TyreFit) -> String {
    let mut text = String::new();
    for (name, unit, rms, most) in &fit.left {
        let _ = writeln!(text, "{name}: RMS residual {} {unit} of {} {unit}", digits(*rms), digits(*most));
    }
    for one in &fit.estimates {
        let _ = match &one.told {
            Told::Within(half) => {
                let [low, high] = [one.value - half, one.value + half].map(digits);
                writeln!(text, "  {:<6} {} (95 %: {low} to {high})", one.key, digits(one.value))
            }
            Told::Held => writeln!(text, "  {:<6} {} held", one.key, digits(one.value)),
            Told::AtEnd => writeln!(text, "  {:<6} {} at an end of its range", one.key, digits(one.value)),
            Told::Not(reason) => writeln!(text, "  {:<6} not determined: {reason}", one.key),
        };
    }
    text
}
