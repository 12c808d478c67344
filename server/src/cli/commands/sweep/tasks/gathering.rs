//! `strainsite tasks gather`: takes in what tasks handed in, each once one of its points gave the same bits here.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use fem_client::solver::Solver;
use placement::sharing::{Part, PartPoint};
use serde::Serialize;
use tokio::runtime::Runtime;

use super::checking::{doubt, part_points};
use super::task_folder::{Task, TaskFolder, Tasks};
use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell};
use crate::cli::terminal::paint::{BAD, GOOD, painted};
use crate::cli::terminal::progress::{count, counting_bar};
use crate::cli::terminal::report::next_steps::shell_word;
use store::StoreError;
use store::merging::parts::{Merged, Taken};
use store::merging::target::Merging;
use store::points::evaluations;
use store::queue::study_rows;

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
    #[command(flatten)]
    solver: SolverOption,
    /// Write what became of each task as JSON to a file, or to standard output with -
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<JsonTarget>,
}

/// Task, and what became of it.
#[derive(Debug, Serialize)]
pub(crate) struct Gathered {
    /// Number of the task.
    pub task: usize,
    /// Part of the points of its design, where it has no more.
    #[serde(skip_serializing_if = "Option::is_none")]
    part: Option<Part>,
    /// Designs that have ended, of those that it has.
    pub ended: usize,
    /// Designs that it has.
    pub designs: usize,
    /// Rows that were taken in.
    #[serde(skip_serializing_if = "Option::is_none")]
    taken: Option<Merged>,
    /// Reason why nothing was, a sentence.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<String>,
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
        let gathered = runtime.block_on(gather(&self.db, (&folder, &tasks), &all, &solver))?;
        if let Some(target) = &self.json {
            target.write(&gathered)?;
        }
        let sum = |of: fn(&Gathered) -> usize| gathered.iter().map(of).sum::<usize>();
        let (ended, designs) = (sum(|one| one.ended), sum(|one| one.designs));
        let lines: String = gathered.iter().map(Gathered::line).collect();
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

/// Takes in what these tasks handed in, and says of each what became of it.
///
/// # Errors
/// When the database can't be read or written, or has no lock to give; what can't be read of a task refuses that task alone.
pub(crate) async fn gather(
    database: &Path,
    (folder, tasks): (&TaskFolder, &Tasks),
    numbers: &[usize],
    solver: &Arc<dyn Solver>,
) -> Result<Vec<Gathered>, Failure> {
    let opened = Merging::open(database).await;
    let mut head = opened.map_err(Failure::other)?;
    let mut gathered = Vec::new();
    for &number in numbers {
        let task = &tasks.tasks[number - 1];
        gathered.push(one(&mut head, folder, number, task, solver).await?);
    }
    head.close().await.map_err(Failure::other)?;
    Ok(gathered)
}

/// Takes in what a task handed in, or says why not.
async fn one(
    head: &mut Merging,
    folder: &TaskFolder,
    number: usize,
    task: &Task,
    solver: &Arc<dyn Solver>,
) -> Result<Gathered, Failure> {
    let points = part_points(head.connection(), task, solver).await;
    let points = points.map_err(Failure::other)?;
    let file = folder.done(number);
    let (mut taken, mut refused) = (None, None);
    if file.exists() {
        match merged(head, &file, (task, points.as_deref()), solver)
            .await
            .map_err(Failure::other)?
        {
            Ok(merged) => taken = Some(merged),
            Err(because) => {
                let aside = folder.set_aside(number)?;
                refused = Some(format!("{because}; kept as {}", aside.display()));
            }
        }
    } else if let Some(refusal) = folder.refusal(number) {
        refused = Some(refusal.because);
    }
    Ok(Gathered {
        task: number,
        part: task.part,
        ended: ended(head, task, points.as_deref())
            .await
            .map_err(Failure::other)?,
        designs: task.studies.len(),
        taken,
        refused,
    })
}

/// Counts the designs of a task that have ended; of a part it is one when all its points are here.
async fn ended(
    head: &mut Merging,
    task: &Task,
    points: Option<&[PartPoint]>,
) -> Result<usize, StoreError> {
    let mut ended = 0;
    for id in &task.studies {
        let study = study_rows::find(head.connection(), id).await?;
        let is_ended = study.is_some_and(|study| study.ended());
        let is_here = match points.filter(|_| !is_ended) {
            Some(points) => are_here(head, points).await?,
            None => is_ended,
        };
        ended += usize::from(is_here);
    }
    Ok(ended)
}

/// Whether there are points, and all are known here.
async fn are_here(head: &mut Merging, points: &[PartPoint]) -> Result<bool, StoreError> {
    let keys: Vec<&str> = points.iter().map(|point| point.key.as_str()).collect();
    let known = evaluations::known(head.connection(), &keys).await?;
    Ok(!keys.is_empty() && known.len() == keys.len())
}

/// Rows that were taken of a file, or the reason why it is refused.
async fn merged(
    head: &mut Merging,
    file: &Path,
    asked: (&Task, Option<&[PartPoint]>),
    solver: &Arc<dyn Solver>,
) -> Result<Result<Merged, String>, StoreError> {
    let bar = counting_bar(0, "rows");
    let seen = |done, of| count(&bar, done, of);
    let whole = head.read(file, &seen).await;
    bar.finish_and_clear();
    let whole = match whole {
        Ok(whole) => whole,
        Err(
            error @ (StoreError::Open { .. } | StoreError::Merge { .. } | StoreError::InUse { .. }),
        ) => return Ok(Err(error.to_string())),
        Err(error) => return Err(error),
    };
    if let Some(because) = doubt(head, &whole, asked, solver).await? {
        return Ok(Err(because));
    }
    match head.take(&whole, Taken::Solved).await {
        Ok(merged) => Ok(Ok(merged)),
        Err(error @ StoreError::Merge { .. }) => Ok(Err(error.to_string())),
        Err(error) => Err(error),
    }
}

impl Gathered {
    /// A line of a table for people.
    fn line(&self) -> String {
        let said = match (&self.refused, &self.taken) {
            (Some(because), _) => painted(BAD, because),
            (None, Some(_)) => painted(GOOD, "taken"),
            (None, None) => "not handed in".to_owned(),
        };
        let what = match self.part {
            Some(Part { number, of }) => format!("part {number} of {of} of a design"),
            None => format!("{} of {} designs", self.ended, self.designs),
        };
        format!("task {}: {what}, {said}\n", self.task)
    }
}
