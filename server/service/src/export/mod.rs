//! Answers as files for other programs.
//!
//! Tables have a row per thing, and their columns are listed once, in `tables`; CSV and Parquet are both written from there. JSON is the
//! result itself, and VTU has the map on the surface that it is of. Every file says which study it is of, the hash of its document and the version of the program.

mod comparison_tables;
mod csv;
mod map_grid;
mod parquet;
mod table;
mod tables;
mod unit;

pub use comparison_tables::{ComparisonExport, ComparisonFormat, ComparisonTable};
use placement::result::StudyResult;
use serde::Deserialize;
use utoipa::ToSchema;

use crate::points::EvaluationView;

/// What is wanted of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, ToSchema, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Table {
    /// Indices of every strain with their errors: one row per location, direction and input.
    Indices,
    /// Ranked locations.
    Locations,
    /// Ranked layouts.
    Layouts,
    /// Solved points: inputs, force, strains.
    Points,
}

impl Table {
    const ALL: [Self; 4] = [Self::Indices, Self::Locations, Self::Layouts, Self::Points];

    /// The name in addresses and file names.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Indices => "indices",
            Self::Locations => "locations",
            Self::Layouts => "layouts",
            Self::Points => "points",
        }
    }

    /// The table of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|table| table.as_str() == name)
    }
}

/// How a file is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, ToSchema, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum FileFormat {
    /// One table as comma-separated values.
    Csv,
    /// The whole result.
    Json,
    /// One table with typed columns, for data frames.
    Parquet,
    /// The map on the inner surface, for ParaView.
    Vtu,
}

impl FileFormat {
    const ALL: [Self; 4] = [Self::Csv, Self::Json, Self::Parquet, Self::Vtu];

    /// The name in addresses, and the ending of file names.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Json => "json",
            Self::Parquet => "parquet",
            Self::Vtu => "vtu",
        }
    }

    /// The format of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.as_str() == name)
    }

    /// The media type. None is registered for VTK's formats; a VTU file is well-formed XML.
    pub fn media_type(self) -> &'static str {
        match self {
            Self::Csv => "text/csv; charset=utf-8",
            Self::Json => "application/json",
            Self::Parquet => "application/vnd.apache.parquet",
            Self::Vtu => "application/xml",
        }
    }

    /// Whether a table has to be chosen.
    pub fn has_tables(self) -> bool {
        matches!(self, Self::Csv | Self::Parquet)
    }

    /// Whether people can read it on a terminal.
    pub fn is_text(self) -> bool {
        matches!(self, Self::Csv | Self::Json)
    }
}

/// A file that can't be made.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// The study has no map.
    #[error("this study has no map: its document asks for no candidates.grid")]
    NoMap,
    /// Its result is an earlier version's.
    #[error(
        "this result was found by a version that didn't keep where the points of a map lie: submit its document again"
    )]
    NoShape,
    /// The map isn't one.
    #[error("the VTU file can't be made: {0}")]
    Vtu(#[from] vtu::VtuError),
    /// The writer of Parquet failed.
    #[error("the Parquet file can't be made: {0}")]
    Parquet(#[from] ::parquet::errors::ParquetError),
    /// The result can't be written as JSON.
    #[error("the result can't be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
}

/// What is exported.
#[derive(Debug, Clone, Copy)]
pub struct Export {
    /// How it is written.
    pub format: FileFormat,
    /// Which table, where there is a choice.
    pub table: Table,
}

impl Export {
    /// Whether the solved points are needed beside the result.
    pub fn needs_points(self) -> bool {
        self.format.has_tables() && self.table == Table::Points
    }

    /// A name for the file.
    pub fn file_name(self, study: &str) -> String {
        let ending = self.format.as_str();
        if self.format.has_tables() {
            format!("{study}-{}.{ending}", self.table.as_str())
        } else {
            format!("{study}.{ending}")
        }
    }

    /// The file's bytes; `points` are those of the study where they are needed.
    ///
    /// # Errors
    /// See [`ExportError`].
    pub fn bytes(
        self,
        result: &StudyResult,
        points: &[EvaluationView],
    ) -> Result<Vec<u8>, ExportError> {
        let table = || tables::table(self.table, result, points);
        match self.format {
            FileFormat::Csv => Ok(csv::csv(&table()).into_bytes()),
            FileFormat::Json => Ok(serde_json::to_string_pretty(result)?.into_bytes()),
            FileFormat::Vtu => Ok(map_grid::vtu(result)?.into_bytes()),
            FileFormat::Parquet => {
                let study = &result.study;
                let origin = [
                    ("study", study.id.as_str()),
                    ("spec_sha256", &study.spec_sha256),
                    ("version", &study.version),
                    ("table", self.table.as_str()),
                ];
                Ok(parquet::parquet(&table(), &origin)?)
            }
        }
    }
}
