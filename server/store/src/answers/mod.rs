//! Results, also as texts in pieces, and measured trades of accuracy for time.

mod content_hash;
mod extracts;
pub mod result_rows;
pub mod result_text;
pub mod trades;
