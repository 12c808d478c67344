//! Features that models are given of the signals, row by row, from this row and earlier ones alone.
//!
//! | feature | formula (the paper's section 4.2) |
//! |---|---|
//! | value | the signal, start value off, sign turned where asked for, averaged over the last N rows |
//! | slope | (v(k) - v(k-1)) / (t(k) - t(k-1)), 1/s |
//! | mean | of the last w values |
//! | variance | of the last w values, divided by w - 1 |
//! | over its baseline | the value less the median of the last s seconds' values: what drifts slowly isn't in it; 0 where no set reads it |
//!
//! A stream begins with a run, and anew after each pause and with each cycle of a column: windows are short there, and the first slope is 0. The start value stays.
//!
//! A start value that isn't known beforehand is the median of the first readings. While they come it is that of those so far, and windows are made anew by it.

mod baselines;

use std::collections::VecDeque;
use std::ops::Range;

use ndarray::Array2;

use self::baselines::Baselines;
use crate::recipe::FeatureSet;
use crate::recording::Recording;
use crate::recording::unloaded::median_reading;

/// Treatment of each row in the stream.
#[derive(Debug, Clone, PartialEq)]
pub struct StreamSettings {
    /// Whether the run's first reading is taken off.
    pub subtract_start: bool,
    /// First readings whose median is the start value.
    pub start_rows: usize,
    /// Whether the sign is turned.
    pub turn_sign: bool,
    /// Rows of the moving average.
    pub smooth_rows: usize,
    /// Rows of rolling mean and variance.
    pub window_rows: usize,
    /// Seconds of the baseline's median; `None` where nothing reads what is over it.
    pub baseline_s: Option<f64>,
    /// Longest time between rows over which something is carried, s.
    pub pause_s: f64,
}

/// Groups of features: values, slopes, rolling means, rolling variances, values over their baseline.
pub const GROUPS: usize = 5;
/// The group of values.
pub(crate) const VALUES: usize = 0;
/// The group of rolling means.
const MEANS: usize = 2;

/// Features of a run's rows, one after another.
#[derive(Debug, Clone)]
pub struct FeatureStream {
    settings: StreamSettings,
    start: Option<Vec<f64>>,
    /// First readings, of which the start value is made; none once it is known.
    settling: Option<Settling>,
    /// Signals without a force as they were learnt, where a start is given though none is taken off: it counts by how far it is from these.
    learnt_zero: Option<Vec<f64>>,
    /// The last row: its time and cycle, its value of each signal.
    last: Option<(f64, Option<usize>, Vec<f64>)>,
    readings: VecDeque<Vec<f64>>,
    values: VecDeque<Vec<f64>>,
    baselines: Baselines,
}

/// First readings of a run, until there are enough of them.
#[derive(Debug, Clone, Default)]
struct Settling {
    readings: Vec<Vec<f64>>,
    /// Times and cycles of the last of them: those since the last begin.
    rows: Vec<(f64, Option<usize>)>,
}

impl FeatureStream {
    /// A run's stream, before its first row.
    pub fn new(settings: StreamSettings) -> Self {
        Self {
            settings,
            start: None,
            settling: Some(Settling::default()),
            learnt_zero: None,
            last: None,
            readings: VecDeque::new(),
            values: VecDeque::new(),
            baselines: Baselines::default(),
        }
    }

    /// All features of the next row, group by group, each with an entry a signal.
    pub fn push(&mut self, time_s: f64, cycle: Option<usize>, signals: &[f64]) -> Vec<f64> {
        let has_zero = self.settings.subtract_start || self.learnt_zero.is_some();
        match self.settling.take().filter(|_| has_zero) {
            Some(settling) => self.settle(settling, (time_s, cycle), signals),
            None => self.row(time_s, cycle, signals),
        }
    }

    /// Takes one more reading for the start value, and brings the rows before to it.
    fn settle(
        &mut self,
        mut settling: Settling,
        row: (f64, Option<usize>),
        signals: &[f64],
    ) -> Vec<f64> {
        settling.readings.push(signals.to_vec());
        settling.rows.push(row);
        self.start = Some(median_reading(signals.len(), &settling.readings));
        self.clear_windows();
        let before = settling.readings.len() - settling.rows.len();
        let mut last = Vec::new();
        for ((time_s, cycle), signals) in settling.rows.iter().zip(&settling.readings[before..]) {
            last = self.row(*time_s, *cycle, signals);
        }
        if settling.readings.len() < self.settings.start_rows {
            self.settling = Some(settling);
        }
        last
    }

