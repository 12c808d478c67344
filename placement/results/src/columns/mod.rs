//! Columns of the tables that an answer is told in: one description a figure.
//!
//! Files, the terminal, the dashboard and Python's data frames take names, units, titles and decimals from here. A row is made of serialised parts of an
//! answer, [`table_rows`], in which a column's value stands at a JSON pointer; what a figure is, the doc comment of its field says.

mod answer_table;
mod comparison_columns;
mod figure_column;
mod force_columns;
mod layout_columns;
mod location_columns;
mod rung_columns;
mod signal_columns;
pub mod table_rows;
pub mod unit;

pub use answer_table::Table;
pub use figure_column::{Column, Kind, text};

/// Every table but that of solved points, whose columns are a study's own inputs and locations.
pub fn tables() -> [Table; 11] {
    [
        location_columns::indices(),
        location_columns::locations(),
        layout_columns::layouts(),
        layout_columns::candidates(),
        signal_columns::signals(),
        force_columns::forces(),
        force_columns::elsewhere(),
        force_columns::models(),
        comparison_columns::compared_locations(),
        comparison_columns::designs(),
        rung_columns::rungs(),
    ]
}

/// The table of this name.
///
/// # Panics
/// When there is none: names are constants of the program.
pub fn table(name: &str) -> Table {
    let named = tables().into_iter().find(|table| table.name == name);
    named.unwrap_or_else(|| panic!("there is no table {name}"))
}
