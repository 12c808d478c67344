//! Errors of left-out runs by where they begin: under a load, and zeroed after lifting.

use document::visible::visible;
use estimation::fit_report::ForceReport;

/// Width of a figure's column, and of what stands before them.
const WIDE: usize = 8;
const NAMED: usize = 40;

/// Table of begins and the sentence that follows from it; nothing where no run was left out.
pub(super) fn beginnings(force: &ForceReport) -> String {
    let Some(beginnings) = &force.beginnings else {
        return String::new();
    };
    let mut text = format!("{}: runs that weren't learnt from\n", visible(&force.force));
    let loaded = beginnings.loaded.iter();
    let loaded = loaded.map(|one| (three(one.load_n), one.rmse_n, one.recorded_rmse_n));
    text += &block("begun under a load of, N", loaded.collect());
    let rested = beginnings.rested.iter();
    let rested = rested.map(|one| (format!("{}", one.rest_s), one.rmse_n, one.recorded_rmse_n));
    text += &block("zeroed after a rest without load of, s", rested.collect());
    text + "  " + &beginnings.advice + "\n\n"
}

/// A line of places, one of the errors there, one of those as recorded.
fn block(places: &str, figures: Vec<(String, f64, f64)>) -> String {
    if figures.is_empty() {
        return String::new();
    }
    let line = |name: &str, of: &dyn Fn(&(String, f64, f64)) -> String| {
        let cells = figures.iter().map(|one| format!("{:>WIDE$}", of(one)));
        format!("  {name:<NAMED$}{}\n", cells.collect::<String>())
    };
    line(places, &|one| one.0.clone())
        + &line("  off by, N", &|one| format!("{:.3}", one.1))
        + &line("  the same rows as recorded, N", &|one| {
            format!("{:.3}", one.2)
        })
}

/// A load to three figures.
fn three(load_n: f64) -> String {
    let digits = match load_n.abs() {
        x if x >= 100.0 => 0,
        x if x >= 10.0 => 1,
        _ => 2,
    };
    format!("{load_n:.digits$}")
}
