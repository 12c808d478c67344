//! A campaign from its first point to its last.

use gsa::analysis::Analysis;
use gsa::campaign::Campaign;
use ndarray::Array2;

/// Asks and tells until the campaign has enough; its answer, and the runs it took.
pub fn until_enough(mut campaign: Campaign, model: impl Fn(&[f64]) -> f64) -> (Analysis, usize) {
    loop {
        let values: Vec<f64> = campaign.points().iter().map(|x| model(x)).collect();
        let values = Array2::from_shape_vec((values.len(), 1), values).expect("a column");
        let found = campaign
            .tell(&values.view())
            .expect("rules exist")
            .remove(0);
        if campaign.points().len() == values.nrows() {
            return (found, values.nrows());
        }
    }
}
