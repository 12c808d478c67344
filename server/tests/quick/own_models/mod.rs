//! A model of somebody else, asked and told: by `strainsite gsa` here, by `/v1/analyses` in `over_http`, over UM-Bridge's protocol in `served_models`; and ours, asked by others: `umbridge`.

mod over_http;
mod served_models;
mod toy_server;
mod umbridge;

use std::f64::consts::PI;
use std::path::Path;

use crate::program::{strainsite, text};
use serde_json::Value;

/// Three uniform inputs on [-pi, pi] and a method.
fn write_inputs(folder: &Path, method: &str) {
    let mut document = String::new();
    for name in ["a", "b, mm", "c"] {
        document.push_str(&format!(
            "[[inputs]]\nname = \"{name}\"\ndistribution = {{ kind = \"uniform\", min = {:?}, max = {PI:?} }}\n",
            -PI
        ));
    }
    document.push_str(&format!("[method]\n{method}\n"));
    std::fs::write(folder.join("inputs.toml"), document).expect("writes");
}

fn ishigami(x: &[f64]) -> f64 {
    x[0].sin() * (1.0 + 0.1 * x[2].powi(4)) + 7.0 * x[1].sin().powi(2)
}

/// Runs the model at the points of a plan and appends its values.
fn answer(plan: &str, values: &mut String) -> usize {
    let rows: Vec<&str> = plan.lines().skip(1).collect();
    for row in &rows {
        let cells: Vec<&str> = row.split(',').collect();
        let x: Vec<f64> = cells[1..]
            .iter()
            .map(|x| x.parse().expect("a number"))
            .collect();
        let y = ishigami(&x);
        values.push_str(&format!("{},{y:?},{:?}\n", cells[0], 3.0 + x[0]));
    }
    rows.len()
}

#[test]
fn auto_asks_until_it_knows() {
    let folder = tempfile::tempdir().expect("temp dir");
    let at = folder.path();
    write_inputs(at, "kind = \"auto\"");
    let mut values = "id,y,\"z, N\"\n".to_owned();
    let mut rounds = 0;
    loop {
        let mut arguments = vec!["gsa", "plan", "inputs.toml"];
        if rounds > 0 {
            arguments.extend(["--values", "values.csv"]);
        }
        let plan = strainsite(at, &arguments);
        assert_eq!(plan.status.code(), Some(0), "{}", text(&plan.stderr));
        let plan = text(&plan.stdout);
        assert!(plan.starts_with("id,a,\"b, mm\",c\n"), "{plan}");
        if answer(plan, &mut values) == 0 {
            break;
        }
        std::fs::write(at.join("values.csv"), &values).expect("writes");
        rounds += 1;
    }
    assert!(rounds > 1);
    let found = strainsite(
        at,
        &["gsa", "analyse", "inputs.toml", "values.csv", "--json", "-"],
    );
    let found: Value = serde_json::from_slice(&found.stdout).expect("one JSON document");
    // no peer needs fewer than some hundreds of runs for two digits here
    assert!(found["evaluations"].as_u64() < Some(100), "{found}");
    assert_eq!(found["wanted"], 0);
    let outputs = found["outputs"].as_array().expect("outputs");
    let exact = [
        [0.31390519114781146, 0.4424111447900408, 0.0],
        [1.0, 0.0, 0.0],
    ];
    for (output, exact) in outputs.iter().zip(exact) {
        let claimed = output["error"]["total"].as_f64().expect("an error");
        for (i, exact) in exact.iter().enumerate() {
            let error = (output["first_order"][i].as_f64().expect("an index") - exact).abs();
            assert!(error <= claimed && claimed <= 0.02, "{output}");
        }
    }
    assert_eq!(outputs[1]["name"], "z, N");
}

#[test]
fn a_claim_as_large_as_the_indices_names_the_method_that_asks_for_more_and_takes_what_there_is() {
    let folder = tempfile::tempdir().expect("temp dir");
    let at = folder.path();
    write_inputs(at, "kind = \"mdrm\"");
    let checked = strainsite(at, &["validate", "inputs.toml"]);
    assert_eq!(checked.status.code(), Some(0), "{}", text(&checked.stderr));
    assert!(text(&checked.stdout).contains("3 inputs of a model of your own, by mdrm"));
    let mut values = "id,y,\"z, N\"\n".to_owned();
    let plan = strainsite(at, &["gsa", "plan", "inputs.toml"]);
    answer(text(&plan.stdout), &mut values);
    std::fs::write(at.join("values.csv"), &values).expect("writes");
    let analyse = ["gsa", "analyse", "inputs.toml", "values.csv"];
    assert!(text(&strainsite(at, &analyse).stdout).contains("kind = \"auto\""));
    // The values go on to serve: a handful more are asked for.
    write_inputs(at, "kind = \"auto\"");
    let more = strainsite(
        at,
        &["gsa", "plan", "inputs.toml", "--values", "values.csv"],
    );
    assert_eq!(more.status.code(), Some(0), "{}", text(&more.stderr));
    let asked = text(&more.stdout).lines().count() - 1;
    assert!((1..12).contains(&asked), "{asked}");
    assert!(!text(&strainsite(at, &analyse).stdout).contains("as large as the indices"));
}

#[test]
fn plans_are_the_same_every_time_and_go_to_a_file_if_asked() {
    let folder = tempfile::tempdir().expect("temp dir");
    for kind in ["mdrm", "bivariate", "tensor", "pce", "saltelli"] {
        write_inputs(folder.path(), &format!("kind = \"{kind}\"\nsamples = 64"));
        let first = strainsite(folder.path(), &["gsa", "plan", "inputs.toml"]);
        let second = strainsite(
            folder.path(),
            &["gsa", "plan", "inputs.toml", "-o", "points.csv"],
        );
        assert_eq!(second.status.code(), Some(0), "{kind}");
        let file = std::fs::read_to_string(folder.path().join("points.csv")).expect("the plan");
        assert_eq!(text(&first.stdout), file, "{kind}");
        assert!(second.stdout.is_empty());
    }
}

