//! Fields over the wheel, from what a study has stored: nothing is solved for them.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use axum::Json;
use axum::extract::State;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::Response;
use results::LayoutFindings;
use serde::Deserialize;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::answer_limits::Making;
use crate::http::edge::conditional::{has, tagged};
use crate::http::edge::extract::{Params, StudyId, StudyPath};
use crate::http::edge::problem_document::Problem;
use crate::http::routes::answers::result_routes::{hashed_part, part, with_map};
use crate::http::routes::study_routes::known;
use service::export::{ExportError, surface_file};
use service::views::rings::Rings;
use service::views::sections::{self, Sections, SectionsError};
use service::views::solved_wheel;
use service::wire::examples;
use service::wire::study_wire::ProblemDocument;

/// `/v1/studies/{id}/surface`, `/sections` and `/rings`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new()
        .routes(routes!(surface))
        .routes(routes!(sections))
        .routes(routes!(rings))
}

/// Part of a result on its mesh.
#[derive(Deserialize)]
struct Meshed {
    model: Level,
}

#[derive(Deserialize)]
struct Level {
    level: String,
}

/// Get the wheel's surface
///
/// Both skins of the whole wheel at the means, inflated and pressed: every node of the mesh's surfaces, what isn't modelled completed by its mirror images.
///
/// Little-endian: the length H of the header as u32; H bytes of JSON, padded by spaces so that 4 + H is a multiple of 4; then lists of 32-bit floats. The header
/// has `study`, `level`, `rows`, `columns`, `phi_deg` (a section angle for each row, from the crown), `theta_deg` (a wheel angle for each column, from -180 on, 0 at the
/// contact), `ground` (its height `z_mm` over `x_mm` along its normal, to which the wheel leans by `camber_deg`) and `arrays`: `name`, `unit`, `components`, `offset` in bytes from the end of the header and `count` of points, which
/// stand row after row. The last column's neighbour is the first. x is the rolling direction, y along the axle, z upward from the wheel's centre; a displacement leads
/// from the inflated state to the equilibrium.
#[utoipa::path(get, path = "/v1/studies/{id}/surface", tag = "answers",
    params(StudyPath, ("If-None-Match" = Option<String>, Header, description = "ETag of the surface that the client has")),
    responses((status = 304, description = "The client has it"),
              (status = 200, description = "The surface", body = String, content_type = "application/octet-stream", example = json!(examples::surface())),
              (status = 404, description = "There is no such study, or it hasn't this yet, or another solver solved it; the detail says which", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn surface(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    headers: HeaderMap,
    _making: Making,
) -> Result<Response, Problem> {
    let (Meshed { model }, content_sha256) = hashed_part(&state.store, &id).await?;
    let tag = format!("{content_sha256}-surface");
    if has(&headers, &tag) {
        return Ok(tagged(&headers, &tag, "no-cache", ()));
    }
    let mut connection = state.store.read().await?;
    let skins = solved_wheel::skins(&mut connection, &id, &model.level).await?;
    let skins = skins.ok_or(ExportError::NoMesh)?;
    let kind = [(header::CONTENT_TYPE, "application/octet-stream")];
    let file = surface_file(&id, &model.level, &skins);
    Ok(tagged(&headers, &tag, "no-cache", (kind, file)))
}

#[derive(Deserialize)]
struct SectionsQuery {
    input: Option<String>,
}

/// Get the map along an input
///
/// Strains and displacements over the map at every value of the input that was solved while all others are at their means. Between these nodes nothing is solved: what
/// is shown there is interpolated.
#[utoipa::path(get, path = "/v1/studies/{id}/sections", tag = "answers", params(StudyPath,
        ("input" = Option<String>, Query, description = "Name of the input; the first one when left out", example = "P3")),
    responses((status = 200, description = "The nodes", body = Sections),
              (status = 400, description = "No input has this name", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent())),
              (status = 404, description = "There is no such study, or it hasn't this yet; the detail says which", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn sections(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    Params(query): Params<SectionsQuery>,
    _making: Making,
) -> Result<Json<Sections>, Problem> {
    let found = with_map(&state.store, &id).await?;
    let study = known(&state.store, &id).await?;
    let mut connection = state.store.read().await?;
    let input = query.input.as_deref();
    Ok(Json(
        sections::of(&mut connection, &study, found, input).await?,
    ))
}

impl From<SectionsError> for Problem {
    fn from(error: SectionsError) -> Self {
        let status = match error {
            SectionsError::Store(error) => return error.into(),
            SectionsError::NoMap => StatusCode::NOT_FOUND,
            SectionsError::NoInput { .. } => StatusCode::BAD_REQUEST,
            SectionsError::Unreadable { .. } => StatusCode::INTERNAL_SERVER_ERROR,
        };
        Self::new(status, error.to_string())
    }
}

/// Part of a result on its layouts.
#[derive(Deserialize)]
struct Found {
    layout_findings: Option<LayoutFindings>,
}

/// Get the strains around the wheel
///
/// What films of the study's layouts read around the whole wheel at the load in the middle, and its derivative by the depth; no ring where the document asks for no layouts.
#[utoipa::path(get, path = "/v1/studies/{id}/rings", tag = "answers", params(StudyPath),
    responses((status = 200, description = "The rings", body = Rings),
              (status = 404, description = "There is no such study, or it hasn't this yet; the detail says which", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn rings(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    _making: Making,
) -> Result<Json<Rings>, Problem> {
    let Found { layout_findings } = part(&state.store, &id).await?;
    Ok(Json(Rings::of(layout_findings.as_ref())))
}
