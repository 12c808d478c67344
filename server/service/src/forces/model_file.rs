//! Estimators as texts: data, versioned, and checked as if anybody could have written them.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use estimation::estimator::{Estimator, FORMAT, VERSION};
use fem_client::document::fault::Fault;
use serde::Deserialize;

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

/// What is read first: a file of another version says so, whatever else it holds.
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
    if head.version != Some(VERSION) {
        let found = head
            .version
            .map_or("none".to_owned(), |version| version.to_string());
        return Err(fault(format!(
            "the model's version is {found}; this program reads version {VERSION}: fit it anew"
        )));
    }
    let mut estimator: Estimator = serde_json::from_str(text)
        .map_err(|error| fault(format!("the model can't be read: {error}")))?;
    estimator
        .prepare()
        .map_err(|detail| fault(format!("the model can't be used: {detail}")))?;
    Ok(estimator)
}
