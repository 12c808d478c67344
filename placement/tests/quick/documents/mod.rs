//! Study documents: every fault at once, and no document that breaks the reader.

mod mutated;

use document::{Format, parse};
use documents::parts::distribution_reader::distribution_value;
use documents::study::{Accuracy, Study, presets};
use serde_json::{Value, json};

use crate::support::{shipped, study};

fn pointers(document: &Value) -> Vec<String> {
    let faults = Study::from_value(document, &|path| Err(format!("no file {path}")))
        .expect_err("has faults");
    faults.into_iter().map(|fault| fault.pointer).collect()
}

fn valid() -> Value {
    parse(presets()[0].1, Format::Toml).unwrap()
}

fn with(pointer: &str, value: Value) -> Value {
    let mut document = valid();
    *document
        .pointer_mut(pointer)
        .unwrap_or_else(|| panic!("no {pointer}")) = value;
    document
}

/// Changes of the shipped study by their places, as JSON, and the places of all faults that they make.
const FAULTY: &str = r##"
* {"/name": " ", "/extra": {}, "/scene": {"preset": "foot-tire", "ground": {"depths_mm": [1, 1, 1, 1, -1]}},
    "/inputs": [
    {"name": "a", "vary": "x", "distribution": {"kind": "uniform", "min": 1}},
    {"name": "b\n", "distribution": {"kind": "cauchy", "shape": 1, "scale": 1}},
    {"name": "c", "vary": "ground.depths_mm[0]", "distribution": {"kind": "normal", "mean": 1, "std": 0}},
    {"name": "d", "vary": "ground.depths_mm[1]", "distribution": {"kind": "uniform", "min": 2, "max": 1}},
    7],
    "/candidates": {"points": "P1-P9", "grid": {"circumferential": 60, "half_width_deg": 0}},
    "/layouts": {"spacings_deg": [60, 50, 60], "positions": ["crown", "toe"]},
    "/method": {"kind": "sobol", "nodes": 16, "check_points": 1.5, "seed": -1},
    "/accuracy": {"tolerance": 0.02, "budget_s": 60}}
    -> /extra | /name | /scene/ground/depths_mm/4 | /candidates/points | /candidates/grid/meridional | /candidates/grid/half_width_deg |
       /candidates/grid/circumferential | /layouts/spacings_deg/1 | /layouts/spacings_deg/2 | /layouts/positions/1 | /method/kind | /method/nodes |
       /method/check_points | /method/seed | /accuracy | /inputs/0/vary | /inputs/0/distribution/max | /inputs/1/name | /inputs/1/vary |
       /inputs/1/distribution/kind | /inputs/2/distribution/std | /inputs/3/distribution | /inputs/4
* {"/inputs": []} -> /inputs
* {"/inputs/1/vary": "ground.depth[1]"} -> /inputs/1/vary
* {"/inputs/1/vary": "model.level"} -> /inputs/1/vary
* {"/inputs/1/vary": "ground.depths_mm[ 0 ]"} -> /inputs/1/vary
* {"/inputs/1/name": "P1"} -> /inputs/1/name
# Both fit the scene by themselves.
* {"/scene": {}, "/method": {"check_points": 16}, "/inputs": [
    {"name": "wall", "vary": "geometry.wall_mm", "distribution": {"kind": "uniform", "min": 2, "max": 9}},
    {"name": "section", "vary": "geometry.section_radius_mm", "distribution": {"kind": "uniform", "min": 4, "max": 21}}]}
    -> /inputs
# Ends beyond the scene's range; the outermost of five Gauss nodes lie 2.857 standard deviations out.
* {"/inputs/0/distribution": {"kind": "uniform", "min": -0.1, "max": 1}} -> /inputs/0/distribution
* {"/inputs/0/distribution": {"kind": "uniform", "min": 0.1, "max": 13}} -> /inputs/0/distribution
* {"/inputs/0/distribution": {"kind": "normal", "mean": 1, "std": 0.4}} -> /inputs/0/distribution
* {"/inputs/0/distribution": {"kind": "normal", "mean": 1, "std": 2, "truncate": [-0.5, 1.5]}} -> /inputs/0/distribution
* {"/inputs/0/distribution": {"kind": "gamma", "shape": -1, "scale": 0, "rate": 1, "truncate": [3, 2]}}
    -> /inputs/0/distribution/rate | /inputs/0/distribution/shape | /inputs/0/distribution/scale | /inputs/0/distribution/truncate
