use crate::contact::conditions::not_below;
use crate::host::oscillator::undamped;
use crate::laws::stribeck;
use crate::model::{Brief, Derivatives, Fault, Law, Meaning, Model, ModelExchange, boolean, integrate, ramp, real};
use crate::number::elementary::{self, pow};
use crate::number::{Real, choose};
use crate::numerics::exponential::exp_m1;

crate::choices! {
    /// Ways in which a controller compensates for friction.
    pub enum Compensation {
        /// The controller knows nothing of friction.
        Off,
        /// Coulomb and viscous friction at the velocity of the target.
        FeedForward,
        /// The force of LuGre's law, whose deflection an observer estimates from the velocity and the position error.
        Observer,
    }
}

crate::model! {
    /// A mass whose position a PID controller holds or moves, against friction: hunting, quadrant glitches, and what
    /// compensation of friction does about them.
    ///
    /// # Equations
    ///
    /// ```text
    /// m dv/dt = u - f_f
    /// de_I/dt = x - x_d
    /// f_e = u = -k_v (v - v_d) - k_p (x - x_d) - k_i e_I + m a_d + f_c
    /// f_n = f_g
    ///
    /// f_c = 0                                                     Off
    /// f_c = F_C sign(v_d) + sigma_2 v_d                           FeedForward
    /// f_c = sigma_0 z + sigma_1 dz/dt + sigma_2 v                 Observer
    ///
    /// dz/dt = v - sigma_0 |v| z / g(v) - k (x - x_d)
    /// g(v)  = F_C + (F_s - F_C) exp(-(v / v_S)^2)
    /// ```
    ///
    /// A sampled controller, T > 0, computes its force at the times 0, T, 2 T, ... and holds it in between:
    ///
    /// ```text
    /// x_n = q round(x / q)            if q > 0, else x
    /// v_n = (x_n - x_(n-1)) / T       at first 0
    /// u_n = -k_v (v_n - v_d) - k_p (x_n - x_d) - k_i e_I + m a_d + f_c
    /// e_I is then raised by T (x_n - x_d)
    /// ```
    ///
    /// Its observer computes $f_c$ from $v_n$ and $x_n - x_d$, and then solves its equation for them over the time T:
    ///
    /// ```text
    /// z is then raised by T dz/dt (1 - exp(-a)) / a,   a = T sigma_0 |v_n| / g(v_n)
    /// ```
    ///
    /// | symbol  | variable              | unit    | meaning                                            |
    /// |---------|-----------------------|---------|----------------------------------------------------|
    /// | f_f     | `friction_force`      | N       | friction force on the mass                         |
    /// | x_d     | `target_position`     | m       | position that the controller aims at               |
    /// | v_d     | `target_velocity`     | m/s     | velocity that it aims at                           |
    /// | a_d     | `target_acceleration` | m/s2    | acceleration that it aims at                       |
    /// | m       | `mass`                | kg      | mass that moves, that of the drive included        |
    /// | k_p     | `proportional_gain`   | N/m     | force by position error                            |
    /// | k_i     | `integral_gain`       | N/(m.s) | force by the integral of the position error        |
    /// | k_v     | `velocity_gain`       | N.s/m   | force by velocity error                            |
    /// | f_g     | `guide_force`         | N       | normal forces of the guides, preload and weight    |
    /// | -       | `compensation`        | -       | how the controller compensates for friction        |
    /// | F_C     | `kinetic_force`       | N       | kinetic level that the controller assumes          |
    /// | F_s     | `breakaway_force`     | N       | static level that the observer assumes             |
    /// | v_S     | `stribeck_velocity`   | m/s     | Stribeck velocity of the observer                  |
    /// | sigma_0 | `sigma_0`             | N/m     | stiffness of its bristles                          |
    /// | sigma_1 | `sigma_1`             | N.s/m   | damping of its bristles                            |
    /// | sigma_2 | `viscous_coefficient` | N.s/m   | viscous coefficient that the controller assumes    |
    /// | k       | `observer_gain`       | 1/s     | gain of the observer                               |
    /// | T       | `sample_time`         | s       | time between two samples of the controller         |
    /// | q       | `encoder_resolution`  | m       | increment of the encoder                           |
    /// | x       | `position`            | m       | position                                           |
    /// | v       | `velocity`            | m/s     | velocity                                           |
    /// | e_I     | `error_integral`      | m.s     | integral of the position error                     |
    /// | z       | `deflection_estimate` | m       | deflection of the bristles as the observer sees it |
    /// | f_e     | `external_force`      | N       | force of the controller                            |
    /// | f_n     | `normal_force`        | N       | sum of the normal forces of the guides             |
    ///
    /// Of a joint that turns, inertia, torques and angles stand for mass, forces and lengths: kg.m2, N.m and rad.
    ///
    /// While the mass sticks short of the target, the integral winds up and the force grows at the rate $k_i (x_d - x)$
    /// until the mass breaks away; if friction then falls, it overshoots. Where the static level is above the kinetic
    /// one this can go on for ever: the mass hunts around its target. A system with this host is `servo` of the
    /// workbench.
    ///
    /// # Sign
    /// Force, position and velocity are positive in the same direction. `friction_force` has the sign of `velocity`
    /// when sliding; the mass feels `-friction_force`.
    ///
    /// # Step
    /// Without the observer the closed loop is linear, and the step is exact for held inputs and for inputs that move
    /// linearly: the exponential of a matrix, split where the velocity of the target changes its sign. With the
    /// observer the step integrates the rates with error control. With a sample time it goes exactly from sample to
    /// sample, wherever the communication points lie; a sample at a communication point sees the inputs that are valid
    /// from there on, and the force is that of the sample as soon as they are set. Outputs follow from states and
    /// target, without direct feed-through of the friction force. In Model Exchange a change of sign of the
    /// target's velocity is an event if the controller feeds friction forward.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; with the observer, `breakaway_force` < `kinetic_force`, a `kinetic_force`
    /// of 0, or, without a sample time, a step that would need more than 500,000 pieces; a `sample_time` below 1 us, a
    /// step with more than 10 million samples, and Model Exchange of a sampled controller; an `encoder_resolution`
    /// without a `sample_time`.
    ///
    /// # Limits
    /// The drive is stiff, its force has no limit, and the travel has no stops. The closed loop is stable without
    /// friction only if $k_p k_v > k_i m$. The three target inputs are not compared: a step is a `target_position` that
    /// jumps, with the other two at 0, and then the velocity gain damps the motion.
    ///
    /// The observer is proven to converge without integral gain if $(sigma_1 s + sigma_0) / (m s^2 + k_v s + k_p)$ is
    /// strictly positive real, which it is if $sigma_1 k_v > sigma_0 m$. The start values are not covered by that: with
    /// them $k_v$ would have to be above 316 N.s/m. The friction force comes from the master: held
    /// over a step, it makes the coupling a method of first order.
    ///
    /// # Source
    /// C. Canudas de Wit, H. Olsson, K. J. Astrom, P. Lischinsky (1995), "A new model for control of systems with
    /// friction", IEEE Transactions on Automatic Control 40, 419-425, doi:10.1109/9.376053: the PID controller with its
    /// gains and mass, and the observer; the parameters of friction are those of its Table 1. The velocity of the
    /// target in the controller, and feed-forward of friction at that velocity, are the usual additions: B.
    /// Armstrong-Helouvry, P. Dupont, C. Canudas de Wit (1994), Automatica 30, 1083-1138,
    /// doi:10.1016/0005-1098(94)90209-7. The condition for the gains follows from the sign of the real part.
    ///
    /// # Example
    /// ```
    /// use stribeck::host::PositionControl;
    /// use stribeck::model::{Law, Model};
    /// let mut control = PositionControl { target_position: 1.0, ..Default::default() };
    /// control.output();
    /// assert_eq!(control.external_force, 3.0); // k_p at a distance of 1 m
    /// control.friction_force = 3.0;
    /// control.step(1e-9);
    /// control.output();
    /// assert!((control.external_force - 3.0 - 4e-9).abs() < 1e-15); // k_i winds it up by 4 N/s
    /// ```
    PositionControl: "Mass whose position a PID controller holds or moves" {
        /// Friction force; has the sign of the velocity when sliding. Body 1 feels its negative.
        friction_force: input = real("N", 0.0).means(Meaning::FrictionForce),
        /// Position that the controller aims at.
        target_position: input = real("m", 0.0),
        /// Velocity that the controller aims at.
        target_velocity: input = real("m/s", 0.0),
        /// Acceleration that the controller aims at.
        target_acceleration: input = real("m/s2", 0.0),
        /// Mass that moves.
        mass: fixed = real("kg", 1.0).positive(),
        /// Force by position error.
        proportional_gain: tunable = real("N/m", 3.0).at_least(0.0),
        /// Force by the integral of the position error.
        integral_gain: tunable = real("N/(m.s)", 4.0).at_least(0.0),
        /// Force by velocity error.
        velocity_gain: tunable = real("N.s/m", 6.0).at_least(0.0),
        /// Sum of the normal forces of the guides (default chosen: a coefficient of friction is then a force in N).
        guide_force: tunable = real("N", 1.0).at_least(0.0),
        /// How the controller compensates for friction.
        compensation: fixed = Compensation::Off.start(),
        /// Kinetic level that the controller assumes.
        kinetic_force: tunable = real("N", 1.0).at_least(0.0),
        /// Static level that the observer assumes.
        breakaway_force: tunable = real("N", 1.5).at_least(0.0),
        /// Stribeck velocity of the observer.
        stribeck_velocity: tunable = real("m/s", 1e-3).positive().shown_in("mm/s"),
        /// Stiffness of the bristles of the observer.
        sigma_0: tunable = real("N/m", 1e5).positive().nominal(1e5),
        /// Damping of the bristles of the observer.
        sigma_1: tunable = real("N.s/m", 316.227_766_016_837_94).at_least(0.0).nominal(100.0),
        /// Viscous coefficient that the controller assumes.
        viscous_coefficient: tunable = real("N.s/m", 0.4).at_least(0.0),
        /// Deflection per second that a position error of 1 m adds to the estimate of the observer (default chosen).
        observer_gain: tunable = real("1/s", 1e-4).at_least(0.0).nominal(1e-3),
        /// Time between two samples of the controller; 0 = a continuous one.
        sample_time: fixed = real("s", 0.0).at_least(0.0).shown_in("ms"),
        /// Increment of the encoder that measures the position of a sampled controller; 0 = an exact one.
        encoder_resolution: fixed = real("m", 0.0).at_least(0.0).nominal(1e-6).shown_in("um"),
        /// Position of the mass.
        position: state_output = real("m", 0.0).nominal(1e-2),
        /// Velocity of the mass.
        velocity: state_output = real("m/s", 0.0).nominal(0.1).means(Meaning::Velocity),
        /// Integral of the position error.
        error_integral: state = real("m.s", 0.0).nominal(1e-2),
        /// Deflection of the bristles as the observer estimates it.
        deflection_estimate: state = real("m", 0.0).nominal(1e-5).shown_in("um"),
        /// Has the controller taken a sample?
        started: state = boolean(false).hidden(),
        /// Time to the next sample.
        time_to_sample: state = real("s", 0.0).discrete().hidden(),
        /// Position at the last sample, as the encoder showed it.
        sampled_position: state = real("m", 0.0).discrete().hidden(),
        /// Force of the controller since the last sample.
        held_force: state = real("N", 0.0).discrete().hidden(),
        /// Force of the controller.
        external_force: output = real("N", 0.0).means(Meaning::ExternalForce),
        /// Sum of the normal forces of the guides.
        normal_force: output = real("N", 0.0).means(Meaning::NormalForce),
    }
}

