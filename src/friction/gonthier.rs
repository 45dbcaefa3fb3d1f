use crate::contact::conditions::is_elastic;
use crate::contact::quantities::*;
use crate::contact::unloading::released_without_load;
use crate::model::{Derivatives, Fault, GivesBack, Law, Meaning, Model, ModelExchange, Preset, real};
use crate::number::elementary::{exp, exp_m1, ln};
use crate::number::{Mask, Real};

crate::model! {
    /// Gonthier friction: a bristle whose force is limited by a static level that rises with the time of rest (dwell
    /// time), so that the breakaway force depends on how long the contact has been at rest.
    ///
    /// # Equations
    ///
    /// ```text
    /// s       = exp(-(v / v_S)^2)
    /// dz/dt   = s v + (1 - s) (f_C dir(v) - sigma_0 z) / sigma_1
    /// f_br    = sigma_0 z + sigma_1 dz/dt
    /// dir(v)  = v / |v|                               |v| >= v_0        (7.42)
    ///         = (v / v_0) (3/2 - (v / v_0)^2 / 2)     |v| <  v_0
    /// ds_d/dt = (s - s_d) / tau_d                     s >= s_d
    ///         = (s - s_d) sigma_0 / sigma_1           s <  s_d
    /// f_max   = f_C + (f_s - f_C) s_d
    /// f_f     = f_br + sigma_2 v                      |f_br| <= f_max   (7.47)
    ///         = f_max sgn(f_br) + sigma_2 v           |f_br| >  f_max
    /// f_C = mu_k f_n,   f_s = mu_s f_n
    /// ```
    ///
    /// | symbol  | variable              | unit  | meaning                                          |
    /// |---------|-----------------------|-------|--------------------------------------------------|
    /// | v       | `velocity`            | m/s   | velocity of body 1 relative to body 2            |
    /// | f_n     | `normal_force`        | N     | force pressing the surfaces together             |
    /// | mu_k    | `mu_k`                | 1     | kinetic coefficient of friction                  |
    /// | mu_s    | `mu_s`                | 1     | static coefficient of friction                   |
    /// | v_S     | `stribeck_velocity`   | m/s   | speed above which the contact slides             |
    /// | v_0     | `transition_velocity` | m/s   | speed below which the direction is smoothed      |
    /// | sigma_0 | `sigma_0`             | N/m   | stiffness of the bristles                        |
    /// | sigma_1 | `sigma_1`             | N.s/m | damping of the bristles                          |
    /// | sigma_2 | `viscous_coefficient` | N.s/m | viscous coefficient                              |
    /// | tau_d   | `dwell_time_constant`          | s     | time constant with which the static level rises  |
    /// | z       | `bristle_deflection`  | m     | mean deflection of the bristles                  |
    /// | s_d     | `dwell`               | 1     | memory of the time of rest                       |
    /// | f_f     | `friction_force`      | N     | friction force                                   |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` in steady sliding; body 1 feels `-friction_force`. Dissipated power
    /// is `friction_force * velocity`; it is negative while the bristles spring back.
    ///
    /// # Step
    /// With held inputs both states relax linearly and are solved exactly; the instants at which $f_br$ passes $f_max$
    /// are located for the energy. So the result does not depend on how an interval is divided. `sticking` means that
    /// $f_br$ is within $f_max$ and more than 1 % (chosen) of the motion still goes into the bristles.
    ///
    /// A master that integrates a mass $m$ with the force it reads couples it explicitly to the stiffness $k$ and the
    /// damping $c$ of the contact at rest. If the friction steps first, a held body stays still for communication steps
    /// $h$ with $k h^2 + 2 c h < 4 m$, which is 3.9 ms for the defaults and 1 kg; above, it chatters within the bounds
    /// of the force. If all models step at once and exchange afterwards, the limit is $h < 1 / (k / c + c / m)$, 1.6
    /// ms.
    ///
    #[doc = include_str!("slopes.md")]
    /// # Errors
    /// Refused: a parameter outside its bound ($sigma_1$ must be > 0: it divides); `mu_s` < `mu_k`.
    ///
    /// # Limits
    /// The steady force is
    /// $min{f_C + sigma_1 v / (exp(v^2 / v_S^2) - 1), f_C + (f_s - f_C) exp(-v^2 / v_S^2)} + sigma_2 v$, the second of
    /// the two for all $v$ if $1.56697399 sigma_1 v_S >= f_s - f_C$, as the defaults just satisfy. $f_max$ starts from
    /// $f_C (s_d = 0)$: a new contact has no stiction yet.
    ///
    /// The limit acts on the force, not on the bristle: at speeds far below $v_S$ the deflection continues to grow
    /// while the force stays at $f_max$, up to about $sigma_1 v_S^2 / (sigma_0 v)$, and the same distance back is
    /// driven, not braked, by the bristle. Slow strokes therefore dissipate little, and if $f_max$ has risen in
    /// between, the law returns more energy than it received: it is not passive, but returns no more than ($f_s - f_C$)
    /// times the distance travelled. For $f_s = f_C$ and constant load it is passive in all histories that were tried.
    /// `normal_force` = 0 releases the contact (force, deflection and $s_d 0$).
    ///
    /// # Source
    /// Gonthier, McPhee, Lange, Piedboeuf (2004), "A regularized contact model with asymmetric damping and dwell-time
    /// dependent friction", Multibody System Dynamics 11, 209-233; equations (7.38) to (7.47) and Table 7.1 of F.
    /// Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis, University of Minho
    /// (2024). Only two of the equations above carry their number: those of the others were not legible in the copy
    /// that was available. The thesis calls $v_0$ at least one tenth of $v_S$ and commonly one hundredth, which
    /// contradicts itself: it should be at most one tenth, and here it is one hundredth. This is the scalar form; for a
    /// motion in a plane the paper uses vectors.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Gonthier;
    /// use stribeck::model::{Law, Model};
    /// let mut law = Gonthier::default();
    /// law.step(2.0); // rest for tau_d
    /// let by_hand = 1.0 - (-1.0f64).exp();
    /// assert!((law.dwell - by_hand).abs() < 1e-15);
    /// law.bristle_deflection = 1e-4; // far beyond f_max / sigma_0
    /// law.output();
    /// assert!((law.friction_force - (0.981 + 0.4905 * by_hand)).abs() < 1e-15);
    /// ```
    Gonthier: "Bristle friction with dwell time (Gonthier)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        stribeck_velocity: tunable = STRIBECK_VELOCITY,
        transition_velocity: tunable = TRANSITION_VELOCITY.start(1e-5),
        sigma_0: tunable = SIGMA_0,
        sigma_1: tunable = SIGMA_1.positive(),
        viscous_coefficient: tunable = VISCOUS_COEFFICIENT.start(0.1),
        /// Time constant with which the static level rises at rest.
        dwell_time_constant: tunable = real("s", 2.0).positive().means(Meaning::Own),
        bristle_deflection: state = BRISTLE_DEFLECTION.reinit(),
        /// Memory of the time at rest: 0 after sliding, 1 after a long rest.
        dwell: state = real("1", 0.0).at_least(0.0).at_most(1.0).reinit(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> Gonthier<T> {
    fn coulomb(&self) -> T {
        self.mu_k * self.normal_force
    }

    /// f_s - f_C.
    fn excess(&self) -> T {
        (self.mu_s - self.mu_k) * self.normal_force
    }

    /// s.
    fn stick_share(&self) -> T {
        let u = self.velocity / self.stribeck_velocity;
        (-(u * u)).exp()
    }

    /// 1 - s.
    fn slip_share(&self) -> T {
        let u = self.velocity / self.stribeck_velocity;
        -(-(u * u)).exp_m1()
    }

    /// dir(v).
    fn direction(&self) -> T {
        let u = self.velocity / self.transition_velocity;
        u.abs().at_least(T::from(1.0)).choose(|| u.sign(), || u * (T::from(1.5) - T::from(0.5) * u * u))
    }

    /// dz/dt at s.
    fn deflection_rate(&self, s: T) -> T {
        let missing = self.coulomb() * self.direction() - self.sigma_0 * self.bristle_deflection;
        s * self.velocity + (T::from(1.0) - s) * missing / self.sigma_1
    }

    /// f_br at dz/dt.
    fn bristle_force(&self, deflection_rate: T) -> T {
        self.sigma_0 * self.bristle_deflection + self.sigma_1 * deflection_rate
    }

    /// f_max.
    fn limit(&self) -> T {
        self.coulomb() + self.excess() * self.dwell
    }

    /// Rate at which s_d approaches s.
    fn dwell_rate(&self, s: T) -> T {
        let rises = s.at_least(self.dwell);
        rises.choose(|| T::from(1.0) / self.dwell_time_constant, || self.sigma_0 / self.sigma_1)
    }

    fn force(&self, bristle_force: T) -> T {
        let loaded = || bristle_force.limited(self.limit()) + self.viscous_coefficient * self.velocity;
        self.normal_force.vanishes().choose(|| T::zero(), loaded)
    }

    /// The outputs at dz/dt.
    fn respond(&mut self, deflection_rate: T) {
        let bristle_force = self.bristle_force(deflection_rate);
        self.friction_force = self.force(bristle_force);
        self.dissipated_power = self.friction_force * self.velocity;
        let within = bristle_force.abs().at_most(self.limit());
        let elastic = self.velocity.vanishes() | within & is_elastic(deflection_rate, self.velocity);
        self.sticking = T::truth(elastic & self.normal_force.is_positive());
    }

    /// The rates of the states at s and dz/dt.
    fn move_on(&self, s: T, deflection_rate: T, rate: &mut Self) {
        let is_loaded = self.normal_force.is_positive();
        rate.bristle_deflection = is_loaded.choose(|| deflection_rate, || T::zero());
        rate.dwell = is_loaded.choose(|| self.dwell_rate(s) * (s - self.dwell), || T::zero());
    }
}

impl<T: Real> Law for Gonthier<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.respond(self.deflection_rate(self.stick_share()));
    }

    fn slide_steadily(&mut self) {
        let is_loaded = self.normal_force.is_positive();
        let (s, slip_share) = (self.stick_share(), self.slip_share());
        self.dwell = is_loaded.choose(|| s, || T::zero());
        // Where dz/dt vanishes; a bristle that never yields is stretched beyond its limit.
        let yielding =
            || (self.coulomb() * self.direction() + self.sigma_1 * s * self.velocity / slip_share) / self.sigma_0;
        let unyielding = || self.velocity.sign() * (self.coulomb() + self.excess()) / self.sigma_0;
        let moving = || slip_share.is_positive().choose(yielding, unyielding);
        let loaded = || self.velocity.vanishes().choose(|| self.bristle_deflection, moving);
        self.bristle_deflection = is_loaded.choose(loaded, || T::zero());
    }
}

