//! Databases that take others in.

use std::path::Path;

use serde_json::Value;
use sha2::{Digest, Sha256};
use sqlx::AssertSqlSafe;

use super::{done, refused};
use crate::cli::draft;
use crate::program::service::{self, Program, sql};
use crate::program::{strainsite, text};

fn json(text: &str) -> Value {
    serde_json::from_str(text).expect("one JSON document")
}

/// Hash of what the only result of a database says.
async fn content(database: &Path) -> String {
    let found = sqlx::query_scalar("select content_sha256 from results");
    let found = found.fetch_one(&mut sql(database).await).await;
    found.expect("one result")
}

#[tokio::test]
async fn what_another_database_has_is_taken_whole_or_in_part_and_once() {
    let folder = tempfile::tempdir().expect("temp dir");
    let run = |arguments: &[&str]| strainsite(folder.path(), arguments);
    let study = draft(folder.path());
    done(&run(&["run", study, "--db", "other.db"]));
    let theirs = content(&folder.path().join("other.db")).await;

    // A database that isn't there yet.
    let merged = run(&["db", "merge", "other.db", "--db", "all.db", "--json", "-"]);
    let merged = json(done(&merged));
    assert_eq!(merged[0]["taken"]["points"]["new"], 31);
    assert_eq!(merged[0]["taken"]["studies"]["new"], 1);
    assert_eq!(content(&folder.path().join("all.db")).await, theirs);
    let again = run(&["db", "merge", "other.db", "--db", "all.db"]);
    let said = done(&again);
    assert!(
        said.contains("nothing new; known before: 1 study, 31 points"),
        "{said}"
    );

    done(&run(&[
        "db",
        "merge",
        "other.db",
        "--db",
        "points.db",
        "--keep",
        "points",
    ]));
    let found = run(&["run", study, "--db", "points.db"]);
    let said = done(&found);
    assert!(said.contains("26 of them known before"), "{said}");
    assert_eq!(content(&folder.path().join("points.db")).await, theirs);

    done(&run(&[
        "db",
        "merge",
        "other.db",
        "--db",
        "results.db",
        "--keep",
        "results",
    ]));
    assert_eq!(content(&folder.path().join("results.db")).await, theirs);
    let listed = run(&["list", "--db", "results.db"]);
    assert!(
        done(&listed).contains("0 of 31"),
        "{}",
        text(&listed.stdout)
    );
    for database in ["all.db", "points.db", "results.db"] {
        done(&run(&["db", "check", "--db", database]));
    }
}

#[tokio::test]
async fn a_study_that_waits_ends_by_what_was_solved_elsewhere() {
    let folder = tempfile::tempdir().expect("temp dir");
    let run = |arguments: &[&str]| strainsite(folder.path(), arguments);
    let [head, task] = ["head.db", "task.db"].map(|name| folder.path().join(name));
    let at_the_head = Program::start(&head);
    let id = at_the_head.submit(&service::draft()).await;
    at_the_head.kill();
    done(&run(&["db", "backup", "task.db", "--db", "head.db"]));
    let elsewhere = Program::start(&task);
    elsewhere.wait(&id, |study| study["state"] == "done").await;
    let theirs = elsewhere.result_hash(&id).await;
    elsewhere.kill();

    let merged = run(&["db", "merge", "task.db", "--db", "head.db", "--json", "-"]);
    assert_eq!(json(done(&merged))[0]["taken"]["ended"], 1);
    done(&run(&["db", "check", "--db", "head.db"]));
    let at_the_head = Program::start(&head);
    assert_eq!(at_the_head.result_hash(&id).await, theirs);
    let study = at_the_head.json(&format!("/v1/studies/{id}")).await;
    assert_eq!(study["state"], "done");
    assert_eq!(study["points"]["done"], study["points"]["total"]);
    at_the_head.kill();
}

/// Alters the responses of a database's points, hashes and all.
pub(crate) async fn poison(database: &Path) {
    let mut connection = sql(database).await;
    let query = "select key, scene, replace(response, 'reaction_n\":1', 'reaction_n\":2') as response, cost from evaluations";
    let rows: Vec<(String, String, String, String)> = sqlx::query_as(query)
        .fetch_all(&mut connection)
        .await
        .expect("reads");
    for (key, scene, response, cost) in &rows {
        let mut digest = Sha256::new();
        for column in [key, scene, response, cost] {
            digest.update((column.len() as u64).to_le_bytes());
            digest.update(column);
        }
        let hash: String = digest
            .finalize()
            .iter()
            .map(|byte| format!("{byte:02x}"))
            .collect();
        let change = sqlx::query("update evaluations set response = ?, sha256 = ? where key = ?");
        let changed = change.bind(response).bind(hash).bind(key);
        changed.execute(&mut connection).await.expect("changes");
    }
}

#[tokio::test]
async fn what_is_cut_altered_poisoned_or_strange_is_refused_by_name() {
    let folder = tempfile::tempdir().expect("temp dir");
    let run = |arguments: &[&str]| strainsite(folder.path(), arguments);
    let at = |name: &str| folder.path().join(name);
    done(&run(&["run", draft(folder.path()), "--db", "head.db"]));
    for name in [
        "cut.db",
        "altered.db",
        "poisoned.db",
        "strange.db",
        "whole.db",
    ] {
        done(&run(&["db", "backup", name, "--db", "head.db"]));
    }
    let whole = std::fs::read(at("cut.db")).expect("reads");
    std::fs::write(at("cut.db"), &whole[..whole.len() / 2]).expect("writes");
    super::damage(&at("altered.db")).await;
    poison(&at("poisoned.db")).await;
    done(&run(&["db", "check", "--db", "poisoned.db"]));
    let view = "create view endless as with recursive n as (select 1 as k union all select k + 1 from n) select k from n";
    let made = sqlx::query(AssertSqlSafe(view))
        .execute(&mut sql(&at("strange.db")).await)
        .await;
    made.expect("makes");
    let files = [
        "cut.db",
        "altered.db",
        "poisoned.db",
        "strange.db",
        "head.db",
        "none.db",
        "whole.db",
    ];
    let merged = run(&[&["db", "merge", "--db", "head.db"], &files[..]].concat());
    refused(&merged, "6 of 7 files weren't merged");
    let said = text(&merged.stdout);
    let lines: Vec<&str> = said.lines().collect();
    for (line, (name, because)) in lines.iter().zip([
        ("cut.db", "malformed"),
        ("altered.db", "damaged: its content does not match its hash"),
        ("poisoned.db", "of the largest value of its kind"),
        ("strange.db", "\"endless\""),
        ("head.db", "itself"),
        ("none.db", "no such file"),
        ("whole.db", "nothing new"),
    ]) {
        assert!(line.contains(name) && line.contains(because), "{said}");
    }
    assert_eq!(lines.len(), files.len(), "{said}");
    done(&run(&["db", "check", "--db", "head.db"]));
    let left = std::fs::read_dir(folder.path()).expect("reads");
    let names = left.map(|entry| {
        entry
            .expect("an entry")
            .file_name()
            .into_string()
            .expect("text")
    });
    assert!(names.into_iter().all(|name| !name.contains("merging")));
}
