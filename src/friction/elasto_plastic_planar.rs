use crate::number::elementary::{exp_m1, hypot};
use nalgebra::Vector2;

use crate::contact::conditions::ELASTIC_SHARE;
use crate::contact::quantities::*;
use crate::contact::unloading::released_without_load;
use crate::laws::passivity::names_least_viscous;
use crate::laws::{elasto_plastic, stribeck};
use crate::model::ramp;
use crate::model::{Derivatives, Fault, Law, Model, ModelExchange, Preset};
use crate::number::Mask;
use crate::numerics::runge_kutta::{dormand_prince_from, growth};
use crate::numerics::vector::{Component, direction, length, only, remainder};

crate::model! {
    /// Elasto-plastic friction in a plane: as LuGre in a plane, but purely elastic up to a breakaway deflection, so
    /// that a contact under a small load, from any direction, does not drift.
    ///
    /// # Equations
    ///
    /// ```text
    /// dz/dt    = v - alpha(|z|) max(0, e^T v) z / z_ss,   e = z / |z|
    /// z_ss     = g(|v|) / sigma_0,   z_ba = kappa z_ss
    /// alpha(z) = 0                                                            z <= z_ba
    ///          = 1/2 + 1/2 sin(pi (z - (z_ss + z_ba) / 2) / (z_ss - z_ba))    z_ba < z < z_ss
    ///          = 1                                                            z_ss <= z
    /// g(|v|)   = f_C + (f_s - f_C) exp(-(|v| / v_S)^delta)
    /// f_f      = sigma_0 z + sigma_1(v) dz/dt + sigma_2 v
    /// f_C = mu_k f_n,   f_s = mu_s f_n
    /// sigma_1(v) = sigma_1 exp(-(|v| / v_d)^2)     if v_d > 0, else sigma_1
    /// ```
    ///
    /// $v$, $z$ and $f_f$ are vectors in the plane; $max(0, e^T v)$ is the velocity along the bristle if it loads it,
    /// else 0. Along a line this is the rule $alpha = 0$ for $sgn v != sgn z$ of the scalar law, and without its jump:
    /// in the plane a motion can turn from loading to unloading without coming to rest.
    ///
    /// | symbol  | variable                 | unit  | meaning                                                  |
    /// |---------|--------------------------|-------|----------------------------------------------------------|
    /// | v       | `velocity_x`             | m/s   | velocity of body 1 relative to body 2                    |
    /// |         | `velocity_y`             |       |                                                          |
    /// | f_n     | `normal_force`           | N     | force pressing the surfaces together                     |
    /// | mu_k    | `mu_k`                   | 1     | kinetic coefficient of friction                          |
    /// | mu_s    | `mu_s`                   | 1     | static coefficient of friction                           |
    /// | v_S     | `stribeck_velocity`      | m/s   | speed at which the level has fallen                      |
    /// | delta   | `stribeck_exponent`      | 1     | shape of the falling level                               |
    /// | kappa   | `breakaway_ratio`        | 1     | elastic part of the deflection of steady sliding         |
    /// | sigma_0 | `sigma_0`                | N/m   | stiffness of the bristles                                |
    /// | sigma_1 | `sigma_1`                | N.s/m | damping of the bristles                                  |
    /// | sigma_2 | `viscous_coefficient`    | N.s/m | viscous coefficient                                      |
    /// | v_d     | `damping_velocity`       | m/s   | speed at which the bristle damping fades                 |
    /// | z       | `bristle_deflection_x`   | m     | mean deflection of the bristles                          |
    /// |         | `bristle_deflection_y`   |       |                                                          |
    /// | f_f     | `friction_force_x`       | N     | friction force                                           |
    /// |         | `friction_force_y`       |       |                                                          |
    ///
    /// # Sign
    /// The friction force has the direction of the velocity in steady sliding; body 1 feels its negative. Dissipated
    /// power is the scalar product of friction force and velocity; it is negative while the bristles spring back.
    ///
    /// # Step
    /// With held inputs $z$ depends on the distance only. The elastic part of the path is solved exactly and its end is
    /// located; the plastic part is integrated with error control (Dormand-Prince, 1e-13 of $z_ss$ per step), and its
    /// end, the approach to steady sliding, is an exponential again. The result does not depend on how an interval is
    /// divided by more than 1e-10. `sticking` means that more than 1 % (chosen) of the motion still goes into the
    /// bristles. For the largest communication step see `LuGrePlanar`, which has the same stiffness and damping at
    /// rest. If the master gives slopes of the inputs, each interval between two kinks is divided into sixteen pieces
    /// with the inputs of their middle; the error is of second order.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`; in Model Exchange `mu_k` = 0. $kappa <= 0.99$ (chosen):
    /// at 1 the law is that of `Liang` with RadialReturn, which solves it exactly.
    ///
    /// # Limits
    /// Not passive for sampled velocities unless $sigma_2 >= sigma_1 (f_s - f_C) / f_C$ or `damping_velocity` > 0, as
    /// LuGre. Without damping ($sigma_1 = 0$) it is passive at constant load. No drift as long as $|f_f| < kappa g$.
    /// Isotropic. No spin about the normal. `normal_force` = 0 releases the contact (force 0, deflection 0).
    ///
    #[doc = include_str!("falling_load.md")]
    /// # Source
    /// The law along a line: Dupont, Hayward, Armstrong, Altpeter (2002), "Single state elastoplastic friction models",
    /// IEEE Transactions on Automatic Control 47, 787-792; equations (7.30) to (7.34) of F. Novais, "A critical
    /// analysis on friction force models in dynamical systems", MSc thesis, University of Minho (2024), here with the
    /// exponent $i = 1$. The sine (7.34) is printed with $z$; $|z|$ is meant. The extension to the plane is ours.
    /// Defaults: Tables 6.1 and 7.1 of the thesis and $kappa = 0.7$ from its text.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::ElastoPlasticPlanar;
    /// use stribeck::model::{Law, Model};
    /// let mut law = ElastoPlasticPlanar { velocity_y: 1e-6, ..Default::default() };
    /// law.step(10.0);
    /// assert!((law.bristle_deflection_y - 1e-5).abs() < 1e-19); // below 0.7 f_s / sigma_0 = 10.3 um: a spring
    /// ```
    ElastoPlasticPlanar: "Bristle friction without drift below breakaway, in a plane (elasto-plastic)" {
        velocity_x: input = VELOCITY_X,
        velocity_y: input = VELOCITY_Y,
        normal_force: input = NORMAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        stribeck_velocity: tunable = STRIBECK_VELOCITY,
        stribeck_exponent: tunable = STRIBECK_EXPONENT,
        breakaway_ratio: tunable = BREAKAWAY_RATIO.at_most(0.99),
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

/// Error allowed in a step of the integration, in units of z_ss (chosen: far below what two halves of a step may differ
/// by).
const TOLERANCE: f64 = 1e-13;

/// Within this distance of steady sliding, in units of z_ss - z_ba, the approach is an exponential (chosen: there 1 -
/// alpha is less than 3e-13, which is (pi / 2 NEAR)^2).
const NEAR: f64 = 3e-7;

impl<T: Component> ElastoPlasticPlanar<T> {
    fn velocity(&self) -> Vector2<T> {
        Vector2::new(self.velocity_x, self.velocity_y)
    }

    fn deflection(&self) -> Vector2<T> {
        Vector2::new(self.bristle_deflection_x, self.bristle_deflection_y)
    }

    /// g(|v|); 0 if it has almost vanished, as it does at high speed for f_C = 0.
    fn level(&self) -> T {
        let coulomb = self.mu_k * self.normal_force;
        let breakaway = self.mu_s * self.normal_force;
        let speed = length(&self.velocity());
        let level = stribeck::level(speed, coulomb, breakaway, self.stribeck_velocity, self.stribeck_exponent);
        level.above(T::from(1e-100) * breakaway).choose(|| level, || T::from(0.0))
    }

    /// sigma_1(v).
    fn damping(&self) -> T {
        let falling = || {
            let u = length(&self.velocity()) / self.damping_velocity;
            self.sigma_1 * (-(u * u)).exp()
        };
        self.damping_velocity.is(0.0).choose(|| self.sigma_1, falling)
    }

    /// dz/dt.
    fn deflection_rate(&self, level: T) -> Vector2<T> {
        let (z, velocity, steady) = (self.deflection(), self.velocity(), level / self.sigma_0);
        let loading = velocity.dot(&direction(&z));
        let alpha = elasto_plastic::alpha(length(&z), steady, self.breakaway_ratio * steady);
        let yielding = remainder(velocity - z * (alpha * loading / steady), &velocity);
        let unloads = loading.at_most(T::from(0.0));
        let rate = velocity.zip_map(&yielding, |velocity, rate| unloads.choose(|| velocity, || rate));
        only(!level.vanishes(), rate)
    }

    fn force(&self, deflection_rate: Vector2<T>) -> Vector2<T> {
        let force = self.deflection() * self.sigma_0
            + deflection_rate * self.damping()
            + self.velocity() * self.viscous_coefficient;
        only(!self.normal_force.vanishes(), force)
    }
}

impl<T: Component> ElastoPlasticPlanar<T> {
    /// The outputs at dz/dt.
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

impl<T: Component> Law for ElastoPlasticPlanar<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.respond(self.deflection_rate(self.level()));
    }

    fn slide_steadily(&mut self) {
        let (level, velocity) = (self.level(), self.velocity());
        let (rests, moving) = (length(&velocity).vanishes(), direction(&velocity) * (level / self.sigma_0));
        let kept = self.deflection().zip_map(&moving, |z, moving| rests.choose(|| z, || moving));
        [self.bristle_deflection_x, self.bristle_deflection_y] = only(!level.vanishes(), kept).into();
    }
}

impl<T: Component> Derivatives for ElastoPlasticPlanar<T> {
    fn derivatives(&self, rate: &mut Self) {
        let change = self.deflection_rate(self.level());
        [rate.bristle_deflection_x, rate.bristle_deflection_y] = change.into();
        rate.dissipated_energy = self.force(change).dot(&self.velocity());
    }

    fn output_and_derivatives(&mut self, rate: &mut Self) {
        let change = self.deflection_rate(self.level());
        [rate.bristle_deflection_x, rate.bristle_deflection_y] = change.into();
        self.respond(change);
        rate.dissipated_energy = self.dissipated_power;
    }
}

impl Model for ElastoPlasticPlanar {
    const STEADY_SLIDING: bool = true;
    const PRESETS: &'static [Preset] = &[Preset {
        name: "thesis",
        source: "The law along a line in Novais (2024), Tables 6.1 and 7.1, and kappa = 0.7 (the start values)",
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

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        ramp::in_pieces(self, slope, dt, ramp::PIECES);
    }

    fn step(&mut self, dt: f64) {
        let (level, velocity, before) = (self.level(), self.velocity(), self.deflection());
        let distance = length(&velocity) * dt;
        if self.normal_force > 0.0 {
            self.dissipated_energy += self.viscous_coefficient * length(&velocity) * distance;
        }
        if level == 0.0 {
            (self.bristle_deflection_x, self.bristle_deflection_y) = (0.0, 0.0);
        } else if distance > 0.0 {
            let steady = level / self.sigma_0;
            let forward = direction(&velocity);
            let across = Vector2::new(-forward.y, forward.x);
            let start = Bristle { along: before.dot(&forward), across: before.dot(&across), area: 0.0 };
            let end = start.scaled(1.0 / steady).advanced(self.breakaway_ratio, distance / steady);
            let after = (forward * end.along + across * end.across) * steady;
            [self.bristle_deflection_x, self.bristle_deflection_y] = after.into();
            self.dissipated_energy += level * (steady * end.area) + self.damping() * (after - before).dot(&velocity);
        }
    }
}

