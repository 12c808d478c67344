//! Figures of a recording's columns, before anything is learnt from it.
//!
//! - [`taken_columns`]: what each column is taken for
//! - [`column_figures`]: range, noise, level without a force and its drift
//! - [`lone_samples`]: samples that stand alone
//! - [`suspect_samples`]: these and far ones, of all columns
//! - [`time_figures`]: length, rate and gaps
//! - [`value_bins`]: a column as a band over time
//! - [`unread_columns`]: numbers of columns that nothing is read from; lines of rows

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

pub mod column_figures;
pub mod lone_samples;
pub mod suspect_samples;
pub mod taken_columns;
pub mod time_figures;
pub mod unread_columns;
pub mod value_bins;
