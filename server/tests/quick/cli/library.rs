//! The database, read without a service.

use serde_json::Value;

use super::draft;
use crate::program::{strainsite, text};

#[test]
fn studies_are_listed_shown_and_exported() {
    let folder = tempfile::tempdir().expect("temp dir");
    let run = |arguments: &[&str]| strainsite(folder.path(), arguments);
    let code = |arguments: &[&str]| run(arguments).status.code();
    assert_eq!(code(&["list"]), Some(1), "there is no database yet");
    let study = draft(folder.path());
    let ran = run(&["run", study, "--json", "-"]);
    let ran: Value = serde_json::from_str(text(&ran.stdout)).expect("one JSON document");
    let id = ran["study"]["id"].as_str().expect("an id");

    let listed = run(&["list", "--state", "done", "--json", "-"]);
    let listed: Value = serde_json::from_str(text(&listed.stdout)).expect("one JSON document");
    assert_eq!(listed["studies"].as_array().map(Vec::len), Some(1));
    assert_eq!(listed["studies"][0]["id"], id);
    assert!(text(&run(&["list"]).stdout).starts_with(id));
    assert_eq!(text(&run(&["list", "--state", "queued"]).stdout), "");
    assert!(text(&run(&["list", "--search", id]).stdout).starts_with(id));
    for none in [&["list", "--search", "_"][..], &["list", "--archived"]] {
        assert_eq!(text(&run(none).stdout), "", "{none:?}");
    }

    let shown = run(&["show", &id[..8]]);
    assert!(text(&shown.stdout).contains("P3") && text(&shown.stdout).contains("whole study"));
    let shown = run(&["show", id, "--json", "-"]);
    let shown: Value = serde_json::from_str(text(&shown.stdout)).expect("one JSON document");
    assert_eq!(shown["result"], ran);
    assert_eq!(shown["document"]["name"], ran["study"]["name"]);

    let exported = run(&["export", id, "--format", "json"]);
    let exported: Value = serde_json::from_str(text(&exported.stdout)).expect("one JSON document");
    assert_eq!(exported, ran);
    let points = run(&["export", id, "--table", "points", "-o", "points.csv"]);
    assert_eq!(points.status.code(), Some(0));
    let written = std::fs::read_to_string(folder.path().join("points.csv")).expect("reads");
    assert_eq!(written.lines().count(), 1 + 31);

    for wrong in [["show", "none"], ["export", "none"]] {
        let refused = run(&wrong);
        assert_eq!(refused.status.code(), Some(2));
        assert!(text(&refused.stderr).contains("there is no study"));
    }
    let twice = run(&["run", study, "--json", "-"]);
    let twice: Value = serde_json::from_str(text(&twice.stdout)).expect("one JSON document");
    let other = twice["study"]["id"].as_str().expect("an id");
    assert_ne!(other, id);
    assert_eq!(code(&["show", &id[..4]]), Some(2), "both begin so");
}
