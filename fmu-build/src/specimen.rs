//! A model for tests: it has every kind of column, nested names, and texts that must be escaped.

use stribeck::model::{CoSimulation, Law, Model, ModelType, boolean, integer, real};
use stribeck::number::{Mask, Real};

stribeck::choices! {
    /// Choices.
    pub enum Behaviour {
        /// At rest.
        Rest,
        /// In motion, "fast" & furious.
        Motion,
    }
}

stribeck::part! {
    /// A part.
    Element {
        /// Stiffness of the element.
        stiffness: tunable = real("N/m", 2.0).positive().nominal(1e3).shown_in("N/mm"),
        /// Deflection of the element.
        deflection: state = real("m", 0.0).nominal(1e-5).shown_in("um"),
    }
}

stribeck::model! {
    /// A specimen.
    ///
    /// | symbol | variable               | meaning           |
    /// |--------|------------------------|-------------------|
    /// | k      | `element[i].stiffness` | a < b & `not one` |
    Specimen: "Model with <every> kind of \"column\" & text" {
        /// A value that is < 1 & > 0, "quoted".
        share: input = real("1", 0.5).at_least(0.0).at_most(1.0),
        /// Is it switched on?
        enabled: input = boolean(true),
        /// Behaviour of the specimen.
        behaviour: fixed = Behaviour::Motion.start(),
        /// A whole number.
        count: tunable = integer(3).at_least(0.0).at_most(9.0),
        /// Elements.
        element: [Element; 2],
        /// A whole number that counts.
        turns: state_output = integer(-7),
        /// Force of the first element, if switched on.
        force: output = real("N", 0.0),
        /// The count, if in motion.
        moves: output = integer(0),
    }
}

impl<T: Real> Law for Specimen<T> {
    type Interface = CoSimulation;

    fn output(&mut self) {
        let element = self.element[0];
        self.force = element.stiffness * element.deflection * self.share * self.enabled;
        self.moves = Behaviour::Motion.is(self.behaviour).choose(|| self.count, T::zero);
    }
}

impl Model for Specimen {
    fn step(&mut self, _dt: f64) {}
}

pub static SPECIMEN: ModelType = ModelType::of::<Specimen>();
