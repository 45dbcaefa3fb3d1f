//! How alike two motions of one system are: when contacts slip and rest, how often, with what forces and how far.

use serde::Serialize;
use stribeck::model::{Meaning, Role};

use super::{Column, Outcome};
use crate::system::{Fault, Place, System, WireSource};

/// Part of the speed up to which a contact rests at which it comes to rest (chosen): noise then ends no rest.
const ENTRY: f64 = 0.5;

/// Least size of a result, in parts of its nominal value, in which a difference is expressed (chosen).
const LEAST: f64 = 1e-6;

/// A quantity of a motion beside that of the solution.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Deviation {
    /// What it is, such as `period of friction`.
    pub name: String,
    /// Unit of the quantity.
    pub unit: String,
    /// The quantity in the motion.
    pub value: f64,
    /// The quantity in the solution.
    pub solution: f64,
    /// The difference without sign: of a time in parts of the interval, of a force, velocity or position in parts of
    /// the largest size or of the range, whichever is less, of a number as it is.
    pub part: f64,
}

/// The results by which motions are compared.
pub struct Compared {
    /// Parts with a contact, and the number of the result that is its sliding velocity.
    contacts: Vec<(String, usize)>,
    /// Results whose largest and smallest values are compared, with the least size of each.
    extremes: Vec<(usize, f64)>,
    /// Names of the results to record.
    pub results: Vec<String>,
}

impl Deviation {
    /// What is off, in words.
    pub fn sentence(&self) -> String {
        let Deviation { name, unit, value, solution, .. } = self;
        let unit = if unit == "1" { String::new() } else { format!(" {unit}") };
        format!("{name} is {}{unit} instead of {}{unit}", short(*value), short(*solution))
    }
}

/// A number with four digits behind the point, or with an exponent if these would be few.
fn short(value: f64) -> String {
    let size = value.abs();
    match size {
        _ if value == value.round() && size < 1e6 => value.to_string(),
        0.01..1e6 => format!("{value:.4}"),
        _ => format!("{value:.3e}"),
    }
}

impl Compared {
    /// The sliding velocities and friction forces of all contacts, by the meaning that their models declare, and those
    /// of the results that are lengths, velocities or forces.
    pub fn of(system: &System, results: &[String]) -> Result<Compared, Fault> {
        let mut compared = Compared { contacts: Vec::new(), extremes: Vec::new(), results: Vec::new() };
        for (number, part) in system.parts.iter().enumerate() {
            let of = |meaning| part.model.table.of(meaning).map(|column| Place { part: number, column });
            let velocity = of(Meaning::Velocity).filter(|place| system.variable(*place).role == Role::Input);
            let Some(velocity) = velocity else { continue };
            let velocity = compared.add(system, origin(system, WireSource::Variable(velocity)));
            compared.contacts.push((part.name.clone(), velocity));
            if let Some(force) = of(Meaning::FrictionForce) {
                compared.add(system, WireSource::Variable(force));
            }
        }
        for name in results {
            let source = system.source(name)?;
            if ["m", "rad", "m/s", "rad/s", "N", "N.m"].contains(&system.unit(source).name.as_str()) {
                compared.add(system, origin(system, source));
            }
        }
        if compared.results.is_empty() {
            return Err(Fault::value("step = find: the system has no contact, and no result to compare"));
        }
        Ok(compared)
    }

    /// Adds a result unless it is there; returns its number.
    fn add(&mut self, system: &System, source: WireSource) -> usize {
        let (name, nominal) = match source {
            WireSource::Variable(place) => (system.name(place), system.variable(place).nominal),
            WireSource::Derivative(place) => (format!("der({})", system.name(place)), 1.0),
        };
        if let Some(known) = self.results.iter().position(|known| *known == name) {
            return known;
        }
        self.results.push(name);
        self.extremes.push((self.results.len() - 1, LEAST * nominal));
        self.results.len() - 1
    }

