//! Taking in what tasks handed in, each once one of its points gave the same bits here.

use std::sync::Arc;

use fem_client::solver::Solver;
use placement::sharing::{Part, PartPoint};
use serde::Serialize;

use crate::checking::{doubt, part_points};
use crate::task_error::TaskError;
use crate::task_folder::{Kept, Task, TaskFolder, Tasks};
use store::StoreError;
use store::merging::parts::{Merged, Taken};
use store::merging::target::Merging;
use store::merging::whole_file::{WholeFile, read_ahead};
use store::points::evaluations;
use store::queue::study_rows;

/// Task, and what became of it.
#[derive(Debug, Serialize)]
pub struct Gathered {
    /// Number of the task.
    pub task: usize,
    /// Part of the points of its design, where it has no more.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<Part>,
    /// Designs that have ended, of those that it has.
    pub ended: usize,
    /// Designs that it has.
    pub designs: usize,
    /// Rows that were taken in.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub taken: Option<Merged>,
    /// Reason why nothing was, a sentence.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<String>,
}

/// Part of a task's file that is taken: of a part of a study there are points alone.
fn part_of(task: &Task, kept: Kept) -> Taken {
    match (kept, task.part) {
        (Kept::Results, None) => Taken::Answers,
        (Kept::Everything, _) | (_, Some(_)) => Taken::Solved,
    }
}

/// Hears how many rows of a file were read, and of how many.
pub type Seen<'s> = &'s dyn Fn(usize, usize);

/// Takes in what these tasks handed in, and says of each what became of it.
///
/// # Errors
/// When the database can't be read or written; what can't be read of a task refuses that task alone.
pub async fn gather(
    mut head: Merging,
    (folder, tasks): (&TaskFolder, &Tasks),
    numbers: &[usize],
    (solver, kept): (&Arc<dyn Solver>, Kept),
    seen: Seen<'_>,
) -> Result<Vec<Gathered>, TaskError> {
    let reader = head.reader();
    let read = async |number: &usize| {
        let file = folder.done(*number);
        match file.exists() {
            true => Some(reader.read(&file, seen).await),
            false => None,
        }
    };
    let gathered = read_ahead(numbers, read, async |&number, file| {
        let task = &tasks.tasks[number - 1];
        one(&mut head, (folder, number), task, file, (solver, kept)).await
    });
    let gathered = gathered.await?;
    head.close().await?;
    Ok(gathered)
}

/// Takes in what a task handed in, or says why not.
async fn one(
    head: &mut Merging,
    (folder, number): (&TaskFolder, usize),
    task: &Task,
    file: Option<Result<WholeFile, StoreError>>,
    (solver, kept): (&Arc<dyn Solver>, Kept),
) -> Result<Gathered, TaskError> {
    let points = part_points(head.connection(), task, solver).await?;
    let (mut taken, mut refused) = (None, None);
    if let Some(file) = file {
        match merged(head, file, (task, points.as_deref()), (solver, kept)).await? {
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
        ended: ended(head, task, points.as_deref()).await?,
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
    file: Result<WholeFile, StoreError>,
    asked: (&Task, Option<&[PartPoint]>),
    (solver, kept): (&Arc<dyn Solver>, Kept),
) -> Result<Result<Merged, String>, StoreError> {
    let whole = match file {
        Ok(whole) => whole,
        Err(
            error @ (StoreError::Open { .. } | StoreError::Merge { .. } | StoreError::InUse { .. }),
        ) => return Ok(Err(error.to_string())),
        Err(error) => return Err(error),
    };
    let taken = part_of(asked.0, kept);
    if let Some(because) = doubt(head, (&whole, taken), asked, solver).await? {
        return Ok(Err(because));
    }
    match head.take(&whole, taken).await {
        Ok(merged) => Ok(Ok(merged)),
        Err(error @ StoreError::Merge { .. }) => Ok(Err(error.to_string())),
        Err(error) => Err(error),
    }
}
