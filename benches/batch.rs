//! Cost of 1,024 rows of a law side by side, as a part of that of the same text in plain scalar Rust: with the functions
//! of Rust's standard library, and with those of the project. Processor time, in one run; medians of the ratios.

use std::hint::black_box;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Range, Sub, SubAssign};

use cpu_time::ThreadTime;
use stribeck::batch::{Batch, Registers, Stepped};
use stribeck::catalogue;
use stribeck::friction::{BrownMcPhee, Dahl, LuGre, Specker, Threlfall};
use stribeck::model::{Columns, InLanes, Law, Model, ModelType, Steps, model_in};
use stribeck::number::Real;
use stribeck::numerics::vector::{Component, One, Zero};

const ROWS: usize = 1024;
const CONTACTS: usize = 4096;
/// Odd, so that the median is one of the rounds.
const ROUNDS: usize = 51;
/// Repetitions in a round.
const TIMES: usize = 20;
const STEP: f64 = 1e-4;

/// An f64 with the functions of the standard library.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
#[repr(transparent)]
struct Plain(f64);

macro_rules! operations {
    ($($Trait:ident $name:ident $op:tt $Assign:ident $assign:ident;)+) => {
        $(
            impl $Trait for Plain {
                type Output = Plain;
                #[inline(always)]
                fn $name(self, other: Plain) -> Plain {
                    Plain(self.0 $op other.0)
                }
            }
            impl $Assign for Plain {
                fn $assign(&mut self, other: Plain) {
                    *self = *self $op other;
                }
            }
        )+
    };
}

operations! {
    Add add + AddAssign add_assign;
    Sub sub - SubAssign sub_assign;
    Mul mul * MulAssign mul_assign;
}

impl Div for Plain {
    type Output = Plain;
    #[inline(always)]
    fn div(self, other: Plain) -> Plain {
        Plain(self.0 / other.0)
    }
}

impl Neg for Plain {
    type Output = Plain;
    #[inline(always)]
    fn neg(self) -> Plain {
        Plain(-self.0)
    }
}

impl From<f64> for Plain {
    #[inline(always)]
    fn from(value: f64) -> Plain {
        Plain(value)
    }
}

impl Zero for Plain {
    fn zero() -> Plain {
        Plain(0.0)
    }
    fn is_zero(&self) -> bool {
        self.0 == 0.0
    }
}

impl One for Plain {
    fn one() -> Plain {
        Plain(1.0)
    }
}

impl Component for Plain {}

macro_rules! functions {
    ($($name:ident)+) => {
        $(
            #[inline(always)]
            fn $name(self) -> Plain {
                Plain(f64::$name(self.0))
            }
        )+
    };
}

impl Real for Plain {
    type Mask = bool;

    functions!(exp exp_m1 ln ln_1p tanh sin cos atan sqrt abs);

    #[inline(always)]
    fn lane(self, _lane: usize) -> f64 {
        self.0
    }
    #[inline(always)]
    fn is(self, constant: f64) -> bool {
        self.0 == constant
    }
    #[inline(always)]
    fn above(self, other: Plain) -> bool {
        self > other
    }
    #[inline(always)]
    fn at_least(self, other: Plain) -> bool {
        self >= other
    }
    #[inline(always)]
    fn equals(self, other: Plain) -> bool {
        self == other
    }
    #[inline(always)]
    fn sign(self) -> Plain {
        Plain(Real::sign(self.0))
    }
    #[inline(always)]
    fn powf(self, exponent: Plain) -> Plain {
        Plain(self.0.powf(exponent.0))
    }
}

/// Work that is measured.
#[derive(Clone, Copy)]
enum Work {
    Output,
    Step,
}

/// Rows at their start values, with velocities of all sizes around the transition and in all directions.
fn rows<M: Columns>() -> Vec<f64> {
    let velocity = M::TABLE.iter().position(|variable| variable.path.to_string() == "velocity").expect("an input");
    let row = |number: usize| {
        let share = (number as f64 * 0.618_033_988_749_894_9).fract();
        let start = M::TABLE.iter().map(|variable| variable.start);
        start.enumerate().map(move |(column, value)| if column == velocity { 6e-3 * share - 3e-3 } else { value })
    };
    (0..ROWS).flat_map(row).collect()
}

