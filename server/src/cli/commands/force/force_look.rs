//! `strainsite force look`.

use std::path::PathBuf;

use clap::Args;
use document::fault::Fault;
use estimation::recipe::Recipe;
use service::forces::look::converting::converted;
use service::forces::look::looking::{Depth, look};
use service::forces::recorded_texts::NamedText;
use service::study_document::{format_of, read_file};
use service::wire::look_wire::Look;

use crate::cli::commands::force::look_table::look_text;
use crate::cli::commands::force::recording_files::recordings;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell};
use crate::cli::terminal::output_place::write;

#[derive(Debug, Args)]
pub(crate) struct LookAt {
    /// Recordings, CSV, one a run
    #[arg(required = true)]
    runs: Vec<PathBuf>,
    /// Recipe whose columns are read, TOML or JSON; all defaults where it is left out
    #[arg(long)]
    recipe: Option<PathBuf>,
    /// Write what was found as JSON, `-` for standard output
    #[arg(long)]
    pub json: Option<JsonTarget>,
    /// Write the recording here in the usual form: seconds, signals, forces in newtons; one recording alone
    #[arg(long, value_name = "OUT")]
    convert: Option<PathBuf>,
}

impl LookAt {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        Files::default()
            .reading(&self.recipe)
            .reading(&self.runs)
            .writing(self.convert.as_deref())
            .telling(self.json.as_ref())
    }

    /// Looks at all recordings, and tells the faults of those that can't be read behind the others.
    pub fn execute(&self) -> Result<(), Failure> {
        if self.convert.is_some() && self.runs.len() > 1 {
            return Err(Failure::input(
                "--convert takes one recording: give it one after another",
            ));
        }
        let recipe = self.recipe().map_err(Failure::Input)?;
        let (files, mut unread) = recordings(&self.runs);
        if files.is_empty() {
            return Err(Failure::Input(unread));
        }
        let mut found = look(&recipe, &files, Depth::Figures).map_err(Failure::Input)?;
        unread.append(&mut found.faults);
        found.faults = unread;
        if let Some(target) = &self.json {
            target.write(&found)?;
        }
        tell(&look_text(&found), self.json.as_ref())?;
        let Look { faults, .. } = found;
        if !faults.is_empty() {
            return Err(Failure::Told(faults));
        }
        self.write_converted(&recipe, &files)
    }

    fn recipe(&self) -> Result<Recipe, Vec<Fault>> {
        let Some(path) = &self.recipe else {
            return Ok(Recipe::default());
        };
        Recipe::from_text(&read_file(path)?, format_of(path))
    }

    fn write_converted(&self, recipe: &Recipe, files: &[NamedText]) -> Result<(), Failure> {
        let (Some(path), [file]) = (&self.convert, files) else {
            return Ok(());
        };
        let text = converted(recipe, file).map_err(Failure::Told)?;
        write(path, text.as_bytes())
    }
}
