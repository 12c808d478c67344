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
    let kind = page.headers()["content-type"].to_str().expect("text");
    assert!(kind.starts_with("text/html"), "{kind}");
    let html = page.text().await.expect("text");
    let scripts = html.split("src=\"").skip(1);
    let scripts: Vec<&str> = scripts.filter_map(|rest| rest.split('"').next()).collect();
    assert!(!scripts.is_empty(), "{html}");
    for script in scripts {
        // Relative to the page, which stands at the root here.
        let beside = script.strip_prefix("./").expect("a relative address");
        let found = app.get(&format!("/{beside}")).await;
        assert_eq!(found.status(), StatusCode::OK, "{script}");
    }
    for foreign in ["http://", "https://", "@import"] {
        assert!(!html.contains(foreign), "{foreign}");
    }
}
