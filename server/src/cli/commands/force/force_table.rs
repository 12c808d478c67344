//! What a fit found, for people: the answer first, then how sure it is, then every model beside it.

use std::fmt::Write as _;

use estimation::fit_report::{ForceReport, ModelReport, Report, SplitReport};
use estimation::recipe::Kind;

use crate::cli::terminal::paint::{BAD, GOOD, HEADER, painted};

/// The report as text.
pub fn table(report: &Report) -> String {
    let mut text = String::new();
    for force in &report.forces {
        text.push_str(&answer(force));
    }
    text.push('\n');
    for force in &report.forces {
        text.push_str(&models(force));
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
            force.force, figures.rmse_n
        );
    }
    let range = figures
        .rmse_interval_n
        .map_or(String::new(), |(low, high)| {
            format!(" ({low:.3} to {high:.3})")
        });
    format!(
        "{}: {}, off by {} N{range} on {}\n",
        force.force,
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

fn models(force: &ForceReport) -> String {
    let head = format!(
        "{:<8}{:<9}{:>9}{:>8}{:>8}{:>7}{:>9}{:>9}   {:>8}{:>8}{:>8}{:>8}{:>8}{:>7}",
        force.force,
        "features",
        "RMSE N",
        "NRMSE %",
        "mean %",
        "R2",
        "covered",
        "width N",
        "random",
        "cycle",
        "run",
        "time",
        "freq.",
        "leak"
    );
    let rows: String = force.models.iter().map(row).collect();
    format!("{}\n{rows}\n", painted(HEADER, head))
}

fn row(model: &ModelReport) -> String {
    let figures = &model.validation;
    let number =
        |x: Option<f64>, digits: usize| x.map_or("-".to_owned(), |x| format!("{x:.digits$}"));
    let split =
        |report: &Option<SplitReport>| number(report.as_ref().map(|report| report.rmse_n), 3);
    let splits = &model.splits;
    format!(
        "{:<8}{:<9}{:>9.3}{:>8}{:>8}{:>7}{:>9}{:>9}   {:>8}{:>8}{:>8}{:>8}{:>8}{:>7}\n",
        model.model.as_str(),
        if model.model == Kind::Mean {
            "-"
        } else {
            model.features.as_str()
        },
        figures.rmse_n,
        number(figures.nrmse_percent, 2),
        number(figures.mean_nrmse_percent, 2),
        number(figures.r2, 3),
        number(figures.coverage, 2),
        number(figures.width_n, 3),
        split(&splits.random),
        split(&splits.cycle),
        split(&splits.run),
        split(&splits.time),
        split(&splits.frequency),
        number(model.leak_factor, 2),
    )
}
