//! Unknowns of a fit: what they are in the law, and the scale on which they are searched.

use std::fmt::Display;

use stribeck::model::{Kind, Meaning, ModelType, Role, Variable};
use stribeck::number::Real;

use super::levels::{kinetic_of, pairs_of_levels};
use super::ports::{Led, Ports};
use super::selection::{OF_RIG, Selection};
use super::{Experiment, tie};
use stribeck_measured::Movement;
use stribeck_solve::system::Fault;

/// Quantity that a parameter stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// A parameter of the law, by its column.
    Column(usize),
    /// d in mu_s = mu_k + d, which keeps the static level above the kinetic one: the columns of both.
    Excess {
        /// Column of mu_s.
        of: usize,
        /// Column of mu_k.
        over: usize,
    },
    /// Mass between load cell and contact.
    Mass,
    /// Constant part of the force of the load cell.
    Offset,
    /// Delay of the motion behind the force.
    Delay,
    /// Gravity of an arm: coefficient of the cosine of its angle.
    Cosine,
    /// The same of the sine.
    Sine,
    /// Torque and angle, which follow from both coefficients.
    Gravity,
}

/// Scale on which a parameter is searched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By its logarithm.
    Logarithmic,
    /// By asinh(p / s): evenly below s, by the logarithm above, so that 0 is included.
    Mixed(f64),
}

impl Scale {
    fn forth(self, value: f64) -> f64 {
        match self {
            Scale::Linear => value,
            Scale::Logarithmic => Real::ln(value),
            Scale::Mixed(small) => {
                let ratio = (value / small).abs();
                Real::ln(ratio + (ratio * ratio + 1.0).sqrt()).copysign(value)
            }
        }
    }

    /// Value and its derivative.
    fn back(self, coordinate: f64) -> [f64; 2] {
        match self {
            Scale::Linear => [coordinate, 1.0],
            Scale::Logarithmic => [Real::exp(coordinate); 2],
            Scale::Mixed(small) => {
                let [up, down] = [Real::exp(coordinate), Real::exp(-coordinate)];
                [0.5 * small * (up - down), 0.5 * small * (up + down)]
            }
        }
    }
}

/// A parameter of a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Name: that of the variable, or of the excess of a static level `mu_s - mu_k`, `mass`, `offset`, `delay`.
    pub name: String,
    /// Unit for a body that slides.
    pub unit: &'static str,
    /// Quantity that it stands for.
    pub target: Target,
    /// The part that it plays in the law.
    pub meaning: Meaning,
    /// Range in which it is searched.
    pub range: [f64; 2],
    /// Scale on which it is searched.
    pub scale: Scale,
}

impl Parameter {
    /// Value at a coordinate from 0 to 1 in the range, and its derivative.
    pub(super) fn value(&self, coordinate: f64) -> [f64; 2] {
        let [low, high] = self.range.map(|end| self.scale.forth(end));
        let [value, slope] = self.scale.back(low + (high - low) * coordinate);
        // Rounding must not lead out of the range.
        [value.clamp(self.range[0], self.range[1]), slope * (high - low)]
    }

    /// Coordinate of a value, from 0 to 1 in the range.
    pub(super) fn coordinate(&self, value: f64) -> f64 {
        let [low, high] = self.range.map(|end| self.scale.forth(end));
        ((self.scale.forth(value.clamp(self.range[0], self.range[1])) - low) / (high - low)).clamp(0.0, 1.0)
    }

