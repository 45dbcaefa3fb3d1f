//! Code shared by several test programs: a model driven by the names of its variables, and the belt benchmark.
#![allow(dead_code, reason = "each test program uses a part of it")]

pub mod importer;
pub mod random;
pub mod rows;
pub mod thesis;

use std::ptr::null_mut;

use stribeck::catalogue::{self, Family};
use stribeck::instance::Instance;
use stribeck::model::{Meaning, ModelType};
use stribeck_ffi::fmi2::types::{fmi2CallbackFunctions, fmi2EventInfo, fmi2False};

/// A struct that an importer passes to be filled in by an event.
pub const NO_EVENT: fmi2EventInfo = fmi2EventInfo {
    newDiscreteStatesNeeded: fmi2False,
    terminateSimulation: fmi2False,
    nominalsOfContinuousStatesChanged: fmi2False,
    valuesOfContinuousStatesChanged: fmi2False,
    nextEventTimeDefined: fmi2False,
    nextEventTime: 0.0,
};

/// Callbacks of an importer without a logger and without its own memory functions.
pub const NO_CALLBACKS: fmi2CallbackFunctions = fmi2CallbackFunctions {
    logger: None,
    allocateMemory: None,
    freeMemory: None,
    stepFinished: None,
    componentEnvironment: null_mut(),
};

/// Laws of sliding along a line.
pub fn scalar_laws() -> impl Iterator<Item = &'static ModelType> {
    let slides =
        |law: &&ModelType| law.table.of(Meaning::KineticLevel).is_some() && law.table.of(Meaning::VelocityY).is_none();
    catalogue::documented(Family::Friction).map(|(law, _)| law).filter(slides)
}

/// Those that a contact of a strut can have: it sets one level for both directions and all speeds, and none without load.
pub fn laws_of_strut() -> impl Iterator<Item = &'static ModelType> {
    let levels = |law: &ModelType| law.table.iter().filter(|one| one.meaning == Meaning::KineticLevel).count();
    scalar_laws().filter(move |law| {
        let others = [Meaning::Preload, Meaning::ReferenceSpeed];
        levels(law) == 1 && others.into_iter().all(|other| law.table.of(other).is_none())
    })
}

/// Laws that know the mass of a body and hold it at rest, without a band in which it creeps.
pub fn holding_laws() -> impl Iterator<Item = &'static str> {
    let holds = |law: &&'static ModelType| {
        law.table.of(Meaning::Mass).is_some() && law.check_without_events(Instance::new(law).row()).is_err()
    };
    scalar_laws().filter(holds).map(|law| law.name)
}

/// A live model, driven by names.
pub struct Bench {
    pub instance: Instance,
}

impl Bench {
    /// A model that makes steps.
    pub fn new(model: &str, values: &[(&str, f64)]) -> Bench {
        Bench::of(Instance::new, model, values)
    }

    /// A model whose states a solver integrates.
    pub fn for_model_exchange(model: &str, values: &[(&str, f64)]) -> Bench {
        Bench::of(Instance::for_model_exchange, model, values)
    }

