//! A number that knows the expression it was computed by, and the course of a computation with it.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::ops::{Add, AddAssign, BitAnd, BitOr, Div, Mul, MulAssign, Neg, Not, Range, Sub, SubAssign};
use std::sync::Arc;

use stribeck::catalogue;
use stribeck::model::{Evaluate, Kind, ModelType, Variable};
use stribeck::number::{Decision, Mask, Real, Scalar};
use stribeck::numerics::vector::{Component, One, Zero};

use super::expression::{Expression, Expressions, Id, Operation, Order};
use crate::describe::text::limits;

/// A number, known by its expression.
#[derive(Clone, Copy, Debug)]
pub struct Tracked(pub Id);

/// An answer, known by its expression.
#[derive(Clone, Copy, Debug)]
pub struct TrackedMask(Id);

/// Question whose answer decides the course of a computation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Question {
    /// An answer.
    Answer(Id),
    /// The choice in a column, of so many.
    Choice(usize, usize),
}

impl Question {
    /// Number of courses from here on.
    pub fn ways(self) -> usize {
        match self {
            Question::Answer(_) => 2,
            Question::Choice(_, ways) => ways,
        }
    }
}

/// For each column that a model computes, the columns that it is computed from; then the same for the rate of each.
pub type Found = Option<Arc<Vec<BTreeSet<usize>>>>;

/// What is to be known of other models.
#[derive(Clone, Copy)]
pub struct Others {
    /// The dependencies of a model.
    pub dependencies: fn(&ModelType) -> Found,
    /// Lets each state of a row depend on what it depends on after a step of the model.
    pub mark_step: fn(&ModelType, &mut [Tracked]),
}

/// What holds in the course of a computation.
#[derive(Clone, Default)]
struct Assumed {
    /// Orders that hold from a question on, or within a branch that is computed for the case that it counts.
    orders: Vec<(Id, Id, Order)>,
    /// Other answers, in the same way.
    answers: Vec<(Id, bool)>,
    /// Columns with the choice that has been taken.
    choices: Vec<(usize, f64)>,
}

/// A computation of which a part is followed on courses of its own.
pub struct Whole {
    script: Vec<usize>,
    questions: Vec<Question>,
    begin: Assumed,
    is_refused: bool,
}

/// A computation, and all expressions of those before it.
#[derive(Default)]
pub struct Course {
    pub expressions: Expressions,
    /// The values that each column can take, if it is a choice.
    ways: Vec<Option<Vec<f64>>>,
    others: Option<Others>,
    /// Ways to take at the first questions; the first way at all others.
    script: Vec<usize>,
    /// Questions that have come up, in order.
    pub questions: Vec<Question>,
    assumed: Assumed,
    /// What holds at the beginning of every course.
    begin: Assumed,
    /// Whether the value of a number other than a choice was read, which no expression records.
    pub is_lost: bool,
    /// Whether rates of a model were asked for that has none: Model Exchange refuses this course.
    pub is_refused: bool,
}

thread_local! {
    static COURSE: RefCell<Course> = RefCell::default();
}

/// Works on the present computation.
pub fn on_course<R>(work: impl FnOnce(&mut Course) -> R) -> R {
    COURSE.with_borrow_mut(work)
}

impl Course {
    /// Begins the computations of a model.
    pub fn begin(&mut self, model: &ModelType, others: Others) {
        let ways = model.table.iter().map(|variable| ways(&variable)).collect();
        *self = Course { ways, others: Some(others), ..Course::default() };
    }

    /// Begins a computation that takes these ways.
    pub fn follow(&mut self, script: &[usize]) {
        self.script = script.to_vec();
        self.questions.clear();
        self.assumed = self.begin.clone();
        self.is_refused = false;
    }

    /// Begins a part that is followed on courses of its own.
    pub fn begin_part(&mut self) -> Whole {
        let begin = std::mem::replace(&mut self.begin, self.assumed.clone());
        let (script, questions) = (std::mem::take(&mut self.script), std::mem::take(&mut self.questions));
        Whole { script, questions, begin, is_refused: self.is_refused }
    }

