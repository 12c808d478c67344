//! `strainsite gsa`: sensitivity analysis of a model that others run.
//!
//! `plan` prints the points to run; `analyse` reads their outputs back. An adaptive method goes on: `plan` again with the
//! values so far prints what is still to be run.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use ::gsa::campaign::Campaign;
use ::gsa::method::analysis::{Analysis, Status};
use clap::{Args, Subcommand};
use document::fault::Fault;
use document::visible::visible;
use documents::own_model::csv_cell;
use documents::own_model::inputs_document::Inputs;
use documents::own_model::value_table::ValueTable;
use ndarray::ArrayView2;
use serde_json::{Value, json};

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::help_examples;
use crate::cli::terminal::output::{JsonTarget, print, tell, warn};
use crate::cli::terminal::output_place::write;
use crate::cli::terminal::paint::{HEADER, WARNING, painted};
use crate::cli::terminal::progress::clock;
use service::study_document::text_files::read_text;
use service::study_document::{format_of, read_file};

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
    /// Write here instead of to standard output
    #[arg(short, long)]
    output: Option<PathBuf>,
}

#[derive(Debug, Args)]
struct Analyse {
    /// Inputs and method, TOML or JSON
    inputs: PathBuf,
    /// Outputs, CSV: header `id,<output names>`, a row per point in any order, empty or `nan` where a run failed
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

fn read_values(path: &Path) -> Result<ValueTable, Failure> {
    let text = read_text(path, MOST_VALUE_BYTES).map_err(Failure::input)?;
    ValueTable::from_csv(&text).map_err(Failure::Input)
}

/// The campaign as these values leave it, and what they say so far, if they are enough to say anything.
fn replay(
    inputs: &Inputs,
    values: &ArrayView2<f64>,
) -> Result<(Campaign, Option<Vec<Analysis>>), Failure> {
    let waiting = clock("planning and analysing");
    let replayed = Campaign::replay(&inputs.laws, inputs.method, values);
    waiting.finish_and_clear();
    replayed.map_err(|error| {
        Failure::Input(vec![Fault {
            pointer: "/inputs".to_owned(),
            detail: error.to_string(),
        }])
    })
}

impl Plan {
    fn execute(&self) -> Result<(), Failure> {
        let inputs = read_inputs(&self.inputs)?;
        let table = match &self.values {
            Some(path) => read_values(path)?,
            None => ValueTable::empty(),
        };
        let (campaign, _) = replay(&inputs, &table.leading_rows().view())?;
        table
            .check_ids(campaign.points().len())
            .map_err(Failure::Input)?;
        let missing: Vec<usize> = (0..campaign.points().len())
            .filter(|id| !table.has(*id))
            .collect();
        let id = "id".to_owned();
        let mut text = csv_cell::line(std::iter::once(&id).chain(&inputs.names));
        for &id in &missing {
            text.push_str(&id.to_string());
            for x in &campaign.points()[id] {
                // The shortest digits that read back bit for bit.
                write!(text, ",{x:?}").map_err(Failure::other)?;
            }
            text.push('\n');
        }
        warn(&format!(
            "{} points to run, {} in all\n",
            missing.len(),
            campaign.points().len()
        ));
        match &self.output {
            Some(path) => write(path, text.as_bytes()),
            None => print(&text),
        }
    }
}

impl Analyse {
    fn execute(&self) -> Result<(), Failure> {
        let inputs = read_inputs(&self.inputs)?;
        let table = read_values(&self.values)?;
        let rows = table.leading_rows();
        let (campaign, found) = replay(&inputs, &rows.view())?;
        let points = campaign.points().len();
        table.check_ids(points).map_err(Failure::Input)?;
        let Some(found) = found else {
            return Err(Failure::Input(table.missing_ids(points)));
        };
        let wanted = (0..points).filter(|id| !table.has(*id)).count();
        if wanted > 0 {
            let more = format!("the method asks for {wanted} more points");
            warn(&format!(
                "{}: strainsite gsa plan {} --values {}\n",
                painted(WARNING, more),
                self.inputs.display(),
                self.values.display()
            ));
        }
        let text = people_table(&inputs.names, table.outputs(), &found);
        tell(&text, self.json.as_ref())?;
        match &self.json {
            Some(target) => target.write(&document(&inputs.names, &table, &found, wanted)),
            None => Ok(()),
        }
    }
}

fn document(inputs: &[String], table: &ValueTable, found: &[Analysis], wanted: usize) -> Value {
    let outputs: Vec<Value> = table
        .outputs()
        .iter()
        .zip(found)
        .map(|(name, analysis)| output(name, analysis))
        .collect();
    json!({"inputs": inputs, "outputs": outputs, "evaluations": table.points(), "wanted": wanted})
}

fn output(name: &str, found: &Analysis) -> Value {
    let broken = found.status == Status::ProductFormBroken;
    let indexed = found.first_order.is_some();
    let mdrm = |indices: &Option<Vec<f64>>| indices.clone().filter(|_| broken);
    json!({
        "name": name,
        "mean": found.mean,
        "variance": found.variance,
        "first_order": found.first_order,
        "total": found.total,
        "second_order": found.second_order,
        "status": found.status.as_str(),
        "reason": found.reason,
        "method": found.method.as_str(),
        "mdrm_first_order": mdrm(&found.mdrm_first_order),
        "mdrm_total": mdrm(&found.mdrm_total),
        "error": {
            "quadrature": found.error.quadrature.filter(|_| indexed),
            "decomposition": found.error.decomposition.filter(|_| indexed),
            "sampling": found.error.sampling,
            "floor": found.error.floor,
            "total": found.error.total.filter(|_| indexed),
            "by_input": found.error.by_input.clone().filter(|_| indexed),
        },
    })
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
