//! The documents of sweeps: those that go in, and those that come out.

use results::{CountForecast, Estimate, Forecast};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use utoipa::ToSchema;

use crate::wire::study_wire::StudySummary;
use crate::wire::sweep_state::state_of;
use store::StoreError;
use store::queue::design_rows::{DesignRow, Standing};
use store::queue::study_rows::State;
use store::queue::sweep_rows::SweepRow;

/// A sweep: its schema is that of the document.
#[derive(Debug, ToSchema)]
pub struct SweepDocument;

/// Further designs of a sweep: their schema is that of the document.
#[derive(Debug, ToSchema)]
pub struct FurtherDesignsDocument;

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
    /// Time at which it was submitted.
    pub created: String,
    /// Time at which its last design ended.
    pub finished: Option<String>,
    /// Time at which it was archived; null unless it is.
    pub archived: Option<String>,
    /// Time in which any of its designs was at work so far, s.
    pub worked_s: f64,
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
    /// Summary of the sweep.
    #[serde(flatten)]
    pub summary: SweepSummary,
    /// The canonical document of the study without changes.
    #[schema(value_type = Object)]
    pub document: Value,
    /// The designs in order, as many as were asked for; `counts` has them all.
    pub designs: Vec<DesignView>,
}

/// A design of the sweep.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct DesignView {
    /// Ordinal of the design in the sweep.
    pub ordinal: i64,
    /// Name that tells it from the others.
    pub name: String,
    /// Values by path.
    #[schema(value_type = Object)]
    pub set: Value,
    /// The study that answers for it.
    pub study: StudySummary,
}

/// A page of sweeps, newest first.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct SweepPage {
    /// The sweeps.
    pub sweeps: Vec<SweepSummary>,
    /// Cursor of the next page; null on the last one.
    pub next_cursor: Option<String>,
}

/// Estimate of a sweep's cost.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct SweepEstimate {
    /// Each design; what an earlier one solves is known to it.
    pub designs: Vec<DesignEstimate>,
    /// Solves left of all designs.
    pub left: CountForecast,
    /// Wall-clock time of all; null where a design's own is, which says why.
    pub wall_s: Option<Forecast>,
    /// Largest memory of any design, bytes.
    pub peak_memory_bytes: u64,
    /// Room that all designs take in the database, bytes.
    pub database_bytes: u64,
}

/// Estimate of a design's cost.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct DesignEstimate {
    /// Name that tells it from the others.
    pub name: String,
    /// Estimate of its study.
    pub estimate: Estimate,
}

impl SweepSummary {
    /// Reads what the rows of the database say.
    pub fn of(sweep: &SweepRow, standing: &Standing) -> Self {
        let count = |state: State| standing.count(state);
        Self {
            id: sweep.id.clone(),
            name: sweep.name.clone(),
            state: state_of(|state| count(state) > 0),
            counts: DesignCounts {
                queued: count(State::Queued),
                running: count(State::Running),
                done: count(State::Done),
                failed: count(State::Failed),
                cancelled: count(State::Cancelled),
            },
            points_total: standing.points_total,
            points_done: standing.points_done,
            priority: sweep.priority,
            created: sweep.created.clone(),
            finished: standing.finished.clone(),
            archived: sweep.archived.clone(),
            worked_s: standing.worked_s,
        }
    }
}

impl SweepDetail {
    /// Reads what the rows of the database say.
    ///
    /// # Errors
    /// When the document in them is damaged.
    pub fn of(
        sweep: &SweepRow,
        standing: &Standing,
        designs: &[DesignRow],
    ) -> Result<Self, StoreError> {
        let view = |design: &DesignRow| DesignView {
            ordinal: design.ordinal,
            name: design.name.clone(),
            set: Value::Object(design.set.clone()),
            study: StudySummary::of(&design.study),
        };
        Ok(Self {
            summary: SweepSummary::of(sweep, standing),
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
            database_bytes: estimates().map(|e| e.database_bytes).sum(),
            designs,
        }
    }
}
