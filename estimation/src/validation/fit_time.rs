//! Time that a fit takes, before it begins, by the sizes of its recordings.

use crate::features::columns;
use crate::model::contract::Effort;
use crate::model::learning_time::LearningTask;
use crate::recipe::{FeatureSet, Kind, Recipe, SplitKind, StartValue};
use crate::split::{FREQUENCIES, MOST_FOLDS, RANDOM_SHARE, TIME_PARTS};
use crate::validation::candidate::{Candidate, candidates};
use crate::validation::tested_rows::MOST_TESTED;

/// A time may be off by this factor: another machine, searches that end sooner or later, other work beside it.
const SPREAD: f64 = 3.0;
/// Time that reading, and a process of its own, take at least, s.
const START_S: f64 = 0.1;
/// Most models of a kind that a blend has.
const MEMBERS: usize = 2;

/// Sizes of the recordings of a fit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FitSizes {
    /// Rows with each of the forces.
    pub rows: Vec<usize>,
    /// Count of the signals.
    pub signals: usize,
    /// Count of the runs.
    pub runs: usize,
    /// Cycles of all runs.
    pub cycles: usize,
}

/// Wall-clock time of a fit, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitTime {
    /// Least time: the cheapest model is chosen.
    pub least_s: f64,
    /// Likeliest time: a model of each kind is learnt from all rows.
    pub expected_s: f64,
    /// Greatest time: two of each kind are.
    pub most_s: f64,
}

/// Returns how long a fit takes on so many threads.
pub fn fit_time(recipe: &Recipe, sizes: &FitSizes, threads: usize) -> FitTime {
    let work = Work { recipe, sizes };
    let before =
        START_S + parallel_s(&work.starts(), threads) + parallel_s(&work.judged(), threads);
    let learnt = |members: &[Candidate]| before + parallel_s(&work.learnt(members), threads);
    let kinds = || {
        candidates(recipe)
            .into_iter()
            .filter(|one| one.kind != Kind::Mean)
    };
    let of_set = |features: Option<&FeatureSet>| -> Vec<Candidate> {
        let chosen = kinds().filter(|one| Some(&one.features) == features);
        chosen.collect()
    };
    let sets = &recipe.features.sets;
    let expected = learnt(&of_set(sets.get(sets.len() / 2)));
    let alone = kinds().map(|one| learnt(&[one]));
    let twice = of_set(sets.iter().max()).repeat(MEMBERS);
    FitTime {
        least_s: alone.fold(expected, f64::min) / SPREAD,
        expected_s: expected,
        most_s: learnt(&twice).max(expected) * SPREAD,
    }
}

/// Pieces of work shared out among threads, s.
fn parallel_s(pieces: &[f64], threads: usize) -> f64 {
    let longest = pieces.iter().copied().fold(0.0, f64::max);
    longest.max(pieces.iter().sum::<f64>() / threads.max(1) as f64)
}

/// A fold by its sizes.
struct FoldSize {
    train: f64,
    test: f64,
}

struct Work<'a> {
    recipe: &'a Recipe,
    sizes: &'a FitSizes,
}

