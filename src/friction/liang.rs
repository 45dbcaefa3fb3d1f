use nalgebra::Vector3;

use crate::contact::planar::{self, AT_LIMIT, Bristle, Ramp};
use crate::contact::quantities::*;
use crate::contact::time_stepping::{MOVED, NO_EVENT, PASSED, REACHED};
use crate::contact::unloading;
use crate::model::ramp;
use crate::model::{Derivatives, Fault, Law, Meaning, Model, ModelExchange, Preset, real};
use crate::number::{Decision, Mask, Scalar};
use crate::numerics::vector::{Component, direction, in_plane, length, remainder, turned_into};

crate::choices! {
    /// Behaviour of the bristle at its largest deflection.
    pub enum LiangVariant {
        /// The deflection keeps its direction and is shortened: the force is continuous.
        RadialReturn,
        /// The deflection takes the direction of the velocity, as printed: the force can jump.
        Printed,
    }
}

crate::choices! {
    /// Motion of the bristle between two events of Model Exchange.
    pub enum LiangMotion {
        /// Determined by deflection and velocity: no event has set it, as in co-simulation.
        Free,
        /// Moves with the surface, within the static limit.
        Bonded,
        /// Slides at the static limit.
        Sliding,
        /// Moves with the surface, within the kinetic limit.
        BondedFast,
        /// Slides at the kinetic limit.
        SlidingFast,
    }
}

impl LiangMotion {
    fn found(is_fast: bool, slides: bool) -> LiangMotion {
        match (is_fast, slides) {
            (false, false) => LiangMotion::Bonded,
            (false, true) => LiangMotion::Sliding,
            (true, false) => LiangMotion::BondedFast,
            (true, true) => LiangMotion::SlidingFast,
        }
    }
}

