//! Linear interpolation to one clock.
//!
//! Between two measured values x_j at t_j and x_(j+1) at t_(j+1), x(t) = x_j + (t - t_j)/(t_(j+1) - t_j) (x_(j+1) - x_j)
//! (the paper's section 4.1). Nothing is interpolated over a pause.

use std::collections::VecDeque;

use ndarray::{Array2, ArrayView1};

use crate::recording::Recording;

/// A row on the clock.
#[derive(Debug, Clone, PartialEq)]
pub struct Tick {
    /// s
    pub time_s: f64,
    /// Cycle of the last row before it.
    pub cycle: Option<usize>,
    /// Values, one a signal.
    pub signals: Vec<f64>,
}

/// Brings rows to a clock of so many ticks a second, one after another. It begins anew after each pause.
#[derive(Debug, Clone)]
pub(crate) struct Clock {
    rate_hz: f64,
    pause_s: f64,
    /// Time at which the clock began, s, and ticks since then.
    begun: Option<(f64, u64)>,
    last_s: f64,
    /// Measured values of each signal from the last one before the next tick on.
    known: Vec<VecDeque<(f64, f64)>>,
    cycles: VecDeque<(f64, Option<usize>)>,
}

impl Clock {
    /// A clock before the first row.
    pub fn new(rate_hz: f64, pause_s: f64, signals: usize) -> Self {
        Self {
            rate_hz,
            pause_s,
            begun: None,
            last_s: 0.0,
            known: vec![VecDeque::new(); signals],
            cycles: VecDeque::new(),
        }
    }

    /// Begins anew with the next row, as after a pause.
    pub fn restart(&mut self) {
        self.begun = None;
    }

    /// The ticks that a row completes: those up to the latest time at which every signal is known. Signals that are NaN weren't measured.
    pub fn push(&mut self, time_s: f64, cycle: Option<usize>, signals: &[f64]) -> Vec<Tick> {
        if self.begun.is_none() || time_s - self.last_s > self.pause_s {
            self.begun = Some((time_s, 0));
            self.known.iter_mut().for_each(VecDeque::clear);
            self.cycles.clear();
        }
        self.last_s = time_s;
        self.cycles.push_back((time_s, cycle));
        for (known, x) in self.known.iter_mut().zip(signals) {
            if x.is_finite() {
                known.push_back((time_s, *x));
            }
        }
        let mut ticks = Vec::new();
        while let Some((first, tick)) = self.begun {
            let t = first + tick as f64 / self.rate_hz;
            let last =
                |known: &VecDeque<(f64, f64)>| known.back().is_some_and(|(last, _)| *last >= t);
            if !self.known.iter().all(last) {
                break;
            }
            self.begun = Some((first, tick + 1));
            ticks.extend(self.tick(t));
        }
        ticks
    }

    /// The values at a time; None before a signal's first one.
    fn tick(&mut self, t: f64) -> Option<Tick> {
        for known in &mut self.known {
            while known.get(1).is_some_and(|(next, _)| *next <= t) {
                known.pop_front();
            }
        }
        while self.cycles.get(1).is_some_and(|(next, _)| *next <= t) {
            self.cycles.pop_front();
        }
        let signals: Option<Vec<f64>> = self.known.iter().map(|known| at(known, t)).collect();
        Some(Tick {
            time_s: t,
            cycle: self.cycles.front().and_then(|(_, cycle)| *cycle),
            signals: signals?,
        })
    }
}

fn at(known: &VecDeque<(f64, f64)>, t: f64) -> Option<f64> {
    match (known.front()?, known.get(1)) {
        ((t0, x0), _) if *t0 == t => Some(*x0),
        ((t0, x0), Some((t1, x1))) if *t0 < t => Some(x0 + (t - t0) / (t1 - t0) * (x1 - x0)),
        _ => None,
    }
}

