use crate::contact::delay_line::{DelayLine, Piece};
use crate::contact::motion::Motion;
use crate::contact::quantities::*;
use crate::contact::time_stepping::{MOVED, NO_EVENT, PASSED, Phase, PhaseColumn, REACHED};
use crate::contact::unloading;
use crate::model::ramp;
use crate::model::{Derivatives, Fault, Law, Meaning, Model, Past, Preset, WithHistory, real};
use crate::number::{Mask, Real, choose};
use crate::numerics::quadrature::integral_past_peak;
use crate::numerics::root::first_rise;

crate::model! {
    /// Armstrong's seven-parameter friction: pre-sliding displacement like a spring while stuck, and while slipping the
    /// Stribeck effect with frictional lag, on a static friction that rises with the time at rest.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = sigma_0 z,   dz/dt = v                                                  stuck
    /// f_f = [f_C + F_S / (1 + (w / v_S)^2)] sgn(v) + f_v v,   w(t) = v(t - tau_L)   slipping
    /// F_S(gamma, t_d) = F_Sa + (F_Sinf - F_Sa) t_d / (t_d + gamma)                  rising static friction
    /// f_C = mu_k f_n,   F_Sinf = (mu_s - mu_k) f_n,   F_Sa = mu_a f_n
    /// ```
    ///
    /// The source leaves open when the law changes between its two states and what is kept. Here:
    ///
    /// ```text
    /// stuck -> slipping    sigma_0 |z| reaches f_C + F_S(gamma, t_d) in the direction of v; F_S is kept as mu_a f_n
    /// slipping -> stuck    v reaches or passes 0; mu_a := mu_a / (1 + (w / v_S)^2), t_d := 0, sigma_0 z := f_f
    /// w                    the velocity of slip: it is 0 while the contact is stuck
    /// start:               stuck, z = 0, t_d = 0, mu_a = 0
    /// ```
    ///
    /// | symbol  | variable               | unit  | meaning                                                 |
    /// |---------|------------------------|-------|---------------------------------------------------------|
    /// | v       | `velocity`             | m/s   | velocity of body 1 relative to body 2                   |
    /// | f_n     | `normal_force`         | N     | force pressing the surfaces together                    |
    /// | mu_k    | `mu_k`                 | 1     | kinetic coefficient of friction                         |
    /// | mu_s    | `mu_s`                 | 1     | static coefficient of friction after a long rest        |
    /// | sigma_0 | `sigma_0`              | N/m   | stiffness of the stuck contact                          |
    /// | v_S     | `stribeck_velocity`    | m/s   | speed at which the excess $F_S$ has fallen to 1/2       |
    /// | f_v     | `viscous_coefficient`  | N.s/m | viscous coefficient                                     |
    /// | tau_L   | `time_lag`             | s     | time by which the Stribeck effect lags behind           |
    /// | gamma   | `gamma`                | s     | dwell time after which half of the rise has occurred    |
    /// |         | `slipping`             |       | whether the contact has broken away                     |
    /// | z       | `bristle_deflection`   | m     | displacement since sticking; slipping: $f_f / sigma_0$  |
    /// | t_d     | `dwell_time`           | s     | time since sticking; 0 while slipping                   |
    /// | mu_a    | `stribeck_coefficient` | 1     | Stribeck magnitude of the last change, per normal force |
    /// | w       | `lagged_velocity`      | m/s   | velocity of slip one time lag ago                       |
    /// |         | `history[i].duration`  | s     | pieces of the history of $w$, the latest first          |
    /// |         | `history[i].begin`     | m/s   | velocity of slip at the beginning of a piece            |
    /// |         | `history[i].end`       | m/s   | velocity of slip at the end of a piece                  |
    /// |         | `phase`                |       | motion as found by the last event                       |
    /// | f_f     | `friction_force`       | N     | friction force                                          |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` while slipping and of the displacement while stuck; body 1 feels
    /// `-friction_force`. Dissipated power is `friction_force * velocity`; it is negative while the stuck contact
    /// springs back.
    ///
    /// # Step
    /// Exact for inputs that are held and for inputs that move linearly. Breakaway is the first zero of a cubic,
    /// located to the last bit within the step; the return to sticking is the zero of the velocity, or the beginning of
    /// the step if a held velocity jumps across zero. So the instants of both do not depend on how an interval is
    /// divided, up to rounding (relative 1e-10 after a million steps). The history of the velocity is kept as in
    /// `FrictionalLag`: 64 pieces, exact for up to 64 different velocities within $tau_L$; with steps shorter than
    /// about $tau_L / 63$ they are thinned: the error of $w$ is then at most $(tau_L / 31)^2 / 8$ times the second
    /// derivative of $v$, plus the change of $v$ over one step. The dissipated energy is a closed form where the inputs
    /// and $w$ are constant, and otherwise a quadrature with a relative error below 1e-10.
    ///
    /// A solver that keeps the past, as the workbench does, integrates the law by its rates: $w$ comes from the motion
    /// that it has found, no step in which the contact slips is longer than $tau_L$, and the law changes at events.
    /// While the contact slips, only the sign of $z$ has a meaning then; a displacement that a falling load cuts follows
    /// within 0.1 ms, its force at once. Model Exchange is not offered, because no importer gives the past.
    ///
    /// A master that integrates a mass m with the force it reads couples it explicitly to the stiffness k of the
    /// contact at rest. If the friction steps first, a held body stays still for communication steps below 2 sqrt(m /
    /// k), which is 6.3 ms for the defaults and 1 kg; above, it chatters within the bounds of the force. If all models
    /// step at once and exchange afterwards, it chatters at every step, since nothing damps the stiffness: take the
    /// friction first.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`.
    ///
    /// # Limits
    /// No damping while stuck: a mass on the contact oscillates. With a positive `time_lag` the force stays at the
    /// breakaway level for that time, regardless of the velocity. `time_lag` = 0 and `gamma` = 0 leave a spring and the
    /// curve of Hess and Soom; `mu_s` = `mu_k` leaves a spring, the Coulomb level and viscous friction. A stuck contact
    /// at $v = 0$ holds. If the load falls, the displacement is cut to what the level can carry: at the beginning of a
    /// step, at the end of one with slopes, and in the force at once.
    ///
    /// Passive at constant load: the energy stored while stuck, $(sigma_0 z)^2 / (2 sigma_0)$, was put in before. A
    /// load that rises during slip from $f_n1$ to $f_n2$ charges the contact at the next stop, so that it may return up
    /// to $mu_s^2 (f_n2^2 - f_n1^2) / (2 sigma_0)$ more than was put in. `normal_force` = 0 releases the contact: force
    /// 0, and the next step resets it to its initial state.
    ///
    /// # Source
    /// Armstrong-Helouvry, Dupont and Canudas de Wit (1994), doi:10.1016/0005-1098(94)90209-7, in the form of Olsson et
    /// al. (1998), European Journal of Control 4, 176-195, who remark that an eighth parameter is probably needed; the
    /// choices above are ours. The papers give $F_Sinf$, $F_Sa$ and $f_C$ in newtons and friction as a force on the
    /// body; here they are coefficients, so that they follow the load, and the sign is that of the resistance. A public
    /// transcription has the brackets of the rising static friction as $F_Sa + [F_Sinf - F_Sa t_d / (t_d + gamma)]$,
    /// which is wrong: at $t_d = 0$ it must be $F_Sa$. The pages of F. Novais, "A critical analysis on friction force
    /// models in dynamical systems", MSc thesis, University of Minho (2024), on this law and its Table 6.4 were not
    /// available: $v_S$ is that of its Table 7.1, $tau_L$ and $gamma$ are chosen.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Armstrong;
    /// use stribeck::model::{Law, Model};
    /// let mut law = Armstrong { sigma_0: 1e9, ..Default::default() };
    /// law.step(2.0); // at rest for gamma: half of the rise from 0.981 N to 1.4715 N
    /// law.velocity = 0.1;
    /// law.step(0.004); // breaks away after 12 ns, and for 5 ms the force stays there
    /// law.output();
    /// assert!((law.friction_force - (0.981 + 1.4715) / 2.0).abs() < 1e-8);
    /// ```
    Armstrong: "Stick, slip, lag and rising static friction with seven parameters (Armstrong-Helouvry)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        sigma_0: tunable = SIGMA_0,
        stribeck_velocity: tunable = STRIBECK_VELOCITY.help("Speed at which half of the excess of static over kinetic friction is left."),
        viscous_coefficient: tunable = VISCOUS_COEFFICIENT,
        time_lag: fixed = TIME_LAG,
        /// Dwell time after which half of the rise of the static friction has occurred (default chosen).
        gamma: tunable = real("s", 2.0).at_least(0.0).means(Meaning::Own),
        slipping: state = SLIPPING,
        bristle_deflection: state = BRISTLE_DEFLECTION,
        /// Time since the contact got stuck; 0 while it slips.
        dwell_time: state = real("s", 0.0).at_least(0.0),
        /// Stribeck magnitude per normal force: that at the end of the last slip while stuck, that of the breakaway
        /// while slipping.
        stribeck_coefficient: state = real("1", 0.0).at_least(0.0),
        lagged_velocity: state = LAGGED_VELOCITY,
        /// History of the velocity of slip.
        delay_line: (DelayLine),
        /// Motion of the contact as found by the last event of Model Exchange.
        phase: state = Phase::Free.start(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

/// Multiple of v_S up to which the kink of w through 0 and the steepest parts of the Stribeck curve are searched for.
const BAND: f64 = 1.0;

/// Time constant of a deflection that a falling load pushes back, in s (chosen).
const PUSHED: f64 = 1e-4;

impl<T: Real> Armstrong<T> {
    /// F_Sinf per normal force.
    fn final_excess(&self) -> T {
        self.mu_s - self.mu_k
    }

    /// F_Sa, or the F_S of the breakaway, per normal force. Not above what mu_s allows, in case mu_s has been lowered
    /// in the meantime.
    fn kept_excess(&self) -> T {
        let limit = self.final_excess();
        self.stribeck_coefficient.below(limit).choose(|| self.stribeck_coefficient, || limit)
    }

    /// F_S(gamma, t_d) per normal force.
    fn risen_excess(&self, dwell_time: T) -> T {
        let rising = || {
            let kept = self.kept_excess();
            kept + (self.final_excess() - kept) * dwell_time / (dwell_time + self.gamma)
        };
        self.gamma.is(0.0).choose(|| self.final_excess(), rising)
    }

    /// f_C + F_S(gamma, t_d): the force that a stuck contact can hold.
    fn holding_level(&self, load: T, dwell_time: T) -> T {
        load * (self.mu_k + self.risen_excess(dwell_time))
    }

    /// F_S / (1 + (w / v_S)^2) per normal force.
    fn sliding_excess(&self, w: T) -> T {
        let u = w / self.stribeck_velocity;
        self.kept_excess() / (T::from(1.0) + u * u)
    }

    /// f_C + F_S / (1 + (w / v_S)^2).
    fn sliding_level(&self, load: T, w: T) -> T {
        load * (self.mu_k + self.sliding_excess(w))
    }

    /// Deflection, limited to what the level can carry.
    fn held_deflection(&self, load: T) -> T {
        self.bristle_deflection.pushed_back(self.holding_level(load, self.dwell_time) / self.sigma_0)
    }

    fn lags(&self) -> T::Mask {
        self.time_lag.is_positive()
    }

    fn is_slipping(&self) -> T::Mask {
        !self.slipping.vanishes()
    }

    /// Whether the contact has slipped until now and a velocity of this sign brings it to rest.
    fn arrives(&self, direction: T) -> T::Mask {
        let is_opposite = self.bristle_deflection.sign().equals(-direction);
        self.is_slipping() & (direction.vanishes() | is_opposite)
    }

    /// w at an instant of rest.
    fn followed_at_rest(&self) -> T {
        self.lags().choose(|| self.lagged_velocity, || T::zero())
    }

    /// Motion of the contact as found by the last event.
    fn phase(&self) -> PhaseColumn<T> {
        PhaseColumn(self.phase)
    }

    /// Whether the contact carries a load; an event that finds none releases it.
    fn is_loaded(&self) -> T::Mask {
        !self.normal_force.at_most(T::from(unloading::RELEASED))
    }

    /// Rate of the deflection of a stuck contact.
    fn deflection_rate(&self) -> T {
        let excess = self.bristle_deflection - self.held_deflection(self.normal_force);
        let is_outward = (self.velocity * excess).is_positive();
        self.velocity - choose!(is_outward, T::zero(), excess / T::from(PUSHED))
    }

    fn force(&self) -> T {
        let (load, direction) = (self.normal_force, self.velocity.sign());
        let arriving = || self.sliding_level(load, self.followed_at_rest()) * self.bristle_deflection.sign();
        let slips_on = self.phase().slides();
        let slipping = || {
            let w = self.lags().choose(|| self.lagged_velocity, || self.velocity);
            // Between events a contact slips in one direction, also in trial steps of a solver beyond the stop.
            let direction = choose!(slips_on, self.phase().direction(), direction);
            self.sliding_level(load, w) * direction + self.viscous_coefficient * self.velocity
        };
        let stuck = || self.sigma_0 * self.held_deflection(load);
        let moving = || self.is_slipping().choose(slipping, stuck);
        let is_arriving = !slips_on & self.arrives(direction);
        load.vanishes().choose(|| T::zero(), || is_arriving.choose(arriving, moving))
    }
}

impl<T: Real> Law for Armstrong<T> {
    type Interface = WithHistory;

    fn output(&mut self) {
        self.friction_force = self.force();
        self.dissipated_power = self.friction_force * self.velocity;
        let stuck = !self.is_slipping() | self.arrives(self.velocity.sign());
        self.sticking = T::truth(stuck & self.normal_force.is_positive());
    }
}

impl<T: Real> Derivatives for Armstrong<T> {
    fn derivatives(&self, rate: &mut Self) {
        let is_stuck = !self.is_slipping() & self.is_loaded();
        rate.bristle_deflection = is_stuck.choose(|| self.deflection_rate(), || T::zero());
        rate.dwell_time = T::truth(is_stuck);
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

impl Armstrong {
    /// |z| in parts of the largest that the level can carry.
    fn stretch(&self) -> f64 {
        let level = self.holding_level(self.normal_force, self.dwell_time);
        if level > 0.0 { self.sigma_0 * self.bristle_deflection.abs() / level } else { f64::INFINITY }
    }

    /// Speed in the direction of the deflection, if there is one, in parts of the least one that counts.
    fn outward_speed(&self) -> f64 {
        let side = self.bristle_deflection.sign();
        (if side == 0.0 { self.velocity.abs() } else { self.velocity * side }) / MOVED
    }

    /// Whether a stuck contact breaks away at an event. The limits lie between those of the indicator.
    fn breaks(&self) -> bool {
        self.stretch() >= 1.0 + 0.5 * REACHED && self.outward_speed() > 0.5 * PASSED
    }

    /// Direction in which the contact slips, if an event or, without one, a step has left it slipping.
    fn slip_direction(&self) -> Option<f64> {
        let direction = Phase::of(self.phase).direction().unwrap_or(self.bristle_deflection.sign());
        self.is_slipping().then_some(direction)
    }

    /// Advances over held inputs.
    fn step_held(&mut self, dt: f64, counts: bool) {
        self.phase = Phase::Free.number();
        self.advance(Motion::held(self.velocity, self.normal_force, dt), counts);
        self.settle();
    }

    /// Advances over inputs that move linearly: the states, and the energy of slip if it `counts`.
    fn advance(&mut self, motion: Motion, counts: bool) {
        for part in motion.parts() {
            if part.is_unloaded() {
                self.release();
            } else {
                self.follow(part, counts);
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

    fn release(&mut self) {
        self.slipping = 0.0;
        self.bristle_deflection = 0.0;
        self.dwell_time = 0.0;
        self.stribeck_coefficient = 0.0;
        self.lagged_velocity = 0.0;
        self.delay_line.clear();
    }

    /// Advances over a motion in one direction.
    fn follow(&mut self, part: Motion, counts: bool) {
        if self.arrives(part.direction()) {
            self.stop(part.load);
        }
        if self.is_slipping() {
            self.slip(part, counts);
            return;
        }
        self.limit_deflection(part.load);
        let Some(breakaway) = self.breakaway(&part) else {
            self.stick(part);
            return;
        };
        self.stick(part.part(0.0, breakaway));
        self.break_away(part.direction(), part.load_at(breakaway));
        self.slip(part.part(breakaway, part.duration), counts);
    }

    /// Slipping -> stuck.
    fn stop(&mut self, load: f64) {
        let w = self.followed_at_rest();
        self.bristle_deflection = self.bristle_deflection.sign() * self.sliding_level(load, w) / self.sigma_0;
        self.stribeck_coefficient = self.sliding_excess(w);
        self.dwell_time = 0.0;
        self.slipping = 0.0;
    }

    /// Stuck -> slipping.
    fn break_away(&mut self, direction: f64, load: f64) {
        self.stribeck_coefficient = self.risen_excess(self.dwell_time);
        self.dwell_time = 0.0;
        self.slipping = 1.0;
        self.bristle_deflection = direction * self.sliding_level(load, 0.0) / self.sigma_0;
    }

    /// The first instant of a motion at which sigma_0 z reaches the level in the direction of motion.
    fn breakaway(&self, part: &Motion) -> Option<f64> {
        let direction = part.direction();
        if direction == 0.0 {
            return None;
        }
        let excess = |t: f64| {
            let force = direction * self.sigma_0 * (self.bristle_deflection + part.path(t));
            force - self.holding_level(part.load_at(t), self.dwell_time + t)
        };
        first_rise(excess, self.breakaway_cubic(part), part.duration)
    }

    /// (sigma_0 |z| - f_C - F_S) (t_d + gamma) as a polynomial in time, without its value at the start.
    fn breakaway_cubic(&self, part: &Motion) -> [f64; 3] {
        let stiffness = part.direction() * self.sigma_0;
        let [z_0, z_1, z_2] = [self.bristle_deflection, part.velocity, 0.5 * part.acceleration].map(|z| stiffness * z);
        let (n_0, n_1) = (part.load, part.load_rate);
        let d_0 = self.dwell_time + self.gamma;
        let kept = self.kept_excess();
        let mu_0 = (self.mu_k + kept) * d_0 + (self.final_excess() - kept) * self.dwell_time;
        let mu_1 = self.mu_s;
        [z_0 + z_1 * d_0 - n_0 * mu_1 - n_1 * mu_0, z_1 + z_2 * d_0 - n_1 * mu_1, z_2]
    }

    /// Limits the displacement to what the level can carry.
    fn limit_deflection(&mut self, load: f64) {
        self.bristle_deflection = self.held_deflection(load);
    }

    fn stick(&mut self, part: Motion) {
        let (before, change) = (self.bristle_deflection, part.path(part.duration));
        self.bristle_deflection += change;
        self.dissipated_energy += self.sigma_0 * change * (before + 0.5 * change);
        self.dwell_time += part.duration;
        self.remember(Piece::held(part.duration, 0.0));
    }

    fn slip(&mut self, part: Motion, counts: bool) {
        let present = Piece::of(&part);
        if counts {
            self.dissipated_energy += self.slip_work(&part, present);
        }
        self.remember(present);
        let level = self.sliding_level(part.load_at(part.duration), self.lagged_velocity);
        self.bristle_deflection = part.direction() * level / self.sigma_0;
    }

    /// Energy dissipated in slip.
    fn slip_work(&self, part: &Motion, present: Piece) -> f64 {
        if !self.lags() {
            return self.work(part, 0.0, present);
        }
        let mut sum = 0.0;
        self.delay_line.delayed(present, self.time_lag, |from, piece| sum += self.work(part, from, piece));
        sum
    }

    /// Energy dissipated in slip from time `from` of a motion, while w is that of `piece`.
    fn work(&self, part: &Motion, from: f64, piece: Piece) -> f64 {
        let power = |t: f64| {
            let speed = part.velocity_at(from + t).abs();
            let level = self.sliding_level(part.load_at(from + t), piece.at(t));
            (level + self.viscous_coefficient * speed) * speed
        };
        if part.is_steady() && piece.is_constant() {
            return power(0.0) * piece.duration;
        }
        integral_past_peak(&power, &|t| piece.at(t), BAND * self.stribeck_velocity, 0.0, piece.duration)
    }

    /// Adds a piece of the velocity of slip to the history. Before the known history the contact was stuck.
    fn remember(&mut self, piece: Piece) {
        if !self.lags() {
            self.lagged_velocity = piece.end;
            return;
        }
        if self.delay_line.is_empty() {
            self.delay_line.push(Piece::held(self.time_lag, 0.0), self.time_lag);
        }
        // Breakaway may be at the very beginning or end of a step.
        if piece.duration > 0.0 {
            self.delay_line.push(piece, self.time_lag);
        }
        self.lagged_velocity = self.delay_line.velocity(self.time_lag);
    }
}

impl Model for Armstrong {
    const PRESETS: &'static [Preset] = &[
        Preset {
            name: "long_rest",
            source: "Example of a contact that has rested so long that its static friction has fully risen",
            values: &[("stribeck_coefficient", 0.05)],
        },
        Preset {
            name: "lubricated_servo",
            source: "Example of a lubricated servo axis, within the ranges of Armstrong-Helouvry et al. (1994)",
            values: &[
                ("mu_k", 0.05),
                ("mu_s", 0.08),
                ("sigma_0", 2e5),
                ("stribeck_velocity", 0.002),
                ("viscous_coefficient", 2.0),
                ("time_lag", 0.01),
                ("gamma", 5.0),
            ],
        },
    ];

    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    fn check_model_exchange(&self) -> Result<(), Fault> {
        self.delay_line.check_model_exchange()
    }

    const EVENT_INDICATORS: usize = 3;

    fn is_linear(&self) -> bool {
        self.phase().is(Phase::Held)
    }

    fn event_indicators(&self, indicators: &mut [f64]) {
        let reserve = 1.0 + REACHED - self.stretch();
        let [change, reserve] = match Phase::of(self.phase).direction() {
            // A swing that only just reaches the level shows in the reserve, which is smooth where it turns.
            None => [reserve.max(PASSED - self.outward_speed()), reserve.max(-1.0)],
            Some(direction) => [direction * self.velocity / MOVED + PASSED, NO_EVENT],
        };
        indicators.copy_from_slice(&[change, reserve, unloading::load(self.normal_force)]);
    }

    fn at_event(&mut self) {
        match self.slip_direction() {
            _ if unloading::is_unloaded(self.normal_force) => self.release(),
            Some(direction) if direction * self.velocity <= 0.0 => self.stop(self.normal_force),
            None if self.breaks() => self.break_away(self.velocity.sign(), self.normal_force),
            _ => {}
        }
        self.phase = self.slip_direction().map_or(Phase::Held, Phase::sliding).number();
    }

    fn past(&self) -> Option<Past> {
        let rests = !self.is_slipping();
        let now = if rests { 0.0 } else { self.velocity };
        Some(Past { lag: self.time_lag, now, before: 0.0, is_kept: true, rests })
    }

    fn step(&mut self, dt: f64) {
        self.step_held(dt, true);
    }

    fn step_without_energy(&mut self, _memory: &mut [f64], dt: f64) {
        self.step_held(dt, false);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        self.phase = Phase::Free.number();
        let begin = ramp::Inputs::of(self);
        let motion = Motion {
            acceleration: slope.velocity,
            load_rate: slope.normal_force,
            ..Motion::held(self.velocity, self.normal_force, dt)
        };
        self.advance(motion, true);
        ramp::set_inputs(self, &begin, slope, dt);
        self.settle();
    }

    fn rate(&self, rate: &mut Self) {
        if !self.is_slipping() {
            rate.bristle_deflection = self.velocity;
            rate.dwell_time = 1.0;
        }
        if self.lags() {
            rate.lagged_velocity = self.delay_line.slope(self.time_lag);
        }
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

#[cfg(test)]
mod tests;
