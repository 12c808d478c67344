//! The trade as a table: for people, and as CSV.

use std::fmt::Write;

use placement::ladder::trade::{Rung, Trade};
use results::columns;
use serde_json::{Value, json};
use service::export;

use crate::cli::terminal::figures::Figures;
use crate::cli::terminal::paint::{BAD, GOOD, HEADER, left, painted};

/// Characters of a rung's name.
const NAMED: usize = 24;

/// Returns all that `trade` prints.
pub fn report(trade: &Trade) -> String {
    let mut text = painted(HEADER, trade.study.escape_debug()) + "\n\n";
    let figures = Figures::of(&columns::rungs().view("rungs"), &rows(&trade.rungs));
    text.push_str(&figures.head("mesh, method, nodes", NAMED, "  ranking   front"));
    for (row, rung) in trade.rungs.iter().enumerate() {
        text.push_str(&line(rung, &figures.row(row)));
    }
    let claimed = trade.reference.error_claimed;
    let claimed = claimed.map_or_else(|| "-".to_owned(), |error| format!("{error:.4}"));
    let _ = writeln!(
        text,
        "\nTrue errors are differences from {} ({} solves, {:.1} s), whose own claim is {}. Errors are absolute; an index lies between 0 and 1. A draft claims nothing: it doesn't know what its mesh does.",
        trade.reference.label, trade.reference.solves, trade.reference.wall_s, claimed
    );
    text.push_str(&verdict(trade));
    text
}

fn rows<'r>(rungs: impl IntoIterator<Item = &'r Rung>) -> Vec<Value> {
    let row = |rung| json!({ "rung": rung });
    rungs.into_iter().map(row).collect()
}

fn line(rung: &Rung, figures: &str) -> String {
    let (style, ranking) = match rung.ranking_agrees {
        true => (GOOD, "agrees"),
        false => (BAD, "differs"),
    };
    let front = if rung.pareto { "*" } else { "" };
    format!(
        "{:<NAMED$}{figures}  {}  {front}\n",
        rung.label,
        left(style, ranking, 8)
    )
}

/// The cheapest rung that ranks as the reference does.
fn verdict(trade: &Trade) -> String {
    let agreeing = trade.rungs.iter().filter(|rung| rung.ranking_agrees);
    match agreeing.min_by(|a, b| a.wall_s.total_cmp(&b.wall_s)) {
        Some(rung) => format!(
            "The cheapest rung that ranks the locations as the reference does is {}: {:.2} s, {:.0} times less.\n",
            rung.label,
            rung.wall_s,
            trade.reference.wall_s / rung.wall_s
        ),
        None => "No rung ranks the locations as the reference does.\n".to_owned(),
    }
}

/// Writes a line per rung, the reference last.
pub fn csv(trade: &Trade) -> String {
    let rungs = trade.rungs.iter().chain([&trade.reference]);
    export::csv_of(&columns::rungs(), &rows(rungs))
}
