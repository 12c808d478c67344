//! Inputs and outputs of models that others run: the documents of `strainsite gsa` and of `/v1/analyses`.

pub mod analysis_document;
pub mod csv_cell;
pub mod fingerprint;
pub mod inputs_document;
mod listed_values;
pub mod own_analysis;
mod planned_cells;
mod printed_number;
mod value_row;
pub mod value_table;
