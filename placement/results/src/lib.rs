//! The answer of a study: the result document, field by field.
//!
//! Numbers that do not exist are `None` (null in JSON) with a reason beside them. What they say in a sentence is in [`answer`].

pub mod answer;
mod climb_report;
pub mod columns;
mod cost_forecast;
mod failed_point;
pub mod film;
mod index_map;
mod indexed_output;
mod layout_findings;
pub mod location_scores;
pub mod named;
mod ranked_layout;
mod ranked_location;
mod study_cost;

pub use answer::{
    Answer, AssumptionChange, AssumptionFindings, Certainty, Grade, GradedNote, InputShare,
    InputsAnswer, InputsBeside, LayoutAnswer, LeftOut, PlaceAnswer, RestsOn, SheetFilm,
    SignalsAnswer, Surer, Topic, TradeAnswer, TradeRow,
};
pub use climb_report::{Climb, ClimbRung, FidelityReport};
pub use cost_forecast::{CountForecast, Estimate, ExpectedAccuracy, Forecast, SolveForecast};
pub use failed_point::{Cause, FailedPoint, Unsolved};
use fem_client::solver::ModelSummary;
pub use film::{
    AlikeError, AskewError, Claim, ClaimRow, DeadFilmError, DriftError, ElsewhereError,
    FilmAnglesReport, FilmPair, ForceError, ForceFindings, ForcePrice, Holds, SignalAxis,
    SignalCurve, SignalError, SignalRow, Signals, SplitError, StressWidth, TableError, TableReport,
    Trend, TrialError, WorstContact,
};
pub use index_map::{IndexMap, MapLayer};
pub use indexed_output::{CoarserIndices, FormMisses, IndexError, Output};
pub use layout_findings::{
    CandidateFilm, ContactFindings, FrontLayout, Knee, LayoutFindings, LayoutLoad, LayoutSearch,
    LoadShear, MenuFindings, StrainRing,
};
pub use ranked_layout::{
    AlikeContacts, ContactError, DeadFilm, ErrorSources, LayoutError, LayoutScore, LoadScore,
    RankedLayout, ShearError, ShearScore, ToldQuantity, WorstForce,
};
pub use ranked_location::RankedLocation;
use serde::{Deserialize, Serialize};
pub use study_cost::StudyCost;

/// The whole answer.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct StudyResult {
    /// Identity of the study.
    pub study: StudyIdentity,
    /// The answer in a sentence, and how sure it is; absent where nothing has a rank.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub answer: Option<Answer>,
    /// Model that was solved.
    pub model: ModelSummary,
    /// Inputs that varied.
    pub inputs: Vec<InputReport>,
    /// Every location and direction with its indices.
    pub outputs: Vec<Output>,
    /// Ranked locations.
    pub locations: Vec<RankedLocation>,
    /// Ranked layouts.
    pub layouts: Vec<RankedLayout>,
    /// Findings of the layouts together; absent where no layouts are asked for.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub layout_findings: Option<LayoutFindings>,
    /// First-order indices over the dense grid, when asked for.
    pub map: Option<IndexMap>,
    /// Films' signals over load, pressure and contact angle; absent where the study asks for none.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub signals: Option<Signals>,
    /// Findings of a virtual rig; absent where the study has none.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub forces: Option<ForceFindings>,
    /// Notes that the user must know before believing the numbers, whole sentences: the texts of `graded_notes`.
    pub notes: Vec<String>,
    /// Notes with what each does to the answer.
    pub graded_notes: Vec<GradedNote>,
    /// Points that have no equilibrium, with their causes; the indices are taken from the others.
    pub failed_points: Vec<FailedPoint>,
    /// The cut point's own response in short: reaction and strains at the means.
    pub cut_point: CutPoint,
    /// Climb to the accuracy asked for; absent where a level was asked for.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub climb: Option<Climb>,
    /// Cost of the study. Not part of the result's hash.
    pub cost: StudyCost,
    /// Estimate of the cost when the run began; not part of the result's hash either. Absent where nobody asked.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub estimate: Option<Estimate>,
}

impl StudyResult {
    /// Adds a note, graded and plain.
    pub fn note(&mut self, note: GradedNote) {
        self.notes.push(note.text.clone());
        self.graded_notes.push(note);
    }

    /// The first layout of a rank.
    pub fn layout_of_rank(&self, rank: usize) -> Option<&RankedLayout> {
        self.layouts.iter().find(|layout| layout.rank == rank)
    }
}

/// Identity of a study: which document, which program.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
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

/// An input as it was understood.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct InputReport {
    /// Name of the input.
    pub name: String,
    /// Path of the scene's field.
    pub vary: String,
    /// Distribution as in the document.
    #[schema(value_type = Object)]
    pub distribution: serde_json::Value,
}

/// The response at the means.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct CutPoint {
    /// Input values.
    pub values: Vec<f64>,
    /// Vertical force, N.
    pub reaction_n: f64,
    /// Height of the ground at the contact centre above the inflated outer radius, mm.
    pub depth_mm: f64,
    /// Outer radius after inflation, mm.
    pub inflated_outer_radius_mm: f64,
    /// Strains at P1, P2, ...
    pub locations: Vec<fem_client::solver::LocationStrain>,
    /// Newton residuals of its load steps.
    pub residual_history: Vec<Vec<f64>>,
}
