//! Times that are written as dates, or as a clock shows them.

use jiff::Timestamp;
use jiff::civil::{DateTime, Time};
use jiff::tz::TimeZone;

const NANOSECONDS: f64 = 1e9;

/// Seconds of `2026-11-25T10:00:00.050Z` since 1970, or of `10:00:00.050` since midnight. A date without a zone counts as UTC: differences of times are what is used.
pub(super) fn seconds(text: &str) -> Option<f64> {
    // jiff reads no comma for a point, and no year alone.
    if !text.contains(':') {
        return None;
    }
    let text = text.replace(',', ".");
    let since_1970 = |at: Timestamp| {
        let nanoseconds = i64::from(at.subsec_nanosecond());
        at.as_second() as f64 + nanoseconds as f64 / NANOSECONDS
    };
    if let Ok(at) = text.parse::<Timestamp>() {
        return Some(since_1970(at));
    }
    if let Ok(at) = text.parse::<DateTime>() {
        return at
            .to_zoned(TimeZone::UTC)
            .ok()
            .map(|at| since_1970(at.timestamp()));
    }
    let at = text.parse::<Time>().ok()?;
    let whole = i32::from(at.hour()) * 3600 + i32::from(at.minute()) * 60 + i32::from(at.second());
    Some(f64::from(whole) + f64::from(at.subsec_nanosecond()) / NANOSECONDS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_and_clocks_are_seconds() {
        // date -u -d 2026-11-25T10:00:00 +%s
        let ten = 1_795_600_800.0;
        for (text, expected) in [
            ("2026-11-25T10:00:00Z", ten),
            ("2026-11-25T10:00:00.050Z", ten + 0.05),
            ("2026-11-25 10:00:00.05", ten + 0.05),
            ("2026-11-25T12:00:00+02:00", ten),
            ("2026-11-25T10:00:00,050", ten + 0.05),
            ("10:00:00.050", 36000.05),
            ("00:00:01", 1.0),
        ] {
            assert_eq!(seconds(text), Some(expected), "{text}");
        }
        for text in [
            "",
            "1.5",
            "10",
            "25:00:00",
            "rest",
            "2026-13-01T00:00:00Z",
            "::",
        ] {
            assert_eq!(seconds(text), None, "{text}");
        }
    }
}
