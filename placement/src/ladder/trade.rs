//! The trade: what accuracy a second buys, measured on one study.
//!
//! Each rung answers the study with another mesh and another method, from nothing, with a solver of its own. Its errors are
//! those of what the ranking goes by: each location's own first-order index for the x and the y strain at the contact centre, or the
//! one that is asked for.
//! The true error is the largest difference from a reference of the highest fidelity, the claimed one the largest that the rung itself
//! states. A rung is on the Pareto front when no other one takes less time and is nearer to the reference.

use std::sync::atomic::AtomicBool;

use fem_client::solver::Solver;
use fem_client::solver::direction::PerDirection;
use serde::{Deserialize, Serialize};

use crate::ladder::fidelity::Fidelity;
use crate::points::Observer;
use crate::points::RunContext;
use crate::points::RunError;
use crate::points::memory::MemoryArchive;
use crate::run::run;
use documents::parts::directions::Directions;
use documents::study::Study;
use documents::study::plan::Plan;
use results::FidelityReport;
use results::location_scores::GSI;
use results::{RankedLocation, StudyResult};

/// The measured trade of a study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Trade {
    /// Name of the study.
    pub study: String,
    /// SHA-256 of its canonical document.
    pub spec_sha256: String,
    /// Rung with which the others are compared.
    pub reference: Rung,
    /// The rungs, in the order of the ladder.
    pub rungs: Vec<Rung>,
}

/// A way to answer the study, and what it gave.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Rung {
    /// Label in a few words.
    pub label: String,
    /// Mesh and method.
    pub fidelity: FidelityReport,
    /// Wall-clock time, s.
    pub wall_s: f64,
    /// Processor time, s.
    pub cpu_s: f64,
    /// Solves, those on the coarser mesh included.
    pub solves: usize,
    /// Largest error of an index that the ranking goes by, absolute; null where an index is missing.
    pub error_true: Option<f64>,
    /// The largest that the rung claims.
    pub error_claimed: Option<f64>,
    /// Share of the indices whose claimed error covers the true one; null where nothing is claimed.
    pub covered: Option<f64>,
    /// Whether the locations rank as by the reference, where that one's own errors leave no doubt which of two is better.
    pub ranking_agrees: bool,
    /// Whether no other rung is both faster and nearer to the reference.
    pub pareto: bool,
    /// Indices of the locations, in the order of their names.
    pub indices: Vec<Index>,
}

impl Rung {
    /// Time, s, and true error; none where that isn't known.
    pub fn true_mark(&self) -> Option<(f64, f64)> {
        self.error_true.map(|error| (self.wall_s, error))
    }

    /// Time, s, and claimed error; none where nothing is claimed.
    pub fn claimed_mark(&self) -> Option<(f64, f64)> {
        self.error_claimed.map(|error| (self.wall_s, error))
    }
}

/// Index by which a location is ranked.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Index {
    /// Name of the location.
    pub location: String,
    /// Rank of the location.
    pub rank: usize,
    /// First-order indices for the x and the y strain, percent.
    #[schema(value_type = Vec<Option<f64>>)]
    pub gsi_percent: PerDirection<Option<f64>>,
    /// Claimed errors of the indices, percentage points.
    #[schema(value_type = Vec<Option<f64>>)]
    pub error_percent: PerDirection<Option<f64>>,
}

/// Answers a study with this fidelity, from nothing.
///
/// # Errors
/// See [`RunError`].
pub fn answer(
    study: &Study,
    fidelity: Fidelity,
    solver: &dyn Solver,
    threads: usize,
    stop: &AtomicBool,
    observer: Observer<'_>,
) -> Result<StudyResult, RunError> {
    let study = fidelity.apply(study);
    let plan = Plan::new(&study)?;
    let archive = MemoryArchive::default();
    let context = RunContext {
        solver,
        archive: &archive,
        threads,
        stop,
        pause: None,
        observer,
    };
    run(&study, &plan, context)
}

/// Compares the answers of all rungs with the reference's.
pub fn compare(
    study: &Study,
    reference: (Fidelity, &StudyResult),
    rungs: &[(Fidelity, StudyResult)],
) -> Trade {
    let truth = indices(reference.1);
    let rung = |(fidelity, result): (Fidelity, &StudyResult)| rung(study, fidelity, result, &truth);
    let mut rungs: Vec<Rung> = rungs.iter().map(|(f, result)| rung((*f, result))).collect();
    let front: Vec<bool> = rungs.iter().map(|own| is_on_front(own, &rungs)).collect();
    for (rung, on_front) in rungs.iter_mut().zip(front) {
        rung.pareto = on_front;
    }
    Trade {
        study: study.name.clone(),
        spec_sha256: study.spec_sha256(),
        reference: rung(reference),
        rungs,
    }
}

