//! A virtual rig on the command line: its table, what it tells of layouts, its recordings.

use std::path::Path;

use serde_json::Value;

use crate::program::{strainsite, text};

/// A draft that takes some seconds: ground without friction isn't dragged.
const STUDY: &str = "name = \"rig\"\nscene = { preset = \"foot-tire\" }\n\
    [[inputs]]\nname = \"P3\"\nvary = \"ground.depths_mm[2]\"\ndistribution = { kind = \"uniform\", min = 0.7, max = 1.3 }\n\
    [layouts]\nunits = [12]\nspacings_deg = []\npositions = [\"crown\"]\ndirections = [[\"y\"]]\n\
    [rig]\nruns = 2\nfilms_follow_force = false\n[rig.gait]\nrun_s = 12\nload_n = [0, 20]\n\
    [method]\nkind = \"mdrm\"\nnodes = 3\ncheck_points = 0\n[accuracy]\npreset = \"draft\"\n";

fn read(folder: &Path, name: &str) -> String {
    std::fs::read_to_string(folder.join(name)).expect("is there")
}

#[test]
fn a_rig_tells_forces_of_layouts_and_its_recordings_are_learnt_from() {
    let folder = tempfile::tempdir().expect("temp dir");
    let folder = folder.path();
    let study = STUDY.replace("[rig]\n", "[rig]\nother_tires = [{ wall_factor = 1.05 }]\n");
    std::fs::write(folder.join("rig.toml"), study).expect("writes");
    let dry = strainsite(folder, &["run", "rig.toml", "--dry-run"]);
    assert!(
        text(&dry.stdout).contains("5 for layouts, 92 for the"),
        "{}",
        text(&dry.stdout)
    );
    let ran = strainsite(folder, &["run", "rig.toml", "--json", "result.json"]);
    let said = text(&ran.stdout);
    assert_eq!(ran.status.code(), Some(0), "{said}{}", text(&ran.stderr));
    assert!(said.contains("12 of y, crown, 30 deg"), "{said}");
    assert!(
        said.contains("fx, fy: no layout's films tell more"),
        "{said}"
    );

    let result: Value = serde_json::from_str(&read(folder, "result.json")).expect("JSON");
    let table = &result["forces"]["table"];
    assert_eq!(
        (&table["solves"], &table["largest_load_n"]),
        (&56.into(), &20.0.into())
    );
    // Contact of the draft mesh comes on node by node: 4 % of full scale where ground is dragged, less where it isn't.
    let worst = table["error"]["signal_worst"].as_f64().expect("an error");
    assert!(worst > 0.0 && worst < 0.04, "{worst}");
    let forces = result["layouts"][0]["force_error"]
        .as_array()
        .expect("forces");
    let vertical = &forces[2];
    assert_eq!(
        (&vertical["axis"], &vertical["useful"]),
        (&"fz".into(), &true.into())
    );
    let share = |of: &Value| of["nrmse_percent"].as_f64().expect("a share");
    let of_runs = vertical["splits"]
        .as_array()
        .and_then(|splits| splits.last())
        .expect("runs");
    assert_eq!(of_runs["by"], "run");
    // Useful is what is 5 % better than the mean on left-out runs: on fresh ones it is better than the mean, too.
    let of_mean = of_runs["mean_nrmse_percent"].as_f64().expect("a share");
    assert!(
        share(&vertical["fresh"]) < of_mean && share(of_runs) < 0.95 * of_mean,
        "{vertical}"
    );
    let other = &vertical["elsewhere"][0];
    assert_eq!(other["tire"], "wall 5 % thicker");
    assert!(share(&other["error"]) < of_mean, "{vertical}");
    assert_eq!(result["forces"]["price"][0]["films"], 12);
    let id = result["study"]["id"].as_str().expect("an identifier");
    let exported = strainsite(folder, &["export", id, "--table", "forces"]);
    let csv = text(&exported.stdout);
    let lines: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(lines.len(), 1 + forces.len(), "{csv}");
    let column = |name: &str| lines[0].iter().position(|head| *head == name).expect(name);
    let rmse_n = lines[3][column("fresh_rmse_n")].parse::<f64>().ok();
    assert_eq!(rmse_n, vertical["fresh"]["rmse_n"].as_f64());
    assert_eq!(lines[3][column("force")], "fz");

    let record = ["force", "record", "rig.toml", "--layout", "1", "-o"];
    for to in ["first", "second"] {
        let recorded = strainsite(folder, &[&record[..], &[to]].concat());
        assert_eq!(
            recorded.status.code(),
            Some(0),
            "{}",
            text(&recorded.stderr)
        );
        assert!(text(&recorded.stdout).contains("strainsite force fit"));
    }
    for name in ["run-1.csv", "run-2.csv", "recipe.toml"] {
        let [first, second] = ["first", "second"].map(|to| read(&folder.join(to), name));
        assert!(first == second, "{name}");
    }
    let run = read(&folder.join("first"), "run-1.csv");
    assert!(run.starts_with("time_s,film_1,"), "{}", &run[..80]);
    // 2400 readings of the films, and one less or as many of the force sensor, whose clock begins later.
    assert!((4799..=4801).contains(&(run.lines().count() - 1)));
    let recipe = read(&folder.join("first"), "recipe.toml");
    let quick = format!("{recipe}\n[features]\nsets = [\"raw\"]\n[models]\nkinds = [\"ridge\"]\n");
    std::fs::write(folder.join("quick.toml"), quick).expect("writes");
    let fit = [
        "force",
        "fit",
        "quick.toml",
        "first/run-1.csv",
        "first/run-2.csv",
        "--json",
        "-",
    ];
    let fitted = strainsite(folder, &fit);
    assert_eq!(fitted.status.code(), Some(0), "{}", text(&fitted.stderr));
    let report: Value = serde_json::from_slice(&fitted.stdout).expect("JSON");
    assert_eq!(report["recordings"][0]["rate_hz"], 200.0);
    assert_eq!(report["forces"][2]["force"], "fz_n");
}

