//! Limits of large answers: how many are made at once, and how many bytes of them wait for whoever asked.
//!
//! A client decides how fast it reads. What waits for it meanwhile is counted until its last byte has gone to the kernel, and there is one bound for the answers of
//! all clients together.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::sync::Arc;
use std::time::Duration;

use axum::body::{Body, Bytes, HttpBody, to_bytes};
use axum::extract::{FromRef, FromRequestParts, Request, State};
use axum::http::StatusCode;
use axum::http::request::Parts;
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::timeout;

use crate::http::edge::problem_document::Problem;

/// Answers that are made of whole results at once: each costs a multiple of the result, and for a while a connection to the database.
const MAKING: usize = 2;
/// Results that are read at once to be sent: the store has one connection for whole results, which the answers being made use too.
const READING: usize = 1;
/// Time that large answers wait: as long as a client that doesn't read is waited for, so that what it held is free by then.
const PATIENCE: Duration = Duration::from_secs(30);
/// Bytes of large answers that may wait for their readers. Pieces of results take half of it at most, and an answer that is larger than that takes half.
const HELD: usize = 128 << 20;
/// An answer up to this size isn't counted: a connection may hold as much anyway.
const SMALL: usize = 64 << 10;
/// A piece of a result that is sent in pieces. SQLite reads all of a text for each of its pieces: larger ones are quicker.
const PIECE: usize = 1 << 20;

/// Limits of large answers.
#[derive(Debug, Clone)]
pub struct AnswerLimits {
    making: Arc<Semaphore>,
    reading: Arc<Semaphore>,
    held: Arc<Semaphore>,
}

impl Default for AnswerLimits {
    fn default() -> Self {
        Self {
            making: Arc::new(Semaphore::new(MAKING)),
            reading: Arc::new(Semaphore::new(READING)),
            held: Arc::new(Semaphore::new(HELD)),
        }
    }
}

impl AnswerLimits {
    /// A place to make an answer of a whole result, for as long as it is kept.
    ///
    /// # Errors
    /// 503 when none became free.
    pub(crate) async fn make(&self) -> Result<Making, Problem> {
        let place = next_of(&self.making).await?;
        Ok(Making { _place: place })
    }

    /// The turn to read a result, for as long as it is kept.
    ///
    /// # Errors
    /// 503 when it didn't come.
    pub(crate) async fn turn(&self) -> Result<OwnedSemaphorePermit, Problem> {
        next_of(&self.reading).await
    }

    /// A piece to be read when its turn comes: a large one while more than half of the room is free. Otherwise a small one, so that clients which don't read hold
    /// up nobody who does.
    pub(crate) async fn piece(&self) -> Piece {
        // Nobody closes it.
        let turn = self.reading.clone().acquire_owned().await.ok();
        let half_free = self.held.available_permits() >= HELD / 2 + PIECE;
        let place = if half_free { self.place(PIECE) } else { None };
        Piece { turn, place }
    }

    /// Returns the bytes, counted until the last of them is dropped.
    fn hold(&self, bytes: Bytes) -> Result<Bytes, Problem> {
        if bytes.len() <= SMALL {
            return Ok(bytes);
        }
        let no_room = || crowded("large answers wait for clients that read slowly");
        let place = self.place(bytes.len()).ok_or_else(no_room)?;
        Ok(Bytes::from_owner(Counted {
            bytes,
            _place: place,
        }))
    }

    fn place(&self, bytes: usize) -> Option<OwnedSemaphorePermit> {
        let bytes = u32::try_from(bytes.min(HELD / 2)).ok()?;
        self.held.clone().try_acquire_many_owned(bytes).ok()
    }
}

async fn next_of(places: &Arc<Semaphore>) -> Result<OwnedSemaphorePermit, Problem> {
    match timeout(PATIENCE, places.clone().acquire_owned()).await {
        Ok(Ok(place)) => Ok(place),
        _ => Err(crowded("too many large answers are asked for")),
    }
}