    fn of(make: fn(&'static ModelType) -> Instance, model: &str, values: &[(&str, f64)]) -> Bench {
        let model = catalogue::by_name(model).unwrap_or_else(|| panic!("no model {model}"));
        let mut bench = Bench { instance: make(model) };
        for (name, value) in values {
            bench.set(name, *value);
        }
        bench
    }

    pub fn column(&self, name: &str) -> usize {
        let model = self.instance.model();
        model.find(name).unwrap_or_else(|| panic!("{} has no {name}", model.name))
    }

    pub fn has(&self, name: &str) -> bool {
        self.instance.model().find(name).is_some()
    }

    pub fn set(&mut self, name: &str, value: f64) {
        self.instance.set_by_name(name, value).unwrap_or_else(|refused| panic!("{refused}"));
    }

    /// Sets the kinetic coefficient of friction, of either direction; of a wheel, that of its rolling resistance.
    pub fn set_coefficient(&mut self, coefficient: f64) {
        if self.has("lever_arm") {
            return self.set("lever_arm", coefficient * 0.3);
        }
        for column in self.columns_of(Meaning::KineticLevel) {
            self.instance.set_column(column, coefficient).unwrap_or_else(|refused| panic!("{refused}"));
        }
    }

    /// The variables that play a part: one of each direction where a law differs by direction.
    pub fn columns_of(&self, meaning: Meaning) -> Vec<usize> {
        let variables = self.instance.model().variables();
        variables.filter(|(_, variable)| variable.meaning == meaning).map(|(column, _)| column).collect()
    }

    /// The value of the variable that plays a part, if there is one; of several the largest.
    pub fn of_meaning(&mut self, meaning: Meaning) -> Option<f64> {
        let columns = self.columns_of(meaning);
        let value = |column| self.instance.get_column(column).unwrap_or_else(|refused| panic!("{refused}"));
        columns.into_iter().map(value).reduce(f64::max)
    }

    pub fn get(&mut self, name: &str) -> f64 {
        self.instance.get_by_name(name).unwrap_or_else(|refused| panic!("{refused}"))
    }

    pub fn step(&mut self, dt: f64) {
        self.instance.step(dt).unwrap_or_else(|fault| panic!("{fault}"));
    }
}

/// Order in which the master exchanges values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exchange {
    /// Friction first, then the host with its force.
    Sequential,
    /// The force is read right after the inputs are set; then both step.
    FeedThrough,
    /// All values are exchanged, then both step.
    Parallel,
}

/// One communication point of a run.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    pub time: f64,
    pub position: f64,
    pub velocity: f64,
    pub external_force: f64,
    pub friction_force: f64,
}

/// The belt benchmark of the thesis (Table 6.1) in co-simulation: the same exchange as any master makes.
pub fn belt(friction: &mut Bench, h: f64, end: f64, exchange: Exchange) -> Vec<Sample> {
    belt_of_master(friction, h, end, exchange, &[])
}

/// An input, and its slope from the rig at the beginning of a step.
pub type Slope<'a> = (&'a str, fn(&mut Bench) -> f64);

/// The same with a master that gives the slopes of these inputs, as far as it knows them at the beginning of a step:
/// the acceleration of the block under the last friction force, and the effect of its velocity on the spring.
pub fn belt_of_master(friction: &mut Bench, h: f64, end: f64, exchange: Exchange, slopes: &[Slope]) -> Vec<Sample> {
    let mut rig = Bench::new("BeltRig", &[]);
    let needs_load = friction.has("external_force");
    let mut samples = Vec::new();
    let steps = (end / h).round() as usize;
    let mut force = 0.0;
    for k in 0..steps {
        let (velocity, external_force) = (rig.get("velocity"), rig.get("external_force"));
        if exchange == Exchange::Parallel {
            force = friction.get("friction_force");
        }
        friction.set("velocity", velocity);
        if needs_load {
            friction.set("external_force", external_force);
        }
        if exchange == Exchange::FeedThrough {
            force = friction.get("friction_force");
        }
        for (name, slope) in slopes {
            let column = friction.column(name);
            friction.instance.set_slope(column, slope(&mut rig)).unwrap();
        }
        friction.step(h);
        if exchange == Exchange::Sequential {
            force = friction.get("friction_force");
        }
        samples.push(Sample {
            time: k as f64 * h,
            position: rig.get("position"),
            velocity,
            external_force,
            friction_force: force,
        });
        rig.set("friction_force", force);
        rig.step(h);
    }
    samples
}

/// Extrema of the position: (time, position), by a parabola through three samples; `sign` +1 for maxima, -1 for minima.
pub fn extrema(samples: &[Sample], sign: f64) -> Vec<(f64, f64)> {
    samples
        .windows(3)
        .filter(|w| sign * w[1].position >= sign * w[0].position && sign * w[1].position > sign * w[2].position)
        .map(|w| {
            let [a, b, c] = [w[0].position, w[1].position, w[2].position];
            let shift = 0.5 * (a - c) / (a - 2.0 * b + c);
            (w[1].time + shift * (w[2].time - w[1].time), b - 0.25 * (a - c) * shift)
        })
        .collect()
}
