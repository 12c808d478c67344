//! The answer of a study: the result document, field by field.
//!
//! Numbers that do not exist are `None` (null in JSON) with a reason beside them. What they say in a sentence is in [`answer`].

pub mod answer;
mod climb_report;
mod cost_forecast;
mod failed_point;
pub mod film;
mod index_map;
mod indexed_output;
pub(crate) mod layout_findings;
pub mod named;
mod ranked_layout;
mod ranked_location;
mod study_cost;

pub use answer::{
    Answer, Certainty, Grade, GradedNote, LayoutAnswer, LeftOut, PlaceAnswer, Surer, Topic,
};
pub use climb_report::{Climb, ClimbRung};
pub use cost_forecast::{CountForecast, Estimate, ExpectedAccuracy, Forecast, SolveForecast};
pub use failed_point::{Cause, FailedPoint};
use fem_client::solver::ModelSummary;
pub use film::film_place::FilmPlace;
pub use film::signal_words::{Claim, FilmModel, Holds, SignalAxis, Trend};
pub use film::{
    AskewError, ClaimRow, Contradiction, DeadFilmError, ElsewhereError, FilmAnglesReport, FilmPair,
    ForceError, ForceFindings, ForcePrice, PrintedFigures, PublishedRow, PublishedTables,
    RigFigures, SignalCurve, SignalError, SignalRow, Signals, SplitError, StressWidth, TableError,
    TableReport, TimeConstantRow, TrialError, WorstContact,
};
pub use index_map::{IndexMap, MapLayer};
pub use indexed_output::{CoarserIndices, FormMisses, IndexError, Output};
pub use layout_findings::{
    CandidateFilm, FrontLayout, Knee, LayoutFindings, LayoutLoad, LayoutSearch, LoadShear,
    OrderAgreement, StrainRing,
};
pub use ranked_layout::{
    AlikeContacts, DeadFilm, LayoutError, LayoutScore, LoadScore, RankedLayout, ShearError,
    ShearScore,
};
pub use ranked_location::RankedLocation;
use serde::{Deserialize, Serialize};
pub use study_cost::StudyCost;

/// The whole answer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct StudyResult {
    /// Which study.
    pub study: StudyIdentity,
    /// The answer in a sentence, and how sure it is; absent from results of earlier versions, and where nothing has a rank.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub answer: Option<Answer>,
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
    /// What the layouts show together; absent from results of earlier versions, and where no layouts are asked for.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub layout_findings: Option<LayoutFindings>,
    /// First-order indices over the dense grid, when asked for.
    pub map: Option<IndexMap>,
    /// Films' signals over load, pressure and contact angle; absent where the study asks for none.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub signals: Option<Signals>,
    /// What a virtual rig shows; absent where the study has none.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub forces: Option<ForceFindings>,
    /// What the user must know before believing the numbers, whole sentences: the texts of `graded_notes`.
    pub notes: Vec<String>,
    /// The same with what each does to the answer; empty in results of earlier versions.
    #[serde(default)]
    pub graded_notes: Vec<GradedNote>,
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

impl StudyResult {
    /// Adds a note, graded and plain.
    pub(crate) fn note(&mut self, note: GradedNote) {
        self.notes.push(note.text.clone());
        self.graded_notes.push(note);
    }
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

/// The response at the means.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct CutPoint {
    /// Input values.
    pub values: Vec<f64>,
    /// Vertical force, N.
    pub reaction_n: f64,
    /// How far the ground at the contact centre stands above the inflated outer radius, mm; absent from results of earlier versions.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub depth_mm: Option<f64>,
    /// Outer radius after inflation, mm.
    pub inflated_outer_radius_mm: f64,
    /// Strains at P1, P2, ...
    pub locations: Vec<fem_client::solver::LocationStrain>,
    /// Newton residuals of its load steps.
    pub residual_history: Vec<Vec<f64>>,
}
