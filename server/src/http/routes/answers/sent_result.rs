//! A result on its way to a client: compared with its hash before the first byte, then read from the database as fast as the client takes it.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use axum::body::{Body, Bytes};
use futures_util::stream;

use crate::http::edge::answer_limits::AnswerLimits;
use crate::http::edge::problem_document::Problem;
use store::answers::result_text::{Reading, ResultText};
use store::{Store, StoreError};

/// Bytes that are read at once to be compared. SQLite reads the whole text for each such piece, and three copies of a piece are held meanwhile.
const AT_ONCE: usize = 16 << 20;
/// A text up to this size is read once, and sent at once.
const SHORT: usize = 1 << 20;
/// Time for which a text isn't compared again before it is sent: what damages it meanwhile ends the answer early instead of refusing it.
const LATELY: Duration = Duration::from_secs(5);

/// Texts that were intact lately: a crowd that asks for one result compares it once.
#[derive(Debug, Clone, Default)]
pub struct Intact(Arc<Mutex<HashMap<ResultText, Instant>>>);

impl Intact {
    fn lately(&self) -> MutexGuard<'_, HashMap<ResultText, Instant>> {
        let mut texts = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        texts.retain(|_, since| since.elapsed() < LATELY);
        texts
    }
}

/// The text, which is intact.
///
/// # Errors
/// 500 when it is damaged; 503 when too many are read at once.
pub(super) async fn body(
    (store, answers, intact): (&Arc<Store>, &AnswerLimits, &Intact),
    text: &ResultText,
) -> Result<Body, Problem> {
    if text.bytes <= SHORT {
        let mut connection = store.read_whole().await?;
        let whole = text.reading().next(&mut connection, SHORT).await?;
        return Ok(whole.map(Body::from).unwrap_or_default());
    }
    let turn = answers.turn().await?;
    if !intact.lately().contains_key(text) {
        compare(store, text).await?;
        intact.lately().insert(text.clone(), Instant::now());
    }
    drop(turn);
    let sending = Sending {
        store: store.clone(),
        answers: answers.clone(),
        reading: text.reading(),
    };
    let pieces = stream::try_unfold(sending, Sending::next);
    Ok(Body::from_stream(pieces))
}

/// Compares a text with its hash.
async fn compare(store: &Store, text: &ResultText) -> Result<(), StoreError> {
    let mut reading = text.reading();
    while !reading.ended() {
        let mut connection = store.read_whole().await?;
        reading.next(&mut connection, AT_ONCE).await?;
    }
    Ok(())
}

/// A text that is being sent.
struct Sending {
    store: Arc<Store>,
    answers: AnswerLimits,
    reading: Reading,
}

impl Sending {
    /// The next piece. A fault ends the connection before the whole text was sent.
    async fn next(mut self) -> Result<Option<(Bytes, Self)>, StoreError> {
        let piece = self.answers.piece().await;
        let read = async {
            let mut connection = self.store.read_whole().await?;
            self.reading.next(&mut connection, piece.size()).await
        };
        let read = read
            .await
            .inspect_err(|error| tracing::error!(%error, "a result could not be sent to its end"));
        Ok(read?.map(|bytes| (piece.holding(bytes), self)))
    }
}
