//! Checks of what tasks hand in: a point is solved again here before any is believed.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use fem_client::scene::Scene;
use fem_client::solver::{Readout, Response, SolveRequest, Solver, StartState};
use placement::sharing::{FirstPoint, PartPoint};
use sqlx::{Connection, SqliteConnection};

use crate::task_folder::Task;
use service::study_document::stored_plan;
use store::StoreError;
use store::merging::parts::Taken;
use store::merging::target::Merging;
use store::merging::whole_file::WholeFile;
use store::points::evaluations;
use store::queue::study_rows::{self, State};

/// Reason to doubt what a file has: designs of another task, or a point has other bits where it is solved again here. That is the first point of a design, of a part any one. A point that is
/// known here is compared when the file is taken. Without such a point nothing new is believed of what is taken.
pub(crate) async fn doubt(
    head: &mut Merging,
    (whole, taken): (&WholeFile, Taken),
    (task, points): (&Task, Option<&[PartPoint]>),
    solver: &Arc<dyn Solver>,
) -> Result<Option<String>, StoreError> {
    let (studies, new_points) = head.foreseen(whole).await?;
    if let Some(other) = studies.iter().find(|id| !task.studies.contains(id)) {
        return Ok(Some(format!("it has the study {other} of another task")));
    }
    let mut theirs = whole.open().await?;
    let (own, other) = (head.connection(), &mut theirs);
    let compared = match points {
        Some(points) => compared_part(own, other, (task, points), solver).await,
        None => compared(own, other, task, solver).await,
    };
    theirs.close().await?;
    Ok(match compared? {
        Compared::Alike => None,
        Compared::Otherwise(because) => Some(because),
        Compared::Nothing { ends } => {
            let is_new = ends || (taken == Taken::Solved && new_points > 0);
            let because = "it has points or results, and no first point of a design or of its part";
            is_new.then(|| because.to_owned())
        }
    })
}

/// Outcome of a comparison of a file's points with what is solved here.
enum Compared {
    /// The point is the same here.
    Alike,
    /// The point is another one here, a sentence.
    Otherwise(String),
    /// No such point is in the file, which may have ends of designs that haven't ended here.
    Nothing { ends: bool },
}

async fn compared(
    head: &mut SqliteConnection,
    theirs: &mut SqliteConnection,
    task: &Task,
    solver: &Arc<dyn Solver>,
) -> Result<Compared, StoreError> {
    let (mut is_alike, mut ends) = (false, false);
    for id in &task.studies {
        let Some(study) = study_rows::find(head, id).await? else {
            return Ok(unknown(id));
        };
        if study.state() == State::Done {
            continue;
        }
        let there = study_rows::find(theirs, id).await?;
        ends |= there.is_some_and(|there| there.state() == State::Done);
        let planning = solver.clone();
        let first = tokio::task::spawn_blocking(move || {
            FirstPoint::of(&stored_plan(&study).ok()?, planning.as_ref())
        });
        let Some(first) = first.await.ok().flatten() else {
            continue;
        };
        let keys = [first.key.clone()];
        let found = evaluations::find(theirs, &keys).await?.pop().flatten();
        let Some(found) = found else {
            continue;
        };
        is_alike = true;
        if evaluations::find(head, &keys)
            .await?
            .pop()
            .flatten()
            .is_some()
        {
            continue;
        }
        let solving = solver.clone();
        let again = tokio::task::spawn_blocking(move || {
            solved(solving.as_ref(), &first.scene, &first.readout, None)
        });
        let is_alike = again.await.is_ok_and(|own| own == found.outcome.ok());
        return Ok(judged(is_alike, "the first point", id));
    }
    Ok(match is_alike {
        true => Compared::Alike,
        false => Compared::Nothing { ends },
    })
}

/// Compares a point of a part that isn't known here, whichever chance chooses.
async fn compared_part(
    head: &mut SqliteConnection,
    theirs: &mut SqliteConnection,
    (task, points): (&Task, &[PartPoint]),
    solver: &Arc<dyn Solver>,
) -> Result<Compared, StoreError> {
    let id = task.studies.first().map_or("", String::as_str);
    if study_rows::find(head, id).await?.is_none() {
        return Ok(unknown(id));
    }
    let keys: Vec<&str> = points.iter().map(|point| point.key.as_str()).collect();
    let there = evaluations::known(theirs, &keys).await?;
    let here = evaluations::known(head, &keys).await?;
    let is_new = |point: &&PartPoint| there.contains(&point.key) && !here.contains(&point.key);
    let new: Vec<&PartPoint> = points.iter().filter(is_new).collect();
    let Some(point) = new.get(any_of(new.len())).map(|point| (*point).clone()) else {
        return Ok(match there.is_empty() {
            true => Compared::Nothing { ends: false },
            false => Compared::Alike,
        });
    };
    let found = evaluations::find(theirs, std::slice::from_ref(&point.key)).await?;
    let start = evaluations::find_start(head, &point.cut).await?;
    let solving = solver.clone();
    let again = tokio::task::spawn_blocking(move || {
        solved(
            solving.as_ref(),
            &point.scene,
            &point.readout,
            start.as_ref(),
        )
    });
    let found = found.into_iter().flatten().next();
    let found = found.and_then(|found| found.outcome.ok());
    let is_alike = again.await.is_ok_and(|own| own == found);
    Ok(judged(is_alike, "a point", id))
}

/// Points of a task that has a part of a study's; of a study that isn't here, or has no plan, there are none.
pub(crate) async fn part_points(
    head: &mut SqliteConnection,
    task: &Task,
    solver: &Arc<dyn Solver>,
) -> Result<Option<Vec<PartPoint>>, StoreError> {
    let (Some(part), Some(id)) = (task.part, task.studies.first()) else {
        return Ok(None);
    };
    let (study, planning) = (study_rows::find(head, id).await?, solver.clone());
    let planned = tokio::task::spawn_blocking(move || {
        let planned = stored_plan(&study?).ok()?;
        Some(part.points(&planned, planning.as_ref()))
    });
    Ok(Some(planned.await.ok().flatten().unwrap_or_default()))
}

/// Place among so many that nobody foresees; the first where there are no random numbers.
fn any_of(count: usize) -> usize {
    let number = getrandom::u64().unwrap_or(0);
    usize::try_from(number).unwrap_or(0) % count.max(1)
}

fn unknown(study: &str) -> Compared {
    Compared::Otherwise(format!(
        "its study {study} isn't known here: gather into the database that the tasks were made from"
    ))
}

fn judged(is_alike: bool, point: &str, study: &str) -> Compared {
    match is_alike {
        true => Compared::Alike,
        false => Compared::Otherwise(format!(
            "{point} of its study {study} has other bits than where it is solved here: none of its points is taken"
        )),
    }
}

/// Response of a point, solved here; `None` where there is none.
fn solved(
    solver: &dyn Solver,
    scene: &Scene,
    readout: &Readout,
    start: Option<&StartState>,
) -> Option<Response> {
    let request = SolveRequest {
        scene,
        readout,
        start,
        watch: &AtomicBool::new(false),
    };
    solver.solve(&request).ok().map(|solved| solved.response)
}
