//! Drafts of designs, of a grid or a list, before a study is made of them.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::collections::{HashMap, HashSet};

use document::MAX_BYTES;
use document::fault::{Fault, entry, member};
use document::fields::{Fields, shown};
use document::visible::visible;
use serde_json::{Map, Value};

use crate::study::study_reader::LONGEST_NAME;
use document::typed::field_value::read_name;

/// Most designs of a sweep.
pub const MOST_DESIGNS: usize = 100_000;
/// Most designs of a document over HTTP, for whose answer a client waits: a design takes some milliseconds.
pub const MOST_SUBMITTED: usize = 10_000;
/// Most values that a design sets: a scene has fewer fields.
const MOST_SET: usize = 100;
/// Most bytes of the values of all designs, written out as JSON: a grid repeats each in many designs.
const MOST_BYTES: usize = 4 * MAX_BYTES;

/// A design before its study is made.
pub(super) struct DesignDraft {
    pub name: Option<String>,
    pub set: Map<String, Value>,
    /// Places of the values in the document, in their order.
    pub pointers: Vec<String>,
    /// Place of the design in the document.
    pub pointer: String,
}

/// The name that is given, if any; none after a fault.
pub(super) fn name(fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Option<Option<String>> {
    match fields.get("name") {
        None => Some(None),
        Some(_) => read_name(fields, "name", LONGEST_NAME, faults).map(Some),
    }
}

/// Every combination, the last path varying fastest. None after a fault.
pub(super) fn of_grid(
    grid: &Value,
    pointer: &str,
    most: usize,
    faults: &mut Vec<Fault>,
) -> Option<Vec<DesignDraft>> {
    let Some(table) = grid.as_object().filter(|table| !table.is_empty()) else {
        let what = "a table with a list of values for each path";
        let detail = format!("must be {what}; it is {}", shown(grid));
        Fault::add(faults, pointer, detail);
        return None;
    };
    let before = faults.len();
    let axes = table.iter().filter_map(|(path, values)| {
        let at = member(pointer, path);
        let list = values.as_array().filter(|values| !values.is_empty());
        if list.is_none() {
            let detail = format!("must be a list of values; it is {}", shown(values));
            Fault::add(faults, &at, detail);
        }
        list.map(|values| Axis { path, values, at })
    });
    let axes: Vec<Axis<'_>> = axes.collect();
    if let Some(detail) = too_much(&axes, most) {
        Fault::add(faults, pointer, detail);
    }
    refuse_twins(table, pointer, faults);
    (faults.len() == before).then(|| combinations(&axes, pointer).collect())
}

/// A field has two names, of which the later one would win.
fn refuse_twins(set: &Map<String, Value>, pointer: &str, faults: &mut Vec<Fault>) {
    let mut seen = HashSet::new();
    for path in set.keys().filter(|path| !seen.insert(field_of(path))) {
        let detail = format!("the field {} is set already", shown(&field_of(path).into()));
        Fault::add(faults, &member(pointer, path), detail);
    }
}

/// The field that a path names: `scene.` in front of it may be left out.
pub(super) fn field_of(path: &str) -> &str {
    let path = path.trim();
    path.strip_prefix("scene.").unwrap_or(path)
}

/// A path of a grid.
struct Axis<'g> {
    path: &'g String,
    values: &'g [Value],
    at: String,
}

