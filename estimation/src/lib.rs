//! Forces from recorded signals, with errors that hold on recordings that nobody learnt from.
//!
//! Films, strain gauges or whatever a rig has give signals; a force sensor beside them gives the truth for some runs. This crate learns forces from signals and says
//! how far off they will be on a run that it hasn't seen. Arrays and texts go in, numbers or a typed error come out: it knows no tire, file, clock or thread.
//!
//! Folders in reading order:
//!
//! - [`recipe`]: what is to be done, every field with a default
//! - [`recording`]: runs from CSV texts
//! - [`align`]: one clock; [`cycles`]: what is left out whole
//! - [`features`]: values, slopes and rolling statistics, from earlier rows alone
//! - [`rows`]: the rows of all runs, as models learn them
//! - [`split`]: which rows are learnt from, and which are tested
//! - [`model`]: mean, ridge, Gaussian process, neural networks
//! - [`error_metrics`]: how far estimates are off, how wide intervals must be, what another run may be off by
//! - [`validation`]: every model and feature set on every split
//! - [`estimator`]: what was chosen, learnt from all rows, as data; [`live`]: its estimates, row by row
//! - `relations`: what signals say of each other, so that faulty ones are told
//! - [`fit_report`]: what the validation found, for people and programs

pub mod align;
pub mod cycles;
pub mod error_metrics;
pub mod estimator;
pub mod features;
pub mod fit_report;
pub mod live;
pub mod model;
pub mod recipe;
pub mod recording;
mod relations;
pub mod rows;
pub mod split;
pub mod validation;
