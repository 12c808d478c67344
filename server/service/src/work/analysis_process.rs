//! Analyses of models that others run, in a process of their own: what a method makes of values can't be told to stop, and takes from a millisecond to hours.

use std::process::{Command, ExitCode};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use document::fault::Fault;
use documents::own_model::analysis_document::AskedAnalysis;
use documents::own_model::own_analysis::OwnAnalysis;
use serde_json::Value;

use super::answering;
use super::own_process::{Unanswered, Wish, ask};
use crate::wire::analysis_wire::ModelAnalysis;

/// The program's only argument when it is started for this. It is no command of its users.
pub const ARGUMENT: &str = "analyse-apart";

/// Longest time that an analysis has.
const LIMIT: Duration = Duration::from_secs(60);
/// Memory that it may take, bytes: ten times what the most points need.
const MEMORY: u64 = 1 << 30;

/// Reason why there is no analysis.
#[derive(Debug, thiserror::Error)]
pub enum Unanalysed {
    /// The document has faults.
    #[error("the document has faults")]
    Faulty(Vec<Fault>),
    /// Stop on request.
    #[error("the service is stopping")]
    Stopped,
    /// Analysis that takes too long, or too much memory.
    #[error(
        "{0}: ask for fewer points by method.most_runs or of fewer outputs, or use strainsite gsa on a machine of your own"
    )]
    TooLarge(String),
    /// The process broke; the log has it.
    #[error("the service has a fault; its log says where")]
    Broken,
}

type Answer = Result<ModelAnalysis, Vec<Fault>>;

/// Analyses in the process that the command starts, until it is told to stop.
///
/// # Errors
/// See [`Unanalysed`].
pub fn analyse(
    command: Command,
    document: &Value,
    stop: &AtomicBool,
) -> Result<ModelAnalysis, Unanalysed> {
    let begun = Instant::now();
    let is_over = || begun.elapsed() > LIMIT;
    let wish = || match stop.load(Ordering::Relaxed) || is_over() {
        true => Wish::Stop,
        false => Wish::GoOn,
    };
    // A document as JSON has no line break.
    let answer = ask(command, &document.to_string(), &wish, &|_| {});
    let answer = answer.map_err(|reason| match reason {
        Unanswered::Stopped if is_over() => Unanalysed::TooLarge(format!(
            "the analysis takes longer than {} s",
            LIMIT.as_secs()
        )),
        Unanswered::Stopped => Unanalysed::Stopped,
        Unanswered::Crashed(cause) => Unanalysed::TooLarge(format!("the analysis broke, {cause}")),
        Unanswered::Broken(cause) => broken(&cause),
    })?;
    let answer: Answer =
        serde_json::from_str(&answer).map_err(|error| broken(&error.to_string()))?;
    answer.map_err(Unanalysed::Faulty)
}

fn broken(cause: &str) -> Unanalysed {
    tracing::error!(cause, "an analysis gave no answer");
    Unanalysed::Broken
}

/// Analyses for the parent process of this one.
pub fn analyse_for_parent() -> ExitCode {
    answering::answer(|order| -> Answer {
        answering::limit_memory(MEMORY);
        let document = serde_json::from_str(order).unwrap_or_default();
        let asked = AskedAnalysis::from_value(document)?;
        let analysis = OwnAnalysis::asked(&asked)?;
        Ok(ModelAnalysis::of(&analysis))
    })
}
