//! Dependencies found by computing with expressions instead of values.
//!
//! Where a law chooses a number, both are computed, and the result depends on the question, too. Where a question
//! decides the course of the computation, each course is followed; results that are the same expression on all courses
//! do not depend on the question.

use std::collections::BTreeSet;

use stribeck::catalogue;
use stribeck::model::{self, Model, ModelType, Visitor};

use super::expression::{Expression, Id};
use super::tracked::{Course, Question, Tracked, on_course};

/// Courses that are followed at most (chosen; the present models take up to 828).
const MOST: usize = 20_000;

/// For each column that is computed, and then for the rate of each column, the columns that it is computed from. `None`
/// if the equations ask for the value of a number, as a search does.
pub fn of(model: &ModelType, has_rates: bool) -> Option<Vec<BTreeSet<usize>>> {
    let mut find = Find { name: model.name, has_rates, found: None };
    catalogue::visit(&mut find);
    find.found
}

struct Find<'a> {
    name: &'a str,
    has_rates: bool,
    found: Option<Vec<BTreeSet<usize>>>,
}

impl Visitor for Find<'_> {
    fn visit<M: Model>(&mut self) {
        if M::NAME == self.name {
            on_course(|course| course.begin(&ModelType::of::<M>()));
            let mut courses = Courses { compute: &|| results::<M>(self.has_rates), left: MOST };
            let first = courses.follow(vec![]);
            let results = first.and_then(|first| courses.united(0, first));
            self.found = results.map(|results| {
                let of = |course: &Course, result| course.expressions.columns(result);
                let results =
                    on_course(|course| results.into_iter().map(|result| of(course, result)).collect::<Vec<_>>());
                let is_known =
                    |column: usize| M::TABLE.get(column).is_some_and(|variable| !variable.role.is_computed());
                let only_computed = |(column, found)| if is_known(column) { BTreeSet::new() } else { found };
                results.into_iter().enumerate().map(only_computed).collect()
            });
            on_course(|course| *course = Default::default());
        }
    }
}

/// Computes the outputs of a model, and its rates.
fn results<M: Model>(has_rates: bool) -> Vec<Id> {
    let start = |column: usize| {
        let variable = &M::TABLE[column];
        if variable.role.is_computed() { Tracked::from(variable.start) } else { Tracked::column(column) }
    };
    let mut row: Vec<Tracked> = (0..M::TABLE.len()).map(start).collect();
    let mut rates = vec![Tracked::from(0.0); row.len()];
    if has_rates {
        model::rate_in::<M, Tracked>(&row, &mut rates);
    }
    model::output_in::<M, Tracked>(&mut row);
    row.into_iter().chain(rates).map(|number| number.0).collect()
}

/// The courses that a computation can take.
struct Courses<'a> {
    compute: &'a dyn Fn() -> Vec<Id>,
    left: usize,
}

/// One course: the ways taken at its questions, and its results.
struct Followed {
    ways: Vec<usize>,
    questions: Vec<Question>,
    results: Vec<Id>,
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
    fn united(&mut self, from: usize, first: Followed) -> Option<Vec<Id>> {
        let Some(question) = first.questions.get(from).copied() else { return Some(first.results) };
        let begin = first.ways[..from].to_vec();
        let mut united = self.united(from + 1, first)?;
        for way in 1..question.ways() {
            let ways = begin.iter().copied().chain([way]).collect();
            let other = self.follow(ways)?;
            let other = self.united(from + 1, other)?;
            on_course(|course| {
                let asked = match question {
                    Question::Answer(answer) => answer,
                    Question::Choice(column, _) => course.expressions.add(Expression::Column(column)),
                };
                for (result, other) in united.iter_mut().zip(other) {
                    *result = course.expressions.chosen(asked, *result, other);
                }
            });
        }
        Some(united)
    }
}
