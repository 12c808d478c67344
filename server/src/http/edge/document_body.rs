//! Reads the bodies of studies, sweeps and scenes.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::sync::Arc;
use std::time::Duration;

use axum::body::Body;
use axum::extract::{FromRequest, Request};
use axum::http::{HeaderMap, StatusCode, header};
use document::fault::Fault;
use document::{Format, MAX_BYTES, parse};
use documents::scene_question::SceneQuestion;
use documents::study::plan::{Estimable, PlannedStudy};
use documents::sweep::{MOST_SUBMITTED, Sweep};
use http_body_util::BodyExt;
use serde_json::Value;
use tokio::sync::Semaphore;

use crate::http::edge::problem_document::Problem;

/// Limits on what is read of a body.
#[derive(Debug, Clone, Copy)]
pub struct BodyLimits {
    /// Body that is refused beyond this many bytes, in words.
    pub what: &'static str,
    /// A body that has more is refused.
    pub bytes: usize,
    /// Bytes beyond which a body is cut off.
    pub discarded: usize,
    /// A client that has not sent its document by then is refused.
    pub time: Duration,
}

const DOCUMENT: BodyLimits = BodyLimits {
    what: "a document has",
    bytes: MAX_BYTES,
    discarded: 16 * MAX_BYTES,
    time: Duration::from_secs(30),
};

/// Documents checked at once: the largest design takes 100 MB meanwhile.
static READERS: Semaphore = Semaphore::const_new(4);

/// A request's body: a document that nobody has looked into yet.
pub(crate) struct Document {
    text: String,
    format: Format,
}

impl<S: Send + Sync> FromRequest<S> for Document {
    type Rejection = Problem;

    async fn from_request(request: Request, _: &S) -> Result<Self, Problem> {
        let format = format_of(request.headers())?;
        let text = read(request, DOCUMENT, |_| Ok(())).await?;
        Ok(Self { text, format })
    }
}

impl Document {
    /// Reads it with a reader.
    ///
    /// # Errors
    /// 400 when it isn't well-formed, 422 with every fault that the reader finds.
    pub async fn checked<T, R>(self, reader: R) -> Result<T, Problem>
    where
        T: Send + 'static,
        R: FnOnce(&Value) -> Result<T, Vec<Fault>> + Send + 'static,
    {
        let Self { text, format } = self;
        // A closed semaphore can't be: nobody closes it.
        let place = READERS.acquire().await.ok();
        // A large design takes seconds to check, which the runtime's threads haven't.
        let read = tokio::task::spawn_blocking(move || {
            let _place = place;
            reader(&well_formed(parse(&text, format))?).map_err(Problem::faults)
        });
        let broken = |_| {
            let detail = "the service has a fault; its log says where";
            Problem::new(StatusCode::INTERNAL_SERVER_ERROR, detail)
        };
        read.await.map_err(broken)?
    }
}

/// A checked study from a request's body.
pub(crate) struct StudyBody {
    /// The study with its plan.
    pub planned: Arc<PlannedStudy>,
}

impl<S: Send + Sync> FromRequest<S> for StudyBody {
    type Rejection = Problem;

    async fn from_request(request: Request, state: &S) -> Result<Self, Problem> {
        let document = Document::from_request(request, state).await?;
        let planned = document.checked(|value| PlannedStudy::from_value(value, &no_files));
        planned.await.map(|planned| Self {
            planned: Arc::new(planned),
        })
    }
}

/// A study from a request's body of which only the cost is asked.
pub(crate) struct EstimateBody {
    /// The study, planned unless that takes long.
    pub study: Estimable,
}

impl<S: Send + Sync> FromRequest<S> for EstimateBody {
    type Rejection = Problem;

    async fn from_request(request: Request, state: &S) -> Result<Self, Problem> {
        let document = Document::from_request(request, state).await?;
        let study = document.checked(|value| Estimable::from_value(value, &no_files));
        study.await.map(|study| Self { study })
    }
}

/// A checked scene from a request's body, with what is read of it.
pub(crate) struct SceneBody {
    /// The scene and its readout.
    pub question: SceneQuestion,
}

impl<S: Send + Sync> FromRequest<S> for SceneBody {
    type Rejection = Problem;

    async fn from_request(request: Request, state: &S) -> Result<Self, Problem> {
        let document = Document::from_request(request, state).await?;
        let question = document.checked(|value| SceneQuestion::from_value(value, &no_files));
        question.await.map(|question| Self { question })
    }
}

