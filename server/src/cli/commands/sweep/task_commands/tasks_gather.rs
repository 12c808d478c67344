//! `strainsite tasks gather`: takes in what tasks handed in, each once one of its points gave the same bits here.

use std::path::PathBuf;

use clap::Args;
use placement::sharing::Part;
use tokio::runtime::Runtime;

use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell};
use crate::cli::terminal::paint::{BAD, GOOD, painted};
use crate::cli::terminal::progress::{count, counting_bar};
use crate::cli::terminal::report::next_steps::shell_word;
use store::merging::target::Merging;
use tasks::gathering::{Gathered, gather};
use tasks::task_folder::{Kept, TaskFolder};

/// Take in what was handed in
#[derive(Debug, Args)]
pub(super) struct Gather {
    /// Folder of the tasks
    #[arg(value_name = "FOLDER")]
    dir: PathBuf,
    /// Database that the tasks were made from
    #[arg(
        long,
        env = "STRAINSITE_DB",
        value_name = "FILE",
        default_value = "strainsite.db"
    )]
    db: PathBuf,
    /// Part that is kept of what tasks handed in
    #[arg(long, value_enum, value_name = "PART", default_value = "everything")]
    keep: Kept,
    #[command(flatten)]
    solver: SolverOption,
    /// Write what became of each task as JSON to a file, or to standard output with -
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<JsonTarget>,
}

impl Gather {
    pub fn files(&self) -> Files {
        Files::of_database(&self.db).telling(self.json.as_ref())
    }

    pub fn execute(&self) -> Result<(), Failure> {
        let (folder, tasks) = TaskFolder::open(&self.dir)?;
        let runtime = Runtime::new().map_err(Failure::other)?;
        let solver = self.solver.solver().map_err(Failure::other)?;
        let all: Vec<usize> = (1..=tasks.tasks.len()).collect();
        let bar = counting_bar(0, "rows");
        let seen = |done, of| count(&bar, done, of);
        let gathered = runtime.block_on(async {
            let head = Merging::open(&self.db).await?;
            gather(head, (&folder, &tasks), &all, (&solver, self.keep), &seen).await
        });
        bar.finish_and_clear();
        let gathered = gathered?;
        if let Some(target) = &self.json {
            target.write(&gathered)?;
        }
        let sum = |of: fn(&Gathered) -> usize| gathered.iter().map(of).sum::<usize>();
        let (ended, designs) = (sum(|one| one.ended), sum(|one| one.designs));
        let lines: String = gathered.iter().map(line).collect();
        let database = shell_word(&self.db);
        let text = format!(
            "{lines}{ended} of {designs} designs have ended\n  strainsite sweep --resume {} --db {database}  # solves what is left here, and compares\n",
            tasks.sweep
        );
        tell(&text, self.json.as_ref())?;
        match ended == designs && gathered.iter().all(|one| one.refused.is_none()) {
            true => Ok(()),
            false => Err(Failure::Partial(format!(
                "{} of {designs} designs are missing: the reasons stand above; tasks that are given once more go on from what they have",
                designs - ended
            ))),
        }
    }
}

/// A line of a table for people.
fn line(one: &Gathered) -> String {
    let said = match (&one.refused, &one.taken) {
        (Some(because), _) => painted(BAD, because),
        (None, Some(_)) => painted(GOOD, "taken"),
        (None, None) => "not handed in".to_owned(),
    };
    let what = match one.part {
        Some(Part { number, of }) => format!("part {number} of {of} of a design"),
        None => format!("{} of {} designs", one.ended, one.designs),
    };
    format!("task {}: {what}, {said}\n", one.task)
}
