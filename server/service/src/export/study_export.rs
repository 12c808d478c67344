//! A study's answer as a file.

use results::StudyResult;
use serde_json::json;
use sqlx::SqliteConnection;
use vtu::wheel_glb::glb;
use vtu::wheel_skins::WheelSkins;

use crate::export::export_choice::{ExportError, FileFormat, Table};
use crate::export::{csv, film_template, map_grid, parquet, tables};
use crate::views::point_views;
use crate::views::solved_wheel;
use crate::wire::study_wire::EvaluationView;
use store::StoreError;
use store::queue::study_rows::StudyRow;

/// Export of a study.
#[derive(Debug, Clone, Copy)]
pub struct Export {
    /// Format of the file.
    pub format: FileFormat,
    /// Table to write, where there is a choice.
    pub table: Table,
}

/// Sources of a file.
#[derive(Debug)]
pub struct ExportSources {
    /// Result of the study.
    pub result: StudyResult,
    /// Points of the study, where the file has them.
    points: Vec<EvaluationView>,
    /// The wheel at its cut point, where the file has it.
    skins: Option<WheelSkins>,
}

impl ExportSources {
    /// Makes the sources of a file that has neither points nor the wheel.
    pub fn of(result: StudyResult) -> Self {
        Self {
            result,
            points: Vec::new(),
            skins: None,
        }
    }
}

impl Export {
    /// Reads what this file of a study is made from, beside its result.
    ///
    /// # Errors
    /// When the database can't be read, or what it holds is damaged.
    pub async fn sources(
        self,
        connection: &mut SqliteConnection,
        study: &StudyRow,
        result: StudyResult,
    ) -> Result<ExportSources, StoreError> {
        let sources = ExportSources::of(result);
        let has_points = self.format.has_tables() && self.table == Table::Points;
        Ok(if has_points {
            let points = point_views::of(connection, study).await?;
            ExportSources { points, ..sources }
        } else if self.format == FileFormat::Glb {
            let level = &sources.result.model.level;
            let skins = solved_wheel::skins(connection, &study.id, level).await?;
            ExportSources { skins, ..sources }
        } else {
            sources
        })
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

    /// The file's bytes.
    ///
    /// # Errors
    /// See [`ExportError`].
    pub fn bytes(self, sources: &ExportSources) -> Result<Vec<u8>, ExportError> {
        let ExportSources {
            result,
            points,
            skins,
        } = sources;
        let table = || tables::table(self.table, result, points);
        match self.format {
            FileFormat::Csv => Ok(csv::csv(&table()).into_bytes()),
            FileFormat::Json => Ok(serde_json::to_string_pretty(result)?.into_bytes()),
            FileFormat::Vtu => Ok(map_grid::vtu(result)?.into_bytes()),
            FileFormat::Svg => Ok(film_template::svg(result)?.into_bytes()),
            FileFormat::Glb => {
                let skins = skins.as_ref().ok_or(ExportError::NoMesh)?;
                let study = &result.study;
                let origin = json!({
                    "study": study.id, "name": study.name, "spec_sha256": study.spec_sha256, "version": study.version,
                });
                Ok(glb(skins, &origin))
            }
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
