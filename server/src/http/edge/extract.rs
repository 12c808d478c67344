//! Reads addresses and queries, with problem documents for those that can't be read.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use axum::extract::rejection::{PathRejection, QueryRejection};
use axum::extract::{FromRequestParts, Path, Query};
use axum::http::request::Parts;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use utoipa::IntoParams;

use crate::http::edge::problem_document::Problem;

/// The query of a request.
pub(crate) struct Params<T>(pub T);

impl<T: DeserializeOwned, S: Send + Sync> FromRequestParts<S> for Params<T> {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, Problem> {
        let refused =
            |error: QueryRejection| Problem::new(StatusCode::BAD_REQUEST, error.body_text());
        Query::from_request_parts(parts, state)
            .await
            .map(|Query(value)| Self(value))
            .map_err(refused)
    }
}

/// The study's identifier in an address.
pub(crate) struct StudyId(pub String);

/// The sweep's identifier in an address.
pub(crate) struct SweepId(pub String);

impl<S: Send + Sync> FromRequestParts<S> for StudyId {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, Problem> {
        identifier(parts, state).await.map(Self)
    }
}

impl<S: Send + Sync> FromRequestParts<S> for SweepId {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, Problem> {
        identifier(parts, state).await.map(Self)
    }
}

/// A document's name in an address.
pub(crate) struct DocumentName(pub String);

impl<S: Send + Sync> FromRequestParts<S> for DocumentName {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, Problem> {
        identifier(parts, state).await.map(Self)
    }
}

/// The estimator's identifier in an address.
pub(crate) struct EstimatorId(pub String);

/// Verb of what is done with an estimator: `{id}:apply` is one part of an address, and routes are told apart by whole parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Verb {
    Apply,
    Zero,
}

impl Verb {
    /// The verb at the end of an identifier, and the identifier.
    fn split(id: &str) -> Option<(&str, Self)> {
        let (id, verb) = id.rsplit_once(':')?;
        match verb {
            "apply" => Some((id, Self::Apply)),
            "zero" => Some((id, Self::Zero)),
            _ => None,
        }
    }
}

/// The identifier of an estimator with which something is done, and what.
pub(crate) struct DoneWithId(pub String, pub Verb);

impl<S: Send + Sync> FromRequestParts<S> for EstimatorId {
    type Rejection = Response;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, Response> {
        let id = identifier(parts, state).await;
        let id = id.map_err(IntoResponse::into_response)?;
        if Verb::split(&id).is_some() {
            return Err(wrong_method(&id));
        }
        Ok(Self(id))
    }
}

impl<S: Send + Sync> FromRequestParts<S> for DoneWithId {
    type Rejection = Response;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, Response> {
        let id = identifier(parts, state).await;
        let id = id.map_err(IntoResponse::into_response)?;
        let done = Verb::split(&id).map(|(id, verb)| Self(id.to_owned(), verb));
        done.ok_or_else(|| wrong_method(&id))
    }
}

/// The part of an address that either of them ends, whatever the method.
pub(crate) struct AnyEstimatorId(String);

impl<S: Send + Sync> FromRequestParts<S> for AnyEstimatorId {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, Problem> {
        identifier(parts, state).await.map(Self)
    }
}

/// Refuses a method that neither of them takes.
pub(crate) async fn no_method(AnyEstimatorId(id): AnyEstimatorId) -> Response {
    wrong_method(&id)
}

/// Answers as the router does, which doesn't know these addresses apart.
fn wrong_method(id: &str) -> Response {
    let allowed = if Verb::split(id).is_some() {
        "POST"
    } else {
        "GET,HEAD,DELETE"
    };
    let problem = Problem::new(
        StatusCode::METHOD_NOT_ALLOWED,
        "this address does not take that method; see the Allow header",
    );
    ([(header::ALLOW, allowed)], problem).into_response()
}

async fn identifier<S: Send + Sync>(parts: &mut Parts, state: &S) -> Result<String, Problem> {
    let refused = |error: PathRejection| Problem::new(StatusCode::BAD_REQUEST, error.body_text());
    let found = Path::from_request_parts(parts, state).await;
    found.map(|Path(id)| id).map_err(refused)
}

/// Description of a study's identifier.
#[derive(Debug, IntoParams)]
#[into_params(parameter_in = Path)]
#[expect(dead_code, reason = "it describes; StudyId reads")]
pub(crate) struct StudyPath {
    /// Identifier of the study, as its submission answered
    #[param(example = "019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6b")]
    id: String,
}

/// Description of a sweep's identifier.
#[derive(Debug, IntoParams)]
#[into_params(parameter_in = Path)]
#[expect(dead_code, reason = "it describes; SweepId reads")]
pub(crate) struct SweepPath {
    /// Identifier of the sweep, as its submission answered
    #[param(example = "019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6c")]
    id: String,
}

/// Description of an estimator's identifier.
#[derive(Debug, IntoParams)]
#[into_params(parameter_in = Path)]
#[expect(dead_code, reason = "it describes; EstimatorId and DoneWithId read")]
pub(crate) struct EstimatorPath {
    /// Identifier of the estimator, as its submission answered
    #[param(example = "019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6d")]
    id: String,
}

/// Whether a study, a sweep or an estimator is removed, or cancelled only.
#[derive(Debug, Deserialize, IntoParams)]
#[into_params(parameter_in = Query)]
pub(crate) struct RemovalQuery {
    /// Remove it for good: `purge` or `purge=true`
    #[param(example = "true", allow_reserved)]
    purge: Option<String>,
}

impl RemovalQuery {
    /// Whether it is to be removed.
    ///
    /// # Errors
    /// 400 for what is neither yes nor no.
    pub(crate) fn removes(&self) -> Result<bool, Problem> {
        match self.purge.as_deref() {
            Some("" | "true") => Ok(true),
            None | Some("false") => Ok(false),
            Some(_) => Err(Problem::new(
                StatusCode::BAD_REQUEST,
                "purge is true or false; without a value it means true",
            )),
        }
    }
}
