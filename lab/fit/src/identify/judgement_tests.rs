//! Tests of values that are judged.

use std::path::{Path, PathBuf};

use super::judgement::Given;
use super::tests::quiet;
use super::{Answer, Data, Fault, Files, Inquiry, Ranking, Selection};

const LOAD: f64 = 20.0;

/// A record of Coulomb friction with coefficient 0.3 and noise of 0.01 N, and a file of values for a law.
fn files(folder: &Path, law: &str, mu_k: f64) -> (PathBuf, String) {
    let velocity = |at: usize| if (at / 50).is_multiple_of(2) { 0.1 } else { -0.2 };
    let noise = [0.01, -0.01, -0.01, 0.01];
    let row = |at: usize| {
        let v: f64 = velocity(at);
        format!("{},{v},{}\n", at as f64 * 1e-3, 0.3 * LOAD * v.signum() + noise[at % 4])
    };
    let record = folder.join("record.csv");
    std::fs::write(&record, "time,velocity,force\n".to_owned() + &(0..400).map(row).collect::<String>()).unwrap();
    let given = folder.join("given.toml");
    std::fs::write(&given, format!("law = [\"{law}\"]\nset = {{ mu_k = {mu_k} }}\n")).unwrap();
    (record, given.display().to_string())
}

fn asked(record: &Path, laws: &[&str]) -> Inquiry {
    Inquiry {
        records: vec![record.to_owned()],
        law: laws.iter().map(|law| (*law).to_owned()).collect(),
        normal_force: Some(LOAD),
        repetitions: Some(0),
        ..Inquiry::default()
    }
}

fn ranking(asked: &Inquiry) -> Result<(Ranking, Data), Fault> {
    let data = asked.data(&Files)?;
    Ok((asked.fits(&data, &mut |_| {}, quiet())?, data))
}

/// A coefficient that is 0.02 too large leaves 0.02 of the load; the right one leaves the noise.
#[test]
fn values_are_judged_alone_without_a_fit() {
    let folder = tempfile::tempdir().unwrap();
    for (mu_k, rms) in [(0.32, 0.02 * LOAD), (0.3, 0.01)] {
        let (record, given) = files(folder.path(), "Coulomb", mu_k);
        let inquiry = Inquiry { evaluate: Some(given.clone()), ..asked(&record, &["Coulomb"]) };
        let (found, data) = ranking(&inquiry).unwrap();
        let judged = found.best().judgement.clone().unwrap();
        assert!((judged.rms / rms - 1.0).abs() < 0.02, "{judged:?}");
        assert_eq!((judged.fit_rms, judged.source, judged.values["mu_k"]), (None, given, mu_k));
        let expected =
            if mu_k == 0.3 { "the values explain the data" } else { "the values are not confirmed: see the warnings" };
        assert_eq!(judged.verdict, expected, "{:?}", judged.warnings);
        assert!(found.best().estimates.is_empty() && found.best().reference().is_none());
        let answer = Answer::of(&found, &data);
        assert_eq!(answer.laws[0].judgement.as_ref().unwrap().rms, judged.rms);
        // As if each parameter were held.
        let fix = vec![stribeck_solve::job::Entry("mu_k".to_owned(), mu_k)];
        let held = ranking(&Inquiry { fix, ..asked(&record, &["Coulomb"]) }).unwrap().0;
        let held = held.best().judgement.as_ref().unwrap();
        assert_eq!((held.rms, held.source.as_str()), (judged.rms, "fix"));
    }
}

#[test]
fn values_are_judged_beside_the_fit_of_the_same_law() {
    let folder = tempfile::tempdir().unwrap();
    let (record, given) = files(folder.path(), "Coulomb", 0.32);
    let reference = Some(given.clone());
    let (found, _) =
        ranking(&Inquiry { reference: reference.clone(), ..asked(&record, &["CoulombViscous", "Coulomb"]) }).unwrap();
    let of = |law: &str| found.fits.iter().find(|fit| fit.law.name == law).unwrap();
    let judged = of("Coulomb").judgement.as_ref().unwrap();
    assert!((judged.rms / (0.02 * LOAD) - 1.0).abs() < 0.02, "{judged:?}");
    assert_eq!(judged.fit_rms, Some(of("Coulomb").residuals.rms));
    let [outside] = &judged.outside[..] else { panic!("{judged:?}") };
    assert!(outside.name == "mu_k" && outside.interval[0] < 0.3 && 0.3 < outside.interval[1], "{outside:?}");
    assert_eq!((judged.verdict.as_str(), &judged.note), ("the values contradict the fit", &None));
    assert!(judged.lines("N")[1].starts_with("mu_k = 0.3200 is outside the interval of the fit, 0."));
    // Of another law it is compared with the best one only, and that is said.
    let other = found.best().law.name == "CoulombViscous";
    assert_eq!(of("CoulombViscous").judgement.as_ref().is_some_and(|one| one.note.is_some()), other);
    let (right, given) = files(folder.path(), "Coulomb", 0.3);
    let (found, _) = ranking(&Inquiry { reference: Some(given), ..asked(&right, &["Coulomb"]) }).unwrap();
    let judged = found.best().judgement.as_ref().unwrap();
    assert_eq!((judged.verdict.as_str(), judged.outside.len()), ("the values explain the data", 0));
    assert_eq!(found.best().reference(), Some(&[("mu_k".to_owned(), 0.3)].into()));
}

#[test]
fn what_cannot_be_judged_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let (record, given) = files(folder.path(), "Dahl", 0.3);
    let told = |inquiry: Inquiry| ranking(&inquiry).unwrap_err().to_string().replace(&given, "given.toml");
    let evaluate = |text: &str| Inquiry { evaluate: Some(text.to_owned()), ..asked(&record, &["Coulomb"]) };
    let other = "given.toml: is a set of Dahl, not of Coulomb";
    assert_eq!(told(evaluate(&given)), other);
    assert_eq!(told(evaluate("rigg")), "Coulomb: preset 'rigg' does not exist");
    let fit = Inquiry { fit: vec!["offset".to_owned()], ..evaluate(&given) };
    assert_eq!(told(fit), "evaluate: nothing is fitted, which fit contradicts");
    // Of an axis mass and offset are known from the file, or held.
    let law = stribeck::catalogue::by_name("Coulomb").unwrap();
    let selection = Selection { fitted: vec!["mass".to_owned()], ..Selection::default() };
    let fixed = |text: &str| {
        std::fs::write(&given, text).unwrap();
        Given(&given).fixed(law, &Given(&given).values(&[law]).unwrap()[0].clone().unwrap(), &selection)
    };
    let wanted = "evaluate: mass is not known: --fix mass=VALUE gives it";
    assert_eq!(fixed("set = { mu_k = 0.3 }").unwrap_err().to_string(), wanted);
    let known = fixed("set = { mu_k = 0.3, \"axis.mass\" = 2.0 }").unwrap();
    assert!(known.contains(&("mass".to_owned(), 2.0)) && known.contains(&("mu_k".to_owned(), 0.3)), "{known:?}");
}