    /// Continues with the whole after such a part.
    pub fn end_part(&mut self, whole: Whole) {
        self.assumed = std::mem::replace(&mut self.begin, whole.begin);
        (self.script, self.questions, self.is_refused) = (whole.script, whole.questions, whole.is_refused);
    }

    fn next_way(&mut self, question: Question) -> usize {
        let way = self.script.get(self.questions.len()).copied().unwrap_or(0);
        self.questions.push(question);
        way
    }

    /// The answer as far as the present course determines it.
    fn settled(&self, id: Id) -> Option<bool> {
        if let Some(answer) = self.expressions.known_answer(id) {
            return Some(answer);
        }
        if let Some((_, answer)) = self.assumed.answers.iter().find(|(known, _)| *known == id) {
            return Some(*answer);
        }
        match self.expressions.get(id) {
            Expression::Not(other) => self.settled(other).map(|answer| !answer),
            Expression::And(a, b) => match (self.settled(a), self.settled(b)) {
                (Some(false), _) | (_, Some(false)) => Some(false),
                (Some(true), Some(true)) => Some(true),
                _ => None,
            },
            Expression::Compared(order, a, b) => self.possible(a, b).settles(order),
            _ => None,
        }
    }

    /// The orders of two numbers that are still possible.
    fn possible(&self, a: Id, b: Id) -> Order {
        let same = self.assumed.orders.iter().filter(|known| (known.0, known.1) == (a, b));
        same.fold(Order::ANY, |possible, known| possible.and(known.2))
    }

    fn assume(&mut self, id: Id, answer: bool) {
        match (self.expressions.get(id), answer) {
            (Expression::Compared(order, a, b), _) => {
                self.assumed.orders.push((a, b, if answer { order } else { order.not() }));
            }
            (Expression::Not(other), _) => self.assume(other, !answer),
            (Expression::And(a, b), true) => {
                self.assume(a, true);
                self.assume(b, true);
            }
            _ => self.assumed.answers.push((id, answer)),
        }
    }

    fn decide(&mut self, id: Id) -> bool {
        if let Some(answer) = self.settled(id) {
            return answer;
        }
        match self.expressions.get(id) {
            Expression::Not(other) => !self.decide(other),
            Expression::And(a, b) => self.decide(a) && self.decide(b),
            _ => {
                let answer = self.next_way(Question::Answer(id)) == 0;
                self.assume(id, answer);
                answer
            }
        }
    }

    /// The value of a choice; any value, which is noted, of another number.
    fn value(&mut self, id: Id) -> f64 {
        if let Some(value) = self.expressions.value(id) {
            return value;
        }
        let chosen = self.chosen(id);
        if let Some(value) = self.expressions.value(chosen) {
            return value;
        }
        if let Expression::Column(column) = self.expressions.get(id)
            && let Some(Some(ways)) = self.ways.get(column)
        {
            let way = self.next_way(Question::Choice(column, ways.len()));
            let value = self.ways[column].as_ref().map_or(0.0, |ways| ways[way]);
            self.assumed.choices.push((column, value));
            return value;
        }
        self.is_lost = true;
        0.5
    }

    /// The number itself, or its value where that is a choice that has been taken.
    fn chosen(&mut self, id: Id) -> Id {
        let Expression::Column(column) = self.expressions.get(id) else { return id };
        let choice = self.assumed.choices.iter().find(|choice| choice.0 == column);
        choice.map(|choice| choice.1).map_or(id, |value| self.expressions.constant(value))
    }

    fn compared(&mut self, order: Order, a: Tracked, b: Tracked) -> TrackedMask {
        let (a, b) = (self.chosen(a.0), self.chosen(b.0));
        TrackedMask(self.expressions.compared(order, a, b))
    }
}

