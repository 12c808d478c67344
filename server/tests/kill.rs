//! SIGKILL against the real program: what was stored survives, nothing is solved twice, the result is the same.

#![cfg(unix)]

use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use fem_client::document::{Format, parse};
use reqwest::Client;
use serde_json::{Value, json};
use sqlx::sqlite::SqliteConnectOptions;
use sqlx::{Connection, SqliteConnection};

/// Kills after the first; each comes a different while after a start.
const KILLS: u32 = 20;
/// Far beyond what a draft study takes.
const PATIENCE: Duration = Duration::from_secs(300);

/// The running program; killed when dropped.
struct Program {
    child: Child,
    url: String,
    client: Client,
}

impl Program {
    fn start(database: &Path) -> Self {
        let mut child = Command::new(env!("CARGO_BIN_EXE_strainsite"))
            .args(["serve", "--addr", "127.0.0.1:0", "--threads", "2", "--db"])
            .arg(database)
            .env("STRAINSITE_LOG", "error")
            .stdout(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let mut line = String::new();
        let stdout = child.stdout.take().expect("a pipe");
        BufReader::new(stdout).read_line(&mut line).expect("a line");
        let url = line
            .trim()
            .strip_prefix("listening on ")
            .expect("the address")
            .to_owned();
        Self {
            child,
            url,
            client: Client::new(),
        }
    }

    /// SIGKILL, the signal that a process can't prepare for.
    fn kill(mut self) {
        self.child.kill().expect("kills");
        self.child.wait().expect("ends");
    }

    async fn submit(&self, document: &Value) -> String {
        let request = self
            .client
            .post(format!("{}/v1/studies", self.url))
            .json(document);
        let body: Value = request
            .send()
            .await
            .expect("an answer")
            .json()
            .await
            .expect("JSON");
        body["id"].as_str().expect("an id").to_owned()
    }

    async fn wait(&self, id: &str, until: impl Fn(&Value) -> bool) -> Value {
        let begun = Instant::now();
        loop {
            let address = format!("{}/v1/studies/{id}", self.url);
            let answer = self.client.get(address).send().await.expect("an answer");
            let study: Value = answer.json().await.expect("JSON");
            if until(&study) {
                return study;
            }
            assert!(
                study["state"] != "failed" && begun.elapsed() < PATIENCE,
                "{study}"
            );
            tokio::time::sleep(Duration::from_millis(5)).await;
        }
    }

    async fn result_hash(&self, id: &str) -> String {
        let done = self.wait(id, |study| study["state"] == "done").await;
        done["result_sha256"].as_str().expect("a hash").to_owned()
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The shipped study on the coarsest mesh, without its map.
fn draft() -> Value {
    let (_, text) = placement::study::presets()[0];
    let mut document = parse(text, Format::Toml).expect("shipped studies are well-formed");
    document["candidates"] = json!({"points": "P1-P5"});
    document["accuracy"] = json!({"preset": "draft"});
    document
}

async fn sql(database: &PathBuf) -> SqliteConnection {
    let options = SqliteConnectOptions::new().filename(database);
    SqliteConnection::connect_with(&options)
        .await
        .expect("the database opens")
}

/// Row number, key and time of every evaluation, in the order in which they were stored.
async fn evaluations(database: &PathBuf) -> Vec<(i64, String, String)> {
    sqlx::query_as("select rowid, key, created from evaluations order by rowid")
        .fetch_all(&mut sql(database).await)
        .await
        .expect("rows")
}

/// Takes the blame from the points that were in flight, as `db release` does: it was this test that killed the program. On a slow
/// machine the same point might be there three times.
async fn release(database: &PathBuf) {
    for table in ["delete from crashes", "delete from solves_in_flight"] {
        let released = sqlx::query(table).execute(&mut sql(database).await).await;
        released.expect("deletes");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_study_killed_again_and_again_loses_nothing_and_gives_the_same_result() {
    let folder = tempfile::tempdir().expect("temp dir");
    let undisturbed = Program::start(&folder.path().join("undisturbed.db"));
    let expected = undisturbed
        .result_hash(&undisturbed.submit(&draft()).await)
        .await;
    undisturbed.kill();

    let database = folder.path().join("killed.db");
    let program = Program::start(&database);
    let id = program.submit(&draft()).await;
    program
        .wait(&id, |study| study["points_done"].as_i64() >= Some(3))
        .await;
    program.kill();
    let mut stored = evaluations(&database).await;
    assert!(
        stored.len() >= 3 && stored.len() < 26,
        "killed in the middle: {} points",
        stored.len()
    );

    for kill in 0..KILLS {
        let program = Program::start(&database);
        // From 0 to 475 ms in an order without a pattern: 7 has no factor in common with 20.
        tokio::time::sleep(Duration::from_millis(u64::from(kill * 7 % 20 * 25))).await;
        program.kill();
        release(&database).await;
        let now = evaluations(&database).await;
        assert_eq!(
            now[..stored.len()],
            stored,
            "after kill {kill}: no stored point is lost or written again"
        );
        stored = now;
    }

    let program = Program::start(&database);
    assert_eq!(program.result_hash(&id).await, expected);
    program.kill();
    let end = evaluations(&database).await;
    assert_eq!(end.len(), 26);
    assert_eq!(end[..stored.len()], stored);
    let twice: Vec<(i64, i64)> = sqlx::query_as(
        "select payload ->> 'ordinal', count(*) from events where kind = 'point-solved' group by 1 having count(*) > 1",
    )
    .fetch_all(&mut sql(&database).await)
    .await
    .expect("rows");
    assert_eq!(twice, [], "no point is reported solved twice");
    let verdict: String = sqlx::query_scalar("pragma integrity_check")
        .fetch_one(&mut sql(&database).await)
        .await
        .expect("a verdict");
    assert_eq!(verdict, "ok");
}
