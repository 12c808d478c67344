//! The real program on the command line.

mod access;
mod accuracy;
mod db;
mod exports;
mod film_signals;
mod library;
mod logs;
mod outputs;
mod served;
mod settings;
#[cfg(unix)]
mod signals;
mod sweep;
mod terminal;
mod verification;

use std::path::Path;
use std::process::Command;

use crate::program::{strainsite, text};
use serde_json::Value;

pub const REPOSITORY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// The shipped study on the coarsest mesh, with one layout, as a file in the folder.
pub fn draft(folder: &Path) -> &'static str {
    let study = std::fs::read_to_string(format!("{REPOSITORY}/studies/foot-tire.toml"))
        .expect("the study ships");
    let study = study.replace("preset = \"standard\"", "preset = \"draft\"");
    let menu = "[layouts]\ndepths_mm = [0.5, 1, 2]";
    assert!(study.contains(menu));
    let study = study.replace(
        menu,
        "[layouts]\nspacings_deg = [60]\npositions = [\"crown\"]",
    );
    std::fs::write(folder.join("draft.toml"), study).expect("writes");
    "draft.toml"
}

#[test]
fn a_study_runs_and_leaves_its_result_in_every_form_that_was_asked_for() {
    let folder = tempfile::tempdir().expect("temp dir");
    let study = draft(folder.path());
    let first = strainsite(
        folder.path(),
        &["run", study, "--out", "answer", "--json", "-"],
    );
    assert_eq!(first.status.code(), Some(0), "{}", text(&first.stderr));
    let result: Value =
        serde_json::from_slice(&first.stdout).expect("one JSON document and nothing else");
    assert_eq!(
        result["locations"][0]["name"], "P3",
        "the deformation centre ranks first"
    );
    assert!(
        text(&first.stderr).contains("rank  location"),
        "the table goes to standard error"
    );

    let file =
        std::fs::read_to_string(folder.path().join("answer/result.json")).expect("the result");
    assert_eq!(serde_json::from_str::<Value>(&file).expect("JSON"), result);
    let csv =
        std::fs::read_to_string(folder.path().join("answer/locations.csv")).expect("the locations");
    assert_eq!(csv.lines().count(), 6);
    assert!(
        csv.lines()
            .nth(1)
            .is_some_and(|line| line.starts_with("1,P3,")),
        "{csv}"
    );

    // What it was expected to take stands beside what it took.
    assert_eq!(result["estimate"]["solves"]["left"]["expected"], 31);
    assert!(text(&first.stderr).contains("estimated before: 31 solves"));
    let empty_bytes = 320e3;
    let database = std::fs::metadata(folder.path().join("strainsite.db")).expect("a database");
    let expected = result["estimate"]["database_bytes"].as_f64();
    let share = (database.len() as f64 - empty_bytes) / expected.expect("a room");
    assert!((0.75..1.25).contains(&share), "{share} of {expected:?}");

    let dry = strainsite(folder.path(), &["run", study, "--dry-run", "--json", "-"]);
    assert_eq!(dry.status.code(), Some(0), "{}", text(&dry.stderr));
    let estimate: Value = serde_json::from_slice(&dry.stdout).expect("JSON");
    assert_eq!(estimate["solves"]["known"], 31);
    assert_eq!(estimate["solves"]["left"]["most"], 0);

    // The same study again takes every point from the database.
    let again = strainsite(folder.path(), &["run", study]);
    assert_eq!(again.status.code(), Some(0));
    let table = text(&again.stdout);
    assert!(
        table.contains("26 solves, 26 of them known before"),
        "{table}"
    );
}

#[test]
fn a_dry_run_solves_nothing_and_makes_no_database() {
    let folder = tempfile::tempdir().expect("temp dir");
    let study = format!("{REPOSITORY}/studies/foot-tire.toml");
    let dry = strainsite(folder.path(), &["run", &study, "--dry-run"]);
    assert_eq!(dry.status.code(), Some(0), "{}", text(&dry.stderr));
    let told = text(&dry.stdout);
    let told = told.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        told.contains(
            "solves 77: 26 points, 26 on coarser meshes, 3 for what is left out, 22 for layouts; 0 known"
        ),
        "{told}"
    );
    assert!(told.contains("accuracy standard mdrm 5"), "{told}");
    assert!(!folder.path().join("strainsite.db").exists());
}

