//! `/v1/studies/{id}/events`.

use std::sync::Arc;
use std::time::{Duration, Instant};

use fem_client::closed_form::ClosedFormSolver;
use fem_client::solver::{SolveError, SolveProgress, SolveRequest, Solved, Solver, Stage};
use reqwest::StatusCode;
use serde_json::Value;

use crate::app::{App, Home, problem, slow, study};

/// An event as a browser would see it.
#[derive(Debug, Clone, PartialEq)]
struct Seen {
    id: i64,
    kind: String,
    data: Value,
}

fn read(text: &str) -> Vec<Seen> {
    let field = |block: &str, name: &str| {
        let line = block
            .lines()
            .find_map(|line| line.strip_prefix(name)?.strip_prefix(':'));
        line.map(|value| value.trim_start().to_owned())
    };
    let blocks = text.split("\n\n").filter(|block| block.contains("data:"));
    let event = |block: &str| Seen {
        id: field(block, "id")
            .expect("an id")
            .parse()
            .expect("a number"),
        kind: field(block, "event").expect("a kind"),
        data: serde_json::from_str(&field(block, "data").expect("data")).expect("JSON"),
    };
    blocks.map(event).collect()
}

/// The whole stream, which must end by itself.
async fn stream(app: &App, id: &str, after: Option<i64>) -> Vec<Seen> {
    let mut request = app.client.get(app.url(&format!("/v1/studies/{id}/events")));
    if let Some(after) = after {
        request = request.header("last-event-id", after);
    }
    let response = request.send().await.expect("an answer");
    assert_eq!(response.status(), StatusCode::OK);
    assert_eq!(response.headers()["content-type"], "text/event-stream");
    read(&response.text().await.expect("a stream"))
}

#[tokio::test(flavor = "multi_thread")]
async fn events_come_in_order_and_the_stream_ends_with_the_study() {
    let home = Home::new();
    let app = home.start(slow()).await;
    let id = app.submit(&study()).await;
    let events = stream(&app, &id, None).await;

    let kinds: Vec<&str> = events.iter().map(|event| event.kind.as_str()).collect();
    assert_eq!(kinds[..2], ["queued", "started"]);
    assert_eq!(kinds[2..28], ["point-solved"; 26]);
    assert_eq!(kinds[28..], ["analysing", "done"]);
    assert!(events.windows(2).all(|pair| pair[0].id < pair[1].id));
    assert_eq!(events[1].data["points"], 26);
    assert_eq!(events[2].data["ordinal"], 0, "the cut point comes first");
    let counts: Vec<i64> = events[2..28]
        .iter()
        .filter_map(|event| event.data["done"].as_i64())
        .collect();
    assert_eq!(counts, (1..=26).collect::<Vec<_>>());
    assert!(
        events.iter().all(
            |event| event.data["kind"] == event.kind.as_str() && event.data["time"].is_string()
        )
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn a_client_that_comes_back_gets_exactly_what_it_missed() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = app.submit(&study()).await;
    app.wait_for(&id, "done").await;
    let all = stream(&app, &id, None).await;
    let missed = stream(&app, &id, Some(all[9].id)).await;
    assert_eq!(missed, all[10..]);

    // A number of another database: all there is comes, and the end.
    assert_eq!(stream(&app, &id, Some(1_000_000)).await, all);

    let last = all.last().expect("events").id;
    let nothing = app
        .client
        .get(app.url(&format!("/v1/studies/{id}/events")))
        .header("last-event-id", last);
    assert_eq!(
        nothing.send().await.expect("an answer").status(),
        StatusCode::NO_CONTENT
    );
    let wrong = app
        .client
        .get(app.url(&format!("/v1/studies/{id}/events")))
        .header("last-event-id", "yesterday");
    problem(
        wrong.send().await.expect("an answer"),
        StatusCode::BAD_REQUEST,
    )
    .await;
    problem(
        app.get("/v1/studies/none/events").await,
        StatusCode::NOT_FOUND,
    )
    .await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_cancelled_study_ends_its_stream() {
    let home = Home::new();
    let app = home.start(slow()).await;
    let id = app.submit(&study()).await;
    let (events, _) = tokio::join!(stream(&app, &id, None), async {
        app.wait(&id, |study| study["points_done"].as_i64() >= Some(1))
            .await;
        app.delete(&format!("/v1/studies/{id}")).await
    });
    assert_eq!(
        events.last().map(|event| event.kind.as_str()),
        Some("cancelled")
    );
    // The queue has done with a study when it has done with the next one; nothing may follow the last event.
    let next = app.submit(&study()).await;
    app.wait_for(&next, "done").await;
    assert_eq!(stream(&app, &id, None).await, events);
}

#[tokio::test(flavor = "multi_thread")]
async fn stopping_the_service_ends_open_streams() {
    let home = Home::new();
    let app = home.start(slow()).await;
    let id = app.submit(&study()).await;
    let mut response = app.get(&format!("/v1/studies/{id}/events")).await;
    response.chunk().await.expect("a first event");
    let begun = Instant::now();
    app.service.stop().await.expect("stops");
    while let Ok(Some(_)) = response.chunk().await {}
    // A solve heeds its flag within milliseconds here; the bound is the grace that requests in flight are given.
    assert!(begun.elapsed().as_secs() < 5);
}

/// Tells of its first solve, as long as that takes.
struct Telling(ClosedFormSolver);

impl Solver for Telling {
    fn version(&self) -> String {
        self.0.version()
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let begun = Instant::now();
        let mut iterations = 0;
        while request.start.is_none() && begun.elapsed() < Duration::from_millis(700) {
            iterations += 1;
            request.watch.tell(SolveProgress {
                stage: Stage::Pressing,
                share: 0.25,
                iterations,
                residual: Some(1e-3),
            });
            std::thread::sleep(Duration::from_millis(5));
        }
        self.0.solve(request)
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn solves_under_way_are_told_to_those_who_look_and_not_kept() {
    let home = Home::new();
    let app = home
        .start_on(Arc::new(Telling(ClosedFormSolver::new())))
        .await;
    let id = app.submit(&study()).await;
    let response = app.get(&format!("/v1/studies/{id}/events")).await;
    let text = response.text().await.expect("a stream");
    let told: Vec<Value> = text
        .split("\n\n")
        .filter(|block| block.contains("event: solving"))
        .map(|block| {
            assert!(!block.contains("id:"), "{block}");
            let data = block.lines().find_map(|line| line.strip_prefix("data: "));
            serde_json::from_str(data.expect("data")).expect("JSON")
        })
        .collect();
    // 200 ms apart at least.
    assert!((1..=4).contains(&told.len()), "{text}");
    let [solve] = &told[0]["solves"].as_array().expect("solves")[..] else {
        panic!("{told:?}")
    };
    assert_eq!(solve["ordinal"], 0);
    assert_eq!(solve["stage"], "pressing");
    assert_eq!(
        (&solve["share"], &solve["residual"]),
        (&0.25.into(), &1e-3.into())
    );
    assert!(solve["iterations"].as_u64() > Some(1));
    let again = stream(&app, &id, None).await;
    assert!(again.iter().all(|event| event.kind != "solving"));
    assert_eq!(again.last().map(|event| event.kind.as_str()), Some("done"));
}
