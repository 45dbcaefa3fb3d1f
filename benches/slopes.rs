//! Cost of a step with moving inputs, in steps with held inputs of the same model from the same state.
//!
//! All models, each with slopes of the velocities alone, of all other inputs alone, and of all inputs, from a thousand
//! random states. Absolute times on a shared machine wander; the two times of a state are taken right after each other.
//! The median over the states is reported, and the worst of the medians of a hundred states each.

#[path = "../tests/common/random.rs"]
mod random;

use cpu_time::ThreadTime;
use random::Random;
use stribeck::catalogue;
use stribeck::model::{Kind, ModelType, Role};

const STATES: usize = 1000;
/// Steps per measurement, so that the clock's own time does not count.
const REPEATS: usize = 32;
const STEP: f64 = 1e-3;
/// Time in which an input crosses its range.
const RANGE_TIME: f64 = 0.1;

fn main() {
    println!("a step of 1 ms with slopes, in steps with held inputs: median over {STATES} states [worst hundredth]\n");
    println!("{:20} {:>10} {:>20} {:>20} {:>20}", "model", "held, ns", "velocity", "other inputs", "all inputs");
    let mut all = Vec::new();
    for model in catalogue::models() {
        let inputs = inputs(model);
        if inputs.is_empty() {
            continue;
        }
        let is_velocity = |column: &usize| model.table.at(*column).path.segments()[0].name.starts_with("velocity");
        let mixtures: [Vec<usize>; 3] = [
            inputs.iter().copied().filter(is_velocity).collect(),
            inputs.iter().copied().filter(|column| !is_velocity(column)).collect(),
            inputs.clone(),
        ];
        let mut held = 0.0;
        let cells = mixtures.map(|sloped| {
            if sloped.is_empty() {
                return "-".to_owned();
            }
            let (mut ratios, time) = measure(model, &inputs, &sloped);
            held = time;
            all.push((quantile(&mut ratios, 0.5), model.name));
            format!("{:.1} [{:.0}]", quantile(&mut ratios, 0.5), quantile(&mut ratios, 0.99))
        });
        println!("{:20} {held:10.0} {:>20} {:>20} {:>20}", model.name, cells[0], cells[1], cells[2]);
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (median, most) = (all[all.len() / 2], all[all.len() - 1]);
    println!("\nmedian of the medians {:.1}, largest {:.1} ({})", median.0, most.0, most.1);
}

fn inputs(model: &ModelType) -> Vec<usize> {
    let is_moving = |column: &usize| {
        model.table.at(*column).role == Role::Input && matches!(model.table.at(*column).kind, Kind::Real(_))
    };
    (0..model.table.len()).filter(is_moving).collect()
}

/// Usual range of an input.
fn range(model: &ModelType, column: usize) -> f64 {
    let Kind::Real(unit) = model.table.at(column).kind else { return 0.0 };
    match unit.name {
        "m" => 5e-3,
        "m/s" => 0.2,
        "m/s2" => 5.0,
        "N" => 20.0,
        "K" => 5.0,
        "W" => 100.0,
        _ => 0.5,
    }
}

fn quantile(values: &mut [f64], share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values[((values.len() - 1) as f64 * share) as usize]
}

/// Ratios over the states, and the median time of a held step in nanoseconds.
fn measure(model: &ModelType, inputs: &[usize], sloped: &[usize]) -> (Vec<f64>, f64) {
    let mut random = Random(5);
    let mut row: Vec<f64> = model.table.iter().map(|variable| variable.start).collect();
    let (mut ratios, mut times) = (Vec::new(), Vec::new());
    while ratios.len() < STATES {
        let mut slope = vec![0.0; row.len()];
        for column in inputs {
            let (variable, range) = (&model.table.at(*column), range(model, *column));
            // Speeds of all sizes, at rest too.
            let size = if variable.path.segments()[0].name.starts_with("velocity") {
                range * 10f64.powf(-4.0 * random.next())
            } else {
                range
            };
            row[*column] = variable.bound.nearest(variable.start + size * random.signed());
            if sloped.contains(column) {
                let rate = range / RANGE_TIME * random.signed();
                slope[*column] = if variable.admits(row[*column] + rate * STEP) { rate } else { 0.0 };
            }
        }
        let held = time(&row, |row| model.advance(row, STEP));
        let ramped = time(&row, |row| model.advance_ramp(row, &slope, STEP));
        if let (Some(held), Some(ramped)) = (held, ramped) {
            ratios.push(ramped / held);
            times.push(held);
        }
        // On to another state.
        model.advance(&mut row, STEP * random.next());
    }
    let held = quantile(&mut times, 0.5);
    (ratios, held)
}

/// Nanoseconds of a step from that row; `None` if it is refused.
fn time(row: &[f64], step: impl Fn(&mut [f64]) -> bool) -> Option<f64> {
    let mut rows = vec![row.to_vec(); REPEATS];
    let begin = ThreadTime::now();
    let taken = rows.iter_mut().all(|row| step(row));
    let elapsed = begin.elapsed().as_secs_f64();
    taken.then(|| elapsed * 1e9 / REPEATS as f64)
}
