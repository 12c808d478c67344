//! The description of the service, OpenAPI 3.1, from the types and routes themselves.
//!
//! Each handler carries its operation, and a router takes handler and operation together, so that neither is there without the other.

use std::sync::LazyLock;

use axum::extract::State;
use axum::http::HeaderMap;
use axum::response::Response;
use axum::{Extension, Json};
use document::json_schema::Schemas;
use documents::own_model::analysis_document::analysis_schema;
use documents::scene_question::scene_question_schema;
use documents::schemas::DocumentKind;
use documents::sweep::sweep_schema::further_designs_schema;
use serde_json::{Value, json};
use utoipa::OpenApi;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::access::Access;
use crate::http::mount::Mount;
use crate::http::routes::openapi::generator_idioms;
use crate::http::routes::upkeep::{engine_routes, health, login_routes, metric_routes};
use crate::http::routes::{
    analysis_routes, answers, assets, at_once, comparison_routes, estimators, event_routes,
    preset_routes, study_routes, sweep_routes,
};
use service::export::{ComparisonFormat, ComparisonTable, FileFormat, Table};
use service::wire::described_tables::described_tables;
use service::wire::examples;
use service::wire::study_wire::{LiveSolve, ProblemDocument};

#[derive(OpenApi)]
#[openapi(
    info(
        title = "strainsite",
        description = "Ranks strain-sensor locations in a smart tire. Studies are documents: what is pressed, what varies, what is asked. They are \
                       queued, solved point by point, and answered with ranked locations and layouts, each number with its error.\n\n\
                       Units are mm, N, MPa, degrees and seconds; strains are plain numbers. Numbers that don't exist are null, with a reason beside \
                       them. Every answer has an `x-request-id`.",
        license(name = "MIT OR Apache-2.0", identifier = "MIT OR Apache-2.0")
    ),
    components(schemas(ProblemDocument, LiveSolve, ComparisonFormat, ComparisonTable, FileFormat, Table)),
    tags(
        (name = "studies", description = "Estimate, submit, follow and cancel"),
        (name = "answers", description = "Answers of studies"),
        (name = "scenes", description = "One equilibrium, without a study"),
        (name = "sweeps", description = "One study and many designs, and what differs between them"),
        (name = "estimators", description = "Forces from recorded signals: learnt, judged, applied"),
        (name = "analyses", description = "Indices of a model of your own: points out, values in"),
        (name = "service", description = "The service itself")
    )
)]
struct Description;

static DOCUMENT: LazyLock<Value> = LazyLock::new(|| {
    let (_, described) = routes().split_for_parts();
    let mut document = serde_json::to_value(&described).unwrap_or_default();
    for operation in operations(&mut document) {
        operation["responses"]["default"] = problem();
    }
    give_examples(&mut document);
    describe_documents(&mut document);
    generator_idioms::rewrite(&mut document);
    document["x-tables"] = described_tables(&document["components"]["schemas"]);
    document
});

/// Answers by method and path, recorded by `lab/examples.py`.
const RECORDED: &str = include_str!("../../generated/examples.json");

/// Puts recorded answers where an operation's JSON has no example of its own.
fn give_examples(document: &mut Value) {
    let recorded: Value = serde_json::from_str(RECORDED).unwrap_or_default();
    let paths = document["paths"].as_object_mut().into_iter().flatten();
    for (path, item) in paths {
        for (method, operation) in item.as_object_mut().into_iter().flatten() {
            let example = &recorded[format!("{method} {path}")];
            let responses = operation["responses"].as_object_mut();
            for (_, response) in responses.into_iter().flatten() {
                match response.pointer_mut("/content/application~1json") {
                    Some(content) if content["example"].is_null() => {
                        content["example"] = example.clone();
                    }
                    _ => {}
                }
            }
        }
    }
}

/// Puts the schemas of the documents that users write in the place of what the types of the handlers say of them.
fn describe_documents(document: &mut Value) {
    // Answers have schemas of the same names.
    let mut schemas = Schemas::referred("#/components/schemas/", "Document");
    for kind in DocumentKind::ALL {
        kind.root(&mut schemas);
    }
    further_designs_schema(&mut schemas);
    scene_question_schema(&mut schemas);
    analysis_schema(&mut schemas);
    if let Some(described) = document["components"]["schemas"].as_object_mut() {
        described.extend(schemas.definitions());
    }
}

/// A router that only has what is said of the whole service.
pub fn described() -> OpenApiRouter<AppState> {
    OpenApiRouter::with_openapi(Description::openapi())
}

/// All routes with their operations.
pub(crate) fn routes() -> OpenApiRouter<AppState> {
    described()
        .merge(study_routes::router())
        .merge(at_once::router())
        .merge(sweep_routes::router())
        .merge(comparison_routes::router())
        .merge(event_routes::router())
        .merge(answers::router())
        .merge(estimators::router())
        .merge(analysis_routes::router())
        .merge(preset_routes::router())
        .merge(health::router())
        .merge(login_routes::router())
        .merge(engine_routes::router())
        .merge(metric_routes::router())
        .merge(router())
}

/// Methods that operations have here.
const METHODS: [&str; 4] = ["get", "post", "patch", "delete"];

/// `/openapi.json` and `/docs`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new()
        .routes(routes!(description))
        .routes(routes!(page))
}

/// Get this description
///
/// OpenAPI 3.1, for people's programs and for generators of clients.
#[utoipa::path(get, path = "/openapi.json", tag = "service",
    responses((status = 200, description = "The description", body = Object, example = json!({"openapi": "3.1.0", "paths": {}}))))]
async fn description(
    State(state): State<AppState>,
    Extension(mount): Extension<Mount>,
) -> Json<Value> {
    Json(document(&state.access, &mount))
}

