//! The way to the accuracy asked for, and what it all took, for people.

use results::StudyResult;

use crate::cli::terminal::paint::{BAD, GOOD, painted};
use crate::cli::terminal::wrapping::wrapped;

/// The way to the accuracy asked for, a line for each rung.
pub fn climb(result: &StudyResult) -> String {
    let Some(climb) = &result.climb else {
        return String::new();
    };
    let (met, missed) = (painted(GOOD, "is met"), painted(BAD, "is out of reach"));
    let mut text = match (climb.tolerance, climb.budget_s) {
        (Some(tolerance), _) if climb.met => format!("\nA tolerance of {tolerance} {met}:\n"),
        (Some(tolerance), _) => format!("\nA tolerance of {tolerance} {missed}:\n"),
        (None, budget) => format!("\nWithin {} s:\n", budget.unwrap_or_default()),
    };
    for (rung, wall_s) in climb.rungs.iter().zip(&result.cost.rungs_wall_s) {
        let error =
            |value: Option<f64>| value.map_or_else(|| "unknown".to_owned(), |e| format!("{e:.4}"));
        let line = format!(
            "- {}: {} solves, {wall_s:.2} s; largest claimed error of an index {}, of the mesh {}",
            rung.label,
            rung.solves,
            error(rung.error_claimed),
            error(rung.error_of_mesh)
        );
        text += &wrapped(&line, 2);
    }
    text
}

pub fn cost(result: &StudyResult) -> String {
    let cost = &result.cost;
    let coarser = match cost.coarser_solves {
        0 => String::new(),
        solves => format!(", {solves} more on a coarser mesh for its error"),
    };
    let signals = match cost.signal_solves {
        0 => String::new(),
        solves => format!(", {solves} for films' signals"),
    };
    let tables = match cost.table_solves {
        0 => String::new(),
        solves => format!(", {solves} for the rig's table"),
    };
    let layouts = match cost.layout_solves {
        0 => String::new(),
        solves => format!(", {solves} for layouts"),
    };
    let counts = format!(
        "whole study {:.2} s; {} solves, {} of them known before{coarser}{layouts}{signals}{tables}; {} Newton iterations, {} factorisations",
        cost.wall_s, cost.solves, cost.reused, cost.newton_iterations, cost.factorisations,
    );
    let shares = format!(
        "of the solves' time: factorisation {:.0} %, substitution and contact {:.0} %, assembly {:.0} %, the rest {:.0} %",
        100.0 * cost.factorisation_share,
        100.0 * cost.substitution_share,
        100.0 * cost.assembly_share,
        100.0 * cost.other_share,
    );
    format!("\n{}{}", wrapped(&counts, 2), wrapped(&shares, 2))
}
