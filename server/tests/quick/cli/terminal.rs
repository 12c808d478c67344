//! Terminals and pipes: what people see on the one, and programs read from the other.

use std::path::Path;
use std::process::{Command, Stdio};

use anstream::adapter::strip_str;

use super::draft;
use crate::program::{strainsite, text};

/// Variables that choose between paint and none.
const CHOICES: [&str; 4] = ["NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE", "CI"];

/// Returns what stands on a terminal when the program has run there, its exit code aside.
fn on_terminal(folder: &Path, arguments: &[&str], choice: &[(&str, &str)]) -> String {
    let quoted = |word: &str| format!("'{word}'");
    let program = [env!("CARGO_BIN_EXE_strainsite")];
    let words: Vec<String> = program
        .iter()
        .chain(arguments)
        .map(|word| quoted(word))
        .collect();
    let mut script = Command::new("script");
    script
        .args(["-q", "-c", &words.join(" "), "/dev/null"])
        .current_dir(folder)
        .env("SHELL", "/bin/sh")
        .env("TERM", "xterm-256color")
        .env_remove("STRAINSITE_DB")
        .stdin(Stdio::null());
    for name in CHOICES {
        script.env_remove(name);
    }
    let ran = script.envs(choice.iter().copied()).output();
    let ran = ran.expect("Debian's bsdutils has script, which makes a terminal");
    text(&ran.stdout).replace("\r\n", "\n")
}

fn piped(folder: &Path, arguments: &[&str], choice: &[(&str, &str)]) -> (String, String) {
    let mut command = crate::program::command(folder, arguments);
    for name in CHOICES {
        command.env_remove(name);
    }
    let ran = command.envs(choice.iter().copied()).output();
    let ran = ran.expect("the program runs");
    (text(&ran.stdout).to_owned(), text(&ran.stderr).to_owned())
}

/// Sweeps a table of every kind: a design with a result, and one without.
fn swept(folder: &Path) -> String {
    let study = draft(folder);
    let grid = "carcass.stiffness_n_per_mm=1,100,120";
    let ran = strainsite(folder, &["sweep", study, "--grid", grid, "--json", "-"]);
    assert_eq!(ran.status.code(), Some(3), "{}", text(&ran.stderr));
    let document: serde_json::Value = serde_json::from_slice(&ran.stdout).expect("JSON");
    document["sweep"]["id"].as_str().expect("an id").to_owned()
}

fn own_model(folder: &Path) {
    let inputs = "[[inputs]]\nname = \"a\"\ndistribution = { kind = \"uniform\", min = 0, max = 1 }\n\
                  [[inputs]]\nname = \"depth\"\ndistribution = { kind = \"uniform\", min = -1, max = 1 }\n";
    std::fs::write(folder.join("inputs.toml"), inputs).expect("writes");
    let planned = strainsite(folder, &["gsa", "plan", "inputs.toml"]);
    let values: String = text(&planned.stdout)
        .lines()
        .skip(1)
        .map(|line| {
            let x: Vec<f64> = line
                .split(',')
                .filter_map(|cell| cell.parse().ok())
                .collect();
            format!("{},{}\n", x[0], x[1] + x[2])
        })
        .collect();
    std::fs::write(folder.join("values.csv"), "id,y\n".to_owned() + &values).expect("writes");
}

