//! `strainsite validate`: checks a file without running it.

use std::path::PathBuf;

use clap::Args;
use document::parse;
use documents::own_model::inputs_document::Inputs;
use documents::study::plan::PlannedStudy;
use documents::study::study_fields::FIELDS;
use fem_client::scene::Scene;
use serde_json::Value;

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::output::tell;
use crate::cli::terminal::slip_text::slip_lines;
use service::study_document::{format_of, read_study, read_study_file};

/// Check a study, a scene, or the inputs of a model of your own, without running it
#[derive(Debug, Args)]
pub(crate) struct Validate {
    /// Study, scene or inputs file, TOML or JSON
    file: PathBuf,
}

impl Validate {
    /// Checks and says what the file asks for.
    pub fn execute(&self) -> Result<(), Failure> {
        let text = read_study_file(&self.file).map_err(Failure::Input)?;
        let document = parse(&text, format_of(&self.file)).map_err(Failure::Input)?;
        let line = if is_own_model(&document) {
            self.inputs(&text)?
        } else if is_study(&document) {
            self.study(&text)?
        } else {
            self.scene(&text)?
        };
        tell(&line, None)
    }

    fn inputs(&self, text: &str) -> Result<String, Failure> {
        let inputs = Inputs::from_document(text, format_of(&self.file)).map_err(Failure::Input)?;
        let (count, method) = (inputs.names.len(), inputs.method.kind.as_str());
        Ok(format!(
            "{0}: {count} inputs of a model of your own, by {method}: strainsite gsa plan {0}\n",
            self.file.display()
        ))
    }

    fn study(&self, text: &str) -> Result<String, Failure> {
        let PlannedStudy { study, plan } = read_study(text, &self.file).map_err(Failure::Input)?;
        let (inputs, points) = (study.inputs.len(), plan.points.len());
        Ok(format!(
            "{}: study {:?}, {inputs} inputs, {points} solves\n{}",
            self.file.display(),
            study.name,
            slip_lines(plan.slips(&study))
        ))
    }

    fn scene(&self, text: &str) -> Result<String, Failure> {
        let scene = Scene::from_text(text, format_of(&self.file)).map_err(Failure::Input)?;
        let (stations, level) = (scene.ground.stations, scene.model.level.as_str());
        Ok(format!(
            "{}: scene, {stations} stations, level {level}\n{}",
            self.file.display(),
            slip_lines(scene.slips())
        ))
    }
}

/// Inputs of a model of one's own vary no field of a scene.
fn is_own_model(document: &Value) -> bool {
    let inputs = document.get("inputs").and_then(Value::as_array);
    let varies = |input: &Value| input.get("vary").is_some();
    let of_study = [
        "scene",
        "candidates",
        "layouts",
        "question",
        "accuracy",
        "signals",
        "rig",
    ];
    let is_study = of_study.iter().any(|field| document.get(field).is_some());
    inputs.is_some_and(|inputs| !inputs.iter().any(varies)) && !is_study
}

/// A study says what varies; a scene has none of a study's fields.
fn is_study(document: &Value) -> bool {
    FIELDS.iter().any(|f| document.get(f).is_some())
}