/// A sample of the controller: position as the encoder shows it, velocity, error, and force.
struct Sample<T> {
    position: T,
    velocity: T,
    error: T,
    force: T,
}

impl<T: Real> PositionControl<T> {
    fn error(&self) -> T {
        self.position - self.target_position
    }

    /// Rate of the estimated deflection of a continuous controller.
    fn estimate_rate(&self) -> T {
        let observes = Compensation::Observer.is(self.compensation);
        let rate = choose!(observes, self.observed_rate(self.velocity, self.error()), T::zero());
        choose!(self.is_continuous(), rate, T::zero())
    }

    /// Level of friction at a velocity, as the observer assumes it.
    fn level(&self, velocity: T) -> T {
        let [kinetic, breakaway] = [self.kinetic_force, self.breakaway_force];
        stribeck::level(velocity, kinetic, breakaway, self.stribeck_velocity, T::from(2.0))
    }

    /// Rate of the estimated deflection at a velocity and a position error.
    fn observed_rate(&self, velocity: T, error: T) -> T {
        let slips = self.sigma_0 * velocity.abs() * self.deflection_estimate / self.level(velocity);
        velocity - slips - self.observer_gain * error
    }

    /// Friction that the controller compensates for at a velocity and a position error.
    fn compensated(&self, velocity: T, error: T) -> T {
        let fed_forward =
            self.kinetic_force * self.target_velocity.sign() + self.viscous_coefficient * self.target_velocity;
        choose!(
            Compensation::Observer.is(self.compensation),
            self.sigma_0 * self.deflection_estimate
                + self.sigma_1 * self.observed_rate(velocity, error)
                + self.viscous_coefficient * velocity,
            choose!(Compensation::FeedForward.is(self.compensation), fed_forward, T::zero())
        )
    }

