//! `strainsite validate`: checks a file without running it.

use std::path::PathBuf;

use clap::Args;
use document::parse;
use documents::study::plan::PlannedStudy;
use fem_client::scene::Scene;
use serde_json::Value;

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::output::tell;
use crate::cli::terminal::slip_text::slip_lines;
use service::study_document::{format_of, read_study, read_study_file};

/// Check a study or scene file without running it
#[derive(Debug, Args)]
pub(crate) struct Validate {
    /// Study or scene file, TOML or JSON
    file: PathBuf,
}

impl Validate {
    /// Checks and says what the file asks for.
    pub fn execute(&self) -> Result<(), Failure> {
        let text = read_study_file(&self.file).map_err(Failure::Input)?;
        let document = parse(&text, format_of(&self.file)).map_err(Failure::Input)?;
        let line = if is_study(&document) {
            self.study(&text)?
        } else {
            self.scene(&text)?
        };
        tell(&line, None)
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

/// A study says what varies; a scene has none of a study's fields.
fn is_study(document: &Value) -> bool {
    [
        "name",
        "scene",
        "inputs",
        "candidates",
        "layouts",
        "method",
        "accuracy",
        "signals",
    ]
    .iter()
    .any(|f| document.get(f).is_some())
}
