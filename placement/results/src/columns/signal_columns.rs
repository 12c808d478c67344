//! Columns of what films read of loads, pressures and contact angles.

use super::answer_table::Table;
use super::figure_column::Column;

/// Columns for rows of [`signals`](super::table_rows::signals).
pub fn signals() -> Table {
    let columns = vec![
        Column::text("tire", "/row/tire"),
        Column::text("film", "/row/film"),
        Column::text("position", "/row/position"),
        Column::text("direction", "/row/direction"),
        Column::text("over", "/row/over"),
        Column::float("load_n", "/row/load_n"),
        Column::float("pressure_mpa", "/row/pressure_mpa"),
        Column::float("contact_deg", "/row/contact_deg"),
        Column::float("depth_mm", "/row/depth_mm"),
        Column::float("strain", "/row/strain"),
        Column::float("tension_1_n_per_mm", "/row/tension_1_n_per_mm"),
        Column::float("charge_nc", "/row/charge_nc"),
        Column::float("open_circuit_v", "/row/open_circuit_v"),
        Column::float("output_v", "/row/output_v"),
        Column::float("output_std_v", "/row/output_std_v"),
        Column::text("state", "/row/state"),
        Column::float("strain_error", "/row/error/strain"),
        Column::float("charge_error_nc", "/row/error/charge_nc"),
        Column::float("open_circuit_error_v", "/row/error/open_circuit_v"),
        Column::float("output_error_v", "/row/error/output_v"),
        Column::text("reason", "/row/reason"),
    ];
    Table {
        name: "signals",
        parts: &[("row", "SignalRow")],
        columns,
    }
}
