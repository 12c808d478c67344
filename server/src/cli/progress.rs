//! How far a run is, on a terminal.

use std::time::Duration;

use anstream::{AutoStream, ColorChoice};
use indicatif::{ProgressBar, ProgressStyle};
use placement::run::Event;

use super::paint::{BAD, painted};

/// A bar on standard error, on a terminal only, after a label.
pub fn progress_bar(label: &str) -> ProgressBar {
    let bar = ProgressBar::new(0);
    if let Ok(style) = ProgressStyle::with_template(
        "{prefix}{wide_bar} {pos}/{len} points, {elapsed} gone, {eta} to go  {msg}",
    ) {
        bar.set_style(style);
    }
    bar.set_prefix(label.to_owned());
    bar
}

/// A bar that counts so many things of this kind.
pub fn counting_bar(of: usize, kind: &str) -> ProgressBar {
    let bar = ProgressBar::new(u64::try_from(of).unwrap_or(u64::MAX));
    let template = format!("{{wide_bar}} {{pos}}/{{len}} {kind}, {{elapsed}} gone, {{eta}} to go");
    if let Ok(style) = ProgressStyle::with_template(&template) {
        bar.set_style(style);
    }
    bar.enable_steady_tick(TICK);
    bar
}

/// What stands there while something takes its time, of which nobody knows how much.
pub fn clock(what: &str) -> ProgressBar {
    let bar = ProgressBar::new_spinner();
    if let Ok(style) = ProgressStyle::with_template("{spinner} {msg}, {elapsed} gone") {
        bar.set_style(style);
    }
    bar.set_message(what.to_owned());
    bar.enable_steady_tick(TICK);
    bar
}

const TICK: Duration = Duration::from_millis(200);

/// Says above the bar which point failed, and why.
pub fn say_failed(bar: &ProgressBar, ordinal: usize, cause: &str) {
    let point = format!("point {ordinal}");
    let point = match AutoStream::choice(&std::io::stderr()) {
        ColorChoice::Never => point,
        _ => painted(BAD, point),
    };
    bar.println(format!("{point}: {cause}"));
}

/// Moves the bar, and says above it what failed.
pub fn show(bar: &ProgressBar, event: &Event) {
    let count = |number: usize| u64::try_from(number).unwrap_or(u64::MAX);
    match event {
        Event::Started { points, reused } => {
            bar.set_length(count(*points));
            bar.set_position(count(*reused));
            bar.reset_eta();
        }
        Event::PointSolved {
            done,
            newton_iterations,
            wall_s,
            ..
        } => {
            bar.set_position(count(*done));
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
            bar.set_position(count(*done));
            say_failed(bar, *ordinal, cause);
        }
        Event::Analysing => bar.set_message("analysing"),
    }
}
