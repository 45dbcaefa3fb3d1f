//! Parameters that have the value of another one, and what a law that differs by direction needs of them.
//!
//! A contact that slides to and fro under a constant load with the levels f_+ and f_-, and a load cell with the offset b,
//! has the force
//!
//! ```text
//! F = f_+ + b,   v > 0          F = -f_- + b,   v < 0
//! ```
//!
//! which is that of (f_+ + c, f_- - c, b - c) for any c: only f_+ + b and f_- - b can be told.

use stribeck::model::{Kind, Meaning, ModelType, Variable};
use stribeck_solve::system::Fault;

use super::levels::{columns_of, levels_by_direction, pairs_of_levels};
use super::selection::{OF_RIG, Selection};

/// Refuses ties between parameters that the law does not have, or of which one cannot follow the other.
pub(super) fn check(law: &ModelType, known: &[(usize, Variable)], selection: &Selection) -> Result<(), Fault> {
    let names: Vec<String> = known.iter().map(|(_, variable)| variable.path.to_string()).collect();
    let unknown =
        |name: &str| Fault::unknown(format!("{}: parameter", law.name), name, names.iter().map(String::as_str));
    let find = |name: &String| {
        let place = names.iter().position(|one| one == name);
        place.map(|place| known[place].1).ok_or_else(|| unknown(name))
    };
    for (number, (name, source)) in selection.tied.iter().enumerate() {
        let refuse = |why: &str| Err(Fault::value(format_args!("tie {name} = {source}: {why}")));
        if OF_RIG.contains(&name.as_str()) || OF_RIG.contains(&source.as_str()) {
            return refuse("both must be parameters of the law");
        }
        let [one, other] = [find(name)?, find(source)?];
        let is_of_one_kind = matches!((one.kind, other.kind), (Kind::Real(a), Kind::Real(b)) if a.name == b.name);
        if !is_of_one_kind {
            return refuse("must be parameters of the same unit");
        }
        // A static level is known only after the kinetic ones.
        if one.meaning == Meaning::KineticLevel && other.meaning == Meaning::StaticLevel {
            return refuse("tie the static level to the kinetic one instead");
        }
        if selection.is_tied(source) {
            return refuse(&format!("{source} is tied itself"));
        }
        if selection.tied[..number].iter().any(|(earlier, _)| earlier == name) {
            return refuse("it is tied twice");
        }
        if selection.fits(name) || selection.fixed(name).is_some() {
            return refuse("it is held or fitted too");
        }
    }
    Ok(())
}

/// The columns that are tied, and those whose values they have.
pub(super) fn columns(law: &ModelType, selection: &Selection) -> Vec<(usize, usize)> {
    selection.tied.iter().filter_map(|(name, source)| Some((law.find(name)?, law.find(source)?))).collect()
}

/// The speeds at which friction falls, of levels that are tied to each other: nothing falls there.
pub(super) fn idle_speeds(law: &ModelType, tied: &[(usize, usize)]) -> Vec<usize> {
    let source = |column: usize| tied.iter().find(|(tied, _)| *tied == column).map_or(column, |(_, source)| *source);
    let of_levels = pairs_of_levels(law).into_iter().zip(columns_of(law, Meaning::FallSpeed));
    of_levels.filter(|([of, over], _)| source(*of) == source(*over)).map(|(_, speed)| speed).collect()
}

/// Whether a law has kinetic levels of both directions that are fitted, each for itself.
pub(super) fn has_open_directions(law: &ModelType, selection: &Selection) -> bool {
    open_directions(law, selection).is_some()
}

/// Their names.
fn open_directions(law: &ModelType, selection: &Selection) -> Option<[String; 2]> {
    let names = levels_by_direction(law)?.map(|column| law.table.at(column).path.to_string());
    let is_open = |name: &String| selection.fixed(name).is_none() && !selection.is_tied(name);
    names.iter().all(is_open).then_some(names)
}

/// Says what the levels of an axis mean whose offset is not fitted, since they contain it.
pub(super) fn without_offset(law: &ModelType, selection: &Selection) -> Option<String> {
    let levels = open_directions(law, selection)?;
    if !selection.fits("offset") || selection.fits_offset(true) {
        return None;
    }
    let [forward, backward] = &levels;
    Some(format!(
        "an offset of the force cannot be told apart from a difference of the levels by direction: offset is held at 0, \
         {forward} contains it, and {backward} its negative; for the offset of equal levels, tie \
         {backward}={forward}; for the levels of a known offset, fix it"
    ))
}