    fn row(&mut self, time_s: f64, cycle: Option<usize>, signals: &[f64]) -> Vec<f64> {
        let apart = |(last, before, _): &(f64, Option<usize>, Vec<f64>)| {
            time_s - last > self.settings.pause_s || *before != cycle
        };
        if self.last.as_ref().is_some_and(apart) {
            self.clear_windows();
        }
        let reading = self.reading(signals);
        keep(&mut self.readings, reading, self.settings.smooth_rows);
        let value = means(&self.readings);
        let slope = self.slope(time_s, &value);
        keep(&mut self.values, value.clone(), self.settings.window_rows);
        let mean = means(&self.values);
        let variance = variances(&self.values, &mean);
        let over = self.over_baseline(time_s, &value);
        self.last = Some((time_s, cycle, value.clone()));
        [value, slope, mean, variance, over].concat()
    }

    /// Begins anew, as after a pause: the start value stays.
    pub fn restart(&mut self) {
        if let Some(settling) = &mut self.settling {
            settling.rows.clear();
        }
        self.clear_windows();
    }

    fn clear_windows(&mut self) {
        self.last = None;
        self.readings.clear();
        self.values.clear();
        self.baselines.clear();
    }

    /// Takes these signals for the start value; none: those of the next rows. Where no start is taken off, `learnt` is what they were when they were learnt.
    pub(crate) fn start_at(&mut self, start: Option<Vec<f64>>, learnt: Option<&Vec<f64>>) {
        self.settling = start.is_none().then(Settling::default);
        self.start = start;
        self.learnt_zero = learnt.cloned();
    }

    /// Whether the next row is the first whose signals will be taken for the zero.
    pub(crate) fn is_zero_next(&self) -> bool {
        self.start.is_none() && (self.settings.subtract_start || self.learnt_zero.is_some())
    }

    fn reading(&self, signals: &[f64]) -> Vec<f64> {
        let sign = if self.settings.turn_sign { -1.0 } else { 1.0 };
        let off = |signal: usize| match (&self.start, &self.learnt_zero) {
            (Some(start), _) if self.settings.subtract_start => start[signal],
            (Some(start), Some(learnt)) => start[signal] - learnt[signal],
            _ => 0.0,
        };
        let signals = signals.iter().enumerate();
        signals.map(|(k, x)| sign * (x - off(k))).collect()
    }

    fn slope(&self, time_s: f64, value: &[f64]) -> Vec<f64> {
        match &self.last {
            Some((last, _, before)) => value
                .iter()
                .zip(before)
                .map(|(x, before)| (x - before) / (time_s - last))
                .collect(),
            None => vec![0.0; value.len()],
        }
    }

    fn over_baseline(&mut self, time_s: f64, value: &[f64]) -> Vec<f64> {
        let Some(seconds) = self.settings.baseline_s else {
            return vec![0.0; value.len()];
        };
        let medians = self.baselines.push(time_s, value, seconds);
        value.iter().zip(medians).map(|(x, of)| x - of).collect()
    }
}

fn keep(rows: &mut VecDeque<Vec<f64>>, row: Vec<f64>, most: usize) {
    rows.push_back(row);
    while rows.len() > most.max(1) {
        rows.pop_front();
    }
}

/// The mean of each column.
fn means(rows: &VecDeque<Vec<f64>>) -> Vec<f64> {
    let mut sums = vec![0.0; rows.front().map_or(0, Vec::len)];
    for row in rows {
        for (sum, x) in sums.iter_mut().zip(row) {
            *sum += x;
        }
    }
    sums.into_iter()
        .map(|sum| sum / rows.len() as f64)
        .collect()
}

fn variances(rows: &VecDeque<Vec<f64>>, mean: &[f64]) -> Vec<f64> {
    let mut sums = vec![0.0; mean.len()];
    for row in rows {
        for ((sum, x), mean) in sums.iter_mut().zip(row).zip(mean) {
            *sum += (x - mean) * (x - mean);
        }
    }
    let degrees = rows.len().saturating_sub(1).max(1) as f64;
    sums.into_iter().map(|sum| sum / degrees).collect()
}

