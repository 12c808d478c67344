//! `strainsite run`: one study without the service, with the same engine and the same database.

mod film_figures;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use fem_client::solver::NoEquilibrium;
use placement::result::{FailedPoint, StudyResult};
use placement::study::Study;
use placement::study::plan::PlannedStudy;
use serde_json::json;
use tokio::runtime::Runtime;

use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::estimate_text::{dry_run, estimated};
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell};
use crate::cli::terminal::output_place::write;
use crate::cli::terminal::progress::{progress_bar, show};
use crate::cli::terminal::report::report;
use crate::cli::terminal::signals::stop_flag;
use crate::config::Config;
use service::engine::{End, Engine};
use service::export::{Export, ExportSources, FileFormat, Table};
use service::forecast::{admit, forecast};
use service::metrics::Metrics;
use service::queue::{enqueue, recover};
use service::study_document::{named_files, read_changed};
use store::queue::study_rows::{self, StudyRow};
use store::queue::turns;
use store::{Store, StoreError};

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
    /// Say what the study would cost, and solve nothing
    #[arg(long, conflicts_with = "out")]
    dry_run: bool,
    /// Write result.json and locations.csv into this folder, and of films' signals signals.csv, figure-4.svg and figure-5.svg
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write the result as JSON to a file, or to standard output with -
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<JsonTarget>,
}

impl Run {
    /// What it reads and writes.
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
        let runtime = Runtime::new().map_err(Failure::other)?;
        if self.dry_run {
            return self.estimate(&runtime, &planned);
        }
        let solver = self.solver.solver().map_err(Failure::other)?;
        let (threads, memory_bytes) = (self.config.threads(), self.config.memory_bytes());
        runtime
            .block_on(admit(&solver, threads, memory_bytes, &planned))
            .map_err(|error| Failure::input(error.to_string()))?;
        let store = runtime
            .block_on(self.config.open())
            .map_err(Failure::other)?;
        let engine = Engine {
            store: Arc::new(store),
            solver,
            threads,
            metrics: Metrics::new(),
            live: Arc::default(),
        };
        let end = self.solve(&runtime, &engine, &planned.study);
        let closed = runtime.block_on(engine.store.close());
        let end = end?;
        closed.map_err(Failure::other)?;
        self.answer(end)
    }

    fn estimate(&self, runtime: &Runtime, planned: &Arc<PlannedStudy>) -> Result<(), Failure> {
        let solver = self.solver.solver().map_err(Failure::other)?;
        let threads = self.config.threads();
        let estimate = estimated(runtime, &self.config.db, async |store| {
            forecast(store, &solver, threads, planned).await
        })?;
        if let Some(target) = &self.json {
            target.write(&estimate)?;
        }
        tell(&dry_run(&planned.study.name, &estimate), self.json.as_ref())
    }

    fn solve(&self, runtime: &Runtime, engine: &Engine, study: &Study) -> Result<End, Failure> {
        let row = runtime
            .block_on(claim(&engine.store, study))
            .map_err(Failure::other)?;
        let stop = stop_flag(runtime)?;
        let bar = progress_bar("");
        let end = engine.run(&row, runtime.handle(), &stop, None, &|event| {
            show(&bar, event)
        });
        bar.finish_and_clear();
        runtime
            .block_on(engine.settle(&row, &end))
            .map_err(Failure::other)?;
        Ok(end)
    }

    fn answer(&self, end: End) -> Result<(), Failure> {
        match end {
            End::Done(result) => self.publish(&result),
            End::Failed { error, points } => Err(failure(error, &points)),
            End::Unstorable(error) => Err(Failure::other(error)),
            End::Stopped | End::Paused => Err(Failure::Other(format!(
                "stopped; what is solved is kept in {}, and the next run of this study resumes there",
                self.config.db.display()
            ))),
        }
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
        tell(&report(result), self.json.as_ref())
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

/// Takes the interrupted study of the same document up again, or stores a new one.
async fn claim(store: &Store, study: &Study) -> Result<StudyRow, StoreError> {
    recover(store).await?;
    let mut transaction = store.begin().await?;
    let sha256 = study.spec_sha256();
    let id = match study_rows::queued_twin(&mut transaction, &sha256).await? {
        Some(row) => row.id,
        None => enqueue(&mut transaction, study, 0).await?,
    };
    let row = turns::claim(&mut transaction, &id).await?;
    store.commit(transaction, 0).await?;
    row.ok_or(StoreError::Database(sqlx::Error::RowNotFound))
}

/// The physics is to blame when every point that failed has no equilibrium.
fn failure(error: String, points: &[FailedPoint]) -> Failure {
    let physical = |point: &FailedPoint| {
        let status = point.cause.status?;
        NoEquilibrium::ALL.contains(&status).then_some(status)
    };
    let statuses: Option<Vec<NoEquilibrium>> = points.iter().map(physical).collect();
    match statuses.as_deref().and_then(<[NoEquilibrium]>::first) {
        Some(status) => Failure::Physics {
            status: status.as_str().to_owned(),
            detail: error,
            known: json!({"failed_points": points}),
        },
        None => Failure::Other(error),
    }
}
