//! Samples that a fit holds for no measurements, as its report tells them.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use estimation::recipe::SuspectRows;
use estimation::recording::dialect::usual;
use estimation::recording::look::suspect_samples::{MeasuredColumn, SuspectSample};
use estimation::recording::look::unread_columns::lines_of_rows;
use estimation::rows::Runs;

use crate::forces::recorded_texts::NamedText;

/// Most samples that the note names.
const MOST_NAMED: usize = 5;

/// A sentence that names suspect samples by file, line and column, and says what becomes of their rows; none where no sample is suspect.
pub(crate) fn suspect_note(
    runs: &Runs,
    files: &[NamedText],
    treated: SuspectRows,
) -> Option<String> {
    let count: usize = runs.suspects.iter().map(Vec::len).sum();
    let mut named: Vec<String> = Vec::new();
    for (samples, file) in runs.suspects.iter().zip(files) {
        let left = MOST_NAMED - named.len();
        let samples: Vec<&SuspectSample> = samples.iter().take(left).collect();
        if samples.is_empty() {
            continue;
        }
        let rows: Vec<usize> = samples.iter().map(|sample| sample.row).collect();
        let lines = lines_of_rows(&usual(&file.text), &rows);
        let told = samples.iter().zip(lines);
        named.extend(told.map(|(sample, line)| {
            let column = column_of(runs, sample).escape_debug();
            let (file, value) = (&file.name, sample.value);
            format!("{file}, line {line}, column {column}: {value}")
        }));
    }
    if named.is_empty() {
        return None;
    }
    let more = match count.saturating_sub(named.len()) {
        0 => String::new(),
        more => format!("; and {more} more"),
    };
    let are = match count {
        1 => "hardly a measurement: it stands alone, or far beyond all others",
        _ => "hardly measurements: each stands alone, or far beyond all others",
    };
    let learnt = match treated {
        SuspectRows::Keep => {
            "Rows that hold one are learnt from and tested as others are; leave them out of learning by [preprocess] suspect_rows = \"leave-out\""
        }
        SuspectRows::LeaveOut => {
            "Rows that hold one, themselves or in a window, are left out of learning, and tested as others are"
        }
    };
    let named = named.join("; ");
    Some(format!("suspect: {named}{more}, {are}. {learnt}"))
}

fn column_of<'r>(runs: &'r Runs, sample: &SuspectSample) -> &'r str {
    let (names, number) = match sample.column {
        MeasuredColumn::Signal(number) => (&runs.names.signals, number),
        MeasuredColumn::Force(number) => (&runs.names.forces, number),
    };
    names.get(number).map_or("", String::as_str)
}
