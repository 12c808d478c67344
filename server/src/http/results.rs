//! What a study found: the result, its ranked rows, its points, its map.

use axum::extract::State;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use axum::{Json, Router};
use fem_client::document::Format;
use fem_client::scene::Scene;
use placement::result::StudyResult;
use placement::study::Input;
use placement::trade::Trade;
use serde::Deserialize;
use serde_json::{Value, json};

use super::AppState;
use super::extract::{Params, StudyId};
use super::problem::Problem;
use super::studies::known;
use crate::store::{Store, evaluations, results, trades};
use crate::study_document::stored_plan;

/// `/v1/studies/{id}/result` and its parts.
pub fn router() -> Router<AppState> {
    Router::new()
        .route("/v1/studies/{id}/result", get(whole))
        .route("/v1/studies/{id}/locations", get(locations))
        .route("/v1/studies/{id}/layouts", get(layouts))
        .route("/v1/studies/{id}/evaluations", get(points))
        .route("/v1/studies/{id}/map", get(map))
        .route("/v1/studies/{id}/trade", get(trade))
}

async fn whole(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let (result, sha256) = ready(&state.store, &id).await?;
    let etag = format!("\"{sha256}\"");
    let known = headers
        .get(header::IF_NONE_MATCH)
        .and_then(|value| value.to_str().ok());
    if known.is_some_and(|tags| tags.split(',').any(|tag| tag.trim() == etag)) {
        return Ok((StatusCode::NOT_MODIFIED, [(header::ETAG, etag)]).into_response());
    }
    Ok(([(header::ETAG, etag)], Json(result)).into_response())
}

async fn locations(
    State(state): State<AppState>,
    StudyId(id): StudyId,
) -> Result<Json<Value>, Problem> {
    let (result, _) = ready(&state.store, &id).await?;
    Ok(Json(json!({"locations": result.locations})))
}

async fn layouts(
    State(state): State<AppState>,
    StudyId(id): StudyId,
) -> Result<Json<Value>, Problem> {
    let (result, _) = ready(&state.store, &id).await?;
    Ok(Json(json!({"layouts": result.layouts})))
}

/// The points that have an outcome so far, in the order of the plan; those after it are the same on a coarser mesh, or on the next
/// rung of a climb. Of one without an equilibrium the numbers are null, and
/// `reason` says why.
async fn points(
    State(state): State<AppState>,
    StudyId(id): StudyId,
) -> Result<Json<Value>, Problem> {
    let study = known(&state.store, &id).await?;
    let inputs = stored_plan(&study)
        .map(|(study, _)| study.inputs)
        .unwrap_or_default();
    let mut connection = state.store.read().await?;
    let mut rows = Vec::new();
    for (ordinal, key) in evaluations::points_of(&mut connection, &id).await? {
        let Some(evaluation) = evaluations::find(&mut connection, &key).await? else {
            continue;
        };
        let response = evaluation.outcome.as_ref().ok();
        let scene = Scene::from_text(&evaluation.scene, Format::Json).ok();
        let mut row = json!({
            "ordinal": ordinal,
            "key": key,
            "level": scene.as_ref().map(|scene| scene.model.level.as_str()),
            "values": scene.as_ref().and_then(|scene| values_of(scene, &inputs)),
            "reaction_n": response.map(|response| response.reaction_n),
            "locations": response.map(|response| &response.locations),
            "newton_iterations": response.map(|_| evaluation.cost.newton_iterations),
            "wall_s": evaluation.cost.wall_s,
        });
        if let Err(unsolved) = &evaluation.outcome {
            row["reason"] = json!(unsolved.to_string());
            row["reached"] = json!(unsolved.reached);
        }
        rows.push(row);
    }
    Ok(Json(json!({"evaluations": rows})))
}

/// The inputs' values in a stored scene; none if this version doesn't know one of them.
fn values_of(scene: &Scene, inputs: &[Input]) -> Option<Vec<f64>> {
    let value = |input: &Input| scene.number_at(&input.vary).ok();
    inputs.iter().map(value).collect()
}

#[derive(Deserialize)]
struct MapQuery {
    direction: Option<String>,
    input: Option<String>,
}

/// One layer of the map; x and the first input unless asked otherwise.
async fn map(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    Params(query): Params<MapQuery>,
) -> Result<Json<Value>, Problem> {
    let (result, _) = ready(&state.store, &id).await?;
    let Some(map) = &result.map else {
        return Err(Problem::not_found(
            "this study has no map: its document asks for no candidates.grid",
        ));
    };
    let direction = query.direction.unwrap_or_else(|| "x".to_owned());
    let Some(layer) = map.layers.iter().find(|layer| layer.direction == direction) else {
        return Err(Problem::new(
            StatusCode::BAD_REQUEST,
            "direction is x (circumferential) or y (meridional)",
        ));
    };
    let names: Vec<&str> = result
        .inputs
        .iter()
        .map(|input| input.name.as_str())
        .collect();
    let wanted = query.input.as_deref();
    let Some(index) = names
        .iter()
        .position(|name| wanted.is_none_or(|wanted| *name == wanted))
    else {
        return Err(Problem::new(
            StatusCode::BAD_REQUEST,
            format!("input is one of {}", names.join(", ")),
        ));
    };
    Ok(Json(json!({
        "direction": direction,
        "input": names[index],
        "theta_deg": map.theta_deg,
        "phi_deg": map.phi_deg,
        "first_order": layer.first_order.get(index),
        "std": layer.std,
        "strain": layer.strain,
        "error": layer.error,
        "status": layer.status,
    })))
}

/// The newest trade that was measured for a study of the same document.
async fn trade(
    State(state): State<AppState>,
    StudyId(id): StudyId,
) -> Result<Json<Trade>, Problem> {
    let study = known(&state.store, &id).await?;
    let mut connection = state.store.read().await?;
    let found = trades::newest(&mut connection, &study.spec_sha256).await?;
    found.map(Json).ok_or_else(|| {
        Problem::not_found(
            "what accuracy costs wasn't measured for this study: strainsite trade does, with the same document and database",
        )
    })
}

/// The result of a study, or 404 with what became of it.
async fn ready(store: &Store, id: &str) -> Result<(StudyResult, String), Problem> {
    let study = known(store, id).await?;
    let mut connection = store.read().await?;
    let found = results::find(&mut connection, id).await?;
    found.ok_or_else(|| {
        let cause = study
            .error
            .as_deref()
            .map(|error| format!(": {error}"))
            .unwrap_or_default();
        Problem::not_found(format!(
            "the study is {} and has no result{cause}",
            study.state().as_str()
        ))
    })
}
