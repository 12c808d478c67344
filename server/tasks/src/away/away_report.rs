//! Reports of what becomes of a sweep's tasks.

use std::collections::BTreeMap;
use std::sync::{Mutex, MutexGuard, PoisonError};

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use crate::engines::engine_name::EngineName;
use crate::rounds::head::Told;
use crate::task_folder::Refusal;

/// Sentences that a report keeps: the latest.
const MOST_SAID: usize = 20;

/// Engines that a service has.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct EngineList {
    /// Each engine that clients may name.
    pub engines: Vec<EngineView>,
}

/// Engine, with the sweeps that it has or had.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct EngineView {
    /// Name of the engine, as `?engine=` has it.
    pub name: EngineName,
    /// Tasks of all its sweeps.
    pub tasks: TaskCounts,
    /// Sweeps whose tasks go on, and others, newest first.
    pub sweeps: Vec<AwaySweep>,
}

/// Tasks by where they stand.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct TaskCounts {
    /// Tasks that wait for a machine.
    pub waiting: usize,
    /// Tasks that a machine does; of a command of the user's all that it hasn't handed in.
    pub running: usize,
    /// Tasks that have ended.
    pub ended: usize,
}

/// Sweep whose designs other machines solve, or did.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct AwaySweep {
    /// Identifier of the sweep.
    pub sweep: String,
    /// Report of its tasks.
    #[serde(flatten)]
    pub report: TaskReport,
    /// Time at which nothing of it went on any more; null while something does. What was left then has its turns at home.
    pub ended: Option<String>,
}

/// Report of what becomes of a sweep's tasks.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct TaskReport {
    /// Tasks of the round.
    pub tasks: TaskCounts,
    /// Reason why the first of those that wait does, in the engine's words.
    pub because: Option<String>,
    /// Designs of the round.
    pub designs: usize,
    /// Designs of the round whose task was taken in and that have ended.
    pub designs_ended: usize,
    /// Nodes that handed in nothing, and why.
    pub refused: Vec<Refusal>,
    /// Further words about it, the latest last.
    pub said: Vec<String>,
}

impl TaskReport {
    /// Notes what happens.
    pub(super) fn note(&mut self, told: Told<'_>) {
        match told {
            Told::Begun { designs, tasks } => {
                self.tasks = TaskCounts {
                    waiting: tasks,
                    ..TaskCounts::default()
                };
                (self.designs, self.designs_ended, self.because) = (designs, 0, None);
            }
            Told::Standing { standing, ended } => {
                let count = self.count();
                let (waiting, running) = (standing.waiting, standing.running);
                self.tasks = TaskCounts {
                    waiting,
                    running,
                    ended: count.saturating_sub(waiting + running),
                };
                self.because.clone_from(&standing.because);
                self.designs_ended = ended;
            }
            Told::Refused(refusal) => {
                if !self.refused.contains(refusal) {
                    self.refused.push(refusal.clone());
                }
            }
            Told::Warned(words) => self.say(words),
            Told::Over => {
                self.tasks = TaskCounts {
                    ended: self.count(),
                    ..TaskCounts::default()
                };
                self.because = None;
            }
        }
    }

    /// Keeps a sentence.
    pub(super) fn say(&mut self, words: &str) {
        if self.said.last().is_none_or(|last| last != words) {
            self.said.push(words.to_owned());
        }
        let over = self.said.len().saturating_sub(MOST_SAID);
        self.said.drain(..over);
    }

    fn count(&self) -> usize {
        self.tasks.waiting + self.tasks.running + self.tasks.ended
    }
}

/// Reports of the sweeps that are away, by their identifiers.
#[derive(Debug, Default)]
pub(super) struct Reports(Mutex<BTreeMap<String, TaskReport>>);

impl Reports {
    /// Reports of all of them.
    pub fn all(&self) -> MutexGuard<'_, BTreeMap<String, TaskReport>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The report of a sweep; an empty one where it has none.
    pub fn of(&self, sweep: &str) -> TaskReport {
        self.all().get(sweep).cloned().unwrap_or_default()
    }

    /// Changes the report of a sweep that is away.
    pub fn change(&self, sweep: &str, change: impl FnOnce(&mut TaskReport)) {
        if let Some(report) = self.all().get_mut(sweep) {
            change(report);
        }
    }
}

impl EngineView {
    /// Names of engine and state, and how many tasks there are.
    pub fn counts(&self) -> [(&'static str, &'static str, usize); 3] {
        let TaskCounts {
            waiting,
            running,
            ended,
        } = self.tasks;
        [("waiting", waiting), ("running", running), ("ended", ended)]
            .map(|(state, count)| (self.name.as_str(), state, count))
    }
}

impl TaskCounts {
    /// Sums them.
    pub(super) fn sum(all: impl Iterator<Item = Self>) -> Self {
        all.fold(Self::default(), |sum, one| Self {
            waiting: sum.waiting + one.waiting,
            running: sum.running + one.running,
            ended: sum.ended + one.ended,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engines::Standing;

    #[test]
    fn tasks_that_neither_wait_nor_run_have_ended() {
        let mut report = TaskReport::default();
        let counts = |report: &TaskReport| {
            let TaskCounts {
                waiting,
                running,
                ended,
            } = report.tasks;
            (waiting, running, ended)
        };
        report.note(Told::Begun {
            designs: 12,
            tasks: 5,
        });
        assert_eq!(counts(&report), (5, 0, 0));
        let standing = Standing {
            waiting: 1,
            running: 2,
            because: Some("Resources".to_owned()),
            news: None,
        };
        report.note(Told::Standing {
            standing: &standing,
            ended: 4,
        });
        assert_eq!(counts(&report), (1, 2, 2));
        assert_eq!((report.designs, report.designs_ended), (12, 4));
        assert_eq!(report.because.as_deref(), Some("Resources"));
        report.note(Told::Over);
        assert_eq!(counts(&report), (0, 0, 5));
        assert_eq!(report.because, None);
    }

    #[test]
    fn the_latest_words_are_kept_and_none_twice_in_a_row() {
        let mut report = TaskReport::default();
        for number in 0..=MOST_SAID {
            for _ in 0..3 {
                report.note(Told::Warned(&format!("word {number}")));
            }
        }
        assert_eq!(report.said.len(), MOST_SAID);
        assert_eq!(report.said[0], "word 1");
    }
}
