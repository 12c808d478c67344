//! Identifiers as people write them in addresses: `latest`, or the beginning of one.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::sync::Arc;

use axum::extract::{Request, State};
use axum::http::uri::PathAndQuery;
use axum::http::{StatusCode, Uri};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use store::Store;
use store::queue::short_names::{LATEST, Listing, meant};

use crate::http::edge::problem_document::Problem;

/// Characters of a whole identifier, a UUID.
const WHOLE: usize = 36;
/// Fewest characters of a beginning: fewer are no more than a guess.
const FEWEST: usize = 4;

/// An address that names one of a list by less than its identifier.
struct Short<'a> {
    listing: Listing,
    /// Part of the path in front of it, with the slash.
    before: &'a str,
    written: &'a str,
    after: &'a str,
}

impl<'a> Short<'a> {
    fn of(path: &'a str) -> Option<Self> {
        let listings = [Listing::Studies, Listing::Sweeps, Listing::Estimators];
        listings.into_iter().find_map(|listing| {
            let rest = path.strip_prefix("/v1/")?;
            let rest = rest.strip_prefix(listing.as_str())?.strip_prefix('/')?;
            let end = rest.find(['/', ':']).unwrap_or(rest.len());
            let (written, after) = rest.split_at_checked(end)?;
            let before = path.get(..path.len() - rest.len())?;
            is_short(written).then_some(Self {
                listing,
                before,
                written,
                after,
            })
        })
    }

    /// The address with the whole identifier, and the query.
    fn whole(&self, id: &str, uri: &Uri) -> Option<Uri> {
        let query = uri
            .query()
            .map_or_else(String::new, |query| format!("?{query}"));
        let path = format!("{}{id}{}{query}", self.before, self.after);
        let mut parts = uri.clone().into_parts();
        parts.path_and_query = Some(PathAndQuery::try_from(path).ok()?);
        Uri::from_parts(parts).ok()
    }
}

/// Whether it is `latest` or the beginning of an identifier.
fn is_short(written: &str) -> bool {
    let digits = |byte: u8| byte.is_ascii_hexdigit() || byte == b'-';
    let is_beginning = (FEWEST..WHOLE).contains(&written.len()) && written.bytes().all(digits);
    written == LATEST || is_beginning
}

/// The one that is meant; what none is stays as it is, and isn't found.
///
/// # Errors
/// 404 where more than one begins so; when the database can't be read.
pub(crate) async fn whole_id(
    store: &Store,
    listing: Listing,
    written: &str,
) -> Result<Option<String>, Problem> {
    if !is_short(written) {
        return Ok(None);
    }
    let mut connection = store.read().await?;
    let mut found = meant(&mut connection, listing, written).await?;
    match (found.pop(), found.is_empty()) {
        (Some(_), false) => {
            let one = listing.one();
            let detail =
                format!("more than one {one} begins with {written:?}: give more of the identifier");
            Err(Problem::new(StatusCode::NOT_FOUND, &detail))
        }
        (found, _) => Ok(found),
    }
}

/// Puts the whole identifier into a request's path. It stands outside of the router, which looks at the path.
pub(crate) async fn lengthen(
    State(store): State<Arc<Store>>,
    mut request: Request,
    next: Next,
) -> Response {
    let uri = request.uri().clone();
    if let Some(short) = Short::of(uri.path()) {
        match whole_id(&store, short.listing, short.written).await {
            Ok(Some(id)) => {
                if let Some(whole) = short.whole(&id, &uri) {
                    *request.uri_mut() = whole;
                }
            }
            Ok(None) => {}
            Err(problem) => return problem.into_response(),
        }
    }
    next.run(request).await
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_identifiers_are_told_from_whole_ones_and_from_other_words() {
        let whole = "01a21d2d-1a01-72b1-aafb-414819cc6ea6";
        let read = |path: &str| {
            Short::of(path).map(|short| (short.written.to_owned(), short.after.to_owned()))
        };
        let both = |written: &str, after: &str| Some((written.to_owned(), after.to_owned()));
        assert_eq!(read("/v1/studies/latest"), both("latest", ""));
        assert_eq!(read("/v1/studies/01a2/result"), both("01a2", "/result"));
        assert_eq!(
            read("/v1/sweeps/01a21d2d-1a:cancel"),
            both("01a21d2d-1a", ":cancel")
        );
        for other in [
            &format!("/v1/studies/{whole}"),
            "/v1/studies/01a",
            "/v1/studies/nobody",
            "/v1/studies",
            "/v1/presets/01a2",
            "/latest",
        ] {
            assert_eq!(read(other), None, "{other}");
        }
        let uri: Uri = "/v1/studies/01a2/map?direction=x"
            .parse()
            .expect("an address");
        let short = Short::of(uri.path()).expect("a beginning");
        let told = short.whole(whole, &uri).map(|uri| uri.to_string());
        assert_eq!(told, Some(format!("/v1/studies/{whole}/map?direction=x")));
    }
}
