//! Recordings from their texts, with all faults of all of them.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::borrow::Cow;
use std::collections::HashSet;

use document::fault::Fault;
use estimation::recipe::Recipe;
use estimation::recording::csv_recording::{
    MOST_COLUMNS, first_time, header, read, rows_below_header,
};
use estimation::recording::dialect::usual;
use estimation::recording::named_columns::NamedColumns;
use estimation::recording::recording_fault::RecordingFault;
use estimation::recording::repeated_rows::repeated_pairs;
use estimation::recording::time_column::{doubt, epoch_unit};
use estimation::recording::{PAUSE_INTERVALS, Recording};
use estimation::rows::{Refusal, Runs};
use serde::{Deserialize, Serialize};

/// Most bytes of a recording: a million rows of 30 columns.
pub const MOST_RECORDING_BYTES: usize = 1 << 28;
/// Most rows of all recordings together.
pub const MOST_ROWS: usize = 2_000_000;

/// A file as it was given.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct NamedText {
    /// Name of the file, for people.
    pub name: String,
    /// Text of the file.
    pub text: String,
}

/// Texts in the usual form, and the columns that are meant in all of them.
pub(crate) struct ColumnedTexts<'t> {
    /// Texts of the files.
    pub usual: Vec<Cow<'t, str>>,
    /// Headers of the files; none of one that has a fault there.
    pub headers: Vec<Option<Vec<String>>>,
    /// The columns' names.
    pub names: NamedColumns,
    /// Whether times are numbers, and no dates.
    has_numbers: bool,
}

/// Finds the columns of recordings as a recipe asks.
///
/// # Errors
/// A fault where there is no recording, or more of them than is read.
pub(crate) fn columned<'t>(
    recipe: &Recipe,
    files: &'t [NamedText],
) -> Result<ColumnedTexts<'t>, Vec<Fault>> {
    if files.is_empty() {
        return Err(vec![fault(
            "there is no recording; give one or more CSV files, one a run".to_owned(),
        )]);
    }
    let usual: Vec<Cow<'_, str>> = files.iter().map(|file| usual(&file.text)).collect();
    let rows: usize = usual.iter().map(|text| rows_below_header(text)).sum();
    if rows > MOST_ROWS {
        return Err(vec![fault(format!(
            "the recordings have {rows} rows; at most {MOST_ROWS} are read"
        ))]);
    }
    // A file without a header says so when it is read.
    let named = files.iter().map(|file| &file.name).zip(&usual);
    let headers: Vec<Option<Vec<String>>> =
        named.map(|(name, text)| header(name, text).ok()).collect();
    let columns: HashSet<&String> = headers.iter().flatten().flatten().collect();
    if columns.len() > MOST_COLUMNS {
        return Err(vec![fault(format!(
            "the recordings have {} columns of different names; at most {MOST_COLUMNS} are read, and every run has the same",
            columns.len()
        ))]);
    }
    let mut names = NamedColumns::find(&recipe.columns, headers.iter().flatten());
    let first_time = usual
        .iter()
        .zip(&headers)
        .find_map(|(text, header)| first_time(text, header.as_ref()?, &names));
    if names.time_unit.is_none() && recipe.columns.time_unit.is_none() {
        names.time_unit = first_time.and_then(epoch_unit);
    }
    Ok(ColumnedTexts {
        usual,
        headers,
        names,
        has_numbers: first_time.is_some(),
    })
}

