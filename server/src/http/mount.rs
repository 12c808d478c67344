//! The path below which the service is seen, where a proxy serves other things beside it.
//!
//! A proxy sends requests on with that path in front or without it; both are understood. Every address that the service gives has it in front. The path is a
//! setting, or what the proxy says in `X-Forwarded-Prefix`, where a setting says that a proxy does: a client could say anything there.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::sync::Arc;

use axum::extract::{Request, State};
use axum::http::uri::PathAndQuery;
use axum::http::{HeaderMap, HeaderName, HeaderValue, StatusCode, Uri, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

use crate::http::edge::problem_document::Problem;

const X_FORWARDED_PREFIX: HeaderName = HeaderName::from_static("x-forwarded-prefix");

/// Longest path, bytes.
const LONGEST: usize = 200;

/// A path in front of all others, without a slash at its end; empty at the root.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mount(Arc<str>);

impl Default for Mount {
    fn default() -> Self {
        Self("".into())
    }
}

impl Mount {
    /// Reads `/` or `/a/b`, with or without a slash at its end.
    ///
    /// # Errors
    /// A sentence that says what would be right.
    pub fn read(text: &str) -> Result<Self, String> {
        let path = text.strip_suffix('/').unwrap_or(text);
        let fits = |part: &str| {
            let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-._~".contains(&byte);
            !matches!(part, "" | "." | "..") && part.bytes().all(plain)
        };
        let rooted = text.starts_with('/') && text.len() <= LONGEST;
        let read = rooted && (path.is_empty() || path.split('/').skip(1).all(fits));
        read.then(|| Self(path.into())).ok_or_else(|| {
            format!(
                "a path is /NAME or /NAME/NAME of letters, digits and -._~, as in /strainsite, and has at most {LONGEST} bytes"
            )
        })
    }

    /// The address of a path of the service.
    pub fn address(&self, path: &str) -> String {
        format!("{}{path}", self.0)
    }

    /// Returns what follows the mount in a path; `None` where it isn't in front.
    fn within<'p>(&self, path: &'p str) -> Option<&'p str> {
        let rest = path.strip_prefix(&*self.0)?;
        (rest.is_empty() || rest.starts_with('/')).then_some(rest)
    }
}

/// The rule by which the mount of a request is found.
#[derive(Debug, Clone, Default)]
pub struct Mounting {
    /// Mount of requests that say nothing of it.
    pub base: Mount,
    /// Whether `X-Forwarded-Prefix` is believed.
    pub trusts_prefix: bool,
}

impl Mounting {
    fn of(&self, headers: &HeaderMap) -> Result<Mount, Problem> {
        let said = headers.get(X_FORWARDED_PREFIX);
        let Some(said) = said.filter(|_| self.trusts_prefix) else {
            return Ok(self.base.clone());
        };
        let read = said
            .to_str()
            .map_err(|_| String::new())
            .and_then(Mount::read);
        read.map_err(|_| {
            let detail =
                "X-Forwarded-Prefix is a path of letters, digits and -._~, as in /strainsite";
            Problem::new(StatusCode::BAD_REQUEST, detail)
        })
    }
}

/// Takes the mount off a request's path, and puts it in front of the address that an answer leads to. It stands outside of the router, which looks at the path.
pub(crate) async fn unmount(
    State(mounting): State<Mounting>,
    mut request: Request,
    next: Next,
) -> Response {
    let mount = match mounting.of(request.headers()) {
        Ok(mount) => mount,
        Err(problem) => return problem.into_response(),
    };
    match mount.within(request.uri().path()) {
        // Addresses on a page are relative to it: without the slash they would lead beside the mount.
        Some("") => return leading_to(&mount.address("/")),
        Some(_) => *request.uri_mut() = unmounted(request.uri(), &mount),
        None => {}
    }
    request.extensions_mut().insert(mount.clone());
    let mut response = next.run(request).await;
    let location = response.headers().get(header::LOCATION);
    let location = location.and_then(|location| location.to_str().ok());
    if let Some(own) = location.filter(|location| location.starts_with('/'))
        && let Ok(address) = HeaderValue::from_str(&mount.address(own))
    {
        response.headers_mut().insert(header::LOCATION, address);
    }
    response
}

fn leading_to(address: &str) -> Response {
    (
        StatusCode::PERMANENT_REDIRECT,
        [(header::LOCATION, address)],
    )
        .into_response()
}

/// The address without the mount; the same where it can't be made, which the router doesn't know then.
fn unmounted(uri: &Uri, mount: &Mount) -> Uri {
    let rest = uri
        .path_and_query()
        .and_then(|whole| mount.within(whole.as_str()));
    let mut parts = uri.clone().into_parts();
    parts.path_and_query = rest.and_then(|rest| PathAndQuery::try_from(rest).ok());
    Uri::from_parts(parts).unwrap_or_else(|_| uri.clone())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_read_and_others_are_refused() {
        for (text, address) in [
            ("/", "/v1"),
            ("/strainsite", "/strainsite/v1"),
            ("/a/b-1/", "/a/b-1/v1"),
        ] {
            assert_eq!(
                Mount::read(text).map(|m| m.address("/v1")),
                Ok(address.to_owned())
            );
        }
        for text in [
            "",
            "strainsite",
            "//evil.example",
            "/a//b",
            "/a/../b",
            "/a b",
            "/a?x",
            "/\u{e9}",
            "/a\"b",
        ] {
            assert!(Mount::read(text).is_err(), "{text}");
        }
        assert!(Mount::read(&format!("/{}", "a".repeat(LONGEST))).is_err());
    }

    #[test]
    fn the_mount_comes_off_whole_parts_alone() {
        let mount = Mount::read("/site").expect("a path");
        for (path, rest) in [
            ("/site/v1/studies?limit=1", Some("/v1/studies?limit=1")),
            ("/site/", Some("/")),
            ("/sites/v1", None),
            ("/v1", None),
        ] {
            let uri: Uri = path.parse().expect("an address");
            let within = mount.within(uri.path()).is_some();
            assert_eq!(within, rest.is_some(), "{path}");
            if let Some(rest) = rest {
                assert_eq!(unmounted(&uri, &mount).to_string(), rest);
            }
        }
    }

    #[test]
    fn a_proxy_is_believed_where_that_is_asked_for_alone() {
        let mut headers = HeaderMap::new();
        headers.insert(X_FORWARDED_PREFIX, HeaderValue::from_static("/said"));
        let mounting = |trusts_prefix| Mounting {
            base: Mount::default(),
            trusts_prefix,
        };
        let found = |mounting: Mounting| mounting.of(&headers).map(|mount| mount.address("/"));
        assert_eq!(found(mounting(true)).expect("is read"), "/said/");
        assert_eq!(found(mounting(false)).expect("is left aside"), "/");
    }
}