    /// Gives it another range.
    fn narrow(&mut self, law: &ModelType, [low, high]: [f64; 2]) -> Result<(), Fault> {
        let refuse = |why| Err(Fault::value(format_args!("{} = {low}:{high}: {why}", self.name)));
        if !(low < high && low.is_finite() && high.is_finite()) {
            return refuse("must be LOW:HIGH with LOW < HIGH, both finite".to_owned());
        }
        match self.target {
            Target::Column(column) if ![low, high].iter().all(|end| law.table.at(column).admits(*end)) => {
                return refuse(format!("both must be {}", law.table.at(column).bound));
            }
            Target::Excess { .. } | Target::Mass if low < 0.0 => return refuse("both must be >= 0".to_owned()),
            _ => {}
        }
        self.range = [low, high];
        if low <= 0.0 && self.scale == Scale::Logarithmic {
            self.scale = Scale::Mixed(1e-3 * high);
        }
        Ok(())
    }

    /// Whether its least value is 0, which no interval then has to exclude.
    pub(super) fn can_be_zero(&self) -> bool {
        self.scale != Scale::Logarithmic && self.range[0] == 0.0
    }

    /// Change of the value that is large: half the range on a linear scale, the value itself on a logarithmic one.
    pub(super) fn large_change(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => 0.5 * (self.range[1] - self.range[0]),
            Scale::Logarithmic => value,
            // A viscous coefficient that makes a tenth of the force at the highest speed.
            Scale::Mixed(small) => value.abs() + 10.0 * small,
        }
    }
}

/// Magnitudes of the experiments, from which ranges follow.
#[derive(Clone, Copy, Debug)]
pub(super) struct Magnitudes {
    movement: Movement,
    force: f64,
    load: f64,
    speed: f64,
    acceleration: f64,
    travel: f64,
    interval: f64,
    duration: f64,
    /// Work of the force as a part of that of the largest one along the whole way.
    dissipated: f64,
    /// Whether they are of maps, which have no way and no time.
    is_map: bool,
    /// Whether the law has a normal force, by which levels are coefficients.
    has_load: bool,
    /// Largest voltage, V; 1 V where the experiments have none.
    voltage: f64,
    /// Largest distance of a condition from its start value, such as a temperature in K; 0 where it does not change.
    condition: f64,
}

/// The same part from which the contact slides (chosen): sliding dissipates most of it, pre-sliding gives much of it back.
const ELASTIC: f64 = 0.3;

impl Magnitudes {
    pub fn of(law: &ModelType, experiments: &[Experiment]) -> Magnitudes {
        let most = |f: &dyn Fn(&Experiment) -> f64| experiments.iter().map(f).fold(f64::MIN_POSITIVE, f64::max);
        let least = |f: &dyn Fn(&Experiment) -> f64| experiments.iter().map(f).fold(f64::INFINITY, f64::min);
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let ports = Ports::of(law);
        let led = || ports.iter().flat_map(|ports| &ports.led);
        let farthest = |led: &Led, from: f64| {
            let of = |one: &Experiment| one.channel(led.name).map_or(0.0, |values| farthest(values, from));
            experiments.iter().map(of).fold(0.0, f64::max)
        };
        let volts = led().filter(|led| led.unit == "V").map(|led| farthest(led, 0.0));
        let conditions = led().filter(|led| !led.is_input && changes(experiments, led));
        Magnitudes {
            has_load: ports.as_ref().is_some_and(|ports| ports.load.is_some()),
            voltage: volts.filter(|volts| *volts > 0.0).reduce(f64::max).unwrap_or(1.0),
            condition: conditions.map(|led| farthest(led, law.table.at(led.column).start)).fold(0.0, f64::max),
            movement: experiments.first().map_or(Movement::Translation, |one| one.movement),
            force: most(&|one| one.force.iter().fold(0.0, |most: f64, force| most.max(force.abs()))),
            load: least(&|one| mean(&one.normal_force)).max(f64::MIN_POSITIVE),
            speed: most(&|one| one.velocity.iter().fold(0.0, |most: f64, v| most.max(v.abs()))),
            acceleration: most(&|one| one.acceleration.iter().fold(0.0, |most: f64, a| most.max(a.abs()))),
            travel: most(&Experiment::travel),
            interval: least(&|one| one.duration() / (one.time.len() - 1) as f64),
            duration: most(&Experiment::duration),
            dissipated: most(&Experiment::dissipated),
            is_map: experiments.iter().any(|one| one.map.is_some()),
        }
    }

