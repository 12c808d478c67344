//! Medians of each signal over the last seconds.

use std::collections::VecDeque;

/// Most values that a median is of: more rows in its seconds than these leave the oldest out.
const MOST_ROWS: usize = 100_000;

/// Windows of the last seconds, one a signal, in order of their values.
#[derive(Debug, Clone, Default)]
pub(super) struct Baselines {
    /// Time, s, and values of each row in the windows.
    rows: VecDeque<(f64, Vec<f64>)>,
    /// The values of each signal in them, sorted.
    sorted: Vec<Vec<f64>>,
}

impl Baselines {
    /// The median of each signal's values of the last `seconds` up to this row, itself among them; the upper one of two in the middle.
    pub fn push(&mut self, time_s: f64, values: &[f64], seconds: f64) -> Vec<f64> {
        while let Some((before, _)) = self.rows.front()
            && (time_s - before > seconds || self.rows.len() >= MOST_ROWS)
        {
            self.drop_oldest();
        }
        self.sorted.resize_with(values.len(), Vec::new);
        for (sorted, value) in self.sorted.iter_mut().zip(values) {
            sorted.insert(place_of(sorted, *value), *value);
        }
        self.rows.push_back((time_s, values.to_vec()));
        let medians = self.sorted.iter().map(|sorted| sorted[sorted.len() / 2]);
        medians.collect()
    }

    /// Forgets all rows.
    pub fn clear(&mut self) {
        self.rows.clear();
        self.sorted.clear();
    }

    fn drop_oldest(&mut self) {
        let Some((_, values)) = self.rows.pop_front() else {
            return;
        };
        for (sorted, value) in self.sorted.iter_mut().zip(values) {
            sorted.remove(place_of(sorted, value));
        }
    }
}

/// The first place whose value isn't less.
fn place_of(sorted: &[f64], value: f64) -> usize {
    sorted.partition_point(|other| other.total_cmp(&value).is_lt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_median_is_that_of_the_rows_in_its_seconds() {
        let times: Vec<f64> = (0..300).map(|k| 0.25 * f64::from(k)).collect();
        // Values that repeat, so that equal ones leave one by one.
        let value = |k: usize, signal: usize| ((k * k * (signal + 3)) % 17) as f64 - 8.0;
        let mut baselines = Baselines::default();
        for (k, time_s) in times.iter().enumerate() {
            let found = baselines.push(*time_s, &[value(k, 0), value(k, 1)], 2.0);
            // 2 s of rows 0.25 s apart are nine, both ends among them.
            for (signal, found) in found.iter().enumerate() {
                let mut window: Vec<f64> = (k.saturating_sub(8)..=k)
                    .map(|j| value(j, signal))
                    .collect();
                window.sort_by(f64::total_cmp);
                assert_eq!(*found, window[window.len() / 2], "{k} {signal}");
            }
        }
        baselines.clear();
        assert_eq!(baselines.push(75.0, &[4.0, 5.0], 2.0), [4.0, 5.0]);
    }

    #[test]
    fn rows_that_are_too_many_leave_the_oldest_out() {
        let mut baselines = Baselines::default();
        for k in 0..MOST_ROWS + 10 {
            baselines.push(1e-9 * k as f64, &[k as f64], 2.0);
        }
        assert_eq!(baselines.rows.len(), MOST_ROWS);
        assert_eq!(baselines.sorted[0].len(), MOST_ROWS);
        assert_eq!(baselines.sorted[0][0], 10.0);
    }
}
