//! Comparison of a virtual rig with the published study's tables 4, 5, 6, 8 and 9 of force errors. The shipped study of forces, solved, with six units of
//! films at the crown. The tables of `docs/use/films/rig.md`.
//!
//! `cargo run --release -p lab --example published_tables [-- LEVEL]`, coarse when left out: ten minutes on two cores, two on the draft mesh.

use documents::study::plan::PlannedStudy;
use estimation::recipe::SplitKind;
use fem_client::scene::Level;
use lab::published::printed_figures::AXES;
use lab::published::published_gaits::ASSUMED;
use lab::published::published_rows::PublishedRow;
use lab::published::rig_tables::{RigTables, TimeConstantRow};
use lab::published::tested_forces::RigFigures;
use lab::study_runs::{level_argument, study_on, undisturbed};
use placement::points::memory::MemoryArchive;
use placement::response_table::study_table::StudyTable;
use tire::embedded::EmbeddedSolver;

/// The published study's, each with an x and a y film.
const UNITS: usize = 6;
const HEAD: &str = "                                           fx, NRMSE %                fy, NRMSE %                fz, NRMSE %\n\
                    table  gait              model        printed  rig  mean fresh   printed  rig  mean fresh   printed  rig  mean fresh";
const LEGEND: &str = "rig: the virtual rig under the same conditions; mean: what the mean force would reach there; \
                      fresh: on a run with other gains, where that isn't what rig is. before, after: temporal cross-validation. *: the printed figures contradict others.";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let PlannedStudy { study, plan } = study_on("forces", level_argument(1, Level::Coarse));
    let rig = study.rig.as_ref().expect("a rig");
    let table = StudyTable::of(&study, rig, &plan)?;
    let mut layouts = table.layouts.iter();
    let layout = layouts.find(|layout| layout.label.units == UNITS);
    let films = &layout.expect("the published layout").arrangement.films;
    let (solver, archive) = (EmbeddedSolver::default(), MemoryArchive::default());
    let tested = table.solved(&plan, undisturbed(&solver, &archive))??;
    let films = table.laid(&tested, films);
    let tables = RigTables::recorded(&films, rig);
    let rows = tables.filled();
    println!("{HEAD}");
    for first in rows.iter().filter(|row| row.axis == AXES[0]) {
        println!("{}", line(first, &rows));
    }
    println!("{LEGEND}");
    for row in &rows {
        told_contradiction(row);
        told_reason(row);
    }
    println!("{}", time_constants(&tables.time_constants()));
    for assumed in ASSUMED {
        println!("{assumed}");
    }
    Ok(())
}

/// The three forces of a printed row.
fn line(first: &PublishedRow, rows: &[PublishedRow]) -> String {
    let key = |row: &PublishedRow| (row.table, row.gait, row.model, row.features, row.by);
    let cells = AXES.map(|axis| {
        let mut same = rows.iter().filter(|row| key(row) == key(first));
        let row = same.find(|row| row.axis == axis).expect("each force");
        cell(row)
    });
    let line = format!(
        "{:>5}  {:<16}  {:<12}{}",
        first.table,
        first.gait,
        model(first),
        cells.concat()
    );
    line.trim_end().to_owned()
}

fn cell(row: &PublishedRow) -> String {
    let mark = match row.printed.contradiction {
        Some(_) => '*',
        None => ' ',
    };
    let rig = |of: fn(RigFigures) -> Option<f64>| number(row.rig.and_then(of), 1);
    let fresh = row.fresh.and_then(|figures| figures.nrmse_percent);
    format!(
        "{:>6.2}{mark}{:>6}{:>6}{:>6}  ",
        row.printed.nrmse_percent,
        rig(|figures| figures.nrmse_percent),
        rig(|figures| figures.mean_nrmse_percent),
        number(fresh, 1),
    )
}

/// The model with what tells its rows apart.
fn model(row: &PublishedRow) -> String {
    let model = row.model.as_str();
    match (row.table, row.by) {
        (4 | 5, _) => format!("{model} {}", row.features.as_str()),
        (8 | 9, SplitKind::Time) => format!("{model} after"),
        (8 | 9, _) => format!("{model} before"),
        _ => model.to_owned(),
    }
}

fn told_contradiction(row: &PublishedRow) {
    if let Some(contradiction) = &row.printed.contradiction {
        println!("* {}: {}", place(row), contradiction.detail);
    }
}

fn told_reason(row: &PublishedRow) {
    if let Some(reason) = &row.reason {
        println!("- {}: {reason}", place(row));
    }
}

fn place(row: &PublishedRow) -> String {
    let PublishedRow {
        table, gait, axis, ..
    } = row;
    format!("table {table}, {gait}, {}, {axis}", model(row))
}

/// Says what the layout's circuit would have to hold.
fn time_constants(rows: &[TimeConstantRow]) -> String {
    let told = rows.iter().filter(|row| row.axis == "fz").map(|row| {
        let [nrmse, r2] = [(row.error.nrmse_percent, 1), (row.error.r2, 2)]
            .map(|(value, digits)| number(value, digits));
        format!("{nrmse} % (R2 {r2}) by {} s", row.time_constant_s)
    });
    let told: Vec<String> = told.collect();
    format!(
        "fz of that layout on runs with other films, by its circuit's time constant: {}.",
        told.join(", ")
    )
}

fn number(value: Option<f64>, digits: usize) -> String {
    value.map_or("-".to_owned(), |value| format!("{value:.digits$}"))
}
