//! `strainsite tasks gather`: takes in what tasks handed in, each once one of its points gave the same bits here.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use clap::Args;
use fem_client::solver::{Response, SolveRequest, Solver};
use placement::estimate::FirstPoint;
use serde::Serialize;
use sqlx::{Connection, SqliteConnection};
use tokio::runtime::Runtime;

use super::task_folder::{Task, TaskFolder, Tasks};
use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, tell};
use crate::cli::terminal::paint::{BAD, GOOD, painted};
use crate::cli::terminal::progress::{count, counting_bar};
use crate::cli::terminal::report::next_steps::shell_word;
use service::study_document::stored_plan;
use store::StoreError;
use store::merging::parts::{Merged, Taken};
use store::merging::target::{Merging, WholeFile};
use store::points::evaluations;
use store::queue::study_rows::{self, State};

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
    let file = folder.done(number);
    let (mut taken, mut refused) = (None, None);
    if file.exists() {
        match merged(head, &file, task, solver)
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
    let mut ended = 0;
    for id in &task.studies {
        let study = study_rows::find(head.connection(), id).await;
        let study = study.map_err(Failure::other)?;
        ended += usize::from(study.is_some_and(|study| study.ended()));
    }
    Ok(Gathered {
        task: number,
        ended,
        designs: task.studies.len(),
        taken,
        refused,
    })
}

/// Rows that were taken of a file, or the reason why it is refused.
async fn merged(
    head: &mut Merging,
    file: &Path,
    task: &Task,
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
    if let Some(because) = doubt(head, &whole, task, solver).await? {
        return Ok(Err(because));
    }
    match head.take(&whole, Taken::Everything).await {
        Ok(merged) => Ok(Ok(merged)),
        Err(error @ StoreError::Merge { .. }) => Ok(Err(error.to_string())),
        Err(error) => Err(error),
    }
}

/// Reason to doubt what a file has: designs of another task, or the first point of a design has other bits where it is solved again here. A first point that is known here is compared when
/// the file is taken.
async fn doubt(
    head: &mut Merging,
    whole: &WholeFile,
    task: &Task,
    solver: &Arc<dyn Solver>,
) -> Result<Option<String>, StoreError> {
    let (studies, new_points) = head.foreseen(whole).await?;
    if let Some(other) = studies.iter().find(|id| !task.studies.contains(id)) {
        return Ok(Some(format!("it has the study {other} of another task")));
    }
    let mut theirs = whole.open().await?;
    let compared = compared(head.connection(), &mut theirs, task, solver).await;
    theirs.close().await?;
    Ok(match compared? {
        Compared::Alike => None,
        Compared::Otherwise(because) => Some(because),
        Compared::Nothing if new_points == 0 => None,
        Compared::Nothing => {
            Some("it has points, and none of them is the first of a design".to_owned())
        }
    })
}

/// Outcome of a comparison of a file's points with what is solved here.
enum Compared {
    /// First point of a design is the same here.
    Alike,
    /// First point of a design is another one here, a sentence.
    Otherwise(String),
    /// No first point of a design is in the file.
    Nothing,
}

async fn compared(
    head: &mut SqliteConnection,
    theirs: &mut SqliteConnection,
    task: &Task,
    solver: &Arc<dyn Solver>,
) -> Result<Compared, StoreError> {
    let mut found_any = Compared::Nothing;
    for id in &task.studies {
        let Some(study) = study_rows::find(head, id).await? else {
            return Ok(Compared::Otherwise(format!(
                "its study {id} isn't known here: gather into the database that the tasks were made from"
            )));
        };
        if study.state() == State::Done {
            continue;
        }
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
        found_any = Compared::Alike;
        if evaluations::find(head, &keys)
            .await?
            .pop()
            .flatten()
            .is_some()
        {
            continue;
        }
        let solving = solver.clone();
        let again = tokio::task::spawn_blocking(move || solved(solving.as_ref(), &first));
        let is_alike = again.await.is_ok_and(|own| own == found.outcome.ok());
        return Ok(match is_alike {
            true => Compared::Alike,
            false => Compared::Otherwise(format!(
                "the first point of its study {id} has other bits than where it is solved here: none of its points is taken"
            )),
        });
    }
    Ok(found_any)
}

/// Response of a point, solved here; `None` where there is none.
fn solved(solver: &dyn Solver, point: &FirstPoint) -> Option<Response> {
    let request = SolveRequest {
        scene: &point.scene,
        readout: &point.readout,
        start: None,
        watch: &AtomicBool::new(false),
    };
    solver.solve(&request).ok().map(|solved| solved.response)
}

impl Gathered {
    /// A line of a table for people.
    fn line(&self) -> String {
        let said = match (&self.refused, &self.taken) {
            (Some(because), _) => painted(BAD, because),
            (None, Some(_)) => painted(GOOD, "taken"),
            (None, None) => "not handed in".to_owned(),
        };
        format!(
            "task {}: {} of {} designs, {said}\n",
            self.task, self.ended, self.designs
        )
    }
}
