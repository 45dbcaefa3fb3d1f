//! Dimensions of the shock absorber.

use crate::model::{Fault, boolean, real};
use crate::number::{Mask, Scalar};
use crate::shock_absorber::telescopic_joint::Guidance;

crate::part! {
    /// Dimensions.
    Geometry {
        /// Distance of the eyes at full extension (default chosen).
        length_extended: fixed = real("m", 0.200).positive().shown_in("mm"),
        /// Stroke from full extension to full compression.
        stroke: fixed = real("m", 0.055).positive().shown_in("mm"),
        /// Are d_i and d_j derived from length_extended and stroke?
        guidance_derived: fixed = boolean(false),
        /// Positions of rod guide and piston.
        guidance: (Guidance),
        /// Radius of the rod, at the rod guide (default chosen).
        r_1: fixed = real("m", 0.007).at_least(0.0).shown_in("mm"),
        /// Radius of the piston (default chosen).
        r_2: fixed = real("m", 0.0125).at_least(0.0).shown_in("mm"),
    }
}

/// Distance of the rod's eye from the rod guide, and of the piston from the tube's eye, at full compression: parts of
/// the extended length less two strokes (chosen: those of the start values).
const CLEARANCES: [f64; 2] = [2.0 / 9.0, 4.0 / 9.0];

impl<T: Scalar> Geometry<T> {
    /// Extended length less two strokes.
    fn clearance(&self) -> T {
        self.length_extended - T::from(2.0) * self.stroke
    }

    /// Positions of rod guide and piston.
    pub(crate) fn guidance(&self) -> Guidance<T> {
        let Guidance { d_i, d_j, h_reg } = self.guidance;
        let derived = || {
            let compressed = self.length_extended - self.stroke;
            CLEARANCES.map(|part| compressed - T::from(part) * self.clearance())
        };
        let [d_i, d_j] = self.guidance_derived.vanishes().choose_all(|| [d_i, d_j], derived);
        Guidance { d_i, d_j, h_reg }
    }
}

impl Geometry {
    /// Refuses a stroke that leaves no room for a guidance.
    pub(crate) fn check(&self) -> Result<(), Fault> {
        if self.guidance_derived == 0.0 || self.clearance() > 0.0 {
            return Ok(());
        }
        let (stroke, half) = (self.stroke, 0.5 * self.length_extended);
        let text = "half of geom.length_extended, because geom.guidance_derived is true";
        Err(Fault::new(format_args!("geom.stroke = {stroke} m: must be < {half} m, {text}")))
    }
}
