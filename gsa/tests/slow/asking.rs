//! A campaign from its first point to its last.

use gsa::campaign::Campaign;
use gsa::method::analysis::Analysis;
use ndarray::Array2;

/// Asks and tells until the campaign has enough; its answer, and the runs it took.
pub fn until_enough(campaign: Campaign, model: impl Fn(&[f64]) -> f64) -> (Analysis, usize) {
    let (found, campaign) = to_the_end(campaign, |_, x| model(x));
    (found, campaign.points().len())
}

/// Asks and tells until the campaign has enough, with runs that may depend on the point's ordinal; its answer, and the campaign
/// at its end.
pub fn to_the_end(
    mut campaign: Campaign,
    run: impl Fn(usize, &[f64]) -> f64,
) -> (Analysis, Campaign) {
    loop {
        let points = campaign.points().iter().enumerate();
        let values: Vec<f64> = points.map(|(ordinal, x)| run(ordinal, x)).collect();
        let values = Array2::from_shape_vec((values.len(), 1), values).expect("a column");
        let found = campaign
            .tell(&values.view())
            .expect("rules exist")
            .remove(0);
        if campaign.points().len() == values.nrows() {
            return (found, campaign);
        }
    }
}