#[test]
fn calculix_answers_where_it_is_installed_and_says_so_where_it_cannot() {
    let folder = tempfile::tempdir().expect("temp dir");
    let scene = "[geometry]\nouter_radius_mm = 70\nsection_radius_mm = 20\nwall_mm = 8\n[pressure]\ninternal_mpa = 0.04\n\
                 [model]\nlevel = \"draft\"\n";
    std::fs::write(folder.path().join("plain.toml"), scene).expect("writes");
    let calculix = ["solve", "plain.toml", "--solver", "calculix", "--json", "-"];

    let lacking = strainsite(
        folder.path(),
        &[&calculix[..], &["--ccx", "./ccx"]].concat(),
    );
    assert_eq!(lacking.status.code(), Some(1));
    assert!(text(&lacking.stderr).contains("apt-get install calculix-ccx"));

    if let Err(error) = Command::new("ccx").arg("-v").output() {
        println!("skipped: ccx: {error}");
        return;
    }
    let solved = strainsite(folder.path(), &calculix);
    assert_eq!(solved.status.code(), Some(0), "{}", text(&solved.stderr));
    let answer: Value = serde_json::from_slice(&solved.stdout).expect("JSON");
    assert_eq!(answer["status"], "converged");
    assert!(answer["reaction_n"].as_f64() > Some(0.0));
    let changes = answer["model"]["left_out"].to_string();
    assert!(changes.contains("incompressibility"), "{changes}");

    let scene = format!("{scene}[carcass]\n");
    std::fs::write(folder.path().join("plain.toml"), scene).expect("writes");
    let refused = strainsite(folder.path(), &calculix);
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).starts_with("/carcass: "));
}

#[test]
fn one_equilibrium_is_solved_and_changed_by_its_keys() {
    let folder = tempfile::tempdir().expect("temp dir");
    let scene = format!("{REPOSITORY}/scenes/foot-tire.toml");
    let solve = |depth: &str| {
        let depths = format!("ground.depths_mm={depth}");
        let output = strainsite(
            folder.path(),
            &[
                "solve",
                &scene,
                "--set",
                "model.level=draft",
                "--set",
                &depths,
                "--json",
                "-",
            ],
        );
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        let answer: Value =
            serde_json::from_slice(&output.stdout).expect("one JSON document and nothing else");
        assert_eq!(answer["status"], "converged");
        answer["reaction_n"].as_f64().expect("a force")
    };
    let (shallow, deep) = (solve("[0.5,0.5,0.5,0.5,0.5]"), solve("[1,1,1,1,1]"));
    assert!(
        0.0 < shallow && shallow < deep,
        "{shallow} N at 0.5 mm, {deep} N at 1 mm"
    );
}

