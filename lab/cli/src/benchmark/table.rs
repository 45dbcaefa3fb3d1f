//! Measurements as one CSV table.

use super::Measurement;

/// All measurements.
pub fn csv(measurements: &[Measurement]) -> String {
    let mut text = String::from(
        "law,solver,tolerance,events located,steps,rejected,evaluations,jacobians,events,time [s],error [m],switching \
         error [s],verdict,end\n",
    );
    for one in measurements {
        let [steps, rejected, evaluations, jacobians, events] = one.counts;
        let number = |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:e}"));
        text += &format!(
            "{},{},{:e},{},{steps},{rejected},{evaluations},{jacobians},{events},{:.6},{},{},{},\"{}\"\n",
            one.law,
            one.trial.solver,
            one.trial.tolerance,
            one.trial.events,
            one.time.as_secs_f64(),
            number(one.error),
            number(one.switching),
            one.verdict(),
            one.reason().replace('"', "'"),
        );
    }
    text
}
