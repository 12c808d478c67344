//! Inputs and outputs of models that others run: the documents of `strainsite gsa`.

pub mod csv_cell;
pub mod fingerprint;
pub mod inputs_document;
mod planned_cells;
mod printed_number;
mod value_row;
pub mod value_table;
