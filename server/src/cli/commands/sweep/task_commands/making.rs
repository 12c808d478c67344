//! `strainsite tasks make`: what a sweep still lacks, as tasks of some minutes.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use clap::Args;
use serde::Serialize;
use tokio::runtime::Runtime;

use crate::cli::commands::sweep::asked::{Asked, with_engine};
use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell};
use crate::cli::terminal::report::next_steps::shell_word;
use crate::cli::terminal::signals::stop_flag;
use crate::config::{Config, minutes};
use store::merging::target::Merging;
use tasks::packing::{Packer, write};
use tasks::task_folder::{Kept, Task, TaskFolder, Tasks};

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
    /// Part that machines hand in of what they solve
    #[arg(long, value_enum, value_name = "PART", default_value = "everything")]
    keep: Kept,
    #[command(flatten)]
    config: Config,
    #[command(flatten)]
    solver: SolverOption,
    /// Write folder, program and tasks as JSON to a file, or to standard output with -
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<JsonTarget>,
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
        let (there, stop) = (self.config.memory_bytes(), stop_flag(&runtime)?);
        let (version, sweep, given) =
            with_engine(&runtime, &self.config, &self.solver, |engine| {
                let sweep = self.asked.stored(&runtime, engine, plan.as_ref(), there)?;
                let packer = Packer {
                    runtime: runtime.handle(),
                    engine,
                    minutes: self.minutes,
                    stop: &stop,
                };
                let given = packer.pack(&sweep.id)?;
                Ok((engine.solver.version(), sweep.id, given))
            })?;
        let head = runtime.block_on(Merging::open(&self.config.db));
        let head = head.map_err(Failure::other)?;
        let of = (version, sweep, self.keep);
        let (folder, tasks, program) = write(runtime.handle(), head, &self.dir, of, given)?;
        self.tell(&folder, &program, &tasks)
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

fn told(folder: &TaskFolder, program: &Path, tasks: &Tasks, database: &Path) -> String {
    let count = tasks.tasks.len();
    if count == 0 {
        return "nothing is left to do: every design of the sweep has come to an end\n".to_owned();
    }
    let designs: HashSet<&String> = tasks.tasks.iter().flat_map(|task| &task.studies).collect();
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
        of(designs.len(), "design"),
    )
}
