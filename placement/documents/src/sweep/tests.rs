use serde_json::json;

use super::*;
use crate::study::plan::Plan;
use crate::study::presets;
use document::{Format, parse};

fn document(rest: Value) -> Value {
    let mut document = json!({"study": parse(presets()[0].1, Format::Toml).unwrap()});
    let members = rest.as_object().unwrap().clone();
    document.as_object_mut().unwrap().extend(members);
    document
}

fn read(rest: Value) -> Result<Sweep, Vec<Fault>> {
    Sweep::from_value(
        &document(rest),
        MOST_SUBMITTED,
        &|path| Err(path.to_owned()),
    )
}

fn faults(rest: Value) -> Vec<(String, String)> {
    let faults = read(rest).unwrap_err();
    let pair = |fault: Fault| (fault.pointer, fault.detail);
    faults.into_iter().map(pair).collect()
}

#[test]
fn a_grid_is_every_combination_and_nothing_else_changes() {
    let grid = json!({"geometry.wall_mm": [2.5, 3], "scene.carcass.angle_deg": [50, 55, 60]});
    let sweep = read(json!({"name": "wall and cord", "grid": grid})).unwrap();
    assert_eq!(
        (sweep.name.as_str(), sweep.designs.len()),
        ("wall and cord", 6)
    );
    let names: Vec<&str> = sweep
        .designs
        .iter()
        .map(|design| design.name.as_str())
        .collect();
    assert_eq!(names[1], "wall_mm = 2.5, angle_deg = 55");
    assert_eq!(names[3], "wall_mm = 3, angle_deg = 50");
    let fourth = &sweep.designs[3].study;
    assert!(fourth.name.ends_with(": wall_mm = 3, angle_deg = 50"));
    let mut expected = sweep.base.clone();
    expected.name.clone_from(&fourth.name);
    expected.scene.set("carcass.angle_deg", &json!(50)).unwrap();
    assert_eq!(*fourth, expected, "3 mm is the base's wall");
}

#[test]
fn designs_may_set_fields_of_the_study_too() {
    let designs = json!([
        {"name": "as it is", "set": {}},
        {"set": {"method.nodes": 7, "accuracy.tolerance": 0.1}},
        {"set": {"ground.depths_mm": [1.0, 1.0, 1.0], "inputs": [
            {"name": "a", "vary": "ground.depths_mm[1]", "distribution": {"kind": "uniform", "min": 0.7, "max": 1.3}}]}},
    ]);
    let sweep = read(json!({"designs": designs})).unwrap();
    assert_eq!(sweep.name, sweep.base.name);
    let [plain, other, three] = &sweep.designs[..] else {
        panic!("three designs")
    };
    assert_eq!(plain.name, "as it is");
    assert_eq!(other.name, "nodes = 7, tolerance = 0.1");
    assert_eq!(other.study.method.nodes, 7);
    assert_eq!(other.study.accuracy, crate::study::Accuracy::Tolerance(0.1));
    assert_eq!(
        (three.study.scene.ground.stations, three.study.inputs.len()),
        (3, 1)
    );
}

#[test]
fn every_table_of_a_study_can_be_set() {
    let sweep = read(json!({"grid": {"question.films": [12, 24]}})).unwrap();
    let asked = sweep
        .designs
        .iter()
        .map(|design| design.study.question.films);
    assert_eq!(asked.collect::<Vec<_>>(), [Some(12), Some(24)]);
}

#[test]
fn further_designs_are_read_alone() {
    let sweep = read(json!({"grid": {"geometry.wall_mm": [3]}})).unwrap();
    let further = json!({"grid": {"geometry.wall_mm": [2.5]}});
    let designs = designs_of(&sweep.base, &further, MOST_SUBMITTED).unwrap();
    assert_eq!(designs[0].study.scene.geometry.wall_mm, 2.5);
}

#[test]
fn all_faults_are_told_at_once_of_the_values_that_made_them() {
    let found = faults(json!({"grid": {
        "geometry.wall_mm": [2.5, -1, "thick"], "carcass.angle_deg": [50, 500], "geometry.walls_mm": [1], "model.level": ["draft"]}}));
    let at = |pointer: &str| found.iter().filter(|(p, _)| p == pointer).count();
    for pointer in [
        "/grid/geometry.wall_mm/1",
        "/grid/geometry.wall_mm/2",
        "/grid/carcass.angle_deg/1",
        "/grid/geometry.walls_mm/0",
        "/grid/model.level/0",
    ] {
        assert_eq!(at(pointer), 1, "{pointer} {found:?}");
    }
    assert_eq!(found.len(), 5, "{found:?}");
}

#[test]
fn what_is_no_sweep_is_refused() {
    for (rest, pointer) in [
        (json!({}), ""),
        (json!({"grid": {}}), "/grid"),
        (
            json!({"grid": {"geometry.wall_mm": 3}}),
            "/grid/geometry.wall_mm",
        ),
        (json!({"grid": {"geometry.wall_mm": [3, 3.0]}}), "/grid"),
        (json!({"designs": []}), "/designs"),
        (json!({"designs": [{"set": 3}]}), "/designs/0/set"),
        (
            json!({"designs": [{"name": " ", "set": {}}]}),
            "/designs/0/name",
        ),
        (json!({"designs": [{"set": {}}], "grid": {"a": [1]}}), ""),
        (json!({"designs": [{"set": {"a b": 1}}]}), "/designs/0"),
        (
            json!({"designs": [{"set": {"geometry.wall_mm": 2.0}}], "name": 3}),
            "/name",
        ),
    ] {
        let found = faults(rest.clone());
        assert_eq!(found[0].0, pointer, "{rest} {found:?}");
    }
    let many: Vec<u32> = (0..101).collect();
    let found =
        faults(json!({"grid": {"geometry.wall_mm": many, "geometry.outer_radius_mm": many}}));
    assert!(found[0].1.contains("more than 10000 designs"), "{found:?}");
}

