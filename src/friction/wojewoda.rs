use crate::contact::branching::{AccelerationSource, Branching};
use crate::contact::motion::Motion;
use crate::contact::quantities::*;
use crate::contact::time_stepping::{Branches, Curve, MOVED, OnCurve, PASSED, Phase, PhaseColumn, REACHED};
use crate::contact::unloading;
use crate::laws::branches;
use crate::model::{Derivatives, Fault, Law, Meaning, Model, ModelExchange, Preset, ramp, real};
use crate::number::{Mask, Real, choose};
use crate::numerics::quadrature::integral_past_peak;
use crate::numerics::root::first_rise;

crate::model! {
    /// Hysteretic friction of Wojewoda and others, reconstructed: a spring while the contact sticks, and while it
    /// slides one curve for speeding up and its mirror image for slowing down.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = sigma_0 z,   dz/dt = v                                       stuck, |f_f| <= f_s
    /// f_f = [f_C + (f_s - f_C) exp(-a |v|)] sgn(v)     v v' >= 0         sliding
    /// f_f = [f_C - (f_s - f_C) exp(-a |v|)] sgn(v)     v v' <  0         sliding
    /// f_C = mu_k f_n,   f_s = mu_s f_n
    /// ```
    ///
    /// The first line is the hysteretic spring $f_rev + sigma_0 (s - s_rev)$ from the last reversal point
    /// $(s_rev, f_rev)$ on. The changes between the two states are chosen:
    ///
    /// ```text
    /// stuck -> sliding    sigma_0 |z| reaches f_s in the direction of v
    /// sliding -> stuck    v reaches or passes 0; sigma_0 |z| := 2 f_C - f_s, where the lower curve ends
    /// ```
    ///
    /// Whether a free body speeds up depends on this force itself. With `acceleration_source` = Balance the external
    /// force $f_e$ decides; between the curves a sliding body keeps its velocity ($v > 0$; mirrored for $v < 0$). With
    /// $f_fu$ for the second line above and $f_fl$ for the third:
    ///
    /// ```text
    /// f_f = f_fu                                  f_e > f_fu
    /// f_f = f_e                                   f_fl <= f_e <= f_fu
    /// f_f = f_fl                                  f_e < f_fl
    /// ```
    ///
    /// | symbol  | variable             | unit | meaning                                              |
    /// |---------|----------------------|------|------------------------------------------------------|
    /// | v       | `velocity`           | m/s  | velocity of body 1 relative to body 2                |
    /// | f_n     | `normal_force`       | N    | force pressing the surfaces together                 |
    /// | f_e     | `external_force`     | N    | resultant of all other tangential forces             |
    /// | v'      | `acceleration`       | m/s2 | acceleration of body 1 relative to body 2            |
    /// |         | `velocity_slope`     | m/s2 | $v'$ from a given slope of the velocity              |
    /// | mu_k    | `mu_k`               | 1    | kinetic coefficient of friction                      |
    /// | mu_s    | `mu_s`               | 1    | static coefficient of friction                       |
    /// | sigma_0 | `sigma_0`            | N/m  | stiffness of the stuck contact                       |
    /// | a       | `branch_decay`       | s/m  | steepness of both curves                             |
    /// |         | `slipping`           |      | whether the contact has broken away                  |
    /// | z       | `bristle_deflection` | m    | elastic displacement; sliding: that of the breakaway |
    /// |         | `phase`              |      | motion as found by the last event of Model Exchange  |
    /// | f_f     | `friction_force`     | N    | friction force                                       |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` while sliding and of the elastic displacement while stuck; body 1
    /// feels `-friction_force`. Dissipated power is `friction_force * velocity`; it is negative while the stuck contact
    /// springs back.
    ///
    /// # Step
    /// Exact for held inputs. Inputs that move linearly are followed too: breakaway is the first zero of a parabola and
    /// the stop the zero of the velocity, both located to the last bit within the step, so they do not depend on how an
    /// interval is divided. A held velocity that jumps across zero stops at the beginning of the step. The sign of the
    /// acceleration is that of the slope of `velocity` if the master gives one (fmi2SetRealInputDerivatives), otherwise
    /// that of the input `acceleration` at the beginning of the step; without either it is 0 and the upper curve
    /// applies. After a step with a slope the outputs use that slope until the next step. The dissipated energy is a
    /// closed form while stuck and for held inputs, and otherwise a quadrature with a relative error below 1e-10. In a
    /// balance of forces inputs that move linearly are held at their means over sixteenths of a step, which is of second
    /// order; breakaway and stop are then located to one of them.
    ///
    /// In Model Exchange breakaway, stop and the change between the curves are events, and the force between two of them
    /// is that of one line above, also where a solver tries values beyond. A free body needs Balance, with
    /// `external_force` connected; a motion that is prescribed needs Input and its acceleration. If the load of a stuck
    /// contact falls, its force follows the level at once, and the displacement with a time constant of 0.1 ms.
    ///
    /// A master that integrates a mass $m$ with the force it reads couples it explicitly to the stiffness k of the
    /// contact at rest. If the friction steps first, a held body stays still for communication steps below
    /// $2 sqrt(m / k)$, which is 6.3 ms for the defaults and 1 kg; above, it chatters within the bounds of the force.
    /// If all models step at once and exchange afterwards, it chatters at every step, since nothing damps the
    /// stiffness: take the friction first.
    ///
    /// With Input sliding needs a shorter step: at breakaway, an acceleration computed from the last force occasionally puts the
    /// contact on the lower curve for one step, which changes the velocity by $2 (f_s - f_C) h / m$. For a block of 1
    /// kg on a belt of 0.1 m/s the stick-slip period is 0.6 % too short at $h = 16$ us, 2 % at 31 us and 37 % at 1 ms. A
    /// balance of forces has no such loop.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`; `mu_s` > 2 `mu_k`, because the lower curve would then
    /// push.
    ///
    /// # Limits
    /// No damping while stuck: a mass on the contact oscillates. The force jumps where the acceleration changes its
    /// sign, and at the stop to the end of the lower curve; an acceleration that is itself computed from this force
    /// closes a loop that may switch at every step, unless forces decide. A stuck contact at $v = 0$ holds. `mu_s` = `mu_k` is the elastic
    /// and perfectly plastic contact. If the load falls, the displacement is cut to what the level can carry: at the
    /// beginning of a step, at the end of one with slopes, and in the force at once.
    ///
    /// Passive at constant load: the curves never push, and the stop leaves $(2 f_C - f_s)^2 / (2 sigma_0)$ in the
    /// spring, not more than the $f_s^2 / (2 sigma_0)$ that the breakaway left there. A load that rises from $f_n1$ to
    /// $f_n2$ while sliding charges the contact at the next stop, so that it may return up to
    /// $[(2 mu_k - mu_s)^2 f_n2^2 - mu_s^2 f_n1^2] / (2 sigma_0)$ more than was put in. `normal_force` = 0 releases the
    /// contact: force 0, and the next step makes it stuck and undeflected.
    ///
    /// # Source
    /// Reconstructed after Wojewoda, Stefanski, Wiercigroch and Kapitaniak (2008), "Hysteretic effects of dry friction:
    /// modelling and experimental studies", Phil. Trans. R. Soc. A 366, 747-765, which was not available: its function
    /// for sticking and the argument of its exponential could not be confirmed. The page of F. Novais, "A critical
    /// analysis on friction force models in dynamical systems", MSc thesis, University of Minho (2024), was not
    /// available either. The defaults $a = 500$ s/m and $sigma_0$ are chosen; the latter is that of the bristle models.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Wojewoda;
    /// use stribeck::model::{Law, Model};
    /// let mut law = Wojewoda { velocity: 1e-5, ..Default::default() };
    /// law.step(1.0); // 10 um of pre-sliding
    /// law.output();
    /// assert!((law.friction_force - 1.0).abs() < 1e-15);
    /// law.velocity = 0.002;
    /// law.step(1.0); // slides, a v = 1
    /// law.output();
    /// assert!((law.friction_force - (0.981 + 0.4905 * (-1.0f64).exp())).abs() < 1e-15);
    /// ```
    Wojewoda: "Hysteretic friction: stuck spring, two branches of sliding (reconstructed after Wojewoda)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        /// How the acceleration is known.
        branching: (Branching),
        /// How the law knows whether the contact speeds up or slows down.
        acceleration_source: fixed = AccelerationSource::Input.start(),
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        sigma_0: tunable = SIGMA_0,
        /// Steepness of the curves for speeding up and slowing down (default chosen).
        branch_decay: tunable = real("s/m", 500.0).positive().nominal(500.0).means(Meaning::Own),
        slipping: state = SLIPPING,
        bristle_deflection: state = BRISTLE_DEFLECTION.reinit(),
        /// Motion of the contact as found by the last event of Model Exchange.
        phase: state = Phase::Free.start(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

/// Time constant of a deflection that a falling load pushes back, in s (chosen).
const PUSHED: f64 = 1e-4;

impl<T: Real> Wojewoda<T> {
    /// End of the lower curve, per normal force: 2 mu_k - mu_s.
    fn mu_stop(&self) -> T {
        self.mu_k + self.mu_k - self.mu_s
    }

    /// Level of the lower curve.
    fn lower(&self, velocity: T) -> T {
        let load = self.normal_force;
        branches::level(velocity, self.mu_k * load, self.mu_stop() * load, self.branch_decay)
    }

    /// Level of the upper curve.
    fn upper(&self, velocity: T) -> T {
        let load = self.normal_force;
        branches::level(velocity, self.mu_k * load, self.mu_s * load, self.branch_decay)
    }

    /// Largest deflection that the level can carry.
    fn limit(&self) -> T {
        self.mu_s * self.normal_force / self.sigma_0
    }

    /// Deflection, limited to what the level can carry.
    fn held_deflection(&self) -> T {
        self.bristle_deflection.pushed_back(self.limit())
    }

    /// Motion of the contact as found by the last event of Model Exchange.
    fn phase(&self) -> PhaseColumn<T> {
        PhaseColumn(self.phase)
    }

    fn is_slipping(&self) -> T::Mask {
        !self.slipping.vanishes()
    }

    /// Whether the contact has slid until now and a velocity of this sign brings it to rest.
    fn arrives(&self, direction: T) -> T::Mask {
        let is_opposite = self.bristle_deflection.sign().equals(-direction);
        self.is_slipping() & (direction.vanishes() | is_opposite)
    }

    /// The same of the present velocity. Between events it never does.
    fn is_arriving(&self) -> T::Mask {
        self.phase().is_free() & self.arrives(self.velocity.sign())
    }

    /// Whether the contact is stuck.
    fn is_stuck(&self) -> T::Mask {
        self.phase().is(Phase::Held) | self.phase().is_free() & !self.is_slipping()
    }

    /// Rate of the deflection.
    fn deflection_rate(&self) -> T {
        let excess = self.bristle_deflection - self.held_deflection();
        let is_outward = (self.velocity * excess).is_positive();
        let pushed_back = choose!(is_outward, T::zero(), excess / T::from(PUSHED));
        choose!(self.is_stuck() & !self.normal_force.vanishes(), self.velocity - pushed_back, T::zero())
    }

    /// The contact on its two curves.
    fn contact(&self) -> OnCurve<'_, T, Self> {
        let Wojewoda { velocity, normal_force, external_force, .. } = *self;
        OnCurve { law: self, velocity, normal_force, external_force, phase: self.phase() }
    }

    fn force(&self) -> T {
        let load = self.normal_force;
        let arriving = || self.mu_stop() * load * self.bristle_deflection.sign();
        let slipping = || self.contact().sliding_on_branches();
        let stuck = || self.sigma_0 * self.held_deflection();
        let moving = || self.is_stuck().choose(stuck, slipping);
        load.vanishes().choose(|| T::zero(), || self.is_arriving().choose(arriving, moving))
    }
}

impl<T: Real> Curve<T> for Wojewoda<T> {
    fn curve(&self, velocity: T) -> T {
        let slows_down = branches::slows_down(velocity, self.branching.known_acceleration());
        slows_down.choose(|| self.lower(velocity), || self.upper(velocity)) * velocity.sign()
    }

    fn level(&self) -> T {
        self.mu_s * self.normal_force
    }

    fn band(&self) -> Option<T> {
        None
    }
}

impl<T: Real> Branches<T> for Wojewoda<T> {
    fn levels(&self, velocity: T) -> [T; 2] {
        [self.lower(velocity), self.upper(velocity)]
    }

    fn is_by_balance(&self) -> T::Mask {
        AccelerationSource::Balance.is(self.acceleration_source)
    }
}

impl<T: Real> Law for Wojewoda<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.friction_force = self.force();
        self.dissipated_power = self.friction_force * self.velocity;
        let stuck = self.is_stuck() | self.is_arriving();
        self.sticking = T::truth(stuck & self.normal_force.is_positive());
    }
}

