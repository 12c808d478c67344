//! Recordings from their texts, with all faults of all of them.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use estimation::recipe::Recipe;
use estimation::recording::csv_recording::{header, read};
use estimation::recording::named_columns::NamedColumns;
use estimation::recording::recording_fault::RecordingFault;
use estimation::rows::{Refusal, Runs};
use fem_client::document::fault::Fault;

/// Most bytes of a recording: a million rows of 30 columns.
pub const MOST_RECORDING_BYTES: usize = 1 << 28;
/// Most rows of all recordings together.
pub const MOST_ROWS: usize = 2_000_000;

/// A file as it was given.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NamedText {
    /// Its name, for people.
    pub name: String,
    /// What it holds.
    pub text: String,
}

/// Reads recordings as a recipe asks.
///
/// # Errors
/// Every fault: of lines and columns, or else of what the recipe wants of them.
pub fn read_runs(recipe: &Recipe, files: &[NamedText]) -> Result<Runs, Vec<Fault>> {
    if files.is_empty() {
        return Err(vec![fault(
            "there is no recording; give one or more CSV files, one a run".to_owned(),
        )]);
    }
    let mut faults = Vec::new();
    let mut headers = Vec::new();
    for file in files {
        match header(&file.name, &file.text) {
            Ok(names) => headers.push((file.name.as_str(), names)),
            Err(found) => add(&mut faults, found),
        }
    }
    let names = match NamedColumns::find(&recipe.columns, &headers) {
        Ok(names) if faults.is_empty() => names,
        Ok(_) => return Err(faults),
        Err(found) => {
            add(&mut faults, found);
            return Err(faults);
        }
    };
    let mut recordings = Vec::new();
    for file in files {
        match read(
            &file.name,
            &file.text,
            &names,
            recipe.preprocess.rate_hz.is_some(),
        ) {
            Ok(recording) => recordings.push(recording),
            Err(found) => add(&mut faults, found),
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let rows: usize = recordings
        .iter()
        .map(estimation::recording::Recording::rows)
        .sum();
    if rows > MOST_ROWS {
        return Err(vec![fault(format!(
            "the recordings have {rows} rows; at most {MOST_ROWS} are read"
        ))]);
    }
    Runs::new(recipe, names, recordings)
        .map_err(|refusals| refusals.into_iter().map(of_recipe).collect())
}

fn fault(detail: String) -> Fault {
    Fault {
        pointer: String::new(),
        detail,
    }
}

fn of_recipe(refusal: Refusal) -> Fault {
    Fault {
        pointer: refusal.pointer,
        detail: refusal.detail,
    }
}

/// The faults of recordings, bounded like all others.
pub fn add(faults: &mut Vec<Fault>, found: Vec<RecordingFault>) {
    for recording in found {
        Fault::add(faults, "", recording.to_string());
    }
}
