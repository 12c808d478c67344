//! Looks at recordings: what their columns are taken for, and what stands in them.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::collections::BTreeSet;

use document::fault::Fault;
use estimation::cycles::cycles;
use estimation::recipe::Recipe;
use estimation::recording::Recording;
use estimation::recording::csv_recording::read_for_look;
use estimation::recording::look::time_figures::{Gap, TimeFigures, gaps};
use estimation::recording::look::unread_columns::lines_of_rows;

use crate::forces::look::column_looks::{Looked, MOST_NAMED};
use crate::forces::recorded_texts::{NamedText, add, columned, runs_of, twins};
use crate::wire::look_wire::{GapLook, GapsLook, Look, RecordingLook};

/// Bins of a column over time.
const MOST_BINS: usize = 300;
/// Bins of all columns of all recordings: 40 MB as text.
const MOST_BINS_IN_ALL: usize = 1 << 20;

/// Depth of a look.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Depth {
    /// Figures.
    Figures,
    /// Figures, and columns over time.
    Series,
}

/// Looks at recordings as a recipe reads them. Those with faults leave the others as they are.
///
/// # Errors
/// A fault where there is no recording, or more of them than is read.
pub fn look(recipe: &Recipe, files: &[NamedText], depth: Depth) -> Result<Look, Vec<Fault>> {
    let columned = columned(recipe, files)?;
    let names = &columned.names;
    let gaps = recipe.preprocess.rate_hz.is_some();
    let (mut faults, mut recordings, mut runs) = (Vec::new(), Vec::new(), Vec::new());
    let columns: usize = columned.headers.iter().flatten().map(Vec::len).sum();
    let most_bins = match depth {
        Depth::Figures => 0,
        Depth::Series => MOST_BINS.min(MOST_BINS_IN_ALL / columns.max(1)),
    };
    let headers = columned.headers.iter().zip(&columned.usual);
    for (file, (header, text)) in files.iter().zip(headers) {
        match read_for_look(&file.name, text, &recipe.columns, names, gaps) {
            Ok(run) => {
                let header = header.as_deref().unwrap_or_default();
                let here = names.among(header);
                let looked = Looked {
                    run: &run,
                    text,
                    header,
                    names: &here,
                };
                recordings.push(of_recording(&looked, recipe, most_bins));
                if !here.forces.is_empty() {
                    runs.push(run);
                }
            }
            Err(found) => add(&mut faults, found),
        }
    }
    let mut refusals = twins(files);
    // Nothing is learnt from recordings without forces: what learning wants isn't asked of them.
    if refusals.is_empty()
        && !runs.is_empty()
        && let Err(found) = runs_of(recipe, &columned, runs)
    {
        refusals.extend(found);
    }
    Ok(Look {
        recordings,
        faults,
        refusals,
    })
}

fn of_recording(looked: &Looked<'_>, recipe: &Recipe, most_bins: usize) -> RecordingLook {
    let run = looked.run;
    let time = TimeFigures::of(run);
    let numbers: BTreeSet<usize> = cycles(run, &recipe.columns.cycles).into_iter().collect();
    let mut notes: Vec<String> = looked.names.conversions().collect();
    if looked.names.forces.is_empty() {
        notes.push("no column is a force: forces can be estimated, and nothing learnt; if one is a force, name it by forces = [...] under [columns]".to_owned());
    }
    let bins = most_bins.min(run.rows());
    let (columns, series) = looked.columns(bins);
    RecordingLook {
        file: run.name.clone(),
        rows: run.rows(),
        begin_s: run.time_s.first().copied().unwrap_or(0.0),
        duration_s: time.duration_s,
        rate_hz: time.rate_hz,
        gaps: gaps_look(run, looked.text, &time),
        cycles: numbers.len(),
        labelled: run.labelled(),
        columns,
        notes,
        series: series.filter(|_| bins > 0),
    }
}

fn gaps_look(run: &Recording, text: &str, time: &TimeFigures) -> GapsLook {
    let named = |gap: &Gap| {
        Some(GapLook {
            line: lines_of_rows(text, &[gap.row]).first().copied()?,
            begin_s: run.time_s.get(gap.row).copied()?,
            length_s: gap.seconds,
        })
    };
    GapsLook {
        count: time.gaps,
        longest: time.longest.as_ref().and_then(named),
        first: gaps(run)
            .iter()
            .take(MOST_NAMED)
            .filter_map(named)
            .collect(),
    }
}