impl<T: Real> Derivatives for Gonthier<T> {
    fn derivatives(&self, rate: &mut Self) {
        let s = self.stick_share();
        let deflection_rate = self.deflection_rate(s);
        self.move_on(s, deflection_rate, rate);
        rate.dissipated_energy = self.force(self.bristle_force(deflection_rate)) * self.velocity;
    }

    fn output_and_derivatives(&mut self, rate: &mut Self) {
        let s = self.stick_share();
        let deflection_rate = self.deflection_rate(s);
        self.move_on(s, deflection_rate, rate);
        self.respond(deflection_rate);
        rate.dissipated_energy = self.dissipated_power;
    }
}

impl Gonthier {
    /// The motion of the states from now on, with held inputs.
    fn course(&self) -> Course {
        let s = self.stick_share();
        Course {
            law: *self,
            rate: self.slip_share() * self.sigma_0 / self.sigma_1,
            deflection_rate: self.deflection_rate(s),
            dwell_rate: self.dwell_rate(s),
            dwell_missing: s - self.dwell,
        }
    }
}

impl Model for Gonthier {
    const STEADY_SLIDING: bool = true;
    const PRESETS: &'static [Preset] = &[Preset {
        name: "thesis",
        source: "Novais (2024), Tables 6.1 and 7.1, v_0 = v_S / 100 of its text (the start values)",
        values: &[],
    }];

    released_without_load!(bristle_deflection, dwell);

    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    fn passivity(&self) -> Option<GivesBack> {
        crate::laws::passivity::equal_levels(self.mu_s, self.mu_k)
    }

    fn step(&mut self, dt: f64) {
        let Some(course) = self.advance(dt) else { return };
        if self.velocity != 0.0 {
            let viscous = self.viscous_coefficient * self.velocity * dt;
            self.dissipated_energy += self.velocity * (course.impulse(dt) + viscous);
        }
    }

    fn step_without_energy(&mut self, _memory: &mut [f64], dt: f64) {
        self.advance(dt);
    }
}

