//! Motion of a host, driven by a contact, by struts, or by itself.

use std::f64::consts::TAU;

use anyhow::{Context, Result, ensure};
use stribeck::catalogue;
use stribeck::instance::Instance;
use stribeck::model::{Kind, ModelType, Role};

use crate::page::curve::{Curve, limits};

/// The motion of a host.
pub struct Motion {
    /// The excitation, in words.
    pub with: String,
    /// Columns of its first two outputs, which are states if it has states.
    pub states: [usize; 2],
    /// Times.
    pub times: Vec<f64>,
    /// Values of the states at these times.
    pub values: Curve,
}

/// Simulates a host on its own.
pub fn motion(model: &'static ModelType) -> Result<Motion> {
    const STEP: f64 = 1e-3;
    let is_output = |column: &usize| model.table.at(*column).role.is_output();
    let states: Vec<usize> = (0..model.table.len()).filter(is_output).collect();
    let states = *states.first_chunk().context("a host needs two outputs")?;
    let mut host = Instance::new(model);
    let mut connection = Connection::of(&mut host)?;
    if let Some(lift) = connection.lifted_by() {
        host.set_column(states[0], host.row()[states[0]] + lift)?;
    }
    let mut motion = Motion { with: connection.name(model), states, times: Vec::new(), values: Vec::new() };
    for step in 0..=connection.steps() {
        host.refresh()?;
        motion.times.push(f64::from(step) * STEP);
        motion.values.push(states.map(|column| host.row()[column]));
        let parts = connection.parts();
        for _ in 0..parts {
            host.refresh()?;
            connection.act(&mut host, STEP / f64::from(parts))?;
            host.step(STEP / f64::from(parts))?;
        }
    }
    let [low, high] = limits([&motion.values], 0);
    ensure!(high > low, "it does not move");
    Ok(motion)
}

/// Excitation of a host.
enum Connection {
    Contact(Box<Contact>),
    Struts(Vec<Strut>),
    /// None: it moves by itself.
    Nothing,
}

impl Connection {
    fn of(host: &mut Instance) -> Result<Connection> {
        if host.model().table.iter().all(|variable| variable.role != Role::Input) {
            return Ok(Connection::Nothing);
        }
        let struts = Strut::all(host)?;
        if !struts.is_empty() {
            return Ok(Connection::Struts(struts));
        }
        Ok(Connection::Contact(Box::new(Contact::of(host)?)))
    }

    fn name(&self, host: &ModelType) -> String {
        match self {
            Connection::Contact(contact) => contact.name(host),
            Connection::Struts(_) => "on linear struts (45 kN/m, 1900 N.s/m), released 20 mm above rest".to_owned(),
            Connection::Nothing => "without external excitation".to_owned(),
        }
    }

    /// A belt carries its block away; a car must be lifted to move.
    fn lifted_by(&self) -> Option<f64> {
        match self {
            Connection::Struts(_) => Some(0.02),
            Connection::Contact(_) | Connection::Nothing => None,
        }
    }

    /// Number of steps worth showing.
    fn steps(&self) -> u32 {
        match self {
            Connection::Contact(_) => 40_000,
            Connection::Struts(_) | Connection::Nothing => 1_000,
        }
    }

    /// Number of communication steps from one shown instant to the next: a damper on a mass as small as that of a top mount
    /// needs short ones.
    fn parts(&self) -> u32 {
        match self {
            Connection::Struts(_) => 10,
            Connection::Contact(_) | Connection::Nothing => 1,
        }
    }

    fn act(&mut self, host: &mut Instance, dt: f64) -> Result<()> {
        match self {
            Connection::Contact(contact) => contact.act(host, dt)?,
            Connection::Struts(struts) => struts.iter().try_for_each(|strut| strut.act(host))?,
            Connection::Nothing => {}
        }
        Ok(())
    }
}

/// A linear spring and a linear damper, and the columns of the host to which they are connected.
struct Strut {
    force: usize,
    length: usize,
    velocity: usize,
    /// Force and length at rest.
    rest: [f64; 2],
}

impl Strut {
    /// The front spring of the default parameters, and the mean of the two sides of the default damper.
    const STIFFNESS: f64 = 45_000.0;
    const DAMPING: f64 = 1_900.0;

    /// One strut for every strut force of a host at rest.
    fn all(host: &mut Instance) -> Result<Vec<Strut>> {
        host.refresh()?;
        let model = host.model();
        let names = model.table.iter().map(|variable| variable.path.to_string());
        let corners: Vec<String> =
            names.filter_map(|name| Some(name.strip_suffix("strut_force")?.to_owned())).collect();
        let strut = |corner: &String| {
            let column = |name| model.find(&format!("{corner}{name}")).with_context(|| format!("no {corner}{name}"));
            let (force, length, velocity) = (column("strut_force")?, column("length")?, column("velocity")?);
            Ok(Strut { force, length, velocity, rest: [host.row()[force], host.row()[length]] })
        };
        corners.iter().map(strut).collect()
    }

    fn act(&self, host: &mut Instance) -> Result<()> {
        let [force, length] = self.rest;
        let spring = force + Strut::STIFFNESS * (length - host.row()[self.length]);
        Ok(host.set_column(self.force, spring - Strut::DAMPING * host.row()[self.velocity])?)
    }
}

