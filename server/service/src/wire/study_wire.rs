//! The documents that the service answers with, and those that it takes.

use fem_client::document::fault::Fault;
use fem_client::solver::SolveProgress;
use placement::result::{
    CandidateFilm, Estimate, LayoutFindings, OrderAgreement, RankedLayout, RankedLocation,
};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use utoipa::ToSchema;

use crate::views::point_views::EvaluationView;
use store::queue::study_rows::{State, StudyRow};

/// A study in the queue, at work, or at its end. Times are RFC 3339, UTC.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct StudySummary {
    /// UUID, ordered by time.
    pub id: String,
    /// Name in lists: the document's, unless it was changed since.
    pub name: String,
    /// Where it stands.
    pub state: State,
    /// SHA-256 of the canonical document.
    pub spec_sha256: String,
    /// Points of its plan, as far as that is known.
    pub points_total: Option<i64>,
    /// Points that have an outcome.
    pub points_done: i64,
    /// Why it failed, a sentence.
    pub error: Option<String>,
    /// Those of higher priority go first, those of the same in turns.
    pub priority: i64,
    /// When it was submitted.
    pub created: String,
    /// When it was first started.
    pub started: Option<String>,
    /// When it ended.
    pub finished: Option<String>,
    /// When it was archived; null unless it is.
    pub archived: Option<String>,
}

impl StudySummary {
    /// What a row of the database says.
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
        }
    }
}

/// A study with its document and what was expected of it.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct StudyDetail {
    /// Where it stands.
    #[serde(flatten)]
    pub summary: StudySummary,
    /// The canonical document: every default filled in, the scene inline.
    #[schema(value_type = Object)]
    pub document: Value,
    /// What it is expected to take: as expected when it last started, or as revised since by what its own solves took; null before.
    pub estimate: Option<Estimate>,
    /// Hash of the result's content; null before there is one. The result's ETag.
    pub result_sha256: Option<String>,
    /// Whether what accuracy costs was measured for this document.
    pub trade_measured: bool,
    /// Identifier of the sweep that it is a design of; null for any other study.
    pub sweep: Option<String>,
}

/// One of the events that a stream consists of.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct StreamEvent {
    /// Its number, for `Last-Event-ID`; `solving` has none.
    pub id: String,
    /// What happened.
    pub event: String,
    /// A JSON object with `kind`, `time` and what else belongs to it.
    pub data: String,
}

/// How far one of the solves under way is.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, ToSchema)]
pub struct LiveSolve {
    /// Ordinal of its point in the plan.
    pub ordinal: usize,
    /// How far.
    #[serde(flatten)]
    pub progress: SolveProgress,
}

/// One page of studies, newest first.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct StudyPage {
    /// The studies.
    pub studies: Vec<StudySummary>,
    /// Where the next page begins; null on the last one.
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
    /// What they show together; absent from results of earlier versions, and where no layouts are asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub findings: Option<LayoutFindings>,
}

/// Kinds of film for layouts, by several criteria.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct Candidates {
    /// Every section angle and direction.
    pub candidates: Vec<CandidateFilm>,
    /// How far each two criteria order them alike.
    pub agreement: Vec<OrderAgreement>,
}

/// Solved points.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct Evaluations {
    /// In the order of the plan; those after it are the same on a coarser mesh, or on the next rung of a climb.
    pub evaluations: Vec<EvaluationView>,
}

/// One layer of the map; lists are rows x columns, all angles of the first row first.
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
    /// Total index of the input, without an error of its own; null unless it is asked for (`index=total`), and of results of earlier versions.
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
    /// What `scene = { preset = ... }` calls it.
    pub name: String,
    /// Its title.
    pub title: String,
    /// The document.
    #[schema(value_type = Object)]
    pub document: Value,
    /// What it is for.
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
    /// To be opened once, after the service's own address.
    pub path: String,
}

/// What a client is told when a request can't be answered: RFC 9457.
#[derive(Debug, Serialize, ToSchema)]
pub struct ProblemDocument {
    /// `about:blank`: the status says what kind of problem it is.
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

/// What varies, and what is asked. Ranges and defaults of single fields are in the faults of a refused document, which names every one of them.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct StudyDocument {
    /// Free text, not empty.
    pub name: String,
    /// The scene's tables inline, or a preset's name with whatever differs from it: `{"preset": "foot-tire", ...}`.
    #[schema(value_type = Object)]
    pub scene: Value,
    /// What varies.
    #[schema(min_items = 1)]
    pub inputs: Vec<InputDocument>,
    /// Where films may go.
    #[schema(nullable = false)]
    pub candidates: Option<CandidatesDocument>,
    /// Layouts to score.
    #[schema(nullable = false)]
    pub layouts: Option<LayoutsDocument>,
    /// How indices are computed.
    #[schema(nullable = false)]
    pub method: Option<MethodDocument>,
    /// Exactly one of `preset`, `tolerance` and `budget_s`.
    #[schema(nullable = false)]
    pub accuracy: Option<AccuracyDocument>,
    /// Films' signals over loads, pressures and contact angles; none where it is left out.
    #[schema(nullable = false)]
    pub signals: Option<SignalsDocument>,
    /// A virtual rig that steps on the tire; none where it is left out.
    #[schema(nullable = false)]
    pub rig: Option<RigDocument>,
}