impl<T: Real> Derivatives for Wojewoda<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.bristle_deflection = self.deflection_rate();
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

impl Wojewoda {
    /// Advances over inputs that move linearly.
    fn advance(&mut self, motion: Motion) {
        self.branching.begin(&motion);
        for part in motion.parts() {
            if part.is_unloaded() {
                self.slipping = 0.0;
                self.bristle_deflection = 0.0;
            } else {
                self.follow(part);
            }
        }
    }

    /// Ends a step, once the inputs have their final values: puts a deflection that the level has limited exactly on
    /// its limit.
    fn settle(&mut self) {
        if !self.is_slipping() {
            self.limit_deflection(self.normal_force);
        }
    }

    /// |z| in parts of the largest that the level can carry.
    fn stretch(&self) -> f64 {
        self.bristle_deflection.abs() / self.limit()
    }

    /// Speed in the direction of the deflection, in parts of the least one that counts.
    fn outward_speed(&self) -> f64 {
        self.velocity * self.bristle_deflection.sign() / MOVED
    }

    /// Motion of the contact after an event. The limits lie between those of the indicator.
    fn settled(&self) -> Phase {
        let breaks = self.stretch() >= 1.0 + 0.5 * REACHED && self.outward_speed() > 0.5 * PASSED;
        match Phase::of(self.phase).direction() {
            _ if unloading::is_unloaded(self.normal_force) => Phase::Held,
            Some(direction) if direction * self.velocity > 0.0 => Phase::sliding(direction),
            None if breaks || !(self.is_stuck() | self.is_arriving()) => Phase::sliding(self.velocity),
            _ => Phase::Held,
        }
    }

