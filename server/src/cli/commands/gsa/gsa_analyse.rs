//! `strainsite gsa analyse`: outputs at the points, turned into indices.

use std::path::PathBuf;

use clap::Args;
use document::fault::Fault;

use crate::cli::commands::gsa::own_values::{analysed, read_inputs, read_values};
use crate::cli::commands::gsa::told_indices::tell_indices;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{JsonTarget, warn};
use crate::cli::terminal::paint::{WARNING, painted};

/// Turn the outputs at the points into sensitivity indices
#[derive(Debug, Args)]
pub(crate) struct Analyse {
    /// Inputs and method, TOML or JSON
    inputs: PathBuf,
    /// Outputs, CSV: header `id,<output names>`, a row per point in any order, empty or `nan` where a run failed. Columns of the plan may stay: they are compared with it
    values: PathBuf,
    /// Write the answer as JSON, `-` for standard output
    #[arg(long)]
    pub json: Option<JsonTarget>,
}

impl Analyse {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        Files::default()
            .reading([&self.inputs, &self.values])
            .telling(self.json.as_ref())
    }

    /// Analyses and prints.
    pub fn execute(&self) -> Result<(), Failure> {
        let inputs = read_inputs(&self.inputs)?;
        let table = read_values(&self.values, &inputs)?;
        let analysis = analysed(&inputs, &table)?;
        let Some(found) = analysis.found() else {
            return Err(Failure::Input(
                analysis.advice().map(of_values).into_iter().collect(),
            ));
        };
        let wanted = analysis.wanted().len();
        if wanted > 0 {
            let more = format!("the method asks for {wanted} more points");
            warn(&format!(
                "{}: strainsite gsa plan {} --values {}\n",
                painted(WARNING, more),
                self.inputs.display(),
                self.values.display()
            ));
        }
        tell_indices(&analysis, found, self.json.as_ref())
    }
}

/// A fault of the file of values as a whole.
fn of_values(detail: String) -> Fault {
    Fault {
        pointer: String::new(),
        detail,
    }
}
