//! Answers that are packed by gzip for clients that take them so: a result is a fifth as long.
//!
//! Events go out as they are, because each has to leave at once; so do answers too short to gain. What is packed has another content than what the tag was made
//! of, so that its tag is a weak one (RFC 9110, 8.8.1).

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use axum::http::{HeaderValue, header};
use axum::response::Response;
use tower_http::CompressionLevel;
use tower_http::compression::CompressionLayer;
use tower_http::compression::predicate::{And, DefaultPredicate, Predicate, SizeAbove};

/// Answers shorter than this fit into one packet anyway, bytes.
const SHORT: u64 = 1024;

/// Packs answers.
pub fn layer() -> CompressionLayer<And<DefaultPredicate, SizeAbove>> {
    CompressionLayer::new()
        .quality(CompressionLevel::Default)
        .compress_when(DefaultPredicate::new().and(SizeAbove::new(SHORT)))
}

/// Makes the tag of a packed answer a weak one.
pub(crate) async fn weaken(mut answer: Response) -> Response {
    let headers = answer.headers_mut();
    if headers.contains_key(header::CONTENT_ENCODING)
        && let Some(tag) = headers.get(header::ETAG)
        && !tag.as_bytes().starts_with(b"W/")
        && let Ok(weak) = HeaderValue::from_bytes(&[b"W/", tag.as_bytes()].concat())
    {
        headers.insert(header::ETAG, weak);
    }
    answer
}
