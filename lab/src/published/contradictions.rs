//! Contradictions of printed figures.
//!
//! NRMSE, RMSE and R2 of one cell imply the deviation and the range of the forces that were tested: RMSE / sqrt(1 - R2) and RMSE / NRMSE. Cells that tested the
//! same forces must imply the same of both. They do so to 0.14 %, by the rounding of what is printed, or are off by 4 % and more.

use crate::published::printed_figures::Triple;

/// Cells whose implied figures are closer than this agree.
const TOLERANCE: f64 = 0.01;

/// A figure that can't be true beside the others.
#[derive(Debug, Clone, PartialEq)]
pub struct Contradiction {
    /// Value that the other cells and this one's RMSE imply; none where two cells contradict each other and none tells which is right.
    pub implied: Option<f64>,
    /// A sentence.
    pub detail: String,
}

/// Findings in cells that tested the same forces.
#[derive(Debug, Clone, PartialEq)]
pub struct Checked {
    /// NRMSE of the mean of the tested forces, %, by cell.
    pub mean_nrmse_percent: Vec<f64>,
    /// Contradictions of the others, by cell.
    pub contradictions: Vec<Option<Contradiction>>,
}

impl Triple {
    /// Standard deviation of the tested forces, N.
    fn deviation_n(&self) -> f64 {
        self.rmse_n / (1.0 - self.r2).sqrt()
    }

    /// Returns the range of the forces, N.
    fn range_n(&self) -> f64 {
        100.0 * self.rmse_n / self.nrmse_percent
    }
}

/// Compares cells that tested the same forces.
pub fn checked(cells: &[Triple]) -> Checked {
    let deviations: Vec<f64> = cells.iter().map(Triple::deviation_n).collect();
    let ranges: Vec<f64> = cells.iter().map(Triple::range_n).collect();
    let [deviation, range] = [&deviations, &ranges].map(|values| shared(values));
    let contradiction = |cell: usize| {
        let off = |values: &[f64], shared: Option<f64>| match shared {
            Some(shared) => differ(values[cell], shared),
            None => true,
        };
        let triple = &cells[cell];
        let pair = [(&deviations, deviation), (&ranges, range)];
        match pair.map(|(values, shared)| off(values, shared)) {
            [false, false] => None,
            [true, true] => Some(unclear(&deviations, &ranges)),
            [true, false] => deviation.map(|deviation| wrong_r2(triple, deviation)),
            [false, true] => range.map(|range| wrong_nrmse(triple, range)),
        }
    };
    let mean = |cell: usize| {
        let deviation = deviation.unwrap_or(deviations[cell]);
        100.0 * deviation / range.unwrap_or(ranges[cell])
    };
    Checked {
        mean_nrmse_percent: (0..cells.len()).map(mean).collect(),
        contradictions: (0..cells.len()).map(contradiction).collect(),
    }
}

fn differ(a: f64, b: f64) -> bool {
    (a / b - 1.0).abs() > TOLERANCE
}

/// The mean of the values that most of them agree on, and at least two.
fn shared(values: &[f64]) -> Option<f64> {
    let agreeing = |value: &f64| -> Vec<f64> {
        let near = values.iter().filter(|other| !differ(**other, *value));
        near.copied().collect()
    };
    let most = values.iter().map(agreeing).max_by_key(Vec::len)?;
    let count = most.len();
    (count >= 2).then(|| most.iter().sum::<f64>() / count as f64)
}

fn wrong_r2(cell: &Triple, deviation_n: f64) -> Contradiction {
    let share = cell.rmse_n / deviation_n;
    let implied = 1.0 - share * share;
    Contradiction {
        implied: Some(implied),
        detail: format!(
            "R2 is printed as {}; the same forces in other cells have a deviation of {deviation_n:.3} N, with which it is {implied:.3}.",
            cell.r2
        ),
    }
}

fn wrong_nrmse(cell: &Triple, range_n: f64) -> Contradiction {
    let implied = 100.0 * cell.rmse_n / range_n;
    Contradiction {
        implied: Some(implied),
        detail: format!(
            "NRMSE is printed as {} %; the same forces in other cells have a range of {range_n:.2} N, with which it is {implied:.2} %.",
            cell.nrmse_percent
        ),
    }
}