/// One uncertain field of the scene.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct InputDocument {
    /// Unique.
    pub name: String,
    /// Path of a number of the scene, as `ground.depths_mm[0]`.
    pub vary: String,
    /// `kind` is uniform, normal, lognormal, exponential, gamma, weibull, beta, gumbel or triangular, beside it its parameters; any takes
    /// `truncate: [low, high]`.
    #[schema(value_type = Object)]
    pub distribution: Value,
}

/// Where films may go.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct CandidatesDocument {
    /// `P1-P5`
    #[schema(nullable = false)]
    pub points: Option<String>,
    /// `["x"]`, `["y"]` or both.
    #[schema(nullable = false)]
    pub directions: Option<Vec<String>>,
    /// `circumferential` and `meridional` numbers of points of the dense map, and `half_width_deg`.
    #[schema(value_type = Object, nullable = false)]
    pub grid: Option<Value>,
}

/// Layouts to score.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct LayoutsDocument {
    /// Angles between neighbouring units, degrees; each divides 360.
    #[schema(nullable = false)]
    pub spacings_deg: Option<Vec<f64>>,
    /// Numbers of units, beside those of the spacings.
    #[schema(nullable = false)]
    pub units: Option<Vec<u32>>,
    /// crown, shoulder, sidewall
    #[schema(nullable = false)]
    pub positions: Option<Vec<String>>,
    /// Section angles beside the positions', degrees from the crown.
    #[schema(nullable = false)]
    pub section_deg: Option<Vec<f64>>,
    /// Sets of directions of a unit's films: `"x"`, `"y"`, or an angle in degrees.
    #[schema(value_type = Vec<Vec<Value>>, nullable = false)]
    pub directions: Option<Value>,
    /// Whether units of several films are also scored with their films spread between the units.
    #[schema(nullable = false)]
    pub staggered: Option<bool>,
    /// Layouts film by film: `name`, and `films` with `theta_deg`, `phi_deg` and `angle_deg`.
    #[schema(value_type = Vec<Object>, nullable = false)]
    pub free: Option<Value>,
    /// How films are modelled: `bare` when left out, or `transfer`: glued on with their stiffness, by the transfer of two coupled solves, and read in volts.
    #[schema(nullable = false)]
    pub film: Option<String>,
    /// Length and width of all films, mm; points when left out, the glued film's with `transfer`.
    #[schema(nullable = false)]
    pub size_mm: Option<[f64; 2]>,
    /// Further lengths and widths that the candidates have, mm.
    #[schema(nullable = false)]
    pub candidate_sizes_mm: Option<Vec<[f64; 2]>>,
    /// Depths at which layouts are scored, mm; the mean one when left out.
    #[schema(nullable = false)]
    pub depths_mm: Option<Vec<f64>>,
    /// Forces in their place, N.
    #[schema(nullable = false)]
    pub loads_n: Option<Vec<f64>>,
    /// Noise of a film over the crown's largest signal; 0.02 when left out.
    #[schema(nullable = false)]
    pub noise_share: Option<f64>,
    /// Noise of a bare film, strain.
    #[schema(nullable = false)]
    pub noise_strain: Option<f64>,
    /// Noise of a glued film, V.
    #[schema(nullable = false)]
    pub noise_v: Option<f64>,
    /// Standard deviation of a film's gain, relative.
    #[schema(nullable = false)]
    pub gain_std: Option<f64>,
    /// Standard deviation of a film's place around the wheel, degrees.
    #[schema(nullable = false)]
    pub place_std_deg: Option<f64>,
    /// Whether every layout is also scored without the film whose loss costs most.
    #[schema(nullable = false)]
    pub dead: Option<bool>,
    /// Whether forces along the wheel and across it are unknown, too: takes ground with friction, and a solve of the whole tire for every load and mesh.
    #[schema(nullable = false)]
    pub shear: Option<bool>,
    /// Mesh level of the layouts' own solves; the study's, the standard at most, when left out.
    #[schema(nullable = false)]
    pub level: Option<String>,
    /// Layouts to search for: numbers of `films` among `slots`, `section_deg` and `directions`.
    #[schema(value_type = Object, nullable = false)]
    pub search: Option<Value>,
}

/// How indices are computed.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct MethodDocument {
    /// mdrm, bivariate, tensor, pce, saltelli or auto.
    #[schema(nullable = false)]
    pub kind: Option<String>,
    /// Gauss nodes of each input.
    #[schema(nullable = false)]
    pub nodes: Option<u32>,
    /// Points off the lines, for the error.
    #[schema(nullable = false)]
    pub check_points: Option<u32>,
    /// Points of pce, base points of saltelli.
    #[schema(nullable = false)]
    pub samples: Option<u32>,
    /// Of what is random.
    #[schema(nullable = false)]
    pub seed: Option<u64>,
    /// Largest error of an index at which auto stops.
    #[schema(nullable = false)]
    pub tolerance: Option<f64>,
    /// Most runs of auto.
    #[schema(nullable = false)]
    pub most_runs: Option<u32>,
}

