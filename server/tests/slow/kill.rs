//! SIGKILL against the real program: what was stored survives, nothing is solved twice, the result is the same.

use std::path::Path;
use std::time::{Duration, Instant};

use crate::program::service::{Program, draft, integrity, sql};
use serde_json::{Value, json};

/// Kills of one study after the first; each comes a different while after a start.
const KILLS: u32 = 20;
/// Time far beyond the start of a solve or the end of a process.
const PATIENCE: Duration = Duration::from_secs(60);
/// Names how many kills there are to be in all.
const MORE: &str = "STRAINSITE_KILLS";

/// Returns how many kills there are to be, where nobody asks for more.
pub fn kills(few: u32) -> u32 {
    std::env::var(MORE).map_or(few, |text| text.parse().expect("a whole number"))
}

/// Row number, key and time of every evaluation, in the order in which they were stored.
async fn evaluations(database: &Path) -> Vec<(i64, String, String)> {
    sqlx::query_as("select rowid, key, created from evaluations order by rowid")
        .fetch_all(&mut sql(database).await)
        .await
        .expect("rows")
}

/// The draft study with so many points that it isn't over before the last kill.
fn long() -> Value {
    let mut document = draft();
    document["method"]["check_points"] = json!(150);
    document
}

#[tokio::test(flavor = "multi_thread")]
async fn a_study_killed_again_and_again_loses_nothing_and_gives_the_same_result() {
    let folder = tempfile::tempdir().expect("temp dir");
    let undisturbed = Program::start(&folder.path().join("undisturbed.db"));
    let id = undisturbed.submit(&long()).await;
    let expected = undisturbed.result_hash(&id).await;
    for round in 0..kills(KILLS).div_ceil(KILLS) {
        let database = folder.path().join(format!("killed-{round}.db"));
        killed_again_and_again(&database, round, &expected).await;
    }
}

async fn killed_again_and_again(database: &Path, round: u32, expected: &str) {
    let program = Program::start(database);
    let id = program.submit(&long()).await;
    program
        .wait(&id, |study| study["points_done"].as_i64() >= Some(3))
        .await;
    program.kill();
    let mut stored = evaluations(database).await;
    assert!(stored.len() >= 3, "{} points", stored.len());

    let mut in_the_middle = 0;
    for kill in 0..KILLS {
        let program = Program::start(database);
        // From 0 to 95 ms in an order without a pattern: 7 has no factor in common with 20. Other rounds fall in between.
        let wait = kill * 7 % 20 * 5 + round % 5;
        tokio::time::sleep(Duration::from_millis(u64::from(wait))).await;
        program.kill();
        let now = evaluations(database).await;
        assert_eq!(
            now[..stored.len()],
            stored,
            "after kill {kill}: no stored point is lost or written again"
        );
        stored = now;
        in_the_middle += u32::from(!has_ended(database).await);
    }
    assert!(
        in_the_middle > KILLS / 2,
        "{in_the_middle} kills came before the study's end"
    );

    let program = Program::start(database);
    assert_eq!(program.result_hash(&id).await, expected);
    let points = program.json(&format!("/v1/studies/{id}")).await["points_total"].clone();
    program.kill();
    let end = evaluations(database).await;
    assert_eq!(Some(end.len() as u64), points.as_u64());
    assert_eq!(end[..stored.len()], stored);
    let twice: Vec<(i64, i64)> = sqlx::query_as(
        "select payload ->> 'ordinal', count(*) from events where kind = 'point-solved' group by 1 having count(*) > 1",
    )
    .fetch_all(&mut sql(database).await)
    .await
    .expect("rows");
    assert_eq!(twice, [], "no point is reported solved twice");
    assert_eq!(integrity(database).await, "ok");
}

/// A coarse cut point takes some tenths of a second, long enough to be met. A plan that may grow has the finer mesh alone at first.
fn coarse() -> Value {
    let mut document = draft();
    document["method"] = json!({"kind": "auto"});
    document["accuracy"] = json!({"preset": "coarse"});
    document
}

/// Waits until a solve is in flight.
async fn in_flight(database: &Path) {
    let begun = Instant::now();
    let counting = "select count(*) from solves_in_flight";
    loop {
        let mut sql = sql(database).await;
        let count = sqlx::query_scalar(counting).fetch_one(&mut sql).await;
        let count: i64 = count.expect("a count");
        if count > 0 {
            return;
        }
        assert!(begun.elapsed() < PATIENCE, "nothing is solved");
        tokio::time::sleep(Duration::from_millis(2)).await;
    }
}

/// Processes whose parent has this number.
fn children(parent: u32) -> Vec<u32> {
    let folders = std::fs::read_dir("/proc").expect("the kernel tells");
    let numbers = folders.filter_map(|folder| folder.ok()?.file_name().to_str()?.parse().ok());
    let is_child = |number: &u32| {
        let status = std::fs::read_to_string(format!("/proc/{number}/status"));
        status.is_ok_and(|status| status.contains(&format!("\nPPid:\t{parent}\n")))
    };
    numbers.filter(is_child).collect()
}

/// Waits for the one process in which the program solves.
async fn child(program: &Program) -> u32 {
    let begun = Instant::now();
    loop {
        if let [child] = children(program.number())[..] {
            return child;
        }
        assert!(begun.elapsed() < PATIENCE, "it solves in its own process");
        tokio::time::sleep(Duration::from_millis(2)).await;
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_study_killed_five_times_in_its_first_point_is_done_like_any_other() {
    let folder = tempfile::tempdir().expect("temp dir");
    let undisturbed = Program::start(&folder.path().join("undisturbed.db"));
    let id = undisturbed.submit(&coarse()).await;
    let expected = undisturbed.result_hash(&id).await;

    let database = folder.path().join("killed.db");
    let program = Program::start(&database);
    let id = program.submit(&coarse()).await;
    in_flight(&database).await;
    program.kill();
    for _ in 1..5 {
        let program = Program::start(&database);
        let child = child(&program).await;
        program.kill();
        let begun = Instant::now();
        while Path::new(&format!("/proc/{child}")).exists() {
            assert!(begun.elapsed() < PATIENCE, "a process outlives its parent");
            tokio::time::sleep(Duration::from_millis(2)).await;
        }
    }
    assert_eq!(evaluations(&database).await.len(), 0);
    let program = Program::start(&database);
    assert_eq!(program.result_hash(&id).await, expected);
    let crashes: Vec<(i64, i64)> = sqlx::query_as("select count, own from crashes")
        .fetch_all(&mut sql(&database).await)
        .await
        .expect("rows");
    assert_eq!(crashes, [(5, 0)]);
}

async fn has_ended(database: &Path) -> bool {
    let ended = "select count(*) from studies where finished is not null";
    let ended: i64 = sqlx::query_scalar(ended)
        .fetch_one(&mut sql(database).await)
        .await
        .expect("a count");
    ended > 0
}
