//! Steps with error control from event to event.

use super::event::{Bracket, Crossing, Watch};
use super::judge;
use super::recorder::{Course, Piece, Recorder};
use super::statistics::{End, Event, Statistics};
use super::step::{Beginning, Step};
use super::{Equations, Options};

/// Safety factor and limits of the change of a step size, as usual.
const SAFETY: f64 = 0.9;
const SHRINK: f64 = 0.1;
const GROW: f64 = 6.0;

/// Error, in parts of the tolerance, below which growth is not judged; the value of the code Radau5.
const LEAST_ERROR: f64 = 1e-2;

/// Factor by which a step that cannot be believed is shortened, at least (chosen).
const DOUBT: f64 = 0.5;

/// Part of a step at which a rejected step that meets an event is tried again, beyond the event (chosen).
const BEYOND: f64 = 1.0 + 1e-3;

/// Parts of a step to which the polynomial's crossing is found (chosen): the steps made after it find the rest.
const PRECISION: f64 = 1e-9;

/// Largest number of steps made to end at an event (chosen).
const MOST_TRIALS: u32 = 100;

/// Steps between two looks at progress and cancellation (chosen).
const LOOK: u64 = 256;

/// A run under way.
struct March<'a, S: Step<N>, const N: usize> {
    equations: &'a mut dyn Equations,
    options: &'a Options<'a>,
    recorder: &'a mut Recorder,
    scales: [f64; N],
    begin: Beginning<N>,
    step: S,
    watch: Watch,
    /// The motion within the step made last, once it was asked for.
    course: Option<S::Course>,
    /// The equations at the end of the step made last, if they were looked at.
    ahead: Option<Beginning<N>>,
    statistics: Statistics,
    /// Length and error of the step before, since the last event.
    last: Option<(f64, f64)>,
}

/// Outcome of making a step.
struct Made {
    end: f64,
    /// Indicator of the event at which it ends.
    event: Option<usize>,
    /// Length that the error control proposes for the next step.
    next: f64,
}

/// Factor by which the error control changes a step whose error grows with this power of the step size:
/// SAFETY error^(-1 / order), between SHRINK and GROW.
fn change(error: f64, order: i32) -> f64 {
    let [most, least] = [SHRINK, GROW].map(|factor| power(SAFETY / factor, order));
    if error.is_nan() || error >= most {
        return SHRINK;
    }
    if error <= least {
        return GROW;
    }
    // The bits of a number are nearly its logarithm: those of 1 less an order-th of what lies between. Newton's method
    // needs no division then, and each pass squares the deviation, at most 0.06 at the beginning (times 3 for order 5).
    // Two passes leave less than a thousandth, which is more than the error control knows.
    let one = 1f64.to_bits() as i64;
    let mut root = f64::from_bits((one - (error.to_bits() as i64 - one) / i64::from(order)) as u64);
    for _ in 0..2 {
        root *= 1.0 + (1.0 - error * power(root, order)) / f64::from(order);
    }
    SAFETY * root
}

/// x^n.
fn power(x: f64, n: i32) -> f64 {
    (0..n).fold(1.0, |product, _| product * x)
}

/// Runs a method. The states are those at the end afterwards.
pub(super) fn run<S: Step<N>, const N: usize>(
    equations: &mut dyn Equations,
    states: &mut [f64],
    options: &Options,
    recorder: &mut Recorder,
) -> (End, Statistics) {
    let mut scales = [1.0; N];
    scales.copy_from_slice(equations.scales());
    let watch = Watch::new(equations, N);
    let zero = [0.0; N];
    let mut begin = Beginning { time: options.begin, states: zero, rates: zero, jacobian: [zero; N], by_time: zero };
    let count = states.len();
    begin.states[..count].copy_from_slice(states);
    let statistics = Statistics::default();
    let (step, course, ahead) = (S::default(), None, None);
    let mut march =
        March { equations, options, recorder, scales, begin, step, watch, course, ahead, statistics, last: None };
    let end = match march.go() {
        Ok(end) => end,
        Err(reason) => End::Failed { time: march.begin.time, reason },
    };
    states.copy_from_slice(&march.begin.states[..count]);
    (end, march.statistics)
}

