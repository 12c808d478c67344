//! `strainsite gsa`: sensitivity analysis of a model that others run.
//!
//! `plan` prints the points to run; `analyse` reads their outputs back. An adaptive method goes on: `plan` again with the
//! values so far prints what is still to be run.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use ::gsa::campaign::Campaign;
use ::gsa::design::DesignError;
use ::gsa::method::Kind;
use ::gsa::method::analysis::{Analysis, Status};
use clap::{Args, Subcommand};
use document::fault::Fault;
use document::visible::visible;
use documents::own_model::csv_cell;
use documents::own_model::fingerprint::fingerprint;
use documents::own_model::inputs_document::Inputs;
use documents::own_model::value_table::{PLAN_COLUMN, Planned, ValueTable};
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

fn no_plan(error: &DesignError) -> Failure {
    Failure::Input(vec![Fault {
        pointer: "/inputs".to_owned(),
        detail: error.to_string(),
    }])
}

/// The fingerprint of what these inputs plan before there are values.
fn fingerprint_of(inputs: &Inputs) -> Result<String, Failure> {
    let campaign = Campaign::new(&inputs.laws, inputs.method).map_err(|error| no_plan(&error))?;
    Ok(fingerprint(&inputs.names, campaign.points()))
}

/// Values belong to the plan, or to none: points that they lack are no fault.
fn check(table: &ValueTable, inputs: &Inputs, campaign: &Campaign) -> Result<(), Failure> {
    let plan = Planned {
        inputs: &inputs.names,
        points: campaign.points(),
        fingerprint: &fingerprint_of(inputs)?,
    };
    table.check_plan(&plan).map_err(Failure::Input)
}

/// The campaign as these values leave it, and what they say so far, if they are enough to say anything.
fn replay(
    inputs: &Inputs,
    values: &ArrayView2<f64>,
) -> Result<(Campaign, Option<Vec<Analysis>>), Failure> {
    let waiting = clock("planning and analysing");
    let replayed = Campaign::replay(&inputs.laws, inputs.method, values);
    waiting.finish_and_clear();
    replayed.map_err(|error| no_plan(&error))
}

impl Plan {
    fn execute(&self) -> Result<(), Failure> {
        let inputs = read_inputs(&self.inputs)?;
        let table = match &self.values {
            Some(path) => read_values(path, &inputs)?,
            None => ValueTable::empty(),
        };
        let (campaign, _) = replay(&inputs, &table.leading_rows().view())?;
        check(&table, &inputs, &campaign)?;
        let missing: Vec<usize> = (0..campaign.points().len())
            .filter(|id| !table.has(*id))
            .collect();
        let text = self.table(&inputs, &campaign, &missing)?;
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

impl Plan {
    /// The rows of these points, under their header.
    fn table(
        &self,
        inputs: &Inputs,
        campaign: &Campaign,
        points: &[usize],
    ) -> Result<String, Failure> {
        let last = match self.fingerprint {
            true => Some(fingerprint_column(inputs)?),
            false => None,
        };
        let (id, plan) = ("id".to_owned(), PLAN_COLUMN.to_owned());
        let of_plan = last.iter().map(|_| &plan);
        let columns = std::iter::once(&id).chain(&inputs.names).chain(of_plan);
        let mut text = csv_cell::line(columns);
        for &id in points {
            text.push_str(&id.to_string());
            for x in &campaign.points()[id] {
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
        None => fingerprint_of(inputs),
    }
}

impl Analyse {
    fn execute(&self) -> Result<(), Failure> {
        let inputs = read_inputs(&self.inputs)?;
        let table = read_values(&self.values, &inputs)?;
        let rows = table.leading_rows();
        let (campaign, found) = replay(&inputs, &rows.view())?;
        let points = campaign.points().len();
        check(&table, &inputs, &campaign)?;
        let Some(found) = found else {
            return Err(Failure::Input(table.missing_ids(points)));
        };
        let printed = found.into_iter().zip(table.half_units());
        let found: Vec<Analysis> = printed
            .map(|(found, half_unit)| match half_unit > 0.0 {
                true => found.of_printed(half_unit),
                false => found,
            })
            .collect();
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
        let mut text = people_table(&inputs.names, table.outputs(), &found);
        if inputs.method.kind != Kind::Auto && found.iter().any(says_little) {
            let advice = painted(WARNING, "an error is as large as the indices:");
            text += &format!("{advice} {MORE_POINTS}\n");
        }
        tell(&text, self.json.as_ref())?;
        match &self.json {
            Some(target) => target.write(&document(&inputs.names, &table, &found, wanted)),
            None => Ok(()),
        }
    }
}

/// Advice where a method with a plan of its own says little.
const MORE_POINTS: &str = "method = { kind = \"auto\" } in the file of inputs asks for more points until it is within its tolerance; the values that you have serve it, too";

/// Whether the claimed error is as large as the largest index.
fn says_little(found: &Analysis) -> bool {
    let largest = found
        .first_order
        .iter()
        .flatten()
        .copied()
        .fold(0.0, f64::max);
    found
        .error
        .total
        .is_some_and(|error| found.first_order.is_some() && error >= largest)
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
            "lost": found.error.lost.filter(|_| indexed),
            "rounding": found.error.rounding.filter(|_| indexed),
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