impl Gonthier {
    /// Advances the states, the energy apart. Returns their course, if there is a load.
    fn advance(&mut self, dt: f64) -> Option<Course> {
        if self.normal_force == 0.0 {
            (self.bristle_deflection, self.dwell) = (0.0, 0.0);
            return None;
        }
        let course = self.course();
        self.bristle_deflection = course.deflection(dt);
        self.dwell = course.dwell(dt).clamp(0.0, 1.0);
        Some(course)
    }
}

/// The states as functions of the time t since the start of a step.
struct Course {
    law: Gonthier,
    rate: f64,
    deflection_rate: f64,
    dwell_rate: f64,
    dwell_missing: f64,
}

impl Course {
    /// z(t).
    fn deflection(&self, t: f64) -> f64 {
        self.law.bristle_deflection + self.deflection_rate * t * first(self.rate * t)
    }

    /// s_d(t).
    fn dwell(&self, t: f64) -> f64 {
        self.law.dwell - self.dwell_missing * exp_m1(-self.dwell_rate * t)
    }

    /// f_br(t).
    fn bristle_force(&self, t: f64) -> f64 {
        self.law.sigma_0 * self.deflection(t) + self.law.sigma_1 * self.deflection_rate * exp(-self.rate * t)
    }

    /// f_max(t).
    fn limit(&self, t: f64) -> f64 {
        self.law.coulomb() + self.law.excess() * self.dwell(t)
    }

