//! A result beside the published figures (Sensors 2025, 25, 4026), where the study is the published one.

use std::fmt::Write;

use fem_client::solver::direction::{Direction, PerDirection};
use placement::result::{InputReport, StudyResult};
use placement::score::location_scores::{GSI, MDRM_GSI, Score};

use crate::cli::terminal::paint::header;
use crate::cli::terminal::report::ranked_table::percent;
use crate::cli::terminal::report::shared_rank::rank_cell;
use crate::cli::terminal::wrapping::wrapped;

/// Table 2 of the paper: P1 to P5, x and y, percent.
const PAPER: [(&str, f64, f64); 5] = [
    ("P1", 1.4719, 0.0662),
    ("P2", 6.1071, 9.4910),
    ("P3", 29.9733, 32.1724),
    ("P4", 6.6748, 10.1924),
    ("P5", 1.5767, 0.0662),
];
/// Its five depths are uniform on this, mm.
const PAPERS_DEPTHS_MM: [f64; 2] = [0.0, 2.0];

/// M-DRM's indices and the paper's, below the table of what holds; nothing where the study isn't the paper's.
pub fn beside_the_paper(result: &StudyResult) -> String {
    if !is_the_papers(&result.inputs) {
        return String::new();
    }
    let mut text = header(
        "\n                M-DRM's gsi,      paper's\n                valid or not, %   Table 2, %\nrank  location         x       y         x       y\n",
    );
    let ranks = || result.locations.iter().map(|location| location.rank);
    for location in &result.locations {
        let PerDirection { x, y } = location.scores.of_score(MDRM_GSI);
        let paper = PAPER.iter().find(|(name, ..)| *name == location.name);
        let _ = writeln!(
            text,
            "{} {:<8}  {} {}   {} {}",
            rank_cell(location.rank, ranks()),
            location.name,
            percent(x.value),
            percent(y.value),
            percent(paper.map(|(_, x, _)| *x)),
            percent(paper.map(|(_, _, y)| *y)),
        );
    }
    text + &remark(result)
}

/// Whether the five depths, and nothing else, vary as in the paper.
fn is_the_papers(inputs: &[InputReport]) -> bool {
    let is_own = |(station, input): (usize, &InputReport)| {
        let law = &input.distribution;
        let ends = ["min", "max"].map(|end| law[end].as_f64());
        input.vary == format!("ground.depths_mm[{station}]")
            && law["kind"] == "uniform"
            && ends == PAPERS_DEPTHS_MM.map(Some)
    };
    inputs.len() == PAPER.len() && inputs.iter().enumerate().all(is_own)
}

/// What M-DRM's numbers are worth beside the paper's, where they come close to it and the valid ones don't.
fn remark(result: &StudyResult) -> String {
    let furthest = |score: &Score| {
        PAPER.iter().try_fold(0.0, |furthest: f64, (name, x, _)| {
            let mut locations = result.locations.iter();
            let location = locations.find(|location| location.name == *name)?;
            let index = location.value(score, Direction::X)?;
            Some(furthest.max((index - x).abs()))
        })
    };
    match (furthest(MDRM_GSI), furthest(GSI)) {
        (Some(mdrm), Some(valid)) if mdrm < 5.0 && valid > 2.0 * mdrm => wrapped(
            &format!(
                "M-DRM's x column is within {mdrm:.1} points of the paper's Table 2, and it is wrong here: the circumferential strain \
                 changes sign within the range of depths, so its product form is broken; the valid indices are up to {valid:.1} points \
                 away from the paper's."
            ),
            0,
        ),
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn inputs(max: f64) -> Vec<InputReport> {
        let input = |station: usize| InputReport {
            name: format!("P{}", station + 1),
            vary: format!("ground.depths_mm[{station}]"),
            distribution: json!({"kind": "uniform", "min": 0.0, "max": max}),
        };
        (0..5).map(input).collect()
    }

    #[test]
    fn the_papers_study_is_known_by_its_inputs() {
        assert!(is_the_papers(&inputs(2.0)));
        assert!(!is_the_papers(&inputs(1.3)));
        assert!(!is_the_papers(&inputs(2.0)[..4]));
        let mut other = inputs(2.0);
        other[4].vary = "pressure.internal_mpa".to_owned();
        assert!(!is_the_papers(&other));
    }
}
