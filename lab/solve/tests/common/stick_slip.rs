//! Stick-slip of a block on a belt in closed form.

use std::f64::consts::PI;

/// Stick and slip of a block with kinetic and static friction in closed form: the block is carried by the belt until the
/// spring pulls with f_s, slides along a cosine about f_C / k, and is caught at belt speed.
pub struct StickSlip {
    pub w: f64,
    centre: f64,
    excess: f64,
    pub first_slip: f64,
    pub slip: f64,
    pub period: f64,
}

/// Velocity of the belt.
pub const BELT: f64 = 0.1;

impl StickSlip {
    /// Table 6.1 of the thesis.
    pub fn table_6_1() -> StickSlip {
        let (k, coulomb, breakaway): (f64, f64, f64) = (2.0, 0.981, 1.4715);
        let w = k.sqrt();
        let excess = (breakaway - coulomb) / k;
        let slip = 2.0 / w * (PI - (excess * w / BELT).atan());
        let period = 2.0 * excess / BELT + slip;
        StickSlip { w, centre: coulomb / k, excess, first_slip: breakaway / k / BELT, slip, period }
    }

    pub fn position(&self, time: f64) -> f64 {
        if time < self.first_slip {
            return BELT * time;
        }
        let since = (time - self.first_slip) % self.period;
        if since < self.slip {
            let phase = self.w * since;
            self.centre + self.excess * phase.cos() + BELT / self.w * phase.sin()
        } else {
            self.centre - self.excess + BELT * (since - self.slip)
        }
    }
}
