//! Who may ask: only pages and programs that mean this service.
//!
//! The service listens on a loopback address, but any web page that the user opens can send requests there, under a
//! name that its owner points at 127.0.0.1. So the Host must be one of ours, and a write that a browser sends must
//! come from our own page.

use std::net::SocketAddr;
use std::sync::Arc;

use axum::extract::{Request, State};
use axum::http::{HeaderMap, HeaderName, HeaderValue, Method, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

use super::problem::Problem;

/// The values of Host under which the service answers.
#[derive(Debug, Clone)]
pub struct HostList(Arc<[String]>);

impl HostList {
    /// Loopback names and the bound address, each with the bound port.
    pub fn of(address: SocketAddr) -> Self {
        let port = address.port();
        let own = match address {
            SocketAddr::V4(v4) => v4.ip().to_string(),
            SocketAddr::V6(v6) => format!("[{}]", v6.ip()),
        };
        let names = ["127.0.0.1", "localhost", "[::1]", &own].map(str::to_owned);
        let with_port = names.iter().map(|name| format!("{name}:{port}"));
        // A browser leaves the port out when it is the scheme's own.
        let bare = names.iter().filter(|_| port == 80).cloned();
        Self(with_port.chain(bare).collect())
    }

    fn check(&self, method: &Method, headers: &HeaderMap) -> Result<(), Problem> {
        let mut hosts = headers.get_all(header::HOST).iter();
        let (Some(host), None) = (hosts.next(), hosts.next()) else {
            return Err(Problem::new(
                StatusCode::BAD_REQUEST,
                "a request needs exactly one Host header",
            ));
        };
        let known = self
            .0
            .iter()
            .any(|name| host.as_bytes().eq_ignore_ascii_case(name.as_bytes()));
        if !known {
            return Err(Problem::new(
                StatusCode::FORBIDDEN,
                format!("this service answers as {} only", self.0.join(", ")),
            ));
        }
        if headers.contains_key(header::CONTENT_LENGTH)
            && headers.contains_key(header::TRANSFER_ENCODING)
        {
            let detail = "a request can't have both Content-Length and Transfer-Encoding";
            return Err(Problem::new(StatusCode::BAD_REQUEST, detail));
        }
        let reads = matches!(*method, Method::GET | Method::HEAD | Method::OPTIONS);
        let own_origin = |origin: &HeaderValue| {
            origin.as_bytes().strip_prefix(b"http://") == Some(host.as_bytes())
        };
        if !reads && !headers.get_all(header::ORIGIN).iter().all(own_origin) {
            return Err(Problem::new(
                StatusCode::FORBIDDEN,
                "pages of another origin can't change anything here",
            ));
        }
        Ok(())
    }
}

/// Refuses requests that don't mean this service.
pub async fn admit(State(hosts): State<HostList>, request: Request, next: Next) -> Response {
    match hosts.check(request.method(), request.headers()) {
        Ok(()) => next.run(request).await,
        Err(problem) => problem.into_response(),
    }
}

/// Tells browsers to keep to this service's own files, and to guess nothing.
pub async fn harden(request: Request, next: Next) -> Response {
    let mut response = next.run(request).await;
    for (name, value) in SECURITY_HEADERS {
        response
            .headers_mut()
            .insert(name, HeaderValue::from_static(value));
    }
    response
}

const SECURITY_HEADERS: [(HeaderName, &str); 5] = [
    (
        header::CONTENT_SECURITY_POLICY,
        "default-src 'self'; img-src 'self' data:; object-src 'none'; base-uri 'none'; form-action 'self'; \
         frame-ancestors 'none'",
    ),
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::X_FRAME_OPTIONS, "DENY"),
    (header::REFERRER_POLICY, "no-referrer"),
    (
        HeaderName::from_static("cross-origin-resource-policy"),
        "same-origin",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    fn status(method: Method, pairs: &[(&'static str, &str)]) -> Option<StatusCode> {
        let mut headers = HeaderMap::new();
        for (name, value) in pairs {
            headers.append(*name, HeaderValue::from_str(value).expect("header"));
        }
        let hosts = HostList::of("127.0.0.1:8080".parse().expect("address"));
        hosts
            .check(&method, &headers)
            .err()
            .map(|problem| problem.into_response().status())
    }

    #[test]
    fn only_our_own_hosts_are_answered() {
        for host in [
            "127.0.0.1:8080",
            "localhost:8080",
            "LOCALHOST:8080",
            "[::1]:8080",
        ] {
            assert_eq!(status(Method::GET, &[("host", host)]), None, "{host}");
        }
        for host in [
            "evil.example",
            "evil.example:8080",
            "127.0.0.1",
            "127.0.0.1:80",
            "localhost.evil.example:8080",
        ] {
            assert_eq!(
                status(Method::GET, &[("host", host)]),
                Some(StatusCode::FORBIDDEN),
                "{host}"
            );
        }
        assert_eq!(status(Method::GET, &[]), Some(StatusCode::BAD_REQUEST));
        let twice = [("host", "localhost:8080"), ("host", "localhost:8080")];
        assert_eq!(status(Method::GET, &twice), Some(StatusCode::BAD_REQUEST));
    }

    #[test]
    fn only_our_own_page_may_write() {
        let from = |origin| [("host", "localhost:8080"), ("origin", origin)];
        assert_eq!(status(Method::POST, &from("http://localhost:8080")), None);
        assert_eq!(status(Method::POST, &[("host", "localhost:8080")]), None);
        for origin in [
            "http://localhost:3000",
            "https://localhost:8080",
            "null",
            "http://evil.example",
        ] {
            assert_eq!(
                status(Method::POST, &from(origin)),
                Some(StatusCode::FORBIDDEN),
                "{origin}"
            );
            assert_eq!(
                status(Method::DELETE, &from(origin)),
                Some(StatusCode::FORBIDDEN),
                "{origin}"
            );
            assert_eq!(status(Method::GET, &from(origin)), None, "{origin}");
        }
    }
}
