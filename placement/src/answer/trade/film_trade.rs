//! Trade of films against errors: the best layout of each number of films, and which of them answers.

use std::collections::BTreeMap;

use crate::answer::layout_figures::Figures;
use crate::answer::layout_words::words;
use documents::study::question::Question;
use layouts::simulate::simulation::LOST_DEG;
use results::{LayoutFindings, RankedLayout, TradeAnswer, TradeRow};

/// The trade of these layouts, which are in their order, with the question and the number of films that are glued on already; `None` where none has a score.
pub(crate) fn trade(
    layouts: &[RankedLayout],
    findings: Option<&LayoutFindings>,
    (question, taken): (Question, usize),
) -> Option<TradeAnswer> {
    let mut rows = best_of_each_count(layouts, &question);
    let most_films = question.most_films(taken);
    if rows.is_empty() {
        return None;
    }
    for row in &mut rows {
        row.cost = question.cost_of(row.film_count, taken);
    }
    mark_front(&mut rows, layouts, &question);
    let knee = knee(&rows);
    let picked = match question.asks_nothing() {
        true => knee.or_else(|| least(&rows, layouts, &question)),
        false => answering(&rows, layouts, &question, most_films),
    };
    let menu = findings.map(|findings| findings.menu.clone());
    let menu = menu.unwrap_or_default();
    Some(TradeAnswer {
        question,
        picked,
        knee,
        tried: layouts.len() + menu.screened,
        screened: menu.screened,
        without_room: menu.without_room,
        most_films,
        menu: menu.sentence,
        rows,
    })
}

fn best_of_each_count(layouts: &[RankedLayout], question: &Question) -> Vec<TradeRow> {
    let mut best: BTreeMap<usize, (f64, usize)> = BTreeMap::new();
    for (index, layout) in layouts.iter().enumerate() {
        let figures = Figures::of(layout);
        let Some(figure) = figures
            .compared(question)
            .filter(|_| figures.angle.is_some())
        else {
            continue;
        };
        let entry = best
            .entry(layout.film_count)
            .or_insert((f64::INFINITY, index));
        if figure.value < entry.0 {
            *entry = (figure.value, index);
        }
    }
    let found = best.into_values();
    found
        .filter_map(|(_, index)| row(index, &layouts[index], question))
        .collect()
}

fn row(index: usize, layout: &RankedLayout, question: &Question) -> Option<TradeRow> {
    let figures = Figures::of(layout);
    let (angle, force) = (figures.angle?, figures.force);
    let compared = figures.compared(question)?;
    Some(TradeRow {
        film_count: layout.film_count,
        rank: layout.rank,
        index,
        words: words(layout),
        angle_error_deg: angle.value,
        angle_claim_deg: angle.claim,
        force_error_n: force.map(|force| force.value),
        force_claim_n: force.and_then(|force| force.claim),
        cost: None,
        meets: question.has_limits().then_some(compared.value <= 1.0),
        is_front: false,
    })
}

/// Marks rows that no row of fewer films equals.
fn mark_front(rows: &mut [TradeRow], layouts: &[RankedLayout], question: &Question) {
    let mut least = f64::INFINITY;
    for row in rows {
        let value = Figures::of(&layouts[row.index])
            .compared(question)
            .map_or(f64::INFINITY, |own| own.value);
        row.is_front = value < least;
        least = least.min(value);
    }
}

/// Returns the row from which on twice the films don't halve the error: the fewest films, of those that keep the contact, whose number times the error can't be told
/// from the least.
fn knee(rows: &[TradeRow]) -> Option<usize> {
    let price = |row: &TradeRow| {
        let films = row.film_count as f64;
        let claim = films * row.angle_claim_deg.unwrap_or(0.0);
        (films * row.angle_error_deg, claim)
    };
    let keeps = || (0..rows.len()).filter(|&k| rows[k].angle_error_deg <= LOST_DEG);
    let prices = keeps().map(|k| price(&rows[k]));
    let (least, claim) = prices.min_by(|a, b| a.0.total_cmp(&b.0))?;
    keeps().find(|&k| {
        let own = price(&rows[k]);
        own.0 - least <= own.1.max(claim)
    })
}

/// Returns the row of the least error.
fn least(rows: &[TradeRow], layouts: &[RankedLayout], question: &Question) -> Option<usize> {
    let value = |k: usize| {
        Figures::of(&layouts[rows[k].index])
            .compared(question)
            .map_or(f64::INFINITY, |own| own.value)
    };
    (0..rows.len()).min_by(|&i, &j| value(i).total_cmp(&value(j)))
}

/// Returns the row that answers a question: the fewest films within the limits; without limits the least error. Neither has more films than there are.
fn answering(
    rows: &[TradeRow],
    layouts: &[RankedLayout],
    question: &Question,
    most_films: Option<usize>,
) -> Option<usize> {
    let few = rows.partition_point(|row| most_films.is_none_or(|most| row.film_count <= most));
    if question.has_limits() {
        return rows[..few].iter().position(|row| row.meets == Some(true));
    }
    least(&rows[..few], layouts, question)
}
