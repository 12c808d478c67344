//! `strainsite force`: from recordings to a model, from a model to estimates.

use std::path::Path;

use serde_json::Value;

use crate::program::{strainsite, text};

mod files;
mod looks;
mod streams;

/// A recipe that takes a second.
const RECIPE: &str = "[columns]\nblock_s = 2\n[features]\nsets = [\"raw\"]\n[models]\nkinds = [\"ridge\", \"gpr\"]\ngpr = { restarts = 2, search_rows = 60 }\n";

/// A made-up press: two signals of a force, with offset and gains of the session, and noise. Every fifth row has no force.
fn recording(session: f64) -> String {
    recording_every(0.05, session)
}

/// Returns the recording with a row every so many seconds.
fn recording_every(interval_s: f64, session: f64) -> String {
    recording_of(300, interval_s, session)
}

/// Returns so many rows of the recording.
fn recording_of(count: u32, interval_s: f64, session: f64) -> String {
    let mut rows = "time_s,a,\"b, V\",fz_n\n".to_owned();
    for row in 0..count {
        let t = f64::from(row) * interval_s;
        let force = 5.0 * (0.9 * t).sin().powi(2) * (1.0 + 0.3 * (0.21 * t + session).sin());
        // None in the first row, which is taken off all others.
        let noise = |k: f64| 0.03 * (f64::from(row * row) * k * (1.0 + 0.1 * session)).sin();
        let gain = 1.0 + 0.02 * (2.0 * session).cos();
        let cell = if row % 5 == 4 {
            String::new()
        } else {
            format!("{force:?}")
        };
        let (a, b) = (
            session + gain * force + noise(7.7),
            0.3 * force * force / gain + noise(9.1),
        );
        rows.push_str(&format!("{t:?},{a:?},{b:?},{cell}\n"));
    }
    rows
}

fn write(folder: &Path, files: &[(&str, &str)]) {
    for (name, content) in files {
        std::fs::write(folder.join(name), content).expect("writes");
    }
}

fn fitted(folder: &Path) -> Value {
    fitted_with(folder, "")
}

/// Learns by the recipe with more at its end.
fn fitted_with(folder: &Path, more: &str) -> Value {
    write(
        folder,
        &[
            ("recipe.toml", &format!("{RECIPE}{more}")),
            ("one.csv", &recording(1.0)),
            ("two.csv", &recording(2.0)),
            ("three.csv", &recording(3.0)),
            ("new.csv", &recording(4.0)),
        ],
    );
    let arguments = [
        "force",
        "fit",
        "recipe.toml",
        "one.csv",
        "two.csv",
        "-o",
        "model.json",
        "--json",
        "-",
    ];
    let fit = strainsite(folder, &arguments);
    assert_eq!(fit.status.code(), Some(0), "{}", text(&fit.stderr));
    serde_json::from_str(text(&fit.stdout)).expect("one JSON document")
}