/// A recording on a clock. Forces are interpolated between their own neighbours, and aren't known before the first or after the last of a piece.
pub fn aligned(recording: &Recording, rate_hz: f64, pause_s: f64) -> Recording {
    let mut clock = Clock::new(rate_hz, pause_s, recording.signals.ncols());
    let mut ticks = Vec::new();
    for (row, time_s) in recording.time_s.iter().enumerate() {
        let cycle = recording.cycle.as_ref().map(|cycle| cycle[row]);
        ticks.extend(clock.push(*time_s, cycle, &recording.signals.row(row).to_vec()));
    }
    let mut forces = Array2::from_elem((ticks.len(), recording.forces.ncols()), f64::NAN);
    for (column, mut out) in recording
        .forces
        .columns()
        .into_iter()
        .zip(forces.columns_mut())
    {
        let between = Neighbours::new(recording, column, pause_s);
        ticks
            .iter()
            .zip(&mut out)
            .for_each(|(tick, place)| *place = between.at(tick.time_s));
    }
    let mut signals = Array2::zeros((ticks.len(), recording.signals.ncols()));
    for (tick, mut row) in ticks.iter().zip(signals.rows_mut()) {
        row.iter_mut()
            .zip(&tick.signals)
            .for_each(|(place, x)| *place = *x);
    }
    Recording {
        name: recording.name.clone(),
        time_s: ticks.iter().map(|tick| tick.time_s).collect(),
        signals,
        forces,
        cycle: recording
            .cycle
            .as_ref()
            .and_then(|_| ticks.iter().map(|tick| tick.cycle).collect()),
    }
}

/// A force's measured values, piece by piece.
struct Neighbours {
    /// Time, value, number of the piece.
    known: Vec<(f64, f64, usize)>,
}

impl Neighbours {
    fn new(recording: &Recording, column: ArrayView1<'_, f64>, pause_s: f64) -> Self {
        let numbered = pieces(&recording.time_s, pause_s).into_iter().enumerate();
        let rows = numbered.flat_map(|(number, piece)| piece.map(move |row| (row, number)));
        let known = rows.map(|(row, number)| (recording.time_s[row], column[row], number));
        Self {
            known: known.filter(|(_, x, _)| x.is_finite()).collect(),
        }
    }

    fn at(&self, t: f64) -> f64 {
        let after = self.known.partition_point(|(time, ..)| *time < t);
        match (
            after
                .checked_sub(1)
                .and_then(|before| self.known.get(before)),
            self.known.get(after),
        ) {
            (_, Some((time, x, _))) if *time == t => *x,
            (Some((t0, x0, before)), Some((t1, x1, next))) if before == next => {
                x0 + (t - t0) / (t1 - t0) * (x1 - x0)
            }
            _ => f64::NAN,
        }
    }
}

/// Rows between pauses.
pub fn pieces(time_s: &[f64], pause_s: f64) -> Vec<std::ops::Range<usize>> {
    let mut found = Vec::new();
    let mut begin = 0;
    for row in 1..=time_s.len() {
        if row == time_s.len() || time_s[row] - time_s[row - 1] > pause_s {
            found.push(begin..row);
            begin = row;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::array;

    #[test]
    fn lines_stay_lines_and_pauses_stay_empty() {
        let recording = Recording {
            name: "r".to_owned(),
            time_s: vec![0.0, 0.3, 1.0, 5.0, 5.5],
            signals: array![[0.0], [0.3], [1.0], [5.0], [5.5]],
            forces: array![[f64::NAN], [3.0], [10.0], [50.0], [f64::NAN]],
            cycle: Some(vec![0, 0, 1, 2, 2]),
        };
        let found = aligned(&recording, 4.0, 1.0);
        assert_eq!(found.time_s, [0.0, 0.25, 0.5, 0.75, 1.0, 5.0, 5.25, 5.5]);
        for (t, x) in found.time_s.iter().zip(found.signals.column(0)) {
            assert!((t - x).abs() < 1e-15, "{t} {x}");
        }
        let known: Vec<bool> = found.forces.iter().map(|f| f.is_finite()).collect();
        assert_eq!(known, [false, false, true, true, true, true, false, false]);
        assert!((found.forces[[2, 0]] - 5.0).abs() < 1e-14);
        assert_eq!(found.cycle, Some(vec![0, 0, 0, 0, 1, 2, 2, 2]));
    }

    #[test]
    fn signals_of_other_clocks_are_brought_together() {
        let nan = f64::NAN;
        let recording = Recording {
            name: "r".to_owned(),
            time_s: vec![0.0, 0.1, 0.2, 0.3, 0.4],
            signals: array![[0.0, nan], [nan, 1.0], [2.0, nan], [nan, 3.0], [4.0, nan]],
            forces: array![[1.0], [1.0], [1.0], [1.0], [1.0]],
            cycle: None,
        };
        let found = aligned(&recording, 10.0, 1.0);
        // Before the second signal's first value and after its last one there is nothing to interpolate.
        assert_eq!(found.rows(), 3);
        for (row, expected) in found.signals.rows().into_iter().zip([1.0, 2.0, 3.0]) {
            assert!(row.iter().all(|x| (x - expected).abs() < 1e-12), "{row}");
        }
    }
}
