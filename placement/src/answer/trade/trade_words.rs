//! The trade of films against errors in words.

use crate::answer::figure_words::with_error;
use crate::answer::layout_figures::Figures;
use crate::answer::layout_words::{counted, laid, words};
use documents::study::question::Question;
use layouts::simulate::simulation::LOST_DEG;
use results::{RankedLayout, TradeAnswer, TradeRow};

/// The answer to the question in a sentence, with what more or fewer films would give; without a question about the knee.
pub(super) fn sentence(trade: &TradeAnswer, picked: &RankedLayout) -> String {
    let question = &trade.question;
    let worst = match picked.loads.len() {
        0 | 1 => "",
        _ => " at the worst load",
    };
    let is_lost = picked.score.simulated_p95_angle_error_deg > Some(LOST_DEG);
    let answers = trade.picked.is_some() && !is_lost;
    let how = match answers {
        true => format!("glue them {}", laid(picked)),
        false => format!("{} come closest", words(picked)),
    };
    let lead = match trade.picked {
        None => format!("No layout that was tried {}", refused(question)),
        Some(_) if is_lost => "No layout that answers keeps the contact".to_owned(),
        Some(row) => lead(question, &trade.rows[row]),
    };
    let beside = trade
        .picked
        .map(|row| beside(trade, row))
        .unwrap_or_default();
    let why = match (
        question.asks_nothing() && trade.picked == trade.knee,
        beside.is_empty(),
    ) {
        (true, false) => " From there on twice the films don't halve the error:",
        _ => "",
    };
    let known = known(picked, question);
    format!("{lead}: {how}; they know {known}{worst}.{why}{beside}")
}

/// `12 films`, `5 degrees need 18 films`, `The knee is at 24 films`.
fn lead(question: &Question, row: &TradeRow) -> String {
    let films = row.film_count;
    match (question.has_limits(), question.cost, question.films) {
        (true, ..) => format!("{} need {}", limits(question), counted(films)),
        (false, Some(most), _) => {
            let own = row.cost.unwrap_or(most);
            format!("Up to a cost of {most} {films} films at {own} do best")
        }
        (false, None, Some(most)) if most != films => {
            format!("Of up to {most} films {films} do best")
        }
        (false, None, Some(_)) => counted(films),
        (false, None, None) => format!("The knee is at {films} films"),
    }
}

/// `5 degrees`, `2 N`, `5 degrees and 2 N`.
fn limits(question: &Question) -> String {
    let angle = question.angle_deg.map(|angle| format!("{angle} degrees"));
    let force = question.force_n.map(|force| format!("{force} N"));
    let both: Vec<String> = [angle, force].into_iter().flatten().collect();
    both.join(" and ")
}

/// Says what no layout does.
fn refused(question: &Question) -> String {
    let films = question.films.map(|most| format!("up to {most} films"));
    let cost = question.cost.map(|most| format!("a cost of {most}"));
    let both: Vec<String> = [films, cost].into_iter().flatten().collect();
    let most = (!both.is_empty()).then(|| both.join(" and "));
    match (question.has_limits(), most) {
        (true, Some(most)) => format!("with {most} keeps to {}", limits(question)),
        (true, None) => format!("keeps to {}", limits(question)),
        (false, Some(most)) => format!("has {most}"),
        (false, None) => "keeps the contact".to_owned(),
    }
}

/// `the contact angle to 10.7 +- 1.8 degrees in 95 of 100 contacts`.
fn known(layout: &RankedLayout, question: &Question) -> String {
    let figures = Figures::of(layout);
    let of_angle = figures.angle.map(|angle| {
        let angle = with_error(angle.value, angle.claim);
        format!("the contact angle to {angle} degrees in 95 of 100 contacts")
    });
    let of_force = question.force_n.and(figures.force).map(|force| {
        let force = with_error(force.value, force.claim);
        format!("the vertical force to {force} N rms")
    });
    let told: Vec<String> = [of_angle, of_force].into_iter().flatten().collect();
    told.join(" and ")
}

/// Says what more films and fewer would give.
fn beside(trade: &TradeAnswer, picked: usize) -> String {
    let own = &trade.rows[picked];
    let forced = trade.question.angle_deg.is_none() && trade.question.force_n.is_some();
    let figure = |row: &TradeRow| {
        let (value, claim, unit) = match (forced, row.force_error_n) {
            (true, Some(force)) => (force, row.force_claim_n, "N"),
            _ => (row.angle_error_deg, row.angle_claim_deg, "degrees"),
        };
        format!(
            "{} films {} {unit}",
            row.film_count,
            with_error(value, claim)
        )
    };
    let front = |row: &&TradeRow| row.is_front;
    let fewer = trade.rows[..picked].iter().rev().find(|row| row.is_front);
    let twice = |row: &&TradeRow| row.film_count >= 2 * own.film_count;
    let mut above = trade.rows[picked + 1..].iter().filter(front);
    let more = above.clone().find(twice).or_else(|| above.next_back());
    let told: Vec<String> = [fewer, more].into_iter().flatten().map(figure).collect();
    match told.as_slice() {
        [] => String::new(),
        told => format!(
            " {}.",
            told.join(", ").replacen(" films ", " films give ", 1)
        ),
    }
}