#[test]
fn an_answer_is_differentiated_by_numbers_of_its_scene() {
    let folder = tempfile::tempdir().expect("temp dir");
    let solve = |further: &[&str]| {
        let scene = ["solve", "foot-tire", "--set", "model.level=draft"];
        strainsite(folder.path(), &[&scene, further].concat())
    };
    let by = "ground.depths_mm[0],pressure.internal_mpa";
    let output = solve(&["--derivatives", by, "--json", "-"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let answer: Value = serde_json::from_slice(&output.stdout).expect("one JSON document");
    let derivatives = answer["derivatives"].as_array().expect("a list");
    let paths: Vec<&Value> = derivatives
        .iter()
        .map(|derivative| &derivative["by"])
        .collect();
    assert_eq!(paths, ["ground.depths_mm[0]", "pressure.internal_mpa"]);
    let [depth, pressure] = [0, 1].map(|i| &derivatives[i]);
    assert_eq!(depth["locations"][0]["name"], "P1");
    // Ground that rises at one end, or a harder tire, is pressed more.
    for derivative in [depth, pressure] {
        assert!(
            derivative["reaction_n"].as_f64() > Some(0.0),
            "{derivative}"
        );
    }
    let end = |location: usize| {
        depth["locations"][location]["strain_y"]
            .as_f64()
            .map(f64::abs)
    };
    assert!(end(0) > end(4).map(|far| 10.0 * far), "{depth}");

    let output = solve(&["--derivatives", by]);
    let said = text(&output.stdout);
    assert!(
        said.contains("per unit of ground.depths_mm[0]: reaction "),
        "{said}"
    );

    let rough = ["--set", "contact.friction=0.3"];
    let refused = solve(
        &[
            &["--derivatives", "ground.stations,pressure.psi"],
            &rough[..],
        ]
        .concat(),
    );
    assert_eq!(refused.status.code(), Some(2));
    let said = text(&refused.stderr);
    let lines: Vec<&str> = said.lines().collect();
    assert!(lines[0].starts_with("/derivatives/0: "), "{said}");
    assert!(
        lines[1].starts_with("/derivatives/1: ") && lines[1].contains("pressure.psi"),
        "{said}"
    );
    assert!(lines[2].starts_with("/contact/friction: "), "{said}");
}

#[test]
fn shipped_documents_are_valid() {
    let folder = tempfile::tempdir().expect("temp dir");
    for kind in ["studies", "scenes"] {
        for file in std::fs::read_dir(format!("{REPOSITORY}/{kind}")).expect("the folder ships") {
            let path = file.expect("an entry").path();
            if path.extension().is_none_or(|kind| kind != "toml") {
                continue;
            }
            let output = strainsite(folder.path(), &["validate", &path.to_string_lossy()]);
            assert_eq!(
                output.status.code(),
                Some(0),
                "{}: {}",
                path.display(),
                text(&output.stderr)
            );
        }
    }
}

#[test]
fn an_unusable_database_is_a_clear_failure() {
    let folder = tempfile::tempdir().expect("temp dir");
    let study = draft(folder.path());
    std::fs::write(
        folder.path().join("letter.db"),
        "dear reader, this is not a database".repeat(100),
    )
    .expect("writes");
    let output = strainsite(
        folder.path(),
        &["run", study, "--db", "letter.db", "--json", "-"],
    );
    assert_eq!(output.status.code(), Some(1));
    assert!(
        text(&output.stderr).contains("letter.db"),
        "{}",
        text(&output.stderr)
    );
    let document: Value =
        serde_json::from_slice(&output.stdout).expect("one JSON document and nothing else");
    assert_eq!(document["status"], "failed");
}

#[test]
fn a_load_that_the_tire_can_not_hold_ends_with_3_and_how_far_it_got() {
    let folder = tempfile::tempdir().expect("temp dir");
    // Without its carcass the reference tire loses its stability below 0.2 MPa.
    let scene = "[pressure]\ninternal_mpa = 0.2\n[model]\nlevel = \"draft\"\n";
    std::fs::write(folder.path().join("bare.toml"), scene).expect("writes");
    let output = strainsite(folder.path(), &["solve", "bare.toml", "--json", "-"]);
    assert_eq!(output.status.code(), Some(3), "{}", text(&output.stderr));
    let answer: Value =
        serde_json::from_slice(&output.stdout).expect("one JSON document and nothing else");
    assert_eq!(answer["status"], "limit-point");
    assert!(answer["detail"].is_string());
    let reached = answer["reached"]["pressure_mpa"]
        .as_f64()
        .expect("a pressure");
    assert!(0.0 < reached && reached < 0.2, "{reached} MPa");
}

#[test]
fn a_tire_pressed_onto_itself_ends_with_3_and_the_depth_it_got_to() {
    let folder = tempfile::tempdir().expect("temp dir");
    let scene = "[carcass]\n[ground]\ndepths_mm = [12.5, 12.5, 12.5, 12.5, 12.5]\n[model]\nlevel = \"draft\"\n";
    std::fs::write(folder.path().join("deep.toml"), scene).expect("writes");
    let output = strainsite(folder.path(), &["solve", "deep.toml", "--json", "-"]);
    assert_eq!(output.status.code(), Some(3), "{}", text(&output.stderr));
    let answer: Value =
        serde_json::from_slice(&output.stdout).expect("one JSON document and nothing else");
    assert_eq!(answer["status"], "self-contact");
    let reached = answer["reached"]["depths_mm"][2].as_f64().expect("a depth");
    assert!(12.0 < reached && reached < 12.5, "{reached} mm");
}
