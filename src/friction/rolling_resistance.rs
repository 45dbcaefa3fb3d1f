use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::model::{Meaning, Model, real};
use crate::number::Real;

crate::model! {
    /// Resistance of a wheel or a roller: the normal force acts ahead of the centre by a lever arm, and its moment opposes
    /// rolling.
    ///
    /// # Equations
    ///
    /// ```text
    /// M_r = f_n d sgn(v)                  v != 0
    /// f_f = M_r / r
    /// f_f = min(|f_e|, f_r) sgn(f_e)      v  = 0
    /// f_r = f_n d / r
    /// ```
    ///
    /// With `mass` $m > 0$ the force over a step $h$ is that of the velocity $w$ at its end; the jump at rest is part
    /// of $f_f$. Of several solutions it is the first one reached from $v$ in the direction of the acceleration
    /// (implicit Euler; time stepping in the sense of Moreau):
    ///
    /// ```text
    /// m (w - v) / h = f_e - f_f(w)
    /// ```
    ///
    /// | symbol | variable           | unit | meaning                                                    |
    /// |--------|--------------------|------|------------------------------------------------------------|
    /// | v      | `velocity`         | m/s  | velocity of the wheel's centre along the road              |
    /// | f_n    | `normal_force`     | N    | force pressing the wheel on the road                       |
    /// | f_e    | `external_force`   | N    | all other forces that drive the wheel, at its centre       |
    /// | d      | `lever_arm`        | m    | distance of the normal force ahead of the centre           |
    /// | r      | `wheel_radius`     | m    | radius of the wheel                                        |
    /// | m      | `mass`             | kg   | effective mass of the host, 0 = the law alone              |
    /// | h      | `step_size`        | s    | last communication step                                    |
    /// | f_f    | `friction_force`   | N    | resistance at the wheel's centre                           |
    /// | M_r    | `resisting_moment` | N.m  | its moment                                                 |
    ///
    /// The coefficient of rolling resistance is $d / r$. Where only the coefficient is known, set `lever_arm` to its
    /// product with `wheel_radius`.
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` while rolling and the sign of `external_force` at rest; the wheel
    /// feels `-friction_force` and `-resisting_moment`, in the sense of its rotation. Dissipated power is
    /// `friction_force * velocity`, which is the moment times the rate of rotation.
    ///
    /// # Step
    /// As in `Coulomb`: without `mass` the law has no memory, and a host that integrates the wheel itself never reaches
    /// $v = 0$ exactly, so the force of a wheel at rest then alternates. With `mass` the wheel is caught where it comes
    /// to rest, at any step. In Model Exchange it is held or rolls in one direction from one event to the next. A wheel
    /// that is held returns `external_force`: connect it, or it is released and caught again endlessly.
    ///
    /// A wheel of the mass $m_w$ and the moment of inertia $J$ that rolls without slip has the effective mass
    /// $m_w + J / r^2$. A driving moment $M$ belongs to `external_force` as $M / r$.
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// The wheel rolls without slip. The lever arm does not depend on speed, load or temperature. The resistance at rest
    /// is not above that of rolling. `normal_force` = 0 or `lever_arm` = 0 removes the resistance (force 0, not
    /// sticking). The contacts of the strut do not offer this law: their levels are those of sliding.
    ///
    /// # Source
    /// Section 4.1.4 of F. Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis,
    /// University of Minho (2024): $M_r = f_n d$. The force at the centre, the state of rest and the defaults are our
    /// additions; a coefficient of 0.01 is chosen as usual for car tyres. Time stepping: Moreau (1988),
    /// doi:10.1007/978-3-7091-2624-0_1.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::RollingResistance;
    /// use stribeck::model::Law;
    /// let mut wheel = RollingResistance { velocity: 20.0, normal_force: 4000.0, ..Default::default() };
    /// wheel.output();
    /// assert!((wheel.resisting_moment - 12.0).abs() < 1e-12); // 3 mm times 4 kN
    /// assert!((wheel.friction_force - 40.0).abs() < 1e-12); // 1 % of the load
    /// ```
    RollingResistance: "Rolling resistance of a wheel, by its lever arm" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        /// Distance of the normal force ahead of the wheel's centre (default chosen).
        lever_arm: tunable = real("m", 0.003).at_least(0.0).nominal(1e-3).shown_in("mm").means(Meaning::Own),
        /// Radius of the wheel (default chosen).
        wheel_radius: tunable = real("m", 0.3).positive().means(Meaning::Own),
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        /// Moment that opposes rolling.
        resisting_moment: output = real("N.m", 0.0).odd(),
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Curve<T> for RollingResistance<T> {
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        self.level() * velocity.sign()
    }

    #[inline(always)]
    fn level(&self) -> T {
        self.normal_force * self.lever_arm / self.wheel_radius
    }

    #[inline(always)]
    fn band(&self) -> Option<T> {
        None
    }
}

memoryless!(RollingResistance, |law| law.resisting_moment = law.friction_force * law.wheel_radius);

impl Model for RollingResistance {
    const PIECEWISE_LINEAR: bool = true;
    memoryless!();
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::model::Law;

    /// The steepest slope on which a wheel rests: tan(alpha) = d / r. Its weight along the slope is then f_r.
    #[test]
    fn a_wheel_rests_up_to_the_slope_of_its_coefficient() {
        for (share, rests) in [(0.999, 1.0), (1.001, 0.0)] {
            let slope = (share * 0.004f64 / 0.25).atan();
            let [normal_force, external_force] = [500.0 * slope.cos(), 500.0 * slope.sin()];
            let mut wheel = RollingResistance { normal_force, external_force, ..Default::default() };
            (wheel.lever_arm, wheel.wheel_radius) = (0.004, 0.25);
            wheel.output();
            assert_eq!(wheel.sticking, rests);
            assert_eq!(wheel.friction_force == external_force, rests == 1.0);
        }
    }

    /// Moment times rate of rotation is force times velocity.
    #[test]
    fn power_by_moment_and_by_force() {
        for velocity in [-7.0, 0.02] {
            let mut wheel = RollingResistance { velocity, normal_force: 120.0, ..Default::default() };
            wheel.output();
            let power = wheel.resisting_moment * velocity / wheel.wheel_radius;
            assert!(power > 0.0 && (wheel.dissipated_power / power - 1.0).abs() < 1e-15);
        }
    }

    /// A wheel of 10 kg with J = 0.4 kg.m2 let go at 1 m/s: it stops after v^2 m / 2 f_r, whatever the step.
    #[test]
    fn coast_down_ends_where_the_energy_is_used_up() {
        let effective = 10.0 + 0.4 / (0.3 * 0.3);
        for dt in [1e-3, 0.1] {
            let mut wheel = RollingResistance { velocity: 1.0, normal_force: 98.1, ..Default::default() };
            wheel.time_stepping.mass = effective;
            let mut path = 0.0;
            for _ in 0..(20.0 / dt) as u32 {
                wheel.step(dt);
                wheel.output();
                let begin = wheel.velocity;
                wheel.velocity -= wheel.friction_force / effective * dt;
                path += 0.5 * (begin + wheel.velocity) * dt;
            }
            assert!(wheel.velocity.abs() < 1e-15 && wheel.sticking == 1.0, "{} m/s", wheel.velocity);
            assert!((path / (0.5 * effective / 0.981) - 1.0).abs() < dt * dt, "{path} m");
            assert_abs_diff_eq!(wheel.dissipated_energy / (0.5 * effective), 1.0, epsilon = 1e-12);
        }
    }
}
