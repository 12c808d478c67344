//! A column as a band: least and greatest value of each bin of time.

use super::column_figures::measured;

/// Least and greatest value of each of so many bins of equal length from the first time to the last; none where nothing was measured.
pub fn value_bins(time_s: &[f64], values: &[f64], bins: usize) -> Vec<Option<(f64, f64)>> {
    let mut found: Vec<Option<(f64, f64)>> = vec![None; bins];
    let first = time_s.first().copied().unwrap_or(0.0);
    let length = time_s.last().map_or(0.0, |last| last - first);
    for (row, value) in measured(values) {
        let Some(time) = time_s.get(row) else {
            continue;
        };
        let share = if length > 0.0 {
            (time - first) / length
        } else {
            0.0
        };
        // The last row belongs to the last bin.
        let bin = ((share * bins as f64) as usize).min(bins.saturating_sub(1));
        if let Some(place) = found.get_mut(bin) {
            let (least, greatest) = place.unwrap_or((value, value));
            *place = Some((least.min(value), greatest.max(value)));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bins_have_the_least_and_the_greatest() {
        let time_s = [0.0, 1.0, 2.0, 9.0, 10.0];
        let values = [3.0, 1.0, f64::NAN, 5.0, 4.0];
        let found = value_bins(&time_s, &values, 5);
        assert_eq!(
            found,
            [Some((1.0, 3.0)), None, None, None, Some((4.0, 5.0))]
        );
        assert_eq!(
            value_bins(&[2.0], &[7.0], 3),
            [Some((7.0, 7.0)), None, None]
        );
        assert!(value_bins(&time_s, &values, 0).is_empty());
    }
}
