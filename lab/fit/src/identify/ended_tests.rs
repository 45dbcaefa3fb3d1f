//! Fits that are ended early.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use stribeck::catalogue::by_name;

use super::tests::{SLIDER, measured, quick, standard};
use super::*;

#[test]
fn a_search_that_is_ended_keeps_its_best() {
    let data = [measured("LuGre", &SLIDER, &standard(500), 0.01, 2)];
    let (stop, best) = (AtomicBool::new(false), Mutex::new(f64::INFINITY));
    let progress = |rms: f64, _| {
        let mut best = best.lock().unwrap();
        *best = best.min(rms);
        stop.store(true, Ordering::Relaxed);
    };
    let watch = Watch { cancel: &stop, progress: &progress };
    let fit = fit(by_name("LuGre").unwrap(), &data, &Settings::default(), watch).unwrap();
    assert!(fit.is_cancelled && fit.residuals.rms.is_finite() && best.lock().unwrap().is_finite());
    assert!(fit.estimates.iter().all(|one| one.profile.is_none() && one.repeated.is_none()));
    assert!(fit.searches == Searches::Ended && !fit.values().is_empty(), "{:?}", fit.estimates);
    let text = fit.table();
    assert!(text.contains(EARLY) && text.contains("the best so far") && !text.contains("95 %"), "{text}");
}

/// Those that were searched are ranked, whatever their place in the catalogue; the others are named.
#[test]
fn a_ranking_that_is_ended_keeps_what_it_has_found() {
    let data = [measured("Dahl", &[], &standard(300), 0.01, 1)];
    let laws = laws_named(&["Coulomb", "Stribeck", "Dahl", "LuGre", "Leuven", "Armstrong"].map(str::to_owned)).unwrap();
    let stop = AtomicBool::new(false);
    let mut begun = Vec::new();
    let mut begin = |law: &'static ModelType| {
        begun.push(law.name);
        stop.fetch_or(begun.len() == 4, Ordering::Relaxed);
    };
    let watch = Watch { cancel: &stop, progress: &|_, _| {} };
    let ranking = fit_all(&laws, &data, &quick(), &mut begin, watch).unwrap();
    let fitted: Vec<&str> = ranking.fits.iter().map(|fit| fit.law.name).collect();
    assert_eq!(fitted, ["Coulomb", "Stribeck", "Dahl", "LuGre"]);
    assert_eq!(ranking.refused.iter().map(|(law, _)| *law).collect::<Vec<_>>(), ["Leuven", "Armstrong"]);
    assert!(ranking.refused.iter().all(|(_, reason)| reason.contains("not reached")), "{:?}", ranking.refused);
    assert_eq!(ranking.best().law.name, "Dahl");
    assert!(ranking.best().is_cancelled && ranking.fits[0].searches == Searches::One);
}

/// Its values are those of an undisturbed fit; what was repeated before the end does not make an interval.
#[test]
fn a_fit_that_is_ended_while_it_is_repeated_says_so() {
    const REPETITIONS: usize = 8;
    let data = [measured("Dahl", &[], &standard(300), 0.01, 1)];
    let task = Settings { budget: 200, repetitions: REPETITIONS, ..quick() };
    let calls = Mutex::new(0);
    let run = |last: usize| {
        let stop = AtomicBool::new(false);
        *calls.lock().unwrap() = 0;
        let progress = |_, _| {
            let mut calls = calls.lock().unwrap();
            *calls += 1;
            stop.store(*calls >= last, Ordering::Relaxed);
        };
        fit(by_name("Dahl").unwrap(), &data, &task, Watch { cancel: &stop, progress: &progress }).unwrap()
    };
    let whole = run(usize::MAX);
    let count = *calls.lock().unwrap();
    let ended = run(count - REPETITIONS / 2);
    assert_eq!(*calls.lock().unwrap(), count - REPETITIONS / 2);
    assert!(!whole.is_cancelled && ended.is_cancelled);
    for (whole, ended) in whole.estimates.iter().zip(&ended.estimates) {
        assert_eq!(whole.value.to_bits(), ended.value.to_bits());
        assert!(whole.repeated.is_some() && ended.repeated.is_none() && ended.profile.is_none());
    }
}