/// All features of a recording: rows x (groups of `signals` columns). `start`: what is taken off instead of the first reading.
pub(crate) fn features(
    recording: &Recording,
    settings: &StreamSettings,
    start: Option<Vec<f64>>,
) -> Array2<f64> {
    let mut stream = FeatureStream::new(settings.clone());
    stream.start_at(start, None);
    let signals = recording.signals.ncols();
    let mut found = Array2::zeros((recording.rows(), GROUPS * signals));
    for (row, time_s) in recording.time_s.iter().enumerate() {
        let cycle = recording.cycle.as_ref().map(|cycle| cycle[row]);
        let here = stream.push(*time_s, cycle, &recording.signals.row(row).to_vec());
        found
            .row_mut(row)
            .iter_mut()
            .zip(here)
            .for_each(|(place, x)| *place = x);
    }
    found
}

/// Moves a row of all features as an offset of its signals does, one each: values and rolling means; slopes, variances and what is over a baseline don't know it.
pub(crate) fn move_signals(features: &mut [f64], offsets: impl IntoIterator<Item = f64>) {
    let signals = features.len() / GROUPS;
    for (signal, offset) in offsets.into_iter().enumerate() {
        for group in [VALUES, MEANS] {
            features[group * signals + signal] += offset;
        }
    }
}

