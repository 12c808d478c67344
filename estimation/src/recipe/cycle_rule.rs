//! Rules for cycles.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::Value;
use document::fault::Fault;
use document::fields::{Fields, Map, Range};
use document::json_schema::{Properties, Schemas};
use document::typed::field_value::Field;
use document::typed::table_fields::Group;
use serde::{Deserialize, Serialize};

use super::column_names;

const SECONDS: Range = Range::new(1e-6, 1e9, "s");
const NEWTONS: Range = Range::new(1e-9, 1e9, "N");

/// Rule for what a cycle is: a press, a stroke, a stance.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum CycleRule {
    /// Rows with the same entry of this column, one after another.
    Column(String),
    /// Rows between pauses longer than this, s.
    PauseS(f64),
    /// Rows from one rise of the total force above this threshold to the next, N.
    ThresholdN(f64),
    /// Pieces of this length, s.
    BlockS(f64),
    /// Ten pieces a run, of equal length in time.
    #[default]
    Tenths,
}

/// A rule by a quantity: its name, range and doc, and what it makes of the value.
type QuantityRule = (&'static str, Range, &'static str, fn(f64) -> CycleRule);

const QUANTITIES: [QuantityRule; 3] = [
    (
        "pause_s",
        SECONDS,
        "Cycles are rows between pauses longer than this, s.",
        CycleRule::PauseS,
    ),
    (
        "threshold_n",
        NEWTONS,
        "A cycle goes from one rise of the total force above this threshold to the next, N.",
        CycleRule::ThresholdN,
    ),
    (
        "block_s",
        SECONDS,
        "Cycles are pieces of this length, s.",
        CycleRule::BlockS,
    ),
];
const CYCLE: &str = "cycle";

/// Reads four fields, of which one at most is given.
impl Group for CycleRule {
    fn names(_: &Value, _: &Self) -> Vec<&'static str> {
        let quantities = QUANTITIES.iter().map(|quantity| quantity.0);
        [CYCLE].into_iter().chain(quantities).collect()
    }

    fn read_fields(fields: &Fields<'_>, usual: Self, faults: &mut Vec<Fault>) -> Option<Self> {
        let mut rules = Vec::new();
        if let Some((value, at)) = fields.get(CYCLE) {
            let column = column_names::one::read(value, &at, faults);
            rules.extend(column.flatten().map(Self::Column));
        }
        for (name, range, _, rule) in QUANTITIES {
            if let Some((value, at)) = fields.get(name) {
                rules.extend(f64::read(value, &at, &range, faults).map(rule));
            }
        }
        if rules.len() > 1 {
            let detail =
                "must say in one way what a cycle is: cycle, pause_s, threshold_n or block_s";
            Fault::add(faults, fields.pointer(), detail);
        }
        Some(rules.into_iter().next().unwrap_or(usual))
    }

    fn write_fields(&self, table: &mut Map) {
        let (name, value) = match self {
            Self::Column(column) => (CYCLE, column.as_str().into()),
            Self::PauseS(seconds) => ("pause_s", (*seconds).into()),
            Self::ThresholdN(newtons) => ("threshold_n", (*newtons).into()),
            Self::BlockS(seconds) => ("block_s", (*seconds).into()),
            Self::Tenths => return,
        };
        table.insert(name.to_owned(), value);
    }

    fn describe(_: &Self, properties: &mut Properties, schemas: &mut Schemas) {
        let doc = "Cycles are rows with the same entry of this column, one after another.";
        let column = column_names::one::schema(schemas);
        properties.add(CYCLE, doc, column, None, false);
        for (name, range, doc, _) in QUANTITIES {
            properties.add(name, doc, range.schema(), None, false);
        }
        properties.exclude(&[CYCLE, "pause_s", "threshold_n", "block_s"]);
    }
}
