//! `strainsite run`: one study without the service, with the same engine and the same database.

mod film_figures;
pub(crate) mod study_runner;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use documents::study::plan::PlannedStudy;
use results::StudyResult;
use tokio::runtime::Runtime;

use crate::cli::commands::run::study_runner::StudyRunner;
use crate::cli::commands::sweep::asked::{stored_alone, with_engine};
use crate::cli::commands::sweep::elsewhere::{Elsewhere, OwnMeans};
use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::estimate_text::{dry_run, estimated};
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell};
use crate::cli::terminal::output_place::write;
use crate::cli::terminal::report::next_steps::after_study;
use crate::cli::terminal::report::report;
use crate::cli::terminal::signals::stop_flag;
use crate::config::Config;
use service::export::{Export, ExportSources, FileFormat, Table};
use service::forecast::{admit, forecast};
use service::study_document::{named_files, read_changed};
use tasks::engines::Engine as OtherEngine;

/// Run one study without the service
#[derive(Debug, Args)]
pub struct Run {
    /// Study file, TOML or JSON, or the name of a shipped study
    study: PathBuf,
    /// Set a field of the study or its scene otherwise; may be given more than once
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    #[command(flatten)]
    config: Config,
    #[command(flatten)]
    solver: SolverOption,
    #[command(flatten)]
    elsewhere: Elsewhere,
    /// Say what the study would cost, and solve nothing
    #[arg(long, conflicts_with_all = ["out", "engine"])]
    dry_run: bool,
    /// Write result.json and locations.csv into this folder, and of films' signals signals.csv, figure-4.svg and figure-5.svg
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write the result as JSON to a file, or to standard output with -
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<JsonTarget>,
}

impl Run {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        Files::of_database(&self.config.db)
            .reading(named_files(&self.study))
            .telling(self.json.as_ref())
            .filling(self.out.as_deref(), &FILES)
    }

    /// Runs the study and prints its answer.
    pub fn execute(&self) -> Result<(), Failure> {
        let planned = read_changed(&self.study, &self.set).map_err(Failure::Input)?;
        let planned = Arc::new(planned);
        if self.dry_run {
            return self.estimate(&planned);
        }
        if let Some(mut engine) = self.elsewhere.engine()? {
            self.solve_elsewhere(&planned, engine.as_mut())?;
        }
        let runner = StudyRunner::open(&self.config, &self.solver, &planned)?;
        runner.answered(&planned.study, |result| self.publish(result))
    }

    /// Has other machines solve the study, or parts of a large one.
    fn solve_elsewhere(
        &self,
        planned: &Arc<PlannedStudy>,
        engine: &mut dyn OtherEngine,
    ) -> Result<(), Failure> {
        let runtime = Runtime::new().map_err(Failure::other)?;
        let stop = stop_flag(&runtime)?;
        let solver = self.solver.solver().map_err(Failure::other)?;
        let admitted = admit(
            &solver,
            self.config.threads(),
            self.config.memory_bytes(),
            planned,
        );
        let admitted = runtime.block_on(admitted);
        admitted.map_err(|error| Failure::input(error.to_string()))?;
        let sweep = with_engine(&runtime, &self.config, &self.solver, |engine| {
            stored_alone(&runtime, engine, &planned.study)
        })?;
        let means = OwnMeans {
            runtime: &runtime,
            config: &self.config,
            solver: &self.solver,
            stop: &stop,
        };
        self.elsewhere.solve(means, &sweep, engine)
    }

    fn estimate(&self, planned: &Arc<PlannedStudy>) -> Result<(), Failure> {
        let runtime = Runtime::new().map_err(Failure::other)?;
        let solver = self.solver.solver().map_err(Failure::other)?;
        let threads = self.config.threads();
        let estimate = estimated(&runtime, &self.config.db, async |store| {
            forecast(store, &solver, threads, planned).await
        })?;
        if let Some(target) = &self.json {
            target.write(&estimate)?;
        }
        tell(&dry_run(&planned.study.name, &estimate), self.json.as_ref())
    }

    fn publish(&self, result: &StudyResult) -> Result<(), Failure> {
        if let Some(folder) = &self.out {
            std::fs::create_dir_all(folder).map_err(|error| {
                Failure::Other(format!("{} can't be made: {error}", folder.display()))
            })?;
            JsonTarget::File(folder.join(RESULT)).write(result)?;
            write_table(&folder.join(LOCATIONS), Table::Locations, result)?;
            write_signals(folder, result)?;
        }
        if let Some(target) = &self.json {
            target.write(result)?;
        }
        let next = after_study(result, &self.config.db);
        tell(&(report(result) + &next), self.json.as_ref())
    }
}

/// The files of `--out`.
const RESULT: &str = "result.json";
const LOCATIONS: &str = "locations.csv";
const SIGNALS: &str = "signals.csv";
const FIGURE_4: &str = "figure-4.svg";
const FIGURE_5: &str = "figure-5.svg";
const FILES: [&str; 5] = [RESULT, LOCATIONS, SIGNALS, FIGURE_4, FIGURE_5];

fn write_table(path: &Path, table: Table, result: &StudyResult) -> Result<(), Failure> {
    let export = Export {
        format: FileFormat::Csv,
        table,
    };
    let sources = ExportSources::of(result.clone());
    write(path, &export.bytes(&sources).map_err(Failure::other)?)
}

/// Films' signals as a table and pictures, where the study asks for them.
fn write_signals(folder: &Path, result: &StudyResult) -> Result<(), Failure> {
    let Some(signals) = &result.signals else {
        return Ok(());
    };
    write_table(&folder.join(SIGNALS), Table::Signals, result)?;
    let figures = [
        (FIGURE_4, film_figures::figure_4(signals)),
        (FIGURE_5, film_figures::figure_5(signals)),
    ];
    for (name, drawn) in figures {
        write(&folder.join(name), drawn.map_err(Failure::Other)?.as_ref())?;
    }
    Ok(())
}
