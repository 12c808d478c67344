//! Designs that a sweep still lacks, packed into tasks and written into a folder.

use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use placement::estimate::Workload;
use placement::sharing::{LARGE, Part, SMALLEST, is_shareable};
use tokio::runtime::Handle;

use crate::grouping::{Groups, workloads};
use crate::task_error::TaskError;
use crate::task_folder::{Kept, Task, TaskFolder, Tasks};
use service::engine::Engine;
use service::forecast::many_designs::{Foreseen, ManyDesigns, TOGETHER};
use service::queue::sweeps::designs_within;
use service::study_document::stored_plan;
use store::StoreError;
use store::merging::target::Merging;
use store::points::evaluations;
use store::queue::design_rows::DesignRow;
use store::queue::study_rows::StudyRow;

/// Task with the points that its designs would ask for and that are known here.
pub struct Given {
    task: Task,
    known: Vec<String>,
}

/// Packer of what a sweep lacks.
pub struct Packer<'p> {
    /// Runtime of the database.
    pub runtime: &'p Handle,
    /// Engine that forecasts, and solves cut points.
    pub engine: &'p Engine,
    /// Time that a task should take on this machine's threads, minutes.
    pub minutes: f64,
    /// Flag that is set when somebody wishes to stop.
    pub stop: &'p AtomicBool,
}

/// Design that goes to other machines whole.
struct Whole {
    study: String,
    /// Time that it is expected to take, s.
    expected_s: Option<f64>,
    /// Keys of its points that are known here.
    known: Vec<String>,
}

/// Way in which a design goes to other machines.
enum Share {
    /// Design that stays here.
    None,
    /// Design among the others of a task.
    Whole,
    /// Parts of its points, so many.
    Parts(usize),
}

impl Packer<'_> {
    /// Packs what a sweep lacks: designs without a result, those that share points together, and parts of those that lack many points. What such a part starts from is
    /// solved first.
    ///
    /// # Errors
    /// When the database can't be read or written, or the user stops it.
    pub fn pack(&self, sweep: &str) -> Result<Vec<Given>, TaskError> {
        let engine = self.engine;
        let solver = engine.solver.as_ref();
        let many = ManyDesigns::begin(Some(&engine.store), solver, engine.threads);
        let mut many = self.runtime.block_on(many)?;
        let (mut whole, mut groups, mut parts) = (Vec::new(), Groups::default(), Vec::new());
        for first in (0..).step_by(TOGETHER) {
            let some = designs_within(&engine.store, sweep, first..first + TOGETHER);
            let some = self.runtime.block_on(some)?;
            if some.is_empty() {
                break;
            }
            let open: Vec<&DesignRow> = some.iter().filter(|d| !d.study.ended()).collect();
            let works = workloads(&open, solver, engine.threads, self.stop);
            let works = works.ok_or(TaskError::Stopped)?;
            let foreseen = self.runtime.block_on(many.next(&works))?;
            for ((design, work), foreseen) in open.iter().zip(&works).zip(foreseen) {
                let (expected_s, known) = told(foreseen);
                let keys = || work.iter().flat_map(Workload::keys);
                match self.share(&design.study, keys().count(), (expected_s, known.len()))? {
                    Share::None => {}
                    Share::Whole => {
                        groups.add(keys());
                        whole.push(Whole {
                            study: design.study.id.clone(),
                            expected_s,
                            known,
                        });
                    }
                    Share::Parts(of) => parts.extend(self.parts(&design.study, expected_s, of)?),
                }
            }
        }
        // What nobody can estimate is a task of its own.
        let time_s = |design: usize| whole[design].expected_s.unwrap_or(self.most_s());
        let tasks = packed(groups.into_groups(), time_s, self.most_s()).into_iter();
        let tasks = tasks.map(|designs| given(designs.iter().map(|design| &whole[*design])));
        Ok(tasks.chain(parts).collect())
    }

    fn most_s(&self) -> f64 {
        60.0 * self.minutes
    }

    /// Way in which a study goes that asks for so many points, takes so long, s, and has so many of them.
    fn share(
        &self,
        study: &StudyRow,
        all: usize,
        (expected_s, has): (Option<f64>, usize),
    ) -> Result<Share, TaskError> {
        if all == 0 {
            return Ok(Share::Whole);
        }
        let lacks = all - has;
        if lacks == 0 || (lacks < LARGE && has >= LARGE) {
            // A little is left, or nothing but to analyse it: sending its points away would take longer.
            return Ok(Share::None);
        }
        let tasks = (expected_s.unwrap_or(f64::INFINITY) / self.most_s()).ceil();
        let of = (lacks / SMALLEST).min(tasks as usize);
        if lacks < LARGE || of < 2 {
            return Ok(Share::Whole);
        }
        let planned = stored_plan(study).map_err(TaskError::Failed)?;
        Ok(match is_shareable(&planned.study) {
            true => Share::Parts(of),
            false => Share::Whole,
        })
    }

    /// Parts of a design's points, so many, each with the cut points, which are solved here where they lack.
    fn parts(
        &self,
        study: &StudyRow,
        expected_s: Option<f64>,
        of: usize,
    ) -> Result<Vec<Given>, TaskError> {
        let handle = self.runtime;
        let solved = self
            .engine
            .solve_part(study, None, handle, self.stop, &|_| {});
        if !solved.map_err(TaskError::Failed)? {
            return Err(TaskError::Stopped);
        }
        let planned = stored_plan(study).map_err(TaskError::Failed)?;
        let given = |number: usize| {
            let part = Part { number, of };
            let points = part.points(&planned, self.engine.solver.as_ref());
            let keys = points.iter().flat_map(|point| [&point.key, &point.cut]);
            let keys: HashSet<&str> = keys.map(String::as_str).collect();
            let asked: Vec<&str> = keys.into_iter().collect();
            let known = self.runtime.block_on(async {
                let mut connection = self.engine.store.read().await?;
                evaluations::known(&mut connection, &asked).await
            });
            Ok(Given {
                known: known.map_err(TaskError::Store)?.into_iter().collect(),
                task: Task {
                    studies: vec![study.id.clone()],
                    part: Some(part),
                    expected_s: expected_s.map(|all_s| all_s / of as f64),
                },
            })
        };
        (1..=of).map(given).collect()
    }
}

