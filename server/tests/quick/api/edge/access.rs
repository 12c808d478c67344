//! A service that asks for a token.

use reqwest::{Method, RequestBuilder, Response, StatusCode};
use serde_json::Value;
use server::http::edge::guard::HostName;
use server::running::Outside;
use server::token::Token;

use crate::app::{App, Home, problem, study};

const SECRET: &str = "the-token-of-these-tests";

fn locked() -> Outside {
    Outside {
        token: Some(Token::chosen(SECRET).expect("fits")),
        hosts: vec![HostName::read("tires.example").expect("a name")],
        ..Outside::default()
    }
}

async fn send(request: RequestBuilder) -> Response {
    request.send().await.expect("an answer")
}

/// Uses the address that lets a browser in, and returns its cookie, as a browser would send it.
async fn browse(app: &App, path: &str) -> String {
    let answer = app.get(path).await;
    assert_eq!(answer.status(), StatusCode::SEE_OTHER);
    assert_eq!(answer.headers()["location"], "/");
    assert_eq!(answer.headers()["cache-control"], "no-store");
    let cookie = answer.headers()["set-cookie"].to_str().expect("text");
    for attribute in ["; HttpOnly", "; SameSite=Strict", "; Path=/"] {
        assert!(cookie.contains(attribute), "{cookie}");
    }
    assert!(!cookie.contains(SECRET));
    cookie.split(';').next().expect("a pair").to_owned()
}

