//! Sweeps over HTTP whose designs an engine has solved elsewhere.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use reqwest::StatusCode;
use serde_json::{Value, json};

use super::contents;
use crate::program::service::{Program, draft, serving, sql};
use crate::program::{strainsite, text};

/// Time far beyond what three draft designs take.
const PATIENCE: Duration = Duration::from_secs(120);
/// Token of the service, which no job may see.
const SECRET: &str = "a-secret-that-no-engine-sees-0123456789";

/// Service with an engine that is this command, and three tasks for three designs.
fn service(folder: &Path, command: &str) -> Command {
    let mut service = serving(&folder.join("own.db"));
    service
        .current_dir(folder)
        .args(["--minutes", "0.001", "--engine", "command"])
        .args(["--engine-command", command]);
    service
}

/// Base of the sweep, in a file of the folder.
fn base(folder: &Path) -> Value {
    let base = draft();
    fs::write(folder.join("base.json"), base.to_string()).expect("writes");
    base
}

const WALLS: [f64; 3] = [2.6, 3.1, 3.4];

async fn submitted(program: &Program, base: &Value) -> String {
    let sweep = json!({"study": base, "grid": {"geometry.wall_mm": WALLS}});
    let (status, body) = post(program, "/v1/sweeps?engine=command", &sweep).await;
    assert_eq!(status, StatusCode::ACCEPTED, "{body}");
    body["id"].as_str().expect("an id").to_owned()
}

async fn post(program: &Program, path: &str, body: &Value) -> (StatusCode, Value) {
    let address = format!("{}{path}", program.url);
    let request = program.client.post(address).json(body);
    let answer = request.send().await.expect("an answer");
    (answer.status(), answer.json().await.expect("JSON"))
}

/// The only sweep of the only engine, once this holds of it and of its designs.
async fn until(program: &Program, id: &str, holds: impl Fn(&Value, &Value) -> bool) -> Value {
    let begun = Instant::now();
    loop {
        let engines = program.json("/v1/engines").await;
        let away = engines["engines"][0]["sweeps"][0].clone();
        let sweep = program.json(&format!("/v1/sweeps/{id}")).await;
        if holds(&away, &sweep["counts"]) {
            return away;
        }
        assert!(begun.elapsed() < PATIENCE, "{away} {}", sweep["counts"]);
        tokio::time::sleep(Duration::from_millis(50)).await;
    }
}

#[tokio::test]
async fn other_machines_solve_a_sweep_and_the_service_what_they_leave() {
    let folder = tempfile::tempdir().expect("temp dir");
    let at = folder.path();
    // Of three tasks it does the first, and one of another is refused.
    let first = r#"env > seen; echo "$TASKS" >> rounds
        [ "$TASKS" = "1 2 3" ] || exit 1
        "$PROGRAM" tasks run "$FOLDER" 1; cp "$FOLDER/done/1.db" "$FOLDER/done/2.db""#;
    let mut command = service(at, first);
    let program = Program::run(&mut command);
    let base = base(at);
    let sweep = json!({"study": base, "grid": {"geometry.wall_mm": WALLS}});
    let (status, refused) = post(&program, "/v1/sweeps?engine=slurm", &sweep).await;
    assert_eq!(status, StatusCode::UNPROCESSABLE_ENTITY, "{refused}");
    let detail = refused["detail"].as_str().expect("a sentence");
    assert!(detail.contains("this service has command"), "{detail}");

    let id = submitted(&program, &base).await;
    let over = until(&program, &id, |away, counts| {
        !away["ended"].is_null() && counts["done"] == 3
    });
    let over = over.await;
    assert_eq!(
        (&over["designs"], &over["designs_ended"]),
        (&json!(2), &json!(0)),
        "{over}"
    );
    let said = over["said"].to_string();
    assert!(
        said.contains("of another task") && said.contains("ended with exit status: 1"),
        "{said}"
    );
    let rounds = fs::read_to_string(at.join("rounds")).expect("rounds");
    assert_eq!(rounds, "1 2 3\n1 2\n1 2\n");
    let seen = fs::read_to_string(at.join("seen")).expect("an environment");
    assert!(!seen.contains("STRAINSITE_TOKEN"), "{seen}");
    let metrics = program.get("/metrics").await.text().await.expect("text");
    assert!(metrics.contains("strainsite_engine_tasks{engine=\"command\",state=\"running\"} 0"));
    drop(program);

    let local = [
        "sweep",
        "base.json",
        "--grid",
        "geometry.wall_mm=2.6,3.1,3.4",
        "--db",
        "local.db",
    ];
    let local = strainsite(at, &local);
    assert_eq!(local.status.code(), Some(0), "{}", text(&local.stderr));
    assert_eq!(
        contents(&at.join("own.db")).await,
        contents(&at.join("local.db")).await
    );
}