    /// The quantities of a motion that has come to its end beside those of the solution. A contact rests up to the part
    /// `within` of its largest speed; what happens in this part of the run before its end may be missing in one of the
    /// two.
    pub fn deviations(&self, motion: &Outcome, solution: &Outcome, within: f64) -> Vec<Deviation> {
        let mut all = Vec::new();
        let until = (1.0 - within) * solution.time.last().copied().unwrap_or(0.0);
        for (contact, result) in &self.contacts {
            let largest = largest_size(&solution.columns[*result].values);
            let [ours, theirs] =
                [motion, solution].map(|one| Episodes::of(&one.time, &one.columns[*result].values, within * largest));
            all.extend(times(&ours, &theirs, contact, until));
            if let (Some(value), Some(solution)) = (ours.rest_speed, theirs.rest_speed) {
                let name = format!("velocity at rest of {contact}");
                let part = (value - solution).abs() / largest;
                all.push(Deviation { name, unit: "m/s".to_owned(), value, solution, part });
            }
        }
        for (result, least) in &self.extremes {
            all.extend(extremes(&motion.columns[*result], &solution.columns[*result], *least));
        }
        all
    }
}

/// Where the value of a connected input comes from: what is there is of the present time in every order of exchange.
fn origin(system: &System, source: WireSource) -> WireSource {
    let wire = system.wires.iter().find(|wire| WireSource::Variable(wire.to) == source);
    wire.map_or(source, |wire| wire.from)
}

fn largest_size(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, value| value.abs().max(largest))
}

fn ends(values: &[f64]) -> [f64; 2] {
    values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(*value), high.max(*value)])
}

/// The largest size of a force; the largest and the smallest value of what has a direction. A force that brings a body
/// to rest within its last step may point the other way, for this step.
fn extremes(ours: &Column, theirs: &Column, least: f64) -> Vec<Deviation> {
    let ([low, high], [their_low, their_high]) = (ends(&ours.values), ends(&theirs.values));
    let [largest, their_largest] = [ours, theirs].map(|column| largest_size(&column.values));
    let size = their_largest.min(their_high - their_low).max(least);
    let deviation = |which: &str, value: f64, solution: f64| Deviation {
        name: format!("{which} {}", theirs.name),
        unit: theirs.unit.clone(),
        value,
        solution,
        part: (value - solution).abs() / size,
    };
    if theirs.unit.starts_with('N') {
        return vec![deviation("largest", largest, their_largest)];
    }
    vec![deviation("largest", high, their_high), deviation("smallest", low, their_low)]
}

/// When a contact slips and rests.
#[derive(Debug, Default, PartialEq)]
struct Episodes {
    /// Times at which it begins to slip, in s.
    slips: Vec<f64>,
    /// Times at which it comes to rest, in s.
    rests: Vec<f64>,
    /// Mean speed while it rests, in m/s; none if it never does.
    rest_speed: Option<f64>,
}

impl Episodes {
    /// A contact slips from a speed of `band` on, and rests again below half of it. Between two results the velocity
    /// moves along a straight line.
    fn of(times: &[f64], velocities: &[f64], band: f64) -> Episodes {
        let mut found = Episodes::default();
        let (mut way, mut duration) = (0.0, 0.0);
        let mut rests = velocities.first().is_some_and(|first| first.abs() <= band);
        for (time, velocity) in times.windows(2).zip(velocities.windows(2)) {
            let (span, change) = (time[1] - time[0], velocity[1] - velocity[0]);
            let passes = |level: f64| time[0] + span * (level - velocity[0]) / change;
            if rests && velocity[1].abs() <= band {
                way += 0.5 * (velocity[0].abs() + velocity[1].abs()) * span;
                duration += span;
            }
            let entry = (ENTRY * band).copysign(velocity[0]);
            // It falls to this speed, or passes through it to the other side.
            if !rests && velocity[1] * entry.signum() <= entry.abs() {
                found.rests.push(passes(entry));
                rests = true;
            }
            if rests && velocity[1].abs() > band {
                found.slips.push(passes(band.copysign(velocity[1])));
                rests = false;
            }
        }
        found.rest_speed = (duration > 0.0).then(|| way / duration);
        found
    }
}