/// Says why a grid asks for too much, when it does.
fn too_much(axes: &[Axis<'_>], most: usize) -> Option<String> {
    if axes.len() > MOST_SET {
        return Some(too_many_set());
    }
    let counts = axes.iter().map(|axis| axis.values.len());
    let designs = counts.fold(1, usize::saturating_mul);
    if designs > most {
        return Some(too_many(most));
    }
    let bytes = axes.iter().map(|axis| {
        let once: usize = axis.values.iter().map(bytes).sum();
        once.saturating_mul(designs / axis.values.len())
    });
    (bytes.sum::<usize>() > MOST_BYTES).then(|| {
        format!("the values of its {designs} designs are more than {MOST_BYTES} bytes together")
    })
}

fn bytes(value: &Value) -> usize {
    value.to_string().len()
}

fn combinations(axes: &[Axis<'_>], pointer: &str) -> impl Iterator<Item = DesignDraft> {
    let designs: usize = axes.iter().map(|axis| axis.values.len()).product();
    (0..designs).map(move |number| {
        let mut draft = DesignDraft {
            name: None,
            set: Map::new(),
            pointers: Vec::new(),
            pointer: pointer.to_owned(),
        };
        let mut stride = designs;
        for axis in axes {
            stride /= axis.values.len();
            let index = number / stride % axis.values.len();
            if let Some(value) = axis.values.get(index) {
                draft.set.insert(axis.path.clone(), value.clone());
                draft.pointers.push(entry(&axis.at, index));
            }
        }
        draft
    })
}

fn too_many(most: usize) -> String {
    let of = match most {
        MOST_DESIGNS => "of one sweep",
        _ => "at once; `strainsite sweep` takes more",
    };
    format!("these are more than {most} designs, the most {of}")
}

fn too_many_set() -> String {
    format!("a design sets at most {MOST_SET} values")
}

/// The designs one by one. None after a fault.
pub(super) fn of_list(
    list: &Value,
    pointer: &str,
    most: usize,
    faults: &mut Vec<Fault>,
) -> Option<Vec<DesignDraft>> {
    let Some(items) = list.as_array().filter(|items| !items.is_empty()) else {
        let detail = format!("must be a list of designs; it is {}", shown(list));
        Fault::add(faults, pointer, detail);
        return None;
    };
    if items.len() > most {
        Fault::add(faults, pointer, too_many(most));
        return None;
    }
    let drafts = items
        .iter()
        .enumerate()
        .filter_map(|(index, item)| of_item(item, entry(pointer, index), faults));
    let drafts: Vec<DesignDraft> = drafts.collect();
    (drafts.len() == items.len()).then_some(drafts)
}

fn of_item(item: &Value, pointer: String, faults: &mut Vec<Fault>) -> Option<DesignDraft> {
    let fields = Fields::open(item, &pointer, &["name", "set"], faults)?;
    let name = name(&fields, faults);
    let (set, within) = fields.required("set", "a table of values by path", faults)?;
    let Some(set) = set.as_object() else {
        let detail = format!("must be a table of values by path; it is {}", shown(set));
        Fault::add(faults, &within, detail);
        return None;
    };
    if set.len() > MOST_SET {
        Fault::add(faults, &within, too_many_set());
        return None;
    }
    let before = faults.len();
    refuse_twins(set, &within, faults);
    (faults.len() == before).then_some(DesignDraft {
        name: name?,
        set: set.clone(),
        pointers: set.keys().map(|path| member(&within, path)).collect(),
        pointer,
    })
}

/// The names that designs have, or else what they set: paths by their last step, where that tells them apart.
pub(super) fn names(drafts: &[DesignDraft]) -> Vec<String> {
    let last = |path: &str| path.rsplit('.').next().unwrap_or(path).to_owned();
    let mut paths: Vec<&String> = drafts.iter().flat_map(|draft| draft.set.keys()).collect();
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
    let named = |draft: &DesignDraft| {
        let texts: Vec<String> = draft
            .set
            .iter()
            .map(|(path, value)| match value {
                Value::String(text) => format!("{} = {text}", short(path)),
                other => format!("{} = {other}", short(path)),
            })
            .collect();
        match (&draft.name, texts.is_empty()) {
            (Some(name), _) => name.clone(),
            (None, true) => "unchanged".to_owned(),
            // As short and as harmless as a name that somebody gives.
            (None, false) => visible(&texts.join(", "))
                .chars()
                .take(LONGEST_NAME)
                .collect(),
        }
    };
    drafts.iter().map(named).collect()
}
