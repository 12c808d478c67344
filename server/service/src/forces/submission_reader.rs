//! Documents that a client sends to learn forces, or to have them estimated: a recipe and recordings in one.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, entry};
use document::fields::{Fields, shown};
use estimation::recipe::Recipe;
use estimation::recording::csv_recording::header;
use estimation::recording::dialect::usual;
use estimation::recording::recording_fault::RecordingFault;
use serde_json::{Value, json};
use store::content::{encode, sha256};

use crate::forces::fit_forecast::estimate;
use crate::forces::fitting::figures_of;
use crate::forces::look::looking::{Depth, look};
use crate::forces::recorded_texts::{self, NamedText, read_runs};
use crate::wire::estimator_wire::StoredEstimator;
use crate::wire::look_wire::Look;

/// Most recordings of one estimator.
const MOST_RECORDINGS: usize = 1000;
/// Characters of a name, as in other documents.
const LONGEST_NAME: usize = 200;

/// A submission that was checked.
#[derive(Debug, Clone, PartialEq)]
pub struct Submission {
    /// Free text.
    pub name: String,
    /// Recipe, forces and figures of the recordings, JSON.
    pub document: String,
    /// The recordings.
    pub files: Vec<NamedText>,
    /// Memory that learning may take, bytes.
    pub memory_bytes: u64,
}

impl Submission {
    /// Hash of all that was submitted.
    pub fn sha256(&self) -> String {
        let files = self.files.iter().flat_map(|file| [&file.name, &file.text]);
        let texts = [&self.name, &self.document].into_iter().chain(files);
        let parts: Vec<&[u8]> = texts.map(|text| text.as_bytes()).collect();
        sha256(&parts)
    }
}

/// Limits of a fit.
#[derive(Debug, Clone, Copy)]
pub struct FitLimits {
    /// Threads that it has.
    pub threads: usize,
    /// Memory, bytes.
    pub memory_bytes: u64,
}

/// Reads a submission, and its recordings as the recipe asks.
///
/// # Errors
/// Every fault of the document; where it has none, every fault of the recordings.
pub fn read_submission(document: Value, limits: FitLimits) -> Result<Submission, Vec<Fault>> {
    let mut faults = Vec::new();
    let read = read_document(document, &["name", "recipe", "recordings"], &mut faults);
    let Some(Read {
        name,
        recipe,
        recipe_document,
        files,
    }) = read.filter(|_| faults.is_empty())
    else {
        return Err(faults);
    };
    let runs = read_runs(&recipe, &files).map_err(placed)?;
    let stored = StoredEstimator {
        recipe: recipe_document,
        forces: runs.names.forces.clone(),
        recordings: figures_of(&runs, &files),
        signals: runs.names.signals.len(),
    };
    let columns = [stored.forces.len(), stored.signals];
    let needed = estimate(&recipe, &stored.recordings, columns, limits.threads).peak_memory_bytes;
    if needed > limits.memory_bytes {
        let detail = format!(
            "learning from so many rows and signals may take {} MB of memory, and {} MB may be taken (--max-memory-mb): send fewer rows, or name fewer signals",
            needed / 1_000_000,
            limits.memory_bytes / 1_000_000
        );
        Fault::add(&mut faults, "/recordings", detail);
        return Err(faults);
    }
    let document = encode("an estimator", &stored).map_err(|error| {
        let detail = error.to_string();
        vec![Fault {
            pointer: "/recordings".to_owned(),
            detail,
        }]
    })?;
    Ok(Submission {
        name,
        document,
        files,
        memory_bytes: needed,
    })
}

/// Most columns of all recordings that are looked at together.
const MOST_LOOKED_AT: usize = 20_000;

/// Reads recordings, and looks at them as a recipe reads them.
///
/// # Errors
/// Every fault of the document; more recordings or columns than are looked at. Faults of recordings are part of the look.
pub fn read_look(document: Value) -> Result<Look, Vec<Fault>> {
    let mut faults = Vec::new();
    let read = read_document(document, &["recipe", "recordings"], &mut faults);
    let Some(Read { recipe, files, .. }) = read.filter(|_| faults.is_empty()) else {
        return Err(faults);
    };
    let columns = |file: &NamedText| header_of(&file.text).map_or(0, |header| header.len());
    let columns: usize = files.iter().map(columns).sum();
    if columns > MOST_LOOKED_AT {
        let detail = format!(
            "have {columns} columns; at most {MOST_LOOKED_AT} are looked at together: send fewer recordings"
        );
        Fault::add(&mut faults, "/recordings", detail);
        return Err(faults);
    }
    let mut found = look(&recipe, &files, Depth::Series).map_err(placed)?;
    found.faults = placed(found.faults);
    found.refusals = placed(found.refusals);
    Ok(found)
}

