//! Results with their ranked rows, and measured trades of accuracy for time.

pub mod ranked_rows;
pub mod result_rows;
pub mod trades;
