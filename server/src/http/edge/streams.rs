//! Places for event streams.

use std::sync::Arc;

use axum::http::StatusCode;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};

use crate::http::edge::problem_document::Problem;

/// Places for streams: each costs a connection for hours.
#[derive(Debug, Clone)]
pub struct Streams {
    places: Arc<Semaphore>,
    most: usize,
}

impl Streams {
    /// Room for so many.
    pub fn new(most: usize) -> Self {
        let most = most.min(Semaphore::MAX_PERMITS);
        Self {
            places: Arc::new(Semaphore::new(most)),
            most,
        }
    }

    /// Counts the open ones.
    pub fn open(&self) -> usize {
        self.most - self.places.available_permits()
    }

    /// A place for as long as the permit is kept.
    ///
    /// # Errors
    /// When none is left.
    pub(crate) fn take(&self) -> Result<OwnedSemaphorePermit, Problem> {
        let place = self.places.clone().try_acquire_owned();
        place.map_err(|_| {
            let detail = format!("{} event streams are open already, which is the most: look at the study now and then instead", self.most);
            Problem::new(StatusCode::TOO_MANY_REQUESTS, detail)
        })
    }
}
