//! Columns of ranked locations, and of every strain's indices.

use fem_client::solver::direction::Direction;

use super::answer_table::Table;
use super::figure_column::Column;
use crate::location_scores::SCORES;

/// Columns for rows of [`locations`](super::table_rows::locations).
pub fn locations() -> Table {
    let at = |name: &str| format!("/location/{name}");
    let float = |name: String| Column::float(&name, &at(&name));
    let of_each = |field: &dyn Fn(Direction) -> Option<String>| {
        Direction::ALL
            .into_iter()
            .filter_map(field)
            .map(float)
            .collect::<Vec<_>>()
    };
    let mut columns = vec![
        Column::integer("rank", "/location/rank"),
        Column::text("name", "/location/name"),
        Column::text("input", "/location/input"),
    ];
    for score in SCORES {
        columns.extend(of_each(&|direction| Some(score.field(direction))));
    }
    for direction in Direction::ALL {
        let name = format!("rank_{direction}");
        columns.push(Column::integer(&name, &at(&name)));
    }
    columns.push(Column::bool("rank_certain", "/location/rank_certain"));
    for score in SCORES {
        columns.extend(of_each(&|direction| score.error_field(direction)));
    }
    Table {
        name: "locations",
        parts: &[("location", "RankedLocation")],
        columns,
    }
}

/// Columns for rows of [`indices`](super::table_rows::indices).
pub fn indices() -> Table {
    let columns = vec![
        Column::text("location", "/output/location"),
        Column::text("direction", "/output/direction"),
        Column::text("input", "/input/name"),
        Column::float("first_order", "/own/first_order"),
        Column::float("total", "/own/total"),
        Column::float("error_mesh", "/output/error/mesh"),
        Column::float("error_quadrature", "/output/error/quadrature"),
        Column::float("error_decomposition", "/output/error/decomposition"),
        Column::float("error_total", "/output/error/total"),
        Column::float("mean_strain", "/output/mean"),
        Column::float("std_strain", "/output/std"),
        Column::text("method", "/output/method"),
        Column::text("status", "/output/status"),
        Column::float("mdrm_first_order", "/own/mdrm_first_order"),
    ];
    Table {
        name: "indices",
        parts: &[
            ("output", "Output"),
            ("input", "InputReport"),
            ("own", "Output"),
        ],
        columns,
    }
}
