//! Statistics of samples.

/// Least and largest value.
pub fn extremes(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
}

/// Number of changes of direction between motions faster than a speed.
pub fn reversals(velocity: &[f64], speed: f64) -> usize {
    let fast = velocity.iter().filter(|v| v.abs() > speed);
    let signs: Vec<bool> = fast.map(|v| *v > 0.0).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// Standard deviation of normal noise by the median of its magnitude.
pub const OF_MEDIAN: f64 = 1.4826;

/// Median, the upper one of an even number of values; sorts them.
pub fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
