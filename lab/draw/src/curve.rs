//! Curves with no more points than a picture can show.

use std::collections::HashMap;
use std::fmt::Write;

/// A point of the drawing.
pub type Point = [f64; 2];

/// Width of a column of the drawing: an eighth of a millimetre. Of each passage of a curve through a column the first,
/// lowest, highest and last point are kept, so no spike is lost.
const COLUMN: f64 = 0.5;
/// Distance from the line through others at which a point is left out: five micrometres.
const UNSEEN: f64 = 0.02;
/// Half the length of the line that is drawn for a point on its own.
const DOT: f64 = 0.9;
/// Size of the cells in which a curve that comes back to where it was is not drawn again, distance of the samples along
/// it, and length of the curve after which a return counts as one. The line is three cells thick.
const CELL: f64 = 0.6;
const SAMPLE: f64 = 0.4;
const RETURN: f64 = 6.0;

/// A curve over time.
pub fn over_time(points: impl Iterator<Item = Point>) -> String {
    data(&envelope(points))
}

/// A curve that may go round many times. Where it runs along itself it is drawn once, so that its dashes stay dashes.
pub fn going_round(points: impl Iterator<Item = Point>) -> String {
    data(&unrepeated(&envelope(points)))
}

/// The data of an SVG path. It is broken where a point is not finite.
fn data(pieces: &[Vec<Point>]) -> String {
    let mut data = String::new();
    for piece in pieces {
        // Writing to a String cannot fail.
        if let [[x, y]] = piece.as_slice() {
            let _ = write!(data, "M{:.2} {y:.2}L{:.2} {y:.2}", x - DOT, x + DOT);
            continue;
        }
        for (number, [x, y]) in thinned(piece).into_iter().enumerate() {
            let letter = if number == 0 { 'M' } else { 'L' };
            let _ = write!(data, "{letter}{x:.2} {y:.2}");
        }
    }
    data
}

/// The pieces of a curve, with at most four points for each passage through a column.
fn envelope(points: impl Iterator<Item = Point>) -> Vec<Vec<Point>> {
    let points: Vec<Point> = points.collect();
    let pieces = points.split(|[x, y]| !(x.is_finite() && y.is_finite())).filter(|piece| !piece.is_empty());
    let column = |point: &Point| (point[0] / COLUMN).floor() as i64;
    pieces.map(|piece| piece.chunk_by(|a, b| column(a) == column(b)).flat_map(extremes).collect()).collect()
}

/// The first, lowest, highest and last point of a passage, in their order.
fn extremes(passage: &[Point]) -> Vec<Point> {
    let up = |a: &usize, b: &usize| passage[*a][1].total_cmp(&passage[*b][1]);
    let numbers = || 0..passage.len();
    let (low, high) = (numbers().min_by(up), numbers().min_by(|a, b| up(b, a)));
    let mut kept: Vec<usize> = [numbers().next(), low, high, numbers().last()].into_iter().flatten().collect();
    kept.sort_unstable();
    kept.dedup();
    kept.into_iter().map(|number| passage[number]).collect()
}

/// Leaves out lines along which the curve has been before.
fn unrepeated(pieces: &[Vec<Point>]) -> Vec<Vec<Point>> {
    let mut trail = Trail { visits: HashMap::new(), length: 0.0 };
    let mut kept: Vec<Vec<Point>> = Vec::new();
    for piece in pieces {
        let mut is_open = false;
        for pair in piece.windows(2) {
            let is_new = trail.goes_on(pair[0], pair[1]);
            match kept.last_mut() {
                Some(last) if is_new && is_open => last.push(pair[1]),
                _ if is_new => kept.push(pair.to_vec()),
                _ => {}
            }
            is_open = is_new;
        }
        if piece.len() == 1 {
            kept.push(piece.clone());
        }
    }
    kept
}

/// Where a curve has been: cells with its length at the first visit.
struct Trail {
    visits: HashMap<(i64, i64), f64>,
    length: f64,
}

impl Trail {
    /// Follows a straight line; whether a part of it is new.
    fn goes_on(&mut self, from: Point, to: Point) -> bool {
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        let samples = (length / SAMPLE).ceil().max(1.0);
        let mut is_new = false;
        for sample in 1..=samples as usize {
            let share = sample as f64 / samples;
            let [x, y] = [0, 1].map(|axis| ((from[axis] + share * (to[axis] - from[axis])) / CELL).round() as i64);
            let now = self.length + share * length;
            let around = (-1..=1).flat_map(|right| (-1..=1).map(move |up| (x + right, y + up)));
            let mut visits = around.filter_map(|cell| self.visits.get(&cell));
            is_new |= !visits.any(|visit| now - visit > RETURN);
            self.visits.entry((x, y)).or_insert(now);
        }
        self.length += length;
        is_new
    }
}

/// Leaves out points that make no visible difference, by the method of Ramer, Douglas and Peucker.
fn thinned(points: &[Point]) -> Vec<Point> {
    let mut kept = vec![false; points.len()];
    let mut spans: Vec<(usize, usize)> = points.len().checked_sub(1).map(|last| (0, last)).into_iter().collect();
    while let Some((begin, end)) = spans.pop() {
        [kept[begin], kept[end]] = [true, true];
        let off = |at: &usize| distance(points[*at], points[begin], points[end]);
        let farthest = (begin + 1..end).map(|at| (off(&at), at)).max_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((_, at)) = farthest.filter(|(off, _)| *off > UNSEEN) {
            spans.extend([(begin, at), (at, end)]);
        }
    }
    points.iter().zip(kept).filter(|(_, kept)| *kept).map(|(point, _)| *point).collect()
}