/// Most values of an integer that are taken one after the other, beside the last one (chosen: no model has more columns
/// for elements of a kind; what a model has beyond them is the same for all numbers of elements).
const MOST_WAYS: usize = 64;

fn ways(variable: &Variable) -> Option<Vec<f64>> {
    let values = |from: f64, count: usize| (0..count).map(|way| from + way as f64).collect();
    match (variable.kind, limits(variable)) {
        (Kind::Boolean, _) => Some(values(0.0, 2)),
        (Kind::Enumeration(items), _) => Some(values(1.0, items.items.len())),
        (Kind::Integer, (Some(min), Some(max))) => {
            let count = (max - min) as usize + 1;
            let mut ways: Vec<f64> = values(min, count.min(MOST_WAYS));
            ways.extend((count > MOST_WAYS).then_some(max));
            Some(ways)
        }
        _ => None,
    }
}

impl Tracked {
    pub fn column(column: usize) -> Tracked {
        on_course(|course| Tracked(course.expressions.add(Expression::Column(column))))
    }

    fn of(operation: Operation, a: Tracked, b: Tracked) -> Tracked {
        on_course(|course| Tracked(course.expressions.result(operation, a.0, b.0)))
    }
}

impl From<f64> for Tracked {
    fn from(value: f64) -> Tracked {
        on_course(|course| Tracked(course.expressions.constant(value)))
    }
}

impl From<bool> for TrackedMask {
    fn from(answer: bool) -> TrackedMask {
        on_course(|course| TrackedMask(course.expressions.answer(answer)))
    }
}

impl BitAnd for TrackedMask {
    type Output = TrackedMask;
    fn bitand(self, other: TrackedMask) -> TrackedMask {
        on_course(|course| TrackedMask(course.expressions.and(self.0, other.0)))
    }
}

impl Not for TrackedMask {
    type Output = TrackedMask;
    fn not(self) -> TrackedMask {
        on_course(|course| TrackedMask(course.expressions.not(self.0)))
    }
}

impl BitOr for TrackedMask {
    type Output = TrackedMask;
    fn bitor(self, other: TrackedMask) -> TrackedMask {
        !(!self & !other)
    }
}

impl Mask<Tracked> for TrackedMask {
    fn agreed(self) -> Option<bool> {
        on_course(|course| course.settled(self.0))
    }

    fn any(self) -> bool {
        self.agreed() != Some(false)
    }

    fn all(self) -> bool {
        self.agreed() == Some(true)
    }

    fn select(self, yes: Tracked, no: Tracked) -> Tracked {
        match self.agreed() {
            Some(true) => yes,
            Some(false) => no,
            None => self.chosen(yes, no),
        }
    }

    fn choose(self, yes: impl FnOnce() -> Tracked, no: impl FnOnce() -> Tracked) -> Tracked {
        let [chosen] = self.choose_all(|| [yes()], || [no()]);
        chosen
    }

    fn choose_all<const N: usize>(
        self,
        yes: impl FnOnce() -> [Tracked; N],
        no: impl FnOnce() -> [Tracked; N],
    ) -> [Tracked; N] {
        match self.agreed() {
            Some(true) => yes(),
            Some(false) => no(),
            None => {
                let (yes, no) = (assuming(self.0, true, yes), assuming(self.0, false, no));
                std::array::from_fn(|number| self.chosen(yes[number], no[number]))
            }
        }
    }
}

impl Decision<Tracked> for TrackedMask {
    fn holds(self) -> bool {
        on_course(|course| course.decide(self.0))
    }
}

impl TrackedMask {
    fn chosen(self, yes: Tracked, no: Tracked) -> Tracked {
        on_course(|course| Tracked(course.expressions.chosen(self.0, yes.0, no.0)))
    }
}

/// Computes a branch for the case that it counts. The compiler repeats this for every branch of every model, so that its
/// steps are functions of their own.
fn assuming<R>(id: Id, answer: bool, work: impl FnOnce() -> R) -> R {
    let assumed = assume(id, answer);
    let result = work();
    // Questions within the branch are answered for the whole computation.
    forget(assumed);
    result
}

