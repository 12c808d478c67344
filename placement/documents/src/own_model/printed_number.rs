//! Numbers as their text shows them: to which digit, and with which rounding.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

/// Significant digits that tell nearly every double apart from its neighbours: nothing of it is rounded.
const DIGITS_OF_A_DOUBLE: i32 = 16;

/// A number and the digits of its text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PrintedNumber {
    pub(super) value: f64,
    /// Power of ten of the first digit that isn't zero; `None` of a zero.
    first: Option<i32>,
    /// Power of ten of the last digit.
    last: i32,
}

impl PrintedNumber {
    /// Reads a finite number; `None` for anything else.
    pub(super) fn read(text: &str) -> Option<Self> {
        let value: f64 = text.parse().ok().filter(|value: &f64| value.is_finite())?;
        let (mantissa, exponent) = match text.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
            None => (text, 0),
        };
        let mantissa = mantissa.trim_start_matches(['+', '-']);
        let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let power_of = |place: usize| i32::try_from(place).ok();
        let last = exponent.checked_sub(power_of(decimals.len())?)?;
        let digits = whole.chars().chain(decimals.chars());
        let leading = digits.take_while(|digit| *digit == '0').count();
        let significant = power_of(whole.len() + decimals.len() - leading)?;
        let first = last.checked_add(significant - 1)?;
        Some(Self {
            value,
            first: (significant > 0).then_some(first),
            last,
        })
    }

    /// Unit of its last digit.
    pub(super) fn unit(&self) -> f64 {
        10f64.powi(self.last)
    }

    fn significant(&self) -> i32 {
        self.first.map_or(0, |first| first - self.last + 1)
    }
}

/// Half a unit of the last digit that a column of numbers was printed to, at the number where it is most; zero where all digits of doubles
/// are there. A program prints to some decimals, or to some significant digits, and may leave zeros at the end out: of either, the most that the
/// column shows. A number is rounded to the coarser of the two, which is the one that was asked for, whichever that was.
pub(super) fn half_unit(column: &[PrintedNumber]) -> f64 {
    let finest = column.iter().map(|number| number.last).min();
    let digits = column.iter().map(PrintedNumber::significant).max();
    let (Some(finest), Some(digits)) = (finest, digits) else {
        return 0.0;
    };
    if digits >= DIGITS_OF_A_DOUBLE {
        return 0.0;
    }
    let last = |number: &PrintedNumber| number.first.map(|first| first - digits + 1);
    let coarsest = column.iter().filter_map(last).fold(finest, i32::max);
    // A zero may be written with any power of ten.
    0.5 * 10f64.powi(coarsest).min(f64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(texts: &[&str]) -> f64 {
        let read = |text: &&str| PrintedNumber::read(text);
        half_unit(&texts.iter().filter_map(read).collect::<Vec<_>>())
    }

    #[test]
    fn places_of_digits_are_read() {
        for (text, first, last) in [
            ("1000.12", Some(3), -2),
            ("-0.0050", Some(-3), -4),
            ("+1.5e-3", Some(-3), -4),
            ("25E2", Some(3), 2),
            (".5", Some(-1), -1),
            ("7.", Some(0), 0),
            ("0.00", None, -2),
        ] {
            let number = PrintedNumber::read(text).unwrap();
            assert_eq!((number.first, number.last), (first, last), "{text}");
        }
        for text in ["nan", "inf", "", "1e999", "x", "1e99999999999"] {
            assert_eq!(PrintedNumber::read(text), None, "{text}");
        }
    }

    #[test]
    fn a_column_is_as_fine_as_its_format() {
        // %.2f with and without its zeros, %.6g across magnitudes, %.3e, whole numbers
        for (texts, expected) in [
            (&["1000.12", "3.40", "-0.05"][..], 0.005),
            (&["1000.1", "1000.25", "3.42", "0"], 0.005),
            (&["1000.12", "3.40512", "0.00123456"], 0.005),
            (&["1.234e+05", "1.2e-3"], 50.0),
            (&["12", "7", "100"], 0.5),
            (&["nan", ""], 0.0),
        ] {
            let found = column(texts);
            assert!(
                (found - expected).abs() <= 1e-15 * expected,
                "{texts:?} {found}"
            );
        }
    }

    #[test]
    fn doubles_are_exact_however_few_digits_some_have() {
        assert_eq!(column(&["0.5", "0.30000000000000004", "2"]), 0.0);
        assert_eq!(column(&["1.1000000000000001"]), 0.0);
    }
}