* {"/inputs/0/distribution": {"kind": "weibull", "scale": "wide", "truncate": [1, "x", 2]}}
    -> /inputs/0/distribution/shape | /inputs/0/distribution/scale | /inputs/0/distribution/truncate
* {"/inputs/0/distribution": {"kind": "gumbel", "location": 1, "scale": 0.1, "truncate": ["a", null]}}
    -> /inputs/0/distribution/truncate/0 | /inputs/0/distribution/truncate/1
* {"/inputs/0/distribution": {"kind": "triangular", "min": 1, "mode": 3, "max": 2}} -> /inputs/0/distribution/mode
* {"/inputs/0/distribution": {"kind": "beta", "alpha": 1, "beta": 1, "min": 2}} -> /inputs/0/distribution
* {"/inputs/0/distribution": {"kind": "exponential", "rate": 1, "truncate": [-2, -1]}} -> /inputs/0/distribution/truncate
* {"/inputs/0/distribution": {"kind": ["normal"]}} -> /inputs/0/distribution/kind
* {"/inputs/0/distribution": "normal"} -> /inputs/0/distribution
# More strains than fit in memory.
* {"/candidates/grid": {"circumferential": 201, "meridional": 201}, "/method/check_points": 1000} -> /candidates/grid
* {"/accuracy": {}} -> /accuracy
* {"/accuracy": {"preset": "draft", "budget_s": 1}} -> /accuracy
* {"/accuracy": {"tolerance": 0}} -> /accuracy/tolerance
* {"/accuracy": {"tolerance": 2}} -> /accuracy/tolerance
* {"/accuracy": {"budget_s": -1}} -> /accuracy/budget_s
* {"/layouts": {
    "units": [6, 0, 6], "section_deg": [30, 110], "directions": [["x", "z"], []], "staggered": "yes", "noise_share": 0, "noise_strain": 1e-3,
    "depths_mm": [1, -1], "loads_n": [5], "gain_std": -1, "level": "fine",
    "free": [{"name": "a", "films": [{"theta_deg": 400}, {"phi_deg": 119}]}, {"films": []}],
    "search": {"films": [3, 2000], "slots": 2}}}
    -> /layouts/units/1 | /layouts/units/2 | /layouts/section_deg/1 | /layouts/directions/0/1 | /layouts/directions/1 | /layouts/staggered |
       /layouts/free/0/films/0/theta_deg | /layouts/free/0/films/1/phi_deg | /layouts/free/1/name | /layouts/free/1/films | /layouts/depths_mm/1 |
       /layouts/loads_n | /layouts/noise_share | /layouts/noise_strain | /layouts/gain_std | /layouts/level | /layouts/search/films/1 |
       /layouts/search/slots
* {"/layouts": {"search": {"films": [3], "slots": 120, "section_deg": [0, 10, 20, 30, 40, 50, 60, 70, 80], "directions": ["x", "y"]}}} -> /layouts/search
# Ground without friction drags nothing, and slopes are those about ground that rests.
* {"/layouts": {"units": [7], "shear": true}} -> /layouts/shear
* {"/layouts": {"units": [7], "shear": "yes"}} -> /layouts/shear
* {"/scene": {"preset": "foot-tire", "contact": {"friction": 0.5}, "ground": {"shift_mm": [0.1, 0]}},
    "/layouts": {"units": [7], "shear": true}}
    -> /layouts/shear
