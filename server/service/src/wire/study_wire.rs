//! The documents that the service answers with, and those that it takes.

use document::fault::Fault;
use fem_client::solver::{LocationStrain, Reached, SolveProgress};
use results::{CandidateFilm, Estimate, LayoutFindings, RankedLayout, RankedLocation};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use utoipa::ToSchema;

use store::queue::study_rows::{State, StudyRow};

/// A study in the queue, at work, or at its end. Times are RFC 3339, UTC.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct StudySummary {
    /// UUID, ordered by time.
    pub id: String,
    /// Name in lists: the document's, unless it was changed since.
    pub name: String,
    /// State of the study.
    pub state: State,
    /// SHA-256 of the canonical document.
    pub spec_sha256: String,
    /// Points of its plan, as far as that is known.
    pub points_total: Option<i64>,
    /// Points that have an outcome.
    pub points_done: i64,
    /// Reason why it failed, a sentence.
    pub error: Option<String>,
    /// Priority: studies of higher ones go first, those of the same in turns.
    pub priority: i64,
    /// Time at which it was submitted.
    pub created: String,
    /// Time at which it was first started.
    pub started: Option<String>,
    /// Time at which it ended.
    pub finished: Option<String>,
    /// Time at which it was archived; null unless it is.
    pub archived: Option<String>,
    /// The answer in few characters, as in `12 y films, 10.7 degrees`; null before there is one.
    pub brief: Option<String>,
}

impl StudySummary {
    /// Reads what a row of the database says.
    pub fn of(study: &StudyRow) -> Self {
        Self {
            id: study.id.clone(),
            name: study.name.clone(),
            state: study.state(),
            spec_sha256: study.spec_sha256.clone(),
            points_total: study.points_total,
            points_done: study.points_done,
            error: study.error.clone(),
            priority: study.priority,
            created: study.created.clone(),
            started: study.started.clone(),
            finished: study.finished.clone(),
            archived: study.archived.clone(),
            brief: study.brief.clone(),
        }
    }
}

/// A study with its document and what was expected of it.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct StudyDetail {
    /// Summary of the study.
    #[serde(flatten)]
    pub summary: StudySummary,
    /// The canonical document: every default filled in, the scene inline.
    #[schema(value_type = Object)]
    pub document: Value,
    /// Estimate of its cost: as expected when it last started, or as revised since by what its own solves took; null before.
    pub estimate: Option<Estimate>,
    /// Hash of the result's content; null before there is one. The result's ETag.
    pub result_sha256: Option<String>,
    /// Whether what accuracy costs was measured for this document.
    pub trade_measured: bool,
    /// Identifier of the sweep that it is a design of; null for any other study.
    pub sweep: Option<String>,
}

/// An event of a stream.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct StreamEvent {
    /// Number of the event, for `Last-Event-ID`; `solving` has none.
    pub id: String,
    /// Kind of event.
    pub event: String,
    /// A JSON object with `kind`, `time` and what else belongs to it.
    pub data: String,
}

/// A solve under way.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, ToSchema)]
pub struct LiveSolve {
    /// Ordinal of its point in the plan.
    pub ordinal: usize,
    /// Progress of the solve.
    #[serde(flatten)]
    pub progress: SolveProgress,
}

/// A page of studies, newest first.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct StudyPage {
    /// The studies.
    pub studies: Vec<StudySummary>,
    /// Cursor of the next page; null on the last one.
    pub next_cursor: Option<String>,
}

/// Ranked locations.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct Locations {
    /// Best first.
    pub locations: Vec<RankedLocation>,
}

/// Ranked layouts.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct Layouts {
    /// Best first.
    pub layouts: Vec<RankedLayout>,
    /// Findings of the layouts together; absent where no layouts are asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub findings: Option<LayoutFindings>,
}

/// Kinds of film for layouts, by several criteria.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct Candidates {
    /// Every section angle and direction.
    pub candidates: Vec<CandidateFilm>,
}

/// A point that has an outcome.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct EvaluationView {
    /// Ordinal of the point in the plan.
    pub ordinal: usize,
    /// Hash of all that determines its outcome.
    pub key: String,
    /// Mesh level.
    pub level: Option<String>,
    /// The inputs' values; null when its scene hasn't one of them.
    pub values: Option<Vec<f64>>,
    /// Vertical force, N; null without an equilibrium.
    pub reaction_n: Option<f64>,
    /// Height of the ground at the contact centre above the inflated outer radius, mm; absent without an equilibrium.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub depth_mm: Option<f64>,
    /// Strains at P1, P2, ...; null without an equilibrium.
    pub locations: Option<Vec<LocationStrain>>,
    /// Newton iterations; null without an equilibrium.
    pub newton_iterations: Option<usize>,
    /// Wall-clock time of the solve, s.
    pub wall_s: f64,
    /// Reason why there is no equilibrium.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
    /// Loads of the last equilibrium before.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reached: Option<Reached>,
}

/// Solved points.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct Evaluations {
    /// Points in the order of the plan; those after it are the same on a coarser mesh, or on the next rung of a climb.
    pub evaluations: Vec<EvaluationView>,
}

/// A layer of the map; lists are rows x columns, all angles of the first row first.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct MapView {
    /// x circumferential, y meridional.
    pub direction: String,
    /// Name of the input.
    pub input: String,
    /// Angles of the columns from the contact centre, degrees.
    pub theta_deg: Vec<f64>,
    /// Angles of the rows from the crown, degrees.
    pub phi_deg: Vec<f64>,
    /// First-order index of the input.
    pub first_order: Option<Vec<Option<f64>>>,
    /// Total index of the input, without an error of its own; null unless it is asked for (`index=total`).
    pub total: Option<Vec<Option<f64>>>,
    /// Standard deviation of the strain.
    pub std: Vec<Option<f64>>,
    /// Strain at the means.
    pub strain: Vec<f64>,
    /// Error of the first-order index, absolute.
    pub error: Vec<Option<f64>>,
    /// `ok`, `constant`, `product-form-broken` or `unusable`.
    pub status: Vec<String>,
}

/// The documents that ship.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct Presets {
    /// Whole studies.
    pub studies: Vec<Preset>,
    /// Scenes alone.
    pub scenes: Vec<Preset>,
}

/// A document to start from.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct Preset {
    /// Name in `scene = { preset = ... }`.
    pub name: String,
    /// Title of the scene.
    pub title: String,
    /// The document.
    #[schema(value_type = Object)]
    pub document: Value,
    /// Purpose of the scene.
    pub comment: String,
}

/// The service answers.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct Health {
    /// `ok`
    pub status: String,
    /// Version of the program.
    pub version: String,
}

/// The service can work.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct Readiness {
    /// `ready`
    pub status: String,
}

/// An address that lets a browser in.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct LoginLink {
    /// Path to be opened once, after the service's own address.
    pub path: String,
}

/// Problem that a client is told when a request can't be answered: RFC 9457.
#[derive(Debug, Serialize, ToSchema)]
pub struct ProblemDocument {
    /// Kind of problem: `about:blank`, the status says it.
    pub r#type: String,
    /// The status in words.
    pub title: String,
    /// The HTTP status.
    pub status: u16,
    /// A sentence for people.
    pub detail: String,
    /// Every fault of the document, with its JSON pointer.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub errors: Vec<Fault>,
    /// The request's identifier, as in the header `x-request-id` and in the log.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub request_id: Option<String>,
}

/// A study: its schema is that of the document.
#[derive(Debug, ToSchema)]
pub struct StudyDocument;
