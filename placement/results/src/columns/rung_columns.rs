//! Columns of a trade's rungs: what accuracy a second buys.

use super::answer_table::Table;
use super::figure_column::Column;

/// Columns for rows of a rung.
pub fn rungs() -> Table {
    let shown =
        |column: Column, title: &str, digits: usize| column.titled(title, digits).in_view("rungs");
    let columns = vec![
        Column::text("label", "/rung/label"),
        Column::text("level", "/rung/fidelity/level"),
        Column::text("method", "/rung/fidelity/method"),
        Column::integer("nodes", "/rung/fidelity/nodes"),
        Column::integer("check_points", "/rung/fidelity/check_points"),
        shown(Column::float("wall_s", "/rung/wall_s"), "wall", 2),
        shown(Column::float("cpu_s", "/rung/cpu_s"), "CPU", 2),
        shown(Column::integer("solves", "/rung/solves"), "solves", 0),
        shown(
            Column::float("error_true", "/rung/error_true"),
            "largest error",
            4,
        ),
        shown(
            Column::float("error_claimed", "/rung/error_claimed"),
            "claimed error",
            4,
        ),
        shown(
            Column::share("covered", "/rung/covered"),
            "claims that hold",
            0,
        ),
        Column::bool("ranking_agrees", "/rung/ranking_agrees"),
        Column::bool("pareto", "/rung/pareto"),
    ];
    Table {
        name: "rungs",
        parts: &[("rung", "Rung")],
        columns,
    }
}
