//! The response of a law to an experiment, and its sensitivities.
//!
//! Between two samples the law is led at their mean velocity, load and acceleration, which is exact in the displacement, or,
//! if it integrates its rates, along the line from one to the other; at a sample it has those of the sample. A record that
//! begins in motion begins in steady sliding; one that begins at rest begins with the start values of the law, such as
//! unloaded bristles.

use std::convert::Infallible;
use std::ops::ControlFlow;

use stribeck::instance::{Instance, Phase, Refused};
use stribeck::model::{InLanes, Law, Model, ModelType, Steps, Visitor, model_in, model_of};
use stribeck::number::Dual;

use super::Experiment;
use super::map::{Sliding, steady_forces};
use super::ports::{Led, Ports};

impl Ports {
    /// Refuses a motion, a load or a condition that an instance does not take.
    fn check(&self, instance: &mut Instance, experiment: &Experiment) -> Result<(), Refused> {
        let inputs = self.inputs(experiment);
        for most in [f64::min, f64::max] {
            let end = |values: &[f64]| values.iter().copied().fold(values[0], most);
            inputs.iter().try_for_each(|(column, values)| instance.set_column(*column, end(values)))?;
            if !self.led.is_empty() {
                instance.check().map_err(Refused::Value)?;
            }
        }
        Ok(())
    }

    /// Columns of the inputs with the samples of an experiment that lead them.
    fn inputs<'a>(&self, experiment: &'a Experiment) -> Vec<(usize, &'a [f64])> {
        let channel = |led: &Led| Some((led.column, experiment.channel(led.name)?));
        let acceleration = self.acceleration.map(|column| (column, &experiment.acceleration[..]));
        let load = self.load.map(|column| (column, &experiment.normal_force[..]));
        let motion = acceleration.into_iter().chain([(self.velocity, &experiment.velocity[..])]).chain(load);
        motion.chain(self.led.iter().filter_map(channel)).collect()
    }

    /// Columns and values of the inputs in steady sliding.
    fn steady(&self, [v, n]: [f64; 2]) -> Vec<(usize, f64)> {
        let acceleration = self.acceleration.map(|column| (column, 0.0));
        let load = self.load.map(|column| (column, n));
        acceleration.into_iter().chain([(self.velocity, v)]).chain(load).collect()
    }
}

/// Way in m and time in s after which sliding is steady (chosen).
const WAY: f64 = 0.1;
const TIME: f64 = 1.0;

/// An experiment as a law is led through it, with each interval divided into parts.
struct Course<'a> {
    experiment: &'a Experiment,
    ports: &'a Ports,
    inputs: Vec<(usize, &'a [f64])>,
    parts: usize,
}

impl<'a> Course<'a> {
    fn of(ports: &'a Ports, experiment: &'a Experiment, parts: usize) -> Course<'a> {
        Course { experiment, ports, inputs: ports.inputs(experiment), parts }
    }

    /// Time for which the first velocity is held before the record begins, if it begins in motion, or for which a law that
    /// integrates the displacement of its host is held at rest, so that its other inputs have come into effect.
    fn run_up(&self) -> Option<f64> {
        let velocity = self.experiment.velocity[0].abs();
        match self.ports.has_displacement() {
            true => Some(TIME),
            false => self.experiment.begins_in_motion().then(|| f64::max(TIME, WAY / velocity)),
        }
    }

    /// Inputs in the run-up.
    fn before(&self) -> impl Iterator<Item = (usize, f64)> {
        let rests = self.ports.has_displacement();
        let value =
            move |column: usize, values: &[f64]| if rests && column == self.ports.velocity { 0.0 } else { values[0] };
        self.inputs.iter().map(move |(column, values)| (*column, value(*column, values)))
    }

    /// Inputs at a sample.
    fn at(&self, at: usize) -> impl Iterator<Item = (usize, f64)> {
        self.inputs.iter().map(move |(column, values)| (*column, values[at]))
    }

    /// Inputs a share of the way from the sample before to a sample.
    fn between(&self, at: usize, share: f64) -> impl Iterator<Item = (usize, f64)> {
        let mean = move |values: &[f64]| values[at - 1] + share * (values[at] - values[at - 1]);
        self.inputs.iter().map(move |(column, values)| (*column, mean(values)))
    }

    /// Length of each part of the interval that ends at a sample.
    fn length(&self, at: usize) -> f64 {
        let time = &self.experiment.time;
        (time[at] - time[at - 1]) / self.parts as f64
    }

    /// Rates of the inputs in that interval.
    fn slopes(&self, at: usize) -> impl Iterator<Item = (usize, f64)> {
        let time = &self.experiment.time;
        let duration = time[at] - time[at - 1];
        self.inputs.iter().map(move |(column, values)| (*column, (values[at] - values[at - 1]) / duration))
    }
}

