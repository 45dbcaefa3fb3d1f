//! A law led to and fro, and at held velocities: as arrays, in Python and in C.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::json;
use stribeck::instance::Instance;
use stribeck::model::Meaning;
use stribeck::series::set_up;
use stribeck_solve::job::literal;
use stribeck_solve::system::Fault;
use ts_rs::TS;

use crate::answer::{Answer, Text};
use crate::series::{Series, followed, settled};
use crate::values::filled;

/// Samples of a period, periods, and velocities on a curve (chosen).
const PERIOD: usize = 400;
const QUARTER: usize = PERIOD / 4;
const SAMPLES: usize = 2 * PERIOD + 1;
const POINTS: usize = 201;

/// What acts on a law that slides along one line, by the names of its inputs.
const ACROSS: [(&str, f64); 5] =
    [("velocity_y", 0.0), ("velocity_z", 0.0), ("normal_x", 0.0), ("normal_y", 0.0), ("normal_z", 1.0)];

/// A law, its parameters, inputs that are held, and its motion.
#[derive(Clone, Debug, Deserialize, TS)]
#[serde(deny_unknown_fields)]
pub struct Strokes {
    model: String,
    #[serde(default)]
    #[ts(type = "Record<string, Value>")]
    set: BTreeMap<String, toml::Value>,
    #[serde(default)]
    #[ts(type = "Record<string, number>")]
    held: BTreeMap<String, f64>,
    /// Highest velocity of the curve, m/s.
    velocity: f64,
    /// Length of the strokes, m.
    stroke: f64,
    /// Their highest speed, m/s.
    speed: f64,
}

/// Strokes to and fro: interval of the samples in s, and samples of a period.
#[derive(Debug, Serialize, TS)]
pub struct Loop {
    every: f64,
    period: usize,
    /// Parameter with which the law can give back more energy than it took.
    warning: Option<String>,
}

/// Names of the inputs that move, and of the result.
struct Names {
    velocity: String,
    force: String,
    acceleration: Option<String>,
    /// Whether it slides along a line.
    is_along: bool,
}

impl Strokes {
    /// Interval of the samples, s: the speed rises and falls along straight lines, so that a stroke takes 2 s / v.
    fn every(&self) -> f64 {
        4.0 * self.stroke / self.speed / PERIOD as f64
    }

    fn names(&self) -> Result<Names, Fault> {
        let model = self.series(BTreeMap::new(), "").model()?;
        let name = |meaning| model.table.of(meaning).map(|column| model.table.at(column).path.to_string());
        let known = |meaning| {
            let none = || Fault::value(format_args!("{}: has no {meaning:?}: it is no law of friction", model.name));
            name(meaning).ok_or_else(none)
        };
        Ok(Names {
            velocity: known(Meaning::Velocity)?,
            force: known(Meaning::FrictionForce)?,
            acceleration: name(Meaning::Acceleration),
            is_along: name(Meaning::VelocityY).is_none(),
        })
    }

    /// Inputs that are held.
    fn held(&self) -> Result<BTreeMap<String, f64>, Fault> {
        let model = self.series(BTreeMap::new(), "").model()?;
        let across = ACROSS.iter().filter(|(name, _)| model.find(name).is_some());
        let across = across.map(|(name, value)| ((*name).to_owned(), *value));
        Ok(across.chain(self.held.clone()).collect())
    }

    fn series(&self, inputs: BTreeMap<String, Vec<f64>>, result: &str) -> Series {
        Series { model: self.model.clone(), set: self.set.clone(), inputs, results: vec![result.to_owned()] }
    }

    /// The inputs, with a velocity and, where it is one, an acceleration.
    fn led(&self, velocity: Vec<f64>, acceleration: Vec<f64>) -> Result<Series, Fault> {
        let names = self.names()?;
        let mut inputs: BTreeMap<String, Vec<f64>> =
            self.held()?.into_iter().map(|(name, value)| (name, vec![value])).collect();
        inputs.insert(names.velocity, velocity);
        inputs.extend(names.acceleration.map(|name| (name, acceleration)));
        Ok(self.series(inputs, &names.force))
    }

    /// Velocities of the curve, closer together near 0.
    fn velocities(&self) -> Vec<f64> {
        let middle = ((POINTS - 1) / 2) as f64;
        let at = |point: usize| {
            let x = (point as f64 - middle) / middle;
            self.velocity * x * x.abs()
        };
        (0..POINTS).map(at).collect()
    }

    fn speeds(&self) -> Vec<f64> {
        let shape = |at: usize| match (at % PERIOD) as f64 / QUARTER as f64 {
            u if u <= 1.0 => u,
            u if u <= 3.0 => 2.0 - u,
            u => u - 4.0,
        };
        (0..SAMPLES).map(|at| self.speed * shape(at)).collect()
    }

    fn accelerations(&self) -> Vec<f64> {
        let slope = self.speed / (QUARTER as f64 * self.every());
        let is_rising = |at: usize| (at % PERIOD / QUARTER).is_multiple_of(3);
        (0..SAMPLES).map(|at| if is_rising(at) { slope } else { -slope }).collect()
    }

