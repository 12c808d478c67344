//! Ten thousand studies in the queue.

use std::time::{Duration, Instant};

use documents::study::Study;
use fem_client::closed_form::ClosedFormSolver;
use reqwest::StatusCode;

use crate::app::{Home, study};
use crate::timing::p99;

const STORED: usize = 9_500;
const SUBMITTED: usize = 500;
/// 50 and 100 ms on a quiet machine; tests share theirs with each other, and each submission waits for the disk.
const SUBMIT: Duration = Duration::from_secs(1);
const LIST: Duration = Duration::from_secs(1);

/// A solver that never gets beyond the first point, so that the queue stays as long as it is.
fn stuck() -> ClosedFormSolver {
    ClosedFormSolver::new().with_delay(Duration::from_secs(3600))
}

#[tokio::test(flavor = "multi_thread")]
async fn a_queue_of_ten_thousand_studies_takes_more_and_lists_them() {
    let home = Home::new();
    home.start(stuck())
        .await
        .service
        .stop()
        .await
        .expect("stops");
    let text = study().to_string();
    let format = document::Format::Json;
    let parsed = Study::from_document(&text, format, &|path| Err(path.to_owned())).expect("reads");
    let rows = "with recursive numbers(n) as (select 1 union all select n + 1 from numbers where n < ?1)
        insert into studies (id, name, spec, spec_sha256, state, created)
        select printf('00000000-0000-7000-8000-%012d', n), 'waiting', ?2, ?3, 'queued', '2026-11-22T00:00:00.000Z' from numbers";
    let stored = sqlx::query(rows)
        .bind(STORED as i64)
        .bind(parsed.canonical())
        .bind(parsed.spec_sha256())
        .execute(&mut home.sql().await)
        .await;
    stored.expect("stores");

    let app = home.start(stuck()).await;
    let (mut submits, mut lists) = (Vec::new(), Vec::new());
    for k in 0..SUBMITTED {
        let begun = Instant::now();
        assert_eq!(app.post(&study()).await.status(), StatusCode::ACCEPTED);
        submits.push(begun.elapsed());
        let begun = Instant::now();
        // A page of the newest, and one of those that wait, from the middle.
        let query = match k % 2 {
            0 => "limit=50".to_owned(),
            _ => format!(
                "limit=200&state=queued&cursor=00000000-0000-7000-8000-{:012}",
                10 * k + 1000
            ),
        };
        let page = app.json(&format!("/v1/studies?{query}")).await;
        lists.push(begun.elapsed());
        assert!(
            page["studies"]
                .as_array()
                .is_some_and(|list| list.len() >= 50)
        );
    }
    let count: i64 =
        sqlx::query_scalar("select count(*) from studies where state in ('queued', 'running')")
            .fetch_one(&mut home.sql().await)
            .await
            .expect("a count");
    assert_eq!(count as usize, STORED + SUBMITTED);
    let (submit, list) = (p99(submits), p99(lists));
    eprintln!("{count} studies: p99 of a submission {submit:?}, of a list {list:?}");
    assert!(submit < SUBMIT && list < LIST, "{submit:?} {list:?}");
    app.service.stop().await.expect("stops");
}
