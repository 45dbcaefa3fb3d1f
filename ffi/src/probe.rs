//! A model for tests: it has features that no shipped model has yet, and it can panic.

use stribeck::model::{CoSimulation, Fault, Law, Model, ModelType, boolean, integer, real};
use stribeck::number::Real;

stribeck::choices! {
    /// Behaviour of the probe in a step.
    pub enum Behaviour {
        /// Adds up its input.
        Integrate,
        /// Panics.
        Panic,
        /// Divides by zero.
        Overflow,
    }
}

stribeck::part! {
    /// A part, repeated and nested.
    Element {
        /// Stiffness of the element.
        stiffness: tunable = real("N/m", 2.0).positive(),
        /// Deflection of the element.
        deflection: state = real("m", 0.0),
    }
}

stribeck::part! {
    /// A part that contains parts.
    Stack {
        /// Its elements.
        element: [Element; 2],
        /// Gap of the stack.
        gap: fixed = real("m", 0.25),
    }
}

stribeck::model! {
    /// A probe.
    Probe: "Model of the tests" {
        /// Rate of the integral.
        rate: input = real("1", 0.0),
        /// Behaviour in a step.
        behaviour: tunable = Behaviour::Integrate.start(),
        /// A whole number.
        count: tunable = integer(3).at_least(0.0).at_most(9.0),
        /// A switch.
        enabled: tunable = boolean(true),
        /// Elements.
        element: [Element; 3] = &[("stiffness", &[5.0])],
        /// A part that contains parts.
        stack: Stack,
        /// The integral.
        integral: state_output = real("1", 0.0),
        /// Twice the integral.
        doubled: output = real("1", 0.0),
    }
}

impl<T: Real> Law for Probe<T> {
    type Interface = CoSimulation;

    fn output(&mut self) {
        self.doubled = self.integral + self.integral;
    }
}

impl Model for Probe {
    fn warning(&self) -> Option<Fault> {
        (self.rate < 0.0).then(|| Fault::new(format_args!("rate = {}: the probe counts up", self.rate)))
    }

    fn step(&mut self, dt: f64) {
        match Behaviour::of(self.behaviour) {
            Behaviour::Integrate => self.integral += self.rate * dt,
            Behaviour::Panic => {
                self.integral = 99.0;
                panic!("the probe was told to panic")
            }
            Behaviour::Overflow => self.integral = 1.0 / 0.0,
        }
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        let change = slope.rate * dt;
        self.rate += 0.5 * change;
        self.step(dt);
        self.rate += 0.5 * change;
    }
}

pub(crate) static MODELS: &[ModelType] = &[ModelType::of::<Probe>()];

#[test]
fn parts_are_flattened_in_the_order_of_the_struct() {
    let names: Vec<String> = MODELS[0].table.iter().map(|variable| variable.path.to_string()).collect();
    assert_eq!(names[4], "element[1].stiffness");
    assert_eq!(names[9], "element[3].deflection");
    assert_eq!(names[12], "stack.element[2].stiffness");
    assert_eq!(names[14], "stack.gap");
    let probe = Probe::default();
    let row = stribeck::model::row_of(&probe);
    assert_eq!(row[14], probe.stack.gap);
    assert_eq!(row[8], probe.element[2].stiffness);
    assert_eq!([row[4], row[6], row[8]], [5.0, 2.0, 2.0]);
    assert_eq!(row.len(), MODELS[0].table.len());
}
