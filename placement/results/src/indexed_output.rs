//! Indices of one strain, and how far each is off.

use fem_client::solver::direction::Direction;
use gsa::judge::misses::Misses;
use gsa::method::analysis::{Form, Status};
use serde::{Deserialize, Serialize};

use crate::named;

/// Indices of one strain.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Output {
    /// P1, P2, ...
    pub location: String,
    /// `x` circumferential, `y` meridional.
    #[schema(value_type = String)]
    pub direction: Direction,
    /// Mean strain.
    pub mean: Option<f64>,
    /// Standard deviation of the strain.
    pub std: Option<f64>,
    /// First-order index of each input.
    pub first_order: Option<Vec<f64>>,
    /// Total index of each input.
    pub total: Option<Vec<f64>>,
    /// Form that gave `first_order` and `total`: `mdrm`, `additive`, `shifted`, `corrected`, `bivariate`, `tensor`, `pce` or `saltelli`.
    #[serde(with = "named")]
    #[schema(value_type = String)]
    pub method: Form,
    /// `ok`, `constant`, `product-form-broken` or `unusable`.
    #[serde(with = "named")]
    #[schema(value_type = String)]
    pub status: Status,
    /// Reason why the status isn't `ok`.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
    /// Indices that M-DRM gave, when its product form is broken.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub mdrm_first_order: Option<Vec<f64>>,
    /// Error of the first-order indices, absolute.
    pub error: IndexError,
    /// The indices on a coarser mesh, where there is one.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub coarser: Option<CoarserIndices>,
    /// Misses of the method's form at the check points, where it has any.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub misses: Option<FormMisses>,
}

/// Indices of the same points on a coarser mesh: the witness of the mesh's error, and of how much of it two studies share.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct CoarserIndices {
    /// First-order index of each input.
    pub first_order: Vec<f64>,
    /// Error of the finer mesh over its difference from the coarser one.
    pub factor: f64,
}

/// Misses of a form at the check points: the witness of the method's error, and of how much of it two studies share.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct FormMisses {
    /// Number of the node of its input's rule at each coordinate of each check point, point after point.
    pub nodes: Vec<usize>,
    /// Strain minus the form's at each check point, over the standard deviation.
    pub residuals: Vec<f64>,
    /// Contributions of each of them to the error of a first-order index, input after input.
    pub contributions: Vec<f64>,
    /// Probability of the interactions, which the residuals stand for.
    pub weight: f64,
    /// Count of the form's numbers that were fitted to the check points.
    pub fitted: usize,
    /// Number of each check point's mirror image, whose strains are its own from the other end; absent where contact or inputs aren't symmetric.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub images: Vec<usize>,
}

impl FormMisses {
    /// Converts them; `None` where a number isn't finite: the form overflows there.
    pub fn of(misses: &Misses) -> Option<Self> {
        let mut numbers = misses.residuals.iter().chain(&misses.contributions);
        numbers.all(|number| number.is_finite()).then(|| Self {
            nodes: misses.nodes.clone(),
            residuals: misses.residuals.clone(),
            contributions: misses.contributions.clone(),
            weight: misses.weight,
            fitted: misses.fitted,
            images: misses.images.clone(),
        })
    }

    /// Returns the misses as the analysis knows them.
    pub fn misses(&self) -> Misses {
        Misses {
            nodes: self.nodes.clone(),
            residuals: self.residuals.clone(),
            contributions: self.contributions.clone(),
            weight: self.weight,
            fitted: self.fitted,
            images: self.images.clone(),
        }
    }
}

/// Parts of the error of an index, absolute.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct IndexError {
    /// Error of the mesh.
    pub mesh: Option<f64>,
    /// Error of the quadrature rule.
    pub quadrature: Option<f64>,
    /// Error of the decomposition.
    pub decomposition: Option<f64>,
    /// Sum of the parts, the largest over the inputs; null where the mesh's part isn't known.
    pub total: Option<f64>,
    /// Reason why a part is null.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
}

impl IndexError {
    /// Returns what quadrature and decomposition add, for comparisons on one mesh.
    pub fn of_method(&self) -> f64 {
        self.quadrature.unwrap_or(0.0) + self.decomposition.unwrap_or(0.0)
    }
}
