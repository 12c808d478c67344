//! Slurm: tasks as arrays of jobs, by its own commands and in plain formats.
//!
//! Jobs are known by their names. So a submission that nobody confirmed is found again, and one that was made twice is ended but for the first.

use std::collections::{BTreeMap, BTreeSet};
use std::time::Duration;

use super::submission::{JobArray, Submission};
use super::{Engine, Standing, Work, quiet, said};
use crate::task_error::TaskError;

/// Tasks of an array where Slurm doesn't say how many it takes.
const USUAL_MOST: usize = 1000;
/// Interval at which Slurm is asked again when it doesn't answer, and how often, before anything is submitted.
const AGAIN: (Duration, usize) = (Duration::from_secs(3), 20);

/// A Slurm cluster.
pub(super) struct Slurm {
    options: Vec<String>,
    /// Tasks that an array may have; fewer after Slurm refused so many.
    most: Option<usize>,
}

/// Job of an array, as `squeue` lists it.
#[derive(Debug, PartialEq, Eq)]
struct Job {
    name: String,
    array: u64,
    /// Place in the array.
    index: String,
    is_waiting: bool,
    reason: String,
}

impl Slurm {
    /// A cluster whose `sbatch` is given these options, too, separated by spaces.
    pub fn new(options: &str) -> Self {
        Self {
            options: options.split_whitespace().map(str::to_owned).collect(),
            most: None,
        }
    }

    /// Submits array after array until all tasks are taken, or Slurm has enough for now.
    fn submit(&mut self, work: &Work<'_>, submission: &mut Submission) -> Result<(), TaskError> {
        loop {
            let most = *self.most.get_or_insert_with(largest_array);
            let Some(array) = submission.next(work, most) else {
                return Ok(());
            };
            submission.arrays.push(array.clone());
            submission.keep(work.folder)?;
            let Err(words) = self.submit_array(work, &array) else {
                mark_known(submission, work)?;
                continue;
            };
            // Nothing of the last array was taken.
            submission.arrays.pop();
            submission.keep(work.folder)?;
            if !submission.arrays.is_empty() {
                return Ok(());
            }
            if array.count == 1 || !is_of_size(&words) {
                return Err(TaskError::Engine(words));
            }
            self.most = Some(array.count.div_ceil(2));
        }
    }

    fn submit_array(&self, work: &Work<'_>, array: &JobArray) -> Result<(), String> {
        let before = array.first - 1;
        let mut sbatch = quiet("sbatch");
        sbatch
            .args(["--parsable", "--requeue", "--export=NONE", "--open-mode=append"])
            .arg(format!("--job-name={}", array.name))
            .arg(format!("--array=1-{}", array.count))
            .arg(format!("--output={}", said_by(array, "%a")))
            .arg("--chdir")
            .arg(work.folder.path())
            .args(&self.options)
            .arg(format!(
                "--wrap=exec ./strainsite tasks run . $((SLURM_ARRAY_TASK_ID + {before})) --threads $SLURM_CPUS_ON_NODE"
            ));
        said(&mut sbatch).map(drop)
    }

    /// Finds out whether Slurm has the last array, which nobody confirmed: it is in the queue, or a task of it wrote something.
    fn confirm(&self, work: &Work<'_>, submission: &mut Submission) -> Result<(), TaskError> {
        let Some(last) = submission.arrays.last().filter(|array| !array.is_known) else {
            return Ok(());
        };
        let is_there = !jobs_in_time(submission)?
            .iter()
            .all(|job| job.name != last.name);
        let has_begun = (1..=last.count).any(|index| {
            work.folder
                .path()
                .join(said_by(last, &index.to_string()))
                .exists()
        });
        if is_there || has_begun {
            return mark_known(submission, work);
        }
        submission.arrays.pop();
        submission.keep(work.folder)
    }
}

/// Whether Slurm refuses as many jobs, and might take fewer: its errors name a limit, or the array.
fn is_of_size(words: &str) -> bool {
    let words = words.to_lowercase();
    words.contains("limit") || words.contains("array")
}

/// File that a job writes to, in the folder of the tasks.
fn said_by(array: &JobArray, index: &str) -> String {
    format!("said/{}.{index}.txt", array.first)
}

fn mark_known(submission: &mut Submission, work: &Work<'_>) -> Result<(), TaskError> {
    if let Some(last) = submission.arrays.last_mut() {
        last.is_known = true;
    }
    submission.keep(work.folder)
}

/// Tasks that one array may have.
fn largest_array() -> usize {
    let config = said(quiet("scontrol").args(["show", "config"])).unwrap_or_default();
    let line = config
        .lines()
        .find_map(|line| line.strip_prefix("MaxArraySize"));
    let size: Option<usize> =
        line.and_then(|line| line.trim_start_matches([' ', '=']).trim().parse().ok());
    // It is one more than the largest index.
    size.map_or(USUAL_MOST, |size| size.saturating_sub(1).max(1))
}

/// Jobs of a submission that wait or run.
fn jobs(submission: &Submission) -> Result<Vec<Job>, String> {
    if submission.arrays.is_empty() {
        return Ok(Vec::new());
    }
    let mut squeue = quiet("squeue");
    squeue
        .args(["--noheader", "--array", "--format=%j|%F|%K|%T|%r"])
        .arg(format!("--name={}", submission.names()));
    Ok(said(&mut squeue)?.lines().filter_map(Job::read).collect())
}