fn crowded(what: &str) -> Problem {
    Problem::new(
        StatusCode::SERVICE_UNAVAILABLE,
        format!("{what}: ask again later"),
    )
}

/// A place to make an answer of a whole result. A handler that makes one has it as an argument.
pub(crate) struct Making {
    _place: OwnedSemaphorePermit,
}

impl<S> FromRequestParts<S> for Making
where
    AnswerLimits: FromRef<S>,
    S: Send + Sync,
{
    type Rejection = Problem;

    async fn from_request_parts(_: &mut Parts, state: &S) -> Result<Self, Problem> {
        AnswerLimits::from_ref(state).make().await
    }
}

/// A piece that may be read now.
pub(crate) struct Piece {
    turn: Option<OwnedSemaphorePermit>,
    place: Option<OwnedSemaphorePermit>,
}

impl Piece {
    /// Returns how many bytes it may have.
    pub(crate) fn size(&self) -> usize {
        if self.place.is_some() { PIECE } else { SMALL }
    }

    /// Returns what was read, counted until it is sent. The next piece may be read.
    pub(crate) fn holding(self, bytes: Vec<u8>) -> Bytes {
        drop(self.turn);
        match self.place {
            Some(place) => Bytes::from_owner(Counted {
                bytes: bytes.into(),
                _place: place,
            }),
            None => bytes.into(),
        }
    }
}

/// Bytes with the room that they take.
struct Counted {
    bytes: Bytes,
    _place: OwnedSemaphorePermit,
}

impl AsRef<[u8]> for Counted {
    fn as_ref(&self) -> &[u8] {
        &self.bytes
    }
}

/// Counts large answers, or refuses them when there is no answers. An answer of unknown size is a stream, which counts its pieces itself.
pub async fn count(State(answers): State<AnswerLimits>, request: Request, next: Next) -> Response {
    let (head, body) = next.run(request).await.into_parts();
    let size = body.size_hint().exact();
    if size.is_none_or(|size| size <= SMALL as u64) {
        return Response::from_parts(head, body);
    }
    // In one piece already: nothing is copied, and nothing can fail.
    let whole = to_bytes(body, usize::MAX).await.unwrap_or_default();
    match answers.hold(whole) {
        Ok(counted) => Response::from_parts(head, Body::from(counted)),
        Err(problem) => problem.into_response(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn large_answers_have_one_bound_and_give_back_what_they_took() {
        let answers = AnswerLimits::default();
        let half = || answers.hold(Bytes::from(vec![1; HELD / 2]));
        let (first, second) = (half().expect("fits"), half().expect("fits"));
        assert!(half().is_err(), "the room is full");
        let small = answers.hold(Bytes::from(vec![1; SMALL]));
        assert!(small.is_ok(), "what any connection may hold isn't counted");
        // A part keeps the whole in memory.
        let part = first.slice(..1);
        drop(first);
        assert!(half().is_err(), "a part of the first is still there");
        drop(part);
        assert!(half().is_ok());
        drop(second);
        let larger = answers.hold(Bytes::from(vec![1; HELD]));
        assert!(larger.is_ok() && half().is_ok());
    }

    #[tokio::test]
    async fn pieces_become_small_when_much_is_held_and_are_never_refused() {
        let answers = AnswerLimits::default();
        let mut unread = Vec::new();
        for _ in 0..HELD / PIECE {
            let piece = answers.piece().await;
            let size = piece.size();
            unread.push(piece.holding(vec![1; size]));
        }
        let large = unread.iter().filter(|piece| piece.len() == PIECE).count();
        assert_eq!(large, HELD / PIECE / 2);
        assert!(unread.iter().skip(large).all(|piece| piece.len() == SMALL));
        assert!(
            answers.hold(Bytes::from(vec![1; HELD])).is_ok(),
            "there is room for other answers"
        );
        drop(unread);
        assert_eq!(answers.piece().await.size(), PIECE);
    }
}
