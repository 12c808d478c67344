//! The tables of a study's answer.
//!
//! Every row ends with the study, the hash of its document and the version of the program, so that rows of several studies can
//! be put under each other. Strains have no unit, as in all data; other columns carry theirs in their names.

use fem_client::solver::direction::Direction;
use results::columns::unit::{PURE, unit_of};
use results::columns::{self, Column, table_rows};
use results::{InputReport, StudyResult};
use serde_json::{Value, json};

use super::export_choice::Table;
use super::table::TypedTable;
use crate::wire::study_wire::EvaluationView;

/// A table of a result; `points` are read for [`Table::Points`] alone.
pub fn table(table: Table, result: &StudyResult, points: &[EvaluationView]) -> TypedTable {
    let (described, rows) = match table {
        Table::Indices => (columns::indices(), table_rows::indices(result)),
        Table::Locations => (columns::locations(), table_rows::locations(result)),
        Table::Layouts => (columns::layouts(), table_rows::layouts(result)),
        Table::Trade => (columns::trade(), table_rows::trade(result)),
        Table::Films => (columns::films(), table_rows::films(result)),
        Table::Candidates => (columns::candidates(), table_rows::candidates(result)),
        Table::Signals => (columns::signals(), table_rows::signals(result)),
        Table::Forces => (columns::forces(), table_rows::forces(result)),
        Table::Points => return signed(solved(&result.inputs, points), result),
    };
    signed(TypedTable::of(described.exported(), &rows), result)
}

/// Adds the columns that say where the rows are from.
fn signed(table: TypedTable, result: &StudyResult) -> TypedTable {
    let study = &result.study;
    table
        .constant("study", &study.id)
        .constant("spec_sha256", &study.spec_sha256)
        .constant("version", &study.version)
}

/// Makes a table with one column per input and two per location; locations are those of the first point that has any.
fn solved(inputs: &[InputReport], points: &[EvaluationView]) -> TypedTable {
    let seen = points.iter().find_map(|point| point.locations.as_ref());
    let names: Vec<&str> = seen
        .into_iter()
        .flatten()
        .map(|location| location.name.as_str())
        .collect();
    let mut columns = vec![
        Column::integer("ordinal", "/point/ordinal"),
        Column::text("level", "/point/level"),
    ];
    for (k, input) in inputs.iter().enumerate() {
        let column = Column::float(&input.name, &format!("/point/values/{k}"));
        columns.push(column.in_unit(unit_of(&input.vary)));
    }
    columns.push(Column::float("reaction_n", "/point/reaction_n"));
    for (k, name) in names.iter().enumerate() {
        for direction in Direction::ALL {
            let (name, at) = (
                format!("{name}_strain_{direction}"),
                format!("/locations/{k}/strain_{direction}"),
            );
            columns.push(Column::float(&name, &at).in_unit(PURE));
        }
    }
    columns.extend([
        Column::integer("newton_iterations", "/point/newton_iterations"),
        Column::float("wall_s", "/point/wall_s"),
        Column::text("reason", "/point/reason"),
        Column::text("key", "/point/key"),
    ]);
    let rows: Vec<Value> = points
        .iter()
        .map(|point| point_row(point, &names))
        .collect();
    TypedTable::of(&columns, &rows)
}

/// A point with its strains at the locations of these names, null where it hasn't one.
fn point_row(point: &EvaluationView, names: &[&str]) -> Value {
    let at = |name: &&str| {
        let mut all = point.locations.iter().flatten();
        all.find(|location| location.name == *name)
    };
    let locations: Vec<_> = names.iter().map(at).collect();
    json!({ "point": point, "locations": locations })
}
