//! `strainsite gsa`: sensitivity analysis of a model that others run.
//!
//! `plan` prints the points to run; `analyse` reads their outputs back. An adaptive method goes on: `plan` again with the
//! values so far prints what is still to be run.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use ::gsa::method::analysis::{Analysis, Status};
use clap::{Args, Subcommand};
use document::fault::Fault;
use document::visible::visible;
use documents::own_model::csv_cell;
use documents::own_model::inputs_document::Inputs;
use documents::own_model::own_analysis::{OwnAnalysis, fingerprint_of};
use documents::own_model::value_table::{PLAN_COLUMN, ValueTable};
use serde_json::json;

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::help_examples;
use crate::cli::terminal::output::{JsonTarget, print, tell, warn};
use crate::cli::terminal::output_place::write;
use crate::cli::terminal::paint::{HEADER, WARNING, painted};
use crate::cli::terminal::progress::clock;
use service::study_document::text_files::read_text;
use service::study_document::{format_of, read_file};
use service::wire::analysis_wire::ModelAnalysis;

/// Analyse a model of your own: print the points to run, then read their outputs back
#[derive(Debug, Args)]
pub struct Gsa {
    #[command(subcommand)]
    step: Step,
}

#[derive(Debug, Subcommand)]
enum Step {
    /// Print the points to run, one row each
    #[command(after_help = help_examples::GSA_PLAN)]
    Plan(Plan),
    /// Turn the outputs at the points into sensitivity indices
    #[command(after_help = help_examples::GSA_ANALYSE)]
    Analyse(Analyse),
}

#[derive(Debug, Args)]
struct Plan {
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

#[derive(Debug, Args)]
struct Analyse {
    /// Inputs and method, TOML or JSON
    inputs: PathBuf,
    /// Outputs, CSV: header `id,<output names>`, a row per point in any order, empty or `nan` where a run failed. Columns of the plan may stay: they are compared with it
    values: PathBuf,
    /// Write the answer as JSON, `-` for standard output
    #[arg(long)]
    json: Option<JsonTarget>,
}

impl Gsa {
    /// Runs the step.
    pub fn execute(&self) -> Result<(), Failure> {
        match &self.step {
            Step::Plan(step) => step.execute(),
            Step::Analyse(step) => step.execute(),
        }
    }

    /// Returns the files that the step reads and writes.
    pub fn files(&self) -> Files {
        match &self.step {
            Step::Plan(step) => Files::default()
                .reading([&step.inputs])
                .reading(&step.values)
                .writing(step.output.as_deref()),
            Step::Analyse(step) => Files::default()
                .reading([&step.inputs, &step.values])
                .telling(step.json.as_ref()),
        }
    }

    /// Returns where the step's JSON goes.
    pub fn json(&self) -> Option<JsonTarget> {
        match &self.step {
            Step::Plan(_) => None,
            Step::Analyse(step) => step.json.clone(),
        }
    }
}

/// Most bytes of a file of values: a million runs, which are the most, of 25 outputs with all their digits.
const MOST_VALUE_BYTES: usize = 1 << 29;

fn read_inputs(path: &Path) -> Result<Inputs, Failure> {
    let text = read_file(path).map_err(Failure::Input)?;
    Inputs::from_document(&text, format_of(path)).map_err(Failure::Input)
}

fn read_values(path: &Path, inputs: &Inputs) -> Result<ValueTable, Failure> {
    let text = read_text(path, MOST_VALUE_BYTES).map_err(Failure::input)?;
    let table = ValueTable::of_model(&text, &inputs.names).map_err(Failure::Input)?;
    let is_input = |name: &&String| inputs.names.contains(name);
    for name in table.outputs().iter().filter(is_input) {
        warn(&format!(
            "{}: column {name:?} is taken for an output, as the file has no other: give it a name that no input has\n",
            painted(WARNING, "named as an input")
        ));
    }
    Ok(table)
}

/// The analysis as far as the values go.
fn analysed<'a>(inputs: &'a Inputs, values: &'a ValueTable) -> Result<OwnAnalysis<'a>, Failure> {
    let waiting = clock("planning and analysing");
    let analysis = OwnAnalysis::of(inputs, values);
    waiting.finish_and_clear();
    analysis.map_err(Failure::Input)
}

impl Plan {
    fn execute(&self) -> Result<(), Failure> {
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
}

impl Plan {
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

impl Analyse {
    fn execute(&self) -> Result<(), Failure> {
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
        let mut text = people_table(&inputs.names, table.outputs(), found);
        if let Some(advice) = analysis.advice() {
            text += &format!("{}\n", painted(WARNING, advice));
        }
        tell(&text, self.json.as_ref())?;
        match &self.json {
            Some(target) => target.write(&json!(ModelAnalysis::of(&analysis))),
            None => Ok(()),
        }
    }
}

/// A fault of the file of values as a whole.
fn of_values(detail: String) -> Fault {
    Fault {
        pointer: String::new(),
        detail,
    }
}

fn people_table(inputs: &[String], outputs: &[String], found: &[Analysis]) -> String {
    let mut text = String::new();
    for (name, analysis) in outputs.iter().zip(found) {
        let status = match analysis.status {
            Status::Ok => String::new(),
            status => format!(", {}", painted(WARNING, status.as_str())),
        };
        let (name, method) = (painted(HEADER, visible(name)), analysis.method.as_str());
        text.push_str(&format!("{name}: {method}{status}\n"));
        if let (Some(first), Some(total)) = (&analysis.first_order, &analysis.total) {
            let width = inputs.iter().map(|name| name.chars().count()).max();
            let width = width.unwrap_or(0).max(5);
            let heads = format!("  {:width$}  first order      total    +-", "input");
            text.push_str(&(painted(HEADER, heads) + "\n"));
            let errors = analysis.error.by_input.as_ref();
            for (i, input) in inputs.iter().enumerate() {
                let error = errors.map_or("unknown".to_owned(), |e| format!("{:.1e}", e[i]));
                text.push_str(&format!(
                    "  {input:width$}  {:11.6} {:10.6}    {error}\n",
                    first[i], total[i]
                ));
            }
        }
        if let Some(reason) = &analysis.reason {
            text.push_str(&format!("  {reason}\n"));
        }
    }
    text
}