* {"/question": {"films": 0, "angle_deg": -5, "force_n": "two", "film": 3}} -> /question/film | /question/films | /question/angle_deg | /question/force_n
* {"/question": {"films": 12}, "/layouts": {"spacings_deg": []}} -> /question
* {"/layouts": {"films": [0, 12, 12]}} -> /layouts/films/0 | /layouts/films/2
* {"/layouts": {"size_mm": 25}} -> /layouts/size_mm
* {"/layouts": {"size_mm": [25]}} -> /layouts/size_mm
* {"/layouts": {"size_mm": [25, 0]}} -> /layouts/size_mm/1
* {"/layouts": {"size_mm": ["x", 10]}} -> /layouts/size_mm/0
* {"/layouts": {"candidate_sizes_mm": [[10, 5], [0, 5], [10, 5]]}} -> /layouts/candidate_sizes_mm/1/0 | /layouts/candidate_sizes_mm/2
# The section is 9.5 mm wide and 102 degrees long to each side: 25 mm along y fit to 26 degrees, 10 mm across to 71.
* {"/layouts": {
    "size_mm": [25, 10], "units": [6], "section_deg": [0, 30, 80], "directions": [["x"], ["y"]],
    "free": [{"name": "a", "films": [{"phi_deg": 20, "angle_deg": 90}, {"phi_deg": -40, "angle_deg": 90}]}],
    "search": {"films": [3], "section_deg": [0, 45]}}}
    -> /layouts/section_deg/1 | /layouts/section_deg/2 | /layouts/free/0/films/1 | /layouts/search/section_deg/1
* {"/layouts": {"size_mm": [25, 10], "units": [6], "section_deg": [26, 27], "directions": [["x"], ["y"]]}} -> /layouts/section_deg/1
# The sidewall is one of the positions that a document without any has.
* {"/layouts": {"size_mm": [25, 10], "units": [6]}} -> /layouts/size_mm
* {"/layouts": {"size_mm": [25, 10], "units": [6], "directions": [["y"]], "positions": ["crown", "shoulder"]}} -> /layouts/positions/1
* {"/layouts": {"size_mm": [300, 1], "units": [6], "positions": ["crown"], "directions": [["x"]]}} -> /layouts/positions/0
* {"/layouts": {"candidate_sizes_mm": [[25, 10], [40, 36]]}} -> /layouts/candidate_sizes_mm/1
# 295 mm around at the crown: 11 films of 25 mm end to end, 29 side by side.
* {"/layouts": {"size_mm": [25, 10], "units": [11, 12, 24], "positions": ["crown"], "directions": [["x"]]}} -> /layouts/units/1 | /layouts/units/2
* {"/layouts": {"size_mm": [25, 10], "units": [29, 30], "positions": ["crown"], "directions": [["y"]]}} -> /layouts/units/1
* {"/layouts": {"size_mm": [25, 10], "spacings_deg": [30, 45], "positions": ["crown"], "directions": [["x", "y"]]}} -> /layouts/spacings_deg/0
# Spread between the units, x and y need 17.5 mm each: 8 units have 18.5.
* {"/layouts": {"size_mm": [25, 10], "units": [8, 9], "positions": ["crown"], "directions": [["x", "y"]], "staggered": true}} -> /layouts/units/1
* {"/layouts": {"size_mm": [25, 10], "free": [{"name": "a", "films": [{}, {"angle_deg": 90}, {"theta_deg": 30}, {"theta_deg": 61}, {"theta_deg": -20, "angle_deg": 90}]}]}}
    -> /layouts/free/0/films/2 | /layouts/free/0/films/4
* {"/layouts": {"search": {"films": [1, 3], "fixed": [{}, {"theta_deg": 90}], "forbidden_deg": [[165, 195], [1]], "least_distance_mm": -1}}}
    -> /layouts/search/forbidden_deg/1 | /layouts/search/least_distance_mm | /layouts/search/films/0
# Films that are taken are counted by a search, too.
* {"/layouts": {"taken": [{}, {"theta_deg": 90}], "forbidden_deg": [[10]], "search": {"films": [1, 3], "fixed": [{}]}}}
    -> /layouts/forbidden_deg/0 | /layouts/search/films/0
