//! Axes: range, unit, ticks.

use stribeck::unit::UNITS;

use crate::text::{decimal, digits, typeset_unit};

/// Values that differ by less than this part of their size are drawn as a constant: the rest is rounding.
const CONSTANT: f64 = 1e-9;
/// Values that differ by less than this part of their size are shown as the difference from a round value.
const CLOSE: f64 = 2e-4;
/// Part of the range that is left free at both ends.
const ROOM: f64 = 0.04;

/// An axis: value shown = (value - offset) factor, or its logarithm.
pub struct Axis {
    /// Unit of the values shown, as printed.
    unit: String,
    /// The offset with its unit, as printed; empty if there is none.
    from: String,
    /// Values shown at the ends.
    low: f64,
    high: f64,
    factor: f64,
    offset: f64,
    step: f64,
    is_logarithmic: bool,
}

impl Axis {
    /// An axis for values from `low` to `high` with about `count` ticks; `tight` if it ends where they do.
    pub fn new(unit: &str, [low, high]: [f64; 2], count: f64, tight: bool) -> Axis {
        let size = low.abs().max(high.abs());
        let is_constant = high - low <= CONSTANT * size;
        let (offset, from) = if is_constant { (0.0, String::new()) } else { origin(unit, [low, high]) };
        let [low, high] = [low - offset, high - offset];
        let room = if is_constant { constant_room(size) } else { ROOM * (high - low) };
        let [low, high] = if tight && !is_constant { [low, high] } else { [low - room, high + room] };
        let (unit, factor) = handy(unit, if is_constant { size } else { low.abs().max(high.abs()) });
        let [low, high] = [low * factor, high * factor];
        Axis { unit, from, low, high, factor, offset, step: tick_step((high - low) / count), is_logarithmic: false }
    }

    /// A logarithmic axis for positive values from `low` to `high`, between powers of ten.
    pub fn powers(unit: &str, [low, high]: [f64; 2]) -> Axis {
        let low = low.log10().floor();
        let high = high.log10().ceil().max(low + 1.0);
        // A tick for each power, or for every second or fifth one.
        let step = tick_step((high - low) / 8.0).max(1.0);
        let unit = if unit == "1" { String::new() } else { typeset_unit(unit) };
        Axis { unit, from: String::new(), low, high, factor: 1.0, offset: 0.0, step, is_logarithmic: true }
    }

    /// Place of a value, as a part of the axis.
    pub fn place(&self, value: f64) -> f64 {
        let shown = if self.is_logarithmic { value.log10() } else { (value - self.offset) * self.factor };
        (shown - self.low) / (self.high - self.low)
    }

    /// Place of zero, if it is inside and the values are not counted from elsewhere.
    pub fn zero(&self) -> Option<f64> {
        let place = self.place(0.0);
        (place > 0.02 && place < 0.98 && self.from.is_empty()).then_some(place)
    }

    /// The offset and the unit as they stand behind the name of the quantity: " in mm".
    pub fn counted(&self) -> String {
        let from = if self.from.is_empty() { String::new() } else { format!(" \u{2212} {}", self.from) };
        let unit = if self.unit.is_empty() { String::new() } else { format!(" in {}", self.unit) };
        from + &unit
    }

    /// Places of the ticks with their texts.
    pub fn ticks(&self) -> impl Iterator<Item = (f64, String)> + '_ {
        const SLACK: f64 = 1e-9;
        let first = (self.low / self.step - SLACK).ceil() as i64;
        let last = (self.high / self.step + SLACK).floor() as i64;
        (first..=last).map(|number| {
            let value = number as f64 * self.step;
            let place = (value - self.low) / (self.high - self.low);
            let is_power = self.is_logarithmic;
            (place, if is_power { format!("10{}", raised(value)) } else { decimal(value, decimals(self.step)) })
        })
    }
}

/// The value from which others are counted, and its text: a round one if the range is narrow, else zero.
fn origin(unit: &str, [low, high]: [f64; 2]) -> (f64, String) {
    if high - low >= CLOSE * low.abs().max(high.abs()) {
        return (0.0, String::new());
    }
    let step = tick_step(high - low);
    let offset = (low / step).round() * step;
    (offset, format!("{} {}", decimal(offset, decimals(step)), typeset_unit(unit)))
}

/// Room on both sides of a constant.
fn constant_room(size: f64) -> f64 {
    if size > 0.0 { 0.5 * size } else { 1.0 }
}

/// 1, 2 or 5 times a power of ten, at least `least`.
pub fn tick_step(least: f64) -> f64 {
    let power = 10f64.powf(least.log10().floor());
    let digit = [1.0, 2.0, 5.0].into_iter().find(|digit| digit * power >= least * (1.0 - 1e-9));
    digit.unwrap_or(10.0) * power
}