fn unclear(deviations_n: &[f64], ranges_n: &[f64]) -> Contradiction {
    let list = |values: &[f64]| {
        let words: Vec<String> = values.iter().map(|value| format!("{value:.2}")).collect();
        words.join(" and ")
    };
    Contradiction {
        implied: None,
        detail: format!(
            "Cells of the same forces imply deviations of {} N and ranges of {} N: none tells which is right.",
            list(deviations_n),
            list(ranges_n)
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::published::printed_figures::{FREQUENCIES, NETWORKS, PROCESSES};

    fn triple(deviation_n: f64, range_n: f64, rmse_n: f64) -> Triple {
        Triple {
            nrmse_percent: 100.0 * rmse_n / range_n,
            rmse_n,
            r2: 1.0 - (rmse_n / deviation_n) * (rmse_n / deviation_n),
        }
    }

    #[test]
    fn cells_that_agree_have_no_contradiction_and_the_means_error() {
        let found = checked(&[triple(2.0, 8.0, 1.0), triple(2.0, 8.0, 1.7)]);
        assert_eq!(found.contradictions, [None, None]);
        assert!((found.mean_nrmse_percent[0] - 25.0).abs() < 1e-9);
    }

    #[test]
    fn a_wrong_figure_is_recomputed_from_the_others() {
        let mut cells = [1.0, 1.5, 1.8].map(|rmse_n| triple(2.0, 8.0, rmse_n));
        cells[1].r2 = 0.9;
        cells[2].nrmse_percent *= 1.1;
        let found = checked(&cells).contradictions;
        assert_eq!(found[0], None);
        let implied = |cell: usize| found[cell].as_ref().and_then(|it| it.implied);
        assert!((implied(1).expect("R2") - (1.0 - 0.75 * 0.75)).abs() < 1e-9);
        assert!((implied(2).expect("NRMSE") - 100.0 * 1.8 / 8.0).abs() < 1e-9);
    }

    #[test]
    fn two_cells_that_disagree_are_told_and_not_recomputed() {
        let found = checked(&[triple(1.0, 9.0, 0.5), triple(3.0, 17.0, 0.5)]);
        let told: Vec<Option<f64>> = found
            .contradictions
            .iter()
            .map(|it| it.as_ref().expect("told").implied)
            .collect();
        assert_eq!(told, [None, None]);
    }

    /// A lost minus twice and once more, a figure of another row, an NRMSE: five cells. The sixth place is a pair of cells.
    #[test]
    fn the_published_tables_contradict_themselves_in_six_places() {
        let mut places = Vec::new();
        for row in FREQUENCIES {
            for (axis, cells) in row.cells.iter().enumerate() {
                let found = checked(cells).contradictions;
                assert_eq!(found[0].is_some(), found[1].is_some());
                places.extend(
                    found[0]
                        .clone()
                        .map(|it| (6, row.gait, axis, 0, it.implied)),
                );
            }
        }
        for (process, network) in PROCESSES.iter().zip(&NETWORKS) {
            for axis in 0..3 {
                let cells = [process.cells[axis], network.cells[axis]].concat();
                let found = checked(&cells).contradictions.into_iter().enumerate();
                let told = found.filter_map(|(cell, it)| {
                    let table = if cell < 2 { 8 } else { 9 };
                    Some((table, process.gait, axis, cell % 2, it?.implied))
                });
                places.extend(told);
            }
        }
        // Rounding of what is printed moves an implied R2 by 0.004 at most: 0.14 % of the deviation, twice, of a share about one.
        let expected = [
            (6, "1 Hz", 2, 0, None),
            (8, "low frequency", 1, 0, Some(0.170)),
            (9, "high frequency", 1, 0, Some(-0.1756)),
            (9, "high frequency", 1, 1, Some(-0.3304)),
            (8, "high frequency", 2, 1, Some(19.04)),
            (9, "gait transition", 0, 0, Some(-0.0594)),
        ];
        assert_eq!(places.len(), expected.len(), "{places:?}");
        for (found, expected) in places.iter().zip(expected) {
            let place =
                |it: &(u32, &'static str, usize, usize, Option<f64>)| (it.0, it.1, it.2, it.3);
            assert_eq!(place(found), place(&expected));
            let apart = found.4.zip(expected.4).map_or(0.0, |(a, b)| a - b);
            assert!(
                apart.abs() < 0.004 && found.4.is_some() == expected.4.is_some(),
                "{found:?}"
            );
        }
    }
}
