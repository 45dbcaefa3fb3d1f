//! model.png of an FMU, drawn from the model itself: force over velocity for a friction law, the motion of a host.

use anyhow::{Context, Result, ensure};
use stribeck::catalogue::{self, Family};
use stribeck::instance::Instance;
use stribeck::model::{Kind, ModelType, Role};
use tiny_skia::{Color, FillRule, LineCap, LineJoin, Paint, PathBuilder, Pixmap, Stroke, Transform};

/// Width and height in pixels.
const SIZE: f32 = 240.0;
/// Space between the edge and the curve.
const MARGIN: f32 = 38.0;
/// Radius of the corners.
const CORNER: f32 = 36.0;
const BACKGROUND: [u8; 3] = [0x12, 0x2b, 0x45];
const AXES: [u8; 3] = [0x4d, 0x6b, 0x8a];
const CURVE: [u8; 3] = [0xff, 0xb0, 0x3b];

/// Points of a curve.
type Curve = Vec<[f64; 2]>;

/// The icon as PNG.
pub fn png(model: &'static ModelType, family: Family) -> Result<Vec<u8>> {
    let curve = match family {
        Family::Friction => force_over_velocity(model),
        Family::Host => motion(model),
    };
    draw(&curve.with_context(|| format!("cannot draw the icon of {}", model.name))?)
        .with_context(|| format!("cannot draw the icon of {}", model.name))
}

fn column(model: &ModelType, name: &str) -> Result<usize> {
    model.find(name).with_context(|| format!("{} has no variable {name}", model.name))
}

fn value(instance: &mut Instance, column: usize) -> Result<f64> {
    instance.refresh()?;
    Ok(instance.row()[column])
}

/// Two periods of a sinusoidal velocity; the second is drawn, when a law with memory has settled.
fn force_over_velocity(model: &'static ModelType) -> Result<Curve> {
    const STEPS: usize = 4000;
    // Of a law in a plane or in space, the first axis.
    let axis = if model.find("velocity").is_some() { "" } else { "_x" };
    let velocity = column(model, &format!("velocity{axis}"))?;
    let force = column(model, &format!("friction_force{axis}"))?;
    let mut law = Instance::new(model);
    let mut curve = Vec::new();
    for step in 0..=2 * STEPS {
        let phase = std::f64::consts::TAU * step as f64 / STEPS as f64;
        law.put(velocity, 5.0 * typical_velocity(model) * phase.sin());
        if step >= STEPS {
            curve.push([value(&mut law, velocity)?, value(&mut law, force)?]);
        }
        law.step(1.0 / STEPS as f64)?;
    }
    Ok(curve)
}

/// The largest velocity among the parameters; 1 mm/s (that of the benchmark's Stribeck curve) for a law without one.
fn typical_velocity(model: &ModelType) -> f64 {
    let is_velocity = |kind| matches!(kind, Kind::Real(unit) if unit.name == "m/s");
    let velocities = model.table.iter().filter(|variable| variable.role.is_parameter() && is_velocity(variable.kind));
    let largest = velocities.map(|variable| variable.start).fold(0.0, f64::max);
    if largest > 0.0 { largest } else { 1e-3 }
}

/// Velocity over position of a host with Coulomb friction in its contact.
fn motion(model: &'static ModelType) -> Result<Curve> {
    const STEP: f64 = 1e-3;
    let states: Vec<usize> =
        (0..model.table.len()).filter(|column| model.table[*column].role == Role::StateOutput).collect();
    let [position, velocity] = *states.first_chunk().context("a host needs two states that are outputs")?;
    let mut host = Instance::new(model);
    let mut contact = Contact::of(model)?;
    let mut curve = Vec::new();
    for _ in 0..40_000 {
        curve.push([value(&mut host, position)?, value(&mut host, velocity)?]);
        contact.act(&mut host, STEP)?;
        host.step(STEP)?;
    }
    Ok(curve)
}

/// A law of dry friction, and the columns of law and host that are connected by their names.
struct Contact {
    law: Instance,
    to_law: Vec<[usize; 2]>,
    to_host: Vec<[usize; 2]>,
}

impl Contact {
    fn of(host: &'static ModelType) -> Result<Contact> {
        let law = catalogue::by_name("CoulombStiction").context("no model CoulombStiction")?;
        let mut contact =
            Contact { law: Instance::new(law), to_law: connections(host, law), to_host: connections(law, host) };
        // With the mass of the host the law can hold it at rest.
        if let Some(mass) = host.find("mass") {
            contact.law.put(column(law, "mass")?, host.table[mass].start);
        }
        Ok(contact)
    }

