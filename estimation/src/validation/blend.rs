//! The median of the models that are nearly as good as the best.
//!
//! Left-out runs are few, and can't tell near equals apart: the next run may rank them otherwise. Errors that models don't share cancel, one that goes astray is outvoted, and where
//! they disagree its interval is wider. Weights are equal: learnt from left-out rows they were no better
//! (docs/develop/decisions/estimation/blend.md), a known puzzle of combined forecasts (Claeskens et al. 2016).

use std::collections::BTreeMap;

use crate::recipe::{FeatureSet, Kind, Recipe, SplitKind};
use crate::rows::LabelledRows;
use crate::validation::candidate::Candidate;
use crate::validation::judged::{Judged, Outcome};
use crate::validation::tested_rows::Tested;

/// A model whose error is within this factor of the least takes part.
const NEARLY: f64 = 1.2;
/// Most models of a kind: two processes for a force are what a controller's cycle has time for.
const OF_A_KIND: usize = 2;

/// The blend of the best of these, judged on the splits that they were; none of fewer than two, and where the recipe has none.
pub fn blend(
    judged: &[Judged],
    by: SplitKind,
    rows: &LabelledRows,
    recipe: &Recipe,
) -> Option<Judged> {
    let members = members(judged, by);
    if members.len() < 2 || !recipe.models.kinds.contains(&Kind::Blend) {
        return None;
    }
    let candidates: Vec<Candidate> = members.iter().map(|member| member.candidate).collect();
    let features = candidates.iter().map(|candidate| candidate.features);
    let splits = members[0].splits.keys();
    let splits = splits.map(|split| (*split, blended(&members, *split, rows, recipe.models.seed)));
    Some(Judged {
        candidate: Candidate {
            kind: Kind::Blend,
            features: features.reduce(FeatureSet::with)?,
        },
        splits: splits.collect(),
        members: candidates,
    })
}

/// Returns those that take part, best first.
fn members(judged: &[Judged], by: SplitKind) -> Vec<&Judged> {
    let error = |judged: &Judged| judged.choosing_rmse(by);
    let mut models: Vec<&Judged> = judged
        .iter()
        .filter(|judged| judged.candidate.kind != Kind::Mean)
        .collect();
    models.sort_by(|a, b| error(a).total_cmp(&error(b)));
    let least = models.first().map_or(0.0, |best| error(best));
    models.retain(|judged| error(judged) <= NEARLY * least);
    let mut of_kind: BTreeMap<Kind, usize> = BTreeMap::new();
    models.retain(|judged| {
        let count = of_kind.entry(judged.candidate.kind).or_default();
        *count += 1;
        *count <= OF_A_KIND
    });
    models
}

fn blended(
    members: &[&Judged],
    split: SplitKind,
    rows: &LabelledRows,
    seed: u64,
) -> Result<Outcome, String> {
    let mut tested: Vec<&Tested> = Vec::new();
    for member in members {
        match member.splits.get(&split) {
            Some(Ok(outcome)) => tested.push(&outcome.tested),
            Some(Err(reason)) => return Err(reason.clone()),
            None => {}
        }
    }
    let tested = Tested::together(&tested).ok_or("the split wasn't made")?;
    Ok(Outcome {
        figures: tested.figures(rows, split, seed),
        tested,
    })
}

#[cfg(test)]
mod tests {
    use ndarray::Array2;

    use super::*;
    use crate::error_metrics::left_out::LeftOut;
    use crate::rows::suspect_rows::SuspectRow;
    use crate::split::Place;

    const ROWS: usize = 8;

    fn rows() -> LabelledRows {
        let place = |row: usize| Place {
            run: 0,
            row,
            cycle: row / 2,
            time_s: row as f64,
        };
        LabelledRows {
            features: Array2::zeros((ROWS, 4)),
            forces: (0..ROWS).map(|row| row as f64).collect(),
            places: (0..ROWS).map(place).collect(),
            suspect: vec![SuspectRow::default(); ROWS],
        }
    }

