//! Where outputs go, and what none of them may replace.

use std::process::Stdio;

use super::draft;
use crate::program::{command, strainsite, text};

#[test]
fn no_output_ends_the_database_or_an_input_and_nothing_is_solved_first() {
    let folder = tempfile::tempdir().expect("temp dir");
    let study = draft(folder.path());
    let before = std::fs::read(folder.path().join(study)).expect("reads");
    for (arguments, why) in [
        (&["--json", "strainsite.db"][..], "a file of the database"),
        (&["--json", "strainsite.db-wal"], "a file of the database"),
        (&["--json", study], "an input of this command"),
        (&["--json", "absent/result.json"], "there is no folder"),
        (&["--out", study], "there is no folder"),
        (
            &["--json", "out/result.json", "--out", "out"],
            "another output",
        ),
    ] {
        let ran = strainsite(folder.path(), &[&["run", study][..], arguments].concat());
        let said = text(&ran.stderr);
        assert_eq!(ran.status.code(), Some(2), "{arguments:?} {said}");
        assert!(said.contains(why), "{arguments:?} {said}");
    }
    let left: Vec<_> = std::fs::read_dir(folder.path()).expect("lists").collect();
    assert_eq!(left.len(), 1, "{left:?}");
    assert_eq!(
        std::fs::read(folder.path().join(study)).expect("reads"),
        before
    );
}

#[cfg(unix)]
#[test]
fn a_reader_that_went_away_is_no_failure() {
    let folder = tempfile::tempdir().expect("temp dir");
    for (arguments, code) in [
        (&["verify", "--only", "patch"][..], 0),
        (&["validate", "absent.toml"], 2),
    ] {
        // What both are written to has no reader.
        let (reader, out) = std::io::pipe().expect("a pipe");
        drop(reader);
        let err = out.try_clone().expect("another end");
        let mut program = command(folder.path(), arguments);
        let ran = program
            .stdout(Stdio::from(out))
            .stderr(Stdio::from(err))
            .status();
        assert_eq!(ran.expect("runs").code(), Some(code), "{arguments:?}");
    }
}
