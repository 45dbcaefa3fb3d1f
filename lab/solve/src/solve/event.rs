//! Location of events within a step.

use super::Equations;
use super::recorder::Piece;

/// Fractions of a step at which the indicators are looked at (chosen): a body that comes to rest and is driven back
/// within one step crosses zero twice.
const LOOKS: [f64; 4] = [0.25, 0.5, 0.75, 1.0];

/// Part of an indicator's size below which its least value between looks is looked at (chosen): it may touch zero there
/// and turn back.
const NEAR: f64 = 0.1;

/// Part of the greatest of three values above which the least of them has to be for that to be impossible, (3 NEAR + 1) / 4
/// and a little more.
const FAR: f64 = 0.35;

/// Looks at such a value, each where a parabola through those around it says (chosen).
const CLOSER: usize = 2;

/// Part of a step after which an indicator that begins at zero has a sign (chosen).
const EARLY: f64 = 1e-6;

/// Part of a distance to an event by which it is passed, so that it lies between the last two steps (chosen).
const BEYOND: f64 = 1.01;

/// The indicators at the beginning of a step, and workspace.
pub(super) struct Watch {
    pub at_beginning: Vec<f64>,
    now: Vec<f64>,
    /// The indicators at the last three looks.
    recent: Vec<[f64; 3]>,
    states: Vec<f64>,
}

/// Whether an indicator has changed its sign. One that begins at zero has none yet.
fn changes(before: f64, now: f64) -> bool {
    before > 0.0 && now <= 0.0 || before < 0.0 && now >= 0.0
}

/// Whether a parabola through three values is not near zero between them either: it is at least a third of four times
/// the least of them less the greatest.
fn is_far([a, b, c]: [f64; 3]) -> bool {
    a.min(b).min(c) > FAR * a.max(c)
}

/// Where the parabola through three positive values is least, if that is between them and near zero.
fn least([a, b, c]: [f64; 3], [at_a, at_b, at_c]: [f64; 3]) -> Option<f64> {
    let [first, second] = [(at_b - at_a) / (b - a), (at_c - at_b) / (c - b)];
    let curvature = (second - first) / (c - a);
    let place = 0.5 * (a + b - first / curvature);
    let value = at_a + (place - a) * (first + curvature * (place - b));
    let is_near = at_a.min(at_b).min(at_c) > 0.0 && curvature > 0.0 && value < NEAR * at_a.max(at_c);
    (is_near && place > a && place < c && place != b).then_some(place)
}

impl Watch {
    /// For steps with this number of states.
    pub fn new(equations: &dyn Equations, states: usize) -> Watch {
        let indicators = vec![0.0; equations.indicators()];
        let recent = vec![[0.0; 3]; indicators.len()];
        Watch { at_beginning: indicators.clone(), now: indicators, recent, states: vec![0.0; states] }
    }

    /// Whether there is anything to watch.
    pub fn is_needed(&self) -> bool {
        !self.now.is_empty()
    }

    /// Takes the indicators as those at the beginning of a step.
    pub fn begin(&mut self, equations: &mut dyn Equations, time: f64, states: &[f64]) {
        equations.indicate(time, states, &mut self.at_beginning);
    }

    /// Takes the indicators at the end of a step without an event as those at the beginning of the next one.
    pub fn go_on(&mut self) {
        self.at_beginning.iter_mut().zip(&self.recent).for_each(|(beginning, recent)| *beginning = recent[2]);
    }

    /// The first indicator that has changed its sign at a state.
    pub fn changed(&mut self, equations: &mut dyn Equations, time: f64, states: &[f64]) -> Option<usize> {
        equations.indicate(time, states, &mut self.now);
        (0..self.now.len()).find(|i| changes(self.at_beginning[*i], self.now[*i]))
    }

    /// Value of an indicator at the last look, in the direction in which it began positive.
    pub fn remaining(&self, indicator: usize) -> f64 {
        self.now[indicator] * self.at_beginning[indicator].signum()
    }

