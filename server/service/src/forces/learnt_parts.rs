//! Parts of a fit, as the database keeps them.

use store::StoreError;
use store::content::encode;
use store::queue::estimator_parts::Part;

use crate::forces::fit_process::Learnt;
use crate::wire::estimator_wire::{LeftOutForces, LeftOutRows};

/// Rows of a force that weren't learnt from, as they are kept to be plotted.
pub(crate) const MOST_LEFT_OUT: usize = 20_000;

/// Returns the parts as they are stored.
///
/// # Errors
/// A sentence, when a number isn't finite.
pub(crate) fn parts(learnt: &Learnt) -> Result<Vec<(Part, String)>, String> {
    let told = |error: StoreError| error.to_string();
    let left_out = LeftOutForces {
        forces: learnt.left_out.iter().map(thinned).collect(),
    };
    Ok(vec![
        (
            Part::Report,
            encode("a report", &learnt.report).map_err(told)?,
        ),
        (Part::Model, learnt.model.clone()),
        (
            Part::LeftOut,
            encode("rows that were left out", &left_out).map_err(told)?,
        ),
    ])
}

/// An even subset of the rows, where there are more than a plot can show.
fn thinned(rows: &LeftOutRows) -> LeftOutRows {
    let count = rows.time_s.len();
    let kept = count.min(MOST_LEFT_OUT);
    let places: Vec<usize> = (0..kept).map(|place| place * count / kept).collect();
    let of = |all: &[f64]| -> Vec<f64> { places.iter().map(|place| all[*place]).collect() };
    LeftOutRows {
        force: rows.force.clone(),
        run: places.iter().map(|place| rows.run[*place]).collect(),
        time_s: of(&rows.time_s),
        truth_n: of(&rows.truth_n),
        estimate_n: of(&rows.estimate_n),
        low_n: of(&rows.low_n),
        high_n: of(&rows.high_n),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_to_plot_are_an_even_subset() {
        let rows = |count: usize| LeftOutRows {
            force: "fz_n".to_owned(),
            run: vec![0; count],
            time_s: (0..count).map(|row| row as f64).collect(),
            truth_n: vec![1.0; count],
            estimate_n: vec![2.0; count],
            low_n: vec![0.0; count],
            high_n: vec![3.0; count],
        };
        for count in [0, 7, MOST_LEFT_OUT] {
            assert_eq!(thinned(&rows(count)), rows(count));
        }
        let few = thinned(&rows(4 * MOST_LEFT_OUT));
        assert_eq!(few.run.len(), MOST_LEFT_OUT);
        assert!(few.time_s.windows(2).all(|pair| pair[1] - pair[0] == 4.0));
    }
}
