//! Models of files, and estimates of files.

use std::io::{BufRead, BufReader, Write};
use std::process::Stdio;

use super::{fitted, recording, recording_every, write};
use crate::program::{command, strainsite, text};

#[test]
fn a_model_knows_a_run_that_it_did_not_learn_from() {
    let folder = tempfile::tempdir().expect("temp dir");
    let report = fitted(folder.path());
    let recordings = report["recordings"].as_array().expect("recordings");
    assert_eq!(recordings[0]["file"], "one.csv");
    assert_eq!(
        (&recordings[0]["rows"], &recordings[0]["labelled"]),
        (&300.into(), &240.into())
    );
    assert_eq!(recordings[0]["cycles"], 8);
    let force = &report["forces"][0];
    assert_eq!(force["force"], "fz_n");
    let best = &force["models"][0];
    assert_eq!(best["model"], force["chosen"]);
    assert_eq!(
        (&best["validation"]["by"], &best["better_than_mean"]),
        (&"run".into(), &true.into())
    );
    let claimed = best["validation"]["rmse_n"].as_f64().expect("a number");
    for split in ["random", "cycle", "run", "time"] {
        assert!(best["splits"][split]["rmse_n"].is_f64(), "{split}");
    }
    let apply = strainsite(
        folder.path(),
        &["force", "apply", "model.json", "new.csv", "-o", "out.csv"],
    );
    assert_eq!(apply.status.code(), Some(0), "{}", text(&apply.stderr));
    let out = std::fs::read_to_string(folder.path().join("out.csv")).expect("reads");
    let mut lines = out.lines();
    assert_eq!(lines.next(), Some("time_s,fz_n,fz_n_low,fz_n_high,outside"));
    let truth = recording(4.0);
    let (mut squares, mut inside, mut count) = (0.0, 0, 0);
    for (line, truth) in lines.zip(truth.lines().skip(1)) {
        let cells: Vec<f64> = line
            .split(',')
            .map(|cell| cell.parse().expect("a number"))
            .collect();
        if let Ok(truth) = truth.rsplit(',').next().unwrap_or_default().parse::<f64>() {
            squares += (cells[1] - truth).powi(2);
            inside += usize::from((cells[2]..=cells[3]).contains(&truth));
            count += 1;
        }
    }
    let rmse = (squares / f64::from(count)).sqrt();
    assert!(
        rmse < 2.5 * claimed && claimed < 2.5 * rmse,
        "{rmse} for {claimed}"
    );
    assert!(
        inside * 10 >= usize::try_from(count).expect("counted") * 9,
        "{inside} of {count}"
    );
}

#[test]
fn rows_are_answered_one_by_one_with_the_file_s_bits() {
    let folder = tempfile::tempdir().expect("temp dir");
    fitted(folder.path());
    let whole = strainsite(folder.path(), &["force", "apply", "model.json", "new.csv"]);
    let arguments = ["force", "apply", "model.json", "-", "--strict"];
    let mut program = command(folder.path(), &arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("starts");
    let mut rows = program.stdin.take().expect("a pipe");
    let mut answers = BufReader::new(program.stdout.take().expect("a pipe"));
    let mut answered = String::new();
    for line in recording(4.0).lines() {
        writeln!(rows, "{line}").expect("writes");
        // Each row is answered before the next one is sent.
        answers.read_line(&mut answered).expect("reads");
    }
    drop(rows);
    assert!(program.wait().expect("ends").success());
    assert_eq!(answered, text(&whole.stdout));
}

#[test]
fn every_fault_is_told_and_nothing_is_written() {
    let folder = tempfile::tempdir().expect("temp dir");
    fitted(folder.path());
    let refused = |arguments: &[&str], parts: &[&str]| {
        let refused = strainsite(folder.path(), arguments);
        let told = text(&refused.stderr);
        assert_eq!(refused.status.code(), Some(2), "{told}");
        assert!(refused.stdout.is_empty());
        for part in parts {
            assert!(told.contains(part), "{part}: {told}");
        }
        assert!(!folder.path().join("no.json").exists());
    };
    let bad = recording(1.0)
        .replacen("\n0.1,", "\n0.1,1,", 1)
        .replacen("\n0.2,", "\nnan,", 1)
        .replacen("\n0.4,", "\n0.3,", 1);
    write(
        folder.path(),
        &[
            ("bad.csv", &bad),
            ("other.csv", &recording(1.0).replacen(",a,", ",c,", 1)),
            ("slow.csv", &recording_every(0.1, 1.0)),
            ("dead.csv", "time_s,a,fz_n\n0,1,\n1,1,\n2,1,\n"),
            (
                "wrong.toml",
                "[columns]\ncycle = \"c\"\npause_s = -1\n[validation]\nby = \"day\"\n",
            ),
            ("twin.csv", &recording(1.0)),
            (
                "negative.csv",
                &recording(1.0).replacen(",0.0\n", ",-1\n", 1),
            ),
            ("poisson.toml", "[models.ann]\nloss = \"poisson\"\n"),
            (
                "negative.csv",
                &recording(1.0).replacen(",0.0\n", ",-1\n", 1),
            ),
            ("by_run.toml", "[validation]\nby = \"run\"\n"),
            (
                "newer.json",
                &std::fs::read_to_string(folder.path().join("model.json"))
                    .expect("reads")
                    .replacen("\"version\":2", "\"version\":3", 1),
            ),
        ],
    );
    let fit = |recipe: &'static str, runs: &[&'static str]| {
        let mut arguments = vec!["force", "fit", recipe];
        arguments.extend(runs);
        arguments.extend(["-o", "no.json"]);
        arguments
    };
    refused(
        &fit("recipe.toml", &["bad.csv", "other.csv"]),
        &[
            "bad.csv, line 4: has 5 cells",
            "bad.csv, line 6, column time_s: is empty",
            "bad.csv, line 10, column time_s: time must rise",
            "bad.csv, line 1, column c: is missing",
            "other.csv, line 1, column a: is missing",
        ],
    );
    refused(
        &fit("wrong.toml", &["one.csv"]),
        &["/columns/pause_s", "/validation/by"],
    );
    refused(
        &fit("by_run.toml", &["one.csv"]),
        &["/validation/by: runs can't be left out of one run"],
    );
    refused(
        &fit("by_run.toml", &["dead.csv"]),
        &[
            "signal a is dead",
            "fz_n was measured in no row",
            "there are 3 cycles",
        ],
    );
    refused(
        &fit("recipe.toml", &["one.csv", "twin.csv"]),
        &["twin.csv is the same as one.csv"],
    );
    refused(
        &fit("poisson.toml", &["negative.csv"]),
        &["/models/ann/loss: the Poisson loss takes forces of 0 and more"],
    );
    refused(
        &fit("recipe.toml", &["absent.csv"]),
        &["absent.csv can't be read"],
    );
    refused(
        &["force", "apply", "model.json", "other.csv", "-o", "no.json"],
        &["other.csv, line 1, column a: is missing"],
    );
    refused(
        &["force", "apply", "model.json", "slow.csv", "-o", "no.json"],
        &["rows a second"],
    );
    refused(
        &["force", "apply", "newer.json", "new.csv", "-o", "no.json"],
        &["version is 3"],
    );
    refused(
        &["force", "apply", "one.csv", "new.csv", "-o", "no.json"],
        &["it is no model"],
    );
}
