//! Indices of a model of one's own, told on the terminal and as JSON.

use ::gsa::method::analysis::{Analysis, Status};
use document::visible::visible;
use documents::own_model::own_analysis::OwnAnalysis;
use serde_json::json;

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::output::{JsonTarget, tell};
use crate::cli::terminal::paint::{HEADER, WARNING, painted};
use service::wire::analysis_wire::ModelAnalysis;

/// Tells the indices, and advice where they say little.
pub(super) fn tell_indices(
    analysis: &OwnAnalysis<'_>,
    found: &[Analysis],
    json: Option<&JsonTarget>,
) -> Result<(), Failure> {
    let mut text = people_table(analysis.inputs(), analysis.values().outputs(), found);
    if let Some(advice) = analysis.advice() {
        text += &format!("{}\n", painted(WARNING, advice));
    }
    tell(&text, json)?;
    match json {
        Some(target) => target.write(&json!(ModelAnalysis::of(analysis))),
        None => Ok(()),
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
