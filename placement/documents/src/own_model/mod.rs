//! Inputs and outputs of models that others run: the documents of `strainsite gsa`.

pub mod csv_cell;
pub mod inputs_document;
pub mod value_table;
