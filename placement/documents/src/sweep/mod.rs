//! Designs of one study: its document with some fields set otherwise.
//!
//! A design is a study like any other; what it shares with others is in the archive by content. A field is named by its path, as in
//! `geometry.wall_mm` for the scene's and `method.nodes` for the study's own.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

mod design_draft;
pub mod sweep_schema;
mod typed;

use std::collections::HashMap;

use document::fault::{Fault, member};
use document::fields::Fields;
use document::visible::visible;
use fem_client::scene::edit::put_in;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use serde_json::{Map, Value, json};

use design_draft::{DesignDraft, field_of, name, names, of_grid, of_list};
pub use design_draft::{MOST_DESIGNS, MOST_SUBMITTED};
pub use typed::{typed_grid, typed_settings};

use crate::parts::scene_reader::Resolve;
use crate::study::plan::PlannedStudy;
use crate::study::study_fields::FIELDS;
use crate::study::study_reader::LONGEST_NAME;
use crate::study::{Study, sha256_hex};
use document::typed::field_value::read_name;

/// Solves that designs ask for at first, in the mean of as many as there may be: each is planned before anything is stored.
const MOST_SOLVES_EACH: usize = 40;
/// Designs that are read side by side before their faults are looked at.
const READ_TOGETHER: usize = 256;

/// Whether a path leads into the study's document, and not into its scene. A design has a name of its own.
fn is_of_study(path: &str) -> bool {
    let step = first_step(path);
    FIELDS.contains(&step) && !["name", "scene"].contains(&step)
}

/// A design of the sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// Name that tells it from the others, as `wall_mm = 2.5`.
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
    /// Designs, at least one; no two are the same study.
    pub designs: Vec<Design>,
}

impl Sweep {
    /// Reads a sweep from a parsed document: `study`, and `grid` (lists of values by path, of which every combination is a design, the last path
    /// varying fastest) or `designs` (a list of `set`, values by path, each with a `name` if wanted), `most` designs at most.
    ///
    /// # Errors
    /// Every fault of the document.
    pub fn from_value(
        value: &Value,
        most: usize,
        resolve: Resolve<'_>,
    ) -> Result<Self, Vec<Fault>> {
        let mut faults = Vec::new();
        let known = ["name", "study", "grid", "designs"];
        let sweep = Fields::open(value, "", &known, &mut faults)
            .and_then(|fields| read(&fields, most, resolve, &mut faults));
        match sweep {
            Some(sweep) if faults.is_empty() => Ok(sweep),
            _ => Err(faults),
        }
    }
}

fn read(
    fields: &Fields<'_>,
    most: usize,
    resolve: Resolve<'_>,
    faults: &mut Vec<Fault>,
) -> Option<Sweep> {
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
    with_designs(base, fields, most, faults)
}

fn with_designs(
    base: Study,
    fields: &Fields<'_>,
    most: usize,
    faults: &mut Vec<Fault>,
) -> Option<Sweep> {
    let name = name(fields, faults);
    let designs = read_designs(&base, fields, most, faults);
    let (name, designs) = (name?.unwrap_or_else(|| base.name.clone()), designs?);
    Some(Sweep {
        name,
        base,
        designs,
    })
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
        .and_then(|fields| with_designs(base, &fields, MOST_DESIGNS, &mut faults));
    match sweep {
        Some(sweep) if faults.is_empty() => Ok(sweep),
        _ => Err(faults),
    }
}

/// Reads further designs of a study, `most` at most: a document with `grid` or `designs`.
///
/// # Errors
/// Every fault of the document.
pub fn designs_of(base: &Study, value: &Value, most: usize) -> Result<Vec<Design>, Vec<Fault>> {
    let mut faults = Vec::new();
    let designs = Fields::open(value, "", &["grid", "designs"], &mut faults)
        .and_then(|fields| read_designs(base, &fields, most, &mut faults));
    match designs {
        Some(designs) if faults.is_empty() => Ok(designs),
        _ => Err(faults),
    }
}

