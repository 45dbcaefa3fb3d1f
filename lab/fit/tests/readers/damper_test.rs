//! Files of damper tests, and the dampers found in them.

use stribeck_fit::dyno::{Damper, MOST_POINTS, Options, Test, find_damper};

/// Maximum number of samples; more make the search slow.
const MOST_SAMPLES: usize = 256;

pub fn read(bytes: &[u8]) {
    // As `Test::load` does.
    let Ok(test) = Test::parse(&String::from_utf8_lossy(bytes)) else { return };
    let columns = [Some(&test.force), test.displacement.as_ref(), test.temperature.as_ref()];
    for column in columns.into_iter().flatten().chain([&test.velocity]) {
        assert_eq!(column.len(), test.velocity.len());
        assert!(column.iter().all(|value| value.is_finite()), "{column:?}");
    }
    if test.velocity.len() > MOST_SAMPLES {
        return;
    }
    let usual = Options::default();
    let other = Options { compression_positive: true, points: Some(3), low_speed: 0.3, gas_force: Some(90.0), ..usual };
    for options in [usual, other] {
        if let Ok(damper) = find_damper(&test, &options) {
            check(&damper, &options);
        }
    }
}

fn check(damper: &Damper, options: &Options) {
    assert!((2..=options.points.unwrap_or(MOST_POINTS)).contains(&damper.table.len()), "{damper:?}");
    assert!(damper.table.windows(2).all(|pair| pair[0].0 < pair[1].0 && pair[0].1 <= pair[1].1), "{damper:?}");
    let friction = damper.friction.map(|friction| friction.level);
    let estimates = [friction, damper.gas_force, damper.gradient].into_iter().flatten();
    let numbers = estimates.flat_map(|estimate| [estimate.value, estimate.deviation]);
    let numbers = numbers.chain(damper.table.iter().flat_map(|point| [point.0, point.1]));
    let numbers = numbers.chain([damper.rms_error, damper.max_error]);
    assert!(numbers.clone().all(f64::is_finite), "{damper:?}");
    if let Ok(set) = damper.parameter_set("damper") {
        assert!(set.values().all(|(variable, value)| variable.admits(value)));
    }
}
