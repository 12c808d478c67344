//! Questions to a server of UM-Bridge's protocol, asked again while it is away.
//!
//! A server is away while nothing that speaks the protocol answers: no connection, no answer in time, HTTP 429, 502, 503 or 504, a page for people. HTTP 500 is the
//! model's own failure: PyPI's `umbridge` answers so, without a word of the protocol, where a model raises an exception.

// What others send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::error::Error;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use http_body_util::{BodyExt, Full, LengthLimitError, Limited};
use hyper::body::{Bytes, Incoming};
use hyper::header::CONTENT_TYPE;
use hyper::{Method, Request, Response, StatusCode, Uri};
use hyper_util::client::legacy::Client;
use hyper_util::client::legacy::connect::HttpConnector;
use hyper_util::rt::TokioExecutor;
use serde_json::{Map, Value};

use crate::umbridge::lenient_json::{object, refusal, shown};

/// Time for a connection to be made.
const CONNECTING: Duration = Duration::from_secs(10);
/// Silence after which a connection is tested: a machine that went away says nothing.
const KEPT_ALIVE: Duration = Duration::from_secs(60);
/// Pause before a question is asked again, which doubles up to the longest.
const FIRST_PAUSE: Duration = Duration::from_millis(100);
const LONGEST_PAUSE: Duration = Duration::from_secs(10);
/// Least time between two lines for people: a hundred questions find a server away at once.
const SAID_EVERY: Duration = Duration::from_secs(30);

/// Address of a server, and how it is asked.
pub(crate) struct Exchange {
    client: Client<HttpConnector, Full<Bytes>>,
    url: String,
    manners: Manners,
    /// Time of the last line for people.
    said: Mutex<Option<Instant>>,
}

/// Patience with a server.
pub(crate) struct Manners {
    /// Time that an answer may take; any when absent.
    pub timeout: Option<Duration>,
    /// Time that the server may be away.
    pub patience: Duration,
    /// Tells people, a line, that it is away.
    pub say: Box<dyn Fn(&str) + Send + Sync>,
}

/// Answer by the protocol.
#[derive(Debug)]
pub(super) enum Reply {
    /// Document that was asked for.
    Document(Map<String, Value>),
    /// Refusal or failure of the model, a sentence.
    Refused(String),
}

/// Reason why a server has been away for longer than the patience lasts, a sentence.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Away(pub String);

/// Reads the address of a server, without the slash at its end.
///
/// # Errors
/// A sentence that says what would be right.
pub(crate) fn server_url(text: &str) -> Result<String, String> {
    let url = text.trim_end_matches('/');
    if url.to_ascii_lowercase().starts_with("https:") {
        return Err("https isn't spoken: name a proxy or tunnel on this machine that speaks http on one side and https on the other".to_owned());
    }
    let is_server = |uri: &Uri| {
        let host = uri.authority().filter(|host| !host.as_str().contains('@'));
        uri.scheme_str() == Some("http") && host.is_some() && uri.query().is_none()
    };
    let uri = url.parse::<Uri>().ok().filter(is_server);
    uri.map(|_| url.to_owned())
        .ok_or_else(|| "an address is http://HOST:PORT, as in http://127.0.0.1:4242".to_owned())
}

impl Exchange {
    /// Exchange with the server at an address that was read by [`server_url`].
    pub(crate) fn with(url: &str, manners: Manners) -> Self {
        let mut connector = HttpConnector::new();
        connector.set_nodelay(true);
        connector.set_connect_timeout(Some(CONNECTING));
        connector.set_keepalive(Some(KEPT_ALIVE));
        Self {
            client: Client::builder(TokioExecutor::new()).build(connector),
            url: url.to_owned(),
            manners,
            said: Mutex::default(),
        }
    }

    /// Address of the server.
    pub(crate) fn url(&self) -> &str {
        &self.url
    }

    /// Asks for an operation, without a body by GET; the answer may have so many bytes.
    pub(super) async fn ask(
        &self,
        operation: &str,
        body: Option<String>,
        most_bytes: usize,
    ) -> Result<Reply, Away> {
        let body = body.map(Bytes::from);
        let (mut pause, mut away_since) = (FIRST_PAUSE, None);
        loop {
            let cause = match self.once(operation, body.clone(), most_bytes).await {
                Ok(reply) => return Ok(reply),
                Err(cause) => format!("{}/{operation}: {cause}", self.url),
            };
            let away_since: Instant = *away_since.get_or_insert_with(Instant::now);
            let left = self.manners.patience.saturating_sub(away_since.elapsed());
            if left.is_zero() {
                return Err(Away(cause));
            }
            self.say(&cause);
            tokio::time::sleep(pause.min(left)).await;
            pause = LONGEST_PAUSE.min(2 * pause);
        }
    }

    /// Says that the server is away, unless that was said a moment ago.
    fn say(&self, cause: &str) {
        let mut said = self.said.lock().unwrap_or_else(PoisonError::into_inner);
        if said.is_none_or(|said| said.elapsed() > SAID_EVERY) {
            let seconds = self.manners.patience.as_secs_f64();
            (self.manners.say)(&format!("{cause}; asking again for {seconds} s\n"));
            *said = Some(Instant::now());
        }
    }

