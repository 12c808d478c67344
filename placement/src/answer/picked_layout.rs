//! The layout that answers, how sure that is, and why.

use super::first_rank::{Judged, Standing, judge};
use super::layout_figures::{Figure, angle, compared};
use super::layout_words::words;
use super::trade_words::sentence;
use crate::score::notes::listed;
use layouts::simulate::simulation::LOST_DEG;
use results::{Certainty, LayoutAnswer, RankedLayout, TradeAnswer};

/// Layouts that a sentence names.
const NAMED: usize = 3;
/// Figures nearer than this are equal, relative: those of mirror images differ by rounding.
const EQUAL: f64 = 1e-9;

/// The layout that a trade picks, with its sentence; where it picks none, the one that comes closest.
pub(super) fn picked_layout(
    trade: &TradeAnswer,
    layouts: &[RankedLayout],
) -> Option<(LayoutAnswer, String)> {
    let question = &trade.question;
    let value = |layout: &RankedLayout| compared(layout, question).map(|figure| figure.value);
    let few = |layout: &&RankedLayout| question.films.is_none_or(|most| layout.film_count <= most);
    let closest = || {
        let scored = layouts
            .iter()
            .filter(few)
            .filter(|layout| value(layout).is_some());
        scored.min_by(|a, b| {
            value(a)
                .unwrap_or(f64::MAX)
                .total_cmp(&value(b).unwrap_or(f64::MAX))
        })
    };
    let picked = match trade.picked {
        Some(row) => &layouts[trade.rows[row].index],
        None => closest().or_else(|| layouts.first())?,
    };
    let found = angle(picked)?;
    let is_lost = found.value > LOST_DEG;
    let rivals = Rivals::of(picked, layouts, trade);
    let judged = rivals.judged();
    let mut reason = match is_lost {
        true => lost(picked),
        false => rivals.reason(&judged),
    };
    reason.extend(shear(picked, layouts).iter().flat_map(|told| [" ", told]));
    let answer = LayoutAnswer {
        rank: picked.rank,
        words: words(picked),
        units: picked.units,
        film_count: picked.film_count,
        angle_error_deg: found.value,
        error_deg: found.claim,
        tied_with: rivals.tied(&judged),
        verdict: match is_lost {
            true => Certainty::Unknown,
            false => judged.verdict,
        },
        reason,
    };
    Some((answer, sentence(trade, picked)))
}

/// The picked layout beside those that could answer in its place.
struct Rivals<'a> {
    picked: &'a RankedLayout,
    trade: &'a TradeAnswer,
    /// Layouts with as few films, without mirror images of the picked one, best first; where limits are asked, those with fewer films.
    others: Vec<&'a RankedLayout>,
}

impl<'a> Rivals<'a> {
    fn of(picked: &'a RankedLayout, layouts: &'a [RankedLayout], trade: &'a TradeAnswer) -> Self {
        let question = &trade.question;
        let own = compared(picked, question).map_or(f64::INFINITY, |figure| figure.value);
        let is_rival = |layout: &&RankedLayout| {
            let Some(figure) = compared(layout, question) else {
                return false;
            };
            match question.has_limits() && trade.picked.is_some() {
                true => layout.film_count < picked.film_count,
                false => {
                    let most = match trade.picked {
                        Some(_) => picked.film_count.max(question.films.unwrap_or(0)),
                        None => question.films.unwrap_or(usize::MAX),
                    };
                    let is_image = (figure.value - own).abs() <= EQUAL * own;
                    layout.film_count <= most && !is_image
                }
            }
        };
        let mut others: Vec<&RankedLayout> = layouts.iter().filter(is_rival).collect();
        let value = |layout: &RankedLayout| {
            compared(layout, question).map_or(f64::INFINITY, |figure| figure.value)
        };
        others.sort_by(|a, b| value(a).total_cmp(&value(b)));
        Self {
            picked,
            trade,
            others,
        }
    }

    /// Whether limits decide: the picked one meets them, and others don't.
    fn by_limits(&self) -> bool {
        self.trade.question.has_limits()
    }

