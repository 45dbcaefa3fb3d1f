//! The past of a velocity, in a bounded number of columns, for laws whose force follows the motion with a delay.
//!
//! The past is a sequence of pieces in which the velocity moves linearly; between pieces it may jump, as a held input
//! does. Nothing is lost as long as the delay holds up to [`PIECES`] steps with different velocities: a velocity that
//! stays the same takes one piece, however many steps it lasts.
//!
//! If there are more, the two neighbours with the shortest joint duration become one piece, a straight line from the
//! beginning of the older to the end of the younger. The past then still spans the whole delay, whatever the step: 62
//! pairs share less than twice the delay, so no piece made this way is longer than 1/31 of it. Such a line differs from
//! a velocity with the second derivative c by at most c (delay / 31)^2 / 8, and from a sampled one additionally by the
//! change over one step. A jump becomes a ramp of that duration.

use crate::contact::motion::Motion;
use crate::model::{Fault, Meaning, real};
use crate::number::Real;

/// Number of pieces (chosen).
const PIECES: usize = 64;

/// A delay that misses the beginning of a piece by less than this, relative to the delay, counts as reaching it
/// (chosen): the rounding errors of accumulated communication steps are far below, and the jump of a held input must
/// not depend on them.
const SLACK: f64 = 1e-9;

crate::part! {
    /// A piece of the past in which the velocity moved linearly.
    Piece {
        /// Duration of this piece of the past; 0 = not used.
        duration: state = real("s", 0.0).at_least(0.0).nominal(1e-3).shown_in("ms").means(Meaning::History),
        /// Velocity at the beginning of this piece of the past.
        begin: state = real("m/s", 0.0).shown_in("mm/s").odd().means(Meaning::History),
        /// Velocity at the end of this piece of the past.
        end: state = real("m/s", 0.0).shown_in("mm/s").odd().means(Meaning::History),
    }
}

impl<T: Real> Piece<T> {
    fn unused() -> Piece<T> {
        Piece { duration: T::zero(), begin: T::zero(), end: T::zero() }
    }
}

impl Piece {
    /// A constant velocity.
    pub(crate) fn held(duration: f64, velocity: f64) -> Piece {
        Piece { duration, begin: velocity, end: velocity }
    }

    /// The velocity of a motion.
    pub(crate) fn of(motion: &Motion) -> Piece {
        Piece { duration: motion.duration, begin: motion.velocity, end: motion.velocity_at(motion.duration) }
    }

    /// Whether the velocity is constant.
    pub(crate) fn is_constant(&self) -> bool {
        self.begin == self.end
    }

    /// Velocity at a time after its beginning; outside, the velocity of the nearer end.
    pub(crate) fn at(&self, time: f64) -> f64 {
        let share = time / self.duration;
        if share >= 1.0 {
            self.end
        } else if share > 0.0 {
            self.begin + (self.end - self.begin) * share
        } else {
            self.begin
        }
    }

    /// The line over a part of its duration.
    fn part(&self, from: f64, to: f64) -> Piece {
        Piece { duration: to - from, begin: self.at(from), end: self.at(to) }
    }
}

crate::part! {
    /// The past of the velocity.
    DelayLine {
        /// Pieces of the past, the latest first.
        history: [Piece; PIECES],
    }
}

impl<T: Real> DelayLine<T> {
    /// Forgets everything.
    pub(crate) fn clear(&mut self) {
        self.history.fill(Piece::unused());
    }
}

impl DelayLine {
    /// Whether nothing has been added yet.
    pub(crate) fn is_empty(&self) -> bool {
        self.history[0].duration == 0.0
    }

    /// Refuses a past that steps have left: a solver with rates begins with none.
    pub(crate) fn check_model_exchange(&self) -> Result<(), Fault> {
        if self.is_empty() {
            return Ok(());
        }
        let text = "for solvers that integrate rates, because they keep the past themselves";
        Err(Fault::new(format_args!("history[1].duration = {}: must be 0 {text}", self.history[0].duration)))
    }

    /// Adds the latest motion. The past older than `delay` is forgotten.
    pub(crate) fn push(&mut self, piece: Piece, delay: f64) {
        if self.goes_on_with(piece) {
            self.history[0].duration += piece.duration;
            self.forget(delay);
            return;
        }
        let kept = self.forget(delay - piece.duration);
        if self.history[PIECES - 1].duration > 0.0 {
            self.thin();
        }
        self.history.copy_within(..kept.min(PIECES - 1), 1);
        self.history[0] = piece;
    }

    /// Whether the latest piece continues.
    fn goes_on_with(&self, piece: Piece) -> bool {
        let latest = self.history[0];
        latest.duration > 0.0 && latest.is_constant() && piece.is_constant() && latest.begin == piece.begin
    }

