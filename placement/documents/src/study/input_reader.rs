//! Reads the uncertain inputs of a study: their names, paths and distributions.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, entry};
use document::fields::{Fields, shown};
use document::json_schema::{Properties, Schemas};
use document::typed::field_value::Field;
use fem_client::scene::Scene;
use gsa::law::distribution::Distribution;
use serde_json::{Value, json};

use crate::parts::distribution_reader::{distribution_schema, read_distribution};
use crate::study::Input;
use document::typed::field_value::read_name;

/// Most inputs of a study.
const MOST_INPUTS: usize = 50;
/// Longest name of an input, characters.
const LONGEST_NAME: usize = 50;
/// Reads `inputs`. None after a fault.
pub(crate) fn read_inputs(
    fields: &Fields<'_>,
    scene: Option<&Scene>,
    nodes: usize,
    faults: &mut Vec<Fault>,
) -> Option<Vec<Input>> {
    let what = format!("a list of 1 to {MOST_INPUTS} tables");
    let (value, pointer) = fields.required("inputs", &what, faults)?;
    let fits = |items: &&Vec<Value>| (1..=MOST_INPUTS).contains(&items.len());
    let Some(items) = value.as_array().filter(fits) else {
        Fault::add(
            faults,
            &pointer,
            format!("must be {what}; it is {}", shown(value)),
        );
        return None;
    };
    let mut inputs: Vec<Input> = Vec::new();
    for (i, item) in items.iter().enumerate() {
        let at = entry(&pointer, i);
        inputs.extend(read_input(item, &at, scene, nodes, faults));
        for field in ["name", "vary"] {
            let twin = items
                .iter()
                .take(i)
                .position(|other| same_text(other, item, field));
            if let Some(twin) = twin {
                let detail = format!("is the same as that of /inputs/{twin}");
                Fault::add(faults, &format!("{at}/{field}"), detail);
            }
        }
    }
    (inputs.len() == items.len()).then_some(inputs)
}

/// The schema of `inputs`.
pub(crate) fn inputs_schema(schemas: &mut Schemas) -> Value {
    let input = schemas.define("Input", |schemas| {
        let mut properties = Properties::default();
        let name = String::schema(&LONGEST_NAME, schemas);
        properties.add_required("name", "Name, like no other's.", name);
        let path = json!({"type": "string", "examples": ["ground.depths_mm[0]"]});
        properties.add_required("vary", "Path of a number of the scene.", path);
        let law = distribution_schema(schemas);
        properties.add_required("distribution", "Distribution of its values.", law);
        properties.table("An uncertain field of the scene.")
    });
    json!({"type": "array", "minItems": 1, "maxItems": MOST_INPUTS, "items": input})
}

/// Whether two inputs have the same text in a field, spaces aside, whatever else is wrong with them.
pub(crate) fn same_text(a: &Value, b: &Value, field: &str) -> bool {
    let text = |input: &Value| Some(without_spaces(input.get(field)?.as_str()?));
    text(a).is_some() && text(a) == text(b)
}

fn without_spaces(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).collect()
}

fn read_input(
    value: &Value,
    pointer: &str,
    scene: Option<&Scene>,
    nodes: usize,
    faults: &mut Vec<Fault>,
) -> Option<Input> {
    let fields = Fields::open(value, pointer, &["name", "vary", "distribution"], faults)?;
    let name = read_name(&fields, "name", LONGEST_NAME, faults);
    let vary = vary(&fields, scene, faults);
    let distribution = fields
        .required(
            "distribution",
            "a table such as { kind = \"uniform\", min = 0.7, max = 1.3 }",
            faults,
        )
        .and_then(|(value, pointer)| read_distribution(value, &pointer, faults));
    let input = Input {
        name: name?,
        vary: vary?,
        distribution: distribution?,
    };
    if let Some(scene) = scene {
        check_support(&input, &fields.at("distribution"), scene, nodes, faults)?;
    }
    Some(input)
}

/// The path of a numeric field, without the spaces that a path may hold.
fn vary(fields: &Fields<'_>, scene: Option<&Scene>, faults: &mut Vec<Fault>) -> Option<String> {
    let (value, pointer) =
        fields.required("vary", "a path such as \"ground.depths_mm[0]\"", faults)?;
    let Some(path) = value.as_str() else {
        let detail = format!(
            "must be a path such as \"ground.depths_mm[0]\"; it is {}",
            shown(value)
        );
        Fault::add(faults, &pointer, detail);
        return None;
    };
    let path = without_spaces(path);
    let found = match scene {
        Some(scene) => scene.number_at(&path),
        // A faulty scene can't be asked; the shipped one has every field, if not as many entries in its lists.
        None => {
            Scene::preset("foot-tire").map_or(Ok(0.0), |scene| scene.number_at(&first_entry(&path)))
        }
    };
    match found {
        Err(fault) => {
            Fault::add(faults, &pointer, fault.detail);
            None
        }
        Ok(_) => Some(path),
    }
}

/// The path with the first entry of a list instead of any other.
fn first_entry(path: &str) -> String {
    match path.split_once('[') {
        Some((list, index))
            if index
                .strip_suffix(']')
                .is_some_and(|i| i.parse::<usize>().is_ok()) =>
        {
            format!("{list}[0]")
        }
        _ => path.to_owned(),
    }
}

/// The ends of what is put into the scene must be scenes. A law without stated ends is judged by its outermost nodes.
fn check_support(
    input: &Input,
    pointer: &str,
    scene: &Scene,
    nodes: usize,
    faults: &mut Vec<Fault>,
) -> Option<()> {
    let rule = match input.distribution.gauss_rule(nodes) {
        Ok(rule) => rule,
        Err(error) => {
            Fault::add(faults, pointer, error.to_string());
            return None;
        }
    };
    let stated = stated_ends(&input.distribution);
    let (low, high) = input.distribution.support();
    let mut good = Some(());
    for (end, node) in [(low, rule.nodes.first()), (high, rule.nodes.last())] {
        let (end, which) = match node {
            _ if stated.contains(&end) => (end, "its end"),
            Some(&node) => (node, "its outermost node"),
            None => continue,
        };
        if let Err(fault) = scene.clone().set(&input.vary, &Value::from(end)) {
            let detail = format!(
                "{which} {end} is outside what {} takes: {}",
                input.vary, fault.detail
            );
            Fault::add(faults, pointer, detail);
            good = None;
        }
    }
    good
}

/// Ends that the document gives a law. Others, infinite or the zero of a positive law, are never reached.
fn stated_ends(law: &Distribution) -> Vec<f64> {
    let bounds = law
        .truncation()
        .into_iter()
        .flat_map(|(low, high)| [low, high]);
    let parameters = law.parameters().into_iter();
    let ends = parameters.filter(|(name, _)| ["min", "max"].contains(name));
    ends.map(|(_, x)| x).chain(bounds).collect()
}
