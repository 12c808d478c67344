//! A full disk costs the writes of that time and nothing else.

use std::time::{Duration, Instant};

use reqwest::StatusCode;
use serde_json::{Value, json};

use crate::program::service::{Program, draft, integrity};
use crate::program::{strainsite, text};
use crate::small_disk::SmallDisk;

/// Submissions far beyond what a disk of a few megabytes takes.
const MOST: usize = 20_000;
/// Time that the service promises, from freed space to the first write.
const RESUMED: Duration = Duration::from_secs(5);

fn id(study: &Value) -> String {
    study["id"].as_str().expect("an id").to_owned()
}

#[tokio::test(flavor = "multi_thread")]
async fn a_full_disk_costs_writes_while_it_is_full_and_nothing_else() {
    let Some(disk) = SmallDisk::mount(64) else {
        return;
    };
    let database = disk.path().join("full.db");
    let program = Program::start(&database);
    let mut accepted = vec![program.submit(&draft()).await];
    let expected = program.result_hash(&accepted[0]).await;

    // Enough for some points of a study, not for all of them.
    let filler = disk.fill_but(100_000);
    let mut other = draft();
    other["inputs"][0]["distribution"]["max"] = json!(1.29);
    let interrupted = program.submit(&other).await;
    let refused = loop {
        let answer = program.post(&draft()).await;
        if answer.status() != StatusCode::ACCEPTED {
            break answer;
        }
        accepted.push(id(&answer.json().await.expect("JSON")));
        assert!(accepted.len() < MOST, "the disk doesn't get full");
    };
    assert_eq!(refused.status(), StatusCode::INSUFFICIENT_STORAGE);
    let kind = &refused.headers()["content-type"];
    assert_eq!(kind, "application/problem+json");
    let problem: Value = refused.json().await.expect("JSON");
    let detail = problem["detail"].as_str().expect("a sentence");
    assert!(detail.contains("full"), "{detail}");

    // Longer than the queue waits before it tries again.
    let full = Instant::now();
    while full.elapsed() < Duration::from_secs(6) {
        let result = format!("/v1/studies/{}/result", accepted[0]);
        for path in ["/healthz", "/v1/studies", &result] {
            program.json(path).await;
        }
        tokio::time::sleep(Duration::from_millis(100)).await;
    }
    std::fs::remove_file(filler).expect("frees");
    let freed = Instant::now();
    loop {
        let answer = program.post(&draft()).await;
        if answer.status() == StatusCode::ACCEPTED {
            accepted.push(id(&answer.json().await.expect("JSON")));
            break;
        }
        assert!(freed.elapsed() < RESUMED, "{}", answer.status());
        tokio::time::sleep(Duration::from_millis(20)).await;
    }
    eprintln!(
        "{} studies were taken in; writes resumed after {:?}",
        accepted.len(),
        freed.elapsed()
    );
    for study in &accepted {
        assert_eq!(program.result_hash(study).await, expected);
    }
    let undisturbed = Program::start(&disk.path().join("other.db"));
    let expected = undisturbed
        .result_hash(&undisturbed.submit(&other).await)
        .await;
    assert_eq!(program.result_hash(&interrupted).await, expected);
    program.kill();
    assert_eq!(integrity(&database).await, "ok");
    let check = strainsite(disk.path(), &["db", "check", "--db", "full.db"]);
    assert_eq!(check.status.code(), Some(0), "{}", text(&check.stdout));
}
