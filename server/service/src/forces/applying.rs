//! Estimates of a recording: whole, or row by row as its lines come in.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::fmt::Write as _;
use std::sync::atomic::{AtomicBool, Ordering};

use documents::own_model::csv_cell;
use estimation::estimator::Estimator;
use estimation::live::live_estimates::{Estimated, Live, Load};
use estimation::live::row_watch::{MOST_TICKS, RATE_ROWS, is_other_rate};
use estimation::recording::csv_recording::{
    CycleNumbers, check_time, header, header_names, read_rows,
};
use estimation::recording::dialect::usual;
use estimation::recording::recording_fault::{FaultList, RecordingFault};
use estimation::recording::row_reader::RowReader;
use estimation::recording::typical_interval;
use estimation::recording::unloaded;

/// Reads lines of a recording and gives lines of estimates.
#[derive(Debug)]
pub struct EstimatedLines<'e> {
    estimator: &'e Estimator,
    file: String,
    reader: RowReader,
    live: Live<'e>,
    line: usize,
    last_s: Option<f64>,
    cycles: CycleNumbers,
    /// The first intervals, s, until the rate is known.
    intervals: Vec<f64>,
    /// Ticks of the model's clock that came since the last estimate.
    ticks: f64,
    /// Load under which the recording begins.
    load: Option<Load>,
}

/// The header of estimates: `time_s`, each force with its interval, `outside`.
pub fn estimates_header(estimator: &Estimator) -> String {
    let of_force = |force: &String| ["", "_low", "_high"].map(|end| format!("{force}{end}"));
    let mut names = vec!["time_s".to_owned()];
    names.extend(estimator.columns.forces.iter().flat_map(of_force));
    names.push("outside".to_owned());
    csv_cell::line(&names)
}

/// A reader of the rows below a header.
///
/// # Errors
/// Signals that it lacks.
pub(super) fn row_reader(
    estimator: &Estimator,
    file: &str,
    header: &str,
) -> Result<RowReader, Vec<RecordingFault>> {
    let mut faults = FaultList::of(file);
    let names = header_names(header.trim_start_matches('\u{feff}'), &mut faults);
    if faults.is_empty() {
        estimator.columns.check_unlabelled(&names, &mut faults);
    }
    let unlabelled = estimator.columns.unlabelled(&names);
    let reader = RowReader::new(&unlabelled, &names, estimator.stream.rate_hz.is_some());
    match reader {
        Some(reader) if faults.is_empty() => Ok(reader),
        _ => Err(faults.into_faults()),
    }
}

impl<'e> EstimatedLines<'e> {
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
            file: file.to_owned(),
            reader: row_reader(estimator, file, header)?,
            live: live_from(estimator, zero),
            line: 1,
            last_s: None,
            cycles: CycleNumbers::default(),
            intervals: Vec::new(),
            ticks: 0.0,
            load: None,
        })
    }

    /// Estimates from a line: a line for each estimate, none for a blank line.
    ///
    /// # Errors
    /// The line's faults; a rate unlike those that were learnt from, once enough lines tell it.
    pub fn push(&mut self, line: &str) -> Result<String, Vec<RecordingFault>> {
        self.line += 1;
        if line.trim().is_empty() {
            return Ok(String::new());
        }
        let mut faults = FaultList::of(&self.file);
        let row = self.reader.row(self.line, line, &mut faults);
        if let Some(row) = &row {
            check_time(
                row.time_s,
                self.last_s,
                self.line,
                &self.estimator.columns.time,
                &mut faults,
            );
        }
        let Some(row) = row.filter(|_| faults.is_empty()) else {
            return Err(faults.into_faults());
        };
        self.check_rate(row.time_s)?;
        self.check_ticks(row.time_s)?;
        self.last_s = Some(row.time_s);
        let cycle = row.cycle.map(|name| self.cycles.next(name));
        let estimated = self.live.push(row.time_s, cycle, &row.signals);
        if !estimated.iter().all(Estimated::is_finite) {
            let detail = "has no finite estimate: signals or the model's numbers are too large";
            faults.add(Some(self.line), None, detail);
            return Err(faults.into_faults());
        }
        if !estimated.is_empty() {
            self.ticks = 0.0;
        }
        self.load = self.load.or(estimated.iter().find_map(|tick| tick.load));
        Ok(estimated.iter().map(line_of).collect())
    }

    /// Says under which load it begins, where one is taken for nothing.
    pub fn begins_loaded(&self) -> Option<String> {
        let Load { force, load_n } = self.load?;
        let name = self.estimator.columns.forces.get(force)?.escape_debug();
        Some(format!(
            "{}: it begins under some {load_n:.3} N of {name} by the zero of the model, and that is taken for nothing: begin unloaded, or give a recording at rest as the zero",
            self.file
        ))
    }

    /// Refuses a row that would complete any number of ticks at once: two rows far apart make as many as they like.
    fn check_ticks(&mut self, time_s: f64) -> Result<(), Vec<RecordingFault>> {
        let stream = &self.estimator.stream;
        let (Some(last), Some(rate_hz)) = (self.last_s, stream.rate_hz) else {
            return Ok(());
        };
        let gap = time_s - last;
        self.ticks = if gap > stream.pause_s {
            0.0
        } else {
            self.ticks + gap * rate_hz
        };
        if self.ticks <= MOST_TICKS {
            return Ok(());
        }
        let mut faults = FaultList::of(&self.file);
        let detail = format!(
            "{:.0} ticks of the model's clock come between estimates; at most {MOST_TICKS} may: leave out rows before the gap, or signals that are seldom measured",
            self.ticks
        );
        self.ticks = 0.0;
        faults.add(Some(self.line), None, detail);
        Err(faults.into_faults())
    }

    fn check_rate(&mut self, time_s: f64) -> Result<(), Vec<RecordingFault>> {
        let Some(last) = self.last_s.filter(|_| self.intervals.len() < RATE_ROWS) else {
            return Ok(());
        };
        self.intervals.push(time_s - last);
        if self.intervals.len() < RATE_ROWS {
            return Ok(());
        }
        let found = typical_interval(&self.intervals).unwrap_or_default();
        let (least, greatest) = self.estimator.interval_s;
        if is_other_rate(found, (least, greatest)) && self.estimator.stream.rate_hz.is_none() {
            let mut faults = FaultList::of(&self.file);
            let detail = format!(
                "has {:.4} rows a second; the model was learnt from {:.4} to {:.4}: another rate needs a model of its own, or a recipe with rate_hz",
                found.recip(),
                greatest.recip(),
                least.recip()
            );
            faults.add(None, None, detail);
            return Err(faults.into_faults());
        }
        Ok(())
    }
}

