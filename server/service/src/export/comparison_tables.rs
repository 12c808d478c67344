//! A comparison as a file: its locations or its designs as a table, or the whole as JSON.

use std::collections::{BTreeSet, HashMap};

use placement::compare::{ComparedStudy, Comparison};
use results::columns::{self, Column};
use serde::Deserialize;
use serde_json::{Value, json};
use utoipa::ToSchema;

use super::export_choice::{ExportError, FileFormat};
use super::table::TypedTable;
use super::{csv, parquet};

/// Table of a comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, ToSchema, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum ComparisonTable {
    /// Index and rank of each location of each study, and differences with their errors.
    Locations,
    /// Settings of each study, its layout with errors and differences, force, signals, best location, cost, or why it has no result.
    Designs,
}

impl ComparisonTable {
    /// The name in addresses and file names.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Locations => "locations",
            Self::Designs => "designs",
        }
    }

    /// The table of this name.
    pub fn named(name: &str) -> Option<Self> {
        let mut all = [Self::Locations, Self::Designs].into_iter();
        all.find(|table| table.as_str() == name)
    }
}

/// Format of a comparison's file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, ToSchema, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum ComparisonFormat {
    /// Comma-separated values, one table.
    Csv,
    /// The whole comparison.
    Json,
    /// Parquet, one table with typed columns, for data frames.
    Parquet,
}

impl ComparisonFormat {
    /// The format of this name.
    pub fn named(name: &str) -> Option<Self> {
        let mut all = [Self::Csv, Self::Json, Self::Parquet].into_iter();
        all.find(|format| format.file().as_str() == name)
    }

    /// The format of the file.
    pub fn file(self) -> FileFormat {
        match self {
            Self::Csv => FileFormat::Csv,
            Self::Json => FileFormat::Json,
            Self::Parquet => FileFormat::Parquet,
        }
    }
}

/// Export of a comparison.
#[derive(Debug, Clone, Copy)]
pub struct ComparisonExport {
    /// Format of the file.
    pub format: ComparisonFormat,
    /// Table to write, where there is a choice.
    pub table: ComparisonTable,
}

impl ComparisonExport {
    /// A name for the file.
    pub fn file_name(self) -> String {
        let ending = self.format.file().as_str();
        match self.format {
            ComparisonFormat::Json => format!("comparison.{ending}"),
            _ => format!("comparison-{}.{ending}", self.table.as_str()),
        }
    }

    /// The file's bytes.
    ///
    /// # Errors
    /// None that a comparison could cause.
    pub fn bytes(self, comparison: &Comparison) -> Result<Vec<u8>, ExportError> {
        let table = || match self.table {
            ComparisonTable::Locations => locations(comparison),
            ComparisonTable::Designs => designs(comparison),
        };
        match self.format {
            ComparisonFormat::Csv => Ok(csv::csv(&table()).into_bytes()),
            ComparisonFormat::Json => Ok(serde_json::to_string_pretty(comparison)?.into_bytes()),
            ComparisonFormat::Parquet => {
                let baseline = comparison.baseline.as_deref().unwrap_or_default();
                let origin = [("baseline", baseline), ("table", self.table.as_str())];
                Ok(parquet::parquet(&table(), &origin)?)
            }
        }
    }
}

fn locations(comparison: &Comparison) -> TypedTable {
    let studies = comparison.studies.iter();
    let by_id: HashMap<&str, Value> = studies.map(|s| (s.id.as_str(), of_study(s))).collect();
    let rows = comparison.rows.iter().filter_map(|row| {
        let study = by_id.get(row.study.as_str())?;
        Some(json!({ "row": row, "study": study, "comparison": named(comparison) }))
    });
    typed(&columns::compared_locations(), comparison, rows)
}

fn designs(comparison: &Comparison) -> TypedTable {
    let studies = comparison.studies.iter();
    let rows = studies.map(|s| json!({ "study": of_study(s), "comparison": named(comparison) }));
    typed(&columns::designs(), comparison, rows)
}

