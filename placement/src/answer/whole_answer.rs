//! The whole answer of a study: its sentence, the weaker verdict, and what could overturn it.

use super::assumption_words::{overturned, rests_on};
use super::best_place::best_place;
use super::brief_words::{of_inputs, of_place, of_signals};
use super::gluing_sheet::sheet;
use super::inputs_beside;
use super::inputs_that_matter::inputs_that_matter;
use super::left_out_words::{FILM_STIFFNESS, largest};
use super::strongest_film::strongest_film;
use super::trade::{self, PickedLayout, picked_layout, trade};
use crate::score::map_slopes::MapSlopes;
use documents::parts::film_model::FilmModel;
use documents::study::Study;
use fem_client::solver::direction::Direction;
use results::location_scores::GSI;
use results::{
    Answer, Certainty, InputsAnswer, LayoutAnswer, LeftOut, PlaceAnswer, RankedLayout,
    RankedLocation, SheetFilm, SignalsAnswer, StudyResult, TradeAnswer,
};

/// The answer of a study's result, which has everything else already; `None` where nothing has a rank. What a surer answer costs depends on the machine: who
/// knows that adds it.
pub(crate) fn answer_of(
    study: &Study,
    result: &StudyResult,
    slopes: Option<&MapSlopes>,
) -> Option<Answer> {
    let place = best_place(&result.locations, study.directions);
    let trade = trade_of(study, result);
    let layout = trade
        .as_ref()
        .and_then(|trade| picked_layout(trade, &result.layouts));
    let signals = result.signals.as_ref().and_then(strongest_film);
    let mut inputs = inputs_that_matter(result, study.directions.asked());
    if let Some(inputs) = &mut inputs {
        let of_layout = layout.as_ref().and_then(|picked| {
            let layout = result.layout_of_rank(picked.answer.rank)?;
            inputs_beside::of_layout(study, layout)
        });
        let of_volts = signals.as_ref().zip(slopes);
        let of_volts =
            of_volts.and_then(|(signals, slopes)| inputs_beside::of_volts(study, signals, slopes));
        inputs.beside = of_layout.into_iter().chain(of_volts).collect();
    }
    let told = told(
        layout.as_ref(),
        signals.as_ref(),
        place.as_ref(),
        inputs.as_ref(),
        &result.locations,
    )?;
    let unscored = (study.layouts.is_asked() && layout.is_none()).then(|| unscored(result));
    let (verdict, reason) = match unscored {
        Some(reason) => (Certainty::Unknown, reason),
        None => (told.verdict, told.reason),
    };
    let (sentence, brief) = (told.sentence.to_owned(), told.brief);
    let overturned = layout.as_ref().and_then(|_| overturned(result));
    Some(Answer {
        sentence: sentence + &overturned.unwrap_or_default(),
        brief: Some(brief),
        verdict,
        reason,
        left_out: left_out(result, signals.as_ref()),
        rests_on: rests_on(result),
        signals,
        place,
        films: films(study, result, layout.as_ref().map(|picked| &picked.answer)),
        layout: layout.map(|picked| picked.answer),
        trade,
        inputs,
        surer: None,
    })
}

/// The layout that answers, and so many that could in its place, the best first; none where none has a score.
pub(crate) fn contenders<'a>(
    study: &Study,
    result: &'a StudyResult,
    others: usize,
) -> Vec<&'a RankedLayout> {
    trade_of(study, result).map_or_else(Vec::new, |trade| {
        trade::contenders(&trade, &result.layouts, others)
    })
}

fn trade_of(study: &Study, result: &StudyResult) -> Option<TradeAnswer> {
    trade(
        &result.layouts,
        result.layout_findings.as_ref(),
        (study.question, study.layouts.limits.taken.len()),
    )
}

/// The largest of what is left out; a study that answers by glued films has their stiffness.
fn left_out(result: &StudyResult, signals: Option<&SignalsAnswer>) -> Option<LeftOut> {
    let is_glued = signals.is_some_and(|signals| signals.film == FilmModel::Coupled);
    let parts = result.model.left_out.iter();
    let parts = parts.filter(|part| !(is_glued && part.what == FILM_STIFFNESS));
    largest(parts)
}

/// The films of the layout that answers.
fn films(study: &Study, result: &StudyResult, layout: Option<&LayoutAnswer>) -> Vec<SheetFilm> {
    let found = layout.and_then(|layout| result.layout_of_rank(layout.rank));
    found.map_or_else(Vec::new, |layout| {
        sheet(
            layout,
            &study.scene.geometry,
            study.layouts.size_mm,
            result.layout_findings.as_ref(),
        )
    })
}

