//! The clock on the wall decides nothing but what is written beside an event.

use std::path::{Path, PathBuf};

use reqwest::header::HeaderValue;
use serde_json::{Value, json};

use crate::program::service::{Program, draft, serving};

/// Debian's `faketime` puts it there, on a machine of any architecture.
fn library() -> Option<PathBuf> {
    let folders = std::fs::read_dir("/usr/lib").ok()?;
    let found = folders
        .filter_map(|folder| Some(folder.ok()?.path().join("faketime/libfaketimeMT.so.1")))
        .find(|path| path.exists());
    if found.is_none() {
        eprintln!("skipped: Debian's package faketime isn't installed");
    }
    found
}

/// A service whose clock on the wall is off by what a file says, now and whenever it changes.
fn start(database: &Path, library: &Path, offset: &Path) -> Program {
    let mut command = serving(database);
    command
        .env("LD_PRELOAD", library)
        .env("FAKETIME_TIMESTAMP_FILE", offset)
        .env("FAKETIME_NO_CACHE", "1")
        // A jump of the wall's clock leaves the monotonic one alone.
        .env("FAKETIME_DONT_FAKE_MONOTONIC", "1");
    Program::run(&mut command)
}

async fn events(program: &Program, id: &str) -> Vec<Value> {
    let text = program.get(&format!("/v1/studies/{id}/events")).await;
    let text = text.text().await.expect("a stream");
    let data = text.lines().filter_map(|line| line.strip_prefix("data:"));
    data.map(|json| serde_json::from_str(json).expect("JSON"))
        .collect()
}

fn year(event: &Value) -> i32 {
    let time = event["time"].as_str().expect("a time");
    time[..4].parse().expect("a year")
}

#[tokio::test(flavor = "multi_thread")]
async fn a_clock_that_jumps_ten_years_and_back_disturbs_no_study() {
    let Some(library) = library() else { return };
    let folder = tempfile::tempdir().expect("temp dir");
    let offset = folder.path().join("offset");
    let jump = |to: &str| std::fs::write(&offset, to).expect("writes");
    jump("+0");
    let program = start(&folder.path().join("test.db"), &library, &offset);
    let mut long = draft();
    long["accuracy"] = json!({"preset": "coarse"});
    let id = program.submit(&long).await;
    let solved = |points: i64| move |study: &Value| study["points_done"].as_i64() >= Some(points);
    program.wait(&id, solved(3)).await;
    jump("+10y");
    program.wait(&id, solved(12)).await;
    jump("-10y");
    let forward = program.result_hash(&id).await;

    let events = events(&program, &id).await;
    let kinds = |kind: &str| events.iter().filter(|event| event["kind"] == kind).count();
    // Taken up once: a lease that had expired would have put it back into the queue.
    assert_eq!((kinds("queued"), kinds("done")), (1, 1));
    let years: Vec<i32> = events.iter().map(year).collect();
    let (first, last) = (years[0], years[years.len() - 1]);
    assert!(
        years.contains(&(first + 10)),
        "the clock didn't jump: {years:?}"
    );
    assert_eq!(last, first - 10, "the clock didn't jump back: {years:?}");

    // What is submitted in the past is solved too, and an ETag or a Last-Event-ID from the future still holds.
    let later = program.submit(&draft()).await;
    program.result_hash(&later).await;
    let etag = HeaderValue::from_str(&format!("\"{forward}\"")).expect("a header");
    let result = format!("{}/v1/studies/{id}/result", program.url);
    let request = program.client.get(result).header("if-none-match", etag);
    assert_eq!(request.send().await.expect("an answer").status(), 304);
}
