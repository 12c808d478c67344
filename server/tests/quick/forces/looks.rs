//! Looks at files before anything is learnt from them, and files in the usual form.

use serde_json::Value;

use super::{recording, write};
use crate::program::{strainsite, text};

/// The recording with a sample that stands alone, and a column of text.
fn marred() -> String {
    let rows = recording(1.0);
    let lines = rows.lines().enumerate().map(|(at, line)| match at {
        0 => format!("{line},note\n"),
        40 => {
            let (time, rest) = line.split_once(',').expect("cells");
            let (_, rest) = rest.split_once(',').expect("cells");
            format!("{time},900,{rest},hit\n")
        }
        _ => format!("{line},\n"),
    });
    lines.collect()
}

#[test]
fn each_column_is_told_and_a_faulty_file_leaves_the_others() {
    let folder = tempfile::tempdir().expect("temp dir");
    let faulty = recording(2.0).replacen("\n0.1,", "\nx,", 1);
    let unlabelled = "time_s,a,\"b, V\"\n0,1,2\n0.05,1.1,2.5\n0.1,1,2\n";
    let recipe = "[columns]\nnot_signals = [\"note\"]\n";
    let files = [
        ("recipe.toml", recipe),
        ("marred.csv", &marred()),
        ("faulty.csv", &faulty),
        ("none.csv", unlabelled),
    ];
    write(folder.path(), &files);
    let asked =
        "force look --recipe recipe.toml marred.csv faulty.csv none.csv absent.csv --json -";
    let arguments: Vec<&str> = asked.split(' ').collect();
    let told = strainsite(folder.path(), &arguments);
    assert_eq!(told.status.code(), Some(2));
    let said = text(&told.stderr);
    let found: Value = serde_json::from_slice(&told.stdout).expect("one document");
    let recordings = found["recordings"].as_array().expect("recordings");
    let names: Vec<&str> = recordings
        .iter()
        .filter_map(|each| each["file"].as_str())
        .collect();
    assert_eq!(names, ["marred.csv", "none.csv"], "{said}");

    let columns = recordings[0]["columns"].as_array().expect("columns");
    let taken: Vec<&str> = columns
        .iter()
        .filter_map(|each| each["taken"].as_str())
        .collect();
    assert_eq!(taken, ["time", "signal", "signal", "force", "nothing"]);
    assert_eq!(columns[1]["lone"]["first"][0]["line"], 41);
    assert_eq!(columns[1]["greatest"], 900.0);
    assert_eq!(
        (&columns[3]["empty"], &columns[4]["texts"]),
        (&60.into(), &1.into())
    );
    assert_eq!(recordings[0]["labelled"], 240);
    assert!(recordings[0].get("series").is_none());
    assert!(
        recordings[1]["notes"][0]
            .as_str()
            .is_some_and(|note| note.starts_with("no column is a force"))
    );

    // The faults are those that a fit tells.
    let fit = strainsite(
        folder.path(),
        &["force", "fit", "recipe.toml", "faulty.csv", "--dry-run"],
    );
    assert_eq!(fit.status.code(), Some(2));
    assert!(text(&fit.stderr).contains("faulty.csv, line 4, column time_s"));
    assert!(said.ends_with(text(&fit.stderr)), "{said}");
    assert!(said.contains("absent.csv can't be read"), "{said}");
    assert!(
        said.contains("marred.csv, line 41, column a: 900 stands alone"),
        "{said}"
    );
    assert!(
        said.lines()
            .all(|line| line.chars().count() <= 100 || line.contains("date as")),
        "{said}"
    );
}

#[test]
fn what_a_fit_refuses_as_a_whole_is_looked_at() {
    let folder = tempfile::tempdir().expect("temp dir");
    let rows: String = (0..30)
        .map(|row| format!("0.{row:02},1,{}\n", row % 7))
        .collect();
    write(
        folder.path(),
        &[("a.csv", &format!("time_s,s1,fz_n\n{rows}"))],
    );
    let told = strainsite(folder.path(), &["force", "look", "a.csv"]);
    assert_eq!(told.status.code(), Some(0), "{}", text(&told.stderr));
    let said = text(&told.stdout);
    assert!(said.contains("suspect: signal s1 is dead"), "{said}");
    assert!(
        said.contains("force fit refuses this: /columns/signals"),
        "{said}"
    );
}

#[test]
fn a_file_in_the_usual_form_tells_what_the_file_did() {
    let folder = tempfile::tempdir().expect("temp dir");
    let commas = recording(1.0)
        .replace("\"b, V\"", "b")
        .replace(',', ";")
        .replace('.', ",");
    write(
        folder.path(),
        &[("logger.csv", &commas), ("other.csv", &recording(2.0))],
    );
    let run = |arguments: &str| {
        let arguments: Vec<&str> = arguments.split(' ').collect();
        strainsite(folder.path(), &arguments)
    };
    let told = run("force look logger.csv --convert usual.csv");
    assert_eq!(told.status.code(), Some(0), "{}", text(&told.stderr));
    let usual = std::fs::read_to_string(folder.path().join("usual.csv")).expect("reads");
    assert_eq!(usual, recording(1.0).replace("\"b, V\"", "b"));
    for (arguments, part) in [
        (
            "force look logger.csv --convert logger.csv",
            "an input of this command",
        ),
        (
            "force look logger.csv other.csv --convert out.csv",
            "takes one recording",
        ),
    ] {
        let refused = run(arguments);
        assert_eq!(refused.status.code(), Some(2));
        assert!(
            text(&refused.stderr).contains(part),
            "{}",
            text(&refused.stderr)
        );
    }
}