    fn is_continuous(&self) -> T::Mask {
        self.sample_time.vanishes()
    }

    /// Force of the controller. Where a sample is due it is that of the sample: a step that follows takes it with the same
    /// inputs.
    fn control(&self) -> T {
        choose!(
            self.is_continuous(),
            self.command(self.velocity, self.error()),
            choose!(self.is_due(), self.sampled().force, self.held_force)
        )
    }

    /// Whether it is time for a sample, as far as rounding tells.
    fn is_due(&self) -> T::Mask {
        self.time_to_sample.at_most(T::from(EARLY) * self.sample_time)
    }

    /// The sample that the controller would take now.
    fn sampled(&self) -> Sample<T> {
        let resolution = self.encoder_resolution;
        let whole = |lane: usize| {
            let resolution = resolution.lane(lane);
            [resolution * (self.position.lane(lane) / resolution).round(), 0.0]
        };
        let [counted, _] = T::found(|| [self.position, resolution], whole);
        let position = choose!(resolution.is_positive(), counted, self.position);
        let before = choose!(self.started.vanishes(), position, self.sampled_position);
        let error = position - self.target_position;
        let velocity = (position - before) / self.sample_time;
        Sample { position, velocity, error, force: self.command(velocity, error) }
    }

    /// Force that the controller computes from the velocity and the position error that it sees.
    fn command(&self, velocity: T, error: T) -> T {
        self.mass * self.target_acceleration + self.compensated(velocity, error)
            - self.velocity_gain * (velocity - self.target_velocity)
            - self.proportional_gain * error
            - self.integral_gain * self.error_integral
    }
}

