//! Sweeps and comparisons on the command line.

use std::path::Path;

use serde_json::Value;

use crate::cli::draft;
use crate::program::service::sql;
use crate::program::{strainsite, text};

mod elsewhere;
mod served_engines;
mod tasks;

fn json(bytes: &[u8]) -> Value {
    serde_json::from_slice(bytes).expect("one JSON document")
}

/// Hashes of what the results of a database say, by design.
async fn contents(database: &Path) -> Vec<String> {
    let query = "select content_sha256 from results join studies on id = study order by name";
    let found = sqlx::query_scalar(query)
        .fetch_all(&mut sql(database).await)
        .await;
    found.expect("results")
}

#[test]
fn a_sweep_runs_its_designs_gives_the_table_and_is_extended_without_repeating_anything() {
    let folder = tempfile::tempdir().expect("temp dir");
    let run = |arguments: &[&str]| strainsite(folder.path(), arguments);
    let study = draft(folder.path());
    let grid = ["--grid", "geometry.wall_mm=2.5,3"];
    let dry = run(&[&["sweep", study, "--dry-run"], &grid[..]].concat());
    assert_eq!(dry.status.code(), Some(0), "{}", text(&dry.stderr));
    assert!(
        text(&dry.stdout).contains("2 designs: 62 solves"),
        "{}",
        text(&dry.stdout)
    );
    let elsewhere = ["sweep", study, "--dry-run", "--engine", "slurm"];
    let elsewhere = run(&[&elsewhere[..], &grid].concat());
    let said = text(&elsewhere.stdout);
    assert!(said.contains("other machines: 1, the longest"), "{said}");
    assert!(!folder.path().join("strainsite.db").exists());

    let ran = run(&[
        &["sweep", study, "--name", "walls", "--json", "-"],
        &grid[..],
    ]
    .concat());
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
    assert!(text(&ran.stderr).contains("wall_mm = 2.5"));
    let ran = json(&ran.stdout);
    let id = ran["sweep"]["id"].as_str().expect("an id");
    assert_eq!(ran["sweep"]["counts"]["done"], 2);

    let again = run(&[
        "sweep",
        "--resume",
        id,
        "--grid",
        "geometry.wall_mm=3,3.5",
        "--json",
        "-",
    ]);
    assert_eq!(again.status.code(), Some(0), "{}", text(&again.stderr));
    let again = json(&again.stdout);
    for design in [0, 1] {
        assert_eq!(
            again["sweep"]["designs"][design],
            ran["sweep"]["designs"][design]
        );
    }
    assert_eq!(again["sweep"]["designs"].as_array().map(Vec::len), Some(3));

    let listed = run(&["list", "--sweeps"]);
    assert_eq!(text(&listed.stdout).lines().count(), 1);
    assert!(
        text(&listed.stdout).starts_with(id),
        "{}",
        text(&listed.stdout)
    );
    let listed = json(&run(&["list", "--sweeps", "--json", "-"]).stdout);
    assert_eq!(listed["sweeps"][0]["counts"]["done"], 3);

    let compared = run(&["compare", id, "--json", "-"]);
    assert_eq!(json(&compared.stdout), again["comparison"]);
    let of = |design: usize| {
        again["sweep"]["designs"][design]["study"]["id"]
            .as_str()
            .expect("an id")
    };
    let pair = run(&["compare", of(1), of(2), "--baseline", of(2)]);
    assert_eq!(pair.status.code(), Some(0), "{}", text(&pair.stderr));
    assert!(
        text(&pair.stdout).contains("wall_mm = 3.5"),
        "{}",
        text(&pair.stdout)
    );
    assert_eq!(run(&["compare", "none"]).status.code(), Some(2));
}

#[test]
fn a_design_without_an_equilibrium_costs_itself_alone_and_the_exit_code_says_so() {
    let folder = tempfile::tempdir().expect("temp dir");
    let run = |arguments: &[&str]| strainsite(folder.path(), arguments);
    let study = draft(folder.path());
    // With next to no textile the tire has its limit point below 0.2 MPa.
    let ran = run(&[
        "sweep",
        study,
        "--grid",
        "carcass.stiffness_n_per_mm=1,100",
        "--json",
        "sweep.json",
    ]);
    assert_eq!(ran.status.code(), Some(3), "{}", text(&ran.stderr));
    assert!(
        text(&ran.stderr).contains("1 of 2 designs have no result"),
        "{}",
        text(&ran.stderr)
    );
    let table = text(&ran.stdout);
    assert!(table.contains("stiffness_n_per_mm = 1: failed"), "{table}");
    let file = std::fs::read(folder.path().join("sweep.json")).expect("the document");
    let document = json(&file);
    assert_eq!(document["sweep"]["counts"]["failed"], 1);
    let solved = document["sweep"]["designs"][1]["study"]["id"].as_str();
    assert_eq!(document["comparison"]["baseline"].as_str(), solved);
}

#[test]
fn fields_are_set_for_a_run_and_for_all_designs() {
    let folder = tempfile::tempdir().expect("temp dir");
    let run = |arguments: &[&str]| strainsite(folder.path(), arguments);
    let study = draft(folder.path());
    let nodes = ["--set", "method.nodes=3", "--json", "-"];
    let thin = [&["run", study, "--set", "geometry.wall_mm=2.5"], &nodes[..]].concat();
    let alone = run(&thin);
    assert_eq!(alone.status.code(), Some(0), "{}", text(&alone.stderr));
    let alone = json(&alone.stdout);
    assert_eq!(
        alone["cost"]["solves"], 16,
        "two points off each of five means, and five checks"
    );

    let grid = ["sweep", study, "--grid", "geometry.wall_mm=2.5,3"];
    let ran = run(&[&grid[..], &nodes[..]].concat());
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
    let compared = json(&ran.stdout)["comparison"]["studies"].clone();
    assert_eq!(compared[0]["reaction_n"], alone["cut_point"]["reaction_n"]);
    assert_eq!(compared[0]["cost"]["reused"], 16, "the run had them");
    assert_eq!(compared[1]["cost"]["solves"], 16);
}
