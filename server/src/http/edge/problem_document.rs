//! Problem documents of RFC 9457: what a client is told when a request can't be answered.

use axum::Json;
use axum::http::{HeaderName, HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use document::fault::Fault;
use serde_json::{Value, json};

use crate::http::edge::request_id;
use service::queue::removal::RemovalError;
use store::StoreError;

/// A problem document in the making.
#[derive(Debug)]
pub struct Problem {
    status: StatusCode,
    detail: String,
    errors: Vec<Fault>,
}

impl Problem {
    /// A problem of this status; `detail` is a sentence for people.
    pub fn new(status: StatusCode, detail: impl Into<String>) -> Self {
        Self {
            status,
            detail: detail.into(),
            errors: Vec::new(),
        }
    }

    /// Makes the problem of something asked for that isn't there.
    pub(crate) fn not_found(detail: impl Into<String>) -> Self {
        Self::new(StatusCode::NOT_FOUND, detail)
    }

    /// A document that can be read but is wrong: every fault with its pointer.
    pub fn faults(errors: Vec<Fault>) -> Self {
        let detail = match errors.len() {
            1 => "the document has one fault".to_owned(),
            count => format!("the document has {count} faults"),
        };
        Self {
            status: StatusCode::UNPROCESSABLE_ENTITY,
            detail,
            errors,
        }
    }

    /// Adds faults to the problem.
    pub(crate) fn with_errors(mut self, errors: Vec<Fault>) -> Self {
        self.errors = errors;
        self
    }

    /// The document.
    pub fn document(&self) -> Value {
        let mut body = json!({
            "type": "about:blank",
            "title": self.status.canonical_reason().unwrap_or("Error"),
            "status": self.status.as_u16(),
            "detail": self.detail,
        });
        if !self.errors.is_empty() {
            body["errors"] = json!(self.errors);
        }
        body
    }
}

impl IntoResponse for Problem {
    fn into_response(self) -> Response {
        let mut body = self.document();
        if let Some(id) = request_id::current() {
            body["request_id"] = json!(id);
        }
        let mut response = (self.status, Json(body)).into_response();
        let kind = HeaderValue::from_static("application/problem+json");
        response.headers_mut().insert(header::CONTENT_TYPE, kind);
        if let Some((name, value)) = advice(self.status) {
            let value = HeaderValue::from_static(value);
            response.headers_mut().insert(name, value);
        }
        response
    }
}

/// Returns what a client may do about it: how to be let in, or after how many seconds to ask again.
fn advice(status: StatusCode) -> Option<(HeaderName, &'static str)> {
    match status {
        StatusCode::UNAUTHORIZED => Some((header::WWW_AUTHENTICATE, "Bearer")),
        // A study or a stream takes at least that long to end.
        StatusCode::TOO_MANY_REQUESTS => Some((header::RETRY_AFTER, "10")),
        StatusCode::SERVICE_UNAVAILABLE => Some((header::RETRY_AFTER, "2")),
        // As often as the queue looks whether there is space again.
        StatusCode::INSUFFICIENT_STORAGE => Some((header::RETRY_AFTER, "5")),
        _ => None,
    }
}

/// Sentence on a database that is gone; which file it was stands in the log.
const GONE: &str = "the service's database was removed or replaced: nothing can be stored or answered until it is put back, or the service is \
                    stopped and started on a copy";

impl From<StoreError> for Problem {
    fn from(error: StoreError) -> Self {
        tracing::error!(error = %error, "the database could not answer");
        match error {
            StoreError::Full => Self::new(StatusCode::INSUFFICIENT_STORAGE, error.to_string()),
            StoreError::Busy => Self::new(StatusCode::SERVICE_UNAVAILABLE, error.to_string()),
            StoreError::Gone { .. } => Self::new(StatusCode::SERVICE_UNAVAILABLE, GONE),
            StoreError::Damaged { .. } => {
                Self::new(StatusCode::INTERNAL_SERVER_ERROR, error.to_string())
            }
            _ => Self::new(
                StatusCode::INTERNAL_SERVER_ERROR,
                "the database failed; the service's log says how",
            ),
        }
    }
}

impl From<RemovalError> for Problem {
    fn from(error: RemovalError) -> Self {
        match error {
            RemovalError::Design { .. } => Self::new(StatusCode::CONFLICT, error.to_string()),
            RemovalError::Busy => Self::new(StatusCode::SERVICE_UNAVAILABLE, error.to_string()),
            RemovalError::Store(error) => error.into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_database_that_can_not_answer_now_says_when_to_ask_again() {
        for (error, status) in [
            (StoreError::Busy, StatusCode::SERVICE_UNAVAILABLE),
            (StoreError::Full, StatusCode::INSUFFICIENT_STORAGE),
            (
                StoreError::Gone {
                    file: "a.db".into(),
                },
                StatusCode::SERVICE_UNAVAILABLE,
            ),
            (
                sqlx::Error::PoolTimedOut.into(),
                StatusCode::SERVICE_UNAVAILABLE,
            ),
        ] {
            let response = Problem::from(error).into_response();
            assert_eq!(response.status(), status);
            let seconds = response.headers()[header::RETRY_AFTER].to_str();
            let seconds: u64 = seconds.expect("text").parse().expect("a number");
            assert!((1..=10).contains(&seconds), "{status}: {seconds}");
        }
        let other = Problem::from(StoreError::from(sqlx::Error::RowNotFound)).into_response();
        assert_eq!(other.status(), StatusCode::INTERNAL_SERVER_ERROR);
        assert!(!other.headers().contains_key(header::RETRY_AFTER));
    }
}
