//! `strainsite tasks make`: what a sweep still lacks, as tasks of some minutes.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use clap::Args;
use placement::estimate::Workload;
use serde::Serialize;
use tokio::runtime::Runtime;

use super::task_folder::{Task, TaskFolder, Tasks};
use crate::cli::commands::sweep::asked::Asked;
use crate::cli::commands::sweep::designs::{grouped, keys, workload};
use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell};
use crate::cli::terminal::report::next_steps::shell_word;
use crate::config::{Config, minutes};
use service::engine::Engine;
use service::forecast::forecast_designs;
use service::queue::recover;
use service::queue::sweeps::designs_of;
use store::StoreError;
use store::merging::target::Merging;

/// Write the designs that a sweep still lacks into a folder
#[derive(Debug, Args)]
pub(super) struct Make {
    #[command(flatten)]
    asked: Asked,
    /// Folder of the tasks, which isn't there yet and which all machines see
    #[arg(long, value_name = "FOLDER")]
    dir: PathBuf,
    /// Time that a task should take on this machine's threads, minutes
    #[arg(long, value_name = "N", default_value = "10", value_parser = minutes)]
    minutes: f64,
    #[command(flatten)]
    config: Config,
    #[command(flatten)]
    solver: SolverOption,
    /// Write folder, program and tasks as JSON to a file, or to standard output with -
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<JsonTarget>,
}

/// Task with the points that its designs would ask for and that are known here.
struct Given {
    task: Task,
    known: Vec<String>,
}

/// Tasks that were made, as JSON.
#[derive(Debug, Serialize)]
struct Made<'m> {
    folder: &'m Path,
    program: &'m Path,
    sweep: &'m str,
    tasks: &'m [Task],
}

impl Make {
    pub fn files(&self) -> Files {
        Files::of_database(&self.config.db)
            .reading(self.asked.files())
            .telling(self.json.as_ref())
    }

    pub fn execute(&self) -> Result<(), Failure> {
        let plan = self.asked.plan()?;
        let runtime = Runtime::new().map_err(Failure::other)?;
        if self.dir.exists() {
            return Err(Failure::input(format!(
                "{} is there already: tasks are written to a folder that isn't",
                self.dir.display()
            )));
        }
        let solver = self.solver.solver().map_err(Failure::other)?;
        let opened = runtime.block_on(self.config.open());
        let engine = self
            .config
            .work
            .engine(solver, opened.map_err(Failure::other)?);
        let recovered = runtime.block_on(recover(&engine.store));
        recovered.map_err(Failure::other)?;
        let there = self.config.memory_bytes();
        let stored = self.asked.stored(&runtime, &engine, plan.as_ref(), there);
        let given = stored.and_then(|sweep| {
            let given = runtime.block_on(self.given(&engine, &sweep.id));
            Ok((sweep.id, given.map_err(Failure::other)?))
        });
        let closed = runtime.block_on(engine.store.close());
        let version = engine.solver.version();
        // The lock on the database goes with the store.
        drop(engine);
        let (sweep, given) = given?;
        closed.map_err(Failure::other)?;
        let folder = TaskFolder::new(&self.dir)?;
        let written = runtime.block_on(write(&self.config.db, &folder, &given));
        written.map_err(Failure::other)?;
        let program = folder.with_program()?;
        let tasks = Tasks {
            version,
            sweep,
            tasks: given.into_iter().map(|given| given.task).collect(),
        };
        folder.write(&tasks)?;
        self.tell(&folder, &program, &tasks)
    }

