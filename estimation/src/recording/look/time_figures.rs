//! Length, rate and gaps of a recording.

use crate::recording::{PAUSE_INTERVALS, Recording};

/// Figures of a recording's time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TimeFigures {
    /// Time from the first row to the last, s.
    pub duration_s: f64,
    /// Rows a second; none of one row.
    pub rate_hz: Option<f64>,
    /// Intervals longer than ten typical ones.
    pub gaps: usize,
    /// The longest of them.
    pub longest: Option<Gap>,
}

/// Time without a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// Length, s.
    pub seconds: f64,
    /// Row before it, from 0.
    pub row: usize,
}

impl TimeFigures {
    /// Figures of a recording.
    pub fn of(run: &Recording) -> Self {
        let gaps = gaps(run);
        let longer = |a: &&Gap, b: &&Gap| a.seconds.total_cmp(&b.seconds);
        let ends = run.time_s.first().zip(run.time_s.last());
        Self {
            duration_s: ends.map_or(0.0, |(first, last)| last - first),
            rate_hz: run.interval_s().map(f64::recip),
            gaps: gaps.len(),
            longest: gaps.iter().max_by(longer).copied(),
        }
    }
}

/// Intervals longer than ten typical ones, in the order of time.
pub fn gaps(run: &Recording) -> Vec<Gap> {
    let longest_usual = PAUSE_INTERVALS * run.interval_s().unwrap_or(f64::INFINITY);
    let times = run.time_s.iter().zip(run.time_s.iter().skip(1));
    let intervals = times.enumerate().map(|(row, (before, after))| Gap {
        seconds: after - before,
        row,
    });
    intervals
        .filter(|gap| gap.seconds > longest_usual)
        .collect()
}

#[cfg(test)]
mod tests {
    use ndarray::Array2;

    use super::*;

    fn run(time_s: Vec<f64>) -> Recording {
        Recording {
            name: "r".to_owned(),
            signals: Array2::zeros((time_s.len(), 1)),
            forces: Array2::zeros((time_s.len(), 0)),
            time_s,
            cycle: None,
        }
    }

    #[test]
    fn gaps_are_longer_than_ten_typical_intervals() {
        let mut time_s: Vec<f64> = (0..20).map(|row| 0.5 * f64::from(row)).collect();
        time_s.extend([14.5, 15.0, 15.5, 25.5, 26.0]);
        let found = TimeFigures::of(&run(time_s));
        // Five seconds are ten intervals, and no gap.
        assert_eq!((found.duration_s, found.gaps), (26.0, 1));
        assert_eq!(
            found.longest,
            Some(Gap {
                seconds: 10.0,
                row: 22
            })
        );
        let rate = found.rate_hz.unwrap_or(0.0);
        assert!((rate - 23.0 / 16.0).abs() < 1e-12, "{rate}");
    }

    #[test]
    fn one_row_has_no_rate() {
        assert_eq!(TimeFigures::of(&run(vec![3.0])), TimeFigures::default());
        assert_eq!(TimeFigures::of(&run(Vec::new())), TimeFigures::default());
    }
}
