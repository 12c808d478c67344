//! Fits in a process of their own: one that is cancelled ends at once, and one that runs out of memory ends alone.

use std::process::{Command, ExitCode};

use estimation::fit_report::Report;
use estimation::recipe::Recipe;
use serde::{Deserialize, Serialize};

use crate::forces::fitting::{Fit, FitFailure, Work, fit};
use crate::forces::model_file::model_text;
use crate::forces::recorded_texts::NamedText;
use crate::wire::estimator_wire::{FitProgress, LeftOutRows};
use crate::work::answering;
use crate::work::own_process::{Unanswered, Wish, ask};

/// The program's only argument when it is started for this. It is no command of its users.
pub const ARGUMENT: &str = "learn-apart";

/// Order to learn.
#[derive(Debug, Serialize, Deserialize)]
pub struct FitOrder {
    /// Recipe of what is to be done.
    pub recipe: Recipe,
    /// The recordings.
    pub files: Vec<NamedText>,
    /// Threads.
    pub threads: usize,
    /// Memory that the process may take, bytes; one that needs more ends.
    pub memory_bytes: u64,
}

/// Fit as texts and as far as people look at it.
#[derive(Debug, Serialize, Deserialize)]
pub struct Learnt {
    /// The model file.
    pub model: String,
    /// Report of what was found.
    pub report: Report,
    /// Predictions of rows that weren't learnt from, one list a force.
    pub left_out: Vec<LeftOutRows>,
}

/// Reason why a process learnt nothing.
#[derive(Debug, Clone, PartialEq)]
pub enum Unlearnt {
    /// Failure of the fit.
    Failed(FitFailure),
    /// Stop on request.
    Stopped,
    /// End of its process by what it learnt: how.
    Crashed(String),
}

type Answer = Result<Box<Learnt>, FitFailure>;

/// Learns in the process that the command starts; `told` hears how far it is.
///
/// # Errors
/// See [`Unlearnt`].
pub fn learn(
    command: Command,
    order: &FitOrder,
    wish: &dyn Fn() -> Wish,
    told: &(dyn Fn(FitProgress) + Sync),
) -> Result<Learnt, Unlearnt> {
    let order = serde_json::to_string(order).map_err(|error| failed(error.to_string()))?;
    let heard = |line: &str| {
        if let Ok(progress) = serde_json::from_str(line) {
            told(progress);
        }
    };
    let answer = ask(command, &order, wish, &heard).map_err(|reason| match reason {
        Unanswered::Stopped => Unlearnt::Stopped,
        Unanswered::Crashed(detail) => Unlearnt::Crashed(detail),
        Unanswered::Broken(detail) => failed(detail),
    })?;
    let answer: Answer = serde_json::from_str(&answer)
        .map_err(|error| failed(format!("what the fit answered can't be read: {error}")))?;
    answer.map(|learnt| *learnt).map_err(Unlearnt::Failed)
}

fn failed(detail: String) -> Unlearnt {
    Unlearnt::Failed(FitFailure::Other(detail))
}

/// Learns for the parent process of this one.
pub fn learn_for_parent() -> ExitCode {
    answering::answer(|order| match serde_json::from_str::<FitOrder>(order) {
        Ok(order) => answer(&order),
        Err(error) => Err(FitFailure::Other(format!(
            "the fit's order can't be read: {error}"
        ))),
    })
}

fn answer(order: &FitOrder) -> Answer {
    answering::limit_memory(order.memory_bytes);
    let work = Work {
        threads: order.threads,
        told: &|progress| answering::tell(&progress),
    };
    fit(&order.recipe, &order.files, work).and_then(learnt)
}

fn learnt(found: Fit) -> Answer {
    Ok(Box::new(Learnt {
        model: model_text(&found.estimator).map_err(FitFailure::Other)?,
        report: found.report,
        left_out: found.left_out,
    }))
}
