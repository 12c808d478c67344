//! Handing in what came of a task: all of it, or its results alone.

use std::path::Path;
use std::sync::Arc;

use fem_client::solver::Solver;
use placement::sharing::FirstPoint;

use crate::task_error::TaskError;
use crate::task_folder::{Kept, Task};
use service::study_document::stored_plan;
use sqlx::Connection;
use store::StoreError;
use store::file::{copies, opening};
use store::merging::parts::Taken;
use store::merging::target::Merging;
use store::queue::study_rows::{self, State};

/// Writes what came of a task, in its `own` database, to the file that is handed in, at once. Where results alone are kept, a task all of whose designs have ended hands in these and the first point
/// of one design, by which it is judged; any other hands in all, so that it goes on from there.
///
/// # Errors
/// When a database can't be read or written.
pub async fn hand_in(
    own: &Path,
    target: &Path,
    (task, kept): (&Task, Kept),
    solver: &Arc<dyn Solver>,
) -> Result<(), TaskError> {
    let lean = own.with_extension("results.db");
    let source = match kept == Kept::Results && task.part.is_none() {
        true => match judged_by(own, task, solver).await? {
            Some(key) => {
                write_results(own, &lean, (&task.studies, key)).await?;
                lean.as_path()
            }
            None => own,
        },
        false => own,
    };
    Ok(copies::hand_in(source, target).await?)
}

/// Key of the first point of a design that is done; none where one hasn't ended.
async fn judged_by(
    own: &Path,
    task: &Task,
    solver: &Arc<dyn Solver>,
) -> Result<Option<String>, StoreError> {
    let mut connection = opening::to_read(own).await?;
    let mut done = None;
    for id in &task.studies {
        let study = study_rows::find(&mut connection, id).await?;
        let Some(study) = study.filter(|study| study.ended()) else {
            connection.close().await?;
            return Ok(None);
        };
        if done.is_none() && study.state() == State::Done {
            done = Some(study);
        }
    }
    connection.close().await?;
    let planned = done.and_then(|study| stored_plan(&study).ok());
    let first = planned.and_then(|planned| FirstPoint::of(&planned, solver.as_ref()));
    Ok(first.map(|first| first.key))
}

/// Writes a database of these studies with their results, and of the point of this key.
async fn write_results(
    own: &Path,
    lean: &Path,
    (studies, key): (&[String], String),
) -> Result<(), StoreError> {
    let mut all = Merging::open(own).await?;
    all.give(lean, studies, &[key]).await?;
    all.close().await?;
    let mut results = Merging::open(lean).await?;
    let whole = results.reader().read(own, &|_, _| {}).await?;
    results.take(&whole, Taken::Answers).await?;
    results.close().await
}
