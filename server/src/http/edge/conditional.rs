//! Answers that needn't be sent again to a client that has them.

use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::Serialize;

use crate::http::edge::problem_document::Problem;
use store::content::sha256;

/// A document with a tag of its content, or 304 for a client that names the tag.
///
/// # Errors
/// 500 when the document can't be written as JSON.
pub fn json(headers: &HeaderMap, document: &impl Serialize) -> Result<Response, Problem> {
    let body = serde_json::to_vec(document).map_err(|error| {
        tracing::error!(%error, "an answer could not be written");
        Problem::new(
            StatusCode::INTERNAL_SERVER_ERROR,
            "the answer can't be written as JSON; the service's log says why",
        )
    })?;
    let kind = [(header::CONTENT_TYPE, "application/json")];
    let tag = sha256(&[&body]);
    Ok(tagged(headers, &tag, "no-cache", (kind, body)))
}

/// An answer with a tag and a rule for caches, or 304 for a client that names the tag.
pub(crate) fn tagged(
    headers: &HeaderMap,
    tag: &str,
    caching: &'static str,
    answer: impl IntoResponse,
) -> Response {
    let etag = format!("\"{tag}\"");
    let known = is_known(headers, &etag);
    let tagging = [
        (header::ETAG, etag),
        (header::CACHE_CONTROL, caching.to_owned()),
    ];
    if known {
        return (StatusCode::NOT_MODIFIED, tagging).into_response();
    }
    (tagging, answer).into_response()
}

/// Whether a client names the tag, so that it needs no body.
pub fn has(headers: &HeaderMap, tag: &str) -> bool {
    is_known(headers, &format!("\"{tag}\""))
}

/// Whether If-None-Match names the tag. Proxies that compress an answer mark its tag as weak.
fn is_known(headers: &HeaderMap, etag: &str) -> bool {
    let values = headers.get_all(header::IF_NONE_MATCH).iter();
    let texts = values.filter_map(|value| value.to_str().ok());
    let mut tags = texts.flat_map(|text| text.split(','));
    tags.any(|tag| {
        let tag = tag.trim();
        tag == "*" || tag.strip_prefix("W/").unwrap_or(tag) == etag
    })
}

#[cfg(test)]
mod tests {
    use axum::http::HeaderValue;

    use super::*;

    #[test]
    fn a_tag_is_known_in_any_of_the_ways_to_name_it() {
        let known = |values: &[&'static str]| {
            let mut headers = HeaderMap::new();
            for value in values {
                headers.append(header::IF_NONE_MATCH, HeaderValue::from_static(value));
            }
            is_known(&headers, "\"a\"")
        };
        for values in [
            &["\"a\""][..],
            &["W/\"a\""],
            &["\"b\", \"a\""],
            &["\"b\"", "\"a\""],
            &["*"],
        ] {
            assert!(known(values), "{values:?}");
        }
        for values in [&[][..], &["a"], &["\"b\""], &["\"ab\""], &[""]] {
            assert!(!known(values), "{values:?}");
        }
    }
}
