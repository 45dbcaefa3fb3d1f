use crate::contact::delay_line::{DelayLine, Piece};
use crate::contact::motion::Motion;
use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, EVENTS_ON_CURVE, OnCurve, Phase, PhaseColumn};
use crate::contact::unloading;
use crate::laws::stribeck;
use crate::model::ramp;
use crate::model::{Derivatives, Fault, Law, Meaning, Model, Past, Preset, WithHistory, boolean};
use crate::number::elementary::{exp_m1, ln_1p, pow};
use crate::number::{Mask, Real, choose};
use crate::numerics::quadrature::integral_past_peak;
use crate::numerics::relaxation;

crate::choices! {
    /// How the friction force lags behind the velocity.
    pub enum FrictionalLagVariant {
        /// The force follows the velocity one time lag earlier.
        Delay,
        /// The force follows the velocity through a first-order filter.
        FirstOrder,
    }
}

crate::model! {
    /// Frictional lag: the Stribeck curve with the delay that a lubricating film needs to follow the velocity, so that
    /// friction is higher while a contact accelerates than while it decelerates.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = F_ss(w) sgn(v)
    /// F_ss(w) = f_C + (f_s - f_C) exp(-(|w| / v_S)^delta) + f_v |w|
    /// w(t) = v(t - tau_L)                        Delay
    /// tau_L dw/dt + w = v                        FirstOrder
    /// f_C = mu_k f_n,   f_s = mu_s f_n
    ///
    /// solvers with events, at rest:   f_f = f_e,   |f_e| <= F_ss(w)
    /// ```
    ///
    /// | symbol | variable              | unit  | meaning                                                |
    /// |--------|-----------------------|-------|--------------------------------------------------------|
    /// | v      | `velocity`            | m/s   | velocity of body 1 relative to body 2                  |
    /// | f_n    | `normal_force`        | N     | force pressing the surfaces together                   |
    /// | f_e    | `external_force`      | N     | resultant of all other tangential forces               |
    /// | mu_k   | `mu_k`                | 1     | kinetic coefficient of friction                        |
    /// | mu_s   | `mu_s`                | 1     | static coefficient of friction                         |
    /// | v_S    | `stribeck_velocity`   | m/s   | speed at which the excess over $f_C$ has fallen to 1/e |
    /// | delta  | `stribeck_exponent`   | 1     | shape of the falling level; 2 = Gaussian               |
    /// | f_v    | `viscous_coefficient` | N.s/m | viscous coefficient                                    |
    /// | tau_L  | `time_lag`            | s     | time by which the force lags behind                    |
    /// | w      | `lagged_velocity`     | m/s   | velocity of a time lag ago, or filtered                |
    /// |        | `history[i].duration` | s     | pieces of the past, the latest first: their durations  |
    /// |        | `history[i].begin`    | m/s   | velocity at the beginning of a piece                   |
    /// |        | `history[i].end`      | m/s   | velocity at the end of a piece                         |
    /// |        | `phase`               |       | motion as found by the last event                      |
    /// | f_f    | `friction_force`      | N     | friction force                                         |
    ///
    /// # Sign
    /// `friction_force` has the sign of the present `velocity`; body 1 feels `-friction_force`. Dissipated power is
    /// `friction_force * velocity`, never negative: the law is passive, whatever the lag.
    ///
    /// # Step
    /// Exact for inputs that are held and for inputs that move linearly: two half steps equal one. A held velocity is
    /// taken as a staircase, and the delayed velocity is the same staircase later. If it stands for a smooth velocity,
    /// it is late by up to one communication step (half of one on average); slopes of the inputs
    /// (fmi2SetRealInputDerivatives) remove that. A step may be longer than $tau_L$: the force at its end then follows
    /// the velocity of the same step.
    ///
    /// The past is kept in 64 pieces with a linear velocity each, a constant one however long it lasts. If the delay
    /// holds more different velocities, that is for a communication step below about $tau_L / 63$, neighbouring pieces
    /// are joined by straight lines: the past still spans $tau_L$, no joined piece is longer than $tau_L / 31$, and the
    /// error of $w$ is at most $|d2v/dt2| (tau_L / 31)^2 / 8$, and for a held velocity its change over one step in
    /// addition.
    ///
    /// A host that integrates the body itself never reaches $v = 0$ exactly: the force alternates, and the velocity of
    /// the body alternates by up to $f_s h / m$, which has to stay well below $v_S$, or the level at rest is not the
    /// static one. For a block of 1 kg on a belt the stick-slip period is 0.2 % too short at $h = 31$ us, 4 % at 125 us
    /// and 39 % at 1 ms.
    ///
    /// Before the first step, and again after the contact was released, $w$ is the velocity with which the contact
    /// begins. The dissipated energy is a closed form where $w$ and the inputs are constant, otherwise a quadrature
    /// with a relative error below 1e-10. `sticking` means that the velocity is exactly zero.
    ///
    /// A solver that keeps the past, as the workbench does, integrates the law by its rates: $w$ comes from the motion
    /// that it has found, and no step is longer than $tau_L$. At an event the contact comes to rest, and then it carries
    /// `external_force` up to $F_ss(w)$: the limit of ever shorter steps. Steps do not use `external_force`, and Model
    /// Exchange is not offered, because no importer gives the past.
    ///
    /// # Coupling
    /// `external_force` matters to solvers with events only. If body 2 has the acceleration $a_2$, it is $F_1 - m_1 a_2$;
    /// if it moves freely, $(m_2 F_1 - m_1 F_2) / (m_1 + m_2)$, with the masses of both bodies and the resultants of all
    /// other tangential forces on them.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`.
    ///
    /// # Limits
    /// No stiction: in co-simulation the force is zero at $v = 0$, so the law cannot hold a load, and a host that
    /// integrates the body itself sees the force alternate around rest. No pre-sliding displacement. When the velocity
    /// changes its sign, the level still follows the speed one time lag earlier, so the force need not pass the static
    /// level. `time_lag` = 0 is the static law; `mu_s` = `mu_k` leaves only the viscous part to lag. `normal_force` = 0
    /// releases the contact: force 0, also of the viscous part, and the next step forgets the past.
    ///
    /// # Source
    /// Hess and Soom (1990), Journal of Tribology 112, 147-152; Armstrong-Helouvry, Dupont and Canudas de Wit (1994),
    /// doi:10.1016/0005-1098(94)90209-7, where lags of 1 to 50 ms are reported. The steady curve is that of
    /// Armstrong-Helouvry (1991); the viscous part lags with it. The pages of F. Novais, "A critical analysis on
    /// friction force models in dynamical systems", MSc thesis, University of Minho (2024), on frictional lag were not
    /// available: the equations are those of the literature. The variant FirstOrder, which needs no past, is a common
    /// substitute. The default $tau_L = 5$ ms is chosen.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::FrictionalLag;
    /// use stribeck::model::{Law, Model};
    /// let mut law = FrictionalLag { velocity: 0.001, ..Default::default() };
    /// law.step(0.01);
    /// law.velocity = -0.1; // the level is still that of 1 mm/s
    /// law.step(0.004);
    /// law.output();
    /// let level = 0.981 + 0.4905 * (-1.0f64).exp();
    /// assert!((law.friction_force + level).abs() < 1e-15);
    /// ```
    FrictionalLag: "Stribeck friction that lags behind the velocity (Hess and Soom)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        stribeck_velocity: tunable = STRIBECK_VELOCITY,
        stribeck_exponent: tunable = STRIBECK_EXPONENT,
        viscous_coefficient: tunable = VISCOUS_COEFFICIENT,
        time_lag: fixed = TIME_LAG,
        /// Variant of the law.
        variant: fixed = FrictionalLagVariant::Delay.start().means(Meaning::Variant),
        /// Does the contact have a past? Without one the level follows the present velocity.
        has_past: state = boolean(false),
        lagged_velocity: state = LAGGED_VELOCITY,
        /// The past of the velocity.
        delay_line: (DelayLine),
        /// Motion of the contact as found by the last event of Model Exchange.
        phase: state = Phase::Free.start(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

/// The Stribeck peak is ignored where it is below exp(-40), which no sum of levels can resolve.
const NEGLIGIBLE: f64 = 40.0;

impl<T: Real> FrictionalLag<T> {
    /// w, if without a lag it is this velocity.
    fn followed(&self, velocity: T) -> T {
        (self.lags() & !self.has_past.vanishes()).choose(|| self.lagged_velocity, || velocity)
    }

    fn lags(&self) -> T::Mask {
        self.time_lag.is_positive()
    }

    /// Whether w comes from a filter.
    fn is_filtered(&self) -> T::Mask {
        self.lags() & !self.has_past.vanishes() & FrictionalLagVariant::FirstOrder.is(self.variant)
    }

    /// F_ss(w) at a normal force.
    fn steady(&self, w: T, load: T) -> T {
        let (coulomb, breakaway) = (self.mu_k * load, self.mu_s * load);
        let loaded = || {
            stribeck::level(w, coulomb, breakaway, self.stribeck_velocity, self.stribeck_exponent)
                + self.viscous_coefficient * w.abs()
        };
        load.vanishes().choose(|| T::zero(), loaded)
    }

    /// Motion of the contact as found by the last event.
    fn phase(&self) -> PhaseColumn<T> {
        PhaseColumn(self.phase)
    }

    /// The contact, which events let carry a force at rest.
    fn contact(&self) -> OnCurve<'_, T, Self> {
        let FrictionalLag { velocity, normal_force, external_force, .. } = *self;
        OnCurve { law: self, velocity, normal_force, external_force, phase: self.phase() }
    }

    fn force(&self) -> T {
        let sliding = || self.curve(choose!(self.phase().slides(), self.contact().extended(), self.velocity));
        let held = || self.normal_force.vanishes().choose(|| T::zero(), || self.external_force);
        self.phase().is(Phase::Held).choose(held, sliding)
    }
}

impl<T: Real> Curve<T> for FrictionalLag<T> {
    fn curve(&self, velocity: T) -> T {
        self.steady(self.followed(velocity), self.normal_force) * velocity.sign()
    }

    /// Level at rest.
    fn level(&self) -> T {
        self.steady(self.followed(T::zero()), self.normal_force)
    }

    fn band(&self) -> Option<T> {
        None
    }
}

impl<T: Real> Law for FrictionalLag<T> {
    type Interface = WithHistory;

    fn output(&mut self) {
        self.friction_force = self.force();
        self.dissipated_power = self.friction_force * self.velocity;
        let rests = self.phase().is(Phase::Held) | self.velocity.vanishes();
        self.sticking = T::truth(rests & self.normal_force.is_positive());
    }

    fn slide_steadily(&mut self) {
        self.phase = T::from(Phase::Free.number());
        self.has_past = T::truth(self.normal_force.is_positive());
        self.lagged_velocity = self.has_past * self.velocity;
        // The next step begins with a past of this velocity.
        self.delay_line.clear();
    }
}

impl<T: Real> Derivatives for FrictionalLag<T> {
    fn derivatives(&self, rate: &mut Self) {
        let filtered = || (self.velocity - self.lagged_velocity) / self.time_lag;
        rate.lagged_velocity = self.is_filtered().choose(filtered, || T::zero());
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

impl FrictionalLag {
    fn variant(&self) -> FrictionalLagVariant {
        FrictionalLagVariant::of(self.variant)
    }

    /// Begins to remember, if it has not yet.
    fn begin(&mut self) {
        if self.has_past == 0.0 {
            self.has_past = 1.0;
            self.lagged_velocity = self.velocity;
        }
    }

    /// Advances over inputs that move linearly: the states, and the energy if it `counts`.
    fn advance(&mut self, motion: Motion, counts: bool) {
        for part in motion.parts() {
            if part.is_unloaded() {
                self.release();
            } else {
                self.slide(part, counts);
            }
        }
    }

    fn release(&mut self) {
        self.has_past = 0.0;
        self.lagged_velocity = 0.0;
        self.delay_line.clear();
    }

    fn slide(&mut self, part: Motion, counts: bool) {
        if self.has_past == 0.0 {
            self.has_past = 1.0;
            self.lagged_velocity = part.velocity;
        }
        match self.variant() {
            _ if !self.lags() => self.follow(part, counts),
            FrictionalLagVariant::Delay => self.delay(part, counts),
            FrictionalLagVariant::FirstOrder => self.filter(part, counts),
        }
    }

    /// No lag: w = v.
    fn follow(&mut self, part: Motion, counts: bool) {
        let present = Piece::of(&part);
        if counts {
            self.dissipated_energy += self.work(&part, 0.0, present);
        }
        self.lagged_velocity = present.end;
    }

    /// w(t) = v(t - tau_L).
    fn delay(&mut self, part: Motion, counts: bool) {
        if self.delay_line.is_empty() {
            self.delay_line.push(Piece::held(self.time_lag, self.lagged_velocity), self.time_lag);
        }
        let present = Piece::of(&part);
        if counts {
            let mut work = 0.0;
            self.delay_line.delayed(present, self.time_lag, |from, piece| work += self.work(&part, from, piece));
            self.dissipated_energy += work;
        }
        self.delay_line.push(present, self.time_lag);
        self.lagged_velocity = self.delay_line.velocity(self.time_lag);
    }

    /// tau_L dw/dt + w = v.
    fn filter(&mut self, part: Motion, counts: bool) {
        let filter = Filter { start: self.lagged_velocity, time_lag: self.time_lag, motion: part };
        let w = |t| filter.at(t);
        if counts {
            let power = |t| self.power(&part, t, w(t));
            let work = |from, to| integral_past_peak(&power, &w, self.band(), from, to);
            self.dissipated_energy += filter.sections().map(|(from, to)| work(from, to)).sum::<f64>();
        }
        self.lagged_velocity = w(part.duration);
    }

    /// f_f v at time `t` of a motion.
    fn power(&self, motion: &Motion, t: f64, w: f64) -> f64 {
        self.steady(w, motion.load_at(t)) * motion.velocity_at(t).abs()
    }

    /// Energy dissipated from time `from` of a motion on, while w is that of `piece`.
    fn work(&self, motion: &Motion, from: f64, piece: Piece) -> f64 {
        if motion.is_steady() && piece.is_constant() {
            return self.power(motion, 0.0, piece.begin) * piece.duration;
        }
        let w = |t: f64| piece.at(t);
        integral_past_peak(&|t| self.power(motion, from + t, w(t)), &w, self.band(), 0.0, piece.duration)
    }

    /// |w| up to which the Stribeck peak counts.
    fn band(&self) -> f64 {
        self.stribeck_velocity * pow(NEGLIGIBLE, 1.0 / self.stribeck_exponent)
    }
}

impl Model for FrictionalLag {
    const STEADY_SLIDING: bool = true;
    const PRESETS: &'static [Preset] = &[
        Preset {
            name: "lubricated_guide",
            source: "Example of a lubricated guide: lag and Stribeck velocity in the middle of the reported ranges",
            values: &[
                ("mu_k", 0.05),
                ("mu_s", 0.1),
                ("stribeck_velocity", 0.01),
                ("viscous_coefficient", 5.0),
                ("time_lag", 0.01),
            ],
        },
        Preset {
            name: "slow_oscillation",
            source: "Example for a visible loop: drive it with (2 + 1.5 sin(2 pi t)) mm/s",
            values: &[("time_lag", 0.05)],
        },
    ];

    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    fn check_model_exchange(&self) -> Result<(), Fault> {
        self.delay_line.check_model_exchange()
    }

    const EVENT_INDICATORS: usize = EVENTS_ON_CURVE;

    fn event_indicators(&self, indicators: &mut [f64]) {
        self.contact().write_indicators(indicators);
    }

    fn at_event(&mut self) {
        if unloading::is_unloaded(self.normal_force) {
            self.release();
        } else {
            self.begin();
        }
        self.phase = self.contact().settled().number();
    }

    fn past(&self) -> Option<Past> {
        let is_delayed = !self.lags() || self.variant() == FrictionalLagVariant::Delay;
        let past = Past {
            lag: self.time_lag,
            now: self.velocity,
            before: self.lagged_velocity,
            is_kept: self.has_past != 0.0,
            rests: false,
        };
        is_delayed.then_some(past)
    }

    fn step(&mut self, dt: f64) {
        self.phase = Phase::Free.number();
        self.advance(Motion::held(self.velocity, self.normal_force, dt), true);
    }

    fn step_without_energy(&mut self, _memory: &mut [f64], dt: f64) {
        self.phase = Phase::Free.number();
        self.advance(Motion::held(self.velocity, self.normal_force, dt), false);
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
    }

    fn rate(&self, rate: &mut Self) {
        if self.lags() && self.has_past != 0.0 {
            rate.lagged_velocity = match self.variant() {
                FrictionalLagVariant::Delay => self.delay_line.slope(self.time_lag),
                FrictionalLagVariant::FirstOrder => (self.velocity - self.lagged_velocity) / self.time_lag,
            };
        }
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

/// The filtered velocity while the velocity moves linearly:
///
/// ```text
/// w(t) = v + (w(0) - v) exp(-x) + v' tau_L (x - 1 + exp(-x)),   x = t / tau_L
/// ```
struct Filter {
    /// w(0).
    start: f64,
    time_lag: f64,
    motion: Motion,
}

impl Filter {
    fn at(&self, t: f64) -> f64 {
        let x = t / self.time_lag;
        let lag = self.motion.acceleration * self.time_lag;
        let relaxed = relaxation::after(self.start, self.motion.velocity, x);
        // 0 times an infinite x would not be a number.
        if lag == 0.0 { relaxed } else { relaxed + lag * (x + exp_m1(-x)) }
    }

    /// The instant at which dw/dt = 0, if there is one.
    fn turn(&self) -> f64 {
        let lag = self.motion.acceleration * self.time_lag;
        ln_1p((self.start - self.motion.velocity) / lag) * self.time_lag
    }

    /// Sections of the motion in which w is monotonic and changes on one scale: the exponential fades within a few
    /// lags, which a quadrature over a long step would overlook.
    fn sections(&self) -> impl Iterator<Item = (f64, f64)> {
        let end = self.motion.duration;
        let [a, b, c] = FADING.map(|lags| lags * self.time_lag);
        let mut cuts = [0.0, a, b, c, self.turn(), end].map(|cut| if cut < end { cut.max(0.0) } else { end });
        cuts.sort_by(f64::total_cmp);
        (0..5).map(move |k| (cuts[k], cuts[k + 1])).filter(|(from, to)| to > from)
    }
}

/// Lags after which the exponential is e^-2, e^-10 and, negligibly small, e^-40.
const FADING: [f64; 3] = [2.0, 10.0, 40.0];

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn law(variant: FrictionalLagVariant, time_lag: f64) -> FrictionalLag {
        FrictionalLag { variant: variant.number(), time_lag, ..Default::default() }
    }

    fn force(law: &mut FrictionalLag) -> f64 {
        law.output();
        law.friction_force
    }

    const BOTH: [FrictionalLagVariant; 2] = [FrictionalLagVariant::Delay, FrictionalLagVariant::FirstOrder];

    /// The Gaussian curve, from the levels 0.981 N and 1.4715 N.
    fn gaussian(w: f64) -> f64 {
        0.981 + 0.4905 * (-(w / 1e-3).powi(2)).exp()
    }

    #[test]
    fn no_lag_is_the_static_law() {
        for variant in BOTH {
            let mut law = law(variant, 0.0);
            for velocity in [2e-3, -5e-4, 1e-5, -0.3] {
                law.velocity = velocity;
                assert_abs_diff_eq!(force(&mut law), gaussian(velocity) * velocity.signum(), epsilon = 1e-15);
                law.step(1e-3);
                assert_abs_diff_eq!(force(&mut law), gaussian(velocity) * velocity.signum(), epsilon = 1e-15);
            }
            law.velocity = 0.0;
            assert_eq!((force(&mut law), law.sticking), (0.0, 1.0));
        }
    }

    /// The sign is that of the present velocity, the level that of one lag earlier, until exactly one lag after the
    /// change.
    #[test]
    fn a_jump_of_the_velocity_reaches_the_level_one_lag_later() {
        let mut law = law(FrictionalLagVariant::Delay, 0.005);
        law.velocity = 1e-3;
        law.step(1.0);
        law.velocity = -4e-3;
        for k in 1..=8 {
            law.step(1e-3);
            let expected = if k < 5 { gaussian(1e-3) } else { gaussian(4e-3) };
            assert!((force(&mut law) + expected).abs() < 1e-15, "after {k} ms");
        }
        let before = gaussian(1e-3) * 4e-3 * 5e-3 + gaussian(4e-3) * 4e-3 * 3e-3;
        assert_abs_diff_eq!(law.dissipated_energy - gaussian(1e-3) * 1e-3, before, epsilon = 1e-15);
    }

    /// After a jump from 0 to v the filter gives w = v (1 - exp(-t / tau_L)).
    #[test]
    fn filter_relaxes_exponentially() {
        for pieces in [1, 3, 1000] {
            let mut law = law(FrictionalLagVariant::FirstOrder, 0.005);
            law.step(1e-3);
            law.velocity = 2e-3;
            for _ in 0..pieces {
                law.step(4e-3 / f64::from(pieces));
            }
            let w = 2e-3 * (1.0 - (-0.8f64).exp());
            assert_abs_diff_eq!(law.lagged_velocity, w, epsilon = 1e-17);
            assert_abs_diff_eq!(force(&mut law), gaussian(w), epsilon = 1e-12);
        }
    }

    /// A ramp through the filter: w = v' (t - tau_L (1 - exp(-t / tau_L))) from rest.
    #[test]
    fn filter_follows_a_ramp() {
        let mut law = law(FrictionalLagVariant::FirstOrder, 0.005);
        let slope = FrictionalLag { velocity: 0.3, normal_force: 0.0, ..law };
        law.step_ramp(&slope, 0.02);
        let w = 0.3 * (0.02 - 0.005 * (1.0 - (-4.0f64).exp()));
        assert!((law.lagged_velocity - w).abs() < 1e-16, "{} against {w}", law.lagged_velocity);
        assert_abs_diff_eq!(law.velocity, 6e-3, epsilon = 1e-17);
    }

    /// Energy against the midpoint rule over many short ramps, for velocity and load that both move and change sign.
    #[test]
    fn energy_is_the_integral_of_power() {
        for variant in BOTH {
            for (time_lag, exponent) in [(0.0, 2.0), (0.003, 2.0), (0.003, 0.5), (0.05, 1.0)] {
                let mut law =
                    FrictionalLag { stribeck_exponent: exponent, viscous_coefficient: 3.0, ..law(variant, time_lag) };
                (law.velocity, law.normal_force) = (-2e-3, 4.0);
                law.step(0.002);
                let slope = FrictionalLag { velocity: 0.7, normal_force: 100.0, ..law };
                let mut dense = law;
                law.step_ramp(&slope, 0.02);
                let (mut power, n) = (dense.dissipated_energy, 40_000);
                for _ in 0..n {
                    dense.step_ramp(&slope, 0.01 / f64::from(n));
                    dense.output();
                    power += dense.dissipated_power * 0.02 / f64::from(n);
                    dense.step_ramp(&slope, 0.01 / f64::from(n));
                }
                let relative = law.dissipated_energy / power - 1.0;
                assert!(relative.abs() < 1e-6, "{variant:?} {time_lag} {exponent}: {relative}");
            }
        }
    }

    #[test]
    fn the_first_step_starts_in_the_steady_state() {
        for variant in BOTH {
            let mut law = FrictionalLag { velocity: 5e-4, ..law(variant, 0.01) };
            for _ in 0..30 {
                assert_abs_diff_eq!(force(&mut law), gaussian(5e-4), epsilon = 1e-15);
                law.step(1e-3);
            }
        }
    }

    #[test]
    fn release_forgets_the_past() {
        for variant in BOTH {
            let mut law = FrictionalLag { velocity: 5e-4, ..law(variant, 0.01) };
            law.step(0.1);
            law.normal_force = 0.0;
            assert_eq!(force(&mut law), 0.0);
            law.step(1e-6);
            (law.normal_force, law.velocity) = (9.81, 0.02);
            law.step(1e-3);
            assert_abs_diff_eq!(force(&mut law), gaussian(0.02), epsilon = 1e-15);
        }
    }
}
