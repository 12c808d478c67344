//! The one trait between the product and any solver.

pub mod gauge;
pub mod solve_error;
pub mod start_state;

use std::sync::atomic::AtomicBool;

use serde::{Deserialize, Serialize};

use crate::scene::{Level, Scene};
use crate::solver::gauge::{Gauge, GaugeReading};
pub use crate::solver::solve_error::{NoEquilibrium, Reached, SolveError};

/// Answers for one equilibrium of a scene.
pub trait Solver: Send + Sync {
    /// Name and version, part of the key under which results are stored.
    fn version(&self) -> String;

    /// A coarser level on which the same scene shows what its own level misses; `None` where there is none.
    fn coarser(&self, _scene: &Scene) -> Option<Coarser> {
        None
    }

    /// What its model of the scene leaves out and could have.
    fn omissions(&self, _scene: &Scene) -> Vec<Omission> {
        Vec::new()
    }

    /// Cells between the nodes of its mesh in a quarter of the tire: what a solve's time and memory follow from.
    fn cells(&self, scene: &Scene) -> usize {
        scene.model.level.cells_of_reference_tire()
    }

    /// Whether the law of solve times in `placement` was fitted to it.
    fn has_time_law(&self) -> bool {
        false
    }

    /// Solves one equilibrium.
    ///
    /// The response is a function of scene and readout up to the solver's tolerance, and to the bit of scene, readout
    /// and start together.
    ///
    /// # Errors
    /// See [`SolveError`]; only [`SolveError::Broken`] is worth a retry at once.
    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError>;
}

/// What is asked of a solver.
#[derive(Clone, Copy)]
pub struct SolveRequest<'a> {
    /// What is pressed, and how.
    pub scene: &'a Scene,
    /// Where the strain is read.
    pub readout: &'a Readout,
    /// A neighbouring equilibrium to start from, as an earlier solve returned it.
    pub start: Option<&'a StartState>,
    /// Set to true by the caller to end the solve at the next Newton iteration.
    pub stop: &'a AtomicBool,
}

/// A coarser level as a witness of a finer one's error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coarser {
    /// The coarser level.
    pub level: Level,
    /// What the finer level may be off, over its difference from the coarser one.
    pub factor: f64,
}

/// A part of reality that a scene's model doesn't have.
#[derive(Debug, Clone, PartialEq)]
pub struct Omission {
    /// The part.
    pub what: &'static str,
    /// The reason.
    pub why: String,
    /// The same scene with that part in a typical size; `None` where no scene can have it, or where it doesn't fit this one.
    pub richer: Option<Scene>,
}

/// Where the strain is read, beside P1-P5 and the section points that every response has.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Readout {
    /// Dense map of the inner surface; absent: no map.
    pub grid: Option<Grid>,
    /// Where the map's points lie, too: a picture needs it of one point of a study, and no other grows by it.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub shape: bool,
    /// Lines around the wheel at these meridional positions.
    pub rings: Vec<Position>,
    /// Single points, each with a direction.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub gauges: Vec<Gauge>,
}

/// A regular grid on the inner surface, centred on the contact, both ends included.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Grid {
    /// Points along the circumference, odd.
    pub circumferential: usize,
    /// Points from bead to bead, odd.
    pub meridional: usize,
    /// Half of the circumferential extent, degrees.
    pub half_width_deg: f64,
}

/// Named meridional positions of a film.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Position {
    /// 0 degrees from the crown.
    Crown,
    /// 45 degrees from the crown.
    Shoulder,
    /// 90 degrees from the crown.
    Sidewall,
}

impl Position {
    /// Meridional angle from the crown, degrees.
    pub fn angle_deg(self) -> f64 {
        match self {
            Self::Crown => 0.0,
            Self::Shoulder => 45.0,
            Self::Sidewall => 90.0,
        }
    }
}

/// What a solve gives: the answer, its price, and the state from which a neighbour may start.
#[derive(Debug, Clone)]
pub struct Solved {
    /// The answer; the same bits for the same request.
    pub response: Response,
    /// What it took; varies from run to run.
    pub cost: Cost,
    /// The equilibrium itself.
    pub state: StartState,
}