    /// Velocities and forces at held velocities.
    pub fn curve(&self) -> Result<Answer, Fault> {
        let velocities = self.velocities();
        let mut forces = settled(&self.led(velocities.clone(), vec![0.0])?)?;
        Ok(Answer::with(json!({}), vec![velocities, forces.swap_remove(0)]))
    }

    /// Displacements, velocities and forces of the strokes, and the interval between them.
    pub fn strokes(&self) -> Result<Answer, Fault> {
        let (every, speeds) = (self.every(), self.speeds());
        let mut forces = followed(&self.led(speeds.clone(), self.accelerations())?, every)?;
        // Sums of trapezia.
        let ways = std::iter::once(0.0).chain(speeds.windows(2).scan(0.0, |way, pair| {
            *way += 0.5 * (pair[0] + pair[1]) * every;
            Some(*way)
        }));
        let ways = ways.collect();
        let warning = self.warning()?;
        Ok(Answer::with(Loop { every, period: PERIOD, warning }, vec![ways, speeds, forces.swap_remove(0)]))
    }

    fn warning(&self) -> Result<Option<String>, Fault> {
        let series = self.series(BTreeMap::new(), "");
        let mut instance = Instance::new(series.model()?);
        set_up(&mut instance, &series.parameters()?).map_err(Fault::value)?;
        for (name, value) in self.held()? {
            instance.set_by_name(&name, value).map_err(Fault::value)?;
        }
        Ok(instance.model().passivity(instance.row()).map(|warning| warning.to_string()))
    }

    /// The strokes, and the curve of a law along one line, in Python.
    pub fn python(&self) -> Result<String, Fault> {
        let (names, speed) = (self.names()?, format!("{:?}", self.speed));
        let held = self.held()?.into_iter().map(|(name, value)| (name, toml::Value::Float(value)));
        let given = held.chain(self.set.clone());
        let given = given.map(|(name, value)| format!("    \"{name}\": {},\n", literal(&value))).collect::<String>();
        let curve = if names.is_along { self.python_curve() } else { String::new() };
        let slope = format!("speed / ({QUARTER} * dt)");
        let acceleration = format!("acceleration = numpy.where(k // {QUARTER} % 3 == 0, {slope}, -{slope})\n");
        let lead = names.acceleration.as_ref().map_or(String::new(), |name| format!(", {name}=acceleration"));
        let acceleration = if lead.is_empty() { "" } else { &acceleration };
        Ok(self.filled(
            include_str!("strokes.py.in"),
            &[
                ("given", &given),
                ("curve", &curve),
                ("speed", &speed),
                ("acceleration", acceleration),
                ("lead", &lead),
                ("velocity", &names.velocity),
                ("force", &names.force),
            ],
        ))
    }

    fn python_curve(&self) -> String {
        let middle = (POINTS - 1) / 2;
        format!(
            "\nx = (numpy.arange({POINTS}) - {middle}) / {middle}\nheld = {:?} * x * abs(x)  # m/s\nforce = \
             stribeck.force(\"{}\", held, **given)  # N\n",
            self.velocity, self.model
        )
    }

    /// The strokes in C.
    pub fn c(&self) -> Result<Answer, Fault> {
        let (names, speed) = (self.names()?, format!("{:?}", self.speed));
        let series = self.led(vec![0.0], vec![0.0])?;
        let model = series.model()?;
        let named = |(column, value)| (model.table.at(column).path.to_string(), value);
        let values = self.held()?.into_iter().chain(series.parameters()?.into_iter().map(named));
        let line = |(name, value)| format!("    check(stribeck_set_by_name(law, \"{name}\", {value:?}), law);\n");
        let find = |name: &str, place: &str| format!("    check(stribeck_find(law, \"{name}\", {place}), law);\n");
        let acceleration = names.acceleration.as_ref().map_or(String::new(), |name| find(name, "&in[1]"));
        let places = find(&names.velocity, "&in[0]") + &acceleration + &find(&names.force, "&out");
        let text = self.filled(
            include_str!("strokes.c.in"),
            &[
                ("values", &values.map(line).collect::<String>()),
                ("places", &places),
                ("inputs", if names.acceleration.is_some() { "2" } else { "1" }),
                ("speed", &speed),
            ],
        );
        Ok(Answer::plain(Text { text }))
    }

    /// A text with what stands between the marks @.
    fn filled(&self, text: &str, own: &[(&str, &str)]) -> String {
        let every = format!("{:?}", self.every());
        let [samples, period, quarter] = [SAMPLES, PERIOD, QUARTER].map(|count| count.to_string());
        let common = [
            ("model", &self.model),
            ("every", &every),
            ("samples", &samples),
            ("period", &period),
            ("quarter", &quarter),
        ];
        let common = common.map(|(name, value)| (name, value.as_str()));
        filled(text, &[own, &common].concat())
    }
}