    /// Range and scale of a mass, of up to 10 t (chosen), or of a moment of inertia, which may be that of a watch or of a
    /// crane: up to a hundred times what the largest torque would accelerate as in the experiments (chosen).
    fn range_of_mass(&self) -> ([f64; 2], Scale) {
        match self.movement {
            Movement::Translation => ([0.0, 1e4], Scale::Mixed(1.0)),
            Movement::Rotation => {
                let small = 0.01 * self.force / self.acceleration;
                ([0.0, 1e4 * small], Scale::Mixed(small))
            }
        }
    }

    /// Range and scale of a variable, by its unit (chosen: wide enough for any contact that such data can show).
    fn range(&self, variable: &Variable, unit: &str) -> ([f64; 2], Scale) {
        let Magnitudes { force, load, speed, travel, interval, duration, dissipated, is_map, .. } = *self;
        // Strokes within the pre-sliding displacement may start anywhere on the way to sliding.
        let yields = if dissipated < ELASTIC { 0.05 } else { 2.0 };
        let (range, scale) = match unit {
            "m" | "N/m" | "s" if is_map && variable.start > 0.0 => around_start(variable),
            "1/K" if self.condition > 0.0 => ([-1.0 / self.condition, 10.0 / self.condition], Scale::Linear),
            _ if !self.has_load => self.range_without_load(variable, unit),
            "1" if is_level(variable.meaning) => ([0.0, 2.0 * force / load], Scale::Linear),
            "m/s" => ([1e-4 * speed, speed], Scale::Logarithmic),
            "m" => ([1e-5 * travel, 0.5 * travel], Scale::Logarithmic),
            "N/m" => ([yields * force / travel, 1e5 * force / travel], Scale::Logarithmic),
            "N.s/m" => ([0.0, 100.0 * force / speed], Scale::Mixed(0.01 * force / speed)),
            "s/m" if variable.start == 0.0 => {
                let top = 100.0 * force / (load * speed);
                ([0.0, top], Scale::Mixed(1e-4 * top))
            }
            "s/m" => ([0.3 / speed, 1e4 / speed], Scale::Logarithmic),
            "s" => ([0.5 * interval, duration], Scale::Logarithmic),
            "N" => ([0.01 * load, 10.0 * load], Scale::Logarithmic),
            _ if variable.start > 0.0 => around_start(variable),
            _ => ([0.0, 100.0], Scale::Mixed(0.01)),
        };
        let bound = variable.bound;
        let low = if bound.is_positive() && range[0] == 0.0 { 1e-6 * range[1] } else { range[0] };
        ([low.max(bound.min()), range[1].min(bound.max())], scale)
    }
}

impl Magnitudes {
    /// As [`Magnitudes::range`], of a component, which may do without any of its parts (chosen).
    fn range_without_load(&self, variable: &Variable, unit: &str) -> ([f64; 2], Scale) {
        let Magnitudes { force, speed, travel, voltage, .. } = *self;
        let from_zero = |size: f64| ([0.0, 1e3 * size], Scale::Mixed(1e-3 * size));
        match unit {
            "N" => from_zero(force),
            "N/m" => from_zero(force / travel),
            "N.s/m" => from_zero(force / speed),
            "N/(m.V)" => from_zero(force / (travel * voltage)),
            "N.s/(m.V)" => from_zero(force / (speed * voltage)),
            "1/N" => from_zero(1.0 / force),
            "1" if is_level(variable.meaning) => ([0.0, 10.0], Scale::Mixed(1e-3)),
            "m" if variable.bound.min() < 0.0 => ([-100.0 * travel, 100.0 * travel], Scale::Linear),
            "m" => ([1e-5 * travel, 10.0 * travel], Scale::Logarithmic),
            "m/s" => ([1e-4 * speed, speed], Scale::Logarithmic),
            _ if variable.start > 0.0 => around_start(variable),
            _ => ([0.0, 100.0], Scale::Mixed(0.01)),
        }
    }
}

