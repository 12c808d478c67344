//! Reads a study from a document, with every fault at once.

use fem_client::document::{Fields, Format, Range, alternatives, choice, number, parse, shown};
use fem_client::fault::{Fault, entry, member};
use fem_client::scene::{Level, PRESETS, Scene};
use fem_client::solver::Grid;
use serde_json::Value;

use crate::input_reader::{read_inputs, read_name};
use crate::plan::{Plan, PlanError};
use crate::study::{Layouts, Method, MethodKind, POSITIONS, Study};

/// Gives the text of a scene file, or says why it can't be had.
pub type Resolve<'r> = &'r dyn Fn(&str) -> Result<String, String>;

/// Longest name of a study, characters.
const LONGEST_NAME: usize = 200;
/// Most points along either side of the dense map.
const MOST_GRID_POINTS: u64 = 201;
/// Most strains of all maps of a study: they are held in memory twice while they are analysed, 320 MB at this bound.
const MOST_MAP_STRAINS: usize = 20_000_000;
const HALF_WIDTH: Range = Range::new(0.1, 180.0, "degrees");
const DEFAULT_HALF_WIDTH_DEG: f64 = 45.0;
const SPACING: Range = Range::new(1.0, 360.0, "degrees");
const MOST_SPACINGS: usize = 50;
/// Nodes per input and check points that this version takes.
const NODES: (u64, u64) = (1, 15);
const CHECK_POINTS: (u64, u64) = (0, 1000);

impl Study {
    /// Reads a study from text. `resolve` gives the text of a scene that the study names by its path, so that this
    /// crate opens no files.
    ///
    /// # Errors
    /// Every fault of the document.
    pub fn from_document(
        text: &str,
        format: Format,
        resolve: Resolve<'_>,
    ) -> Result<Self, Vec<Fault>> {
        let value = parse(text, format)?;
        Self::from_value(&value, resolve)
    }

    /// Reads a study from a parsed document.
    ///
    /// # Errors
    /// Every fault of the document.
    pub fn from_value(value: &Value, resolve: Resolve<'_>) -> Result<Self, Vec<Fault>> {
        let mut faults = Vec::new();
        let study = read(value, resolve, &mut faults);
        match study {
            Some(study) if faults.is_empty() => Ok(study),
            _ => Err(faults),
        }
    }
}

fn read(value: &Value, resolve: Resolve<'_>, faults: &mut Vec<Fault>) -> Option<Study> {
    let known = [
        "name",
        "scene",
        "inputs",
        "candidates",
        "layouts",
        "method",
        "accuracy",
    ];
    let fields = Fields::open(value, "", &known, faults)?;
    let name = read_name(&fields, "name", LONGEST_NAME, faults);
    let scene = scene(&fields, resolve, faults);
    let grid = candidates(&fields, faults);
    let layouts = layouts(&fields, faults);
    let method = method(&fields, faults);
    let level = accuracy(&fields, scene.as_ref(), faults);
    let nodes = method
        .as_ref()
        .map_or(Method::default().nodes, |method| method.nodes);
    let inputs = read_inputs(&fields, scene.as_ref(), nodes, faults);
    let (mut scene, level) = (scene?, level?);
    scene.model.level = level;
    let study = Study {
        name: name?,
        scene,
        inputs: inputs?,
        grid: grid?,
        layouts: layouts?,
        method: method?,
        level,
    };
    // Ends of single inputs are checked with the inputs; their combinations only here.
    if faults.is_empty() {
        check_plan(&study, faults);
    }
    Some(study)
}

fn check_plan(study: &Study, faults: &mut Vec<Fault>) {
    match Plan::new(study) {
        Ok(plan) => check_map(study, plan.points.len(), faults),
        Err(PlanError::Design(error)) => Fault::add(faults, "/inputs", error.to_string()),
        Err(error @ PlanError::Point { .. }) => {
            let detail = format!("the inputs together leave the ranges of the scene: {error}");
            Fault::add(faults, "/inputs", detail);
        }
    }
}

