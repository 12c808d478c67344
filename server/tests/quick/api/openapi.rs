//! The description of the service, and the service as described.

use fem_client::closed_form::ClosedFormSolver;
use reqwest::{Method, StatusCode};

use crate::app::{Home, problem};

#[tokio::test(flavor = "multi_thread")]
async fn what_is_described_is_there_and_nothing_else() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let document = app.json("/openapi.json").await;
    for (path, item) in document["paths"].as_object().expect("paths") {
        let url = app.url(&path.replace("{id}", "none"));
        for method in [
            Method::GET,
            Method::POST,
            Method::DELETE,
            Method::PUT,
            Method::PATCH,
        ] {
            let described = item.get(method.as_str().to_lowercase()).is_some();
            let answer = app
                .client
                .request(method.clone(), &url)
                .send()
                .await
                .expect("an answer");
            if described {
                assert_ne!(
                    answer.status(),
                    StatusCode::METHOD_NOT_ALLOWED,
                    "{method} {path}"
                );
            } else {
                problem(answer, StatusCode::METHOD_NOT_ALLOWED).await;
            }
        }
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn the_page_of_the_description_needs_nothing_from_elsewhere() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let page = app.get("/docs").await;
    assert_eq!(page.headers()["content-type"], "text/html; charset=utf-8");
    let html = page.text().await.expect("text");
    for path in app.json("/openapi.json").await["paths"]
        .as_object()
        .expect("paths")
        .keys()
    {
        assert!(html.contains(path.as_str()), "{path} is not on the page");
    }
    for foreign in ["<script", "src=", "http://", "https://", "@import"] {
        assert!(!html.contains(foreign), "{foreign}");
    }
}