    /// Integral of f_br up to t.
    fn bristle_impulse(&self, t: f64) -> f64 {
        let travel = self.deflection_rate * t * first(self.rate * t);
        let area = t * self.law.bristle_deflection + self.deflection_rate * t * t * second(self.rate * t);
        self.law.sigma_0 * area + self.law.sigma_1 * travel
    }

    /// Integral of f_max up to t.
    fn limit_impulse(&self, t: f64) -> f64 {
        let dwell = t * self.law.dwell + self.dwell_missing * t * (1.0 - first(self.dwell_rate * t));
        self.law.coulomb() * t + self.law.excess() * dwell
    }

    /// Integral of the limited bristle force up to `end`.
    fn impulse(&self, end: f64) -> f64 {
        let ends = [0.0, end].map(|t| [self.limit(t), self.bristle_force(t)]);
        let crossings = |side: f64| self.crossings(side, end, ends.map(|[limit, force]| limit - side * force > 0.0));
        let ([a, b], [c, d]) = (crossings(1.0), crossings(-1.0));
        let mut cuts = [0.0, a, b, c, d, end];
        cuts.sort_by(f64::total_cmp);
        cuts.windows(2).filter(|w| w[1] > w[0]).map(|w| self.piece(w[0], w[1])).sum()
    }

    /// As `impulse`, where f_br is on the same side of f_max throughout.
    fn piece(&self, from: f64, to: f64) -> f64 {
        let middle = 0.5 * (from + to);
        let force = self.bristle_force(middle);
        // Up to the beginning there is none.
        let between = |impulse: &dyn Fn(f64) -> f64| impulse(to) - if from > 0.0 { impulse(from) } else { 0.0 };
        if force.abs() <= self.limit(middle) {
            between(&|t| self.bristle_impulse(t))
        } else {
            force.signum() * between(&|t| self.limit_impulse(t))
        }
    }

    /// The instants up to `end` at which f_max = side f_br: at most two; `end` stands for a missing one. `above` tells
    /// whether f_max is greater at the beginning and at the end.
    fn crossings(&self, side: f64, end: f64, above: [bool; 2]) -> [f64; 2] {
        let is_above = |t: f64| self.limit(t) - side * self.bristle_force(t) > 0.0;
        let Some(turn) = self.turn(side).filter(|turn| *turn > 0.0 && *turn < end) else {
            return [bisect(is_above, [0.0, end], above).unwrap_or(end), end];
        };
        let (begins, turns, ends) = (above[0], is_above(turn), above[1]);
        let crossings = [bisect(is_above, [0.0, turn], [begins, turns]), bisect(is_above, [turn, end], [turns, ends])];
        crossings.map(|crossing| crossing.unwrap_or(end))
    }

    /// The instant of the only extremum of f_max - side f_br, the sum of two exponentials and a constant.
    fn turn(&self, side: f64) -> Option<f64> {
        let rise = self.law.excess() * self.dwell_missing * self.dwell_rate;
        let bristle_rise = side * (self.law.sigma_0 - self.law.sigma_1 * self.rate) * self.deflection_rate;
        let turn = ln(bristle_rise / rise) / (self.rate - self.dwell_rate);
        turn.is_finite().then_some(turn)
    }
}

/// (1 - exp(-x)) / x.
fn first(x: f64) -> f64 {
    if x < 1e-8 { 1.0 - 0.5 * x } else { -exp_m1(-x) / x }
}