/// Largest distance of values from a value.
fn farthest(values: &[f64], from: f64) -> f64 {
    values.iter().fold(0.0, |most: f64, value| most.max((value - from).abs()))
}

/// Whether a channel changes, within an experiment or from one to another.
fn changes(experiments: &[Experiment], led: &Led) -> bool {
    let mut all = experiments.iter().filter_map(|one| one.channel(led.name)).flatten();
    all.next().is_some_and(|first| all.any(|value| value != first))
}

/// Range of a variable of which the data have no measure.
fn around_start(variable: &Variable) -> ([f64; 2], Scale) {
    ([1e-2 * variable.start, 1e2 * variable.start], Scale::Logarithmic)
}

/// Whether a variable is fitted unless it is named: a real parameter of the contact, no exponent, no share of an
/// element, no speed that another level makes up for, no option that is off at its start value.
fn is_usual(variable: &Variable, magnitudes: &Magnitudes) -> bool {
    let is_off = variable.start == 0.0 && matches!(variable.kind, Kind::Real(unit) if unit.name == "m/s");
    let is_held = match variable.meaning {
        Meaning::Shape | Meaning::ReferenceSpeed | Meaning::Condition => true,
        Meaning::EffectOfCondition => magnitudes.condition == 0.0,
        _ => false,
    };
    is_parameter(variable) && !is_off && !is_held
}

/// Whether it is the coefficient of a level of friction.
pub(super) fn is_level(meaning: Meaning) -> bool {
    [Meaning::KineticLevel, Meaning::StaticLevel, Meaning::Level].contains(&meaning)
}

fn is_parameter(variable: &Variable) -> bool {
    let is_of_contact = ![Meaning::Mass, Meaning::ExternalForce].contains(&variable.meaning);
    variable.role.is_parameter() && matches!(variable.kind, Kind::Real(_)) && !variable.is_hidden && is_of_contact
}

/// The error of a law.
pub(super) fn refused(law: &ModelType, reason: impl Display) -> Fault {
    Fault::value(format_args!("{}: {reason}", law.name))
}

/// Name under which the gravity of an arm is fitted, m g l cos(q - q_0) = a cos q + b sin q.
pub(super) const GRAVITY: &str = "gravity";

/// Its coefficients of cosine and sine.
pub(super) const GRAVITY_COEFFICIENTS: [(&str, Target); 2] =
    [("gravity_cos", Target::Cosine), ("gravity_sin", Target::Sine)];

/// The coefficients that a selection fits.
pub(super) fn fitted_gravity(selection: &Selection) -> impl Iterator<Item = (&'static str, Target)> {
    let is_fitted =
        |(name, _): &(&str, Target)| selection.fits(name) || selection.fits(GRAVITY) && selection.fixed(name).is_none();
    GRAVITY_COEFFICIENTS.into_iter().filter(is_fitted)
}

/// Whether a selection says anything of gravity.
pub(super) fn has_gravity(selection: &Selection) -> bool {
    let is_held = |(name, _): (&str, Target)| selection.fixed(name).is_some();
    fitted_gravity(selection).next().is_some() || GRAVITY_COEFFICIENTS.into_iter().any(is_held)
}

/// The parameters of a law that can be fitted, and the inputs that can be held or fitted instead of measured.
pub(super) fn known(law: &ModelType) -> Vec<(usize, Variable)> {
    let can_be_set = |variable: &Variable| matches!(variable.role, Role::Fixed | Role::Tunable);
    let all = law.variables().filter(|(_, variable)| is_parameter(variable) && can_be_set(variable));
    all.chain(inputs(law)).collect()
}

