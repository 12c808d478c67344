//! A study's answer as a file.

use placement::result::StudyResult;

use crate::export::export_choice::{ExportError, FileFormat, Table};
use crate::export::{csv, map_grid, parquet, tables};
use crate::point_views::EvaluationView;

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