/// Jobs of a submission; Slurm is given a minute to answer.
fn jobs_in_time(submission: &Submission) -> Result<Vec<Job>, TaskError> {
    let (pause, times) = AGAIN;
    for _ in 1..times {
        match jobs(submission) {
            Ok(jobs) => return Ok(jobs),
            Err(_) => std::thread::sleep(pause),
        }
    }
    jobs(submission).map_err(TaskError::Engine)
}

impl Job {
    fn read(line: &str) -> Option<Self> {
        let mut parts = line.splitn(5, '|');
        let (name, array) = (parts.next()?, parts.next()?);
        let (index, state) = (parts.next()?, parts.next()?);
        Some(Self {
            name: name.to_owned(),
            array: array.trim().parse().ok()?,
            index: index.trim().to_owned(),
            is_waiting: [
                "PENDING",
                "CONFIGURING",
                "REQUEUED",
                "REQUEUE_HOLD",
                "REQUEUE_FED",
            ]
            .contains(&state.trim()),
            reason: parts.next().unwrap_or_default().trim().to_owned(),
        })
    }
}

/// Reason of a job that Slurm couldn't start, and won't try again until somebody says so: what a controller that lost its memory leaves.
const NOT_LAUNCHED: &str = "launch failed";

/// Arrays that were submitted once more under a name: all but the first.
fn doubled(jobs: &[Job]) -> BTreeSet<u64> {
    let mut by_name: BTreeMap<&str, BTreeSet<u64>> = BTreeMap::new();
    for job in jobs {
        by_name.entry(&job.name).or_default().insert(job.array);
    }
    let further = by_name
        .into_values()
        .flat_map(|arrays| arrays.into_iter().skip(1));
    further.collect()
}

fn end(jobs: BTreeSet<String>) -> Result<(), String> {
    match jobs.is_empty() {
        true => Ok(()),
        false => said(quiet("scancel").args(jobs)).map(drop),
    }
}

impl Engine for Slurm {
    fn asked(&self) -> Result<(), String> {
        let mut sbatch = quiet("sbatch");
        sbatch
            .args(["--test-only", "--export=NONE", "--wrap=true"])
            .args(&self.options);
        said(&mut sbatch).map(drop)
    }

    fn begin(&mut self, work: &Work<'_>) -> Result<(), TaskError> {
        let mut submission = Submission::of(work.folder)?;
        work.folder.part("said")?;
        self.confirm(work, &mut submission)?;
        self.submit(work, &mut submission)
    }

    fn standing(&mut self, work: &Work<'_>) -> Result<Standing, String> {
        let text = |failure: TaskError| failure.to_string();
        let mut submission = Submission::of(work.folder).map_err(text)?;
        let jobs = jobs(&submission)?;
        let twice = doubled(&jobs);
        end(twice.iter().map(u64::to_string).collect())?;
        // The next round has what these would have done.
        let is_lost = |job: &Job| job.is_waiting && job.reason.contains(NOT_LAUNCHED);
        let lost = jobs.iter().filter(|job| is_lost(job));
        end(lost
            .map(|job| format!("{}_{}", job.array, job.index))
            .collect())?;
        let mut standing = Standing::default();
        let stand = |job: &&Job| !twice.contains(&job.array) && !is_lost(job);
        for job in jobs.iter().filter(stand) {
            match job.is_waiting {
                true => standing.waiting += 1,
                false => standing.running += 1,
            }
            if job.is_waiting && standing.because.is_none() {
                standing.because = Some(job.reason.clone());
            }
        }
        // What Slurm had no room for before.
        let most = self.most.unwrap_or(USUAL_MOST);
        if let Some(next) = submission.next(work, most) {
            self.submit(work, &mut submission).map_err(text)?;
            standing.waiting += work.count + 1 - next.first;
        }
        Ok(standing)
    }

    fn cancel(&mut self, work: &Work<'_>) -> Result<(), String> {
        let ended = Submission::of(work.folder)
            .map_err(|failure| failure.to_string())
            .and_then(|submission| {
                let arrays = jobs(&submission)?.into_iter().map(|job| job.array);
                end(arrays.map(|array| array.to_string()).collect())
            });
        ended.map_err(|words| format!("jobs named {}.* may still run: {words}", work.name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_submitted_twice_is_told_by_its_name() {
        let lines = "a.1|17|1|RUNNING|None\na.1|17|2|PENDING|Resources\na.1|21|1|PENDING|Priority\na.5|18|4|PENDING|ReqNodeNotAvail, UnavailableNodes:v1|2\n\nodd";
        let jobs: Vec<Job> = lines.lines().filter_map(Job::read).collect();
        assert_eq!(jobs.len(), 4);
        assert_eq!(jobs[3].reason, "ReqNodeNotAvail, UnavailableNodes:v1|2");
        assert_eq!(doubled(&jobs), BTreeSet::from([21]));
        let waiting: Vec<bool> = jobs.iter().map(|job| job.is_waiting).collect();
        assert_eq!(waiting, [false, true, true, true]);
    }
}
