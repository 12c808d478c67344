//! Indices of models that others run: the answer of `/v1/analyses`, and of `strainsite gsa analyse`.

use documents::own_model::own_analysis::OwnAnalysis;
use gsa::method::analysis::{Analysis, Status};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Inputs of a model of your own, and the values of its outputs so far: its schema is that of the document.
#[derive(Debug, ToSchema)]
pub struct AnalysisDocument;

/// Indices as far as the values tell, and the points that are still to be run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct ModelAnalysis {
    /// Names of the inputs.
    pub inputs: Vec<String>,
    /// Outputs with their indices; none while the method's first points lack values.
    pub outputs: Vec<ModelOutput>,
    /// Points that have values.
    pub evaluations: usize,
    /// Points that are still to be run; 0 at the end.
    pub wanted: usize,
    /// Points that are still to be run.
    pub points: ModelPoints,
    /// Advice, a sentence, where the indices say little or points are missing.
    pub advice: Option<String>,
}

/// Points of a model, each a value of every input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct ModelPoints {
    /// Number of each point, by which its values are sent.
    pub ids: Vec<usize>,
    /// Values of the inputs at each point, in the inputs' units.
    pub rows: Vec<Vec<f64>>,
}

/// Indices of an output, one an input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct ModelOutput {
    /// Name of the output.
    pub name: String,
    /// Mean, in the output's units.
    pub mean: Option<f64>,
    /// Variance, in the output's units squared.
    pub variance: Option<f64>,
    /// First-order index of each input: its share of the variance alone.
    pub first_order: Option<Vec<f64>>,
    /// Total index of each input: its share with all that it interacts in.
    pub total: Option<Vec<f64>>,
    /// Share of each pair of inputs alone, in the order 12, 13, .., 23, ..; null where the method has none.
    pub second_order: Option<Vec<f64>>,
    /// End of the analysis: `ok`, `constant`, `product-form-broken` or `unusable`.
    pub status: String,
    /// Reason why a number is missing, and what else a reader should know.
    pub reason: Option<String>,
    /// Form behind the indices.
    pub method: String,
    /// First-order indices of the product form where it is broken.
    pub mdrm_first_order: Option<Vec<f64>>,
    /// Total indices of the product form where it is broken.
    pub mdrm_total: Option<Vec<f64>>,
    /// Errors of the first-order indices.
    pub error: ModelIndexError,
}

/// Errors of first-order indices: what they are off by at most, in all and in parts.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct ModelIndexError {
    /// Error of the nodes' number.
    pub quadrature: Option<f64>,
    /// Error of the form.
    pub decomposition: Option<f64>,
    /// Error of the sample.
    pub sampling: Option<f64>,
    /// Share of the variance that is rounding of doubles.
    pub floor: f64,
    /// Error of runs that failed.
    pub lost: Option<f64>,
    /// Error of digits that weren't printed.
    pub rounding: Option<f64>,
    /// Error of the worst index, all parts together.
    pub total: Option<f64>,
    /// Error of each input's index.
    pub by_input: Option<Vec<f64>>,
}

impl ModelAnalysis {
    /// Makes the answer of an analysis.
    pub fn of(analysis: &OwnAnalysis<'_>) -> Self {
        let ids = analysis.wanted();
        let points = analysis.points().iter().enumerate();
        let wanted = points.filter(|(id, _)| !analysis.values().has(*id));
        let outputs = analysis.values().outputs().iter();
        let outputs = outputs.zip(analysis.found().unwrap_or_default());
        Self {
            inputs: analysis.inputs().to_vec(),
            outputs: outputs.map(|(name, found)| output(name, found)).collect(),
            evaluations: analysis.values().points(),
            wanted: ids.len(),
            points: ModelPoints {
                ids,
                rows: wanted.map(|(_, x)| x.clone()).collect(),
            },
            advice: analysis.advice(),
        }
    }
}

fn output(name: &str, found: &Analysis) -> ModelOutput {
    let broken = found.status == Status::ProductFormBroken;
    let mdrm = |indices: &Option<Vec<f64>>| indices.clone().filter(|_| broken);
    ModelOutput {
        name: name.to_owned(),
        mean: found.mean,
        variance: found.variance,
        first_order: found.first_order.clone(),
        total: found.total.clone(),
        second_order: found.second_order.clone(),
        status: found.status.as_str().to_owned(),
        reason: found.reason.clone(),
        method: found.method.as_str().to_owned(),
        mdrm_first_order: mdrm(&found.mdrm_first_order),
        mdrm_total: mdrm(&found.mdrm_total),
        error: errors(found),
    }
}

fn errors(found: &Analysis) -> ModelIndexError {
    let (error, indexed) = (&found.error, found.first_order.is_some());
    ModelIndexError {
        quadrature: error.quadrature.filter(|_| indexed),
        decomposition: error.decomposition.filter(|_| indexed),
        sampling: error.sampling,
        floor: error.floor,
        lost: error.lost.filter(|_| indexed),
        rounding: error.rounding.filter(|_| indexed),
        total: error.total.filter(|_| indexed),
        by_input: error.by_input.clone().filter(|_| indexed),
    }
}
