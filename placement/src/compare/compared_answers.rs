//! Answers side by side: which tire tells most, with which layout.
//!
//! Studies that ask a question are compared by its figure: the fewest films within the limits, or the least error with so many films. Without a question each has as
//! many films as the baseline's knee, so that more films don't pass for a better tire.

use std::cmp::Ordering;

use documents::study::question::Question;
use serde::{Deserialize, Serialize};

use super::comparable::{AnswerPart, Comparable};
use super::difference_verdict::Verdict;
use crate::answer::{Figure, Figures, Standing, judge};
use results::{Certainty, TradeRow};

/// The study that answers best.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ComparisonAnswer {
    /// The study that answers best with its layout, and the next, in a sentence.
    pub sentence: String,
    /// Certainty that no other study answers better.
    pub verdict: Certainty,
}

/// Layout by which a study is compared.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ComparedAnswer {
    /// Place among the studies, 1 is best.
    pub rank: usize,
    /// Rank of the layout in its study's `layouts`.
    pub layout_rank: usize,
    /// Description of the layout, as in `12 films along y at the crown, one every 30 degrees`.
    pub words: String,
    /// All its films.
    pub film_count: usize,
    /// Whether it keeps to the limits that the document asks for; null where it asks for none.
    pub meets: Option<bool>,
    /// Certainty of the layout within its study.
    pub verdict: Certainty,
    /// Error of the contact angle in 95 of 100 contacts at the worst load, degrees.
    pub angle_deg: ComparedFigure,
    /// Root mean square error of the vertical force at the worst load, N; null where the study doesn't estimate it.
    pub force_n: Option<ComparedFigure>,
    /// Best layout of each number of films.
    pub trade: Vec<TradeRow>,
}

/// Figure of a layout beside the baseline's.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ComparedFigure {
    /// The figure.
    pub value: f64,
    /// Claimed error of the figure; null where there is no coarser mesh.
    pub error: Option<f64>,
    /// The figure minus the baseline's; null in the baseline.
    pub difference: Option<f64>,
    /// Error of the difference; null where one of both isn't known.
    pub difference_error: Option<f64>,
    /// Whether the difference is beyond its error.
    pub verdict: Option<Verdict>,
}

impl ComparedFigure {
    fn of(value: f64, error: Option<f64>, base: Option<(f64, Option<f64>)>) -> Self {
        let difference = base.map(|(other, _)| value - other);
        // Claims of two tires have nothing in common that is known.
        let both = base.and_then(|(_, other)| Some(error?.hypot(other?)));
        Self {
            value,
            error,
            difference,
            difference_error: both,
            verdict: difference.map(|difference| Verdict::of(difference, both)),
        }
    }
}

/// A study's answer, which is compared by one of its layouts.
struct Candidate<'a> {
    number: usize,
    answer: &'a AnswerPart,
    row: &'a TradeRow,
    rows: &'a [TradeRow],
}

/// Figure that all studies are compared by.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Yardstick {
    question: Question,
    /// Films of the baseline's knee, where nothing is asked.
    films: Option<usize>,
}

impl Yardstick {
    fn row<'a>(&self, answer: &'a AnswerPart) -> Option<&'a TradeRow> {
        let trade = answer.trade.as_ref()?;
        if let Some(most) = self.films {
            let few = trade.rows.iter().filter(|row| row.film_count <= most);
            return few.min_by(|a, b| a.angle_error_deg.total_cmp(&b.angle_error_deg));
        }
        let rank = answer.layout.as_ref()?.rank;
        trade.rows.iter().find(|row| row.rank == rank)
    }

    /// The largest error over its limit, or the angle's error where errors have no limits.
    fn figure(&self, row: &TradeRow) -> Figure {
        let compared = Figures::of_row(row).compared(&self.question);
        compared.unwrap_or(Figure {
            value: row.angle_error_deg,
            claim: row.angle_claim_deg,
        })
    }

    /// Films that decide before errors do: those within the limits.
    fn films(&self, row: &TradeRow) -> usize {
        match row.meets {
            Some(true) => row.film_count,
            Some(false) => usize::MAX,
            None => 0,
        }
    }

    fn order(&self, a: &TradeRow, b: &TradeRow) -> Ordering {
        let errors = self.figure(a).value.total_cmp(&self.figure(b).value);
        self.films(a).cmp(&self.films(b)).then(errors)
    }

    fn figures(&self, row: &TradeRow) -> String {
        Figures::of_row(row).words(&self.question)
    }
}

/// Answers of studies, in their order; `None` of those whose layouts have no score.
pub(super) struct Answers {
    pub of_studies: Vec<Option<ComparedAnswer>>,
    pub best: Option<ComparisonAnswer>,
    /// Whether the studies ask different questions.
    pub questions_differ: bool,
}

