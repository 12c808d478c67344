//! Forces by layouts' films, and how well they are known, for people: a line for each layout and force that its films tell.

use std::fmt::Write;

use document::visible::visible;
use results::columns::{self, Column, table_rows};
use results::{
    AlikeError, DriftError, ElsewhereError, ForceError, ForceFindings, RankedLayout, StudyResult,
    TableReport,
};
use serde_json::Value;

use crate::cli::terminal::figures::Figures;
use crate::cli::terminal::paint::HEADER;
use crate::cli::terminal::report::glued_films::glued;
use crate::cli::terminal::report::layout_table::{DESCRIBED, NAMED, described};
use crate::cli::terminal::wrapping::{labelled, wrapped};

const QUESTION: &str = "how far off are they, learnt from a virtual rig, on runs with other films?";
const NAMES: &str = "rank  layout";
/// Contacts that are alike.
const UPRIGHT: &str = "an upright wheel on flat ground";
/// Lines of layouts that are printed.
const SHOWN: usize = 12;
const AXES: [&str; 3] = ["fx", "fy", "fz"];

/// The forces of a result; nothing where it has none.
pub fn forces(result: &StudyResult) -> String {
    let Some(findings) = &result.forces else {
        return String::new();
    };
    let mut text = format!("\n{}", labelled(HEADER, "forces", QUESTION));
    let told: Vec<(&RankedLayout, &ForceError)> = result
        .layouts
        .iter()
        .flat_map(|layout| {
            layout
                .force_error
                .iter()
                .flatten()
                .map(move |of| (layout, of))
        })
        .collect();
    let useful = told.iter().filter(|(_, force)| force.useful);
    let useful: Vec<_> = useful.collect();
    let shown = &useful[..useful.len().min(SHOWN)];
    if !shown.is_empty() {
        let row =
            |(layout, force): &&(&RankedLayout, &ForceError)| table_rows::force(layout, force);
        let rows: Vec<_> = shown.iter().map(row).collect();
        let figures = Figures::of(&columns::forces().view("known"), &rows);
        text.push_str(&figures.head(NAMES, NAMED, ""));
        for (row, (layout, _)) in shown.iter().enumerate() {
            let _ = writeln!(
                text,
                "{:>4}  {:<DESCRIBED$}{}",
                layout.rank,
                described(layout),
                figures.row(row)
            );
        }
    }
    if useful.len() > SHOWN {
        let _ = writeln!(
            text,
            "{} more are in the result: --json -",
            useful.len() - SHOWN
        );
    }
    text.push_str(&untold(&told));
    text.push_str(&prices(findings, &told));
    text.push_str(&drifts(&told));
    text.push_str(&alike(&told));
    text.push_str(&elsewhere(&told));
    text.push_str(&below(findings));
    text
}

fn number(value: Option<f64>, digits: usize) -> String {
    value.map_or("-".to_owned(), |value| format!("{value:.digits$}"))
}

/// Forces that no layout's films tell.
fn untold(told: &[(&RankedLayout, &ForceError)]) -> String {
    let is_useless = |axis: &&&str| {
        let mut of_axis = told
            .iter()
            .filter(|(_, force)| force.axis == **axis)
            .peekable();
        of_axis.peek().is_some() && of_axis.all(|(_, force)| !force.useful)
    };
    let useless: Vec<&str> = AXES.iter().filter(is_useless).copied().collect();
    match useless.as_slice() {
        [] => String::new(),
        axes => wrapped(
            &format!(
                "{}: no layout's films tell more than the training mean does.",
                axes.join(", ")
            ),
            0,
        ),
    }
}

