//! Derivatives of results with respect to time, in directions, and their adjoints.

use super::component::{Component, Outcome, Refusal, enter, refuse};
use super::layout::{Item, Type};
use super::lifecycle::Call;
use super::types::*;
use super::values::check_count;
use crate::component::Lifecycle;
use crate::guard::pointer::{array, array_mut};
use stribeck::instance::Instance;
use stribeck::model::{Computed, Fault, Role};
use stribeck::number::Dual;

impl Component {
    /// Number of elements of an output; `otherwise` says why another variable is refused.
    fn differentiated(&self, reference: fmi3ValueReference, otherwise: &str) -> Result<usize, Refusal> {
        let elements = self.elements_of(reference, Type::Float64)?;
        if let Item::Column(column) = elements.first() {
            let variable = self.instance.model().table.at(column);
            if variable.role.is_output() {
                variable.check_derivatives().map_err(|fault| Refusal::Discard(fault.0))?;
                return Ok(elements.len());
            }
        }
        refuse(format_args!("{} {otherwise}", self.name(elements)))
    }

    /// Number of elements of an output or derivative.
    fn unknown(&self, reference: fmi3ValueReference) -> Result<usize, Refusal> {
        let elements = self.elements(reference)?;
        match elements.first() {
            Item::Derivative(_) => Ok(elements.len()),
            _ => self.differentiated(reference, "is neither an output nor a derivative"),
        }
    }

    /// Number of elements of a variable with respect to which results are differentiated.
    fn known(&self, reference: fmi3ValueReference) -> Result<usize, Refusal> {
        let elements = self.elements_of(reference, Type::Float64)?;
        match elements.first() {
            Item::Column(column) if self.instance.model().table.at(column).role != Role::Output => Ok(elements.len()),
            _ => {
                let text = "is computed: nothing can be differentiated with respect to it";
                refuse(format_args!("{} {text}", self.name(elements)))
            }
        }
    }
}

/// Variables that are differentiated, and those with respect to which.
struct Pair<'a> {
    unknowns: &'a [fmi3ValueReference],
    knowns: &'a [fmi3ValueReference],
}

impl Pair<'_> {
    /// Numbers of elements of both; refuses derivatives that do not exist.
    fn counts(&self, component: &Component) -> Result<[usize; 2], Refusal> {
        let (mut unknowns, mut knowns) = (0, 0);
        for reference in self.unknowns {
            unknowns += component.unknown(*reference)?;
        }
        for reference in self.knowns {
            knowns += component.known(*reference)?;
        }
        Ok([unknowns, knowns])
    }

    /// Computes what the derivatives need; whether time derivatives are among them.
    fn prepare(&self, component: &mut Component) -> Result<bool, Refusal> {
        let needs = component.needs(self.unknowns);
        component.instance.refresh_to(needs).map_err(|fault| component.out_of_domain(fault))?;
        let has_rates = component.items(self.unknowns).any(|item| matches!(item, Item::Derivative(_)));
        if has_rates {
            let is_tried = component.state.is_tried();
            component.instance.rates().map_err(|fault| Refusal::out_of_domain(is_tried, fault))?;
        }
        Ok(has_rates)
    }
}

/// Derivatives in one direction.
struct Slopes<'a> {
    outputs: &'a [Dual],
    rates: &'a [Dual],
}

