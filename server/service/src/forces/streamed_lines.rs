//! Estimates of a stream that doesn't end at its first imperfect row: each row is answered, with its state.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::collections::BTreeMap;

use documents::own_model::csv_cell;
use estimation::estimator::Estimator;
use estimation::live::live_estimates::{Estimated, Live};
use estimation::live::row_state::RowState;
use estimation::live::row_watch::RowWatch;
use estimation::recipe::BadRows;
use estimation::recording::csv_recording::CycleNumbers;
use estimation::recording::recording_fault::{FaultList, RecordingFault};
use estimation::recording::row_reader::{Row, RowReader};

use crate::forces::applying::{Zero, estimates_header, line_of, live_from, row_reader};

/// Line that makes the next row's signals the zero.
const ZERO: &str = "zero";

/// Reads lines of a stream and gives lines of estimates: those of a file, with `state` and `column` behind them.
#[derive(Debug)]
pub struct StreamedLines<'e> {
    estimator: &'e Estimator,
    header: String,
    reader: RowReader,
    live: Live<'e>,
    watch: RowWatch,
    cycles: CycleNumbers,
    /// Whether the next row is the zero.
    is_zero_next: bool,
    /// Cells of forces and `outside` for a row without an estimate.
    held: String,
    counts: BTreeMap<RowState, u64>,
    /// Time of the last row that completed a tick of a clock, s; before the first row minus infinity: rows without one wait for signals that are seldom measured.
    ticked_s: f64,
}

/// The header of a stream's estimates.
pub fn stream_header(estimator: &Estimator) -> String {
    format!("{},state,column\n", estimates_header(estimator).trim_end())
}

impl<'e> StreamedLines<'e> {
    /// Reads the header's line.
    ///
    /// # Errors
    /// Signals that it lacks.
    pub fn new(
        estimator: &'e Estimator,
        file: &str,
        header: &str,
        zero: &Zero,
    ) -> Result<Self, Vec<RecordingFault>> {
        Ok(Self {
            estimator,
            header: header.trim_start_matches('\u{feff}').trim().to_owned(),
            reader: row_reader(estimator, file, header)?,
            live: live_from(estimator, zero),
            watch: RowWatch::new(estimator),
            cycles: CycleNumbers::default(),
            is_zero_next: false,
            held: ",".repeat(3 * estimator.columns.forces.len()),
            counts: BTreeMap::new(),
            ticked_s: f64::NEG_INFINITY,
        })
    }

    /// Answers a line: with a line for each estimate, with one for a row that has none; none for a blank line, and for `zero`.
    pub fn push(&mut self, line: &str) -> String {
        let text = line.trim();
        if text.is_empty() {
            return String::new();
        }
        if text == ZERO {
            self.is_zero_next = true;
            return String::new();
        }
        if text == self.header {
            return self.without_estimate(None, RowState::Header, "");
        }
        let mut faults = FaultList::of("");
        let Some(row) = self.reader.row(1, line, &mut faults) else {
            let column = faults
                .into_faults()
                .into_iter()
                .find_map(|fault| fault.column);
            let (state, column) = match column {
                Some(column) => (RowState::NotANumber, column),
                None => (RowState::Cut, String::new()),
            };
            let time_s = self.reader.time_s(line);
            return self.without_estimate(time_s, state, &column);
        };
        self.answer(row)
    }

    /// Returns how many rows had each state.
    pub fn counts(&self) -> &BTreeMap<RowState, u64> {
        &self.counts
    }

    fn answer(&mut self, row: Row) -> String {
        let state = match self.watch.state(row.time_s) {
            state if !state.is_estimated() => {
                return self.without_estimate(Some(row.time_s), state, "");
            }
            _ if std::mem::take(&mut self.is_zero_next) => RowState::Zero,
            state => state,
        };
        match state {
            RowState::Zero => self.live.zero(),
            RowState::ClockReset | RowState::Gap => self.live.restart(),
            _ => {}
        }
        if state != RowState::Ok || self.ticked_s.is_infinite() {
            self.ticked_s = row.time_s;
        }
        let missing = row.signals.iter().position(|signal| signal.is_nan());
        let cycle = row.cycle.map(|name| self.cycles.next(name));
        let estimated = self.live.push(row.time_s, cycle, &row.signals);
        if !estimated.iter().all(Estimated::is_finite) {
            // Windows would hold it for rows.
            self.live.restart();
            return self.without_estimate(Some(row.time_s), RowState::TooLarge, "");
        }
        if !estimated.is_empty() {
            self.ticked_s = row.time_s;
        } else if row.time_s - self.ticked_s > self.watch.pause_s() {
            // A signal is missing for longer than anything is carried over: what waits for it is dropped.
            self.live.restart();
            self.ticked_s = row.time_s;
            let missing = missing.and_then(|signal| self.estimator.columns.signals.get(signal));
            let column = missing.cloned().unwrap_or_default();
            return self.without_estimate(Some(row.time_s), RowState::NotANumber, &column);
        }
        let state = match estimated.iter().any(|tick| tick.load.is_some()) {
            true => RowState::Loaded,
            false => state,
        };
        *self.counts.entry(state).or_default() += 1;
        let names = &self.estimator.columns.signals;
        let line = |estimated: &Estimated| {
            let line = line_of(estimated);
            let suspect = estimated.suspect.and_then(|signal| names.get(signal));
            let column = csv_cell::line(&[suspect.cloned().unwrap_or_default()]);
            format!("{},{},{column}", line.trim_end(), state.as_str())
        };
        if self.estimator.recipe.preprocess.bad_rows == BadRows::Hold
            && let Some(last) = estimated.last()
        {
            let line = line_of(last);
            let cells = line.trim_end().split_once(',').map(|(_, cells)| cells);
            self.held = cells.unwrap_or_default().to_owned();
        }
        estimated.iter().map(line).collect()
    }

    fn without_estimate(&mut self, time_s: Option<f64>, state: RowState, column: &str) -> String {
        *self.counts.entry(state).or_default() += 1;
        let time = time_s.map_or_else(String::new, |time_s| format!("{time_s:?}"));
        let column = csv_cell::line(&[column.to_owned()]);
        format!("{time},{},{},{column}", self.held, state.as_str())
    }
}
