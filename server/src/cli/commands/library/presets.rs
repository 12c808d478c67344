//! `strainsite presets`: what can be named without a file.

use clap::Args;
use service::study_document::shipped::shipped;
use service::wire::study_wire::Preset;

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell};
use crate::cli::terminal::paint::header;

/// List the studies and scenes that ship, whose names stand for files
#[derive(Debug, Args)]
pub struct Presets {
    /// Write them with their documents as JSON to a file, or to standard output with -
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<JsonTarget>,
}

impl Presets {
    /// Returns the files that it writes.
    pub fn files(&self) -> Files {
        Files::default().telling(self.json.as_ref())
    }

    /// Prints a line for each.
    pub fn execute(&self) -> Result<(), Failure> {
        let all = shipped();
        if let Some(target) = &self.json {
            target.write(&all)?;
        }
        let studies = listed("studies, for run, trade and sweep", &all.studies);
        let scenes = listed(
            "scenes, for solve, and for scene = { preset = ... } of a study",
            &all.scenes,
        );
        tell(&format!("{studies}\n{scenes}"), self.json.as_ref())
    }
}

fn listed(title: &str, presets: &[Preset]) -> String {
    let line = |preset: &Preset| match preset.title == preset.name {
        true => format!("{}\n", preset.name),
        false => format!("{:<20} {}\n", preset.name, preset.title),
    };
    let lines: String = presets.iter().map(line).collect();
    header(&format!("{title}\n")) + &lines
}
