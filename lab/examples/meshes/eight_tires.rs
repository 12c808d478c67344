//! The eight tires on which claims of the mesh are judged, and the mesh whose answers pass for true.

use document::Format;
use documents::study::Study;
use serde_json::{Value, json};
use tire::mesh::tire_grid::MeshPlan;

/// Depths that vary.
const INPUTS: usize = 5;

/// Returns a mesh that is finer in every direction than the finest level's, which it is made of.
pub fn finer(reference: MeshPlan) -> MeshPlan {
    MeshPlan {
        fine: 18,
        coarse: 7,
        meridional: 22,
        ..reference
    }
}

/// The eight tires, with the mean of the depths, mm.
pub fn tires() -> Vec<(&'static str, Value, f64)> {
    let shipped = |change: &str, value: Value| {
        let mut scene = json!({"preset": "foot-tire"});
        scene[change] = value;
        scene
    };
    let wall = |wall_mm: f64| shipped("geometry", json!({"wall_mm": wall_mm}));
    let ogden = json!({"model": "ogden", "terms": [{"mu_mpa": 0.36, "alpha": 2.0}, {"mu_mpa": 0.02, "alpha": -2.0}]});
    vec![
        ("shipped", json!({"preset": "foot-tire"}), 1.0),
        (
            "5 mm wall without cords",
            json!({"preset": "foot-tire-soft"}),
            1.5,
        ),
        ("1.5 mm wall", wall(1.5), 1.0),
        ("5 mm wall", wall(5.0), 1.0),
        (
            "100 mm radius",
            shipped("geometry", json!({"outer_radius_mm": 100.0})),
            1.0,
        ),
        (
            "0.05 MPa",
            shipped("pressure", json!({"internal_mpa": 0.05})),
            1.0,
        ),
        ("Ogden's law", shipped("material", ogden), 1.0),
        ("pressed 2 mm", json!({"preset": "foot-tire"}), 2.0),
    ]
}

/// Five depths that vary by 0.3 mm about a mean.
pub fn study(scene: Value, depth: f64) -> Result<Study, String> {
    let law = json!({"kind": "uniform", "min": depth - 0.3, "max": depth + 0.3});
    let input = |k: usize| json!({"name": format!("P{}", k + 1), "vary": format!("ground.depths_mm[{k}]"), "distribution": law});
    let document = json!({
        "name": "mesh", "scene": scene, "inputs": (0..INPUTS).map(input).collect::<Vec<_>>(), "layouts": {"spacings_deg": []},
        "method": {"kind": "mdrm", "nodes": 5}, "candidates": {"points": "P1-P5", "grid": {"circumferential": 31, "meridional": 11}},
    });
    let read = |path: &str| Err(format!("{path}: not needed"));
    Study::from_document(&document.to_string(), Format::Json, &read)
        .map_err(|faults| format!("{faults:?}"))
}
