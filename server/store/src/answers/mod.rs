//! Results, also as texts in pieces, and measured trades of accuracy for time.

mod extracts;
pub mod result_rows;
pub mod result_text;
pub mod trades;