/// The deflection along and across a motion at constant velocity; lengths are in units of z_ss.
#[derive(Clone, Copy)]
struct Bristle {
    along: f64,
    across: f64,
    /// Integral of `along` over the distance.
    area: f64,
}

impl Bristle {
    fn scaled(self, factor: f64) -> Bristle {
        Bristle { along: self.along * factor, across: self.across * factor, ..self }
    }

    /// After a distance, for z_ba = kappa.
    fn advanced(mut self, kappa: f64, distance: f64) -> Bristle {
        // Elastic until the motion loads the bristle and |z| exceeds z_ba.
        let begin = ((kappa - self.across) * (kappa + self.across)).max(0.0).sqrt();
        let elastic = (begin - self.along).max(0.0).min(distance);
        self.area += elastic * (self.along + 0.5 * elastic);
        self.along = if elastic < distance { self.along.max(begin) } else { self.along + elastic };
        self.plastic(kappa, distance - elastic)
    }

    fn plastic(self, kappa: f64, distance: f64) -> Bristle {
        let mut at = [self.along, self.across, self.area];
        let (mut left, mut piece) = (distance, 0.01 * (1.0 - kappa));
        let mut first = rates(kappa, at);
        while left > 0.0 {
            let [along, across, area] = at;
            if hypot(along - 1.0, across) < NEAR * (1.0 - kappa) {
                let gone = -exp_m1(-left);
                at = [along - (along - 1.0) * gone, across * (1.0 - gone), area + left + (along - 1.0) * gone];
                break;
            }
            let length = piece.min(left);
            let next = dormand_prince_from(first, |_, at| rates(kappa, at), at, length);
            let error = next.error;
            let deflection = hypot(error[0], error[1]) / hypot(at[0], at[1]).max(1.0);
            let error = f64::max(deflection, error[2].abs() / at[2].abs().max(1.0)) / TOLERANCE;
            // A length that vanishes means numbers out of range: the caller refuses the result.
            if error <= 1.0 || length <= 1e-14 || error.is_nan() {
                (at, first) = (next.end, next.rates);
                left = if length < left { left - length } else { 0.0 };
            }
            if error.is_nan() {
                break;
            }
            if left > 0.0 {
                piece = length * growth(error);
            }
        }
        Bristle { along: at[0], across: at[1], area: at[2] }
    }
}

