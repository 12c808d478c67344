//! The whole answer of a study: its sentence, the weaker verdict, and what could overturn it.

use super::best_layout::best_layout;
use super::best_place::best_place;
use super::left_out_words::largest;
use crate::result::{Answer, Certainty, StudyResult};
use crate::study::Study;

/// The answer of a study's result, which has everything else already; `None` where nothing has a rank. What a surer answer costs depends on the machine: who
/// knows that adds it.
pub(crate) fn answer_of(study: &Study, result: &StudyResult) -> Option<Answer> {
    let place = best_place(&result.locations, study.directions);
    let layout = best_layout(&result.layouts);
    let of_layout = layout
        .as_ref()
        .map(|(layout, sentence)| (layout.verdict, &layout.reason, sentence));
    let of_place = place
        .as_ref()
        .map(|place| (place.verdict, &place.reason, &place.sentence));
    let told = [of_layout, of_place];
    let sentence = told
        .iter()
        .flatten()
        .map(|(.., sentence)| *sentence)
        .next()?
        .clone();
    let unscored = (study.layouts.is_asked() && of_layout.is_none()).then(|| unscored(result));
    let (verdict, reason) = match unscored {
        Some(reason) => (Certainty::Unknown, reason),
        None => {
            // The layout's of equals: the sentence is about it.
            let weaker =
                told.iter().flatten().reduce(
                    |layout, place| {
                        if place.0 > layout.0 { place } else { layout }
                    },
                );
            let (verdict, reason, _) = weaker?;
            (*verdict, (*reason).clone())
        }
    };
    Some(Answer {
        sentence,
        verdict,
        reason,
        left_out: largest(&result.model.left_out),
        place,
        layout: layout.map(|(layout, _)| layout),
        surer: None,
    })
}

/// Why layouts that were asked for have no scores.
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
    use fem_client::document::Format;
    use serde_json::{Value, json};

    use super::*;
    use crate::study::presets;

    /// P3 before P2 with this error of their x indices, and layouts that know the angle to these, degrees, with their errors.
    fn answered(index_error: Option<f64>, layouts: &[(f64, f64)], reason: Option<&str>) -> Answer {
        let location = |name: &str, rank: usize, x: f64| {
            json!({"name": name, "rank": rank, "rank_certain": false, "gsi_x_percent": x, "gsi_y_percent": 10.0,
                   "gsi_x_error_percent": index_error, "gsi_y_error_percent": 0.0})
        };
        let layout = |(row, (p95, error)): (usize, &(f64, f64))| {
            json!({"rank": row + 1, "spacing_deg": 30.0, "units": 12, "position": "crown", "films": ["x"], "film_count": 12,
                   "score": {"weakest_signal": null, "worst_angle_error_deg": null, "rms_angle_error_deg": null, "worst_depth_error_mm": null,
                             "noise_strain": 0.001, "reason": reason,
                             "simulated_p95_angle_error_deg": reason.is_none().then_some(p95),
                             "error": {"worst_angle_error_deg": null, "rms_angle_error_deg": null, "worst_depth_error_mm": null,
                                       "simulated_rms_angle_error_deg": null, "simulated_p95_angle_error_deg": error}}})
        };
        let layouts: Vec<Value> = layouts.iter().enumerate().map(layout).collect();
        let result = json!({
            "study": {"id": "", "name": "made up", "spec_sha256": "", "version": ""},
            "model": {"dimension": "3d", "level": "coarse", "elements": 1, "dofs": 1, "modelled": [],
                      "left_out": [{"what": "friction", "why": "it is 0", "effect": 0.2}]},
            "inputs": [], "outputs": [], "locations": [location("P3", 1, 60.0), location("P2", 2, 50.0)],
            "layouts": layouts, "map": null, "notes": [], "failed_points": [],
            "cut_point": {"values": [], "reaction_n": 1.0, "inflated_outer_radius_mm": 50.0, "locations": [], "residual_history": []},
            "cost": {"solves": 1, "reused": 0, "newton_iterations": 1, "wall_s": 1.0, "cpu_s": 1.0, "peak_memory_bytes": 1,
                     "factorisation_share": 0.0, "assembly_share": 0.0, "other_share": 1.0},
        });
        let result: StudyResult = serde_json::from_value(result).expect("a result");
        let refuse = |path: &str| Err(path.to_owned());
        let (_, text) = presets()[0];
        let mut study = Study::from_document(text, Format::Toml, &refuse).expect("ships");
        if layouts.is_empty() {
            study.layouts = crate::layout::layout_settings::Layouts::none();
        }
        answer_of(&study, &result).expect("an answer")
    }

    #[test]
    fn the_weaker_verdict_counts_and_its_reason_is_told() {
        let [clear, close] = [[(2.0, 0.1), (4.0, 0.1)], [(2.0, 0.1), (2.05, 0.1)]];
        let cases = [
            (Some(1.0), &clear, Certainty::Certain, "No other comes near"),
            (Some(1.0), &close, Certainty::Tied, "Rank 2 can't be told"),
            (Some(20.0), &clear, Certainty::Tied, "Ranked by the indices"),
            (None, &close, Certainty::Unknown, "Ranked by the indices"),
        ];
        for (index_error, layouts, verdict, reason) in cases {
            let answer = answered(index_error, layouts, None);
            assert_eq!(answer.verdict, verdict);
            assert!(answer.reason.starts_with(reason), "{}", answer.reason);
            assert!(answer.sentence.starts_with("Glue films of x at the crown"));
            assert_eq!(answer.left_out.expect("friction").effect, 0.2);
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