/// Decimals that tell one tick from the next.
fn decimals(step: f64) -> usize {
    (-(step * 1.000_001).log10().floor()).max(0.0) as usize
}

/// The unit in which values up to `largest` are readable, with the values shown per SI value.
fn handy(unit: &str, largest: f64) -> (String, f64) {
    let declared = UNITS.iter().find(|known| known.name == unit);
    let shown = declared.into_iter().flat_map(|known| known.display).filter(|shown| shown.offset == 0.0);
    let units = [(unit, 1.0)].into_iter().chain(shown.map(|shown| (shown.name, shown.factor)));
    // From one to a thousand; the SI unit, which is the first, wins a tie.
    let clumsiness = |factor: f64| (largest * factor / 30.0).log10().abs().max(1.5);
    let best = units.min_by(|a, b| clumsiness(a.1).total_cmp(&clumsiness(b.1)));
    let (name, factor) = best.unwrap_or((unit, 1.0));
    let printed = if name == "1" { String::new() } else { typeset_unit(name) };
    let shown = largest * factor;
    if !(shown > 0.0 && shown.is_finite()) || (1e-2..1e5).contains(&shown) {
        return (printed, factor);
    }
    let power = 3.0 * (largest.log10() / 3.0).floor();
    let printed = if unit == "1" { String::new() } else { typeset_unit(unit) };
    (format!("10{} {printed}", raised(power)).trim_end().to_owned(), 10f64.powf(-power))
}

/// A whole number as an exponent.
fn raised(power: f64) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = digits(power, 4);
    raised.chars().map(|letter| letter.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit(unit: &str, largest: f64) -> String {
        Axis::new(unit, [0.0, largest], 6.0, true).unit
    }

    #[test]
    fn units_make_numbers_readable() {
        for (name, largest, expected) in [
            ("m", 0.75, "mm"),
            ("m", 7.5, "m"),
            ("m", 3e-5, "µm"),
            ("m/s", 0.12, "mm/s"),
            ("m/s2", 0.49, "m/s²"),
            ("N", 1.47, "N"),
            ("N", 5300.0, "kN"),
            ("N", 2e-5, "10⁻⁶ N"),
            ("N.m", 3e7, "10⁶ N·m"),
            ("1", 0.5, ""),
        ] {
            assert_eq!(unit(name, largest), expected, "{largest} {name}");
        }
    }

    #[test]
    fn logarithmic_axes_go_from_power_to_power() {
        let axis = Axis::powers("m", [3e-9, 2e-4]);
        let ticks: Vec<(f64, String)> = axis.ticks().collect();
        assert_eq!((ticks.len(), ticks[0].1.as_str(), ticks[6].1.as_str()), (7, "10⁻⁹", "10⁻³"));
        assert_eq!((axis.place(1e-9), axis.place(1e-6), axis.place(1e-3)), (0.0, 0.5, 1.0));
        assert_eq!(Axis::powers("1", [10.0, 10.0]).ticks().count(), 2);
    }

    #[test]
    fn ticks_are_round_and_on_the_axis() {
        for [low, high] in
            [[0.0, 40.0], [-1.4715, 1.4715], [-3e-7, 1e-8], [7.3, 7.9], [2e4, 9e4], [5.0, 5.0], [0.0, 0.0]]
        {
            for tight in [false, true] {
                let axis = Axis::new("N", [low, high], 6.0, tight);
                let ticks: Vec<(f64, String)> = axis.ticks().collect();
                assert!((3..=9).contains(&ticks.len()), "{low} {high}: {ticks:?}");
                for (place, text) in &ticks {
                    assert!((-1e-9..=1.0 + 1e-9).contains(place) && text.chars().count() <= 7, "{ticks:?}");
                    let value: f64 = text.replace('\u{2212}', "-").parse().unwrap();
                    let along = (value - axis.low) / (axis.high - axis.low);
                    assert!((along - place).abs() < 1e-9, "{text} at {place}");
                }
                assert!(axis.place(low) >= 0.0 && axis.place(high) <= 1.0, "{low} {high}");
            }
        }
    }

    /// The ticks of a range of a microsecond, seven seconds after the start, count from a round time.
    #[test]
    fn narrow_ranges_are_counted_from_a_round_value() {
        let axis = Axis::new("s", [7.357_500_2, 7.357_501_4], 8.0, true);
        assert_eq!((axis.from.as_str(), axis.unit.as_str()), ("7.357500 s", "10⁻⁶ s"));
        assert!(axis.ticks().all(|(_, text)| text.len() <= 3), "{:?}", axis.ticks().collect::<Vec<_>>());
        assert!((axis.place(7.357_500_2)).abs() < 1e-6 && (axis.place(7.357_501_4) - 1.0).abs() < 1e-6);
    }
}