impl<'a> Slopes<'a> {
    fn of(instance: &'a mut Instance, has_rates: bool, seeds: impl Iterator<Item = (usize, f64)>) -> Slopes<'a> {
        if has_rates {
            let (outputs, rates) = instance.derivatives(seeds);
            Slopes { outputs, rates }
        } else {
            Slopes { outputs: instance.derivative(seeds), rates: &[] }
        }
    }

    fn at(&self, item: Item) -> f64 {
        match item {
            Item::Derivative(state) => self.rates[state].slope,
            Item::Column(column) => self.outputs[column].slope,
            Item::Time | Item::Indicator(_) | Item::Size(_) => 0.0,
        }
    }
}

/// Says that a derivative is not finite.
#[cold]
fn not_finite(component: &Component, pair: &Pair, at: usize) -> Refusal {
    let mut ends = pair.unknowns.iter().scan(0, |end, reference| {
        *end += component.elements(*reference).map_or(0, super::layout::Elements::len);
        Some((*reference, *end))
    });
    let reference = ends.find(|(_, end)| at < *end).map_or(0, |(reference, _)| reference);
    let text = format_args!("the derivative of value reference {reference} is not finite");
    Refusal::out_of_domain(component.state.is_tried(), Fault::new(text))
}

/// Writes the derivatives of the unknowns in the direction of `seed`.
fn write_directional(component: &mut Component, pair: &Pair, seed: &[f64], sensitivity: &mut [f64]) -> Outcome {
    let has_rates = pair.prepare(component)?;
    let (model, layout) = (component.instance.model(), &component.own.layout);
    let columns = layout.items(model, pair.knowns).filter_map(Item::column);
    let slopes = Slopes::of(&mut component.instance, has_rates, columns.zip(seed.iter().copied()));
    for (item, value) in layout.items(model, pair.unknowns).zip(&mut *sensitivity) {
        *value = slopes.at(item);
    }
    let wrong = sensitivity.iter().position(|value| !value.is_finite());
    wrong.map_or(Ok(()), |at| Err(not_finite(component, pair, at)))
}

/// Writes the sums of the derivatives of the unknowns, weighted by `seed`, with respect to each known.
fn write_adjoint(component: &mut Component, pair: &Pair, seed: &[f64], sensitivity: &mut [f64]) -> Outcome {
    let has_rates = pair.prepare(component)?;
    let (model, layout) = (component.instance.model(), &component.own.layout);
    let mut wrong = None;
    for (column, value) in layout.items(model, pair.knowns).filter_map(Item::column).zip(sensitivity) {
        let slopes = Slopes::of(&mut component.instance, has_rates, [(column, 1.0)].into_iter());
        let mut unknowns = layout.items(model, pair.unknowns).map(|item| slopes.at(item));
        wrong = wrong.or_else(|| unknowns.clone().position(|slope| !slope.is_finite()));
        *value = seed.iter().map(|weight| weight * unknowns.next().unwrap_or_default()).sum();
        if !value.is_finite() {
            wrong = wrong.or(Some(0));
        }
    }
    wrong.map_or(Ok(()), |at| Err(not_finite(component, pair, at)))
}

/// Derivatives of outputs, and of the time derivatives of the states, in a direction of inputs, parameters and states:
/// exact, by automatic differentiation, except for the friction of ShockAbsorber before the run, which is differentiated
/// numerically.
///
/// # Safety
/// `instance` as for every call on an instance; the arrays must have as many elements as their numbers say.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3GetDirectionalDerivative(
    instance: fmi3Instance,
    unknowns: *const fmi3ValueReference,
    nUnknowns: usize,
    knowns: *const fmi3ValueReference,
    nKnowns: usize,
    seed: *const fmi3Float64,
    nSeed: usize,
    sensitivity: *mut fmi3Float64,
    nSensitivity: usize,
) -> fmi3Status {
    // SAFETY: the caller's promises.
    unsafe {
        derivative(
            (instance, Call::GetDirectionalDerivative),
            [(unknowns, nUnknowns), (knowns, nKnowns)],
            (seed, nSeed),
            (sensitivity, nSensitivity),
        )
    }
}

/// Derivatives of a weighted sum of unknowns with respect to each known: the transpose of fmi3GetDirectionalDerivative, as
/// exact, with one evaluation for each known.
///
/// # Safety
/// As for fmi3GetDirectionalDerivative.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3GetAdjointDerivative(
    instance: fmi3Instance,
    unknowns: *const fmi3ValueReference,
    nUnknowns: usize,
    knowns: *const fmi3ValueReference,
    nKnowns: usize,
    seed: *const fmi3Float64,
    nSeed: usize,
    sensitivity: *mut fmi3Float64,
    nSensitivity: usize,
) -> fmi3Status {
    // SAFETY: the caller's promises.
    unsafe {
        derivative(
            (instance, Call::GetAdjointDerivative),
            [(unknowns, nUnknowns), (knowns, nKnowns)],
            (seed, nSeed),
            (sensitivity, nSensitivity),
        )
    }
}

