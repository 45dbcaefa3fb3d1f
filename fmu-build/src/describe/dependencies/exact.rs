//! Dependencies found by computing with expressions instead of values.
//!
//! Where a law chooses a number, both are computed, and the result depends on the question, too. Where a question
//! decides the course of the computation, each course is followed; results that are the same expression on all courses
//! do not depend on the question.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, Mutex, OnceLock};

use stribeck::catalogue;
use stribeck::model::{self, InLanes, Model, ModelType, Steps, Visitor};

use super::expression::{Expression, Id};
use super::tracked::{Course, Found, Others, Question, Tracked, applied, of_other, on_course};

/// Courses that are followed at most (chosen; the present models take up to 200).
const MOST: usize = 20_000;

/// Dependencies by name of the model, each found once: many models contain the same laws, and each has several files.
static KNOWN: Mutex<BTreeMap<&'static str, Arc<OnceLock<Found>>>> = Mutex::new(BTreeMap::new());

/// For each column that is computed, and then for the rate of each column, the columns that it is computed from. `None`
/// if the equations ask for the value of a number, and for a model that is not in the catalogue.
pub fn of(model: &ModelType) -> Found {
    let known = KNOWN.lock().expect("nothing panics while it is held").entry(model.name).or_default().clone();
    known.get_or_init(|| find(model.name)).clone()
}

fn find(name: &str) -> Found {
    let mut find = Find { name, found: None };
    catalogue::visit(&mut find);
    find.found
}

struct Find<'a> {
    name: &'a str,
    found: Found,
}

impl Visitor for Find<'_> {
    fn visit<M: Model>(&mut self) {
        if M::NAME == self.name {
            on_course(|course| course.begin(&ModelType::of::<M>(), Others { dependencies: of, mark_step }));
            let mut courses = Courses { compute: &results::<M>, left: MOST };
            let first = courses.follow(vec![]);
            let results = first.and_then(|first| courses.united(0, first));
            self.found = results.map(|results| Arc::new(on_course(|course| columns::<M>(course, results))));
            on_course(|course| *course = Default::default());
        }
    }
}

/// The columns in each result of a model; none for a column that is not computed.
fn columns<M: Model>(course: &Course, results: Vec<Option<Id>>) -> Vec<BTreeSet<usize>> {
    let is_known = |column: usize| M::TABLE.get(column).is_some_and(|variable| !variable.role.is_computed());
    let of = |(column, result): (usize, Option<Id>)| {
        let result = result.filter(|_| !is_known(column));
        let mut columns = result.map_or_else(BTreeSet::new, |result| course.expressions.columns(result));
        // Memory beside the row has no columns.
        columns.retain(|column| *column < M::TABLE.len());
        columns
    };
    results.into_iter().enumerate().map(of).collect()
}

/// Computes the outputs of a model, and its rates; no rates where Model Exchange refuses this course.
fn results<M: Model>() -> Vec<Option<Id>> {
    let start = |column: usize| {
        let variable = &M::TABLE[column];
        if variable.role.is_computed() { Tracked::from(variable.start) } else { Tracked::column(column) }
    };
    let mut row: Vec<Tracked> = (0..M::TABLE.len()).map(start).collect();
    let mut rates = vec![Tracked::from(0.0); row.len()];
    model::rate_in::<M, Tracked>(&row, &mut rates);
    let is_refused = on_course(|course| course.is_refused);
    let memory = model::memory_in::<M, Tracked>(&row);
    let memory: Vec<Tracked> = (0..memory).map(|place| Tracked::column(row.len() + place)).collect();
    model::output_in::<M, Tracked>(&mut row, &memory);
    model::advise_in::<M, Tracked>(&mut row);
    let rates = rates.into_iter().map(|rate| (!is_refused).then_some(rate.0));
    row.into_iter().map(|number| Some(number.0)).chain(rates).collect()
}

/// Lets each state of a row depend on what it depends on after a step.
fn mark_step(model: &ModelType, row: &mut [Tracked]) {
    catalogue::visit(&mut Step { model, row });
}

/// Columns that each of the moving columns is computed from after any number of steps: itself, what its rate is
/// computed from, and what moves those.
fn moved(rates: &[BTreeSet<usize>], moving: &[usize]) -> Vec<BTreeSet<usize>> {
    let mut found = vec![BTreeSet::new(); rates.len()];
    for column in moving {
        let mut left = vec![*column];
        while let Some(next) = left.pop() {
            if found[*column].insert(next) && moving.contains(&next) {
                left.extend(&rates[next]);
            }
        }
    }
    found
}

