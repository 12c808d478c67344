//! Studies and scenes to start from: the documents that ship.

use axum::routing::get;
use axum::{Json, Router};
use fem_client::document::{Format, parse};
use fem_client::scene::PRESETS;
use serde_json::{Value, json};

use super::AppState;

/// `/v1/presets`.
pub fn router() -> Router<AppState> {
    Router::new().route("/v1/presets", get(list))
}

async fn list() -> Json<Value> {
    let studies: Vec<Value> = placement::study::presets()
        .into_iter()
        .filter_map(preset)
        .collect();
    let scenes: Vec<Value> = PRESETS.into_iter().filter_map(preset).collect();
    Json(json!({"studies": studies, "scenes": scenes}))
}

/// A shipped document as JSON, so that a page can show it, change it and submit it.
fn preset((name, text): (&str, &str)) -> Option<Value> {
    let document = parse(text, Format::Toml).ok()?;
    let title = document.get("name").and_then(Value::as_str).unwrap_or(name);
    Some(json!({"name": name, "title": title, "document": document, "comment": comment(text)}))
}

/// The comment at the head of a shipped document.
fn comment(text: &str) -> String {
    let head = text
        .lines()
        .map_while(|line| line.strip_prefix('#'))
        .map(str::trim);
    head.collect::<Vec<_>>().join(" ")
}
