//! Designs that a sweep still lacks, packed into tasks and written into a folder.

use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use placement::estimate::Workload;
use placement::sharing::{LARGE, Part, SMALLEST, is_shareable};
use tokio::runtime::Runtime;

use super::task_folder::{Task, TaskFolder, Tasks};
use crate::cli::commands::sweep::designs::{grouped, keys, workload};
use crate::cli::terminal::exit::Failure;
use service::engine::Engine;
use service::forecast::forecast_designs;
use service::queue::sweeps::designs_of;
use service::study_document::stored_plan;
use store::StoreError;
use store::merging::target::Merging;
use store::points::evaluations;
use store::queue::study_rows::StudyRow;

/// Task with the points that its designs would ask for and that are known here.
pub(crate) struct Given {
    task: Task,
    known: Vec<String>,
}

/// Work that a sweep lacks, as tasks of so many minutes: designs without a result, those that share points together, and parts of those that lack many points. What such a part starts
/// from is solved first.
///
/// # Errors
/// When the database can't be read or written, or the user stops it.
pub(crate) fn lacking(
    runtime: &Runtime,
    engine: &Engine,
    sweep: &str,
    minutes: f64,
    stop: &AtomicBool,
) -> Result<Vec<Given>, Failure> {
    let designs = runtime.block_on(designs_of(&engine.store, sweep));
    let mut designs = designs.map_err(Failure::other)?;
    designs.retain(|design| !design.study.ended());
    let solver = engine.solver.as_ref();
    let works: Vec<Option<Workload>> = designs
        .iter()
        .map(|design| workload(design, solver))
        .collect();
    let forecast = forecast_designs(&engine.store, &engine.solver, engine.threads, &works);
    let (expected, known) = runtime.block_on(forecast).map_err(Failure::other)?;
    let most_s = 60.0 * minutes;
    let (mut whole, mut parts) = (Vec::new(), Vec::new());
    for design in 0..designs.len() {
        let lacks = |work: &Workload| work.keys().filter(|key| !known.contains(*key)).count();
        let lacking = works[design].as_ref().map(lacks);
        let has = works[design].iter().flat_map(Workload::keys).count() - lacking.unwrap_or(0);
        match lacking {
            // A little is left, or nothing but to analyse it: sending its points away again would take longer.
            Some(lacking) if lacking == 0 || (lacking < LARGE && has >= LARGE) => {}
            Some(lacking) if lacking >= LARGE => {
                let study = &designs[design].study;
                let most = (expected[design].unwrap_or(f64::INFINITY) / most_s).ceil();
                let of = (lacking / SMALLEST).min(most as usize);
                match of > 1 && is_large(study)? {
                    true => parts.extend(parts_of(
                        runtime,
                        engine,
                        study,
                        expected[design],
                        of,
                        stop,
                    )?),
                    false => whole.push(design),
                }
            }
            _ => whole.push(design),
        }
    }
    // What nobody can estimate is a task of its own.
    let time_s = |design: usize| expected[whole[design]].unwrap_or(most_s);
    let groups = grouped(whole.iter().map(|&design| keys(&works[design])));
    let given = |task: Vec<usize>| {
        let task: Vec<usize> = task.into_iter().map(|design| whole[design]).collect();
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
                part: None,
                expected_s: times.map(|times| times.iter().sum()),
            },
        }
    };
    let tasks = packed(groups, time_s, most_s).into_iter().map(given);
    Ok(tasks.chain(parts).collect())
}

/// Whether a study's points can be shared out.
fn is_large(study: &StudyRow) -> Result<bool, Failure> {
    let planned = stored_plan(study).map_err(Failure::Other)?;
    Ok(is_shareable(&planned.study))
}

/// Parts of a study's points, so many, each with the cut points, which are solved here where they lack.
fn parts_of(
    runtime: &Runtime,
    engine: &Engine,
    study: &StudyRow,
    expected_s: Option<f64>,
    of: usize,
    stop: &AtomicBool,
) -> Result<Vec<Given>, Failure> {
    let solved = engine.solve_part(study, None, runtime.handle(), stop, &|_| {});
    if !solved.map_err(Failure::Other)? {
        return Err(Failure::Other("stopped".to_owned()));
    }
    let planned = stored_plan(study).map_err(Failure::Other)?;
    let given = |number: usize| {
        let part = Part { number, of };
        let points = part.points(&planned, engine.solver.as_ref());
        let keys = points.iter().flat_map(|point| [&point.key, &point.cut]);
        let keys: HashSet<&str> = keys.map(String::as_str).collect();
        let asked: Vec<&str> = keys.into_iter().collect();
        let known = runtime.block_on(async {
            let mut connection = engine.store.read().await?;
            evaluations::known(&mut connection, &asked).await
        });
        Ok(Given {
            known: known.map_err(Failure::other)?.into_iter().collect(),
            task: Task {
                studies: vec![study.id.clone()],
                part: Some(part),
                expected_s: expected_s.map(|expected_s| expected_s / of as f64),
            },
        })
    };
    (1..=of).map(given).collect()
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