/// Times of one kind, slips or rests, in a motion and in the solution.
struct Times<'a> {
    what: &'static str,
    contact: &'a str,
    ours: &'a [f64],
    theirs: &'a [f64],
}

fn intervals(times: &[f64]) -> impl Iterator<Item = f64> {
    times.windows(2).map(|pair| pair[1] - pair[0])
}

impl Times<'_> {
    fn deviation(&self, name: &str, value: f64, solution: f64, size: f64) -> Deviation {
        let (name, unit) = (format!("{name} of {}", self.contact), "s".to_owned());
        Deviation { name, unit, value, solution, part: (value - solution).abs() / solution.max(size) }
    }

    /// The time of the first one.
    fn first(&self, usual: f64) -> Option<Deviation> {
        let (value, solution) = (*self.ours.first()?, *self.theirs.first()?);
        Some(self.deviation(&format!("first {}", self.what), value, solution, usual))
    }

    /// All intervals from one to the next.
    fn periods(&self, usual: f64) -> impl Iterator<Item = Deviation> {
        let both = intervals(self.ours).zip(intervals(self.theirs));
        both.map(move |(value, solution)| self.deviation("period", value, solution, usual))
    }

    /// How many there are, if one has more than the other before a time.
    fn number(&self, until: f64) -> Option<Deviation> {
        let (ours, theirs) = (self.ours.len(), self.theirs.len());
        let more = if ours > theirs { &self.ours[theirs..] } else { &self.theirs[ours..] };
        if !more.first().is_some_and(|time| *time < until) {
            return None;
        }
        let (name, unit) = (format!("number of {}s of {}", self.what, self.contact), "1".to_owned());
        let (value, solution) = (ours as f64, theirs as f64);
        Some(Deviation { name, unit, value, solution, part: (value - solution).abs() })
    }
}