# At 47 mm a film along y reaches 6.1 degrees, one along x 15.2: the second lies on a taken film, the third at the valve, the fourth is the taken one, but the second lies on it.
* {"/layouts": {"size_mm": [25, 10], "taken": [{"theta_deg": 90, "angle_deg": 90}], "forbidden_deg": [[175, 185]],
    "free": [{"name": "a", "films": [{}, {"theta_deg": 110}, {"theta_deg": 180}, {"theta_deg": 90, "angle_deg": -90}]}]}}
    -> /layouts/free/0/films/1 | /layouts/free/0/films/2 | /layouts/free/0/films/3
* {"/layouts": {"units": [14, 15], "positions": ["crown"], "directions": [["y"]], "least_distance_mm": 20}} -> /layouts/units/1
"##;

/// The shipped study with these changes.
fn changed(changes: &str) -> Value {
    let mut document = valid();
    let changes: Value = serde_json::from_str(changes).expect("JSON");
    for (place, value) in changes.as_object().expect("places") {
        let (table, name) = place.rsplit_once('/').expect("a pointer");
        let table = document.pointer_mut(table).expect("is there");
        table[name] = value.clone();
    }
    document
}

#[test]
fn every_fault_is_told_at_its_place() {
    let rows = FAULTY.split("\n* ").skip(1);
    let mut count = 0;
    for row in rows {
        let (changes, expected) = row.split_once("->").expect("a row");
        let expected = expected.lines().filter(|line| !line.starts_with('#'));
        let expected: String = expected.collect();
        let expected: Vec<&str> = expected.split('|').map(str::trim).collect();
        assert_eq!(pointers(&changed(changes)), expected, "{changes}");
        count += 1;
    }
    assert_eq!(count, FAULTY.matches("->").count());
    // Just within the scene's range.
    let narrow = r#"{"/inputs/0/distribution": {"kind": "normal", "mean": 1, "std": 0.3}}"#;
    assert!(Study::from_value(&changed(narrow), &|_| Err(String::new())).is_ok());
}

#[test]
fn shipped_studies_read_and_plan() {
    for (name, _) in presets() {
        let study = shipped(name);
        assert_eq!(study.inputs.len(), 5);
        assert_eq!(
            study
                .scene
                .carcass
                .as_ref()
                .map(|carcass| carcass.angle_deg),
            Some(55.0)
        );
    }
}

#[test]
fn little_is_enough() {
    let study = study(
        "name = \"a\"\nscene = {}\n[[inputs]]\nname = \"p\"\nvary = \"pressure.internal_mpa\"\n\
         distribution = { kind = \"lognormal\", mu = -1.6, sigma = 0.1 }",
    );
    assert_eq!(
        (
            study.method.nodes,
            study.method.check_points,
            study.method.seed
        ),
        (5, 5, 1)
    );
    assert_eq!((study.grid, study.layouts.is_asked()), (None, false));
    assert_eq!(study.scene.carcass, None);
}

#[test]
fn a_number_that_is_none_and_a_faulty_scene_hide_no_other_fault() {
    let text = "name = \"a\"\n\
        scene = { geometry = { wall_mm = -3 }, material = { c10_mpa = nan } }\n\
        [[inputs]]\nname = \"P1\"\nvary = \"ground.depths_mm[1]\"\n\
        distribution = { kind = \"uniform\", min = 1.3, max = 0.7 }\n\
        [[inputs]]\nname = \"P1\"\nvary = \"ground.depth[0]\"\n\
        distribution = { kind = \"normal\", mean = inf, std = 1 }\n\
        [method]\nnodes = 50\n";
    let faults =
        Study::from_document(text, Format::Toml, &|_| Err(String::new())).expect_err("has faults");
    let mut pointers: Vec<&str> = faults.iter().map(|fault| fault.pointer.as_str()).collect();
    pointers.sort_unstable();
    assert_eq!(
        pointers,
        [
            "/inputs/0/distribution",
            "/inputs/1/distribution/mean",
            "/inputs/1/name",
            "/inputs/1/vary",
            "/method/nodes",
            "/scene/geometry/wall_mm",
            "/scene/material/c10_mpa",
        ]
    );
}

