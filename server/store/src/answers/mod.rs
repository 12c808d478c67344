//! Results, also as texts in pieces, with their ranked rows and signals, and measured trades of accuracy for time.

pub mod ranked_rows;
pub mod result_rows;
pub mod result_text;
pub mod stored_signals;
pub mod trades;
