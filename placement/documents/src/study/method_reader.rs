//! Reads how indices are computed: the `method` table of studies and of input files.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::Fault;
use document::fields::{Fields, Range};
use document::json_schema::{Properties, Schemas};
use document::typed::field_value::Field;
use gsa::method::{Kind, Method};
use serde_json::{Value, json};

/// Limits of a method's settings, and what is usual.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Limits {
    /// Name of their schema.
    pub name: &'static str,
    /// Kind where none is said.
    pub usual: Kind,
    /// Most nodes per input.
    pub nodes: u64,
    /// Most check points.
    pub check_points: u64,
    /// Most points or base points.
    pub samples: u64,
    /// Most runs of an adaptive method.
    pub runs: u64,
}

/// Largest and smallest error of an index that may be asked for.
const TOLERANCE: Range = Range::new(1e-12, 1.0, "");

/// Reads `method`; what it leaves out has the defaults of its kind. None after a fault.
pub(crate) fn read_method(
    fields: &Fields<'_>,
    limits: Limits,
    faults: &mut Vec<Fault>,
) -> Option<Method> {
    let Some((value, pointer)) = fields.get("method") else {
        return Some(Method::of(limits.usual));
    };
    let known = [
        "kind",
        "nodes",
        "check_points",
        "samples",
        "seed",
        "tolerance",
        "most_runs",
    ];
    let fields = Fields::open(value, &pointer, &known, faults)?;
    let kinds = Kind::ALL.map(|kind| (kind.as_str(), kind));
    let kind = fields.choice("kind", &kinds, limits.usual, faults);
    let default = Method::of(kind.unwrap_or(limits.usual));
    let mut whole = |name: &str, low: u64, high: u64, default: usize| {
        fields
            .integer(name, (low, high), default as u64, faults)
            .map(|n| n as usize)
    };
    let nodes = whole("nodes", 1, limits.nodes, default.nodes);
    let check_points = whole("check_points", 0, limits.check_points, default.check_points);
    let samples = whole("samples", 2, limits.samples, default.samples);
    let most_runs = whole("most_runs", 1, limits.runs, default.most_runs);
    let seed = fields.integer("seed", (0, u64::MAX), default.seed, faults);
    let tolerance = fields.number("tolerance", TOLERANCE, default.tolerance, faults);
    Some(Method {
        kind: kind?,
        nodes: nodes?,
        check_points: check_points?,
        samples: samples?,
        seed: seed?,
        tolerance: tolerance?,
        most_runs: most_runs?,
    })
}

/// The schema of `method`; defaults are those of the kind that is usual.
pub(crate) fn method_schema(limits: Limits, schemas: &mut Schemas) -> Value {
    let usual = Method::of(limits.usual);
    schemas.define(limits.name, |schemas| {
        let mut properties = Properties::default();
        let kinds = json!({"type": "string", "enum": Kind::ALL.map(Kind::as_str)});
        let kind = Some(usual.kind.as_str().into());
        properties.add("kind", "Kind of method.", kinds, kind, false);
        let whole = [
            (
                "nodes",
                "Gauss nodes of each input.",
                (1, limits.nodes),
                usual.nodes,
            ),
            (
                "check_points",
                "Points off the lines, for the error.",
                (0, limits.check_points),
                usual.check_points,
            ),
            (
                "samples",
                "Points of pce, base points of saltelli.",
                (2, limits.samples),
                usual.samples,
            ),
            (
                "most_runs",
                "Most runs of auto.",
                (1, limits.runs),
                usual.most_runs,
            ),
        ];
        for (name, doc, within, default) in whole {
            let schema = usize::schema(&within, schemas);
            properties.add(name, doc, schema, Some(default.into()), false);
        }
        let seed = u64::schema(&(0, u64::MAX), schemas);
        properties.add(
            "seed",
            "Seed of what is random.",
            seed,
            Some(usual.seed.into()),
            false,
        );
        let doc = "Largest error of an index at which auto stops.";
        let tolerance = Some(usual.tolerance.into());
        properties.add("tolerance", doc, TOLERANCE.schema(), tolerance, false);
        properties.table("Method that computes the indices.")
    })
}
