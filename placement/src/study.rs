//! The study document: what varies, what is asked.

use fem_client::scene::{Level, Scene};
use fem_client::solver::{Grid, Position};
use gsa::distribution::Distribution;

/// A checked study. Build it with `Study::from_document`.
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    /// Free text, not empty.
    pub name: String,
    /// The scene at the inputs' means is this scene with the inputs' means put in.
    pub scene: Scene,
    /// What varies.
    pub inputs: Vec<Input>,
    /// Dense map of candidates; absent: P1-P5 alone.
    pub grid: Option<Grid>,
    /// Layouts to score.
    pub layouts: Layouts,
    /// How indices are computed.
    pub method: Method,
    /// How finely the scene is modelled.
    pub level: Level,
}

/// One uncertain field of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// Unique name, P1 to P5 in the paper's study.
    pub name: String,
    /// Path of the scene's field, as `ground.depths_mm[0]`.
    pub vary: String,
    /// Its distribution.
    pub distribution: Distribution,
}

/// Layouts to score.
#[derive(Debug, Clone, PartialEq)]
pub struct Layouts {
    /// Angles between neighbouring units, degrees; each divides 360.
    pub spacings_deg: Vec<f64>,
    /// Meridional positions of the units.
    pub positions: Vec<Position>,
}

/// How indices are computed.
#[derive(Debug, Clone, PartialEq)]
pub struct Method {
    /// Only `mdrm` so far.
    pub kind: MethodKind,
    /// Gauss nodes per input.
    pub nodes: usize,
    /// Off-axis points at which the decomposition is checked.
    pub check_points: usize,
    /// Seed of the check points.
    pub seed: u64,
}

/// Ways to compute indices.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MethodKind {
    /// Multiplicative dimension reduction over Gauss quadrature.
    Mdrm,
}