/// Derivatives with respect to the distance.
fn rates(kappa: f64, [along, across, _]: [f64; 3]) -> [f64; 3] {
    let size = hypot(along, across);
    let plastic = if along > 0.0 { elasto_plastic::alpha(size, 1.0, kappa) * along / size } else { 0.0 };
    [1.0 - plastic * along, -plastic * across, along]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A motion that turns, against small steps of Heun's method.
    #[test]
    fn agrees_with_small_explicit_steps() {
        for breakaway_ratio in [0.2, 0.7, 0.99] {
            let mut law = ElastoPlasticPlanar { breakaway_ratio, ..Default::default() };
            let mut z = Vector2::new(0.0, 0.0);
            let mut work = 0.0;
            for (x, y, time) in [(3e-4, 4e-4, 0.03), (-1e-3, 5e-4, 0.01), (2e-3, 2e-3, 5e-3), (0.0, -1e-2, 1e-3)] {
                (law.velocity_x, law.velocity_y) = (x, y);
                law.step(time);
                let (n, mut fine) = (200_000, law);
                let h = time / f64::from(n);
                let rate = |z: Vector2<f64>, fine: &mut ElastoPlasticPlanar| {
                    [fine.bristle_deflection_x, fine.bristle_deflection_y] = z.into();
                    let change = fine.deflection_rate(fine.level());
                    (change, fine.force(change).dot(&fine.velocity()))
                };
                for _ in 0..n {
                    let (first, power) = rate(z, &mut fine);
                    let (second, power_after) = rate(z + first * h, &mut fine);
                    z += (first + second) * (0.5 * h);
                    work += 0.5 * h * (power + power_after);
                }
                assert!((law.deflection() - z).norm() < 1e-7 * 1e-5, "{breakaway_ratio}: {} {z}", law.deflection());
                assert!((law.dissipated_energy / work - 1.0).abs() < 1e-6, "{breakaway_ratio}: {work}");
            }
        }
    }

    /// A load that rotates within the elastic range leaves the contact where it was.
    #[test]
    fn no_drift_below_breakaway_in_any_direction() {
        let mut law = ElastoPlasticPlanar::default();
        let radius = 1.0e-5; // below 0.7 f_s / sigma_0 = 1.03e-5
        let n = 1000;
        let mut corner = (0.0, 0.0);
        for k in 0..=2 * n {
            let angle = std::f64::consts::TAU * f64::from(k) / f64::from(n);
            let next = (0.5 * radius * (1.0 - angle.cos()), 0.5 * radius * angle.sin());
            (law.velocity_x, law.velocity_y) = ((next.0 - corner.0) / 1e-2, (next.1 - corner.1) / 1e-2);
            law.step(1e-2);
            corner = next;
        }
        assert!(law.deflection().norm() < 1e-17, "{}", law.deflection());
    }
}
