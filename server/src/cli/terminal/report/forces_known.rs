//! How well forces are known by layouts' films, for people: a line for each layout and force that its films tell.

use std::fmt::Write;

use fem_client::document::visible::visible;
use placement::result::{
    FilmAnglesReport, ForceError, ForceFindings, RankedLayout, StudyResult, TableReport,
};

use crate::cli::terminal::paint::{HEADER, header};
use crate::cli::terminal::report::layout_table::{DESCRIBED, described, number};
use crate::cli::terminal::wrapping::{labelled, wrapped};

const QUESTION: &str = "how far off are they, learnt from a virtual rig, on runs with other films?";
const HEAD: &str = "                                                                                  one  films\n                                              force   off by  NRMSE                dead    off\n\
                    rank  layout                                          N      %     R2  covered      N      N\n";
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
    let lines: Vec<String> = useful.map(|(layout, force)| line(layout, force)).collect();
    if !lines.is_empty() {
        text.push_str(&header(HEAD));
        text.extend(lines.iter().take(SHOWN).map(String::as_str));
    }
    if lines.len() > SHOWN {
        let _ = writeln!(
            text,
            "{} more are in the result: --json -",
            lines.len() - SHOWN
        );
    }
    text.push_str(&untold(&told));
    text.push_str(&prices(findings, &told));
    text.push_str(&elsewhere(&told));
    text.push_str(&below(findings));
    text
}

fn line(layout: &RankedLayout, force: &ForceError) -> String {
    let dead = force.dead.and_then(|dead| dead.error.rmse_n);
    format!(
        "{:>4}  {:<DESCRIBED$}{:>5}{:>9}{:>7}{:>7}{:>9}{:>7}{:>7}\n",
        layout.rank,
        described(layout),
        force.axis,
        number(force.fresh.rmse_n, 2),
        number(force.fresh.nrmse_percent, 1),
        number(force.fresh.r2, 2),
        number(force.fresh.coverage, 2),
        number(dead, 2),
        number(force.askew.error.rmse_n, 2),
    )
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

/// What each force's error costs in films, beside what no estimator can be better than.
fn prices(findings: &ForceFindings, told: &[(&RankedLayout, &ForceError)]) -> String {
    let of_axis = |axis: &str| {
        let own = findings.price.iter().filter(|price| price.axis == axis);
        let words: Vec<String> = own
            .map(|price| {
                let is_its = |(layout, force): &&(&RankedLayout, &ForceError)| {
                    layout.rank == price.layout_rank && force.axis == axis
                };
                let floor = told
                    .iter()
                    .find(is_its)
                    .and_then(|(_, force)| force.floor_n);
                format!(
                    "{} films to {:.2} N (bound {})",
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

/// The same estimators on other tires.
fn elsewhere(told: &[(&RankedLayout, &ForceError)]) -> String {
    let useful = || told.iter().filter(|(_, force)| force.useful);
    let mut tires: Vec<&str> = Vec::new();
    for other in useful().flat_map(|(_, force)| &force.elsewhere) {
        if !tires.contains(&other.tire.as_str()) {
            tires.push(&other.tire);
        }
    }
    let of_tire = |tire: &&str| {
        let words = useful().filter_map(|(layout, force)| {
            let error = force
                .elsewhere
                .iter()
                .find(|other| other.tire == **tire)?
                .error;
            let percent = |share: Option<f64>| number(share.map(|share| 100.0 * share), 0);
            Some(format!(
                "layout {}: {} off by {} N, {} % covered, {} % flagged",
                layout.rank,
                force.axis,
                number(error.rmse_n, 2),
                percent(error.coverage),
                percent(error.outside)
            ))
        });
        let words: Vec<String> = words.collect();
        wrapped(
            &format!("on another tire ({}): {}.", visible(tire), words.join("; ")),
            2,
        )
    };
    tires.iter().map(of_tire).collect()
}

/// How far the table is off that the rig reads, and what is missing.
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

/// How far the volts of glued films are off beside the contact.
fn glued(films: &FilmAnglesReport) -> String {
    let off = match (films.signal_worst, films.signal_rms) {
        (Some(worst), Some(rms)) => format!(
            "off by {:.1} % of full scale at most, {:.1} % rms, at {} solves between them",
            100.0 * worst,
            100.0 * rms,
            films.tested
        ),
        _ => "not tested".to_owned(),
    };
    wrapped(
        &format!(
            "Glued films are solved with the tire ({}) at {} angles from the contact: {off}; their transfer alone would be off by {:.1} %.",
            visible(&films.level),
            films.angles_deg.len(),
            100.0 * films.transfer_worst
        ),
        0,
    )
}
