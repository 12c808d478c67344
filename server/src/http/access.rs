//! Who is let in, where a token is asked for.
//!
//! Programs send the token with every request. A browser can't, so it is sent to an address that works once, and gets a cookie there:
//! no script can read it, and no other site can make the browser send it.

use std::sync::{Arc, Mutex, PoisonError};

use axum::Json;
use axum::extract::{Request, State};
use axum::http::{HeaderMap, Method, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use serde::Deserialize;
use serde_json::{Value, json};
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use super::AppState;
use super::extract::Params;
use super::problem::Problem;
use crate::token::{Token, TokenError};
use service::wire::examples;
use service::wire::study_wire::{LoginLink, ProblemDocument};

/// The rule by which requests are let in. Without a token all are.
#[derive(Clone)]
pub struct Access(Option<Arc<Keys>>);

struct Keys {
    token: Token,
    cookie_name: String,
    cookie: Token,
    /// What the address that works once has to say; gone when it was said.
    once: Mutex<Option<Token>>,
}

impl Access {
    /// Lets in who knows the token, and without a token everybody. The port tells the cookies of services on one machine apart:
    /// browsers don't.
    pub fn of(token: Option<Token>, port: u16) -> Self {
        Self(token.map(|token| {
            Arc::new(Keys {
                cookie_name: format!("strainsite-{port}"),
                cookie: token.derived("cookie"),
                once: Mutex::new(None),
                token,
            })
        }))
    }

    /// A path that lets one browser in, once; the one before works no more. `None` where no token is asked for.
    ///
    /// # Errors
    /// When the system has no random numbers.
    pub fn link(&self) -> Result<Option<String>, TokenError> {
        let Some(keys) = &self.0 else {
            return Ok(None);
        };
        let once = Token::random()?;
        let path = format!("/login?once={}", once.reveal());
        *keys.once.lock().unwrap_or_else(PoisonError::into_inner) = Some(once);
        Ok(Some(path))
    }

    /// What the description of the service says of this.
    pub fn describe(&self, document: &mut Value) {
        let Some(keys) = &self.0 else {
            return;
        };
        document["components"]["securitySchemes"] = json!({
            "token": {"type": "http", "scheme": "bearer", "description": "The token that the service was started with"},
            "cookie": {"type": "apiKey", "in": "cookie", "name": keys.cookie_name, "description": "What a browser gets at `/login`"},
        });
        document["security"] = json!([{"token": []}, {"cookie": []}]);
    }

    fn admits(&self, headers: &HeaderMap) -> bool {
        let Some(keys) = &self.0 else {
            return true;
        };
        bearer(headers).is_some_and(|said| keys.token.is(said))
            || cookies(headers, &keys.cookie_name).any(|said| keys.cookie.is(said.as_bytes()))
    }
}

impl Keys {
    /// Uses the address that works once up, when this is what it has to say.
    fn redeem(&self, said: &str) -> bool {
        let mut once = self.once.lock().unwrap_or_else(PoisonError::into_inner);
        once.take_if(|once| once.is(said.as_bytes())).is_some()
    }

    fn set_cookie(&self) -> String {
        let (name, value) = (&self.cookie_name, self.cookie.reveal());
        format!("{name}={value}; HttpOnly; SameSite=Strict; Path=/")
    }
}

/// What follows `Bearer` in the one Authorization header.
fn bearer(headers: &HeaderMap) -> Option<&[u8]> {
    let mut values = headers.get_all(header::AUTHORIZATION).iter();
    let (value, None) = (values.next()?, values.next()) else {
        return None;
    };
    let (scheme, said) = value.as_bytes().split_at_checked("Bearer ".len())?;
    scheme.eq_ignore_ascii_case(b"Bearer ").then_some(said)
}

/// The values of all cookies of this name.
fn cookies<'h>(headers: &'h HeaderMap, name: &str) -> impl Iterator<Item = &'h str> {
    let values = headers.get_all(header::COOKIE).iter();
    let texts = values.filter_map(|value| value.to_str().ok());
    let pairs = texts.flat_map(|text| {
        text.split(';')
            .filter_map(|pair| pair.trim().split_once('='))
    });
    pairs
        .filter(move |(known, _)| *known == name)
        .map(|(_, value)| value)
}

/// Refuses who doesn't know the token. Whether the service is up is no secret, and the address that works once is a key of its own.
pub async fn authorise(State(access): State<Access>, request: Request, next: Next) -> Response {
    let open = match request.uri().path() {
        "/healthz" | "/readyz" => true,
        "/login" => *request.method() == Method::GET,
        _ => false,
    };
    if open || access.admits(request.headers()) {
        return next.run(request).await;
    }
    let detail = "this service asks for its token, as in Authorization: Bearer TOKEN; a browser is let in by the address that the \
                  service printed at its start";
    Problem::new(StatusCode::UNAUTHORIZED, detail).into_response()
}

/// `/login`.
pub fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new().routes(routes!(login, invite))
}

