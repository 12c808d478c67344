//! Examples of the documents of sweeps and comparisons. A test reads each back as the type that it is an example of.

use serde_json::{Value, json};

use crate::wire::examples::{
    estimate as study_estimate, study, study_toml, summary as study_summary,
};

const ID: &str = "019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6c";

/// A study with two walls.
pub fn document() -> Value {
    json!({"name": "two walls", "study": study(), "grid": {"geometry.wall_mm": [2.5, 3]}})
}

/// A study with two walls, as TOML.
pub fn document_toml() -> String {
    let study = study_toml()
        .replace("[[inputs]]", "[[study.inputs]]")
        .replace("[method]", "[study.method]")
        .replace("[accuracy]", "[study.accuracy]");
    format!("[grid]\n\"geometry.wall_mm\" = [2.5, 3]\n[study]\n{study}")
}

/// Further designs.
pub fn further() -> Value {
    json!({"designs": [{"name": "thick", "set": {"geometry.wall_mm": 3.5}}]})
}

/// A sweep at work.
pub fn summary() -> Value {
    json!({
        "id": ID, "name": "two walls", "state": "running", "counts": {"queued": 1, "running": 1, "done": 0, "failed": 0, "cancelled": 0},
        "points_total": null, "points_done": 4, "priority": 0, "created": "2026-11-22T01:02:03.456Z", "finished": null, "archived": null,
    })
}

/// A sweep with its designs.
pub fn detail() -> Value {
    let mut detail = summary();
    detail["document"] = study();
    let design = |ordinal: usize, wall: f64| json!({"ordinal": ordinal, "name": format!("wall_mm = {wall}"), "set": {"geometry.wall_mm": wall}, "study": study_summary()});
    detail["designs"] = json!([design(0, 2.5), design(1, 3.0)]);
    detail
}

/// What it is expected to take.
pub fn estimate() -> Value {
    json!({
        "designs": [{"name": "wall_mm = 2.5", "estimate": study_estimate()}], "left": {"least": 10, "expected": 10, "most": 10},
        "wall_s": {"least": 0.06, "expected": 0.18, "most": 0.54}, "peak_memory_bytes": 36_000_000,
    })
}

/// Two designs beside each other.
pub fn comparison() -> Value {
    let index = |percent: f64, difference: Option<f64>| {
        json!({
            "gsi_percent": percent, "error_percent": 2.9, "difference_percent": difference,
            "difference_error_percent": difference.map(|_| 0.8), "verdict": difference.map(|_| "real"),
        })
    };
    let row = |study: &str, x: Value, y: Value, change: Option<i64>| {
        json!({
            "study": study, "location": "P3", "rank": 1, "rank_certain": true, "rank_change": change, "rank_verdict": null, "x": x, "y": y,
        })
    };
    let study = |id: &str, wall: f64| {
        json!({
            "id": id, "name": format!("wall_mm = {wall}"), "set": {"geometry.wall_mm": wall}, "state": "done", "reason": null,
            "spec_sha256": "af5570f5a1810b7af78caf4bc70a660f0df51e42baf91d4de5b2328de0e83dfc", "version": "strainsite 0.1.0", "level": "standard",
            "reaction_n": 13.1, "std_strain_x": 0.0019, "std_strain_y": 0.0079, "best": "P3", "best_certain": true,
            "layout_spacing_deg": 30.0, "layout_position": "crown", "cost": null,
        })
    };
    json!({
        "baseline": ID, "studies": [study(ID, 3.0), study("019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6d", 2.5)],
        "rows": [row(ID, index(72.9, None), index(55.3, None), None),
                 row("019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6d", index(75.2, Some(2.3)), index(57.0, Some(1.7)), Some(0))],
        "notes": [],
    })
}

/// The beginning of a comparison's locations as CSV.
pub fn comparison_csv() -> &'static str {
    "study,name,geometry.wall_mm,location,rank,rank_certain\n019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6c,wall_mm = 3,3,P3,1,true\n"
}

#[cfg(test)]
mod tests {
    use fem_client::document::{Format, parse};
    use placement::compare::Comparison;
    use placement::sweep::{Sweep, designs_of};
    use serde::de::DeserializeOwned;

    use super::super::sweep_wire;
    use super::*;

    fn reads<T: DeserializeOwned>(example: Value) {
        serde_json::from_value::<T>(example.clone())
            .unwrap_or_else(|error| panic!("{}: {error}: {example}", std::any::type_name::<T>()));
    }

    #[test]
    fn examples_are_of_their_types() {
        reads::<sweep_wire::SweepDocument>(document());
        reads::<sweep_wire::FurtherDesigns>(further());
        reads::<sweep_wire::SweepSummary>(summary());
        reads::<sweep_wire::SweepDetail>(detail());
        reads::<sweep_wire::SweepEstimate>(estimate());
        reads::<Comparison>(comparison());
    }

    #[test]
    fn the_example_sweeps_are_valid_and_the_same() {
        let refuse = |path: &str| Err(path.to_owned());
        let mut toml = parse(&document_toml(), Format::Toml).expect("is TOML");
        toml["name"] = "two walls".into();
        let read = |value: &Value| Sweep::from_value(value, &refuse).expect("a valid sweep");
        let sweep = read(&document());
        assert_eq!(read(&toml), sweep);
        assert_eq!(designs_of(&sweep.base, &further()).expect("valid").len(), 1);
    }
}
