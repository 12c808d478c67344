//! Access where a token is asked for.
//!
//! Programs send the token with every request. A browser can't, so it is sent to an address that works once, and gets a cookie there:
//! no script can read it, and no other site can make the browser send it.

use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use axum::extract::{Request, State};
use axum::http::{HeaderMap, Method, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use serde_json::{Value, json};

use crate::http::edge::connection_slots::{AskedWhole, Standing};
use crate::http::edge::problem_document::Problem;
use crate::http::mount::Mount;
use crate::token::{Token, TokenError};

/// The rule by which requests are let in. Without a token all are.
#[derive(Clone)]
pub struct Access(Option<Arc<Keys>>);

/// Keys that let in.
pub(crate) struct Keys {
    token: Token,
    cookie_name: String,
    cookie: Token,
    /// Token of the address that works once, and since when; gone when it was said.
    once: Mutex<Option<(Token, Instant)>>,
}

/// Lifetime of the address that works once: it stands in a terminal's history, and in that of a browser.
const LINK_LIFETIME: Duration = Duration::from_secs(600);

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

    /// A path that lets one browser in, once and within ten minutes; the one before works no more. `None` where no token is asked for.
    ///
    /// # Errors
    /// When the system has no random numbers.
    pub fn link(&self) -> Result<Option<String>, TokenError> {
        let Some(keys) = &self.0 else {
            return Ok(None);
        };
        let once = Token::random()?;
        let path = format!("/login?once={}", once.reveal());
        *keys.once.lock().unwrap_or_else(PoisonError::into_inner) = Some((once, Instant::now()));
        Ok(Some(path))
    }

    /// Adds to the description of the service what it says of this.
    pub fn describe(&self, document: &mut Value) {
        let Some(keys) = &self.0 else {
            return;
        };
        document["components"]["securitySchemes"] = json!({
            "token": {"type": "http", "scheme": "bearer", "description": "The token that the service was started with"},
            "cookie": {"type": "apiKey", "in": "cookie", "name": keys.cookie_name, "description": "Cookie that a browser gets at `/login`"},
        });
        document["security"] = json!([{"token": []}, {"cookie": []}]);
    }

    /// The keys, where a token is asked for.
    pub(crate) fn keys(&self) -> Option<&Keys> {
        self.0.as_deref()
    }

    pub(crate) fn admits(&self, headers: &HeaderMap) -> bool {
        let Some(keys) = &self.0 else {
            return true;
        };
        bearer(headers).is_some_and(|said| keys.token.is(said))
            || cookies(headers, &keys.cookie_name).any(|said| keys.cookie.is(said.as_bytes()))
    }
}

impl Keys {
    /// Uses the address that works once up, when this is what it has to say.
    pub(crate) fn redeem(&self, said: &str, now: Instant) -> bool {
        let mut once = self.once.lock().unwrap_or_else(PoisonError::into_inner);
        // One that is too old goes, whatever is said.
        once.take_if(|(_, since)| now.duration_since(*since) > LINK_LIFETIME);
        once.take_if(|(once, _)| once.is(said.as_bytes())).is_some()
    }

    /// The cookie, which a browser shows to nothing beside the service.
    pub(crate) fn set_cookie(&self, mount: &Mount) -> String {
        let (name, value) = (&self.cookie_name, self.cookie.reveal());
        let path = mount.address("/");
        format!("{name}={value}; HttpOnly; SameSite=Strict; Path={path}")
    }
}

/// Returns what follows `Bearer` in the one Authorization header.
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

/// Lets a connection belong: at once with a token, else when the whole request has come.
fn belonging(request: Request, knows_token: bool) -> Request {
    let Some(standing) = request.extensions().get::<Standing>().cloned() else {
        return request;
    };
    if knows_token {
        standing.belongs();
        return request;
    }
    request.map(|body| AskedWhole::of(body, standing))
}

/// Refuses who doesn't know the token. Whether the service is up is no secret, and the address that works once is a key of its own.
pub(crate) async fn authorise(
    State(access): State<Access>,
    request: Request,
    next: Next,
) -> Response {
    let open = match request.uri().path() {
        "/healthz" | "/readyz" => true,
        "/login" => *request.method() == Method::GET,
        _ => false,
    };
    let admitted = access.admits(request.headers());
    // Where no token is asked for, a health check says nothing of who asks.
    let request = match admitted && (!open || access.keys().is_some()) {
        true => belonging(request, access.keys().is_some()),
        false => request,
    };
    if open || admitted {
        return next.run(request).await;
    }
    let detail = "this service asks for its token, as in Authorization: Bearer TOKEN; a browser is let in by the address that the \
                  service printed at its start";
    Problem::new(StatusCode::UNAUTHORIZED, detail).into_response()
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
        let now = Instant::now();
        assert!(!keys.redeem(&first, now) && !keys.redeem("", now));
        assert!(keys.redeem(&second, now));
        assert!(!keys.redeem(&second, now));
        let third = secret();
        let too_late = Instant::now() + LINK_LIFETIME + Duration::from_secs(1);
        assert!(!keys.redeem(&third, too_late) && !keys.redeem(&third, now));
        assert_eq!(Access::of(None, 8080).link(), Ok(None));
    }
}
