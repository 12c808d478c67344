//! A start that is killed at any moment leaves a database that the next start takes.

use std::path::Path;
use std::time::{Duration, Instant};

use crate::program::service::{Program, integrity, serving, sql};

const STARTS: u32 = 60;

/// Whether a database has its tables.
async fn has_tables(database: &Path) -> bool {
    if !database.exists() {
        return false;
    }
    let count: Result<i64, _> = sqlx::query_scalar("select count(*) from studies")
        .fetch_one(&mut sql(database).await)
        .await;
    count.is_ok()
}

#[tokio::test(flavor = "multi_thread")]
async fn a_start_killed_at_any_moment_leaves_a_database_that_starts() {
    let folder = tempfile::tempdir().expect("temp dir");
    let begun = Instant::now();
    Program::start(&folder.path().join("first.db")).kill();
    let whole = begun.elapsed();

    let mut unfinished = 0;
    for start in 0..STARTS {
        let database = folder.path().join(format!("{start}.db"));
        let mut killed = serving(&database).spawn().expect("starts");
        let share = f64::from(start) / f64::from(STARTS);
        tokio::time::sleep(whole.mul_f64(share)).await;
        killed.kill().expect("kills");
        killed.wait().expect("ends");
        unfinished += u32::from(!has_tables(&database).await);

        let program = Program::start(&database);
        assert_eq!(program.json("/readyz").await["status"], "ready");
        program.kill();
        assert!(has_tables(&database).await, "start {start}");
        assert_eq!(integrity(&database).await, "ok", "start {start}");
    }
    eprintln!("a start takes {whole:?}; {unfinished} of {STARTS} were killed before its tables");
    assert!(
        unfinished > STARTS / 20,
        "only {unfinished} kills came before the tables"
    );
    // Starts that hang would be killed by nobody: the bound is far above 60 times two starts.
    assert!(begun.elapsed() < Duration::from_secs(300));
}
