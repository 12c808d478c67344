//! Findings of a fit, for people: the answer first, then how sure it is, then every model beside it.

use std::fmt::Write as _;

use document::visible::visible;
use estimation::fit_report::{ForceReport, ModelReport, Report};
use estimation::recipe::Kind;

use results::columns;
use serde_json::json;

use crate::cli::commands::force::force_beginnings::beginnings;
use crate::cli::terminal::figures::Figures;
use crate::cli::terminal::paint::{BAD, GOOD, painted};

/// Characters of a model's name and its features, and of the name alone.
const NAMED: usize = 16;
const MODEL: usize = 8;

/// The report as text.
pub(crate) fn report_text(report: &Report) -> String {
    let mut text = String::new();
    for force in &report.forces {
        text.push_str(&answer(force));
    }
    text.push('\n');
    for force in &report.forces {
        text.push_str(&models(force));
    }
    for force in &report.forces {
        text.push_str(&beginnings(force));
    }
    // Writing to a text can't fail.
    let _ = writeln!(text, "{}", report.promise);
    for note in &report.notes {
        let _ = writeln!(text, "{note}");
    }
    text
}

fn answer(force: &ForceReport) -> String {
    let Some(model) = force.models.first() else {
        return String::new();
    };
    let figures = &model.validation;
    if force.chosen == Kind::Mean {
        let word = painted(BAD, "useless");
        return format!(
            "{}: {word}: no model knows it better than the training mean, off by {:.3} N\n",
            visible(&force.force),
            figures.rmse_n
        );
    }
    let range = figures
        .rmse_interval_n
        .map_or(String::new(), |(low, high)| {
            format!(" ({low:.3} to {high:.3})")
        });
    format!(
        "{}: {}, off by {} N{range} on {}\n",
        visible(&force.force),
        chosen(model),
        painted(GOOD, format!("{:.3}", figures.rmse_n)),
        match figures.by.as_str() {
            "run" => "runs it didn't learn from",
            "cycle" => "cycles it didn't learn from",
            "time" => "later rows than it learnt from",
            "frequency" => "frequencies it didn't learn from",
            _ => "rows drawn at random",
        }
    )
}

fn chosen(model: &ModelReport) -> String {
    let named: Vec<String> = model
        .members
        .iter()
        .map(|member| format!("{} {}", member.model.as_str(), member.features.as_str()))
        .collect();
    match named.split_last() {
        Some((last, others)) => format!("blend of {} and {last}", others.join(", ")),
        None => format!(
            "{} on {} features",
            model.model.as_str(),
            model.features.as_str()
        ),
    }
}

/// Models beside each other: on the split that chooses, on every split, and how far a random split would have misled.
fn models(force: &ForceReport) -> String {
    let row = |model: &ModelReport| json!({ "force": { "force": force.force }, "model": model });
    let rows: Vec<_> = force.models.iter().map(row).collect();
    let table = columns::models();
    let columns = ["judged", "splits", "leak"].map(|view| table.view(view));
    let figures = Figures::of(&columns.concat(), &rows);
    // A name that doesn't fit above the models stands alone.
    let name = visible(&force.force).to_string();
    let is_short = name.chars().count() < MODEL;
    let above = if is_short { name.as_str() } else { "model" };
    let mut text = if is_short {
        String::new()
    } else {
        format!("{name}\n")
    };
    text += &figures.head(&format!("{above:<MODEL$}features"), NAMED, "");
    for (row, model) in force.models.iter().enumerate() {
        let features = match model.model {
            Kind::Mean => "-",
            _ => model.features.as_str(),
        };
        let _ = writeln!(
            text,
            "{:<MODEL$}{features:<8}{}",
            model.model.as_str(),
            figures.row(row)
        );
    }
    text + "\n"
}
