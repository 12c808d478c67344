//! The answer of a study: the result document, field by field.
//!
//! Numbers that do not exist are `None` (null in JSON) with a reason beside them.

use fem_client::solver::{MapShape, ModelSummary};
use gsa::misses::Misses;
use serde::{Deserialize, Serialize};

use crate::fidelity::FidelityReport;

/// The whole answer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct StudyResult {
    /// Which study.
    pub study: StudyIdentity,
    /// What was modelled.
    pub model: ModelSummary,
    /// What varied.
    pub inputs: Vec<InputReport>,
    /// Every location and direction with its indices.
    pub outputs: Vec<Output>,
    /// Ranked locations.
    pub locations: Vec<RankedLocation>,
    /// Ranked layouts.
    pub layouts: Vec<RankedLayout>,
    /// First-order indices over the dense grid, when asked for.
    pub map: Option<IndexMap>,
    /// What the user must know before believing the numbers, whole sentences.
    pub notes: Vec<String>,
    /// Points that have no equilibrium, with their causes; the indices are taken from the others.
    pub failed_points: Vec<FailedPoint>,
    /// The cut point's own response in short: reaction and strains at the means.
    pub cut_point: CutPoint,
    /// How the accuracy asked for was looked for; absent where a level was asked for.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub climb: Option<Climb>,
    /// What it took. Not part of the result's hash.
    pub cost: StudyCost,
    /// What it was expected to take when the run began; not part of the result's hash either. Absent where nobody asked.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub estimate: Option<Estimate>,
}

/// The way from a draft to the accuracy asked for.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Climb {
    /// Largest error of an index that was asked for.
    pub tolerance: Option<f64>,
    /// Wall-clock time that was allowed, s.
    pub budget_s: Option<f64>,
    /// Whether the claimed error is within the tolerance, or the budget gave an answer.
    pub met: bool,
    /// What was tried, in order; the answer is the last one's.
    pub rungs: Vec<ClimbRung>,
}

/// One step of the way.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ClimbRung {
    /// In a few words.
    pub label: String,
    /// Mesh and method.
    pub fidelity: FidelityReport,
    /// Solves, those on the coarser mesh included.
    pub solves: usize,
    /// Largest claimed error of an index at P1, P2, ..., absolute.
    pub error_claimed: Option<f64>,
    /// The mesh's part of it.
    pub error_of_mesh: Option<f64>,
}

/// Which study, which document, which program.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct StudyIdentity {
    /// Identifier in the database.
    pub id: String,
    /// Name from the document.
    pub name: String,
    /// SHA-256 of the canonical document.
    pub spec_sha256: String,
    /// Version of strainsite and its solver.
    pub version: String,
}

/// One input as it was understood.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct InputReport {
    /// Its name.
    pub name: String,
    /// Path of the scene's field.
    pub vary: String,
    /// Its distribution as in the document.
    #[cfg_attr(feature = "openapi", schema(value_type = Object))]
    pub distribution: serde_json::Value,
}

/// Indices of one strain.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Output {
    /// P1, P2, ...
    pub location: String,
    /// `x` circumferential, `y` meridional.
    pub direction: String,
    /// Mean strain.
    pub mean: Option<f64>,
    /// Standard deviation of the strain.
    pub std: Option<f64>,
    /// First-order index of each input.
    pub first_order: Option<Vec<f64>>,
    /// Total index of each input.
    pub total: Option<Vec<f64>>,
    /// Method that gave `first_order` and `total`: `mdrm` or `additive`.
    pub method: String,
    /// `ok`, `constant` or `product-form-broken`.
    pub status: String,
    /// Why the status is not `ok`.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
    /// What M-DRM said, when its product form is broken.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub mdrm_first_order: Option<Vec<f64>>,
    /// Error of the first-order indices, absolute.
    pub error: IndexError,
    /// The indices on a coarser mesh, where there is one.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub coarser: Option<CoarserIndices>,
    /// What the method's form misses at the check points, where it has any.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub misses: Option<FormMisses>,
}

/// Indices of the same points on a coarser mesh: the witness of the mesh's error, and of how much of it two studies share.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct CoarserIndices {
    /// First-order index of each input.
    pub first_order: Vec<f64>,
    /// What the finer mesh may be off, over its difference from the coarser one.
    pub factor: f64,
}

/// What a form misses at the check points: the witness of the method's error, and of how much of it two studies share.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct FormMisses {
    /// Which node of its input's rule each coordinate of each check point is, point after point.
    pub nodes: Vec<usize>,
    /// Strain minus the form's at each check point, over the standard deviation.
    pub residuals: Vec<f64>,
    /// What each of them adds to the error of a first-order index, input after input.
    pub contributions: Vec<f64>,
    /// Probability of the interactions, which the residuals stand for.
    pub weight: f64,
    /// How many numbers of the form were fitted to the check points.
    pub fitted: usize,
}

