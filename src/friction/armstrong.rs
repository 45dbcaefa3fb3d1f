use crate::contact::delay_line::{DelayLine, Piece};
use crate::contact::motion::Motion;
use crate::contact::quantities::*;
use crate::model::ramp;
use crate::model::{CoSimulation, Fault, Law, Meaning, Model, Preset, real};
use crate::number::{Mask, Real};
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
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

/// Multiple of v_S up to which the kink of w through 0 and the steepest parts of the Stribeck curve are searched for.
const BAND: f64 = 1.0;

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

    fn force(&self) -> T {
        let (load, direction) = (self.normal_force, self.velocity.sign());
        let arriving = || self.sliding_level(load, self.followed_at_rest()) * self.bristle_deflection.sign();
        let slipping = || {
            let w = self.lags().choose(|| self.lagged_velocity, || self.velocity);
            self.sliding_level(load, w) * direction + self.viscous_coefficient * self.velocity
        };
        let stuck = || self.sigma_0 * self.held_deflection(load);
        let moving = || self.is_slipping().choose(slipping, stuck);
        load.vanishes().choose(|| T::zero(), || self.arrives(direction).choose(arriving, moving))
    }
}

impl<T: Real> Law for Armstrong<T> {
    type Interface = CoSimulation;

    fn output(&mut self) {
        self.friction_force = self.force();
        self.dissipated_power = self.friction_force * self.velocity;
        let stuck = !self.is_slipping() | self.arrives(self.velocity.sign());
        self.sticking = T::truth(stuck & self.normal_force.is_positive());
    }
}