/// A study with some fields set otherwise, by path as in a design. Where no name is set, it gets one that says what differs.
///
/// # Errors
/// Every fault of the values, at `/set/` and their path.
pub fn changed(
    mut base: PlannedStudy,
    mut set: Map<String, Value>,
) -> Result<PlannedStudy, Vec<Fault>> {
    let mut faults = Vec::new();
    base.study.name = match set.shift_remove("name") {
        Some(name) => {
            let named = json!({"name": name});
            let fields = Fields::open(&named, "/set", &["name"], &mut faults);
            let name = fields.and_then(|f| read_name(&f, "name", LONGEST_NAME, &mut faults));
            name.unwrap_or(base.study.name)
        }
        None => name_of_changed(&base.study.name, &set),
    };
    if set.is_empty() {
        return if faults.is_empty() {
            Ok(base)
        } else {
            Err(faults)
        };
    }
    let base = base.study;
    let list = json!([{"name": base.name, "set": set}]);
    let draft = of_list(&list, "", 1, &mut faults).and_then(|mut drafts| drafts.pop());
    let planned = draft.and_then(|draft| {
        let planned = planned_design(&base, &draft, &base.name);
        planned
            .map_err(|found| blame_all(&draft, &base.name, &found, &mut faults))
            .ok()
    });
    match planned {
        Some(mut planned) if faults.is_empty() => {
            planned.study.name = base.name;
            Ok(planned)
        }
        _ => Err(faults.into_iter().map(of_setting).collect()),
    }
}

/// `foot tire · scene.geometry.wall_mm = 5`: what was set stands behind the name, with its whole path; the name alone where nothing was. Cut where it is too long.
fn name_of_changed(name: &str, set: &Map<String, Value>) -> String {
    let change = |(path, value): (&String, &Value)| {
        let field = field_of(path);
        let of_scene = match is_of_study(field) {
            true => "",
            false => "scene.",
        };
        let value = match value {
            Value::String(text) => text.clone(),
            other => other.to_string(),
        };
        format!("{of_scene}{field} = {value}")
    };
    let changes: Vec<String> = set.iter().map(change).collect();
    let full = match changes.is_empty() {
        true => name.to_owned(),
        false => format!("{name} · {}", visible(&changes.join(", "))),
    };
    full.chars().take(LONGEST_NAME).collect()
}

/// Moves a fault of the only design in a list to its setting: its place there tells nothing.
fn of_setting(fault: Fault) -> Fault {
    let pointer = fault.pointer.strip_prefix("/0").unwrap_or(&fault.pointer);
    Fault {
        pointer: pointer.to_owned(),
        ..fault
    }
}

fn read_designs(
    base: &Study,
    fields: &Fields<'_>,
    most: usize,
    faults: &mut Vec<Fault>,
) -> Option<Vec<Design>> {
    let drafts = match (fields.get("grid"), fields.get("designs")) {
        (Some((grid, pointer)), None) => of_grid(grid, &pointer, most, faults)?,
        (None, Some((list, pointer))) => of_list(list, &pointer, most, faults)?,
        _ => {
            let detail = "must hold exactly one of grid and designs: {\"geometry.wall_mm\": [2.5, 3]} as grid, or \
                          [{\"set\": {\"geometry.wall_mm\": 2.5}}] as designs";
            Fault::add(faults, "", detail);
            return None;
        }
    };
    let names = names(&drafts);
    let named: Vec<(DesignDraft, String)> = drafts.into_iter().zip(names).collect();
    let mut read = ReadDesigns::of_at_most(most);
    for some in named.chunks(READ_TOGETHER) {
        // Plans are let go: those of all designs together would be large.
        let study = |(draft, name): &(DesignDraft, String)| {
            planned_design(base, draft, name).map(|planned| planned.study)
        };
        let studies: Vec<Result<Study, Vec<Fault>>> = some.par_iter().map(study).collect();
        for ((draft, name), study) in some.iter().zip(studies) {
            // Thousands may have one fault in common.
            if Fault::are_enough(faults) {
                return None;
            }
            match study {
                Ok(study) => read.add(draft, name, study, faults)?,
                Err(found) => blame_all(draft, name, &found, faults),
            }
        }
    }
    Some(read.designs)
}

