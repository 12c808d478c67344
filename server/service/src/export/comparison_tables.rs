//! A comparison as a file: its locations or its designs as a table, or the whole as JSON.

use std::collections::{BTreeSet, HashMap};

use fem_client::solver::direction::Direction;
use placement::compare::{ComparedLocation, ComparedStudy, Comparison};
use serde::Deserialize;
use serde_json::Value;
use utoipa::ToSchema;

use super::export_choice::{ExportError, FileFormat};
use super::table::{Rows, TypedTable};
use super::unit::{PERCENT, PURE, unit_of};
use super::{csv, parquet};

/// What is wanted of a comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, ToSchema, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum ComparisonTable {
    /// Index and rank of each location of each study, and differences with their errors.
    Locations,
    /// What each study sets, force, signals, best location and layout, cost, or why it has no result.
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

/// How a comparison is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, ToSchema, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum ComparisonFormat {
    /// One table as comma-separated values.
    Csv,
    /// The whole comparison.
    Json,
    /// One table with typed columns, for data frames.
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

/// What is exported of a comparison.
#[derive(Debug, Clone, Copy)]
pub struct ComparisonExport {
    /// How it is written.
    pub format: ComparisonFormat,
    /// Which table, where there is a choice.
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

/// A location with the study that it is of.
type Located<'c> = (&'c ComparedLocation, &'c ComparedStudy);

fn locations(comparison: &Comparison) -> TypedTable {
    let studies = comparison.studies.iter();
    let by_id: HashMap<&str, &ComparedStudy> = studies.map(|s| (s.id.as_str(), s)).collect();
    let located = comparison
        .rows
        .iter()
        .filter_map(|row| Some((row, *by_id.get(row.study.as_str())?)));
    let rows = begun(comparison, Rows::of(located), |(_, study)| study)
        .text("location", |(row, _)| Some(&row.location))
        .integer("rank", |(row, _)| Some(row.rank))
        .bool("rank_certain", |(row, _)| Some(row.rank_certain))
        .integer("rank_change", |(row, _)| row.rank_change)
        .text("rank_verdict", |(row, _)| Some(row.rank_verdict?.as_str()));
    let rows = Direction::ALL.into_iter().fold(rows, indices);
    rows.text("spec_sha256", |(_, study)| study.spec_sha256.as_deref())
        .text("version", |(_, study)| study.version.as_deref())
        .text("baseline", |_| comparison.baseline.as_deref())
        .table()
}

fn indices<'c>(rows: Rows<Located<'c>>, direction: Direction) -> Rows<Located<'c>> {
    let of = |(row, _): &Located<'c>| row.in_direction(direction);
    let named = |name: &str| format!("{name}_{direction}");
    rows.float(named("gsi_percent"), PERCENT, |row| of(row).gsi_percent)
        .float(named("error_percent"), PERCENT, |row| of(row).error_percent)
        .float(named("difference_percent"), PERCENT, |row| {
            of(row).difference_percent
        })
        .float(named("difference_error_percent"), PERCENT, |row| {
            of(row).difference_error_percent
        })
        .text(&named("verdict"), |row| Some(of(row).verdict?.as_str()))
}

fn designs(comparison: &Comparison) -> TypedTable {
    let rows = Rows::of(&comparison.studies);
    begun(comparison, rows, |study| study)
        .text("state", |study| Some(&study.state))
        .text("reason", |study| study.reason.as_deref())
        .text("level", |study| study.level.as_deref())
        .float("reaction_n", "N", |study| study.reaction_n)
        .float("std_strain_x", PURE, |study| study.std_strain_x)
        .float("std_strain_y", PURE, |study| study.std_strain_y)
        .text("best", |study| study.best.as_deref())
        .bool("best_certain", |study| study.best_certain)
        .float("layout_spacing_deg", "deg", |study| {
            study.layout_spacing_deg
        })
        .text("layout_position", |study| study.layout_position.as_deref())
        .integer("solves", |study| Some(study.cost.as_ref()?.solves))
        .integer("coarser_solves", |study| {
            Some(study.cost.as_ref()?.coarser_solves)
        })
        .integer("effect_solves", |study| {
            Some(study.cost.as_ref()?.effect_solves)
        })
        .integer("reused", |study| Some(study.cost.as_ref()?.reused))
        .float("wall_s", "s", |study| Some(study.cost.as_ref()?.wall_s))
        .float("cpu_s", "s", |study| Some(study.cost.as_ref()?.cpu_s))
        .text("spec_sha256", |study| study.spec_sha256.as_deref())
        .text("version", |study| study.version.as_deref())
        .text("baseline", |_| comparison.baseline.as_deref())
        .table()
}

/// The columns that both tables begin with: the study, its name, and each field that any design sets.
fn begun<T>(
    comparison: &Comparison,
    rows: Rows<T>,
    study: impl for<'r> Fn(&'r T) -> &'r ComparedStudy,
) -> Rows<T> {
    let sets = comparison.studies.iter().filter_map(|s| s.set.as_ref());
    let paths: BTreeSet<&String> = sets.clone().flat_map(|set| set.keys()).collect();
    let mut rows = rows
        .text("study", |row| Some(&study(row).id))
        .text("name", |row| Some(&study(row).name));
    for path in paths {
        let is_number = |value: &Value| value.is_number();
        let numbers = sets.clone().filter_map(|set| set.get(path)).all(is_number);
        let value = |row: &T| study(row).set.as_ref()?.get(path).cloned();
        rows = if numbers {
            rows.float(path, unit_of(path), |row| value(row)?.as_f64())
        } else {
            rows.made_text(path, |row| value(row).map(plain))
        };
    }
    rows
}

/// A value that isn't a number as people write it: a word as it is, anything else as JSON.
fn plain(value: Value) -> String {
    match value {
        Value::String(text) => text,
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

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
            layout_spacing_deg: None,
            layout_position: None,
            cost: None,
        }
    }

    #[test]
    fn what_designs_set_are_columns_with_units() {
        let comparison = Comparison {
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
