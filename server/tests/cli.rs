//! The real program on the command line.

mod program;

use std::path::Path;
use std::process::Command;

use program::{strainsite, text};
use serde_json::Value;

const REPOSITORY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// The shipped study on the coarsest mesh, as a file in the folder.
fn draft(folder: &Path) -> &'static str {
    let study = std::fs::read_to_string(format!("{REPOSITORY}/studies/foot-tire.toml"))
        .expect("the study ships");
    let study = study.replace("preset = \"standard\"", "preset = \"draft\"");
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

    // The same study again takes every point from the database.
    let again = strainsite(folder.path(), &["run", study]);
    assert_eq!(again.status.code(), Some(0));
    let table = text(&again.stdout);
    assert!(
        table.contains("29.97") && table.contains("26 solves, 26 of them known before"),
        "{table}"
    );
}

#[test]
fn the_trade_is_measured_against_its_reference() {
    let folder = tempfile::tempdir().expect("temp dir");
    let study = draft(folder.path());
    let arguments = [
        "trade",
        study,
        "--up-to",
        "draft",
        "--reference-level",
        "coarse",
    ];
    let more = [
        "--reference-method",
        "mdrm",
        "--out",
        "answer",
        "--json",
        "-",
    ];
    let output = strainsite(folder.path(), &[&arguments[..], &more[..]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let trade: Value = serde_json::from_slice(&output.stdout).expect("one JSON document");
    let rungs = trade["rungs"].as_array().expect("a list");
    assert_eq!(rungs.len(), 5);
    for rung in rungs {
        assert_eq!(rung["fidelity"]["level"], "draft");
        let (error, wall) = (rung["error_true"].as_f64(), rung["wall_s"].as_f64());
        // Between the two levels the indices of this study move by hundredths.
        assert!(error.is_some_and(|e| e > 0.0 && e < 0.2), "{rung}");
        assert!(wall.is_some_and(|s| s > 0.0), "{rung}");
    }
    assert!(rungs.iter().any(|rung| rung["pareto"] == true));
    assert_eq!(trade["reference"]["error_true"], 0.0);
    assert_eq!(trade["reference"]["solves"], 52);
    let read = |name: &str| {
        std::fs::read_to_string(folder.path().join("answer").join(name)).expect("written")
    };
    assert_eq!(read("trade.csv").lines().count(), 7);
    let plot = read("trade.svg");
    assert!(plot.starts_with("<svg") && plot.contains("draft mdrm 5") && !plot.contains("NaN"));
}

#[test]
fn a_tolerance_is_met_by_the_cheapest_rung_that_claims_it() {
    let folder = tempfile::tempdir().expect("temp dir");
    let study = draft(folder.path());
    let path = folder.path().join(study);
    let document = std::fs::read_to_string(&path).expect("the study");
    let asking = document.replace("preset = \"draft\"", "tolerance = 0.3");
    assert_ne!(asking, document);
    std::fs::write(&path, asking).expect("written");
    let output = strainsite(folder.path(), &["run", study, "--json", "-"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let result: Value = serde_json::from_slice(&output.stdout).expect("one JSON document");
    let climb = &result["climb"];
    assert_eq!(climb["met"], true);
    assert_eq!(climb["rungs"][0]["fidelity"]["level"], "coarse");
    for output in result["outputs"].as_array().expect("a list") {
        let error = &output["error"];
        assert!(
            error["total"].as_f64().is_some_and(|total| total <= 0.3),
            "{error}"
        );
        assert!(error["mesh"].as_f64().is_some(), "{error}");
    }
    assert!(text(&output.stderr).contains("A tolerance of 0.3 is met"));
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
fn wrong_input_ends_with_2_and_every_fault_on_a_line_of_its_own() {
    let folder = tempfile::tempdir().expect("temp dir");
    std::fs::write(
        folder.path().join("scene.toml"),
        "[pressure]\ninternal_mpa = -1\n[carcass]\nposition = 2\n",
    )
    .expect("writes");
    for command in ["validate", "solve"] {
        let output = strainsite(folder.path(), &[command, "scene.toml"]);
        assert_eq!(output.status.code(), Some(2), "{command}");
        let lines: Vec<&str> = text(&output.stderr).lines().collect();
        assert_eq!(lines.len(), 2, "{lines:?}");
        assert!(
            lines
                .iter()
                .any(|line| line.starts_with("/pressure/internal_mpa: ")),
            "{lines:?}"
        );
        assert!(
            lines
                .iter()
                .any(|line| line.starts_with("/carcass/position: ")),
            "{lines:?}"
        );
        assert!(output.stdout.is_empty());
    }
    for arguments in [
        vec!["validate", "absent.toml"],
        vec!["run", "absent.toml"],
        vec!["run", "scene.toml"],
        vec!["solve", "scene.toml", "--set", "pressure"],
        vec!["serve", "--addr", "0.0.0.0:8080"],
        vec!["fly"],
    ] {
        let output = strainsite(folder.path(), &arguments);
        assert_eq!(
            output.status.code(),
            Some(2),
            "{arguments:?}: {}",
            text(&output.stderr)
        );
        assert!(!output.stderr.is_empty());
    }
    assert!(
        !folder.path().join("strainsite.db").exists(),
        "a refused study makes no database"
    );
}

#[test]
fn shipped_documents_are_valid() {
    let folder = tempfile::tempdir().expect("temp dir");
    for kind in ["studies", "scenes"] {
        for file in std::fs::read_dir(format!("{REPOSITORY}/{kind}")).expect("the folder ships") {
            let path = file.expect("an entry").path();
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

#[test]
fn verification_compares_with_known_answers_and_shows_its_convergence() {
    let folder = tempfile::tempdir().expect("temp dir");
    let families = [
        "--only",
        "homogeneous",
        "--only",
        "cylinder",
        "--only",
        "cook",
    ];
    let arguments: Vec<&str> = ["verify", "--json", "-"]
        .into_iter()
        .chain(families)
        .collect();
    let output = strainsite(folder.path(), &arguments);
    let table = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{table}");
    let document: Value =
        serde_json::from_slice(&output.stdout).expect("one JSON document and nothing else");
    let cases = document["cases"].as_array().expect("cases");
    let named = |name: &str| {
        let case = cases
            .iter()
            .find(|case| case["name"].as_str() == Some(name));
        case.unwrap_or_else(|| panic!("no case {name:?} in {table}"))
    };
    let cylinder = named("cylinder 9.5/12.5, stretch 2, 9-node: pressure, MPa");
    assert_eq!(cylinder["expected"], 0.08944068511004151);
    for case in cases {
        assert_eq!(case["verdict"], "pass", "{case}");
        let (error, tolerance) = (case["error"].as_f64(), case["tolerance"].as_f64());
        assert!(
            error.expect("an error") <= tolerance.expect("a tolerance"),
            "{case}"
        );
        assert!(
            case["source"]
                .as_str()
                .is_some_and(|source| !source.is_empty())
        );
    }
    // Twice the degree, halfway to the next lower order at least.
    assert!(cylinder["slope"]["observed"].as_f64().expect("a slope") > 3.5);
    assert!(
        table.contains("| case ") && table.contains(" pass "),
        "{table}"
    );

    let unknown = strainsite(folder.path(), &["verify", "--only", "everything"]);
    assert_eq!(unknown.status.code(), Some(2));
}

/// What may be asked at the ends, and the page that shows it.
#[test]
fn extremes_end_right_or_with_a_reason_and_the_page_shows_them_all() {
    let folder = tempfile::tempdir().expect("temp dir");
    let output = strainsite(folder.path(), &["verify", "--extremes", "--json", "-"]);
    let table = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{table}");
    let document: Value =
        serde_json::from_slice(&output.stdout).expect("one JSON document and nothing else");
    let cases = document["cases"].as_array().expect("cases");
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/extremes.md"))
        .expect("the page");
    let rows = page.lines().filter(|line| line.starts_with("| "));
    let shown: Vec<&str> = rows
        .filter_map(|row| row.split(" | ").next()?.strip_prefix("| "))
        .map(str::trim)
        .collect();
    for case in cases {
        assert_eq!(case["verdict"], "pass", "{case}");
        assert!(
            case["computed"].is_number() && case["error"].is_number(),
            "{case}"
        );
        let name = case["name"].as_str().expect("a name");
        assert!(shown.contains(&name), "docs/extremes.md lacks {name:?}");
    }
    // Beside the cases the table has its head and the line below it.
    assert_eq!(
        shown.len(),
        cases.len() + 2,
        "docs/extremes.md shows cases that aren't there any more"
    );
    let unknown = strainsite(folder.path(), &["verify", "--extremes", "--only", "cook"]);
    assert_eq!(unknown.status.code(), Some(2));
}

#[cfg(unix)]
mod signals {
    use super::*;
    use std::io::{BufRead, BufReader};
    use std::process::Child;

    use program::{spawn, stored_points, wait_for_points};

    fn send(signal: &str, child: &Child) {
        let sent = Command::new("kill")
            .args([signal, &child.id().to_string()])
            .status()
            .expect("kill runs");
        assert!(sent.success());
    }

    #[tokio::test]
    async fn ctrl_c_keeps_what_is_solved_and_the_next_run_resumes() {
        let folder = tempfile::tempdir().expect("temp dir");
        let study = draft(folder.path());
        let run = spawn(folder.path(), &["run", study, "--threads", "1"]);
        wait_for_points(&folder.path().join("strainsite.db"), 3).await;
        send("-INT", &run);
        let output = run.wait_with_output().expect("ends");
        assert_eq!(output.status.code(), Some(1));
        assert!(
            text(&output.stderr).contains("next run of this study resumes"),
            "{}",
            text(&output.stderr)
        );
        let kept = stored_points(&folder.path().join("strainsite.db")).await;
        assert!((3..26).contains(&kept), "{kept} points");

        let resumed = strainsite(folder.path(), &["run", study, "--json", "-"]);
        assert_eq!(resumed.status.code(), Some(0), "{}", text(&resumed.stderr));
        let result: Value = serde_json::from_slice(&resumed.stdout).expect("JSON");
        assert_eq!(result["cost"]["reused"], kept);
    }

    #[test]
    fn the_service_ends_with_0_when_it_is_asked_to_stop() {
        for signal in ["-INT", "-TERM"] {
            let folder = tempfile::tempdir().expect("temp dir");
            let mut service = spawn(folder.path(), &["serve", "--addr", "127.0.0.1:0"]);
            let mut line = String::new();
            let stdout = service.stdout.take().expect("a pipe");
            BufReader::new(stdout).read_line(&mut line).expect("a line");
            assert!(
                line.starts_with("listening on http://127.0.0.1:"),
                "{line:?}"
            );
            send(signal, &service);
            assert_eq!(service.wait().expect("ends").code(), Some(0), "{signal}");
            assert!(
                !folder.path().join("strainsite.db-wal").exists(),
                "the log is folded into the database"
            );
        }
    }
}
