//! Estimate of a study's cost, and how it compares with what the study took, for people.

use std::fmt::Write;
use std::path::Path;

use placement::compare::MOST_TOLD;
use results::{Estimate, Forecast, StudyResult};
use tokio::runtime::Runtime;

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::paint::{HEADER, painted};
use crate::cli::terminal::slip_text::slip_lines;
use crate::cli::terminal::wrapping::wrapped;
use service::forecast::ForecastError;
use service::wire::estimator_wire::FitEstimate;
use service::wire::sweep_wire::{DesignEstimate, SweepEstimate};
use store::Store;

/// Asks for an estimate with what a database knows. Makes no database: where there is none, nothing is known.
pub fn estimated<T>(
    runtime: &Runtime,
    database: &Path,
    ask: impl AsyncFnOnce(Option<&Store>) -> Result<T, ForecastError>,
) -> Result<T, Failure> {
    let estimate = runtime.block_on(async {
        if !database.exists() {
            return ask(None).await;
        }
        let store = Store::open(database).await?;
        let estimate = ask(Some(&store)).await;
        store.close().await?;
        estimate
    });
    estimate.map_err(Failure::other)
}

/// Returns all that `run --dry-run` prints.
pub(crate) fn dry_run(name: &str, estimate: &Estimate) -> String {
    let title = painted(HEADER, name.escape_debug());
    let mut text = format!("{title}\n\n{}", solves(estimate));
    let time = estimate.wall_s.as_ref().map_or("unknown".to_owned(), range);
    let _ = writeln!(text, "time       {time} on {} threads", estimate.threads);
    let _ = writeln!(
        text,
        "memory     {} MB\ndatabase   {} more",
        megabytes(estimate.peak_memory_bytes),
        room(estimate.database_bytes)
    );
    let accuracy = &estimate.accuracy;
    let figure = |error: Option<f64>| error.map_or("unknown".to_owned(), |e| format!("{e:.3}"));
    let accuracy_line = format!(
        "accuracy   {}: on the paper's study its indices were off by {}, and claimed {}",
        accuracy.fidelity,
        figure(accuracy.error_true),
        figure(accuracy.error_claimed)
    );
    text += &wrapped(&accuracy_line, 11);
    text.push('\n');
    text += &slip_lines(&estimate.unlikely);
    for reason in estimate.reasons.iter().chain(&accuracy.reason) {
        text += &wrapped(&format!("- {reason}"), 2);
    }
    text
}

/// Returns all that `sweep --dry-run` prints.
pub(crate) fn dry_sweep(name: &str, threads: usize, sweep: &SweepEstimate) -> String {
    let mut text = painted(HEADER, name.escape_debug()) + "\n\n";
    for DesignEstimate { name, estimate } in sweep.designs.iter().take(MOST_TOLD) {
        let time = estimate.wall_s.as_ref().map_or("unknown".to_owned(), range);
        let _ = writeln!(
            text,
            "{:<40} {:>6} solves, {:>6} known  {time}",
            name.escape_debug(),
            estimate.solves.left.expected,
            estimate.solves.known
        );
    }
    let others = sweep.designs.len().saturating_sub(MOST_TOLD);
    if others > 0 {
        let _ = writeln!(text, "and {others} others");
    }
    let time = sweep.wall_s.as_ref().map_or("unknown".to_owned(), range);
    let _ = writeln!(
        text,
        "\n{} designs: {} solves, {time} on {threads} threads, {} MB, and {} more of database",
        sweep.designs.len(),
        sweep.left.expected,
        megabytes(sweep.peak_memory_bytes),
        room(sweep.database_bytes)
    );
    text
}

/// Returns all that `force fit --dry-run` prints.
pub(crate) fn fit_estimate(estimate: &FitEstimate) -> String {
    let time = range(&estimate.wall_s);
    let megabytes = megabytes(estimate.peak_memory_bytes);
    format!(
        "time       {time} on {} threads\nmemory     {megabytes} MB at most\n",
        estimate.threads
    )
}

fn solves(estimate: &Estimate) -> String {
    let solves = &estimate.solves;
    let left = solves.left;
    let range = if left.least == left.most {
        String::new()
    } else {
        format!(" ({} to {})", left.least, left.most)
    };
    let signals = match solves.signals {
        0 => String::new(),
        signals => format!(", {signals} for films' signals"),
    };
    let tables = match solves.tables {
        0 => String::new(),
        tables => format!(", {tables} for the rig's table"),
    };
    let layouts = match solves.layouts {
        0 => String::new(),
        layouts => format!(", {layouts} for layouts"),
    };
    let line = format!(
        "solves     {}{range}: {} points, {} on coarser meshes, {} for what is left out{layouts}{signals}{tables}; {} known already",
        left.expected, solves.own, solves.coarser, solves.effects, solves.known
    );
    wrapped(&line, 11)
}

fn range(wall_s: &Forecast) -> String {
    format!(
        "{} ({} to {})",
        duration(wall_s.expected),
        duration(wall_s.least),
        duration(wall_s.most)
    )
}

/// Seconds, minutes or hours, whichever reads best.
fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 120.0 => format!("{s:.2} s"),
        s if s < 7200.0 => format!("{:.0} min", s / 60.0),
        s => format!("{:.1} h", s / 3600.0),
    }
}

fn megabytes(bytes: u64) -> u64 {
    bytes / 1_000_000
}

/// Room on a disk, in the unit that reads best.
fn room(bytes: u64) -> String {
    match bytes as f64 {
        b if b < 1e8 => format!("{:.1} MB", b / 1e6),
        b if b < 1e9 => format!("{:.0} MB", b / 1e6),
        b => format!("{:.1} GB", b / 1e9),
    }
}

/// Returns a line that says what a study is expected to take now, and why.
pub fn revised(estimate: &Estimate) -> String {
    let time = estimate.wall_s.as_ref().map_or("unknown".to_owned(), range);
    let why = estimate.reasons.last().map_or("", String::as_str);
    format!("expected now: {time} in all; {why}")
}

/// Returns a line that compares what was expected with what it took; nothing where nobody expected anything.
pub fn comparison(result: &StudyResult) -> String {
    let (Some(estimate), cost) = (&result.estimate, &result.cost) else {
        return String::new();
    };
    let time = match &estimate.wall_s {
        Some(wall_s) => format!(
            "{}, it took {:.1} times that",
            range(wall_s),
            cost.wall_s / wall_s.expected
        ),
        None => "an unknown time".to_owned(),
    };
    let line = format!(
        "estimated before: {} solves, {time}; {} MB, it took {} MB",
        estimate.solves.left.expected,
        megabytes(estimate.peak_memory_bytes),
        megabytes(cost.peak_memory_bytes)
    );
    wrapped(&line, 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_told_in_the_unit_that_reads_best() {
        assert_eq!(duration(0.25), "0.25 s");
        assert_eq!(duration(119.0), "119.00 s");
        assert_eq!(duration(600.0), "10 min");
        assert_eq!(duration(9000.0), "2.5 h");
    }
}