crate::model! {
    /// Liang friction: one bristle in the tangent plane of a contact in space, with a static and a kinetic limit; for
    /// multibody models where two surfaces slide in any direction.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f   = sigma_0 z + sigma_1 dz/dt                        (7.51)
    /// dz/dt = v_t                    while |z| <= z_max        (7.49)
    /// z     = z_max z / |z|          beyond, RadialReturn
    /// z     = z_max v_t / |v_t|      beyond, Printed           (7.49)
    /// z_max = f_s / sigma_0          |v_t| <= v_0              (7.50)
    ///       = f_C / sigma_0          |v_t| >  v_0
    /// v_t   = v - (n^T v) n,   f_C = mu_k f_n,   f_s = mu_s f_n
    /// ```
    ///
    /// $z$, $v_t$ and $f_f$ are vectors in the plane with the normal $n$. While $z$ slides along the circle
    /// $|z| = z_max$, RadialReturn keeps only the motion across $z$: $dz/dt = v_t$ - ($v_t$ . $z$) $z / |z|^2$.
    ///
    /// | symbol  | variable                 | unit  | meaning                                            |
    /// |---------|--------------------------|-------|----------------------------------------------------|
    /// | v       | `velocity_x`             | m/s   | velocity of body 1 relative to body 2              |
    /// |         | `velocity_y`             |       |                                                    |
    /// |         | `velocity_z`             |       |                                                    |
    /// | n       | `normal_x`               | 1     | normal of the contact, of any length               |
    /// |         | `normal_y`               |       |                                                    |
    /// |         | `normal_z`               |       |                                                    |
    /// | f_n     | `normal_force`           | N     | force pressing the surfaces together               |
    /// | mu_k    | `mu_k`                   | 1     | kinetic coefficient of friction                    |
    /// | mu_s    | `mu_s`                   | 1     | static coefficient of friction                     |
    /// | v_0     | `transition_velocity`    | m/s   | speed up to which the static limit holds           |
    /// | sigma_0 | `sigma_0`                | N/m   | stiffness of the bristle                           |
    /// | sigma_1 | `sigma_1`                | N.s/m | damping of the bristle                             |
    /// |         | `variant`                |       | behaviour at the limit                             |
    /// | z       | `bristle_deflection_x`   | m     | deflection of the bristle                          |
    /// |         | `bristle_deflection_y`   |       |                                                    |
    /// |         | `bristle_deflection_z`   |       |                                                    |
    /// |         | `motion`                 |       | motion of $z$ as found by the last event           |
    /// | f_f     | `friction_force_x`       | N     | friction force                                     |
    /// |         | `friction_force_y`       |       |                                                    |
    /// |         | `friction_force_z`       |       |                                                    |
    ///
    /// # Sign
    /// The friction force has the direction of the velocity when sliding; body 1 feels its negative. (7.51) is printed
    /// with minus signs: there it is the force on the body. Dissipated power is the scalar product of friction force
    /// and velocity; it is negative while the bristle springs back.
    ///
    /// # Step
    /// Exact for held inputs in both variants, so the result does not depend on how an interval is divided: the bristle
    /// moves with $v_t$ until it reaches the circle at a located instant, and then turns towards $v_t$ by
    ///
    /// ```text
    /// tan(phi / 2) = tan(phi_0 / 2) exp(-|v_t| t / z_max),   phi = angle between z and v_t
    /// ```
    ///
    /// At the start of a step $z$ is turned into the plane of the present normal: projected, with its length kept.
    /// `sticking` means that the bristle is not at its limit.
    ///
    /// With linearly moving inputs the step is of second order, in eight pieces (chosen); the plane turns with its
    /// normal. A bristle that slides stays on the circle while the load, and with it the circle, grows or shrinks, and
    /// leaves it where the circle grows faster than the bristle moves outwards. The dissipated energy includes the
    /// damping of the motion with the growing circle; the output force, which is that of held inputs, does not.
    ///
    /// In Model Exchange the bristle reaches its circle, leaves it, and changes from one circle to the other at events.
    /// Between two of them one line above holds, also where a solver tries values beyond. The slope of the load is not
    /// known there. The force of a bristle that slides follows the circle at once, and its state with a time constant of
    /// 0.1 ms; if the circle outgrows the state by more than the bristle moves in that time, the bristle is bonded
    /// again. The state follows a turning plane with the same time constant; a bonded one loses 0.01 % per second by
    /// that at 1 rad/s, and more with the square of that speed. A bristle beyond a circle that shrinks is put on it, and
    /// turned over by the printed rule.
    ///
    /// A master that integrates a mass $m$ with the force it reads couples it explicitly to the stiffness $k$ and the
    /// damping $c$ of the contact at rest. If the friction steps first, a held body stays still for communication steps
    /// $h$ with $k h^2 + 2 c h < 4 m$, which is 3.9 ms for the defaults and 1 kg; above, it chatters within the bounds
    /// of the force. If all models step at once and exchange afterwards, the limit is $h < 1 / (k / c + c / m)$, 1.6
    /// ms.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`. A normal of length 0, as given by importers that start
    /// from zeros, is accepted with a warning: there is no tangent plane, and the whole velocity counts as tangential.
    ///
    /// # Limits
    /// No Stribeck curve: the limit falls at once by $f_s - f_C$ when the speed passes $v_0$, and the damping force
    /// ends where the bristle reaches its limit, so the force jumps. A contact that creeps below $v_0$ stays at the
    /// static level. Passive in both variants, also while load or limit change. Printed: if the limit shrinks below a
    /// deflection that opposes the velocity, the force flips by up to $2 f_C$; at $v_t = 0$, where the printed rule
    /// says nothing, $z$ keeps its direction. `normal_force` = 0 releases the contact (force 0, deflection 0). In one
    /// dimension this is the reset integrator without its stiction gain ($a = 0$) and with a limit that switches with
    /// the speed. $sigma_0$ should be ten times the largest stiffness of the system that contains the contact (Liang et
    /// al.).
    ///
    /// # Source
    /// Liang, Fillmore, Ma (2012), "An extended bristle friction force model with experimental validation", Mechanism
    /// and Machine Theory 56, 123-137; equations (7.48) to (7.51) and Tables 6.1 and 7.1 of F. Novais, "A critical
    /// analysis on friction force models in dynamical systems", MSc thesis, University of Minho (2024). Deviations: the
    /// sign (above); RadialReturn, which equals the printed rule as long as the motion keeps its direction, and is
    /// continuous where the printed rule flips $z$ or is undefined.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Liang;
    /// use stribeck::model::{Law, Model};
    /// let mut law = Liang { velocity_x: 0.03, velocity_y: -0.04, ..Default::default() };
    /// law.step(1.0);
    /// law.output();
    /// // f_C in the direction of the velocity: 0.981 N times (0.6, -0.8, 0).
    /// assert!((law.friction_force_x - 0.5886).abs() < 1e-15 && (law.friction_force_y + 0.7848).abs() < 1e-15);
    /// ```
    Liang: "Bristle friction in space (Liang)" {
        velocity_x: input = VELOCITY_X,
        velocity_y: input = VELOCITY_Y,
        /// Velocity of body 1 relative to body 2, component z.
        velocity_z: input = real("m/s", 0.0).shown_in("mm/s").odd(),
        /// Normal of the contact, component x; the length does not matter.
        normal_x: input = real("1", 0.0),
        /// Normal of the contact, component y; the length does not matter.
        normal_y: input = real("1", 0.0),
        /// Normal of the contact, component z; the length does not matter.
        normal_z: input = real("1", 1.0),
        normal_force: input = NORMAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        transition_velocity: tunable = TRANSITION_VELOCITY,
        sigma_0: tunable = SIGMA_0,
        sigma_1: tunable = SIGMA_1,
        /// Variant of the law.
        variant: fixed = LiangVariant::RadialReturn.start().means(Meaning::Variant),
        bristle_deflection_x: state = BRISTLE_DEFLECTION_X.reinit(),
        bristle_deflection_y: state = BRISTLE_DEFLECTION_Y.reinit(),
        /// Elastic deflection of the bristles, component z.
        bristle_deflection_z: state = real("m", 0.0).nominal(1e-5).shown_in("um").odd().reinit(),
        /// Motion of the bristle as found by the last event of Model Exchange.
        motion: state = LiangMotion::Free.start(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force_x: output = FRICTION_FORCE_X,
        friction_force_y: output = FRICTION_FORCE_Y,
        /// Friction force, component z; has the direction of the velocity when sliding. Body 1 feels its negative.
        friction_force_z: output = real("N", 0.0).odd(),
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

/// Pieces of a step with inputs that move (chosen).
const PIECES: u32 = 8;

/// Time constant with which the stored deflection follows its circle and its plane in Model Exchange, in s (chosen).
const FOLLOWED: f64 = 1e-4;

/// Part of the limit by which a circle must have outgrown a bristle that slides (chosen), so that rounding does not.
const OUTGROWN: f64 = 1e-9;

/// Width of the hysteresis at the transition velocity, in parts of it (chosen).
const EDGE: f64 = 1e-10;

impl<T: Component + Scalar> Liang<T> {
    fn normal(&self) -> Vector3<T> {
        direction(&Vector3::new(self.normal_x, self.normal_y, self.normal_z))
    }

    fn velocity(&self) -> Vector3<T> {
        Vector3::new(self.velocity_x, self.velocity_y, self.velocity_z)
    }

    /// v_t.
    fn tangential_velocity(&self) -> Vector3<T> {
        in_plane(&self.velocity(), &self.normal())
    }

    /// Whether no event has found the motion of the bristle.
    fn is_free(&self) -> T::Mask {
        LiangMotion::Free.is(self.motion)
    }

    /// Whether an event has found it sliding.
    fn is_found_sliding(&self) -> T::Mask {
        LiangMotion::Sliding.is(self.motion) | LiangMotion::SlidingFast.is(self.motion)
    }

    /// Whether an event has found it slower than v_0.
    fn is_found_slow(&self) -> T::Mask {
        LiangMotion::Bonded.is(self.motion) | LiangMotion::Sliding.is(self.motion)
    }

    /// z_max.
    fn limit(&self) -> T {
        let is_slow = length(&self.tangential_velocity()).at_most(self.transition_velocity);
        let mu = (self.is_found_slow() | self.is_free() & is_slow).choose(|| self.mu_s, || self.mu_k);
        mu * self.normal_force / self.sigma_0
    }

    /// z as it is stored.
    fn stored(&self) -> Vector3<T> {
        Vector3::new(self.bristle_deflection_x, self.bristle_deflection_y, self.bristle_deflection_z)
    }

    /// z in the present plane and within its present limit.
    fn deflection(&self) -> Vector3<T> {
        if !self.is_free().holds() {
            return self.deflection_between_events();
        }
        let z = turned_into(&self.stored(), &self.normal());
        let (limit, velocity) = (self.limit(), self.tangential_velocity());
        // A deflection that was left at its limit must not count as beyond it because of rounding.
        if (length(&z) * T::from(AT_LIMIT)).above(limit).holds() {
            let is_led = self.is_printed() && length(&velocity).is_positive().holds();
            direction(if is_led { &velocity } else { &z }) * limit
        } else if self.slides(&z).holds() {
            direction(if self.is_printed() { &velocity } else { &z }) * limit
        } else if (self.is_at_limit(&z) & (length(&z) - limit).rises()).holds() {
            // It is not moved outwards, but the circle shrinks faster than it moves inwards.
            direction(&z) * limit
        } else {
            z
        }
    }

    fn is_printed(&self) -> bool {
        LiangVariant::of(self.variant.value()) == LiangVariant::Printed
    }

    /// The stored z in the present plane: its projection, which is linear.
    fn in_present_plane(&self) -> Vector3<T> {
        in_plane(&self.stored(), &self.normal())
    }

    /// z as the last event has found it moving: bonded, or at its limit.
    fn deflection_between_events(&self) -> Vector3<T> {
        let (z, limit) = (self.in_present_plane(), self.limit());
        let forward = direction(&z);
        let outward = self.tangential_velocity().dot(&forward);
        if self.is_found_sliding().holds() {
            let followed = length(&z) + outward.larger(T::from(0.0)) * T::from(FOLLOWED);
            return self.heading(forward, outward) * limit.at_most(followed).choose(|| limit, || followed);
        }
        // An event is due if it is moved outwards beyond its limit.
        if (length(&z).above(limit) & !outward.is_positive()).holds() { forward * limit } else { z }
    }

    /// Direction of a bristle that slides, from that of the stored one.
    fn heading(&self, forward: Vector3<T>, outward: T) -> Vector3<T> {
        if self.is_printed() && !outward.vanishes().holds() {
            direction(&self.tangential_velocity()) * outward.sign()
        } else {
            forward
        }
    }

    /// Whether z is at its limit and moved outwards. Without a limit there is only sliding.
    fn slides(&self, z: &Vector3<T>) -> T::Mask {
        if !self.is_free().holds() {
            return self.is_found_sliding();
        }
        let is_outward = z.dot(&self.tangential_velocity()).is_positive();
        self.limit().vanishes() | is_outward & self.is_at_limit(z)
    }

    fn is_at_limit(&self, z: &Vector3<T>) -> T::Mask {
        length(z).at_least(T::from(AT_LIMIT) * self.limit())
    }

    /// dz/dt.
    fn deflection_rate(&self, z: &Vector3<T>) -> Vector3<T> {
        let velocity = self.tangential_velocity();
        if (!self.slides(z)).holds() {
            return velocity;
        }
        let forward = direction(z);
        if self.is_printed() || forward.iter().all(|component| component.vanishes().holds()) {
            return Vector3::repeat(T::from(0.0));
        }
        let across = in_plane(&velocity, &forward);
        if self.is_free().holds() { remainder(across, &velocity) } else { across }
    }

    /// f_f, and whether the bristle is at its limit.
    fn force(&self) -> (Vector3<T>, T::Mask) {
        let z = self.deflection();
        (z * self.sigma_0 + self.deflection_rate(&z) * self.sigma_1, self.slides(&z))
    }
}

impl<T: Component + Scalar> Law for Liang<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        let is_loaded = self.normal_force.is_positive().holds();
        let (force, slides) = if is_loaded { self.force() } else { (Vector3::repeat(T::from(0.0)), true.into()) };
        [self.friction_force_x, self.friction_force_y, self.friction_force_z] = force.into();
        self.dissipated_power = force.dot(&self.velocity());
        self.sticking = T::truth(!slides);
    }
}

impl<T: Component + Scalar> Derivatives for Liang<T> {
    fn derivatives(&self, rate: &mut Self) {
        if !self.normal_force.is_positive().holds() {
            return;
        }
        let z = self.deflection();
        let mut change = self.deflection_rate(&z);
        if !self.is_free().holds() {
            change += (z - self.stored()) * T::from(1.0 / FOLLOWED);
        }
        [rate.bristle_deflection_x, rate.bristle_deflection_y, rate.bristle_deflection_z] = change.into();
        rate.dissipated_energy = self.force().0.dot(&self.velocity());
    }
}

impl Model for Liang {
    const PRESETS: &'static [Preset] = &[
        Preset { name: "thesis", source: "Novais (2024), Tables 6.1 and 7.1 (the start values)", values: &[] },
        Preset {
            name: "printed",
            source: "Novais (2024), Tables 6.1 and 7.1, with the limit rule of (7.49) as printed",
            values: &[("variant", 2.0)],
        },
    ];

    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    fn warning(&self) -> Option<Fault> {
        let has_normal = [self.normal_x, self.normal_y, self.normal_z] != [0.0; 3];
        let text = "the contact has no normal, so the whole velocity counts as tangential";
        (!has_normal).then(|| Fault::new(format_args!("normal_x, normal_y, normal_z = 0, 0, 0: {text}")))
    }

    fn step(&mut self, dt: f64) {
        self.motion = LiangMotion::Free.number();
        let (velocity, limit) = (self.tangential_velocity(), self.limit());
        let mut z = self.deflection();
        if limit > 0.0 {
            let mut left = dt;
            if !self.slides(&z) {
                let free = left.min(planar::time_to_limit(&z, &velocity, limit));
                self.dissipated_energy += free
                    * (self.sigma_0 * (z + velocity * (0.5 * free)).dot(&velocity)
                        + self.sigma_1 * velocity.dot(&velocity));
                z += velocity * free;
                left -= free;
            }
            if left > 0.0 {
                if self.is_printed() {
                    z = direction(&velocity) * limit;
                }
                let forward = direction(&velocity);
                let (along, across) =
                    planar::slide(&mut z, &[forward; 2], &self.normal(), length(&velocity) * left, limit);
                self.dissipated_energy +=
                    limit * (self.sigma_0 * limit * along + self.sigma_1 * length(&velocity) * across);
            }
        }
        self.put(&z);
    }

    /// In pieces over which velocity, normal and load count as linear. In the plane of its normal the instants of each
    /// piece are located: where the speed passes v_0, and where the bristle reaches its circle or leaves it.
    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        self.motion = LiangMotion::Free.number();
        let begin = ramp::Inputs::of(self);
        let mut z = self.deflection();
        for piece in 0..PIECES {
            let [from, to] = [piece, piece + 1].map(|k| dt * (f64::from(k) / f64::from(PIECES)));
            ramp::set_inputs(self, &begin, slope, from);
            let (normal, velocity, load) = (self.normal(), self.tangential_velocity(), self.normal_force);
            ramp::set_inputs(self, &begin, slope, to);
            let normal_end = self.normal();
            let ramp = Ramp {
                velocity: [planar::carried(&velocity, &normal, &normal_end), self.tangential_velocity()],
                load: [load, self.normal_force],
                duration: to - from,
            };
            z = planar::carried(&z, &normal, &normal_end);
            self.follow(&mut z, &ramp);
        }
        ramp::set_inputs(self, &begin, slope, dt);
        self.put(&z);
    }

    const EVENT_INDICATORS: usize = 3;

    /// A bristle that slides on a line keeps its direction.
    fn is_linear(&self) -> bool {
        let across = in_plane(&self.tangential_velocity(), &direction(&self.in_present_plane()));
        !self.is_free() && (!self.is_found_sliding() || across == Vector3::zeros())
    }

    fn event_indicators(&self, indicators: &mut [f64]) {
        let speed = length(&self.tangential_velocity()) / self.transition_velocity;
        let passes = if self.is_found_slow() { 1.0 + EDGE - speed } else { speed - (1.0 - EDGE) };
        indicators.copy_from_slice(&[self.change(), passes, unloading::load(self.normal_force)]);
    }

    fn at_event(&mut self) {
        let before = *self;
        let z = if self.is_free() { self.deflection() } else { turned_into(&self.stored(), &self.normal()) };
        let is_fast = length(&self.tangential_velocity()) > self.transition_velocity;
        self.motion = LiangMotion::found(is_fast, false).number();
        let limit = if unloading::is_unloaded(self.normal_force) { 0.0 } else { self.limit() };
        let slides = limit == 0.0 || if before.is_free() { before.slides(&z) } else { self.slides_on(&z, &before) };
        self.motion = LiangMotion::found(is_fast, slides).number();
        let heading = if slides && self.is_printed() { self.tangential_velocity() } else { z };
        self.put(&if slides || length(&z) > limit { direction(&heading) * limit } else { z });
    }
}

