//! Answers as files for other programs.
//!
//! Tables have a row per thing; CSV and Parquet are both written from [`results::columns`]. JSON is the
//! result itself, SVG a template of the answer's films, VTU has the map on the surface that it is of, and GLB the whole wheel. Every file says which study it is of, the hash of its document and the version of the program.

mod comparison_tables;
mod csv;
mod export_choice;
mod film_template;
mod map_grid;
mod parquet;
mod study_export;
mod surface_file;
mod table;
mod tables;

pub use comparison_tables::{ComparisonExport, ComparisonFormat, ComparisonTable};
pub use export_choice::{ExportError, FileFormat, Table};
use results::columns::Table as Described;
use serde_json::Value;
pub use study_export::{Export, ExportSources};
pub use surface_file::surface_file;

/// Writes a table's columns of these rows as comma-separated values.
pub fn csv_of(described: &Described, rows: &[Value]) -> String {
    csv::csv(&table::TypedTable::of(described.exported(), rows))
}
