use nalgebra::Vector2;

use crate::contact::conditions::ELASTIC_SHARE;
use crate::contact::quantities::*;
use crate::contact::unloading::released_without_load;
use crate::laws::passivity::names_least_viscous;
use crate::laws::stribeck;
use crate::model::{Derivatives, Fault, Law, Model, ModelExchange, Preset, Steps, change, in_lanes};
use crate::number::choose;
use crate::numerics::relaxation;
use crate::numerics::vector::{Component, direction, length, only, remainder};

crate::model! {
    /// LuGre friction in a plane: the bristle is a vector, so that a body that slides in one direction and is pushed in
    /// another has the coupled, isotropic friction of a real contact instead of two independent ones.
    ///
    /// # Equations
    ///
    /// ```text
    /// dz/dt  = v - sigma_0 |v| z / g(|v|)
    /// g(|v|) = f_C + (f_s - f_C) exp(-(|v| / v_S)^delta)
    /// f_f    = sigma_0 z + sigma_1(v) dz/dt + sigma_2 v
    /// f_C    = mu_k f_n,   f_s = mu_s f_n
    /// sigma_1(v) = sigma_1 exp(-(|v| / v_d)^2)     if v_d > 0, else sigma_1
    /// ```
    ///
    /// $v$, $z$ and $f_f$ are vectors in the plane.
    ///
    /// | symbol  | variable                 | unit  | meaning                                         |
    /// |---------|--------------------------|-------|-------------------------------------------------|
    /// | v       | `velocity_x`             | m/s   | velocity of body 1 relative to body 2           |
    /// |         | `velocity_y`             |       |                                                 |
    /// | f_n     | `normal_force`           | N     | force pressing the surfaces together            |
    /// | mu_k    | `mu_k`                   | 1     | kinetic coefficient of friction                 |
    /// | mu_s    | `mu_s`                   | 1     | static coefficient of friction                  |
    /// | v_S     | `stribeck_velocity`      | m/s   | speed at which the level has fallen             |
    /// | delta   | `stribeck_exponent`      | 1     | shape of the Stribeck curve                     |
    /// | sigma_0 | `sigma_0`                | N/m   | stiffness of the bristles                       |
    /// | sigma_1 | `sigma_1`                | N.s/m | damping of the bristles                         |
    /// | sigma_2 | `viscous_coefficient`    | N.s/m | viscous coefficient                             |
    /// | v_d     | `damping_velocity`       | m/s   | speed at which the bristle damping fades        |
    /// | z       | `bristle_deflection_x`   | m     | mean deflection of the bristles                 |
    /// |         | `bristle_deflection_y`   |       |                                                 |
    /// | f_f     | `friction_force_x`       | N     | friction force                                  |
    /// |         | `friction_force_y`       |       |                                                 |
    ///
    /// # Sign
    /// The friction force has the direction of the velocity in steady sliding; body 1 feels its negative. Dissipated
    /// power is the scalar product of friction force and velocity; it is negative while the bristles spring back.
    ///
    /// # Step
    /// With held inputs the equation of $z$ is linear and solved exactly, so the result does not depend on how an
    /// interval is divided. `sticking` means that more than 1 % (chosen) of the motion still goes into the bristles.
    ///
    /// A master that integrates a mass $m$ with the force it reads couples it explicitly to the stiffness $k$ and the
    /// damping $c$ of the contact at rest. If the friction steps first, a held body stays still for communication steps
    /// $h$ with $k h^2 + 2 c h < 4 m$, which is 3.9 ms for the defaults and 1 kg; above, it chatters within the bounds
    /// of the force. If all models step at once and exchange afterwards, the limit is $h < 1 / (k / c + c / m)$, 1.6
    /// ms.
    ///
    #[doc = include_str!("slopes.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`; in Model Exchange `mu_k` = 0.
    ///
    /// # Limits
    /// Along a line it is `LuGre`, with all its limits: drift below breakaway; not passive for sampled velocities
    /// unless $sigma_2 >= sigma_1 (f_s - f_C) / f_C$ or `damping_velocity` > 0. Without damping ($sigma_1 = 0$) it is
    /// passive at constant load. Isotropic: no preferred direction. No spin about the normal. `normal_force` = 0
    /// releases the contact (force 0, deflection 0).
    ///
    #[doc = include_str!("falling_load.md")]
    /// # Source
    /// The law along a line: Canudas de Wit, Olsson, Astrom, Lischinsky (1995), doi:10.1109/9.376053. The extension to
    /// the plane, $|v|$ for the magnitude and vectors for the rest, is the usual one for an isotropic contact; here it
    /// is written down without a particular source. Defaults: Tables 6.1 and 7.1 of F. Novais, "A critical analysis on
    /// friction force models in dynamical systems", MSc thesis, University of Minho (2024).
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::LuGrePlanar;
    /// use stribeck::model::{Law, Model};
    /// let mut law = LuGrePlanar { velocity_x: 0.03, velocity_y: -0.04, ..Default::default() };
    /// law.step(1.0);
    /// law.output();
    /// let size = 0.981 + 0.1 * 0.05; // f_C + sigma_2 |v| in the direction (0.6, -0.8)
    /// assert!((law.friction_force_x - 0.6 * size).abs() < 1e-12 && (law.friction_force_y + 0.8 * size).abs() < 1e-12);
    /// ```
    LuGrePlanar: "Bristle friction with Stribeck effect in a plane (LuGre)" {
        velocity_x: input = VELOCITY_X,
        velocity_y: input = VELOCITY_Y,
        normal_force: input = NORMAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        stribeck_velocity: tunable = STRIBECK_VELOCITY,
        stribeck_exponent: tunable = STRIBECK_EXPONENT,
        sigma_0: tunable = SIGMA_0,
        sigma_1: tunable = SIGMA_1,
        viscous_coefficient: tunable = VISCOUS_COEFFICIENT.start(0.1),
        damping_velocity: tunable = DAMPING_VELOCITY,
        bristle_deflection_x: state = BRISTLE_DEFLECTION_X.reinit(),
        bristle_deflection_y: state = BRISTLE_DEFLECTION_Y.reinit(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force_x: output = FRICTION_FORCE_X,
        friction_force_y: output = FRICTION_FORCE_Y,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Component> LuGrePlanar<T> {
    #[inline(always)]
    fn velocity(&self) -> Vector2<T> {
        Vector2::new(self.velocity_x, self.velocity_y)
    }

    #[inline(always)]
    fn deflection(&self) -> Vector2<T> {
        Vector2::new(self.bristle_deflection_x, self.bristle_deflection_y)
    }

    /// g(|v|).
    #[inline(always)]
    fn level(&self, speed: T) -> T {
        let coulomb = self.mu_k * self.normal_force;
        let breakaway = self.mu_s * self.normal_force;
        stribeck::level(speed, coulomb, breakaway, self.stribeck_velocity, self.stribeck_exponent)
    }

    /// sigma_1(v).
    #[inline(always)]
    fn damping(&self) -> T {
        choose!(self.damping_velocity.is(0.0), self.sigma_1, {
            let u = length(&self.velocity()) / self.damping_velocity;
            self.sigma_1 * (-(u * u)).exp()
        })
    }

    /// dz/dt.
    #[inline(always)]
    fn deflection_rate(&self) -> Vector2<T> {
        let speed = length(&self.velocity());
        let level = self.level(speed);
        // Without load, or at high speed without Coulomb level (f_C = 0): a step then drops the deflection, and in
        // Model Exchange, where f_C > 0, the event at which the load vanishes does.
        let velocity = self.velocity();
        let rate = remainder(velocity - self.deflection() * (self.sigma_0 * speed / level), &velocity);
        only(!level.vanishes(), rate)
    }

    #[inline(always)]
    fn force(&self, deflection_rate: Vector2<T>) -> Vector2<T> {
        let force = self.deflection() * self.sigma_0
            + deflection_rate * self.damping()
            + self.velocity() * self.viscous_coefficient;
        only(!self.normal_force.vanishes(), force)
    }
}

impl<T: Component> LuGrePlanar<T> {
    /// The outputs at dz/dt.
    #[inline(always)]
    fn respond(&mut self, rate: Vector2<T>) {
        let force = self.force(rate);
        [self.friction_force_x, self.friction_force_y] = force.into();
        self.dissipated_power = force.dot(&self.velocity());
        let speed = length(&self.velocity());
        let forward = rate.dot(&direction(&self.velocity()));
        let elastic = speed.vanishes() | forward.above(T::from(ELASTIC_SHARE) * speed);
        self.sticking = T::truth(elastic & self.normal_force.is_positive());
    }
}

impl<T: Component> Law for LuGrePlanar<T> {
    type Interface = ModelExchange;

    #[inline(always)]
    fn output(&mut self) {
        self.respond(self.deflection_rate());
    }

    #[inline(always)]
    fn slide_steadily(&mut self) {
        let speed = length(&self.velocity());
        let level = self.level(speed);
        let (rests, moving) = (speed.vanishes(), self.steady_deflection(level));
        let kept = self.deflection().zip_map(&moving, |z, moving| choose!(rests, z, moving));
        [self.bristle_deflection_x, self.bristle_deflection_y] = only(!level.vanishes(), kept).into();
    }
}

impl<T: Component> Derivatives for LuGrePlanar<T> {
    #[inline(always)]
    fn derivatives(&self, rate: &mut Self) {
        let change = self.deflection_rate();
        [rate.bristle_deflection_x, rate.bristle_deflection_y] = change.into();
        rate.dissipated_energy = self.force(change).dot(&self.velocity());
    }

    #[inline(always)]
    fn output_and_derivatives(&mut self, rate: &mut Self) {
        let change = self.deflection_rate();
        [rate.bristle_deflection_x, rate.bristle_deflection_y] = change.into();
        self.respond(change);
        rate.dissipated_energy = self.dissipated_power;
    }
}

impl<T: Component> LuGrePlanar<T> {
    #[inline(always)]
    fn release(&mut self, viscous: T) {
        (self.bristle_deflection_x, self.bristle_deflection_y) = (T::from(0.0), T::from(0.0));
        let before = self.dissipated_energy;
        self.dissipated_energy = choose!(self.normal_force.is_positive(), before + viscous, before);
    }

    /// z of steady sliding at the level g(|v|).
    #[inline(always)]
    fn steady_deflection(&self, level: T) -> Vector2<T> {
        direction(&self.velocity()) * (level / self.sigma_0)
    }

    #[inline(always)]
    fn slide(&mut self, level: T, distance: T, viscous: T) {
        let velocity = self.velocity();
        let (forward, before) = (direction(&velocity), self.deflection());
        let decay = self.sigma_0 * distance / level;
        let steady = self.steady_deflection(level);
        let after = before.zip_map(&steady, |z, steady| relaxation::after(z, steady, decay));
        [self.bristle_deflection_x, self.bristle_deflection_y] = after.into();
        // The integral of the force over the path: sigma_0 |v| z / g = v - dz/dt gives the first term.
        self.dissipated_energy += level * (distance - (after - before).dot(&forward))
            + self.damping() * (after - before).dot(&velocity)
            + viscous;
    }
}

impl<T: Component> Steps for LuGrePlanar<T> {
    #[inline(always)]
    fn advance(&mut self, dt: T) {
        let speed = length(&self.velocity());
        let (level, distance) = (self.level(speed), speed * dt);
        let viscous = self.viscous_coefficient * speed * distance;
        change!(self, level.vanishes(), |law| law.release(viscous), |law| law.slide(level, distance, viscous));
    }
}

in_lanes!(LuGrePlanar);

impl Model for LuGrePlanar {
    const LINEAR: bool = true;
    const STEADY_SLIDING: bool = true;
    const PRESETS: &'static [Preset] = &[Preset {
        name: "thesis",
        source: "The law along a line in Novais (2024), Tables 6.1 and 7.1 (the start values)",
        values: &[],
    }];

    released_without_load!(bristle_deflection_x, bristle_deflection_y);

    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    names_least_viscous!(|_law| 1.0);

    fn check_model_exchange(&self) -> Result<(), Fault> {
        crate::contact::conditions::kinetic_friction_for_exchange(self.mu_k)
    }

    in_lanes!(without registers);
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::friction::LuGre;

    /// Along any line it is LuGre.
    #[test]
    fn along_a_line_it_is_the_scalar_law() {
        for [x, y] in [[1.0, 0.0], [0.6, -0.8], [-5.0 / 13.0, 12.0 / 13.0]] {
            for damping_velocity in [0.0, 1e-3] {
                let mut plane = LuGrePlanar { damping_velocity, ..Default::default() };
                let mut line = LuGre { damping_velocity, ..Default::default() };
                for k in 0..2000 {
                    line.velocity = 2e-3 * (f64::from(k) * 0.7).sin().powi(3);
                    (plane.velocity_x, plane.velocity_y) = (x * line.velocity, y * line.velocity);
                    plane.step(3e-3);
                    line.step(3e-3);
                    plane.output();
                    line.output();
                    assert!((plane.friction_force_x - x * line.friction_force).abs() < 1e-12, "{k}");
                    assert!((plane.friction_force_y - y * line.friction_force).abs() < 1e-12, "{k}");
                    assert_eq!(plane.sticking, line.sticking, "{k}");
                }
                assert_abs_diff_eq!(plane.dissipated_energy / line.dissipated_energy, 1.0, epsilon = 1e-12);
            }
        }
    }

    /// A turn by a right angle in steady sliding: the old component decays as exp(-sigma_0 |v| t / g), the new one
    /// grows.
    #[test]
    fn a_turn_exchanges_the_components() {
        let mut law = LuGrePlanar { velocity_x: 0.1, ..Default::default() };
        law.step(1.0);
        (law.velocity_x, law.velocity_y) = (0.0, 0.1);
        law.step(1e-4);
        let left = (-1e5 * 1e-5 / 0.981f64).exp();
        assert_abs_diff_eq!(law.bristle_deflection_x / (9.81e-6 * left), 1.0, epsilon = 1e-12);
        assert_abs_diff_eq!(law.bristle_deflection_y / (9.81e-6 * (1.0 - left)), 1.0, epsilon = 1e-12);
    }
}