impl<T: Real> Law for PositionControl<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.external_force = self.control();
        self.normal_force = self.guide_force;
    }
}

impl<T: Real> Derivatives for PositionControl<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.position = self.velocity;
        rate.velocity = (self.control() - self.friction_force) / self.mass;
        rate.error_integral = choose!(self.is_continuous(), self.error(), T::zero());
        rate.deflection_estimate = self.estimate_rate();
    }
}

impl PositionControl {
    fn observes(&self) -> bool {
        self.compensation == Compensation::Observer.number()
    }

    fn feeds_forward(&self) -> bool {
        self.compensation == Compensation::FeedForward.number()
    }

    /// Exact motion of the linear loop while the inputs move at constant rates. Relative to the target, whose position
    /// moves at the rate s, the position error y obeys
    ///
    /// ```text
    /// m y'' + k_v y' + k_p y + k_i e_I = b + b' t,   e_I' = y
    /// ```
    ///
    /// The variables are those of a time w t, of which the loop needs about 1 for its fastest motion: w e_I, y, y' / w,
    /// and the right side by m w^2. `sign` is that of the velocity of the target.
    fn advance(&mut self, slope: &Self, sign: f64, t: f64) {
        let pace = slope.target_position;
        let gains = [self.integral_gain, self.proportional_gain, self.velocity_gain].map(|gain| gain / self.mass);
        let w = (1.0 / t).max(pow(gains[0], 1.0 / 3.0)).max(gains[1].sqrt()).max(gains[2]);
        let [i, p, v] = [gains[0] / (w * w * w), gains[1] / (w * w), gains[2] / w].map(|part| part * w * t);
        let grown = {
            let h = w * t;
            let rows =
                [[0.0, h, 0.0, 0.0, 0.0], [0.0, 0.0, h, 0.0, 0.0], [-i, -p, -v, h, 0.0], [0.0, 0.0, 0.0, 0.0, h]];
            exp_m1(&[rows[0], rows[1], rows[2], rows[3], [0.0; 5]])
        };
        let [kinetic, viscous] =
            if self.feeds_forward() { [self.kinetic_force, self.viscous_coefficient] } else { [0.0; 2] };
        let push = self.velocity_gain * (self.target_velocity - pace)
            + kinetic * sign
            + viscous * self.target_velocity
            + self.mass * self.target_acceleration
            - self.friction_force;
        let push_rate = (self.velocity_gain + viscous) * slope.target_velocity + self.mass * slope.target_acceleration
            - slope.friction_force;
        let state = [
            self.error_integral * w,
            self.error(),
            (self.velocity - pace) / w,
            push / (self.mass * w * w),
            push_rate / (self.mass * w * w * w),
        ];
        let change = |row: usize| -> f64 { grown[row].iter().zip(state).map(|(factor, value)| factor * value).sum() };
        self.error_integral += change(0) / w;
        self.position += change(1) + pace * t;
        self.velocity += change(2) * w;
    }

