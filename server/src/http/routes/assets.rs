//! The dashboard: files built into the binary.

use axum::body::Body;
use axum::extract::Request;
use axum::http::{HeaderMap, Method, StatusCode, header};
use axum::response::{IntoResponse, Response};
use fem_client::hexadecimal::hexadecimal;
use rust_embed::{Embed, EmbeddedFile};

use crate::http::edge::conditional::tagged;
use crate::http::edge::problem_document::Problem;

#[derive(Embed)]
#[folder = "../web/dist"]
#[allow_missing = true]
struct Dashboard;

const INDEX: &str = "index.html";

/// Answers what no route answers: a file of the dashboard, the way to its first page from any other address that a browser opens, or a problem document.
pub(crate) async fn fallback(request: Request) -> Response {
    let path = request.uri().path();
    let nothing = || Problem::not_found(format!("there is nothing at {path:?}")).into_response();
    if path == "/v1" || path.starts_with("/v1/") {
        return nothing();
    }
    if !matches!(*request.method(), Method::GET | Method::HEAD) {
        return Problem::new(StatusCode::METHOD_NOT_ALLOWED, "pages can only be read")
            .into_response();
    }
    let name = path.trim_start_matches('/');
    if let Some(file) = Dashboard::get(name) {
        return serve(name, file, request.headers());
    }
    match Dashboard::get(INDEX) {
        Some(file) if path == "/" => serve(INDEX, file, request.headers()),
        // Addresses on the page are relative to its own.
        Some(_) if wants_a_page(request.headers()) => {
            (StatusCode::SEE_OTHER, [(header::LOCATION, "/")]).into_response()
        }
        _ => nothing(),
    }
}

/// A page of the dashboard by its name.
pub fn page(name: &str, headers: &HeaderMap) -> Response {
    match Dashboard::get(name) {
        Some(file) => serve(name, file, headers),
        None => {
            Problem::not_found(format!("this program was built without {name}")).into_response()
        }
    }
}

fn wants_a_page(headers: &HeaderMap) -> bool {
    headers
        .get_all(header::ACCEPT)
        .iter()
        .filter_map(|accept| accept.to_str().ok())
        .any(|accept| accept.contains("text/html"))
}

fn serve(name: &str, file: EmbeddedFile, headers: &HeaderMap) -> Response {
    let hash = hexadecimal(&file.metadata.sha256_hash());
    // Files under assets/ have their content's hash in their names.
    let caching = if name.starts_with("assets/") {
        "public, max-age=31536000, immutable"
    } else {
        "no-cache"
    };
    let kind = [(header::CONTENT_TYPE, file.metadata.mimetype().to_owned())];
    tagged(headers, &hash, caching, (kind, Body::from(file.data)))
}