fn check_map(study: &Study, points: usize, faults: &mut Vec<Fault>) {
    let cells = study
        .grid
        .map_or(0, |grid| grid.circumferential * grid.meridional);
    let strains = 2 * cells * points;
    if strains > MOST_MAP_STRAINS {
        let detail = format!(
            "this map has {strains} strains over the study's {points} points; at most {MOST_MAP_STRAINS} are kept"
        );
        Fault::add(faults, "/candidates/grid", detail);
    }
}

fn scene(fields: &Fields<'_>, resolve: Resolve<'_>, faults: &mut Vec<Fault>) -> Option<Scene> {
    let what = "a path, a table, or { preset = \"foot-tire\" }";
    let (value, pointer) = fields.required("scene", what, faults)?;
    match value {
        Value::String(path) => scene_file(path, &pointer, resolve, faults),
        Value::Object(object) if object.contains_key("preset") => {
            let names = PRESETS.map(|(name, _)| (name, name));
            let name = choice(
                &object["preset"],
                &member(&pointer, "preset"),
                &names,
                faults,
            )?;
            let mut overrides = object.clone();
            overrides.shift_remove("preset");
            Scene::preset(name)?.overlaid(&overrides, &pointer, faults)
        }
        Value::Object(_) => Scene::from_value(value, &pointer, faults),
        other => {
            Fault::add(
                faults,
                &pointer,
                format!("must be {what}; it is {}", shown(other)),
            );
            None
        }
    }
}

fn scene_file(
    path: &str,
    pointer: &str,
    resolve: Resolve<'_>,
    faults: &mut Vec<Fault>,
) -> Option<Scene> {
    let text = match resolve(path) {
        Ok(text) => text,
        Err(detail) => {
            Fault::add(faults, pointer, detail);
            return None;
        }
    };
    let name = path.escape_debug();
    match Scene::from_text(&text, Format::of_path(path)) {
        Ok(scene) => Some(scene),
        Err(found) => {
            for fault in found {
                let at = format!("{pointer}{}", fault.pointer);
                Fault::add(faults, &at, format!("in {name}: {}", fault.detail));
            }
            None
        }
    }
}

