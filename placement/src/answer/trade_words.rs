//! The trade of films against errors in words.

use super::figure_words::with_error;
use super::layout_figures::{Figure, angle, force};
use super::layout_words::{counted, laid, words};
use crate::score::notes::listed;
use documents::study::question::Question;
use layouts::simulate::simulation::LOST_DEG;
use results::{MenuFindings, RankedLayout, TradeAnswer, TradeRow};

/// Says what was tried: `180 layouts were tried: 3 to 48 films along x, y, or both, at the crown, shoulder or sidewall.`
pub(super) fn menu(layouts: &[RankedLayout], menu: MenuFindings) -> String {
    let tried = layouts.len() + menu.screened;
    let mut told = match tried {
        1 => "1 layout was tried".to_owned(),
        tried => format!("{tried} layouts were tried"),
    };
    let counts = || layouts.iter().map(|layout| layout.film_count);
    if let (Some(fewest), Some(most)) = (counts().min(), counts().max()) {
        let range = match fewest == most {
            true => format!("{most} films"),
            false => format!("{fewest} to {most} films"),
        };
        told = format!(
            "{told}: {range} along {}, {}",
            ways(layouts),
            places(layouts)
        );
    }
    if menu.screened > 0 {
        told = format!(
            "{told}; {} of them weren't simulated, as their bounds are worse than others' errors",
            menu.screened
        );
    }
    match menu.without_room {
        0 => format!("{told}."),
        1 => format!("{told}. 1 more has no room for its films."),
        more => format!("{told}. {more} more have no room for their films."),
    }
}

/// `x, y, x and y`: each set of directions once, in their order of size.
fn ways(layouts: &[RankedLayout]) -> String {
    let mut sets: Vec<Vec<&str>> = layouts
        .iter()
        .map(|layout| layout.films.iter().map(String::as_str).collect())
        .collect();
    sets.sort_by(|a, b| a.len().cmp(&b.len()).then(a.cmp(b)));
    sets.dedup();
    let named: Vec<String> = sets.iter().map(|set| listed(set)).collect();
    match named.as_slice() {
        [one] => one.clone(),
        [first @ .., last] => format!("{}, or {last}", first.join(", ")),
        [] => String::new(),
    }
}

/// Names of the section angles: `at the crown, shoulder or sidewall`.
fn places(layouts: &[RankedLayout]) -> String {
    let mut names: Vec<&str> = Vec::new();
    for layout in layouts {
        let name = match layout.position.as_str() {
            "mixed" => "several section angles",
            name => name,
        };
        if !names.contains(&name) {
            names.push(name);
        }
    }
    // From the crown down to the bead, as the eye goes.
    names.sort_by_key(|name| {
        ["crown", "shoulder", "sidewall"]
            .iter()
            .position(|known| known == name)
            .unwrap_or(3)
    });
    match names.as_slice() {
        [one] => format!("at {one}"),
        [first @ .., last] => format!("at {} or {last}", first.join(", ")),
        [] => String::new(),
    }
}

/// The figures that are asked for: `10.7 +- 1.8 degrees`, `0.81 +- 0.05 N`, or both.
pub(super) fn figures(layout: &RankedLayout, question: &Question) -> String {
    let told = |figure: Option<Figure>, unit: &str| {
        figure.map(|figure| format!("{} {unit}", with_error(figure.value, figure.claim)))
    };
    let is_forced = question.force_n.is_some();
    let of_angle = (question.angle_deg.is_some() || !is_forced).then(|| angle(layout));
    let of_force = is_forced.then(|| force(layout));
    let both = [
        told(of_angle.flatten(), "degrees"),
        told(of_force.flatten(), "N"),
    ];
    let both: Vec<String> = both.into_iter().flatten().collect();
    both.join(" and ")
}

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
        Some(_) => lead(question, picked.film_count),
    };
    let beside = trade
        .picked
        .map(|row| beside(trade, row))
        .unwrap_or_default();
    let why = match (
        question.is_empty() && trade.picked == trade.knee,
        beside.is_empty(),
    ) {
        (true, false) => " From there on twice the films don't halve the error:",
        _ => "",
    };
    let known = known(picked, question);
    format!("{lead}: {how}; they know {known}{worst}.{why}{beside}")
}

/// `12 films`, `5 degrees need 18 films`, `The knee is at 24 films`.
fn lead(question: &Question, films: usize) -> String {
    match (question.has_limits(), question.films) {
        (true, _) => format!("{} need {}", limits(question), counted(films)),
        (false, Some(most)) if most != films => format!("Of up to {most} films {films} do best"),
        (false, Some(_)) => counted(films),
        (false, None) => format!("The knee is at {films} films"),
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
    let most = question.films.map(|most| format!("up to {most} films"));
    match (question.has_limits(), most) {
        (true, Some(most)) => format!("with {most} keeps to {}", limits(question)),
        (true, None) => format!("keeps to {}", limits(question)),
        (false, Some(most)) => format!("has {most}"),
        (false, None) => "keeps the contact".to_owned(),
    }
}

/// `the contact angle to 10.7 +- 1.8 degrees in 95 of 100 contacts`.
fn known(layout: &RankedLayout, question: &Question) -> String {
    let of_angle = angle(layout).map(|angle| {
        let angle = with_error(angle.value, angle.claim);
        format!("the contact angle to {angle} degrees in 95 of 100 contacts")
    });
    let of_force = question.force_n.and_then(|_| force(layout)).map(|force| {
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