#[test]
fn a_design_sets_a_field_once_and_leaves_the_mesh_to_the_accuracy() {
    let found = faults(json!({"grid": {"geometry.wall_mm": [2], "scene.geometry.wall_mm": [2.5]}}));
    assert_eq!(found[0].0, "/grid/scene.geometry.wall_mm", "{found:?}");
    let set = json!({"carcass.angle_deg": 50, " scene.carcass.angle_deg": 55});
    let found = faults(json!({"designs": [{"set": set}]}));
    assert_eq!(
        found[0].0, "/designs/0/set/ scene.carcass.angle_deg",
        "{found:?}"
    );
    let found = faults(json!({"designs": [{"set": {"model": {"level": "draft"}}}]}));
    assert_eq!(found[0].0, "/designs/0/set/model", "{found:?}");
    assert!(found[0].1.contains("accuracy.preset"), "{found:?}");
}

#[test]
fn what_a_design_sets_can_not_move_a_terminal_s_cursor() {
    let found = faults(json!({"designs": [{"set": {"wall\u{9b}2J": "\n"}}]}));
    assert!(!found[0].1.contains(char::is_control), "{found:?}");
    let input = |name: &str, station: usize| {
        json!({"name": name.repeat(50), "vary": format!("ground.depths_mm[{station}]"),
            "distribution": {"kind": "uniform", "min": 0.7, "max": 1.3}})
    };
    let long = json!({"inputs": [input("a", 0), input("b", 1)]});
    let sweep = read(json!({"designs": [{"set": long}]})).unwrap();
    assert_eq!(sweep.designs[0].name.chars().count(), LONGEST_NAME);
}

#[test]
fn what_would_take_too_much_is_refused_before_it_is_made() {
    let many: Map<String, Value> = (0..50_000)
        .map(|number| (format!("a{number}.b"), json!([1])))
        .collect();
    let found = faults(json!({"grid": many}));
    assert!(found[0].1.contains("at most 100 values"), "{found:?}");
    let set: Map<String, Value> = (0..50_000)
        .map(|number| (format!("a{number}.b"), json!(1)))
        .collect();
    let found = faults(json!({"designs": [{"set": set}]}));
    assert_eq!(found[0].0, "/designs/0/set", "{found:?}");

    let walls: Vec<f64> = (0..1000)
        .map(|number| 2.0 + 1e-3 * f64::from(number))
        .collect();
    let large = "x".repeat(10_000);
    let found = faults(json!({"grid": {"geometry.wall_mm": walls, "candidates": [large]}}));
    assert!(found[0].1.contains("bytes together"), "{found:?}");
    let method = json!({"kind": "saltelli", "samples": 1000});
    let found = faults(json!({"grid": {"geometry.wall_mm": walls, "method": [method]}}));
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].1.contains("more than 400000 solves"), "{found:?}");
    // As many designs as there may be of the paper's study aren't too much.
    let base = read(json!({"grid": {"geometry.wall_mm": [2]}}))
        .unwrap()
        .base;
    assert!(base.method.first_points(base.inputs.len()) <= MOST_SOLVES_EACH);
}

#[test]
fn a_study_is_changed_as_a_design_is_and_its_name_says_how() {
    let base = read(json!({"grid": {"geometry.wall_mm": [2]}}))
        .unwrap()
        .base;
    let planned = PlannedStudy::new(base.clone()).unwrap();
    let set = |value: Value| changed(planned.clone(), value.as_object().unwrap().clone());
    assert_eq!(set(json!({})).unwrap(), planned);
    let changed = set(json!({"geometry.wall_mm": 2.5, "method.nodes": 3})).unwrap();
    let study = changed.study;
    assert_eq!(changed.plan, Plan::new(&study).unwrap());
    assert_eq!(study.method.nodes, 3);
    let name = format!(
        "{} · scene.geometry.wall_mm = 2.5, method.nodes = 3",
        base.name
    );
    assert_eq!(study.name, name);
    let long = set(json!({"scene.geometry.wall_mm": 2.5, "accuracy.preset": "draft"})).unwrap();
    assert!(
        long.study
            .name
            .ends_with("scene.geometry.wall_mm = 2.5, accuracy.preset = draft")
    );
    let mut scene = base.scene.clone();
    scene.set("geometry.wall_mm", &json!(2.5)).unwrap();
    assert_eq!(study.scene, scene);
    let faults = set(json!({"geometry.wal_mm": 2.5, "method.nodes": 0})).unwrap_err();
    let pointers: Vec<&str> = faults.iter().map(|fault| fault.pointer.as_str()).collect();
    assert_eq!(pointers.len(), 1, "{faults:?}");
    assert_eq!(pointers, ["/set/geometry.wal_mm"]);

    let named = set(json!({"name": "thin wall", "geometry.wall_mm": 2.5})).unwrap();
    assert_eq!(named.study.name, "thin wall");
    assert_eq!(
        named.plan,
        set(json!({"geometry.wall_mm": 2.5})).unwrap().plan
    );
    assert_eq!(set(json!({"name": "alone"})).unwrap().study.name, "alone");
    let faults = set(json!({"name": 1, "geometry.wal_mm": 2.5})).unwrap_err();
    let pointers: Vec<&str> = faults.iter().map(|fault| fault.pointer.as_str()).collect();
    assert_eq!(pointers, ["/set/name", "/set/geometry.wal_mm"]);
}
