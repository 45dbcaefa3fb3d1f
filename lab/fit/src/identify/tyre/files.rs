//! A tyre test of several files, and what each of them has.

use super::columns::{PURE, Sample, TyreTest};
use super::left_out::{by_temperature, without_load_sweeps};
use super::pressure::in_words;

/// Joins the tests of files, each with its name.
pub(super) fn joined(tests: Vec<(String, TyreTest)>) -> TyreTest {
    let mut all = TyreTest::default();
    let is_alone = tests.len() == 1;
    for (file, (name, test)) in tests.into_iter().enumerate() {
        let test = without_load_sweeps(test);
        let named = |note: String| if is_alone { note } else { format!("{name}: {note}") };
        all.notes.extend(test.notes.into_iter().map(named));
        all.notes.push(format!("{name}: {}", contents(&test.samples)));
        all.notes.extend(by_temperature(&test.samples).into_iter().map(|note| format!("{name}, {note}")));
        all.files.push(name);
        all.samples.extend(test.samples.into_iter().map(|one| Sample { file, ..one }));
    }
    all
}

/// Numbers of samples of each kind of slip, what is fitted to them, and their pressures, in words.
fn contents(samples: &[Sample]) -> String {
    let count = |is_one: &dyn Fn(&Sample) -> bool| samples.iter().filter(|one| is_one(one)).count();
    let kinds = [
        (count(&|one| one.is_rolling()), "with side slip alone"),
        (count(&|one| one.is_straight() && !one.is_rolling()), "with longitudinal slip alone"),
        (count(&|one| !one.is_straight() && !one.is_rolling()), "with both"),
    ];
    let kinds = kinds.iter().map(|(count, kind)| format!("{count} {kind}")).collect::<Vec<_>>().join(", ");
    let measured = [
        ("F_x", count(&|one| one.force_x.is_some())),
        ("F_y", count(&|one| one.force_y.is_some())),
        ("M_z", count(&|one| one.moment_z.is_some())),
    ];
    let measured = measured.iter().filter(|(_, count)| *count > 0).map(|(name, _)| *name).collect::<Vec<_>>();
    let pressures = in_words(samples).map_or(String::new(), |levels| format!("; at {levels}"));
    let slip = format!("slips up to {PURE} count as 0");
    format!("{} samples, {kinds} ({slip}); fitted: {}{pressures}", samples.len(), measured.join(", "))
}