#[test]
fn faults_of_both_files_are_listed_with_their_places() {
    let folder = tempfile::tempdir().expect("temp dir");
    let at = folder.path();
    write_inputs(at, "kind = \"mdrm\"\nnodes = 0\ncolour = 1");
    let refused = strainsite(at, &["gsa", "plan", "inputs.toml"]);
    assert_eq!(refused.status.code(), Some(2));
    for place in ["/method/nodes", "/method/colour"] {
        assert!(
            text(&refused.stderr).contains(place),
            "{}",
            text(&refused.stderr)
        );
    }
    write_inputs(at, "kind = \"mdrm\"");
    for (values, expected) in [
        ("id,y\n0,1\n0,2\nx,3\n", &["line 3", "line 4"][..]),
        ("id,y\n0,1\n1,2\n", &["no values for points 2, 3"][..]),
        ("id,y\n500,1\n", &["line 2: there is no point 500"][..]),
    ] {
        std::fs::write(at.join("values.csv"), values).expect("writes");
        let refused = strainsite(at, &["gsa", "analyse", "inputs.toml", "values.csv"]);
        assert_eq!(refused.status.code(), Some(2), "{values}");
        for part in expected {
            assert!(
                text(&refused.stderr).contains(part),
                "{}",
                text(&refused.stderr)
            );
        }
    }
}

#[test]
fn a_failed_run_is_named_and_the_rest_analysed() {
    let folder = tempfile::tempdir().expect("temp dir");
    let at = folder.path();
    write_inputs(at, "kind = \"mdrm\"\nnodes = 7");
    let plan = strainsite(at, &["gsa", "plan", "inputs.toml"]);
    let mut values = "id,y,z\n".to_owned();
    answer(text(&plan.stdout), &mut values);
    let values: Vec<String> = values
        .lines()
        .map(|line| match line.split_once(',') {
            Some(("3", _)) => "3,nan,".to_owned(),
            _ => line.to_owned(),
        })
        .collect();
    std::fs::write(at.join("values.csv"), values.join("\n")).expect("writes");
    let found = strainsite(
        at,
        &[
            "gsa",
            "analyse",
            "inputs.toml",
            "values.csv",
            "--json",
            "out.json",
        ],
    );
    assert_eq!(found.status.code(), Some(0), "{}", text(&found.stderr));
    assert!(text(&found.stdout).contains("first order"));
    let json = std::fs::read_to_string(at.join("out.json")).expect("the answer");
    let json: Value = serde_json::from_str(&json).expect("JSON");
    for output in json["outputs"].as_array().expect("outputs") {
        assert!(output["first_order"].is_array(), "{output}");
        assert!(
            output["reason"]
                .as_str()
                .is_some_and(|r| r.contains("lines: 3")),
            "{output}"
        );
    }
}

/// The plan's own columns stay in the file of values, with y = a + 2 b + c behind them.
fn kept(plan: &str) -> String {
    let mut lines = plan.lines();
    let mut values = format!("{},y\n", lines.next().expect("a header"));
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        let x: Vec<f64> = cells[1..4]
            .iter()
            .map(|x| x.parse().expect("a number"))
            .collect();
        values.push_str(&format!("{line},{:?}\n", x[0] + 2.0 * x[1] + x[2]));
    }
    values
}

#[test]
fn columns_of_the_plan_are_compared_with_it_and_are_no_outputs() {
    let folder = tempfile::tempdir().expect("temp dir");
    let at = folder.path();
    write_inputs(at, "kind = \"mdrm\"");
    let plan = strainsite(at, &["gsa", "plan", "inputs.toml", "--fingerprint"]);
    let values = kept(text(&plan.stdout));
    assert!(values.starts_with("id,a,\"b, mm\",c,plan,y\n"), "{values}");
    std::fs::write(at.join("values.csv"), &values).expect("writes");
    let analyse = ["gsa", "analyse", "inputs.toml", "values.csv", "--json", "-"];
    let found = strainsite(at, &analyse);
    let found: Value = serde_json::from_slice(&found.stdout).expect("one JSON document");
    assert_eq!(found["outputs"].as_array().map(Vec::len), Some(1));
    // Laws of the same range and one node more: the means stay where they are, all other points move.
    write_inputs(at, "kind = \"mdrm\"\nnodes = 7");
    let refused = strainsite(at, &analyse);
    assert_eq!(refused.status.code(), Some(2));
    let said = text(&refused.stderr);
    for part in [
        "line 3, column \"a\": point 1 was run with ",
        "line 2, column \"plan\": point 0 is of the plan p",
        "analyse by the inputs and the method that planned these points",
    ] {
        assert!(said.contains(part), "{part} in {said}");
    }
}

#[test]
fn an_input_named_as_the_column_of_fingerprints_is_named() {
    let folder = tempfile::tempdir().expect("temp dir");
    let inputs =
        "[[inputs]]\nname = \"plan\"\ndistribution = { kind = \"uniform\", min = 0, max = 1 }\n";
    std::fs::write(folder.path().join("inputs.toml"), inputs).expect("writes");
    let refused = strainsite(
        folder.path(),
        &["gsa", "plan", "inputs.toml", "--fingerprint"],
    );
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).starts_with("/inputs/0/name: is that of the column"));
}
