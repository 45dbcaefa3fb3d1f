//! Steps in which bonds snap.
//!
//! The equations are taken for linear over a step, and bonds snap within it at the places where they do: the motion between
//! two snaps is a power series in time, and a snap only lets the rates jump, by what the Jacobian says of the strain. Linear
//! systems are solved exactly, however many bonds snap in a step; others with an error of second order, which the rates at
//! the end of the step tell.
//!
//! ```text
//! x'(t) = f + J (x - x_0) + t df/dt,   between two snaps
//! f    <- f + J_s d                    where a bond snaps: s the strain, d the change of its mean over all bonds
//! ```

use super::recorder::Polynomials;
use super::step::{Beginning, Step};
use super::{Equations, Options, Track};

/// Terms of the power series (chosen).
const TERMS: usize = 5;

/// 1 / k
const RECIPROCALS: [f64; TERMS] = [1.0, 1.0 / 2.0, 1.0 / 3.0, 1.0 / 4.0, 1.0 / 5.0];

/// Size of the last term, in parts of a state's size, up to which a piece is short enough (chosen): what follows is less by
/// the rate of the fastest motion times the length of the piece.
const LAST: f64 = 1e-14;

/// Pieces of a step beyond which the next step is shorter, so that a run can be ended early (chosen).
const MANY: f64 = 1e4;

/// Factor on that beyond which a step is not made to its end (chosen).
const TOO_MANY: f64 = 8.0;

/// Change, in parts of a time, after which Newton's method needs no further pass: its square is below rounding (chosen).
const CLOSE: f64 = 1e-9;

/// Size of the last term of the inverse series, in parts of the time, up to which what follows is not missed (chosen).
const EXACT: f64 = 1e-11;

/// Sum of the displacements by the terms after the first one, in parts of it, up to which a motion goes one way: five times
/// this is less than 1.
const STEADY: f64 = 0.1;

/// Most passes of the search for a snap (chosen): bisection needs less.
const PASSES: u32 = 100;

/// Row by row.
type Matrix<const N: usize> = [[f64; N]; N];

/// A step of the method.
pub(super) struct Snapping<const N: usize> {
    /// The bonds at the beginning of the step.
    before: Vec<Track>,
    begin: [f64; N],
    end: [f64; N],
    /// Rates at both ends, times the length of the step.
    slopes: [[f64; N]; 2],
    error: [f64; N],
    /// Largest last terms.
    least: [f64; N],
    pieces: f64,
    /// Length of a piece at which the series was short enough.
    pace: f64,
}

impl<const N: usize> Default for Snapping<N> {
    fn default() -> Self {
        let zero = [0.0; N];
        Snapping {
            before: Vec::new(),
            begin: zero,
            end: zero,
            slopes: [zero; 2],
            error: zero,
            least: zero,
            pieces: 0.0,
            pace: f64::INFINITY,
        }
    }
}

/// The equations of a step, which are linear.
struct Linear<'a, const N: usize> {
    jacobian: &'a Matrix<N>,
    by_time: &'a [f64; N],
    /// By order of the series from the second one on: what the rates do to the term, J^(k - 1) / k!
    powers: [Matrix<N>; TERMS - 1],
    /// The same of the time, J^(k - 2) df/dt / k!
    drifts: [[f64; N]; TERMS - 1],
}