#[tokio::test(flavor = "multi_thread")]
async fn nothing_but_health_is_answered_without_the_token() {
    let home = Home::new();
    let app = home.start_for(locked()).await;
    for path in ["/healthz", "/readyz"] {
        assert_eq!(app.get(path).await.status(), StatusCode::OK, "{path}");
    }
    let requests = [
        (Method::GET, "/"),
        (Method::GET, "/v1/studies"),
        (Method::POST, "/v1/studies"),
        (Method::DELETE, "/v1/studies/x"),
        (Method::GET, "/v1/studies/x/events"),
        (Method::GET, "/openapi.json"),
        (Method::GET, "/docs"),
        (Method::GET, "/favicon.svg"),
        (Method::GET, "/v1/nothing"),
        (Method::POST, "/healthz/"),
        (Method::HEAD, "/login"),
        (Method::POST, "/login"),
    ];
    for (method, path) in requests {
        let ask = || app.client.request(method.clone(), app.url(path));
        let wrong = format!("{SECRET}x");
        for request in [
            ask(),
            ask().bearer_auth(&wrong),
            ask().header("cookie", format!("strainsite={SECRET}")),
        ] {
            let answer = send(request).await;
            assert_eq!(
                answer.headers()["www-authenticate"],
                "Bearer",
                "{method} {path}"
            );
            if method == Method::HEAD {
                assert_eq!(answer.status(), StatusCode::UNAUTHORIZED);
                continue;
            }
            let body = problem(answer, StatusCode::UNAUTHORIZED).await;
            let text = body.to_string();
            assert!(
                text.contains("Authorization: Bearer") && !text.contains(SECRET),
                "{text}"
            );
        }
        let let_in = send(ask().bearer_auth(SECRET)).await;
        assert_ne!(let_in.status(), StatusCode::UNAUTHORIZED, "{method} {path}");
    }
    let submitted = app.client.post(app.url("/v1/studies")).bearer_auth(SECRET);
    let submitted = send(submitted.json(&study())).await;
    assert_eq!(submitted.status(), StatusCode::ACCEPTED);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_browser_is_let_in_once_and_then_by_its_cookie() {
    let home = Home::new();
    let app = home.start_for(locked()).await;
    let path = app
        .service
        .login()
        .expect("a token is asked for")
        .to_owned();
    for wrong in ["/login", "/login?once=", "/login?once=0123456789abcdef"] {
        problem(app.get(wrong).await, StatusCode::UNAUTHORIZED).await;
    }
    let cookie = browse(&app, &path).await;
    problem(app.get(&path).await, StatusCode::UNAUTHORIZED).await;
    // The browser that is in may come back to it.
    let again = app.client.get(app.url(&path)).header("cookie", &cookie);
    assert_eq!(send(again).await.status(), StatusCode::SEE_OTHER);

    let with_cookie = |path: &str| app.client.get(app.url(path)).header("cookie", &cookie);
    assert_eq!(
        send(with_cookie("/")).await.headers()["content-type"],
        "text/html"
    );
    let post = app
        .client
        .post(app.url("/v1/studies"))
        .header("cookie", &cookie);
    let own = send(
        post.try_clone()
            .expect("no body")
            .header("origin", app.url(""))
            .json(&study()),
    )
    .await;
    assert_eq!(own.status(), StatusCode::ACCEPTED);
    let foreign = post.header("origin", "http://evil.example").json(&study());
    problem(send(foreign).await, StatusCode::FORBIDDEN).await;
    let id = own.json::<Value>().await.expect("JSON")["id"].clone();
    let events = format!("/v1/studies/{}/events", id.as_str().expect("an id"));
    let stream = send(with_cookie(&events)).await;
    assert_eq!(stream.headers()["content-type"], "text/event-stream");
    assert!(
        stream
            .text()
            .await
            .expect("a stream")
            .contains("event: done")
    );

    let invitation = send(app.client.post(app.url("/login")).header("cookie", &cookie)).await;
    assert_eq!(invitation.status(), StatusCode::CREATED);
    let invitation: Value = invitation.json().await.expect("JSON");
    browse(&app, invitation["path"].as_str().expect("a path")).await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_cookie_outlives_a_restart_with_the_same_token_and_no_other() {
    let home = Home::new();
    let app = home.start_for(locked()).await;
    let cookie = browse(&app, app.service.login().expect("a token is asked for")).await;
    let (_, value) = cookie.split_once('=').expect("a pair");
    app.service.stop().await.expect("stops");
    for (token, status) in [
        (SECRET, StatusCode::OK),
        ("another-token-than-before", StatusCode::UNAUTHORIZED),
    ] {
        let outside = Outside {
            token: Some(Token::chosen(token).expect("fits")),
            ..Outside::default()
        };
        let app = home.start_for(outside).await;
        // The port is another one here, and with it the cookie's name.
        let name = format!("strainsite-{}", app.service.address().port());
        let request = app.client.get(app.url("/v1/studies"));
        let request = request.header("cookie", format!("{name}={value}"));
        assert_eq!(send(request).await.status(), status);
        app.service.stop().await.expect("stops");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_service_is_reached_under_the_name_it_was_given_and_through_a_proxy_with_tls() {
    let home = Home::new();
    let app = home.start_for(locked()).await;
    let post = |host: &str, origin: &str| {
        let request = app.client.post(app.url("/v1/studies")).bearer_auth(SECRET);
        send(
            request
                .header("host", host)
                .header("origin", origin)
                .json(&study()),
        )
    };
    let accepted = post("tires.example", "https://tires.example").await;
    assert_eq!(accepted.status(), StatusCode::ACCEPTED);
    let foreign = post("tires.example", "https://evil.example").await;
    problem(foreign, StatusCode::FORBIDDEN).await;
    let unknown = post("rims.example", "https://rims.example").await;
    problem(unknown, StatusCode::FORBIDDEN).await;
}

#[tokio::test(flavor = "multi_thread")]
async fn the_description_says_what_lets_a_client_in() {
    let home = Home::new();
    let app = home.start_for(locked()).await;
    let answer = send(app.client.get(app.url("/openapi.json")).bearer_auth(SECRET)).await;
    let document: Value = answer.json().await.expect("JSON");
    let schemes = &document["components"]["securitySchemes"];
    assert_eq!(schemes["token"]["scheme"], "bearer");
    let port = app.service.address().port();
    assert_eq!(schemes["cookie"]["name"], format!("strainsite-{port}"));
    assert_eq!(
        document["security"],
        serde_json::json!([{"token": []}, {"cookie": []}])
    );
    for path in ["/healthz", "/readyz", "/login"] {
        let open = &document["paths"][path]["get"]["security"];
        assert_eq!(open, &serde_json::json!([{}]), "{path}");
    }
    app.service.stop().await.expect("stops");

    let app = home.start_for(Outside::default()).await;
    assert_eq!(app.json("/openapi.json").await["security"], Value::Null);
    problem(app.get("/login").await, StatusCode::NOT_FOUND).await;
}
