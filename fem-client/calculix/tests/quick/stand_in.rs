//! A script that stands in for CalculiX.

use std::path::{Path, PathBuf};
use std::process::Command;

/// Puts a script where it can be started at once.
///
/// Another process writes it: a program that a test beside this one starts inherits every file that this process has open for writing, and a script that
/// anybody has open for writing can't be started ("Text file busy").
pub(crate) fn install(folder: &Path, script: &str) -> PathBuf {
    let (text, program) = (folder.join("ccx.txt"), folder.join("ccx"));
    std::fs::write(&text, script).expect("writes");
    let installed = Command::new("install")
        .args(["-m", "755"])
        .args([&text, &program])
        .status()
        .expect("starts");
    assert!(installed.success(), "{installed}");
    program
}
