//! `strainsite tasks run`: a task on this machine.
//!
//! It works in a database of its own on this machine's disk, and hands it in whole, under its name at once. Stopped, it hands in what it has, and begun again it goes on from there.

use std::path::{Path, PathBuf};

use clap::Args;
use placement::sharing::Part;
use serde_json::Map;
use tokio::runtime::Runtime;

use crate::cli::commands::sweep::designs::Crew;
use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::output::tell;
use crate::cli::terminal::progress::{progress_bar, show};
use crate::cli::terminal::signals::stop_flag;
use crate::config::Work;
use service::queue::recover;
use store::queue::design_rows::DesignRow;
use store::queue::study_rows;
use store::{Store, StoreError};
use tasks::handing_in::hand_in;
use tasks::task_folder::{Refusal, Task, TaskFolder, Tasks};

/// Do a task on this machine
#[derive(Debug, Args)]
pub(super) struct Run {
    /// Folder of the tasks
    #[arg(value_name = "FOLDER")]
    dir: PathBuf,
    /// Number of the task, from 1
    #[arg(value_name = "N")]
    number: usize,
    /// File that is handed in; done/N.db of the folder when absent
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    work: Work,
    #[command(flatten)]
    solver: SolverOption,
}

impl Run {
    pub fn execute(&self) -> Result<(), Failure> {
        let (folder, tasks) = TaskFolder::open(&self.dir)?;
        let task = self
            .number
            .checked_sub(1)
            .and_then(|index| tasks.tasks.get(index));
        let task = task.ok_or_else(|| {
            Failure::input(format!(
                "there is no task {}: the folder has {}",
                self.number,
                tasks.tasks.len()
            ))
        })?;
        if let Some(refusal) = self.refusal(&tasks)? {
            folder.refuse(self.number, &refusal)?;
            return Err(Failure::Other(refusal.because));
        }
        let target = self
            .output
            .clone()
            .unwrap_or_else(|| folder.done(self.number));
        let begun = match target.exists() {
            true => target.clone(),
            false => folder.asked(self.number),
        };
        let runtime = Runtime::new().map_err(Failure::other)?;
        let disk = tempfile::tempdir().map_err(Failure::other)?;
        let own = disk.path().join("task.db");
        std::fs::copy(&begun, &own).map_err(|error| {
            Failure::Other(format!("{} can't be copied: {error}", begun.display()))
        })?;
        let solved = self.solve(&runtime, &own, task)?;
        let solver = self.solver.solver().map_err(Failure::other)?;
        runtime.block_on(hand_in(&own, &target, (task, tasks.kept), &solver))?;
        folder.accept(self.number);
        self.tell(&solved, task, &target)
    }

    /// Reason why this machine's points would be of no use, where they wouldn't.
    fn refusal(&self, tasks: &Tasks) -> Result<Option<Refusal>, Failure> {
        let own = self.solver.solver().map_err(Failure::other)?.version();
        if own == tasks.version {
            return Ok(None);
        }
        let node = node();
        let because = format!(
            "{node} computes otherwise than the machine that made the tasks, which would find none of its points: {own} here, {} there; let tasks run on machines of that kind (Slurm: --constraint)",
            tasks.version
        );
        Ok(Some(Refusal { node, because }))
    }

    /// Solves what the database of a task lacks; returns how many designs have ended.
    fn solve(&self, runtime: &Runtime, database: &Path, task: &Task) -> Result<Solved, Failure> {
        let store = runtime
            .block_on(Store::open(database))
            .map_err(Failure::other)?;
        let solver = self.solver.solver().map_err(Failure::other)?;
        let engine = self.work.engine(solver, store);
        let stop = stop_flag(runtime)?;
        let crew = Crew {
            runtime: runtime.handle(),
            engine: &engine,
            solver: &|| self.solver.solver().map_err(Failure::other),
            memory_bytes: self.work.memory_bytes(),
            stop: &stop,
        };
        let recovered = runtime.block_on(recover(&engine.store));
        recovered.map_err(Failure::other)?;
        let designs = || {
            runtime
                .block_on(designs(&engine.store, task))
                .map_err(Failure::other)
        };
        let bar = progress_bar("");
        let solved = match (task.part, designs()?.as_slice()) {
            (Some(part), [only]) => {
                let (study, handle) = (&only.study, runtime.handle());
                let solved = engine.solve_part(study, Some(part), handle, &stop, &|event| {
                    show(&bar, event);
                });
                solved.map_err(Failure::Other)
            }
            (_, designs) => crew.run(designs, &bar),
        };
        bar.finish_and_clear();
        let ended = designs()?
            .iter()
            .filter(|design| design.study.ended())
            .count();
        let closed = runtime.block_on(engine.store.close());
        closed.map_err(Failure::other)?;
        Ok(Solved {
            ended,
            whole: solved?,
        })
    }

    fn tell(&self, solved: &Solved, task: &Task, target: &Path) -> Result<(), Failure> {
        let of = task.studies.len();
        let said = match task.part {
            Some(Part { number, of }) => {
                format!("part {number} of {of} of the points of its study")
            }
            None => format!("{} of {of} designs have ended", solved.ended),
        };
        let text = format!(
            "task {}: {said}; handed in as {}\n",
            self.number,
            target.display()
        );
        tell(&text, None)?;
        match solved.whole && (task.part.is_some() || solved.ended == of) {
            true => Ok(()),
            false => Err(Failure::Partial(format!(
                "task {} isn't whole: give it once more, and it goes on from what was handed in",
                self.number
            ))),
        }
    }
}

/// Outcome of a task.
struct Solved {
    /// Designs that have ended.
    ended: usize,
    /// Whether nobody stopped it.
    whole: bool,
}

/// The studies of a task, as designs.
async fn designs(store: &Store, task: &Task) -> Result<Vec<DesignRow>, StoreError> {
    let mut connection = store.read().await?;
    let mut designs = Vec::new();
    for (ordinal, id) in (0..).zip(&task.studies) {
        if let Some(study) = study_rows::find(&mut connection, id).await? {
            designs.push(DesignRow {
                ordinal,
                name: study.name.clone(),
                set: Map::new(),
                study,
            });
        }
    }
    Ok(designs)
}

/// Name of this machine, as whoever starts programs on it knows it.
fn node() -> String {
    let told = std::env::var("SLURMD_NODENAME").ok();
    let own = || std::fs::read_to_string("/proc/sys/kernel/hostname").ok();
    told.or_else(own)
        .map_or_else(|| "this machine".to_owned(), |name| name.trim().to_owned())
}
