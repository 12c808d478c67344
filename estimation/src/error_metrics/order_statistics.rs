//! Quantiles and medians of numbers that were seen.
//!
//! There are nine usual definitions of a sample's quantile (Hyndman and Fan 1996, The American Statistician 50). Two are needed here. Of n sorted numbers
//! x_1 to x_n and a share p:
//!
//! | function | type | value | what it is for |
//! |---|---|---|---|
//! | `covering_quantile` | 1 | x_k with k = n p, rounded up | a bound: at least the share p of the numbers doesn't exceed it |
//! | [`interpolated_quantile`] | 7 | on straight lines through x_k at the shares (k - 1) / (n - 1) | a figure of a law that was sampled: it moves evenly with p, and so do differences of two |
//!
//! Neither promises that another number falls below it with the probability p; with n exchangeable numbers that takes k = (n + 1) p, rounded up. Type 8, which
//! libraries of statistics have, too, lies between x_k and x_(k+1) like type 7; with 480 numbers its 95 % is the place 456.65, that of type 7 456.05.

/// Returns the least of sorted numbers that at least this share of them don't exceed: type 1, an inverse of the empirical distribution function. NaN of none.
pub(crate) fn covering_quantile(sorted: &[f64], share: f64) -> f64 {
    let place = (share * sorted.len() as f64).ceil() as usize;
    let place = place.clamp(1, sorted.len().max(1)) - 1;
    sorted.get(place).copied().unwrap_or(f64::NAN)
}

/// Returns a quantile of sorted numbers by straight lines between them: type 7, from the least at 0 to the greatest at 1.
///
/// # Panics
/// If there are no numbers.
pub fn interpolated_quantile(sorted: &[f64], share: f64) -> f64 {
    let place = share * (sorted.len() - 1) as f64;
    let i = (place.floor() as usize).min(sorted.len() - 1);
    let next = sorted[(i + 1).min(sorted.len() - 1)];
    sorted[i] + place.fract() * (next - sorted[i])
}

/// Returns the median of finite numbers, the upper of two in the middle, so that it is one of them; none of none.
pub fn upper_median(numbers: impl IntoIterator<Item = f64>) -> Option<f64> {
    let mut numbers: Vec<f64> = numbers.into_iter().collect();
    let middle = numbers.len() / 2;
    // What is beside it needn't be sorted: columns have millions of rows.
    (middle < numbers.len()).then(|| *numbers.select_nth_unstable_by(middle, f64::total_cmp).1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of which numpy.quantile gives the values below, by its methods `inverted_cdf` and `linear`.
    const SORTED: [f64; 5] = [1.0, 2.0, 4.0, 8.0, 16.0];

    #[test]
    fn a_covering_quantile_is_a_number_that_was_seen() {
        for (share, expected) in [
            (0.0, 1.0),
            (0.2, 1.0),
            (0.25, 2.0),
            (0.4, 2.0),
            (0.5, 4.0),
            (0.75, 8.0),
            (0.81, 16.0),
            (1.0, 16.0),
        ] {
            assert_eq!(covering_quantile(&SORTED, share), expected, "{share}");
        }
        assert!(covering_quantile(&[], 0.5).is_nan());
    }

    #[test]
    fn a_covering_quantile_holds_its_share_and_no_number_less_would() {
        for count in 1..40 {
            let sorted: Vec<f64> = (0..count).map(f64::from).collect();
            // Shares that are exact in binary, so that n p is.
            for share in (1..=64).map(|k| f64::from(k) / 64.0) {
                let found = covering_quantile(&sorted, share);
                assert!(
                    found + 1.0 >= share * f64::from(count) && found < share * f64::from(count)
                );
            }
        }
    }

    #[test]
    fn an_interpolated_quantile_lies_on_straight_lines() {
        for (share, expected) in [
            (0.0, 1.0),
            (0.125, 1.5),
            (0.25, 2.0),
            (0.375, 3.0),
            (0.5, 4.0),
            (0.625, 6.0),
            (0.75, 8.0),
            (0.9375, 14.0),
            (1.0, 16.0),
        ] {
            assert_eq!(interpolated_quantile(&SORTED, share), expected, "{share}");
        }
        assert_eq!(interpolated_quantile(&[3.0], 0.95), 3.0);
        // 19 steps of 20: the 95 % of 21 numbers is the last but one.
        let sorted: Vec<f64> = (0..=20).map(f64::from).collect();
        assert_eq!(interpolated_quantile(&sorted, 0.95), 19.0);
        assert_eq!(covering_quantile(&sorted, 0.95), 19.0);
    }

    #[test]
    fn a_median_is_a_number_that_was_seen() {
        assert_eq!(upper_median([3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(upper_median([4.0, 1.0, 3.0, 2.0]), Some(3.0));
        assert_eq!(upper_median([]), None);
    }
}