/// Compares the answers of studies of these names with one of them.
pub(super) fn answers(
    results: &[Option<&Comparable>],
    names: &[&str],
    base: Option<usize>,
) -> Answers {
    let answer = |number: usize| results[number].and_then(|result| result.answer.as_ref());
    let questions: Vec<Question> = (0..results.len())
        .filter_map(|number| Some(answer(number)?.trade.as_ref()?.question))
        .collect();
    let questions_differ = questions.windows(2).any(|pair| pair[0] != pair[1]);
    let asked = questions.first().filter(|_| !questions_differ);
    let question = asked.copied().unwrap_or_default();
    let of_base = base.and_then(answer);
    let knee = of_base.and_then(|answer| Some(answer.layout.as_ref()?.film_count));
    let by = Yardstick {
        question,
        films: knee.filter(|_| question.is_empty()),
    };
    let candidates = (0..results.len()).filter_map(|number| {
        let answer = answer(number)?;
        let rows = answer.trade.as_ref()?.rows.as_slice();
        let row = by.row(answer)?;
        Some(Candidate {
            number,
            answer,
            row,
            rows,
        })
    });
    let mut ranked: Vec<Candidate<'_>> = candidates.collect();
    ranked.sort_by(|a, b| by.order(a.row, b.row));
    let base_row = of_base.and_then(|answer| by.row(answer));
    let mut of_studies = vec![None; results.len()];
    for (place, candidate) in ranked.iter().enumerate() {
        let other = base_row.filter(|_| base != Some(candidate.number));
        of_studies[candidate.number] = compared(place + 1, candidate, other);
    }
    Answers {
        of_studies,
        best: best(&ranked, names, &by),
        questions_differ,
    }
}

fn compared(
    rank: usize,
    candidate: &Candidate<'_>,
    base: Option<&TradeRow>,
) -> Option<ComparedAnswer> {
    let row = candidate.row;
    let angle_of_base = base.map(|base| (base.angle_error_deg, base.angle_claim_deg));
    let force_of_base = base.and_then(|base| Some((base.force_error_n?, base.force_claim_n)));
    let force = row.force_error_n;
    Some(ComparedAnswer {
        rank,
        layout_rank: row.rank,
        words: row.words.clone(),
        film_count: row.film_count,
        meets: row.meets,
        verdict: candidate.answer.layout.as_ref()?.verdict,
        angle_deg: ComparedFigure::of(row.angle_error_deg, row.angle_claim_deg, angle_of_base),
        force_n: force.map(|force| ComparedFigure::of(force, row.force_claim_n, force_of_base)),
        trade: candidate.rows.to_vec(),
    })
}

/// The first of two or more, and how sure that is.
fn best(ranked: &[Candidate<'_>], names: &[&str], by: &Yardstick) -> Option<ComparisonAnswer> {
    let (first, others) = ranked
        .split_first()
        .filter(|(_, others)| !others.is_empty())?;
    let standing = |candidate: &Candidate<'_>| {
        let figure = by.figure(candidate.row);
        Standing {
            // What is best is greatest.
            value: -figure.value,
            off: figure.claim.map(|claim| [claim; 2]),
        }
    };
    let alike = |other: &&Candidate<'_>| by.films(other.row) == by.films(first.row);
    let equal: Vec<&Candidate<'_>> = others.iter().filter(alike).collect();
    let judged = judge(
        &standing(first),
        &equal
            .iter()
            .map(|other| standing(other))
            .collect::<Vec<_>>(),
    );
    let next = judged.closest.map_or(&others[0], |closest| equal[closest]);
    // The numbers of films that limits need are as sure as the layouts are.
    let by_films = others.iter().filter(|other| !alike(other));
    let by_films = by_films.map(|other| layout_verdict(other).max(layout_verdict(first)));
    let verdict = by_films.fold(judged.verdict, Certainty::max);
    let name = |candidate: &Candidate<'_>| names[candidate.number];
    let told = |candidate: &Candidate<'_>| {
        let figures = by.figures(candidate.row);
        format!("{}: {}, {figures}", name(candidate), candidate.row.words)
    };
    let layout = format!("{}, {}", first.row.words, by.figures(first.row));
    let leader = name(first);
    let lead = match (first.row.meets, by.films) {
        (Some(true), _) => format!("{leader} needs the fewest films: {layout}."),
        (Some(false), _) => format!("None keeps to the limits; {leader} comes closest: {layout}."),
        (None, Some(most)) => {
            format!("With up to {most} films {leader} tells the angle best: {layout}.")
        }
        (None, None) => format!("{leader} tells the angle best: {layout}."),
    };
    let beside = match verdict {
        Certainty::Certain | Certainty::Likely => "Next",
        Certainty::Tied => "It can't be told from",
        Certainty::Unknown => "How far off that is isn't known; next",
    };
    Some(ComparisonAnswer {
        sentence: format!("{lead} {beside} {}.", told(next)),
        verdict,
    })
}

fn layout_verdict(candidate: &Candidate<'_>) -> Certainty {
    let layout = candidate.answer.layout.as_ref();
    layout.map_or(Certainty::Unknown, |layout| layout.verdict)
}

#[cfg(test)]
mod tests {
    use results::StudyResult;
    use serde_json::{Value, json};

    use super::*;