/// A checked sweep from a request's body.
pub(crate) struct SweepBody {
    /// The sweep.
    pub sweep: Sweep,
}

impl<S: Send + Sync> FromRequest<S> for SweepBody {
    type Rejection = Problem;

    async fn from_request(request: Request, state: &S) -> Result<Self, Problem> {
        let document = Document::from_request(request, state).await?;
        let sweep = document.checked(|value| Sweep::from_value(value, MOST_SUBMITTED, &no_files));
        sweep.await.map(|sweep| Self { sweep })
    }
}

/// A service must not read files that a page or a script on another machine names.
fn no_files(path: &str) -> Result<String, String> {
    Err(format!(
        "the service reads no scene files, so {path:?} can't be used here: put the scene's tables inline, or name a \
         preset as in {{\"preset\": \"foot-tire\"}}"
    ))
}

/// Finds how a body is written.
///
/// # Errors
/// 415 for what isn't read.
pub fn format_of(headers: &HeaderMap) -> Result<Format, Problem> {
    let unsupported = |detail| Problem::new(StatusCode::UNSUPPORTED_MEDIA_TYPE, detail);
    if headers.contains_key(header::CONTENT_ENCODING) {
        return Err(unsupported(
            "send the document as it is, without a Content-Encoding",
        ));
    }
    let kind = headers
        .get(header::CONTENT_TYPE)
        .and_then(|value| value.to_str().ok())
        .unwrap_or_default();
    match kind
        .split(';')
        .next()
        .unwrap_or_default()
        .trim()
        .to_ascii_lowercase()
        .as_str()
    {
        "application/json" => Ok(Format::Json),
        "application/toml" => Ok(Format::Toml),
        _ => Err(unsupported(
            "a document is sent as application/json or application/toml",
        )),
    }
}

/// The text of a body. Each piece is asked for by its size before it is kept.
///
/// # Errors
/// 400, 408, 413; what a piece is refused with.
pub async fn read(
    request: Request,
    limits: BodyLimits,
    keep: impl FnMut(usize) -> Result<(), Problem>,
) -> Result<String, Problem> {
    let slow = |_| {
        Problem::new(
            StatusCode::REQUEST_TIMEOUT,
            "the document took too long to arrive",
        )
    };
    let read = collect(request.into_body(), limits, keep);
    let bytes = tokio::time::timeout(limits.time, read)
        .await
        .map_err(slow)??;
    let foreign = |_| Problem::new(StatusCode::BAD_REQUEST, "the document is not UTF-8");
    String::from_utf8(bytes).map_err(foreign)
}

/// The body, when it isn't too large. Of one that is refused, some more is read and thrown away: most clients look for an
/// answer only when they have sent everything, and see a broken connection otherwise.
async fn collect(
    mut body: Body,
    limits: BodyLimits,
    mut keep: impl FnMut(usize) -> Result<(), Problem>,
) -> Result<Vec<u8>, Problem> {
    let (mut bytes, mut length, mut refused) = (Vec::new(), 0, None);
    while let Some(frame) = body.frame().await {
        let broken = |_| Problem::new(StatusCode::BAD_REQUEST, "the document did not arrive whole");
        let Ok(data) = frame.map_err(broken)?.into_data() else {
            continue;
        };
        length += data.len();
        if length > limits.discarded {
            break;
        }
        if refused.is_none() && length <= limits.bytes {
            refused = keep(data.len()).err();
        }
        if refused.is_none() && length <= limits.bytes {
            bytes.extend_from_slice(&data);
        } else {
            bytes = Vec::new();
        }
    }
    if length > limits.bytes {
        let detail = format!("{} at most {} bytes", limits.what, limits.bytes);
        return Err(Problem::new(StatusCode::PAYLOAD_TOO_LARGE, detail));
    }
    refused.map_or(Ok(bytes), Err)
}

/// A text that can't be read is a bad request; what can be read and is wrong is for the study's own reader.
///
/// # Errors
/// 400 or 422, with the faults.
pub(crate) fn well_formed(parsed: Result<Value, Vec<Fault>>) -> Result<Value, Problem> {
    let faults = match parsed {
        Ok(value) => return Ok(value),
        Err(faults) => faults,
    };
    let unreadable =
        |fault: &Fault| fault.pointer.is_empty() && !fault.detail.contains("number out of range");
    if faults.iter().any(unreadable) {
        return Err(
            Problem::new(StatusCode::BAD_REQUEST, "the document can't be read").with_errors(faults),
        );
    }
    Err(Problem::faults(faults))
}
