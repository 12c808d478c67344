//! Runs the real program on the command line.

// Each test file uses a part of this.
#![allow(dead_code)]

pub mod service;

use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use sqlx::sqlite::{SqliteConnectOptions, SqliteConnection};

/// Time far beyond what a few points of a draft study take.
const PATIENCE: Duration = Duration::from_secs(60);

/// The program with these arguments.
pub fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_strainsite"));
    command
        .args(arguments)
        .current_dir(folder)
        .env_remove("STRAINSITE_DB")
        .env_remove("STRAINSITE_TOKEN");
    command
}

/// Runs it to its end.
pub fn strainsite(folder: &Path, arguments: &[&str]) -> Output {
    command(folder, arguments)
        .output()
        .expect("the program runs")
}

/// Starts it.
pub fn spawn(folder: &Path, arguments: &[&str]) -> Child {
    command(folder, arguments)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts")
}

pub fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

/// Counts the points of studies that have their outcome in a database; none while there is no database.
pub async fn stored_points(database: &Path) -> i64 {
    rows(database, "select count(*) from study_points").await
}

/// Counts the trades of a database.
pub async fn stored_trades(database: &Path) -> i64 {
    rows(database, "select count(*) from trades").await
}

/// Counts the runs of models of a database.
#[tokio::main(flavor = "current_thread")]
pub async fn stored_runs(database: &Path) -> i64 {
    rows(database, "select count(*) from model_runs").await
}

pub async fn rows(database: &Path, counting: &'static str) -> i64 {
    use sqlx::Connection;
    let options = SqliteConnectOptions::new()
        .filename(database)
        .read_only(true);
    let Ok(mut sql) = SqliteConnection::connect_with(&options).await else {
        return 0;
    };
    sqlx::query_scalar(counting)
        .fetch_one(&mut sql)
        .await
        .unwrap_or(0)
}

/// Waits until so many points are stored.
pub async fn wait_for_points(database: &Path, points: i64) {
    let begun = Instant::now();
    while stored_points(database).await < points {
        assert!(begun.elapsed() < PATIENCE, "no {points} points were stored");
        tokio::time::sleep(Duration::from_millis(2)).await;
    }
}
