//! `strainsite sweep`: one study over a grid of designs, without the service.

mod designs;

use std::path::PathBuf;
use std::sync::Arc;

use clap::Args;
use documents::study::Study;
use documents::sweep::{self as placed, Design, Sweep as Plan, sweep_of, typed_grid};
use placement::compare::{Comparison, compare};
use serde_json::json;
use tokio::runtime::Runtime;

use crate::cli::commands::compare::table;
use crate::cli::commands::library;
use crate::cli::commands::sweep::designs::Crew;
use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::estimate_text::{dry_sweep, estimated};
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell};
use crate::cli::terminal::progress::progress_bar;
use crate::cli::terminal::report::next_steps::after_sweep;
use crate::cli::terminal::signals::stop_flag;
use crate::config::Config;
use service::comparison::of_designs;
use service::engine::Engine;
use service::forecast::{admit, forecast_sweep, plan_study};
use service::metrics::Metrics;
use service::queue::recover;
use service::queue::sweeps::{Continuation, designs_of, store};
use service::study_document::{named_files, read_changed, stored_base};
use service::wire::sweep_wire::SweepDetail;
use service::work::memory_share::MemoryShare;
use store::queue::sweep_rows::{self, SweepRow};
use store::{Store, StoreError};

/// Run one study over a grid of designs, and compare them
#[derive(Debug, Args)]
pub struct Sweep {
    /// Study file, TOML or JSON, or the name of a shipped study
    #[arg(required_unless_present = "resume", conflicts_with = "resume")]
    study: Option<PathBuf>,
    /// Values that a field takes, as in geometry.wall_mm=2.5,3,3.5; given more than once, every combination is a design
    #[arg(long, value_name = "KEY=V1,V2,...", required_unless_present = "resume")]
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
    #[command(flatten)]
    config: Config,
    #[command(flatten)]
    solver: SolverOption,
    /// Say what the sweep would cost, and solve nothing
    #[arg(long, conflicts_with = "resume")]
    dry_run: bool,
    /// Write sweep and comparison as JSON to a file, or to standard output with -
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<JsonTarget>,
}

impl Sweep {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        let study = self.study.as_deref().map(named_files);
        Files::of_database(&self.config.db)
            .reading(study.unwrap_or_default())
            .telling(self.json.as_ref())
    }

    /// Runs the designs that have no result yet, and prints the comparison.
    pub fn execute(&self) -> Result<(), Failure> {
        let plan = self
            .study
            .as_ref()
            .map(|path| self.plan(path))
            .transpose()?;
        let runtime = Runtime::new().map_err(Failure::other)?;
        if let (true, Some(plan)) = (self.dry_run, &plan) {
            return self.estimate(&runtime, plan);
        }
        let engine = Engine {
            solver: self.solver.solver().map_err(Failure::other)?,
            store: Arc::new(
                runtime
                    .block_on(self.config.open())
                    .map_err(Failure::other)?,
            ),
            threads: self.config.threads(),
            metrics: Metrics::new(),
            live: Arc::default(),
            memory: Arc::new(MemoryShare::new(self.config.memory_bytes())),
        };
        let ended = self.run(&runtime, &engine, plan.as_ref());
        let closed = runtime.block_on(engine.store.close());
        let (detail, comparison) = ended?;
        closed.map_err(Failure::other)?;
        if let Some(target) = &self.json {
            target.write(&json!({"sweep": detail, "comparison": comparison}))?;
        }
        let next = after_sweep(&detail.summary.id, &self.config.db);
        tell(&(table(&comparison) + &next), self.json.as_ref())?;
        let without = detail.designs.len() - detail.summary.counts.done;
        if without > 0 {
            return Err(Failure::Partial(format!(
                "{without} of {} designs have no result: the reasons stand above",
                detail.designs.len()
            )));
        }
        Ok(())
    }

    fn plan(&self, path: &std::path::Path) -> Result<Plan, Failure> {
        let base = read_changed(path, &self.set).map_err(Failure::Input)?.study;
        let grid = typed_grid(&self.grid).map_err(Failure::Input)?;
        sweep_of(base, self.name.as_deref(), &grid).map_err(Failure::Input)
    }

    fn estimate(&self, runtime: &Runtime, plan: &Plan) -> Result<(), Failure> {
        let solver = self.solver.solver().map_err(Failure::other)?;
        let threads = self.config.threads();
        let estimate = estimated(runtime, &self.config.db, async |store| {
            forecast_sweep(store, &solver, threads, plan).await
        })?;
        if let Some(target) = &self.json {
            target.write(&estimate)?;
        }
        tell(
            &dry_sweep(&plan.name, threads, &estimate),
            self.json.as_ref(),
        )
    }

    fn run(
        &self,
        runtime: &Runtime,
        engine: &Engine,
        plan: Option<&Plan>,
    ) -> Result<(SweepDetail, Comparison), Failure> {
        runtime
            .block_on(recover(&engine.store))
            .map_err(Failure::other)?;
        let sweep = self.stored(runtime, engine, plan)?;
        let stop = stop_flag(runtime)?;
        let designs = || {
            let found = runtime.block_on(designs_of(&engine.store, &sweep.id));
            found.map_err(Failure::other)
        };
        let bar = progress_bar("");
        let all = designs()?;
        let crew = Crew {
            runtime: runtime.handle(),
            engine,
            solver: &|| self.solver.solver().map_err(Failure::other),
            memory_bytes: self.config.memory_bytes(),
            stop: &stop,
        };
        let whole = crew.run(&all, &bar);
        if !whole? {
            bar.finish_and_clear();
            return Err(Failure::Other(format!(
                "stopped; what is solved is kept in {}: strainsite sweep --resume {} goes on",
                self.config.db.display(),
                sweep.id
            )));
        }
        bar.finish_and_clear();
        let ended = designs()?;
        let entries = runtime.block_on(async {
            let mut connection = engine.store.read().await?;
            of_designs(&mut connection, &ended).await
        });
        let comparison = compare(&entries.map_err(Failure::other)?, None);
        let detail = SweepDetail::of(&sweep, &ended).map_err(Failure::other)?;
        Ok((detail, comparison))
    }

    /// The sweep, new or gone on with, in the database.
    fn stored(
        &self,
        runtime: &Runtime,
        engine: &Engine,
        plan: Option<&Plan>,
    ) -> Result<SweepRow, Failure> {
        let admit_all = |designs: &[Design]| {
            let there = self.config.memory_bytes();
            designs.iter().try_for_each(|design| {
                let admitted = async {
                    let planned = plan_study(&design.study).await?;
                    admit(&engine.solver, engine.threads, there, &planned).await
                };
                runtime
                    .block_on(admitted)
                    .map_err(|error| Failure::input(format!("{}: {error}", design.name)))
            })
        };
        let Some(plan) = plan else {
            let wanted = self.resume.as_deref().unwrap_or_default();
            let sweep = runtime.block_on(sweep_named(&engine.store, wanted))?;
            let base = stored_base(&sweep).map_err(Failure::Other)?;
            let further = self.further(&base)?;
            admit_all(&further)?;
            let there = runtime
                .block_on(designs_of(&engine.store, &sweep.id))
                .map_err(Failure::other)?;
            let continuation = Continuation::resuming(&there).and_adding(&there, further);
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
        placed::designs_of(base, &document).map_err(Failure::Input)
    }
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
