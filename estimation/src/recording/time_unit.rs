//! Times in another unit than seconds, told by the name of their column.

/// Units other than seconds, as names end, with their length in seconds.
const UNITS: [(&[&str], &str, f64); 4] = [
    (
        &["ms", "msec", "millis", "milliseconds"],
        "milliseconds",
        1e-3,
    ),
    (
        &["us", "µs", "usec", "micros", "microseconds"],
        "microseconds",
        1e-6,
    ),
    (&["ns", "nsec", "nanos", "nanoseconds"], "nanoseconds", 1e-9),
    (&["min", "minutes"], "minutes", 60.0),
];

/// A sentence on a column of time whose name says another unit than seconds, as in `time_ms`; rows are so far apart, s.
pub fn other_time_unit(column: &str, interval_s: f64) -> Option<String> {
    let lower = column.to_lowercase();
    let mut words = lower.split(|letter: char| !letter.is_alphanumeric());
    let last = words.rfind(|word| !word.is_empty())?;
    let (_, unit, seconds) = UNITS.iter().find(|(ends, _, _)| ends.contains(&last))?;
    let as_meant = interval_s * seconds;
    Some(format!(
        "unlikely value in {column}: it is read as seconds, and its name says {unit}. Rows are {} s apart, and {} s if it does: multiply it by {seconds}, and name it time_s. \
         Rates, pauses and slopes are wrong by that factor until then",
        rounded(interval_s),
        rounded(as_meant)
    ))
}

/// Three digits.
fn rounded(number: f64) -> f64 {
    format!("{number:.2e}").parse().unwrap_or(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_tells_its_unit() {
        for name in ["time_ms", "t [ms]", "Time (ms)", "timestamp/millis"] {
            let found = other_time_unit(name, 5.0).unwrap_or_default();
            assert!(
                found.contains("Rows are 5 s apart, and 0.005 s"),
                "{name}: {found}"
            );
        }
        let micros = other_time_unit("t_us", 5000.0).unwrap_or_default();
        assert!(micros.contains("and 0.005 s"), "{micros}");
        for name in ["time_s", "t", "time", "seconds", "items", "bus", ""] {
            assert_eq!(other_time_unit(name, 5.0), None, "{name}");
        }
    }
}
