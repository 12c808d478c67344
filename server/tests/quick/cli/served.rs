//! The real service, started and asked.

use std::fs::{self, File};
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Stdio};
use std::time::{Duration, Instant};

use reqwest::{Client, StatusCode};
use serde_json::Value;

use crate::program::command;

/// Time far beyond what a draft study takes.
const PATIENCE: Duration = Duration::from_secs(120);

/// The running program, its address and what it prints; killed when dropped.
pub struct Served {
    pub url: String,
    child: Child,
    printed: BufReader<ChildStdout>,
    log: PathBuf,
}

impl Served {
    /// Starts it on a free port of this address, its log going to a file.
    pub fn start(folder: &Path, arguments: &[&str], environment: &[(&str, &str)]) -> Self {
        let log = folder.join("log");
        let mut command = command(folder, &[&["serve"], arguments].concat());
        command.envs(environment.iter().copied());
        command.stdout(Stdio::piped());
        command.stderr(File::create(&log).expect("a file"));
        let mut child = command.spawn().expect("the program starts");
        let stdout = child.stdout.take().expect("a pipe");
        let mut served = Self {
            url: String::new(),
            child,
            printed: BufReader::new(stdout),
            log,
        };
        served.url = served.line("listening on ");
        served
    }

    /// The next line that it prints, which begins like this.
    pub fn line(&mut self, begin: &str) -> String {
        let mut line = String::new();
        self.printed.read_line(&mut line).expect("a line");
        let rest = line.trim().strip_prefix(begin);
        rest.unwrap_or_else(|| panic!("{line:?}")).to_owned()
    }

    /// Returns what the list of studies answers to who says this token.
    pub async fn status(&self, token: &str) -> StatusCode {
        let request = Client::new().get(format!("{}/v1/studies", self.url));
        let answer = request.bearer_auth(token).send().await;
        answer.expect("an answer").status()
    }

    /// Submits a document and waits until its study has ended; its identifier.
    pub async fn run(&self, document: &Value) -> String {
        let (client, studies) = (Client::new(), format!("{}/v1/studies", self.url));
        let sent = client.post(&studies).json(document).send().await;
        let study: Value = sent.expect("an answer").json().await.expect("JSON");
        let id = study["id"].as_str().expect("an id").to_owned();
        let begun = Instant::now();
        loop {
            let asked = client.get(format!("{studies}/{id}")).send().await;
            let study: Value = asked.expect("an answer").json().await.expect("JSON");
            if !study["finished"].is_null() {
                return id;
            }
            assert!(begun.elapsed() < PATIENCE, "{study}");
            tokio::time::sleep(Duration::from_millis(10)).await;
        }
    }

    /// Ends it; all that it logged.
    pub fn log(self) -> String {
        let path = self.log.clone();
        drop(self);
        fs::read_to_string(path).expect("a log")
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