/// The times of a contact beside those of the solution, of which those after `until` may be missing in one of the two:
/// how often it slips or rests if that differs, the first slip, the first rest, and the worst of all intervals.
fn times(ours: &Episodes, theirs: &Episodes, contact: &str, until: f64) -> Vec<Deviation> {
    let of = |what, ours, theirs| Times { what, contact, ours, theirs };
    let both = [of("slip", &ours.slips, &theirs.slips), of("rest", &ours.rests, &theirs.rests)];
    let mut all: Vec<f64> = intervals(&theirs.slips).chain(intervals(&theirs.rests)).collect();
    all.sort_by(f64::total_cmp);
    let usual = all.get(all.len() / 2).copied().unwrap_or(0.0);
    let numbers = both.iter().filter_map(|times| times.number(until));
    let firsts = both.iter().filter_map(|times| times.first(usual));
    let periods = both.iter().flat_map(|times| times.periods(usual));
    numbers.chain(firsts).chain(periods.max_by(|a, b| a.part.total_cmp(&b.part))).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use super::*;

    /// v = cos(2 pi t): it leaves the band of 0.2 at arccos(0.2) from each zero, and enters that of 0.1 before it.
    #[test]
    fn a_contact_rests_between_two_bands() {
        let time: Vec<f64> = (0..=20_000).map(|number| f64::from(number) * 1e-4).collect();
        let velocity: Vec<f64> = time.iter().map(|time| (TAU * time).cos()).collect();
        let found = Episodes::of(&time, &velocity, 0.2);
        let [entry, exit] = [0.1f64, -0.2].map(|level| level.acos() / TAU);
        for (number, (rest, slip)) in found.rests.iter().zip(&found.slips).enumerate() {
            let half = 0.5 * number as f64;
            assert!((rest - entry - half).abs() < 1e-6 && (slip - exit - half).abs() < 1e-6, "{found:?}");
        }
        assert_eq!([found.rests.len(), found.slips.len()], [4, 4]);
        // The mean of |v| = |sin| from -0.1 to 0.2; results at the ends of a rest count as a whole or not at all.
        let (from, to) = (0.1f64.asin(), 0.2f64.asin());
        let mean = (2.0 - from.cos() - to.cos()) / (from + to);
        assert!((found.rest_speed.unwrap() / mean - 1.0).abs() < 0.01, "{found:?} {mean}");
        // Two results on both sides of the band, and a body that never moves.
        let passed = Episodes::of(&[0.0, 1.0], &[-1.0, 1.0], 0.2);
        assert_eq!((passed.rests, passed.slips, passed.rest_speed), (vec![0.45], vec![0.6], None));
        assert_eq!(Episodes::of(&[0.0, 1.0], &[0.0, 0.0], 0.0).rest_speed, Some(0.0));
    }

    /// The strut takes its velocity from the car, and an acceleration is not compared.
    #[test]
    fn results_are_found_by_meaning_and_unit() {
        let source = crate::system::Source::open("quarter-car").unwrap();
        let system = System::assemble(&source, Some("LuGre"), &[]).unwrap();
        let shown: Vec<String> = source.description.show.values().cloned().collect();
        assert!(shown.iter().any(|name| name == "strut.velocity") && shown.iter().any(|name| name.starts_with("der(")));
        let mut results = Compared::of(&system, &shown).unwrap().results;
        results.sort();
        assert_eq!(results, ["car.body_height", "car.length", "car.velocity", "strut.force_friction"]);
    }

    fn slipping(slips: &[f64]) -> Episodes {
        Episodes { slips: slips.to_vec(), rests: Vec::new(), rest_speed: None }
    }

    fn worst(ours: &[f64], theirs: &[f64]) -> (String, f64) {
        let all = times(&slipping(ours), &slipping(theirs), "a", 19.8);
        let worst = all.into_iter().max_by(|a, b| a.part.total_cmp(&b.part)).unwrap();
        (worst.name, worst.part)
    }

    /// The defect of a comparison by the last period: the first slip comes two seconds early.
    #[test]
    fn the_whole_motion_counts_and_not_the_last_period() {
        let solution = [7.36, 11.96, 16.56];
        let (name, part) = worst(&[5.36, 9.96, 14.56], &solution);
        assert!(name == "first slip of a" && (part - 2.0 / 7.36).abs() < 1e-12, "{name} {part}");
        let (name, part) = worst(&[7.36, 12.88, 17.48], &solution);
        assert!(name == "period of a" && (part - 0.2).abs() < 1e-9, "{name} {part}");
        assert_eq!(worst(&[7.36, 11.96], &solution), ("number of slips of a".to_owned(), 1.0));
        assert_eq!(worst(&[7.36, 11.96, 16.56, 19.9], &solution).1, 0.0, "the run ends before the other slips");
    }

    #[test]
    fn a_force_is_compared_by_its_size_and_a_position_by_its_range() {
        let column = |unit: &str, values: &[f64]| Column { name: "x".into(), unit: unit.into(), values: values.into() };
        let parts = |unit: &str, ours: &[f64], theirs: &[f64]| {
            let all = extremes(&column(unit, ours), &column(unit, theirs), 1e-6);
            all.into_iter().map(|one| one.part).collect::<Vec<f64>>()
        };
        assert_eq!(parts("N", &[0.5, -2.5], &[0.0, -2.0]), [0.25]);
        assert_eq!(parts("m", &[10.0, 12.0], &[10.0, 11.0]), [1.0, 0.0]);
        assert_eq!(parts("m", &[0.0, PI], &[0.0, 0.0])[0], PI / 1e-6);
        assert_eq!([2.0, 0.25, 1234.5, 2e-5].map(short), ["2", "0.2500", "1234.5000", "2.000e-5"]);
    }
}