impl FormMisses {
    /// `None` where a number isn't finite: the form overflows there.
    pub(crate) fn of(misses: &Misses) -> Option<Self> {
        let mut numbers = misses.residuals.iter().chain(&misses.contributions);
        numbers.all(|number| number.is_finite()).then(|| Self {
            nodes: misses.nodes.clone(),
            residuals: misses.residuals.clone(),
            contributions: misses.contributions.clone(),
            weight: misses.weight,
            fitted: misses.fitted,
        })
    }

    /// As the analysis knows them.
    pub(crate) fn misses(&self) -> Misses {
        Misses {
            nodes: self.nodes.clone(),
            residuals: self.residuals.clone(),
            contributions: self.contributions.clone(),
            weight: self.weight,
            fitted: self.fitted,
        }
    }
}

/// Parts of the error of an index, absolute.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct IndexError {
    /// From the mesh.
    pub mesh: Option<f64>,
    /// From the quadrature rule.
    pub quadrature: Option<f64>,
    /// From the decomposition.
    pub decomposition: Option<f64>,
    /// Sum of the parts, the largest over the inputs; null where the mesh's part isn't known.
    pub total: Option<f64>,
    /// Why a part is null.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
}

impl IndexError {
    /// What quadrature and decomposition add, for comparisons on one mesh.
    pub(crate) fn of_method(&self) -> f64 {
        self.quadrature.unwrap_or(0.0) + self.decomposition.unwrap_or(0.0)
    }
}

/// One candidate location in the ranking.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct RankedLocation {
    /// P1, P2, ...
    pub name: String,
    /// The input that is this location's own: the depth of the station below it.
    #[serde(default)]
    pub input: Option<String>,
    /// 1 is best.
    pub rank: usize,
    /// 100 times the first-order index of this location's own depth for the x strain at the centre.
    pub gsi_x_percent: Option<f64>,
    /// The same for the y strain.
    pub gsi_y_percent: Option<f64>,
    /// Error of `gsi_x_percent`, percentage points.
    #[serde(default)]
    pub gsi_x_error_percent: Option<f64>,
    /// The same for y.
    #[serde(default)]
    pub gsi_y_error_percent: Option<f64>,
    /// Mean over the x strains at all locations.
    pub mean_gsi_x_percent: Option<f64>,
    /// Mean over the y strains at all locations.
    pub mean_gsi_y_percent: Option<f64>,
    /// For the x strain at this location itself.
    pub own_gsi_x_percent: Option<f64>,
    /// For the y strain at this location itself.
    pub own_gsi_y_percent: Option<f64>,
    /// What M-DRM said for `gsi_x_percent`, valid or not: the paper's Table 2 as the paper computed it.
    pub mdrm_gsi_x_percent: Option<f64>,
    /// The same for y.
    pub mdrm_gsi_y_percent: Option<f64>,
    /// Rank by the x strain alone.
    pub rank_x: Option<usize>,
    /// Rank by the y strain alone.
    pub rank_y: Option<usize>,
    /// Whether the errors leave no doubt about this rank.
    pub rank_certain: bool,
}

impl RankedLocation {
    /// Whether an index that it is ranked by has a known error.
    pub(crate) fn knows_error(&self) -> bool {
        self.gsi_x_error_percent
            .or(self.gsi_y_error_percent)
            .is_some()
    }
}

/// One layout in the ranking.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct RankedLayout {
    /// 1 is best.
    pub rank: usize,
    /// Angle between neighbouring units, degrees.
    pub spacing_deg: f64,
    /// Number of units.
    pub units: usize,
    /// Meridional position.
    pub position: String,
    /// Films of each unit.
    pub films: Vec<String>,
    /// Its scores.
    pub score: LayoutScore,
}

/// How well a layout sees the contact, over all angles at which it can touch down.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct LayoutScore {
    /// Strain of the film that sees most, at the contact angle where that is least.
    pub weakest_signal: Option<f64>,
    /// Cramer-Rao bound of the contact angle, worst angle, degrees.
    pub worst_angle_error_deg: Option<f64>,
    /// Cramer-Rao bound of the contact angle, root mean square over the angles, degrees.
    pub rms_angle_error_deg: Option<f64>,
    /// Cramer-Rao bound of a uniform depth, worst angle, mm.
    pub worst_depth_error_mm: Option<f64>,
    /// Noise of each film assumed for the bounds, strain.
    pub noise_strain: f64,
    /// Why numbers are null.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
}

