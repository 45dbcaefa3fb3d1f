use crate::model::{Derivatives, Law, Meaning, Model, ModelExchange, boolean, real};
use crate::number::{Mask, Scalar};

crate::choices! {
    /// Form of a bump stop's characteristic.
    pub enum BumpMode {
        /// Proportional to its compression.
        Linear,
        /// A power of its compression.
        Power,
        /// A cubic polynomial of its compression.
        Cubic,
    }
}

crate::part! {
    /// Bump stop: rubber that limits the compression.
    BumpStop {
        /// Is there a bump stop?
        enabled: fixed = boolean(true),
        /// Compression from full extension at which the bump stop is touched (default chosen).
        gap: fixed = real("m", 0.040).shown_in("mm"),
        /// Form of the bump stop's characteristic.
        mode: fixed = BumpMode::Linear.start(),
        /// Stiffness: of the linear form, and first coefficient of the cubic one (default chosen).
        k: tunable = real("N/m", 1.5e5).at_least(0.0),
        /// Exponent of the power form (default chosen).
        n: tunable = real("1", 2.2).at_least(1.0),
        /// Compression at which the power form has the force F_ref (default chosen).
        x_ref: tunable = real("m", 0.010).positive().shown_in("mm"),
        /// Force of the power form at x_ref (default chosen).
        F_ref: tunable = real("N", 1500.0).at_least(0.0),
        /// Second coefficient of the cubic form.
        k2: tunable = real("N/m2", 0.0).at_least(0.0),
        /// Third coefficient of the cubic form.
        k3: tunable = real("N/m3", 0.0).at_least(0.0),
        /// Damping while the stop is touched.
        c: tunable = real("N.s/m", 0.0).at_least(0.0),
    }
}

crate::part! {
    /// Rebound stop (top-out): limits the extension.
    ReboundStop {
        /// Is there a rebound stop?
        enabled: fixed = boolean(true),
        /// Compression from full extension at which the rebound stop is touched.
        gap: fixed = real("m", 0.0).shown_in("mm"),
        /// Stiffness (default chosen).
        k: tunable = real("N/m", 1e6).at_least(0.0),
        /// Damping while the stop is touched.
        c: tunable = real("N.s/m", 0.0).at_least(0.0),
    }
}

/// Damping force of a stop, never larger than its elastic force: a stop cannot pull.
fn damping<T: Scalar>(c: T, velocity: T, elastic: T) -> T {
    (c * velocity).limited(elastic.abs())
}

impl<T: Scalar> BumpStop<T> {
    /// Whether the stop is touched.
    pub fn is_active(&self, compression: T) -> T::Mask {
        !self.enabled.vanishes() & compression.above(self.gap)
    }

    /// Force, >= 0, at a compression of the strut and a velocity of extension.
    pub fn force(&self, compression: T, velocity: T) -> T {
        let pressed = || {
            let elastic = self.elastic(compression - self.gap);
            elastic - damping(self.c, velocity, elastic)
        };
        self.is_active(compression).choose(pressed, || T::zero())
    }

    /// Force without damping at a deflection x > 0.
    fn elastic(&self, x: T) -> T {
        let power = || self.F_ref * (x / self.x_ref).powf(self.n);
        let cubic = || x * (self.k + x * (self.k2 + x * self.k3));
        let polynomial = || BumpMode::Cubic.is(self.mode).choose(cubic, || self.k * x);
        BumpMode::Power.is(self.mode).choose(power, polynomial)
    }
}

impl<T: Scalar> ReboundStop<T> {
    /// Force, <= 0, at a compression of the strut and a velocity of extension.
    pub fn force(&self, compression: T, velocity: T) -> T {
        let pulled = || {
            let elastic = self.k * (compression - self.gap);
            elastic - damping(self.c, velocity, elastic)
        };
        let is_free = self.enabled.vanishes() | compression.at_least(self.gap);
        is_free.choose(|| T::zero(), pulled)
    }
}

