//! `strainsite gsa plan`: the points to run.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::Args;
use document::fault::Fault;
use documents::own_model::csv_cell;
use documents::own_model::inputs_document::Inputs;
use documents::own_model::own_analysis::fingerprint_of;
use documents::own_model::value_table::{PLAN_COLUMN, ValueTable};

use crate::cli::commands::gsa::own_values::{analysed, read_inputs, read_values};
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{print, warn};
use crate::cli::terminal::output_place::write;

/// Print the points to run, one row each
#[derive(Debug, Args)]
pub(crate) struct Plan {
    /// Inputs and method, TOML or JSON
    inputs: PathBuf,
    /// Outputs so far: only points without one are printed
    #[arg(long)]
    values: Option<PathBuf>,
    /// Add a column `plan`, which `analyse` compares with its own plan where the file of values keeps it
    #[arg(long)]
    fingerprint: bool,
    /// Write here instead of to standard output
    #[arg(short, long)]
    output: Option<PathBuf>,
}

impl Plan {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        Files::default()
            .reading([&self.inputs])
            .reading(&self.values)
            .writing(self.output.as_deref())
    }

    /// Plans and prints.
    pub fn execute(&self) -> Result<(), Failure> {
        let inputs = read_inputs(&self.inputs)?;
        let table = match &self.values {
            Some(path) => read_values(path, &inputs)?,
            None => ValueTable::empty(),
        };
        let analysis = analysed(&inputs, &table)?;
        let (points, missing) = (analysis.points(), analysis.wanted());
        let text = self.table(&inputs, points, &missing)?;
        warn(&format!(
            "{} points to run, {} in all\n",
            missing.len(),
            points.len()
        ));
        match &self.output {
            Some(path) => write(path, text.as_bytes()),
            None => print(&text),
        }
    }

    /// The rows of these points, under their header.
    fn table(
        &self,
        inputs: &Inputs,
        points: &[Vec<f64>],
        wanted: &[usize],
    ) -> Result<String, Failure> {
        let last = match self.fingerprint {
            true => Some(fingerprint_column(inputs)?),
            false => None,
        };
        let (id, plan) = ("id".to_owned(), PLAN_COLUMN.to_owned());
        let of_plan = last.iter().map(|_| &plan);
        let columns = std::iter::once(&id).chain(&inputs.names).chain(of_plan);
        let mut text = csv_cell::line(columns);
        for &id in wanted {
            text.push_str(&id.to_string());
            for x in &points[id] {
                // The shortest digits that read back bit for bit.
                write!(text, ",{x:?}").map_err(Failure::other)?;
            }
            if let Some(fingerprint) = &last {
                text.push_str(&format!(",{fingerprint}"));
            }
            text.push('\n');
        }
        Ok(text)
    }
}

/// The fingerprint for a column of its own, which no input may have.
fn fingerprint_column(inputs: &Inputs) -> Result<String, Failure> {
    match inputs.names.iter().position(|name| name == PLAN_COLUMN) {
        Some(input) => Err(Failure::Input(vec![Fault {
            pointer: format!("/inputs/{input}/name"),
            detail: "is that of the column of --fingerprint: rename the input, or leave --fingerprint out".to_owned(),
        }])),
        None => fingerprint_of(inputs).map_err(Failure::Input),
    }
}
