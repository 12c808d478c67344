//! Sweep that a command is about: a study over a grid, stored when it is new, or one of the database.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;
use documents::study::Study;
use documents::sweep::{self as placed, Design, MOST_DESIGNS, Sweep as Plan, sweep_of, typed_grid};
use placement::points::worker_threads::in_parallel;
use serde_json::{Map, json};
use tokio::runtime::Runtime;

use crate::cli::commands::library;
use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::exit::Failure;
use crate::config::Config;
use service::engine::Engine;
use service::forecast::{admit, plan_study};
use service::queue::recover;
use service::queue::sweeps::{Continuation, designs_of, store};
use service::study_document::{named_files, read_changed, stored_base};
use store::queue::sweep_rows::{self, SweepRow};
use store::{Store, StoreError};

/// Sweep as the command line names it.
#[derive(Debug, Args)]
pub(super) struct Asked {
    /// Study file, TOML or JSON, or the name of a shipped study
    #[arg(required_unless_present = "resume", conflicts_with = "resume")]
    study: Option<PathBuf>,
    /// Values that a field takes, as in geometry.wall_mm=2.5,3,3.5; given more than once, every combination is a design
    #[arg(long, value_name = "KEY=V1,V2,...")]
    grid: Vec<String>,
    /// Set a field of the study or its scene otherwise in all designs; may be given more than once
    #[arg(long, value_name = "KEY=VALUE", conflicts_with = "resume")]
    set: Vec<String>,
    /// Go on with a sweep of the database, and with the designs of --grid beside its own
    #[arg(long, value_name = "ID")]
    resume: Option<String>,
    /// Name of the sweep; like its study when absent
    #[arg(long, value_name = "NAME", conflicts_with = "resume")]
    name: Option<String>,
}

impl Asked {
    /// Returns the files that are read for it.
    pub(super) fn files(&self) -> Vec<PathBuf> {
        let study = self.study.as_deref().map(named_files);
        study.unwrap_or_default()
    }

    /// Designs of a new sweep; none of one of the database.
    pub(super) fn plan(&self) -> Result<Option<Plan>, Failure> {
        let planned = |path: &PathBuf| {
            let base = read_changed(path, &self.set).map_err(Failure::Input)?.study;
            if self.grid.is_empty() {
                return Ok(alone(base, self.name.as_deref()));
            }
            let grid = typed_grid(&self.grid).map_err(Failure::Input)?;
            sweep_of(base, self.name.as_deref(), &grid).map_err(Failure::Input)
        };
        self.study.as_ref().map(planned).transpose()
    }

    /// Whether it is one study without a grid.
    pub(super) fn is_alone(&self) -> bool {
        self.study.is_some() && self.grid.is_empty()
    }

    /// The sweep, new or gone on with, in the database; none of its designs may take more memory than there is, bytes.
    pub(super) fn stored(
        &self,
        runtime: &Runtime,
        engine: &Engine,
        plan: Option<&Plan>,
        there: u64,
    ) -> Result<SweepRow, Failure> {
        runtime
            .block_on(recover(&engine.store))
            .map_err(Failure::other)?;
        let admit_all = |designs: &[Design]| {
            let admitted = |design: &Design| {
                let admitted = async {
                    let planned = plan_study(&design.study).await?;
                    admit(&engine.solver, engine.threads, there, &planned).await
                };
                runtime
                    .block_on(admitted)
                    .map_err(|error| Failure::input(format!("{}: {error}", design.name)))
            };
            let never = AtomicBool::new(false);
            let all = in_parallel(designs.len(), engine.threads, &never, |i| {
                admitted(&designs[i])
            });
            all.into_iter().flatten().collect::<Result<(), Failure>>()
        };
        let Some(plan) = plan else {
            let wanted = self.resume.as_deref().unwrap_or_default();
            let sweep = runtime.block_on(sweep_named(&engine.store, wanted))?;
            let base = stored_base(&sweep).map_err(Failure::Other)?;
            let further = self.further(&base)?;
            admit_all(&further)?;
            let known = runtime
                .block_on(designs_of(&engine.store, &sweep.id))
                .map_err(Failure::other)?;
            let continuation = Continuation::resuming(&known).and_adding(&known, further);
            let continuation = continuation.map_err(|error| Failure::input(error.to_string()))?;
            runtime
                .block_on(go_on(&engine.store, &sweep, &continuation))
                .map_err(Failure::other)?;
            return Ok(sweep);
        };
        admit_all(&plan.designs)?;
        runtime
            .block_on(new(&engine.store, plan))
            .map_err(Failure::other)
    }

    fn further(&self, base: &Study) -> Result<Vec<Design>, Failure> {
        if self.grid.is_empty() {
            return Ok(Vec::new());
        }
        let grid = typed_grid(&self.grid).map_err(Failure::Input)?;
        let document = json!({"grid": grid});
        placed::designs_of(base, &document, MOST_DESIGNS).map_err(Failure::Input)
    }
}

/// A study as the only design of a sweep of this name; of its own where none is given.
fn alone(base: Study, name: Option<&str>) -> Plan {
    let only = Design {
        name: base.name.clone(),
        set: Map::new(),
        study: base.clone(),
    };
    Plan {
        name: name.unwrap_or(&base.name).to_owned(),
        base,
        designs: vec![only],
    }
}

/// Stores a study as a sweep whose only design it is.
pub(crate) fn stored_alone(
    runtime: &Runtime,
    engine: &Engine,
    study: &Study,
) -> Result<SweepRow, Failure> {
    let plan = alone(study.clone(), None);
    let stored = runtime.block_on(async {
        recover(&engine.store).await?;
        new(&engine.store, &plan).await
    });
    stored.map_err(Failure::other)
}

/// Opens the database for a piece of work, and closes it whatever comes of that: its lock is free again.
pub(crate) fn with_engine<T>(
    runtime: &Runtime,
    config: &Config,
    solver: &SolverOption,
    work: impl FnOnce(&Engine) -> Result<T, Failure>,
) -> Result<T, Failure> {
    let solver = solver.solver().map_err(Failure::other)?;
    let opened = runtime.block_on(config.open());
    let engine = config.work.engine(solver, opened.map_err(Failure::other)?);
    let ended = work(&engine);
    let closed = runtime.block_on(engine.store.close());
    let ended = ended?;
    closed.map_err(Failure::other)?;
    Ok(ended)
}

async fn sweep_named(from: &Store, beginning: &str) -> Result<SweepRow, Failure> {
    let mut connection = from.read().await.map_err(Failure::other)?;
    library::sweep(&mut connection, beginning).await
}

async fn new(to: &Store, plan: &Plan) -> Result<SweepRow, StoreError> {
    let mut transaction = to.begin().await?;
    let id = store(&mut transaction, plan, 0).await?;
    let row = sweep_rows::find(&mut transaction, &id).await?;
    to.commit(transaction, 0).await?;
    row.ok_or(StoreError::Database(sqlx::Error::RowNotFound))
}

/// Puts back what has no result, and adds further designs.
async fn go_on(
    to: &Store,
    sweep: &SweepRow,
    continuation: &Continuation,
) -> Result<(), StoreError> {
    let mut transaction = to.begin().await?;
    continuation.store(&mut transaction, sweep).await?;
    to.commit(transaction, 0).await
}
