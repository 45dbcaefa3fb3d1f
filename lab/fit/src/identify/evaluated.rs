//! Laws at given values, without a search.

use std::sync::atomic::AtomicBool;

use stribeck::model::{Kind, ModelType, Variable};
use stribeck_solve::system::Fault;

use super::least_squares::Found;
use super::parameter::{GRAVITY_COEFFICIENTS, known, refused};
use super::problem::Problem;
use super::warnings::warnings;
use super::{Experiment, Fit, Reference, Residuals, Searches, Selection, Settings, Watch, as_is};

/// Parts of an interval between samples, at most, with which values that are held are judged (chosen).
const FINEST: usize = 64;

/// The law at values that are all held, with the intervals between samples divided until that changes the residual by less
/// than a hundredth.
pub(super) fn evaluated(mut problem: Problem) -> Result<Fit, Fault> {
    let law = problem.law;
    let left =
        |problem: &Problem| problem.residuals(&[]).ok_or_else(|| refused(law, "the law is refused at these values"));
    let size = |left: &[f64]| left.iter().map(|one| one * one).sum::<f64>().sqrt();
    let (mut residuals, mut evaluations) = (left(&problem)?, 1);
    while problem.parts < FINEST {
        problem.parts *= 2;
        let finer = left(&problem)?;
        evaluations += 1;
        let change = size(&finer.iter().zip(&residuals).map(|(a, b)| a - b).collect::<Vec<_>>());
        residuals = finer;
        if change <= 0.01 * size(&residuals) {
            break;
        }
    }
    let found = Residuals::of_fit(&problem, &residuals);
    let warnings = warnings(&problem, (&residuals, &found), &[], Searches::Agree, 0.0);
    let at = Found { point: Vec::new(), cost: problem.loss.cost(&residuals), evaluations };
    Ok(Fit { warnings, ..as_is(&problem, &at, found)? })
}

/// The parameters of a law at the values that are given, otherwise at those at which a selection holds them, otherwise at
/// their start values.
pub(super) fn held(law: &ModelType, values: &Reference, selection: &Selection) -> Vec<(String, f64)> {
    let is_real = |variable: &Variable| variable.role.is_parameter() && matches!(variable.kind, Kind::Real(_));
    let real = known(law).into_iter().filter(|(_, variable)| is_real(variable));
    let value = |name: &str| values.get(name).copied().or_else(|| selection.fixed(name));
    let named = real.map(|(_, variable)| {
        let name = variable.path.to_string();
        let value = value(&name).unwrap_or(variable.start);
        (name, value)
    });
    named.collect()
}

/// Evaluates the law of a fit at other values, in the same experiments and with the mass, offset and delay of the fit.
/// Parameters that are not named have the values at which the task holds them, otherwise their start values.
pub fn evaluate(fit: &Fit, values: &Reference, experiments: &[Experiment], task: &Settings) -> Result<Fit, Fault> {
    let law = fit.law;
    let of_law = held(law, values, &task.selection).into_iter();
    let of_rig =
        [("mass", Some(fit.physical.mass)), ("offset", Some(fit.physical.offset)), ("delay", fit.physical.delay)];
    let of_gravity = GRAVITY_COEFFICIENTS.into_iter().zip(fit.physical.gravity);
    let of_gravity = of_gravity.map(|((name, _), value)| (name, Some(value)));
    let of_rig = of_rig.into_iter().chain(of_gravity).filter_map(|(name, value)| Some((name.to_owned(), value?)));
    let selection = Selection { fixed: of_law.chain(of_rig).collect(), ..Selection::default() };
    let task = Settings { selection, profiles: false, folds: 0, ..task.clone() };
    let watch = Watch { cancel: &AtomicBool::new(false), progress: &|_, _| {} };
    super::fit(law, experiments, &task, watch)
}

#[cfg(test)]
mod tests {
    use stribeck::catalogue::by_name;

    use super::super::fit_all;
    use super::super::tests::{fitted, measured, quick, quiet, standard};
    use super::*;

    /// Without a deflection the residual of a wrong coefficient is the difference times the load, but at rest, where the
    /// record begins.
    #[test]
    fn values_that_are_held_are_judged() {
        let data = [measured("Coulomb", &[("mu_k", 0.3)], &standard(400), 0.0, 1)];
        let load = &data[0].normal_force;
        let mean_square = load.iter().skip(1).map(|load| (0.02 * load).powi(2)).sum::<f64>() / load.len() as f64;
        let held =
            Settings { selection: Selection { fixed: vec![("mu_k".into(), 0.32)], ..Selection::default() }, ..quick() };
        let judged = fitted("Coulomb", &data, &held);
        assert!((judged.residuals.rms / mean_square.sqrt() - 1.0).abs() < 1e-12, "{}", judged.residuals.rms);
        assert!(judged.warnings[0].starts_with("the residuals are not noise"), "{:?}", judged.warnings);
        assert!(judged.table().contains("all parameters are held: nothing was fitted"));
        assert_eq!(judged.values(), [("mu_k".to_owned(), 0.32)]);
        // The same values beside a fit, which finds the right ones; what they do not name has its start value.
        let best = fitted("Coulomb", &data, &quick());
        let beside = evaluate(&best, &[("mu_k".to_owned(), 0.32)].into(), &data, &quick()).unwrap();
        assert_eq!(beside.residuals.rms, judged.residuals.rms);
        assert!(best.residuals.rms < 1e-6 * judged.residuals.rms);
        let unnamed = evaluate(&best, &Reference::new(), &data, &quick()).unwrap();
        assert!((unnamed.residuals.rms / judged.residuals.rms / 10.0 - 1.0).abs() < 1e-12);
    }

    /// The steps of a law that yields are divided until they are fine enough: the values that made the data explain them.
    #[test]
    fn the_values_that_made_a_record_explain_it_among_several_laws() {
        let data = [measured("LuGre", &[("sigma_0", 5e4)], &standard(400), 0.01, 3)];
        let names = ["mu_k", "mu_s", "sigma_1", "stribeck_velocity", "viscous_coefficient"];
        let law = by_name("LuGre").unwrap();
        let start = |name: &str| (name.to_owned(), law.table.at(law.find(name).unwrap()).start);
        let fixed = names.into_iter().map(start).chain([("sigma_0".to_owned(), 5e4)]).collect();
        let task = Settings { selection: Selection { fixed, ..Selection::default() }, ..quick() };
        let laws = ["LuGre", "Coulomb"].map(|name| by_name(name).unwrap());
        let ranking = fit_all(&laws, &data, &task, &mut |_| (), quiet()).unwrap();
        let [best, other] = [0, 1].map(|place: usize| &ranking.fits[ranking.ranks[place].fit]);
        assert_eq!([best.law.name, other.law.name], ["LuGre", "Coulomb"]);
        assert!((best.residuals.rms / (0.01 * best.level) - 1.0).abs() < 0.1, "{}", best.residuals.rms);
        assert!(best.warnings.is_empty() && !other.warnings.is_empty());
    }
}