fn rung(study: &Study, fidelity: Fidelity, result: &StudyResult, truth: &[Index]) -> Rung {
    let indices = indices(result);
    let errors = errors(&indices, truth, study.directions);
    let claims = errors.as_ref().and_then(|errors| {
        let claims = errors.iter().map(|(_, claim)| *claim);
        claims.collect::<Option<Vec<f64>>>()
    });
    let covered = errors
        .as_ref()
        .zip(claims.as_ref())
        .map(|(errors, claims)| {
            let pairs = errors.iter().zip(claims);
            let covered = pairs.filter(|((error, _), claim)| error <= claim);
            covered.count() as f64 / errors.len() as f64
        });
    let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    Rung {
        label: fidelity.label(),
        fidelity: fidelity.report(study),
        wall_s: result.cost.wall_s,
        cpu_s: result.cost.cpu_s,
        solves: result.cost.solves + result.cost.coarser_solves,
        error_true: errors
            .map(|errors| largest(&errors.iter().map(|(e, _)| *e).collect::<Vec<_>>())),
        error_claimed: claims.as_deref().map(largest),
        covered,
        ranking_agrees: agrees(&indices, truth, study.directions),
        pareto: false,
        indices,
    }
}

/// Returns what the ranking goes by, in the order of the locations' names.
fn indices(result: &StudyResult) -> Vec<Index> {
    let index = |location: &RankedLocation| Index {
        location: location.name.clone(),
        rank: location.rank,
        gsi_percent: PerDirection::of(|direction| location.value(GSI, direction)),
        error_percent: PerDirection::of(|direction| location.error(GSI, direction)),
    };
    let mut indices: Vec<Index> = result.locations.iter().map(index).collect();
    indices.sort_by(|a, b| a.location.cmp(&b.location));
    indices
}

/// True and claimed error of every index that is asked for, absolute; `None` where one is missing.
fn errors(
    indices: &[Index],
    truth: &[Index],
    directions: Directions,
) -> Option<Vec<(f64, Option<f64>)>> {
    let mut errors = Vec::new();
    for (own, truth) in indices.iter().zip(truth) {
        for &direction in directions.asked() {
            let (Some(a), Some(b)) = (own.gsi_percent[direction], truth.gsi_percent[direction])
            else {
                // A location without an input of its own has no index by any method.
                if own.gsi_percent[direction].is_none() && truth.gsi_percent[direction].is_none() {
                    continue;
                }
                return None;
            };
            let claim = own.error_percent[direction].map(|claim| 0.01 * claim);
            errors.push((0.01 * (a - b).abs(), claim));
        }
    }
    (!errors.is_empty()).then_some(errors)
}

/// Whether all pairs that the reference tells apart are in its order.
fn agrees(indices: &[Index], truth: &[Index], directions: Directions) -> bool {
    let pairs = || indices.iter().zip(truth);
    pairs().all(|(a, true_a)| {
        pairs().all(|(b, true_b)| {
            let is_certain = match (estimate(true_a, directions), estimate(true_b, directions)) {
                (Some((one, one_error)), Some((other, other_error))) => {
                    one - other > one_error.hypot(other_error)
                }
                _ => false,
            };
            !is_certain || a.rank < b.rank
        })
    })
}

/// Returns what a location is ranked by, the sum of the indices that are asked for, with its error; percent.
fn estimate(index: &Index, directions: Directions) -> Option<(f64, f64)> {
    let (mut sum, mut error) = (0.0, 0.0f64);
    for &direction in directions.asked() {
        sum += index.gsi_percent[direction]?;
        error = error.hypot(index.error_percent[direction]?);
    }
    Some((sum, error))
}

fn is_on_front(own: &Rung, all: &[Rung]) -> bool {
    let Some(error) = own.error_true else {
        return false;
    };
    let beats =
        |other: &Rung| other.error_true.is_some_and(|e| e < error) && other.wall_s < own.wall_s;
    !all.iter().any(beats)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn index(location: &str, rank: usize, x: f64, y: f64, error: f64) -> Index {
        Index {
            location: location.to_owned(),
            rank,
            gsi_percent: [Some(x), Some(y)].into(),
            error_percent: [Some(error); 2].into(),
        }
    }

    #[test]
    fn a_tie_may_be_broken_either_way() {
        let truth = [
            index("P2", 2, 20.0, 10.0, 1.0),
            index("P3", 1, 60.0, 70.0, 1.0),
            index("P4", 3, 19.9, 10.0, 1.0),
        ];
        let mut other = truth.clone();
        (other[0].rank, other[2].rank) = (3, 2);
        let both = Directions::Both;
        assert!(agrees(&other, &truth, both));
        (other[0].rank, other[1].rank, other[2].rank) = (1, 2, 3);
        assert!(!agrees(&other, &truth, both));
    }

    #[test]
    fn errors_are_differences_and_a_missing_index_has_none() {
        let truth = [index("P1", 1, 50.0, 40.0, 0.5)];
        let own = [index("P1", 1, 53.0, 39.0, 2.0)];
        let both = Directions::Both;
        let found = errors(&own, &truth, both).expect("both have indices");
        let expected = [(0.03, Some(0.02)), (0.01, Some(0.02))];
        for ((a, claim), (b, expected)) in found.iter().zip(expected) {
            assert!((a - b).abs() < 1e-15);
            assert_eq!(*claim, expected);
        }
        let mut lacking = own;
        lacking[0].gsi_percent.y = None;
        assert_eq!(errors(&lacking, &truth, both), None);
        assert!(errors(&lacking, &truth, Directions::X).is_some());
        assert_eq!(errors(&[], &[], both), None);
    }
}
