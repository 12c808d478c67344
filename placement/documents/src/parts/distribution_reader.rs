//! Reads the distribution of an input: a kind, its parameters and, for any of them, `truncate = [low, high]`.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, entry};
use document::fields::{Fields, Range, alternatives, number, shown};
use document::json_schema::{Properties, Schemas};
use gsa::law::catalogue::{KINDS, Kind, Parameter};
use gsa::law::distribution::{Distribution, DistributionError};
use serde_json::{Map, Value, json};

/// Parameters of any law; no field of a scene goes beyond 1e9.
const PARAMETER: Range = Range::new(-1e12, 1e12, "");

/// Reads a distribution. None after a fault; all faults are added, each under the parameter it is about.
pub(crate) fn read_distribution(
    value: &Value,
    pointer: &str,
    faults: &mut Vec<Fault>,
) -> Option<Distribution> {
    let kind = read_kind(value, pointer, faults)?;
    let parameters = kind.parameters();
    let names = parameters.iter().map(|parameter| parameter.name);
    let known: Vec<&str> = ["kind"]
        .into_iter()
        .chain(names)
        .chain(["truncate"])
        .collect();
    let before = faults.len();
    let fields = Fields::open(value, pointer, &known, faults)?;
    let values: Vec<f64> = parameters
        .iter()
        .filter_map(|parameter| read_parameter(&fields, parameter, faults))
        .collect();
    let bounds = fields
        .get("truncate")
        .map(|(value, pointer)| read_bounds(value, &pointer, faults));
    let law = if values.len() == parameters.len() {
        kind.distribution(&values)
    } else {
        Err(Vec::new())
    };
    let mut add = |error: DistributionError| {
        let pointer = error
            .parameter()
            .map_or(pointer.to_owned(), |name| fields.at(name));
        Fault::add(faults, &pointer, error.to_string());
    };
    let law = match (law, bounds.flatten()) {
        (Ok(law), Some([low, high])) => law.truncated(low, high).map_err(|error| vec![error]),
        (law, _) => law,
    };
    let law = law
        .map_err(|errors| errors.into_iter().for_each(&mut add))
        .ok();
    law.filter(|_| faults.len() == before)
}

/// Writes a distribution as in a document.
pub fn distribution_value(law: &Distribution) -> Value {
    let mut value = Map::new();
    value.insert("kind".to_owned(), law.kind().into());
    let parameters = law.parameters().into_iter();
    value.extend(parameters.map(|(name, x)| (name.to_owned(), x.into())));
    if let Some((low, high)) = law.truncation() {
        value.insert("truncate".to_owned(), json!([low, high]));
    }
    Value::Object(value)
}

/// The schema of a distribution: each kind with its parameters.
pub(crate) fn distribution_schema(schemas: &mut Schemas) -> Value {
    schemas.define("Distribution", |_| {
        let mut properties = Properties::default();
        for kind in KINDS {
            let mut own = Properties::default();
            for parameter in kind.parameters() {
                let schema = if parameter.positive {
                    json!({"type": "number", "exclusiveMinimum": 0, "maximum": PARAMETER.high})
                } else {
                    PARAMETER.schema()
                };
                match parameter.default {
                    Some(default) => {
                        own.add(parameter.name, "", schema, Some(default.into()), false);
                    }
                    None => own.add_required(parameter.name, "", schema),
                }
            }
            properties.add_kind("kind", kind.name(), "", own, false);
        }
        let bounds =
            json!({"type": "array", "minItems": 2, "maxItems": 2, "items": PARAMETER.schema()});
        properties.add("truncate", "Lower and upper bound.", bounds, None, false);
        properties.table("A law of an input.")
    })
}

fn read_kind(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<&'static Kind> {
    let names = alternatives(KINDS.iter().map(Kind::name));
    let Value::Object(object) = value else {
        let detail = format!(
            "must be a table with a kind, {names}; it is {}",
            shown(value)
        );
        Fault::add(faults, pointer, detail);
        return None;
    };
    let found = object.get("kind");
    let kind = found.and_then(Value::as_str).and_then(Kind::named);
    if kind.is_none() {
        let detail = match found {
            Some(kind) => format!("must be {names}; it is {}", shown(kind)),
            None => format!("is missing; it is {names}"),
        };
        Fault::add(faults, &format!("{pointer}/kind"), detail);
    }
    kind
}

fn read_parameter(
    fields: &Fields<'_>,
    parameter: &Parameter,
    faults: &mut Vec<Fault>,
) -> Option<f64> {
    let found = match parameter.default {
        Some(default) => fields.number(parameter.name, PARAMETER, default, faults),
        None => {
            fields.required(parameter.name, "a number", faults)?;
            fields.number(parameter.name, PARAMETER, 0.0, faults)
        }
    }?;
    match parameter.fault(found) {
        Some(fault) => {
            Fault::add(faults, &fields.at(parameter.name), fault.to_string());
            None
        }
        None => Some(found),
    }
}

fn read_bounds(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<[f64; 2]> {
    let Some([low, high]) = value.as_array().map(Vec::as_slice) else {
        let detail = format!(
            "must be a list of two numbers, the lower bound first; it is {}",
            shown(value)
        );
        Fault::add(faults, pointer, detail);
        return None;
    };
    let low = number(low, &entry(pointer, 0), PARAMETER, faults);
    let high = number(high, &entry(pointer, 1), PARAMETER, faults);
    let (low, high) = (low?, high?);
    if low < high {
        return Some([low, high]);
    }
    let fault = DistributionError::EmptyTruncation { low, high };
    Fault::add(faults, pointer, fault.to_string());
    None
}