/// A contact that is led through an experiment.
trait Contact {
    type Force;
    type Error;

    /// Sets columns of inputs.
    fn drive(&mut self, inputs: impl Iterator<Item = (usize, f64)>) -> Result<(), Self::Error>;

    /// Advances in time.
    fn step(&mut self, dt: f64) -> Result<(), Self::Error>;

    /// Whether its inputs move from sample to sample.
    fn follows_ramps(&self) -> bool;

    /// Advances in time with inputs that move at these rates, if it follows ramps.
    fn ramp(&mut self, slopes: impl Iterator<Item = (usize, f64)>, dt: f64) -> Result<(), Self::Error>;

    /// Friction force at present.
    fn force(&mut self) -> Result<Self::Force, Self::Error>;
}

/// Leads a contact along a course, and hands over its force at each sample; ends early where that is not continued.
fn lead<C: Contact>(
    contact: &mut C,
    course: &Course,
    mut take: impl FnMut(C::Force) -> ControlFlow<()>,
) -> Result<(), C::Error> {
    if let Some(time) = course.run_up() {
        contact.drive(course.before())?;
        contact.step(time)?;
    }
    contact.drive(course.at(0))?;
    let mut next = take(contact.force()?);
    for at in 1..course.experiment.time.len() {
        if next.is_break() {
            break;
        }
        for part in 0..course.parts {
            let begin = if contact.follows_ramps() { 0.0 } else { 0.5 };
            contact.drive(course.between(at, (part as f64 + begin) / course.parts as f64))?;
            if contact.follows_ramps() {
                contact.ramp(course.slopes(at), course.length(at))?;
            } else {
                contact.step(course.length(at))?;
            }
        }
        contact.drive(course.at(at))?;
        next = take(contact.force()?);
    }
    Ok(())
}

/// Forces of a contact at all samples.
fn all<C: Contact>(contact: &mut C, course: &Course) -> Result<Vec<C::Force>, C::Error> {
    let mut found = Vec::with_capacity(course.experiment.time.len());
    lead(contact, course, |force| {
        found.push(force);
        ControlFlow::Continue(())
    })?;
    Ok(found)
}

/// An instance, which refuses what is not finite.
struct Checked<'a> {
    instance: &'a mut Instance,
    force: usize,
    follows_ramps: bool,
}

impl Contact for Checked<'_> {
    type Force = f64;
    type Error = Refused;

    fn drive(&mut self, mut inputs: impl Iterator<Item = (usize, f64)>) -> Result<(), Refused> {
        inputs.try_for_each(|(column, value)| self.instance.set_column(column, value))
    }

    fn step(&mut self, dt: f64) -> Result<(), Refused> {
        self.instance.step(dt).map_err(Refused::NotFinite)
    }

    fn follows_ramps(&self) -> bool {
        self.follows_ramps
    }

    fn ramp(&mut self, mut slopes: impl Iterator<Item = (usize, f64)>, dt: f64) -> Result<(), Refused> {
        slopes.try_for_each(|(column, slope)| self.instance.set_slope(column, slope))?;
        self.step(dt)
    }

    fn force(&mut self) -> Result<f64, Refused> {
        self.instance.get_column(self.force)
    }
}

/// Friction force at the samples of an experiment, with each interval divided into `parts`.
pub(super) fn forces(
    instance: &mut Instance,
    ports: &Ports,
    values: &[(usize, f64)],
    experiment: &Experiment,
    parts: usize,
) -> Result<Vec<f64>, Refused> {
    if experiment.map.is_some() {
        let sliding = Sliding { inputs: &|motion| ports.steady(motion), force: ports.force };
        return steady_forces(instance, &sliding, values, experiment);
    }
    prepare(instance, ports, values, experiment)?;
    let follows_ramps = Plain::of(instance.model()).is_some_and(|plain| plain.ramp.is_some());
    all(&mut Checked { instance, force: ports.force, follows_ramps }, &Course::of(ports, experiment, parts))
}

/// Gives an instance its parameters and the displacement from which an experiment begins, after a look at what the
/// experiment does.
fn prepare(
    instance: &mut Instance,
    ports: &Ports,
    values: &[(usize, f64)],
    experiment: &Experiment,
) -> Result<(), Refused> {
    instance.reset();
    instance.set_all(Phase::Setup, values.iter().copied())?;
    instance.check().map_err(Refused::Value)?;
    instance.set_all(Phase::Setup, ports.displacements.iter().map(|column| (*column, experiment.displacement)))?;
    ports.check(instance, experiment)
}

/// A step of a row with inputs that move at the rates in another row.
type Ramp<T> = fn(&mut [T], &mut [T], f64);