    /// Designs without a result, those that share points together, packed into tasks.
    async fn given(&self, engine: &Engine, sweep: &str) -> Result<Vec<Given>, StoreError> {
        let mut designs = designs_of(&engine.store, sweep).await?;
        designs.retain(|design| !design.study.ended());
        let solver = engine.solver.as_ref();
        let works: Vec<Option<Workload>> = designs
            .iter()
            .map(|design| workload(design, solver))
            .collect();
        let (expected, known) =
            forecast_designs(&engine.store, &engine.solver, engine.threads, &works).await?;
        let most_s = 60.0 * self.minutes;
        // What nobody can estimate is a task of its own.
        let time_s = |design: usize| expected[design].unwrap_or(most_s);
        let tasks = packed(grouped(works.iter().map(keys)), time_s, most_s);
        let given = |task: Vec<usize>| {
            let of_task = task
                .iter()
                .flat_map(|&design| works[design].iter().flat_map(Workload::keys));
            let shared: HashSet<&str> = of_task.filter(|key| known.contains(*key)).collect();
            let times: Option<Vec<f64>> = task.iter().map(|&design| expected[design]).collect();
            Given {
                known: shared.into_iter().map(str::to_owned).collect(),
                task: Task {
                    studies: task
                        .iter()
                        .map(|&design| designs[design].study.id.clone())
                        .collect(),
                    expected_s: times.map(|times| times.iter().sum()),
                },
            }
        };
        Ok(tasks.into_iter().map(given).collect())
    }

    fn tell(&self, folder: &TaskFolder, program: &Path, tasks: &Tasks) -> Result<(), Failure> {
        if let Some(target) = &self.json {
            target.write(&Made {
                folder: folder.path(),
                program,
                sweep: &tasks.sweep,
                tasks: &tasks.tasks,
            })?;
        }
        tell(
            &told(folder, program, tasks, &self.config.db),
            self.json.as_ref(),
        )
    }
}

/// Groups of designs joined in their order, as long as they take no longer together than this, s.
fn packed(groups: Vec<Vec<usize>>, time_s: impl Fn(usize) -> f64, most_s: f64) -> Vec<Vec<usize>> {
    let mut tasks: Vec<Vec<usize>> = Vec::new();
    let mut filled_s = 0.0;
    for group in groups {
        let own_s: f64 = group.iter().map(|&design| time_s(design)).sum();
        match tasks.last_mut() {
            Some(last) if filled_s + own_s <= most_s => {
                last.extend(group);
                filled_s += own_s;
            }
            _ => {
                tasks.push(group);
                filled_s = own_s;
            }
        }
    }
    tasks
}

/// Writes the database of each task.
async fn write(database: &Path, folder: &TaskFolder, given: &[Given]) -> Result<(), StoreError> {
    let mut head = Merging::open(database).await?;
    for (index, given) in given.iter().enumerate() {
        let file = folder.asked(index + 1);
        head.give(&file, &given.task.studies, &given.known).await?;
    }
    head.close().await
}

fn told(folder: &TaskFolder, program: &Path, tasks: &Tasks, database: &Path) -> String {
    let count = tasks.tasks.len();
    if count == 0 {
        return "nothing is left to do: every design of the sweep has come to an end\n".to_owned();
    }
    let designs: usize = tasks.tasks.iter().map(|task| task.studies.len()).sum();
    let expected = tasks.tasks.iter().filter_map(|task| task.expected_s);
    let longest = expected.reduce(f64::max).map_or(String::new(), |longest| {
        format!(", the longest about {longest:.0} s on this machine")
    });
    let (dir, program) = (shell_word(folder.path()), shell_word(program));
    let database = shell_word(database);
    let of = |count: usize, one: &str| match count {
        1 => format!("1 {one}"),
        count => format!("{count} {one}s"),
    };
    format!(
        "{} of {} in {dir}{longest}\n\
         \x20 on any machine    {program} tasks run {dir} N      # N from 1 to {count}\n\
         \x20 all of them here  seq {count} | xargs -I N {program} tasks run {dir} N\n\
         \x20 then              strainsite tasks gather {dir} --db {database}\n",
        of(count, "task"),
        of(designs, "design"),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tasks_are_as_long_as_was_asked_and_no_group_is_divided() {
        let groups = vec![vec![0], vec![1, 2], vec![3], vec![4, 5, 6], vec![7]];
        let packed = |most_s: f64| packed(groups.clone(), |_| 10.0, most_s);
        assert_eq!(packed(1e9), [(0..8).collect::<Vec<_>>()]);
        assert_eq!(packed(1.0), groups);
        assert_eq!(
            packed(30.0),
            [vec![0, 1, 2], vec![3], vec![4, 5, 6], vec![7]]
        );
        assert_eq!(packed(40.0), [vec![0, 1, 2, 3], vec![4, 5, 6, 7]]);
    }
}
