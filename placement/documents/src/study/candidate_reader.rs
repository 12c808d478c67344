//! Candidates of a study: directions of the strains, and the dense map.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::{Choice, Table};
use fem_client::solver::Grid;

use crate::parts::directions::Directions;

/// Candidate places for films.
#[derive(Debug, Clone, Copy, PartialEq, Table)]
pub(crate) struct Candidates {
    /// Places that are ranked.
    #[field(default = Points::Paper)]
    pub points: Points,
    /// Strains that are asked for.
    #[field(omitted, with = named_directions)]
    pub directions: Directions,
    /// Dense map of candidates; without it the ranked places alone.
    pub grid: Option<Grid>,
}

/// Places that are ranked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
pub(crate) enum Points {
    /// Five places of the inner surface above the stations.
    #[choice("P1-P5")]
    Paper,
}

/// Directions by their names.
mod named_directions {
    use document::Value;
    use document::fault::Fault;
    use document::json_schema::Schemas;
    use document::typed::field_value::Field;
    use document::typed::lists::Entries;
    use fem_client::solver::direction::Direction;

    use super::*;

    const WITHIN: Entries<()> = Entries::distinct(Direction::ALL.len(), ());

    pub fn read(value: &Value, at: &str, faults: &mut Vec<Fault>) -> Option<Directions> {
        let named = Vec::read(value, at, &WITHIN, faults)?;
        let directions = Directions::of(&named);
        if directions.is_none() {
            Fault::add(faults, at, "must name x, y or both; it is empty");
        }
        directions
    }

    pub fn write(directions: &Directions) -> Option<Value> {
        let names = directions.asked().iter();
        Some(names.map(|direction| direction.as_str()).collect())
    }

    pub fn schema(schemas: &mut Schemas) -> Value {
        let mut schema = Vec::<Direction>::schema(&WITHIN, schemas);
        if let Value::Object(schema) = &mut schema {
            schema.insert("minItems".to_owned(), 1.into());
        }
        schema
    }
}
