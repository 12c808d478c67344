//! Inputs of a model that others run, with the values of its outputs so far: what `/v1/analyses` is sent.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::Fault;
use document::fields::Fields;
use document::json_schema::{Properties, Schemas};
use gsa::method::Kind;
use serde_json::{Value, json};

use crate::own_model::inputs_document::{self, Inputs};
use crate::own_model::listed_values::{self, listed_schema};
use crate::own_model::value_table::ValueTable;
use crate::study::method_reader::Limits;

/// Most points of one analysis: `strainsite gsa` takes more.
const MOST_POINTS: usize = 20_000;
/// Most numbers of its points, and of their values.
const MOST_NUMBERS: usize = 1_000_000;
/// Limits of the method.
const LIMITS: Limits = Limits {
    name: "AnalysisMethod",
    usual: Kind::Auto,
    nodes: gsa::law::rule::MAX_NODES as u64,
    check_points: MOST_POINTS as u64,
    samples: MOST_POINTS as u64,
    runs: MOST_POINTS as u64,
};

/// Analysis that is asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct AskedAnalysis {
    /// Inputs and method.
    pub inputs: Inputs,
    /// Values so far; none of them at first.
    pub values: ValueTable,
}

impl AskedAnalysis {
    /// Reads a document with `inputs`, `method` (`auto` when left out) and `values`: the text of a CSV file, or lists.
    ///
    /// # Errors
    /// Every fault of inputs and method; where they have none, every fault of the values.
    pub fn from_value(mut document: Value) -> Result<Self, Vec<Fault>> {
        // Taken out, so that a long text isn't copied.
        let values = document.get_mut("values").map(Value::take);
        let mut faults = Vec::new();
        let fields = Fields::open(&document, "", &["inputs", "method", "values"], &mut faults);
        let inputs = fields.and_then(|fields| inputs_document::read(&fields, LIMITS, &mut faults));
        let inputs = inputs.filter(|_| faults.is_empty()).ok_or(faults)?;
        check_size(&inputs)?;
        let values = read_values(values, &inputs).map_err(of_values)?;
        Ok(Self { inputs, values })
    }
}

/// Faults of the values, with their place in the document.
pub(super) fn of_values(mut faults: Vec<Fault>) -> Vec<Fault> {
    for fault in &mut faults {
        fault.pointer.insert_str(0, "/values");
    }
    faults
}

/// Refuses designs that the service has no time for.
fn check_size(Inputs { names, method, .. }: &Inputs) -> Result<(), Vec<Fault>> {
    let first = method.first_points(names.len());
    let most = match method.kind.is_adaptive() {
        true => first.max(method.most_runs),
        false => first,
    };
    if first <= MOST_POINTS && most.saturating_mul(names.len()) <= MOST_NUMBERS {
        return Ok(());
    }
    let detail = format!(
        "asks for up to {most} points of {} inputs; at most {MOST_POINTS} points and {MOST_NUMBERS} numbers are planned here: ask for fewer, or use strainsite gsa on a machine of your own",
        names.len()
    );
    Err(vec![Fault {
        pointer: "/method".to_owned(),
        detail,
    }])
}

fn read_values(values: Option<Value>, inputs: &Inputs) -> Result<ValueTable, Vec<Fault>> {
    match values {
        None => Ok(ValueTable::empty()),
        Some(Value::String(text)) => {
            // Before rows are made of it, each of which takes a multiple of its text.
            let (lines, cells) = (count(&text, b'\n'), count(&text, b','));
            if lines > 2 * MOST_POINTS || cells > MOST_NUMBERS {
                let detail = format!(
                    "has {lines} lines and {cells} cells; a file of values has at most {MOST_POINTS} points and {MOST_NUMBERS} values here"
                );
                return Err(vec![Fault {
                    pointer: String::new(),
                    detail,
                }]);
            }
            ValueTable::of_model(&text, &inputs.names)
        }
        Some(lists) => listed_values::read(&lists),
    }
}

fn count(text: &str, byte: u8) -> usize {
    text.bytes().filter(|other| *other == byte).count()
}

/// The schema of such a document.
pub fn analysis_schema(schemas: &mut Schemas) -> Value {
    schemas.define("Analysis", |schemas| {
        let mut analysis = Properties::default();
        inputs_document::describe(&mut analysis, LIMITS, schemas);
        let text = json!({"type": "string", "description": "CSV as `strainsite gsa analyse` reads it: the header `id,<output names>`, then a row a point; empty or `nan` where a run failed. Digits that aren't there count as rounded."});
        let values = json!({"oneOf": [text, listed_schema(schemas)]});
        let doc = "Values of the outputs so far.";
        analysis.add("values", doc, values, None, false);
        analysis.table("Inputs of a model of your own, and the values of its outputs so far.")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inputs(count: usize) -> Value {
        let law = json!({"kind": "uniform", "min": 0, "max": 1});
        (0..count)
            .map(|k| json!({"name": format!("x{k}"), "distribution": law}))
            .collect()
    }

    fn places(document: Value) -> Vec<String> {
        let faults = AskedAnalysis::from_value(document).unwrap_err();
        faults.into_iter().map(|fault| fault.pointer).collect()
    }

    #[test]
    fn values_are_a_file_or_lists_or_nothing_yet() {
        let read = |document| AskedAnalysis::from_value(document).unwrap();
        let first = read(json!({"inputs": inputs(2)}));
        assert_eq!(
            (first.inputs.method.kind, first.values.points()),
            (Kind::Auto, 0)
        );
        let file = read(json!({"inputs": inputs(2), "values": "id,y\n0,0.5\n"}));
        let lists = json!({"outputs": ["y"], "rows": [[0.5]]});
        let lists = read(json!({"inputs": inputs(2), "values": lists}));
        assert_eq!(file.values.leading_rows(), lists.values.leading_rows());
        // Of a file the digits count that are there.
        assert_eq!(
            (file.values.half_units()[0], lists.values.half_units()[0]),
            (0.05, 0.0)
        );
    }

    #[test]
    fn faults_have_their_places_and_sizes_their_bounds() {
        let faulty = json!({"inputs": [{"name": "a"}], "method": {"nodes": 0}, "value": 1});
        let found = places(faulty);
        for place in ["/inputs/0/distribution", "/method/nodes", "/value"] {
            assert!(found.iter().any(|other| other == place), "{found:?}");
        }
        let valued = |values: Value| json!({"inputs": inputs(2), "values": values});
        assert_eq!(places(valued("id,y\n0,x\n".into())), ["/values"]);
        assert_eq!(
            places(valued(json!({"outputs": ["y"], "rows": [[true]]}))),
            ["/values/rows/0/0"]
        );
        assert_eq!(places(valued(json!(3))), ["/values"]);
        assert_eq!(
            places(valued("\n".repeat(2 * MOST_POINTS + 1).into())),
            ["/values"]
        );
        assert_eq!(places(json!({"inputs": inputs(2000)})), ["/method"]);
        let large = json!({"kind": "saltelli", "samples": 9000});
        assert_eq!(
            places(json!({"inputs": inputs(2), "method": large})),
            ["/method"]
        );
    }
}
