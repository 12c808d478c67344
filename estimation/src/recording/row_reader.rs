//! Rows of a recording from its lines.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use super::csv_line::{cells, number};
use super::force_unit::measured_in;
use super::named_columns::NamedColumns;
use super::recording_fault::{FaultKind, FaultList};
use super::time_column::{NO_SECONDS, nanoseconds_beside};
use super::time_text;
use crate::recipe::time_unit::TimeUnit;

/// Reader of rows: where their columns are.
#[derive(Debug, Clone)]
pub struct RowReader {
    names: NamedColumns,
    width: usize,
    time: usize,
    /// Column of the nanoseconds beside whole seconds.
    nanoseconds: Option<usize>,
    signals: Vec<usize>,
    /// Columns of the forces, and newtons of one of their units; None where the file lacks the force.
    forces: Vec<Option<(usize, f64)>>,
    cycle: Option<usize>,
    /// Whether a signal may be empty: it is then interpolated.
    gaps: bool,
}

/// A row, as it stands in the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// s
    pub time_s: f64,
    /// NaN where not measured.
    pub signals: Vec<f64>,
    /// N; NaN where not measured.
    pub forces: Vec<f64>,
    /// Entry in the column of cycles.
    pub cycle: Option<String>,
}

impl RowReader {
    /// A reader for files with this header. The time and all signals must be in it; None otherwise. `gaps` lets signals be empty.
    pub fn new(names: &NamedColumns, header: &[String], gaps: bool) -> Option<Self> {
        let places: std::collections::HashMap<&String, usize> = header.iter().zip(0..).collect();
        let place = |name: &String| places.get(name).copied();
        let force = |name: &String| {
            let (column, newtons) = measured_in(name, header)?;
            Some((place(column)?, newtons))
        };
        Some(Self {
            width: header.len(),
            time: place(&names.time)?,
            nanoseconds: nanoseconds_beside(&names.time, header).and_then(place),
            signals: names.signals.iter().map(place).collect::<Option<_>>()?,
            forces: names.forces.iter().map(force).collect(),
            cycle: names.cycle.as_ref().and_then(place),
            names: names.clone(),
            gaps,
        })
    }

    /// The time of a line that may be faulty, s; None where it can't be told.
    pub fn time_s(&self, line: &str) -> Option<f64> {
        let cells = cells(line, self.width).ok()?;
        self.seconds(|at| cells.get(at).map_or("", |cell| &**cell))
            .ok()?
    }

