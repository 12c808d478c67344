//! The trade as a table: for people, and as CSV.

use std::fmt::Write;

use placement::ladder::trade::{Rung, Trade};

use crate::cli::terminal::paint::{BAD, GOOD, HEADER, header, left, painted};

/// Everything that `trade` prints.
pub fn report(trade: &Trade) -> String {
    let mut text = painted(HEADER, trade.study.escape_debug()) + "\n\n";
    text.push_str(&header("                          wall      CPU            largest error of an index     claims that\n"));
    text.push_str(&header("mesh, method, nodes          s        s   solves   true        claimed           hold, %      ranking   front\n"));
    for rung in &trade.rungs {
        text.push_str(&row(rung));
    }
    let _ = writeln!(
        text,
        "\nTrue errors are differences from {} ({} solves, {:.1} s), whose own claim is {}. Errors are absolute; an index lies between 0 and 1. A draft claims nothing: it doesn't know what its mesh does.",
        trade.reference.label,
        trade.reference.solves,
        trade.reference.wall_s,
        error(trade.reference.error_claimed).trim()
    );
    text.push_str(&verdict(trade));
    text
}

fn row(rung: &Rung) -> String {
    let covered = rung
        .covered
        .map_or_else(|| "-".to_owned(), |share| format!("{:.0}", 100.0 * share));
    let (style, ranking) = match rung.ranking_agrees {
        true => (GOOD, "agrees"),
        false => (BAD, "differs"),
    };
    format!(
        "{:24} {:7.2}  {:7.2}  {:6}   {}   {}   {covered:>10}         {} {}\n",
        rung.label,
        rung.wall_s,
        rung.cpu_s,
        rung.solves,
        error(rung.error_true),
        error(rung.error_claimed),
        left(style, ranking, 8),
        if rung.pareto { "*" } else { "" },
    )
}

fn error(value: Option<f64>) -> String {
    value.map_or_else(|| format!("{:>9}", "-"), |value| format!("{value:9.4}"))
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

/// One line per rung, the reference last.
pub fn csv(trade: &Trade) -> String {
    let mut text = "label,level,method,nodes,check_points,wall_s,cpu_s,solves,error_true,error_claimed,covered,ranking_agrees,pareto\n".to_owned();
    for rung in trade.rungs.iter().chain([&trade.reference]) {
        let number = |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
        let fidelity = &rung.fidelity;
        let _ = writeln!(
            text,
            "{},{},{},{},{},{},{},{},{},{},{},{},{}",
            rung.label,
            fidelity.level,
            fidelity.method,
            fidelity.nodes,
            fidelity.check_points,
            rung.wall_s,
            rung.cpu_s,
            rung.solves,
            number(rung.error_true),
            number(rung.error_claimed),
            number(rung.covered),
            rung.ranking_agrees,
            rung.pareto,
        );
    }
    text
}
