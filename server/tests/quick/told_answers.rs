//! Answers that `run` gives first, and that all of it fits.

use serde_json::Value;

use crate::cli::{REPOSITORY, draft};
use crate::program::{strainsite, text};

/// Columns of everything that is printed.
const COLUMNS: usize = 100;
/// Studies that ship, with what makes them small: a rough mesh, fewer layouts and films. Every column and every note stays.
const SHIPPED: [(&str, &[&str]); 4] = [
    ("foot-tire", &[]),
    ("foot-tire-paper", &[]),
    (
        "layouts",
        &[
            "layouts.units=[6,24]",
            "layouts.search={\"films\":[3],\"slots\":12}",
        ],
    ),
    (
        "placement",
        &[
            "signals.loads_n=[5,10]",
            "signals.pressures_mpa=[0.2]",
            "signals.contact_deg=[0,10]",
            "signals.films=[\"bare\"]",
            "signals.tires=[]",
        ],
    ),
];

/// A shipped study on the draft mesh.
fn run(folder: &std::path::Path, name: &str, set: &[&str]) -> std::process::Output {
    let set = ["accuracy.preset=draft"].iter().chain(set);
    let set: Vec<&str> = set.flat_map(|set| ["--set", set]).collect();
    let arguments = [&["run", name, "--json", "result.json"][..], &set].concat();
    let ran = strainsite(folder, &arguments);
    assert_eq!(ran.status.code(), Some(0), "{name}: {}", text(&ran.stderr));
    ran
}

fn result(folder: &std::path::Path) -> Value {
    let file = std::fs::read_to_string(folder.join("result.json")).expect("written");
    serde_json::from_str(&file).expect("JSON")
}

/// Lines put together again.
fn unwrapped(told: &str) -> String {
    told.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn every_shipped_study_is_answered_first_and_fits_a_hundred_columns() {
    let folder = tempfile::tempdir().expect("temp dir");
    for (name, set) in SHIPPED {
        let ran = run(folder.path(), name, set);
        let told = text(&ran.stdout);
        let long = told.lines().find(|line| line.chars().count() > COLUMNS);
        assert_eq!(long, None, "{name}");
        let answer = &result(folder.path())["answer"];
        let word = |field: &str| answer[field].as_str().expect("a text").to_owned();
        let (sentence, reason) = (word("sentence"), word("reason"));
        let beside = answer["inputs"]["beside"].as_array().into_iter().flatten();
        let inputs = beside
            .map(|beside| format!("inputs: {} ", beside["sentence"].as_str().expect("a text")));
        let inputs: String = inputs.collect();
        let rests_on = answer["rests_on"]["sentence"].as_str();
        let rests_on = rests_on.map(|told| format!("rests on: {told} "));
        let rests_on = rests_on.unwrap_or_default();
        let first = format!(
            "{sentence} {}: {reason} {inputs}{rests_on}left out: ",
            word("verdict")
        );
        assert!(unwrapped(told).starts_with(&first), "{name}: {told}");
        assert!(sentence.starts_with(told.lines().next().expect("a line")));
        let surer = answer["surer"]["sentence"].as_str().expect("a text");
        assert!(
            unwrapped(told).contains(&format!("surer: {surer}")),
            "{name}: {told}"
        );
        assert_eq!(
            answer["verdict"], "unknown",
            "a draft knows no error: {name}"
        );
        assert!(
            told.contains("   2= P"),
            "{name}: shared ranks have a sign: {told}"
        );
    }
}

#[test]
fn a_note_is_told_once_under_what_it_does_to_the_answer() {
    let folder = tempfile::tempdir().expect("temp dir");
    let study = draft(folder.path());
    let ran = run(folder.path(), study, &[]);
    let told = unwrapped(text(&ran.stdout));
    let result = result(folder.path());
    let graded = result["graded_notes"].as_array().expect("a list");
    let texts: Vec<&Value> = graded.iter().map(|note| &note["text"]).collect();
    let notes: Vec<&Value> = result["notes"].as_array().expect("a list").iter().collect();
    assert_eq!(texts, notes);
    let place = |words: &str| {
        told.find(words)
            .unwrap_or_else(|| panic!("{words}: {told}"))
    };
    for note in graded {
        let words = note["text"].as_str().expect("a text");
        assert_eq!(told.matches(words).count(), 1, "{words}");
        let heading = match note["grade"].as_str() {
            Some("changes-answer") => "changes the answer",
            Some("bears-on-figure") => "bears on a figure",
            _ => "for the record",
        };
        assert!(place(heading) < place(words), "{words}");
    }
    let mirrored = graded.iter().find(|note| {
        note["text"]
            .as_str()
            .is_some_and(|text| text.contains("mirror images"))
    });
    assert_eq!(mirrored.expect("P2 and P4")["grade"], "for-the-record");
}

#[test]
fn a_changed_study_is_named_by_what_differs_unless_it_is_given_a_name() {
    let folder = tempfile::tempdir().expect("temp dir");
    let name = |set: &[&str]| {
        let set: Vec<&str> = set.iter().flat_map(|set| ["--set", set]).collect();
        let arguments = [&["run", "foot-tire", "--dry-run"][..], &set].concat();
        let ran = strainsite(folder.path(), &arguments);
        assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
        text(&ran.stdout).lines().next().expect("a name").to_owned()
    };
    let shipped = "foot tire, five contact depths, 1 mm +-30 %";
    assert_eq!(name(&[]), shipped);
    assert_eq!(
        name(&["geometry.wall_mm=5"]),
        format!("{shipped} · scene.geometry.wall_mm = 5")
    );
    assert_eq!(
        name(&["geometry.wall_mm=5", "name=thick wall"]),
        "thick wall"
    );
}

#[test]
fn a_name_that_is_nearly_right_is_put_right() {
    let folder = tempfile::tempdir().expect("temp dir");
    draft(folder.path());
    for (arguments, meant) in [
        (&["run", "drafft.toml"][..], "Did you mean draft.toml?"),
        (
            &["run", "foot-tyre"],
            "Did you mean foot-tire, which ships?",
        ),
        (
            &["solve", "foot-tire-sofd"],
            "Did you mean foot-tire-soft, which ships?",
        ),
        (&["runn", "foot-tire"], "'run'"),
        (&["db", "chek"], "'check'"),
    ] {
        let refused = strainsite(folder.path(), arguments);
        assert_eq!(refused.status.code(), Some(2), "{arguments:?}");
        let said = text(&refused.stderr);
        assert!(said.contains(meant), "{arguments:?}: {said}");
    }
    let far = strainsite(folder.path(), &["run", "quite-another-thing"]);
    assert!(text(&far.stderr).contains("what ships can be named without a file: foot-tire"));
    let all = strainsite(folder.path(), &["presets"]);
    for entry in std::fs::read_dir(format!("{REPOSITORY}/studies")).expect("the folder ships") {
        let path = entry.expect("an entry").path();
        if path.extension().is_none_or(|kind| kind != "toml") {
            continue;
        }
        let name = path
            .file_stem()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        assert!(
            text(&all.stdout)
                .lines()
                .any(|line| line.starts_with(&name)),
            "{name}"
        );
    }
}
