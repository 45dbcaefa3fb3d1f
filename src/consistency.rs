//! Notices a host that makes a step more often than the time passes.
//!
//! Some integrators ask for a force many times in each of their steps. A host that answers each time with a step of its
//! own count advances what a model remembers many times too far, and no communication point tells: only that the length
//! does not follow from the velocity. Where a model has both as inputs, the ways that they make are compared.

use crate::model::{Fault, Kind, ModelType, Role};

/// A way in one direction counts from this number of steps on (chosen): a velocity that rings from step to step, as that
/// of some integrators does, makes none.
const STEPS: u32 = 32;

/// And what the velocity makes is looked at from this part of the largest length on (chosen).
const SIGNIFICANT: f64 = 0.05;

/// Way of the length over that of the velocity that is told (chosen). At the lower end the length is not given at all;
/// the upper one no motion reaches that is sampled twice in its period, which makes 2 / pi.
const WRONG: [f64; 2] = [0.001, 0.5];

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

/// What was seen in a run.
#[derive(Clone, Copy, Default)]
struct SoFar {
    stroke: Stroke,
    by_length: f64,
    by_velocity: f64,
    largest: f64,
    /// Is nothing known any more?
    is_given_up: bool,
}

impl Consistency {
    /// For a model whose inputs are a length and its time derivative.
    pub fn of(model: &ModelType) -> Option<Consistency> {
        let input = |name: &str| {
            let is_input = |column: &usize| {
                model.table[*column].role == Role::Input && matches!(model.table[*column].kind, Kind::Real(_))
            };
            model.find(name).filter(is_input)
        };
        let (length, velocity) = (input("length")?, input("velocity")?);
        Some(Consistency { length, velocity, so_far: SoFar::default() })
    }

    /// A run begins.
    pub fn begin(&mut self) {
        self.so_far = SoFar::default();
    }

    /// A state is restored: who does so may repeat steps, and has a way back.
    pub fn give_up(&mut self) {
        self.so_far.is_given_up = true;
    }

    /// What the host should know.
    pub fn warning(&self) -> Option<Fault> {
        let (by_length, by_velocity) = self.so_far.ways();
        let ratio = by_length / by_velocity;
        let is_wrong = by_velocity > SIGNIFICANT * self.so_far.largest && WRONG[0] < ratio && ratio < WRONG[1];
        (is_wrong && !self.so_far.is_given_up).then(|| {
            Fault::new(format_args!(
                "the steps so far, with velocity, make a way {:.1} times that of length: is each step made once, and \
                 is velocity the time derivative of length?",
                1.0 / ratio
            ))
        })
    }

    /// Takes part in a step of `dt` from that row on.
    #[inline]
    pub fn observe(&mut self, row: &[f64], dt: f64) {
        self.so_far.add(row[self.length], row[self.velocity] * dt);
    }
}

impl SoFar {
    fn add(&mut self, length: f64, way: f64) {
        let moved = length - self.stroke.end;
        let turns = way * self.stroke.by_velocity < 0.0;
        // Backwards by more than a step makes: the host has put the length somewhere else.
        let jumps = moved * self.stroke.by_velocity < 0.0 && moved.abs() > way.abs();
        if self.stroke.steps == 0 || turns || jumps {
            self.close();
            self.stroke = Stroke { begin: length, end: length, by_velocity: 0.0, steps: 0 };
        }
        self.stroke.end = length;
        self.stroke.by_velocity += way;
        self.stroke.steps = self.stroke.steps.saturating_add(1);
        self.largest = self.largest.max(length.abs());
    }

    /// The ways so far, of the length and by the velocity.
    fn ways(&self) -> (f64, f64) {
        if self.stroke.steps < STEPS {
            return (self.by_length, self.by_velocity);
        }
        let along = (self.stroke.end - self.stroke.begin) * self.stroke.by_velocity.signum();
        (self.by_length + along.max(0.0), self.by_velocity + self.stroke.by_velocity.abs())
    }

    fn close(&mut self) {
        (self.by_length, self.by_velocity) = self.ways();
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
        steps: u64,
    }

    impl Strut {
        fn new() -> Strut {
            let model = catalogue::by_name("ShockAbsorber").expect("the strut");
            let columns = ["length", "velocity"].map(|name| model.find(name).expect(name));
            Strut { instance: Instance::new(model), columns, warnings: Vec::new(), steps: 0 }
        }

        fn step(&mut self, length: f64, velocity: f64, dt: f64) {
            self.instance.put(self.columns[0], length);
            self.instance.put(self.columns[1], velocity);
            self.instance.step(dt).expect("a step");
            self.steps += 1;
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
            let begin = format!("the steps so far, with velocity, make a way {often}.");
            assert!(last.starts_with(&begin), "{last}");
        }
    }

    #[test]
    fn honest_hosts_are_never_warned() {
        type Signal = fn(f64) -> (f64, f64);
        // What a host does: its name, its step, and length and velocity at a time.
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
            let mut strut = Strut::new();
            for k in 0..4000 {
                let (length, velocity) = signal(f64::from(k) * dt);
                strut.step(length, velocity, dt);
            }
            assert!(strut.warnings.is_empty(), "{name}: {:?}", strut.warnings.first());
        }
    }

    /// Slopes move the length within a step, and a master that repeats steps goes back to a saved state each time.
    #[test]
    fn slopes_and_repeated_steps_are_honest() {
        let (mut strut, dt) = (Strut::new(), 1e-3);
        for k in 0..2000 {
            let ((length, velocity), next) = (motion(f64::from(k) * dt), motion(f64::from(k + 1) * dt));
            strut.instance.put_slope(strut.columns[0], (next.0 - length) / dt);
            strut.instance.put_slope(strut.columns[1], (next.1 - velocity) / dt);
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

    /// Every model that has a length and its derivative as inputs is looked at, and no other.
    #[test]
    fn models_with_a_length_are_looked_at() {
        let found: Vec<_> = catalogue::models().filter(|model| Consistency::of(model).is_some()).collect();
        assert!(found.iter().any(|model| model.name == "ShockAbsorber"), "{found:?}");
        assert!(found.iter().all(|model| model.find("length").is_some()), "{found:?}");
    }
}