impl<'a, const N: usize> Linear<'a, N> {
    fn new(jacobian: &'a Matrix<N>, by_time: &'a [f64; N]) -> Self {
        let times = |power: &Matrix<N>, reciprocal: f64| -> Matrix<N> {
            let element = |i: usize, j: usize| (0..N).map(|k| jacobian[i][k] * power[k][j]).sum::<f64>() * reciprocal;
            std::array::from_fn(|i| std::array::from_fn(|j| element(i, j)))
        };
        let (mut powers, mut drifts) = ([*jacobian; TERMS - 1], [*by_time; TERMS - 1]);
        powers[0] = jacobian.map(|row| row.map(|x| x * RECIPROCALS[1]));
        drifts[0] = by_time.map(|x| x * RECIPROCALS[1]);
        for order in 1..TERMS - 1 {
            let reciprocal = RECIPROCALS[order + 1];
            powers[order] = times(&powers[order - 1], reciprocal);
            drifts[order] = std::array::from_fn(|i| product(&jacobian[i], &drifts[order - 1]) * reciprocal);
        }
        Linear { jacobian, by_time, powers, drifts }
    }
}

fn product<const N: usize>(row: &[f64; N], vector: &[f64; N]) -> f64 {
    (0..N).fold(0.0, |sum, j| sum + row[j] * vector[j])
}

/// The motion after a part of a step.
struct Run<'a, const N: usize> {
    states: [f64; N],
    rates: [f64; N],
    linear: &'a Linear<'a, N>,
}

impl<const N: usize> Run<'_, N> {
    /// How the states go on.
    fn paths(&self) -> [Path; N] {
        let mut paths = self.rates.map(|rate| Path([rate; TERMS]));
        for (order, (power, drift)) in self.linear.powers.iter().zip(&self.linear.drifts).enumerate() {
            for i in 0..N {
                paths[i].0[order + 1] = drift[i] + product(&power[i], &self.rates);
            }
        }
        paths
    }

    fn advance(&mut self, paths: &[Path; N], time: f64) {
        let changes = paths.map(|path| path.at(time)[0]);
        for i in 0..N {
            self.states[i] += changes[i];
            self.rates[i] += time * self.linear.by_time[i] + product(&self.linear.jacobian[i], &changes);
        }
    }

    /// The strain of a contact changes by this without a motion.
    fn jump(&mut self, strain: usize, change: f64) {
        for (rate, row) in self.rates.iter_mut().zip(self.linear.jacobian) {
            *rate += row[strain] * change;
        }
    }
}

/// The change of a state as a polynomial in time, c_1 t + c_2 t^2 + ...
#[derive(Clone, Copy)]
struct Path([f64; TERMS]);

/// Course of a displacement within a given time.
enum Reach {
    /// It goes no further than there is room.
    Within,
    /// It leaves the room forwards, or backwards, at a time.
    At(f64, bool),
    /// It turns back, or may do so: a shorter time tells.
    Unclear,
}

impl Path {
    /// Tells whether the motion begins forwards; none if there is no motion.
    fn is_forwards(&self) -> Option<bool> {
        self.0.iter().find(|c| **c != 0.0).map(|c| *c > 0.0)
    }

    /// The change, and its rate.
    fn at(&self, time: f64) -> [f64; 2] {
        let [a, b, c, d, e] = self.0;
        let square = time * time;
        let value = (a + b * time) + square * ((c + d * time) + square * e);
        let slope = (a + 2.0 * b * time) + square * ((3.0 * c + 4.0 * d * time) + square * (5.0 * e));
        [value * time, slope]
    }

    /// Whether it goes one way only, and by how much it moves at most.
    fn bounds(&self, time: f64) -> (bool, f64) {
        let (mut leading, mut others, mut most, mut power) = (0.0, 0.0, 0.0, 1.0);
        for (order, c) in self.0.iter().enumerate() {
            let slope = (order + 1) as f64 * c.abs() * power;
            if leading == 0.0 {
                leading = slope
            } else {
                others += slope
            }
            power *= time;
            most += c.abs() * power;
        }
        (leading >= others, most)
    }

