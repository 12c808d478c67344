//! Findings of a virtual rig on a study's tire.

use serde::{Deserialize, Serialize};

/// Findings of a virtual rig.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ForceFindings {
    /// The table of responses that the rig reads; absent where there is none.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub table: Option<TableReport>,
    /// Prices of a force's error: for each force the layouts by which it is known better than by any with as many films or fewer.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub price: Vec<ForcePrice>,
    /// Assumptions on the rig that no source states, whole sentences; empty where nothing was learnt.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub assumed: Vec<String>,
    /// Reasons why something is missing, whole sentences.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub reasons: Vec<String>,
}

/// A layout that knows a force better than all that have as many films or fewer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ForcePrice {
    /// `fx`: along the wheel, `fy`: across it, `fz`: vertical.
    pub axis: String,
    /// Count of the layout's films.
    pub films: usize,
    /// Root of the mean squared error on runs that nobody learnt from, N.
    pub rmse_n: f64,
    /// The layout's rank.
    pub layout_rank: usize,
}

/// A table of a tire's responses to any contact.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct TableReport {
    /// Mesh level.
    pub level: String,
    /// The largest load, N.
    pub largest_load_n: f64,
    /// The largest shift of the ground at that load, along the wheel and across, mm; 0 where there is no friction.
    pub largest_shift_mm: f64,
    /// Solves, those that test it included.
    pub solves: usize,
    /// Error of the table; null where a load that tests it has no equilibrium.
    pub error: Option<TableError>,
    /// Wheel angles of glued films as an axis; absent for films that resist nothing.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub films: Option<FilmAnglesReport>,
}

/// Glued films solved with the tire around the wheel, on undragged ground; errors are over the largest signal of their kind.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct FilmAnglesReport {
    /// Mesh level of the tire with a film.
    pub level: String,
    /// Angles from the contact, degrees; films that lie askew on both sides of it.
    pub angles_deg: Vec<f64>,
    /// Loads, N.
    pub loads_n: Vec<f64>,
    /// Solves between them that tested the signals; 0 where none did, or where one of them has no equilibrium.
    pub tested: usize,
    /// Root mean square of their signals' errors; null where nothing was tested.
    pub signal_rms: Option<f64>,
    /// The largest; null where nothing was tested.
    pub signal_worst: Option<f64>,
    /// The largest error of a transfer alone, which is solved for films above the contact.
    pub transfer_worst: f64,
}

/// Errors of a table over all kinds of film, wheel angles and tested solves, relative.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct TableError {
    /// Solves that it was tested by.
    pub solves: usize,
    /// Root mean square of a signal's error, over the largest signal of its kind.
    pub signal_rms: f64,
    /// The largest.
    pub signal_worst: f64,
    /// Root mean square of the error of a slope over the wheel angle, over the largest of its kind.
    pub angle_slope_rms: f64,
    /// The largest.
    pub angle_slope_worst: f64,
    /// Root mean square of the error of a slope over the depth, over the largest of its kind.
    pub depth_slope_rms: f64,
    /// The largest.
    pub depth_slope_worst: f64,
    /// The largest error of a force's component, over the largest load.
    pub force_worst: f64,
}
