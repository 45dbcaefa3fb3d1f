//! Fitted laws in the formats of other programs, and a list of what those cannot hold.

use std::collections::BTreeMap;

use stribeck::model::{Meaning, ModelType};
use stribeck_solve::job::literal;
use stribeck_solve::system::Fault;
use toml::{Table, Value};

use super::levels::columns_of;
use super::parameter::refused;
use super::{Experiment, Fit, Ports};
use stribeck_measured::Movement;

/// A format of another program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A module of Python that uses stribeck.
    Python,
    /// MuJoCo: a joint with dry friction and damping; for LuGre an actuator `dcmotor` with the law.
    Mujoco,
    /// URDF: a joint with `dynamics`.
    Urdf,
}

impl Format {
    /// The formats with the extensions of their files.
    pub const ALL: [(&'static str, Format); 3] =
        [("py", Format::Python), ("xml", Format::Mujoco), ("urdf", Format::Urdf)];
}

/// A fitted law in a format of another program.
#[derive(Clone, Debug, PartialEq)]
pub struct Exported {
    /// The file.
    pub text: String,
    /// Parameters and facts of the rig that are not in the file, with their values.
    pub lost: Vec<String>,
}

impl Fit {
    /// The law in a format of another program, at the mean normal force of the experiments. An error if the data do not
    /// determine what the format needs.
    pub fn exported(&self, format: Format, experiments: &[Experiment]) -> Result<Exported, Fault> {
        self.refuse_component("a friction law under a normal force")?;
        match format {
            Format::Python => Ok(Exported { text: self.python(), lost: self.undetermined().map(open).collect() }),
            Format::Mujoco => Joint::of(self, experiments).mujoco(),
            Format::Urdf => Joint::of(self, experiments).urdf(),
        }
    }

    /// Whether it is a law of a contact, which has a normal force, and not a component.
    pub fn has_load(&self) -> bool {
        Ports::of(self.law).is_some_and(|ports| ports.load.is_some())
    }

    /// Refuses a component where a law of friction is needed.
    pub fn refuse_component(&self, needed: &str) -> Result<(), Fault> {
        let why = format_args!("the file is for {needed}, and it has none: write a parameter set, .csv or .ssv");
        if self.has_load() { Ok(()) } else { Err(refused(self.law, why)) }
    }

    fn python(&self) -> String {
        let values: Table = self.accepted().into_iter().map(|(name, value)| (name, Value::Float(value))).collect();
        let (law, values) = (self.law.name, literal(&Value::Table(values)));
        format!(
            r#""""{law} with fitted parameters, in SI units."""

import stribeck

LAW = "{law}"
VALUES = {values}


def force(velocity, normal_force):
    """Friction force of steady sliding."""
    return stribeck.force(LAW, velocity, normal_force, **VALUES)
"#
        )
    }
}

/// Friction of a joint at one normal force.
struct Joint {
    law: &'static ModelType,
    /// Parameters of the law by name: those of the fit, otherwise the start values.
    values: BTreeMap<String, f64>,
    /// Parameters that the data do not determine.
    open: Vec<String>,
    movement: Movement,
    load: f64,
    mass: f64,
    lost: Vec<String>,
}

impl Joint {
    fn of(fit: &Fit, experiments: &[Experiment]) -> Joint {
        let parameters = fit.law.variables().filter(|(_, variable)| variable.role.is_parameter());
        let mut values: BTreeMap<String, f64> =
            parameters.map(|(_, variable)| (variable.path.to_string(), variable.start)).collect();
        values.extend(fit.accepted());
        let loads: Vec<f64> = experiments.iter().flat_map(|one| one.normal_force.iter().copied()).collect();
        let load = loads.iter().sum::<f64>() / loads.len().max(1) as f64;
        let [mass, offset] = [fit.physical.mass, fit.physical.offset];
        let (mut lost, movement) = (Vec::new(), fit.movement);
        let unit = movement.unit("N");
        if let Some([least, most]) = ends(&loads).filter(|[least, most]| most - least > SAME * most) {
            lost.push(format!("the normal force of {least} to {most} {unit}"));
        }
        if offset != 0.0 {
            lost.push(format!("offset = {offset} {unit}"));
        }
        if fit.physical.gravity != [0.0; 2] {
            let [a, b] = fit.physical.gravity;
            lost.push(format!("the gravity of {a} cos q + {b} sin q {unit}"));
        }
        if mass == 0.0 {
            lost.push(format!("the {}, which is not known: 1 {}", movement.inertia(), movement.unit("kg")));
        }
        let open = fit.undetermined().map(str::to_owned).collect();
        Joint { law: fit.law, values, open, movement, load, mass: if mass > 0.0 { mass } else { 1.0 }, lost }
    }

    /// Names of the parameters that play a part: of a law that differs by direction one of each.
    fn names(&self, meaning: Meaning) -> Vec<String> {
        columns_of(self.law, meaning).map(|column| self.law.table.at(column).path.to_string()).collect()
    }

    fn is_open(&self, name: &str) -> bool {
        self.open.iter().any(|open| open == name)
    }

    /// A value, or 0 if the data do not tell it apart from 0.
    fn or_zero(&mut self, name: &str) -> f64 {
        if self.is_open(name) {
            self.lost.push(open(name));
            return 0.0;
        }
        self.values[name]
    }

    /// The level of friction in N, and the viscous coefficient in N.s/m; of a joint in N.m and N.m.s/rad. The means of
    /// both directions where the law differs by direction.
    fn level_and_damping(&mut self) -> Result<[f64; 2], Fault> {
        let no_level = || refused(self.law, "has no kinetic level, which the file needs");
        let levels = self.names(Meaning::KineticLevel);
        if let Some(level) = levels.iter().find(|level| self.is_open(level)) {
            return Err(refused(self.law, format_args!("{level} is not determined, and the file needs it")));
        }
        let viscous = self.names(Meaning::Viscous);
        let damping: Vec<f64> = viscous.iter().map(|name| self.or_zero(name)).collect();
        let forces: Vec<f64> = levels.iter().map(|level| self.values[level] * self.load).collect();
        // The mean of both directions stands for neither of them.
        let kept = [levels, viscous].into_iter().filter(|names| names.len() == 1);
        self.lose_others(&kept.flatten().collect::<Vec<_>>());
        Ok([mean(&forces).ok_or_else(no_level)?, mean(&damping).unwrap_or(0.0)])
    }

    /// Names what has no place: every other parameter of the contact that is not 0.
    fn lose_others(&mut self, kept: &[String]) {
        const AROUND: [Meaning; 4] = [Meaning::Undeclared, Meaning::Mass, Meaning::Exchange, Meaning::Variant];
        let lost: Vec<String> = self
            .law
            .variables()
            .filter(|(_, variable)| !AROUND.contains(&variable.meaning))
            .map(|(_, variable)| variable.path.to_string())
            .filter(|name| !kept.contains(name) && self.values.get(name).is_some_and(|value| *value != 0.0))
            .map(|name| self.spelled(&name))
            .collect();
        self.lost.extend(lost);
    }

    fn spelled(&self, name: &str) -> String {
        let value = self.values[name];
        if self.is_open(name) { open(name) } else { format!("{name} = {value}") }
    }

    /// An actuator with the law itself, if it is one that MuJoCo has and the data determine it. Its exponent is 2. Before
    /// 4.0 its motor must have a constant, here one that is next to nothing.
    fn lugre(&mut self) -> Option<String> {
        let kept = ["sigma_0", "sigma_1", "mu_k", "mu_s", "stribeck_velocity", "viscous_coefficient"];
        if self.law.name != "LuGre" || kept[..5].iter().any(|name| self.is_open(name)) {
            return None;
        }
        let [stiffness, sigma_1, mu_k, mu_s, speed, _] = kept.map(|name| self.values[name]);
        let damping = self.or_zero("viscous_coefficient");
        let has_its_exponent = self.values["stribeck_exponent"] == 2.0;
        let kept = kept.into_iter().chain(has_its_exponent.then_some("stribeck_exponent"));
        self.lose_others(&kept.map(str::to_owned).collect::<Vec<_>>());
        let [kinetic, breakaway] = [mu_k * self.load, mu_s * self.load];
        Some(format!(
            r#"  <actuator>
    <dcmotor name="friction" joint="contact" input="none" motorconst="1e-9" resistance="1"
             lugre="{stiffness:?} {sigma_1:?} {kinetic:?} {breakaway:?} {speed:?}" damping="{damping:?}"/>
  </actuator>
"#
        ))
    }

    fn mujoco(mut self) -> Result<Exported, Fault> {
        let (joint, actuator) = match self.lugre() {
            Some(actuator) => (String::new(), actuator),
            None => {
                let [level, damping] = self.level_and_damping()?;
                (format!(r#" frictionloss="{level:?}" damping="{damping:?}""#), String::new())
            }
        };
        let (comment, mass) = (self.comment(), self.mass);
        let (kind, body) = match self.movement {
            Movement::Translation => ("slide", format!(r#"geom type="sphere" size="{RADIUS}" mass="{mass:?}""#)),
            Movement::Rotation => {
                ("hinge", format!(r#"inertial pos="0 0 0" mass="1" diaginertia="{mass:?} {mass:?} {mass:?}""#))
            }
        };
        let text = format!(
            r#"{comment}<mujoco model="friction">
  <worldbody>
    <body name="slider">
      <joint name="contact" type="{kind}" axis="1 0 0"{joint}/>
      <{body}/>
    </body>
  </worldbody>
{actuator}</mujoco>
"#
        );
        Ok(Exported { text, lost: self.lost })
    }

    fn urdf(mut self) -> Result<Exported, Fault> {
        let [level, damping] = self.level_and_damping()?;
        self.lost.push("the limits of the joint, which are not known: examples".to_owned());
        let comment = self.comment();
        let (kind, mass, inertia) = match self.movement {
            Movement::Translation => ("prismatic", self.mass, 0.4 * self.mass * RADIUS * RADIUS),
            Movement::Rotation => ("revolute", 1.0, self.mass),
        };
        let text = format!(
            r#"<?xml version="1.0"?>
{comment}<robot name="friction">
  <link name="base"/>
  <link name="slider">
    <inertial>
      <mass value="{mass:?}"/>
      <inertia ixx="{inertia:?}" ixy="0" ixz="0" iyy="{inertia:?}" iyz="0" izz="{inertia:?}"/>
    </inertial>
  </link>
  <joint name="contact" type="{kind}">
    <parent link="base"/>
    <child link="slider"/>
    <axis xyz="1 0 0"/>
    <limit lower="-10" upper="10" effort="1000" velocity="10"/>
    <dynamics damping="{damping:?}" friction="{level:?}"/>
  </joint>
</robot>
"#
        );
        Ok(Exported { text, lost: self.lost })
    }

    fn comment(&self) -> String {
        let lost = if self.lost.is_empty() { "nothing".to_owned() } else { self.lost.join("; ") };
        // Two hyphens would end a comment.
        format!(
            "<!-- {} at {} {}, in SI units. Not carried over: {} -->\n",
            self.law.name,
            self.load,
            self.movement.unit("N"),
            lost.replace("--", "-")
        )
    }
}

/// A parameter without a value.
fn open(name: &str) -> String {
    format!("{name}, which is not determined")
}

/// The mean of some numbers; None without any.
fn mean(numbers: &[f64]) -> Option<f64> {
    (!numbers.is_empty()).then(|| numbers.iter().sum::<f64>() / numbers.len() as f64)
}

/// The least and the largest of some numbers.
fn ends(numbers: &[f64]) -> Option<[f64; 2]> {
    let of = |better: fn(f64, f64) -> f64| numbers.iter().copied().reduce(better);
    Some([of(f64::min)?, of(f64::max)?])
}

/// Radius of the slider, in m (chosen): no friction depends on it.
const RADIUS: f64 = 0.05;

/// Part of a load by which it may vary and count as constant (chosen).
const SAME: f64 = 1e-6;

#[cfg(test)]
mod tests {
    use super::super::tests::{fitted, measured, quick, standard};
    use super::*;

    /// A record with a mean load of 20 N that varies, and its fit.
    fn exported(law: &str, values: &[(&str, f64)], format: Format) -> Result<Exported, Fault> {
        let data = [measured(law, values, &standard(400), 0.001, 1)];
        fitted(law, &data, &quick()).exported(format, &data)
    }

    /// The number of an attribute.
    fn number(text: &str, attribute: &str) -> f64 {
        let (_, after) = text.split_once(&format!(" {attribute}=\"")).unwrap();
        after.split_once('"').unwrap().0.parse().unwrap()
    }

    #[test]
    fn a_joint_has_the_level_at_the_mean_load_and_says_what_it_lost() {
        let values = [("mu_k", 0.2), ("viscous_coefficient", 30.0)];
        let load: f64 = standard(400).normal_force.iter().sum::<f64>() / 400.0;
        for (format, attribute) in [(Format::Mujoco, "frictionloss"), (Format::Urdf, "friction")] {
            let Exported { text, lost } = exported("CoulombViscous", &values, format).unwrap();
            assert!((number(&text, attribute) / (0.2 * load) - 1.0).abs() < 1e-3, "{text}");
            assert!((number(&text, "damping") / 30.0 - 1.0).abs() < 1e-2, "{text}");
            assert!(lost[0].starts_with("the normal force of 15") && lost[1].starts_with("the mass"), "{lost:?}");
            assert!(text.contains(&lost.join("; ")), "{text}");
        }
        let lost = exported("Dahl", &[("mu_k", 0.2), ("sigma_0", 3e4)], Format::Mujoco).unwrap().lost;
        assert!(lost.iter().any(|one| one.starts_with("sigma_0 = ")) && lost.iter().all(|one| !one.contains("mu_k")));
    }

    /// At rest no record tells the level.
    #[test]
    fn a_level_that_is_not_determined_is_refused() {
        let still = standard(400);
        let still = Experiment { velocity: still.velocity.iter().map(|velocity| 1e-6 * velocity).collect(), ..still };
        let data = [measured("LuGre", &[("sigma_0", 1e4)], &still, 0.01, 1)];
        let fit = fitted("LuGre", &data, &quick());
        let fault = fit.exported(Format::Mujoco, &data).unwrap_err().to_string();
        assert_eq!(fault, "LuGre: mu_k is not determined, and the file needs it");
        let Exported { text, lost } = fit.exported(Format::Python, &data).unwrap();
        assert!(lost.contains(&"mu_k, which is not determined".to_owned()) && !text.contains("mu_k"), "{text}");
    }
}