    fn standing(&self, layout: &RankedLayout) -> Standing {
        let figure = compared(layout, &self.trade.question).unwrap_or(Figure {
            value: f64::INFINITY,
            claim: None,
        });
        Standing {
            // What is best is greatest.
            value: -figure.value,
            off: figure.claim.map(|claim| [claim; 2]),
        }
    }

    /// Judges the picked one against the others; where limits are asked, it against them, and them against the others.
    fn judged(&self) -> Judged {
        let others: Vec<Standing> = self
            .others
            .iter()
            .map(|other| self.standing(other))
            .collect();
        let own = self.standing(self.picked);
        if !self.by_limits() {
            return judge(&own, &others);
        }
        let limit = Standing {
            value: -1.0,
            off: Some([0.0; 2]),
        };
        match self.trade.picked {
            Some(_) => {
                let meets = judge(&own, &[limit]).verdict;
                let mut fewer = judge(&limit, &others);
                fewer.verdict = fewer.verdict.max(meets);
                fewer
            }
            None => judge(&limit, &[own]),
        }
    }

    /// Ranks of those that can't be told from the picked one.
    fn tied(&self, judged: &Judged) -> Vec<usize> {
        if self.trade.picked.is_none() {
            return Vec::new();
        }
        let mut ranks: Vec<usize> = judged.tied.iter().map(|&k| self.others[k].rank).collect();
        ranks.sort_unstable();
        ranks.dedup();
        ranks
    }

    /// Says why the answer is as sure as it is, and of what.
    fn reason(&self, judged: &Judged) -> String {
        match (self.by_limits(), self.trade.picked) {
            (true, Some(_)) => self.reason_of_limits(judged),
            (true, None) => format!(
                "The layout that comes closest has {}.",
                self.figures(self.picked)
            ),
            (false, _) => self.reason_of_best(judged),
        }
    }

    fn reason_of_best(&self, judged: &Judged) -> String {
        let most = self
            .picked
            .film_count
            .max(self.trade.question.films.unwrap_or(0));
        let among = format!("Of the layouts tried with up to {most} films");
        let Some(closest) = judged.closest.map(|k| self.others[k]) else {
            return match judged.verdict {
                Certainty::Unknown => {
                    format!("{among} it is the only one, and its error isn't known.")
                }
                _ => format!("{among} it is the only one."),
            };
        };
        let figures = format!(
            "it has {}, and {} {}",
            self.figures(self.picked),
            words(closest),
            self.figures(closest)
        );
        match judged.verdict {
            Certainty::Certain => format!("{among} no other comes near: {figures}."),
            Certainty::Likely => format!(
                "{among} the next is farther off than either error, and not than both: {figures}."
            ),
            Certainty::Tied => {
                let tied = named(&self.tied(judged));
                format!("{among} {tied} can't be told from it: {figures}.")
            }
            Certainty::Unknown => {
                format!(
                    "{among} it is first, and how far off the figures are isn't known: {figures}."
                )
            }
        }
    }

    fn reason_of_limits(&self, judged: &Judged) -> String {
        let own = format!("It has {}", self.figures(self.picked));
        let fewer = match judged.closest.map(|k| self.others[k]) {
            None => "nothing with fewer films was tried".to_owned(),
            Some(closest) => format!(
                "of fewer films {} come closest with {}",
                words(closest),
                self.figures(closest)
            ),
        };
        match judged.verdict {
            Certainty::Certain => format!("{own}; {fewer}."),
            Certainty::Likely => {
                format!("{own}; {fewer}: the errors make another number of films unlikely.")
            }
            Certainty::Tied => format!(
                "{own}; {fewer}: within the errors it may need more films, or fewer may do."
            ),
            Certainty::Unknown => {
                format!("{own}; {fewer}: how far off these figures are isn't known.")
            }
        }
    }

    /// The figures that are asked for: `10.7 +- 1.8 degrees`, `0.81 +- 0.05 N`, or both.
    fn figures(&self, layout: &RankedLayout) -> String {
        super::trade_words::figures(layout, &self.trade.question)
    }
}

