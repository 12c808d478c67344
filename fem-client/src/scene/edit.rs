//! Changes single fields of a scene by their path, with every check of the whole.
//!
//! A path is written as in `ground.depths_mm[0]`.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use serde_json::{Map, Value, json};

use crate::scene::sensor_film::OF_ONE_LAYER;
use crate::scene::{Law, Scene};
use document::Variants;
use document::fault::{Fault, entry, member};
use document::fields::shown;

impl Scene {
    /// Sets one field by its path.
    ///
    /// Setting the whole of `ground.depths_mm` sets the number of stations too. Setting `material.model` to another law
    /// starts from that law's default parameters.
    ///
    /// # Errors
    /// The first fault: no such field, or a scene that the reader refuses. The scene is unchanged then.
    pub fn set(&mut self, path: &str, value: &Value) -> Result<(), Fault> {
        self.set_all(&[(path, value)])
            .map_err(|mut faults| faults.swap_remove(0))
    }

    /// Sets several fields, then checks the whole; so fields that depend on each other can be changed together.
    ///
    /// # Errors
    /// Every fault, at least one. The scene is unchanged then.
    pub fn set_all(&mut self, changes: &[(&str, &Value)]) -> Result<(), Vec<Fault>> {
        let mut document = self.to_open_value();
        let mut faults = Vec::new();
        let sets = |field: &str| changes.iter().any(|(path, _)| *path == field);
        let ground = ["depths_mm", "load_n", "stations"];
        forget_ground(
            &mut document,
            ground.map(|field| sets(&format!("ground.{field}"))),
        );
        forget_layers(&mut document, sets("film.layers"));
        if let Some((_, model)) = changes.iter().find(|(path, _)| *path == "material.model") {
            forget_parameters(&mut document, &self.material.law, model);
        }
        for (path, value) in changes {
            put_in(&mut document, path, (*value).clone(), &mut faults);
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        *self = Self::from_value(&document, "", &mut faults).ok_or(faults)?;
        Ok(())
    }

    /// Returns this scene with the fields of a partial document laid over it. Adds every fault, with pointers that start with `pointer`, and returns
    /// None when there is one.
    pub fn overlaid(
        &self,
        overrides: &Map<String, Value>,
        pointer: &str,
        faults: &mut Vec<Fault>,
    ) -> Option<Self> {
        let mut document = self.to_value();
        let ground = overrides.get("ground");
        let sets = |field: &str| ground.is_some_and(|ground| ground.get(field).is_some());
        forget_ground(&mut document, ["depths_mm", "load_n", "stations"].map(sets));
        let film = overrides.get("film");
        forget_layers(
            &mut document,
            film.is_some_and(|film| film.get("layers").is_some()),
        );
        if let Some(model) = overrides.get("material").and_then(|m| m.get("model")) {
            forget_parameters(&mut document, &self.material.law, model);
        }
        if let Value::Object(object) = &mut document {
            lay_over(object, overrides);
        }
        Self::from_value(&document, pointer, faults)
    }

    /// The scene as a document in which the ground's shift and camber stand even where there are none, so that they have paths.
    fn to_open_value(&self) -> Value {
        let mut document = self.to_value();
        if let Some(ground) = document.get_mut("ground").and_then(Value::as_object_mut) {
            ground.insert(SHIFT.to_owned(), json!(self.ground.shift_mm));
            ground.insert(CAMBER.to_owned(), json!(self.ground.camber_deg));
        }
        document
    }

    /// The number at a path.
    ///
    /// # Errors
    /// When there is no such field, or it isn't a number.
    pub fn number_at(&self, path: &str) -> Result<f64, Fault> {
        let fault = |detail| Fault {
            pointer: String::new(),
            detail,
        };
        let quoted = path.escape_debug();
        let steps = parse_path(path)
            .ok_or_else(|| fault(format!("\"{quoted}\" isn't a path; {EXAMPLE}")))?;
        let mut document = self.to_open_value();
        let mut pointer = String::new();
        for step in &steps {
            document = match descend(&mut document, &mut pointer, step) {
                Ok(value) => value.take(),
                Err(detail) => {
                    return Err(fault(format!("there is no field \"{quoted}\": {detail}")));
                }
            };
        }
        document.as_f64().ok_or_else(|| {
            fault(format!(
                "\"{quoted}\" isn't a number; it is {}",
                shown(&document)
            ))
        })
    }
}

/// Puts a value at a path of any document; a fault when there is no such place. Whoever reads the document judges what it is now.
pub fn put_in(document: &mut Value, path: &str, value: Value, faults: &mut Vec<Fault>) {
    match parse_path(path) {
        Some(steps) => put(document, &steps, value, faults),
        None => Fault::add(
            faults,
            "",
            format!("\"{}\" isn't a path; {EXAMPLE}", path.escape_debug()),
        ),
    }
}

/// Fields of the ground that its document lacks where they are nothing.
const SHIFT: &str = "shift_mm";
const CAMBER: &str = "camber_deg";

/// The number at a path of a scene's canonical document, read without checking the rest of it; `None` when there is none.
pub fn number_in(document: &Value, path: &str) -> Option<f64> {
    let steps = parse_path(path)?;
    let left_out = match steps.as_slice() {
        [Step::Name("ground"), Step::Name(SHIFT), Step::Index(0 | 1)] => Some(SHIFT),
        [Step::Name("ground"), Step::Name(CAMBER)] => Some(CAMBER),
        _ => None,
    };
    if let Some(field) = left_out
        && document.get("ground")?.get(field).is_none()
    {
        return Some(0.0);
    }
    let end = steps.iter().try_fold(document, |value, step| match step {
        Step::Name(name) => value.get(name),
        Step::Index(index) => value.get(index),
    });
    end?.as_f64()
}

const EXAMPLE: &str = "write it as in ground.depths_mm[0] or pressure.internal_mpa";

/// A step of a path.
#[derive(Debug, PartialEq)]
enum Step<'p> {
    Name(&'p str),
    Index(usize),
}

fn parse_path(path: &str) -> Option<Vec<Step<'_>>> {
    let mut steps = Vec::new();
    for part in path.trim().split('.') {
        let (name, mut rest) = part.split_at(part.find('[').unwrap_or(part.len()));
        if name.is_empty()
            || !name
                .bytes()
                .all(|byte| byte.is_ascii_alphanumeric() || byte == b'_')
        {
            return None;
        }
        steps.push(Step::Name(name));
        while !rest.is_empty() {
            let (index, after) = rest.strip_prefix('[')?.split_once(']')?;
            steps.push(Step::Index(parse_index(index)?));
            rest = after;
        }
    }
    // No field of a scene lies deeper than four steps; this bounds the work for any text.
    (steps.len() <= 8).then_some(steps)
}

