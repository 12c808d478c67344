//! Fields of films around the wheel, as exactly as layouts are scored by them.

use serde::{Deserialize, Serialize};

/// Signals of every kind of film at every load of a study's layouts.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct FilmFields {
    /// Unit of the signals: `strain`, or `V` of glued films.
    pub unit: String,
    /// Length and width of every film, mm; null: points.
    pub size_mm: Option<[f64; 2]>,
    /// Errors of a reading.
    pub noise: FilmNoise,
    /// Kinds of film; the lists of a load are in their order.
    pub kinds: Vec<FilmKindPlace>,
    /// Loads that were reached.
    pub loads: Vec<FieldLoad>,
}

/// Errors of a film's reading: the variance of one of signal h is floor² + (gain h)² + (place dh/du)².
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct FilmNoise {
    /// Standard deviation whatever the signal, in its unit.
    pub floor: f64,
    /// Standard deviation of the gain, relative.
    pub gain_std: f64,
    /// Standard deviation of the film's place around the wheel, degrees.
    pub place_std_deg: f64,
}

/// Place of a film in the section, and how it is turned.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct FilmKindPlace {
    /// Section angle from the crown, degrees.
    pub phi_deg: f64,
    /// Angle of its length to the circumferential direction, degrees: 0 is x, 90 is y.
    pub angle_deg: f64,
}

/// Fields of films at one load.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct FieldLoad {
    /// Height of the ground above the inflated outer radius, mm.
    pub depth_mm: f64,
    /// Vertical force, N.
    pub load_n: Option<f64>,
    /// Derivative of the force by the depth, N/mm.
    pub force_slope_n_per_mm: f64,
    /// Signal of each kind: a sample for each degree from the contact to the film, from -180 on.
    pub signals: Vec<Vec<f64>>,
    /// Derivative of the signals by the depth, per mm: as many samples.
    pub slopes_per_mm: Vec<Vec<f64>>,
    /// Variance of the signals over contacts as they come, beside that of the noise: as many samples; absent where contacts don't differ.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub variances: Vec<Vec<f64>>,
}