/// Both kinds of derivatives. The seed has a value for each element of the knowns, and the sensitivity one for each of the
/// unknowns; for adjoint derivatives it is the other way round.
///
/// # Safety
/// As for fmi3GetDirectionalDerivative; arrays come with their numbers of elements.
unsafe fn derivative(
    (instance, call): (fmi3Instance, Call),
    [unknowns, knowns]: [(*const fmi3ValueReference, usize); 2],
    seed: (*const fmi3Float64, usize),
    sensitivity: (*mut fmi3Float64, usize),
) -> fmi3Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller promises that many elements.
        let (pair, seed, sensitivity) = unsafe {
            let (unknowns, knowns) = (array(unknowns.0, unknowns.1, "unknowns")?, array(knowns.0, knowns.1, "knowns")?);
            let sensitivity = array_mut(sensitivity.0, sensitivity.1, "sensitivity")?;
            (Pair { unknowns, knowns }, array(seed.0, seed.1, "seed")?, sensitivity)
        };
        let [of_unknowns, of_knowns] = pair.counts(component)?;
        let is_adjoint = call == Call::GetAdjointDerivative;
        let [seeds, sensitivities] = if is_adjoint { [of_unknowns, of_knowns] } else { [of_knowns, of_unknowns] };
        check_count(seed.len(), seeds, "seeds")?;
        check_count(sensitivity.len(), sensitivities, "sensitivities")?;
        let write = if is_adjoint { write_adjoint } else { write_directional };
        write(component, &pair, seed, sensitivity)
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, call, body) }
}

/// Time derivatives of outputs at the present time: order 1 exact, higher orders 0 as no model has them. An order belongs
/// to all elements of its variable.
///
/// # Safety
/// `instance` as for every call on an instance; `valueReferences` and `orders` must have `nValueReferences` elements,
/// `values` `nValues`.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi3GetOutputDerivatives(
    instance: fmi3Instance,
    valueReferences: *const fmi3ValueReference,
    nValueReferences: usize,
    orders: *const fmi3Int32,
    values: *mut fmi3Float64,
    nValues: usize,
) -> fmi3Status {
    let body = |component: &mut Component| {
        // SAFETY: the caller promises that many elements.
        let (references, orders, values) = unsafe {
            let references = array(valueReferences, nValueReferences, "valueReferences")?;
            (references, array(orders, nValueReferences, "orders")?, array_mut(values, nValues, "values")?)
        };
        let mut wanted = 0;
        for (reference, order) in references.iter().zip(orders) {
            component.check_intermediate(*reference)?;
            wanted += component.differentiated(*reference, "is not an output")?;
            if *order < 1 {
                let name = component.name(component.elements(*reference)?);
                return refuse(format_args!("order {order} of {name}: must be >= 1"));
            }
        }
        check_count(nValues, wanted, "values")?;
        write_slopes(component, references, orders, values)
    };
    // SAFETY: the caller's promise about `instance`.
    unsafe { enter(instance, Call::GetOutputDerivatives, body) }
}

/// Writes the time derivatives of outputs.
fn write_slopes(
    component: &mut Component,
    references: &[fmi3ValueReference],
    orders: &[fmi3Int32],
    values: &mut [fmi3Float64],
) -> Outcome {
    component.instance.refresh_to(Computed::Main)?;
    let (model, layout) = (component.instance.model(), &component.own.layout);
    let derivative = component.instance.time_derivative();
    let columns = references.iter().zip(orders).flat_map(|(reference, order)| {
        let elements = layout.find(model, *reference).into_iter().flat_map(super::layout::Elements::iter);
        elements.filter_map(Item::column).map(move |column| (column, *order))
    });
    for ((column, order), value) in columns.zip(values) {
        let slope = derivative[column].slope;
        if !slope.is_finite() {
            return refuse(format_args!("the derivative of {} is not finite", model.table.at(column).path));
        }
        *value = if order == 1 { slope } else { 0.0 };
    }
    Ok(())
}
