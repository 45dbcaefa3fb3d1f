//! model.png of an FMU, drawn from the model itself: force over velocity for a friction law, a cycle of a part of the
//! shock absorber or of another machine, the motion of a host.

use anyhow::{Context, Result, ensure};
#[cfg(test)]
use stribeck::catalogue;
use stribeck::catalogue::Family;
use stribeck::model::ModelType;
use tiny_skia::{Color, FillRule, LineCap, LineJoin, Paint, PathBuilder, Pixmap, Stroke, Transform};

use crate::page::curve::{Curve, Law};
use crate::page::motion;
use crate::page::sweep;

/// Width and height in pixels.
const SIZE: f32 = 240.0;
/// Space between the edge and the curve.
const MARGIN: f32 = 38.0;
/// Radius of the corners.
const CORNER: f32 = 36.0;
const BACKGROUND: [u8; 3] = [0x12, 0x2b, 0x45];
const AXES: [u8; 3] = [0x4d, 0x6b, 0x8a];
const CURVE: [u8; 3] = [0xff, 0xb0, 0x3b];

/// The icon as PNG.
pub fn png(model: &'static ModelType, family: Family) -> Result<Vec<u8>> {
    let curve = match family {
        Family::Friction => force_over_velocity(model),
        Family::ShockAbsorber | Family::Component => sweep::of(model).map(|sweep| sweep.curve),
        Family::Host => motion::motion(model).map(|motion| motion.values),
    };
    curve.and_then(|curve| draw(&curve)).with_context(|| format!("cannot draw the icon of {}", model.name))
}

/// An oscillating velocity shows the memory of a law that has one.
fn force_over_velocity(model: &'static ModelType) -> Result<Curve> {
    let law = Law::new(model, None)?;
    let range = law.velocity_range()?;
    law.oscillation(range, law.period(range)?.unwrap_or(1.0))
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
        ensure!(max > min, "the curve is constant at {min}");
        Ok(Scale { middle: 0.5 * (min + max), half_range: 0.5 * (max - min) })
    }

    /// Values far outside the curve, such as an origin that it never approaches, are placed on the edge.
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
    fn every_model_has_an_icon_that_can_be_reproduced() {
        for family in [Family::Friction, Family::ShockAbsorber, Family::Host, Family::Component] {
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