    /// Deflection after an event that has found a contact stuck.
    fn stuck_deflection(&self) -> f64 {
        let slid = match Phase::of(self.phase) {
            Phase::Free if self.is_slipping() => self.bristle_deflection.sign(),
            phase => phase.direction().unwrap_or(0.0),
        };
        if unloading::is_unloaded(self.normal_force) {
            0.0
        } else if slid == 0.0 {
            self.held_deflection()
        } else {
            self.stopped(slid, self.normal_force)
        }
    }

    /// Advances over a motion in one direction.
    fn follow(&mut self, part: Motion) {
        if self.arrives(part.direction()) {
            self.stop(part.load);
        }
        if self.is_slipping() {
            self.slide(part);
            return;
        }
        self.limit_deflection(part.load);
        let Some(breakaway) = self.breakaway(&part) else {
            self.stick(part);
            return;
        };
        self.stick(part.part(0.0, breakaway));
        self.slipping = 1.0;
        self.slide(part.part(breakaway, part.duration));
    }

    /// Sliding -> stuck.
    fn stop(&mut self, load: f64) {
        self.bristle_deflection = self.stopped(self.bristle_deflection.sign(), load);
        self.slipping = 0.0;
    }

    /// Deflection of a contact that has come to rest.
    fn stopped(&self, direction: f64, load: f64) -> f64 {
        direction * self.mu_stop() * load / self.sigma_0
    }