    /// Whether there is enough room, backwards and forwards, for the displacement within a time.
    fn reach(&self, rooms: [f64; 2], time: f64) -> Reach {
        let Some(is_forwards) = self.is_forwards() else { return Reach::Within };
        let (direction, room) = if is_forwards { (1.0, rooms[1]) } else { (-1.0, rooms[0]) };
        if let Some(at) = self.inverse(room) {
            return if at < time { Reach::At(at, is_forwards) } else { Reach::Within };
        }
        let (is_one_way, most) = self.bounds(time);
        if most < rooms[0].min(rooms[1]) {
            return Reach::Within;
        }
        if !is_one_way {
            return Reach::Unclear;
        }
        if direction * self.at(time)[0] < room {
            return Reach::Within;
        }
        Reach::At(self.time_of(room, direction, time), is_forwards)
    }

    /// The time at which a motion that hardly changes has come this far, by the series of the inverse function.
    fn inverse(&self, room: f64) -> Option<f64> {
        let [velocity, second, third, fourth, fifth] = self.0;
        let reciprocal = 1.0 / velocity;
        let first = room * reciprocal.abs();
        let square = first * first;
        let [a, b, c, d] =
            [second * first, third * square, fourth * square * first, fifth * square * square].map(|c| c * reciprocal);
        let last = a * a * (14.0 * a * a - 21.0 * b) + 6.0 * a * c + 3.0 * b * b - d;
        let time = first * (1.0 - a + (2.0 * a * a - b) + (5.0 * a * (b - a * a) - c) + last);
        let is_steady = a.abs() + b.abs() + c.abs() + d.abs() <= STEADY;
        (is_steady && last.abs() <= EXACT).then_some(time)
    }

    /// The time at which a displacement that goes one way has come this far; at most `latest`. By Newton's method within a
    /// bracket.
    fn time_of(&self, room: f64, direction: f64, latest: f64) -> f64 {
        let (mut low, mut high) = (0.0, latest);
        let first = room / self.0[0].abs();
        let mut time = if first < latest { first } else { latest };
        for _ in 0..PASSES {
            let [value, slope] = self.at(time);
            let missing = room - direction * value;
            if missing > 0.0 {
                low = time
            } else {
                high = time
            }
            let next = time + missing / (direction * slope);
            let next = if next >= low && next <= high { next } else { 0.5 * (low + high) };
            let change = (next - time).abs();
            time = next;
            if change <= CLOSE * time {
                break;
            }
        }
        time
    }
}

/// The end of a piece: its length, and the track on which a bond snaps there, forwards or backwards.
type Piece = (f64, Option<(usize, bool)>);

impl<const N: usize> Snapping<N> {
    /// Moves on by one piece, which ends at a snap or is no longer than this.
    fn piece(&mut self, run: &mut Run<N>, tracks: &mut [Track], longest: f64) -> f64 {
        let paths = run.paths();
        for track in tracks.iter_mut().filter(|track| track.bonds.waits()) {
            if let Some(is_forwards) = paths[track.state].is_forwards() {
                run.jump(track.state, track.bonds.begin(is_forwards));
                return 0.0;
            }
        }
        let (length, snap) = self.end_of_piece(&paths, tracks, longest);
        run.advance(&paths, length);
        for (number, Track { state, bonds }) in tracks.iter_mut().enumerate() {
            match snap {
                Some((snapping, is_forwards)) if snapping == number => run.jump(*state, bonds.snap(is_forwards)),
                _ => bonds.advance(paths[*state].at(length)[0]),
            }
        }
        length
    }

    fn end_of_piece(&mut self, paths: &[Path; N], tracks: &[Track], longest: f64) -> Piece {
        let mut length = longest.min(self.pace);
        for track in tracks {
            // Hardly further than to the next snap, so that the displacement goes one way.
            let velocity = paths[track.state].0[0];
            let twice = 2.0 * track.bonds.rooms()[usize::from(velocity > 0.0)];
            if twice > 0.0 && twice < length * velocity.abs() {
                length = twice / velocity.abs();
            }
        }
        loop {
            match self.try_piece(paths, tracks, length) {
                Some(piece) => return piece,
                None if length > 0.0 => length *= 0.5,
                // A number is not finite.
                None => return (f64::NAN, None),
            }
        }
    }

