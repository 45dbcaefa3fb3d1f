//! A fitted tyre as a tyre property file and as a table.

use std::fmt::Write;

use stribeck::host::{FormulaVersion, MagicFormula, Side};
use stribeck::model::Columns;

use super::super::uncertainty::digits;
use super::{TyreEstimate, TyreFit, Verdict};

/// Sections of the format, by the first letters of their keys.
const SECTIONS: [(&str, &[&str]); 3] = [
    ("LONGITUDINAL_COEFFICIENTS", &["PCX", "PDX", "PEX", "PKX", "PHX", "PVX", "PPX", "RBX", "RCX", "REX", "RHX"]),
    ("LATERAL_COEFFICIENTS", &["PCY", "PDY", "PEY", "PKY", "PHY", "PVY", "PPY", "RBY", "RCY", "REY", "RHY", "RVY"]),
    ("ALIGNING_COEFFICIENTS", &["Q", "SSZ", "PPZ"]),
];

/// The file (`.tir`), which [`crate::tir::parse`] reads. What is not determined is a comment without a number.
pub fn property_file(fit: &TyreFit) -> String {
    let formula = &fit.formula;
    let is_six = FormulaVersion::of(formula.version) == FormulaVersion::Six;
    let (name, format) = if is_six { ("6.1", "'USER'\nFITTYP = 61") } else { ("5.2", "'PAC2002'") };
    let mut text =
        format!("$ Coefficients of the Magic Formula {name}, fitted to a test by stribeck. Axes: ISO 8855.\n");
    text += &notes(fit, "$ ");
    text += &residuals(fit, "$ ");
    let side = if Side::of(formula.side) == Side::Left { "LEFT" } else { "RIGHT" };
    let (unit, pressures) = if is_six { six(formula) } else { Default::default() };
    let _ = write!(
        text,
        "[UNITS]\nLENGTH = 'meter'\nFORCE = 'newton'\nANGLE = 'radians'\nMASS = 'kg'\nTIME = 'second'\n{unit}[MODEL]\n\
         PROPERTY_FILE_FORMAT = {format}\nTYRESIDE = '{side}'\nLONGVL = {}\n[DIMENSION]\nUNLOADED_RADIUS = {}\n\
         {pressures}[VERTICAL]\nFNOMIN = {}\n",
        formula.longvl, formula.unloaded_radius, formula.fnomin
    );
    for (section, beginnings) in SECTIONS {
        let is_here = |one: &&TyreEstimate| beginnings.iter().any(|begin| one.key.starts_with(begin));
        let lines: String = fit.estimates.iter().filter(is_here).map(line).collect();
        if !lines.is_empty() {
            let _ = write!(text, "[{section}]\n{lines}");
        }
    }
    text
}

/// The unit of the inflation pressure, and the pressures of version 6.1.
fn six(formula: &MagicFormula) -> (String, String) {
    let MagicFormula { inflpres, nompres, .. } = formula;
    let pressures = format!("[OPERATING_CONDITIONS]\nINFLPRES = {inflpres}\nNOMPRES = {nompres}\n");
    ("PRESSURE = 'pascal'\n".to_owned(), pressures)
}

/// A line of the file.
fn line(one: &TyreEstimate) -> String {
    let TyreEstimate { key, value, .. } = one;
    match note(one) {
        Ok(note) => format!("{key:<6} = {value:<24} $ {note}; {}\n", help(key)),
        Err(reason) => format!("$ {key}: not determined: {reason}\n"),
    }
}

/// How well the value of a coefficient is known, or why it is not.
fn note(TyreEstimate { value, verdict, .. }: &TyreEstimate) -> Result<String, &str> {
    match verdict {
        Verdict::Within(half) => {
            let [low, high] = [value - half, value + half].map(digits);
            Ok(format!("95 %: {low} to {high}"))
        }
        Verdict::Held => Ok("held".to_owned()),
        Verdict::AtEnd => Ok("at an end of its range".to_owned()),
        Verdict::Not(reason) => Err(reason),
    }
}

/// The notes, each in a line with a mark.
fn notes(fit: &TyreFit, mark: &str) -> String {
    fit.notes.iter().map(|note| format!("{mark}{note}\n")).collect()
}

/// The residuals of the channels, each in a line with a mark.
fn residuals(fit: &TyreFit, mark: &str) -> String {
    let line = |(name, unit, rms, most): &(&str, &str, f64, f64)| {
        format!("{mark}{name}: RMS residual {} {unit} of {} {unit}\n", digits(*rms), digits(*most))
    };
    fit.left.iter().map(line).collect()
}

/// Meaning of a coefficient, from the table of the library.
fn help(key: &str) -> String {
    let name = key.to_lowercase();
    let variable = MagicFormula::TABLE.iter().find(|variable| variable.path.to_string() == name);
    variable.map_or(String::new(), |variable| variable.help.to_owned())
}

/// The fit as a table for a terminal.
pub fn table(fit: &TyreFit) -> String {
    let line = |one: &TyreEstimate| match (note(one), &one.verdict) {
        (Ok(note), Verdict::Within(_)) => format!("  {:<6} {} ({note})\n", one.key, digits(one.value)),
        (Ok(note), _) => format!("  {:<6} {} {note}\n", one.key, digits(one.value)),
        (Err(reason), _) => format!("  {:<6} not determined: {reason}\n", one.key),
    };
    notes(fit, "") + &residuals(fit, "") + &fit.estimates.iter().map(line).collect::<String>()
}