    /// The first instant of a motion at which sigma_0 z reaches f_s in the direction of motion.
    fn breakaway(&self, part: &Motion) -> Option<f64> {
        let direction = part.direction();
        if direction == 0.0 {
            return None;
        }
        let stiffness = direction * self.sigma_0;
        let excess = |t: f64| stiffness * (self.bristle_deflection + part.path(t)) - self.mu_s * part.load_at(t);
        let parabola =
            [stiffness * part.velocity - self.mu_s * part.load_rate, stiffness * 0.5 * part.acceleration, 0.0];
        first_rise(excess, parabola, part.duration)
    }

    /// Limits the displacement to what the level can carry.
    fn limit_deflection(&mut self, load: f64) {
        self.bristle_deflection = Wojewoda { normal_force: load, ..*self }.held_deflection();
    }

    fn stick(&mut self, part: Motion) {
        let (before, change) = (self.bristle_deflection, part.path(part.duration));
        self.bristle_deflection += change;
        self.dissipated_energy += self.sigma_0 * change * (before + 0.5 * change);
    }

    fn slide(&mut self, part: Motion) {
        self.dissipated_energy += self.work(&part);
        self.bristle_deflection = part.direction() * self.mu_s * part.load_at(part.duration) / self.sigma_0;
    }

    /// Energy dissipated while sliding.
    fn work(&self, part: &Motion) -> f64 {
        let power = |t: f64| {
            let moved = Wojewoda { velocity: part.velocity_at(t), normal_force: part.load_at(t), ..*self };
            moved.contact().sliding_on_branches() * moved.velocity
        };
        if part.is_steady() {
            return power(0.0) * part.duration;
        }
        let band = branches::FADED / self.branch_decay;
        integral_past_peak(&power, &|t| part.velocity_at(t), band, 0.0, part.duration)
    }
}