    /// The end of a piece of this length or of a shorter one; none if it is too long.
    fn try_piece(&mut self, paths: &[Path; N], tracks: &[Track], length: f64) -> Option<Piece> {
        let power = (1..TERMS).fold(length, |power, _| power * length);
        let is_short = |i: usize| paths[i].0[TERMS - 1].abs() * power <= self.least[i];
        if !(0..N).all(is_short) {
            self.pace = 0.5 * length;
            return None;
        }
        let mut piece = (length, None);
        for (number, track) in tracks.iter().enumerate() {
            match paths[track.state].reach(track.bonds.rooms(), piece.0) {
                Reach::Within => {}
                Reach::At(time, is_forwards) => piece = (time, Some((number, is_forwards))),
                Reach::Unclear => return None,
            }
        }
        self.pace = self.pace.max(2.0 * length);
        Some(piece)
    }

    /// Goes through a step. False if it has too many pieces.
    fn go(&mut self, run: &mut Run<N>, tracks: &mut [Track], h: f64) -> bool {
        let mut left = h;
        self.pieces = 0.0;
        while left > 0.0 {
            left -= self.piece(run, tracks, left);
            self.pieces += 1.0;
            if self.pieces > TOO_MANY * MANY || left.is_nan() {
                return false;
            }
        }
        true
    }
}

impl<const N: usize> Step<N> for Snapping<N> {
    type Course = Polynomials<N>;
    const ERROR_ORDER: i32 = 3;
    const GAMMA: f64 = 0.5;
    const DEFECT: f64 = 1.0;

    fn begin(&mut self, equations: &mut dyn Equations, _options: &Options) {
        self.least = std::array::from_fn(|i| LAST * equations.scales()[i]);
        self.accept(equations);
    }

    fn accept(&mut self, equations: &mut dyn Equations) {
        self.before.clear();
        self.before.extend_from_slice(equations.tracks());
    }

    fn attempt(&mut self, equations: &mut dyn Equations, begin: &Beginning<N>, h: f64) -> bool {
        let Beginning { time, states, rates, jacobian, by_time } = begin;
        let tracks = equations.tracks();
        tracks.copy_from_slice(&self.before);
        let mut run = Run { states: *states, rates: *rates, linear: &Linear::new(jacobian, by_time) };
        if !self.go(&mut run, tracks, h) {
            return false;
        }
        for track in &*tracks {
            run.states[track.state] = track.bonds.first();
        }
        let mut found = [0.0; N];
        equations.rates(time + h, &run.states, &mut found);
        equations.renew_tracks();
        (self.begin, self.end) = (*states, run.states);
        self.slopes = [*rates, run.rates].map(|rates| rates.map(|rate| rate * h));
        // The difference between the rates grows with the square of the time.
        self.error = std::array::from_fn(|i| (found[i] - run.rates[i]) * h / 3.0);
        self.end.iter().all(|x| x.is_finite())
    }

    fn evaluations(&self) -> u64 {
        1
    }

    fn ends_at_results(&self) -> bool {
        true
    }

    fn end(&self) -> &[f64; N] {
        &self.end
    }

    fn error(&self) -> &[f64; N] {
        &self.error
    }

    fn excess(&self, norm: impl Fn(&[f64; N], &[f64; N]) -> f64) -> f64 {
        let effort = self.pieces / MANY;
        norm(&self.error, &self.end).max(effort * effort * effort / (TOO_MANY * TOO_MANY * TOO_MANY))
    }

