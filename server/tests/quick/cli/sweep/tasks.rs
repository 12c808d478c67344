//! Designs of a sweep that are solved as tasks, by any machine.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

use super::{contents, draft};
use crate::cli::db::merging::poison;
use crate::numerics::{OTHER, has_the_instructions};
use crate::program::{command, rows, stored_points, strainsite, text, wait_for_points};

/// Walls of three designs, each a task of its own.
const GRID: [&str; 2] = ["--grid", "geometry.wall_mm=2.6,3,3.4"];

fn made(folder: &Path) {
    let make = [
        "tasks",
        "make",
        draft(folder),
        "--dir",
        "tasks",
        "--minutes",
        "0.01",
    ];
    let output = strainsite(folder, &[&make[..], &GRID].concat());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let said = text(&output.stdout);
    assert!(said.contains("3 tasks of 3 designs"), "{said}");
}

fn gathered(output: &Output, code: i32) -> Value {
    assert_eq!(output.status.code(), Some(code), "{}", text(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("one JSON document")
}

#[tokio::test]
async fn what_tasks_hand_in_is_what_a_sweep_solves_and_what_is_poisoned_is_refused() {
    let folder = tempfile::tempdir().expect("temp dir");
    let run = |arguments: &[&str]| strainsite(folder.path(), arguments);
    made(folder.path());
    let [ours, lean] = ["strainsite.db", "lean.db"].map(|name| folder.path().join(name));
    std::fs::copy(&ours, &lean).expect("copies");
    assert_eq!(run(&["tasks", "run", "tasks", "4"]).status.code(), Some(2));
    for number in ["1", "2"] {
        // The program that lies in the folder, as nodes run it.
        let mut node = Command::new(folder.path().join("tasks/strainsite"));
        let node = node
            .current_dir(folder.path())
            .args(["tasks", "run", "tasks", number]);
        let output = node.output().expect("the program runs");
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    }
    // What one task handed in is none of another's.
    let done = |number: u32| folder.path().join(format!("tasks/done/{number}.db"));
    std::fs::copy(done(1), done(3)).expect("copies");
    poison(&done(2)).await;
    let some = gathered(&run(&["tasks", "gather", "tasks", "--json", "-"]), 3);
    assert_eq!(some[0]["taken"]["ended"], 1, "{some}");
    let because = some[1]["refused"].as_str().expect("a reason");
    assert!(
        because.contains("other bits") && because.contains("2.refused.db"),
        "{because}"
    );
    let because = some[2]["refused"].as_str().expect("a reason");
    assert!(because.contains("of another task"), "{because}");
    assert_eq!(some[2]["ended"], 0, "{some}");

    for number in ["2", "3"] {
        let again = run(&["tasks", "run", "tasks", number, "--threads", "1"]);
        assert_eq!(again.status.code(), Some(0), "{}", text(&again.stderr));
    }
    for ended in [1, 0] {
        let all = gathered(&run(&["tasks", "gather", "tasks", "--json", "-"]), 0);
        assert_eq!(all[2]["taken"]["ended"], ended, "{all}");
    }
    assert_eq!(run(&["db", "check"]).status.code(), Some(0));
    let left = run(&["tasks", "make", "--resume", "latest", "--dir", "none"]);
    assert!(
        text(&left.stdout).contains("nothing is left"),
        "{}",
        text(&left.stderr)
    );
    let local = run(&[
        &["sweep", draft(folder.path()), "--db", "local.db"],
        &GRID[..],
    ]
    .concat());
    assert_eq!(local.status.code(), Some(0), "{}", text(&local.stderr));
    let own = contents(&folder.path().join("local.db")).await;
    assert_eq!(contents(&ours).await, own);
    let results = ["--db", "lean.db", "--keep", "results", "--json", "-"];
    let gather = [&["tasks", "gather", "tasks"], &results[..]].concat();
    for ended in [1, 0] {
        let results = gathered(&run(&gather), 0);
        assert_eq!(results[2]["taken"]["ended"], ended, "{results}");
    }
    assert_eq!(contents(&lean).await, own);
    assert_eq!(stored_points(&lean).await, 0);
    let size = |database: &Path| std::fs::metadata(database).expect("is there").len();
    assert!(2 * size(&lean) < size(&ours));
    results_alone_are_handed_in_with_a_point_to_judge_them_by(folder.path(), &own).await;
}

/// Hands in the results of three designs, which are known by now.
async fn results_alone_are_handed_in_with_a_point_to_judge_them_by(
    folder: &Path,
    expected: &[String],
) {
    let run = |arguments: &[&str]| strainsite(folder, arguments);
    let at = |name: &str| folder.join(name);
    let to = ["--dir", "lean", "--keep", "results", "--db", "fresh.db"];
    let made = run(&[&["tasks", "make", draft(folder)], &to[..], &GRID].concat());
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
    std::fs::copy(at("fresh.db"), at("unsolved.db")).expect("copies");
    for _ in 0..2 {
        // Whole already, it is handed in once more.
        let ran = run(&["tasks", "run", "lean", "1"]);
        assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
        let points = "select count(*) from evaluations";
        assert_eq!(rows(&at("lean/done/1.db"), points).await, 1);
    }
    std::fs::copy(at("lean/done/1.db"), at("good.db")).expect("copies");
    let gather = |database: &str, code| {
        let into = ["--keep", "results", "--db", database, "--json", "-"];
        let gathering = run(&[&["tasks", "gather", "lean"], &into[..]].concat());
        gathered(&gathering, code)
    };
    poison(&at("lean/done/1.db")).await;
    let refused = gather("fresh.db", 3)[0]["refused"].to_string();
    assert!(refused.contains("other bits"), "{refused}");
    std::fs::rename(at("good.db"), at("lean/done/1.db")).expect("renames");
    assert_eq!(gather("fresh.db", 0)[0]["taken"]["ended"], 3);
    assert_eq!(contents(&at("fresh.db")).await, expected);
    // Results without such a point aren't believed.
    std::fs::copy(at("fresh.db"), at("lean/done/1.db")).expect("copies");
    let refused = gather("unsolved.db", 3)[0]["refused"].to_string();
    assert!(refused.contains("no first point"), "{refused}");
}

#[tokio::test]
async fn points_of_a_large_study_are_parts_and_poisoned_ones_are_refused() {
    let folder = tempfile::tempdir().expect("temp dir");
    let run = |arguments: &[&str]| strainsite(folder.path(), arguments);
    // Three depths at eight nodes each, 513 points.
    let three = r#"inputs=[{"name":"a","vary":"ground.depths_mm[1]","distribution":{"kind":"uniform","min":0.9,"max":1.1}},{"name":"b","vary":"ground.depths_mm[2]","distribution":{"kind":"uniform","min":0.9,"max":1.1}},{"name":"c","vary":"ground.depths_mm[3]","distribution":{"kind":"uniform","min":0.9,"max":1.1}}]"#;
    let tensor = r#"method={"kind":"tensor","nodes":8}"#;
    let of_study = [
        "--set",
        three,
        "--set",
        tensor,
        "--dir",
        "tasks",
        "--minutes",
        "0.01",
    ];
    let study = draft(folder.path());
    let made = run(&[&["tasks", "make", study, "--json", "-"], &of_study[..]].concat());
    let made = gathered(&made, 0);
    let tasks = made["tasks"].as_array().expect("tasks");
    let count = tasks.len();
    assert!((2..=5).contains(&count), "{made}");
    assert_eq!(tasks[1]["part"]["number"], 2, "{made}");
    for number in ["1", "2"] {
        let ran = run(&["tasks", "run", "tasks", number]);
        assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
    }
    poison(&folder.path().join("tasks/done/2.db")).await;
    let some = gathered(&run(&["tasks", "gather", "tasks", "--json", "-"]), 3);
    let points = some[0]["taken"]["points"]["new"].as_u64();
    assert!(
        points >= Some(512 / 5 - 3) && some[0]["ended"] == 1,
        "{some}"
    );
    assert!(
        some[1]["refused"].is_string() && some[1]["ended"] == 0,
        "{some}"
    );
    // What is known already isn't solved again.
    let more = run(&[
        "tasks", "make", "--resume", "latest", "--dir", "more", "--json", "-",
    ]);
    let more = gathered(&more, 0);
    assert_eq!(more["tasks"].as_array().map(Vec::len), Some(1), "{more}");
}

#[tokio::test]
async fn a_task_that_is_stopped_hands_in_what_it_has_and_goes_on_from_there() {
    let folder = tempfile::tempdir().expect("temp dir");
    let run = |arguments: &[&str]| strainsite(folder.path(), arguments);
    let study = draft(folder.path());
    let make = ["tasks", "make", study, "--dir", "tasks"];
    let output = run(&[&make[..], &GRID].concat());
    assert!(
        text(&output.stdout).contains("1 task of 3 designs"),
        "{}",
        text(&output.stderr)
    );
    let disk = folder.path().join("disk");
    std::fs::create_dir(&disk).expect("makes");
    let mut node = command(
        folder.path(),
        &["tasks", "run", "tasks", "1", "--threads", "1"],
    );
    let mut node = node.env("TMPDIR", &disk).spawn().expect("the program runs");
    // It works on its own disk.
    let own = loop {
        let entry = std::fs::read_dir(&disk).expect("reads").next();
        let own = entry.map(|entry| entry.expect("an entry").path().join("task.db"));
        match own.filter(|own| own.exists()) {
            Some(own) => break own,
            None => tokio::time::sleep(std::time::Duration::from_millis(5)).await,
        }
    };
    wait_for_points(&own, 5).await;
    let process = node.id().to_string();
    let stopped = Command::new("kill").args(["-TERM", &process]).status();
    assert!(stopped.expect("kill runs").success());
    assert_eq!(node.wait().expect("ends").code(), Some(3));
    assert_eq!(std::fs::read_dir(&disk).expect("reads").count(), 0);

    let some = gathered(&run(&["tasks", "gather", "tasks", "--json", "-"]), 3);
    assert!(
        some[0]["taken"]["points"]["new"].as_u64() >= Some(5),
        "{some}"
    );
    let again = run(&["tasks", "run", "tasks", "1"]);
    assert_eq!(again.status.code(), Some(0), "{}", text(&again.stderr));
    let all = gathered(&run(&["tasks", "gather", "tasks", "--json", "-"]), 0);
    assert_eq!(
        all[0]["taken"]["points"]["known"],
        some[0]["taken"]["points"]["new"]
    );
    assert_eq!(run(&["db", "check"]).status.code(), Some(0));
}

#[test]
fn a_node_that_computes_otherwise_hands_in_nothing_and_is_named() {
    let folder = tempfile::tempdir().expect("temp dir");
    let run = |arguments: &[&str]| strainsite(folder.path(), arguments);
    made(folder.path());
    // As a task of another version would have been made.
    let tasks = folder.path().join("tasks/tasks.json");
    let text_of = std::fs::read_to_string(&tasks).expect("reads");
    let other = text_of.replace("strainsite-fem 0.", "strainsite-fem 9.");
    assert_ne!(other, text_of);
    std::fs::write(&tasks, other).expect("writes");
    let node = command(folder.path(), &["tasks", "run", "tasks", "1"])
        .env("SLURMD_NODENAME", "node-of-another-kind")
        .output();
    let node = node.expect("the program runs");
    assert_eq!(node.status.code(), Some(1));
    assert!(
        text(&node.stderr).contains("--constraint"),
        "{}",
        text(&node.stderr)
    );
    let none = gathered(&run(&["tasks", "gather", "tasks", "--json", "-"]), 3);
    let because = none[0]["refused"].as_str().expect("a reason");
    assert!(because.contains("node-of-another-kind"), "{because}");
    std::fs::write(&tasks, text_of).expect("writes");
    if has_the_instructions() {
        let node = command(folder.path(), &["tasks", "run", "tasks", "2"])
            .env("GLIBC_TUNABLES", OTHER)
            .output();
        let node = node.expect("the program runs");
        let said = text(&node.stderr);
        assert_eq!(node.status.code(), Some(1), "{said}");
        assert!(said.contains("--constraint"), "{said}");
    }
    // It comes in once a node of the right kind has done it.
    assert_eq!(run(&["tasks", "run", "tasks", "1"]).status.code(), Some(0));
    let some = gathered(&run(&["tasks", "gather", "tasks", "--json", "-"]), 3);
    assert!(
        some[0].get("refused").is_none() && some[0]["ended"] == 1,
        "{some}"
    );
}
