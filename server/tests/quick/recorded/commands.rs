//! Commands: their help, what they tell people, and what they write.

use std::fmt::Write as _;
use std::path::Path;

use super::compare;
use super::redaction::Redaction;
use crate::program::{command, strainsite, text};

const STUDY: &str = "name = \"two depths\"\nscene = { preset = \"foot-tire\" }\n\
    [[inputs]]\nname = \"P2\"\nvary = \"ground.depths_mm[1]\"\ndistribution = { kind = \"uniform\", min = 0.7, max = 1.3 }\n\
    [[inputs]]\nname = \"P3\"\nvary = \"ground.depths_mm[2]\"\ndistribution = { kind = \"uniform\", min = 0.7, max = 1.3 }\n\
    [method]\nkind = \"mdrm\"\nnodes = 3\ncheck_points = 2\n[accuracy]\npreset = \"draft\"\n\
    [layouts]\nspacings_deg = [60]\npositions = [\"crown\"]\n";
const INPUTS: &str = "[[inputs]]\nname = \"a\"\ndistribution = { kind = \"uniform\", min = 0, max = 1 }\n\
    [[inputs]]\nname = \"b\"\ndistribution = { kind = \"uniform\", min = -1, max = 1 }\n";

/// Commands in a folder, with what they told.
struct Terminal<'f> {
    folder: &'f Path,
    redaction: Redaction,
    record: String,
}

impl Terminal<'_> {
    /// Runs a command, records what it told, and returns its standard output.
    fn run(&mut self, arguments: &[&str]) -> String {
        let ran = strainsite(self.folder, arguments);
        let (out, err) = (text(&ran.stdout), text(&ran.stderr));
        let line = self.redaction.text(&arguments.join(" "));
        let code = ran.status.code().expect("ends by itself");
        writeln!(self.record, "## {line}\ncode {code}").expect("writes");
        let is_csv = out
            .lines()
            .next()
            .is_some_and(|line| line.split(',').count() > 2 && !line.contains(' '));
        self.record += &match is_csv {
            true => self.redaction.csv(out),
            false => self.redaction.told(out),
        };
        if !err.is_empty() {
            self.record += "to standard error:\n";
            self.record += &self.redaction.told(err);
        }
        self.record += "\n";
        out.to_owned()
    }

    /// Runs a command that writes JSON, and records that.
    fn json(&mut self, arguments: &[&str]) -> serde_json::Value {
        let ran = strainsite(self.folder, &[arguments, &["--json", "-"]].concat());
        let document = serde_json::from_slice(&ran.stdout).expect("one JSON document");
        let line = self.redaction.text(&arguments.join(" "));
        let shown = self.redaction.json(&document, 3);
        writeln!(self.record, "## {line} --json -\n{shown}\n").expect("writes");
        document
    }

    /// Help of a command and of those below it.
    fn help(&mut self, of: &[String]) {
        let help = command(self.folder, &[]).args(of).arg("--help").output();
        let help = help.expect("the program runs");
        let help = text(&help.stdout);
        let told: Vec<&str> = help.lines().map(str::trim_end).collect();
        writeln!(
            self.record,
            "## {} --help\n{}\n",
            of.join(" "),
            told.join("\n")
        )
        .expect("writes");
        let commands = told.iter().skip_while(|line| **line != "Commands:");
        for line in commands.skip(1).take_while(|line| !line.is_empty()) {
            let name = line.trim_start().split(' ').next().expect("a name");
            if name != "help" {
                self.help(&[of, &[name.to_owned()]].concat());
            }
        }
    }
}

fn terminal(folder: &Path) -> Terminal<'_> {
    Terminal {
        folder,
        redaction: Redaction::default(),
        record: String::new(),
    }
}

#[test]
fn help_is_as_recorded() {
    let folder = tempfile::tempdir().expect("temp dir");
    let mut terminal = terminal(folder.path());
    terminal.help(&[]);
    compare("help", &terminal.record);
}

#[test]
fn a_study_is_told_as_recorded() {
    let folder = tempfile::tempdir().expect("temp dir");
    std::fs::write(folder.path().join("study.toml"), STUDY).expect("writes");
    let mut terminal = terminal(folder.path());
    let two = ["--threads", "2"];
    terminal.run(&["validate", "study.toml"]);
    terminal.run(&[&["run", "study.toml", "--dry-run"], &two[..]].concat());
    terminal.run(&[&["run", "study.toml"], &two[..]].concat());
    let listed = terminal.json(&["list"]);
    let id = listed["studies"][0]["id"].as_str().expect("an id");
    terminal.run(&["list"]);
    terminal.json(&["show", id]);
    for table in ["indices", "locations", "layouts", "points", "candidates"] {
        terminal.run(&["export", id, "--table", table]);
    }
    terminal.json(&["db", "check"]);
    terminal.run(&["db", "check"]);
    terminal.run(&["db", "backup", "copy.db"]);
    terminal.run(&["db", "prune", "--older-than", "1h"]);
    compare("study-commands", &terminal.record);
}

#[test]
fn a_sweep_is_told_as_recorded() {
    let folder = tempfile::tempdir().expect("temp dir");
    std::fs::write(folder.path().join("study.toml"), STUDY).expect("writes");
    let mut terminal = terminal(folder.path());
    let sweep = [
        "sweep",
        "study.toml",
        "--threads",
        "2",
        "--name",
        "walls",
        "--grid",
        "geometry.wall_mm=2.5,3",
    ];
    terminal.run(&[&sweep[..], &["--dry-run"]].concat());
    terminal.run(&sweep);
    let listed = terminal.json(&["list", "--sweeps"]);
    let id = listed["sweeps"][0]["id"].as_str().expect("an id");
    terminal.run(&["list", "--sweeps"]);
    terminal.json(&["compare", id]);
    for table in ["locations", "designs"] {
        terminal.run(&["compare", id, "--format", "csv", "--table", table]);
    }
    compare("sweep-commands", &terminal.record);
}

#[test]
fn other_commands_are_told_as_recorded() {
    let folder = tempfile::tempdir().expect("temp dir");
    std::fs::write(folder.path().join("inputs.toml"), INPUTS).expect("writes");
    let mut terminal = terminal(folder.path());
    let planned = terminal.run(&["gsa", "plan", "inputs.toml"]);
    let values = planned.lines().skip(1).map(|line| {
        let cells: Vec<f64> = line
            .split(',')
            .filter_map(|cell| cell.parse().ok())
            .collect();
        let (a, b) = (cells[1], cells[2]);
        format!("{},{}\n", cells[0], a * b + a + b.powi(3))
    });
    let values = "id,y\n".to_owned() + &values.collect::<String>();
    std::fs::write(folder.path().join("values.csv"), values).expect("writes");
    terminal.run(&["gsa", "analyse", "inputs.toml", "values.csv"]);
    terminal.json(&["gsa", "analyse", "inputs.toml", "values.csv"]);
    terminal.run(&["presets"]);
    let scene = ["solve", "foot-tire", "--set", "model.level=draft"];
    terminal.run(&scene);
    terminal.json(&scene);
    compare("other-commands", &terminal.record);
}