/// Only the usual spelling, so that equal paths are equal texts.
fn parse_index(text: &str) -> Option<usize> {
    let index: usize = text.parse().ok()?;
    (index.to_string() == text).then_some(index)
}

/// Goes one step down, or says what exists instead.
fn descend<'v>(
    value: &'v mut Value,
    pointer: &mut String,
    step: &Step<'_>,
) -> Result<&'v mut Value, String> {
    match (step, value) {
        (Step::Name(name), Value::Object(object)) => {
            *pointer = member(pointer, name);
            let known = object.keys().cloned().collect::<Vec<_>>().join(", ");
            object
                .get_mut(*name)
                .ok_or_else(|| format!("the fields here are {known}"))
        }
        (Step::Index(index), Value::Array(items)) => {
            *pointer = entry(pointer, *index);
            let length = items.len();
            items
                .get_mut(*index)
                .ok_or_else(|| format!("the list has {length} entries, counted from 0"))
        }
        (_, other) => Err(format!("there is {} here", shown(other))),
    }
}

/// Puts a value at the end of the steps. A table's missing member is created: the reader judges whether it may exist.
fn put(document: &mut Value, steps: &[Step<'_>], value: Value, faults: &mut Vec<Fault>) {
    let mut target = document;
    let mut pointer = String::new();
    for (i, step) in steps.iter().enumerate() {
        if let (Step::Name(name), Value::Object(object)) = (step, &mut *target)
            && !object.contains_key(*name)
            && !matches!(steps.get(i + 1), Some(Step::Index(_)))
        {
            object.insert((*name).to_owned(), Value::Object(Map::new()));
        }
        target = match descend(target, &mut pointer, step) {
            Ok(next) => next,
            Err(detail) => {
                return Fault::add(
                    faults,
                    &pointer,
                    format!("there is no such field: {detail}"),
                );
            }
        };
    }
    *target = value;
}

/// Depths say how many stations there are, and stand in place of a load, as it does of them: which of depths, load and stations are set.
fn forget_ground(document: &mut Value, [depths, load, stations]: [bool; 3]) {
    let Some(ground) = document.get_mut("ground").and_then(Value::as_object_mut) else {
        return;
    };
    if depths && !stations {
        ground.shift_remove("stations");
    }
    if depths && !load {
        ground.shift_remove("load_n");
    }
    if load && !depths {
        ground.shift_remove("depths_mm");
    }
}

/// A film's layers stand in place of the fields of one.
fn forget_layers(document: &mut Value, is_set: bool) {
    let Some(film) = document.get_mut("film").and_then(Value::as_object_mut) else {
        return;
    };
    if is_set {
        for name in OF_ONE_LAYER {
            film.shift_remove(name);
        }
    }
}

/// Parameters of one law say nothing about another.
fn forget_parameters(document: &mut Value, law: &Law, model: &Value) {
    if model.as_str() == Some(law.name()) {
        return;
    }
    if let Some(material) = document.get_mut("material").and_then(Value::as_object_mut) {
        for name in law.own_names() {
            material.shift_remove(*name);
        }
    }
}

fn lay_over(under: &mut Map<String, Value>, over: &Map<String, Value>) {
    for (name, value) in over {
        match (under.get_mut(name), value) {
            (Some(Value::Object(below)), Value::Object(above)) => lay_over(below, above),
            _ => {
                under.insert(name.clone(), value.clone());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Carcass;

    #[test]
    fn a_field_is_set_by_its_path() {
        let mut scene = Scene::default();
        scene.set("ground.depths_mm[1]", &json!(0.7)).unwrap();
        scene.set("pressure.internal_mpa", &json!(0)).unwrap();
        scene.set("model.level", &json!("draft")).unwrap();
        assert_eq!(scene.ground.depths_mm, [1.0, 0.7, 1.0, 1.0, 1.0]);
        assert_eq!(scene.pressure.internal_mpa, 0.0);
        assert_eq!(scene.number_at("ground.depths_mm[1]"), Ok(0.7));
    }

    #[test]
    fn a_camber_has_a_path_where_there_is_none() {
        let (mut scene, path) = (Scene::default(), "ground.camber_deg");
        assert_eq!(scene.number_at(path), Ok(0.0));
        assert_eq!(number_in(&scene.to_value(), path), Some(0.0));
        scene.set(path, &json!(7.5)).unwrap();
        assert_eq!(scene.number_at(path), Ok(7.5));
        assert_eq!(number_in(&scene.to_value(), path), Some(7.5));
        assert!(scene.set(path, &json!(-31)).is_err());
        scene.set(path, &json!(0)).unwrap();
        assert_eq!(scene, Scene::default());
    }

    #[test]
    fn a_shift_is_set_by_its_entries_and_forgotten_where_it_is_nowhere() {
        let mut scene = Scene::default();
        scene.contact.friction = 0.5;
        let still = scene.canonical_json();
        assert_eq!(scene.number_at("ground.shift_mm[1]"), Ok(0.0));
        assert_eq!(
            number_in(&scene.to_value(), "ground.shift_mm[1]"),
            Some(0.0)
        );
        assert_eq!(number_in(&scene.to_value(), "ground.shift_mm[2]"), None);
        scene.set("ground.shift_mm[1]", &json!(-0.5)).unwrap();
        assert_eq!(scene.ground.shift_mm, [0.0, -0.5]);
        assert_eq!(scene.number_at("ground.shift_mm[1]"), Ok(-0.5));
        assert_eq!(
            number_in(&scene.to_value(), "ground.shift_mm[1]"),
            Some(-0.5)
        );
        scene.set("ground.depths_mm", &json!([1, 2, 1])).unwrap();
        assert_eq!(scene.ground.shift_mm, [0.0, -0.5]);
        let fault = scene.set("contact.friction", &json!(0)).unwrap_err();
        assert_eq!(fault.pointer, "/ground/shift_mm");
        for (path, value, expected) in [
            ("ground.shift_mm[2]", json!(1), "2 entries"),
            ("ground.shift_mm[0]", json!(13), "from -12.5 to 12.5"),
            ("ground.shift_mm", json!([1]), "2 ways"),
        ] {
            let fault = scene.set(path, &value).unwrap_err();
            assert!(fault.detail.contains(expected), "{path}: {}", fault.detail);
        }
        scene
            .set("ground.depths_mm", &json!([1, 1, 1, 1, 1]))
            .unwrap();
        scene.set("ground.shift_mm[1]", &json!(0)).unwrap();
        assert_eq!(scene.canonical_json(), still);
        // What needs friction comes with it.
        let mut scene = Scene::default();
        let together = [
            ("ground.shift_mm[0]", &json!(0.3)),
            ("contact.friction", &json!(0.5)),
        ];
        scene.set_all(&together).unwrap();
        assert_eq!(scene.ground.shift_mm, [0.3, 0.0]);
    }

    #[test]
    fn setting_all_depths_sets_the_stations() {
        let mut scene = Scene::default();
        scene.set("ground.depths_mm", &json!([1, 2, 1])).unwrap();
        assert_eq!(
            (scene.ground.stations, scene.ground.depths_mm.len()),
            (3, 3)
        );
        assert_eq!(
            scene.set("ground.stations", &json!(5)).unwrap_err().pointer,
            "/ground/stations"
        );
        scene
            .set_all(&[
                ("ground.stations", &json!(1)),
                ("ground.depths_mm", &json!([2])),
            ])
            .unwrap();
        assert_eq!(scene.ground.depths_mm, [2.0]);
    }

    #[test]
    fn a_load_takes_the_place_of_depths_and_depths_that_of_a_load() {
        let mut scene = Scene::default();
        scene.set("ground.load_n", &json!(13)).unwrap();
        assert_eq!(
            (scene.ground.load_n, scene.ground.stations),
            (Some(13.0), 5)
        );
        assert!(scene.ground.depths_mm.is_empty());
        assert_eq!(scene.number_at("ground.load_n"), Ok(13.0));
        let text = scene.canonical_json();
        assert_eq!(Scene::from_json(&text).unwrap(), scene);
        scene.set("ground.depths_mm", &json!([1, 2, 1])).unwrap();
        assert_eq!((scene.ground.load_n, scene.ground.stations), (None, 3));
        let overrides = json!({"ground": {"load_n": 5, "stations": 7}});
        let overrides = overrides.as_object().unwrap();
        let scene = scene.overlaid(overrides, "", &mut Vec::new()).unwrap();
        assert_eq!((scene.ground.load_n, scene.ground.stations), (Some(5.0), 7));
    }

    #[test]
    fn an_absent_table_appears_when_a_field_of_it_is_set() {
        let mut scene = Scene::default();
        scene.set("carcass.angle_deg", &json!(40)).unwrap();
        assert_eq!(
            scene.carcass,
            Some(Carcass {
                angle_deg: 40.0,
                ..Carcass::default()
            })
        );
        scene.set("carcass", &Value::Null).unwrap();
        assert_eq!(scene.carcass, None);
    }

    #[test]
    fn another_law_starts_from_its_own_parameters() {
        let mut scene = Scene::default();
        scene.set("material.model", &json!("yeoh")).unwrap();
        assert_eq!(scene.material.law, Law::of_name("yeoh").expect("a law"));
        scene.set("material.c20_mpa", &json!(-0.01)).unwrap();
        assert_eq!(scene.number_at("material.c20_mpa"), Ok(-0.01));
        // The same law again keeps what was set.
        scene.set("material.model", &json!("yeoh")).unwrap();
        assert_eq!(scene.number_at("material.c20_mpa"), Ok(-0.01));
        let terms = json!([{"mu_mpa": 0.5, "alpha": 1.3}, {"mu_mpa": 0.1, "alpha": -2}]);
        scene
            .set_all(&[
                ("material.model", &json!("ogden")),
                ("material.terms", &terms),
            ])
            .unwrap();
        scene.set("material.terms[1].mu_mpa", &json!(0.2)).unwrap();
        assert_eq!(scene.number_at("material.terms[1].mu_mpa"), Ok(0.2));
        assert_eq!(scene.number_at("material.terms[0].alpha"), Ok(1.3));
        let overrides = json!({"material": {"model": "neo-hookean", "c10_mpa": 0.2}});
        let preset = Scene::preset("foot-tire").unwrap();
        let scene = preset
            .overlaid(overrides.as_object().unwrap(), "", &mut Vec::new())
            .unwrap();
        assert_eq!(scene.material.law, Law::NeoHookean { c10_mpa: 0.2 });
    }

    #[test]
    fn faults_name_what_exists_and_leave_the_scene_alone() {
        let mut scene = Scene::default();
        let cases = [
            ("ground.depth_mm[0]", json!(1), "fields"),
            ("ground.depth", json!(1), "depths_mm"),
            ("ground.depths_mm[5]", json!(1), "5 entries"),
            ("ground.depths_mm[0].x", json!(1), "there is 1.0 here"),
            ("ground.depths_mm[0]", json!(-1), "from 0 to"),
            ("ground.load_n", json!(-1), "from 0 to"),
            ("ground.load_n", json!("heavy"), "must be a number"),
            ("geometry.wall_mm", json!(20), "section_radius_mm"),
            ("tyre", json!(1), "the fields here are geometry"),
            ("", json!(1), "isn't a path"),
            ("ground.depths_mm[00]", json!(1), "isn't a path"),
            ("ground.depths_mm[", json!(1), "isn't a path"),
            (
                "ground.depths_mm[99999999999999999999]",
                json!(1),
                "isn't a path",
            ),
        ];
        for (path, value, expected) in cases {
            let fault = scene.set(path, &value).unwrap_err();
            assert!(fault.detail.contains(expected), "{path}: {}", fault.detail);
        }
        assert_eq!(scene, Scene::default());
    }

    #[test]
    fn only_numbers_have_a_number() {
        let scene = Scene::default();
        assert!(
            scene
                .number_at("model.level")
                .unwrap_err()
                .detail
                .contains("isn't a number")
        );
        assert!(
            scene
                .number_at("carcass.angle_deg")
                .unwrap_err()
                .detail
                .contains("geometry, material")
        );
        assert!(
            scene
                .number_at("ground.depths_mm")
                .unwrap_err()
                .detail
                .contains("a list of 5")
        );
    }

    #[test]
    fn overrides_are_laid_over_a_preset() {
        let preset = Scene::preset("foot-tire").unwrap();
        let overrides = json!({"ground": {"depths_mm": [1, 1, 1]}, "carcass": {"angle_deg": 50}});
        let scene = preset
            .overlaid(overrides.as_object().unwrap(), "/scene", &mut Vec::new())
            .unwrap();
        assert_eq!(scene.ground.stations, 3);
        assert_eq!(scene.carcass.unwrap().stiffness_n_per_mm, 100.0);
        let mut faults = Vec::new();
        let overrides = json!({"ground": {"depths_mm": [1, -1, 1]}});
        assert_eq!(
            preset.overlaid(overrides.as_object().unwrap(), "/scene", &mut faults),
            None
        );
        assert_eq!(faults[0].pointer, "/scene/ground/depths_mm/1");
    }
}