/// Steps and outputs of a law without the checks that an instance makes each time, and without the dissipated energy where
/// that is costly: with the same bits, in less time. Along ramps with more error, in less time.
#[derive(Clone, Copy)]
pub(super) struct Plain {
    step: fn(&mut [f64], &mut [f64], f64),
    /// Step with inputs that move at rates.
    ramp: Option<Ramp<f64>>,
    output: fn(&mut [f64], &mut [f64]),
    memory_in_use: fn(&mut [f64]) -> usize,
}

impl Plain {
    /// Those of a law.
    pub fn of(law: &ModelType) -> Option<Plain> {
        struct Search<'a>(&'a str, Option<Plain>);
        impl Visitor for Search<'_> {
            fn visit<M: Model>(&mut self) {
                if M::NAME == self.0 {
                    self.1 = Some(Plain {
                        step: |row, memory, dt| model_of::<M>(row).step_without_energy(memory, dt),
                        ramp: M::COARSE_RAMP.map(|_| ramp::<M> as Ramp<f64>),
                        output: |row, memory| model_of::<M>(row).output_with(memory),
                        memory_in_use: |row| model_of::<M>(row).memory_in_use(),
                    });
                }
            }
        }
        let mut search = Search(law.name, None);
        stribeck::catalogue::visit(&mut search);
        search.1
    }

    /// Hands over the forces of [`forces`] one by one, until that is not continued. False if the law does not take the
    /// parameters or the motion, or if a result is not finite.
    pub fn lead(
        self,
        instance: &mut Instance,
        ports: &Ports,
        values: &[(usize, f64)],
        (experiment, parts): (&Experiment, usize),
        mut take: impl FnMut(f64) -> ControlFlow<()>,
    ) -> bool {
        if prepare(instance, ports, values, experiment).is_err() {
            return false;
        }
        let mut row = instance.row().to_vec();
        let memory = vec![0.0; (self.memory_in_use)(&mut row)];
        let Plain { step, ramp, output, .. } = self;
        let ramp = ramp.map(|ramp| (ramp, vec![0.0; row.len()]));
        let mut contact = Unchecked { step, ramp, output, force: ports.force, row, memory };
        let mut is_finite = true;
        let Ok(()) = lead(&mut contact, &Course::of(ports, experiment, parts), |force: f64| {
            is_finite &= force.is_finite();
            if is_finite { take(force) } else { ControlFlow::Break(()) }
        });
        is_finite && contact.row.iter().chain(&contact.memory).all(|value| value.is_finite())
    }
}

fn ramp<M: Model>(row: &mut [f64], slope: &mut [f64], dt: f64) {
    if let Some(ramp) = M::COARSE_RAMP {
        ramp(model_of(row), model_of(slope), dt);
    }
}

/// A law without checks, in plain or dual numbers.
struct Unchecked<T> {
    step: fn(&mut [T], &mut [T], f64),
    /// Step along ramps, if it makes them, and a row for their rates.
    ramp: Option<(Ramp<T>, Vec<T>)>,
    output: fn(&mut [T], &mut [T]),
    force: usize,
    row: Vec<T>,
    memory: Vec<T>,
}

impl<T: Copy + From<f64>> Contact for Unchecked<T> {
    type Force = T;
    type Error = Infallible;

    fn drive(&mut self, inputs: impl Iterator<Item = (usize, f64)>) -> Result<(), Infallible> {
        inputs.for_each(|(column, value)| self.row[column] = value.into());
        Ok(())
    }

    fn step(&mut self, dt: f64) -> Result<(), Infallible> {
        (self.step)(&mut self.row, &mut self.memory, dt);
        Ok(())
    }

    fn follows_ramps(&self) -> bool {
        self.ramp.is_some()
    }

    fn ramp(&mut self, slopes: impl Iterator<Item = (usize, f64)>, dt: f64) -> Result<(), Infallible> {
        if let Some((ramp, rates)) = &mut self.ramp {
            slopes.for_each(|(column, slope)| rates[column] = slope.into());
            ramp(&mut self.row, rates, dt);
        }
        Ok(())
    }

    fn force(&mut self) -> Result<T, Infallible> {
        (self.output)(&mut self.row, &mut self.memory);
        Ok(self.row[self.force])
    }
}

/// A law whose steps are written for every number: its response carries exact derivatives.
#[derive(Clone, Copy)]
pub(super) struct Exact {
    step: fn(&mut [Dual], &mut [Dual], f64),
    output: fn(&mut [Dual], &mut [Dual]),
}

impl Exact {
    /// None for a law whose steps have modes: its sensitivities are differences.
    pub fn of(law: &ModelType) -> Option<Exact> {
        struct Search<'a>(&'a str, Option<Exact>);
        impl Visitor for Search<'_> {
            fn visit<M: Model>(&mut self) {}