/// The columns of a set among all features of so many signals.
pub fn columns(set: FeatureSet, signals: usize) -> impl Iterator<Item = usize> {
    let group = move |number: &usize| -> Range<usize> { number * signals..(number + 1) * signals };
    let groups: &'static [usize] = match set {
        FeatureSet::Raw => &[0],
        FeatureSet::Baseline => &[4],
        FeatureSet::Slopes => &[0, 1],
        FeatureSet::Rolling => &[0, 2, 3],
        FeatureSet::All => &[0, 1, 2, 3],
        FeatureSet::Whole => &[0, 1, 2, 3, 4],
    };
    groups.iter().flat_map(group)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settings() -> StreamSettings {
        StreamSettings {
            subtract_start: true,
            start_rows: 1,
            turn_sign: false,
            smooth_rows: 1,
            window_rows: 3,
            baseline_s: None,
            pause_s: 1.0,
        }
    }

    fn pushed(settings: StreamSettings, rows: &[(f64, Option<usize>, f64)]) -> Vec<Vec<f64>> {
        let mut stream = FeatureStream::new(settings);
        rows.iter()
            .map(|(t, cycle, x)| stream.push(*t, *cycle, &[*x]))
            .collect()
    }

    #[test]
    fn windows_hold_what_was_and_end_at_pauses_and_cycles() {
        let rows = [
            (0.0, Some(0), 10.0),
            (0.5, Some(0), 12.0),
            (1.0, Some(0), 17.0),
            (1.5, Some(0), 18.0),
            (3.0, Some(0), 11.0),
            (3.5, Some(1), 14.0),
        ];
        let found = pushed(settings(), &rows);
        assert_eq!(found[0], [0.0; GROUPS]);
        assert_eq!(found[1], [2.0, 4.0, 1.0, 2.0, 0.0]);
        // Mean of 2, 7, 8; variance (121 + 16 + 49) / 9 / 2.
        let expected = [8.0, 2.0, 17.0 / 3.0, 31.0 / 3.0];
        for (x, expected) in found[3].iter().zip(expected) {
            assert!((x - expected).abs() < 1e-14, "{x} {expected}");
        }
        // After the pause and with the new cycle windows begin anew; the run's start value stays.
        assert_eq!(found[4], [1.0, 0.0, 1.0, 0.0, 0.0]);
        assert_eq!(found[5], [4.0, 0.0, 4.0, 0.0, 0.0]);
    }

    #[test]
    fn a_start_value_of_several_readings_is_their_median_as_they_come() {
        let rows: Vec<_> = [10.0, 16.0, 11.0, 12.0, 20.0]
            .into_iter()
            .enumerate()
            .map(|(k, x)| (0.5 * k as f64, None, x))
            .collect();
        let found = pushed(
            StreamSettings {
                start_rows: 3,
                ..settings()
            },
            &rows,
        );
        // Medians 10, 16, 11: the upper one of two. Means and variances are those of one start value, and slopes know none.
        let values: Vec<f64> = found.iter().map(|row| row[0]).collect();
        assert_eq!(values, [0.0, 0.0, 0.0, 1.0, 9.0]);
        let slopes: Vec<f64> = found.iter().map(|row| row[1]).collect();
        assert_eq!(slopes, [0.0, 12.0, -10.0, 2.0, 16.0]);
        let means: Vec<f64> = found.iter().map(|row| row[2]).collect();
        assert_eq!(means, [0.0, -3.0, 4.0 / 3.0, 2.0, 10.0 / 3.0]);
        // Once they are there all is as by a known one.
        let mut known = FeatureStream::new(settings());
        known.start_at(Some(vec![11.0]), None);
        let by_known = rows
            .iter()
            .map(|(t, cycle, x)| known.push(*t, *cycle, &[*x]));
        assert_eq!(found[2..], by_known.collect::<Vec<_>>()[2..]);
    }

    #[test]
    fn a_begin_while_the_start_value_settles_keeps_its_readings_and_no_window() {
        let mut stream = FeatureStream::new(StreamSettings {
            start_rows: 3,
            ..settings()
        });
        stream.push(5.0, None, &[10.0]);
        stream.push(5.5, None, &[12.0]);
        // A clock that was set back: what was before it is in no window.
        stream.restart();
        assert_eq!(stream.push(0.0, None, &[11.0]), [0.0; GROUPS]);
        assert_eq!(stream.push(0.5, None, &[13.0])[..2], [2.0, 4.0]);
    }

    #[test]
    fn later_rows_change_nothing() {
        let rows: Vec<_> = (0..40)
            .map(|k| (0.1 * f64::from(k), None, (f64::from(k) * 0.7).sin()))
            .collect();
        let smooth = StreamSettings {
            smooth_rows: 4,
            baseline_s: Some(0.5),
            ..settings()
        };
        let all = pushed(smooth.clone(), &rows);
        let some = pushed(smooth, &rows[..17]);
        assert_eq!(all[..17], some[..]);
    }

    #[test]
    fn signs_turn_and_averages_are_those_of_the_last_rows() {
        let other = StreamSettings {
            subtract_start: false,
            turn_sign: true,
            smooth_rows: 2,
            ..settings()
        };
        let found = pushed(
            other,
            &[(0.0, None, 1.0), (0.5, None, 3.0), (1.0, None, 7.0)],
        );
        let values: Vec<f64> = found.iter().map(|row| row[0]).collect();
        assert_eq!(values, [-1.0, -2.0, -5.0]);
    }

    #[test]
    fn a_drift_is_not_in_what_is_over_its_baseline() {
        // Touched for a fifth of each second, on a drift of 3 a second from 40.
        let touch = |k: u32| f64::from(u8::from(k % 100 < 20));
        let row = |k: u32| {
            let time_s = 0.01 * f64::from(k);
            (time_s, None, 40.0 + 3.0 * time_s + 10.0 * touch(k))
        };
        let rows: Vec<_> = (0..600).map(row).collect();
        let baseline = StreamSettings {
            subtract_start: false,
            baseline_s: Some(1.0),
            ..settings()
        };
        let found = pushed(baseline, &rows);
        for (k, row) in found.iter().enumerate().skip(100) {
            // The median lies within a second of drift below the value that it would have untouched.
            let over = row[4] - 10.0 * touch(k as u32);
            assert!((0.0..=3.0).contains(&over), "{k} {over}");
            assert!(row[0] > 43.0);
        }
    }

    #[test]
    fn sets_pick_their_groups() {
        let read = |set: FeatureSet, signals: usize| columns(set, signals).collect::<Vec<_>>();
        assert_eq!(read(FeatureSet::Raw, 2), [0, 1]);
        assert_eq!(read(FeatureSet::Slopes, 2), [0, 1, 2, 3]);
        assert_eq!(read(FeatureSet::Rolling, 2), [0, 1, 4, 5, 6, 7]);
        assert_eq!(read(FeatureSet::All, 2).len(), 8);
        assert_eq!(read(FeatureSet::Baseline, 2), [8, 9]);
        assert_eq!(read(FeatureSet::Whole, 2).len(), 10);
    }
}
