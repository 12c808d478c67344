//! Designs of one study: its document with some fields set otherwise.
//!
//! A design is a study like any other; what it shares with others is in the archive by content. A field is named by its path, as in
//! `geometry.wall_mm` for the scene's and `method.nodes` for the study's own.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::collections::HashMap;

use fem_client::fault::{Fault, entry, member};
use fem_client::fields::{Fields, shown};
use fem_client::scene_edit::put_in;
use serde_json::{Map, Value};

use crate::input_reader::read_name;
use crate::study::Study;
use crate::study_reader::{LONGEST_NAME, Resolve};

/// Most designs of a sweep.
pub const MOST_DESIGNS: usize = 1000;
/// Parts of a study's document that aren't its scene.
const OF_STUDY: [&str; 5] = ["inputs", "candidates", "layouts", "method", "accuracy"];

/// One of the designs.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// What tells it from the others, as `wall_mm = 2.5`.
    pub name: String,
    /// Values by path, in the order given.
    pub set: Map<String, Value>,
    /// The study with these values.
    pub study: Study,
}

/// A study and its designs.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// Free text, the study's name where none is given.
    pub name: String,
    /// The study without changes.
    pub base: Study,
    /// At least one; no two are the same study.
    pub designs: Vec<Design>,
}

impl Sweep {
    /// Reads a sweep from a parsed document: `study`, and `grid` (lists of values by path, of which every combination is a design, the last path
    /// varying fastest) or `designs` (a list of `set`, values by path, each with a `name` if wanted).
    ///
    /// # Errors
    /// Every fault of the document.
    pub fn from_value(value: &Value, resolve: Resolve<'_>) -> Result<Self, Vec<Fault>> {
        let mut faults = Vec::new();
        let known = ["name", "study", "grid", "designs"];
        let sweep = Fields::open(value, "", &known, &mut faults)
            .and_then(|fields| read(&fields, resolve, &mut faults));
        match sweep {
            Some(sweep) if faults.is_empty() => Ok(sweep),
            _ => Err(faults),
        }
    }
}

fn read(fields: &Fields<'_>, resolve: Resolve<'_>, faults: &mut Vec<Fault>) -> Option<Sweep> {
    let (study, pointer) = fields.required("study", "a study document", faults)?;
    let base = match Study::from_value(study, resolve) {
        Ok(base) => base,
        Err(found) => {
            for fault in found {
                Fault::add(faults, &format!("{pointer}{}", fault.pointer), fault.detail);
            }
            return None;
        }
    };
    with_designs(base, fields, faults)
}