#[inline(never)]
fn scalar<M: InLanes, T: Component>(rows: &mut [T], work: Work) {
    for row in rows.chunks_exact_mut(M::TABLE.len()) {
        let law = model_in::<M, T>(row);
        match work {
            Work::Output => law.output(),
            Work::Step => law.advance(T::from(STEP)),
        }
    }
}

fn side_by_side(batch: &mut Batch, work: Work) {
    let is_finite = match work {
        Work::Output => batch.output(),
        Work::Step => batch.advance(STEP),
    };
    assert!(is_finite);
}

/// Nanoseconds for a row.
fn timed(mut work: impl FnMut()) -> f64 {
    let start = ThreadTime::now();
    (0..TIMES).for_each(|_| work());
    start.elapsed().as_secs_f64() * 1e9 / (TIMES * ROWS) as f64
}

fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

fn compare<M: InLanes + Model>(work: Work, name: &str) {
    let law = catalogue::by_name(M::NAME).expect("a law");
    let mut own = rows::<M>();
    let mut plain: Vec<Plain> = own.iter().copied().map(Plain).collect();
    for registers in Registers::here().filter(|registers| *registers != Registers::Scalar) {
        let Some(mut batch) = Batch::new(law, registers, ROWS).expect("memory") else { continue };
        for (number, row) in own.chunks_exact(M::TABLE.len()).enumerate() {
            assert!(batch.load(number..number + 1, row));
        }
        let rounds: Vec<[f64; 3]> = (0..ROUNDS)
            .map(|_| {
                [
                    timed(|| scalar::<M, Plain>(black_box(&mut plain), work)),
                    timed(|| scalar::<M, f64>(black_box(&mut own), work)),
                    timed(|| side_by_side(black_box(&mut batch), work)),
                ]
            })
            .collect();
        let of = |number: usize| median(rounds.iter().map(|times| times[number]).collect());
        let ratio = |to: usize| median(rounds.iter().map(|times| times[2] / times[to]).collect());
        println!(
            "{name:18} {:8} {:8.2} {:8.2} {:8.2} {:12.2} {:12.2}",
            format!("{registers:?}").to_lowercase(),
            of(0),
            of(1),
            of(2),
            ratio(0),
            ratio(1)
        );
    }
}

/// Microseconds for a step of all contacts with the widest registers: velocities in, forces out.
fn stepped(law: &'static ModelType) -> f64 {
    let column = |name: &str| law.find(name).expect("a variable");
    let mut contacts = Stepped::new(law, Registers::best(), CONTACTS).expect("memory");
    let velocities: Vec<f64> =
        (0..CONTACTS).map(|number| 6e-3 * (number as f64 * 0.618_033_988_749_894_9).fract() - 3e-3).collect();
    let (velocity, force, mut forces) = (column("velocity"), column("friction_force"), vec![0.0; CONTACTS]);
    let mut step = || {
        let mut take = |runs: Range<usize>, values: &[f64]| {
            forces[runs].copy_from_slice(values);
            Ok(())
        };
        contacts.step(STEP, &[(velocity, &velocities)], force, &mut take).expect("a step");
    };
    median((0..ROUNDS).map(|_| timed(&mut step) * ROWS as f64 * 1e-3).collect())
}

fn main() {
    println!("{ROWS} rows, ns per row, and ratios; medians of {ROUNDS} rounds\n");
    let heading = ["standard", "own", "lanes", "to standard", "to own"];
    println!(
        "{:18} {:8} {:>8} {:>8} {:>8} {:>12} {:>12}",
        "law", "lanes", heading[0], heading[1], heading[2], heading[3], heading[4]
    );
    compare::<Threlfall>(Work::Output, "Threlfall");
    compare::<BrownMcPhee>(Work::Output, "BrownMcPhee");
    compare::<Specker>(Work::Output, "Specker");
    compare::<LuGre>(Work::Output, "LuGre, output");
    compare::<LuGre>(Work::Step, "LuGre, step");
    compare::<Dahl>(Work::Step, "Dahl, step");
    println!("\n{CONTACTS} contacts that the caller steps, us per step\n");
    let runs_in_lanes = |law: &'static ModelType| Batch::new(law, Registers::best(), 1).expect("memory").is_some();
    let laws = catalogue::documented(catalogue::Family::Friction).map(|(law, _)| law).filter(|law| runs_in_lanes(law));
    laws.for_each(|law| println!("{:24} {:8.1}", law.name, stepped(law)));
}
