//! What was estimated against what it takes: a program of its own, so that no other test shares the cores.

use crate::program::{strainsite, text};
use serde_json::Value;

/// Twice as long or half as long for a law that is right only on average, and as much again for other work that comes or goes on the machine between
/// the measurement and the run.
const WITHIN: f64 = 3.0;

#[test]
fn studies_take_what_was_estimated_on_a_machine_that_was_measured() {
    let folder = tempfile::tempdir().expect("temp dir");
    // Another study of the same kind measures the machine at its present load, on both meshes.
    let (_, shipped) = placement::study::presets()[0];
    let (spacings, one) = (
        "spacings_deg = [30, 45, 60, 72, 90, 120, 180]",
        "spacings_deg = [60]",
    );
    assert!(shipped.contains(spacings));
    let shipped = shipped.replace(spacings, one);
    let wall_s = |name: &str, level: &str, greatest: &str| {
        let study = shipped.replace("\"standard\"", &format!("\"{level}\""));
        let study = study.replace("max = 1.3", &format!("max = {greatest}"));
        std::fs::write(folder.path().join(name), study).expect("writes");
        let run = strainsite(folder.path(), &["run", name, "--json", "-"]);
        assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
        let result: Value = serde_json::from_slice(&run.stdout).expect("JSON");
        let taken = result["cost"]["wall_s"].as_f64().expect("a time");
        let expected = result["estimate"]["wall_s"]["expected"]
            .as_f64()
            .expect("a time");
        assert!(result["cost"]["reused"] == 0, "a point was known before");
        (taken, expected)
    };
    wall_s("before.toml", "coarse", "1.29");
    for level in ["draft", "coarse"] {
        // Medians of three, each with points of its own: a draft is over so soon that one pause of the machine doubles its time.
        let mut ratios = ["1.26", "1.27", "1.28"].map(|greatest| {
            let (taken, expected) = wall_s("study.toml", level, greatest);
            taken / expected
        });
        ratios.sort_by(f64::total_cmp);
        let middle = ratios[1];
        assert!(
            (1.0 / WITHIN..WITHIN).contains(&middle),
            "{level}: took {ratios:.2?} times what was expected"
        );
    }
}