fn header_of(text: &str) -> Option<Vec<String>> {
    header("", &usual(text)).ok()
}

/// Reads one recording whose forces are asked for.
///
/// # Errors
/// Every fault.
pub fn read_recording(document: Value) -> Result<NamedText, Vec<Fault>> {
    let mut faults = Vec::new();
    match recording(document, "", &mut faults) {
        Some(file) if faults.is_empty() => Ok(file),
        _ => Err(faults),
    }
}

/// Faults of the one recording that was sent, each with its place.
pub fn of_recording(found: Vec<RecordingFault>) -> Vec<Fault> {
    let mut faults = Vec::new();
    recorded_texts::add(&mut faults, found);
    for fault in &mut faults {
        fault.pointer.insert_str(0, "/text");
    }
    faults
}

struct Read {
    name: String,
    recipe: Recipe,
    recipe_document: Value,
    files: Vec<NamedText>,
}

fn read_document(
    mut document: Value,
    known: &[&'static str],
    faults: &mut Vec<Fault>,
) -> Option<Read> {
    // Taken out, so that long texts are moved and not copied.
    let recordings = document.get_mut("recordings").map(Value::take);
    let fields = Fields::open(&document, "", known, faults)?;
    let name = fields.get("name");
    let name = name.map(|(value, at)| read_name(value, &at, faults).unwrap_or_default());
    let recipe_document = fields
        .get("recipe")
        .map_or_else(|| json!({}), |(value, _)| value.clone());
    let recipe = match Recipe::from_value(&recipe_document) {
        Ok(recipe) => recipe,
        Err(found) => {
            for fault in found {
                Fault::add(faults, &format!("/recipe{}", fault.pointer), fault.detail);
            }
            Recipe::default()
        }
    };
    let files = read_recordings(recordings, faults);
    let first = files
        .first()
        .map_or(String::new(), |file| file.name.clone());
    Some(Read {
        name: name.unwrap_or(first),
        recipe,
        recipe_document,
        files,
    })
}

fn read_recordings(recordings: Option<Value>, faults: &mut Vec<Fault>) -> Vec<NamedText> {
    let items = match recordings {
        Some(Value::Array(items)) if (1..=MOST_RECORDINGS).contains(&items.len()) => items,
        found => {
            let is = found.as_ref().map_or("missing".to_owned(), shown);
            let detail = format!(
                "must be a list of 1 to {MOST_RECORDINGS} recordings, one a run, each {{\"file\": ..., \"text\": ...}}; it is {is}"
            );
            Fault::add(faults, "/recordings", detail);
            return Vec::new();
        }
    };
    let mut files: Vec<NamedText> = Vec::new();
    for (place, item) in items.into_iter().enumerate() {
        let at = entry("/recordings", place);
        if let Some(file) = recording(item, &at, faults) {
            if files.iter().any(|other| other.name == file.name) {
                let detail = "must be another one than those before: faults name recordings by it";
                Fault::add(faults, &format!("{at}/file"), detail);
            }
            files.push(file);
        }
    }
    files
}

fn recording(mut item: Value, at: &str, faults: &mut Vec<Fault>) -> Option<NamedText> {
    let text = item.get_mut("text").map(Value::take);
    let fields = Fields::open(&item, at, &["file", "text"], faults)?;
    let name = fields
        .required("file", "what faults and reports call the recording", faults)
        .and_then(|(value, at)| read_name(value, &at, faults));
    let text = match text {
        Some(Value::String(text)) => Some(text),
        found => {
            let is = found.as_ref().map_or("missing".to_owned(), shown);
            let detail = format!("must be the recording as CSV text; it is {is}");
            Fault::add(faults, &format!("{at}/text"), detail);
            None
        }
    };
    Some(NamedText {
        name: name?,
        text: text?,
    })
}

fn read_name(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<String> {
    let fits = |text: &&str| {
        !text.trim().is_empty()
            && text.chars().count() <= LONGEST_NAME
            && !text.chars().any(char::is_control)
    };
    let name = value.as_str().filter(fits);
    if name.is_none() {
        let detail = format!(
            "must be a text of 1 to {LONGEST_NAME} characters without control characters; it is {}",
            shown(value)
        );
        Fault::add(faults, pointer, detail);
    }
    name.map(str::to_owned)
}

/// Faults of recordings and of what the recipe wants of them, each with its place in the submission.
fn placed(mut faults: Vec<Fault>) -> Vec<Fault> {
    for fault in &mut faults {
        let table = if fault.pointer.is_empty() {
            "/recordings"
        } else {
            "/recipe"
        };
        fault.pointer.insert_str(0, table);
    }
    faults
}

#[cfg(test)]
mod tests {
    use std::fmt::Write as _;

    use super::*;

    const ROOMY: FitLimits = FitLimits {
        threads: 1,
        memory_bytes: u64::MAX,
    };

    fn run(file: &str) -> Value {
        let mut text = "time_s,s1,fz_n\n".to_owned();
        for row in 0..60 {
            let force = f64::from(row % 10);
            let noise = (f64::from(row * row) * file.len() as f64).sin();
            let signal = 2.0 * force + 0.1 * noise;
            writeln!(text, "{},{signal},{force}", 0.01 * f64::from(row)).expect("writes");
        }
        json!({"file": file, "text": text})
    }

    fn faults(document: Value) -> Vec<(String, String)> {
        let found = read_submission(document, ROOMY).expect_err("has faults");
        let pairs = found.into_iter().map(|fault| (fault.pointer, fault.detail));
        pairs.collect()
    }

    #[test]
    fn a_submission_is_named_by_its_first_recording_unless_it_has_a_name() {
        let recordings = json!([run("monday.csv"), run("tuesday.csv")]);
        let unnamed = read_submission(json!({"recordings": recordings}), ROOMY).expect("reads");
        assert_eq!(unnamed.name, "monday.csv");
        let named = json!({"name": "rig", "recipe": {"models": {"kinds": ["ridge"]}}, "recordings": recordings});
        let named = read_submission(named, ROOMY).expect("reads");
        assert_eq!(named.name, "rig");
        let stored: StoredEstimator = serde_json::from_str(&named.document).expect("reads");
        assert_eq!(stored.forces, ["fz_n"]);
        assert_eq!(stored.recordings[1].rows, 60);
        assert_ne!(named.sha256(), unnamed.sha256());
    }

    #[test]
    fn faults_of_the_document_are_told_at_once() {
        let found = faults(json!({
            "name": "", "recipe": {"models": {"seed": -1}}, "runs": 1,
            "recordings": [run("a.csv"), run("a.csv"), {"file": "b\n", "texts": "x"}, 3],
        }));
        let places: Vec<&str> = found.iter().map(|(place, _)| place.as_str()).collect();
        for place in [
            "/name",
            "/recipe/models/seed",
            "/runs",
            "/recordings/1/file",
            "/recordings/2/file",
            "/recordings/2/text",
            "/recordings/2/texts",
            "/recordings/3",
        ] {
            assert!(places.contains(&place), "{place}: {places:?}");
        }
        assert_eq!(faults(json!({}))[0].0, "/recordings");
        assert_eq!(faults(json!({"recordings": []}))[0].0, "/recordings");
        assert_eq!(faults(json!(1))[0].0, "");
    }

    #[test]
    fn faults_of_recordings_have_their_place() {
        let mut broken = run("b.csv");
        broken["text"] = json!("time_s,s1,fz_n\n0,1,2\n1,x,3\n");
        let found = faults(json!({"recordings": [run("a.csv"), broken]}));
        assert_eq!(found[0].0, "/recordings");
        assert!(
            found[0].1.starts_with("b.csv, line 3, column s1"),
            "{found:?}"
        );
        let found =
            faults(json!({"recipe": {"columns": {"signals": "s9"}}, "recordings": [run("a.csv")]}));
        assert!(found[0].1.contains("s9"), "{found:?}");
        let found =
            faults(json!({"recipe": {"validation": {"by": "run"}}, "recordings": [run("a.csv")]}));
        assert_eq!(found[0].0, "/recipe/validation/by", "{found:?}");
    }

    #[test]
    fn what_would_take_too_much_memory_is_refused() {
        let limits = FitLimits {
            memory_bytes: 50_000,
            ..ROOMY
        };
        let document = json!({"recordings": [run("a.csv")]});
        let found = read_submission(document, limits).expect_err("is too large");
        assert!(found[0].detail.contains("--max-memory-mb"), "{found:?}");
    }
}
