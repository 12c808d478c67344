//! Answers as files for other programs.
//!
//! Tables have a row per thing, and their columns are listed once, in `tables` and `force_tables`; CSV and Parquet are both written from there. JSON is the
//! result itself, VTU has the map on the surface that it is of, and GLB the whole wheel. Every file says which study it is of, the hash of its document and the version of the program.

mod comparison_tables;
mod csv;
mod export_choice;
mod force_tables;
mod map_grid;
mod parquet;
mod study_export;
mod surface_file;
mod table;
mod tables;
mod unit;

pub use comparison_tables::{ComparisonExport, ComparisonFormat, ComparisonTable};
pub use export_choice::{ExportError, FileFormat, Table};
pub use study_export::{Export, ExportSources};
pub use surface_file::surface_file;