/// (x - 1 + exp(-x)) / x^2.
fn second(x: f64) -> f64 {
    if x > 1.0 {
        return (1.0 - first(x)) / x;
    }
    // Horner's form of sum (-x)^k / (k + 2)!; eighteen terms leave less than 1 / 20!.
    (3..=20).rev().fold(1.0, |sum, k| 1.0 - x * sum / f64::from(k)) / 2.0
}

/// The instant at which an answer changes that is known at both ends, and changes at most once.
fn bisect(is_above: impl Fn(f64) -> bool, [mut low, mut high]: [f64; 2], [begins, ends]: [bool; 2]) -> Option<f64> {
    if begins == ends {
        return None;
    }
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return Some(middle);
        }
        if is_above(middle) == begins {
            low = middle;
        } else {
            high = middle;
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    #[test]
    fn relaxation_functions_join_their_series() {
        for x in [1e-9, 0.9e-8, 1.1e-8, 1e-3, 0.999_999, 1.000_001, 5.0, 800.0] {
            assert!((1.0 - x * second(x) - first(x)).abs() < 1e-14, "{x}");
            // d/dx of x first(x) is exp(-x).
            let h = 1e-5 * x;
            let slope = ((x + h) * first(x + h) - (x - h) * first(x - h)) / (2.0 * h);
            assert!((slope - (-x).exp()).abs() < 1e-9, "{x}: {slope}");
        }
    }

    /// A long step against the trapezoidal sum of the power, through reversals, saturation and dwell.
    #[test]
    fn energy_is_the_integral_of_power() {
        let mut law = Gonthier::default();
        let mut integral = 0.0;
        for (velocity, time) in [(1e-4, 0.3), (-1e-3, 0.02), (1e-6, 3.0), (-2e-4, 0.5), (5e-3, 0.01), (-0.02, 1e-3)] {
            law.velocity = velocity;
            let (mut fine, n) = (law, 200_000);
            for _ in 0..n {
                fine.output();
                let before = fine.dissipated_power;
                fine.step(time / f64::from(n));
                fine.output();
                integral += 0.5 * (before + fine.dissipated_power) * time / f64::from(n);
            }
            law.step(time);
            assert_abs_diff_eq!(law.bristle_deflection / fine.bristle_deflection, 1.0, epsilon = 1e-10);
            assert!((law.dissipated_energy - integral).abs() < 1e-8 * integral.abs(), "{velocity}: {integral}");
        }
    }

    /// Slides slowly, rests, slides back: the bristle has wound up and returns more energy than it received, within the
    /// stated bound.
    #[test]
    fn dwell_makes_the_law_active_within_the_stated_bound() {
        let mut law =
            Gonthier { velocity: 1e-5, dwell_time_constant: 20.0, viscous_coefficient: 0.0, ..Default::default() };
        law.step(3.0);
        law.velocity = 0.0;
        law.step(1000.0);
        law.velocity = -1e-5;
        law.step(2.6);
        assert!(law.dissipated_energy < -1e-6, "{}", law.dissipated_energy);
        assert!(law.dissipated_energy > -0.4905 * 6e-5, "{}", law.dissipated_energy);
    }

    /// tau_d -> 0: at rest the static level is reached at once.
    #[test]
    fn short_dwell_time_gives_full_stiction_at_once() {
        let mut law = Gonthier { dwell_time_constant: 1e-9, bristle_deflection: 1e-3, ..Default::default() };
        law.step(1e-6);
        law.output();
        assert_abs_diff_eq!(law.friction_force, 1.4715, epsilon = 1e-12);
    }

    /// dir(v) is odd and joins the signs at the transition velocity without a kink.
    #[test]
    fn direction_joins_the_signs_smoothly() {
        let at = |u: f64| {
            let start = Gonthier::default();
            Gonthier { velocity: u * start.transition_velocity, ..start }.direction()
        };
        for side in [1.0, -1.0] {
            assert_eq!([at(side), at(3.0 * side), at(0.0)], [side, side, 0.0]);
            let h = 1e-4;
            // A parabola touches the plateau: it is 3/2 h^2 lower at a distance of h.
            assert_abs_diff_eq!((1.0 - side * at(side * (1.0 - h))) / (h * h), 1.5, epsilon = 1e-3);
            assert_eq!(at(-0.3 * side), -at(0.3 * side));
        }
    }
}