    /// A study with best layouts of these films, angle errors and claims, of which the numbered one is its answer.
    fn result(
        rows: &[(usize, f64, f64)],
        picked: usize,
        question: &Value,
    ) -> Result<Comparable, serde_json::Error> {
        let limit = question["angle_deg"].as_f64();
        let row = |(index, &(films, angle, claim)): (usize, &(usize, f64, f64))| {
            json!({"film_count": films, "rank": index + 1, "index": index, "words": format!("{films} films along y"), "angle_error_deg": angle,
                   "angle_claim_deg": claim, "force_error_n": null, "force_claim_n": null, "meets": limit.map(|most| angle <= most), "is_front": true})
        };
        let rows: Vec<Value> = rows.iter().enumerate().map(row).collect();
        let answer = json!({"sentence": "", "verdict": "certain", "reason": "", "place": null, "left_out": null, "surer": null,
            "layout": {"rank": picked + 1, "words": "", "units": 1, "film_count": rows[picked]["film_count"], "angle_error_deg": 1.0, "error_deg": null,
                       "tied_with": [], "verdict": "certain", "reason": ""},
            "trade": {"question": question, "rows": rows, "picked": picked, "knee": null, "tried": 9, "screened": 0, "without_room": 0, "menu": ""}});
        Ok(Comparable::of(&StudyResult {
            answer: Some(serde_json::from_value(answer)?),
            ..StudyResult::default()
        }))
    }

    fn ranks(answers: &Answers) -> Vec<usize> {
        let found = answers.of_studies.iter().flatten();
        found.map(|answer| answer.rank).collect()
    }

    #[test]
    fn without_a_question_all_have_as_many_films_as_the_baseline() -> Result<(), serde_json::Error>
    {
        let thin = result(&[(12, 8.0, 0.5), (24, 2.0, 0.2)], 1, &json!({}))?;
        // Its own knee has more films, which would pass for a better tire.
        let thick = result(&[(24, 3.0, 0.2), (48, 0.5, 0.1)], 1, &json!({}))?;
        let both = [Some(&thin), Some(&thick)];
        let found = answers(&both, &["thin", "thick"], Some(0));
        assert_eq!(ranks(&found), [1, 2]);
        let best = found.best.expect("two answers");
        assert_eq!(
            (best.sentence.as_str(), best.verdict),
            (
                "With up to 24 films thin tells the angle best: 24 films along y, 2.00 +- 0.20 degrees. Next thick: 24 films along y, 3.00 +- 0.20 degrees.",
                Certainty::Certain
            )
        );
        let other = found.of_studies[1].as_ref().expect("an answer");
        assert_eq!(other.angle_deg.difference, Some(1.0));
        assert_eq!(other.angle_deg.difference_error, Some(0.2_f64.hypot(0.2)));
        assert_eq!(other.angle_deg.verdict, Some(Verdict::Real));
        let own = found.of_studies[0].as_ref().expect("an answer");
        assert_eq!(own.angle_deg.difference, None);
        let wider = answers(&both, &["thin", "thick"], Some(1));
        assert_eq!(ranks(&wider), [2, 1]);
        Ok(())
    }

    #[test]
    fn limits_are_answered_by_the_fewest_films() -> Result<(), serde_json::Error> {
        let asked = json!({"angle_deg": 5.0});
        let few = result(&[(12, 4.9, 0.2), (24, 2.0, 0.2)], 0, &asked)?;
        let many = result(&[(12, 9.0, 0.2), (24, 1.0, 0.1)], 1, &asked)?;
        let none = result(&[(12, 9.0, 0.2)], 0, &asked)?;
        let found = answers(
            &[Some(&none), Some(&many), None, Some(&few)],
            &["none", "many", "lost", "few"],
            Some(0),
        );
        assert_eq!(ranks(&found), [3, 2, 1]);
        assert!(found.of_studies[2].is_none());
        let best = found.best.expect("answers");
        assert!(
            best.sentence
                .starts_with("few needs the fewest films: 12 films along y, 4.90 +- 0.20"),
            "{}",
            best.sentence
        );
        assert_eq!(best.verdict, Certainty::Certain);
        Ok(())
    }

    #[test]
    fn equal_tires_are_tied_and_different_questions_are_noted() -> Result<(), serde_json::Error> {
        let one = result(&[(24, 2.0, 0.2)], 0, &json!({"films": 24}))?;
        let same = result(&[(24, 2.1, 0.2)], 0, &json!({"films": 24}))?;
        let found = answers(&[Some(&one), Some(&same)], &["one", "same"], Some(0));
        let best = found.best.expect("two answers");
        assert_eq!(best.verdict, Certainty::Tied);
        assert!(best.sentence.contains("It can't be told from same"));
        assert!(!found.questions_differ);
        let other = result(&[(12, 4.0, 0.2)], 0, &json!({"films": 12}))?;
        let found = answers(&[Some(&one), Some(&other)], &["one", "other"], Some(0));
        assert!(found.questions_differ);
        assert_eq!(ranks(&found), [1, 2]);
        Ok(())
    }
}
