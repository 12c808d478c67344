//! The layouts that could answer in the place of the picked one: how sure it is against them, and why.

use crate::answer::first_rank::{Judged, Standing, judge};
use crate::answer::layout_figures::{Figure, Figures};
use crate::answer::layout_words::words;
use crate::score::notes::listed;
use results::{Certainty, RankedLayout, TradeAnswer};

/// Layouts that a sentence names.
const NAMED: usize = 3;
/// Figures nearer than this are equal, relative: those of mirror images differ by rounding.
const EQUAL: f64 = 1e-9;

/// The picked layout beside those that could answer in its place.
pub(super) struct Rivals<'l, 't> {
    picked: &'l RankedLayout,
    trade: &'t TradeAnswer,
    /// Layouts with as few films, without mirror images of the picked one, best first; where limits are asked, those with fewer films.
    others: Vec<&'l RankedLayout>,
}

impl<'l, 't> Rivals<'l, 't> {
    pub fn of(
        picked: &'l RankedLayout,
        layouts: &'l [RankedLayout],
        trade: &'t TradeAnswer,
    ) -> Self {
        let question = &trade.question;
        let own = Figures::of(picked)
            .compared(question)
            .map_or(f64::INFINITY, |figure| figure.value);
        let is_rival = |layout: &&RankedLayout| {
            let Some(figure) = Figures::of(layout).compared(question) else {
                return false;
            };
            match question.has_limits() && trade.picked.is_some() {
                true => layout.film_count < picked.film_count,
                false => {
                    let most = match trade.picked {
                        Some(_) => picked.film_count.max(trade.most_films.unwrap_or(0)),
                        None => trade.most_films.unwrap_or(usize::MAX),
                    };
                    let is_image = (figure.value - own).abs() <= EQUAL * own;
                    layout.film_count <= most && !is_image
                }
            }
        };
        let mut others: Vec<&RankedLayout> = layouts.iter().filter(is_rival).collect();
        let value = |layout: &RankedLayout| {
            Figures::of(layout)
                .compared(question)
                .map_or(f64::INFINITY, |figure| figure.value)
        };
        others.sort_by(|a, b| value(a).total_cmp(&value(b)));
        Self {
            picked,
            trade,
            others,
        }
    }

    /// The best of the others.
    pub fn best(&self, most: usize) -> Vec<&'l RankedLayout> {
        self.others.iter().take(most).copied().collect()
    }

    /// Whether limits decide: the picked one meets them, and others don't.
    fn by_limits(&self) -> bool {
        self.trade.question.has_limits()
    }

    fn standing(&self, layout: &RankedLayout) -> Standing {
        let figure = Figures::of(layout)
            .compared(&self.trade.question)
            .unwrap_or(Figure {
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
    pub fn judged(&self) -> Judged {
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
    pub(super) fn tied(&self, judged: &Judged) -> Vec<usize> {
        if self.trade.picked.is_none() {
            return Vec::new();
        }
        let mut ranks: Vec<usize> = judged.tied.iter().map(|&k| self.others[k].rank).collect();
        ranks.sort_unstable();
        ranks.dedup();
        ranks
    }

    /// Says why the answer is as sure as it is, and of what.
    pub fn reason(&self, judged: &Judged) -> String {
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
            .max(self.trade.most_films.unwrap_or(0));
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
            Certainty::Certain => format!("{among} no other is as good: {figures}."),
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
        Figures::of(layout).words(&self.trade.question)
    }
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