/// First-order indices over the dense grid.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct IndexMap {
    /// Angles of the columns from the contact centre, degrees.
    pub theta_deg: Vec<f64>,
    /// Angles of the rows from the crown, degrees.
    pub phi_deg: Vec<f64>,
    /// One layer per direction.
    pub layers: Vec<MapLayer>,
    /// Where the points lie at the means; earlier versions kept nothing of it.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub shape: Option<MapShape>,
}

/// One direction of the map; all lists are rows x columns.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct MapLayer {
    /// `x` or `y`.
    pub direction: String,
    /// Strain at the cut point.
    pub strain: Vec<f64>,
    /// Standard deviation of the strain.
    pub std: Vec<Option<f64>>,
    /// First-order index per input, in the order of the inputs, each rows x columns.
    pub first_order: Vec<Vec<Option<f64>>>,
    /// Estimated error of the first-order indices, rows x columns.
    pub error: Vec<Option<f64>>,
    /// `ok`, `constant` or `product-form-broken`.
    pub status: Vec<String>,
}

/// A point without a response.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct FailedPoint {
    /// Ordinal in the plan.
    pub ordinal: usize,
    /// Input values.
    pub values: Vec<f64>,
    /// What happened.
    pub cause: String,
}

/// The response at the means.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct CutPoint {
    /// Input values.
    pub values: Vec<f64>,
    /// Vertical force, N.
    pub reaction_n: f64,
    /// Outer radius after inflation, mm.
    pub inflated_outer_radius_mm: f64,
    /// Strains at P1, P2, ...
    pub locations: Vec<fem_client::solver::LocationStrain>,
    /// Newton residuals of its load steps.
    pub residual_history: Vec<Vec<f64>>,
}

/// What a study took.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct StudyCost {
    /// Points of the plan.
    pub solves: usize,
    /// Points of the plan solved once more on a coarser mesh, for the error of the mesh.
    #[serde(default)]
    pub coarser_solves: usize,
    /// Solves that show what the model leaves out.
    #[serde(default)]
    pub effect_solves: usize,
    /// Wall-clock time of each rung of the climb, s.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub rungs_wall_s: Vec<f64>,
    /// Points taken from the archive instead of being solved.
    pub reused: usize,
    /// Newton iterations of all solves.
    pub newton_iterations: usize,
    /// Factorisations of all solves, without the tangent that the solves from one equilibrium share.
    #[serde(default)]
    pub factorisations: usize,
    /// Wall-clock time of this run, s.
    pub wall_s: f64,
    /// Processor time of this run's own threads, s; 0 where the system doesn't tell it.
    pub cpu_s: f64,
    /// Peak memory of the process, bytes.
    pub peak_memory_bytes: u64,
    /// Share of the solves' time in numeric factorisation.
    pub factorisation_share: f64,
    /// Share in substitutions with the factor, and in the contact solved between them.
    #[serde(default)]
    pub substitution_share: f64,
    /// Share in assembly.
    pub assembly_share: f64,
    /// Share in all the rest, and in solves that found no equilibrium.
    pub other_share: f64,
}

/// What a study is expected to cost, and to be worth.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Estimate {
    /// Equilibria to solve.
    pub solves: SolveForecast,
    /// Wall-clock time; null where `reason` says why.
    pub wall_s: Option<Forecast>,
    /// Largest resident memory of the process, bytes.
    pub peak_memory_bytes: u64,
    /// What the answer is expected to be worth.
    pub accuracy: ExpectedAccuracy,
    /// Solves at once.
    pub threads: usize,
    /// Solves of this database by which the times were corrected for this machine; 0: the times are those of another machine.
    pub measured_solves: usize,
    /// Why figures are ranges or null, whole sentences.
    pub reasons: Vec<String>,
}

/// Equilibria that are expected to be solved.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct SolveForecast {
    /// Points on the meshes of the answer and of the rungs before it.
    pub own: usize,
    /// The same points on coarser meshes, for the error of the mesh.
    pub coarser: usize,
    /// Solves that show what the model leaves out.
    pub effects: usize,
    /// How many of these the database has already: they cost nothing.
    pub known: usize,
    /// How many are left to solve.
    pub left: CountForecast,
}

/// A number of solves with its range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct CountForecast {
    /// At least.
    pub least: usize,
    /// As far as can be told.
    pub expected: usize,
    /// At most.
    pub most: usize,
}

/// A figure with its range.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Forecast {
    /// At least.
    pub least: f64,
    /// As far as can be told.
    pub expected: f64,
    /// At most.
    pub most: f64,
}

/// What studies of this kind were worth where that was measured: the largest error of the ten indices that the paper's study ranks by, absolute.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ExpectedAccuracy {
    /// Mesh and method of the answer, in a few words.
    pub fidelity: String,
    /// Difference from the finest reference.
    pub error_true: Option<f64>,
    /// What the answer claimed itself.
    pub error_claimed: Option<f64>,
    /// Why there are no figures.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
}
