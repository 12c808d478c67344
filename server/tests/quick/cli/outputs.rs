//! Outputs whose readers went away.

use std::process::Stdio;

use crate::program::command;

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
