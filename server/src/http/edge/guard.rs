//! Guard: only pages and programs that mean this service may ask.
//!
//! The service listens on a loopback address, but any web page that the user opens can send requests there, under a
//! name that its owner points at 127.0.0.1. So the Host must be one of ours, and a write that a browser sends must
//! come from our own page.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::net::{Ipv6Addr, SocketAddr};
use std::sync::Arc;

use axum::extract::{Request, State};
use axum::http::{HeaderMap, HeaderName, HeaderValue, Method, StatusCode, Uri, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

use crate::http::edge::problem_document::Problem;

/// A name under which others reach the service, and the port when it isn't the service's own.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HostName(String);

impl HostName {
    /// Reads `NAME`, `NAME:PORT`, or the same with an address of either family.
    ///
    /// # Errors
    /// A sentence that says what would be right.
    pub fn read(text: &str) -> Result<Self, String> {
        let (name, port) = match text.rsplit_once(':') {
            Some((name, port)) if !port.ends_with(']') => (name, Some(port)),
            _ => (text, None),
        };
        let numbered = name.strip_prefix('[').and_then(|n| n.strip_suffix(']'));
        let named = !name.is_empty()
            && name
                .bytes()
                .all(|byte| byte.is_ascii_alphanumeric() || b"-._".contains(&byte));
        let fits = numbered.map_or(named, |ip| ip.parse::<Ipv6Addr>().is_ok())
            && port.is_none_or(|port| port.parse::<u16>().is_ok_and(|port| port > 0));
        fits.then(|| Self(text.to_owned())).ok_or_else(|| {
            "a host is NAME or NAME:PORT, as in tires.example or 192.168.1.2:8080".to_owned()
        })
    }

    /// The values of Host that mean this name: without a port both the scheme's own and the service's.
    fn values(&self, port: u16) -> Vec<String> {
        let bare = self.0.clone();
        match bare.rsplit_once(':') {
            Some((_, port)) if !port.ends_with(']') => vec![bare],
            _ => vec![format!("{bare}:{port}"), bare],
        }
    }
}

/// The values of Host under which the service answers.
#[derive(Debug, Clone)]
pub struct HostList {
    own: Arc<[String]>,
    /// Names that the service was given. A proxy may stand before it and speak TLS under them.
    given: Arc<[String]>,
}

impl HostList {
    /// Loopback names and the bound address, each with the bound port; and the names given.
    pub fn of(address: SocketAddr, given: &[HostName]) -> Self {
        let port = address.port();
        let own = match address {
            SocketAddr::V4(v4) => v4.ip().to_string(),
            SocketAddr::V6(v6) => format!("[{}]", v6.ip()),
        };
        let names = ["127.0.0.1", "localhost", "[::1]", &own].map(str::to_owned);
        let with_port = names.iter().map(|name| format!("{name}:{port}"));
        // A browser leaves the port out when it is the scheme's own.
        let bare = names.iter().filter(|_| port == 80).cloned();
        Self {
            own: with_port.chain(bare).collect(),
            given: given.iter().flat_map(|name| name.values(port)).collect(),
        }
    }

    fn check(&self, method: &Method, target: &Uri, headers: &HeaderMap) -> Result<(), Problem> {
        let mut hosts = headers.get_all(header::HOST).iter();
        let (Some(host), None) = (hosts.next(), hosts.next()) else {
            return Err(Problem::new(
                StatusCode::BAD_REQUEST,
                "a request needs exactly one Host header",
            ));
        };
        // Of a target with a host of its own, that is the one which is meant (RFC 9112, 3.2.2).
        let host = target
            .authority()
            .map_or(host.as_bytes(), |host| host.as_str().as_bytes());
        let among = |names: &[String]| {
            let is_host = |name: &String| host.eq_ignore_ascii_case(name.as_bytes());
            names.iter().any(is_host)
        };
        let given = among(&self.given);
        if !given && !among(&self.own) {
            let names = [&*self.own, &*self.given].concat().join(", ");
            return Err(Problem::new(
                StatusCode::FORBIDDEN,
                format!("this service answers as {names} only"),
            ));
        }
        if headers.len() > MOST_HEADERS {
            let detail = format!("a request has at most {MOST_HEADERS} headers");
            return Err(Problem::new(
                StatusCode::REQUEST_HEADER_FIELDS_TOO_LARGE,
                detail,
            ));
        }
        if let Some(twice) = ONCE.iter().find(|name| is_double(headers, name)) {
            let detail = format!("a request has one {twice} header at most");
            return Err(Problem::new(StatusCode::BAD_REQUEST, detail));
        }
        let reads = matches!(*method, Method::GET | Method::HEAD | Method::OPTIONS);
        let own_origin = |origin: &HeaderValue| {
            let says = |scheme: &[u8]| origin.as_bytes().strip_prefix(scheme) == Some(host);
            says(b"http://") || (given && says(b"https://"))
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

/// Headers of one value: which of two is meant, nobody knows.
const ONCE: [&str; 5] = [
    "Authorization",
    "Content-Type",
    "Idempotency-Key",
    "Last-Event-ID",
    "X-Forwarded-Prefix",
];

fn is_double(headers: &HeaderMap, name: &str) -> bool {
    headers.get_all(name).iter().nth(1).is_some()
}

/// Browsers send about twenty.
const MOST_HEADERS: usize = 100;

/// Refuses requests that don't mean this service.
pub async fn admit(State(hosts): State<HostList>, request: Request, next: Next) -> Response {
    match hosts.check(request.method(), request.uri(), request.headers()) {
        Ok(()) => next.run(request).await,
        Err(problem) => problem.into_response(),
    }
}

/// Tells browsers to keep to this service's own files, and to guess nothing; and caches to keep nothing of which nobody says how long.
pub(crate) async fn harden(request: Request, next: Next) -> Response {
    let mut response = next.run(request).await;
    let headers = response.headers_mut();
    for (name, value) in SECURITY_HEADERS {
        headers.insert(name, HeaderValue::from_static(value));
    }
    let (name, value) = UNKEPT;
    headers
        .entry(name)
        .or_insert(HeaderValue::from_static(value));
    response
}

/// Rule for caches of an answer that has none.
pub(crate) const UNKEPT: (HeaderName, &str) = (header::CACHE_CONTROL, "no-store");

/// Headers of every answer.
pub(crate) const SECURITY_HEADERS: [(HeaderName, &str); 5] = [
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
        status_of("/", method, pairs)
    }

    fn status_of(
        target: &str,
        method: Method,
        pairs: &[(&'static str, &str)],
    ) -> Option<StatusCode> {
        let target = target.parse().expect("a target");
        let mut headers = HeaderMap::new();
        for (name, value) in pairs {
            headers.append(*name, HeaderValue::from_str(value).expect("header"));
        }
        let given = HostName::read("tires.example").expect("a name");
        let hosts = HostList::of("127.0.0.1:8080".parse().expect("address"), &[given]);
        hosts
            .check(&method, &target, &headers)
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
            "tires.example",
            "Tires.Example:8080",
        ] {
            assert_eq!(status(Method::GET, &[("host", host)]), None, "{host}");
        }
        for host in [
            "evil.example",
            "evil.example:8080",
            "127.0.0.1",
            "127.0.0.1:80",
            "localhost.evil.example:8080",
            "tires.example:80",
            "tires.example.evil.example",
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
    fn the_host_of_a_target_is_the_one_that_is_meant() {
        let host = [("host", "localhost:8080")];
        let asked = |target| status_of(target, Method::GET, &host);
        assert_eq!(asked("http://localhost:8080/"), None);
        for target in [
            "http://evil.example/",
            "http://a@localhost:8080/",
            "evil.example:80",
        ] {
            assert_eq!(asked(target), Some(StatusCode::FORBIDDEN), "{target}");
        }
    }

    #[test]
    fn a_header_of_one_value_stands_once() {
        for name in ["idempotency-key", "content-type", "last-event-id"] {
            let twice = [("host", "localhost:8080"), (name, "a"), (name, "b")];
            let refused = Some(StatusCode::BAD_REQUEST);
            assert_eq!(status(Method::POST, &twice), refused, "{name}");
            assert_eq!(status(Method::POST, &twice[..2]), None, "{name}");
        }
    }

    #[test]
    fn names_of_hosts_are_read_and_others_are_refused() {
        for text in [
            "tires.example",
            "tires.example:443",
            "10.0.0.7",
            "[fe80::1]:8080",
            "[fe80::1]",
        ] {
            assert!(HostName::read(text).is_ok(), "{text}");
        }
        for text in [
            "",
            ":80",
            "a b",
            "tires.example:",
            "tires.example:0",
            "tires.example:99999",
            "http://tires.example",
            "*",
            "fe80::1",
            "[x]",
        ] {
            assert!(HostName::read(text).is_err(), "{text}");
        }
    }

    #[test]
    fn only_our_own_page_may_write() {
        let from = |origin| [("host", "localhost:8080"), ("origin", origin)];
        assert_eq!(status(Method::POST, &from("http://localhost:8080")), None);
        assert_eq!(status(Method::POST, &[("host", "localhost:8080")]), None);
        let behind_a_proxy = [
            ("host", "tires.example"),
            ("origin", "https://tires.example"),
        ];
        assert_eq!(status(Method::POST, &behind_a_proxy), None);
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