    /// Samples position and target.
    fn sample(&mut self) {
        let Sample { position, velocity, error, force } = self.sampled();
        (self.held_force, self.sampled_position, self.started) = (force, position, 1.0);
        self.error_integral += self.sample_time * error;
        if self.observes() {
            let slips = self.sample_time * self.sigma_0 * velocity.abs() / self.level(velocity);
            let part = if slips > 0.0 { -elementary::exp_m1(-slips) / slips } else { 1.0 };
            self.deflection_estimate += self.sample_time * self.observed_rate(velocity, error) * part;
        }
        self.time_to_sample = self.sample_time;
    }

    fn samples_too_often(&self, dt: f64) -> bool {
        self.sample_time > 0.0 && dt / self.sample_time > MOST_SAMPLES
    }

    /// Motion from sample to sample while the inputs move at constant rates.
    fn advance_sampled(&mut self, slope: &Self, dt: f64) {
        if self.samples_too_often(dt) {
            self.position = f64::NAN;
            return;
        }
        let begin = ramp::Inputs::of(self);
        let mut at = 0.0;
        while at < dt {
            if self.is_due() {
                self.sample();
            }
            let rest = dt - at;
            // A sample at the end of the step belongs to the next one, which may have other inputs.
            let is_within = self.time_to_sample + EARLY * self.sample_time < rest;
            let span = if is_within { self.time_to_sample } else { rest };
            let push = [self.held_force - self.friction_force, -slope.friction_force].map(|push| push / self.mass);
            [self.position, self.velocity] = undamped([self.position, self.velocity], push, 0.0, span);
            at = if is_within { at + span } else { dt };
            ramp::set_inputs(self, &begin, slope, at);
            self.time_to_sample -= span;
        }
    }

