//! Responses to indices per output: the strains at P1, P2, ... and those of the dense map, in one analysis.

use fem_client::solver::{Response, StrainMap};
use gsa::analysis::Analysis;
use gsa::campaign::Campaign;
use ndarray::Array2;

use crate::archive::Outcome;
use crate::result::{IndexError, IndexMap, MapLayer, Output};

/// Why no index has an error of the mesh.
pub const NO_MESH_ERROR: &str =
    "the mesh error of an index needs a second mesh level, which this version doesn't run";

/// Strain directions: circumferential and meridional.
pub const DIRECTIONS: [&str; 2] = ["x", "y"];

/// Indices of every output of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct Scores {
    /// P1 x, P1 y, P2 x, ...
    pub outputs: Vec<Output>,
    /// M-DRM's indices of these outputs, wherever they exist, whether they hold or not.
    pub mdrm_first_order: Vec<Option<Vec<f64>>>,
    /// Error of each first-order index of these outputs.
    pub index_errors: Vec<Option<Vec<f64>>>,
    /// Indices over the dense map, when the responses have one.
    pub map: Option<IndexMap>,
}

/// The outputs of all points, a row each: locations first, then the map. A point without an equilibrium has a row of NaN.
///
/// # Panics
/// If the responses differ in their readout.
pub fn values(outcomes: &[Outcome]) -> Array2<f64> {
    let columns = outcomes
        .iter()
        .flatten()
        .next()
        .map_or(0, |first| strains(first).len());
    let row = |outcome: &Outcome| match outcome {
        Ok(response) => strains(response),
        Err(_) => vec![f64::NAN; columns],
    };
    let rows: Vec<Vec<f64>> = outcomes.iter().map(row).collect();
    let values = Array2::from_shape_vec((rows.len(), columns), rows.concat());
    values.expect("every response has the same readout")
}

/// Scores the outcomes at the points of a campaign, in its order; `cut` is the response of its first point.
///
/// # Panics
/// If there is not one outcome for each point, or the responses differ in their readout.
pub fn score(campaign: &Campaign, cut: &Response, outcomes: &[Outcome]) -> Scores {
    assert_eq!(
        outcomes.len(),
        campaign.points().len(),
        "one outcome for each point"
    );
    let analyses = campaign
        .analyse(&values(outcomes).view())
        .expect("a campaign that asked for points has the rules to analyse them");
    let (at_locations, over_map) = analyses.split_at(2 * cut.locations.len());
    let names = cut
        .locations
        .iter()
        .flat_map(|l| DIRECTIONS.map(|d| (&l.name, d)));
    Scores {
        outputs: names
            .zip(at_locations)
            .map(|((name, d), a)| output(name, d, a))
            .collect(),
        mdrm_first_order: at_locations
            .iter()
            .map(|a| a.mdrm_first_order.clone())
            .collect(),
        index_errors: at_locations
            .iter()
            .map(|a| a.error.by_input.clone().filter(|_| a.first_order.is_some()))
            .collect(),
        map: cut
            .map
            .as_ref()
            .map(|map| index_map(map, campaign.inputs().len(), over_map)),
    }
}

/// The outputs of one point: locations first, then the map's x layer and y layer.
fn strains(response: &Response) -> Vec<f64> {
    let mut strains: Vec<f64> = response
        .locations
        .iter()
        .flat_map(|location| [location.strain_x, location.strain_y])
        .collect();
    if let Some(map) = &response.map {
        strains.extend_from_slice(&map.strain_x);
        strains.extend_from_slice(&map.strain_y);
    }
    strains
}

fn std(analysis: &Analysis) -> Option<f64> {
    analysis.variance.map(f64::sqrt)
}

fn output(location: &str, direction: &str, analysis: &Analysis) -> Output {
    let broken = analysis.status == gsa::analysis::Status::ProductFormBroken;
    Output {
        location: location.to_owned(),
        direction: direction.to_owned(),
        mean: analysis.mean,
        std: std(analysis),
        first_order: analysis.first_order.clone(),
        total: analysis.total.clone(),
        method: analysis.method.as_str().to_owned(),
        status: analysis.status.as_str().to_owned(),
        reason: analysis.reason.clone(),
        mdrm_first_order: analysis.mdrm_first_order.clone().filter(|_| broken),
        error: index_error(analysis),
    }
}

fn index_error(analysis: &Analysis) -> IndexError {
    let missing = |part: Option<f64>, why: &str| part.is_none().then(|| why.to_owned());
    let reasons = [
        Some(NO_MESH_ERROR.to_owned()),
        missing(
            analysis.error.quadrature,
            "the rule has too few nodes to show its own error",
        ),
        missing(
            analysis.error.decomposition,
            "there are no check points to show the error of the decomposition",
        ),
    ];
    let indexed = analysis.first_order.is_some();
    IndexError {
        mesh: None,
        quadrature: analysis.error.quadrature.filter(|_| indexed),
        decomposition: analysis.error.decomposition.filter(|_| indexed),
        total: analysis.error.total.filter(|_| indexed),
        reason: Some(if indexed {
            reasons.into_iter().flatten().collect::<Vec<_>>().join("; ")
        } else {
            "there are no indices to have an error".to_owned()
        }),
    }
}

fn index_map(map: &StrainMap, inputs: usize, analyses: &[Analysis]) -> IndexMap {
    let (x, y) = analyses.split_at(map.strain_x.len());
    IndexMap {
        theta_deg: map.theta_deg.clone(),
        phi_deg: map.phi_deg.clone(),
        layers: vec![
            layer("x", &map.strain_x, x, inputs),
            layer("y", &map.strain_y, y, inputs),
        ],
    }
}

fn layer(direction: &str, strain: &[f64], analyses: &[Analysis], inputs: usize) -> MapLayer {
    let index = |input: usize| {
        analyses
            .iter()
            .map(move |a| a.first_order.as_ref().map(|indices| indices[input]))
            .collect()
    };
    MapLayer {
        direction: direction.to_owned(),
        strain: strain.to_vec(),
        std: analyses.iter().map(std).collect(),
        first_order: (0..inputs).map(index).collect(),
        error: analyses
            .iter()
            .map(|a| a.error.total.filter(|_| a.first_order.is_some()))
            .collect(),
        status: analyses
            .iter()
            .map(|a| a.status.as_str().to_owned())
            .collect(),
    }
}
