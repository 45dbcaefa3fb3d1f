//! Frame of a diagram: its grid, axes and numbers.

use std::fmt::Write;

use crate::axis::Axis;
use crate::curve::Point;

/// Edges of the frame in units of the drawing, downwards from its upper left corner.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Left edge.
    pub left: f64,
    /// Right edge.
    pub right: f64,
    /// Upper edge.
    pub top: f64,
    /// Lower edge.
    pub bottom: f64,
}

impl Frame {
    /// Place of a part of the horizontal axis.
    pub fn across(&self, part: f64) -> f64 {
        self.left + part * (self.right - self.left)
    }

    /// Place of a part of the vertical axis.
    pub fn up(&self, part: f64) -> f64 {
        self.bottom - part * (self.bottom - self.top)
    }

    /// Place of a pair of values.
    pub fn place(&self, axes: &[Axis; 2], [x, y]: Point) -> Point {
        [self.across(axes[0].place(x)), self.up(axes[1].place(y))]
    }

    /// Path data of a line at each tick.
    pub fn grid(&self, axes: &[Axis; 2]) -> String {
        let upright = axes[0].ticks().map(|(part, _)| self.upright(part));
        upright.chain(axes[1].ticks().map(|(part, _)| self.level(part))).collect()
    }

    /// Path data of the left and the lower edge.
    pub fn edges(&self) -> String {
        let Frame { left, right, top, bottom } = self;
        format!("M{left:.2} {top}V{bottom}H{right:.2}")
    }

    /// Path data of the line where the values of the horizontal axis are zero, if it is inside the frame.
    pub fn zero_across(&self, axes: &[Axis; 2]) -> String {
        axes[0].zero().map_or(String::new(), |part| self.upright(part))
    }

    /// Path data of the line where the values of the vertical axis are zero, if it is inside the frame.
    pub fn zero_up(&self, axes: &[Axis; 2]) -> String {
        axes[1].zero().map_or(String::new(), |part| self.level(part))
    }

    /// Numbers of the horizontal axis as text elements, with their baseline this far below the frame.
    pub fn numbers_across(&self, axes: &[Axis; 2], below: f64) -> String {
        let y = self.bottom + below;
        let mut svg = String::new();
        for (part, text) in axes[0].ticks() {
            // Writing to a String cannot fail.
            let _ = writeln!(svg, "<text x=\"{:.2}\" y=\"{y}\">{text}</text>", self.across(part));
        }
        svg
    }

    /// Numbers of the vertical axis as text elements, this far to the left of the frame, with their baselines so much
    /// below their ticks that they are level with them.
    pub fn numbers_up(&self, axes: &[Axis; 2], beside: f64, below: f64) -> String {
        let x = self.left - beside;
        let mut svg = String::new();
        for (part, text) in axes[1].ticks() {
            let _ = writeln!(svg, "<text x=\"{x:.2}\" y=\"{:.2}\">{text}</text>", self.up(part) + below);
        }
        svg
    }

    fn upright(&self, part: f64) -> String {
        format!("M{:.2} {}V{}", self.across(part), self.top, self.bottom)
    }

    fn level(&self, part: f64) -> String {
        format!("M{:.2} {:.2}H{:.2}", self.left, self.up(part), self.right)
    }
}
