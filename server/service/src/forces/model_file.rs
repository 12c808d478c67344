//! Estimators as texts: data, versioned, and checked as if anybody could have written them.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::Fault;
use estimation::estimator::{Estimator, FORMAT, VERSION};
use serde::Deserialize;
use serde_json::{Map, Value};

/// Most bytes of a model file.
pub const MOST_MODEL_BYTES: usize = 1 << 28;

/// The text of an estimator: JSON in one line.
///
/// # Errors
/// A sentence, when a number of it isn't finite: the estimator is broken.
pub fn model_text(estimator: &Estimator) -> Result<String, String> {
    estimator.clone().prepare()?;
    let text = serde_json::to_string(estimator).map_err(|error| error.to_string())?;
    Ok(text + "\n")
}

/// Head of a model file, which is read first: a file of another version says so, whatever else it holds.
#[derive(Deserialize)]
struct Head {
    format: Option<String>,
    version: Option<u32>,
}

/// Reads an estimator and makes it ready to use.
///
/// # Errors
/// One fault that says what is wrong.
pub fn read_model(text: &str) -> Result<Estimator, Vec<Fault>> {
    let fault = |detail: String| {
        vec![Fault {
            pointer: String::new(),
            detail,
        }]
    };
    let head: Head = serde_json::from_str(text)
        .map_err(|error| fault(format!("it is no model of strainsite: {error}")))?;
    if head.format.as_deref() != Some(FORMAT) {
        return Err(fault(format!(
            "it is no model of strainsite: format must be \"{FORMAT}\""
        )));
    }
    let read = match head.version {
        Some(VERSION) => serde_json::from_str(text),
        Some(1) => first_version(text),
        other => {
            let found = other.map_or("none".to_owned(), |version| version.to_string());
            return Err(fault(format!(
                "the model's version is {found}; this program reads versions 1 and {VERSION}: fit it anew"
            )));
        }
    };
    let mut estimator: Estimator =
        read.map_err(|error| fault(format!("the model can't be read: {error}")))?;
    estimator
        .prepare()
        .map_err(|detail| fault(format!("the model can't be used: {detail}")))?;
    Ok(estimator)
}

/// Reads a file of version 1: a force had one model, whose fields stood beside its factor.
fn first_version(text: &str) -> serde_json::Result<Estimator> {
    let mut whole: Map<String, Value> = serde_json::from_str(text)?;
    whole.insert("version".to_owned(), VERSION.into());
    if let Some(Value::Array(forces)) = whole.get_mut("forces") {
        for force in forces.iter_mut().filter_map(Value::as_object_mut) {
            let factor = force.remove("factor");
            let model = std::mem::take(force);
            force.extend(factor.map(|factor| ("factor".to_owned(), factor)));
            force.insert("members".to_owned(), vec![Value::Object(model)].into());
        }
    }
    serde_json::from_value(Value::Object(whole))
}

#[cfg(test)]
#[allow(clippy::expect_used, clippy::indexing_slicing, reason = "a test")]
mod tests {
    use super::*;

    /// File as the first version wrote it.
    const FIRST: &str = include_str!("../../../../tests/fuzz/models/ridge.json");

    #[test]
    fn a_model_of_the_first_version_is_read_and_written_as_one_of_this() {
        let read = read_model(FIRST).expect("reads");
        assert_eq!((read.version, read.forces[0].members.len()), (VERSION, 1));
        assert_eq!(read.forces[0].factor, 2.3284342812381666);
        let text = model_text(&read).expect("a text");
        assert_eq!(read_model(&text), Ok(read));
    }

    #[test]
    fn a_force_without_models_is_refused() {
        let text = model_text(&read_model(FIRST).expect("reads")).expect("a text");
        let mut whole: Value = serde_json::from_str(&text).expect("JSON");
        whole["forces"][0]["members"] = Value::Array(Vec::new());
        let faults = read_model(&whole.to_string()).expect_err("no models");
        assert!(
            faults[0].detail.contains("1 to 12 models; it has 0"),
            "{faults:?}"
        );
    }
}
