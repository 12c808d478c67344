//! Settings of `serve`: flags, environment, file, defaults.

use std::fs;

use super::served::Served;
use crate::program::{command, text};

#[tokio::test]
async fn the_environment_goes_before_the_file_and_flags_before_both() {
    let folder = tempfile::tempdir().expect("temp dir");
    // Nobody but root may listen on port 1, and nothing is called nowhere.
    let file =
        "addr = \"127.0.0.1:1\"\nlog = \"off\"\ndb = \"nowhere/file.db\"\nsolve_limit_s = 60";
    fs::write(folder.path().join("settings.toml"), file).expect("writes");
    let environment = [
        ("STRAINSITE_CONFIG", "settings.toml"),
        ("STRAINSITE_ADDR", "127.0.0.1:0"),
        ("STRAINSITE_DB", "nowhere/environment.db"),
    ];
    let service = Served::start(folder.path(), &["--db", "flag.db"], &environment);
    assert!(!service.url.ends_with(":1"), "{}", service.url);
    assert!(folder.path().join("flag.db").exists());
    // The file says that nothing is logged.
    assert_eq!(service.log(), "");
}

#[test]
fn a_fault_of_the_environment_is_told_by_its_name() {
    let folder = tempfile::tempdir().expect("temp dir");
    let mut serve = command(folder.path(), &["serve"]);
    let refused = serve.env("STRAINSITE_ADDR", "everywhere").output();
    let refused = refused.expect("the program runs");
    let told = text(&refused.stderr);
    assert_eq!(refused.status.code(), Some(2));
    assert!(
        told.starts_with("STRAINSITE_ADDR: \"everywhere\""),
        "{told}"
    );
}

/// The table of settings is read by people only, so it is compared here.
#[test]
fn every_setting_is_in_the_manual() {
    let folder = tempfile::tempdir().expect("temp dir");
    let help = command(folder.path(), &["serve", "--help"])
        .output()
        .expect("the program runs");
    let manual = include_str!("../../../../docs/use/operations.md");
    let flags = text(&help.stdout)
        .split_whitespace()
        .filter_map(|word| word.strip_prefix("--"));
    let mut seen = 0;
    for flag in flags.filter(|flag| {
        flag.bytes()
            .all(|byte| byte.is_ascii_lowercase() || byte == b'-')
    }) {
        if ["help", "version", "config"].contains(&flag) {
            continue;
        }
        seen += 1;
        let key = flag.replace('-', "_");
        assert!(
            manual.contains(&format!("| `{key}` |")),
            "{key} is not in the table"
        );
    }
    assert!(seen > 10, "{seen}");
}
