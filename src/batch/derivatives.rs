//! Exact derivatives of what runs lead to.

use super::stepped::{Stepped, Stopped, refusal};
use crate::instance::Refused;
use crate::model::{Fault, InLanes, Law, Model, ModelType, Steps, Visitor, model_in};
use crate::number::Dual;

/// A step of a law, and the outputs after it, in dual numbers.
type Step = fn(&mut [Dual], f64);

/// None for a law whose steps have modes: they are not written for every number.
fn step_of(law: &ModelType) -> Option<Step> {
    struct Search<'a>(&'a str, Option<Step>);
    impl Visitor for Search<'_> {
        fn visit<M: Model>(&mut self) {}

        fn visit_in_lanes<M: InLanes>(&mut self) {
            if M::NAME == self.0 {
                self.1 = Some(|row, dt| {
                    let law = model_in::<M, Dual>(row);
                    law.advance(Dual::from(dt));
                    law.output();
                });
            }
        }
    }
    let mut search = Search(law.name, None);
    crate::catalogue::visit(&mut search);
    search.1
}

/// Which derivatives are wanted.
#[derive(Clone, Copy, Debug)]
pub struct Wanted<'a> {
    /// The columns that are differentiated: outputs and, with a step, states.
    pub of: &'a [usize],
    /// Those by which they are: inputs, parameters and states.
    pub by: &'a [usize],
    /// The step after which the first ones are meant, from the present state and with the present inputs; none for the
    /// present outputs.
    pub dt: Option<f64>,
}

impl Stepped {
    /// Whether there are derivatives over a step: for laws whose steps have no modes.
    pub fn differentiates_steps(&self) -> bool {
        step_of(self.model()).is_some()
    }

    /// Hands over derivatives: numbers of the one that is differentiated and of the one by which it is, run, derivative. The
    /// runs stay where they are.
    ///
    /// # Panics
    ///
    /// If a step is wanted of a law whose steps have modes: see [`Stepped::differentiates_steps`].
    pub fn derivatives(&mut self, wanted: Wanted, take: &mut dyn FnMut([usize; 2], usize, f64)) -> Result<(), Stopped> {
        let (model, Wanted { of, by, dt }) = (self.model(), wanted);
        let step = dt.and_then(|dt| Some((step_of(model)?, dt)));
        assert!(dt.is_some() == step.is_some(), "a law whose steps are differentiated");
        self.forget_given();
        self.check()?;
        dt.map_or(Ok(()), |dt| self.check_step(dt))?;
        let mut seeded: Vec<Dual> = Vec::new();
        for run in 0..self.runs() {
            let (row, memory) = self.row_of(run);
            let memory: Vec<Dual> = memory.iter().map(|value| Dual::from(*value)).collect();
            for (number, column) in by.iter().enumerate() {
                seeded.clear();
                seeded.extend(row.iter().map(|value| Dual::from(*value)));
                seeded[*column].slope = 1.0;
                match step {
                    Some((step, dt)) => step(&mut seeded, dt),
                    None => (model.output_dual_with)(&mut seeded, &memory),
                }
                for (place, result) in of.iter().enumerate() {
                    let slope = seeded[*result].slope;
                    if !slope.is_finite() {
                        let [result, column] = [result, column].map(|column| model.table.at(*column).path);
                        let text = format_args!("the derivative of {result} by {column} is not finite");
                        return Err((run, refusal(Refused::NotFinite(Fault::new(text)))));
                    }
                    take([place, number], run, slope);
                }
            }
        }
        Ok(())
    }
}
