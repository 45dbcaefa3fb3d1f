//! Detects a host that steps a model more often than time passes.
//!
//! Some integrators ask for a force many times in each of their steps. A host that answers each time with a step of the
//! model advances its states many times too far, and nothing shows it but a length that does not follow from the
//! velocity. Where a model has both as inputs, the distances that they travel are compared.

use crate::model::{Fault, Kind, ModelType, Role};

/// Least number of steps that a motion in one direction takes to count (chosen). The velocity of some integrators
/// oscillates from step to step; that does not count.
const STEPS: u32 = 32;

/// Distance travelled by the velocity from which on it is compared, relative to the largest length (chosen).
const SIGNIFICANT: f64 = 0.05;

/// Range of the distance travelled by the length over that travelled by the velocity which gives a warning (chosen).
/// Below it the length is not given at all; a velocity in mm/s has 0.001. A motion sampled only twice per period has
/// 2 / pi.
const WRONG: [f64; 2] = [1e-5, 0.5];

/// Share of the distance travelled against the velocity that gives a warning (chosen).
const BACKWARDS: f64 = 0.5;

/// A motion in one direction.
#[derive(Clone, Copy, Default)]
struct Stroke {
    begin: f64,
    end: f64,
    by_velocity: f64,
    steps: u32,
}

/// Compares length and velocity of a model.
pub(crate) struct Consistency {
    length: usize,
    velocity: usize,
    so_far: SoFar,
}

/// Distances travelled.
#[derive(Clone, Copy, Default)]
struct Travel {
    by_length: f64,
    by_velocity: f64,
    /// By the length, against the velocity.
    backwards: f64,
}

/// Observations of a run.
#[derive(Clone, Copy, Default)]
struct SoFar {
    stroke: Stroke,
    travel: Travel,
    largest: f64,
    /// Whether a state was restored, so that the steps no longer follow one another.
    is_given_up: bool,
}

/// Length at the beginning of a step, and the distance travelled by the velocity in it.
#[derive(Clone, Copy)]
pub(crate) struct Sample {
    length: f64,
    distance: f64,
}

impl Consistency {
    /// For a model whose inputs are a length and its time derivative.
    pub fn of(model: &ModelType) -> Option<Consistency> {
        let input = |name: &str| {
            let is_input = |column: &usize| {
                model.table.at(*column).role == Role::Input && matches!(model.table.at(*column).kind, Kind::Real(_))
            };
            model.find(name).filter(is_input)
        };
        let (length, velocity) = (input("length")?, input("velocity")?);
        Some(Consistency { length, velocity, so_far: SoFar::default() })
    }

    /// Begins a run.
    pub fn begin(&mut self) {
        self.so_far = SoFar::default();
    }

    /// Ends the comparison once a state is restored: such a host may repeat steps.
    pub fn give_up(&mut self) {
        self.so_far.is_given_up = true;
    }

    /// Warning to the host if length and velocity contradict each other.
    pub fn warning(&self) -> Option<Fault> {
        let Travel { by_length, by_velocity, backwards } = self.so_far.travel();
        if self.so_far.is_given_up || by_velocity <= SIGNIFICANT * self.so_far.largest {
            return None;
        }
        let ratio = by_length / by_velocity;
        if backwards > BACKWARDS * by_velocity {
            let text = "velocity has the sign opposite to the change of length in the steps so far: is it positive \
                        while the length grows?";
            Some(Fault::new(format_args!("{text}")))
        } else if WRONG[0] < ratio && ratio < WRONG[1] {
            Some(Fault::new(format_args!(
                "velocity has travelled {:.1} times as far as length in the steps so far: is each step made only once, \
                 and is velocity the time derivative of length?",
                1.0 / ratio
            )))
        } else {
            None
        }
    }

    /// The inputs at the beginning of a step of `dt`.
    #[inline]
    pub fn sample(&self, row: &[f64], dt: f64) -> Sample {
        Sample { length: row[self.length], distance: row[self.velocity] * dt }
    }

    /// Adds a step that was made.
    #[inline]
    pub fn observe(&mut self, sample: Sample) {
        self.so_far.add(sample.length, sample.distance);
    }
}