#[test]
fn every_law_reads_back_as_it_was_written() {
    for law in [
        json!({"kind": "uniform", "min": 0.7, "max": 1.3}),
        json!({"kind": "normal", "mean": 1.0, "std": 0.1}),
        json!({"kind": "lognormal", "mu": 0.0, "sigma": 0.1}),
        json!({"kind": "exponential", "rate": 5.0, "truncate": [0.1, 2.0]}),
        json!({"kind": "gamma", "shape": 9.0, "scale": 0.1}),
        json!({"kind": "weibull", "shape": 3.0, "scale": 1.0}),
        json!({"kind": "beta", "alpha": 2.0, "beta": 3.0, "min": 0.5, "max": 1.5}),
        json!({"kind": "gumbel", "location": 1.0, "scale": 0.1}),
        json!({"kind": "triangular", "min": 0.5, "mode": 1.0, "max": 1.2}),
        json!({"kind": "normal", "mean": 1.0, "std": 2.0, "truncate": [0.5, 1.5]}),
    ] {
        let document = with("/inputs/0/distribution", law.clone());
        let study = Study::from_value(&document, &|_| Err(String::new())).expect("no faults");
        assert_eq!(distribution_value(&study.inputs[0].distribution), law);
    }
    // On [0, 1] unless said otherwise; zero is then a stated end, and a depth that a scene takes.
    let document = with(
        "/inputs/0/distribution",
        json!({"kind": "beta", "alpha": 2, "beta": 3}),
    );
    let study = Study::from_value(&document, &|_| Err(String::new())).expect("no faults");
    assert_eq!(study.inputs[0].distribution.support(), (0.0, 1.0));
}

#[test]
fn more_solves_than_anyone_waits_for_are_refused_before_they_are_planned() {
    // (9 + 2) 10 000 solves; 100 000 are allowed.
    let mut document = with("/method", json!({"kind": "saltelli", "samples": 10_000}));
    document["scene"] = json!({"preset": "foot-tire", "ground": {"depths_mm": vec![1.0; 21], "station_spacing_mm": 2.0}});
    document["inputs"] = (0..9)
        .map(|k| {
            json!({"name": format!("P{k}"), "vary": format!("ground.depths_mm[{k}]"),
                   "distribution": {"kind": "uniform", "min": 0.7, "max": 1.3}})
        })
        .collect();
    assert_eq!(pointers(&document), ["/method/samples"]);
    document["method"]["samples"] = json!(100);
    assert!(Study::from_value(&document, &|path| Err(path.to_owned())).is_ok());
}

#[test]
fn a_scene_file_is_read_through_the_callback() {
    let mut document = valid();
    document["scene"] = json!("tires/mine.json");
    let resolve = |path: &str| match path {
        "tires/mine.json" => Ok("{\"geometry\": {\"wall_mm\": 2}}".to_owned()),
        other => Err(format!("no file {other}")),
    };
    assert_eq!(
        Study::from_value(&document, &resolve)
            .unwrap()
            .scene
            .geometry
            .wall_mm,
        2.0
    );
    let faulty = |_: &str| Ok("{\"geometry\": {\"wall_mm\": 20}}".to_owned());
    let faults = Study::from_value(&document, &faulty).unwrap_err();
    assert_eq!(faults[0].pointer, "/scene/geometry/wall_mm");
    assert!(
        faults[0].detail.starts_with("in tires/mine.json: "),
        "{}",
        faults[0].detail
    );
    let refusing = |_: &str| Err("paths aren't read here".to_owned());
    let faults = Study::from_value(&document, &refusing).unwrap_err();
    assert_eq!(
        (faults[0].pointer.as_str(), faults[0].detail.as_str()),
        ("/scene", "paths aren't read here")
    );
}

