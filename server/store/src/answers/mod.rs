//! Results, also as texts in pieces, with their ranked rows, and measured trades of accuracy for time.

pub mod ranked_rows;
pub mod result_rows;
pub mod result_text;
pub mod trades;