    fn act(&mut self, host: &mut Instance, dt: f64) -> Result<()> {
        for [from, to] in &self.to_law {
            self.law.put(*to, value(host, *from)?);
        }
        self.law.step(dt)?;
        for [from, to] in &self.to_host {
            host.put(*to, value(&mut self.law, *from)?);
        }
        Ok(())
    }
}

/// Pairs of an output and the input of the same name.
fn connections(from: &ModelType, to: &ModelType) -> Vec<[usize; 2]> {
    let output = |input: usize| from.table.iter().position(|v| v.role.is_output() && v.path == to.table[input].path);
    let inputs = (0..to.table.len()).filter(|column| to.table[*column].role == Role::Input);
    inputs.filter_map(|input| Some([output(input)?, input])).collect()
}

fn draw(curve: &Curve) -> Result<Vec<u8>> {
    let mut canvas = Pixmap::new(SIZE as u32, SIZE as u32).context("no canvas")?;
    let scale = [Scale::of(curve, 0)?, Scale::of(curve, 1)?];
    let at = |point: &[f64; 2]| (scale[0].pixel(point[0]), SIZE - scale[1].pixel(point[1]));
    canvas.fill_path(&rounded_square()?, &paint(BACKGROUND), FillRule::Winding, Transform::identity(), None);
    let (x, y) = at(&[0.0, 0.0]);
    line(&mut canvas, &[(MARGIN / 2.0, y), (SIZE - MARGIN / 2.0, y)], AXES, 3.0)?;
    line(&mut canvas, &[(x, MARGIN / 2.0), (x, SIZE - MARGIN / 2.0)], AXES, 3.0)?;
    line(&mut canvas, &curve.iter().map(at).collect::<Vec<_>>(), CURVE, 9.0)?;
    Ok(canvas.encode_png()?)
}

/// Maps the values of one axis onto pixels, symmetrically about the middle of their range.
struct Scale {
    middle: f64,
    half_range: f64,
}

impl Scale {
    fn of(curve: &Curve, axis: usize) -> Result<Scale> {
        let values = || curve.iter().map(|point| point[axis]);
        let (min, max) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
        ensure!(max > min, "the curve does not move from {min}");
        Ok(Scale { middle: 0.5 * (min + max), half_range: 0.5 * (max - min) })
    }

    /// Values far outside the curve, such as an origin that it never comes near, land on the edge.
    fn pixel(&self, value: f64) -> f32 {
        let share = ((value - self.middle) / self.half_range).clamp(-1.5, 1.5) as f32;
        0.5 * SIZE + share * (0.5 * SIZE - MARGIN)
    }
}

fn paint([red, green, blue]: [u8; 3]) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color(Color::from_rgba8(red, green, blue, 255));
    paint
}

fn rounded_square() -> Result<tiny_skia::Path> {
    let mut path = PathBuilder::new();
    let (near, far) = (CORNER, SIZE - CORNER);
    path.move_to(near, 0.0);
    path.line_to(far, 0.0);
    path.quad_to(SIZE, 0.0, SIZE, near);
    path.line_to(SIZE, far);
    path.quad_to(SIZE, SIZE, far, SIZE);
    path.line_to(near, SIZE);
    path.quad_to(0.0, SIZE, 0.0, far);
    path.line_to(0.0, near);
    path.quad_to(0.0, 0.0, near, 0.0);
    path.close();
    path.finish().context("no outline")
}

fn line(canvas: &mut Pixmap, points: &[(f32, f32)], color: [u8; 3], width: f32) -> Result<()> {
    let mut path = PathBuilder::new();
    let (first, rest) = points.split_first().context("a line needs points")?;
    path.move_to(first.0, first.1);
    rest.iter().for_each(|(x, y)| path.line_to(*x, *y));
    let path = path.finish().context("the line has no length")?;
    let stroke = Stroke { width, line_cap: LineCap::Round, line_join: LineJoin::Round, ..Stroke::default() };
    canvas.stroke_path(&path, &paint(color), &stroke, Transform::identity(), None);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_model_has_an_icon_and_twice_the_same() {
        for family in [Family::Friction, Family::Host] {
            for (model, _) in catalogue::documented(family) {
                let icon = png(model, family).unwrap();
                let pixmap = Pixmap::decode_png(&icon).unwrap();
                assert_eq!((pixmap.width(), pixmap.height()), (240, 240), "{}", model.name);
                let bright = pixmap.pixels().iter().filter(|pixel| pixel.red() > 0xf0).count();
                assert!(bright > 1000, "{}: the curve covers {bright} pixels", model.name);
                assert_eq!(icon, png(model, family).unwrap(), "{}", model.name);
            }
        }
    }
}
