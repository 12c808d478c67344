//! Exports of what a study found, as a file for other programs.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use axum::extract::State;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use results::StudyResult;
use serde::Deserialize;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::answer_limits::Making;
use crate::http::edge::extract::{Params, StudyId, StudyPath};
use crate::http::edge::problem_document::Problem;
use crate::http::routes::answers::result_routes::with_map;
use crate::http::routes::study_routes::known;
use service::export::{Export, ExportError, FileFormat, Table};
use service::wire::examples;
use service::wire::study_wire::ProblemDocument;

/// `/v1/studies/{id}/export`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new().routes(routes!(export))
}

#[derive(Deserialize)]
struct ExportQuery {
    format: Option<String>,
    table: Option<String>,
}

/// Download a table, the result, the map or the wheel
///
/// As CSV or Parquet one table, each of its rows with the study, the hash of its document and the version of the program; a Parquet file says the
/// same in its metadata, beside the unit of each column. As JSON the whole
/// result. As VTU, for ParaView, the inner surface with the strains at the means, the indices and their errors; the study must have asked for a map. As
/// GLB, glTF 2.0 for any viewer, both skins of the whole wheel, pressed as at the means by the morph target `contact`.
#[utoipa::path(get, path = "/v1/studies/{id}/export", tag = "answers", params(StudyPath,
        ("format" = Option<FileFormat>, Query, description = "csv (when left out), json, parquet, vtu or glb", example = "csv"),
        ("table" = Option<Table>, Query, description = "Content of CSV and Parquet: indices (when left out), locations, layouts, points, signals, candidates or forces", example = "points")),
    responses((status = 200, description = "The file", content(
                  (String = "text/csv", example = json!(examples::csv())),
                  (StudyResult = "application/json"),
                  (String = "application/vnd.apache.parquet", example = json!(examples::parquet())),
                  (String = "application/xml", example = json!(examples::vtu())),
                  (String = "model/gltf-binary", example = json!(examples::glb())))),
              (status = 404, description = "There is no such study, or it hasn't this yet; the detail says which", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn export(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    Params(query): Params<ExportQuery>,
    _making: Making,
) -> Result<Response, Problem> {
    let wanted = wanted(&query)?;
    let result: StudyResult = with_map(&state.store, &id).await?;
    let study = known(&state.store, &id).await?;
    let mut connection = state.store.read().await?;
    let sources = wanted.sources(&mut connection, &study, result).await?;
    let bytes = wanted.bytes(&sources)?;
    // The identifier of a known study is a UUID and needs no quoting.
    Ok(file(wanted.format, &wanted.file_name(&id), bytes))
}

/// A file to download, under a name that needs no quoting.
pub fn file(format: FileFormat, name: &str, bytes: Vec<u8>) -> Response {
    let headers = [
        (header::CONTENT_TYPE, format.media_type().to_owned()),
        (
            header::CONTENT_DISPOSITION,
            format!("attachment; filename=\"{name}\""),
        ),
    ];
    (headers, bytes).into_response()
}

fn wanted(query: &ExportQuery) -> Result<Export, Problem> {
    let format = FileFormat::named(query.format.as_deref().unwrap_or("csv"));
    let table = Table::named(query.table.as_deref().unwrap_or("indices"));
    let (format, table) = both((format, FORMATS), (table, TABLES))?;
    Ok(Export { format, table })
}

const FORMATS: &str = "format is one of csv, json, parquet, vtu, glb, svg";
const TABLES: &str = "table is one of indices, locations, layouts, trade, films, points, signals, candidates, forces";

/// The format and the table that a query names, or what each that names nothing could be.
pub fn both<F, T>(format: (Option<F>, &str), table: (Option<T>, &str)) -> Result<(F, T), Problem> {
    let detail = match (format, table) {
        ((Some(format), _), (Some(table), _)) => return Ok((format, table)),
        ((None, formats), (Some(_), _)) => formats.to_owned(),
        ((Some(_), _), (None, tables)) => tables.to_owned(),
        ((None, formats), (None, tables)) => format!("{formats}; {tables}"),
    };
    Err(Problem::new(StatusCode::BAD_REQUEST, detail))
}

impl From<ExportError> for Problem {
    fn from(error: ExportError) -> Self {
        let status = match error {
            ExportError::NoMap | ExportError::NoMesh | ExportError::NoFilms => {
                StatusCode::NOT_FOUND
            }
            _ => StatusCode::INTERNAL_SERVER_ERROR,
        };
        Self::new(status, error.to_string())
    }
}
