//! The published study's tables of force errors beside the rig's, for people.

use std::fmt::Write;

use placement::result::{PublishedRow, PublishedTables, StudyResult};

use crate::cli::terminal::paint::{HEADER, header};
use crate::cli::terminal::report::layout_table::number;
use crate::cli::terminal::wrapping::{labelled, wrapped};

const AXES: [&str; 3] = ["fx", "fy", "fz"];
const HEAD: &str = "                                           fx, NRMSE %          fy, NRMSE %          fz, NRMSE %\n\
                    table  gait              model        printed  rig  mean   printed  rig  mean   printed  rig  mean\n";

/// The published tables of a result; nothing where it has none.
pub fn published_forces(result: &StudyResult) -> String {
    let published = result.forces.as_ref().and_then(|it| it.published.as_ref());
    let Some(tables) = published else {
        return String::new();
    };
    let question = format!(
        "how does the rig compare with the published study's tables, by layout {}?",
        tables.layout_rank
    );
    let mut text = format!(
        "\n{}{}",
        labelled(HEADER, "published", &question),
        header(HEAD)
    );
    let firsts = tables.rows.iter().filter(|row| row.axis == AXES[0]);
    text.extend(firsts.map(|first| line(first, &tables.rows)));
    text.push_str(&wrapped(
        "rig: the virtual rig under the same conditions; mean: what the mean force would reach there. before, after: temporal cross-validation. *: the printed \
         figures contradict others.",
        0,
    ));
    let marked = tables.rows.iter().filter_map(|row| {
        let contradiction = row.printed.contradiction.as_ref()?;
        let named = format!(
            "* table {}, {}, {}, {}: {}",
            row.table,
            row.gait,
            model(row),
            row.axis,
            contradiction.detail
        );
        Some(wrapped(&named, 2))
    });
    text.extend(marked);
    text + &time_constants(tables)
}

/// The three forces of a printed row.
fn line(first: &PublishedRow, rows: &[PublishedRow]) -> String {
    let mut line = format!(
        "{:>5}  {:<16}  {:<12}",
        first.table,
        first.gait,
        model(first)
    );
    for axis in AXES {
        let same = |row: &&PublishedRow| {
            row.axis == axis
                && (row.table, &row.gait, row.model, row.features, row.by)
                    == (
                        first.table,
                        &first.gait,
                        first.model,
                        first.features,
                        first.by,
                    )
        };
        let Some(row) = rows.iter().find(same) else {
            continue;
        };
        let mark = if row.printed.contradiction.is_some() {
            '*'
        } else {
            ' '
        };
        let rig =
            |of: fn(&placement::result::RigFigures) -> Option<f64>| row.rig.as_ref().and_then(of);
        let _ = write!(
            line,
            "{:>6.2}{mark}{:>6}{:>6}  ",
            row.printed.nrmse_percent,
            number(rig(|figures| figures.nrmse_percent), 1),
            number(rig(|figures| figures.mean_nrmse_percent), 1),
        );
    }
    format!("{}\n", line.trim_end())
}

/// The model with what tells its rows apart.
fn model(row: &PublishedRow) -> String {
    let model = row.model.as_str();
    match (row.table, row.by.as_str()) {
        (4 | 5, _) => format!("{model} {}", row.features.as_str()),
        (8 | 9, "time") => format!("{model} after"),
        (8 | 9, _) => format!("{model} before"),
        _ => model.to_owned(),
    }
}

/// What the layout's circuit would have to hold.
fn time_constants(tables: &PublishedTables) -> String {
    let told = tables.time_constants.iter().filter(|row| row.axis == "fz");
    let words: Vec<String> = told
        .map(|row| {
            format!(
                "{} % (R2 {}) by {} s",
                number(row.error.nrmse_percent, 1),
                number(row.error.r2, 2),
                row.time_constant_s
            )
        })
        .collect();
    match words.is_empty() {
        true => String::new(),
        false => wrapped(
            &format!(
                "fz of that layout on runs with other films, by its circuit's time constant: {}.",
                words.join(", ")
            ),
            0,
        ),
    }
}
