//! Accuracy that is asked for, and what it costs.

use serde_json::Value;

use super::draft;
use crate::program::{stored_trades, strainsite, text};

#[tokio::test]
async fn the_trade_is_measured_against_its_reference_and_kept() {
    let folder = tempfile::tempdir().expect("temp dir");
    let study = draft(folder.path());
    let arguments = [
        "trade",
        study,
        "--up-to",
        "draft",
        "--reference-level",
        "coarse",
    ];
    let more = [
        "--reference-method",
        "mdrm",
        "--out",
        "answer",
        "--json",
        "-",
    ];
    let output = strainsite(folder.path(), &[&arguments[..], &more[..]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let trade: Value = serde_json::from_slice(&output.stdout).expect("one JSON document");
    let rungs = trade["rungs"].as_array().expect("a list");
    assert_eq!(rungs.len(), 5);
    for rung in rungs {
        assert_eq!(rung["fidelity"]["level"], "draft");
        let (error, wall) = (rung["error_true"].as_f64(), rung["wall_s"].as_f64());
        // Between the two levels the indices of this study move by hundredths.
        assert!(error.is_some_and(|e| e > 0.0 && e < 0.2), "{rung}");
        assert!(wall.is_some_and(|s| s > 0.0), "{rung}");
    }
    assert!(rungs.iter().any(|rung| rung["pareto"] == true));
    assert_eq!(trade["reference"]["error_true"], 0.0);
    assert_eq!(trade["reference"]["solves"], 52);
    let read = |name: &str| {
        std::fs::read_to_string(folder.path().join("answer").join(name)).expect("written")
    };
    assert_eq!(read("trade.csv").lines().count(), 7);
    let plot = read("trade.svg");
    assert!(plot.starts_with("<svg") && plot.contains("draft mdrm 5") && !plot.contains("NaN"));
    let kept = stored_trades(&folder.path().join("strainsite.db")).await;
    assert_eq!(kept, 1);
}

#[test]
fn a_tolerance_is_met_by_the_cheapest_rung_that_claims_it() {
    let folder = tempfile::tempdir().expect("temp dir");
    let study = draft(folder.path());
    let path = folder.path().join(study);
    let document = std::fs::read_to_string(&path).expect("the study");
    let asking = document.replace("preset = \"draft\"", "tolerance = 0.3");
    assert_ne!(asking, document);
    std::fs::write(&path, asking).expect("written");
    let output = strainsite(folder.path(), &["run", study, "--json", "-"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let result: Value = serde_json::from_slice(&output.stdout).expect("one JSON document");
    let climb = &result["climb"];
    assert_eq!(climb["met"], true);
    assert_eq!(climb["rungs"][0]["fidelity"]["level"], "coarse");
    for output in result["outputs"].as_array().expect("a list") {
        let error = &output["error"];
        assert!(
            error["total"].as_f64().is_some_and(|total| total <= 0.3),
            "{error}"
        );
        assert!(error["mesh"].as_f64().is_some(), "{error}");
    }
    assert!(text(&output.stderr).contains("A tolerance of 0.3 is met"));
}
