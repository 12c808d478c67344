//! Locations in their order.

use std::collections::BTreeMap;

use fem_client::direction_fields;
use fem_client::solver::direction::{Direction, PerDirection};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::Value;

use crate::location_scores::{Figure, GSI, LocationScores, Score};

direction_fields! {
    /// Names of ranks by one direction alone.
    RankFields: "rank_x", "rank_y";
}

/// A candidate location in the ranking.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RankedLocation {
    /// P1, P2, ...
    pub name: String,
    /// The input that is this location's own: the depth of the station below it.
    pub input: Option<String>,
    /// Rank of the location, 1 the best. Equal locations, as mirror images are, share that of the first of them, and follow each other in the order of their
    /// names.
    pub rank: usize,
    /// Scores by which it is judged.
    #[serde(flatten)]
    pub scores: LocationScores,
    /// Rank by one strain alone, which equal locations share.
    #[serde(flatten, with = "RankFields")]
    pub ranks: PerDirection<Option<usize>>,
    /// Whether the errors leave no doubt about this rank, which equals share.
    pub rank_certain: bool,
}

impl RankedLocation {
    /// A score's value.
    pub fn value(&self, score: &Score, direction: Direction) -> Option<f64> {
        self.scores.of_score(score)[direction].value
    }

    /// A score's error.
    pub fn error(&self, score: &Score, direction: Direction) -> Option<f64> {
        self.scores.of_score(score)[direction].error
    }

    /// Whether an index that it is ranked by has a known error.
    pub fn knows_error(&self) -> bool {
        let ranked_by = self.scores.of_score(GSI);
        ranked_by.iter().any(|figure| figure.error.is_some())
    }
}

impl Serialize for LocationScores {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.fields())
    }
}

impl<'de> Deserialize<'de> for LocationScores {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let fields = BTreeMap::<String, Value>::deserialize(deserializer)?;
        let number = |name: String| fields.get(&name)?.as_f64();
        Ok(Self::of(|score, direction| Figure {
            value: number(score.field(direction)),
            error: score.error_field(direction).and_then(number),
        }))
    }
}

mod schema {
    use fem_client::solver::direction::Direction;
    use fem_client::solver::object_schema::{ObjectSchema, Type};
    use utoipa::openapi::{RefOr, Schema};
    use utoipa::{PartialSchema, ToSchema};

    use super::RankedLocation;
    use crate::location_scores::{SCORES, Score};

    impl PartialSchema for RankedLocation {
        fn schema() -> RefOr<Schema> {
            let own = "The input that is this location's own: the depth of the station below it.";
            let schema = ObjectSchema::new("One candidate location in the ranking.")
                .required(Type::String, "name", "P1, P2, ...")
                .nullable(Type::String, "input", own)
                .required(Type::Integer, "rank", "1 is best. Equal locations, as mirror images are, share the rank of the first of them, and follow each other in the order of their names.");
            let schema = SCORES
                .iter()
                .fold(schema, |schema, score| with_score(schema, score));
            let schema = Direction::ALL
                .into_iter()
                .fold(schema, |schema, direction| {
                    let by = format!(
                        "Rank by the {direction} strain alone, which equal locations share."
                    );
                    schema.nullable(Type::Integer, &format!("rank_{direction}"), &by)
                });
            let certain =
                "Whether the errors leave no doubt about this rank, which equal locations share.";
            schema
                .required(Type::Boolean, "rank_certain", certain)
                .schema()
        }
    }

    fn with_score(mut schema: ObjectSchema, score: &Score) -> ObjectSchema {
        for direction in Direction::ALL {
            let what = score.what[direction];
            schema = schema.nullable(Type::Number, &score.field(direction), what);
        }
        for direction in Direction::ALL {
            if let Some(field) = score.error_field(direction) {
                let what = score.what_of_error(direction);
                schema = schema.nullable(Type::Number, &field, &what);
            }
        }
        schema
    }

    impl ToSchema for RankedLocation {}
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scores_stand_flat_in_documents() {
        let scores = LocationScores::of(|score, direction| Figure {
            value: (direction == Direction::X).then_some(score.name.len() as f64),
            error: score.has_error.then_some(0.1 + 0.2),
        });
        let location = RankedLocation {
            name: "P3".to_owned(),
            input: None,
            rank: 1,
            scores,
            ranks: [Some(1), None].into(),
            rank_certain: true,
        };
        let text = serde_json::to_string(&location).expect("finite numbers");
        let first = r#"{"name":"P3","input":null,"rank":1,"gsi_x_percent":3.0,"gsi_y_percent":null,"gsi_x_error_percent":0.30000000000000004,"gsi_y_error_percent":0.30000000000000004,"mean_gsi_x_percent":8.0,"mean_gsi_y_percent":null,"#;
        assert!(text.starts_with(first), "{text}");
        let last = r#","rank_x":1,"rank_y":null,"rank_certain":true}"#;
        assert!(text.ends_with(last), "{text}");
        let back: RankedLocation = serde_json::from_str(&text).expect("reads back");
        assert_eq!(back, location);
    }
}
