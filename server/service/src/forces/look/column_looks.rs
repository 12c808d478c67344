//! Columns of one recording: what each is taken for, and what stands in it.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::borrow::Cow;

use estimation::recording::Recording;
use estimation::recording::csv_recording::first_time;
use estimation::recording::look::column_figures::{ColumnFigures, rows_at_rest};
use estimation::recording::look::lone_samples::lone_samples;
use estimation::recording::look::taken_columns::{Part, taken_columns};
use estimation::recording::look::unread_columns::{UnreadColumn, lines_of_rows, unread_columns};
use estimation::recording::look::value_bins::value_bins;
use estimation::recording::named_columns::NamedColumns;
use estimation::recording::suspect_signals::suspicion;

use crate::wire::look_wire::{
    ColumnLook, ColumnSeries, LoneSample, LoneSamples, RecordingSeries, Taken,
};

/// Gaps, and samples that stand alone, that are named one by one.
pub(super) const MOST_NAMED: usize = 20;
/// Lines that a sentence names.
const MOST_LINES: usize = 4;

/// A recording that was read, with its text in the usual form.
pub(super) struct Looked<'l> {
    pub run: &'l Recording,
    pub text: &'l str,
    pub header: &'l [String],
    /// The names that the header has.
    pub names: &'l NamedColumns,
}