impl Armstrong {
    /// Advances over inputs that move linearly.
    fn advance(&mut self, motion: Motion) {
        for part in motion.parts() {
            if part.is_unloaded() {
                self.release();
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

    fn release(&mut self) {
        self.slipping = 0.0;
        self.bristle_deflection = 0.0;
        self.dwell_time = 0.0;
        self.stribeck_coefficient = 0.0;
        self.lagged_velocity = 0.0;
        self.delay_line.clear();
    }

    /// Advances over a motion in one direction.
    fn follow(&mut self, part: Motion) {
        if self.arrives(part.direction()) {
            self.stop(part.load);
        }
        if self.is_slipping() {
            self.slip(part);
            return;
        }
        self.limit_deflection(part.load);
        let Some(breakaway) = self.breakaway(&part) else {
            self.stick(part);
            return;
        };
        self.stick(part.part(0.0, breakaway));
        self.break_away(part.direction(), part.load_at(breakaway));
        self.slip(part.part(breakaway, part.duration));
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

    /// (sigma_0 |z| - f_C - F_S) (t_d + gamma) as a polynomial in time.
    fn breakaway_cubic(&self, part: &Motion) -> [f64; 4] {
        let stiffness = part.direction() * self.sigma_0;
        let [z_0, z_1, z_2] = [self.bristle_deflection, part.velocity, 0.5 * part.acceleration].map(|z| stiffness * z);
        let (n_0, n_1) = (part.load, part.load_rate);
        let d_0 = self.dwell_time + self.gamma;
        let kept = self.kept_excess();
        let mu_0 = (self.mu_k + kept) * d_0 + (self.final_excess() - kept) * self.dwell_time;
        let mu_1 = self.mu_s;
        [z_0 * d_0 - n_0 * mu_0, z_0 + z_1 * d_0 - n_0 * mu_1 - n_1 * mu_0, z_1 + z_2 * d_0 - n_1 * mu_1, z_2]
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

    fn slip(&mut self, part: Motion) {
        let present = Piece::of(&part);
        self.dissipated_energy += self.slip_work(&part, present);
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

    fn step(&mut self, dt: f64) {
        self.advance(Motion::held(self.velocity, self.normal_force, dt));
        self.settle();
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        let begin = ramp::Inputs::of(self);
        self.advance(Motion {
            acceleration: slope.velocity,
            load_rate: slope.normal_force,
            ..Motion::held(self.velocity, self.normal_force, dt)
        });
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
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    const F_C: f64 = 0.981;
    const F_SINF: f64 = 0.4905;

    fn force(law: &mut Armstrong) -> f64 {
        law.output();
        law.friction_force
    }

    fn go(law: &mut Armstrong, velocity: f64, time: f64) -> f64 {
        law.velocity = velocity;
        law.step(time);
        force(law)
    }

    #[test]
    fn a_stuck_contact_is_a_spring() {
        let mut law = Armstrong::default();
        assert_abs_diff_eq!(go(&mut law, 1e-6, 2.0), 0.2, epsilon = 1e-15);
        assert_abs_diff_eq!(go(&mut law, -3e-6, 1.0), -0.1, epsilon = 1e-15);
        assert_abs_diff_eq!(law.dissipated_energy, 0.1 * 0.1 / 2e5, epsilon = 1e-21);
        assert_eq!((law.sticking, law.dwell_time), (1.0, 3.0));
    }

    /// Hyperbolic rise: a half at gamma, a third at gamma / 2, three quarters at 3 gamma. A stiff contact breaks away
    /// at once, and the force stays there for the lag.
    #[test]
    fn breakaway_rises_with_the_dwell_time() {
        for (dwell, share) in [(2.0, 0.5), (1.0, 1.0 / 3.0), (6.0, 0.75)] {
            let mut law = Armstrong { sigma_0: 1e12, ..Default::default() };
            go(&mut law, 0.0, dwell);
            let found = go(&mut law, -0.01, 0.0049);
            assert!((found + F_C + share * F_SINF).abs() < 1e-9, "{dwell}: {found}");
        }
    }

    /// The instant of breakaway by fixed-point iteration of sigma_0 v t = f_C + F_Sinf (1 + t) / (1 + t + gamma).
    #[test]
    fn breakaway_is_located_within_the_step() {
        let mut t = 0.0;
        for _ in 0..100 {
            t = (F_C + F_SINF * (1.0 + t) / (3.0 + t)) / (1e5 * 1e-5);
        }
        let (level, w) = (1e5 * 1e-5 * t, 1e-5 / 0.001);
        for pieces in [1, 2, 19, 4000] {
            let mut law = Armstrong::default();
            go(&mut law, 0.0, 1.0);
            for _ in 0..pieces {
                go(&mut law, 1e-5, 2.0 / f64::from(pieces));
            }
            let sliding = F_C + (level - F_C) / (1.0 + w * w);
            assert!((force(&mut law) - sliding).abs() < 1e-14, "{pieces}");
            let energy = 0.5 * level * 1e-5 * t + level * 1e-5 * 0.005 + sliding * 1e-5 * (2.0 - t - 0.005);
            assert!((law.dissipated_energy / energy - 1.0).abs() < 1e-12, "{pieces}");
        }
    }

    /// While the velocity of slip one lag earlier is 0, the force stays at the breakaway level; then it falls.
    #[test]
    fn force_stays_for_the_lag_after_breakaway() {
        let mut law = Armstrong { sigma_0: 1e9, gamma: 0.0, ..Default::default() };
        for k in 1..=60 {
            let found = go(&mut law, 0.002, 1e-4);
            let expected = if k <= 50 { F_C + F_SINF } else { F_C + F_SINF / 5.0 };
            assert!((found - expected).abs() < 1e-12, "after {k} steps of 0.1 ms: {found}");
        }
    }

    /// Without lag and with gamma = 0 the slip branch is the Lorentzian curve.
    #[test]
    fn no_lag_and_instant_rise_leave_the_curve_of_hess_and_soom() {
        let values = [(1e-5, 1.47145095), (2e-4, 1.45263462), (1e-3, 1.22625), (2e-3, 1.0791), (1e-2, 0.985856436)];
        let mut law = Armstrong { time_lag: 0.0, gamma: 0.0, ..Default::default() };
        for (velocity, expected) in values {
            for sign in [1.0, -1.0] {
                let found = go(&mut law, sign * velocity, 10.0);
                assert!((sign * found / expected - 1.0).abs() < 1e-8, "{velocity}: {found}");
            }
        }
    }

    /// Stopping from 2 mm/s: the level at the stop belongs to the velocity one lag earlier, and the next rise begins
    /// there.
    #[test]
    fn the_stop_keeps_the_force_and_the_magnitude() {
        let mut law = Armstrong { gamma: 1.0, stribeck_coefficient: 0.05, ..Default::default() };
        go(&mut law, 0.002, 1.0);
        go(&mut law, 0.0, 1e-9);
        assert_abs_diff_eq!(force(&mut law) - F_C, F_SINF / 5.0, epsilon = 1e-12);
        assert_abs_diff_eq!(law.stribeck_coefficient, 0.01, epsilon = 1e-15);
        assert_eq!((law.sticking, law.slipping), (1.0, 0.0));
        // A second later half of the missing part has returned.
        go(&mut law, 0.0, 1.0);
        law.sigma_0 = 1e12;
        law.bristle_deflection = 0.0;
        assert_abs_diff_eq!(go(&mut law, 1e-3, 1e-3) - F_C, 0.6 * F_SINF, epsilon = 1e-8);
    }

    /// After a reversal the contact unloads elastically and breaks away after 2 f / sigma_0 on the other side.
    #[test]
    fn a_reversal_passes_through_the_spring() {
        let mut law = Armstrong { time_lag: 0.0, gamma: 0.0, ..Default::default() };
        go(&mut law, 1e-3, 1.0);
        let level = F_C + F_SINF;
        for k in 1..29 {
            let found = go(&mut law, -1e-3, 1e-3);
            assert!((found - (level - 0.1 * f64::from(k))).abs() < 1e-12, "{k}: {found}");
        }
        assert_abs_diff_eq!(go(&mut law, -1e-3, 5e-3), -1.22625, epsilon = 1e-12);
        assert_eq!(law.sticking, 0.0);
    }

    /// Sudden fall of the load: the force falls at once and stays low when the load is back.
    #[test]
    fn a_falling_load_cuts_the_force() {
        let mut law = Armstrong { gamma: 0.0, ..Default::default() };
        go(&mut law, 1e-5, 1.0);
        law.normal_force = 1.0;
        law.velocity = 0.0;
        assert_abs_diff_eq!(force(&mut law), 0.15, epsilon = 1e-15);
        law.step(1e-3);
        law.normal_force = 9.81;
        assert_abs_diff_eq!(force(&mut law), 0.15, epsilon = 1e-12);
    }

    /// Ramps of velocity and load through zero velocity against 100 000 short ramps, energy against the midpoint rule.
    #[test]
    fn ramps_do_not_depend_on_their_division_and_energy_is_the_integral_of_power() {
        for time_lag in [0.0, 0.003] {
            let mut law = Armstrong { time_lag, gamma: 0.01, viscous_coefficient: 2.0, ..Default::default() };
            go(&mut law, -2e-3, 0.1);
            let slope = Armstrong { velocity: 0.3, normal_force: -150.0, ..law };
            let (mut dense, n) = (law, 50_000);
            law.step_ramp(&slope, 0.04);
            let mut energy = dense.dissipated_energy;
            for _ in 0..n {
                dense.step_ramp(&slope, 0.02 / f64::from(n));
                energy += { force(&mut dense) * dense.velocity } * 0.04 / f64::from(n);
                dense.step_ramp(&slope, 0.02 / f64::from(n));
            }
            assert!((law.dissipated_energy / dense.dissipated_energy - 1.0).abs() < 1e-8, "{time_lag}");
            assert!((law.dissipated_energy / energy - 1.0).abs() < 1e-4, "{} {energy}", law.dissipated_energy);
            assert!((force(&mut law) - force(&mut dense)).abs() < 1e-8, "{time_lag}");
        }
    }

    fn noise(k: i32) -> f64 {
        (f64::from(k) * 12.9898).sin() * 3e-3 * (f64::from(k) * 0.7).cos()
    }

    /// At constant load the contact returns no more energy than was put in; if the load rises during slip, no more than
    /// stated.
    #[test]
    fn passive_at_constant_load_and_within_the_stated_bound_else() {
        for time_lag in [0.0, 1e-3, 0.02] {
            let mut law = Armstrong { time_lag, gamma: 0.05, ..Default::default() };
            for k in 0..20_000 {
                go(&mut law, noise(k), 2e-3);
                assert!(law.dissipated_energy >= 0.0, "{time_lag} {k}: {}", law.dissipated_energy);
            }
        }
        let mut law = Armstrong { gamma: 0.0, time_lag: 0.0, normal_force: 1.0, ..Default::default() };
        go(&mut law, 1e-6, 1.500_001);
        law.normal_force = 1000.0;
        go(&mut law, 1e-9, 1e-6);
        go(&mut law, -1e-3, 1.5);
        let bound = 0.15f64.powi(2) * (1000f64.powi(2) - 1.0) / 2e5;
        assert!(law.dissipated_energy < -0.9 * bound && law.dissipated_energy > -bound, "{}", law.dissipated_energy);
    }

    #[test]
    fn equal_levels_leave_spring_and_coulomb_level() {
        let mut law = Armstrong { mu_s: 0.1, ..Default::default() };
        for velocity in [1e-4, -0.2, 3.0] {
            let found = go(&mut law, velocity, 1.0);
            assert_abs_diff_eq!(found, F_C * velocity.signum(), epsilon = 1e-15);
        }
    }

    #[test]
    fn release_sets_back_to_the_start() {
        let mut law = Armstrong::default();
        go(&mut law, 0.01, 1.0);
        law.normal_force = 0.0;
        law.step(1e-3);
        let fresh = Armstrong { velocity: 0.01, normal_force: 0.0, ..Default::default() };
        law.dissipated_energy = 0.0;
        law.output();
        let (mut a, mut b) = (law, fresh);
        b.output();
        (a.normal_force, b.normal_force) = (9.81, 9.81);
        assert_eq!(go(&mut a, 3e-3, 0.3), go(&mut b, 3e-3, 0.3));
        assert_eq!(crate::model::row_of(&a), crate::model::row_of(&b));
    }
}