#[test]
fn glued_films_are_solved_with_the_tire_around_the_wheel() {
    let folder = tempfile::tempdir().expect("temp dir");
    let folder = folder.path();
    let glued = STUDY.replace("[layouts]\n", "[layouts]\nfilm = \"transfer\"\n");
    std::fs::write(folder.join("glued.toml"), glued).expect("writes");
    let ran = strainsite(folder, &["run", "glued.toml", "--json", "result.json"]);
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
    let result: Value = serde_json::from_str(&read(folder, "result.json")).expect("JSON");
    // Four loads of the tire without friction, and of the one kind of film at twelve angles, with five tests, beside the table's own.
    let table = &result["forces"]["table"];
    assert_eq!(table["solves"], 56 + 4 + 12 * 4 + 5);
    let films = &table["films"];
    assert_eq!(
        (&films["level"], &films["tested"]),
        (&"draft".into(), &5.into())
    );
    let error = |name: &str| films[name].as_f64().expect("an error");
    assert!(error("signal_worst") < error("transfer_worst"), "{films}");
    assert_eq!(result["layouts"][0]["force_error"][2]["useful"], true);
}

#[test]
fn what_cannot_be_recorded_is_told_and_nothing_is_written() {
    let folder = tempfile::tempdir().expect("temp dir");
    let folder = folder.path();
    let without = STUDY.split("[rig]").next().expect("tables").to_owned();
    std::fs::write(folder.join("without.toml"), without).expect("writes");
    std::fs::write(
        folder.join("faulty.toml"),
        STUDY
            .replace("runs = 2", "runs = 0\nrnus = 2")
            .replace("load_n = [0, 20]", "load_n = [20, 0]"),
    )
    .expect("writes");
    let record = |study: &str| {
        let done = strainsite(
            folder,
            &["force", "record", study, "--layout", "1", "-o", "out"],
        );
        assert_eq!(done.status.code(), Some(2));
        text(&done.stderr).to_owned()
    };
    assert!(record("without.toml").contains("the study has no rig: add a table [rig]"));
    let faults = record("faulty.toml");
    for part in ["runs", "rnus", "load_n"] {
        assert!(faults.contains(part), "{part}: {faults}");
    }
    assert!(!folder.join("out").exists() && !folder.join("strainsite.db").exists());
}
