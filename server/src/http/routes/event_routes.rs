//! Progress as server-sent events.
//!
//! The number of an event is its row in the database, so a client that comes back with `Last-Event-ID` gets exactly
//! what it missed. A stream reads rows as its client takes them and holds no connection in between, so a slow client
//! costs neither memory nor one of the few reading connections.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::collections::VecDeque;
use std::convert::Infallible;
use std::sync::Arc;
use std::time::Duration;

use axum::extract::State;
use axum::http::{HeaderMap, StatusCode};
use axum::response::sse::{Event, KeepAlive, Sse};
use axum::response::{IntoResponse, Response};
use futures_util::stream;
use serde_json::{Value, json};
use tokio::sync::{OwnedSemaphorePermit, watch};
use tracing::{Instrument, Span};
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::extract::{StudyId, StudyPath};
use crate::http::edge::problem_document::Problem;
use crate::http::routes::study_routes::known;
use service::solving::live::Solves;
use service::wire::examples;
use service::wire::study_wire::{LiveSolve, ProblemDocument, StreamEvent};
use service::work::shutdown::Shutdown;
use store::clock::now;
use store::queue::event_rows;
use store::queue::event_rows::EventRow;
use store::{Store, StoreError};

/// Rows read at once.
const BATCH: u32 = 100;
const KEEP_ALIVE: Duration = Duration::from_secs(15);
/// Tells a proxy to send each event on at once: nginx would gather an answer and send on nothing of it for minutes.
const UNBUFFERED: [(&str, &str); 1] = [("x-accel-buffering", "no")];

/// `/v1/studies/{id}/events`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new().routes(routes!(follow))
}

/// Follow a study
///
/// Server-sent events: `queued`, `started`, `solving`, `point-solved`, `point-failed`, `estimate-revised`, `analysing`, then one of `done`, `failed` and `cancelled`, which ends the stream. Each
/// has a number; a client that comes back with `Last-Event-ID` gets what it missed, and one whose number is beyond the newest of this database gets all.
/// `solving` has none and doesn't come again: it tells up to five times a second how far the solves under way are, each with its stage, iterations and residual.
#[utoipa::path(get, path = "/v1/studies/{id}/events", tag = "studies",
    params(StudyPath, ("Last-Event-ID" = Option<String>, Header, description = "Number of the last event seen; all come again where it is beyond the newest", example = "17")),
    responses((status = 200, description = "The events", content_type = "text/event-stream", body = StreamEvent,
                  example = json!(examples::event())),
              (status = 204, description = "The study has ended and there is nothing more to tell"),
              (status = 429, description = "Too many streams are open already; `Retry-After` says when to look again", body = ProblemDocument, content_type = "application/problem+json",
                  headers(("Retry-After" = String, description = "Seconds after which to try again")), example = json!(examples::crowded())),
              (status = 404, description = "There is no such study", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn follow(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let last = last_event_id(&headers)?;
    let place = state.streams.take()?;
    let study = known(&state.store, &id).await?;
    let last = from_here(&state.store, last).await?;
    let mut follower = Follower {
        seen: state.store.events_seen(),
        solves: state.engine.live.subscribe(),
        store: state.store,
        shutdown: state.shutdown,
        study: id,
        last,
        waiting: VecDeque::new(),
        ended: false,
        _place: place,
    };
    follower.fetch().await?;
    if study.ended() && follower.waiting.is_empty() {
        // An event source that gets 204 stops coming back.
        return Ok(StatusCode::NO_CONTENT.into_response());
    }
    let request = Span::current();
    let stream = stream::unfold(follower, move |mut follower| {
        let next = async move {
            let event = follower.next().await?;
            Some((Ok::<_, Infallible>(event), follower))
        };
        next.instrument(request.clone())
    });
    let events = Sse::new(stream).keep_alive(KeepAlive::new().interval(KEEP_ALIVE));
    Ok((UNBUFFERED, events).into_response())
}

fn last_event_id(headers: &HeaderMap) -> Result<i64, Problem> {
    let Some(value) = headers.get("last-event-id") else {
        return Ok(0);
    };
    let number = value
        .to_str()
        .ok()
        .and_then(|text| text.trim().parse::<i64>().ok());
    let wrong = || {
        Problem::new(
            StatusCode::BAD_REQUEST,
            "Last-Event-ID is the number of an event of this study",
        )
    };
    number.filter(|id| *id >= 0).ok_or_else(wrong)
}

/// A client that has seen an event which isn't there yet saw it in another database, as before a copy was restored: it gets all from the beginning.
async fn from_here(store: &Store, last: i64) -> Result<i64, StoreError> {
    let mut connection = store.read().await?;
    let latest = event_rows::latest(&mut connection).await?;
    Ok(if last > latest { 0 } else { last })
}

struct Follower {
    store: Arc<Store>,
    seen: watch::Receiver<i64>,
    solves: watch::Receiver<Solves>,
    shutdown: Shutdown,
    study: String,
    last: i64,
    waiting: VecDeque<EventRow>,
    ended: bool,
    /// Free again when the stream ends.
    _place: OwnedSemaphorePermit,
}

impl Follower {
    async fn next(&mut self) -> Option<Event> {
        if self.ended {
            return None;
        }
        while self.waiting.is_empty() {
            tokio::select! {
                changed = self.seen.changed() => changed.ok()?,
                () = self.shutdown.wait() => return None,
                changed = self.solves.changed() => {
                    changed.ok()?;
                    match solving(&self.solves.borrow_and_update(), &self.study) {
                        Some(event) => return Some(event),
                        None => continue,
                    }
                }
            }
            if let Err(error) = self.fetch().await {
                tracing::error!(%error, "an event stream could not go on");
                return None;
            }
        }
        let row = self.waiting.pop_front()?;
        self.ended = row.ends_the_study();
        Some(wire(&row))
    }

    /// Reads what came after the last row; what comes later than this reading changes `seen` again.
    async fn fetch(&mut self) -> Result<(), StoreError> {
        self.seen.mark_unchanged();
        let mut connection = self.store.read().await?;
        let rows = event_rows::after(&mut connection, &self.study, self.last, BATCH).await?;
        if rows.len() == BATCH as usize {
            self.seen.mark_changed();
        }
        self.last = rows.last().map_or(self.last, |row| row.id);
        self.waiting.extend(rows);
        Ok(())
    }
}

/// Tells how far the solves of a study are; `None` where none is told of.
fn solving(solves: &Solves, study: &str) -> Option<Event> {
    if solves.study != study || solves.points.is_empty() {
        return None;
    }
    let points = solves.points.iter();
    let points = points.map(|(&ordinal, &progress)| LiveSolve { ordinal, progress });
    let told = json!({"kind": "solving", "time": now(), "solves": points.collect::<Vec<_>>()});
    Some(Event::default().event("solving").data(told.to_string()))
}

fn wire(row: &EventRow) -> Event {
    let mut data = json!({"kind": row.kind, "time": row.created});
    if let (Value::Object(data), Ok(Value::Object(payload))) =
        (&mut data, serde_json::from_str(&row.payload))
    {
        data.extend(payload);
    }
    Event::default()
        .id(row.id.to_string())
        .event(&row.kind)
        .data(data.to_string())
}