    /// Forgets the pieces that ended at least `age` ago. Returns the number of the others, which are the first ones.
    fn forget(&mut self, age: f64) -> usize {
        let mut since = 0.0;
        let is_old = |piece: &Piece| {
            let is_old = since >= age;
            since += piece.duration;
            is_old
        };
        let kept = self.history.iter().position(is_old).unwrap_or(PIECES);
        self.history[kept..].fill(Piece::unused());
        kept
    }

    /// Joins the two neighbours with the shortest joint duration; of equals, the oldest.
    fn thin(&mut self) {
        let sum = |k: &usize| self.history[*k].duration + self.history[k + 1].duration;
        let least = (0..PIECES - 1).rev().min_by(|a, b| sum(a).total_cmp(&sum(b))).unwrap_or(0);
        let [younger, older] = [self.history[least], self.history[least + 1]];
        let duration = older.duration + younger.duration;
        self.history[least] = Piece { duration, begin: older.begin, end: younger.end };
        self.history.copy_within(least + 2.., least + 1);
        self.history[PIECES - 1] = Piece::unused();
    }

    /// Pieces from the latest to the oldest, each with the time since it ended.
    fn pieces(&self) -> impl Iterator<Item = (f64, Piece)> {
        let used = self.history.iter().take_while(|piece| piece.duration > 0.0);
        used.scan(0.0, |since, piece| {
            let ended = *since;
            *since += piece.duration;
            Some((ended, *piece))
        })
    }

    /// The piece in which an instant `delay` > 0 ago lies, and the time since its beginning; at a jump the later one.
    fn find(&self, delay: f64) -> Option<(Piece, f64)> {
        let mut found = None;
        for (ended, piece) in self.pieces() {
            let began = ended + piece.duration;
            found = Some((piece, began - delay));
            if delay <= began * (1.0 + SLACK) {
                break;
            }
        }
        found
    }

    /// Velocity at an instant `delay` > 0 ago: before the known past its first value, without a past 0.
    pub(crate) fn velocity(&self, delay: f64) -> f64 {
        self.find(delay).map_or(0.0, |(piece, time)| piece.at(time))
    }

    /// Slope of the velocity at an instant `delay` > 0 ago.
    pub(crate) fn slope(&self, delay: f64) -> f64 {
        let within = self.find(delay).filter(|(_, time)| *time >= -SLACK * delay);
        within.map_or(0.0, |(piece, _)| (piece.end - piece.begin) / piece.duration)
    }