#[derive(Deserialize)]
struct LoginQuery {
    once: Option<String>,
}

/// Let a browser in
///
/// The address that the service prints at its start, or that `POST /login` answers with. It works once: the browser gets a cookie and is sent to the
/// dashboard.
#[utoipa::path(get, path = "/login", tag = "service", security(()),
    params(("once" = Option<String>, Query, description = "The secret of the address", example = "af5570f5a1810b7af78caf4bc70a660f")),
    responses((status = 303, description = "The browser is in", headers(("Location" = String, description = "The dashboard"), ("Set-Cookie" = String, description = "What lets it in from now on"))),
              (status = 401, description = "The address was used, or never given", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::locked())),
              (status = 404, description = "This service asks for no token", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn login(
    State(state): State<AppState>,
    headers: HeaderMap,
    Params(query): Params<LoginQuery>,
) -> Result<Response, Problem> {
    let keys = state.access.0.as_ref().ok_or_else(no_token)?;
    let dashboard = (header::LOCATION, "/".to_owned());
    // Browsers open some addresses twice, the first time to be quick.
    if state.access.admits(&headers) {
        return Ok((StatusCode::SEE_OTHER, [dashboard]).into_response());
    }
    if !query.once.is_some_and(|said| keys.redeem(&said)) {
        let detail = "this address works once, and was used or replaced by a newer one: POST /login with the token gives another";
        return Err(Problem::new(StatusCode::UNAUTHORIZED, detail));
    }
    let headers = [
        dashboard,
        (header::SET_COOKIE, keys.set_cookie()),
        (header::CACHE_CONTROL, "no-store".to_owned()),
    ];
    Ok((StatusCode::SEE_OTHER, headers).into_response())
}

/// Get an address for another browser
///
/// It lets one browser in, once, without the token; the one before works no more.
#[utoipa::path(post, path = "/login", tag = "service",
    responses((status = 201, description = "The address", body = LoginLink, example = json!({"path": "/login?once=af5570f5a1810b7af78caf4bc70a660f"})),
              (status = 404, description = "This service asks for no token", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn invite(State(state): State<AppState>) -> Result<Response, Problem> {
    let link = state
        .access
        .link()
        .map_err(|error| Problem::new(StatusCode::INTERNAL_SERVER_ERROR, error.to_string()))?;
    let path = link.ok_or_else(no_token)?;
    let headers = [(header::CACHE_CONTROL, "no-store")];
    Ok((StatusCode::CREATED, headers, Json(LoginLink { path })).into_response())
}

fn no_token() -> Problem {
    Problem::not_found("this service asks for no token: every browser on this machine is in")
}

#[cfg(test)]
mod tests {
    use axum::http::HeaderValue;

    use super::*;

    fn admitted(access: &Access, pairs: &[(header::HeaderName, String)]) -> bool {
        let mut headers = HeaderMap::new();
        for (name, value) in pairs {
            headers.append(name, HeaderValue::from_str(value).expect("a header"));
        }
        access.admits(&headers)
    }

    #[test]
    fn the_token_and_the_cookie_let_in_and_nothing_else_does() {
        let token = Token::random().expect("random numbers");
        let access = Access::of(Some(token.clone()), 8080);
        let authorization = |text: String| (header::AUTHORIZATION, text);
        let cookie = |text: String| (header::COOKIE, text);
        let (secret, session) = (token.reveal(), token.derived("cookie"));
        let session = session.reveal();
        for right in [
            authorization(format!("Bearer {secret}")),
            authorization(format!("bearer {secret}")),
            cookie(format!("a=b; strainsite-8080={session}")),
        ] {
            assert!(admitted(&access, &[right]));
        }
        for wrong in [
            authorization(String::new()),
            authorization("Bearer ".to_owned()),
            authorization(format!("Basic {secret}")),
            authorization(secret.to_owned()),
            authorization(format!("Bearer {session}")),
            cookie(format!("strainsite-8080={secret}")),
            cookie(format!("strainsite-8081={session}")),
        ] {
            assert!(!admitted(&access, &[wrong]));
        }
        let twice = [(); 2].map(|()| authorization(format!("Bearer {secret}")));
        assert!(!admitted(&access, &twice));
        assert!(!admitted(&access, &[]));
        assert!(admitted(&Access::of(None, 8080), &[]));
    }

    #[test]
    fn an_address_works_once_and_a_newer_one_replaces_it() {
        let access = Access::of(Token::random().ok(), 8080);
        let secret = || {
            let path = access.link().expect("random numbers").expect("a token");
            path.strip_prefix("/login?once=")
                .expect("a secret")
                .to_owned()
        };
        let keys = access.0.as_ref().expect("a token");
        let (first, second) = (secret(), secret());
        assert!(!keys.redeem(&first) && !keys.redeem(""));
        assert!(keys.redeem(&second));
        assert!(!keys.redeem(&second));
        assert_eq!(Access::of(None, 8080).link(), Ok(None));
    }
}
