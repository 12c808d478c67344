//! Results of a study: its ranked rows, its points, its map.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use axum::Json;
use axum::body::Body;
use axum::extract::State;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::Response;
use fem_client::solver::direction::Direction;
use placement::ladder::trade::Trade;
use results::{LayoutFindings, MapLayer, RankedLayout, Signals, StudyResult};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use sqlx::SqliteConnection;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::answer_limits::Making;
use crate::http::edge::conditional::{has, tagged};
use crate::http::edge::extract::{Params, StudyId, StudyPath};
use crate::http::edge::problem_document::Problem;
use crate::http::routes::answers::sent_result;
use crate::http::routes::study_routes::known;
use service::views::point_views;
use service::wire::examples;
use service::wire::study_wire::{
    Candidates, Evaluations, Layouts, Locations, MapView, ProblemDocument,
};
use store::answers::result_rows::{self, Extent};
use store::answers::result_text;
use store::answers::trades;
use store::queue::study_rows::StudyRow;
use store::{Store, StoreError};

/// `/v1/studies/{id}/result` and its parts.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new()
        .routes(routes!(whole))
        .routes(routes!(locations))
        .routes(routes!(layouts))
        .routes(routes!(candidates))
        .routes(routes!(signals))
        .routes(routes!(evaluations))
        .routes(routes!(map))
        .routes(routes!(trade))
}