impl Model for Wojewoda {
    const PRESETS: &'static [Preset] = &[Preset {
        name: "rubber_pad",
        source: "Example of a soft pad with a wide hysteresis",
        values: &[("mu_k", 0.5), ("mu_s", 0.8), ("sigma_0", 2e4), ("branch_decay", 50.0)],
    }];

    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)?;
        if self.mu_s > 2.0 * self.mu_k {
            return Err(Fault::new(format_args!("mu_s = {}: must be <= 2 mu_k = {}", self.mu_s, 2.0 * self.mu_k)));
        }
        Ok(())
    }

    const EVENT_INDICATORS: usize = 4;

    fn is_linear(&self) -> bool {
        self.phase().is(Phase::Held)
    }

    fn event_indicators(&self, indicators: &mut [f64]) {
        let change = match Phase::of(self.phase).direction() {
            None => (1.0 + REACHED - self.stretch()).max(PASSED - self.outward_speed()),
            Some(direction) => direction * self.velocity / MOVED + PASSED,
        };
        let [lower, upper] = self.contact().changes_of_branch(self.branching.known_acceleration());
        indicators.copy_from_slice(&[change, lower, upper, unloading::load(self.normal_force)]);
    }

    fn at_event(&mut self) {
        self.branching.velocity_slope = 0.0;
        let phase = self.settled();
        let stuck = self.stuck_deflection();
        self.bristle_deflection = phase.direction().map_or(stuck, |direction| direction * self.limit());
        self.slipping = f64::from(u8::from(phase.direction().is_some()));
        self.phase = phase.number();
    }

    fn step(&mut self, dt: f64) {
        self.phase = Phase::Free.number();
        self.advance(Motion::held(self.velocity, self.normal_force, dt));
        self.settle();
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        self.phase = Phase::Free.number();
        if self.is_by_balance() {
            ramp::in_pieces(self, slope, dt, ramp::PIECES);
            return self.settle();
        }
        let begin = ramp::Inputs::of(self);
        self.advance(Motion {
            acceleration: slope.velocity,
            load_rate: slope.normal_force,
            ..Motion::held(self.velocity, self.normal_force, dt)
        });
        ramp::set_inputs(self, &begin, slope, dt);
        self.settle();
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    const F_C: f64 = 0.981;
    const F_S: f64 = 1.4715;

    fn force(law: &mut Wojewoda) -> f64 {
        law.output();
        law.friction_force
    }

    fn go(law: &mut Wojewoda, velocity: f64, time: f64) -> f64 {
        law.velocity = velocity;
        law.step(time);
        force(law)
    }

    fn ramp(law: &mut Wojewoda, slope: f64, time: f64) -> f64 {
        let slopes = Wojewoda { velocity: slope, normal_force: 0.0, ..*law };
        law.step_ramp(&slopes, time);
        force(law)
    }

    /// Below f_s unloading follows the loading line: the loop closes without area.
    #[test]
    fn the_presliding_loop_closes() {
        let mut law = Wojewoda::default();
        for velocity in [1e-5, -1e-5, -1.4e-5, 1.4e-5, 0.0] {
            go(&mut law, velocity, 1.0);
            assert_eq!(law.sticking, 1.0);
        }
        assert!(force(&mut law).abs() < 1e-15 && law.dissipated_energy.abs() < 1e-20);
    }

    /// Back and forth by 2 X, so slowly that the curves have not fallen from f_s: the loop of an elastic, plastic
    /// contact that starts from 2 f_C - f_s after each stop. The elastic travel to f_s on the other side is s = 2 f_C /
    /// sigma_0, so the area is 2 [f_s (2 X - s) + (f_s^2 - (2 f_C - f_s)^2) / (2 sigma_0)].
    #[test]
    fn a_loop_beyond_breakaway_closes_and_has_its_area() {
        let (x, stop) = (1e-4, 2.0 * F_C - F_S);
        let mut law = Wojewoda { branch_decay: 1e-3, ..Default::default() };
        go(&mut law, x, 1.0);
        for _ in 0..3 {
            let before = law.dissipated_energy;
            let back = go(&mut law, -2.0 * x, 1.0);
            let forth = go(&mut law, 2.0 * x, 1.0);
            assert!((back + F_S).abs() < 1e-6 && (forth - F_S).abs() < 1e-6, "{back} {forth}");
            let elastic = 2.0 * F_C / 1e5;
            let area = 2.0 * (F_S * (2.0 * x - elastic) + (F_S * F_S - stop * stop) / 2e5);
            assert_abs_diff_eq!(law.dissipated_energy - before, area, epsilon = 1e-6 * area);
        }
    }

    #[test]
    fn sliding_has_two_branches() {
        let fading = (-500.0f64 * 0.003).exp() * (F_S - F_C);
        for sign in [1.0, -1.0] {
            let mut law = Wojewoda::default();
            assert_abs_diff_eq!(sign * go(&mut law, sign * 0.003, 1.0) - F_C, fading, epsilon = 1e-15);
            law.branching.acceleration = sign * -2.0;
            assert!((sign * force(&mut law) - F_C + fading).abs() < 1e-15);
            law.branching.acceleration = sign * 2.0;
            assert_abs_diff_eq!(sign * force(&mut law) - F_C, fading, epsilon = 1e-15);
        }
    }

    /// From rest up to 10 mm/s, down to rest and on in the other direction: the force follows the spring, the upper
    /// curve, the lower curve, the spring.
    #[test]
    fn ramps_pass_through_all_branches() {
        let mut law = Wojewoda::default();
        // 1/2 v' t^2 = f_s / sigma_0 / 4 after half of the time to breakaway.
        let breakaway = (2.0 * F_S / 1e5 / 0.1f64).sqrt();
        assert_abs_diff_eq!(ramp(&mut law, 0.1, 0.5 * breakaway), 0.25 * F_S, epsilon = 1e-15);
        assert_eq!(law.sticking, 1.0);
        let up = ramp(&mut law, 0.1, 0.1 - 0.5 * breakaway);
        assert!((up - F_C - 0.4905 * (-5.0f64).exp()).abs() < 1e-14, "{up}");
        let down = ramp(&mut law, -0.1, 0.09);
        assert!((down - F_C + 0.4905 * (-0.5f64).exp()).abs() < 1e-12, "{down}");
        let t = 0.5 * breakaway;
        let back = ramp(&mut law, -0.1, 0.01 + t);
        assert!((back - (2.0 * F_C - F_S) + 1e5 * 0.05 * t * t).abs() < 1e-11, "{back}");
    }

    /// Energy and force of a ramp through zero do not depend on its division; energy against the midpoint rule.
    #[test]
    fn energy_is_the_integral_of_power() {
        let mut law = Wojewoda::default();
        go(&mut law, -2e-3, 0.1);
        let slope = Wojewoda { velocity: 0.3, normal_force: -150.0, ..law };
        let (mut dense, n) = (law, 50_000);
        law.step_ramp(&slope, 0.04);
        let mut energy = dense.dissipated_energy;
        for _ in 0..n {
            dense.step_ramp(&slope, 0.02 / f64::from(n));
            energy += { force(&mut dense) * dense.velocity } * 0.04 / f64::from(n);
            dense.step_ramp(&slope, 0.02 / f64::from(n));
        }
        assert_abs_diff_eq!(law.dissipated_energy / dense.dissipated_energy, 1.0, epsilon = 1e-8);
        assert_abs_diff_eq!(law.dissipated_energy / energy, 1.0, epsilon = 1e-4);
        assert_abs_diff_eq!(force(&mut law), force(&mut dense), epsilon = 1e-8);
    }

    #[test]
    fn passive_at_constant_load_and_within_the_stated_bound_else() {
        let mut law = Wojewoda::default();
        for k in 0..20_000 {
            let phase = f64::from(k);
            law.branching.acceleration = (phase * 7.1).sin();
            go(&mut law, 3e-3 * (phase * 12.9898).sin() * (phase * 0.7).cos(), 2e-3);
            assert!(law.dissipated_energy >= 0.0, "{k}: {}", law.dissipated_energy);
        }
        let mut law = Wojewoda { normal_force: 1.0, ..Default::default() };
        go(&mut law, 1e-6, 1.500_001);
        law.normal_force = 1000.0;
        go(&mut law, 1e-9, 1e-6);
        go(&mut law, -5e-4, 1.0);
        let bound = ((0.05f64 * 1000.0).powi(2) - 0.15f64.powi(2)) / 2e5;
        assert!(law.dissipated_energy < -0.9 * bound && law.dissipated_energy >= -bound, "{}", law.dissipated_energy);
    }

    #[test]
    fn a_lower_curve_that_would_push_is_refused_by_name() {
        let law = Wojewoda { mu_s: 0.25, ..Default::default() };
        assert_eq!(law.check().unwrap_err().0, "mu_s = 0.25: must be <= 2 mu_k = 0.2");
        // At the limit the lower curve ends at 0.
        let mut law = Wojewoda { mu_s: 0.2, ..Default::default() };
        assert!(law.check().is_ok());
        go(&mut law, 0.1, 1.0);
        assert_eq!(go(&mut law, 0.0, 1.0), 0.0);
    }

    /// Equal levels: the elastic and perfectly plastic contact, which is Dahl's law with alpha = 0.
    #[test]
    fn equal_levels_reduce_to_dahl_with_alpha_0() {
        let mut law = Wojewoda { mu_s: 0.1, ..Default::default() };
        let mut dahl = crate::friction::Dahl { alpha: 0.0, ..Default::default() };
        for velocity in [3e-3, -2e-3, 5e-3, 0.0, -4e-3, -1e-2, 7e-3] {
            dahl.velocity = velocity;
            dahl.step(3e-3);
            dahl.output();
            assert!((go(&mut law, velocity, 3e-3) - dahl.friction_force).abs() < 1e-12, "{velocity}");
            assert_abs_diff_eq!(law.dissipated_energy, dahl.dissipated_energy, epsilon = 1e-16);
        }
    }

    #[test]
    fn release_makes_it_stuck_and_undeflected() {
        let mut law = Wojewoda::default();
        go(&mut law, 0.01, 1.0);
        law.normal_force = 0.0;
        assert_eq!(force(&mut law), 0.0);
        law.step(1e-3);
        law.normal_force = 9.81;
        assert_eq!((force(&mut law), law.sticking), (0.0, 1.0));
    }
}
