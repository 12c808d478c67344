//! Reads bodies that have files in them, which are larger than other documents.
//!
//! What is held of them is counted from the first byte until it is stored or answered, for all clients together.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::time::Duration;

use axum::extract::{FromRequest, Request};
use axum::http::StatusCode;
use document::fault::Fault;
use document::{Format, parse_long_texts};
use serde_json::Value;
use tokio::sync::{Semaphore, SemaphorePermit};
use tokio::time::timeout;

use crate::http::edge::document_body::{BodyLimits, format_of, read, well_formed};
use crate::http::edge::problem_document::Problem;

const LONG: BodyLimits = BodyLimits {
    what: "a document with files has",
    bytes: 64 << 20,
    discarded: 128 << 20,
    time: Duration::from_secs(60),
};
/// Bytes of such bodies that are held at once.
const HELD: usize = 4 * LONG.bytes;
/// A client whose document waits for its check longer is refused.
const PATIENCE: Duration = Duration::from_secs(30);

static HELD_BYTES: Semaphore = Semaphore::const_new(HELD);
/// Documents checked at once: the rows of the largest recording take 300 MB meanwhile.
static CHECKERS: Semaphore = Semaphore::const_new(1);

/// A request's body: a document with files that nobody has looked into yet.
pub(crate) struct LongBody {
    text: String,
    held: Held,
}

/// Room that a body takes, for as long as it is kept.
#[derive(Default)]
pub struct Held(Option<SemaphorePermit<'static>>);

impl Held {
    /// Room for so many bytes more.
    fn grow(&mut self, bytes: usize) -> Result<(), Problem> {
        let more = u32::try_from(bytes)
            .ok()
            .and_then(|bytes| HELD_BYTES.try_acquire_many(bytes).ok())
            .ok_or_else(crowded)?;
        match &mut self.0 {
            Some(held) => held.merge(more),
            None => self.0 = Some(more),
        }
        Ok(())
    }
}

fn crowded() -> Problem {
    Problem::new(
        StatusCode::SERVICE_UNAVAILABLE,
        "files of others are taken in just now: ask again later",
    )
}

impl<S: Send + Sync> FromRequest<S> for LongBody {
    type Rejection = Problem;

    async fn from_request(request: Request, _: &S) -> Result<Self, Problem> {
        if format_of(request.headers())? != Format::Json {
            return Err(Problem::new(
                StatusCode::UNSUPPORTED_MEDIA_TYPE,
                "files are sent in application/json",
            ));
        }
        let mut held = Held::default();
        let text = read(request, LONG, |bytes| held.grow(bytes)).await?;
        Ok(Self { text, held })
    }
}

impl LongBody {
    /// Reads it with a reader, and returns the room that it takes.
    ///
    /// # Errors
    /// 400 when it isn't well-formed, 422 with every fault that the reader finds, 503 when others' documents took too long.
    pub async fn checked<T, R>(self, reader: R) -> Result<(T, Held), Problem>
    where
        T: Send + 'static,
        R: FnOnce(Value) -> Result<T, Vec<Fault>> + Send + 'static,
    {
        let Self { text, held } = self;
        let place = timeout(PATIENCE, CHECKERS.acquire()).await;
        let place = place.ok().and_then(Result::ok).ok_or_else(crowded)?;
        // A large file takes seconds to check, which the runtime's threads haven't.
        let read = tokio::task::spawn_blocking(move || {
            let _place = place;
            let document = well_formed(parse_long_texts(&text))?;
            drop(text);
            reader(document).map_err(Problem::faults)
        });
        let broken = |_| {
            let detail = "the service has a fault; its log says where";
            Problem::new(StatusCode::INTERNAL_SERVER_ERROR, detail)
        };
        let read = read.await.map_err(broken)?;
        read.map(|read| (read, held))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_have_one_bound_and_give_back_what_they_took() {
        let mut held = Held::default();
        for _ in 0..4 {
            held.grow(LONG.bytes).expect("fits");
        }
        assert!(Held::default().grow(1).is_err());
        drop(held);
        assert!(Held::default().grow(1).is_ok());
    }
}
