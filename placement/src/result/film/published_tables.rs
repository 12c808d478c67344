//! The published study's tables of force errors, beside what a virtual rig shows under the same conditions.

use estimation::recipe::{FeatureSet, Kind, SplitKind};
use serde::{Deserialize, Serialize};

use super::force_error::TrialError;

/// Tables 4, 5, 6, 8 and 9 of the published study and the rig's figures for the same rows, with one layout: six units every 60 degrees at the crown.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct PublishedTables {
    /// Rank of the layout.
    pub layout_rank: usize,
    /// All rows, in the order of the tables.
    pub rows: Vec<PublishedRow>,
    /// The same layout's forces with other time constants of its circuit. The published study states none.
    pub time_constants: Vec<TimeConstantRow>,
    /// What was done where the published study doesn't say what it did, whole sentences.
    pub assumed: Vec<String>,
}

/// One figure of the published study beside the rig's.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct PublishedRow {
    /// Number of the published table.
    pub table: u32,
    /// The gait: `randomised`, `1 Hz`, `low frequency` or the like.
    pub gait: String,
    /// The model.
    pub model: Kind,
    /// The features it reads.
    pub features: FeatureSet,
    /// `fx`: along the wheel, `fy`: across it, `fz`: vertical.
    pub axis: String,
    /// What the rig's model is tested by: `random` readings, later `time`, or another `run`, whose films have other gains.
    pub by: SplitKind,
    /// As it was printed.
    pub printed: PrintedFigures,
    /// As the rig has it; null where nothing was learnt.
    pub rig: Option<RigFigures>,
    /// The rig's model on a run with other gains; null where that is what `rig` has.
    pub fresh: Option<RigFigures>,
    /// Why numbers are null.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
}

/// Figures as the published study prints them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct PrintedFigures {
    /// RMSE over the range of the tested forces, %.
    pub nrmse_percent: f64,
    /// Root of the mean squared error, N.
    pub rmse_n: Option<f64>,
    /// Coefficient of determination.
    pub r2: Option<f64>,
    /// What the mean of the tested forces would have reached, by what the three figures imply, %.
    pub mean_nrmse_percent: Option<f64>,
    /// Where the figures contradict those of the same tested forces in other cells.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub contradiction: Option<Contradiction>,
}

/// A figure that can't be true beside the others.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Contradiction {
    /// Which figure: `r2`, `nrmse_percent`, or `both` where two cells contradict each other and none tells which is right.
    pub figure: String,
    /// What the other cells and this one's RMSE imply; null where none tells.
    pub implied: Option<f64>,
    /// A sentence.
    pub detail: String,
}

/// Figures of a virtual rig.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct RigFigures {
    /// Root of the mean squared error, N.
    pub rmse_n: f64,
    /// RMSE over the range of the tested forces, %.
    pub nrmse_percent: Option<f64>,
    /// What the mean of the learnt forces would have reached, %.
    pub mean_nrmse_percent: Option<f64>,
    /// Coefficient of determination.
    pub r2: Option<f64>,
}

/// A layout's force on runs with other gains, with another time constant.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct TimeConstantRow {
    /// s
    pub time_constant_s: f64,
    /// `fx`, `fy` or `fz`.
    pub axis: String,
    /// The model that was chosen.
    pub chosen: Kind,
    /// Its error.
    pub error: TrialError,
}