/// All numbers with the fewest digits that read back bit for bit.
pub(super) fn line_of(estimated: &Estimated) -> String {
    let mut line = format!("{:?}", estimated.time_s);
    for estimate in &estimated.forces {
        // Writing to a text can't fail.
        let _ = write!(
            line,
            ",{:?},{:?},{:?}",
            estimate.force, estimate.low, estimate.high
        );
    }
    let _ = writeln!(line, ",{}", u8::from(estimated.outside));
    line
}

/// Zero of the signals that are estimated from.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Zero {
    /// Zero that the model learnt to take: the first row's signals, or none.
    #[default]
    AsLearnt,
    /// The first row's signals.
    First,
    /// Signals that are known to be it, one each.
    Known(Vec<f64>),
}

/// Estimates from a stream's first row on.
pub(super) fn live_from<'e>(estimator: &'e Estimator, zero: &Zero) -> Live<'e> {
    let mut live = Live::new(estimator);
    match zero {
        Zero::AsLearnt => {}
        Zero::First => live.zero(),
        Zero::Known(zero) => live.start_at(zero.clone()),
    }
    live
}

/// The zero of a recording: its signals' medians where no force acts, or over all rows of one without forces.
///
/// # Errors
/// Its faults; that none of its rows is unloaded.
pub fn measured_zero(
    estimator: &Estimator,
    file: &str,
    text: &str,
) -> Result<Vec<f64>, Vec<RecordingFault>> {
    let text = &usual(text);
    let names = header(file, text)?;
    let mut faults = FaultList::of(file);
    estimator.columns.check_unlabelled(&names, &mut faults);
    if !faults.is_empty() {
        return Err(faults.into_faults());
    }
    let gaps = estimator.stream.rate_hz.is_some();
    let there = estimator.columns.among(&names);
    let run = read_rows(file, text, &there, &names, gaps)?;
    let zero = unloaded::zero(&run);
    zero.ok_or_else(|| {
        let detail = "has no row whose forces are below a twentieth of their largest, as the zero needs; of a recording at rest leave the forces out";
        faults.add(None, None, detail);
        faults.into_faults()
    })
}

/// Estimates of a recording.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Estimates {
    /// CSV with a header.
    pub csv: String,
    /// Load under which the recording begins, a sentence, where one is taken for nothing.
    pub begins_loaded: Option<String>,
}

/// Estimates of a whole recording.
///
/// # Errors
/// Every fault, up to a bound.
pub fn apply(
    estimator: &Estimator,
    file: &str,
    text: &str,
    zero: &Zero,
) -> Result<Estimates, Vec<RecordingFault>> {
    let unbounded = Bounds {
        zero,
        most_bytes: usize::MAX,
        stop: &AtomicBool::new(false),
    };
    Ok(apply_within(estimator, file, text, unbounded)?.unwrap_or_default())
}

/// Bounds of the estimates.
#[derive(Debug, Clone, Copy)]
pub struct Bounds<'a> {
    /// Zero of the signals.
    pub zero: &'a Zero,
    /// Most bytes of them.
    pub most_bytes: usize,
    /// Whether to stop.
    pub stop: &'a AtomicBool,
}

/// Estimates as [`apply`] does; `None` when it was to stop before the end.
///
/// # Errors
/// As [`apply`], and when there are more estimates than there may be.
pub fn apply_within(
    estimator: &Estimator,
    file: &str,
    text: &str,
    bounds: Bounds<'_>,
) -> Result<Option<Estimates>, Vec<RecordingFault>> {
    let text = usual(text);
    // Lines that were comments are blank.
    let blanks = text.lines().take_while(|line| line.trim().is_empty());
    let blanks = blanks.count();
    let mut lines = text.lines().skip(blanks);
    let mut rows = EstimatedLines::new(
        estimator,
        file,
        lines.next().unwrap_or_default(),
        bounds.zero,
    )?;
    rows.line += blanks;
    let mut csv = estimates_header(estimator);
    let mut faults = Vec::new();
    for line in lines {
        if bounds.stop.load(Ordering::Relaxed) {
            return Ok(None);
        }
        match rows.push(line) {
            Ok(estimates) => csv.push_str(&estimates),
            Err(found) => faults.extend(found),
        }
        if csv.len() > bounds.most_bytes {
            let mut large = FaultList::of(file);
            let detail = format!(
                "has more than {} MiB of estimates: send it in parts",
                bounds.most_bytes >> 20
            );
            large.add(None, None, detail);
            faults.extend(large.into_faults());
            break;
        }
        if faults.len() > estimation::recording::recording_fault::MOST_FAULTS {
            break;
        }
    }
    if faults.is_empty() {
        let begins_loaded = rows.begins_loaded();
        Ok(Some(Estimates { csv, begins_loaded }))
    } else {
        Err(faults)
    }
}