#[tokio::test]
async fn an_engine_outlives_its_service_and_ends_when_its_sweep_is_cancelled() {
    let folder = tempfile::tempdir().expect("temp dir");
    let at = folder.path();
    // It does the first task when it may, and waits for ever before the second.
    let slow = r#"echo "$TASKS" >> rounds; env > seen
        until [ -e go ]; do sleep 0.05; done
        "$PROGRAM" tasks run "$FOLDER" 1; touch done; exec sleep 600"#;
    let mut command = service(at, slow);
    command.env("STRAINSITE_TOKEN", SECRET);
    let token = |program: &mut Program| {
        let mut headers = reqwest::header::HeaderMap::new();
        let value = format!("Bearer {SECRET}").parse().expect("a header");
        headers.insert("authorization", value);
        let client = reqwest::Client::builder().default_headers(headers).build();
        program.client = client.expect("a client");
    };
    let mut program = Program::run(&mut command);
    token(&mut program);
    let id = submitted(&program, &base(at)).await;
    until(&program, &id, |away, _| away["tasks"]["running"] == 3).await;
    program.kill();

    let mut program = Program::run(&mut command);
    token(&mut program);
    until(&program, &id, |away, _| away["tasks"]["running"] == 3).await;
    fs::write(at.join("go"), "").expect("writes");
    let begun = Instant::now();
    while !at.join("done").exists() {
        assert!(begun.elapsed() < PATIENCE, "the first task isn't done");
        tokio::time::sleep(Duration::from_millis(20)).await;
    }
    let address = format!("{}/v1/sweeps/{id}", program.url);
    until(&program, &id, |away, _| away["tasks"]["ended"] == 1).await;
    let cancelled = program
        .client
        .delete(address)
        .send()
        .await
        .expect("an answer");
    assert_eq!(cancelled.status(), StatusCode::ACCEPTED);
    until(&program, &id, |away, _| !away["ended"].is_null()).await;
    assert_eq!(
        fs::read_to_string(at.join("rounds")).expect("rounds"),
        "1 2 3\n"
    );
    let seen = fs::read_to_string(at.join("seen")).expect("an environment");
    assert!(!seen.contains(SECRET), "{seen}");
    assert!(!at.join("own.db.tasks").exists(), "tasks are left");

    // What the first task had solved is there, and what was cancelled stays so until it is asked for.
    let counts = program.json(&format!("/v1/sweeps/{id}")).await["counts"].clone();
    assert_eq!(counts["cancelled"], 3, "{counts}");
    let (status, body) = post(&program, &format!("/v1/sweeps/{id}/resume"), &json!({})).await;
    assert_eq!(status, StatusCode::ACCEPTED, "{body}");
    until(&program, &id, |_, counts| counts["done"] == 3).await;
    let reused = "select count(*) from events where kind = 'started' and json_extract(payload, '$.reused') = json_extract(payload, '$.points')";
    let reused: i64 = sqlx::query_scalar(reused)
        .fetch_one(&mut sql(&at.join("own.db")).await)
        .await
        .expect("a count");
    assert_eq!(reused, 1);
}

#[tokio::test]
async fn a_folder_that_is_away_is_waited_for() {
    let folder = tempfile::tempdir().expect("temp dir");
    let at = folder.path();
    let every = r#"for task in $TASKS; do "$PROGRAM" tasks run "$FOLDER" $task; done"#;
    fs::write(at.join("shared"), "no folder").expect("writes");
    let program = Program::run(service(at, every).args(["--tasks", "shared/tasks"]));
    let id = submitted(&program, &base(at)).await;
    let waits = until(&program, &id, |away, _| away["said"] != json!([])).await;
    let said = waits["said"].to_string();
    assert!(
        said.contains("shared/tasks") && said.contains("can't be written"),
        "{said}"
    );
    fs::remove_file(at.join("shared")).expect("removes");
    let over = until(&program, &id, |away, counts| {
        !away["ended"].is_null() && counts["done"] == 3
    });
    assert_eq!(over.await["designs_ended"], 3);
}

#[tokio::test]
async fn what_an_engine_says_against_a_sweep_is_what_the_client_reads() {
    let folder = tempfile::tempdir().expect("temp dir");
    let mut command = serving(&folder.path().join("own.db"));
    let empty = folder.path().join("bin");
    fs::create_dir(&empty).expect("makes");
    // No program of Slurm's is on the path.
    let program = Program::run(command.args(["--engine", "slurm"]).env("PATH", &empty));
    let sweep = json!({"study": draft(), "grid": {"geometry.wall_mm": WALLS}});
    let (status, refused) = post(&program, "/v1/sweeps?engine=slurm", &sweep).await;
    assert_eq!(status, StatusCode::SERVICE_UNAVAILABLE, "{refused}");
    let detail = refused["detail"].as_str().expect("a sentence");
    assert_eq!(
        detail,
        "the engine slurm: there is no sbatch on this machine's PATH"
    );
    assert_eq!(program.json("/v1/sweeps").await["sweeps"], json!([]));
}