/// What is asked of the answer: one of the three.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct AccuracyDocument {
    /// Level of the mesh: draft, coarse, standard or reference.
    #[schema(nullable = false)]
    pub preset: Option<String>,
    /// Largest error of any first-order index, absolute.
    #[schema(nullable = false)]
    pub tolerance: Option<f64>,
    /// Wall-clock time, s.
    #[schema(nullable = false)]
    pub budget_s: Option<f64>,
}

/// Over which loads, pressures and contact angles films are read, and which films.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct SignalsDocument {
    /// Loads at the tire's own pressure, N.
    #[schema(nullable = false, min_items = 1, max_items = 64)]
    pub loads_n: Option<Vec<f64>>,
    /// Internal pressures, MPa.
    #[schema(nullable = false, min_items = 1, max_items = 64)]
    pub pressures_mpa: Option<Vec<f64>>,
    /// Load of the pressures, N.
    #[schema(nullable = false)]
    pub at_load_n: Option<f64>,
    /// Load of the contact angles, N.
    #[schema(nullable = false)]
    pub contact_load_n: Option<f64>,
    /// Wheel angles from a film to the contact, degrees.
    #[schema(nullable = false, min_items = 1, max_items = 64)]
    pub contact_deg: Option<Vec<f64>>,
    /// crown, shoulder, sidewall
    #[schema(nullable = false, min_items = 1)]
    pub positions: Option<Vec<String>>,
    /// `["x"]`, `["y"]` or both.
    #[schema(nullable = false, min_items = 1)]
    pub directions: Option<Vec<String>>,
    /// bare, transfer, coupled
    #[schema(nullable = false, min_items = 1)]
    pub films: Option<Vec<String>>,
    /// A scene's `film` without its place: `theta_deg`, `phi_deg` and `angle_deg`.
    #[schema(value_type = Object, nullable = false)]
    pub film: Option<Value>,
    /// Tires beside the study's own.
    #[schema(nullable = false, max_items = 16)]
    pub tires: Option<Vec<FurtherTireDocument>>,
}

/// How a virtual rig steps, and what its films are wired to.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct RigDocument {
    /// `frequency` (`kind`: fixed, randomised or transition), `stances` or `run_s`, `contact_deg` and `load_n` (each least and greatest), `duty`, `shear_share`.
    #[schema(value_type = Object, nullable = false)]
    pub gait: Option<Value>,
    /// `kind` and the fields of a film's amplifier; `time_constant_s`, `bits`, `range_v`.
    #[schema(value_type = Object, nullable = false)]
    pub electronics: Option<Value>,
    /// `white_share`, `thermal_k`, `drift_share`, `drift_time_s`, `warming_k_per_min`, `gain_std`.
    #[schema(value_type = Object, nullable = false)]
    pub noise: Option<Value>,
    /// `rate_hz`, `offset_s`, `ppm`, `noise_n`.
    #[schema(value_type = Object, nullable = false)]
    pub force_sensor: Option<Value>,
    /// Prony branches of the rubber: `share` and `time_s` of each.
    #[schema(value_type = Vec<Object>, nullable = false, max_items = 8)]
    pub relaxation: Option<Vec<Value>>,
    /// Whether films relax as the force does.
    #[schema(nullable = false)]
    pub films_follow_force: Option<bool>,
    /// Readings of each film a second, Hz.
    #[schema(nullable = false)]
    pub film_rate_hz: Option<f64>,
    /// Runs, each with gains of its own.
    #[schema(nullable = false, minimum = 1, maximum = 1000)]
    pub runs: Option<u64>,
    /// Of all that is drawn.
    #[schema(nullable = false)]
    pub seed: Option<u64>,
    /// Whether the published study's tables are made, too; it needs its layout among the study's.
    #[schema(nullable = false)]
    pub paper_tables: Option<bool>,
    /// Tires that estimators are tried on, too: `level`, `wall_factor`, `pressure_factor`, `friction_factor`, and whether they are `learnt` from.
    #[schema(value_type = Vec<Object>, nullable = false, max_items = 4)]
    pub other_tires: Option<Vec<Value>>,
}

/// A tire beside the study's own.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct FurtherTireDocument {
    /// Like no other's, and not `own`.
    pub name: String,
    /// As a study's scene.
    #[schema(value_type = Object)]
    pub scene: Value,
    /// Its own loads, where they differ from the signals', N.
    #[schema(nullable = false, min_items = 1, max_items = 64)]
    pub loads_n: Option<Vec<f64>>,
    /// Its own pressures, MPa.
    #[schema(nullable = false, min_items = 1, max_items = 64)]
    pub pressures_mpa: Option<Vec<f64>>,
    /// Its own load of the pressures, N.
    #[schema(nullable = false)]
    pub at_load_n: Option<f64>,
    /// Its own load of the contact angles, N.
    #[schema(nullable = false)]
    pub contact_load_n: Option<f64>,
}
