//! The indices over the inner surface.

use fem_client::solver::MapShape;
use fem_client::solver::direction::Direction;
use gsa::method::analysis::Status;
use serde::{Deserialize, Serialize};

use crate::named;

/// First-order indices over the dense grid.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct IndexMap {
    /// Angles of the columns from the contact centre, degrees.
    pub theta_deg: Vec<f64>,
    /// Angles of the rows from the crown, degrees.
    pub phi_deg: Vec<f64>,
    /// Layers, one per direction.
    pub layers: Vec<MapLayer>,
    /// Places of the points at the means.
    pub shape: MapShape,
}

/// A direction of the map; all lists are rows x columns.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct MapLayer {
    /// `x` or `y`.
    #[schema(value_type = String)]
    pub direction: Direction,
    /// Strain at the cut point.
    pub strain: Vec<f64>,
    /// Standard deviation of the strain.
    pub std: Vec<Option<f64>>,
    /// First-order index per input, in the order of the inputs, each rows x columns.
    pub first_order: Vec<Vec<Option<f64>>>,
    /// Estimated error of the first-order indices, the largest over the inputs, rows x columns.
    pub error: Vec<Option<f64>>,
    /// Estimated error of the first-order index per input, in the order of the inputs, each rows x columns.
    pub first_order_error: Vec<Vec<Option<f64>>>,
    /// Total index per input, in the order of the inputs, each rows x columns: without errors of their own.
    pub total: Vec<Vec<Option<f64>>>,
    /// `ok`, `constant`, `product-form-broken` or `unusable`, rows x columns.
    #[serde(with = "named::list")]
    #[schema(value_type = Vec<String>)]
    pub status: Vec<Status>,
}