/// Designs that were read so far.
struct ReadDesigns {
    designs: Vec<Design>,
    solves: usize,
    most_solves: usize,
    /// Place in the document of each, by the hash of all but its name.
    seen: HashMap<String, String>,
}

impl ReadDesigns {
    fn of_at_most(designs: usize) -> Self {
        Self {
            designs: Vec::new(),
            solves: 0,
            most_solves: MOST_SOLVES_EACH * designs,
            seen: HashMap::new(),
        }
    }

    /// Adds a design; nothing where those so far ask for too much.
    fn add(
        &mut self,
        draft: &DesignDraft,
        name: &str,
        study: Study,
        faults: &mut Vec<Fault>,
    ) -> Option<()> {
        let own = study.method.first_points(study.inputs.len());
        self.solves = self.solves.saturating_add(own);
        if self.solves > self.most_solves && !self.designs.is_empty() {
            let most = self.most_solves;
            let detail = format!("the designs ask for more than {most} solves together");
            Fault::add(faults, &draft.pointer, detail);
            return None;
        }
        let document = sha256_hex(&nameless(&study));
        if let Some(twin) = self.seen.insert(document, draft.pointer.clone()) {
            let detail = format!("is the same design as that of {twin}");
            Fault::add(faults, &draft.pointer, detail);
        }
        self.designs.push(Design {
            name: name.to_owned(),
            set: draft.set.clone(),
            study,
        });
        Some(())
    }
}

/// Canonical document of a study without its name: the same for the same design.
pub fn nameless(study: &Study) -> String {
    let nameless = Study {
        name: String::new(),
        ..study.clone()
    };
    nameless.canonical()
}

/// The study of a design, or the faults of its document.
fn planned_design(
    base: &Study,
    draft: &DesignDraft,
    name: &str,
) -> Result<PlannedStudy, Vec<Fault>> {
    let (of_study, of_scene): (Vec<_>, Vec<_>) = draft
        .set
        .iter()
        .map(|(path, value)| (field_of(path), value))
        .partition(|(path, _)| is_of_study(path));
    let mut found = Vec::new();
    let mut scene = base.scene.clone();
    if let Err(refused) = scene.set_all(&of_scene) {
        found.extend(refused);
    }
    let asked = draft.set.keys().any(|path| field_of(path) == "model.level");
    if asked || scene.model.level != base.scene.model.level {
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
    if !found.is_empty() {
        return Err(found);
    }
    let no_files = |path: &str| Err(format!("a design names the file {path:?}"));
    PlannedStudy::from_value(&document, &no_files)
}

fn first_step(path: &str) -> &str {
    path.split(['.', '[']).next().unwrap_or(path)
}

/// The base's name with the design's, cut where it is too long.
fn full_name(base: &Study, name: &str) -> String {
    let full = format!("{}: {name}", base.name);
    full.chars().take(LONGEST_NAME).collect()
}

/// Faults of a design's study, each told of the value that made it: once, however many designs of a grid share it.
fn blame_all(draft: &DesignDraft, name: &str, found: &[Fault], faults: &mut Vec<Fault>) {
    for fault in found {
        blame(draft, name, fault, faults);
    }
}

fn blame(draft: &DesignDraft, name: &str, fault: &Fault, faults: &mut Vec<Fault>) {
    let within = fault
        .pointer
        .strip_prefix("/scene")
        .unwrap_or(&fault.pointer);
    let culprit = draft.set.keys().zip(&draft.pointers).find(|(path, _)| {
        let of_path = as_pointer(field_of(path));
        within == of_path || within.starts_with(&format!("{of_path}/"))
    });
    let told = match culprit {
        Some((_, pointer)) => Fault {
            pointer: pointer.clone(),
            detail: fault.detail.clone(),
        },
        None => Fault {
            pointer: draft.pointer.clone(),
            detail: format!("the design {}: {fault}", visible(name)),
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
mod tests;