/// Sentence of an answer, how sure it is, and why.
#[derive(Debug, Clone)]
struct Told<'a> {
    sentence: &'a str,
    /// The sentence in few characters.
    brief: String,
    verdict: Certainty,
    reason: String,
}

/// Returns what a study tells first: its layout; without one the film that gives most, where films are read; else its best place, or the input that matters more than the depth below it. A layout is no surer than the
/// first of several places, and an input than the place that a study looks for.
fn told<'a>(
    layout: Option<&'a PickedLayout>,
    signals: Option<&'a SignalsAnswer>,
    place: Option<&'a PlaceAnswer>,
    inputs: Option<&'a InputsAnswer>,
    locations: &[RankedLocation],
) -> Option<Told<'a>> {
    let of_place = place.map(|place| Told {
        sentence: &place.sentence,
        brief: of_place(place),
        verdict: place.verdict,
        reason: place.reason.clone(),
    });
    if let Some(layout) = layout {
        let own = Told {
            sentence: &layout.sentence,
            brief: layout.brief.clone(),
            verdict: layout.answer.verdict,
            reason: layout.answer.reason.clone(),
        };
        let ranked = locations.iter().filter(|location| has_index(location));
        let weaker = of_place.filter(|place| ranked.count() > 1 && place.verdict > own.verdict);
        return Some(match weaker {
            Some(place) => Told {
                verdict: place.verdict,
                reason: place.reason,
                ..own
            },
            None => own,
        });
    }
    if let Some(signals) = signals {
        return Some(Told {
            sentence: &signals.sentence,
            brief: of_signals(signals),
            verdict: signals.verdict,
            reason: signals.reason.clone(),
        });
    }
    let is_own = |input: &String| {
        let mut locations = locations.iter();
        locations.any(|location| location.input.as_ref() == Some(input))
    };
    let others = inputs.filter(|inputs| {
        let first = inputs.shares.first();
        first.is_some_and(|share| !is_own(&share.input))
    });
    let of_inputs = others.map(|inputs| {
        // Whoever lets a depth vary looks for a place, too.
        let weaker = of_place
            .as_ref()
            .filter(|place| place.verdict > inputs.verdict);
        Told {
            sentence: &inputs.sentence,
            brief: of_inputs(inputs),
            verdict: weaker.map_or(inputs.verdict, |place| place.verdict),
            reason: weaker.map_or(inputs.reason.clone(), |place| {
                format!("{} {}", place.reason, inputs.reason)
            }),
        }
    });
    of_inputs.or(of_place)
}

fn has_index(location: &RankedLocation) -> bool {
    Direction::ALL
        .iter()
        .any(|&direction| location.value(GSI, direction).is_some())
}

/// Says why layouts that were asked for have no scores.
fn unscored(result: &StudyResult) -> String {
    let findings = result.layout_findings.as_ref();
    let first = result.layouts.first();
    let reasons = [
        first.and_then(|layout| layout.score.reason.as_ref()),
        findings.and_then(|findings| findings.reasons.first()),
    ];
    let known = reasons.into_iter().flatten().next();
    known.map_or_else(
        || "Layouts were asked for, and not scored.".to_owned(),
        |reason| format!("Layouts were asked for, and have no scores: {reason}"),
    )
}

#[cfg(test)]
mod tests {
    use document::Format;
    use fem_client::solver::{Choice, ModelSummary};
    use serde_json::json;

    use super::*;
    use documents::study::presets;
    use results::{InputShare, LayoutError, LayoutScore, RankedLayout, RankedLocation};