/// Strains, forces and diagnostics of one equilibrium.
///
/// Strains are stretches relative to the inflated state minus one, on the inner surface; x circumferential,
/// y meridional.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Response {
    /// Vertical force of the ground on the whole tire, N.
    pub reaction_n: f64,
    /// P1, P2, ... in order.
    pub locations: Vec<LocationStrain>,
    /// Crown, shoulder and sidewall above the contact centre.
    pub section: Section,
    /// The inflated state before contact.
    pub inflated: Inflated,
    /// Estimated discretisation errors of the readout.
    pub error: ResponseError,
    /// Largest |J - 1| of an element's mean.
    pub max_volume_change: f64,
    /// Newton iterations of all load steps of this solve.
    pub newton_iterations: usize,
    /// Residual norms relative to the forces of the problem, one list per load step.
    pub residual_history: Vec<Vec<f64>>,
    /// What was modelled.
    pub model: ModelSummary,
    /// The dense map, when asked for.
    pub map: Option<StrainMap>,
    /// One ring per position asked for, in the order asked.
    pub rings: Vec<Ring>,
    /// One reading per gauge asked for, in the order asked.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub gauges: Vec<GaugeReading>,
    /// State of the textile layer; absent without one.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub carcass: Option<CarcassState>,
    /// State of the film; absent without one.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub film: Option<FilmState>,
}

/// Strain at a named location.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct LocationStrain {
    /// P1, P2, ...
    pub name: String,
    /// Angle from the contact centre, degrees, positive in the rolling direction.
    pub theta_deg: f64,
    /// Circumferential strain.
    pub strain_x: f64,
    /// Meridional strain.
    pub strain_y: f64,
    /// Von Mises stress of the rubber at the inner surface, MPa.
    pub von_mises_mpa: f64,
    /// Estimated discretisation errors; absent when the solver has no estimate.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub error: Option<LocationError>,
}

/// Estimated discretisation errors at a location, absolute: see [`crate::solver::gauge::GaugeError`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct LocationError {
    /// Of the circumferential strain.
    pub strain_x: f64,
    /// Of the meridional strain.
    pub strain_y: f64,
    /// Of the von Mises stress, MPa.
    pub von_mises_mpa: f64,
}

/// Least and greatest values over the whole textile layer.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct CarcassState {
    /// Stretch of the fibres.
    pub fibre_stretch: Extremes,
    /// Tension along the fibres: force per reference length across a family, N/mm; negative in compression.
    pub tension_n_per_mm: Extremes,
}

/// Least and greatest values over the whole film, relative to its unstressed state in the undeformed tire.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct FilmState {
    /// Circumferential stretch.
    pub stretch_x: Extremes,
    /// Meridional stretch.
    pub stretch_y: Extremes,
    /// Circumferential tension (second Piola-Kirchhoff), N/mm.
    pub tension_x_n_per_mm: Extremes,
    /// Meridional tension (second Piola-Kirchhoff), N/mm.
    pub tension_y_n_per_mm: Extremes,
}

/// Least and greatest value of a field.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Extremes {
    /// Least value.
    pub min: f64,
    /// Greatest value.
    pub max: f64,
}

impl Extremes {
    /// The range without values.
    pub const NONE: Self = Self {
        min: f64::INFINITY,
        max: f64::NEG_INFINITY,
    };

    /// Widens the range to a value.
    pub fn include(&mut self, value: f64) {
        self.min = self.min.min(value);
        self.max = self.max.max(value);
    }
}

/// Strains over the section above the contact centre.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Section {
    /// 0 degrees from the crown.
    pub crown: StrainPair,
    /// 45 degrees from the crown.
    pub shoulder: StrainPair,
    /// 90 degrees from the crown.
    pub sidewall: StrainPair,
}

/// Circumferential and meridional strain.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct StrainPair {
    /// Circumferential strain.
    pub strain_x: f64,
    /// Meridional strain.
    pub strain_y: f64,
}

