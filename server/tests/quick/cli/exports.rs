//! Files for other programs, written without a service.

use serde_json::Value;

use super::{REPOSITORY, draft};
use crate::program::{strainsite, text};

#[test]
fn binary_files_go_to_a_file_or_a_pipe() {
    let folder = tempfile::tempdir().expect("temp dir");
    let run = |arguments: &[&str]| strainsite(folder.path(), arguments);
    let ran = run(&["run", draft(folder.path()), "--json", "-"]);
    let ran: Value = serde_json::from_str(text(&ran.stdout)).expect("one JSON document");
    let id = ran["study"]["id"].as_str().expect("an id");
    for format in ["parquet", "vtu"] {
        let piped = run(&["export", id, "--format", format]);
        assert_eq!(piped.status.code(), Some(0), "{}", text(&piped.stderr));
        assert!(
            piped
                .stdout
                .starts_with(if format == "vtu" { b"<?xm" } else { b"PAR1" })
        );
        let written = run(&["export", id, "--format", format, "-o", "file"]);
        assert_eq!((written.status.code(), written.stdout.len()), (Some(0), 0));
        assert_eq!(
            std::fs::read(folder.path().join("file")).expect("reads"),
            piped.stdout
        );
    }
}

#[test]
fn a_study_without_a_map_says_what_gives_one() {
    let folder = tempfile::tempdir().expect("temp dir");
    let study = draft(folder.path());
    let path = folder.path().join(study);
    let document = std::fs::read_to_string(&path).expect("reads");
    let lines = document.lines().filter(|line| !line.starts_with("grid"));
    std::fs::write(&path, lines.collect::<Vec<_>>().join("\n")).expect("writes");
    let run = |arguments: &[&str]| strainsite(folder.path(), arguments);
    let ran = run(&["run", study, "--json", "-"]);
    let ran: Value = serde_json::from_str(text(&ran.stdout)).expect("one JSON document");
    let id = ran["study"]["id"].as_str().expect("an id");
    let refused = run(&["export", id, "--format", "vtu", "-o", "map.vtu"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("candidates.grid"));
    assert!(!folder.path().join("map.vtu").exists());
}

#[test]
fn a_solve_writes_its_mesh() {
    let folder = tempfile::tempdir().expect("temp dir");
    let scene = format!("{REPOSITORY}/scenes/foot-tire.toml");
    let solve = [
        "solve",
        &scene,
        "--set",
        "model.level=draft",
        "--vtu",
        "tire.vtu",
        "--json",
        "-",
    ];
    let solved = strainsite(folder.path(), &solve);
    let answer: Value = serde_json::from_str(text(&solved.stdout)).expect("one JSON document");
    let file = std::fs::read_to_string(folder.path().join("tire.vtu")).expect("reads");
    let cells = format!("NumberOfCells=\"{}\"", answer["model"]["elements"]);
    assert!(file.contains(&cells) && file.contains("Name=\"von_mises_mpa\""));
}