impl<S: Step<N>, const N: usize> March<'_, S, N> {
    fn go(&mut self) -> Result<End, String> {
        self.settle()?;
        self.record(self.begin.time, self.begin.states)?;
        let mut h = self.first_step();
        let end = self.options.end;
        while self.begin.time < end {
            if self.statistics.steps.is_multiple_of(LOOK) {
                if self.options.is_cancelled() {
                    return Ok(End::Cancelled { time: self.begin.time });
                }
                if let Some(progress) = self.options.progress {
                    progress.reached(self.begin.time);
                }
            }
            let made = self.advance(h)?;
            self.accept(&made)?;
            h = made.next;
        }
        Ok(End::Reached)
    }

    /// Makes events until none is due, and looks at the equations there.
    fn settle(&mut self) -> Result<(), String> {
        let time = self.begin.time;
        // What was before an event says nothing about what comes after it.
        self.last = None;
        self.equations.at_event(time, &mut self.begin.states)?;
        self.step.begin(self.equations, self.options);
        if self.options.events && self.watch.is_needed() {
            self.watch.begin(self.equations, time, &self.begin.states);
        }
        self.look()
    }

    /// Evaluates rates and Jacobian at the beginning of a step. After an exact one the Jacobian is that before it.
    fn look(&mut self) -> Result<(), String> {
        if self.step.is_exact() {
            let Beginning { time, states, rates, .. } = &mut self.begin;
            self.statistics.evaluations += 1;
            self.equations.rates(*time, states, rates);
        } else {
            self.begin = self.linearised(self.begin.time, self.begin.states);
        }
        self.check(&self.begin)
    }

    fn linearised(&mut self, time: f64, states: [f64; N]) -> Beginning<N> {
        let mut there = Beginning { time, states, ..self.begin };
        let Beginning { rates, jacobian, by_time, .. } = &mut there;
        self.equations.linearise(time, &states, rates, jacobian.as_flattened_mut(), by_time);
        self.statistics.evaluations += 1;
        self.statistics.jacobians += 1;
        there
    }

    /// Refuses equations that are not finite.
    fn check(&self, there: &Beginning<N>) -> Result<(), String> {
        let Beginning { rates, jacobian, .. } = there;
        match rates.iter().chain(jacobian.as_flattened()).position(|number| !number.is_finite()) {
            None => Ok(()),
            Some(at) if at < N => Err(format!("the rate of {} is not finite", self.equations.state_name(at))),
            Some(at) => {
                let [of, by] = [at / N - 1, at % N].map(|state| self.equations.state_name(state));
                Err(format!("the derivative of the rate of {of} with respect to {by} is not finite"))
            }
        }
    }

    /// Error or change, in parts of the tolerance; 0 without states.
    fn norm(&self, of: &[f64; N], other: &[f64; N]) -> f64 {
        let Options { relative, absolute, .. } = *self.options;
        let part = |i: usize| {
            let size = self.begin.states[i].abs().max(other[i].abs());
            let part = of[i] / (absolute * self.scales[i] + relative * size);
            part * part
        };
        ((0..N).map(part).sum::<f64>() / self.equations.states().max(1) as f64).sqrt()
    }

    /// A step in which the states change by a hundredth of their size; see E. Hairer, S. P. Norsett, G. Wanner, Solving
    /// Ordinary Differential Equations I, section II.4.
    fn first_step(&self) -> f64 {
        if self.step.ends_at_results() {
            // Such a step costs what happens in it, however long it is.
            return self.wall() - self.begin.time;
        }
        let Beginning { states, rates, .. } = &self.begin;
        let (size, pace) = (self.norm(states, states), self.norm(rates, states));
        let span = self.options.end - self.begin.time;
        if size < 1e-5 || pace < 1e-5 { 1e-6 * span } else { (0.01 * size / pace).min(span) }
    }

    /// The shortest step that moves the time.
    fn shortest(&self) -> f64 {
        16.0 * f64::EPSILON * self.begin.time.abs().max(self.options.end.abs() * f64::EPSILON)
    }

    fn attempt(&mut self, h: f64) -> bool {
        self.course = None;
        let is_made = self.step.attempt(self.equations, &self.begin, h);
        self.statistics.evaluations += self.step.evaluations();
        is_made
    }

    /// Whether the equations are what the step takes them for.
    fn is_confirmed(&mut self, to_event: bool) -> bool {
        self.step.is_confirmed(self.equations, &self.begin, to_event, &mut self.statistics)
    }

    fn course(&mut self) -> S::Course {
        *self.course.get_or_insert_with(|| self.step.course(&self.begin))
    }

    /// The time at which the next step must end at the latest.
    fn wall(&self) -> f64 {
        let result = self.recorder.next().filter(|_| self.step.ends_at_results()).unwrap_or(f64::INFINITY);
        self.equations.next_break(self.begin.time).min(self.options.end).min(result)
    }

    /// Makes the next step, of length h or shorter.
    fn advance(&mut self, h: f64) -> Result<Made, String> {
        let wall = self.wall();
        let mut h = h.min(self.options.longest);
        loop {
            if self.statistics.steps + self.statistics.rejected >= self.options.most_steps {
                return Err(format!("more than {} steps", self.options.most_steps));
            }
            let room = wall - self.begin.time;
            // A remainder hardly longer than the step is made in one.
            let is_last = h >= room / 1.01;
            let length = if is_last { room } else { h };
            let error = if self.attempt(length) { self.step.excess(|of, end| self.norm(of, end)) } else { f64::NAN };
            let factor = change(error, S::ERROR_ORDER);
            // Where an exact step is too long, its crossing tells nothing that the next attempt does not.
            let is_of_use = error <= 1.0 || !(error.is_nan() || self.step.is_exact());
            let crossing = if is_of_use { self.first_change(length) } else { None };
            if error <= 1.0 {
                let next = length * self.growth(length, error, factor);
                let made = match crossing {
                    None => Some((length, None)),
                    Some(crossing) => self.locate(length, crossing).map(|(at, event)| (at, Some(event))),
                };
                match made {
                    Some((made, event)) if self.is_confirmed(event.is_some()) => {
                        let end = if is_last && event.is_none() { wall } else { self.begin.time + made };
                        match self.doubt(end, made, event.is_some())? {
                            None => return Ok(Made { end, event, next }),
                            Some(factor) => h = made * factor,
                        }
                    }
                    Some(_) => h = length,
                    None if 0.5 * length < self.shortest() => return Err(self.chatters(crossing)),
                    None => h = 0.5 * length,
                }
            } else {
                h = length * crossing.map_or(factor, |crossing| factor.max(crossing.fraction * BEYOND).min(0.9));
            }
            self.statistics.rejected += 1;
            if h < self.shortest() {
                return Err(self.too_short(h));
            }
        }
    }

    /// Looks at the equations at the end of the step made last: whether it has to be made again, and by which factor shorter.
    /// Its end less its beginning is not its length to the last digit.
    fn doubt(&mut self, end: f64, length: f64, to_event: bool) -> Result<Option<f64>, String> {
        self.ahead = None;
        if self.step.is_exact() {
            return Ok(None);
        }
        let ahead = self.linearised(end, *self.step.end());
        match self.check(&ahead) {
            // What comes after an event has other equations.
            Err(_) if to_event => return Ok(None),
            checked => checked?,
        }
        let mut slopes = [0.0; N];
        self.course().end_slopes(&mut slopes);
        let defect = judge::defect(&ahead, &slopes, length, S::GAMMA);
        let excess = defect.map_or(f64::INFINITY, |defect| self.norm(&defect, &ahead.states) / S::DEFECT);
        if excess > 1.0 {
            return Ok(Some(change(excess, S::ERROR_ORDER).min(DOUBT)));
        }
        if let Some(correction) = defect
            && self.is_illusion(&ahead, &slopes, length, &correction)
        {
            self.check_resolution(&ahead, &correction)?;
            return Ok(Some(DOUBT));
        }
        self.ahead = Some(ahead);
        // The law may hold the body at the end: then only the beginning knows that the motion grew away from there.
        let grows = [&self.begin.jacobian, &ahead.jacobian].into_iter().any(|jacobian| judge::grows(jacobian, length));
        Ok(grows.then_some(DOUBT))
    }

    /// Whether the correction of a steep state, small as it is, leaves the defect as it was: the slope does not last so far,
    /// or the state does not change by so little.
    fn is_illusion(&mut self, end: &Beginning<N>, slopes: &[f64; N], length: f64, correction: &[f64; N]) -> bool {
        let by_rates = |rates: &[f64; N]| -> [f64; N] { std::array::from_fn(|i| rates[i] * length - slopes[i]) };
        let before = self.norm(&by_rates(&end.rates), &end.states);
        let share = length / (self.options.end - self.options.begin);
        if before <= (judge::STEEP * self.norm(correction, &end.states)).max(judge::HARMLESS * share) {
            return false;
        }
        let corrected: [f64; N] = std::array::from_fn(|i| end.states[i] + correction[i]);
        let mut rates = [0.0; N];
        self.equations.rates(end.time, &corrected, &mut rates);
        self.statistics.evaluations += 1;
        let after: [f64; N] = by_rates(&rates);
        let left: [f64; N] = std::array::from_fn(|i| after[i] - correction[i] / S::GAMMA);
        self.norm(&left, &end.states) > judge::ILLUSION * before
    }

    /// Refuses a state whose correction is lost in rounding: no step is short enough for it.
    fn check_resolution(&self, end: &Beginning<N>, correction: &[f64; N]) -> Result<(), String> {
        if (0..N).any(|i| end.states[i] + correction[i] != end.states[i]) {
            return Ok(());
        }
        let slope = |i: &usize| end.jacobian[*i][*i].abs();
        let state = (0..self.equations.states()).max_by(|a, b| slope(a).total_cmp(&slope(b))).unwrap_or(0);
        Err(format!("the rounding of {} decides on its rate", self.equations.state_name(state)))
    }

    /// Factor by which the next step is longer.
    fn growth(&mut self, length: f64, error: f64, factor: f64) -> f64 {
        if self.step.is_exact() {
            // An attempt that turns out to be too long costs little.
            if factor == GROW { GROW * GROW } else { factor }
        } else {
            factor.min(self.predicted(length, error, factor))
        }
    }

    /// Factor by which the next step is longer if the error goes on to grow as from the step before to this one; see
    /// K. Gustafsson (1994), Control-theoretic techniques for stepsize selection in implicit Runge-Kutta methods, ACM
    /// Transactions on Mathematical Software 20, 496-517, doi:10.1145/198429.198437.
    fn predicted(&mut self, length: f64, error: f64, factor: f64) -> f64 {
        let error = error.max(LEAST_ERROR);
        let (length_before, error_before) = self.last.replace((length, error)).unwrap_or((length, error));
        let growth = change(error / error_before, S::ERROR_ORDER) / SAFETY;
        (factor * growth * length / length_before).max(SHRINK)
    }

    /// A rate jumps so that no step ends right behind the event.
    fn chatters(&self, crossing: Option<Crossing>) -> String {
        let name = crossing.map(|crossing| self.equations.indicator_name(crossing.indicator)).unwrap_or_default();
        format!("{name} chatters: no step ends at its event")
    }

    fn too_short(&self, h: f64) -> String {
        let size = |i: &usize| self.step.error()[*i].abs() / self.scales[*i];
        // Those beyond the states of the equations are padding.
        let worst = (0..self.equations.states()).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(0);
        format!("a step of {h:e} s is still too long for {}", self.equations.state_name(worst))
    }

    fn first_change(&mut self, length: f64) -> Option<Crossing> {
        if !(self.options.events && self.watch.is_needed()) {
            return None;
        }
        let course = self.course();
        let precision = if self.step.is_exact() { self.precision(length) / length } else { PRECISION };
        let piece = Piece { begin: self.begin.time, length, course: &course, precision };
        self.watch.first_change(self.equations, &piece)
    }

    /// Shortens the step that was just made until it ends right behind an event, by regula falsi on the ends of the steps
    /// themselves: those that end before it lie on one branch of the equations. None if no such step can be made.
    fn locate(&mut self, length: f64, crossing: Crossing) -> Option<(f64, usize)> {
        let Crossing { fraction, indicator: mut event, slope } = crossing;
        let precision = self.precision(length);
        let mut bracket = Bracket::new((0.0, self.watch.size(event)), length, precision).with_slope(slope);
        let mut h = fraction * length;
        for trial in 0..MOST_TRIALS {
            self.statistics.rejected += 1;
            if !self.attempt(h) {
                return None;
            }
            let end = *self.step.end();
            match self.watch.changed(self.equations, self.begin.time + h, &end) {
                Some(indicator) if trial == 0 && self.step.is_exact() => return Some((h, indicator)),
                Some(indicator) => {
                    event = indicator;
                    bracket.after(h, self.watch.remaining(indicator));
                }
                None => bracket.before(h, self.watch.remaining(event)),
            }
            if let Some(shortest) = bracket.closed() {
                return self.attempt(shortest).then_some((shortest, event));
            }
            if bracket.is_missed() {
                return None;
            }
            h = bracket.next();
        }
        None
    }

    /// How precisely the time of an event in a step of this length can be told.
    fn precision(&self, length: f64) -> f64 {
        4.0 * f64::EPSILON * (self.begin.time + length).abs()
    }

    fn accept(&mut self, made: &Made) -> Result<(), String> {
        let course = self.course();
        let length = made.end - self.begin.time;
        if self.step.ends_at_results() {
            self.record(made.end, *self.step.end())?;
        } else {
            let piece = Piece { begin: self.begin.time, length, course: &course, precision: PRECISION };
            self.recorder.piece(self.equations, &piece)?;
        }
        self.step.accept(self.equations);
        self.equations.accept(self.begin.time, made.end, &|fraction, states| course.at(fraction, states));
        self.begin.time = made.end;
        self.begin.states = *self.step.end();
        self.statistics.steps += 1;
        match made.event {
            Some(indicator) => self.pass(indicator),
            None if self.equations.is_due(made.end) => self.settle(),
            None => {
                if self.options.events && self.watch.is_needed() {
                    self.watch.go_on();
                }
                match self.ahead.take() {
                    None => self.look(),
                    Some(ahead) => {
                        self.begin = ahead;
                        Ok(())
                    }
                }
            }
        }
    }

    /// Records the states at a time, if it is an output time.
    fn record(&mut self, time: f64, states: [f64; N]) -> Result<(), String> {
        while self.recorder.is_due(time) {
            self.recorder.point(self.equations, &states)?;
        }
        Ok(())
    }

    /// Makes an event.
    fn pass(&mut self, indicator: usize) -> Result<(), String> {
        let name = self.equations.indicator_name(indicator);
        let duration = self.options.end - self.options.begin;
        self.statistics.pass(Event { time: self.begin.time, indicator }, &name, duration)?;
        self.settle()
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Beside the power function.
    #[test]
    fn steps_change_by_a_root_of_the_error() {
        for order in [2, 3, 5] {
            for exponent in -4000..=4000 {
                let error = 10f64.powf(f64::from(exponent) * 2e-3);
                let expected = (SAFETY * error.powf(-1.0 / f64::from(order))).clamp(SHRINK, GROW);
                assert_relative_eq!(change(error, order), expected, max_relative = 1e-3);
            }
        }
        assert_eq!([f64::NAN, f64::INFINITY, 0.0].map(|error| change(error, 5)), [SHRINK, SHRINK, GROW]);
    }
}