    /// The cubic polynomials with the states and rates at both ends: where events are looked for first.
    fn course(&self, _begin: &Beginning<N>) -> Polynomials<N> {
        std::array::from_fn(|i| {
            let (change, [first, last]) = (self.end[i] - self.begin[i], self.slopes.map(|slope| slope[i]));
            [self.begin[i], first, 3.0 * change - 2.0 * first - last, first + last - 2.0 * change, 0.0]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Displacements with drawn coefficients, looked at in 20,000 places.
    #[test]
    fn a_displacement_leaves_its_room_where_it_first_reaches_the_end() {
        let mut random = fastrand::Rng::with_seed(5);
        let mut counts = [0; 3];
        for _ in 0..500 {
            let mut draw = |size: f64| size * (2.0 * random.f64() - 1.0);
            let path = Path([draw(1.0), draw(1.0), draw(0.3), draw(0.1), draw(0.03)]);
            let [time, rooms] = [[draw(1.0).abs(); 2], [draw(0.5).abs(), draw(0.5).abs()]];
            let value = |t: f64| path.0.iter().enumerate().map(|(k, c)| c * t.powi(k as i32 + 1)).sum::<f64>();
            let is_out = |t: &f64| value(*t) >= rooms[1] || value(*t) <= -rooms[0];
            let first = (0..=20_000).map(|place| time[0] * f64::from(place) / 20_000.0).find(is_out);
            match path.reach(rooms, time[0]) {
                Reach::Within => assert_eq!(first, None, "{:?}", path.0),
                Reach::At(at, is_forwards) => {
                    let (expected, end) = (first.unwrap(), if is_forwards { rooms[1] } else { -rooms[0] });
                    assert!((at - expected).abs() < 1e-4 && (value(at) - end).abs() < 1e-12, "{at} {expected}");
                }
                Reach::Unclear => assert!(path.at(0.0)[1] != 0.0),
            }
            counts[usize::from(first.is_some())] += 1;
            let clear = |time: f64| !matches!(path.reach(rooms, time), Reach::Unclear);
            counts[2] += usize::from(clear(time[0]));
            assert!(clear(1e-3 * path.0[0].abs()), "{:?}", path.0);
        }
        assert!(counts.iter().all(|count| *count > 100), "{counts:?}");
    }

    /// The displacement is the room there to twelve digits, and the motion goes one way until then.
    #[test]
    fn the_series_of_the_inverse_ends_where_nothing_is_missing() {
        let mut random = fastrand::Rng::with_seed(6);
        let mut count = 0;
        for _ in 0..500 {
            let mut draw = |size: f64| size * (2.0 * random.f64() - 1.0);
            let path = Path([draw(1.0), draw(1.0), draw(1.0), draw(1.0), draw(1.0)]);
            let room = draw(1e-3).abs();
            let Some(time) = path.inverse(room) else { continue };
            assert!((path.at(time)[0].abs() / room - 1.0).abs() < 1e-12, "{:?} {room}", path.0);
            assert!((0..=100).all(|k| path.at(time * f64::from(k) / 100.0)[1] * path.0[0] > 0.0), "{:?}", path.0);
            count += 1;
        }
        assert!((100..490).contains(&count), "{count}");
    }

    /// x'' = -w^2 x from x = 1, in pieces as long as the series is short enough.
    #[test]
    fn a_run_without_snaps_is_an_oscillation() {
        let omega = 7.0f64;
        let jacobian = [[0.0, 1.0], [-omega * omega, 0.0]];
        let rates = [0.0, -omega * omega];
        let mut run = Run { states: [1.0, 0.0], rates, linear: &Linear::new(&jacobian, &[0.0; 2]) };
        let mut step = Snapping { least: [LAST, omega * LAST], ..Snapping::default() };
        assert!(step.go(&mut run, &mut [], 2.0));
        assert!((run.states[0] - (2.0 * omega).cos()).abs() < 1e-11, "{:?}", run.states);
        assert!((run.states[1] + omega * (2.0 * omega).sin()).abs() < 1e-10, "{:?}", run.states);
        assert!((run.rates[1] + omega * omega * run.states[0]).abs() < 1e-9 && step.pieces > 100.0);
    }
}