/// The inflated tire before contact.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Inflated {
    /// Outer radius at the crown, mm.
    pub outer_radius_mm: f64,
    /// Circumferential stretch at the crown's inner surface.
    pub crown_stretch_x: f64,
    /// Meridional stretch at the crown's inner surface.
    pub crown_stretch_y: f64,
}

/// Estimated errors: absolute, of the largest reported value of each kind.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ResponseError {
    /// Contact penetration's share of the reaction, N.
    pub reaction_n: f64,
    /// Largest error of the circumferential strain at P1-P5.
    pub strain_x: f64,
    /// Largest error of the meridional strain at P1-P5.
    pub strain_y: f64,
}

/// What was modelled and what was left out.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ModelSummary {
    /// `3d`, `3d-half` or `3d-quarter`.
    pub dimension: String,
    /// Mesh level.
    pub level: String,
    /// Number of solid elements.
    pub elements: usize,
    /// Free displacement unknowns.
    pub dofs: usize,
    /// Parts of the scene in the model.
    pub modelled: Vec<Choice>,
    /// Parts of the scene left out.
    pub left_out: Vec<Choice>,
}

/// One modelling choice with its reason.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Choice {
    /// The part.
    pub what: String,
    /// The reason.
    pub why: String,
    /// What leaving it out does: the largest change of a strain at P1, P2, ... at the means when it is modelled, over the largest strain
    /// of that direction there. 0 where leaving it out is exact; absent where the part is modelled, or the effect isn't known.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub effect: Option<f64>,
}

/// Strains on a regular grid, row by row: all circumferential points of the first meridional angle first.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StrainMap {
    /// Circumferential angles of the columns, degrees.
    pub theta_deg: Vec<f64>,
    /// Meridional angles of the rows from the crown, degrees.
    pub phi_deg: Vec<f64>,
    /// Circumferential strain, rows x columns.
    pub strain_x: Vec<f64>,
    /// Meridional strain, rows x columns.
    pub strain_y: Vec<f64>,
    /// Where its points lie, when asked for.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub shape: Option<MapShape>,
}

/// Where the points of a map lie: x in the rolling direction, y along the axle, z upward, from the wheel's centre.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct MapShape {
    /// Positions in the inflated state before contact, mm, rows x columns.
    pub inflated_mm: Vec<[f64; 3]>,
    /// Displacements from there to the equilibrium, mm, rows x columns.
    pub displacement_mm: Vec<[f64; 3]>,
}

/// Strains around the whole wheel at one meridional position.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Ring {
    /// Where the ring lies.
    pub position: Position,
    /// Angles from -180 (included) to 180 (excluded), one degree apart.
    pub theta_deg: Vec<f64>,
    /// Circumferential strain.
    pub strain_x: Vec<f64>,
    /// Meridional strain.
    pub strain_y: Vec<f64>,
}

/// What a solve took.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Cost {
    /// Wall-clock time, s.
    pub wall_s: f64,
    /// Time in numeric factorisation, s.
    pub factorisation_s: f64,
    /// Time in substitutions with the factor, and in the contact solved between them, s.
    #[serde(default)]
    pub substitution_s: f64,
    /// Time in assembly of residual and tangent, s.
    pub assembly_s: f64,
    /// Newton iterations.
    pub newton_iterations: usize,
    /// Numeric factorisations; the tangent shared by the solves of a study isn't counted.
    #[serde(default)]
    pub factorisations: usize,
}

/// An equilibrium from which a neighbour may start: opaque, but it survives storage bit for bit.
#[derive(Debug, Clone, PartialEq)]
pub struct StartState {
    /// Says which inflated problem `inflated` solves; the solver's own business.
    pub inflated_key: String,
    /// Unknowns of the inflated state.
    pub inflated: Vec<f64>,
    /// Internal pressure of the equilibrium, MPa.
    pub pressure_mpa: f64,
    /// Station depths of the equilibrium, mm.
    pub depths_mm: Vec<f64>,
    /// Unknowns of the equilibrium.
    pub equilibrium: Vec<f64>,
}