    /// Size of an indicator at the beginning of the step.
    pub fn size(&self, indicator: usize) -> f64 {
        self.at_beginning[indicator].abs()
    }

    fn changed_within(&mut self, equations: &mut dyn Equations, piece: &Piece, fraction: f64) -> Option<usize> {
        let mut states = std::mem::take(&mut self.states);
        piece.course.at(fraction, &mut states);
        let changed = self.changed(equations, piece.begin + fraction * piece.length, &states);
        self.states = states;
        changed
    }

    /// Where the first indicator changes its sign, by the polynomials of the step.
    pub fn first_change(&mut self, equations: &mut dyn Equations, piece: &Piece) -> Option<Crossing> {
        if self.is_calm(equations, piece) {
            return None;
        }
        let mut places = [f64::NAN, f64::NAN, 0.0];
        self.look_back();
        // An indicator that begins at zero shows its sign at once.
        let early = self.at_beginning.contains(&0.0).then_some(EARLY);
        for look in early.into_iter().chain(LOOKS) {
            if let Some(indicator) = self.changed_within(equations, piece, look) {
                return Some(self.narrow(equations, piece, [places[2], look], indicator));
            }
            for (beginning, now) in self.at_beginning.iter_mut().zip(&self.now) {
                if *beginning == 0.0 {
                    *beginning = *now;
                }
            }
            places = [places[1], places[2], look];
            self.keep();
            for indicator in 0..self.recent.len() {
                let crossing = self.touch(equations, piece, places, indicator);
                if crossing.is_some() {
                    return crossing;
                }
            }
        }
        None
    }

    /// Whether no indicator comes near zero in the middle of a step and at its end.
    fn is_calm(&mut self, equations: &mut dyn Equations, piece: &Piece) -> bool {
        self.look_back();
        for look in [0.5, 1.0] {
            if self.changed_within(equations, piece, look).is_some() {
                return false;
            }
            self.keep();
        }
        self.recent.iter().all(|recent| is_far(recent.map(f64::abs)))
    }

    /// Takes the beginning of the step as the last look.
    fn look_back(&mut self) {
        self.recent.iter_mut().zip(&self.at_beginning).for_each(|(recent, beginning)| recent[2] = *beginning);
    }

    /// Keeps the indicators of the last look.
    fn keep(&mut self) {
        for (recent, now) in self.recent.iter_mut().zip(&self.now) {
            *recent = [recent[1], recent[2], *now];
        }
    }

    /// Whether an indicator that comes near zero between the last three looks and turns back reaches it.
    fn touch(
        &mut self,
        equations: &mut dyn Equations,
        piece: &Piece,
        mut places: [f64; 3],
        indicator: usize,
    ) -> Option<Crossing> {
        let direction = self.at_beginning[indicator].signum();
        let mut values = self.recent[indicator].map(|value| value * direction);
        if is_far(values) {
            return None;
        }
        for _ in 0..CLOSER {
            let place = least(places, values)?;
            let before = if place > places[1] { places[1] } else { places[0] };
            if let Some(changed) = self.changed_within(equations, piece, place) {
                return Some(self.narrow(equations, piece, [before, place], changed));
            }
            let value = self.remaining(indicator);
            (places, values) = if place > places[1] {
                ([places[1], place, places[2]], [values[1], value, values[2]])
            } else {
                ([places[0], place, places[1]], [values[0], value, values[1]])
            };
        }
        None
    }

    /// Narrows an interval at whose end an indicator has changed its sign.
    fn narrow(
        &mut self,
        equations: &mut dyn Equations,
        piece: &Piece,
        [low, high]: [f64; 2],
        mut indicator: usize,
    ) -> Crossing {
        let after = self.remaining(indicator);
        self.changed_within(equations, piece, low);
        let mut bracket = Bracket::new((low, self.remaining(indicator)), high, piece.precision);
        bracket.after(high, after);
        while bracket.closed().is_none() {
            let middle = bracket.next();
            match self.changed_within(equations, piece, middle) {
                Some(changed) => {
                    indicator = changed;
                    bracket.after(middle, self.remaining(changed));
                }
                None => bracket.before(middle, self.remaining(indicator)),
            }
        }
        Crossing { fraction: bracket.closed().unwrap_or(high), indicator, slope: bracket.secant() / piece.length }
    }
}

