//! What a virtual rig on a study's tire shows.

use serde::{Deserialize, Serialize};

use crate::response_table::table_error::TableError;

/// What a virtual rig shows.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ForceFindings {
    /// The table of responses that the rig reads; absent where there is none.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub table: Option<TableReport>,
    /// Why something is missing, whole sentences.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub reasons: Vec<String>,
}

/// A table of a tire's responses to any contact.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct TableReport {
    /// Mesh level.
    pub level: String,
    /// The largest load, N.
    pub largest_load_n: f64,
    /// The largest shift of the ground at that load, along the wheel and across, mm; 0 where there is no friction.
    pub largest_shift_mm: f64,
    /// Solves, those that test it included.
    pub solves: usize,
    /// How far it is off; null where a load that tests it has no equilibrium.
    pub error: Option<TableError>,
}