crate::model! {
    /// End stops of a shock absorber: bump stop and rebound stop.
    ///
    /// # Equations
    ///
    /// With the compression $u = x - x_b > 0$ of the bump stop:
    ///
    /// ```text
    /// F_b = k_b u                              linear
    /// F_b = F_1 (u / x_1)^n                    power
    /// F_b = k_b u + k_2 u^2 + k_3 u^3          cubic
    /// F_r = k_r (x - x_o)                      where x < x_o, else 0
    /// ```
    ///
    /// Each is reduced by the damping force $c v$, which is limited to the size of the elastic force.
    ///
    /// | symbol | variable              | unit  | meaning                                        |
    /// |--------|-----------------------|-------|------------------------------------------------|
    /// | x      | `compression`         | m     | compression of the strut from full extension   |
    /// | v      | `velocity`            | m/s   | velocity of extension                          |
    /// | x_b    | `bump.gap`            | m     | compression at which the bump stop is touched  |
    /// | x_o    | `rebound.gap`         | m     | compression below which the rebound stop pulls |
    /// | u      | -                     | m     | compression of the bump stop                   |
    /// | k_b    | `bump.k`              | N/m   | stiffness of the bump stop                     |
    /// | k_2    | `bump.k2`             | N/m2  | second coefficient of the cubic form           |
    /// | k_3    | `bump.k3`             | N/m3  | third coefficient of the cubic form            |
    /// | x_1    | `bump.x_ref`          | m     | compression at which the power form has $F_1$  |
    /// | F_1    | `bump.F_ref`          | N     | force of the power form there                  |
    /// | n      | `bump.n`              | 1     | exponent of the power form                     |
    /// | k_r    | `rebound.k`           | N/m   | stiffness of the rebound stop                  |
    /// | c      | `bump.c`, `rebound.c` | N.s/m | damping while a stop is touched                |
    /// | F_b    | `force_bump`          | N     | force of the bump stop                         |
    /// | F_r    | `force_rebound`       | N     | force of the rebound stop                      |
    ///
    /// # Sign
    /// Forces are positive when they push the eyes apart: `force_bump` >= 0, `force_rebound` <= 0.
    ///
    /// # Step
    /// No memory: the forces follow the motion.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// No hysteresis of the rubber beyond the damping.
    ///
    /// # Source
    /// Linear stop: F. Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis,
    /// University of Minho (2024), list of symbols of chapter 9. Cubic form as in the bump stops of Adams. All defaults
    /// are chosen.
    ///
    /// # Example
    /// ```
    /// use stribeck::model::Law;
    /// use stribeck::shock_absorber::EndStops;
    /// let mut stops = EndStops { compression: 0.048, ..Default::default() };
    /// stops.output();
    /// assert!((stops.force_bump - 1200.0).abs() < 1e-9); // 8 mm at 150 N/mm
    /// ```
    EndStops: "Bump stop and rebound stop of a shock absorber" {
        /// Compression from full extension.
        compression: input = real("m", 0.0).shown_in("mm"),
        /// Velocity of extension.
        velocity: input = real("m/s", 0.0).means(Meaning::Velocity),
        /// Bump stop.
        bump: BumpStop,
        /// Rebound stop.
        rebound: ReboundStop,
        /// Force of the bump stop; positive pushes the eyes apart.
        force_bump: output = real("N", 0.0),
        /// Force of the rebound stop; negative pulls the eyes together.
        force_rebound: output = real("N", 0.0),
        /// Is the bump stop touched?
        bump_active: output = boolean(false),
    }
}

impl<T: Scalar> Law for EndStops<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.force_bump = self.bump.force(self.compression, self.velocity);
        self.force_rebound = self.rebound.force(self.compression, self.velocity);
        self.bump_active = T::truth(self.bump.is_active(self.compression));
    }
}

impl<T: Scalar> Derivatives for EndStops<T> {
    /// No state moves with time.
    fn derivatives(&self, _rate: &mut Self) {}
}

impl Model for EndStops {
    fn step(&mut self, _dt: f64) {}
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn forces(x: f64, velocity: f64, set: impl Fn(&mut EndStops)) -> [f64; 2] {
        let mut stops = EndStops { compression: x, velocity, ..Default::default() };
        set(&mut stops);
        stops.output();
        [stops.force_bump, stops.force_rebound]
    }

    /// 1500 N (8 / 10)^2.2, and a polynomial computed by hand: 8 mm of 1e5 u + 2e6 u^2 + 3e8 u^3.
    #[test]
    fn progressive_forms() {
        let power = forces(0.048, 0.0, |stops| stops.bump.mode = 2.0)[0];
        assert_abs_diff_eq!(power, 918.0984, epsilon = 1e-4);
        let cubic = forces(0.048, 0.0, |stops| {
            stops.bump.mode = 3.0;
            (stops.bump.k, stops.bump.k2, stops.bump.k3) = (1e5, 2e6, 3e8);
        })[0];
        assert_abs_diff_eq!(cubic, 800.0 + 128.0 + 153.6, epsilon = 1e-9);
    }

    #[test]
    fn damped_stops_never_pull() {
        for velocity in [-100.0, -0.1, 0.1, 100.0] {
            let [bump, _] = forces(0.041, velocity, |stops| stops.bump.c = 5000.0);
            let [_, rebound] = forces(-0.001, velocity, |stops| stops.rebound.c = 5000.0);
            assert!((0.0..300.001).contains(&bump) && (-2000.001..=0.0).contains(&rebound), "{bump} {rebound}");
        }
        assert_abs_diff_eq!(forces(0.041, -0.01, |stops| stops.bump.c = 5000.0)[0], 200.0, epsilon = 1e-9);
        assert_abs_diff_eq!(forces(-0.001, 0.01, |stops| stops.rebound.c = 5000.0)[1], -1050.0, epsilon = 1e-9);
    }
}
