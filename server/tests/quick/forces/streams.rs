//! Streams of rows that are late, cut, no numbers and worse: each is answered, and none ends them.

use std::io::Write;
use std::process::Stdio;

use super::{fitted, fitted_with, recording_of};
use crate::program::{command, strainsite, text};

const HEADER: &str = "time_s,a,\"b, V\",fz_n";
const OUT: &str = "time_s,fz_n,fz_n_low,fz_n_high,outside,state,column";

/// Answers to a stream, without their header, and what is said at its end.
fn streamed(folder: &std::path::Path, rows: &[u8]) -> (Vec<String>, String) {
    streamed_with(folder, &[], rows)
}

fn streamed_with(folder: &std::path::Path, options: &[&str], rows: &[u8]) -> (Vec<String>, String) {
    let arguments = [&["force", "apply", "model.json", "-"], options].concat();
    let mut program = command(folder, &arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("starts");
    let mut stdin = program.stdin.take().expect("a pipe");
    let rows = rows.to_vec();
    let sent = std::thread::spawn(move || stdin.write_all(&rows));
    let output = program.wait_with_output().expect("ends");
    sent.join().expect("sends").expect("is read to its end");
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let mut lines = text(&output.stdout).lines().map(str::to_owned);
    assert_eq!(lines.next().as_deref(), Some(OUT));
    (lines.collect(), text(&output.stderr).to_owned())
}

/// The rows of a clean recording.
fn clean(rows: u32) -> Vec<String> {
    let whole = recording_of(rows, 0.05, 4.0);
    whole.lines().skip(1).map(str::to_owned).collect()
}

fn joined(rows: &[String]) -> Vec<u8> {
    format!("{HEADER}\n{}\n", rows.join("\n")).into_bytes()
}

/// State and column of an answer.
fn state(answer: &str) -> &str {
    answer.splitn(6, ',').last().unwrap_or_default()
}

#[test]
fn every_fault_is_answered_by_its_state_and_the_rows_around_it_are_right() {
    let folder = tempfile::tempdir().expect("temp dir");
    fitted(folder.path());
    let rows = clean(1000);
    let (right, told) = streamed(folder.path(), &joined(&rows));
    assert_eq!(told, "rows: 1000 ok\n");
    assert!(right.iter().all(|answer| state(answer) == "ok,"));

    let mut faulty = rows.clone();
    let time = |row: &str| row.split(',').next().unwrap_or_default().to_owned();
    // By their places from the last to the first, so that each is where it says.
    faulty.insert(900, HEADER.to_owned());
    faulty.insert(800, "\u{fffd}garbage".to_owned());
    faulty.insert(700, rows[699][..rows[699].len() / 3].to_owned());
    faulty.insert(600, format!("{},inf,1,", time(&rows[599])));
    faulty.insert(500, format!("{},1,nan,", time(&rows[499])));
    faulty.insert(400, format!("{},,1,", time(&rows[399])));
    faulty.insert(300, rows[200].clone());
    faulty.insert(200, rows[199].clone());
    faulty.insert(100, format!("{}1,9,9,", time(&rows[99])));
    let (answers, told) = streamed(folder.path(), &joined(&faulty));
    let expected = [
        (100, "early,"),
        (201, "duplicate,"),
        (302, "clock-reset,"),
        (303, "gap,"),
        (403, "not-a-number,a"),
        (504, "not-a-number,\"b, V\""),
        (605, "not-a-number,a"),
        (706, "cut,"),
        (807, "cut,"),
        (908, "header,"),
    ];
    for (place, expected) in expected {
        assert_eq!(state(&answers[place]), expected, "{}", answers[place]);
    }
    assert_eq!(answers.len(), 1009);
    assert!(told.contains("999 ok"), "{told}");
    // One that isn't estimated from changes no other: what is left is as without it, from the gap of the clock on as soon as windows are full again.
    let estimated = answers.iter().filter(|answer| state(answer) == "ok,");
    let expected = right.iter().enumerate().filter(|(row, _)| *row != 300);
    for (answer, (row, right)) in estimated.zip(expected) {
        assert_eq!(answer, right, "row {row}");
    }
}

#[test]
fn bad_rows_hold_the_last_estimate_where_the_recipe_says_so() {
    let folder = tempfile::tempdir().expect("temp dir");
    fitted(folder.path());
    let model = folder.path().join("model.json");
    let text = std::fs::read_to_string(&model).expect("reads");
    assert!(text.contains("\"bad_rows\":\"null\""));
    let rows = [clean(1), vec!["0.05,,1,".to_owned()]].concat();
    let (answers, _) = streamed(folder.path(), &joined(&rows));
    assert_eq!(answers[1], "0.05,,,,,not-a-number,a");
    std::fs::write(
        &model,
        text.replace("\"bad_rows\":\"null\"", "\"bad_rows\":\"hold\""),
    )
    .expect("writes");
    let (answers, _) = streamed(folder.path(), &joined(&rows));
    let cells = |answer: &str| {
        answer
            .split(',')
            .skip(1)
            .take(4)
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    assert_eq!(cells(&answers[0]), cells(&answers[1]));
}

/// Root mean square error of the answers with a known force.
fn rmse(answers: &[String], rows: &[String]) -> f64 {
    let off = |(answer, row): (&String, &String)| -> Option<f64> {
        let truth: f64 = row.rsplit(',').next()?.parse().ok()?;
        let estimate: f64 = answer.split(',').nth(1)?.parse().ok()?;
        Some((estimate - truth).powi(2))
    };
    let squares: Vec<f64> = answers.iter().zip(rows).filter_map(off).collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

/// A stream begun under a quarter, half and all of the largest force is off by that; zeroed once it is lifted, or told the zero of another recording, it is as one that was
/// begun unloaded: within 1.2 times its error.
#[test]
fn a_stream_begun_loaded_is_right_once_it_has_a_zero() {
    let folder = tempfile::tempdir().expect("temp dir");
    fitted(folder.path());
    let rows = clean(280);
    let force = |row: usize| {
        let cell = rows[row].rsplit(',').next().unwrap_or_default();
        cell.parse::<f64>().ok()
    };
    let most = (0..70).filter_map(force).fold(0.0, f64::max);
    let is_free = |row: &usize| force(*row).is_some_and(|force| force < 0.02);
    let free = (70..140).rfind(is_free).expect("a row without a force");
    let right = streamed(folder.path(), &joined(&rows)).0;
    let expected = rmse(&right[free..], &rows[free..]);
    let rest = [rows[0].clone(), rows[free].clone()];
    std::fs::write(folder.path().join("rest.csv"), joined(&rest)).expect("writes");
    for share in [0.25, 0.5, 1.0] {
        let near = |row: &usize| force(*row).is_some_and(|f| f >= 0.99 * share * most);
        let begun = (0..70).find(near).expect("a loaded row");
        let loaded = streamed(folder.path(), &joined(&rows[begun..])).0;
        let off = rmse(&loaded[free - begun..], &rows[free..]);
        assert!(off > 3.0 * expected, "{share}: {off} for {expected}");
        // Offsets of sessions are 1 N apart, so that less than 3 N may be one.
        let is_told = state(&loaded[0]) == "loaded,";
        assert_eq!(is_told, share == 1.0, "{}", loaded[0]);

        let mut zeroed = rows[begun..].to_vec();
        zeroed.insert(free - begun, "zero".to_owned());
        let (answers, told) = streamed(folder.path(), &joined(&zeroed));
        assert!(told.contains("1 zero"), "{told}");
        assert_eq!(state(&answers[free - begun]), "zero,");
        let off = rmse(&answers[free - begun..], &rows[free..]);
        assert!(off <= 1.2 * expected, "{share}: {off} for {expected}");

        let (answers, _) = streamed_with(
            folder.path(),
            &["--start", "rest.csv"],
            &joined(&rows[begun..]),
        );
        let off = rmse(&answers, &rows[begun..]);
        assert!(off <= 1.2 * expected, "{share}: {off} for {expected}");
    }
}

#[test]
fn a_model_that_keeps_first_readings_takes_a_zero_by_how_far_it_moved() {
    let folder = tempfile::tempdir().expect("temp dir");
    fitted_with(folder.path(), "[preprocess]\nstart_value = \"keep\"\n");
    let model: serde_json::Value = serde_json::from_str(
        &std::fs::read_to_string(folder.path().join("model.json")).expect("reads"),
    )
    .expect("JSON");
    let zero = model["zero"][0].as_f64().expect("a zero");
    // Sessions 1 and 2 have offsets of 1 and 2: the upper one of two medians.
    assert!((zero - 2.0).abs() < 0.1, "{zero}");
    let rows = clean(280);
    let (kept, _) = streamed(folder.path(), &joined(&rows));
    let (zeroed, _) = streamed_with(folder.path(), &["--start", "first"], &joined(&rows));
    // The fourth session's offset is 4, which nobody has seen.
    let [kept, zeroed] = [kept, zeroed].map(|answers| rmse(&answers, &rows));
    assert!(zeroed < 0.5 * kept, "{zeroed} for {kept}");
    let (model, _) = streamed_with(folder.path(), &["--start", "model"], &joined(&rows));
    assert_eq!(rmse(&model, &rows), kept);
}

#[test]
fn whatever_a_row_is_like_the_stream_goes_on() {
    let folder = tempfile::tempdir().expect("temp dir");
    fitted(folder.path());
    let rows = clean(1000);
    let mut state = 7_u64;
    let mut drawn = |most: usize| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        usize::try_from(state >> 33).expect("31 bits") % most
    };
    let mut bytes = joined(&rows);
    let begins = HEADER.len() + 1;
    for _ in 0..200 {
        let at = begins + drawn(bytes.len() - begins);
        match drawn(4) {
            0 => bytes[at] = u8::try_from(drawn(256)).expect("a byte"),
            1 => drop(bytes.drain(at..(at + drawn(40)).min(bytes.len()))),
            2 => bytes.insert(at, b','),
            _ => bytes.insert(at, b'\n'),
        }
    }
    let (answers, told) = streamed(folder.path(), &bytes);
    assert!(answers.len() > 900, "{told}");
    assert!(
        answers
            .iter()
            .all(|answer| !answer.contains("NaN") && !answer.contains("inf"))
    );
    let right = answers
        .iter()
        .filter(|answer| answer.ends_with(",ok,"))
        .count();
    assert!(right > 600, "{told}");
}

#[test]
fn signals_of_two_clocks_are_estimated_as_from_a_file() {
    let folder = tempfile::tempdir().expect("temp dir");
    fitted_with(folder.path(), "[preprocess]\nrate_hz = 20\n");
    let mut rows = clean(60);
    for (row, line) in rows.iter_mut().enumerate() {
        let mut cells: Vec<&str> = line.split(',').collect();
        cells[1 + row % 2] = "";
        *line = cells.join(",");
    }
    let (answers, told) = streamed(folder.path(), &joined(&rows));
    assert_eq!(told, "rows: 60 ok\n");
    std::fs::write(folder.path().join("two.csv"), joined(&rows)).expect("writes");
    let file = strainsite(folder.path(), &["force", "apply", "model.json", "two.csv"]);
    let file: Vec<String> = text(&file.stdout)
        .lines()
        .skip(1)
        .map(|line| format!("{line},ok,"))
        .collect();
    assert!(file.len() > 50);
    assert_eq!(answers, file);
}

#[test]
fn a_file_that_begins_loaded_is_warned_of() {
    let folder = tempfile::tempdir().expect("temp dir");
    fitted(folder.path());
    let rows = clean(280);
    let force = |row: &String| row.rsplit(',').next().and_then(|cell| cell.parse().ok());
    let begun = rows.iter().position(|row| force(row) > Some(5.0));
    let loaded = joined(&rows[begun.expect("a loaded row")..]);
    std::fs::write(folder.path().join("loaded.csv"), loaded).expect("writes");
    let apply = |options: &[&str]| {
        let arguments = [&["force", "apply", "model.json", "loaded.csv"], options].concat();
        let output = strainsite(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(0));
        text(&output.stderr).to_owned()
    };
    let warning = apply(&[]);
    let begins = "loaded.csv: it begins under some ";
    assert!(warning.starts_with(begins), "{warning}");
    // By the zero of the model nothing is taken for nothing.
    assert_eq!(apply(&["--start", "model"]), "");
}