/// Time that a design is expected to take, s, and the keys of its points that are known.
fn told(foreseen: Option<Foreseen>) -> (Option<f64>, Vec<String>) {
    let Some(Foreseen { estimate, known }) = foreseen else {
        return (None, Vec::new());
    };
    (estimate.wall_s.map(|wall_s| wall_s.expected), known)
}

/// A task of whole designs.
fn given<'w>(designs: impl Iterator<Item = &'w Whole> + Clone) -> Given {
    let known: HashSet<&String> = designs.clone().flat_map(|design| &design.known).collect();
    let times: Option<Vec<f64>> = designs.clone().map(|design| design.expected_s).collect();
    Given {
        known: known.into_iter().cloned().collect(),
        task: Task {
            studies: designs.map(|design| design.study.clone()).collect(),
            part: None,
            expected_s: times.map(|times| times.iter().sum()),
        },
    }
}

/// Writes tasks of a database into a new folder, with the program.
///
/// # Errors
/// When the folder is there already, or one of both can't be written or read.
pub fn write(
    runtime: &Handle,
    head: Merging,
    dir: &Path,
    (version, sweep, kept): (String, String, Kept),
    given: Vec<Given>,
) -> Result<(TaskFolder, Tasks, PathBuf), TaskError> {
    let folder = TaskFolder::new(dir)?;
    runtime.block_on(write_databases(head, &folder, &given))?;
    let program = folder.with_program()?;
    let tasks = Tasks {
        version,
        sweep,
        kept,
        tasks: given.into_iter().map(|given| given.task).collect(),
    };
    folder.write(&tasks)?;
    Ok((folder, tasks, program))
}

/// Groups of designs joined in their order, as long as they take no longer together than this, s.
pub fn packed(
    groups: Vec<Vec<usize>>,
    time_s: impl Fn(usize) -> f64,
    most_s: f64,
) -> Vec<Vec<usize>> {
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
    mut head: Merging,
    folder: &TaskFolder,
    given: &[Given],
) -> Result<(), StoreError> {
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