/// Part of a row that is a study, without the trade of its layouts: no column has any of that, and it is most of a study.
fn of_study(study: &ComparedStudy) -> Value {
    let mut part = json!(study);
    if let Some(answer) = part["answer"].as_object_mut() {
        answer.remove("trade");
    }
    part
}

/// Part of a row that is the comparison itself.
fn named(comparison: &Comparison) -> Value {
    json!({ "baseline": comparison.baseline })
}

/// A table that begins with the study, its name, and each field that any design sets.
fn typed(
    described: &columns::Table,
    comparison: &Comparison,
    rows: impl Iterator<Item = Value>,
) -> TypedTable {
    let sets = comparison.studies.iter().filter_map(|s| s.set.as_ref());
    let paths: BTreeSet<&String> = sets.clone().flat_map(|set| set.keys()).collect();
    let mut columns = vec![
        Column::text("study", "/study/id"),
        Column::text("name", "/study/name"),
    ];
    for (k, path) in paths.iter().enumerate() {
        let is_number = |value: &Value| value.is_number();
        let at = format!("/set/{k}");
        let mut values = sets.clone().filter_map(|set| set.get(*path));
        columns.push(if values.all(is_number) {
            Column::float(path, &at)
        } else {
            Column::text(path, &at)
        });
    }
    columns.extend(described.exported().cloned());
    let with_settings = |mut row: Value| {
        let set = |path: &&String| row["study"]["set"].get(*path).cloned().map(plain);
        row["set"] = paths.iter().map(set).collect();
        row
    };
    TypedTable::of(&columns, rows.map(with_settings))
}

/// Writes what isn't a number as people do: a word as it is, anything else as JSON.
fn plain(value: Value) -> Value {
    match value {
        Value::Number(_) | Value::String(_) => value,
        other => other.to_string().into(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::table::Values;
    use super::*;

    fn study(id: &str, set: Value) -> ComparedStudy {
        let set = set.as_object().cloned();
        ComparedStudy {
            id: id.to_owned(),
            name: format!("design {id}"),
            set,
            state: "failed".to_owned(),
            reason: Some("no equilibrium".to_owned()),
            spec_sha256: None,
            version: None,
            level: None,
            reaction_n: None,
            std_strain_x: None,
            std_strain_y: None,
            best: None,
            best_certain: None,
            answer: None,
            layout_spacing_deg: None,
            layout_position: None,
            cost: None,
        }
    }

    #[test]
    fn what_designs_set_are_columns_with_units() {
        let comparison = Comparison {
            answer: None,
            baseline: None,
            studies: vec![
                study(
                    "a",
                    json!({"geometry.wall_mm": 3, "inputs[0].distribution": {"kind": "normal"}}),
                ),
                study(
                    "b",
                    json!({"geometry.wall_mm": 2.5, "material.model": "yeoh"}),
                ),
                study("c", Value::Null),
            ],
            rows: Vec::new(),
            notes: Vec::new(),
        };
        let table = designs(&comparison);
        let seen: Vec<_> = table.columns[2..5].iter().collect();
        let texts = |values: [Option<&str>; 3]| {
            Values::Text(values.map(|value| value.map(str::to_owned)).to_vec())
        };
        let expected = [
            (
                "geometry.wall_mm",
                Some("mm"),
                Values::Float(vec![Some(3.0), Some(2.5), None]),
            ),
            (
                "inputs[0].distribution",
                None,
                texts([Some("{\"kind\":\"normal\"}"), None, None]),
            ),
            ("material.model", None, texts([None, Some("yeoh"), None])),
        ];
        for (column, (name, unit, values)) in seen.into_iter().zip(expected) {
            assert_eq!((column.name.as_str(), column.unit), (name, unit));
            assert_eq!(column.values, values, "{name}");
        }
        assert_eq!(locations(&comparison).columns[0].values.len(), 0);
    }
}
