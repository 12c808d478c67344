//! The layout that ranks first, how sure that is, and why.

use super::figure_words::with_error;
use super::first_rank::{Judged, Standing, judge};
use super::layout_words::{instruction, words};
use crate::score::notes::listed;
use layouts::ranking::layout_order::order_key;
use layouts::simulate::simulation::LOST_DEG;
use results::{Certainty, LayoutAnswer, RankedLayout};

/// Layouts that a sentence names.
const NAMED: usize = 3;

/// The best layout with its sentence; `None` where none has a score.
pub(super) fn best_layout(layouts: &[RankedLayout]) -> Option<(LayoutAnswer, String)> {
    let best = layouts.first()?;
    let angle_error_deg = best.score.simulated_p95_angle_error_deg?;
    let error = best.score.error.as_ref();
    let error_deg = error.and_then(|error| error.simulated_p95_angle_error_deg);
    let others: Vec<&RankedLayout> = layouts
        .iter()
        .filter(|layout| layout.rank != best.rank && order_key(layout).value.is_finite())
        .collect();
    let standings: Vec<Standing> = others.iter().map(|layout| standing(layout)).collect();
    let mut judged = judge(&standing(best), &standings);
    let is_lost = angle_error_deg > LOST_DEG;
    if is_lost {
        judged.verdict = Certainty::Unknown;
    }
    let mut tied_with: Vec<usize> = judged.tied.iter().map(|&k| others[k].rank).collect();
    tied_with.dedup();
    let mut reason = match is_lost {
        true => lost(best),
        false => reason(&judged, best, &others, &tied_with),
    };
    reason.extend(shear(best, layouts).iter().flat_map(|told| [" ", told]));
    let sentence = sentence(best, with_error(angle_error_deg, error_deg), is_lost);
    let answer = LayoutAnswer {
        rank: best.rank,
        words: words(best),
        units: best.units,
        film_count: best.film_count,
        angle_error_deg,
        error_deg,
        tied_with,
        verdict: judged.verdict,
        reason,
    };
    Some((answer, sentence))
}

/// Returns where a layout stands: the best is the greatest, so that what a key may be off down is off up here.
fn standing(layout: &RankedLayout) -> Standing {
    let key = order_key(layout);
    Standing {
        value: -key.value,
        off: key.off.map(|[down, up]| [up, down]),
    }
}

fn sentence(best: &RankedLayout, error: String, is_lost: bool) -> String {
    let worst = match best.loads.len() {
        0 | 1 => "",
        _ => " at the worst load",
    };
    if is_lost {
        return format!(
            "No layout that was asked for keeps the contact; the best is {}: in 95 of 100 contacts it knows the contact angle to {error} degrees{worst}.",
            words(best)
        );
    }
    format!(
        "{}: in 95 of 100 contacts they know the contact angle to {error} degrees{worst}.",
        instruction(best)
    )
}

/// Says what a layout that loses the contact is worth.
fn lost(best: &RankedLayout) -> String {
    let share = best.score.lost_share;
    let lost = share.map_or("more than 5".to_owned(), |s| format!("{:.0}", 100.0 * s));
    format!(
        "Even the best layout is off by more than {LOST_DEG:.0} degrees in {lost} of 100 contacts: which one loses least says little."
    )
}

/// Says why the first rank is as sure as it is.
fn reason(
    judged: &Judged,
    best: &RankedLayout,
    others: &[&RankedLayout],
    tied_with: &[usize],
) -> String {
    let Some(closest) = judged.closest.map(|k| others[k]) else {
        return match judged.verdict {
            Certainty::Unknown => "The error of the only layout isn't known.".to_owned(),
            _ => "It is the only layout that was asked for.".to_owned(),
        };
    };
    let by = "by the angle's error times the root of the number of films, which the order goes by";
    let figure = |layout: &RankedLayout| {
        let key = order_key(layout);
        // The side that counts: the first may be worse, the other better.
        let side = usize::from(layout.rank == best.rank);
        with_error(key.value, key.off.map(|off| off[side]))
    };
    let figures = format!(
        "{by}, it has {} and rank {}, {}, {}",
        figure(best),
        closest.rank,
        words(closest),
        figure(closest)
    );
    match judged.verdict {
        Certainty::Certain => format!("No other comes near: {figures}."),
        Certainty::Likely => {
            format!("The next is farther off than either error, and not than both: {figures}.")
        }
        Certainty::Tied => format!("{} can't be told from it: {figures}.", ranks(tied_with)),
        Certainty::Unknown => format!("How far off these figures are isn't known: {figures}."),
    }
}

