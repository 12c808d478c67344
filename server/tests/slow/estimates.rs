//! Estimates against what the studies take.

use crate::program::{strainsite, text};
use serde_json::Value;

/// Twice as long or half as long for a law that is right only on average, and as much again for other work that comes or goes on the machine between
/// the measurement and the run.
const WITHIN: f64 = 3.0;
/// Other tests share the cores, and may come or go while one study runs; an estimate that is wrong is wrong every time.
const TRIES: usize = 5;

#[test]
fn studies_take_what_was_estimated_on_a_machine_that_was_measured() {
    let (_, shipped) = documents::study::presets()[0];
    let (menu, one) = ("[layouts]\n", "[layouts]\nspacings_deg = [60]\n");
    assert!(shipped.contains(menu));
    let shipped = shipped.replace(menu, one);
    for level in ["draft", "coarse"] {
        let mut ratios = Vec::new();
        while !ratios.last().is_some_and(is_within) {
            assert!(
                ratios.len() < TRIES,
                "{level}: took {ratios:.2?} times what was expected"
            );
            ratios.push(ratio(&shipped, level));
        }
    }
}

fn is_within(ratio: &f64) -> bool {
    (1.0 / WITHIN..WITHIN).contains(ratio)
}

/// Returns what a study takes over what it was expected to take, in a database where a coarse study of the same kind has measured the machine at its present
/// load.
fn ratio(shipped: &str, level: &str) -> f64 {
    let folder = tempfile::tempdir().expect("temp dir");
    let run = |level: &str, greatest: &str| {
        let study = shipped.replace("\"standard\"", &format!("\"{level}\""));
        let study = study.replace("max = 1.3", &format!("max = {greatest}"));
        std::fs::write(folder.path().join("study.toml"), study).expect("writes");
        let run = strainsite(folder.path(), &["run", "study.toml", "--json", "-"]);
        assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
        let result: Value = serde_json::from_slice(&run.stdout).expect("JSON");
        assert!(result["cost"]["reused"] == 0, "a point was known before");
        result
    };
    run("coarse", "1.29");
    let result = run(level, "1.28");
    let taken = result["cost"]["wall_s"].as_f64().expect("a time");
    let expected = &result["estimate"]["wall_s"]["expected"];
    taken / expected.as_f64().expect("a time")
}
