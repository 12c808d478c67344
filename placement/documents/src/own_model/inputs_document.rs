//! The document of a model that others run: its uncertain inputs, and the method that asks for points.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, entry};
use document::fields::{Fields, shown};
use document::json_schema::{Properties, Schemas};
use document::typed::field_value::Field;
use document::{Format, parse};
use gsa::law::distribution::Distribution;
use gsa::method::{Kind, Method};
use serde_json::{Value, json};

use crate::parts::distribution_reader::{distribution_schema, read_distribution};
use crate::study::input_reader::same_text;
use crate::study::method_reader::{Limits, method_schema, read_method};
use document::typed::field_value::read_name;

/// Most inputs of a model that isn't ours.
const MOST_INPUTS: usize = 10_000;
/// Longest name of an input, characters.
const LONGEST_NAME: usize = 100;
/// Limits for models of others, which may be cheap.
const LIMITS: Limits = Limits {
    name: "ModelMethod",
    usual: Kind::Mdrm,
    nodes: gsa::law::rule::MAX_NODES as u64,
    check_points: gsa::design::MAX_CHECK_POINTS as u64,
    samples: gsa::design::MAX_CHECK_POINTS as u64,
    runs: 1_000_000,
};

/// Fields of the document.
pub(super) const FIELDS: [&str; 2] = ["inputs", "method"];

/// Inputs and method. Build it with [`Inputs::from_document`].
#[derive(Debug, Clone, PartialEq)]
pub struct Inputs {
    /// Unique names.
    pub names: Vec<String>,
    /// The law of each.
    pub laws: Vec<Distribution>,
    /// Asks for points and analyses their values.
    pub method: Method,
}

impl Inputs {
    /// Reads a document with `inputs` (each a name and a distribution) and, if it isn't the default, `method`.
    ///
    /// # Errors
    /// Every fault of the document.
    pub fn from_document(text: &str, format: Format) -> Result<Self, Vec<Fault>> {
        let value = parse(text, format)?;
        let mut faults = Vec::new();
        let fields = Fields::open(&value, "", &FIELDS, &mut faults);
        let read = fields.and_then(|fields| read(&fields, LIMITS, &mut faults));
        read.filter(|_| faults.is_empty()).ok_or(faults)
    }
}

/// Reads inputs and method from the fields of a document.
pub(super) fn read(fields: &Fields<'_>, limits: Limits, faults: &mut Vec<Fault>) -> Option<Inputs> {
    let method = read_method(fields, limits, faults);
    let what = format!("a list of 1 to {MOST_INPUTS} tables");
    let (value, pointer) = fields.required("inputs", &what, faults)?;
    let fits = |items: &&Vec<Value>| (1..=MOST_INPUTS).contains(&items.len());
    let Some(items) = value.as_array().filter(fits) else {
        let detail = format!("must be {what}; it is {}", shown(value));
        Fault::add(faults, &pointer, detail);
        return None;
    };
    let (mut names, mut laws) = (Vec::new(), Vec::new());
    for (i, item) in items.iter().enumerate() {
        let at = entry(&pointer, i);
        let Some(fields) = Fields::open(item, &at, &["name", "distribution"], faults) else {
            continue;
        };
        names.extend(read_name(&fields, "name", LONGEST_NAME, faults));
        let what = "a table such as { kind = \"uniform\", min = 0.7, max = 1.3 }";
        if let Some((value, pointer)) = fields.required("distribution", what, faults) {
            laws.extend(read_distribution(value, &pointer, faults));
        }
        let twin = items
            .iter()
            .take(i)
            .position(|other| same_text(other, item, "name"));
        if let Some(twin) = twin {
            let detail = format!("is the same as that of /inputs/{twin}");
            Fault::add(faults, &format!("{at}/name"), detail);
        }
    }
    Some(Inputs {
        names,
        laws,
        method: method?,
    })
}

/// The schema of such a document.
pub(crate) fn inputs_file_schema(schemas: &mut Schemas) -> Value {
    schemas.define("Inputs", |schemas| {
        let mut file = Properties::default();
        describe(&mut file, LIMITS, schemas);
        file.table("Inputs of a model that others run, and the method that asks for points.")
    })
}

/// Describes inputs and method among the fields of a document.
pub(super) fn describe(table: &mut Properties, limits: Limits, schemas: &mut Schemas) {
    let input = schemas.define("ModelInput", |schemas| {
        let mut input = Properties::default();
        let name = String::schema(&LONGEST_NAME, schemas);
        input.add_required("name", "Name, like no other's.", name);
        let law = distribution_schema(schemas);
        input.add_required("distribution", "Distribution of its values.", law);
        input.table("An input of the model.")
    });
    let inputs = json!({"type": "array", "minItems": 1, "maxItems": MOST_INPUTS, "items": input});
    table.add_required("inputs", "Inputs of the model.", inputs);
    let (method, doc) = (
        method_schema(limits, schemas),
        "Method that computes the indices.",
    );
    table.add("method", doc, method, None, false);
}

#[cfg(test)]
mod tests {
    use super::*;
    use gsa::method::Kind;

    fn read(text: &str) -> Result<Inputs, Vec<Fault>> {
        Inputs::from_document(text, Format::Toml)
    }

    #[test]
    fn inputs_and_method_are_read() {
        let found = read(
            "[[inputs]]\nname = 'a'\ndistribution = { kind = 'normal', mean = 1, std = 2 }\n\
             [[inputs]]\nname = 'b'\ndistribution = { kind = 'gumbel', location = 0, scale = 1 }\n\
             [method]\nkind = 'auto'\ntolerance = 0.01\nmost_runs = 300\n",
        )
        .unwrap();
        assert_eq!(found.names, ["a", "b"]);
        assert_eq!(found.laws[1].kind(), "gumbel");
        assert_eq!(found.method.kind, Kind::Auto);
        assert_eq!(
            (found.method.tolerance, found.method.most_runs),
            (0.01, 300)
        );
        assert_eq!(found.method.nodes, Method::of(Kind::Auto).nodes);
    }

    #[test]
    fn every_fault_is_named_with_its_place() {
        let faults = read(
            "colour = 1\n[[inputs]]\nname = 'a'\ndistribution = { kind = 'normal', mean = 1, std = -2 }\n\
             [[inputs]]\nname = 'a'\nvary = 'x'\n[method]\nkind = 'magic'\nnodes = 0\n",
        )
        .unwrap_err();
        let pointers: Vec<&str> = faults.iter().map(|fault| fault.pointer.as_str()).collect();
        for expected in [
            "/colour",
            "/inputs/0/distribution/std",
            "/inputs/1/vary",
            "/inputs/1/distribution",
            "/inputs/1/name",
            "/method/kind",
            "/method/nodes",
        ] {
            assert!(pointers.contains(&expected), "{expected} in {pointers:?}");
        }
    }
}
