//! `strainsite export`: a study's answer as a file, without a service.

use std::io::IsTerminal;
use std::path::{Path, PathBuf};

use clap::Args;
use results::StudyResult;
use sqlx::SqliteConnection;

use crate::cli::commands::library::{Database, study};
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::print;
use crate::cli::terminal::output_place::write;
use service::export::{self, ExportError, FileFormat, Table};
use store::answers::result_rows::{self, Extent};
use store::queue::study_rows::StudyRow;

/// Write a study's answer as a file: a table, the map, the wheel, or the whole result
#[derive(Debug, Args)]
pub struct Export {
    /// Identifier of the study, its beginning, or latest
    id: String,
    #[command(flatten)]
    database: Database,
    /// Format of the file
    #[arg(long, value_enum, value_name = "FORMAT", default_value = "csv")]
    format: FileFormat,
    /// Content of CSV and Parquet
    #[arg(long, value_enum, value_name = "TABLE", default_value = "indices")]
    table: Table,
    /// File to write; standard output when absent
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Export {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        Files::of_database(self.database.file()).writing(self.output.as_deref())
    }

    /// Writes the answer.
    pub fn execute(&self) -> Result<(), Failure> {
        readable(self.format, self.output.as_deref())?;
        let wanted = export::Export {
            format: self.format,
            table: self.table,
        };
        let bytes = self.database.read(async |connection| {
            let row = study(connection, &self.id).await?;
            let result = result(connection, &row).await?;
            let sources = wanted.sources(connection, &row, result).await;
            let sources = sources.map_err(Failure::other)?;
            wanted.bytes(&sources).map_err(failure)
        })?;
        deliver(self.format, bytes, self.output.as_deref())
    }
}

/// Refuses to print on a terminal what nobody can read there.
pub fn readable(format: FileFormat, output: Option<&Path>) -> Result<(), Failure> {
    if output.is_some() || format.is_text() || !std::io::stdout().is_terminal() {
        return Ok(());
    }
    Err(Failure::input(format!(
        "{} is nothing to read on a terminal: name a file with --output, or send it to another program",
        format.as_str()
    )))
}

/// Writes the bytes of an export to a file, or to standard output.
pub(crate) fn deliver(
    format: FileFormat,
    mut bytes: Vec<u8>,
    output: Option<&Path>,
) -> Result<(), Failure> {
    if format == FileFormat::Json {
        bytes.push(b'\n');
    }
    match output {
        Some(path) => write(path, &bytes),
        None => print(&bytes),
    }
}

fn failure(error: ExportError) -> Failure {
    match error {
        ExportError::NoMap | ExportError::NoMesh | ExportError::NoFilms => {
            Failure::input(error.to_string())
        }
        error => Failure::other(error),
    }
}

async fn result(
    connection: &mut SqliteConnection,
    study: &StudyRow,
) -> Result<StudyResult, Failure> {
    let found = result_rows::find(connection, &study.id, Extent::Whole).await;
    let Some((result, _)) = found.map_err(Failure::other)? else {
        let why = study.error.as_deref().unwrap_or("it hasn't ended");
        return Err(Failure::Other(format!(
            "study {} is {} and has no result: {}",
            study.id,
            study.state().as_str(),
            why.escape_debug()
        )));
    };
    Ok(result)
}