/// Assumes an answer; returns the places of what is assumed with it, orders and other answers.
fn assume(id: Id, answer: bool) -> [Range<usize>; 2] {
    on_course(|course| {
        let (orders, answers) = (course.assumed.orders.len(), course.assumed.answers.len());
        course.assume(id, answer);
        [orders..course.assumed.orders.len(), answers..course.assumed.answers.len()]
    })
}

fn forget([orders, answers]: [Range<usize>; 2]) {
    on_course(|course| {
        course.assumed.orders.drain(orders);
        course.assumed.answers.drain(answers);
    });
}

impl Add for Tracked {
    type Output = Tracked;
    fn add(self, other: Tracked) -> Tracked {
        Tracked::of(Operation::Add, self, other)
    }
}

impl Sub for Tracked {
    type Output = Tracked;
    fn sub(self, other: Tracked) -> Tracked {
        Tracked::of(Operation::Sub, self, other)
    }
}

impl Mul for Tracked {
    type Output = Tracked;
    fn mul(self, other: Tracked) -> Tracked {
        Tracked::of(Operation::Mul, self, other)
    }
}

impl Div for Tracked {
    type Output = Tracked;
    fn div(self, other: Tracked) -> Tracked {
        Tracked::of(Operation::Div, self, other)
    }
}

impl Neg for Tracked {
    type Output = Tracked;
    fn neg(self) -> Tracked {
        Tracked::of(Operation::Neg, self, self)
    }
}

impl PartialEq for Tracked {
    fn eq(&self, other: &Tracked) -> bool {
        self.equals(*other).holds()
    }
}

impl PartialOrd for Tracked {
    fn partial_cmp(&self, other: &Tracked) -> Option<Ordering> {
        Some(if self.above(*other).holds() {
            Ordering::Greater
        } else if self.equals(*other).holds() {
            Ordering::Equal
        } else {
            Ordering::Less
        })
    }
    fn lt(&self, other: &Tracked) -> bool {
        self.below(*other).holds()
    }
    fn le(&self, other: &Tracked) -> bool {
        self.at_most(*other).holds()
    }
    fn gt(&self, other: &Tracked) -> bool {
        self.above(*other).holds()
    }
    fn ge(&self, other: &Tracked) -> bool {
        self.at_least(*other).holds()
    }
}

impl Scalar for Tracked {}

impl Real for Tracked {
    type Mask = TrackedMask;
    /// Both ways of a choice count until one is ruled out.
    const HAS_ONE_LANE: bool = false;

    fn lane(self, _lane: usize) -> f64 {
        on_course(|course| course.value(self.0))
    }
    fn is(self, constant: f64) -> TrackedMask {
        self.equals(Tracked::from(constant))
    }
    fn above(self, other: Tracked) -> TrackedMask {
        on_course(|course| course.compared(Order::GREATER, self, other))
    }
    fn at_least(self, other: Tracked) -> TrackedMask {
        on_course(|course| course.compared(Order::GREATER.or(Order::EQUAL), self, other))
    }
    fn equals(self, other: Tracked) -> TrackedMask {
        on_course(|course| course.compared(Order::EQUAL, self, other))
    }
    fn found<const N: usize>(on: impl FnOnce() -> [Tracked; N], _search: impl Fn(usize) -> [f64; 2]) -> [Tracked; 2] {
        let on = on().map(|number| number.0);
        on_course(|course| [0, 1].map(|place| Tracked(course.expressions.found(place, on.into_iter()))))
    }
    fn sign(self) -> Tracked {
        Tracked::of(Operation::Sign, self, self)
    }
    fn abs(self) -> Tracked {
        Tracked::of(Operation::Abs, self, self)
    }
    fn exp(self) -> Tracked {
        Tracked::of(Operation::Exp, self, self)
    }
    fn exp_m1(self) -> Tracked {
        Tracked::of(Operation::ExpM1, self, self)
    }
    fn ln(self) -> Tracked {
        Tracked::of(Operation::Ln, self, self)
    }
    fn ln_1p(self) -> Tracked {
        Tracked::of(Operation::Ln1p, self, self)
    }
    fn tanh(self) -> Tracked {
        Tracked::of(Operation::Tanh, self, self)
    }
    fn sin(self) -> Tracked {
        Tracked::of(Operation::Sin, self, self)
    }
    fn cos(self) -> Tracked {
        Tracked::of(Operation::Cos, self, self)
    }
    fn atan(self) -> Tracked {
        Tracked::of(Operation::Atan, self, self)
    }
    fn sqrt(self) -> Tracked {
        Tracked::of(Operation::Sqrt, self, self)
    }
    fn powf(self, exponent: Tracked) -> Tracked {
        Tracked::of(Operation::Power, self, exponent)
    }
}

