//! Designs that a sweep still lacks, packed into tasks and written into a folder.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use placement::estimate::Workload;
use tokio::runtime::Runtime;

use super::task_folder::{Task, TaskFolder, Tasks};
use crate::cli::commands::sweep::designs::{grouped, keys, workload};
use crate::cli::terminal::exit::Failure;
use service::engine::Engine;
use service::forecast::forecast_designs;
use service::queue::sweeps::designs_of;
use store::StoreError;
use store::merging::target::Merging;

/// Task with the points that its designs would ask for and that are known here.
pub(crate) struct Given {
    task: Task,
    known: Vec<String>,
}

/// Designs without a result, those that share points together, packed into tasks of so many minutes.
///
/// # Errors
/// When the database can't be read.
pub(crate) async fn lacking(
    engine: &Engine,
    sweep: &str,
    minutes: f64,
) -> Result<Vec<Given>, StoreError> {
    let mut designs = designs_of(&engine.store, sweep).await?;
    designs.retain(|design| !design.study.ended());
    let solver = engine.solver.as_ref();
    let works: Vec<Option<Workload>> = designs
        .iter()
        .map(|design| workload(design, solver))
        .collect();
    let (expected, known) =
        forecast_designs(&engine.store, &engine.solver, engine.threads, &works).await?;
    let most_s = 60.0 * minutes;
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

/// Writes tasks of a database into a new folder, with the program; nobody else may have the database meanwhile.
///
/// # Errors
/// When the folder is there already, or one of both can't be written or read.
pub(crate) fn write(
    runtime: &Runtime,
    database: &Path,
    dir: &Path,
    tasks: (String, String, Vec<Given>),
) -> Result<(TaskFolder, Tasks, PathBuf), Failure> {
    let (version, sweep, given) = tasks;
    let folder = TaskFolder::new(dir)?;
    runtime
        .block_on(write_databases(database, &folder, &given))
        .map_err(Failure::other)?;
    let program = folder.with_program()?;
    let tasks = Tasks {
        version,
        sweep,
        tasks: given.into_iter().map(|given| given.task).collect(),
    };
    folder.write(&tasks)?;
    Ok((folder, tasks, program))
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
async fn write_databases(
    database: &Path,
    folder: &TaskFolder,
    given: &[Given],
) -> Result<(), StoreError> {
    let mut head = Merging::open(database).await?;
    for (index, given) in given.iter().enumerate() {
        let file = folder.asked(index + 1);
        head.give(&file, &given.task.studies, &given.known).await?;
    }
    head.close().await
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
