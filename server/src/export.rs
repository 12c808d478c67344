//! Answers as tables for other programs: comma-separated values, a header and one row per thing.
//!
//! Every row ends with the study, the hash of its document and the version of the program, so that rows of several studies can
//! be put under each other. Strains have no unit, as in all data; other columns carry theirs in their names. What doesn't exist
//! is an empty field.

use placement::result::{InputReport, StudyResult};
use serde::Deserialize;
use utoipa::ToSchema;

use crate::points::EvaluationView;

/// What is wanted of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, ToSchema, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Table {
    /// Indices of every strain with their errors: one row per location, direction and input.
    Indices,
    /// Ranked locations.
    Locations,
    /// Ranked layouts.
    Layouts,
    /// Solved points: inputs, force, strains.
    Points,
}

impl Table {
    /// The name in addresses and file names.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Indices => "indices",
            Self::Locations => "locations",
            Self::Layouts => "layouts",
            Self::Points => "points",
        }
    }

    /// The table of this name.
    pub fn named(name: &str) -> Option<Self> {
        [Self::Indices, Self::Locations, Self::Layouts, Self::Points]
            .into_iter()
            .find(|table| table.as_str() == name)
    }
}

/// A table of a result as CSV; `points` are read for [`Table::Points`] alone.
pub fn csv(table: Table, result: &StudyResult, points: &[EvaluationView]) -> String {
    let mut rows = match table {
        Table::Indices => indices(result),
        Table::Locations => locations(result),
        Table::Layouts => layouts(result),
        Table::Points => solved(&result.inputs, points),
    };
    let study = &result.study;
    let origin = [&study.id, &study.spec_sha256, &study.version];
    for (line, row) in rows.iter_mut().enumerate() {
        if line == 0 {
            row.extend(["study", "spec_sha256", "version"].map(str::to_owned));
        } else {
            row.extend(origin.map(Clone::clone));
        }
    }
    written(&rows)
}

type Row = Vec<String>;

fn header(names: &[&str]) -> Row {
    names.iter().map(|name| (*name).to_owned()).collect()
}

/// The shortest text that reads back as the same number.
fn text<T: ToString>(value: Option<T>) -> String {
    value.map(|value| value.to_string()).unwrap_or_default()
}

fn indices(result: &StudyResult) -> Vec<Row> {
    let mut rows = vec![header(&[
        "location",
        "direction",
        "input",
        "first_order",
        "total",
        "error_mesh",
        "error_quadrature",
        "error_decomposition",
        "error_total",
        "mean_strain",
        "std_strain",
        "method",
        "status",
        "mdrm_first_order",
    ])];
    for output in &result.outputs {
        let at = |list: &Option<Vec<f64>>, k: usize| text(list.as_ref().and_then(|l| l.get(k)));
        for (k, input) in result.inputs.iter().enumerate() {
            rows.push(vec![
                output.location.clone(),
                output.direction.clone(),
                input.name.clone(),
                at(&output.first_order, k),
                at(&output.total, k),
                text(output.error.mesh),
                text(output.error.quadrature),
                text(output.error.decomposition),
                text(output.error.total),
                text(output.mean),
                text(output.std),
                output.method.clone(),
                output.status.clone(),
                at(&output.mdrm_first_order, k),
            ]);
        }
    }
    rows
}