/// Inputs that a rig may hold, such as a voltage.
fn inputs(law: &ModelType) -> impl Iterator<Item = (usize, Variable)> {
    let led = Ports::of(law).map(|ports| ports.led).unwrap_or_default();
    led.into_iter().filter(|led| led.is_input).map(|led| (led.column, law.table.at(led.column)))
}

/// Name of the excess of a static level over a kinetic one.
fn excess_name(law: &ModelType, of: usize, over: usize) -> String {
    format!("{} - {}", law.table.at(of).path, law.table.at(over).path)
}

/// The parameters of a fit, in the order of the table, then those of the rig; none if all are held.
pub(super) fn parameters(
    law: &ModelType,
    experiments: &[Experiment],
    selection: &Selection,
) -> Result<Vec<Parameter>, Fault> {
    let known = known(law);
    check_names(law, &known, selection)?;
    tie::check(law, &known, selection)?;
    let magnitudes = Magnitudes::of(law, experiments);
    let idle = tie::idle_speeds(law, &tie::columns(law, selection));
    let is_chosen = |(column, variable): &&(usize, Variable)| {
        let name = variable.path.to_string();
        let is_open = selection.fixed(&name).is_none() && !selection.is_tied(&name);
        is_open && (is_usual(variable, &magnitudes) && !idle.contains(column) || selection.fits(&name))
    };
    let chosen = known.iter().filter(is_chosen);
    let mut list: Vec<Parameter> =
        chosen.filter_map(|(column, variable)| of_law(law, *column, variable, &magnitudes)).collect();
    list.extend(of_rig(law, experiments, selection, &magnitudes)?);
    narrow(&mut list, law, selection)?;
    let is_empty = |one: &&Parameter| !(one.range[0] < one.range[1] && one.range[1].is_finite());
    match list.iter().find(is_empty) {
        Some(Parameter { name, range: [low, high], .. }) => {
            Err(refused(law, format_args!("the data give no range for {name} ({low:e} to {high:e}); give one")))
        }
        None => Ok(list),
    }
}

/// The parameter of a column; None if that has no real number.
fn of_law(law: &ModelType, column: usize, variable: &Variable, magnitudes: &Magnitudes) -> Option<Parameter> {
    let Kind::Real(unit) = variable.kind else { return None };
    let (range, scale) = magnitudes.range(variable, unit.name);
    let over = kinetic_of(law, column);
    let (name, target) = match over {
        Some(over) => (excess_name(law, column, over), Target::Excess { of: column, over }),
        None => (variable.path.to_string(), Target::Column(column)),
    };
    Some(Parameter { name, unit: unit.name, target, meaning: variable.meaning, range, scale })
}

/// The range in which a delay is looked for; None if none is. Each record with clocks of its own has another one; the
/// controller of an axis has one.
fn delay_range(experiments: &[Experiment]) -> Result<Option<[f64; 2]>, Fault> {
    let mut ranges = experiments.iter().filter(|one| one.delay_range.is_some());
    let Some(first) = ranges.next() else { return Ok(None) };
    for other in ranges {
        if first.matched_filter.is_none() || other.matched_filter.is_none() {
            return Err(Fault::value(format_args!(
                "{}: its delay is another one than that of {}: look for delays in one record at a time, and give them",
                other.name, first.name
            )));
        }
        if other.delay_range != first.delay_range {
            return Err(Fault::value(format_args!(
                "{}: is sampled at other intervals than {}, so that the controller delays it by another time: fit them \
                 one at a time",
                other.name, first.name
            )));
        }
    }
    Ok(first.delay_range)
}