    /// P3 before P2 with this error of their x indices, and layouts that know the angle to these, degrees, with their errors.
    fn answered(index_error: Option<f64>, layouts: &[(f64, f64)], reason: Option<&str>) -> Answer {
        let location = |name: &str, rank: usize, x: f64| -> RankedLocation {
            let fields = json!({"name": name, "rank": rank, "rank_certain": false, "gsi_x_percent": x, "gsi_y_percent": 10.0,
                   "gsi_x_error_percent": index_error, "gsi_y_error_percent": 0.0});
            serde_json::from_value(fields).expect("a location")
        };
        let layout = |(row, &(p95, error)): (usize, &(f64, f64))| RankedLayout {
            rank: row + 1,
            spacing_deg: Some(30.0),
            units: 12,
            position: "crown".to_owned(),
            films: vec!["x".to_owned()],
            film_count: 12,
            score: LayoutScore {
                reason: reason.map(str::to_owned),
                simulated_p95_angle_error_deg: reason.is_none().then_some(p95),
                error: Some(LayoutError {
                    simulated_p95_angle_error_deg: Some(error),
                    ..LayoutError::default()
                }),
                ..LayoutScore::default()
            },
            ..RankedLayout::default()
        };
        let result = StudyResult {
            model: ModelSummary {
                left_out: vec![Choice {
                    what: "friction".to_owned(),
                    why: "it is 0".to_owned(),
                    effect: Some(0.2),
                }],
                ..ModelSummary::default()
            },
            locations: vec![location("P3", 1, 60.0), location("P2", 2, 50.0)],
            layouts: layouts.iter().enumerate().map(layout).collect(),
            ..StudyResult::default()
        };
        let refuse = |path: &str| Err(path.to_owned());
        let (_, text) = presets()[0];
        let mut study = Study::from_document(text, Format::Toml, &refuse).expect("ships");
        if layouts.is_empty() {
            study.layouts = documents::layouts::layout_settings::Layouts::none();
        }
        answer_of(&study, &result, None).expect("an answer")
    }

    #[test]
    fn the_weaker_verdict_counts_and_its_reason_is_told() {
        let [clear, close] = [[(2.0, 0.1), (4.0, 0.1)], [(2.0, 0.1), (2.05, 0.1)]];
        let cases = [
            (
                Some(1.0),
                &clear,
                Certainty::Certain,
                "Of the layouts tried with up to 12 films no other",
            ),
            (
                Some(1.0),
                &close,
                Certainty::Tied,
                "Of the layouts tried with up to 12 films rank 2 can't",
            ),
            (Some(20.0), &clear, Certainty::Tied, "Ranked by the indices"),
            (None, &close, Certainty::Unknown, "Ranked by the indices"),
        ];
        for (index_error, layouts, verdict, reason) in cases {
            let answer = answered(index_error, layouts, None);
            assert_eq!(answer.verdict, verdict);
            assert!(answer.reason.starts_with(reason), "{}", answer.reason);
            assert!(
                answer
                    .sentence
                    .starts_with("The knee is at 12 films: glue them along x at the crown")
            );
            assert_eq!(answer.left_out.expect("friction").effect, 0.2);
        }
    }

    #[test]
    fn an_input_that_matters_more_is_no_surer_than_the_place_that_is_looked_for() {
        let place = |verdict: Certainty| PlaceAnswer {
            names: vec!["P1".to_owned()],
            direction: "x".to_owned(),
            index: 0.001,
            error: Some(0.002),
            verdict,
            reason: "One place is no ranking.".to_owned(),
            sentence: "P1 tells most.".to_owned(),
        };
        let share = |input: &str, index: f64| InputShare {
            input: input.to_owned(),
            index,
            error: Some(0.01),
        };
        let inputs = InputsAnswer {
            sentence: "Pressure matters most.".to_owned(),
            verdict: Certainty::Certain,
            reason: "No other does as much.".to_owned(),
            location: "P3".to_owned(),
            direction: "y".to_owned(),
            shares: vec![share("pressure", 0.99), share("P1", 0.01)],
            beside: Vec::new(),
        };
        let alone = place(Certainty::Unknown);
        let unsure = told(None, None, Some(&alone), Some(&inputs), &[]).expect("inputs");
        assert_eq!(
            (unsure.sentence, unsure.verdict, unsure.reason.as_str()),
            (
                "Pressure matters most.",
                Certainty::Unknown,
                "One place is no ranking. No other does as much."
            )
        );
        let clear = place(Certainty::Certain);
        for sure in [Some(&clear), None] {
            let told = told(None, None, sure, Some(&inputs), &[]).expect("inputs");
            assert_eq!(told.verdict, Certainty::Certain);
            assert_eq!(told.reason, "No other does as much.");
        }
    }

    #[test]
    fn without_layouts_the_place_is_the_answer() {
        let answer = answered(Some(1.0), &[], None);
        let place = answer.place.expect("P3");
        assert_eq!((answer.verdict, answer.layout), (Certainty::Certain, None));
        assert_eq!(
            (answer.sentence, answer.reason),
            (place.sentence, place.reason)
        );
    }

    #[test]
    fn layouts_without_scores_leave_the_answer_unknown() {
        let why = "the first load has no equilibrium";
        let answer = answered(Some(1.0), &[(2.0, 0.1)], Some(why));
        assert_eq!((answer.verdict, answer.layout), (Certainty::Unknown, None));
        assert_eq!(
            answer.reason,
            "Layouts were asked for, and have no scores: the first load has no equilibrium"
        );
    }
}
