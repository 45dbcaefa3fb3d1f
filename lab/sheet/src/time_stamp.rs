//! Time stamps: `hh:mm:ss.sss`, of a day or since a start, or ISO 8601 with a date before them.

/// Seconds of a day.
const DAY: f64 = 86_400.0;
/// Most hours since a start (chosen: a year).
const LONGEST: u32 = 8784;

/// A moment: a time of day, perhaps with its day, or a time since a start, which may be longer than a day.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stamp {
    /// Days since 1970-01-01.
    day: Option<i64>,
    /// Seconds since midnight; in other time zones than UTC perhaps of another day.
    second: f64,
}

impl Stamp {
    /// Reads a time stamp; None for other texts.
    pub fn parse(text: &str) -> Option<Stamp> {
        let (date, time) = text.trim().split_once(['T', ' ']).unwrap_or(("", text.trim()));
        let day = if date.is_empty() { None } else { Some(days(date)?) };
        let (time, offset) = without_zone(time.trim())?;
        let mut parts = time.splitn(3, ':');
        let mut whole = |most: u32| parts.next()?.parse::<u32>().ok().filter(|part| *part <= most).map(f64::from);
        let (hour, minute) = (whole(if day.is_none() { LONGEST } else { 23 })?, whole(59)?);
        let digits = parts.next()?.replace(',', ".");
        let is_plain = digits.starts_with(|first: char| first.is_ascii_digit()) && !digits.contains(['e', 'E']);
        let second = digits.parse::<f64>().ok().filter(|second| is_plain && *second < 61.0)?;
        Some(Stamp { day, second: 3600.0 * hour + 60.0 * minute + second - offset })
    }

    /// Seconds since midnight of the day of another stamp; None if only one of them has a day.
    pub fn since_midnight_of(self, first: Stamp) -> Option<f64> {
        match (self.day, first.day) {
            (Some(day), Some(first)) => Some((day - first) as f64 * DAY + self.second),
            (None, None) => Some(self.second),
            _ => None,
        }
    }
}

/// A time without `Z` or `+hh:mm`, and the seconds of the latter.
fn without_zone(time: &str) -> Option<(&str, f64)> {
    if let Some(time) = time.strip_suffix(['Z', 'z']) {
        return Some((time, 0.0));
    }
    let Some(at) = time.find(['+', '-']) else { return Some((time, 0.0)) };
    let sign = if time[at..].starts_with('-') { -1.0 } else { 1.0 };
    let digits = time[at + 1..].replace(':', "");
    let number = digits.parse::<u32>().ok().filter(|_| matches!(digits.len(), 2 | 4))?;
    let [hours, minutes] = if digits.len() == 2 { [number, 0] } else { [number / 100, number % 100] };
    Some((&time[..at], sign * (3600.0 * f64::from(hours) + 60.0 * f64::from(minutes))))
}

/// Days from 1970-01-01 to a date `yyyy-mm-dd` of the Gregorian calendar.
fn days(date: &str) -> Option<i64> {
    let mut parts = date.splitn(3, '-').map(|part| part.parse::<u32>().ok().map(i64::from));
    let (year, month, day) = (parts.next()??, parts.next()??, parts.next()??);
    if !(1..=9999).contains(&year) || !(1..=12).contains(&month) || !(1..=length(year, month)).contains(&day) {
        return None;
    }
    // Leap days before this year, then the months of it.
    let before = year - 1;
    let of_years = 365 * before + before / 4 - before / 100 + before / 400;
    let of_months: i64 = (1..month).map(|month| length(year, month)).sum();
    Some(of_years + of_months + day - 1 - EPOCH)
}

/// Days from 0001-01-01 to 1970-01-01.
const EPOCH: i64 = 719_162;

fn length(year: i64, month: i64) -> i64 {
    match month {
        2 if year % 4 == 0 && (year % 100 != 0 || year % 400 == 0) => 29,
        2 => 28,
        4 | 6 | 9 | 11 => 30,
        _ => 31,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_are_those_of_the_calendar() {
        let known = [("1970-01-01", 0), ("2000-02-29", 11_016), ("2000-03-01", 11_017), ("2024-12-31", 20_088)];
        for (date, count) in known {
            assert_eq!(days(date), Some(count), "{date}");
        }
        for wrong in ["2023-02-29", "1900-02-29", "2024-13-01", "2024-00-10", "2024-04-31", "24.12.2024", "2024-12"] {
            assert_eq!(days(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn stamps_are_seconds_of_the_first_day() {
        let first = Stamp::parse("2024-02-28T23:59:59.75Z").unwrap();
        let since = |text: &str| Stamp::parse(text).and_then(|stamp| stamp.since_midnight_of(first));
        assert_eq!(since("2024-02-28T23:59:59.75Z"), Some(86_399.75));
        assert_eq!(since("2024-03-01 00:00:00,5"), Some(2.0 * DAY + 0.5));
        assert_eq!(since("2024-02-29T01:00:00+01:00"), Some(DAY));
        assert_eq!(since("2024-02-28T20:30:00-0330"), Some(DAY));
        assert_eq!(since("12:00:00"), None, "its day is not known");
        let alone = Stamp::parse("01:02:03.5").unwrap();
        assert_eq!(alone.since_midnight_of(alone), Some(3723.5));
        assert_eq!(Stamp::parse("24:00:01").unwrap().since_midnight_of(alone), Some(86_401.0));
        for wrong in [
            "1:2",
            "2024-02-28T24:00:00",
            "9000:00:00",
            "12:60:00",
            "12:00:61",
            "12:00:-1",
            "12:00:nan",
            "1.5",
            "",
            "12:00:1e1",
        ] {
            assert_eq!(Stamp::parse(wrong), None, "{wrong}");
        }
    }
}
