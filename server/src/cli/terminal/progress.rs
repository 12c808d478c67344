//! Progress of a run, on a terminal.

use std::time::Duration;

use fem_client::solver::{SolveProgress, Stage};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use placement::points::Event;

use crate::cli::terminal::estimate_text::revised;
use crate::cli::terminal::output::as_warned;
use crate::cli::terminal::paint::{BAD, painted};

/// A bar on standard error, on a terminal only, after a label.
pub(crate) fn progress_bar(label: &str) -> ProgressBar {
    let bar = ProgressBar::new(0);
    if let Ok(style) = ProgressStyle::with_template(
        "{prefix}{wide_bar} {pos}/{len} points, {elapsed} gone, {eta} to go  {msg}",
    ) {
        bar.set_style(style);
    }
    bar.set_prefix(as_warned(label));
    bar
}

/// A bar that counts so many things of this kind.
pub(crate) fn counting_bar(of: usize, kind: &str) -> ProgressBar {
    ticking_bar(number(of), &format!("{{pos}}/{{len}} {kind}"))
}

/// A bar of a file that grows to so many bytes.
pub(crate) fn bytes_bar(of: u64) -> ProgressBar {
    ticking_bar(of, "{bytes}/{total_bytes}")
}

fn ticking_bar(of: u64, counted: &str) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(of), ProgressDrawTarget::hidden());
    let template = format!("{{wide_bar}} {counted}, {{elapsed}} gone, {{eta}} to go  {{msg}}");
    if let Ok(style) = ProgressStyle::with_template(&template) {
        bar.set_style(style);
    }
    seen_in_time(bar)
}

/// Moves a bar; what comes before the first of all isn't counted in the time that one takes.
pub fn count(bar: &ProgressBar, done: usize, of: usize) {
    bar.set_length(number(of));
    bar.set_position(number(done));
    if done == 1 {
        bar.reset_eta();
    }
}

fn number(count: usize) -> u64 {
    u64::try_from(count).unwrap_or(u64::MAX)
}

/// Makes the line that stands there while something takes its time, of which nobody knows how much.
pub fn clock(what: &str) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
    if let Ok(style) = ProgressStyle::with_template("{spinner} {msg}, {elapsed} gone") {
        bar.set_style(style);
    }
    bar.set_message(as_warned(what));
    seen_in_time(bar)
}

/// The bar, hidden so far, is seen from its second second on: nothing flickers on the terminal for what is done before.
fn seen_in_time(bar: ProgressBar) -> ProgressBar {
    let waiting = bar.downgrade();
    std::thread::spawn(move || {
        std::thread::sleep(PATIENCE);
        let still = waiting.upgrade().filter(|bar| !bar.is_finished());
        if let Some(bar) = still {
            bar.set_draw_target(ProgressDrawTarget::stderr());
            bar.enable_steady_tick(TICK);
        }
    });
    bar
}

/// Least time for a bar: what takes less needs none.
const PATIENCE: Duration = Duration::from_secs(1);

/// Interval at which a bar is drawn anew when nothing else moves it.
pub(crate) const TICK: Duration = Duration::from_millis(200);

/// Says how far the solve is that was told of last.
fn solving(progress: &SolveProgress) -> String {
    let stage = match progress.stage {
        Stage::Inflating => "inflating",
        Stage::Pressing => "pressing",
    };
    let residual = progress.residual;
    let residual =
        residual.map_or_else(String::new, |residual| format!(", residual {residual:.0e}"));
    format!("{stage}, iteration {}{residual}", progress.iterations)
}

/// Says above the bar which point failed, and why.
pub(crate) fn say_failed(bar: &ProgressBar, ordinal: usize, cause: &str) {
    let point = painted(BAD, format!("point {ordinal}"));
    bar.println(as_warned(&format!("{point}: {cause}")));
}

/// Moves the bar, and says above it what failed.
pub(crate) fn show(bar: &ProgressBar, event: &Event) {
    match event {
        Event::Started { points, reused } => {
            bar.set_length(number(*points));
            bar.set_position(number(*reused));
            bar.reset_eta();
        }
        Event::PointSolved {
            done,
            newton_iterations,
            wall_s,
            ..
        } => {
            bar.set_position(number(*done));
            bar.set_message(format!(
                "last: {newton_iterations} iterations, {wall_s:.1} s"
            ));
        }
        Event::PointFailed {
            ordinal,
            done,
            cause,
            ..
        } => {
            bar.set_position(number(*done));
            say_failed(bar, *ordinal, cause);
        }
        Event::Solving { progress, .. } => bar.set_message(solving(progress)),
        Event::Analysing => bar.set_message("analysing"),
        Event::Revised(estimate) => bar.println(as_warned(&revised(estimate))),
    }
}