impl SoFar {
    fn add(&mut self, length: f64, distance: f64) {
        let moved = length - self.stroke.end;
        let turns = distance * self.stroke.by_velocity < 0.0;
        // Backwards by far more than a step: the host has set the length anew.
        let jumps = moved * self.stroke.by_velocity < 0.0 && moved.abs() > 4.0 * distance.abs();
        if self.stroke.steps == 0 || turns || jumps {
            self.close();
            self.stroke = Stroke { begin: length, end: length, by_velocity: 0.0, steps: 0 };
        }
        self.stroke.end = length;
        self.stroke.by_velocity += distance;
        self.stroke.steps = self.stroke.steps.saturating_add(1);
        self.largest = self.largest.max(length.abs());
    }

    /// Distances so far, the present stroke included.
    fn travel(&self) -> Travel {
        if self.stroke.steps < STEPS {
            return self.travel;
        }
        let along = (self.stroke.end - self.stroke.begin) * self.stroke.by_velocity.signum();
        Travel {
            by_length: self.travel.by_length + along.max(0.0),
            by_velocity: self.travel.by_velocity + self.stroke.by_velocity.abs(),
            backwards: self.travel.backwards - along.min(0.0),
        }
    }

    fn close(&mut self) {
        self.travel = self.travel();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue;
    use crate::instance::Instance;

    /// A strut in a host that sets length and velocity, and makes the step.
    struct Strut {
        instance: Instance,
        columns: [usize; 2],
        warnings: Vec<String>,
    }

    impl Strut {
        fn new() -> Strut {
            let model = catalogue::by_name("ShockAbsorber").expect("the strut");
            let columns = ["length", "velocity"].map(|name| model.find(name).expect(name));
            Strut { instance: Instance::new(model), columns, warnings: Vec::new() }
        }

        fn step(&mut self, length: f64, velocity: f64, dt: f64) {
            self.instance.set_column(self.columns[0], length).unwrap();
            self.instance.set_column(self.columns[1], velocity).unwrap();
            self.instance.step(dt).expect("a step");
            // More often than any interface asks.
            self.warnings.extend(self.instance.warning().map(|fault| fault.to_string()));
        }
    }

    const LENGTH: f64 = 0.1775;

    /// 20 mm at 1.3 Hz with a little of 11 Hz on it.
    fn motion(t: f64) -> (f64, f64) {
        let (slow, fast) = (8.168, 69.115);
        let length = LENGTH + 0.02 * f64::sin(slow * t) + 5e-4 * f64::sin(fast * t);
        (length, 0.02 * slow * f64::cos(slow * t) + 5e-4 * fast * f64::cos(fast * t))
    }

    /// Chrono's HHT evaluates 21 times in each step, while it looks for the velocity of the step's end.
    #[test]
    fn a_host_that_evaluates_often_is_warned() {
        for often in [3, 21] {
            let (mut strut, dt) = (Strut::new(), 1e-3);
            for k in 0..2000 {
                for evaluation in 0..often {
                    let (length, velocity) = motion(f64::from(k) * dt);
                    let trial = 1.0 + 1e-3 / f64::from(1 + evaluation);
                    strut.step(length + 1e-6 * trial, velocity * trial, dt);
                }
            }
            let last = strut.warnings.last().expect("a warning");
            let begin = format!("velocity has travelled {often}.");
            assert!(last.starts_with(&begin), "{last}");
        }
    }

    /// The warnings over four seconds of a host with the given step, and length and velocity over time.
    fn warnings(dt: f64, signal: impl Fn(f64) -> (f64, f64)) -> Vec<String> {
        let mut strut = Strut::new();
        for k in 0..4000 {
            let (length, velocity) = signal(f64::from(k) * dt);
            strut.step(length, velocity, dt);
        }
        strut.warnings
    }

    #[test]
    fn wrong_units_and_signs_are_noticed() {
        let in_millimetres = warnings(1e-3, |t| (motion(t).0, 1e3 * motion(t).1));
        assert!(in_millimetres.last().expect("a warning").contains(" times as far as length"), "{in_millimetres:?}");
        let reversed = warnings(1e-3, |t| (motion(t).0, -motion(t).1));
        assert!(reversed.last().expect("a warning").starts_with("velocity has the sign opposite"), "{reversed:?}");
    }

    /// A step that is refused, and made again in two halves, counts once.
    #[test]
    fn refused_steps_do_not_count() {
        let mut strut = Strut::new();
        for k in 0..2000 {
            let (length, velocity) = motion(f64::from(k) * 1e-3);
            for _ in 0..3 {
                strut.instance.set_slope(strut.columns[0], f64::MAX).unwrap();
                strut.instance.set_column(strut.columns[0], length).unwrap();
                strut.instance.set_column(strut.columns[1], velocity).unwrap();
                assert!(strut.instance.step(1e-3).is_err());
            }
            strut.instance.set_slope(strut.columns[0], velocity).unwrap();
            strut.step(length, velocity, 5e-4);
            strut.step(length + 5e-4 * velocity, velocity, 5e-4);
        }
        assert!(strut.warnings.is_empty(), "{:?}", strut.warnings.first());
    }

    #[test]
    fn honest_hosts_are_never_warned() {
        type Signal = fn(f64) -> (f64, f64);
        // Name and step of a host, and its length and velocity over time.
        let hosts: [(&str, f64, Signal); 10] = [
            ("sequential", 1e-3, motion),
            ("coarse", 5e-3, motion),
            ("parallel: the velocity is one step late", 5e-3, |t| (motion(t).0, motion(t - 5e-3).1)),
            ("parallel: the length is one step late", 5e-3, |t| (motion(t - 5e-3).0, motion(t).1)),
            ("held for ten steps", 1e-3, |t| motion((t * 100.0).floor() / 100.0)),
            ("no velocity", 1e-3, |t| (motion(t).0, 0.0)),
            ("no length", 1e-3, |t| (LENGTH, motion(t).1)),
            ("at rest, with noise", 1e-3, |t| (LENGTH + 1e-9 * (1e4 * t).sin(), 1e-4 * (1.7e4 * t).sin())),
            ("a velocity that rings", 1e-3, |t| {
                let sign = if (t * 1e3).round() as i64 % 2 == 0 { 1.0 } else { -1.0 };
                (LENGTH + 0.001 * t, 0.001 + 0.5 * sign)
            }),
            ("put back after each stroke", 1e-3, |t| (LENGTH + 0.02 * (5.0 * t).fract(), 0.1)),
        ];
        for (name, dt, signal) in hosts {
            let warnings = warnings(dt, signal);
            assert!(warnings.is_empty(), "{name}: {:?}", warnings.first());
        }
    }

    /// Slopes move the length within a step, and a master that repeats steps goes back to a saved state each time.
    #[test]
    fn slopes_and_repeated_steps_are_honest() {
        let (mut strut, dt) = (Strut::new(), 1e-3);
        for k in 0..2000 {
            let ((length, velocity), next) = (motion(f64::from(k) * dt), motion(f64::from(k + 1) * dt));
            strut.instance.set_slope(strut.columns[0], (next.0 - length) / dt).unwrap();
            strut.instance.set_slope(strut.columns[1], (next.1 - velocity) / dt).unwrap();
            strut.step(length, velocity, dt);
        }
        assert!(strut.warnings.is_empty(), "slopes: {:?}", strut.warnings.first());
        let mut strut = Strut::new();
        for k in 0..2000 {
            let (length, velocity) = motion(f64::from(k) * dt);
            let saved = strut.instance.save();
            for _ in 0..5 {
                strut.instance.restore(&saved);
                strut.step(length, velocity, dt);
            }
        }
        assert!(strut.warnings.is_empty(), "repeated: {:?}", strut.warnings.first());
    }

    #[test]
    fn models_with_length_and_velocity_are_checked() {
        let checked = catalogue::models().filter(|model| Consistency::of(model).is_some());
        assert_eq!(checked.map(|model| model.name).collect::<Vec<_>>(), ["ShockAbsorber"]);
    }
}