/// The dense map; Some(None) when the study asks for none.
fn candidates(fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Option<Option<Grid>> {
    let Some((value, pointer)) = fields.get("candidates") else {
        return Some(None);
    };
    let fields = Fields::open(value, &pointer, &["points", "grid"], faults)?;
    fields.choice("points", &[("P1-P5", ())], (), faults);
    let Some((value, pointer)) = fields.get("grid") else {
        return Some(None);
    };
    let known = ["circumferential", "meridional", "half_width_deg"];
    let fields = Fields::open(value, &pointer, &known, faults)?;
    let circumferential = grid_points(&fields, "circumferential", faults);
    let meridional = grid_points(&fields, "meridional", faults);
    let half_width = fields.number("half_width_deg", HALF_WIDTH, DEFAULT_HALF_WIDTH_DEG, faults);
    Some(Some(Grid {
        circumferential: circumferential?,
        meridional: meridional?,
        half_width_deg: half_width?,
    }))
}

fn grid_points(fields: &Fields<'_>, name: &str, faults: &mut Vec<Fault>) -> Option<usize> {
    let what = format!("an odd number of points, 3 to {MOST_GRID_POINTS}");
    fields.required(name, &what, faults)?;
    let points = fields.integer(name, (3, MOST_GRID_POINTS), 3, faults)?;
    if points.is_multiple_of(2) {
        let detail = format!("must be odd, so that a point lies in the middle; it is {points}");
        Fault::add(faults, &fields.at(name), detail);
    }
    Some(points as usize)
}

fn layouts(fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Option<Layouts> {
    let mut layouts = Layouts::default();
    let Some((value, pointer)) = fields.get("layouts") else {
        return Some(layouts);
    };
    let fields = Fields::open(value, &pointer, &["spacings_deg", "positions"], faults)?;
    // Both lists are read before the first fault ends it.
    let spacings = fields
        .get("spacings_deg")
        .map(|(value, pointer)| list(value, &pointer, MOST_SPACINGS, faults, spacing));
    let positions = fields.get("positions").map(|(value, pointer)| {
        list(
            value,
            &pointer,
            POSITIONS.len(),
            faults,
            |value, at, faults| choice(value, at, &POSITIONS, faults),
        )
    });
    if let Some(spacings) = spacings {
        layouts.spacings_deg = spacings?;
    }
    if let Some(positions) = positions {
        layouts.positions = positions?;
    }
    Some(layouts)
}

fn spacing(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<f64> {
    let spacing = number(value, pointer, SPACING, faults)?;
    let units = 360.0 / spacing;
    // A spacing such as 51.428571428571 for sevenths of a turn is meant to divide it.
    if (units - units.round()).abs() > 1e-9 * units {
        let detail = format!("must divide 360 degrees into whole units; {spacing} gives {units}");
        Fault::add(faults, pointer, detail);
        return None;
    }
    Some(360.0 / units.round())
}

/// Reads a list whose entries differ; all entries are read before the first fault ends it.
fn list<T: PartialEq>(
    value: &Value,
    pointer: &str,
    longest: usize,
    faults: &mut Vec<Fault>,
    read: impl Fn(&Value, &str, &mut Vec<Fault>) -> Option<T>,
) -> Option<Vec<T>> {
    let Some(items) = value.as_array().filter(|items| items.len() <= longest) else {
        let detail = format!(
            "must be a list of at most {longest} entries; it is {}",
            shown(value)
        );
        Fault::add(faults, pointer, detail);
        return None;
    };
    let mut read_items = Vec::new();
    for (i, item) in items.iter().enumerate() {
        let at = entry(pointer, i);
        let Some(item) = read(item, &at, faults) else {
            continue;
        };
        if read_items.contains(&item) {
            Fault::add(faults, &at, "is in the list already");
        }
        read_items.push(item);
    }
    (read_items.len() == items.len()).then_some(read_items)
}

fn method(fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Option<Method> {
    let default = Method::default();
    let Some((value, pointer)) = fields.get("method") else {
        return Some(default);
    };
    let known = ["kind", "nodes", "check_points", "seed"];
    let fields = Fields::open(value, &pointer, &known, faults)?;
    let kind = fields
        .get("kind")
        .map_or(Some(default.kind), |(value, pointer)| {
            method_kind(value, &pointer, faults)
        });
    let nodes = fields.integer("nodes", NODES, default.nodes as u64, faults);
    let checks = fields.integer(
        "check_points",
        CHECK_POINTS,
        default.check_points as u64,
        faults,
    );
    let seed = fields.integer("seed", (0, u64::MAX), default.seed, faults);
    Some(Method {
        kind: kind?,
        nodes: nodes? as usize,
        check_points: checks? as usize,
        seed: seed?,
    })
}

fn method_kind(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<MethodKind> {
    let planned = ["bivariate", "tensor", "pce", "saltelli", "auto"];
    match value.as_str() {
        Some("mdrm") => Some(MethodKind::Mdrm),
        Some(name) if planned.contains(&name) => {
            let detail = format!("this version has only \"mdrm\"; \"{name}\" isn't available yet");
            Fault::add(faults, pointer, detail);
            None
        }
        _ => choice(value, pointer, &[("mdrm", MethodKind::Mdrm)], faults),
    }
}

/// The mesh level: the preset's, or the scene's own when the study doesn't ask.
fn accuracy(fields: &Fields<'_>, scene: Option<&Scene>, faults: &mut Vec<Fault>) -> Option<Level> {
    let default = scene.map_or(Level::Standard, |scene| scene.model.level);
    let Some((value, pointer)) = fields.get("accuracy") else {
        return Some(default);
    };
    let known = ["preset", "tolerance", "budget_s"];
    let fields = Fields::open(value, &pointer, &known, faults)?;
    let presets = alternatives(Level::NAMES.iter().map(|(name, _)| *name));
    for name in ["tolerance", "budget_s"] {
        if fields.get(name).is_some() {
            let detail = format!(
                "this version doesn't choose the model by {name}; set preset to {presets} instead"
            );
            Fault::add(faults, &fields.at(name), detail);
        }
    }
    if known.iter().all(|name| fields.get(name).is_none()) {
        let detail = format!(
            "must hold exactly one of {}; preset is {presets}",
            known.join(", ")
        );
        Fault::add(faults, &pointer, detail);
    }
    fields.choice("preset", &Level::NAMES, default, faults)
}
