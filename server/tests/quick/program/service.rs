//! The real program as a service, and what a test asks of it.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use document::{Format, parse};
use reqwest::{Client, Response, StatusCode};
use serde_json::{Value, json};
use sqlx::sqlite::SqliteConnectOptions;
use sqlx::{Connection, SqliteConnection};

/// Time far beyond what a draft study takes.
const PATIENCE: Duration = Duration::from_secs(300);

/// The running program; killed when dropped.
pub struct Program {
    child: Child,
    pub url: String,
    pub client: Client,
}

/// The service on a database, at a port of its own choice, on two threads.
pub fn serving(database: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_strainsite"));
    command
        .args(["serve", "--addr", "127.0.0.1:0", "--threads", "2", "--db"])
        .arg(database)
        .env("STRAINSITE_LOG", "error")
        .stdout(Stdio::piped());
    command
}

impl Program {
    pub fn start(database: &Path) -> Self {
        Self::run(&mut serving(database))
    }

    /// Runs the command and waits until it listens.
    pub fn run(command: &mut Command) -> Self {
        let mut child = command.spawn().expect("the program starts");
        let mut line = String::new();
        let stdout = child.stdout.take().expect("a pipe");
        BufReader::new(stdout).read_line(&mut line).expect("a line");
        let url = line
            .trim()
            .strip_prefix("listening on ")
            .unwrap_or_else(|| panic!("it says {line:?} instead of its address"))
            .to_owned();
        Self {
            child,
            url,
            client: Client::new(),
        }
    }

    /// SIGKILL, the signal that a process can't prepare for.
    pub fn kill(mut self) {
        self.child.kill().expect("kills");
        self.child.wait().expect("ends");
    }

    /// The process's number.
    pub fn number(&self) -> u32 {
        self.child.id()
    }

    /// Returns where it listens, IP:PORT.
    pub fn address(&self) -> &str {
        self.url.strip_prefix("http://").expect("an address")
    }

    pub async fn get(&self, path: &str) -> Response {
        let request = self.client.get(format!("{}{path}", self.url));
        request.send().await.expect("an answer")
    }

    /// The JSON document at an address that must answer 200.
    pub async fn json(&self, path: &str) -> Value {
        let response = self.get(path).await;
        assert_eq!(response.status(), StatusCode::OK, "{path}");
        response.json().await.expect("JSON")
    }

    pub async fn post(&self, document: &Value) -> Response {
        let address = format!("{}/v1/studies", self.url);
        let request = self.client.post(address).json(document);
        request.send().await.expect("an answer")
    }

    pub async fn submit(&self, document: &Value) -> String {
        let body: Value = self.post(document).await.json().await.expect("JSON");
        body["id"].as_str().expect("an id").to_owned()
    }

    pub async fn wait(&self, id: &str, until: impl Fn(&Value) -> bool) -> Value {
        let begun = Instant::now();
        loop {
            let study = self.json(&format!("/v1/studies/{id}")).await;
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

    pub async fn result_hash(&self, id: &str) -> String {
        let done = self.wait(id, |study| study["state"] == "done").await;
        done["result_sha256"].as_str().expect("a hash").to_owned()
    }

    /// Memory that it holds now, bytes.
    pub fn resident_bytes(&self) -> u64 {
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.child.id()));
        let status = status.expect("the kernel tells");
        let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
        let kilobytes = line.and_then(|text| text.trim().strip_suffix(" kB")?.parse::<u64>().ok());
        1024 * kilobytes.expect("a number")
    }

    /// Files and connections that it has open.
    pub fn open_files(&self) -> usize {
        let folder = format!("/proc/{}/fd", self.child.id());
        std::fs::read_dir(folder).expect("the kernel tells").count()
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The shipped study on the coarsest mesh, without its map and layouts.
pub fn draft() -> Value {
    let (_, text) = documents::study::presets()[0];
    let mut document = parse(text, Format::Toml).expect("shipped studies are well-formed");
    document["candidates"] = json!({"points": "P1-P5"});
    document["layouts"] = json!({"spacings_deg": []});
    document["accuracy"] = json!({"preset": "draft"});
    document
}

/// A connection of the test's own to a database.
pub async fn sql(database: &Path) -> SqliteConnection {
    let options = SqliteConnectOptions::new().filename(database);
    SqliteConnection::connect_with(&options)
        .await
        .expect("the database opens")
}

/// Returns what SQLite says of a database: `ok` when it is whole.
pub async fn integrity(database: &Path) -> String {
    sqlx::query_scalar("pragma integrity_check")
        .fetch_one(&mut sql(database).await)
        .await
        .expect("a verdict")
}