    /// Time at which the velocity of the target changes its sign within a step, or its end.
    fn sign_change(&self, slope: &Self, dt: f64) -> f64 {
        let change = -self.target_velocity / slope.target_velocity;
        if self.feeds_forward() && change > 0.0 && change < dt { change } else { dt }
    }
}

/// Shortest sample time in s (chosen).
const SHORTEST: f64 = 1e-6;

/// Most samples of a step (chosen: about a second of computation).
const MOST_SAMPLES: f64 = 1e7;

/// Part of the sample time by which a sample may be early or late (chosen), so that it meets a communication point in
/// spite of rounding.
const EARLY: f64 = 1e-9;

impl Model for PositionControl {
    fn check_step(&self, dt: f64) -> Result<(), Fault> {
        if !self.samples_too_often(dt) {
            return Ok(());
        }
        let [sample_time, longest] = [self.sample_time, MOST_SAMPLES * self.sample_time].map(Brief);
        Err(Fault::new(format_args!(
            "sample_time = {sample_time} s: a step must be <= {longest} s, in which the controller samples 10 million times"
        )))
    }

    const EVENT_INDICATORS: usize = 1;
    const PIECEWISE_LINEAR: bool = true;

    fn check(&self) -> Result<(), Fault> {
        if self.observes() {
            not_below(("breakaway_force", self.breakaway_force), ("kinetic_force", self.kinetic_force))?;
            if self.kinetic_force == 0.0 {
                return Err(Fault::new(format_args!("kinetic_force = 0: must be > 0 with compensation = Observer")));
            }
        }
        let (sample_time, resolution) = (self.sample_time, self.encoder_resolution);
        let fault = |limit: &str| Err(Fault::new(format_args!("sample_time = {sample_time}: must be {limit}")));
        if sample_time > 0.0 && sample_time < SHORTEST {
            return fault("0 or >= 0.000001");
        }
        if resolution > 0.0 && sample_time == 0.0 {
            return Err(Fault::new(format_args!("encoder_resolution = {resolution}: must be 0 with sample_time = 0")));
        }
        Ok(())
    }

    fn check_model_exchange(&self) -> Result<(), Fault> {
        if self.sample_time == 0.0 {
            return Ok(());
        }
        let why = "must be 0 for solvers that integrate rates, because a sampled controller acts in steps";
        Err(Fault::new(format_args!("sample_time = {}: {why}", self.sample_time)))
    }

    /// Where the velocity of the target changes its sign, so does the friction that is fed forward.
    fn event_indicators(&self, indicators: &mut [f64]) {
        indicators[0] = if self.feeds_forward() { self.target_velocity } else { 1.0 };
    }

    fn is_linear(&self) -> bool {
        !self.observes() && self.is_continuous()
    }

    fn step(&mut self, dt: f64) {
        self.step_ramp(&ramp::held_inputs(self), dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        if !self.is_continuous() {
            return self.advance_sampled(slope, dt);
        }
        if self.observes() {
            return integrate::advance::<_, 4>(self, slope, dt);
        }
        let begin = ramp::Inputs::of(self);
        let turn = self.sign_change(slope, dt);
        let mut at = 0.0;
        for end in [turn, dt] {
            if end > at {
                let middle = self.target_velocity + slope.target_velocity * 0.5 * (end - at);
                self.advance(slope, middle.sign(), end - at);
                ramp::set_inputs(self, &begin, slope, end);
                at = end;
            }
        }
    }
}

#[cfg(test)]
mod tests;