struct Step<'a> {
    model: &'a ModelType,
    row: &'a mut [Tracked],
}

impl Visitor for Step<'_> {
    /// A step written for plain numbers alone may use all numbers of the row for each state. The continuous states of a
    /// model for Model Exchange move only by their rates.
    fn visit<M: Model>(&mut self) {
        let (model, row) = (self.model, &mut *self.row);
        if M::NAME != model.name {
            return;
        }
        let known = (0..row.len()).filter(|column| !M::TABLE[*column].role.is_computed()).collect();
        let is_moving = |column: usize| model.model_exchange && M::TABLE[column].is_continuous_state();
        let all = applied(model, row, &vec![known; row.len()]);
        for column in (0..row.len()).filter(|column| M::TABLE[*column].role.is_state() && !is_moving(*column)) {
            row[column] = all[column];
        }
        let moving: Vec<usize> = (0..row.len()).filter(|column| is_moving(*column)).collect();
        let Some(found) = of_other(model).filter(|_| !moving.is_empty()) else { return };
        let moved = applied(model, row, &moved(&found[row.len()..], &moving));
        moving.into_iter().for_each(|column| row[column] = moved[column]);
    }

    fn visit_in_lanes<M: InLanes>(&mut self) {
        if M::NAME != self.model.name {
            return;
        }
        let step = || {
            let mut row = self.row.to_vec();
            model::model_in::<M, Tracked>(&mut row).advance(Tracked::from(1.0));
            row.into_iter().map(|number| Some(number.0)).collect()
        };
        let whole = on_course(Course::begin_part);
        let mut courses = Courses { compute: &step, left: MOST };
        let first = courses.follow(vec![]);
        let results = first.and_then(|first| courses.united(0, first));
        on_course(|course| course.end_part(whole));
        for (number, result) in self.row.iter_mut().zip(results.into_iter().flatten()) {
            *number = result.map_or(*number, Tracked);
        }
    }
}

/// The courses that a computation can take.
struct Courses<'a> {
    compute: &'a dyn Fn() -> Vec<Option<Id>>,
    left: usize,
}

/// One course: the ways taken at its questions, and its results.
struct Followed {
    ways: Vec<usize>,
    questions: Vec<Question>,
    results: Vec<Option<Id>>,
}

impl Courses<'_> {
    fn follow(&mut self, mut ways: Vec<usize>) -> Option<Followed> {
        self.left = self.left.checked_sub(1)?;
        on_course(|course| course.follow(&ways));
        let results = (self.compute)();
        let (questions, is_lost) = on_course(|course| (course.questions.clone(), course.is_lost));
        ways.resize(questions.len(), 0);
        (!is_lost).then_some(Followed { ways, questions, results })
    }

    /// The results of all courses that begin as this one does, up to question number `from`.
    fn united(&mut self, from: usize, first: Followed) -> Option<Vec<Option<Id>>> {
        let Some(question) = first.questions.get(from).copied() else { return Some(first.results) };
        let begin = first.ways[..from].to_vec();
        let mut united = self.united(from + 1, first)?;
        for way in 1..question.ways() {
            let ways = begin.iter().copied().chain([way]).collect();
            let other = self.follow(ways)?;
            let other = self.united(from + 1, other)?;
            on_course(|course| choose(course, question, &mut united, other));
        }
        Some(united)
    }
}

/// Makes each result the choice between itself and that of another way to answer a question.
fn choose(course: &mut Course, question: Question, results: &mut [Option<Id>], others: Vec<Option<Id>>) {
    let asked = match question {
        Question::Answer(answer) => answer,
        Question::Choice(column, _) => course.expressions.add(Expression::Column(column)),
    };
    for (result, other) in results.iter_mut().zip(others) {
        *result = match (*result, other) {
            (Some(result), Some(other)) => Some(course.expressions.chosen(asked, result, other)),
            (result, other) => result.or(other),
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Column 0 is moved by 1, 1 by 2 and by the input 3; 4 by itself. Column 2 has a rate, but does not move.
    #[test]
    fn a_step_reaches_what_moves_the_numbers_of_a_rate() {
        let rates = [vec![1], vec![2, 3], vec![4], vec![], vec![4]].map(|from| from.into_iter().collect());
        let columns = |found: &BTreeSet<usize>| found.iter().copied().collect::<Vec<usize>>();
        let found: Vec<Vec<usize>> = moved(&rates, &[0, 1, 4]).iter().map(columns).collect();
        assert_eq!(found, [vec![0, 1, 2, 3], vec![1, 2, 3], vec![], vec![], vec![4]]);
    }
}
