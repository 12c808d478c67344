//! Settings of `serve`: flags, environment, file, defaults.

use std::fs;
use std::process::Output;

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
fn all_faults_are_told_at_once_and_nothing_is_started() {
    let folder = tempfile::tempdir().expect("temp dir");
    let file = "threads = 0\nmax_waiting = -1\ncolour = \"black\"\nlog = \"server=loud\"\ntoken = \"hush\"\nhost = [\"a b\"]";
    fs::write(folder.path().join("settings.toml"), file).expect("writes");
    let serve = |arguments: &[&str], environment: &[(&str, &str)]| -> Output {
        let mut command = command(folder.path(), &[&["serve"], arguments].concat());
        command
            .envs(environment.iter().copied())
            .output()
            .expect("the program runs")
    };
    let refused = serve(
        &["--config", "settings.toml", "--turn-s", "soon"],
        &[("STRAINSITE_ADDR", "everywhere")],
    );
    assert_eq!(refused.status.code(), Some(2));
    let told = text(&refused.stderr);
    for place in [
        "settings.toml: threads: ",
        "settings.toml: max_waiting: ",
        "settings.toml: colour: there is no such setting; there are addr, ",
        "settings.toml: log: ",
        "settings.toml: token: ",
        "settings.toml: host: ",
        "--turn-s: \"soon\"",
        "STRAINSITE_ADDR: \"everywhere\"",
    ] {
        assert!(
            told.lines().any(|line| line.starts_with(place)),
            "{place} is not in {told}"
        );
    }
    assert_eq!(told.lines().count(), 8, "{told}");
    assert!(!told.contains("hush"));

    // Settings that are right by themselves and wrong together.
    let together = serve(
        &[
            "--addr",
            "0.0.0.0:0",
            "--solver",
            "calculix",
            "--ccx",
            "./no-ccx",
        ],
        &[],
    );
    let told = text(&together.stderr);
    assert_eq!(together.status.code(), Some(2));
    assert!(
        told.contains("--token") && told.contains("calculix-ccx"),
        "{told}"
    );
    assert!(!folder.path().join("strainsite.db").exists());
}

/// The table of settings is read by people only, so it is compared here.
#[test]
fn every_setting_is_in_the_manual() {
    let folder = tempfile::tempdir().expect("temp dir");
    let help = command(folder.path(), &["serve", "--help"])
        .output()
        .expect("the program runs");
    let manual = include_str!("../../../../docs/operations.md");
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