impl Work<'_> {
    /// Pieces that tell whether first readings are taken off: lines and processes, both ways.
    fn starts(&self) -> Vec<f64> {
        if self.recipe.preprocess.start_value != StartValue::Auto || self.sizes.runs < 2 {
            return Vec::new();
        }
        let of = |kind, rows| {
            let candidate = Candidate {
                kind,
                features: FeatureSet::Raw,
            };
            self.split_s(candidate, rows, self.chooses())
        };
        let rows = self.sizes.rows.iter().copied();
        let both = rows.flat_map(|rows| [Kind::Ridge, Kind::Gpr].map(|kind| of(kind, rows)));
        let both: Vec<f64> = both.collect();
        both.repeat(2)
    }

    /// Pieces that judge a candidate of a force on every split.
    fn judged(&self) -> Vec<f64> {
        let candidates = candidates(self.recipe);
        let of = |candidate: &Candidate, rows: usize| {
            let splits = SplitKind::ALL.into_iter();
            splits
                .map(|split| self.split_s(*candidate, rows, split))
                .sum()
        };
        let pairs = self.sizes.rows.iter();
        pairs
            .flat_map(|rows| candidates.iter().map(move |one| of(one, *rows)))
            .collect()
    }

    /// Pieces that learn what was chosen from all rows, what chance would do, and what runs that begin elsewhere do to it.
    fn learnt(&self, members: &[Candidate]) -> Vec<f64> {
        let of = |candidate: Candidate, rows: usize| {
            let whole = self.task(candidate, Effort::Whole, rows).learning_s();
            let split_s = |split| self.split_s(candidate, rows, split);
            [whole, split_s(self.chooses()), split_s(SplitKind::Run)]
        };
        let rows = self.sizes.rows.iter();
        rows.flat_map(|rows| members.iter().flat_map(move |one| of(*one, *rows)))
            .collect()
    }

    /// A candidate on one split.
    fn split_s(&self, candidate: Candidate, rows: usize, split: SplitKind) -> f64 {
        let folds = self.folds(rows, split);
        let most = MOST_TESTED as f64 / folds.len().max(1) as f64;
        let of = |fold: &FoldSize| {
            let task = self.task(candidate, Effort::Fold, fold.train as usize);
            task.learning_s() + fold.test.min(most) * task.predicting_s()
        };
        folds.iter().map(of).sum()
    }

    /// The folds of a split; none where it can't be made.
    fn folds(&self, rows: usize, split: SplitKind) -> Vec<FoldSize> {
        let n = rows as f64;
        let left_out = |groups: usize| -> Vec<FoldSize> {
            let count = groups.min(MOST_FOLDS);
            let test = n / count.max(1) as f64;
            let fold = |_| FoldSize {
                train: n - test,
                test,
            };
            (0..count).filter(|_| count > 1).map(fold).collect()
        };
        match split {
            SplitKind::Random => vec![FoldSize {
                train: n * (1.0 - RANDOM_SHARE),
                test: n * RANDOM_SHARE,
            }],
            SplitKind::Cycle => left_out(self.sizes.cycles),
            SplitKind::Run => left_out(self.sizes.runs),
            SplitKind::Time => {
                let part = n / TIME_PARTS as f64;
                let fold = |parts: usize| FoldSize {
                    train: part * parts as f64,
                    test: part,
                };
                (1..TIME_PARTS).map(fold).collect()
            }
            SplitKind::Frequency if self.sizes.cycles < 2 * FREQUENCIES => Vec::new(),
            SplitKind::Frequency => left_out(FREQUENCIES),
        }
    }

    /// The split that chooses.
    fn chooses(&self) -> SplitKind {
        let strictest = match self.sizes.runs {
            0 | 1 => SplitKind::Cycle,
            _ => SplitKind::Run,
        };
        self.recipe.validation.by.unwrap_or(strictest)
    }

    fn task(&self, candidate: Candidate, effort: Effort, rows: usize) -> LearningTask<'_> {
        LearningTask {
            kind: candidate.kind,
            models: &self.recipe.models,
            effort,
            rows,
            features: columns(candidate.features, self.sizes.signals).count(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sizes(rows: usize, runs: usize) -> FitSizes {
        FitSizes {
            rows: vec![rows; 2],
            signals: 8,
            runs,
            cycles: 10 * runs,
        }
    }

    #[test]
    fn a_fit_takes_longer_with_more_rows_forces_and_kinds() {
        let usual = Recipe::default();
        let of =
            |recipe: &Recipe, sizes: &FitSizes| fit_time(recipe, sizes, 1).expected_s - START_S;
        let base = of(&usual, &sizes(1000, 3));
        assert!(of(&usual, &sizes(4000, 3)) > base);
        let mut one_force = sizes(1000, 3);
        one_force.rows.pop();
        assert!((2.0 * of(&usual, &one_force) / base - 1.0).abs() < 1e-10);
        let mut lines = usual.clone();
        lines.models.kinds = vec![Kind::Ridge];
        assert!(of(&lines, &sizes(1000, 3)) < 0.1 * base);
    }

    #[test]
    fn threads_share_the_pieces_but_no_piece_is_cut() {
        let usual = Recipe::default();
        let on = |threads| fit_time(&usual, &sizes(1000, 3), threads);
        let [one, two, many] = [1, 2, 1000].map(on);
        assert!(two.expected_s < one.expected_s && many.expected_s > one.expected_s / 100.0);
        for found in [one, two, many] {
            assert!(found.least_s <= found.expected_s && found.expected_s <= found.most_s);
        }
    }

    #[test]
    fn a_split_that_cant_be_made_takes_no_time() {
        let recipe = Recipe::default();
        let work = Work {
            recipe: &recipe,
            sizes: &sizes(1000, 1),
        };
        assert!(work.folds(1000, SplitKind::Run).is_empty() && work.starts().is_empty());
        let trained: f64 = work
            .folds(1000, SplitKind::Cycle)
            .iter()
            .map(|fold| fold.train)
            .sum();
        assert!((trained - 4000.0).abs() < 1e-9);
    }
}