    /// Makes a candidate that is off by as much in every row, with a deviation of 2.
    fn off_by(error: f64, kind: Kind, features: FeatureSet) -> Judged {
        let rows = rows();
        let left_out = |row: usize| LeftOut {
            row,
            group: row / 2,
            truth: rows.forces[row],
            mean: rows.forces[row] + error,
            deviation: 2.0,
            is_suspect: false,
        };
        let tested = Tested {
            left_out: (0..ROWS).map(left_out).collect(),
            means: vec![3.5; ROWS],
        };
        let candidate = Candidate { kind, features };
        let outcome = Outcome {
            figures: tested.figures(&rows, SplitKind::Cycle, 1),
            tested,
        };
        Judged {
            candidate,
            members: vec![candidate],
            splits: [
                (SplitKind::Cycle, Ok(outcome)),
                (SplitKind::Run, Err("one run".to_owned())),
            ]
            .into(),
        }
    }

    fn blend_of(judged: &[Judged]) -> Option<Judged> {
        blend(judged, SplitKind::Cycle, &rows(), &Recipe::default())
    }

    #[test]
    fn at_most_two_of_a_kind_take_part_whose_errors_are_near_the_least() {
        let judged = [
            off_by(0.0, Kind::Mean, FeatureSet::Raw),
            off_by(1.21, Kind::Ann, FeatureSet::Raw),
            off_by(1.19, Kind::Ridge, FeatureSet::Slopes),
            off_by(1.15, Kind::Gpr, FeatureSet::Slopes),
            off_by(1.1, Kind::Gpr, FeatureSet::Rolling),
            off_by(1.0, Kind::Gpr, FeatureSet::Raw),
        ];
        let found = blend_of(&judged).expect("a blend");
        let named: Vec<(Kind, FeatureSet)> = found
            .members
            .iter()
            .map(|member| (member.kind, member.features))
            .collect();
        assert_eq!(
            named,
            [
                (Kind::Gpr, FeatureSet::Raw),
                (Kind::Gpr, FeatureSet::Rolling),
                (Kind::Ridge, FeatureSet::Slopes)
            ]
        );
        // Rolling and slopes together are all features.
        assert_eq!(found.candidate.features, FeatureSet::All);
        assert!(
            matches!(found.splits.get(&SplitKind::Run), Some(Err(reason)) if reason == "one run")
        );
    }

    #[test]
    fn errors_that_are_not_shared_cancel_and_widen_the_interval() {
        let judged = [
            off_by(1.5, Kind::Ridge, FeatureSet::Raw),
            off_by(-1.5, Kind::Gpr, FeatureSet::Raw),
        ];
        let found = blend_of(&judged).expect("a blend");
        assert_eq!(
            found.on(SplitKind::Cycle).map(|figures| figures.rmse),
            Some(0.0)
        );
        // root(2^2 + 1.5^2) = 2.5
        let mut deviations = found
            .left_out(SplitKind::Cycle)
            .iter()
            .map(|row| row.deviation);
        assert!(deviations.all(|deviation| deviation == 2.5));
    }

    #[test]
    fn one_model_is_no_blend_nor_is_what_nobody_asked_for() {
        let mut judged = vec![
            off_by(1.0, Kind::Gpr, FeatureSet::Raw),
            off_by(2.0, Kind::Gpr, FeatureSet::All),
        ];
        assert_eq!(blend_of(&judged), None);
        judged.push(off_by(1.0, Kind::Ann, FeatureSet::Raw));
        let mut recipe = Recipe::default();
        assert!(blend(&judged, SplitKind::Cycle, &rows(), &recipe).is_some());
        recipe.models.kinds = vec![Kind::Gpr, Kind::Ann];
        assert_eq!(blend(&judged, SplitKind::Cycle, &rows(), &recipe), None);
    }
}
