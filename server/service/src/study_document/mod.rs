//! Study documents from files and from the database.
//!
//! - [`text_files`]: files up to a limit
//! - [`shipped`]: the documents that ship

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

pub mod shipped;
pub mod text_files;

use std::path::{Path, PathBuf};

use document::fault::Fault;
use document::fields::nearest;
use document::{Format, MAX_BYTES, parse};
use documents::study::plan::PlannedStudy;
use documents::study::{Study, presets};
use documents::sweep::{changed, typed_settings};
use fem_client::scene::PRESETS;
use serde_json::Value;

use crate::study_document::text_files::read_text;
use store::StoreError;
use store::queue::study_rows::StudyRow;
use store::queue::sweep_rows::SweepRow;

/// The study that a row of the database asks for.
///
/// # Errors
/// A sentence, when the row is damaged.
pub fn stored_study(row: &StudyRow) -> Result<Study, String> {
    read_stored(row.document())
}

/// The study of whose designs a row of the database is the sweep.
///
/// # Errors
/// As for [`stored_study`].
pub fn stored_base(row: &SweepRow) -> Result<Study, String> {
    read_stored(row.document())
}

fn read_stored(document: Result<&str, StoreError>) -> Result<Study, String> {
    let document = document.map_err(|error| error.to_string())?;
    Study::from_canonical(document).map_err(|faults| {
        let first = faults.first().map(Fault::to_string).unwrap_or_default();
        format!("this version refuses the stored document: {first}")
    })
}

/// The study that a row of the database asks for, with its plan.
///
/// # Errors
/// As for [`stored_study`]; when it can't be planned.
pub fn stored_plan(row: &StudyRow) -> Result<PlannedStudy, String> {
    PlannedStudy::new(stored_study(row)?).map_err(|error| error.to_string())
}

/// Reads a study's file; where there is none of this name, a shipped study may have it.
///
/// # Errors
/// One fault naming the file.
pub fn read_study_file(path: &Path) -> Result<String, Vec<Fault>> {
    read_file_or_preset(path, &presets())
}

/// Reads a scene's file; where there is none of this name, a shipped scene may have it.
///
/// # Errors
/// One fault naming the file.
pub fn read_scene_file(path: &Path) -> Result<String, Vec<Fault>> {
    read_file_or_preset(path, &PRESETS)
}

fn read_file_or_preset(path: &Path, shipped: &[(&str, &str)]) -> Result<String, Vec<Fault>> {
    let named = |(name, _): &&(&str, &str)| path == Path::new(name);
    match shipped.iter().find(named) {
        Some((_, text)) if !path.exists() || path.is_dir() => Ok((*text).to_owned()),
        _ => read_file(path).map_err(|mut faults| {
            if let Some(fault) = faults.first_mut().filter(|_| !path.exists()) {
                let names: Vec<&str> = shipped.iter().map(|(name, _)| *name).collect();
                fault.detail += &match nearest(&path.to_string_lossy(), names.iter().copied()) {
                    Some(near) => format!(". Did you mean {near}, which ships?"),
                    None => {
                        let names = names.join(", ");
                        format!(" (what ships can be named without a file: {names})")
                    }
                };
            }
            faults
        }),
    }
}

/// Reads a document's file, or says in a fault why it can't be read.
///
/// # Errors
/// One fault naming the file.
pub fn read_file(path: &Path) -> Result<String, Vec<Fault>> {
    read_text(path, MAX_BYTES).map_err(|detail| {
        vec![Fault {
            pointer: String::new(),
            detail,
        }]
    })
}

/// Reads a study from its text. Scene files that it names are looked for beside the study first, then in the
/// working folder.
///
/// # Errors
/// Every fault of the document.
pub fn read_study(text: &str, path: &Path) -> Result<PlannedStudy, Vec<Fault>> {
    let scene_file = |name: &str| read_text(&scene_path(path, name), MAX_BYTES);
    PlannedStudy::from_document(text, format_of(path), &scene_file)
}

fn scene_path(study: &Path, name: &str) -> PathBuf {
    let beside = study.parent().unwrap_or(Path::new("")).join(name);
    if beside.exists() {
        beside
    } else {
        PathBuf::from(name)
    }
}

/// A study's file and that of the scene which it names, as far as they can be read.
pub fn named_files(study: &Path) -> Vec<PathBuf> {
    let mut files = vec![study.to_owned()];
    let document = read_file(study).and_then(|text| parse(&text, format_of(study)));
    if let Ok(document) = &document
        && let Some(name) = document.get("scene").and_then(Value::as_str)
    {
        files.push(scene_path(study, name));
    }
    files
}

/// Reads a study file, with the fields that are set by texts of the form `KEY=VALUE`.
///
/// # Errors
/// Every fault of the file, or else of what is set.
pub fn read_changed(path: &Path, set: &[String]) -> Result<PlannedStudy, Vec<Fault>> {
    let study = read_study(&read_study_file(path)?, path)?;
    changed(study, typed_settings(set)?)
}

/// The format that a file's name promises.
pub fn format_of(path: &Path) -> Format {
    Format::of_path(&path.to_string_lossy())
}
