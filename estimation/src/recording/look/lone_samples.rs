//! Samples that stand alone: away from both neighbours by far more than neighbours differ, with nothing going on beside them.

use super::column_figures::{measured, step_deviation};

/// Robust deviations of the differences between neighbours by which a lone sample differs from both.
const FAR: f64 = 20.0;
/// Share of its height by which its neighbours may differ from each other, and from theirs: it returns, and nothing else happens.
const STILL: f64 = 0.25;

/// Rows whose samples stand alone. First and last ones have one neighbour, which tells nothing.
pub fn lone_samples(values: &[f64]) -> Vec<usize> {
    let known: Vec<(usize, f64)> = measured(values).collect();
    let numbers: Vec<f64> = known.iter().map(|(_, value)| *value).collect();
    let far = FAR * step_deviation(&numbers);
    let mut found = Vec::new();
    for (at, window) in known.windows(3).enumerate() {
        let [(_, before), (row, value), (_, after)] = window else {
            continue;
        };
        let (up, down) = (value - before, value - after);
        let height = up.abs().min(down.abs());
        let is_far = up * down > 0.0 && height > far;
        if !is_far {
            continue;
        }
        let step = |first: usize| Some((numbers.get(first + 1)? - numbers.get(first)?).abs());
        let beside = [
            at.checked_sub(1).and_then(step),
            step(at + 2),
            Some((after - before).abs()),
        ];
        if beside
            .into_iter()
            .flatten()
            .all(|step| step <= STILL * height)
        {
            found.push(*row);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wave(row: u32) -> f64 {
        (0.1 * f64::from(row)).sin()
    }

    #[test]
    fn one_sample_that_returns_stands_alone() {
        let mut values: Vec<f64> = (0..200).map(wave).collect();
        assert!(lone_samples(&values).is_empty());
        for (row, off) in [(50, 9.0), (120, -4.0)] {
            values[row] += off;
        }
        assert_eq!(lone_samples(&values), [50, 120]);
        // A value that wasn't measured is no neighbour.
        values[51] = f64::NAN;
        assert_eq!(lone_samples(&values), [50, 120]);
    }

    #[test]
    fn steps_pulses_of_more_rows_and_ends_do_not() {
        let level = |high: std::ops::Range<u32>| -> Vec<f64> {
            (0..200)
                .map(|row| wave(row) + if high.contains(&row) { 9.0 } else { 0.0 })
                .collect()
        };
        for high in [60..200, 60..62, 0..1, 199..200] {
            assert!(lone_samples(&level(high.clone())).is_empty(), "{high:?}");
        }
        assert!(lone_samples(&[]).is_empty() && lone_samples(&[1.0; 40]).is_empty());
    }

    #[test]
    fn a_column_with_few_digits_is_judged_by_its_steps() {
        // Stands still but for steps of 1; one of 30 is none of them.
        let mut values: Vec<f64> = (0..200).map(|row| f64::from(row / 10 % 5)).collect();
        assert!(lone_samples(&values).is_empty());
        values[95] += 40.0;
        assert_eq!(lone_samples(&values), [95]);
    }
}
