//! The database file, looked after.

use std::path::Path;
use std::process::Output;

use serde_json::Value;
use sqlx::sqlite::SqliteConnectOptions;
use sqlx::{Connection, SqliteConnection};

use crate::cli::draft;
use crate::program::{spawn, strainsite, text};

pub(crate) mod merging;

fn done(output: &Output) -> &str {
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    text(&output.stdout)
}

fn refused(output: &Output, because: &str) {
    assert_eq!(output.status.code(), Some(1));
    let said = text(&output.stderr);
    assert!(said.contains(because), "{said}");
}

async fn damage(database: &Path) {
    let options = SqliteConnectOptions::new().filename(database);
    let connected = SqliteConnection::connect_with(&options).await;
    let changed = sqlx::query(
        "update evaluations set response = replace(response, 'reaction_n\":1', 'reaction_n\":2')",
    )
    .execute(&mut connected.expect("opens"))
    .await;
    assert!(changed.expect("changes").rows_affected() > 0);
}

#[tokio::test]
async fn a_database_is_checked_copied_and_compacted() {
    let folder = tempfile::tempdir().expect("temp dir");
    let run = |arguments: &[&str]| strainsite(folder.path(), arguments);
    refused(&run(&["db", "check"]), "strainsite.db can't be opened");
    let study = draft(folder.path());
    done(&run(&["run", study]));

    let found = run(&["db", "check", "--json", "-"]);
    let found: Value = serde_json::from_str(done(&found)).expect("one JSON document");
    assert_eq!(found["rows"]["evaluations"], 31);
    assert_eq!(found["rows"]["results"], 1);
    assert_eq!(found["faults"], Value::Array(vec![]));

    done(&run(&["db", "backup", "copy.db"]));
    refused(&run(&["db", "backup", "copy.db"]), "isn't there yet");
    done(&run(&["db", "check", "--db", "copy.db"]));
    let again = run(&["run", study, "--db", "copy.db"]);
    assert!(done(&again).contains("26 of them known before"));
    assert!(done(&run(&["db", "vacuum"])).contains("bytes"));
    done(&run(&["db", "check"]));

    damage(&folder.path().join("copy.db")).await;
    let damaged = run(&["db", "check", "--db", "copy.db"]);
    refused(&damaged, "faults");
    let said = text(&damaged.stdout);
    assert!(said.contains("of table evaluations is damaged"), "{said}");
}

#[test]
fn a_database_in_use_is_checked_and_copied_but_not_compacted() {
    let folder = tempfile::tempdir().expect("temp dir");
    let run = |arguments: &[&str]| strainsite(folder.path(), arguments);
    let mut service = spawn(folder.path(), &["serve", "--addr", "127.0.0.1:0"]);
    let mut line = String::new();
    let stdout = service.stdout.take().expect("a pipe");
    std::io::BufRead::read_line(&mut std::io::BufReader::new(stdout), &mut line).expect("a line");
    done(&run(&["db", "check"]));
    done(&run(&["db", "backup", "copy.db"]));
    refused(&run(&["db", "vacuum"]), "another strainsite process");
    service.kill().expect("ends");
    service.wait().expect("ended");
}

#[tokio::test]
async fn a_copy_takes_the_place_of_a_database_whose_log_a_kill_left() {
    let folder = tempfile::tempdir().expect("temp dir");
    let run = |arguments: &[&str]| strainsite(folder.path(), arguments);
    let study = draft(folder.path());
    done(&run(&["run", study]));
    // Names that mean something else to SQLite are those of files.
    for name in [":memory:", "file:copy.db?mode=memory", "copy.db"] {
        done(&run(&["db", "backup", name]));
        done(&run(&["db", "check", "--db", name]));
        assert!(folder.path().join(name).is_file(), "{name}");
    }
    let mut service = spawn(folder.path(), &["serve", "--addr", "127.0.0.1:0"]);
    let mut line = String::new();
    let stdout = service.stdout.take().expect("a pipe");
    std::io::BufRead::read_line(&mut std::io::BufReader::new(stdout), &mut line).expect("a line");
    refused(
        &run(&["db", "restore", "copy.db"]),
        "another strainsite process",
    );
    service.kill().expect("ends");
    service.wait().expect("ended");

    std::fs::copy(
        folder.path().join("copy.db"),
        folder.path().join("strainsite.db"),
    )
    .expect("copies");
    let log = folder.path().join("strainsite.db-wal");
    std::fs::write(&log, "of the database before").expect("writes");
    refused(&run(&["run", study]), "strainsite.db-wal");
    let restored = run(&["db", "restore", "copy.db"]);
    assert!(
        done(&restored).contains("is kept as"),
        "{}",
        text(&restored.stdout)
    );
    assert!(!log.exists());
    assert!(done(&run(&["run", study])).contains("26 of them known before"));

    refused(&run(&["db", "restore", "strainsite.db"]), "itself");
    damage(&folder.path().join("copy.db")).await;
    let damaged = run(&["db", "restore", "copy.db", "--discard"]);
    refused(&damaged, "copy.db can't be opened: it isn't whole");
    done(&run(&["db", "check"]));
    assert!(!folder.path().join("strainsite.db.unfinished").exists());
}
