//! Steps that are written once for every number type.

use super::row::view_mut;
use super::{Law, Model};
use crate::numerics::relaxation::Relaxation;
use crate::numerics::vector::Component;

/// A law whose step has no modes that decide the course of the computation: it is written once for every number type.
pub trait Steps: Law {
    /// The work that [`Steps::advance_and_output`] does once instead of twice.
    const SHARED: Shared = Shared::Nothing;

    /// Advances the states by `dt` > 0 while the inputs are held.
    fn advance(&mut self, dt: Self::Number);

    /// [`Steps::advance`], and the outputs after it. To be overridden if both need the same costly term.
    #[inline(always)]
    fn advance_and_output(&mut self, dt: Self::Number) {
        self.advance(dt);
        self.output();
    }

    /// How the state of [`InLanes::RELAXES`] moves in [`Steps::advance`], whatever it is; none if there is no such state.
    #[inline(always)]
    fn relaxation(&self, _dt: Self::Number) -> Option<Relaxation<Self::Number>> {
        None
    }
}

/// The work that a step and the outputs after it have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shared {
    /// Nothing that takes long.
    Nothing,
    /// A costly term.
    Term,
    /// All that takes long: a step without the outputs saves nothing.
    All,
}

/// A model with such steps: it runs on several rows at once, each in a lane of its own, and through dual numbers.
pub trait InLanes: Model {
    /// The same model in another number.
    type Of<T: Component>: Steps<Number = T>;

    /// The column of a state that relaxes linearly over a step with held inputs, if that and the energy are all states, and
    /// if the energy of a step is added to that before.
    const RELAXES: Option<usize> = None;

    /// How the row can be worked on beside others, with its present parameters and states.
    fn fit(&self) -> Fit {
        Fit::Steps
    }
}

/// How a row can be worked on beside others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fit {
    /// Not at all: its steps search for a velocity.
    Alone,
    /// With its steps.
    Steps,
    /// Even without steps: none of its outputs but the energy depends on those before.
    Outputs,
}

/// A row of a model, seen as the model.
#[inline(always)]
pub fn model_of<M: Model>(row: &mut [f64]) -> &mut M {
    view_mut(row)
}

/// A row of a model in any number, seen as the model.
#[inline(always)]
pub fn model_in<M: InLanes, T: Component>(row: &mut [T]) -> &mut M::Of<T> {
    view_mut(row)
}

/// Declares that a model runs in lanes: `in_lanes!(Law)`, and `in_lanes!();` inside `impl Model`, where it takes the
/// steps from [`Steps`]. `in_lanes!(Law, |law| answer)` also says how its rows [fit](InLanes::fit), and `in_lanes!(Law,
/// relaxes state)` which state [relaxes](InLanes::RELAXES).
/// `in_lanes!(without registers);` is for a law whose vectors would be calls in every one of them.
macro_rules! in_lanes {
    ($Law:ident $(, |$law:ident| $fit:expr)? $(, relaxes $state:ident)?) => {
        impl $crate::model::InLanes for $Law {
            type Of<T: $crate::numerics::vector::Component> = $Law<T>;

            $(const RELAXES: Option<usize> = Some(std::mem::offset_of!($Law, $state) / size_of::<f64>());)?

            $(fn fit(&self) -> $crate::model::Fit {
                let $law = self;
                $fit
            })?
        }
    };

    () => {
        const KERNELS: Option<$crate::model::Kernels> = Some($crate::model::Kernels::of::<Self>());

        $crate::model::in_lanes!(without registers);
    };

    (without registers) => {
        fn accept(visitor: &mut impl $crate::model::Visitor) {
            visitor.visit_in_lanes::<Self>();
        }

        fn step(&mut self, dt: f64) {
            $crate::model::Steps::advance(self, dt);
        }

        #[inline(always)]
        fn step_and_output(&mut self, dt: f64) {
            $crate::model::Steps::advance_and_output(self, dt);
        }
    };
}
pub(crate) use in_lanes;
