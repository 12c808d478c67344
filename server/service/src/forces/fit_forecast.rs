//! Time and memory that a fit takes, before it begins.

use document::fault::Fault;
use estimation::fit_report::RecordingFigures;
use estimation::recipe::Recipe;
use estimation::validation::{FitSizes, FitTime, fit_time};
use results::Forecast;

use crate::forces::fit_memory::{RowSizes, fit_memory_bytes};
use crate::forces::fitting::figures_of;
use crate::forces::recorded_texts::{NamedText, read_runs};
use crate::wire::estimator_wire::{FitEstimate, StoredEstimator};

/// Forecast of a fit whose recordings are at hand.
///
/// # Errors
/// Every fault of the recordings.
pub fn fit_forecast(
    recipe: &Recipe,
    files: &[NamedText],
    threads: usize,
) -> Result<FitEstimate, Vec<Fault>> {
    let runs = read_runs(recipe, files)?;
    let (forces, signals) = (runs.names.forces.len(), runs.names.signals.len());
    let figures = figures_of(&runs, files);
    Ok(estimate(recipe, &figures, [forces, signals], threads))
}

/// Forecast of a fit whose recordings are stored; none of a document of an earlier version.
pub(crate) fn stored_forecast(stored: &StoredEstimator, threads: usize) -> Option<FitEstimate> {
    let recipe = Recipe::from_value(&stored.recipe).ok()?;
    let columns = [stored.forces.len(), stored.signals];
    (stored.signals > 0).then(|| estimate(&recipe, &stored.recordings, columns, threads))
}

/// Forecast of a fit by its recordings' figures and the counts of forces and signals: a row with one force is counted for all.
pub(crate) fn estimate(
    recipe: &Recipe,
    recordings: &[RecordingFigures],
    [forces, signals]: [usize; 2],
    threads: usize,
) -> FitEstimate {
    let sum = |of: fn(&RecordingFigures) -> usize| recordings.iter().map(of).sum();
    let sizes = FitSizes {
        rows: vec![sum(|recording| recording.labelled); forces],
        signals,
        runs: recordings.len(),
        cycles: sum(|recording| recording.cycles),
    };
    let FitTime {
        least_s,
        expected_s,
        most_s,
    } = fit_time(recipe, &sizes, threads);
    let rows = RowSizes {
        rows: sum(|recording| recording.rows),
        signals,
        forces,
    };
    FitEstimate {
        wall_s: Forecast {
            least: least_s,
            expected: expected_s,
            most: most_s,
        },
        peak_memory_bytes: fit_memory_bytes(&rows, recipe, threads),
        threads,
    }
}
