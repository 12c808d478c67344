//! Commands that are refused: with an exit code and every fault on a line of its own, before anything is solved or written.

use std::fmt::Write as _;

use super::compare;
use super::redaction::Redaction;
use crate::cli::{REPOSITORY, draft};
use crate::program::{strainsite, text};

const FILES: [(&str, &str); 5] = [
    (
        "scene.toml",
        "[pressure]\ninternal_mpa = -1\n[carcass]\nposition = 2\n",
    ),
    (
        "settings.toml",
        "threads = 0\nmax_waiting = -1\ncolour = \"black\"\nlog = \"server=loud\"\ntoken = \"hush\"\nhost = [\"a b\"]",
    ),
    (
        "inputs.toml",
        "[[inputs]]\nname = \"a\"\ndistribution = { kind = \"uniform\", min = 1, max = 0 }\n",
    ),
    ("broken.toml", "name = \n"),
    ("letter.db", "dear reader, this is not a database"),
];

#[test]
fn refusals_are_as_recorded_and_nothing_is_made() {
    let folder = tempfile::tempdir().expect("temp dir");
    let study = draft(folder.path());
    for (name, content) in FILES {
        std::fs::write(folder.path().join(name), content).expect("writes");
    }
    let shipped = format!("{REPOSITORY}/scenes/foot-tire.toml");
    std::fs::copy(shipped, folder.path().join("tire.toml")).expect("copies");
    let before = std::fs::read_dir(folder.path()).expect("lists").count();

    let grid = "geometry.wall_mm=2,99";
    let (mut redaction, mut record) = (Redaction::default(), String::new());
    for arguments in [
        // Words
        &["fly"][..],
        &["run"],
        &["run", "foot-tyre"],
        &["run", study, "--thread", "2"],
        &["export", "none", "--format", "xls"],
        &["serve", "--addr", "0.0.0.0:8080"],
        &[
            "serve",
            "--config",
            "settings.toml",
            "--turn-s",
            "soon",
            "--addr",
            "everywhere",
        ],
        &[
            "serve",
            "--addr",
            "0.0.0.0:0",
            "--solver",
            "calculix",
            "--ccx",
            "./no-ccx",
        ],
        // Documents
        &["validate", "absent.toml"],
        &["validate", "broken.toml"],
        &["validate", "scene.toml"],
        &["solve", "scene.toml"],
        &["run", "absent.toml"],
        &["run", "scene.toml"],
        &["gsa", "plan", "inputs.toml"],
        &[
            "solve",
            "tire.toml",
            "--set",
            "pressure",
            "--set",
            "geometry.wall_mm=2",
            "--set",
            "geometry.wall_mm=3",
        ],
        &[
            "solve",
            "tire.toml",
            "--vtu",
            "other.vtu",
            "--solver",
            "calculix",
        ],
        &["run", study, "--set", "wall"],
        &["run", study, "--set", "method.nodes=0"],
        &["sweep", study],
        &["sweep", "--grid", grid],
        &["sweep", study, "--grid", "wall"],
        &[
            "sweep",
            study,
            "--grid",
            grid,
            "--grid",
            "geometry.wal_mm=1",
        ],
        &["sweep", study, "--grid", grid, "--set", "method.nodes=0"],
        // Databases
        &["list"],
        &["show", "none"],
        &["db", "check"],
        &["run", study, "--db", "letter.db"],
        // Outputs
        &["run", study, "--json", "strainsite.db"],
        &["run", study, "--json", "strainsite.db-wal"],
        &["run", study, "--json", study],
        &["run", study, "--json", "absent/result.json"],
        &["run", study, "--out", study],
        &["run", study, "--json", "out/result.json", "--out", "out"],
    ] {
        let ran = strainsite(folder.path(), arguments);
        assert!(ran.stdout.is_empty(), "{arguments:?}");
        let code = ran.status.code().expect("ends by itself");
        let told = redaction.text(text(&ran.stderr));
        writeln!(record, "## {}\ncode {code}\n{told}", arguments.join(" ")).expect("writes");
    }
    let after = std::fs::read_dir(folder.path()).expect("lists").count();
    assert_eq!(after, before, "nothing is made");
    compare("refused-commands", &record);
}
