//! Figures with their errors, as they stand in sentences.

/// Decimals of a figure without an error, and at most.
const DECIMALS: usize = 1;
const MOST_DECIMALS: usize = 4;

/// `9.2 +- 1.5`: two digits of the error, and the figure to the same place. `9.2` where no error is known; `100` or `56.421` where the error is below the last decimal.
pub(crate) fn with_error(value: f64, error: Option<f64>) -> String {
    match error {
        Some(error) if error < 0.5 * 10f64.powi(-(MOST_DECIMALS as i32)) => {
            let text = format!("{value:.MOST_DECIMALS$}");
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        }
        Some(error) => {
            let decimals = decimals(error);
            format!("{value:.decimals$} +- {error:.decimals$}")
        }
        None => format!("{value:.DECIMALS$}"),
    }
}

/// Decimals that show two digits of an error.
fn decimals(error: f64) -> usize {
    if !error.is_finite() {
        return DECIMALS;
    }
    (0..MOST_DECIMALS)
        .find(|&decimals| error * 10f64.powi(decimals as i32) >= 9.95)
        .unwrap_or(MOST_DECIMALS)
}

/// A share in percent, as far as it matters: `100`, `6.3`, `0.04`.
pub(super) fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    match percent.abs() {
        size if size >= 9.95 => format!("{percent:.0}"),
        size if size >= 0.095 => format!("{percent:.1}"),
        _ => format!("{percent:.2}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_digits_of_an_error_are_said() {
        let cases = [
            (9.234, Some(1.449), "9.2 +- 1.4"),
            (36.47, Some(27.47), "36 +- 27"),
            (0.872, Some(0.211), "0.87 +- 0.21"),
            (72.86, Some(9.96), "73 +- 10"),
            (100.0, Some(0.0), "100"),
            (56.421, Some(1e-9), "56.421"),
            (5.0, Some(6e-5), "5.0000 +- 0.0001"),
            (5.04, None, "5.0"),
        ];
        for (value, error, words) in cases {
            assert_eq!(with_error(value, error), words);
        }
    }

    #[test]
    fn shares_are_said_as_far_as_they_matter() {
        let said = [0.9966, 0.0626, 0.00038].map(percent);
        assert_eq!(said, ["100", "6.3", "0.04"]);
    }
}