/// `Rank 2`, `Ranks 2 and 3`, `Ranks 2, 3, 4 and 9 more`.
fn ranks(ranks: &[usize]) -> String {
    let named = ranks.iter().take(NAMED).map(usize::to_string);
    let mut names: Vec<String> = named.collect();
    let more = ranks.len().saturating_sub(NAMED);
    if more > 0 {
        names.push(format!("{more} more"));
    }
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let noun = if ranks.len() == 1 { "Rank" } else { "Ranks" };
    format!("{noun} {}", listed(&names))
}

/// Says what tells forces along and across from the angle, where they are unknown, too.
fn shear(best: &RankedLayout, layouts: &[RankedLayout]) -> Option<String> {
    let shear = best.score.shear.as_ref()?;
    let bound = |bound: Option<f64>| {
        bound.map_or("unknown".to_owned(), |degrees| {
            format!("{degrees:.1} degrees")
        })
    };
    let rise = format!(
        "With the forces along and across unknown, too, the bound of its angle goes from {} to {}",
        bound(best.score.worst_angle_error_deg),
        bound(shear.worst_angle_error_deg)
    );
    let Some(untold) = &shear.reason else {
        return Some(format!("{rise}, and it tells all three forces."));
    };
    let tells = |layout: &&RankedLayout| {
        let shear = layout.score.shear.as_ref();
        shear.is_some_and(|shear| shear.reason.is_none())
    };
    let teller = match layouts.iter().find(tells) {
        Some(teller) => format!(
            "the first that tells them is rank {}, {}",
            teller.rank,
            words(teller)
        ),
        None => "no layout that was asked for tells them".to_owned(),
    };
    Some(format!("{rise}, and {untold}; {teller}."))
}

#[cfg(test)]
mod tests {
    use super::*;
    use layouts::ranking::layout_order::rank;
    use results::{LayoutError, LayoutScore, LoadScore, ShearScore};

    /// Makes a layout of so many films of x and y at the crown that know the angle to this, degrees.
    fn layout(film_count: usize, p95: f64, error: Option<f64>) -> RankedLayout {
        let units = film_count / 2;
        let score = LayoutScore {
            simulated_p95_angle_error_deg: Some(p95),
            lost_share: Some(0.36),
            error: error.map(|error| LayoutError {
                simulated_p95_angle_error_deg: Some(error),
                ..LayoutError::default()
            }),
            ..LayoutScore::default()
        };
        let load = LoadScore {
            depth_mm: None,
            load_n: None,
            score: score.clone(),
        };
        RankedLayout {
            spacing_deg: Some(360.0 / units as f64),
            units,
            position: "crown".to_owned(),
            films: vec!["x".to_owned(), "y".to_owned()],
            film_count,
            loads: vec![load.clone(), load],
            score,
            ..RankedLayout::default()
        }
    }

    fn answered(mut layouts: Vec<RankedLayout>) -> (LayoutAnswer, String) {
        rank(&mut layouts);
        best_layout(&layouts).expect("a best layout")
    }

