//! The documents of sweeps: those that go in, and those that come out.

use placement::result::{CountForecast, Estimate, Forecast};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use utoipa::ToSchema;

use crate::wire::study_wire::{StudyDocument, StudySummary};
use crate::wire::sweep_state::state_of;
use store::StoreError;
use store::queue::study_rows::State;
use store::queue::sweep_rows::{DesignRow, SweepRow};

/// A study, and what its designs set otherwise: `grid` or `designs`.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct SweepDocument {
    /// Free text; the study's name when left out.
    #[schema(nullable = false)]
    pub name: Option<String>,
    /// The study without changes.
    pub study: StudyDocument,
    /// Lists of values by path, as `{"geometry.wall_mm": [2.5, 3]}`: every combination is a design, the last path varying fastest.
    #[schema(value_type = Object, nullable = false)]
    pub grid: Option<Value>,
    /// The designs one by one.
    #[schema(nullable = false)]
    pub designs: Option<Vec<DesignDocument>>,
}

/// Further designs of a sweep: `grid` or `designs`.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct FurtherDesigns {
    /// Lists of values by path.
    #[schema(value_type = Object, nullable = false)]
    pub grid: Option<Value>,
    /// The designs one by one.
    #[schema(nullable = false)]
    pub designs: Option<Vec<DesignDocument>>,
}

/// One design.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct DesignDocument {
    /// What it sets when left out, as `wall_mm = 2.5`.
    #[schema(nullable = false)]
    pub name: Option<String>,
    /// Values by path: `geometry.wall_mm` for the scene's fields, `method.nodes` for the study's own.
    #[schema(value_type = Object)]
    pub set: Value,
}

/// A sweep as far as it is. Times are RFC 3339, UTC.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct SweepSummary {
    /// UUID, ordered by time.
    pub id: String,
    /// Name in lists: as it was submitted, unless it was changed since.
    pub name: String,
    /// `queued` before any design is begun, `running` while some aren't ended, `cancelled` when any was, `done` when any has a result.
    pub state: State,
    /// Designs by where they stand.
    pub counts: DesignCounts,
    /// Points of all designs, once all of their plans are known.
    pub points_total: Option<i64>,
    /// Points that have an outcome.
    pub points_done: i64,
    /// Priority of its studies.
    pub priority: i64,
    /// When it was submitted.
    pub created: String,
    /// When its last design ended.
    pub finished: Option<String>,
    /// When it was archived; null unless it is.
    pub archived: Option<String>,
}

/// Designs by where they stand.
#[derive(Debug, Default, Serialize, Deserialize, ToSchema)]
pub struct DesignCounts {
    /// Wait for their turn.
    pub queued: usize,
    /// Are being solved.
    pub running: usize,
    /// Have a result.
    pub done: usize,
    /// Have none, and their study says why.
    pub failed: usize,
    /// Were cancelled.
    pub cancelled: usize,
}

/// A sweep with its designs.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct SweepDetail {
    /// How far it is.
    #[serde(flatten)]
    pub summary: SweepSummary,
    /// The canonical document of the study without changes.
    #[schema(value_type = Object)]
    pub document: Value,
    /// The designs in order.
    pub designs: Vec<DesignView>,
}

/// One of the designs.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct DesignView {
    /// Its place.
    pub ordinal: i64,
    /// What tells it from the others.
    pub name: String,
    /// Values by path.
    #[schema(value_type = Object)]
    pub set: Value,
    /// The study that answers for it.
    pub study: StudySummary,
}

/// One page of sweeps, newest first.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct SweepPage {
    /// The sweeps.
    pub sweeps: Vec<SweepSummary>,
    /// Where the next page begins; null on the last one.
    pub next_cursor: Option<String>,
}

/// What a sweep would cost.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct SweepEstimate {
    /// Each design; what an earlier one solves is known to it.
    pub designs: Vec<DesignEstimate>,
    /// Solves left of all designs.
    pub left: CountForecast,
    /// Wall-clock time of all; null where a design's reasons say why.
    pub wall_s: Option<Forecast>,
    /// Largest memory of any design, bytes.
    pub peak_memory_bytes: u64,
}

/// What a design would cost.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct DesignEstimate {
    /// What tells it from the others.
    pub name: String,
    /// Its estimate.
    pub estimate: Estimate,
}

impl SweepSummary {
    /// What the rows of the database say.
    pub fn of(sweep: &SweepRow, designs: &[DesignRow]) -> Self {
        let states = designs.iter().map(|design| design.study.state());
        let count = |state: State| states.clone().filter(|other| *other == state).count();
        let ended = designs.iter().all(|design| design.study.ended());
        let finished = designs.iter().filter_map(|d| d.study.finished.as_ref());
        Self {
            id: sweep.id.clone(),
            name: sweep.name.clone(),
            state: state_of(states.clone()),
            counts: DesignCounts {
                queued: count(State::Queued),
                running: count(State::Running),
                done: count(State::Done),
                failed: count(State::Failed),
                cancelled: count(State::Cancelled),
            },
            points_total: designs.iter().map(|d| d.study.points_total).sum(),
            points_done: designs.iter().map(|d| d.study.points_done).sum(),
            priority: sweep.priority,
            created: sweep.created.clone(),
            finished: finished.max().filter(|_| ended).cloned(),
            archived: sweep.archived.clone(),
        }
    }
}

impl SweepDetail {
    /// What the rows of the database say.
    ///
    /// # Errors
    /// When the document in them is damaged.
    pub fn of(sweep: &SweepRow, designs: &[DesignRow]) -> Result<Self, StoreError> {
        let view = |design: &DesignRow| DesignView {
            ordinal: design.ordinal,
            name: design.name.clone(),
            set: Value::Object(design.set.clone()),
            study: StudySummary::of(&design.study),
        };
        Ok(Self {
            summary: SweepSummary::of(sweep, designs),
            document: serde_json::from_str(sweep.document()?).unwrap_or(Value::Null),
            designs: designs.iter().map(view).collect(),
        })
    }
}

impl SweepEstimate {
    /// The sum of its designs, which run one after the other.
    pub fn of(designs: Vec<DesignEstimate>) -> Self {
        let estimates = || designs.iter().map(|design| &design.estimate);
        let solves = |part: fn(&CountForecast) -> usize| -> usize {
            estimates().map(|e| part(&e.solves.left)).sum()
        };
        let time = |part: fn(&Forecast) -> f64| -> Option<f64> {
            estimates().map(|e| e.wall_s.as_ref().map(part)).sum()
        };
        let wall_s = || {
            Some(Forecast {
                least: time(|wall| wall.least)?,
                expected: time(|wall| wall.expected)?,
                most: time(|wall| wall.most)?,
            })
        };
        Self {
            left: CountForecast {
                least: solves(|left| left.least),
                expected: solves(|left| left.expected),
                most: solves(|left| left.most),
            },
            wall_s: wall_s(),
            peak_memory_bytes: estimates().map(|e| e.peak_memory_bytes).max().unwrap_or(0),
            designs,
        }
    }
}