            fn visit_in_lanes<M: InLanes>(&mut self) {
                if M::NAME == self.0 {
                    self.1 = Some(Exact {
                        step: |row, _, dt| Steps::advance(model_in::<M, Dual>(row), Dual::from(dt)),
                        output: |row, _| Law::output(model_in::<M, Dual>(row)),
                    });
                }
            }
        }
        let mut search = Search(law.name, None);
        stribeck::catalogue::visit(&mut search);
        search.1
    }

    /// As [`forces`], with its derivative in the direction of `seeds` (column, component), from the row of an instance
    /// that has the values of the parameters.
    pub fn forces(
        self,
        start: &[f64],
        ports: &Ports,
        seeds: &[(usize, f64)],
        experiment: &Experiment,
        parts: usize,
    ) -> Vec<Dual> {
        let mut row: Vec<Dual> = start.iter().map(|value| Dual::from(*value)).collect();
        for (column, component) in seeds {
            row[*column].slope += component;
        }
        for column in &ports.displacements {
            row[*column] = experiment.displacement.into();
        }
        let (Exact { step, output }, force) = (self, ports.force);
        let mut contact = Unchecked { step, ramp: None, output, force, row, memory: Vec::new() };
        let Ok(found) = all(&mut contact, &Course::of(ports, experiment, parts));
        found
    }
}

#[cfg(test)]
mod tests {
    use stribeck::catalogue::by_name;

    use super::super::laws;
    use super::super::tests::standard;
    use super::*;

    /// Forces without checks; None if the law does not take something, or if a result is not finite.
    fn plain(
        law: &'static ModelType,
        values: &[(usize, f64)],
        experiment: &Experiment,
        parts: usize,
    ) -> Option<Vec<f64>> {
        let mut found = Vec::new();
        let take = |force: f64| {
            found.push(force);
            ControlFlow::Continue(())
        };
        let ports = &Ports::of(law).unwrap();
        let is_led = Plain::of(law).unwrap().lead(&mut Instance::new(law), ports, values, (experiment, parts), take);
        is_led.then_some(found)
    }

    #[test]
    fn a_law_without_checks_gives_the_bits_of_an_instance() {
        let experiment = standard(600);
        // Elements beyond those of the table are in the memory of an instance.
        let many = |law: &ModelType| {
            let values = [("distribution", 2.0), ("element_count", 100.0)];
            let found = values.into_iter().map(|(name, value)| Some((law.find(name)?, value)));
            found.collect::<Option<Vec<_>>>().filter(|_| law.memory > 0)
        };
        assert!(laws().any(|law| many(law).is_some()));
        let other = |law: &ModelType| law.find("variant").map(|column| vec![(column, 2.0)]);
        assert!(laws().filter(|law| other(law).is_some()).count() > 2);
        for law in laws() {
            for values in [vec![]].into_iter().chain(many(law)).chain(other(law)) {
                for parts in [1, 3] {
                    let ports = &Ports::of(law).unwrap();
                    let checked = forces(&mut Instance::new(law), ports, &values, &experiment, parts).unwrap();
                    assert_eq!(plain(law, &values, &experiment, parts).unwrap(), checked, "{} {parts}", law.name);
                }
            }
        }
    }

    /// A law that integrates its rates is led along lines, whose division changes nothing; without checks it is as near as
    /// no noise ever is.
    #[test]
    fn a_law_that_integrates_its_rates_is_led_along_lines() {
        let law = by_name("MagnetorheologicalDamper").unwrap();
        let (ports, experiment) = (Ports::of(law).unwrap(), standard(200));
        let values = [(law.find("voltage").unwrap(), 1.5)];
        let [whole, divided] =
            [1, 3].map(|parts| forces(&mut Instance::new(law), &ports, &values, &experiment, parts).unwrap());
        let most = whole.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
        let apart =
            |other: &[f64]| whole.iter().zip(other).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) / most;
        assert!(apart(&divided) < 1e-8, "{}", apart(&divided));
        let quick = plain(law, &values, &experiment, 1).unwrap();
        assert!(quick != whole && apart(&quick) < 1e-5, "{}", apart(&quick));
    }

    #[test]
    fn what_an_instance_refuses_is_not_led_to_its_end() {
        let law = by_name("LuGre").unwrap();
        let pulled = Experiment { normal_force: vec![-1.0; 50], ..standard(50) };
        let huge = Experiment { velocity: vec![1e308; 50], ..standard(50) };
        let column = |name: &str| law.find(name).unwrap();
        let levels = [(column("mu_s"), 0.1), (column("mu_k"), 0.2)];
        for (values, experiment) in
            [(&[][..], &pulled), (&[(column("viscous_coefficient"), 1e10)], &huge), (&levels, &standard(50))]
        {
            assert!(forces(&mut Instance::new(law), &Ports::of(law).unwrap(), values, experiment, 1).is_err());
            assert_eq!(plain(law, values, experiment, 1), None);
        }
    }
}
