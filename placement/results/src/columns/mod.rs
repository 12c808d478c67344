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
pub use comparison_columns::{compared_locations, designs};
pub use figure_column::{Column, Kind, text};
pub use force_columns::{drifts, elsewhere, forces, models};
pub use layout_columns::{candidates, films, layouts, trade};
pub use location_columns::{indices, locations};
pub use rung_columns::rungs;
pub use signal_columns::signals;

/// Every table but that of solved points, whose columns are a study's own inputs and locations.
pub fn tables() -> [Table; 14] {
    [
        indices(),
        locations(),
        layouts(),
        trade(),
        films(),
        candidates(),
        signals(),
        forces(),
        elsewhere(),
        drifts(),
        models(),
        compared_locations(),
        designs(),
        rungs(),
    ]
}
