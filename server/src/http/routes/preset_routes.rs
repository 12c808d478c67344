//! Studies and scenes to start from: the documents that ship.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use axum::Json;
use fem_client::document::{Format, parse};
use fem_client::scene::PRESETS;
use serde_json::Value;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use service::wire::examples;
use service::wire::study_wire::{Preset, Presets};

/// `/v1/presets`.
pub fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new().routes(routes!(presets))
}

/// List the shipped documents
///
/// Studies and scenes to start from, to show, to change and to submit.
#[utoipa::path(get, path = "/v1/presets", tag = "service",
    responses((status = 200, description = "The documents", body = Presets, example = json!({"studies": [examples::preset()], "scenes": []}))))]
async fn presets() -> Json<Presets> {
    let studies = placement::study::presets()
        .into_iter()
        .filter_map(preset)
        .collect();
    let scenes = PRESETS.into_iter().filter_map(preset).collect();
    Json(Presets { studies, scenes })
}

/// A shipped document as JSON, so that a page can show it, change it and submit it.
fn preset((name, text): (&str, &str)) -> Option<Preset> {
    let document = parse(text, Format::Toml).ok()?;
    let title = document.get("name").and_then(Value::as_str).unwrap_or(name);
    Some(Preset {
        name: name.to_owned(),
        title: title.to_owned(),
        comment: comment(text),
        document,
    })
}

/// The comment at the head of a shipped document.
fn comment(text: &str) -> String {
    let head = text
        .lines()
        .map_while(|line| line.strip_prefix('#'))
        .map(str::trim);
    head.collect::<Vec<_>>().join(" ")
}
