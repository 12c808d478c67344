//! The rows of the published tables as they were printed, each figure checked against the others of the same forces.

use estimation::recipe::{FeatureSet, Kind, SplitKind};

use crate::published::contradictions::{Checked, Contradiction, checked};
use crate::published::printed_figures::{
    ABLATIONS, AXES, Ablation, FREQUENCIES, NETWORKS, PROCESSES, Triple,
};
use crate::published::published_gaits::RANDOMISED;
use crate::published::tested_forces::RigFigures;

/// A figure of the published study beside the rig's.
#[derive(Debug, Clone, PartialEq)]
pub struct PublishedRow {
    /// Number of the published table.
    pub table: u32,
    /// The gait: `randomised`, `1 Hz`, `low frequency` or the like.
    pub gait: &'static str,
    /// The model.
    pub model: Kind,
    /// The features it reads.
    pub features: FeatureSet,
    /// `fx`: along the wheel, `fy`: across it, `fz`: vertical.
    pub axis: &'static str,
    /// Split by which the rig's model is tested: random readings, later ones, or another run, whose films have other gains.
    pub by: SplitKind,
    /// Figures as they were printed.
    pub printed: PrintedFigures,
    /// Figures of the rig; none where nothing was learnt.
    pub rig: Option<RigFigures>,
    /// The rig's model on a run with other gains; none where that is what `rig` has.
    pub fresh: Option<RigFigures>,
    /// Reason why figures are missing.
    pub reason: Option<String>,
}

/// Figures as the published study prints them.
#[derive(Debug, Clone, PartialEq)]
pub struct PrintedFigures {
    /// RMSE over the range of the tested forces, %.
    pub nrmse_percent: f64,
    /// Root of the mean squared error, N.
    pub rmse_n: Option<f64>,
    /// Coefficient of determination.
    pub r2: Option<f64>,
    /// NRMSE that the mean of the tested forces would have reached, by what the three figures imply, %.
    pub mean_nrmse_percent: Option<f64>,
    /// Contradiction of the figures with those of the same tested forces in other cells.
    pub contradiction: Option<Contradiction>,
}

/// Splits that tables 8 and 9 call before and after temporal cross-validation.
const BEFORE_AND_AFTER: [SplitKind; 2] = [SplitKind::Random, SplitKind::Time];

/// All rows, in the order of the tables, without the rig's figures.
pub fn published_rows() -> Vec<PublishedRow> {
    let mut rows = ablations();
    rows.extend(frequencies());
    rows.extend(cross_validations(8));
    rows.extend(cross_validations(9));
    rows
}

fn row(
    table: u32,
    gait: &'static str,
    (model, features): (Kind, FeatureSet),
    axis: usize,
    by: SplitKind,
    printed: PrintedFigures,
) -> PublishedRow {
    PublishedRow {
        table,
        gait,
        model,
        features,
        axis: AXES[axis],
        by,
        printed,
        rig: None,
        fresh: None,
        reason: None,
    }
}

fn ablations() -> Vec<PublishedRow> {
    let of = |ablation: &Ablation| {
        let given = (ablation.model, ablation.features);
        let (table, percent) = (ablation.table, ablation.nrmse_percent);
        (0..AXES.len()).map(move |axis| {
            let printed = PrintedFigures {
                nrmse_percent: percent[axis],
                rmse_n: None,
                r2: None,
                mean_nrmse_percent: None,
                contradiction: None,
            };
            row(table, RANDOMISED, given, axis, SplitKind::Random, printed)
        })
    };
    ABLATIONS.iter().flat_map(of).collect()
}

fn printed(cell: &Triple, checked: &Checked, at: usize) -> PrintedFigures {
    PrintedFigures {
        nrmse_percent: cell.nrmse_percent,
        rmse_n: Some(cell.rmse_n),
        r2: Some(cell.r2),
        mean_nrmse_percent: Some(checked.mean_nrmse_percent[at]),
        contradiction: checked.contradictions[at].clone(),
    }
}

fn frequencies() -> Vec<PublishedRow> {
    let mut rows = Vec::new();
    for pair in &FREQUENCIES {
        for (axis, cells) in pair.cells.iter().enumerate() {
            let checked = checked(cells);
            for (at, model) in [Kind::Gpr, Kind::Ann].into_iter().enumerate() {
                let printed = printed(&cells[at], &checked, at);
                let given = (model, FeatureSet::All);
                rows.push(row(6, pair.gait, given, axis, SplitKind::Run, printed));
            }
        }
    }
    rows
}

fn cross_validations(table: u32) -> Vec<PublishedRow> {
    let (model, first) = match table {
        8 => (Kind::Gpr, 0),
        _ => (Kind::Ann, 2),
    };
    let mut rows = Vec::new();
    for (process, network) in PROCESSES.iter().zip(&NETWORKS) {
        for axis in 0..AXES.len() {
            // Both models were tested on the same forces.
            let cells = [process.cells[axis], network.cells[axis]].concat();
            let checked = checked(&cells);
            for (cell, by) in BEFORE_AND_AFTER.into_iter().enumerate() {
                let at = first + cell;
                let printed = printed(&cells[at], &checked, at);
                let given = (model, FeatureSet::All);
                rows.push(row(table, process.gait, given, axis, by, printed));
            }
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_printed_figure_has_its_row() {
        let rows = published_rows();
        let of = |table: u32| rows.iter().filter(|row| row.table == table).count();
        assert_eq!([4, 5, 6, 8, 9].map(of), [12, 12, 18, 18, 18]);
        let found = rows.iter().find(|row| {
            row.table == 9
                && row.gait == "gait transition"
                && row.axis == "fz"
                && row.by == SplitKind::Time
        });
        let printed = &found.expect("the last row").printed;
        assert_eq!(
            (printed.nrmse_percent, printed.rmse_n, printed.r2),
            (15.43, Some(1.3914), Some(0.7053))
        );
        // Forces with a deviation of 2.565 N in a range of 9.018 N.
        let mean = printed.mean_nrmse_percent.expect("three figures");
        assert!((mean - 28.44).abs() < 0.05, "{mean}");
        let marked = rows
            .iter()
            .filter(|row| row.printed.contradiction.is_some());
        assert_eq!(marked.count(), 7);
    }
}