/// Read this description
///
/// Every operation on a page for people, with a filter and examples.
#[utoipa::path(get, path = "/docs", tag = "service",
    responses((status = 200, description = "The page", content_type = "text/html", body = String, example = json!("<!doctype html>..."))))]
async fn page(headers: HeaderMap) -> Response {
    assets::page("docs.html", &headers)
}

/// The description, with what lets a client in and where the service is.
fn document(access: &Access, mount: &Mount) -> Value {
    let mut document = DOCUMENT.clone();
    access.describe(&mut document);
    document["servers"] = json!([{"url": mount.address("/")}]);
    document
}

/// Every operation of a document.
fn operations(document: &mut Value) -> impl Iterator<Item = &mut Value> {
    let paths = document["paths"].as_object_mut().into_iter().flatten();
    paths.flat_map(|(_, item)| {
        let methods = item.as_object_mut().into_iter().flatten();
        methods
            .filter(|(name, _)| METHODS.contains(&name.as_str()))
            .map(|(_, operation)| operation)
    })
}

/// Describes what any operation may answer instead of its own answers.
fn problem() -> Value {
    json!({
        "description": "A problem: 400 for what can't be read, 401 without the token where one is asked for, 403 for a foreign Host or Origin, 404, 405, 408, \
                        413, 415, 429, 431, 500, 503 and 507, as their names say; 429, 503 and 507 say in `Retry-After` when to ask again",
        "content": {"application/problem+json": {
            "schema": {"$ref": "#/components/schemas/ProblemDocument"},
            "example": examples::absent(),
        }},
    })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::fs;

    use axum::Router;

    use super::*;

    /// The file from which the page's types and the Python client's are made.
    const COMMITTED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../web/openapi.json");

    /// Replaces numbers by what JavaScript, which writes the committed file, takes them for.
    fn as_script_reads(value: &mut Value) {
        match value {
            Value::Number(number) => *value = json!(number.as_f64()),
            Value::Array(items) => items.iter_mut().for_each(as_script_reads),
            Value::Object(fields) => fields.values_mut().for_each(as_script_reads),
            Value::Null | Value::Bool(_) | Value::String(_) => {}
        }
    }

    #[test]
    fn the_committed_description_is_that_of_the_routes() {
        let committed = fs::read_to_string(COMMITTED).expect("the committed description");
        let mut committed: Value = serde_json::from_str(&committed).expect("JSON");
        let mut served = document(&Access::of(None, 0), &Mount::read("/").expect("a path"));
        as_script_reads(&mut committed);
        as_script_reads(&mut served);
        let parts = |document: &Value| document.as_object().expect("an object").clone();
        let (committed, served) = (parts(&committed), parts(&served));
        let names: BTreeSet<&String> = committed.keys().chain(served.keys()).collect();
        let differing = names
            .into_iter()
            .filter(|&name| committed.get(name) != served.get(name));
        let differing: Vec<&String> = differing.collect();
        assert!(
            differing.is_empty(),
            "{differing:?} differ: run make generate, and commit what it made"
        );
    }

    /// The paths of a router, and those that axum adds to every router: it lists them nowhere but in its debugging text.
    fn paths(router: &Router<AppState>) -> BTreeSet<String> {
        let text = format!("{router:?}");
        let quoted = text.split('"').filter(|part| part.starts_with('/'));
        quoted.map(str::to_owned).collect()
    }

    #[test]
    fn the_router_and_the_description_have_the_same_paths() {
        let (router, described) = routes().split_for_parts();
        // The router takes {id}:apply and {id}:zero for an {id}, and its handlers tell them apart.
        let described = described.paths.paths.keys();
        let described = described.map(|path| match path.split_once("{id}:") {
            Some((before, _)) => format!("{before}{{id}}"),
            None => path.clone(),
        });
        let described: BTreeSet<String> = described.collect();
        let own = paths(&Router::new());
        let routed: BTreeSet<String> = paths(&router).difference(&own).cloned().collect();
        assert!(!routed.is_empty());
        assert_eq!(routed, described);
    }

    #[test]
    fn every_column_is_a_described_field_of_its_row() {
        let tables = DOCUMENT["x-tables"].as_object().expect("tables");
        assert!(!tables.is_empty());
        for (name, table) in tables {
            for column in table["columns"].as_array().expect("columns") {
                assert!(column["description"].is_string(), "{name}: {column}");
            }
        }
    }

    #[test]
    fn every_operation_is_described_with_examples() {
        let mut document = DOCUMENT.clone();
        assert_eq!(document["openapi"], "3.1.0");
        let schemas = document["components"]["schemas"].clone();
        let mut ids = BTreeSet::new();
        for operation in operations(&mut document) {
            let id = operation["operationId"].as_str().expect("an id");
            assert!(ids.insert(id.to_owned()), "{id} stands twice");
            for field in ["summary", "description", "tags"] {
                assert!(!operation[field].is_null(), "{id} has no {field}");
            }
            for (status, response) in operation["responses"].as_object().expect("responses") {
                assert!(response["description"].is_string(), "{id} {status}");
                for (kind, content) in response["content"].as_object().into_iter().flatten() {
                    assert!(!content["example"].is_null(), "{id} {status} {kind}");
                }
            }
            for (kind, content) in operation["requestBody"]["content"]
                .as_object()
                .into_iter()
                .flatten()
            {
                assert!(!content["example"].is_null(), "{id} {kind}");
            }
        }
        assert!(ids.len() > 10);
        for reference in document.to_string().split("#/components/schemas/").skip(1) {
            let name = reference.split('"').next().expect("a name");
            assert!(schemas[name].is_object(), "{name} is not described");
        }
    }
}
