//! The trade of films against errors, for people.

use std::fmt::Write;

use document::visible::visible;
use results::{StudyResult, TradeAnswer, TradeRow};

use crate::cli::terminal::paint::{HEADER, STRONG, painted};
use crate::cli::terminal::wrapping::{cut, labelled};

/// Columns of what a layout is, without its number of films.
const DESCRIBED: usize = 50;

/// The best layout of each number of films, and what was tried; nothing where there is but one.
pub fn trade(result: &StudyResult) -> String {
    let trade = result
        .answer
        .as_ref()
        .and_then(|answer| answer.trade.as_ref());
    let Some(trade) = trade.filter(|trade| trade.rows.len() > 1) else {
        return String::new();
    };
    let head = format!(
        "   films  {:<DESCRIBED$}{:>16}{:>16}",
        "best layout", "angle, 95 %, deg", "force, rms, N"
    );
    let mut text = painted(HEADER, head) + "\n";
    for (number, row) in trade.rows.iter().enumerate() {
        let line = line(row, trade, number);
        let is_picked = trade.picked == Some(number);
        text += &if is_picked {
            painted(STRONG, line)
        } else {
            line
        };
        text.push('\n');
    }
    text + &labelled(STRONG, "menu", &visible(&trade.menu))
}

fn line(row: &TradeRow, trade: &TradeAnswer, number: usize) -> String {
    let mark = match trade.picked == Some(number) {
        true => '>',
        false => ' ',
    };
    // Each row begins with its number of films, which the words do, too.
    let words = row
        .words
        .split_once(" along ")
        .map_or(&*row.words, |(_, rest)| rest);
    let mut line = format!(
        " {mark}{:>6}  {:<DESCRIBED$}",
        row.film_count,
        cut(visible(words), DESCRIBED)
    );
    let angle = figure(Some(row.angle_error_deg), row.angle_claim_deg);
    let force = figure(row.force_error_n, row.force_claim_n);
    let _ = write!(line, "{angle:>16}{force:>16}");
    line
}

/// `10.7 +- 1.8`, as far as the claim tells; ` - ` where there is none.
fn figure(value: Option<f64>, claim: Option<f64>) -> String {
    let Some(value) = value else {
        return "-".to_owned();
    };
    let decimals = match value.abs() {
        size if size >= 10.0 => 1,
        _ => 2,
    };
    match claim {
        Some(claim) => format!("{value:.decimals$} +-{claim:>5.decimals$}"),
        None => format!("{value:.decimals$}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_told_with_their_claims() {
        assert_eq!(figure(Some(10.65), Some(1.8)), "10.7 +-  1.8");
        assert_eq!(figure(Some(0.525), Some(0.061)), "0.53 +- 0.06");
        assert_eq!(figure(Some(0.525), None), "0.53");
        assert_eq!(figure(None, None), "-");
    }
}