    /// Asks once.
    ///
    /// # Errors
    /// A clause, where nothing that speaks the protocol answered.
    async fn once(
        &self,
        operation: &str,
        body: Option<Bytes>,
        most_bytes: usize,
    ) -> Result<Reply, String> {
        let answering = self.answer(operation, body, most_bytes);
        match self.manners.timeout {
            None => answering.await,
            Some(timeout) => {
                let answered = tokio::time::timeout(timeout, answering).await;
                let seconds = timeout.as_secs_f64();
                answered.unwrap_or_else(|_| Err(format!("no answer within {seconds} s")))
            }
        }
    }

    async fn answer(
        &self,
        operation: &str,
        body: Option<Bytes>,
        most_bytes: usize,
    ) -> Result<Reply, String> {
        let method = match body {
            Some(_) => Method::POST,
            None => Method::GET,
        };
        let request = Request::builder()
            .method(method)
            .uri(format!("{}/{operation}", self.url))
            .header(CONTENT_TYPE, "application/json")
            .body(Full::new(body.unwrap_or_default()))
            .map_err(|error| error.to_string())?;
        let answer = self.client.request(request).await.map_err(|e| cause(&e))?;
        let (status, answer) = (answer.status(), whole(answer, most_bytes).await?);
        match answer {
            Some(text) => reply(status, &text),
            None => Ok(Reply::Refused(format!(
                "its answer has more than {most_bytes} bytes"
            ))),
        }
    }
}

/// Text of an answer; nothing where it is too long.
async fn whole(answer: Response<Incoming>, most_bytes: usize) -> Result<Option<Bytes>, String> {
    match Limited::new(answer.into_body(), most_bytes).collect().await {
        Ok(text) => Ok(Some(text.to_bytes())),
        Err(error) if error.is::<LengthLimitError>() => Ok(None),
        Err(error) => Err(cause(&*error)),
    }
}

/// Meaning of an answer.
fn reply(status: StatusCode, text: &[u8]) -> Result<Reply, String> {
    let passes = [
        StatusCode::TOO_MANY_REQUESTS,
        StatusCode::BAD_GATEWAY,
        StatusCode::SERVICE_UNAVAILABLE,
        StatusCode::GATEWAY_TIMEOUT,
    ];
    let said = || match shown(&String::from_utf8_lossy(text)) {
        words if words.is_empty() => format!("HTTP {}", status.as_u16()),
        words => format!("HTTP {}: {words}", status.as_u16()),
    };
    if passes.contains(&status) {
        return Err(said());
    }
    let document = object(text);
    if let Some(refused) = document.as_ref().and_then(refusal) {
        return Ok(Reply::Refused(refused));
    }
    match document {
        Some(document) if status.is_success() => Ok(Reply::Document(document)),
        _ if status == StatusCode::INTERNAL_SERVER_ERROR => Ok(Reply::Refused(said())),
        // Who meant to write JSON and failed will fail again at the same point.
        None if status.is_success() && text.trim_ascii_start().starts_with(b"{") => {
            Ok(Reply::Refused("its answer isn't JSON".to_owned()))
        }
        _ => Err(format!("no answer of UM-Bridge's protocol, but {}", said())),
    }
}

/// Innermost cause of an error, in the system's words.
fn cause(error: &(dyn Error + 'static)) -> String {
    let mut inner = error;
    while let Some(source) = inner.source() {
        inner = source;
    }
    inner.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_are_of_http() {
        for (text, url) in [
            ("http://127.0.0.1:4242", "http://127.0.0.1:4242"),
            (
                "http://cluster.example/models/",
                "http://cluster.example/models",
            ),
            ("http://[::1]:4242//", "http://[::1]:4242"),
        ] {
            assert_eq!(server_url(text).as_deref(), Ok(url));
        }
        for text in [
            "127.0.0.1:4242",
            "http://",
            "http://a:b@c",
            "http://a?b",
            "ftp://a",
            "",
            "http://a b",
        ] {
            assert!(
                server_url(text).unwrap_err().contains("http://HOST:PORT"),
                "{text}"
            );
        }
        assert!(server_url("https://a").unwrap_err().contains("tunnel"));
    }

    #[test]
    fn a_failed_model_is_told_from_a_server_that_is_away() {
        let said = |status: u16, text: &str| {
            let status = StatusCode::from_u16(status).expect("a status");
            match reply(status, text.as_bytes()) {
                Ok(Reply::Document(_)) => "document".to_owned(),
                Ok(Reply::Refused(words)) => format!("refused: {words}"),
                Err(cause) => format!("away: {cause}"),
            }
        };
        let error = r#"{"error": {"type": "Bad", "message": "no"}}"#;
        for (status, text, expected) in [
            (200, "{}", "document"),
            (200, error, "refused: Bad: no"),
            (400, error, "refused: Bad: no"),
            (
                500,
                "got itself in trouble",
                "refused: HTTP 500: got itself in trouble",
            ),
            (
                200,
                " {\"output\": [[1e999]]}",
                "refused: its answer isn't JSON",
            ),
            (503, error, "away: HTTP 503: "),
            (502, "", "away: HTTP 502"),
            (
                200,
                "<html>",
                "away: no answer of UM-Bridge's protocol, but HTTP 200: <html>",
            ),
            (
                404,
                "{}",
                "away: no answer of UM-Bridge's protocol, but HTTP 404: {}",
            ),
        ] {
            let found = said(status, text);
            assert!(found.starts_with(expected), "{found}");
        }
    }
}
