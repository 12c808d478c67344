//! The trade of films against errors, for people.

use document::visible::visible;
use results::columns::{self, table_rows};
use results::{StudyResult, TradeRow};

use crate::cli::terminal::figures::Figures;
use crate::cli::terminal::paint::{STRONG, painted};
use crate::cli::terminal::wrapping::{cut, labelled};

/// Words above numbers of films and layouts.
const NAMES: &str = "   films  best layout";
/// Columns of what a layout is, without its number of films.
const DESCRIBED: usize = 50;
/// Columns of both.
const NAMED: usize = DESCRIBED + 10;

/// The best layout of each number of films, and what was tried; nothing where there is but one.
pub fn trade(result: &StudyResult) -> String {
    let trade = result
        .answer
        .as_ref()
        .and_then(|answer| answer.trade.as_ref());
    let Some(trade) = trade.filter(|trade| trade.rows.len() > 1) else {
        return String::new();
    };
    let figures = Figures::of(&columns::trade().view("trade"), &table_rows::trade(result));
    let mut text = figures.head(NAMES, NAMED, "");
    for (number, row) in trade.rows.iter().enumerate() {
        let is_picked = trade.picked == Some(number);
        let line = format!("{}{}", named(row, is_picked), figures.row(number));
        text += &if is_picked {
            painted(STRONG, line)
        } else {
            line
        };
        text.push('\n');
    }
    text + &labelled(STRONG, "menu", &visible(&trade.menu)) + "\n"
}

/// ` >    12  y at the crown, one every 30 degrees`: the row that answers is marked.
fn named(row: &TradeRow, is_picked: bool) -> String {
    let mark = if is_picked { '>' } else { ' ' };
    // Each line begins with the number of films, which the words do, too.
    let words = row.words.split_once(" along ");
    let words = words.map_or(&*row.words, |(_, rest)| rest);
    let words = cut(visible(words), DESCRIBED);
    format!(" {mark}{:>6}  {words:<DESCRIBED$}", row.film_count)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_is_named_by_its_films_and_marked_where_it_answers() {
        let row = TradeRow {
            film_count: 12,
            rank: 3,
            index: 2,
            words: "12 films along y at the crown, one every 30 degrees".to_owned(),
            angle_error_deg: 10.65,
            angle_claim_deg: Some(1.8),
            force_error_n: None,
            force_claim_n: None,
            cost: None,
            meets: None,
            is_front: true,
        };
        let [picked, other] = [true, false].map(|is_picked| named(&row, is_picked));
        assert_eq!(
            picked.trim_end(),
            " >    12  y at the crown, one every 30 degrees"
        );
        assert_eq!(
            other.trim_end(),
            "      12  y at the crown, one every 30 degrees"
        );
        assert_eq!(picked.chars().count(), NAMED);
    }
}
