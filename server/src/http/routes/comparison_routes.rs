//! Studies side by side.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::slice;

use axum::Json;
use axum::extract::State;
use axum::http::StatusCode;
use axum::response::Response;
use placement::compare::{Comparison, Entry, MOST_TOLD, compare};
use serde::Deserialize;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::answer_limits::Making;
use crate::http::edge::extract::Params;
use crate::http::edge::problem_document::Problem;
use crate::http::routes::answers::export_routes::{both, file};
use crate::http::routes::study_routes;
use crate::http::routes::sweep_routes;
use crate::http::short_ids::whole_id;
use service::comparison::{of_designs, of_studies};
use service::export::{ComparisonExport, ComparisonFormat, ComparisonTable};
use service::queue::sweeps::designs_of;
use service::wire::examples::{self, absent};
use service::wire::study_wire::ProblemDocument;
use service::wire::sweep_examples;
use store::queue::short_names::Listing;

/// `/v1/comparison` and its export.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new()
        .routes(routes!(compare_studies))
        .routes(routes!(export_comparison))
}

#[derive(Deserialize)]
struct ComparisonQuery {
    studies: Option<String>,
    sweep: Option<String>,
    baseline: Option<String>,
}

#[derive(Deserialize)]
struct ToldQuery {
    #[serde(flatten)]
    of: ComparisonQuery,
    best: Option<String>,
}

#[derive(Deserialize)]
struct ExportQuery {
    #[serde(flatten)]
    of: ComparisonQuery,
    format: Option<String>,
    table: Option<String>,
}

/// Compare studies
///
/// Index and rank of each location in each of the studies, what differs from the baseline, and whether the difference is real: beyond its error, which is
/// less than that of two single indices where both meshes err alike. Studies without a result are listed with the reason.
#[utoipa::path(get, path = "/v1/comparison", tag = "sweeps", operation_id = "compare",
    params(
        ("studies" = Option<String>, Query, description = "Identifiers of the studies, separated by commas; or else a sweep", example = "019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6b"),
        ("sweep" = Option<String>, Query, description = "Identifier of a sweep, whose designs are compared"),
        ("baseline" = Option<String>, Query, description = "Identifier of the study to take differences from; the first that has a result when left out"),
        ("best" = Option<usize>, Query, description = "Studies that are told at most, the best ones and the baseline; 1000 when left out. The export has them all", minimum = 1, maximum = 1000, example = 10)),
    responses((status = 200, description = "The table", body = Comparison),
              (status = 400, description = "The query asks for nothing that can be compared", body = ProblemDocument, content_type = "application/problem+json", example = json!(absent())),
              (status = 404, description = "There is no such study or sweep", body = ProblemDocument, content_type = "application/problem+json", example = json!(absent()))))]
async fn compare_studies(
    State(state): State<AppState>,
    Params(query): Params<ToldQuery>,
    _making: Making,
) -> Result<Json<Comparison>, Problem> {
    let best = query.best.as_deref().map(str::parse).transpose();
    let best = best.ok().map(|best| best.unwrap_or(MOST_TOLD));
    let best = best.filter(|best| (1..=MOST_TOLD).contains(best));
    let best = best.ok_or_else(|| wrong(&format!("best is between 1 and {MOST_TOLD}")))?;
    let comparison = compared(&state, &query.of).await?;
    Ok(Json(comparison.best(best)))
}

/// Download a comparison
///
/// As CSV or Parquet one table: `locations` has the rows of the comparison, `designs` a row for each study, also for those without a result. Every row has the study with
/// what its design sets, the hash of its document, the version of the program and the baseline. As JSON the whole comparison.
#[utoipa::path(get, path = "/v1/comparison/export", tag = "sweeps", operation_id = "export_comparison",
    params(
        ("studies" = Option<String>, Query, description = "Identifiers of the studies, separated by commas; or else a sweep", example = "019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6b"),
        ("sweep" = Option<String>, Query, description = "Identifier of a sweep, whose designs are compared"),
        ("baseline" = Option<String>, Query, description = "Identifier of the study to take differences from; the first that has a result when left out"),
        ("format" = Option<ComparisonFormat>, Query, description = "csv (when left out), json or parquet", example = "csv"),
        ("table" = Option<ComparisonTable>, Query, description = "Content of CSV and Parquet: locations (when left out) or designs", example = "designs")),
    responses((status = 200, description = "The file", content(
                  (String = "text/csv", example = json!(sweep_examples::comparison_csv())),
                  (Comparison = "application/json"),
                  (String = "application/vnd.apache.parquet", example = json!(examples::parquet())))),
              (status = 400, description = "The query asks for nothing that can be compared", body = ProblemDocument, content_type = "application/problem+json", example = json!(absent())),
              (status = 404, description = "There is no such study or sweep", body = ProblemDocument, content_type = "application/problem+json", example = json!(absent()))))]
async fn export_comparison(
    State(state): State<AppState>,
    Params(query): Params<ExportQuery>,
    _making: Making,
) -> Result<Response, Problem> {
    let wanted = wanted(&query)?;
    let comparison = compared(&state, &query.of).await?;
    let bytes = wanted.bytes(&comparison)?;
    Ok(file(wanted.format.file(), &wanted.file_name(), bytes))
}

fn wanted(query: &ExportQuery) -> Result<ComparisonExport, Problem> {
    let format = ComparisonFormat::named(query.format.as_deref().unwrap_or("csv"));
    let table = ComparisonTable::named(query.table.as_deref().unwrap_or("locations"));
    let (format, table) = both((format, FORMATS), (table, TABLES))?;
    Ok(ComparisonExport { format, table })
}

const FORMATS: &str = "format is one of csv, json, parquet";
const TABLES: &str = "table is one of locations, designs";

async fn compared(state: &AppState, query: &ComparisonQuery) -> Result<Comparison, Problem> {
    let entries = match (&query.studies, &query.sweep) {
        (Some(studies), None) => entries_of(state, studies).await?,
        (None, Some(id)) => {
            sweep_routes::known(&state.store, id).await?;
            let designs = designs_of(&state.store, id).await?;
            let mut entries = Vec::new();
            for design in &designs {
                let mut connection = state.store.read_whole().await?;
                entries.extend(of_designs(&mut connection, slice::from_ref(design)).await?);
            }
            entries
        }
        _ => {
            return Err(wrong(
                "the query names studies or a sweep: ?studies=ID,ID or ?sweep=ID",
            ));
        }
    };
    let baseline = query.baseline.as_deref();
    if baseline.is_some_and(|id| !entries.iter().any(|entry| entry.id == id)) {
        return Err(wrong(
            "baseline is the identifier of one of the studies that are compared",
        ));
    }
    Ok(compare(&entries, baseline))
}

fn wrong(detail: &str) -> Problem {
    Problem::new(StatusCode::BAD_REQUEST, detail)
}

async fn entries_of(state: &AppState, list: &str) -> Result<Vec<Entry>, Problem> {
    let ids: Vec<&str> = list.split(',').map(str::trim).collect();
    if ids.len() > MOST_TOLD {
        let detail = format!("at most {MOST_TOLD} studies are compared at once");
        return Err(wrong(&detail));
    }
    let mut rows = Vec::new();
    for id in ids {
        let whole = whole_id(&state.store, Listing::Studies, id).await?;
        rows.push(study_routes::known(&state.store, whole.as_deref().unwrap_or(id)).await?);
    }
    let mut entries = Vec::new();
    for row in &rows {
        let mut connection = state.store.read_whole().await?;
        entries.extend(of_studies(&mut connection, slice::from_ref(row)).await?);
    }
    Ok(entries)
}