/// The parameters of the rig.
fn of_rig(
    law: &ModelType,
    experiments: &[Experiment],
    selection: &Selection,
    magnitudes: &Magnitudes,
) -> Result<Vec<Parameter>, Fault> {
    let one = |name: &str, unit, target, range, scale| {
        let (name, meaning) = (name.to_owned(), Meaning::Undeclared);
        Parameter { name, unit, target, meaning, range, scale }
    };
    let mut list = Vec::new();
    if selection.fits("mass") {
        let (range, scale) = magnitudes.range_of_mass();
        list.push(one("mass", "kg", Target::Mass, range, scale));
    }
    if selection.fits_offset(tie::has_open_directions(law, selection)) {
        let range = [-magnitudes.force, magnitudes.force];
        list.push(one("offset", "N", Target::Offset, range, Scale::Linear));
    }
    for (name, target) in fitted_gravity(selection) {
        if experiments.iter().any(|one| one.direction.is_none()) {
            return Err(Fault::value(format_args!("{name}: is fitted to joints whose angle is known")));
        }
        let small = 0.01 * magnitudes.force;
        list.push(one(name, "N", target, [-1e4 * small, 1e4 * small], Scale::Mixed(small)));
    }
    match (delay_range(experiments)?, selection.fixed("delay")) {
        (None, Some(_)) => Err("delay: is held only where it is looked for; otherwise give it with the record"),
        (Some(range), None) => {
            list.push(one("delay", "s", Target::Delay, range, Scale::Linear));
            Ok(list)
        }
        _ if selection.fits("delay") => {
            Err("delay: can be fitted only if it is looked for in the motion of a single record")
        }
        _ => Ok(list),
    }
    .map_err(Fault::value)
}

/// Refuses names that the law does not have, and values at which a parameter cannot be held.
fn check_names(law: &ModelType, known: &[(usize, Variable)], selection: &Selection) -> Result<(), Fault> {
    let names: Vec<String> = known.iter().map(|(_, variable)| variable.path.to_string()).collect();
    let excess: Vec<String> = pairs_of_levels(law).into_iter().map(|[of, over]| excess_name(law, of, over)).collect();
    let ranges = selection.ranges.iter().map(|(name, _)| name).filter(|name| !excess.contains(name));
    let mut named = selection.fixed.iter().map(|(name, _)| name).chain(&selection.fitted).chain(ranges);
    if let Some(name) = named.find(|name| !names.contains(name) && !OF_RIG.contains(&name.as_str())) {
        let all = names.iter().map(String::as_str).chain(OF_RIG);
        return Err(Fault::unknown(format!("{}: parameter", law.name), name, all));
    }
    for (name, value) in &selection.fixed {
        let refuse = |why: std::fmt::Arguments| Err(Fault::value(format_args!("{name} = {value}: {why}")));
        let variable = known.iter().zip(&names).find(|(_, known)| *known == name).map(|((_, variable), _)| variable);
        match variable.filter(|variable| !variable.admits(*value)) {
            _ if selection.fits(name) => return refuse(format_args!("is held, and to be fitted too")),
            Some(variable) => return refuse(format_args!("must be {}", variable.bound)),
            None if name == GRAVITY => {
                return refuse(format_args!("hold gravity_cos and gravity_sin instead"));
            }
            None if !value.is_finite() => return refuse(format_args!("must be a finite number")),
            None => {}
        }
    }
    Ok(())
}

/// Ranges of the user.
fn narrow(list: &mut [Parameter], law: &ModelType, selection: &Selection) -> Result<(), Fault> {
    for (name, range) in &selection.ranges {
        let Some(parameter) = list.iter_mut().find(|parameter| parameter.name == *name) else {
            let pairs = pairs_of_levels(law).into_iter();
            let mut excess =
                pairs.filter(|[of, _]| law.find(name) == Some(*of)).map(|[of, over]| excess_name(law, of, over));
            let how = excess.next().map_or(String::new(), |excess| format!("; it is fitted as '{excess}'"));
            return Err(refused(law, format_args!("{name} has a range and is not fitted{how}")));
        };
        parameter.narrow(law, *range)?;
    }
    Ok(())
}