impl Liang {
    /// |z| in parts of its limit.
    fn stretch(&self, z: &Vector3<f64>) -> f64 {
        let limit = self.limit();
        if limit > 0.0 { length(z) / limit } else { 0.0 }
    }

    /// Speed in the direction of z, in parts of the least one that counts.
    fn outward_speed(&self, z: &Vector3<f64>) -> f64 {
        self.tangential_velocity().dot(&direction(z)) / MOVED
    }

    /// The same of a bonded bristle that begins to slide; the printed rule needs no direction.
    fn breaking_speed(&self, z: &Vector3<f64>) -> f64 {
        if self.is_printed() { length(&self.tangential_velocity()) / MOVED } else { self.outward_speed(z) }
    }

    /// Event indicator: positive until a bristle begins to slide, or ceases to.
    fn change(&self) -> f64 {
        let z = self.in_present_plane();
        if !self.is_found_sliding() {
            return (1.0 + REACHED - self.stretch(&z)).max(PASSED - self.breaking_speed(&z));
        }
        if self.limit() == 0.0 || unloading::is_unloaded(self.normal_force) {
            return NO_EVENT;
        }
        let followed = self.stretch(&self.deflection_between_events());
        (self.outward_speed(&z) + PASSED).min((followed - 1.0) / OUTGROWN + 1.0)
    }