/// The dependencies of another model.
pub fn of_other(model: &ModelType) -> Found {
    // To find them is a computation of its own.
    let present = on_course(std::mem::take);
    let found = present.others.and_then(|others| (others.dependencies)(model));
    on_course(|course| *course = present);
    on_course(|course| course.is_lost |= found.is_none());
    found
}

impl Zero for Tracked {
    fn zero() -> Tracked {
        Tracked::from(0.0)
    }
    fn is_zero(&self) -> bool {
        self.equals(Tracked::from(0.0)).holds()
    }
}

impl One for Tracked {
    fn one() -> Tracked {
        Tracked::from(1.0)
    }
}

impl AddAssign for Tracked {
    fn add_assign(&mut self, other: Tracked) {
        *self = *self + other;
    }
}

impl SubAssign for Tracked {
    fn sub_assign(&mut self, other: Tracked) {
        *self = *self - other;
    }
}

impl MulAssign for Tracked {
    fn mul_assign(&mut self, other: Tracked) {
        *self = *self * other;
    }
}

impl Component for Tracked {}

/// Columns that a model computes from columns of a row, and the numbers that stand there for them.
pub fn applied(model: &ModelType, row: &[Tracked], found: &[BTreeSet<usize>]) -> Vec<Tracked> {
    // Equal lists of different models do not give the same number.
    let place = catalogue::models().position(|other| other == model).unwrap_or_default();
    on_course(|course| {
        let mark = course.expressions.constant(place as f64);
        let of = |(column, from): (usize, &BTreeSet<usize>)| {
            let numbers = from.iter().map(|column| row[*column].0);
            Tracked(course.expressions.found(column, std::iter::once(mark).chain(numbers)))
        };
        found.iter().enumerate().map(of).collect()
    })
}

impl Evaluate for Tracked {
    const HAS_VALUES: bool = false;

    fn evaluate(model: &ModelType, row: &mut [Tracked]) -> bool {
        let Some(found) = of_other(model) else { return true };
        let results = applied(model, row, &found[..row.len()]);
        for (column, result) in results.into_iter().enumerate() {
            if model.table.at(column).role.is_computed() {
                row[column] = result;
            }
        }
        true
    }
    fn rate(model: &ModelType, row: &[Tracked], rate: &mut [Tracked]) {
        if !model.model_exchange {
            Tracked::refuse_rates();
        }
        let Some(found) = of_other(model) else { return };
        rate.copy_from_slice(&applied(model, row, &found[row.len()..]));
    }
    fn overshoot(_model: &ModelType, row: &[Tracked]) -> Tracked {
        row.iter().fold(Tracked::from(1.0), |sum, number| sum + *number)
    }
    fn refuse_rates() {
        on_course(|course| course.is_refused = true);
    }
    fn mark_step(model: &ModelType, row: &mut [Tracked]) {
        if let Some(others) = on_course(|course| course.others) {
            (others.mark_step)(model, row);
        }
    }
    fn slope(self) -> f64 {
        0.0
    }
    fn with_slope(value: f64, _slope: f64) -> Tracked {
        Tracked::from(value)
    }
}