fn locations(result: &StudyResult) -> Vec<Row> {
    let mut rows = vec![header(&[
        "rank",
        "name",
        "gsi_x_percent",
        "gsi_y_percent",
        "mean_gsi_x_percent",
        "mean_gsi_y_percent",
        "own_gsi_x_percent",
        "own_gsi_y_percent",
        "mdrm_gsi_x_percent",
        "mdrm_gsi_y_percent",
        "rank_x",
        "rank_y",
        "rank_certain",
        "gsi_x_error_percent",
        "gsi_y_error_percent",
    ])];
    rows.extend(result.locations.iter().map(|l| {
        vec![
            l.rank.to_string(),
            l.name.clone(),
            text(l.gsi_x_percent),
            text(l.gsi_y_percent),
            text(l.mean_gsi_x_percent),
            text(l.mean_gsi_y_percent),
            text(l.own_gsi_x_percent),
            text(l.own_gsi_y_percent),
            text(l.mdrm_gsi_x_percent),
            text(l.mdrm_gsi_y_percent),
            text(l.rank_x),
            text(l.rank_y),
            l.rank_certain.to_string(),
            text(l.gsi_x_error_percent),
            text(l.gsi_y_error_percent),
        ]
    }));
    rows
}

fn layouts(result: &StudyResult) -> Vec<Row> {
    let mut rows = vec![header(&[
        "rank",
        "spacing_deg",
        "units",
        "position",
        "films",
        "weakest_signal_strain",
        "worst_angle_error_deg",
        "rms_angle_error_deg",
        "worst_depth_error_mm",
        "noise_strain",
        "reason",
    ])];
    rows.extend(result.layouts.iter().map(|layout| {
        let score = &layout.score;
        vec![
            layout.rank.to_string(),
            layout.spacing_deg.to_string(),
            layout.units.to_string(),
            layout.position.clone(),
            layout.films.join("+"),
            text(score.weakest_signal),
            text(score.worst_angle_error_deg),
            text(score.rms_angle_error_deg),
            text(score.worst_depth_error_mm),
            score.noise_strain.to_string(),
            text(score.reason.as_ref()),
        ]
    }));
    rows
}

/// One column per input and two per location; locations are those of the first point that has any.
fn solved(inputs: &[InputReport], points: &[EvaluationView]) -> Vec<Row> {
    let seen = points.iter().find_map(|point| point.locations.as_ref());
    let names: Vec<&str> = seen
        .map(|locations| locations.iter().map(|l| l.name.as_str()).collect())
        .unwrap_or_default();
    let mut head = header(&["ordinal", "level"]);
    head.extend(inputs.iter().map(|input| input.name.clone()));
    head.push("reaction_n".to_owned());
    for name in &names {
        head.extend(["x", "y"].map(|direction| format!("{name}_strain_{direction}")));
    }
    head.extend(header(&["newton_iterations", "wall_s", "reason", "key"]));
    let mut rows = vec![head];
    rows.extend(points.iter().map(|point| {
        let mut row = vec![point.ordinal.to_string(), text(point.level.as_ref())];
        let value = |k: usize| point.values.as_ref().and_then(|values| values.get(k));
        row.extend((0..inputs.len()).map(|k| text(value(k))));
        row.push(text(point.reaction_n));
        for name in &names {
            let strains = point.locations.as_ref();
            let strain = strains.and_then(|all| all.iter().find(|l| l.name == *name));
            row.push(text(strain.map(|l| l.strain_x)));
            row.push(text(strain.map(|l| l.strain_y)));
        }
        row.push(text(point.newton_iterations));
        row.push(point.wall_s.to_string());
        row.push(text(point.reason.as_ref()));
        row.push(point.key.clone());
        row
    }));
    rows
}

/// Quotes what needs it (RFC 4180), one line per row.
fn written(rows: &[Row]) -> String {
    let mut text = String::new();
    for row in rows {
        let fields: Vec<String> = row.iter().map(|field| quoted(field)).collect();
        text.push_str(&fields.join(","));
        text.push('\n');
    }
    text
}

fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_users_name_can_not_break_a_row() {
        let row = |fields: &[&str]| fields.iter().map(|f| (*f).to_owned()).collect::<Row>();
        let rows = [row(&["plain", "a,b"]), row(&["say \"P3\"", "two\nlines"])];
        assert_eq!(
            written(&rows),
            "plain,\"a,b\"\n\"say \"\"P3\"\"\",\"two\nlines\"\n"
        );
    }
}