/// Says what each force's error costs in films, beside what no estimator can be better than.
fn prices(findings: &ForceFindings, told: &[(&RankedLayout, &ForceError)]) -> String {
    let of_axis = |axis: &str| {
        let own = findings.price.iter().filter(|price| price.axis == axis);
        let words: Vec<String> = own
            .map(|price| {
                let is_its = |(layout, force): &&(&RankedLayout, &ForceError)| {
                    layout.rank == price.layout_rank && force.axis == axis
                };
                let force = told.iter().find(is_its).map(|(_, force)| force);
                let floor = force.and_then(|force| force.floor_n);
                let range = force.and_then(|force| force.range_by_drift_n());
                let by_drift = range.map_or(String::new(), |(low, high)| {
                    format!("{low:.2} to {high:.2} by drift; ")
                });
                format!(
                    "{} films to {:.2} N ({by_drift}bound {})",
                    price.films,
                    price.rmse_n,
                    number(floor, 2)
                )
            })
            .collect();
        (!words.is_empty())
            .then(|| wrapped(&format!("{axis} is known by {}.", words.join(", by ")), 0))
    };
    AXES.iter().filter_map(|axis| of_axis(axis)).collect()
}

/// Says how the same estimators fare on other tires.
fn elsewhere(told: &[(&RankedLayout, &ForceError)]) -> String {
    let table = columns::elsewhere();
    let rows = |force: &ForceError| {
        let on = |other: &ElsewhereError| (other.tire.clone(), table_rows::force_on(other, force));
        force.elsewhere.iter().map(on).collect()
    };
    changed(told, "on another tire", &table.view("other tires"), rows)
}

/// Says how far layouts are off where their readings drift otherwise.
fn drifts(told: &[(&RankedLayout, &ForceError)]) -> String {
    let table = columns::drifts();
    let rows = |force: &ForceError| {
        let with = |other: &DriftError| (other.drift.clone(), table_rows::force_with(other, force));
        force.drift.iter().map(with).collect()
    };
    changed(
        told,
        "learnt with another drift",
        &table.view("drift"),
        rows,
    )
}

/// Says how far layouts are off where contacts differ in their angle, load and shear alone.
fn alike(told: &[(&RankedLayout, &ForceError)]) -> String {
    let table = columns::drifts();
    let rows = |force: &ForceError| {
        let with = |alike: &AlikeError| (UPRIGHT.to_owned(), table_rows::force_alike(alike, force));
        force.alike.iter().map(with).collect()
    };
    changed(told, "learnt on", &table.view("drift"), rows)
}

/// Says, for each thing that is changed, what becomes of each layout's forces; `rows` has them with the change in words.
fn changed(
    told: &[(&RankedLayout, &ForceError)],
    title: &str,
    columns: &[&Column],
    rows: impl Fn(&ForceError) -> Vec<(String, Value)>,
) -> String {
    let mut changes: Vec<(String, Vec<String>)> = Vec::new();
    for (layout, force) in told.iter().filter(|(_, force)| force.useful) {
        for (change, row) in rows(force) {
            let figures = columns.iter().map(|column| column.in_words(&row));
            let figures: Vec<String> = figures.collect();
            let (rank, axis) = (layout.rank, &force.axis);
            let words = format!("layout {rank}: {axis} {}", figures.join(", "));
            match changes.iter_mut().find(|(known, _)| *known == change) {
                Some((_, known)) => known.push(words),
                None => changes.push((change, vec![words])),
            }
        }
    }
    let lines = changes.iter().map(|(change, words)| {
        let line = format!("{title} ({}): {}.", visible(change), words.join("; "));
        wrapped(&line, 2)
    });
    lines.collect()
}

/// Says how far the table is off that the rig reads, and what is missing.
fn below(findings: &ForceFindings) -> String {
    let error = |table: &TableReport| {
        let error = table.error?;
        Some(wrapped(
            &format!(
                "The rig reads a table of {} solves ({}, to {} N), off by {:.2} % of a film's full scale at most, {:.3} % rms; forces by {:.2} % of the load. \
                 What is assumed of the rig is in the result: forces.assumed.",
                table.solves,
                visible(&table.level),
                table.largest_load_n,
                100.0 * error.signal_worst,
                100.0 * error.signal_rms,
                100.0 * error.force_worst,
            ),
            0,
        ))
    };
    let table = findings.table.as_ref();
    let films = table.and_then(|table| table.films.as_ref()).map(glued);
    let table = table.and_then(error).unwrap_or_default() + &films.unwrap_or_default();
    let reasons = findings.reasons.iter();
    table
        + &reasons
            .map(|reason| wrapped(&visible(reason), 0))
            .collect::<String>()
}
