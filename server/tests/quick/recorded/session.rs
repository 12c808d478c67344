//! Requests to a service, with what it answers.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use reqwest::{Method, RequestBuilder, StatusCode};
use serde_json::Value;

use super::redaction::Redaction;
use crate::app::App;

/// Headers that a record shows, and whose mere presence it shows.
const HEADERS: [&str; 5] = [
    "content-type",
    "content-disposition",
    "location",
    "retry-after",
    "allow",
];
const PRESENT: [&str; 1] = ["etag"];
/// Levels of a document that are shown, unless said otherwise.
pub const DEPTH: usize = 6;

/// A service that is asked, and the record of its answers.
pub struct Session<'a> {
    app: &'a App,
    redaction: Redaction,
    record: String,
    /// Levels of a document that are shown.
    pub depth: usize,
    /// Methods and paths so far.
    pub asked: BTreeSet<(String, String)>,
}

impl<'a> Session<'a> {
    pub fn new(app: &'a App) -> Self {
        Self {
            app,
            redaction: Redaction::default(),
            record: String::new(),
            depth: DEPTH,
            asked: BTreeSet::new(),
        }
    }

    /// The record, for comparison, whichever port was free.
    pub fn record(&self) -> String {
        let port = format!(":{}", self.app.service.address().port());
        self.record.replace(&port, ":PORT")
    }

    /// Asks, and records the answer whole.
    pub async fn ask(&mut self, method: Method, path: &str, body: Option<&Value>) -> Value {
        let request = self.app.client.request(method.clone(), self.app.url(path));
        let request = match body {
            Some(body) => request.json(body),
            None => request,
        };
        self.send(&format!("{method} {path}"), request).await
    }

    /// Sends a request under a title that begins with its method and path.
    pub async fn send(&mut self, title: &str, request: RequestBuilder) -> Value {
        let answer = request.send().await.expect("an answer");
        let mut words = title.split(' ').map(str::to_owned);
        self.asked.extend(words.next().zip(words.next()));
        self.redaction.goes_on = answer.status() == StatusCode::ACCEPTED;
        let title = self.redaction.text(title);
        writeln!(self.record, "## {title}\n{}", answer.status()).expect("writes");
        for name in HEADERS {
            if let Some(value) = answer.headers().get(name) {
                let value = self.redaction.text(value.to_str().expect("text"));
                writeln!(self.record, "{name}: {value}").expect("writes");
            }
        }
        for name in PRESENT {
            if answer.headers().contains_key(name) {
                writeln!(self.record, "{name}: ..").expect("writes");
            }
        }
        let kind = answer.headers().get("content-type").cloned();
        let kind = kind.map_or(String::new(), |kind| {
            kind.to_str().expect("text").to_owned()
        });
        let bytes = answer.bytes().await.expect("a body");
        let (body, document) = self.body(&kind, &bytes);
        writeln!(self.record, "{body}").expect("writes");
        document
    }

    fn body(&mut self, kind: &str, bytes: &[u8]) -> (String, Value) {
        if kind.contains("json") {
            let mut document: Value = serde_json::from_slice(bytes).expect("JSON");
            let shown = document
                .as_object_mut()
                .map(|fields| fields.remove("request_id"));
            let text = self.redaction.json(&document, self.depth);
            if let Some(Some(id)) = shown {
                document["request_id"] = id;
            }
            return (text + "\n", document);
        }
        let text = std::str::from_utf8(bytes);
        let text = match (kind.split(';').next().unwrap_or(kind), text) {
            ("text/csv", Ok(text)) => self.redaction.csv(text),
            ("text/event-stream", Ok(text)) => events(text),
            ("text/plain", Ok(text)) | ("application/openmetrics-text", Ok(text)) => helps(text),
            (_, _) if bytes.is_empty() => String::new(),
            _ => "..\n".to_owned(),
        };
        (text, Value::Null)
    }
}

/// Kinds of events in the order of their first one, but for those that depend on the clock.
fn events(text: &str) -> String {
    let mut seen: Vec<&str> = Vec::new();
    for line in text.lines().filter(|line| line.starts_with("event:")) {
        let by_clock = ["event: solving", "event: estimate-revised"].contains(&line);
        if !by_clock && !seen.contains(&line) {
            seen.push(line);
        }
    }
    seen.join("\n") + "\n"
}

/// Names and meanings of measurements.
fn helps(text: &str) -> String {
    let lines = text.lines().filter(|line| line.starts_with("# HELP"));
    lines.map(|line| format!("{line}\n")).collect()
}