/// A change of sign of an indicator, by the polynomials of a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    /// Fraction of the step at which it has just happened.
    pub fraction: f64,
    /// Number of the indicator.
    pub indicator: usize,
    /// Rate of the indicator there, in the direction in which it began positive.
    pub slope: f64,
}

/// Lengths of steps that end before and after an event, with the indicator there.
pub(super) struct Bracket {
    low: (f64, f64),
    high: Option<(f64, f64)>,
    /// Rate of the indicator near the event, until two steps have ended there.
    slope: Option<f64>,
    /// Distance to look ahead without a slope: the polynomial is not exact, and the event may be anywhere or nowhere.
    ahead: f64,
    longest: f64,
    precision: f64,
    /// Side that was moved last, for the Illinois rule.
    moved_low: Option<bool>,
}

impl Bracket {
    /// A step of a length that ends before the event has this value; the longest has none yet.
    pub fn new(low: (f64, f64), longest: f64, precision: f64) -> Bracket {
        Bracket { low, high: None, slope: None, ahead: 1e-3 * longest, longest, precision, moved_low: None }
    }

    /// The indicator is known to change at this rate near the event.
    pub fn with_slope(self, slope: f64) -> Bracket {
        Bracket { slope: Some(slope).filter(|slope| *slope < 0.0), ..self }
    }

    /// A step of length `h` ends before the event.
    pub fn before(&mut self, h: f64, remaining: f64) {
        if self.high.is_none() && self.slope.is_none() {
            self.slope = Some((remaining - self.low.1) / (h - self.low.0)).filter(|slope| *slope < 0.0);
        }
        self.low = (h, remaining);
        if let (Some(true), Some((_, value))) = (self.moved_low, &mut self.high) {
            *value *= 0.5;
        }
        self.moved_low = Some(true);
    }

    /// A step of length `h` ends after the event, or at it.
    pub fn after(&mut self, h: f64, remaining: f64) {
        self.high = Some((h, remaining));
        if self.moved_low == Some(false) {
            self.low.1 *= 0.5;
        }
        self.moved_low = Some(false);
    }

    /// The shortest step that ends after the event, once it is as short as it can be.
    pub fn closed(&self) -> Option<f64> {
        self.high.map(|(high, _)| high).filter(|high| high - self.low.0 <= self.precision)
    }

    /// Whether not even the longest step ends after the event.
    pub fn is_missed(&self) -> bool {
        self.high.is_none() && self.low.0 >= self.longest
    }

    /// Rate of the indicator between both.
    pub fn secant(&self) -> f64 {
        let (low, at_low) = self.low;
        self.high.map_or(f64::NAN, |(high, at_high)| (at_high - at_low) / (high - low))
    }

    /// The length to try next.
    pub fn next(&mut self) -> f64 {
        let (low, at_low) = self.low;
        let near = 0.5 * self.precision;
        let Some((high, at_high)) = self.high else {
            // Not there yet: as far as the slope says and a little further, then further and further.
            let ahead = match self.slope.take() {
                Some(slope) => (BEYOND * at_low / -slope).max(self.precision),
                None => self.ahead,
            };
            self.ahead = 2.0 * self.ahead.max(ahead);
            return (low + ahead).min(self.longest);
        };
        let falsi = match self.slope.take() {
            // No step has ended near the event on the other side.
            Some(slope) => high - BEYOND * at_high / slope,
            None => low + (high - low) * at_low / (at_low - at_high),
        };
        // Close to one end, as far from it as the bracket is to be wide in the end.
        let h = if falsi < low + near {
            low + self.precision
        } else if falsi > high - near {
            high - self.precision
        } else {
            falsi
        };
        if h > low + 0.1 * near && h < high - 0.1 * near { h } else { 0.5 * (low + high) }
    }
}