    /// Whether a bristle slides after an event. The limits lie between those of the indicator.
    fn slides_on(&self, z: &Vector3<f64>, before: &Liang) -> bool {
        let (stretch, outward) = (self.stretch(z), self.outward_speed(z));
        if !before.is_found_sliding() {
            let is_beyond = stretch >= 1.0 + 0.5 * REACHED && self.breaking_speed(z) > 0.5 * PASSED;
            return is_beyond || stretch >= AT_LIMIT && outward > 0.5 * PASSED;
        }
        let is_on_circle = if before.limit() == self.limit() {
            self.stretch(&before.deflection_between_events()) >= 1.0 - 0.5 * OUTGROWN
        } else {
            stretch >= AT_LIMIT
        };
        outward > 0.0 && is_on_circle
    }

    fn put(&mut self, z: &Vector3<f64>) {
        [self.bristle_deflection_x, self.bristle_deflection_y, self.bristle_deflection_z] = (*z).into();
    }

    /// Follows a ramp in the plane of the present normal, whatever the speed.
    fn follow(&mut self, z: &mut Vector3<f64>, ramp: &Ramp) {
        let mut bristle = Bristle {
            deflection: *z,
            energy: self.dissipated_energy,
            normal: self.normal(),
            stiffness: self.sigma_0,
            damping: self.sigma_1,
            is_led: self.is_printed(),
        };
        let mut from = 0.0;
        for cut in ramp.cuts(self.transition_velocity).into_iter().chain([1.0]) {
            let to = cut.min(1.0);
            if to > from {
                let part = ramp.part(from, to).rounded();
                let mu = if length(&part.velocity_at(0.5)) <= self.transition_velocity { self.mu_s } else { self.mu_k };
                bristle.follow(&part, part.load.map(|load| mu * load / self.sigma_0));
                from = to;
            }
        }
        (*z, self.dissipated_energy) = (bristle.deflection, bristle.energy);
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn forces(law: &Liang) -> Vector3<f64> {
        let mut law = *law;
        law.output();
        Vector3::new(law.friction_force_x, law.friction_force_y, law.friction_force_z)
    }

    impl Liang {
        fn at_zero() -> Liang {
            let mut zero = Liang::default();
            crate::model::row_of_mut(&mut zero).fill(0.0);
            zero
        }
    }

    fn moving(law: &mut Liang, velocity: Vector3<f64>) {
        [law.velocity_x, law.velocity_y, law.velocity_z] = velocity.into();
    }

    /// A change of direction while sliding, against small steps of the clamp itself (z + v h, then back to the circle).
    #[test]
    fn turning_bristle_agrees_with_many_small_returns() {
        let mut law = Liang { velocity_x: 0.01, ..Default::default() };
        law.step(1.0);
        moving(&mut law, Vector3::new(-0.003, 0.004, 0.0));
        let (mut z, limit, n) = (Vector3::new(9.81e-6, 0.0, 0.0), 9.81e-6, 1_000_000);
        let (time, mut work) = (8e-3, 0.0);
        let before = law.dissipated_energy;
        for _ in 0..n {
            let h = time / f64::from(n);
            let old = z;
            z += law.velocity() * h;
            if z.norm() > limit {
                z *= limit / z.norm();
            }
            work += (0.5 * 1e5 * (old + z) * h + law.sigma_1 * (z - old)).dot(&law.velocity());
        }
        law.step(time);
        assert!((law.deflection() - z).norm() < 1e-6 * limit, "{} {z}", law.deflection());
        assert!(((law.dissipated_energy - before) / work - 1.0).abs() < 1e-6, "{}", law.dissipated_energy - before);
    }

    /// The plane is the same on either side: turning its normal over moves no bristle.
    #[test]
    fn a_normal_turned_over_leaves_the_deflection() {
        let turned = |normal: [f64; 3]| {
            let mut law = Liang { velocity_x: 1e-3, velocity_y: 2e-3, ..Default::default() };
            law.step(2e-3);
            moving(&mut law, Vector3::zeros());
            [law.normal_x, law.normal_y, law.normal_z] = normal;
            law.step(1e-3);
            law.deflection()
        };
        let before = turned([0.0, 0.0, 1.0]);
        assert!(before.norm() > 1e-7, "{before}");
        assert_eq!(turned([0.0, 0.0, -1.0]), before);
        let [up, down] = [[0.1, 0.2, 1.0], [-0.1, -0.2, -1.0]].map(turned);
        assert!((up - down).norm() < 1e-15 * before.norm(), "{up} {down}");
    }

    /// A tilted plane: only the tangential velocity counts, and the force lies in the plane.
    #[test]
    fn force_lies_in_the_plane_and_turns_with_it() {
        let mut law = Liang { normal_x: 3.0, normal_z: 4.0, velocity_x: 0.5, ..Default::default() };
        law.step(1.0);
        let expected = Vector3::new(0.8, 0.0, -0.6) * 0.981;
        assert!((forces(&law) - expected).norm() < 1e-15, "{}", forces(&law));
        // The plane turns, the bristle keeps its length.
        (law.velocity_x, law.normal_x, law.normal_z) = (0.0, 0.0, 1.0);
        assert!((forces(&law) - Vector3::new(0.981, 0.0, 0.0)).norm() < 1e-15);
        (law.normal_x, law.normal_z) = (1.0, 0.0);
        law.step(1e-3);
        assert!((forces(&law) - Vector3::new(0.0, 0.0, -0.981)).norm() < 1e-15);
    }

    /// Importers start from zeros: without a plane every direction is tangential, and the user is warned.
    #[test]
    fn without_a_normal_the_whole_velocity_is_tangential() {
        let mut law = Liang { normal_z: 0.0, velocity_x: 0.3, velocity_z: -0.4, ..Default::default() };
        assert!(law.check().is_ok());
        let warning = law.warning().map(|fault| fault.0).unwrap_or_default();
        assert!(warning.starts_with("normal_x, normal_y, normal_z = 0, 0, 0: the contact has no normal"), "{warning}");
        law.step(1.0);
        assert!((forces(&law) - Vector3::new(0.6, 0.0, -0.8) * 0.981).norm() < 1e-15, "{}", forces(&law));
        let slope = Liang { velocity_x: 1.0, velocity_y: 2.0, ..Liang::at_zero() };
        law.step_ramp(&slope, 0.1);
        assert!(((forces(&law)).norm() / 0.981 - 1.0).abs() < 1e-12, "{}", forces(&law));
        assert!(Liang::default().warning().is_none());
        let mut zeros = Liang { normal_z: 0.0, normal_force: 0.0, ..Default::default() };
        zeros.step(1e-3);
        assert_eq!(forces(&zeros), Vector3::zeros());
    }

    /// The trap of the printed rule: loaded forwards to 0.98 f_s, then fast backwards, so that the limit shrinks below
    /// z.
    #[test]
    fn printed_rule_flips_the_force_where_radial_return_does_not() {
        let loaded = Liang { bristle_deflection_x: 1.44e-5, velocity_x: -0.01, sigma_1: 0.0, ..Default::default() };
        assert_abs_diff_eq!(forces(&loaded).x, 0.981, epsilon = 1e-15);
        let printed = Liang { variant: 2.0, ..loaded };
        assert_abs_diff_eq!(forces(&printed).x, -0.981, epsilon = 1e-15);
    }
}
