//! Units of a column of time: by its name, or by numbers that only a date can have.

use super::unit_of_name::parts;
use crate::recipe::time_unit::TimeUnit;

/// Words for units at the end of names.
const WORDS: [(TimeUnit, &[&str]); 5] = [
    (TimeUnit::S, &["s", "sec", "secs", "seconds"]),
    (TimeUnit::Ms, &["ms", "msec", "millis", "milliseconds"]),
    (
        TimeUnit::Us,
        &["us", "µs", "μs", "usec", "micros", "microseconds"],
    ),
    (TimeUnit::Ns, &["ns", "nsec", "nanos", "nanoseconds"]),
    (TimeUnit::Min, &["min", "minutes"]),
];
/// Names of times without their units.
const TIMES: [&str; 11] = [
    "time",
    "t",
    "timestamp",
    "time_stamp",
    "stamp",
    "header_stamp",
    "elapsed",
    "elapsed_time",
    "datetime",
    "date_time",
    "epoch",
];
/// Names of times in seconds that stand beside nanoseconds, or alone.
const SECONDS: [&str; 3] = ["sec", "secs", "seconds"];
const NANOSECONDS: [&str; 4] = ["nanosec", "nsec", "nsecs", "nanosecs"];
/// Numbers from here on are no seconds: they would be 3000 years, and steps of a fast clock would be lost in their rounding.
pub(super) const NO_SECONDS: f64 = 1e11;
/// Rows so far apart may be so many milliseconds, s.
const DOUBTFUL_S: f64 = 2.0;

/// The unit that a name ends with.
pub(super) fn unit_of(name: &str) -> Option<TimeUnit> {
    let unit = parts(name, |unit| of_word(unit).is_some()).unit?;
    of_word(&unit)
}

/// The unit of a date in numbers since 1970, by its size; `None` of a number that may be seconds.
pub fn epoch_unit(number: f64) -> Option<TimeUnit> {
    match number.abs() {
        n if !n.is_finite() || n < NO_SECONDS => None,
        n if n < 1e3 * NO_SECONDS => Some(TimeUnit::Ms),
        n if n < 1e6 * NO_SECONDS => Some(TimeUnit::Us),
        _ => Some(TimeUnit::Ns),
    }
}

fn of_word(word: &str) -> Option<TimeUnit> {
    let mut units = WORDS.iter();
    let found = units.find(|(_, words)| words.contains(&word))?;
    Some(found.0)
}

/// A sentence on numbers that may be no seconds: rows of a column without a unit that are far apart, or that count; `is_named` where a recipe names the column.
pub fn doubt(column: &str, time_s: &[f64], interval_s: f64, is_named: bool) -> Option<String> {
    let counts = || {
        time_s
            .windows(2)
            .all(|pair| matches!(pair, [a, b] if b - a == 1.0))
    };
    if !is_named && !is_time(column) && counts() {
        return Some(format!(
            "no column is the time by its name, and {} counts rows: name the column of time by time = \"...\", or say time = {column:?} if rows are a second apart",
            column.escape_debug()
        ));
    }
    let has_unit = unit_of(column).is_some();
    (!has_unit && interval_s >= DOUBTFUL_S).then(|| {
        format!(
            "rows are {} apart in {}, whose name says no unit: add time_unit = \"s\" if these are seconds, or \"ms\", \"us\", \"ns\"",
            rounded(interval_s),
            column.escape_debug()
        )
    })
}

/// Four digits.
fn rounded(number: f64) -> f64 {
    format!("{number:.3e}").parse().unwrap_or(number)
}

/// Whether a name is one that columns of time usually have.
pub(super) fn is_time(name: &str) -> bool {
    let found = parts(name, |unit| of_word(unit).is_some());
    TIMES.contains(&found.base.as_str())
        || found.unit.is_none() && SECONDS.contains(&found.base.as_str())
}