#[test]
fn an_accuracy_is_a_level_a_tolerance_or_a_budget() {
    let read = |accuracy: Value| {
        let document = with("/accuracy", accuracy);
        Study::from_value(&document, &|_| Err(String::new()))
    };
    let tolerance = read(json!({"tolerance": 0.03})).unwrap();
    assert_eq!(tolerance.accuracy, Accuracy::Tolerance(0.03));
    let budget = read(json!({"budget_s": 60})).unwrap();
    assert_eq!(budget.accuracy, Accuracy::Budget(60.0));
    for (study, level) in [(tolerance, "coarse"), (budget, "draft")] {
        assert_eq!(study.level.as_str(), level);
        let again = Study::from_document(&study.canonical(), Format::Json, &|_| Err(String::new()));
        assert_eq!(again.unwrap(), study);
    }
}

#[test]
fn the_accuracy_sets_the_level_of_the_scene() {
    let document = with("/accuracy/preset", json!("draft"));
    let study = Study::from_value(&document, &|_| Err(String::new())).unwrap();
    assert_eq!(study.level.as_str(), "draft");
    assert_eq!(study.scene.model.level, study.level);
}

#[test]
fn a_question_is_answered_by_the_common_menu_or_by_its_own() {
    let read = |change: &dyn Fn(&mut Value)| {
        let mut document = valid();
        document.as_object_mut().unwrap().remove("layouts");
        change(&mut document);
        let study = Study::from_value(&document, &|path| Err(path.to_owned())).unwrap();
        assert_eq!(Study::from_canonical(&study.canonical()), Ok(study.clone()));
        study
    };
    let asked = read(&|document| document["question"] = json!({"films": 14, "angle_deg": 5}));
    assert_eq!(
        (asked.question.films, asked.question.angle_deg),
        (Some(14), Some(5.0))
    );
    // Fourteen films are on the menu then, too: x, y, and both in two ways at three section angles.
    let of_14 = asked.layouts.rings(asked.directions).into_iter();
    assert_eq!(of_14.filter(|ring| ring.films() == 14).count(), 12);
    let own = read(&|document| {
        document["question"] = json!({"films": 14});
        document["layouts"] = json!({"units": [7], "positions": ["crown"]});
    });
    assert_eq!(own.layouts.rings(own.directions).len(), 1);
    assert!(read(&|_| ()).question.is_empty());
}

#[test]
fn a_study_of_layouts_reads_back_as_itself() {
    let mut document = valid();
    document["layouts"] = json!({
        "units": [7], "section_deg": [-20], "directions": [["x", "y"], [45]], "staggered": true, "loads_n": [5, 13], "noise_strain": 1e-3,
        "gain_std": 0.1, "place_std_deg": 3, "dead": true, "level": "coarse",
        "free": [{"name": "a", "films": [{"theta_deg": 10, "phi_deg": 20, "angle_deg": 30}]}],
        "search": {"films": [3], "fixed": [{"theta_deg": 90}], "forbidden_deg": [[165, 195]], "least_distance_mm": 20}, "size_mm": [12, 4.5], "candidate_sizes_mm": [[10, 5], [25, 10]],
    });
    let read = Study::from_value(&document, &|path| Err(path.to_owned())).unwrap();
    assert_eq!(Study::from_canonical(&read.canonical()), Ok(read));
    document["scene"] = json!({"preset": "foot-tire", "contact": {"friction": 0.5}});
    document["layouts"] = json!({"units": [7], "shear": true});
    let sheared = Study::from_value(&document, &|path| Err(path.to_owned())).unwrap();
    assert!(sheared.layouts.shear);
    assert_eq!(Study::from_canonical(&sheared.canonical()), Ok(sheared));
    let mut none = valid();
    none.as_object_mut().unwrap().remove("layouts");
    let read = Study::from_value(&none, &|path| Err(path.to_owned())).unwrap();
    assert!(!read.layouts.is_asked());
    assert_eq!(Study::from_canonical(&read.canonical()), Ok(read));
}