fn with_designs(base: Study, fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Option<Sweep> {
    let name = name(fields, faults);
    let designs = read_designs(&base, fields, faults);
    let (name, designs) = (name?.unwrap_or_else(|| base.name.clone()), designs?);
    Some(Sweep {
        name,
        base,
        designs,
    })
}

/// None after a fault.
fn name(fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Option<Option<String>> {
    match fields.get("name") {
        None => Some(None),
        Some(_) => read_name(fields, "name", LONGEST_NAME, faults).map(Some),
    }
}

/// A sweep of a checked study over a grid: lists of values by path.
///
/// # Errors
/// Every fault of the name and of the grid.
pub fn sweep_of(
    base: Study,
    name: Option<&str>,
    grid: &Map<String, Value>,
) -> Result<Sweep, Vec<Fault>> {
    let mut document = Map::from_iter([("grid".to_owned(), Value::Object(grid.clone()))]);
    document.extend(name.map(|name| ("name".to_owned(), Value::from(name))));
    let document = Value::Object(document);
    let mut faults = Vec::new();
    let sweep = Fields::open(&document, "", &["name", "grid"], &mut faults)
        .and_then(|fields| with_designs(base, &fields, &mut faults));
    match sweep {
        Some(sweep) if faults.is_empty() => Ok(sweep),
        _ => Err(faults),
    }
}

/// Reads further designs of a study: a document with `grid` or `designs`.
///
/// # Errors
/// Every fault of the document.
pub fn designs_of(base: &Study, value: &Value) -> Result<Vec<Design>, Vec<Fault>> {
    let mut faults = Vec::new();
    let designs = Fields::open(value, "", &["grid", "designs"], &mut faults)
        .and_then(|fields| read_designs(base, &fields, &mut faults));
    match designs {
        Some(designs) if faults.is_empty() => Ok(designs),
        _ => Err(faults),
    }
}

/// A design before its study is made.
struct Wish {
    name: Option<String>,
    set: Map<String, Value>,
    /// Where each value stands in the document, in their order.
    pointers: Vec<String>,
    /// Where the design stands.
    pointer: String,
}

fn read_designs(base: &Study, fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Option<Vec<Design>> {
    let wishes = match (fields.get("grid"), fields.get("designs")) {
        (Some((grid, pointer)), None) => of_grid(grid, &pointer, faults)?,
        (None, Some((list, pointer))) => of_list(list, &pointer, faults)?,
        _ => {
            let detail = "must hold exactly one of grid and designs: {\"geometry.wall_mm\": [2.5, 3]} as grid, or \
                          [{\"set\": {\"geometry.wall_mm\": 2.5}}] as designs";
            Fault::add(faults, "", detail);
            return None;
        }
    };
    let names = names(&wishes);
    let mut seen: HashMap<String, String> = HashMap::new();
    let mut designs = Vec::new();
    for (wish, name) in wishes.into_iter().zip(names) {
        let Some(study) = study_of(base, &wish, &name, faults) else {
            continue;
        };
        if let Some(twin) = seen.insert(nameless(&study), wish.pointer.clone()) {
            let detail = format!("is the same design as that of {twin}");
            Fault::add(faults, &wish.pointer, detail);
        }
        designs.push(Design {
            name,
            set: wish.set,
            study,
        });
    }
    Some(designs)
}

/// Canonical document of a study without its name: the same for the same design.
pub fn nameless(study: &Study) -> String {
    let nameless = Study {
        name: String::new(),
        ..study.clone()
    };
    nameless.canonical()
}

/// Every combination, the last path varying fastest.
fn of_grid(grid: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Vec<Wish>> {
    let what = "a table with a list of values for each path";
    let table = grid.as_object().filter(|table| !table.is_empty());
    let Some(table) = table else {
        Fault::add(
            faults,
            pointer,
            format!("must be {what}; it is {}", shown(grid)),
        );
        return None;
    };
    let mut wishes = vec![Wish {
        name: None,
        set: Map::new(),
        pointers: Vec::new(),
        pointer: pointer.to_owned(),
    }];
    for (path, values) in table {
        let at = member(pointer, path);
        let Some(values) = values.as_array().filter(|values| !values.is_empty()) else {
            let detail = format!("must be a list of values; it is {}", shown(values));
            Fault::add(faults, &at, detail);
            continue;
        };
        if wishes.len().saturating_mul(values.len()) > MOST_DESIGNS {
            Fault::add(faults, pointer, too_many());
            return None;
        }
        let with = |wish: &Wish, (index, value): (usize, &Value)| {
            let mut set = wish.set.clone();
            set.insert(path.clone(), value.clone());
            let mut pointers = wish.pointers.clone();
            pointers.push(entry(&at, index));
            Wish {
                name: None,
                set,
                pointers,
                pointer: pointer.to_owned(),
            }
        };
        wishes = wishes
            .iter()
            .flat_map(|wish| {
                values
                    .iter()
                    .enumerate()
                    .map(move |value| with(wish, value))
            })
            .collect();
    }
    faults.is_empty().then_some(wishes)
}

fn too_many() -> String {
    format!("these are more than {MOST_DESIGNS} designs, the most of one sweep")
}

fn of_list(list: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Vec<Wish>> {
    let Some(items) = list.as_array().filter(|items| !items.is_empty()) else {
        let detail = format!("must be a list of designs; it is {}", shown(list));
        Fault::add(faults, pointer, detail);
        return None;
    };
    if items.len() > MOST_DESIGNS {
        Fault::add(faults, pointer, too_many());
        return None;
    }
    let wishes = items.iter().enumerate().filter_map(|(index, item)| {
        let at = entry(pointer, index);
        let fields = Fields::open(item, &at, &["name", "set"], faults)?;
        let name = name(&fields, faults)?;
        let (set, within) = fields.required("set", "a table of values by path", faults)?;
        let Some(set) = set.as_object() else {
            let detail = format!("must be a table of values by path; it is {}", shown(set));
            Fault::add(faults, &within, detail);
            return None;
        };
        Some(Wish {
            name,
            set: set.clone(),
            pointers: set.keys().map(|path| member(&within, path)).collect(),
            pointer: at,
        })
    });
    let wishes: Vec<Wish> = wishes.collect();
    faults.is_empty().then_some(wishes)
}

/// The names that designs have, or else what they set: paths by their last step, where that tells them apart.
fn names(wishes: &[Wish]) -> Vec<String> {
    let last = |path: &str| path.rsplit('.').next().unwrap_or(path).to_owned();
    let mut paths: Vec<&String> = wishes.iter().flat_map(|wish| wish.set.keys()).collect();
    paths.sort();
    paths.dedup();
    let mut count: HashMap<String, usize> = HashMap::new();
    for path in paths {
        *count.entry(last(path)).or_default() += 1;
    }
    let short = |path: &str| match count.get(&last(path)) {
        Some(1) => last(path),
        _ => path.to_owned(),
    };
    let named = |wish: &Wish| {
        let texts: Vec<String> = wish
            .set
            .iter()
            .map(|(path, value)| match value {
                Value::String(text) => format!("{} = {text}", short(path)),
                other => format!("{} = {other}", short(path)),
            })
            .collect();
        let text = texts.join(", ");
        match (&wish.name, text.is_empty()) {
            (Some(name), _) => name.clone(),
            (None, true) => "unchanged".to_owned(),
            (None, false) => text,
        }
    };
    wishes.iter().map(named).collect()
}

/// The study of a design; its faults stand where the values do.
fn study_of(base: &Study, wish: &Wish, name: &str, faults: &mut Vec<Fault>) -> Option<Study> {
    let (of_study, of_scene): (Vec<_>, Vec<_>) = wish
        .set
        .iter()
        .map(|(path, value)| (path.strip_prefix("scene.").unwrap_or(path), value))
        .partition(|(path, _)| OF_STUDY.contains(&first_step(path)));
    let mut found = Vec::new();
    let mut scene = base.scene.clone();
    if let Err(refused) = scene.set_all(&of_scene) {
        found.extend(refused);
    }
    if wish.set.keys().any(|path| path.ends_with("model.level")) {
        let detail = "the mesh of a study is set by accuracy.preset";
        Fault::add(&mut found, "/model/level", detail);
    }
    let mut document: Value = serde_json::from_str(&base.canonical()).unwrap_or_default();
    put_in(&mut document, "scene", scene.to_value(), &mut found);
    put_in(
        &mut document,
        "name",
        full_name(base, name).into(),
        &mut found,
    );
    for (path, value) in of_study {
        if first_step(path) == "accuracy" {
            // One of several ways to ask for it, of which the document names one.
            put_in(&mut document, "accuracy", Map::new().into(), &mut found);
        }
        put_in(&mut document, path, value.clone(), &mut found);
    }
    let study = if found.is_empty() {
        let no_files = |path: &str| Err(format!("a design names the file {path:?}"));
        Study::from_value(&document, &no_files)
    } else {
        Err(found)
    };
    match study {
        Ok(study) => Some(study),
        Err(found) => {
            found
                .iter()
                .for_each(|fault| blame(wish, name, fault, faults));
            None
        }
    }
}

fn first_step(path: &str) -> &str {
    path.split(['.', '[']).next().unwrap_or(path)
}

/// The base's name with the design's, cut where it is too long.
fn full_name(base: &Study, name: &str) -> String {
    let full = format!("{}: {name}", base.name);
    full.chars().take(LONGEST_NAME).collect()
}

/// A fault of a design's study, told of the value that made it: once, however many designs of a grid share it.
fn blame(wish: &Wish, name: &str, fault: &Fault, faults: &mut Vec<Fault>) {
    let within = fault
        .pointer
        .strip_prefix("/scene")
        .unwrap_or(&fault.pointer);
    let culprit = wish.set.keys().zip(&wish.pointers).find(|(path, _)| {
        let path = path.strip_prefix("scene.").unwrap_or(path);
        let of_path = as_pointer(path);
        within == of_path || within.starts_with(&format!("{of_path}/"))
    });
    let told = match culprit {
        Some((_, pointer)) => Fault {
            pointer: pointer.clone(),
            detail: fault.detail.clone(),
        },
        None => Fault {
            pointer: wish.pointer.clone(),
            detail: format!("the design {name}: {fault}"),
        },
    };
    if !faults.contains(&told) {
        Fault::add(faults, &told.pointer, told.detail);
    }
}

/// `/ground/depths_mm/0` of `ground.depths_mm[0]`.
fn as_pointer(path: &str) -> String {
    let steps = path.split(['.', '[', ']']).filter(|step| !step.is_empty());
    steps.fold(String::new(), |pointer, step| member(&pointer, step))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::study::presets;
    use fem_client::document::{Format, parse};

    fn document(rest: Value) -> Value {
        let mut document = json!({"study": parse(presets()[0].1, Format::Toml).unwrap()});
        let members = rest.as_object().unwrap().clone();
        document.as_object_mut().unwrap().extend(members);
        document
    }

    fn read(rest: Value) -> Result<Sweep, Vec<Fault>> {
        Sweep::from_value(&document(rest), &|path| Err(path.to_owned()))
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
    fn further_designs_are_read_alone() {
        let sweep = read(json!({"grid": {"geometry.wall_mm": [3]}})).unwrap();
        let further = json!({"grid": {"geometry.wall_mm": [2.5]}});
        let designs = designs_of(&sweep.base, &further).unwrap();
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
        let many: Vec<u32> = (0..40).collect();
        let found =
            faults(json!({"grid": {"geometry.wall_mm": many, "geometry.outer_radius_mm": many}}));
        assert!(found[0].1.contains("more than 1000"), "{found:?}");
    }
}
