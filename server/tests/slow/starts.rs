//! A start or a migration that is killed at any moment leaves a database that the next start takes.

use std::path::Path;
use std::time::{Duration, Instant};

use sqlx::sqlite::SqliteConnectOptions;
use sqlx::{Connection, SqliteConnection};

use crate::migrations;
use crate::program::service::{Program, integrity, serving, sql};

const STARTS: u32 = 60;

/// A database as a version with the first `count` migrations left it, with one study.
async fn earlier(database: &Path, count: usize) {
    let options = SqliteConnectOptions::new()
        .filename(database)
        .create_if_missing(true);
    let mut old = SqliteConnection::connect_with(&options)
        .await
        .expect("opens");
    let migrated = migrations::first(count).await.run(&mut old).await;
    migrated.expect("migrates");
    let study = "insert into studies (id, name, spec, spec_sha256, state, created) values ('a', 'old', '{}', '44136fa355b3678a1146ad16f7e8649e94fb4fc21fe77e8310c060f61caaff8a', 'done', 't')";
    sqlx::query(study).execute(&mut old).await.expect("stores");
    old.close().await.expect("closes");
}

/// Migrations that a database has; none when it can't be asked.
async fn migrated(database: &Path) -> i64 {
    if !database.exists() {
        return 0;
    }
    let count = sqlx::query_scalar("select count(*) from _sqlx_migrations where success");
    count.fetch_one(&mut sql(database).await).await.unwrap_or(0)
}

#[tokio::test(flavor = "multi_thread")]
async fn a_start_killed_at_any_moment_leaves_a_database_that_starts() {
    let folder = tempfile::tempdir().expect("temp dir");
    let begun = Instant::now();
    Program::start(&folder.path().join("first.db")).kill();
    let whole = begun.elapsed();

    let all = migrations::all().await.iter().count();
    let mut unfinished = 0;
    for start in 0..STARTS {
        let database = folder.path().join(format!("{start}.db"));
        // Fresh ones, and every earlier schema in turn.
        let known = start as usize % all;
        if known > 0 {
            earlier(&database, known).await;
        }
        let mut killed = serving(&database).spawn().expect("starts");
        // 7 has no factor in common with 60, so that fresh and old ones are killed at every share of a start.
        let share = f64::from(start * 7 % STARTS) / f64::from(STARTS);
        tokio::time::sleep(whole.mul_f64(share)).await;
        killed.kill().expect("kills");
        killed.wait().expect("ends");
        unfinished += u32::from(migrated(&database).await < all as i64);

        let program = Program::start(&database);
        assert_eq!(program.json("/readyz").await["status"], "ready");
        if known > 0 {
            assert_eq!(program.json("/v1/studies/a").await["name"], "old");
        }
        program.kill();
        assert_eq!(migrated(&database).await, all as i64, "start {start}");
        assert_eq!(integrity(&database).await, "ok", "start {start}");
    }
    eprintln!(
        "a start takes {whole:?}; {unfinished} of {STARTS} were killed before all migrations"
    );
    assert!(
        unfinished > STARTS / 20,
        "only {unfinished} kills came before the last migration"
    );
    // Starts that hang would be killed by nobody: the bound is far above 60 times two starts.
    assert!(begun.elapsed() < Duration::from_secs(300));
}