#[test]
fn tables_are_painted_on_a_terminal_alone_and_their_columns_stay_where_they_are() {
    let folder = tempfile::tempdir().expect("temp dir");
    let folder = folder.path();
    let sweep = swept(folder);
    own_model(folder);
    let (listed, _) = piped(folder, &["list", "--state", "done"], &[]);
    let done = listed.split(' ').next().expect("an id").to_owned();
    for (arguments, painted) in [
        (
            &["compare", &sweep][..],
            &[
                "\u{1b}[1mdesign",
                "\u{1b}[31mfailed\u{1b}[0m ",
                "\u{1b}[32mdone\u{1b}[0m  ",
            ][..],
        ),
        (
            &["show", &done],
            &[
                "\u{1b}[1mrank",
                "\u{1b}[2muncertain\u{1b}[0m",
                "\u{1b}[32mdone",
            ],
        ),
        (
            &["gsa", "analyse", "inputs.toml", "values.csv"],
            &["\u{1b}[1m  input"],
        ),
        (
            &[
                "sweep",
                "draft.toml",
                "--dry-run",
                "--grid",
                "geometry.wall_mm=2.5",
            ],
            &["\u{1b}[1mfoot tire"],
        ),
        (&["db", "check"], &["\u{1b}[32mevery row"]),
        (&["show", "none"], &["\u{1b}[31mthere is no study"]),
        (
            &["validate", "values.csv"],
            &["\u{1b}[31mnot well-formed TOML"],
        ),
    ] {
        let seen = on_terminal(folder, arguments, &[]);
        for piece in painted {
            assert!(seen.contains(piece), "{arguments:?} {piece:?} {seen:?}");
        }
        let (out, err) = piped(folder, arguments, &[]);
        assert!(
            !(out.clone() + &err).contains('\u{1b}'),
            "{arguments:?} {out} {err}"
        );
        let plain = strip_str(&seen).to_string();
        let told = plain.strip_prefix(HEAD_OF_LIST).unwrap_or(&plain);
        assert_eq!(told, out + &err, "{arguments:?}");

        let unpainted = on_terminal(folder, arguments, &[("NO_COLOR", "1")]);
        assert_eq!(unpainted, plain, "{arguments:?}");
    }
}

/// Head of a list, which only people need: scripts take a line for a study.
const HEAD_OF_LIST: &str = "study                                 state      points            created                   name\n";

#[test]
fn a_list_has_a_header_for_people_alone() {
    let folder = tempfile::tempdir().expect("temp dir");
    let folder = folder.path();
    let sweep = swept(folder);
    let seen = on_terminal(folder, &["list"], &[]);
    let lines: Vec<&str> = seen.lines().collect();
    assert_eq!(strip_str(lines[0]).to_string() + "\n", HEAD_OF_LIST);
    // Each column begins below its head.
    let column = |head: &str| HEAD_OF_LIST.find(head).expect("a head");
    for line in &lines[1..] {
        let plain = strip_str(line).to_string();
        let at = |head: &str| plain.get(column(head)..).unwrap_or_default().to_owned();
        assert!(
            at("state").starts_with("done ") || at("state").starts_with("failed "),
            "{plain}"
        );
        assert!(at("created").starts_with("20"), "{plain}");
        assert!(at("name").starts_with("foot tire"), "{plain}");
    }
    assert_eq!(lines.len(), 4);

    // Who asks for paint gets it in a pipe too, but never in a document.
    let force = [("CLICOLOR_FORCE", "1")];
    let (out, _) = piped(folder, &["list"], &force);
    assert!(
        out.contains("\u{1b}[31mfailed") && !out.contains("created"),
        "{out}"
    );
    let both = [("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")];
    assert!(!piped(folder, &["list"], &both).0.contains('\u{1b}'));
    let compare = ["compare", &sweep, "--json", "-"];
    let (document, told) = piped(folder, &compare, &force);
    assert!(told.contains('\u{1b}'), "{told}");
    assert_eq!(document, piped(folder, &compare, &[]).0);
}

#[test]
fn a_study_on_a_terminal_shows_how_long_it_still_takes() {
    let folder = tempfile::tempdir().expect("temp dir");
    let study = draft(folder.path());
    let seen = on_terminal(folder.path(), &["run", study, "--threads", "1"], &[]);
    assert!(
        seen.contains("/26 points, ") && seen.contains(" to go"),
        "{seen}"
    );
    assert!(seen.contains("\u{1b}[1mrank  location"), "{seen}");
    let (out, err) = piped(folder.path(), &["run", study], &[]);
    assert!(!out.contains('\u{1b}') && err.is_empty(), "{out} {err}");
}