/// The column of nanoseconds that belongs to one of whole seconds, as ROS writes them: `sec` and `nanosec`, `header.stamp.secs` and `header.stamp.nsecs`.
pub(super) fn nanoseconds_beside<'h>(time: &str, header: &'h [String]) -> Option<&'h String> {
    let (stem, last) = stem(time);
    let is_beside = |name: &&String| {
        let (other, word) = self::stem(name);
        other == stem && NANOSECONDS.contains(&word.as_str())
    };
    header
        .iter()
        .find(is_beside)
        .filter(|_| SECONDS.contains(&last.as_str()))
}

/// A name up to its last word, and that word.
fn stem(name: &str) -> (String, String) {
    let lower = name.trim().to_lowercase();
    let at = lower.rfind(|letter: char| !letter.is_alphanumeric());
    match at {
        Some(at) => {
            let (before, after) = lower.split_at(at);
            let word = after.trim_start_matches(|letter: char| !letter.is_alphanumeric());
            (before.to_owned(), word.to_owned())
        }
        None => (String::new(), lower),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_tells_its_unit() {
        for (name, unit) in [
            ("time_ms", Some(TimeUnit::Ms)),
            ("Time (ms)", Some(TimeUnit::Ms)),
            ("timestamp/millis", Some(TimeUnit::Ms)),
            ("t_us", Some(TimeUnit::Us)),
            ("t [µs]", Some(TimeUnit::Us)),
            ("timestamp_ns", Some(TimeUnit::Ns)),
            ("time_s", Some(TimeUnit::S)),
            ("Time [min]", Some(TimeUnit::Min)),
            ("time", None),
            ("items", None),
            ("", None),
        ] {
            assert_eq!(unit_of(name), unit, "{name}");
        }
        for name in [
            "time_ms",
            "Time [s]",
            "t",
            "sec",
            "header.stamp.sec",
            "TimeStamp",
        ] {
            assert!(is_time(name), "{name}");
        }
        for name in ["sample", "index", "seconds_held", "s1", "ms"] {
            assert!(!is_time(name), "{name}");
        }
    }

    #[test]
    fn only_dates_have_such_numbers() {
        // November 2025 in each unit; a year of seconds, of milliseconds.
        assert_eq!(epoch_unit(1.764e9), None);
        assert_eq!(epoch_unit(1.764e12), Some(TimeUnit::Ms));
        assert_eq!(epoch_unit(1.764e15), Some(TimeUnit::Us));
        assert_eq!(epoch_unit(1.764e18), Some(TimeUnit::Ns));
        assert_eq!(epoch_unit(3.2e10), None);
        assert_eq!(TimeUnit::Ms.seconds(50.0), 0.05);
        assert_eq!(TimeUnit::Ns.seconds(150e6), 0.15);
        assert_eq!(TimeUnit::Min.seconds(2.0), 120.0);
    }

    #[test]
    fn what_may_be_no_seconds_is_doubted() {
        let [fast, counted] = [[0.0, 0.05, 0.1], [0.0, 1.0, 2.0]];
        assert_eq!(doubt("t", &fast, 0.05, false), None);
        assert_eq!(doubt("t", &counted, 1.0, false), None);
        assert_eq!(doubt("sample", &counted, 1.0, true), None);
        let counts = doubt("sample", &counted, 1.0, false).unwrap_or_default();
        assert!(counts.contains("sample counts rows"), "{counts}");
        let far = doubt("t", &[0.0, 50.0], 50.0, false).unwrap_or_default();
        assert!(far.contains("rows are 50 apart"), "{far}");
        assert_eq!(doubt("time_s", &[0.0, 50.0], 50.0, false), None);
    }

    #[test]
    fn whole_seconds_have_nanoseconds_beside_them() {
        let header = |names: [&str; 3]| names.map(str::to_owned);
        for (time, beside) in [
            ("sec", "nanosec"),
            ("header.stamp.secs", "header.stamp.nsecs"),
        ] {
            let names = header([time, beside, "s1"]);
            assert_eq!(
                nanoseconds_beside(time, &names).map(String::as_str),
                Some(beside)
            );
        }
        for (time, other) in [("sec", "a.nanosec"), ("time", "nanosec"), ("sec", "s2")] {
            assert_eq!(nanoseconds_beside(time, &header([time, other, "s1"])), None);
        }
    }
}
