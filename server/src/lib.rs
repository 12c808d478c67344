//! The strainsite program: command line, HTTP service, queue and database. The only async code of the project.
//!
//! The modules, in reading order:
//!
//! - [`config`]: settings from flags and environment
//! - [`telemetry`]: the log
//! - [`traced`]: solves whose lines in the log say for which study
//! - [`watched`]: solves that come to an end in time
//! - [`token`]: the secret that lets a client in
//! - [`solver`]: which solver answers
//! - [`shutdown`]: the wish to stop
//! - [`store`]: the database, all SQL
//! - [`study_document`]: study documents from files and from the database
//! - [`points`]: the points of a study as a reader sees them
//! - [`comparison`]: studies side by side
//! - [`export`]: answers as tables for other programs
//! - [`metrics`]: what is counted and measured
//! - [`archive`]: the database as the place where solved points are kept
//! - [`forecast`]: what a study would cost
//! - [`answered`]: the same study again
//! - [`engine`]: runs one study from its document to its end
//! - [`queue`]: the queue of studies
//! - [`sweeps`]: many designs of a study as one
//! - [`http`]: routes and dashboard
//! - [`service`]: database, queue and HTTP together
//! - [`cli`]: the command line

pub mod answered;
pub mod archive;
pub mod cli;
pub mod comparison;
pub mod config;
pub mod engine;
pub mod export;
pub mod forecast;
pub mod http;
pub mod metrics;
pub mod points;
pub mod queue;
pub mod service;
pub mod shutdown;
pub mod solver;
pub mod store;
pub mod study_document;
pub mod sweeps;
pub mod telemetry;
pub mod token;
pub mod traced;
pub mod watched;