impl Looked<'_> {
    /// All columns, and those with numbers over time in so many bins.
    pub fn columns(&self, bins: usize) -> (Vec<ColumnLook>, Option<RecordingSeries>) {
        let parts = taken_columns(self.names, self.header);
        let is_unread = |part: &Part| matches!(part, Part::Nanoseconds | Part::Cycle | Part::None);
        let numbered = parts.iter().enumerate();
        let places: Vec<usize> = numbered
            .filter(|(_, part)| is_unread(part))
            .map(|(place, _)| place)
            .collect();
        let mut unread = unread_columns(self.text, &places).into_iter();
        let at_rest = rows_at_rest(self.run);
        let (mut looks, mut series) = (Vec::new(), Vec::new());
        for (column, part) in self.header.iter().zip(&parts) {
            let of_its_own = match is_unread(part) {
                true => unread.next().unwrap_or_default(),
                false => UnreadColumn::default(),
            };
            let values = self.values(part, &of_its_own);
            looks.push(self.column(column, part, &values, &at_rest, of_its_own.texts));
            if bins > 0 && !matches!(part, Part::Time | Part::Nanoseconds) {
                series.extend(self.series(column, &values, bins));
            }
        }
        let length = |first: &f64| self.run.time_s.last().map_or(0.0, |last| last - first);
        let duration_s = self.run.time_s.first().map_or(0.0, length);
        let series = RecordingSeries {
            bin_s: duration_s / bins.max(1) as f64,
            columns: series,
        };
        (looks, Some(series))
    }

    fn values<'v>(&'v self, part: &Part, unread: &'v UnreadColumn) -> Cow<'v, [f64]> {
        match part {
            Part::Time => Cow::Borrowed(&self.run.time_s),
            Part::Signal(number) => Cow::Owned(self.run.signals.column(*number).to_vec()),
            Part::Force { number, .. } => Cow::Owned(self.run.forces.column(*number).to_vec()),
            Part::Nanoseconds | Part::Cycle | Part::None => Cow::Borrowed(&unread.values),
        }
    }

    fn column(
        &self,
        column: &str,
        part: &Part,
        values: &[f64],
        at_rest: &[usize],
        texts: usize,
    ) -> ColumnLook {
        let is_measured = matches!(part, Part::Signal(_) | Part::Force { .. });
        let figures = ColumnFigures::of(values, at_rest);
        let of_measured = |figure: Option<f64>| figure.filter(|_| is_measured);
        let lone = match is_measured {
            true => self.lone(values),
            false => LoneSamples::default(),
        };
        let (force, newtons) = match part {
            Part::Force { number, newtons } => {
                (self.names.forces.get(*number).cloned(), Some(*newtons))
            }
            _ => (None, None),
        };
        let suspicions = self.suspicions(column, part, &figures, &lone);
        ColumnLook {
            column: column.to_owned(),
            taken: match part {
                Part::Time | Part::Nanoseconds => Taken::Time,
                Part::Signal(_) => Taken::Signal,
                Part::Force { .. } => Taken::Force,
                Part::Cycle => Taken::Cycle,
                Part::None => Taken::Nothing,
            },
            force,
            newtons,
            time_unit: self.time_unit(part).map(str::to_owned),
            measured: figures.measured,
            empty: self.run.rows().saturating_sub(figures.measured + texts),
            texts,
            least: figures.range.map(|(least, _)| least),
            greatest: figures.range.map(|(_, greatest)| greatest),
            noise: of_measured(figures.noise),
            unloaded: of_measured(figures.unloaded),
            drift: of_measured(figures.drift),
            lone,
            suspicions,
        }
    }

    /// A column over time; none of one without numbers.
    fn series(&self, column: &str, values: &[f64], bins: usize) -> Option<ColumnSeries> {
        let found = value_bins(&self.run.time_s, values, bins);
        let ends = |of: fn((f64, f64)) -> f64| found.iter().map(|bin| bin.map(of)).collect();
        found.iter().any(Option::is_some).then(|| ColumnSeries {
            column: column.to_owned(),
            least: ends(|(least, _)| least),
            greatest: ends(|(_, greatest)| greatest),
        })
    }

    fn time_unit(&self, part: &Part) -> Option<&'static str> {
        let is_number = || first_time(self.text, self.header, self.names).is_some();
        match part {
            Part::Time if !is_number() => Some("dates or clock times"),
            Part::Time => Some(
                self.names
                    .time_unit
                    .map_or("seconds", |unit| unit.in_words()),
            ),
            Part::Nanoseconds => Some("nanoseconds"),
            _ => None,
        }
    }

    fn lone(&self, values: &[f64]) -> LoneSamples {
        let rows = lone_samples(values);
        let named = rows.get(..MOST_NAMED.min(rows.len())).unwrap_or_default();
        let lines = lines_of_rows(self.text, named);
        let sample = |(row, line): (&usize, usize)| {
            Some(LoneSample {
                line,
                time_s: self.run.time_s.get(*row).copied()?,
                value: values.get(*row).copied()?,
            })
        };
        LoneSamples {
            count: rows.len(),
            first: named.iter().zip(lines).filter_map(sample).collect(),
        }
    }

    fn suspicions(
        &self,
        column: &str,
        part: &Part,
        figures: &ColumnFigures,
        lone: &LoneSamples,
    ) -> Vec<String> {
        let has_one = figures
            .range
            .is_some_and(|(least, greatest)| least == greatest);
        let shown = column.escape_debug();
        let mut found = Vec::new();
        match part {
            Part::Signal(_) | Part::Force { .. } if figures.measured == 0 => {
                found.push(format!("column {shown} was measured in no row"));
            }
            Part::Signal(_) if has_one => found.push(format!(
                "signal {shown} is dead: it has one value in all rows; leave it out by not_signals = [{column:?}]"
            )),
            Part::Force { .. } if has_one => found.push(format!(
                "force {shown} never changes, so that nothing is learnt of it"
            )),
            Part::Signal(number) => {
                let runs = std::slice::from_ref(self.run);
                found.extend(suspicion(runs, self.names, *number, column));
            }
            _ => {}
        }
        found.extend(self.lone_sentence(column, lone));
        found
    }

    fn lone_sentence(&self, column: &str, lone: &LoneSamples) -> Option<String> {
        let (first, further) = lone.first.split_first()?;
        let lines = further.iter().take(MOST_LINES);
        let lines: Vec<String> = lines.map(|sample| sample.line.to_string()).collect();
        let also = match (lines.len(), lone.count - 1) {
            (0, _) => String::new(),
            (1, 1) => format!(" (also line {})", lines.join(", ")),
            (named, all) if named == all => format!(" (also lines {})", lines.join(", ")),
            (named, all) => format!(
                " (also lines {} and {} more)",
                lines.join(", "),
                all - named
            ),
        };
        Some(format!(
            "{}, line {}, column {}: {} stands alone: far from the samples before and after it{also}",
            self.run.name,
            first.line,
            column.escape_debug(),
            first.value
        ))
    }
}