    #[test]
    fn verdicts_go_by_what_the_order_goes_by() {
        // 8, and what the next has by its error times the root of its films.
        let with = |other| answered(vec![layout(16, 2.0, Some(0.1)), other]).0;
        let certain = with(layout(4, 5.0, Some(0.2)));
        assert_eq!(certain.verdict, Certainty::Certain);
        assert_eq!(
            certain.reason,
            "No other comes near: by the angle's error times the root of the number of films, which the order goes by, it has 8.00 +- 0.40 \
             and rank 2, 2 units of x and y at the crown, every 180 degrees, 10.00 +- 0.40."
        );
        let likely = answered(vec![
            layout(16, 2.0, Some(0.5)),
            layout(16, 2.55, Some(0.5)),
        ])
        .0;
        assert_eq!(
            (likely.verdict, likely.tied_with),
            (Certainty::Likely, vec![])
        );
        let tied = with(layout(4, 5.0, Some(1.4)));
        assert_eq!((tied.verdict, tied.tied_with), (Certainty::Tied, vec![2]));
        assert!(tied.reason.starts_with("Rank 2 can't be told from it: "));
        let unknown = answered(vec![layout(16, 2.0, None), layout(4, 5.0, None)]).0;
        assert_eq!(
            (unknown.verdict, unknown.error_deg),
            (Certainty::Unknown, None)
        );
    }

    #[test]
    fn an_error_that_may_lose_the_contact_counts_as_lost() {
        let other = || layout(40, 19.5, Some(0.3));
        let sure = answered(vec![layout(24, 16.0, Some(3.0)), other()]).0;
        assert_eq!(sure.verdict, Certainty::Certain);
        // 19 +- 3 degrees may be more than the 20 from which on a layout comes last.
        let tied = answered(vec![layout(24, 19.0, Some(3.0)), other()]).0;
        assert_eq!((tied.verdict, tied.tied_with), (Certainty::Tied, vec![2]));
    }

    #[test]
    fn layouts_that_lose_the_contact_are_no_answer() {
        let (answer, sentence) = answered(vec![
            layout(24, 30.0, Some(0.1)),
            layout(24, 60.0, Some(0.1)),
        ]);
        assert_eq!(answer.verdict, Certainty::Unknown);
        assert!(
            sentence.starts_with(
                "No layout that was asked for keeps the contact; the best is 12 units"
            )
        );
        assert!(
            answer.reason.contains("in 36 of 100 contacts"),
            "{}",
            answer.reason
        );
    }

    #[test]
    fn equal_scores_share_the_first_rank_and_tie_nobody() {
        let equal = || layout(16, 2.0, Some(0.1));
        let (answer, sentence) = answered(vec![equal(), equal(), layout(16, 4.0, Some(0.1))]);
        assert_eq!(
            (answer.verdict, answer.tied_with),
            (Certainty::Certain, vec![])
        );
        assert_eq!(
            sentence,
            "Glue films of x and y at the crown, 8 units every 45 degrees: in 95 of 100 contacts they know the contact angle to \
             2.00 +- 0.10 degrees at the worst load."
        );
        assert!(answered(vec![equal()]).0.reason.contains("only layout"));
        assert!(best_layout(&[RankedLayout::default()]).is_none());
    }

    #[test]
    fn what_tells_shear_from_the_angle_is_said() {
        let sheared = |p95: f64, reason: Option<&str>| {
            let mut layout = layout(16, p95, Some(0.1));
            layout.score.worst_angle_error_deg = Some(1.0);
            layout.score.shear = Some(ShearScore {
                worst_angle_error_deg: Some(3.0),
                reason: reason.map(str::to_owned),
                ..ShearScore::default()
            });
            layout
        };
        let untold = "no film feels the force across";
        let told = answered(vec![sheared(2.0, Some(untold)), sheared(4.0, None)]).0;
        assert!(
            told.reason.ends_with(
                "goes from 1.0 degrees to 3.0 degrees, and no film feels the force across; the first that tells them is rank 2, 8 units of x \
                 and y at the crown, every 45 degrees."
            ),
            "{}",
            told.reason
        );
        let itself = answered(vec![sheared(2.0, None)]).0;
        assert!(itself.reason.ends_with("and it tells all three forces."));
        let nobody = answered(vec![sheared(2.0, Some(untold))]).0;
        assert!(
            nobody
                .reason
                .ends_with("no layout that was asked for tells them.")
        );
    }
}
