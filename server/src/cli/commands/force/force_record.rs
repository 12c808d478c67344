//! `strainsite force record`.

use std::path::PathBuf;
use std::sync::Arc;

use clap::Args;
use documents::study::plan::PlannedStudy;
use results::StudyResult;
use service::forces::recorded_texts::NamedText;
use service::forces::rig_recording::{Finished, RECIPE, RecordFailure, run_name};
use service::study_document::{named_files, read_changed};

use crate::cli::commands::run::study_runner::StudyRunner;
use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::tell;
use crate::cli::terminal::output_place::write;
use crate::config::Config;

#[derive(Debug, Args)]
pub(crate) struct Record {
    /// Study with a rig, TOML or JSON
    study: PathBuf,
    /// Set a field of the study or its scene otherwise; may be given more than once
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Rank of the layout whose films are read
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    layout: u32,
    /// Write the recordings and the recipe that reads them into this folder
    #[arg(short, long, value_name = "DIR", default_value = "recordings")]
    output: PathBuf,
    #[command(flatten)]
    config: Config,
    #[command(flatten)]
    solver: SolverOption,
}

impl Record {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        Files::of_database(&self.config.db)
            .reading(named_files(&self.study))
            .filling(Some(&self.output), &[RECIPE, &run_name(0)])
    }

    /// Runs the study, or takes its answer from the database, and lets the rig step on its tire.
    pub fn execute(&self) -> Result<(), Failure> {
        let planned = read_changed(&self.study, &self.set).map_err(Failure::Input)?;
        if planned.study.rig.is_none() {
            return Err(Failure::input(
                "the study has no rig: add a table [rig]; it may be empty",
            ));
        }
        let planned = Arc::new(planned);
        let runner = StudyRunner::open(&self.config, &self.solver, &planned)?;
        let texts = runner.answered(&planned.study, |result| {
            self.recordings(&runner, &planned, result)
        })?;
        self.written(&texts)
    }

    fn recordings(
        &self,
        runner: &StudyRunner<'_>,
        planned: &PlannedStudy,
        result: &StudyResult,
    ) -> Result<Vec<NamedText>, Failure> {
        let finished = Finished {
            engine: &runner.engine,
            planned,
            result,
            runtime: runner.runtime.handle(),
            stop: &runner.stop,
        };
        let found = finished.recordings(self.layout as usize);
        found.map_err(|failure| match failure {
            RecordFailure::Input(detail) => Failure::input(detail),
            other => Failure::other(other),
        })
    }

    fn written(&self, texts: &[NamedText]) -> Result<(), Failure> {
        std::fs::create_dir_all(&self.output).map_err(|error| {
            Failure::Other(format!("{} can't be made: {error}", self.output.display()))
        })?;
        let mut paths = Vec::new();
        for NamedText { name, text } in texts {
            let path = self.output.join(name);
            write(&path, text.as_bytes())?;
            paths.push(path.display().to_string());
        }
        let recipe = paths.pop().unwrap_or_default();
        tell(
            &format!(
                "{}\nread by: strainsite force fit {recipe} {}\n",
                paths.join("\n"),
                paths.join(" ")
            ),
            None,
        )
    }
}