/// Says what a layout that loses the contact is worth.
fn lost(best: &RankedLayout) -> String {
    let share = best.score.lost_share;
    let lost = share.map_or("more than 5".to_owned(), |s| format!("{:.0}", 100.0 * s));
    format!(
        "It is off by more than {LOST_DEG:.0} degrees in {lost} of 100 contacts: which layout loses least says little."
    )
}

/// `rank 2`, `ranks 2 and 3`, `ranks 2, 3, 4 and 9 more`.
fn named(ranks: &[usize]) -> String {
    let first = ranks.iter().take(NAMED).map(usize::to_string);
    let mut names: Vec<String> = first.collect();
    let more = ranks.len().saturating_sub(NAMED);
    if more > 0 {
        names.push(format!("{more} more"));
    }
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let noun = if ranks.len() == 1 { "rank" } else { "ranks" };
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
    use crate::answer::film_trade::trade;
    use documents::study::question::Question;
    use layouts::ranking::layout_order::rank;
    use results::{LayoutError, LayoutScore, LoadScore, ShearScore};

    /// Makes a layout of so many films of x and y at the crown that know the angle to this, degrees.
    fn layout(film_count: usize, p95: f64, error: Option<f64>) -> RankedLayout {
        let units = film_count / 2;
        let score = LayoutScore {
            simulated_p95_angle_error_deg: Some(p95),
            force_error_n: Some(0.1 * p95),
            lost_share: Some(0.36),
            error: error.map(|error| LayoutError {
                simulated_p95_angle_error_deg: Some(error),
                force_error_n: Some(0.1 * error),
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

    fn asked(question: Question, mut layouts: Vec<RankedLayout>) -> (LayoutAnswer, String) {
        rank(&mut layouts);
        let trade = trade(&layouts, None, question).expect("a trade");
        picked_layout(&trade, &layouts).expect("a layout")
    }

    fn of_films(films: usize, layouts: Vec<RankedLayout>) -> (LayoutAnswer, String) {
        let question = Question {
            films: Some(films),
            ..Question::default()
        };
        asked(question, layouts)
    }

    fn within(angle_deg: f64, layouts: Vec<RankedLayout>) -> (LayoutAnswer, String) {
        let question = Question {
            angle_deg: Some(angle_deg),
            ..Question::default()
        };
        asked(question, layouts)
    }

    #[test]
    fn the_best_of_as_many_films_is_judged_by_the_others() {
        let with = |p95, error| {
            let layouts = vec![
                layout(8, 2.0, Some(0.1)),
                layout(8, p95, error),
                layout(16, 1.0, Some(0.1)),
            ];
            of_films(8, layouts)
        };
        let (certain, sentence) = with(4.0, Some(0.2));
        assert_eq!(
            (certain.verdict, certain.film_count),
            (Certainty::Certain, 8)
        );
        assert_eq!(
            certain.reason,
            "Of the layouts tried with up to 8 films no other comes near: it has 2.00 +- 0.10 degrees, and 8 films along x and y at the \
             crown, a pair every 90 degrees 4.00 +- 0.20 degrees."
        );
        assert_eq!(
            sentence,
            "8 films: glue them along x and y at the crown, a pair every 90 degrees; they know the contact angle to 2.00 +- 0.10 degrees \
             in 95 of 100 contacts at the worst load. 16 films give 1.00 +- 0.10 degrees."
        );
        let likely = with(2.108, Some(0.1)).0;
        assert_eq!(
            (likely.verdict, likely.tied_with),
            (Certainty::Likely, vec![])
        );
        let (tied, _) = with(2.1, Some(0.2));
        assert_eq!(tied.verdict, Certainty::Tied);
        assert!(
            tied.reason.contains("rank 3 can't be told from it: "),
            "{}",
            tied.reason
        );
        assert_eq!(with(4.0, None).0.verdict, Certainty::Unknown);
        assert!(
            of_films(9, vec![layout(8, 2.0, Some(0.1))])
                .0
                .reason
                .contains("only one")
        );
        assert!(
            of_films(9, vec![layout(8, 2.0, Some(0.1))])
                .1
                .starts_with("Of up to 9 films 8 do best")
        );
    }

    #[test]
    fn limits_are_met_by_the_fewest_films() {
        let layouts = |error| {
            vec![
                layout(8, 8.0, Some(error)),
                layout(12, 4.0, Some(error)),
                layout(16, 2.0, Some(error)),
            ]
        };
        let (met, sentence) = within(5.0, layouts(0.2));
        assert_eq!((met.film_count, met.verdict), (12, Certainty::Certain));
        assert!(
            sentence.starts_with("5 degrees need 12 films: glue them"),
            "{sentence}"
        );
        assert!(
            sentence.ends_with("8 films give 8.00 +- 0.20 degrees, 16 films 2.00 +- 0.20 degrees."),
            "{sentence}"
        );
        // 4 +- 2 may be above 5, and 8 +- 2 isn't below.
        let doubtful = within(5.0, layouts(2.0)).0;
        assert_eq!(
            (doubtful.film_count, doubtful.verdict),
            (12, Certainty::Tied)
        );
        let (never, sentence) = within(1.0, layouts(0.2));
        assert_eq!((never.film_count, never.verdict), (16, Certainty::Certain));
        assert!(
            sentence.starts_with("No layout that was tried keeps to 1 degrees: 16 films"),
            "{sentence}"
        );
        let force = Question {
            force_n: Some(0.5),
            films: Some(14),
            ..Question::default()
        };
        assert_eq!(asked(force, layouts(0.2)).0.film_count, 12);
    }

    #[test]
    fn without_a_question_the_knee_answers() {
        // Films times error: 64, 48, 32, 33: from 16 films on twice as many don't halve it.
        let layouts = vec![
            layout(8, 8.0, Some(0.1)),
            layout(12, 4.0, Some(0.1)),
            layout(16, 2.0, Some(0.1)),
            layout(30, 1.1, Some(0.1)),
        ];
        let (knee, sentence) = asked(Question::default(), layouts);
        assert_eq!(knee.film_count, 16);
        assert!(
            sentence.starts_with("The knee is at 16 films: glue them"),
            "{sentence}"
        );
        assert!(
            sentence.contains(
                "From there on twice the films don't halve the error: 12 films give 4.00"
            ),
            "{sentence}"
        );
    }

    #[test]
    fn layouts_that_lose_the_contact_are_no_answer() {
        let lost = || vec![layout(24, 30.0, Some(0.1)), layout(24, 60.0, Some(0.1))];
        for (answer, sentence) in [asked(Question::default(), lost()), of_films(24, lost())] {
            assert_eq!(answer.verdict, Certainty::Unknown);
            assert!(
                sentence.starts_with(
                    "No layout that answers keeps the contact: 24 films along x and y"
                ),
                "{sentence}"
            );
            assert!(
                answer.reason.contains("in 36 of 100 contacts"),
                "{}",
                answer.reason
            );
        }
    }

    #[test]
    fn equal_scores_tie_nobody() {
        let equal = || layout(16, 2.0, Some(0.1));
        let answer = of_films(16, vec![equal(), equal(), layout(16, 4.0, Some(0.1))]).0;
        assert_eq!(
            (answer.verdict, answer.tied_with),
            (Certainty::Certain, vec![])
        );
        assert!(trade(&[RankedLayout::default()], None, Question::default()).is_none());
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
        let told = of_films(16, vec![sheared(2.0, Some(untold)), sheared(4.0, None)]).0;
        assert!(
            told.reason.ends_with(
                "goes from 1.0 degrees to 3.0 degrees, and no film feels the force across; the first that tells them is rank 2, 16 films \
                 along x and y at the crown, a pair every 45 degrees."
            ),
            "{}",
            told.reason
        );
        let itself = of_films(16, vec![sheared(2.0, None)]).0;
        assert!(itself.reason.ends_with("and it tells all three forces."));
        let nobody = of_films(16, vec![sheared(2.0, Some(untold))]).0;
        assert!(
            nobody
                .reason
                .ends_with("no layout that was asked for tells them.")
        );
    }
}
