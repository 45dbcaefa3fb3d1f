//! Measurements as one CSV table.

use super::{Measurement, Trial};

/// All measurements.
pub fn csv(measurements: &[Measurement]) -> String {
    let mut text = String::from(
        "law,solver,tolerance,events located,steps,rejected,evaluations,jacobians,events,time [s],error [m],switching \
         error [s],verdict,end\n",
    );
    measurements.iter().for_each(|one| text += &row(one));
    text
}

fn row(one: &Measurement) -> String {
    let Measurement { law, trial: Trial { solver, tolerance, events: located }, time, .. } = one;
    let [steps, rejected, evaluations, jacobians, events] = one.counts;
    let number = |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:e}"));
    format!(
        "{law},{solver},{tolerance:e},{located},{steps},{rejected},{evaluations},{jacobians},{events},{:.6},{},{},{},\
         \"{}\"\n",
        time.as_secs_f64(),
        number(one.error),
        number(one.switching),
        one.verdict(),
        one.reason().replace('"', "'"),
    )
}