    /// The delayed velocity during a step with the motion `present`: each of its pieces, with the time in the step at
    /// which it begins. Time before the known past has the first known value.
    pub(crate) fn delayed(&self, present: Piece, delay: f64, mut visit: impl FnMut(f64, Piece)) {
        let end = present.duration;
        if delay < end {
            visit(delay, present.part(0.0, end - delay));
        }
        let mut first = (delay.min(end), 0.0);
        for (ended, piece) in self.pieces() {
            let (from, to) = (delay - ended - piece.duration, (delay - ended).min(end));
            if to <= 0.0 {
                return;
            }
            if to > from.max(0.0) {
                visit(from.max(0.0), piece.part((-from).max(0.0), to - from));
            }
            first = (from.min(end), piece.begin);
        }
        if first.0 > 0.0 {
            visit(0.0, Piece { duration: first.0, begin: first.1, end: first.1 });
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    const DELAY: f64 = 5e-3;

    fn line() -> DelayLine {
        DelayLine { history: [Piece::unused(); PIECES] }
    }

    fn held(duration: f64, velocity: f64) -> Piece {
        Piece::held(duration, velocity)
    }

    fn used(line: &DelayLine) -> usize {
        line.pieces().count()
    }

    /// Five steps of 1 ms in a master with rounding errors: the value is that of the step that began 5 ms ago.
    #[test]
    fn a_jump_is_met_in_spite_of_rounding() {
        for h in [1e-3, 9.999999999998899e-4, 1.000_000_000_000_1e-3] {
            let mut line = line();
            for k in 1..=20 {
                line.push(held(h, f64::from(k)), DELAY);
                let expected = f64::from((k - 4).max(1));
                assert_eq!(line.velocity(DELAY), expected, "{h} after step {k}");
            }
            assert!(used(&line) <= 7, "{}", used(&line));
        }
    }

    #[test]
    fn ramps_are_interpolated_and_have_slopes() {
        let mut line = line();
        line.push(Piece { duration: 4e-3, begin: 0.0, end: 8.0 }, DELAY);
        line.push(held(3e-3, 8.0), DELAY);
        assert_abs_diff_eq!(line.velocity(DELAY), 4.0, epsilon = 1e-12);
        assert_abs_diff_eq!(line.slope(DELAY), 2000.0, epsilon = 1e-9);
        assert_eq!((line.velocity(1e-3), line.slope(1e-3)), (8.0, 0.0));
    }

    #[test]
    fn before_the_known_past_the_first_value_counts() {
        let mut line = line();
        assert_eq!(line.velocity(DELAY), 0.0);
        line.push(held(1e-3, 3.0), DELAY);
        assert_eq!((line.velocity(DELAY), line.slope(DELAY)), (3.0, 0.0));
    }

    /// A constant velocity takes one piece; 64 different ones take 64; none of them is changed.
    #[test]
    fn up_to_64_different_velocities_are_kept_exactly() {
        let mut line = line();
        for _ in 0..10_000 {
            line.push(held(1e-6, 7.0), DELAY);
        }
        assert_eq!(used(&line), 1);
        for k in 0..63 {
            line.push(held(1e-6, f64::from(k)), DELAY);
        }
        assert_eq!(used(&line), PIECES);
        for k in 0..63 {
            assert_eq!(line.velocity((63.0 - f64::from(k) - 0.5) * 1e-6), f64::from(k));
        }
    }

    /// 5000 samples in the delay: the past always spans it, no piece is longer than 1/31 of it, and the error is within
    /// the stated bound. (The stated order is tested with a coarser curve in the next test.)
    #[test]
    fn many_samples_are_thinned_within_the_stated_error() {
        let (h, w) = (1e-6, 500.0);
        let mut line = line();
        let mut worst: f64 = 0.0;
        for k in 0..40_000 {
            let time = f64::from(k) * h;
            line.push(held(h, (w * time).sin()), DELAY);
            assert!(used(&line) <= PIECES);
            if time > 2.0 * DELAY {
                let span: f64 = line.pieces().map(|(_, piece)| piece.duration).sum();
                assert!(span >= DELAY * (1.0 - 1e-12), "{span}");
                let longest = line.pieces().map(|(_, piece)| piece.duration).fold(0.0, f64::max);
                assert!(longest <= DELAY / 31.0 * (1.0 + 1e-9), "{longest}");
                let exact = (w * (time + h - DELAY)).sin();
                worst = worst.max((line.velocity(DELAY) - exact).abs());
            }
        }
        let bound = w * w * (DELAY / 31.0).powi(2) / 8.0 + w * h;
        assert!(worst <= bound, "{worst} against {bound}");
        assert!(worst > 0.05 * bound, "the bound {bound} is too wide for {worst}");
    }

    /// Lines that join without a jump and without a kink are kept exactly, whatever is thinned.
    #[test]
    fn thinning_leaves_a_straight_line_straight() {
        let mut line = line();
        for k in 0..9000 {
            let [begin, end] = [k, k + 1].map(|k| 2.0 * f64::from(k) * 1e-6);
            line.push(Piece { duration: 1e-6, begin, end }, DELAY);
        }
        assert!(used(&line) > 32);
        for delay in [1e-7, 3.3e-4, 1.7e-3, DELAY] {
            assert_abs_diff_eq!(line.velocity(delay), 2.0 * (9e-3 - delay), epsilon = 1e-13);
        }
    }

    /// The delayed pieces of a step fill it without gap or overlap, and their integral is that of the delayed velocity.
    #[test]
    fn delayed_pieces_fill_the_step() {
        let mut line = line();
        for (duration, begin, end) in [(2e-3, 1.0, 1.0), (1e-3, 1.0, 3.0), (1e-3, -2.0, -2.0)] {
            line.push(Piece { duration, begin, end }, DELAY);
        }
        // In the delay of 5 ms: 1 ms before the known past (1), 2 ms of 1, 1 ms of a ramp (2), 1 ms of -2; then 10.
        for (end, expected) in [(5e-4, 5e-4), (1e-3, 1e-3), (3.5e-3, 3.75e-3), (5e-3, 3e-3), (7e-3, 2.3e-2)] {
            let (mut filled, mut integral) = (0.0, 0.0);
            line.delayed(held(end, 10.0), DELAY, |from, piece| {
                assert!(from >= 0.0 && from + piece.duration <= end + 1e-18);
                filled += piece.duration;
                integral += 0.5 * (piece.begin + piece.end) * piece.duration;
            });
            assert!((filled - end).abs() < 1e-17, "{end}: {filled}");
            assert!((integral - expected).abs() < 1e-16, "{end}: {integral} against {expected}");
        }
    }
}