    /// Seconds of a row's cells; None where there is no time.
    fn seconds<'c>(&self, cell: impl Fn(usize) -> &'c str) -> Result<Option<f64>, String> {
        let text = cell(self.time);
        if let Some(seconds) = time_text::seconds(text) {
            return Ok(Some(seconds));
        }
        let unit = self.names.time_unit.unwrap_or(TimeUnit::S);
        let Some(whole) = number(text)?.map(|number| unit.seconds(number)) else {
            return Ok(None);
        };
        let rest = match self.nanoseconds {
            Some(nanoseconds) => number(cell(nanoseconds))?,
            None => Some(0.0),
        };
        let Some(rest) = rest else {
            return Ok(None);
        };
        let time_s = whole + TimeUnit::Ns.seconds(rest);
        if time_s.abs() >= NO_SECONDS {
            return Err(format!(
                "is {time_s:.3e} s, 3000 years or more: a time is a number whose unit time_unit = \"ms\", \"us\" or \"ns\" under [columns] says"
            ));
        }
        Ok(Some(time_s))
    }

    /// Reads one line; None after a fault.
    pub fn row(&self, line_number: usize, line: &str, faults: &mut FaultList) -> Option<Row> {
        let cells = match cells(line, self.width) {
            Ok(cells) if cells.len() == self.width => cells,
            other => {
                let count = other.map_or_else(|count| count, |cells| cells.len());
                let detail = format!(
                    "has {count} cells; the header has {}: delete the row where it was cut",
                    self.width
                );
                faults.add_like(FaultKind::Cells, line_number, None, detail);
                return None;
            }
        };
        let cell = |at: usize| cells.get(at).map_or("", |cell| &**cell);
        let mut whole = true;
        let mut refuse = |kind: FaultKind, name: &str, detail: String| {
            faults.add_like(kind, line_number, Some(name), detail);
            whole = false;
            f64::NAN
        };
        let time_s = match self.seconds(cell) {
            Ok(Some(time_s)) => time_s,
            Ok(None) => refuse(
                FaultKind::Empty,
                &self.names.time,
                "is empty; each row has a time".to_owned(),
            ),
            Err(detail) => {
                let detail = format!(
                    "{detail}, a date as 2026-11-25T10:00:00.050Z, or a clock's 10:00:00.050"
                );
                refuse(FaultKind::Number, &self.names.time, detail)
            }
        };
        let signals = self.signals.iter().zip(&self.names.signals);
        let signals = signals
            .map(|(at, name)| match number(cell(*at)) {
                Ok(None) if !self.gaps => refuse(
                    FaultKind::Empty,
                    name,
                    format!("is empty; add rate_hz = ... under [preprocess], and it is interpolated, or not_signals = [{name:?}] under [columns]"),
                ),
                Ok(signal) => signal.unwrap_or(f64::NAN),
                Err(detail) => {
                    let detail = format!("{detail}; text is left out by not_signals = [{name:?}] under [columns]");
                    refuse(FaultKind::Number, name, detail)
                }
            })
            .collect();
        let forces = self.forces.iter().zip(&self.names.forces);
        let forces = forces
            .map(|(place, name)| {
                let Some((at, newtons)) = *place else {
                    return f64::NAN;
                };
                match number(cell(at)) {
                    Ok(force) => force.map_or(f64::NAN, |force| newtons * force),
                    Err(detail) => refuse(FaultKind::Number, name, detail),
                }
            })
            .collect();
        let cycle = self.cycle.map(|at| cell(at).to_owned());
        whole.then_some(Row {
            time_s,
            signals,
            forces,
            cycle,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::Columns;

    fn reader(header: &str) -> RowReader {
        let header: Vec<String> = header.split(',').map(str::to_owned).collect();
        let names = NamedColumns::find(&Columns::default(), [&header]);
        RowReader::new(&names, &header, false).expect("columns")
    }

    fn rows(header: &str, lines: [&str; 2]) -> Vec<Row> {
        let reader = reader(header);
        let mut faults = FaultList::of("r.csv");
        let row = |line| reader.row(2, line, &mut faults).expect("a row");
        lines.map(row).to_vec()
    }

    #[test]
    fn times_are_seconds_whatever_they_are_written_as() {
        let cases = [
            ("time_s,s1,fz_n", ["0.05,1,2", "0.1,1,2"]),
            ("time_ms,s1,fz_n", ["50,1,2", "100,1,2"]),
            ("t [us],s1,fz_n", ["50000,1,2", "100000,1,2"]),
            ("time,s1,fz_n", ["00:00:00.050,1,2", "00:00:00.100,1,2"]),
            (
                "timestamp,s1,fz_n",
                ["1970-01-01T00:00:00.05Z,1,2", "1970-01-01 00:00:00.1,1,2"],
            ),
            ("sec,nanosec,s1,fz_n", ["0,50000000,1,2", "0,100000000,1,2"]),
        ];
        for (header, lines) in cases {
            let times: Vec<f64> = rows(header, lines).iter().map(|row| row.time_s).collect();
            assert_eq!(times, [0.05, 0.1], "{header}");
        }
    }

    #[test]
    fn no_time_is_thousands_of_years() {
        // A date since 1970 in seconds, the same in milliseconds, and numbers whose neighbours are far more than seconds apart.
        for (header, good, bad) in [
            (
                "time_s,s1,fz_n",
                "1795852800,1,2",
                ["1795852800000,1,2", "-7.8e67,1,2"],
            ),
            (
                "sec,nanosec,s1,fz_n",
                "1795852800,5,1,2",
                ["1795852800000,5,1,2", "1,7.8e67,1,2"],
            ),
        ] {
            let reader = reader(header);
            let mut faults = FaultList::of("r.csv");
            assert!(reader.row(2, good, &mut faults).is_some());
            for line in bad {
                assert_eq!(reader.row(3, line, &mut faults), None, "{line}");
                assert_eq!(reader.time_s(line), None, "{line}");
            }
            let [fault] = &faults.into_faults()[..] else {
                panic!("faults of one kind are one");
            };
            assert!(fault.detail.contains("time_unit"), "{fault}");
        }
    }

    #[test]
    fn forces_are_newtons() {
        for (header, lines, expected) in [
            ("time_s,s1,fz_kn", ["0,1,0.002", "1,1,"], 2.0),
            ("time_s,s1,force_g", ["0,1,100", "1,1,"], 0.980_665),
        ] {
            let found = rows(header, lines);
            assert!((found[0].forces[0] - expected).abs() < 1e-15, "{header}");
            assert!(found[1].forces[0].is_nan());
        }
    }
}
