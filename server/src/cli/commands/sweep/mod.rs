//! `strainsite sweep`: one study over a grid of designs, without the service.

pub(crate) mod asked;
mod designs;
pub(crate) mod elsewhere;
pub(crate) mod task_commands;

use std::sync::atomic::AtomicBool;

use clap::Args;
use documents::sweep::Sweep as Plan;
use placement::compare::{Comparison, MOST_TOLD, compare};
use serde_json::json;
use tokio::runtime::Runtime;

use crate::cli::commands::compare::table;
use crate::cli::commands::sweep::asked::{Asked, with_engine};
use crate::cli::commands::sweep::designs::Crew;
use crate::cli::commands::sweep::elsewhere::{Elsewhere, OwnMeans};
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
use service::forecast::forecast_sweep;
use service::queue::sweeps::{designs_of, standing_of};
use service::wire::sweep_wire::{DesignEstimate, SweepDetail};
use store::queue::sweep_rows::SweepRow;

/// Run one study over a grid of designs, and compare them
#[derive(Debug, Args)]
pub struct Sweep {
    #[command(flatten)]
    asked: Asked,
    #[command(flatten)]
    config: Config,
    #[command(flatten)]
    solver: SolverOption,
    #[command(flatten)]
    elsewhere: Elsewhere,
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
        Files::of_database(&self.config.db)
            .reading(self.asked.files())
            .telling(self.json.as_ref())
    }

    /// Runs the designs that have no result yet, and prints the comparison.
    pub fn execute(&self) -> Result<(), Failure> {
        if self.asked.is_alone() && !self.elsewhere.is_asked() {
            return Err(Failure::input(
                "a sweep needs --grid, as in --grid geometry.wall_mm=2.5,3; strainsite run STUDY runs a study alone",
            ));
        }
        let plan = self.asked.plan()?;
        let runtime = Runtime::new().map_err(Failure::other)?;
        if let (true, Some(plan)) = (self.dry_run, &plan) {
            return self.estimate(&runtime, plan);
        }
        let stop = stop_flag(&runtime)?;
        let there = self.config.memory_bytes();
        let asked = |engine: &Engine| self.asked.stored(&runtime, engine, plan.as_ref(), there);
        let solved = |engine: &Engine, sweep: &SweepRow| self.run(&runtime, engine, sweep, &stop);
        let (detail, comparison) = match self.elsewhere.engine()? {
            None => self.with_engine(&runtime, |engine| solved(engine, &asked(engine)?))?,
            Some(mut other) => {
                let sweep = self.with_engine(&runtime, asked)?;
                let means = OwnMeans {
                    runtime: &runtime,
                    config: &self.config,
                    solver: &self.solver,
                    stop: &stop,
                };
                self.elsewhere.solve(means, &sweep, other.as_mut())?;
                self.with_engine(&runtime, |engine| solved(engine, &sweep))?
            }
        };
        if let Some(target) = &self.json {
            target.write(&json!({"sweep": detail, "comparison": comparison}))?;
        }
        let next = after_sweep(&detail.summary.id, &self.config.db);
        let told = table(&comparison.best(MOST_TOLD));
        tell(&(told + &next), self.json.as_ref())?;
        let without = detail.designs.len() - detail.summary.counts.done;
        if without > 0 {
            return Err(Failure::Partial(format!(
                "{without} of {} designs have no result: the reasons stand above",
                detail.designs.len()
            )));
        }
        Ok(())
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
        let expected = |design: &DesignEstimate| Some(design.estimate.wall_s.as_ref()?.expected);
        let designs_s: Option<Vec<f64>> = estimate.designs.iter().map(expected).collect();
        let tasks = designs_s.map_or(String::new(), |all| self.elsewhere.foreseen(&all));
        let text = dry_sweep(&plan.name, threads, &estimate) + &tasks;
        tell(&text, self.json.as_ref())
    }

    fn with_engine<T>(
        &self,
        runtime: &Runtime,
        work: impl FnOnce(&Engine) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        with_engine(runtime, &self.config, &self.solver, work)
    }

    fn run(
        &self,
        runtime: &Runtime,
        engine: &Engine,
        sweep: &SweepRow,
        stop: &AtomicBool,
    ) -> Result<(SweepDetail, Comparison), Failure> {
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
            stop,
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
        let standing = runtime.block_on(standing_of(&engine.store, &sweep.id));
        let standing = standing.map_err(Failure::other)?;
        let detail = SweepDetail::of(sweep, &standing, &ended).map_err(Failure::other)?;
        Ok((detail, comparison))
    }
}