/// Distance of a point from the line between two others.
fn distance([x, y]: Point, [x_0, y_0]: Point, [x_1, y_1]: Point) -> f64 {
    let [right, up] = [x_1 - x_0, y_1 - y_0];
    let square = right * right + up * up;
    let share = if square > 0.0 { (((x - x_0) * right + (y - y_0) * up) / square).clamp(0.0, 1.0) } else { 0.0 };
    (x - x_0 - share * right).hypot(y - y_0 - share * up)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of a path.
    fn read(path: &str) -> Vec<Point> {
        let numbers = |point: &str| {
            let (x, y) = point.split_once(' ').unwrap();
            [x.parse().unwrap(), y.parse().unwrap()]
        };
        path.split(['M', 'L']).skip(1).map(numbers).collect()
    }

    #[test]
    fn a_spike_of_one_sample_in_many_is_kept() {
        let count = 400_001;
        for at in [0, 1, 123_457, 399_999, 400_000] {
            let value = |number: usize| if number == at { -3.0 } else { 100.0 + (number as f64 * 1e-4).sin() };
            let points = read(&over_time((0..count).map(|number| [number as f64 * 500.0 / 4e5, value(number)])));
            let spike = points.iter().min_by(|a, b| a[1].total_cmp(&b[1])).unwrap();
            assert_eq!(spike[1], -3.0);
            assert!((spike[0] - at as f64 * 500.0 / 4e5).abs() < 0.006, "{spike:?}");
            assert!(points.len() < 4_100, "{}", points.len());
        }
    }

    /// The drawn polygon lies within half a column of the curve, and is short.
    #[test]
    fn smooth_curves_need_few_points_and_stay_in_place() {
        let curve = |x: f64| 150.0 + 120.0 * (x / 30.0).sin();
        let points = read(&over_time((0..=40_000).map(|number| f64::from(number) / 80.0).map(|x| [x, curve(x)])));
        assert!((50..600).contains(&points.len()), "{}", points.len());
        for pair in points.windows(2) {
            let middle = [0.5 * (pair[0][0] + pair[1][0]), 0.5 * (pair[0][1] + pair[1][1])];
            // The steepest slope is 4.
            assert!((middle[1] - curve(middle[0])).abs() < 4.2 * UNSEEN + 0.02, "{middle:?}");
        }
    }

    #[test]
    fn noise_fills_its_band_and_the_band_is_drawn() {
        let mut random = fastrand::Rng::with_seed(7);
        let values: Vec<f64> = (0..100_000).map(|_| 100.0 * random.f64()).collect();
        let points = read(&over_time(values.iter().enumerate().map(|(number, y)| [number as f64 * 5e-3, *y])));
        for (column, values) in values.chunks(100).enumerate() {
            let (low, high) = values.iter().fold((f64::MAX, f64::MIN), |(low, high), y| (low.min(*y), high.max(*y)));
            let within = |point: &&Point| (point[0] - 0.25 - 0.5 * column as f64).abs() <= 0.2551;
            let drawn = points.iter().filter(within).map(|point| point[1]);
            let (low_drawn, high_drawn) = drawn.fold((f64::MAX, f64::MIN), |(low, high), y| (low.min(y), high.max(y)));
            assert!(low_drawn < low + 0.03 && high_drawn > high - 0.03, "column {column}");
        }
    }

    #[test]
    fn gaps_break_a_curve_and_lone_points_are_seen() {
        let nan = f64::NAN;
        let points =
            [[0.0, 1.0], [5.0, 2.0], [nan, 3.0], [9.0, nan], [12.0, 4.0], [nan, nan], [15.0, 1.0], [20.0, 9.0]];
        assert_eq!(over_time(points.into_iter()), "M0.00 1.00L5.00 2.00M11.10 4.00L12.90 4.00M15.00 1.00L20.00 9.00");
        assert_eq!(over_time([].into_iter()), "");
    }

    /// A cycle that is repeated exactly is drawn once; one that differs is drawn too.
    #[test]
    fn repeated_cycles_are_drawn_once() {
        let cycle = |number: u32, size: f64| {
            let angle = f64::from(number) * std::f64::consts::TAU / 2000.0;
            [200.0 + size * angle.cos(), 150.0 + size * angle.sin()]
        };
        let once = going_round((0..=2000).map(|number| cycle(number, 100.0)));
        let often = going_round((0..=200_000).map(|number| cycle(number, 100.0)));
        assert!(often.len() < once.len() + 40, "{} {}", once.len(), often.len());
        let grown =
            going_round((0..=200_000).map(|number| cycle(number, if number > 198_000 { 110.0 } else { 100.0 })));
        let right = read(&grown).iter().map(|point| point[0]).fold(0.0, f64::max);
        assert!((right - 310.0).abs() < 0.03, "{right}");
    }

    #[test]
    fn thinning_keeps_ends_and_corners() {
        let points = [[0.0, 0.0], [1.0, 0.01], [2.0, 0.0], [3.0, 5.0], [4.0, 5.0]];
        assert_eq!(thinned(&points), [[0.0, 0.0], [2.0, 0.0], [3.0, 5.0], [4.0, 5.0]]);
        assert_eq!(thinned(&[]), Vec::<Point>::new());
        // A curve that returns to where it began.
        assert_eq!(thinned(&[[0.0, 0.0], [9.0, 0.0], [0.0, 0.0]]).len(), 3);
    }
}