/// Get the result
///
/// The whole answer: indices with their errors, ranked locations and layouts, the map, what was modelled, what it took and what was expected. The map is most of
/// it: with `map=false` it is null, and all else as it is.
#[utoipa::path(get, path = "/v1/studies/{id}/result", tag = "answers",
    params(StudyPath,
        ("map" = Option<bool>, Query, description = "Whether the map is sent; true when left out", example = "false"),
        ("If-None-Match" = Option<String>, Header, description = "ETag of the result that the client has")),
    responses((status = 304, description = "The client has it"),
              (status = 200, description = "The answer", body = StudyResult),
              (status = 404, description = "There is no such study, or it hasn't this yet; the detail says which", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn whole(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    Params(query): Params<ResultQuery>,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let has_map = query.has_map()?;
    let found = ready(&state.store, &id, async |connection| {
        result_text::find(connection, &id).await
    });
    let text = found.await?;
    if !has_map {
        return without_map(&state, &id, &headers, &text.content_sha256).await;
    }
    // A result never changes: what the client has was compared with its hash when it was sent, and the text needn't be read again.
    let body = if has(&headers, &text.content_sha256) {
        Body::empty()
    } else {
        let from = (&state.store, &state.answers, &state.intact);
        sent_result::body(from, &text).await?
    };
    let kind = [
        (header::CONTENT_TYPE, "application/json".to_owned()),
        (header::CONTENT_LENGTH, text.bytes.to_string()),
    ];
    let answer = (kind, body);
    Ok(tagged(&headers, &text.content_sha256, "no-cache", answer))
}

/// Query of a result.
#[derive(Deserialize)]
struct ResultQuery {
    map: Option<String>,
}

impl ResultQuery {
    fn has_map(&self) -> Result<bool, Problem> {
        match self.map.as_deref() {
            None | Some("true") => Ok(true),
            Some("false") => Ok(false),
            Some(_) => Err(Problem::new(
                StatusCode::BAD_REQUEST,
                "map is true or false; true when left out",
            )),
        }
    }
}

/// A result whose map is null, under a tag of its own.
async fn without_map(
    state: &AppState,
    id: &str,
    headers: &HeaderMap,
    content_sha256: &str,
) -> Result<Response, Problem> {
    let tag = format!("{content_sha256}-without-map");
    if has(headers, &tag) {
        return Ok(tagged(headers, &tag, "no-cache", ()));
    }
    let _making = state.answers.make().await?;
    let result: StudyResult = part(&state.store, id).await?;
    Ok(tagged(headers, &tag, "no-cache", Json(result)))
}

/// Get the ranked locations
///
/// Best first.
#[utoipa::path(get, path = "/v1/studies/{id}/locations", tag = "answers", params(StudyPath),
    responses((status = 200, description = "The answer", body = Locations),
              (status = 404, description = "There is no such study, or it hasn't this yet; the detail says which", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn locations(
    State(state): State<AppState>,
    StudyId(id): StudyId,
) -> Result<Json<Locations>, Problem> {
    Ok(Json(part(&state.store, &id).await?))
}

/// Get the ranked layouts
///
/// Best first.
#[utoipa::path(get, path = "/v1/studies/{id}/layouts", tag = "answers", params(StudyPath),
    responses((status = 200, description = "The answer", body = Layouts),
              (status = 404, description = "There is no such study, or it hasn't this yet; the detail says which", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn layouts(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    _making: Making,
) -> Result<Json<Layouts>, Problem> {
    let Ranked {
        layouts,
        layout_findings: findings,
    } = part(&state.store, &id).await?;
    Ok(Json(Layouts { layouts, findings }))
}

/// Part of a result on its layouts.
#[derive(Deserialize)]
struct Ranked {
    layouts: Vec<RankedLayout>,
    layout_findings: Option<LayoutFindings>,
}

/// Part of a result on what its layouts show together.
#[derive(Deserialize)]
struct Found {
    layout_findings: Option<LayoutFindings>,
}

/// Get the kinds of film for layouts
///
/// Every section angle and direction by several criteria.
#[utoipa::path(get, path = "/v1/studies/{id}/candidates", tag = "answers", params(StudyPath),
    responses((status = 200, description = "The answer", body = Candidates),
              (status = 404, description = "There is no such study, or it hasn't this yet; the detail says which", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn candidates(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    _making: Making,
) -> Result<Json<Candidates>, Problem> {
    let Found { layout_findings } = part(&state.store, &id).await?;
    let found = layout_findings.ok_or_else(|| {
        Problem::not_found("this study has no candidates: its document asks for no layouts, or its budget left no time for them")
    })?;
    Ok(Json(Candidates {
        candidates: found.candidates,
    }))
}

/// Get the films' signals
///
/// What each film reads of each load, pressure and contact angle, with its error, and what the curves show.
#[utoipa::path(get, path = "/v1/studies/{id}/signals", tag = "answers", params(StudyPath),
    responses((status = 200, description = "The answer", body = Signals),
              (status = 404, description = "There is no such study, or it hasn't this yet; the detail says which", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn signals(
    State(state): State<AppState>,
    StudyId(id): StudyId,
) -> Result<Json<Signals>, Problem> {
    let Read { signals } = part(&state.store, &id).await?;
    signals.map(Json).ok_or_else(|| {
        Problem::not_found("this study has no signals: its document asks for none, or its budget left no time for them")
    })
}

/// Part of a result on films' signals.
#[derive(Deserialize)]
struct Read {
    signals: Option<Signals>,
}

/// Get the solved points
///
/// Those that have an outcome so far, while the study runs too. Of one without an equilibrium the numbers are null, and `reason` says why.
#[utoipa::path(get, path = "/v1/studies/{id}/evaluations", tag = "answers", params(StudyPath),
    responses((status = 200, description = "The answer", body = Evaluations),
              (status = 404, description = "There is no such study, or it hasn't this yet; the detail says which", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn evaluations(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    _making: Making,
) -> Result<Json<Evaluations>, Problem> {
    let study = known(&state.store, &id).await?;
    let mut connection = state.store.read().await?;
    let evaluations = point_views::of(&mut connection, &study).await?;
    Ok(Json(Evaluations { evaluations }))
}

#[derive(Deserialize)]
struct MapQuery {
    direction: Option<String>,
    input: Option<String>,
    index: Option<String>,
}

/// Get a layer of the map
///
/// First-order index of one input over the inner surface, for one direction; with `index=total` its total index, too.
#[utoipa::path(get, path = "/v1/studies/{id}/map", tag = "answers", params(StudyPath,
        ("direction" = Option<String>, Query, description = "x circumferential, y meridional; x when left out", example = "x"),
        ("input" = Option<String>, Query, description = "Name of the input; the first one when left out", example = "P3"),
        ("index" = Option<String>, Query, description = "first-order, or total for both; first-order when left out", example = "total")),
    responses((status = 200, description = "The answer", body = MapView),
              (status = 404, description = "There is no such study, or it hasn't this yet; the detail says which", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn map(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    Params(query): Params<MapQuery>,
    _making: Making,
) -> Result<Json<MapView>, Problem> {
    let has_total = match query.index.as_deref() {
        None | Some("first-order") => false,
        Some("total") => true,
        Some(_) => {
            let detail = "index is first-order or total";
            return Err(Problem::new(StatusCode::BAD_REQUEST, detail));
        }
    };
    let result: StudyResult = with_map(&state.store, &id).await?;
    let Some(map) = &result.map else {
        return Err(Problem::not_found(
            "this study has no map: its document asks for no candidates.grid",
        ));
    };
    let direction = query.direction.as_deref().unwrap_or("x");
    let direction = Direction::named(direction);
    let is_asked = |layer: &&MapLayer| Some(layer.direction) == direction;
    let Some(layer) = map.layers.iter().find(is_asked) else {
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
    let Some((index, input)) = names
        .iter()
        .enumerate()
        .find(|(_, name)| wanted.is_none_or(|wanted| **name == wanted))
    else {
        return Err(Problem::new(
            StatusCode::BAD_REQUEST,
            format!("input is one of {}", names.join(", ")),
        ));
    };
    Ok(Json(MapView {
        input: (*input).to_owned(),
        theta_deg: map.theta_deg.clone(),
        phi_deg: map.phi_deg.clone(),
        first_order: layer.first_order.get(index).cloned(),
        total: layer.total.get(index).filter(|_| has_total).cloned(),
        std: layer.std.clone(),
        strain: layer.strain.clone(),
        error: layer
            .first_order_error
            .get(index)
            .cloned()
            .unwrap_or_default(),
        status: layer
            .status
            .iter()
            .map(|status| status.as_str().to_owned())
            .collect(),
        direction: layer.direction.to_string(),
    }))
}

/// Get what accuracy costs
///
/// The newest trade that `strainsite trade` measured for the same document.
#[utoipa::path(get, path = "/v1/studies/{id}/trade", tag = "answers", params(StudyPath),
    responses((status = 200, description = "The answer", body = Trade),
              (status = 404, description = "There is no such study, or it hasn't this yet; the detail says which", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
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

/// The part `R` of a study's result that isn't of its map, or 404 with what became of it.
pub(super) async fn part<R: DeserializeOwned>(store: &Store, id: &str) -> Result<R, Problem> {
    Ok(hashed_part(store, id).await?.0)
}

/// Returns that part, and the hash of the whole result's content.
pub(super) async fn hashed_part<R: DeserializeOwned>(
    store: &Store,
    id: &str,
) -> Result<(R, String), Problem> {
    read(store, id, Extent::WithoutMap).await
}

/// A study's result, or a part `R` of it that is of its map, too.
pub(super) async fn with_map<R: DeserializeOwned>(store: &Store, id: &str) -> Result<R, Problem> {
    Ok(read(store, id, Extent::Whole).await?.0)
}

async fn read<R: DeserializeOwned>(
    store: &Store,
    id: &str,
    extent: Extent,
) -> Result<(R, String), Problem> {
    let study = known(store, id).await?;
    let mut connection = store.read_whole().await?;
    let found = result_rows::row(&mut connection, id, extent).await?;
    // Others may read while this one is worked on.
    drop(connection);
    Ok(found.ok_or_else(|| without_result(&study))?.read()?)
}

/// Returns what is found of a study's result, or 404 with what became of the study.
pub(super) async fn ready<R>(
    store: &Store,
    id: &str,
    find: impl AsyncFnOnce(&mut SqliteConnection) -> Result<Option<R>, StoreError>,
) -> Result<R, Problem> {
    let study = known(store, id).await?;
    let mut connection = store.read().await?;
    let found = find(&mut connection).await?;
    found.ok_or_else(|| without_result(&study))
}

fn without_result(study: &StudyRow) -> Problem {
    let cause = study
        .error
        .as_deref()
        .map(|error| format!(": {error}"))
        .unwrap_or_default();
    Problem::not_found(format!(
        "the study is {} and has no result{cause}",
        study.state().as_str()
    ))
}
