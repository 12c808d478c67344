//! Studies on any mesh level, and what they are run with.

use std::sync::atomic::AtomicBool;

use document::Choice;
use document::{Format, parse};
use documents::study::plan::PlannedStudy;
use documents::study::presets;
use fem_client::scene::Level;
use fem_client::solver::Solver;
use placement::points::RunContext;
use placement::points::archive::Archive;
use serde_json::json;

use crate::all_cores::cores;

static GO_ON: AtomicBool = AtomicBool::new(false);

/// A study on a mesh level: one that ships, by its name, or one of a file.
///
/// # Panics
/// Where there is no such study, or it has faults.
pub fn study_on(study: &str, level: Level) -> PlannedStudy {
    let read = |path: &str| std::fs::read_to_string(path).map_err(|error| error.to_string());
    let mut shipped = presets().into_iter();
    let text = match shipped.find(|(name, _)| *name == study) {
        Some((_, text)) => text.to_owned(),
        None => read(study).unwrap_or_else(|error| panic!("{study}: {error}")),
    };
    let planned = parse(&text, Format::of_path(study)).and_then(|mut document| {
        document["accuracy"] = json!({"preset": level.as_str()});
        PlannedStudy::from_value(&document, &read)
    });
    planned.unwrap_or_else(|faults| panic!("{study}: {faults:?}"))
}

/// The mesh level that is an argument of the command line, by its number; the usual one where there is none.
///
/// # Panics
/// Where there is no such level.
pub fn level_argument(number: usize, usual: Level) -> Level {
    let Some(asked) = std::env::args().nth(number) else {
        return usual;
    };
    let known = Level::CHOICES.iter().find(|(name, _)| *name == asked);
    let (_, level) = known.unwrap_or_else(|| panic!("no mesh level is called {asked:?}"));
    *level
}

/// Makes a context that runs on all cores, to the end, without a word.
pub fn undisturbed<'r>(solver: &'r dyn Solver, archive: &'r dyn Archive) -> RunContext<'r> {
    RunContext {
        solver,
        archive,
        threads: cores(),
        stop: &GO_ON,
        pause: None,
        observer: &|_| (),
    }
}