/// A law of dry friction, and the columns of law and host that are connected by their names.
struct Contact {
    law: Instance,
    to_law: Vec<[usize; 2]>,
    to_host: Vec<[usize; 2]>,
    swung: Option<Swung>,
    time: f64,
}

/// An input of the host that swings between two values.
struct Swung {
    input: usize,
    amplitude: f64,
}

impl Swung {
    /// Those inputs without which a host would rest, and amplitudes at which its contact slips for a part of the time.
    const INPUTS: [(&str, f64); 5] =
        [("angle", 0.2), ("force_1", 3.0), ("drive_force", 0.2), ("target_angle", 1.0), ("target_position", 0.2)];
    /// Period in s.
    const PERIOD: f64 = 10.0;

    fn of(host: &ModelType) -> Option<Swung> {
        let mut inputs = Swung::INPUTS.iter();
        inputs.find_map(|(name, amplitude)| {
            let input = host.find(name).filter(|column| host.table.at(*column).role == Role::Input)?;
            Some(Swung { input, amplitude: *amplitude })
        })
    }

    fn at(&self, time: f64) -> f64 {
        self.amplitude * (TAU * time / Swung::PERIOD).cos()
    }
}

impl Contact {
    fn of(host: &mut Instance) -> Result<Contact> {
        host.refresh()?;
        let model = host.model();
        let law = catalogue::by_name("CoulombStiction").context("no model CoulombStiction")?;
        let (to_law, to_host) = (connections(model, law), connections(law, model));
        let mut contact = Contact { law: Instance::new(law), to_law, to_host, swung: Swung::of(model), time: 0.0 };
        // With the mass of the host the law can hold it at rest.
        let mass = model.find("effective_mass").or_else(|| model.find("mass"));
        if let (Some(of_host), Some(of_law)) = (mass, law.find("mass")) {
            contact.law.set_column(of_law, host.row()[of_host])?;
        }
        contact.swing(host)?;
        Ok(contact)
    }

    fn name(&self, host: &ModelType) -> String {
        let what = "with Coulomb friction and stiction in the contact";
        let Some(Swung { input, amplitude }) = &self.swung else { return what.to_owned() };
        let variable = host.table.at(*input);
        let Kind::Real(unit) = variable.kind else { return what.to_owned() };
        format!("{what}, {} swinging by {amplitude} {} in {} s", variable.path, unit.name, Swung::PERIOD)
    }

    fn swing(&self, host: &mut Instance) -> Result<()> {
        self.swung.as_ref().map_or(Ok(()), |swung| Ok(host.set_column(swung.input, swung.at(self.time))?))
    }

    fn act(&mut self, host: &mut Instance, dt: f64) -> Result<()> {
        self.swing(host)?;
        self.time += dt;
        host.refresh()?;
        self.to_law.iter().try_for_each(|[from, to]| self.law.set_column(*to, host.row()[*from]))?;
        self.law.step(dt)?;
        Ok(self.to_host.iter().try_for_each(|[from, to]| host.set_column(*to, self.law.row()[*from]))?)
    }
}

/// Pairs of an output and the input of the same name.
fn connections(from: &ModelType, to: &ModelType) -> Vec<[usize; 2]> {
    let output = |input: usize| from.table.iter().position(|v| v.role.is_output() && v.path == to.table.at(input).path);
    let inputs = (0..to.table.len()).filter(|column| to.table.at(*column).role == Role::Input);
    inputs.filter_map(|input| Some([output(input)?, input])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::abs_diff_eq;
    use catalogue::by_name;

    #[test]
    fn belt_rig_moves_and_sticks() {
        let motion = motion(by_name("BeltRig").unwrap()).unwrap();
        assert_eq!(motion.values[0], [0.0, 0.1]);
        // It sticks until k x = f_s, that is x = 1.4715 N / 2 N/m.
        let slips = motion.values.iter().find(|value| value[1] < 0.0999).unwrap();
        assert!(abs_diff_eq!(slips[0], 0.73575, epsilon = 1e-3), "{slips:?}");
    }

    /// On a plane that swings by 0.2 rad the block slides near both ends (tan(0.2) = 0.203 > 0.15) and rests before it
    /// turns round: 2.98 s in all, by explicit steps that stop it where its velocity changes sign.
    #[test]
    fn hosts_that_rest_by_themselves_are_swung() {
        for name in ["Incline", "TwoBlocks", "Axis", "ServoArm", "PositionControl"] {
            let motion = motion(by_name(name).unwrap()).unwrap();
            assert!(motion.with.contains(" in 10 s"), "{name}: {}", motion.with);
        }
        let block = motion(by_name("Incline").unwrap()).unwrap();
        let at_rest = block.values.iter().filter(|value| value[1].abs() < 1e-5).count();
        assert!((2_800..3_200).contains(&at_rest), "{at_rest} ms");
    }

    /// A released car swings back to its rest position: through it at 3.8 Hz, a quarter of a period later.
    #[test]
    fn cars_are_let_go() {
        for name in ["QuarterCar", "FourPostCar"] {
            let motion = motion(by_name(name).unwrap()).unwrap();
            assert_eq!(motion.values[0], [0.02, 0.0], "{name}");
            let passes = motion.values.iter().position(|value| value[0] < 0.0).unwrap();
            assert!((66..110).contains(&passes), "{name}: after {passes} ms");
            assert!(motion.values[1_000][0].abs() < 1e-4, "{name}");
        }
    }
}