/// Reads recordings as a recipe asks.
///
/// # Errors
/// Every fault: of lines and columns, or else of what the recipe wants of them.
pub(crate) fn read_runs(recipe: &Recipe, files: &[NamedText]) -> Result<Runs, Vec<Fault>> {
    let columned = columned(recipe, files)?;
    let mut faults = twins(files);
    let gaps = recipe.preprocess.rate_hz.is_some();
    let mut recordings = Vec::new();
    for (file, text) in files.iter().zip(&columned.usual) {
        match read(&file.name, text, &recipe.columns, &columned.names, gaps) {
            Ok(recording) => recordings.push(recording),
            Err(found) => add(&mut faults, found),
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    runs_of(recipe, &columned, recordings)
}

/// A fault for each file that was given before.
pub(crate) fn twins(files: &[NamedText]) -> Vec<Fault> {
    let mut faults = Vec::new();
    for (place, file) in files.iter().enumerate() {
        let mut before = files.iter().take(place);
        if let Some(twin) = before.find(|other| other.text == file.text) {
            let detail = format!(
                "{} is the same as {}: a run that is learnt from twice isn't left out",
                file.name, twin.name
            );
            Fault::add(&mut faults, "", detail);
        }
    }
    faults
}

/// Runs of recordings that were read and have all columns.
///
/// # Errors
/// Every fault of what the recipe wants of them.
pub(crate) fn runs_of(
    recipe: &Recipe,
    columned: &ColumnedTexts<'_>,
    recordings: Vec<Recording>,
) -> Result<Runs, Vec<Fault>> {
    let repeated = repeated_stretches(&recordings);
    if !repeated.is_empty() {
        return Err(repeated);
    }
    if let Some(refused) = doubtful_time(recipe, columned, &recordings) {
        return Err(vec![refused]);
    }
    if let Some(refused) = too_many_ticks(recipe, &recordings) {
        return Err(vec![refused]);
    }
    Runs::new(recipe, columned.names.clone(), recordings)
        .map_err(|refusals| refusals.into_iter().map(of_recipe).collect())
}

/// A fault for each pair of recordings that share a stretch of one measurement.
fn repeated_stretches(recordings: &[Recording]) -> Vec<Fault> {
    let mut faults = Vec::new();
    for [(earlier, first), (later, second)] in repeated_pairs(recordings) {
        let name = |number: usize| recordings.get(number).map_or("", |run| run.name.as_str());
        let detail = format!(
            "{} repeats {}: its row {} on is row {} on there, so that neither is a run that the other leaves out; give one of them",
            name(later),
            name(earlier),
            second + 1,
            first + 1
        );
        Fault::add(&mut faults, "", detail);
    }
    faults
}

/// Numbers of time that may be no seconds, where neither name nor recipe says so.
pub(crate) fn doubtful_time(
    recipe: &Recipe,
    ColumnedTexts {
        names, has_numbers, ..
    }: &ColumnedTexts<'_>,
    recordings: &[Recording],
) -> Option<Fault> {
    let columns = &recipe.columns;
    if !has_numbers || names.time_unit.is_some() || columns.time_unit.is_some() {
        return None;
    }
    let is_named = columns.time.is_some();
    let of_run = |run: &Recording| doubt(&names.time, &run.time_s, run.interval_s()?, is_named);
    let detail = recordings.iter().find_map(of_run)?;
    Some(Fault {
        pointer: "/columns/time".to_owned(),
        detail,
    })
}

/// A clock on which recordings would have more rows than are read: a few rows far apart make any number of them.
fn too_many_ticks(recipe: &Recipe, recordings: &[Recording]) -> Option<Fault> {
    let rate_hz = recipe.preprocess.rate_hz?;
    let typical = recordings.iter().filter_map(Recording::interval_s);
    let usual = PAUSE_INTERVALS * typical.fold(0.0, f64::max);
    let pause_s = recipe.preprocess.pause_s.unwrap_or(usual);
    let gaps = recordings.iter().flat_map(|run| run.time_s.windows(2));
    let gaps = gaps.filter_map(|pair| Some(pair.last()? - pair.first()?));
    let ticks = rate_hz * gaps.filter(|gap| *gap <= pause_s).sum::<f64>();
    (ticks > MOST_ROWS as f64).then(|| Fault {
        pointer: "/preprocess/rate_hz".to_owned(),
        detail: format!(
            "makes {ticks:.0} rows of these recordings; at most {MOST_ROWS} are learnt from"
        ),
    })
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

#[cfg(test)]
mod tests {
    use estimation::recipe::CycleRule;

    use super::*;

    #[test]
    fn a_clock_that_makes_too_many_rows_is_refused() {
        let recipe = |pause_s: Option<f64>, rate_hz: f64| {
            let mut recipe = Recipe::default();
            recipe.preprocess.rate_hz = Some(rate_hz);
            recipe.preprocess.pause_s = pause_s;
            recipe.columns.cycles = CycleRule::BlockS(1.0);
            recipe
        };
        let row = |row: u32| format!("{},{},{}\n", 0.1 * f64::from(row), row % 7, row % 5);
        let rows: String = (0..60).map(row).collect();
        let text = format!("time_s,s1,fz_n\n{rows}1e8,1,1\n");
        let name = "a.csv".to_owned();
        let files = [NamedText { name, text }];
        // A day without a row is a pause, unless the recipe says otherwise.
        assert!(read_runs(&recipe(None, 100.0), &files).is_ok());
        for (pause_s, rate_hz) in [(Some(1e9), 100.0), (None, 1e6)] {
            let refused = read_runs(&recipe(pause_s, rate_hz), &files).expect_err("too many");
            assert_eq!(refused[0].pointer, "/preprocess/rate_hz");
        }
    }
}
